/* Draws kerbside machines: petrol pumps old and new, charging pillars, parking meters, ticket machines. Nozzles come
 * out of their boots, triggers are squeezed, flaps and doors open. The customer stands at +Z. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- nozzles and plugs: they come up along +y out of a boot at the origin ---- */

static void draw_trigger(dmg_builder* b, uint32_t nozzle, float h, float r, float bend, float length) {
    dmg_vec along = {0, cosf(bend), sinf(bend)}, out = {0, -sinf(bend), cosf(bend)};
    dmg_vec foot = {0, 0.75f * h, 0.8f * r}, pin = v3_mad(foot, out, 0.8f * r);
    dmg_use(b, nozzle);
    dmg_rod(b, v3_add(pin, v3(-0.7f * r, 0, 0)), v3_add(pin, v3(0.7f * r, 0, 0)), 0.2f * r);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.6f * r, foot.y, 0), v3_add(pin, v3((float)s * 0.6f * r, 0, 0)), 0.15f * r,
                 0.6f * r);
    if (dmg_chance(b, 0.6f)) { /* a bow that guards it */
        dmg_vec end = v3_mad(v3(0, h, 0), along, length);
        const dmg_vec path[] = {v3_mad(pin, out, 0.2f * r), v3_mad(v3_mad(pin, out, 2.2f * r), along, 0.3f * length),
                                v3_mad(v3_mad(end, out, 2.2f * r), along, -0.25f * length), end};
        dmg_sweep(b, path, 4, 0.2f * r, 0.2f * r, false);
    }
    dmg_hinge(b, nozzle, "trigger", pin, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.15f, 0.35f));
    dmg_beam(b, pin, v3_mad(v3_mad(pin, along, 0.7f * length), out, 0.5f * r), 0.9f * r, 0.25f * r);
    dmg_use(b, 0);
}

/* Draws a pistol for petrol: spout, body, grip bent out to the customer. */
static void draw_nozzle(dmg_builder* b, uint32_t parent, float r) {
    float h = r * dmg_range(b, 2.5f, 4.0f), deep = r * dmg_range(b, 2.5f, 5.0f), bend = dmg_range(b, 0.2f, 1.0f),
          length = r * dmg_range(b, 4.0f, 7.0f);
    int boot = dmg_int(b, 0, 2);
    const dmg_xy tube[] = {{0.75f * r, -1.05f * deep},
                           {1.3f * r, -1.05f * deep},
                           {1.5f * r, 0},
                           {0.95f * r, 0},
                           {0.75f * r, -1.05f * deep}};
    dmg_use(b, parent);
    if (boot == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), tube, 5);
    for (int s = -1; s <= 1 && boot == 1; s += 2)
        dmg_box_span(b, v3((float)s * 1.5f * r - 0.3f * r, -deep, -1.5f * r),
                     v3((float)s * 1.5f * r + 0.3f * r, 0.6f * h, 1.2f * r));
    if (boot == 1) dmg_box_span(b, v3(-1.8f * r, -deep, -1.8f * r), v3(1.8f * r, 0.6f * h, -1.3f * r));
    if (boot == 2) dmg_torus(b, v3(0, -0.2f * r, 0), v3(0, 1, 0), 1.2f * r, 0.25f * r);
    uint32_t nozzle = dmg_slide(b, parent, "nozzle", v3(0, 1, 0), 0.0f, deep * dmg_range(b, 1.0f, 2.0f));
    dmg_cone(b, v3(0, -0.95f * deep, 0), v3(0, 0, 0), 0.4f * r, 0.6f * r);
    dmg_rounded_box(b, v3(0, 0.5f * h, 0), v3(1.7f * r, h, 1.8f * r), 0.4f * r);
    dmg_rod(b, v3(0, 0.9f * h, 0), v3(0, h + length * cosf(bend), length * sinf(bend)), 0.6f * r);
    if (dmg_chance(b, 0.8f)) draw_trigger(b, nozzle, h, r, bend, length);
    dmg_use(b, 0);
}

