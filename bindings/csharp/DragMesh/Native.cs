// The C interface of dragmesh. Written by scripts/describe from the public headers: not to be edited.
using System;
using System.Runtime.InteropServices;

namespace DragMesh
{
    /// <summary>The constants of the C header, under its names.</summary>
    public static class Constants
    {
        public const int DM_VERSION_MAJOR = 0;
        public const int DM_VERSION_MINOR = 3;
        public const int DM_VERSION_PATCH = 0;
        /// <summary>1 while the version that the three numbers name is in development, 0 in its release.</summary>
        public const int DM_VERSION_DEVELOPMENT = 1;
        /// <summary>Number of key poses of a generated motion (paper: T).</summary>
        public const int DM_MOTION_FRAMES = 16;
        /// <summary>Most hypotheses kept for one part.</summary>
        public const int DM_MAX_HYPOTHESES = 8;
        /// <summary>Most parts of one object, the body not counted.</summary>
        public const int DM_MAX_PARTS = 4096;
        /// <summary>Most nodes of one asset. At most DM_MAX_PARTS of them have meshes that are no DM_ASSET_NODE_FOLLOWS.</summary>
        public const int DM_MAX_ASSET_NODES = 65536;
        /// <summary>Most bytes of a label, the zero not counted.</summary>
        public const int DM_MAX_LABEL = 4096;
        /// <summary>Most vertices or triangles of one object.</summary>
        public const int DM_MAX_ELEMENTS = 268435456;
        /// <summary>Most links of one object.</summary>
        public const int DM_MAX_LINKS = 256;
        /// <summary>Most snap values of one drag.</summary>
        public const int DM_MAX_SNAPS = 16;
        /// <summary>No library of the interface dm.core/1 needs more bytes for a dm_drag_save; it says how many by dm_drag_snapshot_size.</summary>
        public const int DM_DRAG_SNAPSHOT_MAX = 65536;
        /// <summary>no node: the scene itself</summary>
        public const uint DM_ASSET_NO_NODE = 4294967295;
        /// <summary>no part: the body that stays</summary>
        public const uint DM_ASSET_NO_PART = 4294967295;
        public const uint DM_GLTF_NO_CARRIER = 4294967295;
        public const int DM_OK = 0;
        /// <summary>a null pointer, an unknown enum value, a count that makes no sense</summary>
        public const int DM_ERROR_INVALID_ARGUMENT = -1;
        /// <summary>struct_size too small, or a newer field is set that this library can't know</summary>
        public const int DM_ERROR_STRUCT_SIZE = -2;
        /// <summary>null, destroyed, or of another kind or context</summary>
        public const int DM_ERROR_STALE_HANDLE = -3;
        /// <summary>the host's allocator answered NULL</summary>
        public const int DM_ERROR_OUT_OF_MEMORY = -4;
        /// <summary>a NaN or infinite number in the input</summary>
        public const int DM_ERROR_NOT_FINITE = -5;
        /// <summary>an index names a vertex or a hypothesis that does not exist</summary>
        public const int DM_ERROR_INDEX_OUT_OF_RANGE = -6;
        /// <summary>no triangle belongs to the part</summary>
        public const int DM_ERROR_EMPTY_MASK = -7;
        /// <summary>the mask, or the part found, is the whole mesh: it tells nothing apart</summary>
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
        /// <summary>the output buffer can't hold the answer; the size needed is set</summary>
        public const int DM_ERROR_BUFFER_TOO_SMALL = -18;
        /// <summary>no such part, node or instance</summary>
        public const int DM_ERROR_NOT_FOUND = -19;
        /// <summary>valid, but this build or this file kind can't do it</summary>
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
        /// <summary>dm_context_desc.custom_axes</summary>
        public const int DM_AXES_CUSTOM = 4;
        /// <summary>Embree 3.13 or 4 where its shared library is found, else the library's own</summary>
        public const int DM_PICK_AUTO = 0;
        /// <summary>Embree alone</summary>
        public const int DM_PICK_EMBREE = 1;
        /// <summary>the library's own: everywhere, in the host's memory</summary>
        public const int DM_PICK_PORTABLE = 2;
        /// <summary>nothing, for hosts that cast their own rays: objects keep no trees, there are no scenes</summary>
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
        /// <summary>positions: three each</summary>
        public const int DM_FLOAT32 = 0;
        /// <summary>positions: three each</summary>
        public const int DM_FLOAT64 = 1;
        /// <summary>indices and part ids</summary>
        public const int DM_UINT32 = 0;
        /// <summary>indices and part ids</summary>
        public const int DM_UINT16 = 1;
        /// <summary>indices and part ids</summary>
        public const int DM_UINT8 = 2;
        /// <summary>indices and part ids</summary>
        public const int DM_INT32 = 3;
        public const int DM_PER_VERTEX = 0;
        public const int DM_PER_FACE = 1;
        /// <summary>nothing: it is judged by those of the other parts</summary>
        public const int DM_PIVOT_UNKNOWN = 0;
        /// <summary>where a program puts them all: it says nothing</summary>
        public const int DM_PIVOT_DEFAULT = 1;
        /// <summary>the other nodes' follow a rule and it does not: somebody has set it, and it says the more</summary>
        public const int DM_PIVOT_SET = 2;
        public const int DM_JOINT_FROM_NETWORK = 0;
        public const int DM_JOINT_FROM_GEOMETRY = 1;
        /// <summary>certain, limits too: no pull changes it</summary>
        public const int DM_JOINT_FROM_HOST = 2;
        /// <summary>a hypothesis of the library that dm_object_desc.choose has chosen: no pull puts another joint in its place, or its range on the other side of rest, but its limits are estimates and give</summary>
        public const int DM_JOINT_CHOSEN = 3;
        public const int DM_LIMIT_LOWER = 1;
        public const int DM_LIMIT_UPPER = 2;
        public const int DM_CHOICE_KEEP = -1;
        /// <summary>keep no triangles: the object can't be added to a scene, and is small</summary>
        public const int DM_PREPARE_WITHOUT_PICKING = 1;
        /// <summary>the plain KPP-Net: no geometric candidates, no ranker. To compare with; NO_MODEL when `model` has no kinematics weights</summary>
        public const int DM_PREPARE_NETWORK_ALONE = 2;
        /// <summary>who read the mesh left something of its file out (dm_gltf_left_out): kept as DM_DEGRADED_MESH</summary>
        public const int DM_PREPARE_MESH_INCOMPLETE = 4;
        /// <summary>no weights of KPP-Net: joints are found by geometry alone</summary>
        public const int DM_DEGRADED_NO_KINEMATICS = 1;
        /// <summary>no weights of the ranker: joints are chosen, and limits set, by rules</summary>
        public const int DM_DEGRADED_NO_RANKER = 2;
        /// <summary>no weights of the DQ-VAE: releases are paced by a rule, motions answer NO_MODEL</summary>
        public const int DM_DEGRADED_NO_MOTION = 4;
        /// <summary>everything is of a part: nothing stays that joints could be told by</summary>
        public const int DM_DEGRADED_NO_BODY = 8;
        /// <summary>a pivot was ignored: it is 1,000 object sizes away or more</summary>
        public const int DM_DEGRADED_HINT = 16;
        /// <summary>DM_PREPARE_MESH_INCOMPLETE</summary>
        public const int DM_DEGRADED_MESH = 32;
        /// <summary>neither part nor body: a level of detail, a collider, something hidden. It goes where `follows` goes, and its mesh is not looked at</summary>
        public const int DM_ASSET_NODE_FOLLOWS = 1;
        /// <summary>where its origin lies says nothing</summary>
        public const int DM_ASSET_NODE_NO_PIVOT = 2;
        /// <summary>the animation scales or bends the node as well</summary>
        public const int DM_CLIP_NOT_RIGID = 1;
        /// <summary>clips say nothing</summary>
        public const int DM_ASSET_WITHOUT_CLIPS = 256;
        /// <summary>names and labels say nothing</summary>
        public const int DM_ASSET_WITHOUT_NAMES = 512;
        /// <summary>a clip moves a node as no joint does, or is not rigid</summary>
        public const int DM_ASSET_CLIP_LEFT_OUT = 1;
        /// <summary>it might move, but probably does not: `moves` is below dm_asset_desc.min_moves. Bodies that almost certainly stay are no parts</summary>
        public const int DM_ASSET_STAYS = 0;
        /// <summary>by its joint</summary>
        public const int DM_ASSET_MOVES = 1;
        /// <summary>nothing but its weight holds it, as the lid of a teapot: a player can take it away. Its joint is the slide by which it comes off, with a low confidence</summary>
        public const int DM_ASSET_FREE = 2;
        /// <summary>from shape, contacts and names</summary>
        public const int DM_ASSET_INFERRED = 0;
        /// <summary>dm_asset_node.joint</summary>
        public const int DM_ASSET_FROM_FILE = 1;
        /// <summary>dm_asset_node.clips</summary>
        public const int DM_ASSET_FROM_CLIP = 2;
        /// <summary>follow the joint in force, limits and all, whatever the pull says, as with a host's joint</summary>
        public const int DM_DRAG_KEEP_JOINT = 1;
        /// <summary>no point is grabbed: for hands of DM_HAND_RATE, STEP and VALUE, and for releases. grab_point is not read; the middle of the part's box stands for it</summary>
        public const int DM_DRAG_WITHOUT_POINT = 2;
        /// <summary>the part stays where it is, gives a little, and says so (DM_EVENT_LOCKED)</summary>
        public const int DM_RULE_LOCKED = 1;
        /// <summary>a latch holds it at rest until a handle has turned (dm_drag_input.handles), and catches it again when it comes to rest with the handle let go</summary>
        public const int DM_RULE_LATCH = 2;
        /// <summary>the driven part's value is offset + ratio * (the driver's beyond `from`), inside its limits</summary>
        public const int DM_LINK_MOVES = 0;
        /// <summary>the driven part is held until the driver has reached `from`: a handle</summary>
        public const int DM_LINK_FREES = 1;
        /// <summary>the driven part is held once the driver has reached `from`: of drawers, one at a time</summary>
        public const int DM_LINK_HOLDS = 2;
        /// <summary>of DM_LINK_MOVES: moving the driven part moves the driver</summary>
        public const int DM_LINK_BOTH_WAYS = 1;
        /// <summary>no news of it: the part goes on to where it was asked to be</summary>
        public const int DM_HAND_NONE = 0;
        /// <summary>a pointer: `ray`</summary>
        public const int DM_HAND_RAY = 1;
        /// <summary>a hand in space: `point`. The vector from it to the grabbed point stays as in its first update</summary>
        public const int DM_HAND_POINT = 2;
        /// <summary>a stick or a key held down: `amount`, -1 to 1, times dm_drag_rules.drive_speed</summary>
        public const int DM_HAND_RATE = 3;
        /// <summary>a wheel: moves by `amount`, a share of the range</summary>
        public const int DM_HAND_STEP = 4;
        /// <summary>a slider of the host's: goes to the joint value `amount`</summary>
        public const int DM_HAND_VALUE = 5;
        /// <summary>locked in this update, as by DM_RULE_LOCKED</summary>
        public const int DM_INPUT_LOCKED = 1;
        /// <summary>dm_drag_override may change the value that this update takes</summary>
        public const int DM_INPUT_ASK = 2;
        /// <summary>lower and upper hold, also when they are equal</summary>
        public const int DM_INPUT_BOUNDS = 4;
        /// <summary>follows the pointer</summary>
        public const int DM_DRAG_HELD = 0;
        /// <summary>moves on by itself: dm_drag_release</summary>
        public const int DM_DRAG_RELEASED = 1;
        /// <summary>has come to where it goes</summary>
        public const int DM_DRAG_AT_REST = 2;
        /// <summary>it has met its lower limit (within 0.5 % of the range), dm_drag_state.impact fast; again after it was 2 % away. An estimated limit that has given is none</summary>
        public const int DM_EVENT_LIMIT_LOWER = 1;
        /// <summary>the same of the upper one</summary>
        public const int DM_EVENT_LIMIT_UPPER = 2;
        /// <summary>it is more than 2 % of the range away from rest</summary>
        public const int DM_EVENT_LEFT_REST = 4;
        /// <summary>it is within 0.5 % of the range of rest, having left it</summary>
        public const int DM_EVENT_REACHED_REST = 8;
        /// <summary>dm_drag_rules.open_share</summary>
        public const int DM_EVENT_OPENED = 16;
        /// <summary>dm_drag_rules.closed_share</summary>
        public const int DM_EVENT_CLOSED = 32;
        /// <summary>it has gone over to another detent or snap value: dm_drag_state.detents</summary>
        public const int DM_EVENT_DETENT = 64;
        /// <summary>the pull has changed the joint: dm_drag_state.changes</summary>
        public const int DM_EVENT_JOINT = 128;
        /// <summary>dm_drag_input's bounds hold it</summary>
        public const int DM_EVENT_BLOCKED = 256;
        /// <summary>they no longer do</summary>
        public const int DM_EVENT_FREED = 512;
        /// <summary>the latch has caught it</summary>
        public const int DM_EVENT_LATCHED = 1024;
        /// <summary>the handle has opened the latch</summary>
        public const int DM_EVENT_UNLATCHED = 2048;
        /// <summary>it was tried while locked or latched; again after the hand has let up</summary>
        public const int DM_EVENT_LOCKED = 4096;
        /// <summary>dm_drag_rules.break_distance has let go of it</summary>
        public const int DM_EVENT_LET_GO = 8192;
        /// <summary>the latch holds it</summary>
        public const int DM_STATUS_LATCHED = 1;
        /// <summary>DM_RULE_LOCKED or DM_INPUT_LOCKED holds it</summary>
        public const int DM_STATUS_LOCKED = 2;
        /// <summary>dm_drag_input's bounds hold it, from DM_EVENT_BLOCKED to DM_EVENT_FREED</summary>
        public const int DM_STATUS_BLOCKED = 4;
        /// <summary>it counts as open, from DM_EVENT_OPENED to DM_EVENT_CLOSED</summary>
        public const int DM_STATUS_OPEN = 8;
        /// <summary>dm_object_prepare found it, and no pull has changed it</summary>
        public const int DM_BASIS_PREPARED = 0;
        /// <summary>a pull of this drag, or of an earlier one of the same dm_part_state, has changed it</summary>
        public const int DM_BASIS_PULL = 1;
        /// <summary>the host's own</summary>
        public const int DM_BASIS_HOST = 2;
        /// <summary>the host has chosen it among the hypotheses</summary>
        public const int DM_BASIS_CHOSEN = 3;
        /// <summary>as the player meant it, by where the part is and how fast it goes</summary>
        public const int DM_GO_AUTO = 0;
        /// <summary>glides to a stop; also stops a part that moves by itself</summary>
        public const int DM_GO_STAY = 1;
        /// <summary>goes on to the end of the joint that lies the way it was pulled</summary>
        public const int DM_GO_OPEN = 2;
        /// <summary>falls back to where it is closed: dm_joint.closed, which is rest unless it rests open</summary>
        public const int DM_GO_CLOSE = 3;
        /// <summary>does once more what it did after the last release</summary>
        public const int DM_GO_REPLAY = 4;
        /// <summary>stops dead</summary>
        public const int DM_GO_FREEZE = 5;
        /// <summary>opens when it is nearer to where it is closed than to its open end, else closes</summary>
        public const int DM_GO_TOGGLE = 6;
        public const int DM_INTENT_AUTO = 0;
        public const int DM_INTENT_STAY = 1;
        public const int DM_INTENT_OPEN = 2;
        public const int DM_INTENT_CLOSE = 3;
        public const int DM_INTENT_REPLAY = 4;
        public const int DM_INTENT_FREEZE = 5;
        public const int DM_INTENT_TOGGLE = 6;
        /// <summary>paced by a rule, not by the DQ-VAE, whose last bits differ between instruction sets</summary>
        public const int DM_RELEASE_BY_RULE = 1;
        /// <summary>a part that opens to both sides of rest opens away from `away_from`</summary>
        public const int DM_RELEASE_AWAY_FROM = 2;
        /// <summary>How a texture goes on beyond its edges: OpenGL's numbers.</summary>
        public const int DM_GLTF_WRAP_REPEAT = 10497;
        /// <summary>How a texture goes on beyond its edges: OpenGL's numbers.</summary>
        public const int DM_GLTF_WRAP_CLAMP = 33071;
        /// <summary>How a texture goes on beyond its edges: OpenGL's numbers.</summary>
        public const int DM_GLTF_WRAP_MIRROR = 33648;
        /// <summary>rigged.urdf: ROS, Gazebo, MuJoCo, Bullet</summary>
        public const int DM_GLTF_RIG_URDF = 1;
        /// <summary>rigged.xml: MuJoCo</summary>
        public const int DM_GLTF_RIG_MJCF = 2;
        /// <summary>rigged.sdf, of SDF 1.7: Gazebo</summary>
        public const int DM_GLTF_RIG_SDF = 4;
        /// <summary>rigged.usda, with UsdPhysics: Isaac Sim, Omniverse; all in one file</summary>
        public const int DM_GLTF_RIG_USDA = 8;
        /// <summary>rigged.tscn: Godot 4</summary>
        public const int DM_GLTF_RIG_TSCN = 16;
        /// <summary>rigged.glb: the file with an animation that opens and closes all parts, with KHR_physics_rigid_bodies, KHR_implicit_shapes and KHR_node_selectability, and the joints in `extras` as dm_gltf_get_asset reads them. What a clip of the file moves, with all that it carries, is left to that clip: it has its joint in `extras` alone</summary>
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

