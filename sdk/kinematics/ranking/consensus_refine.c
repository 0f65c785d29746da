/* Weighted mean of axes, weighted geometric median of lines. */
#include "kinematics/ranking/consensus_refine.h"

#include "math/linear3.h"

#define MAJORITY 0.5f     /* share of the weight that is a majority; by hand */
#define SAME_AXIS 0.02f   /* sine between two axes that agree; by hand */
#define OTHER_AXIS 0.825f /* cosine up to which an axis is another direction; by hand */
#define SAME_PLACE 1e-4f  /* object sizes between two lines at the same place; by hand */
#define MIN_WEIGHT 1e-20f /* length of a mean axis; a shorter one is rounding, and has no direction */
#define ROUNDS 20         /* rounds of Weiszfeld's iteration; by hand */

/* The place where a supporting candidate's line passes the plane across the chosen axis. */
typedef struct line_point {
    float at[2], weight;
} line_point;

static float distance_to(const line_point* a, const float b[2]) {
    const float x = a->at[0] - b[0], y = a->at[1] - b[1];
    return sqrtf(x * x + y * y);
}

/* Writes the weighted mean axis, or the chosen one where most agree with it. */
static void mean_axis(const dmi_candidate* chosen, const dmi_weighted_candidate* support, uint32_t count,
                      float out[3]) {
    float sum = 0, agreeing = 0, mean[3] = {0};
    for (uint32_t i = 0; i < count; i++) {
        const float* axis = support[i].candidate->axis;
        const float weight = support[i].weight;
        float across[3];
        dmi_cross3(axis, chosen->axis, across);
        dmi_madd3(mean, dmi_dot3(axis, chosen->axis) < 0 ? -weight : weight, axis, mean);
        agreeing += dmi_length3(across) < SAME_AXIS ? weight : 0;
        sum += weight;
    }
    const bool has_mean = dmi_normalize3(mean) > MIN_WEIGHT;
    dmi_copy3(has_mean && agreeing < MAJORITY * sum ? mean : chosen->axis, out);
}

/* Writes the point with the least weighted sum of distances to all others (the medoid). */
static void medoid(const line_point* points, uint32_t count, float out[2]) {
    float least = INFINITY;
    uint32_t best = 0;
    for (uint32_t i = 0; i < count; i++) {
        float sum = 0;
        for (uint32_t k = 0; k < count; k++) sum += points[k].weight * distance_to(&points[k], points[i].at);
        if (sum < least) least = sum, best = i;
    }
    memcpy(out, points[best].at, sizeof points[best].at);
}

/* Writes the weighted geometric median. A point is the median when the others pull at it less than it weighs (Kuhn's
 * condition); otherwise Weiszfeld's iteration finds it, after a step away from the point, where it would stand still
 * (Vardi and Zhang 2000). */
static void geometric_median(const line_point* points, uint32_t count, float out[2]) {
    float pull[2] = {0}, own = 0, stiffness = 0;
    medoid(points, count, out);
    for (uint32_t i = 0; i < count; i++) {
        const float distance = distance_to(&points[i], out);
        if (distance < SAME_PLACE) {
            own += points[i].weight;
            continue;
        }
        for (int k = 0; k < 2; k++) pull[k] += points[i].weight * (points[i].at[k] - out[k]) / distance;
        stiffness += points[i].weight / distance;
    }
    const float strength = sqrtf(pull[0] * pull[0] + pull[1] * pull[1]);
    if (strength <= own) return;
    for (int k = 0; k < 2; k++) out[k] += (1 - own / strength) / stiffness * pull[k];
    for (int round = 0; round < ROUNDS; round++) {
        float sum[2] = {0}, all = 0;
        for (uint32_t i = 0; i < count; i++) {
            const float share = points[i].weight / (distance_to(&points[i], out) + SAME_PLACE);
            for (int k = 0; k < 2; k++) sum[k] += share * points[i].at[k];
            all += share;
        }
        for (int k = 0; k < 2; k++) out[k] = sum[k] / all;
    }
}

/* Writes the median of the lines, by where they pass the part's centroid. */
static void median_line(const dmi_candidate* chosen, const dmi_weighted_candidate* support, uint32_t count,
                        float out[3]) {
    line_point points[DMI_CONSENSUS_MAX] = {0};
    float u[3], v[3], median[2];
    dmi_perpendicular3(chosen->axis, u, v);
    for (uint32_t i = 0; i < count; i++) {
        float off[3];
        dmi_sub3(support[i].candidate->origin, chosen->origin, off);
        points[i] = (line_point){{dmi_dot3(off, u), dmi_dot3(off, v)}, support[i].weight};
    }
    geometric_median(points, count, median);
    dmi_madd3(chosen->origin, median[0], u, out);
    dmi_madd3(out, median[1], v, out);
}

bool dmi_consensus_counts(const dmi_candidate* chosen, const dmi_candidate* other) {
    return chosen->type == other->type && fabsf(dmi_dot3(chosen->axis, other->axis)) > OTHER_AXIS;
}

void dmi_consensus_refine(const dmi_candidate* chosen, const dmi_weighted_candidate* support, uint32_t count,
                          dm_joint* joint) {
    float axis[3], origin[3];
    mean_axis(chosen, support, count, axis);
    joint->axis = (dm_vec3){axis[0], axis[1], axis[2]};
    if (chosen->type == DM_JOINT_PRISMATIC) return;
    median_line(chosen, support, count, origin);
    joint->origin = (dm_vec3){origin[0], origin[1], origin[2]};
}
