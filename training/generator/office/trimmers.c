/* Draws desk tools with a blade: paper trimmers, hole punches, tape dispensers. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- a trimmer: a board, and a knife that swings down beside it or runs along a rail over it ---- */

typedef struct board {
    float wide, deep, thick; /* x, z, y of its top */
    float edge;              /* x of the line it cuts along */
} board;

/* Draws a knife on a pin at the far end of the edge, the grip at its near end. */
static void draw_swung_knife(dmg_builder* b, const board* o) {
    float far = -0.5f * o->deep - 0.04f * o->wide, reach = o->deep * dmg_range(b, 0.95f, 1.2f),
          tall = o->wide * dmg_range(b, 0.06f, 0.14f);
    float t = fmaxf(0.004f, 0.012f * o->wide), x = o->edge + 0.6f * t, pin = o->thick + 0.35f * tall,
          grip = reach * dmg_range(b, 0.15f, 0.3f);
    float up = dmg_range(b, 0.7f, 1.4f), r = 0.25f * tall;
    bool curved = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(o->edge - 3 * t, 0, far - 0.3f * tall), v3(o->edge, pin + 0.5f * tall, far + 0.6f * tall));
    uint32_t knife = dmg_hinge(b, 0, "knife", v3(x, pin, far), v3(-1, 0, 0), 0.0f, up);
    dmg_rest(b, knife, dmg_chance(b, 0.5f) ? 0.0f : up * dmg_range(b, 0.2f, 0.9f));
    dmg_rod(b, v3(x - 2.5f * t, pin, far), v3(x + 1.5f * t, pin, far), 0.3f * tall);
    dmg_save(b);
    dmg_move(b, x, 0, far);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* x of the outline runs along Z */
    float low = fmaxf(0.02f * o->wide, o->thick - 0.5f * tall), belly = curved ? 0.3f * tall : 0.0f;
    const dmg_xy blade[] = {{-0.3f * tall, low + belly},
                            {0.3f * reach, low + 0.3f * belly},
                            {0.7f * reach, low},
                            {reach, low + belly},
                            {reach, pin + 0.2f * tall},
                            {0.5f * reach, pin + 0.35f * tall + belly},
                            {-0.3f * tall, pin + 0.4f * tall}};
    dmg_extrude(b, blade, 7, -0.5f * t, 0.5f * t);
    dmg_restore(b);
    float y = pin + 0.1f * tall, end = far + reach;
    switch (dmg_int(b, 0, 3)) {
    case 0:
        dmg_rod(b, v3(x, y, end - 0.02f * reach), v3(x, y + 0.1f * grip, end + grip), r);
        break;
    case 1:
        dmg_ellipsoid(b, v3(x, y, end), v3(1.3f * r, 1.3f * r, 2.2f * r));
        break;
    case 2: /* across the end */
        dmg_rod(b, v3(x - 0.3f * r, y, end), v3(x + 1.5f * grip, y, end), r);
        break;
    default:
        dmg_rounded_box(b, v3(x + r, y + r, end - 0.3f * grip), v3(2.5f * r, 2.5f * r, grip), 0.4f * r);
        break;
    }
    dmg_use(b, 0);
}

