/* Rival joints of a dragged part: each follows the pointer on its own; what it can't follow speaks against it. */
#include "motion/drag_rivals.h"

#include <math.h>
#include <string.h>

#define ONE_TURN 6.28318531f
#define FIRST_PULL 0.006f  /* of the part's size: less tells nothing */
#define SPREAD 0.02f       /* of the pull: how far off the right path a hand goes */
#define TREMOR 0.003f      /* of the part's size: and how far it is off at the start */
#define TAIL 8.0f          /* hands err much now and then: a normal law near the path, a power law far from it */
#define OTHER_SIDE (-0.7f) /* log of how probable it is that a range lies on the other side of rest */
#define LEAST_PRIOR 1e-3f
#define LAST_RESORT (-5.0f) /* log odds of a slide along an axis that nothing speaks for */
#define GOOD_ARM 0.15f      /* of the part's size: nobody turns a part by a point much nearer to its axis … */
#define LEAST_ARM 0.05f     /* … of that; but a hand may land there */
#define AT_ONCE 2           /* rivals weighed an update, beside the best */
#define STALE 0.05f         /* how much likelier a rival may have become in each round that left it out, log */
#define REST_SHARE 0.05f    /* of the range: so near to rest, a limit is a stop at rest */
#define MARGIN 0.4f         /* how much more probable another joint must be, log */
#define SAME_COSINE 0.9998f /* of two axes, 20 mrad */
#define SAME_DISTANCE 0.02f /* of the part's size */

/* The side of rest that a range which begins there lies on. */
static float side_of(const dm_joint* joint) {
    if (!dmi_joint_has_limits(joint)) return 0;
    const float near = REST_SHARE * (joint->upper - joint->lower);
    return fabsf(joint->lower) <= near ? 1.0f : fabsf(joint->upper) <= near ? -1.0f : 0;
}

static float distance_of_lines(const dm_joint* a, const dm_joint* b) {
    const float gap[3] = {b->origin.x - a->origin.x, b->origin.y - a->origin.y, b->origin.z - a->origin.z};
    const float axis[3] = {a->axis.x, a->axis.y, a->axis.z};
    float along = 0, square = 0;
    for (int i = 0; i < 3; i++) along += gap[i] * axis[i];
    for (int i = 0; i < 3; i++) square += (gap[i] - along * axis[i]) * (gap[i] - along * axis[i]);
    return sqrtf(square);
}

/* So alike that no pull would tell them apart. */
static int alike(const dm_joint* a, const dm_joint* b, float size) {
    const float cosine = fabsf(a->axis.x * b->axis.x + a->axis.y * b->axis.y + a->axis.z * b->axis.z);
    if (a->type != b->type || cosine < SAME_COSINE) return 0;
    return a->type == DM_JOINT_PRISMATIC || distance_of_lines(a, b) < SAME_DISTANCE * size;
}

static int known(const dmi_rivals* rivals, const dm_joint* joint) {
    for (uint32_t i = 0; i < rivals->count; i++) {
        if (alike(&rivals->list[i].joint, joint, rivals->size)) return 1;
    }
    return 0;
}

/* Odds: confidences are each hypothesis's own, they do not share one whole. */
static float prior_of(const dm_joint* joint) {
    const float p = fminf(fmaxf(joint->confidence, LEAST_PRIOR), 1 - LEAST_PRIOR);
    return logf(p / (1 - p));
}

/* What speaks against a turn by the place where the part was taken hold of: about an axis close by, any small pull is
 * explained, by a large turn. */
static float arm_cost(const dmi_rivals* rivals, const dm_joint* joint) {
    if (!dmi_joint_turns(joint->type)) return 0;
    const dm_joint grabbed = {.origin = {rivals->grab[0], rivals->grab[1], rivals->grab[2]}};
    const float arm = distance_of_lines(joint, &grabbed) / (GOOD_ARM * rivals->size);
    return logf(fminf(fmaxf(arm, LEAST_ARM), 1));
}

static void add(dmi_rivals* rivals, const dm_joint* joint, float prior, int open) {
    if (rivals->count == DMI_RIVALS || joint->type == DM_JOINT_FIXED || known(rivals, joint)) return;
    prior += arm_cost(rivals, joint);
    rivals->hope[rivals->count] = prior;
    rivals->list[rivals->count++] =
        (dmi_rival){.joint = *joint, .side = side_of(joint), .open = open, .prior = prior, .score = prior};
}

