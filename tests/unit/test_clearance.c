/* How far a part may slide along the sides of its box before the body stands in its way. */
#include "test_analysis.h"

#include <math.h>

#include "math/linear3.h"

static test_shape shape;
static test_analysis a;

#define WIDE 0.8f
#define HIGH 1.5f
#define THICK 0.04f
#define TRACK 0.002f /* between a leaf and the track beside it: far less than a cell of the distance grid */

static void begin(void) {
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){WIDE, HIGH, THICK}, 1);
}

static void add_body(float x0, float y0, float z0, float x1, float y1, float z1) {
    test_shape_box(&shape, (const float[]){x0, y0, z0}, (const float[]){x1, y1, z1}, 0);
}

static void add_frame(void) {
    add_body(-0.1f, -0.1f, -0.1f, -0.003f, HIGH + 0.1f, 0.1f);
    add_body(2 * WIDE + 0.003f, -0.1f, -0.1f, 2 * WIDE + 0.1f, HIGH + 0.1f, 0.1f);
    add_body(0, -0.1f, -0.1f, 2 * WIDE, -0.003f, 0.1f);
    add_body(0, HIGH + 0.003f, -0.1f, 2 * WIDE, HIGH + 0.1f, 0.1f);
}

/* Returns the part's clearance the way of a direction along a side of its box. */
static float clearance_towards(const float way[3]) {
    for (int k = 0; k < 3; k++) {
        const float cosine = dmi_dot3(way, a.of_part.box.axes[k]);
        if (fabsf(cosine) > 0.999f) return a.of_part.clearance[k][cosine > 0];
    }
    fail();
    return 0;
}

static const float left[3] = {-1, 0, 0}, right[3] = {1, 0, 0}, up[3] = {0, 1, 0}, out[3] = {0, 0, 1};

static void leaves_in_one_plane_are_in_each_others_way(void** state) {
    (void)state;
    begin(), add_frame();
    add_body(WIDE + 0.003f, 0, 0, 2 * WIDE, HIGH, THICK);
    test_analysis_open(&a, &shape, 3);
    assert_true(clearance_towards(left) < 0.02f && clearance_towards(right) < 0.02f && clearance_towards(up) < 0.02f);
    assert_float_equal(clearance_towards(out), DMI_MOST_CLEARANCE, 1e-6f);
    test_analysis_close(&a);
}

static void a_leaf_in_the_next_track_is_not_in_the_way(void** state) {
    (void)state;
    begin(), add_frame();
    add_body(WIDE - 0.02f, 0, THICK + TRACK, 2 * WIDE, HIGH, 2 * THICK + TRACK);
    test_analysis_open(&a, &shape, 3);
    assert_true(clearance_towards(left) < 0.02f);
    assert_float_equal(clearance_towards(right), DMI_MOST_CLEARANCE, 1e-6f);
    test_analysis_close(&a);
}

static void a_gap_counts_in_sides_of_the_part(void** state) {
    (void)state;
    begin();
    add_body(WIDE * 1.25f, 0, 0, WIDE * 1.5f, HIGH, THICK);
    test_analysis_open(&a, &shape, 3);
    assert_float_equal(clearance_towards(right), 0.25f, 1e-4f);
    assert_float_equal(clearance_towards(left), DMI_MOST_CLEARANCE, 1e-6f);
    test_analysis_close(&a);
}

/* A part without a body is free each way. */
static void nothing_is_in_the_way_of_a_part_alone(void** state) {
    (void)state;
    begin();
    test_analysis_open(&a, &shape, 3);
    for (int k = 0; k < 3; k++)
        for (int way = 0; way < 2; way++) assert_float_equal(a.of_part.clearance[k][way], DMI_MOST_CLEARANCE, 0);
    test_analysis_close(&a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(leaves_in_one_plane_are_in_each_others_way),
        cmocka_unit_test(a_leaf_in_the_next_track_is_not_in_the_way),
        cmocka_unit_test(a_gap_counts_in_sides_of_the_part),
        cmocka_unit_test(nothing_is_in_the_way_of_a_part_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