/* Draws a rail over the edge, hung at one end so that paper goes under it; a head with a round blade runs along it. */
static void draw_rail_knife(dmg_builder* b, const board* o) {
    float high = o->wide * dmg_range(b, 0.03f, 0.07f), w = o->wide * dmg_range(b, 0.03f, 0.07f), half = 0.5f * o->deep;
    float size = w * dmg_range(b, 1.2f, 2.5f), at = dmg_chance(b, 0.5f) ? 1.0f : dmg_range(b, -0.8f, 0.8f),
          way = 2.0f * half - 2.5f * size;
    uint32_t rail = 0;
    bool swings = dmg_chance(b, 0.5f), lifts = dmg_chance(b, 0.4f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(o->edge - w, 0.5f * o->thick, (float)s * (half + 0.6f * w) - 0.5f * w),
                     v3(o->edge + w, o->thick + high, (float)s * (half + 0.6f * w) + 0.5f * w));
    if (swings)
        rail = dmg_hinge(b, 0, "rail", v3(o->edge, o->thick + high, -half - 0.6f * w), v3(-1, 0, 0), 0.0f,
                         dmg_range(b, 0.4f, 1.3f));
    else if (lifts)
        rail =
            dmg_hinge(b, 0, "rail", v3(o->edge + w, o->thick + high, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 0.3f, 1.2f));
    float y = o->thick + high;
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(o->edge - 0.5f * w, y, -half - w), v3(o->edge + 0.5f * w, y + 0.4f * w, half + w));
    else
        dmg_rod(b, v3(o->edge, y + 0.3f * w, -half - w), v3(o->edge, y + 0.3f * w, half + w), 0.3f * w);
    uint32_t head = dmg_slide(b, rail, "cutting_head", v3(0, 0, -1), 0.0f, way);
    dmg_rest(b, head, 0.5f * way * (1.0f - at));
    float z = half - 1.2f * size;
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(o->edge, y + 0.5f * size, z), v3(1.8f * w, 1.1f * size, 2.0f * size), 0.2f * size);
    else
        dmg_box(b, v3(o->edge, y + 0.5f * size, z), v3(1.7f * w, size, 1.6f * size));
    if (dmg_chance(b, 0.5f)) {
        dmg_spin(b, head, "round_blade", v3(o->edge - 1.1f * w, y + 0.1f * size, z), v3(1, 0, 0));
        dmg_rod(b, v3(o->edge - 1.2f * w, y + 0.15f * size, z), v3(o->edge - w, y + 0.15f * size, z),
                fminf(high + 0.1f * size, 0.7f * size));
    } else {
        dmg_slide(b, head, "blade_key", v3(0, -1, 0), 0.0f, 0.15f * size);
        dmg_rod(b, v3(o->edge, y + size, z), v3(o->edge, y + 1.3f * size, z), 0.35f * fminf(size, 2.0f * w));
    }
    dmg_use(b, 0);
}

/* Draws what holds the paper: a bar that presses, a stop that slides, an arm that turns out. */
static void draw_guides(dmg_builder* b, const board* o) {
    float t = 0.015f * o->wide, y = o->thick, left = -0.5f * o->wide;
    if (dmg_chance(b, 0.6f)) { /* a stop that slides along the board */
        float way = o->edge - left - 0.1f * o->wide;
        uint32_t stop = dmg_slide(b, 0, "stop", v3(-1, 0, 0), 0.0f, 0.8f * way);
        dmg_rest(b, stop, way * dmg_range(b, 0.0f, 0.8f));
        float x = o->edge - 0.08f * o->wide;
        dmg_box_span(b, v3(x - 2 * t, y, -0.3f * o->deep), v3(x, y + 1.5f * t, 0.4f * o->deep));
        if (dmg_chance(b, 0.5f)) {
            dmg_screw(b, stop, "stop_screw", v3(x - t, y + t, 0.3f * o->deep), v3(0, 1, 0), 0.05f * t, 0.0f, 9.0f);
            dmg_rod(b, v3(x - t, y + t, 0.3f * o->deep), v3(x - t, y + 4 * t, 0.3f * o->deep), 1.6f * t);
        }
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.4f)) { /* a ruler along the far edge, fixed */
        dmg_box_span(b, v3(left, y, -0.5f * o->deep), v3(o->edge - t, y + t, -0.5f * o->deep + 3 * t));
    }
    if (dmg_chance(b, 0.35f)) { /* a leaf that swings out from the left edge to carry a long sheet */
        dmg_hinge(b, 0, "arm", v3(left + 2 * t, y, 0.5f * o->deep), v3(0, -1, 0), 0.0f, 1.57f);
        dmg_box_span(b, v3(left + t, 0.3f * y, 0.5f * o->deep),
                     v3(left + 0.6f * o->wide, 0.8f * y, 0.5f * o->deep + 2 * t));
        dmg_use(b, 0);
    }
}

