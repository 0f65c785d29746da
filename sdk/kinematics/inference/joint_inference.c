/* Infers joints in order: part analysis, KPP-Net, candidates, prefilter, features, ranking, selection, limits. */
#include "kinematics/inference/joint_inference.h"

#include <float.h>

#include "kinematics/features/candidate_features.h"
#include "kinematics/features/kpp_ensemble.h"
#include "kinematics/hints/hint_likelihood.h"
#include "kinematics/inference/hypothesis_selection.h"
#include "kinematics/limits/limits.h"
#include "kinematics/limits/sweep.h"
#include "kinematics/ranking/twin_leaves.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define SCRATCH_BLOCK ((size_t)1 << 20)
#define SCREW_CERTAIN 0.8f /* KPP-Net's probability from which a turn is a screw; by hand */
#define USUAL_PITCH 0.02f  /* object sizes a radian, of a screw that no network knows; by hand */
#define LEAST_ROOM 0.1f    /* least share of a joint's range that lies in the drag's direction; by hand */

/* Slope and offset of the log odds of a dragged part's confidence when the object has no body, which no training case
 * lacks. Fitted on the parts of 99 generated objects, each alone, and rounded. */
#define ALONE_SLOPE 2.0f
#define ALONE_OFFSET (-2.0f)

/* What makes a drag a straight pull. */
#define EXPLAINED 1e-3f  /* rad: the drag's angle as a feature, where a candidate explains the drag; by hand */
#define LEAST_BEND 0.05f /* rad between the drag and the first movement; a smaller angle is a hand's error; by hand */
/* Share of the part's farthest distance from the axis, from which on a hand pulls straight: it takes hold of the far
 * end or a handle. A hand that holds nearer to the axis gives the exact drag of another joint (measured: slides that
 * are dragged along the room). */
#define FAR_OUT 0.9f

typedef struct work {
    const dmi_inference_query* query;
    dmi_part_analysis analysis;
    dmi_kpp_ensemble ensemble; /* answers of KPP-Net, where there is one */
    dmi_candidate candidates[DMI_CANDIDATES_MAX];
    float features[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT];
    float score[DMI_CANDIDATES_MAX]; /* KPP-Net's scores */
    float probability[DMI_CANDIDATES_MAX];
    uint32_t count;
} work;

/* Returns the ranker, or NULL when rules take its place. */
static const dmi_ranker* ranker(const work* w) {
    const dmi_joint_models* models = w->query->models.joints;
    return models != NULL ? &models->ranker : NULL;
}

/* Returns the limit networks, or NULL when rules take their place. */
static const dmi_limit_network* limit_network(const work* w) {
    const dmi_joint_models* models = w->query->models.joints;
    return models != NULL ? &models->limits : NULL;
}

/* Returns KPP-Net's prediction, or NULL when there is no KPP-Net. */
static const dmi_prediction* prediction(const work* w) {
    return w->query->models.kpp != NULL ? &w->ensemble.prediction : NULL;
}

/* Runs KPP-Net. hint: the drag as the network is given it; NULL: none. */
static dm_result run_kpp_net(dmi_env* env, dmi_arena* arena, const dmi_drag_hint* hint, work* w) {
    const dmi_inference_query* query = w->query;
    if (query->models.kpp == NULL) return DM_OK;
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    void* scratch = dmi_arena_push(arena, dmi_kpp_net_scratch_size(query->models.kpp));
    if (scratch == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "kinematics: no memory for KPP-Net's scratch");
    const bool is_run =
        dmi_kpp_ensemble_run(query->models.kpp, query->models.isa, query->cloud, hint, scratch, &w->ensemble);
    dmi_arena_rewind(arena, mark);
    if (is_run) return DM_OK;
    return dmi_fail(env, DM_ERROR_BAD_DATA, "kinematics: KPP-Net's weights overflow");
}

