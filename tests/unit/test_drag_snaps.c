/* Snap values: they hold and let go, nothing moves at the grab, a released part goes to one in reach. */
#include "test_rules.h"

static const float places[3] = {0.2f, 0.3f, 0.8f};
static const dm_drag_rules three = {.struct_size = sizeof three, .snap_count = 3, .snaps = places};

static dmi_rules kept_rules(const dm_drag_feel* feel, float reach) {
    dm_drag_rules rules = three;
    rules.snap_reach = reach;
    return dmi_rules_from(&rules, feel, &test_slide, false, 1);
}

static void the_map_is_monotone_and_holds_at_snaps(void** state) {
    (void)state;
    for (int i = 0; i < 3; i++) {
        const float reaches[3] = {0, 0.02f, 0.5f};
        const dm_drag_feel feel = {.detent_pull = 0.9f};
        const dmi_rules rules = kept_rules(&feel, reaches[i]);
        float last = -1;
        for (int k = -100; k <= 1200; k++) {
            const float x = 0.001f * (float)k, y = dmi_snaps_pull(&rules.snaps, x);
            assert_true(y >= last);
            assert_near(dmi_snaps_pull(&rules.snaps, dmi_snaps_invert(&rules.snaps, x)), x, 1e-5);
            last = y;
        }
        for (int k = 0; k < 3; k++) {
            assert_near(dmi_snaps_pull(&rules.snaps, places[k]), places[k], 1e-6);
            assert_near(dmi_snaps_pull(&rules.snaps, places[k] + 0.001f) - places[k], 0.0001, 5e-5);
        }
        assert_near(dmi_snaps_pull(&rules.snaps, 0.25f), 0.25, 1e-6); /* half-way: the ridge */
    }
}

/* Beyond the reach that the host gives, the pointer has the part, and no snap catches it. */
static void out_of_reach_snaps_do_nothing(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const float reach = 0.03f;
    const dmi_rules rules = kept_rules(&feel, reach);
    for (int k = 0; k <= 100; k++) {
        const float value = 0.01f * (float)k + 0.001f;
        float nearest = INFINITY, snap;
        for (int i = 0; i < 3; i++) nearest = fminf(nearest, fabsf(value - places[i]));
        assert_int_equal(dmi_snaps_catch(&rules.snaps, &test_slide, value, &snap), nearest < reach);
        if (nearest >= reach)
            assert_near(dmi_snaps_pull(&rules.snaps, value), value, 0);
        else
            assert_true(dmi_snaps_pull(&rules.snaps, value) != value);
    }
}

static void a_grab_between_snaps_moves_nothing(void** state) {
    (void)state;
    const dm_drag_feel feel = {.detent_pull = 1};
    for (int k = 0; k <= 20; k++) {
        const float value = 0.05f * (float)k;
        dmi_drag drag;
        dm_drag_state now = {0};
        test_begin(&drag, &test_slide, value, &feel, &three);
        dmi_drag_get_state(&drag, &now);
        assert_near(now.value, value, 1e-6);
        assert_near(dmi_snaps_pull(&drag.rules.snaps, drag.pointer_value), value, 1e-4);
    }
}

