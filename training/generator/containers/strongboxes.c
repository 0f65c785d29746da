/* Draws doors before closed blocks: safes whose door is a sheet with dials, ovens whose door is a pane on the front. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct lock {
    float size; /* of the door's smaller side */
    bool moves; /* its dials are parts of their own */
    uint32_t door;
} lock;

/* Draws two to five boxes in a row or a column: lettering, a badge, a display. */
static void draw_badge(dmg_builder* b, float size) {
    int count = dmg_int(b, 1, 5);
    float w = size * dmg_range(b, 0.04f, 0.12f), h = size * dmg_range(b, 0.04f, 0.12f), t = 0.01f * size;
    bool upright = dmg_chance(b, 0.3f);
    for (int i = 0; i < count; ++i) {
        float at = 1.2f * (upright ? h : w) * ((float)i - 0.5f * (float)(count - 1));
        dmg_box(b, v3(upright ? 0 : at, upright ? at : 0, 0.5f * t), v3(w, h, t));
    }
}

/* Draws a hub with spokes, straight or ending in balls, with a rim sometimes; turned by hand. */
static void draw_spokes(dmg_builder* b, const lock* l) {
    float r = l->size * dmg_range(b, 0.08f, 0.3f), out = r * dmg_range(b, 0.15f, 0.7f),
          bar = r * dmg_range(b, 0.06f, 0.18f);
    int count = dmg_int(b, 2, 8);
    bool balls = dmg_chance(b, 0.3f), rim = dmg_chance(b, 0.25f);
    if (l->moves) dmg_spin(b, l->door, "wheel", v3(0, 0, 0), v3(0, 0, -1));
    dmg_cone(b, v3(0, 0, 0), v3(0, 0, 1.1f * out), 3 * bar, 2 * bar);
    for (int i = 0; i < count; ++i) {
        float angle = 2.0f * DMG_PI * ((float)i + 0.25f) / (float)count;
        dmg_vec end = {r * cosf(angle), r * sinf(angle), out};
        dmg_rod(b, v3(0, 0, out), end, bar);
        if (balls) dmg_ellipsoid(b, end, v3(2 * bar, 2 * bar, 2 * bar));
    }
    if (rim) dmg_torus(b, v3(0, 0, out), v3(0, 0, 1), r, bar);
    dmg_use(b, l->door);
}

static void draw_dial(dmg_builder* b, const lock* l) {
    float r = l->size * dmg_range(b, 0.05f, 0.15f), h = r * dmg_range(b, 0.3f, 1.2f);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.15f * r), 1.4f * r); /* its ring stays */
    int kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    if (l->moves) dmg_spin(b, l->door, "dial", v3(0, 0, 0), v3(0, 0, 1));
    dmg_knob_draw(b, kind, r, h);
    dmg_use(b, l->door);
}

static void draw_lever(dmg_builder* b, const lock* l, float way) {
    float length = l->size * dmg_range(b, 0.12f, 0.3f), bar = length * dmg_range(b, 0.06f, 0.14f), out = 3 * bar;
    if (l->moves) dmg_hinge(b, l->door, "lever", v3(0, 0, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 0.7f, 1.6f));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), 1.5f * bar);
    dmg_beam(b, v3(0, 0, out), v3(way * length, 0, out), 2 * bar, bar);
    dmg_use(b, l->door);
}

static void draw_keypad(dmg_builder* b, const lock* l) {
    float key = l->size * dmg_range(b, 0.03f, 0.06f), out = key * dmg_range(b, 0.2f, 1.2f);
    int columns = dmg_int(b, 2, 4), rows = dmg_int(b, 3, 5);
    dmg_box(b, v3(0, 0, 0.5f * out), v3(1.4f * key * (float)columns, 1.4f * key * (float)rows, out));
    dmg_move(b, 0, 0, out);
    dmg_buttons pad = {"key", columns, rows,       1.25f * key, 1.25f * key,
                       key,   key,     0.3f * key, 0.2f * key,  dmg_int(b, 0, 2)};
    if (l->moves) {
        dmg_buttons_draw(b, l->door, &pad);
        return;
    }
    for (int i = 0; i < columns * rows; ++i)
        dmg_box(b,
                v3(pad.pitch_x * ((float)(i % columns) - 0.5f * (float)(columns - 1)),
                   pad.pitch_y * ((float)(i / columns) - 0.5f * (float)(rows - 1)), 0.15f * key),
                v3(key, key, 0.3f * key));
}

