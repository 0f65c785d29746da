/* Draws radios: portable ones with aerials, bows and cassette doors, walkie-talkies, bedside sets. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* A case between x = ±half, y = 0 … high, z = ±deep. */
typedef struct unit {
    float half, high, deep;
} unit;

static void draw_unit(dmg_builder* b, const unit* u) {
    float round = fminf(u->half, fminf(0.5f * u->high, u->deep)) * dmg_range(b, 0.1f, 0.5f);
    dmg_vec size = v3(2 * u->half, u->high, 2 * u->deep);
    if (dmg_chance(b, 0.4f))
        dmg_rounded_box(b, v3(0, 0.5f * u->high, 0), size, 0.5f * round);
    else
        dmg_box(b, v3(0, 0.5f * u->high, 0), size);
}

/* Draws a whip that turns on its foot, comes up, and draws out; it lies along -X from `at`. */
static void draw_whip(dmg_builder* b, dmg_vec at, float length, float r) {
    bool turns = dmg_chance(b, 0.6f);
    int joints = dmg_int(b, 0, 3);
    uint32_t foot = 0;
    if (turns) {
        foot = dmg_spin(b, 0, "aerial_foot", at, v3(0, 1, 0));
        dmg_rod(b, at, v3(at.x, at.y + 1.5f * r, at.z), 2 * r);
    }
    float y = at.y + 2.6f * r;
    dmg_box_span(b, v3(at.x - 0.8f * r, at.y, at.z - 1.8f * r), v3(at.x + 0.8f * r, y + r, at.z - 0.8f * r));
    uint32_t last = dmg_hinge(b, foot, "aerial", v3(at.x, y, at.z), v3(0, 0, -1), 0.0f, dmg_range(b, 1.5f, 2.6f));
    dmg_rest(b, last, dmg_chance(b, 0.4f) ? 0.0f : 1.5f * dmg_unit(b));
    dmg_rod(b, v3(at.x, y, at.z - 0.7f * r), v3(at.x, y, at.z + 0.9f * r), 0.9f * r);
    dmg_rod(b, v3(at.x, y, at.z), v3(at.x - length, y, at.z), 0.7f * r);
    for (int i = 0; i < joints; ++i) { /* each a little thinner, its end out of the one before */
        float thin = 0.7f * r * powf(0.75f, (float)(i + 1)), end = length * (1.0f + 0.04f * (float)(i + 1));
        last = dmg_slide(b, last, "segment", v3(-1, 0, 0), 0.0f, 0.8f * length);
        dmg_rod(b, v3(at.x - 0.1f * length, y, at.z), v3(at.x - end, y, at.z), thin);
    }
    dmg_ellipsoid(b, v3(at.x - length * (1.0f + 0.04f * (float)joints), y, at.z), v3(r, r, r));
    dmg_use(b, 0);
}

/* Draws a lid before z = 0 over a compartment, hung at one side of four, sometimes with a window. */
static void draw_flap(dmg_builder* b, const char* name, float wide, float high, float t, int side) {
    float x = side == 2 ? -0.5f * wide : 0.5f * wide, y = side == 0 ? -0.5f * high : 0.5f * high;
    bool upright = side > 1, window = dmg_chance(b, 0.5f), lip = dmg_chance(b, 0.4f);
    dmg_vec axis = upright ? v3(0, side == 2 ? -1.0f : 1.0f, 0) : v3(side == 0 ? 1.0f : -1.0f, 0, 0);
    dmg_hinge(b, 0, name, v3(upright ? x : 0, upright ? 0 : y, 0.5f * t), axis, 0.0f, dmg_range(b, 0.4f, 1.9f));
    if (window)
        dmg_frame_draw(b, wide, high, -t, 0.15f * fminf(wide, high));
    else
        dmg_box(b, v3(0, 0, 0.55f * t), v3(wide, high, 0.9f * t));
    if (window) dmg_box(b, v3(0, 0, 0.5f * t), v3(0.75f * wide, 0.75f * high, 0.3f * t));
    if (lip)
        dmg_box(b, v3(upright ? -0.85f * x : 0, upright ? 0 : -0.85f * y, 1.2f * t),
                upright ? v3(0.06f * wide, 0.5f * high, t) : v3(0.5f * wide, 0.06f * high, t));
    dmg_use(b, 0);
}

