/* One joint that a dragged part may move by: its reachable range, how it follows the pointer, and the log posterior
 * that the pull gives it. */
#ifndef DMI_DRAG_JOINT_HYPOTHESIS_H
#define DMI_DRAG_JOINT_HYPOTHESIS_H

#include <stdbool.h>

#include "drag/pull_fit.h"

/* Log probability that a range lies on the other side of rest than it was found on. Fitted
 * (docs/research/trials_drag.md). */
#define DMI_OTHER_SIDE_LOG_PRIOR (-0.2f)

/* How far a pull may take a part beyond limits that were only estimated. */
typedef struct dmi_limit_give {
    float share;  /* share of the range; 0: bounded by `length` or one turn alone; negative: not at all */
    float length; /* most that a slide may go beyond when share is 0, host units; a turn may go 2 pi */
} dmi_limit_give;

/* What all hypotheses of one drag share. */
typedef struct dmi_grasp {
    dmi_pull pull;
    float size; /* size of the part, host units */
    dmi_limit_give limit_give;
    bool was_open;      /* the part was away from rest when it was grabbed: the hand has seen how it moves */
    float straightness; /* log likelihood of the pull's bend in a hand that means to go straight; 0 or less */
    float way[3];       /* unit direction from the grabbed point to the pointer, as seen; zeros: none */
} dmi_grasp;

/* dmi_joint_hypothesis.rank of a joint that inference has not ranked. */
enum { DMI_UNRANKED = -1 };

typedef struct dmi_joint_hypothesis {
    dm_joint joint;          /* host object frame */
    float initial_origin[3]; /* origin before any shift by the pull */
    float curvature;         /* curvature of the grabbed point's path, 1 / host units; 0: a slide */
    float first_motion[3];   /* unit direction in which the joint moves the grabbed point at rest; zeros: it has none */
    float shift[2];          /* shift of the axis line from there, in part sizes (pull_fit.h) */
    float shift_cost;        /* negative log prior of that shift */
    float side;              /* side of rest on which its range was found: +1 or -1; 0: both */
    int8_t rank;             /* rank that inference gave it, 0 for the best; DMI_UNRANKED */
    bool upright;            /* a slide along the up direction */
    bool range_unknown;      /* inference found no range for it */
    bool grabbed;            /* it was in force when the part was grabbed */
    bool other_side_blocked; /* the part would penetrate its body on the other side of rest */
    dmi_free_range free_range; /* host units */
    float excursion[2];        /* farthest that the pull has asked for below rest, and above; 0 or more */
    float log_prior;           /* log probability before the pull, up to a constant */
    float log_posterior;       /* log probability after it, up to the same constant */
    float pointer_value;       /* joint value that the pointer asks for, on either side of rest */
    float max_residual;        /* largest distance of the grabbed point from the pointer so far, host units */
} dmi_joint_hypothesis;

/* Returns the log odds of the joint's stated confidence. */
float dmi_joint_log_odds(const dm_joint* joint);
/* Returns the log prior (0 or less) of a turn by the distance of its axis from the grabbed point; 0 for slides. */
float dmi_lever_arm_log_prior(const dmi_grasp* grasp, const dm_joint* joint);
/* Makes a hypothesis from a joint. log_odds: the joint's, before the grabbed point is taken into account. free_range:
 * values that are free for the joint. */
dmi_joint_hypothesis dmi_joint_hypothesis_make(const dmi_grasp* grasp, const dm_joint* joint, float log_odds,
                                               bool range_unknown, dmi_free_range free_range);
/* Returns whether two joints are so alike that no pull tells them apart. size: the part's. */
bool dmi_joints_alike(const dm_joint* a, const dm_joint* b, float size);

/* Computes the range that a pull may take an inferred joint to. A stop at rest holds. The far limit was estimated and
 * may be exceeded by `limit_give`. The range is infinite without limits. */
void dmi_joint_reachable_range(const dm_joint* joint, dmi_limit_give limit_give, float* out_lower, float* out_upper);
/* Does the same for a hypothesis, which is followed on both sides of rest: the hand may push against a stop, and the
 * side may have been inferred wrongly. A joint whose range is unknown stays in its free range. */
