/* Candidates of generated cases with their evidence and their true cost, made by the library's own kinematics. */
#include "lab_ranker.h"

#include <math.h>
#include <string.h>

#include "case.h"
#include "goal.h"
#include "kinematics/evidence.h"
#include "kinematics/kinematics.h"
#include "kinematics/opinion.h"
#include "kinematics/sieve.h"
#include "math/linear3.h"

#define KEPT_BEST 8
#define SIEVE_VERSION 1
#define EXACT_DRAGS 0.4f

typedef struct ranker_case {
    lab_case made;
    dmi_study study;
    dmi_opinion opinion; /* with a network */
    dmi_candidate candidates[DMI_CANDIDATES_MAX];
    float evidence[DMI_CANDIDATES_MAX][DMI_EVIDENCE_COUNT];
    float score[DMI_CANDIDATES_MAX], pose[DMI_CANDIDATES_MAX];
    uint32_t order[DMI_CANDIDATES_MAX];
    uint32_t count;
    dm_joint joint; /* the true one, positive along the drag */
    dmi_drag_hint hint;
} ranker_case;

/* What both entries need beside their cases. */
typedef struct bench {
    dmi_env env;
    dmi_kpp_net* net;
    dmi_sieve* sieve; /* NULL: all candidates are judged */
    void* scratch;
    size_t scratch_size;
    ranker_case* work;
} bench;

uint32_t dm_lab_ranker_columns(void) {
    return DMI_EVIDENCE_COUNT;
}

uint32_t dm_lab_sieve_columns(uint8_t* out) {
    if (out != NULL) memcpy(out, dmi_glance_columns, sizeof dmi_glance_columns);
    return DMI_GLANCE_COLUMNS;
}

static void axis_of(const dm_joint* joint, float axis[3], float origin[3]) {
    axis[0] = joint->axis.x, axis[1] = joint->axis.y, axis[2] = joint->axis.z;
    origin[0] = joint->origin.x, origin[1] = joint->origin.y, origin[2] = joint->origin.z;
}

static void label(ranker_case* r) {
    lab_goal goal;
    lab_goal_make(&r->made.cloud, &r->joint, r->hint.point, &goal);
    for (uint32_t i = 0; i < r->count; i++) {
        const dmi_candidate* c = &r->candidates[i];
        r->pose[i] = lab_goal_error(&goal, c->type, c->axis, c->origin);
    }
}

/* Candidates of a case with their evidence and labels. hint: NULL when the kinematics gets no drag; r->hint labels. */
static dm_result judge_case(bench* b, dmi_arena* arena, const dmi_drag_hint* hint, ranker_case* r) {
    const dmi_kpp_net* net = b->net;
    const uint32_t part = (uint32_t)dmi_mesh_find_part(r->made.mesh, r->made.part);
    dm_result result = dmi_study_make(arena, r->made.mesh, &r->made.cloud, part, r->made.welded, &r->study);
    if (result != DM_OK) return dmi_fail(&b->env, result, "lab: a case can't be studied");
    const dmi_isa isa = dmi_cpu_best_isa();
    if (net != NULL) dmi_opinion_form(net, isa, &r->made.cloud, hint, b->scratch, &r->opinion);
    const dmi_prediction* prediction = net != NULL ? &r->opinion.prediction : NULL;
    r->count = dmi_candidates_make(&r->study, hint, prediction, r->candidates);
    if (b->sieve != NULL)
        r->count = dmi_sieve_keep(b->sieve, &r->study, hint, net, isa, net != NULL ? &r->opinion : NULL, r->candidates,
                                  r->count, r->evidence);
    if (net != NULL) dmi_opinion_score(net, isa, &r->opinion, r->candidates, r->count, r->score);
    dmi_evidence_make(&r->study, hint, prediction, net != NULL ? r->score : NULL, r->candidates, r->count, r->evidence);
    label(r);
    return DM_OK;
}

/* The best few first, then the others in random order. */
static void order_rows(ranker_case* r) {
    for (uint32_t i = 0; i < r->count; i++) r->order[i] = i;
    for (uint32_t i = 0; i < r->count && i < KEPT_BEST; i++)
        for (uint32_t j = i + 1; j < r->count; j++)
            if (r->pose[r->order[j]] < r->pose[r->order[i]]) {
                const uint32_t swap = r->order[i];
                r->order[i] = r->order[j], r->order[j] = swap;
            }
    for (uint32_t i = KEPT_BEST; i < r->count; i++) {
        const uint32_t j = i + dmi_random_u32(&r->made.random) % (r->count - i), swap = r->order[i];
        r->order[i] = r->order[j], r->order[j] = swap;
    }
}

