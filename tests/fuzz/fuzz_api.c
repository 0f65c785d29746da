/* Fuzz target: the whole interface, call after call. An input is a sequence of calls: for each a byte that names it and
 * the bytes of its arguments. Handles may be stale, null, of another kind or another context; memory runs out; hooks
 * call other contexts back; preparations are cancelled.
 *
 * Holds throughout: every answer is a result of the header's, INTERNAL never; outputs are finite after DM_OK and
 * untouched after an error; memory is given back in the sizes in which it was lent, and all of it in the end. */
#include "cabinet.h"
#include "host.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { CONTEXTS = 2, MAX_HANDLES = 32, MAX_CALLS = 200, MAX_PREPARES = 2, HOOK_CALLS = 3 };
enum { UNTOUCHED = 0xa5 }; /* every byte of an output before a call */

typedef enum handle_kind { OBJECT, DRAG, SCENE, MOTION, HANDLE_KINDS } handle_kind;

typedef struct handle {
    uint64_t id;
    handle_kind kind;
} handle;

typedef struct player {
    fuzz_input* in;
    fuzz_host hosts[CONTEXTS];
    dm_context* contexts[CONTEXTS];
    handle handles[MAX_HANDLES];
    uint32_t handle_count, prepares;
} player;

static player now;
static uint8_t saved_object[1u << 20];
static size_t saved_size;
static uint8_t saved_drag[DM_DRAG_SNAPSHOT_MAX];
static bool has_saved_drag;

/* ---- what must hold ---- */

/* Checks a result, and that an error has left the `size` bytes of the output as they were, struct_size apart. */
static bool is_ok(dm_result result, const void* output, size_t size) {
    fuzz_expect_result(result);
    const uint8_t* bytes = output;
    for (size_t i = 0; result != DM_OK && i < size; i++) fuzz_expect(bytes[i] == UNTOUCHED);
    return result == DM_OK;
}

/* Makes an output whose bytes are all UNTOUCHED, but for its struct_size. */
#define OUTPUT(type, name)                                                                                             \
    type name;                                                                                                         \
    memset(&name, UNTOUCHED, sizeof name);                                                                             \
    name.struct_size = sizeof name

/* is_ok for such an output. */
#define OK(result, name) is_ok(result, (const uint8_t*)&(name) + sizeof(uint32_t), sizeof(name) - sizeof(uint32_t))

/* ---- handles ---- */

static void keep(handle_kind kind, uint64_t id) {
    const uint32_t at = now.handle_count < MAX_HANDLES ? now.handle_count++ : fuzz_below(now.in, MAX_HANDLES);
    now.handles[at] = (handle){id, kind};
}

/* Mostly one of the kind that is asked for. */
static uint64_t any_handle(handle_kind kind) {
    const uint8_t way = fuzz_byte(now.in);
    if (now.handle_count == 0 || way >= 250) return way % 2 ? fuzz_word(now.in) : 0;
    const uint32_t first = fuzz_below(now.in, now.handle_count);
    for (uint32_t i = 0; i < now.handle_count && way < 240; i++) {
        const handle* found = &now.handles[(first + i) % now.handle_count];
        if (found->kind == kind) return found->id;
    }
    return now.handles[first].id;
}

static uint32_t any_part(void) {
    const uint8_t way = fuzz_byte(now.in);
    if (way >= 250) return fuzz_word(now.in);
    return way < 200 ? 1u + way % CABINET_PARTS : way % (CABINET_PARTS + 2u);
}

/* ---- arguments ---- */

static dm_drag_hint any_hint(void) {
    dm_drag_hint hint = {cabinet_grab, {0, 0, 1}};
    if (fuzz_one_in(now.in, 3)) hint.point = fuzz_vector(now.in);
    if (fuzz_one_in(now.in, 2)) hint.vector = fuzz_vector(now.in);
    return hint;
}

static dm_pose any_pose(void) {
    dm_pose pose = {{0, 0, 0, 1}, {0, 0, 0, 0}};
    if (fuzz_one_in(now.in, 2))
        for (int i = 0; i < 4; i++) pose.dual[i] = fuzz_number(now.in);
    if (fuzz_one_in(now.in, 4))
        for (int i = 0; i < 4; i++) pose.real[i] = fuzz_number(now.in);
    return pose;
}

