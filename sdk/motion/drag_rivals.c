/* Rival joints of a dragged part: each follows the pointer on its own; what it can't follow speaks against it. */
#include "motion/drag_rivals.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"

#define ONE_TURN 6.28318531f
#define FIRST_PULL 0.006f  /* of the part's size: less tells nothing */
#define SPREAD 0.01f       /* of the pull: how far off the right path a good hand goes */
#define TREMOR 0.003f      /* of the part's size: and how far it is off at the start */
#define TAIL 2.0f          /* how good the hand is, nobody knows: far misses count by their ratio, not by their size */
#define STRAIGHT (-4.5f)   /* log of how probable it is that a hand goes straight to where a turn should end */
#define OTHER_SIDE (-0.7f) /* log of how probable it is that a range lies on the other side of rest */
#define CLEARLY 3.0f       /* more probable, log: the other does not count */
#define LEAST_PRIOR 1e-3f
#define LAST_RESORT (-5.0f) /* log odds of a slide along an axis that nothing speaks for */
#define GOOD_ARM 0.15f      /* of the part's size: nobody turns a part by a point much nearer to its axis … */
#define LEAST_ARM 0.05f     /* … of that; but a hand may land there */
#define AT_ONCE 2           /* rivals weighed an update, beside the best */
#define FIT_EVERY 2         /* updates: lines are fitted by one more of the remembered rays */
#define FIT_BEST_EVERY 3    /* lines fitted: that of the best is shown, and it is what others are measured by */
#define SHIFT 0.1f          /* of the part's size: rivals that move the part less unlike each other are one */
#define UNSHIFTED 1.0f      /* log odds that a line is exactly where the geometry has it, and more for sure joints */
#define LEAST_RAYS 4        /* that tell a line's place */
#define NOBODY UINT32_MAX
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
    const dm_joint grabbed = {.origin = {rivals->pull.grab[0], rivals->pull.grab[1], rivals->pull.grab[2]}};
    const float arm = distance_of_lines(joint, &grabbed) / (GOOD_ARM * rivals->size);
    return logf(fminf(fmaxf(arm, LEAST_ARM), 1));
}

static void add(dmi_rivals* rivals, const dm_joint* joint, float prior, int open) {
    if (rivals->count == DMI_RIVALS || joint->type == DM_JOINT_FIXED || known(rivals, joint)) return;
    prior += arm_cost(rivals, joint);
    rivals->hope[rivals->count] = prior;
    rivals->promise[rivals->count] = dmi_joint_turns(joint->type) ? prior : -INFINITY;
    rivals->list[rivals->count++] = (dmi_rival){.joint = *joint,
                                                .home = {joint->origin.x, joint->origin.y, joint->origin.z},
                                                .side = side_of(joint),
                                                .open = open,
                                                .prior = prior,
                                                .score = prior};
}

void dmi_rivals_add_alternative(dmi_rivals* rivals, const dm_joint* joint) {
    dm_joint unlimited = *joint;
    unlimited.lower = unlimited.upper = 0;
    add(rivals, &unlimited, prior_of(joint) + 0.5f * OTHER_SIDE, 1); /* the side may be either */
}

