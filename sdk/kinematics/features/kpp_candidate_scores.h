/* KPP-Net's candidate-scoring head: a log-likelihood for each candidate. Where two hinges are likely, regression
 * answers their mean; the head can rate both. */
#ifndef DMI_FEATURES_KPP_CANDIDATE_SCORES_H
#define DMI_FEATURES_KPP_CANDIDATE_SCORES_H

#include "kinematics/candidates/candidates.h"

/* Writes log-likelihoods up to a constant. input, output: of dmi_kpp_net_forward for the same part and drag. */
void dmi_kpp_candidate_scores(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_input* input,
                              const dmi_kpp_output* output, const dmi_candidate* candidates, uint32_t count,
                              float* out_scores);

#endif
