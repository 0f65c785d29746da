/* Writes generated cases' candidates with the ranker's probabilities and the features that asset hints count. */
#include "lab_hints.h"

#include <string.h>

#include "case.h"
#include "hint_draw.h"
#include "kinematics/features/candidate_features.h"
#include "kinematics/features/kpp_ensemble.h"
#include "kinematics/hints/hint_likelihood.h"
#include "kinematics/inference/joint_models.h"
#include "kinematics/ranking/twin_leaves.h"
#include "pose_error.h"
#include "pull.h"

#define FACES_FRONT 0.5f /* share of files whose object faces +Z as glTF says; the others face any side; by hand */
#define BLOCK ((size_t)1 << 20)

typedef struct hint_work {
    dmi_env env;
    dmi_kpp_net* net;
    dmi_joint_models* joints;
    void* scratch;
    size_t scratch_size;
    lab_case made;
    dmi_part_analysis analysis;
    dmi_kpp_ensemble ensemble;
    dmi_candidate candidates[DMI_CANDIDATES_MAX];
    float features[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT];
    float score[DMI_CANDIDATES_MAX], probability[DMI_CANDIDATES_MAX];
    uint32_t count;
} hint_work;

static const char* const kind_features[] = {
    "slide upright", "slide level", "slide oblique", "slide long",   "slide middle", "slide short",
    "turn upright",  "turn level",  "turn oblique",  "turn long",    "turn middle",  "turn short",
    "turn centre",   "turn inside", "turn edge",     "turn outside", "turn top",     "turn bottom",
    "turn outer",    "turn inner",  "turn front",    "turn back"};
static const char* const places[] = {"MIDDLE", "BOTTOM", "TOP", "SIDE", "EDGE", "INSIDE", "OUTSIDE", "DEFAULT"};
static const char* const pivot_features[] = {"slide", "slide aligned", "turn aligned",  "near",
                                             "on",    "on aligned",    "slide through", "on middle"};

const char* dm_lab_hint_name(int32_t which, uint32_t index) {
    if (which == 1) return index < DMI_KIND_FEATURES ? kind_features[index] : NULL;
    if (which == 2) return index < DMI_PIVOT_PLACES ? places[index] : NULL;
    if (which == 3) return index < DMI_PIVOT_FEATURES ? pivot_features[index] : NULL;
    return dmi_kind_name((dmi_part_kind)index);
}

static dm_result open_work(const void* kinematics, size_t kinematics_size, const void* ranker, size_t ranker_size,
                           hint_work** out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    hint_work* work = dmi_alloc_zeroed(&env, sizeof *work, 64);
    if (work == NULL) return DM_ERROR_OUT_OF_MEMORY;
    *out = work;
    dmi_env_init(&work->env, NULL, NULL, NULL);
    dm_result result = dmi_kpp_net_load(&work->env, kinematics, kinematics_size, &work->net);
    if (result == DM_OK) result = dmi_joint_models_load(&work->env, ranker, ranker_size, &work->joints);
    if (result != DM_OK) return result;
    work->scratch_size = dmi_kpp_net_scratch_size(work->net);
    work->scratch = dmi_alloc(&work->env, work->scratch_size, 64);
    return work->scratch != NULL ? DM_OK : DM_ERROR_OUT_OF_MEMORY;
}

static void close_work(hint_work* work) {
    dmi_joint_models_destroy(work->joints);
    if (work->net != NULL) dmi_kpp_net_destroy(work->net);
    dmi_free(&work->env, work->scratch, work->scratch_size);
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_free(&env, work, sizeof *work);
}

/* Ranks the candidates as the library does, those through the pivot among them. */
static dm_result rank(hint_work* w, dmi_arena* arena, uint32_t part, const dmi_drag_hint* drag,
                      const dmi_asset_hints* hints) {
    const dmi_isa isa = dmi_cpu_best_isa();
    const dmi_prediction* prediction = &w->ensemble.prediction;
    const dm_result result =
        dmi_part_analysis_make(arena, w->made.mesh, &w->made.cloud, part, w->made.welded, NULL, &w->analysis);
    if (result != DM_OK) return result;
    dmi_kpp_ensemble_run(w->net, isa, &w->made.cloud, drag, w->scratch, &w->ensemble);
    w->count = dmi_candidates_make(&w->analysis, drag, prediction, w->candidates);
    w->count = dmi_prefilter_keep(&w->joints->prefilter, &w->analysis, drag, w->net, isa, &w->ensemble, w->candidates,
                                  w->count, w->features);
    w->count = dmi_twin_add_candidates(&w->analysis, drag, w->candidates, w->count);
    if (!dmi_asset_hints_are_empty(hints))
        w->count = dmi_hints_add_candidates(hints, &w->analysis, drag, w->candidates, w->count);
    dmi_kpp_ensemble_score(w->net, isa, &w->ensemble, w->candidates, w->count, w->score);
    dmi_candidate_features_make(&w->analysis, drag, prediction, w->score, w->candidates, w->count, w->features);
    dmi_ranker_probabilities(&w->joints->ranker, isa, (const float(*)[DMI_FEATURE_COUNT])w->features, w->count,
                             w->probability);
    dmi_leaves_weigh(&w->analysis, w->candidates, w->count, w->probability);
    return DM_OK;
}