/* Draws a plug for a car's battery: a round or flat nose in a socket, its grip bent away, a latch to press on it. */
static void draw_plug(dmg_builder* b, float r) {
    float deep = r * dmg_range(b, 0.8f, 1.5f), bend = dmg_range(b, 0.3f, 1.3f), length = r * dmg_range(b, 2.5f, 4.5f);
    const dmg_xy socket[] = {{0.9f * r, -1.05f * deep},
                             {1.2f * r, -1.05f * deep},
                             {1.25f * r, 0.1f * r},
                             {0.9f * r, 0.1f * r},
                             {0.9f * r, -1.05f * deep}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), socket, 5);
    uint32_t plug = dmg_slide(b, 0, "plug", v3(0, 1, 0), 0.0f, deep * dmg_range(b, 1.0f, 2.5f));
    dmg_rod(b, v3(0, -deep, 0), v3(0, 0.6f * r, 0), 0.85f * r);
    dmg_vec end = {0, 0.6f * r + length * cosf(bend), length * sinf(bend)};
    dmg_capsule(b, v3(0, 0.6f * r, 0), end, 0.65f * r);
    if (dmg_chance(b, 0.6f)) {
        dmg_vec key = v3_lerp(v3(0, 0.6f * r, 0), end, 0.35f), up = {0, sinf(bend), -cosf(bend)};
        dmg_slide(b, plug, "latch_key", v3_scale(up, -1), 0.0f, 0.12f * r);
        dmg_beam(b, v3_mad(key, up, 0.5f * r), v3_mad(key, up, 0.9f * r), 0.5f * r, 0.6f * r);
    }
    dmg_use(b, 0);
}

/* ---- what is on a face: z = 0, within width x high ---- */

