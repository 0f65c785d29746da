"""Python holds a drag from the grab to the end: python3 tests/python/test_drag.py (after scripts/build)."""
import sys
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings/python"))
import dragmesh  # noqa: E402
from dragmesh import native as structs  # noqa: E402

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
                  [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]], np.uint32)
HANDLE, EYE = np.array([0.9, 0.5, 1.05]), np.array([1.5, 2.0, 4.0])


class Door(unittest.TestCase):
    """A slab before a box, hinged along y through (0, 0, 1), opening towards +z."""

    def setUp(self):
        self.context = dragmesh.Context()
        self.addCleanup(self.context.close)
        self.object = self.prepare(None)
        self.object.set_joint(1, dragmesh.Joint(type=dragmesh.JointType.REVOLUTE, axis=structs.Vec3(0, -1, 0),
                                                origin=structs.Vec3(0, 0, 1), upper=1.5))

    def prepare(self, choose):
        slab = CUBE * [1, 1, 0.05] + [0, 0, 1]
        return self.context.prepare(np.concatenate([CUBE, slab]), np.concatenate([FACES, FACES + 8]),
                                    np.repeat([0, 1], 8), choose=choose)

    def pull(self, drag, value):
        arm, cosine, sine = HANDLE - [0, 0, 1], np.cos(value), np.sin(value)
        point = np.array([cosine * arm[0] - sine * arm[2], arm[1], sine * arm[0] + cosine * arm[2] + 1])
        return drag.update(EYE, point - EYE, 1 / 60)

    def dragged(self, **feel):
        drag = self.object.drag(1, HANDLE, **feel)
        for frame in range(61):  # the first ray is the one that grabs
            state = self.pull(drag, 0.8 * frame / 60)
        return drag, state

    def test_follows_and_tells_its_joint(self):
        drag, state = self.dragged(smoothing_time=-1)
        self.assertAlmostEqual(state.value, 0.8, places=3)
        joint = drag.part_state().joint
        self.assertEqual((joint.type, joint.upper), (dragmesh.JointType.REVOLUTE, 1.5))
        self.assertAlmostEqual(drag.end().value, 0.8, places=3)

    def test_ends_with_a_state_that_the_next_drag_goes_on_from(self):
        drag, last = self.dragged()
        state = drag.end()
        state.joint.evidence = (1, 2, 2**32 - 1, 4)
        again = self.object.drag(1, last.grab_point, state=state)
        self.assertEqual(bytes(again.part_state().pose), bytes(last.pose))
        self.assertEqual(list(again.end().joint.evidence), [1, 2, 2**32 - 1, 4])
        value, angle, distance = dragmesh.joint_value(state.joint, state.pose)
        self.assertAlmostEqual(value, state.value, places=5)
        self.assertLess(max(angle, distance), 1e-5)
        frame = dragmesh.joint_frame(state.joint)
        self.assertEqual((frame.limits, frame.upper, frame.x.y), (3, 1.5, -1))

    def test_tells_events_and_keeps_bounds(self):
        drag = self.object.drag(1, HANDLE, rules={"snaps": [0.4], "open_share": 0.2})
        events, detents = dragmesh.Event(0), 0
        for frame in range(91):
            arm, angle = HANDLE - [0, 0, 1], 0.8 * min(frame, 60) / 60
            point = np.array([np.cos(angle) * arm[0] - np.sin(angle) * arm[2], arm[1],
                              np.sin(angle) * arm[0] + np.cos(angle) * arm[2] + 1])
            state = drag.step(1 / 60, ray=(EYE, point - EYE), bounds=(-1, 0.6))
            events, detents = events | dragmesh.Event(state.events), detents + state.detents
        self.assertAlmostEqual(state.value, 0.6, places=3)
        self.assertEqual(events, dragmesh.Event.LEFT_REST | dragmesh.Event.OPENED | dragmesh.Event.DETENT |
                         dragmesh.Event.BLOCKED)
        self.assertEqual(detents, 1)
        with self.assertRaises(TypeError):
            self.object.drag(1, HANDLE, rules={"sanps": []})

    def test_is_moved_without_a_pointer(self):
        drag = self.object.drag(1, rules={"flags": 2, "latch_turn": 0.5})
        state = drag.step(1, value=0.9)
        self.assertLess(state.value, 0.02)
        for _ in range(60):
            state = drag.step(1 / 60, value=0.9, handles=(0.6, 0))
        self.assertAlmostEqual(state.value, 0.9, places=2)
        drag.step(1 / 60, rate=-1, flags=2)
        self.assertEqual(drag.take(0.25).value, 0.25)
        self.assertEqual(drag.release(dragmesh.Intent.TOGGLE).end_value, 1.5)
        point = self.object.drag(1, HANDLE)
        point.step(0, point=HANDLE)
        self.assertEqual(point.step(0.1, point=HANDLE).value, 0)
        self.assertAlmostEqual(dragmesh.joint_value_at(drag.part_state().joint, 0.1), 0.15, places=6)

    def test_links_of_one_part_are_refused(self):
        self.object.set_links([])
        with self.assertRaises(dragmesh.Error):
            self.object.set_links([{"driver": 1, "driven": 1}])
        self.assertEqual(self.object.follow_links(1, [0.5]), ([0.5], [False]))

    def test_is_put_back_into_a_saved_state(self):
        drag, before = self.dragged()
        saved = drag.save()
        first = bytes(self.pull(drag, 1.1))
        drag.restore(saved)
        self.assertEqual(bytes(self.pull(drag, 1.1)), first)
        with self.assertRaises(dragmesh.Error):
            drag.restore(saved[:-1])

    def test_released_it_does_as_planned(self):
        drag, _ = self.dragged()
        plan = drag.release(dragmesh.Intent.OPEN, duration=0.5)
        self.assertEqual((plan.intent, plan.end_value, plan.duration), (dragmesh.Intent.OPEN, 1.5, 0.5))
        for _ in range(31):
            state = drag.advance(1 / 60)
        self.assertEqual((state.value, state.phase), (1.5, 2))
        self.assertEqual(drag.release(dragmesh.Intent.CLOSE).end_value, 0)

    def test_errors_have_a_text(self):
        drag = self.object.drag(1, HANDLE)
        with self.assertRaisesRegex(dragmesh.Error, "never released"):
            drag.release(dragmesh.Intent.REPLAY)
        drag.end()
        with self.assertRaises(dragmesh.Error):
            drag.part_state()
        with self.assertRaises(TypeError):
            self.object.drag(1, HANDLE, softness=1)

    def test_the_host_chooses_among_hypotheses(self):
        shown = []

        def choose(part, hypotheses):
            self.assertEqual(part.id, 1)
            shown.extend((h.joint.contents.type, h.ends[1].value, h.joint.contents.upper) for h in hypotheses)
            return 1

        joint = self.prepare(choose).joint(1)
        self.assertEqual((joint.source, joint.joint_confidence, joint.type), (3, 1, shown[1][0]))
        self.assertEqual(self.prepare(lambda part, hypotheses: None).joint(1).type, shown[0][0])
        with self.assertRaisesRegex(dragmesh.Error, "desc.choose answered 9 for part 1"):
            self.prepare(lambda part, hypotheses: 9)
        with self.assertRaises(ZeroDivisionError):
            self.prepare(lambda part, hypotheses: 1 // 0)


if __name__ == "__main__":
    unittest.main()
