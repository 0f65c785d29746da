/* What tells how far a joint goes: where its sweep meets the body, how far the part comes off it, how both lie along or
 * about the axis, and the part's shape. */
#include "base/sort.h"
#include "kinematics/limits/limits.h"
#include "kinematics/limits/sweep.h"
#include "math/linear3.h"

enum { KIND, REACH = 2, SHAPE = 6, OFF = 14, BOX = 20, NETWORK = 23, AROUND = 28 };

typedef struct measure {
    const dmi_part_analysis* study;
    dmi_sweep sweep;
    int slides;
    float unit; /* that limits are learnt in: 1 rad, or the part's extent along the slide */
} measure;

static void write_reach(const measure* m, float* out) {
    const float step = m->slides ? 1.2f * m->sweep.extent / DMI_SWEEP_SLIDES : DMI_SWEEP_TURN;
    const int steps = m->slides ? DMI_SWEEP_SLIDES : DMI_SWEEP_TURNS;
    float up[2], down[2];
    dmi_sweep_reach(&m->sweep, step, steps, up);
    dmi_sweep_reach(&m->sweep, -step, steps, down);
    for (int k = 0; k < 2; k++) out[k] = up[k] / m->unit, out[2 + k] = down[k] / m->unit;
}

static void write_shape(const measure* m, float* out) {
    const dmi_part_analysis* study = m->study;
    float side[3];
    for (int k = 0; k < 3; k++) side[k] = study->box.high[k] - study->box.low[k];
    out[0] = m->slides ? 0 : dmi_min(dmi_sweep_roundness(&m->sweep), 0.5f);
    out[1] = m->sweep.extent / study->diagonal;
    out[2] =
        m->slides
            ? 0
            : dmi_min(dmi_line_distance3(study->centre, m->sweep.moved.axis, m->sweep.origin) / study->diagonal, 2);
    out[3] = side[2] / dmi_max(side[0], 1e-6f);
    out[4] = side[1] / dmi_max(side[0], 1e-6f);
    out[5] = logf(study->diagonal);
    out[6] = logf(1 + study->area_ratio) / 5;
    out[7] = (float)m->sweep.free_count / DMI_SWEEP_POINTS;
}

/* How far the part has come off the body, over its diagonal, at a few values either way. */
static void write_off(const measure* m, float* out) {
    static const float shares[3] = {0.15f, 0.4f, 0.8f};
    const float whole = m->slides ? m->sweep.extent : 1.8f;
    for (int k = 0; k < 3; k++)
        for (int way = 0; way < 2; way++) {
            const dmi_clearance at = dmi_sweep_clearance(&m->sweep, (way == 0 ? whole : -whole) * shares[k]);
            out[k + 3 * way] = dmi_min(at.least / m->study->diagonal, 1);
        }
}

/* A slide: where the body around the part begins and ends along the axis, seen from the part's ends: how far a button
 * stands proud, how long a drawer is held. In extents of the part. */
static void write_surroundings(const measure* m, float* out) {
    const dmi_part_analysis* study = m->study;
    const float* axis = m->sweep.moved.axis;
    float heights[1024], spare[1024], low = INFINITY, high = -INFINITY, radius = 0;
    uint32_t count = 0;
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        const float height = dmi_dot3(study->points[i], axis);
        low = dmi_min(low, height), high = dmi_max(high, height);
        radius = dmi_max(radius, dmi_line_distance3(study->points[i], axis, study->centre));
    }
    const uint32_t stride = 1 + study->near_count / 4096;
    for (uint32_t i = 0; i < study->near_count && count < 1024; i += stride)
        if (dmi_line_distance3(study->near_points[i], axis, study->centre) < 1.3f * radius)
            heights[count++] = dmi_dot3(study->near_points[i], axis);
    out[0] = (float)count / 1024;
    if (count < 8) return;
    dmi_sort_floats(heights, count, spare);
    static const float shares[4] = {0.05f, 0.3f, 0.7f, 0.95f};
    for (int k = 0; k < 4; k++) {
        const float height = heights[(uint32_t)(shares[k] * (float)(count - 1))];
        out[1 + k] = dmi_min(dmi_max((height - low) / m->unit, -4), 4);
        out[5 + k] = dmi_min(dmi_max((height - high) / m->unit, -4), 4);
    }
}

/* A turn: the mean arm of points about the axis, and how they spread around it. */
static void mean_arm(const measure* m, const float (*points)[3], uint32_t count, uint32_t stride, float out_arm[3],
                     float* out_spread) {
    float total = 0;
    memset(out_arm, 0, 3 * sizeof *out_arm);
    for (uint32_t i = 0; i < count; i += stride) {
        float arm[3];
        dmi_sub3(points[i], m->sweep.origin, arm);
        dmi_reject3(arm, m->sweep.moved.axis);
        dmi_madd3(out_arm, 1, arm, out_arm);
        total += dmi_length3(arm);
    }
    *out_spread = total > 0 ? 1 - dmi_normalize3(out_arm) / total : 1;
}

/* A turn: the angle from the part to the body about the axis, as its cosine and sine, and how far each spreads. */
static void write_angle(const measure* m, float* out) {
    float part[3], body[3], across[3];
    mean_arm(m, m->study->points, DMI_SWEEP_POINTS, 1, part, &out[2]);
    mean_arm(m, (const float(*)[3])m->study->near_points, m->study->near_count, 1 + m->study->near_count / 2048, body,
             &out[3]);
    dmi_cross3(part, body, across);
    out[0] = dmi_dot3(part, body);
    out[1] = dmi_dot3(across, m->sweep.moved.axis);
}

static void write_network(const measure* m, const dmi_prediction* p, float* out) {
    const float* axis = m->slides ? p->slide_axis : p->turn_axis;
    const float* limits = m->slides ? p->slide_limits : p->turn_limits;
    const int along = dmi_dot3(axis, m->sweep.moved.axis) >= 0;
    out[0] = 1;
    out[1] = dmi_min(dmi_max((along ? limits[0] : -limits[1]) / m->unit, -4), 4);
    out[2] = dmi_min(dmi_max((along ? limits[1] : -limits[0]) / m->unit, -4), 4);
    out[3] = p->type[DM_JOINT_REVOLUTE - 1];
    out[4] = p->type[DM_JOINT_CONTINUOUS - 1];
}

float dmi_limits_features(const dmi_part_analysis* study, const dmi_prediction* prediction, int with_drag,
                          const dm_joint* joint, float out[DMI_LIMIT_FEATURES]) {
    measure m = {.study = study, .slides = joint->type == DM_JOINT_PRISMATIC};
    dmi_sweep_make(study, joint, &m.sweep);
    m.unit = m.slides ? m.sweep.extent : 1;
    memset(out, 0, sizeof(float) * DMI_LIMIT_FEATURES);
    out[KIND] = m.slides ? 1.0f : 0.0f;
    out[KIND + 1] = with_drag ? 1.0f : 0.0f;
    write_reach(&m, out + REACH);
    write_shape(&m, out + SHAPE);
    write_off(&m, out + OFF);
    for (int k = 0; k < 3; k++) out[BOX + k] = fabsf(dmi_dot3(m.sweep.moved.axis, study->box.axes[k]));
    if (prediction != NULL) write_network(&m, prediction, out + NETWORK);
    if (m.slides)
        write_surroundings(&m, out + AROUND);
    else
        write_angle(&m, out + AROUND);
    return m.unit;
}
