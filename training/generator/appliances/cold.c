/* Draws large white goods and safes: refrigerators, dishwashers, washing machines, safes. The door is most of the
 * housing's front. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- refrigerator ---- */

/* Trays on the inside of the door in use, whose opening is centred at the origin. */
static void draw_door_trays(dmg_builder* b, float width, float height, float thickness, float room) {
    int count = dmg_int(b, 1, 4);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, 0, height * (((float)i + 0.3f) / (float)count - 0.5f), -thickness);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.75f * width, 0.12f * height, room, 0.012f);
        dmg_restore(b);
    }
}

/* Shelves and crispers of one compartment, its opening centred at the origin. */
static void draw_compartment(dmg_builder* b, float width, float height, float depth, float wall, bool crispers) {
    int shelves = (int)(height / dmg_range(b, 0.2f, 0.4f));
    float w = width - 2 * wall, back = depth - wall, front = 0.16f * depth;
    for (int i = 1; i <= shelves; ++i) {
        float y = (height - 2 * wall) * ((float)i / (float)(shelves + 1) - 0.5f);
        dmg_box_span(b, v3(-0.5f * w, y, -back), v3(0.5f * w, y + 0.008f, -front));
    }
    float room = (height - 2 * wall) / (float)(shelves + 1);
    for (int i = 0; i < 2 && crispers; ++i) {
        dmg_drawer crisper = {.thickness = 0.01f, .travel = 0.6f * depth, .tray_height = 0.9f, .wall = 0.006f};
        crisper.width = 0.48f * w;
        crisper.height = 0.85f * fminf(room, 0.3f);
        crisper.depth = back - front;
        crisper.tray = DMG_TRAY_BOARDS;
        crisper.handle = (dmg_handle){DMG_HANDLE_BLOCK, 0.08f, 0.012f, 0.012f, 0.8f};
        crisper.handles = 1;
        dmg_save(b);
        dmg_move(b, ((float)i - 0.5f) * 0.5f * w, -0.5f * height + wall + 0.5f * crisper.height + 0.004f, -front);
        dmg_keep_rest(b, dmg_drawer_draw(b, 0, "crisper", &crisper));
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

typedef struct fridge {
    float width, depth, wall, thickness;
    dmg_leaf leaf;
    dmg_case_kind shell;
    bool trays;
} fridge;

/* Draws one compartment with one or two doors, centred at the origin of the front. */
static void draw_cold_room(dmg_builder* b, const fridge* f, float width, float height, bool twin, bool left,
                           bool crispers) {
    dmg_use(b, 0);
    dmg_case_draw(b, f->shell, width, height, f->depth, f->wall);
    if (f->shell != DMG_CASE_SOLID) draw_compartment(b, width, height, f->depth, f->wall, crispers && !twin);
    for (int i = 0; i < (twin ? 2 : 1); ++i) {
        dmg_leaf leaf = f->leaf;
        leaf.width = (twin ? 0.5f * width : width) - 0.006f;
        leaf.height = height - 0.006f;
        bool hung_left = twin ? i == 0 : left;
        leaf.side = hung_left ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_save(b);
        dmg_move(b, twin ? ((float)i - 0.5f) * 0.5f * width : 0.0f, 0, leaf.thickness);
        dmg_leaf_draw(b, 0, height > 0.9f || twin ? "door" : "freezer_door", &leaf);
        if (f->trays && f->shell != DMG_CASE_SOLID)
            draw_door_trays(b, leaf.width - f->wall, 0.9f * height, leaf.thickness, 0.13f * f->depth);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_freezer_drawer(dmg_builder* b, const fridge* f, float height) {
    dmg_use(b, 0);
    dmg_case_draw(b, f->shell, f->width, height, f->depth, f->wall);
    dmg_drawer drawer = dmg_drawer_pick(b, 0.4f);
    drawer.width = f->width - 0.006f;
    drawer.height = height - 0.006f;
    drawer.thickness = f->thickness;
    drawer.depth = 0.85f * f->depth;
    drawer.travel = 0.7f * f->depth;
    drawer.panel = f->leaf.panel;
    drawer.handle = f->leaf.handle;
    drawer.handle_at = 0.3f;
    dmg_save(b);
    dmg_move(b, 0, 0, f->thickness);
    dmg_drawer_draw(b, 0, "freezer_drawer", &drawer);
    dmg_restore(b);
    dmg_use(b, 0);
}

static fridge pick_fridge(dmg_builder* b, float height) {
    fridge f = {
        .width = dmg_range(b, 0.5f, 0.95f), .depth = dmg_range(b, 0.5f, 0.75f), .wall = dmg_range(b, 0.03f, 0.06f)};
    f.thickness = dmg_range(b, 0.03f, 0.08f);
    f.shell = dmg_case_pick(b);
    f.trays = dmg_chance(b, 0.5f);
    f.leaf = dmg_leaf_pick_appliance(b, f.width, 0.6f * height, f.thickness);
    if (dmg_chance(b, 0.5f)) dmg_leaf_pick_line(b, &f.leaf);
    f.leaf.panel.kind =
        dmg_chance(b, 0.85f) ? (dmg_chance(b, 0.5f) ? DMG_PANEL_FLAT : DMG_PANEL_SOFT) : DMG_PANEL_WINDOW;
    f.leaf.handle_at = dmg_range(b, -0.2f, 0.2f);
    return f;
}

void dmg_build_refrigerator(dmg_builder* b) {
    float height = dmg_scale_range(b, 0.6f, 2.0f), foot = dmg_range(b, 0, 0.06f),
          part = height * dmg_range(b, 0.22f, 0.4f);
    fridge f = pick_fridge(b, height);
    bool left = dmg_chance(b, 0.5f);
    int layout = height < 1.1f ? 0 : dmg_int(b, 0, 4);
    dmg_feet_draw(b, dmg_chance(b, 0.5f) ? 1 : 3, f.width, f.depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * f.depth);
    if (layout == 0) draw_cold_room(b, &f, f.width, height, false, left, true);
    if (layout == 3) { /* side by side */
        float share = dmg_range(b, 0.35f, 0.5f), w = share * f.width;
        dmg_move(b, 0.5f * (w - f.width), 0, 0);
        draw_cold_room(b, &f, w, height, false, true, false);
        dmg_move(b, 0.5f * f.width, 0, 0);
        draw_cold_room(b, &f, f.width - w, height, false, false, true);
    }
    if (layout == 0 || layout == 3) return;
    bool above = layout == 1;
    dmg_save(b);
    dmg_move(b, 0, above ? -0.5f * part : 0.5f * part, 0);
    draw_cold_room(b, &f, f.width, height - part, layout == 4, left, true);
    dmg_restore(b);
    dmg_move(b, 0, (above ? 0.5f : -0.5f) * (height - part), 0);
    if (layout == 4 || dmg_chance(b, 0.3f))
        draw_freezer_drawer(b, &f, part);
    else
        draw_cold_room(b, &f, f.width, part, false, left, false);
}

/* ---- dishwasher ---- */

void dmg_build_dishwasher(dmg_builder* b) {
    float width = dmg_range(b, 0.4f, 0.62f), height = dmg_range(b, 0.6f, 0.88f), depth = dmg_range(b, 0.5f, 0.62f),
          t = dmg_range(b, 0.02f, 0.06f);
    float foot = dmg_range(b, 0.02f, 0.12f), wall = dmg_range(b, 0.015f, 0.04f),
          strip = height * dmg_range(b, 0.1f, 0.18f);
    dmg_case_kind shell = dmg_case_pick(b);
    bool panel_on_door = dmg_chance(b, 0.6f);
    dmg_feet_draw(b, dmg_chance(b, 0.6f) ? 1 : 3, width, depth, foot);
    float tall = panel_on_door ? height : height - strip;
    dmg_move(b, 0, foot + 0.5f * tall, 0.5f * depth);
    dmg_case_draw(b, shell, width, tall, depth, wall);
    if (shell != DMG_CASE_SOLID)
        dmg_racks_draw(b, "rack", dmg_int(b, 1, 3), width - 2.5f * wall, tall - 3 * wall, depth - 2 * wall,
                       0.12f * tall);
    dmg_leaf leaf = dmg_leaf_pick_appliance(b, width, tall, t);
    if (dmg_chance(b, 0.5f)) dmg_leaf_pick_line(b, &leaf);
    if (dmg_chance(b, 0.8f)) leaf.panel.kind = DMG_PANEL_FLAT;
    leaf.side = DMG_SIDE_BOTTOM;
    leaf.swing = dmg_range(b, 1.35f, 1.6f);
    leaf.handle_edge = panel_on_door ? 0.22f : 0.08f;
    dmg_move(b, 0, 0, t);
    uint32_t door = dmg_leaf_draw(b, 0, "door", &leaf);
    if (panel_on_door) {
        dmg_move(b, 0, 0.5f * (tall - strip), 0);
        dmg_controls_draw(b, door, 0.85f * width, 0.6f * strip);
    } else {
        dmg_use(b, 0);
        dmg_box(b, v3(0, 0.5f * (tall + strip), -0.5f * depth - 0.5f * t), v3(width, strip, depth + t));
        dmg_move(b, 0, 0.5f * (tall + strip), 0);
        dmg_controls_draw(b, 0, 0.9f * width, 0.7f * strip);
    }
    dmg_use(b, 0);
}

/* ---- washing machine ---- */

/* Draws a round door: ring and glass, hung on the left. */
static void draw_porthole(dmg_builder* b, float radius, float rim, bool left) {
    float side = left ? -1.0f : 1.0f, out = rim * dmg_range(b, 0.0f, 0.8f), half = 0.5f * rim;
    float hung = radius + dmg_range(b, -0.6f, 0.5f) * rim, far = dmg_range(b, 1.6f, 2.8f);
    dmg_hinge(b, 0, "door", v3(side * hung, 0, 0.5f * out), v3(0, side, 0), 0.0f, far);
    const dmg_xy ring[] = {{radius - rim, -half},
                           {radius, -half},
                           {radius, 0.3f * rim},
                           {radius - rim, 0.7f * rim},
                           {radius - rim, -half}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
    float bulge = radius * dmg_range(b, 0.1f, 0.5f);
    const dmg_xy glass[] = {{radius - rim, 0}, {0.7f * radius, -0.6f * bulge}, {0.4f * radius, -bulge}, {0, -bulge}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, -1),
              (const dmg_xy[]){{0, bulge}, {0.4f * radius, bulge}, {0.7f * radius, 0.6f * bulge}, {radius - rim, 0}},
              4);
    if (dmg_chance(b, 0.3f)) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), glass, 4);
    float grip = -side * (radius - 0.5f * rim);
    if (dmg_chance(b, 0.7f))
        dmg_rounded_box(b, v3(grip, 0, 0.7f * rim), v3(0.5f * rim, 0.5f * radius, 0.5f * rim), 0.1f * rim);
    dmg_use(b, 0);
}

static void draw_front_loader(dmg_builder* b, float width, float height, float depth) {
    float strip = height * dmg_range(b, 0.12f, 0.2f),
          radius = 0.5f * fminf(width, height - strip) * dmg_range(b, 0.5f, 0.85f),
          rim = radius * dmg_range(b, 0.12f, 0.3f);
    dmg_move(b, 0, 0.5f * (height - strip), 0.5f * depth);
    if (b->messy && dmg_chance(b, 0.4f))
        dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, height - strip, depth));
    else { /* a front with a round hole, a drum behind */
        float hole = radius - 0.8f * rim;
        dmg_holed_plate_draw(b, width, height - strip, 0.02f, hole);
        dmg_move(b, 0, 0, -0.02f);
        dmg_case_draw(b, dmg_case_pick(b), width, height - strip, depth - 0.02f, 0.015f);
        const dmg_xy drum[] = {{0, -0.8f * depth}, {hole, -0.8f * depth}, {hole, 0}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), drum, 3);
        dmg_move(b, 0, 0, 0.02f);
    }
    dmg_save(b);
    dmg_move(b, 0, 0, 0.5f * rim);
    bool left = dmg_chance(b, 0.6f);
    draw_porthole(b, radius, rim, left);
    dmg_restore(b);
    dmg_move(b, 0, 0.5f * height, 0);
    dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, strip, depth));
    dmg_drawer soap = dmg_drawer_pick(b, 0.08f);
    soap.width = width * dmg_range(b, 0.2f, 0.35f);
    soap.height = 0.6f * strip;
    soap.thickness = 0.015f;
    soap.depth = 0.4f * depth;
    soap.travel = 0.3f * depth;
    dmg_save(b);
    dmg_move(b, -0.5f * width + 0.6f * soap.width, 0, 0.015f);
    dmg_drawer_draw(b, 0, "detergent_drawer", &soap);
    dmg_restore(b);
    dmg_move(b, 0.5f * soap.width + 0.02f, 0, 0);
    dmg_controls_draw(b, 0, 0.9f * width - 1.4f * soap.width, 0.75f * strip);
}

