/* dragmesh: makes any 3D object openable. This header is the whole public interface.
 *
 * Once per object:   mesh + part ids --prepare--> joints (type, axis, origin, limits)
 * Every frame:       pointer ray --pick--> grabbed point --drag--> joint value --> rigid pose
 *
 * Conventions of all functions:
 *  - Frames and units are the host's, as dm_context_desc states them, and angles are radians (docs/coordinates.md).
 *  - A function returns DM_OK (0) or a negative dm_result. After an error its outputs are untouched, the context stays
 *    usable, and the log callback gets a message that names field and value, except from [frame] functions. Any
 *    function may answer INVALID_ARGUMENT, STRUCT_SIZE, STALE_HANDLE and NOT_FINITE, one that names a part or an
 *    instance NOT_FOUND, and one that makes something OUT_OF_MEMORY. Its comment says what else it may answer.
 *  - The caller sets struct_size in every struct that has it, outputs included, or starts from dm_NAME_default().
 *    A zero in any other field means its default. The elements of an array all have the struct_size of the first.
 *  - Memory that the host passes in is borrowed for the call alone, and written only where it is an output.
 *  - A handle of 0 is null. Handles, determinism and limits: docs/reliability.md.
 *  - The interface "dm.core/1" only grows (docs/integration.md, "Versions"). Frozen structs never change.
 *  - Callbacks call nothing of the context that calls them, and return normally (docs/integration.md).
 *  - Tags (docs/threading.md): [any-thread] can be called at any time from any thread. [frame] is the same, with one
 *    caller at a time for a drag, motion or scene, and never allocates, locks or logs. During an [exclusive object]
 *    call, no other call uses the same object, scene or model; during an [exclusive context] call, none uses the
 *    context. */
#ifndef DRAGMESH_H
#define DRAGMESH_H

#include <stddef.h>
#include <stdint.h>

/* The library is built with DM_BUILDING, which exports its functions. Hosts on Windows that link it statically define
 * DM_STATIC. */
#if defined(_WIN32)
#define DM_CALL __cdecl
#if defined(DM_BUILDING)
#define DM_API __declspec(dllexport)
#elif defined(DM_STATIC)
#define DM_API
#else
#define DM_API __declspec(dllimport)
#endif
#else
#define DM_CALL
#if defined(DM_BUILDING)
#define DM_API __attribute__((visibility("default")))
#else
#define DM_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define DM_VERSION_MAJOR 0
#define DM_VERSION_MINOR 4
#define DM_VERSION_PATCH 0
/* It is 1 while the version that the three numbers name is in development, and 0 in its release. */
#define DM_VERSION_DEVELOPMENT 1
/* One number that rises with the version; dm_version returns that of the library in use. It is even in a release, whose
 * patch number is even. In development it is odd, one less than in the release to come. So 0.4.0 in development lies
 * above every release before it and below 0.4.0. Its bits read 0.3.4095, which is never released. */
#define DM_VERSION (((DM_VERSION_MAJOR << 22) | (DM_VERSION_MINOR << 12) | DM_VERSION_PATCH) - DM_VERSION_DEVELOPMENT)

/* Number of key poses of a generated motion (paper: T). */
#define DM_MOTION_FRAMES 16
/* Most hypotheses kept for one part. */
#define DM_MAX_HYPOTHESES 8
/* Most parts of one object, without the body. */
#define DM_MAX_PARTS 4096
/* Most nodes of one asset. At most DM_MAX_PARTS of them may have a mesh and not the flag DM_ASSET_NODE_FOLLOWS. */
#define DM_MAX_ASSET_NODES 65536
/* Most bytes of a label, without the terminating zero. */
#define DM_MAX_LABEL 4096
/* Most vertices or triangles of one object. */
#define DM_MAX_ELEMENTS 268435456
/* Most links of one object. */
#define DM_MAX_LINKS 256
/* Most snap values of one drag. */
#define DM_MAX_SNAPS 16
/* Most bytes of a dm_drag_save in any library of the interface dm.core/1. dm_drag_snapshot_size returns how many this
 * one writes. */
#define DM_DRAG_SNAPSHOT_MAX 65536

/* ---- results ------------------------------------------------------------------------------------------------ */

typedef int32_t dm_result;
enum {
    DM_OK = 0,
    DM_ERROR_INVALID_ARGUMENT = -1,   /* a null pointer, an unknown enum value, a count that makes no sense */
    DM_ERROR_STRUCT_SIZE = -2,        /* struct_size is too small, or a field is set that this library does not know */
    DM_ERROR_STALE_HANDLE = -3,       /* null, destroyed, or of another kind or context */
    DM_ERROR_OUT_OF_MEMORY = -4,      /* the host's allocator returned NULL */
    DM_ERROR_NOT_FINITE = -5,         /* a NaN or infinite number in the input */
    DM_ERROR_INDEX_OUT_OF_RANGE = -6, /* an index names a vertex or a hypothesis that does not exist */
    DM_ERROR_EMPTY_MASK = -7,         /* no triangle belongs to the part */
    DM_ERROR_FULL_MASK = -8,          /* the mask, or the part found, is the whole mesh, so nothing stays */
    DM_ERROR_DEGENERATE_MESH = -9,    /* no triangle with an area, or all vertices in one point */
    DM_ERROR_ZERO_DRAG = -10,         /* the drag vector has no length */
    DM_ERROR_DRAG_OFF_PART = -11,     /* the drag point is farther from the part than half the object's size */
    DM_ERROR_BAD_DATA = -12,          /* truncated, corrupt or hostile bytes */
    DM_ERROR_WRONG_MODEL = -13,       /* readable weights, but not of the architecture asked for */
    DM_ERROR_VERSION = -14,           /* made by a newer version than this library can read */
    DM_ERROR_CANCELLED = -15,         /* the progress callback asked to stop */
    DM_ERROR_NO_MODEL = -16,          /* the call needs weights and none were given */
    DM_ERROR_TOO_LARGE = -17,         /* more than DM_MAX_ELEMENTS or DM_MAX_PARTS */
    DM_ERROR_BUFFER_TOO_SMALL = -18,  /* the output buffer cannot hold the answer; the size needed is set */
    DM_ERROR_NOT_FOUND = -19,         /* no such part, node or instance */
    DM_ERROR_UNSUPPORTED = -20,       /* valid, but this build or this kind of file cannot do it */
    DM_ERROR_INTERNAL = -21           /* a bug of ours; please report it */
};

/* ---- plain types (frozen) ----------------------------------------------------------------------------------- */

typedef struct dm_vec3 {
    float x, y, z;
} dm_vec3;

/* A rigid pose x' = R x + t as a unit dual quaternion real + eps dual, both in x, y, z, w order;
 * dual = 1/2 t (*) real with t as a pure quaternion. Identity: real = {0,0,0,1}, dual = {0,0,0,0}. */
typedef struct dm_pose {
    float real[4];
    float dual[4];
} dm_pose;

/* A ray. The direction need not be a unit vector. Distances along the ray are in host units, not in multiples of it. */
typedef struct dm_ray {
    dm_vec3 origin;
    dm_vec3 direction;
} dm_ray;

typedef struct dm_context dm_context;
typedef uint64_t dm_model;  /* loaded weights */
typedef uint64_t dm_object; /* a prepared object: parts and their joints */
typedef uint64_t dm_motion; /* a generated motion of one part: 16 key poses, sampled continuously */
typedef uint64_t dm_drag;   /* one player dragging one part */
typedef uint64_t dm_scene;  /* placed objects that rays can pick */
typedef uint64_t dm_asset;  /* a whole asset: which of its nodes move, how, and what carries them */

/* ---- context ------------------------------------------------------------------------------------------------ */

/* The host's memory. allocate returns memory aligned to `alignment` (a power of two, 64 at most) or NULL; release gets
 * the size that was asked for. Both may be called from any thread on which the host calls the library.
 * docs/integration.md says what callbacks may do. */
typedef struct dm_allocator {
    void* user;
    void*(DM_CALL* allocate)(void* user, size_t size, size_t alignment);
    void(DM_CALL* release)(void* user, void* memory, size_t size);
} dm_allocator;

enum { DM_LOG_ERROR = 0, DM_LOG_WARNING = 1, DM_LOG_INFO = 2 };

/* Receives messages for people, on the threads on which the host calls the library. level: DM_LOG_*. code: the error,
 * or DM_OK for other messages. text: UTF-8, valid during the call. */
typedef struct dm_log {
    void* user;
    void(DM_CALL* message)(void* user, int32_t level, dm_result code, const char* text);
} dm_log;

typedef void(DM_CALL* dm_task)(void* data, uint32_t index);

/* The host's job system. parallel_for runs task(data, i) once for every i in [0, count) and returns non-zero when all
 * are done. It may return 0 without having run any, and the library then runs them itself. When a task was left out,
 * made up or run twice, the call answers INVALID_ARGUMENT; a second run of a task does nothing. The library starts no
 * thread of its own. */
typedef struct dm_jobs {
    void* user;
    int32_t(DM_CALL* parallel_for)(void* user, uint32_t count, dm_task task, void* data);
} dm_jobs;

/* Reports how much of a call is done, as a number that rises from 0 to 1. It runs on the thread that calls the library,
 * whatever jobs run beside it. Return non-zero to cancel the call, which then answers DM_ERROR_CANCELLED. */
typedef int32_t(DM_CALL* dm_progress_callback)(void* user, float done);

/* The host's axes. The library's own frame is glTF's: right-handed, +Y up, metres. */
enum {
    DM_AXES_GLTF = 0,    /* right-handed, +Y up (glTF, Godot, OpenGL) */
    DM_AXES_UNITY = 1,   /* left-handed, +Y up, +Z forward */
    DM_AXES_UNREAL = 2,  /* left-handed, +Z up, +X forward */
    DM_AXES_BLENDER = 3, /* right-handed, +Z up (Blender, ROS, most CAD) */
    DM_AXES_CUSTOM = 4   /* those of dm_context_desc.custom_axes */
};

/* What picks rays. All choices give the same hits, except within float rounding of an edge or of another surface. */
enum {
    DM_PICK_AUTO = 0,     /* Embree 3.13 or 4 where its shared library is found, else the library's own code */
    DM_PICK_EMBREE = 1,   /* Embree; the context is refused where it is missing */
    DM_PICK_PORTABLE = 2, /* the library's own code, which runs everywhere, in the host's memory */
    DM_PICK_NONE = 3 /* nothing, for hosts that cast their own rays: objects keep no trees, and there are no scenes */
};

