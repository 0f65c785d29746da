/* Draws secret doors as games build them: bookcases that swing or slide, a wall that turns about its middle, stones
 * that draw back, sink or rise, slabs over a pit, and their triggers: a book, a sconce, a brick, a picture, a bust,
 * a plate in the floor. The wall's front is z = 0, the floor y = 0. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct site {
    float x, y;       /* half width and height of the opening */
    float wing, over; /* of the wall beside and above it */
    float deep;       /* thickness of the wall */
    int stones;       /* 0 plain, 1 coursed, 2 panelled */
} site;

static site pick_site(dmg_builder* b) {
    site s = {.x = dmg_scale_range(b, 0.08f, 0.9f)};
    s.y = s.x * dmg_range(b, 2.6f, 4.6f);
    s.wing = s.x * dmg_range(b, 0.6f, 2.5f);
    s.over = s.x * dmg_range(b, 0.2f, 1.0f);
    s.deep = s.x * dmg_range(b, 0.15f, 0.6f);
    s.stones = dmg_int(b, 0, 2);
    return s;
}

/* ---- the wall ---- */

/* Blocks in bond from corner to corner, their faces a little uneven; front about z = front. */
static void draw_courses(dmg_builder* b, float x0, float x1, float y0, float y1, float back, float front) {
    float wide = x1 - x0, high = y1 - y0, gap = 0.01f * fminf(wide, high);
    float tall = fmaxf(0.12f * (wide + high), 0.11f * high);
    int rows = (int)fmaxf(1.0f, roundf(high / tall)), columns = (int)fmaxf(1.0f, roundf(wide / (1.8f * tall)));
    float step = wide / (float)columns, rise = high / (float)rows;
    for (int r = 0; r < rows; ++r) {
        bool bond = r % 2 && columns > 1;
        for (int c = 0; c < columns + (bond ? 1 : 0); ++c) {
            float left = x0 + step * ((float)c - (bond ? 0.5f : 0.0f)), right = fminf(x1, left + step);
            float out = front - dmg_unit(b) * 0.06f * (front - back);
            dmg_box_span(b, v3(fmaxf(x0, left) + gap, y0 + rise * (float)r + gap, back),
                         v3(right - gap, y0 + rise * (float)(r + 1) - gap, out));
        }
    }
}

static void draw_field(dmg_builder* b, const site* s, float x0, float x1, float y0, float y1) {
    if (s->stones == 1)
        draw_courses(b, x0, x1, y0, y1, -s->deep, 0);
    else
        dmg_box_span(b, v3(x0, y0, -s->deep), v3(x1, y1, 0));
    if (s->stones != 2 || x1 - x0 > 3 * (y1 - y0)) return;
    float rim = 0.12f * (x1 - x0), t = 0.08f * s->deep;
    for (int i = 0; i < 2; ++i) {
        float low = y0 + (y1 - y0) * (i ? 0.42f : 0.04f), high = y0 + (y1 - y0) * (i ? 0.94f : 0.36f);
        dmg_box_span(b, v3(x0 + rim, low, 0), v3(x1 - rim, high, t));
    }
}

/* Beside and above the opening; `side` 0 both, else the one alone is wide. */
static void draw_wall(dmg_builder* b, const site* s, float side) {
    for (int k = -1; k <= 1; k += 2) {
        float wing = side != 0.0f && (float)k != side ? 0.4f * s->wing : s->wing;
        float in = (float)k * s->x, out = (float)k * (s->x + wing);
        draw_field(b, s, fminf(in, out), fmaxf(in, out), 0, s->y);
    }
    draw_field(b, s, -s->x - s->wing * (side > 0 ? 0.4f : 1.0f), s->x + s->wing * (side < 0 ? 0.4f : 1.0f), s->y,
               s->y + s->over);
    if (dmg_chance(b, 0.5f)) { /* a floor */
        float t = 0.1f * s->deep, front = s->x * dmg_range(b, 0.3f, 2.0f);
        dmg_box_span(b, v3(-s->x - s->wing, -t, -2 * s->deep), v3(s->x + s->wing, -0.004f * s->y, front));
    }
}

/* ---- a bookcase: bottom middle of its front at the origin ---- */

