/* Draws rail wagons: hopper doors below, sliding doors, drop sides, tanks with hatches and valves, stakes. */
#include "core/build.h"
#include "parts/rails.h"
#include "parts/walls.h"

/* ---- wagons: the floor's top is y = floor ---- */

typedef struct wagon {
    float half, end, floor, high; /* half width, half length, top of the floor, height of the body over it */
} wagon;

/* Bins whose bottoms open: doors across or along the track. */
static void draw_hopper(dmg_builder* b, const wagon* w) {
    int bins = dmg_int(b, 1, 4);
    float each = 2 * w->end * 0.84f / (float)bins, mouth = w->half * dmg_range(b, 0.3f, 0.5f), deep = 0.5f * mouth,
          low = w->floor - 0.25f, t = 0.05f, swing = dmg_range(b, 0.7f, 1.4f), top = w->floor + w->high;
    int doors = dmg_int(b, 0, 2); /* pairs along the track, one across, sliding gates */
    for (int i = 0; i < bins; ++i) {
        float z = -0.84f * w->end + each * ((float)i + 0.5f);
        const dmg_xy square[] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};
        const dmg_row rows[] = {{2 * mouth, 2 * deep, 0, 0},
                                {2 * w->half, each, 0, w->floor + 0.3f * w->high - low},
                                {2 * w->half, each, 0, top - low}};
        dmg_roof_enter(b, v3(0, low, z));
        dmg_loft(b, square, 4, rows, 3);
        dmg_restore(b);
        dmg_vec far = {0, low - 0.5f * t - 0.01f, z};
        for (int k = -1; k <= 1 && doors == 0; k += 2) {
            dmg_hinge(b, 0, "hopper_door", v3((float)k * mouth, low, z), v3(0, 0, (float)k), 0.0f, swing);
            dmg_box(b, v3((float)k * 0.5f * mouth, far.y, z), v3(0.97f * mouth, t, 2 * deep));
            dmg_use(b, 0);
        }
        if (doors == 1) {
            dmg_hinge(b, 0, "hopper_door", v3(0, low, z + deep), v3(-1, 0, 0), 0.0f, swing);
            dmg_box(b, far, v3(2 * mouth, t, 2 * deep));
        } else if (doors == 2) {
            float dir = dmg_sign(b);
            dmg_slide(b, 0, "hopper_gate", v3(dir, 0, 0), 0.0f, 0.9f * mouth);
            dmg_box(b, far, v3(1.9f * mouth, t, 2 * deep));
            dmg_box(b, v3(dir * 1.05f * mouth, far.y, z), v3(0.3f * mouth, t, 0.3f * deep));
        }
        dmg_use(b, 0);
        if (dmg_chance(b, 0.5f)) { /* a lid on top, or the wheel that works the doors */
            dmg_roof_enter(b, v3(0, top, z));
            dmg_wall_leaf_draw(b, 0, "hatch", 1.2f * w->half, 0.7f * each,
                               dmg_chance(b, 0.7f) ? DMG_SIDE_LEFT : DMG_SIDE_TOP);
            dmg_restore(b);
        } else {
            dmg_wall_enter(b, v3(w->half, w->floor + 0.4f * w->high, z), 0.5f * DMG_PI);
            dmg_wall_wheel_draw(b, 0, "door_wheel", 0.22f);
            dmg_restore(b);
        }
    }
    for (int k = 0; k < 4; ++k) { /* posts that carry the corners */
        float x = (k & 1 ? 0.9f : -0.9f) * w->half, z = (k & 2 ? 0.8f : -0.8f) * w->end;
        dmg_box_span(b, v3(x - 0.06f, w->floor, z - 0.08f), v3(x + 0.06f, w->floor + 0.4f * w->high, z + 0.08f));
    }
    for (int k = -1; k <= 1; k += 2)
        dmg_box(b, v3((float)k * 0.9f * w->half, w->floor - 0.1f, 0), v3(0.12f, 0.25f, 2 * w->end));
    for (int k = -1; k <= 1; k += 2)
        dmg_box(b, v3(0, w->floor - 0.1f, (float)k * 0.93f * w->end), v3(2 * w->half, 0.25f, 0.14f * w->end));
}