    /// <summary>direction need not be unit; distances along the ray are in host units, not in multiples of it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Ray
    {
        public Vec3 Origin;
        public Vec3 Direction;
    }

    /// <summary>Hooks: see "Callbacks" above. Host memory. allocate returns memory aligned to `alignment` (a power of two, 64 at most) or NULL; release gets the size that was asked for. Both may be called from any thread the host calls the library on.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Allocator
    {
        public void* User;
        public IntPtr Allocate;
        public IntPtr Release;
    }

    /// <summary>Messages for people, on the threads that the host calls the library on. level: DM_LOG_*. code: of an error, else DM_OK. `text` is UTF-8, valid during the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Log
    {
        public void* User;
        public IntPtr Message;
    }

    /// <summary>The host's job system. parallel_for runs task(data, i) once for every i in [0, count) and returns non-zero when all are done, or returns 0 without having run any (the library then runs them inline). A task that was left out, made up or run twice ends the call with INVALID_ARGUMENT; its second run does nothing. The library starts no thread.</summary>
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
        /// <summary>DM_AXES_*; 0 = glTF</summary>
        public int Axes;
        /// <summary>length of one host unit; 0 = 1. Unreal: 0.01</summary>
        public float UnitInMetres;
        /// <summary>for DM_AXES_CUSTOM: row-major matrix that takes a host vector to the canonical frame; orthogonal, determinant +1 or -1</summary>
        public fixed float CustomAxes[9];
        /// <summary>zeros = malloc/free</summary>
        public Allocator Allocator;
        /// <summary>zeros = silent</summary>
        public Log Log;
        /// <summary>zeros = inline</summary>
        public Jobs Jobs;
        /// <summary>DM_PICK_*; 0 = auto</summary>
        public int Picking;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>of the calls that take long where the mesh is large: dm_mesh_find_part, dm_object_prepare without a callback of its own, dm_object_load, dm_object_refine. NULL = none. May be called from several threads at once</summary>
        public IntPtr Progress;
        public void* ProgressUser;
        /// <summary>most scratch memory that stays with the context from call to call; 0 = 32 MB, 1 = none. dm_context_trim gives it back</summary>
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
        /// <summary>held now through the context's allocator</summary>
        public ulong Bytes;
        /// <summary>most ever held</summary>
        public ulong PeakBytes;
        /// <summary>calls of allocate so far</summary>
        public ulong Allocations;
        /// <summary>held now by Embree, which reports sizes but has its own allocator</summary>
        public ulong PickBytes;
        /// <summary>of `bytes`: in no use now, kept for later calls (dm_context_desc.kept_bytes)</summary>
        public ulong KeptBytes;

