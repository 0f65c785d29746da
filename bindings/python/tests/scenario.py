"""The common scenario: prints what bindings/scenario/scenario.c prints. scenario.py [WEIGHTS_FOLDER]"""
import sys

import numpy as np

import dragmesh
from dragmesh import Go, InputFlag, Joint, LinkKind, Rule

FRAMES, SHOWN_EVERY, SAVED_AT, RELEASED_FRAMES, HANDLE_TURNS_AT = 60, 10, 30, 120, 25
FRAME_TIME = 1 / 60
HANDLE_TURN, WIDEST = 1, float(np.float32(0.45))  # rad
DOOR, DRAWER = 1, 2

# From x, y, z to x, y, z, and the part: samples/common/cabinet.h.
BOXES = np.array([
    [0.00, 0.00, 0.000, 0.60, 0.02, 0.40, 0], [0.00, 0.98, 0.000, 0.60, 1.00, 0.42, 0],
    [0.00, 0.02, 0.000, 0.02, 0.98, 0.40, 0], [0.58, 0.02, 0.000, 0.60, 0.98, 0.40, 0],
    [0.02, 0.02, 0.000, 0.58, 0.98, 0.02, 0], [0.00, 0.00, 0.402, 0.60, 0.79, 0.42, DOOR],
    [0.54, 0.35, 0.420, 0.56, 0.55, 0.45, DOOR], [0.00, 0.80, 0.402, 0.60, 0.97, 0.42, DRAWER],
    [0.25, 0.87, 0.420, 0.35, 0.89, 0.45, DRAWER], [0.04, 0.82, 0.030, 0.56, 0.83, 0.402, DRAWER],
    [0.04, 0.83, 0.030, 0.05, 0.95, 0.402, DRAWER], [0.55, 0.83, 0.030, 0.56, 0.95, 0.402, DRAWER],
    [0.05, 0.83, 0.030, 0.55, 0.95, 0.040, DRAWER]], np.float32)
CORNERS = np.array([0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                    2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6])
POSITIONS = np.array([[box[k + 3 * (v >> k & 1)] for k in range(3)] for box in BOXES for v in range(8)])
INDICES = (8 * np.arange(len(BOXES))[:, None] + CORNERS).reshape(-1)  # int64, as numpy makes them
PARTS = np.repeat(BOXES[:, 6].astype(np.int64), 8)


def ray_at(frame):
    """The pointer's ray in a frame, in single precision."""
    direction = np.array([-0.35, -0.45, -1.55], np.float32)
    direction[0] -= np.float32(0.01) * np.float32(frame)
    direction[2] += np.float32(0.005) * np.float32(frame)
    return np.array([0.9, 0.9, 2.0], np.float32), direction


def show(name, *values):
    print(name, *(f"{bits:08x}" for bits in np.array(values, np.float32).view(np.uint32)))


def show_joint(joint: Joint):
    print(f"joint {joint.type} source {joint.source}")
    show(" ", *joint.axis, *joint.origin, joint.lower, joint.upper, joint.type_confidence, joint.joint_confidence)


def show_pose(pose):
    show(" ", *pose.real)
    show(" ", *pose.dual)


def show_state(name, state, events=None):
    print(f"{name} phase {state.phase} events {state.events if events is None else events} changes {state.changes}"
          f" basis {state.joint_basis}")
    show(" ", state.value, state.joint_confidence)
    show_pose(state.pose)


def show_hypotheses(thing, part):
    joints = thing.hypotheses(part)
    print(f"part {part} hypotheses {len(joints)}")
    show_joint(thing.joint(part))
    for joint in joints:
        show_joint(joint)


def pick(context, thing):
    with context.scene() as scene:
        scene.add(thing)
        scene.commit()
        hit = scene.pick(*ray_at(0))
    print(f"picked part {hit.part_id} triangle {hit.triangle}")
    show(" ", *hit.object_point)
    return hit


def drag_and_release(thing, hit):
    drag, events, saved = thing.drag(hit.part_id, hit.object_point, rules={}), 0, b""
    for frame in range(FRAMES):
        state = drag.update(*ray_at(frame), FRAME_TIME)
        events |= state.events
        if frame % SHOWN_EVERY == 0:
            show_state("frame", state)
        if frame == SAVED_AT:
            saved = drag.save()
    drag.restore(saved)
    show_state("restored", drag.update(*ray_at(FRAMES), FRAME_TIME))
    show("plan", drag.release(Go.OPEN, by_rule=True).end_value)
    for _ in range(RELEASED_FRAMES):
        state = drag.advance(FRAME_TIME)
        events |= state.events
    show_state("released", state, events)
    again = thing.drag(hit.part_id, state.grab_point, state=drag.end(), rules={}).end()
    show("again", again.value)
    show_pose(again.pose)
    print("evidence", *again.joint.evidence)


def drag_behind_latch(thing, hit):
    drag = thing.drag(hit.part_id, hit.object_point, rules={"flags": Rule.LATCH, "snaps": [0.2, 0.4]})
    events = detents = 0
    for frame in range(FRAMES):
        turned = 0 if frame < HANDLE_TURNS_AT else HANDLE_TURN
        state = drag.update_input(FRAME_TIME, ray=ray_at(frame), handles=(turned, 0), flags=InputFlag.ASK)
        if state.value > WIDEST:
            state = drag.override(WIDEST)
        events, detents = events | state.events, detents + state.detents
        if frame % SHOWN_EVERY == 0:
            show_state("latch", state)
    show_state("latched", state, events)
    print("detents", detents)
    drag.close()


def follow_links(thing):
    thing.set_links([{"driver": DOOR, "driven": DRAWER, "ratio": 0.25, "from_": 0.1},
                     {"driver": DRAWER, "driven": DOOR, "kind": LinkKind.HOLDS, "from_": 0.05}])
    values = [-0.9, 0.0]
    for _ in range(2):
        values, held = thing.follow_links(DOOR, values)
        show("linked", *values)
        print("held", *map(int, held))
        values[0] = 0.9


def save_and_load(context, thing):
    data, digest = thing.save(), 2166136261  # FNV-1a
    for byte in data:
        digest = (digest ^ byte) * 16777619 & 0xFFFFFFFF
    print(f"saved {len(data)} bytes {digest:08x}")
    show_joint(context.load_object(data).joint(DOOR))


def main():
    with dragmesh.Context() as context:
        names = ("kpp_net", "dq_vae", "ranker")
        model = context.load_model(*(f"{sys.argv[1]}/{name}.safetensors" for name in names)) if sys.argv[1:] \
            else context.load_shipped_model()
        parts = [{"id": DOOR, "label": "kitchen/cabinet/door"}, {"id": DRAWER, "label": "kitchen/cabinet/drawer"}]
        thing = context.prepare(POSITIONS, INDICES, PARTS, parts, model, picking=True)
        show_hypotheses(thing, DOOR)
        show_hypotheses(thing, DRAWER)
        hit = pick(context, thing)
        drag_and_release(thing, hit)
        drag_behind_latch(thing, hit)
        follow_links(thing)
        save_and_load(context, thing)
        try:
            context.prepare(POSITIONS, INDICES[:36], PARTS)  # one box, without any part
        except dragmesh.Error as error:
            print("error", error.name)


main()
