/* Draws bread bins: fronts that roll under the roof, fall forward, turn up with the roof, or are pulled. */
#include "core/arcs.h"
#include "core/build.h"
#include "parts/hardware.h"

typedef struct bin {
    float width, depth, height, wall, round; /* round: of the upper front edge */
} bin;

/* Cheeks, floor, back and as much of the roof as lies behind the front's rounding; or straight in front. */
static void draw_bin_case(dmg_builder* b, const bin* n, bool roof) {
    float z = 0.5f * n->depth, h = n->height, t = n->wall, r = n->round;
    dmg_xy side[DMG_ARC + 3] = {{0, 0}};
    dmg_arc_points(side, r, 0, 0.5f * DMG_PI);
    for (int i = 0; i < DMG_ARC; ++i) side[i] = (dmg_xy){side[i].x + z - r, side[i].y + h - r};
    side[DMG_ARC] = (dmg_xy){-z, h};
    side[DMG_ARC + 1] = (dmg_xy){-z, 0};
    side[DMG_ARC + 2] = (dmg_xy){z, 0};
    dmg_profile_begin(b);
    for (int s = -1; s <= 1; s += 2) {
        float x = 0.5f * (float)s * (n->width - t);
        dmg_extrude(b, side, DMG_ARC + 3, x - 0.5f * t, x + 0.5f * t);
    }
    dmg_restore(b);
    float inner = n->width - 2 * t;
    dmg_box_span(b, v3(-0.5f * inner, 0, -z), v3(0.5f * inner, t, z));
    dmg_box_span(b, v3(-0.5f * inner, t, -z), v3(0.5f * inner, h, t - z));
    if (roof) dmg_box_span(b, v3(-0.5f * inner, h - t, t - z), v3(0.5f * inner, h, z - r));
}

