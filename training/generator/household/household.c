/* Draws household things: lamps, kettles, latches, folding screens, whole kitchen counters, ladders, swings, vices. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- desk lamp ---- */

void dmg_build_desk_lamp(dmg_builder* b) {
    float size = dmg_range(b, 0.2f, 0.7f), thin = size * dmg_range(b, 0.015f, 0.04f),
          base = size * dmg_range(b, 0.18f, 0.35f), lean = dmg_range(b, -0.4f, 0.3f);
    int arms = dmg_int(b, 1, 3), twin = dmg_int(b, 0, 1), foot = dmg_int(b, 0, 2);
    if (foot == 0) dmg_rod(b, v3(0, 0, 0), v3(0, 0.08f * size, 0), base);
    if (foot == 1) dmg_box(b, v3(0, 0.04f * size, 0), v3(1.6f * base, 0.08f * size, 1.6f * base));
    if (foot == 2) dmg_cone(b, v3(0, 0, 0), v3(0, 0.12f * size, 0), base, 0.2f * base);
    dmg_vec at = {0, 0.1f * size, 0};
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.5f)) {
        carrier = dmg_spin(b, 0, "post", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.05f * size, 0), v3(0, 0.14f * size, 0), 2 * thin);
    }
    for (int i = 0; i < arms; ++i) {
        float length = size * dmg_range(b, 0.4f, 0.7f) / (0.5f + 0.5f * (float)arms), swing = dmg_range(b, 0.5f, 1.0f);
        dmg_vec to = v3_add(at, v3(0, length * cosf(lean), length * sinf(lean)));
        carrier = dmg_hinge(b, carrier, "arm", at, v3(1, 0, 0), -swing, swing);
        dmg_rod(b, v3_add(at, v3(-2.5f * thin, 0, 0)), v3_add(at, v3(2.5f * thin, 0, 0)), 1.6f * thin);
        if (twin == 0) dmg_rod(b, at, to, thin);
        for (int s = -1; s <= 1 && twin; s += 2)
            dmg_rod(b, v3_add(at, v3((float)s * 1.6f * thin, 0, 0)), v3_add(to, v3((float)s * 1.6f * thin, 0, 0)),
                    0.6f * thin);
        at = to;
        lean += dmg_range(b, 0.3f, 1.3f);
    }
    float shade = size * dmg_range(b, 0.08f, 0.2f), look = lean + dmg_range(b, 0.2f, 0.8f);
    dmg_vec way = {0, cosf(look), sinf(look)};
    dmg_hinge(b, carrier, "head", at, v3(1, 0, 0), -0.9f, 0.7f);
    int kind = dmg_int(b, 0, 2);
    dmg_rod(b, v3_add(at, v3(-2 * thin, 0, 0)), v3_add(at, v3(2 * thin, 0, 0)), 1.4f * thin);
    if (kind == 0) dmg_cone(b, at, v3_mad(at, way, 1.4f * shade), 0.35f * shade, shade);
    if (kind == 1) dmg_beam(b, at, v3_mad(at, way, 3 * shade), 0.8f * shade, 0.25f * shade);
    if (kind == 2) dmg_rod(b, at, v3_mad(at, way, 1.6f * shade), 0.6f * shade);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.3f)) {
        dmg_move(b, 0, 0.1f * size, 0.6f * base);
        dmg_face_up(b);
        dmg_buttons one = {"switch",        1, 1, 0, 0, 0.2f * base, 0.2f * base, 0.05f * base, 0.03f * base,
                           dmg_int(b, 0, 3)};
        dmg_buttons_draw(b, 0, &one);
    }
}

/* ---- kettle ---- */

