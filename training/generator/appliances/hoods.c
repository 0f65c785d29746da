/* Draws barbecues and food warmers: lids and hoods that turn up, back or round over bowls, drums, boxes and trays. */
#include "core/arcs.h"
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a bar across on two posts, on y = 0, facing up. */
static void draw_grip(dmg_builder* b, float room) {
    dmg_handle grip = dmg_handle_pick_bar(b, 0.3f * room);
    dmg_save(b);
    dmg_face_up(b);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &grip, room);
    dmg_restore(b);
}

typedef struct grill {
    float width, depth, wall;
} grill;

/* From y = 0 up to `height`: short feet, splayed legs on wheels, a cabinet, a post. */
static void draw_grill_stand(dmg_builder* b, const grill* g, float height, int kind) {
    float leg = 0.03f * g->depth, wheel = dmg_chance(b, 0.5f) ? 0.12f * g->depth : 0.0f;
    if (kind == 0) dmg_feet_draw(b, 3, 0.6f * g->width, 0.6f * g->depth, height);
    int legs = g->width > 1.3f * g->depth ? 4 : 3;
    for (int i = 0; i < legs && kind == 1; ++i) {
        float angle = 2.0f * DMG_PI * ((float)i + 0.5f) / (float)legs,
              x = 0.4f * g->width * cosf(angle) * (legs == 4 ? 1.3f : 1.0f),
              z = 0.45f * g->depth * sinf(angle) * (legs == 4 ? 1.2f : 1.0f);
        bool rolls = wheel > 0.0f && x > 0.05f * g->width;
        dmg_use(b, 0);
        dmg_beam(b, v3(0.8f * x, height, 0.7f * z), v3(x, rolls ? wheel : 0.0f, z), leg, leg);
        if (!rolls) continue;
        dmg_spin(b, 0, "wheel", v3(x + 2 * leg, wheel, z), v3(1, 0, 0));
        dmg_save(b);
        dmg_move(b, x + 2 * leg, wheel, z);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, dmg_int(b, 0, DMG_WHEEL_KINDS - 1), wheel, 2 * leg, 6);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (kind == 1 && dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0.4f * height, 0), v3(0.6f * g->width, leg, 0.55f * g->depth));
    if (kind == 2) {
        float w = 0.95f * g->width, d = 0.8f * g->depth;
        int doors = w > d ? 2 : 1;
        dmg_leaf leaf = dmg_leaf_pick(b, 0.2f * height);
        leaf.width = 0.97f * w / (float)doors;
        leaf.height = 0.9f * height;
        leaf.thickness = 0.03f * d;
        dmg_save(b);
        dmg_move(b, 0, 0.5f * height, 0.5f * d);
        dmg_case_draw(b, dmg_case_pick(b), w, height, d, 0.02f * w);
        for (int i = 0; i < doors; ++i) {
            leaf.side = i == 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
            dmg_save(b);
            dmg_move(b, doors == 1 ? 0.0f : w * ((float)i - 0.5f) * 0.5f, 0, leaf.thickness);
            dmg_leaf_draw(b, 0, "door", &leaf);
            dmg_restore(b);
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
    if (kind == 3) {
        dmg_rod(b, v3(0, 0, 0), v3(0, height, 0), 0.08f * g->depth);
        dmg_cone(b, v3(0, 0, 0), v3(0, 0.06f * height, 0), 0.35f * g->depth, 0.25f * g->depth);
    }
}

/* Shelves at both ends; some fold down about a line beside the body. */
static void draw_side_tables(dmg_builder* b, const grill* g, float up) {
    float length = g->width * dmg_range(b, 0.25f, 0.5f), t = g->wall * dmg_range(b, 1.0f, 3.0f);
    bool folds = dmg_chance(b, 0.6f);
    static const float through[] = {0.0f, 0.5f, 1.0f};
    float line = up - t * through[dmg_int(b, 0, 2)];
    for (int s = dmg_chance(b, 0.5f) ? -1 : 1; s <= 1; s += 2) {
        float side = (float)s, x = side * (0.5f * g->width + 0.6f * t);
        if (folds) dmg_hinge(b, 0, "table", v3(x, line, 0), v3(0, 0, -side), 0.0f, dmg_range(b, 1.3f, 1.57f));
        dmg_box(b, v3(x + 0.5f * side * length, up - 0.5f * t, 0), v3(length, t, 0.75f * g->depth));
        if (dmg_chance(b, 0.4f))
            dmg_box(b, v3(x + side * 0.95f * length, up - t, 0), v3(0.04f * length, t, 0.7f * g->depth));
        dmg_use(b, 0);
    }
}

/* Draws a dome or a flat-topped lid over a bowl, both turned; the rim is y = 0. */
static void draw_bowl_half(dmg_builder* b, float r, float rise, float wall, float power) {
    dmg_xy profile[2 * DMG_ARC];
    for (int i = 0; i < DMG_ARC; ++i) {
        float angle = 0.5f * DMG_PI * (float)i / (DMG_ARC - 1), c = powf(cosf(angle), power),
              s = powf(sinf(angle), power);
        c = i + 1 == DMG_ARC ? 0.0f : c;
        profile[i] = (dmg_xy){r * c, rise * s};
        profile[2 * DMG_ARC - 1 - i] =
            (dmg_xy){fmaxf(r - wall, 0.0f) * c, (fabsf(rise) - wall) * s * copysignf(1.0f, rise)};
    }
    if (rise < 0.0f) /* a solid's profile goes up outside */
        for (int i = 0; i < DMG_ARC; ++i) {
            dmg_xy swap = profile[i];
            profile[i] = profile[2 * DMG_ARC - 1 - i];
            profile[2 * DMG_ARC - 1 - i] = swap;
        }
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 2 * DMG_ARC);
}

