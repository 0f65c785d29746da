/* Draws bench instruments of a laboratory: measuring sets with bails, plug-ins and racks; centrifuges. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/switches.h"

/* ---- measuring sets: front at z = 0, its middle at the origin ---- */

typedef struct set {
    float width, height, depth;
} set;

static const float front_weights[DMG_CONTROL_KINDS] = {6, 3, 5, 1, 0.5f, 0, 0, 0.2f, 0.1f, 0.2f, 0.2f, 2};

/* Rows of controls over a field, and sockets below them. */
static void draw_field(dmg_builder* b, float width, float height) {
    int rows = dmg_int(b, 1, 4), sockets = dmg_int(b, 0, 4);
    float gap = height / ((float)rows + (sockets > 0 ? 0.6f : 0.0f)), top = 0.5f * height - 0.5f * gap;
    for (int i = 0; i < rows && b->part_count < 60; ++i) {
        int kind = dmg_weighted(b, front_weights, DMG_CONTROL_KINDS), count = dmg_int(b, 1, 4);
        float pitch = width / (float)count, radius = 0.5f * fminf(pitch, gap) * dmg_range(b, 0.45f, 0.85f);
        dmg_save(b);
        dmg_move(b, 0, top - gap * (float)i, 0);
        dmg_control_row_draw(b, (dmg_control_kind)kind, count, pitch, radius);
        dmg_restore(b);
    }
    for (int i = 0; i < sockets; ++i) {
        float x = width * (((float)i + 0.5f) / (float)sockets - 0.5f), r = 0.13f * gap;
        dmg_rod(b, v3(x, -0.5f * height + 0.2f * gap, 0), v3(x, -0.5f * height + 0.2f * gap, 2.5f * r), r);
    }
}

/* Draws a bail about two bosses on the sides: over the set it carries, before its feet it props. */
static void draw_bail(dmg_builder* b, const set* s) {
    float z = -s->depth * dmg_range(b, 0.25f, 0.6f), x = 0.5f * s->width, t = 0.03f * s->width, rest = 0.0f,
          reach = fmaxf(0.55f * s->height, 0.55f * s->depth) * dmg_range(b, 1.1f, 1.5f);
    bool front = dmg_chance(b, 0.4f);
    for (int i = -1; i <= 1; i += 2) dmg_rod(b, v3((float)i * x, 0, z), v3((float)i * (x + t), 0, z), 0.1f * s->height);
    uint32_t bail = dmg_hinge(b, 0, "bail", v3(0, 0, z), v3(1, 0, 0), -1.6f, 1.9f);
    if (dmg_chance(b, 0.5f)) {
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3((float)i * (x + 1.8f * t), 0.5f * reach, z), v3(1.2f * t, reach + 3 * t, 2.5f * t));
        dmg_rounded_box(b, v3(0, reach, z), v3(2 * x + 3.6f * t, 2.5f * t, 3 * t), t);
    } else {
        const dmg_vec path[] = {{-x - 1.8f * t, 0, z}, {-x - 1.8f * t, 0.9f * reach, z}, {-0.85f * x, reach, z},
                                {0.85f * x, reach, z}, {x + 1.8f * t, 0.9f * reach, z},  {x + 1.8f * t, 0, z}};
        dmg_sweep(b, path, 6, t, t, false);
    }
    if (front) rest = dmg_range(b, 0.0f, 1.9f);
    dmg_rest(b, bail, rest);
    dmg_use(b, 0);
}

