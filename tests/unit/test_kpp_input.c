/* KPP-Net's input: frame and groups of the specification, invariance to pose and scale. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "kinematics/kpp/kpp_input.h"
#include "math/linear3.h"

/* Draws a noisy normal of a box; the body's box is rotated by 45 degrees against the part's. */
static void make_normal(dmi_random* random, int is_part, float out[3]) {
    const uint32_t face = dmi_random_u32(random) % 8; /* the first direction has more faces than the others */
    for (int k = 0; k < 3; k++) out[k] = 0.04f * dmi_random_normal(random);
    out[face < 4 ? 2 : face < 6 ? 0 : 1] += face % 2 ? 1.0f : -1.0f;
    const float axis[3] = {0, 1, 0}, zero[3] = {0, 0, 0};
    if (!is_part) dmi_turn3(axis, zero, 0.70710678f, 0.70710678f, out, out);
    dmi_normalize3(out);
}

/* Makes a slab (the part) in front of an asymmetric cloud (the body). */
static void make_cloud(uint64_t seed, dmi_cloud* out) {
    dmi_random random = dmi_random_make(seed, 7);
    for (uint32_t i = 0; i < DMI_CLOUD_POINTS; i++) {
        float u = dmi_random_unit(&random), v = dmi_random_unit(&random), w = dmi_random_unit(&random);
        float part[3] = {0.4f * u - 0.2f, 0.7f * v * v - 0.3f, 0.05f * w + 0.3f};
        float body[3] = {u - 0.5f, 0.8f * v - 0.4f, 0.6f * w * w - 0.45f};
        memcpy(out->xyz[i], i < DMI_CLOUD_PART ? part : body, sizeof part);
        make_normal(&random, i < DMI_CLOUD_PART, out->normal[i]);
    }
}

static dmi_drag_hint make_hint(void) {
    return (dmi_drag_hint){{0.15f, 0.2f, 0.35f}, {0.02f, -0.01f, 0.1f}};
}

static void turn(const float axis[3], float angle, const float in[3], float out[3]) {
    const float zero[3] = {0, 0, 0};
    dmi_turn3(axis, zero, cosf(angle), sinf(angle), in, out);
}

static void move_cloud(const float axis[3], float angle, float scale, const float shift[3], dmi_cloud* cloud) {
    for (uint32_t i = 0; i < DMI_CLOUD_POINTS; i++) {
        turn(axis, angle, cloud->xyz[i], cloud->xyz[i]);
        for (int k = 0; k < 3; k++) cloud->xyz[i][k] = scale * cloud->xyz[i][k] + shift[k];
        turn(axis, angle, cloud->normal[i], cloud->normal[i]);
    }
}

static void assert_same(const float* a, const float* b, size_t count, float tolerance) {
    for (size_t i = 0; i < count; i++) assert_float_equal(a[i], b[i], tolerance);
}

/* Every subset gives nearly the same frame from other points. */
static void subsets_differ(void** state) {
    (void)state;
    dmi_cloud* cloud = malloc(sizeof *cloud);
    dmi_kpp_input* inputs = malloc(DMI_KPP_SUBSETS * sizeof *inputs);
    const dmi_drag_hint hint = make_hint();
    make_cloud(3, cloud);
    for (uint32_t q = 0; q < DMI_KPP_SUBSETS; q++) dmi_kpp_input_make(cloud, q, &hint, &inputs[q]);
    for (uint32_t q = 1; q < DMI_KPP_SUBSETS; q++) {
        assert_float_equal(inputs[q].frame.scale / inputs[0].frame.scale, 1, 0.1);
        for (int r = 0; r < 3; r++)
            assert_true(dmi_dot3(inputs[q].frame.rotation + 3 * r, inputs[0].frame.rotation + 3 * r) > 0.98f);
        for (int g = 0; g < DMI_KPP_LOCAL_GROUPS; g++)
            for (int h = 0; h < DMI_KPP_LOCAL_GROUPS; h++)
                assert_memory_not_equal(inputs[q].local_centres[g], inputs[0].local_centres[h], 3 * sizeof(float));
    }
    free(inputs);
    free(cloud);
}

