/* A small network that sees candidates at a glance and keeps those worth all of the evidence. Trained on generated
 * objects; its weights lie in the ranker's file. */
#ifndef DMI_KINEMATICS_SIEVE_H
#define DMI_KINEMATICS_SIEVE_H

#include "kinematics/glance.h"
#include "kinematics/opinion.h"
#include "nn/weights.h"

#define DMI_SIEVE_HIDDEN 16
/* The right joint is among so many for 99 in 100 parts of which it is a candidate at all. */
#define DMI_SIEVE_KEPT 256

/* Glance -> 16 -> 1, ReLU between; weights transposed, the standardisation folded in. */
typedef struct dmi_sieve {
    float first[DMI_GLANCE_COLUMNS][DMI_SIEVE_HIDDEN], first_bias[DMI_SIEVE_HIDDEN];
    float last[DMI_SIEVE_HIDDEN];
} dmi_sieve;

/* 0 when a tensor is missing or of another shape. */
int dmi_sieve_read(const dmi_weights* weights, dmi_sieve* out_sieve);

/* Moves the DMI_SIEVE_KEPT best candidates to the front, in the order they had; answers how many there are now.
 * net and opinion NULL: without a network. rows: scratch, one a candidate. */
uint32_t dmi_sieve_keep(const dmi_sieve* sieve, const dmi_study* study, const dmi_drag_hint* hint,
                        const dmi_kpp_net* net, dmi_isa isa, const dmi_opinion* opinion, dmi_candidate* candidates,
                        uint32_t count, float (*rows)[DMI_EVIDENCE_COUNT]);

#endif
