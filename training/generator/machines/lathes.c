/* Draws lathes for metal and wood, and turning centres behind doors: the bed carries the saddle, the saddle the
 * cross slide; spindles, hand wheels and levers turn on what they move. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/shop.h"

/* ---- lathes: the bed's top is y = 0, the spindle along +X at height `swing`; the headstock ends at x = 0 ---- */

typedef struct lathe {
    float swing, length, half; /* half: of the bed's width */
    float head;                /* length of the headstock */
    int bed;                   /* two ways, solid, two round bars, one bar */
    bool wood;
} lathe;

static void draw_bed(dmg_builder* b, const lathe* l) {
    float h = 0.7f * l->swing, from = -l->head, to = l->length, w = l->half;
    for (int s = -1; s <= 1 && l->bed == 0; s += 2)
        dmg_box_span(b, v3(from, -h, (s < 0 ? -1.0f : 0.45f) * w), v3(to, 0, (s < 0 ? -0.45f : 1.0f) * w));
    for (int i = 0; i < 4 && l->bed == 0; ++i)
        dmg_box(b, v3(from + (to - from) * (0.1f + 0.26f * (float)i), -0.5f * h, 0), v3(0.15f * w, 0.8f * h, 1.2f * w));
    if (l->bed == 1) dmg_box_span(b, v3(from, -h, -w), v3(to, 0, w));
    for (int s = -1; s <= 1 && l->bed == 2; s += 2)
        dmg_rod(b, v3(from, -0.3f * w, (float)s * 0.7f * w), v3(to, -0.3f * w, (float)s * 0.7f * w), 0.25f * w);
    if (l->bed == 3) dmg_rod(b, v3(from, -0.4f * w, 0), v3(to, -0.4f * w, 0), 0.4f * w);
    if (l->bed >= 2)
        for (int s = 0; s <= 1; ++s)
            dmg_box_span(b, v3(s ? to - 0.3f * w : from, -h, -w), v3(s ? to : from + 0.3f * w, 0, w));
}

/* Jaws that slide in the chuck's face, a plate with slots, a nut, a spur; some hold a workpiece. */
static void draw_chuck(dmg_builder* b, const lathe* l, uint32_t spindle) {
    int kind = dmg_weighted(b, (const float[]){0.55f, 0.15f, 0.15f, 0.15f}, 4), jaws = dmg_int(b, 3, 4);
    float r = l->swing * dmg_range(b, 0.35f, 0.75f), thick = r * dmg_range(b, 0.4f, 0.9f), jaw = 0.3f * r,
          in = jaw * dmg_range(b, 0.4f, 0.9f), end = 0.1f * r + (kind == 1 ? 0.25f : 1.0f) * thick, work = 0.2f * r;
    bool slide = dmg_chance(b, 0.6f);
    dmg_rod(b, v3(-0.2f * r, 0, 0), v3(0.1f * r, 0, 0), 0.5f * r);
    if (kind <= 1) dmg_rod(b, v3(0.1f * r, 0, 0), v3(end, 0, 0), r);
    if (kind == 2) dmg_cone(b, v3(0.1f * r, 0, 0), v3(end, 0, 0), 0.55f * r, 0.4f * r);
    if (kind == 3) dmg_cone(b, v3(0.1f * r, 0, 0), v3(end, 0, 0), 0.3f * r, 0.05f * r);
    if (kind < 3 && dmg_chance(b, 0.5f))
        dmg_rod(b, v3(end, 0, 0), v3(fminf(0.35f * l->length, end + r * dmg_range(b, 0.5f, 3.0f)), 0, 0), work);
    for (int i = 0; i < jaws && kind == 0; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(1, 0, 0), i, jaws);
        if (slide) dmg_slide(b, spindle, "jaw", v3(0, -1, 0), -0.5f * jaw, in);
        dmg_box(b, v3(end + 0.1f * r, 0.2f * r + in + 0.8f * jaw, 0), v3(0.3f * r, 1.6f * jaw, 0.8f * jaw));
        dmg_box(b, v3(end + 0.25f * r, 0.2f * r + in + 0.4f * jaw, 0), v3(0.5f * r, 0.8f * jaw, 0.7f * jaw));
        dmg_use(b, spindle);
        dmg_restore(b);
    }
}

