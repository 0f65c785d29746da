/* Mirror symmetry of the part and of the body near it. Joints tend to respect it: the axis of a symmetric lid is
 * perpendicular to its mirror plane, a drawer slides along its mirror planes, and of two doors side by side each has
 * its hinge on the side away from the other. */
#ifndef DMI_FEATURES_SYMMETRY_FEATURES_H
#define DMI_FEATURES_SYMMETRY_FEATURES_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/features/feature_table.h"

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
