/* Draws light folding and portable things: stools on crossed legs, camp tables on folding frames, hampers and litter
 * boxes with swinging flaps. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws two frames crossed on a pin: one stays, the other folds onto it. The seat hangs between their upper rails. */
static void draw_crossed_stool(dmg_builder* b) {
    float h = dmg_range(b, 0.3f, 0.5f), x = h * dmg_range(b, 0.35f, 0.55f), d = dmg_range(b, 0.25f, 0.45f), r = 0.011f,
          z = 0.5f * d, sag = dmg_range(b, 0.03f, 0.07f), back = dmg_range(b, 0.3f, 0.5f),
          turn = 1.4f * atan2f(x, 0.5f * h);
    bool backrest = dmg_chance(b, 0.4f);
    for (int i = 0; i < 2; ++i) {
        float side = i ? -1.0f : 1.0f, at = i ? z - 2.2f * r : z;
        if (i) dmg_hinge(b, 0, "frame", v3(0, 0.5f * h, 0), v3(0, 0, -1), 0.0f, turn);
        for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3(-side * x, r, (float)s * at), v3(side * x, h, (float)s * at), r);
        dmg_rod(b, v3(side * x, h, -at), v3(side * x, h, at), r);
        dmg_rod(b, v3(-side * x, r, -at), v3(-side * x, r, at), r);
    }
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(0, 0.5f * h, (float)s * z), v3(0, 0.5f * h, (float)s * (z + 1.6f * r)), 0.7f * r);
    const dmg_xy cloth[] = {{1.5f * r - x, h - 0.3f * sag}, {-0.5f * x, h - sag}, {0.5f * x, h - sag}, {x, h}};
    dmg_bent_plate(b, cloth, 4, 0.004f, 1.7f * z);
    if (!backrest) return;
    dmg_hinge(b, 0, "backrest", v3(x, h, 0), v3(0, 0, 1), 0.0f, 1.2f);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(x, h, (float)s * (z + 2.2f * r)), v3(1.1f * x, h + back, (float)s * (z + 2.2f * r)), 0.8f * r);
    dmg_beam(b, v3(1.07f * x, h + 0.7f * back, 0), v3(1.1f * x, h + back, 0), 2 * z + 4.4f * r, 0.006f);
    dmg_use(b, 0);
}

/* Draws a top on two hoops that fold in under it. */
static void draw_camp_table(dmg_builder* b) {
    float w = dmg_range(b, 0.5f, 1.2f), d = w * dmg_range(b, 0.5f, 0.75f), h = dmg_range(b, 0.3f, 0.7f), r = 0.011f,
          z = 0.42f * d, t = 0.02f, y = h - t - r;
    dmg_rounded_box(b, v3(0, h - 0.5f * t, 0), v3(w, t, d), 0.006f);
    for (int i = 0; i < 2; ++i) {
        float side = i ? -1.0f : 1.0f, x = 0.42f * side * w, at = i ? z - 2.5f * r : z, drop = i ? 2.5f * r : 0.0f;
        dmg_use(b, 0);
        dmg_box_span(b, v3(x - r, y - drop - r, -0.5f * z), v3(x + r, h - t, 0.5f * z));
        dmg_hinge(b, 0, "legs", v3(x, y - drop, 0), v3(0, 0, -side), 0.0f, 1.45f);
        const dmg_vec hoop[] = {{x, y - drop, -at}, {x, r, -at}, {x, r, at}, {x, y - drop, at}};
        dmg_sweep(b, hoop, 4, r, r, false);
        dmg_rod(b, v3(x, y - drop, -at), v3(x, y - drop, -0.51f * z), r);
        dmg_rod(b, v3(x, y - drop, 0.51f * z), v3(x, y - drop, at), r);
    }
    dmg_use(b, 0);
}

/* Draws a box with a lid hung behind; or a hood with a way in, closed by a flap that swings both ways. */
static void draw_lidded_box(dmg_builder* b, bool litter) {
    float w = dmg_range(b, 0.35f, 0.55f), d = w * dmg_range(b, 0.7f, 1.2f),
          h = litter ? 0.8f * w : w * dmg_range(b, 1.0f, 1.7f), t = 0.008f, x = 0.5f * w, z = 0.5f * d,
          door = 0.55f * w, sill = 0.35f * h, top = 0.85f * h;
    bool swings = dmg_chance(b, 0.8f);
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * (x - 0.5f * t) - 0.5f * t, 0, -z),
                     v3((float)i * (x - 0.5f * t) + 0.5f * t, h, z));
    dmg_box_span(b, v3(t - x, 0, -z), v3(x - t, h, t - z));
    dmg_box_span(b, v3(t - x, 0, t - z), v3(x - t, t, z - t));
    dmg_box_span(b, v3(t - x, 0, z - t), v3(x - t, litter ? sill : h, z));
    for (int i = -1; i <= 1 && litter; i += 2)
        dmg_box_span(b, v3(i < 0 ? t - x : 0.5f * door, sill, z - t), v3(i < 0 ? -0.5f * door : x - t, h, z));
    if (litter) dmg_box_span(b, v3(-0.5f * door, top, z - t), v3(0.5f * door, h, z));
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, h + 0.001f, -z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.8f));
    dmg_rounded_box(b, v3(0, h + 0.016f, 0), v3(1.02f * w, 0.03f, 1.02f * d), 0.01f);
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, lid, "handle", v3(0, h + 0.036f, 0), v3(1, 0, 0), -1.4f, 1.4f);
        const dmg_vec grip[] = {
            {-0.06f, h + 0.036f, 0}, {-0.06f, h + 0.07f, 0}, {0.06f, h + 0.07f, 0}, {0.06f, h + 0.036f, 0}};
        dmg_sweep(b, grip, 4, 0.005f, 0.005f, false);
    }
    dmg_use(b, 0);
    if (!litter) return;
    dmg_hinge(b, 0, "flap", v3(0, top - 0.003f, z - 0.5f * t), v3(-1, 0, 0), swings ? -1.2f : 0.0f, 1.2f);
    dmg_box_span(b, v3(0.004f - 0.5f * door, sill + 0.006f, z - 0.7f * t),
                 v3(0.5f * door - 0.004f, top - 0.003f, z - 0.3f * t));
    dmg_use(b, 0);
}

void dmg_build_folding_stool(dmg_builder* b) {
    switch (dmg_int(b, 0, 3)) {
    case 0:
        draw_crossed_stool(b);
        break;
    case 1:
        draw_camp_table(b);
        break;
    case 2:
        draw_lidded_box(b, true);
        break;
    default:
        draw_lidded_box(b, false);
        break;
    }
}
