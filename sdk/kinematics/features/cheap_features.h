/* The features that cost a few operations a candidate: every candidate's, for the prefilter. */
#ifndef DMI_FEATURES_CHEAP_FEATURES_H
#define DMI_FEATURES_CHEAP_FEATURES_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/features/feature_table.h"

/* What all candidates of a part share. */
typedef struct dmi_cheap_features {
    const dmi_part_analysis* analysis;
    const dmi_drag_hint* hint;        /* NULL: none */
    const dmi_prediction* prediction; /* NULL: none */
    float drag[3], drag_normal[3];    /* unit; the part's normal at the dragged point */
    float drag_length;                /* object sizes */
    int room_axis;                    /* the axis of the object's frame that the drag runs along; -1: none */
    float side[3], middle[3];         /* lengths of the part's box and its centre, along its axes */
    float box_centre[3];
    float log_diagonal, log_area_ratio; /* the same numbers as in the group SHAPE */
} dmi_cheap_features;

/* hint and prediction may be NULL. */
void dmi_cheap_features_begin(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                              const dmi_prediction* prediction, dmi_cheap_features* out);
/* Fills the cheap columns (dmi_cheap_columns) but those of the group NETWORK_SCORE. Leaves the others as they are. */
void dmi_cheap_features_row(const dmi_cheap_features* cheap, const dmi_candidate* candidate,
                            float row[DMI_FEATURE_COUNT]);
/* Fills the group NETWORK_SCORE. scores: log-likelihoods up to a constant, one a row; NULL: zeros. */
void dmi_cheap_features_kpp_scores(const float* scores, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]);

#endif
