/* What a drag ends with and begins with: joint and value in one piece, snapshots, the joints in force, scaled
 * instances, limits that mean "none", and numbers that can't be meant. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "../../plugin_api/src/api_handles.h" /* for the instruction set of a context */
#include "test_snapshot.h"
#include "test_world.h"

static dm_vec3 moved(const dm_joint* joint, float value, dm_vec3 from) {
    dm_pose pose;
    float point[3] = {from.x, from.y, from.z};
    assert_int_equal(dm_joint_pose(joint, value, &pose), DM_OK);
    dm_pose_apply_points(&pose, point, 0, point, 0, 1);
    return (dm_vec3){point[0], point[1], point[2]};
}

/* rules, state: NULL for none. */
static dm_drag begin_ruled(const test_world* w, dm_object object, dm_vec3 grab, const dm_drag_rules* rules,
                           const dm_part_state* state) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = TEST_DOOR,
                               .object = object,
                               .grab_point = grab,
                               .rules = rules,
                               .state = state};
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(w->context, &desc, &drag), DM_OK);
    return drag;
}

static dm_drag begin(const test_world* w, dm_object object, dm_vec3 grab, const dm_part_state* state) {
    return begin_ruled(w, object, grab, NULL, state);
}

static void save_and_restore(const test_world* w, dm_drag drag) {
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    assert_int_equal(dm_drag_save(w->context, drag, saved, sizeof saved), DM_OK);
    assert_int_equal(dm_drag_restore(w->context, drag, saved, dm_drag_snapshot_size()), DM_OK);
}

/* Pulls the door's handle along a joint to `value`; rest: frames that the pointer then stays. */
static dm_drag_state pull(const test_world* w, dm_drag drag, const dm_joint* along, float from, float value, int rest) {
    dm_drag_state now = dm_drag_state_default();
    for (int k = 1; k <= 60 + rest; k++) {
        const dm_ray ray =
            test_ray_to(moved(along, from + (value - from) * fminf((float)k / 60, 1), test_pull().point));
        assert_int_equal(dm_drag_update(w->context, drag, &ray, 0.016f, &now), DM_OK);
    }
    return now;
}

static void open_world(test_world* w, dm_object* out_object) {
    test_world_init(w);
    test_world_open(w);
    *out_object = test_world_cabinet(w);
    w->messages.count = 0;
}

/* Largest distance between the places of the door's corners under two poses. */
static float jump(const dm_pose* a, const dm_pose* b) {
    float most = 0;
    for (int corner = 0; corner < 8; corner++) {
        const float at[3] = {corner & 1 ? 1 : 0.0f, corner & 2 ? 1 : 0.0f, corner & 4 ? 1.05f : 1.01f};
        float p[3], q[3], sum = 0;
        dm_pose_apply_points(a, at, 0, p, 0, 1);
        dm_pose_apply_points(b, at, 0, q, 0, 1);
        for (int i = 0; i < 3; i++) sum += (p[i] - q[i]) * (p[i] - q[i]);
        most = fmaxf(most, sqrtf(sum));
    }
    return most;
}

/* ---- one piece, out and in ---- */

/* The pull follows another joint than the one in force; the next grab goes on where this one ends, be it at rest or in
 * the middle of coming over to the new joint. */
static void the_next_drag_begins_where_the_last_ended(void** state) {
    (void)state;
    const dm_joint hinge = test_hinge();
    const dm_joint flap = {
        .struct_size = sizeof flap, .type = DM_JOINT_REVOLUTE, .axis = {1, 0, 0}, .origin = {0, 0, 1.03f}};
    const dm_joint* pulls[] = {&hinge, &flap};
    uint32_t changes = 0;
    for (int i = 0; i < 2; i++) {
        for (int rest = 0; rest < 60; rest += 30) {
            test_world w;
            dm_object object;
            open_world(&w, &object);
            const dm_drag first = begin(&w, object, test_pull().point, NULL);
            const dm_drag_state last = pull(&w, first, pulls[i], 0, 0.9f, rest);
            changes += last.changes;
            dm_part_state end = dm_part_state_default(), again = dm_part_state_default();
            assert_int_equal(dm_drag_end(w.context, first, &end), DM_OK);
            assert_true(end.value == last.value);
            assert_memory_equal(&end.pose, &last.pose, sizeof end.pose);
            const dm_drag second = begin(&w, object, last.grab_point, &end);
            assert_int_equal(dm_drag_get_part_state(w.context, second, &again), DM_OK);
            assert_true(again.value == end.value && end.value != 0);
            assert_memory_equal(&again.joint, &end.joint, sizeof end.joint); /* source and confidences too */
            assert_true(jump(&again.pose, &last.pose) < 1e-5f);
            dm_drag_state now = dm_drag_state_default();
            const dm_ray still = test_ray_to(last.grab_point);
            assert_int_equal(dm_drag_update(w.context, second, &still, 0.016f, &now), DM_OK);
            assert_true(jump(&now.pose, &last.pose) < 0.04f); /* in a frame of coming over, in 0.1 s and more */
            test_world_close(&w);
        }
    }
    assert_true(changes > 0); /* or this tests nothing */
}

/* A part that stands open on a joint that an earlier pull left unsure still changes to the one that the pull shows. */
static void a_new_grab_may_change_the_joint(void** state) {
    (void)state;
    const dm_joint hinge = test_hinge();
    test_world w;
    dm_object object;
    open_world(&w, &object);
    dm_part_state left = {.struct_size = sizeof left, .value = 0.1f, .joint = dm_joint_default()};
    left.joint.type = DM_JOINT_REVOLUTE;
    left.joint.axis = (dm_vec3){1, 0, 0}, left.joint.origin = (dm_vec3){0, 0, 1.03f};
    left.joint.joint_confidence = left.joint.type_confidence = 0.3f;
    left.joint.source = DM_JOINT_FROM_GEOMETRY;
    left.joint.lower = -1.5f, left.joint.upper = 1.5f;
    const dm_drag drag = begin(&w, object, moved(&left.joint, left.value, test_pull().point), &left);
    const dm_drag_state now = pull(&w, drag, &hinge, 0.1f, 1.2f, 30);
    dm_part_state end = dm_part_state_default();
    assert_int_equal(dm_drag_end(w.context, drag, &end), DM_OK);
    assert_true(now.changes > 0);
    assert_memory_not_equal(&end.joint.axis, &left.joint.axis, sizeof end.joint.axis);
    test_world_close(&w);
}

