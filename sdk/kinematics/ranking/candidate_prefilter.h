/* Prefilter: a small network that scores candidates by their cheap features and keeps those worth the full ones. Fitted
 * on generated objects. */
#ifndef DMI_RANKING_CANDIDATE_PREFILTER_H
#define DMI_RANKING_CANDIDATE_PREFILTER_H

#include "kinematics/features/cheap_features.h"
#include "kinematics/features/kpp_ensemble.h"
#include "nn/layers.h"

/* Number of candidates kept. Measured: the right joint is among so many for 99 in 100 parts of which it is a candidate
 * at all. */
#define DMI_PREFILTER_KEPT 256

typedef struct dmi_prefilter {
    dmi_perceptron network; /* cheap features -> 16 -> 1 */
} dmi_prefilter;

void dmi_prefilter_read(dmi_loader* loader, dmi_prefilter* out_prefilter);

/* Moves the DMI_PREFILTER_KEPT best candidates to the front, in the order they had. Returns how many there are now. net
 * and ensemble: NULL when there is no KPP-Net. rows: scratch, one a candidate. */
uint32_t dmi_prefilter_keep(const dmi_prefilter* prefilter, const dmi_part_analysis* analysis,
                            const dmi_drag_hint* hint, const dmi_kpp_net* net, dmi_isa isa,
                            const dmi_kpp_ensemble* ensemble, dmi_candidate* candidates, uint32_t count,
                            float (*rows)[DMI_FEATURE_COUNT]);

#endif