/* Over the chuck, hung on the headstock behind the spindle. */
static void draw_chuck_guard(dmg_builder* b, const lathe* l) {
    float r = 0.9f * l->swing, wide = l->swing * dmg_range(b, 0.5f, 1.0f), z = -0.95f * r;
    dmg_xy line[7];
    for (int i = 0; i < 7; ++i) {
        float angle = 3.1f - 0.42f * (float)i;
        line[i] = (dmg_xy){-r * cosf(angle), r * sinf(angle)};
    }
    dmg_hinge(b, 0, "guard", v3(0, l->swing, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.8f));
    dmg_save(b);
    dmg_move(b, 0.1f * wide + 0.5f * wide, l->swing, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* the line's x is -Z now */
    dmg_bent_plate(b, line, 7, 0.05f * r, wide);
    dmg_restore(b);
    dmg_rod(b, v3(-0.3f * wide, l->swing, z), v3(0.2f * wide, l->swing, z), 0.06f * r);
    dmg_use(b, 0);
}

static void draw_headstock(dmg_builder* b, const lathe* l) {
    float high = l->swing * dmg_range(b, 1.35f, 1.9f), deep = l->half * dmg_range(b, 1.0f, 1.3f), s = l->swing;
    int kind = dmg_int(b, 0, 2);
    dmg_vec middle = {-0.5f * l->head, 0.5f * high, 0}, size = {l->head, high, 2 * deep};
    if (kind == 0) dmg_box(b, middle, size);
    if (kind == 1) dmg_rounded_box(b, middle, size, 0.15f * s);
    if (kind == 2) { /* two bearings and a belt pulley between them */
        for (int e = 0; e <= 1; ++e)
            dmg_box_span(b, v3(e ? -0.3f * l->head : -l->head, 0, -0.7f * deep),
                         v3(e ? 0 : -0.7f * l->head, 1.3f * s, 0.7f * deep));
        dmg_box_span(b, v3(-l->head, 0, -0.7f * deep), v3(0, 0.3f * s, 0.7f * deep));
    }
    uint32_t spindle = dmg_spin(b, 0, "spindle", v3(0, s, 0), v3(dmg_sign(b), 0, 0));
    dmg_save(b);
    dmg_move(b, 0, s, 0);
    draw_chuck(b, l, spindle);
    for (int i = 0; i < 3 && kind == 2; ++i)
        dmg_rod(b, v3((-0.35f - 0.1f * (float)i) * l->head, 0, 0), v3((-0.43f - 0.1f * (float)i) * l->head, 0, 0),
                (0.35f + 0.1f * (float)i) * s);
    dmg_restore(b);
    dmg_use(b, 0);
    if (kind == 2) return;
    for (int i = 0, count = dmg_int(b, 0, 3); i < count; ++i)
        dmg_machine_lever_place(b, 0, "speed", v3(l->head * (-0.2f - 0.3f * (float)i), 0.45f * high, deep), 0.0f,
                                0.35f * s);
    if (dmg_chance(b, 0.5f)) { /* the gears' cover at the end, a lid on top, or neither */
        float t = 0.25f * s;
        dmg_hinge(b, 0, "cover", v3(-l->head, 0, -deep), v3(0, -1, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
        dmg_box_span(b, v3(-l->head - t, -0.3f * s, -deep), v3(-l->head - 0.01f * s, 0.95f * high, 0.95f * deep));
    } else if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, 0, "lid", v3(0, high, -deep), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.8f));
        dmg_box_span(b, v3(-l->head, high, -deep), v3(0, high + 0.12f * s, deep));
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.3f)) draw_chuck_guard(b, l);
}

