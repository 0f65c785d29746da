/* Draws market carts: hand carts with a shade, hinged counters, drawers and doors in their side, pots with lids on
 * top. The seller stands at -Z, the street is at +Z. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct cart {
    float width, deep, floor, top, wall, wheel;
} cart;

/* Wheels about X at the sides: two big ones and legs, or four. */
static void draw_wheels(dmg_builder* b, const cart* c) {
    int kind = dmg_int(b, 0, 3), count = dmg_chance(b, 0.6f) ? 1 : 2;
    float w = c->wheel * dmg_range(b, 0.12f, 0.3f), x = 0.5f * c->width + 0.8f * w;
    bool across = dmg_chance(b, 0.5f); /* the cart is pushed along X instead */
    float run = across ? 0.5f * c->deep + 0.8f * w : x, spread = (across ? c->width : c->deep) * 0.32f;
    for (int i = 0; i < count; ++i) {
        float along = count == 1 ? dmg_range(b, -0.3f, 0.3f) * spread : (i ? spread : -spread);
        dmg_save(b);
        if (across) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_rod(b, v3(-run, c->wheel, along), v3(run, c->wheel, along), 0.1f * c->wheel);
        dmg_box_span(b, v3(-0.8f * run, c->wheel, along - 0.15f * c->wheel),
                     v3(0.8f * run, c->floor + c->wall, along + 0.15f * c->wheel));
        for (int s = -1; s <= 1; s += 2) {
            dmg_spin(b, 0, "wheel", v3((float)s * run, c->wheel, along), v3(1, 0, 0));
            dmg_save(b);
            dmg_move(b, (float)s * run, c->wheel, along);
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_wheel_draw(b, kind, c->wheel, w, dmg_int(b, 5, 12));
            dmg_restore(b);
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
    if (count == 2) return;
    for (int s = -1; s <= 1; s += 2) { /* a leg that folds, or a fixed one */
        float lx = (float)s * 0.4f * c->width, lz = -0.42f * c->deep, thick = 0.5f * c->wall;
        if (dmg_chance(b, 0.4f)) dmg_hinge(b, 0, "leg", v3(lx, c->floor, lz), v3(1, 0, 0), -1.2f, 0.0f);
        dmg_box_span(b, v3(lx - thick, 0, lz - thick), v3(lx + thick, c->floor, lz + thick));
        dmg_use(b, 0);
    }
}

/* Draws two bars to push it by, or one bow, at a side. */
static void draw_push_bar(dmg_builder* b, const cart* c) {
    float r = 0.3f * c->wall, y = c->floor + 0.6f * (c->top - c->floor), x = 0.5f * c->width,
          out = x + 0.25f * c->width;
    float side = dmg_sign(b);
    for (int k = -1; k <= 1; k += 2)
        dmg_rod(b, v3(side * 0.9f * x, y, (float)k * 0.35f * c->deep), v3(side * out, y, (float)k * 0.35f * c->deep),
                r);
    if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3(side * out, y, -0.35f * c->deep), v3(side * out, y, 0.35f * c->deep), 1.2f * r);
}

/* Over the cart on posts: a roof with flaps before it or on both sides, or an umbrella on a pole. */
static void draw_shade(dmg_builder* b, const cart* c) {
    int kind = dmg_int(b, 0, 2);
    float high = c->top + c->width * dmg_range(b, 0.6f, 1.0f), x = 0.47f * c->width, z = 0.46f * c->deep,
          r = 0.35f * c->wall;
    if (kind == 2) { /* an umbrella that is lowered and turned on its pole */
        float wide = 0.7f * c->width;
        dmg_rod(b, v3(0, c->top, 0), v3(0, high, 0), 1.4f * r);
        if (dmg_chance(b, 0.6f))
            dmg_slide(b, 0, "umbrella", v3(0, 1, 0), -0.25f * (high - c->top), 0.0f);
        else
            dmg_spin(b, 0, "umbrella", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, high - 0.4f * (high - c->top), 0), v3(0, 1.02f * high, 0), r);
        dmg_cone(b, v3(0, high, 0), v3(0, high + 0.3f * wide, 0), wide, 0);
        dmg_use(b, 0);
        return;
    }
    for (int i = 0; i < 4; ++i) {
        float px = i & 1 ? x : -x, pz = i & 2 ? z : -z;
        dmg_rod(b, v3(px, c->floor, pz), v3(px, high, pz), r);
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_rod(b, v3(-x, high, (float)s * z), v3(x, high, (float)s * z), r);
        dmg_rod(b, v3((float)s * x, high, -z), v3((float)s * x, high, z), r);
    }
    float reach = c->deep * dmg_range(b, 0.3f, 0.7f), thin = 0.3f * c->wall, slope = dmg_range(b, 0.0f, 0.6f);
    dmg_box_span(b, v3(-x - 2 * r, high + r, -z - 2 * r), v3(x + 2 * r, high + r + thin, z + 2 * r));
    for (int s = kind == 1 ? -1 : 1; s <= 1; s += 2) { /* flaps beyond the posts, let down or raised */
        float at = (float)s * (z + 2.2f * r);
        dmg_hinge(b, 0, "awning", v3(0, high + r, at), v3((float)s, 0, 0), -0.4f, dmg_range(b, 0.8f, 1.4f));
        dmg_save(b);
        dmg_move(b, 0, high + r, at);
        dmg_turn(b, v3(1, 0, 0), (float)s * slope * 0.3f);
        dmg_box_span(b, v3(-x - 2 * r, 0, s > 0 ? 0 : -reach), v3(x + 2 * r, thin, s > 0 ? reach : 0));
        if (dmg_chance(b, 0.5f)) /* its valance */
            dmg_box_span(b, v3(-x - 2 * r, -0.15f * reach, s > 0 ? reach - thin : -reach),
                         v3(x + 2 * r, 0, s > 0 ? reach : thin - reach));
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws a leaf along the street or at an end, hung at the top's edge: down, or out level as a counter. */
static void draw_counter(dmg_builder* b, const cart* c, int where) {
    float angle = 0.5f * DMG_PI * (float)where, half = 0.5f * (where % 2 ? c->width : c->deep),
          wide = 0.95f * (where % 2 ? c->deep : c->width);
    float reach = fminf(c->deep * dmg_range(b, 0.25f, 0.5f), 0.6f * (c->top - c->floor)), t = 0.5f * c->wall;
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), angle);
    if (dmg_chance(b, 0.5f)) { /* drawn hanging: raised to the level */
        dmg_hinge(b, 0, "counter", v3(0, c->top - 0.3f * t, half + t), v3(-1, 0, 0), 0.0f, 0.5f * DMG_PI);
        dmg_box_span(b, v3(-0.5f * wide, c->top - reach, half + 0.05f * t), v3(0.5f * wide, c->top, half + t));
    } else { /* drawn level: it drops */
        dmg_hinge(b, 0, "counter", v3(0, c->top - t, half), v3(1, 0, 0), 0.0f, 0.5f * DMG_PI);
        dmg_box_span(b, v3(-0.5f * wide, c->top - t, half + 0.02f * t), v3(0.5f * wide, c->top, half + reach));
    }
    dmg_use(b, 0);
    dmg_restore(b);
}