static void draw_box_wagon(dmg_builder* b, const wagon* w) {
    float t = 0.07f, top = w->floor + w->high, door = w->end * dmg_range(b, 0.25f, 0.5f), y = w->floor + 0.5f * w->high;
    int kind = dmg_int(b, 0, 2); /* one slides, two slide apart, two swing */
    bool solid = dmg_chance(b, 0.3f);
    dmg_box_span(b, v3(-w->half, w->floor - 0.15f, -w->end), v3(w->half, w->floor, w->end));
    dmg_box_span(b, v3(-w->half - 0.05f, top, -w->end), v3(w->half + 0.05f, top + t, w->end));
    if (solid) dmg_box_span(b, v3(-w->half + t, w->floor, -w->end), v3(w->half - t, top, w->end));
    for (int k = -1; k <= 1; k += 2) {
        float s = (float)k;
        dmg_box(b, v3(0, y, s * (w->end - 0.5f * t)), v3(2 * w->half, w->high, t));
        for (int m = -1; m <= 1; m += 2)
            dmg_box(b, v3(s * (w->half - 0.5f * t), y, (float)m * 0.5f * (w->end + door)),
                    v3(t, w->high, w->end - door));
        for (int m = -1; m <= 1; m += 2)
            dmg_box(b, v3(s * (w->half + 0.07f), y + (float)m * 0.5f * w->high, 0),
                    v3(0.1f, 0.06f, kind < 2 ? 1.9f * w->end : 2 * door));
        dmg_wall_enter(b, v3(s * (w->half + 0.005f), y, 0), s * 0.5f * DMG_PI);
        for (int m = 0; m < (kind ? 2 : 1); ++m) {
            float dir = kind ? (m ? 1.0f : -1.0f) : dmg_sign(b), wide = kind ? door : 2 * door;
            dmg_move(b, kind ? dir * 0.5f * door : 0.0f, 0, 0);
            if (kind == 2) {
                dmg_wall_leaf_draw(b, 0, "side_door", 0.97f * wide, 0.93f * w->high,
                                   m ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT);
            } else {
                dmg_slide(b, 0, "side_door", v3(dir, 0, 0), 0.0f, fminf(wide, w->end - door) * 0.95f);
                dmg_panel p = dmg_panel_pick(b);
                dmg_handle h = dmg_handle_pick_bar(b, 0.4f);
                dmg_move(b, 0, 0, 0.06f);
                dmg_panel_draw(b, &p, 0.99f * wide, 0.93f * w->high, 0.05f);
                dmg_move(b, -dir * 0.4f * wide, 0, 0);
                dmg_handle_draw(b, &h, 0.6f);
                dmg_move(b, dir * 0.4f * wide, 0, -0.06f);
                dmg_use(b, 0);
            }
            dmg_move(b, kind ? -dir * 0.5f * door : 0.0f, 0, 0);
        }
        dmg_restore(b);
    }
    int hatches = dmg_int(b, 0, 3);
    for (int i = 0; i < hatches; ++i) {
        dmg_roof_enter(b, v3(0, top + t, w->end * (-0.7f + 0.6f * (float)i)));
        dmg_wall_leaf_draw(b, 0, "roof_hatch", 0.9f * w->half, 0.5f, (dmg_side)dmg_int(b, 0, 3));
        dmg_restore(b);
    }
}

