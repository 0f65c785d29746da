/* The feel of a drag: detents, estimated limits, inertia, springing back; the result does not depend on the frame rate.
 */
#include "test_math.h"

#include "drag/drag.h"

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

/* ---- maps and motion against their formulas ---- */

static void a_soft_end_is_as_wide_as_stated(void** state) {
    (void)state;
    const dm_joint door = {.type = DM_JOINT_REVOLUTE, .lower = -1, .upper = 3}, wheel = {.type = DM_JOINT_CONTINUOUS};
    const struct { float share, width; } cases[] = {{-0.3f, 0}, {0, 0}, {0.1f, 0.4f}, {0.5f, 2}, {0.7f, 2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dm_drag_feel feel = {.soft_limit = cases[i].share};
        assert_near(dmi_feel_soft_width(&feel, &door), cases[i].width, 1e-6);
        assert_near(dmi_feel_soft_width(&feel, &wheel), 0, 0);
    }
}

/* Within a soft end of width w the slope falls from 1, w inside the limit, to 0, w beyond it, where the limit is
 * reached: its integral is a parabola. */
static void a_soft_end_is_a_parabola(void** state) {
    (void)state;
    const dm_joint door = {.type = DM_JOINT_REVOLUTE, .lower = -1, .upper = 3};
    for (int i = 1; i <= 5; i++) {
        const dm_drag_feel feel = {.soft_limit = 0.1f * (float)i};
        const double w = 0.4 * i;
        for (int k = -300; k <= 500; k++) {
            const float asked = 0.01f * (float)k;
            const double sign = asked > 1 ? 1 : -1, begin = asked > 1 ? 3 - w : -1 + w;
            const double inside = sign * ((double)asked - begin);
            if (inside > 2 * w) continue; /* where no pointer goes */
            const double wanted = begin + sign * (inside <= 0 ? inside : inside - inside * inside / (4 * w));
            const float target = dmi_feel_target(&feel, &door, asked);
            assert_near(target, wanted, 2e-6);
            if (inside < 1.9 * w)
                assert_near(dmi_feel_pointer_value(&feel, &door, target), asked, 2e-5 + 2e-5 / (2 - inside / w));
        }
    }
}

/* One period of a sine is taken off, whose strength is the pull: 1 stops the part at the detent. */
static void a_detent_pulls_by_a_sine(void** state) {
    (void)state;
    const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS};
    const struct { float given, pull; } pulls[] = {{0, 0.7f}, {-1, 0}, {0.4f, 0.4f}, {1, 1}, {3, 1}};
    for (size_t i = 0; i < sizeof pulls / sizeof *pulls; i++) {
        const dm_drag_feel feel = {.detent = 0.3f, .detent_pull = pulls[i].given};
        assert_near(dmi_feel_detent_pull(&feel), pulls[i].pull, 0);
        for (int k = -100; k <= 100; k++) {
            const double asked = 0.01 * k + 0.003, period = 0.3 / 6.283185307;
            const double wanted = asked - (double)pulls[i].pull * period * sin(asked / period);
            assert_near(dmi_feel_target(&feel, &wheel, (float)asked), wanted, 1e-6);
            assert_near(dmi_feel_soft_target(&feel, 0, -2, 2, (float)asked), wanted, 1e-6);
            const float back = dmi_feel_pointer_value(&feel, &wheel, (float)wanted);
            assert_near((double)back - (double)pulls[i].pull * period * sin((double)back / period), wanted, 1e-6);
            assert_near(dmi_feel_soft_pointer_value(&feel, 0, (float)wanted), back, 0);
            assert_near(dmi_feel_nearest_detent(&feel, &wheel, (float)asked), 0.3 * round(asked / 0.3), 1e-6);
        }
    }
    const dm_drag_feel feel = {.detent = 0.3f}, none = {0};
    assert_near(dmi_feel_nearest_detent(&feel, &slide, 1.7f), 1, 0); /* inside the limits */
    assert_near(dmi_feel_nearest_detent(&feel, &slide, -0.7f), 0, 0);
    assert_near(dmi_feel_nearest_detent(&none, &slide, 0.37f), 0.37f, 0);
}

/* An estimated end holds for 1/100 of the range, and is as if it were none beyond 3/100: straight in between. */
static void an_estimated_end_has_a_dead_zone(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    for (int k = 0; k <= 100; k++) {
        const double beyond = 0.002 * k, width = 0.04; /* of a range of 4 */
        const double wanted = beyond < width ? 0 : beyond > 3 * width ? beyond : 1.5 * (beyond - width);
        assert_near(dmi_feel_soft_target(&feel, 0, -1, 3, (float)(3 + beyond)) - 3, wanted, 1e-6);
        assert_near(-1 - dmi_feel_soft_target(&feel, 0, -1, 3, (float)(-1 - beyond)), wanted, 1e-6);
        assert_near(dmi_feel_soft_target(&feel, 0, -1, 3, (float)(3 - beyond)), 3 - beyond, 1e-6);
    }
}

