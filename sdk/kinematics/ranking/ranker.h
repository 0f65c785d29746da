/* Scores candidate joints by their features: a small network and boosted trees fitted on generated objects, or rules
 * set by hand without them. */
#ifndef DMI_RANKING_RANKER_H
#define DMI_RANKING_RANKER_H

#include "kinematics/features/candidate_features.h"
#include "kinematics/ranking/boosted_trees.h"
#include "nn/weights.h"

#define DMI_RANKER_HIDDEN 64

/* The score is the mean of two: that of a network, standardised features -> 64 -> 64 -> 1 with ReLU between, and that
 * of the trees. The softmax over a part's candidates is a probability. Weights are transposed, so that the inner loops
 * run over outputs and vectorise. */
typedef struct dmi_ranker {
    float first[DMI_FEATURE_COUNT][DMI_RANKER_HIDDEN], first_bias[DMI_RANKER_HIDDEN];
    float second[DMI_RANKER_HIDDEN][DMI_RANKER_HIDDEN], second_bias[DMI_RANKER_HIDDEN];
    float last[DMI_RANKER_HIDDEN], last_bias;
    float calibration[2][2]; /* without a drag and with one: slope and offset between log odds */
    dmi_boosted_trees trees;
} dmi_ranker;

/* DM_ERROR_WRONG_MODEL when a tensor is missing or of another shape, or the calibration does not rise. */
dm_result dmi_ranker_read(dmi_env* env, const dmi_weights* weights, dmi_ranker* out_ranker);

/* Probabilities of the candidates; they sum to 1. ranker NULL: by rules. */
void dmi_ranker_probabilities(const dmi_ranker* ranker, const float (*features)[DMI_FEATURE_COUNT], uint32_t count,
                              float* out_probability);
/* The chance that an answer is right whose candidates gather this probability. ranker NULL: the probability itself. */
float dmi_ranker_confidence(const dmi_ranker* ranker, int dragged, float mass);

#endif
