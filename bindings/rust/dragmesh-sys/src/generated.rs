// The C interface of dragmesh. Written by scripts/describe from the public headers: not to be edited.
use std::os::raw::{c_char, c_void};

pub const DM_VERSION_MAJOR: i32 = 0;
pub const DM_VERSION_MINOR: i32 = 4;
pub const DM_VERSION_PATCH: i32 = 0;
/// It is 1 while the version that the three numbers name is in development, and 0 in its release.
pub const DM_VERSION_DEVELOPMENT: i32 = 1;
/// Number of key poses of a generated motion (paper: T).
pub const DM_MOTION_FRAMES: i32 = 16;
/// Most hypotheses kept for one part.
pub const DM_MAX_HYPOTHESES: i32 = 8;
/// Most parts of one object, without the body.
pub const DM_MAX_PARTS: i32 = 4096;
/// Most nodes of one asset. At most DM\_MAX\_PARTS of them may have a mesh and not the flag DM\_ASSET\_NODE\_FOLLOWS.
pub const DM_MAX_ASSET_NODES: i32 = 65536;
/// Most bytes of a label, without the terminating zero.
pub const DM_MAX_LABEL: i32 = 4096;
/// Most vertices or triangles of one object.
pub const DM_MAX_ELEMENTS: i32 = 268435456;
/// Most links of one object.
pub const DM_MAX_LINKS: i32 = 256;
/// Most snap values of one drag.
pub const DM_MAX_SNAPS: i32 = 16;
/// Most bytes of a dm\_drag\_save in any library of the interface dm.core/1. dm\_drag\_snapshot\_size returns how many this one writes.
pub const DM_DRAG_SNAPSHOT_MAX: i32 = 65536;
/// no node: the scene itself
pub const DM_ASSET_NO_NODE: u32 = 4294967295;
/// no part: the body that stays
pub const DM_ASSET_NO_PART: u32 = 4294967295;
pub const DM_GLTF_NO_CARRIER: u32 = 4294967295;
pub const DM_OK: i32 = 0;
/// a null pointer, an unknown enum value, a count that makes no sense
pub const DM_ERROR_INVALID_ARGUMENT: i32 = -1;
/// struct\_size is too small, or a field is set that this library does not know
pub const DM_ERROR_STRUCT_SIZE: i32 = -2;
/// null, destroyed, or of another kind or context
pub const DM_ERROR_STALE_HANDLE: i32 = -3;
/// the host's allocator returned NULL
pub const DM_ERROR_OUT_OF_MEMORY: i32 = -4;
/// a NaN or infinite number in the input
pub const DM_ERROR_NOT_FINITE: i32 = -5;
/// an index names a vertex or a hypothesis that does not exist
pub const DM_ERROR_INDEX_OUT_OF_RANGE: i32 = -6;
/// no triangle belongs to the part
pub const DM_ERROR_EMPTY_MASK: i32 = -7;
/// the mask, or the part found, is the whole mesh, so nothing stays
pub const DM_ERROR_FULL_MASK: i32 = -8;
/// no triangle with an area, or all vertices in one point
pub const DM_ERROR_DEGENERATE_MESH: i32 = -9;
/// the drag vector has no length
pub const DM_ERROR_ZERO_DRAG: i32 = -10;
/// the drag point is farther from the part than half the object's size
pub const DM_ERROR_DRAG_OFF_PART: i32 = -11;
/// truncated, corrupt or hostile bytes
pub const DM_ERROR_BAD_DATA: i32 = -12;
/// readable weights, but not of the architecture asked for
pub const DM_ERROR_WRONG_MODEL: i32 = -13;
/// made by a newer version than this library can read
pub const DM_ERROR_VERSION: i32 = -14;
/// the progress callback asked to stop
pub const DM_ERROR_CANCELLED: i32 = -15;
/// the call needs weights and none were given
pub const DM_ERROR_NO_MODEL: i32 = -16;
/// more than DM\_MAX\_ELEMENTS or DM\_MAX\_PARTS
pub const DM_ERROR_TOO_LARGE: i32 = -17;
/// the output buffer cannot hold the answer; the size needed is set
pub const DM_ERROR_BUFFER_TOO_SMALL: i32 = -18;
/// no such part, node or instance
pub const DM_ERROR_NOT_FOUND: i32 = -19;
/// valid, but this build or this kind of file cannot do it
pub const DM_ERROR_UNSUPPORTED: i32 = -20;
/// a bug of ours; please report it
pub const DM_ERROR_INTERNAL: i32 = -21;
pub const DM_LOG_ERROR: i32 = 0;
pub const DM_LOG_WARNING: i32 = 1;
pub const DM_LOG_INFO: i32 = 2;
/// right-handed, +Y up (glTF, Godot, OpenGL)
pub const DM_AXES_GLTF: i32 = 0;
/// left-handed, +Y up, +Z forward
pub const DM_AXES_UNITY: i32 = 1;
/// left-handed, +Z up, +X forward
pub const DM_AXES_UNREAL: i32 = 2;
/// right-handed, +Z up (Blender, ROS, most CAD)
pub const DM_AXES_BLENDER: i32 = 3;
/// those of dm\_context\_desc.custom\_axes
pub const DM_AXES_CUSTOM: i32 = 4;
/// Embree 3.13 or 4 where its shared library is found, else the library's own code
pub const DM_PICK_AUTO: i32 = 0;
/// Embree; the context is refused where it is missing
pub const DM_PICK_EMBREE: i32 = 1;
/// the library's own code, which runs everywhere, in the host's memory
pub const DM_PICK_PORTABLE: i32 = 2;
/// nothing, for hosts that cast their own rays: objects keep no trees, and there are no scenes
pub const DM_PICK_NONE: i32 = 3;
pub const DM_JOINT_UNKNOWN: i32 = 0;
/// turns about a line between two limits, rad
pub const DM_JOINT_REVOLUTE: i32 = 1;
/// slides along a direction, host units
pub const DM_JOINT_PRISMATIC: i32 = 2;
/// turns and advances \`pitch\` host units a radian
pub const DM_JOINT_SCREW: i32 = 3;
/// turns without limits
pub const DM_JOINT_CONTINUOUS: i32 = 4;
pub const DM_JOINT_FIXED: i32 = 5;
/// formats of positions, three numbers each
pub const DM_FLOAT32: i32 = 0;
/// formats of positions, three numbers each
pub const DM_FLOAT64: i32 = 1;
/// formats of indices and part ids
pub const DM_UINT32: i32 = 0;
/// formats of indices and part ids
pub const DM_UINT16: i32 = 1;
/// formats of indices and part ids
pub const DM_UINT8: i32 = 2;
/// formats of indices and part ids
pub const DM_INT32: i32 = 3;
pub const DM_PER_VERTEX: i32 = 0;
pub const DM_PER_FACE: i32 = 1;
/// not known: the library compares it with those of the other parts
pub const DM_PIVOT_UNKNOWN: i32 = 0;
/// a program puts all of them there, so it says nothing
pub const DM_PIVOT_DEFAULT: i32 = 1;
/// The other nodes' pivots follow a rule and this one does not, so somebody has set it. It counts for more.
pub const DM_PIVOT_SET: i32 = 2;
pub const DM_JOINT_FROM_NETWORK: i32 = 0;
pub const DM_JOINT_FROM_GEOMETRY: i32 = 1;
/// the host's own: certain, limits too, and no pull changes it
pub const DM_JOINT_FROM_HOST: i32 = 2;
/// The host has chosen it with dm\_object\_desc.choose. No pull replaces it, or moves its range to the other side of rest. Its limits are estimates, and give.
pub const DM_JOINT_CHOSEN: i32 = 3;
pub const DM_LIMIT_LOWER: i32 = 1;
pub const DM_LIMIT_UPPER: i32 = 2;
pub const DM_CHOICE_KEEP: i32 = -1;
/// The object keeps no triangles. It is small, and cannot be added to a scene.
pub const DM_PREPARE_WITHOUT_PICKING: i32 = 1;
/// KPP-Net alone infers the joints, without geometric candidates and ranker, for comparisons. The call answers NO\_MODEL when \`model\` has no kinematics weights.
pub const DM_PREPARE_NETWORK_ALONE: i32 = 2;
/// The reader of the mesh has left out something of its file (dm\_gltf\_left\_out). The object keeps it as DM\_DEGRADED\_MESH.
pub const DM_PREPARE_MESH_INCOMPLETE: i32 = 4;
/// no weights of KPP-Net: geometry alone finds the joints
pub const DM_DEGRADED_NO_KINEMATICS: i32 = 1;
/// no weights of the ranker: rules choose the joints, and set limits
pub const DM_DEGRADED_NO_RANKER: i32 = 2;
/// no weights of the DQ-VAE: a rule paces releases, and motions answer NO\_MODEL
pub const DM_DEGRADED_NO_MOTION: i32 = 4;
/// the mesh has no body, whose contacts would show the joints
pub const DM_DEGRADED_NO_BODY: i32 = 8;
/// a pivot was ignored, because it is 1,000 object sizes away or more
pub const DM_DEGRADED_HINT: i32 = 16;
/// DM\_PREPARE\_MESH\_INCOMPLETE
pub const DM_DEGRADED_MESH: i32 = 32;
/// The node is neither part nor body: a level of detail, a collider, something hidden. It goes where \`follows\` goes, and its mesh is not read.
pub const DM_ASSET_NODE_FOLLOWS: i32 = 1;
/// the place of its origin says nothing
pub const DM_ASSET_NODE_NO_PIVOT: i32 = 2;
/// the animation also scales or bends the node
pub const DM_CLIP_NOT_RIGID: i32 = 1;
/// clips are ignored
pub const DM_ASSET_WITHOUT_CLIPS: i32 = 256;
/// names and labels are ignored
pub const DM_ASSET_WITHOUT_NAMES: i32 = 512;
/// a clip is not rigid, or no joint moves a node as it does
pub const DM_ASSET_CLIP_LEFT_OUT: i32 = 1;
/// It may move, but probably does not: \`moves\` is below dm\_asset\_desc.min\_moves. A body that almost certainly stays is not listed as a part.
pub const DM_ASSET_STAYS: i32 = 0;
/// it moves by its joint
pub const DM_ASSET_MOVES: i32 = 1;
/// Only its weight holds it, as the lid of a teapot, so a player can take it away. Its joint is the slide by which it comes off, with a low confidence.
pub const DM_ASSET_FREE: i32 = 2;
/// inferred from shape, contacts and names
pub const DM_ASSET_INFERRED: i32 = 0;
/// stated in dm\_asset\_node.joint
pub const DM_ASSET_FROM_FILE: i32 = 1;
/// read from dm\_asset\_node.clips
pub const DM_ASSET_FROM_CLIP: i32 = 2;
/// The drag follows the joint in force with its limits, whatever the pull says, as it follows a host's joint.
pub const DM_DRAG_KEEP_JOINT: i32 = 1;
/// No point is grabbed, for hands of DM\_HAND\_RATE, STEP and VALUE, and for releases. grab\_point is ignored, and the middle of the part's box takes its place.
pub const DM_DRAG_WITHOUT_POINT: i32 = 2;
/// The part stays where it is, gives a little, and reports a try as DM\_EVENT\_LOCKED.
pub const DM_RULE_LOCKED: i32 = 1;
/// A latch holds the part at rest until a handle has turned (dm\_drag\_input.handles), and catches it again when it comes to rest with the handle let go.
pub const DM_RULE_LATCH: i32 = 2;
/// The driven part's value is offset + ratio \* (the driver's value beyond \`from\`), inside its limits.
pub const DM_LINK_MOVES: i32 = 0;
/// the driven part is held until the driver has reached \`from\`: a handle
pub const DM_LINK_FREES: i32 = 1;
/// the driven part is held once the driver has reached \`from\`: one drawer at a time
pub const DM_LINK_HOLDS: i32 = 2;
/// the driven part of a DM\_LINK\_MOVES also moves the driver
pub const DM_LINK_BOTH_WAYS: i32 = 1;
/// no input in this update: the part moves on to its last target
pub const DM_HAND_NONE: i32 = 0;
/// a pointer, with \`ray\`
pub const DM_HAND_RAY: i32 = 1;
/// A hand in space, with \`point\`. The vector from it to the grabbed point stays as it was in its first update.
pub const DM_HAND_POINT: i32 = 2;
/// a stick or a key held down, with \`amount\` from -1 to 1 times dm\_drag\_rules.drive\_speed
pub const DM_HAND_RATE: i32 = 3;
/// a wheel, which moves the part by \`amount\`, a share of the range
pub const DM_HAND_STEP: i32 = 4;
/// a slider of the host, which moves the part to the joint value \`amount\`
pub const DM_HAND_VALUE: i32 = 5;
/// the part is locked in this update, as by DM\_RULE\_LOCKED
pub const DM_INPUT_LOCKED: i32 = 1;
/// dm\_drag\_override may change the value after this update
pub const DM_INPUT_ASK: i32 = 2;
/// lower and upper hold even when they are equal
pub const DM_INPUT_BOUNDS: i32 = 4;
/// the part follows the pointer
pub const DM_DRAG_HELD: i32 = 0;
/// the part moves by itself after dm\_drag\_release
pub const DM_DRAG_RELEASED: i32 = 1;
/// the part has come to where it goes
pub const DM_DRAG_AT_REST: i32 = 2;
/// It has met its lower limit (within 0.5 % of the range), with the speed dm\_drag\_state.impact. The event comes again after the part was 2 % away. An estimated limit that has given does not count.
pub const DM_EVENT_LIMIT_LOWER: i32 = 1;
/// the same for the upper limit
pub const DM_EVENT_LIMIT_UPPER: i32 = 2;
/// it is more than 2 % of the range away from rest
pub const DM_EVENT_LEFT_REST: i32 = 4;
/// it is within 0.5 % of the range of rest, having left it
pub const DM_EVENT_REACHED_REST: i32 = 8;
/// it has opened beyond dm\_drag\_rules.open\_share
pub const DM_EVENT_OPENED: i32 = 16;
/// it has closed to within dm\_drag\_rules.closed\_share
pub const DM_EVENT_CLOSED: i32 = 32;
/// it has passed to another detent or snap value, see dm\_drag\_state.detents
pub const DM_EVENT_DETENT: i32 = 64;
/// the pull has changed the joint, see dm\_drag\_state.changes
pub const DM_EVENT_JOINT: i32 = 128;
/// the bounds of dm\_drag\_input hold it
pub const DM_EVENT_BLOCKED: i32 = 256;
/// these bounds no longer hold it
pub const DM_EVENT_FREED: i32 = 512;
/// the latch has caught it
pub const DM_EVENT_LATCHED: i32 = 1024;
/// the handle has opened the latch
pub const DM_EVENT_UNLATCHED: i32 = 2048;
/// it was tried while locked or latched; the event comes again after the hand has let up
pub const DM_EVENT_LOCKED: i32 = 4096;
/// it was let go of at dm\_drag\_rules.break\_distance
pub const DM_EVENT_LET_GO: i32 = 8192;
/// the latch holds it
pub const DM_STATUS_LATCHED: i32 = 1;
/// DM\_RULE\_LOCKED or DM\_INPUT\_LOCKED holds it
pub const DM_STATUS_LOCKED: i32 = 2;
/// the bounds of dm\_drag\_input hold it, from DM\_EVENT\_BLOCKED to DM\_EVENT\_FREED
pub const DM_STATUS_BLOCKED: i32 = 4;
/// it counts as open, from DM\_EVENT\_OPENED to DM\_EVENT\_CLOSED
pub const DM_STATUS_OPEN: i32 = 8;
/// dm\_object\_prepare found it, and no pull has changed it
pub const DM_BASIS_PREPARED: i32 = 0;
/// a pull of this drag, or of an earlier one of the same dm\_part\_state, has changed it
pub const DM_BASIS_PULL: i32 = 1;
/// it is the host's own
pub const DM_BASIS_HOST: i32 = 2;
/// the host has chosen it among the hypotheses
pub const DM_BASIS_CHOSEN: i32 = 3;
/// the library decides what the player meant, by where the part is and how fast it goes
pub const DM_GO_AUTO: i32 = 0;
/// it glides to a stop; this also stops a part that moves by itself
pub const DM_GO_STAY: i32 = 1;
/// it goes to the end of the joint that lies the way it was pulled
pub const DM_GO_OPEN: i32 = 2;
/// it goes to where it is closed (dm\_joint.closed), which is rest unless it rests open
pub const DM_GO_CLOSE: i32 = 3;
/// it repeats what it did after the last release
pub const DM_GO_REPLAY: i32 = 4;
/// it stops at once
pub const DM_GO_FREEZE: i32 = 5;
/// it opens when it is nearer to where it is closed than to its open end, else it closes
pub const DM_GO_TOGGLE: i32 = 6;
pub const DM_INTENT_AUTO: i32 = 0;
pub const DM_INTENT_STAY: i32 = 1;
pub const DM_INTENT_OPEN: i32 = 2;
pub const DM_INTENT_CLOSE: i32 = 3;
pub const DM_INTENT_REPLAY: i32 = 4;
pub const DM_INTENT_FREEZE: i32 = 5;
pub const DM_INTENT_TOGGLE: i32 = 6;
/// A rule paces the release instead of the DQ-VAE, whose last bits differ between instruction sets.
pub const DM_RELEASE_BY_RULE: i32 = 1;
/// a part that opens to both sides of rest opens away from \`away\_from\`
pub const DM_RELEASE_AWAY_FROM: i32 = 2;
/// How a texture continues beyond its edges, by OpenGL's numbers.
pub const DM_GLTF_WRAP_REPEAT: i32 = 10497;
/// How a texture continues beyond its edges, by OpenGL's numbers.
pub const DM_GLTF_WRAP_CLAMP: i32 = 33071;
/// How a texture continues beyond its edges, by OpenGL's numbers.
pub const DM_GLTF_WRAP_MIRROR: i32 = 33648;
/// rigged.urdf: ROS, Gazebo, MuJoCo, Bullet
pub const DM_GLTF_RIG_URDF: i32 = 1;
/// rigged.xml: MuJoCo
pub const DM_GLTF_RIG_MJCF: i32 = 2;
/// rigged.sdf, SDF 1.7: Gazebo
pub const DM_GLTF_RIG_SDF: i32 = 4;
/// rigged.usda, with UsdPhysics: Isaac Sim, Omniverse; all in one file
pub const DM_GLTF_RIG_USDA: i32 = 8;
/// rigged.tscn: Godot 4
pub const DM_GLTF_RIG_TSCN: i32 = 16;
/// rigged.glb: the file with an animation that opens and closes all parts, with KHR\_physics\_rigid\_bodies, KHR\_implicit\_shapes and KHR\_node\_selectability, and with the joints in \`extras\` as dm\_gltf\_get\_asset reads them. What a clip of the file moves, with all that it carries, is left to that clip, and has its joint in \`extras\` alone.
pub const DM_GLTF_RIG_GLB: i32 = 32;

