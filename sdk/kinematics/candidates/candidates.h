/* Joints worth considering: every direction and every point that a part's shape, its contacts, a drag or the network
 * suggests. Choosing among them is the ranker's work. */
#ifndef DMI_CANDIDATES_CANDIDATES_H
#define DMI_CANDIDATES_CANDIDATES_H

#include "kinematics/analysis/part_analysis.h"
#include "kinematics/kpp/kpp_prediction.h"
#include "math/linear3.h"

#define DMI_CANDIDATES_MAX 1536

/* Where a direction comes from (bits). */
enum {
    DMI_DIRECTION_BOX = 1 << 0,
    DMI_DIRECTION_PART = 1 << 1,        /* principal directions of the part */
    DMI_DIRECTION_ALL = 1 << 2,         /* of the body near it */
    DMI_DIRECTION_NORMAL = 1 << 3,      /* a face normal of the part */
    DMI_DIRECTION_NEAR_NORMAL = 1 << 4, /* of the body near it */
    DMI_DIRECTION_CONTACT = 1 << 5,     /* principal directions of a contact region */
    DMI_DIRECTION_SLIP = 1 << 6,        /* slippage of the part or a contact */
    DMI_DIRECTION_PATCH = 1 << 7,       /* axis of a patch of the part */
    DMI_DIRECTION_NEAR_PATCH = 1 << 8,  /* of the body */
    DMI_DIRECTION_DRAG = 1 << 9,        /* across the drag and something of the part */
    DMI_DIRECTION_NETWORK = 1 << 10
};
#define DMI_DIRECTION_FAMILIES 11

/* Where a point of the axis comes from (bits). */
enum {
    DMI_ORIGIN_CENTROID = 1 << 0,
    DMI_ORIGIN_BOX = 1 << 1,
    DMI_ORIGIN_CONTACT = 1 << 2,
    DMI_ORIGIN_CONTACT_CLUSTER = 1 << 3,
    DMI_ORIGIN_SHELL = 1 << 4,
    DMI_ORIGIN_PATCH = 1 << 5,
    DMI_ORIGIN_NEAR_SHELL = 1 << 6,
    DMI_ORIGIN_NEAR_PATCH = 1 << 7,
    DMI_ORIGIN_CORNER = 1 << 8, /* edge of the box along the axis */
    DMI_ORIGIN_SIDE = 1 << 9,   /* middle line of a face of it */
    DMI_ORIGIN_INSET = 1 << 10, /* half a thickness from a side */
    DMI_ORIGIN_CONTACT_BOX = 1 << 11,
    DMI_ORIGIN_SLIP = 1 << 12,
    DMI_ORIGIN_LINE = 1 << 13, /* axis of a patch of the part */
    DMI_ORIGIN_NEAR_LINE = 1 << 14,
    DMI_ORIGIN_NETWORK = 1 << 15
};
#define DMI_ORIGIN_FAMILIES 16

typedef struct dmi_candidate {
    int32_t type;             /* DM_JOINT_REVOLUTE or DM_JOINT_PRISMATIC */
    float axis[3], origin[3]; /* origin: the point of the axis nearest the part's centre */
    uint32_t direction_families, origin_families;
} dmi_candidate;

/* Of a point of the part, at unit speed: per radian or per unit of way. */
static inline void dmi_candidate_velocity(const dmi_candidate* c, const float point[3], float out[3]) {
    if (c->type == DM_JOINT_PRISMATIC) {
        dmi_copy3(c->axis, out);
        return;
    }
    float arm[3];
    dmi_sub3(point, c->origin, arm);
    dmi_cross3(c->axis, arm, out);
}

/* The network's answer as two candidates, a turn and a slide, with its probabilities: the plain KPP-Net. centre: of the
 * part. */
void dmi_prediction_candidates(const dmi_prediction* prediction, const float centre[3], dmi_candidate out[2],
                               float out_probability[2]);

/* hint and prediction may be NULL. Signs follow the drag where there is one. Answers how many, at most
 * DMI_CANDIDATES_MAX; at least one. */
uint32_t dmi_candidates_make(const dmi_part_analysis* study, const dmi_drag_hint* hint,
                             const dmi_prediction* prediction, dmi_candidate* out);

#endif