/* A door of two is another door: what one was pulled to does not touch the other, or the object. */
static void states_belong_to_instances(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    dm_joint before = dm_joint_default(), after = dm_joint_default();
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &before), DM_OK);
    dm_part_state left = {.struct_size = sizeof left, .value = 0.7f, .joint = test_hinge()};
    left.joint.source = DM_JOINT_FROM_HOST;
    const dm_drag a = begin(&w, object, moved(&left.joint, 0.7f, test_pull().point), &left);
    const dm_drag b = begin(&w, object, test_pull().point, NULL);
    const dm_drag_state now = pull(&w, a, &left.joint, 0.7f, 1.2f, 30);
    assert_true(fabsf(now.value - 1.2f) < 0.01f && now.changes == 0); /* certain: it is the host's */
    dm_part_state right = dm_part_state_default();
    assert_int_equal(dm_drag_get_part_state(w.context, b, &right), DM_OK);
    assert_true(right.value == 0);
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &after), DM_OK);
    assert_memory_equal(&before, &after, sizeof before);
    dm_pose pose;
    assert_int_equal(dm_joint_pose(&left.joint, now.value, &pose), DM_OK);
    assert_true(jump(&pose, &now.pose) < 1e-5f); /* the pose is on the joint */
    test_world_close(&w);
}

static void a_bad_state_is_refused_by_name(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_part_state good = {.struct_size = sizeof good, .value = 0.5f, .joint = test_hinge()};
    enum { BAD = 13 };
    dm_part_state bad[BAD];
    for (int i = 0; i < BAD; i++) bad[i] = good;
    bad[0].struct_size = 0;
    bad[1].joint.struct_size = 0;
    bad[2].value = (float)NAN;
    bad[3].joint.axis = (dm_vec3){0, 0, 0};
    bad[4].joint.source = 7;
    bad[5].pose.real[0] = 9;
    bad[6].joint.struct_size = sizeof good.joint + 4; /* more than there is */
    bad[7].joint.type_confidence = (float)NAN;
    bad[8].joint.joint_confidence = 1.5f;
    /* Too large to compute with: poses would not be finite. */
    bad[9].value = -1e30f;
    bad[10].joint.origin.y = 1e20f;
    bad[11].joint.type = DM_JOINT_SCREW, bad[11].joint.pitch = -1e20f;
    bad[12].pose = (dm_pose){{0, 0, 0, 1}, {0, 1e20f, 0, 0}};
    const char* const fields[BAD] = {"desc.state.struct_size",
                                     "desc.state.joint.struct_size",
                                     "desc.state.value",
                                     "desc.state.joint.axis",
                                     "desc.state.joint.source",
                                     "desc.state.pose",
                                     "desc.state.joint.struct_size",
                                     "desc.state.joint.type_confidence",
                                     "desc.state.joint.joint_confidence",
                                     "desc.state.value",
                                     "desc.state.joint.origin.y",
                                     "desc.state.joint.pitch",
                                     "desc.state.pose.dual[1]"};
    for (int i = 0; i < BAD; i++) {
        const dm_drag_desc desc = {
            .struct_size = sizeof desc, .part_id = TEST_DOOR, .object = object, .state = &bad[i]};
        dm_drag drag = 0;
        if (dm_drag_begin(w.context, &desc, &drag) >= 0) fail_msg("%s was taken", fields[i]);
        if (!strstr(w.messages.text, fields[i])) fail_msg("no %s in: %s", fields[i], w.messages.text);
    }
    const dm_drag_desc both = {
        .struct_size = sizeof both, .part_id = TEST_DOOR, .object = object, .start_value = 0.1f, .state = &good};
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(w.context, &both, &drag), DM_ERROR_INVALID_ARGUMENT);
    test_world_close(&w);
}

/* As a value, in a state, in a saved drag: where a joint comes in, each of its numbers is checked. */
static void every_number_of_a_joint_is_checked(void** state) {
    (void)state;
    static const struct {
        const char* name;
        size_t offset;
    } fields[] = {{"axis.x", offsetof(dm_joint, axis.x)},     {"axis.y", offsetof(dm_joint, axis.y)},
                  {"axis.z", offsetof(dm_joint, axis.z)},     {"origin.x", offsetof(dm_joint, origin.x)},
                  {"origin.y", offsetof(dm_joint, origin.y)}, {"origin.z", offsetof(dm_joint, origin.z)},
                  {"pitch", offsetof(dm_joint, pitch)},       {"lower", offsetof(dm_joint, lower)},
                  {"upper", offsetof(dm_joint, upper)}};
    enum { FIELDS = sizeof fields / sizeof *fields, LIMITS = 2 };
    test_world w;
    dm_object object;
    open_world(&w, &object);
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX], bad[DM_DRAG_SNAPSHOT_MAX];
    const size_t size = dm_drag_snapshot_size();
    const dm_part_state good = {.struct_size = sizeof good, .value = 0.5f, .joint = test_hinge()};
    const dm_drag drag = begin(&w, object, test_pull().point, &good);
    assert_int_equal(dm_drag_save(w.context, drag, saved, sizeof saved), DM_OK);
    size_t at = 0; /* of the joint */
    while (memcmp(saved + at + offsetof(dm_joint, axis), &good.joint.axis, 2 * sizeof(dm_vec3)) != 0) at++;
    for (int i = 0; i < 2 * FIELDS; i++) {
        const size_t offset = fields[i / 2].offset;
        const float number = i % 2 ? (float)NAN : (float)INFINITY;
        dm_part_state state_now = good;
        memcpy((uint8_t*)&state_now.joint + offset, &number, sizeof number);
        memcpy(bad, saved, size);
        memcpy(bad + at + offset, &number, sizeof number);
        test_snapshot_sign(bad, size);
        assert_int_equal(dm_drag_restore(w.context, drag, bad, size), DM_ERROR_BAD_DATA);
        if (i / 2 >= FIELDS - LIMITS) continue; /* a host's limits may be infinite */
        dm_pose pose;
        const dm_drag_desc desc = {
            .struct_size = sizeof desc, .part_id = TEST_DOOR, .object = object, .state = &state_now};
        dm_drag other = 0;
        assert_int_equal(dm_joint_pose(&state_now.joint, 0.5f, &pose), DM_ERROR_NOT_FINITE);
        assert_int_equal(dm_drag_begin(w.context, &desc, &other), DM_ERROR_NOT_FINITE);
        if (!strstr(w.messages.text, fields[i / 2].name)) fail_msg("no %s in: %s", fields[i / 2].name, w.messages.text);
    }
    for (int32_t type = DM_JOINT_UNKNOWN - 1; type <= DM_JOINT_FIXED + 1; type++) {
        const bool known = type >= DM_JOINT_UNKNOWN && type <= DM_JOINT_FIXED;
        dm_joint joint = good.joint;
        joint.type = type;
        dm_pose pose;
        memcpy(bad, saved, size);
        memcpy(bad + at + offsetof(dm_joint, type), &type, sizeof type);
        test_snapshot_sign(bad, size);
        assert_int_equal(dm_joint_pose(&joint, 0.5f, &pose), known ? DM_OK : DM_ERROR_INVALID_ARGUMENT);
        assert_int_equal(dm_drag_restore(w.context, drag, bad, size), known ? DM_OK : DM_ERROR_BAD_DATA);
    }
    test_world_close(&w);
}

