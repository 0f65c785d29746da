/* Measures how far a joint may go: where its sweep meets the body, how far the part comes off it, how both lie along or
 * about the axis, the part's shape, and KPP-Net's guess. */
#include "base/sort.h"
#include "kinematics/limits/limits.h"
#include "kinematics/limits/sweep.h"
#include "math/elementary.h"
#include "math/linear3.h"

/* Columns of the limit features. Lengths are in the joint's unit: 1 rad, or the part's extent along the slide. */
enum {
    IS_SLIDE = 0,
    HAS_DRAG,
    UP_STOPPED, /* how far the part goes up before it is stopped, and before it is jammed; then the same down */
    UP_JAMMED,
    DOWN_STOPPED,
    DOWN_JAMMED,
    ROUNDNESS,       /* 0 for a slide */
    EXTENT,          /* extent along the axis, diagonals */
    CENTROID_OFFSET, /* distance of the centroid from the axis, diagonals; 0 for a slide */
    THIN_BY_LONG,
    MIDDLE_BY_LONG,
    LOG_DIAGONAL,
    LOG_AREA_RATIO,
    FREE_SHARE, /* share of the points that are clear of the body at rest */
    OFF_UP,     /* 3 columns: how far the part has come off the body at three values up; then the same down */
    OFF_DOWN = OFF_UP + 3,
    /* 3 columns: cosines between the axis and the sides of the part's box, longest side first. */
    BOX_COSINES = OFF_DOWN + 3,
    HAS_NETWORK = BOX_COSINES + 3,
    NETWORK_LOWER,
    NETWORK_UPPER,
    NETWORK_REVOLUTE,
    NETWORK_CONTINUOUS,
    SURROUNDINGS, /* 9 columns of a slide, or 4 of a turn */
    /* The columns of a slide: */
    SURROUNDED = SURROUNDINGS, /* share of the samples that lie round the part */
    BODY_FROM_LOW,             /* 4 columns: quantiles of the body's heights round the part, from the part's low end */
    BODY_FROM_HIGH = BODY_FROM_LOW + 4, /* 4 columns: the same from its high end */
    LIMIT_FEATURES = BODY_FROM_HIGH + 4,
    /* The columns of a turn: */
    ANGLE_COSINE = SURROUNDINGS, /* cosine of the angle from the part to the body about the axis */
    ANGLE_SINE,
    PART_SPREAD, /* 0 when all arms point one way, 1 when they point all around */
    BODY_SPREAD
};
_Static_assert(LIMIT_FEATURES == DMI_LIMIT_FEATURES, "limit features");

#define SLIDE_SWEEP 1.2f    /* extents of the part that a slide is swept; by hand */
#define TURN_SWEEP 1.8f     /* rad to the farthest of the three values of OFF; by hand */
#define MOST_ROUNDNESS 0.5f /* set by hand, as all bounds below are */
#define MOST_OFFSET 2       /* diagonals */
#define MOST_OFF 1          /* diagonals */
#define MOST_LENGTH 4       /* units */
#define AREA_RATIO_UNIT 5
#define LEAST_SIDE 1e-6f /* objects; avoids a division by 0 */
/* Multiple of the part's radius round the axis, within which the body surrounds the part; by hand. */
#define SURROUND_RADIUS 1.3f
#define LEAST_SURROUNDING 8 /* samples; fewer say nothing; by hand */
enum {
    MOST_HEIGHTS = 1024,   /* samples of the body that are sorted; by hand */
    HEIGHT_SAMPLES = 4096, /* samples of the body that are looked at, at most about twice as many; by hand */
    ARM_SAMPLES = 2048     /* the same for arms */
};
static const float off_shares[3] = {0.15f, 0.4f, 0.8f};      /* shares of the way; by hand */
static const float quantiles[] = {0.05f, 0.3f, 0.7f, 0.95f}; /* quantiles of the heights; by hand */

