/* Draws sound consoles: synthesisers with wheels beside their keys, mixing desks of channel strips, pads and jog
 * wheels, boards of effect pedals. The player is at +Z. */
#include "core/build.h"
#include "music/manuals.h"
#include "parts/hardware.h"

enum { PART_ROOM = DMG_PART_LIMIT - 10 };

/* How many of `wanted` parts may still be added. */
static int room_for(const dmg_builder* b, int wanted) {
    int left = PART_ROOM - (int)b->part_count;
    return wanted < left ? wanted : (left > 0 ? left : 0);
}

/* ---- what is on a panel: z = 0 facing +Z, +Y away from the player; `carrier` is in use afterwards ---- */

typedef struct cap {
    int kind;
    float wide, long_, high;
} cap;

static cap pick_cap(dmg_builder* b) {
    cap c = {.kind = dmg_int(b, 0, 3)};
    c.wide = dmg_range(b, 0.4f, 0.9f);
    c.long_ = dmg_range(b, 0.3f, 0.8f);
    c.high = dmg_range(b, 0.2f, 0.7f);
    return c;
}

/* Draws a slot along Y and the cap that runs in it; `size` is the room across. */
static void draw_fader(dmg_builder* b, uint32_t carrier, const char* name, const cap* c, float way, float size) {
    float w = c->wide * size, l = fminf(c->long_ * size, 0.4f * way), h = c->high * size, run = way - l;
    dmg_box(b, v3(0, 0, 0), v3(0.12f * size, way, 0.06f * size));
    uint32_t fader = dmg_slide(b, carrier, name, v3(0, 1, 0), -0.5f * run, 0.5f * run);
    if (c->kind == 0) dmg_box(b, v3(0, 0, 0.5f * h), v3(w, l, h));
    if (c->kind == 1) { /* on a blade, hollowed for the finger */
        const dmg_xy saddle[] = {{-0.5f * l, 0.3f * h}, {0.5f * l, 0.3f * h},  {0.5f * l, h},
                                 {0.1f * l, 0.7f * h},  {-0.1f * l, 0.7f * h}, {-0.5f * l, h}};
        dmg_box(b, v3(0, 0, 0.2f * h), v3(0.1f * size, 0.5f * l, 0.4f * h));
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_extrude(b, saddle, 6, -0.5f * w, 0.5f * w);
        dmg_restore(b);
    }
    if (c->kind == 2) {
        dmg_box(b, v3(0, 0, 0.25f * h), v3(w, l, 0.5f * h));
        dmg_box(b, v3(0, 0, 0.6f * h), v3(w, 0.2f * l, 0.8f * h));
    }
    if (c->kind == 3) dmg_rod(b, v3(0, 0, 0), v3(0, 0, h), 0.5f * fminf(w, l));
    dmg_rest(b, fader, run * dmg_range(b, -0.5f, 0.5f));
    dmg_use(b, carrier);
}

static void draw_fader_row(dmg_builder* b, uint32_t carrier, float w, float h) {
    int count = room_for(b, dmg_int(b, 2, 8));
    float pitch = w / (float)(count > 0 ? count : 1), size = fminf(0.9f * pitch, 0.3f * h);
    cap c = pick_cap(b);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        draw_fader(b, carrier, "fader", &c, 0.85f * h, size);
        dmg_restore(b);
    }
}

static void draw_knob_grid(dmg_builder* b, uint32_t carrier, float w, float h) {
    int columns = dmg_int(b, 1, 5), rows = dmg_int(b, 1, 3);
    float px = w / (float)columns, py = h / (float)rows, r = fminf(px, py) * dmg_range(b, 0.2f, 0.42f);
    for (int i = 0; i < rows; ++i) {
        dmg_save(b);
        dmg_move(b, 0, py * ((float)i - 0.5f * (float)(rows - 1)), 0);
        dmg_knobs_draw(b, carrier, room_for(b, columns), px, 0, r);
        dmg_restore(b);
    }
}

