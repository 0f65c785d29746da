/* Draws tables, wardrobes and chairs. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- table ---- */

static void draw_table_top(dmg_builder* b, float width, float depth, float thick, bool round) {
    if (round) {
        dmg_save(b);
        dmg_face_up(b);
        dmg_rounded_plate(b, width, depth, thick, 0.5f * fminf(width, depth));
        dmg_restore(b);
        return;
    }
    dmg_box(b, v3(0, -0.5f * thick, 0), v3(width, thick, depth));
}

static void draw_table_legs(dmg_builder* b, float width, float depth, float height, float leg) {
    int kind = dmg_int(b, 0, 3);
    float x = 0.5f * width - leg, z = 0.5f * depth - leg, slant = kind == 1 ? dmg_range(b, -1.5f, 1.5f) * leg : 0.0f;
    if (kind == 3) { /* panels at the ends */
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * x, 0.5f * height, 0), v3(0.6f * leg, height, 0.9f * depth));
        return;
    }
    for (int i = 0; i < 4; ++i) {
        float sx = i & 1 ? 1.0f : -1.0f, sz = i & 2 ? 1.0f : -1.0f;
        dmg_vec foot = {sx * (x + slant), 0, sz * (z + slant)}, top = {sx * x, height, sz * z};
        if (kind == 2)
            dmg_cone(b, foot, top, 0.3f * leg, 0.5f * leg);
        else
            dmg_beam(b, foot, top, leg, leg);
    }
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, 0.25f * height, 0), v3(2 * x, 0.4f * leg, 2 * z)); /* a shelf */
}

/* Drawers side by side in the apron below the top, y = 0, their fronts at z = 0. */
static void draw_apron_drawers(dmg_builder* b, float width, float depth, float height, int count, int rows) {
    dmg_drawer drawer = dmg_drawer_pick(b, 0.12f);
    float w = width / (float)count, h = height / (float)rows, rail = dmg_range(b, 0.0f, 0.12f);
    drawer.width = w * (1.0f - rail);
    drawer.height = h * 0.92f;
    drawer.thickness = fminf(drawer.thickness, 0.2f * h);
    drawer.handle.thickness = fminf(drawer.handle.thickness, 0.12f * h);
    drawer.handle.standoff = fminf(drawer.handle.standoff, 0.5f * h);
    drawer.depth = depth * dmg_range(b, 0.6f, 0.95f);
    drawer.travel = 0.85f * drawer.depth;
    for (int i = 0; i < count * rows; ++i) {
        dmg_save(b);
        dmg_move(b, w * ((float)(i % count) + 0.5f) - 0.5f * width, -h * ((float)(i / count) + 0.5f), 0);
        dmg_drawer_draw(b, 0, "drawer", &drawer);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a case on the floor with drawers over each other, front at z = 0. */
static void draw_pedestal(dmg_builder* b, float width, float depth, float height) {
    int rows = dmg_int(b, 1, 4);
    bool door = dmg_chance(b, 0.25f), left = dmg_chance(b, 0.5f);
    dmg_save(b);
    dmg_move(b, 0, -0.5f * height, 0);
    dmg_case_draw(b, dmg_case_pick(b), width, height, depth, 0.018f);
    dmg_restore(b);
    if (!door) {
        dmg_move(b, 0, 0, 0.01f);
        draw_apron_drawers(b, width, depth, height, 1, rows);
        return;
    }
    dmg_leaf leaf = dmg_leaf_pick(b, 0.12f);
    leaf.width = width;
    leaf.height = height;
    leaf.side = left ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
    dmg_move(b, 0, -0.5f * height, leaf.thickness);
    dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_use(b, 0);
}

void dmg_build_table(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.4f, 2.0f), depth = width * dmg_range(b, 0.4f, 1.0f),
          height = dmg_range(b, 0.35f, 0.85f), thick = dmg_range(b, 0.015f, 0.05f);
    float leg = dmg_range(b, 0.03f, 0.08f), under = height - thick, apron = under * dmg_range(b, 0.12f, 0.3f);
    bool round = dmg_chance(b, 0.1f), desk = width > 1.0f && dmg_chance(b, 0.45f), both = dmg_chance(b, 0.4f);
    dmg_save(b);
    dmg_move(b, 0, height, 0);
    draw_table_top(b, width, depth, thick, round);
    dmg_restore(b);
    draw_table_legs(b, round ? 0.7f * width : width, round ? 0.7f * depth : depth, under, leg);
    float inner = (round ? 0.6f : 1.0f) * (width - 3 * leg), z = 0.5f * depth - 0.5f * leg,
          deep = (round ? 0.5f : 1.0f) * (depth - 2 * leg);
    if (round) z = 0.3f * depth;
    dmg_move(b, 0, under, z);
    if (desk) { /* pedestals at one side or both */
        float w = inner * dmg_range(b, 0.2f, 0.33f), h = under * dmg_range(b, 0.5f, 0.97f);
        for (int s = -1; s <= (both ? 1 : -1); s += 2) {
            dmg_save(b);
            dmg_move(b, (float)s * 0.5f * (inner - w), 0, 0);
            draw_pedestal(b, w, deep, h);
            dmg_restore(b);
        }
        if (!both) return;
        inner -= 2.2f * w;
    }
    dmg_box(b, v3(0, -0.5f * apron, -deep), v3(inner, apron, 0.018f));
    if (dmg_chance(b, 0.7f)) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.51f * inner, -0.5f * apron, -0.5f * deep), v3(0.018f, apron, deep));
    }
    int columns = dmg_int(b, 1, inner > 0.9f ? 4 : 2), rows = apron > 0.16f ? dmg_int(b, 1, 2) : 1;
    draw_apron_drawers(b, inner, deep, apron, columns, rows);
    if (!round && dmg_chance(b, 0.15f)) { /* a leaf that folds down at the end of the top */
        float leaf = 0.3f * width, y = thick - dmg_range(b, 0, 1) * thick;
        dmg_move(b, 0.5f * width, 0, -z);
        dmg_hinge(b, 0, "table_leaf", v3(0, y, 0), v3(0, 0, -1), 0.0f, 1.5f);
        dmg_box(b, v3(0.5f * leaf, 0.5f * thick, 0), v3(leaf, thick, depth));
        dmg_use(b, 0);
    }
}