/* On the top: pots whose lids hinge or lift, or trays under flaps hung before or behind. */
static void draw_top_lids(dmg_builder* b, const cart* c) {
    int count = dmg_int(b, 1, 4), kind = dmg_int(b, 0, 2);
    float pitch = 0.9f * c->width / (float)count, r = fminf(0.38f * pitch, 0.35f * c->deep),
          rim = r * dmg_range(b, 0.15f, 0.5f), end = dmg_sign(b);
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1)), y = c->top + rim;
        const dmg_xy lid[] = {{1.03f * r, 0}, {1.03f * r, 0.08f * r}, {0.6f * r, 0.25f * r}, {0, 0.3f * r}};
        if (kind == 2) {
            float half = 0.45f * pitch, deep = 0.4f * c->deep;
            dmg_box_span(b, v3(x - half, c->top, -deep), v3(x + half, y, deep));
            dmg_hinge(b, 0, "flap", v3(x, y, end * deep), v3(end, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
            dmg_box_span(b, v3(x - half, y, -deep), v3(x + half, y + 0.12f * r, deep));
            dmg_box(b, v3(x, y + 0.2f * r, -0.8f * end * deep), v3(0.3f * half, 0.15f * r, 0.08f * deep));
        } else {
            dmg_rod(b, v3(x, c->top, 0), v3(x, y, 0), r);
            if (kind == 0) dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, 1.2f * r);
            if (kind == 1)
                dmg_hinge(b, 0, "lid", v3(x, y, end * 1.05f * r), v3(end, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.8f));
            dmg_lathe(b, v3(x, y, 0), v3(0, 1, 0), lid, 4);
            dmg_ellipsoid(b, v3(x, y + 0.35f * r, 0), v3(0.12f * r, 0.12f * r, 0.12f * r));
        }
        dmg_use(b, 0);
    }
}