typedef struct dm_context_desc {
    uint32_t struct_size;
    int32_t axes;         /* DM_AXES_*; 0 = DM_AXES_GLTF */
    float unit_in_metres; /* length of one host unit, m; 0 = 1. Unreal: 0.01 */
    /* Row-major matrix that takes a host vector to glTF's axes, for DM_AXES_CUSTOM. It is orthogonal, with determinant
     * +1 or -1. */
    float custom_axes[9];
    dm_allocator allocator; /* zeros = malloc/free */
    dm_log log;             /* zeros = silent */
    dm_jobs jobs;           /* zeros = tasks run on the calling thread */
    int32_t picking;        /* DM_PICK_*; 0 = auto */
    uint32_t reserved;      /* 0 */
    /* Callback of dm_mesh_find_part, dm_object_load and dm_object_refine, and of dm_object_prepare and dm_asset_create
     * without one of their own; NULL = none. Several threads may call it at once, one for each such call. */
    dm_progress_callback progress;
    void* progress_user;
    /* Most bytes of scratch memory that stay with the context between calls; 0 = 32 MB, 1 = none. dm_context_trim gives
     * them back. */
    uint64_t kept_bytes;
} dm_context_desc;

typedef struct dm_memory_info {
    uint32_t struct_size;
    uint32_t reserved;    /* 0 */
    uint64_t bytes;       /* bytes held now through the context's allocator */
    uint64_t peak_bytes;  /* most bytes ever held */
    uint64_t allocations; /* calls of allocate so far */
    uint64_t pick_bytes;  /* bytes held now by Embree, which has its own allocator and reports sizes */
    uint64_t kept_bytes; /* share of `bytes` that no call uses now, kept for later calls (dm_context_desc.kept_bytes) */
} dm_memory_info;

/* ---- weights ------------------------------------------------------------------------------------------------ */

/* Weights, as the bytes of safetensors files. Each may be absent (NULL, 0). The library copies and repacks them, so the
 * host may free them after the call. */
typedef struct dm_model_desc {
    uint32_t struct_size;
    const void* kinematics; /* KPP-Net: sdk/models/kpp_net.safetensors */
    size_t kinematics_size;
    const void* motion; /* DQ-VAE: sdk/models/dq_vae.safetensors */
    size_t motion_size;
    const void* ranker; /* chooses between candidate joints: sdk/models/ranker.safetensors; rules choose without it */
    size_t ranker_size;
} dm_model_desc;

/* ---- objects ------------------------------------------------------------------------------------------------ */

enum {
    DM_JOINT_UNKNOWN = 0,
    DM_JOINT_REVOLUTE = 1,   /* turns about a line between two limits, rad */
    DM_JOINT_PRISMATIC = 2,  /* slides along a direction, host units */
    DM_JOINT_SCREW = 3,      /* turns and advances `pitch` host units a radian */
    DM_JOINT_CONTINUOUS = 4, /* turns without limits */
    DM_JOINT_FIXED = 5
};

enum { DM_FLOAT32 = 0, DM_FLOAT64 = 1 };                           /* formats of positions, three numbers each */
enum { DM_UINT32 = 0, DM_UINT16 = 1, DM_UINT8 = 2, DM_INT32 = 3 }; /* formats of indices and part ids */
enum { DM_PER_VERTEX = 0, DM_PER_FACE = 1 };

/* The host's mesh of triangles, which the library reads in place. The sizes of the buffers guard against a forgotten
 * format, scope or stride: the call refuses a buffer that does not hold what counts, formats and strides say, and never
 * reads past its end. */
typedef struct dm_mesh_desc {
    uint32_t struct_size;
    uint32_t position_stride; /* bytes from one vertex to the next; 0 = packed */
    const void* positions;    /* vertex_count x 3 numbers */
    uint64_t vertex_count;
    uint64_t position_bytes; /* size of the buffer that begins at `positions`; 0 = not stated, and not checked */
    const void* indices; /* index_count indices, three a triangle; NULL = each three vertices in order are a triangle */
    uint64_t index_count;
    uint64_t index_bytes; /* size of the buffer; 0 = not stated, and not checked */
    /* The part that each vertex or face belongs to: 0 = the body that stays, 1 and above = parts. An id that
     * dm_object_desc.parts does not list counts as the body's. With ids per vertex, a triangle belongs to the id that
     * two of its corners share, or else to the smallest. A mesh without a body, such as a door leaf alone, is allowed,
     * but its joints are less certain. */
    const void* part_ids;
    /* Size of the buffer that begins at `part_ids`, required with part_ids. It must be exactly that of one id a vertex
     * or a face, as part_id_scope says. */
    uint64_t part_id_bytes;
    uint32_t part_id_stride; /* bytes from one id to the next; 0 = packed */
    int32_t position_format; /* DM_FLOAT32 | DM_FLOAT64 */
    int32_t index_format;    /* DM_UINT32 | DM_UINT16 | DM_UINT8 */
    int32_t part_id_format;  /* DM_UINT32 | DM_UINT16 | DM_UINT8 | DM_INT32, whose negative ids are the body's */
    int32_t part_id_scope;   /* DM_PER_VERTEX | DM_PER_FACE */
    uint32_t reserved;       /* 0 */
} dm_mesh_desc;

/* A drag as evidence of how a part moves: a point on it, and the way in which a hand pulled it. */
typedef struct dm_drag_hint {
    dm_vec3 point;  /* a point on or near the part, host object frame */
    dm_vec3 vector; /* direction of the pull, not zero; its length is how far it went */
} dm_drag_hint;

/* The place, at rest, of the node or bone that moves a part. An artist may have put it on the hinge, or left it in the
 * middle or at the file's origin, so it is evidence only. Leave it out, or say DM_PIVOT_DEFAULT, where the nodes of an
 * asset all have their places by one rule: at one point, or at the same place of their boxes. A program has put them
 * there, and the library would take an edge that happens to lie there for a hinge. */
typedef struct dm_pivot {
    dm_vec3 origin; /* host object frame */
    /* The node's x, y and z axis, three numbers each, host object frame. They may have any length, and may be mirrored.
     * Zeros: unknown. */
    float axes[9];
} dm_pivot;

typedef struct dm_part_desc {
    uint32_t struct_size;
    uint32_t id;              /* id as in part_ids, 1 or above */
    uint32_t parent;          /* id of the part that carries this one and that it moves with; 0 = the body */
    int32_t joint_type;       /* DM_JOINT_*; 0 = the library infers it */
    const dm_drag_hint* drag; /* optional evidence */
    /* Optional evidence: the names that the asset has for the part, as UTF-8, outermost first, joined by '/': file,
     * parents, node, mesh. A name counts, in any language, when it says what the part is (door, lid, Hebel). At most
     * DM_MAX_LABEL bytes. */
    const char* label;
    const dm_pivot* pivot; /* optional evidence */
    int32_t pivot_kind;    /* DM_PIVOT_*: whether somebody has set the pivot */
    uint32_t reserved;     /* 0 */
} dm_part_desc;

/* How a pivot came to lie where it is. dm_gltf_get_pivot_kind returns it for a glTF file. */
enum {
    DM_PIVOT_UNKNOWN = 0, /* not known: the library compares it with those of the other parts */
    DM_PIVOT_DEFAULT = 1, /* a program puts all of them there, so it says nothing */
    /* The other nodes' pivots follow a rule and this one does not, so somebody has set it. It counts for more. */
    DM_PIVOT_SET = 2
};

/* How a part moves. */
typedef struct dm_joint {
    uint32_t struct_size;
    int32_t type;          /* DM_JOINT_* */
    float type_confidence; /* probability that the type is right, 0 to 1 */
    /* Probability that type, axis and origin are all right, 0 to 1; never above type_confidence. */
    float joint_confidence;
    float pitch; /* host units a radian, signed along the axis; for screws only */
    /* Unit vector, host object frame. A positive value slides along it, or turns about it: right-handed in a
     * right-handed host frame, left-handed in a left-handed one. A joint found with a drag is positive the way of the
     * drag. Without a drag the longer way is positive, so `upper` is the open end. */
    dm_vec3 axis;
    /* A point of the axis. For a joint that the library found, it is the one nearest the part's centre. The point of a
     * host's own joint stays as it was given. */
    dm_vec3 origin;
    /* Limits of the joint value, rad or host units; the rest pose is value 0. There are no limits when both are equal,
     * and none for continuous joints. A limit of the host farther from rest than 1000 rad or 100 object sizes (FLT_MAX,
     * 1e10, infinity) counts as none. Where only one side has none, a slightly larger number stands for the missing
     * limit. */
    float lower, upper;
    int32_t source; /* DM_JOINT_FROM_*, DM_JOINT_CHOSEN */
    /* Evidence in a dm_part_state: what the part's pulls so far say of all its joints. dm_drag_end writes it and
     * dm_drag_begin reads it, so keep the four numbers as they are. Zeros: no pull has said anything. In other structs
     * it is 0, and no function reads it. */
    uint32_t evidence[4];
    /* Joint value at which the part is closed: 0, or one of the limits when the part rests open. A host's joint may set
     * it; a value outside of its limits becomes the nearer limit. */
    float closed;
} dm_joint;

enum {
    DM_JOINT_FROM_NETWORK = 0,
    DM_JOINT_FROM_GEOMETRY = 1,
    DM_JOINT_FROM_HOST = 2, /* the host's own: certain, limits too, and no pull changes it */
    /* The host has chosen it with dm_object_desc.choose. No pull replaces it, or moves its range to the other side of
     * rest. Its limits are estimates, and give. */
    DM_JOINT_CHOSEN = 3
};

/* A joint as the constraint of a physics engine: an orthonormal frame whose x axis is that of the hinge or slider. The
 * y and z axes are arbitrary, but always the same for the same joint. x, y, z and `rotation` have determinant +1 in the
 * host's coordinates. */
typedef struct dm_joint_frame {
    uint32_t struct_size;
    int32_t type;      /* DM_JOINT_* */
    dm_vec3 origin;    /* host object frame */
    dm_vec3 x, y, z;   /* unit vectors */
    float rotation[4]; /* unit quaternion x, y, z, w that takes the frame's coordinates to the object's */
    /* Limits, about or along x: rad for hinges and screws, host units for sliders; 0 where there is none. */
    float lower, upper;
    uint32_t limits; /* DM_LIMIT_LOWER | DM_LIMIT_UPPER: the limits that exist */
    float pitch;     /* host units along x a radian; for screws only */
} dm_joint_frame;

enum { DM_LIMIT_LOWER = 1, DM_LIMIT_UPPER = 2 };

