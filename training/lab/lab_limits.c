/* Features and true limits of generated joints, made by the library's own sweep. */
#include "lab_limits.h"

#include <string.h>

#include "case.h"
#include "kinematics/kinematics.h"
#include "kinematics/limits.h"
#include "kinematics/opinion.h"

typedef struct bench {
    dmi_env env;
    dmi_kpp_net* net;
    void* scratch;
    lab_case made;
    dmi_opinion opinion;
    dmi_study study;
} bench;

uint32_t dm_lab_limits_columns(void) {
    return DMI_LIMIT_FEATURES;
}

static dm_result limits_case(bench* b, dmi_arena* arena, const dm_lab_options* options, const dm_lab_limits* out,
                             uint32_t at) {
    dm_joint truth;
    const dmi_drag_hint hint = lab_case_drag(&b->made, options->drag_noise_degrees, &truth);
    const int with_drag = lab_chance(&b->made.random, options->with_drag);
    const uint32_t part = (uint32_t)dmi_mesh_find_part(b->made.mesh, b->made.part);
    const dm_result result = dmi_study_make(arena, b->made.mesh, &b->made.cloud, part, b->made.welded, &b->study);
    if (result != DM_OK) return result;
    dmi_opinion_form(b->net, dmi_cpu_best_isa(), &b->made.cloud, with_drag ? &hint : NULL, b->scratch, &b->opinion);
    const int free = truth.type == DM_JOINT_CONTINUOUS;
    if (free) truth.type = DM_JOINT_REVOLUTE;
    const float unit = dmi_limits_features(&b->study, &b->opinion.prediction, with_drag, &truth,
                                           out->features + (size_t)at * DMI_LIMIT_FEATURES);
    out->lower[at] = truth.lower / unit;
    out->upper[at] = truth.upper / unit;
    out->free[at] = free;
    out->category[at] = (int32_t)b->made.category;
    return DM_OK;
}

dm_result dm_lab_limits_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                              const dm_lab_limits* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    bench* b = dmi_alloc_zeroed(&env, sizeof *b, 64);
    if (b == NULL) return DM_ERROR_OUT_OF_MEMORY;
    b->env = env;
    dm_result result = dmi_kpp_net_load(&b->env, kinematics, kinematics_size, &b->net);
    if (result == DM_OK) b->scratch = dmi_alloc(&b->env, dmi_kpp_net_scratch_size(b->net), 64);
    if (result == DM_OK && b->scratch == NULL) result = DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        result = lab_case_make(&b->env, options, i, &b->made);
        if (result != DM_OK) break;
        dmi_arena arena;
        dmi_arena_init(&arena, &b->env, (size_t)1 << 20);
        result = limits_case(b, &arena, options, out, i);
        dmi_arena_release(&arena);
        lab_case_release(&b->env, &b->made);
    }
    if (b->scratch != NULL) dmi_free(&b->env, b->scratch, dmi_kpp_net_scratch_size(b->net));
    if (b->net != NULL) dmi_kpp_net_destroy(b->net);
    dmi_free(&env, b, sizeof *b);
    return result;
}