/* Checks that a rigid motion and a scale do not change any channel. */
static void check_invariance(const dmi_drag_hint* hint) {
    const float axis[3] = {0.6f, 0.0f, 0.8f}, shift[3] = {0.4f, -1.3f, 0.2f};
    const float angle = 2.1f, scale = 1.7f;
    dmi_cloud* cloud = malloc(sizeof *cloud);
    dmi_kpp_input* before = malloc(sizeof *before);
    dmi_kpp_input* after = malloc(sizeof *after);
    make_cloud(3, cloud);
    dmi_kpp_input_make(cloud, 0, hint, before);

    dmi_drag_hint moved;
    if (hint != NULL) {
        turn(axis, angle, hint->point, moved.point);
        for (int k = 0; k < 3; k++) moved.point[k] = scale * moved.point[k] + shift[k];
        turn(axis, angle, hint->vector, moved.vector);
    }
    move_cloud(axis, angle, scale, shift, cloud);
    dmi_kpp_input_make(cloud, 0, hint != NULL ? &moved : NULL, after);

    assert_same(&before->global_points[0][0][0], &after->global_points[0][0][0],
                sizeof before->global_points / sizeof(float), 1e-4f);
    assert_same(&before->local_points[0][0][0], &after->local_points[0][0][0],
                sizeof before->local_points / sizeof(float), 1e-4f);
    assert_same(&before->global_centres[0][0], &after->global_centres[0][0], DMI_KPP_GLOBAL_GROUPS * 3, 1e-4f);
    assert_same(&before->local_centres[0][0], &after->local_centres[0][0], DMI_KPP_LOCAL_GROUPS * 3, 1e-4f);
    assert_float_equal(after->frame.scale * scale, before->frame.scale, 1e-4f);
    const int size = DMI_KPP_SHAPE_RADIUS; /* varies with the scale */
    for (int i = 0; i < DMI_KPP_SHAPE; i++)
        if (i != size) assert_float_equal(before->shape[i], after->shape[i], 1e-4f);
    free(cloud), free(before), free(after);
}

static void invariant_with_drag(void** state) {
    (void)state;
    dmi_drag_hint hint = make_hint();
    check_invariance(&hint);
}

static void invariant_without_drag(void** state) {
    (void)state;
    check_invariance(NULL);
}

static void frame_is_a_rotation(void** state) {
    (void)state;
    dmi_cloud* cloud = malloc(sizeof *cloud);
    dmi_kpp_input* input = malloc(sizeof *input);
    make_cloud(5, cloud);
    dmi_drag_hint hint = make_hint();
    for (int with = 0; with < 2; with++) {
        dmi_kpp_input_make(cloud, 0, with ? &hint : NULL, input);
        const float* r = input->frame.rotation;
        float third[3];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                float wanted = i == j ? 1.0f : 0.0f;
                assert_float_equal(dmi_dot3(r + 3 * i, r + 3 * j), wanted, 1e-5f);
            }
        dmi_cross3(r, r + 3, third);
        assert_same(third, r + 6, 3, 1e-5f);
        for (int i = 0; with && i < 3; i++) /* the axis closest to the drag comes first */
            assert_true(dmi_dot3(r, hint.vector) >= fabsf(dmi_dot3(r + 3 * i, hint.vector)));
    }
    free(cloud), free(input);
}

/* Groups start with their centre and are sorted by distance; channels are those of the specification. */
static void groups_follow_the_specification(void** state) {
    (void)state;
    dmi_cloud* cloud = malloc(sizeof *cloud);
    dmi_kpp_input* input = malloc(sizeof *input);
    make_cloud(9, cloud);
    dmi_drag_hint hint = make_hint();
    dmi_kpp_input_make(cloud, 0, &hint, input);
    int masked = 0;
    for (uint32_t g = 0; g < DMI_KPP_GLOBAL_GROUPS; g++) {
        float last = 0;
        for (uint32_t m = 0; m < DMI_KPP_GROUP; m++) {
            const float* c = input->global_points[g][m];
            float d = dmi_distance3(c, input->global_centres[g]);
            assert_true(d >= last - 1e-6f);
            last = d;
            for (int k = 0; k < 3; k++)
                assert_float_equal(c[DMI_KPP_OFFSET + k], 2 * (c[k] - input->global_centres[g][k]), 1e-6f);
            assert_float_equal(dmi_length3(c + DMI_KPP_DRAG_VECTOR), 1, 1e-5f);
            assert_true(dmi_length3(c) < 2 + logf(8));
            masked += c[DMI_KPP_MASK] == 1;
        }
        assert_same(input->global_points[g][0], input->global_centres[g], 3, 0);
        for (uint32_t h = 0; h < g; h++)
            assert_true(dmi_distance3(input->global_centres[g], input->global_centres[h]) > 1e-3f);
    }
    assert_in_range(masked, 1, DMI_KPP_GLOBAL_GROUPS * DMI_KPP_GROUP - 1);
    for (uint32_t g = 0; g < DMI_KPP_LOCAL_GROUPS; g++)
        for (uint32_t m = 0; m < DMI_KPP_GROUP; m++) assert_true(input->local_points[g][m][DMI_KPP_MASK] == 1);
    free(cloud), free(input);
}