static void draw_books(dmg_builder* b, float x0, float x1, float y, float room, float deep) {
    float at = x0;
    while (at < x1) {
        float wide = room * dmg_range(b, 0.12f, 0.35f), high = room * dmg_range(b, 0.55f, 0.95f),
              in = deep * dmg_range(b, 0.1f, 0.35f);
        if (at + wide > x1) return;
        if (!dmg_chance(b, 0.15f)) dmg_box_span(b, v3(at, y, -0.9f * deep), v3(at + 0.94f * wide, y + high, -in));
        at += wide;
    }
}

/* Tips out about its lower edge, or is drawn, or pushed. */
static void draw_secret_book(dmg_builder* b, uint32_t parent, float x, float y, float room, float deep) {
    float half = room * dmg_range(b, 0.08f, 0.16f), high = room * dmg_range(b, 0.6f, 0.9f), front = -0.05f * deep;
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_hinge(b, parent, "book", v3(x, y, front), v3(1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.2f));
    if (kind == 1) dmg_slide(b, parent, "book", v3(0, 0, 1), 0.0f, deep * dmg_range(b, 0.3f, 0.6f));
    if (kind == 2) dmg_hinge(b, parent, "book", v3(x, y + 0.1f * high, -0.5f * deep), v3(1, 0, 0), 0.0f, 0.6f);
    dmg_box_span(b, v3(x - half, y, -0.8f * deep), v3(x + half, y + high, front));
    for (int i = 0; i < 2; ++i)
        dmg_box(b, v3(x, y + high * (i ? 0.75f : 0.2f), front), v3(1.9f * half, 0.05f * high, 0.03f * deep));
    dmg_use(b, parent);
}

static void draw_bookcase(dmg_builder* b, uint32_t parent, float half, float high, float deep, bool trigger) {
    float t = half * dmg_range(b, 0.04f, 0.09f);
    int shelves = dmg_int(b, 3, 6), secret = dmg_int(b, 1, shelves - 1), fill = dmg_int(b, 0, 3);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * (half - 0.5f * t) - 0.5f * t, 0, -deep),
                     v3((float)s * (half - 0.5f * t) + 0.5f * t, high, 0));
    dmg_box_span(b, v3(-half, 0, -deep - 0.5f * t), v3(half, high, -deep));
    for (int i = 0; i <= shelves; ++i) {
        float y = (high - t) * (float)i / (float)shelves, room = (high - t) / (float)shelves - t;
        dmg_box_span(b, v3(-half + t, y, -deep), v3(half - t, y + t, 0));
        if (i == shelves) continue;
        bool here = trigger && i == secret;
        float x = dmg_range(b, -0.4f, 0.4f) * half, clear = 0.25f * room;
        if (fill && !here) draw_books(b, -half + t, half - t, y + t, room, deep);
        if (!here) continue;
        if (fill) draw_books(b, -half + t, x - clear, y + t, room, deep);
        if (fill) draw_books(b, x + clear, half - t, y + t, room, deep);
        draw_secret_book(b, parent, x, y + t, room, deep);
    }
}

/* ---- triggers on the wall, at the origin on z = 0 ---- */

static void draw_sconce(dmg_builder* b, float size) {
    float r = 0.05f * size, out = 0.3f * size;
    dmg_box(b, v3(0, 0, 0.4f * r), v3(5 * r, 9 * r, 0.8f * r));
    if (dmg_chance(b, 0.6f)) { /* pulled down */
        dmg_rod(b, v3(-2 * r, 0, 1.6f * r), v3(2 * r, 0, 1.6f * r), 0.8f * r);
        dmg_hinge(b, 0, "sconce", v3(0, 0, 1.6f * r), v3(1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.1f));
    } else { /* turned aside */
        float swing = dmg_range(b, 0.7f, 1.6f);
        dmg_hinge(b, 0, "sconce", v3(0, 0, 0.8f * r), v3(0, 0, dmg_sign(b)), 0.0f, swing);
    }
    dmg_rod(b, v3(0, 0, r), v3(0, 0.1f * size, out), r);
    dmg_cone(b, v3(0, 0.06f * size, out), v3(0, 0.2f * size, out), r, 2.5f * r);
    if (dmg_chance(b, 0.7f)) dmg_cone(b, v3(0, 0.2f * size, out), v3(0, 0.5f * size, out), 1.3f * r, 0.8f * r);
    dmg_use(b, 0);
}

