/* What training sees: labels that agree with the inputs, signs that follow the drag, nothing given away by the frame.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../training/lab/dragmesh_lab.h"
#include "kinematics/kpp/kpp_input.h"
#include "motion/dq_vae.h"
#include "test_lab.h"

enum { COUNT = 48, REVOLUTE = 0, PRISMATIC = 1, SCREW = 2, CONTINUOUS = 3 };

static dm_result (*kpp_batch)(const dm_lab_options*, const dm_lab_kpp*);
static dm_result (*vae_batch)(const dm_lab_options*, const dm_lab_vae*);
static uint32_t (*category_count)(void);
static const char* (*category_name)(uint32_t);
static uint32_t (*category_id)(uint32_t);

static struct {
    float global_points[COUNT][DMI_KPP_GLOBAL_GROUPS][16][17], global_centres[COUNT][DMI_KPP_GLOBAL_GROUPS][3];
    float local_points[COUNT][DMI_KPP_LOCAL_GROUPS][16][17], local_centres[COUNT][DMI_KPP_LOCAL_GROUPS][3];
    float shape[COUNT][DMI_KPP_SHAPE];
    int32_t type[COUNT], has_drag[COUNT], category[COUNT];
    float axis[COUNT][3], origin[COUNT][3], limits[COUNT][5], size[COUNT];
} kpp, kpp_again;

static struct {
    float xyz[COUNT][64][3], mask[COUNT][64];
    int32_t type[COUNT], category[COUNT];
    float axis[COUNT][3], origin[COUNT][3], pitch[COUNT];
    dmi_vae_features features[COUNT];
    int32_t near_origin[COUNT][4], near_drag[COUNT][4];
    float drag_point[COUNT][3], drag_vector[COUNT][3], limits[COUNT][2];
    float values[COUNT][16], closed_form[COUNT][16];
} vae;

#define OUT_OF(arrays) (void*)arrays
static dm_result fill_kpp(const dm_lab_options* options, void* arrays) {
    __typeof__(kpp)* a = arrays;
    const dm_lab_kpp out = {OUT_OF(a->global_points),
                            OUT_OF(a->global_centres),
                            OUT_OF(a->local_points),
                            OUT_OF(a->local_centres),
                            OUT_OF(a->shape),
                            a->type,
                            a->has_drag,
                            a->category,
                            OUT_OF(a->axis),
                            OUT_OF(a->origin),
                            OUT_OF(a->limits),
                            a->size};
    return kpp_batch(options, &out);
}

static dm_result fill_vae(const dm_lab_options* options) {
    const dm_lab_vae out = {OUT_OF(vae.xyz),
                            OUT_OF(vae.mask),
                            vae.type,
                            vae.category,
                            OUT_OF(vae.axis),
                            OUT_OF(vae.origin),
                            vae.pitch,
                            OUT_OF(vae.features),
                            OUT_OF(vae.near_origin),
                            OUT_OF(vae.near_drag),
                            OUT_OF(vae.drag_point),
                            OUT_OF(vae.drag_vector),
                            OUT_OF(vae.limits),
                            OUT_OF(vae.values),
                            OUT_OF(vae.closed_form)};
    return vae_batch(options, &out);
}

static uint8_t everything[512];

static dm_lab_options exact(uint64_t seed) {
    return (dm_lab_options){
        .seed = seed, .count = COUNT, .categories = everything, .messy = 0.5f, .rotated = 0.5f, .with_drag = 1.0f};
}

static int load_lab(void** state) {
    (void)state;
    void* lab = test_open_lab();
    if (lab == NULL) return -1;
    *(void**)&kpp_batch = dlsym(lab, "dm_lab_kpp_batch");
    *(void**)&vae_batch = dlsym(lab, "dm_lab_vae_batch");
    *(void**)&category_count = dlsym(lab, "dm_lab_category_count");
    *(void**)&category_name = dlsym(lab, "dm_lab_category_name");
    *(void**)&category_id = dlsym(lab, "dm_lab_category_id");
    return test_every_category(lab, everything, sizeof everything) ? 0 : -1;
}

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Velocity of `point` when the joint's value grows. */
static void velocity(int32_t type, const float axis[3], const float origin[3], float pitch, const float point[3],
                     float out[3]) {
    const float r[3] = {point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]};
    const float advance = type == PRISMATIC ? 1.0f : type == SCREW ? pitch : 0.0f;
    for (int i = 0; i < 3; i++) {
        const float turn = axis[(i + 1) % 3] * r[(i + 2) % 3] - axis[(i + 2) % 3] * r[(i + 1) % 3];
        out[i] = (type == PRISMATIC ? 0.0f : turn) + advance * axis[i];
    }
}

