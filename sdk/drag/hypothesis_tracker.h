/* Tracks which of its joint hypotheses a dragged part moves by: with every pointer ray the active one and the likeliest
 * others are updated, and the most probable takes over. */
#ifndef DMI_DRAG_HYPOTHESIS_TRACKER_H
#define DMI_DRAG_HYPOTHESIS_TRACKER_H

#include "drag/joint_hypothesis.h"

typedef struct dmi_hypothesis_tracker {
    dmi_grasp grasp;
    dmi_joint_hypothesis list[DMI_TRACKED_HYPOTHESES];
    uint32_t count, best; /* best: index of the active one */
    /* Last log posterior plus a bonus for waiting; the highest is updated next. */
    float priority[DMI_TRACKED_HYPOTHESES];
    uint32_t round;   /* updates so far */
    float confidence; /* probability that the active one is right, as of the last update */
    dmi_axis_refiner refiner;
} dmi_hypothesis_tracker;

/* Starts a tracker. joints[0] is active. free_ranges: ranges that are free for the joints; NULL: they have no bounds.
 * With count 0 it tracks nothing. */
void dmi_hypothesis_tracker_init(dmi_hypothesis_tracker* tracker, const dm_joint* joints,
                                 const dmi_free_range* free_ranges, uint32_t count, const float grab_point[3],
                                 float size, dmi_limit_give limit_give);
/* Adds a joint whose range is unknown; it is left out when the tracker is full or holds one alike. */
void dmi_hypothesis_tracker_add_alternative(dmi_hypothesis_tracker* tracker, const dm_joint* joint,
                                            dmi_free_range free_range);
/* Adds a slide that inference did not propose, as a last resort. axis: unit. */
void dmi_hypothesis_tracker_add_slide(dmi_hypothesis_tracker* tracker, dm_vec3 axis, dmi_free_range free_range);
/* Says which way is up: unit, host object frame. Call it when all joints have been added. */
void dmi_hypothesis_tracker_set_up(dmi_hypothesis_tracker* tracker, const float up[3]);
/* Updates the active hypothesis, which follows the ray at `pointer_value`, and the likeliest others by one ray. The
 * rest wait, so that an update takes about a microsecond. Returns true when another joint, another side of rest or
 * another axis line is active now. */
bool dmi_hypothesis_tracker_update(dmi_hypothesis_tracker* tracker, float pointer_value, const dm_ray* ray,
                                   dmi_projection projection);
/* Returns the probability that the active hypothesis is right. */
float dmi_hypothesis_tracker_confidence(const dmi_hypothesis_tracker* tracker);
/* Returns the probability that the type of the active hypothesis is right. It is of this pull alone, as
 * tracker->confidence is. */
float dmi_hypothesis_tracker_type_confidence(const dmi_hypothesis_tracker* tracker);

/* ---- pull_evidence.c: what a drag has learnt, for the next one ---- */

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
