"""Enums, errors, and functions of joints and poses, which need no context."""
import ctypes as c
import enum
from typing import Any, Sequence, Tuple

import numpy as np

from . import native as n
from .library import open_library

Vector = Sequence[float]
Hint = Tuple[Vector, Vector]


class JointType(enum.IntEnum):
    """How a part moves: Joint.type."""
    UNKNOWN = n.DM_JOINT_UNKNOWN
    REVOLUTE = n.DM_JOINT_REVOLUTE
    PRISMATIC = n.DM_JOINT_PRISMATIC
    SCREW = n.DM_JOINT_SCREW
    CONTINUOUS = n.DM_JOINT_CONTINUOUS
    FIXED = n.DM_JOINT_FIXED


class JointSource(enum.IntEnum):
    """Who says so: Joint.source."""
    NETWORK = n.DM_JOINT_FROM_NETWORK
    GEOMETRY = n.DM_JOINT_FROM_GEOMETRY
    HOST = n.DM_JOINT_FROM_HOST
    CHOSEN = n.DM_JOINT_CHOSEN


class JointBasis(enum.IntEnum):
    """Where the joint that a drag follows comes from: DragState.joint_basis."""
    PREPARED = n.DM_BASIS_PREPARED
    PULL = n.DM_BASIS_PULL
    HOST = n.DM_BASIS_HOST
    CHOSEN = n.DM_BASIS_CHOSEN


class Axes(enum.IntEnum):
    """The host's axes."""
    GLTF = n.DM_AXES_GLTF
    UNITY = n.DM_AXES_UNITY
    UNREAL = n.DM_AXES_UNREAL
    BLENDER = n.DM_AXES_BLENDER
    CUSTOM = n.DM_AXES_CUSTOM


class Picking(enum.IntEnum):
    """What picks rays."""
    AUTO = n.DM_PICK_AUTO
    EMBREE = n.DM_PICK_EMBREE
    PORTABLE = n.DM_PICK_PORTABLE
    NONE = n.DM_PICK_NONE


class Go(enum.IntEnum):
    """What a released part does next."""
    AUTO = n.DM_GO_AUTO
    STAY = n.DM_GO_STAY
    OPEN = n.DM_GO_OPEN
    CLOSE = n.DM_GO_CLOSE
    REPLAY = n.DM_GO_REPLAY
    FREEZE = n.DM_GO_FREEZE
    TOGGLE = n.DM_GO_TOGGLE


Intent = Go  # its name in 0.2


class Phase(enum.IntEnum):
    """What a drag does: DragState.phase."""
    HELD = n.DM_DRAG_HELD
    RELEASED = n.DM_DRAG_RELEASED
    AT_REST = n.DM_DRAG_AT_REST


class Event(enum.IntFlag):
    """What has happened to a part in an update: bits of DragState.events."""
    LIMIT_LOWER = n.DM_EVENT_LIMIT_LOWER
    LIMIT_UPPER = n.DM_EVENT_LIMIT_UPPER
    LEFT_REST = n.DM_EVENT_LEFT_REST
    REACHED_REST = n.DM_EVENT_REACHED_REST
    OPENED = n.DM_EVENT_OPENED
    CLOSED = n.DM_EVENT_CLOSED
    DETENT = n.DM_EVENT_DETENT
    JOINT = n.DM_EVENT_JOINT
    BLOCKED = n.DM_EVENT_BLOCKED
    FREED = n.DM_EVENT_FREED
    LATCHED = n.DM_EVENT_LATCHED
    UNLATCHED = n.DM_EVENT_UNLATCHED
    LOCKED = n.DM_EVENT_LOCKED
    LET_GO = n.DM_EVENT_LET_GO


class Status(enum.IntFlag):
    """What holds a part, and how it stands: bits of DragState.status and PartState.status."""
    LATCHED = n.DM_STATUS_LATCHED
    LOCKED = n.DM_STATUS_LOCKED
    BLOCKED = n.DM_STATUS_BLOCKED
    OPEN = n.DM_STATUS_OPEN


class Rule(enum.IntFlag):
    """Flags of the rules of a drag."""
    LOCKED = n.DM_RULE_LOCKED
    LATCH = n.DM_RULE_LATCH


class InputFlag(enum.IntFlag):
    """Flags of one Drag.update_input."""
    LOCKED = n.DM_INPUT_LOCKED
    ASK = n.DM_INPUT_ASK


StepFlag = InputFlag  # its name in 0.2


