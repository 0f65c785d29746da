/* One joint that a dragged part may move by: where it may be, how it follows the pointer, and how well it explains the
 * pull. */
#ifndef DMI_MOTION_JOINT_HYPOTHESIS_H
#define DMI_MOTION_JOINT_HYPOTHESIS_H

#include <stdbool.h>

#include "motion/drag_fit.h"

#define DMI_OTHER_SIDE (-0.2f) /* log of how probable it is that a range lies on the other side of rest */

/* How far a pull takes a part beyond limits that were only estimated. */
typedef struct dmi_give {
    float share;  /* of the range; 0: as far as it is pulled … */
    float length; /* … up to this along a slide, and up to a turn */
} dmi_give;

/* What all rivals have in common: the part in the hand. */
typedef struct dmi_hold {
    dmi_pull pull;
    float size; /* of the part */
    dmi_give give;
} dmi_hold;

typedef struct dmi_joint_hypothesis {
    dm_joint joint;   /* host object frame */
    float home[3];    /* the origin that it came with; the pull may have shifted it … */
    float shift[2];   /* … by so much (drag_fit.h), … */
    float lean;       /* … which costs so much, log */
    float side;       /* of rest that its range was found on, +1 or -1; 0: both */
    int open;         /* nothing is known of its range */
    int settled;      /* the part has gone out on that side: rest is its stop */
    float prior;      /* log of its probability before the pull, up to a constant */
    float score;      /* the same after it */
    float reach;      /* the value the pointer asks of it, on whichever side */
    float worst;      /* how far it has missed the pull, at most */
    float stop_score; /* were it held by the stop at rest that its joint has */
} dmi_joint_hypothesis;

/* Log odds that a joint states itself. */
float dmi_joint_hypothesis_odds(const dm_joint* joint);
/* What speaks against a turn by the place where the part was taken hold of, log. */
float dmi_joint_hypothesis_arm_cost(const dmi_hold* hold, const dm_joint* joint);
/* odds: of the joint, before it is known where the part was taken hold of. */
dmi_joint_hypothesis dmi_joint_hypothesis_make(const dmi_hold* hold, const dm_joint* joint, float odds, int open);
/* So alike that no pull would tell them apart. */
bool dmi_hypothesis_tracker_alike(const dm_joint* a, const dm_joint* b, float size);

/* Where the pull may take a joint that the library found: a stop at rest is a stop, but how far a part opens was only
 * estimated. Infinite without limits. */
void dmi_hypothesis_tracker_limits(const dm_joint* joint, dmi_give give, float* out_lower, float* out_upper);
/* Where a rival may be, on either side of rest as long as it has not gone out on one. */
void dmi_joint_hypothesis_range(const dmi_hold* hold, const dmi_joint_hypothesis* rival, float* out_lower,
                                float* out_upper);
/* What a stop holds back tells nothing of the joint. */
bool dmi_joint_hypothesis_is_held(const dmi_joint_hypothesis* rival, float wish);

/* Log likelihood of a pull that a rival misses by so much, and of the side of rest that it goes to. */
float dmi_joint_hypothesis_explains(const dmi_hold* hold, const dmi_joint_hypothesis* rival, float off);
float dmi_joint_hypothesis_side_cost(const dmi_joint_hypothesis* rival, float side);
/* How far off a hand is anyway, by now. */
float dmi_hand_off(const dmi_hold* hold);

/* Follows one more ray, and weighs what it misses. */
void dmi_joint_hypothesis_weigh(const dmi_hold* hold, dmi_joint_hypothesis* rival, const dm_ray* ray);
/* The same of the one in force, which asks for `wish` on its side of rest: it is followed already. */
void dmi_joint_hypothesis_weigh_best(const dmi_hold* hold, dmi_joint_hypothesis* best, float wish, const dm_ray* ray);
/* Gives the joint the side of rest that the pull goes to; 1: it had the other. */
bool dmi_joint_hypothesis_take_side(dmi_joint_hypothesis* rival, float size);

#endif