static dm_joint any_joint(void) {
    dm_joint joint = dm_joint_default();
    joint.struct_size = fuzz_struct_size(now.in, sizeof joint);
    joint.type = (int32_t)fuzz_below(now.in, 7);
    joint.pitch = fuzz_number(now.in);
    joint.axis = fuzz_vector(now.in);
    joint.origin = fuzz_vector(now.in);
    joint.lower = fuzz_number(now.in);
    joint.upper = fuzz_number(now.in);
    joint.source = (int32_t)fuzz_below(now.in, 5);
    return joint;
}

static dm_ray any_ray(void) {
    dm_ray ray = {{0.5f, 1.5f, 3}, {0, -0.3f, -1}};
    if (fuzz_one_in(now.in, 4)) ray.origin = fuzz_vector(now.in);
    ray.direction.x += 0.2f * fuzz_number(now.in);
    ray.direction.y += 0.2f * fuzz_number(now.in);
    return ray;
}

static dm_hand any_hand(void) {
    dm_hand hand = {.kind = (int32_t)fuzz_below(now.in, 8)};
    hand.ray = any_ray();
    hand.point = fuzz_vector(now.in);
    hand.amount = fuzz_number(now.in);
    if (fuzz_one_in(now.in, 2)) hand.grab_point = fuzz_vector(now.in);
    return hand;
}

static float seconds(void) {
    return fuzz_one_in(now.in, 8) ? fuzz_number(now.in) : (float)(1 + fuzz_below(now.in, 60)) / 600;
}

/* ---- calls: objects ---- */

static void prepare(dm_context* context, fuzz_host* host) {
    if (now.prepares++ >= MAX_PREPARES) return;
    static test_shape shape;
    cabinet_make(&shape);
    for (uint32_t edits = fuzz_below(now.in, 4); edits > 1; edits--)
        shape.xyz[fuzz_below(now.in, CABINET_VERTICES)][fuzz_below(now.in, 3)] = fuzz_number(now.in);
    if (fuzz_one_in(now.in, 8)) shape.corners[fuzz_below(now.in, CABINET_FACES)][0] = fuzz_byte(now.in);
    if (fuzz_one_in(now.in, 8)) shape.part[fuzz_below(now.in, CABINET_FACES)] = fuzz_byte(now.in);
    const dm_mesh_desc mesh = test_shape_desc(&shape);
    const dm_drag_hint hint = any_hint();
    const dm_pivot pivot = {.origin = fuzz_vector(now.in)};
    dm_part_desc part = {.struct_size = fuzz_struct_size(now.in, sizeof part), .id = any_part(), .label = "room/door"};
    if (fuzz_one_in(now.in, 2)) part.drag = &hint;
    if (fuzz_one_in(now.in, 2)) part.pivot = &pivot;
    dm_object_desc desc = {.struct_size = fuzz_struct_size(now.in, sizeof desc),
                           .flags = fuzz_below(now.in, 8),
                           .mesh = &mesh,
                           .seed = fuzz_byte(now.in),
                           .progress = fuzz_progress,
                           .progress_user = host};
    if (fuzz_one_in(now.in, 2)) desc.parts = &part;
    desc.part_count = desc.parts != NULL;
    if (fuzz_one_in(now.in, 3)) desc.choose = fuzz_choose;
    if (fuzz_one_in(now.in, 3)) desc.intent = fuzz_intent;
    desc.choose_user = desc.intent_user = host;
    dm_object object;
    memset(&object, UNTOUCHED, sizeof object);
    if (is_ok(dm_object_prepare(context, &desc, &object), &object, sizeof object)) keep(OBJECT, object);
}

static void find_part(dm_context* context, fuzz_host* host) {
    (void)host;
    static test_shape shape;
    cabinet_make(&shape);
    dm_mesh_desc mesh = test_shape_desc(&shape);
    if (fuzz_one_in(now.in, 2)) mesh.part_ids = NULL;
    const dm_drag_hint hint = any_hint();
    uint8_t faces[CABINET_FACES];
    memset(faces, UNTOUCHED, sizeof faces);
    const uint64_t room = fuzz_one_in(now.in, 4) ? fuzz_byte(now.in) % sizeof faces : sizeof faces;
    if (is_ok(dm_mesh_find_part(context, &mesh, &hint, faces, room), faces, sizeof faces))
        for (size_t i = 0; i < sizeof faces; i++) fuzz_expect(faces[i] <= 1);
}