/* Draws the post: a block with tools that turns, locked by a lever; lower, a rest of the turner's tool. */
static void draw_tool_post(dmg_builder* b, uint32_t carrier, float room, float wide) {
    float post = fminf(0.55f * room, 0.6f * wide);
    uint32_t turret = dmg_chance(b, 0.6f) ? dmg_spin(b, carrier, "tool_post", v3(0, 0, 0), v3(0, 1, 0)) : carrier;
    dmg_box(b, v3(0, 0.5f * room, 0), v3(post, room, post));
    dmg_box(b, v3(-0.4f * post, 0.8f * room, -0.8f * post), v3(0.2f * post, 0.2f * post, 1.6f * post));
    if (dmg_chance(b, 0.6f)) {
        dmg_hinge(b, turret, "lock", v3(0, room, 0), v3(0, 1, 0), -1.5f, 0.8f);
        dmg_rod(b, v3(0, room, 0), v3(0, 1.15f * room, 0), 0.25f * post);
        dmg_rod(b, v3(0, 1.1f * room, 0), v3(0.9f * post, 1.4f * room, 0.5f * post), 0.08f * post);
        dmg_ellipsoid(b, v3(0.9f * post, 1.4f * room, 0.5f * post), v3(0.15f * post, 0.15f * post, 0.15f * post));
    }
    dmg_use(b, carrier);
}

/* Saddle and apron along the bed, on it a slide across, on that one that swivels, and the tool. */
static void draw_carriage(dmg_builder* b, const lathe* l, float from, float to) {
    float s = l->swing, wide = s * dmg_range(b, 0.7f, 1.2f), t = 0.16f * s, deep = 1.25f * l->half,
          at = from + 0.5f * wide + 0.3f * (to - from - wide) * dmg_unit(b);
    uint32_t carriage = dmg_slide(b, 0, "carriage", v3(dmg_sign(b), 0, 0), 0, 0);
    dmg_joint* joint = &b->parts[carriage - 1].joint;
    float low = from + 0.5f * wide - at, high = to - 0.5f * wide - at;
    bool forward = joint->axis[0] > 0;
    joint->lower = forward ? low : -high;
    joint->upper = forward ? high : -low;
    dmg_save(b);
    dmg_move(b, at, 0.01f * s, 0);
    dmg_box(b, v3(0, 0.5f * t, 0), v3(wide, t, 2 * deep));
    float apron = 0.6f * s;
    dmg_box_span(b, v3(-0.5f * wide, -apron, 1.03f * l->half), v3(0.5f * wide, 0, deep));
    dmg_handwheel_place(b, carriage, "handwheel", v3(-0.2f * wide, -0.5f * apron, deep), 0, 0.3f * s);
    if (dmg_chance(b, 0.5f))
        dmg_machine_lever_place(b, carriage, "feed", v3(0.3f * wide, -0.6f * apron, deep), 0, 0.3f * s);
    float slide = 0.6f * deep, way = deep - 0.4f * slide;
    uint32_t cross = dmg_slide(b, carriage, "cross_slide", v3(0, 0, dmg_sign(b)), -0.4f * way, 0.4f * way);
    dmg_move(b, 0, t, 0.2f * deep);
    dmg_box(b, v3(0, 0.5f * t, 0.2f * deep), v3(0.5f * wide, t, 2 * slide));
    dmg_handwheel_place(b, cross, "handle", v3(0, 0.5f * t, 0.2f * deep + slide), 0, 0.2f * s);
    dmg_move(b, 0, t, 0);
    uint32_t top = cross;
    if (dmg_chance(b, 0.6f)) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.3f * t, 0), 0.25f * wide);
        top = dmg_hinge(b, cross, "swivel", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -1.0f, 1.0f);
        dmg_move(b, 0, 0.3f * t, 0);
        dmg_turn(b, v3(0, 1, 0), dmg_range(b, -0.8f, 0.8f));
        dmg_box(b, v3(0, 0.3f * t, 0), v3(0.35f * wide, 0.6f * t, 0.7f * wide));
        dmg_move(b, 0, 0.6f * t, 0);
        top = dmg_slide(b, top, "top_slide", v3(0, 0, 1), -0.2f * wide, 0.2f * wide);
        dmg_box(b, v3(0, 0.3f * t, 0.1f * wide), v3(0.33f * wide, 0.6f * t, 0.7f * wide));
        dmg_handwheel_place(b, top, "handle", v3(0, 0.3f * t, 0.45f * wide), 0, 0.12f * s);
        dmg_move(b, 0, 0.6f * t, 0);
    }
    draw_tool_post(b, top, 0.4f * s, 0.6f * wide);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a turner's rest: a foot along the bed, a post in it that turns and rises, a bar on top. */
