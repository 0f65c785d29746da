// The C interface of dragmesh. Written by scripts/describe from the public headers: not to be edited.
using System;
using System.Runtime.InteropServices;

namespace DragMesh
{
    /// <summary>The constants of the C header, under its names.</summary>
    public static class Constants
    {
        public const int DM_VERSION_MAJOR = 0;
        public const int DM_VERSION_MINOR = 4;
        public const int DM_VERSION_PATCH = 0;
        /// <summary>It is 1 while the version that the three numbers name is in development, and 0 in its release.</summary>
        public const int DM_VERSION_DEVELOPMENT = 1;
        /// <summary>Number of key poses of a generated motion (paper: T).</summary>
        public const int DM_MOTION_FRAMES = 16;
        /// <summary>Most hypotheses kept for one part.</summary>
        public const int DM_MAX_HYPOTHESES = 8;
        /// <summary>Most parts of one object, without the body.</summary>
        public const int DM_MAX_PARTS = 4096;
        /// <summary>Most nodes of one asset. At most DM_MAX_PARTS of them may have a mesh and not the flag DM_ASSET_NODE_FOLLOWS.</summary>
        public const int DM_MAX_ASSET_NODES = 65536;
        /// <summary>Most bytes of a label, without the terminating zero.</summary>
        public const int DM_MAX_LABEL = 4096;
        /// <summary>Most vertices or triangles of one object.</summary>
        public const int DM_MAX_ELEMENTS = 268435456;
        /// <summary>Most links of one object.</summary>
        public const int DM_MAX_LINKS = 256;
        /// <summary>Most snap values of one drag.</summary>
        public const int DM_MAX_SNAPS = 16;
        /// <summary>Most bytes of a dm_drag_save in any library of the interface dm.core/1. dm_drag_snapshot_size returns how many this one writes.</summary>
        public const int DM_DRAG_SNAPSHOT_MAX = 65536;
        /// <summary>no node: the scene itself</summary>
        public const uint DM_ASSET_NO_NODE = 4294967295;
        /// <summary>no part: the body that stays</summary>
        public const uint DM_ASSET_NO_PART = 4294967295;
        public const uint DM_GLTF_NO_CARRIER = 4294967295;
        public const int DM_OK = 0;
        /// <summary>a null pointer, an unknown enum value, a count that makes no sense</summary>
        public const int DM_ERROR_INVALID_ARGUMENT = -1;
        /// <summary>struct_size is too small, or a field is set that this library does not know</summary>
        public const int DM_ERROR_STRUCT_SIZE = -2;
        /// <summary>null, destroyed, or of another kind or context</summary>
        public const int DM_ERROR_STALE_HANDLE = -3;
        /// <summary>the host's allocator returned NULL</summary>
        public const int DM_ERROR_OUT_OF_MEMORY = -4;
        /// <summary>a NaN or infinite number in the input</summary>
        public const int DM_ERROR_NOT_FINITE = -5;
        /// <summary>an index names a vertex or a hypothesis that does not exist</summary>
        public const int DM_ERROR_INDEX_OUT_OF_RANGE = -6;
        /// <summary>no triangle belongs to the part</summary>
        public const int DM_ERROR_EMPTY_MASK = -7;
        /// <summary>the mask, or the part found, is the whole mesh, so nothing stays</summary>
        public const int DM_ERROR_FULL_MASK = -8;
        /// <summary>no triangle with an area, or all vertices in one point</summary>
        public const int DM_ERROR_DEGENERATE_MESH = -9;
        /// <summary>the drag vector has no length</summary>
        public const int DM_ERROR_ZERO_DRAG = -10;
        /// <summary>the drag point is farther from the part than half the object's size</summary>
        public const int DM_ERROR_DRAG_OFF_PART = -11;
        /// <summary>truncated, corrupt or hostile bytes</summary>
        public const int DM_ERROR_BAD_DATA = -12;
        /// <summary>readable weights, but not of the architecture asked for</summary>
        public const int DM_ERROR_WRONG_MODEL = -13;
        /// <summary>made by a newer version than this library can read</summary>
        public const int DM_ERROR_VERSION = -14;
        /// <summary>the progress callback asked to stop</summary>
        public const int DM_ERROR_CANCELLED = -15;
        /// <summary>the call needs weights and none were given</summary>
        public const int DM_ERROR_NO_MODEL = -16;
        /// <summary>more than DM_MAX_ELEMENTS or DM_MAX_PARTS</summary>
        public const int DM_ERROR_TOO_LARGE = -17;
        /// <summary>the output buffer cannot hold the answer; the size needed is set</summary>
        public const int DM_ERROR_BUFFER_TOO_SMALL = -18;
        /// <summary>no such part, node or instance</summary>
        public const int DM_ERROR_NOT_FOUND = -19;
        /// <summary>valid, but this build or this kind of file cannot do it</summary>
        public const int DM_ERROR_UNSUPPORTED = -20;
        /// <summary>a bug of ours; please report it</summary>
        public const int DM_ERROR_INTERNAL = -21;
        public const int DM_LOG_ERROR = 0;
        public const int DM_LOG_WARNING = 1;
        public const int DM_LOG_INFO = 2;
        /// <summary>right-handed, +Y up (glTF, Godot, OpenGL)</summary>
        public const int DM_AXES_GLTF = 0;
        /// <summary>left-handed, +Y up, +Z forward</summary>
        public const int DM_AXES_UNITY = 1;
        /// <summary>left-handed, +Z up, +X forward</summary>
        public const int DM_AXES_UNREAL = 2;
        /// <summary>right-handed, +Z up (Blender, ROS, most CAD)</summary>
        public const int DM_AXES_BLENDER = 3;
        /// <summary>those of dm_context_desc.custom_axes</summary>
        public const int DM_AXES_CUSTOM = 4;
        /// <summary>Embree 3.13 or 4 where its shared library is found, else the library's own code</summary>
        public const int DM_PICK_AUTO = 0;
        /// <summary>Embree; the context is refused where it is missing</summary>
        public const int DM_PICK_EMBREE = 1;
        /// <summary>the library's own code, which runs everywhere, in the host's memory</summary>
        public const int DM_PICK_PORTABLE = 2;
        /// <summary>nothing, for hosts that cast their own rays: objects keep no trees, and there are no scenes</summary>
        public const int DM_PICK_NONE = 3;
        public const int DM_JOINT_UNKNOWN = 0;
        /// <summary>turns about a line between two limits, rad</summary>
        public const int DM_JOINT_REVOLUTE = 1;
        /// <summary>slides along a direction, host units</summary>
        public const int DM_JOINT_PRISMATIC = 2;
        /// <summary>turns and advances `pitch` host units a radian</summary>
        public const int DM_JOINT_SCREW = 3;
        /// <summary>turns without limits</summary>
        public const int DM_JOINT_CONTINUOUS = 4;
        public const int DM_JOINT_FIXED = 5;
        /// <summary>formats of positions, three numbers each</summary>
        public const int DM_FLOAT32 = 0;
        /// <summary>formats of positions, three numbers each</summary>
        public const int DM_FLOAT64 = 1;
        /// <summary>formats of indices and part ids</summary>
        public const int DM_UINT32 = 0;
        /// <summary>formats of indices and part ids</summary>
        public const int DM_UINT16 = 1;
        /// <summary>formats of indices and part ids</summary>
        public const int DM_UINT8 = 2;
        /// <summary>formats of indices and part ids</summary>
        public const int DM_INT32 = 3;
        public const int DM_PER_VERTEX = 0;
        public const int DM_PER_FACE = 1;
        /// <summary>not known: the library compares it with those of the other parts</summary>
        public const int DM_PIVOT_UNKNOWN = 0;
        /// <summary>a program puts all of them there, so it says nothing</summary>
        public const int DM_PIVOT_DEFAULT = 1;
        /// <summary>The other nodes' pivots follow a rule and this one does not, so somebody has set it. It counts for more.</summary>
        public const int DM_PIVOT_SET = 2;
        public const int DM_JOINT_FROM_NETWORK = 0;
        public const int DM_JOINT_FROM_GEOMETRY = 1;
        /// <summary>the host's own: certain, limits too, and no pull changes it</summary>
        public const int DM_JOINT_FROM_HOST = 2;
        /// <summary>The host has chosen it with dm_object_desc.choose. No pull replaces it, or moves its range to the other side of rest. Its limits are estimates, and give.</summary>
        public const int DM_JOINT_CHOSEN = 3;
        public const int DM_LIMIT_LOWER = 1;
        public const int DM_LIMIT_UPPER = 2;
        public const int DM_CHOICE_KEEP = -1;
        /// <summary>The object keeps no triangles. It is small, and cannot be added to a scene.</summary>
        public const int DM_PREPARE_WITHOUT_PICKING = 1;
        /// <summary>KPP-Net alone infers the joints, without geometric candidates and ranker, for comparisons. The call answers NO_MODEL when `model` has no kinematics weights.</summary>
        public const int DM_PREPARE_NETWORK_ALONE = 2;
        /// <summary>The reader of the mesh has left out something of its file (dm_gltf_left_out). The object keeps it as DM_DEGRADED_MESH.</summary>
        public const int DM_PREPARE_MESH_INCOMPLETE = 4;
        /// <summary>no weights of KPP-Net: geometry alone finds the joints</summary>
        public const int DM_DEGRADED_NO_KINEMATICS = 1;
        /// <summary>no weights of the ranker: rules choose the joints, and set limits</summary>
        public const int DM_DEGRADED_NO_RANKER = 2;
        /// <summary>no weights of the DQ-VAE: a rule paces releases, and motions answer NO_MODEL</summary>
        public const int DM_DEGRADED_NO_MOTION = 4;
        /// <summary>the mesh has no body, whose contacts would show the joints</summary>
        public const int DM_DEGRADED_NO_BODY = 8;
        /// <summary>a pivot was ignored, because it is 1,000 object sizes away or more</summary>
        public const int DM_DEGRADED_HINT = 16;
        /// <summary>DM_PREPARE_MESH_INCOMPLETE</summary>
        public const int DM_DEGRADED_MESH = 32;
        /// <summary>The node is neither part nor body: a level of detail, a collider, something hidden. It goes where `follows` goes, and its mesh is not read.</summary>
        public const int DM_ASSET_NODE_FOLLOWS = 1;
        /// <summary>the place of its origin says nothing</summary>
        public const int DM_ASSET_NODE_NO_PIVOT = 2;
        /// <summary>the animation also scales or bends the node</summary>
        public const int DM_CLIP_NOT_RIGID = 1;
        /// <summary>clips are ignored</summary>
        public const int DM_ASSET_WITHOUT_CLIPS = 256;
        /// <summary>names and labels are ignored</summary>
        public const int DM_ASSET_WITHOUT_NAMES = 512;
        /// <summary>a clip is not rigid, or no joint moves a node as it does</summary>
        public const int DM_ASSET_CLIP_LEFT_OUT = 1;
        /// <summary>It may move, but probably does not: `moves` is below dm_asset_desc.min_moves. A body that almost certainly stays is not listed as a part.</summary>
        public const int DM_ASSET_STAYS = 0;
        /// <summary>it moves by its joint</summary>
        public const int DM_ASSET_MOVES = 1;
        /// <summary>Only its weight holds it, as the lid of a teapot, so a player can take it away. Its joint is the slide by which it comes off, with a low confidence.</summary>
        public const int DM_ASSET_FREE = 2;
        /// <summary>inferred from shape, contacts and names</summary>
        public const int DM_ASSET_INFERRED = 0;
        /// <summary>stated in dm_asset_node.joint</summary>
        public const int DM_ASSET_FROM_FILE = 1;
        /// <summary>read from dm_asset_node.clips</summary>
        public const int DM_ASSET_FROM_CLIP = 2;
        /// <summary>The drag follows the joint in force with its limits, whatever the pull says, as it follows a host's joint.</summary>
        public const int DM_DRAG_KEEP_JOINT = 1;
        /// <summary>No point is grabbed, for hands of DM_HAND_RATE, STEP and VALUE, and for releases. grab_point is ignored, and the middle of the part's box takes its place.</summary>
        public const int DM_DRAG_WITHOUT_POINT = 2;
        /// <summary>The part stays where it is, gives a little, and reports a try as DM_EVENT_LOCKED.</summary>
        public const int DM_RULE_LOCKED = 1;
        /// <summary>A latch holds the part at rest until a handle has turned (dm_drag_input.handles), and catches it again when it comes to rest with the handle let go.</summary>
        public const int DM_RULE_LATCH = 2;
        /// <summary>The driven part's value is offset + ratio * (the driver's value beyond `from`), inside its limits.</summary>
        public const int DM_LINK_MOVES = 0;
        /// <summary>the driven part is held until the driver has reached `from`: a handle</summary>
        public const int DM_LINK_FREES = 1;
        /// <summary>the driven part is held once the driver has reached `from`: one drawer at a time</summary>
        public const int DM_LINK_HOLDS = 2;
        /// <summary>the driven part of a DM_LINK_MOVES also moves the driver</summary>
        public const int DM_LINK_BOTH_WAYS = 1;
        /// <summary>no input in this update: the part moves on to its last target</summary>
        public const int DM_HAND_NONE = 0;
        /// <summary>a pointer, with `ray`</summary>
        public const int DM_HAND_RAY = 1;
        /// <summary>A hand in space, with `point`. The vector from it to the grabbed point stays as it was in its first update.</summary>
        public const int DM_HAND_POINT = 2;
        /// <summary>a stick or a key held down, with `amount` from -1 to 1 times dm_drag_rules.drive_speed</summary>
        public const int DM_HAND_RATE = 3;
        /// <summary>a wheel, which moves the part by `amount`, a share of the range</summary>
        public const int DM_HAND_STEP = 4;
        /// <summary>a slider of the host, which moves the part to the joint value `amount`</summary>
        public const int DM_HAND_VALUE = 5;
        /// <summary>the part is locked in this update, as by DM_RULE_LOCKED</summary>
        public const int DM_INPUT_LOCKED = 1;
        /// <summary>dm_drag_override may change the value after this update</summary>
        public const int DM_INPUT_ASK = 2;
        /// <summary>lower and upper hold even when they are equal</summary>
        public const int DM_INPUT_BOUNDS = 4;
        /// <summary>the part follows the pointer</summary>
        public const int DM_DRAG_HELD = 0;
        /// <summary>the part moves by itself after dm_drag_release</summary>
        public const int DM_DRAG_RELEASED = 1;
        /// <summary>the part has come to where it goes</summary>
        public const int DM_DRAG_AT_REST = 2;
        /// <summary>It has met its lower limit (within 0.5 % of the range), with the speed dm_drag_state.impact. The event comes again after the part was 2 % away. An estimated limit that has given does not count.</summary>
        public const int DM_EVENT_LIMIT_LOWER = 1;
        /// <summary>the same for the upper limit</summary>
        public const int DM_EVENT_LIMIT_UPPER = 2;
        /// <summary>it is more than 2 % of the range away from rest</summary>
        public const int DM_EVENT_LEFT_REST = 4;
        /// <summary>it is within 0.5 % of the range of rest, having left it</summary>
        public const int DM_EVENT_REACHED_REST = 8;
        /// <summary>it has opened beyond dm_drag_rules.open_share</summary>
        public const int DM_EVENT_OPENED = 16;
        /// <summary>it has closed to within dm_drag_rules.closed_share</summary>
        public const int DM_EVENT_CLOSED = 32;
        /// <summary>it has passed to another detent or snap value, see dm_drag_state.detents</summary>
        public const int DM_EVENT_DETENT = 64;
        /// <summary>the pull has changed the joint, see dm_drag_state.changes</summary>
        public const int DM_EVENT_JOINT = 128;
        /// <summary>the bounds of dm_drag_input hold it</summary>
        public const int DM_EVENT_BLOCKED = 256;
        /// <summary>these bounds no longer hold it</summary>
        public const int DM_EVENT_FREED = 512;
        /// <summary>the latch has caught it</summary>
        public const int DM_EVENT_LATCHED = 1024;
        /// <summary>the handle has opened the latch</summary>
        public const int DM_EVENT_UNLATCHED = 2048;
        /// <summary>it was tried while locked or latched; the event comes again after the hand has let up</summary>
        public const int DM_EVENT_LOCKED = 4096;
        /// <summary>it was let go of at dm_drag_rules.break_distance</summary>
        public const int DM_EVENT_LET_GO = 8192;
        /// <summary>the latch holds it</summary>
        public const int DM_STATUS_LATCHED = 1;
        /// <summary>DM_RULE_LOCKED or DM_INPUT_LOCKED holds it</summary>
        public const int DM_STATUS_LOCKED = 2;
        /// <summary>the bounds of dm_drag_input hold it, from DM_EVENT_BLOCKED to DM_EVENT_FREED</summary>
        public const int DM_STATUS_BLOCKED = 4;
        /// <summary>it counts as open, from DM_EVENT_OPENED to DM_EVENT_CLOSED</summary>
        public const int DM_STATUS_OPEN = 8;
        /// <summary>dm_object_prepare found it, and no pull has changed it</summary>
        public const int DM_BASIS_PREPARED = 0;
        /// <summary>a pull of this drag, or of an earlier one of the same dm_part_state, has changed it</summary>
        public const int DM_BASIS_PULL = 1;
        /// <summary>it is the host's own</summary>
        public const int DM_BASIS_HOST = 2;
        /// <summary>the host has chosen it among the hypotheses</summary>
        public const int DM_BASIS_CHOSEN = 3;
        /// <summary>the library decides what the player meant, by where the part is and how fast it goes</summary>
        public const int DM_GO_AUTO = 0;
        /// <summary>it glides to a stop; this also stops a part that moves by itself</summary>
        public const int DM_GO_STAY = 1;
        /// <summary>it goes to the end of the joint that lies the way it was pulled</summary>
        public const int DM_GO_OPEN = 2;
        /// <summary>it goes to where it is closed (dm_joint.closed), which is rest unless it rests open</summary>
        public const int DM_GO_CLOSE = 3;
        /// <summary>it repeats what it did after the last release</summary>
        public const int DM_GO_REPLAY = 4;
        /// <summary>it stops at once</summary>
        public const int DM_GO_FREEZE = 5;
        /// <summary>it opens when it is nearer to where it is closed than to its open end, else it closes</summary>
        public const int DM_GO_TOGGLE = 6;
        public const int DM_INTENT_AUTO = 0;
        public const int DM_INTENT_STAY = 1;
        public const int DM_INTENT_OPEN = 2;
        public const int DM_INTENT_CLOSE = 3;
        public const int DM_INTENT_REPLAY = 4;
        public const int DM_INTENT_FREEZE = 5;
        public const int DM_INTENT_TOGGLE = 6;
        /// <summary>A rule paces the release instead of the DQ-VAE, whose last bits differ between instruction sets.</summary>
        public const int DM_RELEASE_BY_RULE = 1;
        /// <summary>a part that opens to both sides of rest opens away from `away_from`</summary>
        public const int DM_RELEASE_AWAY_FROM = 2;
        /// <summary>How a texture continues beyond its edges, by OpenGL's numbers.</summary>
        public const int DM_GLTF_WRAP_REPEAT = 10497;
        /// <summary>How a texture continues beyond its edges, by OpenGL's numbers.</summary>
        public const int DM_GLTF_WRAP_CLAMP = 33071;
        /// <summary>How a texture continues beyond its edges, by OpenGL's numbers.</summary>
        public const int DM_GLTF_WRAP_MIRROR = 33648;
        /// <summary>rigged.urdf: ROS, Gazebo, MuJoCo, Bullet</summary>
        public const int DM_GLTF_RIG_URDF = 1;
        /// <summary>rigged.xml: MuJoCo</summary>
        public const int DM_GLTF_RIG_MJCF = 2;
        /// <summary>rigged.sdf, SDF 1.7: Gazebo</summary>
        public const int DM_GLTF_RIG_SDF = 4;
        /// <summary>rigged.usda, with UsdPhysics: Isaac Sim, Omniverse; all in one file</summary>
        public const int DM_GLTF_RIG_USDA = 8;
        /// <summary>rigged.tscn: Godot 4</summary>
        public const int DM_GLTF_RIG_TSCN = 16;
        /// <summary>rigged.glb: the file with an animation that opens and closes all parts, with KHR_physics_rigid_bodies, KHR_implicit_shapes and KHR_node_selectability, and with the joints in `extras` as dm_gltf_get_asset reads them. What a clip of the file moves, with all that it carries, is left to that clip, and has its joint in `extras` alone.</summary>
        public const int DM_GLTF_RIG_GLB = 32;
    }

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void Task(void* data, uint index);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int ProgressCallback(void* user, float done);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int IntentCallback(void* user, uint part_id, Vec3 box_min, Vec3 box_max);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int ChoiceCallback(void* user, Choice* choice);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void* AllocatorAllocate(void* user, UIntPtr size, UIntPtr alignment);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void AllocatorRelease(void* user, void* memory, UIntPtr size);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void LogMessage(void* user, int level, int code, byte* text);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int JobsParallelFor(void* user, uint count, IntPtr task, void* data);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate byte* Core1ResultString(int result);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate uint Core1Version();

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ContextCreate(ContextDesc* desc, IntPtr* out_context);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void Core1ContextDestroy(IntPtr context);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ContextGetMemory(IntPtr context, MemoryInfo* out_info);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ModelLoad(IntPtr context, ModelDesc* desc, ulong* out_model);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ModelUnload(IntPtr context, ulong model);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1MeshFindPart(IntPtr context, MeshDesc* mesh, DragHint* drag, byte* out_face_ids, ulong face_count);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectPrepare(IntPtr context, ObjectDesc* desc, ulong* out_object);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectSave(IntPtr context, ulong @object, void* buffer, UIntPtr capacity, UIntPtr* out_size);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectLoad(IntPtr context, void* data, UIntPtr size, ulong model, ulong* out_object);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectDestroy(IntPtr context, ulong @object);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectGetInfo(IntPtr context, ulong @object, ObjectInfo* out_info);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectGetPart(IntPtr context, ulong @object, uint index, PartInfo* out_info);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectGetJoint(IntPtr context, ulong @object, uint part_id, Joint* out_joint);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectGetHypotheses(IntPtr context, ulong @object, uint part_id, DragHint* drag, Joint* out_joints, uint capacity, uint* out_count);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectRefine(IntPtr context, ulong @object, uint part_id, DragHint* drag);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectSetJoint(IntPtr context, ulong @object, uint part_id, Joint* joint);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectResetJoint(IntPtr context, ulong @object, uint part_id);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1JointPose(Joint* joint, float value, Pose* out_pose);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1JointValue(Joint* joint, Pose* pose, float* out_value, float* out_angle_error, float* out_distance_error);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1JointGetFrame(Joint* joint, JointFrame* out_frame);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1JointScale(Joint* joint, Vec3 scale, Joint* out_joint);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1MotionGenerate(IntPtr context, ulong @object, MotionDesc* desc, ulong* out_motion);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1MotionSample(IntPtr context, ulong motion, float t, Pose* out_pose, float* out_value);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1MotionGetFrames(IntPtr context, ulong motion, Pose* out_poses, float* out_values);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1MotionDestroy(IntPtr context, ulong motion);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragBegin(IntPtr context, DragDesc* desc, ulong* out_drag);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragUpdate(IntPtr context, ulong drag, Ray* ray, float dt, DragState* out_state);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragRelease(IntPtr context, ulong drag, ReleaseDesc* desc, ReleasePlan* out_plan);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragEnd(IntPtr context, ulong drag, PartState* out_state);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragGetPartState(IntPtr context, ulong drag, PartState* out_state);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate UIntPtr Core1DragSnapshotSize();

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragSave(IntPtr context, ulong drag, void* buffer, UIntPtr capacity);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragRestore(IntPtr context, ulong drag, void* data, UIntPtr size);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void Core1PoseMultiply(Pose* a, Pose* b, Pose* out_pose);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void Core1PoseToMatrix(Pose* pose, float* out_matrix);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void Core1PoseApplyPoints(Pose* pose, float* src, UIntPtr src_stride, float* dst, UIntPtr dst_stride, UIntPtr count);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1CameraRay(IntPtr context, Camera* camera, float x, float y, Ray* out_ray);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1SceneCreate(IntPtr context, SceneDesc* desc, ulong* out_scene);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1SceneDestroy(IntPtr context, ulong scene);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1SceneAdd(IntPtr context, ulong scene, ulong @object, Pose* placement, uint* out_instance);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1SceneMove(IntPtr context, ulong scene, uint instance, uint part_id, Pose* pose);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1SceneRemove(IntPtr context, ulong scene, uint instance);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1SceneCommit(IntPtr context, ulong scene);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ScenePick(IntPtr context, ulong scene, Ray* ray, Hit* out_hit);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragStep(IntPtr context, ulong drag, DragInput* input, float dt, DragState* out_state);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1DragTake(IntPtr context, ulong drag, float value, DragState* out_state);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectSetLinks(IntPtr context, ulong @object, Link* links, uint count);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ObjectFollowLinks(IntPtr context, ulong @object, uint part_id, float* inout_values, byte* out_held, uint count);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1JointValueAt(Joint* joint, float share, float* out_value);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void Core1PoseInverse(Pose* pose, Pose* out_pose);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1PoseFromRotation(float* rotation, Vec3 translation, Pose* out_pose);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetCreate(IntPtr context, AssetDesc* desc, ulong* out_asset);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetDestroy(IntPtr context, ulong asset);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetGetInfo(IntPtr context, ulong asset, AssetInfo* out_info);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetGetPart(IntPtr context, ulong asset, uint index, AssetPart* out_part);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetGetJoint(IntPtr context, ulong asset, uint index, Joint* out_joint);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetGetPartNodes(IntPtr context, ulong asset, uint index, uint* out_nodes, uint capacity);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetGetNodeParts(IntPtr context, ulong asset, uint* out_parts, uint capacity);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1AssetMakeObject(IntPtr context, ulong asset, ulong* out_object);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int Core1ContextTrim(IntPtr context);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int GltfFilesOpen(void* user, byte* path, void** out_data, UIntPtr* out_size);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void GltfFilesClose(void* user, void* data, UIntPtr size);

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Vec3
    {
        public float X;
        public float Y;
        public float Z;
    }