void dmg_build_paper_cutter(dmg_builder* b) {
    board o = {.wide = dmg_scale_range(b, 0.2f, 0.6f)};
    o.deep = o.wide * dmg_range(b, 0.6f, 1.4f);
    o.thick = o.wide * dmg_range(b, 0.04f, 0.12f);
    bool swung = dmg_chance(b, 0.55f);
    o.edge = swung ? 0.5f * o.wide : o.wide * dmg_range(b, 0.15f, 0.42f);
    if (dmg_chance(b, 0.3f)) dmg_mirror(b, v3(1, 0, 0));
    float foot = dmg_chance(b, 0.5f) ? 0.3f * o.thick : 0.0f;
    if (dmg_chance(b, 0.4f))
        dmg_rounded_box(b, v3(0, 0.5f * (o.thick + foot), 0), v3(o.wide, o.thick - foot, o.deep),
                        0.2f * (o.thick - foot));
    else
        dmg_box_span(b, v3(-0.5f * o.wide, foot, -0.5f * o.deep), v3(0.5f * o.wide, o.thick, 0.5f * o.deep));
    for (int i = 0; i < 4 && foot > 0.0f; ++i) {
        float x = (i & 1 ? 0.4f : -0.4f) * o.wide, z = (i & 2 ? 0.4f : -0.4f) * o.deep;
        dmg_rod(b, v3(x, 0, z), v3(x, foot, z), 0.5f * o.thick);
    }
    draw_guides(b, &o);
    if (swung)
        draw_swung_knife(b, &o);
    else
        draw_rail_knife(b, &o);
    float tall = o.wide * dmg_range(b, 0.08f, 0.2f), x = o.edge - 0.012f * o.wide, way = dmg_range(b, 0.5f, 1.5f);
    if (!swung || !dmg_chance(b, 0.5f)) return;
    /* The finger guard beside the knife: a strip that tips up from its inner edge. */
    dmg_hinge(b, 0, "press_bar", v3(x - tall, o.thick + 0.006f * o.wide, 0), v3(0, 0, 1), 0.0f, 0.5f * way);
    dmg_box_span(b, v3(x - tall, o.thick, -0.46f * o.deep), v3(x, o.thick + 0.012f * o.wide, 0.46f * o.deep));
}

/* ---- a punch: one lever for all pins, a tray for the chips ---- */

typedef struct punch {
    float wide, deep, base; /* of the base: x, z, y of its top */
    float gap, block;       /* the paper's mouth, the height of the block over it */
    float line, pin;        /* depth and height of the lever's pin */
    int pins;
} punch;

/* Each pin in a block, with a heel in front of which the paper stops; blocks of some are set along the base. */
static void draw_pins(dmg_builder* b, const punch* p, bool slide, float z) {
    float under = p->base + p->gap, r = 0.03f * p->wide, play = p->wide * dmg_range(b, 0.02f, 0.048f);
    bool set = dmg_chance(b, 0.25f);
    if (set)
        dmg_box_span(b, v3(-0.44f * p->wide, p->base, z - 4.5f * r),
                     v3(0.44f * p->wide, under + 0.5f * p->block, z - 2.6f * r));
    for (int i = 0; i < p->pins; ++i) {
        float x = p->wide * 0.6f * ((float)i / (float)(p->pins - 1) - 0.5f);
        uint32_t block = 0;
        dmg_use(b, 0);
        if (set) block = dmg_slide(b, 0, "block", v3(1, 0, 0), -play, play);
        dmg_rounded_box(b, v3(x, under + 0.5f * p->block, z), v3(5 * r, p->block, 5 * r), 0.5f * r);
        dmg_box_span(b, v3(x - 2 * r, p->base, z - 2.5f * r), v3(x + 2 * r, under + 0.5f * p->gap, z - 1.2f * r));
        if (!slide) continue;
        dmg_slide(b, block, "pin", v3(0, -1, 0), 0.0f, 0.3f * p->block);
        dmg_rod(b, v3(x, under, z), v3(x, under + 1.5f * p->block, z), r);
    }
    dmg_use(b, 0);
}

