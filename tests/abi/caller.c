/* caller MODELS [--workers N] [--load FILE] [--save FILE] — a host's whole life with one fixed scene: weights, prepare,
 * pick, drag, release, motion. Prints what it gets as numbers that round-trip; the first word of a line tells which
 * call they come from. --load reads a prepared object in prepare's place, --save writes the object.
 * caller --read FILE — prints a prepared object.
 *
 * Uses the public header alone, that of any version: guard.sh compiles it with older and later headers, determinism.sh
 * compares what it prints between compilers and machines. With CALLER_LATER the header has fields that the library does
 * not know (guard.sh): zeros in them are taken, other values refused, and outputs have zeros there. */
#include <pthread.h>
#include <string.h>

#include "cabinet.h"
#include "weights.h"

enum { HELD_FRAMES = 60, RELEASED_FRAMES = 90, STEPS = 60, MOST_WORKERS = 16, GARBAGE = 0xA5, SAMPLES = 5, PICKS = 8 };
static const float frame_time = 1.0f / 60;

static void must(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "caller: %s: %s\n", what, dm_result_string(result));
    exit(1);
}

/* ---- structs of another size than the library's ---- */

/* An output whose bytes are garbage but for its size. */
#define OUTPUT(type, name)                                                                                             \
    type name;                                                                                                         \
    memset(&name, GARBAGE, sizeof name);                                                                               \
    name.struct_size = (uint32_t)sizeof name

#ifdef CALLER_LATER
static void check_zeros(const uint32_t later[CALLER_LATER], const char* what) {
    for (int i = 0; i < CALLER_LATER; i++) {
        if (later[i] == 0) continue;
        fprintf(stderr, "caller: %s: the library has left garbage in a field that it does not know\n", what);
        exit(1);
    }
}

static void must_refuse(dm_result result, const char* what) {
    if (result == DM_ERROR_STRUCT_SIZE) return;
    fprintf(stderr, "caller: %s: a field that the library does not know is set: %s\n", what, dm_result_string(result));
    exit(1);
}
#define CHECK_LATER(output) check_zeros((output).later, #output)
#else
#define CHECK_LATER(output) (void)(output)
#endif

/* ---- printing ---- */

static void print(const char* name, const float* values, int count) {
    printf("%s", name);
    for (int i = 0; i < count; i++) printf(" %.9g", (double)values[i]);
    printf("\n");
}

static void print_pose(const char* name, const dm_pose* pose, float value) {
    const float numbers[9] = {value,         pose->real[0], pose->real[1], pose->real[2], pose->real[3],
                              pose->dual[0], pose->dual[1], pose->dual[2], pose->dual[3]};
    print(name, numbers, 9);
}

static void print_joint(const char* name, const dm_joint* joint) {
    const dm_vec3 axis = joint->axis, origin = joint->origin;
    const float numbers[11] = {axis.x,
                               axis.y,
                               axis.z,
                               origin.x,
                               origin.y,
                               origin.z,
                               joint->lower,
                               joint->upper,
                               joint->pitch,
                               joint->type_confidence,
                               joint->joint_confidence};
    printf("%s type %d source %d\n", name, joint->type, joint->source);
    print(name, numbers, 11);
}

static void print_state(const char* name, const dm_drag_state* state) {
    const float numbers[6] = {state->target,       state->velocity,     state->impact,
                              state->grab_point.x, state->grab_point.y, state->grab_point.z};
    printf("%s phase %d limit %d changes %u events %u detents %u\n", name, state->phase, state->at_limit,
           state->changes, state->events, state->detents);
    print(name, numbers, 6);
    print_pose(name, &state->pose, state->value);
}

/* ---- the host's threads ---- */

typedef struct batch {
    pthread_mutex_t lock;
    dm_task task;
    void* data;
    uint32_t next, count;
} batch;

static void* work(void* user) {
    batch* b = user;
    for (;;) {
        pthread_mutex_lock(&b->lock);
        const uint32_t index = b->next++;
        pthread_mutex_unlock(&b->lock);
        if (index >= b->count) return NULL;
        b->task(b->data, index);
    }
}

/* user: how many threads work, the caller's not counted. */
static int32_t DM_CALL parallel_for(void* user, uint32_t count, dm_task task, void* data) {
    batch b = {.task = task, .data = data, .count = count};
    pthread_t threads[MOST_WORKERS];
    int started = 0;
    pthread_mutex_init(&b.lock, NULL);
    while (started < *(int*)user && pthread_create(&threads[started], NULL, work, &b) == 0) started++;
    work(&b);
    for (int i = 0; i < started; i++) pthread_join(threads[i], NULL);
    pthread_mutex_destroy(&b.lock);
    return 1;
}

