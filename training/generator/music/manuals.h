/* Declares a row of keys for pianos, organs and synthesisers (pianos.c). */
#ifndef DMG_MANUALS_H
#define DMG_MANUALS_H

#include "core/build.h"

/* The white keys' tops are y = 0, their fronts z = 0, they reach back to z = -length. */
typedef struct dmg_manual {
    int whites;
    float pitch, length, rise; /* rise: of a black key */
    float thick, hidden;       /* of a key, and how far behind its end its pin is */
    float dip;                 /* how far a front goes down */
    bool turns, fixed;         /* fixed: drawn, but of the body */
} dmg_manual;

dmg_manual dmg_manual_pick(dmg_builder* b, float pitch);
float dmg_manual_width(const dmg_manual* m);
/* Centred in x, with the bed below. */
void dmg_manual_draw(dmg_builder* b, const dmg_manual* m, uint32_t carrier);

#endif
