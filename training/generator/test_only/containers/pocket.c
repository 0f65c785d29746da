/* Draws pocket things that fold or slide: game consoles, telephones, organisers, mirrors, jewel boxes, spectacle
 * cases, tins. The hinge lies at the slabs' rear edge, between them; the lid rises from +Z. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- two slabs and the barrel behind them ---- */

typedef struct slabs {
    float half, deep; /* half the width; from the hinge line to the front */
    float low, high;  /* how thick the lower and the upper one are */
    float gap, r;     /* between them; of the barrel */
    float corner;
    int hinge; /* 0 knuckles, 1 two axles, 2 none drawn, 3 a tube along the whole edge */
    bool soft; /* edges rounded all over */
    bool hollow;
    float rear; /* where the slabs begin */
} slabs;

static slabs slabs_pick(dmg_builder* b, float half, float deep, float low, float high) {
    slabs s = {.half = half, .deep = deep, .low = low, .high = high};
    static const float weights[] = {5, 1.6f, 1, 1.2f};
    float wide = dmg_range(b, 0.4f, 0.9f), round = dmg_range(b, 0.02f, 0.5f);
    s.gap = 0.08f * fminf(low, high);
    s.r = wide * fminf(fminf(low, high), 0.12f * deep);
    s.hinge = dmg_weighted(b, weights, 4);
    s.soft = dmg_chance(b, 0.35f);
    s.corner = 0.4f * round * fminf(half, deep);
    s.rear = s.hinge == 0 || s.hinge == 3 ? 1.03f * s.r : 0.0f;
    return s;
}

/* Draws a slab between two heights, lying. */
static void draw_slab(dmg_builder* b, const slabs* s, float y0, float y1) {
    float deep = s->deep - s->rear;
    dmg_vec middle = v3(0, 0.5f * (y0 + y1), s->rear + 0.5f * deep);
    if (s->soft && s->corner < 0.25f * s->half) {
        dmg_rounded_box(b, middle, v3(2 * s->half, y1 - y0, deep), 0.45f * (y1 - y0));
        return;
    }
    dmg_save(b);
    dmg_move(b, 0, y1, middle.z);
    dmg_face_up(b);
    dmg_rounded_plate(b, 2 * s->half, deep, y1 - y0, s->corner);
    dmg_restore(b);
}

/* Draws the upper slab's part with what it hangs on; the frame's origin is on the hinge line's level z = 0. */
static uint32_t add_lid(dmg_builder* b, const slabs* s, const char* name, float upper) {
    float y = s->low + 0.5f * s->gap, third = s->half * dmg_range(b, 0.25f, 0.7f), r = s->r;
    if (s->hinge == 1) { /* the spine turns on the lower slab, the lid on the spine */
        float way = 0.5f * fminf(upper, 3.14f), top = s->low + s->gap + 0.5f * s->high, t = 0.5f * fminf(r, s->low);
        uint32_t spine = dmg_hinge(b, 0, "spine", v3(0, 0.5f * s->low, -0.2f * t), v3(-1, 0, 0), 0.0f, way);
        dmg_rounded_box(b, v3(0, 0.5f * (0.5f * s->low + top), -0.7f * t),
                        v3(1.9f * third, top - 0.5f * s->low + 1.2f * t, t), 0.4f * t);
        return dmg_hinge(b, spine, name, v3(0, top, -0.2f * t), v3(-1, 0, 0), 0.0f, way);
    }
    bool swap = dmg_chance(b, 0.5f), tube = s->hinge == 3;
    float end = s->half * dmg_range(b, 0.72f, 0.99f);
    if (s->hinge == 2) return dmg_hinge(b, 0, name, v3(0, y, 0), v3(-1, 0, 0), 0.0f, upper);
    if (tube) { /* the tube goes with the body, flanges on it with the lid */
        dmg_rod(b, v3(-end, y, 0), v3(end, y, 0), 0.75f * r);
        dmg_box_span(b, v3(-0.9f * end, y - 0.5f * r, 0), v3(0.9f * end, y - 0.05f * r, s->rear + 0.1f * r));
        uint32_t lid = dmg_hinge(b, 0, name, v3(0, y, 0), v3(-1, 0, 0), 0.0f, upper);
        for (int i = -1; i <= 1; i += 2) {
            dmg_rod(b, v3((float)i * 1.0f * end, y, 0), v3((float)i * 0.93f * end, y, 0), r);
            dmg_box_span(b, v3((float)i * 0.965f * end - 0.035f * end, y, 0),
                         v3((float)i * 0.965f * end + 0.035f * end, y + 0.7f * r, s->rear + 0.1f * r));
        }
        return lid;
    }
    uint32_t lid = 0;
    for (int pass = 0; pass < 2; ++pass) { /* the middle knuckle, then the outer ones */
        bool of_lid = (pass == 0) != swap;
        if (of_lid) lid = dmg_hinge(b, 0, name, v3(0, y, 0), v3(-1, 0, 0), 0.0f, upper);
        dmg_use(b, of_lid ? lid : 0);
        float from = pass ? third + 0.02f * s->half : -third, to = pass ? fmaxf(end, third + 0.2f * s->half) : third;
        for (int i = 0; i <= pass; ++i) {
            float x0 = i ? -to : from, x1 = i ? -from : to;
            dmg_rod(b, v3(x0, y, 0), v3(x1, y, 0), r);
            dmg_box_span(b, v3(x0, of_lid ? y + 0.06f * r : y - 0.7f * r, 0),
                         v3(x1, of_lid ? y + 0.7f * r : y - 0.06f * r, s->rear + 0.1f * r));
        }
    }
    dmg_use(b, lid);
    return lid;
}

