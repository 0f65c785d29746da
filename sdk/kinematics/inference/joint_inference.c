/* Joint hypotheses of one part: study, network, candidates, evidence, ranking, residual, limits. */
#include "kinematics/inference/joint_inference.h"

#include "kinematics/candidates/twist.h"
#include "kinematics/features/candidate_features.h"
#include "kinematics/features/kpp_ensemble.h"
#include "kinematics/limits/limits.h"
#include "kinematics/ranking/consensus_refine.h"
#include "math/linear3.h"

#define SCRATCH_BLOCK ((size_t)1 << 20)
#define TOP_OF_TYPE 32 /* candidates of turning, and of sliding, that may become hypotheses */
#define TOP (2 * TOP_OF_TYPE)
/* Shares by which the motions of two joints differ: about the first is as near as an answer has to be, within the
 * second they support one hypothesis, and beyond the third they are worth two. */
#define NEAR 0.03f
#define ALIKE 0.1f
#define APART 0.3f
#define GOOD_ENOUGH 0.9f
#define SCREW_CERTAIN 0.8f
#define LEAST_ROOM 0.1f /* of its range, in the drag's direction */

typedef struct work {
    const dmi_inference_query* query;
    dmi_part_analysis study;
    dmi_kpp_ensemble opinion; /* with a network */
    dmi_candidate candidates[DMI_CANDIDATES_MAX];
    float evidence[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT];
    float score[DMI_CANDIDATES_MAX]; /* by the network */
    float probability[DMI_CANDIDATES_MAX];
    uint32_t count;
} work;

/* NULL: by rules. */
static const dmi_ranker* ranker(const work* w) {
    const dmi_joint_models* models = w->query->models.joints;
    return models != NULL ? &models->ranker : NULL;
}

static const dmi_limit_network* limit_network(const work* w) {
    const dmi_joint_models* models = w->query->models.joints;
    return models != NULL ? &models->limits : NULL;
}

static dm_result predict(dmi_env* env, dmi_arena* arena, work* w) {
    const dmi_inference_query* query = w->query;
    void* scratch = dmi_arena_push(arena, dmi_kpp_net_scratch_size(query->models.kpp));
    if (scratch == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "kinematics: no memory for the network's scratch");
    dmi_kpp_ensemble_run(query->models.kpp, query->models.isa, query->cloud, query->hint, scratch, &w->opinion);
    return DM_OK;
}

/* Keeps the candidates of the type that the host has given. */
static void keep_type(work* w) {
    int32_t type = w->query->given_type;
    if (type == DM_JOINT_UNKNOWN || type == DM_JOINT_FIXED) return;
    int slides = type == DM_JOINT_PRISMATIC;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < w->count; i++)
        if ((w->candidates[i].type == DM_JOINT_PRISMATIC) == slides) w->candidates[kept++] = w->candidates[i];
    if (kept > 0) w->count = kept;
}

typedef struct ranked {
    uint32_t index;
    float weight; /* the probability that it is near enough, whichever candidate is right */
} ranked;

static int slides(const work* w, uint32_t index) {
    return w->candidates[index].type == DM_JOINT_PRISMATIC;
}

/* The most probable candidates of one type, most probable first. */
static uint32_t top_of_type(const work* w, int sliding, ranked out[TOP_OF_TYPE]) {
    uint32_t n = 0;
    for (uint32_t i = 0; i < w->count; i++) {
        float p = w->probability[i];
        if (slides(w, i) != sliding || (n == TOP_OF_TYPE && p <= w->probability[out[n - 1].index])) continue;
        uint32_t at = n < TOP_OF_TYPE ? n++ : TOP_OF_TYPE - 1;
        for (; at > 0 && w->probability[out[at - 1].index] < p; at--) out[at] = out[at - 1];
        out[at].index = i;
    }
    return n;
}

