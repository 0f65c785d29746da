/* Scheduling of hypothesis updates, and the switch to another joint. */
#include "drag/hypothesis_tracker.h"

#include <math.h>

#include "drag/joint_hypothesis.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define MIN_PULL 0.006f /* share of the part's size: a shorter pull carries no information; fitted */
/* Log odds of a slide along an object axis that inference did not propose; fitted. */
#define FALLBACK_SLIDE_LOG_ODDS (-6.5f)
#define UNKNOWN_RANGE_LOG_ODDS (-0.35f) /* log odds of a joint without an inferred range; fitted */
#define UPDATED_PER_RAY 3               /* hypotheses beside the active one; by hand, for a microsecond an update */
#define REFINE_INTERVAL 2               /* updates between two steps of the axis refinement; by hand */
#define WAITING_BONUS 0.05f /* log likelihood that a hypothesis may gain in a round without update; fitted */
/* Log odds against the active hypothesis; one below them is left out of its probability; by hand. */
#define NEGLIGIBLE_LOG_ODDS (-7.0f)
#define SMALLEST_POSTERIOR 1e-4f /* posteriors are clamped to [this, 1 - this]; by hand */
#define UPRIGHT_COSINE 0.98f     /* cosine of a slide and the up direction, 11 degrees; by hand */
#define NEVER_WAITS 1e9f         /* a priority above all others */
#define TYPE_MARGIN 0.35f        /* how much more probable one of another type must be; fitted */
#define SWITCH_MARGIN 0.4f       /* log ratio by which another joint must be more probable; fitted */

/* Line that maps log odds among the tracked hypotheses to log odds of being right: one for a straight pull, one for a
 * pull that bends. Slopes and offsets are fitted (docs/research/trials_drag.md). The upper bound is set by hand,
 * because no straight pull makes a joint certain. */
static const struct { float slope, offset, most; } calibration[2] = {{0.43f, 1.17f, 3.0f}, {0.55f, 2.1f, 4.6f}};

static bool is_known(const dmi_hypothesis_tracker* tracker, const dm_joint* joint) {
    for (uint32_t i = 0; i < tracker->count; i++) {
        if (dmi_joints_alike(&tracker->list[i].joint, joint, tracker->grasp.size)) return true;
    }
    return false;
}

static void add_hypothesis(dmi_hypothesis_tracker* tracker, const dm_joint* joint, float log_odds, bool range_unknown,
                           dmi_free_range free_range) {
    if (tracker->count == DMI_TRACKED_HYPOTHESES || joint->type == DM_JOINT_FIXED || is_known(tracker, joint)) return;
    const uint32_t index = tracker->count++;
    tracker->list[index] = dmi_joint_hypothesis_make(&tracker->grasp, joint, log_odds, range_unknown, free_range);
    tracker->priority[index] = tracker->list[index].log_prior;
    dmi_axis_refiner_add(&tracker->refiner, index, &tracker->list[index]);
}

void dmi_hypothesis_tracker_add_alternative(dmi_hypothesis_tracker* tracker, const dm_joint* joint,
                                            dmi_free_range free_range) {
    dm_joint unlimited = *joint;
    unlimited.lower = unlimited.upper = 0;
    add_hypothesis(tracker, &unlimited, dmi_joint_log_odds(joint) + UNKNOWN_RANGE_LOG_ODDS, true, free_range);
}

void dmi_hypothesis_tracker_add_slide(dmi_hypothesis_tracker* tracker, dm_vec3 axis, dmi_free_range free_range) {
    const float size = tracker->grasp.size;
    float origin[3];
    for (int i = 0; i < 3; i++) origin[i] = dmi_clamp_within(tracker->grasp.pull.grab[i], DMI_LARGEST);
    const dm_joint slide = {.type = DM_JOINT_PRISMATIC,
                            .axis = axis,
                            .origin = dmi_vec3(origin),
                            .lower = dmi_fmaxf(-size, free_range.lower),
                            .upper = dmi_fminf(size, free_range.upper),
                            .source = DM_JOINT_FROM_GEOMETRY};
    if (slide.lower < slide.upper) add_hypothesis(tracker, &slide, FALLBACK_SLIDE_LOG_ODDS, false, free_range);
}