/* Draws a disc that turns on top of a lid, a little off its middle, to let smoke out. */
static void draw_vent(dmg_builder* b, uint32_t lid, float r, float rise) {
    float size = 0.16f * r;
    dmg_hinge(b, lid, "vent", v3(0, rise, 0), v3(0, 1, 0), 0.0f, dmg_range(b, 0.5f, 1.6f));
    dmg_rod(b, v3(0, rise - 0.01f * r, 0), v3(0, rise + 0.02f * r, 0), size);
    dmg_box(b, v3(0.9f * size, rise + 0.03f * r, 0), v3(0.5f * size, 0.05f * r, 0.25f * size));
    dmg_use(b, lid);
}

static void draw_round_grill(dmg_builder* b, const grill* g) {
    float r = 0.5f * g->depth, bowl = r * dmg_range(b, 0.4f, 1.2f), rise = r * dmg_range(b, 0.3f, 1.0f),
          power = dmg_range(b, 0.6f, 1.0f);
    bool egg = bowl > 0.8f * r && dmg_chance(b, 0.5f), table = dmg_chance(b, 0.25f);
    float height = table ? 0.3f * r : r * dmg_range(b, 1.0f, 2.2f);
    draw_grill_stand(b, g, height + 0.5f * bowl, table ? 0 : (dmg_chance(b, 0.8f) ? 1 : 3));
    dmg_move(b, 0, height + bowl, 0);
    draw_bowl_half(b, r, -bowl, g->wall, power);
    /* The line: on the rim's skin, on lugs behind it, on a long bracket above it. */
    float out = dmg_chance(b, 0.35f) ? 0.0f : r * dmg_range(b, 0.03f, egg ? 0.3f : 0.2f),
          up = dmg_chance(b, 0.5f) ? 0.0f : r * dmg_range(b, 0.0f, 0.12f);
    float lug = r * dmg_range(b, 0.1f, 0.5f), pin = r * dmg_range(b, 0.015f, 0.04f), far = dmg_range(b, 1.1f, 1.7f);
    for (int s = -1; s <= 1 && out > 0.0f; s += 2)
        dmg_box_span(b, v3((float)s * lug - pin, -3 * pin, -r - out - pin),
                     v3((float)s * lug + pin, up + 1.5f * pin, 3 * pin - 0.96f * r));
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, up, -r - out), v3(-1, 0, 0), 0.0f, far);
    dmg_move(b, 0, 0.005f * r, 0);
    draw_bowl_half(b, r, rise, g->wall, power);
    if (out > 0.0f || dmg_chance(b, 0.5f)) {
        dmg_rod(b, v3(-1.2f * lug, up, -r - out), v3(1.2f * lug, up, -r - out), pin);
        dmg_box_span(b, v3(-0.8f * lug, up, -r - out - 0.5f * pin), v3(0.8f * lug, up + pin, -0.9f * r));
    }
    if (egg) dmg_torus(b, v3(0, 2 * pin, 0), v3(0, 1, 0), r, pin);
    if (dmg_chance(b, 0.5f)) draw_vent(b, lid, r, rise);
    bool front = dmg_chance(b, 0.5f);
    dmg_save(b);
    if (front) {
        dmg_move(b, 0, 0.35f * rise, 0.98f * r * cosf(0.36f));
        dmg_turn(b, v3(1, 0, 0), 1.2f);
    } else {
        dmg_move(b, 0, rise, 0.3f * r);
        dmg_turn(b, v3(1, 0, 0), 0.3f);
    }
    draw_grip(b, 0.5f * r);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, lid, far * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, 0);
    if (!table && dmg_chance(b, 0.4f)) { /* the lever of the ash sweep */
        float way = dmg_sign(b);
        dmg_hinge(b, 0, "lever", v3(0, -bowl, 0), v3(0, way, 0), 0.0f, dmg_range(b, 0.5f, 1.2f));
        dmg_beam(b, v3(0, -1.04f * bowl, 0), v3(0.3f * r, -1.04f * bowl, 0.5f * r), 0.05f * r, 0.03f * r);
        dmg_use(b, 0);
    }
}