pub type dm_result = i32;
#[repr(C)]
pub struct dm_context {
    opaque: [u8; 0],
}
/// loaded weights
pub type dm_model = u64;
/// a prepared object: parts and their joints
pub type dm_object = u64;
/// a generated motion of one part: 16 key poses, sampled continuously
pub type dm_motion = u64;
/// one player dragging one part
pub type dm_drag = u64;
/// placed objects that rays can pick
pub type dm_scene = u64;
/// a whole asset: which of its nodes move, how, and what carries them
pub type dm_asset = u64;
pub type dm_task = Option<unsafe extern "C" fn(data: *mut c_void, index: u32)>;
/// Reports how much of a call is done, as a number that rises from 0 to 1. It runs on the thread that calls the library, whatever jobs run beside it. Return non-zero to cancel the call, which then answers DM\_ERROR\_CANCELLED.
pub type dm_progress_callback = Option<unsafe extern "C" fn(user: *mut c_void, done: f32) -> i32>;
/// Asks the host for the joint type of a part (a designer's tag, a rule, a vision-language model). Return a DM\_JOINT\_\*, or DM\_JOINT\_UNKNOWN to leave the question to the library.
pub type dm_intent_callback = Option<unsafe extern "C" fn(user: *mut c_void, part_id: u32, box_min: dm_vec3, box_max: dm_vec3) -> i32>;
/// Asks the host which hypothesis is right (a designer's rule, a vision-language model that sees pictures). Return its index to put it in force; its source becomes DM\_JOINT\_CHOSEN, and both confidences become 1. Return DM\_CHOICE\_KEEP to keep the library's answer with its confidences. With any other number, the preparation answers INDEX\_OUT\_OF\_RANGE. dm\_object\_get\_hypotheses and dm\_object\_reset\_joint still give the library's own ranking afterwards. The callback runs on the thread that prepares, for one part after the other by rising id, and not for parts that the host declares fixed.
pub type dm_choice_callback = Option<unsafe extern "C" fn(user: *mut c_void, choice: *const dm_choice) -> i32>;
#[repr(C)]
pub struct dm_gltf {
    opaque: [u8; 0],
}
#[repr(C)]
pub struct dm_gltf_rig {
    opaque: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_vec3 {
    pub x: f32,
    pub y: f32,
    pub z: f32,
}

impl Default for dm_vec3 {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// A rigid pose x' = R x + t as a unit dual quaternion real + eps dual, both in x, y, z, w order; dual = 1/2 t (\*) real with t as a pure quaternion. Identity: real = {0,0,0,1}, dual = {0,0,0,0}.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_pose {
    pub real: [f32; 4],
    pub dual: [f32; 4],
}

impl Default for dm_pose {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// A ray. The direction need not be a unit vector. Distances along the ray are in host units, not in multiples of it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_ray {
    pub origin: dm_vec3,
    pub direction: dm_vec3,
}

impl Default for dm_ray {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// The host's memory. allocate returns memory aligned to \`alignment\` (a power of two, 64 at most) or NULL; release gets the size that was asked for. Both may be called from any thread on which the host calls the library. docs/integration.md says what callbacks may do.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_allocator {
    pub user: *mut c_void,
    pub allocate: Option<unsafe extern "C" fn(user: *mut c_void, size: usize, alignment: usize) -> *mut c_void>,
    pub release: Option<unsafe extern "C" fn(user: *mut c_void, memory: *mut c_void, size: usize)>,
}

impl Default for dm_allocator {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// Receives messages for people, on the threads on which the host calls the library. level: DM\_LOG\_\*. code: the error, or DM\_OK for other messages. text: UTF-8, valid during the call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_log {
    pub user: *mut c_void,
    pub message: Option<unsafe extern "C" fn(user: *mut c_void, level: i32, code: dm_result, text: *const c_char)>,
}

impl Default for dm_log {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// The host's job system. parallel\_for runs task(data, i) once for every i in \[0, count) and returns non-zero when all are done. It may return 0 without having run any, and the library then runs them itself. When a task was left out, made up or run twice, the call answers INVALID\_ARGUMENT; a second run of a task does nothing. The library starts no thread of its own.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_jobs {
    pub user: *mut c_void,
    pub parallel_for: Option<unsafe extern "C" fn(user: *mut c_void, count: u32, task: dm_task, data: *mut c_void) -> i32>,
}

impl Default for dm_jobs {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_context_desc {
    pub struct_size: u32,
    /// DM\_AXES\_\*; 0 = DM\_AXES\_GLTF
    pub axes: i32,
    /// length of one host unit, m; 0 = 1. Unreal: 0.01
    pub unit_in_metres: f32,
    /// Row-major matrix that takes a host vector to glTF's axes, for DM\_AXES\_CUSTOM. It is orthogonal, with determinant +1 or -1.
    pub custom_axes: [f32; 9],
    /// zeros = malloc/free
    pub allocator: dm_allocator,
    /// zeros = silent
    pub log: dm_log,
    /// zeros = tasks run on the calling thread
    pub jobs: dm_jobs,
    /// DM\_PICK\_\*; 0 = auto
    pub picking: i32,
    /// 0
    pub reserved: u32,
    /// Callback of dm\_mesh\_find\_part, dm\_object\_load and dm\_object\_refine, and of dm\_object\_prepare and dm\_asset\_create without one of their own; NULL = none. Several threads may call it at once, one for each such call.
    pub progress: dm_progress_callback,
    pub progress_user: *mut c_void,
    /// Most bytes of scratch memory that stay with the context between calls; 0 = 32 MB, 1 = none. dm\_context\_trim gives them back.
    pub kept_bytes: u64,
}

impl Default for dm_context_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_memory_info {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// bytes held now through the context's allocator
    pub bytes: u64,
    /// most bytes ever held
    pub peak_bytes: u64,
    /// calls of allocate so far
    pub allocations: u64,
    /// bytes held now by Embree, which has its own allocator and reports sizes
    pub pick_bytes: u64,
    /// share of \`bytes\` that no call uses now, kept for later calls (dm\_context\_desc.kept\_bytes)
    pub kept_bytes: u64,
}

impl Default for dm_memory_info {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// Weights, as the bytes of safetensors files. Each may be absent (NULL, 0). The library copies and repacks them, so the host may free them after the call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_model_desc {
    pub struct_size: u32,
    /// KPP-Net: sdk/models/kpp\_net.safetensors
    pub kinematics: *const c_void,
    pub kinematics_size: usize,
    /// DQ-VAE: sdk/models/dq\_vae.safetensors
    pub motion: *const c_void,
    pub motion_size: usize,
    /// chooses between candidate joints: sdk/models/ranker.safetensors; rules choose without it
    pub ranker: *const c_void,
    pub ranker_size: usize,
}

impl Default for dm_model_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// The host's mesh of triangles, which the library reads in place. The sizes of the buffers guard against a forgotten format, scope or stride: the call refuses a buffer that does not hold what counts, formats and strides say, and never reads past its end.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_mesh_desc {
    pub struct_size: u32,
    /// bytes from one vertex to the next; 0 = packed
    pub position_stride: u32,
    /// vertex\_count x 3 numbers
    pub positions: *const c_void,
    pub vertex_count: u64,
    /// size of the buffer that begins at \`positions\`; 0 = not stated, and not checked
    pub position_bytes: u64,
    /// index\_count indices, three a triangle; NULL = each three vertices in order are a triangle
    pub indices: *const c_void,
    pub index_count: u64,
    /// size of the buffer; 0 = not stated, and not checked
    pub index_bytes: u64,
    /// The part that each vertex or face belongs to: 0 = the body that stays, 1 and above = parts. An id that dm\_object\_desc.parts does not list counts as the body's. With ids per vertex, a triangle belongs to the id that two of its corners share, or else to the smallest. A mesh without a body, such as a door leaf alone, is allowed, but its joints are less certain.
    pub part_ids: *const c_void,
    /// Size of the buffer that begins at \`part\_ids\`, required with part\_ids. It must be exactly that of one id a vertex or a face, as part\_id\_scope says.
    pub part_id_bytes: u64,
    /// bytes from one id to the next; 0 = packed
    pub part_id_stride: u32,
    /// DM\_FLOAT32 | DM\_FLOAT64
    pub position_format: i32,
    /// DM\_UINT32 | DM\_UINT16 | DM\_UINT8
    pub index_format: i32,
    /// DM\_UINT32 | DM\_UINT16 | DM\_UINT8 | DM\_INT32, whose negative ids are the body's
    pub part_id_format: i32,
    /// DM\_PER\_VERTEX | DM\_PER\_FACE
    pub part_id_scope: i32,
    /// 0
    pub reserved: u32,
}

impl Default for dm_mesh_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// A drag as evidence of how a part moves: a point on it, and the way in which a hand pulled it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_drag_hint {
    /// a point on or near the part, host object frame
    pub point: dm_vec3,
    /// direction of the pull, not zero; its length is how far it went
    pub vector: dm_vec3,
}

impl Default for dm_drag_hint {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// The place, at rest, of the node or bone that moves a part. An artist may have put it on the hinge, or left it in the middle or at the file's origin, so it is evidence only. Leave it out, or say DM\_PIVOT\_DEFAULT, where the nodes of an asset all have their places by one rule: at one point, or at the same place of their boxes. A program has put them there, and the library would take an edge that happens to lie there for a hinge.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_pivot {
    /// host object frame
    pub origin: dm_vec3,
    /// The node's x, y and z axis, three numbers each, host object frame. They may have any length, and may be mirrored. Zeros: unknown.
    pub axes: [f32; 9],
}

impl Default for dm_pivot {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_part_desc {
    pub struct_size: u32,
    /// id as in part\_ids, 1 or above
    pub id: u32,
    /// id of the part that carries this one and that it moves with; 0 = the body
    pub parent: u32,
    /// DM\_JOINT\_\*; 0 = the library infers it
    pub joint_type: i32,
    /// optional evidence
    pub drag: *const dm_drag_hint,
    /// Optional evidence: the names that the asset has for the part, as UTF-8, outermost first, joined by '/': file, parents, node, mesh. A name counts, in any language, when it says what the part is (door, lid, Hebel). At most DM\_MAX\_LABEL bytes.
    pub label: *const c_char,
    /// optional evidence
    pub pivot: *const dm_pivot,
    /// DM\_PIVOT\_\*: whether somebody has set the pivot
    pub pivot_kind: i32,
    /// 0
    pub reserved: u32,
}

impl Default for dm_part_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// How a part moves.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_joint {
    pub struct_size: u32,
    /// DM\_JOINT\_\*
    pub type_: i32,
    /// probability that the type is right, 0 to 1
    pub type_confidence: f32,
    /// Probability that type, axis and origin are all right, 0 to 1; never above type\_confidence.
    pub joint_confidence: f32,
    /// host units a radian, signed along the axis; for screws only
    pub pitch: f32,
    /// Unit vector, host object frame. A positive value slides along it, or turns about it: right-handed in a right-handed host frame, left-handed in a left-handed one. A joint found with a drag is positive the way of the drag. Without a drag the longer way is positive, so \`upper\` is the open end.
    pub axis: dm_vec3,
    /// A point of the axis. For a joint that the library found, it is the one nearest the part's centre. The point of a host's own joint stays as it was given.
    pub origin: dm_vec3,
    /// Limits of the joint value, rad or host units; the rest pose is value 0. There are no limits when both are equal, and none for continuous joints. A limit of the host farther from rest than 1000 rad or 100 object sizes (FLT\_MAX, 1e10, infinity) counts as none. Where only one side has none, a slightly larger number stands for the missing limit.
    pub lower: f32,
    /// Limits of the joint value, rad or host units; the rest pose is value 0. There are no limits when both are equal, and none for continuous joints. A limit of the host farther from rest than 1000 rad or 100 object sizes (FLT\_MAX, 1e10, infinity) counts as none. Where only one side has none, a slightly larger number stands for the missing limit.
    pub upper: f32,
    /// DM\_JOINT\_FROM\_\*, DM\_JOINT\_CHOSEN
    pub source: i32,
    /// Evidence in a dm\_part\_state: what the part's pulls so far say of all its joints. dm\_drag\_end writes it and dm\_drag\_begin reads it, so keep the four numbers as they are. Zeros: no pull has said anything. In other structs it is 0, and no function reads it.
    pub evidence: [u32; 4],
    /// Joint value at which the part is closed: 0, or one of the limits when the part rests open. A host's joint may set it; a value outside of its limits becomes the nearer limit.
    pub closed: f32,
}