/* Where the part of one instance stands, and by which joint it moves. This is all that a host must keep, save,
 * replicate and undo for it. It belongs to the instance, not to the object, because two doors of one object may differ.
 * Save it field by field: type, pitch, axis, origin, limits, source, both confidences, evidence, value. */
typedef struct dm_part_state {
    uint32_t struct_size;
    float value;    /* joint value; 0 = rest */
    float velocity; /* d value / dt, for a physics engine that takes over; output only: a drag begins with velocity 0 */
    uint32_t status; /* DM_STATUS_*; output only */
    /* The pose as shown, from rest. It differs from dm_joint_pose(joint, value) only while the part blends over to a
     * joint that has just changed. Zeros: the pose of joint and value. */
    dm_pose pose;
    dm_joint joint; /* stays the last field */
} dm_part_state;

/* Asks the host for the joint type of a part (a designer's tag, a rule, a vision-language model). Return a DM_JOINT_*,
 * or DM_JOINT_UNKNOWN to leave the question to the library. */
typedef int32_t(DM_CALL* dm_intent_callback)(void* user, uint32_t part_id, dm_vec3 box_min, dm_vec3 box_max);

typedef struct dm_part_info {
    uint32_t struct_size;
    uint32_t id, parent;
    uint32_t triangle_count; /* triangles of the part alone, without the parts it carries */
    dm_vec3 box_min, box_max;
    dm_vec3 centre; /* centroid of the surface */
    float area;
} dm_part_info;

/* Where a hypothesis takes its part at one end of its range, host object frame. Frozen. */
typedef struct dm_joint_end {
    float value;              /* joint value */
    dm_pose pose;             /* pose of the part, from rest */
    dm_vec3 box_min, box_max; /* box of the part alone, as in dm_part_info */
    dm_vec3 centre;
} dm_joint_end;

/* A ranked hypothesis and what it would do. struct_size says how much the library has filled. */
typedef struct dm_hypothesis {
    uint32_t struct_size;
    uint32_t reserved;     /* 0 */
    const dm_joint* joint; /* the joint, with its limits and probabilities */
    /* The ends at the lower and at the upper limit. For a joint without limits they are a quarter turn, or half the
     * object's size, either way. */
    dm_joint_end ends[2];
} dm_hypothesis;

/* A part and its hypotheses, for the host to choose from. It is valid during the call only. */
typedef struct dm_choice {
    uint32_t struct_size;
    uint32_t count; /* number of hypotheses, 1 to DM_MAX_HYPOTHESES */
    const dm_part_info* part;
    const dm_hypothesis* const* hypotheses; /* most probable first */
} dm_choice;

enum { DM_CHOICE_KEEP = -1 };

/* Asks the host which hypothesis is right (a designer's rule, a vision-language model that sees pictures). Return its
 * index to put it in force; its source becomes DM_JOINT_CHOSEN, and both confidences become 1. Return DM_CHOICE_KEEP to
 * keep the library's answer with its confidences. With any other number, the preparation answers INDEX_OUT_OF_RANGE.
 * dm_object_get_hypotheses and dm_object_reset_joint still give the library's own ranking afterwards. The callback runs
 * on the thread that prepares, for one part after the other by rising id, and not for parts that the host declares
 * fixed. */
typedef int32_t(DM_CALL* dm_choice_callback)(void* user, const dm_choice* choice);

enum {
    /* The object keeps no triangles. It is small, and cannot be added to a scene. */
    DM_PREPARE_WITHOUT_PICKING = 1,
    /* KPP-Net alone infers the joints, without geometric candidates and ranker, for comparisons. The call answers
     * NO_MODEL when `model` has no kinematics weights. */
    DM_PREPARE_NETWORK_ALONE = 2,
    /* The reader of the mesh has left out something of its file (dm_gltf_left_out). The object keeps it as
     * DM_DEGRADED_MESH. */
    DM_PREPARE_MESH_INCOMPLETE = 4
};

typedef struct dm_object_desc {
    uint32_t struct_size;
    uint32_t flags; /* DM_PREPARE_* */
    const dm_mesh_desc* mesh;
    const dm_part_desc* parts; /* NULL: every id above 0 in part_ids is a part that the body carries */
    uint32_t part_count;
    uint32_t reserved; /* 0 */
    dm_model model;    /* weights; 0 = the joints come from geometry alone */
    uint64_t seed;     /* seed of the surface sampling; the same seed gives the same bits */
    dm_intent_callback intent;
    void* intent_user;
    dm_progress_callback progress; /* NULL = the context's */
    void* progress_user;
    /* Optional evidence: names of the whole object, as dm_part_desc.label. They count for the parts whose own label
     * says nothing. */
    const char* label;
    /* The up direction, host object frame. It counts only together with labels and pivots. 0 = that of the context's
     * axes. */
    dm_vec3 up;
    dm_choice_callback choose;
    void* choose_user;
} dm_object_desc;

/* Why the answers about an object are worse than they could be, as bits of dm_object_info.degraded. The call that makes
 * the object says the same in one warning. A saved object keeps the bits, except DM_DEGRADED_NO_MOTION, which depends
 * on the model that it is loaded with. */
enum {
    DM_DEGRADED_NO_KINEMATICS = 1, /* no weights of KPP-Net: geometry alone finds the joints */
    DM_DEGRADED_NO_RANKER = 2,     /* no weights of the ranker: rules choose the joints, and set limits */
    DM_DEGRADED_NO_MOTION = 4,     /* no weights of the DQ-VAE: a rule paces releases, and motions answer NO_MODEL */
    DM_DEGRADED_NO_BODY = 8,       /* the mesh has no body, whose contacts would show the joints */
    DM_DEGRADED_HINT = 16,         /* a pivot was ignored, because it is 1,000 object sizes away or more */
    DM_DEGRADED_MESH = 32          /* DM_PREPARE_MESH_INCOMPLETE */
};

typedef struct dm_object_info {
    uint32_t struct_size;
    uint32_t part_count;
    uint64_t vertex_count, triangle_count;
    dm_vec3 box_min, box_max; /* host object frame; oblique custom axes may make it larger than need be */
    float size;               /* largest side of the box */
    uint32_t pickable;        /* 1 when it has kept its triangles */
    uint32_t degraded;        /* DM_DEGRADED_*; 0: nothing was missing */
    /* DM_PICK_EMBREE or DM_PICK_PORTABLE: the kind of its trees. DM_PICK_NONE: it has none. */
    int32_t picking;
} dm_object_info;

/* ---- assets ------------------------------------------------------------------------------------------------- */

/* The asset frame is the one into which the nodes' transforms take their meshes. It is the object frame of the object
 * that dm_asset_make_object makes. */

#define DM_ASSET_NO_NODE UINT32_MAX /* no node: the scene itself */
#define DM_ASSET_NO_PART UINT32_MAX /* no part: the body that stays */

enum {
    /* The node is neither part nor body: a level of detail, a collider, something hidden. It goes where `follows` goes,
     * and its mesh is not read. */
    DM_ASSET_NODE_FOLLOWS = 1,
    DM_ASSET_NODE_NO_PIVOT = 2 /* the place of its origin says nothing */
};

enum { DM_CLIP_NOT_RIGID = 1 /* the animation also scales or bends the node */ };

/* How one animation moves one node. Frozen. */
typedef struct dm_asset_clip {
    const char* name;   /* name of the animation, UTF-8; may be NULL */
    const float* times; /* s, rising */
    /* Poses of the node relative to the pose that its mesh has, asset frame, as if all nodes above it stood still. */
    const dm_pose* poses;
    uint32_t key_count; /* number of times and of poses */
    uint32_t flags;     /* DM_CLIP_NOT_RIGID */
} dm_asset_clip;

/* A node of an asset, as the host has it. */
typedef struct dm_asset_node {
    uint32_t struct_size;
    uint32_t flags;  /* DM_ASSET_NODE_* */
    uint32_t parent; /* index of the node above it, which may come later in the list, or DM_ASSET_NO_NODE */
    /* Index of the node that a DM_ASSET_NODE_FOLLOWS follows; DM_ASSET_NO_NODE: the one above it. */
    uint32_t follows;
    const char* name;         /* UTF-8, DM_MAX_LABEL bytes at most; NULL: none */
    const char* mesh_name;    /* name of its mesh, with the same rules */
    const dm_mesh_desc* mesh; /* mesh without part_ids; NULL: a node without a mesh, such as a group */
    /* 4x4, column-major, affine: takes the node's frame to the asset frame, all nodes above it included. NULL:
     * identity. */
    const float* transform;
    /* Pivot of the node, asset frame. NULL: origin and axes of `transform`, and unknown where that is NULL too. */
    const dm_pivot* pivot;
    const dm_asset_clip* clips;
    uint32_t clip_count;
    uint32_t reserved; /* 0 */
    /* Joint that the file states for this node, asset frame, with limits. It is as certain as a joint that the host
     * sets. DM_JOINT_FIXED: the node is one with the node above it. NULL: none. */
    const dm_joint* joint;
} dm_asset_node;

enum {
    DM_ASSET_WITHOUT_CLIPS = 256, /* clips are ignored */
    DM_ASSET_WITHOUT_NAMES = 512  /* names and labels are ignored */
};

typedef struct dm_asset_desc {
    uint32_t struct_size;
    uint32_t flags; /* DM_ASSET_*, DM_PREPARE_WITHOUT_PICKING, DM_PREPARE_MESH_INCOMPLETE */
    const dm_asset_node* nodes;
    const char* label; /* optional evidence: names of the whole asset, as dm_object_desc.label */
    uint32_t node_count;
    /* Least probability of moving, 0 to 1, from which a part counts as moving and belongs to the object; 0 = 0.5. */
    float min_moves;
    dm_model model;                /* weights; 0 = the joints come from geometry alone */
    uint64_t seed;                 /* seed, as dm_object_desc.seed */
    dm_progress_callback progress; /* NULL = the context's */
    void* progress_user;
    dm_vec3 up;        /* the up direction, asset frame; 0 = that of the context's axes */
    uint32_t reserved; /* 0 */
} dm_asset_desc;

/* What was ignored, as bits of dm_asset_info.warnings. */
enum {
    DM_ASSET_CLIP_LEFT_OUT = 1 /* a clip is not rigid, or no joint moves a node as it does */
};

typedef struct dm_asset_info {
    uint32_t struct_size;
    uint32_t node_count;
    uint32_t part_count;     /* parts, those that stay included */
    uint32_t moving_count;   /* parts that move or are free, which are those of the object */
    uint64_t triangle_count; /* triangles of the nodes that do not follow others */
    uint32_t degraded;       /* DM_DEGRADED_*: what was missing when the joints were found */
    uint32_t warnings;       /* DM_ASSET_CLIP_LEFT_OUT */
} dm_asset_info;