static dm_joint make_joint(const work* w, const dmi_candidate* c, float mass, float type_mass) {
    float confidence = dmi_ranker_confidence(ranker(w), w->query->hint != NULL, mass);
    dm_joint joint = {.type = c->type,
                      .confidence = confidence,
                      .type_confidence = fminf(fmaxf(type_mass, confidence), 1),
                      .axis = {c->axis[0], c->axis[1], c->axis[2]},
                      .origin = {c->origin[0], c->origin[1], c->origin[2]},
                      .source = DM_JOINT_FROM_GEOMETRY};
    if ((c->direction_families & DMI_DIRECTION_NETWORK) != 0 &&
        (c->direction_families & ~(uint32_t)DMI_DIRECTION_NETWORK) == 0)
        joint.source = DM_JOINT_FROM_NETWORK;
    int32_t given = w->query->given_type;
    const dmi_prediction* p = w->query->models.kpp != NULL ? &w->opinion.prediction : NULL;
    if (c->type == DM_JOINT_REVOLUTE &&
        (given == DM_JOINT_SCREW || (given == DM_JOINT_UNKNOWN && p != NULL && p->type[2] > SCREW_CERTAIN))) {
        joint.type = DM_JOINT_SCREW;
        joint.pitch = p != NULL ? (dmi_dot3(p->turn_axis, c->axis) < 0 ? -p->pitch : p->pitch) : 0.02f;
    }
    return joint;
}

/* Of all hypotheses at once. candidates: which of them each is. */
static void set_limits(const work* w, const uint32_t candidates[DM_MAX_HYPOTHESES], dmi_hypotheses* out) {
    const dmi_prediction* p = w->query->models.kpp != NULL ? &w->opinion.prediction : NULL;
    const int32_t given = w->query->given_type;
    const float* evidence[DM_MAX_HYPOTHESES];
    for (uint32_t i = 0; i < out->count; i++) evidence[i] = w->evidence[candidates[i]];
    dmi_limits_set(&w->study, p, w->query->hint != NULL, limit_network(w), w->query->models.isa, evidence, out->joints,
                   out->count);
    for (uint32_t i = 0; i < out->count; i++) {
        dm_joint* joint = &out->joints[i];
        if (given == DM_JOINT_CONTINUOUS || (given == DM_JOINT_REVOLUTE && joint->type == DM_JOINT_CONTINUOUS))
            joint->type = given;
    }
}

/* Everything that choosing works on: the leading candidates, who is alike, what is left. */
typedef struct choice {
    ranked top[TOP];
    float difference[TOP][TOP];
    uint8_t taken[TOP];
    uint32_t count;
    float type_mass[2]; /* of turning, of sliding */
} choice;

static void start_choice(const work* w, choice* c) {
    *c = (choice){.count = 0};
    for (uint32_t i = 0; i < w->count; i++) c->type_mass[slides(w, i)] += w->probability[i];
    c->count = top_of_type(w, 0, c->top);
    c->count += top_of_type(w, 1, c->top + c->count);
    dmi_twist twist[TOP];
    for (uint32_t i = 0; i < c->count; i++)
        dmi_twist_of_candidate(&w->study, &w->candidates[c->top[i].index], &twist[i]);
    for (uint32_t i = 0; i < c->count; i++) {
        c->top[i].weight = 0;
        for (uint32_t j = 0; j < c->count; j++) {
            const float off = c->difference[i][j] = i == j ? 0 : dmi_twist_difference(&twist[i], &twist[j]);
            c->top[i].weight += w->probability[c->top[j].index] * expf(-off * off / (NEAR * NEAR));
        }
    }
}

/* The heaviest candidate left; c->count when none is. only: -1 or a type. */
static uint32_t heaviest(const work* w, int only, const choice* c) {
    uint32_t best = c->count;
    for (uint32_t i = 0; i < c->count; i++) {
        uint32_t index = c->top[i].index;
        if (c->taken[i] || (only >= 0 && slides(w, index) != only)) continue;
        if (best == c->count || c->top[i].weight > c->top[best].weight * 1.0001f) best = i;
    }
    return best;
}

/* Of the candidates in the same place that are nearly as good, the most probable: where a line or direction of the
 * geometry is meant, it is met exactly. */