/* Draws a flap before a tray: hung at its top, pushed in or pulled up; or at its foot. */
static void draw_tray_flap(dmg_builder* b, uint32_t parent, const char* name, float width, float high) {
    float t = 0.06f * high, rim = 0.1f * high;
    int way = dmg_int(b, 0, 2);
    dmg_use(b, parent);
    dmg_frame_draw(b, width + 2 * rim, high + 2 * rim, way == 0 ? 0.7f * high : 2 * t, rim);
    dmg_save(b);
    dmg_move(b, 0, 0, 2.2f * t);
    if (way == 0) { /* in: the frame stands out so far that there is room behind */
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.5f * width - rim, -0.5f * high - rim, -2 * t),
                         v3((float)s * 0.5f * width + rim, 0.5f * high + rim, 0.9f * high));
        dmg_box_span(b, v3(-0.5f * width, 0.5f * high, -2 * t), v3(0.5f * width, 0.5f * high + rim, 0.9f * high));
        dmg_hinge(b, parent, name, v3(0, 0.48f * high, 0.85f * high), v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.2f));
        dmg_box_span(b, v3(-0.5f * width + 1.1f * rim, -0.5f * high, 0.85f * high - t),
                     v3(0.5f * width - 1.1f * rim, 0.48f * high, 0.85f * high));
    } else {
        float y = way == 1 ? 0.5f * high : -0.5f * high;
        dmg_hinge(b, parent, name, v3(0, y, 0.5f * t), v3(way == 1 ? -1.0f : 1.0f, 0, 0), 0.0f,
                  dmg_range(b, 0.7f, 1.7f));
        dmg_box_span(b, v3(-0.5f * width, -0.5f * high, 0), v3(0.5f * width, 0.5f * high, t));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, -0.8f * y, 1.4f * t), v3(0.4f * width, 0.12f * high, t));
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Rows from top to bottom: a screen, keys, slots for coins and cards with a key to get them back, a tray. */
static void draw_pay_face(dmg_builder* b, uint32_t parent, float width, float high) {
    float y = 0.5f * high, w = 0.8f * width;
    int rows = dmg_int(b, 2, 4);
    for (int i = 0; i < rows; ++i) {
        float own = high / (float)rows, mid = y - 0.5f * own;
        int kind = i == rows - 1 && dmg_chance(b, 0.7f) ? 3 : dmg_int(b, 0, 3);
        dmg_use(b, parent);
        dmg_save(b);
        dmg_move(b, 0, mid, 0);
        if (kind == 0) {
            dmg_frame_draw(b, w, 0.8f * own, 0.04f * w, 0.06f * w);
            dmg_box(b, v3(0, 0, 0.01f * w), v3(0.85f * w, 0.66f * own, 0.02f * w));
        }
        if (kind == 1) {
            float key = 0.6f * fminf(own, w);
            int columns = dmg_int(b, 2, 4), lines = dmg_int(b, 1, 4);
            dmg_buttons keys = {.name = "key", .columns = columns, .rows = lines, .rise = 0.04f * key};
            keys.pitch_x = key / (float)keys.columns;
            keys.pitch_y = fminf(key / (float)keys.rows, keys.pitch_x);
            keys.width = 0.7f * keys.pitch_x;
            keys.height = 0.7f * keys.pitch_y;
            keys.travel = dmg_button_way(b, keys.rise);
            keys.kind = dmg_int(b, 0, 3);
            dmg_buttons_draw(b, parent, &keys);
        }
        if (kind == 2) {
            dmg_box(b, v3(-0.25f * w, 0, 0.02f * w), v3(0.28f * w, 0.25f * own, 0.04f * w));
            float r = 0.12f * fminf(w, own);
            dmg_save(b);
            dmg_move(b, 0.25f * w, 0, 0);
            if (dmg_chance(b, 0.5f)) {
                dmg_knobs_draw(b, parent, 1, 0, 0, r);
            } else { /* gives the coins back */
                dmg_buttons one = {.name = "return_key", .columns = 1, .rows = 1, .width = 2 * r, .height = 1.6f * r};
                one.rise = r * dmg_range(b, 0.2f, 0.8f);
                one.travel = dmg_button_way(b, one.rise);
                one.kind = dmg_int(b, 0, 3);
                dmg_buttons_draw(b, parent, &one);
            }
            dmg_restore(b);
        }
        if (kind == 3) draw_tray_flap(b, parent, "tray_flap", 0.5f * w, fminf(0.5f * own, 0.4f * w));
        dmg_restore(b);
        y -= own;
    }
    dmg_use(b, parent);
}