void dmg_build_kettle(dmg_builder* b) {
    float radius = dmg_range(b, 0.06f, 0.12f), height = radius * dmg_range(b, 1.2f, 2.8f),
          mouth = radius * dmg_range(b, 0.45f, 0.8f), lid = radius * dmg_range(b, 0.1f, 0.4f);
    float waist = radius * dmg_range(b, 0.75f, 1.0f);
    const dmg_xy profile[] = {{0, 0},          {0.9f * radius, 0}, {radius, 0.1f * height}, {waist, 0.6f * height},
                              {mouth, height}, {0, height}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, dmg_chance(b, 0.5f) ? 6 : 5);
    dmg_cone(b, v3(0, 0.5f * height, 0.8f * radius), v3(0, 0.95f * height, 1.5f * radius), 0.25f * radius,
             0.12f * radius);
    int handle = dmg_int(b, 0, 2), opens = dmg_int(b, 0, 2);
    if (handle == 0) {
        const dmg_vec loop[] = {{0, 0.85f * height, -0.7f * radius},
                                {0, 0.95f * height, -1.5f * radius},
                                {0, 0.3f * height, -1.5f * radius},
                                {0, 0.2f * height, -0.9f * radius}};
        dmg_sweep(b, loop, 4, 0.08f * radius, 0.13f * radius, false);
    } else { /* over the top; some fold */
        float high = height + radius;
        const dmg_vec bail[] = {{-0.85f * radius, 0.8f * height, 0}, {-0.8f * radius, 0.8f * high, 0},
                                {-0.4f * radius, high, 0},           {0.4f * radius, high, 0},
                                {0.8f * radius, 0.8f * high, 0},     {0.85f * radius, 0.8f * height, 0}};
        if (handle == 2) dmg_hinge(b, 0, "handle", bail[0], v3(1, 0, 0), -1.1f, 1.1f);
        dmg_sweep(b, bail, 6, 0.06f * radius, 0.08f * radius, false);
        dmg_use(b, 0);
    }
    if (opens == 0) dmg_hinge(b, 0, "lid", v3(0, height, -mouth), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.6f));
    if (opens == 1) dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, radius);
    if (opens == 2) dmg_spin(b, 0, "lid", v3(0, 0, 0), v3(0, 1, 0));
    if (dmg_chance(b, 0.5f))
        dmg_dome(b, v3(0, height, 0), v3(mouth, lid, mouth));
    else
        dmg_rod(b, v3(0, height, 0), v3(0, height + 0.3f * lid, 0), mouth);
    dmg_ellipsoid(b, v3(0, height + lid, 0), v3(0.15f * radius, 0.12f * radius, 0.15f * radius));
    dmg_use(b, 0);
    if (handle == 0 && dmg_chance(b, 0.5f)) { /* what one presses to boil */
        dmg_vec pin = {0, 0.22f * height, -1.0f * radius};
        dmg_hinge(b, 0, "switch", pin, v3(1, 0, 0), 0.0f, 0.4f);
        dmg_beam(b, pin, v3_add(pin, v3(0, -0.05f * height, -0.4f * radius)), 0.25f * radius, 0.06f * radius);
        dmg_use(b, 0);
    }
}

/* ---- latch ---- */