static void draw_top_loader(dmg_builder* b, float width, float height, float depth) {
    float t = dmg_range(b, 0.01f, 0.04f), riser = depth * dmg_range(b, 0.12f, 0.25f),
          rise = height * dmg_range(b, 0.08f, 0.2f);
    float lid_depth = (depth - riser) * dmg_range(b, 0.8f, 1.0f), lid_width = width * dmg_range(b, 0.7f, 1.0f);
    dmg_save(b);
    dmg_move(b, 0, height, 0);
    dmg_face_up(b);
    dmg_case_draw(b, dmg_case_pick(b), width, depth, height, 0.02f);
    dmg_restore(b);
    dmg_box(b, v3(0, height + 0.5f * rise, -0.5f * (depth - riser)), v3(width, rise, riser));
    float back = -0.5f * depth + riser;
    dmg_save(b);
    dmg_move(b, 0, height + 0.5f * rise, back);
    dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0, 0.1f));
    dmg_controls_draw(b, 0, 0.85f * width, 0.7f * rise);
    dmg_restore(b);
    float up = height + dmg_range(b, 0, 1) * t, far = dmg_range(b, 1.2f, 1.8f);
    dmg_hinge(b, 0, "lid", v3(0, up, back), v3(-1, 0, 0), 0.0f, far);
    dmg_box(b, v3(0, height + 0.5f * t, back + 0.5f * lid_depth), v3(lid_width, t, lid_depth));
    if (dmg_chance(b, 0.6f))
        dmg_box(b, v3(0, height + t, back + 0.95f * lid_depth), v3(0.3f * lid_width, 0.6f * t, 0.05f * lid_depth));
    dmg_use(b, 0);
}