void dmi_hypothesis_tracker_init(dmi_hypothesis_tracker* tracker, const dm_joint* joints,
                                 const dmi_free_range* free_ranges, uint32_t count, const float grab_point[3],
                                 float size, dmi_limit_give limit_give) {
    *tracker = (dmi_hypothesis_tracker){.grasp = {.size = size, .limit_give = limit_give}};
    dmi_axis_refiner_init(&tracker->refiner);
    dmi_pull_begin(&tracker->grasp.pull, grab_point, MIN_PULL * size);
    for (uint32_t i = 0; i < count && i < DM_MAX_HYPOTHESES; i++)
        add_hypothesis(tracker, &joints[i], dmi_joint_log_odds(&joints[i]), false,
                       free_ranges != NULL ? free_ranges[i] : dmi_unbounded_range());
    tracker->list[0].grabbed = tracker->count > 0;
}

void dmi_hypothesis_tracker_set_up(dmi_hypothesis_tracker* tracker, const float up[3]) {
    for (uint32_t i = 0; i < tracker->count; i++) {
        dmi_joint_hypothesis* one = &tracker->list[i];
        one->upright =
            one->joint.type == DM_JOINT_PRISMATIC && fabsf(dmi_dot3(dmi_xyz(one->joint.axis).v, up)) > UPRIGHT_COSINE;
    }
}

/* Finds the hypotheses of highest priority but the active one, highest first. */
static uint32_t highest_priority(const dmi_hypothesis_tracker* tracker, uint32_t out[UPDATED_PER_RAY]) {
    uint32_t found = 0;
    float least = -INFINITY; /* priority that a further one must exceed */
    for (uint32_t i = 0; i < tracker->count; i++) {
        const float priority = tracker->priority[i];
        if (!(priority > least) || i == tracker->best) continue; /* a NaN is skipped too */
        uint32_t at = found < UPDATED_PER_RAY ? found++ : found - 1;
        for (; at > 0 && tracker->priority[out[at - 1]] < priority; at--) out[at] = out[at - 1];
        out[at] = i;
        if (found == UPDATED_PER_RAY) least = tracker->priority[out[found - 1]];
    }
    return found;
}

/* Sets the priority of an updated hypothesis. Every waiting one gains WAITING_BONUS a round, so the updated one loses
 * the bonus of the rounds so far instead. The joint of the grab never waits, because a pull that has left it may come
 * back to it. */
static void set_priority(dmi_hypothesis_tracker* tracker, uint32_t updated) {
    const dmi_joint_hypothesis* one = &tracker->list[updated];
    tracker->priority[updated] =
        one->grabbed ? NEVER_WAITS : one->log_posterior - WAITING_BONUS * (float)tracker->round;
}

/* Updates some hypotheses and returns the most probable of them and the active one. */
static uint32_t update_some(dmi_hypothesis_tracker* tracker, const dm_ray* ray) {
    uint32_t some[UPDATED_PER_RAY] = {0}, winner = tracker->best;
    const uint32_t count = highest_priority(tracker, some);
    set_priority(tracker, tracker->best);
    for (uint32_t i = 0; i < count; i++) {
        dmi_joint_hypothesis_update(&tracker->grasp, &tracker->list[some[i]], ray);
        set_priority(tracker, some[i]);
        if (tracker->list[some[i]].log_posterior > tracker->list[winner].log_posterior) winner = some[i];
    }
    return winner;
}

/* Returns true when another hypothesis, or the other side of rest, is active now. */
static bool switch_to_best(dmi_hypothesis_tracker* tracker, float pointer_value, const dm_ray* ray) {
    dmi_joint_hypothesis* best = &tracker->list[tracker->best];
    const float at_stop = dmi_joint_hypothesis_update_active(&tracker->grasp, best, pointer_value, ray);
    const float needed = at_stop + SWITCH_MARGIN;
    const uint32_t winner = update_some(tracker, ray);
    const bool same_type = dmi_joint_turns(tracker->list[winner].joint.type) == dmi_joint_turns(best->joint.type);
    if (tracker->list[winner].log_posterior <= needed + (same_type ? 0 : TYPE_MARGIN)) return false;
    const bool changed = winner != tracker->best;
    tracker->best = winner;
    return dmi_joint_hypothesis_adopt_side(&tracker->list[winner], tracker->grasp.size) || changed;
}

