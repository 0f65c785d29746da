"""What the layer of Python adds to the library: python3 tests/python/test_binding.py (after scripts/build)."""
import ctypes
import gc
import json
import os
import sys
import tempfile
import threading
import typing
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings/python"))
import dragmesh  # noqa: E402
from dragmesh import arrays, native  # noqa: E402

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
                  [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
POINTS = np.concatenate([CUBE, CUBE * [1, 0.05, 1] + [0, 1.01, 0]])  # a box and a lid that lies on it
CORNERS = np.concatenate([FACES, FACES + 8])
IDS = np.repeat([0, 1], 8)
DMO = (ROOT / "tests/replay/hands/object.dmo").read_bytes()
DRAWER = str(ROOT / "tests/replay/drawer/object.glb")


class Boundary(unittest.TestCase):
    """Structs, integers and arrays."""

    def test_layouts_are_those_of_c(self):
        for struct, layouts in native.LAYOUTS.items():
            size, offsets = layouts[ctypes.sizeof(ctypes.c_void_p)]
            self.assertEqual(ctypes.sizeof(struct), size, struct)
            self.assertEqual([getattr(struct, name).offset for name, _ in struct._fields_], offsets, struct)
        self.assertEqual(typing.get_type_hints(native.Joint)["axis"], native.Vec3)

    def test_integers_that_do_not_fit_are_errors(self):
        for wrong in (-1, 2**32):
            with self.assertRaisesRegex(ValueError, str(wrong)):
                native.PartDesc(id=wrong)
            with dragmesh.Context() as context, self.assertRaisesRegex(ValueError, str(wrong)):
                context.load_object(DMO).joint(wrong)
        with self.assertRaises(TypeError):
            native.PartDesc(id=1.5)
        with self.assertRaises(TypeError):
            native.PartDesc(ident=1)
        self.assertEqual(native.PartDesc(id=np.int64(7)).id, 7)

    def test_labels_keep_their_value_or_are_refused(self):
        wide = {np.dtype(np.uint32): native.DM_UINT32, np.dtype(np.int32): native.DM_INT32}
        for given, kind in (([0, 1, 2**32 - 1], np.uint32), ([-1, 0, 7], np.int32), ([], np.uint32)):
            out = arrays.integers_of(np.array(given, np.int64), "labels", wide)
            self.assertEqual((out.dtype, out.tolist()), (kind, given))
        for given in ([2**32], [-1, 2**31], [-2**31 - 1], [2**63 - 1]):
            with self.assertRaisesRegex(ValueError, "labels have the value"):
                arrays.integers_of(np.array(given, np.int64), "labels", wide)
        with self.assertRaisesRegex(ValueError, "18446744073709551615 at 1"):
            arrays.integers_of(np.array([0, 2**64 - 1], np.uint64), "labels", wide)
        for given in (np.array([0.0, 1.0]), np.array(["a"]), np.array([None])):
            with self.assertRaisesRegex(TypeError, "must be integers"):
                arrays.integers_of(given, "labels", wide)

    def test_labels_of_the_mesh(self):
        with dragmesh.Context() as context:
            ids = np.where(IDS == 1, 1, -1)  # int64; negative is the body
            for given in (IDS, ids, ids.astype(np.int16), IDS == 1, list(IDS), np.where(IDS == 1, 2**32 - 1, 0)):
                self.assertEqual(len(context.prepare(POINTS, CORNERS, given).parts()), 1)
            faces = context.prepare(POINTS, CORNERS, np.repeat([0, 5], 12))
            self.assertEqual(faces.parts()[0].id, 5)
            for given in (np.where(IDS == 1, 2**32, 0), IDS.astype(float), IDS[:-1]):
                with self.assertRaises((TypeError, ValueError)):
                    context.prepare(POINTS, CORNERS, given)

    def test_indices_and_positions(self):
        with dragmesh.Context() as context:
            for corners in (CORNERS - 1, np.where(CORNERS == 3, 2**32, CORNERS), CORNERS.astype(float), CORNERS > 3):
                with self.assertRaises((TypeError, ValueError, dragmesh.Error)):
                    context.prepare(POINTS, corners, IDS)
            with self.assertRaises(dragmesh.Error) as caught:
                context.prepare(POINTS, CORNERS + 8, IDS)
            self.assertEqual(caught.exception.name, "DM_ERROR_INDEX_OUT_OF_RANGE")
            for points in (POINTS[:, :2], POINTS.astype(complex), POINTS.astype(str), np.full((16, 3), 2**53 + 1)):
                with self.assertRaises((TypeError, ValueError)):
                    context.prepare(points, CORNERS, IDS)
            expected = context.prepare(POINTS.astype(np.float64), CORNERS, IDS).save()
            for points in (POINTS[::-1][::-1], np.asfortranarray(POINTS), POINTS.tolist()):
                self.assertEqual(context.prepare(points, CORNERS, IDS).save(), expected)


class Owners(unittest.TestCase):
    """Ends, callbacks, threads."""

    def test_everything_ends_with_its_last_reference(self):
        context = dragmesh.Context()
        kept = context.load_object(DMO)
        before = context.memory().bytes
        for _ in range(3):
            thing = context.load_object(DMO)
            part = thing.parts()[0]
            drag = thing.drag(part.id, part.centre)
            del thing  # the drag keeps it
            drag.update((0, 0, 5), (0, 0, -1), 0.01)
            del drag
        gc.collect()
        self.assertLess(context.memory().bytes, before + (64 << 10))
        context.close()
        kept.close()
        with self.assertRaises(ValueError):
            kept.info()
        context.close()

    def test_callbacks(self):
        shares, said = [], []
        with dragmesh.Context(log=lambda level, text: said.append((level, text))) as context:
            thing = context.prepare(POINTS, CORNERS, IDS, progress=shares.append,
                                    intent=lambda part, low, high: dragmesh.JointType.PRISMATIC)
            self.assertEqual(thing.joint(1).type, dragmesh.JointType.PRISMATIC)
            self.assertEqual(shares, sorted(shares))
            self.assertGreater(len(shares), 1)
            with self.assertRaises(dragmesh.Error) as caught:
                context.prepare(POINTS, CORNERS, IDS, progress=lambda done: False)
            self.assertEqual(caught.exception.name, "DM_ERROR_CANCELLED")
            with self.assertRaises(ZeroDivisionError):
                context.prepare(POINTS, CORNERS, IDS, progress=lambda done: 1 // 0)
            with self.assertRaises(TypeError):
                context.prepare(POINTS, CORNERS, IDS, choose=lambda part, hypotheses: "first")
            with self.assertRaises(dragmesh.Error) as caught:
                context.load_object(b"none")
            self.assertEqual((0, caught.exception.message), said[-1])

    def test_progress_of_a_context(self):
        shares = []
        with dragmesh.Context(progress=shares.append) as context:
            saved = context.prepare(POINTS, CORNERS, IDS).save()
            context.load_object(saved)
            self.assertGreater(shares.count(1.0), 1)
        with dragmesh.Context(progress=lambda done: False) as context:
            with self.assertRaises(dragmesh.Error) as caught:
                context.load_object(saved)
            self.assertEqual(caught.exception.name, "DM_ERROR_CANCELLED")
        with dragmesh.Context(progress=lambda done: 1 // 0) as context:
            with self.assertRaises(ZeroDivisionError):
                context.find_part(POINTS, CORNERS, ((0, 0, 0), (0, 0, 1)))

    def test_messages_belong_to_their_thread(self):
        context, wrong, heard = dragmesh.Context(), [], []
        thing = context.load_object(DMO)

        def ask(part):
            for _ in range(50):
                try:
                    thing.joint(part)
                except dragmesh.Error as error:
                    heard.append(part)
                    wrong.extend([] if str(part) in error.message else [error.message])

        threads = [threading.Thread(target=ask, args=(part,)) for part in (71, 92)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((wrong, len(heard)), ([], 100))
        context.close()


class Scenes(unittest.TestCase):
    """Picking and finding parts."""

    def test_picks_what_has_moved(self):
        with dragmesh.Context() as context, context.scene() as scene:
            instance = scene.add(context.prepare(POINTS, CORNERS, IDS, picking=True))
            scene.commit()
            self.assertEqual(scene.pick((0.5, 5, 0.5), (0, -1, 0)).part_id, 1)
            up = dragmesh.Pose((0, 0, 0, 1), (0, 1, 0, 0))  # by (0, 2, 0)
            self.assertEqual(dragmesh.pose_apply(up, (1, 1, 1)).tolist(), [1, 3, 1])
            self.assertEqual(dragmesh.pose_matrix(dragmesh.pose_multiply(up, up))[1, 3], 4)
            turned = dragmesh.pose_from_rotation((0, 2, 0, 2), (1, 2, 3))  # a quarter turn about y
            moved = dragmesh.pose_apply(turned, (1, 0, 0))
            np.testing.assert_allclose(moved, (1, 2, 2), atol=1e-6)
            np.testing.assert_allclose(dragmesh.pose_apply(dragmesh.pose_inverse(turned), moved), (1, 0, 0), atol=1e-6)
            scene.move(instance, 1, up)
            scene.commit()
            self.assertEqual(scene.pick((-5, 1.03, 0.5), (1, 0, 0)), None)
            camera = dragmesh.Camera(fov_y=1, viewport_width=100, viewport_height=100, eye=dragmesh.Vec3(0.5, 3.05, 5),
                                     forward=dragmesh.Vec3(0, 0, -1), up=dragmesh.Vec3(0, 1, 0))
            ray = context.camera_ray(camera, 50, 50)
            self.assertEqual(scene.pick(ray.origin, ray.direction).part_id, 1)
            scene.remove(instance)
            scene.commit()
            self.assertIsNone(scene.pick((0.5, 5, 0.5), (0, -1, 0)))

    def test_finds_the_part_of_a_point(self):
        with dragmesh.Context() as context:
            faces = context.find_part(POINTS, CORNERS, ((0.5, 1.06, 0.5), (0, 1, 0)), IDS)
            self.assertEqual(faces.tolist(), [0] * 12 + [1] * 12)


class Files(unittest.TestCase):
    """glTF."""

    def test_reads_prepares_and_exports(self):
        with dragmesh.Gltf(DRAWER) as gltf, dragmesh.Context() as context:
            nodes, (points, faces) = gltf.nodes(), gltf.mesh()
            self.assertEqual(nodes[0].name, "body")
            self.assertEqual(nodes[-1].faces.stop, len(faces))
            self.assertLess(int(faces.max()), len(points))
            ids = np.zeros(len(faces), np.uint8)
            gltf.mark_faces(["drawer"], 1, ids)
            self.assertTrue(ids[nodes[1].faces].all() and not ids[nodes[0].faces].any())
            label, (origin, axes) = gltf.hints("drawer")
            self.assertIsInstance(gltf.pivots_are_lost, bool)
            self.assertTrue(label.endswith("drawer") and axes.shape == (3, 3) and np.isfinite(origin).all())
            thing = dragmesh.prepare_gltf(context, gltf, context.load_shipped_model(), "kitchen")
            joint = thing.joint(1)
            self.assertEqual(joint.type, dragmesh.JointType.PRISMATIC)
            poses = [dragmesh.joint_pose(joint, joint.upper * t) for t in (0, 0.5, 1)]
            data = gltf.export([{"face_ids": ids, "value": 1, "poses": poses, "times": [0, 1, 2], "name": "drawer moves"}])
            document = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
            self.assertEqual(len(document["animations"]), 1)
            with dragmesh.Gltf(data) as again:
                self.assertEqual(again.face_count(), len(faces))
            mask = gltf.read_mask(json.dumps(ids.tolist()).encode())
            self.assertEqual(mask.tolist(), ids.tolist())
            self.assertGreater(len(gltf.surfaces()), 0)
            motion = thing.motion(1, (thing.parts()[0].centre, joint.axis))
            self.assertEqual(len(motion.frames()[0]), native.DM_MOTION_FRAMES)

    def test_writes_meshes(self):
        data = dragmesh.write_glb([{"positions": CUBE, "indices": FACES, "name": "body"},
                                   {"positions": CUBE + 2, "indices": FACES, "colour": (1, 0, 0, 1)}])
        with dragmesh.Gltf(data) as gltf:
            self.assertEqual([node.name for node in gltf.nodes()], ["body", "part"])
            self.assertEqual(gltf.nodes()[1].colour, (1, 0, 0, 1))

    def test_names_what_is_wrong(self):
        with self.assertRaisesRegex(dragmesh.Error, "NOT_FOUND"):
            dragmesh.Gltf("nothing.glb")
        with self.assertRaisesRegex(dragmesh.Error, "BAD_DATA: .+"):
            dragmesh.Gltf(b"no file")


class Rigs(unittest.TestCase):
    """Whole assets."""

    NODES = [{"name": "box", "positions": CUBE, "indices": FACES},
             {"name": "lid", "positions": CUBE * [1, 0.05, 1], "indices": FACES, "parent": 0,
              "transform": [[1, 0, 0, 0], [0, 1, 0, 1.01], [0, 0, 1, 0], [0, 0, 0, 1]]}]

    def test_nodes_become_parts_and_an_object(self):
        with dragmesh.Context() as context:
            hinge = native.Joint(type=dragmesh.JointType.REVOLUTE, axis=native.Vec3(0, 0, 1), upper=1.5)
            asset = dragmesh.rig(context, [self.NODES[0], {**self.NODES[1], "joint": hinge}], min_moves=0.01)
            self.assertEqual((asset.info().node_count, asset.info().part_count), (2, 1))
            self.assertEqual((asset.node_parts(), asset.part_nodes(0)), ([None, 0], [1]))
            self.assertAlmostEqual(asset.joint(0).upper, 1.5)
            self.assertAlmostEqual(asset.parts()[0].box_min.y, 1.01, 5)
            prepared = asset.make_object()
            asset.close()
            self.assertEqual([part.id for part in prepared.parts()], [1])

    def test_what_is_refused(self):
        with dragmesh.Context() as context:
            for wrong, error in (({"parent": 1}, dragmesh.Error), ({"colour": 1}, TypeError), ({"parent": -1}, ValueError),
                                 ({"clips": [{"times": [0], "poses": []}]}, ValueError)):
                with self.assertRaises(error):
                    dragmesh.rig(context, [self.NODES[0], {**self.NODES[1], **wrong}])

    def test_a_file(self):
        with dragmesh.Context() as context, dragmesh.Gltf(DRAWER) as gltf:
            asset = dragmesh.rig_gltf(context, gltf, min_moves=0.01)
            self.assertEqual(len(asset.node_parts()), len(gltf.asset_nodes()))
            self.assertGreater(asset.info().part_count, 0)
            self.assertEqual(dragmesh.part_names(asset, gltf)[0], "drawer")
            with dragmesh.Gltf(DRAWER) as again, dragmesh.prepare_gltf(context, again) as thing:
                moving = dragmesh.rig_gltf(context, gltf).info().moving_count
                self.assertEqual([part.id for part in thing.parts()], list(range(1, moving + 1)))

    def test_a_file_for_engines_and_simulators(self):
        with dragmesh.Context() as context, dragmesh.Gltf(DRAWER) as gltf, tempfile.TemporaryDirectory() as folder:
            asset = dragmesh.rig_gltf(context, gltf, min_moves=0.01)
            files = dragmesh.export_rig(asset, gltf, dragmesh.RIG_FORMATS, name="Drawer & co")
            self.assertLessEqual({"rigged.glb", "rigged.urdf", "rigged.xml", "rigged.sdf", "rigged.usda", "rigged.tscn"}, set(files))
            self.assertIn(b'<robot name="asset_Drawer_co">', files["rigged.urdf"])
            dragmesh.write_rig(folder, files)
            for path, data in files.items():
                with open(os.path.join(folder, path), "rb") as file:
                    self.assertEqual(file.read(), data)
            again = dragmesh.Gltf(files["rigged.glb"])
            nodes, count = again.asset()
            joints = [nodes[index].joint[0] for index in range(count) if nodes[index].joint]
            self.assertEqual(len(joints), asset.info().moving_count)
            for wrong in ("stl", ["urdf", "stl"], []):
                with self.assertRaises((ValueError, dragmesh.Error)):
                    dragmesh.export_rig(asset, gltf, wrong)


if __name__ == "__main__":
    unittest.main()