/* Draws what a safe's door carries, mostly towards its free edge, which lies at `way` * X. */
static void draw_lockwork(dmg_builder* b, const lock* l, float width, float height, float way) {
    static const float weights[] = {3, 3, 1.5f, 2, 1.5f};
    int count = dmg_int(b, 1, 3);
    bool central = dmg_chance(b, 0.3f), column = dmg_chance(b, 0.7f);
    float x = central ? 0.0f : way * width * dmg_range(b, -0.05f, 0.25f);
    for (int i = 0; i < count; ++i) {
        float at = count == 1 ? dmg_range(b, -0.15f, 0.15f) : 0.6f * ((float)i / (float)(count - 1) - 0.5f);
        dmg_save(b);
        dmg_move(b, column ? x : at * width, column ? at * height : 0.0f, 0);
        int kind = dmg_weighted(b, weights, 5);
        if (kind == 0) draw_spokes(b, l);
        if (kind == 1) draw_dial(b, l);
        if (kind == 2) draw_lever(b, l, -way);
        if (kind == 3) draw_keypad(b, l);
        if (kind == 4) draw_badge(b, l->size);
        dmg_restore(b);
    }
}

/* Draws a door of a safe: a sheet, a plate, a rounded plate or a stepped one; front at z = 0. */
static void draw_safe_door(dmg_builder* b, float width, float height, float t) {
    int kind = dmg_int(b, 0, 3);
    dmg_vec centre = {0, 0, -0.5f * t}, size = {width, height, t};
    if (kind == 0) dmg_box_faces(b, v3(0, 0, -0.5f * t), size, DMG_FACE_FRONT);
    if (kind == 1) dmg_box(b, centre, size);
    if (kind == 2) dmg_rounded_plate(b, width, height, t, dmg_range(b, 0.03f, 0.25f) * fminf(width, height));
    if (kind == 3) {
        dmg_box(b, v3(0, 0, -0.75f * t), v3(width, height, 0.5f * t));
        dmg_box(b, v3(0, 0, -0.25f * t), v3(0.85f * width, 0.85f * height, 0.5f * t));
    }
}

/* Draws the block that a door of width x height closes, its front at z = 0: plain, or with a rim round the door. */
static void draw_block(dmg_builder* b, float width, float height, float depth, float rim, float border) {
    dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth));
    if (rim <= 0.0f) return;
    dmg_save(b);
    dmg_move(b, 0, 0, rim);
    dmg_frame_draw(b, width, height, rim, border);
    dmg_restore(b);
}

/* Draws one door before the block; the frame is at the middle of its place, z = 0 on the block. */
static void hang_safe_door(dmg_builder* b, float width, float height) {
    float small = fminf(width, height), t = small * dmg_scale_range(b, 0.008f, 0.09f), way = dmg_sign(b);
    dmg_leaf line = dmg_leaf_pick(b, small);
    float away = dmg_chance(b, 0.5f) ? 0.001f * small : small * dmg_range(b, 0.0f, 0.02f);
    float far = dmg_range(b, 1.4f, 2.6f);
    dmg_move(b, 0, 0, t + away);
    dmg_vec hinge = v3(-way * (0.5f * width - fminf(line.inset, 1.0f) * t), 0, -line.depth * t);
    uint32_t door = dmg_hinge(b, 0, "door", hinge, v3(0, -way, 0), 0.0f, far);
    draw_safe_door(b, width, height, t);
    lock l = {.size = small, .moves = dmg_chance(b, 0.5f), .door = door};
    draw_lockwork(b, &l, width, height, way);
    line.hinge.radius = fminf(line.hinge.radius, 0.5f * t);
    line.hinge.length = fminf(line.hinge.length, 0.2f * height);
    dmg_move(b, hinge.x, 0, hinge.z);
    if (way < 0.0f) dmg_mirror(b, v3(1, 0, 0));
    if (dmg_chance(b, 0.4f)) dmg_hinge_draw(b, &line.hinge, height, width, door, 0);
    dmg_use(b, 0);
}

