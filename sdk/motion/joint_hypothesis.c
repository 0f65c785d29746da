/* A joint's odds before the pull, its range, and its likelihood as it follows the pointer. */
#include "motion/joint_hypothesis.h"

#include <math.h>
#include <stdbool.h>

#include "math/linear3.h"
#include "math/vec3.h"

#define ONE_TURN 6.28318531f
#define SPREAD 0.01f     /* of the pull: how far off the right path a good hand goes */
#define TREMOR 0.0015f   /* of the part's size: and how far it is off at the start */
#define FALL 3.5f        /* how good the hand is, nobody knows: misses count by their ratio, to this power */
#define STRAIGHT (-4.5f) /* log of how probable it is that a hand goes straight to where a turn should end */
#define CLEARLY 3.0f     /* more probable, log: the other does not count */
#define LEAST_PRIOR 1e-3f
#define GOOD_ARM 0.15f      /* of the part's size: nobody turns a part by a point much nearer to its axis … */
#define LEAST_ARM 0.05f     /* … of that; but a hand may land there */
#define REST_SHARE 0.05f    /* of the range: so near to rest, a limit is a stop at rest */
#define SAME_COSINE 0.9998f /* of two axes, 20 mrad */
#define SAME_DISTANCE 0.02f /* of the part's size */

/* ---- before the pull ---- */

/* The side of rest that a range which begins there lies on. */
static float side_of(const dm_joint* joint) {
    if (!dmi_joint_has_limits(joint)) return 0;
    const float near = REST_SHARE * (joint->upper - joint->lower);
    return fabsf(joint->lower) <= near ? 1.0f : fabsf(joint->upper) <= near ? -1.0f : 0;
}

static float distance_to_line(const float point[3], const dm_joint* joint) {
    return dmi_line_distance3(point, dmi_xyz(joint->axis).v, dmi_xyz(joint->origin).v);
}

bool dmi_hypothesis_tracker_alike(const dm_joint* a, const dm_joint* b, float size) {
    const float cosine = fabsf(a->axis.x * b->axis.x + a->axis.y * b->axis.y + a->axis.z * b->axis.z);
    if (a->type != b->type || cosine < SAME_COSINE) return false;
    return a->type == DM_JOINT_PRISMATIC || distance_to_line(dmi_xyz(b->origin).v, a) < SAME_DISTANCE * size;
}

/* Odds: confidences are each hypothesis's own, they do not share one whole. */
float dmi_joint_hypothesis_odds(const dm_joint* joint) {
    const float p = fminf(fmaxf(joint->confidence, LEAST_PRIOR), 1 - LEAST_PRIOR);
    return logf(p / (1 - p));
}

/* What speaks against a turn by the place where the part was taken hold of: about an axis close by, any small pull is
 * explained, by a large turn. The root of the share: small parts do turn about points close by. */
float dmi_joint_hypothesis_arm_cost(const dmi_hold* hold, const dm_joint* joint) {
    if (!dmi_joint_turns(joint->type)) return 0;
    const float arm = distance_to_line(hold->pull.grab, joint) / (GOOD_ARM * hold->size);
    return 0.5f * logf(fminf(fmaxf(arm, LEAST_ARM), 1));
}

dmi_joint_hypothesis dmi_joint_hypothesis_make(const dmi_hold* hold, const dm_joint* joint, float odds, int open) {
    const float prior = odds + dmi_joint_hypothesis_arm_cost(hold, joint);
    return (dmi_joint_hypothesis){.joint = *joint,
                                  .home = {joint->origin.x, joint->origin.y, joint->origin.z},
                                  .side = side_of(joint),
                                  .open = open,
                                  .prior = prior,
                                  .score = prior};
}

/* ---- where it may be ---- */

void dmi_hypothesis_tracker_limits(const dm_joint* joint, dmi_give give, float* out_lower, float* out_upper) {
    *out_lower = -INFINITY, *out_upper = INFINITY;
    if (!dmi_joint_has_limits(joint)) return;
    const float range = joint->upper - joint->lower, near = REST_SHARE * range;
    const float most = dmi_joint_turns(joint->type) ? ONE_TURN : give.length;
    const float more = give.share == 0 ? most : fmaxf(give.share, 0) * range;
    *out_lower = fabsf(joint->lower) <= near ? joint->lower : joint->lower - more;
    *out_upper = fabsf(joint->upper) <= near ? joint->upper : joint->upper + more;
}

void dmi_joint_hypothesis_range(const dmi_hold* hold, const dmi_joint_hypothesis* rival, float* out_lower,
                                float* out_upper) {
    dmi_hypothesis_tracker_limits(&rival->joint, hold->give, out_lower, out_upper);
    if (side_of(&rival->joint) == 0 || rival->settled) return;
    *out_upper = fmaxf(-*out_lower, *out_upper), *out_lower = -*out_upper;
}