/* Trap 2 of the method: the sign of the axis. With an exact drag, the drag point starts along it. */
static void kpp_axis_is_signed_by_the_drag(void** state) {
    (void)state;
    const dm_lab_options options = exact(3);
    assert_int_equal(fill_kpp(&options, &kpp), DM_OK);
    for (int i = 0; i < COUNT; i++) {
        const float* channels = kpp.global_points[i][0][0];
        assert_int_equal(kpp.has_drag[i], 1);
        assert_float_equal(dot(channels + 7, channels + 7), 1.0f, 1e-4f);
        if (sqrtf(dot(channels + 4, channels + 4)) > 1.9f) continue; /* the input shortens far points */
        float v[3];
        velocity(kpp.type[i], kpp.axis[i], kpp.origin[i], kpp.limits[i][4], channels + 4, v);
        assert_true(dot(v, channels + 7) > 0.95f * sqrtf(dot(v, v)));
    }
}

static void kpp_labels_are_sound(void** state) {
    (void)state;
    dm_lab_options options = exact(4);
    options.with_drag = 0.5f;
    options.mask_noise = 0.5f;
    options.drag_noise_degrees = 7.5f;
    assert_int_equal(fill_kpp(&options, &kpp), DM_OK);
    int drags = 0;
    for (int i = 0; i < COUNT; i++) {
        assert_float_equal(dot(kpp.axis[i], kpp.axis[i]), 1.0f, 1e-4f);
        assert_in_range(kpp.type[i], 0, 3);
        assert_true(kpp.limits[i][0] <= kpp.limits[i][1] && kpp.limits[i][2] <= kpp.limits[i][3]);
        assert_true(kpp.size[i] > 0.0f && kpp.size[i] <= 1.8f);
        for (const float* p = kpp.global_points[i][0][0];
             p < kpp.global_points[i][0][0] + DMI_KPP_GLOBAL_GROUPS * 16 * 17; p++)
            assert_true(isfinite(*p));
        for (int g = 0; g < DMI_KPP_LOCAL_GROUPS; g++) assert_float_equal(kpp.local_points[i][g][0][3], 1.0f, 0.0f);
        drags += kpp.has_drag[i];
    }
    assert_in_range(drags, COUNT / 4, 3 * COUNT / 4);
}

/* Trap 1: a frame centred on the joint would make its origin a constant. Over all kinds of objects, the axis of few
 * turning parts passes through the input's zero, and it does so at many distances. */
static void origin_is_not_in_the_frame(void** state) {
    (void)state;
    const dm_lab_options options = exact(5);
    assert_int_equal(fill_kpp(&options, &kpp), DM_OK);
    int turning = 0, near_zero = 0;
    float least = 1e9f, most = 0.0f;
    for (int i = 0; i < COUNT; i++) {
        if (kpp.type[i] != REVOLUTE) continue;
        const float along = dot(kpp.origin[i], kpp.axis[i]);
        const float distance = sqrtf(fmaxf(0.0f, dot(kpp.origin[i], kpp.origin[i]) - along * along));
        turning++;
        near_zero += distance < 0.02f;
        least = fminf(least, distance);
        most = fmaxf(most, distance);
    }
    assert_true(turning > 5);
    assert_true(2 * near_zero < turning);
    assert_true(most > least + 0.3f);
}

static void batches_repeat(void** state) {
    (void)state;
    dm_lab_options options = exact(6);
    options.mask_noise = 0.5f;
    assert_int_equal(fill_kpp(&options, &kpp), DM_OK);
    assert_int_equal(fill_kpp(&options, &kpp_again), DM_OK);
    assert_memory_equal(&kpp, &kpp_again, sizeof kpp);
    options.split = DM_LAB_TEST;
    assert_int_equal(fill_kpp(&options, &kpp_again), DM_OK);
    assert_memory_not_equal(kpp.global_points, kpp_again.global_points, sizeof kpp.global_points);
}

