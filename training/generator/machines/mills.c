/* Draws knee mills, drill presses on a round column, machining centres behind doors: tables on slides, spindles in
 * quills, wheels and levers that feed them. */
#include "core/build.h"
#include "parts/cranks.h"
#include "parts/hardware.h"
#include "parts/shop.h"

/* Half of the table is `half`; the column's front is z = 0, the floor y = 0. */
typedef struct mill {
    float unit, half, deep, high; /* of the column: width, depth, height */
} mill;

/* Draws the tool below the origin: a chuck, a collet with a cutter, a face mill. */
static void draw_tool(dmg_builder* b, float r) {
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) {
        dmg_rod(b, v3(0, -1.2f * r, 0), v3(0, 0, 0), r);
        dmg_cone(b, v3(0, -1.2f * r, 0), v3(0, -1.9f * r, 0), 0.9f * r, 0.35f * r);
    }
    if (kind == 1) dmg_cone(b, v3(0, -1.5f * r, 0), v3(0, 0, 0), 0.6f * r, r);
    if (kind == 2) {
        dmg_rod(b, v3(0, -0.8f * r, 0), v3(0, 0, 0), 0.7f * r);
        dmg_rod(b, v3(0, -1.5f * r, 0), v3(0, -0.8f * r, 0), 1.8f * r);
        for (int i = 0; i < 5; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, 5);
            dmg_box(b, v3(1.75f * r, -1.35f * r, 0), v3(0.3f * r, 0.5f * r, 0.4f * r));
            dmg_restore(b);
        }
    } else if (dmg_chance(b, 0.7f))
        dmg_rod(b, v3(0, -3.2f * r, 0), v3(0, -1.2f * r, 0), r * 0.25f);
}

/* Draws a quill that comes down out of the origin with the spindle that turns in it; `room` is free below. */
static void draw_quill(dmg_builder* b, uint32_t head, float r, float way) {
    float out = r * dmg_range(b, 0.4f, 2.0f), thin = dmg_range(b, 0.5f, 0.8f);
    uint32_t quill = head;
    if (dmg_chance(b, 0.75f)) {
        quill = dmg_slide(b, head, "quill", v3(0, -1, 0), 0.0f, way);
        if (dmg_chance(b, 0.3f)) dmg_rest(b, quill, way * dmg_unit(b));
        dmg_rod(b, v3(0, -out, 0), v3(0, way + 0.5f * r, 0), r);
    } else
        dmg_rod(b, v3(0, -out, 0), v3(0, 0.2f * r, 0), r);
    dmg_spin(b, quill, "spindle", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    dmg_move(b, 0, -out, 0);
    draw_tool(b, thin * r);
    dmg_use(b, head);
}

/* Draws a slab with T-slots, a vice or a plate on it; its top at y = 0. */
static void draw_table(dmg_builder* b, uint32_t table, float half, float deep, float t) {
    int slots = dmg_int(b, 0, 4), load = dmg_int(b, 0, 3);
    dmg_box(b, v3(0, -0.5f * t, 0), v3(2 * half, t, deep));
    for (int i = 0; i <= slots && slots > 1; ++i) /* ribs between the slots */
        dmg_box(b, v3(0, 0.1f * t, deep * ((float)i / (float)slots - 0.5f) * 0.9f),
                v3(1.98f * half, 0.2f * t, 0.55f * deep / (float)slots));
    float s = 0.4f * deep, x = half * dmg_range(b, -0.3f, 0.3f);
    if (load == 1) dmg_box(b, v3(x, 0.6f * t, 0), v3(s, 0.9f * t, s));
    if (load != 2) return;
    dmg_save(b); /* a vice: the nearer jaw slides */
    dmg_move(b, x, 0.2f * t, 0);
    dmg_box(b, v3(0, 0.2f * s, 0), v3(s, 0.4f * s, 1.6f * s));
    dmg_box(b, v3(0, 0.6f * s, -0.65f * s), v3(s, 0.5f * s, 0.3f * s));
    dmg_slide(b, table, "jaw", v3(0, 0, -1), -0.1f * s, 0.55f * s);
    dmg_box(b, v3(0, 0.6f * s, 0.3f * s), v3(s, 0.5f * s, 0.3f * s));
    dmg_use(b, table);
    if (dmg_chance(b, 0.6f)) dmg_handwheel_place(b, table, "vice_handle", v3(0, 0.2f * s, 0.8f * s), 0, 0.35f * s);
    dmg_restore(b);
}

/* Knee, saddle and table, one on the other; the table's top at rest at y = top. */
static void draw_knee(dmg_builder* b, const mill* m, float top, float way) {
    float u = m->unit, t = 0.2f * u, reach = u * dmg_range(b, 1.2f, 1.8f), z = 0.5f * reach;
    bool lifts = dmg_chance(b, 0.85f);
    uint32_t knee = 0;
    dmg_save(b);
    dmg_move(b, 0, top, 0);
    if (lifts) knee = dmg_slide(b, 0, "knee", v3(0, dmg_sign(b), 0), -way, way);
    dmg_box_span(b, v3(-0.4f * u, -0.9f * u, 0.01f * u), v3(0.4f * u, -3 * t, reach));
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, -1.3f * u - way, z), v3(0, -0.8f * u, z), 0.12f * u);
    dmg_handwheel_place(b, knee, "knee_crank", v3(0.15f * u, -0.7f * u, reach), 0, 0.25f * u);
    uint32_t saddle = dmg_slide(b, knee, "saddle", v3(0, 0, dmg_sign(b)), -0.2f * u, 0.2f * u);
    dmg_box(b, v3(0, -2 * t, z), v3(0.9f * u, 2 * t, 0.6f * reach));
    uint32_t table = dmg_slide(b, saddle, "table", v3(dmg_sign(b), 0, 0), -0.6f * m->half, 0.6f * m->half);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, table, m->half * dmg_range(b, -0.5f, 0.5f));
    dmg_move(b, 0, 0, z);
    draw_table(b, table, m->half, 0.6f * reach, t);
    for (int s = -1; s <= 1; s += 2)
        if (dmg_chance(b, 0.7f))
            dmg_handwheel_place(b, table, "table_wheel", v3((float)s * m->half, -0.5f * t, 0), (float)s * 0.5f * DMG_PI,
                                0.28f * u);
    dmg_use(b, saddle);
    if (dmg_chance(b, 0.5f))
        dmg_machine_lever_place(b, saddle, "lock", v3(0.2f * u, -2 * t, 0.3f * reach), 0, 0.3f * u);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a head before the column or a ram's end, its spindle's nose at the origin; motor on top, lever at the side. */