impl Default for dm_joint {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// A joint as the constraint of a physics engine: an orthonormal frame whose x axis is that of the hinge or slider. The y and z axes are arbitrary, but always the same for the same joint. x, y, z and \`rotation\` have determinant +1 in the host's coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_joint_frame {
    pub struct_size: u32,
    /// DM\_JOINT\_\*
    pub type_: i32,
    /// host object frame
    pub origin: dm_vec3,
    /// unit vectors
    pub x: dm_vec3,
    /// unit vectors
    pub y: dm_vec3,
    /// unit vectors
    pub z: dm_vec3,
    /// unit quaternion x, y, z, w that takes the frame's coordinates to the object's
    pub rotation: [f32; 4],
    /// Limits, about or along x: rad for hinges and screws, host units for sliders; 0 where there is none.
    pub lower: f32,
    /// Limits, about or along x: rad for hinges and screws, host units for sliders; 0 where there is none.
    pub upper: f32,
    /// DM\_LIMIT\_LOWER | DM\_LIMIT\_UPPER: the limits that exist
    pub limits: u32,
    /// host units along x a radian; for screws only
    pub pitch: f32,
}

impl Default for dm_joint_frame {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// Where the part of one instance stands, and by which joint it moves. This is all that a host must keep, save, replicate and undo for it. It belongs to the instance, not to the object, because two doors of one object may differ. Save it field by field: type, pitch, axis, origin, limits, source, both confidences, evidence, value.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_part_state {
    pub struct_size: u32,
    /// joint value; 0 = rest
    pub value: f32,
    /// d value / dt, for a physics engine that takes over; output only: a drag begins with velocity 0
    pub velocity: f32,
    /// DM\_STATUS\_\*; output only
    pub status: u32,
    /// The pose as shown, from rest. It differs from dm\_joint\_pose(joint, value) only while the part blends over to a joint that has just changed. Zeros: the pose of joint and value.
    pub pose: dm_pose,
    /// stays the last field
    pub joint: dm_joint,
}