static void draw_key_grid(dmg_builder* b, uint32_t carrier, const char* name, float w, float h, bool pads) {
    int columns = pads ? dmg_int(b, 2, 4) : dmg_int(b, 2, 8), rows = pads ? dmg_int(b, 1, 4) : dmg_int(b, 1, 2);
    if (room_for(b, columns * rows) < columns * rows) return;
    dmg_buttons keys = {.name = name, .columns = columns, .rows = rows, .kind = pads ? 2 : dmg_int(b, 0, 3)};
    keys.pitch_x = w / (float)columns;
    keys.pitch_y = h / (float)rows;
    if (pads) keys.pitch_x = keys.pitch_y = fminf(keys.pitch_x, keys.pitch_y);
    keys.width = keys.pitch_x * dmg_range(b, 0.55f, 0.9f);
    keys.height = pads ? keys.width : fminf(keys.pitch_y, keys.pitch_x) * dmg_range(b, 0.4f, 0.85f);
    keys.rise = keys.height * dmg_range(b, 0.1f, 0.4f);
    keys.travel = dmg_button_way(b, keys.rise);
    dmg_buttons_draw(b, carrier, &keys);
}

/* Draws a screen: let in, or hung by its far edge and raised. */
static void draw_screen(dmg_builder* b, uint32_t carrier, float w, float h) {
    float t = 0.06f * fminf(w, h);
    if (dmg_chance(b, 0.5f)) {
        uint32_t s = dmg_hinge(b, carrier, "screen", v3(0, 0.45f * h, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.4f));
        dmg_box_span(b, v3(-0.45f * w, -0.45f * h, 0), v3(0.45f * w, 0.45f * h, t));
        dmg_rest(b, s, dmg_range(b, 0.0f, 0.5f));
    } else {
        dmg_box_span(b, v3(-0.45f * w, -0.45f * h, -t), v3(0.45f * w, 0.45f * h, 0.5f * t));
    }
    dmg_use(b, carrier);
}

/* Draws a disc for the whole hand, with a dimple or a rim of grips. */
static void draw_jog(dmg_builder* b, uint32_t carrier, float r) {
    float h = r * dmg_range(b, 0.08f, 0.35f), top = dmg_range(b, 0.75f, 0.97f) * r;
    const dmg_xy disc[] = {{0, 0}, {r, 0}, {r, 0.6f * h}, {top, h}, {0, h}};
    dmg_spin(b, carrier, "jog_wheel", v3(0, 0, 0), v3(0, 0, 1));
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), disc, 5);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0.65f * top, h), v3(0, 0.65f * top, 1.1f * h), 0.12f * r);
    int grips = dmg_chance(b, 0.4f) ? 12 : 0;
    for (int i = 0; i < grips; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / 12;
        dmg_rod(b, v3(r * cosf(angle), r * sinf(angle), 0.05f * h), v3(r * cosf(angle), r * sinf(angle), 0.5f * h),
                0.05f * r);
    }
    dmg_use(b, carrier);
}

static void draw_section(dmg_builder* b, uint32_t carrier, float w, float h) {
    int kind = dmg_weighted(b, (const float[]){3, 2.5f, 2, 1.3f, 1.3f, 0.6f}, 6);
    if (kind == 0) draw_knob_grid(b, carrier, w, h);
    if (kind == 1) draw_fader_row(b, carrier, w, h);
    if (kind == 2) draw_key_grid(b, carrier, "button", w, h, false);
    if (kind == 3) draw_key_grid(b, carrier, "pad", w, h, true);
    if (kind == 4) draw_screen(b, carrier, w, h);
    if (kind == 5 && room_for(b, 1)) draw_jog(b, carrier, 0.42f * fminf(w, h));
}

/* Sections side by side over the panel. */
static void draw_sections(dmg_builder* b, uint32_t carrier, float w, float h, int count) {
    float total = 0, share[6], at = -0.5f * w;
    for (int i = 0; i < count; ++i) {
        share[i] = dmg_range(b, 0.5f, 1.5f);
        total += share[i];
    }
    for (int i = 0; i < count; ++i) {
        float wide = w * share[i] / total;
        dmg_save(b);
        dmg_move(b, at + 0.5f * wide, 0, 0);
        draw_section(b, carrier, 0.88f * wide, 0.88f * h);
        dmg_restore(b);
        at += wide;
    }
}

/* ---- synthesisers ---- */

