/* Moves samples of a part along a joint and looks up how far they are from the body. Ranges that
 * are free are found by the same sweep as limits. */
#include "kinematics/limits/sweep.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define STOPPED 0.03f      /* share of the free points that must meet the body; by hand */
#define JAMMED 0.15f       /* share that no gap or thin shell explains; by hand */
#define TOUCH_CELLS 2.1f   /* cells of the body's grid; a point that is nearer touches the body at rest; by hand */
#define HIT_CELLS 0.9f     /* cells; a free point that is nearer has met the body; by hand */
#define LEAST_EXTENT 0.01f /* least extent along the axis, object sizes; by hand */
#define ROUND_TURNS 3      /* turns at which roundness is measured, a third of the points each … */
#define FIRST_ROUND 0.4f   /* … rad; by hand: no fraction of a turn … */
#define NEXT_ROUND 2.1f    /* … rad */

/* Writes the points' distances from a grid's samples at a value of the joint. */
static void distances_at(const dmi_sweep* s, float value, const dmi_distance_grid* grid, float out[DMI_SWEEP_POINTS]) {
    if (dmi_sweep_slides(s)) {
        dmi_batched_transform_distances(&s->moved, 1, 0, value, grid, out);
        return;
    }
    const float advance = s->joint->type == DM_JOINT_SCREW ? s->joint->pitch * value : 0;
    const dmi_circlef at = dmi_circle_atf(value);
    dmi_batched_transform_distances(&s->moved, at.cosine, at.sine, advance, grid, out);
}

/* Returns the share of the free points that are inside the body's cells at a value. */
static float blocked_share(const dmi_sweep* s, float value) {
    float distance[DMI_SWEEP_POINTS];
    distances_at(s, value, &s->analysis->body_grid, distance);
    const float limit = HIT_CELLS * s->analysis->body_grid.cell;
    int32_t hits = 0;
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) hits += s->free[i] & (distance[i] < limit);
    return s->free_count > 0 ? (float)hits / (float)s->free_count : 0;
}

void dmi_sweep_reach(const dmi_sweep* s, float step, int steps, float out[2]) {
    out[0] = out[1] = step * (float)steps;
    bool stopped = false;
    for (int i = 1; i <= steps; i++) {
        const float share = blocked_share(s, step * (float)i);
        if (!stopped && share > STOPPED) out[0] = step * (float)(i - 1), stopped = true;
        if (share <= JAMMED) continue;
        out[1] = step * (float)(i - 1);
        return;
    }
}

dmi_clearance dmi_sweep_clearance(const dmi_sweep* s, float value) {
    float distance[DMI_SWEEP_POINTS];
    distances_at(s, value, &s->analysis->body_grid, distance);
    dmi_clearance out = {.least = INFINITY};
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        out.mean += dmi_min(distance[i], s->analysis->diagonal) / DMI_SWEEP_POINTS;
        out.least = dmi_min(out.least, distance[i]);
    }
    return out;
}

float dmi_sweep_roundness(const dmi_sweep* s) {
    float mean = 0;
    for (uint32_t turn = 0; turn < ROUND_TURNS; turn++) {
        float distance[DMI_SWEEP_POINTS];
        distances_at(s, FIRST_ROUND + NEXT_ROUND * (float)turn, &s->analysis->part_grid, distance);
        for (uint32_t i = turn; i < DMI_SWEEP_POINTS; i += ROUND_TURNS) mean += distance[i] / DMI_SWEEP_POINTS;
    }
    return mean / s->analysis->diagonal;
}

void dmi_sweep_make(const dmi_part_analysis* analysis, const dm_joint* joint, dmi_sweep* out) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    dmi_copy3((const float[]){joint->origin.x, joint->origin.y, joint->origin.z}, out->origin);
    out->analysis = analysis;
    out->joint = joint;
    if (joint->type == DM_JOINT_PRISMATIC)
        dmi_batched_transform_prismatic(axis, analysis->points, DMI_SWEEP_POINTS, &out->moved);
    else
        dmi_batched_transform_revolute(axis, out->origin, analysis->points, DMI_SWEEP_POINTS, &out->moved);
    float low, high;
    dmi_extents_along((const float(*)[3])analysis->extreme_points, analysis->extreme_point_count, &axis, 1, &low,
                      &high);
    out->extent = dmi_max(high - low, LEAST_EXTENT);
    out->free_count = 0;
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        out->free[i] = dmi_distance_grid_distance(&analysis->body_grid, analysis->points[i]) >
                       TOUCH_CELLS * analysis->body_grid.cell;
        out->free_count += out->free[i];
    }
}

/* ---- range that is free ---- */

#define SLIDE_EXTENTS 1.2f /* extents of the part that a slide is swept; by hand */

dmi_free_range dmi_free_range_of(const dmi_part_analysis* analysis, const dm_joint* joint) {
    dmi_sweep sweep;
    dmi_free_range out = dmi_unbounded_range();
    dmi_sweep_make(analysis, joint, &sweep);
    const bool slides = dmi_sweep_slides(&sweep);
    const float step = slides ? SLIDE_EXTENTS * sweep.extent / DMI_SWEEP_SLIDES : DMI_SWEEP_TURN;
    const int steps = slides ? DMI_SWEEP_SLIDES : DMI_SWEEP_TURNS;
    float up[2], down[2]; /* values where the part is stopped, and where it is jammed */
    dmi_sweep_reach(&sweep, step, steps, up);
    dmi_sweep_reach(&sweep, -step, steps, down);
    if (up[1] < step * (float)steps) out.upper = up[1];
    if (down[1] > -step * (float)steps) out.lower = down[1];
    return out;
}
