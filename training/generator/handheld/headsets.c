/* Draws headsets: a visor that tips up or slides forward on its band, ear cups that swivel on a bow, the wheel that
 * tightens the strap. The face looks to +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

enum { BAND = 14 };

typedef struct head_set {
    float wide, deep, high; /* half the width and depth of the head; height of the visor */
    float strap;            /* width of the band */
} head_set;

/* A band round the head from one share of the turn to another, 0 at the face: lying, or tipped up about X at the face.
 */
static void draw_band(dmg_builder* b, const head_set* h, float from, float to, float thick) {
    dmg_vec path[BAND];
    bool whole = to - from > 0.999f;
    for (int i = 0; i < BAND; ++i) {
        float angle = 2.0f * DMG_PI * (from + (to - from) * (float)i / (whole ? BAND : BAND - 1));
        path[i] = v3(h->wide * sinf(angle), 0, h->deep * cosf(angle));
    }
    dmg_sweep(b, path, BAND, thick, 0.5f * h->strap, whole);
}

/* Over the crown, from side to side or from the face to the back. */
static void draw_crown(dmg_builder* b, const head_set* h, bool across, float thick) {
    dmg_vec path[BAND];
    for (int i = 0; i < BAND; ++i) {
        float angle = DMG_PI * (float)i / (BAND - 1), out = -cosf(angle), up = h->deep * 1.05f * sinf(angle);
        path[i] = across ? v3(out * h->wide, up, 0) : v3(0, up, out * h->deep);
    }
    dmg_sweep(b, path, BAND, thick, 0.4f * h->strap, false);
}

/* Draws the display's box before the eyes: its back at the face, curved or straight; with lenses, a nose, cameras, keys
 * below. */
static void draw_visor_box(dmg_builder* b, const head_set* h, uint32_t parent, float front) {
    float w = 1.9f * h->wide, t = h->deep * dmg_range(b, 0.35f, 0.8f),
          round = fminf(t, h->high) * dmg_range(b, 0.1f, 0.45f);
    int shape = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, 0, 0, front);
    if (shape == 0) dmg_rounded_box(b, v3(0, 0, 0.5f * t), v3(w, h->high, t), round);
    if (shape == 1) dmg_ellipsoid(b, v3(0, 0, 0.3f * t), v3(0.52f * w, 0.55f * h->high, 0.7f * t));
    if (shape == 2) { /* goggles: a bent shell */
        const dmg_xy rim[] = {{0.52f * w, -0.5f * h->high}, {0.55f * w, 0},
                              {0.52f * w, 0.5f * h->high},  {0.45f * w, 0.5f * h->high},
                              {0.45f * w, -0.5f * h->high}, {0.52f * w, -0.5f * h->high}};
        float arc = dmg_range(b, 2.0f, 2.9f); /* round +Y, whose zero is +Z */
        dmg_lathe_arc(b, v3(0, 0, -0.25f * w), v3(0, 1, 0), rim, 6, 0.5f * DMG_PI - 0.5f * arc, arc);
    }
    int eyes = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1 && eyes == 0 && shape == 0; s += 2)
        dmg_rod(b, v3((float)s * 0.25f * w, 0, -0.08f * t), v3((float)s * 0.25f * w, 0, 0.1f * t), 0.15f * w);
    for (int s = -1; s <= 1 && eyes == 1 && shape == 0; s += 2)
        dmg_rod(b, v3((float)s * 0.4f * w, -0.3f * h->high, 0.9f * t),
                v3((float)s * 0.4f * w, -0.3f * h->high, 1.03f * t), 0.03f * w);
    if (dmg_chance(b, 0.5f) && shape == 0) {
        dmg_move(b, w * dmg_range(b, -0.3f, 0.3f), 0.5f * h->high, 0.5f * t);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_thumb_key_draw(b, parent, "button", 0.06f * w);
    }
    dmg_restore(b);
}

/* Draws the wheel at the back of the strap, or the drum round it. */
static void draw_strap_wheel(dmg_builder* b, const head_set* h) {
    float radius = h->strap * dmg_range(b, 0.5f, 1.2f), thick = h->deep * dmg_range(b, 0.08f, 0.25f);
    dmg_save(b);
    dmg_move(b, 0, 0, -h->deep);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_rounded_box(b, v3(0, 0, 0), v3(3 * radius, 1.6f * h->strap, 0.6f * thick), 0.2f * thick);
    dmg_move(b, 0, 0, 0.3f * thick);
    if (dmg_chance(b, 0.7f))
        dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1));
    else
        dmg_hinge(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 2.0f, 6.0f));
    dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), radius, thick);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Ear cups at both ends of the bow: turn about the upright, tip about the way forward, or slide along the bow. */
