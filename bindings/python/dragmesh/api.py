"""dragmesh for Python: a thin, typed layer over dragmesh.h. Arrays are numpy's; everything is in the host's own frame."""
import ctypes as c
import enum
import os

import numpy as np

from . import structs as s
from .library import find_library


class JointType(enum.IntEnum):
    UNKNOWN, REVOLUTE, PRISMATIC, SCREW, CONTINUOUS, FIXED = range(6)


class Axes(enum.IntEnum):
    GLTF, UNITY, UNREAL, BLENDER, CUSTOM = range(5)


class Picking(enum.IntEnum):
    """What picks rays; see DM_PICK_*."""
    AUTO, EMBREE, PORTABLE, NONE = range(4)


class Intent(enum.IntEnum):
    """What a released part does next; see DM_INTENT_*."""
    AUTO, STAY, OPEN, CLOSE, REPLAY, FREEZE, TOGGLE = range(7)


class Hand(enum.IntEnum):
    """How a hand holds a part; see DM_HAND_*."""
    NONE, RAY, POINT, RATE, STEP, VALUE = range(6)


class Event(enum.IntFlag):
    """What has happened to a part in an update: bits of DragState.events; see DM_EVENT_*."""
    (LIMIT_LOWER, LIMIT_UPPER, LEFT_REST, REACHED_REST, OPENED, CLOSED, DETENT, JOINT, BLOCKED, FREED, LATCHED,
     UNLATCHED, LOCKED, LET_GO) = (1 << bit for bit in range(14))


class LinkKind(enum.IntEnum):
    """What a link does to its driven part; see DM_LINK_*."""
    MOVES, FREES, HOLDS = range(3)


LOCKED, ASK = 1, 2  # DM_INPUT_*


class Error(RuntimeError):
    """A dm_result below 0; `code` is its number, the text what the library logged."""

    def __init__(self, name, code, message):
        super().__init__(f"{name}: {message}" if message else name)
        self.code = code


_library = None


def load():
    """The shared library, loaded at the first use."""
    global _library
    if _library is None:
        _library = c.CDLL(find_library("libdragmesh.so"))
        _library.dm_result_string.restype = c.c_char_p
        _library.dm_version.restype = c.c_uint32
        for name in ("dm_context_destroy", "dm_pose_multiply", "dm_pose_to_matrix", "dm_pose_apply_points"):
            getattr(_library, name).restype = None
        _library.dm_drag_snapshot_size.restype = c.c_size_t
    return _library


def joint_pose(joint, value):
    """Pose of a joint at a value."""
    out = s.Pose()
    if load().dm_joint_pose(c.byref(joint), c.c_float(value), c.byref(out)) < 0:
        raise ValueError("no joint, or not finite")
    return out


def joint_value(joint, pose):
    """(value, angle off the joint, distance off the joint) of a pose: the inverse of joint_pose."""
    out = [c.c_float(), c.c_float(), c.c_float()]
    if load().dm_joint_value(c.byref(joint), c.byref(pose), *map(c.byref, out)) < 0:
        raise ValueError("no joint, or not finite")
    return tuple(number.value for number in out)


def joint_value_at(joint, share):
    """The value at a share of the way from rest (0) to the open end (1)."""
    out = c.c_float()
    if load().dm_joint_value_at(c.byref(joint), c.c_float(share), c.byref(out)) < 0:
        raise ValueError("no joint, or without limits")
    return out.value


def joint_frame(joint):
    """The joint as a physics engine's constraint."""
    out = s.JointFrame()
    if load().dm_joint_get_frame(c.byref(joint), c.byref(out)) < 0:
        raise ValueError("no joint, or not finite")
    return out


def _rules(snaps=(), **fields):
    """The fields of dm_drag_rules as the struct."""
    unknown = set(fields) - {name for name, _ in s.DragRules._fields_}
    if unknown:
        raise TypeError(f"dm_drag_rules has no {', '.join(sorted(unknown))}")
    return s.DragRules(snap_count=len(snaps), snaps=(c.c_float * len(snaps))(*snaps), **fields)


