/* Manhattan frames: exact for boxes in any pose, orthonormal for any normals. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

#include "base/random.h"
#include "kinematics/kpp/kpp_frame.h"
#include "math/linear3.h"

#define COUNT 600

/* Draws a random rotation (rows). */
static void random_axes(dmi_random* random, float out[3][3]) {
    for (int k = 0; k < 3; k++) out[0][k] = dmi_random_normal(random), out[1][k] = dmi_random_normal(random);
    dmi_normalize3(out[0]);
    dmi_reject3(out[1], out[0]);
    dmi_normalize3(out[1]);
    dmi_cross3(out[0], out[1], out[2]);
}

/* Draws normals of a flat box with the given axes, fewer along each axis than along the one before; a share `noise` of
 * them has random directions. */
static void box_normals(dmi_random* random, const float axes[3][3], float noise, float out[COUNT][3]) {
    for (int i = 0; i < COUNT; i++) {
        const int k = i % 10 < 7 ? 0 : i % 10 < 9 ? 1 : 2;
        const float sign = dmi_random_unit(random) < 0.5f ? -1.0f : 1.0f;
        const int is_noise = dmi_random_unit(random) < noise;
        for (int c = 0; c < 3; c++)
            out[i][c] = is_noise ? dmi_random_normal(random) : sign * axes[k][c] + 0.02f * dmi_random_normal(random);
        dmi_normalize3(out[i]);
    }
}

/* Returns the least cosine between a true axis and the found axis closest to it. */
static float worst_match(const float axes[3][3], const float found[3][3]) {
    float worst = 1;
    for (int k = 0; k < 3; k++) {
        float best = 0;
        for (int d = 0; d < 3; d++) best = fmaxf(best, fabsf(dmi_dot3(axes[k], found[d])));
        worst = fminf(worst, best);
    }
    return worst;
}

static void assert_perpendicular(const float axes[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) assert_float_equal(dmi_dot3(axes[i], axes[j]), (i == j ? 1.0f : 0.0f), 1e-5f);
}

static void boxes_give_their_axes(void** state) {
    (void)state;
    for (uint64_t seed = 0; seed < 200; seed++) {
        dmi_random random = dmi_random_make(seed, 1);
        float axes[3][3], found[3][3], normals[COUNT][3];
        random_axes(&random, axes);
        box_normals(&random, (const float(*)[3])axes, 0.1f, normals);
        const dmi_normals all = {(const float(*)[3])normals, COUNT / 3, (const float(*)[3])normals + COUNT / 3,
                                 COUNT - COUNT / 3};
        dmi_manhattan_frame_guess(&all, found);
        const float fit = dmi_manhattan_frame_fit(&all, found);
        assert_perpendicular((const float(*)[3])found);
        assert_true(worst_match((const float(*)[3])axes, (const float(*)[3])found) > 0.999f);
        assert_true(fit > 0.8f && fit < 0.97f);
    }
}

/* The axis of a cylinder is the direction perpendicular to all normals. */
static void the_axis_of_a_cylinder_comes_last(void** state) {
    (void)state;
    float normals[COUNT][3], found[3][3];
    for (int i = 0; i < COUNT; i++) {
        const float angle = 6.2831853f * (float)i / COUNT;
        normals[i][0] = cosf(angle), normals[i][1] = 0, normals[i][2] = sinf(angle);
    }
    const dmi_normals all = {(const float(*)[3])normals, COUNT, NULL, 0};
    dmi_manhattan_frame_guess(&all, found);
    assert_float_equal(fabsf(found[2][1]), 1, 1e-5f);
    dmi_manhattan_frame_fit(&all, found);
    assert_perpendicular((const float(*)[3])found);
    assert_float_equal(fabsf(found[2][1]), 1, 1e-5f);
}

static void no_normals_and_equal_normals_give_rotations(void** state) {
    (void)state;
    float zero[COUNT][3], found[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    memset(zero, 0, sizeof zero);
    const dmi_normals none = {(const float(*)[3])zero, 0, NULL, 0}, nothing = {(const float(*)[3])zero, COUNT, NULL, 0};
    assert_float_equal(dmi_manhattan_frame_fit(&none, found), 0, 0);
    assert_perpendicular((const float(*)[3])found);
    assert_float_equal(dmi_manhattan_frame_fit(&nothing, found), 0, 0);
    assert_perpendicular((const float(*)[3])found);
    for (int i = 0; i < COUNT; i++) zero[i][1] = 1;
    dmi_manhattan_frame_guess(&nothing, found);
    assert_float_equal(dmi_manhattan_frame_fit(&nothing, found), 1, 0);
    assert_perpendicular((const float(*)[3])found);
    assert_float_equal(fabsf(found[0][1]), 1, 1e-5f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_give_their_axes),
        cmocka_unit_test(the_axis_of_a_cylinder_comes_last),
        cmocka_unit_test(no_normals_and_equal_normals_give_rotations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
