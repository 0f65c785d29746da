/* Implements curved sheets about X and the plates that close their ends: hoods, rolling fronts. */
#include "core/arcs.h"

void dmg_profile_begin(dmg_builder* b) {
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
}

void dmg_arc_points(dmg_xy* line, float radius, float from, float to) {
    for (int i = 0; i < DMG_ARC; ++i) {
        float angle = from + (to - from) * (float)i / (DMG_ARC - 1);
        line[i] = (dmg_xy){radius * cosf(angle), radius * sinf(angle)};
    }
}

void dmg_arc_skin(dmg_builder* b, float radius, float from, float to, float wall, float width) {
    dmg_xy line[DMG_ARC];
    dmg_arc_points(line, radius, from, to);
    dmg_profile_begin(b);
    dmg_bent_plate(b, line, DMG_ARC, wall, width);
    dmg_restore(b);
}

void dmg_arc_cheek(dmg_builder* b, float radius, float from, float to, float x, float t, bool radii) {
    dmg_xy outline[DMG_ARC + 1] = {{0, 0}};
    dmg_arc_points(outline, radius, from, to);
    outline[DMG_ARC] = (dmg_xy){0, 0};
    dmg_profile_begin(b);
    dmg_extrude(b, outline, radii ? DMG_ARC + 1 : DMG_ARC, -x - 0.5f * t, -x + 0.5f * t);
    dmg_restore(b);
}
