/* KPP-Net in C against PyTorch: the shipped weights, the same inputs, every kernel path of this machine. */
#include "golden.h"

#include "kinematics/features/kpp_ensemble.h"
#include "platform.h"

#define CANDIDATES 40

static void compare_choice(const dmi_kpp_net* net, dmi_isa isa, const dmi_weights* golden, dmi_kpp_input* input,
                           const dmi_kpp_output* output, const char* where) {
    float frame[13], slides[CANDIDATES], axis[CANDIDATES][3], origin[CANDIDATES][3], scores[CANDIDATES];
    dmi_candidate candidates[CANDIDATES] = {0};
    golden_copy(golden, "frame", 13, 0, frame);
    golden_copy(golden, "candidate_slides", CANDIDATES, 0, slides);
    golden_copy(golden, "candidate_axis", CANDIDATES, 3, axis);
    golden_copy(golden, "candidate_origin", CANDIDATES, 3, origin);
    memcpy(input->frame.rotation, frame, sizeof input->frame.rotation);
    memcpy(input->frame.origin, frame + 9, sizeof input->frame.origin);
    input->frame.scale = frame[12];
    for (int i = 0; i < CANDIDATES; ++i) {
        candidates[i].type = slides[i] > 0 ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE;
        memcpy(candidates[i].axis, axis[i], sizeof axis[i]);
        memcpy(candidates[i].origin, origin[i], sizeof origin[i]);
    }
    dmi_kpp_candidate_scores(net, isa, input, output, candidates, CANDIDATES, scores);
    golden_compare(golden, "scores", CANDIDATES, 0, scores, 3 * GOLDEN_TOLERANCE, where);
}

static void compare(const dmi_kpp_net* net, dmi_isa isa, const char* name, const dmi_weights* golden) {
    dmi_kpp_input* input = calloc(1, sizeof *input);
    dmi_kpp_output output;
    char where[64];
    snprintf(where, sizeof where, "%s %s", name, dmi_isa_name(isa));
    golden_copy(golden, "global_points", DMI_KPP_GLOBAL_GROUPS * DMI_KPP_GROUP, DMI_KPP_CHANNELS, input->global_points);
    golden_copy(golden, "global_centres", DMI_KPP_GLOBAL_GROUPS, 3, input->global_centres);
    golden_copy(golden, "local_points", DMI_KPP_LOCAL_GROUPS * DMI_KPP_GROUP, DMI_KPP_CHANNELS, input->local_points);
    golden_copy(golden, "local_centres", DMI_KPP_LOCAL_GROUPS, 3, input->local_centres);
    golden_copy(golden, "shape", DMI_KPP_SHAPE, 0, input->shape);
    void* scratch = platform_allocate(dmi_kpp_net_scratch_size(net), 64);
    dmi_kpp_net_forward(net, isa, input, scratch, &output);
    golden_compare(golden, "type_logits", DMI_KPP_TYPES, 0, output.type_logits, GOLDEN_TOLERANCE, where);
    golden_compare(golden, "turn_axis", 3, 0, output.turn_axis, GOLDEN_TOLERANCE, where);
    golden_compare(golden, "slide_axis", 3, 0, output.slide_axis, GOLDEN_TOLERANCE, where);
    golden_compare(golden, "origin", 3, 0, output.origin, GOLDEN_TOLERANCE, where);
    golden_compare(golden, "limits", 5, 0, output.limits, GOLDEN_TOLERANCE, where);
    compare_choice(net, isa, golden, input, &output, where);
    platform_release(scratch);
    free(input);
}

static void answers_as_pytorch(void** state) {
    const char* name = *state;
    char path[128];
    test_env t;
    dmi_kpp_net* net = NULL;
    snprintf(path, sizeof path, "tests/golden/data/%s.safetensors", name);
    golden_file answers = golden_read(path), weights = golden_read("sdk/models/kpp_net.safetensors");
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(dmi_kpp_net_load(&t.env, weights.data, weights.size, &net), DM_OK);
    dmi_weights* golden = golden_open(&t.env, answers, "dragmesh-golden-kpp", weights);
    for (dmi_isa isa = DMI_ISA_SCALAR; isa <= DMI_ISA_NEON; ++isa)
        if (dmi_kernels_usable(isa)) compare(net, isa, name, golden);
    dmi_weights_close(golden);
    dmi_kpp_net_destroy(net);
    test_env_close(&t);
    free(answers.data);
    free(weights.data);
}

static dm_result load_and_destroy(dmi_env* env, const void* data, size_t size) {
    dmi_kpp_net* net = NULL;
    const dm_result result = dmi_kpp_net_load(env, data, size, &net);
    dmi_kpp_net_destroy(net);
    return result;
}

static void loading_fails_by_name(void** state) {
    (void)state;
    golden_check_loading(load_and_destroy, "sdk/models/kpp_net.safetensors", "sdk/models/dq_vae.safetensors",
                         "limits.2.bias");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        {"with a drag", answers_as_pytorch, NULL, NULL, "kpp_drag"},
        {"without a drag", answers_as_pytorch, NULL, NULL, "kpp_free"},
        cmocka_unit_test(loading_fails_by_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