static void load_object(dm_context* context, fuzz_host* host) {
    (void)host;
    static uint8_t copy[sizeof saved_object];
    memcpy(copy, saved_object, saved_size);
    if (fuzz_one_in(now.in, 4)) copy[fuzz_word(now.in) % saved_size] ^= fuzz_byte(now.in);
    const size_t size = fuzz_one_in(now.in, 8) ? fuzz_word(now.in) % saved_size : saved_size;
    dm_object object;
    memset(&object, UNTOUCHED, sizeof object);
    if (is_ok(dm_object_load(context, copy, size, 0, &object), &object, sizeof object)) keep(OBJECT, object);
}

/* What is saved can be loaded, and is saved as the same bytes again. */
static void save_object(dm_context* context, fuzz_host* host) {
    (void)host;
    static uint8_t first[sizeof saved_object], second[sizeof saved_object];
    size_t size = 0, again = 0;
    dm_object loaded;
    const dm_result result = dm_object_save(context, any_handle(OBJECT), first, sizeof first, &size);
    fuzz_expect_result(result);
    if (result != DM_OK || dm_object_load(context, first, size, 0, &loaded) != DM_OK) return;
    if (dm_object_save(context, loaded, second, sizeof second, &again) == DM_OK)
        fuzz_expect(again == size && memcmp(first, second, size) == 0);
    fuzz_expect_result(dm_object_destroy(context, loaded));
}

static void destroy_object(dm_context* context, fuzz_host* host) {
    (void)host;
    fuzz_expect_result(dm_object_destroy(context, any_handle(OBJECT)));
}

static void get_object(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_object object = any_handle(OBJECT);
    OUTPUT(dm_object_info, info);
    OUTPUT(dm_part_info, part);
    OUTPUT(dm_joint, joint);
    if (OK(dm_object_get_info(context, object, &info), info)) fuzz_expect_finite(&info.size, 1);
    if (OK(dm_object_get_part(context, object, fuzz_byte(now.in), &part), part)) {
        fuzz_expect_vector(&part.centre);
        fuzz_expect_finite(&part.area, 1);
    }
    if (OK(dm_object_get_joint(context, object, any_part(), &joint), joint)) fuzz_expect_joint(&joint);
}

static void get_hypotheses(dm_context* context, fuzz_host* host) {
    (void)host;
    dm_joint joints[DM_MAX_HYPOTHESES];
    const dm_drag_hint hint = any_hint();
    uint32_t count = 0;
    joints[0].struct_size = fuzz_struct_size(now.in, sizeof joints[0]);
    const dm_result result =
        dm_object_get_hypotheses(context, any_handle(OBJECT), any_part(), fuzz_one_in(now.in, 2) ? &hint : NULL, joints,
                                 fuzz_below(now.in, DM_MAX_HYPOTHESES + 1), &count);
    fuzz_expect_result(result);
    for (uint32_t i = 0; result == DM_OK && joints[0].struct_size == sizeof joints[0] && i < count; i++)
        fuzz_expect_joint(&joints[i]);
}

static void set_joint(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_object object = any_handle(OBJECT);
    const dm_joint joint = any_joint();
    const dm_drag_hint hint = any_hint();
    const uint32_t way = fuzz_below(now.in, 4);
    if (way < 2) fuzz_expect_result(dm_object_set_joint(context, object, any_part(), &joint));
    if (way == 2) fuzz_expect_result(dm_object_reset_joint(context, object, any_part()));
    if (way == 3) fuzz_expect_result(dm_object_refine(context, object, any_part(), &hint));
}

