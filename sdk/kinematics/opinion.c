/* Two forward passes and their means. */
#include "kinematics/opinion.h"

#include <math.h>

/* Shifts log-likelihoods so that they add up to a probability of one. */
static void normalize(float* scores, uint32_t count) {
    float most = -INFINITY, sum = 0;
    for (uint32_t i = 0; i < count; i++) most = fmaxf(most, scores[i]);
    for (uint32_t i = 0; i < count; i++) sum += expf(scores[i] - most);
    for (uint32_t i = 0; i < count; i++) scores[i] -= most + logf(sum);
}

void dmi_opinion_form(const dmi_kpp_net* net, dmi_isa isa, const dmi_cloud* cloud, const dmi_drag_hint* hint,
                      void* scratch, dmi_opinion* out_opinion) {
    dmi_opinion* o = out_opinion;
    dmi_kpp_input_make(cloud, hint, &o->input[0]);
    dmi_kpp_input_turn(&o->input[0], &o->input[1]);
    for (int i = 0; i < DMI_LOOKS; i++) dmi_kpp_net_forward(net, isa, &o->input[i], scratch, &o->output[i]);
    dmi_prediction second;
    dmi_prediction_read(&o->input[0].frame, &o->output[0], &o->prediction);
    dmi_prediction_read(&o->input[1].frame, &o->output[1], &second);
    for (int k = 0; k < DMI_KPP_TYPES; k++) o->prediction.type[k] = 0.5f * (o->prediction.type[k] + second.type[k]);
}

void dmi_opinion_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_opinion* opinion, const dmi_candidate* candidates,
                       uint32_t count, float out_scores[DMI_CANDIDATES_MAX]) {
    float other[DMI_CANDIDATES_MAX];
    dmi_kpp_choice(net, isa, &opinion->input[0], &opinion->output[0], candidates, count, out_scores);
    dmi_kpp_choice(net, isa, &opinion->input[1], &opinion->output[1], candidates, count, other);
    normalize(out_scores, count);
    normalize(other, count);
    for (uint32_t i = 0; i < count; i++) out_scores[i] = 0.5f * (out_scores[i] + other[i]);
}

void dmi_opinion_glance(const dmi_kpp_net* net, dmi_isa isa, const dmi_opinion* opinion,
                        const dmi_candidate* candidates, uint32_t count, float out_scores[DMI_CANDIDATES_MAX]) {
    dmi_kpp_choice(net, isa, &opinion->input[0], &opinion->output[0], candidates, count, out_scores);
}
