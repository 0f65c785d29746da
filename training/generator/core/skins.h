/* Declares surfaces of revolution about Z: single sheets, as low-polygon aircraft have them, or with a thickness.
 * Angles go from +X over +Y. */
#ifndef DMG_SKINS_H
#define DMG_SKINS_H

#include "core/build.h"

typedef struct dmg_skin {
    const dmg_xy* rows; /* radius and z, z rising */
    int count;
    float from, to; /* angles */
    float t;        /* inwards; 0: one sheet, seen from outside */
    float high;     /* of the section, fraction of its width */
} dmg_skin;

void dmg_skin_draw(dmg_builder* b, const dmg_skin* skin);
/* One straight row to the next, over the given angles. */
void dmg_skin_cone(dmg_builder* b, dmg_xy back, dmg_xy front, float from, float to, float t);
/* Returns the point at that angle (counter-clockwise seen from +Z) on the circle of that radius. */
dmg_vec dmg_skin_point(float radius, float angle, float z);

#endif
