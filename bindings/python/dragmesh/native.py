# The C interface of dragmesh. Written by scripts/describe from the public headers: not to be edited.
# pylint: disable=line-too-long, missing-class-docstring, too-many-lines, too-few-public-methods
"""The structs, constants and functions of the C headers, for ctypes."""
import ctypes as c
from typing import Any

from .base import Sized, Struct

DM_VERSION_MAJOR = 0
DM_VERSION_MINOR = 4
DM_VERSION_PATCH = 0
DM_VERSION_DEVELOPMENT = 1
DM_MOTION_FRAMES = 16
DM_MAX_HYPOTHESES = 8
DM_MAX_PARTS = 4096
DM_MAX_ASSET_NODES = 65536
DM_MAX_LABEL = 4096
DM_MAX_ELEMENTS = 268435456
DM_MAX_LINKS = 256
DM_MAX_SNAPS = 16
DM_DRAG_SNAPSHOT_MAX = 65536
DM_ASSET_NO_NODE = 4294967295
DM_ASSET_NO_PART = 4294967295
DM_GLTF_NO_CARRIER = 4294967295
DM_OK = 0
DM_ERROR_INVALID_ARGUMENT = -1
DM_ERROR_STRUCT_SIZE = -2
DM_ERROR_STALE_HANDLE = -3
DM_ERROR_OUT_OF_MEMORY = -4
DM_ERROR_NOT_FINITE = -5
DM_ERROR_INDEX_OUT_OF_RANGE = -6
DM_ERROR_EMPTY_MASK = -7
DM_ERROR_FULL_MASK = -8
DM_ERROR_DEGENERATE_MESH = -9
DM_ERROR_ZERO_DRAG = -10
DM_ERROR_DRAG_OFF_PART = -11
DM_ERROR_BAD_DATA = -12
DM_ERROR_WRONG_MODEL = -13
DM_ERROR_VERSION = -14
DM_ERROR_CANCELLED = -15
DM_ERROR_NO_MODEL = -16
DM_ERROR_TOO_LARGE = -17
DM_ERROR_BUFFER_TOO_SMALL = -18
DM_ERROR_NOT_FOUND = -19
DM_ERROR_UNSUPPORTED = -20
DM_ERROR_INTERNAL = -21
DM_LOG_ERROR = 0
DM_LOG_WARNING = 1
DM_LOG_INFO = 2
DM_AXES_GLTF = 0
DM_AXES_UNITY = 1
DM_AXES_UNREAL = 2
DM_AXES_BLENDER = 3
DM_AXES_CUSTOM = 4
DM_PICK_AUTO = 0
DM_PICK_EMBREE = 1
DM_PICK_PORTABLE = 2
DM_PICK_NONE = 3
DM_JOINT_UNKNOWN = 0
DM_JOINT_REVOLUTE = 1
DM_JOINT_PRISMATIC = 2
DM_JOINT_SCREW = 3
DM_JOINT_CONTINUOUS = 4
DM_JOINT_FIXED = 5
DM_FLOAT32 = 0
DM_FLOAT64 = 1
DM_UINT32 = 0
DM_UINT16 = 1
DM_UINT8 = 2
DM_INT32 = 3
DM_PER_VERTEX = 0
DM_PER_FACE = 1
DM_PIVOT_UNKNOWN = 0
DM_PIVOT_DEFAULT = 1
DM_PIVOT_SET = 2
DM_JOINT_FROM_NETWORK = 0
DM_JOINT_FROM_GEOMETRY = 1
DM_JOINT_FROM_HOST = 2
DM_JOINT_CHOSEN = 3
DM_LIMIT_LOWER = 1
DM_LIMIT_UPPER = 2
DM_CHOICE_KEEP = -1
DM_PREPARE_WITHOUT_PICKING = 1
DM_PREPARE_NETWORK_ALONE = 2
DM_PREPARE_MESH_INCOMPLETE = 4
DM_DEGRADED_NO_KINEMATICS = 1
DM_DEGRADED_NO_RANKER = 2
DM_DEGRADED_NO_MOTION = 4
DM_DEGRADED_NO_BODY = 8
DM_DEGRADED_HINT = 16
DM_DEGRADED_MESH = 32
DM_ASSET_NODE_FOLLOWS = 1
DM_ASSET_NODE_NO_PIVOT = 2
DM_CLIP_NOT_RIGID = 1
DM_ASSET_WITHOUT_CLIPS = 256
DM_ASSET_WITHOUT_NAMES = 512
DM_ASSET_CLIP_LEFT_OUT = 1
DM_ASSET_STAYS = 0
DM_ASSET_MOVES = 1
DM_ASSET_FREE = 2
DM_ASSET_INFERRED = 0
DM_ASSET_FROM_FILE = 1
DM_ASSET_FROM_CLIP = 2
DM_DRAG_KEEP_JOINT = 1
DM_DRAG_WITHOUT_POINT = 2
DM_RULE_LOCKED = 1
DM_RULE_LATCH = 2
DM_LINK_MOVES = 0
DM_LINK_FREES = 1
DM_LINK_HOLDS = 2
DM_LINK_BOTH_WAYS = 1
DM_HAND_NONE = 0
DM_HAND_RAY = 1
DM_HAND_POINT = 2
DM_HAND_RATE = 3
DM_HAND_STEP = 4
DM_HAND_VALUE = 5
DM_INPUT_LOCKED = 1
DM_INPUT_ASK = 2
DM_INPUT_BOUNDS = 4
DM_DRAG_HELD = 0
DM_DRAG_RELEASED = 1
DM_DRAG_AT_REST = 2
DM_EVENT_LIMIT_LOWER = 1
DM_EVENT_LIMIT_UPPER = 2
DM_EVENT_LEFT_REST = 4
DM_EVENT_REACHED_REST = 8
DM_EVENT_OPENED = 16
DM_EVENT_CLOSED = 32
DM_EVENT_DETENT = 64
DM_EVENT_JOINT = 128
DM_EVENT_BLOCKED = 256
DM_EVENT_FREED = 512
DM_EVENT_LATCHED = 1024
DM_EVENT_UNLATCHED = 2048
DM_EVENT_LOCKED = 4096
DM_EVENT_LET_GO = 8192
DM_STATUS_LATCHED = 1
DM_STATUS_LOCKED = 2
DM_STATUS_BLOCKED = 4
DM_STATUS_OPEN = 8
DM_BASIS_PREPARED = 0
DM_BASIS_PULL = 1
DM_BASIS_HOST = 2
DM_BASIS_CHOSEN = 3
DM_GO_AUTO = 0
DM_GO_STAY = 1
DM_GO_OPEN = 2
DM_GO_CLOSE = 3
DM_GO_REPLAY = 4
DM_GO_FREEZE = 5
DM_GO_TOGGLE = 6
DM_INTENT_AUTO = 0
DM_INTENT_STAY = 1
DM_INTENT_OPEN = 2
DM_INTENT_CLOSE = 3
DM_INTENT_REPLAY = 4
DM_INTENT_FREEZE = 5
DM_INTENT_TOGGLE = 6
DM_RELEASE_BY_RULE = 1
DM_RELEASE_AWAY_FROM = 2
DM_GLTF_WRAP_REPEAT = 10497
DM_GLTF_WRAP_CLAMP = 33071
DM_GLTF_WRAP_MIRROR = 33648
DM_GLTF_RIG_URDF = 1
DM_GLTF_RIG_MJCF = 2
DM_GLTF_RIG_SDF = 4
DM_GLTF_RIG_USDA = 8
DM_GLTF_RIG_TSCN = 16
DM_GLTF_RIG_GLB = 32