/* To the lower slab's upper face: +Z out of it, +Y towards the hinge. */
static void go_to_deck(dmg_builder* b, const slabs* s, float x, float z) {
    dmg_move(b, x, s->low, z);
    dmg_face_up(b);
}

/* Draws the lid with a screen or a mirror inside, and whatever there is on its back. */
static uint32_t draw_screen_lid(dmg_builder* b, const slabs* s, float upper) {
    float y0 = s->low + s->gap, y1 = y0 + s->high, border = dmg_range(b, 0.6f, 0.92f), mid = 0.5f * (s->rear + s->deep);
    uint32_t lid = add_lid(b, s, "lid", upper);
    if (dmg_chance(b, 0.6f)) dmg_rest(b, lid, b->parts[lid - 1].joint.upper * dmg_unit(b));
    draw_slab(b, s, y0, y1);
    dmg_box(b, v3(0, y0, mid), v3(1.9f * s->half * border, 0.3f * s->gap, 0.9f * (s->deep - s->rear) * border));
    int back = dmg_int(b, 0, 3);
    float size = 0.2f * fminf(s->half, s->deep);
    if (back == 1) dmg_rod(b, v3(0, y1, mid), v3(0, y1 + 0.3f * s->gap, mid), 1.5f * size);
    if (back == 2) dmg_box(b, v3(0, y1, mid + size), v3(4 * size, 0.6f * s->gap, 2 * size));
    if (back == 3)
        dmg_rod(b, v3(-0.6f * s->half, y1, s->deep - 2 * size),
                v3(-0.6f * s->half, y1 + 0.15f * s->high, s->deep - 2 * size), 0.6f * size);
    dmg_use(b, 0);
    return lid;
}

/* ---- what is on the lower slab ---- */

/* Draws a cross that rocks, a disc that slides both ways, or four keys. */
static void draw_thumb_place(dmg_builder* b, float r, float rise, int kind) {
    if (kind == 0) {
        dmg_hinge(b, 0, "cross", v3(0, 0, 0), v3(1, 0, 0), -0.08f, 0.08f);
        dmg_box(b, v3(0, 0, 0.2f * rise), v3(2 * r, 0.66f * r, 1.4f * rise));
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3(0, (float)i * 0.665f * r, 0.2f * rise), v3(0.66f * r, 0.67f * r, 1.4f * rise));
    } else if (kind == 1) {
        uint32_t skirt = dmg_slide(b, 0, "pad_x", v3(1, 0, 0), -0.25f * r, 0.25f * r);
        dmg_rod(b, v3(0, 0, -0.2f * rise), v3(0, 0, 0.3f * rise), r);
        dmg_slide(b, skirt, "pad_y", v3(0, 1, 0), -0.25f * r, 0.25f * r);
        dmg_rod(b, v3(0, 0, 0.35f * rise), v3(0, 0, 0.95f * rise), 0.7f * r);
    } else {
        for (int i = 0; i < 4; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 0, 1), i, 4);
            dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, 0.7f * rise);
            dmg_rod(b, v3(0.68f * r, 0, -0.4f * rise), v3(0.68f * r, 0, rise), 0.28f * r);
            dmg_restore(b);
        }
    }
    dmg_use(b, 0);
}

