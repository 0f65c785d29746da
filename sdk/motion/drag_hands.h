/* Hands other than one pointer: a hand in space, a scalar, and a second hand beside the first. */
#ifndef DMI_MOTION_DRAG_HANDS_H
#define DMI_MOTION_DRAG_HANDS_H

#include "motion/follow.h"
#include "motion/follow_point.h"

/* Number of eyes from which a hand in space is shown to the hypothesis tracker, in turn. The tracker knows only rays,
 * and from two sides no motion is end on in all. */
#define DMI_HAND_EYES 2

/* A second hand on the part. */
typedef struct dmi_second_hand {
    bool on;
    bool placed;         /* bias is known */
    float rest_point[3]; /* where it holds the part, with the part at rest */
    float value;         /* joint value that it asked for last, without the bias */
    float bias;          /* joint value that is added to what it asks for, so that it comes without a jump */
} dmi_second_hand;

typedef struct dmi_hands {
    int32_t kind;    /* DM_HAND_* of the last update; POINT: `point` holds */
    bool has_offset; /* offset is known */
    float offset[3]; /* vector from the hand in space to the point that it grabbed */
    float point[3];  /* place of the hand in space, with the offset added */
    float bias;      /* joint value that is added to what the first hand asks for, since a second one has gone */
    float pressed;   /* s for which a scalar has asked for more at an estimated limit; 0: it does not */
    uint32_t eye;    /* eye of the next ray that the hypothesis tracker gets from a hand in space */
    dmi_second_hand second;
} dmi_hands;

#endif
