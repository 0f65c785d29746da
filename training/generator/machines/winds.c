/* Draws wind-driven machines: power turbines with slender blades, windmills with sails, vanes, cups and socks on
 * masts. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a blade along +X from the hub, about Z: wide near its root, thin at the tip, twisted. */
static void draw_slender_blade(dmg_builder* b, float hub, float radius, float chord, float twist, bool flat) {
    enum { STATIONS = 5 };
    static const float along[STATIONS] = {0.0f, 0.2f, 0.5f, 0.8f, 1.0f},
                       wide[STATIONS] = {0.4f, 1.0f, 0.7f, 0.4f, 0.15f};
    uint32_t v[STATIONS][4];
    dmg_piece_begin(b);
    for (int i = 0; i < STATIONS; ++i) {
        float x = hub + (radius - hub) * along[i], c = chord * wide[i], t = flat ? 0.03f * chord : 0.2f * c,
              angle = twist * (1.0f - along[i]), s = sinf(angle), k = cosf(angle);
        const dmg_xy section[4] = {{-0.35f * c, 0}, {0, -0.5f * t}, {0.65f * c, 0}, {0, 0.5f * t}};
        for (int j = 0; j < 4; ++j)
            v[i][j] = dmg_vertex(b, v3(x, section[j].x * k - section[j].y * s, section[j].x * s + section[j].y * k));
    }
    for (int i = 0; i + 1 < STATIONS; ++i)
        for (int j = 0; j < 4; ++j) dmg_quad(b, v[i][j], v[i][(j + 1) % 4], v[i + 1][(j + 1) % 4], v[i + 1][j]);
    dmg_quad(b, v[STATIONS - 1][0], v[STATIONS - 1][1], v[STATIONS - 1][2], v[STATIONS - 1][3]);
    dmg_quad(b, v[0][3], v[0][2], v[0][1], v[0][0]);
}

/* Blades turn about their own length, the rotor about a shaft that looks up a little, the house about the tower. */
void dmg_build_power_turbine(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.5f, 60), tower = radius * dmg_range(b, 1.05f, 2.6f),
          foot = radius * dmg_range(b, 0.02f, 0.07f), deep = radius * dmg_range(b, 0.06f, 0.35f),
          thick = fminf(deep, radius * dmg_range(b, 0.03f, 0.1f)), hub = 0.5f * thick;
    int count = dmg_chance(b, 0.75f) ? 3 : dmg_int(b, 1, 4), house = dmg_int(b, 0, 2);
    dmg_cone(b, v3(0, 0, 0), v3(0, tower, 0), foot, foot * dmg_range(b, 0.5f, 0.9f));
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0.02f * tower, 0), 3 * foot);
    dmg_move(b, 0, tower, 0);
    uint32_t head = 0;
    if (dmg_chance(b, 0.75f))
        head = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "nacelle", v3(0, 0, 0), v3(0, 1, 0))
                                   : dmg_hinge_either_way(b, 0, "nacelle", v3(0, 0, 0), v3(0, 1, 0), 0.5f, 3.1f);
    dmg_move(b, 0, 0.5f * thick, deep * dmg_range(b, -0.3f, 0.1f));
    if (house == 0) dmg_box(b, v3(0, 0, 0), v3(thick, thick, deep));
    if (house == 1) dmg_rounded_box(b, v3(0, 0, 0), v3(thick, thick, deep), 0.35f * thick);
    if (house == 2) dmg_cone(b, v3(0, 0, -0.5f * deep), v3(0, 0, 0.5f * deep), 0.3f * thick, 0.55f * thick);
    float tilt = dmg_chance(b, 0.5f) ? dmg_range(b, 0.02f, 0.12f) : 0.0f;
    dmg_move(b, 0, 0, 0.5f * deep + 1.2f * hub);
    dmg_turn(b, v3(1, 0, 0), -tilt);
    uint32_t rotor = dmg_spin(b, head, "rotor", v3(0, 0, 0), v3(0, 0, 1));
    if (dmg_chance(b, 0.6f))
        dmg_ellipsoid(b, v3(0, 0, 0), v3(hub, hub, 1.3f * hub));
    else
        dmg_cone(b, v3(0, 0, -hub), v3(0, 0, 1.5f * hub), hub, 0.2f * hub);
    bool pitches = dmg_chance(b, 0.2f), flat = dmg_chance(b, 0.2f);
    float chord = radius * dmg_range(b, 0.04f, 0.14f), twist = dmg_range(b, 0.0f, 0.6f), first = dmg_range(b, 0, 6.2f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), first + 2.0f * DMG_PI * (float)i / (float)count);
        if (pitches) dmg_hinge(b, rotor, "blade", v3(0, 0, 0), v3(1, 0, 0), -0.2f, dmg_range(b, 0.6f, 1.5f));
        draw_slender_blade(b, 0.6f * hub, radius, chord, twist, flat);
        dmg_restore(b);
        dmg_use(b, rotor);
    }
    dmg_use(b, 0);
}

/* ---- mills ---- */

