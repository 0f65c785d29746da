/* Computes the candidates of a case, sieved where there is a sieve, with their evidence and their pose errors. */
#include "evaluate_candidates.h"

#include "pose_error.h"

#define SIEVE_VERSION 1
#define EXACT_DRAGS 0.4f /* share of cases, set by hand */

static dm_result open_sieve(lab_evaluator* evaluator, const void* data, size_t size) {
    dmi_weights* weights;
    const dm_result result = dmi_weights_open(&evaluator->env, data, size, "dragmesh-sieve", SIEVE_VERSION, &weights);
    if (result != DM_OK) return result;
    evaluator->sieve = dmi_alloc(&evaluator->env, sizeof *evaluator->sieve, 64);
    const int read = evaluator->sieve != NULL && dmi_prefilter_read(weights, evaluator->sieve);
    dmi_weights_close(weights);
    return read ? DM_OK
                : dmi_fail(&evaluator->env, DM_ERROR_WRONG_MODEL, "lab: no sieve in the file, or no memory for it");
}

dm_result lab_evaluator_open(const void* kinematics, size_t kinematics_size, const void* sieve, size_t sieve_size,
                             lab_evaluator* out) {
    *out = (lab_evaluator){0};
    dmi_env_init(&out->env, NULL, NULL, NULL);
    dm_result result = kinematics != NULL ? dmi_kpp_net_load(&out->env, kinematics, kinematics_size, &out->net) : DM_OK;
    if (result == DM_OK && sieve != NULL) result = open_sieve(out, sieve, sieve_size);
    if (result == DM_OK) {
        out->scratch_size = out->net != NULL ? dmi_kpp_net_scratch_size(out->net) : 64;
        out->scratch = dmi_alloc(&out->env, out->scratch_size, 64);
        out->work = dmi_alloc_zeroed(&out->env, sizeof *out->work, 64);
        if (out->scratch == NULL || out->work == NULL) result = DM_ERROR_OUT_OF_MEMORY;
    }
    if (result != DM_OK) lab_evaluator_close(out);
    return result;
}

void lab_evaluator_close(lab_evaluator* evaluator) {
    dmi_free(&evaluator->env, evaluator->work, sizeof *evaluator->work);
    dmi_free(&evaluator->env, evaluator->scratch, evaluator->scratch_size);
    dmi_free(&evaluator->env, evaluator->sieve, sizeof *evaluator->sieve);
    dmi_kpp_net_destroy(evaluator->net);
}

static void label(lab_evaluated_case* work) {
    lab_pose_target target;
    lab_pose_target_make(&work->made.cloud, &work->joint, work->hint.point, &target);
    for (uint32_t i = 0; i < work->count; i++) {
        const dmi_candidate* c = &work->candidates[i];
        work->pose[i] = lab_pose_error(&target, c->type, c->axis, c->origin);
    }
}

static dm_result evaluate_case(lab_evaluator* evaluator, dmi_arena* arena, int with_drag) {
    const dmi_kpp_net* net = evaluator->net;
    lab_evaluated_case* w = evaluator->work;
    const dmi_drag_hint* hint = with_drag ? &w->hint : NULL;
    const uint32_t part = (uint32_t)dmi_mesh_find_part(w->made.mesh, w->made.part);
    const dm_result result = dmi_part_analysis_make(arena, w->made.mesh, &w->made.cloud, part, w->made.welded, &w->study);
    if (result != DM_OK) return dmi_fail(&evaluator->env, result, "lab: a case can't be studied");
    const dmi_isa isa = dmi_cpu_best_isa();
    const dmi_kpp_ensemble* opinion = net != NULL ? &w->opinion : NULL;
    if (net != NULL) dmi_kpp_ensemble_run(net, isa, &w->made.cloud, hint, evaluator->scratch, &w->opinion);
    const dmi_prediction* prediction = net != NULL ? &w->opinion.prediction : NULL;
    w->count = dmi_candidates_make(&w->study, hint, prediction, w->candidates);
    if (evaluator->sieve != NULL)
        w->count =
            dmi_prefilter_keep(evaluator->sieve, &w->study, hint, net, isa, opinion, w->candidates, w->count, w->evidence);
    if (net != NULL) dmi_kpp_ensemble_score(net, isa, &w->opinion, w->candidates, w->count, w->score);
    dmi_candidate_features_make(&w->study, hint, prediction, net != NULL ? w->score : NULL, w->candidates, w->count, w->evidence);
    label(w);
    return DM_OK;
}

dm_result lab_evaluate_case(lab_evaluator* evaluator, int with_drag, uint32_t index, lab_evaluated_visit each,
                            void* user) {
    dmi_arena arena;
    dmi_arena_init(&arena, &evaluator->env, (size_t)1 << 20);
    const dm_result result = evaluate_case(evaluator, &arena, with_drag);
    if (result == DM_OK) each(evaluator->work, with_drag, index, user);
    dmi_arena_release(&arena);
    return result;
}

static dm_result evaluate_cases(lab_evaluator* evaluator, const dm_lab_options* options, lab_evaluated_visit each,
                                void* user) {
    lab_evaluated_case* w = evaluator->work;
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        result = lab_case_make(&evaluator->env, options, i, &w->made);
        if (result != DM_OK) break;
        /* Some drags are exact, as from a host that computes the tangent. */
        const float noise = lab_random_bool(&w->made.random, EXACT_DRAGS) ? 0 : options->drag_noise_degrees;
        w->hint = lab_case_drag(&w->made, noise, &w->joint);
        result = lab_evaluate_case(evaluator, lab_random_bool(&w->made.random, options->with_drag), i, each, user);
        lab_case_release(&evaluator->env, &w->made);
    }
    return result;
}

dm_result lab_evaluate_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                             const void* sieve, size_t sieve_size, lab_evaluated_visit each, void* user) {
    lab_evaluator evaluator;
    dm_result result = lab_evaluator_open(kinematics, kinematics_size, sieve, sieve_size, &evaluator);
    if (result != DM_OK) return result;
    result = evaluate_cases(&evaluator, options, each, user);
    lab_evaluator_close(&evaluator);
    return result;
}
