/* Draws kitchen appliances: a housing with doors, knobs, buttons and trays. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a turntable plate on the floor of a cavity, y = 0. */
static void draw_turntable(dmg_builder* b, float radius) {
    uint32_t plate = dmg_spin(b, 0, "turntable", v3(0, 0, 0), v3(0, 1, 0));
    dmg_keep_rest(b, plate);
    const dmg_xy profile[] = {{0, 0.02f * radius},
                              {0.9f * radius, 0.02f * radius},
                              {radius, 0.1f * radius},
                              {radius, 0.13f * radius},
                              {0, 0.06f * radius}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 5);
    dmg_use(b, 0);
}

void dmg_build_microwave(dmg_builder* b) {
    float width = dmg_range(b, 0.4f, 0.65f), height = dmg_range(b, 0.24f, 0.4f), depth = dmg_range(b, 0.28f, 0.5f);
    float wall = dmg_range(b, 0.012f, 0.03f), foot = dmg_range(b, 0.0f, 0.02f), t = dmg_range(b, 0.015f, 0.04f);
    float panel = width * dmg_range(b, 0.16f, 0.3f), cavity = width - panel;
    bool controls_below = dmg_chance(b, 0.12f), flap = controls_below || dmg_chance(b, 0.1f);
    dmg_case_kind shell = dmg_case_pick(b);
    dmg_feet_draw(b, dmg_chance(b, 0.5f) ? 3 : 4, width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    if (dmg_chance(b, 0.2f)) dmg_mirror(b, v3(1, 0, 0));
    float x = -0.5f * panel, y = 0.0f, w = cavity, h = height, control_w = panel, control_h = height;
    if (controls_below) {
        x = 0.0f;
        w = control_w = width;
        control_h = panel * 0.5f;
        h = height - control_h;
        y = 0.5f * control_h;
    }
    dmg_save(b);
    dmg_move(b, x, y, 0);
    dmg_case_draw(b, shell, w, h, depth, wall);
    float fill_x = dmg_range(b, 0.92f, 1.0f), fill_y = dmg_range(b, 0.9f, 1.0f);
    dmg_leaf leaf = dmg_leaf_pick_appliance(b, w * fill_x, h * fill_y, t);
    if (dmg_chance(b, 0.5f)) dmg_leaf_pick_line(b, &leaf);
    leaf.side = flap ? DMG_SIDE_BOTTOM : DMG_SIDE_LEFT;
    leaf.swing = dmg_range(b, 1.4f, 1.9f);
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_move(b, 0, -0.5f * h + wall, -0.5f * depth);
    if (shell != DMG_CASE_SOLID && dmg_chance(b, 0.5f)) draw_turntable(b, 0.4f * fminf(w, depth));
    dmg_restore(b);
    float proud = dmg_chance(b, 0.5f) ? t : 0.0f;
    dmg_move(b, controls_below ? 0 : 0.5f * cavity, controls_below ? -0.5f * h : 0, proud);
    dmg_box(b, v3(0, 0, -0.5f * (depth + proud)), v3(control_w, control_h, depth + proud));
    dmg_controls_draw(b, 0, 0.85f * control_w, 0.85f * control_h);
}

static void draw_burners(dmg_builder* b, float width, float depth) {
    for (int i = 0; i < 4; ++i) {
        float x = width * (i & 1 ? 0.24f : -0.24f), z = depth * (i & 2 ? 0.24f : -0.24f),
              r = 0.16f * fminf(width, depth);
        if (i == 0) b->sides = b->sides < 12 ? 12 : b->sides;
        dmg_torus(b, v3(x, 0.01f, z), v3(0, 1, 0), r, 0.08f * r);
    }
}

void dmg_build_oven(dmg_builder* b) {
    float width = dmg_range(b, 0.5f, 0.9f), height = dmg_range(b, 0.45f, 0.95f), depth = dmg_range(b, 0.45f, 0.65f);
    float wall = dmg_range(b, 0.02f, 0.05f), t = dmg_range(b, 0.025f, 0.06f), foot = dmg_range(b, 0, 0.1f);
    float panel = height * dmg_range(b, 0.1f, 0.2f),
          base = dmg_chance(b, 0.4f) ? height * dmg_range(b, 0.12f, 0.3f) : 0.0f;
    dmg_case_kind shell = dmg_case_pick(b);
    dmg_feet_draw(b, dmg_int(b, 0, DMG_FEET_KINDS - 1), width, depth, foot);
    float cavity = height - panel - base;
    if (dmg_chance(b, 0.4f)) {
        dmg_save(b);
        dmg_move(b, 0, foot + height, 0);
        draw_burners(b, width, depth);
        dmg_restore(b);
    }
    dmg_move(b, 0, foot + base + 0.5f * cavity, 0.5f * depth);
    dmg_case_draw(b, shell, width, cavity, depth, wall);
    if (shell != DMG_CASE_SOLID)
        dmg_racks_draw(b, "rack", dmg_int(b, 0, 3), width - 2.5f * wall, cavity - 2 * wall, depth - 2 * wall, 0.02f);
    float fill_x = dmg_range(b, 0.9f, 1.0f), fill_y = dmg_range(b, 0.92f, 1.0f);
    dmg_leaf leaf = dmg_leaf_pick_appliance(b, width * fill_x, cavity * fill_y, t);
    if (dmg_chance(b, 0.5f)) dmg_leaf_pick_line(b, &leaf);
    leaf.side = dmg_chance(b, 0.85f) ? DMG_SIDE_BOTTOM : DMG_SIDE_LEFT;
    leaf.swing = dmg_range(b, 1.3f, 1.65f);
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    if (base > 0.0f) { /* a drawer or a plinth below */
        dmg_drawer drawer = dmg_drawer_pick(b, 0.2f);
        drawer.width = 0.97f * width;
        drawer.height = 0.95f * base;
        drawer.depth = 0.85f * depth;
        drawer.travel = 0.7f * depth;
        drawer.thickness = t;
        dmg_save(b);
        dmg_move(b, 0, -0.5f * (cavity + base), t);
        dmg_drawer_draw(b, 0, "drawer", &drawer);
        dmg_move(b, 0, 0, -t);
        dmg_use(b, 0);
        dmg_case_draw(b, shell, width, base, depth, wall);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * (cavity + panel), 0);
    dmg_box(b, v3(0, 0, -0.5f * depth + 0.5f * t), v3(width, panel, depth + t));
    dmg_move(b, 0, 0, t);
    dmg_controls_draw(b, 0, 0.9f * width, 0.75f * panel);
}

/* ---- toaster ---- */

/* Draws the lever that lowers the bread, in a groove on the side z = 0 facing +Z. */
static void draw_toast_lever(dmg_builder* b, float width, float height) {
    float travel = height * dmg_range(b, 0.3f, 0.55f), size = width * dmg_range(b, 0.08f, 0.18f), top = 0.3f * height;
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, top - 0.5f * travel, 0), v3(0.2f * size, travel + size, 0.04f * size));
    uint32_t lever = dmg_slide(b, 0, "slider", v3(0, -1, 0), 0.0f, travel);
    dmg_rod(b, v3(0, top, -0.3f * size), v3(0, top, 0.6f * size), 0.15f * size);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, top, 0.7f * size), v3(1.6f * size, 0.5f * size, 0.6f * size), 0.15f * size);
    else
        dmg_box(b, v3(0, top, 0.7f * size), v3(1.4f * size, 0.4f * size, 0.6f * size));
    if (dmg_chance(b, 0.3f)) dmg_rest(b, lever, dmg_range(b, 0, travel));
    dmg_use(b, 0);
}

