/* What speaks for and against a candidate joint, as numbers for the ranker. Nothing here knows the world's axes, the
 * object's unit or where it stands; a drag is soft evidence (hands are off by 5 to 10 degrees). */
#ifndef DMI_KINEMATICS_EVIDENCE_H
#define DMI_KINEMATICS_EVIDENCE_H

#include "kinematics/candidates.h"

/* One row a candidate. Named because the rules that stand in for a missing ranker read them; the ranker reads them all.
 */
enum {
    DMI_EVIDENCE_SLIDES = 0,     /* 1 for prismatic */
    DMI_EVIDENCE_SLIP = 1,       /* mean normal speed of the part's surface over its mean speed */
    DMI_EVIDENCE_CONTACT = 2,    /* 7 for each contact region, see contact_evidence */
    DMI_EVIDENCE_SWEEP = 23,     /* 14: collision, detachment and touch on either side, see sweep_evidence */
    DMI_EVIDENCE_SHAPE = 37,     /* 5: proportions of the part */
    DMI_EVIDENCE_ALIGNMENT = 42, /* 12: to the long, middle and short side of its box */
    DMI_EVIDENCE_PLACE = 54,     /* 11: where the axis runs through the part */
    DMI_EVIDENCE_SIDE = 65,      /* 3: place in the box across the axis, 1 = on a side */
    DMI_EVIDENCE_ALONG = 68,     /* 4: distances from the body and the part along the axis */
    DMI_EVIDENCE_SYMMETRY = 72,  /* 3: the part turned on itself */
    DMI_EVIDENCE_DRAG = 75,      /* 11 */
    DMI_EVIDENCE_NETWORK = 86,   /* 12 */
    DMI_EVIDENCE_DIRECTION = 98, /* families, one a bit */
    DMI_EVIDENCE_ORIGIN = DMI_EVIDENCE_DIRECTION + DMI_DIRECTION_FAMILIES,
    DMI_EVIDENCE_RELATIVE = DMI_EVIDENCE_ORIGIN + DMI_ORIGIN_FAMILIES, /* 24: see relative_evidence */
    DMI_EVIDENCE_HANDLE = DMI_EVIDENCE_RELATIVE + 24,                  /* 4: what stands out, seen from the axis */
    DMI_EVIDENCE_OUTLINE = DMI_EVIDENCE_HANDLE + 4,                    /* 4: the axis in the whole object */
    DMI_EVIDENCE_SPOT = DMI_EVIDENCE_OUTLINE + 4,    /* 8: where the axis runs through the box's cross-section */
    DMI_EVIDENCE_GRIP = DMI_EVIDENCE_SPOT + 8,       /* 6: what a hand takes hold of, seen from the axis */
    DMI_EVIDENCE_CHOICE = DMI_EVIDENCE_GRIP + 6,     /* 6: see dmi_glance_choice */
    DMI_EVIDENCE_MIRROR = DMI_EVIDENCE_CHOICE + 6,   /* 13: see mirror.h and mirror_evidence */
    DMI_EVIDENCE_BEARING = DMI_EVIDENCE_MIRROR + 13, /* 12: see bearing.h and bearing_evidence */
    DMI_EVIDENCE_COUNT = DMI_EVIDENCE_BEARING + 12
};

/* hint, prediction and scores (of dmi_kpp_choice, one a candidate) may be NULL: their numbers are then 0. */
void dmi_evidence_make(const dmi_study* study, const dmi_drag_hint* hint, const dmi_prediction* prediction,
                       const float* scores, const dmi_candidate* candidates, uint32_t count,
                       float (*out)[DMI_EVIDENCE_COUNT]);

#endif