static void draw_mill_head(dmg_builder* b, uint32_t head, float u, float way) {
    float r = u * dmg_range(b, 0.12f, 0.22f), h = u * dmg_range(b, 0.9f, 1.5f), w = u * dmg_range(b, 0.25f, 0.4f);
    bool round = dmg_chance(b, 0.4f), motor = dmg_chance(b, 0.7f);
    if (round)
        dmg_rod(b, v3(0, 0, 0), v3(0, h, 0), w);
    else
        dmg_rounded_box(b, v3(0, 0.5f * h, -0.1f * w), v3(2 * w, h, 2.1f * w), 0.2f * w);
    if (motor) dmg_rod(b, v3(0, h, 0), v3(0, h + u * 0.6f, 0), 0.75f * w);
    dmg_handwheel_place(b, head, "quill_lever", v3(w, 0.3f * h, 0), 0.5f * DMG_PI, 0.35f * u);
    if (dmg_chance(b, 0.4f)) dmg_machine_lever_place(b, head, "brake", v3(-w, 0.7f * h, 0), -0.5f * DMG_PI, 0.25f * u);
    dmg_save(b);
    draw_quill(b, head, r, fminf(way, 0.6f * h));
    dmg_restore(b);
}

/* Draws a column, knee and table before it, a ram over them with a head that tilts. */
static void draw_knee_mill(dmg_builder* b) {
    float u = dmg_scale_range(b, 0.08f, 0.6f);
    mill m = {.unit = u, .half = u * dmg_range(b, 1.0f, 2.2f)};
    m.deep = u * dmg_range(b, 0.8f, 1.4f);
    m.high = u * dmg_range(b, 3.0f, 4.0f);
    float wide = u * dmg_range(b, 0.7f, 1.1f), ram = 0.5f * u, z = u * dmg_range(b, 0.7f, 0.9f), way = 0.35f * u;
    bool slides = dmg_chance(b, 0.6f);
    dmg_box_span(b, v3(-0.8f * u, 0, -1.1f * m.deep), v3(0.8f * u, 0.2f * u, 2 * u));
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.5f * wide, 0, -m.deep), v3(0.5f * wide, m.high, 0));
    else { /* wider at its foot */
        dmg_box_span(b, v3(-0.5f * wide, 0, -m.deep), v3(0.5f * wide, 0.5f * m.high, 0));
        dmg_box_span(b, v3(-0.4f * wide, 0.5f * m.high, -0.8f * m.deep), v3(0.4f * wide, m.high, 0));
    }
    draw_knee(b, &m, 0.55f * m.high, way);
    uint32_t head = 0;
    if (slides) head = dmg_slide(b, 0, "ram", v3(0, 0, 1), -0.25f * u, 0.3f * u);
    dmg_box_span(b, v3(-0.35f * wide, m.high + 0.01f * u, -1.2f * m.deep), v3(0.35f * wide, m.high + ram, 0.45f * u));
    if (slides && dmg_chance(b, 0.5f))
        dmg_handwheel_place(b, head, "ram_crank", v3(0.35f * wide, m.high + 0.5f * ram, -0.4f * m.deep), 0.5f * DMG_PI,
                            0.2f * u);
    if (dmg_chance(b, 0.6f))
        head = dmg_hinge(b, head, "head", v3(0, m.high + 0.5f * ram, 0.45f * u), v3(0, 0, dmg_sign(b)), -0.8f, 0.8f);
    dmg_rod(b, v3(0, m.high + 0.5f * ram, 0.4f * u), v3(0, m.high + 0.5f * ram, z), 0.4f * ram);
    dmg_move(b, 0, m.high - 0.1f * u, z);
    draw_mill_head(b, head, u, 0.4f * u);
    dmg_use(b, 0);
}

