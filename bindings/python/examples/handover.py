"""What a host does with a joint beside dragging: a constraint for physics, a saved game, a client. OBJECT.dmo"""
import json
import sys

import numpy as np

import dragmesh

FIELDS = ("type", "source", "type_confidence", "joint_confidence", "pitch", "lower", "upper")


def save(door):
    """Numbers, not the struct as it lies in memory: structs grow."""
    joint = {name: getattr(door.joint, name) for name in FIELDS}
    lists = {name: list(getattr(door.joint, name)) for name in ("axis", "origin", "evidence")}
    return json.dumps({"value": door.value, **lists, **joint})


def load(text):
    """Its pose is zeros: that of joint and value."""
    kept = json.loads(text)
    joint = dragmesh.Joint(axis=dragmesh.Vec3(*kept["axis"]), origin=dragmesh.Vec3(*kept["origin"]),
                           evidence=tuple(kept["evidence"]), **{name: kept[name] for name in FIELDS})
    return dragmesh.PartState(value=kept["value"], joint=joint)


with open(sys.argv[1], "rb") as file, dragmesh.Context() as context:
    thing = context.load_object(file.read())
    part = thing.parts()[0]
    door = dragmesh.PartState(joint=thing.joint(part.id))

    # Physics: origin, rotation (x is the axis) and limits are those of the engine's hinge or slider.
    frame = dragmesh.joint_frame(door.joint)
    print(f"a constraint that opens to {frame.upper:.2f}")

    # … and back: body is the transform that the engine has given the part, from rest.
    body = dragmesh.joint_pose(door.joint, 1.2)
    door.value, angle_off, distance_off = dragmesh.joint_value(door.joint, body)
    door.pose = body
    print(f"physics leaves it at {door.value:.2f}")

    loaded = load(save(door))
    print(f"saved and loaded at {loaded.value:.2f}")

    # A client has neither object nor context: the joint once, the value every frame.
    shown = dragmesh.joint_pose(loaded.joint, loaded.value)

    # The next grab begins where the part stands.
    point = dragmesh.pose_apply(shown, np.array([list(part.centre)]))[0]
    again = thing.drag(part.id, point, state=loaded).end()
    print(f"grabbed again at {again.value:.2f}")