impl Default for dm_part_state {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_part_info {
    pub struct_size: u32,
    pub id: u32,
    pub parent: u32,
    /// triangles of the part alone, without the parts it carries
    pub triangle_count: u32,
    pub box_min: dm_vec3,
    pub box_max: dm_vec3,
    /// centroid of the surface
    pub centre: dm_vec3,
    pub area: f32,
}

impl Default for dm_part_info {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// Where a hypothesis takes its part at one end of its range, host object frame. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_joint_end {
    /// joint value
    pub value: f32,
    /// pose of the part, from rest
    pub pose: dm_pose,
    /// box of the part alone, as in dm\_part\_info
    pub box_min: dm_vec3,
    /// box of the part alone, as in dm\_part\_info
    pub box_max: dm_vec3,
    pub centre: dm_vec3,
}

impl Default for dm_joint_end {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// A ranked hypothesis and what it would do. struct\_size says how much the library has filled.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_hypothesis {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// the joint, with its limits and probabilities
    pub joint: *const dm_joint,
    /// The ends at the lower and at the upper limit. For a joint without limits they are a quarter turn, or half the object's size, either way.
    pub ends: [dm_joint_end; 2],
}

impl Default for dm_hypothesis {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// A part and its hypotheses, for the host to choose from. It is valid during the call only.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_choice {
    pub struct_size: u32,
    /// number of hypotheses, 1 to DM\_MAX\_HYPOTHESES
    pub count: u32,
    pub part: *const dm_part_info,
    /// most probable first
    pub hypotheses: *const *const dm_hypothesis,
}

impl Default for dm_choice {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_object_desc {
    pub struct_size: u32,
    /// DM\_PREPARE\_\*
    pub flags: u32,
    pub mesh: *const dm_mesh_desc,
    /// NULL: every id above 0 in part\_ids is a part that the body carries
    pub parts: *const dm_part_desc,
    pub part_count: u32,
    /// 0
    pub reserved: u32,
    /// weights; 0 = the joints come from geometry alone
    pub model: dm_model,
    /// seed of the surface sampling; the same seed gives the same bits
    pub seed: u64,
    pub intent: dm_intent_callback,
    pub intent_user: *mut c_void,
    /// NULL = the context's
    pub progress: dm_progress_callback,
    pub progress_user: *mut c_void,
    /// Optional evidence: names of the whole object, as dm\_part\_desc.label. They count for the parts whose own label says nothing.
    pub label: *const c_char,
    /// The up direction, host object frame. It counts only together with labels and pivots. 0 = that of the context's axes.
    pub up: dm_vec3,
    pub choose: dm_choice_callback,
    pub choose_user: *mut c_void,
}

impl Default for dm_object_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_object_info {
    pub struct_size: u32,
    pub part_count: u32,
    pub vertex_count: u64,
    pub triangle_count: u64,
    /// host object frame; oblique custom axes may make it larger than need be
    pub box_min: dm_vec3,
    /// host object frame; oblique custom axes may make it larger than need be
    pub box_max: dm_vec3,
    /// largest side of the box
    pub size: f32,
    /// 1 when it has kept its triangles
    pub pickable: u32,
    /// DM\_DEGRADED\_\*; 0: nothing was missing
    pub degraded: u32,
    /// DM\_PICK\_EMBREE or DM\_PICK\_PORTABLE: the kind of its trees. DM\_PICK\_NONE: it has none.
    pub picking: i32,
}

impl Default for dm_object_info {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// How one animation moves one node. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_asset_clip {
    /// name of the animation, UTF-8; may be NULL
    pub name: *const c_char,
    /// s, rising
    pub times: *const f32,
    /// Poses of the node relative to the pose that its mesh has, asset frame, as if all nodes above it stood still.
    pub poses: *const dm_pose,
    /// number of times and of poses
    pub key_count: u32,
    /// DM\_CLIP\_NOT\_RIGID
    pub flags: u32,
}

impl Default for dm_asset_clip {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// A node of an asset, as the host has it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_asset_node {
    pub struct_size: u32,
    /// DM\_ASSET\_NODE\_\*
    pub flags: u32,
    /// index of the node above it, which may come later in the list, or DM\_ASSET\_NO\_NODE
    pub parent: u32,
    /// Index of the node that a DM\_ASSET\_NODE\_FOLLOWS follows; DM\_ASSET\_NO\_NODE: the one above it.
    pub follows: u32,
    /// UTF-8, DM\_MAX\_LABEL bytes at most; NULL: none
    pub name: *const c_char,
    /// name of its mesh, with the same rules
    pub mesh_name: *const c_char,
    /// mesh without part\_ids; NULL: a node without a mesh, such as a group
    pub mesh: *const dm_mesh_desc,
    /// 4x4, column-major, affine: takes the node's frame to the asset frame, all nodes above it included. NULL: identity.
    pub transform: *const f32,
    /// Pivot of the node, asset frame. NULL: origin and axes of \`transform\`, and unknown where that is NULL too.
    pub pivot: *const dm_pivot,
    pub clips: *const dm_asset_clip,
    pub clip_count: u32,
    /// 0
    pub reserved: u32,
    /// Joint that the file states for this node, asset frame, with limits. It is as certain as a joint that the host sets. DM\_JOINT\_FIXED: the node is one with the node above it. NULL: none.
    pub joint: *const dm_joint,
}

impl Default for dm_asset_node {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_asset_desc {
    pub struct_size: u32,
    /// DM\_ASSET\_\*, DM\_PREPARE\_WITHOUT\_PICKING, DM\_PREPARE\_MESH\_INCOMPLETE
    pub flags: u32,
    pub nodes: *const dm_asset_node,
    /// optional evidence: names of the whole asset, as dm\_object\_desc.label
    pub label: *const c_char,
    pub node_count: u32,
    /// Least probability of moving, 0 to 1, from which a part counts as moving and belongs to the object; 0 = 0.5.
    pub min_moves: f32,
    /// weights; 0 = the joints come from geometry alone
    pub model: dm_model,
    /// seed, as dm\_object\_desc.seed
    pub seed: u64,
    /// NULL = the context's
    pub progress: dm_progress_callback,
    pub progress_user: *mut c_void,
    /// the up direction, asset frame; 0 = that of the context's axes
    pub up: dm_vec3,
    /// 0
    pub reserved: u32,
}

impl Default for dm_asset_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_asset_info {
    pub struct_size: u32,
    pub node_count: u32,
    /// parts, those that stay included
    pub part_count: u32,
    /// parts that move or are free, which are those of the object
    pub moving_count: u32,
    /// triangles of the nodes that do not follow others
    pub triangle_count: u64,
    /// DM\_DEGRADED\_\*: what was missing when the joints were found
    pub degraded: u32,
    /// DM\_ASSET\_CLIP\_LEFT\_OUT
    pub warnings: u32,
}

impl Default for dm_asset_info {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// Nodes that move together, or might.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_asset_part {
    pub struct_size: u32,
    /// index of the part that carries it, or DM\_ASSET\_NO\_PART
    pub parent: u32,
    /// id in the object: its index in the asset + 1; 0 while it stays
    pub part_id: u32,
    /// DM\_ASSET\_STAYS …
    pub state: i32,
    /// DM\_ASSET\_INFERRED …
    pub basis: i32,
    /// probability that it moves relative to what carries it, 0 to 1
    pub moves: f32,
    /// Its nodes, those that follow them included. Nodes of the parts that it carries do not count.
    pub node_count: u32,
    /// triangles of these nodes, without those that follow
    pub triangle_count: u32,
    /// Seconds in which its clip takes it from one end of the joint to the other; 0: it has no clip.
    pub duration: f32,
    /// 0
    pub reserved: u32,
    pub box_min: dm_vec3,
    pub box_max: dm_vec3,
}

impl Default for dm_asset_part {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// What the player asked for. The network answers with a motion of DM\_MOTION\_FRAMES poses from rest.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_motion_desc {
    pub struct_size: u32,
    pub part_id: u32,
    /// required
    pub drag: dm_drag_hint,
    /// Optional: the path on which the pointer drew the drag point, from drag.point on; at most 65536 points.
    pub path: *const dm_vec3,
    /// 0: the path that opens the joint all the way in the drag's direction
    pub path_count: u32,
    /// 0: the most likely motion (z = mean); else z is drawn with this seed
    pub seed: u32,
}

impl Default for dm_motion_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// How a drag feels. Zeros are the defaults. Stiffness, damping and inertia of a part in the hand matter only through two ratios, which are times: smoothing\_time is damping over stiffness, coast\_time is inertia over damping.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_drag_feel {
    /// s for the part to close half the gap to the pointer; 0 = 0.02, negative = none
    pub smoothing_time: f32,
    /// Share of the range over which the ends give; 0 = hard ends. It does not apply to limits that the library estimated: see dm\_drag\_desc.limit\_give.
    pub soft_limit: f32,
    /// Seconds in which a part left alone loses half its speed; in the hand it makes the part heavy. 0 = 0.1 once released, and weightless in the hand; negative = it stops where it is let go.
    pub coast_time: f32,
    /// Joint value from one catch to the next, rad or host units, counted from where the part is closed; 0 = none.
    pub detent: f32,
    /// strength of the catches, up to 1; 0 = 0.7. It has no effect without \`detent\`
    pub detent_pull: f32,
    /// Seconds in which the released part springs back to rest. 0 = push buttons alone do, in 0.12 s; negative = nothing does.
    pub return_time: f32,
}

impl Default for dm_drag_feel {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// What a part does besides following the hand. Zeros are off, except that thresholds have defaults. "Range" is the way from lower to upper limit; where one of them is missing, it is 1 rad or the object's size. docs/feel.md describes each rule.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_drag_rules {
    pub struct_size: u32,
    /// DM\_RULE\_\*
    pub flags: u32,
    /// Joint values, rising, at which the part catches as at detents, with the strength of feel.detent\_pull. With feel.detent above 0 they are refused.
    pub snaps: *const f32,
    /// DM\_MAX\_SNAPS at most
    pub snap_count: u32,
    /// Distance, in joint value, from which a snap value catches the part, to either side; 0 = half-way to the next one, or a twentieth of the range where there is none.
    pub snap_reach: f32,
    /// share of the range from rest beyond which DM\_EVENT\_OPENED comes; 0 = 0.1
    pub open_share: f32,
    /// Share of the range from rest within which DM\_EVENT\_CLOSED comes; 0 = 0.02. It is less than open\_share. A part that is grabbed between both counts as open.
    pub closed_share: f32,
    /// shortest time between DM\_EVENT\_OPENED and DM\_EVENT\_CLOSED, s
    pub event_time: f32,
    /// joint value a second; 0 = no limit
    pub max_speed: f32,
    /// Joint value a second squared while the part gets faster: the highest force over the part's inertia; 0 = no limit.
    pub max_acceleration: f32,
    /// Share of the range by which a locked or latched part gives at most; 0 = 0.01, negative = none.
    pub lock_give: f32,
    /// Joint value of a handle, of either sign, from which on the latch is open; 0 = 0.785 (rad: 45 degrees).
    pub latch_turn: f32,
    /// Share of the range: a released part nearer to rest than this closes by itself; 0 = none does.
    pub auto_close_share: f32,
    /// seconds in which it closes; 0 = 0.25
    pub auto_close_time: f32,
    /// seconds from the release until the part starts to spring back by feel.return\_time
    pub close_delay: f32,
    /// Share of the range: a released part nearer to rest than this falls to rest, and any other to its open end, as a hatch does; 0 = it does not fall.
    pub tip_share: f32,
    /// seconds of a fall over the whole range; 0 = 0.7
    pub fall_time: f32,
    /// Share of its speed, 0 to 1, with which a part rebounds from a limit that it falls, glides or swings against.
    pub restitution: f32,
    /// Host units from the hand to where it holds the part, beyond which the part is released (DM\_EVENT\_LET\_GO); 0 = never.
    pub break_distance: f32,
    /// share of the range a second at dm\_hand.amount 1; 0 = 1
    pub drive_speed: f32,
    /// 0
    pub reserved: u32,
}

impl Default for dm_drag_rules {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// A link between two parts. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_link {
    /// part ids
    pub driver: u32,
    /// part ids
    pub driven: u32,
    /// DM\_LINK\_\*
    pub kind: i32,
    /// DM\_LINK\_BOTH\_WAYS
    pub flags: u32,
    /// How far the driven part's value changes for each unit of the driver's; 0 = 1. The two may be rad and host units, as in a rack and pinion.
    pub ratio: f32,
    /// value of the driven part while the driver is at \`from\`
    pub offset: f32,
    /// Value of the driver from which on the link acts, on that side of rest. A \`from\` of 0 counts as reached at rest for DM\_LINK\_FREES and DM\_LINK\_HOLDS.
    pub from: f32,
}

impl Default for dm_link {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_drag_desc {
    pub struct_size: u32,
    pub part_id: u32,
    pub object: dm_object,
    /// point on the part as it is now, host object frame
    pub grab_point: dm_vec3,
    /// joint value of the part now; 0 = rest. It must be 0 with \`state\`
    pub start_value: f32,
    pub feel: dm_drag_feel,
    /// DM\_DRAG\_KEEP\_JOINT, DM\_DRAG\_WITHOUT\_POINT
    pub flags: u32,
    /// How far a pull takes the part beyond limits that the library estimated, as a share of the range. 0 = as far as the pull goes, by one turn or the object's size at most; negative = not at all. The host's own limits never give, nor does a stop at rest.
    pub limit_give: f32,
    /// The instance's joint and value, as an earlier drag has returned them; the drag begins in its pose. NULL = the object's joint in force, at start\_value.
    pub state: *const dm_part_state,
    /// Scale of the instance along the axes of the object frame; negative = mirrored, 0 = 1. grab\_point, rays, state and poses are then in the scaled frame (object coordinates times scale), and poses are rigid in it.
    pub scale: dm_vec3,
    /// 0
    pub reserved: u32,
    /// NULL = no rules, and no events
    pub rules: *const dm_drag_rules,
}

impl Default for dm_drag_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_hand {
    /// DM\_HAND\_\*. RATE, STEP and VALUE stay inside the limits. RATE and STEP open the part with an amount above 0. A limit that the library estimated stops them first. It gives afterwards, as it gives to a pull: to a RATE after 0.25 s at the limit, to a STEP with the next step.
    pub kind: i32,
    /// object frame, scaled with dm\_drag\_desc.scale
    pub ray: dm_ray,
    /// object frame, scaled with dm\_drag\_desc.scale
    pub point: dm_vec3,
    /// what RATE, STEP and VALUE ask for
    pub amount: f32,
    /// Where a second hand takes hold of the part as it is then. It is read in that hand's first update only.
    pub grab_point: dm_vec3,
}

impl Default for dm_hand {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// Everything that one update can read.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_drag_input {
    pub struct_size: u32,
    /// DM\_INPUT\_\*
    pub flags: u32,
    pub hand: dm_hand,
    /// Another hand on the part, by ray or point; DM\_HAND\_NONE = none. The hand that can move the part farther counts more. The second hand comes and goes without a jump.
    pub second: dm_hand,
    /// joint values of the handles of a latch, from their drags or links
    pub handles: [f32; 2],
    /// Joint values between which the host's world leaves the part room in this update, infinite on a free side. There are no bounds when both are equal, unless DM\_INPUT\_BOUNDS is set. The part stops there softly, goes on when it is free, and is pushed back when it lies beyond.
    pub lower: f32,
    /// Joint values between which the host's world leaves the part room in this update, infinite on a free side. There are no bounds when both are equal, unless DM\_INPUT\_BOUNDS is set. The part stops there softly, goes on when it is free, and is pushed back when it lies beyond.
    pub upper: f32,
}

impl Default for dm_drag_input {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_drag_state {
    pub struct_size: u32,
    /// pose of the part from rest, object frame; compose it with the carrier's own pose
    pub pose: dm_pose,
    /// place of the grabbed point now
    pub grab_point: dm_vec3,
    /// joint value
    pub value: f32,
    /// joint value that the pointer asks for, before smoothing and inside the limits
    pub target: f32,
    /// d value / dt
    pub velocity: f32,
    /// -1 at lower, +1 at upper, 0 between
    pub at_limit: i32,
    /// DM\_DRAG\_HELD …
    pub phase: i32,
    /// How often the pull has changed the joint that the drag follows (dm\_drag\_get\_part\_state). The pose blends over to a new joint within 0.6 s, the grabbed point mostly within 0.1 s.
    pub changes: u32,
    /// DM\_EVENT\_\*; 0 without dm\_drag\_desc.rules
    pub events: u32,
    /// Detents or snap values that the part has passed to since the update before; a long update may pass several. 0 without dm\_drag\_desc.rules.
    pub detents: u32,
    /// Speed with which it met a limit or was blocked, joint value a second; 0 without such an event, or without dm\_drag\_desc.rules.
    pub impact: f32,
    /// DM\_STATUS\_\*: what holds the part, and whether it is open; 0 without dm\_drag\_desc.rules
    pub status: u32,
    /// Probability that the joint in force is right, 0 to 1: the one number to show. A pull of one kind from one side never makes it 1.
    pub joint_confidence: f32,
    /// DM\_BASIS\_\*: where the joint in force comes from
    pub joint_basis: i32,
    /// How far the part is open: 0 where it is closed (dm\_joint.closed), 1 at the end farther from there, and linear in the joint value between both. 0 for joints without limits.
    pub open_share: f32,
}

impl Default for dm_drag_state {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_release_desc {
    pub struct_size: u32,
    /// DM\_GO\_\*
    pub intent: i32,
    /// seconds from here to the end; 0 = the library takes it from the part's way and speed
    pub duration: f32,
    /// seed of the DQ-VAE, as dm\_motion\_desc.seed
    pub seed: u32,
    /// DM\_RELEASE\_\*
    pub flags: u32,
    /// a place such as the player's, object frame, scaled with dm\_drag\_desc.scale
    pub away_from: dm_vec3,
}

impl Default for dm_release_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_release_plan {
    pub struct_size: u32,
    /// what was decided: DM\_GO\_STAY, OPEN, CLOSE or FREEZE
    pub intent: i32,
    pub start_value: f32,
    pub end_value: f32,
    /// seconds; 0 when the part is there already
    pub duration: f32,
    /// 1: the DQ-VAE paces it; 0: a rule does
    pub from_network: u32,
}

impl Default for dm_release_plan {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_camera {
    pub struct_size: u32,
    /// vertical angle of view, rad, below pi; 0 = orthographic with ortho\_height
    pub fov_y: f32,
    /// host world frame
    pub eye: dm_vec3,
    /// need not be unit or orthogonal, but must not be parallel
    pub forward: dm_vec3,
    /// need not be unit or orthogonal, but must not be parallel
    pub up: dm_vec3,
    /// pixels
    pub viewport_width: f32,
    /// pixels
    pub viewport_height: f32,
    /// host units from bottom to top, for orthographic views only
    pub ortho_height: f32,
}

impl Default for dm_camera {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_scene_desc {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
}

impl Default for dm_scene_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_hit {
    pub struct_size: u32,
    /// instance, as dm\_scene\_add returned it
    pub instance: u32,
    /// 0 = nothing was hit
    pub object: dm_object,
    /// 0 = the body
    pub part_id: u32,
    /// index in the host's mesh
    pub triangle: u32,
    /// host units from the ray's origin
    pub distance: f32,
    /// barycentric weights of the triangle's second and third corners
    pub u: f32,
    /// barycentric weights of the triangle's second and third corners
    pub v: f32,
    /// host world frame
    pub point: dm_vec3,
    /// unit geometric normal, by the triangle's winding; host world frame
    pub normal: dm_vec3,
    /// The same point in the object's frame with the part as it is now, for dm\_drag\_desc.grab\_point.
    pub object_point: dm_vec3,
}

impl Default for dm_hit {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_core_1 {
    /// size of this table in the library in use; check it before you call a newer entry
    pub struct_size: u32,
    pub reserved: u32,
    pub result_string: Option<unsafe extern "C" fn(result: dm_result) -> *const c_char>,
    pub version: Option<unsafe extern "C" fn() -> u32>,
    pub context_create: Option<unsafe extern "C" fn(desc: *const dm_context_desc, out_context: *mut *mut dm_context) -> dm_result>,
    pub context_destroy: Option<unsafe extern "C" fn(context: *mut dm_context)>,
    pub context_get_memory: Option<unsafe extern "C" fn(context: *const dm_context, out_info: *mut dm_memory_info) -> dm_result>,
    pub model_load: Option<unsafe extern "C" fn(context: *mut dm_context, desc: *const dm_model_desc, out_model: *mut dm_model) -> dm_result>,
    pub model_unload: Option<unsafe extern "C" fn(context: *mut dm_context, model: dm_model) -> dm_result>,
    pub mesh_find_part: Option<unsafe extern "C" fn(context: *mut dm_context, mesh: *const dm_mesh_desc, drag: *const dm_drag_hint, out_face_ids: *mut u8, face_count: u64) -> dm_result>,
    pub object_prepare: Option<unsafe extern "C" fn(context: *mut dm_context, desc: *const dm_object_desc, out_object: *mut dm_object) -> dm_result>,
    pub object_save: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, buffer: *mut c_void, capacity: usize, out_size: *mut usize) -> dm_result>,
    pub object_load: Option<unsafe extern "C" fn(context: *mut dm_context, data: *const c_void, size: usize, model: dm_model, out_object: *mut dm_object) -> dm_result>,
    pub object_destroy: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object) -> dm_result>,
    pub object_get_info: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, out_info: *mut dm_object_info) -> dm_result>,
    pub object_get_part: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, index: u32, out_info: *mut dm_part_info) -> dm_result>,
    pub object_get_joint: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, part_id: u32, out_joint: *mut dm_joint) -> dm_result>,
    pub object_get_hypotheses: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, part_id: u32, drag: *const dm_drag_hint, out_joints: *mut dm_joint, capacity: u32, out_count: *mut u32) -> dm_result>,
    pub object_refine: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, part_id: u32, drag: *const dm_drag_hint) -> dm_result>,
    pub object_set_joint: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, part_id: u32, joint: *const dm_joint) -> dm_result>,
    pub object_reset_joint: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, part_id: u32) -> dm_result>,
    pub joint_pose: Option<unsafe extern "C" fn(joint: *const dm_joint, value: f32, out_pose: *mut dm_pose) -> dm_result>,
    pub joint_value: Option<unsafe extern "C" fn(joint: *const dm_joint, pose: *const dm_pose, out_value: *mut f32, out_angle_error: *mut f32, out_distance_error: *mut f32) -> dm_result>,
    pub joint_get_frame: Option<unsafe extern "C" fn(joint: *const dm_joint, out_frame: *mut dm_joint_frame) -> dm_result>,
    pub joint_scale: Option<unsafe extern "C" fn(joint: *const dm_joint, scale: dm_vec3, out_joint: *mut dm_joint) -> dm_result>,
    pub motion_generate: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, desc: *const dm_motion_desc, out_motion: *mut dm_motion) -> dm_result>,
    pub motion_sample: Option<unsafe extern "C" fn(context: *mut dm_context, motion: dm_motion, t: f32, out_pose: *mut dm_pose, out_value: *mut f32) -> dm_result>,
    pub motion_get_frames: Option<unsafe extern "C" fn(context: *mut dm_context, motion: dm_motion, out_poses: *mut dm_pose, out_values: *mut f32) -> dm_result>,
    pub motion_destroy: Option<unsafe extern "C" fn(context: *mut dm_context, motion: dm_motion) -> dm_result>,
    pub drag_begin: Option<unsafe extern "C" fn(context: *mut dm_context, desc: *const dm_drag_desc, out_drag: *mut dm_drag) -> dm_result>,
    pub drag_update: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, ray: *const dm_ray, dt: f32, out_state: *mut dm_drag_state) -> dm_result>,
    pub drag_release: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, desc: *const dm_release_desc, out_plan: *mut dm_release_plan) -> dm_result>,
    pub drag_end: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, out_state: *mut dm_part_state) -> dm_result>,
    pub drag_get_part_state: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, out_state: *mut dm_part_state) -> dm_result>,
    pub drag_snapshot_size: Option<unsafe extern "C" fn() -> usize>,
    pub drag_save: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, buffer: *mut c_void, capacity: usize) -> dm_result>,
    pub drag_restore: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, data: *const c_void, size: usize) -> dm_result>,
    pub pose_multiply: Option<unsafe extern "C" fn(a: *const dm_pose, b: *const dm_pose, out_pose: *mut dm_pose)>,
    pub pose_to_matrix: Option<unsafe extern "C" fn(pose: *const dm_pose, out_matrix: *mut f32)>,
    pub pose_apply_points: Option<unsafe extern "C" fn(pose: *const dm_pose, src: *const f32, src_stride: usize, dst: *mut f32, dst_stride: usize, count: usize)>,
    pub camera_ray: Option<unsafe extern "C" fn(context: *const dm_context, camera: *const dm_camera, x: f32, y: f32, out_ray: *mut dm_ray) -> dm_result>,
    pub scene_create: Option<unsafe extern "C" fn(context: *mut dm_context, desc: *const dm_scene_desc, out_scene: *mut dm_scene) -> dm_result>,
    pub scene_destroy: Option<unsafe extern "C" fn(context: *mut dm_context, scene: dm_scene) -> dm_result>,
    pub scene_add: Option<unsafe extern "C" fn(context: *mut dm_context, scene: dm_scene, object: dm_object, placement: *const dm_pose, out_instance: *mut u32) -> dm_result>,
    pub scene_move: Option<unsafe extern "C" fn(context: *mut dm_context, scene: dm_scene, instance: u32, part_id: u32, pose: *const dm_pose) -> dm_result>,
    pub scene_remove: Option<unsafe extern "C" fn(context: *mut dm_context, scene: dm_scene, instance: u32) -> dm_result>,
    pub scene_commit: Option<unsafe extern "C" fn(context: *mut dm_context, scene: dm_scene) -> dm_result>,
    pub scene_pick: Option<unsafe extern "C" fn(context: *mut dm_context, scene: dm_scene, ray: *const dm_ray, out_hit: *mut dm_hit) -> dm_result>,
    pub drag_step: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, input: *const dm_drag_input, dt: f32, out_state: *mut dm_drag_state) -> dm_result>,
    pub drag_take: Option<unsafe extern "C" fn(context: *mut dm_context, drag: dm_drag, value: f32, out_state: *mut dm_drag_state) -> dm_result>,
    pub object_set_links: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, links: *const dm_link, count: u32) -> dm_result>,
    pub object_follow_links: Option<unsafe extern "C" fn(context: *mut dm_context, object: dm_object, part_id: u32, inout_values: *mut f32, out_held: *mut u8, count: u32) -> dm_result>,
    pub joint_value_at: Option<unsafe extern "C" fn(joint: *const dm_joint, share: f32, out_value: *mut f32) -> dm_result>,
    pub pose_inverse: Option<unsafe extern "C" fn(pose: *const dm_pose, out_pose: *mut dm_pose)>,
    pub pose_from_rotation: Option<unsafe extern "C" fn(rotation: *const f32, translation: dm_vec3, out_pose: *mut dm_pose) -> dm_result>,
    pub asset_create: Option<unsafe extern "C" fn(context: *mut dm_context, desc: *const dm_asset_desc, out_asset: *mut dm_asset) -> dm_result>,
    pub asset_destroy: Option<unsafe extern "C" fn(context: *mut dm_context, asset: dm_asset) -> dm_result>,
    pub asset_get_info: Option<unsafe extern "C" fn(context: *mut dm_context, asset: dm_asset, out_info: *mut dm_asset_info) -> dm_result>,
    pub asset_get_part: Option<unsafe extern "C" fn(context: *mut dm_context, asset: dm_asset, index: u32, out_part: *mut dm_asset_part) -> dm_result>,
    pub asset_get_joint: Option<unsafe extern "C" fn(context: *mut dm_context, asset: dm_asset, index: u32, out_joint: *mut dm_joint) -> dm_result>,
    pub asset_get_part_nodes: Option<unsafe extern "C" fn(context: *mut dm_context, asset: dm_asset, index: u32, out_nodes: *mut u32, capacity: u32) -> dm_result>,
    pub asset_get_node_parts: Option<unsafe extern "C" fn(context: *mut dm_context, asset: dm_asset, out_parts: *mut u32, capacity: u32) -> dm_result>,
    pub asset_make_object: Option<unsafe extern "C" fn(context: *mut dm_context, asset: dm_asset, out_object: *mut dm_object) -> dm_result>,
    pub context_trim: Option<unsafe extern "C" fn(context: *mut dm_context) -> dm_result>,
}

