/* Draws play panels between posts: drums that turn on rods, beads that slide along them, wheels, gears, flaps, pucks
 * in slots, bolts, clocks. The child stands at +Z. */
#include "core/build.h"
#include "parts/hardware.h"

/* Drums, cubes or prisms on upright rods: they turn. Beads on level rods: they slide. Alike but for their rods. */
static void draw_rods(dmg_builder* b, float w, float high, bool slides) {
    int lines = dmg_int(b, 2, 3), each = dmg_int(b, 2, slides ? 4 : 3), shape = dmg_int(b, 0, 2);
    bool upright = !slides && dmg_chance(b, 0.6f);
    float pitch = (upright ? w : high) / (float)lines, along = upright ? high : w,
          r = 0.3f * fminf(pitch, along / (float)each);
    if (slides) r *= 0.8f;
    dmg_frame_draw(b, 1.12f * w, 1.12f * high, 1.2f * r, 0.06f * w);
    dmg_move(b, 0, 0, -0.6f * r);
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    float half = slides ? 0.35f * r : fminf(0.42f * along / (float)each, 1.2f * r),
          free_ = along - 2 * half * (float)each;
    for (int i = 0; i < lines; ++i) {
        float y = pitch * ((float)i + 0.5f - 0.5f * (float)lines);
        dmg_use(b, 0);
        dmg_rod(b, v3(-0.5f * along, y, 0), v3(0.5f * along, y, 0), 0.12f * r);
        float at = 0;
        bool pushed = slides && dmg_chance(b, 0.6f);
        for (int k = 0; k < each; ++k) {
            float step = along / (float)each,
                  x = slides ? -0.5f * along + half * (float)(2 * k + 1) : step * ((float)k + 0.5f) - 0.5f * along;
            if (slides) {
                uint32_t bead = dmg_slide(b, 0, "bead", v3(1, 0, 0), 0.0f, 0.98f * free_);
                if (pushed) at += (0.98f * free_ - at) * dmg_unit(b);
                dmg_rest(b, bead, at);
            } else
                dmg_spin(b, 0, "drum", v3(x, y, 0), v3(1, 0, 0));
            if (shape == 0) dmg_rod(b, v3(x - half, y, 0), v3(x + half, y, 0), r);
            if (shape == 1) dmg_box(b, v3(x, y, 0), v3(2 * half, 1.5f * r, 1.5f * r));
            if (shape == 2) dmg_ellipsoid(b, v3(x, y, 0), v3(half, r, r));
        }
    }
    dmg_use(b, 0);
}

/* On z = 0: a wheel to steer by, gears, a window with a flap, a glass to look through, a bell's lever. */
static void draw_play_thing(dmg_builder* b, int kind, float w) {
    if (kind == 0) {
        float turn = dmg_range(b, 1.5f, 6.0f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.2f * w), 0.06f * w);
        if (dmg_chance(b, 0.6f))
            dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        else
            dmg_hinge(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1), -turn, turn);
        dmg_move(b, 0, 0, 0.2f * w);
        int spokes = dmg_int(b, 2, 6);
        dmg_wheel_draw(b, dmg_chance(b, 0.7f) ? 3 : 6, 0.36f * w, 0.08f * w, spokes);
    }
    if (kind == 1) {
        for (int i = -1; i <= 1; i += 2) {
            dmg_use(b, 0);
            dmg_spin(b, 0, "gear", v3((float)i * 0.24f * w, 0, 0), v3(0, 0, 1));
            dmg_save(b);
            dmg_move(b, (float)i * 0.24f * w, 0, 0.06f * w);
            dmg_wheel_draw(b, 4, 0.22f * w, 0.08f * w, 6);
            dmg_rod(b, v3(0.13f * w, 0, 0), v3(0.13f * w, 0, 0.12f * w), 0.03f * w);
            dmg_restore(b);
        }
    }
    if (kind == 2) {
        dmg_leaf leaf = dmg_leaf_pick(b, 0.08f);
        leaf.width = 0.6f * w;
        leaf.height = 0.6f * w;
        leaf.thickness = 0.03f * w;
        leaf.side = (dmg_side)dmg_int(b, 0, 2);
        dmg_move(b, 0, 0, 0.035f * w);
        dmg_leaf_draw(b, 0, "flap", &leaf);
    }
    if (kind == 3) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.15f * w), 0.05f * w);
        uint32_t fork = dmg_spin(b, 0, "swivel", v3(0, 0, 0.15f * w), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, 0.13f * w), v3(0, 0, 0.2f * w), 0.1f * w);
        dmg_hinge(b, fork, "glass", v3(0, 0, 0.25f * w), v3(1, 0, 0), -0.5f, 0.5f);
        dmg_cone(b, v3(0, -0.35f * w, 0.27f * w), v3(0, 0.35f * w, 0.27f * w), 0.06f * w, 0.09f * w);
    }
    dmg_use(b, 0);
}

