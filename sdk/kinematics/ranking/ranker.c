/* The learned ranker's forward pass, and the rules that stand in for it. */
#include "kinematics/ranking/ranker.h"

#include "base/cpu.h"
#include "math/linear3.h"

#define HIDDEN DMI_RANKER_HIDDEN
/* Share of the opinion that does without KPP-Net. Where neither it nor the ranker knows the kind of object, 0 to .2 do
 * about as well and .4 worse, most of all without a drag (docs/decisions.md, 31). */
#define DOUBT 0.2f

static int copy_transposed(const dmi_weights* weights, const char* name, uint32_t outputs, uint32_t inputs, float* to) {
    float from[HIDDEN * (DMI_FEATURE_COUNT > HIDDEN ? DMI_FEATURE_COUNT : HIDDEN)];
    if (!dmi_weights_read(weights, name, outputs, inputs, from)) return 0;
    for (uint32_t o = 0; o < outputs; o++)
        for (uint32_t i = 0; i < inputs; i++) to[i * outputs + o] = from[o * inputs + i];
    return 1;
}

static int copy_vector(const dmi_weights* weights, const char* name, uint32_t count, float* to) {
    return dmi_weights_read(weights, name, count, 0, to);
}

/* Folds the standardisation (x - mean) * scale into the first layer. */
static void fold_standardisation(const float* mean, const float* scale, dmi_ranker* ranker) {
    for (uint32_t i = 0; i < DMI_FEATURE_COUNT; i++)
        for (uint32_t o = 0; o < HIDDEN; o++) {
            ranker->first[i][o] *= scale[i];
            ranker->first_bias[o] -= ranker->first[i][o] * mean[i];
        }
}

static int read_tensors(const dmi_weights* weights, dmi_ranker* ranker) {
    float mean[DMI_FEATURE_COUNT], scale[DMI_FEATURE_COUNT];
    if (!copy_vector(weights, "mean", DMI_FEATURE_COUNT, mean) ||
        !copy_vector(weights, "scale", DMI_FEATURE_COUNT, scale) ||
        !copy_transposed(weights, "0.weight", HIDDEN, DMI_FEATURE_COUNT, &ranker->first[0][0]) ||
        !copy_vector(weights, "0.bias", HIDDEN, ranker->first_bias) ||
        !copy_transposed(weights, "2.weight", HIDDEN, HIDDEN, &ranker->second[0][0]) ||
        !copy_vector(weights, "2.bias", HIDDEN, ranker->second_bias) ||
        !copy_transposed(weights, "4.weight", 1, HIDDEN, ranker->last) ||
        !copy_vector(weights, "4.bias", 1, &ranker->last_bias) ||
        !dmi_weights_read(weights, "calibration", 2, 2, &ranker->calibration[0][0]))
        return 0;
    for (int i = 0; i < 2; i++)
        if (!(ranker->calibration[i][0] > 0 && ranker->calibration[i][0] < 1e3f)) return 0;
    fold_standardisation(mean, scale, ranker);
    return 1;
}

dm_result dmi_ranker_read(dmi_env* env, const dmi_weights* weights, dmi_ranker* out_ranker) {
    if (!read_tensors(weights, out_ranker))
        return dmi_fail(env, DM_ERROR_WRONG_MODEL,
                        "ranker: a tensor is missing or of another shape, or the calibration does not rise");
    return dmi_boosted_trees_read(env, weights, &out_ranker->trees);
}

/* Adds what some columns of evidence give the first layer. */
static void add_columns(const dmi_ranker* ranker, const float* restrict evidence, uint32_t from, uint32_t to,
                        float* restrict hidden) {
    for (uint32_t i = from; i < to; i++) {
        const float x = evidence[i];
        if (x == 0) continue;
        for (uint32_t o = 0; o < HIDDEN; o++) hidden[o] += x * ranker->first[i][o];
    }
}

static float upper_layers(const dmi_ranker* ranker, const float* restrict hidden) {
    float b[HIDDEN], score = ranker->last_bias;
    memcpy(b, ranker->second_bias, sizeof b);
    for (uint32_t i = 0; i < HIDDEN; i++) {
        if (hidden[i] <= 0) continue;
        for (uint32_t o = 0; o < HIDDEN; o++) b[o] += hidden[i] * ranker->second[i][o];
    }
    for (uint32_t i = 0; i < HIDDEN; i++) score += (b[i] > 0 ? b[i] : 0) * ranker->last[i];
    return score;
}

/* Two members of one ranker: with KPP-Net's features, and, to a share, without them. */
static float forward(const dmi_ranker* ranker, const float* evidence) {
    float without[HIDDEN], with[HIDDEN];
    memcpy(without, ranker->first_bias, sizeof without);
    for (uint32_t k = 0, from = 0; k <= DMI_NETWORK_COLUMNS; k++) {
        const uint32_t to = k < DMI_NETWORK_COLUMNS ? dmi_network_columns[k] : DMI_FEATURE_COUNT;
        add_columns(ranker, evidence, from, to, without);
        from = to + 1;
    }
    const float alone = upper_layers(ranker, without);
    if (evidence[DMI_FEATURE_HAS_NETWORK] == 0) return alone;
    memcpy(with, without, sizeof with);
    for (uint32_t k = 0; k < DMI_NETWORK_COLUMNS; k++)
        add_columns(ranker, evidence, dmi_network_columns[k], dmi_network_columns[k] + 1u, with);
    return (1 - DOUBT) * upper_layers(ranker, with) + DOUBT * alone;
}