/* Keys behind the hinge's ends, at the slab's rear corners: pressed forward, or turning about their inner ends. */
static void draw_shoulders(dmg_builder* b, const slabs* s) {
    bool turns = dmg_chance(b, 0.5f);
    float wide = 0.24f * s->half, t = 0.5f * s->r;
    for (int i = 0; i < 2; ++i) {
        dmg_save(b);
        if (i) dmg_mirror(b, v3(1, 0, 0));
        float x = s->half - wide - 0.02f * s->half;
        if (turns)
            dmg_hinge(b, 0, "shoulder", v3(x, 0, s->rear), v3(0, -1, 0), 0.0f, 0.3f * t / wide);
        else
            dmg_slide(b, 0, "shoulder", v3(0, 0, 1), 0.0f, 0.3f * t);
        dmg_box_span(b, v3(x, 0.3f * s->low, s->rear - t), v3(x + wide, 0.95f * s->low, s->rear));
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* On the slab's right side and front: sliders, a thumb wheel, a stylus that is drawn out. */
static void draw_edge_things(dmg_builder* b, const slabs* s) {
    float y = 0.5f * s->low, t = 0.25f * s->low, mid = 0.5f * s->deep;
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, 0, "slider", v3(0, 0, 1), 0.0f, 0.12f * s->deep);
        dmg_box_span(b, v3(s->half - t, y - 0.5f * t, mid),
                     v3(s->half + 0.7f * t, y + 0.5f * t, mid + 0.08f * s->deep));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.3f)) {
        float r = 0.08f * s->half;
        dmg_spin(b, 0, "thumb_wheel", v3(-s->half + 0.6f * r, y, mid), v3(0, 1, 0));
        dmg_rod(b, v3(-s->half + 0.6f * r, y - 0.5f * t, mid), v3(-s->half + 0.6f * r, y + 0.5f * t, mid), r);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.3f)) {
        float r = 0.3f * s->low, x = s->half + 0.4f * r, way = 0.5f * s->deep;
        dmg_slide(b, 0, "stylus", v3(0, 0, 1), 0.0f, way);
        dmg_rod(b, v3(x, y, s->deep - 1.2f * way), v3(x, y, s->deep), r);
        dmg_use(b, 0);
        dmg_box_span(b, v3(s->half - r, 0.1f * s->low, 0.2f * s->deep),
                     v3(x + 1.3f * r, 0.9f * s->low, 0.3f * s->deep));
    }
}

/* ---- the kinds of pocket thing ---- */

static void draw_console(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.035f, 0.09f), deep = half * dmg_range(b, 0.9f, 1.3f),
          low = half * dmg_range(b, 0.12f, 0.24f), high = low * dmg_range(b, 0.5f, 1.0f);
    slabs s = slabs_pick(b, half, deep, low, high);
    float r = half * dmg_range(b, 0.14f, 0.2f), z = deep * dmg_range(b, 0.35f, 0.5f), rise = 0.6f * s.gap;
    int left = dmg_int(b, 0, 1), below = dmg_int(b, 0, 2);
    draw_slab(b, &s, 0, low);
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, low, 0.55f * deep), v3(0.95f * half, 0.3f * s.gap, 0.6f * deep));
    draw_screen_lid(b, &s, dmg_range(b, 2.0f, 3.1f));
    for (int i = -1; i <= 1; i += 2) {
        dmg_save(b);
        go_to_deck(b, &s, (float)i * 0.75f * half, z);
        draw_thumb_place(b, r, rise, i < 0 ? left : 2);
        dmg_restore(b);
        if (below != (i < 0 ? 1 : 2)) continue;
        dmg_save(b);
        go_to_deck(b, &s, (float)i * 0.75f * half, z + 2.2f * r);
        draw_thumb_place(b, 0.8f * r, rise, i < 0 ? 1 - left : 2);
        dmg_restore(b);
    }
    if (s.rear > 0.0f && dmg_chance(b, 0.7f)) draw_shoulders(b, &s);
    draw_edge_things(b, &s);
}

