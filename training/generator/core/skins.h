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
/* A point on the circle of that radius, and the direction along it there (counter-clockwise seen from +Z). */
dmg_vec dmg_skin_point(float radius, float angle, float z);
dmg_vec dmg_skin_tangent(float angle);

/* A ring of doors or flaps with the fixed strips between them; each turns about the tangent at its share `at` of the
 * way from its front edge to its rear one. */
typedef struct dmg_band {
    const char* name;
    uint32_t parent;
    dmg_xy back, front; /* radius and z of the ring's ends */
    int count;
    float start, arc; /* the sector it fills */
    float fill;       /* share of each place that the door takes */
    float t, at, lower, upper;
    bool inwards; /* the rear edge goes in as the value rises */
    bool strips;  /* the rest of the ring stays */
    bool plates;  /* flat, not curved */
    float rest;
} dmg_band;

void dmg_band_draw(dmg_builder* b, const dmg_band* band);

#endif
