/* What a part's earlier pulls have said of its joints. It leaves a drag at its end and enters the next one. */
#ifndef DMI_DRAG_PULL_EVIDENCE_H
#define DMI_DRAG_PULL_EVIDENCE_H

#include "drag/hypothesis_tracker.h"

enum { DMI_EVIDENCE_WORDS = sizeof((dm_joint*)0)->evidence / sizeof(uint32_t) };

/* Log likelihoods of all earlier pulls, up to a constant that all share; 0 or less. */
typedef struct dmi_pull_evidence {
    uint32_t pulls;                  /* pulls that said something; with 0 the other numbers have no meaning */
    float ranked[DM_MAX_HYPOTHESES]; /* log likelihoods of the joints that inference has ranked */
    float others;                    /* log likelihood of all other joints together */
    float own;                       /* log posterior of the instance's joint, where it is none of the ranked */
} dmi_pull_evidence;

/* Writes evidence in steps of an eighth of a nat. part: a number that tells the part from others. */
void dmi_pull_evidence_pack(const dmi_pull_evidence* evidence, uint32_t part, uint32_t out[DMI_EVIDENCE_WORDS]);
/* Reads evidence back. Words of another part, zeros among them, are no evidence. */
dmi_pull_evidence dmi_pull_evidence_unpack(const uint32_t words[DMI_EVIDENCE_WORDS], uint32_t part);

/* Takes evidence into the priors of a tracker that has not seen a ray yet. ranked: the joints of inference, by rank. */
void dmi_pull_evidence_recall(dmi_hypothesis_tracker* tracker, const dm_joint* ranked, uint32_t count,
                              const dmi_pull_evidence* earlier);
/* Adds what this pull says to the earlier evidence. */
dmi_pull_evidence dmi_pull_evidence_collect(const dmi_hypothesis_tracker* tracker, const dmi_pull_evidence* earlier);

#endif
