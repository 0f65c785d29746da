/* Two passes over the recorded rays for each hypothesis: the first accumulates the Gauss-Newton step of the axis line,
 * the second measures the shifted line, which is kept when it is clearly more probable. */
#include "drag/joint_hypothesis.h"

#include <math.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define ACTIVE_EVERY 3       /* rounds: the active hypothesis is shown, so it is refined more often; by hand */
#define SHIFT_DEVIATION 0.1f /* standard deviation of a shift, share of the part's size; fitted */
/* Log odds that a line is exactly where geometry has it; a surer joint has more; fitted. */
#define EXACT_LINE_LOG_ODDS 1.6f
#define MIN_RAYS 4          /* recorded rays that determine a line's place; by hand */
#define SHIFT_MARGIN 0.4f   /* log ratio by which a shifted line must be more probable; fitted */
#define WAITING_BONUS 0.05f /* log likelihood that a hypothesis may gain in a round without refinement; fitted */

void dmi_axis_refiner_init(dmi_axis_refiner* refiner) {
    *refiner = (dmi_axis_refiner){.hypothesis = DMI_NO_HYPOTHESIS};
}

void dmi_axis_refiner_add(dmi_axis_refiner* refiner, uint32_t index, const dmi_joint_hypothesis* hypothesis) {
    refiner->priority[index] = dmi_joint_turns(hypothesis->joint.type) ? hypothesis->log_prior : -INFINITY;
}

static void origin_at(const dmi_joint_hypothesis* hypothesis, const dmi_pull_fit* fit, const float shift[2],
                      dm_vec3* out) {
    float at[3];
    for (int i = 0; i < 3; i++) {
        const float way = fit->size * (shift[0] * fit->outward[i] + shift[1] * fit->forward[i]);
        at[i] = dmi_clamp_within(hypothesis->initial_origin[i] + way, DMI_LARGEST);
    }
    *out = dmi_vec3(at);
}

/* Returns the negative log prior of a shift: a normal law of its length, and the odds that geometry was exact. */
static float cost_of_shift(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, const dmi_pull_fit* fit,
                           const float shift[2]) {
    dm_joint initial = hypothesis->joint, there = hypothesis->joint;
    initial.origin = dmi_vec3(hypothesis->initial_origin);
    origin_at(hypothesis, fit, shift, &there.origin);
    const float far = (shift[0] * shift[0] + shift[1] * shift[1]) / (2 * SHIFT_DEVIATION * SHIFT_DEVIATION);
    return EXACT_LINE_LOG_ODDS + dmi_fmaxf(dmi_joint_log_odds(&hypothesis->joint), 0) + far +
           dmi_lever_arm_log_prior(grasp, &initial) - dmi_lever_arm_log_prior(grasp, &there);
}

/* Solves the 2x2 normal equations of residuals and shift prior together (Gauss-Newton with a ridge). */
static void best_shift(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, const dmi_pull_fit* fit,
                       float out[2]) {
    const float expected = dmi_expected_residual(grasp);
    const float ridge = expected * expected / (SHIFT_DEVIATION * SHIFT_DEVIATION);
    const float a = fit->hessian[0] + ridge, b = fit->hessian[1], c = fit->hessian[2] + ridge;
    const float p = fit->gradient[0] + ridge * hypothesis->shift[0];
    const float q = fit->gradient[1] + ridge * hypothesis->shift[1];
    const float det = a * c - b * b;
    out[0] = hypothesis->shift[0] + (b * q - c * p) / det;
    out[1] = hypothesis->shift[1] + (b * p - a * q) / det;
}

/* Begins a pass at the first recorded ray. */
static void start_pass(dmi_axis_refiner* refiner, const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis) {
    dmi_pull_fit* fit = &refiner->fit;
    dm_joint initial = hypothesis->joint;
    initial.origin = dmi_vec3(hypothesis->initial_origin);
    *fit = (dmi_pull_fit){.joint = hypothesis->joint, .size = grasp->size};
    dmi_pull_fit_shift_directions(&initial, grasp->pull.grab, fit->outward, fit->forward);
    if (refiner->shifted) origin_at(hypothesis, fit, refiner->shift, &fit->joint.origin);
    dmi_joint_hypothesis_range(grasp, hypothesis, &fit->lower, &fit->upper);
    refiner->thinned = grasp->pull.thinned;
}

