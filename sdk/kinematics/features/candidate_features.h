/* Computes the features of candidate joints: one row of numbers a candidate, for prefilter, ranker and limits. No
 * feature depends on the world's axes, the object's unit or its place. */
#ifndef DMI_FEATURES_CANDIDATE_FEATURES_H
#define DMI_FEATURES_CANDIDATE_FEATURES_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/features/feature_table.h"

/* Fills every column of `count` rows. hint NULL: without a drag. prediction and scores (of dmi_kpp_ensemble_score, one
 * a candidate) NULL: without KPP-Net. The columns of what is missing are 0. */
void dmi_candidate_features_make(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                                 const dmi_prediction* prediction, const float* scores, const dmi_candidate* candidates,
                                 uint32_t count, float (*out)[DMI_FEATURE_COUNT]);

#endif