/* A caller that is newer: its joint, the last field of its state, is longer by zeros. */
static void a_newer_state_is_taken(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    struct {
        dm_part_state known;
        uint32_t unknown[40];
    } newer;
    memset(&newer, 0, sizeof newer);
    newer.known = (dm_part_state){.struct_size = sizeof newer, .value = 0.5f, .joint = test_hinge()};
    newer.known.joint.struct_size = sizeof newer.known.joint + sizeof newer.unknown;
    dm_part_state now = dm_part_state_default();
    const dm_drag drag = begin(&w, object, test_pull().point, &newer.known);
    assert_int_equal(dm_drag_end(w.context, drag, &now), DM_OK);
    assert_true(now.value == 0.5f);
    assert_memory_equal(&now.joint.axis, &newer.known.joint.axis, sizeof now.joint.axis);
    test_world_close(&w);
}

/* Points, rays, scales and feels of which nothing finite would come. */
static void numbers_beyond_computing_are_refused(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_drag_desc good = {
        .struct_size = sizeof good, .part_id = TEST_DOOR, .object = object, .grab_point = test_pull().point};
    dm_drag_desc bad[6] = {good, good, good, good, good, good};
    bad[0].grab_point.z = 1e30f;
    bad[1].start_value = 1e30f;
    bad[2].scale = (dm_vec3){1, 1e30f, 1};
    bad[3].scale = (dm_vec3){1, 1, 1e-30f};
    bad[4].feel.detent = 1e-40f;
    bad[5].feel.smoothing_time = 1e-40f;
    const char* const fields[6] = {"desc.grab_point.z", "desc.start_value", "desc.scale.y",
                                   "desc.scale",        "desc.feel.detent", "desc.feel.smoothing_time"};
    dm_drag drag = 0;
    for (int i = 0; i < 6; i++) {
        assert_int_equal(dm_drag_begin(w.context, &bad[i], &drag), DM_ERROR_INVALID_ARGUMENT);
        if (!strstr(w.messages.text, fields[i])) fail_msg("no %s in: %s", fields[i], w.messages.text);
    }
    assert_int_equal(dm_drag_begin(w.context, &good, &drag), DM_OK);
    const dm_ray far = {{0, 1e30f, 0}, {0, -1, 0}};
    dm_drag_state now = dm_drag_state_default();
    assert_int_equal(dm_drag_update(w.context, drag, &far, 0.016f, &now), DM_ERROR_INVALID_ARGUMENT);
    const dm_joint slide = {
        .struct_size = sizeof slide, .type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .origin = {3e38f, 0, 0}};
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &slide), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(w.messages.text, "joint.origin.x"));
    test_world_close(&w);
}

/* However long a time is that a host gives, parts stay where finite numbers are. */
static void endless_times_give_finite_poses(void** state) {
    (void)state;
    const dm_joint hinge = test_hinge();
    test_world w;
    dm_object object;
    open_world(&w, &object);
    dm_joint wheel = hinge; /* glides as far as it likes */
    wheel.type = DM_JOINT_CONTINUOUS;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &wheel), DM_OK);
    for (int i = 0; i < 4; i++) {
        dm_drag_desc desc = {
            .struct_size = sizeof desc, .part_id = TEST_DOOR, .object = object, .grab_point = test_pull().point};
        float* const times[4] = {&desc.feel.smoothing_time, &desc.feel.coast_time, &desc.feel.return_time,
                                 &desc.feel.detent};
        *times[i] = 3e38f;
        dm_drag drag = 0;
        assert_int_equal(dm_drag_begin(w.context, &desc, &drag), DM_OK);
        dm_drag_state now = dm_drag_state_default();
        dm_release_plan plan = dm_release_plan_default();
        for (int frame = 0; frame < 40; frame++) {
            const dm_ray ray = test_ray_to(moved(&hinge, 0.05f * (float)frame, test_pull().point));
            if (frame == 20) assert_int_equal(dm_drag_release(w.context, drag, NULL, &plan), DM_OK);
            assert_int_equal(dm_drag_update(w.context, drag, frame < 20 ? &ray : NULL, 0.002f, &now), DM_OK);
            assert_true(test_state_is_finite(&now));
        }
        assert_true(isfinite(plan.end_value) && isfinite(plan.duration));
        assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
    }
    test_world_close(&w);
}

/* However slow a part may be by its rules, it stays where finite numbers are, and can be saved and restored. */
static void parts_that_may_hardly_move_give_finite_poses(void** state) {
    (void)state;
    static const float slow[] = {1e-45f, FLT_MIN, 1e-30f, 1e-13f};
    static const int32_t intents[] = {DM_INTENT_AUTO, DM_INTENT_OPEN, DM_INTENT_CLOSE, DM_INTENT_STAY};
    enum { SLOW = sizeof slow / sizeof *slow, INTENTS = sizeof intents / sizeof *intents, FIELDS = 4 };
    const dm_joint hinge = test_hinge();
    test_world w;
    dm_object object;
    open_world(&w, &object);
    for (int i = 0; i < FIELDS * SLOW * INTENTS; i++) {
        dm_drag_rules rules = {.struct_size = sizeof rules, .restitution = 0.3f};
        float* const fields[FIELDS] = {&rules.max_speed, &rules.max_acceleration, &rules.drive_speed, &rules.fall_time};
        *fields[i % FIELDS] = slow[i / FIELDS % SLOW];
        const dm_part_state begun = {.struct_size = sizeof begun, .value = 0.6f, .joint = hinge};
        const dm_release_desc release = {.struct_size = sizeof release, .intent = intents[i / FIELDS / SLOW]};
        const dm_drag drag = begin_ruled(&w, object, test_pull().point, &rules, &begun);
        dm_drag_state now = dm_drag_state_default();
        dm_release_plan plan = dm_release_plan_default();
        for (int frame = 0; frame < 20; frame++) {
            const dm_ray ray = test_ray_to(moved(&hinge, 0.6f + 0.02f * (float)frame, test_pull().point));
            if (frame == 10) assert_int_equal(dm_drag_release(w.context, drag, &release, &plan), DM_OK);
            assert_int_equal(dm_drag_update(w.context, drag, frame < 10 ? &ray : NULL, 0.016f, &now), DM_OK);
            assert_true(test_state_is_finite(&now));
            save_and_restore(&w, drag);
        }
        assert_true(isfinite(plan.end_value) && isfinite(plan.duration));
        assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
    }
    test_world_close(&w);
}

