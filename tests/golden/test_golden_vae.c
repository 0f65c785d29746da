/* DQ-VAE in C against PyTorch: the features of a drag, the neighbours, and the network with the shipped weights, on
 * every kernel path of this machine. */
#include "golden.h"

#include "motion/dq_vae.h"
#include "platform.h"

#define FEATURE_TOLERANCE 2e-5f

static void copy_query(const dmi_weights* golden, dmi_vae_query* out) {
    float type, scalars[3];
    *out = (dmi_vae_query){0};
    golden_copy(golden, "type", 1, 0, &type);
    golden_copy(golden, "scalars", 3, 0, scalars);
    golden_copy(golden, "axis", 3, 0, &out->joint.axis);
    golden_copy(golden, "origin", 3, 0, &out->joint.origin);
    golden_copy(golden, "drawn", DMI_VAE_PATH, 3, out->path);
    golden_copy(golden, "drag_vector", 3, 0, out->drag_vector);
    memcpy(out->drag_point, out->path[0], sizeof out->drag_point);
    out->joint.type = (int32_t)type;
    out->joint.pitch = scalars[0];
    out->joint.lower = scalars[1];
    out->joint.upper = scalars[2];
}

static void compare_features(const dmi_weights* golden, const char* name) {
    dmi_vae_query query;
    dmi_vae_features made;
    copy_query(golden, &query);
    dmi_vae_features_make(&query, &made);
    golden_compare(golden, "joint_scalars", 3, 0, made.joint_scalars, FEATURE_TOLERANCE, name);
    golden_compare(golden, "rotation_direction", 3, 0, made.rotation_direction, FEATURE_TOLERANCE, name);
    golden_compare(golden, "mean_velocity", 3, 0, made.mean_velocity, FEATURE_TOLERANCE, name);
    golden_compare(golden, "chords", 9, 0, made.chords, FEATURE_TOLERANCE, name);
    golden_compare(golden, "amplitude", 2, 0, made.amplitude, FEATURE_TOLERANCE, name);
    golden_compare(golden, "path", DMI_VAE_PATH, 5, made.path[0], FEATURE_TOLERANCE, name);
}

static void compare_neighbours(const dmi_weights* golden, const char* name, const char* centre_name,
                               const dmi_vae_object* object) {
    float expected[DMI_VAE_NEIGHBOURS], centre[3];
    uint32_t found[DMI_VAE_NEIGHBOURS];
    golden_copy(golden, name, DMI_VAE_NEIGHBOURS, 0, expected);
    golden_copy(golden, centre_name, 3, 0, centre);
    dmi_vae_neighbours(object, centre, found);
    for (int i = 0; i < DMI_VAE_NEIGHBOURS; ++i) assert_int_equal(found[i], (int)expected[i]);
}

static void fill_points(const dmi_weights* golden, dmi_part_points* points) {
    float xyz[DMI_VAE_POINTS][3];
    golden_copy(golden, "xyz", DMI_VAE_POINTS, 3, xyz);
    dmi_part_points_take((const float(*)[3])xyz, 1, points);
}

static void compare(const dmi_dq_vae* vae, dmi_isa isa, const char* name, const dmi_weights* golden) {
    static dmi_vae_object object;
    dmi_part_points points;
    dmi_vae_query query;
    dmi_vae_output output;
    char where[64];
    snprintf(where, sizeof where, "%s %s", name, dmi_isa_name(isa));
    void* scratch = platform_allocate(dmi_dq_vae_scratch_size(vae), 64);
    fill_points(golden, &points);
    copy_query(golden, &query);
    dmi_dq_vae_prepare(vae, isa, &points, &object);
    dmi_dq_vae_forward(vae, isa, &object, &query, scratch, &output);
    compare_neighbours(golden, "near_origin", "origin", &object);
    compare_neighbours(golden, "near_drag", "drag_point", &object);
    golden_compare(golden, "mean", DMI_VAE_LATENT, 0, output.mean, GOLDEN_TOLERANCE, where);
    golden_compare(golden, "log_variance", DMI_VAE_LATENT, 0, output.log_variance, GOLDEN_TOLERANCE, where);
    golden_compare(golden, "raw", DM_MOTION_FRAMES, 8, output.raw[0], GOLDEN_TOLERANCE, where);
    platform_release(scratch);
}

static void answers_as_pytorch(void** state) {
    const char* name = *state;
    char path[128];
    test_env t;
    dmi_dq_vae* vae = NULL;
    snprintf(path, sizeof path, "tests/golden/data/%s.safetensors", name);
    golden_file answers = golden_read(path), weights = golden_read("sdk/models/dq_vae.safetensors");
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(dmi_dq_vae_load(&t.env, weights.data, weights.size, &vae), DM_OK);
    dmi_weights* golden = golden_open(&t.env, answers, "dragmesh-golden-vae", weights);
    compare_features(golden, name);
    for (dmi_isa isa = DMI_ISA_SCALAR; isa <= DMI_ISA_NEON; ++isa)
        if (dmi_kernels_usable(isa)) compare(vae, isa, name, golden);
    dmi_weights_close(golden);
    dmi_dq_vae_destroy(vae);
    test_env_close(&t);
    free(answers.data);
    free(weights.data);
}

static dm_result load_and_destroy(dmi_env* env, const void* data, size_t size) {
    dmi_dq_vae* net = NULL;
    const dm_result result = dmi_dq_vae_load(env, data, size, &net);
    dmi_dq_vae_destroy(net);
    return result;
}

static void loading_fails_by_name(void** state) {
    (void)state;
    golden_check_loading(load_and_destroy, "sdk/models/dq_vae.safetensors", "sdk/models/kpp_net.safetensors",
                         "correction.2.bias");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        {"revolute", answers_as_pytorch, NULL, NULL, "vae_revolute"},
        {"prismatic", answers_as_pytorch, NULL, NULL, "vae_prismatic"},
        {"screw", answers_as_pytorch, NULL, NULL, "vae_screw"},
        {"continuous", answers_as_pytorch, NULL, NULL, "vae_continuous"},
        cmocka_unit_test(loading_fails_by_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