def _hint(drag):
    """(point, vector) to a dm_drag_hint."""
    point, vector = drag
    return s.DragHint(s.Vec3(*map(float, point)), s.Vec3(*map(float, vector)))


def _pivot(pivot):
    """(origin, axes) to a dm_pivot; axes None: unknown."""
    origin, axes = pivot
    numbers = np.zeros(9) if axes is None else np.asarray(axes, float).reshape(9)
    return s.Pivot(s.Vec3(*map(float, origin)), (c.c_float * 9)(*numbers))


def _array(values, dtypes, columns):
    """A contiguous array of one of the types that the boundary reads."""
    array = np.asarray(values)
    if array.dtype not in dtypes:
        array = array.astype(dtypes[0])
    return np.ascontiguousarray(array.reshape(-1, columns) if columns > 1 else array.reshape(-1))


_POSITIONS = [np.dtype(np.float32), np.dtype(np.float64)]
_INDICES = [np.dtype(np.uint32), np.dtype(np.uint16), np.dtype(np.uint8)]
_PART_IDS = [*_INDICES, np.dtype(np.int32)]


def pose_matrix(pose):
    """4 x 4, for column vectors."""
    out = (c.c_float * 16)()
    load().dm_pose_to_matrix(c.byref(pose), out)
    return np.array(out, np.float32).reshape(4, 4).T


def _chooser(choose, failures):
    """The callback for a Python function. Nothing may pass through the library, so exceptions are kept in a list."""

    def answer(_, choice):
        if failures:
            return s.CHOICE_KEEP
        try:
            shown = [choice.contents.hypotheses[i].contents for i in range(choice.contents.count)]
            index = choose(choice.contents.part.contents, shown)
            return s.CHOICE_KEEP if index is None else int(index)
        except BaseException as failure:  # pylint: disable=broad-except
            failures.append(failure)
            return s.CHOICE_KEEP

    return s.CHOICE_CALLBACK(answer)


