/* dragmesh: makes any 3D object openable. The whole public surface.
 *
 * One time, per object:   mesh + part ids --prepare--> joints (type, axis, origin, limits)
 * Every frame:            pointer ray --pick--> grabbed point --drag--> joint value --> rigid pose
 *
 * Conventions that hold for every function:
 *  - Frames and units are the HOST's, as stated in dm_context_desc (axes preset, unit). Angles are radians.
 *  - Places, lengths, joint values and pitches beyond 1e9 host units or rad, and numbers beyond 4e9 in the dual part of
 *    a pose, answer INVALID_ARGUMENT where a drag, a pose or a pick would compute with them; factors of a scale are
 *    1e-6 to 1e6. Finite input gives finite output; the functions that return nothing (dm_pose_multiply, _inverse,
 *    _to_matrix, _apply_points) promise it for numbers within these bounds.
 *  - Functions return DM_OK (0) or a negative dm_result. On an error the outputs are untouched, a message that
 *    names the field and the value goes to the log callback, but for [frame] functions, and the context stays usable.
 *    Nothing aborts.
 *    Any function may answer INVALID_ARGUMENT, STRUCT_SIZE, STALE_HANDLE and NOT_FINITE, one that names a part or an
 *    instance NOT_FOUND, and one that makes something OUT_OF_MEMORY; each says what else it may answer.
 *  - Every descriptor, and every output that may grow, starts with struct_size = sizeof(the struct); the caller
 *    sets it, or starts from dm_NAME_default(). A zero in any other field means its default, for ever. A caller that
 *    is newer than the library may only send zeros in the part the library can't know, and gets zeros there in
 *    outputs. Elements of an array all have the struct_size of the first.
 *  - From version 0.2 on this interface, "dm.core/1", only grows: functions at the end of the table, fields at the end
 *    of structs that start with struct_size, constants, bits. Structs without struct_size never change. Error codes,
 *    bits of events and of status may be added: take an unknown negative result as an error, and leave out unknown
 *    bits. Answers are no part of this, they get better. docs/integration.md, "Versions".
 *  - Handles are opaque 64-bit ids: 8 bits of kind, 32 of generation, 24 of index. 0 is null. A handle to something
 *    destroyed answers DM_ERROR_STALE_HANDLE, and so does one of another context. A context gives no handle twice, and
 *    has room for 16,777,152 of each kind at a time (TOO_LARGE beyond).
 *  - Memory the host passes in is borrowed for the call alone, never kept, never written unless it is an output.
 *  - Callbacks (allocator, log, jobs, intent, choose, progress) may call functions that take no context
 *    (dm_result_string, dm_joint_*, dm_pose_*) and anything of OTHER contexts, nothing of the context that calls them.
 *    They return normally: no C++ exception and no longjmp may pass through the library. What the interrupted call held
 *    would be lost, and a lock would stay locked.
 *  - Determinism: one build of the library with one C library gives the same bits for the same calls on every x86-64
 *    processor, drags of a loaded .dmo included: begin, update, and a release with DM_RELEASE_BY_RULE. Two things may
 *    differ in their last bits between instruction sets: what runs a network (prepare, refine, motions, other
 *    releases), and a drag with feel.coast_time above 0 in the hand, which needs double-precision exp, sin and cos.
 *  - The floating-point environment of the calling thread (rounding, flushed denormals, trapped exceptions) and the
 *    locale change nothing. It is put aside during each call and task, and given back at its end; callbacks run in the
 *    library's. This holds on x86-64 and 64-bit Arm for builds by gcc or clang.
 *  - Stack: a call needs less than 128 KB, a task of dm_jobs less than 64 KB.
 *  - Contexts: as many as memory holds; 1,100 are tested. With DM_PICK_EMBREE some 990 a process, then UNSUPPORTED.
 *  - Threading tags:
 *      [any-thread]        callable at any time from any thread.
 *      [exclusive context] no other call on this context at the same time.
 *      [exclusive object]  no other call on the same object (or scene, or model) at the same time; calls on
 *                          different ones may run side by side.
 *      [frame]             as [any-thread], one caller at a time per drag, motion or scene; never allocates,
 *                          locks or logs, whatever its input: its result is all that it says. What the updates of a
 *                          drag refused is told once, as a warning, by dm_drag_release and dm_drag_end.
 */
#ifndef DRAGMESH_H
#define DRAGMESH_H

#include <stddef.h>
#include <stdint.h>

/* DM_BUILDING: defined while the library itself is built, which exports; DM_STATIC: by hosts on Windows that link it
 * statically. */
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
#define DM_VERSION_MINOR 3
#define DM_VERSION_PATCH 0
/* 1 while the version that the three numbers name is in development, 0 in its release. */
#define DM_VERSION_DEVELOPMENT 1
/* One number that rises with the version; dm_version tells that of the library in use. It is even in a release, whose
 * patch number is even, and odd in development: one less than in the release to come. So 0.3.0 in development lies
 * above every release before it and below 0.3.0; its bits read 0.2.4095, which is never released. */
#define DM_VERSION (((DM_VERSION_MAJOR << 22) | (DM_VERSION_MINOR << 12) | DM_VERSION_PATCH) - DM_VERSION_DEVELOPMENT)

/* Number of key poses of a generated motion (paper: T). */
#define DM_MOTION_FRAMES 16
/* Most hypotheses kept for one part. */
#define DM_MAX_HYPOTHESES 8
/* Most parts of one object, the body not counted. */
#define DM_MAX_PARTS 4096
/* Most nodes of one asset. At most DM_MAX_PARTS of them have meshes that are no DM_ASSET_NODE_FOLLOWS. */
#define DM_MAX_ASSET_NODES 65536
/* Most bytes of a label, the zero not counted. */
#define DM_MAX_LABEL 4096
/* Most vertices or triangles of one object. */
#define DM_MAX_ELEMENTS 268435456
/* Most links of one object. */
#define DM_MAX_LINKS 256
/* Most snap values of one drag. */
#define DM_MAX_SNAPS 16
/* No library of the interface dm.core/1 needs more bytes for a dm_drag_save; it says how many by
 * dm_drag_snapshot_size. */
#define DM_DRAG_SNAPSHOT_MAX 65536

/* ---- results ------------------------------------------------------------------------------------------------ */

