"""URDF folders become object.glb + joints.json, and those become cases: python3 tests/loaders/test_loaders.py"""
import json
import struct
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "training"))
from dragmesh_training import config, data  # noqa: E402
from dragmesh_training.loaders import batches, glb, meshes, objects, urdf  # noqa: E402


class Drawer(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.out = Path(self.folder.name) / "drawer"
        self.count = urdf.convert(HERE / "drawer", self.out)
        self.meta = json.loads((self.out / "joints.json").read_text())
        self.parts = glb.read(self.out / "object.glb")

    def test_joints_without_anything_to_see_are_left_out(self):
        self.assertEqual(self.count, 2)
        self.assertEqual([j["name"] for j in self.meta["joints"]], ["slide", "turn"])
        self.assertEqual(sorted(self.parts), ["knob", "link_0", "link_1", "link_2"])

    def test_links_lie_where_the_joints_at_zero_put_them(self):
        body, front = self.parts["link_0"][0], self.parts["link_1"][0]
        # The root turns y to z and z to -y, and lifts by 3: a box of 1 x 2 x 1 about (0, 0, 0.5).
        np.testing.assert_allclose(body.min(0), [-0.5, -1, 2], atol=1e-6)
        np.testing.assert_allclose(body.max(0), [0.5, 0, 4], atol=1e-6)
        np.testing.assert_allclose(front.min(0), [0.4, -0.75, 2], atol=1e-6)
        np.testing.assert_allclose(front.max(0), [0.5, -0.25, 4], atol=1e-6)
        self.assertAlmostEqual(self.meta["largest_dimension"], 2.4, places=5)

    def test_axes_origins_and_limits(self):
        slide, turn = self.meta["joints"]
        np.testing.assert_allclose(slide["axis"], [1, 0, 0], atol=1e-9)
        self.assertEqual((slide["type"], slide["lower"], slide["upper"], slide["rest_at"]), ("prismatic", 0, 0.4, "lower"))
        self.assertEqual(slide["moving_nodes"], ["link_1", "knob"])
        self.assertEqual(slide["part"], "drawer")
        # x of the joint's frame is y of the link's (turned about z), which the root turns to z.
        np.testing.assert_allclose(turn["axis"], [0, 0, 1], atol=1e-9)
        np.testing.assert_allclose(turn["origin"], [0, -0.5, 4.1], atol=1e-9)
        self.assertEqual((turn["drag_sign"], turn["rest_at"]), (-1, "upper"))
        self.assertEqual(self.meta["category"], "StorageFurniture")

    def test_drags_start_to_move_as_the_joint_does(self):
        for joint in self.meta["joints"]:
            axis, origin = np.array(joint["axis"]), np.array(joint["origin"])
            self.assertEqual(len(joint["drags"]), 3)
            for drag in joint["drags"]:
                point, vector = np.array(drag["point"]), np.array(drag["vector"])
                way = axis if joint["type"] == "prismatic" else np.cross(axis, point - origin)
                cosine = joint["drag_sign"] * way @ vector / np.linalg.norm(way) / np.linalg.norm(vector)
                self.assertAlmostEqual(cosine, 1, places=6)
                self.assertAlmostEqual(np.linalg.norm(vector), 0.1 * self.meta["largest_dimension"], places=6)

    def test_cases_hold_what_was_converted(self):
        slide, turn = objects.all_cases(self.folder.name)
        self.assertEqual((slide.name, slide.type, turn.type), ("drawer/0", objects.PRISMATIC, objects.REVOLUTE))
        moving = slide.positions[slide.indices[slide.face_part == 1]].reshape(-1, 3)
        self.assertGreaterEqual(moving[:, 0].min(), 0.4 - 1e-6)
        self.assertEqual(slide.face_part.sum(), len(self.parts["link_1"][1]) + len(self.parts["knob"][1]))
        self.assertEqual(len(turn.drags), 3)


class Batches(unittest.TestCase):
    """What training/train --data gives the networks; through the lab of a build."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        urdf.convert(HERE / "drawer", Path(cls.folder.name) / "drawer")
        cls.lab = data.Lab()
        cls.loaded = batches.Loaded(cls.folder.name)

    def batch(self, network, seed=1, **mix):
        return self.loaded.batch(self.lab, network, seed, 24, {**config.MIX, **mix})

    def test_kpp_axes_follow_the_drags(self):
        arrays = self.batch("kpp", with_drag=1.0, drag_noise_degrees=0.0)
        self.assertEqual(set(arrays["type"]), {0, 1})
        vector = arrays["shape"][:, 42:45]  # of the drag, in the network's frame
        along = (arrays["axis"] * vector).sum(-1)
        np.testing.assert_allclose(along[arrays["type"] == 1], 1, atol=1e-3)
        np.testing.assert_allclose(along[arrays["type"] == 0], 0, atol=1e-3)
        self.assertTrue(np.isfinite(arrays["global_points"]).all())

    def test_noise_turns_the_drag_alone(self):
        arrays = self.batch("kpp", with_drag=1.0, drag_noise_degrees=30.0)
        along = (arrays["axis"] * arrays["shape"][:, 42:45]).sum(-1)[arrays["type"] == 1]
        self.assertLess(along.min(), 0.999)

    def test_strokes_stay_inside_the_limits(self):
        arrays = self.batch("vae", joint_noise=0.0)
        lower, upper = arrays["limits"].T
        self.assertTrue((arrays["values"] >= lower[:, None] - 1e-6).all() and (arrays["values"] <= upper[:, None] + 1e-6).all())
        self.assertGreater(np.abs(arrays["values"]).max(), 0.05)

    def test_a_seed_gives_the_same_batch(self):
        for network in ("kpp", "vae"):
            first, second, other = self.batch(network), self.batch(network), self.batch(network, seed=2)
            for name in first:
                np.testing.assert_array_equal(first[name], second[name])
            self.assertTrue(any((first[name] != other[name]).any() for name in first))

    def test_a_chunk_for_training_has_its_share(self):
        chunk = data.mixed_batch(self.lab, "vae", 1, ["door"], self.loaded, 0.25)
        self.assertEqual(len(chunk["type"]), data.CHUNK)
        theirs = self.loaded.batch(self.lab, "vae", 1, data.CHUNK // 4, config.MIX)
        np.testing.assert_array_equal(chunk["values"][:data.CHUNK // 4], theirs["values"])

    def test_a_folder_without_objects_is_named(self):
        with self.assertRaisesRegex(SystemExit, "no sub-folder"):
            batches.Loaded(HERE)


class Primitives(unittest.TestCase):
    def volume(self, shape):
        corners = shape[0][shape[1]]
        return np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6

    def test_primitives_are_closed_and_look_outwards(self):
        self.assertAlmostEqual(self.volume(meshes.box([1, 2, 3])), 6)
        self.assertAlmostEqual(self.volume(meshes.cylinder(1, 2, 400)), 2 * np.pi, places=2)
        self.assertAlmostEqual(self.volume(meshes.sphere(1, 100, 200)), 4 / 3 * np.pi, places=2)


class BadFiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name)

    def write(self, name, text):
        (self.path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        return self.path / name

    def test_broken_meshes_are_named(self):
        for name, text, reason in (("a.obj", "v 0 0 0\nf 1 2 3\n", "not there"), ("b.obj", "v 0 0\n", "line 1"), ("g.obj", "v 0 0 0\n", "no triangles"),
                                   ("c.obj", "v 0 0 nought\n", "line 1"), ("d.dae", "", "is not read"),
                                   ("e.stl", "solid\nvertex 0 0 0\n", "no triangles")):
            with self.assertRaisesRegex(meshes.MeshError, reason):
                meshes.read(self.write(name, text))
        with self.assertRaisesRegex(meshes.MeshError, "no such file"):
            meshes.read(self.path / "none.obj")

    def test_binary_and_text_stl_are_the_same(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
        text = "solid\n facet normal 0 0 1\n  outer loop\n" + "".join(f"   vertex {x} {y} {z}\n" for x, y, z in corners)
        binary = b"\0" * 80 + struct.pack("<I12fH", 1, 0, 0, 1, *[float(x) for c in corners for x in c], 0)
        first, second = meshes.read(self.write("t.stl", text)), meshes.read(self.write("b.stl", binary))
        np.testing.assert_array_equal(first[0][first[1]], second[0][second[1]])

    def test_broken_trees_are_named(self):
        joint = '<joint name="j" type="{}"><parent link="{}"/><child link="{}"/></joint>'
        for text, reason in (("<robot", "urdf"), ("<robot/>", "no parent"),
                             ('<robot><link name="a"/><link name="b"/></robot>', "2 links have no parent"),
                             ('<robot><link name="a"/><link name="b"/><link name="c"/>' + joint.format("fixed", "b", "c")
                              + joint.format("fixed", "c", "b") + "</robot>", "circle"),
                             ('<robot><link name="a"/></robot>', "anything to see")):
            with self.assertRaisesRegex(urdf.UrdfError, reason):
                urdf.convert(self.write("x.urdf", text), self.path / "out")
        with self.assertRaisesRegex(urdf.UrdfError, "no .urdf file"):
            urdf.convert(self.path / "nowhere", self.path / "out")


if __name__ == "__main__":
    unittest.main()