class Vec3(Struct):
    x: float
    y: float
    z: float
    _fields_ = [
        ("x", c.c_float),
        ("y", c.c_float),
        ("z", c.c_float),
    ]


class Pose(Struct):
    """A rigid pose x' = R x + t as a unit dual quaternion real + eps dual, both in x, y, z, w order; dual = 1/2 t (*) real with t as a pure quaternion. Identity: real = {0,0,0,1}, dual = {0,0,0,0}."""

    real: Any
    dual: Any
    _fields_ = [
        ("real", c.c_float * 4),
        ("dual", c.c_float * 4),
    ]


class Ray(Struct):
    """A ray. The direction need not be a unit vector. Distances along the ray are in host units, not in multiples of it."""

    origin: Vec3
    direction: Vec3
    _fields_ = [
        ("origin", Vec3),
        ("direction", Vec3),
    ]


class Allocator(Struct):
    """The host's memory. allocate returns memory aligned to `alignment` (a power of two, 64 at most) or NULL; release gets the size that was asked for. Both may be called from any thread on which the host calls the library. docs/integration.md says what callbacks may do."""

    user: Any
    allocate: Any
    release: Any
    _fields_ = [
        ("user", c.c_void_p),
        ("allocate", c.CFUNCTYPE(c.c_void_p, c.c_void_p, c.c_size_t, c.c_size_t)),
        ("release", c.CFUNCTYPE(None, c.c_void_p, c.c_void_p, c.c_size_t)),
    ]


class Log(Struct):
    """Receives messages for people, on the threads on which the host calls the library. level: DM_LOG_*. code: the error, or DM_OK for other messages. text: UTF-8, valid during the call."""

    user: Any
    message: Any
    _fields_ = [
        ("user", c.c_void_p),
        ("message", c.CFUNCTYPE(None, c.c_void_p, c.c_int32, c.c_int32, c.c_char_p)),
    ]


class Jobs(Struct):
    """The host's job system. parallel_for runs task(data, i) once for every i in [0, count) and returns non-zero when all are done. It may return 0 without having run any, and the library then runs them itself. When a task was left out, made up or run twice, the call answers INVALID_ARGUMENT; a second run of a task does nothing. The library starts no thread of its own."""

    user: Any
    parallel_for: Any
    _fields_ = [
        ("user", c.c_void_p),
        ("parallel_for", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint32, c.CFUNCTYPE(None, c.c_void_p, c.c_uint32), c.c_void_p)),
    ]


class ContextDesc(Sized):
    struct_size: int
    axes: int
    unit_in_metres: float
    custom_axes: Any
    allocator: Allocator
    log: Log
    jobs: Jobs
    picking: int
    reserved: int
    progress: Any
    progress_user: Any
    kept_bytes: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("axes", c.c_int32),
        ("unit_in_metres", c.c_float),
        ("custom_axes", c.c_float * 9),
        ("allocator", Allocator),
        ("log", Log),
        ("jobs", Jobs),
        ("picking", c.c_int32),
        ("reserved", c.c_uint32),
        ("progress", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_float)),
        ("progress_user", c.c_void_p),
        ("kept_bytes", c.c_uint64),
    ]


class MemoryInfo(Sized):
    struct_size: int
    reserved: int
    bytes: int
    peak_bytes: int
    allocations: int
    pick_bytes: int
    kept_bytes: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("reserved", c.c_uint32),
        ("bytes", c.c_uint64),
        ("peak_bytes", c.c_uint64),
        ("allocations", c.c_uint64),
        ("pick_bytes", c.c_uint64),
        ("kept_bytes", c.c_uint64),
    ]


class ModelDesc(Sized):
    """Weights, as the bytes of safetensors files. Each may be absent (NULL, 0). The library copies and repacks them, so the host may free them after the call."""

    struct_size: int
    kinematics: Any
    kinematics_size: int
    motion: Any
    motion_size: int
    ranker: Any
    ranker_size: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("kinematics", c.c_void_p),
        ("kinematics_size", c.c_size_t),
        ("motion", c.c_void_p),
        ("motion_size", c.c_size_t),
        ("ranker", c.c_void_p),
        ("ranker_size", c.c_size_t),
    ]


class MeshDesc(Sized):
    """The host's mesh of triangles, which the library reads in place. The sizes of the buffers guard against a forgotten format, scope or stride: the call refuses a buffer that does not hold what counts, formats and strides say, and never reads past its end."""

    struct_size: int
    position_stride: int
    positions: Any
    vertex_count: int
    position_bytes: int
    indices: Any
    index_count: int
    index_bytes: int
    part_ids: Any
    part_id_bytes: int
    part_id_stride: int
    position_format: int
    index_format: int
    part_id_format: int
    part_id_scope: int
    reserved: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("position_stride", c.c_uint32),
        ("positions", c.c_void_p),
        ("vertex_count", c.c_uint64),
        ("position_bytes", c.c_uint64),
        ("indices", c.c_void_p),
        ("index_count", c.c_uint64),
        ("index_bytes", c.c_uint64),
        ("part_ids", c.c_void_p),
        ("part_id_bytes", c.c_uint64),
        ("part_id_stride", c.c_uint32),
        ("position_format", c.c_int32),
        ("index_format", c.c_int32),
        ("part_id_format", c.c_int32),
        ("part_id_scope", c.c_int32),
        ("reserved", c.c_uint32),
    ]


class DragHint(Struct):
    """A drag as evidence of how a part moves: a point on it, and the way in which a hand pulled it."""

    point: Vec3
    vector: Vec3
    _fields_ = [
        ("point", Vec3),
        ("vector", Vec3),
    ]


class Pivot(Struct):
    """The place, at rest, of the node or bone that moves a part. An artist may have put it on the hinge, or left it in the middle or at the file's origin, so it is evidence only. Leave it out, or say DM_PIVOT_DEFAULT, where the nodes of an asset all have their places by one rule: at one point, or at the same place of their boxes. A program has put them there, and the library would take an edge that happens to lie there for a hinge."""

    origin: Vec3
    axes: Any
    _fields_ = [
        ("origin", Vec3),
        ("axes", c.c_float * 9),
    ]


class PartDesc(Sized):
    struct_size: int
    id: int
    parent: int
    joint_type: int
    drag: Any
    label: Any
    pivot: Any
    pivot_kind: int
    reserved: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("id", c.c_uint32),
        ("parent", c.c_uint32),
        ("joint_type", c.c_int32),
        ("drag", c.POINTER(DragHint)),
        ("label", c.c_char_p),
        ("pivot", c.POINTER(Pivot)),
        ("pivot_kind", c.c_int32),
        ("reserved", c.c_uint32),
    ]


class Joint(Sized):
    """How a part moves."""

    struct_size: int
    type: int
    type_confidence: float
    joint_confidence: float
    pitch: float
    axis: Vec3
    origin: Vec3
    lower: float
    upper: float
    source: int
    evidence: Any
    closed: float
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("type", c.c_int32),
        ("type_confidence", c.c_float),
        ("joint_confidence", c.c_float),
        ("pitch", c.c_float),
        ("axis", Vec3),
        ("origin", Vec3),
        ("lower", c.c_float),
        ("upper", c.c_float),
        ("source", c.c_int32),
        ("evidence", c.c_uint32 * 4),
        ("closed", c.c_float),
    ]


