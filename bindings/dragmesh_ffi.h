/* The C interface of dragmesh. Written by scripts/describe from the public headers: not to be edited. */
enum { DM_VERSION_MAJOR = 0 };
enum { DM_VERSION_MINOR = 4 };
enum { DM_VERSION_PATCH = 0 };
enum { DM_VERSION_DEVELOPMENT = 1 };
enum { DM_MOTION_FRAMES = 16 };
enum { DM_MAX_HYPOTHESES = 8 };
enum { DM_MAX_PARTS = 4096 };
enum { DM_MAX_ASSET_NODES = 65536 };
enum { DM_MAX_LABEL = 4096 };
enum { DM_MAX_ELEMENTS = 268435456 };
enum { DM_MAX_LINKS = 256 };
enum { DM_MAX_SNAPS = 16 };
enum { DM_DRAG_SNAPSHOT_MAX = 65536 };
static const uint32_t DM_ASSET_NO_NODE = 4294967295;
static const uint32_t DM_ASSET_NO_PART = 4294967295;
static const uint32_t DM_GLTF_NO_CARRIER = 4294967295;
enum {
    DM_OK = 0,
    DM_ERROR_INVALID_ARGUMENT = -1,
    DM_ERROR_STRUCT_SIZE = -2,
    DM_ERROR_STALE_HANDLE = -3,
    DM_ERROR_OUT_OF_MEMORY = -4,
    DM_ERROR_NOT_FINITE = -5,
    DM_ERROR_INDEX_OUT_OF_RANGE = -6,
    DM_ERROR_EMPTY_MASK = -7,
    DM_ERROR_FULL_MASK = -8,
    DM_ERROR_DEGENERATE_MESH = -9,
    DM_ERROR_ZERO_DRAG = -10,
    DM_ERROR_DRAG_OFF_PART = -11,
    DM_ERROR_BAD_DATA = -12,
    DM_ERROR_WRONG_MODEL = -13,
    DM_ERROR_VERSION = -14,
    DM_ERROR_CANCELLED = -15,
    DM_ERROR_NO_MODEL = -16,
    DM_ERROR_TOO_LARGE = -17,
    DM_ERROR_BUFFER_TOO_SMALL = -18,
    DM_ERROR_NOT_FOUND = -19,
    DM_ERROR_UNSUPPORTED = -20,
    DM_ERROR_INTERNAL = -21
};
enum {
    DM_LOG_ERROR = 0,
    DM_LOG_WARNING = 1,
    DM_LOG_INFO = 2
};
enum {
    DM_AXES_GLTF = 0,
    DM_AXES_UNITY = 1,
    DM_AXES_UNREAL = 2,
    DM_AXES_BLENDER = 3,
    DM_AXES_CUSTOM = 4
};
enum {
    DM_PICK_AUTO = 0,
    DM_PICK_EMBREE = 1,
    DM_PICK_PORTABLE = 2,
    DM_PICK_NONE = 3
};
enum {
    DM_JOINT_UNKNOWN = 0,
    DM_JOINT_REVOLUTE = 1,
    DM_JOINT_PRISMATIC = 2,
    DM_JOINT_SCREW = 3,
    DM_JOINT_CONTINUOUS = 4,
    DM_JOINT_FIXED = 5
};
enum {
    DM_FLOAT32 = 0,
    DM_FLOAT64 = 1
};
enum {
    DM_UINT32 = 0,
    DM_UINT16 = 1,
    DM_UINT8 = 2,
    DM_INT32 = 3
};
enum {
    DM_PER_VERTEX = 0,
    DM_PER_FACE = 1
};
enum {
    DM_PIVOT_UNKNOWN = 0,
    DM_PIVOT_DEFAULT = 1,
    DM_PIVOT_SET = 2
};
enum {
    DM_JOINT_FROM_NETWORK = 0,
    DM_JOINT_FROM_GEOMETRY = 1,
    DM_JOINT_FROM_HOST = 2,
    DM_JOINT_CHOSEN = 3
};
enum {
    DM_LIMIT_LOWER = 1,
    DM_LIMIT_UPPER = 2
};
enum {
    DM_CHOICE_KEEP = -1
};
enum {
    DM_PREPARE_WITHOUT_PICKING = 1,
    DM_PREPARE_NETWORK_ALONE = 2,
    DM_PREPARE_MESH_INCOMPLETE = 4
};
enum {
    DM_DEGRADED_NO_KINEMATICS = 1,
    DM_DEGRADED_NO_RANKER = 2,
    DM_DEGRADED_NO_MOTION = 4,
    DM_DEGRADED_NO_BODY = 8,
    DM_DEGRADED_HINT = 16,
    DM_DEGRADED_MESH = 32
};
enum {
    DM_ASSET_NODE_FOLLOWS = 1,
    DM_ASSET_NODE_NO_PIVOT = 2
};
enum {
    DM_CLIP_NOT_RIGID = 1
};
enum {
    DM_ASSET_WITHOUT_CLIPS = 256,
    DM_ASSET_WITHOUT_NAMES = 512
};
enum {
    DM_ASSET_CLIP_LEFT_OUT = 1
};
enum {
    DM_ASSET_STAYS = 0,
    DM_ASSET_MOVES = 1,
    DM_ASSET_FREE = 2
};
enum {
    DM_ASSET_INFERRED = 0,
    DM_ASSET_FROM_FILE = 1,
    DM_ASSET_FROM_CLIP = 2
};
enum {
    DM_DRAG_KEEP_JOINT = 1,
    DM_DRAG_WITHOUT_POINT = 2
};
enum {
    DM_RULE_LOCKED = 1,
    DM_RULE_LATCH = 2
};
enum {
    DM_LINK_MOVES = 0,
    DM_LINK_FREES = 1,
    DM_LINK_HOLDS = 2
};
enum {
    DM_LINK_BOTH_WAYS = 1
};
enum {
    DM_HAND_NONE = 0,
    DM_HAND_RAY = 1,
    DM_HAND_POINT = 2,
    DM_HAND_RATE = 3,
    DM_HAND_STEP = 4,
    DM_HAND_VALUE = 5
};
enum {
    DM_INPUT_LOCKED = 1,
    DM_INPUT_ASK = 2,
    DM_INPUT_BOUNDS = 4
};
enum {
    DM_DRAG_HELD = 0,
    DM_DRAG_RELEASED = 1,
    DM_DRAG_AT_REST = 2
};
enum {
    DM_EVENT_LIMIT_LOWER = 1,
    DM_EVENT_LIMIT_UPPER = 2,
    DM_EVENT_LEFT_REST = 4,
    DM_EVENT_REACHED_REST = 8,
    DM_EVENT_OPENED = 16,
    DM_EVENT_CLOSED = 32,
    DM_EVENT_DETENT = 64,
    DM_EVENT_JOINT = 128,
    DM_EVENT_BLOCKED = 256,
    DM_EVENT_FREED = 512,
    DM_EVENT_LATCHED = 1024,
    DM_EVENT_UNLATCHED = 2048,
    DM_EVENT_LOCKED = 4096,
    DM_EVENT_LET_GO = 8192
};
enum {
    DM_STATUS_LATCHED = 1,
    DM_STATUS_LOCKED = 2,
    DM_STATUS_BLOCKED = 4,
    DM_STATUS_OPEN = 8
};
enum {
    DM_BASIS_PREPARED = 0,
    DM_BASIS_PULL = 1,
    DM_BASIS_HOST = 2,
    DM_BASIS_CHOSEN = 3
};
enum {
    DM_GO_AUTO = 0,
    DM_GO_STAY = 1,
    DM_GO_OPEN = 2,
    DM_GO_CLOSE = 3,
    DM_GO_REPLAY = 4,
    DM_GO_FREEZE = 5,
    DM_GO_TOGGLE = 6
};
enum {
    DM_INTENT_AUTO = 0,
    DM_INTENT_STAY = 1,
    DM_INTENT_OPEN = 2,
    DM_INTENT_CLOSE = 3,
    DM_INTENT_REPLAY = 4,
    DM_INTENT_FREEZE = 5,
    DM_INTENT_TOGGLE = 6
};
enum {
    DM_RELEASE_BY_RULE = 1,
    DM_RELEASE_AWAY_FROM = 2
};
enum {
    DM_GLTF_WRAP_REPEAT = 10497,
    DM_GLTF_WRAP_CLAMP = 33071,
    DM_GLTF_WRAP_MIRROR = 33648
};
enum {
    DM_GLTF_RIG_URDF = 1,
    DM_GLTF_RIG_MJCF = 2,
    DM_GLTF_RIG_SDF = 4,
    DM_GLTF_RIG_USDA = 8,
    DM_GLTF_RIG_TSCN = 16,
    DM_GLTF_RIG_GLB = 32
};
typedef struct dm_vec3 dm_vec3;
typedef struct dm_pose dm_pose;
typedef struct dm_ray dm_ray;
typedef struct dm_allocator dm_allocator;
typedef struct dm_log dm_log;
typedef struct dm_jobs dm_jobs;
typedef struct dm_context_desc dm_context_desc;
typedef struct dm_memory_info dm_memory_info;
typedef struct dm_model_desc dm_model_desc;
typedef struct dm_mesh_desc dm_mesh_desc;
typedef struct dm_drag_hint dm_drag_hint;
typedef struct dm_pivot dm_pivot;
typedef struct dm_part_desc dm_part_desc;
typedef struct dm_joint dm_joint;
typedef struct dm_joint_frame dm_joint_frame;
typedef struct dm_part_state dm_part_state;
typedef struct dm_part_info dm_part_info;
typedef struct dm_joint_end dm_joint_end;
typedef struct dm_hypothesis dm_hypothesis;
typedef struct dm_choice dm_choice;
typedef struct dm_object_desc dm_object_desc;
typedef struct dm_object_info dm_object_info;
typedef struct dm_asset_clip dm_asset_clip;
typedef struct dm_asset_node dm_asset_node;
typedef struct dm_asset_desc dm_asset_desc;
typedef struct dm_asset_info dm_asset_info;
typedef struct dm_asset_part dm_asset_part;
typedef struct dm_motion_desc dm_motion_desc;
typedef struct dm_drag_feel dm_drag_feel;
typedef struct dm_drag_rules dm_drag_rules;
typedef struct dm_link dm_link;
typedef struct dm_drag_desc dm_drag_desc;
typedef struct dm_hand dm_hand;
typedef struct dm_drag_input dm_drag_input;
typedef struct dm_drag_state dm_drag_state;
typedef struct dm_release_desc dm_release_desc;
typedef struct dm_release_plan dm_release_plan;
typedef struct dm_camera dm_camera;
typedef struct dm_scene_desc dm_scene_desc;
typedef struct dm_hit dm_hit;
typedef struct dm_core_1 dm_core_1;
typedef struct dm_gltf_files dm_gltf_files;
typedef struct dm_gltf_desc dm_gltf_desc;
typedef struct dm_gltf_node dm_gltf_node;
typedef struct dm_gltf_surface dm_gltf_surface;
typedef struct dm_gltf_track dm_gltf_track;
typedef struct dm_gltf_part dm_gltf_part;
typedef struct dm_gltf_rig_desc dm_gltf_rig_desc;
typedef struct dm_gltf_rig_file dm_gltf_rig_file;
typedef int32_t dm_result;
typedef struct dm_context dm_context;
typedef uint64_t dm_model;
typedef uint64_t dm_object;
typedef uint64_t dm_motion;
typedef uint64_t dm_drag;
typedef uint64_t dm_scene;
typedef uint64_t dm_asset;
typedef struct dm_gltf dm_gltf;
typedef struct dm_gltf_rig dm_gltf_rig;
typedef void (*dm_task)(void* data, uint32_t index);
typedef int32_t (*dm_progress_callback)(void* user, float done);
typedef int32_t (*dm_intent_callback)(void* user, uint32_t part_id, dm_vec3 box_min, dm_vec3 box_max);
typedef int32_t (*dm_choice_callback)(void* user, const dm_choice* choice);
struct dm_vec3 {
    float x;
    float y;
    float z;
};
struct dm_pose {
    float real[4];
    float dual[4];
};
struct dm_ray {
    dm_vec3 origin;
    dm_vec3 direction;
};
struct dm_allocator {
    void* user;
    void* (*allocate)(void* user, size_t size, size_t alignment);
    void (*release)(void* user, void* memory, size_t size);
};
struct dm_log {
    void* user;
    void (*message)(void* user, int32_t level, dm_result code, const char* text);
};
struct dm_jobs {
    void* user;
    int32_t (*parallel_for)(void* user, uint32_t count, dm_task task, void* data);
};
struct dm_context_desc {
    uint32_t struct_size;
    int32_t axes;
    float unit_in_metres;
    float custom_axes[9];
    dm_allocator allocator;
    dm_log log;
    dm_jobs jobs;
    int32_t picking;
    uint32_t reserved;
    dm_progress_callback progress;
    void* progress_user;
    uint64_t kept_bytes;
};
struct dm_memory_info {
    uint32_t struct_size;
    uint32_t reserved;
    uint64_t bytes;
    uint64_t peak_bytes;
    uint64_t allocations;
    uint64_t pick_bytes;
    uint64_t kept_bytes;
};
struct dm_model_desc {
    uint32_t struct_size;
    const void* kinematics;
    size_t kinematics_size;
    const void* motion;
    size_t motion_size;
    const void* ranker;
    size_t ranker_size;
};
struct dm_mesh_desc {
    uint32_t struct_size;
    uint32_t position_stride;
    const void* positions;
    uint64_t vertex_count;
    uint64_t position_bytes;
    const void* indices;
    uint64_t index_count;
    uint64_t index_bytes;
    const void* part_ids;
    uint64_t part_id_bytes;
    uint32_t part_id_stride;
    int32_t position_format;
    int32_t index_format;
    int32_t part_id_format;
    int32_t part_id_scope;
    uint32_t reserved;
};
struct dm_drag_hint {
    dm_vec3 point;
    dm_vec3 vector;
};
struct dm_pivot {
    dm_vec3 origin;
    float axes[9];
};
struct dm_part_desc {
    uint32_t struct_size;
    uint32_t id;
    uint32_t parent;
    int32_t joint_type;
    const dm_drag_hint* drag;
    const char* label;
    const dm_pivot* pivot;
    int32_t pivot_kind;
    uint32_t reserved;
};
struct dm_joint {
    uint32_t struct_size;
    int32_t type;
    float type_confidence;
    float joint_confidence;
    float pitch;
    dm_vec3 axis;
    dm_vec3 origin;
    float lower;
    float upper;
    int32_t source;
    uint32_t evidence[4];
    float closed;
};
struct dm_joint_frame {
    uint32_t struct_size;
    int32_t type;
    dm_vec3 origin;
    dm_vec3 x;
    dm_vec3 y;
    dm_vec3 z;
    float rotation[4];
    float lower;
    float upper;
    uint32_t limits;
    float pitch;
};
struct dm_part_state {
    uint32_t struct_size;
    float value;
    float velocity;
    uint32_t status;
    dm_pose pose;
    dm_joint joint;
};
struct dm_part_info {
    uint32_t struct_size;
    uint32_t id;
    uint32_t parent;
    uint32_t triangle_count;
    dm_vec3 box_min;
    dm_vec3 box_max;
    dm_vec3 centre;
    float area;
};
struct dm_joint_end {
    float value;
    dm_pose pose;
    dm_vec3 box_min;
    dm_vec3 box_max;
    dm_vec3 centre;
};
struct dm_hypothesis {
    uint32_t struct_size;
    uint32_t reserved;
    const dm_joint* joint;
    dm_joint_end ends[2];
};
struct dm_choice {
    uint32_t struct_size;
    uint32_t count;
    const dm_part_info* part;
    const dm_hypothesis** hypotheses;
};
struct dm_object_desc {
    uint32_t struct_size;
    uint32_t flags;
    const dm_mesh_desc* mesh;
    const dm_part_desc* parts;
    uint32_t part_count;
    uint32_t reserved;
    dm_model model;
    uint64_t seed;
    dm_intent_callback intent;
    void* intent_user;
    dm_progress_callback progress;
    void* progress_user;
    const char* label;
    dm_vec3 up;
    dm_choice_callback choose;
    void* choose_user;
};
struct dm_object_info {
    uint32_t struct_size;
    uint32_t part_count;
    uint64_t vertex_count;
    uint64_t triangle_count;
    dm_vec3 box_min;
    dm_vec3 box_max;
    float size;
    uint32_t pickable;
    uint32_t degraded;
    int32_t picking;
};
struct dm_asset_clip {
    const char* name;
    const float* times;
    const dm_pose* poses;
    uint32_t key_count;
    uint32_t flags;
};
struct dm_asset_node {
    uint32_t struct_size;
    uint32_t flags;
    uint32_t parent;
    uint32_t follows;
    const char* name;
    const char* mesh_name;
    const dm_mesh_desc* mesh;
    const float* transform;
    const dm_pivot* pivot;
    const dm_asset_clip* clips;
    uint32_t clip_count;
    uint32_t reserved;
    const dm_joint* joint;
};
struct dm_asset_desc {
    uint32_t struct_size;
    uint32_t flags;
    const dm_asset_node* nodes;
    const char* label;
    uint32_t node_count;
    float min_moves;
    dm_model model;
    uint64_t seed;
    dm_progress_callback progress;
    void* progress_user;
    dm_vec3 up;
    uint32_t reserved;
};
struct dm_asset_info {
    uint32_t struct_size;
    uint32_t node_count;
    uint32_t part_count;
    uint32_t moving_count;
    uint64_t triangle_count;
    uint32_t degraded;
    uint32_t warnings;
};
struct dm_asset_part {
    uint32_t struct_size;
    uint32_t parent;
    uint32_t part_id;
    int32_t state;
    int32_t basis;
    float moves;
    uint32_t node_count;
    uint32_t triangle_count;
    float duration;
    uint32_t reserved;
    dm_vec3 box_min;
    dm_vec3 box_max;
};
struct dm_motion_desc {
    uint32_t struct_size;
    uint32_t part_id;
    dm_drag_hint drag;
    const dm_vec3* path;
    uint32_t path_count;
    uint32_t seed;
};
struct dm_drag_feel {
    float smoothing_time;
    float soft_limit;
    float coast_time;
    float detent;
    float detent_pull;
    float return_time;
};
struct dm_drag_rules {
    uint32_t struct_size;
    uint32_t flags;
    const float* snaps;
    uint32_t snap_count;
    float snap_reach;
    float open_share;
    float closed_share;
    float event_time;
    float max_speed;
    float max_acceleration;
    float lock_give;
    float latch_turn;
    float auto_close_share;
    float auto_close_time;
    float close_delay;
    float tip_share;
    float fall_time;
    float restitution;
    float break_distance;
    float drive_speed;
    uint32_t reserved;
};
struct dm_link {
    uint32_t driver;
    uint32_t driven;
    int32_t kind;
    uint32_t flags;
    float ratio;
    float offset;
    float from;
};
struct dm_drag_desc {
    uint32_t struct_size;
    uint32_t part_id;
    dm_object object;
    dm_vec3 grab_point;
    float start_value;
    dm_drag_feel feel;
    uint32_t flags;
    float limit_give;
    const dm_part_state* state;
    dm_vec3 scale;
    uint32_t reserved;
    const dm_drag_rules* rules;
};
struct dm_hand {
    int32_t kind;
    dm_ray ray;
    dm_vec3 point;
    float amount;
    dm_vec3 grab_point;
};
struct dm_drag_input {
    uint32_t struct_size;
    uint32_t flags;
    dm_hand hand;
    dm_hand second;
    float handles[2];
    float lower;
    float upper;
};
struct dm_drag_state {
    uint32_t struct_size;
    dm_pose pose;
    dm_vec3 grab_point;
    float value;
    float target;
    float velocity;
    int32_t at_limit;
    int32_t phase;
    uint32_t changes;
    uint32_t events;
    uint32_t detents;
    float impact;
    uint32_t status;
    float joint_confidence;
    int32_t joint_basis;
    float open_share;
};
struct dm_release_desc {
    uint32_t struct_size;
    int32_t intent;
    float duration;
    uint32_t seed;
    uint32_t flags;
    dm_vec3 away_from;
};
struct dm_release_plan {
    uint32_t struct_size;
    int32_t intent;
    float start_value;
    float end_value;
    float duration;
    uint32_t from_network;
};
struct dm_camera {
    uint32_t struct_size;
    float fov_y;
    dm_vec3 eye;
    dm_vec3 forward;
    dm_vec3 up;
    float viewport_width;
    float viewport_height;
    float ortho_height;
};
struct dm_scene_desc {
    uint32_t struct_size;
    uint32_t reserved;
};
struct dm_hit {
    uint32_t struct_size;
    uint32_t instance;
    dm_object object;
    uint32_t part_id;
    uint32_t triangle;
    float distance;
    float u;
    float v;
    dm_vec3 point;
    dm_vec3 normal;
    dm_vec3 object_point;
};
struct dm_core_1 {
    uint32_t struct_size;
    uint32_t reserved;
    const char* (*result_string)(dm_result result);
    uint32_t (*version)(void);
    dm_result (*context_create)(const dm_context_desc* desc, dm_context** out_context);
    void (*context_destroy)(dm_context* context);
    dm_result (*context_get_memory)(const dm_context* context, dm_memory_info* out_info);
    dm_result (*model_load)(dm_context* context, const dm_model_desc* desc, dm_model* out_model);
    dm_result (*model_unload)(dm_context* context, dm_model model);
    dm_result (*mesh_find_part)(dm_context* context, const dm_mesh_desc* mesh, const dm_drag_hint* drag, uint8_t* out_face_ids, uint64_t face_count);
    dm_result (*object_prepare)(dm_context* context, const dm_object_desc* desc, dm_object* out_object);
    dm_result (*object_save)(dm_context* context, dm_object object, void* buffer, size_t capacity, size_t* out_size);
    dm_result (*object_load)(dm_context* context, const void* data, size_t size, dm_model model, dm_object* out_object);
    dm_result (*object_destroy)(dm_context* context, dm_object object);
    dm_result (*object_get_info)(dm_context* context, dm_object object, dm_object_info* out_info);
    dm_result (*object_get_part)(dm_context* context, dm_object object, uint32_t index, dm_part_info* out_info);
    dm_result (*object_get_joint)(dm_context* context, dm_object object, uint32_t part_id, dm_joint* out_joint);
    dm_result (*object_get_hypotheses)(dm_context* context, dm_object object, uint32_t part_id, const dm_drag_hint* drag, dm_joint* out_joints, uint32_t capacity, uint32_t* out_count);
    dm_result (*object_refine)(dm_context* context, dm_object object, uint32_t part_id, const dm_drag_hint* drag);
    dm_result (*object_set_joint)(dm_context* context, dm_object object, uint32_t part_id, const dm_joint* joint);
    dm_result (*object_reset_joint)(dm_context* context, dm_object object, uint32_t part_id);
    dm_result (*joint_pose)(const dm_joint* joint, float value, dm_pose* out_pose);
    dm_result (*joint_value)(const dm_joint* joint, const dm_pose* pose, float* out_value, float* out_angle_error, float* out_distance_error);
    dm_result (*joint_get_frame)(const dm_joint* joint, dm_joint_frame* out_frame);
    dm_result (*joint_scale)(const dm_joint* joint, dm_vec3 scale, dm_joint* out_joint);
    dm_result (*motion_generate)(dm_context* context, dm_object object, const dm_motion_desc* desc, dm_motion* out_motion);
    dm_result (*motion_sample)(dm_context* context, dm_motion motion, float t, dm_pose* out_pose, float* out_value);
    dm_result (*motion_get_frames)(dm_context* context, dm_motion motion, dm_pose* out_poses, float* out_values);
    dm_result (*motion_destroy)(dm_context* context, dm_motion motion);
    dm_result (*drag_begin)(dm_context* context, const dm_drag_desc* desc, dm_drag* out_drag);
    dm_result (*drag_update)(dm_context* context, dm_drag drag, const dm_ray* ray, float dt, dm_drag_state* out_state);
    dm_result (*drag_release)(dm_context* context, dm_drag drag, const dm_release_desc* desc, dm_release_plan* out_plan);
    dm_result (*drag_end)(dm_context* context, dm_drag drag, dm_part_state* out_state);
    dm_result (*drag_get_part_state)(dm_context* context, dm_drag drag, dm_part_state* out_state);
    size_t (*drag_snapshot_size)(void);
    dm_result (*drag_save)(dm_context* context, dm_drag drag, void* buffer, size_t capacity);
    dm_result (*drag_restore)(dm_context* context, dm_drag drag, const void* data, size_t size);
    void (*pose_multiply)(const dm_pose* a, const dm_pose* b, dm_pose* out_pose);
    void (*pose_to_matrix)(const dm_pose* pose, float out_matrix[16]);
    void (*pose_apply_points)(const dm_pose* pose, const float* src, size_t src_stride, float* dst, size_t dst_stride, size_t count);
    dm_result (*camera_ray)(const dm_context* context, const dm_camera* camera, float x, float y, dm_ray* out_ray);
    dm_result (*scene_create)(dm_context* context, const dm_scene_desc* desc, dm_scene* out_scene);
    dm_result (*scene_destroy)(dm_context* context, dm_scene scene);
    dm_result (*scene_add)(dm_context* context, dm_scene scene, dm_object object, const dm_pose* placement, uint32_t* out_instance);
    dm_result (*scene_move)(dm_context* context, dm_scene scene, uint32_t instance, uint32_t part_id, const dm_pose* pose);
    dm_result (*scene_remove)(dm_context* context, dm_scene scene, uint32_t instance);
    dm_result (*scene_commit)(dm_context* context, dm_scene scene);
    dm_result (*scene_pick)(dm_context* context, dm_scene scene, const dm_ray* ray, dm_hit* out_hit);
    dm_result (*drag_step)(dm_context* context, dm_drag drag, const dm_drag_input* input, float dt, dm_drag_state* out_state);
    dm_result (*drag_take)(dm_context* context, dm_drag drag, float value, dm_drag_state* out_state);
    dm_result (*object_set_links)(dm_context* context, dm_object object, const dm_link* links, uint32_t count);
    dm_result (*object_follow_links)(dm_context* context, dm_object object, uint32_t part_id, float* inout_values, uint8_t* out_held, uint32_t count);
    dm_result (*joint_value_at)(const dm_joint* joint, float share, float* out_value);
    void (*pose_inverse)(const dm_pose* pose, dm_pose* out_pose);
    dm_result (*pose_from_rotation)(const float rotation[4], dm_vec3 translation, dm_pose* out_pose);
    dm_result (*asset_create)(dm_context* context, const dm_asset_desc* desc, dm_asset* out_asset);
    dm_result (*asset_destroy)(dm_context* context, dm_asset asset);
    dm_result (*asset_get_info)(dm_context* context, dm_asset asset, dm_asset_info* out_info);
    dm_result (*asset_get_part)(dm_context* context, dm_asset asset, uint32_t index, dm_asset_part* out_part);
    dm_result (*asset_get_joint)(dm_context* context, dm_asset asset, uint32_t index, dm_joint* out_joint);
    dm_result (*asset_get_part_nodes)(dm_context* context, dm_asset asset, uint32_t index, uint32_t* out_nodes, uint32_t capacity);
    dm_result (*asset_get_node_parts)(dm_context* context, dm_asset asset, uint32_t* out_parts, uint32_t capacity);
    dm_result (*asset_make_object)(dm_context* context, dm_asset asset, dm_object* out_object);
    dm_result (*context_trim)(dm_context* context);
};
struct dm_gltf_files {
    void* user;
    int32_t (*open)(void* user, const char* path, const void** out_data, size_t* out_size);
    void (*close)(void* user, const void* data, size_t size);
};
struct dm_gltf_desc {
    uint32_t struct_size;
    uint32_t reserved;
    const void* data;
    size_t size;
    dm_allocator allocator;
    dm_log log;
    dm_gltf_files files;
    dm_progress_callback progress;
    void* progress_user;
};
struct dm_gltf_node {
    const char* name;
    uint32_t node;
    uint32_t carrier;
    uint64_t first_vertex;
    uint64_t vertex_count;
    uint64_t first_face;
    uint64_t face_count;
    float colour[4];
};
struct dm_gltf_surface {
    uint64_t first_face;
    uint64_t face_count;
    float colour[4];
    const void* image;
    size_t image_size;
    int32_t wrap_u;
    int32_t wrap_v;
};
struct dm_gltf_track {
    const char* name;
    const uint8_t* face_ids;
    uint8_t value;
    uint8_t reserved[7];
    const dm_pose* poses;
    const float* times;
    uint32_t key_count;
    uint32_t reserved2;
};
struct dm_gltf_part {
    const char* name;
    const float* positions;
    const uint32_t* indices;
    uint64_t vertex_count;
    uint64_t index_count;
    float colour[4];
};
struct dm_gltf_rig_desc {
    uint32_t struct_size;
    uint32_t formats;
    const dm_asset_node* nodes;
    const dm_asset_part* parts;
    const dm_joint* joints;
    const uint32_t* node_parts;
    const float* colours;
    const char* name;
    const char** part_names;
    dm_gltf* gltf;
    uint32_t node_count;
    uint32_t part_count;
    int32_t axes;
    float unit_in_metres;
    float density;
    float thickness;
    float friction;
    float damping_time;
    dm_allocator allocator;
    dm_log log;
};
struct dm_gltf_rig_file {
    const char* path;
    const void* data;
    size_t size;
};
const char* dm_result_string(dm_result result);
uint32_t dm_version(void);
const void* dm_get_interface(const char* id);
dm_result dm_context_create(const dm_context_desc* desc, dm_context** out_context);
void dm_context_destroy(dm_context* context);
dm_result dm_context_get_memory(const dm_context* context, dm_memory_info* out_info);
dm_result dm_context_trim(dm_context* context);
dm_result dm_model_load(dm_context* context, const dm_model_desc* desc, dm_model* out_model);
dm_result dm_model_unload(dm_context* context, dm_model model);
dm_result dm_mesh_find_part(dm_context* context, const dm_mesh_desc* mesh, const dm_drag_hint* drag, uint8_t* out_face_ids, uint64_t face_count);
dm_result dm_object_prepare(dm_context* context, const dm_object_desc* desc, dm_object* out_object);
dm_result dm_object_save(dm_context* context, dm_object object, void* buffer, size_t capacity, size_t* out_size);
dm_result dm_object_load(dm_context* context, const void* data, size_t size, dm_model model, dm_object* out_object);
dm_result dm_object_destroy(dm_context* context, dm_object object);
dm_result dm_object_get_info(dm_context* context, dm_object object, dm_object_info* out_info);
dm_result dm_object_get_part(dm_context* context, dm_object object, uint32_t index, dm_part_info* out_info);
dm_result dm_object_get_joint(dm_context* context, dm_object object, uint32_t part_id, dm_joint* out_joint);
dm_result dm_object_get_hypotheses(dm_context* context, dm_object object, uint32_t part_id, const dm_drag_hint* drag, dm_joint* out_joints, uint32_t capacity, uint32_t* out_count);
dm_result dm_object_refine(dm_context* context, dm_object object, uint32_t part_id, const dm_drag_hint* drag);
dm_result dm_object_set_joint(dm_context* context, dm_object object, uint32_t part_id, const dm_joint* joint);
dm_result dm_object_reset_joint(dm_context* context, dm_object object, uint32_t part_id);
dm_result dm_object_set_links(dm_context* context, dm_object object, const dm_link* links, uint32_t count);
dm_result dm_object_follow_links(dm_context* context, dm_object object, uint32_t part_id, float* inout_values, uint8_t* out_held, uint32_t count);
dm_result dm_asset_create(dm_context* context, const dm_asset_desc* desc, dm_asset* out_asset);
dm_result dm_asset_destroy(dm_context* context, dm_asset asset);
dm_result dm_asset_get_info(dm_context* context, dm_asset asset, dm_asset_info* out_info);
dm_result dm_asset_get_part(dm_context* context, dm_asset asset, uint32_t index, dm_asset_part* out_part);
dm_result dm_asset_get_joint(dm_context* context, dm_asset asset, uint32_t index, dm_joint* out_joint);
dm_result dm_asset_get_part_nodes(dm_context* context, dm_asset asset, uint32_t index, uint32_t* out_nodes, uint32_t capacity);
dm_result dm_asset_get_node_parts(dm_context* context, dm_asset asset, uint32_t* out_parts, uint32_t capacity);
dm_result dm_asset_make_object(dm_context* context, dm_asset asset, dm_object* out_object);
dm_result dm_joint_pose(const dm_joint* joint, float value, dm_pose* out_pose);
dm_result dm_joint_value(const dm_joint* joint, const dm_pose* pose, float* out_value, float* out_angle_error, float* out_distance_error);
dm_result dm_joint_value_at(const dm_joint* joint, float share, float* out_value);
dm_result dm_joint_get_frame(const dm_joint* joint, dm_joint_frame* out_frame);
dm_result dm_joint_scale(const dm_joint* joint, dm_vec3 scale, dm_joint* out_joint);
dm_result dm_motion_generate(dm_context* context, dm_object object, const dm_motion_desc* desc, dm_motion* out_motion);
dm_result dm_motion_sample(dm_context* context, dm_motion motion, float t, dm_pose* out_pose, float* out_value);
dm_result dm_motion_get_frames(dm_context* context, dm_motion motion, dm_pose* out_poses, float* out_values);
dm_result dm_motion_destroy(dm_context* context, dm_motion motion);
dm_result dm_drag_begin(dm_context* context, const dm_drag_desc* desc, dm_drag* out_drag);
dm_result dm_drag_update(dm_context* context, dm_drag drag, const dm_ray* ray, float dt, dm_drag_state* out_state);
dm_result dm_drag_step(dm_context* context, dm_drag drag, const dm_drag_input* input, float dt, dm_drag_state* out_state);
dm_result dm_drag_take(dm_context* context, dm_drag drag, float value, dm_drag_state* out_state);
dm_result dm_drag_release(dm_context* context, dm_drag drag, const dm_release_desc* desc, dm_release_plan* out_plan);
dm_result dm_drag_end(dm_context* context, dm_drag drag, dm_part_state* out_state);
dm_result dm_drag_get_part_state(dm_context* context, dm_drag drag, dm_part_state* out_state);
size_t dm_drag_snapshot_size(void);
dm_result dm_drag_save(dm_context* context, dm_drag drag, void* buffer, size_t capacity);
dm_result dm_drag_restore(dm_context* context, dm_drag drag, const void* data, size_t size);
void dm_pose_multiply(const dm_pose* a, const dm_pose* b, dm_pose* out_pose);
void dm_pose_inverse(const dm_pose* pose, dm_pose* out_pose);
dm_result dm_pose_from_rotation(const float rotation[4], dm_vec3 translation, dm_pose* out_pose);
void dm_pose_to_matrix(const dm_pose* pose, float out_matrix[16]);
void dm_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst, size_t dst_stride, size_t count);
dm_result dm_camera_ray(const dm_context* context, const dm_camera* camera, float x, float y, dm_ray* out_ray);
dm_result dm_scene_create(dm_context* context, const dm_scene_desc* desc, dm_scene* out_scene);
dm_result dm_scene_destroy(dm_context* context, dm_scene scene);
dm_result dm_scene_add(dm_context* context, dm_scene scene, dm_object object, const dm_pose* placement, uint32_t* out_instance);
dm_result dm_scene_move(dm_context* context, dm_scene scene, uint32_t instance, uint32_t part_id, const dm_pose* pose);
dm_result dm_scene_remove(dm_context* context, dm_scene scene, uint32_t instance);
dm_result dm_scene_commit(dm_context* context, dm_scene scene);
dm_result dm_scene_pick(dm_context* context, dm_scene scene, const dm_ray* ray, dm_hit* out_hit);
uint32_t dm_gltf_version(void);
dm_result dm_gltf_open(const dm_gltf_desc* desc, dm_gltf** out_gltf);
dm_result dm_gltf_open_file(const char* path, const dm_gltf_desc* desc, dm_gltf** out_gltf);
void dm_gltf_close(dm_gltf* gltf);
uint32_t dm_gltf_node_count(const dm_gltf* gltf);
dm_result dm_gltf_get_node(const dm_gltf* gltf, uint32_t index, dm_gltf_node* out_node);
dm_result dm_gltf_get_mesh(const dm_gltf* gltf, dm_mesh_desc* out_mesh);
void dm_gltf_get_origin(const dm_gltf* gltf, double out_origin[3]);
uint32_t dm_gltf_surface_count(const dm_gltf* gltf);
dm_result dm_gltf_get_surface(dm_gltf* gltf, uint32_t index, dm_gltf_surface* out_surface);
dm_result dm_gltf_get_texture_coordinates(dm_gltf* gltf, uint32_t index, float* out_uv, uint64_t corner_count);
dm_result dm_gltf_mark_faces(const dm_gltf* gltf, const char** names, uint32_t name_count, uint8_t value, uint8_t* inout_face_ids, uint64_t face_count);
dm_result dm_gltf_get_hints(const dm_gltf* gltf, const char* name, char* out_label, size_t label_size, dm_pivot* out_pivot);
dm_result dm_gltf_get_asset(dm_gltf* gltf, uint32_t flags, const dm_asset_node** out_nodes, uint32_t* out_count);
dm_result dm_gltf_get_asset_node(dm_gltf* gltf, uint32_t index, uint32_t* out_node);
int32_t dm_gltf_pivots_are_lost(const dm_gltf* gltf);
dm_result dm_gltf_get_pivot_kind(const dm_gltf* gltf, const char* name, int32_t* out_kind);
int32_t dm_gltf_left_out(const dm_gltf* gltf);
dm_result dm_gltf_read_mask(const dm_gltf* gltf, const void* data, size_t size, const int64_t* mask_value, uint8_t* out_part_ids, int32_t* out_scope, int32_t* out_ambiguous);
dm_result dm_gltf_export(const dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count, void** out_data, size_t* out_size);
void dm_gltf_release_bytes(const dm_gltf* gltf, void* data, size_t size);
dm_result dm_gltf_write(const dm_gltf_part* parts, uint32_t part_count, const dm_allocator* allocator, const dm_log* log, void** out_data, size_t* out_size);
size_t dm_gltf_mend_text(char* text);
dm_result dm_gltf_rig_make(const dm_gltf_rig_desc* desc, dm_gltf_rig** out_rig);
void dm_gltf_rig_destroy(dm_gltf_rig* rig);
uint32_t dm_gltf_rig_file_count(const dm_gltf_rig* rig);
dm_result dm_gltf_rig_get_file(const dm_gltf_rig* rig, uint32_t index, dm_gltf_rig_file* out_file);
dm_result dm_drag_update_input(dm_context* context, dm_drag drag, const dm_drag_input* input, float dt, dm_drag_state* out_state) __asm__("dm_drag_step");
dm_result dm_drag_override(dm_context* context, dm_drag drag, float value, dm_drag_state* out_state) __asm__("dm_drag_take");