void dmg_build_washing_machine(dmg_builder* b) {
    float width = dmg_range(b, 0.5f, 0.7f), height = dmg_range(b, 0.7f, 0.95f), depth = dmg_range(b, 0.45f, 0.65f),
          foot = dmg_range(b, 0, 0.04f);
    dmg_feet_draw(b, 3, width, depth, foot);
    dmg_move(b, 0, foot, 0);
    if (dmg_chance(b, 0.7f))
        draw_front_loader(b, width, height, depth);
    else
        draw_top_loader(b, width, height, depth);
}

/* ---- safe ---- */

/* Draws what one turns to open it, on the door in use at z = 0. */
static void draw_safe_lock(dmg_builder* b, uint32_t door, float size) {
    int kind = dmg_int(b, 0, 3);
    float radius = size * dmg_range(b, 0.06f, 0.12f), out = radius * dmg_range(b, 0.5f, 1.2f);
    if (kind == 0) { /* a spoked wheel */
        dmg_spin(b, door, "wheel", v3(0, 0, 0), v3(0, 0, -1));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), 0.25f * radius);
        dmg_save(b);
        dmg_move(b, 0, 0, out);
        dmg_wheel_draw(b, 3, 1.6f * radius, 0.4f * radius, dmg_int(b, 3, 6));
        dmg_restore(b);
    }
    if (kind == 1) { /* a lever */
        dmg_hinge(b, door, "lever", v3(0, 0, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 0.7f, 1.6f));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), 0.5f * radius);
        dmg_beam(b, v3(0, 0, out), v3(-2.2f * radius, 0, out), 0.4f * radius, 0.4f * radius);
    }
    if (kind == 2) { /* three spokes */
        dmg_spin(b, door, "handle", v3(0, 0, 0), v3(0, 0, -1));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), 0.4f * radius);
        for (int i = 0; i < 3; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / 3.0f;
            dmg_vec end = {1.8f * radius * cosf(angle), 1.8f * radius * sinf(angle), out};
            dmg_rod(b, v3(0, 0, 0.8f * out), end, 0.12f * radius);
            dmg_ellipsoid(b, end, v3(0.25f * radius, 0.25f * radius, 0.25f * radius));
        }
    }
    if (kind == 3) { /* a plain knob */
        dmg_hinge(b, door, "knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, 1.6f);
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), radius, out);
    }
    dmg_use(b, door);
}