class JointFrame(Sized):
    """A joint as the constraint of a physics engine: an orthonormal frame whose x axis is that of the hinge or slider. The y and z axes are arbitrary, but always the same for the same joint. x, y, z and `rotation` have determinant +1 in the host's coordinates."""

    struct_size: int
    type: int
    origin: Vec3
    x: Vec3
    y: Vec3
    z: Vec3
    rotation: Any
    lower: float
    upper: float
    limits: int
    pitch: float
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("type", c.c_int32),
        ("origin", Vec3),
        ("x", Vec3),
        ("y", Vec3),
        ("z", Vec3),
        ("rotation", c.c_float * 4),
        ("lower", c.c_float),
        ("upper", c.c_float),
        ("limits", c.c_uint32),
        ("pitch", c.c_float),
    ]


class PartState(Sized):
    """Where the part of one instance stands, and by which joint it moves. This is all that a host must keep, save, replicate and undo for it. It belongs to the instance, not to the object, because two doors of one object may differ. Save it field by field: type, pitch, axis, origin, limits, source, both confidences, evidence, value."""

    struct_size: int
    value: float
    velocity: float
    status: int
    pose: Pose
    joint: Joint
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("value", c.c_float),
        ("velocity", c.c_float),
        ("status", c.c_uint32),
        ("pose", Pose),
        ("joint", Joint),
    ]


class PartInfo(Sized):
    struct_size: int
    id: int
    parent: int
    triangle_count: int
    box_min: Vec3
    box_max: Vec3
    centre: Vec3
    area: float
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("id", c.c_uint32),
        ("parent", c.c_uint32),
        ("triangle_count", c.c_uint32),
        ("box_min", Vec3),
        ("box_max", Vec3),
        ("centre", Vec3),
        ("area", c.c_float),
    ]


class JointEnd(Struct):
    """Where a hypothesis takes its part at one end of its range, host object frame. Frozen."""

    value: float
    pose: Pose
    box_min: Vec3
    box_max: Vec3
    centre: Vec3
    _fields_ = [
        ("value", c.c_float),
        ("pose", Pose),
        ("box_min", Vec3),
        ("box_max", Vec3),
        ("centre", Vec3),
    ]


class Hypothesis(Sized):
    """A ranked hypothesis and what it would do. struct_size says how much the library has filled."""

    struct_size: int
    reserved: int
    joint: Any
    ends: Any
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("reserved", c.c_uint32),
        ("joint", c.POINTER(Joint)),
        ("ends", JointEnd * 2),
    ]


class Choice(Sized):
    """A part and its hypotheses, for the host to choose from. It is valid during the call only."""

    struct_size: int
    count: int
    part: Any
    hypotheses: Any
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("count", c.c_uint32),
        ("part", c.POINTER(PartInfo)),
        ("hypotheses", c.POINTER(c.POINTER(Hypothesis))),
    ]


class ObjectDesc(Sized):
    struct_size: int
    flags: int
    mesh: Any
    parts: Any
    part_count: int
    reserved: int
    model: int
    seed: int
    intent: Any
    intent_user: Any
    progress: Any
    progress_user: Any
    label: Any
    up: Vec3
    choose: Any
    choose_user: Any
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("flags", c.c_uint32),
        ("mesh", c.POINTER(MeshDesc)),
        ("parts", c.POINTER(PartDesc)),
        ("part_count", c.c_uint32),
        ("reserved", c.c_uint32),
        ("model", c.c_uint64),
        ("seed", c.c_uint64),
        ("intent", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint32, Vec3, Vec3)),
        ("intent_user", c.c_void_p),
        ("progress", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_float)),
        ("progress_user", c.c_void_p),
        ("label", c.c_char_p),
        ("up", Vec3),
        ("choose", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(Choice))),
        ("choose_user", c.c_void_p),
    ]


class ObjectInfo(Sized):
    struct_size: int
    part_count: int
    vertex_count: int
    triangle_count: int
    box_min: Vec3
    box_max: Vec3
    size: float
    pickable: int
    degraded: int
    picking: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("part_count", c.c_uint32),
        ("vertex_count", c.c_uint64),
        ("triangle_count", c.c_uint64),
        ("box_min", Vec3),
        ("box_max", Vec3),
        ("size", c.c_float),
        ("pickable", c.c_uint32),
        ("degraded", c.c_uint32),
        ("picking", c.c_int32),
    ]


class AssetClip(Struct):
    """How one animation moves one node. Frozen."""

    name: Any
    times: Any
    poses: Any
    key_count: int
    flags: int
    _fields_ = [
        ("name", c.c_char_p),
        ("times", c.POINTER(c.c_float)),
        ("poses", c.POINTER(Pose)),
        ("key_count", c.c_uint32),
        ("flags", c.c_uint32),
    ]


class AssetNode(Sized):
    """A node of an asset, as the host has it."""

    struct_size: int
    flags: int
    parent: int
    follows: int
    name: Any
    mesh_name: Any
    mesh: Any
    transform: Any
    pivot: Any
    clips: Any
    clip_count: int
    reserved: int
    joint: Any
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("flags", c.c_uint32),
        ("parent", c.c_uint32),
        ("follows", c.c_uint32),
        ("name", c.c_char_p),
        ("mesh_name", c.c_char_p),
        ("mesh", c.POINTER(MeshDesc)),
        ("transform", c.POINTER(c.c_float)),
        ("pivot", c.POINTER(Pivot)),
        ("clips", c.POINTER(AssetClip)),
        ("clip_count", c.c_uint32),
        ("reserved", c.c_uint32),
        ("joint", c.POINTER(Joint)),
    ]


class AssetDesc(Sized):
    struct_size: int
    flags: int
    nodes: Any
    label: Any
    node_count: int
    min_moves: float
    model: int
    seed: int
    progress: Any
    progress_user: Any
    up: Vec3
    reserved: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("flags", c.c_uint32),
        ("nodes", c.POINTER(AssetNode)),
        ("label", c.c_char_p),
        ("node_count", c.c_uint32),
        ("min_moves", c.c_float),
        ("model", c.c_uint64),
        ("seed", c.c_uint64),
        ("progress", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_float)),
        ("progress_user", c.c_void_p),
        ("up", Vec3),
        ("reserved", c.c_uint32),
    ]


class AssetInfo(Sized):
    struct_size: int
    node_count: int
    part_count: int
    moving_count: int
    triangle_count: int
    degraded: int
    warnings: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("node_count", c.c_uint32),
        ("part_count", c.c_uint32),
        ("moving_count", c.c_uint32),
        ("triangle_count", c.c_uint64),
        ("degraded", c.c_uint32),
        ("warnings", c.c_uint32),
    ]


class AssetPart(Sized):
    """Nodes that move together, or might."""

    struct_size: int
    parent: int
    part_id: int
    state: int
    basis: int
    moves: float
    node_count: int
    triangle_count: int
    duration: float
    reserved: int
    box_min: Vec3
    box_max: Vec3
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("parent", c.c_uint32),
        ("part_id", c.c_uint32),
        ("state", c.c_int32),
        ("basis", c.c_int32),
        ("moves", c.c_float),
        ("node_count", c.c_uint32),
        ("triangle_count", c.c_uint32),
        ("duration", c.c_float),
        ("reserved", c.c_uint32),
        ("box_min", Vec3),
        ("box_max", Vec3),
    ]