/* Sides and ends let down about the floor's edge, or stakes that fold or lift out. */
static void draw_open_wagon(dmg_builder* b, const wagon* w) {
    int count = dmg_int(b, 1, 4), stakes = dmg_int(b, 0, 2); /* none, folding, lifting */
    bool sides = stakes == 0 || dmg_chance(b, 0.3f), ends = dmg_chance(b, 0.7f);
    float high = dmg_range(b, 0.4f, 1.1f), t = 0.05f, each = 2 * w->end / (float)count,
          swing = dmg_range(b, 1.6f, 3.0f), tall = dmg_range(b, 0.8f, 1.8f);
    dmg_box_span(b, v3(-w->half, w->floor - 0.2f, -w->end), v3(w->half, w->floor, w->end));
    for (int k = 0; k < 2; ++k) {
        dmg_save(b);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        for (int i = 0; i < count; ++i) {
            float z = -w->end + each * ((float)i + 0.5f);
            if (sides) {
                uint32_t side = dmg_hinge(b, 0, "drop_side", v3(w->half + t, w->floor, z), v3(0, 0, -1), 0.0f, swing);
                dmg_box_span(b, v3(w->half, w->floor - 0.02f, z - 0.485f * each),
                             v3(w->half + t, w->floor + high, z + 0.485f * each));
                for (int m = -1; m <= 1; m += 2)
                    dmg_box_span(b, v3(w->half + t, w->floor, z + (float)m * 0.4f * each),
                                 v3(w->half + 1.6f * t, w->floor + high, z + (float)m * 0.4f * each + 0.1f));
                dmg_wall_enter(b, v3(w->half + t, w->floor + 0.85f * high, z), 0.5f * DMG_PI);
                if (i == 0) dmg_wall_lever_draw(b, side, "side_catch", 0.25f, -1.57f, 1.4f);
                dmg_restore(b);
            }
            if (stakes == 1) {
                dmg_hinge(b, 0, "stake", v3(w->half + 0.15f, w->floor - 0.1f, z), v3(0, 0, -1), 0.0f, 2.9f);
            } else if (stakes == 2) {
                dmg_slide(b, 0, "stake", v3(0, 1, 0), 0.0f, 0.35f);
            }
            if (stakes)
                dmg_box_span(b, v3(w->half + 0.1f, w->floor - 0.18f, z + 0.49f * each - 0.1f),
                             v3(w->half + 0.2f, w->floor + tall, z + 0.49f * each));
            dmg_use(b, 0);
            if (stakes)
                dmg_box_span(b, v3(w->half, w->floor - 0.2f, z + 0.49f * each - 0.14f),
                             v3(w->half + 0.1f, w->floor - 0.02f, z + 0.49f * each + 0.04f));
        }
        dmg_restore(b);
        dmg_save(b);
        if (k) dmg_mirror(b, v3(0, 0, 1));
        if (ends) {
            dmg_hinge(b, 0, "end_flap", v3(0, w->floor, w->end + t), v3(1, 0, 0), 0.0f, dmg_range(b, 1.3f, 1.7f));
            dmg_box_span(b, v3(-0.98f * w->half, w->floor - 0.02f, w->end),
                         v3(0.98f * w->half, w->floor + 0.9f * high, w->end + t));
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
}

static void draw_tank(dmg_builder* b, const wagon* w) {
    float r = fminf(w->half, 0.5f * w->high + 0.2f), y = w->floor + r + 0.1f;
    int hatches = dmg_int(b, 1, 3), valves = dmg_int(b, 1, 2);
    dmg_box_span(b, v3(-0.6f * w->half, w->floor - 0.25f, -w->end), v3(0.6f * w->half, w->floor, w->end));
    dmg_rod(b, v3(0, y, -0.9f * w->end), v3(0, y, 0.9f * w->end), r);
    dmg_ellipsoid(b, v3(0, y, 0.9f * w->end), v3(0.98f * r, 0.98f * r, 0.2f * r));
    dmg_ellipsoid(b, v3(0, y, -0.9f * w->end), v3(0.98f * r, 0.98f * r, 0.2f * r));
    for (int k = -1; k <= 1; k += 2)
        dmg_box(b, v3(0, w->floor + 0.25f * r, (float)k * 0.6f * w->end), v3(1.4f * r, 0.6f * r, 0.4f));
    dmg_box(b, v3(0.55f * r, y + r - 0.08f, 0), v3(0.6f * r, 0.05f, 0.6f * w->end)); /* where one walks */
    for (int i = 0; i < hatches; ++i) {
        float z = w->end * 0.4f * ((float)i - 0.5f * (float)(hatches - 1));
        dmg_rod(b, v3(0, y + 0.9f * r, z), v3(0, y + 1.06f * r, z), 0.3f);
        dmg_roof_enter(b, v3(0, y + 1.06f * r, z));
        dmg_wall_lid_draw(b, 0, "tank_hatch", 0.33f);
        dmg_restore(b);
    }
    for (int i = 0; i < valves; ++i) {
        float side = i ? -1.0f : 1.0f;
        dmg_rod(b, v3(0, w->floor - 0.4f, 0.05f * side), v3(side * w->half, w->floor - 0.4f, 0.05f * side), 0.09f);
        dmg_wall_enter(b, v3(side * w->half, w->floor - 0.4f, 0.05f * side), side * 0.5f * DMG_PI);
        dmg_wall_lid_draw(b, 0, "outlet_cap", 0.14f);
        dmg_move(b, 0.4f, 0, -0.1f);
        dmg_rod(b, v3(-0.4f, 0, -0.05f), v3(0, 0, -0.05f), 0.06f);
        dmg_rod(b, v3(0, 0, -0.1f), v3(0, 0, 0), 0.09f);
        if (dmg_chance(b, 0.5f))
            dmg_wall_wheel_draw(b, 0, "valve", 0.16f);
        else
            dmg_wall_lever_draw(b, 0, "valve", 0.3f, 0.0f, 1.57f);
        dmg_restore(b);
    }
}

void dmg_build_rail_wagon(dmg_builder* b) {
    dmg_running n = dmg_running_pick(b, dmg_range(b, 0.35f, 0.5f));
    wagon w = {.half = dmg_range(b, 1.1f, 1.5f)};
    w.end = dmg_range(b, 2.2f, 7.0f);
    w.floor = 2.4f * n.r + 0.35f;
    w.high = dmg_range(b, 1.4f, 2.8f);
    dmg_grow(b, dmg_chance(b, 0.3f) ? dmg_scale_range(b, 0.01f, 0.3f) : 1.0f);
    if (w.end > 4.0f) {
        for (int k = -1; k <= 1; k += 2) dmg_bogie_draw(b, &n, (float)k * (w.end - 2.4f * n.r), w.floor - 0.25f, 2);
    } else {
        for (int k = -1; k <= 1; k += 2) {
            float z = (float)k * (w.end - 2.0f * n.r);
            for (int m = -1; m <= 1; m += 2)
                dmg_box_span(b, v3((float)m * (n.gauge + 0.25f) - 0.06f, 0.7f * n.r, z - 0.3f),
                             v3((float)m * (n.gauge + 0.25f) + 0.06f, w.floor - 0.1f, z + 0.3f));
            dmg_wheelset_draw(b, &n, 0, z);
        }
    }
    for (int k = -1; k <= 1; k += 2) dmg_buffing_draw(b, 0, w.floor - 0.15f, (float)k * (w.end + 0.12f), (float)k);
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) draw_hopper(b, &w);
    if (kind == 1) draw_box_wagon(b, &w);
    if (kind == 2) draw_open_wagon(b, &w);
    if (kind == 3) draw_tank(b, &w);
    if (dmg_chance(b, 0.6f)) { /* the brake: a wheel on a pillar, or a long lever at the side */
        bool wheel = dmg_chance(b, 0.5f);
        if (wheel) {
            float top = w.floor + dmg_range(b, 0.5f, 1.2f);
            dmg_rod(b, v3(0.6f * w.half, w.floor - 0.2f, w.end + 0.25f), v3(0.6f * w.half, top, w.end + 0.25f), 0.03f);
            dmg_roof_enter(b, v3(0.6f * w.half, top, w.end + 0.25f));
            dmg_wall_wheel_draw(b, 0, "brake_wheel", 0.2f);
        } else {
            dmg_wall_enter(b, v3(w.half - 0.02f, w.floor - 0.25f, 0.3f * w.end), 0.5f * DMG_PI);
            dmg_wall_lever_draw(b, 0, "brake_lever", 1.1f, 0.15f, 0.4f);
        }
        dmg_restore(b);
    }
}