class LinkKind(enum.IntEnum):
    """What a link does to its driven part."""
    MOVES = n.DM_LINK_MOVES
    FREES = n.DM_LINK_FREES
    HOLDS = n.DM_LINK_HOLDS


class Error(RuntimeError):
    """A dm_result below 0; `code` is its number, `name` its name, the text what the library logged."""

    def __init__(self, name: str, code: int, message: str) -> None:
        super().__init__(name, code, message)  # all, so that it can be pickled
        self.name, self.code, self.message = name, code, message

    def __str__(self) -> str:
        return f"{self.name}: {self.message}" if self.message else self.name


def load() -> c.CDLL:
    """The shared library, loaded at the first use."""
    return open_library("libdragmesh.so", n.FUNCTIONS)


def check(result: int, message: str = "") -> None:
    """An Error for a failed call."""
    if result < 0:
        raise Error(load().dm_result_string(result).decode(), result, message)


def version() -> Tuple[int, int, int]:
    """Version of the library in use: major, minor, patch. An odd patch is a version in development."""
    number = load().dm_version()
    return number >> 22, number >> 12 & 0x3FF, number & 0xFFF


def vec3(values: Sequence[float]) -> n.Vec3:
    """Three numbers as the struct."""
    x, y, z = values
    return n.Vec3(float(x), float(y), float(z))


def hint_of(drag: Hint) -> n.DragHint:
    """(point, vector) as the struct."""
    point, vector = drag
    return n.DragHint(vec3(point), vec3(vector))


def joint_pose(joint: n.Joint, value: float) -> n.Pose:
    """Pose of a joint at a value."""
    out = n.Pose()
    check(load().dm_joint_pose(c.byref(joint), value, c.byref(out)))
    return out


def joint_value(joint: n.Joint, pose: n.Pose) -> Tuple[float, float, float]:
    """(value, angle off the joint, distance off the joint) of a pose: the inverse of joint_pose."""
    value, angle, distance = c.c_float(), c.c_float(), c.c_float()
    check(load().dm_joint_value(c.byref(joint), c.byref(pose), c.byref(value), c.byref(angle), c.byref(distance)))
    return value.value, angle.value, distance.value


def joint_value_at(joint: n.Joint, share: float) -> float:
    """The value at a share of the way from rest (0) to the open end (1)."""
    out = c.c_float()
    check(load().dm_joint_value_at(c.byref(joint), share, c.byref(out)))
    return out.value


def joint_frame(joint: n.Joint) -> n.JointFrame:
    """The joint as a physics engine's constraint."""
    out = n.JointFrame()
    check(load().dm_joint_get_frame(c.byref(joint), c.byref(out)))
    return out


def joint_scaled(joint: n.Joint, scale: Sequence[float]) -> n.Joint:
    """The joint of an instance scaled along the axes of the object frame."""
    out = n.Joint()
    check(load().dm_joint_scale(c.byref(joint), vec3(scale), c.byref(out)))
    return out


def pose_multiply(a: n.Pose, b: n.Pose) -> n.Pose:
    """a after b."""
    out = n.Pose()
    load().dm_pose_multiply(c.byref(a), c.byref(b), c.byref(out))
    return out


def pose_inverse(pose: n.Pose) -> n.Pose:
    """The motion back."""
    out = n.Pose()
    load().dm_pose_inverse(c.byref(pose), c.byref(out))
    return out


def pose_from_rotation(rotation: Sequence[float], translation: Sequence[float] = (0, 0, 0)) -> n.Pose:
    """A rotation by a quaternion x, y, z, w of any length, then a translation."""
    x, y, z, w = rotation
    out = n.Pose()
    check(load().dm_pose_from_rotation((c.c_float * 4)(x, y, z, w), vec3(translation), c.byref(out)))
    return out


def pose_matrix(pose: n.Pose) -> np.ndarray:
    """4 x 4, for column vectors."""
    out = (c.c_float * 16)()
    load().dm_pose_to_matrix(c.byref(pose), out)
    return np.array(out, np.float32).reshape(4, 4).T


def pose_apply(pose: n.Pose, points: Any) -> np.ndarray:
    """Points (n x 3 or 3) moved by a pose, in single precision."""
    given = np.asarray(points, np.float32)
    moved = np.array(given.reshape(-1, 3), order="C")
    data = moved.ctypes.data_as(c.POINTER(c.c_float))
    load().dm_pose_apply_points(c.byref(pose), data, 0, data, 0, len(moved))
    return moved.reshape(given.shape)
