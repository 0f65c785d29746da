/* Declares lorries: rails, axles, a cab that may tilt. */
#ifndef DMG_TRUCKS_H
#define DMG_TRUCKS_H

#include "parts/works.h"

typedef struct dmg_truck {
    float half, length, deck; /* half width; of the body behind the cab, whose rear end is z = 0; top of the rails */
    float cab, roof, nose;    /* length of the cab, its height; of a bonnet before it: 0 where there is none */
    float wheel;
} dmg_truck;

dmg_truck dmg_truck_pick(dmg_builder* b, float size);
void dmg_truck_draw(dmg_builder* b, const dmg_truck* truck);

#endif
