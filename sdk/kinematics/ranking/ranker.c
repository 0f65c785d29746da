/* Scores candidates by network and trees, or by rules, and calibrates confidences. */
#include "kinematics/ranking/ranker.h"

#include <math.h>
#include <string.h>

#include "kinematics/candidates/candidates.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define HIDDEN 64
#define BATCH 24           /* rows at a time, which stay in the first cache with their hidden numbers */
#define STEEPEST 1e3f      /* slope of the calibration that a file may have */
#define LEAST_CHANCE 1e-4f /* probabilities are kept so far from 0 and 1 before their log odds are taken; by hand */
/* Share of the ensemble member that does without KPP-Net. Measured: where neither KPP-Net nor the ranker knows the kind
 * of object, 0 to 0.2 do about as well and 0.4 worse, most of all without a drag (docs/research/decisions.md, 31). */
#define NETWORK_FREE_SHARE 0.2f

static void refuse_model(dmi_loader* loader, const char* what) {
    if (loader->result == DM_OK) loader->result = dmi_fail(loader->env, DM_ERROR_WRONG_MODEL, "ranker: %s", what);
}

void dmi_ranker_read(dmi_loader* loader, dmi_ranker* out_ranker) {
    static const uint32_t sizes[] = {DMI_FEATURE_COUNT, HIDDEN, HIDDEN, 1};
    dmi_load_standardised_perceptron(loader, "ranker", sizes, 3, &out_ranker->network);
    const float* calibration = dmi_load_tensor(loader, "ranker.calibration", 2, 2);
    if (calibration != NULL) memcpy(out_ranker->calibration, calibration, sizeof out_ranker->calibration);
    for (int i = 0; calibration != NULL && i < 2; i++)
        if (!(out_ranker->calibration[i][0] > 0 && out_ranker->calibration[i][0] < STEEPEST))
            refuse_model(loader, "the calibration does not rise");
    dmi_boosted_trees_read(loader, &out_ranker->trees);
}

/* Hides KPP-Net's features, as training does. */
static void hide_network(float (*rows)[DMI_FEATURE_COUNT], uint32_t count) {
    for (uint32_t r = 0; r < count; r++)
        for (int k = 0; k < DMI_NETWORK_COLUMNS; k++) rows[r][dmi_network_columns[k]] = 0;
}

/* Scores by two members of one network: with KPP-Net's features and, to a share, without them. All rows have KPP-Net's
 * features, or none has. */
static void network_score(const dmi_ranker* ranker, dmi_isa isa, const float (*features)[DMI_FEATURE_COUNT],
                          uint32_t count, float* out_score) {
    const dmi_kernels* kernels = dmi_kernels_for(isa);
    _Alignas(DMI_ALIGNMENT) float x[BATCH][DMI_FEATURE_COUNT], hidden[2][BATCH][HIDDEN], alone[BATCH];
    float* const buffers[2] = {hidden[0][0], hidden[1][0]};
    for (uint32_t first = 0; first < count; first += BATCH) {
        const uint32_t rows = count - first < BATCH ? count - first : BATCH;
        dmi_perceptron_apply(&ranker->network, kernels, features[first], rows, buffers, out_score + first);
        if (features[first][DMI_FEATURE_HAS_NETWORK] == 0) continue;
        memcpy(x, features[first], rows * sizeof *x);
        hide_network(x, rows);
        dmi_perceptron_apply(&ranker->network, kernels, x[0], rows, buffers, alone);
        for (uint32_t r = 0; r < rows; r++)
            out_score[first + r] = (1 - NETWORK_FREE_SHARE) * out_score[first + r] + NETWORK_FREE_SHARE * alone[r];
    }
}

/* Scores by rules, whose weights are fitted on 1,500 generated cases and rounded. Surfaces slide on themselves where
 * parts touch. A motion does not run into the body, on the better way of the two. A drag is followed. Axes run along
 * sides, through middles and where part and body touch. KPP-Net's answer attracts what is near it; its weights are set
 * by hand. */