/* Draws a service door in the lower face, drawn round the origin. */
static void draw_service_door(dmg_builder* b, float width, float high) {
    dmg_leaf leaf = dmg_leaf_pick(b, 0.12f);
    leaf.width = width;
    leaf.height = high;
    leaf.thickness = 0.03f * width;
    leaf.side = dmg_chance(b, 0.8f) ? (dmg_side)dmg_int(b, 0, 1) : DMG_SIDE_TOP;
    leaf.swing = fminf(leaf.swing, 2.0f);
    dmg_save(b);
    dmg_move(b, 0, 0, 1.02f * leaf.thickness);
    dmg_leaf_draw(b, 0, "service_door", &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- petrol pumps ---- */

/* Nozzles in a row on the face, or at the sides. */
static void draw_nozzles(dmg_builder* b, float width, float deep, float y, int count, bool sides) {
    float r = fminf(dmg_range(b, 0.018f, 0.034f), 0.1f * width), lean = dmg_range(b, 0.1f, 0.6f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        if (sides) {
            dmg_turn(b, v3(0, 1, 0), i & 1 ? -0.5f * DMG_PI : 0.5f * DMG_PI);
            dmg_move(b, (i / 2 ? 0.25f : -0.25f) * deep * (count > 2 ? 1.0f : 0.0f), y, 0.5f * width + 2.2f * r);
        } else {
            dmg_move(b, width * (((float)i + 0.5f) / (float)count - 0.5f), y, 0.5f * deep + 3 * r);
        }
        dmg_turn(b, v3(1, 0, 0), lean);
        draw_nozzle(b, 0, r);
        dmg_restore(b);
    }
}

static void draw_modern_pump(dmg_builder* b) {
    float width = dmg_range(b, 0.5f, 1.1f), high = dmg_range(b, 1.2f, 2.2f), deep = width * dmg_range(b, 0.4f, 0.8f),
          foot = dmg_range(b, 0.0f, 0.15f), split = dmg_range(b, 0.45f, 0.62f);
    int count = dmg_int(b, 1, 4), shape = dmg_int(b, 0, 2);
    bool sides = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-0.7f * width, 0, -0.8f * deep), v3(0.7f * width, foot, 0.8f * deep));
    dmg_move(b, 0, foot, 0);
    if (shape == 0) dmg_box(b, v3(0, 0.5f * high, 0), v3(width, high, deep));
    if (shape == 1) dmg_rounded_box(b, v3(0, 0.5f * high, 0), v3(width, high, deep), 0.1f * deep);
    if (shape == 2) { /* a head on two posts over a low body */
        dmg_box(b, v3(0, 0.25f * high, 0), v3(width, 0.5f * high, deep));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.46f * width, 0.6f * high, 0), v3(0.08f * width, 0.3f * high, 0.5f * deep));
        dmg_box(b, v3(0, 0.85f * high, 0), v3(width, 0.3f * high, deep));
        split = 0.68f;
    }
    draw_nozzles(b, width, deep, (shape == 2 ? 0.38f : split - 0.1f) * high, count, sides);
    float face = 0.5f * deep, room = high * (0.96f - split);
    dmg_save(b);
    dmg_move(b, 0, (split + 0.02f) * high + 0.5f * room, face);
    draw_pay_face(b, 0, 0.9f * width, shape == 2 ? fminf(room, 0.26f * high) : room);
    dmg_restore(b);
    if (dmg_chance(b, 0.7f)) {
        float door = high * (shape == 2 || !sides ? 0.2f : 0.35f);
        dmg_save(b);
        dmg_move(b, 0, 0.05f * high + 0.5f * door, face);
        draw_service_door(b, 0.84f * width, door);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.35f)) { /* a sign on top */
        dmg_rod(b, v3(0, high, 0), v3(0, 1.1f * high, 0), 0.03f * width);
        dmg_box(b, v3(0, 1.15f * high, 0), v3(0.8f * width, 0.12f * high, 0.15f * width));
    }
}

/* Draws the lever beside the cradle that starts it, the crank that turns the counters back, the hands on its clock. */
static void draw_old_pump_fittings(dmg_builder* b, float width, float deep, float high) {
    float x = 0.5f * width, y = high * dmg_range(b, 0.4f, 0.6f), swing = dmg_range(b, 0.6f, 1.8f);
    int hands = dmg_int(b, 0, 2);
    if (dmg_chance(b, 0.7f)) {
        dmg_rod(b, v3(-x, y, 0), v3(-x - 0.05f, y, 0), 0.03f);
        dmg_hinge(b, 0, "switch_lever", v3(-x - 0.03f, y, 0), v3(1, 0, 0), -0.5f * swing, 0.5f * swing);
        dmg_box_span(b, v3(-x - 0.045f, y - 0.015f, 0), v3(-x - 0.025f, y + 0.015f, 0.16f));
        dmg_ellipsoid(b, v3(-x - 0.035f, y, 0.17f), v3(0.022f, 0.022f, 0.022f));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.6f)) {
        float up = 0.72f * high, arm = dmg_range(b, 0.06f, 0.14f);
        dmg_spin(b, 0, "reset_crank", v3(-x, up, 0), v3(-1, 0, 0));
        dmg_rod(b, v3(-x + 0.02f, up, 0), v3(-x - 0.05f, up, 0), 0.012f);
        dmg_box_span(b, v3(-x - 0.06f, up - 0.012f, -0.012f), v3(-x - 0.045f, up + arm, 0.012f));
        dmg_rod(b, v3(-x - 0.05f, up + arm, 0), v3(-x - 0.12f, up + arm, 0), 0.014f);
        dmg_use(b, 0);
    }
    float r = 0.36f * width, mid = high * dmg_range(b, 0.74f, 0.8f), z = 0.5f * deep;
    if (hands) dmg_rod(b, v3(0, mid, z), v3(0, mid, z + 0.015f), r);
    for (int i = 0; i < hands; ++i) {
        float front = z + 0.02f + 0.008f * (float)i;
        uint32_t hand = dmg_spin(b, 0, "hand", v3(0, mid, front), v3(0, 0, -1));
        dmg_rest(b, hand, dmg_range(b, 0.0f, 6.2f));
        dmg_box_span(b, v3(-0.05f * r, mid - 0.15f * r, front - 0.004f),
                     v3(0.05f * r, mid + (i ? 0.6f : 0.85f) * r, front + 0.004f));
        dmg_rod(b, v3(0, mid, front - 0.006f), v3(0, mid, front + 0.004f), 0.1f * r);
        dmg_use(b, 0);
    }
}