/* However short an update is, what it, its bounds and a value that the host takes instead say of the speed is finite.
 */
static void updates_of_almost_no_time_give_finite_speeds(void** state) {
    (void)state;
    const dm_joint hinge = test_hinge();
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_drag_rules rules = {.struct_size = sizeof rules};
    const dm_part_state begun = {.struct_size = sizeof begun, .value = 0.6f, .joint = hinge};
    const dm_drag drag = begin_ruled(&w, object, test_pull().point, &rules, &begun);
    dm_drag_state now = dm_drag_state_default();
    for (int frame = 0; frame < 12; frame++) {
        dm_drag_input input = dm_drag_input_default();
        input.flags = DM_INPUT_ASK | (frame % 4 == 1 ? DM_INPUT_BOUNDS : 0);
        input.lower = frame % 4 == 1 ? 0.7f : 0, input.upper = frame % 4 == 1 ? 0.8f : 0;
        input.hand.kind = DM_HAND_RAY;
        input.hand.ray = test_ray_to(moved(&hinge, 0.6f + 0.05f * (float)frame, test_pull().point));
        assert_int_equal(dm_drag_step(w.context, drag, &input, frame % 3 ? 1e-45f : 0.016f, &now), DM_OK);
        assert_true(isfinite(now.velocity));
        assert_int_equal(dm_drag_take(w.context, drag, now.value + (frame % 2 ? 0.1f : 0), &now), DM_OK);
        assert_true(isfinite(now.velocity));
    }
    test_world_close(&w);
}

/* However long an update is, a scalar hand asks for a value that hosts may have. */
static void scalars_over_endless_updates_ask_for_finite_values(void** state) {
    (void)state;
    static const int32_t kinds[] = {DM_HAND_RATE, DM_HAND_STEP, DM_HAND_VALUE};
    const dm_joint hinge = test_hinge();
    dm_joint wheel = hinge;
    wheel.type = DM_JOINT_CONTINUOUS;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    for (int i = 0; i < 12; i++) {
        const dm_part_state begun = {.struct_size = sizeof begun, .value = 0.6f, .joint = i % 2 ? hinge : wheel};
        const float amount = i / 6 ? -1e9f : 1e9f;
        const dm_drag drag = begin(&w, object, test_pull().point, &begun);
        dm_drag_state now = dm_drag_state_default();
        for (int frame = 0; frame < 6; frame++) {
            dm_drag_input input = dm_drag_input_default();
            input.hand = (dm_hand){.kind = kinds[i / 2 % 3], .amount = amount};
            assert_int_equal(dm_drag_step(w.context, drag, &input, 3e38f, &now), DM_OK);
            assert_true(fabsf(now.value) <= 1e9f && fabsf(now.target) <= 1e9f);
            assert_true(test_state_is_finite(&now));
            save_and_restore(&w, drag);
        }
        assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
    }
    test_world_close(&w);
}

/* Outputs of callers that are newer: what the library can't know comes back as zeros; no other size is taken. */
static void outputs_fit_the_callers_version(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    struct {
        dm_drag_state known;
        uint32_t unknown[2];
    } newer, same;
    memset(&newer, 0xAA, sizeof newer), memset(&same, 0xAA, sizeof same);
    newer.known.struct_size = sizeof newer, same.known.struct_size = sizeof same.known;
    const dm_ray ray = test_ray_to(test_pull().point);
    const dm_drag a = begin(&w, object, test_pull().point, NULL), b = begin(&w, object, test_pull().point, NULL);
    assert_int_equal(dm_drag_update(w.context, a, &ray, 0.016f, &newer.known), DM_OK);
    assert_int_equal(dm_drag_update(w.context, b, &ray, 0.016f, &same.known), DM_OK);
    assert_true(newer.unknown[0] == 0 && newer.unknown[1] == 0 && same.unknown[0] == 0xAAAAAAAAu);
    assert_true(newer.known.struct_size == sizeof newer && same.known.struct_size == sizeof same.known);
    assert_memory_equal(&newer.known.pose, &same.known.pose, sizeof same.known - sizeof(uint32_t));
    newer.known.struct_size = offsetof(dm_drag_state, changes); /* less than its first version */
    assert_int_equal(dm_drag_update(w.context, a, &ray, 0.016f, &newer.known), DM_ERROR_STRUCT_SIZE);
    dm_joint joint = {0};
    dm_part_state part = {0};
    dm_memory_info memory = {0};
    uint32_t count = 0;
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_object_get_hypotheses(w.context, object, TEST_DOOR, NULL, &joint, 1, &count),
                     DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &joint), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_drag_get_part_state(w.context, a, &part), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_drag_end(w.context, a, &part), DM_ERROR_STRUCT_SIZE); /* and the drag lives on */
    assert_int_equal(dm_context_get_memory(w.context, &memory), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_drag_end(w.context, a, NULL), DM_OK);
    test_world_close(&w);
}

/* ---- the joint in force ---- */

static void setting_the_joint_that_is_there_changes_nothing(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    dm_joint own = dm_joint_default(), now = dm_joint_default();
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &own), DM_OK);
    assert_int_not_equal(own.source, DM_JOINT_FROM_HOST);
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &own), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &now), DM_OK);
    assert_memory_equal(&own, &now, sizeof own);
    dm_joint hinge = test_hinge();
    hinge.axis.y = -3;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &now), DM_OK);
    assert_true(now.source == DM_JOINT_FROM_HOST && now.joint_confidence == 1 && now.axis.y == -1);
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &own), DM_OK); /* as undo does */
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &now), DM_OK);
    assert_memory_equal(&own, &now, sizeof own);
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
    assert_int_equal(dm_object_reset_joint(w.context, object, TEST_DOOR), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &now), DM_OK);
    assert_memory_equal(&own, &now, sizeof own);
    assert_int_equal(dm_object_reset_joint(w.context, object, 99), DM_ERROR_NOT_FOUND);
    test_world_close(&w);
}

