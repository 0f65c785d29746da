/* dragmesh bench: times the library's calls (median, 99th percentile, cold caches) and counts their allocations. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench_objects.h"
#include "box_object.h"
#include "json.h"
#include "options.h"
#include "platform.h"
#include "runs.h"
#include "session.h"
#include "session_open.h"
#include "timing.h"

enum {
    /* By hand, for the time of a run. */
    GRID = 34,             /* squares a box side: 97104 triangles */
    COLD_BYTES = 64 << 20, /* read before a cold call: more than the caches hold */
    COLD_ROUNDS = 9,       /* of each row */
    MAX_ROUNDS = 20000,    /* of each row, with warm caches */
    POINTS = 100000,       /* of the bulk transform */
    MANY_MOTIONS = 10000,  /* sampled together, as a game's frame does */
    LONG_NS = 20000        /* calls above this are timed by the thread's clock */
};
static const double row_ms = 250; /* spent on each row's warm rounds */

typedef struct counter {
    unsigned long long calls;
} counter;

static void* count_allocate(void* user, size_t size, size_t alignment) {
    ((counter*)user)->calls++;
    return platform_allocate(size, alignment < sizeof(void*) ? sizeof(void*) : alignment);
}

static void count_release(void* user, void* memory, size_t size) {
    (void)user;
    (void)size;
    platform_release(memory);
}

typedef struct saved_object {
    void* data; /* .dmo */
    size_t size;
} saved_object;

typedef struct bench {
    session session;
    counter counter;
    box_object shape;
    dm_mesh_desc mesh;
    dm_motion motion;
    dm_drag drag, ruled; /* without rules, with all of them */
    dm_scene scene;
    uint32_t instance;
    dm_camera camera;
    dm_pose pose;
    saved_object saved, saved_bare; /* with and without triangles */
    dm_motion many_motions[MANY_MOTIONS];
    float* points;
    clockid_t clock;
    double clock_ns; /* what reading it costs */
    unsigned round;  /* of the row, so that no two calls in a row are the same */
} bench;

/* Returns a number in [0, 1] that changes with every round. */
static float wave(const bench* b) {
    return (float)(b->round % 101) / 100;
}

/* ---- the calls: each is one round of its row ---- */

static dm_result prepare_with(bench* b, uint32_t flags, dm_object* out_object) {
    const dm_part_desc part = {.struct_size = sizeof part, .id = 1, .drag = &box_object_drag};
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .flags = flags,
                                 .mesh = &b->mesh,
                                 .parts = &part,
                                 .part_count = 1,
                                 .model = b->session.model,
                                 .seed = b->round};
    return dm_object_prepare(b->session.context, &desc, out_object);
}

static dm_result prepare_and_destroy(bench* b, uint32_t flags) {
    dm_object object;
    const dm_result result = prepare_with(b, flags, &object);
    return result == DM_OK ? dm_object_destroy(b->session.context, object) : result;
}

static dm_result call_object_prepare(bench* b) {
    return prepare_and_destroy(b, 0);
}

static dm_result call_object_prepare_bare(bench* b) {
    return prepare_and_destroy(b, DM_PREPARE_WITHOUT_PICKING);
}

static dm_result call_object_refine(bench* b) {
    return dm_object_refine(b->session.context, b->session.object, 1, &box_object_drag);
}

static dm_result call_object_get_hypotheses(bench* b) {
    dm_joint joints[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *joints}};
    uint32_t count;
    return dm_object_get_hypotheses(b->session.context, b->session.object, 1, &box_object_drag, joints,
                                    DM_MAX_HYPOTHESES, &count);
}

static dm_result call_object_save(bench* b) {
    return dm_object_save(b->session.context, b->session.object, b->saved.data, b->saved.size, &b->saved.size);
}

static dm_result load_and_destroy(bench* b, const saved_object* saved) {
    dm_object object;
    const dm_result result = dm_object_load(b->session.context, saved->data, saved->size, b->session.model, &object);
    return result == DM_OK ? dm_object_destroy(b->session.context, object) : result;
}