static uint32_t sharpen(const work* w, uint32_t best, const choice* c) {
    uint32_t sharp = best;
    for (uint32_t i = 0; i < c->count; i++) {
        if (c->taken[i] || c->difference[best][i] > NEAR || c->top[i].weight < GOOD_ENOUGH * c->top[best].weight)
            continue;
        if (w->probability[c->top[i].index] > w->probability[c->top[sharp].index]) sharp = i;
    }
    return sharp;
}

/* Takes a candidate and all that are not worth a hypothesis beside it; answers the probability of those that move the
 * part alike. */
static float take_alike(const work* w, uint32_t chosen, choice* c) {
    float mass = 0;
    for (uint32_t j = 0; j < c->count; j++) {
        if (c->taken[j] || c->difference[chosen][j] > APART) continue;
        if (c->difference[chosen][j] <= ALIKE) mass += w->probability[c->top[j].index];
        c->taken[j] = 1;
    }
    return mass;
}

/* The chosen candidate and those that move the part much as it does, by how likely they are. The rules' scores are no
 * probabilities: with them the candidate stays as it is. */
static void refine(const work* w, uint32_t chosen, const choice* c, dm_joint* joint) {
    dmi_weighted_candidate voices[TOP_OF_TYPE];
    uint32_t count = 0;
    const dmi_candidate* winner = &w->candidates[c->top[chosen].index];
    if (ranker(w) == NULL) return;
    for (uint32_t i = 0; i < c->count; i++) {
        const uint32_t index = c->top[i].index;
        const float off = c->difference[chosen][i] / ALIKE;
        if (!dmi_consensus_counts(winner, &w->candidates[index])) continue;
        voices[count++] = (dmi_weighted_candidate){&w->candidates[index], w->probability[index] * expf(-off * off)};
    }
    dmi_consensus_refine(winner, voices, count, joint);
}

/* Signs a joint along the drag. A part that is being dragged has room that way: when its limits leave none there, the
 * sweep has mistaken the side. */
static void follow(const dmi_drag_hint* hint, dm_joint* joint) {
    dmi_joint_orient(joint, hint);
    if (joint->type == DM_JOINT_CONTINUOUS || joint->upper > LEAST_ROOM * (joint->upper - joint->lower)) return;
    joint->upper = -joint->lower, joint->lower = 0;
}

/* Not the most probable candidate but the one that is most probably near enough: of several lines in the same place,
 * each a little likely, one in their midst. The first hypothesis is of the likelier type (the rules' scores are no
 * probabilities, they can't say): turns are many candidates that share their probability, slides few, so that a single
 * slide outweighs each turn long before slides outweigh turns. */
static void choose(const work* w, dmi_hypotheses* out) {
    choice c;
    uint32_t chosen[DM_MAX_HYPOTHESES];
    start_choice(w, &c);
    out->count = 0;
    float least = 1; /* no alternative is stated likelier than what goes before it */
    while (out->count < DM_MAX_HYPOTHESES) {
        int only = out->count > 0 || ranker(w) == NULL ? -1 : c.type_mass[1] > c.type_mass[0];
        uint32_t best = heaviest(w, only, &c);
        if (best == c.count) break;
        best = sharpen(w, best, &c);
        uint32_t index = c.top[best].index;
        least = fminf(least, take_alike(w, best, &c));
        chosen[out->count] = index;
        dm_joint* joint = &out->joints[out->count++];
        *joint = make_joint(w, &w->candidates[index], least, c.type_mass[slides(w, index)]);
        refine(w, best, &c, joint);
    }
    set_limits(w, chosen, out);
}

static void gather_evidence(work* w, const dmi_prediction* prediction) {
    const dmi_inference_query* query = w->query;
    if (prediction != NULL)
        dmi_kpp_ensemble_score(query->models.kpp, query->models.isa, &w->opinion, w->candidates, w->count, w->score);
    dmi_candidate_features_make(&w->study, query->hint, prediction, prediction != NULL ? w->score : NULL, w->candidates,
                                w->count, w->evidence);
}

