"""What contexts make: models, objects, motions, drags, scenes."""
import ctypes as c
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from . import native as n
from .base import Unique, bytes_of, integer
from .values import Go, Hint, Vector, hint_of, vec3

if TYPE_CHECKING:
    from .context import Context


def _u32(value: Any, name: str) -> int:
    return integer(c.c_uint32, value, name)


class Owned(Unique):
    """Something that a context has made. close() ends it now, else it ends when nothing refers to it any more."""

    _end = ""
    _with: Tuple[Any, ...] = ()  # what follows the handle

    def __init__(self, context: "Context", handle: int, kept: Any = None) -> None:
        self.context, self.handle, self._kept = context, handle, kept
        self.uses = 0  # long calls that run with it

    def call(self, name: str, *arguments: Any) -> None:
        """dm_<name>(context, handle, ...), an Error when it fails."""
        self.context.call(name, self.handle, *arguments)

    def close(self) -> None:
        """Ends it. A second time does nothing. An error in a callback of its context, and while a call uses it."""
        if self.handle and self.context.pointer:
            self.context.end(self, self._end, self.handle, *self._with)
        self.handle = 0

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        handle, self.handle = getattr(self, "handle", 0), 0
        if handle and self.context.pointer:
            self.context.forget(self._end, handle, *self._with)


class Model(Owned):
    """Loaded weights."""
    _end = "model_unload"


class Object(Owned):
    """A prepared object: parts and their joints."""
    _end = "object_destroy"

    def info(self) -> n.ObjectInfo:
        """Counts, box, size."""
        info = n.ObjectInfo()
        self.call("object_get_info", c.byref(info))
        return info

    def parts(self) -> List[n.PartInfo]:
        """All parts, in order of id."""
        parts = []
        for index in range(self.info().part_count):
            parts.append(n.PartInfo())
            self.call("object_get_part", index, c.byref(parts[-1]))
        return parts

    def joint(self, part_id: int) -> n.Joint:
        """The joint in force."""
        joint = n.Joint()
        self.call("object_get_joint", _u32(part_id, "part_id"), c.byref(joint))
        return joint

    def set_joint(self, part_id: int, joint: n.Joint) -> None:
        """Puts the host's own joint in force."""
        self.call("object_set_joint", _u32(part_id, "part_id"), c.byref(joint))

    def reset_joint(self, part_id: int) -> None:
        """Puts the library's own answer back in force."""
        self.call("object_reset_joint", _u32(part_id, "part_id"))

    def hypotheses(self, part_id: int, drag: Optional[Hint] = None) -> List[n.Joint]:
        """Ranked joints, best first; drag=(point, vector) ranks them anew."""
        joints, count = (n.Joint * n.DM_MAX_HYPOTHESES)(), c.c_uint32()
        joints[0].struct_size = c.sizeof(n.Joint)
        hint = c.byref(hint_of(drag)) if drag is not None else None
        self.call("object_get_hypotheses", _u32(part_id, "part_id"), hint, joints, len(joints), c.byref(count))
        return list(joints[:count.value])

    def refine(self, part_id: int, drag: Hint) -> None:
        """Infers the joint again with a drag as evidence and puts the result in force."""
        self.call("object_refine", _u32(part_id, "part_id"), c.byref(hint_of(drag)))

    def save(self) -> bytes:
        """Bytes of a .dmo file."""
        size = c.c_size_t()
        self.call("object_save", None, 0, c.byref(size))
        buffer = c.create_string_buffer(size.value)
        self.call("object_save", buffer, size, c.byref(size))
        return buffer.raw[:size.value]

    def motion(self, part_id: int, drag: Hint, path: Any = None, seed: int = 0) -> "Motion":
        """The DQ-VAE's motion for a drag=(point, vector), or for the path (n x 3) a pointer drew."""
        desc = n.MotionDesc(part_id=part_id, drag=hint_of(drag), seed=seed)
        if path is not None:
            points = np.ascontiguousarray(path, np.float32).reshape(-1, 3)
            desc.path, desc.path_count = points.ctypes.data_as(c.POINTER(n.Vec3)), len(points)
        handle = c.c_uint64()
        self.call("motion_generate", c.byref(desc), c.byref(handle))
        return Motion(self.context, handle.value, self)

    def set_links(self, links: Sequence[Dict[str, Any]]) -> None:
        """Links parts, in place of the links of before: dicts of driver, driven and, as wanted, kind, ratio, offset,
        from_, both_ways."""
        rows = [n.Link(flags=int(link.pop("both_ways", False)), **link) for link in map(dict, links)]
        self.call("object_set_links", (n.Link * len(rows))(*rows), len(rows))

    def follow_links(self, part_id: int, values: Sequence[float]) -> Tuple[List[float], List[bool]]:
        """(values, held) of all parts, in order of id, after a part has moved. values: as they were, with its own."""
        moved, held = (c.c_float * len(values))(*values), (c.c_uint8 * len(values))()
        self.call("object_follow_links", _u32(part_id, "part_id"), moved, held, len(values))
        return list(moved), [bool(one) for one in held]

    def drag(self, part_id: int, grab_point: Optional[Vector] = None, start_value: float = 0.0, keep_joint: bool = False,
             limit_give: float = 0.0, state: Optional[n.PartState] = None, scale: Optional[Vector] = None,
             rules: Optional[Dict[str, Any]] = None, **feel: float) -> "Drag":
        """The player grabs the part at a point. None: at no point, to move it by a scalar or a release. state: what an
        earlier drag of this instance ended with; scale: of the instance; rules: a dict of fields of dm_drag_rules, {} for
        events alone, with snaps as a list; feel: fields of dm_drag_feel, such as smoothing_time=0.06."""
        desc = n.DragDesc(part_id=part_id, object=self.handle, start_value=start_value, feel=n.DragFeel(**feel),
                          limit_give=limit_give, flags=n.DM_DRAG_KEEP_JOINT if keep_joint else 0)
        if grab_point is None:
            desc.flags |= n.DM_DRAG_WITHOUT_POINT
        else:
            desc.grab_point = vec3(grab_point)
        if state is not None:
            desc.state = c.pointer(state)
        if scale is not None:
            desc.scale = vec3(scale)
        if rules is not None:
            desc.rules = c.pointer(_rules(**rules))
        handle = c.c_uint64()
        self.context.call("drag_begin", c.byref(desc), c.byref(handle))
        return Drag(self.context, handle.value, self)


