/* log posterior = log probability of the ranker + log-likelihood of the label + log-likelihood of the pivot, both
 * linear in the features of the candidate. The weights are fitted on generated objects (training/train hints), but
 * those of the label's modifiers are set by hand. */
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

/* ---- modifiers ---- */

/* The priors of modifiers follow from how such leaves are built. Nothing here is fitted. A word that names a mechanism
 * is taken to be right in nine of ten assets and more, so that it outweighs a shape that favours another mechanism
 * three to one. */
#define ONLY 2.0f     /* log weight of what the mechanism always is */
#define USUAL 1.0f    /* log weight of what it mostly is */
#define RARE (-1.0f)  /* log weight of what it is in some builds */
#define NEVER (-2.0f) /* log weight of what the word rules out */
#define SLIGHT 0.5f
#define NEUTRAL_SLIDE (-0.4f) /* takes back what the kind of windows says for the slide (hint_weights.def) */

#define NO_TURN [DMI_KIND_TURN_UPRIGHT] = NEVER, [DMI_KIND_TURN_LEVEL] = NEVER, [DMI_KIND_TURN_OBLIQUE] = NEVER
#define NO_SLIDE [DMI_KIND_SLIDE_UPRIGHT] = NEVER, [DMI_KIND_SLIDE_LEVEL] = NEVER, [DMI_KIND_SLIDE_OBLIQUE] = NEVER

/* One of a pair hangs on the side away from the other leaf. */
#define OF_PAIR                                                                                                        \
    {                                                                                                                  \
        [DMI_KIND_TURN_UPRIGHT] = USUAL, [DMI_KIND_TURN_OUTER] = USUAL, [DMI_KIND_TURN_INNER] = RARE,                  \
        [DMI_KIND_TURN_LEVEL] = RARE                                                                                   \
    }

static const float priors[DMI_MODIFIER_COUNT][DMI_KIND_FEATURES] = {
    /* It slides in its own plane, sideways or, as a hatch, up. A slide through its own thickness takes it off. */
    [DMI_MODIFIER_SLIDING] = {NO_TURN, [DMI_KIND_SLIDE_LEVEL] = USUAL, [DMI_KIND_SLIDE_SHORT] = NEVER},
    /* It hangs on wheels on a rail along the wall; some barns have a pair of hinged leaves. */
    [DMI_MODIFIER_BARN] = {[DMI_KIND_SLIDE_LEVEL] = ONLY,
                           [DMI_KIND_SLIDE_SHORT] = NEVER,
                           [DMI_KIND_SLIDE_UPRIGHT] = RARE,
                           [DMI_KIND_TURN_LEVEL] = RARE},
    /* Doors of lifts and trains go sideways into a pocket; old lifts have a hinged one. */
    [DMI_MODIFIER_ELEVATOR] = {[DMI_KIND_SLIDE_LEVEL] = ONLY,
                               [DMI_KIND_SLIDE_SHORT] = NEVER,
                               [DMI_KIND_SLIDE_UPRIGHT] = RARE,
                               [DMI_KIND_TURN_UPRIGHT] = RARE,
                               [DMI_KIND_TURN_LEVEL] = NEVER},
    /* An up-and-over door turns about a level axis in its upper part, or rises. A pair of hinged leaves is older. */
    [DMI_MODIFIER_GARAGE] = {[DMI_KIND_TURN_LEVEL] = USUAL,
                             [DMI_KIND_TURN_TOP] = SLIGHT,
                             [DMI_KIND_TURN_BOTTOM] = NEVER,
                             [DMI_KIND_SLIDE_UPRIGHT] = USUAL,
                             [DMI_KIND_SLIDE_LEVEL] = RARE,
                             [DMI_KIND_SLIDE_SHORT] = NEVER,
                             [DMI_KIND_TURN_UPRIGHT] = RARE},
    /* It rolls up on a drum over the opening, so what is seen of it rises. */
    [DMI_MODIFIER_ROLLING] = {[DMI_KIND_SLIDE_UPRIGHT] = ONLY,
                              [DMI_KIND_SLIDE_LEVEL] = RARE,
                              [DMI_KIND_SLIDE_SHORT] = NEVER,
                              [DMI_KIND_TURN_UPRIGHT] = NEVER,
                              [DMI_KIND_TURN_LEVEL] = RARE},
    /* Its panels turn about upright hinges at their edges. */
    [DMI_MODIFIER_FOLDING] = {[DMI_KIND_TURN_UPRIGHT] = USUAL,
                              [DMI_KIND_TURN_EDGE] = SLIGHT,
                              [DMI_KIND_TURN_LEVEL] = RARE,
                              [DMI_KIND_SLIDE_UPRIGHT] = RARE,
                              [DMI_KIND_SLIDE_LEVEL] = RARE},
    /* It turns about an upright post, through its middle or at the inner edge of one wing. */
    [DMI_MODIFIER_REVOLVING] = {NO_SLIDE, [DMI_KIND_TURN_UPRIGHT] = ONLY, [DMI_KIND_TURN_LEVEL] = NEVER,
                                [DMI_KIND_TURN_INNER] = SLIGHT, [DMI_KIND_TURN_CENTRE] = SLIGHT},
    /* It swings about an upright edge. */
    [DMI_MODIFIER_HINGED] = {NO_SLIDE, [DMI_KIND_TURN_UPRIGHT] = USUAL, [DMI_KIND_TURN_EDGE] = USUAL},
    /* It may be any leaf of a window: some slide, some swing. */
    [DMI_MODIFIER_SASH] = {[DMI_KIND_SLIDE_UPRIGHT] = NEUTRAL_SLIDE,
                           [DMI_KIND_SLIDE_LEVEL] = NEUTRAL_SLIDE,
                           [DMI_KIND_SLIDE_OBLIQUE] = NEUTRAL_SLIDE},
    /* It slides up and down on cords. */
    [DMI_MODIFIER_HUNG] = {NO_TURN, [DMI_KIND_SLIDE_UPRIGHT] = ONLY, [DMI_KIND_SLIDE_SHORT] = NEVER},
    /* It makes a trapdoor of a door (part_kind.c), and says nothing else. */
    [DMI_MODIFIER_HATCH] = {0},
    /* It hangs from its upper edge. */
    [DMI_MODIFIER_AWNING] = {NO_SLIDE, [DMI_KIND_TURN_LEVEL] = ONLY, [DMI_KIND_TURN_TOP] = USUAL,
                             [DMI_KIND_TURN_BOTTOM] = RARE, [DMI_KIND_TURN_UPRIGHT] = RARE},
    [DMI_MODIFIER_LEFT] = OF_PAIR,
    [DMI_MODIFIER_RIGHT] = OF_PAIR,
};

