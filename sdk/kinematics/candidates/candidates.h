/* Candidate joints: axes along every direction and through every point that a part's shape, its contacts, a drag or the
 * network suggest. The ranker chooses among them. */
#ifndef DMI_CANDIDATES_CANDIDATES_H
#define DMI_CANDIDATES_CANDIDATES_H

#include "kinematics/analysis/part_analysis.h"
#include "kinematics/kpp/kpp_net.h"
#include "math/linear3.h"

#define DMI_CANDIDATES_MAX 1536 /* most candidates; by hand */

/* Sources of a direction (bits). */
enum {
    DMI_DIRECTION_BOX = 1 << 0,         /* axes of the part's box */
    DMI_DIRECTION_PART = 1 << 1,        /* principal directions of the part */
    DMI_DIRECTION_ALL = 1 << 2,         /* principal directions of the body near it */
    DMI_DIRECTION_NORMAL = 1 << 3,      /* normal clusters of the part */
    DMI_DIRECTION_NEAR_NORMAL = 1 << 4, /* normal clusters of the body near it */
    DMI_DIRECTION_CONTACT = 1 << 5,     /* principal directions of a contact region */
    DMI_DIRECTION_SLIP = 1 << 6,        /* slippage of the part or a contact */
    DMI_DIRECTION_PATCH = 1 << 7,       /* axis of a patch of the part */
    DMI_DIRECTION_NEAR_PATCH = 1 << 8,  /* axis of a patch of the body */
    DMI_DIRECTION_DRAG = 1 << 9,        /* perpendicular to the drag, or along it */
    DMI_DIRECTION_NETWORK = 1 << 10     /* predicted by KPP-Net */
};
#define DMI_DIRECTION_FAMILIES 11

/* Sources of a point of the axis (bits). */
enum {
    DMI_ORIGIN_CENTROID = 1 << 0,        /* mean of the part's points */
    DMI_ORIGIN_BOX = 1 << 1,             /* centre of the part's box */
    DMI_ORIGIN_CONTACT = 1 << 2,         /* mean or box centre of a contact region */
    DMI_ORIGIN_CONTACT_CLUSTER = 1 << 3, /* box centre of a cluster of a contact region */
    DMI_ORIGIN_SHELL = 1 << 4,           /* centre of a shell of the part */
    DMI_ORIGIN_PATCH = 1 << 5,           /* centre of a smooth region of the part */
    DMI_ORIGIN_NEAR_SHELL = 1 << 6,      /* centre of a shell of the body near the part */
    DMI_ORIGIN_NEAR_PATCH = 1 << 7,      /* centre of a smooth region of the body near the part */
    DMI_ORIGIN_CORNER = 1 << 8,          /* edge of the box along the axis */
    DMI_ORIGIN_SIDE = 1 << 9,            /* centre line of a face of the box */
    DMI_ORIGIN_INSET = 1 << 10,          /* half a thickness from a side */
    DMI_ORIGIN_CONTACT_BOX = 1 << 11,    /* half a thickness from a side of a contact region's box */
    DMI_ORIGIN_SLIP = 1 << 12,           /* slippage of the part or a contact */
    DMI_ORIGIN_LINE = 1 << 13,           /* axis of a patch of the part */
    DMI_ORIGIN_NEAR_LINE = 1 << 14,      /* axis of a patch of the body */
    DMI_ORIGIN_NETWORK = 1 << 15         /* predicted by KPP-Net */
};
#define DMI_ORIGIN_FAMILIES 16

typedef struct dmi_candidate {
    int32_t type;             /* DM_JOINT_REVOLUTE or DM_JOINT_PRISMATIC */
    float axis[3], origin[3]; /* origin: the point of the axis nearest the part's centre */
    uint32_t direction_families, origin_families;
} dmi_candidate;

/* Computes the velocity of a point of the part per radian (revolute) or per unit of length (prismatic). */
static inline void dmi_candidate_velocity(const dmi_candidate* c, const float point[3], float out[3]) {
    if (c->type == DM_JOINT_PRISMATIC) {
        dmi_copy3(c->axis, out);
        return;
    }
    float arm[3];
    dmi_sub3(point, c->origin, arm);
    dmi_cross3(c->axis, arm, out);
}

/* Makes two candidates of KPP-Net's prediction, revolute and prismatic, with their probabilities. centre: the part's.
 */
void dmi_prediction_candidates(const dmi_prediction* prediction, const float centre[3], dmi_candidate out[2],
                               float out_probability[2]);

/* Makes the candidates. hint and prediction may be NULL. A drag signs the axes. Returns how many there are, 1 ..
 * DMI_CANDIDATES_MAX. */
uint32_t dmi_candidates_make(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                             const dmi_prediction* prediction, dmi_candidate* out);

/* Adds turns about lines through a point along unit directions, and slides along them, where a drag allows them and no
 * candidate is the same. count: the number of candidates before. Returns their number with those added. */
uint32_t dmi_candidates_add_through(const dmi_part_analysis* analysis, const dmi_drag_hint* hint, const float point[3],
                                    const float (*directions)[3], uint32_t direction_count, dmi_candidate* candidates,
                                    uint32_t count);

#endif