/* Draws what the lever's pin runs in: posts at both sides, lugs near the middle, or cheeks that reach forward. */
static void draw_bearings(dmg_builder* b, const punch* p, float half, float t) {
    int kind = dmg_int(b, 0, 2);
    float rear = p->line - 2 * t, near = p->line + 2 * t, ahead = p->deep * dmg_range(b, 0.2f, 0.6f);
    const dmg_xy cheek[] = {{rear, 0.5f * p->base},
                            {near + ahead, 0.5f * p->base},
                            {near + ahead, p->base + 2 * t},
                            {near, p->pin + 1.5f * t},
                            {rear, p->pin + 1.5f * t}};
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_save(b);
        if (kind == 0) dmg_box_span(b, v3(x - t, 0.5f * p->base, rear), v3(x + t, p->pin + 1.5f * t, near));
        if (kind == 1)
            dmg_box_span(b, v3(0.4f * x - 2 * t, 0.5f * p->base, rear), v3(0.4f * x + 2 * t, p->pin + 0.3f * t, near));
        dmg_move(b, x, 0, 0);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* x of the outline runs along Z */
        if (kind == 2) dmg_extrude(b, cheek, 5, -t, t);
        dmg_restore(b);
    }
}

/* Half a shell over the pins, a flat handle, or a long lever with a grip: all on a pin at the rear. */
static void draw_press_lever(dmg_builder* b, const punch* p) {
    float press = dmg_range(b, 0.15f, 0.4f), t = 0.03f * p->wide, half = 0.46f * p->wide, near = 0.5f * p->deep;
    float reach = near - p->line, rise = reach * tanf(press);
    int kind = dmg_int(b, 0, 2);
    draw_bearings(b, p, half, t);
    dmg_hinge(b, 0, "lever", v3(0, p->pin, p->line), v3(1, 0, 0), 0.0f, 0.9f * press);
    dmg_rod(b, v3(-half + t, p->pin, p->line), v3(half - t, p->pin, p->line), 1.2f * t);
    float inner = half - 1.3f * t;
    dmg_vec from = v3(0, p->pin + t, p->line), end = v3(0, p->pin + rise, near);
    if (kind == 0) dmg_beam(b, from, end, 2 * inner, 1.5f * t);
    if (kind == 1) { /* a hood: a plate with cheeks */
        dmg_beam(b, from, end, 2 * inner, t);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * (inner - 0.5f * t), p->pin + 0.5f * t, p->line),
                     v3((float)s * (inner - 0.5f * t), end.y - 1.5f * t, near), t, 3 * t);
    }
    if (kind == 2) {
        dmg_beam(b, from, v3(0, p->pin + 0.4f * rise, p->line + 0.45f * reach), 2 * inner, 2 * t);
        end = v3_mad(end, v3_sub(end, from), dmg_range(b, 0.2f, 1.2f));
        dmg_beam(b, v3(0, p->pin + 0.4f * rise, p->line + 0.4f * reach), end, 5 * t, 2 * t);
        dmg_rod(b, v3_lerp(from, end, 0.6f), end, 2.5f * t);
    }
    dmg_use(b, 0);
}