/* Returns the turn of highest priority that is not active. */
static uint32_t highest_priority(const dmi_axis_refiner* refiner, uint32_t count, uint32_t best) {
    uint32_t found = DMI_NO_HYPOTHESIS;
    float most = -INFINITY;
    for (uint32_t i = 0; i < count; i++)
        if (refiner->priority[i] > most && i != best) most = refiner->priority[i], found = i;
    return found;
}

static void choose_hypothesis(dmi_axis_refiner* refiner, const dmi_grasp* grasp, const dmi_joint_hypothesis* hypotheses,
                              uint32_t count, uint32_t best) {
    const bool active = refiner->rounds++ % ACTIVE_EVERY == 0 && dmi_joint_turns(hypotheses[best].joint.type);
    refiner->hypothesis = active ? best : highest_priority(refiner, count, best);
    refiner->shifted = false;
    if (refiner->hypothesis != DMI_NO_HYPOTHESIS) start_pass(refiner, grasp, &hypotheses[refiner->hypothesis]);
}

/* Begins the second pass after the first: residuals of the shifted line are measured, not extrapolated. Returns false
 * when the shifted line would not be more probable even without any residual. */
static bool try_shift(dmi_axis_refiner* refiner, const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis) {
    if (refiner->shifted || refiner->fit.count < MIN_RAYS) return false;
    best_shift(grasp, hypothesis, &refiner->fit, refiner->shift);
    if (!isfinite(refiner->shift[0]) || !isfinite(refiner->shift[1])) return false;
    refiner->shift_cost = cost_of_shift(grasp, hypothesis, &refiner->fit, refiner->shift);
    refiner->unshifted_log_posterior =
        dmi_joint_hypothesis_log_likelihood(grasp, hypothesis, refiner->fit.max_residual) - hypothesis->shift_cost;
    if (!(-refiner->shift_cost > refiner->unshifted_log_posterior + SHIFT_MARGIN)) return false;
    refiner->shifted = true;
    start_pass(refiner, grasp, hypothesis);
    return true;
}

/* Adopts the shifted line if it is clearly more probable. */
static bool adopt_shift(const dmi_axis_refiner* refiner, const dmi_grasp* grasp, dmi_joint_hypothesis* hypothesis) {
    const float after =
        dmi_joint_hypothesis_log_likelihood(grasp, hypothesis, refiner->fit.max_residual) - refiner->shift_cost;
    if (!refiner->shifted || !(after > refiner->unshifted_log_posterior + SHIFT_MARGIN)) return false;
    hypothesis->joint.origin = refiner->fit.joint.origin;
    dmi_joint_hypothesis_find_path(grasp, hypothesis);
    hypothesis->shift[0] = refiner->shift[0], hypothesis->shift[1] = refiner->shift[1];
    hypothesis->shift_cost = refiner->shift_cost;
    hypothesis->max_residual = refiner->fit.max_residual;
    hypothesis->pointer_value = refiner->fit.pointer_value;
    hypothesis->log_posterior = hypothesis->log_prior + after +
                                dmi_joint_hypothesis_side_log_prior(grasp, hypothesis, hypothesis->pointer_value);
    return true;
}

uint32_t dmi_axis_refiner_step(dmi_axis_refiner* refiner, const dmi_grasp* grasp, dmi_joint_hypothesis* hypotheses,
                               uint32_t count, uint32_t best) {
    if (refiner->hypothesis == DMI_NO_HYPOTHESIS) choose_hypothesis(refiner, grasp, hypotheses, count, best);
    if (refiner->hypothesis == DMI_NO_HYPOTHESIS) return DMI_NO_HYPOTHESIS;
    dmi_joint_hypothesis* hypothesis = &hypotheses[refiner->hypothesis];
    if (refiner->thinned != grasp->pull.thinned) start_pass(refiner, grasp, hypothesis);
    if (refiner->fit.count < grasp->pull.count) dmi_pull_fit_step(&refiner->fit, &grasp->pull);
    if (refiner->fit.count < grasp->pull.count || try_shift(refiner, grasp, hypothesis)) return DMI_NO_HYPOTHESIS;
    const uint32_t fitted = refiner->hypothesis;
    const bool moved = adopt_shift(refiner, grasp, hypothesis);
    refiner->priority[fitted] = hypothesis->log_posterior - WAITING_BONUS * (float)refiner->rounds;
    refiner->hypothesis = DMI_NO_HYPOTHESIS;
    return moved ? fitted : DMI_NO_HYPOTHESIS;
}
