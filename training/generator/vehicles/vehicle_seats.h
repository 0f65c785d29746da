/* Declares seats of vehicles. */
#ifndef DMG_VEHICLE_SEATS_H
#define DMG_VEHICLE_SEATS_H

#include "core/build.h"

/* Looks to -Z; its floor at y = 0, the middle of the back's hinge at (x, seat, z). */
typedef struct dmg_seat {
    float wide, deep, seat, tall, thick; /* thick: of cushion and back */
    int shell;                           /* rounded blocks, a bent shell, a sporty bucket, slats on tubes */
    int base;                            /* rails it slides on, a block, a post it turns on, legs */
    int head, arms;                      /* 0 none, 1 fixed, 2 that move */
    bool reclines, tray, tips, lever;
} dmg_seat;

dmg_seat dmg_seat_pick(dmg_builder* b);
void dmg_seat_draw(dmg_builder* b, const dmg_seat* seat, float x, float z);

#endif
