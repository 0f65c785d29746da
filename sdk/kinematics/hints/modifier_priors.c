/* Priors that follow from how such leaves are built. Nothing here is fitted. A word that names a mechanism is taken to
 * be right in nine of ten assets and more, so that it outweighs a shape that favours another mechanism three to one. */
#include "kinematics/hints/modifier_priors.h"

#include "kinematics/hints/hint_features.h"

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

float dmi_slide_by_definition(dmi_part_kind kind) {
    return kind == DMI_KIND_LEVER ? RARE : 0;
}

float dmi_modifier_likelihood(dmi_label_modifiers modifiers, uint32_t features, float above) {
    return sum_of(modifiers.own, features) + above * sum_of(modifiers.above, features);
}