static void write_case(const ranker_case* r, int with_drag, const dm_lab_ranker* out, uint32_t at) {
    const uint32_t rows = r->count < out->rows ? r->count : out->rows;
    float axis[3], origin[3];
    axis_of(&r->joint, axis, origin);
    for (uint32_t i = 0; i < rows; i++) {
        const uint32_t k = r->order[i], slot = at * out->rows + i;
        const dmi_candidate* c = &r->candidates[k];
        memcpy(out->evidence + (size_t)slot * DMI_EVIDENCE_COUNT, r->evidence[k], sizeof r->evidence[k]);
        out->pose[slot] = r->pose[k];
        out->axis_error[slot] = acosf(fminf(fabsf(dmi_dot3(axis, c->axis)), 1));
        out->line_error[slot] = c->type == DM_JOINT_PRISMATIC ? 0 : dmi_line_distance3(c->origin, axis, origin);
    }
    out->used[at] = (int32_t)rows;
    out->total[at] = (int32_t)r->count;
    out->type[at] = r->joint.type - 1;
    out->has_drag[at] = with_drag;
    out->category[at] = (int32_t)r->made.category;
    out->best[at] = r->pose[r->order[0]];
}

static dm_result write_judged(bench* b, int with_drag, const dm_lab_ranker* out, uint32_t at) {
    ranker_case* r = b->work;
    dmi_arena arena;
    dmi_arena_init(&arena, &b->env, (size_t)1 << 20);
    const dm_result result = judge_case(b, &arena, with_drag ? &r->hint : NULL, r);
    if (result == DM_OK) {
        order_rows(r);
        write_case(r, with_drag, out, at);
    }
    dmi_arena_release(&arena);
    return result;
}

static dm_result make_cases(bench* b, const dm_lab_options* options, const dm_lab_ranker* out) {
    ranker_case* r = b->work;
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        result = lab_case_make(&b->env, options, i, &r->made);
        if (result != DM_OK) break;
        /* Some drags are exact: a host may hand over a tangent that it has computed. */
        const float noise = lab_chance(&r->made.random, EXACT_DRAGS) ? 0 : options->drag_noise_degrees;
        r->hint = lab_case_drag(&r->made, noise, &r->joint);
        const int with_drag = lab_chance(&r->made.random, options->with_drag);
        result = write_judged(b, with_drag, out, i);
        lab_case_release(&b->env, &r->made);
    }
    return result;
}

static void bench_close(bench* b) {
    dmi_free(&b->env, b->work, sizeof *b->work);
    dmi_free(&b->env, b->scratch, b->scratch_size);
    dmi_free(&b->env, b->sieve, sizeof *b->sieve);
    dmi_kpp_net_destroy(b->net);
}

static dm_result bench_open(const void* kinematics, size_t size, bench* b) {
    *b = (bench){0};
    dmi_env_init(&b->env, NULL, NULL, NULL);
    if (kinematics != NULL) {
        const dm_result result = dmi_kpp_net_load(&b->env, kinematics, size, &b->net);
        if (result != DM_OK) return result;
    }
    b->scratch_size = b->net != NULL ? dmi_kpp_net_scratch_size(b->net) : 64;
    b->scratch = dmi_alloc(&b->env, b->scratch_size, 64);
    b->work = dmi_alloc(&b->env, sizeof *b->work, 64);
    if (b->scratch != NULL && b->work != NULL) return DM_OK;
    bench_close(b);
    return DM_ERROR_OUT_OF_MEMORY;
}

static dm_result open_sieve(bench* b, const void* data, size_t size) {
    dmi_weights* weights;
    const dm_result result = dmi_weights_open(&b->env, data, size, "dragmesh-sieve", SIEVE_VERSION, &weights);
    if (result != DM_OK) return result;
    b->sieve = dmi_alloc(&b->env, sizeof *b->sieve, 64);
    const int read = b->sieve != NULL && dmi_sieve_read(weights, b->sieve);
    dmi_weights_close(weights);
    return read ? DM_OK : dmi_fail(&b->env, DM_ERROR_WRONG_MODEL, "lab: no sieve in the file, or no memory for it");
}

dm_result dm_lab_ranker_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                              const void* sieve, size_t sieve_size, const dm_lab_ranker* out) {
    bench b;
    dm_result result = bench_open(kinematics, kinematics_size, &b);
    if (result != DM_OK) return result;
    if (sieve != NULL) result = open_sieve(&b, sieve, sieve_size);
    if (result == DM_OK) result = make_cases(&b, options, out);
    bench_close(&b);
    return result;
}

dm_result dm_lab_ranker_given(const dm_lab_given* given, int32_t with_drag, const void* kinematics,
                              size_t kinematics_size, const dm_lab_ranker* out) {
    bench b;
    dm_result result = bench_open(kinematics, kinematics_size, &b);
    if (result != DM_OK) return result;
    ranker_case* r = b.work;
    memset(&r->made, 0, sizeof r->made);
    result = lab_case_given(&b.env, given, &r->made);
    if (result == DM_OK) {
        r->hint = lab_given_drag(&r->made, given, 0, &r->joint);
        result = write_judged(&b, with_drag, out, 0);
        dmi_mesh_destroy(&b.env, r->made.mesh);
    }
    bench_close(&b);
    return result;
}