/* Turns the features of front and back as if the object faced any side: its front, a side (neither is known) or its
 * back. */
static uint32_t turn_front(uint32_t bits, uint32_t quarters) {
    const uint32_t front = 1u << DMI_KIND_TURN_FRONT, back = 1u << DMI_KIND_TURN_BACK, rest = bits & ~(front | back);
    if (quarters == 0) return bits;
    if (quarters != 2) return rest;
    return rest | (bits & front ? back : 0) | (bits & back ? front : 0);
}

static void write_case(hint_work* w, const dm_joint* truth, const dmi_drag_hint* drag, const dmi_asset_hints* hints,
                       uint32_t at, const dm_lab_hint_cases* out) {
    const uint32_t used = w->count < out->rows ? w->count : out->rows, first = w->count - used;
    dmi_hint_frame frame;
    lab_pose_target target;
    dmi_hint_frame_make(hints, &w->analysis, &frame);
    lab_pose_target_make(&w->made.cloud, truth, drag->point, &target);
    const int faces_front = lab_random_bool(&w->made.random, FACES_FRONT);
    const uint32_t quarters = faces_front ? 0 : dmi_random_u32(&w->made.random) & 3u;
    for (uint32_t i = 0; i < used; i++) {
        const dmi_candidate* c = &w->candidates[first + i];
        const size_t slot = (size_t)at * out->rows + i;
        out->probability[slot] = w->probability[first + i];
        out->pose[slot] = lab_pose_error(&target, c->type, c->axis, c->origin);
        out->bits[slot] = turn_front(dmi_kind_features(&frame, c), quarters);
        if (hints->has_pivot) dmi_pivot_features(&frame, c, out->pivot + slot * DMI_PIVOT_FEATURES);
    }
    out->used[at] = (int32_t)used;
    out->kind[at] = (int32_t)hints->label.kind;
    out->depth[at] = (int32_t)hints->label.depth;
    out->place[at] = hints->has_pivot ? (int32_t)frame.place : -1;
    out->category[at] = (int32_t)w->made.category_id;
}

static dm_result make_case(hint_work* w, const dm_lab_options* options, const dm_lab_hint_options* shares, uint32_t at,
                           const dm_lab_hint_cases* out) {
    dm_result result = lab_case_make(&w->env, options, at, &w->made);
    if (result != DM_OK) return result;
    dm_joint truth;
    const uint32_t part = (uint32_t)dmi_mesh_find_part(w->made.mesh, w->made.part);
    const dmi_drag_hint drag = lab_case_drag(&w->made, options->pull, options->drag_noise_degrees, &truth);
    const int with_drag = lab_random_bool(&w->made.random, options->with_drag);
    const dmi_asset_hints hints = lab_draw_hints(&w->made.random, &w->made, part, shares);
    dmi_arena arena;
    dmi_arena_init(&arena, &w->env, BLOCK);
    result = rank(w, &arena, part, with_drag ? &drag : NULL, &hints);
    if (result == DM_OK) write_case(w, &truth, &drag, &hints, at, out);
    out->has_drag[at] = with_drag;
    dmi_arena_release(&arena);
    lab_case_release(&w->env, &w->made);
    return result;
}

dm_result dm_lab_hint_batch(const dm_lab_options* options, const dm_lab_hint_options* hints, const void* kinematics,
                            size_t kinematics_size, const void* ranker, size_t ranker_size,
                            const dm_lab_hint_cases* out) {
    hint_work* work = NULL;
    dm_result result = open_work(kinematics, kinematics_size, ranker, ranker_size, &work);
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) result = make_case(work, options, hints, i, out);
    if (work != NULL) close_work(work);
    return result;
}