/* Chips leave through a tray that is drawn out, a cap that is pulled off the end, or a bottom that swings open. */
static void draw_chips(dmg_builder* b, const punch* p, float foot) {
    float half = 0.47f * p->wide, z = 0.44f * p->deep, t = 0.1f * foot;
    switch (dmg_int(b, 0, 2)) {
    case 0:
        dmg_slide(b, 0, "tray", v3(1, 0, 0), 0.0f, p->wide * dmg_range(b, 0.3f, 0.9f));
        dmg_box_span(b, v3(-half, t, -z), v3(half, foot - t, z));
        dmg_box_span(b, v3(half, t, -0.5f * z), v3(half + 2 * foot, foot - t, 0.5f * z));
        break;
    case 1:
        dmg_hinge(b, 0, "bottom", v3(0, 0.5f * foot, -z), v3(1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.6f));
        dmg_box_span(b, v3(-half, 0, -z), v3(half, foot - t, z));
        break;
    default:
        dmg_slide(b, 0, "tray", v3(0, 0, 1), 0.0f, p->deep * dmg_range(b, 0.3f, 0.8f));
        dmg_box_span(b, v3(-half, t, -z), v3(half, foot - t, 1.1f * z));
        break;
    }
    dmg_use(b, 0);
}

/* Draws a ruler in the base that is drawn out at a side until its stop sits right for the paper. */
static void draw_paper_guide(dmg_builder* b, const punch* p) {
    float t = 0.2f * p->base, z = 0.35f * p->deep, way = p->wide * dmg_range(b, 0.3f, 0.8f);
    uint32_t ruler = dmg_slide(b, 0, "guide", v3(-1, 0, 0), 0.0f, way);
    dmg_rest(b, ruler, dmg_chance(b, 0.5f) ? 0.0f : way * dmg_range(b, 0.0f, 0.9f));
    dmg_box_span(b, v3(-0.52f * p->wide, p->base, z - 2 * t), v3(0.3f * p->wide, p->base + 0.5f * t, z));
    dmg_box_span(b, v3(-0.52f * p->wide - 2 * t, p->base - t, z - 3 * t),
                 v3(-0.52f * p->wide, p->base + 4 * t, z + 2 * t));
    dmg_use(b, 0);
}

void dmg_build_hole_punch(dmg_builder* b) {
    punch p = {.wide = dmg_scale_range(b, 0.08f, 0.3f)};
    p.pins = dmg_chance(b, 0.7f) ? 2 : dmg_int(b, 3, 4);
    p.deep = p.wide * dmg_range(b, 0.5f, 1.1f);
    p.gap = p.wide * dmg_range(b, 0.02f, 0.04f);
    p.block = p.wide * dmg_range(b, 0.1f, 0.22f);
    float foot = p.wide * dmg_range(b, 0.05f, 0.12f);
    bool chips = dmg_chance(b, 0.75f);
    p.base = foot + p.wide * dmg_range(b, 0.03f, 0.1f);
    p.line = -p.deep * dmg_range(b, 0.32f, 0.46f);
    p.pin = p.base + p.gap + p.block + p.wide * dmg_range(b, 0.035f, 0.08f);
    dmg_rounded_box(b, v3(0, 0.5f * (foot + p.base), 0), v3(p.wide, p.base - foot, p.deep), 0.15f * (p.base - foot));
    if (!chips) dmg_box_span(b, v3(-0.45f * p.wide, 0, -0.45f * p.deep), v3(0.45f * p.wide, foot, 0.45f * p.deep));
    float z = p.line + p.deep * dmg_range(b, 0.2f, 0.35f);
    draw_pins(b, &p, dmg_chance(b, 0.5f), z);
    draw_press_lever(b, &p);
    if (chips) draw_chips(b, &p, foot);
    if (dmg_chance(b, 0.5f)) draw_paper_guide(b, &p);
    if (dmg_chance(b, 0.3f)) { /* a latch that holds the lever down */
        float side = dmg_sign(b), t = 0.02f * p.wide, x = side * (0.5f * p.wide + t), at = -0.1f * p.deep;
        dmg_hinge(b, 0, "latch", v3(x, p.base, at), v3(1, 0, 0), -0.9f, 0.3f);
        dmg_box_span(b, v3(x - t, p.base - t, at - 2 * t), v3(x + t, p.base + p.block, at + 2 * t));
    }
}