/* On a door or a board: bolts that slide, bars that turn, thumb turns, hasps. */
void dmg_build_latch(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.03f, 0.3f), t = size * dmg_range(b, 0.05f, 0.15f),
          board = size * dmg_range(b, 1.2f, 5.0f), depth = size * dmg_range(b, 0.1f, 0.6f),
          over = dmg_range(b, -0.4f, 0.4f);
    dmg_move(b, 0, 0.6f * board, 0);
    if (dmg_chance(b, 0.3f)) dmg_case_draw(b, dmg_case_pick(b), board, board, board, 0.05f * board);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0.55f * board, 0, -0.5f * depth), v3(0.1f * board, 1.1f * board, 1.2f * depth));
    dmg_box(b, v3(0, 0, -0.5f * depth), v3(board, board, depth));
    dmg_move(b, 0.5f * board - 0.6f * size, over * board, 0);
    int kind = dmg_int(b, 0, 4);
    if (kind == 0) { /* a bolt in two loops */
        float travel = size * dmg_range(b, 0.3f, 0.6f);
        dmg_box(b, v3(0, 0, 0), v3(1.2f * size, 0.5f * size, 0.4f * t));
        for (int s = -1; s <= 1; s += 2)
            dmg_torus(b, v3((float)s * 0.4f * size, 0, t), v3(1, 0, 0), 1.1f * t, 0.3f * t);
        dmg_slide(b, 0, "bolt", v3(dmg_sign(b), 0, 0), 0.0f, travel);
        dmg_rod(b, v3(-0.6f * size, 0, t), v3(0.6f * size, 0, t), 0.7f * t);
        dmg_rod(b, v3(0, 0, t), v3(0, 0.25f * size, 1.5f * t), 0.4f * t);
    }
    if (kind == 1) { /* a bar about a screw */
        float out = dmg_range(b, 0.3f, 0.9f), way = dmg_sign(b);
        dmg_hinge(b, 0, "bar", v3(0, 0, 0), v3(0, 0, way), 0.0f, dmg_range(b, 1.2f, 3.0f));
        dmg_box(b, v3((0.5f - out) * size * 0.5f, 0, 0.6f * t), v3(size, 2.5f * t, t));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 1.5f * t), 0.9f * t);
    }
    if (kind == 2) { /* a thumb turn or a key */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.5f * t), 0.3f * size);
        if (dmg_chance(b, 0.4f))
            dmg_spin(b, 0, "key", v3(0, 0, 0), v3(0, 0, 1));
        else
            dmg_hinge(b, 0, "turn", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), 0.0f, 1.57f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 2 * t), 0.12f * size);
        dmg_rounded_box(b, v3(0, 0, 3 * t), v3(0.12f * size, 0.5f * size, 3 * t), 0.05f * size);
    }
    if (kind == 3) { /* a hasp */
        float reach = dmg_range(b, 0.6f, 1.0f);
        dmg_box(b, v3(-0.3f * size, 0, 0.2f * t), v3(0.4f * size, 0.4f * size, 0.4f * t));
        dmg_hinge(b, 0, "hasp", v3(-0.1f * size, 0, 0.4f * t), v3(0, -1, 0), 0.0f, dmg_range(b, 1.5f, 3.0f));
        dmg_box(b, v3(0.5f * reach * size - 0.1f * size, 0, 0.4f * t), v3(reach * size, 0.3f * size, 0.3f * t));
        dmg_rod(b, v3(-0.1f * size, -0.2f * size, 0.4f * t), v3(-0.1f * size, 0.2f * size, 0.4f * t), 0.4f * t);
    }
    if (kind == 4) { /* a hook and its eye */
        enum { POINTS = 5 };
        const dmg_vec hook[POINTS] = {{0, 0, t},
                                      {0.3f * size, -0.05f * size, t},
                                      {0.8f * size, 0, t},
                                      {0.9f * size, -0.05f * size, t},
                                      {0.85f * size, -0.15f * size, t}};
        dmg_torus(b, v3(0, 0, t), v3(0, 1, 0), t, 0.3f * t);
        dmg_hinge(b, 0, "hook", v3(0, 0, t), v3(0, 0, 1), 0.0f, 1.6f);
        dmg_sweep(b, hook, POINTS, 0.5f * t, 0.5f * t, false);
    }
    dmg_use(b, 0);
}

/* ---- folding screen ---- */

/* Panels one after another: screens, solar wings, folding doors, maps. */
void dmg_build_folding_panel(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.1f, 1.2f), height = width * dmg_scale_range(b, 0.4f, 4.0f),
          t = width * dmg_range(b, 0.01f, 0.08f), angle = dmg_range(b, 0.0f, 1.2f);
    int panels = dmg_int(b, 2, 6), start = dmg_int(b, 0, 2);
    dmg_panel panel = dmg_panel_pick(b);
    dmg_hinge_style hinge = dmg_hinge_pick(b, 0.4f * t);
    bool zigzag = dmg_chance(b, 0.8f), flat = dmg_chance(b, 0.3f), stacked = zigzag && dmg_chance(b, 0.3f);
    if (stacked) angle = dmg_range(b, 2.95f, 3.1f); /* folded up */
    dmg_move(b, 0, 0.5f * height, 0);
    if (flat) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    uint32_t carrier = 0;
    float side = 1.0f;
    if (start == 0) { /* what they are hung on */
        float post = width * dmg_range(b, 0.2f, 1.0f), deep = width * dmg_range(b, 0.1f, 1.0f);
        dmg_box(b, v3(-0.5f * post, 0, -0.5f * deep), v3(post, height, deep));
    } else {
        dmg_save(b);
        dmg_move(b, -0.5f * width, 0, 0);
        dmg_panel_draw(b, &panel, width, height, t);
        dmg_restore(b);
    }
    for (int i = 0; i < panels - (start != 0); ++i) {
        /* Folding alternates, so the line lies on the back and on the front in turn. */
        float z = side > 0 ? -t : 0.0f;
        uint32_t before = carrier;
        carrier = dmg_hinge(b, before, "panel", v3(0, 0, z), v3(0, side, 0), 0.0f, 3.1f);
        dmg_rest(b, carrier, i == 0 && angle < 2.0f ? 0.5f * angle : angle);
        dmg_save(b);
        dmg_move(b, 0.5f * width, 0, 0);
        dmg_panel_draw(b, &panel, 0.995f * width, height, t);
        dmg_restore(b);
        dmg_save(b);
        dmg_move(b, 0, 0, z);
        dmg_hinge_draw(b, &hinge, height, width, carrier, before);
        dmg_restore(b);
        dmg_move(b, width, 0, 0);
        if (zigzag) side = -side;
    }
    dmg_use(b, 0);
}

