/* Declares running gear of rail vehicles: wheels with flanges, bogies, buffers and couplings. */
#ifndef DMG_RAILS_H
#define DMG_RAILS_H

#include "core/build.h"

typedef struct dmg_running {
    float gauge, r; /* half the gauge, radius of the wheels */
    int wheel;      /* its spokes; 0: a disc */
    bool loose;     /* the wheels of an axle turn apart */
} dmg_running;

dmg_running dmg_running_pick(dmg_builder* b, float r);
void dmg_wheelset_draw(dmg_builder* b, const dmg_running* n, uint32_t parent, float z);
/* Two or three axles in a frame that turns about a pin below the floor at y = top. */
void dmg_bogie_draw(dmg_builder* b, const dmg_running* n, float z, float top, int axles);
/* Buffers that give way and what couples, on a beam facing `dir` (1 or -1) at z. */
void dmg_buffing_draw(dmg_builder* b, uint32_t parent, float y, float z, float dir);

#endif
