/* Moves samples of a part along a joint and looks up how far they are from the body. Ranges that
 * are free are found by the same sweep as limits. */
#include "kinematics/limits/sweep.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define STOPPED 0.03f      /* share of the free points that must meet the body; by hand */
#define JAMMED 0.15f       /* share that no gap or thin shell explains; by hand */
#define LEAST_EXTENT 0.01f /* least extent along the axis, object sizes; by hand */
#define ROUND_TURNS 3      /* turns at which roundness is measured, a third of the points each … */
#define FIRST_ROUND 0.4f   /* … rad; by hand: no fraction of a turn … */
#define NEXT_ROUND 2.1f    /* … rad */

/* Returns the cosine and the sine of the joint's angle at a value. */
static dmi_circlef turn_at(const dmi_sweep* s, float value) {
    return dmi_sweep_slides(s) ? (dmi_circlef){.cosine = 1, .sine = 0} : dmi_circle_atf(value);
}

/* Returns the shift along the joint's axis at a value. */
static float shift_at(const dmi_sweep* s, float value) {
    if (dmi_sweep_slides(s)) return value;
    return s->joint->type == DM_JOINT_SCREW ? s->joint->pitch * value : 0;
}

/* Writes the points' distances from a grid's samples at a value of the joint. */
static void distances_at(const dmi_sweep* s, float value, const dmi_distance_grid* grid, float out[DMI_SWEEP_POINTS]) {
    const dmi_circlef turn = turn_at(s, value);
    dmi_batched_transform_distances(&s->moved, turn.cosine, turn.sine, shift_at(s, value), grid, out);
}

/* Returns the share of the free points that are in cells of the body's surface at a value. */
static float blocked_share(const dmi_sweep* s, float value) {
    int32_t meets[DMI_SWEEP_POINTS], hits = 0;
    const dmi_circlef turn = turn_at(s, value);
    dmi_batched_transform_meetings(&s->moved_free, turn.cosine, turn.sine, shift_at(s, value), &s->analysis->body_grid,
                                   meets);
    for (int32_t i = 0; i < s->free_count; i++) hits += meets[i];
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

static void carry(const dm_joint* joint, const float (*points)[3], uint32_t count, dmi_batched_transform* out) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    const float origin[3] = {joint->origin.x, joint->origin.y, joint->origin.z};
    if (joint->type == DM_JOINT_PRISMATIC)
        dmi_batched_transform_prismatic(axis, points, count, out);
    else
        dmi_batched_transform_revolute(axis, origin, points, count, out);
}

void dmi_sweep_make(const dmi_part_analysis* analysis, const dm_joint* joint, dmi_sweep* out) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    dmi_copy3((const float[]){joint->origin.x, joint->origin.y, joint->origin.z}, out->origin);
    out->analysis = analysis;
    out->joint = joint;
    float points[DMI_SWEEP_POINTS][3];
    out->free_count = (int32_t)dmi_put_free_points_first(&analysis->body_grid, (const float(*)[3])analysis->points,
                                                         DMI_SWEEP_POINTS, points);
    carry(joint, analysis->points, DMI_SWEEP_POINTS, &out->moved);
    carry(joint, (const float(*)[3])points, dmi_whole_batches((uint32_t)out->free_count), &out->moved_free);
    float low, high;
    dmi_extents_along((const float(*)[3])analysis->extreme_points, analysis->extreme_point_count, &axis, 1, &low,
                      &high);
    out->extent = dmi_max(high - low, LEAST_EXTENT);
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