/* Left of the keys at z = 0 of a panel: wheels half let in, about X, or a stick. */
static void draw_benders(dmg_builder* b, float w, float h) {
    int kind = dmg_weighted(b, (const float[]){4, 1, 1}, 3);
    if (kind == 0) {
        float r = h * dmg_range(b, 0.2f, 0.32f), deep = r * dmg_range(b, 0.1f, 0.6f), t = w * dmg_range(b, 0.12f, 0.3f);
        bool stacked = dmg_chance(b, 0.2f);
        for (int i = 0; i < 2; ++i) {
            float side = i ? 0.5f : -0.5f, x = stacked ? 0.0f : side * 0.5f * w, y = stacked ? side * 0.5f * h : 0.0f;
            float own = stacked ? 0.7f * r : r;
            uint32_t wheel = dmg_hinge(b, 0, i ? "mod_wheel" : "pitch_wheel", v3(x, y, -deep), v3(-1, 0, 0),
                                       i ? 0.0f : -0.7f, i ? 1.4f : 0.7f);
            dmg_rod(b, v3(x - 0.5f * t, y, -deep), v3(x + 0.5f * t, y, -deep), own);
            dmg_rod(b, v3(x - 0.4f * t, y, own - deep), v3(x + 0.4f * t, y, own - deep), 0.12f * own);
            if (i) dmg_rest(b, wheel, dmg_range(b, 0.0f, 1.4f));
            dmg_use(b, 0);
        }
    } else if (kind == 1) { /* a stick: to the sides, and away */
        float tall = 0.35f * h, r = 0.06f * h;
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 3 * r, 0.5f * r);
        uint32_t base = dmg_hinge(b, 0, "bend_stick", v3(0, 0, 0), v3(0, 1, 0), -0.5f, 0.5f);
        dmg_ellipsoid(b, v3(0, 0, 0), v3(1.8f * r, 1.8f * r, 1.2f * r));
        dmg_hinge(b, base, "mod_stick", v3(0, 0, 0), v3(1, 0, 0), -0.5f, 0.5f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, tall), 0.7f * r);
        dmg_ellipsoid(b, v3(0, 0, tall), v3(1.3f * r, 1.3f * r, r));
        dmg_use(b, 0);
    } else { /* levers that lie across, about their left ends */
        for (int i = 0; i < 2; ++i) {
            float y = (i ? 0.2f : -0.2f) * h, t = 0.1f * h;
            dmg_hinge(b, 0, i ? "mod_lever" : "pitch_lever", v3(-0.3f * w, y, 0), v3(0, 0, 1), -0.3f, 0.3f);
            dmg_box_span(b, v3(-0.35f * w, y - 0.4f * t, 0), v3(0.4f * w, y + 0.4f * t, t));
            dmg_use(b, 0);
        }
    }
}

/* Below y = 0, half sizes x and z: crossed bars, columns on feet or nothing. */
static void draw_stand(dmg_builder* b, float x, float z, float tall) {
    int kind = dmg_int(b, 0, 7);
    float t = 0.05f * z + 0.01f * x;
    if (kind == 0) {
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 0.7f * x, -t, (float)s * 2 * t),
                     v3(-(float)s * 0.7f * x, -tall, (float)s * 2 * t), 2 * t, 2 * t);
        for (int s = -1; s <= 1; s += 2) {
            dmg_beam(b, v3((float)s * 0.7f * x, -t, -0.9f * z), v3((float)s * 0.7f * x, -t, 0.9f * z), 2 * t, 2 * t);
            dmg_beam(b, v3((float)s * 0.7f * x, -tall, -1.2f * z), v3((float)s * 0.7f * x, -tall, 1.2f * z), 2 * t,
                     2 * t);
        }
    } else if (kind == 1) {
        for (int s = -1; s <= 1; s += 2) {
            dmg_box_span(b, v3((float)s * 0.85f * x - t, -tall, -0.4f * z), v3((float)s * 0.85f * x + t, 0, 0.4f * z));
            dmg_box_span(b, v3((float)s * 0.85f * x - 1.5f * t, -tall - t, -z),
                         v3((float)s * 0.85f * x + 1.5f * t, -tall, z));
        }
    }
}