/* ---- kitchen counter ---- */

/* Draws one unit of a counter: doors, drawers, an oven, a dishwasher, a sink's flap or nothing. */
static void draw_unit(dmg_builder* b, float width, float height, float depth, float t, const dmg_leaf* style,
                      const dmg_drawer* box) {
    static const float weights[] = {3, 3, 1, 1, 1, 0.7f};
    int kind = dmg_weighted(b, weights, 6), rows = kind == 1 ? dmg_int(b, 1, 4) : 1;
    float share = dmg_range(b, 0.2f, 0.35f), gap = 0.006f;
    dmg_leaf leaf = *style;
    leaf.width = width - gap;
    leaf.height = height - gap;
    dmg_drawer drawer = *box;
    drawer.width = width - gap;
    drawer.depth = 0.9f * depth;
    drawer.travel = 0.8f * depth;
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    if (kind == 0 || kind == 4) { /* a drawer above a door */
        float drawers = kind == 4 ? share * height : 0.0f;
        leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        leaf.height -= drawers;
        dmg_save(b);
        dmg_move(b, 0, -0.5f * drawers, 0);
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
        drawer.height = drawers - gap;
        dmg_move(b, 0, 0.5f * (height - drawers), 0);
        if (kind == 4) dmg_drawer_draw(b, 0, "drawer", &drawer);
    }
    for (int i = 0; i < rows && kind == 1; ++i) {
        drawer.height = height / (float)rows - gap;
        dmg_save(b);
        dmg_move(b, 0, height * (((float)i + 0.5f) / (float)rows - 0.5f), 0);
        dmg_drawer_draw(b, 0, "drawer", &drawer);
        dmg_restore(b);
    }
    if (kind == 2 || kind == 3) { /* a machine: its door falls forward, its knobs above */
        float panel = 0.14f * height;
        dmg_leaf door = dmg_leaf_pick_appliance(b, width - gap, height - panel, t);
        door.side = DMG_SIDE_BOTTOM;
        door.swing = 1.55f;
        if (dmg_chance(b, 0.4f)) { /* the door of a machine that is let in reaches below its pivot */
            door.inset = dmg_range(b, 0.3f, 2.0f);
            door.depth = dmg_range(b, 0.3f, 1.0f);
        }
        dmg_use(b, 0);
        dmg_box(b, v3(0, 0.5f * (height - panel), -0.5f * t), v3(width - gap, panel, t));
        dmg_save(b);
        dmg_move(b, 0, 0.5f * (height - panel), 0);
        if (kind == 2) dmg_knobs_draw(b, 0, dmg_int(b, 2, 6), 0.13f * width, 0, 0.3f * panel);
        dmg_restore(b);
        dmg_move(b, 0, -0.5f * panel, 0);
        dmg_leaf_draw(b, 0, "appliance_door", &door);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_kitchen_counter(dmg_builder* b) {
    int units = dmg_int(b, 2, 5);
    float height = dmg_range(b, 0.6f, 0.85f), depth = dmg_range(b, 0.5f, 0.65f), t = 0.02f, widths[5], total = 0.0f,
          plinth = 0.1f;
    dmg_leaf leaf = dmg_leaf_pick(b, 0.15f);
    dmg_drawer box = dmg_drawer_pick(b, 0.15f);
    leaf.thickness = box.thickness = t;
    if (dmg_chance(b, 0.3f)) leaf.inset = leaf.depth = 0.0f;
    if (dmg_chance(b, 0.8f)) {
        box.handle = leaf.handle;
        box.panel = leaf.panel;
    }
    for (int i = 0; i < units; ++i) {
        widths[i] = dmg_range(b, 0.35f, 0.8f);
        total += widths[i];
    }
    dmg_case_kind shell = dmg_case_pick(b);
    dmg_box(b, v3(0, 0.5f * plinth, -0.05f), v3(total, plinth, depth));
    dmg_box(b, v3(0, plinth + height + 0.02f, 0.01f), v3(total + 0.02f, 0.04f, depth + 0.06f));
    dmg_move(b, -0.5f * total, plinth + 0.5f * height, 0.5f * depth);
    for (int i = 0; i < units; ++i) {
        dmg_move(b, 0.5f * widths[i], 0, 0);
        dmg_case_draw(b, shell, widths[i], height, depth, 0.018f);
        draw_unit(b, widths[i], height, depth, t, &leaf, &box);
        dmg_move(b, 0.5f * widths[i], 0, 0);
    }
    if (b->part_count == 0) {
        dmg_move(b, -0.5f * widths[units - 1], 0, t);
        leaf.width = widths[units - 1];
        leaf.height = height;
        dmg_leaf_draw(b, 0, "door", &leaf);
    }
    dmg_use(b, 0);
}

/* ---- ladder and trestle ---- */

void dmg_build_step_ladder(dmg_builder* b) {
    float height = dmg_range(b, 0.5f, 2.5f), width = height * dmg_range(b, 0.2f, 0.6f),
          rail = height * dmg_range(b, 0.015f, 0.03f), lean = dmg_range(b, 0.1f, 0.35f);
    int steps = dmg_int(b, 1, 7), hangs = dmg_int(b, 0, 1);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.5f * width, 0, height * tanf(lean)), v3((float)s * 0.45f * width, height, 0), rail,
                 2.5f * rail);
    for (int i = 1; i <= steps; ++i) {
        float y = height * (float)i / (float)(steps + 1);
        dmg_box(b, v3(0, y, (height - y) * tanf(lean)), v3(0.95f * width, 0.6f * rail, 5 * rail));
    }
    if (dmg_chance(b, 0.7f)) dmg_box(b, v3(0, height, 0), v3(width, 1.5f * rail, 7 * rail));
    dmg_vec pin = {0, height - (hangs ? 0.1f * height : 0), -2 * rail};
    dmg_hinge(b, 0, "rear_legs", pin, v3(-1, 0, 0), -0.5f * lean, 2 * lean);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.42f * width, pin.y, pin.z), v3((float)s * 0.5f * width, 0, -height * tanf(lean)),
                 rail, 1.6f * rail);
    for (int i = dmg_int(b, 1, 3); i > 0; --i) {
        float y = height * 0.2f * (float)i;
        dmg_box(b, v3(0, y, -(height - y) * tanf(lean)), v3(0.9f * width, rail, rail));
    }
    dmg_use(b, 0);
}