void dmi_rivals_init(dmi_rivals* rivals, const dm_joint* joints, uint32_t count, const float grab_point[3], float size,
                     dmi_give give) {
    *rivals = (dmi_rivals){.size = size, .give = give, .fitting = {.rival = NOBODY}};
    dmi_pull_begin(&rivals->pull, grab_point, FIRST_PULL * size);
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

/* Log likelihood of being so far off. It counts how far that was at most, as a share of the pull by now: a slide
 * crosses the arc of a hinge, and explains it where it does; what a hand did wrong at the start fades. The tail is that
 * of a hand of unknown skill: where no joint is met well, a near one is little better than a farther one. */
static float met(const dmi_rivals* rivals, float off) {
    const float share = off / (SPREAD * rivals->pull.length + TREMOR * rivals->size);
    return -TAIL * logf(1 + share * share / (2 * TAIL));
}

/* Log likelihood of a pull that a joint misses by so much. Some hands don't follow a part round, they go straight to
 * where it should be: no turn misses a straight pull that its circle goes round. */
static float explains(const dmi_rivals* rivals, const dmi_rival* rival, float off) {
    const float followed = met(rivals, off), straight = STRAIGHT + met(rivals, rivals->pull.bend);
    if (followed > straight + CLEARLY || !dmi_joint_turns(rival->joint.type)) return followed;
    if (!dmi_pull_cuts_corner(&rivals->pull, &rival->joint)) return followed;
    const float more = fmaxf(followed, straight);
    return more + logf(expf(followed - more) + expf(straight - more));
}

/* What speaks against a side. */
static float side_cost(const dmi_rival* rival, float side) {
    return rival->side * side < 0 ? OTHER_SIDE : 0;
}

static void score(const dmi_rivals* rivals, dmi_rival* rival, const dm_ray* ray) {
    const dm_pose pose = dmi_joint_pose(&rival->joint, rival->reach);
    const float now = side_of(&rival->joint);
    float point[3];
    dmi_pose_apply(&pose, rivals->pull.grab, point);
    rival->worst = fmaxf(rival->worst, dmi_pull_miss(&rivals->pull, ray, point));
    rival->score = rival->prior - rival->lean + side_cost(rival, rival->reach) + explains(rivals, rival, rival->worst);
    rival->stop_score = rival->score;
    if (now * rival->reach >= 0) return;
    rival->stop_score = rival->prior - rival->lean + side_cost(rival, now) +
                        explains(rivals, rival, dmi_pull_miss(&rivals->pull, ray, rivals->pull.grab));
}

/* Where it may be, on either side of rest as long as it has not gone out on one. */
static void range_of(const dmi_rivals* rivals, const dmi_rival* rival, float* out_lower, float* out_upper) {
    dmi_rivals_limits(&rival->joint, rivals->give, out_lower, out_upper);
    if (side_of(&rival->joint) == 0 || rival->settled) return;
    *out_upper = fmaxf(-*out_lower, *out_upper), *out_lower = -*out_upper;
}

static void weigh(const dmi_rivals* rivals, dmi_rival* rival, const dm_ray* ray) {
    const dmi_pull* pull = &rivals->pull;
    float lower, upper;
    range_of(rivals, rival, &lower, &upper);
    rival->reach = dmi_follow_ray_roughly(&rival->joint, pull->grab, ray, pull->projection, rival->reach, lower, upper);
    score(rivals, rival, ray);
}

/* What a stop holds back tells nothing of the joint. */
static int is_held(const dmi_rival* rival, float wish) {
    const float side = side_of(&rival->joint);
    return side != 0 && rival->settled && side * wish <= 0;
}

/* The best is followed already, unless a stop at rest holds it, which it may not have; a drawer that was pulled out and
 * is pushed back has it. */
static void weigh_best(const dmi_rivals* rivals, dmi_rival* best, float wish, const dm_ray* ray) {
    const float range = best->joint.upper - best->joint.lower, side = side_of(&best->joint);
    best->settled |= side * wish > REST_SHARE * range;
    if (side != 0 && !best->settled) {
        weigh(rivals, best, ray);
        return;
    }
    best->reach = wish;
    if (is_held(best, wish)) return;
    score(rivals, best, ray);
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
static uint32_t weigh_some(dmi_rivals* rivals, const dm_ray* ray) {
    uint32_t some[AT_ONCE] = {0}, winner = rivals->best;
    const uint32_t count = likeliest(rivals, some);
    remember(rivals, rivals->best);
    for (uint32_t i = 0; i < count; i++) {
        weigh(rivals, &rivals->list[some[i]], ray);
        remember(rivals, some[i]);
        if (rivals->list[some[i]].score > rivals->list[winner].score) winner = some[i];
    }
    return winner;
}

/* ---- lines ---- */

static void origin_at(const dmi_rival* rival, const dmi_fit* fit, const float shift[2], dm_vec3* out) {
    float at[3];
    for (int i = 0; i < 3; i++)
        at[i] = rival->home[i] + fit->size * (shift[0] * fit->outward[i] + shift[1] * fit->forward[i]);
    *out = dmi_vec3(at);
}

/* What a shift of the line costs: one that nothing in the geometry speaks for is rare, a far one rarer. */
static float lean_of(const dmi_rivals* rivals, const dmi_rival* rival, const dmi_fit* fit, const float shift[2]) {
    dm_joint home = rival->joint, there = rival->joint;
    home.origin = dmi_vec3(rival->home);
    origin_at(rival, fit, shift, &there.origin);
    const float far = (shift[0] * shift[0] + shift[1] * shift[1]) / (2 * SHIFT * SHIFT);
    return UNSHIFTED + fmaxf(prior_of(&rival->joint), 0) + far + arm_cost(rivals, &home) - arm_cost(rivals, &there);
}

/* The shift that would make the misses and itself least together, were they linear in it. */
static void best_shift(const dmi_rivals* rivals, const dmi_rival* rival, const dmi_fit* fit, float out[2]) {
    const float off = SPREAD * rivals->pull.length + TREMOR * rivals->size;
    const float worth = off * off / (SHIFT * SHIFT);
    const float a = fit->curvature[0] + worth, b = fit->curvature[1], c = fit->curvature[2] + worth;
    const float p = fit->slope[0] + worth * rival->shift[0], q = fit->slope[1] + worth * rival->shift[1];
    const float det = a * c - b * b;
    out[0] = rival->shift[0] + (b * q - c * p) / det;
    out[1] = rival->shift[1] + (b * p - a * q) / det;
}

/* Back to the start of the pull. */
static void start_run(const dmi_rivals* rivals, dmi_fitting* fitting) {
    const dmi_rival* rival = &rivals->list[fitting->rival];
    dmi_fit* fit = &fitting->fit;
    dm_joint home = rival->joint;
    home.origin = dmi_vec3(rival->home);
    *fit = (dmi_fit){.joint = rival->joint, .size = rivals->size};
    dmi_fit_ways(&home, rivals->pull.grab, fit->outward, fit->forward);
    if (fitting->shifted) origin_at(rival, fit, fitting->shift, &fit->joint.origin);
    range_of(rivals, rival, &fit->lower, &fit->upper);
    fitting->thinned = rivals->pull.thinned;
}

/* The turn that promises most of those not in force; nobody when there is none. */
static uint32_t most_promising(const dmi_rivals* rivals) {
    uint32_t found = NOBODY;
    float most = -INFINITY;
    for (uint32_t i = 0; i < rivals->count; i++)
        if (rivals->promise[i] > most && i != rivals->best) most = rivals->promise[i], found = i;
    return found;
}

static void begin_fitting(dmi_rivals* rivals) {
    dmi_fitting* fitting = &rivals->fitting;
    const int the_best = rivals->fits++ % FIT_BEST_EVERY == 0 && dmi_joint_turns(rivals->list[rivals->best].joint.type);
    *fitting = (dmi_fitting){.rival = the_best ? rivals->best : most_promising(rivals)};
    if (fitting->rival != NOBODY) start_run(rivals, fitting);
}

/* The line as it is has gone through the pull. Where it would be better, misses may not be linear any more: so that
 * line goes through it too. 0: even if it missed nothing, it would not be better. */
static int try_shift(const dmi_rivals* rivals, dmi_fitting* fitting) {
    const dmi_rival* rival = &rivals->list[fitting->rival];
    if (fitting->shifted || fitting->fit.count < LEAST_RAYS) return 0;
    best_shift(rivals, rival, &fitting->fit, fitting->shift);
    if (!isfinite(fitting->shift[0]) || !isfinite(fitting->shift[1])) return 0;
    fitting->lean = lean_of(rivals, rival, &fitting->fit, fitting->shift);
    fitting->before = explains(rivals, rival, fitting->fit.worst) - rival->lean;
    if (!(-fitting->lean > fitting->before + MARGIN)) return 0;
    fitting->shifted = 1;
    start_run(rivals, fitting);
    return 1;
}

/* Takes the line that was tried, if it is clearly better. */
static int take_shift(dmi_rivals* rivals, const dmi_fitting* fitting) {
    dmi_rival* rival = &rivals->list[fitting->rival];
    const float after = explains(rivals, rival, fitting->fit.worst) - fitting->lean;
    if (!fitting->shifted || !(after > fitting->before + MARGIN)) return 0;
    rival->joint.origin = fitting->fit.joint.origin;
    rival->shift[0] = fitting->shift[0], rival->shift[1] = fitting->shift[1];
    rival->lean = fitting->lean;
    rival->worst = fitting->fit.worst;
    rival->reach = fitting->fit.reach;
    rival->score = rival->stop_score = rival->prior + after + side_cost(rival, rival->reach);
    remember(rivals, fitting->rival);
    return 1;
}

/* One step of a line through the pull. 1: that of the best has become another. */
static int fit_line(dmi_rivals* rivals) {
    dmi_fitting* fitting = &rivals->fitting;
    if (fitting->rival == NOBODY) begin_fitting(rivals);
    if (fitting->rival == NOBODY) return 0;
    if (fitting->thinned != rivals->pull.thinned) start_run(rivals, fitting);
    if (fitting->fit.count < rivals->pull.count) dmi_fit_follow(&fitting->fit, &rivals->pull);
    if (fitting->fit.count < rivals->pull.count || try_shift(rivals, fitting)) return 0;
    const uint32_t fitted = fitting->rival;
    const int moved = take_shift(rivals, fitting);
    rivals->promise[fitted] = rivals->list[fitted].score - STALE * (float)rivals->fits;
    fitting->rival = NOBODY;
    return moved && fitted == rivals->best;
}

static int fits_now(const dmi_rivals* rivals) {
    return rivals->round % FIT_EVERY == 0;
}

/* 1: another, or the other side, is the best now. */
static int weigh_all(dmi_rivals* rivals, float wish, const dm_ray* ray) {
    dmi_rival* best = &rivals->list[rivals->best];
    weigh_best(rivals, best, wish, ray);
    const float needed = best->stop_score + MARGIN;
    const uint32_t winner = weigh_some(rivals, ray);
    if (rivals->list[winner].score <= needed) return 0;
    const int changed = winner != rivals->best;
    rivals->best = winner;
    return take_side(&rivals->list[winner], rivals->size) || changed;
}

int dmi_rivals_weigh(dmi_rivals* rivals, float wish, const dm_ray* ray, dmi_projection projection) {
    if (rivals->count == 0) return 0;
    rivals->pull.projection = projection;
    if (!is_held(&rivals->list[rivals->best], wish)) dmi_pull_add(&rivals->pull, ray);
    if (rivals->pull.length < FIRST_PULL * rivals->size) return 0;
    rivals->round++;
    if (weigh_all(rivals, wish, ray)) return 1;
    dmi_rival* best = &rivals->list[rivals->best];
    if (is_held(best, wish) || !fits_now(rivals) || !fit_line(rivals)) return 0;
    float lower, upper;
    range_of(rivals, best, &lower, &upper);
    best->reach = dmi_follow_ray(&best->joint, rivals->pull.grab, ray, projection, wish, lower, upper);
    return 1;
}

float dmi_rivals_confidence(const dmi_rivals* rivals) {
    const float best = rivals->count ? rivals->list[rivals->best].score : 0;
    float sum = 0;
    for (uint32_t i = 0; i < rivals->count; i++) sum += expf(rivals->list[i].score - best);
    return sum > 0 ? 1 / sum : 1;
}