static void score_plain(const dmi_ranker* ranker, const float (*evidence)[DMI_FEATURE_COUNT], uint32_t count,
                        float* out_score) {
    for (uint32_t i = 0; i < count; i++) out_score[i] = forward(ranker, evidence[i]);
}

#if defined(__x86_64__)
/* The same operations, eight at a time; without FMA, so the same bits. */
__attribute__((target("avx2"), flatten)) static void
score_avx2(const dmi_ranker* ranker, const float (*evidence)[DMI_FEATURE_COUNT], uint32_t count, float* out_score) {
    for (uint32_t i = 0; i < count; i++) out_score[i] = forward(ranker, evidence[i]);
}
#endif

/* Rules: surfaces slide on themselves where parts touch; a motion does not run into the body; a drag is followed; axes
 * run along sides and through middles; KPP-Net's answer attracts what is near it. Weights are round numbers set by
 * hand. */
static float rule_score(const float* f) {
    const bool turns = f[DMI_FEATURE_PRISMATIC] == 0;
    float score = -3 * f[DMI_FEATURE_SURFACE_SLIP] - 3 * f[DMI_FEATURE_NEAREST_PART_NORMAL_SPEED] -
                  2 * f[DMI_FEATURE_NEAREST_BODY_NORMAL_SPEED] -
                  4 * dmi_min(f[DMI_FEATURE_HIT_SHORT_ALONG], f[DMI_FEATURE_HIT_SHORT_AGAINST]);
    score -= f[DMI_FEATURE_HAS_DRAG] > 0
                 ? 4 * f[DMI_FEATURE_HIT_MIDDLE_ALONG] + f[DMI_FEATURE_DRAG_ANGLE] * f[DMI_FEATURE_DRAG_ANGLE] / 0.02f
                 : 0;
    if (turns) {
        score += 1.5f * f[DMI_FEATURE_NEAREST_ON_AXIS] + f[DMI_FEATURE_ON_SIDE] + f[DMI_FEATURE_ROUND] +
                 f[DMI_FEATURE_AT_CENTROID] + f[DMI_FEATURE_AT_BOX_CENTRE];
        score -= 3 * dmi_max(f[DMI_FEATURE_ALONG_PART_MEAN] - 0.05f, 0) + 1;
    }
    if (f[DMI_FEATURE_HAS_NETWORK] > 0) {
        score += logf(f[DMI_FEATURE_NETWORK_TYPE] + 0.02f) - 4 * dmi_min(f[DMI_FEATURE_NETWORK_ANGLE], 1) +
                 2 * f[DMI_FEATURE_NETWORK_NEAR_50MRAD];
        if (turns) score -= 4 * dmi_min(f[DMI_FEATURE_NETWORK_OFFSET], 1) - f[DMI_FEATURE_NETWORK_ON_LINE_3];
    }
    for (int k = 0; k < 3; k++) score += 0.7f * f[DMI_FEATURE_ALIGNED_LONG + k];
    return score;
}

static void network_score(const dmi_ranker* ranker, const float (*evidence)[DMI_FEATURE_COUNT], uint32_t count,
                          float* out_score) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) {
        score_avx2(ranker, evidence, count, out_score);
        return;
    }
#endif
    score_plain(ranker, evidence, count, out_score);
}

/* A network and a forest err on different candidates: their mean errs less than either. */
static void score(const dmi_ranker* ranker, const float (*evidence)[DMI_FEATURE_COUNT], uint32_t count,
                  float* out_score) {
    if (ranker == NULL) {
        for (uint32_t i = 0; i < count; i++) out_score[i] = rule_score(evidence[i]);
        return;
    }
    float by_trees[DMI_CANDIDATES_MAX];
    dmi_boosted_trees_score(&ranker->trees, evidence, count, by_trees);
    network_score(ranker, evidence, count, out_score);
    for (uint32_t i = 0; i < count; i++) out_score[i] = (out_score[i] + by_trees[i]) / 2;
}

void dmi_ranker_probabilities(const dmi_ranker* ranker, const float (*evidence)[DMI_FEATURE_COUNT], uint32_t count,
                              float* out_probability) {
    float most = -INFINITY, sum = 0;
    score(ranker, evidence, count, out_probability);
    for (uint32_t i = 0; i < count; i++) most = dmi_max(most, out_probability[i]);
    for (uint32_t i = 0; i < count; i++) sum += out_probability[i] = expf(out_probability[i] - most);
    for (uint32_t i = 0; i < count; i++) out_probability[i] /= sum;
}

float dmi_ranker_confidence(const dmi_ranker* ranker, int dragged, float mass) {
    if (ranker == NULL) return dmi_min(mass, 1);
    float p = dmi_min(dmi_max(mass, 1e-4f), 1 - 1e-4f);
    const float* line = ranker->calibration[dragged ? 1 : 0];
    return 1 / (1 + expf(-line[0] * logf(p / (1 - p)) - line[1]));
}
