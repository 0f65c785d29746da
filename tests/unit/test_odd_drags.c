/* Drags with odd numbers in every field that takes one, from the smallest to the largest float: whatever is taken gives
 * finite numbers and unit rotations, what is saved is restored, and what a drag ends with begins another one. */
#include <math.h>
#include <stdbool.h>

#include "test_odd.h"
#include "test_snapshot.h"
#include "test_world.h"

enum { DRAGS = 60000, FRAMES = 24 };

static const float times[] = {0, 1e-45f, 1e-9f, 1e-6f, 0.004f, 1.0f / 60, 1.0f / 60, 0.5f, 10, 1e6f, 1e12f, 3e38f};

static float odd_time(dmi_random* random) {
    return times[dmi_random_u32(random) % (sizeof times / sizeof *times)];
}

/* How much of what was tried was taken: refusals alone would show nothing. */
static struct { int drags, steps, values, plans; } taken;

/* ---- one odd drag ---- */

/* What a drag is begun with. */
typedef struct beginning {
    dm_drag_desc desc;
    dm_drag_rules rules;
    dm_part_state state;
    float snaps[2];
} beginning;

static void odd_rules(dmi_random* random, beginning* b) {
    dm_drag_rules* r = &b->rules;
    float* const fields[] = {&r->snap_reach,       &r->open_share,       &r->closed_share,   &r->event_time,
                             &r->max_speed,        &r->max_acceleration, &r->lock_give,      &r->latch_turn,
                             &r->auto_close_share, &r->auto_close_time,  &r->close_delay,    &r->tip_share,
                             &r->fall_time,        &r->restitution,      &r->break_distance, &r->drive_speed};
    *r = (dm_drag_rules){.struct_size = sizeof *r, .flags = dmi_random_u32(random) % 4};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        if (test_once_in(random, 4)) *fields[i] = test_odd(random);
    }
    const float one = test_once_in(random, 4) ? test_odd(random) : 0.2f;
    b->snaps[0] = fminf(one, 0.9f), b->snaps[1] = fmaxf(one, 0.9f);
    if (test_once_in(random, 2)) r->snaps = b->snaps, r->snap_count = 2;
    if (!test_once_in(random, 3)) b->desc.rules = r;
}

static void odd_feel(dmi_random* random, dm_drag_desc* desc) {
    dm_drag_feel* f = &desc->feel;
    float* const fields[] = {&f->smoothing_time, &f->soft_limit,  &f->coast_time,   &f->detent,
                             &f->detent_pull,    &f->return_time, &desc->limit_give};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        if (test_once_in(random, 4)) *fields[i] = test_odd(random);
    }
    if (desc->rules != NULL && desc->rules->snap_count > 0) f->detent = 0; /* both are refused */
}

static void odd_state(dmi_random* random, beginning* b) {
    dm_joint* joint = &b->state.joint;
    b->state = dm_part_state_default();
    *joint = test_hinge();
    joint->type = DM_JOINT_REVOLUTE + (int32_t)(dmi_random_u32(random) % 5);
    float* const fields[] = {&joint->lower,    &joint->upper,  &joint->pitch,  &joint->origin.x, &joint->origin.y,
                             &joint->origin.z, &joint->axis.x, &joint->axis.y, &joint->axis.z};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        if (test_once_in(random, i < 3 ? 3 : 10)) *fields[i] = test_odd(random);
    }
    const float rotation[4] = {test_odd(random), test_odd(random), test_odd(random), test_odd(random)};
    if (test_once_in(random, 6)) dm_pose_from_rotation(rotation, test_odd_vector(random), &b->state.pose);
    b->state.value = test_once_in(random, 2) ? 0.5f : test_odd(random);
    if (test_once_in(random, 3)) b->state.velocity = test_odd(random);
    if (test_once_in(random, 2)) b->desc.state = &b->state;
}

static void odd_beginning(dmi_random* random, dm_object object, beginning* b) {
    b->desc = (dm_drag_desc){.struct_size = sizeof b->desc,
                             .part_id = TEST_DOOR,
                             .object = object,
                             .grab_point = test_pull().point,
                             .flags = dmi_random_u32(random) % 4};
    if (test_once_in(random, 8)) b->desc.grab_point = test_odd_vector(random);
    odd_rules(random, b);
    odd_feel(random, &b->desc);
    odd_state(random, b);
    if (b->desc.state == NULL && test_once_in(random, 4)) b->desc.start_value = test_odd(random);
    if (test_once_in(random, 4)) b->desc.scale = test_odd_vector(random);
}

static dm_hand odd_hand(dmi_random* random, uint32_t kinds, dm_vec3 at) {
    dm_hand hand = {
        .kind = (int32_t)(dmi_random_u32(random) % kinds), .ray = test_ray_to(at), .point = at, .grab_point = at};
    float* const fields[] = {&hand.point.x,         &hand.point.y,        &hand.point.z,      &hand.ray.origin.x,
                             &hand.ray.origin.y,    &hand.ray.origin.z,   &hand.grab_point.x, &hand.ray.direction.x,
                             &hand.ray.direction.y, &hand.ray.direction.z};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        if (test_once_in(random, 20)) *fields[i] = test_odd(random);
    }
    hand.amount = test_once_in(random, 3) ? test_odd(random) : 0.2f;
    return hand;
}