#define BIT(name) (1u << DMI_MODIFIER_##name)
#define WAYS (BIT(SLIDING) | BIT(HINGED))
#define SIDES (BIT(LEFT) | BIT(RIGHT))
#define OF_DOORS (WAYS | SIDES | BIT(BARN) | BIT(ELEVATOR) | BIT(GARAGE) | BIT(ROLLING) | BIT(FOLDING) | BIT(REVOLVING))
#define OF_WINDOWS (WAYS | SIDES | BIT(ROLLING) | BIT(FOLDING) | BIT(SASH) | BIT(HUNG) | BIT(AWNING))

/* Modifiers that mean something for a part of each kind. NOTHING: the noun is not known. */
static const uint32_t of_kind[DMI_KIND_COUNT] = {
    [DMI_KIND_NOTHING] = WAYS,
    [DMI_KIND_DOOR] = OF_DOORS,
    [DMI_KIND_GATE] = OF_DOORS & ~BIT(ELEVATOR),
    [DMI_KIND_SLIDING_DOOR] = OF_DOORS,
    [DMI_KIND_WINDOW] = OF_WINDOWS,
    [DMI_KIND_SHUTTER] = OF_WINDOWS | BIT(GARAGE),
    [DMI_KIND_LID] = WAYS,
    [DMI_KIND_FLAP] = WAYS,
    [DMI_KIND_TRAPDOOR] = WAYS,
    [DMI_KIND_TRAY] = WAYS,
    [DMI_KIND_PORTCULLIS] = WAYS,
};

dmi_label_modifiers dmi_modifiers_that_count(dmi_part_kind kind, dmi_label_modifiers modifiers) {
    dmi_label_modifiers out = {modifiers.own & of_kind[kind], modifiers.above & of_kind[kind]};
    if (kind == DMI_KIND_NOTHING) out.above = 0; /* these may belong to anything that the asset has */
    const uint32_t sides = (out.own & SIDES) != 0 ? out.own & SIDES : out.above & SIDES;
    if (sides == SIDES || (out.own & SIDES) != 0) out.above &= ~SIDES;
    if (sides == SIDES) out.own &= ~SIDES;
    out.above &= ~out.own;
    return out;
}

static float sum_of(uint32_t modifiers, uint32_t features) {
    float sum = 0;
    for (int m = 0; m < DMI_MODIFIER_COUNT; m++) {
        if (!(modifiers >> m & 1)) continue;
        for (int i = 0; i < DMI_KIND_FEATURES; i++)
            if (features >> i & 1) sum += priors[m][i];
    }
    return sum;
}

/* Returns what the meaning of a kind's noun adds to the log probability of sliding: a lever turns about its fulcrum. */
static float slide_by_definition(dmi_part_kind kind) {
    return kind == DMI_KIND_LEVER ? RARE : 0;
}

/* Returns what the modifiers add to the log probability of a candidate with these kind features (dmi_kind_feature).
 * modifiers: as dmi_modifiers_that_count returns them. above: factor of the modifiers in the names above. */
static float modifier_likelihood(dmi_label_modifiers modifiers, uint32_t features, float above) {
    return sum_of(modifiers.own, features) + above * sum_of(modifiers.above, features);
}

/* ---- what the asset says ---- */

bool dmi_asset_hints_are_empty(const dmi_asset_hints* hints) {
    if (hints == NULL) return true;
    const dmi_label_modifiers say = dmi_modifiers_that_count(hints->label.kind, hints->label.modifiers);
    return hints->label.kind == DMI_KIND_NOTHING && !hints->has_pivot && (say.own | say.above) == 0;
}

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
    const float words = modifier_likelihood(modifiers, bits, label_trust[1]) * (has_drag ? WITH_DRAG : 1);
    if (label.kind == DMI_KIND_NOTHING) return words;
    float sum = 0;
    for (int i = 0; i < DMI_KIND_FEATURES; i++)
        if (bits >> i & 1) sum += kind_weights[label.kind][i];
    sum = sum * label_trust[label.depth > 0] + words;
    const bool tells_type = !has_drag && label.depth == 0 && candidate->type == DM_JOINT_PRISMATIC;
    return tells_type ? sum + kind_slides[label.kind] + slide_by_definition(label.kind) : sum;
}

/* Returns whether words say that the part slides. The pivot of such a part lies wherever its author has put it. */
static bool words_tell_slide(dmi_label_kind label) {
    const dmi_label_modifiers say = dmi_modifiers_that_count(label.kind, label.modifiers);
    return ((say.own | say.above) & (BIT(SLIDING) | BIT(HUNG))) != 0;
}

static float pivot_likelihood(const dmi_hint_frame* frame, const dmi_candidate* candidate) {
    if (!frame->hints->has_pivot || words_tell_slide(frame->hints->label)) return 0;
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