impl Default for dm_core_1 {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// Gives access to files beside a .gltf: to buffers when it is opened, to images when it is exported or a surface is asked for.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_files {
    pub user: *mut c_void,
    /// Hands over the bytes of the file at \`path\`, which is relative to the document, UTF-8, with '/' between folders. The path is never absolute, and has no "..", backslash or colon. Returns DM\_OK, DM\_ERROR\_OUT\_OF\_MEMORY, or any other number when there is no such file.
    pub open: Option<unsafe extern "C" fn(user: *mut c_void, path: *const c_char, out_data: *const *const c_void, out_size: *mut usize) -> i32>,
    /// Takes the bytes back, before dm\_gltf\_close returns.
    pub close: Option<unsafe extern "C" fn(user: *mut c_void, data: *const c_void, size: usize)>,
}

impl Default for dm_gltf_files {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_desc {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// the bytes of a .glb or .gltf; borrowed for the call
    pub data: *const c_void,
    pub size: usize,
    /// zeros = malloc/free
    pub allocator: dm_allocator,
    /// zeros = silent
    pub log: dm_log,
    /// Zeros = none: everything is embedded. \`user\` must live as long as the dm\_gltf.
    pub files: dm_gltf_files,
    /// Callback of dm\_gltf\_open, dm\_gltf\_open\_file and dm\_gltf\_export; NULL = none. A call that it stops answers CANCELLED.
    pub progress: dm_progress_callback,
    /// must live as long as the dm\_gltf
    pub progress_user: *mut c_void,
}

impl Default for dm_gltf_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

/// What moves as one: a node that has a mesh, or a bone of a skin with the triangles that go with it. Vertices and faces are those of the merged mesh. The merged mesh holds the nodes with meshes in file order (the order of the nodes array), and the primitives of a node in order. Its vertices are in the scene's frame less dm\_gltf\_get\_origin, with node transforms applied. Primitives of a node that share an accessor share its vertices. A node with a skin is stored bone by bone, as its bones stand in the file; a vertex goes with its heaviest bone.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_node {
    /// Valid UTF-8, with '?' for each piece that is none; "" when it has none. It lives as long as the dm\_gltf.
    pub name: *const c_char,
    /// index of the node or bone in the file's nodes array; instances come behind them
    pub node: u32,
    /// Index of the nearest dm\_gltf\_node above it, with which it moves, or DM\_GLTF\_NO\_CARRIER.
    pub carrier: u32,
    pub first_vertex: u64,
    pub vertex_count: u64,
    pub first_face: u64,
    pub face_count: u64,
    /// base colour factor of its first material, linear; white without one
    pub colour: [f32; 4],
}

impl Default for dm_gltf_node {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// Faces of the merged mesh that lie side by side and have one material. A dm\_gltf\_node has one or more surfaces.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_surface {
    pub first_face: u64,
    pub face_count: u64,
    /// base colour factor, linear; white without a material
    pub colour: [f32; 4],
    /// The base colour texture as it is stored, in sRGB: PNG, JPEG, or what an extension has. NULL: none. Surfaces with the same image have the same pointer. It lives as long as the dm\_gltf.
    pub image: *const c_void,
    /// bytes
    pub image_size: usize,
    /// DM\_GLTF\_WRAP\_\*
    pub wrap_u: i32,
    /// DM\_GLTF\_WRAP\_\*
    pub wrap_v: i32,
}