/* Under a globe: a slim cabinet, a turned column with a clock's face, or a glass cylinder filled by a long lever. */
static void draw_old_pump(dmg_builder* b) {
    float width = dmg_range(b, 0.35f, 0.6f), high = dmg_range(b, 1.4f, 2.0f), deep = width * dmg_range(b, 0.7f, 1.0f),
          globe = width * dmg_range(b, 0.3f, 0.5f);
    bool glass = dmg_chance(b, 0.4f), door = dmg_chance(b, 0.7f);
    dmg_box(b, v3(0, 0.03f, 0), v3(1.2f * width, 0.06f, 1.2f * deep));
    if (glass) {
        float body = 0.55f * high, r = 0.45f * width, reach = dmg_range(b, 0.5f, 0.8f),
              swing = dmg_range(b, 0.4f, 0.8f);
        dmg_box_span(b, v3(-0.5f * width, 0.06f, -0.5f * deep), v3(0.5f * width, body, 0.5f * deep));
        dmg_rod(b, v3(0, body, 0), v3(0, body + 0.05f, 0), 1.1f * r);
        dmg_rod(b, v3(0, body + 0.05f, 0), v3(0, high - 0.05f, 0), 0.9f * r);
        dmg_rod(b, v3(0, high - 0.05f, 0), v3(0, high, 0), 1.1f * r);
        dmg_rod(b, v3(0.5f * width, 0.25f * body, 0), v3(0.5f * width + 0.06f, 0.25f * body, 0), 0.04f);
        uint32_t lever =
            dmg_hinge(b, 0, "pump_lever", v3(0.5f * width + 0.05f, 0.25f * body, 0), v3(1, 0, 0), -swing, swing);
        dmg_rest(b, lever, swing * dmg_range(b, -1.0f, 1.0f));
        dmg_rod(b, v3(0.5f * width + 0.05f, 0.25f * body, 0), v3(0.5f * width + 0.05f, 0.25f * body + reach, 0),
                0.015f);
        dmg_use(b, 0);
    } else {
        dmg_rounded_box(b, v3(0, 0.5f * high, 0), v3(width, high, deep), dmg_range(b, 0.01f, 0.3f) * width);
        draw_old_pump_fittings(b, width, deep, high);
    }
    dmg_rod(b, v3(0, high - 0.02f, 0), v3(0, high + 0.06f, 0), 0.4f * globe);
    if (dmg_chance(b, 0.7f))
        dmg_ellipsoid(b, v3(0, high + 0.05f + 0.8f * globe, 0),
                      v3(globe, globe, dmg_chance(b, 0.5f) ? globe : 0.4f * globe));
    if (door) {
        dmg_save(b);
        dmg_move(b, 0, 0.28f * high, 0.5f * deep);
        draw_service_door(b, 0.75f * width, 0.35f * high);
        dmg_restore(b);
    }
    draw_nozzles(b, width, deep, (glass ? 0.45f : 0.55f) * high, dmg_chance(b, 0.8f) ? 1 : 2, true);
}