/* Draws a numeric pad on a telephone, or rows of letters. */
static void draw_keys(dmg_builder* b, const slabs* s, bool letters, float from) {
    int columns = letters ? dmg_int(b, 8, 11) : 3, rows = letters ? dmg_int(b, 3, 5) : 4;
    float room = (s->deep - s->rear) * (0.93f - from), fill = dmg_range(b, 0.65f, 0.92f), rise = 0.5f * s->gap;
    dmg_buttons keys = {.name = "key", .columns = columns, .rows = rows, .rise = rise, .travel = 0.7f * rise};
    keys.kind = dmg_int(b, 0, 2);
    keys.pitch_x = 1.84f * s->half / (float)columns;
    keys.pitch_y = room / (float)rows;
    keys.width = fill * keys.pitch_x;
    keys.height = fill * keys.pitch_y;
    dmg_save(b);
    go_to_deck(b, s, 0, s->rear + (s->deep - s->rear) * from + 0.5f * room);
    dmg_buttons_draw(b, 0, &keys);
    dmg_restore(b);
}

static void draw_folding_phone(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.02f, 0.04f), deep = half * dmg_range(b, 2.4f, 4.0f),
          low = half * dmg_range(b, 0.25f, 0.5f), high = low * dmg_range(b, 0.5f, 1.0f);
    slabs s = slabs_pick(b, half, deep, low, high);
    draw_slab(b, &s, 0, low);
    draw_screen_lid(b, &s, dmg_range(b, 2.4f, 3.1f));
    draw_keys(b, &s, false, 0.36f);
    dmg_save(b);
    go_to_deck(b, &s, 0, s.rear + 0.18f * deep);
    draw_thumb_place(b, 0.4f * half, 0.6f * s.gap, dmg_chance(b, 0.5f) ? 0 : 2);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f)) { /* a whip drawn out of the rear */
        float x = 0.86f * half, r = 0.12f * low, way = deep * dmg_range(b, 0.3f, 0.8f);
        dmg_slide(b, 0, "antenna", v3(0, 0, -1), 0.0f, way);
        dmg_rod(b, v3(x, 0.45f * low, -0.1f * deep), v3(x, 0.45f * low, 0.9f * way), r);
        dmg_rod(b, v3(x, 0.45f * low, -0.22f * deep), v3(x, 0.45f * low, -0.1f * deep), 2 * r);
        dmg_use(b, 0);
    }
    draw_edge_things(b, &s);
}

static void draw_organiser(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.05f, 0.11f), deep = half * dmg_range(b, 0.9f, 1.2f),
          low = half * dmg_range(b, 0.1f, 0.2f), high = low * dmg_range(b, 0.4f, 1.0f);
    slabs s = slabs_pick(b, half, deep, low, high);
    draw_slab(b, &s, 0, low);
    draw_screen_lid(b, &s, dmg_range(b, 1.7f, 3.1f));
    draw_keys(b, &s, true, dmg_range(b, 0.1f, 0.3f));
    draw_edge_things(b, &s);
}