/* In its street side: doors, drawers, or nothing. */
static void draw_cart_front(dmg_builder* b, const cart* c) {
    int kind = dmg_int(b, 0, 2), count = dmg_int(b, 1, 4);
    float high = c->top - c->floor, wide = 0.9f * c->width / (float)count, hand = 0.12f * c->width;
    for (int i = 0; i < count && kind > 0; ++i) {
        dmg_save(b);
        dmg_move(b, wide * ((float)i - 0.5f * (float)(count - 1)), c->floor + 0.5f * high, 0.5f * c->deep);
        if (kind == 1) {
            dmg_leaf leaf = dmg_leaf_pick(b, hand);
            leaf.width = 0.95f * wide;
            leaf.height = 0.8f * high;
            leaf.thickness = 0.4f * c->wall;
            leaf.side = i % 2 ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT;
            dmg_move(b, 0, 0, leaf.thickness);
            dmg_leaf_draw(b, 0, "door", &leaf);
        } else {
            dmg_drawer drawer = dmg_drawer_pick(b, hand);
            drawer.width = 0.95f * wide;
            drawer.height = 0.4f * high;
            drawer.thickness = 0.4f * c->wall;
            drawer.depth = 0.7f * c->deep;
            drawer.travel = 0.5f * c->deep;
            dmg_move(b, 0, 0.2f * high, drawer.thickness);
            dmg_drawer_draw(b, 0, "drawer", &drawer);
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_market_cart(dmg_builder* b) {
    cart c = {.width = dmg_scale_range(b, 0.4f, 2.2f)};
    c.deep = c.width * dmg_range(b, 0.4f, 0.8f);
    c.wheel = c.width * dmg_range(b, 0.1f, 0.26f);
    c.wall = c.width * dmg_range(b, 0.02f, 0.05f);
    c.floor = c.wheel * dmg_range(b, 1.15f, 1.8f);
    c.top = c.floor + c.width * dmg_range(b, 0.25f, 0.5f);
    bool open = dmg_chance(b, 0.35f);
    dmg_save(b);
    dmg_move(b, 0, c.top, 0);
    dmg_face_up(b);
    dmg_case_draw(b, open ? DMG_CASE_BOARDS : DMG_CASE_SOLID, c.width, c.deep, c.top - c.floor, c.wall);
    dmg_restore(b);
    draw_wheels(b, &c);
    if (dmg_chance(b, 0.7f)) draw_push_bar(b, &c);
    if (dmg_chance(b, 0.8f)) draw_shade(b, &c);
    int side = dmg_int(b, 0, 3);
    bool counter = dmg_chance(b, 0.6f);
    if (counter) draw_counter(b, &c, side);
    if (!open && dmg_chance(b, 0.5f)) draw_top_lids(b, &c);
    if (!(counter && side == 0)) draw_cart_front(b, &c);
    dmg_use(b, 0);
}
