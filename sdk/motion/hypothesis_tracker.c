/* Rival joints of a dragged part: the likeliest are weighed with every ray, and the best is in force. */
#include "motion/hypothesis_tracker.h"

#include <math.h>
#include <stdbool.h>

#define FIRST_PULL 0.006f   /* of the part's size: less tells nothing */
#define LAST_RESORT (-6.5f) /* log odds of a slide along an axis that nothing speaks for */
#define UNRANGED (-0.35f)   /* log odds of a joint whose range nobody has looked for */
#define AT_ONCE 3           /* rivals weighed an update, beside the best */
#define FIT_EVERY 2         /* updates: lines are fitted by one more of the remembered rays */
#define STALE 0.05f         /* how much likelier a rival may have become in each round that left it out, log */
#define MARGIN 0.4f         /* how much more probable another joint must be, log */

static bool known(const dmi_hypothesis_tracker* rivals, const dm_joint* joint) {
    for (uint32_t i = 0; i < rivals->count; i++) {
        if (dmi_hypothesis_tracker_alike(&rivals->list[i].joint, joint, rivals->hold.size)) return true;
    }
    return false;
}

static void add(dmi_hypothesis_tracker* rivals, const dm_joint* joint, float odds, int open) {
    if (rivals->count == DMI_TRACKED_HYPOTHESES || joint->type == DM_JOINT_FIXED || known(rivals, joint)) return;
    const uint32_t index = rivals->count++;
    rivals->list[index] = dmi_joint_hypothesis_make(&rivals->hold, joint, odds, open);
    rivals->hope[index] = rivals->list[index].prior;
    dmi_lines_add(&rivals->lines, index, &rivals->list[index]);
}

void dmi_hypothesis_tracker_add_alternative(dmi_hypothesis_tracker* rivals, const dm_joint* joint) {
    dm_joint unlimited = *joint;
    unlimited.lower = unlimited.upper = 0;
    add(rivals, &unlimited, dmi_joint_hypothesis_odds(joint) + UNRANGED, 1);
}

void dmi_hypothesis_tracker_init(dmi_hypothesis_tracker* rivals, const dm_joint* joints, uint32_t count,
                                 const float grab_point[3], float size, dmi_give give) {
    *rivals = (dmi_hypothesis_tracker){.hold = {.size = size, .give = give}};
    dmi_lines_begin(&rivals->lines);
    dmi_pull_begin(&rivals->hold.pull, grab_point, FIRST_PULL * size);
    for (uint32_t i = 0; i < count && i < DM_MAX_HYPOTHESES; i++)
        add(rivals, &joints[i], dmi_joint_hypothesis_odds(&joints[i]), 0);
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

/* The likeliest rivals but the best, likeliest first; one that has waited long may have become likelier. */
static uint32_t likeliest(const dmi_hypothesis_tracker* rivals, uint32_t out[AT_ONCE]) {
    uint32_t found = 0;
    for (uint32_t i = 0; i < rivals->count; i++) {
        const float hope = rivals->hope[i], least = found == AT_ONCE ? rivals->hope[out[found - 1]] : -INFINITY;
        if (!(hope > least) || i == rivals->best) continue; /* nor where it is no number */
        uint32_t at = found < AT_ONCE ? found++ : found - 1;
        for (; at > 0 && rivals->hope[out[at - 1]] < hope; at--) out[at] = out[at - 1];
        out[at] = i;
    }
    return found;
}

/* All that wait gain as much, so those that were weighed lose it instead. */
static void remember(dmi_hypothesis_tracker* rivals, uint32_t weighed) {
    rivals->hope[weighed] = rivals->list[weighed].score - STALE * (float)rivals->round;
}

/* The best of the one in force and of the likeliest others. */
static uint32_t weigh_some(dmi_hypothesis_tracker* rivals, const dm_ray* ray) {
    uint32_t some[AT_ONCE] = {0}, winner = rivals->best;
    const uint32_t count = likeliest(rivals, some);
    remember(rivals, rivals->best);
    for (uint32_t i = 0; i < count; i++) {
        dmi_joint_hypothesis_weigh(&rivals->hold, &rivals->list[some[i]], ray);
        remember(rivals, some[i]);
        if (rivals->list[some[i]].score > rivals->list[winner].score) winner = some[i];
    }
    return winner;
}

/* 1: another, or the other side, is the best now. */
static bool weigh_all(dmi_hypothesis_tracker* rivals, float wish, const dm_ray* ray) {
    dmi_joint_hypothesis* best = &rivals->list[rivals->best];
    dmi_joint_hypothesis_weigh_best(&rivals->hold, best, wish, ray);
    const float needed = best->stop_score + MARGIN;
    const uint32_t winner = weigh_some(rivals, ray);
    if (rivals->list[winner].score <= needed) return false;
    const bool changed = winner != rivals->best;
    rivals->best = winner;
    return dmi_joint_hypothesis_take_side(&rivals->list[winner], rivals->hold.size) || changed;
}

/* 1: the line of the best has become another. */
static bool fit_lines(dmi_hypothesis_tracker* rivals) {
    if (rivals->round % FIT_EVERY != 0) return false;
    const uint32_t moved = dmi_lines_fit(&rivals->lines, &rivals->hold, rivals->list, rivals->count, rivals->best);
    if (moved != DMI_NOBODY) remember(rivals, moved);
    return moved == rivals->best;
}

bool dmi_hypothesis_tracker_weigh(dmi_hypothesis_tracker* rivals, float wish, const dm_ray* ray,
                                  dmi_projection projection) {
    if (rivals->count == 0) return false;
    dmi_pull* pull = &rivals->hold.pull;
    pull->projection = projection;
    if (!dmi_joint_hypothesis_is_held(&rivals->list[rivals->best], wish)) dmi_pull_add(pull, ray);
    if (pull->length < FIRST_PULL * rivals->hold.size) return false;
    rivals->round++;
    if (weigh_all(rivals, wish, ray)) return true;
    dmi_joint_hypothesis* best = &rivals->list[rivals->best];
    if (dmi_joint_hypothesis_is_held(best, wish) || !fit_lines(rivals)) return false;
    float lower, upper;
    dmi_joint_hypothesis_range(&rivals->hold, best, &lower, &upper);
    best->reach = dmi_follow_ray(&best->joint, pull->grab, ray, projection, wish, lower, upper);
    return true;
}

float dmi_hypothesis_tracker_confidence(const dmi_hypothesis_tracker* rivals) {
    const float best = rivals->count ? rivals->list[rivals->best].score : 0;
    float sum = 0;
    for (uint32_t i = 0; i < rivals->count; i++) sum += expf(rivals->list[i].score - best);
    return sum > 0 ? 1 / sum : 1;
}