/* Draws a row of knobs that slide in slots. */
static void draw_faders(dmg_builder* b, int count, float wide, float high, float t) {
    bool across = dmg_chance(b, 0.3f);
    for (int i = 0; i < count; ++i) {
        float at = ((float)i + 0.5f) / (float)count - 0.5f, rest = high * dmg_range(b, 0.0f, 0.7f);
        dmg_save(b);
        if (across) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_move(b, (across ? high : wide) * at, 0, 0);
        float length = across ? wide : high;
        rest *= length / high;
        dmg_box(b, v3(0, 0, 0.05f * t), v3(0.3f * t, length, 0.1f * t));
        uint32_t fader = dmg_slide(b, 0, "fader", v3(0, 1, 0), 0.0f, 0.8f * length);
        dmg_rest(b, fader, rest);
        dmg_box(b, v3(0, -0.4f * length, 0.6f * t), v3(0.12f * fminf(wide, 3 * t * (float)count), 0.12f * length, t));
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* Draws a row of keys on top, pressed. */
static void draw_top_keys(dmg_builder* b, const unit* u, float x, float wide, int count) {
    float rise = 0.03f * u->high;
    dmg_buttons keys = {.name = "key", .columns = count, .rows = 1, .rise = rise};
    keys.kind = dmg_int(b, 0, 2);
    keys.travel = dmg_button_way(b, rise);
    keys.pitch_x = wide / (float)count;
    keys.width = 0.85f * keys.pitch_x;
    keys.height = fminf(0.8f * u->deep, 1.5f * keys.pitch_x);
    dmg_save(b);
    dmg_move(b, x, u->high, 0.4f * u->deep);
    dmg_face_up(b);
    dmg_buttons_draw(b, 0, &keys);
    dmg_restore(b);
}

/* ---- radio ---- */

/* Draws a bow from side to side, its pins near the top: it folds to the front and the back. */
static void draw_bow(dmg_builder* b, const unit* u) {
    float pin = u->high * dmg_range(b, 0.75f, 0.92f), t = 0.04f * u->high, x = u->half + 0.7f * t,
          reach = hypotf(u->high - pin, u->deep) + t * dmg_range(b, 1.5f, 5.0f);
    float rest = dmg_range(b, -1.5f, 1.5f);
    bool upright = dmg_chance(b, 0.5f);
    uint32_t bow = dmg_hinge(b, 0, "handle", v3(0, pin, 0), v3(1, 0, 0), -1.57f, 1.57f);
    dmg_rest(b, bow, upright ? 0.0f : rest);
    for (int i = -1; i <= 1; i += 2) {
        float s = (float)i;
        dmg_rod(b, v3(s * (u->half - 0.1f * t), pin, 0), v3(s * (x + 0.6f * t), pin, 0), 1.1f * t);
        dmg_box_span(b, v3(s * x - 0.5f * t, pin, -0.8f * t), v3(s * x + 0.5f * t, pin + reach, 0.8f * t));
    }
    dmg_rod(b, v3(-x - 0.5f * t, pin + reach, 0), v3(x + 0.5f * t, pin + reach, 0), 0.9f * t);
    dmg_use(b, 0);
}

static void draw_speaker(dmg_builder* b, float r) {
    float t = 0.06f * r;
    dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), r, t);
    if (dmg_chance(b, 0.6f))
        dmg_cone(b, v3(0, 0, -0.05f * r), v3(0, 0, 0.12f * r), 0.4f * r, 0.2f * r);
    else
        for (int i = -3; i <= 3; ++i)
            dmg_box(b, v3(0, 0.25f * r * (float)i, 0), v3(1.6f * r * cosf(0.3f * (float)i), 0.08f * r, 2 * t));
}

