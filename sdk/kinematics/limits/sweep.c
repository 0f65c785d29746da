/* Moves samples of a part along a joint and looks up how far they are from the body. */
#include "kinematics/limits/sweep.h"

#include "math/linear3.h"

#define STOPPED 0.03f /* share of the free points that must meet the body */
#define JAMMED 0.15f  /* share that no gap or thin shell explains */

/* The points' distances from a field's samples at a value of the joint. */
static void distances_at(const dmi_sweep* s, float value, const dmi_distance_grid* field, float out[DMI_SWEEP_POINTS]) {
    if (dmi_sweep_slides(s)) {
        dmi_batched_transform_distances(&s->moved, 1, 0, value, field, out);
        return;
    }
    const float advance = s->joint->type == DM_JOINT_SCREW ? s->joint->pitch * value : 0;
    dmi_batched_transform_distances(&s->moved, cosf(value), sinf(value), advance, field, out);
}

/* Share of the free points that are inside the body's cells at a value. */
static float blocked(const dmi_sweep* s, float value) {
    float distance[DMI_SWEEP_POINTS];
    distances_at(s, value, &s->study->body_grid, distance);
    const float limit = 0.9f * s->study->body_grid.cell;
    int32_t hits = 0;
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) hits += s->free[i] & (distance[i] < limit);
    return s->free_count > 0 ? (float)hits / (float)s->free_count : 0;
}

void dmi_sweep_reach(const dmi_sweep* s, float step, int steps, float out[2]) {
    out[0] = out[1] = step * (float)steps;
    int stopped = 0;
    for (int i = 1; i <= steps; i++) {
        const float share = blocked(s, step * (float)i);
        if (!stopped && share > STOPPED) out[0] = step * (float)(i - 1), stopped = 1;
        if (share <= JAMMED) continue;
        out[1] = step * (float)(i - 1);
        return;
    }
}

dmi_clearance dmi_sweep_clearance(const dmi_sweep* s, float value) {
    float distance[DMI_SWEEP_POINTS];
    distances_at(s, value, &s->study->body_grid, distance);
    dmi_clearance out = {.least = INFINITY};
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        out.mean += dmi_min(distance[i], s->study->diagonal) / DMI_SWEEP_POINTS;
        out.least = dmi_min(out.least, distance[i]);
    }
    return out;
}

float dmi_sweep_roundness(const dmi_sweep* s) {
    float mean = 0;
    for (uint32_t turn = 0; turn < 3; turn++) {
        float distance[DMI_SWEEP_POINTS];
        distances_at(s, 0.4f + 2.1f * (float)turn, &s->study->part_grid, distance);
        for (uint32_t i = turn; i < DMI_SWEEP_POINTS; i += 3) mean += distance[i] / DMI_SWEEP_POINTS;
    }
    return mean / s->study->diagonal;
}

void dmi_sweep_make(const dmi_part_analysis* study, const dm_joint* joint, dmi_sweep* out) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    dmi_copy3((const float[]){joint->origin.x, joint->origin.y, joint->origin.z}, out->origin);
    out->study = study;
    out->joint = joint;
    if (joint->type == DM_JOINT_PRISMATIC)
        dmi_batched_transform_prismatic(axis, study->points, DMI_SWEEP_POINTS, &out->moved);
    else
        dmi_batched_transform_revolute(axis, out->origin, study->points, DMI_SWEEP_POINTS, &out->moved);
    float low, high;
    dmi_extents_along((const float(*)[3])study->extreme_points, study->extreme_point_count, &axis, 1, &low, &high);
    out->extent = dmi_max(high - low, 0.01f);
    out->free_count = 0;
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        out->free[i] = dmi_distance_grid_distance(&study->body_grid, study->points[i]) > 2.1f * study->body_grid.cell;
        out->free_count += out->free[i];
    }
}
