"""What a host may do wrong with the layer of Python: an exception each time, and the context goes on. python3
tests/python/test_misuse.py (after scripts/build)."""
import copy
import ctypes
import gc
import math
import pickle
import subprocess
import sys
import threading
import unittest

import numpy as np

from test_binding import CORNERS, DMO, DRAWER, IDS, POINTS, ROOT, dragmesh, native

UP = ((0.5, 1.06, 0.5), (0, 1, 0))  # a pull at the lid
SEEN_FROM, TOWARDS = (0, 0, 5), (0, 0, -1)


class Misuse(unittest.TestCase):
    """A context that every test leaves in working order."""

    def setUp(self):
        self.hook = None  # what the progress of the context calls
        self.context = dragmesh.Context(progress=lambda done: self.hook() if self.hook else None)

    def tearDown(self):
        self.hook = None
        thing = self.context.prepare(POINTS, CORNERS, IDS)
        self.assertEqual(thing.drag(1, rules={}).step(0.01, value=0.1).phase, dragmesh.Phase.HELD)
        self.context.close()

    def chest(self, **how):
        return self.context.prepare(POINTS, CORNERS, IDS, **how)


class Ends(Misuse):
    """Calls after, during and instead of ends."""

    def test_what_is_closed_is_refused(self):
        thing = self.context.load_object(DMO)
        part = thing.parts()[0]
        drag = thing.drag(part.id, part.centre)
        thing.close()
        thing.close()
        for call in (thing.info, thing.save, lambda: drag.update(SEEN_FROM, TOWARDS, 0.01), drag.save, drag.end):
            with self.assertRaisesRegex(dragmesh.Error, "STALE_HANDLE"):
                call()
        drag.close()
        with self.assertRaisesRegex(dragmesh.Error, "STALE_HANDLE"):
            drag.part_state()

    def test_a_context_that_ends_first(self):
        context = dragmesh.Context()
        model = context.load_shipped_model()
        thing = context.prepare(POINTS, CORNERS, IDS, model=model, picking=True)
        made = [model, thing, thing.drag(1, rules={}), thing.motion(1, UP), context.scene()]
        made[-1].add(thing)
        context.close()
        context.close()
        for call in (thing.info, made[-1].commit, context.memory, context.scene, lambda: context.load_object(DMO)):
            with self.assertRaisesRegex(ValueError, "closed"):
                call()
        for one in made:
            one.close()
        del thing, one
        made.clear()
        gc.collect()

    def test_things_of_another_context(self):
        with dragmesh.Context() as other, self.context.scene() as scene:
            for call in (lambda: scene.add(other.load_object(DMO)), lambda: self.chest(model=other.load_shipped_model())):
                with self.assertRaisesRegex(dragmesh.Error, "STALE_HANDLE"):
                    call()

    def test_owners_are_not_copied(self):
        with dragmesh.Gltf(DRAWER) as gltf:
            for owner in (self.context, self.chest(), gltf):
                for copied in (copy.copy, copy.deepcopy, pickle.dumps):
                    with self.assertRaisesRegex(TypeError, "copied"):
                        copied(owner)

    def test_a_closed_file(self):
        gltf = dragmesh.Gltf(DRAWER)
        gltf.close()
        gltf.close()
        for call in (gltf.nodes, gltf.mesh, gltf.face_count, gltf.origin, gltf.surfaces, lambda: gltf.pivots_are_lost,
                     lambda: gltf.read_mask(b"[]"), lambda: gltf.hints("drawer"), lambda: gltf.export([])):
            with self.assertRaisesRegex(ValueError, "closed"):
                call()

    def test_the_interpreter_ends_first(self):
        start = "import sys; sys.path.insert(0, sys.argv[1]); from test_binding import *; context = dragmesh.Context()\n"
        for end in ("drag = context.load_object(DMO).drag(1, rules={}); circle = [drag]; circle.append(circle)",
                    "gltf = dragmesh.Gltf(DRAWER); scene = context.scene(); sys.exit()",
                    "begun = threading.Event()\n"
                    "def slow(done): begun.set(); threading.Event().wait(0.05)\n"
                    "call = lambda: context.prepare(POINTS, CORNERS, IDS, progress=slow)\n"
                    "threading.Thread(target=call, daemon=True).start(); begun.wait()"):
            done = subprocess.run([sys.executable, "-c", start + end, str(ROOT / "tests/python")], capture_output=True,
                                  text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))