/* Draws four sails of lattice, or a wheel of many small blades. */
static void draw_sails(dmg_builder* b, float radius, int count) {
    float wide = radius * dmg_range(b, 0.12f, 0.3f), t = 0.015f * radius;
    int bars = dmg_int(b, 3, 7);
    bool cloth = dmg_chance(b, 0.4f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), 2.0f * DMG_PI * (float)i / (float)count + 0.3f);
        dmg_beam(b, v3(0, 0, 0), v3(radius, 0, 0), 1.5f * t, 1.5f * t);
        if (cloth) dmg_box(b, v3(0.6f * radius, 0.5f * wide, 0), v3(0.75f * radius, wide, 0.3f * t));
        if (!cloth) dmg_beam(b, v3(0.22f * radius, wide, 0), v3(radius, wide, 0), t, t);
        for (int k = 0; k < bars && !cloth; ++k) {
            float x = radius * (0.22f + 0.77f * (float)k / (float)(bars - 1));
            dmg_beam(b, v3(x, 0, 0), v3(x, wide, 0), t, t);
        }
        dmg_restore(b);
    }
}

void dmg_build_windmill(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.3f, 12), high = radius * dmg_range(b, 1.1f, 2.4f),
          wide = radius * dmg_range(b, 0.3f, 0.6f), deep = 0.5f * wide;
    bool farm = dmg_chance(b, 0.45f); /* a wheel with a vane on a lattice; else a house with a cap */
    if (farm)
        for (int i = 0; i < 4; ++i) {
            float x = i & 1 ? 1.0f : -1.0f, z = i & 2 ? 1.0f : -1.0f;
            dmg_beam(b, v3(x * wide, 0, z * wide), v3(0, high, 0), 0.06f * wide, 0.06f * wide);
            dmg_beam(b, v3(0.6f * x * wide, 0.4f * high, 0.6f * z * wide),
                     v3(-0.6f * x * wide, 0.4f * high, 0.6f * z * wide), 0.05f * wide, 0.05f * wide);
        }
    else
        dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), wide, wide * dmg_range(b, 0.5f, 0.9f));
    dmg_move(b, 0, high, 0);
    uint32_t cap = 0;
    if (dmg_chance(b, 0.75f)) cap = dmg_spin(b, 0, "cap", v3(0, 0, 0), v3(0, 1, 0));
    if (farm) {
        dmg_box(b, v3(0, 0.1f * wide, 0), v3(0.2f * wide, 0.2f * wide, 0.4f * wide));
        dmg_beam(b, v3(0, 0.1f * wide, 0), v3(0, 0.1f * wide, -0.9f * radius), 0.05f * wide, 0.05f * wide);
        bool folds = dmg_chance(b, 0.3f);
        if (folds) dmg_hinge(b, cap, "vane", v3(0, 0, -0.5f * radius), v3(0, 1, 0), -0.2f, 1.5f);
        dmg_box(b, v3(0, 0.1f * wide, -0.8f * radius), v3(0.03f * wide, 0.35f * radius, 0.6f * radius));
        dmg_use(b, cap);
    } else {
        int roof = dmg_int(b, 0, 1);
        if (roof) dmg_dome(b, v3(0, 0, 0), v3(0.75f * wide, 0.7f * wide, 0.9f * wide));
        if (!roof) dmg_cone(b, v3(0, 0, 0), v3(0, 0.8f * wide, 0), 0.9f * wide, 0.1f * wide);
        if (dmg_chance(b, 0.4f))
            dmg_beam(b, v3(0, 0.3f * wide, -0.7f * wide), v3(0, -0.6f * high, -1.8f * wide), 0.06f * wide,
                     0.06f * wide);
        deep = wide;
    }
    dmg_move(b, 0, farm ? 0.1f * wide : 0.25f * wide, deep);
    dmg_use(b, cap);
    dmg_rod(b, v3(0, 0, -deep), v3(0, 0, 0.05f * wide), 0.06f * wide);
    dmg_spin(b, cap, "sails", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.15f * wide), 0.1f * wide);
    dmg_move(b, 0, 0, 0.1f * wide);
    if (farm) {
        for (int i = 0; i < 3; ++i) {
            dmg_vec spoke = {0.5f * radius * cosf(1.047f * (float)i), 0.5f * radius * sinf(1.047f * (float)i), 0};
            dmg_rod(b, v3_scale(spoke, -1.0f), spoke, 0.012f * radius);
        }
        dmg_blades_draw(b, 0, 0.85f * radius, 0.3f * radius, 0.16f * radius, dmg_int(b, 8, 18), 0.6f);
    } else
        draw_sails(b, radius, dmg_chance(b, 0.8f) ? 4 : dmg_int(b, 3, 8));
    dmg_use(b, 0);
}

/* ---- instruments of the wind ---- */