static float rule_score(const float* f) {
    static const float slip_weight = 2, touching_weight = 1.5f, hit_weight = 4, axis_weight = 4, aligned_weight = 2;
    /* Some turn among many axes follows any drag, so that a dragged turn needs more evidence than a slide. */
    static const float turn_cost = 1.5f, dragged_turn_cost = 3, network_weight = 4;
    static const float drag_variance = 0.03f; /* variance of a drag's angle, rad squared */
    static const float some_distance = 0.05f; /* distance from the part at which an axis may run, diagonals */
    static const float doubt = 0.02f;         /* probability that every type has at least, whatever KPP-Net says */
    const bool turns = f[DMI_FEATURE_PRISMATIC] == 0;
    float score = -slip_weight * f[DMI_FEATURE_NEAREST_SLIP] -
                  touching_weight * f[DMI_FEATURE_TOUCHING_PART_NORMAL_SPEED] -
                  hit_weight * dmi_min(f[DMI_FEATURE_HIT_MIDDLE_ALONG], f[DMI_FEATURE_HIT_MIDDLE_AGAINST]) -
                  hit_weight * dmi_min(f[DMI_FEATURE_HIT_LONG_ALONG], f[DMI_FEATURE_HIT_LONG_AGAINST]);
    const bool has_drag = f[DMI_FEATURE_HAS_DRAG] > 0;
    if (has_drag) score -= f[DMI_FEATURE_DRAG_ANGLE] * f[DMI_FEATURE_DRAG_ANGLE] / drag_variance;
    if (turns) {
        score += axis_weight * f[DMI_FEATURE_NEAREST_ON_AXIS] + f[DMI_FEATURE_AT_BOX_CENTRE] +
                 0.5f * (f[DMI_FEATURE_ON_SIDE] + f[DMI_FEATURE_ROUND] + f[DMI_FEATURE_AT_CENTROID]);
        score -= 2 * dmi_max(f[DMI_FEATURE_ALONG_PART_MEAN] - some_distance, 0);
        score -= has_drag ? dragged_turn_cost : turn_cost;
    }
    if (f[DMI_FEATURE_HAS_NETWORK] > 0) {
        score += dmi_logf(f[DMI_FEATURE_NETWORK_TYPE] + doubt) -
                 network_weight * dmi_min(f[DMI_FEATURE_NETWORK_ANGLE], 1) + 2 * f[DMI_FEATURE_NETWORK_NEAR_50MRAD];
        if (turns)
            score -= network_weight * dmi_min(f[DMI_FEATURE_NETWORK_OFFSET], 1) - f[DMI_FEATURE_NETWORK_ON_LINE_3];
    }
    for (int k = 0; k < 3; k++) score += aligned_weight * f[DMI_FEATURE_ALIGNED_LONG + k];
    return score;
}

/* Scores by the mean of network and trees. The two err on different candidates, so the mean errs less than either
 * (measured). */
static void score_candidates(const dmi_ranker* ranker, dmi_isa isa, const float (*features)[DMI_FEATURE_COUNT],
                             uint32_t count, float* out_score) {
    if (ranker == NULL) {
        for (uint32_t i = 0; i < count; i++) out_score[i] = rule_score(features[i]);
        return;
    }
    float by_trees[DMI_CANDIDATES_MAX];
    dmi_boosted_trees_score(&ranker->trees, features, count, by_trees);
    network_score(ranker, isa, features, count, out_score);
    for (uint32_t i = 0; i < count; i++) out_score[i] = (out_score[i] + by_trees[i]) / 2;
}

void dmi_ranker_probabilities(const dmi_ranker* ranker, dmi_isa isa, const float (*features)[DMI_FEATURE_COUNT],
                              uint32_t count, float* out_probability) {
    score_candidates(ranker, isa, features, count, out_probability);
    dmi_softmax(out_probability, count);
}

void dmi_ranker_geometry_probabilities(const dmi_ranker* ranker, dmi_isa isa,
                                       const float (*features)[DMI_FEATURE_COUNT], uint32_t count,
                                       float* out_probability) {
    _Alignas(DMI_ALIGNMENT) float x[BATCH][DMI_FEATURE_COUNT];
    for (uint32_t first = 0; first < count; first += BATCH) {
        const uint32_t rows = count - first < BATCH ? count - first : BATCH;
        memcpy(x, features[first], rows * sizeof *x);
        hide_network(x, rows);
        score_candidates(ranker, isa, (const float(*)[DMI_FEATURE_COUNT])x, rows, out_probability + first);
    }
    dmi_softmax(out_probability, count);
}

float dmi_ranker_confidence(const dmi_ranker* ranker, int dragged, float mass) {
    if (ranker == NULL) return dmi_min(mass, 1);
    const float p = dmi_min(dmi_max(mass, LEAST_CHANCE), 1 - LEAST_CHANCE);
    const float* line = ranker->calibration[dragged ? 1 : 0];
    return 1 / (1 + dmi_expf(-line[0] * dmi_logf(p / (1 - p)) - line[1]));
}