/* On the column: a round table on an arm that turns about it, or one that slides up it. */
static void draw_drill_table(dmg_builder* b, float u, float reach, float at, float way) {
    bool turns = dmg_chance(b, 0.4f);
    float r = u * dmg_range(b, 0.6f, 1.0f), t = 0.12f * u, over = fminf(r, reach - 0.35f * u);
    uint32_t table = turns ? dmg_hinge(b, 0, "table", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -1.5f, 1.5f)
                           : dmg_slide(b, 0, "table", v3(0, dmg_sign(b), 0), -way, way);
    dmg_save(b);
    dmg_move(b, 0, at, 0);
    dmg_tube_draw(b, v3(0, -0.35f * u, 0), v3(0, 1, 0), 0.4f * u, 0.205f * u, 0.08f * u);
    dmg_box_span(b, v3(-0.15f * u, -0.3f * u, 0.25f * u), v3(0.15f * u, -t, reach - 0.1f * u));
    dmg_handwheel_place(b, table, "crank", v3(0.28f * u, -0.15f * u, 0), 0.5f * DMG_PI, 0.2f * u);
    if (dmg_chance(b, 0.5f)) dmg_hinge(b, table, "tilt", v3(0, -0.2f * u, reach), v3(0, 0, 1), -0.8f, 0.8f);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, -t, reach), v3(0, 0, reach), over);
    else
        dmg_box(b, v3(0, -0.5f * t, reach), v3(2.4f * over, t, 2 * over));
    dmg_rod(b, v3(0, -0.25f * u, reach - 0.2f * u), v3(0, -0.25f * u, reach + 0.1f * u), 0.1f * u);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a belt's cover that lifts at its back, a switch box, the motor behind. */
static void draw_drill_head(dmg_builder* b, float u, float reach) {
    float w = u * dmg_range(b, 0.35f, 0.5f), h = u * dmg_range(b, 0.8f, 1.2f), back = -0.9f * u,
          front = reach + 1.1f * w, lid = u * dmg_range(b, 0.2f, 0.4f);
    dmg_rounded_box(b, v3(0, 0.5f * h, 0.5f * reach), v3(2 * w, h, reach + 2 * w), 0.2f * w);
    dmg_rod(b, v3(0, 0, -0.6f * u), v3(0, 0.9f * h, -0.6f * u), 0.35f * u);
    dmg_handwheel_place(b, 0, "feed", v3(w, 0.35f * h, reach), 0.5f * DMG_PI, 0.6f * u);
    dmg_save(b);
    dmg_move(b, 0, 0.4f * h, reach + w);
    dmg_controls_draw(b, 0, 1.2f * w, 0.4f * h);
    dmg_restore(b);
    bool hung = dmg_chance(b, 0.7f), side = dmg_chance(b, 0.4f);
    if (hung)
        dmg_hinge(b, 0, "cover", side ? v3(-w, h, 0) : v3(0, h, back), side ? v3(0, 0, 1) : v3(-1, 0, 0), 0.0f,
                  dmg_range(b, 0.8f, 1.7f));
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, h + 0.5f * lid, 0.5f * (back + front)), v3(2.2f * w, lid, front - back), 0.3f * lid);
    else
        dmg_box_span(b, v3(-w, h, back), v3(w, h + lid, front));
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0, 0, reach);
    draw_quill(b, 0, 0.4f * w, 0.6f * h);
    dmg_restore(b);
}