void dmg_build_strongbox(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.25f, 1.0f), height = width * dmg_scale_range(b, 0.5f, 2.0f),
          depth = width * dmg_scale_range(b, 0.4f, 2.0f), small = fminf(width, height);
    float border = small * dmg_range(b, 0.01f, 0.16f),
          rim = dmg_chance(b, 0.35f) ? small * dmg_range(b, 0.02f, 0.15f) : 0.0f;
    float w = width - 2.1f * border, h = height - 2.1f * border, foot = dmg_chance(b, 0.3f) ? 0.05f * height : 0.0f;
    if (foot > 0.0f) dmg_feet_draw(b, dmg_int(b, 0, 3), width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    draw_block(b, width, height, depth, rim, border);
    int doors = h > 0.9f * w && dmg_chance(b, 0.2f) ? 2 : 1;
    float share = doors == 1 ? 1.0f : dmg_range(b, 0.3f, 0.7f);
    dmg_save(b);
    dmg_move(b, 0, -0.5f * (1.0f - share) * h, 0);
    hang_safe_door(b, w, share * h);
    dmg_restore(b);
    if (doors == 1) return;
    dmg_move(b, 0, 0.5f * share * h, 0);
    hang_safe_door(b, w, 0.96f * (1.0f - share) * h);
}

/* ---- an oven for the counter ---- */

/* Draws a door that is one sheet of the front, with a window's box behind it or before it. Front at z = 0. */
static void draw_pane_door(dmg_builder* b, float width, float height, float t) {
    int kind = dmg_int(b, 0, 3);
    float w = width * dmg_range(b, 0.5f, 0.85f), h = height * dmg_range(b, 0.5f, 0.85f),
          deep = t * dmg_range(b, 1.0f, 6.0f);
    if (kind == 3)
        dmg_box(b, v3(0, 0, -0.5f * t), v3(width, height, t));
    else
        dmg_box_faces(b, v3(0, 0, -0.5f * t), v3(width, height, t),
                      kind == 2 ? DMG_FACE_ALL & ~DMG_FACE_BACK : DMG_FACE_FRONT);
    if (kind == 0) dmg_box(b, v3(0, 0, -0.5f * deep - 0.01f * t), v3(w, h, deep));
    if (kind == 1) dmg_box(b, v3(0, 0, 0.1f * t), v3(w, h, 0.2f * t));
    if (kind > 1) dmg_frame_draw(b, w, h, -0.1f * t, 0.05f * w);
}

static void draw_pane_handle(dmg_builder* b, float width, float height, bool flap) {
    dmg_handle pull = dmg_handle_pick_bar(b, 0.6f * (flap ? width : height));
    if (dmg_chance(b, 0.3f)) pull.kind = DMG_HANDLE_NONE;
    pull.thickness = fminf(pull.thickness, 0.06f * height);
    pull.standoff = fminf(pull.standoff, 0.14f * height);
    dmg_save(b);
    dmg_move(b, flap ? 0.0f : 0.44f * width, flap ? 0.42f * height : 0.0f, 0);
    if (flap) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &pull, 0.95f * (flap ? width : height));
    dmg_restore(b);
}

