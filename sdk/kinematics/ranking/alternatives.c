/* Chooses alternatives by non-maximum suppression: the likeliest candidates that move the part unlike each other and
 * unlike its hypotheses. */
#include "kinematics/ranking/alternatives.h"

#include "kinematics/candidates/twist.h"
#include "math/linear3.h"

#define ALIKE 0.1f /* twist difference up to which candidates are one alternative; as for hypotheses */
#define TAKEN (-1.0f)

/* Removes the candidates that move the part alike. Returns the sum of their probabilities. */
static float take_alike(const dmi_twist* like, const dmi_twist* motions, uint32_t count, float* left) {
    float mass = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (left[i] == TAKEN || dmi_twist_difference(like, &motions[i]) > ALIKE) continue;
        mass += left[i];
        left[i] = TAKEN;
    }
    return mass;
}

static void add_alternative(const dmi_candidate* candidate, float confidence, dmi_alternatives* out) {
    dmi_alternative* added = &out->list[out->count++];
    added->type = candidate->type;
    added->confidence = confidence;
    dmi_copy3(candidate->axis, added->axis);
    dmi_copy3(candidate->origin, added->origin);
}

dm_result dmi_alternatives_find(dmi_arena* arena, const dmi_part_analysis* analysis, const dmi_ranker* ranker,
                                int dragged, const dm_joint* hypotheses, uint32_t hypothesis_count,
                                const dmi_candidate* candidates, const float* probability, uint32_t count,
                                dmi_alternatives* out) {
    dmi_twist* motions = dmi_arena_push(arena, count * sizeof *motions);
    float* left = dmi_arena_push(arena, count * sizeof *left);
    out->count = 0;
    if (motions == NULL || left == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "alternatives: no memory for %u motions", count);
    for (uint32_t i = 0; i < count; i++) {
        dmi_twist_of_candidate(analysis, &candidates[i], &motions[i]);
        left[i] = probability[i];
    }
    for (uint32_t i = 0; i < hypothesis_count; i++) {
        dmi_twist known;
        dmi_twist_of_joint(analysis, &hypotheses[i], &known);
        take_alike(&known, motions, count, left);
    }
    while (out->count < DMI_ALTERNATIVES) {
        uint32_t best = 0;
        for (uint32_t i = 1; i < count; i++) best = left[i] > left[best] ? i : best;
        if (count == 0 || left[best] == TAKEN) break;
        const dmi_twist like = motions[best];
        const float mass = take_alike(&like, motions, count, left);
        add_alternative(&candidates[best], dmi_ranker_confidence(ranker, dragged, mass), out);
    }
    return DM_OK;
}