static void link_parts(dm_context* context, fuzz_host* host) {
    (void)host;
    dm_link links[4];
    float values[CABINET_PARTS];
    uint8_t held[CABINET_PARTS];
    const dm_object object = any_handle(OBJECT);
    for (int i = 0; i < 4; i++)
        links[i] = (dm_link){any_part(),
                             any_part(),
                             (int32_t)fuzz_below(now.in, 4),
                             fuzz_below(now.in, 3),
                             fuzz_number(now.in),
                             fuzz_number(now.in),
                             fuzz_number(now.in)};
    fuzz_expect_result(dm_object_set_links(context, object, links, fuzz_below(now.in, 5)));
    for (int i = 0; i < CABINET_PARTS; i++) values[i] = fuzz_number(now.in);
    const dm_result result = dm_object_follow_links(context, object, any_part(), values, held, CABINET_PARTS);
    fuzz_expect_result(result);
    if (result == DM_OK) fuzz_expect_finite(values, CABINET_PARTS);
}

/* ---- calls: drags ---- */

static void begin_drag(dm_context* context, fuzz_host* host) {
    (void)host;
    const float snaps[3] = {-0.2f, 0.3f, fuzz_number(now.in)};
    dm_drag_rules rules = {.struct_size = fuzz_struct_size(now.in, sizeof rules), .flags = fuzz_below(now.in, 5)};
    if (fuzz_one_in(now.in, 2)) rules.snaps = snaps;
    rules.snap_count = rules.snaps != NULL ? 3 : 0;
    float* const amounts[] = {&rules.open_share,       &rules.closed_share,     &rules.event_time, &rules.max_speed,
                              &rules.max_acceleration, &rules.lock_give,        &rules.tip_share,  &rules.restitution,
                              &rules.break_distance,   &rules.auto_close_share, &rules.close_delay};
    for (size_t i = 0; i < sizeof amounts / sizeof amounts[0]; i++)
        if (fuzz_one_in(now.in, 3)) *amounts[i] = fuzz_number(now.in);
    dm_drag_desc desc = {.struct_size = fuzz_struct_size(now.in, sizeof desc),
                         .part_id = any_part(),
                         .object = any_handle(OBJECT),
                         .grab_point = cabinet_grab,
                         .flags = fuzz_below(now.in, 4)};
    if (fuzz_one_in(now.in, 4)) desc.grab_point = fuzz_vector(now.in);
    if (fuzz_one_in(now.in, 4)) desc.start_value = fuzz_number(now.in);
    if (fuzz_one_in(now.in, 4)) desc.scale = fuzz_vector(now.in);
    if (fuzz_one_in(now.in, 2)) desc.rules = &rules;
    if (fuzz_one_in(now.in, 3))
        desc.feel = (dm_drag_feel){fuzz_number(now.in), fuzz_number(now.in), fuzz_number(now.in),
                                   fuzz_number(now.in), fuzz_number(now.in), fuzz_number(now.in)};
    dm_drag drag;
    memset(&drag, UNTOUCHED, sizeof drag);
    if (is_ok(dm_drag_begin(context, &desc, &drag), &drag, sizeof drag)) keep(DRAG, drag);
}

static void update_drag(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_drag drag = any_handle(DRAG);
    for (uint32_t frames = 1 + fuzz_below(now.in, 8); frames > 0; frames--) {
        const dm_ray ray = any_ray();
        OUTPUT(dm_drag_state, state);
        if (!OK(dm_drag_update(context, drag, &ray, seconds(), &state), state)) return;
        fuzz_expect_state(&state);
    }
}

static void step_drag(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_drag drag = any_handle(DRAG);
    dm_drag_input input = dm_drag_input_default();
    input.flags = fuzz_below(now.in, 4);
    input.hand = any_hand();
    if (fuzz_one_in(now.in, 3)) input.second = any_hand();
    input.handles[0] = fuzz_number(now.in);
    input.lower = fuzz_number(now.in);
    input.upper = fuzz_number(now.in);
    OUTPUT(dm_drag_state, state);
    OUTPUT(dm_drag_state, taken);
    if (OK(dm_drag_step(context, drag, &input, seconds(), &state), state)) fuzz_expect_state(&state);
    if (OK(dm_drag_take(context, drag, fuzz_number(now.in), &taken), taken)) fuzz_expect_state(&taken);
}

