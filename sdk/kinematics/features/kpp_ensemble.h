/* KPP-Net as an ensemble of one network: it runs several times, each time on other points of the cloud, every second
 * time with two axes of its frame reversed, because the sign of these axes is partly a convention. */
#ifndef DMI_FEATURES_KPP_ENSEMBLE_H
#define DMI_FEATURES_KPP_ENSEMBLE_H

#include "kinematics/candidates/candidates.h"

#define DMI_KPP_MEMBERS 4

typedef struct dmi_kpp_ensemble {
    dmi_kpp_input input[DMI_KPP_MEMBERS];
    dmi_kpp_output output[DMI_KPP_MEMBERS];
    dmi_prediction prediction; /* prediction of the member that the others agree with most; type: the mean of all */
} dmi_kpp_ensemble;

/* Returns false when an output can't be computed with: weights have overflowed. hint NULL: without a drag. scratch: as
 * for dmi_kpp_net_forward. */
bool dmi_kpp_ensemble_run(const dmi_kpp_net* net, dmi_isa isa, const dmi_cloud* cloud, const dmi_drag_hint* hint,
                          void* scratch, dmi_kpp_ensemble* out_ensemble);

/* ---- scores of candidates ---- */

/* KPP-Net's candidate-scoring head gives a log-likelihood for each candidate. Where two hinges are likely, regression
 * answers their mean; the head can rate both. */

/* Writes one network's log-likelihoods up to a constant. input, output: of dmi_kpp_net_forward for the same part and
 * drag. */
void dmi_kpp_candidate_scores(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_input* input,
                              const dmi_kpp_output* output, const dmi_candidate* candidates, uint32_t count,
                              float* out_scores);
/* Writes log-likelihoods of candidates up to a constant: the mean of all members. */
void dmi_kpp_ensemble_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_ensemble* ensemble,
                            const dmi_candidate* candidates, uint32_t count, float out_scores[DMI_CANDIDATES_MAX]);
/* Writes those of the first member alone. */
void dmi_kpp_ensemble_score_first(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_ensemble* ensemble,
                                  const dmi_candidate* candidates, uint32_t count,
                                  float out_scores[DMI_CANDIDATES_MAX]);

#endif