static dm_result call_object_load(bench* b) {
    return load_and_destroy(b, &b->saved);
}

static dm_result call_object_load_bare(bench* b) {
    return load_and_destroy(b, &b->saved_bare);
}

static dm_result call_motion_generate(bench* b) {
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = 1, .drag = box_object_drag, .seed = b->round};
    dm_motion motion;
    const dm_result result = dm_motion_generate(b->session.context, b->session.object, &desc, &motion);
    return result == DM_OK ? dm_motion_destroy(b->session.context, motion) : result;
}

static dm_result call_motion_sample(bench* b) {
    return dm_motion_sample(b->session.context, b->motion, wave(b), &b->pose, NULL);
}

/* Samples all motions, as a game's frame does. */
static dm_result call_motion_sample_many(bench* b) {
    dm_result result = DM_OK;
    for (int i = 0; i < MANY_MOTIONS && result == DM_OK; i++)
        result = dm_motion_sample(b->session.context, b->many_motions[i], wave(b), &b->pose, NULL);
    return result;
}

static dm_ray pulling_ray(const bench* b) {
    return (dm_ray){{0.6f, 0.9f, 2}, {-0.4f - 0.2f * wave(b), -0.5f, -1.9f}};
}

static dm_result call_drag_update(bench* b) {
    const dm_ray ray = pulling_ray(b);
    dm_drag_state state = {.struct_size = sizeof state};
    return dm_drag_update(b->session.context, b->drag, &ray, 1 / 60.0f, &state);
}

/* An update of a drag with all rules, told of handles and bounds. */
static dm_result step_ruled(bench* b, dm_drag_input* input, dm_drag_state* out_state) {
    input->hand = (dm_hand){.kind = DM_HAND_RAY, .ray = pulling_ray(b)};
    input->handles[0] = 1, input->lower = -1, input->upper = 3;
    return dm_drag_update_input(b->session.context, b->ruled, input, 1 / 60.0f, out_state);
}

static dm_result call_drag_step(bench* b) {
    dm_drag_input input = dm_drag_input_default();
    dm_drag_state state = dm_drag_state_default();
    return step_ruled(b, &input, &state);
}

/* The same with a second hand, and a host that takes another value. */
static dm_result call_drag_step_two_hands(bench* b) {
    dm_drag_input input = dm_drag_input_default();
    dm_drag_state state = dm_drag_state_default();
    input.second = (dm_hand){.kind = DM_HAND_POINT, .grab_point = box_object_drag.point, .point = {0, 0.5f, 0.5f}};
    input.flags = DM_INPUT_ASK;
    const dm_result result = step_ruled(b, &input, &state);
    return result == DM_OK ? dm_drag_override(b->session.context, b->ruled, 0.99f * state.value, &state) : result;
}

static dm_result call_joint_pose(bench* b) {
    const dm_joint hinge = {.struct_size = sizeof hinge,
                            .type = DM_JOINT_REVOLUTE,
                            .axis = {0, 1, 0},
                            .origin = {-0.25f, 0.4f, 0.01f},
                            .upper = 2};
    return dm_joint_pose(&hinge, wave(b), &b->pose);
}

static dm_result call_pose_apply_points(bench* b) {
    dm_pose_apply_points(&b->pose, b->points, 0, b->points, 0, POINTS);
    return DM_OK;
}

static dm_result call_camera_ray(bench* b) {
    dm_ray ray;
    return dm_camera_ray(b->session.context, &b->camera, 1000 * wave(b), 500, &ray);
}

static dm_result call_scene_move(bench* b) {
    return dm_scene_move(b->session.context, b->scene, b->instance, 1, &b->pose);
}

static dm_result call_scene_commit(bench* b) {
    return dm_scene_commit(b->session.context, b->scene);
}