static void draw_picture(dmg_builder* b, float size) {
    float x = 0.5f * size, y = size * dmg_range(b, 0.4f, 0.7f), t = 0.05f * size;
    int kind = dmg_int(b, 0, 2);
    float side = dmg_sign(b);
    if (kind == 0) dmg_hinge(b, 0, "picture", v3(side * x, 0, 0), v3(0, side, 0), 0.0f, dmg_range(b, 1.0f, 2.6f));
    if (kind == 1) dmg_slide(b, 0, "picture", v3(side, 0, 0), 0.0f, 0.9f * size);
    if (kind == 2) /* hangs askew on its nail */
        dmg_hinge(b, 0, "picture", v3(0, 0.9f * y, 0), v3(0, 0, side), -0.2f, dmg_range(b, 0.3f, 0.9f));
    dmg_save(b);
    dmg_move(b, 0, 0, 1.2f * t);
    dmg_frame_draw(b, 2 * x, 2 * y, t, 0.12f * size);
    dmg_box(b, v3(0, 0, -0.6f * t), v3(1.8f * x, 1.8f * y, 0.3f * t));
    dmg_restore(b);
    dmg_use(b, 0);
    if (kind == 2) dmg_rod(b, v3(0, 0.9f * y, 0), v3(0, 0.9f * y, 1.4f * t), 0.3f * t);
    if (kind == 2) return;
    dmg_box(b, v3(0, 0, 0.1f * t), v3(1.1f * x, 1.1f * y, 0.2f * t)); /* what it hides */
    dmg_rod(b, v3(0.2f * x, 0, 0), v3(0.2f * x, 0, 0.5f * t), 0.1f * x);
}

static void draw_brick(dmg_builder* b, float size) {
    float x = 0.3f * size, y = 0.15f * size, out = size * dmg_range(b, 0.02f, 0.1f);
    dmg_slide(b, 0, "brick", v3(0, 0, -1), 0.0f, out * dmg_range(b, 0.8f, 1.2f));
    dmg_box_span(b, v3(-x, -y, -0.2f * out), v3(x, y, 1.3f * out));
    dmg_use(b, 0);
}

/* On a plinth on the floor: its head tips back, or the whole bust turns or slides. */
static void draw_bust(dmg_builder* b, float size) {
    float r = 0.18f * size, y = 0.7f * size;
    int kind = dmg_int(b, 0, 2);
    dmg_box(b, v3(0, 0.5f * y, 0), v3(0.42f * size, y, 0.42f * size));
    dmg_box(b, v3(0, y, 0), v3(0.5f * size, 0.08f * size, 0.5f * size));
    y += 0.04f * size;
    if (kind == 1) dmg_spin(b, 0, "bust", v3(0, y, 0), v3(0, dmg_sign(b), 0));
    if (kind == 2) dmg_slide(b, 0, "bust", v3(dmg_sign(b), 0, 0), 0.0f, 0.15f * size);
    dmg_cone(b, v3(0, y, 0), v3(0, y + 0.4f * r, 0), 0.8f * r, 0.5f * r);
    dmg_ellipsoid(b, v3(0, y + 0.9f * r, 0), v3(1.2f * r, 0.7f * r, 0.6f * r));
    if (kind == 0)
        dmg_hinge(b, 0, "head", v3(0, y + 1.5f * r, -0.4f * r), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.6f));
    dmg_rod(b, v3(0, y + 1.4f * r, 0), v3(0, y + 1.9f * r, 0), 0.35f * r);
    dmg_ellipsoid(b, v3(0, y + 2.3f * r, 0), v3(0.55f * r, 0.75f * r, 0.65f * r));
    dmg_ellipsoid(b, v3(0, y + 2.25f * r, 0.65f * r), v3(0.12f * r, 0.2f * r, 0.15f * r));
    dmg_use(b, 0);
}

