/* Prior, reachable range and posterior of one joint hypothesis.
 *
 * All numbers of the priors are fitted to scripted drags of generated objects
 * (docs/research/trials_drag.md), unless their comment says otherwise. */
#include "drag/joint_hypothesis.h"

#include <math.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define PUSH_LOG_PRIOR (-1.5f)      /* log prior of a hand that pushes a part against its stop; by hand */
#define EXCURSION_LOG_PRIOR (-4.0f) /* log prior of the side of rest to which the pull has gone less far; by hand */
#define JOSTLE_SHARE 0.15f          /* most travel of the grabbed point in a jostle, share of the part; fitted */
/* Multiple of the excess over a jostle that a pull must go to leave the stated side; fitted. */
#define LEAVE_RATIO 3.5f
#define RETURN_RATIO 0.5f /* multiple of the way that it left by, which brings it back to the stated side; fitted */
/* Share of the range of a turn, and then of a slide; a side of rest with less room is blocked. The range of a turn that
 * rests at its end does not fit on such a side; the ranges of slides are estimated less well. Both are set by hand. */
#define BLOCKED_TURN_SHARE 1.0f
#define BLOCKED_SLIDE_SHARE 0.25f
/* Exponent of the odds, because the confidences of one part's joints err together. */
#define CONFIDENCE_EXPONENT 0.85f
#define MIN_CONFIDENCE 1e-3f /* confidences are clamped to [this, 1 - this]; by hand */
#define GOOD_ARM 0.15f       /* distance of axis and grabbed point at full prior, share of the part; fitted */
#define MIN_ARM 0.05f        /* least share of GOOD_ARM that lowers the prior further; fitted */
#define REST_SHARE 0.05f     /* share of the range; a limit this near to rest is a stop at rest; by hand */
#define SAME_COSINE 0.9998f  /* cosine of two axes that count as alike, 20 mrad; by hand */
#define SAME_DISTANCE 0.02f  /* distance of two axis lines that count as alike, share of the part's size; by hand */

/* ---- prior ---- */

/* Returns the side of rest on which a range that begins at rest lies: +1 or -1; 0: on both. */
static float side_of(const dm_joint* joint) {
    if (!dmi_joint_has_limits(joint)) return 0;
    const float near = REST_SHARE * (joint->upper - joint->lower);
    return fabsf(joint->lower) <= near ? 1.0f : fabsf(joint->upper) <= near ? -1.0f : 0;
}

static float distance_to_line(const float point[3], const dm_joint* joint) {
    return dmi_line_distance3(point, dmi_xyz(joint->axis).v, dmi_xyz(joint->origin).v);
}

bool dmi_joints_alike(const dm_joint* a, const dm_joint* b, float size) {
    const float cosine = fabsf(a->axis.x * b->axis.x + a->axis.y * b->axis.y + a->axis.z * b->axis.z);
    if (a->type != b->type || cosine < SAME_COSINE) return false;
    return a->type == DM_JOINT_PRISMATIC || distance_to_line(dmi_xyz(b->origin).v, a) < SAME_DISTANCE * size;
}

/* The function works with odds, because the confidences of an object's hypotheses do not add up to 1. */
float dmi_joint_log_odds(const dm_joint* joint) {
    const float p = dmi_fminf(dmi_fmaxf(joint->joint_confidence, MIN_CONFIDENCE), 1 - MIN_CONFIDENCE);
    return CONFIDENCE_EXPONENT * dmi_logf(p / (1 - p));
}

/* A turn about an axis close to the grabbed point explains any small pull by a large angle, so it gets a lower prior.
 * The square root keeps small parts, which do turn about points close by. */
float dmi_lever_arm_log_prior(const dmi_grasp* grasp, const dm_joint* joint) {
    if (!dmi_joint_turns(joint->type)) return 0;
    const float arm = distance_to_line(grasp->pull.grab, joint) / (GOOD_ARM * grasp->size);
    return 0.5f * dmi_logf(dmi_fminf(dmi_fmaxf(arm, MIN_ARM), 1));
}

/* Returns whether a joint that rests at an end of its range has too little room on the other side of rest. */
static bool is_blocked(const dm_joint* joint, dmi_free_range free_range) {
    const float side = side_of(joint), room = side > 0 ? -free_range.lower : free_range.upper;
    const float share = dmi_joint_turns(joint->type) ? BLOCKED_TURN_SHARE : BLOCKED_SLIDE_SHARE;
    return side != 0 && room < share * (joint->upper - joint->lower);
}