/* Snaps are numbered from 0; half-way to the next is a half, and beyond the outermost ones come -1 and one more. */
static void places_lie_between_snaps_and_beyond_the_outermost(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dmi_rules rules = kept_rules(&feel, 0);
    const struct {
        float value, place;
    } cases[] = {{-10, -1}, {0.2f, 0}, {0.25f, 0.5f}, {0.3f, 1}, {0.55f, 1.5f}, {0.8f, 2}, {10, 3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_near(dmi_snaps_place(&rules.snaps, cases[i].value), cases[i].place, 1e-5);
}

static float sweep(float time) {
    return fminf(0.5f * time, 1);
}

static void snaps_passed_are_counted(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const dm_drag_feel feel = {0};
        dmi_drag drag;
        test_begin(&drag, &test_slide, 0, &feel, &three);
        const test_story story = test_play(&drag, sweep, NULL, 3, rate);
        assert_int_equal(story.detents, 3);
        assert_near(story.value, 1, 1e-4);
    }
}

static void a_released_part_goes_to_a_snap_in_reach(void** state) {
    (void)state;
    const struct {
        float value, end;
    } cases[] = {{0.77f, 0.8f}, {0.22f, 0.2f}, {0.29f, 0.3f}, {0.5f, 0.3f}, {0.95f, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dm_drag_feel feel = {0};
        dmi_drag drag;
        dm_drag_state now = {0};
        test_begin(&drag, &test_slide, cases[i].value, &feel, &three);
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        for (int k = 0; k < 300; k++) dmi_drag_update(&drag, NULL, 1.0f / 60, &now);
        assert_near(now.value, cases[i].end, 1e-4);
        assert_int_equal(now.phase, DM_DRAG_AT_REST);
    }
}

/* ---- against the formula ---- */

/* Half-way to the next, no farther than the host says; a side without a next one reaches that far, or 1/20 of the
 * range. */
static double reach_of(int snap, bool upwards, double stated) {
    const int next = upwards ? snap + 1 : snap - 1;
    if (next < 0 || next > 2) return stated > 0 ? stated : 0.05;
    const double half = 0.5 * fabs((double)places[next] - (double)places[snap]);
    return stated > 0 ? fmin(stated, half) : half;
}

static void a_snap_pulls_by_a_sine_on_either_side(void** state) {
    (void)state;
    const float reaches[3] = {0, 0.04f, 0.5f}, pulls[3] = {0.4f, 0, 1};
    for (int i = 0; i < 3; i++) {
        const dm_drag_feel feel = {.detent_pull = pulls[i]};
        const double pull = pulls[i] > 0 ? (double)pulls[i] : 0.7;
        const dmi_rules rules = kept_rules(&feel, reaches[i]);
        for (int k = -300; k <= 1300; k++) {
            const double value = 0.001 * k + 0.0003;
            int snap = 0;
            for (int n = 1; n < 3; n++)
                if (fabs(value - (double)places[n]) < fabs(value - (double)places[snap])) snap = n;
            const double off = value - (double)places[snap], reach = reach_of(snap, off > 0, (double)reaches[i]);
            const bool caught = fabs(off) < reach;
            const double pi = 3.14159265358979,
                         wanted = value - (caught ? pull * reach / pi * sin(pi * off / reach) : 0);
            assert_near(dmi_snaps_pull(&rules.snaps, (float)value), wanted, 1e-6);
            const double least = snap == 0 && off < 0 ? -1 : -0.5, most = snap == 2 && off > 0 ? 1 : 0.5;
            assert_near(dmi_snaps_place(&rules.snaps, (float)value), snap + fmin(fmax(0.5 * off / reach, least), most),
                        2e-4);
            float found = -7;
            assert_int_equal(dmi_snaps_catch(&rules.snaps, &test_slide, (float)value, &found), caught);
            assert_near(found, caught ? places[snap] : -7, 0);
            const dm_joint shorter = {.type = DM_JOINT_PRISMATIC, .lower = 0.25f, .upper = 0.75f};
            assert_int_equal(dmi_snaps_catch(&rules.snaps, &shorter, (float)value, &found), caught && snap == 1);
        }
    }
    const dmi_snaps none = {0};
    float found = -7;
    assert_near(dmi_snaps_pull(&none, 0.3f), 0.3f, 0);
    assert_near(dmi_snaps_invert(&none, 0.3f), 0.3f, 0);
    assert_false(dmi_snaps_catch(&none, &test_slide, 0.3f, &found));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_map_is_monotone_and_holds_at_snaps),
        cmocka_unit_test(out_of_reach_snaps_do_nothing),
        cmocka_unit_test(a_grab_between_snaps_moves_nothing),
        cmocka_unit_test(places_lie_between_snaps_and_beyond_the_outermost),
        cmocka_unit_test(snaps_passed_are_counted),
        cmocka_unit_test(a_released_part_goes_to_a_snap_in_reach),
        cmocka_unit_test(a_snap_pulls_by_a_sine_on_either_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