class MotionDesc(Sized):
    """What the player asked for. The network answers with a motion of DM_MOTION_FRAMES poses from rest."""

    struct_size: int
    part_id: int
    drag: DragHint
    path: Any
    path_count: int
    seed: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("part_id", c.c_uint32),
        ("drag", DragHint),
        ("path", c.POINTER(Vec3)),
        ("path_count", c.c_uint32),
        ("seed", c.c_uint32),
    ]


class DragFeel(Struct):
    """How a drag feels. Zeros are the defaults. Stiffness, damping and inertia of a part in the hand matter only through two ratios, which are times: smoothing_time is damping over stiffness, coast_time is inertia over damping."""

    smoothing_time: float
    soft_limit: float
    coast_time: float
    detent: float
    detent_pull: float
    return_time: float
    _fields_ = [
        ("smoothing_time", c.c_float),
        ("soft_limit", c.c_float),
        ("coast_time", c.c_float),
        ("detent", c.c_float),
        ("detent_pull", c.c_float),
        ("return_time", c.c_float),
    ]


class DragRules(Sized):
    """What a part does besides following the hand. Zeros are off, except that thresholds have defaults. \"Range\" is the way from lower to upper limit; where one of them is missing, it is 1 rad or the object's size. docs/feel.md describes each rule."""

    struct_size: int
    flags: int
    snaps: Any
    snap_count: int
    snap_reach: float
    open_share: float
    closed_share: float
    event_time: float
    max_speed: float
    max_acceleration: float
    lock_give: float
    latch_turn: float
    auto_close_share: float
    auto_close_time: float
    close_delay: float
    tip_share: float
    fall_time: float
    restitution: float
    break_distance: float
    drive_speed: float
    reserved: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("flags", c.c_uint32),
        ("snaps", c.POINTER(c.c_float)),
        ("snap_count", c.c_uint32),
        ("snap_reach", c.c_float),
        ("open_share", c.c_float),
        ("closed_share", c.c_float),
        ("event_time", c.c_float),
        ("max_speed", c.c_float),
        ("max_acceleration", c.c_float),
        ("lock_give", c.c_float),
        ("latch_turn", c.c_float),
        ("auto_close_share", c.c_float),
        ("auto_close_time", c.c_float),
        ("close_delay", c.c_float),
        ("tip_share", c.c_float),
        ("fall_time", c.c_float),
        ("restitution", c.c_float),
        ("break_distance", c.c_float),
        ("drive_speed", c.c_float),
        ("reserved", c.c_uint32),
    ]


class Link(Struct):
    """A link between two parts. Frozen."""

    driver: int
    driven: int
    kind: int
    flags: int
    ratio: float
    offset: float
    from_: float
    _fields_ = [
        ("driver", c.c_uint32),
        ("driven", c.c_uint32),
        ("kind", c.c_int32),
        ("flags", c.c_uint32),
        ("ratio", c.c_float),
        ("offset", c.c_float),
        ("from_", c.c_float),
    ]


class DragDesc(Sized):
    struct_size: int
    part_id: int
    object: int
    grab_point: Vec3
    start_value: float
    feel: DragFeel
    flags: int
    limit_give: float
    state: Any
    scale: Vec3
    reserved: int
    rules: Any
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("part_id", c.c_uint32),
        ("object", c.c_uint64),
        ("grab_point", Vec3),
        ("start_value", c.c_float),
        ("feel", DragFeel),
        ("flags", c.c_uint32),
        ("limit_give", c.c_float),
        ("state", c.POINTER(PartState)),
        ("scale", Vec3),
        ("reserved", c.c_uint32),
        ("rules", c.POINTER(DragRules)),
    ]


class Hand(Struct):
    kind: int
    ray: Ray
    point: Vec3
    amount: float
    grab_point: Vec3
    _fields_ = [
        ("kind", c.c_int32),
        ("ray", Ray),
        ("point", Vec3),
        ("amount", c.c_float),
        ("grab_point", Vec3),
    ]


class DragInput(Sized):
    """Everything that one update can read."""

    struct_size: int
    flags: int
    hand: Hand
    second: Hand
    handles: Any
    lower: float
    upper: float
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("flags", c.c_uint32),
        ("hand", Hand),
        ("second", Hand),
        ("handles", c.c_float * 2),
        ("lower", c.c_float),
        ("upper", c.c_float),
    ]


class DragState(Sized):
    struct_size: int
    pose: Pose
    grab_point: Vec3
    value: float
    target: float
    velocity: float
    at_limit: int
    phase: int
    changes: int
    events: int
    detents: int
    impact: float
    status: int
    joint_confidence: float
    joint_basis: int
    open_share: float
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("pose", Pose),
        ("grab_point", Vec3),
        ("value", c.c_float),
        ("target", c.c_float),
        ("velocity", c.c_float),
        ("at_limit", c.c_int32),
        ("phase", c.c_int32),
        ("changes", c.c_uint32),
        ("events", c.c_uint32),
        ("detents", c.c_uint32),
        ("impact", c.c_float),
        ("status", c.c_uint32),
        ("joint_confidence", c.c_float),
        ("joint_basis", c.c_int32),
        ("open_share", c.c_float),
    ]


class ReleaseDesc(Sized):
    struct_size: int
    intent: int
    duration: float
    seed: int
    flags: int
    away_from: Vec3
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("intent", c.c_int32),
        ("duration", c.c_float),
        ("seed", c.c_uint32),
        ("flags", c.c_uint32),
        ("away_from", Vec3),
    ]


class ReleasePlan(Sized):
    struct_size: int
    intent: int
    start_value: float
    end_value: float
    duration: float
    from_network: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("intent", c.c_int32),
        ("start_value", c.c_float),
        ("end_value", c.c_float),
        ("duration", c.c_float),
        ("from_network", c.c_uint32),
    ]


class Camera(Sized):
    struct_size: int
    fov_y: float
    eye: Vec3
    forward: Vec3
    up: Vec3
    viewport_width: float
    viewport_height: float
    ortho_height: float
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("fov_y", c.c_float),
        ("eye", Vec3),
        ("forward", Vec3),
        ("up", Vec3),
        ("viewport_width", c.c_float),
        ("viewport_height", c.c_float),
        ("ortho_height", c.c_float),
    ]


class SceneDesc(Sized):
    struct_size: int
    reserved: int
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("reserved", c.c_uint32),
    ]


class Hit(Sized):
    struct_size: int
    instance: int
    object: int
    part_id: int
    triangle: int
    distance: float
    u: float
    v: float
    point: Vec3
    normal: Vec3
    object_point: Vec3
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("instance", c.c_uint32),
        ("object", c.c_uint64),
        ("part_id", c.c_uint32),
        ("triangle", c.c_uint32),
        ("distance", c.c_float),
        ("u", c.c_float),
        ("v", c.c_float),
        ("point", Vec3),
        ("normal", Vec3),
        ("object_point", Vec3),
    ]


