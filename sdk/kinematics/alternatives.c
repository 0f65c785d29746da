/* Alternatives: the likeliest candidates that move the part unlike each other and unlike its hypotheses. */
#include "kinematics/alternatives.h"

#include "kinematics/linear3.h"

#define POINTS 12    /* that motions are compared at */
#define ALIKE 0.995f /* cosine between motions that are one alternative: they differ by less than a tenth */
#define GONE (-1.0f)

/* The velocities of some of the part's points, together of unit length; slides and turns are compared apart. */
typedef struct motion {
    float velocity[POINTS][3];
    int slides;
} motion;

static void unit_motion(motion* m) {
    float square = 0;
    for (int i = 0; i < POINTS; i++) square += dmi_dot3(m->velocity[i], m->velocity[i]);
    const float scale = 1 / sqrtf(square + 1e-20f);
    for (int i = 0; i < POINTS; i++)
        for (int k = 0; k < 3; k++) m->velocity[i][k] *= scale;
}

static motion motion_of_candidate(const dmi_study* study, const dmi_candidate* candidate) {
    motion m = {.slides = candidate->type == DM_JOINT_PRISMATIC};
    for (int i = 0; i < POINTS; i++) dmi_candidate_velocity(candidate, study->points[i], m.velocity[i]);
    unit_motion(&m);
    return m;
}

static motion motion_of_joint(const dmi_study* study, const dm_joint* joint) {
    motion m = {.slides = joint->type == DM_JOINT_PRISMATIC};
    for (int i = 0; i < POINTS; i++) dmi_joint_velocity(joint, 0, study->points[i], m.velocity[i]);
    unit_motion(&m);
    return m;
}

static int alike(const motion* a, const motion* b) {
    float cosine = 0;
    for (int i = 0; i < POINTS; i++) cosine += dmi_dot3(a->velocity[i], b->velocity[i]);
    return a->slides == b->slides && fabsf(cosine) > ALIKE;
}

/* Takes what moves the part alike; answers the probability that it gathers. */
static float take_alike(const motion* like, const motion* motions, uint32_t count, float* left) {
    float mass = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (left[i] == GONE || !alike(like, &motions[i])) continue;
        mass += left[i];
        left[i] = GONE;
    }
    return mass;
}

static void add(const dmi_candidate* candidate, float confidence, dmi_alternatives* out) {
    dmi_alternative* added = &out->list[out->count++];
    added->type = candidate->type;
    added->confidence = confidence;
    dmi_copy3(candidate->axis, added->axis);
    dmi_copy3(candidate->origin, added->origin);
}

dm_result dmi_alternatives_find(dmi_arena* arena, const dmi_study* study, const dmi_ranker* ranker, int dragged,
                                const dm_joint* hypotheses, uint32_t hypothesis_count, const dmi_candidate* candidates,
                                const float* probability, uint32_t count, dmi_alternatives* out) {
    motion* motions = dmi_arena_push(arena, count * sizeof *motions);
    float* left = dmi_arena_push(arena, count * sizeof *left);
    out->count = 0;
    if (motions == NULL || left == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "alternatives: no memory for %u motions", count);
    for (uint32_t i = 0; i < count; i++)
        motions[i] = motion_of_candidate(study, &candidates[i]), left[i] = probability[i];
    for (uint32_t i = 0; i < hypothesis_count; i++) {
        const motion known = motion_of_joint(study, &hypotheses[i]);
        take_alike(&known, motions, count, left);
    }
    while (out->count < DMI_ALTERNATIVES) {
        uint32_t best = 0;
        for (uint32_t i = 1; i < count; i++) best = left[i] > left[best] ? i : best;
        if (count == 0 || left[best] == GONE) break;
        const motion like = motions[best];
        const float mass = take_alike(&like, motions, count, left);
        add(&candidates[best], dmi_ranker_confidence(ranker, dragged, mass), out);
    }
    return DM_OK;
}