/* ---- wardrobe ---- */

/* Hinged leaves side by side; pairs meet in their middle. */
static void draw_wardrobe_doors(dmg_builder* b, float width, float height, int count) {
    dmg_leaf leaf = dmg_leaf_pick(b, 0.25f);
    leaf.width = width / (float)count - 0.004f;
    leaf.height = height;
    for (int i = 0; i < count; ++i) {
        leaf.side = i % 2 == 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_save(b);
        dmg_move(b, width * (((float)i + 0.5f) / (float)count - 0.5f), 0, leaf.thickness);
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_wardrobe(dmg_builder* b) {
    float width = dmg_range(b, 0.8f, 2.4f), height = dmg_range(b, 1.6f, 2.4f), depth = dmg_range(b, 0.45f, 0.7f),
          foot = dmg_range(b, 0, 0.12f), wall = 0.022f;
    float drawers = dmg_chance(b, 0.35f) ? dmg_range(b, 0.2f, 0.4f) : 0.0f, doors = height - drawers;
    dmg_case_kind shell = dmg_case_pick(b);
    dmg_feet_draw(b, dmg_int(b, 0, DMG_FEET_KINDS - 1), width, depth, foot);
    dmg_move(b, 0, foot + drawers + 0.5f * doors, 0.5f * depth);
    dmg_case_draw(b, shell, width, doors, depth, wall);
    if (shell != DMG_CASE_SOLID) { /* inside: a rail and shelves */
        dmg_rod(b, v3(-0.5f * width, 0.42f * doors, -0.5f * depth), v3(0.5f * width, 0.42f * doors, -0.5f * depth),
                0.015f);
        int shelves = dmg_int(b, 0, 3);
        for (int i = 0; i < shelves; ++i)
            dmg_box(b, v3(0.25f * width, (0.25f * (float)i - 0.4f) * doors, -0.5f * depth),
                    v3(0.5f * width - wall, wall, 0.85f * depth));
        if (shelves > 0) dmg_box(b, v3(0, 0, -0.5f * depth), v3(wall, doors, 0.85f * depth));
    }
    int count = (int)(width / dmg_range(b, 0.4f, 0.65f));
    count = count < 1 ? 1 : (count > 6 ? 6 : count);
    if (dmg_chance(b, 0.3f) && width > 1.0f) {
        dmg_sliding s = {.name = "sliding_door",
                         .leaves = dmg_int(b, 2, 3),
                         .width = width,
                         .height = doors - 2 * wall,
                         .thickness = 0.025f};
        s.leaf = 1.04f * width / (float)s.leaves;
        s.panel = dmg_panel_pick(b);
        s.handle = dmg_handle_pick(b, 0.25f);
        dmg_save(b);
        dmg_move(b, 0, 0, 0.06f);
        dmg_sliding_draw(b, &s);
        dmg_restore(b);
    } else {
        draw_wardrobe_doors(b, width, doors, count);
    }
    if (drawers == 0.0f) return;
    dmg_move(b, 0, -0.5f * (doors + drawers), 0);
    dmg_case_draw(b, shell, width, drawers, depth, wall);
    dmg_drawer drawer = dmg_drawer_pick(b, 0.2f);
    int columns = dmg_int(b, 1, 3);
    drawer.width = width / (float)columns - 0.006f;
    drawer.height = 0.96f * drawers;
    drawer.depth = 0.9f * depth;
    drawer.travel = 0.75f * depth;
    for (int i = 0; i < columns; ++i) {
        dmg_save(b);
        dmg_move(b, width * (((float)i + 0.5f) / (float)columns - 0.5f), 0, drawer.thickness);
        dmg_drawer_draw(b, 0, "drawer", &drawer);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- folding chair ---- */

void dmg_build_folding_chair(dmg_builder* b) {
    float width = dmg_range(b, 0.38f, 0.5f), seat = dmg_range(b, 0.4f, 0.5f), back = dmg_range(b, 0.75f, 1.0f),
          r = dmg_range(b, 0.008f, 0.02f), deep = dmg_range(b, 0.32f, 0.45f);
    float lean = dmg_range(b, 0.25f, 0.45f), x = 0.5f * width;
    bool round = dmg_chance(b, 0.5f);
    /* The back frame runs from the front feet to the top of the back rest; the rest hangs on it. */
    dmg_vec front = {0, 0, 0.5f * deep}, top = {0, back, 0.5f * deep - lean * back},
            pivot = v3_lerp(front, top, seat / back);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec side = {(float)s * x, 0, 0};
        if (round)
            dmg_rod(b, v3_add(front, side), v3_add(top, side), r);
        else
            dmg_beam(b, v3_add(front, side), v3_add(top, side), 1.4f * r, 2.4f * r);
    }
    dmg_rod(b, v3_add(front, v3(-x, 0.15f, -0.15f * lean)), v3_add(front, v3(x, 0.15f, -0.15f * lean)), 0.7f * r);
    dmg_vec rest = v3_lerp(pivot, top, 0.75f);
    dmg_save(b);
    dmg_move(b, rest.x, rest.y, rest.z);
    dmg_turn(b, v3(1, 0, 0), -atanf(lean));
    dmg_rounded_plate(b, width, (back - seat) * dmg_range(b, 0.3f, 0.6f), 1.2f * r, 0.05f);
    dmg_restore(b);
    float legs = seat / back * dmg_range(b, 0.55f, 0.9f), folded = dmg_range(b, 1.1f, 1.4f);
    dmg_vec cross = v3_lerp(front, top, legs);
    uint32_t leg = dmg_hinge(b, 0, "rear_legs", cross, v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 0.9f));
    dmg_vec foot = {0, 0, cross.z - dmg_range(b, 0.2f, 0.3f)}, rung = v3_lerp(cross, foot, dmg_range(b, 0.5f, 0.9f));
    dmg_rod(b, v3_add(rung, v3(-x, 0, 0)), v3_add(rung, v3(x, 0, 0)), 0.7f * r);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec side = {(float)s * (x - 2.2f * r), 0, 0};
        if (round)
            dmg_rod(b, v3_add(cross, side), v3_add(foot, side), r);
        else
            dmg_beam(b, v3_add(cross, side), v3_add(foot, side), 1.4f * r, 2.4f * r);
    }
    uint32_t pan = dmg_hinge(b, 0, "seat", pivot, v3(-1, 0, 0), 0.0f, folded);
    dmg_save(b);
    dmg_move(b, 0, pivot.y + r, pivot.z + 0.45f * deep);
    if (dmg_chance(b, 0.5f)) {
        dmg_face_up(b);
        dmg_rounded_plate(b, width - 5 * r, deep, 1.5f * r, 0.06f);
    } else {
        for (int i = 0; i < 5; ++i)
            dmg_box(b, v3(0, 0, deep * (0.2f * (float)i - 0.4f)), v3(width - 5 * r, 1.2f * r, 0.15f * deep));
    }
    dmg_restore(b);
    bool is_folded = dmg_chance(b, 0.3f);
    if (is_folded) dmg_rest(b, pan, folded);
    if (is_folded) dmg_rest(b, leg, 0.45f);
    dmg_use(b, 0);
}

/* ---- swivel chair ---- */

static void draw_star_base(dmg_builder* b, float reach, float wheel) {
    int arms = dmg_int(b, 4, 5);
    bool forks = dmg_chance(b, 0.7f);
    for (int i = 0; i < arms; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, arms);
        dmg_use(b, 0);
        dmg_beam(b, v3(0, 2.6f * wheel, 0), v3(0, 2.3f * wheel, reach), 0.9f * wheel, 0.9f * wheel);
        uint32_t fork = 0;
        if (forks) { /* a caster swivels, its wheel rolls a little behind */
            fork = dmg_spin(b, 0, "caster", v3(0, 0, reach), v3(0, 1, 0));
            dmg_rod(b, v3(0, 1.9f * wheel, reach), v3(0, 2.7f * wheel, reach), 0.3f * wheel);
            dmg_box(b, v3(0, 1.9f * wheel, reach + 0.3f * wheel), v3(1.2f * wheel, 0.4f * wheel, 1.4f * wheel));
        }
        dmg_move(b, 0, wheel, reach + 0.5f * wheel);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_spin(b, fork, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, dmg_chance(b, 0.5f) ? 0 : 5, wheel, 0.8f * wheel, 4);
        dmg_restore(b);
    }
}