/* Cups on spokes about the mast. */
static void draw_cups(dmg_builder* b, float size) {
    int count = dmg_int(b, 3, 4);
    dmg_spin(b, 0, "cups", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.3f * size, 0), 0.12f * size);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, count);
        dmg_rod(b, v3(0, 0.15f * size, 0), v3(size, 0.15f * size, 0), 0.03f * size);
        dmg_move(b, size, 0.15f * size, 0);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_dome(b, v3(0, 0, 0), v3(0.28f * size, 0.28f * size, 0.28f * size));
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws an arrow, a plate or a bird that looks into the wind. */
static void draw_vane(dmg_builder* b, float size) {
    float tail = size * dmg_range(b, 0.5f, 1.2f), high = size * dmg_range(b, 0.3f, 0.9f);
    dmg_spin(b, 0, "vane", v3(0, 0, 0), v3(0, 1, 0));
    if (dmg_chance(b, 0.7f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0.4f * size, 0), 0.06f * size);
    dmg_rod(b, v3(0, 0.3f * size, -tail), v3(0, 0.3f * size, size), 0.04f * size);
    dmg_cone(b, v3(0, 0.3f * size, size), v3(0, 0.3f * size, 1.3f * size), 0.12f * size, 0);
    dmg_box(b, v3(0, 0.3f * size, -tail), v3(0.03f * size, high, 0.5f * size));
    dmg_use(b, 0);
}

/* Lengths of cloth that sag one from the other, hung in the middle or at the upper edge of the ring before. */
static void draw_sock(dmg_builder* b, float size) {
    float length = size * dmg_range(b, 2, 6), radius = size * dmg_range(b, 0.3f, 0.7f),
          out = dmg_chance(b, 0.5f) ? 0.0f : size * dmg_range(b, 0.2f, 1.0f), taper = dmg_range(b, 0.3f, 0.8f),
          sag = dmg_range(b, 0.1f, 0.8f);
    int pieces = dmg_int(b, 1, 6);
    bool top = dmg_chance(b, 0.6f), bare = dmg_chance(b, 0.5f), shown = dmg_chance(b, 0.5f);
    uint32_t carrier = dmg_spin(b, 0, "sock", v3(0, 0, 0), v3(0, 1, 0));
    if (bare) { /* the first length of cloth is all that turns about the mast */
        const dmg_xy tube[] = {{radius, 0}, {radius, 0.15f * length}};
        dmg_lathe(b, v3(0, 0, out), v3(0, 0, 1), tube, 2);
    } else {
        dmg_torus(b, v3(0, 0, out + 0.05f * size), v3(0, 0, 1), radius, 0.04f * size);
        dmg_rod(b, v3(0, -radius, out + 0.05f * size), v3(0, radius, out + 0.05f * size), 0.04f * size);
        dmg_beam(b, v3(0, 0, 0), v3(0, 0, out + 0.05f * size), 0.06f * size, 0.06f * size);
    }
    float z = out + (bare ? 0.15f * length : 0.05f * size);
    for (int i = 0; i < pieces; ++i) {
        float r0 = radius * (1.0f - (1.0f - taper) * (float)i / (float)pieces),
              r1 = r0 - radius * (1.0f - taper) / (float)pieces, each = length / (float)pieces,
              swing = sag * dmg_range(b, 0.5f, 1.5f) / sqrtf((float)pieces);
        uint32_t cloth = dmg_hinge(b, carrier, "cloth", v3(0, top ? r0 : 0.0f, z), v3(1, 0, 0), 0.0f, swing);
        if (shown) dmg_rest(b, cloth, swing * dmg_range(b, 0.3f, 1.0f));
        const dmg_xy tube[] = {{r0, 0}, {r1, each}};
        dmg_lathe(b, v3(0, 0, z), v3(0, 0, 1), tube, 2);
        carrier = cloth;
        z += each;
    }
    dmg_use(b, 0);
}

void dmg_build_wind_mast(dmg_builder* b) {
    float high = dmg_scale_range(b, 0.3f, 10), size = high * dmg_range(b, 0.05f, 0.2f),
          pole = high * dmg_range(b, 0.005f, 0.02f);
    int kind = dmg_int(b, 0, 4);
    dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), 1.6f * pole, pole);
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, 0.01f * high, 0), v3(0.15f * high, 0.02f * high, 0.15f * high));
    if (kind == 0) { /* two instruments on a crossbar */
        dmg_beam(b, v3(-1.5f * size, 0.95f * high, 0), v3(1.5f * size, 0.95f * high, 0), pole, pole);
        for (int s = -1; s <= 1; s += 2) {
            dmg_save(b);
            dmg_move(b, (float)s * 1.5f * size, 0.95f * high, 0);
            dmg_rod(b, v3(0, 0, 0), v3(0, 0.3f * size, 0), pole);
            dmg_move(b, 0, 0.3f * size, 0);
            if (s < 0)
                draw_cups(b, 0.6f * size);
            else
                draw_vane(b, 0.7f * size);
            dmg_restore(b);
        }
        return;
    }
    dmg_move(b, 0, kind > 2 ? high - 0.4f * size : high, 0);
    if (kind == 1) draw_cups(b, size);
    if (kind == 2) draw_vane(b, size);
    if (kind > 2) draw_sock(b, size);
}
