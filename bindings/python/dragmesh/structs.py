"""The structs of dragmesh.h in ctypes, field for field."""
import ctypes as c

MOTION_FRAMES = 16
MAX_HYPOTHESES = 8


class Sized(c.Structure):
    """A struct that states its size, as dm_*_default() makes them."""

    def __init__(self, **values):
        super().__init__(**{"struct_size": c.sizeof(type(self)), **values})


class Vec3(c.Structure):
    _fields_ = [("x", c.c_float), ("y", c.c_float), ("z", c.c_float)]

    def __iter__(self):
        return iter((self.x, self.y, self.z))


class Pose(c.Structure):
    """Unit dual quaternion: real and dual part, x, y, z, w each."""

    _fields_ = [("real", c.c_float * 4), ("dual", c.c_float * 4)]


class Ray(c.Structure):
    _fields_ = [("origin", Vec3), ("direction", Vec3)]


class Allocator(c.Structure):
    _fields_ = [("user", c.c_void_p), ("allocate", c.c_void_p), ("release", c.c_void_p)]


LOG_CALLBACK = c.CFUNCTYPE(None, c.c_void_p, c.c_int32, c.c_int32, c.c_char_p)


class Log(c.Structure):
    _fields_ = [("user", c.c_void_p), ("message", LOG_CALLBACK)]


class Jobs(c.Structure):
    _fields_ = [("user", c.c_void_p), ("parallel_for", c.c_void_p)]


class ContextDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("axes", c.c_int32), ("unit_in_metres", c.c_float),
                ("custom_axes", c.c_float * 9), ("allocator", Allocator), ("log", Log), ("jobs", Jobs),
                ("picking", c.c_int32), ("reserved", c.c_uint32)]


class MemoryInfo(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("reserved", c.c_uint32), ("bytes", c.c_uint64), ("peak_bytes", c.c_uint64),
                ("allocations", c.c_uint64), ("pick_bytes", c.c_uint64)]


class ModelDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("kinematics", c.c_char_p), ("kinematics_size", c.c_size_t),
                ("motion", c.c_char_p), ("motion_size", c.c_size_t), ("ranker", c.c_char_p), ("ranker_size", c.c_size_t)]


class MeshDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("position_stride", c.c_uint32), ("positions", c.c_void_p),
                ("vertex_count", c.c_uint64), ("position_bytes", c.c_uint64), ("indices", c.c_void_p),
                ("index_count", c.c_uint64), ("index_bytes", c.c_uint64), ("part_ids", c.c_void_p),
                ("part_id_bytes", c.c_uint64), ("part_id_stride", c.c_uint32), ("position_format", c.c_int32),
                ("index_format", c.c_int32), ("part_id_format", c.c_int32), ("part_id_scope", c.c_int32),
                ("reserved", c.c_uint32)]


class DragHint(c.Structure):
    _fields_ = [("point", Vec3), ("vector", Vec3)]


class Pivot(c.Structure):
    """Where an asset has the node that moves a part; see dm_pivot."""

    _fields_ = [("origin", Vec3), ("axes", c.c_float * 9)]


class PartDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("id", c.c_uint32), ("parent", c.c_uint32), ("joint_type", c.c_int32),
                ("drag", c.POINTER(DragHint)), ("label", c.c_char_p), ("pivot", c.POINTER(Pivot))]


class Joint(Sized):
    """How a part moves; see dm_joint."""

    _fields_ = [("struct_size", c.c_uint32), ("type", c.c_int32), ("type_confidence", c.c_float),
                ("joint_confidence", c.c_float), ("pitch", c.c_float), ("axis", Vec3), ("origin", Vec3),
                ("lower", c.c_float), ("upper", c.c_float), ("source", c.c_int32)]


class JointFrame(Sized):
    """A joint as a physics engine's constraint; see dm_joint_frame."""

    _fields_ = [("struct_size", c.c_uint32), ("type", c.c_int32), ("origin", Vec3), ("x", Vec3), ("y", Vec3),
                ("z", Vec3), ("rotation", c.c_float * 4), ("lower", c.c_float), ("upper", c.c_float),
                ("limits", c.c_uint32), ("pitch", c.c_float)]


class PartState(Sized):
    """Where an instance's part stands, and by which joint; see dm_part_state."""

    _fields_ = [("struct_size", c.c_uint32), ("value", c.c_float), ("pose", Pose), ("joint", Joint)]


class PartInfo(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("id", c.c_uint32), ("parent", c.c_uint32),
                ("triangle_count", c.c_uint32), ("box_min", Vec3), ("box_max", Vec3), ("centre", Vec3),
                ("area", c.c_float)]


class JointEnd(c.Structure):
    """Where a hypothesis takes its part at one end of its range; see dm_joint_end."""

    _fields_ = [("value", c.c_float), ("pose", Pose), ("box_min", Vec3), ("box_max", Vec3), ("centre", Vec3)]