/* The upper slab slides away from the keys, or turns away over them about a corner or its middle. */
static void draw_sliding_phone(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.022f, 0.04f), deep = half * dmg_range(b, 3.2f, 4.2f),
          low = half * dmg_range(b, 0.2f, 0.4f), high = low * dmg_range(b, 0.5f, 1.0f);
    slabs s = slabs_pick(b, half, deep, low, high);
    static const float weights[] = {4, 2, 2, 1.5f};
    int motion = dmg_weighted(b, weights, 4);
    float way = deep * dmg_range(b, 0.35f, 0.6f), at = dmg_sign(b), y0 = low + s.gap, y1 = y0 + high;
    s.rear = 0;
    draw_slab(b, &s, 0, low);
    draw_keys(b, &s, motion == 1 && dmg_chance(b, 0.5f), 1.0f - 0.9f * way / deep);
    if (dmg_chance(b, 0.5f)) { /* rails along the sides, under the slider */
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3((float)i * 0.96f * half, low + 0.4f * s.gap, 0.5f * deep),
                    v3(0.05f * half, 0.8f * s.gap, 0.9f * deep));
    }
    float turn = motion == 2 ? 3.14f : 1.57f * dmg_range(b, 1.0f, 2.0f), inset = 0.8f * half;
    uint32_t slider;
    if (motion < 2)
        slider = dmg_slide(b, 0, "slider", motion ? v3(at, 0, 0) : v3(0, 0, -1), 0.0f, motion ? 0.5f * way : way);
    else
        slider =
            dmg_hinge(b, 0, "swivel", v3(motion == 3 ? at * 0.1f * half : 0, low, motion == 3 ? 0.5f * deep : inset),
                      v3(0, at, 0), 0.0f, turn);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, slider, b->parts[slider - 1].joint.upper * dmg_unit(b));
    draw_slab(b, &s, y0, y1);
    if (motion > 1)
        dmg_rod(b, v3(0, low, motion == 3 ? 0.5f * deep : inset), v3(0, y0, motion == 3 ? 0.5f * deep : inset),
                0.3f * half);
    dmg_box(b, v3(0, y1, 0.45f * deep), v3(1.7f * half, 0.3f * s.gap, 0.7f * deep));
    dmg_slide(b, slider, "home_key", v3(0, -1, 0), 0.0f, 0.3f * s.gap);
    dmg_rod(b, v3(0, y1 - s.gap, 0.9f * deep), v3(0, y1 + 0.5f * s.gap, 0.9f * deep), 0.25f * half);
    dmg_use(b, 0);
    draw_edge_things(b, &s);
}

/* Draws a pressed catch at the front; a pan that comes up on a hinge of its own. */
static void draw_compact(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.025f, 0.06f), deep = 2 * half * dmg_range(b, 0.7f, 1.1f),
          low = half * dmg_range(b, 0.12f, 0.3f), high = low * dmg_range(b, 0.3f, 1.0f);
    slabs s = slabs_pick(b, half, deep, low, high);
    bool round = dmg_chance(b, 0.6f), catches = dmg_chance(b, 0.6f);
    float from = s.low - 0.6f * s.low, pan = dmg_range(b, 0.55f, 0.75f) * half;
    if (round) {
        s.soft = false;
        s.corner = fminf(half, 0.5f * (deep - s.rear));
        s.hinge = s.hinge == 3 ? 0 : s.hinge;
        s.half = s.corner;
        s.rear = s.rear > 0.0f ? 0.5f * s.rear : 0.0f;
    }
    draw_slab(b, &s, 0, low);
    draw_screen_lid(b, &s, dmg_range(b, 1.6f, 3.0f));
    float mid = 0.5f * (s.rear + s.deep);
    if (dmg_chance(b, 0.6f)) {
        dmg_hinge(b, 0, "pan", v3(0, low, mid - pan), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.6f));
        dmg_rod(b, v3(0, from, mid), v3(0, low + 0.4f * s.gap, mid), 0.9f * fminf(pan, 0.5f * (deep - s.rear)));
        dmg_use(b, 0);
    }
    if (!catches) return;
    dmg_slide(b, 0, "catch", v3(0, 0, -1), 0.0f, 0.12f * low);
    dmg_box_span(b, v3(-0.15f * half, 0.2f * low, deep - 0.2f * low), v3(0.15f * half, 0.95f * low, deep + 0.3f * low));
    dmg_use(b, 0);
}

/* ---- boxes: hollow halves ---- */