class Callbacks(Misuse):
    """Callbacks that call, end, keep and raise what they should not."""

    def test_calls_of_the_context_that_calls(self):
        model = self.context.load_shipped_model()
        thing = self.chest(model=model, picking=True)
        for call in (self.context.close, self.chest, thing.close, thing.info, model.close, self.context.scene):
            with self.assertRaisesRegex(RuntimeError, "in use|must not call"):
                self.chest(model=model, progress=lambda done, call=call: call())
            with self.assertRaisesRegex(RuntimeError, "in use|must not call"):
                self.chest(intent=lambda part, low, high, call=call: call())
            with self.assertRaisesRegex(RuntimeError, "in use|must not call"):
                self.chest(choose=lambda part, hypotheses, call=call: call())
            self.hook = call
            with self.assertRaisesRegex(RuntimeError, "in use|must not call"):
                thing.refine(1, UP)
            self.hook = None
        self.assertEqual(thing.parts()[0].id, 1)

    def test_other_contexts_may_be_called(self):
        with dragmesh.Context() as other:
            self.chest(progress=lambda done: other.load_object(DMO) and None)

    def test_exceptions_leave_nothing_behind(self):
        def fail(*_):
            raise KeyboardInterrupt

        self.chest()
        before = self.context.memory().bytes
        for how in ({"progress": fail}, {"intent": fail}, {"choose": fail}):
            with self.assertRaises(KeyboardInterrupt):
                self.chest(**how)
        for wrong in (2**40, -2**40, "first", 1.5, math.nan, [0]):
            with self.assertRaises((TypeError, ValueError, dragmesh.Error)):
                self.chest(choose=lambda part, hypotheses, wrong=wrong: wrong)
            with self.assertRaises((TypeError, ValueError, dragmesh.Error)):
                self.chest(intent=lambda part, low, high, wrong=wrong: wrong)
        self.assertLessEqual(self.context.memory().bytes, before)

    def test_a_log_that_raises(self):
        seen, hook = [], sys.unraisablehook
        sys.unraisablehook = lambda what: seen.append(what.exc_type)
        try:
            with dragmesh.Context(log=lambda level, text: 1 // 0) as context:
                with self.assertRaisesRegex(dragmesh.Error, "BAD_DATA: .+"):
                    context.load_object(b"none")
                context.load_object(DMO)
        finally:
            sys.unraisablehook = hook
        self.assertEqual(seen, [ZeroDivisionError])

    def test_what_a_callback_was_shown_may_be_kept(self):
        kept = []
        self.chest(choose=lambda part, hypotheses: kept.append((part, hypotheses)))
        with dragmesh.Context() as other:
            other.load_object(DMO)
        part, hypotheses = kept[0]
        self.assertEqual((part.id, part.triangle_count), (1, 12))
        for one in hypotheses:
            joint = one.joint.contents
            self.assertAlmostEqual(float(np.linalg.norm(list(joint.axis))), 1, 5)

    def test_the_collector_comes_in_a_callback(self):
        before = self.context.memory().bytes

        def collect(_):
            circle = [self.lost.pop()] if self.lost else []
            circle.append(circle)
            del circle
            gc.collect()

        self.lost = [self.context.load_object(DMO) for _ in range(3)]
        self.chest(progress=collect).close()
        self.assertEqual(self.lost, [])
        held = self.context.memory()
        self.assertLess(held.bytes - held.kept_bytes, before + (1 << 20))

    def test_arrays_that_change_meanwhile(self):
        points, corners = POINTS.copy(), CORNERS.astype(np.uint32)

        def change(_):
            corners[:] = 2**31
            points[:] = np.nan

        try:
            self.context.prepare(points, corners, IDS, progress=change)
        except dragmesh.Error as error:
            self.assertIn(error.name, ("DM_ERROR_NOT_FINITE", "DM_ERROR_INDEX_OUT_OF_RANGE"))


class Values(Misuse):
    """Arrays, texts, numbers and structs of the wrong kind."""

    def test_arrays(self):
        thing, locked = self.chest(), np.frombuffer(bytes(84), np.uint8)
        for call in (lambda: thing.follow_links(1, []), lambda: thing.follow_links(1, [0] * 1000),
                     lambda: thing.follow_links(1, "a"), lambda: thing.set_links([{"driver": 1}] * 300),
                     lambda: thing.drag(1, rules={"snaps": [0.1] * 1000}), lambda: thing.drag(1, (0, 0)),
                     lambda: thing.drag(1, rules={"snap_count": 9}), lambda: thing.drag(1, rules={"struct_size": 4096}),
                     lambda: self.context.prepare([], [], []), lambda: self.context.prepare(POINTS, [[0, 1]], IDS),
                     lambda: self.context.prepare(POINTS, CORNERS, IDS.astype(np.float64)),
                     lambda: self.context.prepare(b"abc", CORNERS, IDS), lambda: self.context.prepare(None, None, None),
                     lambda: dragmesh.Context(axes=dragmesh.Axes.CUSTOM, custom_axes=[1, 2, 3]),
                     lambda: dragmesh.pose_apply(dragmesh.Pose(), [1, 2]), lambda: dragmesh.pose_apply(None, [1, 2, 3])):
            with self.assertRaises((TypeError, ValueError, IndexError, ctypes.ArgumentError, dragmesh.Error)):
                call()
        with dragmesh.Gltf(DRAWER) as gltf:
            faces = gltf.face_count()
            for ids in (locked[:faces], np.zeros(2 * faces, np.uint8)[::2], np.zeros(faces), [0] * faces,
                        np.zeros(faces - 1, np.uint8)):
                with self.assertRaises((TypeError, ValueError, dragmesh.Error)):
                    gltf.mark_faces(["drawer"], 1, ids)
        self.assertFalse(locked.any())

    def test_bytes(self):
        expected = self.context.load_object(DMO).save()
        for data in (bytearray(DMO), memoryview(DMO), np.frombuffer(DMO, np.uint8)):
            self.assertEqual(self.context.load_object(data).save(), expected)
        drag = self.chest().drag(1, rules={})
        for wrong in ("text", 5, None, [1, 2], object()):
            for call in (self.context.load_object, drag.restore, lambda data: self.context.load_model(ranker=[data]),
                         lambda data: dragmesh.Gltf([data])):
                with self.assertRaises(TypeError):
                    call(wrong)
        for wrong in (b"", b"x", bytes(70000), drag.save()[:-1]):
            with self.assertRaises(dragmesh.Error):
                drag.restore(wrong)

    def test_texts(self):
        for text in ("a\0b", "\ud800", 5, b"bytes"):
            for call in (lambda label: self.chest(label=label), lambda label: self.chest(parts=[{"id": 1, "label": label}]),
                         lambda name: dragmesh.write_glb([{"positions": POINTS, "indices": CORNERS, "name": name}])):
                with self.assertRaises((TypeError, ValueError)):
                    call(text)
        with self.assertRaises(ValueError):
            dragmesh.Gltf(DRAWER + "\0.txt")
        with self.assertRaisesRegex(dragmesh.Error, "TOO_LARGE"):
            self.chest(label="x" * 10**7)
        name = "Tür \U0001f6aa" * 1000
        with dragmesh.Gltf(dragmesh.write_glb([{"positions": POINTS, "indices": CORNERS, "name": name}])) as gltf:
            self.assertEqual(gltf.nodes()[0].name, name)

    def test_numbers(self):
        thing = self.chest()
        drag, joint = thing.drag(1, rules={}), thing.joint(1)
        for wrong in (math.nan, math.inf, -math.inf, 1e300):
            joint.axis = dragmesh.Vec3(wrong, 0, 0)
            for call in (lambda: drag.update((wrong, 0, 0), TOWARDS, 0.01), lambda: drag.update(SEEN_FROM, TOWARDS, wrong),
                         lambda: drag.step(0.01, value=wrong), lambda: thing.set_joint(1, joint),
                         lambda: thing.drag(1, (wrong, 0, 0)), lambda: thing.refine(1, ((wrong, 0, 0), (0, 1, 0))),
                         lambda: self.chest(up=(wrong, 0, 0)), lambda: dragmesh.joint_pose(thing.joint(1), wrong),
                         lambda: dragmesh.Context(unit_in_metres=wrong)):
                with self.assertRaises((dragmesh.Error, OverflowError)):
                    call()
        for wrong in (-1, 2**32, 2**64, 1.0, "1", None, math.nan):
            for call in (thing.joint, thing.reset_joint, lambda part: thing.drag(part, rules={}),
                         lambda part: thing.follow_links(part, [0])):
                with self.assertRaises((TypeError, ValueError)):
                    call(wrong)
        for wrong in (-1, 2**64, 1.5, "1"):
            with self.assertRaises((TypeError, ValueError)):
                self.chest(seed=wrong)

    def test_structs(self):
        thing = self.chest()
        joint = thing.joint(1)
        for size in (0, 55, 4096, 2**32 - 1):
            with self.assertRaises(ValueError):
                joint.struct_size = size
            with self.assertRaises(ValueError):
                native.PartState(struct_size=size)
        for call in (lambda: thing.set_joint(1, dragmesh.Pose()), lambda: thing.set_joint(1, None),
                     lambda: thing.drag(1, state=joint), lambda: dragmesh.joint_pose(dragmesh.Pose(), 0),
                     lambda: self.context.camera_ray(joint, 0, 0)):
            with self.assertRaises((TypeError, ctypes.ArgumentError)):
                call()


class Threads(Misuse):
    """What a host does on several threads without a lock of its own."""

    def test_ends_while_another_thread_calls(self):
        begun, go = threading.Event(), threading.Event()
        model, failures = self.context.load_shipped_model(), []

        def slow(_):
            begun.set()
            go.wait(10)

        def call():
            try:
                self.chest(model=model, progress=slow)
            except BaseException as failure:  # pylint: disable=broad-except
                failures.append(failure)

        thread = threading.Thread(target=call)
        thread.start()
        begun.wait(10)
        for end in (self.context.close, model.close):
            with self.assertRaisesRegex(RuntimeError, "in use"):
                end()
        drag = self.context.load_object(DMO).drag(1, rules={})  # frames go on beside
        drag.step(0.01, value=0.1)
        go.set()
        thread.join()
        self.assertEqual(failures, [])
        model.close()

    def test_one_drag_and_one_object_by_many(self):
        model = self.context.load_shipped_model()
        thing = self.chest(model=model, picking=True)
        drag, wrong = thing.drag(1, rules={}), []
        calls = [lambda: drag.step(0.01, value=0.1), lambda: thing.refine(1, UP), lambda: thing.joint(1),
                 lambda: thing.motion(1, UP).close(), lambda: drag.release(dragmesh.Intent.OPEN), drag.save, thing.save]

        def work(number):
            try:
                for i in range(30):
                    calls[(number + i) % len(calls)]()
            except dragmesh.Error as error:
                wrong.append(error)

        threads = [threading.Thread(target=work, args=(number,)) for number in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
