/* KPP-Net's candidate-scoring head: how likely the network holds each candidate. Regression can only answer the mean of
 * two likely hinges; this says that either is likely. */
#ifndef DMI_FEATURES_KPP_CANDIDATE_SCORES_H
#define DMI_FEATURES_KPP_CANDIDATE_SCORES_H

#include "kinematics/candidates/candidates.h"

/* Writes log-likelihoods up to a constant. input, output: of dmi_kpp_net_forward for the same part and drag. */
void dmi_kpp_candidate_scores(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_input* input,
                              const dmi_kpp_output* output, const dmi_candidate* candidates, uint32_t count,
                              float* out_scores);

#endif
