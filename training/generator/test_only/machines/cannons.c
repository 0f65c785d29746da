/* Draws things that throw water or light from a pivot: water cannons, searchlights, signal lamps with slats,
 * beacons. */
#include "core/build.h"
#include "parts/walls.h"
#include "parts/works.h"

/* In the head's frame the barrel or the light looks along +Z; the head is the part in use. */
static void draw_cannon_head(dmg_builder* b, uint32_t head, float s) {
    float l = s * dmg_range(b, 2.0f, 4.5f), r = s * dmg_range(b, 0.2f, 0.4f);
    int tip = dmg_int(b, 0, 2);
    bool handles = dmg_chance(b, 0.4f);
    dmg_cone(b, v3(0, 0, -0.5f * s), v3(0, 0, l), r, 0.6f * r);
    dmg_rod(b, v3(0, 0, -0.3f * s), v3(0, 0, 0.4f * s), 1.3f * r);
    for (int k = -1; k <= 1 && handles; k += 2)
        dmg_beam(b, v3((float)k * r, 0, -0.2f * s), v3((float)k * 1.2f * s, 0.2f * s, -1.5f * s), 0.1f * s, 0.1f * s);
    if (tip < 2) {
        dmg_spin(b, head, "nozzle", v3(0, 0, l), v3(0, 0, dmg_sign(b)));
        dmg_cone(b, v3(0, 0, 1.001f * l), v3(0, 0, l + 1.2f * s), 0.8f * r, 1.3f * r);
        for (int k = -1; k <= 1; k += 2)
            dmg_box(b, v3((float)k * r, 0, l + 0.5f * s), v3(0.3f * r, 0.3f * r, 0.8f * s));
    } else { /* a lip that bends the jet */
        dmg_hinge(b, head, "deflector", v3(0, 0.7f * r, l), v3(1, 0, 0), 0.0f, 0.7f);
        dmg_box_span(b, v3(-0.7f * r, 0.65f * r, 1.005f * l), v3(0.7f * r, 0.8f * r, l + s));
    }
    dmg_use(b, head);
    dmg_wall_enter(b, v3(1.3f * r, 0, 0), 0.5f * DMG_PI);
    dmg_wall_lever_draw(b, head, "deluge_lever", 0.9f * s, dmg_range(b, 0.0f, 3.0f), 1.57f);
    dmg_restore(b);
}

/* Draws a drum with a glass before it; slats that shutter it, or a glass that hinges open; a lid behind. */
static void draw_lamp_head(dmg_builder* b, uint32_t head, float s) {
    float r = s * dmg_range(b, 0.7f, 1.0f), l = s * dmg_range(b, 0.6f, 1.3f), t = 0.04f * s;
    int front = dmg_int(b, 0, 2), slats = dmg_int(b, 4, 9);
    dmg_cone(b, v3(0, 0, -l), v3(0, 0, 0.5f * l), 0.8f * r, r);
    dmg_wall_enter(b, v3(0, 0, -l), DMG_PI);
    dmg_wall_lid_draw(b, head, "rear_lid", 0.5f * r);
    dmg_restore(b);
    float z = 0.5f * l, each = 1.8f * r / (float)slats;
    if (front == 0) {
        dmg_hinge(b, head, "glass", v3(1.05f * r, 0, z + 1.5f * t), v3(0, 1, 0), 0.0f, 2.2f);
        dmg_torus(b, v3(0, 0, z + 1.5f * t), v3(0, 0, 1), r, t);
        dmg_rod(b, v3(0, 0, z + 1.2f * t), v3(0, 0, z + 1.8f * t), r);
    } else if (front == 1) {
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * 1.05f * r - t, -r, z - t), v3((float)k * 1.05f * r + t, r, z + 1.2f * each));
        for (int i = 0; i < slats; ++i) {
            float y = -0.9f * r + each * ((float)i + 0.5f);
            dmg_hinge(b, head, "shutter_slat", v3(0, y, z + 0.6f * each), v3(1, 0, 0), 0.0f, 1.4f);
            dmg_box(b, v3(0, y, z + 0.6f * each), v3(2.0f * r, 0.95f * each, 0.06f * each));
            dmg_use(b, head);
        }
        dmg_wall_enter(b, v3(1.05f * r + t, 0, z + 0.4f * each), 0.5f * DMG_PI);
        dmg_wall_lever_draw(b, head, "shutter_lever", 0.7f * s, 3.14f, 0.6f);
        dmg_restore(b);
    } else {
        dmg_rod(b, v3(0, 0, z - t), v3(0, 0, z + t), 0.95f * r);
        dmg_hinge(b, head, "visor", v3(0, r + t, z), v3(-1, 0, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(-0.7f * r, r + 0.6f * t, z), v3(0.7f * r, r + 1.4f * t, z + 0.8f * r));
    }
    dmg_use(b, head);
}

