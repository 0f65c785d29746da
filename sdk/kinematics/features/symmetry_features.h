/* Mirror images: what looks the same in a mirror mostly moves alike in it. A lid that is its own image across the
 * middle of its hinge turns about that normal, a drawer runs along its mirrors, and a door whose image lies beside it
 * opens away from it. */
#ifndef DMI_FEATURES_SYMMETRY_FEATURES_H
#define DMI_FEATURES_SYMMETRY_FEATURES_H

#include "kinematics/candidates/candidates.h"

enum {
    DMI_SYMMETRY_MIDPLANES = 0, /* 3 x 3: how far the part is from its image and how far the body near it is, in the
                               mirror through the part's middle; how far that is from the object's middle. Across the
                               axis; towards it (a slide: that of the other two in which the part is more its own
                               image); across both */
    DMI_SYMMETRY_TWINS = 9,     /* 2: how far the part's image beyond its side away from the axis is from the body, and
                                 beyond     the side towards it (a slide: beyond its sides): near, where it has a twin */
    DMI_SYMMETRY_COUNT = 11
};

/* One mirror through the part's middle, and those at its low and its high side along the normal. */
typedef struct dmi_mirror_plane {
    float normal[3], middle[3], twins[2];
} dmi_mirror_plane;

/* What the candidates of a part are seen with. They share most of their mirrors: each is looked into once. */
#define DMI_MIRROR_PLANES 128
typedef struct dmi_symmetry {
    const dmi_part_analysis* study;
    float centre[3]; /* of the part's box */
    dmi_mirror_plane looks[DMI_MIRROR_PLANES];
    uint32_t count;
} dmi_symmetry;

void dmi_symmetry_begin(const dmi_part_analysis* study, dmi_symmetry* out);
/* Distances are means in diagonals of the part, at most a quarter. */
void dmi_symmetry_features(dmi_symmetry* mirror, const dmi_candidate* candidate, float out[DMI_SYMMETRY_COUNT]);

#endif