static dm_result call_scene_pick(bench* b) {
    const dm_ray ray = {{0.6f, 0.9f, 2}, {-0.6f - 0.2f * wave(b), -0.5f, -2}};
    dm_hit hit = {.struct_size = sizeof hit};
    return dm_scene_pick(b->session.context, b->scene, &ray, &hit);
}

typedef struct row {
    const char* name;
    dm_result (*call)(bench* b);
    int needs_model;               /* 1: kinematics weights, 2: motion weights */
    dm_result (*before)(bench* b); /* not timed; NULL: nothing */
} row;

static const row rows[] = {{"object_prepare", call_object_prepare, 0, NULL},
                           {"object_prepare_bare", call_object_prepare_bare, 0, NULL},
                           {"object_refine", call_object_refine, 1, NULL},
                           {"object_get_hypotheses", call_object_get_hypotheses, 0, NULL},
                           {"object_save", call_object_save, 0, NULL},
                           {"object_load", call_object_load, 0, NULL},
                           {"object_load_bare", call_object_load_bare, 0, NULL},
                           {"motion_generate", call_motion_generate, 2, NULL},
                           {"motion_sample", call_motion_sample, 2, NULL},
                           {"motion_sample_10000", call_motion_sample_many, 2, NULL},
                           {"drag_update", call_drag_update, 0, NULL},
                           {"drag_step_ruled", call_drag_step, 0, NULL},
                           {"drag_step_two_hands", call_drag_step_two_hands, 0, NULL},
                           {"joint_pose", call_joint_pose, 0, NULL},
                           {"pose_apply_points", call_pose_apply_points, 0, NULL},
                           {"camera_ray", call_camera_ray, 0, NULL},
                           {"scene_move", call_scene_move, 0, NULL},
                           {"scene_commit", call_scene_commit, 0, call_scene_move},
                           {"scene_pick", call_scene_pick, 0, NULL}};
enum { ROWS = sizeof rows / sizeof *rows };

/* ---- measuring ---- */

typedef struct timing {
    double median_ns, p99_ns, cold_ns;
    unsigned long long allocations; /* of one call */
} timing;

static double timed(bench* b, const row* row, dm_result* result) {
    b->round++;
    if (row->before != NULL) row->before(b);
    const double start = timing_now_ns(b->clock);
    const dm_result now = row->call(b);
    const double ns = timing_now_ns(b->clock) - start;
    if (now != DM_OK) *result = now;
    return fmax(ns - b->clock_ns, 0);
}

/* Returns the time of reading a clock: the median of empty measurements. */
static double clock_cost(clockid_t clock) {
    double ns[COLD_ROUNDS * COLD_ROUNDS];
    for (int i = 0; i < COLD_ROUNDS * COLD_ROUNDS; i++) {
        const double start = timing_now_ns(clock);
        ns[i] = timing_now_ns(clock) - start;
    }
    timing_sort(ns, (size_t)COLD_ROUNDS * COLD_ROUNDS);
    return ns[COLD_ROUNDS * COLD_ROUNDS / 2];
}

/* Chooses the monotonic clock for short calls, which the thread's clock is too slow for, and the thread's processor
 * time for long ones, which other programs then hardly affect. */
static void choose_clock(bench* b, const row* row, dm_result* result) {
    b->clock = CLOCK_MONOTONIC;
    b->clock_ns = 0;
    timed(b, row, result);
    if (timed(b, row, result) > LONG_NS) b->clock = CLOCK_THREAD_CPUTIME_ID;
    b->clock_ns = clock_cost(b->clock);
}

/* Evicts the call's data from the caches. */
static void evict_caches(unsigned char* cold) {
    for (size_t i = 0; i < COLD_BYTES; i += 64 /* a cache line */) cold[i]++;
}

