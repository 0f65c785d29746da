/* Evidence of earlier pulls, as sixteen bytes of a state that hosts save. */
#include "drag/hypothesis_tracker.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

/* Most nats that earlier pulls speak against a joint, so that a later one can revise it; by hand. */
#define MOST_EVIDENCE 8.0f
#define STEPS 8.0f     /* steps a nat; by hand, finer than any decision needs */
#define MOST_OWN 15.0f /* nats of the own joint's log posterior, either way, that fit a byte; by hand */
#define MOST_PULLS 255 /* most pulls that a byte counts */
#define SHOWN_OTHERS 8 /* likeliest of the unranked joints that stand for all of them; by hand, for the time */

/* ---- bytes ---- */

static uint32_t byte_of(float nats, float most) {
    const float kept = dmi_fminf(dmi_fmaxf(nats, -most), most);
    return (uint32_t)(int32_t)rintf(kept * STEPS) & 0xFFu;
}

static float nats_of(uint32_t byte) {
    return (float)(int8_t)(uint8_t)byte / STEPS;
}

void dmi_pull_evidence_pack(const dmi_pull_evidence* evidence, uint32_t part, uint32_t out[DMI_EVIDENCE_WORDS]) {
    memset(out, 0, DMI_EVIDENCE_WORDS * sizeof *out);
    if (evidence->pulls == 0) return;
    const uint32_t pulls = evidence->pulls < MOST_PULLS ? evidence->pulls : MOST_PULLS;
    out[0] = part;
    out[1] = pulls | byte_of(evidence->others, MOST_EVIDENCE) << 8 | byte_of(evidence->own, MOST_OWN) << 16;
    for (uint32_t i = 0; i < DM_MAX_HYPOTHESES; i++)
        out[2 + i / 4] |= byte_of(evidence->ranked[i], MOST_EVIDENCE) << 8 * (i % 4);
}

dmi_pull_evidence dmi_pull_evidence_unpack(const uint32_t words[DMI_EVIDENCE_WORDS], uint32_t part) {
    dmi_pull_evidence evidence = {.pulls = 0};
    if (words[0] != part || (words[1] & 0xFFu) == 0) return evidence;
    evidence.pulls = words[1] & 0xFFu;
    evidence.others = nats_of(words[1] >> 8 & 0xFFu);
    evidence.own = nats_of(words[1] >> 16 & 0xFFu);
    for (uint32_t i = 0; i < DM_MAX_HYPOTHESES; i++)
        evidence.ranked[i] = nats_of(words[2 + i / 4] >> 8 * (i % 4) & 0xFFu);
    return evidence;
}

/* ---- a drag's beginning ---- */

static int8_t rank_of(const dm_joint* joint, const dm_joint* ranked, uint32_t count, float size) {
    for (uint32_t i = 0; i < count; i++)
        if (dmi_joints_alike(joint, &ranked[i], size)) return (int8_t)i;
    return DMI_UNRANKED;
}

void dmi_pull_evidence_recall(dmi_hypothesis_tracker* tracker, const dm_joint* ranked, uint32_t count,
                              const dmi_pull_evidence* earlier) {
    const dmi_grasp* grasp = &tracker->grasp;
    for (uint32_t i = 0; i < tracker->count; i++) {
        dmi_joint_hypothesis* one = &tracker->list[i];
        if (!one->range_unknown) one->rank = rank_of(&one->joint, ranked, count, grasp->size);
        if (earlier->pulls == 0) continue;
        const float arm = dmi_lever_arm_log_prior(grasp, &one->joint);
        if (one->rank >= 0)
            one->log_prior = dmi_joint_log_odds(&ranked[one->rank]) + earlier->ranked[one->rank] + arm;
        else
            one->log_prior = i == 0 ? earlier->own + arm : one->log_prior + earlier->others;
        one->log_posterior = tracker->priority[i] = one->log_prior;
    }
}

/* Returns the log likelihood of the pull under a hypothesis. One that has waited for its update follows the recorded
 * rays now, and all of them if it has followed none. */

/* Returns the log likelihood of the pull under a hypothesis. One that has waited for its update follows the recorded
 * rays now: all of them if it has followed none. */
static float likelihood_of(const dmi_hypothesis_tracker* tracker, uint32_t index) {
    const dmi_pull* pull = &tracker->grasp.pull;
    dmi_joint_hypothesis one = tracker->list[index];
    const bool is_new = one.max_residual == 0;
    for (uint32_t i = is_new ? 0 : pull->count - 1; i < pull->count && index != tracker->best; i++)
        dmi_joint_hypothesis_update(&tracker->grasp, &one, &pull->rays[i]);
    return one.log_posterior - one.log_prior;
}

/* Returns the log likelihood of the unranked joints together: of the likeliest before the pull, by their odds. It is
 * minus infinity when there are none. */
static float likelihood_of_others(const dmi_hypothesis_tracker* tracker) {
    float before = 0, after = 0;
    uint32_t shown = 0;
    for (uint32_t i = 1; i < tracker->count && shown < SHOWN_OTHERS; i++) {
        if (tracker->list[i].rank >= 0) continue;
        const float weight = dmi_expf(tracker->list[i].log_prior);
        before += weight, after += weight * dmi_expf(likelihood_of(tracker, i)), shown++;
    }
    return before > 0 && after > 0 ? dmi_logf(after / before) : -INFINITY;
}

/* Adds the likelihoods of the ranked joints, of which out_tracked tells those that the tracker holds. */
static void add_ranked(const dmi_hypothesis_tracker* tracker, float ranked[DM_MAX_HYPOTHESES],
                       bool out_tracked[DM_MAX_HYPOTHESES]) {
    for (uint32_t i = 0; i < tracker->count; i++) {
        const int8_t rank = tracker->list[i].rank;
        if (rank < 0) continue;
        ranked[rank] += likelihood_of(tracker, i);
        out_tracked[rank] = true;
    }
}

dmi_pull_evidence dmi_pull_evidence_collect(const dmi_hypothesis_tracker* tracker, const dmi_pull_evidence* earlier) {
    dmi_pull_evidence all = *earlier;
    if (tracker->round == 0 || tracker->grasp.pull.count == 0) return all;
    const dmi_joint_hypothesis* best = &tracker->list[tracker->best];
    bool tracked[DM_MAX_HYPOTHESES] = {false};
    all.others += likelihood_of_others(tracker);
    add_ranked(tracker, all.ranked, tracked);
    float most = all.others;
    for (uint32_t i = 0; i < DM_MAX_HYPOTHESES; i++) most = tracked[i] ? dmi_fmaxf(most, all.ranked[i]) : most;
    if (most == -INFINITY) most = 0; /* the instance's own joint is all that is tracked */
    for (uint32_t i = 0; i < DM_MAX_HYPOTHESES; i++) all.ranked[i] = tracked[i] ? all.ranked[i] - most : 0;
    all.others = dmi_fmaxf(all.others - most, -MOST_EVIDENCE);
    all.own = best->log_posterior - dmi_lever_arm_log_prior(&tracker->grasp, &best->joint) - most;
    all.pulls++;
    return all;
}