/* Draws a pillar or a box on the wall, plugs at its sides or front, a flap over a socket. */
static void draw_charger(dmg_builder* b) {
    bool pillar = dmg_chance(b, 0.65f);
    float high = pillar ? dmg_range(b, 1.1f, 2.0f) : dmg_range(b, 0.3f, 0.6f),
          width = pillar ? dmg_range(b, 0.2f, 0.6f) : high * dmg_range(b, 0.5f, 1.0f),
          deep = width * dmg_range(b, 0.3f, 0.9f), r = fminf(0.035f, 0.12f * width);
    int plugs = dmg_int(b, 1, 2), where = dmg_int(b, 0, 1), round = dmg_int(b, 0, 2);
    if (round == 0)
        dmg_box(b, v3(0, 0.5f * high, 0), v3(width, high, deep));
    else
        dmg_rounded_box(b, v3(0, 0.5f * high, 0), v3(width, high, deep),
                        (round == 1 ? 0.12f : 0.35f) * fminf(deep, width));
    for (int i = 0; i < plugs; ++i) {
        float lean = where ? dmg_range(b, 0.3f, 0.9f) : dmg_range(b, 0.9f, 1.57f);
        dmg_save(b);
        if (where) dmg_turn(b, v3(0, 1, 0), i ? -0.5f * DMG_PI : 0.5f * DMG_PI);
        float x = where || plugs == 1 ? 0.0f : (i ? 0.25f : -0.25f) * width;
        dmg_move(b, x, 0.5f * high, where ? 0.5f * width + r : 0.5f * deep + r);
        dmg_turn(b, v3(1, 0, 0), lean);
        draw_plug(b, r);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.6f)) {
        dmg_save(b);
        dmg_move(b, 0, 0.75f * high, 0.5f * deep);
        draw_pay_face(b, 0, 0.9f * width, 0.3f * high);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.6f)) { /* a socket under its own lid */
        float s = 2.2f * r, y = (pillar ? 0.3f : 0.22f) * high, z = 0.5f * deep;
        dmg_rod(b, v3(0, y, z), v3(0, y, z + 0.5f * r), 0.7f * s);
        dmg_hinge(b, 0, "socket_lid", v3(0, y + 0.75f * s, z + 0.55f * r), v3(-1, 0, 0), 0.0f,
                  dmg_range(b, 1.0f, 2.4f));
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(0, y, z + 0.52f * r), v3(0, y, z + 0.75f * r), 0.75f * s);
        else
            dmg_box_span(b, v3(-0.75f * s, y - 0.75f * s, z + 0.52f * r), v3(0.75f * s, y + 0.75f * s, z + 0.75f * r));
        dmg_use(b, 0);
    }
}

/* ---- parking meters and ticket machines ---- */