static void release_drag(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_release_desc desc = {.struct_size = fuzz_struct_size(now.in, sizeof desc),
                                  .intent = (int32_t)fuzz_below(now.in, 8),
                                  .duration = fuzz_number(now.in),
                                  .flags = fuzz_below(now.in, 4),
                                  .away_from = fuzz_vector(now.in)};
    OUTPUT(dm_release_plan, plan);
    if (!OK(dm_drag_release(context, any_handle(DRAG), &desc, &plan), plan)) return;
    const float numbers[3] = {plan.start_value, plan.end_value, plan.duration};
    fuzz_expect_finite(numbers, 3);
}

static void end_drag(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_drag drag = any_handle(DRAG);
    OUTPUT(dm_part_state, state);
    const dm_result result =
        fuzz_one_in(now.in, 2) ? dm_drag_end(context, drag, &state) : dm_drag_get_part_state(context, drag, &state);
    if (!OK(result, state)) return;
    fuzz_expect_finite(&state.value, 1);
    fuzz_expect_pose(&state.pose);
    fuzz_expect_joint(&state.joint);
}

static void save_drag(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_drag drag = any_handle(DRAG);
    if (has_saved_drag && fuzz_one_in(now.in, 2)) {
        fuzz_expect_result(dm_drag_restore(context, drag, saved_drag, dm_drag_snapshot_size()));
        return;
    }
    const dm_result result = dm_drag_save(context, drag, saved_drag, sizeof saved_drag);
    fuzz_expect_result(result);
    has_saved_drag |= result == DM_OK;
}

/* ---- calls: the rest ---- */

static void generate_motion(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = any_part(), .drag = any_hint()};
    dm_motion motion;
    memset(&motion, UNTOUCHED, sizeof motion);
    if (is_ok(dm_motion_generate(context, any_handle(OBJECT), &desc, &motion), &motion, sizeof motion))
        keep(MOTION, motion);
    dm_pose pose;
    memset(&pose, UNTOUCHED, sizeof pose);
    if (is_ok(dm_motion_sample(context, any_handle(MOTION), fuzz_number(now.in), &pose, NULL), &pose, sizeof pose))
        fuzz_expect_pose(&pose);
    if (fuzz_one_in(now.in, 3)) fuzz_expect_result(dm_motion_destroy(context, any_handle(MOTION)));
}

static void change_scene(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_scene_desc desc = {.struct_size = fuzz_struct_size(now.in, sizeof desc)};
    const dm_pose pose = any_pose();
    dm_scene scene = any_handle(SCENE);
    uint32_t instance;
    switch (fuzz_below(now.in, 8)) {
    case 0:
        memset(&scene, UNTOUCHED, sizeof scene);
        if (is_ok(dm_scene_create(context, &desc, &scene), &scene, sizeof scene)) keep(SCENE, scene);
        break;
    case 1:
        fuzz_expect_result(dm_scene_destroy(context, scene));
        break;
    case 2:
        fuzz_expect_result(dm_scene_remove(context, scene, fuzz_byte(now.in) % 4));
        break;
    case 3:
        fuzz_expect_result(dm_scene_move(context, scene, fuzz_byte(now.in) % 4, any_part(), &pose));
        break;
    default:
        memset(&instance, UNTOUCHED, sizeof instance);
        (void)is_ok(dm_scene_add(context, scene, any_handle(OBJECT), &pose, &instance), &instance, sizeof instance);
    }
}

static void pick(dm_context* context, fuzz_host* host) {
    (void)host;
    const dm_scene scene = any_handle(SCENE);
    const dm_ray ray = any_ray();
    OUTPUT(dm_hit, hit);
    if (fuzz_one_in(now.in, 2)) fuzz_expect_result(dm_scene_commit(context, scene));
    if (!OK(dm_scene_pick(context, scene, &ray, &hit), hit) || hit.object == 0) return;
    const float numbers[3] = {hit.distance, hit.u, hit.v};
    fuzz_expect_finite(numbers, 3);
    fuzz_expect_vector(&hit.point);
    fuzz_expect_vector(&hit.normal);
    fuzz_expect_vector(&hit.object_point);
}