class Core1(Sized):
    struct_size: int
    reserved: int
    result_string: Any
    version: Any
    context_create: Any
    context_destroy: Any
    context_get_memory: Any
    model_load: Any
    model_unload: Any
    mesh_find_part: Any
    object_prepare: Any
    object_save: Any
    object_load: Any
    object_destroy: Any
    object_get_info: Any
    object_get_part: Any
    object_get_joint: Any
    object_get_hypotheses: Any
    object_refine: Any
    object_set_joint: Any
    object_reset_joint: Any
    joint_pose: Any
    joint_value: Any
    joint_get_frame: Any
    joint_scale: Any
    motion_generate: Any
    motion_sample: Any
    motion_get_frames: Any
    motion_destroy: Any
    drag_begin: Any
    drag_update: Any
    drag_release: Any
    drag_end: Any
    drag_get_part_state: Any
    drag_snapshot_size: Any
    drag_save: Any
    drag_restore: Any
    pose_multiply: Any
    pose_to_matrix: Any
    pose_apply_points: Any
    camera_ray: Any
    scene_create: Any
    scene_destroy: Any
    scene_add: Any
    scene_move: Any
    scene_remove: Any
    scene_commit: Any
    scene_pick: Any
    drag_step: Any
    drag_take: Any
    object_set_links: Any
    object_follow_links: Any
    joint_value_at: Any
    pose_inverse: Any
    pose_from_rotation: Any
    asset_create: Any
    asset_destroy: Any
    asset_get_info: Any
    asset_get_part: Any
    asset_get_joint: Any
    asset_get_part_nodes: Any
    asset_get_node_parts: Any
    asset_make_object: Any
    context_trim: Any
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("reserved", c.c_uint32),
        ("result_string", c.CFUNCTYPE(c.c_char_p, c.c_int32)),
        ("version", c.CFUNCTYPE(c.c_uint32)),
        ("context_create", c.CFUNCTYPE(c.c_int32, c.POINTER(ContextDesc), c.POINTER(c.c_void_p))),
        ("context_destroy", c.CFUNCTYPE(None, c.c_void_p)),
        ("context_get_memory", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(MemoryInfo))),
        ("model_load", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(ModelDesc), c.POINTER(c.c_uint64))),
        ("model_unload", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64)),
        ("mesh_find_part", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(MeshDesc), c.POINTER(DragHint), c.POINTER(c.c_uint8), c.c_uint64)),
        ("object_prepare", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(ObjectDesc), c.POINTER(c.c_uint64))),
        ("object_save", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_void_p, c.c_size_t, c.POINTER(c.c_size_t))),
        ("object_load", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_void_p, c.c_size_t, c.c_uint64, c.POINTER(c.c_uint64))),
        ("object_destroy", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64)),
        ("object_get_info", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(ObjectInfo))),
        ("object_get_part", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(PartInfo))),
        ("object_get_joint", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(Joint))),
        ("object_get_hypotheses", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(DragHint), c.POINTER(Joint), c.c_uint32, c.POINTER(c.c_uint32))),
        ("object_refine", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(DragHint))),
        ("object_set_joint", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(Joint))),
        ("object_reset_joint", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32)),
        ("joint_pose", c.CFUNCTYPE(c.c_int32, c.POINTER(Joint), c.c_float, c.POINTER(Pose))),
        ("joint_value", c.CFUNCTYPE(c.c_int32, c.POINTER(Joint), c.POINTER(Pose), c.POINTER(c.c_float), c.POINTER(c.c_float), c.POINTER(c.c_float))),
        ("joint_get_frame", c.CFUNCTYPE(c.c_int32, c.POINTER(Joint), c.POINTER(JointFrame))),
        ("joint_scale", c.CFUNCTYPE(c.c_int32, c.POINTER(Joint), Vec3, c.POINTER(Joint))),
        ("motion_generate", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(MotionDesc), c.POINTER(c.c_uint64))),
        ("motion_sample", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_float, c.POINTER(Pose), c.POINTER(c.c_float))),
        ("motion_get_frames", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(Pose), c.POINTER(c.c_float))),
        ("motion_destroy", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64)),
        ("drag_begin", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(DragDesc), c.POINTER(c.c_uint64))),
        ("drag_update", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(Ray), c.c_float, c.POINTER(DragState))),
        ("drag_release", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(ReleaseDesc), c.POINTER(ReleasePlan))),
        ("drag_end", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(PartState))),
        ("drag_get_part_state", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(PartState))),
        ("drag_snapshot_size", c.CFUNCTYPE(c.c_size_t)),
        ("drag_save", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_void_p, c.c_size_t)),
        ("drag_restore", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_void_p, c.c_size_t)),
        ("pose_multiply", c.CFUNCTYPE(None, c.POINTER(Pose), c.POINTER(Pose), c.POINTER(Pose))),
        ("pose_to_matrix", c.CFUNCTYPE(None, c.POINTER(Pose), c.c_void_p)),
        ("pose_apply_points", c.CFUNCTYPE(None, c.POINTER(Pose), c.POINTER(c.c_float), c.c_size_t, c.POINTER(c.c_float), c.c_size_t, c.c_size_t)),
        ("camera_ray", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(Camera), c.c_float, c.c_float, c.POINTER(Ray))),
        ("scene_create", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(SceneDesc), c.POINTER(c.c_uint64))),
        ("scene_destroy", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64)),
        ("scene_add", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint64, c.POINTER(Pose), c.POINTER(c.c_uint32))),
        ("scene_move", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.c_uint32, c.POINTER(Pose))),
        ("scene_remove", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32)),
        ("scene_commit", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64)),
        ("scene_pick", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(Ray), c.POINTER(Hit))),
        ("drag_step", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(DragInput), c.c_float, c.POINTER(DragState))),
        ("drag_take", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_float, c.POINTER(DragState))),
        ("object_set_links", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(Link), c.c_uint32)),
        ("object_follow_links", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(c.c_float), c.POINTER(c.c_uint8), c.c_uint32)),
        ("joint_value_at", c.CFUNCTYPE(c.c_int32, c.POINTER(Joint), c.c_float, c.POINTER(c.c_float))),
        ("pose_inverse", c.CFUNCTYPE(None, c.POINTER(Pose), c.POINTER(Pose))),
        ("pose_from_rotation", c.CFUNCTYPE(c.c_int32, c.c_void_p, Vec3, c.POINTER(Pose))),
        ("asset_create", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.POINTER(AssetDesc), c.POINTER(c.c_uint64))),
        ("asset_destroy", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64)),
        ("asset_get_info", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(AssetInfo))),
        ("asset_get_part", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(AssetPart))),
        ("asset_get_joint", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(Joint))),
        ("asset_get_part_nodes", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(c.c_uint32), c.c_uint32)),
        ("asset_get_node_parts", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(c.c_uint32), c.c_uint32)),
        ("asset_make_object", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_uint64, c.POINTER(c.c_uint64))),
        ("context_trim", c.CFUNCTYPE(c.c_int32, c.c_void_p)),
    ]


class GltfFiles(Struct):
    """Gives access to files beside a .gltf: to buffers when it is opened, to images when it is exported or a surface is asked for."""

    user: Any
    open: Any
    close: Any
    _fields_ = [
        ("user", c.c_void_p),
        ("open", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_char_p, c.POINTER(c.c_void_p), c.POINTER(c.c_size_t))),
        ("close", c.CFUNCTYPE(None, c.c_void_p, c.c_void_p, c.c_size_t)),
    ]


class GltfDesc(Sized):
    struct_size: int
    reserved: int
    data: Any
    size: int
    allocator: Allocator
    log: Log
    files: GltfFiles
    progress: Any
    progress_user: Any
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("reserved", c.c_uint32),
        ("data", c.c_void_p),
        ("size", c.c_size_t),
        ("allocator", Allocator),
        ("log", Log),
        ("files", GltfFiles),
        ("progress", c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_float)),
        ("progress_user", c.c_void_p),
    ]