/* Draws a curved front that turns about the middle of its rounding and goes under the roof. */
static void draw_roll_front(dmg_builder* b, const bin* source) {
    bin n = *source;
    n.round = fminf(0.49f * n.depth, n.height - 2.5f * n.wall) * dmg_range(b, 0.8f, 1.0f);
    draw_bin_case(b, &n, true);
    float r = n.round - 1.6f * n.wall, inner = n.width - 2.3f * n.wall, y = n.height - n.round,
          z = 0.5f * n.depth - n.round, far = dmg_range(b, 1.1f, 1.5f);
    bool cheeks = dmg_chance(b, 0.5f), pins = dmg_chance(b, 0.5f);
    dmg_move(b, 0, y, z);
    float low = -asinf(fminf(1.0f, (y - 1.2f * n.wall) / r)) * dmg_range(b, 0.3f, 1.0f);
    if (low * r < 0.0f) { /* a sill as high as the front's lower edge */
        float sill = r * sinf(low) + y;
        if (sill > 1.2f * n.wall)
            dmg_box_span(b, v3(-0.5f * inner, -y, 0.96f * r * cosf(low)),
                         v3(0.5f * inner, sill - y - 0.2f * n.wall, 0.96f * r * cosf(low) + n.wall));
    }
    uint32_t front = dmg_hinge(b, 0, "front", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, far);
    dmg_arc_skin(b, r, low, 0.5f * DMG_PI, n.wall, inner);
    for (int s = -1; s <= 1; s += 2) {
        if (cheeks) dmg_arc_cheek(b, r, low, 0.5f * DMG_PI, 0.48f * (float)s * inner, 0.5f * n.wall, true);
        if (pins) dmg_rod(b, v3(0.46f * (float)s * inner, 0, 0), v3(0.53f * (float)s * n.width, 0, 0), 1.2f * n.wall);
    }
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI - low - 0.15f);
    dmg_move(b, 0, r, 0);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0.8f * n.wall, 0), v3(0.3f * inner, 2 * n.wall, n.wall));
    else
        dmg_rod(b, v3(0, 0, 0), v3(0, 3 * n.wall, 0), 1.5f * n.wall);
    dmg_restore(b);
    if (dmg_chance(b, 0.35f)) dmg_rest(b, front, far * dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

/* Draws a flat front, upright or leaning, that falls forward: its line at the outer lower edge, in it, or on pins above
 * it. */
static void draw_drop_front(dmg_builder* b, const bin* n) {
    float z = 0.5f * n->depth, h = n->height, t = n->wall, lean = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.1f, 0.6f),
          top = z - h * tanf(lean), inner = n->width - 2.1f * t;
    top = fmaxf(top, -0.5f * z);
    lean = atanf((z - top) / h);
    const dmg_xy side[] = {{-z, 0}, {z, 0}, {top, h}, {-z, h}};
    dmg_profile_begin(b);
    for (int s = -1; s <= 1; s += 2) {
        float x = 0.5f * (float)s * (n->width - t);
        dmg_extrude(b, side, 4, x - 0.5f * t, x + 0.5f * t);
    }
    dmg_restore(b);
    dmg_box_span(b, v3(-0.5f * inner, 0, -z), v3(0.5f * inner, t, z - 1.5f * t));
    dmg_box_span(b, v3(-0.5f * inner, t, -z), v3(0.5f * inner, h, t - z));
    dmg_box_span(b, v3(-0.5f * inner, h - t, t - z), v3(0.5f * inner, h, top - 1.2f * t));
    float length = h / cosf(lean), out = t * dmg_range(b, -1.0f, 0.0f),
          up = dmg_chance(b, 0.5f) ? 0.0f : length * dmg_range(b, 0.02f, 0.12f);
    dmg_move(b, 0, 0, z);
    dmg_turn(b, v3(1, 0, 0), -lean);
    bool between = dmg_chance(b, 0.6f); /* between the cheeks or before them */
    if (!between) dmg_move(b, 0, 0, 1.02f * t);
    uint32_t front = dmg_hinge(b, 0, "front", v3(0, up, out), v3(1, 0, 0), 0.0f,
                               dmg_range(b, 1.2f, 1.7f) + (up > 0.0f ? 0.0f : 0.2f));
    dmg_panel panel = dmg_panel_pick(b);
    float w = between ? inner : n->width;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * length, 0);
    dmg_panel_draw(b, &panel, w, 0.99f * length, t);
    dmg_handle grip = dmg_handle_pick(b, 0.3f * h);
    dmg_move(b, 0, 0.35f * length, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &grip, 0.6f * w);
    dmg_restore(b);
    if (up > 0.0f && dmg_chance(b, 0.6f))
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(0.49f * (float)s * w, up, out), v3(0.53f * (float)s * n->width, up, out), 0.6f * t);
    if (dmg_chance(b, 0.35f)) dmg_rest(b, front, dmg_range(b, 0.2f, 1.2f));
    dmg_use(b, 0);
}

