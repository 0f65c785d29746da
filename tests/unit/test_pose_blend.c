/* From one joint to another: the grabbed point goes straight to where the new one has it, the part turns after it. */
#include "test_math.h"

#include "drag/pose_blend.h"

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

/* ---- against the formulas ---- */

static double left_of(double age, double time) {
    const double s = fmin(age / time, 1);
    return 1 - s * s * (3 - 2 * s);
}

/* A tenth of a second and 0.3 a radian, 0.6 at most; the grabbed point 0.05 and 0.3 a length of the part, 0.5 at most.
 */
static void a_blend_takes_the_time_of_its_way(void** state) {
    (void)state;
    const float axis[3] = {0, 0, 1}, place[3] = {0, 0, 0}, point[3] = {2, 0, 0};
    const dm_pose none = dmi_pose_identity();
    for (int k = 0; k <= 30; k++) {
        const float turn = 0.1f * (float)(k - 15), slide = 0.05f * (float)k;
        for (int sizes = 0; sizes < 3; sizes++) {
            const float size = (float)sizes;
            const dm_pose before = dmi_pose_from_screw(axis, place, turn, slide);
            const dmi_pose_blend blend = dmi_pose_blend_new_joint(&before, &none, point, size),
                                 same = dmi_pose_blend_same_joint(&before, &none);
            const double way = hypot(2 * 2 * sin(fabs(0.5 * (double)turn)), (double)slide);
            assert_near(blend.turn_time, fmin(0.1 + 0.3 * fabs((double)turn), 0.6), 5e-4);
            assert_near(same.turn_time, blend.turn_time, 0);
            assert_near(blend.lag_time, fmin(0.05 + (size > 0 ? 0.3 * way / (double)size : 0), 0.5), 1e-5);
            assert_near(same.lag_time, 0, 0);
            for (int n = 0; n <= 20; n++) {
                dmi_pose_blend aged = blend, alone = same;
                aged.age = alone.age = 0.04f * (float)n;
                const dm_pose shown = dmi_pose_blend_apply(&aged, &none, point),
                              screw = dmi_pose_blend_apply(&alone, &none, point);
                const double age = (double)aged.age, turned = left_of(age, (double)blend.turn_time) * (double)turn;
                const double lag = left_of(age, (double)blend.lag_time);
                float at[3], other[3], far[3] = {3, 0, 0}, there[3];
                dmi_pose_apply(&before, point, there);
                dmi_pose_apply(&shown, point, at);
                for (int i = 0; i < 3; i++) assert_near(at[i], point[i] + lag * (double)(there[i] - point[i]), 2e-5);
                dmi_pose_apply(&shown, far, other);
                assert_near(other[0] - at[0], cos(turned), 1e-3);
                assert_near(other[1] - at[1], sin(turned), 1e-3);
                dmi_pose_apply(&screw, point, at);
                assert_near(at[0], 2 * cos(turned), 2e-3);
                assert_near(at[1], 2 * sin(turned), 2e-3);
                assert_near(at[2], left_of(age, (double)blend.turn_time) * (double)slide, 2e-3);
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(begins_where_it_was_and_ends_at_the_joint),
        cmocka_unit_test(the_grabbed_point_only_comes_nearer),
        cmocka_unit_test(no_frame_jumps),
        cmocka_unit_test(nothing_to_come_from_is_the_joint_itself),
        cmocka_unit_test(a_blend_takes_the_time_of_its_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