        /// <summary>Zeros, with StructSize set.</summary>
        public static MemoryInfo New() => new MemoryInfo { StructSize = (uint)sizeof(MemoryInfo) };
    }

    /// <summary>Bytes of safetensors files; each may be absent (NULL, 0). They are copied and repacked: free them after the call.</summary>
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
        /// <summary>chooses between candidate joints: sdk/models/ranker.safetensors; absent: by rules</summary>
        public void* Ranker;
        public UIntPtr RankerSize;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ModelDesc New() => new ModelDesc { StructSize = (uint)sizeof(ModelDesc) };
    }

    /// <summary>The host's mesh, read in place. Triangles. The sizes of the buffers guard against a forgotten format, scope or stride: one that does not hold what counts, formats and strides say is refused, and nothing is read past its end.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct MeshDesc
    {
        public uint StructSize;
        /// <summary>bytes between vertices; 0 = packed</summary>
        public uint PositionStride;
        /// <summary>vertex_count x 3</summary>
        public void* Positions;
        public ulong VertexCount;
        /// <summary>of the buffer from `positions` on; 0 = not stated, and not checked</summary>
        public ulong PositionBytes;
        /// <summary>index_count, a multiple of 3; NULL = vertices in order, three a triangle</summary>
        public void* Indices;
        public ulong IndexCount;
        /// <summary>of the buffer; 0 = not stated, and not checked</summary>
        public ulong IndexBytes;
        /// <summary>which part a vertex or a face belongs to: 0 = the body that stays, 1.. = parts. Ids that dm_object_desc.parts does not list are the body's. Per vertex, a triangle belongs to the id that two of its corners share (else the smallest). Where everything is of a part, as of a door leaf alone, there is no body, and joints are less sure</summary>
        public void* PartIds;
        /// <summary>of the buffer from `part_ids` on; required with part_ids. It must be that of one id a vertex or a face, as part_id_scope says, neither less nor more</summary>
        public ulong PartIdBytes;
        /// <summary>bytes; 0 = packed</summary>
        public uint PartIdStride;
        /// <summary>DM_FLOAT32 | DM_FLOAT64</summary>
        public int PositionFormat;
        /// <summary>DM_UINT32 | DM_UINT16 | DM_UINT8</summary>
        public int IndexFormat;
        /// <summary>DM_UINT32 | DM_UINT16 | DM_UINT8 | DM_INT32 (negative = body)</summary>
        public int PartIdFormat;
        /// <summary>DM_PER_VERTEX | DM_PER_FACE</summary>
        public int PartIdScope;
        /// <summary>0</summary>
        public uint Reserved;

        /// <summary>Zeros, with StructSize set.</summary>
        public static MeshDesc New() => new MeshDesc { StructSize = (uint)sizeof(MeshDesc) };
    }

    /// <summary>A drag as evidence of how a part moves: a point on it and the direction it was pulled, as a hand drew it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragHint
    {
        /// <summary>on or near the part, host object frame</summary>
        public Vec3 Point;
        /// <summary>non-zero; its length is how far it was pulled</summary>
        public Vec3 Vector;
    }

    /// <summary>Where an asset has the node or bone that moves a part, at rest. Evidence: an artist may have put it on the hinge, or left it in the middle or at the file's origin. Leave it out, or say DM_PIVOT_DEFAULT, where all nodes of an asset, the body's too, have theirs by one rule: at one point, or at the same place of their boxes. A program has put them there, and an edge that happens to lie there would be taken for a hinge.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Pivot
    {
        /// <summary>host object frame</summary>
        public Vec3 Origin;
        /// <summary>the node's own x, y and z axis, three numbers each, host object frame; of any length, also mirrored. Zeros: unknown</summary>
        public fixed float Axes[9];
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct PartDesc
    {
        public uint StructSize;
        /// <summary>as in part_ids; 1..</summary>
        public uint Id;
        /// <summary>id of the part that carries this one; 0 = the body. A part moves with its parent</summary>
        public uint Parent;
        /// <summary>DM_JOINT_*; 0 = to be found out</summary>
        public int JointType;
        /// <summary>optional evidence</summary>
        public DragHint* Drag;
        /// <summary>optional evidence: names that the asset has for the part, UTF-8, outermost first, joined by '/': file, parents, node, mesh. Names in any language that tell what it is (door, lid, Hebel) count, others don't. At most DM_MAX_LABEL bytes</summary>
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
        /// <summary>probability that the type is right, 0..1</summary>
        public float TypeConfidence;
        /// <summary>probability that type, axis and origin are all right, 0..1; never above the other</summary>
        public float JointConfidence;
        /// <summary>screws: host units a radian, signed along the axis</summary>
        public float Pitch;
        /// <summary>unit; host object frame. A positive value turns right-handed in a right-handed host frame (left-handed in a left-handed one), or slides along it. Found with a drag, positive goes its way; without one, the longer way is positive, so `upper` opens</summary>
        public Vec3 Axis;
        /// <summary>the point of the axis line nearest the part's centre; a host's own stays as it was given</summary>
        public Vec3 Origin;
        /// <summary>limits of the joint value (rad or host units); the rest pose is value 0. None when they are equal, and for continuous joints. A limit that a host gives farther from rest than 1000 rad or 100 object sizes (FLT_MAX, 1e10, infinity) is none; where only one side is, a little more than that stands for it</summary>
        public float Lower;
        /// <summary>limits of the joint value (rad or host units); the rest pose is value 0. None when they are equal, and for continuous joints. A limit that a host gives farther from rest than 1000 rad or 100 object sizes (FLT_MAX, 1e10, infinity) is none; where only one side is, a little more than that stands for it</summary>
        public float Upper;
        /// <summary>DM_JOINT_FROM_*, DM_JOINT_CHOSEN</summary>
        public int Source;
        /// <summary>in a dm_part_state: what the part's pulls so far say of all its joints. dm_drag_end writes it, dm_drag_begin reads it; keep the four numbers as they are. Zeros: no pull said anything. Elsewhere 0, and not read</summary>
        public fixed uint Evidence[4];
        /// <summary>joint value at which the part is closed: 0, or one of the limits where the part rests open. A host's joint may have it; outside of its limits it is moved to the nearer one</summary>
        public float Closed;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Joint New() => new Joint { StructSize = (uint)sizeof(Joint) };
    }

    /// <summary>A joint as a physics engine's constraint wants it: an orthonormal frame whose x axis is the hinge's or slider's. y and z are any, the same for the same joint; x, y, z and `rotation` have determinant +1 in the host's coordinates.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct JointFrame
    {
        public uint StructSize;
        /// <summary>DM_JOINT_*</summary>
        public int Type;
        /// <summary>host object frame</summary>
        public Vec3 Origin;
        /// <summary>unit</summary>
        public Vec3 X;
        /// <summary>unit</summary>
        public Vec3 Y;
        /// <summary>unit</summary>
        public Vec3 Z;
        /// <summary>unit quaternion x, y, z, w that takes the frame's coordinates to the object's</summary>
        public fixed float Rotation[4];
        /// <summary>hinges and screws: rad about x; sliders: host units along x; 0 where there is none</summary>
        public float Lower;
        /// <summary>hinges and screws: rad about x; sliders: host units along x; 0 where there is none</summary>
        public float Upper;
        /// <summary>DM_LIMIT_LOWER | DM_LIMIT_UPPER: which there are</summary>
        public uint Limits;
        /// <summary>screws: host units along x a radian</summary>
        public float Pitch;

        /// <summary>Zeros, with StructSize set.</summary>
        public static JointFrame New() => new JointFrame { StructSize = (uint)sizeof(JointFrame) };
    }

    /// <summary>Where one instance's part stands, and by which joint: all of what the host keeps of it, saves, replicates and undoes. Belongs to the instance, not to the object: doors of one object may differ. Save it field by field (type, pitch, axis, origin, limits, source, both confidences, evidence, value).</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct PartState
    {
        public uint StructSize;
        /// <summary>joint value; 0 = rest</summary>
        public float Value;
        /// <summary>d value / dt, for a physics engine that takes over; told, not read: a drag begins without</summary>
        public float Velocity;
        /// <summary>DM_STATUS_*; told, not read</summary>
        public uint Status;
        /// <summary>as shown, from rest. It differs from dm_joint_pose(joint, value) only while the part comes over to a joint that has just changed. Zeros: that of joint and value</summary>
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
        /// <summary>of the part alone, without the parts it carries</summary>
        public uint TriangleCount;
        public Vec3 BoxMin;
        public Vec3 BoxMax;
        /// <summary>area-weighted surface centroid</summary>
        public Vec3 Centre;
        public float Area;

        /// <summary>Zeros, with StructSize set.</summary>
        public static PartInfo New() => new PartInfo { StructSize = (uint)sizeof(PartInfo) };
    }

    /// <summary>Where a hypothesis takes its part at one end of its range. Host object frame. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct JointEnd
    {
        /// <summary>joint value</summary>
        public float Value;
        /// <summary>of the part, from rest</summary>
        public Pose Pose;
        /// <summary>of the part alone, as in dm_part_info</summary>
        public Vec3 BoxMin;
        /// <summary>of the part alone, as in dm_part_info</summary>
        public Vec3 BoxMax;
        public Vec3 Centre;
    }

    /// <summary>A ranked hypothesis and what it would do. struct_size: what the library has filled.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Hypothesis
    {
        public uint StructSize;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>with its limits and probabilities</summary>
        public Joint* Joint;
        /// <summary>at the lower and the upper limit. Of a joint without limits: a quarter turn, or half the object's size, either way</summary>
        public JointEnd Ends0;
        /// <summary>at the lower and the upper limit. Of a joint without limits: a quarter turn, or half the object's size, either way</summary>
        public JointEnd Ends1;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Hypothesis New() => new Hypothesis { StructSize = (uint)sizeof(Hypothesis) };
    }

    /// <summary>A part and its hypotheses, for the host to choose from. Valid during the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Choice
    {
        public uint StructSize;
        /// <summary>of hypotheses; 1 .. DM_MAX_HYPOTHESES</summary>
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
        /// <summary>NULL: every id &gt; 0 in part_ids is a part carried by the body</summary>
        public PartDesc* Parts;
        public uint PartCount;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>weights; 0 = geometry alone</summary>
        public ulong Model;
        /// <summary>of the surface sampling; the same seed gives the same bits</summary>
        public ulong Seed;
        public IntPtr Intent;
        public void* IntentUser;
        /// <summary>NULL = that of the context</summary>
        public IntPtr Progress;
        public void* ProgressUser;
        /// <summary>optional evidence: names of the whole object, as dm_part_desc.label; they count for the parts whose own label tells nothing</summary>
        public byte* Label;
        /// <summary>which way is up, host object frame; it counts together with labels and pivots alone. 0 = that of the context's axes</summary>
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
        /// <summary>host object frame; with oblique custom axes it may be larger than need be</summary>
        public Vec3 BoxMin;
        /// <summary>host object frame; with oblique custom axes it may be larger than need be</summary>
        public Vec3 BoxMax;
        /// <summary>largest side of the box</summary>
        public float Size;
        /// <summary>1 when it kept its triangles</summary>
        public uint Pickable;
        /// <summary>DM_DEGRADED_*; 0: all that the library knows was at work</summary>
        public uint Degraded;
        /// <summary>DM_PICK_EMBREE or DM_PICK_PORTABLE: whose trees it has; DM_PICK_NONE: it has none</summary>
        public int Picking;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ObjectInfo New() => new ObjectInfo { StructSize = (uint)sizeof(ObjectInfo) };
    }

    /// <summary>How one animation moves one node. Frozen.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetClip
    {
        /// <summary>of the animation, UTF-8; may be NULL</summary>
        public byte* Name;
        /// <summary>s, rising</summary>
        public float* Times;
        /// <summary>of the node from the pose that its mesh has, asset frame, as if all nodes above it stood still</summary>
        public Pose* Poses;
        /// <summary>of times and poses</summary>
        public uint KeyCount;
        /// <summary>DM_CLIP_NOT_RIGID</summary>
        public uint Flags;
    }

    /// <summary>A node of an asset as a host has it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetNode
    {
        public uint StructSize;
        /// <summary>DM_ASSET_NODE_*</summary>
        public uint Flags;
        /// <summary>index of the node above it, which may come later in the list; else DM_ASSET_NO_NODE</summary>
        public uint Parent;
        /// <summary>of DM_ASSET_NODE_FOLLOWS: index of a node, DM_ASSET_NO_NODE: the one above it</summary>
        public uint Follows;
        /// <summary>UTF-8, DM_MAX_LABEL bytes at most; NULL: none</summary>
        public byte* Name;
        /// <summary>the same, of its mesh</summary>
        public byte* MeshName;
        /// <summary>without part_ids; NULL: a node without a mesh, such as a group</summary>
        public MeshDesc* Mesh;
        /// <summary>4x4, column-major: node to asset frame, all nodes above it included; affine. NULL: identity</summary>
        public float* Transform;
        /// <summary>asset frame. NULL: origin and axes of `transform`; where that is NULL too, unknown</summary>
        public Pivot* Pivot;
        public AssetClip* Clips;
        public uint ClipCount;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>asset frame: a joint that the file states for this node, with limits; certain, as a joint that the host sets. DM_JOINT_FIXED: the node is one with the node above it. NULL: none</summary>
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
        /// <summary>parts of at least this probability move, and are the object's; 0 = 0.5</summary>
        public float MinMoves;
        /// <summary>weights; 0 = geometry alone</summary>
        public ulong Model;
        /// <summary>as dm_object_desc.seed</summary>
        public ulong Seed;
        /// <summary>NULL = that of the context</summary>
        public IntPtr Progress;
        public void* ProgressUser;
        /// <summary>which way is up, asset frame; 0 = that of the context's axes</summary>
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
        /// <summary>those that stay included</summary>
        public uint PartCount;
        /// <summary>parts that move or are free: those of the object</summary>
        public uint MovingCount;
        /// <summary>of the nodes that do not follow others</summary>
        public ulong TriangleCount;
        /// <summary>DM_DEGRADED_*: what the joints were found without</summary>
        public uint Degraded;
        /// <summary>DM_ASSET_CLIP_LEFT_OUT</summary>
        public uint Warnings;

        /// <summary>Zeros, with StructSize set.</summary>
        public static AssetInfo New() => new AssetInfo { StructSize = (uint)sizeof(AssetInfo) };
    }

    /// <summary>Nodes that move as one, or might.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetPart
    {
        public uint StructSize;
        /// <summary>index of the part that carries it, or DM_ASSET_NO_PART</summary>
        public uint Parent;
        /// <summary>in the object: its index + 1; 0 while it stays</summary>
        public uint PartId;
        /// <summary>DM_ASSET_STAYS …</summary>
        public int State;
        /// <summary>DM_ASSET_INFERRED …</summary>
        public int Basis;
        /// <summary>probability that it moves against what carries it, 0..1</summary>
        public float Moves;
        /// <summary>its nodes, those that follow them included; not those of the parts that it carries</summary>
        public uint NodeCount;
        /// <summary>the same without those that follow</summary>
        public uint TriangleCount;
        /// <summary>s that its clip takes from one end of the joint to the other; 0: it has none</summary>
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
        /// <summary>optional: where the pointer drew the drag point, from drag.point on; 65536 at most</summary>
        public Vec3* Path;
        /// <summary>0: the path that opens the joint all the way in the drag's direction</summary>
        public uint PathCount;
        /// <summary>0: the most likely motion (z = mean); else z is drawn with this seed</summary>
        public uint Seed;

        /// <summary>Zeros, with StructSize set.</summary>
        public static MotionDesc New() => new MotionDesc { StructSize = (uint)sizeof(MotionDesc) };
    }

    /// <summary>How a drag feels. Zeros are the defaults. Stiffness, damping and inertia of a part in the hand matter through two ratios, which are times: smoothing_time is damping over stiffness, coast_time inertia over damping.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragFeel
    {
        /// <summary>s for the part to close half the gap to the pointer; 0 = 0.02, negative = none</summary>
        public float SmoothingTime;
        /// <summary>share of the range over which the ends give; 0 = hard ends. Not of limits that the library estimated: see dm_drag_desc.limit_give</summary>
        public float SoftLimit;
        /// <summary>s in which a part left alone loses half its speed, and how heavy it is in the hand; 0 = 0.1 once released and weightless in the hand, negative = stops where it is let go</summary>
        public float CoastTime;
        /// <summary>joint value from one catch to the next, the first at rest (rad or host units); 0 = none</summary>
        public float Detent;
        /// <summary>how hard catches hold, up to 1; 0 = 0.7. Nothing without `detent`</summary>
        public float DetentPull;
        /// <summary>s for the released part to spring back to rest; 0 = push buttons alone, in 0.12; negative = nothing springs back</summary>
        public float ReturnTime;
    }

    /// <summary>What a part does besides following the hand. Zeros are off, but for the defaults of thresholds. "Range" is from lower to upper limit; where one of them is missing, 1 rad or the object's size. docs/feel.md.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragRules
    {
        public uint StructSize;
        /// <summary>DM_RULE_*</summary>
        public uint Flags;
        /// <summary>snap_count joint values, rising: there the part catches, as at detents, and pulls as hard as feel.detent_pull says. Not with feel.detent</summary>
        public float* Snaps;
        /// <summary>DM_MAX_SNAPS at most</summary>
        public uint SnapCount;
        /// <summary>joint value: how far a snap value reaches to either side; 0 = half-way to the next, or a twentieth of the range where there is none</summary>
        public float SnapReach;
        /// <summary>share of the range from rest: DM_EVENT_OPENED beyond; 0 = 0.1</summary>
        public float OpenShare;
        /// <summary>share of the range from rest: DM_EVENT_CLOSED within; 0 = 0.02; less than open_share. A part that is grabbed between both counts as open</summary>
        public float ClosedShare;
        /// <summary>shortest time between DM_EVENT_OPENED and DM_EVENT_CLOSED, s</summary>
        public float EventTime;
        /// <summary>joint value a second; 0 = none</summary>
        public float MaxSpeed;
        /// <summary>joint value a second squared while it gets faster, the highest force over the part's inertia; 0 = none</summary>
        public float MaxAcceleration;
        /// <summary>share of the range that a locked or latched part gives at most; 0 = 0.01, negative = none</summary>
        public float LockGive;
        /// <summary>joint value of a handle, of either sign, from which on the latch is open; 0 = 0.785</summary>
        public float LatchTurn;
        /// <summary>a released part nearer to rest than this share of the range closes; 0 = none does</summary>
        public float AutoCloseShare;
        /// <summary>s that takes; 0 = 0.25</summary>
        public float AutoCloseTime;
        /// <summary>s after the release before feel.return_time brings it back</summary>
        public float CloseDelay;
        /// <summary>a released part falls to rest from nearer than this share of the range, and else to its open end, as a hatch does; 0 = it does not fall</summary>
        public float TipShare;
        /// <summary>s of a fall over the whole range; 0 = 0.7</summary>
        public float FallTime;
        /// <summary>share of its speed, 0 to 1, with which it comes back from a limit that it falls, glides or swings against</summary>
        public float Restitution;
        /// <summary>host units from the hand to where it holds the part, beyond which it lets go (DM_EVENT_LET_GO) and the part is released; 0 = never</summary>
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
        /// <summary>value of the driven part a value of the driver; 0 = 1. Rad, host units: rack and pinion</summary>
        public float Ratio;
        /// <summary>value of the driven part while the driver is at `from`</summary>
        public float Offset;
        /// <summary>value of the driver: nothing moves while it is nearer to 0, on that side of 0. 0: DM_LINK_FREES and DM_LINK_HOLDS take it as reached at rest</summary>
        public float From;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragDesc
    {
        public uint StructSize;
        public uint PartId;
        public ulong Object;
        /// <summary>on the part as it is now, host object frame</summary>
        public Vec3 GrabPoint;
        /// <summary>joint value the part has now; 0 = rest. Not with `state`</summary>
        public float StartValue;
        public DragFeel Feel;
        /// <summary>DM_DRAG_KEEP_JOINT, DM_DRAG_WITHOUT_POINT</summary>
        public uint Flags;
        /// <summary>how far a pull that goes on takes the part beyond limits that the library estimated, as a share of the range. 0 = as far as it is pulled, by a turn or the object's size at most; negative = not at all. The host's own limits never give, nor does a stop at rest</summary>
        public float LimitGive;
        /// <summary>the instance's own joint and value, as an earlier drag ended with them: the first pose is the last one of then. NULL = the object's joint in force, at start_value</summary>
        public PartState* State;
        /// <summary>of the instance along the axes of the object frame, negative = mirrored; 0 = 1. Then grab_point, rays, state and poses are in the scaled frame (object coordinates times scale), and poses are rigid in it</summary>
        public Vec3 Scale;
        /// <summary>0</summary>
        public uint Reserved;
        /// <summary>NULL = none, and no events</summary>
        public DragRules* Rules;

        /// <summary>Zeros, with StructSize set.</summary>
        public static DragDesc New() => new DragDesc { StructSize = (uint)sizeof(DragDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Hand
    {
        /// <summary>DM_HAND_*. RATE, STEP and VALUE stay inside the limits. RATE and STEP open with an amount above 0. A limit that the library estimated stops them first. It then gives as to a pull: to a RATE after 0.25 s at the limit, to the next STEP</summary>
        public int Kind;
        /// <summary>object frame; scaled with dm_drag_desc.scale</summary>
        public Ray Ray;
        /// <summary>the same</summary>
        public Vec3 Point;
        /// <summary>of RATE, STEP, VALUE</summary>
        public float Amount;
        /// <summary>of a second hand alone, where it takes hold: read in its first update, on the part as it is</summary>
        public Vec3 GrabPoint;
    }

    /// <summary>All that can be told a drag in one update.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragInput
    {
        public uint StructSize;
        /// <summary>DM_INPUT_*</summary>
        public uint Flags;
        public Hand Hand;
        /// <summary>another hand on the part, by ray or point; DM_HAND_NONE = none. Both count as far as each can move the part. It comes and goes without a jump</summary>
        public Hand Second;
        /// <summary>joint values of the handles of a latch, where their drags or links have them</summary>
        public fixed float Handles[2];
        /// <summary>joint values between which the host's world leaves the part room in this update, infinite on a free side; none when they are equal, but for DM_INPUT_BOUNDS. The part stops there softly, and goes on when it is free; where it is beyond, it is pushed back</summary>
        public float Lower;
        /// <summary>joint values between which the host's world leaves the part room in this update, infinite on a free side; none when they are equal, but for DM_INPUT_BOUNDS. The part stops there softly, and goes on when it is free; where it is beyond, it is pushed back</summary>
        public float Upper;

        /// <summary>Zeros, with StructSize set.</summary>
        public static DragInput New() => new DragInput { StructSize = (uint)sizeof(DragInput) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct DragState
    {
        public uint StructSize;
        /// <summary>of the part from rest, object frame; compose with the parent part's own pose</summary>
        public Pose Pose;
        /// <summary>where the grabbed point is now</summary>
        public Vec3 GrabPoint;
        /// <summary>joint value</summary>
        public float Value;
        /// <summary>value the pointer asks for, before smoothing and inside the limits</summary>
        public float Target;
        /// <summary>d value / dt</summary>
        public float Velocity;
        /// <summary>-1 at lower, +1 at upper, 0 between</summary>
        public int AtLimit;
        /// <summary>DM_DRAG_HELD …</summary>
        public int Phase;
        /// <summary>how often the pull has changed the joint that the drag follows: dm_drag_get_part_state. The pose comes over to a new joint within 0.6 s; the grabbed point first, mostly in 0.1 s</summary>
        public uint Changes;
        /// <summary>DM_EVENT_*; 0 without dm_drag_desc.rules, as the two below</summary>
        public uint Events;
        /// <summary>detents or snap values that it has gone over to since the update before; a long update may pass several</summary>
        public uint Detents;
        /// <summary>joint value a second: how fast it met a limit or was blocked; 0 without such an event</summary>
        public float Impact;
        /// <summary>DM_STATUS_*: what holds the part, and how it stands; 0 without dm_drag_desc.rules</summary>
        public uint Status;
        /// <summary>probability that the joint in force is right, 0..1: the one number to show. A pull of one kind from one side never makes it certain</summary>
        public float JointConfidence;
        /// <summary>DM_BASIS_*: where the joint in force comes from</summary>
        public int JointBasis;
        /// <summary>how far the part is open: 0 where it is closed (dm_joint.closed), 1 at the end farther from there, between them by the joint value; 0 for joints without limits</summary>
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
        /// <summary>s from here to the end; 0 = as far and fast as it goes asks for</summary>
        public float Duration;
        /// <summary>of the DQ-VAE, as dm_motion_desc.seed</summary>
        public uint Seed;
        /// <summary>DM_RELEASE_*</summary>
        public uint Flags;
        /// <summary>object frame, scaled with dm_drag_desc.scale: the player, say</summary>
        public Vec3 AwayFrom;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ReleaseDesc New() => new ReleaseDesc { StructSize = (uint)sizeof(ReleaseDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ReleasePlan
    {
        public uint StructSize;
        /// <summary>as decided: DM_GO_STAY, OPEN, CLOSE or FREEZE</summary>
        public int Intent;
        public float StartValue;
        public float EndValue;
        /// <summary>s; 0 when it is there already</summary>
        public float Duration;
        /// <summary>1: paced by the DQ-VAE; 0: by a rule</summary>
        public uint FromNetwork;

        /// <summary>Zeros, with StructSize set.</summary>
        public static ReleasePlan New() => new ReleasePlan { StructSize = (uint)sizeof(ReleasePlan) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Camera
    {
        public uint StructSize;
        /// <summary>rad, below pi; 0 = orthographic with ortho_height</summary>
        public float FovY;
        /// <summary>host world frame</summary>
        public Vec3 Eye;
        /// <summary>need not be unit or orthogonal, not parallel</summary>
        public Vec3 Forward;
        /// <summary>need not be unit or orthogonal, not parallel</summary>
        public Vec3 Up;
        /// <summary>pixels</summary>
        public float ViewportWidth;
        /// <summary>pixels</summary>
        public float ViewportHeight;
        /// <summary>orthographic: host units from bottom to top; else not used</summary>
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
        /// <summary>as dm_scene_add gave it</summary>
        public uint Instance;
        /// <summary>0 = nothing hit</summary>
        public ulong Object;
        /// <summary>0 = the body</summary>
        public uint PartId;
        /// <summary>index in the host's mesh</summary>
        public uint Triangle;
        /// <summary>host units from the ray's origin</summary>
        public float Distance;
        /// <summary>barycentric weights of the triangle's second and third corner</summary>
        public float U;
        /// <summary>barycentric weights of the triangle's second and third corner</summary>
        public float V;
        /// <summary>host world frame</summary>
        public Vec3 Point;
        /// <summary>unit, geometric, of the triangle's winding; host world frame</summary>
        public Vec3 Normal;
        /// <summary>the same point in the object's frame with the part as it is now: dm_drag_desc.grab_point</summary>
        public Vec3 ObjectPoint;

        /// <summary>Zeros, with StructSize set.</summary>
        public static Hit New() => new Hit { StructSize = (uint)sizeof(Hit) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Core1
    {
        /// <summary>bytes of this table in the library at hand: check before calling a newer entry</summary>
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

    /// <summary>Files beside a .gltf: buffers when it is opened, images when it is exported or a surface is asked for.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfFiles
    {
        public void* User;
        /// <summary>Hands over the bytes of the file at `path`: relative to the document, UTF-8, '/' between folders. It never is absolute, never has "..", a backslash or a colon in it. Returns DM_OK, DM_ERROR_OUT_OF_MEMORY, or another number: there is no such file.</summary>
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
        /// <summary>zeros = none: everything is embedded. `user` lives as long as the dm_gltf</summary>
        public GltfFiles Files;
        /// <summary>of dm_gltf_open, dm_gltf_open_file and dm_gltf_export; NULL = none. A call that it stops answers CANCELLED</summary>
        public IntPtr Progress;
        /// <summary>lives as long as the dm_gltf</summary>
        public void* ProgressUser;

        /// <summary>Zeros, with StructSize set.</summary>
        public static GltfDesc New() => new GltfDesc { StructSize = (uint)sizeof(GltfDesc) };
    }

    /// <summary>What moves as one: a node that has a mesh, or a bone of a skin with the triangles that go with it. Vertices and faces are those of the merged mesh. It holds the nodes with meshes in file order (document order of the nodes array), a node's primitives in order, every vertex in the scene's frame less dm_gltf_get_origin (node transforms applied). Primitives of a node that share an accessor share its vertices. A node with a skin stands bone by bone, as its bones stand in the file; a vertex goes with its heaviest bone.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfNode
    {
        /// <summary>valid UTF-8, '?' for what is none; "" when it has none. Lives as long as the dm_gltf</summary>
        public byte* Name;
        /// <summary>index in the file's nodes array, of the node or bone; of an instance: behind them</summary>
        public uint Node;
        /// <summary>the nearest dm_gltf_node above it, by index here: it goes where that one goes. Else DM_GLTF_NO_CARRIER</summary>
        public uint Carrier;
        public ulong FirstVertex;
        public ulong VertexCount;
        public ulong FirstFace;
        public ulong FaceCount;
        /// <summary>base colour factor of its first material, linear; white without one</summary>
        public fixed float Colour[4];
    }

    /// <summary>Faces of the merged mesh that lie side by side and have one material. Those of a dm_gltf_node are one or more.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfSurface
    {
        public ulong FirstFace;
        public ulong FaceCount;
        /// <summary>base colour factor, linear; white without a material</summary>
        public fixed float Colour[4];
        /// <summary>the base colour texture as it is stored: PNG, JPEG, or what an extension has, sRGB. NULL: none. Surfaces with the same image have the same pointer; lives as long as the dm_gltf</summary>
        public void* Image;
        /// <summary>bytes</summary>
        public UIntPtr ImageSize;
        /// <summary>DM_GLTF_WRAP_*</summary>
        public int WrapU;
        /// <summary>DM_GLTF_WRAP_*</summary>
        public int WrapV;
    }

    /// <summary>One animated part: which faces it takes and its key poses (host frame = the file's scene frame, from rest).</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfTrack
    {
        /// <summary>of the new node and animation target; NULL = "moving_part"</summary>
        public byte* Name;
        /// <summary>face_count of the merged mesh</summary>
        public byte* FaceIds;
        /// <summary>faces with this id move</summary>
        public byte Value;
        public fixed byte Reserved[7];
        /// <summary>key_count</summary>
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
        /// <summary>vertex_count x 3, glTF frame</summary>
        public float* Positions;
        /// <summary>index_count</summary>
        public uint* Indices;
        public ulong VertexCount;
        public ulong IndexCount;
        /// <summary>base colour, linear; clamped to 0 to 1</summary>
        public fixed float Colour[4];
    }

    /// <summary>What dm_asset_create was given and what it has answered. Everything is borrowed for the call.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfRigDesc
    {
        public uint StructSize;
        /// <summary>DM_GLTF_RIG_*</summary>
        public uint Formats;
        /// <summary>as dm_asset_create took them</summary>
        public AssetNode* Nodes;
        /// <summary>all that dm_asset_get_part answers; NULL: none</summary>
        public AssetPart* Parts;
        /// <summary>all that dm_asset_get_joint answers, one a part</summary>
        public Joint* Joints;
        /// <summary>what dm_asset_get_node_parts answers</summary>
        public uint* NodeParts;
        /// <summary>red, green, blue, opacity of each node, linear; NULL: white</summary>
        public float* Colours;
        /// <summary>of the asset, UTF-8; NULL: "asset"</summary>
        public byte* Name;
        /// <summary>UTF-8, of each part; NULL: that of its first node that has one</summary>
        public byte** PartNames;
        /// <summary>the file whose dm_gltf_get_asset has made the nodes; NULL: there is none. A GLB needs it. Where `colours` is NULL, nodes have those of the file</summary>
        public IntPtr Gltf;
        public uint NodeCount;
        public uint PartCount;
        /// <summary>of the asset frame: DM_AXES_*, but for DM_AXES_CUSTOM</summary>
        public int Axes;
        /// <summary>length of one unit of the asset; 0 = 1</summary>
        public float UnitInMetres;
        /// <summary>kg/m³ of closed pieces; 0 = 600, wood</summary>
        public float Density;
        /// <summary>m, of pieces that are open surfaces; 0 = 0.003</summary>
        public float Thickness;
        /// <summary>share of a part's weight that holds it back; 0 = 0.1; negative: none</summary>
        public float Friction;
        /// <summary>s in which a part that nothing drives loses 63 % of its speed; 0 = 0.5; negative: no damping</summary>
        public float DampingTime;
        /// <summary>zeros = malloc/free</summary>
        public Allocator Allocator;
        /// <summary>zeros = silent; warns of what a format can't hold</summary>
        public Log Log;

        /// <summary>Zeros, with StructSize set.</summary>
        public static GltfRigDesc New() => new GltfRigDesc { StructSize = (uint)sizeof(GltfRigDesc) };
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GltfRigFile
    {
        /// <summary>below the folder of the rig: letters, digits, '_', '.', and '/' between folders</summary>
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

        /// <summary>NAME of a result, such as "DM_ERROR_EMPTY_MASK"; "DM_ERROR_UNKNOWN" for others. Never NULL. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern byte* dm_result_string(int result);

        /// <summary>Version of the library in use, as DM_VERSION. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_version();

        /// <summary>The function table of an interface id, NULL for an unknown one. "dm.core/1" -&gt; const dm_core_1*. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void* dm_get_interface(byte* id);

        /// <summary>Makes a context. desc NULL = all defaults. Errors: UNSUPPORTED when desc.picking asks for what is not there. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_context_create(ContextDesc* desc, IntPtr* out_context);

        /// <summary>Destroys it and everything made with it; NULL does nothing. [exclusive context]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_context_destroy(IntPtr context);

        /// <summary>out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_context_get_memory(IntPtr context, MemoryInfo* out_info);

        /// <summary>Gives the scratch memory that is kept for later calls (dm_memory_info.kept_bytes) back to the host's allocator: when a level has loaded, or memory is short. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_context_trim(IntPtr context);

        /// <summary>Reads weights. Errors: BAD_DATA, WRONG_MODEL, VERSION. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_model_load(IntPtr context, ModelDesc* desc, ulong* out_model);

        /// <summary>Objects prepared with it keep their joints, and motions made with it stay; new motions and refinements of such objects answer NO_MODEL. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_model_unload(IntPtr context, ulong model);

        /// <summary>Finds the part that a point of the surface belongs to, when no mask names it: 1 in out_face_ids for every triangle that moves with it, 0 for the others; as part ids per face they go straight into a dm_mesh_desc. mesh-&gt;part_ids tell pieces known to be rigid (the nodes of a scene): the grabbed one moves, with what is fastened to it alone. NULL, or one piece: the part is put together from the mesh's sheets of surface. drag: where it was grabbed and how it was pulled; a zero vector: no direction. Milliseconds to tens of them, a second for tens of thousands of loose pieces; never more than linear in their number. Errors: as dm_object_prepare's of the mesh; BUFFER_TOO_SMALL when face_count is less than the mesh's; DRAG_OFF_PART; FULL_MASK when nothing is left that stays; CANCELLED. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_mesh_find_part(IntPtr context, MeshDesc* mesh, DragHint* drag, byte* out_face_ids, ulong face_count);

        /// <summary>Finds out how each part moves. Milliseconds to tens of them; see docs/performance.md. Uses dm_jobs. Warns once where the answer is less than it could be (DM_DEGRADED_*). Errors: NOT_FINITE, INDEX_OUT_OF_RANGE (also of what desc.choose answers), EMPTY_MASK, DEGENERATE_MESH, ZERO_DRAG, DRAG_OFF_PART, TOO_LARGE, CANCELLED. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_prepare(IntPtr context, ObjectDesc* desc, ulong* out_object);

        /// <summary>Writes the prepared object (.dmo: versioned, checksummed, little-endian). Call with buffer NULL to learn the size. out_size gets the bytes needed or written, with BUFFER_TOO_SMALL too. Triangles come with trees of the library's own, so that loading builds none; where the object has others, each call builds them. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_save(IntPtr context, ulong @object, void* buffer, UIntPtr capacity, UIntPtr* out_size);

        /// <summary>Reads what dm_object_save wrote, by this or any earlier version. `model` (may be 0) serves its motions. The file's own trees are taken where desc.picking of the context is DM_PICK_AUTO or DM_PICK_PORTABLE (dm_object_info.picking). Errors: BAD_DATA, VERSION, CANCELLED. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_load(IntPtr context, void* data, UIntPtr size, ulong model, ulong* out_object);

        /// <summary>Its drags and motions end with it, and its instances leave their scenes. [exclusive object, and none of those in use]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_destroy(IntPtr context, ulong @object);

        /// <summary>out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_info(IntPtr context, ulong @object, ObjectInfo* out_info);

        /// <summary>Part by position 0 .. part_count-1, in order of id. out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_part(IntPtr context, ulong @object, uint index, PartInfo* out_info);

        /// <summary>The joint in force: the best hypothesis, or the host's own. out_joint-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_joint(IntPtr context, ulong @object, uint part_id, Joint* out_joint);

        /// <summary>Ranked hypotheses, best first, re-ranked by `drag` when it is given (microseconds; no network pass). capacity up to DM_MAX_HYPOTHESES; out_joints[0].struct_size must be set, the others get it; out_count gets how many were written. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_get_hypotheses(IntPtr context, ulong @object, uint part_id, DragHint* drag, Joint* out_joints, uint capacity, uint* out_count);

        /// <summary>Runs the kinematics pass of one part again, with the player's drag as evidence, and puts the result in force. Milliseconds, not for every frame. Errors: NO_MODEL; UNSUPPORTED when the object kept no triangles; CANCELLED, which leaves the joint in force. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_refine(IntPtr context, ulong @object, uint part_id, DragHint* drag);

        /// <summary>The host knows better: puts its joint in force. The axis may have any length, limits may be infinite (dm_joint.lower). Source becomes DM_JOINT_FROM_HOST and both confidences 1, unless the joint is, bit for bit, the one in force or the library's own answer: then source and confidences are those of that one. Drags and motions that already run keep the joint they began with. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_set_joint(IntPtr context, ulong @object, uint part_id, Joint* joint);

        /// <summary>Puts the library's own answer back in force, after dm_object_set_joint or a choice. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_reset_joint(IntPtr context, ulong @object, uint part_id);

        /// <summary>Links parts of an object, in place of the links of before; count 0 to DM_MAX_LINKS, 0: none. Copied; a saved object does not hold them. Errors: INVALID_ARGUMENT also when a part is moved by two drivers, or by itself over others; NOT_FOUND. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_set_links(IntPtr context, ulong @object, Link* links, uint count);

        /// <summary>Moves what is linked with a part that has moved. inout_values: the joint values of one instance, one a part, in the order of dm_object_get_part; that of the part itself changes where a driver of it is at its limit (dm_drag_override). out_held (may be NULL): 1 for the parts that links hold where they are (DM_INPUT_LOCKED), else 0. count: of both, the number of parts. Limits are those of the joints in force, of the instance unscaled. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_object_follow_links(IntPtr context, ulong @object, uint part_id, float* inout_values, byte* out_held, uint count);

        /// <summary>Finds out which nodes of an asset move, which of them as one, what carries what, and how each moves. The same nodes in the same order give the same bits. About as long as dm_object_prepare for all of its nodes. Uses dm_jobs. Warns once where the answer is less than it could be. Errors, which name the node: NOT_FINITE, INDEX_OUT_OF_RANGE, DEGENERATE_MESH, TOO_LARGE, CANCELLED; INVALID_ARGUMENT also when parents or followers form a circle, a name is no UTF-8, and no node has a mesh. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_create(IntPtr context, AssetDesc* desc, ulong* out_asset);

        /// <summary>Objects made of it stay. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_destroy(IntPtr context, ulong asset);

        /// <summary>out_info-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_info(IntPtr context, ulong asset, AssetInfo* out_info);

        /// <summary>Part by index 0 .. part_count-1. out_part-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_part(IntPtr context, ulong asset, uint index, AssetPart* out_part);

        /// <summary>How a part moves, asset frame; of one that stays, how it would. out_joint-&gt;struct_size must be set. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_joint(IntPtr context, ulong asset, uint index, Joint* out_joint);

        /// <summary>The nodes of a part, rising: dm_asset_part.node_count of them. BUFFER_TOO_SMALL when capacity is less. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_part_nodes(IntPtr context, ulong asset, uint index, uint* out_nodes, uint capacity);

        /// <summary>The part of each node, DM_ASSET_NO_PART for those of the body: dm_asset_info.node_count numbers. BUFFER_TOO_SMALL when capacity is less. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_get_node_parts(IntPtr context, ulong asset, uint* out_parts, uint capacity);

        /// <summary>Makes a prepared object of the parts that move or are free, carried by each other as in the asset; all else is the body. Its triangles are those of the nodes that do not follow others, node after node. Errors: EMPTY_MASK when nothing moves. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_asset_make_object(IntPtr context, ulong asset, ulong* out_object);

        /// <summary>Pose of a joint at a value, in the frame of the joint. The axis may have any length, here and in the functions below. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_pose(Joint* joint, float value, Pose* out_pose);

        /// <summary>Inverse of dm_joint_pose: the value at which the joint comes nearest to a pose (from rest), and how far off the joint the pose is: the angle between both, rad, and the distance of the joint's origin under both, host units. Of values a turn apart: inside the limits, else nearest to 0; of a screw, by its advance. Both errors may be NULL. NOT_FINITE when an answer is beyond a float. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_value(Joint* joint, Pose* pose, float* out_value, float* out_angle_error, float* out_distance_error);

        /// <summary>The joint value at a share of the way from rest to the open end, the limit that is farther from rest: 0 is rest, 1 open, 0.1 ajar. INVALID_ARGUMENT for a joint without limits. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_value_at(Joint* joint, float share, float* out_value);

        /// <summary>The joint as a constraint of a physics engine; out_frame-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_get_frame(Joint* joint, JointFrame* out_frame);

        /// <summary>Carries a joint over into the frame of an instance scaled by (x, y, z), as dm_drag_begin does: the line through the scaled points; limits of slides and the pitch in scaled units, angles as they are. out_joint-&gt;struct_size must be set; it may be `joint`. Zeros = 1. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_joint_scale(Joint* joint, Vec3 scale, Joint* out_joint);

        /// <summary>The DQ-VAE's motion for a drag, projected exactly onto the joint in force; a fixed part's motion is rest. Errors: NO_MODEL, ZERO_DRAG, DRAG_OFF_PART. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_generate(IntPtr context, ulong @object, MotionDesc* desc, ulong* out_motion);

        /// <summary>Pose at t in [0, 1] (clamped), 0 = rest; between key poses along the joint's own screw. NULL value is allowed. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_sample(IntPtr context, ulong motion, float t, Pose* out_pose, float* out_value);

        /// <summary>The DM_MOTION_FRAMES key poses, and (when not NULL) their joint values. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_get_frames(IntPtr context, ulong motion, Pose* out_poses, float* out_values);

        /// <summary>Destroys a motion that no other thread samples. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_motion_destroy(IntPtr context, ulong motion);

        /// <summary>The player grabs a part. Where the library found the joint, a pull tells more about it: the drag holds the part's other hypotheses, and likely joints beyond them, and follows the one that explains the pull best, and limits that were estimated yield when the pull goes on beyond them. docs/feel.md. A grab point or value that can't be meant (other units, degrees) gets a warning. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_begin(IntPtr context, DragDesc* desc, ulong* out_drag);

        /// <summary>The grabbed point follows the pointer ray (object frame; scaled with dm_drag_desc.scale) as closely as its joint allows; dt in seconds, from -1e-4 to 0 taken as 0: a clock's rounding. Pass first the ray that grabbed the part: by how much it misses the grab point (at most 0.032 rad) is kept for the whole drag, so that the part does not move before the pointer does. After dm_drag_release it moves by itself, and ray may be NULL. out_state-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_update(IntPtr context, ulong drag, Ray* ray, float dt, DragState* out_state);

        /// <summary>dm_drag_update for all that a dm_drag_input holds. A released part needs no hand. Errors: INVALID_ARGUMENT, also for handles, bounds and DM_INPUT_LOCKED of a drag without dm_drag_desc.rules. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_step(IntPtr context, ulong drag, DragInput* input, float dt, DragState* out_state);

        /// <summary>After an update with DM_INPUT_ASK, whose out_state is what is about to be: takes another value, inside the limits and bounds of that update. Events are then those of the value taken. Without this call, the update stands. Errors: INVALID_ARGUMENT when the last update did not ask. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_take(IntPtr context, ulong drag, float value, DragState* out_state);

        /// <summary>The player lets go, and the part does what was meant: it swings open, falls shut, springs back or stays. The DQ-VAE paces it where the object has its weights and desc.flags doesn't forbid it. dm_drag_update moves it, dm_drag_end ends it at any time; a second release changes its mind or replays. desc NULL = all defaults; out_plan may be NULL, else its struct_size must be set. Microseconds to a millisecond. One caller at a time per drag. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_release(IntPtr context, ulong drag, ReleaseDesc* desc, ReleasePlan* out_plan);

        /// <summary>Lets go. out_state (may be NULL, else its struct_size must be set) gets what dm_drag_get_part_state gives. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_end(IntPtr context, ulong drag, PartState* out_state);

        /// <summary>Where the part stands and the joint that the drag follows now, with the limits and the confidence that the pull so far has left it. The same piece taken back by dm_drag_desc.state goes on where this one is. out_state-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_get_part_state(IntPtr context, ulong drag, PartState* out_state);

        /// <summary>Bytes that dm_drag_save writes: the same for every drag of this library, DM_DRAG_SNAPSHOT_MAX at most. [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr dm_drag_snapshot_size();

        /// <summary>Writes the whole state of a drag, for rollback: after dm_drag_restore the same calls give the same bits. For this very version of the library on this kind of machine; what lasts is dm_part_state. BUFFER_TOO_SMALL when capacity is less than dm_drag_snapshot_size. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_save(IntPtr context, ulong drag, void* buffer, UIntPtr capacity);

        /// <summary>Puts a drag back into a saved state, of this or any other drag of the same part. Errors leave it as it is: BAD_DATA, VERSION, and INVALID_ARGUMENT when the state is of another part. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_drag_restore(IntPtr context, ulong drag, void* data, UIntPtr size);

        /// <summary>out = a after b: x -&gt; a(b(x)). [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_multiply(Pose* a, Pose* b, Pose* out_pose);

        /// <summary>The motion back: what it does to the points that `pose` has moved undoes it. out_pose may be `pose`. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_inverse(Pose* pose, Pose* out_pose);

        /// <summary>The pose that rotates, then translates, as engines keep the place of a node. rotation: quaternion x, y, z, w of any length. Errors: INVALID_ARGUMENT when it has no length; NOT_FINITE. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_pose_from_rotation(float* rotation, Vec3 translation, Pose* out_pose);

        /// <summary>4x4, column-major, column vectors (OpenGL, glTF, Unity's Matrix4x4 memory order). [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_to_matrix(Pose* pose, float* out_matrix);

        /// <summary>Moves `count` float32 points; strides in bytes, 0 = packed. src may equal dst. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_pose_apply_points(Pose* pose, float* src, UIntPtr src_stride, float* dst, UIntPtr dst_stride, UIntPtr count);

        /// <summary>Ray through pixel (x, y), (0, 0) the top left corner of the viewport; direction is unit. Errors: INVALID_ARGUMENT when the camera has no view; NOT_FINITE when the ray's origin is beyond a float's range. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_camera_ray(IntPtr context, Camera* camera, float x, float y, Ray* out_ray);

        /// <summary>Errors: UNSUPPORTED when the context picks nothing (DM_PICK_NONE, or nothing was found). [any-thread]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_create(IntPtr context, SceneDesc* desc, ulong* out_scene);

        /// <summary>Destroys it with its instances; their objects stay. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_destroy(IntPtr context, ulong scene);

        /// <summary>Places a prepared object; placement NULL = identity (object frame to world). Instances are small numbers from 0 on, used again after a removal. Errors: UNSUPPORTED when the object can't be picked: it kept no triangles, or is smaller than 1e-6 or larger than 1e12 host units. Takes effect with dm_scene_commit. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_add(IntPtr context, ulong scene, ulong @object, Pose* placement, uint* out_instance);

        /// <summary>Moves a part of an instance to `pose` (from rest, object frame; the pose of the parts that carry it included), or with part_id 0 the whole instance to a new placement. Takes effect with dm_scene_commit. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_move(IntPtr context, ulong scene, uint instance, uint part_id, Pose* pose);

        /// <summary>Takes an instance away, at once. [exclusive object]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_remove(IntPtr context, ulong scene, uint instance);

        /// <summary>Makes the moves visible to picks. Once a frame, after them. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_commit(IntPtr context, ulong scene);

        /// <summary>Nearest hit of a ray. DM_OK with out_hit-&gt;object 0 when nothing is hit. Several threads may pick at once while none moves or commits. out_hit-&gt;struct_size must be set. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_scene_pick(IntPtr context, ulong scene, Ray* ray, Hit* out_hit);

        /// <summary>Version of the libdragmesh_gltf in use, as DM_VERSION.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_version();

        /// <summary>Reads triangles, strips and fans, also quantised ones (KHR_mesh_quantization) and, where the build has their libraries, compressed ones (EXT_meshopt_compression, KHR_meshopt_compression, KHR_draco_mesh_compression). Another required extension that may change geometry: UNSUPPORTED, by name. Morph targets are applied as the file's weights say. An instance of EXT_mesh_gpu_instancing is a node of its own, behind those of the file, below the one that has the extension. Left out with a warning: triangles whose vertices do not exist or are not finite, primitives that are broken, points, lines, nodes whose scale is zero. Left out in silence, because they are no body: nodes and meshes named UCX_*, UBX_*, UCP_*, USP_*, *_collider, *-colonly, *-convcolonly; coarser levels of detail (MSFT_lod, or siblings named *_LOD0, *_LOD1); invisible nodes (KHR_node_visibility) and materials of alpha 0. When nothing is left, the error is the first reason: BAD_DATA, NOT_FINITE, INDEX_OUT_OF_RANGE, DEGENERATE_MESH. Others: NOT_FOUND (a file beside it), VERSION, TOO_LARGE (it would take more memory than 64 MB and 64 bytes a byte of the file, 256 a byte of a Draco stream). A call logs one warning, which counts what is left out and quotes the first three.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_open(GltfDesc* desc, IntPtr* out_gltf);

        /// <summary>The same for a file and those beside it, which are read from its folder and from nowhere else; `desc` leaves data, size and files at 0. NOT_FOUND: there is no such regular file.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_open_file(byte* path, GltfDesc* desc, IntPtr* out_gltf);

        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_close(IntPtr gltf);

        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_node_count(IntPtr gltf);

        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_node(IntPtr gltf, uint index, GltfNode* out_node);

        /// <summary>positions float32, indices uint32; no part ids. Points into the dm_gltf.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_mesh(IntPtr gltf, MeshDesc* out_mesh);

        /// <summary>Where the merged mesh's origin is in the scene: 0, 0, 0 but for objects more than 256 times their size away, whose shape floats could not hold there.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_get_origin(IntPtr gltf, double* out_origin);

        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_surface_count(IntPtr gltf);

        /// <summary>An image that can't be had is left out with a warning. Errors: NOT_FOUND, OUT_OF_MEMORY.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_surface(IntPtr gltf, uint index, GltfSurface* out_surface);

        /// <summary>Writes where the corners of a surface lie in its base colour texture: u and v of each, three corners a face, in the order of the merged mesh; (0, 0) is the image's top left corner. Scaled, turned and shifted as the material says (KHR_texture_transform). corner_count: three times face_count. Errors: NOT_FOUND (no texture, or no coordinates), BUFFER_TOO_SMALL, BAD_DATA, OUT_OF_MEMORY.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_texture_coordinates(IntPtr gltf, uint index, float* out_uv, ulong corner_count);

        /// <summary>Sets `value` for every face of the named nodes or bones and of all that they carry (a name that several nodes share means all of them; that of a node with a skin means all its bones; "#12" means node 12 of the file, for files without names). Errors: NOT_FOUND, naming the first missing name and some that exist.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_mark_faces(IntPtr gltf, byte** names, uint name_count, byte value, byte* inout_face_ids, ulong face_count);

        /// <summary>What the file says of a node, as dm_part_desc takes it: the names of those that carry it, outermost first, of its mesh and its own, joined by '/', and its origin and axes in the merged mesh's frame. name: as for dm_gltf_mark_faces; of several nodes, the first. out_label: label_size bytes, where not all names fit the outer ones are left out; may be NULL. out_pivot may be NULL. Errors: NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_hints(IntPtr gltf, byte* name, byte* out_label, UIntPtr label_size, Pivot* out_pivot);

        /// <summary>The scene as dm_asset_create takes it: all nodes that have triangles or carry some, and those of which the merged mesh has none because they are no body. First come the dm_gltf_nodes in their order, then groups without triangles, then what is hidden, a collider or a coarser level of detail (DM_ASSET_NODE_FOLLOWS). Meshes are in the merged mesh's frame, so that transforms are NULL. Clips are the file's animations, each against the node above it. Joints are those of the nodes' `extras` and of KHR_physics_rigid_bodies (docs/gltf.md). flags: 0. Points into the dm_gltf. Errors: OUT_OF_MEMORY, TOO_LARGE.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_asset(IntPtr gltf, uint flags, AssetNode** out_nodes, uint* out_count);

        /// <summary>The index in the file's nodes array of a node of that list. Errors: those, NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_asset_node(IntPtr gltf, uint index, uint* out_node);

        /// <summary>1 when pivots tell nothing: the file has several dm_gltf_nodes, and the origins of all follow one rule, as exporters leave them: they are one point, or lie at the same place of each node's box (middle, lowest corner, middle of a face …). 0: some may tell, or gltf is NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_pivots_are_lost(IntPtr gltf);

        /// <summary>Writes what is known of where a node's pivot lies (DM_PIVOT_*), for dm_part_desc.pivot_kind. A rule holds where the node with the largest surface and more than half of all follow it: DM_PIVOT_DEFAULT is the answer for what follows it, DM_PIVOT_SET for the others. DM_PIVOT_UNKNOWN: no rule holds, or the node has no triangles. name: as for dm_gltf_get_hints. Errors: NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_get_pivot_kind(IntPtr gltf, byte* name, int* out_kind);

        /// <summary>1 when triangles of the file are not in the merged mesh: a triangle, a primitive or a node could not be read, or only one of its instances was. Warnings of dm_gltf_open name them. Pass DM_PREPARE_MESH_INCOMPLETE then. 0: all are there, or gltf is NULL.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_left_out(IntPtr gltf);

        /// <summary>Reads a part mask (.npy or JSON array, one integer a vertex or one a face, in the order of the file where bones sort the merged mesh otherwise). mask_value NULL: non-zero is moving. out_part_ids: as many bytes as max(vertex_count, face_count). out_ambiguous (may be NULL): both lengths fit, and per vertex was taken. Errors: BAD_DATA, INVALID_ARGUMENT (neither length fits), EMPTY_MASK, FULL_MASK.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_read_mask(IntPtr gltf, void* data, UIntPtr size, long* mask_value, byte* out_part_ids, int* out_scope, int* out_ambiguous);

        /// <summary>Writes a .glb: the file's meshes and materials, with the tracks' faces split off into nodes of their own that a looping animation moves. Without tracks it adds no animation. The file's own animations stay as they are, and go on moving the nodes that they name. out_data is released with dm_gltf_release_bytes.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_export(IntPtr gltf, GltfTrack* tracks, uint track_count, void** out_data, UIntPtr* out_size);

        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_release_bytes(IntPtr gltf, void* data, UIntPtr size);

        /// <summary>Writes a static .glb with one identity node a part. allocator zeros = malloc/free; release out_data with the same.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_write(GltfPart* parts, uint part_count, Allocator* allocator, Log* log, void** out_data, UIntPtr* out_size);

        /// <summary>Makes any text valid UTF-8, in place: a '?' for each piece that is no character, also for one that was cut off. Names and messages of this library are so already; hosts need it for what they write beside them. Returns the new length, never a longer one. NULL: 0.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern UIntPtr dm_gltf_mend_text(byte* text);

        /// <summary>Makes the files of all formats asked for, meshes that they share included, in memory. Parts that move are bodies, in metres and Z up, hung on what carries them; parts that stay, and fixed ones, are one with it. Bodies are called part_N_NAME, N the part's index + 1 and NAME what is legal of its first node's name; the body that stays is "body". Errors: those of the meshes, NOT_FINITE, INVALID_ARGUMENT (no format, parents in a circle), INDEX_OUT_OF_RANGE, DEGENERATE_MESH (no triangle), OUT_OF_MEMORY, STRUCT_SIZE.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_rig_make(GltfRigDesc* desc, IntPtr* out_rig);

        /// <summary>Frees the files. NULL does nothing.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern void dm_gltf_rig_destroy(IntPtr rig);

        /// <summary>How many files there are. NULL: 0.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern uint dm_gltf_rig_file_count(IntPtr rig);

        /// <summary>Meshes come before the files that refer to them. Errors: INVALID_ARGUMENT, NOT_FOUND.</summary>
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl)]
        public static extern int dm_gltf_rig_get_file(IntPtr rig, uint index, GltfRigFile* out_file);

        /// <summary>dm_drag_update for all that a dm_drag_input holds. A released part needs no hand. Errors: INVALID_ARGUMENT, also for handles, bounds and DM_INPUT_LOCKED of a drag without dm_drag_desc.rules. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, EntryPoint = "dm_drag_step")]
        public static extern int dm_drag_update_input(IntPtr context, ulong drag, DragInput* input, float dt, DragState* out_state);

        /// <summary>After an update with DM_INPUT_ASK, whose out_state is what is about to be: takes another value, inside the limits and bounds of that update. Events are then those of the value taken. Without this call, the update stands. Errors: INVALID_ARGUMENT when the last update did not ask. [frame]</summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, EntryPoint = "dm_drag_take")]
        public static extern int dm_drag_override(IntPtr context, ulong drag, float value, DragState* out_state);
    }
}
