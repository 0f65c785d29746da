/* Implements running gear of rail vehicles: wheels with flanges, bogies, buffers and couplings. */
#include "parts/rails.h"

#include "parts/walls.h"

dmg_running dmg_running_pick(dmg_builder* b, float r) {
    dmg_running n = {.r = r};
    n.gauge = dmg_range(b, 0.6f, 0.85f);
    n.wheel = dmg_chance(b, 0.5f) ? 0 : dmg_int(b, 5, 12);
    n.loose = dmg_chance(b, 0.2f);
    return n;
}

/* Draws a tread with its flange inside; a plate or spokes within. */
static void draw_rail_wheel(dmg_builder* b, const dmg_running* n, float side, float z) {
    float r = n->r, in = n->wheel == 0 ? 0.0f : 0.8f * r;
    const dmg_xy rim[] = {{in, -0.09f},       {r, -0.09f}, {r, -0.05f}, {0.94f * r, -0.04f},
                          {0.92f * r, 0.08f}, {in, 0.08f}, {in, -0.09f}};
    dmg_wall_enter(b, v3(side * n->gauge, r, z), side * 0.5f * DMG_PI);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), rim, n->wheel == 0 ? 6 : 7);
    dmg_rod(b, v3(0, 0, -0.1f), v3(0, 0, 0.11f), 0.2f * r);
    for (int i = 0; i < n->wheel; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, n->wheel);
        dmg_box_span(b, v3(0.1f * r, -0.04f * r, -0.03f), v3(0.85f * r, 0.04f * r, 0.03f));
        dmg_restore(b);
    }
    dmg_restore(b);
}

void dmg_wheelset_draw(dmg_builder* b, const dmg_running* n, uint32_t parent, float z) {
    dmg_vec centre = {0, n->r, z};
    dmg_use(b, parent);
    if (n->loose) dmg_rod(b, v3(-n->gauge, n->r, z), v3(n->gauge, n->r, z), 0.1f * n->r);
    if (!n->loose) {
        dmg_spin(b, parent, "wheelset", centre, v3(dmg_sign(b), 0, 0));
        dmg_rod(b, v3(-n->gauge, n->r, z), v3(n->gauge, n->r, z), 0.1f * n->r);
    }
    for (int s = -1; s <= 1; s += 2) {
        if (n->loose) dmg_spin(b, parent, "wheel", v3((float)s * n->gauge, n->r, z), v3(dmg_sign(b), 0, 0));
        draw_rail_wheel(b, n, (float)s, z);
    }
    dmg_use(b, parent);
}

/* Two or three axles in a frame that turns about a pin below the floor at y = top. */
void dmg_bogie_draw(dmg_builder* b, const dmg_running* n, float z, float top, int axles) {
    float pitch = n->r * dmg_range(b, 2.3f, 3.0f), x = n->gauge - 0.22f, long_half = 0.5f * pitch * (float)(axles - 1);
    bool outside = dmg_chance(b, 0.5f);
    if (outside) x = n->gauge + 0.2f;
    dmg_rod(b, v3(0, 1.4f * n->r, z), v3(0, top, z), 0.15f);
    uint32_t bogie = dmg_hinge(b, 0, "bogie", v3(0, n->r, z), v3(0, dmg_sign(b), 0), -0.15f, 0.15f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * x, 1.05f * n->r, z), v3(0.12f, 0.5f * n->r, 2 * long_half + 1.2f * n->r));
    dmg_box(b, v3(0, 1.2f * n->r, z), v3(2 * x, 0.3f * n->r, 0.4f * n->r));
    for (int i = 0; i < axles; ++i) dmg_wheelset_draw(b, n, bogie, z - long_half + pitch * (float)i);
    dmg_use(b, 0);
}

/* Buffers that give way and what couples, on a beam facing `dir` (1 or -1) at z. */
void dmg_buffing_draw(dmg_builder* b, uint32_t parent, float y, float z, float dir) {
    float r = dmg_range(b, 0.16f, 0.26f), way = dmg_range(b, 0.08f, 0.2f), x = dmg_range(b, 0.75f, 0.95f);
    int coupling = dmg_int(b, 0, 3);
    bool buffers = coupling != 3 || dmg_chance(b, 0.3f);
    dmg_wall_enter(b, v3(0, y, z), dir > 0 ? 0.0f : DMG_PI);
    dmg_use(b, parent);
    dmg_box(b, v3(0, 0, -0.06f), v3(2.4f, 0.35f, 0.12f));
    for (int s = -1; s <= 1 && buffers; s += 2) {
        const dmg_xy barrel[] = {
            {0.55f * r, 0.25f}, {0.55f * r, 0}, {0.8f * r, 0}, {0.7f * r, 0.25f}, {0.55f * r, 0.25f}};
        dmg_use(b, parent);
        dmg_lathe(b, v3((float)s * x, 0, 0), v3(0, 0, 1), barrel, 5);
        dmg_slide(b, parent, "buffer", v3(0, 0, -1), 0.0f, way);
        dmg_rod(b, v3((float)s * x, 0, 0.22f - way * 0.3f), v3((float)s * x, 0, 0.28f + way), 0.45f * r);
        dmg_rod(b, v3((float)s * x, 0, 0.28f + way), v3((float)s * x, 0, 0.34f + way), r);
    }
    dmg_use(b, parent);
    if (coupling < 2) { /* a hook, and a chain hanging from it */
        dmg_box(b, v3(0, 0, 0.12f), v3(0.06f, 0.12f, 0.26f));
        dmg_hinge(b, parent, "link", v3(0, -0.04f, 0.2f), v3(-1, 0, 0), 0.0f, 1.5f);
        const dmg_vec loop[] = {
            {-0.07f, -0.04f, 0.2f}, {0.07f, -0.04f, 0.2f}, {0.07f, -0.45f, 0.2f}, {-0.07f, -0.45f, 0.2f}};
        dmg_sweep(b, loop, 4, 0.02f, 0.02f, true);
    } else if (coupling == 3) { /* a claw on a shank that swings sideways, its knuckle */
        uint32_t shank = dmg_hinge(b, parent, "coupler", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -0.25f, 0.25f);
        dmg_box(b, v3(0, 0, 0.25f), v3(0.14f, 0.16f, 0.5f));
        dmg_box(b, v3(-0.12f, 0, 0.55f), v3(0.14f, 0.24f, 0.2f));
        dmg_hinge(b, shank, "knuckle", v3(0.1f, 0, 0.52f), v3(0, 1, 0), 0.0f, 0.9f);
        dmg_rod(b, v3(0.1f, -0.13f, 0.52f), v3(0.1f, 0.13f, 0.52f), 0.05f);
        dmg_box(b, v3(0.09f, 0, 0.63f), v3(0.1f, 0.22f, 0.2f));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}
