/* Scores candidate joints by their evidence: a small network and a forest trained on generated objects, or rules
 * without them. */
#ifndef DMI_KINEMATICS_RANKER_H
#define DMI_KINEMATICS_RANKER_H

#include "kinematics/evidence.h"
#include "kinematics/limit_net.h"
#include "kinematics/sieve.h"

/* Architecture "dragmesh-ranker": the mean of two scores, standardised evidence -> 64 -> 64 -> 1, ReLU between, and a
 * forest's (forest.h). The softmax over a part's candidates (those that the sieve kept) is a probability; what an
 * answer gathers of it is calibrated by two numbers in the file, others without a drag than with one. */
typedef struct dmi_ranker dmi_ranker;

dm_result dmi_ranker_load(dmi_env* env, const void* data, size_t size, dmi_ranker** out_ranker);
void dmi_ranker_destroy(dmi_ranker* ranker);

/* Probabilities of the candidates; they sum to 1. ranker NULL: by rules. */
void dmi_ranker_probabilities(const dmi_ranker* ranker, const float (*evidence)[DMI_EVIDENCE_COUNT], uint32_t count,
                              float* out_probability);
/* The chance that an answer is right whose candidates gather this probability. */
float dmi_ranker_confidence(const dmi_ranker* ranker, int dragged, float mass);

/* The limits' network of the same file; NULL without a ranker. */
const dmi_limit_net* dmi_ranker_limits(const dmi_ranker* ranker);
/* The sieve of the same file; NULL without a ranker. */
const dmi_sieve* dmi_ranker_sieve(const dmi_ranker* ranker);

#endif