void dmi_rivals_add_alternative(dmi_rivals* rivals, const dm_joint* joint) {
    dm_joint unlimited = *joint;
    unlimited.lower = unlimited.upper = 0;
    add(rivals, &unlimited, prior_of(joint) + 0.5f * OTHER_SIDE, 1); /* the side may be either */
}

void dmi_rivals_init(dmi_rivals* rivals, const dm_joint* joints, uint32_t count, const float grab_point[3], float size,
                     dmi_give give) {
    *rivals = (dmi_rivals){.grab = {grab_point[0], grab_point[1], grab_point[2]}, .size = size, .give = give};
    for (uint32_t i = 0; i < count && i < DM_MAX_HYPOTHESES; i++) add(rivals, &joints[i], prior_of(&joints[i]), 0);
    if (rivals->count == 0) return;
    for (int i = 0; i < 3; i++) {
        const dm_joint slide = {.type = DM_JOINT_PRISMATIC,
                                .axis = {i == 0, i == 1, i == 2},
                                .origin = joints[0].origin,
                                .lower = -size,
                                .upper = size,
                                .source = DM_JOINT_FROM_GEOMETRY};
        add(rivals, &slide, LAST_RESORT, 0);
    }
}

void dmi_rivals_limits(const dm_joint* joint, dmi_give give, float* out_lower, float* out_upper) {
    *out_lower = -INFINITY, *out_upper = INFINITY;
    if (!dmi_joint_has_limits(joint)) return;
    const float range = joint->upper - joint->lower, near = REST_SHARE * range;
    const float most = dmi_joint_turns(joint->type) ? ONE_TURN : give.length;
    const float more = give.share == 0 ? most : fmaxf(give.share, 0) * range;
    *out_lower = fabsf(joint->lower) <= near ? joint->lower : joint->lower - more;
    *out_upper = fabsf(joint->upper) <= near ? joint->upper : joint->upper + more;
}