/* In the floor before the wall: sinks, or tips about one edge. */
static void draw_pressure_plate(dmg_builder* b, float size) {
    float half = 0.35f * size, rim = 0.12f * size, t = size * dmg_range(b, 0.04f, 0.12f);
    const dmg_xy outer[] = {
        {half + rim, half + rim}, {-half - rim, half + rim}, {-half - rim, -half - rim}, {half + rim, -half - rim}};
    dmg_xy inner[4];
    for (int i = 0; i < 4; ++i)
        inner[i] = (dmg_xy){outer[i].x * 1.02f * half / (half + rim), outer[i].y * 1.02f * half / (half + rim)};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_ring_plate(b, outer, inner, 4, 0, t);
    dmg_restore(b);
    dmg_box_span(b, v3(-half - rim, -0.3f * t, -half - rim), v3(half + rim, 0, half + rim));
    float up = t * dmg_range(b, 1.1f, 1.6f);
    if (dmg_chance(b, 0.75f))
        dmg_slide(b, 0, "pressure_plate", v3(0, -1, 0), 0.0f, 0.6f * t);
    else
        dmg_hinge(b, 0, "pressure_plate", v3(0, 0.9f * t, -half), v3(1, 0, 0), 0.0f, 0.3f * t / half);
    dmg_box_span(b, v3(-half, 0.7f * t, -half), v3(half, up, half));
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, up, 0), v3(0, 1.15f * up, 0), 0.6f * half);
    dmg_use(b, 0);
}

/* Draws one or two of them beside the opening. */
static void draw_triggers(dmg_builder* b, const site* s, float side) {
    float x = side * (s->x + 0.5f * s->wing), size = fminf(1.1f * s->wing, s->x);
    int kind = dmg_int(b, 0, 4);
    dmg_save(b);
    dmg_move(b, x, s->y * (kind > 2 ? 0.0f : dmg_range(b, 0.45f, 0.65f)), kind > 2 ? 0.8f * size : 0.1f * s->deep);
    if (kind == 0) draw_sconce(b, size);
    if (kind == 1) draw_picture(b, 0.9f * size);
    if (kind == 2) draw_brick(b, size);
    if (kind == 3) draw_bust(b, size);
    if (kind == 4) draw_pressure_plate(b, size);
    dmg_restore(b);
}

/* ---- what moves ---- */

/* In the opening: hung at its front or rear corner, or on rails before the wall. */
static void build_bookcase(dmg_builder* b, const site* s) {
    bool slides = dmg_chance(b, 0.4f), trigger = dmg_chance(b, 0.7f);
    float side = dmg_sign(b), deep = fmaxf(s->deep, 0.35f * s->x), t = 0.06f * s->x;
    if (slides) {
        draw_wall(b, s, side);
        float z = deep + 2 * t, half = s->x * dmg_range(b, 1.0f, 1.15f),
              far = fminf(1.9f * s->x, s->x + 0.6f * s->wing);
        float low = dmg_chance(b, 0.5f) ? 0.02f * s->y : 0.0f;
        if (low > 0) { /* rails */
            float end = side * (half + far);
            dmg_box_span(b, v3(fminf(-side * half, end), 0, 0.2f * deep),
                         v3(fmaxf(-side * half, end), low, 0.3f * deep));
            dmg_box_span(b, v3(fminf(-side * half, end), 0, 0.8f * deep),
                         v3(fmaxf(-side * half, end), low, 0.9f * deep));
        }
        uint32_t part = dmg_slide(b, 0, "bookcase", v3(side, 0, 0), 0.0f, far);
        dmg_move(b, 0, low, z);
        draw_bookcase(b, part, half, 1.02f * s->y, deep, trigger);
        dmg_use(b, 0);
        return;
    }
    draw_wall(b, s, 0);
    float front = dmg_range(b, 0.0f, 0.4f) * deep, half = 0.97f * s->x;
    bool double_leaf = dmg_chance(b, 0.25f);
    for (int k = -1; k <= 1; k += 2) {
        if (!double_leaf && (float)k != side) continue;
        float hung = (float)k * half, middle = double_leaf ? 0.5f * hung : 0.0f;
        uint32_t part =
            dmg_hinge(b, 0, "bookcase", v3(hung, 0, front), v3(0, (float)k, 0), 0.0f, dmg_range(b, 0.9f, 1.7f));
        dmg_save(b);
        dmg_move(b, middle, 0.01f * s->y, front);
        draw_bookcase(b, part, double_leaf ? 0.49f * half : half, 0.98f * s->y, deep, trigger);
        dmg_restore(b);
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(hung, 0.05f * s->y, front), v3(hung, 0.95f * s->y, front), 0.5f * t);
        dmg_use(b, 0);
    }
}