/* Draws a drum lying along X: two halves, or a door cut out of its skin. */
static void draw_drum_grill(dmg_builder* b, const grill* g) {
    float r = 0.5f * g->depth, height = r * dmg_range(b, 0.4f, 2.0f),
          tilt = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -0.3f, 0.3f);
    float from = tilt, to = tilt + DMG_PI, off = dmg_chance(b, 0.4f) ? 0.0f : g->wall * dmg_range(b, 0.3f, 2.0f);
    bool cut = dmg_chance(b, 0.4f), below = cut && dmg_chance(b, 0.25f);
    if (cut) {
        from = dmg_range(b, -0.4f, 0.4f);
        to = from + dmg_range(b, 1.2f, 2.2f);
    }
    draw_grill_stand(b, g, height + (cut ? 0.1f : 0.2f) * r, height < r ? 0 : 1);
    dmg_move(b, 0, height + r, 0);
    draw_side_tables(b, g, -0.1f * r);
    float door = cut ? g->width * dmg_range(b, 0.6f, 0.85f) : g->width, turn = 2.0f * DMG_PI;
    dmg_arc_skin(b, r, to, from + turn, g->wall, g->width);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.5f * (g->width - g->wall);
        dmg_arc_cheek(b, r, cut ? 0 : to, turn * (cut ? 1.0f : 0.0f) + (cut ? 0.0f : from + turn), x, g->wall, false);
        if (cut) { /* what is left beside the door */
            dmg_save(b);
            dmg_move(b, (float)s * 0.25f * (g->width + door), 0, 0);
            dmg_arc_skin(b, r, from, to, g->wall, 0.5f * (g->width - door));
            dmg_restore(b);
        }
    }
    float at = below ? from : to, pin = g->wall * dmg_range(b, 0.5f, 1.5f);
    dmg_vec line = {0, (r + off) * sinf(at), (r + off) * cosf(at)};
    float far = below ? dmg_range(b, 1.2f, 2.2f) : fminf(dmg_range(b, 1.0f, 1.9f), to < 2.4f ? 1.6f : 1.9f);
    bool barrel = dmg_chance(b, 0.6f);
    if (barrel) dmg_rod(b, v3(-0.45f * door, line.y, line.z), v3(0.1f * door, line.y, line.z), pin);
    uint32_t lid = dmg_hinge(b, 0, cut ? "door" : "lid", line, v3(below ? 1.0f : -1.0f, 0, 0), 0.0f, far);
    if (barrel) dmg_rod(b, v3(0.11f * door, line.y, line.z), v3(0.45f * door, line.y, line.z), pin);
    dmg_arc_skin(b, r + (cut ? 0.1f * g->wall : 0.0f), from, to, g->wall, 0.998f * door);
    for (int s = -1; s <= 1 && !cut; s += 2)
        dmg_arc_cheek(b, r, from, to, (float)s * 0.5f * (g->width - g->wall), g->wall, false);
    float where = below ? to - 0.15f * (to - from) : from + 0.2f * (to - from);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI - where);
    dmg_move(b, 0, r + 0.4f * g->wall, 0);
    draw_grip(b, 0.6f * door);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, lid, far * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, 0);
    if (dmg_chance(b, 0.4f)) { /* its chimney has a cap that turns */
        float x = 0.5f * g->width + 0.2f * r;
        dmg_rod(b, v3(x, 0.4f * r, -0.4f * r), v3(x, 1.8f * r, -0.4f * r), 0.15f * r);
        dmg_box(b, v3(x - 0.1f * r, 0.5f * r, -0.4f * r), v3(0.3f * r, 0.2f * r, 0.2f * r));
        dmg_hinge(b, 0, "damper", v3(x + 0.14f * r, 0, -0.4f * r), v3(0, 1, 0), 0.0f, dmg_range(b, 0.8f, 2.0f));
        dmg_rod(b, v3(x, 1.81f * r, -0.4f * r), v3(x, 1.86f * r, -0.4f * r), 0.19f * r);
        dmg_use(b, 0);
    }
}

