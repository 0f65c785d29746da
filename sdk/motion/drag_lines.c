/* A line goes through the remembered pull; shifted as one step of Gauss and Newton has it, it goes through it again,
 * and is taken when it explains the pull clearly better. */
#include "motion/drag_lines.h"

#include <math.h>
#include <stdbool.h>

#include "math/vec3.h"

#define FIT_BEST_EVERY 3 /* lines fitted: that of the best is shown, and it is what others are measured by */
#define SHIFT 0.1f       /* of the part's size: rivals that move the part less unlike each other are one */
#define UNSHIFTED 1.6f   /* log odds that a line is exactly where the geometry has it, and more for sure joints */
#define LEAST_RAYS 4     /* that tell a line's place */
#define MARGIN 0.4f      /* how much more probable another line must be, log */
#define STALE 0.05f      /* how much likelier a rival may have become in each fit that left it out, log */

void dmi_lines_begin(dmi_lines* lines) {
    *lines = (dmi_lines){.rival = DMI_NOBODY};
}

void dmi_lines_add(dmi_lines* lines, uint32_t index, const dmi_joint_hypothesis* rival) {
    lines->promise[index] = dmi_joint_turns(rival->joint.type) ? rival->prior : -INFINITY;
}

static void origin_at(const dmi_joint_hypothesis* rival, const dmi_fit* fit, const float shift[2], dm_vec3* out) {
    float at[3];
    for (int i = 0; i < 3; i++)
        at[i] = rival->home[i] + fit->size * (shift[0] * fit->outward[i] + shift[1] * fit->forward[i]);
    *out = dmi_vec3(at);
}

/* What a shift of the line costs: one that nothing in the geometry speaks for is rare, a far one rarer. */
static float lean_of(const dmi_hold* hold, const dmi_joint_hypothesis* rival, const dmi_fit* fit,
                     const float shift[2]) {
    dm_joint home = rival->joint, there = rival->joint;
    home.origin = dmi_vec3(rival->home);
    origin_at(rival, fit, shift, &there.origin);
    const float far = (shift[0] * shift[0] + shift[1] * shift[1]) / (2 * SHIFT * SHIFT);
    return UNSHIFTED + fmaxf(dmi_joint_hypothesis_odds(&rival->joint), 0) + far +
           dmi_joint_hypothesis_arm_cost(hold, &home) - dmi_joint_hypothesis_arm_cost(hold, &there);
}

/* The shift that would make the misses and itself least together, were they linear in it. */
static void best_shift(const dmi_hold* hold, const dmi_joint_hypothesis* rival, const dmi_fit* fit, float out[2]) {
    const float off = dmi_hand_off(hold);
    const float worth = off * off / (SHIFT * SHIFT);
    const float a = fit->curvature[0] + worth, b = fit->curvature[1], c = fit->curvature[2] + worth;
    const float p = fit->slope[0] + worth * rival->shift[0], q = fit->slope[1] + worth * rival->shift[1];
    const float det = a * c - b * b;
    out[0] = rival->shift[0] + (b * q - c * p) / det;
    out[1] = rival->shift[1] + (b * p - a * q) / det;
}

/* Back to the start of the pull. */
static void start_run(dmi_lines* lines, const dmi_hold* hold, const dmi_joint_hypothesis* rival) {
    dmi_fit* fit = &lines->fit;
    dm_joint home = rival->joint;
    home.origin = dmi_vec3(rival->home);
    *fit = (dmi_fit){.joint = rival->joint, .size = hold->size};
    dmi_fit_ways(&home, hold->pull.grab, fit->outward, fit->forward);
    if (lines->shifted) origin_at(rival, fit, lines->shift, &fit->joint.origin);
    dmi_joint_hypothesis_range(hold, rival, &fit->lower, &fit->upper);
    lines->thinned = hold->pull.thinned;
}

/* The turn that promises most of those not in force; nobody when there is none. */
static uint32_t most_promising(const dmi_lines* lines, uint32_t count, uint32_t best) {
    uint32_t found = DMI_NOBODY;
    float most = -INFINITY;
    for (uint32_t i = 0; i < count; i++)
        if (lines->promise[i] > most && i != best) most = lines->promise[i], found = i;
    return found;
}

static void choose(dmi_lines* lines, const dmi_hold* hold, const dmi_joint_hypothesis* rivals, uint32_t count,
                   uint32_t best) {
    const bool the_best = lines->fits++ % FIT_BEST_EVERY == 0 && dmi_joint_turns(rivals[best].joint.type);
    lines->rival = the_best ? best : most_promising(lines, count, best);
    lines->shifted = 0;
    if (lines->rival != DMI_NOBODY) start_run(lines, hold, &rivals[lines->rival]);
}

/* The line as it is has gone through the pull. Where it would be better, misses may not be linear any more: so that
 * line goes through it too. 0: even if it missed nothing, it would not be better. */
static bool try_shift(dmi_lines* lines, const dmi_hold* hold, const dmi_joint_hypothesis* rival) {
    if (lines->shifted || lines->fit.count < LEAST_RAYS) return false;
    best_shift(hold, rival, &lines->fit, lines->shift);
    if (!isfinite(lines->shift[0]) || !isfinite(lines->shift[1])) return false;
    lines->lean = lean_of(hold, rival, &lines->fit, lines->shift);
    lines->before = dmi_joint_hypothesis_explains(hold, rival, lines->fit.worst) - rival->lean;
    if (!(-lines->lean > lines->before + MARGIN)) return false;
    lines->shifted = 1;
    start_run(lines, hold, rival);
    return true;
}

/* Takes the line that was tried, if it is clearly better. */
static bool take_shift(const dmi_lines* lines, const dmi_hold* hold, dmi_joint_hypothesis* rival) {
    const float after = dmi_joint_hypothesis_explains(hold, rival, lines->fit.worst) - lines->lean;
    if (!lines->shifted || !(after > lines->before + MARGIN)) return false;
    rival->joint.origin = lines->fit.joint.origin;
    rival->shift[0] = lines->shift[0], rival->shift[1] = lines->shift[1];
    rival->lean = lines->lean;
    rival->worst = lines->fit.worst;
    rival->reach = lines->fit.reach;
    rival->score = rival->stop_score = rival->prior + after + dmi_joint_hypothesis_side_cost(rival, rival->reach);
    return true;
}

uint32_t dmi_lines_fit(dmi_lines* lines, const dmi_hold* hold, dmi_joint_hypothesis* rivals, uint32_t count,
                       uint32_t best) {
    if (lines->rival == DMI_NOBODY) choose(lines, hold, rivals, count, best);
    if (lines->rival == DMI_NOBODY) return DMI_NOBODY;
    dmi_joint_hypothesis* rival = &rivals[lines->rival];
    if (lines->thinned != hold->pull.thinned) start_run(lines, hold, rival);
    if (lines->fit.count < hold->pull.count) dmi_fit_follow(&lines->fit, &hold->pull);
    if (lines->fit.count < hold->pull.count || try_shift(lines, hold, rival)) return DMI_NOBODY;
    const uint32_t fitted = lines->rival;
    const int moved = take_shift(lines, hold, rival);
    lines->promise[fitted] = rival->score - STALE * (float)lines->fits;
    lines->rival = DMI_NOBODY;
    return moved ? fitted : DMI_NOBODY;
}