typedef struct measure {
    const dmi_part_analysis* analysis;
    dmi_sweep sweep;
    bool slides;
    float unit; /* 1 rad, or the part's extent along the slide */
} measure;

static float clamp(float x, float most) {
    return dmi_min(dmi_max(x, -most), most);
}

static void write_reach(const measure* m, float* out) {
    const float step = m->slides ? SLIDE_SWEEP * m->sweep.extent / DMI_SWEEP_SLIDES : DMI_SWEEP_TURN;
    const int steps = m->slides ? DMI_SWEEP_SLIDES : DMI_SWEEP_TURNS;
    float up[2], down[2];
    dmi_sweep_reach(&m->sweep, step, steps, up);
    dmi_sweep_reach(&m->sweep, -step, steps, down);
    out[UP_STOPPED] = up[0] / m->unit, out[UP_JAMMED] = up[1] / m->unit;
    out[DOWN_STOPPED] = down[0] / m->unit, out[DOWN_JAMMED] = down[1] / m->unit;
}

static void write_shape(const measure* m, float* out) {
    const dmi_part_analysis* a = m->analysis;
    float side[3];
    for (int k = 0; k < 3; k++) side[k] = a->box.high[k] - a->box.low[k];
    if (!m->slides) {
        const float offset = dmi_line_distance3(a->centre, m->sweep.moved.axis, m->sweep.origin) / a->diagonal;
        out[ROUNDNESS] = dmi_min(dmi_sweep_roundness(&m->sweep), MOST_ROUNDNESS);
        out[CENTROID_OFFSET] = dmi_min(offset, MOST_OFFSET);
    }
    out[EXTENT] = m->sweep.extent / a->diagonal;
    out[THIN_BY_LONG] = side[2] / dmi_max(side[0], LEAST_SIDE);
    out[MIDDLE_BY_LONG] = side[1] / dmi_max(side[0], LEAST_SIDE);
    out[LOG_DIAGONAL] = dmi_logf(a->diagonal);
    out[LOG_AREA_RATIO] = dmi_logf(1 + a->area_ratio) / AREA_RATIO_UNIT;
    out[FREE_SHARE] = (float)m->sweep.free_count / DMI_SWEEP_POINTS;
}

static void write_off(const measure* m, float* out) {
    const float whole = m->slides ? m->sweep.extent : TURN_SWEEP;
    for (int k = 0; k < 3; k++) {
        const dmi_clearance up = dmi_sweep_clearance(&m->sweep, whole * off_shares[k]);
        const dmi_clearance down = dmi_sweep_clearance(&m->sweep, -whole * off_shares[k]);
        out[OFF_UP + k] = dmi_min(up.least / m->analysis->diagonal, MOST_OFF);
        out[OFF_DOWN + k] = dmi_min(down.least / m->analysis->diagonal, MOST_OFF);
    }
}

/* Collects the heights along a slide of the body's samples round the part. Returns how many. */
static uint32_t surrounding_heights(const measure* m, float radius, float heights[MOST_HEIGHTS]) {
    const dmi_part_analysis* a = m->analysis;
    const float* axis = m->sweep.moved.axis;
    const uint32_t stride = 1 + a->near_count / HEIGHT_SAMPLES;
    uint32_t count = 0;
    for (uint32_t i = 0; i < a->near_count && count < MOST_HEIGHTS; i += stride)
        if (dmi_line_distance3(a->near_points[i], axis, a->centre) < SURROUND_RADIUS * radius)
            heights[count++] = dmi_dot3(a->near_points[i], axis);
    return count;
}

/* Writes where the body round a slide's part begins and ends along the axis, relative to the part's ends. For a button
 * this is its height above the body; for a drawer, the length that is inside the body. */