class Context:
    """A context and everything made with it. Use as a context manager, or call close()."""

    def __init__(self, axes=Axes.GLTF, unit_in_metres=1.0, picking=Picking.AUTO):
        self.library, self.message = load(), ""
        self._log = s.LOG_CALLBACK(self._remember)  # kept: the library calls it
        desc = s.ContextDesc(axes=int(axes), unit_in_metres=unit_in_metres,
                             log=s.Log(None, self._log), picking=int(picking))
        self.pointer = c.c_void_p()
        self.check(self.library.dm_context_create(c.byref(desc), c.byref(self.pointer)))

    def _remember(self, user, level, code, text):
        if level == 0:
            self.message = text.decode(errors="replace")

    def check(self, result):
        if result < 0:
            message, self.message = self.message, ""
            raise Error(self.library.dm_result_string(result).decode(), result, message)

    def call(self, name, *arguments):
        """dm_<name>(context, ...), an Error when it fails."""
        self.check(getattr(self.library, "dm_" + name)(self.pointer, *arguments))

    def close(self):
        if self.pointer:
            self.library.dm_context_destroy(self.pointer)
            self.pointer = c.c_void_p()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def memory(self):
        info = s.MemoryInfo()
        self.call("context_get_memory", c.byref(info))
        return info

    def load_model(self, kinematics=None, motion=None, ranker=None):
        """A model from the bytes (or the paths) of the safetensors files; each may be absent."""
        values = {}
        for name, data in (("kinematics", kinematics), ("motion", motion), ("ranker", ranker)):
            if isinstance(data, (str, os.PathLike)):
                with open(data, "rb") as file:
                    data = file.read()
            values.update({name: data, name + "_size": len(data or b"")})
        desc = s.ModelDesc(**values)
        handle = c.c_uint64()
        self.call("model_load", c.byref(desc), c.byref(handle))
        return Model(self, handle)

    def prepare(self, positions, indices, part_ids, parts=None, model=None, seed=0, picking=False, label=None, up=None,
                choose=None):
        """An object from vertices (n x 3), triangles (m x 3) and one part id a vertex or a triangle (0 = the body).

        parts: a list of dicts with id and, as wanted, parent, joint_type, drag=(point, vector), label (names of the asset
        for the part, joined by "/"), pivot=(origin, axes) (axes: three rows or None); None: every id. label, up: of the
        object; see dm_object_desc. choose(part, hypotheses): picks one for each part, by its index, or None to keep the
        library's answer; a PartInfo and a list of Hypothesis, valid during the call."""
        positions, indices = _array(positions, _POSITIONS, 3), _array(indices, _INDICES, 1)
        part_ids = _array(part_ids, _PART_IDS, 1)
        per_face = len(part_ids) != len(positions)
        if per_face and len(part_ids) * 3 != len(indices):
            raise ValueError(f"{len(part_ids)} part ids for {len(positions)} vertices and {len(indices) // 3} triangles")
        mesh = s.MeshDesc(
            positions=positions.ctypes.data, vertex_count=len(positions), indices=indices.ctypes.data,
            index_count=len(indices), part_ids=part_ids.ctypes.data,
            position_bytes=positions.nbytes, index_bytes=indices.nbytes, part_id_bytes=part_ids.nbytes,
            position_format=_POSITIONS.index(positions.dtype), index_format=_INDICES.index(indices.dtype),
            part_id_format=_PART_IDS.index(part_ids.dtype), part_id_scope=int(per_face))
        rows = (s.PartDesc * len(parts or []))()
        hints, pivots = [], []
        for row, part in zip(rows, parts or []):
            row.struct_size, row.id, row.parent = c.sizeof(s.PartDesc), part["id"], part.get("parent", 0)
            row.joint_type = int(part.get("joint_type", 0))
            if part.get("drag") is not None:
                hints.append(_hint(part["drag"]))
                row.drag = c.pointer(hints[-1])
            if part.get("label") is not None:
                row.label = part["label"].encode()
            if part.get("pivot") is not None:
                pivots.append(_pivot(part["pivot"]))
                row.pivot = c.pointer(pivots[-1])
        desc = s.ObjectDesc(flags=0 if picking else 1, mesh=c.pointer(mesh),
                          parts=rows if parts else None, part_count=len(rows),
                          model=model.handle if model else 0, seed=seed, label=label.encode() if label else None,
                          up=s.Vec3(*up) if up is not None else s.Vec3())
        failures = []
        if choose is not None:
            desc.choose = _chooser(choose, failures)
        handle = c.c_uint64()
        self.call("object_prepare", c.byref(desc), c.byref(handle))
        if failures:
            self.call("object_destroy", handle)
            raise failures[0]
        return Object(self, handle)

    def load_object(self, data, model=None):
        """An object from the bytes that Object.save gave."""
        handle = c.c_uint64()
        self.call("object_load", data, c.c_size_t(len(data)), c.c_uint64(model.handle.value if model else 0),
                  c.byref(handle))
        return Object(self, handle)


class Model:
    """Loaded weights."""

    def __init__(self, context, handle):
        self.context, self.handle = context, handle

    def unload(self):
        self.context.call("model_unload", self.handle)