class GltfNode(Struct):
    """What moves as one: a node that has a mesh, or a bone of a skin with the triangles that go with it. Vertices and faces are those of the merged mesh. The merged mesh holds the nodes with meshes in file order (the order of the nodes array), and the primitives of a node in order. Its vertices are in the scene's frame less dm_gltf_get_origin, with node transforms applied. Primitives of a node that share an accessor share its vertices. A node with a skin is stored bone by bone, as its bones stand in the file; a vertex goes with its heaviest bone."""

    name: Any
    node: int
    carrier: int
    first_vertex: int
    vertex_count: int
    first_face: int
    face_count: int
    colour: Any
    _fields_ = [
        ("name", c.c_char_p),
        ("node", c.c_uint32),
        ("carrier", c.c_uint32),
        ("first_vertex", c.c_uint64),
        ("vertex_count", c.c_uint64),
        ("first_face", c.c_uint64),
        ("face_count", c.c_uint64),
        ("colour", c.c_float * 4),
    ]


class GltfSurface(Struct):
    """Faces of the merged mesh that lie side by side and have one material. A dm_gltf_node has one or more surfaces."""

    first_face: int
    face_count: int
    colour: Any
    image: Any
    image_size: int
    wrap_u: int
    wrap_v: int
    _fields_ = [
        ("first_face", c.c_uint64),
        ("face_count", c.c_uint64),
        ("colour", c.c_float * 4),
        ("image", c.c_void_p),
        ("image_size", c.c_size_t),
        ("wrap_u", c.c_int32),
        ("wrap_v", c.c_int32),
    ]


class GltfTrack(Struct):
    """One animated part: the faces it takes and its key poses (host frame = the file's scene frame, from rest)."""

    name: Any
    face_ids: Any
    value: int
    reserved: Any
    poses: Any
    times: Any
    key_count: int
    reserved2: int
    _fields_ = [
        ("name", c.c_char_p),
        ("face_ids", c.POINTER(c.c_uint8)),
        ("value", c.c_uint8),
        ("reserved", c.c_uint8 * 7),
        ("poses", c.POINTER(Pose)),
        ("times", c.POINTER(c.c_float)),
        ("key_count", c.c_uint32),
        ("reserved2", c.c_uint32),
    ]


class GltfPart(Struct):
    """A mesh to write as one node of a new .glb."""

    name: Any
    positions: Any
    indices: Any
    vertex_count: int
    index_count: int
    colour: Any
    _fields_ = [
        ("name", c.c_char_p),
        ("positions", c.POINTER(c.c_float)),
        ("indices", c.POINTER(c.c_uint32)),
        ("vertex_count", c.c_uint64),
        ("index_count", c.c_uint64),
        ("colour", c.c_float * 4),
    ]


class GltfRigDesc(Sized):
    """The input and the answers of dm_asset_create. Everything is borrowed for the call."""

    struct_size: int
    formats: int
    nodes: Any
    parts: Any
    joints: Any
    node_parts: Any
    colours: Any
    name: Any
    part_names: Any
    gltf: Any
    node_count: int
    part_count: int
    axes: int
    unit_in_metres: float
    density: float
    thickness: float
    friction: float
    damping_time: float
    allocator: Allocator
    log: Log
    _fields_ = [
        ("struct_size", c.c_uint32),
        ("formats", c.c_uint32),
        ("nodes", c.POINTER(AssetNode)),
        ("parts", c.POINTER(AssetPart)),
        ("joints", c.POINTER(Joint)),
        ("node_parts", c.POINTER(c.c_uint32)),
        ("colours", c.POINTER(c.c_float)),
        ("name", c.c_char_p),
        ("part_names", c.POINTER(c.c_char_p)),
        ("gltf", c.c_void_p),
        ("node_count", c.c_uint32),
        ("part_count", c.c_uint32),
        ("axes", c.c_int32),
        ("unit_in_metres", c.c_float),
        ("density", c.c_float),
        ("thickness", c.c_float),
        ("friction", c.c_float),
        ("damping_time", c.c_float),
        ("allocator", Allocator),
        ("log", Log),
    ]


class GltfRigFile(Struct):
    path: Any
    data: Any
    size: int
    _fields_ = [
        ("path", c.c_char_p),
        ("data", c.c_void_p),
        ("size", c.c_size_t),
    ]


FUNCTIONS = {  # name: (result, arguments)
    "dm_result_string": (c.c_char_p, [c.c_int32]),
    "dm_version": (c.c_uint32, []),
    "dm_get_interface": (c.c_void_p, [c.c_char_p]),
    "dm_context_create": (c.c_int32, [c.POINTER(ContextDesc), c.POINTER(c.c_void_p)]),
    "dm_context_destroy": (None, [c.c_void_p]),
    "dm_context_get_memory": (c.c_int32, [c.c_void_p, c.POINTER(MemoryInfo)]),
    "dm_context_trim": (c.c_int32, [c.c_void_p]),
    "dm_model_load": (c.c_int32, [c.c_void_p, c.POINTER(ModelDesc), c.POINTER(c.c_uint64)]),
    "dm_model_unload": (c.c_int32, [c.c_void_p, c.c_uint64]),
    "dm_mesh_find_part": (c.c_int32, [c.c_void_p, c.POINTER(MeshDesc), c.POINTER(DragHint), c.POINTER(c.c_uint8), c.c_uint64]),
    "dm_object_prepare": (c.c_int32, [c.c_void_p, c.POINTER(ObjectDesc), c.POINTER(c.c_uint64)]),
    "dm_object_save": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_void_p, c.c_size_t, c.POINTER(c.c_size_t)]),
    "dm_object_load": (c.c_int32, [c.c_void_p, c.c_void_p, c.c_size_t, c.c_uint64, c.POINTER(c.c_uint64)]),
    "dm_object_destroy": (c.c_int32, [c.c_void_p, c.c_uint64]),
    "dm_object_get_info": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(ObjectInfo)]),
    "dm_object_get_part": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(PartInfo)]),
    "dm_object_get_joint": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(Joint)]),
    "dm_object_get_hypotheses": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(DragHint), c.POINTER(Joint), c.c_uint32, c.POINTER(c.c_uint32)]),
    "dm_object_refine": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(DragHint)]),
    "dm_object_set_joint": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(Joint)]),
    "dm_object_reset_joint": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32]),
    "dm_object_set_links": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(Link), c.c_uint32]),
    "dm_object_follow_links": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(c.c_float), c.POINTER(c.c_uint8), c.c_uint32]),
    "dm_asset_create": (c.c_int32, [c.c_void_p, c.POINTER(AssetDesc), c.POINTER(c.c_uint64)]),
    "dm_asset_destroy": (c.c_int32, [c.c_void_p, c.c_uint64]),
    "dm_asset_get_info": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(AssetInfo)]),
    "dm_asset_get_part": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(AssetPart)]),
    "dm_asset_get_joint": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(Joint)]),
    "dm_asset_get_part_nodes": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.POINTER(c.c_uint32), c.c_uint32]),
    "dm_asset_get_node_parts": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(c.c_uint32), c.c_uint32]),
    "dm_asset_make_object": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(c.c_uint64)]),
    "dm_joint_pose": (c.c_int32, [c.POINTER(Joint), c.c_float, c.POINTER(Pose)]),
    "dm_joint_value": (c.c_int32, [c.POINTER(Joint), c.POINTER(Pose), c.POINTER(c.c_float), c.POINTER(c.c_float), c.POINTER(c.c_float)]),
    "dm_joint_value_at": (c.c_int32, [c.POINTER(Joint), c.c_float, c.POINTER(c.c_float)]),
    "dm_joint_get_frame": (c.c_int32, [c.POINTER(Joint), c.POINTER(JointFrame)]),
    "dm_joint_scale": (c.c_int32, [c.POINTER(Joint), Vec3, c.POINTER(Joint)]),
    "dm_motion_generate": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(MotionDesc), c.POINTER(c.c_uint64)]),
    "dm_motion_sample": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_float, c.POINTER(Pose), c.POINTER(c.c_float)]),
    "dm_motion_get_frames": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(Pose), c.POINTER(c.c_float)]),
    "dm_motion_destroy": (c.c_int32, [c.c_void_p, c.c_uint64]),
    "dm_drag_begin": (c.c_int32, [c.c_void_p, c.POINTER(DragDesc), c.POINTER(c.c_uint64)]),
    "dm_drag_update": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(Ray), c.c_float, c.POINTER(DragState)]),
    "dm_drag_step": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(DragInput), c.c_float, c.POINTER(DragState)]),
    "dm_drag_take": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_float, c.POINTER(DragState)]),
    "dm_drag_release": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(ReleaseDesc), c.POINTER(ReleasePlan)]),
    "dm_drag_end": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(PartState)]),
    "dm_drag_get_part_state": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(PartState)]),
    "dm_drag_snapshot_size": (c.c_size_t, []),
    "dm_drag_save": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_void_p, c.c_size_t]),
    "dm_drag_restore": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_void_p, c.c_size_t]),
    "dm_pose_multiply": (None, [c.POINTER(Pose), c.POINTER(Pose), c.POINTER(Pose)]),
    "dm_pose_inverse": (None, [c.POINTER(Pose), c.POINTER(Pose)]),
    "dm_pose_from_rotation": (c.c_int32, [c.c_void_p, Vec3, c.POINTER(Pose)]),
    "dm_pose_to_matrix": (None, [c.POINTER(Pose), c.c_void_p]),
    "dm_pose_apply_points": (None, [c.POINTER(Pose), c.POINTER(c.c_float), c.c_size_t, c.POINTER(c.c_float), c.c_size_t, c.c_size_t]),
    "dm_camera_ray": (c.c_int32, [c.c_void_p, c.POINTER(Camera), c.c_float, c.c_float, c.POINTER(Ray)]),
    "dm_scene_create": (c.c_int32, [c.c_void_p, c.POINTER(SceneDesc), c.POINTER(c.c_uint64)]),
    "dm_scene_destroy": (c.c_int32, [c.c_void_p, c.c_uint64]),
    "dm_scene_add": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint64, c.POINTER(Pose), c.POINTER(c.c_uint32)]),
    "dm_scene_move": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32, c.c_uint32, c.POINTER(Pose)]),
    "dm_scene_remove": (c.c_int32, [c.c_void_p, c.c_uint64, c.c_uint32]),
    "dm_scene_commit": (c.c_int32, [c.c_void_p, c.c_uint64]),
    "dm_scene_pick": (c.c_int32, [c.c_void_p, c.c_uint64, c.POINTER(Ray), c.POINTER(Hit)]),
}