typedef int32_t dm_result;
enum {
    DM_OK = 0,
    DM_ERROR_INVALID_ARGUMENT = -1,   /* a null pointer, an unknown enum value, a count that makes no sense */
    DM_ERROR_STRUCT_SIZE = -2,        /* struct_size too small, or a newer field is set that this library can't know */
    DM_ERROR_STALE_HANDLE = -3,       /* null, destroyed, or of another kind or context */
    DM_ERROR_OUT_OF_MEMORY = -4,      /* the host's allocator answered NULL */
    DM_ERROR_NOT_FINITE = -5,         /* a NaN or infinite number in the input */
    DM_ERROR_INDEX_OUT_OF_RANGE = -6, /* an index names a vertex or a hypothesis that does not exist */
    DM_ERROR_EMPTY_MASK = -7,         /* no triangle belongs to the part */
    DM_ERROR_FULL_MASK = -8,          /* the mask, or the part found, is the whole mesh: it tells nothing apart */
    DM_ERROR_DEGENERATE_MESH = -9,    /* no triangle with an area, or all vertices in one point */
    DM_ERROR_ZERO_DRAG = -10,         /* the drag vector has no length */
    DM_ERROR_DRAG_OFF_PART = -11,     /* the drag point is farther from the part than half the object's size */
    DM_ERROR_BAD_DATA = -12,          /* truncated, corrupt or hostile bytes */
    DM_ERROR_WRONG_MODEL = -13,       /* readable weights, but not of the architecture asked for */
    DM_ERROR_VERSION = -14,           /* made by a newer version than this library can read */
    DM_ERROR_CANCELLED = -15,         /* the progress callback asked to stop */
    DM_ERROR_NO_MODEL = -16,          /* the call needs weights and none were given */
    DM_ERROR_TOO_LARGE = -17,         /* more than DM_MAX_ELEMENTS or DM_MAX_PARTS */
    DM_ERROR_BUFFER_TOO_SMALL = -18,  /* the output buffer can't hold the answer; the size needed is set */
    DM_ERROR_NOT_FOUND = -19,         /* no such part, node or instance */
    DM_ERROR_UNSUPPORTED = -20,       /* valid, but this build or this file kind can't do it */
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

/* direction need not be unit; distances along the ray are in host units, not in multiples of it. */
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

/* Hooks: see "Callbacks" above.
 *
 * Host memory. allocate returns memory aligned to `alignment` (a power of two, 64 at most) or NULL; release gets the
 * size that was asked for. Both may be called from any thread the host calls the library on. */
typedef struct dm_allocator {
    void* user;
    void*(DM_CALL* allocate)(void* user, size_t size, size_t alignment);
    void(DM_CALL* release)(void* user, void* memory, size_t size);
} dm_allocator;

enum { DM_LOG_ERROR = 0, DM_LOG_WARNING = 1, DM_LOG_INFO = 2 };

/* Messages for people, on the threads that the host calls the library on. level: DM_LOG_*. code: of an error, else
 * DM_OK. `text` is UTF-8, valid during the call. */
typedef struct dm_log {
    void* user;
    void(DM_CALL* message)(void* user, int32_t level, dm_result code, const char* text);
} dm_log;

typedef void(DM_CALL* dm_task)(void* data, uint32_t index);

/* The host's job system. parallel_for runs task(data, i) once for every i in [0, count) and returns non-zero when all
 * are done, or returns 0 without having run any (the library then runs them inline). A task that was left out, made up
 * or run twice ends the call with INVALID_ARGUMENT; its second run does nothing. The library starts no thread. */
typedef struct dm_jobs {
    void* user;
    int32_t(DM_CALL* parallel_for)(void* user, uint32_t count, dm_task task, void* data);
} dm_jobs;

/* How far a call is: 0..1, rising; return non-zero to cancel it: it answers DM_ERROR_CANCELLED. Called on the thread
 * that calls the library, whatever jobs run beside it. */
typedef int32_t(DM_CALL* dm_progress_callback)(void* user, float done);

/* The host's axes. Canonical inside is glTF's: right-handed, +Y up, metres. */
enum {
    DM_AXES_GLTF = 0,    /* right-handed, +Y up (glTF, Godot, OpenGL) */
    DM_AXES_UNITY = 1,   /* left-handed, +Y up, +Z forward */
    DM_AXES_UNREAL = 2,  /* left-handed, +Z up, +X forward */
    DM_AXES_BLENDER = 3, /* right-handed, +Z up (Blender, ROS, most CAD) */
    DM_AXES_CUSTOM = 4   /* dm_context_desc.custom_axes */
};

/* What picks rays. The hits are the same, except within float rounding of an edge or of another surface. */
enum {
    DM_PICK_AUTO = 0,     /* Embree 3.13 or 4 where its shared library is found, else the library's own */
    DM_PICK_EMBREE = 1,   /* Embree alone */
    DM_PICK_PORTABLE = 2, /* the library's own: everywhere, in the host's memory */
    DM_PICK_NONE = 3      /* nothing, for hosts that cast their own rays: objects keep no trees, there are no scenes */
};

typedef struct dm_context_desc {
    uint32_t struct_size;
    int32_t axes;           /* DM_AXES_*; 0 = glTF */
    float unit_in_metres;   /* length of one host unit; 0 = 1. Unreal: 0.01 */
    float custom_axes[9];   /* for DM_AXES_CUSTOM: row-major matrix that takes a host vector to the canonical frame;
                               orthogonal, determinant +1 or -1 */
    dm_allocator allocator; /* zeros = malloc/free */
    dm_log log;             /* zeros = silent */
    dm_jobs jobs;           /* zeros = inline */
    int32_t picking;        /* DM_PICK_*; 0 = auto */
    uint32_t reserved;      /* 0 */
    dm_progress_callback progress; /* of the calls that take long where the mesh is large: dm_mesh_find_part,
                                      dm_object_prepare without a callback of its own, dm_object_load,
                                      dm_object_refine. NULL = none. May be called from several threads at once */
    void* progress_user;
    uint64_t kept_bytes; /* most scratch memory that stays with the context from call to call; 0 = 32 MB, 1 = none.
                            dm_context_trim gives it back */
} dm_context_desc;

typedef struct dm_memory_info {
    uint32_t struct_size;
    uint32_t reserved;    /* 0 */
    uint64_t bytes;       /* held now through the context's allocator */
    uint64_t peak_bytes;  /* most ever held */
    uint64_t allocations; /* calls of allocate so far */
    uint64_t pick_bytes;  /* held now by Embree, which reports sizes but has its own allocator */
    uint64_t kept_bytes;  /* of `bytes`: in no use now, kept for later calls (dm_context_desc.kept_bytes) */
} dm_memory_info;

/* ---- weights ------------------------------------------------------------------------------------------------ */

/* Bytes of safetensors files; each may be absent (NULL, 0). They are copied and repacked: free them after the call. */
typedef struct dm_model_desc {
    uint32_t struct_size;
    const void* kinematics; /* KPP-Net: sdk/models/kpp_net.safetensors */
    size_t kinematics_size;
    const void* motion; /* DQ-VAE: sdk/models/dq_vae.safetensors */
    size_t motion_size;
    const void* ranker; /* chooses between candidate joints: sdk/models/ranker.safetensors; absent: by rules */
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

enum { DM_FLOAT32 = 0, DM_FLOAT64 = 1 };                           /* positions: three each */
enum { DM_UINT32 = 0, DM_UINT16 = 1, DM_UINT8 = 2, DM_INT32 = 3 }; /* indices and part ids */
enum { DM_PER_VERTEX = 0, DM_PER_FACE = 1 };

/* The host's mesh, read in place. Triangles. The sizes of the buffers guard against a forgotten format, scope or
 * stride: one that does not hold what counts, formats and strides say is refused, and nothing is read past its end. */
typedef struct dm_mesh_desc {
    uint32_t struct_size;
    uint32_t position_stride; /* bytes between vertices; 0 = packed */
    const void* positions;    /* vertex_count x 3 */
    uint64_t vertex_count;
    uint64_t position_bytes; /* of the buffer from `positions` on; 0 = not stated, and not checked */
    const void* indices;     /* index_count, a multiple of 3; NULL = vertices in order, three a triangle */
    uint64_t index_count;
    uint64_t index_bytes;    /* of the buffer; 0 = not stated, and not checked */
    const void* part_ids;    /* which part a vertex or a face belongs to: 0 = the body that stays, 1.. = parts. Ids that
                                dm_object_desc.parts does not list are the body's. Per vertex, a triangle belongs to
                                the id that two of its corners share (else the smallest). Where everything is of a
                                part, as of a door leaf alone, there is no body, and joints are less sure */
    uint64_t part_id_bytes;  /* of the buffer from `part_ids` on; required with part_ids. It must be that of one id a
                                vertex or a face, as part_id_scope says, neither less nor more */
    uint32_t part_id_stride; /* bytes; 0 = packed */
    int32_t position_format; /* DM_FLOAT32 | DM_FLOAT64 */
    int32_t index_format;    /* DM_UINT32 | DM_UINT16 | DM_UINT8 */
    int32_t part_id_format;  /* DM_UINT32 | DM_UINT16 | DM_UINT8 | DM_INT32 (negative = body) */
    int32_t part_id_scope;   /* DM_PER_VERTEX | DM_PER_FACE */
    uint32_t reserved;       /* 0 */
} dm_mesh_desc;

/* A drag as evidence of how a part moves: a point on it and the direction it was pulled, as a hand drew it. */
typedef struct dm_drag_hint {
    dm_vec3 point;  /* on or near the part, host object frame */
    dm_vec3 vector; /* non-zero; its length is how far it was pulled */
} dm_drag_hint;

/* Where an asset has the node or bone that moves a part, at rest. Evidence: an artist may have put it on the hinge, or
 * left it in the middle or at the file's origin. Leave it out, or say DM_PIVOT_DEFAULT, where all nodes of an asset,
 * the body's too, have theirs by one rule: at one point, or at the same place of their boxes. A program has put them
 * there, and an edge that happens to lie there would be taken for a hinge. */
typedef struct dm_pivot {
    dm_vec3 origin; /* host object frame */
    float axes[9];  /* the node's own x, y and z axis, three numbers each, host object frame; of any length, also
                       mirrored. Zeros: unknown */
} dm_pivot;

typedef struct dm_part_desc {
    uint32_t struct_size;
    uint32_t id;              /* as in part_ids; 1.. */
    uint32_t parent;          /* id of the part that carries this one; 0 = the body. A part moves with its parent */
    int32_t joint_type;       /* DM_JOINT_*; 0 = to be found out */
    const dm_drag_hint* drag; /* optional evidence */
    const char* label;     /* optional evidence: names that the asset has for the part, UTF-8, outermost first, joined
                              by '/': file, parents, node, mesh. Names in any language that tell what it is (door, lid,
                              Hebel) count, others don't. At most DM_MAX_LABEL bytes */
    const dm_pivot* pivot; /* optional evidence */
    int32_t pivot_kind;    /* DM_PIVOT_*: whether somebody has set the pivot */
    uint32_t reserved;     /* 0 */
} dm_part_desc;

/* What is known of where a pivot lies (dm_gltf_get_pivot_kind tells it of a glTF file). */
enum {
    DM_PIVOT_UNKNOWN = 0, /* nothing: it is judged by those of the other parts */
    DM_PIVOT_DEFAULT = 1, /* where a program puts them all: it says nothing */
    DM_PIVOT_SET = 2 /* the other nodes' follow a rule and it does not: somebody has set it, and it says the more */
};

/* How a part moves. */
typedef struct dm_joint {
    uint32_t struct_size;
    int32_t type;           /* DM_JOINT_* */
    float type_confidence;  /* probability that the type is right, 0..1 */
    float joint_confidence; /* probability that type, axis and origin are all right, 0..1; never above the other */
    float pitch;            /* screws: host units a radian, signed along the axis */
    dm_vec3 axis;           /* unit; host object frame. A positive value turns right-handed in a right-handed host
                               frame (left-handed in a left-handed one), or slides along it. Found with a drag,
                               positive goes its way; without one, the longer way is positive, so `upper` opens */
    dm_vec3 origin;       /* the point of the axis line nearest the part's centre; a host's own stays as it was given */
    float lower, upper;   /* limits of the joint value (rad or host units); the rest pose is value 0. None when they are
                             equal, and for continuous joints. A limit that a host gives farther from rest than 1000 rad
                             or 100 object sizes (FLT_MAX, 1e10, infinity) is none; where only one side is, a little more
                             than that stands for it */
    int32_t source;       /* DM_JOINT_FROM_*, DM_JOINT_CHOSEN */
    uint32_t evidence[4]; /* in a dm_part_state: what the part's pulls so far say of all its joints. dm_drag_end writes
                             it, dm_drag_begin reads it; keep the four numbers as they are. Zeros: no pull said
                             anything. Elsewhere 0, and not read */
    float closed;         /* joint value at which the part is closed: 0, or one of the limits where the part rests open.
                             A host's joint may have it; outside of its limits it is moved to the nearer one */
} dm_joint;

enum {
    DM_JOINT_FROM_NETWORK = 0,
    DM_JOINT_FROM_GEOMETRY = 1,
    DM_JOINT_FROM_HOST = 2, /* certain, limits too: no pull changes it */
    DM_JOINT_CHOSEN = 3     /* a hypothesis of the library that dm_object_desc.choose has chosen: no pull puts another
                               joint in its place, or its range on the other side of rest, but its limits are estimates
                               and give */
};

/* A joint as a physics engine's constraint wants it: an orthonormal frame whose x axis is the hinge's or slider's. y
 * and z are any, the same for the same joint; x, y, z and `rotation` have determinant +1 in the host's coordinates. */
typedef struct dm_joint_frame {
    uint32_t struct_size;
    int32_t type;       /* DM_JOINT_* */
    dm_vec3 origin;     /* host object frame */
    dm_vec3 x, y, z;    /* unit */
    float rotation[4];  /* unit quaternion x, y, z, w that takes the frame's coordinates to the object's */
    float lower, upper; /* hinges and screws: rad about x; sliders: host units along x; 0 where there is none */
    uint32_t limits;    /* DM_LIMIT_LOWER | DM_LIMIT_UPPER: which there are */
    float pitch;        /* screws: host units along x a radian */
} dm_joint_frame;

enum { DM_LIMIT_LOWER = 1, DM_LIMIT_UPPER = 2 };

/* Where one instance's part stands, and by which joint: all of what the host keeps of it, saves, replicates and undoes.
 * Belongs to the instance, not to the object: doors of one object may differ. Save it field by field (type, pitch,
 * axis, origin, limits, source, both confidences, evidence, value). */
typedef struct dm_part_state {
    uint32_t struct_size;
    float value;     /* joint value; 0 = rest */
    float velocity;  /* d value / dt, for a physics engine that takes over; told, not read: a drag begins without */
    uint32_t status; /* DM_STATUS_*; told, not read */
    dm_pose pose;    /* as shown, from rest. It differs from dm_joint_pose(joint, value) only while the part comes over
                        to a joint that has just changed. Zeros: that of joint and value */
    dm_joint joint;  /* stays the last field */
} dm_part_state;

/* Asks the host for a joint type (a designer's tag, a rule, a vision-language model; not DM_GO_*). Return
 * DM_JOINT_UNKNOWN to leave the question to the library. */
typedef int32_t(DM_CALL* dm_intent_callback)(void* user, uint32_t part_id, dm_vec3 box_min, dm_vec3 box_max);

typedef struct dm_part_info {
    uint32_t struct_size;
    uint32_t id, parent;
    uint32_t triangle_count; /* of the part alone, without the parts it carries */
    dm_vec3 box_min, box_max;
    dm_vec3 centre; /* area-weighted surface centroid */
    float area;
} dm_part_info;

/* Where a hypothesis takes its part at one end of its range. Host object frame. Frozen. */
typedef struct dm_joint_end {
    float value;              /* joint value */
    dm_pose pose;             /* of the part, from rest */
    dm_vec3 box_min, box_max; /* of the part alone, as in dm_part_info */
    dm_vec3 centre;
} dm_joint_end;

/* A ranked hypothesis and what it would do. struct_size: what the library has filled. */
typedef struct dm_hypothesis {
    uint32_t struct_size;
    uint32_t reserved;     /* 0 */
    const dm_joint* joint; /* with its limits and probabilities */
    dm_joint_end ends[2];  /* at the lower and the upper limit. Of a joint without limits: a quarter turn, or half the
                              object's size, either way */
} dm_hypothesis;

/* A part and its hypotheses, for the host to choose from. Valid during the call. */
typedef struct dm_choice {
    uint32_t struct_size;
    uint32_t count; /* of hypotheses; 1 .. DM_MAX_HYPOTHESES */
    const dm_part_info* part;
    const dm_hypothesis* const* hypotheses; /* most probable first */
} dm_choice;

enum { DM_CHOICE_KEEP = -1 };

/* Asks the host which hypothesis is right (a designer's rule, a vision-language model that is shown pictures). Return
 * its index to put it in force: its source is DM_JOINT_CHOSEN then, and both confidences are 1. DM_CHOICE_KEEP leaves
 * the library's answer with its confidences. What else is no index ends the preparation with INDEX_OUT_OF_RANGE.
 * dm_object_get_hypotheses and dm_object_reset_joint go on giving the library's own ranking. Called on the thread that
 * prepares, for one part after the other in order of id; not for parts that the host declares fixed. */
typedef int32_t(DM_CALL* dm_choice_callback)(void* user, const dm_choice* choice);

enum {
    DM_PREPARE_WITHOUT_PICKING = 1, /* keep no triangles: the object can't be added to a scene, and is small */
    DM_PREPARE_NETWORK_ALONE = 2,   /* the plain KPP-Net: no geometric candidates, no ranker. To compare with; NO_MODEL
                                       when `model` has no kinematics weights */
    DM_PREPARE_MESH_INCOMPLETE = 4  /* who read the mesh left something of its file out (dm_gltf_left_out): kept as
                                       DM_DEGRADED_MESH */
};

typedef struct dm_object_desc {
    uint32_t struct_size;
    uint32_t flags; /* DM_PREPARE_* */
    const dm_mesh_desc* mesh;
    const dm_part_desc* parts; /* NULL: every id > 0 in part_ids is a part carried by the body */
    uint32_t part_count;
    uint32_t reserved; /* 0 */
    dm_model model;    /* weights; 0 = geometry alone */
    uint64_t seed;     /* of the surface sampling; the same seed gives the same bits */
    dm_intent_callback intent;
    void* intent_user;
    dm_progress_callback progress; /* NULL = that of the context */
    void* progress_user;
    const char* label; /* optional evidence: names of the whole object, as dm_part_desc.label; they count for the parts
                          whose own label tells nothing */
    dm_vec3 up;        /* which way is up, host object frame; it counts together with labels and pivots alone. 0 = that
                          of the context's axes */
    dm_choice_callback choose;
    void* choose_user;
} dm_object_desc;

/* Why answers about an object are less than they could be: bits of dm_object_info.degraded. The call that makes the
 * object says the same in one warning. A saved object keeps them, but for DM_DEGRADED_NO_MOTION, which is that of the
 * model it was loaded with. */
enum {
    DM_DEGRADED_NO_KINEMATICS = 1, /* no weights of KPP-Net: joints are found by geometry alone */
    DM_DEGRADED_NO_RANKER = 2,     /* no weights of the ranker: joints are chosen, and limits set, by rules */
    DM_DEGRADED_NO_MOTION = 4,     /* no weights of the DQ-VAE: releases are paced by a rule, motions answer NO_MODEL */
    DM_DEGRADED_NO_BODY = 8,       /* everything is of a part: nothing stays that joints could be told by */
    DM_DEGRADED_HINT = 16,         /* a pivot was ignored: it is 1,000 object sizes away or more */
    DM_DEGRADED_MESH = 32          /* DM_PREPARE_MESH_INCOMPLETE */
};

typedef struct dm_object_info {
    uint32_t struct_size;
    uint32_t part_count;
    uint64_t vertex_count, triangle_count;
    dm_vec3 box_min, box_max; /* host object frame; with oblique custom axes it may be larger than need be */
    float size;               /* largest side of the box */
    uint32_t pickable;        /* 1 when it kept its triangles */
    uint32_t degraded;        /* DM_DEGRADED_*; 0: all that the library knows was at work */
    int32_t picking;          /* DM_PICK_EMBREE or DM_PICK_PORTABLE: whose trees it has; DM_PICK_NONE: it has none */
} dm_object_info;

/* ---- assets ------------------------------------------------------------------------------------------------- */

/* The asset frame is the one into which the nodes' transforms take their meshes: the object frame of the object that
 * dm_asset_make_object makes. */

#define DM_ASSET_NO_NODE UINT32_MAX /* no node: the scene itself */
#define DM_ASSET_NO_PART UINT32_MAX /* no part: the body that stays */

enum {
    DM_ASSET_NODE_FOLLOWS = 1, /* neither part nor body: a level of detail, a collider, something hidden. It goes where
                                  `follows` goes, and its mesh is not looked at */
    DM_ASSET_NODE_NO_PIVOT = 2 /* where its origin lies says nothing */
};

enum { DM_CLIP_NOT_RIGID = 1 /* the animation scales or bends the node as well */ };

/* How one animation moves one node. Frozen. */
typedef struct dm_asset_clip {
    const char* name;     /* of the animation, UTF-8; may be NULL */
    const float* times;   /* s, rising */
    const dm_pose* poses; /* of the node from the pose that its mesh has, asset frame, as if all nodes above it stood
                             still */
    uint32_t key_count;   /* of times and poses */
    uint32_t flags;       /* DM_CLIP_NOT_RIGID */
} dm_asset_clip;

/* A node of an asset as a host has it. */
typedef struct dm_asset_node {
    uint32_t struct_size;
    uint32_t flags;           /* DM_ASSET_NODE_* */
    uint32_t parent;          /* index of the node above it, which may come later in the list; else DM_ASSET_NO_NODE */
    uint32_t follows;         /* of DM_ASSET_NODE_FOLLOWS: index of a node, DM_ASSET_NO_NODE: the one above it */
    const char* name;         /* UTF-8, DM_MAX_LABEL bytes at most; NULL: none */
    const char* mesh_name;    /* the same, of its mesh */
    const dm_mesh_desc* mesh; /* without part_ids; NULL: a node without a mesh, such as a group */
    const float* transform;   /* 4x4, column-major: node to asset frame, all nodes above it included; affine. NULL:
                                 identity */
    const dm_pivot* pivot;    /* asset frame. NULL: origin and axes of `transform`; where that is NULL too, unknown */
    const dm_asset_clip* clips;
    uint32_t clip_count;
    uint32_t reserved;     /* 0 */
    const dm_joint* joint; /* asset frame: a joint that the file states for this node, with limits; certain, as a joint
                              that the host sets. DM_JOINT_FIXED: the node is one with the node above it. NULL: none */
} dm_asset_node;

enum {
    DM_ASSET_WITHOUT_CLIPS = 256, /* clips say nothing */
    DM_ASSET_WITHOUT_NAMES = 512  /* names and labels say nothing */
};

typedef struct dm_asset_desc {
    uint32_t struct_size;
    uint32_t flags; /* DM_ASSET_*, DM_PREPARE_WITHOUT_PICKING, DM_PREPARE_MESH_INCOMPLETE */
    const dm_asset_node* nodes;
    const char* label; /* optional evidence: names of the whole asset, as dm_object_desc.label */
    uint32_t node_count;
    float min_moves;               /* parts of at least this probability move, and are the object's; 0 = 0.5 */
    dm_model model;                /* weights; 0 = geometry alone */
    uint64_t seed;                 /* as dm_object_desc.seed */
    dm_progress_callback progress; /* NULL = that of the context */
    void* progress_user;
    dm_vec3 up;        /* which way is up, asset frame; 0 = that of the context's axes */
    uint32_t reserved; /* 0 */
} dm_asset_desc;

/* What was left aside: bits of dm_asset_info.warnings. */
enum {
    DM_ASSET_CLIP_LEFT_OUT = 1 /* a clip moves a node as no joint does, or is not rigid */
};

typedef struct dm_asset_info {
    uint32_t struct_size;
    uint32_t node_count;
    uint32_t part_count;     /* those that stay included */
    uint32_t moving_count;   /* parts that move or are free: those of the object */
    uint64_t triangle_count; /* of the nodes that do not follow others */
    uint32_t degraded;       /* DM_DEGRADED_*: what the joints were found without */
    uint32_t warnings;       /* DM_ASSET_CLIP_LEFT_OUT */
} dm_asset_info;

/* Whether a part moves. */
enum {
    DM_ASSET_STAYS = 0, /* it might move, but probably does not: `moves` is below dm_asset_desc.min_moves. Bodies that
                           almost certainly stay are no parts */
    DM_ASSET_MOVES = 1, /* by its joint */
    DM_ASSET_FREE = 2   /* nothing but its weight holds it, as the lid of a teapot: a player can take it away. Its joint
                           is the slide by which it comes off, with a low confidence */
};

/* Where a part's joint comes from. */
enum {
    DM_ASSET_INFERRED = 0,  /* from shape, contacts and names */
    DM_ASSET_FROM_FILE = 1, /* dm_asset_node.joint */
    DM_ASSET_FROM_CLIP = 2  /* dm_asset_node.clips */
};

/* Nodes that move as one, or might. */
typedef struct dm_asset_part {
    uint32_t struct_size;
    uint32_t parent;         /* index of the part that carries it, or DM_ASSET_NO_PART */
    uint32_t part_id;        /* in the object: its index + 1; 0 while it stays */
    int32_t state;           /* DM_ASSET_STAYS … */
    int32_t basis;           /* DM_ASSET_INFERRED … */
    float moves;             /* probability that it moves against what carries it, 0..1 */
    uint32_t node_count;     /* its nodes, those that follow them included; not those of the parts that it carries */
    uint32_t triangle_count; /* the same without those that follow */
    float duration;          /* s that its clip takes from one end of the joint to the other; 0: it has none */
    uint32_t reserved;       /* 0 */
    dm_vec3 box_min, box_max;
} dm_asset_part;

/* ---- motion and drag ---------------------------------------------------------------------------------------- */

/* What the player asked for. The network answers with a motion of DM_MOTION_FRAMES poses from rest. */
typedef struct dm_motion_desc {
    uint32_t struct_size;
    uint32_t part_id;
    dm_drag_hint drag;   /* required */
    const dm_vec3* path; /* optional: where the pointer drew the drag point, from drag.point on; 65536 at most */
    uint32_t path_count; /* 0: the path that opens the joint all the way in the drag's direction */
    uint32_t seed;       /* 0: the most likely motion (z = mean); else z is drawn with this seed */
} dm_motion_desc;

/* How a drag feels. Zeros are the defaults. Stiffness, damping and inertia of a part in the hand matter through two
 * ratios, which are times: smoothing_time is damping over stiffness, coast_time inertia over damping. */
typedef struct dm_drag_feel {
    float smoothing_time; /* s for the part to close half the gap to the pointer; 0 = 0.02, negative = none */
    float soft_limit;     /* share of the range over which the ends give; 0 = hard ends. Not of limits that the library
                             estimated: see dm_drag_desc.limit_give */
    float coast_time;     /* s in which a part left alone loses half its speed, and how heavy it is in the hand;
                             0 = 0.1 once released and weightless in the hand, negative = stops where it is let go */
    float detent;         /* joint value from one catch to the next, the first at rest (rad or host units); 0 = none */
    float detent_pull;    /* how hard catches hold, up to 1; 0 = 0.7. Nothing without `detent` */
    float return_time;    /* s for the released part to spring back to rest; 0 = push buttons alone, in 0.12;
                             negative = nothing springs back */
} dm_drag_feel;

enum {
    DM_DRAG_KEEP_JOINT = 1,   /* follow the joint in force, limits and all, whatever the pull says, as with a host's
                                 joint */
    DM_DRAG_WITHOUT_POINT = 2 /* no point is grabbed: for hands of DM_HAND_RATE, STEP and VALUE, and for releases.
                                 grab_point is not read; the middle of the part's box stands for it */
};

enum {
    DM_RULE_LOCKED = 1, /* the part stays where it is, gives a little, and says so (DM_EVENT_LOCKED) */
    DM_RULE_LATCH = 2   /* a latch holds it at rest until a handle has turned (dm_drag_input.handles), and catches it
                           again when it comes to rest with the handle let go */
};

/* What a part does besides following the hand. Zeros are off, but for the defaults of thresholds. "Range" is from lower
 * to upper limit; where one of them is missing, 1 rad or the object's size. docs/feel.md. */
typedef struct dm_drag_rules {
    uint32_t struct_size;
    uint32_t flags;         /* DM_RULE_* */
    const float* snaps;     /* snap_count joint values, rising: there the part catches, as at detents, and pulls as hard
                               as feel.detent_pull says. Not with feel.detent */
    uint32_t snap_count;    /* DM_MAX_SNAPS at most */
    float snap_reach;       /* joint value: how far a snap value reaches to either side; 0 = half-way to the next, or a
                               twentieth of the range where there is none */
    float open_share;       /* share of the range from rest: DM_EVENT_OPENED beyond; 0 = 0.1 */
    float closed_share;     /* share of the range from rest: DM_EVENT_CLOSED within; 0 = 0.02; less than open_share. A
                               part that is grabbed between both counts as open */
    float event_time;       /* shortest time between DM_EVENT_OPENED and DM_EVENT_CLOSED, s */
    float max_speed;        /* joint value a second; 0 = none */
    float max_acceleration; /* joint value a second squared while it gets faster, the highest force over the part's
                               inertia; 0 = none */
    float lock_give;  /* share of the range that a locked or latched part gives at most; 0 = 0.01, negative = none */
    float latch_turn; /* joint value of a handle, of either sign, from which on the latch is open; 0 = 0.785 */
    float auto_close_share; /* a released part nearer to rest than this share of the range closes; 0 = none does */
    float auto_close_time;  /* s that takes; 0 = 0.25 */
    float close_delay;      /* s after the release before feel.return_time brings it back */
    float tip_share;        /* a released part falls to rest from nearer than this share of the range, and else to its
                               open end, as a hatch does; 0 = it does not fall */
    float fall_time;        /* s of a fall over the whole range; 0 = 0.7 */
    float restitution;    /* share of its speed, 0 to 1, with which it comes back from a limit that it falls, glides or
                             swings against */
    float break_distance; /* host units from the hand to where it holds the part, beyond which it lets go
                             (DM_EVENT_LET_GO) and the part is released; 0 = never */
    float drive_speed;    /* share of the range a second at dm_hand.amount 1; 0 = 1 */
    uint32_t reserved;    /* 0 */
} dm_drag_rules;

/* What a link does to its driven part. */
enum {
    DM_LINK_MOVES = 0, /* the driven part's value is offset + ratio * (the driver's beyond `from`), inside its limits */
    DM_LINK_FREES = 1, /* the driven part is held until the driver has reached `from`: a handle */
    DM_LINK_HOLDS = 2  /* the driven part is held once the driver has reached `from`: of drawers, one at a time */
};

enum { DM_LINK_BOTH_WAYS = 1 /* of DM_LINK_MOVES: moving the driven part moves the driver */ };

/* A link between two parts. Frozen. */
typedef struct dm_link {
    uint32_t driver, driven; /* part ids */
    int32_t kind;            /* DM_LINK_* */
    uint32_t flags;          /* DM_LINK_BOTH_WAYS */
    float ratio;  /* value of the driven part a value of the driver; 0 = 1. Rad, host units: rack and pinion */
    float offset; /* value of the driven part while the driver is at `from` */
    float from;   /* value of the driver: nothing moves while it is nearer to 0, on that side of 0. 0: DM_LINK_FREES and
                     DM_LINK_HOLDS take it as reached at rest */
} dm_link;

typedef struct dm_drag_desc {
    uint32_t struct_size;
    uint32_t part_id;
    dm_object object;
    dm_vec3 grab_point; /* on the part as it is now, host object frame */
    float start_value;  /* joint value the part has now; 0 = rest. Not with `state` */
    dm_drag_feel feel;
    uint32_t flags;   /* DM_DRAG_KEEP_JOINT, DM_DRAG_WITHOUT_POINT */
    float limit_give; /* how far a pull that goes on takes the part beyond limits that the library estimated, as a share
                         of the range. 0 = as far as it is pulled, by a turn or the object's size at most; negative =
                         not at all. The host's own limits never give, nor does a stop at rest */
    const dm_part_state* state; /* the instance's own joint and value, as an earlier drag ended with them: the first
                                   pose is the last one of then. NULL = the object's joint in force, at start_value */
    dm_vec3 scale;              /* of the instance along the axes of the object frame, negative = mirrored; 0 = 1. Then
                                   grab_point, rays, state and poses are in the scaled frame (object coordinates times
                                   scale), and poses are rigid in it */
    uint32_t reserved;          /* 0 */
    const dm_drag_rules* rules; /* NULL = none, and no events */
} dm_drag_desc;

/* How a hand holds the part. */
enum {
    DM_HAND_NONE = 0, /* no news of it: the part goes on to where it was asked to be */
    DM_HAND_RAY = 1,  /* a pointer: `ray` */
    DM_HAND_POINT =
        2, /* a hand in space: `point`. The vector from it to the grabbed point stays as in its first update */
    DM_HAND_RATE = 3, /* a stick or a key held down: `amount`, -1 to 1, times dm_drag_rules.drive_speed */
    DM_HAND_STEP = 4, /* a wheel: moves by `amount`, a share of the range */
    DM_HAND_VALUE = 5 /* a slider of the host's: goes to the joint value `amount` */
};

typedef struct dm_hand {
    int32_t kind;  /* DM_HAND_*. RATE, STEP and VALUE stay inside the limits. RATE and STEP open with an amount above 0.
                      A limit that the library estimated stops them first. It then gives as to a pull: to a RATE after
                      0.25 s at the limit, to the next STEP */
    dm_ray ray;    /* object frame; scaled with dm_drag_desc.scale */
    dm_vec3 point; /* the same */
    float amount;  /* of RATE, STEP, VALUE */
    dm_vec3
        grab_point; /* of a second hand alone, where it takes hold: read in its first update, on the part as it is */
} dm_hand;

enum {
    DM_INPUT_LOCKED = 1, /* locked in this update, as by DM_RULE_LOCKED */
    DM_INPUT_ASK = 2,    /* dm_drag_override may change the value that this update takes */
    DM_INPUT_BOUNDS = 4  /* lower and upper hold, also when they are equal */
};

/* All that can be told a drag in one update. */
typedef struct dm_drag_input {
    uint32_t struct_size;
    uint32_t flags; /* DM_INPUT_* */
    dm_hand hand;
    dm_hand second;     /* another hand on the part, by ray or point; DM_HAND_NONE = none. Both count as far as each can
                           move the part. It comes and goes without a jump */
    float handles[2];   /* joint values of the handles of a latch, where their drags or links have them */
    float lower, upper; /* joint values between which the host's world leaves the part room in this update, infinite on
                           a free side; none when they are equal, but for DM_INPUT_BOUNDS. The part stops there softly,
                           and goes on when it is free; where it is beyond, it is pushed back */
} dm_drag_input;

enum {
    DM_DRAG_HELD = 0,     /* follows the pointer */
    DM_DRAG_RELEASED = 1, /* moves on by itself: dm_drag_release */
    DM_DRAG_AT_REST = 2   /* has come to where it goes */
};

/* What has happened to the part since the update before: bits of dm_drag_state.events. */
enum {
    DM_EVENT_LIMIT_LOWER = 1,  /* it has met its lower limit (within 0.5 % of the range), dm_drag_state.impact fast;
                                  again after it was 2 % away. An estimated limit that has given is none */
    DM_EVENT_LIMIT_UPPER = 2,  /* the same of the upper one */
    DM_EVENT_LEFT_REST = 4,    /* it is more than 2 % of the range away from rest */
    DM_EVENT_REACHED_REST = 8, /* it is within 0.5 % of the range of rest, having left it */
    DM_EVENT_OPENED = 16,      /* dm_drag_rules.open_share */
    DM_EVENT_CLOSED = 32,      /* dm_drag_rules.closed_share */
    DM_EVENT_DETENT = 64,      /* it has gone over to another detent or snap value: dm_drag_state.detents */
    DM_EVENT_JOINT = 128,      /* the pull has changed the joint: dm_drag_state.changes */
    DM_EVENT_BLOCKED = 256,    /* dm_drag_input's bounds hold it */
    DM_EVENT_FREED = 512,      /* they no longer do */
    DM_EVENT_LATCHED = 1024,   /* the latch has caught it */
    DM_EVENT_UNLATCHED = 2048, /* the handle has opened the latch */
    DM_EVENT_LOCKED = 4096,    /* it was tried while locked or latched; again after the hand has let up */
    DM_EVENT_LET_GO = 8192     /* dm_drag_rules.break_distance has let go of it */
};

/* How a part with dm_drag_rules stands after an update, or at its beginning: bits of dm_drag_state.status. */
enum {
    DM_STATUS_LATCHED = 1, /* the latch holds it */
    DM_STATUS_LOCKED = 2,  /* DM_RULE_LOCKED or DM_INPUT_LOCKED holds it */
    DM_STATUS_BLOCKED = 4, /* dm_drag_input's bounds hold it, from DM_EVENT_BLOCKED to DM_EVENT_FREED */
    DM_STATUS_OPEN = 8     /* it counts as open, from DM_EVENT_OPENED to DM_EVENT_CLOSED */
};

typedef struct dm_drag_state {
    uint32_t struct_size;
    dm_pose pose;       /* of the part from rest, object frame; compose with the parent part's own pose */
    dm_vec3 grab_point; /* where the grabbed point is now */
    float value;        /* joint value */
    float target;       /* value the pointer asks for, before smoothing and inside the limits */
    float velocity;     /* d value / dt */
    int32_t at_limit;   /* -1 at lower, +1 at upper, 0 between */
    int32_t phase;      /* DM_DRAG_HELD … */
    uint32_t changes;   /* how often the pull has changed the joint that the drag follows: dm_drag_get_part_state.
                           The pose comes over to a new joint within 0.6 s; the grabbed point first, mostly in 0.1 s */
    uint32_t events;    /* DM_EVENT_*; 0 without dm_drag_desc.rules, as the two below */
    uint32_t detents;   /* detents or snap values that it has gone over to since the update before; a long update may
                           pass several */
    float impact;       /* joint value a second: how fast it met a limit or was blocked; 0 without such an event */
    uint32_t status;    /* DM_STATUS_*: what holds the part, and how it stands; 0 without dm_drag_desc.rules */
    float joint_confidence; /* probability that the joint in force is right, 0..1: the one number to show. A pull of one
                               kind from one side never makes it certain */
    int32_t joint_basis;    /* DM_BASIS_*: where the joint in force comes from */
    float open_share; /* how far the part is open: 0 where it is closed (dm_joint.closed), 1 at the end farther from
                         there, between them by the joint value; 0 for joints without limits */
} dm_drag_state;

/* Where the joint that a drag follows comes from. */
enum {
    DM_BASIS_PREPARED = 0, /* dm_object_prepare found it, and no pull has changed it */
    DM_BASIS_PULL = 1,     /* a pull of this drag, or of an earlier one of the same dm_part_state, has changed it */
    DM_BASIS_HOST = 2,     /* the host's own */
    DM_BASIS_CHOSEN = 3    /* the host has chosen it among the hypotheses */
};

/* What a released part does next. */
enum {
    DM_GO_AUTO = 0,   /* as the player meant it, by where the part is and how fast it goes */
    DM_GO_STAY = 1,   /* glides to a stop; also stops a part that moves by itself */
    DM_GO_OPEN = 2,   /* goes on to the end of the joint that lies the way it was pulled */
    DM_GO_CLOSE = 3,  /* falls back to where it is closed: dm_joint.closed, which is rest unless it rests open */
    DM_GO_REPLAY = 4, /* does once more what it did after the last release */
    DM_GO_FREEZE = 5, /* stops dead */
    DM_GO_TOGGLE = 6  /* opens when it is nearer to where it is closed than to its open end, else closes */
};

/* The same by their names of version 0.2. */
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
    DM_RELEASE_BY_RULE = 1,  /* paced by a rule, not by the DQ-VAE, whose last bits differ between instruction sets */
    DM_RELEASE_AWAY_FROM = 2 /* a part that opens to both sides of rest opens away from `away_from` */
};

typedef struct dm_release_desc {
    uint32_t struct_size;
    int32_t intent;    /* DM_GO_* */
    float duration;    /* s from here to the end; 0 = as far and fast as it goes asks for */
    uint32_t seed;     /* of the DQ-VAE, as dm_motion_desc.seed */
    uint32_t flags;    /* DM_RELEASE_* */
    dm_vec3 away_from; /* object frame, scaled with dm_drag_desc.scale: the player, say */
} dm_release_desc;

typedef struct dm_release_plan {
    uint32_t struct_size;
    int32_t intent; /* as decided: DM_GO_STAY, OPEN, CLOSE or FREEZE */
    float start_value, end_value;
    float duration;        /* s; 0 when it is there already */
    uint32_t from_network; /* 1: paced by the DQ-VAE; 0: by a rule */
} dm_release_plan;

/* ---- camera and scene --------------------------------------------------------------------------------------- */

typedef struct dm_camera {
    uint32_t struct_size;
    float fov_y;                           /* rad, below pi; 0 = orthographic with ortho_height */
    dm_vec3 eye;                           /* host world frame */
    dm_vec3 forward, up;                   /* need not be unit or orthogonal, not parallel */
    float viewport_width, viewport_height; /* pixels */
    float ortho_height;                    /* orthographic: host units from bottom to top; else not used */
} dm_camera;

typedef struct dm_scene_desc {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
} dm_scene_desc;

typedef struct dm_hit {
    uint32_t struct_size;
    uint32_t instance;    /* as dm_scene_add gave it */
    dm_object object;     /* 0 = nothing hit */
    uint32_t part_id;     /* 0 = the body */
    uint32_t triangle;    /* index in the host's mesh */
    float distance;       /* host units from the ray's origin */
    float u, v;           /* barycentric weights of the triangle's second and third corner */
    dm_vec3 point;        /* host world frame */
    dm_vec3 normal;       /* unit, geometric, of the triangle's winding; host world frame */
    dm_vec3 object_point; /* the same point in the object's frame with the part as it is now: dm_drag_desc.grab_point */
} dm_hit;

/* ---- defaults: struct_size set, the rest zeros ---------------------------------------------------------------------
 */

/* Inline, so that struct_size is that of the caller's header: dm_drag_desc desc = dm_drag_desc_default(). Callers from
 * other languages zero the struct and set struct_size to its size. [any-thread] */
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

/* NAME of a result, such as "DM_ERROR_EMPTY_MASK"; "DM_ERROR_UNKNOWN" for others. Never NULL. [any-thread] */
DM_API const char* DM_CALL dm_result_string(dm_result result);

/* Version of the library in use, as DM_VERSION. [any-thread] */
DM_API uint32_t DM_CALL dm_version(void);

/* The function table of an interface id, NULL for an unknown one. "dm.core/1" -> const dm_core_1*. [any-thread] */
DM_API const void* DM_CALL dm_get_interface(const char* id);

/* ---- functions: context ------------------------------------------------------------------------------------------ */

/* Makes a context. desc NULL = all defaults. Errors: UNSUPPORTED when desc.picking asks for what is not there.
 * [any-thread] */
DM_API dm_result DM_CALL dm_context_create(const dm_context_desc* desc, dm_context** out_context);

/* Destroys it and everything made with it; NULL does nothing. [exclusive context] */
DM_API void DM_CALL dm_context_destroy(dm_context* context);

/* out_info->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_context_get_memory(const dm_context* context, dm_memory_info* out_info);

/* Gives the scratch memory that is kept for later calls (dm_memory_info.kept_bytes) back to the host's allocator: when
 * a level has loaded, or memory is short. [any-thread] */
DM_API dm_result DM_CALL dm_context_trim(dm_context* context);

/* ---- functions: weights ------------------------------------------------------------------------------------------ */

/* Reads weights. Errors: BAD_DATA, WRONG_MODEL, VERSION. [any-thread] */
DM_API dm_result DM_CALL dm_model_load(dm_context* context, const dm_model_desc* desc, dm_model* out_model);

/* Objects prepared with it keep their joints, and motions made with it stay; new motions and refinements of such
 * objects answer NO_MODEL. [exclusive object] */
DM_API dm_result DM_CALL dm_model_unload(dm_context* context, dm_model model);

/* ---- functions: objects and their joints ------------------------------------------------------------------------- */

/* Finds the part that a point of the surface belongs to, when no mask names it: 1 in out_face_ids for every triangle
 * that moves with it, 0 for the others; as part ids per face they go straight into a dm_mesh_desc. mesh->part_ids tell
 * pieces known to be rigid (the nodes of a scene): the grabbed one moves, with what is fastened to it alone. NULL, or
 * one piece: the part is put together from the mesh's sheets of surface. drag: where it was grabbed and how it was
 * pulled; a zero vector: no direction. Milliseconds to tens of them, a second for tens of thousands of loose pieces;
 * never more than linear in their number. Errors: as dm_object_prepare's of the mesh;
 * BUFFER_TOO_SMALL when face_count is less than the mesh's; DRAG_OFF_PART; FULL_MASK when nothing is left that stays;
 * CANCELLED. [any-thread] */
DM_API dm_result DM_CALL dm_mesh_find_part(dm_context* context, const dm_mesh_desc* mesh, const dm_drag_hint* drag,
                                           uint8_t* out_face_ids, uint64_t face_count);

/* Finds out how each part moves. Milliseconds to tens of them; see docs/performance.md. Uses dm_jobs. Warns once where
 * the answer is less than it could be (DM_DEGRADED_*).
 * Errors: NOT_FINITE, INDEX_OUT_OF_RANGE (also of what desc.choose answers), EMPTY_MASK, DEGENERATE_MESH, ZERO_DRAG,
 * DRAG_OFF_PART, TOO_LARGE, CANCELLED. [any-thread] */
DM_API dm_result DM_CALL dm_object_prepare(dm_context* context, const dm_object_desc* desc, dm_object* out_object);

/* Writes the prepared object (.dmo: versioned, checksummed, little-endian). Call with buffer NULL to learn the size.
 * out_size gets the bytes needed or written, with BUFFER_TOO_SMALL too. Triangles come with trees of the library's own,
 * so that loading builds none; where the object has others, each call builds them. [exclusive object] */
DM_API dm_result DM_CALL dm_object_save(dm_context* context, dm_object object, void* buffer, size_t capacity,
                                        size_t* out_size);

/* Reads what dm_object_save wrote, by this or any earlier version. `model` (may be 0) serves its motions. The file's
 * own trees are taken where desc.picking of the context is DM_PICK_AUTO or DM_PICK_PORTABLE (dm_object_info.picking).
 * Errors: BAD_DATA, VERSION, CANCELLED. [any-thread] */
DM_API dm_result DM_CALL dm_object_load(dm_context* context, const void* data, size_t size, dm_model model,
                                        dm_object* out_object);

/* Its drags and motions end with it, and its instances leave their scenes. [exclusive object, and none of those in use]
 */
DM_API dm_result DM_CALL dm_object_destroy(dm_context* context, dm_object object);

/* out_info->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_object_get_info(dm_context* context, dm_object object, dm_object_info* out_info);

/* Part by position 0 .. part_count-1, in order of id. out_info->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_object_get_part(dm_context* context, dm_object object, uint32_t index,
                                            dm_part_info* out_info);

/* The joint in force: the best hypothesis, or the host's own. out_joint->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_object_get_joint(dm_context* context, dm_object object, uint32_t part_id,
                                             dm_joint* out_joint);

/* Ranked hypotheses, best first, re-ranked by `drag` when it is given (microseconds; no network pass). capacity up to
 * DM_MAX_HYPOTHESES; out_joints[0].struct_size must be set, the others get it; out_count gets how many were written.
 * [any-thread] */
DM_API dm_result DM_CALL dm_object_get_hypotheses(dm_context* context, dm_object object, uint32_t part_id,
                                                  const dm_drag_hint* drag, dm_joint* out_joints, uint32_t capacity,
                                                  uint32_t* out_count);

/* Runs the kinematics pass of one part again, with the player's drag as evidence, and puts the result in force.
 * Milliseconds, not for every frame. Errors: NO_MODEL; UNSUPPORTED when the object kept no triangles; CANCELLED, which
 * leaves the joint in force. [exclusive object] */
DM_API dm_result DM_CALL dm_object_refine(dm_context* context, dm_object object, uint32_t part_id,
                                          const dm_drag_hint* drag);

/* The host knows better: puts its joint in force. The axis may have any length, limits may be infinite
 * (dm_joint.lower). Source becomes DM_JOINT_FROM_HOST and both confidences 1, unless the joint is, bit for bit, the one
 * in force or the library's own answer: then source and confidences are those of that one. Drags and motions that
 * already run keep the joint they began with. [exclusive object] */
DM_API dm_result DM_CALL dm_object_set_joint(dm_context* context, dm_object object, uint32_t part_id,
                                             const dm_joint* joint);

/* Puts the library's own answer back in force, after dm_object_set_joint or a choice. [exclusive object] */
DM_API dm_result DM_CALL dm_object_reset_joint(dm_context* context, dm_object object, uint32_t part_id);

/* Links parts of an object, in place of the links of before; count 0 to DM_MAX_LINKS, 0: none. Copied; a saved object
 * does not hold them. Errors: INVALID_ARGUMENT also when a part is moved by two drivers, or by itself over others;
 * NOT_FOUND. [exclusive object] */
DM_API dm_result DM_CALL dm_object_set_links(dm_context* context, dm_object object, const dm_link* links,
                                             uint32_t count);

/* Moves what is linked with a part that has moved. inout_values: the joint values of one instance, one a part, in the
 * order of dm_object_get_part; that of the part itself changes where a driver of it is at its limit (dm_drag_override).
 * out_held (may be NULL): 1 for the parts that links hold where they are (DM_INPUT_LOCKED), else 0. count: of both, the
 * number of parts. Limits are those of the joints in force, of the instance unscaled. [frame] */
DM_API dm_result DM_CALL dm_object_follow_links(dm_context* context, dm_object object, uint32_t part_id,
                                                float* inout_values, uint8_t* out_held, uint32_t count);

/* ---- functions: assets ------------------------------------------------------------------------------------------- */

/* Finds out which nodes of an asset move, which of them as one, what carries what, and how each moves. The same nodes
 * in the same order give the same bits. About as long as dm_object_prepare for all of its nodes. Uses dm_jobs. Warns
 * once where the answer is less than it could be.
 * Errors, which name the node: NOT_FINITE, INDEX_OUT_OF_RANGE, DEGENERATE_MESH, TOO_LARGE, CANCELLED; INVALID_ARGUMENT
 * also when parents or followers form a circle, a name is no UTF-8, and no node has a mesh. [any-thread] */
DM_API dm_result DM_CALL dm_asset_create(dm_context* context, const dm_asset_desc* desc, dm_asset* out_asset);

/* Objects made of it stay. [exclusive object] */
DM_API dm_result DM_CALL dm_asset_destroy(dm_context* context, dm_asset asset);

/* out_info->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_info(dm_context* context, dm_asset asset, dm_asset_info* out_info);

/* Part by index 0 .. part_count-1. out_part->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_part(dm_context* context, dm_asset asset, uint32_t index,
                                           dm_asset_part* out_part);

/* How a part moves, asset frame; of one that stays, how it would. out_joint->struct_size must be set. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_joint(dm_context* context, dm_asset asset, uint32_t index, dm_joint* out_joint);

/* The nodes of a part, rising: dm_asset_part.node_count of them. BUFFER_TOO_SMALL when capacity is less.
 * [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_part_nodes(dm_context* context, dm_asset asset, uint32_t index,
                                                 uint32_t* out_nodes, uint32_t capacity);

/* The part of each node, DM_ASSET_NO_PART for those of the body: dm_asset_info.node_count numbers. BUFFER_TOO_SMALL
 * when capacity is less. [any-thread] */
DM_API dm_result DM_CALL dm_asset_get_node_parts(dm_context* context, dm_asset asset, uint32_t* out_parts,
                                                 uint32_t capacity);

/* Makes a prepared object of the parts that move or are free, carried by each other as in the asset; all else is the
 * body. Its triangles are those of the nodes that do not follow others, node after node. Errors: EMPTY_MASK when
 * nothing moves. [any-thread] */
DM_API dm_result DM_CALL dm_asset_make_object(dm_context* context, dm_asset asset, dm_object* out_object);

/* ---- functions: joints as values --------------------------------------------------------------------------------- */

/* Pose of a joint at a value, in the frame of the joint. The axis may have any length, here and in the functions below.
 * [frame] */
DM_API dm_result DM_CALL dm_joint_pose(const dm_joint* joint, float value, dm_pose* out_pose);

/* Inverse of dm_joint_pose: the value at which the joint comes nearest to a pose (from rest), and how far off the joint
 * the pose is: the angle between both, rad, and the distance of the joint's origin under both, host units. Of values a
 * turn apart: inside the limits, else nearest to 0; of a screw, by its advance. Both errors may be NULL. NOT_FINITE
 * when an answer is beyond a float. [frame] */
DM_API dm_result DM_CALL dm_joint_value(const dm_joint* joint, const dm_pose* pose, float* out_value,
                                        float* out_angle_error, float* out_distance_error);

/* The joint value at a share of the way from rest to the open end, the limit that is farther from rest: 0 is rest, 1
 * open, 0.1 ajar. INVALID_ARGUMENT for a joint without limits. [frame] */
DM_API dm_result DM_CALL dm_joint_value_at(const dm_joint* joint, float share, float* out_value);

/* The joint as a constraint of a physics engine; out_frame->struct_size must be set. [frame] */
DM_API dm_result DM_CALL dm_joint_get_frame(const dm_joint* joint, dm_joint_frame* out_frame);

/* Carries a joint over into the frame of an instance scaled by (x, y, z), as dm_drag_begin does: the line through the
 * scaled points; limits of slides and the pitch in scaled units, angles as they are. out_joint->struct_size must be
 * set; it may be `joint`. Zeros = 1. [frame] */
DM_API dm_result DM_CALL dm_joint_scale(const dm_joint* joint, dm_vec3 scale, dm_joint* out_joint);

/* ---- functions: motions ------------------------------------------------------------------------------------------ */

/* The DQ-VAE's motion for a drag, projected exactly onto the joint in force; a fixed part's motion is rest. Errors:
 * NO_MODEL, ZERO_DRAG, DRAG_OFF_PART. [any-thread] */
DM_API dm_result DM_CALL dm_motion_generate(dm_context* context, dm_object object, const dm_motion_desc* desc,
                                            dm_motion* out_motion);

/* Pose at t in [0, 1] (clamped), 0 = rest; between key poses along the joint's own screw. NULL value is allowed.
 * [frame] */
DM_API dm_result DM_CALL dm_motion_sample(dm_context* context, dm_motion motion, float t, dm_pose* out_pose,
                                          float* out_value);

/* The DM_MOTION_FRAMES key poses, and (when not NULL) their joint values. [frame] */
DM_API dm_result DM_CALL dm_motion_get_frames(dm_context* context, dm_motion motion, dm_pose* out_poses,
                                              float* out_values);

/* Destroys a motion that no other thread samples. [any-thread] */
DM_API dm_result DM_CALL dm_motion_destroy(dm_context* context, dm_motion motion);

/* ---- functions: drags -------------------------------------------------------------------------------------------- */

/* The player grabs a part. Where the library found the joint, a pull tells more about it: the drag holds the part's
 * other hypotheses, and likely joints beyond them, and follows the one that explains the pull best, and limits that
 * were estimated yield when the pull goes on beyond them. docs/feel.md. A grab point or value that can't be meant
 * (other units, degrees) gets a warning. [any-thread] */
DM_API dm_result DM_CALL dm_drag_begin(dm_context* context, const dm_drag_desc* desc, dm_drag* out_drag);

/* The grabbed point follows the pointer ray (object frame; scaled with dm_drag_desc.scale) as closely as its joint
 * allows; dt in seconds, from -1e-4 to 0 taken as 0: a clock's rounding. Pass first the ray that grabbed the part: by
 * how much it misses the grab point (at most 0.032 rad) is kept for the whole drag, so that the part does not move
 * before the pointer does. After dm_drag_release it moves by itself, and ray may be NULL. out_state->struct_size must
 * be set. [frame] */
DM_API dm_result DM_CALL dm_drag_update(dm_context* context, dm_drag drag, const dm_ray* ray, float dt,
                                        dm_drag_state* out_state);

/* dm_drag_update for all that a dm_drag_input holds. A released part needs no hand. Errors: INVALID_ARGUMENT, also for
 * handles, bounds and DM_INPUT_LOCKED of a drag without dm_drag_desc.rules. [frame] */
DM_API dm_result DM_CALL dm_drag_step(dm_context* context, dm_drag drag, const dm_drag_input* input, float dt,
                                      dm_drag_state* out_state);
/* The same function, by the name for new code; dm_core_1 and the exports have dm_drag_step. */
#define dm_drag_update_input dm_drag_step

/* After an update with DM_INPUT_ASK, whose out_state is what is about to be: takes another value, inside the limits and
 * bounds of that update. Events are then those of the value taken. Without this call, the update stands. Errors:
 * INVALID_ARGUMENT when the last update did not ask. [frame] */
DM_API dm_result DM_CALL dm_drag_take(dm_context* context, dm_drag drag, float value, dm_drag_state* out_state);
/* The same function, by the name for new code; dm_core_1 and the exports have dm_drag_take. */
#define dm_drag_override dm_drag_take

/* The player lets go, and the part does what was meant: it swings open, falls shut, springs back or stays. The DQ-VAE
 * paces it where the object has its weights and desc.flags doesn't forbid it. dm_drag_update moves it, dm_drag_end ends
 * it at any time; a second release changes its mind or replays. desc NULL = all defaults; out_plan may be NULL, else
 * its struct_size must be set. Microseconds to a millisecond. One caller at a time per drag. [any-thread] */
DM_API dm_result DM_CALL dm_drag_release(dm_context* context, dm_drag drag, const dm_release_desc* desc,
                                         dm_release_plan* out_plan);

/* Lets go. out_state (may be NULL, else its struct_size must be set) gets what dm_drag_get_part_state gives.
 * [any-thread] */
DM_API dm_result DM_CALL dm_drag_end(dm_context* context, dm_drag drag, dm_part_state* out_state);

/* Where the part stands and the joint that the drag follows now, with the limits and the confidence that the pull so
 * far has left it. The same piece taken back by dm_drag_desc.state goes on where this one is. out_state->struct_size
 * must be set. [frame] */
DM_API dm_result DM_CALL dm_drag_get_part_state(dm_context* context, dm_drag drag, dm_part_state* out_state);

/* Bytes that dm_drag_save writes: the same for every drag of this library, DM_DRAG_SNAPSHOT_MAX at most. [any-thread]
 */
DM_API size_t DM_CALL dm_drag_snapshot_size(void);

/* Writes the whole state of a drag, for rollback: after dm_drag_restore the same calls give the same bits. For this
 * very version of the library on this kind of machine; what lasts is dm_part_state. BUFFER_TOO_SMALL when capacity is
 * less than dm_drag_snapshot_size. [frame] */
DM_API dm_result DM_CALL dm_drag_save(dm_context* context, dm_drag drag, void* buffer, size_t capacity);

/* Puts a drag back into a saved state, of this or any other drag of the same part. Errors leave it as it is: BAD_DATA,
 * VERSION, and INVALID_ARGUMENT when the state is of another part. [frame] */
DM_API dm_result DM_CALL dm_drag_restore(dm_context* context, dm_drag drag, const void* data, size_t size);

/* ---- functions: poses -------------------------------------------------------------------------------------------- */

/* out = a after b: x -> a(b(x)). [frame] */
DM_API void DM_CALL dm_pose_multiply(const dm_pose* a, const dm_pose* b, dm_pose* out_pose);

/* The motion back: what it does to the points that `pose` has moved undoes it. out_pose may be `pose`. [frame] */
DM_API void DM_CALL dm_pose_inverse(const dm_pose* pose, dm_pose* out_pose);

/* The pose that rotates, then translates, as engines keep the place of a node. rotation: quaternion x, y, z, w of any
 * length. Errors: INVALID_ARGUMENT when it has no length; NOT_FINITE. [frame] */
DM_API dm_result DM_CALL dm_pose_from_rotation(const float rotation[4], dm_vec3 translation, dm_pose* out_pose);

/* 4x4, column-major, column vectors (OpenGL, glTF, Unity's Matrix4x4 memory order). [frame] */
DM_API void DM_CALL dm_pose_to_matrix(const dm_pose* pose, float out_matrix[16]);

/* Moves `count` float32 points; strides in bytes, 0 = packed. src may equal dst. [frame] */
DM_API void DM_CALL dm_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst,
                                         size_t dst_stride, size_t count);

