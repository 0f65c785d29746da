/* Computes the candidates of a case, prefiltered where there is a prefilter, their features and their pose errors. */
#include "evaluate_candidates.h"

#include "pose_error.h"
#include "pull.h"

#define BLOCK ((size_t)1 << 20)
#define WEIGHTS_BLOCK ((size_t)64 * 1024)

static void read_prefilter(dmi_loader* loader, void* network) {
    dmi_prefilter_read(loader, network);
}

dm_result lab_evaluator_open(const void* kinematics, size_t kinematics_size, const void* prefilter,
                             size_t prefilter_size, lab_evaluator* out) {
    *out = (lab_evaluator){.has_prefilter = prefilter != NULL};
    dmi_env_init(&out->env, NULL, NULL, NULL);
    dmi_arena_init(&out->weights, &out->env, WEIGHTS_BLOCK);
    dm_result result = kinematics != NULL ? dmi_kpp_net_load(&out->env, kinematics, kinematics_size, &out->net) : DM_OK;
    if (result == DM_OK && prefilter != NULL)
        result = dmi_load_network(&out->env, prefilter, prefilter_size, "dragmesh-prefilter", read_prefilter,
                                  &out->prefilter, &out->weights);
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
    dmi_arena_release(&evaluator->weights);
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
    const dmi_isa isa = dmi_cpu_best_isa();
    lab_evaluated_case* w = evaluator->work;
    const dmi_drag_hint* hint = with_drag ? &w->hint : NULL;
    const dmi_kpp_ensemble* ensemble = net != NULL ? &w->ensemble : NULL;
    const dmi_prediction* prediction = net != NULL ? &w->ensemble.prediction : NULL;
    const uint32_t part = (uint32_t)dmi_mesh_find_part(w->made.mesh, w->made.part);
    const dm_result result =
        dmi_part_analysis_make(arena, w->made.mesh, &w->made.cloud, part, w->made.welded, NULL, &w->analysis);
    if (result != DM_OK) return dmi_fail(&evaluator->env, result, "lab: a part can't be analysed");
    if (net != NULL) dmi_kpp_ensemble_run(net, isa, &w->made.cloud, hint, evaluator->scratch, &w->ensemble);
    w->count = dmi_candidates_make(&w->analysis, hint, prediction, w->candidates);
    if (evaluator->has_prefilter)
        w->count = dmi_prefilter_keep(&evaluator->prefilter, &w->analysis, hint, net, isa, ensemble, w->candidates,
                                      w->count, w->features);
    if (net != NULL) dmi_kpp_ensemble_score(net, isa, ensemble, w->candidates, w->count, w->score);
    dmi_candidate_features_make(&w->analysis, hint, prediction, net != NULL ? w->score : NULL, w->candidates, w->count,
                                w->features);
    label(w);
    return DM_OK;
}

dm_result lab_evaluate_case(lab_evaluator* evaluator, int with_drag, uint32_t index, lab_evaluated_visit each,
                            void* user) {
    dmi_arena arena;
    dmi_arena_init(&arena, &evaluator->env, BLOCK);
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
        w->hint = lab_case_drag(&w->made, options->pull, options->drag_noise_degrees, &w->joint);
        result = lab_evaluate_case(evaluator, lab_random_bool(&w->made.random, options->with_drag), i, each, user);
        lab_case_release(&evaluator->env, &w->made);
    }
    return result;
}

dm_result lab_evaluate_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                             const void* prefilter, size_t prefilter_size, lab_evaluated_visit each, void* user) {
    lab_evaluator evaluator;
    dm_result result = lab_evaluator_open(kinematics, kinematics_size, prefilter, prefilter_size, &evaluator);
    if (result != DM_OK) return result;
    result = evaluate_cases(&evaluator, options, each, user);
    lab_evaluator_close(&evaluator);
    return result;
}