/* Turns about an upright in its middle, with a disc of the floor and what hangs on it, or tips about a level line. */
static void build_turning_wall(dmg_builder* b, const site* s) {
    draw_wall(b, s, 0);
    float half = 0.96f * s->x, z = -0.5f * s->deep, t = 0.45f * s->deep, low = 0.01f * s->y,
          off = dmg_chance(b, 0.3f) ? dmg_range(b, -0.4f, 0.4f) * half : 0.0f;
    int kind = dmg_weighted(b, (const float[]){4, 3, 1.5f}, 3); /* a half turn, endless, about a level line */
    float way = dmg_sign(b), swing = dmg_range(b, 1.4f, 3.14f);
    uint32_t part;
    if (kind == 2)
        part = dmg_hinge(b, 0, "wall", v3(0, 0.5f * s->y, z), v3(way, 0, 0), 0.0f, 0.5f * swing);
    else if (kind == 1)
        part = dmg_spin(b, 0, "wall", v3(0, 0, z), v3(0, way, 0));
    else
        part = dmg_hinge(b, 0, "wall", v3(off, 0, z), v3(0, way, 0), 0.0f, swing);
    t = fminf(t, 0.25f * half);
    dmg_box_span(b, v3(-half, low, z - t), v3(half, s->y - low, z + t));
    bool disc = kind == 1 && dmg_chance(b, 0.5f);
    if (disc) dmg_rod(b, v3(0, low, z), v3(0, 2.5f * low, z), 0.98f * half);
    if (kind < 2 && dmg_chance(b, 0.6f))
        for (int k = 0; k < 2; ++k) dmg_rod(b, v3(off, k ? s->y - low : 0, z), v3(off, k ? s->y : low, z), 0.5f * t);
    int dress = dmg_int(b, 0, 3);
    for (int i = 0; i < 3 && dress == 1; ++i) /* shelves */
        dmg_box(b, v3(0, s->y * (0.3f + 0.2f * (float)i), z + 1.3f * t), v3(1.4f * half, 0.02f * s->y, 0.6f * t));
    if (dress == 2) dmg_box(b, v3(0, 0.55f * s->y, z + t), v3(1.1f * half, 0.4f * s->y, 0.3f * t)); /* a picture */
    if (dress == 3) { /* a rack with a shield */
        dmg_rod(b, v3(0, 0.6f * s->y, z + t), v3(0, 0.6f * s->y, z + 1.2f * t), 0.4f * half);
        dmg_hinge(b, part, "lever", v3(0.6f * half, 0.45f * s->y, z + t), v3(0, 0, dmg_sign(b)), 0.0f, 1.2f);
        dmg_rod(b, v3(0.6f * half, 0.45f * s->y, z + t), v3(0.6f * half, 0.45f * s->y, z + 1.4f * t), 0.07f * half);
        dmg_box(b, v3(0.6f * half, 0.52f * s->y, z + 1.4f * t), v3(0.07f * half, 0.16f * s->y, 0.2f * t));
    }
    dmg_use(b, 0);
}

/* Draws a stone the size of the opening, or a few in it, that draw back, sink, rise or go aside behind the wall. */
static void build_stones(dmg_builder* b, const site* s) {
    site wall = *s;
    wall.stones = 1;
    float side = dmg_sign(b);
    draw_wall(b, &wall, 0);
    int way = dmg_int(b, 0, 3), count = way == 0 ? dmg_int(b, 1, 4) : way == 3 ? 1 : dmg_int(b, 1, 2);
    bool coursed = dmg_chance(b, 0.5f);
    float gap = 0.015f * s->x, high = s->y / (float)count, z = way == 3 || way == 1 ? -1.05f * s->deep : 0.0f;
    for (int i = 0; i < count; ++i) {
        float wide = 2 * s->x, back = z - s->deep * dmg_range(b, 0.9f, 1.3f);
        float travel = way == 0 ? s->deep * dmg_range(b, 0.5f, 2.5f) : high * dmg_range(b, 0.6f, 0.95f);
        if (way == 0) dmg_slide(b, 0, "stone", v3(0, 0, -1), 0.0f, travel);
        if (way == 1) dmg_slide(b, 0, "stone", v3(0, count > 1 && i == 0 ? -1 : 1, 0), 0.0f, travel);
        if (way == 2 && count == 1) dmg_slide(b, 0, "stone", v3(0, -1, 0), 0.0f, travel);
        if (way == 2 && count > 1) dmg_slide(b, 0, "stone", v3(0, 0, i ? 1 : -1), 0.0f, fminf(travel, 1.5f * s->deep));
        if (way == 3) dmg_slide(b, 0, "stone", v3(side, 0, 0), 0.0f, 0.95f * wide);
        float grow = z < 0 ? -gap : gap;
        float y0 = high * (float)i + gap, y1 = high * (float)(i + 1) - gap;
        if (coursed) /* a piece of the wall */
            draw_courses(b, -s->x + grow, s->x - grow, y0, y1, back, z);
        else
            dmg_box_span(b, v3(-s->x + grow, y0, back), v3(s->x - grow, y1, z));
        if (dmg_chance(b, 0.5f))
            dmg_torus(b, v3(0, high * ((float)i + 0.5f), z), v3(0, 0, 1), 0.2f * fminf(s->x, high), 0.03f * s->x);
        dmg_use(b, 0);
    }
}

