/* Candidates of a case, sieved where there is a sieve, with their evidence and what each would cost a player. */
#include "judge.h"

#include "goal.h"

#define SIEVE_VERSION 1
#define EXACT_DRAGS 0.4f

static dm_result open_sieve(lab_judge* judge, const void* data, size_t size) {
    dmi_weights* weights;
    const dm_result result = dmi_weights_open(&judge->env, data, size, "dragmesh-sieve", SIEVE_VERSION, &weights);
    if (result != DM_OK) return result;
    judge->sieve = dmi_alloc(&judge->env, sizeof *judge->sieve, 64);
    const int read = judge->sieve != NULL && dmi_sieve_read(weights, judge->sieve);
    dmi_weights_close(weights);
    return read ? DM_OK : dmi_fail(&judge->env, DM_ERROR_WRONG_MODEL, "lab: no sieve in the file, or no memory for it");
}

dm_result lab_judge_open(const void* kinematics, size_t kinematics_size, const void* sieve, size_t sieve_size,
                         lab_judge* out) {
    *out = (lab_judge){0};
    dmi_env_init(&out->env, NULL, NULL, NULL);
    dm_result result = kinematics != NULL ? dmi_kpp_net_load(&out->env, kinematics, kinematics_size, &out->net) : DM_OK;
    if (result == DM_OK && sieve != NULL) result = open_sieve(out, sieve, sieve_size);
    if (result == DM_OK) {
        out->scratch_size = out->net != NULL ? dmi_kpp_net_scratch_size(out->net) : 64;
        out->scratch = dmi_alloc(&out->env, out->scratch_size, 64);
        out->work = dmi_alloc_zeroed(&out->env, sizeof *out->work, 64);
        if (out->scratch == NULL || out->work == NULL) result = DM_ERROR_OUT_OF_MEMORY;
    }
    if (result != DM_OK) lab_judge_close(out);
    return result;
}

void lab_judge_close(lab_judge* judge) {
    dmi_free(&judge->env, judge->work, sizeof *judge->work);
    dmi_free(&judge->env, judge->scratch, judge->scratch_size);
    dmi_free(&judge->env, judge->sieve, sizeof *judge->sieve);
    dmi_kpp_net_destroy(judge->net);
}

static void label(lab_judged* work) {
    lab_goal goal;
    lab_goal_make(&work->made.cloud, &work->joint, work->hint.point, &goal);
    for (uint32_t i = 0; i < work->count; i++) {
        const dmi_candidate* c = &work->candidates[i];
        work->pose[i] = lab_goal_error(&goal, c->type, c->axis, c->origin);
    }
}

static dm_result judge_case(lab_judge* judge, dmi_arena* arena, int with_drag) {
    const dmi_kpp_net* net = judge->net;
    lab_judged* w = judge->work;
    const dmi_drag_hint* hint = with_drag ? &w->hint : NULL;
    const uint32_t part = (uint32_t)dmi_mesh_find_part(w->made.mesh, w->made.part);
    const dm_result result = dmi_study_make(arena, w->made.mesh, &w->made.cloud, part, w->made.welded, &w->study);
    if (result != DM_OK) return dmi_fail(&judge->env, result, "lab: a case can't be studied");
    const dmi_isa isa = dmi_cpu_best_isa();
    const dmi_opinion* opinion = net != NULL ? &w->opinion : NULL;
    if (net != NULL) dmi_opinion_form(net, isa, &w->made.cloud, hint, judge->scratch, &w->opinion);
    const dmi_prediction* prediction = net != NULL ? &w->opinion.prediction : NULL;
    w->count = dmi_candidates_make(&w->study, hint, prediction, w->candidates);
    if (judge->sieve != NULL)
        w->count =
            dmi_sieve_keep(judge->sieve, &w->study, hint, net, isa, opinion, w->candidates, w->count, w->evidence);
    if (net != NULL) dmi_opinion_score(net, isa, &w->opinion, w->candidates, w->count, w->score);
    dmi_evidence_make(&w->study, hint, prediction, net != NULL ? w->score : NULL, w->candidates, w->count, w->evidence);
    label(w);
    return DM_OK;
}

dm_result lab_judge_one(lab_judge* judge, int with_drag, uint32_t index, lab_judge_each each, void* user) {
    dmi_arena arena;
    dmi_arena_init(&arena, &judge->env, (size_t)1 << 20);
    const dm_result result = judge_case(judge, &arena, with_drag);
    if (result == DM_OK) each(judge->work, with_drag, index, user);
    dmi_arena_release(&arena);
    return result;
}

static dm_result judge_cases(lab_judge* judge, const dm_lab_options* options, lab_judge_each each, void* user) {
    lab_judged* w = judge->work;
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        result = lab_case_make(&judge->env, options, i, &w->made);
        if (result != DM_OK) break;
        /* Some drags are exact: a host may hand over a tangent that it has computed. */
        const float noise = lab_chance(&w->made.random, EXACT_DRAGS) ? 0 : options->drag_noise_degrees;
        w->hint = lab_case_drag(&w->made, noise, &w->joint);
        result = lab_judge_one(judge, lab_chance(&w->made.random, options->with_drag), i, each, user);
        lab_case_release(&judge->env, &w->made);
    }
    return result;
}

dm_result lab_judge_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                          const void* sieve, size_t sieve_size, lab_judge_each each, void* user) {
    lab_judge judge;
    dm_result result = lab_judge_open(kinematics, kinematics_size, sieve, sieve_size, &judge);
    if (result != DM_OK) return result;
    result = judge_cases(&judge, options, each, user);
    lab_judge_close(&judge);
    return result;
}