static dm_result measure(bench* b, const row* row, unsigned char* cold, timing* out) {
    dm_result result = DM_OK;
    double* ns = cli_alloc(MAX_ROUNDS * sizeof *ns);
    b->round = 0; /* rays begin at the grabbed point, as a player's do: a drag costs by where it was begun */
    choose_clock(b, row, &result);
    for (int i = 0; i < COLD_ROUNDS; i++) {
        evict_caches(cold);
        ns[i] = timed(b, row, &result);
    }
    timing_sort(ns, COLD_ROUNDS);
    out->cold_ns = ns[COLD_ROUNDS / 2];
    const unsigned long long before = b->counter.calls;
    timed(b, row, &result);
    out->allocations = b->counter.calls - before;
    size_t rounds = 0;
    const double end = cli_now_ms() + row_ms;
    while (rounds < COLD_ROUNDS || (rounds < MAX_ROUNDS && cli_now_ms() < end)) ns[rounds++] = timed(b, row, &result);
    timing_sort(ns, rounds);
    out->median_ns = ns[rounds / 2];
    out->p99_ns = ns[rounds * 99 / 100];
    free(ns);
    return result;
}

/* ---- setting up ---- */

static dm_result save(bench* b, dm_object object, saved_object* out) {
    dm_result result = dm_object_save(b->session.context, object, NULL, 0, &out->size);
    if (result != DM_OK) return result;
    out->data = cli_alloc(out->size);
    return dm_object_save(b->session.context, object, out->data, out->size, &out->size);
}

static dm_result set_up_objects(bench* b) {
    dm_object bare;
    dm_result result = prepare_with(b, DM_PREPARE_WITHOUT_PICKING, &bare);
    if (result == DM_OK) result = save(b, bare, &b->saved_bare);
    if (result == DM_OK) result = dm_object_destroy(b->session.context, bare);
    if (result == DM_OK) result = prepare_with(b, 0, &b->session.object);
    return result == DM_OK ? save(b, b->session.object, &b->saved) : result;
}

static dm_result set_up_motion(bench* b) {
    const dm_motion_desc motion = {.struct_size = sizeof motion, .part_id = 1, .drag = box_object_drag};
    if (!b->session.has_motion) return DM_OK;
    dm_result result = dm_motion_generate(b->session.context, b->session.object, &motion, &b->motion);
    for (int i = 0; i < MANY_MOTIONS && result == DM_OK; i++)
        result = dm_motion_generate(b->session.context, b->session.object, &motion, &b->many_motions[i]);
    return result;
}

/* Begins a drag with everything on. */
static dm_result begin_ruled(bench* b) {
    static const float snaps[3] = {0.2f, 0.6f, 1.2f};
    const dm_drag_rules rules = {.struct_size = sizeof rules,
                                 .flags = DM_RULE_LATCH,
                                 .snaps = snaps,
                                 .snap_count = 3,
                                 .event_time = 0.1f,
                                 .max_speed = 20,
                                 .max_acceleration = 400,
                                 .auto_close_share = 0.1f,
                                 .close_delay = 1,
                                 .tip_share = 0.5f,
                                 .restitution = 0.3f,
                                 .break_distance = 10};
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = 1,
                               .object = b->session.object,
                               .grab_point = box_object_drag.point,
                               .feel = {.soft_limit = 0.05f},
                               .rules = &rules};
    return dm_drag_begin(b->session.context, &desc, &b->ruled);
}