/* Roof and front in one piece, bent: it turns up about the rear edge or about pins in the cheeks. */
static void draw_bent_lid(dmg_builder* b, const bin* n) {
    float z = 0.5f * n->depth, h = n->height, t = n->wall, low = h * dmg_range(b, 0.15f, 0.6f),
          inner = n->width - 2.2f * t;
    bool pins = dmg_chance(b, 0.5f), outside = !pins && dmg_chance(b, 0.4f);
    float in = pins ? n->depth * dmg_range(b, 0.08f, 0.35f) : -t * dmg_range(b, 0.0f, 1.0f),
          drop = pins ? fmaxf(1.2f * t, 0.8f * in) : t * dmg_range(b, -0.5f, 1.0f);
    draw_bin_case(b, n, false);
    dmg_box_span(b, v3(-0.5f * inner, t, z - t), v3(0.5f * inner, low, z));
    float over = outside ? t : -0.4f * t, r = n->round;
    dmg_xy line[DMG_ARC + 2];
    dmg_arc_points(line + 1, r + over, 0, 0.5f * DMG_PI);
    for (int i = 1; i <= DMG_ARC; ++i) line[i] = (dmg_xy){line[i].x + z - r, line[i].y + h - r};
    line[0] = (dmg_xy){z + over, fminf(low, h - 1.1f * r)};
    line[DMG_ARC + 1] = (dmg_xy){pins ? -z + 1.3f * t : -z, h + over};
    float far = dmg_range(b, 1.0f, pins ? 1.2f : 1.9f);
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, h - drop, in - z), v3(-1, 0, 0), 0.0f, far);
    dmg_profile_begin(b);
    dmg_bent_plate(b, line, DMG_ARC + 2, t, outside ? n->width + 2.2f * t : inner);
    dmg_restore(b);
    for (int s = -1; s <= 1 && pins; s += 2) {
        float x = 0.48f * (float)s * inner;
        dmg_box_span(b, v3(x - 0.4f * t, h - drop - 1.2f * t, in - z - 1.5f * t),
                     v3(x + 0.4f * t, h, in - z + 1.5f * t));
        dmg_rod(b, v3(x, h - drop, in - z), v3(0.52f * (float)s * n->width, h - drop, in - z), 0.7f * t);
    }
    if (!pins && dmg_chance(b, 0.6f))
        dmg_rod(b, v3(-0.4f * inner, h - drop, in - z), v3(0.4f * inner, h - drop, in - z), 0.7f * t);
    dmg_box(b, v3(0, low + 0.3f * (h - low), z + over + t), v3(inner * dmg_range(b, 0.1f, 0.5f), t, 2 * t));
    if (dmg_chance(b, 0.35f)) dmg_rest(b, lid, far * dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

/* Draws what looks like a flap and is none: a front that goes up in grooves, or one that pulls its tray out. */
static void draw_pulled_front(dmg_builder* b, const bin* n) {
    float z = 0.5f * n->depth, t = n->wall, inner = n->width - 2.1f * t, h = n->height;
    bin square = *n;
    square.round = t;
    draw_bin_case(b, &square, true);
    bool tray = dmg_chance(b, 0.5f);
    uint32_t front = dmg_slide(b, 0, tray ? "drawer" : "front", tray ? v3(0, 0, 1) : v3(0, 1, 0), 0.0f,
                               tray ? n->depth * dmg_range(b, 0.5f, 0.8f) : 0.85f * h);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * h, tray ? z : z - 1.2f * t);
    if (!tray) dmg_move(b, 0, 0, 2.3f * t);
    dmg_panel panel = dmg_panel_pick(b);
    dmg_panel_draw(b, &panel, tray ? 0.98f * inner : n->width, (tray ? 0.95f : 1.0f) * (h - 2 * t), t);
    dmg_handle grip = dmg_handle_pick(b, 0.3f * h);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &grip, 0.6f * inner);
    dmg_restore(b);
    dmg_move(b, 0, 1.1f * t - 0.5f * h, -t);
    if (tray) dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.95f * inner, 0.6f * h, 0.85f * n->depth, t);
    dmg_restore(b);
    if (dmg_chance(b, 0.3f)) dmg_rest(b, front, 0.3f * h);
    dmg_use(b, 0);
    for (int s = -1; s <= 1 && !tray; s += 2)
        dmg_box_span(b, v3((float)s * (0.5f * n->width + 0.6f * t) - 0.5f * t, 0, z - t),
                     v3((float)s * (0.5f * n->width + 0.6f * t) + 0.5f * t, h, z + 2.4f * t));
}

void dmg_build_bread_bin(dmg_builder* b) {
    bin n = {.width = dmg_scale_range(b, 0.2f, 0.6f)};
    n.depth = n.width * dmg_range(b, 0.4f, 0.9f);
    n.height = n.width * dmg_range(b, 0.35f, 0.8f);
    n.wall = n.width * dmg_range(b, 0.01f, 0.04f);
    n.round = fminf(n.depth, n.height) * dmg_range(b, 0.1f, 0.6f);
    static const float weights[] = {2.5f, 2, 2, 1};
    int kind = dmg_weighted(b, weights, 4), tiers = kind < 2 && dmg_chance(b, 0.2f) ? 2 : 1;
    float foot = dmg_chance(b, 0.3f) ? 0.04f * n.height : 0.0f;
    if (foot > 0.0f) dmg_feet_draw(b, 3, n.width, n.depth, foot);
    for (int i = 0; i < tiers; ++i) {
        dmg_save(b);
        dmg_move(b, 0, foot + (float)i * n.height, 0);
        if (kind == 0) draw_roll_front(b, &n);
        if (kind == 1) draw_drop_front(b, &n);
        if (kind == 2) draw_bent_lid(b, &n);
        if (kind == 3) draw_pulled_front(b, &n);
        dmg_restore(b);
    }
}
