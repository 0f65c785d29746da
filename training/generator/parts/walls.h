/* Declares what the walls of large machines carry: doors and hatches laid on them, round lids, sticks. A
 * wall is the plane z = 0 of the frame, seen from +Z. */
#ifndef DMG_WALLS_H
#define DMG_WALLS_H

#include "parts/hardware.h"

/* Saves the frame and goes to a place on an upright wall; `facing` about Y brings +Z to where the wall faces. */
void dmg_wall_enter(dmg_builder* b, dmg_vec at, float facing);
/* The same on a level roof or deck; +Y of the wall is -Z of the object. */
void dmg_roof_enter(dmg_builder* b, dmg_vec at);
/* A leaf of any make on the wall, centred. Returns it; the parent is in use again. */
uint32_t dmg_wall_leaf_draw(dmg_builder* b, uint32_t parent, const char* name, float width, float height,
                            dmg_side side);
/* A round lid on a collar: hung at its edge (+Y), swung aside about a pin, or a cap that screws. */
void dmg_wall_lid_draw(dmg_builder* b, uint32_t parent, const char* name, float r);
/* A lever that stands out of the wall (a floor, a desk) and leans about X. */
void dmg_wall_stick_draw(dmg_builder* b, uint32_t parent, const char* name, float length);
/* A hand wheel on a shaft. */
void dmg_wall_wheel_draw(dmg_builder* b, uint32_t parent, const char* name, float r);

#endif
