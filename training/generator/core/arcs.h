/* Declares curved sheets about X. Their profiles lie in z (the profile's x) and y; angles go from the front (0) over
 * the top. */
#ifndef DMG_ARCS_H
#define DMG_ARCS_H

#include "core/build.h"

enum { DMG_ARC = 11 }; /* points of an arc */

/* Until dmg_restore, shapes drawn in x, y lie in z, y, and their z is -x. */
void dmg_profile_begin(dmg_builder* b);
void dmg_arc_points(dmg_xy* line, float radius, float from, float to);
/* A curved sheet about X through the origin. */
void dmg_arc_skin(dmg_builder* b, float radius, float from, float to, float wall, float width);
/* The plate that closes such a sheet at x: cut off by its chord, or by its two radii. */
void dmg_arc_cheek(dmg_builder* b, float radius, float from, float to, float x, float t, bool radii);

#endif