/* Whether a part moves. */
enum {
    /* It may move, but probably does not: `moves` is below dm_asset_desc.min_moves. A body that almost certainly stays
     * is not listed as a part. */
    DM_ASSET_STAYS = 0,
    DM_ASSET_MOVES = 1, /* it moves by its joint */
    /* Only its weight holds it, as the lid of a teapot, so a player can take it away. Its joint is the slide by which
     * it comes off, with a low confidence. */
    DM_ASSET_FREE = 2
};

/* Where a part's joint comes from. */
enum {
    DM_ASSET_INFERRED = 0,  /* inferred from shape, contacts and names */
    DM_ASSET_FROM_FILE = 1, /* stated in dm_asset_node.joint */
    DM_ASSET_FROM_CLIP = 2  /* read from dm_asset_node.clips */
};

/* Nodes that move together, or might. */
typedef struct dm_asset_part {
    uint32_t struct_size;
    uint32_t parent;  /* index of the part that carries it, or DM_ASSET_NO_PART */
    uint32_t part_id; /* id in the object: its index in the asset + 1; 0 while it stays */
    int32_t state;    /* DM_ASSET_STAYS … */
    int32_t basis;    /* DM_ASSET_INFERRED … */
    float moves;      /* probability that it moves relative to what carries it, 0 to 1 */
    /* Its nodes, those that follow them included. Nodes of the parts that it carries do not count. */
    uint32_t node_count;
    uint32_t triangle_count; /* triangles of these nodes, without those that follow */
    /* Seconds in which its clip takes it from one end of the joint to the other; 0: it has no clip. */
    float duration;
    uint32_t reserved; /* 0 */
    dm_vec3 box_min, box_max;
} dm_asset_part;

/* ---- motion and drag ---------------------------------------------------------------------------------------- */

/* What the player asked for. The network answers with a motion of DM_MOTION_FRAMES poses from rest. */
typedef struct dm_motion_desc {
    uint32_t struct_size;
    uint32_t part_id;
    dm_drag_hint drag; /* required */
    /* Optional: the path on which the pointer drew the drag point, from drag.point on; at most 65536 points. */
    const dm_vec3* path;
    uint32_t path_count; /* 0: the path that opens the joint all the way in the drag's direction */
    uint32_t seed;       /* 0: the most likely motion (z = mean); else z is drawn with this seed */
} dm_motion_desc;

/* How a drag feels. Zeros are the defaults. Stiffness, damping and inertia of a part in the hand matter only through
 * two ratios, which are times: smoothing_time is damping over stiffness, coast_time is inertia over damping. */
typedef struct dm_drag_feel {
    float smoothing_time; /* s for the part to close half the gap to the pointer; 0 = 0.02, negative = none */
    /* Share of the range over which the ends give; 0 = hard ends. It does not apply to limits that the library
     * estimated: see dm_drag_desc.limit_give. */
    float soft_limit;
    /* Seconds in which a part left alone loses half its speed; in the hand it makes the part heavy. 0 = 0.1 once
     * released, and weightless in the hand; negative = it stops where it is let go. */
    float coast_time;
    /* Joint value from one catch to the next, rad or host units, counted from where the part is closed; 0 = none. */
    float detent;
    float detent_pull; /* strength of the catches, up to 1; 0 = 0.7. It has no effect without `detent` */
    /* Seconds in which the released part springs back to rest. 0 = push buttons alone do, in 0.12 s; negative = nothing
     * does. */
    float return_time;
} dm_drag_feel;

enum {
    /* The drag follows the joint in force with its limits, whatever the pull says, as it follows a host's joint. */
    DM_DRAG_KEEP_JOINT = 1,
    /* No point is grabbed, for hands of DM_HAND_RATE, STEP and VALUE, and for releases. grab_point is ignored, and the
     * middle of the part's box takes its place. */
    DM_DRAG_WITHOUT_POINT = 2
};

enum {
    /* The part stays where it is, gives a little, and reports a try as DM_EVENT_LOCKED. */
    DM_RULE_LOCKED = 1,
    /* A latch holds the part at rest until a handle has turned (dm_drag_input.handles), and catches it again when it
     * comes to rest with the handle let go. */
    DM_RULE_LATCH = 2
};

/* What a part does besides following the hand. Zeros are off, except that thresholds have defaults. "Range" is the way
 * from lower to upper limit; where one of them is missing, it is 1 rad or the object's size. docs/feel.md describes
 * each rule. */
typedef struct dm_drag_rules {
    uint32_t struct_size;
    uint32_t flags; /* DM_RULE_* */
    /* Joint values, rising, at which the part catches as at detents, with the strength of feel.detent_pull. With
     * feel.detent above 0 they are refused. */
    const float* snaps;
    uint32_t snap_count; /* DM_MAX_SNAPS at most */
    /* Distance, in joint value, from which a snap value catches the part, to either side; 0 = half-way to the next one,
     * or a twentieth of the range where there is none. */
    float snap_reach;
    float open_share; /* share of the range from rest beyond which DM_EVENT_OPENED comes; 0 = 0.1 */
    /* Share of the range from rest within which DM_EVENT_CLOSED comes; 0 = 0.02. It is less than open_share. A part
     * that is grabbed between both counts as open. */
    float closed_share;
    float event_time; /* shortest time between DM_EVENT_OPENED and DM_EVENT_CLOSED, s */
    float max_speed;  /* joint value a second; 0 = no limit */
    /* Joint value a second squared while the part gets faster: the highest force over the part's inertia; 0 = no
     * limit. */
    float max_acceleration;
    /* Share of the range by which a locked or latched part gives at most; 0 = 0.01, negative = none. */
    float lock_give;
    /* Joint value of a handle, of either sign, from which on the latch is open; 0 = 0.785 (rad: 45 degrees). */
    float latch_turn;
    /* Share of the range: a released part nearer to rest than this closes by itself; 0 = none does. */
    float auto_close_share;
    float auto_close_time; /* seconds in which it closes; 0 = 0.25 */
    float close_delay;     /* seconds from the release until the part starts to spring back by feel.return_time */
    /* Share of the range: a released part nearer to rest than this falls to rest, and any other to its open end, as a
     * hatch does; 0 = it does not fall. */
    float tip_share;
    float fall_time; /* seconds of a fall over the whole range; 0 = 0.7 */
    /* Share of its speed, 0 to 1, with which a part rebounds from a limit that it falls, glides or swings against. */
    float restitution;
    /* Host units from the hand to where it holds the part, beyond which the part is released (DM_EVENT_LET_GO);
     * 0 = never. */
    float break_distance;
    float drive_speed; /* share of the range a second at dm_hand.amount 1; 0 = 1 */
    uint32_t reserved; /* 0 */
} dm_drag_rules;

/* What a link does to its driven part. */
enum {
    /* The driven part's value is offset + ratio * (the driver's value beyond `from`), inside its limits. */
    DM_LINK_MOVES = 0,
    DM_LINK_FREES = 1, /* the driven part is held until the driver has reached `from`: a handle */
    DM_LINK_HOLDS = 2  /* the driven part is held once the driver has reached `from`: one drawer at a time */
};

enum { DM_LINK_BOTH_WAYS = 1 /* the driven part of a DM_LINK_MOVES also moves the driver */ };

/* A link between two parts. Frozen. */
typedef struct dm_link {
    uint32_t driver, driven; /* part ids */
    int32_t kind;            /* DM_LINK_* */
    uint32_t flags;          /* DM_LINK_BOTH_WAYS */
    /* How far the driven part's value changes for each unit of the driver's; 0 = 1. The two may be rad and host units,
     * as in a rack and pinion. */
    float ratio;
    float offset; /* value of the driven part while the driver is at `from` */
    /* Value of the driver from which on the link acts, on that side of rest. A `from` of 0 counts as reached at rest
     * for DM_LINK_FREES and DM_LINK_HOLDS. */
    float from;
} dm_link;

typedef struct dm_drag_desc {
    uint32_t struct_size;
    uint32_t part_id;
    dm_object object;
    dm_vec3 grab_point; /* point on the part as it is now, host object frame */
    float start_value;  /* joint value of the part now; 0 = rest. It must be 0 with `state` */
    dm_drag_feel feel;
    uint32_t flags; /* DM_DRAG_KEEP_JOINT, DM_DRAG_WITHOUT_POINT */
    /* How far a pull takes the part beyond limits that the library estimated, as a share of the range. 0 = as far as
     * the pull goes, by one turn or the object's size at most; negative = not at all. The host's own limits never give,
     * nor does a stop at rest. */
    float limit_give;
    /* The instance's joint and value, as an earlier drag has returned them; the drag begins in its pose. NULL = the
     * object's joint in force, at start_value. */
    const dm_part_state* state;
    /* Scale of the instance along the axes of the object frame; negative = mirrored, 0 = 1. grab_point, rays, state and
     * poses are then in the scaled frame (object coordinates times scale), and poses are rigid in it. */
    dm_vec3 scale;
    uint32_t reserved;          /* 0 */
    const dm_drag_rules* rules; /* NULL = no rules, and no events */
} dm_drag_desc;

/* How a hand holds the part. */
enum {
    DM_HAND_NONE = 0, /* no input in this update: the part moves on to its last target */
    DM_HAND_RAY = 1,  /* a pointer, with `ray` */
    /* A hand in space, with `point`. The vector from it to the grabbed point stays as it was in its first update. */
    DM_HAND_POINT = 2,
    DM_HAND_RATE = 3, /* a stick or a key held down, with `amount` from -1 to 1 times dm_drag_rules.drive_speed */
    DM_HAND_STEP = 4, /* a wheel, which moves the part by `amount`, a share of the range */
    DM_HAND_VALUE = 5 /* a slider of the host, which moves the part to the joint value `amount` */
};

typedef struct dm_hand {
    /* DM_HAND_*. RATE, STEP and VALUE stay inside the limits. RATE and STEP open the part with an amount above 0. A
     * limit that the library estimated stops them first. It gives afterwards, as it gives to a pull: to a RATE after
     * 0.25 s at the limit, to a STEP with the next step. */
    int32_t kind;
    dm_ray ray;    /* object frame, scaled with dm_drag_desc.scale */
    dm_vec3 point; /* object frame, scaled with dm_drag_desc.scale */
    float amount;  /* what RATE, STEP and VALUE ask for */
    /* Where a second hand takes hold of the part as it is then. It is read in that hand's first update only. */
    dm_vec3 grab_point;
} dm_hand;

