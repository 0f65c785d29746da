/* From one joint to another: the grabbed point goes straight to where the new one has it, the part turns after it. */
#include "test_math.h"

#include "motion/pose_blend.h"

enum { CASES = 500, FRAMES = 60 };
#define FRAME (1.0f / 60)

typedef struct change {
    dm_pose before, now;
    float point[3];
} change;

static dm_pose some_pose(dmi_random* random, float turn) {
    float axis[3], place[3];
    test_direction(random, axis);
    test_point(random, 1, place);
    return dmi_pose_from_screw(axis, place, test_range(random, -turn, turn), test_range(random, -0.3f, 0.3f));
}

static change some_change(dmi_random* random) {
    change c = {.before = some_pose(random, 1.5f), .now = some_pose(random, 1.5f)};
    test_point(random, 1, c.point);
    return c;
}

/* Distance of the grabbed point, as it is shown, from where the new joint has it. */
static double lag_of(const change* c, const dm_pose* shown) {
    float here[3], there[3];
    dmi_pose_apply(shown, c->point, here);
    dmi_pose_apply(&c->now, c->point, there);
    return test_distance(here, there);
}

static void begins_where_it_was_and_ends_at_the_joint(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 1);
    for (int i = 0; i < CASES; i++) {
        const change c = some_change(&random);
        float x[3], expected[3], actual[3];
        test_point(&random, 1, x);
        dmi_pose_blend handover = dmi_pose_blend_new_joint(&c.before, &c.now, c.point, 1);
        dm_pose shown = dmi_pose_blend_apply(&handover, &c.now, c.point);
        dmi_pose_apply(&c.before, x, expected);
        dmi_pose_apply(&shown, x, actual);
        assert_near3(actual, expected, 1e-5);
        handover.age = 1;
        shown = dmi_pose_blend_apply(&handover, &c.now, c.point);
        assert_memory_equal(&shown, &c.now, sizeof shown);
    }
}

/* The same pose with the part turned about the grabbed point: that point stays under the pointer. Along the screw
 * between two poses it would not, nor go the straight way from one place to the other. */
static void the_grabbed_point_only_comes_nearer(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 1);
    for (int i = 0; i < CASES; i++) {
        const change c = some_change(&random);
        dmi_pose_blend handover = dmi_pose_blend_new_joint(&c.before, &c.now, c.point, 1);
        double last = lag_of(&c, &c.before);
        for (int k = 0; k <= FRAMES; k++) {
            handover.age = (float)k * FRAME;
            const dm_pose shown = dmi_pose_blend_apply(&handover, &c.now, c.point);
            const double lag = lag_of(&c, &shown);
            assert_is_unit(&shown, 5e-6);
            assert_true(lag <= last + 1e-5);
            last = lag;
        }
        assert_near(last, 0, 1e-5);
    }
}

/* However far it is: no frame goes farther than a tenth of the part, or a fifteenth of the way. */
static void no_frame_jumps(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 1);
    for (int i = 0; i < CASES; i++) {
        const change c = some_change(&random);
        dmi_pose_blend handover = dmi_pose_blend_new_joint(&c.before, &c.now, c.point, 1);
        const double most = fmax(0.1, lag_of(&c, &c.before) / 15);
        dm_pose last = c.before;
        for (int k = 0; k <= FRAMES; k++) {
            handover.age = (float)k * FRAME;
            const dm_pose shown = dmi_pose_blend_apply(&handover, &c.now, c.point);
            float a[3], b[3];
            dmi_pose_apply(&last, c.point, a);
            dmi_pose_apply(&shown, c.point, b);
            assert_true(test_distance(a, b) < most);
            last = shown;
        }
    }
}

static void nothing_to_come_from_is_the_joint_itself(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 1);
    const change c = some_change(&random);
    const dmi_pose_blend none = dmi_pose_blend_none();
    const dm_pose shown = dmi_pose_blend_apply(&none, &c.now, c.point);
    assert_memory_equal(&shown, &c.now, sizeof shown);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(begins_where_it_was_and_ends_at_the_joint),
        cmocka_unit_test(the_grabbed_point_only_comes_nearer),
        cmocka_unit_test(no_frame_jumps),
        cmocka_unit_test(nothing_to_come_from_is_the_joint_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