static void draw_drill_press(dmg_builder* b) {
    float u = dmg_scale_range(b, 0.06f, 0.35f), tall = dmg_chance(b, 0.5f) ? 4.0f : 7.0f,
          high = u * tall * dmg_range(b, 0.8f, 1.2f), reach = u * dmg_range(b, 1.1f, 1.7f), table = 0.5f * high,
          way = 0.2f * high;
    dmg_box_span(b, v3(-0.9f * u, 0, -0.6f * u), v3(0.9f * u, 0.2f * u, reach + 0.7f * u));
    dmg_rod(b, v3(0, 0, 0), v3(0, high + 0.3f * u, 0), 0.2f * u);
    if (dmg_chance(b, 0.8f)) draw_drill_table(b, u, reach, table, way);
    if (dmg_chance(b, 0.3f)) { /* a rack up the column */
        dmg_box_span(b, v3(-0.26f * u, 0.2f * u, -0.05f * u), v3(-0.2f * u, high, 0.05f * u));
    }
    dmg_move(b, 0, high, 0);
    draw_drill_head(b, u, reach);
}

/* The table on two slides below a head that comes down; walls, doors and a panel round them. */
static void draw_centre(dmg_builder* b) {
    float u = dmg_scale_range(b, 0.15f, 0.6f), half = u * dmg_range(b, 0.9f, 1.5f), t = 0.2f * u,
          base = u * dmg_range(b, 0.8f, 1.5f), high = 3.0f * u, z = 0.2f * u, way = 0.5f * u;
    dmg_box_span(b, v3(-2.0f * half, 0, -1.6f * u), v3(2.0f * half, base, 1.4f * u));
    dmg_move(b, 0, base, 0);
    dmg_box_span(b, v3(-0.45f * u, 0, -1.5f * u), v3(0.45f * u, high, -0.8f * u));
    uint32_t saddle = dmg_slide(b, 0, "saddle", v3(0, 0, dmg_sign(b)), -0.35f * u, 0.35f * u);
    dmg_box(b, v3(0, 1.05f * t, z), v3(0.9f * half, 2 * t, u));
    uint32_t table = dmg_slide(b, saddle, "table", v3(dmg_sign(b), 0, 0), -0.7f * half, 0.7f * half);
    dmg_save(b);
    dmg_move(b, 0, 3.1f * t, z);
    draw_table(b, table, half, 0.8f * u, t);
    dmg_restore(b);
    dmg_use(b, 0);
    uint32_t head = dmg_slide(b, 0, "head", v3(0, -1, 0), -0.2f * u, way);
    dmg_box_span(b, v3(-0.4f * u, 1.8f * u, -0.79f * u), v3(0.4f * u, 2.9f * u, z + 0.35f * u));
    dmg_save(b);
    dmg_move(b, 0, 1.8f * u, z);
    float r = u * dmg_range(b, 0.12f, 0.2f);
    dmg_spin(b, head, "spindle", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, -0.8f * r, 0), v3(0, 0.1f * r, 0), 1.3f * r);
    dmg_move(b, 0, -0.8f * r, 0);
    draw_tool(b, r);
    dmg_restore(b);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) { /* the drum that holds the other tools */
        dmg_save(b);
        dmg_move(b, -1.3f * half, 2.2f * u, -0.7f * u);
        dmg_spin(b, 0, "magazine", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
        dmg_wheel_draw(b, 0, 0.6f * half, 0.2f * u, 6);
        for (int i = 0; i < 8; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 0, 1), i, 8);
            dmg_cone(b, v3(0.48f * half, 0, 0.1f * u), v3(0.48f * half, 0, 0.35f * u), 0.09f * half, 0.04f * half);
            dmg_restore(b);
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.75f)) dmg_enclosure_draw(b, v3(3.8f * half, 2.9f * u, 2.7f * u), 0.06f * u);
    dmg_move(b, 2.0f * half + 0.3f * u, 1.8f * u, 1.2f * u);
    if (dmg_chance(b, 0.7f)) dmg_pendant_draw(b, 0.7f * u);
}

void dmg_build_milling_machine(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){0.4f, 0.35f, 0.25f}, 3);
    if (kind == 0) draw_knee_mill(b);
    if (kind == 1) draw_drill_press(b);
    if (kind == 2) draw_centre(b);
}