impl Default for dm_gltf_surface {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// One animated part: the faces it takes and its key poses (host frame = the file's scene frame, from rest).
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_track {
    /// name of the new node and animation target; NULL = "moving\_part"
    pub name: *const c_char,
    /// face\_count ids of the merged mesh
    pub face_ids: *const u8,
    /// faces with this id move
    pub value: u8,
    pub reserved: [u8; 7],
    /// key\_count poses
    pub poses: *const dm_pose,
    /// seconds, rising
    pub times: *const f32,
    pub key_count: u32,
    pub reserved2: u32,
}

impl Default for dm_gltf_track {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// A mesh to write as one node of a new .glb.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_part {
    pub name: *const c_char,
    /// vertex\_count x 3 numbers, glTF frame
    pub positions: *const f32,
    /// index\_count indices
    pub indices: *const u32,
    pub vertex_count: u64,
    pub index_count: u64,
    /// base colour, linear; clamped to 0 to 1
    pub colour: [f32; 4],
}

impl Default for dm_gltf_part {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

/// The input and the answers of dm\_asset\_create. Everything is borrowed for the call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_rig_desc {
    pub struct_size: u32,
    /// DM\_GLTF\_RIG\_\*
    pub formats: u32,
    /// the nodes that dm\_asset\_create took
    pub nodes: *const dm_asset_node,
    /// all parts that dm\_asset\_get\_part answers; NULL: none
    pub parts: *const dm_asset_part,
    /// all joints that dm\_asset\_get\_joint answers, one a part
    pub joints: *const dm_joint,
    /// what dm\_asset\_get\_node\_parts answers
    pub node_parts: *const u32,
    /// red, green, blue, opacity of each node, linear; NULL: white
    pub colours: *const f32,
    /// name of the asset, UTF-8; NULL: "asset"
    pub name: *const c_char,
    /// name of each part, UTF-8; NULL: that of its first node that has one
    pub part_names: *const *const c_char,
    /// The file whose dm\_gltf\_get\_asset has made the nodes; NULL: there is none. A GLB needs it. Where \`colours\` is NULL, nodes have the colours of the file.
    pub gltf: *mut dm_gltf,
    pub node_count: u32,
    pub part_count: u32,
    /// axes of the asset frame: DM\_AXES\_\*, except DM\_AXES\_CUSTOM
    pub axes: i32,
    /// length of one unit of the asset, m; 0 = 1
    pub unit_in_metres: f32,
    /// density of closed pieces, kg/m³; 0 = 600, wood
    pub density: f32,
    /// thickness of pieces that are open surfaces, m; 0 = 0.003
    pub thickness: f32,
    /// share of a part's weight that holds it back; 0 = 0.1; negative: none
    pub friction: f32,
    /// Seconds in which a part that nothing drives loses 63 % of its speed; 0 = 0.5; negative: no damping.
    pub damping_time: f32,
    /// zeros = malloc/free
    pub allocator: dm_allocator,
    /// zeros = silent; gets warnings of what a format cannot hold
    pub log: dm_log,
}

impl Default for dm_gltf_rig_desc {
    /// Zeros, with struct\_size set.
    fn default() -> Self {
        let mut value: Self = unsafe { core::mem::zeroed() };
        value.struct_size = core::mem::size_of::<Self>() as u32;
        value
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dm_gltf_rig_file {
    /// path below the folder of the rig: letters, digits, '\_', '.', and '/' between folders
    pub path: *const c_char,
    /// lives as long as the dm\_gltf\_rig
    pub data: *const c_void,
    pub size: usize,
}

impl Default for dm_gltf_rig_file {
    /// Zeros.
    fn default() -> Self {
        unsafe { core::mem::zeroed() }
    }
}

#[link(name = "dragmesh")]
extern "C" {
    /// Returns the name of a result, such as "DM\_ERROR\_EMPTY\_MASK", or "DM\_ERROR\_UNKNOWN" for a number that is not one. It never returns NULL. \[any-thread\]
    pub fn dm_result_string(result: dm_result) -> *const c_char;
    /// Returns the version of the library in use, as a number like DM\_VERSION. \[any-thread\]
    pub fn dm_version() -> u32;
    /// Returns the function table of an interface id, or NULL for an unknown one. "dm.core/1" gives a const dm\_core\_1\*. \[any-thread\]
    pub fn dm_get_interface(id: *const c_char) -> *const c_void;
    /// Creates a context. desc NULL stands for all defaults. Errors: UNSUPPORTED when desc.picking asks for a picker that is not there. \[any-thread\]
    pub fn dm_context_create(desc: *const dm_context_desc, out_context: *mut *mut dm_context) -> dm_result;
    /// Destroys a context and everything made with it. NULL does nothing. \[exclusive context\]
    pub fn dm_context_destroy(context: *mut dm_context);
    /// Writes how much memory a context holds. out\_info-\>struct\_size must be set. \[any-thread\]
    pub fn dm_context_get_memory(context: *const dm_context, out_info: *mut dm_memory_info) -> dm_result;
    /// Returns the scratch memory that the context keeps for later calls (dm\_memory\_info.kept\_bytes) to the host's allocator, for instance when a level has loaded. \[any-thread\]
    pub fn dm_context_trim(context: *mut dm_context) -> dm_result;
    /// Loads weights. Errors: BAD\_DATA, WRONG\_MODEL, VERSION. \[any-thread\]
    pub fn dm_model_load(context: *mut dm_context, desc: *const dm_model_desc, out_model: *mut dm_model) -> dm_result;
    /// Frees weights. Objects prepared with them keep their joints, and motions made with them stay; new motions and refinements of such objects answer NO\_MODEL. \[exclusive object\]
    pub fn dm_model_unload(context: *mut dm_context, model: dm_model) -> dm_result;
    /// Finds the part that a point of the surface belongs to, in a mesh whose parts are not known. Writes 1 to out\_face\_ids for every triangle of the part and 0 for the others; as part ids per face they can go into a dm\_mesh\_desc unchanged. The call takes up to tens of milliseconds, and a second for tens of thousands of loose pieces; its time grows at most linearly with their number. mesh-\>part\_ids: pieces known to be rigid, such as the nodes of a scene; the grabbed one moves, together with what is fastened to it alone. With NULL, or with one piece, the part is put together from the mesh's sheets of surface. drag: the point where the part was grabbed, and the direction of the pull; a zero vector means no direction. Errors: those of dm\_object\_prepare for a mesh; BUFFER\_TOO\_SMALL when face\_count is less than the mesh's; DRAG\_OFF\_PART; FULL\_MASK when nothing is left that stays; CANCELLED. \[any-thread\]
    pub fn dm_mesh_find_part(context: *mut dm_context, mesh: *const dm_mesh_desc, drag: *const dm_drag_hint, out_face_ids: *mut u8, face_count: u64) -> dm_result;
    /// Infers how each part of a mesh moves, and makes an object of it. The call takes up to tens of milliseconds for a usual object (docs/performance.md) and uses dm\_jobs. It warns once where the answer is worse than it could be (DM\_DEGRADED\_\*). Errors: NOT\_FINITE, INDEX\_OUT\_OF\_RANGE (also for an answer of desc.choose), EMPTY\_MASK, DEGENERATE\_MESH, ZERO\_DRAG, DRAG\_OFF\_PART, TOO\_LARGE, CANCELLED. \[any-thread\]
    pub fn dm_object_prepare(context: *mut dm_context, desc: *const dm_object_desc, out_object: *mut dm_object) -> dm_result;
    /// Writes a prepared object as .dmo bytes, which are versioned, checksummed and little-endian. Call it with a NULL buffer to learn the size. out\_size gets the bytes needed or written, also with BUFFER\_TOO\_SMALL. Triangles are stored with trees of the library's own, so that loading builds none; where the object has other trees, each call builds the library's. \[exclusive object\]
    pub fn dm_object_save(context: *mut dm_context, object: dm_object, buffer: *mut c_void, capacity: usize, out_size: *mut usize) -> dm_result;
    /// Loads what dm\_object\_save has written, by this or any earlier version. model: the weights of its motions; may be 0. The file's own trees are used where desc.picking of the context is DM\_PICK\_AUTO or DM\_PICK\_PORTABLE (dm\_object\_info.picking). Errors: BAD\_DATA, VERSION, CANCELLED. \[any-thread\]
    pub fn dm_object_load(context: *mut dm_context, data: *const c_void, size: usize, model: dm_model, out_object: *mut dm_object) -> dm_result;
    /// Destroys an object. Its drags and motions end with it, and its instances leave their scenes. \[exclusive object, and none of those in use\]
    pub fn dm_object_destroy(context: *mut dm_context, object: dm_object) -> dm_result;
    /// Writes counts, box and size of an object. out\_info-\>struct\_size must be set. \[any-thread\]
    pub fn dm_object_get_info(context: *mut dm_context, object: dm_object, out_info: *mut dm_object_info) -> dm_result;
    /// Writes the part at a position, 0 to part\_count - 1, in order of id. out\_info-\>struct\_size must be set. \[any-thread\]
    pub fn dm_object_get_part(context: *mut dm_context, object: dm_object, index: u32, out_info: *mut dm_part_info) -> dm_result;
    /// Writes the joint in force: the best hypothesis, or the host's own. out\_joint-\>struct\_size must be set. \[any-thread\]
    pub fn dm_object_get_joint(context: *mut dm_context, object: dm_object, part_id: u32, out_joint: *mut dm_joint) -> dm_result;
    /// Writes the hypotheses of a part, best first. When \`drag\` is given, it re-ranks them, which takes microseconds and no network pass. capacity: up to DM\_MAX\_HYPOTHESES. out\_joints\[0\].struct\_size must be set, and the others get it. out\_count gets how many were written. \[any-thread\]
    pub fn dm_object_get_hypotheses(context: *mut dm_context, object: dm_object, part_id: u32, drag: *const dm_drag_hint, out_joints: *mut dm_joint, capacity: u32, out_count: *mut u32) -> dm_result;
    /// Infers the joint of one part again with the player's drag as evidence, and puts the result in force. It takes milliseconds, so it is not for every frame. Errors: NO\_MODEL; UNSUPPORTED when the object kept no triangles; CANCELLED, which leaves the joint in force. \[exclusive object\]
    pub fn dm_object_refine(context: *mut dm_context, object: dm_object, part_id: u32, drag: *const dm_drag_hint) -> dm_result;
    /// Puts the host's own joint in force. Its axis may have any length, and its limits may be infinite (dm\_joint.lower). Its source becomes DM\_JOINT\_FROM\_HOST and both confidences 1, unless the joint is, bit for bit, the one in force or the library's own answer; it then keeps the source and the confidences of that one. Drags and motions that already run keep the joint they began with. \[exclusive object\]
    pub fn dm_object_set_joint(context: *mut dm_context, object: dm_object, part_id: u32, joint: *const dm_joint) -> dm_result;
    /// Puts the library's own answer back in force, after dm\_object\_set\_joint or a choice. \[exclusive object\]
    pub fn dm_object_reset_joint(context: *mut dm_context, object: dm_object, part_id: u32) -> dm_result;
    /// Replaces all links between parts of an object by copies of these. count: 0, which removes all, to DM\_MAX\_LINKS. A saved object does not hold links. Errors: INVALID\_ARGUMENT also when two drivers move one part, or a part moves itself through other links; NOT\_FOUND. \[exclusive object\]
    pub fn dm_object_set_links(context: *mut dm_context, object: dm_object, links: *const dm_link, count: u32) -> dm_result;
    /// Moves everything that is linked with a part that has moved. inout\_values: the joint values of one instance, one a part, in the order of dm\_object\_get\_part. The value of the moved part itself changes too when a driver of it is at its limit; dm\_drag\_override takes that value. out\_held: gets 1 for each part that links hold where it is (DM\_INPUT\_LOCKED), else 0; may be NULL. count: the number of parts, which is the length of both. The limits are those of the joints in force, for the unscaled instance. \[frame\]
    pub fn dm_object_follow_links(context: *mut dm_context, object: dm_object, part_id: u32, inout_values: *mut f32, out_held: *mut u8, count: u32) -> dm_result;
    /// Infers which nodes of an asset move, which of them move as one, what carries what, and how each part moves. The same nodes in the same order give the same bits. The call takes about as long as dm\_object\_prepare for all of its nodes, and uses dm\_jobs. It warns once where the answer is worse than it could be. Errors, whose messages name the node: NOT\_FINITE, INDEX\_OUT\_OF\_RANGE, DEGENERATE\_MESH, TOO\_LARGE, CANCELLED; INVALID\_ARGUMENT also when parents or followers form a circle, a name is not UTF-8, or no node has a mesh. \[any-thread\]
    pub fn dm_asset_create(context: *mut dm_context, desc: *const dm_asset_desc, out_asset: *mut dm_asset) -> dm_result;
    /// Destroys an asset. Objects made of it stay. \[exclusive object\]
    pub fn dm_asset_destroy(context: *mut dm_context, asset: dm_asset) -> dm_result;
    /// Writes counts and warnings of an asset. out\_info-\>struct\_size must be set. \[any-thread\]
    pub fn dm_asset_get_info(context: *mut dm_context, asset: dm_asset, out_info: *mut dm_asset_info) -> dm_result;
    /// Writes the part at an index, 0 to part\_count - 1. out\_part-\>struct\_size must be set. \[any-thread\]
    pub fn dm_asset_get_part(context: *mut dm_context, asset: dm_asset, index: u32, out_part: *mut dm_asset_part) -> dm_result;
    /// Writes the joint of a part, in the asset frame. For a part that stays, it is the joint by which it would move. out\_joint-\>struct\_size must be set. \[any-thread\]
    pub fn dm_asset_get_joint(context: *mut dm_context, asset: dm_asset, index: u32, out_joint: *mut dm_joint) -> dm_result;
    /// Writes the indices of a part's nodes, rising: dm\_asset\_part.node\_count of them. Errors: BUFFER\_TOO\_SMALL when capacity is less. \[any-thread\]
    pub fn dm_asset_get_part_nodes(context: *mut dm_context, asset: dm_asset, index: u32, out_nodes: *mut u32, capacity: u32) -> dm_result;
    /// Writes the index of the part of each node, or DM\_ASSET\_NO\_PART for nodes of the body: dm\_asset\_info.node\_count numbers. Errors: BUFFER\_TOO\_SMALL when capacity is less. \[any-thread\]
    pub fn dm_asset_get_node_parts(context: *mut dm_context, asset: dm_asset, out_parts: *mut u32, capacity: u32) -> dm_result;
    /// Makes a prepared object of the parts that move or are free. They carry each other as in the asset, and all else is the body. The object has the triangles of the nodes that do not follow others, node after node. Errors: EMPTY\_MASK when nothing moves. \[any-thread\]
    pub fn dm_asset_make_object(context: *mut dm_context, asset: dm_asset, out_object: *mut dm_object) -> dm_result;
    /// Writes the pose of a joint at a value, from rest, in the frame in which the joint is given. The axis may have any length, here and in the functions below. \[frame\]
    pub fn dm_joint_pose(joint: *const dm_joint, value: f32, out_pose: *mut dm_pose) -> dm_result;
    /// Inverts dm\_joint\_pose: writes the value at which the joint comes nearest to a pose. out\_angle\_error gets the angle between both poses, rad. out\_distance\_error gets the distance between the places of the joint's origin under both, host units. Both may be NULL. Of values one turn apart, the answer is the one inside the limits, or else the one nearest to 0; for a screw, its advance decides. Errors: NOT\_FINITE when an answer is beyond a float's range. \[frame\]
    pub fn dm_joint_value(joint: *const dm_joint, pose: *const dm_pose, out_value: *mut f32, out_angle_error: *mut f32, out_distance_error: *mut f32) -> dm_result;
    /// Writes the joint value at a share of the way from rest to the open end, which is the limit farther from rest: 0 is rest, 1 is open, 0.1 is ajar. Errors: INVALID\_ARGUMENT for a joint without limits. \[frame\]
    pub fn dm_joint_value_at(joint: *const dm_joint, share: f32, out_value: *mut f32) -> dm_result;
    /// Writes the joint as a constraint of a physics engine. out\_frame-\>struct\_size must be set. \[frame\]
    pub fn dm_joint_get_frame(joint: *const dm_joint, out_frame: *mut dm_joint_frame) -> dm_result;
    /// Converts a joint to the frame of an instance that is scaled by (x, y, z), as dm\_drag\_begin does. The axis is the line through the scaled points. Limits of slides and the pitch are in scaled units; angles stay as they are. A zero counts as 1. out\_joint-\>struct\_size must be set; it may be \`joint\`. \[frame\]
    pub fn dm_joint_scale(joint: *const dm_joint, scale: dm_vec3, out_joint: *mut dm_joint) -> dm_result;
    /// Generates the DQ-VAE's motion for a drag, projected exactly onto the joint in force. The motion of a fixed part stays at rest. Errors: NO\_MODEL, ZERO\_DRAG, DRAG\_OFF\_PART. \[any-thread\]
    pub fn dm_motion_generate(context: *mut dm_context, object: dm_object, desc: *const dm_motion_desc, out_motion: *mut dm_motion) -> dm_result;
    /// Writes pose and joint value of a motion at t, which is clamped to \[0, 1\]; 0 is rest. Between key poses the part follows the joint's own screw. out\_value may be NULL. \[frame\]
    pub fn dm_motion_sample(context: *mut dm_context, motion: dm_motion, t: f32, out_pose: *mut dm_pose, out_value: *mut f32) -> dm_result;
    /// Writes the DM\_MOTION\_FRAMES key poses and their joint values. out\_values may be NULL. \[frame\]
    pub fn dm_motion_get_frames(context: *mut dm_context, motion: dm_motion, out_poses: *mut dm_pose, out_values: *mut f32) -> dm_result;
    /// Destroys a motion that no other thread samples. \[any-thread\]
    pub fn dm_motion_destroy(context: *mut dm_context, motion: dm_motion) -> dm_result;
    /// Starts a drag: the player grabs a part. Where the library found the joint, the pull is more evidence. The drag holds the part's other hypotheses and likely joints beyond them, and follows the one that explains the pull best. Limits that were estimated give when the pull goes on beyond them. docs/feel.md describes how. The call warns of a grab point or value in other units than expected (millimetres, degrees). \[any-thread\]
    pub fn dm_drag_begin(context: *mut dm_context, desc: *const dm_drag_desc, out_drag: *mut dm_drag) -> dm_result;
    /// Advances a drag by dt seconds. The grabbed point follows the pointer's ray (object frame, scaled with dm\_drag\_desc.scale) as closely as the joint allows. Pass the ray that grabbed the part first. The whole drag keeps the angle by which this ray misses the grab point, up to 0.032 rad, so that the part does not move before the pointer does. A dt from -1e-4 to 0, as clocks round it, counts as 0. After dm\_drag\_release the part moves by itself, and ray may be NULL. out\_state-\>struct\_size must be set. \[frame\]
    pub fn dm_drag_update(context: *mut dm_context, drag: dm_drag, ray: *const dm_ray, dt: f32, out_state: *mut dm_drag_state) -> dm_result;
    /// Does what dm\_drag\_update does, with everything that a dm\_drag\_input holds. A released part needs no hand. Errors: INVALID\_ARGUMENT, also for handles, bounds and DM\_INPUT\_LOCKED of a drag without dm\_drag\_desc.rules. \[frame\]
    pub fn dm_drag_step(context: *mut dm_context, drag: dm_drag, input: *const dm_drag_input, dt: f32, out_state: *mut dm_drag_state) -> dm_result;
    /// Replaces the value that an update with DM\_INPUT\_ASK has proposed in its out\_state. The value is brought inside the limits and bounds of that update, and the events become those of the value taken. Without this call, the update stands. Errors: INVALID\_ARGUMENT when the last update did not ask. \[frame\]
    pub fn dm_drag_take(context: *mut dm_context, drag: dm_drag, value: f32, out_state: *mut dm_drag_state) -> dm_result;
    /// Releases the part, which then does what the player meant: it swings open, falls shut, springs back or stays. The DQ-VAE paces it where the object has its weights, unless desc.flags forbids it. dm\_drag\_update moves it, and dm\_drag\_end may end the drag at any time; another release replaces this one, or replays. desc NULL stands for all defaults. out\_plan may be NULL, else its struct\_size must be set. The call takes up to a millisecond. One caller at a time per drag. \[any-thread\]
    pub fn dm_drag_release(context: *mut dm_context, drag: dm_drag, desc: *const dm_release_desc, out_plan: *mut dm_release_plan) -> dm_result;
    /// Ends a drag and destroys it. out\_state gets what dm\_drag\_get\_part\_state gives; it may be NULL, else its struct\_size must be set. \[any-thread\]
    pub fn dm_drag_end(context: *mut dm_context, drag: dm_drag, out_state: *mut dm_part_state) -> dm_result;
    /// Writes where the part stands, and the joint that the drag follows now, with the limits and the confidence that the pull has left it. A drag that begins with this state as dm\_drag\_desc.state goes on where this one is. out\_state-\>struct\_size must be set. \[frame\]
    pub fn dm_drag_get_part_state(context: *mut dm_context, drag: dm_drag, out_state: *mut dm_part_state) -> dm_result;
    /// Returns how many bytes dm\_drag\_save writes. The number is the same for every drag of this library, and DM\_DRAG\_SNAPSHOT\_MAX at most. \[any-thread\]
    pub fn dm_drag_snapshot_size() -> usize;
    /// Writes the whole state of a drag, for rollback. After dm\_drag\_restore, the same calls give the same bits. Only this very version of the library on this kind of machine can read it; dm\_part\_state is what lasts. Errors: BUFFER\_TOO\_SMALL when capacity is less than dm\_drag\_snapshot\_size. \[frame\]
    pub fn dm_drag_save(context: *mut dm_context, drag: dm_drag, buffer: *mut c_void, capacity: usize) -> dm_result;
    /// Restores a state that dm\_drag\_save has written, of this or any other drag of the same part. An error leaves the drag as it is: BAD\_DATA, VERSION, or INVALID\_ARGUMENT when the state belongs to another part. \[frame\]
    pub fn dm_drag_restore(context: *mut dm_context, drag: dm_drag, data: *const c_void, size: usize) -> dm_result;
    /// Writes the pose that applies b first and then a: x -\> a(b(x)). out\_pose may be \`a\` or \`b\`. \[frame\]
    pub fn dm_pose_multiply(a: *const dm_pose, b: *const dm_pose, out_pose: *mut dm_pose);
    /// Writes the inverse of a pose, which takes the points that the pose has moved back. out\_pose may be \`pose\`. \[frame\]
    pub fn dm_pose_inverse(pose: *const dm_pose, out_pose: *mut dm_pose);
    /// Writes the pose that rotates first and then translates, as engines keep the place of a node. rotation: a quaternion x, y, z, w of any length. Errors: INVALID\_ARGUMENT when it has no length; NOT\_FINITE. \[frame\]
    pub fn dm_pose_from_rotation(rotation: *const f32, translation: dm_vec3, out_pose: *mut dm_pose) -> dm_result;
    /// Writes a pose as a 4x4 matrix, column-major for column vectors (the memory order of OpenGL, glTF and Unity's Matrix4x4). \[frame\]
    pub fn dm_pose_to_matrix(pose: *const dm_pose, out_matrix: *mut f32);
    /// Moves \`count\` float32 points by a pose. Strides are in bytes, and 0 means packed. src may equal dst. \[frame\]
    pub fn dm_pose_apply_points(pose: *const dm_pose, src: *const f32, src_stride: usize, dst: *mut f32, dst_stride: usize, count: usize);
    /// Writes the ray through pixel (x, y) in the host's world frame; (0, 0) is the top left corner of the viewport. Its direction is a unit vector. Errors: INVALID\_ARGUMENT when the camera has no view; NOT\_FINITE when the ray's origin is beyond a float's range. \[frame\]
    pub fn dm_camera_ray(context: *const dm_context, camera: *const dm_camera, x: f32, y: f32, out_ray: *mut dm_ray) -> dm_result;
    /// Creates an empty scene. Errors: UNSUPPORTED when the context picks nothing (DM\_PICK\_NONE, or no picker was found). \[any-thread\]
    pub fn dm_scene_create(context: *mut dm_context, desc: *const dm_scene_desc, out_scene: *mut dm_scene) -> dm_result;
    /// Destroys a scene with its instances. Their objects stay. \[exclusive object\]
    pub fn dm_scene_destroy(context: *mut dm_context, scene: dm_scene) -> dm_result;
    /// Places a prepared object in a scene, from the next dm\_scene\_commit on. placement: pose from the object frame to the world; NULL = identity. out\_instance gets a small number from 0 on, which may be used again after a removal. Errors: UNSUPPORTED when the object cannot be picked, because it kept no triangles, or is smaller than 1e-6 or larger than 1e12 host units. \[exclusive object\]
    pub fn dm_scene_add(context: *mut dm_context, scene: dm_scene, object: dm_object, placement: *const dm_pose, out_instance: *mut u32) -> dm_result;
    /// Moves a part of an instance to a pose from rest, in the object frame, which includes the pose of the parts that carry it. With part\_id 0 it moves the whole instance to a new placement. The move takes effect with dm\_scene\_commit. \[frame\]
    pub fn dm_scene_move(context: *mut dm_context, scene: dm_scene, instance: u32, part_id: u32, pose: *const dm_pose) -> dm_result;
    /// Removes an instance from a scene, at once. \[exclusive object\]
    pub fn dm_scene_remove(context: *mut dm_context, scene: dm_scene, instance: u32) -> dm_result;
    /// Makes all moves since the last commit visible to picks. Call it once a frame, after the moves. \[frame\]
    pub fn dm_scene_commit(context: *mut dm_context, scene: dm_scene) -> dm_result;
    /// Finds the nearest hit of a ray. The answer is DM\_OK with out\_hit-\>object 0 when nothing is hit. Several threads may pick at once while none moves or commits. out\_hit-\>struct\_size must be set. \[frame\]
    pub fn dm_scene_pick(context: *mut dm_context, scene: dm_scene, ray: *const dm_ray, out_hit: *mut dm_hit) -> dm_result;
}
/// dm\_drag\_update\_input is the name of dm\_drag\_step for new code. dm\_core\_1 and the exports have dm\_drag\_step.
pub use self::dm_drag_step as dm_drag_update_input;
/// dm\_drag\_override is the name of dm\_drag\_take for new code. dm\_core\_1 and the exports have dm\_drag\_take.
pub use self::dm_drag_take as dm_drag_override;

#[cfg(feature = "gltf")]
#[link(name = "dragmesh_gltf")]
extern "C" {
    /// Returns the version of the libdragmesh\_gltf in use, as a number like DM\_VERSION.
    pub fn dm_gltf_version() -> u32;
    /// Opens the bytes of a .glb or .gltf. Reads triangles, strips and fans, also quantised ones (KHR\_mesh\_quantization) and, where the build has their libraries, compressed ones (EXT\_meshopt\_compression, KHR\_meshopt\_compression, KHR\_draco\_mesh\_compression). Another required extension that may change geometry is refused as UNSUPPORTED, by name. Morph targets are applied as the file's weights say. An instance of EXT\_mesh\_gpu\_instancing becomes a node of its own, behind those of the file, below the node that has the extension. These are left out with a warning: triangles whose vertices do not exist or are not finite, broken primitives, points, lines, and nodes whose scale is zero. These are left out in silence, because they are no body: nodes and meshes named UCX\_\*, UBX\_\*, UCP\_\*, USP\_\*, \*\_collider, \*-colonly, \*-convcolonly; coarser levels of detail (MSFT\_lod, or siblings named \*\_LOD0, \*\_LOD1); invisible nodes (KHR\_node\_visibility); and materials of alpha 0. A call logs one warning, which counts what is left out and quotes the first three. Errors: when nothing is left, the first reason: BAD\_DATA, NOT\_FINITE, INDEX\_OUT\_OF\_RANGE or DEGENERATE\_MESH; NOT\_FOUND for a file beside it; VERSION; TOO\_LARGE when it would take more memory than 64 MB and 64 bytes a byte of the file, or 256 a byte of a Draco stream.
    pub fn dm_gltf_open(desc: *const dm_gltf_desc, out_gltf: *mut *mut dm_gltf) -> dm_result;
    /// Opens a file and those beside it, which are read from its folder and from nowhere else. \`desc\` leaves data, size and files at 0. Errors: those of dm\_gltf\_open; NOT\_FOUND when there is no such regular file.
    pub fn dm_gltf_open_file(path: *const c_char, desc: *const dm_gltf_desc, out_gltf: *mut *mut dm_gltf) -> dm_result;
    /// Closes a file and frees all that points into it. NULL does nothing.
    pub fn dm_gltf_close(gltf: *mut dm_gltf);
    /// Returns how many nodes there are, and 0 for NULL.
    pub fn dm_gltf_node_count(gltf: *const dm_gltf) -> u32;
    /// Writes the node at an index. Errors: INVALID\_ARGUMENT, NOT\_FOUND.
    pub fn dm_gltf_get_node(gltf: *const dm_gltf, index: u32, out_node: *mut dm_gltf_node) -> dm_result;
    /// Writes the merged mesh, which points into the dm\_gltf: positions as float32, indices as uint32, no part ids.
    pub fn dm_gltf_get_mesh(gltf: *const dm_gltf, out_mesh: *mut dm_mesh_desc) -> dm_result;
    /// Writes where the merged mesh's origin is in the scene. It is 0, 0, 0 unless the object is more than 256 times its size away, where floats could not hold its shape.
    pub fn dm_gltf_get_origin(gltf: *const dm_gltf, out_origin: *mut f64);
    /// Returns how many surfaces there are, and 0 for NULL.
    pub fn dm_gltf_surface_count(gltf: *const dm_gltf) -> u32;
    /// Writes the surface at an index. An image that cannot be read is left out with a warning. Errors: NOT\_FOUND, OUT\_OF\_MEMORY.
    pub fn dm_gltf_get_surface(gltf: *mut dm_gltf, index: u32, out_surface: *mut dm_gltf_surface) -> dm_result;
    /// Writes where the corners of a surface lie in its base colour texture: u and v of each, three corners a face, in the order of the merged mesh. (0, 0) is the image's top left corner. They are scaled, turned and shifted as the material says (KHR\_texture\_transform). corner\_count: three times face\_count. Errors: NOT\_FOUND when there is no texture, or there are no coordinates; BUFFER\_TOO\_SMALL, BAD\_DATA, OUT\_OF\_MEMORY.
    pub fn dm_gltf_get_texture_coordinates(gltf: *mut dm_gltf, index: u32, out_uv: *mut f32, corner_count: u64) -> dm_result;
    /// Sets \`value\` for every face of the named nodes or bones and of all that they carry. A name that several nodes share means all of them. The name of a node with a skin means all its bones. "#12" means node 12 of the file, for files without names. Errors: NOT\_FOUND, whose message has the first missing name and some that exist.
    pub fn dm_gltf_mark_faces(gltf: *const dm_gltf, names: *const *const c_char, name_count: u32, value: u8, inout_face_ids: *mut u8, face_count: u64) -> dm_result;
    /// Writes what the file says of a node, as dm\_part\_desc takes it. The label has the names of the nodes that carry it, outermost first, of its mesh and its own, joined by '/'. The pivot has its origin and axes in the merged mesh's frame. name: as for dm\_gltf\_mark\_faces; of several nodes, the first counts. out\_label: label\_size bytes, from which the outer names are left out where not all fit; may be NULL. out\_pivot may be NULL. Errors: NOT\_FOUND.
    pub fn dm_gltf_get_hints(gltf: *const dm_gltf, name: *const c_char, out_label: *mut c_char, label_size: usize, out_pivot: *mut dm_pivot) -> dm_result;
    /// Writes the scene as dm\_asset\_create takes it: all nodes that have triangles or carry some, and nodes that the merged mesh leaves out because they are no body. First come the dm\_gltf\_nodes in their order, then groups without triangles, then what is hidden, a collider or a coarser level of detail (DM\_ASSET\_NODE\_FOLLOWS). Meshes are in the merged mesh's frame, so that transforms are NULL. Clips are the file's animations, each relative to the node above it. Joints are those of the nodes' \`extras\` and of KHR\_physics\_rigid\_bodies (docs/gltf.md). flags: 0. The list points into the dm\_gltf. Errors: OUT\_OF\_MEMORY, TOO\_LARGE.
    pub fn dm_gltf_get_asset(gltf: *mut dm_gltf, flags: u32, out_nodes: *const *const dm_asset_node, out_count: *mut u32) -> dm_result;
    /// Writes the index in the file's nodes array of a node of that list. Errors: those of dm\_gltf\_get\_asset; NOT\_FOUND.
    pub fn dm_gltf_get_asset_node(gltf: *mut dm_gltf, index: u32, out_node: *mut u32) -> dm_result;
    /// Returns 1 when pivots say nothing: the file has several dm\_gltf\_nodes, and the origins of all follow one rule, as exporters leave them. They are one point, or lie at the same place of each node's box (middle, lowest corner, middle of a face …). Returns 0 when some may say something, or gltf is NULL.
    pub fn dm_gltf_pivots_are_lost(gltf: *const dm_gltf) -> i32;
    /// Writes how a node's pivot came to lie where it is (DM\_PIVOT\_\*), for dm\_part\_desc.pivot\_kind. A rule holds where the node with the largest surface and more than half of all nodes follow it. The answer is then DM\_PIVOT\_DEFAULT for a node that follows it and DM\_PIVOT\_SET for the others. It is DM\_PIVOT\_UNKNOWN when no rule holds, or the node has no triangles. name: as for dm\_gltf\_get\_hints. Errors: NOT\_FOUND.
    pub fn dm_gltf_get_pivot_kind(gltf: *const dm_gltf, name: *const c_char, out_kind: *mut i32) -> dm_result;
    /// Returns 1 when triangles of the file are missing in the merged mesh, because a triangle, a primitive or a node could not be read, or only one of its instances was. Warnings of dm\_gltf\_open name them. Pass DM\_PREPARE\_MESH\_INCOMPLETE then. Returns 0 when all are there, or gltf is NULL.
    pub fn dm_gltf_left_out(gltf: *const dm_gltf) -> i32;
    /// Reads a part mask: a .npy or JSON array with one integer a vertex or a face, in the order of the file where bones sort the merged mesh otherwise. mask\_value: the value of the part that moves; NULL = every value but 0. out\_part\_ids: as many bytes as max(vertex\_count, face\_count). out\_ambiguous: gets 1 when both lengths fit, and the integers were taken per vertex; may be NULL. Errors: BAD\_DATA; INVALID\_ARGUMENT when neither length fits; EMPTY\_MASK; FULL\_MASK.
    pub fn dm_gltf_read_mask(gltf: *const dm_gltf, data: *const c_void, size: usize, mask_value: *const i64, out_part_ids: *mut u8, out_scope: *mut i32, out_ambiguous: *mut i32) -> dm_result;
    /// Writes a .glb with the file's meshes and materials. The tracks' faces are split off into nodes of their own, which a looping animation moves. Without tracks it adds no animation. The file's own animations stay as they are, and still move the nodes that they name. Release out\_data with dm\_gltf\_release\_bytes.
    pub fn dm_gltf_export(gltf: *const dm_gltf, tracks: *const dm_gltf_track, track_count: u32, out_data: *mut *mut c_void, out_size: *mut usize) -> dm_result;
    /// Releases bytes of dm\_gltf\_export, with the allocator of the dm\_gltf.
    pub fn dm_gltf_release_bytes(gltf: *const dm_gltf, data: *mut c_void, size: usize);
    /// Writes a static .glb with one identity node a part. allocator: zeros = malloc/free; release out\_data with the same.
    pub fn dm_gltf_write(parts: *const dm_gltf_part, part_count: u32, allocator: *const dm_allocator, log: *const dm_log, out_data: *mut *mut c_void, out_size: *mut usize) -> dm_result;
    /// Makes any text valid UTF-8, in place: it puts a '?' for each piece that is no character, also for one that was cut off. Names and messages of this library are valid already; hosts need it for what they write beside them. Returns the new length, which is never longer, and 0 for NULL.
    pub fn dm_gltf_mend_text(text: *mut c_char) -> usize;
    /// Makes the files of all formats asked for in memory, with the meshes that they share. Parts that move become bodies, in metres and Z up, hung on what carries them. Parts that stay, and fixed ones, are one with it. Bodies are called part\_N\_NAME, where N is the part's index + 1 and NAME what is legal of its first node's name; the body that stays is "body". Errors: those of the meshes, NOT\_FINITE, INVALID\_ARGUMENT (no format, parents in a circle), INDEX\_OUT\_OF\_RANGE, DEGENERATE\_MESH (no triangle), OUT\_OF\_MEMORY, STRUCT\_SIZE.
    pub fn dm_gltf_rig_make(desc: *const dm_gltf_rig_desc, out_rig: *mut *mut dm_gltf_rig) -> dm_result;
    /// Frees the files. NULL does nothing.
    pub fn dm_gltf_rig_destroy(rig: *mut dm_gltf_rig);
    /// Returns how many files there are, and 0 for NULL.
    pub fn dm_gltf_rig_file_count(rig: *const dm_gltf_rig) -> u32;
    /// Writes the path and the bytes of a file. Meshes come before the files that refer to them. Errors: INVALID\_ARGUMENT, NOT\_FOUND.
    pub fn dm_gltf_rig_get_file(rig: *const dm_gltf_rig, index: u32, out_file: *mut dm_gltf_rig_file) -> dm_result;
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::mem::size_of;

    macro_rules! check {
        ($name:ident, $size:expr $(, $field:ident $offset:expr)*) => {
            let value = $name::default();
            let start = &value as *const _ as usize;
            assert_eq!(size_of::<$name>(), $size, stringify!($name));
            $(assert_eq!(core::ptr::addr_of!(value.$field) as usize - start, $offset, stringify!($name, $field));)*
        };
    }

    #[test]
    #[cfg(target_pointer_width = "64")]
    fn layouts_are_those_of_c() {
        check!(dm_vec3, 12, x 0, y 4, z 8);
        check!(dm_pose, 32, real 0, dual 16);
        check!(dm_ray, 24, origin 0, direction 12);
        check!(dm_allocator, 24, user 0, allocate 8, release 16);
        check!(dm_log, 16, user 0, message 8);
        check!(dm_jobs, 16, user 0, parallel_for 8);
        check!(dm_context_desc, 136, struct_size 0, axes 4, unit_in_metres 8, custom_axes 12, allocator 48, log 72, jobs 88, picking 104, reserved 108, progress 112, progress_user 120, kept_bytes 128);
        check!(dm_memory_info, 48, struct_size 0, reserved 4, bytes 8, peak_bytes 16, allocations 24, pick_bytes 32, kept_bytes 40);
        check!(dm_model_desc, 56, struct_size 0, kinematics 8, kinematics_size 16, motion 24, motion_size 32, ranker 40, ranker_size 48);
        check!(dm_mesh_desc, 96, struct_size 0, position_stride 4, positions 8, vertex_count 16, position_bytes 24, indices 32, index_count 40, index_bytes 48, part_ids 56, part_id_bytes 64, part_id_stride 72, position_format 76, index_format 80, part_id_format 84, part_id_scope 88, reserved 92);
        check!(dm_drag_hint, 24, point 0, vector 12);
        check!(dm_pivot, 48, origin 0, axes 12);
        check!(dm_part_desc, 48, struct_size 0, id 4, parent 8, joint_type 12, drag 16, label 24, pivot 32, pivot_kind 40, reserved 44);
        check!(dm_joint, 76, struct_size 0, type_ 4, type_confidence 8, joint_confidence 12, pitch 16, axis 20, origin 32, lower 44, upper 48, source 52, evidence 56, closed 72);
        check!(dm_joint_frame, 88, struct_size 0, type_ 4, origin 8, x 20, y 32, z 44, rotation 56, lower 72, upper 76, limits 80, pitch 84);
        check!(dm_part_state, 124, struct_size 0, value 4, velocity 8, status 12, pose 16, joint 48);
        check!(dm_part_info, 56, struct_size 0, id 4, parent 8, triangle_count 12, box_min 16, box_max 28, centre 40, area 52);
        check!(dm_joint_end, 72, value 0, pose 4, box_min 36, box_max 48, centre 60);
        check!(dm_hypothesis, 160, struct_size 0, reserved 4, joint 8, ends 16);
        check!(dm_choice, 24, struct_size 0, count 4, part 8, hypotheses 16);
        check!(dm_object_desc, 120, struct_size 0, flags 4, mesh 8, parts 16, part_count 24, reserved 28, model 32, seed 40, intent 48, intent_user 56, progress 64, progress_user 72, label 80, up 88, choose 104, choose_user 112);
        check!(dm_object_info, 64, struct_size 0, part_count 4, vertex_count 8, triangle_count 16, box_min 24, box_max 36, size 48, pickable 52, degraded 56, picking 60);
        check!(dm_asset_clip, 32, name 0, times 8, poses 16, key_count 24, flags 28);
        check!(dm_asset_node, 80, struct_size 0, flags 4, parent 8, follows 12, name 16, mesh_name 24, mesh 32, transform 40, pivot 48, clips 56, clip_count 64, reserved 68, joint 72);
        check!(dm_asset_desc, 80, struct_size 0, flags 4, nodes 8, label 16, node_count 24, min_moves 28, model 32, seed 40, progress 48, progress_user 56, up 64, reserved 76);
        check!(dm_asset_info, 32, struct_size 0, node_count 4, part_count 8, moving_count 12, triangle_count 16, degraded 24, warnings 28);
        check!(dm_asset_part, 64, struct_size 0, parent 4, part_id 8, state 12, basis 16, moves 20, node_count 24, triangle_count 28, duration 32, reserved 36, box_min 40, box_max 52);
        check!(dm_motion_desc, 48, struct_size 0, part_id 4, drag 8, path 32, path_count 40, seed 44);
        check!(dm_drag_feel, 24, smoothing_time 0, soft_limit 4, coast_time 8, detent 12, detent_pull 16, return_time 20);
        check!(dm_drag_rules, 88, struct_size 0, flags 4, snaps 8, snap_count 16, snap_reach 20, open_share 24, closed_share 28, event_time 32, max_speed 36, max_acceleration 40, lock_give 44, latch_turn 48, auto_close_share 52, auto_close_time 56, close_delay 60, tip_share 64, fall_time 68, restitution 72, break_distance 76, drive_speed 80, reserved 84);
        check!(dm_link, 28, driver 0, driven 4, kind 8, flags 12, ratio 16, offset 20, from 24);
        check!(dm_drag_desc, 96, struct_size 0, part_id 4, object 8, grab_point 16, start_value 28, feel 32, flags 56, limit_give 60, state 64, scale 72, reserved 84, rules 88);
        check!(dm_hand, 56, kind 0, ray 4, point 28, amount 40, grab_point 44);
        check!(dm_drag_input, 136, struct_size 0, flags 4, hand 8, second 64, handles 120, lower 128, upper 132);
        check!(dm_drag_state, 100, struct_size 0, pose 4, grab_point 36, value 48, target 52, velocity 56, at_limit 60, phase 64, changes 68, events 72, detents 76, impact 80, status 84, joint_confidence 88, joint_basis 92, open_share 96);
        check!(dm_release_desc, 32, struct_size 0, intent 4, duration 8, seed 12, flags 16, away_from 20);
        check!(dm_release_plan, 24, struct_size 0, intent 4, start_value 8, end_value 12, duration 16, from_network 20);
        check!(dm_camera, 56, struct_size 0, fov_y 4, eye 8, forward 20, up 32, viewport_width 44, viewport_height 48, ortho_height 52);
        check!(dm_scene_desc, 8, struct_size 0, reserved 4);
        check!(dm_hit, 72, struct_size 0, instance 4, object 8, part_id 16, triangle 20, distance 24, u 28, v 32, point 36, normal 48, object_point 60);
        check!(dm_core_1, 504, struct_size 0, reserved 4, result_string 8, version 16, context_create 24, context_destroy 32, context_get_memory 40, model_load 48, model_unload 56, mesh_find_part 64, object_prepare 72, object_save 80, object_load 88, object_destroy 96, object_get_info 104, object_get_part 112, object_get_joint 120, object_get_hypotheses 128, object_refine 136, object_set_joint 144, object_reset_joint 152, joint_pose 160, joint_value 168, joint_get_frame 176, joint_scale 184, motion_generate 192, motion_sample 200, motion_get_frames 208, motion_destroy 216, drag_begin 224, drag_update 232, drag_release 240, drag_end 248, drag_get_part_state 256, drag_snapshot_size 264, drag_save 272, drag_restore 280, pose_multiply 288, pose_to_matrix 296, pose_apply_points 304, camera_ray 312, scene_create 320, scene_destroy 328, scene_add 336, scene_move 344, scene_remove 352, scene_commit 360, scene_pick 368, drag_step 376, drag_take 384, object_set_links 392, object_follow_links 400, joint_value_at 408, pose_inverse 416, pose_from_rotation 424, asset_create 432, asset_destroy 440, asset_get_info 448, asset_get_part 456, asset_get_joint 464, asset_get_part_nodes 472, asset_get_node_parts 480, asset_make_object 488, context_trim 496);
        check!(dm_gltf_files, 24, user 0, open 8, close 16);
        check!(dm_gltf_desc, 104, struct_size 0, reserved 4, data 8, size 16, allocator 24, log 48, files 64, progress 88, progress_user 96);
        check!(dm_gltf_node, 64, name 0, node 8, carrier 12, first_vertex 16, vertex_count 24, first_face 32, face_count 40, colour 48);
        check!(dm_gltf_surface, 56, first_face 0, face_count 8, colour 16, image 32, image_size 40, wrap_u 48, wrap_v 52);
        check!(dm_gltf_track, 48, name 0, face_ids 8, value 16, reserved 17, poses 24, times 32, key_count 40, reserved2 44);
        check!(dm_gltf_part, 56, name 0, positions 8, indices 16, vertex_count 24, index_count 32, colour 40);
        check!(dm_gltf_rig_desc, 144, struct_size 0, formats 4, nodes 8, parts 16, joints 24, node_parts 32, colours 40, name 48, part_names 56, gltf 64, node_count 72, part_count 76, axes 80, unit_in_metres 84, density 88, thickness 92, friction 96, damping_time 100, allocator 104, log 128);
        check!(dm_gltf_rig_file, 24, path 0, data 8, size 16);
    }

    #[test]
    #[cfg(target_pointer_width = "32")]
    fn layouts_are_those_of_c() {
        check!(dm_vec3, 12, x 0, y 4, z 8);
        check!(dm_pose, 32, real 0, dual 16);
        check!(dm_ray, 24, origin 0, direction 12);
        check!(dm_allocator, 12, user 0, allocate 4, release 8);
        check!(dm_log, 8, user 0, message 4);
        check!(dm_jobs, 8, user 0, parallel_for 4);
        check!(dm_context_desc, 104, struct_size 0, axes 4, unit_in_metres 8, custom_axes 12, allocator 48, log 60, jobs 68, picking 76, reserved 80, progress 84, progress_user 88, kept_bytes 96);
        check!(dm_memory_info, 48, struct_size 0, reserved 4, bytes 8, peak_bytes 16, allocations 24, pick_bytes 32, kept_bytes 40);
        check!(dm_model_desc, 28, struct_size 0, kinematics 4, kinematics_size 8, motion 12, motion_size 16, ranker 20, ranker_size 24);
        check!(dm_mesh_desc, 96, struct_size 0, position_stride 4, positions 8, vertex_count 16, position_bytes 24, indices 32, index_count 40, index_bytes 48, part_ids 56, part_id_bytes 64, part_id_stride 72, position_format 76, index_format 80, part_id_format 84, part_id_scope 88, reserved 92);
        check!(dm_drag_hint, 24, point 0, vector 12);
        check!(dm_pivot, 48, origin 0, axes 12);
        check!(dm_part_desc, 36, struct_size 0, id 4, parent 8, joint_type 12, drag 16, label 20, pivot 24, pivot_kind 28, reserved 32);
        check!(dm_joint, 76, struct_size 0, type_ 4, type_confidence 8, joint_confidence 12, pitch 16, axis 20, origin 32, lower 44, upper 48, source 52, evidence 56, closed 72);
        check!(dm_joint_frame, 88, struct_size 0, type_ 4, origin 8, x 20, y 32, z 44, rotation 56, lower 72, upper 76, limits 80, pitch 84);
        check!(dm_part_state, 124, struct_size 0, value 4, velocity 8, status 12, pose 16, joint 48);
        check!(dm_part_info, 56, struct_size 0, id 4, parent 8, triangle_count 12, box_min 16, box_max 28, centre 40, area 52);
        check!(dm_joint_end, 72, value 0, pose 4, box_min 36, box_max 48, centre 60);
        check!(dm_hypothesis, 156, struct_size 0, reserved 4, joint 8, ends 12);
        check!(dm_choice, 16, struct_size 0, count 4, part 8, hypotheses 12);
        check!(dm_object_desc, 80, struct_size 0, flags 4, mesh 8, parts 12, part_count 16, reserved 20, model 24, seed 32, intent 40, intent_user 44, progress 48, progress_user 52, label 56, up 60, choose 72, choose_user 76);
        check!(dm_object_info, 64, struct_size 0, part_count 4, vertex_count 8, triangle_count 16, box_min 24, box_max 36, size 48, pickable 52, degraded 56, picking 60);
        check!(dm_asset_clip, 20, name 0, times 4, poses 8, key_count 12, flags 16);
        check!(dm_asset_node, 52, struct_size 0, flags 4, parent 8, follows 12, name 16, mesh_name 20, mesh 24, transform 28, pivot 32, clips 36, clip_count 40, reserved 44, joint 48);
        check!(dm_asset_desc, 64, struct_size 0, flags 4, nodes 8, label 12, node_count 16, min_moves 20, model 24, seed 32, progress 40, progress_user 44, up 48, reserved 60);
        check!(dm_asset_info, 32, struct_size 0, node_count 4, part_count 8, moving_count 12, triangle_count 16, degraded 24, warnings 28);
        check!(dm_asset_part, 64, struct_size 0, parent 4, part_id 8, state 12, basis 16, moves 20, node_count 24, triangle_count 28, duration 32, reserved 36, box_min 40, box_max 52);
        check!(dm_motion_desc, 44, struct_size 0, part_id 4, drag 8, path 32, path_count 36, seed 40);
        check!(dm_drag_feel, 24, smoothing_time 0, soft_limit 4, coast_time 8, detent 12, detent_pull 16, return_time 20);
        check!(dm_drag_rules, 84, struct_size 0, flags 4, snaps 8, snap_count 12, snap_reach 16, open_share 20, closed_share 24, event_time 28, max_speed 32, max_acceleration 36, lock_give 40, latch_turn 44, auto_close_share 48, auto_close_time 52, close_delay 56, tip_share 60, fall_time 64, restitution 68, break_distance 72, drive_speed 76, reserved 80);
        check!(dm_link, 28, driver 0, driven 4, kind 8, flags 12, ratio 16, offset 20, from 24);
        check!(dm_drag_desc, 88, struct_size 0, part_id 4, object 8, grab_point 16, start_value 28, feel 32, flags 56, limit_give 60, state 64, scale 68, reserved 80, rules 84);
        check!(dm_hand, 56, kind 0, ray 4, point 28, amount 40, grab_point 44);
        check!(dm_drag_input, 136, struct_size 0, flags 4, hand 8, second 64, handles 120, lower 128, upper 132);
        check!(dm_drag_state, 100, struct_size 0, pose 4, grab_point 36, value 48, target 52, velocity 56, at_limit 60, phase 64, changes 68, events 72, detents 76, impact 80, status 84, joint_confidence 88, joint_basis 92, open_share 96);
        check!(dm_release_desc, 32, struct_size 0, intent 4, duration 8, seed 12, flags 16, away_from 20);
        check!(dm_release_plan, 24, struct_size 0, intent 4, start_value 8, end_value 12, duration 16, from_network 20);
        check!(dm_camera, 56, struct_size 0, fov_y 4, eye 8, forward 20, up 32, viewport_width 44, viewport_height 48, ortho_height 52);
        check!(dm_scene_desc, 8, struct_size 0, reserved 4);
        check!(dm_hit, 72, struct_size 0, instance 4, object 8, part_id 16, triangle 20, distance 24, u 28, v 32, point 36, normal 48, object_point 60);
        check!(dm_core_1, 256, struct_size 0, reserved 4, result_string 8, version 12, context_create 16, context_destroy 20, context_get_memory 24, model_load 28, model_unload 32, mesh_find_part 36, object_prepare 40, object_save 44, object_load 48, object_destroy 52, object_get_info 56, object_get_part 60, object_get_joint 64, object_get_hypotheses 68, object_refine 72, object_set_joint 76, object_reset_joint 80, joint_pose 84, joint_value 88, joint_get_frame 92, joint_scale 96, motion_generate 100, motion_sample 104, motion_get_frames 108, motion_destroy 112, drag_begin 116, drag_update 120, drag_release 124, drag_end 128, drag_get_part_state 132, drag_snapshot_size 136, drag_save 140, drag_restore 144, pose_multiply 148, pose_to_matrix 152, pose_apply_points 156, camera_ray 160, scene_create 164, scene_destroy 168, scene_add 172, scene_move 176, scene_remove 180, scene_commit 184, scene_pick 188, drag_step 192, drag_take 196, object_set_links 200, object_follow_links 204, joint_value_at 208, pose_inverse 212, pose_from_rotation 216, asset_create 220, asset_destroy 224, asset_get_info 228, asset_get_part 232, asset_get_joint 236, asset_get_part_nodes 240, asset_get_node_parts 244, asset_make_object 248, context_trim 252);
        check!(dm_gltf_files, 12, user 0, open 4, close 8);
        check!(dm_gltf_desc, 56, struct_size 0, reserved 4, data 8, size 12, allocator 16, log 28, files 36, progress 48, progress_user 52);
        check!(dm_gltf_node, 64, name 0, node 4, carrier 8, first_vertex 16, vertex_count 24, first_face 32, face_count 40, colour 48);
        check!(dm_gltf_surface, 48, first_face 0, face_count 8, colour 16, image 32, image_size 36, wrap_u 40, wrap_v 44);
        check!(dm_gltf_track, 32, name 0, face_ids 4, value 8, reserved 9, poses 16, times 20, key_count 24, reserved2 28);
        check!(dm_gltf_part, 48, name 0, positions 4, indices 8, vertex_count 16, index_count 24, colour 32);
        check!(dm_gltf_rig_desc, 92, struct_size 0, formats 4, nodes 8, parts 12, joints 16, node_parts 20, colours 24, name 28, part_names 32, gltf 36, node_count 40, part_count 44, axes 48, unit_in_metres 52, density 56, thickness 60, friction 64, damping_time 68, allocator 72, log 84);
        check!(dm_gltf_rig_file, 12, path 0, data 4, size 8);
    }
}
