/* Finds limits by a sweep of the part's samples through the body's distance grid. The limit networks read it, or rules
 * do without them. */
#include "kinematics/limits/limits.h"

#include "kinematics/limits/sweep.h"
#include "math/elementary.h"
#include "math/joint.h"

#define ROUND 0.02f      /* diagonals; a turned part whose mean distance from itself is less is round; by hand */
#define ROUND_CELLS 0.5f /* cells of the part's grid, added to that; by hand */
#define UNSTOPPED 3.1f   /* rad either way of a part that nothing stops; by hand */
#define USUAL_OPENING DMI_HALF_PI_F /* rad: a quarter turn; by hand */
#define USUAL_TRAVEL 0.8f           /* extents of the part along a slide: drawers stay on their runners; by hand */
#define AWAY_SHARE 0.2f             /* share of the sweep over which the way away from the body is measured; by hand */
#define AWAY_WEIGHT 4               /* weight of that way, in diagonals, against room, in sweeps; by hand */

static bool is_round(const dmi_sweep* s) {
    return dmi_sweep_roundness(s) < ROUND + ROUND_CELLS * s->analysis->part_grid.cell / s->analysis->diagonal;
}

static void limit_turn(const dmi_sweep* s, dm_joint* joint) {
    float up[2], down[2];
    dmi_sweep_reach(s, DMI_SWEEP_TURN, DMI_SWEEP_TURNS, up);
    dmi_sweep_reach(s, -DMI_SWEEP_TURN, DMI_SWEEP_TURNS, down);
    if (up[0] >= UNSTOPPED && down[0] <= -UNSTOPPED && joint->type == DM_JOINT_REVOLUTE && is_round(s)) {
        joint->type = DM_JOINT_CONTINUOUS;
        joint->lower = -DMI_PI_F, joint->upper = DMI_PI_F;
        return;
    }
    /* The part is assumed to rest closed, and to open to the side with more room. */
    joint->upper = up[0] >= -down[0] ? dmi_fminf(up[0], USUAL_OPENING) : 0;
    joint->lower = up[0] >= -down[0] ? 0 : dmi_fmaxf(down[0], -USUAL_OPENING);
    if (joint->upper - joint->lower < DMI_SWEEP_TURN) joint->upper = USUAL_OPENING, joint->lower = 0;
}

static void limit_slide(const dmi_sweep* s, dm_joint* joint) {
    float most = USUAL_TRAVEL * s->extent, step = most / DMI_SWEEP_SLIDES, up[2], down[2];
    dmi_sweep_reach(s, step, DMI_SWEEP_SLIDES, up);
    dmi_sweep_reach(s, -step, DMI_SWEEP_SLIDES, down);
    joint->upper = up[0] >= -down[0] ? up[0] : 0;
    joint->lower = up[0] >= -down[0] ? 0 : down[0];
    if (joint->upper - joint->lower < step) joint->upper = most, joint->lower = 0;
}

void dmi_limits_face_room(const dmi_part_analysis* analysis, dm_joint* joint) {
    dmi_sweep s;
    dmi_sweep_make(analysis, joint, &s);
    const bool slides = dmi_sweep_slides(&s);
    const int steps = slides ? DMI_SWEEP_SLIDES : DMI_SWEEP_TURNS;
    const float step = slides ? s.extent / DMI_SWEEP_SLIDES : DMI_SWEEP_TURN;
    float up[2], down[2];
    dmi_sweep_reach(&s, step, steps, up);
    dmi_sweep_reach(&s, -step, steps, down);
    /* The way that leads away from the body decides also where the sweep meets nothing on either side. */
    const float room = (up[0] + up[1] + down[0] + down[1]) / (step * (float)steps);
    const float value = AWAY_SHARE * step * (float)steps;
    const float away = dmi_sweep_clearance(&s, value).mean - dmi_sweep_clearance(&s, -value).mean;
    if (room + AWAY_WEIGHT * away / analysis->diagonal < 0) dmi_joint_reverse(joint);
}

static void set_by_rules(const dmi_part_analysis* analysis, dm_joint* joint) {
    dmi_sweep s;
    dmi_sweep_make(analysis, joint, &s);
    if (dmi_sweep_slides(&s))
        limit_slide(&s, joint);
    else
        limit_turn(&s, joint);
}

static void take_prediction(const dmi_limit_prediction* prediction, float unit, dm_joint* joint) {
    if (joint->type == DM_JOINT_REVOLUTE && prediction->free > 0) {
        joint->type = DM_JOINT_CONTINUOUS;
        joint->lower = -DMI_PI_F, joint->upper = DMI_PI_F;
        return;
    }
    joint->lower = unit * prediction->lower, joint->upper = unit * prediction->upper;
}

/* Sets limits by the networks. Hides the candidate features of slides from them: with these they overfit to the travel
 * of buttons in each generated category (docs/research/decisions.md, 39). */
static void set_by_networks(const dmi_part_analysis* analysis, const dmi_prediction* prediction, int with_drag,
                            const dmi_limit_network* network, dmi_isa isa, const float* const* features,
                            dm_joint* joints, uint32_t count) {
    dmi_limit_query queries[DM_MAX_HYPOTHESES] = {0};
    dmi_limit_prediction predictions[DM_MAX_HYPOTHESES];
    float units[DM_MAX_HYPOTHESES];
    for (uint32_t i = 0; i < count; i++) {
        if (!with_drag) dmi_limits_face_room(analysis, &joints[i]);
        units[i] = dmi_limits_features(analysis, prediction, with_drag, &joints[i], queries[i].features);
        queries[i].dragged = with_drag != 0;
        queries[i].candidate = joints[i].type != DM_JOINT_PRISMATIC ? features[i] : NULL;
    }
    dmi_limit_network_predict(network, isa, queries, count, predictions);
    for (uint32_t i = 0; i < count; i++) take_prediction(&predictions[i], units[i], &joints[i]);
}

void dmi_limits_set(const dmi_part_analysis* analysis, const dmi_prediction* prediction, int with_drag,
                    const dmi_limit_network* network, dmi_isa isa, const float* const* features, dm_joint* joints,
                    uint32_t count) {
    if (network != NULL)
        set_by_networks(analysis, prediction, with_drag, network, isa, features, joints, count);
    else
        for (uint32_t i = 0; i < count; i++) set_by_rules(analysis, &joints[i]);
    if (with_drag) return;
    for (uint32_t i = 0; i < count; i++)
        if (-joints[i].lower > joints[i].upper) dmi_joint_reverse(&joints[i]);
}