static void draw_rest(dmg_builder* b, const lathe* l, float at, float way) {
    float s = l->swing, long_side = s * dmg_range(b, 0.8f, 2.0f), z = l->half * dmg_range(b, 0.9f, 1.4f);
    uint32_t foot = dmg_slide(b, 0, "rest_base", v3(1, 0, 0), -0.5f * way, 0.5f * way);
    dmg_save(b);
    dmg_move(b, at, 0.01f * s, 0);
    dmg_box_span(b, v3(-0.15f * s, 0, -0.8f * l->half), v3(0.15f * s, 0.2f * s, z));
    dmg_rod(b, v3(0, 0, z), v3(0, 0.45f * s, z), 0.17f * s);
    if (dmg_chance(b, 0.5f))
        dmg_hinge(b, foot, "rest", v3(0, 0, z), v3(0, dmg_sign(b), 0), -1.2f, 1.2f);
    else
        dmg_slide(b, foot, "rest", v3(0, 1, 0), -0.1f * s, 0.25f * s);
    dmg_rod(b, v3(0, 0.3f * s, z), v3(0, 0.85f * s, z), 0.09f * s);
    dmg_box(b, v3(0, 0.9f * s, z), v3(long_side, 0.2f * s, 0.1f * s));
    dmg_use(b, foot);
    dmg_machine_lever_place(b, foot, "lock", v3(0, 0.3f * s, z + 0.17f * s), 0, 0.25f * s);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* On the bed, its quill out of it towards the chuck, its wheel behind. */
static void draw_tailstock(dmg_builder* b, const lathe* l, float at, float way) {
    float s = l->swing, wide = s * dmg_range(b, 0.7f, 1.2f), r = s * dmg_range(b, 0.22f, 0.35f), out = 0.3f * wide;
    int kind = dmg_int(b, 0, 2);
    uint32_t stock = dmg_slide(b, 0, "tailstock", v3(-1, 0, 0), -0.05f * way, way);
    dmg_save(b);
    dmg_move(b, at, 0.01f * s, 0);
    if (kind == 0) dmg_box_span(b, v3(-0.4f * wide, 0, -0.8f * l->half), v3(0.4f * wide, s, 0.8f * l->half));
    if (kind == 1) dmg_beam(b, v3(0, 0, 0), v3(0, s, 0), 0.7f * wide, 0.6f * l->half);
    if (kind != 0) dmg_box_span(b, v3(-0.5f * wide, 0, -0.9f * l->half), v3(0.5f * wide, 0.2f * s, 0.9f * l->half));
    if (kind == 2) dmg_box_span(b, v3(0, 0, -0.4f * l->half), v3(0.5f * wide, s, 0.4f * l->half));
    dmg_rod(b, v3(-0.55f * wide, s, 0), v3(0.55f * wide, s, 0), r);
    dmg_handwheel_place(b, stock, "handwheel", v3(0.55f * wide, s, 0), 0.5f * DMG_PI, 0.4f * s);
    if (dmg_chance(b, 0.5f)) dmg_machine_lever_place(b, stock, "lock", v3(0, 0.7f * s, 0.8f * l->half), 0, 0.3f * s);
    dmg_slide(b, stock, "quill", v3(-1, 0, 0), -0.8f * out, 0.6f * wide);
    dmg_rod(b, v3(-0.55f * wide - out, s, 0), v3(0, s, 0), 0.6f * r);
    dmg_cone(b, v3(-0.55f * wide - out, s, 0), v3(-0.55f * wide - out - 0.8f * r, s, 0), 0.4f * r, 0.0f);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a turret of stations that indexes about Z on a slide behind the spindle. */
static void draw_turret(dmg_builder* b, const lathe* l) {
    float s = l->swing, r = 0.6f * s, x = 0.55f * l->length;
    uint32_t slide = dmg_slide(b, 0, "slide", v3(dmg_sign(b), 0, 0), -0.25f * l->length, 0.25f * l->length);
    dmg_box(b, v3(x, 0.6f * s, -0.9f * l->half), v3(1.2f * s, 1.2f * s, 0.8f * l->half));
    slide = dmg_slide(b, slide, "cross_slide", v3(0, 1, 0), -0.4f * s, 0.4f * s);
    dmg_box(b, v3(x, 1.2f * s, -0.9f * l->half), v3(0.9f * s, 1.4f * s, 0.7f * l->half));
    dmg_save(b);
    dmg_move(b, x - 0.75f * s, 1.4f * s, -0.9f * l->half);
    dmg_spin(b, slide, "turret", v3(0, 0, 0), v3(dmg_sign(b), 0, 0));
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_wheel_draw(b, 0, r, 0.5f * s, 6);
    for (int i = 0; i < 6; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, 6);
        dmg_box(b, v3(1.2f * r, 0, 0), v3(0.5f * r, 0.2f * r, 0.2f * r));
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_lathe(dmg_builder* b) {
    lathe l = {.swing = dmg_scale_range(b, 0.03f, 0.35f)};
    l.length = l.swing * dmg_range(b, 3.5f, 8.0f);
    l.half = l.swing * dmg_range(b, 0.5f, 0.9f);
    l.head = l.swing * dmg_range(b, 1.2f, 3.0f);
    l.bed = dmg_int(b, 0, 3);
    l.wood = dmg_chance(b, 0.3f);
    bool centre = !l.wood && dmg_chance(b, 0.25f);
    float far = l.length - 0.7f * l.swing, stock = dmg_chance(b, 0.75f) ? 1.4f * l.swing : 0.0f;
    draw_bed(b, &l);
    draw_headstock(b, &l);
    if (stock > 0) draw_tailstock(b, &l, far, 0.35f * l.length);
    if (centre) draw_turret(b, &l);
    if (l.wood) draw_rest(b, &l, 0.4f * l.length, 0.4f * l.length);
    if (!centre && !l.wood) draw_carriage(b, &l, 0.1f * l.length, far - 0.5f * stock);
    dmg_move(b, 0, -0.7f * l.swing, 0);
    if (centre) {
        dmg_box_span(b, v3(-1.3f * l.head, -2 * l.swing, -3 * l.half), v3(1.05f * l.length, 0, 3 * l.half));
        float wide = l.length + 1.3f * l.head;
        dmg_save(b);
        dmg_move(b, 1.05f * l.length - 0.5f * wide, 0, 0);
        dmg_enclosure_draw(b, v3(wide, 4.5f * l.swing, 5.5f * l.half), 0.12f * l.swing);
        dmg_move(b, 0.5f * wide + 0.5f * l.swing, 3.5f * l.swing, 2 * l.half);
        dmg_pendant_draw(b, 1.5f * l.swing);
        dmg_restore(b);
    } else
        dmg_machine_stand_draw(b, -l.head, l.length, 2.2f * l.half, l.swing);
}
