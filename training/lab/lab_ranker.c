/* Writes the candidates of generated cases with their features and errors, computed by the library's own code. */
#include "lab_ranker.h"

#include <math.h>
#include <string.h>

#include "evaluate_candidates.h"
#include "kinematics/inference/joint_models.h"
#include "math/linear3.h"

#define LEAST_SHARE 1e-30f /* whose logarithm stands for less */
#define KEPT_BEST 8        /* candidates with the least pose error, which are always written */

uint32_t dm_lab_ranker_columns(void) {
    return DMI_FEATURE_COUNT;
}

uint32_t dm_lab_prefilter_columns(uint8_t* out) {
    if (out != NULL) memcpy(out, dmi_cheap_columns, sizeof dmi_cheap_columns);
    return DMI_CHEAP_COLUMNS;
}

/* Orders candidates: the KEPT_BEST with the least pose error first, then the others at random. */
static void order_rows(const lab_evaluated_case* work, uint32_t order[DMI_CANDIDATES_MAX]) {
    dmi_random random = work->made.random;
    for (uint32_t i = 0; i < work->count; i++) order[i] = i;
    for (uint32_t i = 0; i < work->count && i < KEPT_BEST; i++)
        for (uint32_t j = i + 1; j < work->count; j++)
            if (work->pose[order[j]] < work->pose[order[i]]) {
                const uint32_t swap = order[i];
                order[i] = order[j], order[j] = swap;
            }
    for (uint32_t i = KEPT_BEST; i < work->count; i++) {
        const uint32_t j = i + dmi_random_u32(&random) % (work->count - i), swap = order[i];
        order[i] = order[j], order[j] = swap;
    }
}

static void write_case(const lab_evaluated_case* work, int with_drag, uint32_t at, void* user) {
    const dm_lab_ranker* out = user;
    const uint32_t rows = work->count < out->rows ? work->count : out->rows;
    uint32_t order[DMI_CANDIDATES_MAX];
    const dmi_float3 axis = dmi_xyz(work->joint.axis), origin = dmi_xyz(work->joint.origin);
    order_rows(work, order);
    for (uint32_t i = 0; i < rows; i++) {
        const uint32_t k = order[i], slot = at * out->rows + i;
        const dmi_candidate* c = &work->candidates[k];
        memcpy(out->features + (size_t)slot * DMI_FEATURE_COUNT, work->features[k], sizeof work->features[k]);
        out->pose[slot] = work->pose[k];
        out->axis_error[slot] = acosf(fminf(fabsf(dmi_dot3(axis.v, c->axis)), 1));
        out->line_error[slot] = c->type == DM_JOINT_PRISMATIC ? 0 : dmi_line_distance3(c->origin, axis.v, origin.v);
    }
    out->used[at] = (int32_t)rows;
    out->total[at] = (int32_t)work->count;
    out->type[at] = work->joint.type - 1;
    out->has_drag[at] = with_drag;
    out->category[at] = (int32_t)work->made.category_id;
    out->best[at] = out->pose[(size_t)at * out->rows];
}

dm_result dm_lab_ranker_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                              const void* prefilter, size_t prefilter_size, const dm_lab_ranker* out) {
    dm_lab_ranker to = *out;
    return lab_evaluate_batch(options, kinematics, kinematics_size, prefilter, prefilter_size, write_case, &to);
}

dm_result dm_lab_ranker_log_shares(const void* ranker, size_t ranker_size, uint32_t cases, const uint32_t* first,
                                   const float* features, float* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_joint_models* models = NULL;
    const dm_result result = dmi_joint_models_load(&env, ranker, ranker_size, &models);
    if (result != DM_OK) return result;
    const float(*rows)[DMI_FEATURE_COUNT] = (const float(*)[DMI_FEATURE_COUNT])features;
    for (uint32_t c = 0; c < cases; c++)
        dmi_ranker_probabilities(&models->ranker, dmi_cpu_best_isa(), rows + first[c], first[c + 1] - first[c],
                                 out + first[c]);
    for (uint32_t i = 0; i < first[cases]; i++) out[i] = logf(fmaxf(out[i], LEAST_SHARE));
    dmi_joint_models_destroy(models);
    return DM_OK;
}

dm_result dm_lab_ranker_given(const dm_lab_given* given, int32_t with_drag, const void* kinematics,
                              size_t kinematics_size, const dm_lab_ranker* out) {
    lab_evaluator evaluator;
    dm_lab_ranker to = *out;
    dm_result result = lab_evaluator_open(kinematics, kinematics_size, NULL, 0, &evaluator);
    if (result != DM_OK) return result;
    result = lab_case_given(&evaluator.env, given, &evaluator.work->made);
    if (result == DM_OK) {
        evaluator.work->hint = lab_given_drag(&evaluator.work->made, given, 0, &evaluator.work->joint);
        result = lab_evaluate_case(&evaluator, with_drag, 0, write_case, &to);
        dmi_mesh_destroy(&evaluator.env, evaluator.work->made.mesh);
    }
    lab_evaluator_close(&evaluator);
    return result;
}