enum {
    DM_INPUT_LOCKED = 1, /* the part is locked in this update, as by DM_RULE_LOCKED */
    DM_INPUT_ASK = 2,    /* dm_drag_override may change the value after this update */
    DM_INPUT_BOUNDS = 4  /* lower and upper hold even when they are equal */
};

/* Everything that one update can read. */
typedef struct dm_drag_input {
    uint32_t struct_size;
    uint32_t flags; /* DM_INPUT_* */
    dm_hand hand;
    /* Another hand on the part, by ray or point; DM_HAND_NONE = none. The hand that can move the part farther counts
     * more. The second hand comes and goes without a jump. */
    dm_hand second;
    float handles[2]; /* joint values of the handles of a latch, from their drags or links */
    /* Joint values between which the host's world leaves the part room in this update, infinite on a free side. There
     * are no bounds when both are equal, unless DM_INPUT_BOUNDS is set. The part stops there softly, goes on when it is
     * free, and is pushed back when it lies beyond. */
    float lower, upper;
} dm_drag_input;

enum {
    DM_DRAG_HELD = 0,     /* the part follows the pointer */
    DM_DRAG_RELEASED = 1, /* the part moves by itself after dm_drag_release */
    DM_DRAG_AT_REST = 2   /* the part has come to where it goes */
};

/* What has happened to the part since the update before, as bits of dm_drag_state.events. */
enum {
    /* It has met its lower limit (within 0.5 % of the range), with the speed dm_drag_state.impact. The event comes
     * again after the part was 2 % away. An estimated limit that has given does not count. */
    DM_EVENT_LIMIT_LOWER = 1,
    DM_EVENT_LIMIT_UPPER = 2,  /* the same for the upper limit */
    DM_EVENT_LEFT_REST = 4,    /* it is more than 2 % of the range away from rest */
    DM_EVENT_REACHED_REST = 8, /* it is within 0.5 % of the range of rest, having left it */
    DM_EVENT_OPENED = 16,      /* it has opened beyond dm_drag_rules.open_share */
    DM_EVENT_CLOSED = 32,      /* it has closed to within dm_drag_rules.closed_share */
    DM_EVENT_DETENT = 64,      /* it has passed to another detent or snap value, see dm_drag_state.detents */
    DM_EVENT_JOINT = 128,      /* the pull has changed the joint, see dm_drag_state.changes */
    DM_EVENT_BLOCKED = 256,    /* the bounds of dm_drag_input hold it */
    DM_EVENT_FREED = 512,      /* these bounds no longer hold it */
    DM_EVENT_LATCHED = 1024,   /* the latch has caught it */
    DM_EVENT_UNLATCHED = 2048, /* the handle has opened the latch */
    DM_EVENT_LOCKED = 4096, /* it was tried while locked or latched; the event comes again after the hand has let up */
    DM_EVENT_LET_GO = 8192  /* it was let go of at dm_drag_rules.break_distance */
};

/* What holds a part with dm_drag_rules, and whether it counts as open, after an update or when its drag begins, as bits
 * of dm_drag_state.status. */
enum {
    DM_STATUS_LATCHED = 1, /* the latch holds it */
    DM_STATUS_LOCKED = 2,  /* DM_RULE_LOCKED or DM_INPUT_LOCKED holds it */
    DM_STATUS_BLOCKED = 4, /* the bounds of dm_drag_input hold it, from DM_EVENT_BLOCKED to DM_EVENT_FREED */
    DM_STATUS_OPEN = 8     /* it counts as open, from DM_EVENT_OPENED to DM_EVENT_CLOSED */
};

typedef struct dm_drag_state {
    uint32_t struct_size;
    dm_pose pose;       /* pose of the part from rest, object frame; compose it with the carrier's own pose */
    dm_vec3 grab_point; /* place of the grabbed point now */
    float value;        /* joint value */
    float target;       /* joint value that the pointer asks for, before smoothing and inside the limits */
    float velocity;     /* d value / dt */
    int32_t at_limit;   /* -1 at lower, +1 at upper, 0 between */
    int32_t phase;      /* DM_DRAG_HELD … */
    /* How often the pull has changed the joint that the drag follows (dm_drag_get_part_state). The pose blends over to
     * a new joint within 0.6 s, the grabbed point mostly within 0.1 s. */
    uint32_t changes;
    uint32_t events; /* DM_EVENT_*; 0 without dm_drag_desc.rules */
    /* Detents or snap values that the part has passed to since the update before; a long update may pass several. 0
     * without dm_drag_desc.rules. */
    uint32_t detents;
    /* Speed with which it met a limit or was blocked, joint value a second; 0 without such an event, or without
     * dm_drag_desc.rules. */
    float impact;
    uint32_t status; /* DM_STATUS_*: what holds the part, and whether it is open; 0 without dm_drag_desc.rules */
    /* Probability that the joint in force is right, 0 to 1: the one number to show. A pull of one kind from one side
     * never makes it 1. */
    float joint_confidence;
    int32_t joint_basis; /* DM_BASIS_*: where the joint in force comes from */
    /* How far the part is open: 0 where it is closed (dm_joint.closed), 1 at the end farther from there, and linear in
     * the joint value between both. 0 for joints without limits. */
    float open_share;
} dm_drag_state;

/* Where the joint that a drag follows comes from. */
enum {
    DM_BASIS_PREPARED = 0, /* dm_object_prepare found it, and no pull has changed it */
    DM_BASIS_PULL = 1,     /* a pull of this drag, or of an earlier one of the same dm_part_state, has changed it */
    DM_BASIS_HOST = 2,     /* it is the host's own */
    DM_BASIS_CHOSEN = 3    /* the host has chosen it among the hypotheses */
};

/* What a released part does next. */
enum {
    DM_GO_AUTO = 0,   /* the library decides what the player meant, by where the part is and how fast it goes */
    DM_GO_STAY = 1,   /* it glides to a stop; this also stops a part that moves by itself */
    DM_GO_OPEN = 2,   /* it goes to the end of the joint that lies the way it was pulled */
    DM_GO_CLOSE = 3,  /* it goes to where it is closed (dm_joint.closed), which is rest unless it rests open */
    DM_GO_REPLAY = 4, /* it repeats what it did after the last release */
    DM_GO_FREEZE = 5, /* it stops at once */
    DM_GO_TOGGLE = 6  /* it opens when it is nearer to where it is closed than to its open end, else it closes */
};

/* The same values, by their names of version 0.2. */
enum {
    DM_INTENT_AUTO = DM_GO_AUTO,
    DM_INTENT_STAY = DM_GO_STAY,
    DM_INTENT_OPEN = DM_GO_OPEN,
    DM_INTENT_CLOSE = DM_GO_CLOSE,
    DM_INTENT_REPLAY = DM_GO_REPLAY,
    DM_INTENT_FREEZE = DM_GO_FREEZE,
    DM_INTENT_TOGGLE = DM_GO_TOGGLE
};

enum {
    /* A rule paces the release instead of the DQ-VAE, whose last bits differ between instruction sets. */
    DM_RELEASE_BY_RULE = 1,
    DM_RELEASE_AWAY_FROM = 2 /* a part that opens to both sides of rest opens away from `away_from` */
};

typedef struct dm_release_desc {
    uint32_t struct_size;
    int32_t intent;    /* DM_GO_* */
    float duration;    /* seconds from here to the end; 0 = the library takes it from the part's way and speed */
    uint32_t seed;     /* seed of the DQ-VAE, as dm_motion_desc.seed */
    uint32_t flags;    /* DM_RELEASE_* */
    dm_vec3 away_from; /* a place such as the player's, object frame, scaled with dm_drag_desc.scale */
} dm_release_desc;

typedef struct dm_release_plan {
    uint32_t struct_size;
    int32_t intent; /* what was decided: DM_GO_STAY, OPEN, CLOSE or FREEZE */
    float start_value, end_value;
    float duration;        /* seconds; 0 when the part is there already */
    uint32_t from_network; /* 1: the DQ-VAE paces it; 0: a rule does */
} dm_release_plan;

/* ---- camera and scene --------------------------------------------------------------------------------------- */

typedef struct dm_camera {
    uint32_t struct_size;
    float fov_y;         /* vertical angle of view, rad, below pi; 0 = orthographic with ortho_height */
    dm_vec3 eye;         /* host world frame */
    dm_vec3 forward, up; /* need not be unit or orthogonal, but must not be parallel */
    float viewport_width, viewport_height; /* pixels */
    float ortho_height;                    /* host units from bottom to top, for orthographic views only */
} dm_camera;

typedef struct dm_scene_desc {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
} dm_scene_desc;

typedef struct dm_hit {
    uint32_t struct_size;
    uint32_t instance; /* instance, as dm_scene_add returned it */
    dm_object object;  /* 0 = nothing was hit */
    uint32_t part_id;  /* 0 = the body */
    uint32_t triangle; /* index in the host's mesh */
    float distance;    /* host units from the ray's origin */
    float u, v;        /* barycentric weights of the triangle's second and third corners */
    dm_vec3 point;     /* host world frame */
    dm_vec3 normal;    /* unit geometric normal, by the triangle's winding; host world frame */
    /* The same point in the object's frame with the part as it is now, for dm_drag_desc.grab_point. */
    dm_vec3 object_point;
} dm_hit;

/* ---- defaults: struct_size set, the rest zeros ------------------------------------------------------------------- */

/* dm_NAME_default() returns the struct with struct_size set and zeros elsewhere, as in
 * dm_drag_desc desc = dm_drag_desc_default(). It is inline, so that struct_size is that of the caller's header. Callers
 * from other languages zero the struct and set struct_size to its size. [any-thread] */
#define DM_SIZED_STRUCTS(X)                                                                                            \
    X(dm_context_desc)                                                                                                 \
    X(dm_memory_info)                                                                                                  \
    X(dm_model_desc)                                                                                                   \
    X(dm_mesh_desc)                                                                                                    \
    X(dm_part_desc)                                                                                                    \
    X(dm_joint)                                                                                                        \
    X(dm_joint_frame)                                                                                                  \
    X(dm_part_state)                                                                                                   \
    X(dm_object_desc)                                                                                                  \
    X(dm_object_info)                                                                                                  \
    X(dm_part_info)                                                                                                    \
    X(dm_asset_node)                                                                                                   \
    X(dm_asset_desc)                                                                                                   \
    X(dm_asset_info)                                                                                                   \
    X(dm_asset_part)                                                                                                   \
    X(dm_motion_desc)                                                                                                  \
    X(dm_drag_rules)                                                                                                   \
    X(dm_drag_desc)                                                                                                    \
    X(dm_drag_input)                                                                                                   \
    X(dm_drag_state)                                                                                                   \
    X(dm_release_desc)                                                                                                 \
    X(dm_release_plan)                                                                                                 \
    X(dm_camera)                                                                                                       \
    X(dm_scene_desc)                                                                                                   \
    X(dm_hit)