/* ---- limits that mean none ---- */

typedef struct limit_case {
    int32_t type;
    float lower, upper;
    int32_t limits; /* -1: only a lower one stays, +1: only an upper one, 0: none, 2: both */
} limit_case;

static void play_limits(test_world* w, dm_object object, const limit_case* c) {
    dm_joint joint = test_hinge(), kept = dm_joint_default();
    joint.type = c->type;
    if (c->type == DM_JOINT_PRISMATIC) joint.axis = (dm_vec3){0, 0, 1};
    joint.lower = c->lower, joint.upper = c->upper;
    assert_int_equal(dm_object_set_joint(w->context, object, TEST_DOOR, &joint), DM_OK);
    assert_int_equal(dm_object_get_joint(w->context, object, TEST_DOOR, &kept), DM_OK);
    assert_true(isfinite(kept.lower) && isfinite(kept.upper));
    assert_int_equal(kept.lower == kept.upper, c->limits == 0);
    const dm_drag drag = begin(w, object, test_pull().point, NULL);
    const dm_joint free = {.struct_size = sizeof free, .type = c->type, .axis = joint.axis, .origin = joint.origin};
    dm_drag_state now = pull(w, drag, &free, 0, 0.5f, 30);
    assert_true(fabsf(now.value - 0.5f) < 0.01f && now.at_limit == 0);
    dm_release_plan plan = dm_release_plan_default();
    assert_int_equal(dm_drag_release(w->context, drag, NULL, &plan), DM_OK);
    assert_int_equal(plan.intent, DM_INTENT_STAY);
    assert_true(isfinite(plan.end_value) && isfinite(plan.duration));
    for (int k = 0; k < 300; k++) assert_int_equal(dm_drag_update(w->context, drag, NULL, 0.016f, &now), DM_OK);
    assert_true(now.phase == DM_DRAG_AT_REST && fabsf(now.value - 0.5f) < 0.2f && isfinite(now.velocity));
    assert_int_equal(dm_drag_end(w->context, drag, NULL), DM_OK);
    const dm_drag back = begin(w, object, test_pull().point, NULL); /* from rest, the other way */
    now = pull(w, back, &free, 0, -0.4f, 30);
    const bool stops = c->limits == -1;
    assert_true(stops ? now.value == 0 && now.at_limit == -1 : fabsf(now.value + 0.4f) < 0.01f && now.at_limit == 0);
    assert_int_equal(dm_drag_end(w->context, back, NULL), DM_OK);
    assert_int_equal(dm_object_set_joint(w->context, object, TEST_DOOR, &kept), DM_OK); /* and it stays what it is */
    dm_joint again = dm_joint_default();
    assert_int_equal(dm_object_get_joint(w->context, object, TEST_DOOR, &again), DM_OK);
    assert_memory_equal(&kept, &again, sizeof kept);
}

static void other_engines_words_for_no_limit_are_understood(void** state) {
    (void)state;
    const float inf = (float)INFINITY;
    const limit_case cases[] = {{DM_JOINT_PRISMATIC, -FLT_MAX, FLT_MAX, 0},
                                {DM_JOINT_PRISMATIC, -1e30f, 1e30f, 0},
                                {DM_JOINT_PRISMATIC, 0, FLT_MAX, -1},
                                {DM_JOINT_PRISMATIC, 0, 1e10f, -1},
                                {DM_JOINT_PRISMATIC, 0, inf, -1},
                                {DM_JOINT_PRISMATIC, -inf, 1.5f, 1},
                                {DM_JOINT_REVOLUTE, -FLT_MAX, FLT_MAX, 0},
                                {DM_JOINT_REVOLUTE, -inf, inf, 0},
                                {DM_JOINT_REVOLUTE, 0, inf, -1},
                                {DM_JOINT_REVOLUTE, -1e10f, 1.5f, 1},
                                {DM_JOINT_SCREW, -1e16f, 1e16f, 0},
                                {DM_JOINT_REVOLUTE, -174, 174, 2}};
    test_world w;
    dm_object object;
    open_world(&w, &object);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (cases[i].limits == 2) continue;
        play_limits(&w, object, &cases[i]);
    }
    dm_joint joint = test_hinge();
    joint.lower = joint.upper = FLT_MAX;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &joint), DM_ERROR_INVALID_ARGUMENT);
    test_world_close(&w);
}

/* ---- numbers that can't be meant ---- */

/* Begins with a point and a value; returns how many warnings came. */
static uint64_t warnings(test_world* w, dm_object object, dm_vec3 point, float value, float dt) {
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .part_id = TEST_DOOR, .object = object, .grab_point = point, .start_value = value};
    dm_drag drag = 0;
    dm_drag_state now = dm_drag_state_default();
    const dm_ray ray = test_ray_to(test_pull().point);
    w->messages.count = 0, w->messages.text[0] = 0;
    assert_int_equal(dm_drag_begin(w->context, &desc, &drag), DM_OK);
    for (int i = 0; i < 3; i++) assert_int_equal(dm_drag_update(w->context, drag, &ray, dt, &now), DM_OK);
    assert_true(isfinite(now.value) && isfinite(now.pose.real[0]) && isfinite(now.pose.dual[0]));
    assert_int_equal(dm_drag_end(w->context, drag, NULL), DM_OK);
    return (uint64_t)w->messages.count;
}

static void what_cannot_be_meant_is_named_once(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_joint hinge = test_hinge();
    const dm_vec3 grab = test_pull().point, far = {910, 500, 1070};
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
    assert_int_equal(warnings(&w, object, grab, 0.4f, 0.016f), 0);
    assert_int_equal(warnings(&w, object, far, 0, 0.016f), 1);
    assert_non_null(strstr(w.messages.text, "object sizes away"));
    assert_int_equal(warnings(&w, object, grab, 60, 0.016f), 1);
    assert_non_null(strstr(w.messages.text, "degrees"));
    assert_int_equal(warnings(&w, object, grab, 0, 16), 1);
    assert_non_null(strstr(w.messages.text, "milliseconds"));
    dm_joint slide = {.struct_size = sizeof slide, .type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .upper = 0.5f};
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &slide), DM_OK);
    assert_int_equal(warnings(&w, object, grab, 300, 0.016f), 1);
    assert_non_null(strstr(w.messages.text, "millimetres"));
    dm_joint degrees = hinge;
    degrees.upper = 90;
    w.messages.count = 0;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &degrees), DM_OK);
    assert_int_equal(w.messages.count, 1);
    assert_non_null(strstr(w.messages.text, "Were degrees meant"));
    test_world_close(&w);
}

