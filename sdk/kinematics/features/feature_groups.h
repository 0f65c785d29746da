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
    float swept[DMI_SWEPT_POINTS][3]; /* the points of the sweep: first those that do not touch the body at rest … */
    uint32_t free_count;              /* … which are so many */
} dmi_feature_context;

static inline bool dmi_candidate_slides(const dmi_candidate* candidate) {
    return candidate->type == DM_JOINT_PRISMATIC;
}

/* slip_features.c: SLIP and the CONTACT groups. */
void dmi_slip_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                       float row[DMI_FEATURE_COUNT]);

/* sweep_features.c: fills context->swept and free_count, and the group SWEEP. */
void dmi_sweep_features_begin(dmi_feature_context* context);
void dmi_sweep_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                        float row[DMI_FEATURE_COUNT]);

/* place_features.c: the full features of PLACE, DRAG, WIDEST_GAP and PROTRUSION, and the groups ALONG, ROTATION and
 * OUTLINE. */
void dmi_place_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                        float row[DMI_FEATURE_COUNT]);

/* axis_hardware.c: fills the group HARDWARE but for what compares candidates. Axis hardware is pins, knuckles, sockets,
 * rims and shells that lie on the axis of a candidate joint, on the part and on the body. A pair in line, one on either
 * side, suggests a hinge more strongly than a single one. */
void dmi_axis_hardware_features(const dmi_part_analysis* analysis, const dmi_candidate* candidate,
                                float row[DMI_FEATURE_COUNT]);

/* ---- symmetry_features.c ---- */

/* Mirror symmetry of the part and of the body near it. Joints tend to respect it: the axis of a symmetric lid is
 * perpendicular to its mirror plane, a drawer slides along its mirror planes, and of two doors side by side each has
 * its hinge on the side away from the other. */

/* How far the part is from its image in the mirror through its middle, how far the body near it is from its own, and
 * how far that mirror is from the object's middle. */
typedef struct dmi_mirror_distances {
    float part, body, offset;
} dmi_mirror_distances;

/* A mirror plane through the middle of the part's box. twins: the part is mirrored at its low side and at its high side
 * along the normal; mean distance of each image from the body. Small: there is a second part alike. */
typedef struct dmi_mirror_plane {
    float normal[3];
    dmi_mirror_distances middle;
    float twins[2];
} dmi_mirror_plane;

/* The candidates of a part share most of their mirrors: each is measured once. */
#define DMI_MIRROR_PLANES 128 /* most planes; by hand: parts have a few dozen */
typedef struct dmi_symmetry {
    const dmi_part_analysis* analysis;
    float centre[3]; /* centre of the part's box */
    dmi_mirror_plane planes[DMI_MIRROR_PLANES];
    uint32_t count;
} dmi_symmetry;

void dmi_symmetry_begin(const dmi_part_analysis* analysis, dmi_symmetry* out);
/* Fills the group MIRROR but for what compares candidates. */
void dmi_symmetry_features(dmi_symmetry* symmetry, const dmi_candidate* candidate, float row[DMI_FEATURE_COUNT]);

#endif
