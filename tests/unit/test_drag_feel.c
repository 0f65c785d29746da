/* The feel of a drag: detents, estimated limits, inertia, springing back; the result does not depend on the frame rate.
 */
#include "test_math.h"

#include "motion/drag.h"

#define FRAME (1.0f / 60)

static const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = 0, .upper = 1};
static const float origin[3] = {0, 0, 0};

/* A ray from above that asks a slide along x for `x`. */
static dm_ray ray_at(float x) {
    return (dm_ray){{x, 0, 5}, {0, 0, -1}};
}

static void catches_hold_and_let_go(void** state) {
    (void)state;
    const dm_drag_feel feel = {.smoothing_time = -1, .detent = 0.25f};
    dmi_drag drag;
    dm_drag_state now;
    dmi_drag_begin(&drag, &slide, origin, 0, &feel);
    float last = 0, steepest = 0, flattest = 1;
    for (int k = 0; k <= 1000; k++) {
        const dm_ray ray = ray_at(0.001f * (float)k);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_true(now.value >= last); /* never back */
        if (k > 0) steepest = fmaxf(steepest, now.value - last), flattest = fminf(flattest, now.value - last);
        if (k % 250 == 0) assert_near(now.value, 0.001f * (float)k, 1e-4);
        last = now.value;
    }
    assert_near(steepest, 0.0017, 1e-4); /* the default pull of 0.7 */
    assert_near(flattest, 0.0003, 1e-4);
}

/* Soft ends: the part comes to rest at either limit of any range alike, and goes with the pointer in between. */
static void both_ends_of_any_range_are_soft(void** state) {
    (void)state;
    static const float ranges[][2] = {{0, 1}, {-1, 1}, {2, 5}, {-3, -1}, {0, 0.2f}, {-0.5f, 4}};
    const dm_drag_feel feel = {.soft_limit = 0.25f};
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++) {
        const float lower = ranges[i][0], upper = ranges[i][1], range = upper - lower;
        const dm_joint joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = lower, .upper = upper};
        for (int k = -25; k <= 50; k++) { /* as far beyond as the soft end is wide, no pointer goes farther */
            const float off = 0.01f * (float)k * range; /* of the pointer, from a limit inwards */
            const float low = dmi_feel_target(&feel, &joint, lower + off) - lower;
            const float high = upper - dmi_feel_target(&feel, &joint, upper - off);
            assert_near(low / range, high / range, 1e-5);
            if (k >= 25)
                assert_near(low / range, off / range, 1e-5);
            else if (k == -25)
                assert_near(low, 0, 1e-6);
            else
                assert_true(low > 0 && low > off);
        }
    }
}

static void a_grab_between_catches_moves_nothing(void** state) {
    (void)state;
    const dm_drag_feel feel = {.detent = 0.25f, .detent_pull = 1};
    for (int k = 0; k <= 20; k++) {
        const float value = 0.05f * (float)k, grab[3] = {value, 0, 0};
        dmi_drag drag;
        dm_drag_state now;
        dmi_drag_begin(&drag, &slide, grab, value, &feel);
        dmi_drag_get_state(&drag, &now);
        assert_near(now.value, value, 1e-6);
        assert_near(dmi_feel_target(&feel, &slide, drag.pointer_value), value, 1e-4);
    }
}

/* An end that was estimated holds a little, then comes along without a jump, so far as it may; a stop at rest stays
 * one. */
static void estimated_ends_yield(void** state) {
    (void)state;
    const dm_drag_feel feel = {.smoothing_time = -1};
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &slide, origin, 0, &feel);
    dmi_drag_track_hypotheses(&drag, &slide, NULL, 0, 1, (dmi_limit_give){.length = 1});
    float last = 0;
    for (int k = 0; k <= 2500; k++) {
        const float x = 0.001f * (float)k;
        const dm_ray ray = ray_at(x);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_true(now.value >= last - 1e-6f && now.value - last < 0.0016f);
        assert_true(now.value <= drag.joint.upper);
        if (k > 1000 && k <= 1010) assert_near(now.value, 1, 1e-5);
        if (k >= 1030 && k <= 2000) assert_near(now.value, x, 1e-4);
        last = now.value;
    }
    assert_near(now.value, 2, 1e-5); /* no farther than the object is large */
    for (int k = 2500; k >= -500; k--) {
        const dm_ray ray = ray_at(0.001f * (float)k);
        dmi_drag_update(&drag, &ray, FRAME, &now);
    }
    assert_near(now.value, 0, 1e-6);
}