/* Draws two speakers, one or two cassette decks between them, the dial with its pointer above. */
static void draw_boombox(dmg_builder* b) {
    unit u = {.half = dmg_scale_range(b, 0.12f, 0.35f)};
    u.high = u.half * dmg_range(b, 0.8f, 1.3f);
    u.deep = u.half * dmg_range(b, 0.2f, 0.4f);
    float r = fminf(0.28f * u.half, 0.32f * u.high), t = 0.03f * u.high, bay = 0.5f * u.half;
    int decks = dmg_int(b, 0, 2), side = dmg_weighted(b, (const float[]){4, 1, 1, 1}, 4);
    int faders = dmg_chance(b, 0.5f) ? dmg_int(b, 2, 6) : 0, keys = dmg_chance(b, 0.7f) ? dmg_int(b, 4, 7) : 0;
    float row = 0.79f * u.high, way = 0.7f * u.half, rest = way * dmg_unit(b);
    draw_unit(b, &u);
    dmg_save(b);
    dmg_move(b, 0, 0, u.deep);
    for (int i = -1; i <= 1; i += 2) {
        dmg_save(b);
        dmg_move(b, (float)i * 0.66f * u.half, 0.36f * u.high, 0);
        draw_speaker(b, r);
        dmg_restore(b);
    }
    for (int i = 0; i < decks; ++i) {
        dmg_save(b);
        dmg_move(b, 0, (decks == 1 ? 0.36f : 0.22f + 0.28f * (float)i) * u.high, 0);
        draw_flap(b, "cassette_door", 0.9f * bay, (decks == 1 ? 0.4f : 0.24f) * u.high, t, side);
        dmg_restore(b);
    }
    dmg_box(b, v3(-0.2f * u.half, row, 0), v3(way * 1.15f, 0.1f * u.high, 0.3f * t));
    uint32_t pointer = dmg_slide(b, 0, "pointer", v3(1, 0, 0), 0.0f, way);
    dmg_rest(b, pointer, rest);
    dmg_box(b, v3(-0.2f * u.half - 0.5f * way, row, 0.4f * t), v3(0.02f * u.half, 0.12f * u.high, 0.3f * t));
    dmg_use(b, 0);
    dmg_move(b, 0.6f * u.half, row, 0);
    if (faders)
        draw_faders(b, faders, 0.5f * u.half, 0.2f * u.high, 0.8f * t);
    else
        dmg_knobs_draw(b, 0, 2, 0.3f * u.half, 0, 0.11f * u.half);
    dmg_restore(b);
    if (keys) draw_top_keys(b, &u, 0, 0.9f * u.half, keys);
    if (dmg_chance(b, 0.8f)) draw_bow(b, &u);
    float length = u.half * dmg_range(b, 0.9f, 1.6f);
    if (dmg_chance(b, 0.85f)) draw_whip(b, v3(0.85f * u.half, u.high, -0.6f * u.deep), length, 0.014f * u.half);
}

/* Draws the clip for a belt: its lower end leaves the case. */
static void draw_clip(dmg_builder* b, const unit* u, float t) {
    dmg_vec pin = {0, 0.8f * u->high, -u->deep - t};
    dmg_box(b, v3(0, pin.y, -u->deep - 0.4f * t), v3(0.5f * u->half, 2 * t, t));
    dmg_hinge(b, 0, "clip", pin, v3(1, 0, 0), 0.0f, 0.35f);
    dmg_box_span(b, v3(-0.3f * u->half, 0.35f * u->high, pin.z - 0.8f * t), v3(0.3f * u->half, pin.y + 3 * t, pin.z));
}

/* Draws a key at the side that the thumb holds down; knobs and the aerial on top. */
static void draw_walkie_talkie(dmg_builder* b) {
    unit u = {.half = dmg_range(b, 0.022f, 0.04f)};
    u.high = u.half * dmg_range(b, 3.4f, 5.0f);
    u.deep = u.half * dmg_range(b, 0.45f, 0.75f);
    float y = 0.72f * u.high, key = 0.1f * u.high, t = 0.1f * u.half, r = 0.16f * u.half;
    int knobs = dmg_int(b, 1, 2), aerial = dmg_int(b, 0, 2);
    draw_unit(b, &u);
    if (dmg_chance(b, 0.5f))
        dmg_hinge(b, 0, "talk_key", v3(-u.half, y + key, 0), v3(0, 0, 1), 0.0f, 0.7f * t / key);
    else
        dmg_slide(b, 0, "talk_key", v3(1, 0, 0), 0.0f, 0.6f * t);
    dmg_rounded_box(b, v3(-u.half, y, 0), v3(2 * t, 2 * key, u.deep), 0.3f * t);
    for (int i = 0; i < knobs; ++i) {
        float x = u.half * (0.1f - 0.6f * (float)i);
        dmg_save(b);
        dmg_move(b, x, u.high, 0);
        dmg_face_up(b);
        dmg_hinge(b, 0, i ? "channel" : "volume", v3(0, 0, 0), v3(0, 0, -1), 0.0f, 4.7f);
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 0.24f * u.half, 0.35f * u.half);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    float x = 0.66f * u.half, whip = u.high * dmg_range(b, 0.5f, 1.3f);
    if (aerial == 1) { /* drawn out of the case */
        dmg_rod(b, v3(x, u.high, 0), v3(x, u.high + 2 * r, 0), 1.4f * r);
        dmg_slide(b, 0, "aerial", v3(0, 1, 0), 0.0f, 0.75f * u.high);
        dmg_rod(b, v3(x, 0.15f * u.high, 0), v3(x, u.high + 2.5f * r, 0), 0.6f * r);
    }
    if (aerial == 2) { /* folds down along the side */
        dmg_box(b, v3(u.half, u.high - r, 0), v3(2 * r, 2 * r, 3 * r));
        dmg_hinge(b, 0, "aerial", v3(u.half + 1.5f * r, u.high, 0), v3(0, 0, -1), 0.0f, DMG_PI);
        x = u.half + 1.5f * r;
    }
    if (aerial != 1) dmg_cone(b, v3(x, u.high - 0.2f * r, 0), v3(x, u.high + whip, 0), r, 0.6f * r);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0, 0.62f * u.high, u.deep);
    draw_speaker(b, 0.55f * u.half);
    dmg_move(b, 0, -0.32f * u.high, 0);
    if (dmg_chance(b, 0.6f)) dmg_controls_draw(b, 0, 1.5f * u.half, 0.35f * u.high);
    dmg_restore(b);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) draw_clip(b, &u, t);
}