GLTF_FUNCTIONS = {  # name: (result, arguments)
    "dm_gltf_version": (c.c_uint32, []),
    "dm_gltf_open": (c.c_int32, [c.POINTER(GltfDesc), c.POINTER(c.c_void_p)]),
    "dm_gltf_open_file": (c.c_int32, [c.c_char_p, c.POINTER(GltfDesc), c.POINTER(c.c_void_p)]),
    "dm_gltf_close": (None, [c.c_void_p]),
    "dm_gltf_node_count": (c.c_uint32, [c.c_void_p]),
    "dm_gltf_get_node": (c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(GltfNode)]),
    "dm_gltf_get_mesh": (c.c_int32, [c.c_void_p, c.POINTER(MeshDesc)]),
    "dm_gltf_get_origin": (None, [c.c_void_p, c.c_void_p]),
    "dm_gltf_surface_count": (c.c_uint32, [c.c_void_p]),
    "dm_gltf_get_surface": (c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(GltfSurface)]),
    "dm_gltf_get_texture_coordinates": (c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(c.c_float), c.c_uint64]),
    "dm_gltf_mark_faces": (c.c_int32, [c.c_void_p, c.POINTER(c.c_char_p), c.c_uint32, c.c_uint8, c.POINTER(c.c_uint8), c.c_uint64]),
    "dm_gltf_get_hints": (c.c_int32, [c.c_void_p, c.c_char_p, c.c_char_p, c.c_size_t, c.POINTER(Pivot)]),
    "dm_gltf_get_asset": (c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(c.POINTER(AssetNode)), c.POINTER(c.c_uint32)]),
    "dm_gltf_get_asset_node": (c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(c.c_uint32)]),
    "dm_gltf_pivots_are_lost": (c.c_int32, [c.c_void_p]),
    "dm_gltf_get_pivot_kind": (c.c_int32, [c.c_void_p, c.c_char_p, c.POINTER(c.c_int32)]),
    "dm_gltf_left_out": (c.c_int32, [c.c_void_p]),
    "dm_gltf_read_mask": (c.c_int32, [c.c_void_p, c.c_void_p, c.c_size_t, c.POINTER(c.c_int64), c.POINTER(c.c_uint8), c.POINTER(c.c_int32), c.POINTER(c.c_int32)]),
    "dm_gltf_export": (c.c_int32, [c.c_void_p, c.POINTER(GltfTrack), c.c_uint32, c.POINTER(c.c_void_p), c.POINTER(c.c_size_t)]),
    "dm_gltf_release_bytes": (None, [c.c_void_p, c.c_void_p, c.c_size_t]),
    "dm_gltf_write": (c.c_int32, [c.POINTER(GltfPart), c.c_uint32, c.POINTER(Allocator), c.POINTER(Log), c.POINTER(c.c_void_p), c.POINTER(c.c_size_t)]),
    "dm_gltf_mend_text": (c.c_size_t, [c.c_char_p]),
    "dm_gltf_rig_make": (c.c_int32, [c.POINTER(GltfRigDesc), c.POINTER(c.c_void_p)]),
    "dm_gltf_rig_destroy": (None, [c.c_void_p]),
    "dm_gltf_rig_file_count": (c.c_uint32, [c.c_void_p]),
    "dm_gltf_rig_get_file": (c.c_int32, [c.c_void_p, c.c_uint32, c.POINTER(GltfRigFile)]),
}

ALIASES = {  # another name of a function
    "dm_drag_update_input": "dm_drag_step",
    "dm_drag_override": "dm_drag_take",
}