/* Draws a lens and a lamp going round in a glazed lantern with a door. */
static void draw_beacon(dmg_builder* b, float s) {
    float base = s * dmg_range(b, 0.5f, 4.0f), r = s, high = s * dmg_range(b, 1.6f, 2.4f);
    int posts = dmg_int(b, 5, 9), lenses = dmg_int(b, 1, 4);
    dmg_cone(b, v3(0, 0, 0), v3(0, base, 0), r * dmg_range(b, 1.0f, 1.4f), r);
    dmg_rod(b, v3(0, base, 0), v3(0, base + 0.1f * s, 0), 1.3f * r);
    dmg_cone(b, v3(0, base + high, 0), v3(0, base + high + 0.7f * s, 0), 1.1f * r, 0.1f * r);
    for (int i = 0; i < posts; ++i) {
        float a = 6.2832f * ((float)i + 0.5f) / (float)posts;
        dmg_rod(b, v3(0.97f * r * sinf(a), base, 0.97f * r * cosf(a)),
                v3(0.97f * r * sinf(a), base + high, 0.97f * r * cosf(a)), 0.04f * r);
    }
    float y = base + 0.5f * high, wide = 2 * 0.97f * r * sinf(DMG_PI / (float)posts);
    dmg_wall_enter(b, v3(0, y, 1.0f * r), 0.0f);
    dmg_wall_leaf_draw(b, 0, "lantern_door", 0.9f * wide, 0.85f * high, DMG_SIDE_LEFT);
    dmg_restore(b);
    dmg_rod(b, v3(0, base + 0.1f * s, 0), v3(0, base + 0.25f * high, 0), 0.2f * r);
    dmg_spin(b, 0, "lens", v3(0, y, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, base + 0.26f * high, 0), v3(0, base + 0.8f * high, 0), 0.12f * r);
    for (int i = 0; i < lenses; ++i) {
        float a = 6.2832f * (float)i / (float)lenses + 0.3f;
        dmg_vec out = {sinf(a), 0, cosf(a)}, at = {0, y, 0};
        dmg_cone(b, v3_mad(at, out, 0.15f * r), v3_mad(at, out, 0.6f * r), 0.15f * r, 0.3f * r);
    }
    dmg_use(b, 0);
}

void dmg_build_water_cannon(dmg_builder* b) {
    float s = dmg_scale_range(b, 0.06f, 0.6f);
    int kind = dmg_weighted(b, (const float[]){4, 4, 2}, 3);
    if (kind == 2) {
        draw_beacon(b, s);
        return;
    }
    float foot = s * dmg_range(b, 0.4f, 4.0f), ear = s * dmg_range(b, 1.1f, 1.5f), y = foot + 1.7f * s;
    bool plate = dmg_chance(b, 0.6f), wheel = dmg_chance(b, 0.4f);
    if (plate) dmg_rod(b, v3(0, 0, 0), v3(0, 0.12f * s, 0), 1.2f * s);
    dmg_cone(b, v3(0, 0, 0), v3(0, foot, 0), 0.6f * s, 0.4f * s);
    if (wheel) {
        dmg_wall_enter(b, v3(0, 0.5f * foot, 0.48f * s), 0.0f);
        dmg_wall_wheel_draw(b, 0, "valve", 0.4f * fminf(s, foot));
        dmg_restore(b);
    }
    uint32_t pan = dmg_hinge(b, 0, "pan", v3(0, foot, 0), v3(0, dmg_sign(b), 0), -2.8f, 2.8f);
    dmg_rod(b, v3(0, 1.01f * foot, 0), v3(0, foot + 0.25f * s, 0), 0.6f * s);
    dmg_box(b, v3(0, foot + 0.3f * s, 0), v3(2 * ear + 0.16f * s, 0.16f * s, 0.6f * s));
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * ear - 0.08f * s, foot + 0.25f * s, -0.25f * s),
                     v3((float)k * ear + 0.08f * s, y + 0.2f * s, 0.25f * s));
    uint32_t head = dmg_hinge_across(b, pan, "tilt", v3(0, y, 0), -0.3f, 1.1f);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_rod(b, v3(-1.02f * ear, 0, 0), v3(1.02f * ear, 0, 0), 0.12f * s);
    if (kind == 0)
        draw_cannon_head(b, head, s);
    else
        draw_lamp_head(b, head, s);
    dmg_restore(b);
    dmg_use(b, 0);
}