class Object:
    """A prepared object: parts and their joints."""

    def __init__(self, context, handle):
        self.context, self.handle = context, handle

    def destroy(self):
        self.context.call("object_destroy", self.handle)

    def info(self):
        info = s.ObjectInfo()
        self.context.call("object_get_info", self.handle, c.byref(info))
        return info

    def parts(self):
        parts = []
        for index in range(self.info().part_count):
            parts.append(s.PartInfo())
            self.context.call("object_get_part", self.handle, c.c_uint32(index), c.byref(parts[-1]))
        return parts

    def joint(self, part_id):
        """The joint in force."""
        joint = s.Joint()
        self.context.call("object_get_joint", self.handle, c.c_uint32(part_id), c.byref(joint))
        return joint

    def set_joint(self, part_id, joint):
        self.context.call("object_set_joint", self.handle, c.c_uint32(part_id), c.byref(joint))

    def reset_joint(self, part_id):
        """Puts the library's own answer back in force."""
        self.context.call("object_reset_joint", self.handle, c.c_uint32(part_id))

    def hypotheses(self, part_id, drag=None):
        """Ranked joints, best first; drag=(point, vector) ranks them anew."""
        joints, count = (s.Joint * s.MAX_HYPOTHESES)(), c.c_uint32()
        joints[0].struct_size = c.sizeof(s.Joint)
        hint = c.byref(_hint(drag)) if drag is not None else None
        self.context.call("object_get_hypotheses", self.handle, c.c_uint32(part_id), hint, joints,
                          c.c_uint32(len(joints)), c.byref(count))
        return list(joints[:count.value])

    def refine(self, part_id, drag):
        """Runs joint inference again with a drag as additional input; the result becomes the active joint."""
        self.context.call("object_refine", self.handle, c.c_uint32(part_id), c.byref(_hint(drag)))

    def save(self):
        """Bytes of a .dmo file."""
        size = c.c_size_t()
        self.context.call("object_save", self.handle, None, c.c_size_t(0), c.byref(size))
        buffer = c.create_string_buffer(size.value)
        self.context.call("object_save", self.handle, buffer, size, c.byref(size))
        return buffer.raw[:size.value]

    def motion(self, part_id, drag, path=None, seed=0):
        """The DQ-VAE's motion for a drag=(point, vector), or for the path (n x 3) a pointer drew."""
        desc = s.MotionDesc(part_id=part_id, drag=_hint(drag), seed=seed)
        if path is not None:
            points = np.ascontiguousarray(path, np.float32).reshape(-1, 3)
            desc.path, desc.path_count = points.ctypes.data, len(points)
        handle = c.c_uint64()
        self.context.call("motion_generate", self.handle, c.byref(desc), c.byref(handle))
        return Motion(self.context, handle)

    def set_links(self, links):
        """Links parts, in place of the links of before: dicts of driver, driven and, as wanted, kind, ratio, offset,
        from_, both_ways."""
        rows = [s.Link(flags=int(link.pop("both_ways", False)), **link) for link in map(dict, links)]
        self.context.call("object_set_links", self.handle, (s.Link * len(rows))(*rows), c.c_uint32(len(rows)))

    def follow_links(self, part_id, values):
        """(values, held) of all parts, in order of id, after a part has moved. values: as they were, with its own."""
        moved, held = (c.c_float * len(values))(*values), (c.c_uint8 * len(values))()
        self.context.call("object_follow_links", self.handle, c.c_uint32(part_id), moved, held,
                          c.c_uint32(len(values)))
        return list(moved), [bool(one) for one in held]

    def drag(self, part_id, grab_point=None, start_value=0.0, keep_joint=False, limit_give=0.0, state=None, scale=None,
             rules=None, **feel):
        """The player grabs the part at a point, None: at none, to move it by a scalar or a release. state: what an earlier drag of this instance ended with; scale: of the
        instance; rules: a dict of fields of dm_drag_rules, {} for events alone, with snaps as a list; feel: fields of
        dm_drag_feel, such as smoothing_time=0.06."""
        unknown = set(feel) - {name for name, _ in s.DragFeel._fields_}
        if unknown:
            raise TypeError(f"dm_drag_feel has no {', '.join(sorted(unknown))}")
        desc = s.DragDesc(part_id=part_id, object=self.handle, start_value=start_value,
                          feel=s.DragFeel(**feel), flags=int(keep_joint) | (2 if grab_point is None else 0),
                          limit_give=limit_give)
        if grab_point is not None:
            desc.grab_point = s.Vec3(*map(float, grab_point))
        if state is not None:
            desc.state = c.pointer(state)
        if scale is not None:
            desc.scale = s.Vec3(*map(float, scale))
        if rules is not None:
            desc.rules = c.pointer(_rules(**rules))
        handle = c.c_uint64()
        self.context.call("drag_begin", c.byref(desc), c.byref(handle))
        return Drag(self.context, handle)