/* Draws a hood with cheeks over a box of burners: pins through the cheeks, in from its rear edge. */
static void draw_hood_grill(dmg_builder* b, const grill* g) {
    float d = g->depth, rise = d * dmg_range(b, 0.35f, 0.7f), box = d * dmg_range(b, 0.25f, 0.5f),
          height = d * dmg_range(b, 0.1f, 1.4f), z = 0.5f * d;
    draw_grill_stand(b, g, height, height < 0.4f * d ? 0 : dmg_int(b, 1, 2));
    const dmg_xy trough[] = {{-0.8f * z, 0}, {0.8f * z, 0}, {z, box}, {-z, box}};
    dmg_move(b, 0, height, 0);
    dmg_profile_begin(b);
    dmg_extrude(b, trough, 4, -0.5f * g->width, 0.5f * g->width);
    dmg_restore(b);
    draw_side_tables(b, g, 0.95f * box);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * box, 0.92f * z);
    dmg_turn(b, v3(1, 0, 0), -0.2f);
    dmg_box(b, v3(0, 0, 0), v3(0.98f * g->width, 0.6f * box, 0.16f * z));
    dmg_move(b, 0, 0, 0.08f * z);
    float knob = 0.16f * box;
    dmg_knobs_draw(b, 0, dmg_int(b, 1, 5), 0.17f * g->width, 0, fminf(knob, 0.07f * g->width));
    dmg_restore(b);
    dmg_move(b, 0, box, 0);
    float in = dmg_chance(b, 0.4f) ? 0.0f : d * dmg_range(b, 0.02f, 0.16f),
          up = fmaxf(in, 0.02f * d) * dmg_range(b, 1.0f, 1.6f), brow = dmg_range(b, 0.3f, 0.9f),
          far = dmg_range(b, 1.0f, 1.5f);
    dmg_vec line = {0, up, in - z};
    const dmg_xy skin[] = {{z, 0.01f * d},   {0.98f * z, 0.4f * rise}, {brow * z, 0.85f * rise},
                           {0.2f * z, rise}, {-0.7f * z, rise},        {-z, 0.75f * rise},
                           {-z, up}};
    for (int s = -1; s <= 1; s += 2) /* posts for the pins, inside or outside the cheeks */
        dmg_box(b, v3((float)s * 0.485f * g->width, 0.5f * up, line.z), v3(0.02f * g->width, up, 0.05f * d));
    uint32_t lid = dmg_hinge(b, 0, "hood", line, v3(-1, 0, 0), 0.0f, far);
    dmg_profile_begin(b);
    dmg_bent_plate(b, skin, 7, g->wall, g->width);
    for (int s = -1; s <= 1; s += 2) {
        float x = 0.5f * (float)s * (g->width - g->wall);
        dmg_xy cheek[8];
        for (int i = 0; i < 7; ++i) cheek[i] = skin[i];
        cheek[7] = (dmg_xy){fminf(in, 0.4f * d) - 0.9f * z, 0.01f * d};
        dmg_extrude(b, cheek, 8, x - 0.5f * g->wall, x + 0.5f * g->wall);
    }
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) /* their heads show on the outside */
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3((float)s * 0.49f * g->width, line.y, line.z), v3((float)s * 0.52f * g->width, line.y, line.z),
                    0.02f * d);
    dmg_save(b);
    dmg_move(b, 0, 0.3f * rise, 0.99f * z);
    dmg_turn(b, v3(1, 0, 0), 0.45f * DMG_PI);
    draw_grip(b, 0.8f * g->width);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0.6f * rise, 0.8f * z), v3(0, 0.62f * rise, 0.95f * z), 0.1f * rise);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, lid, far * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, 0);
}

/* Part of a ball about X through the origin, as thick as `wall`. */
static void draw_ball_skin(dmg_builder* b, float r, float from, float to, float wall, float squeeze) {
    dmg_xy profile[2 * DMG_ARC];
    for (int i = 0; i < DMG_ARC; ++i) {
        float angle = DMG_PI * (0.03f + 0.94f * (float)i / (DMG_ARC - 1));
        profile[i] = (dmg_xy){r * sinf(angle), -squeeze * r * cosf(angle)};
        profile[2 * DMG_ARC - 1 - i] = (dmg_xy){(r - wall) * sinf(angle), -squeeze * (r - wall) * cosf(angle)};
    }
    /* Its angles go from +Y to +Z. */
    dmg_lathe_arc(b, v3(0, 0, 0), v3(1, 0, 0), profile, 2 * DMG_ARC, 0.5f * DMG_PI - to, to - from);
}

