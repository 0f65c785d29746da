/* All words of a drag at once, in any order: values stay finite and inside their bounds, nothing jumps without an
 * event, the same calls give the same bits, and an update takes as long as it may. */
#include "test_rules.h"

enum { UPDATES = 6000, SEQUENCES = 64 };

#define DT (1.0f / 144)
#define JUMP 0.01f   /* of the range, between one step and the next */
#define REASON 0.25f /* s for which an event is a reason: what comes free catches up, what is pushed goes back */

static const float places[2] = {0.3f, 0.75f};

/* Any of the rules, each off as often as on. */
static dm_drag_rules any_rules(dmi_random* random) {
    dm_drag_rules rules = {.struct_size = sizeof rules};
    rules.flags = dmi_random_u32(random) % 4 == 0 ? DM_RULE_LATCH : 0;
    float* const numbers[] = {&rules.event_time,  &rules.max_speed,   &rules.max_acceleration, &rules.auto_close_share,
                              &rules.close_delay, &rules.tip_share,   &rules.restitution,      &rules.break_distance,
                              &rules.fall_time,   &rules.drive_speed, &rules.lock_give};
    static const float most[] = {0.5f, 2, 8, 0.2f, 0.5f, 0.9f, 0.9f, 0.5f, 1, 2, 0.05f};
    for (size_t i = 0; i < sizeof most / sizeof *most; i++)
        if (dmi_random_u32(random) % 2) *numbers[i] = test_range(random, 0.1f * most[i], most[i]);
    if (dmi_random_u32(random) % 2) rules.snaps = places, rules.snap_count = 2;
    return rules;
}

static dm_drag_feel any_feel(dmi_random* random, bool has_snaps) {
    dm_drag_feel feel = {0};
    if (dmi_random_u32(random) % 3 == 0) feel.smoothing_time = test_range(random, 0.02f, 0.2f);
    if (dmi_random_u32(random) % 3 == 0) feel.coast_time = test_range(random, 0.02f, 0.3f);
    if (dmi_random_u32(random) % 3 == 0) feel.soft_limit = 0.05f;
    if (dmi_random_u32(random) % 3 == 0) feel.return_time = test_range(random, 0.3f, 1);
    if (!has_snaps && dmi_random_u32(random) % 3 == 0) feel.detent = 0.1f;
    return feel;
}

/* A hand that wanders, with what is held, blocked and turned changing now and then. */
typedef struct player {
    dmi_random random;
    float x, speed;
    dm_drag_input input;
} player;

static void play_on(player* p, int update) {
    dmi_random* random = &p->random;
    dm_drag_input* in = &p->input;
    in->struct_size = sizeof *in;
    p->speed = fminf(fmaxf(p->speed + test_range(random, -0.1f, 0.1f), -1), 1);
    p->x = fminf(fmaxf(p->x + p->speed * DT, -0.5f), 1.5f);
    if (update % 200 == 0) {
        static const int32_t kinds[] = {DM_HAND_RAY,   DM_HAND_RAY,  DM_HAND_POINT,
                                        DM_HAND_POINT, DM_HAND_RATE, DM_HAND_NONE};
        in->hand.kind = kinds[dmi_random_u32(random) % 6];
        in->second.kind =
            in->hand.kind <= DM_HAND_POINT && dmi_random_u32(random) % 3 == 0 ? DM_HAND_POINT : DM_HAND_NONE;
        in->flags = dmi_random_u32(random) % 6 == 0 ? DM_INPUT_LOCKED : 0;
        in->handles[0] = dmi_random_u32(random) % 2 ? 1.0f : 0.0f;
        const bool free = dmi_random_u32(random) % 2;
        in->lower = free ? 0 : test_range(random, -0.2f, 0.3f), in->upper = free ? 0 : test_range(random, 0.4f, 1.2f);
    }
    in->hand.ray = test_ray_at(p->x);
    in->hand.point = (dm_vec3){p->x, 0, 0};
    in->hand.amount = p->speed;
    in->second.point = (dm_vec3){p->x + 0.05f, 1, 0};
}

static void check(const dm_drag_state* now, const dm_drag_state* last, const dm_drag_state* before, float calm) {
    assert_true(isfinite(now->value) && isfinite(now->velocity) && isfinite(now->target) && isfinite(now->impact));
    assert_true(now->value >= 0 && now->value <= 1 && now->detents <= 12);
    const float change = (now->value - last->value) - (last->value - before->value);
    if (!(fabsf(change) > JUMP) || calm < REASON) return;
    fail_msg("%g, %g, %g without an event", (double)before->value, (double)last->value, (double)now->value);
}

static void run(uint64_t seed, dm_drag_state* out_last) {
    player p = {.random = dmi_random_make(seed, 0)};
    const dm_drag_rules rules = any_rules(&p.random);
    const dm_drag_feel feel = any_feel(&p.random, rules.snap_count > 0);
    dm_drag_state now = {0}, last = {0}, before = {0};
    float calm = 0;
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    for (int k = 0; k < UPDATES; k++) {
        play_on(&p, k);
        const bool let_go = k % 1000 == 999 || drag.release.phase != DM_DRAG_HELD;
        if (k % 1000 == 999) dmi_drag_release(&drag, (int32_t)(dmi_random_u32(&p.random) % 4), 0);
        if (let_go && k % 1000 == 600) { /* grabbed again where it is */
            const float value = drag.value;
            test_begin(&drag, &test_slide, value, &feel, &rules);
            p.x = value, p.speed = 0, p.input = (dm_drag_input){.hand.kind = DM_HAND_RAY};
            last.value = before.value = value;
            play_on(&p, k);
            continue;
        }
        before = last, last = now;
        p.input.second.grab_point = (dm_vec3){drag.value, 1, 0};
        dmi_drag_step(&drag, &p.input, DT, &now);
        calm = now.events != 0 || k % 200 == 0 ? 0 : calm + DT; /* another kind of hand may hold somewhere else */
        if (k > 1) check(&now, &last, &before, calm);
    }
    *out_last = now;
}

static void nothing_breaks_and_nothing_jumps(void** state) {
    (void)state;
    for (uint64_t seed = 1; seed <= SEQUENCES; seed++) {
        dm_drag_state now = {0}, again = {0};
        run(seed, &now);
        if (seed % 8 == 0) run(seed, &again), assert_memory_equal(&now, &again, sizeof now);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_breaks_and_nothing_jumps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