/* How far is the host's to say. */
static void ends_yield_as_far_as_asked(void** state) {
    (void)state;
    const dm_drag_feel feel = {.smoothing_time = -1};
    const struct { float share, end; } cases[] = {{-1, 1}, {0.25f, 1.25f}, {3, 4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        dmi_drag_begin(&drag, &slide, origin, 0, &feel);
        dmi_drag_track_hypotheses(&drag, &slide, NULL, 0, 1, (dmi_limit_give){.share = cases[i].share, .length = 1});
        for (int k = 0; k <= 600; k++) {
            const dm_ray ray = ray_at(0.01f * (float)k);
            dmi_drag_update(&drag, &ray, FRAME, &now);
        }
        assert_near(now.value, cases[i].end, 1e-5);
    }
}

static float heavy_value(float coast, int updates, float time, float* out_velocity) {
    const dm_drag_feel feel = {.smoothing_time = 0.05f, .coast_time = coast};
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &slide, origin, 0, &feel);
    for (int k = 0; k <= updates; k++) {
        const dm_ray ray = ray_at(0.8f * (float)k / (float)updates);
        dmi_drag_update(&drag, &ray, time / (float)updates, &now);
    }
    *out_velocity = now.velocity;
    return now.value;
}

/* Weight makes a part late, not different at another rate; that it swings over is what weight does. */
static void heavy_parts_do_not_depend_on_the_rate(void** state) {
    (void)state;
    const float coasts[] = {0.005f, 0.01f, 0.0125f, 0.05f, 0.3f};
    for (int i = 0; i < 5; i++) {
        float slow_velocity, fast_velocity, light_velocity;
        const float slow = heavy_value(coasts[i], 15, 0.15f, &slow_velocity);
        const float fast = heavy_value(coasts[i], 120, 0.15f, &fast_velocity);
        const float light = heavy_value(0, 120, 0.15f, &light_velocity);
        assert_near(slow, fast, 1e-4);
        assert_near(slow_velocity, fast_velocity, 2e-3);
        if (i > 2) assert_true(fabsf(fast - light) > 0.005f);
    }
}

/* A quarter of the mass at which it just does not swing over, that mass, and far beyond: all come to the pointer. */
static void heavy_parts_come_to_the_pointer(void** state) {
    (void)state;
    const float coasts[] = {1e-4f, 0.0032f, 0.0129f, 0.1f, 1};
    for (int i = 0; i < 5; i++) {
        const dm_drag_feel feel = {.smoothing_time = 0.05f, .coast_time = coasts[i]};
        dmi_drag drag;
        dm_drag_state now = {0};
        dmi_drag_begin(&drag, &slide, origin, 0, &feel);
        const dm_ray ray = ray_at(0.4f);
        for (int k = 0; k < 60 * 30; k++) dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_near(now.value, 0.4f, 1e-3);
        dmi_drag_update(&drag, &ray, 1e20f, &now);
        assert_near(now.value, 0.4f, 1e-3);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(catches_hold_and_let_go),
        cmocka_unit_test(both_ends_of_any_range_are_soft),
        cmocka_unit_test(a_grab_between_catches_moves_nothing),
        cmocka_unit_test(estimated_ends_yield),
        cmocka_unit_test(ends_yield_as_far_as_asked),
        cmocka_unit_test(heavy_parts_do_not_depend_on_the_rate),
        cmocka_unit_test(heavy_parts_come_to_the_pointer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