void dmi_joint_hypothesis_range(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, float* out_lower,
                                float* out_upper);
/* Whether the hand pushes the part against its stop at rest: it asks for a value on the other side, which is blocked.
 */
bool dmi_joint_hypothesis_is_pushed_shut(const dmi_joint_hypothesis* hypothesis, float pointer_value);

/* Finds first motion and curvature. Call it when a joint or an axis line has changed. */
void dmi_joint_hypothesis_find_path(const dmi_grasp* grasp, dmi_joint_hypothesis* hypothesis);
/* Returns the log prior that the pull asks for this value, which depends on its side of rest. */
float dmi_joint_hypothesis_side_log_prior(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, float value);
/* Follows one more ray and updates residual and posterior. Returns the log likelihood of the pull so far. */
float dmi_joint_hypothesis_update(const dmi_grasp* grasp, dmi_joint_hypothesis* hypothesis, const dm_ray* ray);
/* Does the same for the active hypothesis. Where it is not followed on both sides, it already follows at
 * `pointer_value`. Returns its log posterior if the stop at rest holds the part. */
float dmi_joint_hypothesis_update_active(const dmi_grasp* grasp, dmi_joint_hypothesis* active, float pointer_value,
                                         const dm_ray* ray);
/* Gives the joint the side of rest that the pull goes to. Returns true when it had the other. */
bool dmi_joint_hypothesis_adopt_side(dmi_joint_hypothesis* hypothesis, float size);

/* ---- hand_likelihood.c: how probable an update of the pull is on a hypothesis ---- */

/* Adds one more ray to the pull. */
void dmi_grasp_add(dmi_grasp* grasp, const dm_ray* ray);
/* Returns whether the pull bends so little that the hand may have meant a straight line. */
bool dmi_grasp_is_straight(const dmi_grasp* grasp);
/* Whether the pull can't tell this joint's value, nor anything against it: the part was grabbed on this joint, whose
 * first motion is seen end on. */
bool dmi_joint_hypothesis_is_end_on(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis);
/* Returns the residual that the right joint has with an unsteady pointer, host units. */
float dmi_expected_residual(const dmi_grasp* grasp);
/* Returns the log likelihood of a hand that follows the part exactly and misses it by this largest residual. */
float dmi_followed_log_likelihood(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, float residual);
/* Returns the log likelihood of the pull, summed over the ways in which a hand may pull. residual: the largest one. */
float dmi_joint_hypothesis_log_likelihood(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis,
                                          float residual);

/* ---- axis_refine.c: the line of an axis, where the pull shows it ---- */

#define DMI_TRACKED_HYPOTHESES 64 /* 8 ranked, 48 alternatives and 3 fallback slides fit */
#define DMI_NO_HYPOTHESIS UINT32_MAX

/* A hypothesis goes through the recorded rays with its axis line as it is, and then, if the step promises a higher
 * posterior, with the line shifted. */
typedef struct dmi_axis_refiner {
    dmi_pull_fit fit;
    uint32_t hypothesis; /* being refined; DMI_NO_HYPOTHESIS: none */
    uint32_t thinned;    /* the pull's `thinned` when the fit began */
    bool shifted;        /* second pass, with the shifted line */
    float shift[2];      /* the shift under test, in part sizes */
    float shift_cost;    /* negative log prior of that shift */
    float unshifted_log_posterior;
    /* Last log posterior plus a bonus for waiting; the highest is refined next. */
    float priority[DMI_TRACKED_HYPOTHESES];
    uint32_t rounds; /* hypotheses refined so far */
} dmi_axis_refiner;

void dmi_axis_refiner_init(dmi_axis_refiner* refiner);
/* Announces a new hypothesis. */
void dmi_axis_refiner_add(dmi_axis_refiner* refiner, uint32_t index, const dmi_joint_hypothesis* hypothesis);
/* Follows one recorded ray. Returns the hypothesis whose line has changed (its posterior is then up to date), mostly
 * DMI_NO_HYPOTHESIS. */
uint32_t dmi_axis_refiner_step(dmi_axis_refiner* refiner, const dmi_grasp* grasp, dmi_joint_hypothesis* hypotheses,
                               uint32_t count, uint32_t best);

#endif