static void draw_ear_cups(dmg_builder* b, const head_set* h, float y) {
    float radius = h->deep * dmg_range(b, 0.25f, 0.45f), thick = radius * dmg_range(b, 0.3f, 0.9f),
          tall = dmg_range(b, 1.0f, 1.4f), off = radius * dmg_range(b, -0.3f, 0.3f), swing = dmg_range(b, 0.2f, 1.5f);
    int motion = dmg_int(b, 0, 2), arm = dmg_int(b, 0, 1);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, x = side * (h->wide + 0.5f * thick);
        if (motion == 0) dmg_hinge(b, 0, "ear_cup", v3(x, y, off), v3(0, side, 0), -0.3f * swing, swing);
        if (motion == 1)
            dmg_hinge(b, 0, "ear_cup", v3(x, y + (arm ? tall * radius : 0.0f), 0), v3(0, 0, side), -0.2f,
                      fminf(0.5f, swing));
        if (motion == 2) dmg_slide(b, 0, "ear_cup", v3(0, -1, 0), 0.0f, radius * dmg_range(b, 0.2f, 1.0f));
        dmg_save(b);
        dmg_move(b, x, y, 0);
        dmg_ellipsoid(b, v3(0, 0, 0), v3(0.5f * thick, tall * radius, radius));
        dmg_torus(b, v3(-side * 0.4f * thick, 0, 0), v3(1, 0, 0), 0.75f * radius, 0.2f * radius);
        if (arm) dmg_box(b, v3(0, tall * radius, 0), v3(0.3f * thick, 0.6f * radius, 0.4f * radius));
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws a boom before the mouth, pinned at the ear. */
static void draw_microphone(dmg_builder* b, const head_set* h) {
    float side = dmg_sign(b), x = side * 1.25f * h->wide, reach = h->deep * dmg_range(b, 0.8f, 1.3f),
          thin = 0.04f * h->deep;
    dmg_hinge(b, 0, "microphone", v3(x, 0, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 2.2f));
    const dmg_vec path[] = {{x, 0, 0}, {x, -0.3f * reach, 0.5f * reach}, {0.8f * x, -0.5f * reach, reach}};
    dmg_rod(b, v3(x - side * 2 * thin, 0, 0), v3(x + side * 2 * thin, 0, 0), 3 * thin);
    dmg_sweep(b, path, 3, thin, thin, false);
    dmg_ellipsoid(b, path[2], v3(2 * thin, 2 * thin, 3 * thin));
    dmg_use(b, 0);
}

void dmg_build_headset(dmg_builder* b) {
    head_set h = {.wide = dmg_range(b, 0.07f, 0.085f), .deep = dmg_range(b, 0.085f, 0.11f)};
    h.high = h.wide * dmg_range(b, 0.9f, 1.4f);
    h.strap = h.wide * dmg_range(b, 0.2f, 0.6f);
    float thick = h.wide * dmg_range(b, 0.02f, 0.08f), tip = dmg_range(b, -0.3f, 0.3f),
          up = h.deep * dmg_range(b, 0.1f, 0.9f);
    int kind = dmg_int(b, 0, 3); /* the visor is a part, or the ears are, or both are still but for the wheel */
    bool crown = kind == 2 || dmg_chance(b, 0.5f);
    dmg_move(b, 0, 0.12f, 0);
    if (crown) draw_crown(b, &h, kind == 2 || dmg_chance(b, 0.5f), thick);
    if (kind == 2) {
        draw_ear_cups(b, &h, -0.1f * h.deep);
        if (dmg_chance(b, 0.6f)) draw_microphone(b, &h);
        return;
    }
    draw_band(b, &h, kind == 3 ? 0.12f : 0.0f, kind == 3 ? 0.88f : 1.0f, thick);
    if (kind <= 1) { /* pinned at the temples or at the brow */
        bool brow = dmg_chance(b, 0.4f);
        dmg_vec pin = brow ? v3(0, 0.5f * h.high, h.deep * dmg_range(b, 0.95f, 1.1f))
                           : v3(0, tip * h.high, h.deep * dmg_range(b, 0.2f, 0.7f));
        uint32_t visor;
        if (kind == 1 && dmg_chance(b, 0.3f))
            visor = dmg_slide(b, 0, "visor", v3(0, 0, 1), 0.0f, h.deep * dmg_range(b, 0.05f, 0.3f));
        else
            visor = dmg_hinge(b, 0, "visor", pin, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.25f, 1.6f));
        draw_visor_box(b, &h, visor, 1.1f * h.deep);
        for (int s = -1; s <= 1 && !brow && dmg_chance(b, 0.8f); s += 2)
            dmg_beam(b, v3((float)s * 1.06f * h.wide, pin.y, pin.z), v3((float)s * 0.95f * h.wide, 0, 1.2f * h.deep),
                     thick, 0.7f * h.strap);
        dmg_use(b, 0);
    } else {
        draw_visor_box(b, &h, 0, 0.85f * h.deep);
    }
    if (dmg_chance(b, kind == 3 ? 1.0f : 0.6f)) draw_strap_wheel(b, &h);
    if (dmg_chance(b, 0.3f)) draw_ear_cups(b, &h, -0.35f * up);
}