/* Draws a box with a dial: by the bed, or of wood on a shelf. */
static void draw_table_radio(dmg_builder* b) {
    unit u = {.half = dmg_scale_range(b, 0.08f, 0.25f)};
    u.high = u.half * dmg_range(b, 0.5f, 1.4f);
    u.deep = u.half * dmg_range(b, 0.4f, 0.8f);
    bool clock = dmg_chance(b, 0.5f);
    float r = 0.13f * u.half, t = 0.04f * u.half, wide = u.half * dmg_range(b, 0.6f, 1.6f);
    draw_unit(b, &u);
    dmg_save(b);
    dmg_move(b, 0, 0.55f * u.high, u.deep);
    if (clock)
        dmg_box(b, v3(0, 0, 0), v3(1.5f * u.half, 0.5f * u.high, t));
    else
        draw_speaker(b, 0.36f * fminf(u.high, u.half));
    dmg_move(b, 0, -0.36f * u.high, 0);
    dmg_knobs_draw(b, 0, dmg_int(b, 2, 4), 0.42f * u.half, 0, fminf(r, 0.1f * u.high));
    dmg_restore(b);
    dmg_use(b, 0);
    if (clock && dmg_chance(b, 0.8f)) { /* the bar that buys nine minutes: on a hinge behind, or pressed straight */
        float way = 0.5f * t;
        dmg_vec middle = v3(0, u.high + 0.4f * t, 0.3f * u.deep);
        if (dmg_chance(b, 0.4f))
            dmg_hinge(b, 0, "snooze", v3(0, u.high, 0.3f * u.deep - r), v3(1, 0, 0), 0.0f, way / (2 * r));
        else
            dmg_slide(b, 0, "snooze", v3(0, -1, 0), 0.0f, way);
        dmg_rounded_box(b, middle, v3(wide, 1.4f * t, 2 * r), 0.3f * t);
        dmg_use(b, 0);
    }
    float z = u.deep * dmg_range(b, -0.5f, 0.5f), y = 0.6f * u.high;
    dmg_spin(b, 0, "tuning", v3(u.half - 0.5f * r, y, z), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(u.half - 0.5f * r, y - 0.8f * t, z), v3(u.half - 0.5f * r, y + 0.8f * t, z), r);
    dmg_use(b, 0);
    if (!clock && dmg_chance(b, 0.35f)) { /* a lid over a turntable */
        float lid = 0.25f * u.high, wall = 0.5f * t;
        dmg_spin(b, 0, "platter", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, u.high, 0), v3(0, u.high + 0.3f * lid, 0), 0.7f * fminf(u.deep, u.half));
        dmg_hinge(b, 0, "lid", v3(0, u.high, -0.8f * u.deep), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.6f));
        dmg_save(b);
        dmg_move(b, 0, u.high + lid, -0.8f * u.deep);
        dmg_turn(b, v3(1, 0, 0), DMG_PI);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, 1.8f * u.half, lid, 1.7f * u.deep, wall);
        dmg_restore(b);
    } else if (dmg_chance(b, 0.5f)) {
        draw_whip(b, v3(0.8f * u.half, u.high, -0.85f * u.deep), 1.3f * u.half, 0.02f * u.half);
    }
}

void dmg_build_radio(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 3, 3}, 3);
    if (dmg_chance(b, 0.3f)) dmg_mirror(b, v3(1, 0, 0));
    if (kind == 0) draw_boombox(b);
    if (kind == 1) draw_walkie_talkie(b);
    if (kind == 2) draw_table_radio(b);
}
