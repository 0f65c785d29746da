/* What speaks for and against a candidate joint, as numbers for the ranker. Nothing here knows the world's axes, the
 * object's unit or where it stands; a drag is soft evidence (hands are off by 5 to 10 degrees). */
#ifndef DMI_FEATURES_CANDIDATE_FEATURES_H
#define DMI_FEATURES_CANDIDATE_FEATURES_H

#include "kinematics/candidates/candidates.h"

/* One row a candidate. Named because the rules that stand in for a missing ranker read them; the ranker reads them all.
 */
enum {
    DMI_FEATURE_SLIDES = 0,     /* 1 for prismatic */
    DMI_FEATURE_SLIP = 1,       /* mean normal speed of the part's surface over its mean speed */
    DMI_FEATURE_CONTACT = 2,    /* 7 for each contact region, see contact_evidence */
    DMI_FEATURE_SWEEP = 23,     /* 14: collision, detachment and touch on either side, see sweep_evidence */
    DMI_FEATURE_SHAPE = 37,     /* 5: proportions of the part */
    DMI_FEATURE_ALIGNMENT = 42, /* 12: to the long, middle and short side of its box */
    DMI_FEATURE_PLACE = 54,     /* 11: where the axis runs through the part */
    DMI_FEATURE_SIDE = 65,      /* 3: place in the box across the axis, 1 = on a side */
    DMI_FEATURE_ALONG = 68,     /* 4: distances from the body and the part along the axis */
    DMI_FEATURE_SYMMETRY = 72,  /* 3: the part turned on itself */
    DMI_FEATURE_DRAG = 75,      /* 11 */
    DMI_FEATURE_NETWORK = 86,   /* 12 */
    DMI_FEATURE_DIRECTION = 98, /* families, one a bit */
    DMI_FEATURE_ORIGIN = DMI_FEATURE_DIRECTION + DMI_DIRECTION_FAMILIES,
    DMI_FEATURE_RELATIVE = DMI_FEATURE_ORIGIN + DMI_ORIGIN_FAMILIES, /* 24: see relative_evidence */
    DMI_FEATURE_HANDLE = DMI_FEATURE_RELATIVE + 24,                  /* 4: what stands out, seen from the axis */
    DMI_FEATURE_OUTLINE = DMI_FEATURE_HANDLE + 4,                    /* 4: the axis in the whole object */
    DMI_FEATURE_SPOT = DMI_FEATURE_OUTLINE + 4,    /* 8: where the axis runs through the box's cross-section */
    DMI_FEATURE_GRIP = DMI_FEATURE_SPOT + 8,       /* 6: what a hand takes hold of, seen from the axis */
    DMI_FEATURE_CHOICE = DMI_FEATURE_GRIP + 6,     /* 6: see dmi_cheap_features_kpp_scores */
    DMI_FEATURE_MIRROR = DMI_FEATURE_CHOICE + 6,   /* 13: see mirror.h and mirror_evidence */
    DMI_FEATURE_BEARING = DMI_FEATURE_MIRROR + 13, /* 12: see bearing.h and bearing_evidence */
    DMI_FEATURE_COUNT = DMI_FEATURE_BEARING + 12
};

/* hint, prediction and scores (of dmi_kpp_candidate_scores, one a candidate) may be NULL: their numbers are then 0. */
void dmi_candidate_features_make(const dmi_part_analysis* study, const dmi_drag_hint* hint,
                                 const dmi_prediction* prediction, const float* scores, const dmi_candidate* candidates,
                                 uint32_t count, float (*out)[DMI_FEATURE_COUNT]);

#endif
