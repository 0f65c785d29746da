/* Declares wings: root at the origin, span along +X, nose to +Z, thin along Y. */
#ifndef DMG_WINGS_H
#define DMG_WINGS_H

#include "core/build.h"

typedef struct dmg_wing {
    float span, root, tip; /* chords */
    float sweep;           /* of the leading edge: how far the tip lies back */
    float thick;           /* fraction of the chord */
    float dihedral;
    bool flat; /* a plate, not a profile */
} dmg_wing;

/* A movable trailing edge from s0 to s1, its hinge at the fraction c of the chord. */
typedef struct dmg_surface {
    const char* name;
    float s0, s1, c, swing;
    bool drops; /* goes down alone, as flaps do */
} dmg_surface;

dmg_wing dmg_wing_pick(dmg_builder* b, float span, float root);
/* A point of the wing: s along the span, c along the chord from the leading edge, side -1 … 1 of the thickness. */
dmg_vec dmg_wing_point(const dmg_wing* w, float s, float c, float side);
/* The wing between two places along the span (x, y) and from `fore` to `aft` on the chord, at the one and at the other.
 */
void dmg_wing_patch_draw(dmg_builder* b, const dmg_wing* w, dmg_xy s, dmg_xy fore, dmg_xy aft);
/* The same with both at equal shares of the chord. */
void dmg_wing_piece_draw(dmg_builder* b, const dmg_wing* w, float s0, float s1, float c0, float c1);
/* The wing with its surfaces cut out of it; surfaces in order along the span. */
void dmg_wing_draw(dmg_builder* b, const dmg_wing* w, uint32_t parent, const dmg_surface* surfaces, int count);
/* One or two surfaces, inner and outer; either may be missing (NULL). Returns their number. */
int dmg_surfaces_pick(dmg_builder* b, dmg_surface out[2], const char* inner, const char* outer);

#endif
