/* Selects a few hypotheses among ranked candidates, by non-maximum suppression: candidates that move the part alike
 * support one hypothesis. */
#ifndef DMI_INFERENCE_HYPOTHESIS_SELECTION_H
#define DMI_INFERENCE_HYPOTHESIS_SELECTION_H

#include "kinematics/ranking/consensus_refine.h"

typedef struct dmi_ranked_candidates {
    const dmi_part_analysis* analysis;
    const dmi_candidate* candidates;
    const float* probability; /* probability of each candidate; they sum to 1 */
    uint32_t count;
} dmi_ranked_candidates;

/* A candidate that became a hypothesis. */
typedef struct dmi_selected {
    const dmi_candidate* candidate;
    uint32_t index;  /* index of the candidate */
    float mass;      /* probability of the candidates that move the part alike, at most that of the one before */
    float type_mass; /* probability of all candidates of its type, turn or slide */
    uint32_t support_count;
    dmi_weighted_candidate support[DMI_CONSENSUS_MAX]; /* candidates near it, itself among them */
} dmi_selected;

/* How candidates are weighed, by the probability of those near them, and how the first hypothesis is chosen. */
typedef enum dmi_selection_rule {
    DMI_SELECT_HEAVIEST, /* suits scores of rules, which are no probabilities */
    /* The first is of the type, turn or slide, with more probability in sum. Turns are many candidates
     * that share their probability and slides are few: a single slide may have more than each single turn although
     * turns have more together. */
    DMI_SELECT_LIKELIER_TYPE_FIRST,
    /* Candidates are near where the parts that they open end near each other, in object sizes. The first is the
     * heaviest, whatever its type. */
    DMI_SELECT_BY_POSE
} dmi_selection_rule;

/* Selects hypotheses, best first. Returns their number. */
uint32_t dmi_select_hypotheses(const dmi_ranked_candidates* ranked, dmi_selection_rule rule,
                               dmi_selected out[DM_MAX_HYPOTHESES]);

#endif