/* ---- swing and seesaw ---- */

void dmg_build_swing(dmg_builder* b) {
    float height = dmg_scale_range(b, 0.3f, 3.0f), width = height * dmg_range(b, 0.3f, 0.8f),
          bar = height * dmg_range(b, 0.01f, 0.04f), swing = dmg_range(b, 0.4f, 1.0f);
    int kind = dmg_int(b, 0, 3); /* a swing, a seesaw, a sign, a bell */
    if (kind == 1) {
        float length = height * dmg_range(b, 1.5f, 3.0f), y = height * 0.4f;
        dmg_cone(b, v3(0, 0, 0), v3(0, y, 0), 0.3f * height, 0.05f * height);
        dmg_rod(b, v3(-0.2f * height, y, 0), v3(0.2f * height, y, 0), bar);
        dmg_hinge(b, 0, "board", v3(0, y, 0), v3(1, 0, 0), -0.3f, 0.3f);
        dmg_box(b, v3(0, y + bar, 0), v3(0.25f * height, 1.5f * bar, length));
        dmg_use(b, 0);
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.6f * width;
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(x, 0, 0), v3(x, height, 0), bar);
        else
            for (int k = -1; k <= 1; k += 2) dmg_rod(b, v3(x, 0, (float)k * 0.3f * height), v3(x, height, 0), bar);
    }
    dmg_rod(b, v3(-0.7f * width, height, 0), v3(0.7f * width, height, 0), bar);
    float drop = height * dmg_range(b, 0.2f, 0.8f), half = 0.4f * width;
    dmg_hinge(b, 0, kind == 0 ? "seat" : "hanging", v3(0, height, 0), v3(1, 0, 0), -swing, swing);
    float y = height - drop;
    for (int s = -1; s <= 1 && kind != 3; s += 2)
        dmg_rod(b, v3((float)s * half, y, 0), v3((float)s * half, height, 0), 0.4f * bar);
    if (kind == 0) dmg_box(b, v3(0, y, 0), v3(2.2f * half, bar, 0.4f * width));
    if (kind == 2) dmg_box(b, v3(0, height - 0.6f * drop, 0), v3(2.2f * half, 0.8f * drop, bar));
    if (kind == 3) {
        const dmg_xy bell[] = {{0, 0},
                               {0.3f * half, -0.1f * drop},
                               {0.5f * half, -0.6f * drop},
                               {0.8f * half, -0.9f * drop},
                               {0.7f * half, -0.9f * drop},
                               {0.4f * half, -0.5f * drop},
                               {0, -0.15f * drop}};
        dmg_lathe(b, v3(0, height - bar, 0), v3(0, 1, 0), bell, 7);
        dmg_rod(b, v3(0, height - 0.2f * drop, 0), v3(0, height + bar, 0), bar);
    }
    dmg_use(b, 0);
}