/* Things with an end to their way: a puck in a slot, a bolt in its staples, a clock's hands, a bell's lever, a tube
 * that swings across. */
static void draw_play_catch(dmg_builder* b, int kind, float w) {
    float t = 0.03f * w;
    if (kind == 0) { /* the slot is two rails; the puck slides between them, at any slant */
        dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0.0f, DMG_PI));
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, (float)s * 0.06f * w, 0.5f * t), v3(0.8f * w, 0.04f * w, t));
        uint32_t puck = dmg_slide(b, 0, "puck", v3(1, 0, 0), -0.3f * w, 0.3f * w);
        if (dmg_chance(b, 0.7f)) dmg_rest(b, puck, 0.3f * w * dmg_range(b, -1.0f, 1.0f));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 3 * t), 0.03f * w);
        dmg_rod(b, v3(0, 0, 1.2f * t), v3(0, 0, 2.5f * t), 0.1f * w);
    }
    if (kind == 1) {
        for (int i = -1; i <= 1; ++i) dmg_box(b, v3((float)i * 0.3f * w, 0, t), v3(0.08f * w, 0.14f * w, 2 * t));
        dmg_slide(b, 0, "bolt", v3(1, 0, 0), 0.0f, 0.24f * w);
        dmg_rod(b, v3(-0.42f * w, 0, 1.2f * t), v3(0.1f * w, 0, 1.2f * t), 0.9f * t);
        dmg_rod(b, v3(-0.2f * w, 0, 1.2f * t), v3(-0.2f * w, 0, 5 * t), 0.7f * t);
    }
    if (kind == 2) {
        float r = 0.38f * w;
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.5f * t), r);
        for (int i = 0; i < 2; ++i) {
            float long_ = i ? 0.55f * r : 0.85f * r, z = t * (1.0f + (float)i);
            uint32_t hand = dmg_spin(b, 0, "hand", v3(0, 0, z), v3(0, 0, -1));
            dmg_rest(b, hand, dmg_range(b, 0.0f, 6.2f));
            dmg_box_span(b, v3(-0.05f * r, -0.1f * r, z - 0.3f * t), v3(0.05f * r, long_, z + 0.3f * t));
            dmg_rod(b, v3(0, 0, z - 0.4f * t), v3(0, 0, z + 0.4f * t), 0.1f * r);
            dmg_use(b, 0);
        }
    }
    if (kind == 3) {
        bool across = dmg_chance(b, 0.5f);
        if (across) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.08f * w, 0, 0.05f * w), v3(0.04f * w, 0.12f * w, 0.1f * w));
        dmg_hinge(b, 0, "lever", v3(0, 0, 0.06f * w), v3(1, 0, 0), -0.5f, 0.5f);
        dmg_rod(b, v3(-0.1f * w, 0, 0.06f * w), v3(0.1f * w, 0, 0.06f * w), 0.025f * w);
        dmg_rod(b, v3(0, 0, 0.06f * w), v3(0, 0, 0.4f * w), 0.03f * w);
        dmg_ellipsoid(b, v3(0, 0, 0.4f * w), v3(0.06f * w, 0.06f * w, 0.06f * w));
    }
    dmg_use(b, 0);
}

void dmg_build_play_panel(dmg_builder* b) {
    float w = dmg_range(b, 0.6f, 1.6f), high = w * dmg_range(b, 0.6f, 0.9f), low = dmg_range(b, 0.3f, 0.6f),
          post = dmg_range(b, 0.035f, 0.07f);
    int kind = dmg_weighted(b, (const float[]){1, 1, 2.5f}, 3), things = dmg_int(b, 2, 4);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * (0.56f * w + post), 0, -0.03f * w),
                v3((float)s * (0.56f * w + post), low + 1.15f * high, -0.03f * w), post);
    dmg_move(b, 0, low + 0.5f * high, 0);
    if (kind < 2) {
        draw_rods(b, w, high, kind == 1);
        return;
    }
    dmg_box(b, v3(0, 0, -0.02f * w), v3(1.12f * w, high, 0.04f * w));
    for (int i = 0; i < things; ++i) {
        float room = fminf(w / (float)things, high);
        dmg_save(b);
        dmg_move(b, w * (((float)i + 0.5f) / (float)things - 0.5f), 0, 0);
        int kind_of = dmg_int(b, 0, 7);
        if (kind_of < 4)
            draw_play_thing(b, kind_of, room);
        else
            draw_play_catch(b, kind_of - 4, room);
        dmg_restore(b);
    }
}