/* Draws the head about the origin: a D standing on its flat side, a drum, a box under a roof. */
static void draw_meter_head(dmg_builder* b, float w) {
    enum { ARC = 11 };
    dmg_xy outline[ARC + 2];
    float h = w * dmg_range(b, 0.4f, 1.0f), deep = w * dmg_range(b, 0.5f, 0.8f), z = 0.5f * deep;
    for (int i = 0; i < ARC; ++i) {
        float angle = DMG_PI * (float)i / (ARC - 1);
        outline[i] = (dmg_xy){0.5f * w * cosf(angle), h + 0.5f * w * sinf(angle)};
    }
    outline[ARC] = (dmg_xy){-0.4f * w, 0};
    outline[ARC + 1] = (dmg_xy){0.4f * w, 0};
    if (dmg_chance(b, 0.7f))
        dmg_extrude(b, outline, ARC + 2, -z, z);
    else
        dmg_rounded_box(b, v3(0, 0.5f * h + 0.2f * w, 0), v3(w, h + 0.4f * w, deep), 0.1f * w);
    dmg_rod(b, v3(0, h, z - 0.02f * w), v3(0, h, z + 0.04f * w), 0.33f * w); /* the window */
    if (dmg_chance(b, 0.5f)) {
        uint32_t needle = dmg_hinge(b, 0, "needle", v3(0, h - 0.15f * w, z + 0.05f * w), v3(0, 0, -1), -1.0f, 1.0f);
        dmg_rest(b, needle, dmg_range(b, -1.0f, 1.0f));
        dmg_box_span(b, v3(-0.02f * w, h - 0.17f * w, z + 0.045f * w), v3(0.02f * w, h + 0.12f * w, z + 0.055f * w));
        dmg_use(b, 0);
    }
    float turn = dmg_range(b, 0.8f, 3.0f), y = 0.28f * h;
    if (dmg_chance(b, 0.75f)) { /* the handle that takes the coin */
        dmg_hinge(b, 0, "turn_handle", v3(0, y, z), v3(0, 0, -1), 0.0f, turn);
        dmg_save(b);
        dmg_move(b, 0, y, z);
        dmg_knob_draw(b, dmg_int(b, 1, 6), 0.13f * w, 0.18f * w);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_box(b, v3(0.24f * w, y, z), v3(0.12f * w, 0.16f * w, 0.08f * w));
    if (dmg_chance(b, 0.4f)) { /* a back that opens to its works */
        dmg_hinge(b, 0, "back", v3(0, 0.05f * w, -z - 0.03f * w), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 2.0f));
        dmg_box_span(b, v3(-0.38f * w, 0.05f * w, -z - 0.06f * w), v3(0.38f * w, h, -z - 0.005f * w));
        dmg_use(b, 0);
    }
}