/* Keeps the candidates of the type that the host has given. */
static void keep_given_type(work* w) {
    const int32_t type = w->query->given_type;
    if (type == DM_JOINT_UNKNOWN || type == DM_JOINT_FIXED) return;
    const bool slides = type == DM_JOINT_PRISMATIC;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < w->count; i++)
        if ((w->candidates[i].type == DM_JOINT_PRISMATIC) == slides) w->candidates[kept++] = w->candidates[i];
    if (kept > 0) w->count = kept;
}

static void prefilter_candidates(work* w) {
    const dmi_inference_query* query = w->query;
    if (query->models.joints == NULL) return;
    w->count = dmi_prefilter_keep(&query->models.joints->prefilter, &w->analysis, query->hint, query->models.kpp,
                                  query->models.isa, query->models.kpp != NULL ? &w->ensemble : NULL, w->candidates,
                                  w->count, w->features);
}

static void measure_features(work* w) {
    const dmi_inference_query* query = w->query;
    const bool scored = query->models.kpp != NULL;
    if (scored)
        dmi_kpp_ensemble_score(query->models.kpp, query->models.isa, &w->ensemble, w->candidates, w->count, w->score);
    dmi_candidate_features_make(&w->analysis, query->hint, prediction(w), scored ? w->score : NULL, w->candidates,
                                w->count, w->features);
}

/* Multiplies probabilities by what a twin beside the part or a frame around it, names and a pivot say. */
static void weigh_by_evidence(const work* w, float* probability) {
    const dmi_asset_hints* asset = w->query->asset_hints;
    dmi_leaves_weigh(&w->analysis, w->candidates, w->count, probability);
    if (!dmi_asset_hints_are_empty(asset))
        dmi_hints_weigh(asset, &w->analysis, w->query->hint, w->candidates, w->count, probability);
}

static void rank_candidates(work* w) {
    const dmi_asset_hints* asset = w->query->asset_hints;
    w->count = dmi_candidates_make(&w->analysis, w->query->hint, prediction(w), w->candidates);
    keep_given_type(w);
    prefilter_candidates(w);
    w->count = dmi_twin_add_candidates(&w->analysis, w->query->hint, w->candidates, w->count);
    if (!dmi_asset_hints_are_empty(asset))
        w->count = dmi_hints_add_candidates(asset, &w->analysis, w->query->hint, w->candidates, w->count);
    keep_given_type(w);
    measure_features(w);
    dmi_ranker_probabilities(ranker(w), w->query->models.isa, (const float(*)[DMI_FEATURE_COUNT])w->features, w->count,
                             w->probability);
    weigh_by_evidence(w, w->probability);
}

bool dmi_straight_pull_read(const dmi_candidate* candidate, const float features[DMI_FEATURE_COUNT],
                            const dmi_drag_hint* hint, dmi_drag_hint* out_hint) {
    if (features[DMI_FEATURE_DRAG_ANGLE] > EXPLAINED || features[DMI_FEATURE_DRAG_REACH] < FAR_OUT) return false;
    float way[3];
    dmi_candidate_velocity(candidate, hint->point, way);
    const float speed = dmi_max(dmi_length3(way), FLT_MIN), length = dmi_length3(hint->vector);
    const float cosine = dmi_dot3(way, hint->vector) / dmi_max(speed * length, FLT_MIN);
    if (dmi_acosf(dmi_max(dmi_min(cosine, 1), -1)) < LEAST_BEND) return false;
    *out_hint = *hint;
    for (int k = 0; k < 3; k++) out_hint->vector[k] = length / speed * way[k];
    return true;
}

/* Finds the first movement that the drag means, where it is a straight pull of the likeliest joint by geometry alone.
 * Returns whether it is. */
static bool read_straight_pull(const work* w, dmi_drag_hint* out_hint) {
    if (w->query->hint == NULL || prediction(w) == NULL || ranker(w) == NULL) return false;
    float probability[DMI_CANDIDATES_MAX];
    dmi_selected selected[DM_MAX_HYPOTHESES];
    const dmi_ranked_candidates ranked = {&w->analysis, w->candidates, probability, w->count};
    dmi_ranker_geometry_probabilities(ranker(w), w->query->models.isa, (const float(*)[DMI_FEATURE_COUNT])w->features,
                                      w->count, probability);
    dmi_leaves_weigh(&w->analysis, w->candidates, w->count, probability);
    if (dmi_select_hypotheses(&ranked, DMI_SELECT_LIKELIER_TYPE_FIRST, selected) == 0) return false;
    return dmi_straight_pull_read(selected[0].candidate, w->features[selected[0].index], w->query->hint, out_hint);
}