void dmg_build_synthesizer(dmg_builder* b) {
    dmg_manual m = dmg_manual_pick(b, dmg_range(b, 0.015f, 0.025f));
    bool raised = dmg_chance(b, 0.3f);
    m.fixed = m.fixed && dmg_chance(b, 0.3f);
    float left = m.pitch * (dmg_chance(b, 0.8f) ? dmg_range(b, 3.5f, 7.0f) : 0.6f),
          slab = m.thick * 2.5f + 1.5f * m.dip, keys = dmg_manual_width(&m), x = 0.5f * (keys + left) + 0.5f * m.pitch,
          slip = 0.6f * m.pitch, deep = m.length * dmg_range(b, 0.5f, 1.8f), tilt = dmg_range(b, 0.0f, 0.7f),
          high = m.rise * dmg_range(b, 0.6f, 2.0f);
    float rear = -m.length - deep * cosf(tilt), low = -slab - m.pitch * dmg_range(b, 0.0f, 1.5f);
    dmg_move(b, 0, 0.9f, 0);
    dmg_box_span(b, v3(-x, low, rear), v3(x, -slab, slip));
    dmg_box_span(b, v3(-x, -slab, 0.1f * slip), v3(x, -0.2f * m.thick, slip));
    dmg_save(b);
    dmg_move(b, 0.5f * left, 0, 0);
    dmg_manual_draw(b, &m, 0);
    dmg_restore(b);
    float end = -x + left; /* the block beside the keys */
    dmg_box_span(b, v3(-x, -slab, -m.length), v3(end, 0.3f * m.rise, 0.1f * slip));
    dmg_box_span(b, v3(end + keys, -slab, -m.length), v3(x, 0.3f * m.rise, 0.1f * slip));
    if (left > 2 * m.pitch) {
        dmg_save(b);
        dmg_move(b, -x + 0.5f * left, 0.3f * m.rise, -0.5f * m.length);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        draw_benders(b, left, 0.8f * m.length);
        dmg_restore(b);
    }
    for (int s = -1; s <= 1; s += 2) /* cheeks of wood */
        dmg_box_span(b, v3(s > 0 ? x : -x - 0.5f * m.pitch, low, rear),
                     v3(s > 0 ? x + 0.5f * m.pitch : -x, high, slip));
    /* The panel slopes up from behind the keys: a block, or a leaf that is raised for the road. */
    uint32_t panel = 0;
    dmg_save(b);
    dmg_move(b, 0, high, -m.length);
    float t = 0.5f * m.pitch;
    if (raised) {
        panel = dmg_hinge(b, 0, "panel", v3(0, 0, 0), v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.3f));
        dmg_rest(b, panel, dmg_range(b, 0.0f, 0.5f));
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    } else {
        dmg_box_span(b, v3(-x, -slab - high, -deep * cosf(tilt)), v3(x, 0, 0));
        dmg_turn(b, v3(1, 0, 0), tilt - 0.5f * DMG_PI);
    }
    dmg_move(b, 0, 0.5f * deep, 0);
    dmg_box_span(b, v3(-x, -0.5f * deep, -t), v3(x, 0.5f * deep, 0));
    draw_sections(b, panel, 1.9f * x, 0.9f * deep, dmg_int(b, 2, 5));
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_move(b, 0, low, 0.5f * (rear + slip));
    draw_stand(b, x, 0.5f * (slip - rear), fminf(0.8f, 1.5f * x));
}

/* ---- desks: a wedge whose face carries everything ---- */

typedef struct wedge {
    float wide, deep, low, high; /* heights in front and behind */
    float face;                  /* length of the slope */
} wedge;

static wedge pick_wedge(dmg_builder* b, float least, float most) {
    wedge w = {.wide = dmg_scale_range(b, 0.2f, 1.2f)};
    w.deep = w.wide * dmg_range(b, least, most);
    w.low = fminf(w.wide, w.deep) * dmg_range(b, 0.04f, 0.15f);
    w.high = w.low + w.deep * (dmg_chance(b, 0.3f) ? 0.0f : dmg_range(b, 0.03f, 0.35f));
    w.face = hypotf(w.deep, w.high - w.low);
    return w;
}

static void draw_wedge(dmg_builder* b, const wedge* w) {
    const dmg_xy side[] = {
        {-0.5f * w->deep, 0}, {0.5f * w->deep, 0}, {0.5f * w->deep, w->high}, {-0.5f * w->deep, w->low}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_extrude(b, side, 4, -0.5f * w->wide, 0.5f * w->wide);
    dmg_restore(b);
    float cheek = 0.03f * w->wide, up = dmg_range(b, 0.0f, 0.05f) * w->wide;
    if (!dmg_chance(b, 0.4f)) return;
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        const dmg_xy board[] = {{-0.52f * w->deep, 0},
                                {0.52f * w->deep, 0},
                                {0.52f * w->deep, w->high + up},
                                {-0.52f * w->deep, w->low + up}};
        float from = (float)s * 0.5f * w->wide;
        dmg_extrude(b, board, 4, s > 0 ? from : from - cheek, s > 0 ? from + cheek : from);
        dmg_restore(b);
    }
}

