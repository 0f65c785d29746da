/* Implements wings and the control surfaces cut out of them, for aircraft and submarines. */
#include "parts/wings.h"

static float chord_at(const dmg_wing* w, float s) {
    return w->root + (w->tip - w->root) * s;
}

/* A point of the wing: s along the span, c along the chord from the leading edge, side -1 … 1 of the thickness. */
dmg_vec dmg_wing_point(const dmg_wing* w, float s, float c, float side) {
    float chord = chord_at(w, s), profile = w->flat ? 0.5f : 0.5f * (1.0f - 0.9f * c) * (c < 0.02f ? 0.4f : 1.0f);
    return v3(s * w->span, side * profile * w->thick * chord + s * w->span * w->dihedral,
              0.5f * w->root - s * w->sweep - c * chord);
}

void dmg_wing_patch_draw(dmg_builder* b, const dmg_wing* w, dmg_xy s, dmg_xy fore, dmg_xy aft) {
    enum { HALF = 3 };
    uint32_t v[2][2 * HALF];
    dmg_piece_begin(b);
    for (int end = 0; end < 2; ++end) {
        for (int i = 0; i < 2 * HALF; ++i) {
            float share = (float)(i < HALF ? i : 2 * HALF - 1 - i) / (HALF - 1), c0 = end ? fore.y : fore.x,
                  c1 = end ? aft.y : aft.x;
            v[end][i] =
                dmg_vertex(b, dmg_wing_point(w, end ? s.y : s.x, c0 + (c1 - c0) * share, i < HALF ? 1.0f : -1.0f));
        }
    }
    for (int i = 0; i < 2 * HALF; ++i) {
        int next = (i + 1) % (2 * HALF);
        dmg_quad(b, v[0][i], v[0][next], v[1][next], v[1][i]);
    }
    for (int i = 0; i + 1 < HALF; ++i) {
        int under = 2 * HALF - 1 - i;
        dmg_quad(b, v[0][i], v[0][under], v[0][under - 1], v[0][i + 1]);
        dmg_quad(b, v[1][i], v[1][i + 1], v[1][under - 1], v[1][under]);
    }
}

void dmg_wing_piece_draw(dmg_builder* b, const dmg_wing* w, float s0, float s1, float c0, float c1) {
    dmg_wing_patch_draw(b, w, (dmg_xy){s0, s1}, (dmg_xy){c0, c0}, (dmg_xy){c1, c1});
}

static void draw_surface(dmg_builder* b, const dmg_wing* w, uint32_t parent, const dmg_surface* f, float gap) {
    float along = gap * 0.5f;
    float s0 = f->s0 + along, s1 = f->s1 - along, at = f->c + gap;
    dmg_vec from = dmg_wing_point(w, s0, at, 0), to = dmg_wing_point(w, s1, at, 0);
    /* About +X (root to tip) the trailing edge, which lies to -Z, goes up: lower it. */
    dmg_vec line = v3_normalize(v3_sub(from, to)), middle = v3_lerp(from, to, 0.5f);
    bool plain = dmg_chance(b, 0.25f); /* straight across, whatever the sweep: good enough for many a model */
    dmg_hinge(b, parent, f->name, plain ? middle : from, plain ? v3(-1, 0, 0) : line, f->drops ? 0.0f : -f->swing,
              f->swing);
    dmg_wing_piece_draw(b, w, s0, s1, at, 1.0f);
    if (dmg_chance(b, 0.15f))
        dmg_box(b, v3_lerp(from, to, 0.5f), v3(0.01f * w->span, 0.2f * w->thick * w->root, 0.05f * w->root));
    dmg_use(b, parent);
}

/* The wing with its surfaces cut out of it; surfaces in order along the span. */
void dmg_wing_draw(dmg_builder* b, const dmg_wing* w, uint32_t parent, const dmg_surface* surfaces, int count) {
    float done = 0.0f, gap = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.004f, 0.03f);
    bool whole = dmg_chance(b, 0.15f); /* nobody cut the wing: the surface lies in it */
    dmg_use(b, parent);
    if (whole) dmg_wing_piece_draw(b, w, 0, 1, 0, 0.99f);
    for (int i = 0; i < count && !whole; ++i) {
        if (surfaces[i].s0 > done) dmg_wing_piece_draw(b, w, done, surfaces[i].s0, 0, 1);
        dmg_wing_piece_draw(b, w, surfaces[i].s0, surfaces[i].s1, 0, surfaces[i].c);
        done = surfaces[i].s1;
    }
    if (!whole && done < 1.0f) dmg_wing_piece_draw(b, w, done, 1, 0, 1);
    for (int i = 0; i < count; ++i) draw_surface(b, w, parent, &surfaces[i], gap);
}

dmg_wing dmg_wing_pick(dmg_builder* b, float span, float root) {
    dmg_wing w = {.span = span, .root = root, .tip = root * dmg_range(b, 0.25f, 1.0f)};
    w.sweep = dmg_chance(b, 0.5f) ? 0.5f * (root - w.tip) : span * dmg_range(b, -0.1f, 0.8f);
    w.thick = dmg_range(b, 0.05f, 0.15f);
    w.flat = dmg_chance(b, 0.2f);
    if (w.flat) w.thick *= 0.4f;
    return w;
}

int dmg_surfaces_pick(dmg_builder* b, dmg_surface out[2], const char* inner, const char* outer) {
    float swing = dmg_range(b, 0.3f, 0.8f), c = dmg_range(b, 0.62f, 0.85f), middle = dmg_range(b, 0.4f, 0.65f);
    int count = 0;
    float first = dmg_range(b, 0.05f, 0.2f), from = dmg_range(b, 0.02f, 0.5f), last = dmg_range(b, 0.85f, 1.0f);
    if (inner) out[count++] = (dmg_surface){inner, first, middle - 0.02f, c, swing, false};
    if (outer) out[count++] = (dmg_surface){outer, inner ? middle + 0.02f : from, last, c, swing, false};
    return count;
}