static dm_drag_input odd_input(dmi_random* random, bool ruled, int frame) {
    const dm_joint hinge = test_hinge();
    const dm_vec3 at = test_point_on(&hinge, 0.05f * (float)frame);
    dm_drag_input input = dm_drag_input_default();
    input.hand = odd_hand(random, DM_HAND_VALUE + 1, at);
    if (test_once_in(random, 4)) input.second = odd_hand(random, DM_HAND_POINT + 1, at);
    if (test_once_in(random, 3)) input.flags |= DM_INPUT_ASK;
    if (!ruled) return input;
    if (test_once_in(random, 4))
        input.lower = test_odd(random), input.upper = test_odd(random), input.flags |= DM_INPUT_BOUNDS;
    if (test_once_in(random, 6)) input.handles[0] = test_odd(random), input.handles[1] = test_odd(random);
    if (test_once_in(random, 9)) input.flags |= DM_INPUT_LOCKED;
    return input;
}

/* ---- what holds of it ---- */

static void expect_sound(const dm_drag_state* now, int which, const char* after) {
    if (test_state_is_finite(now) && test_is_sound_pose(&now->pose)) return;
    fail_msg("drag %d, %s: value %g, target %g, velocity %g, impact %g, rotation %g %g %g %g", which, after, now->value,
             now->target, now->velocity, now->impact, now->pose.real[0], now->pose.real[1], now->pose.real[2],
             now->pose.real[3]);
}

static void expect_restored(const test_world* w, dm_drag drag, const dm_drag_state* now, int which) {
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    assert_int_equal(dm_drag_save(w->context, drag, saved, sizeof saved), DM_OK);
    if (dm_drag_restore(w->context, drag, saved, dm_drag_snapshot_size()) == DM_OK) return;
    fail_msg("drag %d is not restored: value %g, target %g, velocity %g, phase %d", which, now->value, now->target,
             now->velocity, now->phase);
}

static void odd_release(const test_world* w, dmi_random* random, dm_drag drag, int which) {
    dm_release_plan plan = dm_release_plan_default();
    dm_release_desc desc = {.struct_size = sizeof desc, .intent = (int32_t)(dmi_random_u32(random) % 7)};
    if (test_once_in(random, 2)) desc.duration = test_odd(random);
    if (dm_drag_release(w->context, drag, &desc, &plan) != DM_OK) return;
    taken.plans++;
    if (!isfinite(plan.start_value) || !isfinite(plan.end_value) || !isfinite(plan.duration))
        fail_msg("drag %d: planned from %g to %g in %g s", which, plan.start_value, plan.end_value, plan.duration);
}

static void odd_step(const test_world* w, dmi_random* random, dm_drag drag, bool ruled, float dt, int which,
                     int frame) {
    dm_drag_state now = dm_drag_state_default();
    const dm_drag_input input = odd_input(random, ruled, frame);
    const float instead = test_odd(random);
    if (dm_drag_step(w->context, drag, &input, dt, &now) != DM_OK) return;
    taken.steps++;
    expect_sound(&now, which, "a step");
    if (input.flags & DM_INPUT_ASK && dm_drag_take(w->context, drag, instead, &now) == DM_OK) {
        taken.values++;
        expect_sound(&now, which, "another value");
    }
    expect_restored(w, drag, &now, which);
}

static void expect_begun_again(const test_world* w, beginning* b, const dm_part_state* end, int which) {
    dm_drag again = 0;
    b->desc.state = end;
    b->desc.start_value = 0;
    b->desc.flags |= DM_DRAG_WITHOUT_POINT; /* taken hold of where it is shown */
    if (dm_drag_begin(w->context, &b->desc, &again) != DM_OK)
        fail_msg("drag %d: does not begin where it ended: %s", which, w->messages.text);
    assert_int_equal(dm_drag_end(w->context, again, NULL), DM_OK);
}

static void odd_drag(test_world* w, dm_object object, int which) {
    dmi_random random = dmi_random_make((uint64_t)which, 1);
    beginning b;
    dm_drag drag = 0;
    dm_part_state end = dm_part_state_default();
    odd_beginning(&random, object, &b);
    if (dm_drag_begin(w->context, &b.desc, &drag) != DM_OK) return;
    taken.drags++;
    const int released = 5 + (int)(dmi_random_u32(&random) % 12);
    float dt = odd_time(&random);
    for (int frame = 0; frame < FRAMES; frame++) {
        if (test_once_in(&random, 6)) dt = odd_time(&random);
        if (frame == released) odd_release(w, &random, drag, which);
        odd_step(w, &random, drag, b.desc.rules != NULL, dt, which, frame);
    }
    assert_int_equal(dm_drag_end(w->context, drag, &end), DM_OK);
    expect_begun_again(w, &b, &end, which);
}