/* Infers the joint from candidates. KPP-Net knows only drags along the first movement. It takes another joint when it
 * is given a straight pull, so it is asked again with what geometry makes of the pull. */
static dm_result infer_from_candidates(dmi_env* env, dmi_arena* arena, work* w) {
    dmi_drag_hint first_movement;
    rank_candidates(w);
    if (!read_straight_pull(w, &first_movement)) return DM_OK;
    const dm_result result = run_kpp_net(env, arena, &first_movement, w);
    if (result == DM_OK) rank_candidates(w);
    return result;
}

/* Makes two candidates of KPP-Net's regression, a turn and a slide, with its probabilities. A type that the host has
 * given has probability 1. The features are computed for the limits. */
static void take_network_answers(work* w) {
    const int32_t type = w->query->given_type;
    dmi_prediction_candidates(prediction(w), w->analysis.centre, w->candidates, w->probability);
    w->count = 2;
    measure_features(w);
    if (type == DM_JOINT_UNKNOWN || type == DM_JOINT_FIXED) return;
    w->probability[1] = type == DM_JOINT_PRISMATIC ? 1 : 0;
    w->probability[0] = 1 - w->probability[1];
}

static bool suggested_by_network_alone(const dmi_candidate* c) {
    return c->direction_families == DMI_DIRECTION_NETWORK;
}

static void make_screw(const dmi_prediction* p, const dmi_candidate* c, dm_joint* joint) {
    joint->type = DM_JOINT_SCREW;
    joint->pitch = p != NULL ? (dmi_dot3(p->turn_axis, c->axis) < 0 ? -p->pitch : p->pitch) : USUAL_PITCH;
}

static float confidence_of(const work* w, float mass) {
    const bool has_drag = w->query->hint != NULL, is_alone = w->analysis.area_ratio <= 0;
    const float confidence = dmi_ranker_confidence(ranker(w), has_drag, mass);
    if (!has_drag || !is_alone || ranker(w) == NULL) return confidence;
    const float log_odds = dmi_logf(dmi_max(confidence, FLT_MIN)) - dmi_logf(dmi_max(1 - confidence, FLT_MIN));
    return 1 / (1 + dmi_expf(-ALONE_SLOPE * log_odds - ALONE_OFFSET));
}

static dm_joint make_joint(const work* w, const dmi_selected* selected) {
    const dmi_candidate* c = selected->candidate;
    const float confidence = confidence_of(w, selected->mass);
    dm_joint joint = {.type = c->type,
                      .joint_confidence = confidence,
                      .type_confidence = dmi_fminf(dmi_fmaxf(selected->type_mass, confidence), 1),
                      .axis = {c->axis[0], c->axis[1], c->axis[2]},
                      .origin = {c->origin[0], c->origin[1], c->origin[2]},
                      .source = suggested_by_network_alone(c) ? DM_JOINT_FROM_NETWORK : DM_JOINT_FROM_GEOMETRY};
    const int32_t given = w->query->given_type;
    const dmi_prediction* p = prediction(w);
    const bool screws = given == DM_JOINT_SCREW ||
                        (given == DM_JOINT_UNKNOWN && p != NULL && p->type[DM_JOINT_SCREW - 1] > SCREW_CERTAIN);
    if (c->type == DM_JOINT_REVOLUTE && screws) make_screw(p, c, &joint);
    /* Rules' scores are no probabilities: with them the candidate stays as it is. */
    if (ranker(w) != NULL) dmi_consensus_refine(c, selected->support, selected->support_count, &joint);
    return joint;
}

