/* Mirror symmetry: what is its own image in a mirror mostly moves alike on both sides of it. A lid that is its own
 * image across the middle of its hinge turns about that normal, a drawer runs along its mirrors, and a door whose image
 * lies beside it opens away from it. */
#ifndef DMI_FEATURES_SYMMETRY_FEATURES_H
#define DMI_FEATURES_SYMMETRY_FEATURES_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/features/feature_table.h"

/* How far the part is from its image in the mirror through its middle, how far the body near it is from its own, and
 * how far that mirror is from the object's middle. */
typedef struct dmi_mirror_distances {
    float part, body, offset;
} dmi_mirror_distances;

/* A mirror through the middle of the part's box; twins: how far the part's image beyond its low and beyond its high
 * side along the normal is from the body. */
typedef struct dmi_mirror_plane {
    float normal[3];
    dmi_mirror_distances middle;
    float twins[2];
} dmi_mirror_plane;

/* The candidates of a part share most of their mirrors: each is measured once. */
#define DMI_MIRROR_PLANES 128 /* by hand: parts have a few dozen */
typedef struct dmi_symmetry {
    const dmi_part_analysis* analysis;
    float centre[3]; /* of the part's box */
    dmi_mirror_plane planes[DMI_MIRROR_PLANES];
    uint32_t count;
} dmi_symmetry;

void dmi_symmetry_begin(const dmi_part_analysis* analysis, dmi_symmetry* out);
/* Fills the group MIRROR but for what compares candidates. */
void dmi_symmetry_features(dmi_symmetry* symmetry, const dmi_candidate* candidate, float row[DMI_FEATURE_COUNT]);

#endif