static void odd_drags_stay_sound(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    const dm_object object = test_world_cabinet(&w);
    for (int i = 0; i < DRAGS; i++) odd_drag(&w, object, i);
    if (taken.drags < DRAGS / 8 || taken.steps < 10 * taken.drags || taken.values < taken.drags ||
        taken.plans < taken.drags / 4)
        fail_msg("only %d drags, %d steps, %d values and %d plans were taken", taken.drags, taken.steps, taken.values,
                 taken.plans);
    test_world_close(&w);
}

/* ---- single numbers ---- */

static void expect_refused(test_world* w, const dm_drag_desc* desc, const char* says) {
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(w->context, desc, &drag), DM_ERROR_INVALID_ARGUMENT);
    assert_true(drag == 0);
    if (strstr(w->messages.text, says) == NULL) fail_msg("'%s' does not say '%s'", w->messages.text, says);
}

static void what_is_too_far_is_refused_by_name(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_part_state part = dm_part_state_default();
    dm_drag_desc desc = {.struct_size = sizeof desc,
                         .part_id = TEST_DOOR,
                         .object = test_world_cabinet(&w),
                         .grab_point = test_pull().point,
                         .state = &part};
    part.joint = test_hinge();
    part.joint.type = DM_JOINT_SCREW;
    part.joint.pitch = 1e7f;
    part.value = 200;
    expect_refused(&w, &desc, "the value is 200: with the screw's pitch 1e+07, values beyond 100");
    part.joint = test_hinge();
    part.joint.origin.x = 9e8f;
    part.value = 3;
    expect_refused(&w, &desc, "the grabbed point, with the part at rest: x is");
    part.value = 0;
    part.pose.real[3] = 1;
    part.pose.dual[1] = 5e9f;
    expect_refused(&w, &desc, "desc.state.pose.dual[1] is 5e+09");
    test_world_close(&w);
}

/* Lets go of an open door and returns its state after one update of dt seconds. */
static dm_drag_state fall_shut(const test_world* w, dm_object object, float dt) {
    const dm_joint hinge = test_hinge();
    const dm_part_state part = {.struct_size = sizeof part, .joint = hinge, .value = 1};
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = TEST_DOOR,
                               .object = object,
                               .flags = DM_DRAG_WITHOUT_POINT,
                               .state = &part};
    const dm_release_desc close = {.struct_size = sizeof close, .intent = DM_INTENT_CLOSE, .duration = 1};
    dm_drag_state now = dm_drag_state_default();
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(w->context, &desc, &drag), DM_OK);
    assert_int_equal(dm_drag_release(w->context, drag, &close, NULL), DM_OK);
    assert_int_equal(dm_drag_update(w->context, drag, NULL, dt, &now), DM_OK);
    assert_int_equal(dm_drag_end(w->context, drag, NULL), DM_OK);
    return now;
}

static void next_to_no_time_is_none_and_the_longest_is_over(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    const dm_object object = test_world_cabinet(&w);
    const dm_drag_state before = fall_shut(&w, object, 1e-12f), half = fall_shut(&w, object, 0.5f),
                        after = fall_shut(&w, object, 3e38f);
    assert_true(before.value == 1 && before.velocity == 0 && before.phase == DM_DRAG_RELEASED);
    assert_true(half.value > 0.3f && half.value < 0.7f && half.velocity < -0.5f);
    assert_true(after.value == 0 && after.phase == DM_DRAG_AT_REST);
    test_world_close(&w);
}

/* Where the stand-in of a limit that is none would lie beyond the largest value, the slide still has one limit. */
static void a_huge_slide_with_one_limit_keeps_the_one(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    for (uint32_t i = 0; i < 3 * w.shape.vertex_count; i++) w.shape.xyz[i / 3][i % 3] *= 2e7f; /* micrometres */
    test_world_open(&w);
    dm_part_state part = dm_part_state_default();
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = TEST_DOOR,
                               .object = test_world_cabinet(&w),
                               .flags = DM_DRAG_WITHOUT_POINT,
                               .state = &part};
    const dm_drag_input nothing = dm_drag_input_default();
    part.joint = test_hinge();
    part.joint.type = DM_JOINT_PRISMATIC;
    part.joint.source = DM_JOINT_FROM_HOST;
    part.joint.upper = INFINITY;
    for (int again = 0; again < 2; again++) {
        dm_drag_state now = dm_drag_state_default();
        dm_drag drag = 0;
        part.value = 1e9f;
        assert_int_equal(dm_drag_begin(w.context, &desc, &drag), DM_OK);
        assert_int_equal(dm_drag_step(w.context, drag, &nothing, 0.016f, &now), DM_OK);
        assert_true(now.value == 1e9f && now.at_limit == 0);
        assert_int_equal(dm_drag_end(w.context, drag, &part), DM_OK);
    }
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(odd_drags_stay_sound),
                                       cmocka_unit_test(what_is_too_far_is_refused_by_name),
                                       cmocka_unit_test(next_to_no_time_is_none_and_the_longest_is_over),
                                       cmocka_unit_test(a_huge_slide_with_one_limit_keeps_the_one)};
    return cmocka_run_group_tests_name("odd_drags", tests, NULL, NULL);
}
