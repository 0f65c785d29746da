/* Means of axes and medians of lines. */
#include "kinematics/ranking/consensus_refine.h"

#include "math/linear3.h"

#define MAJORITY 0.5f
#define SAME_AXIS 0.02f   /* rad */
#define OTHER_AXIS 0.825f /* cosine up to which an axis is no variant of the chosen one */
#define SAME_PLACE 1e-4f  /* of the object's size */
#define ROUNDS 20

/* A voice seen along the chosen axis. */
typedef struct spot {
    float at[2], weight;
} spot;

static float apart(const spot* a, const float b[2]) {
    const float x = a->at[0] - b[0], y = a->at[1] - b[1];
    return sqrtf(x * x + y * y);
}

/* The mean of the axes; the chosen one where most agree with it. */
static void mean_axis(const dmi_candidate* chosen, const dmi_weighted_candidate* voices, uint32_t count, float out[3]) {
    float sum = 0, agreeing = 0, mean[3] = {0};
    for (uint32_t i = 0; i < count; i++) {
        const float* axis = voices[i].candidate->axis;
        const float weight = voices[i].weight;
        float across[3];
        dmi_cross3(axis, chosen->axis, across);
        dmi_madd3(mean, dmi_dot3(axis, chosen->axis) < 0 ? -weight : weight, axis, mean);
        agreeing += dmi_length3(across) < SAME_AXIS ? weight : 0;
        sum += weight;
    }
    dmi_normalize3(mean);
    dmi_copy3(agreeing < MAJORITY * sum ? mean : chosen->axis, out);
}

/* Of the spots the one that all together are nearest to. */
static void middle_spot(const spot* spots, uint32_t count, float out[2]) {
    float least = INFINITY;
    uint32_t best = 0;
    for (uint32_t i = 0; i < count; i++) {
        float sum = 0;
        for (uint32_t k = 0; k < count; k++) sum += spots[k].weight * apart(&spots[k], spots[i].at);
        if (sum < least) least = sum, best = i;
    }
    memcpy(out, spots[best].at, sizeof spots[best].at);
}

/* A spot is the median when the others pull at it less than it weighs (Kuhn's condition); otherwise Weiszfeld's
 * iteration finds it, after a step away from the spot, where it would stand still (Vardi and Zhang). */
static void geometric_median(const spot* spots, uint32_t count, float out[2]) {
    float pull[2] = {0}, own = 0, stiffness = 0;
    middle_spot(spots, count, out);
    for (uint32_t i = 0; i < count; i++) {
        const float distance = apart(&spots[i], out);
        if (distance < SAME_PLACE) {
            own += spots[i].weight;
            continue;
        }
        for (int k = 0; k < 2; k++) pull[k] += spots[i].weight * (spots[i].at[k] - out[k]) / distance;
        stiffness += spots[i].weight / distance;
    }
    const float strength = sqrtf(pull[0] * pull[0] + pull[1] * pull[1]);
    if (strength <= own) return;
    for (int k = 0; k < 2; k++) out[k] += (1 - own / strength) / stiffness * pull[k];
    for (int round = 0; round < ROUNDS; round++) {
        float sum[2] = {0}, all = 0;
        for (uint32_t i = 0; i < count; i++) {
            const float share = spots[i].weight / (apart(&spots[i], out) + SAME_PLACE);
            for (int k = 0; k < 2; k++) sum[k] += share * spots[i].at[k];
            all += share;
        }
        for (int k = 0; k < 2; k++) out[k] = sum[k] / all;
    }
}

/* The median of the lines, by where they pass the part's middle. */
static void median_line(const dmi_candidate* chosen, const dmi_weighted_candidate* voices, uint32_t count,
                        float out[3]) {
    spot spots[DMI_CONSENSUS_MAX] = {0};
    float u[3], v[3], median[2];
    dmi_perpendicular3(chosen->axis, u, v);
    for (uint32_t i = 0; i < count; i++) {
        float off[3];
        dmi_sub3(voices[i].candidate->origin, chosen->origin, off);
        spots[i] = (spot){{dmi_dot3(off, u), dmi_dot3(off, v)}, voices[i].weight};
    }
    geometric_median(spots, count, median);
    dmi_madd3(chosen->origin, median[0], u, out);
    dmi_madd3(out, median[1], v, out);
}

int dmi_consensus_counts(const dmi_candidate* chosen, const dmi_candidate* other) {
    return chosen->type == other->type && fabsf(dmi_dot3(chosen->axis, other->axis)) > OTHER_AXIS;
}

void dmi_consensus_refine(const dmi_candidate* chosen, const dmi_weighted_candidate* voices, uint32_t count,
                          dm_joint* joint) {
    float axis[3], origin[3];
    mean_axis(chosen, voices, count, axis);
    joint->axis = (dm_vec3){axis[0], axis[1], axis[2]};
    if (chosen->type == DM_JOINT_PRISMATIC) return;
    median_line(chosen, voices, count, origin);
    joint->origin = (dm_vec3){origin[0], origin[1], origin[2]};
}