#if defined(__cplusplus)
#define DM_ZEROS                                                                                                       \
    {}
#else
#define DM_ZEROS                                                                                                       \
    { 0 }
#endif
#define DM_DEFAULT(type)                                                                                               \
    static inline type type##_default(void) {                                                                          \
        type value = DM_ZEROS;                                                                                         \
        value.struct_size = (uint32_t)sizeof value;                                                                    \
        return value;                                                                                                  \
    }
DM_SIZED_STRUCTS(DM_DEFAULT)
#undef DM_DEFAULT
#undef DM_ZEROS

/* ---- functions: the library -------------------------------------------------------------------------------------- */

/* Returns the name of a result, such as "DM_ERROR_EMPTY_MASK", or "DM_ERROR_UNKNOWN" for a number that is not one. It
 * never returns NULL. [any-thread] */
DM_API const char* DM_CALL dm_result_string(dm_result result);

/* Returns the version of the library in use, as a number like DM_VERSION. [any-thread] */
DM_API uint32_t DM_CALL dm_version(void);

/* Returns the function table of an interface id, or NULL for an unknown one. "dm.core/1" gives a const dm_core_1*.
 * [any-thread] */
DM_API const void* DM_CALL dm_get_interface(const char* id);

/* ---- functions: context ------------------------------------------------------------------------------------------ */

/* Creates a context. desc NULL stands for all defaults. Errors: UNSUPPORTED when desc.picking asks for a picker that is
 * not there. [any-thread] */
DM_API dm_result DM_CALL dm_context_create(const dm_context_desc* desc, dm_context** out_context);

/* Destroys a context and everything made with it. NULL does nothing. [exclusive context] */
DM_API void DM_CALL dm_context_destroy(dm_context* context);

/* Writes how much memory a context holds. out_info->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_context_get_memory(const dm_context* context, dm_memory_info* out_info);

/* Returns the scratch memory that the context keeps for later calls (dm_memory_info.kept_bytes) to the host's
 * allocator, for instance when a level has loaded. [any-thread] */
DM_API dm_result DM_CALL dm_context_trim(dm_context* context);

/* ---- functions: weights ------------------------------------------------------------------------------------------ */

/* Loads weights. Errors: BAD_DATA, WRONG_MODEL, VERSION. [any-thread] */
DM_API dm_result DM_CALL dm_model_load(dm_context* context, const dm_model_desc* desc, dm_model* out_model);

/* Frees weights. Objects prepared with them keep their joints, and motions made with them stay; new motions and
 * refinements of such objects answer NO_MODEL. [exclusive object] */
DM_API dm_result DM_CALL dm_model_unload(dm_context* context, dm_model model);

/* ---- functions: objects and their joints ------------------------------------------------------------------------- */

/* Finds the part that a point of the surface belongs to, in a mesh whose parts are not known. Writes 1 to out_face_ids
 * for every triangle of the part and 0 for the others; as part ids per face they can go into a dm_mesh_desc unchanged.
 * The call takes up to tens of milliseconds, and a second for tens of thousands of loose pieces; its time grows at most
 * linearly with their number.
 * mesh->part_ids: pieces known to be rigid, such as the nodes of a scene; the grabbed one moves, together with what is
 * fastened to it alone. With NULL, or with one piece, the part is put together from the mesh's sheets of surface.
 * drag: the point where the part was grabbed, and the direction of the pull; a zero vector means no direction.
 * Errors: those of dm_object_prepare for a mesh; BUFFER_TOO_SMALL when face_count is less than the mesh's;
 * DRAG_OFF_PART; FULL_MASK when nothing is left that stays; CANCELLED. [any-thread] */
DM_API dm_result DM_CALL dm_mesh_find_part(dm_context* context, const dm_mesh_desc* mesh, const dm_drag_hint* drag,
                                           uint8_t* out_face_ids, uint64_t face_count);

/* Infers how each part of a mesh moves, and makes an object of it. The call takes up to tens of milliseconds for a
 * usual object (docs/performance.md) and uses dm_jobs. It warns once where the answer is worse than it could be
 * (DM_DEGRADED_*). Errors: NOT_FINITE, INDEX_OUT_OF_RANGE (also for an answer of desc.choose), EMPTY_MASK,
 * DEGENERATE_MESH, ZERO_DRAG, DRAG_OFF_PART, TOO_LARGE, CANCELLED. [any-thread] */
DM_API dm_result DM_CALL dm_object_prepare(dm_context* context, const dm_object_desc* desc, dm_object* out_object);

/* Writes a prepared object as .dmo bytes, which are versioned, checksummed and little-endian. Call it with a NULL
 * buffer to learn the size. out_size gets the bytes needed or written, also with BUFFER_TOO_SMALL. Triangles are stored
 * with trees of the library's own, so that loading builds none; where the object has other trees, each call builds the
 * library's. [exclusive object] */
DM_API dm_result DM_CALL dm_object_save(dm_context* context, dm_object object, void* buffer, size_t capacity,
                                        size_t* out_size);

/* Loads what dm_object_save has written, by this or any earlier version. model: the weights of its motions; may be 0.
 * The file's own trees are used where desc.picking of the context is DM_PICK_AUTO or DM_PICK_PORTABLE
 * (dm_object_info.picking). Errors: BAD_DATA, VERSION, CANCELLED. [any-thread] */
DM_API dm_result DM_CALL dm_object_load(dm_context* context, const void* data, size_t size, dm_model model,
                                        dm_object* out_object);

/* Destroys an object. Its drags and motions end with it, and its instances leave their scenes. [exclusive object, and
 * none of those in use] */
DM_API dm_result DM_CALL dm_object_destroy(dm_context* context, dm_object object);

/* Writes counts, box and size of an object. out_info->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_object_get_info(dm_context* context, dm_object object, dm_object_info* out_info);

/* Writes the part at a position, 0 to part_count - 1, in order of id. out_info->struct_size must be set.
 * [any-thread] */
DM_API dm_result DM_CALL dm_object_get_part(dm_context* context, dm_object object, uint32_t index,
                                            dm_part_info* out_info);

/* Writes the joint in force: the best hypothesis, or the host's own. out_joint->struct_size must be set.
 * [any-thread] */
DM_API dm_result DM_CALL dm_object_get_joint(dm_context* context, dm_object object, uint32_t part_id,
                                             dm_joint* out_joint);

/* Writes the hypotheses of a part, best first. When `drag` is given, it re-ranks them, which takes microseconds and no
 * network pass. capacity: up to DM_MAX_HYPOTHESES. out_joints[0].struct_size must be set, and the others get it.
 * out_count gets how many were written. [any-thread] */
DM_API dm_result DM_CALL dm_object_get_hypotheses(dm_context* context, dm_object object, uint32_t part_id,
                                                  const dm_drag_hint* drag, dm_joint* out_joints, uint32_t capacity,
                                                  uint32_t* out_count);

/* Infers the joint of one part again with the player's drag as evidence, and puts the result in force. It takes
 * milliseconds, so it is not for every frame. Errors: NO_MODEL; UNSUPPORTED when the object kept no triangles;
 * CANCELLED, which leaves the joint in force. [exclusive object] */
DM_API dm_result DM_CALL dm_object_refine(dm_context* context, dm_object object, uint32_t part_id,
                                          const dm_drag_hint* drag);

/* Puts the host's own joint in force. Its axis may have any length, and its limits may be infinite (dm_joint.lower).
 * Its source becomes DM_JOINT_FROM_HOST and both confidences 1, unless the joint is, bit for bit, the one in force or
 * the library's own answer; it then keeps the source and the confidences of that one. Drags and motions that already
 * run keep the joint they began with. [exclusive object] */
DM_API dm_result DM_CALL dm_object_set_joint(dm_context* context, dm_object object, uint32_t part_id,
                                             const dm_joint* joint);

/* Puts the library's own answer back in force, after dm_object_set_joint or a choice. [exclusive object] */
DM_API dm_result DM_CALL dm_object_reset_joint(dm_context* context, dm_object object, uint32_t part_id);

/* Replaces all links between parts of an object by copies of these. count: 0, which removes all, to DM_MAX_LINKS. A
 * saved object does not hold links. Errors: INVALID_ARGUMENT also when two drivers move one part, or a part moves
 * itself through other links; NOT_FOUND. [exclusive object] */
DM_API dm_result DM_CALL dm_object_set_links(dm_context* context, dm_object object, const dm_link* links,
                                             uint32_t count);

/* Moves everything that is linked with a part that has moved. inout_values: the joint values of one instance, one a
 * part, in the order of dm_object_get_part. The value of the moved part itself changes too when a driver of it is at
 * its limit; dm_drag_override takes that value. out_held: gets 1 for each part that links hold where it is
 * (DM_INPUT_LOCKED), else 0; may be NULL. count: the number of parts, which is the length of both. The limits are those
 * of the joints in force, for the unscaled instance. [frame] */
DM_API dm_result DM_CALL dm_object_follow_links(dm_context* context, dm_object object, uint32_t part_id,
                                                float* inout_values, uint8_t* out_held, uint32_t count);

/* ---- functions: assets ------------------------------------------------------------------------------------------- */

/* Infers which nodes of an asset move, which of them move as one, what carries what, and how each part moves. The same
 * nodes in the same order give the same bits. The call takes about as long as dm_object_prepare for all of its nodes,
 * and uses dm_jobs. It warns once where the answer is worse than it could be. Errors, whose messages name the node:
 * NOT_FINITE, INDEX_OUT_OF_RANGE, DEGENERATE_MESH, TOO_LARGE, CANCELLED; INVALID_ARGUMENT also when parents or
 * followers form a circle, a name is not UTF-8, or no node has a mesh. [any-thread] */
DM_API dm_result DM_CALL dm_asset_create(dm_context* context, const dm_asset_desc* desc, dm_asset* out_asset);

/* Destroys an asset. Objects made of it stay. [exclusive object] */
DM_API dm_result DM_CALL dm_asset_destroy(dm_context* context, dm_asset asset);