/* How far apart the ray and a point look, as a length where the grabbed point was at the start. */
static float miss(const dm_ray* ray, const float point[3], const float grab[3], dmi_projection projection) {
    const float d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    const float eye[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    float along = 0, square = 0, depth = 0;
    for (int i = 0; i < 3; i++) along += (point[i] - eye[i]) * d[i], depth += (grab[i] - eye[i]) * d[i];
    for (int i = 0; i < 3; i++) {
        const float across = point[i] - eye[i] - along * d[i];
        square += across * across;
    }
    if (projection == DMI_PARALLEL) return sqrtf(square);
    return along > 0 ? sqrtf(square) / along * fabsf(depth) : INFINITY;
}

/* Log likelihood of a pull that is so far off. It counts how far that was at most, as a share of the pull by now: a
 * slide crosses the arc of a hinge, and explains it where it does; what a hand did wrong at the start fades. */
static float explains(const dmi_rivals* rivals, float off) {
    const float share = off / (SPREAD * rivals->pull + TREMOR * rivals->size);
    return -TAIL * logf(1 + share * share / (2 * TAIL));
}

/* What speaks against a side. */
static float side_cost(const dmi_rival* rival, float side) {
    return rival->side * side < 0 ? OTHER_SIDE : 0;
}

static void score(const dmi_rivals* rivals, dmi_rival* rival, const float grab[3], const dm_ray* ray,
                  dmi_projection projection) {
    const dm_pose pose = dmi_joint_pose(&rival->joint, rival->reach);
    const float now = side_of(&rival->joint);
    float point[3];
    dmi_pose_apply(&pose, grab, point);
    rival->worst = fmaxf(rival->worst, miss(ray, point, grab, projection));
    rival->score = rival->prior + side_cost(rival, rival->reach) + explains(rivals, rival->worst);
    rival->stop_score = rival->score;
    if (now * rival->reach >= 0) return;
    rival->stop_score = rival->prior + side_cost(rival, now) + explains(rivals, miss(ray, grab, grab, projection));
}

static void weigh(const dmi_rivals* rivals, dmi_rival* rival, const float grab[3], const dm_ray* ray,
                  dmi_projection projection) {
    float lower, upper;
    dmi_rivals_limits(&rival->joint, rivals->give, &lower, &upper);
    if (side_of(&rival->joint) != 0 && !rival->settled) upper = fmaxf(-lower, upper), lower = -upper;
    rival->reach = dmi_follow_ray_roughly(&rival->joint, grab, ray, projection, rival->reach, lower, upper);
    score(rivals, rival, grab, ray, projection);
}

/* The best is followed already, unless a stop at rest holds it, which it may not have; a drawer that was pulled out and
 * is pushed back has it. */
static void weigh_best(const dmi_rivals* rivals, dmi_rival* best, float wish, const float grab[3], const dm_ray* ray,
                       dmi_projection projection) {
    const float range = best->joint.upper - best->joint.lower, side = side_of(&best->joint);
    best->settled |= side * wish > REST_SHARE * range;
    if (side != 0 && !best->settled) {
        weigh(rivals, best, grab, ray, projection);
        return;
    }
    best->reach = wish;
    if (side * wish <= 0 && best->settled) return; /* what a stop holds back tells nothing of the joint */
    score(rivals, best, grab, ray, projection);
}

/* Most slides rest at an end of their range, most turns that are hard to find do not: those stay free. */
static void give_range(dmi_rival* rival, float size) {
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

/* Gives a joint the side of rest that the pull goes to. */
static int take_side(dmi_rival* rival, float size) {
    dm_joint* joint = &rival->joint;
    if (rival->open) give_range(rival, size);
    if (!(side_of(joint) * rival->reach < 0)) return 0;
    const float lower = joint->lower;
    joint->lower = -joint->upper, joint->upper = -lower;
    return 1;
}

/* The likeliest rivals but the best, likeliest first; one that has waited long may have become likelier. */
static uint32_t likeliest(const dmi_rivals* rivals, uint32_t out[AT_ONCE]) {
    float first = -INFINITY, second = -INFINITY;
    uint32_t found = 0;
    for (uint32_t i = 0; i < rivals->count; i++) {
        const float hope = rivals->hope[i];
        if (!(hope > second) || i == rivals->best) continue;
        const int leads = hope > first;
        second = leads ? first : hope, out[1] = leads ? out[0] : i;
        first = leads ? hope : first, out[0] = leads ? i : out[0];
        found += found < AT_ONCE;
    }
    return found;
}

/* All that wait gain as much, so those that were weighed lose it instead. */
static void remember(dmi_rivals* rivals, uint32_t weighed) {
    rivals->hope[weighed] = rivals->list[weighed].score - STALE * (float)rivals->round;
}

/* The best of the one in force and of the likeliest others. */
static uint32_t weigh_some(dmi_rivals* rivals, const float grab[3], const dm_ray* ray, dmi_projection projection) {
    uint32_t some[AT_ONCE] = {0}, winner = rivals->best;
    const uint32_t count = likeliest(rivals, some);
    rivals->round++;
    remember(rivals, rivals->best);
    for (uint32_t i = 0; i < count; i++) {
        weigh(rivals, &rivals->list[some[i]], grab, ray, projection);
        remember(rivals, some[i]);
        if (rivals->list[some[i]].score > rivals->list[winner].score) winner = some[i];
    }
    return winner;
}

int dmi_rivals_weigh(dmi_rivals* rivals, const float grab_point[3], float wish, const dm_ray* ray,
                     dmi_projection projection) {
    const float pull = miss(ray, grab_point, grab_point, projection);
    if (isfinite(pull)) rivals->pull = fmaxf(rivals->pull, pull);
    if (rivals->count == 0 || rivals->pull < FIRST_PULL * rivals->size) return 0;
    dmi_rival* best = &rivals->list[rivals->best];
    weigh_best(rivals, best, wish, grab_point, ray, projection);
    const float needed = best->stop_score + MARGIN;
    const uint32_t winner = weigh_some(rivals, grab_point, ray, projection);
    if (rivals->list[winner].score <= needed) return 0;
    const int changed = winner != rivals->best;
    rivals->best = winner;
    return take_side(&rivals->list[winner], rivals->size) || changed;
}

float dmi_rivals_confidence(const dmi_rivals* rivals) {
    const float best = rivals->count ? rivals->list[rivals->best].score : 0;
    float sum = 0;
    for (uint32_t i = 0; i < rivals->count; i++) sum += expf(rivals->list[i].score - best);
    return sum > 0 ? 1 / sum : 1;
}