/* Draws the lid over a box: a slab, a shallow tray upside down, or a roof bent over the length. */
static void draw_box_lid(dmg_builder* b, const slabs* s, float t, int kind) {
    enum { STEPS = 7 };
    float y = s->low + s->gap, deep = s->deep - s->rear;
    dmg_xy line[STEPS];
    if (kind == 0) draw_slab(b, s, y, y + s->high);
    if (kind == 1) {
        dmg_save(b);
        dmg_move(b, 0, y + s->high, s->rear);
        dmg_turn(b, v3(1, 0, 0), DMG_PI);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, 2 * s->half, s->high, deep, t);
        dmg_restore(b);
    }
    if (kind != 2) return;
    for (int i = 0; i < STEPS; ++i) {
        float angle = DMG_PI * (float)i / (STEPS - 1);
        line[i] = (dmg_xy){(0.5f * deep - 0.5f * t) * cosf(angle), (s->high - t) * sinf(angle)};
    }
    dmg_save(b);
    dmg_move(b, 0, y + 0.3f * t, s->rear + 0.5f * deep);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_bent_plate(b, line, STEPS, t, 2 * s->half - 2 * t);
    for (int i = -1; i <= 1; i += 2)
        dmg_extrude(b, line, STEPS, (float)i * (s->half - 0.7f * t) - 0.3f * t,
                    (float)i * (s->half - 0.7f * t) + 0.3f * t);
    dmg_restore(b);
}

/* Draws what holds the lid down in front: a hasp hung on it, a hook on the box, a button. */
static void draw_fastener(dmg_builder* b, const slabs* s, uint32_t lid, float t) {
    float y = s->low + 0.5f * s->gap, z = s->deep, w = 0.12f * s->half, drop = fminf(0.5f * s->low, 2 * w);
    switch (dmg_int(b, 0, 3)) {
    case 0:
        dmg_hinge(b, lid, "hasp", v3(0, y + s->gap + 0.5f * t, z + 0.5f * t), v3(-1, 0, 0), 0.0f, 1.6f);
        dmg_box_span(b, v3(-w, y - drop, z + 0.1f * t), v3(w, y + s->gap + t, z + 0.8f * t));
        dmg_rod(b, v3(-w, y + s->gap + t, z + 0.5f * t), v3(w, y + s->gap + t, z + 0.5f * t), 0.5f * t);
        dmg_use(b, 0);
        dmg_rod(b, v3(0, y - 1.3f * drop, z), v3(0, y - 1.3f * drop, z + t), 0.4f * w);
        break;
    case 1:
        dmg_use(b, lid);
        dmg_rod(b, v3(0, y + s->gap + 1.5f * t, z), v3(0, y + s->gap + 1.5f * t, z + 1.2f * t), 0.5f * t);
        dmg_hinge(b, 0, "hook", v3(2 * w, y - t, z + 0.6f * t), v3(0, 0, -1), 0.0f, 1.8f);
        dmg_rod(b, v3(2 * w, y - t, z), v3(2 * w, y - t, z + 1.1f * t), 0.6f * t);
        dmg_beam(b, v3(2 * w, y - t, z + 0.7f * t), v3(0.7f * t, y + s->gap + 1.5f * t, z + 0.7f * t), 0.5f * t,
                 0.6f * t);
        break;
    case 2:
        dmg_slide(b, 0, "catch", v3(0, 0, -1), 0.0f, 0.4f * t);
        dmg_rod(b, v3(0, y - drop, z - 0.1f * t), v3(0, y - drop, z + 0.9f * t), 0.6f * w);
        break;
    default:
        dmg_use(b, lid);
        dmg_box(b, v3(0, y + s->gap + 0.6f * t, z + 0.3f * t), v3(2 * w, t, t));
        break;
    }
    dmg_use(b, 0);
}