static void draw_meter(dmg_builder* b) {
    float w = dmg_range(b, 0.16f, 0.28f), post = dmg_range(b, 0.8f, 1.2f), r = w * dmg_range(b, 0.12f, 0.25f),
          vault = w * dmg_range(b, 0.6f, 1.2f);
    int heads = dmg_chance(b, 0.3f) ? 2 : 1;
    dmg_rod(b, v3(0, 0, 0), v3(0, post, 0), r);
    if (dmg_chance(b, 0.5f)) dmg_cone(b, v3(0, 0, 0), v3(0, 0.3f * w, 0), 2.2f * r, 1.2f * r);
    if (heads == 2) dmg_box(b, v3(0, post, 0), v3(3.0f * w, 0.12f * w, 0.3f * w));
    for (int i = 0; i < heads; ++i) {
        dmg_save(b);
        dmg_move(b, heads == 1 ? 0.0f : (i ? 1.1f : -1.1f) * w, post, 0);
        dmg_box_span(b, v3(-0.4f * w, 0, -0.3f * w), v3(0.4f * w, vault, 0.3f * w));
        dmg_rod(b, v3(0, 0.5f * vault, 0.3f * w), v3(0, 0.5f * vault, 0.33f * w), 0.3f * w);
        int lid = dmg_int(b, 0, 2); /* to the coins: on a hinge, screwed in, or a drawer */
        float z = 0.335f * w, y = 0.5f * vault, s = fminf(0.28f * w, 0.42f * vault);
        if (lid == 0)
            dmg_hinge(b, 0, "vault_door", v3(-s, y, z + 0.02f * w), v3(0, -1, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
        if (lid == 1)
            dmg_screw(b, 0, "vault_lid", v3(0, y, z), v3(0, 0, 1), 0.01f * w, 0.0f,
                      2 * DMG_PI * (float)dmg_int(b, 1, 4));
        if (lid == 2) dmg_slide(b, 0, "coin_box", v3(0, 0, 1), 0.0f, 0.5f * w);
        if (lid == 1)
            dmg_rod(b, v3(0, y, z), v3(0, y, z + 0.05f * w), s);
        else
            dmg_box_span(b, v3(-s, y - s, z), v3(s, y + s, z + 0.05f * w));
        if (lid == 2) dmg_box_span(b, v3(-0.9f * s, y - 0.9f * s, -0.2f * w), v3(0.9f * s, y + 0.9f * s, z));
        dmg_rod(b, v3(0, y, z + 0.05f * w), v3(0, y, z + 0.09f * w), 0.06f * w);
        dmg_use(b, 0);
        dmg_move(b, 0, vault, 0);
        draw_meter_head(b, w);
        dmg_restore(b);
    }
}

/* Draws a cabinet whose whole front opens with all that is on it, or a lower door; a visor, a lamp, a roof with a solar
 * cell. */
static void draw_ticket_machine(dmg_builder* b) {
    float width = dmg_range(b, 0.3f, 0.9f), high = dmg_range(b, 1.1f, 1.9f), deep = width * dmg_range(b, 0.5f, 1.0f),
          z = 0.5f * deep, t = 0.05f * width;
    bool whole = dmg_chance(b, 0.4f), post = !whole && dmg_chance(b, 0.3f);
    uint32_t door = 0;
    if (whole) {
        float side = dmg_sign(b);
        dmg_save(b);
        dmg_move(b, 0, 0.5f * high, z - t);
        dmg_case_draw(b, dmg_case_pick(b), width, high, deep - t, 0.6f * t);
        dmg_restore(b);
        const float upper = dmg_range(b, 1.2f, 2.2f);
        const dmg_vec origin = v3(side * 0.5f * width, 0, z - t * dmg_range(b, 0.0f, 1.0f));
        door = dmg_hinge(b, 0, "front", origin, v3(0, side, 0), 0.0f, upper);
        dmg_box_span(b, v3(-0.5f * width, 0, z - 0.98f * t), v3(0.5f * width, high, z));
    } else if (post) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.5f * high, 0), 0.3f * width);
        dmg_box_span(b, v3(-0.5f * width, 0.5f * high, -z), v3(0.5f * width, high, z));
    } else {
        dmg_box_span(b, v3(-0.5f * width, 0, -z), v3(0.5f * width, high, z));
        dmg_save(b);
        dmg_move(b, 0, 0.25f * high, z);
        draw_service_door(b, 0.85f * width, 0.4f * high);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, 0, 0.74f * high, z);
    draw_pay_face(b, door, width, 0.46f * high);
    dmg_restore(b);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.4f)) { /* against the rain: pushed up */
        dmg_hinge(b, 0, "visor", v3(0, high + 0.02f, z + 0.12f * width), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.5f));
        dmg_box_span(b, v3(-0.45f * width, 0.76f * high, z + 0.12f * width),
                     v3(0.45f * width, high + 0.02f, z + 0.14f * width));
        dmg_use(b, 0);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.46f * width - 0.01f, high - 0.02f, z - t),
                         v3((float)s * 0.46f * width + 0.01f, high + 0.035f, z + 0.13f * width));
    } else if (dmg_chance(b, 0.5f)) {
        dmg_rod(b, v3(0, high, 0), v3(0, 1.15f * high, 0), 0.04f * width);
        uint32_t cell = dmg_hinge(b, 0, "solar_cell", v3(0, 1.15f * high, 0), v3(1, 0, 0), -0.2f, 1.0f);
        dmg_rest(b, cell, dmg_range(b, 0.0f, 0.8f));
        dmg_box(b, v3(0, 1.15f * high + 0.03f * width, 0), v3(0.7f * width, 0.04f * width, 0.6f * width));
        dmg_use(b, 0);
    }
}

void dmg_build_fuel_pump(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){2, 1.6f, 1.4f}, 3);
    if (kind == 0) draw_modern_pump(b);
    if (kind == 1) draw_old_pump(b);
    if (kind == 2) draw_charger(b);
    dmg_use(b, 0);
}

void dmg_build_ticket_machine(dmg_builder* b) {
    if (dmg_chance(b, 0.5f))
        draw_meter(b);
    else
        draw_ticket_machine(b);
    dmg_use(b, 0);
}