/* Draws two legs or one wire under the front edge that fold back; a strap that lifts; a lid before the front. */
static void draw_extras(dmg_builder* b, const set* s) {
    float low = -0.5f * s->height, t = 0.03f * s->height, leg = s->depth * dmg_range(b, 0.15f, 0.3f);
    if (dmg_chance(b, 0.5f)) {
        for (int i = -1; i <= 1; i += 2) {
            float x = (float)i * 0.35f * s->width, z = -0.15f * s->depth;
            dmg_box(b, v3(x, low - 0.5f * t, z), v3(0.06f * s->width, t, 2 * t));
            uint32_t foot = dmg_hinge(b, 0, "leg", v3(x, low - t, z), v3(-1, 0, 0), 0.0f, 1.9f);
            dmg_box(b, v3(x, low - t, z - 0.5f * leg), v3(0.05f * s->width, t, leg));
            if (dmg_chance(b, 0.3f)) dmg_rest(b, foot, 1.5f);
            dmg_use(b, 0);
        }
    }
    if (dmg_chance(b, 0.15f)) {
        dmg_hinge(b, 0, "front_cover", v3(0, low, 0.06f * s->depth), v3(1, 0, 0), 0.0f, dmg_range(b, 1.5f, 3.0f));
        dmg_save(b);
        dmg_move(b, 0, 0, 0.2f * s->depth);
        dmg_turn(b, v3(0, 1, 0), DMG_PI); /* a shell that is open towards the set */
        dmg_move(b, 0, 0, 0.15f * s->depth);
        dmg_case_draw(b, DMG_CASE_BOARDS, s->width, s->height, 0.15f * s->depth, t);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Modules side by side below or beside the screen; each draws out with the knobs it carries. */
static void draw_plug_ins(dmg_builder* b, float width, float height, float depth) {
    int count = dmg_int(b, 1, 4);
    float pitch = width / (float)count;
    for (int i = 0; i < count; ++i) {
        float wide = 0.94f * pitch, t = 0.03f * height, out = depth * dmg_range(b, 0.4f, 0.9f);
        int knobs = dmg_int(b, 1, 3);
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        uint32_t module = dmg_slide(b, 0, "plug_in", v3(0, 0, 1), 0.0f, out);
        dmg_box(b, v3(0, 0, 0), v3(wide, 0.95f * height, 2 * t));
        dmg_box(b, v3(0, 0, -0.5f * depth), v3(0.9f * wide, 0.85f * height, depth));
        dmg_move(b, 0, -0.42f * height, t);
        dmg_rod(b, v3(-0.2f * wide, 0, 0), v3(0.2f * wide, 0, 0), t); /* its latch, to pull */
        for (int k = 0; k < knobs; ++k) {
            float r = 0.5f * fminf(0.5f * wide, 0.8f * height / (float)knobs) * dmg_range(b, 0.6f, 0.9f);
            dmg_save(b);
            dmg_move(b, 0, 0.9f * height * ((float)k + 0.6f) / (float)knobs, 0);
            dmg_spin(b, module, "knob", v3(0, 0, 0), v3(0, 0, -1));
            dmg_any_knob_draw(b, r, 0.5f, 1.4f);
            dmg_restore(b);
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws three drawers of a rack, each the whole front of a set: the screws stay, the chassis comes out with its knobs.
 */
static void draw_rack(dmg_builder* b, const set* s) {
    int units = dmg_int(b, 2, 4);
    float unit = s->height / (float)units, t = 0.04f * s->width;
    dmg_move(b, 0, 0.5f * s->height + 2 * t, 0);
    dmg_case_draw(b, DMG_CASE_BOARDS, s->width + 2.5f * t, s->height + 2.5f * t, 1.1f * s->depth, t);
    for (int i = 0; i < units; ++i) {
        bool fixed = i > 0 && dmg_chance(b, 0.3f);
        int knobs = dmg_int(b, 0, 3);
        dmg_save(b);
        dmg_move(b, 0, unit * ((float)i - 0.5f * (float)(units - 1)), 0);
        uint32_t chassis = fixed ? 0 : dmg_slide(b, 0, "chassis", v3(0, 0, 1), 0.0f, 0.8f * s->depth);
        dmg_box(b, v3(0, 0, 0.5f * t), v3(s->width + 0.4f * t, 0.94f * unit, 0.5f * t));
        dmg_box(b, v3(0, 0, -0.45f * s->depth), v3(0.93f * s->width, 0.85f * unit, 0.9f * s->depth + t));
        for (int k = -1; k <= 1; k += 2) { /* the handles at both ends */
            float x = (float)k * 0.45f * s->width;
            const dmg_vec path[] = {{x, -0.3f * unit, 0.5f * t},
                                    {x, -0.3f * unit, 2.5f * t},
                                    {x, 0.3f * unit, 2.5f * t},
                                    {x, 0.3f * unit, 0.5f * t}};
            dmg_sweep(b, path, 4, 0.25f * t, 0.25f * t, false);
        }
        dmg_box(b, v3(-0.2f * s->width, 0, 0.8f * t), v3(0.25f * s->width, 0.5f * unit, 0.2f * t));
        for (int k = 0; k < knobs; ++k) {
            float r = 0.5f * fminf(0.12f * s->width, 0.7f * unit) * dmg_range(b, 0.6f, 1.0f);
            dmg_save(b);
            dmg_move(b, s->width * (0.05f + 0.13f * (float)k), 0, 0.75f * t);
            dmg_spin(b, chassis, "knob", v3(0, 0, 0), v3(0, 0, -1));
            dmg_any_knob_draw(b, r, 0.5f, 1.4f);
            dmg_restore(b);
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_bench_set(dmg_builder* b) {
    set s = {.width = dmg_scale_range(b, 0.12f, 0.5f)};
    s.height = s.width * dmg_range(b, 0.4f, 1.1f);
    s.depth = s.width * dmg_scale_range(b, 0.3f, 1.5f);
    int kind = dmg_int(b, 0, 3);
    if (kind == 3) {
        draw_rack(b, &s);
        return;
    }
    float screen = s.width * dmg_range(b, 0.3f, 0.55f), side = dmg_sign(b), rest = s.width - screen;
    dmg_move(b, 0, 0.5f * s.height + 0.05f * s.height, 0);
    bool hollow = kind == 1;
    if (hollow)
        dmg_case_draw(b, DMG_CASE_BOARDS, s.width, s.height, s.depth, 0.03f * s.width);
    else if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0, -0.5f * s.depth), v3(s.width, s.height, s.depth));
    else
        dmg_rounded_box(b, v3(0, 0, -0.5f * s.depth), v3(s.width, s.height, s.depth), 0.05f * s.width);
    dmg_save(b);
    dmg_move(b, side * 0.5f * (s.width - screen), 0, 0);
    if (hollow) dmg_box(b, v3(0, 0, -0.02f * s.depth), v3(0.95f * screen, 0.93f * s.height, 0.04f * s.depth));
    dmg_frame_draw(b, 0.85f * screen, fminf(0.85f * s.height, 0.8f * screen), 0.1f * screen, 0.07f * screen);
    dmg_box(b, v3(0, 0, 0), v3(0.75f * screen, fminf(0.75f * s.height, 0.7f * screen), 0.02f * screen));
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, -side * 0.5f * screen, 0, 0);
    if (hollow)
        draw_plug_ins(b, 0.92f * rest, 0.9f * s.height, 0.85f * s.depth);
    else
        draw_field(b, 0.9f * rest, 0.9f * s.height);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f) || b->part_count == 0) draw_bail(b, &s);
    draw_extras(b, &s);
    dmg_use(b, 0);
}

/* ---- centrifuge ---- */

/* Tubes that lean in a solid cone, or buckets on pins that swing out. */
static void draw_rotor(dmg_builder* b, float r, float y) {
    int kind = dmg_int(b, 0, 2), places = 2 * dmg_int(b, 2, 4);
    float tall = 0.5f * r;
    uint32_t rotor = dmg_spin(b, 0, "rotor", v3(0, 0, 0), v3(0, 1, 0));
    if (kind == 0) {
        dmg_cone(b, v3(0, y, 0), v3(0, y + tall, 0), 0.9f * r, 0.5f * r);
        dmg_rod(b, v3(0, y + tall, 0), v3(0, y + 1.3f * tall, 0), 0.15f * r);
    }
    if (kind == 1) { /* a disc of holes under a cap that screws off */
        dmg_rod(b, v3(0, y, 0), v3(0, y + 0.4f * tall, 0), 0.88f * r);
        dmg_screw(b, rotor, "rotor_lid", v3(0, 0, 0), v3(0, 1, 0), 0.02f * r, 0.0f, 9.0f);
        dmg_rod(b, v3(0, y + 0.4f * tall, 0), v3(0, y + 0.5f * tall, 0), 0.85f * r);
        dmg_rod(b, v3(0, y + 0.5f * tall, 0), v3(0, y + 0.9f * tall, 0), 0.2f * r);
    }
    if (kind == 2) {
        places = dmg_chance(b, 0.5f) ? 4 : 2;
        dmg_rod(b, v3(0, y, 0), v3(0, y + tall, 0), 0.2f * r);
    }
    for (int i = 0; i < places && kind != 1; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, places);
        if (kind == 0) {
            float thin = 0.4f * r * sinf(DMG_PI / (float)places);
            dmg_cone(b, v3(0.75f * r, y + 0.2f * tall, 0), v3(0.5f * r, y + 1.15f * tall, 0), 0.8f * thin, thin);
        } else {
            float at = 0.6f * r, wide = 0.18f * r, pin = y + 0.85f * tall;
            for (int k = -1; k <= 1; k += 2) /* the fork and its pins */
                dmg_beam(b, v3(0, pin, (float)k * 0.1f * r), v3(1.1f * at, pin, (float)k * 1.4f * wide), 0.08f * r,
                         0.12f * r);
            dmg_hinge(b, rotor, "bucket", v3(at, pin, 0), v3(0, 0, 1), 0.0f, 1.5f);
            dmg_rod(b, v3(at, pin, -1.3f * wide), v3(at, pin, 1.3f * wide), 0.3f * wide);
            dmg_rod(b, v3(at, pin - 0.35f * r, 0), v3(at, pin + 0.3f * wide, 0), wide);
            dmg_use(b, rotor);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_centrifuge(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.08f, 0.35f), high = r * dmg_range(b, 1.2f, 2.2f), t = 0.12f * r, bowl = 0.55f * high,
          wide = 1.35f * r, front = r * dmg_range(b, 1.3f, 2.2f);
    bool round = dmg_chance(b, 0.35f), domed = dmg_chance(b, 0.4f);
    const dmg_xy tub[] = {{0, 0},    {round ? wide : 1.12f * r, 0}, {round ? wide : 1.12f * r, high},
                          {r, high}, {0.95f * r, high - bowl},      {0, high - bowl}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), tub, 6);
    if (!round) { /* a housing of four sides and a top with a hole */
        dmg_save(b);
        dmg_move(b, 0, high, 0);
        dmg_face_up(b);
        dmg_holed_plate_draw(b, 2 * wide, 2 * wide, t, 1.02f * r);
        dmg_restore(b);
        for (int i = -1; i <= 1; i += 2) {
            dmg_box_span(b, v3((float)i * wide - 0.5f * t, 0, -wide), v3((float)i * wide + 0.5f * t, high, wide));
            dmg_box_span(b, v3(-wide, 0, (float)i * wide - 0.5f * t), v3(wide, high, (float)i * wide + 0.5f * t));
        }
        const dmg_xy desk[] = {{wide, 0}, {front + 0.4f * r, 0}, {front + 0.4f * r, 0.3f * high}, {wide, 0.9f * high}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, desk, 4, -wide, wide);
        dmg_restore(b);
        dmg_save(b); /* controls on its slope */
        dmg_move(b, 0, 0.6f * high, 0.5f * (wide + front + 0.4f * r));
        dmg_turn(b, v3(1, 0, 0), -atan2f(front + 0.4f * r - wide, 0.6f * high));
        const int count = dmg_int(b, 1, 4);
        const dmg_control_kind kind = dmg_chance(b, 0.5f) ? DMG_CONTROL_DIAL : DMG_CONTROL_KEY;
        dmg_control_row_draw(b, kind, count, 0.5f * wide, 0.18f * r);
        dmg_restore(b);
    } else if (dmg_chance(b, 0.6f)) {
        dmg_save(b);
        dmg_move(b, 0, 0.4f * high, wide * 0.98f);
        dmg_control_row_draw(b, DMG_CONTROL_DIAL, 1, 0, 0.25f * r);
        dmg_restore(b);
    }
    draw_rotor(b, 0.9f * r, high - 0.85f * bowl);
    dmg_rod(b, v3(0, high - bowl, 0), v3(0, high - 0.85f * bowl, 0), 0.12f * r);
    float back = -wide - 0.3f * t, line = high + dmg_range(b, 0.0f, 1.0f) * t;
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, line, back), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.0f));
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(-0.6f * wide, line, back), v3(0.6f * wide, line, back), 0.5f * t);
    dmg_beam(b, v3(0, high + 0.5f * t, back), v3(0, high + 0.5f * t, -0.8f * r), 0.9f * wide, 0.8f * t);
    if (round || dmg_chance(b, 0.4f)) {
        dmg_rod(b, v3(0, high + 0.02f * t, 0), v3(0, high + t, 0), 1.2f * r);
        if (domed) dmg_dome(b, v3(0, high + t, 0), v3(r, 0.3f * r, r));
    } else {
        dmg_rounded_box(b, v3(0, high + 0.55f * t, 0), v3(2 * wide, t, 2 * wide), 0.3f * t);
    }
    dmg_box(b, v3(0, high + 0.6f * t, 1.15f * r), v3(0.4f * r, 0.6f * t, 0.4f * r));
    if (dmg_chance(b, 0.4f)) dmg_rest(b, lid, 1.1f);
    dmg_use(b, 0);
}