/* Brings the range of a part that rests open to where it is closed. faces_open: the longer way is to be positive. */
static void reach_closed(const dmi_part_analysis* analysis, bool faces_open, dm_joint* joint) {
    float closed;
    if (!dmi_closed_pose_find(analysis, joint, &closed)) return;
    joint->closed = closed;
    if (closed < 0) joint->lower = closed, joint->upper = dmi_fmaxf(joint->upper, 0);
    if (closed > 0) joint->upper = closed, joint->lower = dmi_fminf(joint->lower, 0);
    if (faces_open && -joint->lower > joint->upper) dmi_joint_reverse(joint);
}

static void set_limits(const work* w, const dmi_selected* selected, dmi_hypotheses* out) {
    const int32_t given = w->query->given_type;
    const float* features[DM_MAX_HYPOTHESES];
    for (uint32_t i = 0; i < out->count; i++) features[i] = w->features[selected[i].index];
    dmi_limits_set(&w->analysis, prediction(w), w->query->hint != NULL, limit_network(w), w->query->models.isa,
                   features, out->joints, out->count);
    for (uint32_t i = 0; i < out->count; i++) {
        dm_joint* joint = &out->joints[i];
        if (dmi_joint_has_limits(joint)) reach_closed(&w->analysis, w->query->hint == NULL, joint);
        if (given == DM_JOINT_CONTINUOUS || (given == DM_JOINT_REVOLUTE && joint->type == DM_JOINT_CONTINUOUS))
            joint->type = given;
    }
}

/* Signs a joint along the drag. A dragged part can move along the drag. Where the limits leave no room there, they are
 * mirrored, because the sweep found the wrong side. */
static void follow_drag(const dmi_drag_hint* hint, dm_joint* joint) {
    dmi_joint_orient(joint, hint);
    if (joint->type == DM_JOINT_CONTINUOUS || joint->closed != 0 ||
        joint->upper > LEAST_ROOM * (joint->upper - joint->lower))
        return;
    joint->upper = -joint->lower, joint->lower = 0;
}

/* Returns the rule of the selection. It goes by pose where names or a pivot say something and no drag does; without
 * either, that loses on the development set (measured: docs/research/trials_joints.md). */
static dmi_selection_rule selection_rule(const work* w) {
    if (ranker(w) == NULL) return DMI_SELECT_HEAVIEST;
    const bool by_asset = w->query->hint == NULL && !dmi_asset_hints_are_empty(w->query->asset_hints);
    return by_asset ? DMI_SELECT_BY_POSE : DMI_SELECT_LIKELIER_TYPE_FIRST;
}

static void make_hypotheses(const work* w, dmi_hypotheses* out) {
    const dmi_ranked_candidates ranked = {&w->analysis, w->candidates, w->probability, w->count};
    dmi_selected selected[DM_MAX_HYPOTHESES];
    out->count = dmi_select_hypotheses(&ranked, selection_rule(w), selected);
    for (uint32_t i = 0; i < out->count; i++) out->joints[i] = make_joint(w, &selected[i]);
    set_limits(w, selected, out);
    for (uint32_t i = 0; w->query->hint != NULL && i < out->count; i++) follow_drag(w->query->hint, &out->joints[i]);
}

/* Finds alternatives. There are none for screws, whose pitch geometry does not tell, and none for KPP-Net alone. */
static dm_result find_alternatives(dmi_arena* arena, const work* w, const dmi_hypotheses* hypotheses,
                                   dmi_alternatives* out) {
    const int32_t given = w->query->given_type;
    out->count = 0;
    if (given == DM_JOINT_SCREW || w->query->network_alone) return DM_OK;
    const dm_result result =
        dmi_alternatives_find(arena, &w->analysis, ranker(w), w->query->hint != NULL, hypotheses->joints,
                              hypotheses->count, w->candidates, w->probability, w->count, out);
    for (uint32_t i = 0; i < out->count; i++)
        if (given == DM_JOINT_CONTINUOUS) out->list[i].type = given;
    return result;
}