/* A housing without a front: the door is its front as far as the panel of knobs goes. */
void dmg_build_counter_oven(dmg_builder* b) {
    float width = dmg_range(b, 0.35f, 0.65f), height = width * dmg_range(b, 0.45f, 0.75f),
          depth = width * dmg_range(b, 0.5f, 1.05f);
    float panel = width * dmg_range(b, 0.14f, 0.32f), t = width * dmg_scale_range(b, 0.006f, 0.07f);
    bool flap = dmg_chance(b, 0.25f), open_inside = dmg_chance(b, 0.7f), flush = dmg_chance(b, 0.5f);
    float foot = dmg_range(b, 0.0f, 0.03f) * width, fill = dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.85f, 1.0f);
    float w = width - panel, set = flush ? 0.0f : t, aside = dmg_range(b, 0.0f, 1.0f) * (1.0f - fill) * 0.5f * w;
    dmg_feet_draw(b, 3, width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    if (dmg_chance(b, 0.4f)) dmg_mirror(b, v3(1, 0, 0));
    int faces = open_inside ? DMG_FACE_ALL & ~DMG_FACE_FRONT : DMG_FACE_ALL;
    float back = open_inside || !flush ? 0.0f : t;
    dmg_box_faces(b, v3(0, 0, -0.5f * (depth + back)), v3(width, height, depth - back), faces);
    float z = back > 0.0f ? 0.0f : set;
    dmg_save(b);
    dmg_move(b, 0.5f * w, 0, z);
    dmg_box(b, v3(0, 0, -0.5f * t), v3(panel, height, t));
    if (dmg_chance(b, 0.8f)) dmg_controls_draw(b, 0, 0.8f * panel, 0.8f * height);
    dmg_restore(b);
    dmg_leaf line = dmg_leaf_pick(b, 0.5f * width);
    dmg_move(b, -0.5f * panel - aside, 0, z + (back > 0.0f || set > 0.0f ? 0.0f : 0.001f * width));
    float high = height * (dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.85f, 1.0f)), in = fminf(line.inset, 1.2f) * t;
    dmg_vec hinge = flap ? v3(0, -0.5f * high + in, -line.depth * t) : v3(-0.5f * fill * w + in, 0, -line.depth * t);
    dmg_hinge(b, 0, "door", hinge, flap ? v3(1, 0, 0) : v3(0, -1, 0), 0.0f, dmg_range(b, 1.4f, 1.9f));
    draw_pane_door(b, fill * w, high, t);
    draw_pane_handle(b, fill * w, high, flap);
    dmg_use(b, 0);
}

/* ---- a cooler ---- */

/* Draws a fat door, round at its edges or bowed, with a liner and bins that reach into the cavity. */
static void draw_fat_door(dmg_builder* b, float width, float height, float t, float wall) {
    int kind = dmg_int(b, 0, 3);
    dmg_vec centre = {0, 0, -0.5f * t}, size = {width, height, t};
    if (kind == 0) dmg_box(b, centre, size);
    if (kind == 1) dmg_rounded_box(b, centre, size, t * dmg_range(b, 0.15f, 0.49f));
    if (kind == 2) dmg_panel_draw(b, &(dmg_panel){.kind = DMG_PANEL_BOWED}, width, height, t);
    if (kind == 3) { /* rounded seen from above */
        dmg_save(b);
        dmg_move(b, 0, 0.5f * height, -0.5f * t);
        dmg_face_up(b);
        dmg_rounded_plate(b, width, t, height, dmg_range(b, 0.2f, 0.49f) * t);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.4f)) return;
    float deep = width * dmg_range(b, 0.05f, 0.3f),
          margin = wall + 0.06f * width + 0.5f * (deep + t) * (deep + t) / width;
    float inner = width - 2 * margin, tall = height - 2 * (wall + 0.04f * height);
    if (inner < 0.3f * width) return;
    dmg_box(b, v3(0, 0, -t - 0.05f * deep), v3(inner, tall, 0.1f * deep));
    int bins = dmg_int(b, 0, 4);
    for (int i = 0; i < bins; ++i) {
        float h = tall / (float)bins, y = h * ((float)i + 0.3f) - 0.5f * tall;
        dmg_box_faces(b, v3(0, y, -t - 0.5f * deep), v3(0.96f * inner, 0.45f * h, deep), DMG_FACE_ALL & ~DMG_FACE_TOP);
    }
}