/* The plain KPP-Net; a given type is certain. The evidence is for the limits. */
static void ask_network(work* w) {
    int32_t type = w->query->given_type;
    dmi_prediction_candidates(&w->opinion.prediction, w->study.centre, w->candidates, w->probability);
    w->count = 2;
    gather_evidence(w, &w->opinion.prediction);
    if (type == DM_JOINT_UNKNOWN || type == DM_JOINT_FIXED) return;
    w->probability[1] = type == DM_JOINT_PRISMATIC ? 1 : 0;
    w->probability[0] = 1 - w->probability[1];
}

/* Of a thousand candidates all but a few hundred can be told at a glance to be wrong. */
static void sift(work* w) {
    const dmi_inference_query* query = w->query;
    if (query->models.joints == NULL) return;
    w->count = dmi_prefilter_keep(&query->models.joints->prefilter, &w->study, query->hint, query->models.kpp,
                                  query->models.isa, query->models.kpp != NULL ? &w->opinion : NULL, w->candidates,
                                  w->count, w->evidence);
}

static void rank_candidates(work* w, const dmi_prediction* prediction) {
    const dmi_inference_query* query = w->query;
    w->count = dmi_candidates_make(&w->study, query->hint, prediction, w->candidates);
    keep_type(w);
    sift(w);
    gather_evidence(w, prediction);
    dmi_ranker_probabilities(ranker(w), query->models.isa, (const float(*)[DMI_FEATURE_COUNT])w->evidence, w->count,
                             w->probability);
}

/* None of screws, whose pitch no geometry tells; the plain network has none. */
static dm_result find_alternatives(dmi_arena* arena, const work* w, const dmi_hypotheses* hypotheses,
                                   dmi_alternatives* out) {
    const int32_t given = w->query->given_type;
    out->count = 0;
    if (given == DM_JOINT_SCREW || w->query->network_alone) return DM_OK;
    const dm_result result =
        dmi_alternatives_find(arena, &w->study, ranker(w), w->query->hint != NULL, hypotheses->joints,
                              hypotheses->count, w->candidates, w->probability, w->count, out);
    for (uint32_t i = 0; i < out->count; i++)
        if (given == DM_JOINT_CONTINUOUS) out->list[i].type = given;
    return result;
}

static dm_result infer(dmi_env* env, dmi_arena* arena, const dmi_inference_query* query, dmi_hypotheses* out,
                       dmi_alternatives* out_alternatives) {
    work* w = dmi_arena_push(arena, sizeof *w);
    if (w == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "kinematics: no memory for %zu bytes of scratch", sizeof *w);
    w->query = query;
    dm_result result = dmi_part_analysis_make(arena, query->mesh, query->cloud, query->part, query->welded, &w->study);
    if (result == DM_ERROR_OUT_OF_MEMORY)
        return dmi_fail(env, result, "kinematics: no memory to study part %u", query->mesh->parts[query->part].id);
    if (result != DM_OK) return result;
    if (query->models.kpp != NULL) result = predict(env, arena, w);
    if (result != DM_OK) return result;
    const dmi_prediction* prediction = query->models.kpp != NULL ? &w->opinion.prediction : NULL;
    if (query->network_alone && prediction != NULL)
        ask_network(w);
    else
        rank_candidates(w, prediction);
    choose(w, out);
    if (query->hint != NULL)
        for (uint32_t i = 0; i < out->count; i++) follow(query->hint, &out->joints[i]);
    return out_alternatives != NULL ? find_alternatives(arena, w, out, out_alternatives) : DM_OK;
}

dm_result dmi_joint_inference_run(dmi_env* env, const dmi_inference_query* query, dmi_hypotheses* out_hypotheses,
                                  dmi_alternatives* out_alternatives) {
    dmi_arena own, *arena = query->scratch != NULL ? query->scratch : &own;
    dmi_arena_init(&own, env, SCRATCH_BLOCK);
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dm_result result = infer(env, arena, query, out_hypotheses, out_alternatives);
    dmi_arena_rewind(arena, mark);
    dmi_arena_release(&own);
    return result;
}