/* Draws a tray that lifts out of the box, a ring stand that springs up, or compartments. */
static void draw_inside(dmg_builder* b, const slabs* s, float t, float floor) {
    float mid = 0.5f * (s->rear + s->deep), deep = s->deep - s->rear - 2.4f * t, wide = 2 * s->half - 2.4f * t;
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) {
        float high = 0.4f * (s->low - floor);
        dmg_slide(b, 0, "tray", v3(0, 1, 0), 0.0f, 1.5f * s->low);
        dmg_save(b);
        dmg_move(b, 0, s->low - high, mid + 0.5f * deep);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, wide, high, deep, 0.6f * t);
        dmg_restore(b);
    }
    if (kind == 1) { /* half of the top is a flap over a place of its own */
        dmg_hinge(b, 0, "flap", v3(-0.5f * wide, s->low - 0.5f * t, 0), v3(0, 0, 1), 0.0f, 1.7f);
        dmg_box_span(b, v3(-0.5f * wide, s->low - 0.8f * t, mid - 0.5f * deep),
                     v3(-0.1f * wide, s->low - 0.2f * t, mid + 0.5f * deep));
    }
    if (kind == 2) {
        dmg_box_span(b, v3(-0.5f * t, 0.5f * floor, mid - 0.52f * deep),
                     v3(0.5f * t, 0.9f * s->low, mid + 0.52f * deep));
        dmg_rounded_box(b, v3(0.25f * wide, 0.4f * (floor + s->low), mid),
                        v3(0.4f * wide, 0.5f * (s->low - floor), 0.7f * deep), t);
    }
    if (kind == 3) { /* a figure that turns on its pin */
        float r = 0.05f * fminf(wide, deep), top = floor + 0.75f * (s->low - floor);
        dmg_spin(b, 0, "dancer", v3(0, 0, mid), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.5f * floor, mid), v3(0, top, mid), 0.5f * r);
        dmg_cone(b, v3(0, floor + 0.3f * (top - floor), mid), v3(0, floor + 0.7f * (top - floor), mid), 3 * r, r);
        dmg_beam(b, v3(-2 * r, floor + 0.7f * (top - floor), mid), v3(2 * r, top, mid), 0.4f * r, 0.4f * r);
    }
    dmg_use(b, 0);
}

/* Draws a storey under the tray with a drawer in it. */
static void draw_box_drawer(dmg_builder* b, const slabs* s, float t, float floor) {
    float y0 = floor + t, y1 = floor + 0.25f * s->low, rear = s->rear;
    dmg_box_span(b, v3(-s->half, floor, rear), v3(s->half, y0, s->deep));
    for (int i = -1; i <= 1; i += 2) {
        float x = (float)i * (s->half - 0.5f * t);
        dmg_box_span(b, v3(x - 0.5f * t, y0, rear), v3(x + 0.5f * t, y1, s->deep));
    }
    dmg_box_span(b, v3(-s->half + t, y0, rear), v3(s->half - t, y1, rear + t));
    dmg_drawer d = dmg_drawer_pick(b, 0.3f * s->half);
    d.width = 2 * s->half - 2.2f * t;
    d.height = y1 - y0 - 0.1f * t;
    d.thickness = 0.7f * t;
    d.depth = s->deep - rear - 2.5f * t;
    d.travel = 0.85f * d.depth;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (y0 + y1), s->deep + 0.35f * t);
    dmg_drawer_draw(b, 0, "drawer", &d);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_jewel_box(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.03f, 0.15f), deep = 2 * half * dmg_range(b, 0.5f, 1.0f),
          low = half * dmg_range(b, 0.35f, 1.2f), high = low * dmg_range(b, 0.2f, 0.8f);
    slabs s = slabs_pick(b, half, deep, low, high);
    float t = half * dmg_range(b, 0.04f, 0.09f), floor = 0;
    s.hinge = s.hinge == 1 ? 2 : s.hinge;
    s.r = fminf(s.r, 1.5f * t);
    s.rear = s.hinge == 2 ? 0.0f : 1.03f * s.r;
    s.corner = fminf(s.corner, t);
    s.gap = fminf(s.gap, 0.3f * t);
    int drawers = dmg_chance(b, 0.4f) ? dmg_int(b, 1, 2) : 0, kind = dmg_int(b, 0, 2);
    for (int i = 0; i < drawers; ++i) {
        draw_box_drawer(b, &s, t, floor);
        floor += 0.25f * low;
    }
    dmg_save(b);
    dmg_move(b, 0, floor, deep);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, 2 * half, low - floor, deep - s.rear, t);
    dmg_restore(b);
    draw_inside(b, &s, t, floor + t);
    uint32_t lid = add_lid(b, &s, "lid", dmg_range(b, 1.3f, 2.2f));
    if (dmg_chance(b, 0.4f)) dmg_rest(b, lid, b->parts[lid - 1].joint.upper * dmg_unit(b));
    draw_box_lid(b, &s, t, kind);
    draw_fastener(b, &s, lid, t);
}