/* Draws a hood that rolls about the pins in the middle of its ends, over or under a fixed half. */
static void draw_roll_dish(dmg_builder* b, const grill* g) {
    float r = 0.5f * g->depth, tray = r * dmg_range(b, 0.2f, 0.7f), foot = r * dmg_range(b, 0.2f, 0.6f), t = g->wall;
    bool ball = dmg_chance(b, 0.4f), half = dmg_chance(b, 0.5f), under = dmg_chance(b, 0.5f);
    float squeeze = ball ? dmg_range(b, 0.8f, 1.2f) : 1.0f, width = ball ? 2 * squeeze * r : g->width;
    float to = half ? 0.5f * DMG_PI : DMG_PI, far = half ? dmg_range(b, 1.2f, 1.5f) : dmg_range(b, 1.2f, 2.4f),
          apart = 1.3f * t;
    /* What goes down behind must not reach the ground. */
    if (!half && foot + tray < r) far = fminf(far, asinf((foot + tray) / r));
    float under_tray = foot + (ball ? 0.2f : 0.0f) * tray;
    dmg_feet_draw(b, dmg_int(b, 0, 1) * 3, (ball ? 0.7f : 0.9f) * width, (half && !ball ? 1.6f : 1.1f) * r, under_tray);
    dmg_move(b, 0, foot + tray, 0);
    bool open = !half; /* the whole hood goes down behind the tray: it must be narrower than that */
    float inner = open ? 0.93f * r : r;
    if (ball)
        draw_bowl_half(b, open ? 0.9f * inner : r, -tray, t, 0.8f);
    else
        dmg_box(b, v3(0, -0.5f * tray, 0), v3(open ? 0.94f * width : width, tray, 2 * (open ? 0.9f * inner : r)));
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (0.5f * width + 1.5f * t);
        dmg_box_span(b, v3(x - 0.7f * t, -0.5f * tray, -2 * t), v3(x + 0.7f * t, 2 * t, 2 * t));
        if (!ball && open)
            dmg_box_span(b, v3(fminf(x, 0.45f * (float)s * width), -0.5f * tray, -2 * t),
                         v3(fmaxf(x, 0.45f * (float)s * width), -0.5f * tray + 2 * t, 2 * t));
    }
    if (half) {
        float back = under ? r : r - apart;
        if (ball)
            draw_ball_skin(b, back, 0.5f * DMG_PI - 0.05f, DMG_PI, t, squeeze);
        else {
            dmg_arc_skin(b, back, 0.5f * DMG_PI - 0.05f, DMG_PI, t, 0.96f * width);
            for (int s = -1; s <= 1; s += 2)
                dmg_arc_cheek(b, back, 0.5f * DMG_PI, DMG_PI, (float)s * 0.47f * width, t, true);
        }
    }
    float own = half && under ? r - apart : r;
    uint32_t hood = dmg_hinge(b, 0, "hood", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, far);
    if (ball)
        draw_ball_skin(b, own, 0.02f, to, t, squeeze);
    else {
        dmg_arc_skin(b, own, 0.02f, to, t, (half && under ? 0.92f : 1.0f) * width);
        for (int s = -1; s <= 1; s += 2)
            dmg_arc_cheek(b, own, 0.02f, to, (float)s * (half && under ? 0.45f : 0.495f) * width, t, true);
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.47f * width, 0, 0), v3((float)s * (0.5f * width + 3 * t), 0, 0), 1.2f * t);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI - 0.15f);
    dmg_move(b, 0, own, 0);
    draw_grip(b, (ball ? 0.4f : 0.7f) * width);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, hood, far * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, 0);
}

void dmg_build_grill(dmg_builder* b) {
    grill g = {.depth = dmg_scale_range(b, 0.2f, 0.8f)};
    int kind = dmg_int(b, 0, 3);
    g.width = kind == 0 ? g.depth : g.depth * dmg_range(b, 1.0f, 2.6f);
    g.wall = g.depth * dmg_range(b, 0.01f, 0.035f);
    if (kind == 0) draw_round_grill(b, &g);
    if (kind == 1) draw_drum_grill(b, &g);
    if (kind == 2) draw_hood_grill(b, &g);
    if (kind == 3) draw_roll_dish(b, &g);
}