static void draw_toaster_body(dmg_builder* b, float width, float height, float depth, int slots, bool lengthwise) {
    float rim = 0.06f * height, slot = (lengthwise ? depth : width) / (float)slots;
    int shape = dmg_int(b, 0, 2);
    dmg_vec centre = {0, 0.5f * height, 0}, size = {width, height, depth};
    if (shape == 0) dmg_rounded_box(b, centre, size, 0.2f * fminf(height, depth));
    if (shape == 1) dmg_box(b, centre, size);
    if (shape == 2) {
        dmg_box(b, v3(0, 0.1f * height, 0), v3(1.02f * width, 0.2f * height, 1.04f * depth));
        dmg_rounded_box(b, v3(0, 0.55f * height, 0), v3(width, 0.9f * height, depth), 0.15f * depth);
    }
    for (int i = 0; i < slots; ++i) { /* rims round the slots */
        float at = slot * ((float)i + 0.5f) - 0.5f * slot * (float)slots;
        dmg_save(b);
        dmg_move(b, lengthwise ? 0 : at, height, lengthwise ? at : 0);
        dmg_face_up(b);
        float w = lengthwise ? 0.75f * width : 0.5f * slot, h = lengthwise ? 0.5f * slot : 0.75f * depth;
        dmg_frame_draw(b, w, h, 0.5f * rim, 0.15f * fminf(w, h));
        dmg_restore(b);
    }
}