void dmg_build_swivel_chair(dmg_builder* b) {
    float seat = dmg_range(b, 0.42f, 0.55f), width = dmg_range(b, 0.4f, 0.52f), reach = dmg_range(b, 0.22f, 0.32f),
          wheel = dmg_range(b, 0.025f, 0.04f), high = dmg_range(b, 0.35f, 0.7f);
    draw_star_base(b, reach, wheel);
    dmg_use(b, 0);
    dmg_rod(b, v3(0, 2.2f * wheel, 0), v3(0, 0.6f * seat, 0), 0.028f);
    bool lifts = dmg_chance(b, 0.5f);
    uint32_t column = 0;
    if (lifts) {
        column = dmg_slide(b, 0, "column", v3(0, 1, 0), 0.0f, 0.12f);
        dmg_rod(b, v3(0, 0.3f * seat, 0), v3(0, 0.85f * seat, 0), 0.02f);
    }
    uint32_t top = dmg_spin(b, column, "seat", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0.8f * seat, 0), v3(0, seat, 0), 0.035f);
    dmg_rounded_box(b, v3(0, seat + 0.03f, 0), v3(width, 0.07f, width), 0.03f);
    if (dmg_chance(b, 0.8f)) {
        uint32_t back = top;
        dmg_vec foot = {0, seat, -0.5f * width};
        if (dmg_chance(b, 0.4f)) back = dmg_hinge(b, top, "backrest", foot, v3(-1, 0, 0), -0.1f, 0.5f);
        dmg_use(b, back);
        dmg_beam(b, foot, v3_add(foot, v3(0, 0.5f * high, -0.05f)), 0.06f, 0.02f);
        dmg_rounded_box(b, v3_add(foot, v3(0, 0.55f * high, 0)), v3(0.9f * width, 0.8f * high, 0.06f), 0.025f);
    }
    for (int s = -1; s <= 1 && dmg_chance(b, 0.6f); s += 2) {
        dmg_use(b, top);
        dmg_vec foot = {(float)s * 0.52f * width, seat, 0};
        dmg_beam(b, foot, v3_add(foot, v3(0, 0.2f, 0)), 0.03f, 0.06f);
        dmg_box(b, v3_add(foot, v3(0, 0.21f, 0.03f)), v3(0.06f, 0.025f, 0.26f));
    }
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, top, "lever", v3(0.05f, 0.93f * seat, 0), v3(0, 0, 1), -0.25f, 0.25f);
        dmg_rod(b, v3(0.05f, 0.93f * seat, 0), v3(0.5f * width, 0.93f * seat, 0), 0.006f);
    }
    dmg_use(b, 0);
}