    /// <summary>A rigid pose x' = R x + t as a unit dual quaternion real + eps dual, both in x, y, z, w order; dual = 1/2 t (*) real with t as a pure quaternion. Identity: real = {0,0,0,1}, dual = {0,0,0,0}.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Pose
    {
        public fixed float Real[4];
        public fixed float Dual[4];
    }

    /// <summary>A ray. The direction need not be a unit vector. Distances along the ray are in host units, not in multiples of it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Ray
    {
        public Vec3 Origin;
        public Vec3 Direction;
    }

    /// <summary>The host's memory. allocate returns memory aligned to `alignment` (a power of two, 64 at most) or NULL; release gets the size that was asked for. Both may be called from any thread on which the host calls the library. docs/integration.md says what callbacks may do.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Allocator
    {
        public void* User;
        public IntPtr Allocate;
        public IntPtr Release;
    }

    /// <summary>Receives messages for people, on the threads on which the host calls the library. level: DM_LOG_*. code: the error, or DM_OK for other messages. text: UTF-8, valid during the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Log
    {
        public void* User;
        public IntPtr Message;
    }

    /// <summary>The host's job system. parallel_for runs task(data, i) once for every i in [0, count) and returns non-zero when all are done. It may return 0 without having run any, and the library then runs them itself. When a task was left out, made up or run twice, the call answers INVALID_ARGUMENT; a second run of a task does nothing. The library starts no thread of its own.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Jobs
    {
        public void* User;
        public IntPtr ParallelFor;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ContextDesc
    {
        public uint StructSize;
        /// <summary>DM_AXES_*; 0 = DM_AXES_GLTF</summary>
        public int Axes;
        /// <summary>length of one host unit, m; 0 = 1. Unreal: 0.01</summary>
        public float UnitInMetres;
        /// <summary>Row-major matrix that takes a host vector to glTF's axes, for DM_AXES_CUSTOM. It is orthogonal, with determinant +1 or -1.</summary>
        public fixed float CustomAxes[9];
        /// <summary>zeros = malloc/free</summary>
        public Allocator Allocator;
        /// <summary>zeros = silent</summary>
        public Log Log;
        /// <summary>zeros = tasks run on the calling thread</summary>
        public Jobs Jobs;
        /// <summary>DM_PICK_*; 0 = auto</summary>
        public int Picking;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>Callback of dm_mesh_find_part, dm_object_load and dm_object_refine, and of dm_object_prepare and dm_asset_create without one of their own; NULL = none. Several threads may call it at once, one for each such call.</summary>
        public IntPtr Progress;
        public void* ProgressUser;
        /// <summary>Most bytes of scratch memory that stay with the context between calls; 0 = 32 MB, 1 = none. dm_context_trim gives them back.</summary>
        public ulong KeptBytes;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ContextDesc New() => new ContextDesc { StructSize = (uint)sizeof(ContextDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct MemoryInfo
    {
        public uint StructSize;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>bytes held now through the context's allocator</summary>
        public ulong Bytes;
        /// <summary>most bytes ever held</summary>
        public ulong PeakBytes;
        /// <summary>calls of allocate so far</summary>
        public ulong Allocations;
        /// <summary>bytes held now by Embree, which has its own allocator and reports sizes</summary>
        public ulong PickBytes;
        /// <summary>share of `bytes` that no call uses now, kept for later calls (dm_context_desc.kept_bytes)</summary>
        public ulong KeptBytes;

        /// <summary>Zeros, with StructSize set.</summary>
        public static MemoryInfo New() => new MemoryInfo { StructSize = (uint)sizeof(MemoryInfo) };
    }

    /// <summary>Weights, as the bytes of safetensors files. Each may be absent (NULL, 0). The library copies and repacks them, so the host may free them after the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ModelDesc
    {
        public uint StructSize;
        /// <summary>KPP-Net: sdk/models/kpp_net.safetensors</summary>
        public void* Kinematics;
        public UIntPtr KinematicsSize;
        /// <summary>DQ-VAE: sdk/models/dq_vae.safetensors</summary>
        public void* Motion;
        public UIntPtr MotionSize;
        /// <summary>chooses between candidate joints: sdk/models/ranker.safetensors; rules choose without it</summary>
        public void* Ranker;
        public UIntPtr RankerSize;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ModelDesc New() => new ModelDesc { StructSize = (uint)sizeof(ModelDesc) };
    }

    /// <summary>The host's mesh of triangles, which the library reads in place. The sizes of the buffers guard against a forgotten format, scope or stride: the call refuses a buffer that does not hold what counts, formats and strides say, and never reads past its end.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct MeshDesc
    {
        public uint StructSize;
        /// <summary>bytes from one vertex to the next; 0 = packed</summary>
        public uint PositionStride;
        /// <summary>vertex_count x 3 numbers</summary>
        public void* Positions;
        public ulong VertexCount;
        /// <summary>size of the buffer that begins at `positions`; 0 = not stated, and not checked</summary>
        public ulong PositionBytes;
        /// <summary>index_count indices, three a triangle; NULL = each three vertices in order are a triangle</summary>
        public void* Indices;
        public ulong IndexCount;
        /// <summary>size of the buffer; 0 = not stated, and not checked</summary>
        public ulong IndexBytes;
        /// <summary>The part that each vertex or face belongs to: 0 = the body that stays, 1 and above = parts. An id that dm_object_desc.parts does not list counts as the body's. With ids per vertex, a triangle belongs to the id that two of its corners share, or else to the smallest. A mesh without a body, such as a door leaf alone, is allowed, but its joints are less certain.</summary>
        public void* PartIds;
        /// <summary>Size of the buffer that begins at `part_ids`, required with part_ids. It must be exactly that of one id a vertex or a face, as part_id_scope says.</summary>
        public ulong PartIdBytes;
        /// <summary>bytes from one id to the next; 0 = packed</summary>
        public uint PartIdStride;
        /// <summary>DM_FLOAT32 | DM_FLOAT64</summary>
        public int PositionFormat;
        /// <summary>DM_UINT32 | DM_UINT16 | DM_UINT8</summary>
        public int IndexFormat;
        /// <summary>DM_UINT32 | DM_UINT16 | DM_UINT8 | DM_INT32, whose negative ids are the body's</summary>
        public int PartIdFormat;
        /// <summary>DM_PER_VERTEX | DM_PER_FACE</summary>
        public int PartIdScope;
        /// <summary>0</summary>
        public uint Reserved;

        /// <summary>Zeros, with StructSize set.</summary>
        public static MeshDesc New() => new MeshDesc { StructSize = (uint)sizeof(MeshDesc) };
    }

    /// <summary>A drag as evidence of how a part moves: a point on it, and the way in which a hand pulled it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragHint
    {
        /// <summary>a point on or near the part, host object frame</summary>
        public Vec3 Point;
        /// <summary>direction of the pull, not zero; its length is how far it went</summary>
        public Vec3 Vector;
    }

    /// <summary>The place, at rest, of the node or bone that moves a part. An artist may have put it on the hinge, or left it in the middle or at the file's origin, so it is evidence only. Leave it out, or say DM_PIVOT_DEFAULT, where the nodes of an asset all have their places by one rule: at one point, or at the same place of their boxes. A program has put them there, and the library would take an edge that happens to lie there for a hinge.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Pivot
    {
        /// <summary>host object frame</summary>
        public Vec3 Origin;
        /// <summary>The node's x, y and z axis, three numbers each, host object frame. They may have any length, and may be mirrored. Zeros: unknown.</summary>
        public fixed float Axes[9];
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct PartDesc
    {
        public uint StructSize;
        /// <summary>id as in part_ids, 1 or above</summary>
        public uint Id;
        /// <summary>id of the part that carries this one and that it moves with; 0 = the body</summary>
        public uint Parent;
        /// <summary>DM_JOINT_*; 0 = the library infers it</summary>
        public int JointType;
        /// <summary>optional evidence</summary>
        public DragHint* Drag;
        /// <summary>Optional evidence: the names that the asset has for the part, as UTF-8, outermost first, joined by '/': file, parents, node, mesh. A name counts, in any language, when it says what the part is (door, lid, Hebel). At most DM_MAX_LABEL bytes.</summary>
        public byte* Label;
        /// <summary>optional evidence</summary>
        public Pivot* Pivot;
        /// <summary>DM_PIVOT_*: whether somebody has set the pivot</summary>
        public int PivotKind;
        /// <summary>0</summary>
        public uint Reserved;

        /// <summary>Zeros, with StructSize set.</summary>
        public static PartDesc New() => new PartDesc { StructSize = (uint)sizeof(PartDesc) };
    }

    /// <summary>How a part moves.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Joint
    {
        public uint StructSize;
        /// <summary>DM_JOINT_*</summary>
        public int Type;
        /// <summary>probability that the type is right, 0 to 1</summary>
        public float TypeConfidence;
        /// <summary>Probability that type, axis and origin are all right, 0 to 1; never above type_confidence.</summary>
        public float JointConfidence;
        /// <summary>host units a radian, signed along the axis; for screws only</summary>
        public float Pitch;
        /// <summary>Unit vector, host object frame. A positive value slides along it, or turns about it: right-handed in a right-handed host frame, left-handed in a left-handed one. A joint found with a drag is positive the way of the drag. Without a drag the longer way is positive, so `upper` is the open end.</summary>
        public Vec3 Axis;
        /// <summary>A point of the axis. For a joint that the library found, it is the one nearest the part's centre. The point of a host's own joint stays as it was given.</summary>
        public Vec3 Origin;
        /// <summary>Limits of the joint value, rad or host units; the rest pose is value 0. There are no limits when both are equal, and none for continuous joints. A limit of the host farther from rest than 1000 rad or 100 object sizes (FLT_MAX, 1e10, infinity) counts as none. Where only one side has none, a slightly larger number stands for the missing limit.</summary>
        public float Lower;
        /// <summary>Limits of the joint value, rad or host units; the rest pose is value 0. There are no limits when both are equal, and none for continuous joints. A limit of the host farther from rest than 1000 rad or 100 object sizes (FLT_MAX, 1e10, infinity) counts as none. Where only one side has none, a slightly larger number stands for the missing limit.</summary>
        public float Upper;
        /// <summary>DM_JOINT_FROM_*, DM_JOINT_CHOSEN</summary>
        public int Source;
        /// <summary>Evidence in a dm_part_state: what the part's pulls so far say of all its joints. dm_drag_end writes it and dm_drag_begin reads it, so keep the four numbers as they are. Zeros: no pull has said anything. In other structs it is 0, and no function reads it.</summary>
        public fixed uint Evidence[4];
        /// <summary>Joint value at which the part is closed: 0, or one of the limits when the part rests open. A host's joint may set it; a value outside of its limits becomes the nearer limit.</summary>
        public float Closed;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Joint New() => new Joint { StructSize = (uint)sizeof(Joint) };
    }

    /// <summary>A joint as the constraint of a physics engine: an orthonormal frame whose x axis is that of the hinge or slider. The y and z axes are arbitrary, but always the same for the same joint. x, y, z and `rotation` have determinant +1 in the host's coordinates.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct JointFrame
    {
        public uint StructSize;
        /// <summary>DM_JOINT_*</summary>
        public int Type;
        /// <summary>host object frame</summary>
        public Vec3 Origin;
        /// <summary>unit vectors</summary>
        public Vec3 X;
        /// <summary>unit vectors</summary>
        public Vec3 Y;
        /// <summary>unit vectors</summary>
        public Vec3 Z;
        /// <summary>unit quaternion x, y, z, w that takes the frame's coordinates to the object's</summary>
        public fixed float Rotation[4];
        /// <summary>Limits, about or along x: rad for hinges and screws, host units for sliders; 0 where there is none.</summary>
        public float Lower;
        /// <summary>Limits, about or along x: rad for hinges and screws, host units for sliders; 0 where there is none.</summary>
        public float Upper;
        /// <summary>DM_LIMIT_LOWER | DM_LIMIT_UPPER: the limits that exist</summary>
        public uint Limits;
        /// <summary>host units along x a radian; for screws only</summary>
        public float Pitch;

        /// <summary>Zeros, with StructSize set.</summary>
        public static JointFrame New() => new JointFrame { StructSize = (uint)sizeof(JointFrame) };
    }

    /// <summary>Where the part of one instance stands, and by which joint it moves. This is all that a host must keep, save, replicate and undo for it. It belongs to the instance, not to the object, because two doors of one object may differ. Save it field by field: type, pitch, axis, origin, limits, source, both confidences, evidence, value.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct PartState
    {
        public uint StructSize;
        /// <summary>joint value; 0 = rest</summary>
        public float Value;
        /// <summary>d value / dt, for a physics engine that takes over; output only: a drag begins with velocity 0</summary>
        public float Velocity;
        /// <summary>DM_STATUS_*; output only</summary>
        public uint Status;
        /// <summary>The pose as shown, from rest. It differs from dm_joint_pose(joint, value) only while the part blends over to a joint that has just changed. Zeros: the pose of joint and value.</summary>
        public Pose Pose;
        /// <summary>stays the last field</summary>
        public Joint Joint;

        /// <summary>Zeros, with StructSize set.</summary>
        public static PartState New() => new PartState { StructSize = (uint)sizeof(PartState) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct PartInfo
    {
        public uint StructSize;
        public uint Id;
        public uint Parent;
        /// <summary>triangles of the part alone, without the parts it carries</summary>
        public uint TriangleCount;
        public Vec3 BoxMin;
        public Vec3 BoxMax;
        /// <summary>centroid of the surface</summary>
        public Vec3 Centre;
        public float Area;

        /// <summary>Zeros, with StructSize set.</summary>
        public static PartInfo New() => new PartInfo { StructSize = (uint)sizeof(PartInfo) };
    }

    /// <summary>Where a hypothesis takes its part at one end of its range, host object frame. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct JointEnd
    {
        /// <summary>joint value</summary>
        public float Value;
        /// <summary>pose of the part, from rest</summary>
        public Pose Pose;
        /// <summary>box of the part alone, as in dm_part_info</summary>
        public Vec3 BoxMin;
        /// <summary>box of the part alone, as in dm_part_info</summary>
        public Vec3 BoxMax;
        public Vec3 Centre;
    }

    /// <summary>A ranked hypothesis and what it would do. struct_size says how much the library has filled.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Hypothesis
    {
        public uint StructSize;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>the joint, with its limits and probabilities</summary>
        public Joint* Joint;
        /// <summary>The ends at the lower and at the upper limit. For a joint without limits they are a quarter turn, or half the object's size, either way.</summary>
        public JointEnd Ends0;
        /// <summary>The ends at the lower and at the upper limit. For a joint without limits they are a quarter turn, or half the object's size, either way.</summary>
        public JointEnd Ends1;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Hypothesis New() => new Hypothesis { StructSize = (uint)sizeof(Hypothesis) };
    }

    /// <summary>A part and its hypotheses, for the host to choose from. It is valid during the call only.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Choice
    {
        public uint StructSize;
        /// <summary>number of hypotheses, 1 to DM_MAX_HYPOTHESES</summary>
        public uint Count;
        public PartInfo* Part;
        /// <summary>most probable first</summary>
        public Hypothesis** Hypotheses;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Choice New() => new Choice { StructSize = (uint)sizeof(Choice) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ObjectDesc
    {
        public uint StructSize;
        /// <summary>DM_PREPARE_*</summary>
        public uint Flags;
        public MeshDesc* Mesh;
        /// <summary>NULL: every id above 0 in part_ids is a part that the body carries</summary>
        public PartDesc* Parts;
        public uint PartCount;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>weights; 0 = the joints come from geometry alone</summary>
        public ulong Model;
        /// <summary>seed of the surface sampling; the same seed gives the same bits</summary>
        public ulong Seed;
        public IntPtr Intent;
        public void* IntentUser;
        /// <summary>NULL = the context's</summary>
        public IntPtr Progress;
        public void* ProgressUser;
        /// <summary>Optional evidence: names of the whole object, as dm_part_desc.label. They count for the parts whose own label says nothing.</summary>
        public byte* Label;
        /// <summary>The up direction, host object frame. It counts only together with labels and pivots. 0 = that of the context's axes.</summary>
        public Vec3 Up;
        public IntPtr Choose;
        public void* ChooseUser;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ObjectDesc New() => new ObjectDesc { StructSize = (uint)sizeof(ObjectDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ObjectInfo
    {
        public uint StructSize;
        public uint PartCount;
        public ulong VertexCount;
        public ulong TriangleCount;
        /// <summary>host object frame; oblique custom axes may make it larger than need be</summary>
        public Vec3 BoxMin;
        /// <summary>host object frame; oblique custom axes may make it larger than need be</summary>
        public Vec3 BoxMax;
        /// <summary>largest side of the box</summary>
        public float Size;
        /// <summary>1 when it has kept its triangles</summary>
        public uint Pickable;
        /// <summary>DM_DEGRADED_*; 0: nothing was missing</summary>
        public uint Degraded;
        /// <summary>DM_PICK_EMBREE or DM_PICK_PORTABLE: the kind of its trees. DM_PICK_NONE: it has none.</summary>
        public int Picking;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ObjectInfo New() => new ObjectInfo { StructSize = (uint)sizeof(ObjectInfo) };
    }

    /// <summary>How one animation moves one node. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetClip
    {
        /// <summary>name of the animation, UTF-8; may be NULL</summary>
        public byte* Name;
        /// <summary>s, rising</summary>
        public float* Times;
        /// <summary>Poses of the node relative to the pose that its mesh has, asset frame, as if all nodes above it stood still.</summary>
        public Pose* Poses;
        /// <summary>number of times and of poses</summary>
        public uint KeyCount;
        /// <summary>DM_CLIP_NOT_RIGID</summary>
        public uint Flags;
    }

    /// <summary>A node of an asset, as the host has it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetNode
    {
        public uint StructSize;
        /// <summary>DM_ASSET_NODE_*</summary>
        public uint Flags;
        /// <summary>index of the node above it, which may come later in the list, or DM_ASSET_NO_NODE</summary>
        public uint Parent;
        /// <summary>Index of the node that a DM_ASSET_NODE_FOLLOWS follows; DM_ASSET_NO_NODE: the one above it.</summary>
        public uint Follows;
        /// <summary>UTF-8, DM_MAX_LABEL bytes at most; NULL: none</summary>
        public byte* Name;
        /// <summary>name of its mesh, with the same rules</summary>
        public byte* MeshName;
        /// <summary>mesh without part_ids; NULL: a node without a mesh, such as a group</summary>
        public MeshDesc* Mesh;
        /// <summary>4x4, column-major, affine: takes the node's frame to the asset frame, all nodes above it included. NULL: identity.</summary>
        public float* Transform;
        /// <summary>Pivot of the node, asset frame. NULL: origin and axes of `transform`, and unknown where that is NULL too.</summary>
        public Pivot* Pivot;
        public AssetClip* Clips;
        public uint ClipCount;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>Joint that the file states for this node, asset frame, with limits. It is as certain as a joint that the host sets. DM_JOINT_FIXED: the node is one with the node above it. NULL: none.</summary>
        public Joint* Joint;

        /// <summary>Zeros, with StructSize set.</summary>
        public static AssetNode New() => new AssetNode { StructSize = (uint)sizeof(AssetNode) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetDesc
    {
        public uint StructSize;
        /// <summary>DM_ASSET_*, DM_PREPARE_WITHOUT_PICKING, DM_PREPARE_MESH_INCOMPLETE</summary>
        public uint Flags;
        public AssetNode* Nodes;
        /// <summary>optional evidence: names of the whole asset, as dm_object_desc.label</summary>
        public byte* Label;
        public uint NodeCount;
        /// <summary>Least probability of moving, 0 to 1, from which a part counts as moving and belongs to the object; 0 = 0.5.</summary>
        public float MinMoves;
        /// <summary>weights; 0 = the joints come from geometry alone</summary>
        public ulong Model;
        /// <summary>seed, as dm_object_desc.seed</summary>
        public ulong Seed;
        /// <summary>NULL = the context's</summary>
        public IntPtr Progress;
        public void* ProgressUser;
        /// <summary>the up direction, asset frame; 0 = that of the context's axes</summary>
        public Vec3 Up;
        /// <summary>0</summary>
        public uint Reserved;

        /// <summary>Zeros, with StructSize set.</summary>
        public static AssetDesc New() => new AssetDesc { StructSize = (uint)sizeof(AssetDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetInfo
    {
        public uint StructSize;
        public uint NodeCount;
        /// <summary>parts, those that stay included</summary>
        public uint PartCount;
        /// <summary>parts that move or are free, which are those of the object</summary>
        public uint MovingCount;
        /// <summary>triangles of the nodes that do not follow others</summary>
        public ulong TriangleCount;
        /// <summary>DM_DEGRADED_*: what was missing when the joints were found</summary>
        public uint Degraded;
        /// <summary>DM_ASSET_CLIP_LEFT_OUT</summary>
        public uint Warnings;

        /// <summary>Zeros, with StructSize set.</summary>
        public static AssetInfo New() => new AssetInfo { StructSize = (uint)sizeof(AssetInfo) };
    }

    /// <summary>Nodes that move together, or might.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetPart
    {
        public uint StructSize;
        /// <summary>index of the part that carries it, or DM_ASSET_NO_PART</summary>
        public uint Parent;
        /// <summary>id in the object: its index in the asset + 1; 0 while it stays</summary>
        public uint PartId;
        /// <summary>DM_ASSET_STAYS …</summary>
        public int State;
        /// <summary>DM_ASSET_INFERRED …</summary>
        public int Basis;
        /// <summary>probability that it moves relative to what carries it, 0 to 1</summary>
        public float Moves;
        /// <summary>Its nodes, those that follow them included. Nodes of the parts that it carries do not count.</summary>
        public uint NodeCount;
        /// <summary>triangles of these nodes, without those that follow</summary>
        public uint TriangleCount;
        /// <summary>Seconds in which its clip takes it from one end of the joint to the other; 0: it has no clip.</summary>
        public float Duration;
        /// <summary>0</summary>
        public uint Reserved;
        public Vec3 BoxMin;
        public Vec3 BoxMax;

        /// <summary>Zeros, with StructSize set.</summary>
        public static AssetPart New() => new AssetPart { StructSize = (uint)sizeof(AssetPart) };
    }

    /// <summary>What the player asked for. The network answers with a motion of DM_MOTION_FRAMES poses from rest.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct MotionDesc
    {
        public uint StructSize;
        public uint PartId;
        /// <summary>required</summary>
        public DragHint Drag;
        /// <summary>Optional: the path on which the pointer drew the drag point, from drag.point on; at most 65536 points.</summary>
        public Vec3* Path;
        /// <summary>0: the path that opens the joint all the way in the drag's direction</summary>
        public uint PathCount;
        /// <summary>0: the most likely motion (z = mean); else z is drawn with this seed</summary>
        public uint Seed;

        /// <summary>Zeros, with StructSize set.</summary>
        public static MotionDesc New() => new MotionDesc { StructSize = (uint)sizeof(MotionDesc) };
    }

    /// <summary>How a drag feels. Zeros are the defaults. Stiffness, damping and inertia of a part in the hand matter only through two ratios, which are times: smoothing_time is damping over stiffness, coast_time is inertia over damping.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragFeel
    {
        /// <summary>s for the part to close half the gap to the pointer; 0 = 0.02, negative = none</summary>
        public float SmoothingTime;
        /// <summary>Share of the range over which the ends give; 0 = hard ends. It does not apply to limits that the library estimated: see dm_drag_desc.limit_give.</summary>
        public float SoftLimit;
        /// <summary>Seconds in which a part left alone loses half its speed; in the hand it makes the part heavy. 0 = 0.1 once released, and weightless in the hand; negative = it stops where it is let go.</summary>
        public float CoastTime;
        /// <summary>Joint value from one catch to the next, rad or host units, counted from where the part is closed; 0 = none.</summary>
        public float Detent;
        /// <summary>strength of the catches, up to 1; 0 = 0.7. It has no effect without `detent`</summary>
        public float DetentPull;
        /// <summary>Seconds in which the released part springs back to rest. 0 = push buttons alone do, in 0.12 s; negative = nothing does.</summary>
        public float ReturnTime;
    }

    /// <summary>What a part does besides following the hand. Zeros are off, except that thresholds have defaults. "Range" is the way from lower to upper limit; where one of them is missing, it is 1 rad or the object's size. docs/feel.md describes each rule.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragRules
    {
        public uint StructSize;
        /// <summary>DM_RULE_*</summary>
        public uint Flags;
        /// <summary>Joint values, rising, at which the part catches as at detents, with the strength of feel.detent_pull. With feel.detent above 0 they are refused.</summary>
        public float* Snaps;
        /// <summary>DM_MAX_SNAPS at most</summary>
        public uint SnapCount;
        /// <summary>Distance, in joint value, from which a snap value catches the part, to either side; 0 = half-way to the next one, or a twentieth of the range where there is none.</summary>
        public float SnapReach;
        /// <summary>share of the range from rest beyond which DM_EVENT_OPENED comes; 0 = 0.1</summary>
        public float OpenShare;
        /// <summary>Share of the range from rest within which DM_EVENT_CLOSED comes; 0 = 0.02. It is less than open_share. A part that is grabbed between both counts as open.</summary>
        public float ClosedShare;
        /// <summary>shortest time between DM_EVENT_OPENED and DM_EVENT_CLOSED, s</summary>
        public float EventTime;
        /// <summary>joint value a second; 0 = no limit</summary>
        public float MaxSpeed;
        /// <summary>Joint value a second squared while the part gets faster: the highest force over the part's inertia; 0 = no limit.</summary>
        public float MaxAcceleration;
        /// <summary>Share of the range by which a locked or latched part gives at most; 0 = 0.01, negative = none.</summary>
        public float LockGive;
        /// <summary>Joint value of a handle, of either sign, from which on the latch is open; 0 = 0.785 (rad: 45 degrees).</summary>
        public float LatchTurn;
        /// <summary>Share of the range: a released part nearer to rest than this closes by itself; 0 = none does.</summary>
        public float AutoCloseShare;
        /// <summary>seconds in which it closes; 0 = 0.25</summary>
        public float AutoCloseTime;
        /// <summary>seconds from the release until the part starts to spring back by feel.return_time</summary>
        public float CloseDelay;
        /// <summary>Share of the range: a released part nearer to rest than this falls to rest, and any other to its open end, as a hatch does; 0 = it does not fall.</summary>
        public float TipShare;
        /// <summary>seconds of a fall over the whole range; 0 = 0.7</summary>
        public float FallTime;
        /// <summary>Share of its speed, 0 to 1, with which a part rebounds from a limit that it falls, glides or swings against.</summary>
        public float Restitution;
        /// <summary>Host units from the hand to where it holds the part, beyond which the part is released (DM_EVENT_LET_GO); 0 = never.</summary>
        public float BreakDistance;
        /// <summary>share of the range a second at dm_hand.amount 1; 0 = 1</summary>
        public float DriveSpeed;
        /// <summary>0</summary>
        public uint Reserved;

        /// <summary>Zeros, with StructSize set.</summary>
        public static DragRules New() => new DragRules { StructSize = (uint)sizeof(DragRules) };
    }

    /// <summary>A link between two parts. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Link
    {
        /// <summary>part ids</summary>
        public uint Driver;
        /// <summary>part ids</summary>
        public uint Driven;
        /// <summary>DM_LINK_*</summary>
        public int Kind;
        /// <summary>DM_LINK_BOTH_WAYS</summary>
        public uint Flags;
        /// <summary>How far the driven part's value changes for each unit of the driver's; 0 = 1. The two may be rad and host units, as in a rack and pinion.</summary>
        public float Ratio;
        /// <summary>value of the driven part while the driver is at `from`</summary>
        public float Offset;
        /// <summary>Value of the driver from which on the link acts, on that side of rest. A `from` of 0 counts as reached at rest for DM_LINK_FREES and DM_LINK_HOLDS.</summary>
        public float From;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragDesc
    {
        public uint StructSize;
        public uint PartId;
        public ulong Object;
        /// <summary>point on the part as it is now, host object frame</summary>
        public Vec3 GrabPoint;
        /// <summary>joint value of the part now; 0 = rest. It must be 0 with `state`</summary>
        public float StartValue;
        public DragFeel Feel;
        /// <summary>DM_DRAG_KEEP_JOINT, DM_DRAG_WITHOUT_POINT</summary>
        public uint Flags;
        /// <summary>How far a pull takes the part beyond limits that the library estimated, as a share of the range. 0 = as far as the pull goes, by one turn or the object's size at most; negative = not at all. The host's own limits never give, nor does a stop at rest.</summary>
        public float LimitGive;
        /// <summary>The instance's joint and value, as an earlier drag has returned them; the drag begins in its pose. NULL = the object's joint in force, at start_value.</summary>
        public PartState* State;
        /// <summary>Scale of the instance along the axes of the object frame; negative = mirrored, 0 = 1. grab_point, rays, state and poses are then in the scaled frame (object coordinates times scale), and poses are rigid in it.</summary>
        public Vec3 Scale;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>NULL = no rules, and no events</summary>
        public DragRules* Rules;

        /// <summary>Zeros, with StructSize set.</summary>
        public static DragDesc New() => new DragDesc { StructSize = (uint)sizeof(DragDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Hand
    {
        /// <summary>DM_HAND_*. RATE, STEP and VALUE stay inside the limits. RATE and STEP open the part with an amount above 0. A limit that the library estimated stops them first. It gives afterwards, as it gives to a pull: to a RATE after 0.25 s at the limit, to a STEP with the next step.</summary>
        public int Kind;
        /// <summary>object frame, scaled with dm_drag_desc.scale</summary>
        public Ray Ray;
        /// <summary>object frame, scaled with dm_drag_desc.scale</summary>
        public Vec3 Point;
        /// <summary>what RATE, STEP and VALUE ask for</summary>
        public float Amount;
        /// <summary>Where a second hand takes hold of the part as it is then. It is read in that hand's first update only.</summary>
        public Vec3 GrabPoint;
    }

    /// <summary>Everything that one update can read.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragInput
    {
        public uint StructSize;
        /// <summary>DM_INPUT_*</summary>
        public uint Flags;
        public Hand Hand;
        /// <summary>Another hand on the part, by ray or point; DM_HAND_NONE = none. The hand that can move the part farther counts more. The second hand comes and goes without a jump.</summary>
        public Hand Second;
        /// <summary>joint values of the handles of a latch, from their drags or links</summary>
        public fixed float Handles[2];
        /// <summary>Joint values between which the host's world leaves the part room in this update, infinite on a free side. There are no bounds when both are equal, unless DM_INPUT_BOUNDS is set. The part stops there softly, goes on when it is free, and is pushed back when it lies beyond.</summary>
        public float Lower;
        /// <summary>Joint values between which the host's world leaves the part room in this update, infinite on a free side. There are no bounds when both are equal, unless DM_INPUT_BOUNDS is set. The part stops there softly, goes on when it is free, and is pushed back when it lies beyond.</summary>
        public float Upper;

        /// <summary>Zeros, with StructSize set.</summary>
        public static DragInput New() => new DragInput { StructSize = (uint)sizeof(DragInput) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragState
    {
        public uint StructSize;
        /// <summary>pose of the part from rest, object frame; compose it with the carrier's own pose</summary>
        public Pose Pose;
        /// <summary>place of the grabbed point now</summary>
        public Vec3 GrabPoint;
        /// <summary>joint value</summary>
        public float Value;
        /// <summary>joint value that the pointer asks for, before smoothing and inside the limits</summary>
        public float Target;
        /// <summary>d value / dt</summary>
        public float Velocity;
        /// <summary>-1 at lower, +1 at upper, 0 between</summary>
        public int AtLimit;
        /// <summary>DM_DRAG_HELD …</summary>
        public int Phase;
        /// <summary>How often the pull has changed the joint that the drag follows (dm_drag_get_part_state). The pose blends over to a new joint within 0.6 s, the grabbed point mostly within 0.1 s.</summary>
        public uint Changes;
        /// <summary>DM_EVENT_*; 0 without dm_drag_desc.rules</summary>
        public uint Events;
        /// <summary>Detents or snap values that the part has passed to since the update before; a long update may pass several. 0 without dm_drag_desc.rules.</summary>
        public uint Detents;
        /// <summary>Speed with which it met a limit or was blocked, joint value a second; 0 without such an event, or without dm_drag_desc.rules.</summary>
        public float Impact;
        /// <summary>DM_STATUS_*: what holds the part, and whether it is open; 0 without dm_drag_desc.rules</summary>
        public uint Status;
        /// <summary>Probability that the joint in force is right, 0 to 1: the one number to show. A pull of one kind from one side never makes it 1.</summary>
        public float JointConfidence;
        /// <summary>DM_BASIS_*: where the joint in force comes from</summary>
        public int JointBasis;
        /// <summary>How far the part is open: 0 where it is closed (dm_joint.closed), 1 at the end farther from there, and linear in the joint value between both. 0 for joints without limits.</summary>
        public float OpenShare;

        /// <summary>Zeros, with StructSize set.</summary>
        public static DragState New() => new DragState { StructSize = (uint)sizeof(DragState) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ReleaseDesc
    {
        public uint StructSize;
        /// <summary>DM_GO_*</summary>
        public int Intent;
        /// <summary>seconds from here to the end; 0 = the library takes it from the part's way and speed</summary>
        public float Duration;
        /// <summary>seed of the DQ-VAE, as dm_motion_desc.seed</summary>
        public uint Seed;
        /// <summary>DM_RELEASE_*</summary>
        public uint Flags;
        /// <summary>a place such as the player's, object frame, scaled with dm_drag_desc.scale</summary>
        public Vec3 AwayFrom;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ReleaseDesc New() => new ReleaseDesc { StructSize = (uint)sizeof(ReleaseDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ReleasePlan
    {
        public uint StructSize;
        /// <summary>what was decided: DM_GO_STAY, OPEN, CLOSE or FREEZE</summary>
        public int Intent;
        public float StartValue;
        public float EndValue;
        /// <summary>seconds; 0 when the part is there already</summary>
        public float Duration;
        /// <summary>1: the DQ-VAE paces it; 0: a rule does</summary>
        public uint FromNetwork;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ReleasePlan New() => new ReleasePlan { StructSize = (uint)sizeof(ReleasePlan) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Camera
    {
        public uint StructSize;
        /// <summary>vertical angle of view, rad, below pi; 0 = orthographic with ortho_height</summary>
        public float FovY;
        /// <summary>host world frame</summary>
        public Vec3 Eye;
        /// <summary>need not be unit or orthogonal, but must not be parallel</summary>
        public Vec3 Forward;
        /// <summary>need not be unit or orthogonal, but must not be parallel</summary>
        public Vec3 Up;
        /// <summary>pixels</summary>
        public float ViewportWidth;
        /// <summary>pixels</summary>
        public float ViewportHeight;
        /// <summary>host units from bottom to top, for orthographic views only</summary>
        public float OrthoHeight;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Camera New() => new Camera { StructSize = (uint)sizeof(Camera) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct SceneDesc
    {
        public uint StructSize;
        /// <summary>0</summary>
        public uint Reserved;

        /// <summary>Zeros, with StructSize set.</summary>
        public static SceneDesc New() => new SceneDesc { StructSize = (uint)sizeof(SceneDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Hit
    {
        public uint StructSize;
        /// <summary>instance, as dm_scene_add returned it</summary>
        public uint Instance;
        /// <summary>0 = nothing was hit</summary>
        public ulong Object;
        /// <summary>0 = the body</summary>
        public uint PartId;
        /// <summary>index in the host's mesh</summary>
        public uint Triangle;
        /// <summary>host units from the ray's origin</summary>
        public float Distance;
        /// <summary>barycentric weights of the triangle's second and third corners</summary>
        public float U;
        /// <summary>barycentric weights of the triangle's second and third corners</summary>
        public float V;
        /// <summary>host world frame</summary>
        public Vec3 Point;
        /// <summary>unit geometric normal, by the triangle's winding; host world frame</summary>
        public Vec3 Normal;
        /// <summary>The same point in the object's frame with the part as it is now, for dm_drag_desc.grab_point.</summary>
        public Vec3 ObjectPoint;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Hit New() => new Hit { StructSize = (uint)sizeof(Hit) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Core1
    {
        /// <summary>size of this table in the library in use; check it before you call a newer entry</summary>
        public uint StructSize;
        public uint Reserved;
        public IntPtr ResultString;
        public IntPtr Version;
        public IntPtr ContextCreate;
        public IntPtr ContextDestroy;
        public IntPtr ContextGetMemory;
        public IntPtr ModelLoad;
        public IntPtr ModelUnload;
        public IntPtr MeshFindPart;
        public IntPtr ObjectPrepare;
        public IntPtr ObjectSave;
        public IntPtr ObjectLoad;
        public IntPtr ObjectDestroy;
        public IntPtr ObjectGetInfo;
        public IntPtr ObjectGetPart;
        public IntPtr ObjectGetJoint;
        public IntPtr ObjectGetHypotheses;
        public IntPtr ObjectRefine;
        public IntPtr ObjectSetJoint;
        public IntPtr ObjectResetJoint;
        public IntPtr JointPose;
        public IntPtr JointValue;
        public IntPtr JointGetFrame;
        public IntPtr JointScale;
        public IntPtr MotionGenerate;
        public IntPtr MotionSample;
        public IntPtr MotionGetFrames;
        public IntPtr MotionDestroy;
        public IntPtr DragBegin;
        public IntPtr DragUpdate;
        public IntPtr DragRelease;
        public IntPtr DragEnd;
        public IntPtr DragGetPartState;
        public IntPtr DragSnapshotSize;
        public IntPtr DragSave;
        public IntPtr DragRestore;
        public IntPtr PoseMultiply;
        public IntPtr PoseToMatrix;
        public IntPtr PoseApplyPoints;
        public IntPtr CameraRay;
        public IntPtr SceneCreate;
        public IntPtr SceneDestroy;
        public IntPtr SceneAdd;
        public IntPtr SceneMove;
        public IntPtr SceneRemove;
        public IntPtr SceneCommit;
        public IntPtr ScenePick;
        public IntPtr DragStep;
        public IntPtr DragTake;
        public IntPtr ObjectSetLinks;
        public IntPtr ObjectFollowLinks;
        public IntPtr JointValueAt;
        public IntPtr PoseInverse;
        public IntPtr PoseFromRotation;
        public IntPtr AssetCreate;
        public IntPtr AssetDestroy;
        public IntPtr AssetGetInfo;
        public IntPtr AssetGetPart;
        public IntPtr AssetGetJoint;
        public IntPtr AssetGetPartNodes;
        public IntPtr AssetGetNodeParts;
        public IntPtr AssetMakeObject;
        public IntPtr ContextTrim;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Core1 New() => new Core1 { StructSize = (uint)sizeof(Core1) };
    }

    /// <summary>Gives access to files beside a .gltf: to buffers when it is opened, to images when it is exported or a surface is asked for.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfFiles
    {
        public void* User;
        /// <summary>Hands over the bytes of the file at `path`, which is relative to the document, UTF-8, with '/' between folders. The path is never absolute, and has no "..", backslash or colon. Returns DM_OK, DM_ERROR_OUT_OF_MEMORY, or any other number when there is no such file.</summary>
        public IntPtr Open;
        /// <summary>Takes the bytes back, before dm_gltf_close returns.</summary>
        public IntPtr Close;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfDesc
    {
        public uint StructSize;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>the bytes of a .glb or .gltf; borrowed for the call</summary>
        public void* Data;
        public UIntPtr Size;
        /// <summary>zeros = malloc/free</summary>
        public Allocator Allocator;
        /// <summary>zeros = silent</summary>
        public Log Log;
        /// <summary>Zeros = none: everything is embedded. `user` must live as long as the dm_gltf.</summary>
        public GltfFiles Files;
        /// <summary>Callback of dm_gltf_open, dm_gltf_open_file and dm_gltf_export; NULL = none. A call that it stops answers CANCELLED.</summary>
        public IntPtr Progress;
        /// <summary>must live as long as the dm_gltf</summary>
        public void* ProgressUser;

        /// <summary>Zeros, with StructSize set.</summary>
        public static GltfDesc New() => new GltfDesc { StructSize = (uint)sizeof(GltfDesc) };
    }

    /// <summary>What moves as one: a node that has a mesh, or a bone of a skin with the triangles that go with it. Vertices and faces are those of the merged mesh. The merged mesh holds the nodes with meshes in file order (the order of the nodes array), and the primitives of a node in order. Its vertices are in the scene's frame less dm_gltf_get_origin, with node transforms applied. Primitives of a node that share an accessor share its vertices. A node with a skin is stored bone by bone, as its bones stand in the file; a vertex goes with its heaviest bone.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfNode
    {
        /// <summary>Valid UTF-8, with '?' for each piece that is none; "" when it has none. It lives as long as the dm_gltf.</summary>
        public byte* Name;
        /// <summary>index of the node or bone in the file's nodes array; instances come behind them</summary>
        public uint Node;
        /// <summary>Index of the nearest dm_gltf_node above it, with which it moves, or DM_GLTF_NO_CARRIER.</summary>
        public uint Carrier;
        public ulong FirstVertex;
        public ulong VertexCount;
        public ulong FirstFace;
        public ulong FaceCount;
        /// <summary>base colour factor of its first material, linear; white without one</summary>
        public fixed float Colour[4];
    }

    /// <summary>Faces of the merged mesh that lie side by side and have one material. A dm_gltf_node has one or more surfaces.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfSurface
    {
        public ulong FirstFace;
        public ulong FaceCount;
        /// <summary>base colour factor, linear; white without a material</summary>
        public fixed float Colour[4];
        /// <summary>The base colour texture as it is stored, in sRGB: PNG, JPEG, or what an extension has. NULL: none. Surfaces with the same image have the same pointer. It lives as long as the dm_gltf.</summary>
        public void* Image;
        /// <summary>bytes</summary>
        public UIntPtr ImageSize;
        /// <summary>DM_GLTF_WRAP_*</summary>
        public int WrapU;
        /// <summary>DM_GLTF_WRAP_*</summary>
        public int WrapV;
    }

    /// <summary>One animated part: the faces it takes and its key poses (host frame = the file's scene frame, from rest).</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfTrack
    {
        /// <summary>name of the new node and animation target; NULL = "moving_part"</summary>
        public byte* Name;
        /// <summary>face_count ids of the merged mesh</summary>
        public byte* FaceIds;
        /// <summary>faces with this id move</summary>
        public byte Value;
        public fixed byte Reserved[7];
        /// <summary>key_count poses</summary>
        public Pose* Poses;
        /// <summary>seconds, rising</summary>
        public float* Times;
        public uint KeyCount;
        public uint Reserved2;
    }

    /// <summary>A mesh to write as one node of a new .glb.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfPart
    {
        public byte* Name;
        /// <summary>vertex_count x 3 numbers, glTF frame</summary>
        public float* Positions;
        /// <summary>index_count indices</summary>
        public uint* Indices;
        public ulong VertexCount;
        public ulong IndexCount;
        /// <summary>base colour, linear; clamped to 0 to 1</summary>
        public fixed float Colour[4];
    }

    /// <summary>The input and the answers of dm_asset_create. Everything is borrowed for the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfRigDesc
    {
        public uint StructSize;
        /// <summary>DM_GLTF_RIG_*</summary>
        public uint Formats;
        /// <summary>the nodes that dm_asset_create took</summary>
        public AssetNode* Nodes;
        /// <summary>all parts that dm_asset_get_part answers; NULL: none</summary>
        public AssetPart* Parts;
        /// <summary>all joints that dm_asset_get_joint answers, one a part</summary>
        public Joint* Joints;
        /// <summary>what dm_asset_get_node_parts answers</summary>
        public uint* NodeParts;
        /// <summary>red, green, blue, opacity of each node, linear; NULL: white</summary>
        public float* Colours;
        /// <summary>name of the asset, UTF-8; NULL: "asset"</summary>
        public byte* Name;
        /// <summary>name of each part, UTF-8; NULL: that of its first node that has one</summary>
        public byte** PartNames;
        /// <summary>The file whose dm_gltf_get_asset has made the nodes; NULL: there is none. A GLB needs it. Where `colours` is NULL, nodes have the colours of the file.</summary>
        public IntPtr Gltf;
        public uint NodeCount;
        public uint PartCount;
        /// <summary>axes of the asset frame: DM_AXES_*, except DM_AXES_CUSTOM</summary>
        public int Axes;
        /// <summary>length of one unit of the asset, m; 0 = 1</summary>
        public float UnitInMetres;
        /// <summary>density of closed pieces, kg/m³; 0 = 600, wood</summary>
        public float Density;
        /// <summary>thickness of pieces that are open surfaces, m; 0 = 0.003</summary>
        public float Thickness;
        /// <summary>share of a part's weight that holds it back; 0 = 0.1; negative: none</summary>
        public float Friction;
        /// <summary>Seconds in which a part that nothing drives loses 63 % of its speed; 0 = 0.5; negative: no damping.</summary>
        public float DampingTime;
        /// <summary>zeros = malloc/free</summary>
        public Allocator Allocator;
        /// <summary>zeros = silent; gets warnings of what a format cannot hold</summary>
        public Log Log;

        /// <summary>Zeros, with StructSize set.</summary>
        public static GltfRigDesc New() => new GltfRigDesc { StructSize = (uint)sizeof(GltfRigDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfRigFile
    {
        /// <summary>path below the folder of the rig: letters, digits, '_', '.', and '/' between folders</summary>
        public byte* Path;
        /// <summary>lives as long as the dm_gltf_rig</summary>
        public void* Data;
        public UIntPtr Size;
    }

    /// <summary>The functions of the C header.</summary>
    public static unsafe class Native
    {
#if UNITY_IOS && !UNITY_EDITOR
        public const string Library = "__Internal", GltfLibrary = "__Internal";
#else
        public const string Library = "dragmesh", GltfLibrary = "dragmesh_gltf";
#endif

        /// <summary>Returns the name of a result, such as "DM_ERROR_EMPTY_MASK", or "DM_ERROR_UNKNOWN" for a number that is not one. It never returns NULL. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* dm_result_string(int result);

        /// <summary>Returns the version of the library in use, as a number like DM_VERSION. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_version();

        /// <summary>Returns the function table of an interface id, or NULL for an unknown one. "dm.core/1" gives a const dm_core_1*. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void* dm_get_interface(byte* id);

        /// <summary>Creates a context. desc NULL stands for all defaults. Errors: UNSUPPORTED when desc.picking asks for a picker that is not there. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_context_create(ContextDesc* desc, IntPtr* out_context);

        /// <summary>Destroys a context and everything made with it. NULL does nothing. [exclusive context]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_context_destroy(IntPtr context);

        /// <summary>Writes how much memory a context holds. out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_context_get_memory(IntPtr context, MemoryInfo* out_info);

        /// <summary>Returns the scratch memory that the context keeps for later calls (dm_memory_info.kept_bytes) to the host's allocator, for instance when a level has loaded. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_context_trim(IntPtr context);

        /// <summary>Loads weights. Errors: BAD_DATA, WRONG_MODEL, VERSION. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_model_load(IntPtr context, ModelDesc* desc, ulong* out_model);

        /// <summary>Frees weights. Objects prepared with them keep their joints, and motions made with them stay; new motions and refinements of such objects answer NO_MODEL. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_model_unload(IntPtr context, ulong model);

        /// <summary>Finds the part that a point of the surface belongs to, in a mesh whose parts are not known. Writes 1 to out_face_ids for every triangle of the part and 0 for the others; as part ids per face they can go into a dm_mesh_desc unchanged. The call takes up to tens of milliseconds, and a second for tens of thousands of loose pieces; its time grows at most linearly with their number. mesh-&gt;part_ids: pieces known to be rigid, such as the nodes of a scene; the grabbed one moves, together with what is fastened to it alone. With NULL, or with one piece, the part is put together from the mesh's sheets of surface. drag: the point where the part was grabbed, and the direction of the pull; a zero vector means no direction. Errors: those of dm_object_prepare for a mesh; BUFFER_TOO_SMALL when face_count is less than the mesh's; DRAG_OFF_PART; FULL_MASK when nothing is left that stays; CANCELLED. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_mesh_find_part(IntPtr context, MeshDesc* mesh, DragHint* drag, byte* out_face_ids, ulong face_count);

        /// <summary>Infers how each part of a mesh moves, and makes an object of it. The call takes up to tens of milliseconds for a usual object (docs/performance.md) and uses dm_jobs. It warns once where the answer is worse than it could be (DM_DEGRADED_*). Errors: NOT_FINITE, INDEX_OUT_OF_RANGE (also for an answer of desc.choose), EMPTY_MASK, DEGENERATE_MESH, ZERO_DRAG, DRAG_OFF_PART, TOO_LARGE, CANCELLED. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_prepare(IntPtr context, ObjectDesc* desc, ulong* out_object);

        /// <summary>Writes a prepared object as .dmo bytes, which are versioned, checksummed and little-endian. Call it with a NULL buffer to learn the size. out_size gets the bytes needed or written, also with BUFFER_TOO_SMALL. Triangles are stored with trees of the library's own, so that loading builds none; where the object has other trees, each call builds the library's. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_save(IntPtr context, ulong @object, void* buffer, UIntPtr capacity, UIntPtr* out_size);

        /// <summary>Loads what dm_object_save has written, by this or any earlier version. model: the weights of its motions; may be 0. The file's own trees are used where desc.picking of the context is DM_PICK_AUTO or DM_PICK_PORTABLE (dm_object_info.picking). Errors: BAD_DATA, VERSION, CANCELLED. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_load(IntPtr context, void* data, UIntPtr size, ulong model, ulong* out_object);

        /// <summary>Destroys an object. Its drags and motions end with it, and its instances leave their scenes. [exclusive object, and none of those in use]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_destroy(IntPtr context, ulong @object);

        /// <summary>Writes counts, box and size of an object. out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_info(IntPtr context, ulong @object, ObjectInfo* out_info);

        /// <summary>Writes the part at a position, 0 to part_count - 1, in order of id. out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_part(IntPtr context, ulong @object, uint index, PartInfo* out_info);

        /// <summary>Writes the joint in force: the best hypothesis, or the host's own. out_joint-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_joint(IntPtr context, ulong @object, uint part_id, Joint* out_joint);

        /// <summary>Writes the hypotheses of a part, best first. When `drag` is given, it re-ranks them, which takes microseconds and no network pass. capacity: up to DM_MAX_HYPOTHESES. out_joints[0].struct_size must be set, and the others get it. out_count gets how many were written. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_hypotheses(IntPtr context, ulong @object, uint part_id, DragHint* drag, Joint* out_joints, uint capacity, uint* out_count);

        /// <summary>Infers the joint of one part again with the player's drag as evidence, and puts the result in force. It takes milliseconds, so it is not for every frame. Errors: NO_MODEL; UNSUPPORTED when the object kept no triangles; CANCELLED, which leaves the joint in force. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_refine(IntPtr context, ulong @object, uint part_id, DragHint* drag);

        /// <summary>Puts the host's own joint in force. Its axis may have any length, and its limits may be infinite (dm_joint.lower). Its source becomes DM_JOINT_FROM_HOST and both confidences 1, unless the joint is, bit for bit, the one in force or the library's own answer; it then keeps the source and the confidences of that one. Drags and motions that already run keep the joint they began with. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_set_joint(IntPtr context, ulong @object, uint part_id, Joint* joint);

        /// <summary>Puts the library's own answer back in force, after dm_object_set_joint or a choice. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_reset_joint(IntPtr context, ulong @object, uint part_id);

        /// <summary>Replaces all links between parts of an object by copies of these. count: 0, which removes all, to DM_MAX_LINKS. A saved object does not hold links. Errors: INVALID_ARGUMENT also when two drivers move one part, or a part moves itself through other links; NOT_FOUND. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_set_links(IntPtr context, ulong @object, Link* links, uint count);

        /// <summary>Moves everything that is linked with a part that has moved. inout_values: the joint values of one instance, one a part, in the order of dm_object_get_part. The value of the moved part itself changes too when a driver of it is at its limit; dm_drag_override takes that value. out_held: gets 1 for each part that links hold where it is (DM_INPUT_LOCKED), else 0; may be NULL. count: the number of parts, which is the length of both. The limits are those of the joints in force, for the unscaled instance. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_follow_links(IntPtr context, ulong @object, uint part_id, float* inout_values, byte* out_held, uint count);

        /// <summary>Infers which nodes of an asset move, which of them move as one, what carries what, and how each part moves. The same nodes in the same order give the same bits. The call takes about as long as dm_object_prepare for all of its nodes, and uses dm_jobs. It warns once where the answer is worse than it could be. Errors, whose messages name the node: NOT_FINITE, INDEX_OUT_OF_RANGE, DEGENERATE_MESH, TOO_LARGE, CANCELLED; INVALID_ARGUMENT also when parents or followers form a circle, a name is not UTF-8, or no node has a mesh. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_create(IntPtr context, AssetDesc* desc, ulong* out_asset);

        /// <summary>Destroys an asset. Objects made of it stay. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_destroy(IntPtr context, ulong asset);

        /// <summary>Writes counts and warnings of an asset. out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_info(IntPtr context, ulong asset, AssetInfo* out_info);

        /// <summary>Writes the part at an index, 0 to part_count - 1. out_part-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_part(IntPtr context, ulong asset, uint index, AssetPart* out_part);

        /// <summary>Writes the joint of a part, in the asset frame. For a part that stays, it is the joint by which it would move. out_joint-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_joint(IntPtr context, ulong asset, uint index, Joint* out_joint);

        /// <summary>Writes the indices of a part's nodes, rising: dm_asset_part.node_count of them. Errors: BUFFER_TOO_SMALL when capacity is less. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_part_nodes(IntPtr context, ulong asset, uint index, uint* out_nodes, uint capacity);

        /// <summary>Writes the index of the part of each node, or DM_ASSET_NO_PART for nodes of the body: dm_asset_info.node_count numbers. Errors: BUFFER_TOO_SMALL when capacity is less. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_node_parts(IntPtr context, ulong asset, uint* out_parts, uint capacity);

        /// <summary>Makes a prepared object of the parts that move or are free. They carry each other as in the asset, and all else is the body. The object has the triangles of the nodes that do not follow others, node after node. Errors: EMPTY_MASK when nothing moves. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_make_object(IntPtr context, ulong asset, ulong* out_object);

        /// <summary>Writes the pose of a joint at a value, from rest, in the frame in which the joint is given. The axis may have any length, here and in the functions below. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_pose(Joint* joint, float value, Pose* out_pose);

        /// <summary>Inverts dm_joint_pose: writes the value at which the joint comes nearest to a pose. out_angle_error gets the angle between both poses, rad. out_distance_error gets the distance between the places of the joint's origin under both, host units. Both may be NULL. Of values one turn apart, the answer is the one inside the limits, or else the one nearest to 0; for a screw, its advance decides. Errors: NOT_FINITE when an answer is beyond a float's range. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_value(Joint* joint, Pose* pose, float* out_value, float* out_angle_error, float* out_distance_error);

        /// <summary>Writes the joint value at a share of the way from rest to the open end, which is the limit farther from rest: 0 is rest, 1 is open, 0.1 is ajar. Errors: INVALID_ARGUMENT for a joint without limits. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_value_at(Joint* joint, float share, float* out_value);

        /// <summary>Writes the joint as a constraint of a physics engine. out_frame-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_get_frame(Joint* joint, JointFrame* out_frame);

        /// <summary>Converts a joint to the frame of an instance that is scaled by (x, y, z), as dm_drag_begin does. The axis is the line through the scaled points. Limits of slides and the pitch are in scaled units; angles stay as they are. A zero counts as 1. out_joint-&gt;struct_size must be set; it may be `joint`. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_scale(Joint* joint, Vec3 scale, Joint* out_joint);

        /// <summary>Generates the DQ-VAE's motion for a drag, projected exactly onto the joint in force. The motion of a fixed part stays at rest. Errors: NO_MODEL, ZERO_DRAG, DRAG_OFF_PART. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_generate(IntPtr context, ulong @object, MotionDesc* desc, ulong* out_motion);

        /// <summary>Writes pose and joint value of a motion at t, which is clamped to [0, 1]; 0 is rest. Between key poses the part follows the joint's own screw. out_value may be NULL. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_sample(IntPtr context, ulong motion, float t, Pose* out_pose, float* out_value);

        /// <summary>Writes the DM_MOTION_FRAMES key poses and their joint values. out_values may be NULL. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_get_frames(IntPtr context, ulong motion, Pose* out_poses, float* out_values);

        /// <summary>Destroys a motion that no other thread samples. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_destroy(IntPtr context, ulong motion);

        /// <summary>Starts a drag: the player grabs a part. Where the library found the joint, the pull is more evidence. The drag holds the part's other hypotheses and likely joints beyond them, and follows the one that explains the pull best. Limits that were estimated give when the pull goes on beyond them. docs/feel.md describes how. The call warns of a grab point or value in other units than expected (millimetres, degrees). [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_begin(IntPtr context, DragDesc* desc, ulong* out_drag);

        /// <summary>Advances a drag by dt seconds. The grabbed point follows the pointer's ray (object frame, scaled with dm_drag_desc.scale) as closely as the joint allows. Pass the ray that grabbed the part first. The whole drag keeps the angle by which this ray misses the grab point, up to 0.032 rad, so that the part does not move before the pointer does. A dt from -1e-4 to 0, as clocks round it, counts as 0. After dm_drag_release the part moves by itself, and ray may be NULL. out_state-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_update(IntPtr context, ulong drag, Ray* ray, float dt, DragState* out_state);

        /// <summary>Does what dm_drag_update does, with everything that a dm_drag_input holds. A released part needs no hand. Errors: INVALID_ARGUMENT, also for handles, bounds and DM_INPUT_LOCKED of a drag without dm_drag_desc.rules. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_step(IntPtr context, ulong drag, DragInput* input, float dt, DragState* out_state);

        /// <summary>Replaces the value that an update with DM_INPUT_ASK has proposed in its out_state. The value is brought inside the limits and bounds of that update, and the events become those of the value taken. Without this call, the update stands. Errors: INVALID_ARGUMENT when the last update did not ask. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_take(IntPtr context, ulong drag, float value, DragState* out_state);

        /// <summary>Releases the part, which then does what the player meant: it swings open, falls shut, springs back or stays. The DQ-VAE paces it where the object has its weights, unless desc.flags forbids it. dm_drag_update moves it, and dm_drag_end may end the drag at any time; another release replaces this one, or replays. desc NULL stands for all defaults. out_plan may be NULL, else its struct_size must be set. The call takes up to a millisecond. One caller at a time per drag. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_release(IntPtr context, ulong drag, ReleaseDesc* desc, ReleasePlan* out_plan);

        /// <summary>Ends a drag and destroys it. out_state gets what dm_drag_get_part_state gives; it may be NULL, else its struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_end(IntPtr context, ulong drag, PartState* out_state);

        /// <summary>Writes where the part stands, and the joint that the drag follows now, with the limits and the confidence that the pull has left it. A drag that begins with this state as dm_drag_desc.state goes on where this one is. out_state-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_get_part_state(IntPtr context, ulong drag, PartState* out_state);

        /// <summary>Returns how many bytes dm_drag_save writes. The number is the same for every drag of this library, and DM_DRAG_SNAPSHOT_MAX at most. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr dm_drag_snapshot_size();

        /// <summary>Writes the whole state of a drag, for rollback. After dm_drag_restore, the same calls give the same bits. Only this very version of the library on this kind of machine can read it; dm_part_state is what lasts. Errors: BUFFER_TOO_SMALL when capacity is less than dm_drag_snapshot_size. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_save(IntPtr context, ulong drag, void* buffer, UIntPtr capacity);

        /// <summary>Restores a state that dm_drag_save has written, of this or any other drag of the same part. An error leaves the drag as it is: BAD_DATA, VERSION, or INVALID_ARGUMENT when the state belongs to another part. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_restore(IntPtr context, ulong drag, void* data, UIntPtr size);

        /// <summary>Writes the pose that applies b first and then a: x -&gt; a(b(x)). out_pose may be `a` or `b`. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_multiply(Pose* a, Pose* b, Pose* out_pose);

        /// <summary>Writes the inverse of a pose, which takes the points that the pose has moved back. out_pose may be `pose`. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_inverse(Pose* pose, Pose* out_pose);

        /// <summary>Writes the pose that rotates first and then translates, as engines keep the place of a node. rotation: a quaternion x, y, z, w of any length. Errors: INVALID_ARGUMENT when it has no length; NOT_FINITE. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_pose_from_rotation(float* rotation, Vec3 translation, Pose* out_pose);

        /// <summary>Writes a pose as a 4x4 matrix, column-major for column vectors (the memory order of OpenGL, glTF and Unity's Matrix4x4). [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_to_matrix(Pose* pose, float* out_matrix);

        /// <summary>Moves `count` float32 points by a pose. Strides are in bytes, and 0 means packed. src may equal dst. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_apply_points(Pose* pose, float* src, UIntPtr src_stride, float* dst, UIntPtr dst_stride, UIntPtr count);

        /// <summary>Writes the ray through pixel (x, y) in the host's world frame; (0, 0) is the top left corner of the viewport. Its direction is a unit vector. Errors: INVALID_ARGUMENT when the camera has no view; NOT_FINITE when the ray's origin is beyond a float's range. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_camera_ray(IntPtr context, Camera* camera, float x, float y, Ray* out_ray);

        /// <summary>Creates an empty scene. Errors: UNSUPPORTED when the context picks nothing (DM_PICK_NONE, or no picker was found). [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_create(IntPtr context, SceneDesc* desc, ulong* out_scene);

        /// <summary>Destroys a scene with its instances. Their objects stay. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_destroy(IntPtr context, ulong scene);

        /// <summary>Places a prepared object in a scene, from the next dm_scene_commit on. placement: pose from the object frame to the world; NULL = identity. out_instance gets a small number from 0 on, which may be used again after a removal. Errors: UNSUPPORTED when the object cannot be picked, because it kept no triangles, or is smaller than 1e-6 or larger than 1e12 host units. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_add(IntPtr context, ulong scene, ulong @object, Pose* placement, uint* out_instance);

        /// <summary>Moves a part of an instance to a pose from rest, in the object frame, which includes the pose of the parts that carry it. With part_id 0 it moves the whole instance to a new placement. The move takes effect with dm_scene_commit. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_move(IntPtr context, ulong scene, uint instance, uint part_id, Pose* pose);

        /// <summary>Removes an instance from a scene, at once. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_remove(IntPtr context, ulong scene, uint instance);

        /// <summary>Makes all moves since the last commit visible to picks. Call it once a frame, after the moves. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_commit(IntPtr context, ulong scene);

        /// <summary>Finds the nearest hit of a ray. The answer is DM_OK with out_hit-&gt;object 0 when nothing is hit. Several threads may pick at once while none moves or commits. out_hit-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_pick(IntPtr context, ulong scene, Ray* ray, Hit* out_hit);

        /// <summary>Returns the version of the libdragmesh_gltf in use, as a number like DM_VERSION.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_version();

        /// <summary>Opens the bytes of a .glb or .gltf. Reads triangles, strips and fans, also quantised ones (KHR_mesh_quantization) and, where the build has their libraries, compressed ones (EXT_meshopt_compression, KHR_meshopt_compression, KHR_draco_mesh_compression). Another required extension that may change geometry is refused as UNSUPPORTED, by name. Morph targets are applied as the file's weights say. An instance of EXT_mesh_gpu_instancing becomes a node of its own, behind those of the file, below the node that has the extension. These are left out with a warning: triangles whose vertices do not exist or are not finite, broken primitives, points, lines, and nodes whose scale is zero. These are left out in silence, because they are no body: nodes and meshes named UCX_*, UBX_*, UCP_*, USP_*, *_collider, *-colonly, *-convcolonly; coarser levels of detail (MSFT_lod, or siblings named *_LOD0, *_LOD1); invisible nodes (KHR_node_visibility); and materials of alpha 0. A call logs one warning, which counts what is left out and quotes the first three. Errors: when nothing is left, the first reason: BAD_DATA, NOT_FINITE, INDEX_OUT_OF_RANGE or DEGENERATE_MESH; NOT_FOUND for a file beside it; VERSION; TOO_LARGE when it would take more memory than 64 MB and 64 bytes a byte of the file, or 256 a byte of a Draco stream.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_open(GltfDesc* desc, IntPtr* out_gltf);

        /// <summary>Opens a file and those beside it, which are read from its folder and from nowhere else. `desc` leaves data, size and files at 0. Errors: those of dm_gltf_open; NOT_FOUND when there is no such regular file.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_open_file(byte* path, GltfDesc* desc, IntPtr* out_gltf);

        /// <summary>Closes a file and frees all that points into it. NULL does nothing.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_close(IntPtr gltf);

        /// <summary>Returns how many nodes there are, and 0 for NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_node_count(IntPtr gltf);

        /// <summary>Writes the node at an index. Errors: INVALID_ARGUMENT, NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_node(IntPtr gltf, uint index, GltfNode* out_node);

        /// <summary>Writes the merged mesh, which points into the dm_gltf: positions as float32, indices as uint32, no part ids.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_mesh(IntPtr gltf, MeshDesc* out_mesh);

        /// <summary>Writes where the merged mesh's origin is in the scene. It is 0, 0, 0 unless the object is more than 256 times its size away, where floats could not hold its shape.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_get_origin(IntPtr gltf, double* out_origin);

        /// <summary>Returns how many surfaces there are, and 0 for NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_surface_count(IntPtr gltf);

        /// <summary>Writes the surface at an index. An image that cannot be read is left out with a warning. Errors: NOT_FOUND, OUT_OF_MEMORY.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_surface(IntPtr gltf, uint index, GltfSurface* out_surface);

        /// <summary>Writes where the corners of a surface lie in its base colour texture: u and v of each, three corners a face, in the order of the merged mesh. (0, 0) is the image's top left corner. They are scaled, turned and shifted as the material says (KHR_texture_transform). corner_count: three times face_count. Errors: NOT_FOUND when there is no texture, or there are no coordinates; BUFFER_TOO_SMALL, BAD_DATA, OUT_OF_MEMORY.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_texture_coordinates(IntPtr gltf, uint index, float* out_uv, ulong corner_count);

        /// <summary>Sets `value` for every face of the named nodes or bones and of all that they carry. A name that several nodes share means all of them. The name of a node with a skin means all its bones. "#12" means node 12 of the file, for files without names. Errors: NOT_FOUND, whose message has the first missing name and some that exist.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_mark_faces(IntPtr gltf, byte** names, uint name_count, byte value, byte* inout_face_ids, ulong face_count);

        /// <summary>Writes what the file says of a node, as dm_part_desc takes it. The label has the names of the nodes that carry it, outermost first, of its mesh and its own, joined by '/'. The pivot has its origin and axes in the merged mesh's frame. name: as for dm_gltf_mark_faces; of several nodes, the first counts. out_label: label_size bytes, from which the outer names are left out where not all fit; may be NULL. out_pivot may be NULL. Errors: NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_hints(IntPtr gltf, byte* name, byte* out_label, UIntPtr label_size, Pivot* out_pivot);

        /// <summary>Writes the scene as dm_asset_create takes it: all nodes that have triangles or carry some, and nodes that the merged mesh leaves out because they are no body. First come the dm_gltf_nodes in their order, then groups without triangles, then what is hidden, a collider or a coarser level of detail (DM_ASSET_NODE_FOLLOWS). Meshes are in the merged mesh's frame, so that transforms are NULL. Clips are the file's animations, each relative to the node above it. Joints are those of the nodes' `extras` and of KHR_physics_rigid_bodies (docs/gltf.md). flags: 0. The list points into the dm_gltf. Errors: OUT_OF_MEMORY, TOO_LARGE.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_asset(IntPtr gltf, uint flags, AssetNode** out_nodes, uint* out_count);

        /// <summary>Writes the index in the file's nodes array of a node of that list. Errors: those of dm_gltf_get_asset; NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_asset_node(IntPtr gltf, uint index, uint* out_node);

        /// <summary>Returns 1 when pivots say nothing: the file has several dm_gltf_nodes, and the origins of all follow one rule, as exporters leave them. They are one point, or lie at the same place of each node's box (middle, lowest corner, middle of a face …). Returns 0 when some may say something, or gltf is NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_pivots_are_lost(IntPtr gltf);

        /// <summary>Writes how a node's pivot came to lie where it is (DM_PIVOT_*), for dm_part_desc.pivot_kind. A rule holds where the node with the largest surface and more than half of all nodes follow it. The answer is then DM_PIVOT_DEFAULT for a node that follows it and DM_PIVOT_SET for the others. It is DM_PIVOT_UNKNOWN when no rule holds, or the node has no triangles. name: as for dm_gltf_get_hints. Errors: NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_pivot_kind(IntPtr gltf, byte* name, int* out_kind);

        /// <summary>Returns 1 when triangles of the file are missing in the merged mesh, because a triangle, a primitive or a node could not be read, or only one of its instances was. Warnings of dm_gltf_open name them. Pass DM_PREPARE_MESH_INCOMPLETE then. Returns 0 when all are there, or gltf is NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_left_out(IntPtr gltf);

        /// <summary>Reads a part mask: a .npy or JSON array with one integer a vertex or a face, in the order of the file where bones sort the merged mesh otherwise. mask_value: the value of the part that moves; NULL = every value but 0. out_part_ids: as many bytes as max(vertex_count, face_count). out_ambiguous: gets 1 when both lengths fit, and the integers were taken per vertex; may be NULL. Errors: BAD_DATA; INVALID_ARGUMENT when neither length fits; EMPTY_MASK; FULL_MASK.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_read_mask(IntPtr gltf, void* data, UIntPtr size, long* mask_value, byte* out_part_ids, int* out_scope, int* out_ambiguous);

        /// <summary>Writes a .glb with the file's meshes and materials. The tracks' faces are split off into nodes of their own, which a looping animation moves. Without tracks it adds no animation. The file's own animations stay as they are, and still move the nodes that they name. Release out_data with dm_gltf_release_bytes.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_export(IntPtr gltf, GltfTrack* tracks, uint track_count, void** out_data, UIntPtr* out_size);

        /// <summary>Releases bytes of dm_gltf_export, with the allocator of the dm_gltf.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_release_bytes(IntPtr gltf, void* data, UIntPtr size);

        /// <summary>Writes a static .glb with one identity node a part. allocator: zeros = malloc/free; release out_data with the same.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_write(GltfPart* parts, uint part_count, Allocator* allocator, Log* log, void** out_data, UIntPtr* out_size);

        /// <summary>Makes any text valid UTF-8, in place: it puts a '?' for each piece that is no character, also for one that was cut off. Names and messages of this library are valid already; hosts need it for what they write beside them. Returns the new length, which is never longer, and 0 for NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr dm_gltf_mend_text(byte* text);

        /// <summary>Makes the files of all formats asked for in memory, with the meshes that they share. Parts that move become bodies, in metres and Z up, hung on what carries them. Parts that stay, and fixed ones, are one with it. Bodies are called part_N_NAME, where N is the part's index + 1 and NAME what is legal of its first node's name; the body that stays is "body". Errors: those of the meshes, NOT_FINITE, INVALID_ARGUMENT (no format, parents in a circle), INDEX_OUT_OF_RANGE, DEGENERATE_MESH (no triangle), OUT_OF_MEMORY, STRUCT_SIZE.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_rig_make(GltfRigDesc* desc, IntPtr* out_rig);

        /// <summary>Frees the files. NULL does nothing.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_rig_destroy(IntPtr rig);

        /// <summary>Returns how many files there are, and 0 for NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_rig_file_count(IntPtr rig);

        /// <summary>Writes the path and the bytes of a file. Meshes come before the files that refer to them. Errors: INVALID_ARGUMENT, NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_rig_get_file(IntPtr rig, uint index, GltfRigFile* out_file);

        /// <summary>Does what dm_drag_update does, with everything that a dm_drag_input holds. A released part needs no hand. Errors: INVALID_ARGUMENT, also for handles, bounds and DM_INPUT_LOCKED of a drag without dm_drag_desc.rules. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, EntryPoint = "dm_drag_step")]
        public static extern int dm_drag_update_input(IntPtr context, ulong drag, DragInput* input, float dt, DragState* out_state);

        /// <summary>Replaces the value that an update with DM_INPUT_ASK has proposed in its out_state. The value is brought inside the limits and bounds of that update, and the events become those of the value taken. Without this call, the update stands. Errors: INVALID_ARGUMENT when the last update did not ask. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, EntryPoint = "dm_drag_take")]
        public static extern int dm_drag_override(IntPtr context, ulong drag, float value, DragState* out_state);
    }
}