/* ---- functions: camera and scene --------------------------------------------------------------------------------- */

/* Ray through pixel (x, y), (0, 0) the top left corner of the viewport; direction is unit. Errors: INVALID_ARGUMENT
 * when the camera has no view; NOT_FINITE when the ray's origin is beyond a float's range. [frame] */
DM_API dm_result DM_CALL dm_camera_ray(const dm_context* context, const dm_camera* camera, float x, float y,
                                       dm_ray* out_ray);

/* Errors: UNSUPPORTED when the context picks nothing (DM_PICK_NONE, or nothing was found). [any-thread] */
DM_API dm_result DM_CALL dm_scene_create(dm_context* context, const dm_scene_desc* desc, dm_scene* out_scene);

/* Destroys it with its instances; their objects stay. [exclusive object] */
DM_API dm_result DM_CALL dm_scene_destroy(dm_context* context, dm_scene scene);

/* Places a prepared object; placement NULL = identity (object frame to world). Instances are small numbers from 0 on,
 * used again after a removal. Errors: UNSUPPORTED when the object can't be picked: it kept no triangles, or is smaller
 * than 1e-6 or larger than 1e12 host units. Takes effect with dm_scene_commit.
 * [exclusive object] */
DM_API dm_result DM_CALL dm_scene_add(dm_context* context, dm_scene scene, dm_object object, const dm_pose* placement,
                                      uint32_t* out_instance);

/* Moves a part of an instance to `pose` (from rest, object frame; the pose of the parts that carry it included), or
 * with part_id 0 the whole instance to a new placement. Takes effect with dm_scene_commit. [frame] */
DM_API dm_result DM_CALL dm_scene_move(dm_context* context, dm_scene scene, uint32_t instance, uint32_t part_id,
                                       const dm_pose* pose);

/* Takes an instance away, at once. [exclusive object] */
DM_API dm_result DM_CALL dm_scene_remove(dm_context* context, dm_scene scene, uint32_t instance);

/* Makes the moves visible to picks. Once a frame, after them. [frame] */
DM_API dm_result DM_CALL dm_scene_commit(dm_context* context, dm_scene scene);

/* Nearest hit of a ray. DM_OK with out_hit->object 0 when nothing is hit. Several threads may pick at once while none
 * moves or commits. out_hit->struct_size must be set. [frame] */
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
    uint32_t struct_size; /* bytes of this table in the library at hand: check before calling a newer entry */
    uint32_t reserved;
    DM_CORE_FUNCTIONS(DM_TABLE_ENTRY)
} dm_core_1;
#undef DM_TABLE_ENTRY

#ifdef __cplusplus
}
#endif

#endif
