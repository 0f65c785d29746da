/* Declares doors of buses and rail cars. */
#ifndef DMG_COACH_DOORS_H
#define DMG_COACH_DOORS_H

#include "parts/hardware.h"

typedef enum dmg_doorway_kind {
    DMG_DOORWAY_FOLD,    /* pairs of leaves hung on each other */
    DMG_DOORWAY_SLIDE,   /* along the outer skin */
    DMG_DOORWAY_HINGED,  /* outwards, on the skin */
    DMG_DOORWAY_POCKET,  /* along the inner skin */
    DMG_DOORWAY_PLUG,    /* out with its carriage, then along the wall */
    DMG_DOORWAY_GLIDER,  /* inwards about a post that stands behind the jamb */
    DMG_DOORWAY_SWINGING /* outwards on an arm, the leaf turning back on its end */
} dmg_doorway_kind;

/* Sill at the origin, x outwards from the skin, z along the wall, in whose middle it is. */
typedef struct dmg_doorway {
    dmg_doorway_kind kind;
    float wide, high, wall, t; /* t: of the leaves */
    bool twin;                 /* parts in the middle */
    float end;                 /* the side, along z, of a single leaf's hinge or way */
    dmg_panel leaf;
    int ramp; /* 0 none, 1 turns over, 2 slides out from under the sill */
} dmg_doorway;

/* hollow: there is room inside. */
dmg_doorway dmg_doorway_pick(dmg_builder* b, bool hollow);
void dmg_doorway_draw(dmg_builder* b, const dmg_doorway* doorway);

#endif