class Hypothesis(Sized):
    """A ranked joint and what it would do; see dm_hypothesis."""

    _fields_ = [("struct_size", c.c_uint32), ("reserved", c.c_uint32), ("joint", c.POINTER(Joint)),
                ("ends", JointEnd * 2)]


class Choice(Sized):
    """A part and its hypotheses; see dm_choice."""

    _fields_ = [("struct_size", c.c_uint32), ("count", c.c_uint32), ("part", c.POINTER(PartInfo)),
                ("hypotheses", c.POINTER(c.POINTER(Hypothesis)))]


CHOICE_KEEP = -1
CHOICE_CALLBACK = c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(Choice))


class ObjectDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("flags", c.c_uint32), ("mesh", c.POINTER(MeshDesc)),
                ("parts", c.POINTER(PartDesc)), ("part_count", c.c_uint32), ("reserved", c.c_uint32),
                ("model", c.c_uint64), ("seed", c.c_uint64), ("intent", c.c_void_p), ("intent_user", c.c_void_p),
                ("progress", c.c_void_p), ("progress_user", c.c_void_p), ("label", c.c_char_p), ("up", Vec3),
                ("reserved2", c.c_uint32), ("choose", CHOICE_CALLBACK), ("choose_user", c.c_void_p)]


class ObjectInfo(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("part_count", c.c_uint32), ("vertex_count", c.c_uint64),
                ("triangle_count", c.c_uint64), ("box_min", Vec3), ("box_max", Vec3), ("size", c.c_float),
                ("pickable", c.c_uint32)]


class MotionDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("part_id", c.c_uint32), ("drag", DragHint), ("path", c.c_void_p),
                ("path_count", c.c_uint32), ("seed", c.c_uint32)]


class DragFeel(c.Structure):
    _fields_ = [("smoothing_time", c.c_float), ("soft_limit", c.c_float), ("coast_time", c.c_float),
                ("detent", c.c_float), ("detent_pull", c.c_float), ("return_time", c.c_float)]


class DragRules(Sized):
    """What a part does besides following the hand; see dm_drag_rules."""

    _fields_ = [("struct_size", c.c_uint32), ("flags", c.c_uint32), ("snaps", c.POINTER(c.c_float)),
                ("snap_count", c.c_uint32), ("snap_reach", c.c_float), ("open_share", c.c_float),
                ("closed_share", c.c_float), ("event_time", c.c_float), ("max_speed", c.c_float),
                ("max_acceleration", c.c_float), ("lock_give", c.c_float), ("latch_turn", c.c_float),
                ("auto_close_share", c.c_float), ("auto_close_time", c.c_float), ("close_delay", c.c_float),
                ("tip_share", c.c_float), ("fall_time", c.c_float), ("restitution", c.c_float),
                ("break_distance", c.c_float), ("drive_speed", c.c_float), ("reserved", c.c_uint32)]


class Hand(c.Structure):
    _fields_ = [("kind", c.c_int32), ("ray", Ray), ("point", Vec3), ("amount", c.c_float), ("grab_point", Vec3)]


class DragInput(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("flags", c.c_uint32), ("hand", Hand), ("second", Hand),
                ("handles", c.c_float * 2), ("lower", c.c_float), ("upper", c.c_float)]


class Link(c.Structure):
    """A link between two parts; see dm_link."""

    _fields_ = [("driver", c.c_uint32), ("driven", c.c_uint32), ("kind", c.c_int32), ("flags", c.c_uint32),
                ("ratio", c.c_float), ("offset", c.c_float), ("from_", c.c_float)]


class DragDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("part_id", c.c_uint32), ("object", c.c_uint64), ("grab_point", Vec3),
                ("start_value", c.c_float), ("feel", DragFeel), ("flags", c.c_uint32), ("limit_give", c.c_float),
                ("state", c.POINTER(PartState)), ("scale", Vec3), ("reserved", c.c_uint32),
                ("rules", c.POINTER(DragRules))]


class DragState(Sized):
    """Where a dragged part is; see dm_drag_state."""

    _fields_ = [("struct_size", c.c_uint32), ("pose", Pose), ("grab_point", Vec3), ("value", c.c_float),
                ("target", c.c_float), ("velocity", c.c_float), ("at_limit", c.c_int32), ("phase", c.c_int32),
                ("changes", c.c_uint32), ("events", c.c_uint32), ("detents", c.c_uint32), ("impact", c.c_float)]


class ReleaseDesc(Sized):
    _fields_ = [("struct_size", c.c_uint32), ("intent", c.c_int32), ("duration", c.c_float), ("seed", c.c_uint32),
                ("flags", c.c_uint32), ("away_from", Vec3)]


class ReleasePlan(Sized):
    """What a released part will do; see dm_release_plan."""

    _fields_ = [("struct_size", c.c_uint32), ("intent", c.c_int32), ("start_value", c.c_float),
                ("end_value", c.c_float), ("duration", c.c_float), ("from_network", c.c_uint32)]