static void find_free_ranges(const work* w, dmi_hypotheses* hypotheses, dmi_alternatives* alternatives) {
    for (uint32_t i = 0; i < hypotheses->count; i++)
        hypotheses->free_range[i] = dmi_free_range_of(&w->analysis, &hypotheses->joints[i]);
    if (alternatives == NULL) return;
    for (uint32_t i = 0; i < alternatives->count; i++) {
        dmi_alternative* one = &alternatives->list[i];
        const dm_joint joint = {.type = one->type,
                                .axis = {one->axis[0], one->axis[1], one->axis[2]},
                                .origin = {one->origin[0], one->origin[1], one->origin[2]}};
        one->free_range = dmi_free_range_of(&w->analysis, &joint);
    }
    for (int i = 0; i < 3; i++) {
        const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {i == 0, i == 1, i == 2}};
        alternatives->slides[i] = dmi_free_range_of(&w->analysis, &slide);
    }
}

static bool is_finite(const dm_joint* joint) {
    const dm_vec3 a = joint->axis, o = joint->origin;
    return isfinite(joint->type_confidence) && isfinite(joint->joint_confidence) && isfinite(joint->pitch) &&
           isfinite(a.x) && isfinite(a.y) && isfinite(a.z) && isfinite(o.x) && isfinite(o.y) && isfinite(o.z) &&
           isfinite(joint->lower) && isfinite(joint->upper);
}

/* Returns whether all numbers are finite. Weights are, but what networks make of them may not be. */
static bool are_finite(const dmi_hypotheses* hypotheses, const dmi_alternatives* alternatives) {
    for (uint32_t i = 0; i < hypotheses->count; i++)
        if (!is_finite(&hypotheses->joints[i])) return false;
    for (uint32_t i = 0; alternatives != NULL && i < alternatives->count; i++) {
        const dm_joint joint = dmi_alternative_joint(&alternatives->list[i]);
        if (!is_finite(&joint)) return false;
    }
    return true;
}

static dm_result infer_joint(dmi_env* env, dmi_arena* arena, const dmi_inference_query* query, dmi_hypotheses* out,
                             dmi_alternatives* out_alternatives) {
    work* w = dmi_arena_push(arena, sizeof *w);
    if (w == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "kinematics: no memory for %zu bytes of scratch", sizeof *w);
    w->query = query;
    const dmi_progress analysing = dmi_progress_piece(query->progress, 0, DMI_STAGE_INFER_ANALYSED);
    dm_result result =
        dmi_part_analysis_make(arena, query->mesh, query->cloud, query->part, query->welded, &analysing, &w->analysis);
    if (result == DM_ERROR_OUT_OF_MEMORY)
        return dmi_fail(env, result, "kinematics: no memory to analyse part %u", query->mesh->parts[query->part].id);
    if (result == DM_OK) result = dmi_progress_tell(query->progress, DMI_STAGE_INFER_ANALYSED);
    if (result == DM_OK) result = run_kpp_net(env, arena, query->hint, w);
    if (result == DM_OK) result = dmi_progress_tell(query->progress, DMI_STAGE_INFER_NETWORK_RUN);
    if (result != DM_OK) return result;
    if (query->network_alone && query->models.kpp != NULL)
        take_network_answers(w);
    else
        result = infer_from_candidates(env, arena, w);
    if (result == DM_OK) result = dmi_progress_tell(query->progress, DMI_STAGE_INFER_RANKED);
    if (result != DM_OK) return result;
    make_hypotheses(w, out);
    if (out_alternatives != NULL) result = find_alternatives(arena, w, out, out_alternatives);
    if (result != DM_OK) return result;
    if (!are_finite(out, out_alternatives))
        return dmi_fail(env, DM_ERROR_BAD_DATA, "kinematics: the ranker's weights overflow");
    find_free_ranges(w, out, out_alternatives);
    return DM_OK;
}

dm_result dmi_joint_inference_run(dmi_env* env, const dmi_inference_query* query, dmi_hypotheses* out_hypotheses,
                                  dmi_alternatives* out_alternatives) {
    dmi_arena own, *arena = query->scratch != NULL ? query->scratch : &own;
    dmi_arena_init(&own, env, SCRATCH_BLOCK);
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dm_result result = infer_joint(env, arena, query, out_hypotheses, out_alternatives);
    dmi_arena_rewind(arena, mark);
    dmi_arena_release(&own);
    return result;
}