/* Writes counts and warnings of an asset. out_info->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_info(dm_context* context, dm_asset asset, dm_asset_info* out_info);

/* Writes the part at an index, 0 to part_count - 1. out_part->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_part(dm_context* context, dm_asset asset, uint32_t index,
                                           dm_asset_part* out_part);

/* Writes the joint of a part, in the asset frame. For a part that stays, it is the joint by which it would move.
 * out_joint->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_joint(dm_context* context, dm_asset asset, uint32_t index, dm_joint* out_joint);

/* Writes the indices of a part's nodes, rising: dm_asset_part.node_count of them. Errors: BUFFER_TOO_SMALL when
 * capacity is less. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_part_nodes(dm_context* context, dm_asset asset, uint32_t index,
                                                 uint32_t* out_nodes, uint32_t capacity);

/* Writes the index of the part of each node, or DM_ASSET_NO_PART for nodes of the body: dm_asset_info.node_count
 * numbers. Errors: BUFFER_TOO_SMALL when capacity is less. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_node_parts(dm_context* context, dm_asset asset, uint32_t* out_parts,
                                                 uint32_t capacity);

/* Makes a prepared object of the parts that move or are free. They carry each other as in the asset, and all else is
 * the body. The object has the triangles of the nodes that do not follow others, node after node. Errors: EMPTY_MASK
 * when nothing moves. [any-thread] */
DM_API dm_result DM_CALL dm_asset_make_object(dm_context* context, dm_asset asset, dm_object* out_object);

/* ---- functions: joints as values --------------------------------------------------------------------------------- */

/* Writes the pose of a joint at a value, from rest, in the frame in which the joint is given. The axis may have any
 * length, here and in the functions below. [frame] */
DM_API dm_result DM_CALL dm_joint_pose(const dm_joint* joint, float value, dm_pose* out_pose);

/* Inverts dm_joint_pose: writes the value at which the joint comes nearest to a pose. out_angle_error gets the angle
 * between both poses, rad. out_distance_error gets the distance between the places of the joint's origin under both,
 * host units. Both may be NULL. Of values one turn apart, the answer is the one inside the limits, or else the one
 * nearest to 0; for a screw, its advance decides. Errors: NOT_FINITE when an answer is beyond a float's range.
 * [frame] */
DM_API dm_result DM_CALL dm_joint_value(const dm_joint* joint, const dm_pose* pose, float* out_value,
                                        float* out_angle_error, float* out_distance_error);

/* Writes the joint value at a share of the way from rest to the open end, which is the limit farther from rest: 0 is
 * rest, 1 is open, 0.1 is ajar. Errors: INVALID_ARGUMENT for a joint without limits. [frame] */
DM_API dm_result DM_CALL dm_joint_value_at(const dm_joint* joint, float share, float* out_value);

/* Writes the joint as a constraint of a physics engine. out_frame->struct_size must be set. [frame] */
DM_API dm_result DM_CALL dm_joint_get_frame(const dm_joint* joint, dm_joint_frame* out_frame);

/* Converts a joint to the frame of an instance that is scaled by (x, y, z), as dm_drag_begin does. The axis is the line
 * through the scaled points. Limits of slides and the pitch are in scaled units; angles stay as they are. A zero counts
 * as 1. out_joint->struct_size must be set; it may be `joint`. [frame] */
DM_API dm_result DM_CALL dm_joint_scale(const dm_joint* joint, dm_vec3 scale, dm_joint* out_joint);

/* ---- functions: motions ------------------------------------------------------------------------------------------ */

/* Generates the DQ-VAE's motion for a drag, projected exactly onto the joint in force. The motion of a fixed part stays
 * at rest. Errors: NO_MODEL, ZERO_DRAG, DRAG_OFF_PART. [any-thread] */
DM_API dm_result DM_CALL dm_motion_generate(dm_context* context, dm_object object, const dm_motion_desc* desc,
                                            dm_motion* out_motion);

/* Writes pose and joint value of a motion at t, which is clamped to [0, 1]; 0 is rest. Between key poses the part
 * follows the joint's own screw. out_value may be NULL. [frame] */
DM_API dm_result DM_CALL dm_motion_sample(dm_context* context, dm_motion motion, float t, dm_pose* out_pose,
                                          float* out_value);

/* Writes the DM_MOTION_FRAMES key poses and their joint values. out_values may be NULL. [frame] */
DM_API dm_result DM_CALL dm_motion_get_frames(dm_context* context, dm_motion motion, dm_pose* out_poses,
                                              float* out_values);

/* Destroys a motion that no other thread samples. [any-thread] */
DM_API dm_result DM_CALL dm_motion_destroy(dm_context* context, dm_motion motion);

/* ---- functions: drags -------------------------------------------------------------------------------------------- */

/* Starts a drag: the player grabs a part. Where the library found the joint, the pull is more evidence. The drag holds
 * the part's other hypotheses and likely joints beyond them, and follows the one that explains the pull best. Limits
 * that were estimated give when the pull goes on beyond them. docs/feel.md describes how. The call warns of a grab
 * point or value in other units than expected (millimetres, degrees). [any-thread] */
DM_API dm_result DM_CALL dm_drag_begin(dm_context* context, const dm_drag_desc* desc, dm_drag* out_drag);

/* Advances a drag by dt seconds. The grabbed point follows the pointer's ray (object frame, scaled with
 * dm_drag_desc.scale) as closely as the joint allows. Pass the ray that grabbed the part first. The whole drag keeps
 * the angle by which this ray misses the grab point, up to 0.032 rad, so that the part does not move before the pointer
 * does. A dt from -1e-4 to 0, as clocks round it, counts as 0. After dm_drag_release the part moves by itself, and ray
 * may be NULL. out_state->struct_size must be set. [frame] */
DM_API dm_result DM_CALL dm_drag_update(dm_context* context, dm_drag drag, const dm_ray* ray, float dt,
                                        dm_drag_state* out_state);

/* Does what dm_drag_update does, with everything that a dm_drag_input holds. A released part needs no hand. Errors:
 * INVALID_ARGUMENT, also for handles, bounds and DM_INPUT_LOCKED of a drag without dm_drag_desc.rules. [frame] */
DM_API dm_result DM_CALL dm_drag_step(dm_context* context, dm_drag drag, const dm_drag_input* input, float dt,
                                      dm_drag_state* out_state);
/* dm_drag_update_input is the name of dm_drag_step for new code. dm_core_1 and the exports have dm_drag_step. */
#define dm_drag_update_input dm_drag_step

/* Replaces the value that an update with DM_INPUT_ASK has proposed in its out_state. The value is brought inside the
 * limits and bounds of that update, and the events become those of the value taken. Without this call, the update
 * stands. Errors: INVALID_ARGUMENT when the last update did not ask. [frame] */
DM_API dm_result DM_CALL dm_drag_take(dm_context* context, dm_drag drag, float value, dm_drag_state* out_state);
/* dm_drag_override is the name of dm_drag_take for new code. dm_core_1 and the exports have dm_drag_take. */
#define dm_drag_override dm_drag_take

/* Releases the part, which then does what the player meant: it swings open, falls shut, springs back or stays. The
 * DQ-VAE paces it where the object has its weights, unless desc.flags forbids it. dm_drag_update moves it, and
 * dm_drag_end may end the drag at any time; another release replaces this one, or replays. desc NULL stands for all
 * defaults. out_plan may be NULL, else its struct_size must be set. The call takes up to a millisecond. One caller at a
 * time per drag. [any-thread] */
DM_API dm_result DM_CALL dm_drag_release(dm_context* context, dm_drag drag, const dm_release_desc* desc,
                                         dm_release_plan* out_plan);

/* Ends a drag and destroys it. out_state gets what dm_drag_get_part_state gives; it may be NULL, else its struct_size
 * must be set. [any-thread] */
DM_API dm_result DM_CALL dm_drag_end(dm_context* context, dm_drag drag, dm_part_state* out_state);

/* Writes where the part stands, and the joint that the drag follows now, with the limits and the confidence that the
 * pull has left it. A drag that begins with this state as dm_drag_desc.state goes on where this one is.
 * out_state->struct_size must be set. [frame] */
DM_API dm_result DM_CALL dm_drag_get_part_state(dm_context* context, dm_drag drag, dm_part_state* out_state);

/* Returns how many bytes dm_drag_save writes. The number is the same for every drag of this library, and
 * DM_DRAG_SNAPSHOT_MAX at most. [any-thread] */
DM_API size_t DM_CALL dm_drag_snapshot_size(void);

/* Writes the whole state of a drag, for rollback. After dm_drag_restore, the same calls give the same bits. Only this
 * very version of the library on this kind of machine can read it; dm_part_state is what lasts. Errors:
 * BUFFER_TOO_SMALL when capacity is less than dm_drag_snapshot_size. [frame] */
DM_API dm_result DM_CALL dm_drag_save(dm_context* context, dm_drag drag, void* buffer, size_t capacity);

/* Restores a state that dm_drag_save has written, of this or any other drag of the same part. An error leaves the drag
 * as it is: BAD_DATA, VERSION, or INVALID_ARGUMENT when the state belongs to another part. [frame] */
DM_API dm_result DM_CALL dm_drag_restore(dm_context* context, dm_drag drag, const void* data, size_t size);

/* ---- functions: poses -------------------------------------------------------------------------------------------- */

/* Writes the pose that applies b first and then a: x -> a(b(x)). out_pose may be `a` or `b`. [frame] */
DM_API void DM_CALL dm_pose_multiply(const dm_pose* a, const dm_pose* b, dm_pose* out_pose);

/* Writes the inverse of a pose, which takes the points that the pose has moved back. out_pose may be `pose`. [frame] */
DM_API void DM_CALL dm_pose_inverse(const dm_pose* pose, dm_pose* out_pose);

/* Writes the pose that rotates first and then translates, as engines keep the place of a node. rotation: a quaternion
 * x, y, z, w of any length. Errors: INVALID_ARGUMENT when it has no length; NOT_FINITE. [frame] */
DM_API dm_result DM_CALL dm_pose_from_rotation(const float rotation[4], dm_vec3 translation, dm_pose* out_pose);

/* Writes a pose as a 4x4 matrix, column-major for column vectors (the memory order of OpenGL, glTF and Unity's
 * Matrix4x4). [frame] */
DM_API void DM_CALL dm_pose_to_matrix(const dm_pose* pose, float out_matrix[16]);

/* Moves `count` float32 points by a pose. Strides are in bytes, and 0 means packed. src may equal dst. [frame] */
DM_API void DM_CALL dm_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst,
                                         size_t dst_stride, size_t count);

/* ---- functions: camera and scene --------------------------------------------------------------------------------- */

/* Writes the ray through pixel (x, y) in the host's world frame; (0, 0) is the top left corner of the viewport. Its
 * direction is a unit vector. Errors: INVALID_ARGUMENT when the camera has no view; NOT_FINITE when the ray's origin is
 * beyond a float's range. [frame] */
DM_API dm_result DM_CALL dm_camera_ray(const dm_context* context, const dm_camera* camera, float x, float y,
                                       dm_ray* out_ray);