void dmg_build_toaster(dmg_builder* b) {
    float width = dmg_range(b, 0.2f, 0.4f), height = dmg_range(b, 0.15f, 0.24f),
          depth = width * dmg_range(b, 0.45f, 0.9f), foot = dmg_range(b, 0, 0.015f);
    int slots = dmg_chance(b, 0.7f) ? 2 : dmg_int(b, 1, 4);
    bool on_side = dmg_chance(b, 0.6f); /* the lever's face */
    dmg_feet_draw(b, 3, 0.8f * width, 0.75f * depth, foot + 0.02f);
    dmg_move(b, 0, foot, 0);
    draw_toaster_body(b, width, height, depth, slots, on_side);
    dmg_move(b, 0, 0.5f * height, 0);
    if (on_side) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    float w = on_side ? depth : width, d = on_side ? width : depth;
    dmg_move(b, 0, 0, 0.5f * d);
    int levers = w > 0.25f && slots > 1 ? dmg_int(b, 1, 2) : 1;
    for (int i = 0; i < levers; ++i) {
        dmg_save(b);
        dmg_move(b, levers == 1 ? dmg_range(b, -0.25f, 0.25f) * w : ((float)i - 0.5f) * 0.5f * w, 0, 0);
        draw_toast_lever(b, w / (float)levers, height);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, 0, -0.28f * height, 0.035f * d); /* a panel proud of the body */
    dmg_box(b, v3(0, 0, -0.04f * d), v3(0.75f * w, 0.28f * height, 0.08f * d));
    if (dmg_chance(b, 0.8f)) dmg_controls_draw(b, 0, 0.7f * w, 0.25f * height);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f)) { /* crumb tray */
        dmg_slide(b, 0, "crumb_tray", v3(0, 0, 1), 0.0f, 0.8f * d);
        dmg_box(b, v3(0, -0.47f * height, -0.48f * d), v3(0.7f * w, 0.02f * height, 0.9f * d));
        dmg_box(b, v3(0, -0.46f * height, 0.01f * d), v3(0.5f * w, 0.06f * height, 0.04f * d));
        dmg_use(b, 0);
    }
}

/* ---- coffee machine ---- */

/* Draws a jug on y = 0, its handle towards +Z. */
static void draw_jug(dmg_builder* b, float radius, float height) {
    enum { POINTS = 6 };
    float neck = radius * dmg_range(b, 0.6f, 0.9f);
    const dmg_xy profile[] = {{0, 0},
                              {0.85f * radius, 0},
                              {radius, 0.3f * height},
                              {neck, 0.85f * height},
                              {1.05f * neck, height},
                              {0.95f * neck, height},
                              {0.9f * radius, 0.3f * height},
                              {0, 0.05f * height}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 8);
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * ((float)i / (POINTS - 1) - 0.5f);
        path[i] = v3(0, height * (0.5f + 0.33f * sinf(angle)), 0.85f * radius + 0.7f * radius * cosf(angle));
    }
    dmg_sweep(b, path, POINTS, 0.07f * radius, 0.12f * radius, false);
}

/* Draws a lid hinged at the back, on y = 0 over width x depth centred at the origin. */
static void draw_small_lid(dmg_builder* b, const char* name, float width, float depth, float thick) {
    float back = -0.5f * depth + dmg_range(b, -0.5f, 0.5f) * thick, far = dmg_range(b, 1.1f, 1.9f);
    dmg_hinge(b, 0, name, v3(0, dmg_range(b, 0, 1) * thick, back), v3(-1, 0, 0), 0.0f, far);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0.5f * thick, 0), v3(width, thick, depth));
    else
        dmg_rounded_box(b, v3(0, 0.5f * thick, 0), v3(width, thick, depth), 0.4f * thick);
    dmg_use(b, 0);
}

/* Base, column and head: the jug slides out of the C. */
static void draw_drip_machine(dmg_builder* b, float width, float height, float depth) {
    float base = height * dmg_range(b, 0.08f, 0.18f), head = height * dmg_range(b, 0.2f, 0.35f),
          column = depth * dmg_range(b, 0.25f, 0.4f), gap = height - base - head;
    dmg_box(b, v3(0, 0.5f * base, 0), v3(width, base, depth));
    dmg_box(b, v3(0, 0.5f * height, -0.5f * (depth - column)), v3(width, height, column));
    dmg_box(b, v3(0, height - 0.5f * head, 0), v3(width, head, depth));
    float radius = 0.45f * fminf(width, depth - column), z = 0.5f * depth - 0.5f * (depth - column);
    dmg_save(b);
    dmg_move(b, 0, base, z);
    dmg_slide(b, 0, "jug", v3(0, 0, 1), 0.0f, depth);
    draw_jug(b, radius, 0.9f * gap);
    dmg_use(b, 0);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, height, 0);
    draw_small_lid(b, "lid", dmg_range(b, 0.7f, 1.0f) * width, 0.8f * depth, 0.06f * height);
    dmg_restore(b);
    dmg_move(b, 0, height - 0.5f * head, 0.5f * depth);
    dmg_controls_draw(b, 0, 0.7f * width, 0.6f * head);
}