/* ---- the object ---- */

static dm_object prepare(dm_context* context, dm_model model) {
    static cabinet arrays;
    const dm_mesh_desc mesh = cabinet_make(&arrays);
    dm_part_desc parts[2] = {dm_part_desc_default(), dm_part_desc_default()};
    parts[0].id = CABINET_DOOR, parts[0].label = "kitchen/cabinet/door";
    parts[1].id = CABINET_DRAWER;
    dm_object_desc desc = dm_object_desc_default();
    desc.mesh = &mesh, desc.parts = parts, desc.part_count = 2, desc.model = model, desc.seed = 1;
    dm_object object;
    must(dm_object_prepare(context, &desc, &object), "prepare");
#ifdef CALLER_LATER
    dm_object refused;
    desc.later[CALLER_LATER - 1] = 1;
    must_refuse(dm_object_prepare(context, &desc, &refused), "dm_object_desc");
    desc.later[CALLER_LATER - 1] = 0, parts[1].later[0] = 1;
    must_refuse(dm_object_prepare(context, &desc, &refused), "dm_part_desc");
#endif
    return object;
}

static dm_object load(dm_context* context, dm_model model, const char* path) {
    size_t size;
    void* data = read_whole(path, &size);
    dm_object object;
    must(dm_object_load(context, data, size, model, &object), path);
    free(data);
    return object;
}

static void save(dm_context* context, dm_object object, const char* path) {
    size_t size = 0;
    must(dm_object_save(context, object, NULL, 0, &size), "size");
    void* data = malloc(size);
    FILE* file = fopen(path, "wb");
    if (data == NULL || file == NULL) exit(1);
    must(dm_object_save(context, object, data, size, &size), "save");
    if (fwrite(data, 1, size, file) != size || fclose(file) != 0) exit(1);
    free(data);
}

static void print_hypotheses(dm_context* context, dm_object object, uint32_t part, const dm_drag_hint* hint) {
    dm_joint ranked[DM_MAX_HYPOTHESES];
    uint32_t count;
    memset(ranked, GARBAGE, sizeof ranked);
    ranked[0].struct_size = (uint32_t)sizeof *ranked;
    must(dm_object_get_hypotheses(context, object, part, hint, ranked, DM_MAX_HYPOTHESES, &count), "hypotheses");
    printf("prepare hypotheses %u\n", count);
    for (uint32_t i = 0; i < count; i++) {
        CHECK_LATER(ranked[i]);
        print_joint("prepare", &ranked[i]);
    }
}

static void print_object(dm_context* context, dm_object object) {
    OUTPUT(dm_object_info, whole);
    must(dm_object_get_info(context, object, &whole), "info");
    CHECK_LATER(whole);
    printf("prepare parts %u triangles %u pickable %u\n", whole.part_count, (unsigned)whole.triangle_count,
           whole.pickable);
    print("prepare", &whole.size, 1);
    for (uint32_t i = 0; i < whole.part_count; i++) {
        OUTPUT(dm_part_info, part);
        OUTPUT(dm_joint, joint);
        OUTPUT(dm_joint_frame, frame);
        must(dm_object_get_part(context, object, i, &part), "part");
        CHECK_LATER(part);
        printf("prepare part %u of %u triangles %u\n", part.id, part.parent, part.triangle_count);
        print("prepare", &part.centre.x, 3);
        must(dm_object_get_joint(context, object, part.id, &joint), "joint");
        CHECK_LATER(joint);
        print_joint("prepare", &joint);
        must(dm_joint_get_frame(&joint, &frame), "frame");
        CHECK_LATER(frame);
        print("prepare", frame.rotation, 4);
        print_hypotheses(context, object, part.id, NULL);
    }
}

/* ---- drags ---- */

/* From the camera, past the point in an arc to the left and towards the camera. */
static dm_ray ray_at(int frame, dm_vec3 grab) {
    const float away = 0.008f * (float)frame;
    const dm_vec3 eye = {grab.x + 0.2f, grab.y + 0.5f, grab.z + 1.6f};
    const dm_vec3 seen = {grab.x - 0.6f * away, grab.y, grab.z + away};
    return (dm_ray){eye, {seen.x - eye.x, seen.y - eye.y, seen.z - eye.z}};
}