void dmi_joint_hypothesis_find_path(const dmi_grasp* grasp, dmi_joint_hypothesis* hypothesis) {
    const dm_joint* joint = &hypothesis->joint;
    dmi_joint_velocity(joint, 0, grasp->pull.grab, hypothesis->first_motion);
    dmi_normalize3(hypothesis->first_motion);
    const float arm = dmi_fmaxf(distance_to_line(grasp->pull.grab, joint), MIN_ARM * GOOD_ARM * grasp->size);
    hypothesis->curvature = dmi_joint_turns(joint->type) ? 1 / arm : 0;
}

dmi_joint_hypothesis dmi_joint_hypothesis_make(const dmi_grasp* grasp, const dm_joint* joint, float log_odds,
                                               bool range_unknown, dmi_free_range free_range) {
    const float log_prior = log_odds + dmi_lever_arm_log_prior(grasp, joint);
    dmi_joint_hypothesis made = {.joint = *joint,
                                 .initial_origin = {joint->origin.x, joint->origin.y, joint->origin.z},
                                 .side = side_of(joint),
                                 .rank = DMI_UNRANKED,
                                 .range_unknown = range_unknown,
                                 .other_side_blocked = is_blocked(joint, free_range),
                                 .free_range = free_range,
                                 .log_prior = log_prior,
                                 .log_posterior = log_prior};
    dmi_joint_hypothesis_find_path(grasp, &made);
    return made;
}

/* ---- reachable range ---- */

void dmi_joint_reachable_range(const dm_joint* joint, dmi_limit_give limit_give, float* out_lower, float* out_upper) {
    *out_lower = -INFINITY, *out_upper = INFINITY;
    if (!dmi_joint_has_limits(joint)) return;
    const float range = joint->upper - joint->lower, near = REST_SHARE * range;
    const float most = dmi_joint_turns(joint->type) ? DMI_TWO_PI_F : limit_give.length;
    const float more = limit_give.share == 0 ? most : dmi_fmaxf(limit_give.share, 0) * range;
    const float far = dmi_joint_farthest(joint);
    *out_lower = fabsf(joint->lower - joint->closed) <= near ? joint->lower : dmi_fmaxf(joint->lower - more, -far);
    *out_upper = fabsf(joint->upper - joint->closed) <= near ? joint->upper : dmi_fminf(joint->upper + more, far);
}

void dmi_joint_hypothesis_range(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, float* out_lower,
                                float* out_upper) {
    if (hypothesis->range_unknown) {
        *out_lower = hypothesis->free_range.lower, *out_upper = hypothesis->free_range.upper;
        return;
    }
    if (hypothesis->joint.type == DM_JOINT_PRISMATIC && dmi_joint_hypothesis_is_end_on(grasp, hypothesis)) {
        *out_lower = hypothesis->joint.lower, *out_upper = hypothesis->joint.upper;
        return;
    }
    dmi_joint_reachable_range(&hypothesis->joint, grasp->limit_give, out_lower, out_upper);
    if (side_of(&hypothesis->joint) == 0) return;
    *out_upper = dmi_fmaxf(-*out_lower, *out_upper), *out_lower = -*out_upper;
}

bool dmi_joint_hypothesis_is_pushed_shut(const dmi_joint_hypothesis* hypothesis, float pointer_value) {
    return hypothesis->other_side_blocked && side_of(&hypothesis->joint) * pointer_value < 0;
}

/* Gives a joint of unknown range a range inside its free range: a slide begins at rest on the side of the pull, a turn
 * stays free. Most slides of the development set rest at an end of their range; most of its turns that are hard to
 * infer do not. */
static void set_default_range(dmi_joint_hypothesis* hypothesis, float size) {
    dm_joint* joint = &hypothesis->joint;
    const dmi_free_range free = hypothesis->free_range;
    hypothesis->range_unknown = false;
    if (joint->type == DM_JOINT_PRISMATIC) {
        joint->lower = hypothesis->pointer_value < 0 ? dmi_fmaxf(-size, free.lower) : 0;
        joint->upper = hypothesis->pointer_value < 0 ? 0 : dmi_fminf(size, free.upper);
        hypothesis->side = side_of(joint);
        hypothesis->other_side_blocked = is_blocked(joint, free);
        return;
    }
    const bool bounded = free.lower > -DMI_PI_F || free.upper < DMI_PI_F;
    joint->type = bounded ? DM_JOINT_REVOLUTE : DM_JOINT_CONTINUOUS;
    joint->lower = dmi_fmaxf(-DMI_PI_F, free.lower), joint->upper = dmi_fminf(DMI_PI_F, free.upper);
}