def _rules(snaps: Sequence[float] = (), **fields: Any) -> n.DragRules:
    return n.DragRules(snap_count=len(snaps), snaps=(c.c_float * len(snaps))(*snaps), **fields)


class Motion(Owned):
    """A generated motion: 16 key poses, sampled continuously."""
    _end = "motion_destroy"

    def sample(self, t: float) -> Tuple[n.Pose, float]:
        """(pose, joint value) at t in [0, 1]."""
        pose, value = n.Pose(), c.c_float()
        self.call("motion_sample", t, c.byref(pose), c.byref(value))
        return pose, value.value

    def frames(self) -> Tuple[List[n.Pose], List[float]]:
        """The 16 key poses and their joint values."""
        poses, values = (n.Pose * n.DM_MOTION_FRAMES)(), (c.c_float * n.DM_MOTION_FRAMES)()
        self.call("motion_get_frames", poses, values)
        return list(poses), list(values)


def _hand(ray: Any = None, point: Any = None, rate: Optional[float] = None, move: Optional[float] = None,
          value: Optional[float] = None, grab_point: Any = None) -> n.Hand:
    """A hand by the one thing that is given of it."""
    hand = n.Hand(grab_point=vec3(grab_point)) if grab_point is not None else n.Hand()
    if ray is not None:
        hand.kind, hand.ray = n.DM_HAND_RAY, n.Ray(*map(vec3, ray))
    elif point is not None:
        hand.kind, hand.point = n.DM_HAND_POINT, vec3(point)
    for kind, amount in ((n.DM_HAND_RATE, rate), (n.DM_HAND_STEP, move), (n.DM_HAND_VALUE, value)):
        if amount is not None:
            hand.kind, hand.amount = kind, amount
    return hand