/* Where a ray from the front meets a part. */
static dm_vec3 pick(dm_context* context, dm_object object, dm_vec3 towards) {
    const dm_scene_desc desc = dm_scene_desc_default();
    const dm_ray ray = {{towards.x, towards.y, towards.z + 2}, {0, 0, -1}};
    dm_scene scene;
    uint32_t instance;
    OUTPUT(dm_hit, hit);
    must(dm_scene_create(context, &desc, &scene), "scene");
    must(dm_scene_add(context, scene, object, NULL, &instance), "add");
    must(dm_scene_commit(context, scene), "commit");
    must(dm_scene_pick(context, scene, &ray, &hit), "pick");
    CHECK_LATER(hit);
    must(dm_scene_destroy(context, scene), "destroy");
    printf("pick part %u instance %u\n", hit.part_id, hit.instance);
    print("pick", &hit.object_point.x, 3);
    return hit.object_point;
}

/* What rays hit that come from the front, side by side. */
static void print_picks(dm_context* context, dm_object object) {
    const dm_scene_desc desc = dm_scene_desc_default();
    dm_scene scene;
    uint32_t instance;
    must(dm_scene_create(context, &desc, &scene), "scene");
    must(dm_scene_add(context, scene, object, NULL, &instance), "add");
    must(dm_scene_commit(context, scene), "commit");
    for (int i = 0; i < PICKS * PICKS; i++) {
        const float x = (float)(i % PICKS) / PICKS, y = (float)(i / PICKS) / PICKS;
        const dm_ray ray = {{x, y, 5}, {0.01f, 0.02f, -1}};
        OUTPUT(dm_hit, hit);
        must(dm_scene_pick(context, scene, &ray, &hit), "pick");
        CHECK_LATER(hit);
        if (hit.object == 0) continue;
        printf("pick ray %d part %u triangle %u\n", i, hit.part_id, hit.triangle);
        print("pick", &hit.object_point.x, 3);
    }
    must(dm_scene_destroy(context, scene), "destroy");
}

/* Drags a part, lets go of it, and takes it again where it has come to rest. flags: DM_RELEASE_*. */
static void drag_and_release(dm_context* context, dm_object object, uint32_t part, dm_vec3 grab, uint32_t flags) {
    const char* after = flags & DM_RELEASE_BY_RULE ? "release" : "paced";
    dm_drag_rules rules = dm_drag_rules_default();
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag drag;
    OUTPUT(dm_drag_state, state);
    desc.object = object, desc.part_id = part, desc.grab_point = grab, desc.rules = &rules;
    desc.feel.soft_limit = 0.1f, desc.feel.coast_time = 0.3f;
    must(dm_drag_begin(context, &desc, &drag), "begin");
#ifdef CALLER_LATER
    dm_drag refused;
    desc.later[0] = 1;
    must_refuse(dm_drag_begin(context, &desc, &refused), "dm_drag_desc");
    desc.later[0] = 0, rules.later[0] = 1;
    must_refuse(dm_drag_begin(context, &desc, &refused), "dm_drag_rules");
    rules.later[0] = 0;
#endif
    for (int frame = 0; frame < HELD_FRAMES; frame++) {
        const dm_ray ray = ray_at(frame, grab);
        must(dm_drag_update(context, drag, &ray, frame_time, &state), "update");
        CHECK_LATER(state);
        print_state("drag", &state);
    }
    dm_release_desc release = dm_release_desc_default();
    OUTPUT(dm_release_plan, plan);
    release.intent = DM_INTENT_OPEN, release.flags = flags;
    must(dm_drag_release(context, drag, &release, &plan), "release");
    CHECK_LATER(plan);
    printf("%s intent %d\n", after, plan.intent);
    print(after, &plan.end_value, 1);
    for (int frame = 0; frame < RELEASED_FRAMES; frame++) {
        must(dm_drag_update(context, drag, NULL, frame_time, &state), "released");
        print_state(after, &state);
    }
    OUTPUT(dm_part_state, end);
    must(dm_drag_end(context, drag, &end), "end");
    print_joint(after, &end.joint);
    desc.grab_point = state.grab_point, desc.state = &end;
    must(dm_drag_begin(context, &desc, &drag), "begin again");
    OUTPUT(dm_part_state, again);
    must(dm_drag_get_part_state(context, drag, &again), "part state");
    print_pose(after, &again.pose, again.value);
    must(dm_drag_end(context, drag, NULL), "end again");
}