/* Draws a boiler with a group: the portafilter turns, the tank lifts out, the tray slides. */
static void draw_espresso_machine(dmg_builder* b, float width, float height, float depth) {
    float tray = height * dmg_range(b, 0.1f, 0.16f), head = height * dmg_range(b, 0.3f, 0.45f),
          back = depth * dmg_range(b, 0.4f, 0.6f), radius = width * dmg_range(b, 0.08f, 0.14f);
    dmg_box(b, v3(0, 0.5f * height, -0.5f * (depth - back)), v3(width, height, back));
    dmg_box(b, v3(0, height - 0.5f * head, 0), v3(width, head, 0.95f * depth));
    dmg_save(b);
    dmg_move(b, 0, 0.5f * tray, 0.5f * depth);
    dmg_slide(b, 0, "tray", v3(0, 0, 1), 0.0f, 0.7f * (depth - back));
    dmg_box_span(b, v3(-0.48f * width, -0.5f * tray, -(depth - back)), v3(0.48f * width, 0.5f * tray, 0));
    dmg_use(b, 0);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, height - head, 0.5f * depth - 0.45f * (depth - back));
    dmg_rod(b, v3(0, -0.4f * radius, 0), v3(0, 0.1f * radius, 0), 1.2f * radius);
    dmg_hinge(b, 0, "portafilter", v3(0, 0, 0), v3(0, 1, 0), 0.0f, dmg_range(b, 0.6f, 1.2f));
    dmg_rod(b, v3(0, -1.0f * radius, 0), v3(0, -0.4f * radius, 0), radius);
    dmg_rod(b, v3(0, -0.7f * radius, 0.9f * radius), v3(0, -0.9f * radius, 4 * radius), 0.3f * radius);
    dmg_use(b, 0);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) {
        dmg_slide(b, 0, "tank", v3(0, 1, 0), 0.0f, 0.6f * height);
        dmg_box(b, v3(0, 0.6f * height, -0.5f * depth - 0.09f * depth), v3(0.8f * width, 0.7f * height, 0.18f * depth));
        dmg_use(b, 0);
    }
    dmg_move(b, 0, height - 0.4f * head, 0.475f * depth);
    dmg_controls_draw(b, 0, 0.8f * width, 0.6f * head);
}

/* Draws a capsule machine: a big lever over the head. */
static void draw_capsule_machine(dmg_builder* b, float width, float height, float depth) {
    float base = 0.08f * height, radius = 0.5f * width;
    dmg_box(b, v3(0, 0.5f * base, 0), v3(width, base, depth));
    dmg_rounded_box(b, v3(0, 0.5f * height, -0.15f * depth), v3(width, height, 0.6f * depth), 0.3f * radius);
    dmg_rod(b, v3(0, 0.75f * height, 0), v3(0, 0.75f * height, 0.45f * depth), 0.6f * radius);
    dmg_vec pivot = {0, 0.93f * height, -0.1f * depth};
    dmg_hinge(b, 0, "lever", pivot, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.6f));
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec foot = v3_add(pivot, v3((float)s * 1.05f * radius, 0, 0));
        dmg_beam(b, foot, v3_add(foot, v3(0, 0.05f * height, 0.6f * depth)), 0.1f * radius, 0.25f * radius);
    }
    dmg_vec grip = v3_add(pivot, v3(0, 0.05f * height, 0.6f * depth));
    dmg_rod(b, v3_add(grip, v3(-1.1f * radius, 0, 0)), v3_add(grip, v3(1.1f * radius, 0, 0)), 0.14f * radius);
    dmg_use(b, 0);
    dmg_slide(b, 0, "tank", v3(0, 1, 0), 0.0f, 0.5f * height);
    dmg_rod(b, v3(0, 0.1f * height, -0.65f * depth), v3(0, 0.85f * height, -0.65f * depth), 0.8f * radius);
    dmg_use(b, 0);
    dmg_move(b, 0, 0.3f * height, 0.15f * depth);
    dmg_controls_draw(b, 0, 0.6f * width, 0.1f * height);
}

void dmg_build_coffee_machine(dmg_builder* b) {
    float width = dmg_range(b, 0.15f, 0.35f), height = dmg_range(b, 0.26f, 0.42f), depth = dmg_range(b, 0.22f, 0.38f);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) draw_drip_machine(b, width, height, depth);
    if (kind == 1) draw_espresso_machine(b, width, height, depth);
    if (kind == 2) draw_capsule_machine(b, 0.6f * width, height, depth);
}
