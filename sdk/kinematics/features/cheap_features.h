/* The first look at candidate joints: the numbers of their evidence that cost next to nothing. */
#ifndef DMI_FEATURES_CHEAP_FEATURES_H
#define DMI_FEATURES_CHEAP_FEATURES_H

#include "kinematics/features/candidate_features.h"

/* The columns of the evidence that a glance fills, in rising order. */
#define DMI_CHEAP_COLUMNS 96
extern const uint8_t dmi_cheap_columns[DMI_CHEAP_COLUMNS];

/* What all candidates of a part are seen with. */
typedef struct dmi_cheap_features {
    const dmi_part_analysis* study;
    const dmi_drag_hint* hint;
    const dmi_prediction* prediction;
    float drag[3], drag_normal[3]; /* unit */
    float side[3], middle[3];      /* lengths of the box and its centre, along its axes */
    float box_centre[3];
    float shape[5];
} dmi_cheap_features;

/* hint and prediction may be NULL. */
void dmi_cheap_features_begin(const dmi_part_analysis* study, const dmi_drag_hint* hint,
                              const dmi_prediction* prediction, dmi_cheap_features* out);
/* Those columns but the choice's; the others are left as they are. */
void dmi_cheap_features_row(const dmi_cheap_features* glance, const dmi_candidate* candidate,
                            float row[DMI_FEATURE_COUNT]);
/* scores: one a row, may be NULL. */
void dmi_cheap_features_kpp_scores(const float* scores, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]);

#endif