/* A stick drives a part against the room that the host's world leaves it. */
static void drive(dm_context* context, dm_object object, uint32_t part) {
    static const float snaps[2] = {0.05f, 0.1f}; /* host units */
    dm_drag_rules rules = dm_drag_rules_default();
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag_input input = dm_drag_input_default();
    dm_drag drag;
    OUTPUT(dm_drag_state, state);
    rules.snaps = snaps, rules.snap_count = 2, rules.max_speed = 1;
    desc.object = object, desc.part_id = part, desc.flags = DM_DRAG_WITHOUT_POINT, desc.rules = &rules;
    input.hand.kind = DM_HAND_RATE, input.hand.amount = 1, input.lower = -0.15f, input.upper = 0.15f;
    must(dm_drag_begin(context, &desc, &drag), "begin without a point");
    for (int frame = 0; frame < STEPS; frame++) {
        must(dm_drag_step(context, drag, &input, frame_time, &state), "step");
        CHECK_LATER(state);
        print_state("drag", &state);
    }
#ifdef CALLER_LATER
    input.later[1] = 1;
    must_refuse(dm_drag_step(context, drag, &input, frame_time, &state), "dm_drag_input");
#endif
    must(dm_drag_end(context, drag, NULL), "end without a point");
}

/* ---- motions ---- */

static void generate(dm_context* context, dm_object object, uint32_t part, dm_vec3 grab) {
    dm_motion_desc desc = dm_motion_desc_default();
    dm_pose poses[DM_MOTION_FRAMES], pose;
    float values[DM_MOTION_FRAMES], value;
    dm_motion motion;
    desc.part_id = part, desc.drag = (dm_drag_hint){grab, {0, 0, 0.2f}}, desc.seed = 7;
    must(dm_motion_generate(context, object, &desc, &motion), "generate");
    must(dm_motion_get_frames(context, motion, poses, values), "frames");
    for (int i = 0; i < DM_MOTION_FRAMES; i++) print_pose("motion", &poses[i], values[i]);
    for (int i = 0; i < SAMPLES; i++) {
        must(dm_motion_sample(context, motion, (float)i / (SAMPLES - 1), &pose, &value), "sample");
        print_pose("motion", &pose, value);
    }
    must(dm_motion_destroy(context, motion), "destroy");
}

static void live(dm_context* context, dm_object object) {
    const dm_vec3 door = pick(context, object, (dm_vec3){0.55f, 0.45f, 0});
    const dm_vec3 drawer = pick(context, object, (dm_vec3){0.3f, 0.88f, 0});
    print_hypotheses(context, object, CABINET_DOOR, &(dm_drag_hint){door, {0, 0, 0.2f}});
    drag_and_release(context, object, CABINET_DOOR, door, DM_RELEASE_BY_RULE);
    drag_and_release(context, object, CABINET_DRAWER, drawer, DM_RELEASE_BY_RULE);
    drag_and_release(context, object, CABINET_DOOR, door, 0);
    drive(context, object, CABINET_DRAWER);
    generate(context, object, CABINET_DOOR, door);
    OUTPUT(dm_memory_info, memory);
    must(dm_context_get_memory(context, &memory), "memory");
    CHECK_LATER(memory);
}

int main(int argc, char** argv) {
    const char *read = NULL, *from = NULL, *to = NULL;
    int workers = 0;
    for (int i = 1; i + 1 < argc; i++) {
        if (strcmp(argv[i], "--read") == 0) read = argv[i + 1];
        if (strcmp(argv[i], "--load") == 0) from = argv[i + 1];
        if (strcmp(argv[i], "--save") == 0) to = argv[i + 1];
        if (strcmp(argv[i], "--workers") == 0) workers = atoi(argv[i + 1]) - 1;
    }
    if (argc < 2 || workers < 0 || workers > MOST_WORKERS) return 2;
    dm_context_desc host = dm_context_desc_default();
    dm_context* context;
    dm_model model = 0;
    host.log.message = print_message;
    if (workers > 0) host.jobs = (dm_jobs){&workers, parallel_for};
    must(dm_context_create(&host, &context), "context");
    if (read != NULL) {
        const dm_object object = load(context, 0, read);
        print_object(context, object);
        print_picks(context, object);
    } else {
        must(load_weights(context, argv[1], &model), "weights");
        const dm_object object = from != NULL ? load(context, model, from) : prepare(context, model);
        print_object(context, object);
        if (to != NULL) save(context, object, to);
        live(context, object);
    }
    dm_context_destroy(context);
    return 0;
}