/* Draws two long half shells. */
static void draw_spectacle_case(dmg_builder* b) {
    enum { STEPS = 9 };
    float half = dmg_range(b, 0.07f, 0.09f), deep = half * dmg_range(b, 0.6f, 0.9f),
          high = deep * dmg_range(b, 0.25f, 0.45f);
    slabs s = slabs_pick(b, half, deep, high, high);
    float t = 0.05f * deep, power = dmg_range(b, 0.4f, 1.0f), share = dmg_range(b, 0.6f, 1.0f),
          glass = dmg_range(b, 0.3f, 0.6f);
    s.rear = s.hinge == 2 ? 0.0f : 1.03f * s.r;
    float mid = 0.5f * (s.rear + deep), reach = 0.5f * (deep - s.rear);
    dmg_xy line[STEPS];
    uint32_t lid = 0;
    for (int upper = 0; upper < 2; ++upper) {
        float rise = (upper ? share : 1.0f) * high - 0.5f * t, level = upper ? s.low + s.gap : s.low;
        if (upper) lid = add_lid(b, &s, "lid", dmg_range(b, 1.2f, 2.4f));
        for (int i = 0; i < STEPS; ++i) {
            float angle = DMG_PI * (float)i / (STEPS - 1);
            line[i] = (dmg_xy){(reach - 0.5f * t) * copysignf(powf(fabsf(cosf(angle)), power), cosf(angle)),
                               rise * powf(sinf(angle), power)};
        }
        line[STEPS - 1].y = 0;
        dmg_save(b);
        dmg_move(b, 0, level, mid);
        if (!upper) dmg_mirror(b, v3(0, 1, 0));
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_bent_plate(b, line, STEPS, t, 2 * half);
        for (int i = -1; i <= 1; i += 2)
            dmg_extrude(b, line, STEPS, (float)i * (half - 0.5f * t) - 0.5f * t,
                        (float)i * (half - 0.5f * t) + 0.5f * t);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.5f)) dmg_rest(b, lid, b->parts[lid - 1].joint.upper * dmg_unit(b));
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, 0, "catch", v3(0, 0, -1), 0.0f, 0.8f * t);
        dmg_rounded_box(b, v3(0, s.low - 3 * t, deep), v3(6 * t, 3 * t, 2 * t), 0.7f * t);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) { /* the spectacles in it */
        for (int i = -1; i <= 1; i += 2)
            dmg_rod(b, v3((float)i * 0.45f * half, s.low - glass * high, mid),
                    v3((float)i * 0.45f * half, s.low - glass * high + t, mid), fminf(0.38f * half, 0.7f * reach));
        dmg_rod(b, v3(-0.7f * half, s.low - glass * high, mid - 0.3f * reach),
                v3(0.7f * half, s.low - glass * high, mid - 0.3f * reach), 0.6f * t);
        dmg_rod(b, v3(0, 0.5f * t, mid), v3(0, s.low - glass * high, mid), t);
    }
}

void dmg_build_clamshell(dmg_builder* b) {
    static const float weights[] = {3, 2.5f, 1.5f, 2, 2, 2, 1};
    if (dmg_chance(b, 0.25f)) dmg_mirror(b, v3(1, 0, 0));
    switch (dmg_weighted(b, weights, 7)) {
    case 0:
        draw_console(b);
        break;
    case 1:
        draw_folding_phone(b);
        break;
    case 2:
        draw_organiser(b);
        break;
    case 3:
        draw_sliding_phone(b);
        break;
    case 4:
        draw_compact(b);
        break;
    case 5:
        draw_jewel_box(b);
        break;
    default:
        draw_spectacle_case(b);
        break;
    }
}
