/* Moves samples of a part along a joint and looks up how far they are from the body. */
#include "kinematics/sweep.h"

#include "kinematics/linear3.h"

#define STOPPED 0.03f /* share of the free points that must meet the body */
#define JAMMED 0.15f  /* share that no gap or thin shell explains */

/* The joint at a value. */
typedef struct placement {
    float value, cosine, sine;
} placement;

static placement place(const dmi_sweep* s, float value) {
    if (dmi_sweep_slides(s)) return (placement){value, 1, 0};
    return (placement){value, cosf(value), sinf(value)};
}

static void moved(const dmi_sweep* s, const float point[3], placement at, float out[3]) {
    if (dmi_sweep_slides(s)) {
        dmi_madd3(point, at.value, s->axis, out);
        return;
    }
    dmi_turn3(s->axis, s->origin, at.cosine, at.sine, point, out);
    if (s->joint->type == DM_JOINT_SCREW) dmi_madd3(out, s->joint->pitch * at.value, s->axis, out);
}

static float distance_of(const dmi_sweep* s, uint32_t point, placement at) {
    float x[3];
    moved(s, s->study->points[point], at, x);
    return dmi_field_distance(&s->study->body_field, x);
}

/* Share of the free points that are inside the body's cells at a value. */
static float blocked(const dmi_sweep* s, float value) {
    const placement at = place(s, value);
    uint32_t hits = 0;
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++)
        hits += s->free[i] && distance_of(s, i, at) < 0.9f * s->study->body_field.cell;
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
    const placement at = place(s, value);
    dmi_clearance out = {.least = INFINITY};
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        const float distance = distance_of(s, i, at);
        out.mean += fminf(distance, s->study->diagonal) / DMI_SWEEP_POINTS;
        out.least = fminf(out.least, distance);
    }
    return out;
}

float dmi_sweep_roundness(const dmi_sweep* s) {
    placement at[3];
    float mean = 0;
    for (int i = 0; i < 3; i++) at[i] = place(s, 0.4f + 2.1f * (float)i);
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        float x[3];
        moved(s, s->study->points[i], at[i % 3], x);
        mean += dmi_field_distance(&s->study->part_field, x) / DMI_SWEEP_POINTS;
    }
    return mean / s->study->diagonal;
}

dmi_sweep dmi_sweep_make(const dmi_study* study, const dm_joint* joint) {
    dmi_sweep s = {.study = study,
                   .joint = joint,
                   .axis = {joint->axis.x, joint->axis.y, joint->axis.z},
                   .origin = {joint->origin.x, joint->origin.y, joint->origin.z}};
    const float axes[1][3] = {{s.axis[0], s.axis[1], s.axis[2]}};
    float low, high;
    dmi_shape_limits((const float(*)[3])study->extremes, study->extreme_count, axes, 1, &low, &high);
    s.extent = fmaxf(high - low, 0.01f);
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        s.free[i] = dmi_field_distance(&study->body_field, study->points[i]) > 2.1f * study->body_field.cell;
        s.free_count += s.free[i];
    }
    return s;
}