/* Returns true when the axis line of the active hypothesis has changed. A straight pull does not show where a line is:
 * a hand that goes straight misses the circle of the right one too. */
static bool refine_axes(dmi_hypothesis_tracker* tracker) {
    if (tracker->round % REFINE_INTERVAL != 0 || dmi_grasp_is_straight(&tracker->grasp)) return false;
    const uint32_t moved =
        dmi_axis_refiner_step(&tracker->refiner, &tracker->grasp, tracker->list, tracker->count, tracker->best);
    if (moved != DMI_NO_HYPOTHESIS) set_priority(tracker, moved);
    return moved == tracker->best;
}

/* ---- confidence ---- */

/* Returns the posterior probability of the active hypothesis, or of all of its type, among those tracked. */
static float posterior_of_active(const dmi_hypothesis_tracker* tracker, bool type_alone) {
    const dmi_joint_hypothesis* best = &tracker->list[tracker->best];
    float sum = 1, own = 1; /* sums of odds against the active one */
    for (uint32_t i = 0; i < tracker->count; i++) {
        const dmi_joint_hypothesis* one = &tracker->list[i];
        const float apart = one->log_posterior - best->log_posterior;
        if (i == tracker->best || apart < NEGLIGIBLE_LOG_ODDS) continue;
        const float odds = dmi_expf(dmi_fminf(apart, -NEGLIGIBLE_LOG_ODDS));
        sum += odds;
        if (type_alone && dmi_joint_turns(one->joint.type) == dmi_joint_turns(best->joint.type)) own += odds;
    }
    return own / sum;
}

/* Returns the probability that an answer with the posterior p among those tracked is right. "None of these" has a share
 * that grows with what the pull leaves open. */
static float calibrate_posterior(const dmi_hypothesis_tracker* tracker, float p) {
    const float kept = dmi_fminf(dmi_fmaxf(p, SMALLEST_POSTERIOR), 1 - SMALLEST_POSTERIOR);
    const int bends = !dmi_grasp_is_straight(&tracker->grasp);
    const float log_odds = calibration[bends].slope * dmi_logf(kept / (1 - kept)) + calibration[bends].offset;
    return 1 / (1 + dmi_expf(-dmi_fminf(log_odds, calibration[bends].most)));
}

float dmi_hypothesis_tracker_confidence(const dmi_hypothesis_tracker* tracker) {
    return calibrate_posterior(tracker, posterior_of_active(tracker, false));
}

float dmi_hypothesis_tracker_type_confidence(const dmi_hypothesis_tracker* tracker) {
    return dmi_fmaxf(calibrate_posterior(tracker, posterior_of_active(tracker, true)), tracker->confidence);
}

/* ---- update ---- */

/* Follows one ray that the pull has taken in. Returns true when another joint, side of rest or axis line is active. */
static bool follow_ray(dmi_hypothesis_tracker* tracker, float pointer_value, const dm_ray* ray) {
    const dmi_pull* pull = &tracker->grasp.pull;
    if (switch_to_best(tracker, pointer_value, ray)) return true;
    dmi_joint_hypothesis* best = &tracker->list[tracker->best];
    if (dmi_joint_hypothesis_is_pushed_shut(best, best->pointer_value) || !refine_axes(tracker)) return false;
    float lower, upper;
    dmi_joint_hypothesis_range(&tracker->grasp, best, &lower, &upper);
    best->pointer_value = dmi_follow_ray(&best->joint, pull->grab, ray, pull->projection, pointer_value, lower, upper);
    return true;
}

bool dmi_hypothesis_tracker_update(dmi_hypothesis_tracker* tracker, float pointer_value, const dm_ray* ray,
                                   dmi_projection projection) {
    if (tracker->count == 0) return false;
    tracker->grasp.pull.projection = projection;
    dmi_grasp_add(&tracker->grasp, ray);
    if (tracker->grasp.pull.length < MIN_PULL * tracker->grasp.size) return false;
    tracker->round++;
    const bool changed = follow_ray(tracker, pointer_value, ray);
    tracker->confidence = dmi_hypothesis_tracker_confidence(tracker);
    return changed;
}