/* Creates an empty scene. Errors: UNSUPPORTED when the context picks nothing (DM_PICK_NONE, or no picker was found).
 * [any-thread] */
DM_API dm_result DM_CALL dm_scene_create(dm_context* context, const dm_scene_desc* desc, dm_scene* out_scene);

/* Destroys a scene with its instances. Their objects stay. [exclusive object] */
DM_API dm_result DM_CALL dm_scene_destroy(dm_context* context, dm_scene scene);

/* Places a prepared object in a scene, from the next dm_scene_commit on. placement: pose from the object frame to the
 * world; NULL = identity. out_instance gets a small number from 0 on, which may be used again after a removal. Errors:
 * UNSUPPORTED when the object cannot be picked, because it kept no triangles, or is smaller than 1e-6 or larger than
 * 1e12 host units. [exclusive object] */
DM_API dm_result DM_CALL dm_scene_add(dm_context* context, dm_scene scene, dm_object object, const dm_pose* placement,
                                      uint32_t* out_instance);

/* Moves a part of an instance to a pose from rest, in the object frame, which includes the pose of the parts that carry
 * it. With part_id 0 it moves the whole instance to a new placement. The move takes effect with dm_scene_commit.
 * [frame] */
DM_API dm_result DM_CALL dm_scene_move(dm_context* context, dm_scene scene, uint32_t instance, uint32_t part_id,
                                       const dm_pose* pose);

/* Removes an instance from a scene, at once. [exclusive object] */
DM_API dm_result DM_CALL dm_scene_remove(dm_context* context, dm_scene scene, uint32_t instance);

/* Makes all moves since the last commit visible to picks. Call it once a frame, after the moves. [frame] */
DM_API dm_result DM_CALL dm_scene_commit(dm_context* context, dm_scene scene);

/* Finds the nearest hit of a ray. The answer is DM_OK with out_hit->object 0 when nothing is hit. Several threads may
 * pick at once while none moves or commits. out_hit->struct_size must be set. [frame] */
DM_API dm_result DM_CALL dm_scene_pick(dm_context* context, dm_scene scene, const dm_ray* ray, dm_hit* out_hit);

/* ---- the same functions as a table ---------------------------------------------------------------------------
 * NEVER REARRANGE: the order is the binary interface "dm.core/1". New functions go to the end. */

#define DM_CORE_FUNCTIONS(X)                                                                                           \
    X(const char*, result_string, (dm_result result))                                                                  \
    X(uint32_t, version, (void))                                                                                       \
    X(dm_result, context_create, (const dm_context_desc* desc, dm_context** out_context))                              \
    X(void, context_destroy, (dm_context * context))                                                                   \
    X(dm_result, context_get_memory, (const dm_context* context, dm_memory_info* out_info))                            \
    X(dm_result, model_load, (dm_context * context, const dm_model_desc* desc, dm_model* out_model))                   \
    X(dm_result, model_unload, (dm_context * context, dm_model model))                                                 \
    X(dm_result, mesh_find_part,                                                                                       \
      (dm_context * context, const dm_mesh_desc* mesh, const dm_drag_hint* drag, uint8_t* out_face_ids,                \
       uint64_t face_count))                                                                                           \
    X(dm_result, object_prepare, (dm_context * context, const dm_object_desc* desc, dm_object* out_object))            \
    X(dm_result, object_save,                                                                                          \
      (dm_context * context, dm_object object, void* buffer, size_t capacity, size_t* out_size))                       \
    X(dm_result, object_load,                                                                                          \
      (dm_context * context, const void* data, size_t size, dm_model model, dm_object* out_object))                    \
    X(dm_result, object_destroy, (dm_context * context, dm_object object))                                             \
    X(dm_result, object_get_info, (dm_context * context, dm_object object, dm_object_info * out_info))                 \
    X(dm_result, object_get_part, (dm_context * context, dm_object object, uint32_t index, dm_part_info * out_info))   \
    X(dm_result, object_get_joint, (dm_context * context, dm_object object, uint32_t part_id, dm_joint * out_joint))   \
    X(dm_result, object_get_hypotheses,                                                                                \
      (dm_context * context, dm_object object, uint32_t part_id, const dm_drag_hint* drag, dm_joint* out_joints,       \
       uint32_t capacity, uint32_t* out_count))                                                                        \
    X(dm_result, object_refine, (dm_context * context, dm_object object, uint32_t part_id, const dm_drag_hint* drag))  \
    X(dm_result, object_set_joint, (dm_context * context, dm_object object, uint32_t part_id, const dm_joint* joint))  \
    X(dm_result, object_reset_joint, (dm_context * context, dm_object object, uint32_t part_id))                       \
    X(dm_result, joint_pose, (const dm_joint* joint, float value, dm_pose* out_pose))                                  \
    X(dm_result, joint_value,                                                                                          \
      (const dm_joint* joint, const dm_pose* pose, float* out_value, float* out_angle_error,                           \
       float* out_distance_error))                                                                                     \
    X(dm_result, joint_get_frame, (const dm_joint* joint, dm_joint_frame* out_frame))                                  \
    X(dm_result, joint_scale, (const dm_joint* joint, dm_vec3 scale, dm_joint* out_joint))                             \
    X(dm_result, motion_generate,                                                                                      \
      (dm_context * context, dm_object object, const dm_motion_desc* desc, dm_motion* out_motion))                     \
    X(dm_result, motion_sample,                                                                                        \
      (dm_context * context, dm_motion motion, float t, dm_pose* out_pose, float* out_value))                          \
    X(dm_result, motion_get_frames, (dm_context * context, dm_motion motion, dm_pose * out_poses, float* out_values))  \
    X(dm_result, motion_destroy, (dm_context * context, dm_motion motion))                                             \
    X(dm_result, drag_begin, (dm_context * context, const dm_drag_desc* desc, dm_drag* out_drag))                      \
    X(dm_result, drag_update,                                                                                          \
      (dm_context * context, dm_drag drag, const dm_ray* ray, float dt, dm_drag_state* out_state))                     \
    X(dm_result, drag_release,                                                                                         \
      (dm_context * context, dm_drag drag, const dm_release_desc* desc, dm_release_plan* out_plan))                    \
    X(dm_result, drag_end, (dm_context * context, dm_drag drag, dm_part_state * out_state))                            \
    X(dm_result, drag_get_part_state, (dm_context * context, dm_drag drag, dm_part_state * out_state))                 \
    X(size_t, drag_snapshot_size, (void))                                                                              \
    X(dm_result, drag_save, (dm_context * context, dm_drag drag, void* buffer, size_t capacity))                       \
    X(dm_result, drag_restore, (dm_context * context, dm_drag drag, const void* data, size_t size))                    \
    X(void, pose_multiply, (const dm_pose* a, const dm_pose* b, dm_pose* out_pose))                                    \
    X(void, pose_to_matrix, (const dm_pose* pose, float out_matrix[16]))                                               \
    X(void, pose_apply_points,                                                                                         \
      (const dm_pose* pose, const float* src, size_t src_stride, float* dst, size_t dst_stride, size_t count))         \
    X(dm_result, camera_ray, (const dm_context* context, const dm_camera* camera, float x, float y, dm_ray* out_ray))  \
    X(dm_result, scene_create, (dm_context * context, const dm_scene_desc* desc, dm_scene* out_scene))                 \
    X(dm_result, scene_destroy, (dm_context * context, dm_scene scene))                                                \
    X(dm_result, scene_add,                                                                                            \
      (dm_context * context, dm_scene scene, dm_object object, const dm_pose* placement, uint32_t* out_instance))      \
    X(dm_result, scene_move,                                                                                           \
      (dm_context * context, dm_scene scene, uint32_t instance, uint32_t part_id, const dm_pose* pose))                \
    X(dm_result, scene_remove, (dm_context * context, dm_scene scene, uint32_t instance))                              \
    X(dm_result, scene_commit, (dm_context * context, dm_scene scene))                                                 \
    X(dm_result, scene_pick, (dm_context * context, dm_scene scene, const dm_ray* ray, dm_hit* out_hit))               \
    X(dm_result, drag_step,                                                                                            \
      (dm_context * context, dm_drag drag, const dm_drag_input* input, float dt, dm_drag_state* out_state))            \
    X(dm_result, drag_take, (dm_context * context, dm_drag drag, float value, dm_drag_state* out_state))               \
    X(dm_result, object_set_links, (dm_context * context, dm_object object, const dm_link* links, uint32_t count))     \
    X(dm_result, object_follow_links,                                                                                  \
      (dm_context * context, dm_object object, uint32_t part_id, float* inout_values, uint8_t* out_held,               \
       uint32_t count))                                                                                                \
    X(dm_result, joint_value_at, (const dm_joint* joint, float share, float* out_value))                               \
    X(void, pose_inverse, (const dm_pose* pose, dm_pose* out_pose))                                                    \
    X(dm_result, pose_from_rotation, (const float rotation[4], dm_vec3 translation, dm_pose* out_pose))                \
    X(dm_result, asset_create, (dm_context * context, const dm_asset_desc* desc, dm_asset* out_asset))                 \
    X(dm_result, asset_destroy, (dm_context * context, dm_asset asset))                                                \
    X(dm_result, asset_get_info, (dm_context * context, dm_asset asset, dm_asset_info * out_info))                     \
    X(dm_result, asset_get_part, (dm_context * context, dm_asset asset, uint32_t index, dm_asset_part * out_part))     \
    X(dm_result, asset_get_joint, (dm_context * context, dm_asset asset, uint32_t index, dm_joint * out_joint))        \
    X(dm_result, asset_get_part_nodes,                                                                                 \
      (dm_context * context, dm_asset asset, uint32_t index, uint32_t * out_nodes, uint32_t capacity))                 \
    X(dm_result, asset_get_node_parts,                                                                                 \
      (dm_context * context, dm_asset asset, uint32_t * out_parts, uint32_t capacity))                                 \
    X(dm_result, asset_make_object, (dm_context * context, dm_asset asset, dm_object * out_object))                    \
    X(dm_result, context_trim, (dm_context * context))

/* NOLINTNEXTLINE(bugprone-macro-parentheses): the parts of a declaration take none */
#define DM_TABLE_ENTRY(result, name, arguments) result(DM_CALL* name) arguments;
typedef struct dm_core_1 {
    uint32_t struct_size; /* size of this table in the library in use; check it before you call a newer entry */
    uint32_t reserved;
    DM_CORE_FUNCTIONS(DM_TABLE_ENTRY)
} dm_core_1;
#undef DM_TABLE_ENTRY

#ifdef __cplusplus
}
#endif

#endif