/* ---- scaled instances ---- */

static dm_vec3 times(dm_vec3 a, dm_vec3 b) {
    return (dm_vec3){a.x * b.x, a.y * b.y, a.z * b.z};
}

/* A hinge of an instance with any scale keeps the grabbed point on the pointer, by rigid poses. */
static void scaled_instances_open_without_shear(void** state) {
    (void)state;
    const dm_vec3 scales[] = {{1, 1, 1}, {2, 1, 0.5f}, {3, 3, 3}, {-1, 1, 1}, {0.5f, -2, 1.5f}};
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_joint hinge = test_hinge();
    for (int held = 0; held < 2; held++) {
        if (held) assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
        for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
            dm_joint joint = dm_joint_default();
            assert_int_equal(dm_joint_scale(&hinge, scales[i], &joint), DM_OK);
            const dm_vec3 grab = times(test_pull().point, scales[i]);
            const dm_drag_desc desc = {.struct_size = sizeof desc,
                                       .part_id = TEST_DOOR,
                                       .object = object,
                                       .grab_point = grab,
                                       .scale = scales[i]};
            dm_drag drag = 0;
            dm_drag_state now = dm_drag_state_default();
            assert_int_equal(dm_drag_begin(w.context, &desc, &drag), DM_OK);
            dm_vec3 aim = grab;
            for (int k = 0; k <= 90; k++) {
                aim = moved(&joint, 1.2f * fminf((float)k / 60, 1), grab);
                const dm_ray ray = {{9, 7, 16}, {aim.x - 9, aim.y - 7, aim.z - 16}};
                assert_int_equal(dm_drag_update(w.context, drag, &ray, 0.016f, &now), DM_OK);
            }
            if (held) assert_true(fabsf(now.value - 1.2f) < 0.01f);
            const float* r = now.pose.real;
            assert_true(fabsf(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3] - 1) < 1e-5f);
            if (held) {
                const dm_vec3 g = now.grab_point;
                assert_true(fabsf(g.x - aim.x) + fabsf(g.y - aim.y) + fabsf(g.z - aim.z) < 0.05f);
            }
            dm_release_plan plan = dm_release_plan_default();
            assert_int_equal(dm_drag_release(w.context, drag, NULL, &plan), DM_OK);
            dm_part_state end = dm_part_state_default();
            assert_int_equal(dm_drag_end(w.context, drag, &end), DM_OK);
            if (held) assert_memory_equal(&end.joint.axis, &joint.axis, sizeof joint.axis);
        }
    }
    dm_drag drag = 0;
    dm_drag_desc flat = {.struct_size = sizeof flat, .part_id = TEST_DOOR, .object = object, .scale = {1, 0, 1}};
    assert_int_equal(dm_drag_begin(w.context, &flat, &drag), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(w.messages.text, "desc.scale"));
    flat.scale.y = (float)NAN;
    assert_int_equal(dm_drag_begin(w.context, &flat, &drag), DM_ERROR_NOT_FINITE);
    test_world_close(&w);
}

/* A saved drag can be restored: so what a scale would take beyond the largest number of a host is refused. */
static void a_scale_takes_no_joint_beyond_what_hosts_may_have(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    dm_joint far = dm_joint_default(), scaled = dm_joint_default();
    far.type = DM_JOINT_REVOLUTE, far.axis = (dm_vec3){0, 1, 0}, far.origin = (dm_vec3){0, 0, 2000}, far.upper = 1;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &far), DM_OK);
    for (int beyond = 0; beyond < 2; beyond++) {
        const dm_vec3 scale = {1, 1, beyond ? 6e5f : 4e5f};
        const dm_drag_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .object = object, .scale = scale};
        const dm_result expected = beyond ? DM_ERROR_INVALID_ARGUMENT : DM_OK;
        uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
        dm_drag drag = 0;
        assert_int_equal(dm_joint_scale(&far, scale, &scaled), expected);
        assert_int_equal(dm_drag_begin(w.context, &desc, &drag), expected);
        if (beyond) break;
        assert_int_equal(dm_drag_save(w.context, drag, saved, sizeof saved), DM_OK);
        assert_int_equal(dm_drag_restore(w.context, drag, saved, sizeof saved), DM_OK);
        assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
    }
    assert_non_null(strstr(w.messages.text, "desc.scale: the scaled joint.origin.z is 1.2e+09"));
    test_world_close(&w);
}

/* The network paces a scaled slide as it paces the plain one. */
static void a_scaled_release_is_paced_by_the_network(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    const dm_object object = test_world_cabinet(&w);
    const dm_joint slide = {.struct_size = sizeof slide, .type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .upper = 0.5f};
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &slide), DM_OK);
    for (int scaled = 0; scaled < 2; scaled++) {
        const dm_vec3 scale = {1, 1, scaled ? 6.0f : 1.0f};
        const dm_drag_desc desc = {.struct_size = sizeof desc,
                                   .part_id = TEST_DOOR,
                                   .object = object,
                                   .grab_point = times(test_pull().point, scale),
                                   .scale = scale};
        const dm_release_desc wish = {.struct_size = sizeof wish, .intent = DM_INTENT_OPEN};
        dm_release_plan plan = dm_release_plan_default();
        dm_drag drag = 0;
        assert_int_equal(dm_drag_begin(w.context, &desc, &drag), DM_OK);
        assert_int_equal(dm_drag_release(w.context, drag, &wish, &plan), DM_OK);
        assert_int_equal(plan.from_network, 1);
        assert_true(plan.end_value == 0.5f * scale.z);
    }
    test_world_close(&w);
}

/* ---- snapshots ---- */

typedef struct recording {
    dm_drag_state frames[120];
} recording;