/* To the middle of the face. */
static void on_face(dmg_builder* b, const wedge* w) {
    dmg_move(b, 0, 0.5f * (w->low + w->high), 0);
    dmg_turn(b, v3(1, 0, 0), atan2f(w->high - w->low, w->deep) - 0.5f * DMG_PI);
}

/* Strips alike, from behind: knobs, a key or two, the fader nearest to the player. */
static void draw_strips(dmg_builder* b, float w, float h) {
    int strips = dmg_int(b, 3, 12), knobs = dmg_int(b, 1, 6), keys = dmg_int(b, 0, 2),
        kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    while (strips * (knobs + keys + 1) > PART_ROOM - 8) --strips;
    float pitch = w / (float)strips, way = h * dmg_range(b, 0.25f, 0.5f), rows = h - way,
          py = rows / (float)(knobs + keys), r = fminf(pitch, py) * dmg_range(b, 0.22f, 0.42f),
          tall = r * dmg_range(b, 0.7f, 2.0f);
    bool rotary = dmg_chance(b, 0.12f); /* no faders but one more knob */
    cap c = pick_cap(b);
    dmg_buttons key = {
        .name = "mute", .columns = 1, .rows = 1, .pitch_x = pitch, .pitch_y = py, .kind = dmg_int(b, 0, 3)};
    key.width = 1.3f * r;
    key.height = r * dmg_range(b, 0.7f, 1.3f);
    key.rise = 0.4f * r;
    key.travel = dmg_button_way(b, key.rise);
    for (int i = 0; i < strips; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(strips - 1));
        dmg_save(b);
        dmg_move(b, x, 0.5f * (way - h), 0);
        if (!rotary) draw_fader(b, 0, "fader", &c, 0.9f * way, fminf(0.9f * pitch, 0.25f * way));
        dmg_move(b, 0, 0.5f * way + 0.5f * py, 0);
        for (int k = 0; k < keys + knobs; ++k) {
            if (k < keys) {
                dmg_buttons_draw(b, 0, &key);
            } else {
                uint32_t knob = dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1), -2.4f, 2.4f);
                dmg_knob_draw(b, kind, r, tall);
                dmg_rest(b, knob, dmg_range(b, -2.0f, 2.0f));
                dmg_use(b, 0);
            }
            dmg_move(b, 0, py, 0);
        }
        dmg_restore(b);
    }
}

/* Behind the face: a bridge of meters that tilts, or a lid over all; at the edge rests to fold out. */
static void draw_desk_extras(dmg_builder* b, const wedge* w) {
    float t = 0.02f * w->wide, z = -0.5f * w->deep, tall = w->deep * dmg_range(b, 0.15f, 0.4f);
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.4f * w->wide - t, w->high - t, z - 2 * t),
                         v3((float)s * 0.4f * w->wide + t, w->high + 2 * t, z));
        uint32_t bridge = dmg_hinge(b, 0, "meter_bridge", v3(0, w->high + 2 * t, z - t), v3(-1, 0, 0), -0.3f,
                                    dmg_range(b, 0.3f, 1.2f));
        dmg_box_span(b, v3(-0.5f * w->wide, w->high + 1.5f * t, z - 2 * t),
                     v3(0.5f * w->wide, w->high + 2 * t + tall, z));
        dmg_rest(b, bridge, dmg_range(b, -0.2f, 0.3f));
        dmg_use(b, 0);
    }
    if (kind == 1) { /* a cover, hung behind */
        float rim = 0.08f * w->wide, swing = dmg_range(b, 1.0f, 2.4f);
        uint32_t lid = dmg_hinge(b, 0, "cover", v3(0, w->high, z), v3(-1, 0, 0), 0.0f, swing);
        dmg_save(b);
        on_face(b, w);
        dmg_turn(b, v3(1, 0, 0), DMG_PI);
        dmg_case_draw(b, dmg_chance(b, 0.5f) ? DMG_CASE_SHEET : DMG_CASE_BOARDS, 1.02f * w->wide, 1.02f * w->face, rim,
                      0.3f * t);
        dmg_restore(b);
        dmg_rest(b, lid, swing * dmg_range(b, 0.5f, 1.0f));
        dmg_use(b, 0);
    }
}