/* ---- vice ---- */

/* Jaws that close on a screw: vices, clamps, presses. */
void dmg_build_vise(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.05f, 0.5f), width = size * dmg_range(b, 0.4f, 1.0f),
          jaw = size * dmg_range(b, 0.15f, 0.35f), opened = size * dmg_range(b, 0.2f, 0.8f),
          screw = size * dmg_range(b, 0.04f, 0.1f);
    bool upright = dmg_chance(b, 0.3f);
    dmg_move(b, 0, size, 0);
    if (upright) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_box(b, v3(0, 0, -0.5f * jaw), v3(width, size, jaw)); /* the fixed jaw */
    dmg_box(b, v3(0, -0.55f * size, 0.5f * opened + 0.5f * jaw), v3(0.6f * width, 0.25f * size, opened + 4 * jaw));
    if (!upright && dmg_chance(b, 0.6f)) dmg_box(b, v3(0, -0.8f * size, 0), v3(1.3f * width, 0.3f * size, size));
    uint32_t slide = dmg_slide(b, 0, "jaw", v3(0, 0, -1), 0.0f, opened);
    dmg_box(b, v3(0, 0.05f * size, opened + 0.5f * jaw), v3(width, 0.9f * size, jaw));
    dmg_use(b, 0);
    float end = opened + 3 * jaw, z = opened + jaw;
    int carried = dmg_int(b, 0, 1);
    dmg_spin(b, carried ? slide : 0, "screw", v3(0, -0.2f * size, z), v3(0, 0, 1));
    dmg_rod(b, v3(0, -0.2f * size, z), v3(0, -0.2f * size, end), screw);
    dmg_rod(b, v3(0, -0.2f * size, end - screw), v3(0, -0.2f * size, end + 2 * screw), 1.6f * screw);
    float bar = size * dmg_range(b, 0.3f, 0.6f), turn = dmg_range(b, 0, 3.1f);
    dmg_vec arm = {bar * cosf(turn), bar * sinf(turn), 0}, hub = {0, -0.2f * size, end};
    dmg_rod(b, v3_sub(hub, arm), v3_add(hub, arm), 0.5f * screw);
    dmg_use(b, 0);
}