static void record(const test_world* w, dm_drag drag, const dm_joint* along, recording* out) {
    memset(out, 0, sizeof *out);
    for (int k = 0; k < 120; k++) {
        const dm_ray ray = test_ray_to(moved(along, 0.2f + 0.01f * (float)k, test_pull().point));
        out->frames[k].struct_size = sizeof out->frames[k];
        if (k == 80) assert_int_equal(dm_drag_release(w->context, drag, NULL, NULL), DM_OK);
        assert_int_equal(dm_drag_update(w->context, drag, k < 80 ? &ray : NULL, 0.016f, &out->frames[k]), DM_OK);
    }
}

static void a_restored_drag_gives_the_same_bits(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_joint hinge = test_hinge();
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    recording first, second, third;
    const size_t size = dm_drag_snapshot_size();
    assert_true(size > 0 && size <= sizeof saved);
    const dm_drag drag = begin(&w, object, test_pull().point, NULL);
    pull(&w, drag, &hinge, 0, 0.2f, 0);
    const int64_t calls = w.memory.calls;
    assert_int_equal(dm_drag_save(w.context, drag, saved, sizeof saved), DM_OK);
    record(&w, drag, &hinge, &first);
    assert_int_equal(dm_drag_restore(w.context, drag, saved, size), DM_OK);
    record(&w, drag, &hinge, &second);
    assert_memory_equal(&first, &second, sizeof first);
    assert_int_equal(w.memory.calls, calls); /* no memory, not a word */
    assert_int_equal(w.messages.count, 0);
    const dm_drag other = begin(&w, object, test_pull().point, NULL);
    assert_int_equal(dm_drag_restore(w.context, other, saved, size), DM_OK);
    record(&w, other, &hinge, &third);
    assert_memory_equal(&first, &third, sizeof first);
    test_world_close(&w);
}

static void snapshots_of_other_things_are_refused(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX], bad[DM_DRAG_SNAPSHOT_MAX];
    const size_t size = dm_drag_snapshot_size();
    const dm_drag drag = begin(&w, object, test_pull().point, NULL);
    const dm_drag_desc handle = {.struct_size = sizeof handle, .part_id = TEST_HANDLE, .object = object};
    dm_drag other = 0;
    assert_int_equal(dm_drag_begin(w.context, &handle, &other), DM_OK);
    assert_int_equal(dm_drag_save(w.context, drag, saved, size - 1), DM_ERROR_BUFFER_TOO_SMALL);
    assert_int_equal(dm_drag_save(w.context, drag, NULL, size), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_save(w.context, drag, saved, size), DM_OK);
    assert_int_equal(dm_drag_restore(w.context, other, saved, size), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_restore(w.context, drag, NULL, size), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_restore(w.context, drag, saved, size - 1), DM_ERROR_BAD_DATA);
    assert_int_equal(dm_drag_restore(w.context, drag, saved, 0), DM_ERROR_BAD_DATA);
    for (size_t i = 0; i < size; i += 13) { /* any byte that is off */
        memcpy(bad, saved, size);
        bad[i] ^= 0x55;
        const dm_result result = dm_drag_restore(w.context, drag, bad, size);
        if (i >= 4 && i < 12) assert_int_equal(result, DM_ERROR_VERSION);
        if (result == DM_OK) assert_true(i >= 12 && i < 16); /* reserved */
    }
    assert_int_equal(dm_drag_restore(w.context, object, saved, size), DM_ERROR_STALE_HANDLE);
    test_world_close(&w);
}

/* Plays a drag and a release by rule on the object of a file, on one instruction set. */
static void play_on(dmi_isa isa, const uint8_t* file, size_t size, recording* out) {
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    w.context->isa = isa;
    test_world_load_model(&w);
    const dm_joint hinge = test_hinge();
    dm_object object = 0;
    assert_int_equal(dm_object_load(w.context, file, size, w.model, &object), DM_OK);
    const dm_release_desc rule = {.struct_size = sizeof rule, .intent = DM_INTENT_OPEN, .flags = DM_RELEASE_BY_RULE};
    const dm_drag drag = begin(&w, object, test_pull().point, NULL);
    memset(out, 0, sizeof *out);
    for (int k = 0; k < 120; k++) {
        const dm_ray ray = test_ray_to(moved(&hinge, 0.01f * (float)k, test_pull().point));
        out->frames[k].struct_size = sizeof out->frames[k];
        if (k == 60) assert_int_equal(dm_drag_release(w.context, drag, &rule, NULL), DM_OK);
        assert_int_equal(dm_drag_update(w.context, drag, k < 60 ? &ray : NULL, 0.016f, &out->frames[k]), DM_OK);
    }
    test_world_close(&w);
}

static void drags_have_the_same_bits_on_every_instruction_set(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    static uint8_t file[1 << 20];
    size_t size = 0;
    static recording plain, fast;
    assert_int_equal(dm_object_save(w.context, object, file, sizeof file, &size), DM_OK);
    play_on(DMI_ISA_SCALAR, file, size, &plain);
    play_on(dmi_cpu_best_isa(), file, size, &fast);
    assert_memory_equal(&plain, &fast, sizeof plain);
    test_world_close(&w);
}

/* ---- snapshots that mean harm ---- */