static void draw_safe_dial(dmg_builder* b, uint32_t door, float size) {
    if (dmg_chance(b, 0.5f)) {
        float radius = size * dmg_range(b, 0.05f, 0.1f);
        dmg_spin(b, door, "dial", v3(0, 0, 0), v3(0, 0, 1));
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), radius, 0.6f * radius);
        dmg_use(b, door);
        return;
    }
    float key = size * dmg_range(b, 0.035f, 0.06f);
    dmg_box(b, v3(0, 0, 0.1f * key), v3(4.2f * key, 5.4f * key, 0.2f * key));
    dmg_buttons pad = {"key", 3, 4, 1.25f * key, 1.25f * key, key, key, 0.4f * key, 0.2f * key, dmg_int(b, 0, 2)};
    dmg_save(b);
    dmg_move(b, 0, 0, 0.2f * key);
    dmg_buttons_draw(b, door, &pad);
    dmg_restore(b);
}

void dmg_build_safe(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.25f, 0.9f), height = width * dmg_scale_range(b, 0.7f, 1.8f),
          depth = width * dmg_range(b, 0.6f, 1.1f);
    float wall = width * dmg_range(b, 0.04f, 0.1f), t = wall * dmg_range(b, 0.6f, 1.6f),
          foot = dmg_chance(b, 0.4f) ? 0.06f * height : 0.0f;
    bool let_in = dmg_chance(b, 0.6f), left = dmg_chance(b, 0.6f);
    dmg_case_kind shell = dmg_case_pick(b);
    dmg_feet_draw(b, dmg_int(b, 0, 3), width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    dmg_case_draw(b, shell, width, height, depth, wall);
    if (shell != DMG_CASE_SOLID && dmg_chance(b, 0.6f))
        dmg_box(b, v3(0, dmg_range(b, -0.2f, 0.2f) * height, -0.55f * depth),
                v3(width - 2 * wall, 0.3f * wall, 0.8f * depth));
    dmg_leaf leaf = dmg_leaf_pick(b, width);
    leaf.width = width - (let_in ? 2.04f * wall : 0.0f);
    leaf.height = height - (let_in ? 2.04f * wall : 0.0f);
    leaf.thickness = t;
    leaf.side = left ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
    leaf.swing = dmg_range(b, 1.5f, 2.9f);
    leaf.handle.kind = DMG_HANDLE_NONE;
    if (dmg_chance(b, 0.6f)) {
        leaf.inset = dmg_range(b, -0.4f, 0.3f);
        leaf.depth = let_in ? dmg_range(b, -0.3f, 0.1f) : dmg_range(b, 0, 1);
    } else {
        leaf.inset = fminf(leaf.inset, 0.6f);
        if (let_in) leaf.depth = fminf(leaf.depth, 0.5f);
    }
    leaf.panel.kind = dmg_chance(b, 0.5f) ? DMG_PANEL_FLAT : (dmg_chance(b, 0.5f) ? DMG_PANEL_RAISED : DMG_PANEL_SOFT);
    leaf.hinge.radius = 0.35f * t;
    dmg_move(b, 0, 0, let_in ? 0.05f * t : t);
    uint32_t door = dmg_leaf_draw(b, 0, "door", &leaf);
    float small = fminf(width, height), side = left ? 1.0f : -1.0f;
    dmg_save(b);
    float lock_x = side * leaf.width * dmg_range(b, 0.1f, 0.28f), lock_y = leaf.height * dmg_range(b, -0.25f, 0.0f);
    dmg_move(b, lock_x, lock_y, 0);
    draw_safe_lock(b, door, small);
    dmg_restore(b);
    dmg_move(b, side * leaf.width * dmg_range(b, -0.1f, 0.1f), leaf.height * 0.27f, 0);
    if (dmg_chance(b, 0.75f)) draw_safe_dial(b, door, small);
    dmg_use(b, 0);
}