class Motion:
    """A generated motion: 16 key poses, sampled continuously."""

    def __init__(self, context, handle):
        self.context, self.handle = context, handle

    def sample(self, t):
        """(pose, joint value) at t in [0, 1]."""
        pose, value = s.Pose(), c.c_float()
        self.context.call("motion_sample", self.handle, c.c_float(t), c.byref(pose), c.byref(value))
        return pose, value.value

    def frames(self):
        """The 16 key poses and their joint values."""
        poses, values = (s.Pose * s.MOTION_FRAMES)(), (c.c_float * s.MOTION_FRAMES)()
        self.context.call("motion_get_frames", self.handle, poses, values)
        return list(poses), list(values)

    def destroy(self):
        self.context.call("motion_destroy", self.handle)


class Drag:
    """One player dragging one part."""

    def __init__(self, context, handle):
        self.context, self.handle = context, handle

    def update(self, origin, direction, dt):
        """The state after the pointer's ray of this frame; dt in seconds."""
        ray, state = s.Ray(s.Vec3(*map(float, origin)), s.Vec3(*map(float, direction))), s.DragState()
        self.context.call("drag_update", self.handle, c.byref(ray), c.c_float(dt), c.byref(state))
        return state

    def step(self, dt, ray=None, bounds=None, point=None, rate=None, value=None, handles=(0, 0), flags=0):
        """The state after an update by all that a dm_drag_input holds. Of the hand, one of: ray (origin, direction),
        point, rate, value, or no news of it. bounds: the joint values (lower, upper) between which there is room;
        handles: values of the latch's handles; flags: LOCKED, ASK."""
        given, state = s.DragInput(flags=flags, handles=(c.c_float * 2)(*handles)), s.DragState()
        if ray is not None:
            given.hand = s.Hand(Hand.RAY, s.Ray(*(s.Vec3(*map(float, vector)) for vector in ray)))
        elif point is not None:
            given.hand = s.Hand(kind=Hand.POINT, point=s.Vec3(*map(float, point)))
        elif rate is not None:
            given.hand = s.Hand(kind=Hand.RATE, amount=rate)
        elif value is not None:
            given.hand = s.Hand(kind=Hand.VALUE, amount=value)
        if bounds is not None:
            given.lower, given.upper = bounds
        self.context.call("drag_step", self.handle, c.byref(given), c.c_float(dt), c.byref(state))
        return state

    def take(self, value):
        """The state with another value than that of the last step, which had flags=ASK."""
        state = s.DragState()
        self.context.call("drag_take", self.handle, c.c_float(value), c.byref(state))
        return state

    def part_state(self):
        """Joint, value and pose now, as the pull has left them: Object.drag(state=...) goes on from there."""
        state = s.PartState()
        self.context.call("drag_get_part_state", self.handle, c.byref(state))
        return state

    def save(self):
        """The whole state, for rollback, as bytes."""
        buffer = c.create_string_buffer(load().dm_drag_snapshot_size())
        self.context.call("drag_save", self.handle, buffer, c.c_size_t(len(buffer)))
        return buffer.raw

    def restore(self, data):
        """Goes back to what save() gave."""
        self.context.call("drag_restore", self.handle, data, c.c_size_t(len(data)))

    def release(self, intent=Intent.AUTO, duration=0.0, seed=0, away_from=None):
        """The player lets go: the plan of what the part does now. advance() moves it. away_from: where the player
        stands, for a part that opens to both sides."""
        desc = s.ReleaseDesc(intent=int(intent), duration=duration, seed=seed)
        if away_from is not None:
            desc.flags, desc.away_from = 2, s.Vec3(*map(float, away_from))
        plan = s.ReleasePlan()
        self.context.call("drag_release", self.handle, c.byref(desc), c.byref(plan))
        return plan

    def advance(self, dt):
        """The state of a released part dt seconds later."""
        state = s.DragState()
        self.context.call("drag_update", self.handle, None, c.c_float(dt), c.byref(state))
        return state

    def end(self):
        """Lets go; the part's state, to keep with the instance."""
        state = s.PartState()
        self.context.call("drag_end", self.handle, c.byref(state))
        return state