static dm_result set_up(bench* b) {
    dm_context* context = b->session.context;
    b->shape = box_object_new(GRID);
    b->mesh = box_object_mesh(&b->shape);
    b->pose = (dm_pose){{0, 0.08715574f, 0, 0.9961947f}, {0, 0, 0, 0}}; /* 10 degrees about y */
    b->points = cli_alloc_zeroed(3 * sizeof(float) * POINTS);
    b->camera = (dm_camera){.struct_size = sizeof b->camera,
                            .fov_y = 0.8f,
                            .eye = {0, 1, 3},
                            .forward = {0, -0.2f, -1},
                            .up = {0, 1, 0},
                            .viewport_width = 1920,
                            .viewport_height = 1080};
    dm_result result = set_up_objects(b);
    if (result != DM_OK) return result;
    const dm_drag_desc drag = {
        .struct_size = sizeof drag, .part_id = 1, .object = b->session.object, .grab_point = box_object_drag.point};
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    result = set_up_motion(b);
    if (result == DM_OK) result = dm_drag_begin(context, &drag, &b->drag);
    if (result == DM_OK) result = begin_ruled(b);
    if (result == DM_OK) result = dm_scene_create(context, &scene, &b->scene);
    if (result == DM_OK) result = dm_scene_add(context, b->scene, b->session.object, NULL, &b->instance);
    return result == DM_OK ? dm_scene_commit(context, b->scene) : result;
}

static void tear_down(bench* b) {
    free(b->points);
    free(b->saved.data);
    free(b->saved_bare.data);
    box_object_free(&b->shape);
    session_close(&b->session);
}

static dm_result run_rows(bench* b, int as_json) {
    unsigned char* cold = cli_alloc_zeroed(COLD_BYTES);
    cJSON* out = cJSON_CreateObject();
    cJSON_AddStringToObject(out, "isa", timing_isa());
    cJSON_AddNumberToObject(out, "triangles", b->shape.face_count);
    cJSON_AddNumberToObject(out, "points", POINTS);
    cJSON_AddNumberToObject(out, "dmo_bytes", (double)b->saved.size);
    cJSON_AddNumberToObject(out, "dmo_bare_bytes", (double)b->saved_bare.size);
    cJSON* list = cJSON_AddArrayToObject(out, "rows");
    dm_result result = DM_OK;
    if (!as_json) printf("%-24s %12s %12s %12s %7s\n", timing_isa(), "median ns", "p99 ns", "cold ns", "allocs");
    for (int i = 0; i < ROWS && result == DM_OK; i++) {
        timing t;
        if ((rows[i].needs_model == 1 && !b->session.model) || (rows[i].needs_model == 2 && !b->session.has_motion))
            continue;
        result = measure(b, &rows[i], cold, &t);
        cJSON* item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", rows[i].name);
        json_add_number(item, "median_ns", round(t.median_ns), 12);
        json_add_number(item, "p99_ns", round(t.p99_ns), 12);
        json_add_number(item, "cold_ns", round(t.cold_ns), 12);
        cJSON_AddNumberToObject(item, "allocs", (double)t.allocations);
        cJSON_AddItemToArray(list, item);
        if (!as_json)
            printf("%-24s %12.0f %12.0f %12.0f %7llu\n", rows[i].name, t.median_ns, t.p99_ns, t.cold_ns, t.allocations);
    }
    if (as_json && result == DM_OK)
        json_print(out);
    else
        cJSON_Delete(out);
    free(cold);
    return result;
}

static int run_cabinet(bench* b, int as_json) {
    dm_result result = set_up(b);
    if (result == DM_OK) result = run_rows(b, as_json);
    if (result != DM_OK) fprintf(stderr, "dragmesh: %s\n", b->session.error);
    return result == DM_OK ? CLI_OK : CLI_FAILED;
}

int bench_run(const cli_command* command, int argc, char** argv) {
    const char *models = NULL, *folder = NULL;
    int as_json = 0;
    const option_spec table[] = {{.name = "--models", .kind = OPTION_TEXT, .value = &models},
                                 {.name = "--json", .kind = OPTION_FLAG, .value = &as_json}};
    bench* b = cli_alloc_zeroed(sizeof *b);
    const dm_allocator allocator = {&b->counter, count_allocate, count_release};
    int status = options_read(command, argc, argv, table, 2, &folder);
    if (status == CLI_OK) status = session_open(&b->session, models, &allocator);
    if (status == CLI_OK) {
        status = folder != NULL ? bench_objects(&b->session, folder, as_json) : run_cabinet(b, as_json);
        tear_down(b);
    }
    free(b);
    return status;
}