static void hang_fat_door(dmg_builder* b, float width, float height, float t, float wall, bool left) {
    dmg_leaf line = dmg_leaf_pick(b, width);
    if (dmg_chance(b, 0.3f)) line.inset = line.depth = 0.5f;
    line.depth = fmaxf(line.depth, 0.3f); /* about its front edge it would swing clear of the housing */
    float in = fmaxf(fminf(line.inset, 1.3f) * t, -0.02f * width),
          gap = dmg_chance(b, 0.5f) ? 0.0f : t * dmg_range(b, 0.02f, 0.3f);
    dmg_save(b);
    dmg_move(b, 0, 0, t + gap);
    if (!left) dmg_mirror(b, v3(1, 0, 0));
    dmg_hinge(b, 0, "door", v3(in - 0.5f * width, 0, -line.depth * t), v3(0, -1, 0), 0.0f, dmg_range(b, 1.4f, 2.3f));
    draw_fat_door(b, width, height, t, wall);
    dmg_handle pull = dmg_handle_pick_bar(b, dmg_range(b, 0.2f, 0.7f) * height);
    pull.thickness = fminf(pull.thickness, 0.08f * width);
    pull.standoff = fminf(pull.standoff, 0.12f * width);
    float edge = fmaxf(0.5f * pull.thickness, dmg_range(b, 0.0f, 0.08f) * width);
    dmg_move(b, 0.5f * width - edge, dmg_range(b, -0.25f, 0.25f) * height, 0);
    dmg_handle_draw(b, &pull, 0.5f * height);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_cooler(dmg_builder* b) {
    float width = dmg_range(b, 0.4f, 0.95f), height = width * dmg_scale_range(b, 0.7f, 2.8f),
          depth = width * dmg_range(b, 0.6f, 1.2f), wall = width * dmg_range(b, 0.02f, 0.08f),
          t = width * dmg_scale_range(b, 0.05f, 0.25f);
    float foot = dmg_chance(b, 0.5f) ? height * dmg_range(b, 0.01f, 0.08f) : 0.0f,
          head = dmg_chance(b, 0.3f) ? dmg_range(b, 0.02f, 0.1f) * height : 0.0f;
    bool left = dmg_chance(b, 0.5f), twin = width > 0.7f && dmg_chance(b, 0.3f);
    int rows = height > 1.3f * width && dmg_chance(b, 0.5f) ? 2 : 1;
    float share = rows == 1 ? 1.0f : dmg_range(b, 0.25f, 0.75f), front = height - head;
    if (foot > 0.0f) dmg_feet_draw(b, dmg_int(b, 0, 3), width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    dmg_case_kind shell = dmg_case_pick(b);
    if (shell == DMG_CASE_SOLID) shell = DMG_CASE_DOUBLE;
    dmg_case_draw(b, shell, width, height, depth, wall);
    int shelves = dmg_int(b, 0, 4);
    for (int i = 1; i <= shelves; ++i)
        dmg_box(b, v3(0, height * ((float)i / (float)(shelves + 1) - 0.5f), -0.65f * depth),
                v3(width - 2 * wall, 0.2f * wall, 0.5f * depth));
    if (head > 0.0f) dmg_box(b, v3(0, 0.5f * (height - head), 0.5f * t), v3(width, head, t));
    float bottom = -0.5f * height;
    for (int i = 0; i < rows; ++i) {
        float h = front * (i == 0 ? share : 1.0f - share), w = width * (twin ? 0.5f : 1.0f);
        for (int k = 0; k < (twin ? 2 : 1); ++k) {
            dmg_save(b);
            dmg_move(b, twin ? w * ((float)k - 0.5f) : 0.0f, bottom + 0.5f * h, 0);
            hang_fat_door(b, 0.985f * w, 0.985f * h, t, wall, twin ? k == 0 : left);
            dmg_restore(b);
        }
        bottom += h;
    }
}
