/* A few forward passes and their means. */
#include "kinematics/opinion.h"

#include <math.h>
#include <string.h>

/* Shifts log-likelihoods so that they add up to a probability of one. */
static void normalize(float* scores, uint32_t count) {
    float most = -INFINITY, sum = 0;
    for (uint32_t i = 0; i < count; i++) most = fmaxf(most, scores[i]);
    for (uint32_t i = 0; i < count; i++) sum += expf(scores[i] - most);
    for (uint32_t i = 0; i < count; i++) scores[i] -= most + logf(sum);
}

/* Every look is at other points of the cloud, every second one with its frame turned. */
static void look(const dmi_cloud* cloud, uint32_t index, const dmi_drag_hint* hint, dmi_kpp_input* out) {
    if (index % 2 == 0) {
        dmi_kpp_input_make(cloud, index % DMI_KPP_QUARTERS, hint, out);
        return;
    }
    dmi_kpp_input straight;
    dmi_kpp_input_make(cloud, index % DMI_KPP_QUARTERS, hint, &straight);
    dmi_kpp_input_turn(&straight, out);
}

void dmi_opinion_form(const dmi_kpp_net* net, dmi_isa isa, const dmi_cloud* cloud, const dmi_drag_hint* hint,
                      void* scratch, dmi_opinion* out_opinion) {
    dmi_opinion* o = out_opinion;
    float type[DMI_KPP_TYPES] = {0};
    for (uint32_t i = DMI_LOOKS; i-- > 0;) {
        look(cloud, i, hint, &o->input[i]);
        dmi_kpp_net_forward(net, isa, &o->input[i], scratch, &o->output[i]);
        dmi_prediction_read(&o->input[i].frame, &o->output[i], &o->prediction);
        for (int k = 0; k < DMI_KPP_TYPES; k++) type[k] += o->prediction.type[k] / DMI_LOOKS;
    }
    memcpy(o->prediction.type, type, sizeof type);
}

void dmi_opinion_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_opinion* opinion, const dmi_candidate* candidates,
                       uint32_t count, float out_scores[DMI_CANDIDATES_MAX]) {
    float one[DMI_CANDIDATES_MAX];
    memset(out_scores, 0, count * sizeof *out_scores);
    for (int i = 0; i < DMI_LOOKS; i++) {
        dmi_kpp_choice(net, isa, &opinion->input[i], &opinion->output[i], candidates, count, one);
        normalize(one, count);
        for (uint32_t c = 0; c < count; c++) out_scores[c] += one[c] / DMI_LOOKS;
    }
}