/* Draws two jog wheels, a mixer's strip between them. */
static void draw_player_face(dmg_builder* b, const wedge* w) {
    float h = w->face, side = 0.36f * w->wide, r = fminf(0.26f * h, 0.12f * w->wide), small = 0.05f * h;
    cap c = pick_cap(b);
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * 0.3f * w->wide, 0.12f * h, 0);
        draw_jog(b, 0, r);
        dmg_move(b, 0, -0.4f * h, 0);
        draw_key_grid(b, 0, "pad", 0.26f * w->wide, 0.2f * h, true);
        dmg_restore(b);
        dmg_save(b);
        dmg_move(b, (float)s * (side + 0.09f * w->wide), 0.1f * h, 0);
        draw_fader(b, 0, "pitch", &c, 0.5f * h, small);
        dmg_restore(b);
        dmg_save(b);
        dmg_move(b, (float)s * 0.05f * w->wide, 0.2f * h, 0);
        dmg_knobs_draw(b, 0, dmg_int(b, 2, 4), 0, 0.12f * h, 0.5f * small);
        dmg_move(b, 0, -0.3f * h, 0);
        draw_fader(b, 0, "fader", &c, 0.28f * h, small);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, 0, -0.36f * h, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    draw_fader(b, 0, "crossfader", &c, 0.16f * w->wide, small);
    dmg_restore(b);
}

/* Draws a box for a foot: knobs, and a button that sinks, a plate hung behind the knobs, or a treadle on a pin in its
 * middle. */
static void draw_stomp_box(dmg_builder* b, float w, float h, float t) {
    int kind = dmg_int(b, 0, 2);
    dmg_box_span(b, v3(-0.5f * w, -0.5f * h, 0), v3(0.5f * w, 0.5f * h, t));
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    if (kind == 2) {
        float lift = 0.3f * t, tilt = dmg_range(b, 0.1f, 0.25f);
        dmg_box_span(b, v3(-0.3f * w, -0.1f * h, 0), v3(0.3f * w, 0.1f * h, lift));
        uint32_t treadle = dmg_hinge(b, 0, "treadle", v3(0, 0, lift), v3(1, 0, 0), -tilt, tilt);
        dmg_rounded_box(b, v3(0, 0, lift + 0.15f * t), v3(0.9f * w, 0.98f * h, 0.3f * t), 0.1f * t);
        dmg_rest(b, treadle, dmg_range(b, -tilt, tilt));
    } else {
        dmg_save(b);
        dmg_move(b, 0, 0.36f * h, 0);
        dmg_knobs_draw(b, 0, dmg_int(b, 1, 3), 0.3f * w, 0, 0.11f * w);
        dmg_restore(b);
        if (kind == 0) {
            dmg_slide(b, 0, "foot_switch", v3(0, 0, -1), 0.0f, 0.12f * w);
            dmg_rod(b, v3(0, -0.3f * h, 0), v3(0, -0.3f * h, 0.2f * w), 0.1f * w);
        } else {
            dmg_hinge(b, 0, "plate", v3(0, 0.2f * h, 0.1f * t), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.1f, 1.3f));
            dmg_box_span(b, v3(-0.48f * w, -0.48f * h, 0.05f * t), v3(0.48f * w, 0.2f * h, 0.25f * t));
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_sound_desk(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 2, 2, 1.5f}, 4);
    wedge w =
        kind == 0 ? pick_wedge(b, 0.5f, 1.3f) : (kind == 3 ? pick_wedge(b, 0.3f, 0.5f) : pick_wedge(b, 0.45f, 0.8f));
    draw_wedge(b, &w);
    dmg_save(b);
    on_face(b, &w);
    if (kind == 0) draw_strips(b, 0.95f * w.wide, 0.93f * w.face);
    if (kind == 1) draw_player_face(b, &w);
    if (kind == 2) {
        dmg_move(b, 0, -0.25f * w.face, 0);
        draw_sections(b, 0, 0.95f * w.wide, 0.45f * w.face, dmg_int(b, 1, 3));
        dmg_move(b, 0, 0.5f * w.face, 0);
        draw_sections(b, 0, 0.95f * w.wide, 0.42f * w.face, dmg_int(b, 2, 4));
    }
    int boxes = kind == 3 ? dmg_int(b, 3, 7) : 0;
    float pitch = 0.95f * w.wide / fmaxf(1.0f, (float)boxes), wide = fminf(0.85f * pitch, 0.6f * w.face);
    for (int i = 0; i < boxes; ++i) {
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(boxes - 1)), 0, 0);
        draw_stomp_box(b, wide, fminf(0.9f * w.face, 1.8f * wide), wide * dmg_range(b, 0.3f, 0.6f));
        dmg_restore(b);
    }
    dmg_restore(b);
    if (kind != 3) draw_desk_extras(b, &w);
}