static void write_surroundings(const measure* m, float* out) {
    const dmi_part_analysis* a = m->analysis;
    const float* axis = m->sweep.moved.axis;
    float heights[MOST_HEIGHTS], spare[MOST_HEIGHTS], low = INFINITY, high = -INFINITY, radius = 0;
    for (uint32_t i = 0; i < DMI_SWEEP_POINTS; i++) {
        const float height = dmi_dot3(a->points[i], axis);
        low = dmi_min(low, height), high = dmi_max(high, height);
        radius = dmi_max(radius, dmi_line_distance3(a->points[i], axis, a->centre));
    }
    const uint32_t count = surrounding_heights(m, radius, heights);
    out[SURROUNDED] = (float)count / MOST_HEIGHTS;
    if (count < LEAST_SURROUNDING) return;
    dmi_sort_floats(heights, count, spare);
    for (size_t k = 0; k < sizeof quantiles / sizeof *quantiles; k++) {
        const float height = heights[(uint32_t)(quantiles[k] * (float)(count - 1))];
        out[BODY_FROM_LOW + k] = clamp((height - low) / m->unit, MOST_LENGTH);
        out[BODY_FROM_HIGH + k] = clamp((height - high) / m->unit, MOST_LENGTH);
    }
}

/* Writes the mean arm of points about the axis of a turn, and how they spread around it. */
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

/* Writes the angle from the part to the body about the axis of a turn, and how far each spreads. */
static void write_angle(const measure* m, float* out) {
    const dmi_part_analysis* a = m->analysis;
    float part[3], body[3], across[3];
    mean_arm(m, a->points, DMI_SWEEP_POINTS, 1, part, &out[PART_SPREAD]);
    mean_arm(m, (const float(*)[3])a->near_points, a->near_count, 1 + a->near_count / ARM_SAMPLES, body,
             &out[BODY_SPREAD]);
    dmi_cross3(part, body, across);
    out[ANGLE_COSINE] = dmi_dot3(part, body);
    out[ANGLE_SINE] = dmi_dot3(across, m->sweep.moved.axis);
}

static void write_network(const measure* m, const dmi_prediction* p, float* out) {
    const float* axis = m->slides ? p->slide_axis : p->turn_axis;
    const float* limits = m->slides ? p->slide_limits : p->turn_limits;
    const bool along = dmi_dot3(axis, m->sweep.moved.axis) >= 0;
    out[HAS_NETWORK] = 1;
    out[NETWORK_LOWER] = clamp((along ? limits[0] : -limits[1]) / m->unit, MOST_LENGTH);
    out[NETWORK_UPPER] = clamp((along ? limits[1] : -limits[0]) / m->unit, MOST_LENGTH);
    out[NETWORK_REVOLUTE] = p->type[DM_JOINT_REVOLUTE - 1];
    out[NETWORK_CONTINUOUS] = p->type[DM_JOINT_CONTINUOUS - 1];
}

float dmi_limits_features(const dmi_part_analysis* analysis, const dmi_prediction* prediction, int with_drag,
                          const dm_joint* joint, float out[DMI_LIMIT_FEATURES]) {
    measure m = {.analysis = analysis, .slides = joint->type == DM_JOINT_PRISMATIC};
    dmi_sweep_make(analysis, joint, &m.sweep);
    m.unit = m.slides ? m.sweep.extent : 1;
    memset(out, 0, sizeof(float) * DMI_LIMIT_FEATURES);
    out[IS_SLIDE] = m.slides ? 1.0f : 0.0f;
    out[HAS_DRAG] = with_drag ? 1.0f : 0.0f;
    write_reach(&m, out);
    write_shape(&m, out);
    write_off(&m, out);
    for (int k = 0; k < 3; k++) out[BOX_COSINES + k] = fabsf(dmi_dot3(m.sweep.moved.axis, analysis->box.axes[k]));
    if (prediction != NULL) write_network(&m, prediction, out);
    if (m.slides)
        write_surroundings(&m, out);
    else
        write_angle(&m, out);
    return m.unit;
}
