/* The groups of features, each measured by one function. Rows are indexed by DMI_FEATURE_*. */
#ifndef DMI_FEATURES_FEATURE_GROUPS_H
#define DMI_FEATURES_FEATURE_GROUPS_H

#include "kinematics/features/candidate_features.h"
#include "kinematics/features/cheap_features.h"

#define DMI_SWEPT_POINTS 96 /* points of the part in the collision sweep; by hand */

/* What all candidates of a part are measured with. */
typedef struct dmi_feature_context {
    const dmi_part_analysis* analysis;
    const dmi_drag_hint* hint; /* NULL: none */
    dmi_cheap_features cheap;
    int32_t free[DMI_SWEPT_POINTS]; /* 1: the point does not touch the body at rest */
} dmi_feature_context;

static inline bool dmi_candidate_slides(const dmi_candidate* candidate) {
    return candidate->type == DM_JOINT_PRISMATIC;
}

/* slip_features.c: SLIP and the CONTACT groups. */
void dmi_slip_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                       float row[DMI_FEATURE_COUNT]);

/* sweep_features.c: fills context->free, and the group SWEEP. */
void dmi_sweep_features_begin(dmi_feature_context* context);
void dmi_sweep_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                        float row[DMI_FEATURE_COUNT]);

/* place_features.c: the full features of PLACE, DRAG, WIDEST_GAP and PROTRUSION, and the groups ALONG, ROTATION and
 * OUTLINE. */
void dmi_place_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                        float row[DMI_FEATURE_COUNT]);

#endif