bool dmi_joint_hypothesis_adopt_side(dmi_joint_hypothesis* hypothesis, float size) {
    dm_joint* joint = &hypothesis->joint;
    if (hypothesis->range_unknown) set_default_range(hypothesis, size);
    if (!(side_of(joint) * hypothesis->pointer_value < 0) || hypothesis->other_side_blocked) return false;
    const float lower = joint->lower;
    joint->lower = -joint->upper, joint->upper = -lower;
    return true;
}

/* ---- posterior ---- */

/* Returns how far a pull must go to one side of rest to make it its side, after it went to the other by `excursion`. A
 * jostle is undone by as much. A part that was really opened on the stated side needs much more to leave it, because a
 * hand that shuts a part goes on beyond rest. */
static float distance_against(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, bool leaves) {
    const dm_joint* joint = &hypothesis->joint;
    const float excursion = hypothesis->excursion[hypothesis->side > 0 ? leaves : !leaves];
    if (!leaves) return RETURN_RATIO * excursion;
    const float arm = dmi_joint_turns(joint->type) ? distance_to_line(grasp->pull.grab, joint) : 1;
    const float opened = dmi_fmaxf(excursion - JOSTLE_SHARE * grasp->size / arm, 0);
    return excursion - opened + LEAVE_RATIO * opened;
}

/* The side that the pull went to most is its side. A joint may have been found on the wrong side of rest, where the
 * other is not blocked. */
float dmi_joint_hypothesis_side_log_prior(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, float value) {
    if (hypothesis->side == 0) return 0;
    if (dmi_joint_hypothesis_is_pushed_shut(hypothesis, value)) return PUSH_LOG_PRIOR;
    if (hypothesis->other_side_blocked) return 0;
    const bool leaves = hypothesis->side * value < 0;
    const float against = distance_against(grasp, hypothesis, leaves), back = against - fabsf(value);
    const float less = back > 0 ? EXCURSION_LOG_PRIOR * back / against : 0;
    return less + (leaves ? DMI_OTHER_SIDE_LOG_PRIOR : 0);
}

/* Returns the log likelihood of the pull so far. */
static float update_posterior(const dmi_grasp* grasp, dmi_joint_hypothesis* hypothesis, const dm_ray* ray) {
    const float value = hypothesis->pointer_value;
    float point[3];
    dmi_joint_move(&hypothesis->joint, value, grasp->pull.grab, point);
    hypothesis->excursion[value > 0] = dmi_fmaxf(hypothesis->excursion[value > 0], fabsf(value));
    hypothesis->max_residual = dmi_fmaxf(hypothesis->max_residual, dmi_pull_residual(&grasp->pull, ray, point));
    const float likelihood = dmi_joint_hypothesis_log_likelihood(grasp, hypothesis, hypothesis->max_residual);
    hypothesis->log_posterior = hypothesis->log_prior - hypothesis->shift_cost +
                                dmi_joint_hypothesis_side_log_prior(grasp, hypothesis, value) + likelihood;
    return likelihood;
}

/* Returns the log posterior if the stop at rest holds the part. likelihood: log, of the pull so far. */
static float log_posterior_at_stop(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, const dm_ray* ray,
                                   float likelihood) {
    if (side_of(&hypothesis->joint) * hypothesis->pointer_value >= 0 || hypothesis->other_side_blocked)
        return hypothesis->log_posterior;
    const float at_stop = dmi_pull_residual(&grasp->pull, ray, grasp->pull.grab);
    /* A part that is held goes along no chord. */
    const float missed = dmi_followed_log_likelihood(grasp, hypothesis, at_stop);
    return hypothesis->log_prior - hypothesis->shift_cost + dmi_fmaxf(missed, PUSH_LOG_PRIOR + likelihood);
}

float dmi_joint_hypothesis_update(const dmi_grasp* grasp, dmi_joint_hypothesis* hypothesis, const dm_ray* ray) {
    const dmi_pull* pull = &grasp->pull;
    float lower, upper;
    dmi_joint_hypothesis_range(grasp, hypothesis, &lower, &upper);
    hypothesis->pointer_value = dmi_follow_ray_coarse(&hypothesis->joint, pull->grab, ray, pull->projection,
                                                      hypothesis->pointer_value, lower, upper);
    return update_posterior(grasp, hypothesis, ray);
}

/* A joint that rests at an end of its range is followed on both sides as all others are. */
float dmi_joint_hypothesis_update_active(const dmi_grasp* grasp, dmi_joint_hypothesis* active, float pointer_value,
                                         const dm_ray* ray) {
    const bool both_sides = side_of(&active->joint) != 0;
    if (!both_sides) active->pointer_value = pointer_value;
    const float likelihood =
        both_sides ? dmi_joint_hypothesis_update(grasp, active, ray) : update_posterior(grasp, active, ray);
    return log_posterior_at_stop(grasp, active, ray, likelihood);
}