bool dmi_joint_hypothesis_is_held(const dmi_joint_hypothesis* rival, float wish) {
    const float side = side_of(&rival->joint);
    return side != 0 && rival->settled && side * wish <= 0;
}

/* Most slides rest at an end of their range, most turns that are hard to find do not: those stay free. */
static void give_range(dmi_joint_hypothesis* rival, float size) {
    dm_joint* joint = &rival->joint;
    rival->open = 0;
    if (joint->type == DM_JOINT_PRISMATIC) {
        joint->lower = rival->reach < 0 ? -size : 0;
        joint->upper = rival->reach < 0 ? 0 : size;
        return;
    }
    joint->type = DM_JOINT_CONTINUOUS;
    joint->lower = -0.5f * ONE_TURN, joint->upper = 0.5f * ONE_TURN;
}

bool dmi_joint_hypothesis_take_side(dmi_joint_hypothesis* rival, float size) {
    dm_joint* joint = &rival->joint;
    if (rival->open) give_range(rival, size);
    if (!(side_of(joint) * rival->reach < 0)) return false;
    const float lower = joint->lower;
    joint->lower = -joint->upper, joint->upper = -lower;
    return true;
}

/* ---- what the pull says ---- */

float dmi_hand_off(const dmi_hold* hold) {
    return SPREAD * hold->pull.length + TREMOR * hold->size;
}

/* Log likelihood of being so far off. It counts how far that was at most, as a share of the pull by now: a slide
 * crosses the arc of a hinge, and explains it where it does; what a hand did wrong at the start fades. The tail is that
 * of a hand of unknown skill: where no joint is met well, a near one is little better than a farther one. Fitted to
 * drags of generated objects (docs/trials_drag.md). */
static float met(const dmi_hold* hold, float off) {
    return -FALL * logf(1 + off / dmi_hand_off(hold));
}

/* Log likelihood of a pull that a joint misses by so much. Some hands don't follow a part round, they go straight to
 * where it should be: no turn misses a straight pull that its circle goes round. */
float dmi_joint_hypothesis_explains(const dmi_hold* hold, const dmi_joint_hypothesis* rival, float off) {
    const float followed = met(hold, off);
    if (followed > STRAIGHT + CLEARLY || !dmi_joint_turns(rival->joint.type)) return followed;
    const float straight = STRAIGHT + met(hold, hold->pull.bend);
    if (followed > straight + CLEARLY || !dmi_pull_cuts_corner(&hold->pull, &rival->joint)) return followed;
    const float more = fmaxf(followed, straight);
    return more + logf(expf(followed - more) + expf(straight - more));
}

float dmi_joint_hypothesis_side_cost(const dmi_joint_hypothesis* rival, float side) {
    return rival->side * side < 0 ? DMI_OTHER_SIDE : 0;
}

static void score(const dmi_hold* hold, dmi_joint_hypothesis* rival, const dm_ray* ray) {
    const float now = side_of(&rival->joint);
    float point[3];
    dmi_joint_move(&rival->joint, rival->reach, hold->pull.grab, point);
    rival->worst = fmaxf(rival->worst, dmi_pull_miss(&hold->pull, ray, point));
    rival->score = rival->prior - rival->lean + dmi_joint_hypothesis_side_cost(rival, rival->reach) +
                   dmi_joint_hypothesis_explains(hold, rival, rival->worst);
    rival->stop_score = rival->score;
    if (now * rival->reach >= 0) return;
    rival->stop_score = rival->prior - rival->lean + dmi_joint_hypothesis_side_cost(rival, now) +
                        dmi_joint_hypothesis_explains(hold, rival, dmi_pull_miss(&hold->pull, ray, hold->pull.grab));
}

void dmi_joint_hypothesis_weigh(const dmi_hold* hold, dmi_joint_hypothesis* rival, const dm_ray* ray) {
    const dmi_pull* pull = &hold->pull;
    float lower, upper;
    dmi_joint_hypothesis_range(hold, rival, &lower, &upper);
    rival->reach = dmi_follow_ray_roughly(&rival->joint, pull->grab, ray, pull->projection, rival->reach, lower, upper);
    score(hold, rival, ray);
}

/* Followed already, unless a stop at rest holds it, which it may not have; a drawer that was pulled out and
 * is pushed back has it. */
void dmi_joint_hypothesis_weigh_best(const dmi_hold* hold, dmi_joint_hypothesis* best, float wish, const dm_ray* ray) {
    const float range = best->joint.upper - best->joint.lower, side = side_of(&best->joint);
    best->settled |= side * wish > REST_SHARE * range;
    if (side != 0 && !best->settled) {
        dmi_joint_hypothesis_weigh(hold, best, ray);
        return;
    }
    best->reach = wish;
    if (dmi_joint_hypothesis_is_held(best, wish)) return;
    score(hold, best, ray);
}