/* Goes on with a drag whose saved bytes were changed at `place`: numbers are finite, rotations unit. */
static void expect_sound_frames(const test_world* w, dm_drag drag, size_t place) {
    const dm_joint hinge = test_hinge();
    dm_drag_state now = dm_drag_state_default();
    for (int frame = 0; frame < 8; frame++) {
        dm_drag_input input = dm_drag_input_default();
        input.hand.kind = DM_HAND_RAY;
        input.hand.ray = test_ray_to(moved(&hinge, 0.4f + 0.1f * (float)frame, test_pull().point));
        if (frame % 4 == 3) input.second = (dm_hand){.kind = DM_HAND_POINT, .point = test_pull().point};
        assert_int_equal(dm_drag_step(w->context, drag, &input, 0.016f, &now), DM_OK);
        if (!test_state_is_finite(&now)) fail_msg("byte %zu: frame %d is not finite", place, frame);
        const float* q = now.pose.real;
        const float length = sqrtf(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (fabsf(length - 1) > 1e-4f) fail_msg("byte %zu: frame %d has a rotation of length %g", place, frame, length);
    }
}

/* Restores a saved drag with other content at `at`, its checksum set right. */
static dm_result restore_changed(const test_world* w, dm_drag drag, const uint8_t* saved, size_t at,
                                 const void* content, size_t count) {
    uint8_t bad[DM_DRAG_SNAPSHOT_MAX];
    const size_t size = dm_drag_snapshot_size();
    memcpy(bad, saved, size);
    memcpy(bad + at, content, at + count <= size ? count : size - at);
    test_snapshot_sign(bad, size);
    const dm_result result = dm_drag_restore(w->context, drag, bad, size);
    assert_true(result == DM_OK || result == DM_ERROR_BAD_DATA);
    return result;
}

/* Bytes that mean harm are refused or harmless: no crash, whatever they hold. */
static void expect_harmless_bytes(const test_world* w, dm_drag drag, const uint8_t* saved) {
    static const uint8_t contents[][4] = {{0}, {1}, {2}, {0x7f}, {0x80}, {0xff, 0xff, 0xff, 0xff}};
    const dm_joint hinge = test_hinge();
    uint32_t taken = 0, refused = 0;
    for (size_t i = 32; i < dm_drag_snapshot_size(); i++) {
        for (size_t k = 0; k < sizeof contents / sizeof *contents; k++) {
            const dm_result result = restore_changed(w, drag, saved, i, contents[k], k == 5 ? 4 : 1);
            taken += result == DM_OK, refused += result != DM_OK;
            if (result != DM_OK || k % 3 != 0) continue;
            dm_drag_state now = dm_drag_state_default();
            for (int frame = 0; frame < 4; frame++) {
                const dm_ray ray = test_ray_to(moved(&hinge, 0.4f + 0.1f * (float)frame, test_pull().point));
                assert_int_equal(dm_drag_update(w->context, drag, &ray, 0.016f, &now), DM_OK);
            }
        }
    }
    assert_true(taken > 0 && refused > 0);
}

/* A drag that is taken with another number goes on with finite numbers and unit rotations. */
static void expect_harmless_numbers(const test_world* w, dm_drag drag, const uint8_t* saved) {
    static const float numbers[] = {NAN,   INFINITY, -INFINITY, FLT_MAX, -1e30f, 1e15f,
                                    -1e9f, FLT_MIN,  -FLT_MIN,  1e-45f,  0,      -1};
    for (size_t i = 32; i + sizeof(float) <= dm_drag_snapshot_size(); i += sizeof(float)) {
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
            if (restore_changed(w, drag, saved, i, &numbers[k], sizeof(float)) == DM_OK)
                expect_sound_frames(w, drag, i);
        for (int k = 1; k <= 4; k++) {
            float number;
            memcpy(&number, saved + i, sizeof number);
            number *= 1 + 0.0004f * (float)k; /* a little off */
            if (restore_changed(w, drag, saved, i, &number, sizeof number) == DM_OK) expect_sound_frames(w, drag, i);
        }
    }
}

static void save_signed(const test_world* w, dm_drag drag, uint8_t saved[DM_DRAG_SNAPSHOT_MAX]) {
    uint8_t again[DM_DRAG_SNAPSHOT_MAX];
    const size_t size = dm_drag_snapshot_size();
    assert_int_equal(dm_drag_save(w->context, drag, saved, DM_DRAG_SNAPSHOT_MAX), DM_OK);
    memcpy(again, saved, size);
    test_snapshot_sign(again, size);
    assert_memory_equal(again, saved, size); /* or these tests test nothing */
}

static void hostile_snapshots_do_no_harm(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_joint hinge = test_hinge();
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    const dm_drag drag = begin(&w, object, test_pull().point, NULL);
    pull(&w, drag, &hinge, 0, 0.4f, 0);
    save_signed(&w, drag, saved);
    expect_harmless_bytes(&w, drag, saved);
    expect_harmless_numbers(&w, drag, saved);
    test_world_close(&w);
}

#define SNAP_REACH 0.0625f /* of no other number of the drag below */

static void hostile_snapshots_of_rules_do_no_harm(void** state) {
    (void)state;
    test_world w;
    dm_object object;
    open_world(&w, &object);
    const dm_joint hinge = test_hinge();
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    dm_drag_rules rules = test_every_rule();
    rules.snap_reach = SNAP_REACH;
    const dm_drag drag = begin_ruled(&w, object, test_pull().point, &rules, NULL);
    pull(&w, drag, &hinge, 0, 0.4f, 0);
    save_signed(&w, drag, saved);
    expect_harmless_numbers(&w, drag, saved);
    /* How far an outermost snap value reaches: as far as objects are large, and no farther. */
    const float reaches[2] = {SNAP_REACH, SNAP_REACH}, fair = 1e9f, far = 1e17f;
    size_t at = 32;
    while (memcmp(saved + at, reaches, sizeof reaches) != 0) at += sizeof(float);
    assert_int_equal(restore_changed(&w, drag, saved, at + sizeof(float), &fair, sizeof fair), DM_OK);
    assert_int_equal(restore_changed(&w, drag, saved, at + sizeof(float), &far, sizeof far), DM_ERROR_BAD_DATA);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_next_drag_begins_where_the_last_ended),
        cmocka_unit_test(a_new_grab_may_change_the_joint),
        cmocka_unit_test(states_belong_to_instances),
        cmocka_unit_test(a_bad_state_is_refused_by_name),
        cmocka_unit_test(every_number_of_a_joint_is_checked),
        cmocka_unit_test(a_newer_state_is_taken),
        cmocka_unit_test(numbers_beyond_computing_are_refused),
        cmocka_unit_test(endless_times_give_finite_poses),
        cmocka_unit_test(parts_that_may_hardly_move_give_finite_poses),
        cmocka_unit_test(updates_of_almost_no_time_give_finite_speeds),
        cmocka_unit_test(scalars_over_endless_updates_ask_for_finite_values),
        cmocka_unit_test(outputs_fit_the_callers_version),
        cmocka_unit_test(setting_the_joint_that_is_there_changes_nothing),
        cmocka_unit_test(other_engines_words_for_no_limit_are_understood),
        cmocka_unit_test(what_cannot_be_meant_is_named_once),
        cmocka_unit_test(scaled_instances_open_without_shear),
        cmocka_unit_test(a_scale_takes_no_joint_beyond_what_hosts_may_have),
        cmocka_unit_test(a_scaled_release_is_paced_by_the_network),
        cmocka_unit_test(a_restored_drag_gives_the_same_bits),
        cmocka_unit_test(drags_have_the_same_bits_on_every_instruction_set),
        cmocka_unit_test(snapshots_of_other_things_are_refused),
        cmocka_unit_test(hostile_snapshots_do_no_harm),
        cmocka_unit_test(hostile_snapshots_of_rules_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