/* Steady hand, exact joint: the nearest joint values along the path are the values meant. */
static void vae_targets_agree_with_the_path(void** state) {
    (void)state;
    const dm_lab_options options = exact(7);
    assert_int_equal(fill_vae(&options), DM_OK);
    for (int i = 0; i < COUNT; i++) {
        assert_float_equal(vae.values[i][0], 0.0f, 0.0f);
        float most = 0.0f;
        int clear = 1; /* half a turn between two places and nobody can tell which way round it went */
        for (int f = 0; f < 16; f++) {
            assert_true(vae.values[i][f] >= 0.0f && vae.values[i][f] <= vae.limits[i][1]);
            clear = clear && (vae.type[i] == PRISMATIC || f == 0 || vae.values[i][f] - vae.values[i][f - 1] < 3.0f);
            if (clear) assert_float_equal(vae.values[i][f], vae.closed_form[i][f], 2e-3f * (1.0f + vae.values[i][f]));
            most = fmaxf(most, vae.values[i][f]);
        }
        assert_true(most > 0.0f);
        if (vae.pitch[i] != 0.0f) continue; /* of a steep screw the way soon leaves its tangent */
        float v[3];
        velocity(vae.type[i], vae.axis[i], vae.origin[i], vae.pitch[i], vae.drag_point[i], v);
        assert_true(dot(v, vae.drag_vector[i]) >
                    0.95f * sqrtf(dot(v, v) * dot(vae.drag_vector[i], vae.drag_vector[i])));
    }
}

/* An unsteady hand moves the inputs and leaves the targets inside the limits. */
static void vae_noise_is_in_the_input_alone(void** state) {
    (void)state;
    dm_lab_options options = exact(8);
    options.hand_noise = options.joint_noise = 1.0f;
    assert_int_equal(fill_vae(&options), DM_OK);
    int unsteady = 0;
    for (int i = 0; i < COUNT; i++) {
        float apart = 0.0f, cloud = 0.0f;
        for (int f = 0; f < 16; f++) {
            assert_true(vae.values[i][f] >= 0.0f && vae.values[i][f] <= vae.limits[i][1] + 1e-6f);
            apart = fmaxf(apart, fabsf(vae.values[i][f] - vae.closed_form[i][f]));
        }
        for (int p = 0; p < 64; p++)
            for (int k = 0; k < 3; k++) cloud = fmaxf(cloud, fabsf(vae.xyz[i][p][k]));
        assert_true(cloud <= 0.5001f); /* the object's box, not the joint, is the centre */
        unsteady += apart > 1e-3f;
    }
    assert_true(unsteady > COUNT / 3);
}

static void no_category_is_an_error(void** state) {
    (void)state;
    const uint8_t nothing[512] = {0};
    dm_lab_options options = exact(1);
    options.categories = nothing;
    assert_int_equal(fill_kpp(&options, &kpp), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(fill_vae(&options), DM_ERROR_INVALID_ARGUMENT);
}

/* One category alone, by its id: all cases are of it. */
static void cases_are_of_the_ids_chosen(void** state) {
    (void)state;
    uint8_t one[sizeof everything] = {0};
    dm_lab_options options = exact(4);
    const uint32_t id = category_id(category_count() / 2);
    one[id] = 3;
    options.categories = one;
    assert_int_equal(fill_kpp(&options, &kpp), DM_OK);
    for (int i = 0; i < COUNT; i++) assert_int_equal(kpp.category[i], id);
}

static void categories_have_names(void** state) {
    (void)state;
    assert_true(category_count() > 0 && category_count() <= sizeof everything);
    for (uint32_t c = 0; c < category_count(); c++) assert_true(strlen(category_name(c)) > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kpp_axis_is_signed_by_the_drag),  cmocka_unit_test(kpp_labels_are_sound),
        cmocka_unit_test(origin_is_not_in_the_frame),      cmocka_unit_test(batches_repeat),
        cmocka_unit_test(vae_targets_agree_with_the_path), cmocka_unit_test(vae_noise_is_in_the_input_alone),
        cmocka_unit_test(no_category_is_an_error),         cmocka_unit_test(cases_are_of_the_ids_chosen),
        cmocka_unit_test(categories_have_names),
    };
    return cmocka_run_group_tests(tests, load_lab, NULL);
}
