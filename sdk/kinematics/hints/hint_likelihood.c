/* log posterior = log probability of the ranker + log-likelihood of the label + log-likelihood of the pivot, both
 * linear in the features of the candidate. The weights are fitted on generated objects (training/train hints). */
#include "kinematics/hints/hint_likelihood.h"

#include <float.h>

#include "math/elementary.h"
#include "math/linear3.h"

/* Factor of the weights of a pivot that breaks the rule of the asset's others; by hand. The weights are fitted on
 * pivots of which 0.28 were left where a program had put them (training/lab/hint_draw.c), and such a pivot is not among
 * those. */
#define SET_TRUST 1.25f

/* Factor of what modifiers say where a drag says how the part moves; by hand. */
#define WITH_DRAG 0.5f

/* Weights by kind: a row for each kind of kinds.def. */
static const float kind_weights[DMI_KIND_COUNT][DMI_KIND_FEATURES] = {
#define KIND_WEIGHTS(kind, ...) [DMI_KIND_##kind] = {__VA_ARGS__},
#include "kinematics/hints/hint_weights.def"
};

/* What the part's own name adds to the log odds of sliding where no drag tells the type, by kind. */
static const float kind_slides[DMI_KIND_COUNT] = {
#define KIND_SLIDES(kind, value) [DMI_KIND_##kind] = (value),
#include "kinematics/hints/hint_weights.def"
};

/* Weights by place of the pivot. */
static const float pivot_weights[DMI_PIVOT_PLACES][DMI_PIVOT_FEATURES] = {
#define PIVOT_WEIGHTS(place, ...) [DMI_PIVOT_##place] = {__VA_ARGS__},
#include "kinematics/hints/hint_weights.def"
};

/* Factors of the kind's weights: where the part's own name says it, and where a name above it does. */
static const float label_trust[2] = {
#define LABEL_TRUST(...) __VA_ARGS__
#include "kinematics/hints/hint_weights.def"
};

uint32_t dmi_hints_add_candidates(const dmi_asset_hints* hints, const dmi_part_analysis* analysis,
                                  const dmi_drag_hint* drag, dmi_candidate* candidates, uint32_t count) {
    if (!hints->has_pivot) return count;
    if (hints->has_axes)
        count = dmi_candidates_add_through(analysis, drag, hints->pivot, hints->pivot_axes, 3, candidates, count);
    return dmi_candidates_add_through(analysis, drag, hints->pivot, analysis->box.axes, 3, candidates, count);
}

static float label_likelihood(const dmi_hint_frame* frame, const dmi_candidate* candidate, bool has_drag) {
    const dmi_label_kind label = frame->hints->label;
    const dmi_label_modifiers modifiers = dmi_modifiers_that_count(label.kind, label.modifiers);
    const uint32_t bits = dmi_kind_features(frame, candidate);
    const float words = dmi_modifier_likelihood(modifiers, bits, label_trust[1]) * (has_drag ? WITH_DRAG : 1);
    if (label.kind == DMI_KIND_NOTHING) return words;
    float sum = 0;
    for (int i = 0; i < DMI_KIND_FEATURES; i++)
        if (bits >> i & 1) sum += kind_weights[label.kind][i];
    sum = sum * label_trust[label.depth > 0] + words;
    const bool tells_type = !has_drag && label.depth == 0 && candidate->type == DM_JOINT_PRISMATIC;
    return tells_type ? sum + kind_slides[label.kind] + dmi_slide_by_definition(label.kind) : sum;
}

static float pivot_likelihood(const dmi_hint_frame* frame, const dmi_candidate* candidate) {
    if (!frame->hints->has_pivot) return 0;
    float features[DMI_PIVOT_FEATURES], sum = 0;
    dmi_pivot_features(frame, candidate, features);
    for (int i = 0; i < DMI_PIVOT_FEATURES; i++) sum += pivot_weights[frame->place][i] * features[i];
    return frame->hints->is_set ? SET_TRUST * sum : sum;
}

void dmi_hints_weigh(const dmi_asset_hints* hints, const dmi_part_analysis* analysis, const dmi_drag_hint* drag,
                     const dmi_candidate* candidates, uint32_t count, float* probability) {
    dmi_hint_frame frame;
    dmi_hint_frame_make(hints, analysis, &frame);
    for (uint32_t i = 0; i < count; i++) {
        probability[i] = dmi_logf(dmi_max(probability[i], FLT_MIN));
        probability[i] += label_likelihood(&frame, &candidates[i], drag != NULL);
        probability[i] += pivot_likelihood(&frame, &candidates[i]);
    }
    dmi_softmax(probability, count);
}
