/* Scores candidate joints by their features: a small network and boosted trees fitted on generated objects, or rules
 * set by hand without them. */
#ifndef DMI_RANKING_RANKER_H
#define DMI_RANKING_RANKER_H

#include "kinematics/ranking/boosted_trees.h"
#include "nn/layers.h"

/* The score is the mean of two: that of the network and that of the trees. The softmax over a part's candidates is a
 * probability. */
typedef struct dmi_ranker {
    dmi_perceptron network;  /* features -> 64 -> 64 -> 1 */
    float calibration[2][2]; /* slope and offset between log odds, first without a drag and then with one */
    dmi_boosted_trees trees;
} dmi_ranker;

/* Reads the ranker. Answers DM_ERROR_WRONG_MODEL when what the file holds are no trees, or the calibration does not
 * rise. */
void dmi_ranker_read(dmi_loader* loader, dmi_ranker* out_ranker);

/* Computes the probabilities of the candidates, which sum to 1. ranker: NULL scores by rules. count: at most
 * DMI_CANDIDATES_MAX. */
void dmi_ranker_probabilities(const dmi_ranker* ranker, dmi_isa isa, const float (*features)[DMI_FEATURE_COUNT],
                              uint32_t count, float* out_probability);
/* Computes the same as if there were no KPP-Net. */
void dmi_ranker_geometry_probabilities(const dmi_ranker* ranker, dmi_isa isa,
                                       const float (*features)[DMI_FEATURE_COUNT], uint32_t count,
                                       float* out_probability);
/* Returns the probability that an answer is right whose candidates gather the probability `mass`. Without a ranker
 * (NULL) it is `mass`. */
float dmi_ranker_confidence(const dmi_ranker* ranker, int dragged, float mass);

#endif