LAYOUTS = {  # struct: {bytes of a pointer: (size, offsets)}
    Vec3: {8: (12, [0, 4, 8]), 4: (12, [0, 4, 8])},
    Pose: {8: (32, [0, 16]), 4: (32, [0, 16])},
    Ray: {8: (24, [0, 12]), 4: (24, [0, 12])},
    Allocator: {8: (24, [0, 8, 16]), 4: (12, [0, 4, 8])},
    Log: {8: (16, [0, 8]), 4: (8, [0, 4])},
    Jobs: {8: (16, [0, 8]), 4: (8, [0, 4])},
    ContextDesc: {8: (136, [0, 4, 8, 12, 48, 72, 88, 104, 108, 112, 120, 128]), 4: (104, [0, 4, 8, 12, 48, 60, 68, 76, 80, 84, 88, 96])},
    MemoryInfo: {8: (48, [0, 4, 8, 16, 24, 32, 40]), 4: (48, [0, 4, 8, 16, 24, 32, 40])},
    ModelDesc: {8: (56, [0, 8, 16, 24, 32, 40, 48]), 4: (28, [0, 4, 8, 12, 16, 20, 24])},
    MeshDesc: {8: (96, [0, 4, 8, 16, 24, 32, 40, 48, 56, 64, 72, 76, 80, 84, 88, 92]), 4: (96, [0, 4, 8, 16, 24, 32, 40, 48, 56, 64, 72, 76, 80, 84, 88, 92])},
    DragHint: {8: (24, [0, 12]), 4: (24, [0, 12])},
    Pivot: {8: (48, [0, 12]), 4: (48, [0, 12])},
    PartDesc: {8: (48, [0, 4, 8, 12, 16, 24, 32, 40, 44]), 4: (36, [0, 4, 8, 12, 16, 20, 24, 28, 32])},
    Joint: {8: (76, [0, 4, 8, 12, 16, 20, 32, 44, 48, 52, 56, 72]), 4: (76, [0, 4, 8, 12, 16, 20, 32, 44, 48, 52, 56, 72])},
    JointFrame: {8: (88, [0, 4, 8, 20, 32, 44, 56, 72, 76, 80, 84]), 4: (88, [0, 4, 8, 20, 32, 44, 56, 72, 76, 80, 84])},
    PartState: {8: (124, [0, 4, 8, 12, 16, 48]), 4: (124, [0, 4, 8, 12, 16, 48])},
    PartInfo: {8: (56, [0, 4, 8, 12, 16, 28, 40, 52]), 4: (56, [0, 4, 8, 12, 16, 28, 40, 52])},
    JointEnd: {8: (72, [0, 4, 36, 48, 60]), 4: (72, [0, 4, 36, 48, 60])},
    Hypothesis: {8: (160, [0, 4, 8, 16]), 4: (156, [0, 4, 8, 12])},
    Choice: {8: (24, [0, 4, 8, 16]), 4: (16, [0, 4, 8, 12])},
    ObjectDesc: {8: (120, [0, 4, 8, 16, 24, 28, 32, 40, 48, 56, 64, 72, 80, 88, 104, 112]), 4: (80, [0, 4, 8, 12, 16, 20, 24, 32, 40, 44, 48, 52, 56, 60, 72, 76])},
    ObjectInfo: {8: (64, [0, 4, 8, 16, 24, 36, 48, 52, 56, 60]), 4: (64, [0, 4, 8, 16, 24, 36, 48, 52, 56, 60])},
    AssetClip: {8: (32, [0, 8, 16, 24, 28]), 4: (20, [0, 4, 8, 12, 16])},
    AssetNode: {8: (80, [0, 4, 8, 12, 16, 24, 32, 40, 48, 56, 64, 68, 72]), 4: (52, [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48])},
    AssetDesc: {8: (80, [0, 4, 8, 16, 24, 28, 32, 40, 48, 56, 64, 76]), 4: (64, [0, 4, 8, 12, 16, 20, 24, 32, 40, 44, 48, 60])},
    AssetInfo: {8: (32, [0, 4, 8, 12, 16, 24, 28]), 4: (32, [0, 4, 8, 12, 16, 24, 28])},
    AssetPart: {8: (64, [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 52]), 4: (64, [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 52])},
    MotionDesc: {8: (48, [0, 4, 8, 32, 40, 44]), 4: (44, [0, 4, 8, 32, 36, 40])},
    DragFeel: {8: (24, [0, 4, 8, 12, 16, 20]), 4: (24, [0, 4, 8, 12, 16, 20])},
    DragRules: {8: (88, [0, 4, 8, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72, 76, 80, 84]), 4: (84, [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72, 76, 80])},
    Link: {8: (28, [0, 4, 8, 12, 16, 20, 24]), 4: (28, [0, 4, 8, 12, 16, 20, 24])},
    DragDesc: {8: (96, [0, 4, 8, 16, 28, 32, 56, 60, 64, 72, 84, 88]), 4: (88, [0, 4, 8, 16, 28, 32, 56, 60, 64, 68, 80, 84])},
    Hand: {8: (56, [0, 4, 28, 40, 44]), 4: (56, [0, 4, 28, 40, 44])},
    DragInput: {8: (136, [0, 4, 8, 64, 120, 128, 132]), 4: (136, [0, 4, 8, 64, 120, 128, 132])},
    DragState: {8: (100, [0, 4, 36, 48, 52, 56, 60, 64, 68, 72, 76, 80, 84, 88, 92, 96]), 4: (100, [0, 4, 36, 48, 52, 56, 60, 64, 68, 72, 76, 80, 84, 88, 92, 96])},
    ReleaseDesc: {8: (32, [0, 4, 8, 12, 16, 20]), 4: (32, [0, 4, 8, 12, 16, 20])},
    ReleasePlan: {8: (24, [0, 4, 8, 12, 16, 20]), 4: (24, [0, 4, 8, 12, 16, 20])},
    Camera: {8: (56, [0, 4, 8, 20, 32, 44, 48, 52]), 4: (56, [0, 4, 8, 20, 32, 44, 48, 52])},
    SceneDesc: {8: (8, [0, 4]), 4: (8, [0, 4])},
    Hit: {8: (72, [0, 4, 8, 16, 20, 24, 28, 32, 36, 48, 60]), 4: (72, [0, 4, 8, 16, 20, 24, 28, 32, 36, 48, 60])},
    Core1: {8: (504, [0, 4, 8, 16, 24, 32, 40, 48, 56, 64, 72, 80, 88, 96, 104, 112, 120, 128, 136, 144, 152, 160, 168, 176, 184, 192, 200, 208, 216, 224, 232, 240, 248, 256, 264, 272, 280, 288, 296, 304, 312, 320, 328, 336, 344, 352, 360, 368, 376, 384, 392, 400, 408, 416, 424, 432, 440, 448, 456, 464, 472, 480, 488, 496]), 4: (256, [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72, 76, 80, 84, 88, 92, 96, 100, 104, 108, 112, 116, 120, 124, 128, 132, 136, 140, 144, 148, 152, 156, 160, 164, 168, 172, 176, 180, 184, 188, 192, 196, 200, 204, 208, 212, 216, 220, 224, 228, 232, 236, 240, 244, 248, 252])},
    GltfFiles: {8: (24, [0, 8, 16]), 4: (12, [0, 4, 8])},
    GltfDesc: {8: (104, [0, 4, 8, 16, 24, 48, 64, 88, 96]), 4: (56, [0, 4, 8, 12, 16, 28, 36, 48, 52])},
    GltfNode: {8: (64, [0, 8, 12, 16, 24, 32, 40, 48]), 4: (64, [0, 4, 8, 16, 24, 32, 40, 48])},
    GltfSurface: {8: (56, [0, 8, 16, 32, 40, 48, 52]), 4: (48, [0, 8, 16, 32, 36, 40, 44])},
    GltfTrack: {8: (48, [0, 8, 16, 17, 24, 32, 40, 44]), 4: (32, [0, 4, 8, 9, 16, 20, 24, 28])},
    GltfPart: {8: (56, [0, 8, 16, 24, 32, 40]), 4: (48, [0, 4, 8, 16, 24, 32])},
    GltfRigDesc: {8: (144, [0, 4, 8, 16, 24, 32, 40, 48, 56, 64, 72, 76, 80, 84, 88, 92, 96, 100, 104, 128]), 4: (92, [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72, 84])},
    GltfRigFile: {8: (24, [0, 8, 16]), 4: (12, [0, 4, 8])},
}