static void use_joint(dm_context* context, fuzz_host* host) {
    (void)context;
    (void)host;
    const dm_joint joint = any_joint();
    const dm_pose from = any_pose();
    dm_pose pose;
    float numbers[3];
    memset(&pose, UNTOUCHED, sizeof pose);
    if (is_ok(dm_joint_pose(&joint, fuzz_number(now.in), &pose), &pose, sizeof pose)) fuzz_expect_pose(&pose);
    memset(numbers, UNTOUCHED, sizeof numbers);
    if (is_ok(dm_joint_value(&joint, &from, numbers, numbers + 1, numbers + 2), numbers, sizeof numbers))
        fuzz_expect_finite(numbers, 3);
    memset(numbers, UNTOUCHED, sizeof numbers);
    if (is_ok(dm_joint_value_at(&joint, fuzz_number(now.in), numbers), numbers, sizeof numbers[0]))
        fuzz_expect_finite(numbers, 1);
    OUTPUT(dm_joint_frame, frame);
    if (OK(dm_joint_get_frame(&joint, &frame), frame)) fuzz_expect_finite(frame.rotation, 4);
}

/* Memory runs out at one of the next allocations. */
static void refuse_memory(dm_context* context, fuzz_host* host) {
    (void)context;
    host->refuse_in = 1u + fuzz_byte(now.in);
}

/* ---- the sequence ---- */

typedef void (*call)(dm_context* context, fuzz_host* host);

/* Drags are called most. New calls go to the end, so that corpora stay of use. */
static const call calls[] = {
    prepare,      find_part,  load_object, save_object,   destroy_object, get_object,  get_hypotheses, set_joint,
    link_parts,   begin_drag, update_drag, step_drag,     release_drag,   end_drag,    save_drag,      generate_motion,
    change_scene, pick,       use_joint,   refuse_memory, begin_drag,     update_drag, step_drag,      change_scene,
};

static void call_once(uint32_t context) {
    const call chosen = calls[fuzz_below(now.in, sizeof calls / sizeof calls[0])];
    chosen(now.contexts[context], &now.hosts[context]);
}

/* From a hook of one context: calls the other one. */
static void call_other(fuzz_host* host) {
    const uint32_t other = host == &now.hosts[0];
    if (now.hosts[other].inside || now.contexts[other] == NULL) return;
    for (uint32_t i = fuzz_below(now.in, HOOK_CALLS); i > 0; i--) call_once(other);
}

static void open_contexts(void) {
    for (uint32_t c = 0; c < CONTEXTS; c++) {
        fuzz_host* host = &now.hosts[c];
        *host = (fuzz_host){.in = now.in, .reenter = fuzz_one_in(now.in, 2) ? call_other : NULL};
        dm_context_desc desc = {.struct_size = sizeof desc,
                                .axes = (int32_t)fuzz_below(now.in, 4),
                                .allocator = {host, fuzz_allocate, fuzz_release},
                                .log = {host, fuzz_message},
                                .picking = DM_PICK_PORTABLE};
        if (fuzz_one_in(now.in, 2)) desc.jobs = (dm_jobs){host, fuzz_parallel_for};
        fuzz_expect(dm_context_create(&desc, &now.contexts[c]) == DM_OK);
    }
}

/* Prepares the object that load_object reads. */
static void save_an_object(void) {
    dm_context* context;
    fuzz_expect(dm_context_create(NULL, &context) == DM_OK);
    const dm_object object = cabinet_prepare(context);
    fuzz_expect(dm_object_save(context, object, saved_object, sizeof saved_object, &saved_size) == DM_OK);
    dm_context_destroy(context);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static fuzz_input in; /* `now` points to it beyond this call */
    in = (fuzz_input){data, size};
    if (saved_size == 0) save_an_object();
    now = (player){.in = &in};
    has_saved_drag = false;
    open_contexts();
    for (uint32_t i = 0; i < MAX_CALLS && in.size > 0; i++) call_once(fuzz_one_in(&in, 4));
    for (uint32_t c = 0; c < CONTEXTS; c++) {
        now.hosts[c].reenter = NULL;
        dm_context_destroy(now.contexts[c]);
        fuzz_expect(now.hosts[c].live == 0);
    }
    return 0;
}
