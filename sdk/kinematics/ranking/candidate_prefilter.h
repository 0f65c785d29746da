/* A small network that sees candidates at a glance and keeps those worth all of the evidence. Trained on generated
 * objects; its weights lie in the ranker's file. */
#ifndef DMI_RANKING_CANDIDATE_PREFILTER_H
#define DMI_RANKING_CANDIDATE_PREFILTER_H

#include "kinematics/features/cheap_features.h"
#include "kinematics/features/kpp_ensemble.h"
#include "nn/weights.h"

#define DMI_PREFILTER_HIDDEN 16
/* The right joint is among so many for 99 in 100 parts of which it is a candidate at all. */
#define DMI_PREFILTER_KEPT 256

/* Glance -> 16 -> 1, ReLU between; weights transposed, the standardisation folded in. */
typedef struct dmi_prefilter {
    float first[DMI_CHEAP_COLUMNS][DMI_PREFILTER_HIDDEN], first_bias[DMI_PREFILTER_HIDDEN];
    float last[DMI_PREFILTER_HIDDEN];
} dmi_prefilter;

/* 0 when a tensor is missing or of another shape. */
int dmi_prefilter_read(const dmi_weights* weights, dmi_prefilter* out_sieve);

/* Moves the DMI_PREFILTER_KEPT best candidates to the front, in the order they had; answers how many there are now.
 * net and opinion NULL: without a network. rows: scratch, one a candidate. */
uint32_t dmi_prefilter_keep(const dmi_prefilter* sieve, const dmi_part_analysis* study, const dmi_drag_hint* hint,
                            const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_ensemble* opinion,
                            dmi_candidate* candidates, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]);

#endif