/* tau x'' + x' = rate (T - x), with T going evenly, in small steps of Runge and Kutta's fourth order. tau 0: x' alone.
 */
static void integrate(double tau, double rate, double before, double target, double dt, double* x, double* v) {
    enum { STEPS = 4000 };
    const double h = dt / STEPS;
    for (int i = 0; i < STEPS; i++) {
        double dx[4], dv[4];
        for (int k = 0; k < 4; k++) {
            const double part = k == 0 ? 0 : k == 3 ? 1 : 0.5, last = k > 0 ? part * h : 0;
            const double at = *x + (k > 0 ? last * dx[k - 1] : 0), speed = *v + (k > 0 ? last * dv[k - 1] : 0);
            const double aim = before + (target - before) * ((double)i + part) / STEPS;
            dx[k] = tau > 0 ? speed : rate * (aim - at);
            dv[k] = tau > 0 ? (rate * (aim - at) - speed) / tau : 0;
        }
        *x += h * (dx[0] + 2 * dx[1] + 2 * dx[2] + dx[3]) / 6;
        *v += h * (dv[0] + 2 * dv[1] + 2 * dv[2] + dv[3]) / 6;
    }
}

static void a_step_solves_the_equation_of_motion(void** state) {
    (void)state;
    const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS};
    dmi_random random = dmi_random_make(8, 2);
    for (int i = 0; i < 120; i++) {
        const bool heavy = i % 3 != 0;
        dm_drag_feel feel = {.smoothing_time = i % 4 ? test_range(&random, 0.01f, 0.3f) : 0};
        const float half = feel.smoothing_time > 0 ? feel.smoothing_time : 0.02f;
        if (heavy) feel.coast_time = i % 6 == 1 ? half / 4 : test_range(&random, 0.01f, 0.5f); /* just does not swing */
        const float before = test_range(&random, -1, 1), target = test_range(&random, -1, 1);
        const float dt = i % 5 ? test_range(&random, 0.005f, 0.1f) : 1e-4f;
        float value = test_range(&random, -1, 1), velocity = test_range(&random, -5, 5);
        const double old = (double)value, ln2 = log(2);
        double wanted = old, speed = (double)velocity;
        integrate((double)feel.coast_time / ln2, ln2 / (double)half, (double)before, (double)target, (double)dt,
                  &wanted, &speed);
        dmi_feel_follow(&feel, &wheel, before, target, dt, &value, &velocity);
        assert_near(value, wanted, 2e-6);
        if (!heavy) speed = (wanted - old) / (double)dt;
        assert_near(velocity, speed, heavy ? 2e-5 : 2e-6 / (double)dt);
    }
}

static void a_limit_stops_and_no_smoothing_is_at_once(void** state) {
    (void)state;
    const dm_drag_feel heavy = {.smoothing_time = 0.05f, .coast_time = 0.5f},
                       rigid = {.smoothing_time = -1, .coast_time = 0.5f};
    for (int side = -1; side <= 1; side += 2) {
        const float end = side > 0 ? 1 : 0;
        float value = 0.5f, velocity = 20 * (float)side;
        dmi_feel_follow(&heavy, &slide, 0.5f, 0.5f, 0.1f, &value, &velocity);
        assert_true(value == end && velocity == 0);
        value = 0.5f, velocity = 7;
        dmi_feel_follow(&rigid, &slide, 0.5f, 0.75f, 0.1f, &value, &velocity);
        assert_true(value == 0.75f);
        assert_near(velocity, 2.5, 1e-5);
        dmi_feel_follow(&rigid, &slide, 0.75f, 0.25f, 0, &value, &velocity);
        assert_true(value == 0.25f);
        assert_near(velocity, 2.5, 1e-5); /* no time, no speed of it */
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
        cmocka_unit_test(a_soft_end_is_as_wide_as_stated),
        cmocka_unit_test(a_soft_end_is_a_parabola),
        cmocka_unit_test(a_detent_pulls_by_a_sine),
        cmocka_unit_test(an_estimated_end_has_a_dead_zone),
        cmocka_unit_test(a_step_solves_the_equation_of_motion),
        cmocka_unit_test(a_limit_stops_and_no_smoothing_is_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
