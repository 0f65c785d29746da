/* Mirror images: what looks the same in a mirror mostly moves alike in it. A lid that is its own image across the
 * middle of its hinge turns about that normal, a drawer runs along its mirrors, and a door whose image lies beside it
 * opens away from it. */
#ifndef DMI_KINEMATICS_MIRROR_H
#define DMI_KINEMATICS_MIRROR_H

#include "kinematics/candidates.h"

enum {
    DMI_MIRROR_MIDDLES = 0, /* 3 x 3: how far the part is from its image and how far the body near it is, in the mirror
                               through the part's middle; how far that is from the object's middle. Across the axis;
                               towards it (a slide: that of the other two in which the part is more its own image);
                               across both */
    DMI_MIRROR_TWINS = 9, /* 2: how far the part's image beyond its side away from the axis is from the body, and beyond
                             the side towards it (a slide: beyond its sides): near, where it has a twin */
    DMI_MIRROR_COUNT = 11
};

/* One mirror through the part's middle, and those at its low and its high side along the normal. */
typedef struct dmi_mirror_look {
    float normal[3], middle[3], twins[2];
} dmi_mirror_look;

/* What the candidates of a part are seen with. They share most of their mirrors: each is looked into once. */
#define DMI_MIRROR_LOOKS 128
typedef struct dmi_mirror {
    const dmi_study* study;
    float centre[3]; /* of the part's box */
    dmi_mirror_look looks[DMI_MIRROR_LOOKS];
    uint32_t count;
} dmi_mirror;

void dmi_mirror_begin(const dmi_study* study, dmi_mirror* out);
/* Distances are means in diagonals of the part, at most a quarter. */
void dmi_mirror_evidence(dmi_mirror* mirror, const dmi_candidate* candidate, float out[DMI_MIRROR_COUNT]);

#endif
