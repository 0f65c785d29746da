/* What bears a part: pins, knuckles, sockets, rims and shells that lie on the axis of a candidate joint, on the part
 * and on the body. One of them may be chance, two in line on either side are a hinge. */
#ifndef DMI_FEATURES_AXIS_HARDWARE_H
#define DMI_FEATURES_AXIS_HARDWARE_H

#include "kinematics/candidates/candidates.h"

enum {
    DMI_HARDWARE_ROUND = 0,   /* 4: how many patches of the part turn about the axis (a slide: about a line along it),
                                how large the largest is; then of the body */
    DMI_HARDWARE_PAIR = 4,    /* the best pair of one of the part and one of the body that turn about the same line */
    DMI_HARDWARE_CENTRED = 5, /* 2: how many shells of the part, of the body, have their middle on the axis */
    DMI_HARDWARE_SPAN = 7,    /* 2: how far apart along the axis what lies on it is, of all kinds; of the contact */
    DMI_HARDWARE_CLOSE = 9,   /* share of the contact that lies close to the axis */
    DMI_HARDWARE_COUNT = 10
};

/* A slide has but the first five. Sizes are in diagonals of the part, at most 2; counts at most 6. */
void dmi_axis_hardware_features(const dmi_part_analysis* study, const dmi_candidate* candidate,
                                float out[DMI_HARDWARE_COUNT]);

#endif