/* Draws a slab on the floor over a pit with stairs: pushed aside, swung on a corner, or the statue on it goes with it.
 */
static void build_slab(dmg_builder* b, const site* s) {
    float x = s->x, z = s->x * dmg_range(b, 1.0f, 2.0f), rim = 0.3f * x, deep = s->x * dmg_range(b, 0.5f, 1.2f),
          t = 0.15f * x;
    const dmg_xy outer[] = {{x + rim, z + rim}, {-x - rim, z + rim}, {-x - rim, -z - rim}, {x + rim, -z - rim}};
    const dmg_xy inner[] = {{x, z}, {-x, z}, {-x, -z}, {x, -z}};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_ring_plate(b, outer, inner, 4, 0, deep);
    dmg_restore(b);
    int steps = dmg_int(b, 0, 5), kind = dmg_int(b, 0, 2), statue = dmg_int(b, 0, 3);
    for (int i = 0; i < steps; ++i)
        dmg_box_span(
            b, v3(-x, 0, -z + 1.6f * z * (float)i / (float)steps),
            v3(x, deep * 0.85f * (1.0f - (float)i / (float)steps), -z + 1.6f * z * (float)(i + 1) / (float)steps));
    float y = deep + 0.02f * t, side = dmg_sign(b);
    if (kind == 0) dmg_slide(b, 0, "slab", v3(side, 0, 0), 0.0f, x * dmg_range(b, 1.0f, 1.9f));
    if (kind == 1) dmg_slide(b, 0, "slab", v3(0, 0, side), 0.0f, z * dmg_range(b, 1.0f, 1.9f));
    if (kind == 2)
        dmg_hinge(b, 0, "slab", v3(x + 0.5f * rim, 0, side * (z + 0.5f * rim)), v3(0, -side, 0), 0.0f,
                  dmg_range(b, 0.8f, 1.9f));
    dmg_box_span(b, v3(-x - 0.8f * rim, y, -z - 0.8f * rim), v3(x + 0.8f * rim, y + t, z + 0.8f * rim));
    if (statue == 1) dmg_box_span(b, v3(-0.6f * x, y + t, -0.6f * x), v3(0.6f * x, y + 1.5f * x, 0.6f * x));
    if (statue == 2) dmg_cone(b, v3(0, y + t, 0), v3(0, y + 2.2f * x, 0), 0.6f * x, 0.3f * x);
    if (statue == 2) dmg_ellipsoid(b, v3(0, y + 2.4f * x, 0), v3(0.3f * x, 0.4f * x, 0.3f * x));
    if (statue == 3)
        for (int k = -1; k <= 1; k += 2)
            dmg_torus(b, v3(0, y + t, (float)k * 0.6f * z), v3(1, 0, 0), 0.2f * x, 0.04f * x);
    dmg_use(b, 0);
    dmg_move(b, -side * (x + rim + 0.6f * x), 0, 0);
    if (dmg_chance(b, 0.6f)) draw_bust(b, x);
}

void dmg_build_secret_wall(dmg_builder* b) {
    site s = pick_site(b);
    int kind = dmg_weighted(b, (const float[]){3.5f, 3, 2.5f, 1.5f}, 4);
    dmg_save(b);
    switch (kind) {
    case 0:
        build_bookcase(b, &s);
        break;
    case 1:
        build_turning_wall(b, &s);
        break;
    case 2:
        build_stones(b, &s);
        break;
    default:
        build_slab(b, &s);
        break;
    }
    dmg_restore(b);
    float side = dmg_sign(b);
    if (kind == 1 || kind == 2) draw_triggers(b, &s, side);
    if ((kind == 1 || kind == 2) && dmg_chance(b, 0.4f)) draw_triggers(b, &s, -side);
    dmg_use(b, 0);
}
