/* The first look at candidate joints: the numbers of their evidence that cost next to nothing. */
#ifndef DMI_KINEMATICS_GLANCE_H
#define DMI_KINEMATICS_GLANCE_H

#include "kinematics/evidence.h"

/* The columns of the evidence that a glance fills, in rising order. */
#define DMI_GLANCE_COLUMNS 96
extern const uint8_t dmi_glance_columns[DMI_GLANCE_COLUMNS];

/* What all candidates of a part are seen with. */
typedef struct dmi_glance {
    const dmi_study* study;
    const dmi_drag_hint* hint;
    const dmi_prediction* prediction;
    float drag[3], drag_normal[3]; /* unit */
    float side[3], middle[3];      /* lengths of the box and its centre, along its axes */
    float box_centre[3];
    float shape[5];
} dmi_glance;

/* hint and prediction may be NULL. */
void dmi_glance_begin(const dmi_study* study, const dmi_drag_hint* hint, const dmi_prediction* prediction,
                      dmi_glance* out);
/* Those columns but the choice's; the others are left as they are. */
void dmi_glance_row(const dmi_glance* glance, const dmi_candidate* candidate, float row[DMI_EVIDENCE_COUNT]);
/* scores: one a row, may be NULL. */
void dmi_glance_choice(const float* scores, uint32_t count, float (*rows)[DMI_EVIDENCE_COUNT]);

#endif