/* The frame follows the part's faces, not the drag; the body's axes are among the shape features. */
static void frame_follows_the_faces(void** state) {
    (void)state;
    dmi_cloud* cloud = malloc(sizeof *cloud);
    dmi_kpp_input* input = malloc(sizeof *input);
    make_cloud(11, cloud);
    dmi_drag_hint hint = make_hint();
    dmi_kpp_input_make(cloud, 0, &hint, input);
    const float face[3] = {0, 0, 1};
    assert_true(dmi_dot3(input->frame.rotation, face) > 0.999f);
    const float* r = input->frame.rotation;
    const float turned[3] = {0.70710678f, 0, 0.70710678f}; /* of the body's faces */
    const float inner[3] = {dmi_dot3(r, turned), dmi_dot3(r + 3, turned), dmi_dot3(r + 6, turned)};
    float best = 0;
    for (int d = 3; d < 6; d++) best = fmaxf(best, fabsf(dmi_dot3(input->shape + 3 * d, inner)));
    assert_true(best > 0.999f);
    const float* half = input->shape + DMI_KPP_SHAPE_PART_BOX + 3;
    assert_float_equal(half[0] / input->frame.scale, 0.025f, 2e-3f); /* the slab's half thickness */
    free(cloud), free(input);
}

/* Rotates a vector out of the frame. */
static void outer(const dmi_kpp_frame* frame, const float y[3], float out[3]) {
    for (int k = 0; k < 3; k++)
        out[k] = frame->rotation[k] * y[0] + frame->rotation[3 + k] * y[1] + frame->rotation[6 + k] * y[2];
}

/* The flipped frame has the same vectors outside of it; flipping twice restores the input. */
static void flipping_twice_restores_the_input(void** state) {
    (void)state;
    dmi_cloud* cloud = malloc(sizeof *cloud);
    dmi_kpp_input* inputs = malloc(3 * sizeof *inputs);
    make_cloud(11, cloud);
    dmi_drag_hint hint = make_hint();
    dmi_kpp_input_make(cloud, 0, &hint, &inputs[0]);
    dmi_kpp_input_flip(&inputs[0], &inputs[1]);
    dmi_kpp_input_flip(&inputs[1], &inputs[2]);
    assert_memory_equal(&inputs[0].frame, &inputs[2].frame, sizeof inputs[0].frame);
    assert_memory_equal(inputs[0].global_points, inputs[2].global_points, sizeof inputs[0].global_points);
    assert_memory_equal(inputs[0].shape, inputs[2].shape, sizeof inputs[0].shape);
    static const int vectors[] = {DMI_KPP_POINT, DMI_KPP_DRAG_POINT, DMI_KPP_DRAG_VECTOR, DMI_KPP_OFFSET,
                                  DMI_KPP_NORMAL};
    for (int v = 0; v < 5; v++) {
        float a[3], b[3];
        outer(&inputs[0].frame, inputs[0].global_points[5][3] + vectors[v], a);
        outer(&inputs[1].frame, inputs[1].global_points[5][3] + vectors[v], b);
        assert_true(dmi_distance3(a, b) < 1e-6f);
    }
    /* Directions (as lines), centres of the boxes, drag point and vector, mean of the contact. */
    for (int first = 0; first < DMI_KPP_SHAPE - 4; first += first < 42 ? 3 : 7) {
        if (first == 30 || first == 36) continue; /* half sides */
        float a[3], b[3];
        outer(&inputs[0].frame, inputs[0].shape + first, a);
        outer(&inputs[1].frame, inputs[1].shape + first, b);
        if (first < 27 && dmi_dot3(a, b) < 0)
            for (int k = 0; k < 3; k++) b[k] = -b[k];
        assert_true(dmi_distance3(a, b) < 1e-6f);
    }
    free(cloud), free(inputs);
}

/* Coincident points, a drag through the centre, a drag along the principal direction give finite numbers. */
static void degenerate_clouds_stay_finite(void** state) {
    (void)state;
    dmi_cloud* cloud = calloc(1, sizeof *cloud);
    dmi_kpp_input* input = malloc(sizeof *input);
    dmi_drag_hint hint = {{0, 0, 0}, {0, 1, 0}};
    for (int shape = 0; shape < 2; shape++) {
        for (uint32_t i = 0; i < DMI_CLOUD_POINTS; i++) cloud->xyz[i][1] = shape == 0 ? 0 : (float)(i % 512) - 255.5f;
        for (int with = 0; with < 2; with++) {
            dmi_kpp_input_make(cloud, 0, with ? &hint : NULL, input);
            const float* all = (const float*)(const void*)input;
            for (size_t i = 0; i < sizeof *input / sizeof(float); i++) assert_true(isfinite(all[i]));
            for (int r = 0; r < 3; r++) assert_float_equal(dmi_length3(input->frame.rotation + 3 * r), 1, 1e-5f);
        }
    }
    free(cloud), free(input);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(subsets_differ),
        cmocka_unit_test(invariant_with_drag),
        cmocka_unit_test(invariant_without_drag),
        cmocka_unit_test(frame_is_a_rotation),
        cmocka_unit_test(groups_follow_the_specification),
        cmocka_unit_test(frame_follows_the_faces),
        cmocka_unit_test(degenerate_clouds_stay_finite),
        cmocka_unit_test(flipping_twice_restores_the_input),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