class Drag(Owned):
    """One player dragging one part."""
    _end = "drag_end"
    _with = (None,)

    def update(self, origin: Vector, direction: Vector, dt: float) -> n.DragState:
        """The state after the pointer's ray of this frame; dt in seconds."""
        state = n.DragState()
        self.call("drag_update", c.byref(n.Ray(vec3(origin), vec3(direction))), dt, c.byref(state))
        return state

    def update_input(self, dt: float, ray: Any = None, bounds: Optional[Tuple[float, float]] = None, point: Any = None,
                     rate: Optional[float] = None, value: Optional[float] = None,
                     handles: Tuple[float, float] = (0, 0), flags: int = 0, move: Optional[float] = None,
                     second: Optional[Dict[str, Any]] = None) -> n.DragState:
        """The state after an update by all that a dm_drag_input holds. Of the hand, one of: ray (origin, direction),
        point, rate, move (a wheel's share of the range), value, or no news of it. second: a dict of ray or point and
        grab_point of another hand. bounds: the joint values (lower, upper) between which there is room; handles: values
        of the latch's handles; flags: InputFlag."""
        given, state = n.DragInput(flags=flags, handles=(c.c_float * 2)(*handles)), n.DragState()
        given.hand = _hand(ray, point, rate, move, value)
        if second is not None:
            given.second = _hand(**second)
        if bounds is not None:
            given.lower, given.upper = bounds
        self.call("drag_update_input", c.byref(given), dt, c.byref(state))
        return state

    def override(self, value: float) -> n.DragState:
        """The state with another value than that of the last update_input, which had flags=InputFlag.ASK."""
        state = n.DragState()
        self.call("drag_override", value, c.byref(state))
        return state

    step, take = update_input, override  # their names in 0.2

    def part_state(self) -> n.PartState:
        """Joint, value and pose now, as the pull has left them: Object.drag(state=...) goes on from there."""
        state = n.PartState()
        self.call("drag_get_part_state", c.byref(state))
        return state

    def save(self) -> bytes:
        """The whole state, for rollback, as bytes."""
        buffer = c.create_string_buffer(self.context.library.dm_drag_snapshot_size())
        self.call("drag_save", buffer, len(buffer))
        return buffer.raw

    def restore(self, data: bytes) -> None:
        """Goes back to what save() gave."""
        data = bytes_of(data, "data")
        self.call("drag_restore", data, len(data))

    def release(self, intent: int = Go.AUTO, duration: float = 0.0, seed: int = 0,
                away_from: Optional[Vector] = None, by_rule: bool = False) -> n.ReleasePlan:
        """The player lets go: the plan of what the part does now. advance() moves it. away_from: where the player
        stands, for a part that opens to both sides. by_rule: the same bits on every processor."""
        desc = n.ReleaseDesc(intent=intent, duration=duration, seed=seed, flags=n.DM_RELEASE_BY_RULE if by_rule else 0)
        if away_from is not None:
            desc.flags |= n.DM_RELEASE_AWAY_FROM
            desc.away_from = vec3(away_from)
        plan = n.ReleasePlan()
        self.call("drag_release", c.byref(desc), c.byref(plan))
        return plan

    def advance(self, dt: float) -> n.DragState:
        """The state of a released part dt seconds later."""
        state = n.DragState()
        self.call("drag_update", None, dt, c.byref(state))
        return state

    def end(self) -> n.PartState:
        """Lets go; the part's state, to keep with the instance."""
        state = n.PartState()
        self.call("drag_end", c.byref(state))
        self.handle = 0
        return state


class Scene(Owned):
    """Placed objects that rays can pick."""
    _end = "scene_destroy"

    def __init__(self, context: "Context", handle: int) -> None:
        super().__init__(context, handle, {})

    def add(self, placed: Object, placement: Optional[n.Pose] = None) -> int:
        """Places an object, prepared with picking=True, and returns its instance. placement: from object to world."""
        instance = c.c_uint32()
        self.call("scene_add", placed.handle, c.byref(placement) if placement is not None else None, c.byref(instance))
        self._kept[instance.value] = placed  # it would leave the scene when it ends
        return instance.value

    def move(self, instance: int, part_id: int, pose: n.Pose) -> None:
        """Moves a part, or with part 0 the instance."""
        self.call("scene_move", _u32(instance, "instance"), _u32(part_id, "part_id"), c.byref(pose))

    def remove(self, instance: int) -> None:
        """Takes an instance out."""
        self.call("scene_remove", _u32(instance, "instance"))
        self._kept.pop(instance, None)

    def commit(self) -> None:
        """Makes moves visible to picks: once a frame."""
        self.call("scene_commit")

    def pick(self, origin: Vector, direction: Vector) -> Optional[n.Hit]:
        """The nearest hit of a ray of the world; None: nothing is hit."""
        hit = n.Hit()
        self.call("scene_pick", c.byref(n.Ray(vec3(origin), vec3(direction))), c.byref(hit))
        return hit if hit.object else None
