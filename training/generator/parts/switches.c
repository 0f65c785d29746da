/* Implements panel controls with the proportions of real ones: controls that turn are round and stand out, controls
 * that are pressed are low. Without a drag their type is inferred from these proportions alone. */
#include "parts/switches.h"

#include "parts/hardware.h"

/* ---- knobs ---- */

enum { KNOB_KNURLED = DMG_KNOB_KINDS, KNOB_SLEEVE, KNOB_ARROW, KNOB_MARKED, KNOB_LEVER, KNOB_KINDS };

/* Draws a rim of fine teeth. */
static void draw_knurled(dmg_builder* b, float radius, float height) {
    enum { MOST = 72 };
    dmg_xy outline[MOST];
    int points = 2 * dmg_int(b, 9, MOST / 2);
    float valley = radius * dmg_range(b, 0.84f, 0.96f);
    for (int i = 0; i < points; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)points, r = i & 1 ? valley : radius;
        outline[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
    }
    dmg_extrude(b, outline, points, 0, height);
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, 0, height), v3(0, 0, 1.12f * height), 0.75f * radius);
}

/* Draws a house-shaped pointer, its tip farther from the axis than its back. */
static void draw_arrow(dmg_builder* b, float radius, float height) {
    float half = radius * dmg_range(b, 0.35f, 0.7f), back = radius * dmg_range(b, 0.5f, 0.9f),
          neck = radius * dmg_range(b, 0.1f, 0.6f);
    const dmg_xy outline[] = {{-half, -back}, {half, -back}, {half, neck}, {0, radius}, {-half, neck}};
    dmg_extrude(b, outline, 5, 0, height);
}

static void draw_dial_body(dmg_builder* b, int kind, float radius, float height) {
    const dmg_vec z = {0, 0, 1};
    switch (kind) {
    case KNOB_KNURLED:
        draw_knurled(b, radius, height);
        break;
    case KNOB_SLEEVE: { /* open at the back, a hollow in front */
        const dmg_xy profile[] = {{radius, 0},
                                  {radius, 0.92f * height},
                                  {0.92f * radius, height},
                                  {0.6f * radius, height},
                                  {0.55f * radius, 0.8f * height},
                                  {0, 0.8f * height}};
        dmg_lathe(b, v3(0, 0, 0), z, profile, 6);
        break;
    }
    case KNOB_ARROW:
        draw_arrow(b, radius, height);
        break;
    case KNOB_MARKED: /* a line along the side and over the front */
        dmg_cone(b, v3(0, 0, 0), v3(0, 0, height), radius, 0.93f * radius);
        dmg_box(b, v3(0, 0.55f * radius, 0.55f * height), v3(0.1f * radius, 0.95f * radius, 1.0f * height));
        break;
    case KNOB_LEVER: /* a cap with an arm out to the side */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, height), 0.55f * radius);
        dmg_box(b, v3(0, 0.5f * radius, 0.75f * height), v3(0.3f * radius, radius, 0.45f * height));
        break;
    default:
        dmg_knob_draw(b, kind, radius, height);
        break;
    }
}

dmg_dial dmg_dial_pick(dmg_builder* b) {
    static const float weights[KNOB_KINDS] = {3, 1.5f, 1, 0.7f, 1, 1.2f, 0.8f, 2.5f, 1.5f, 0.8f, 1.2f, 0.6f};
    dmg_dial dial = {.kind = dmg_weighted(b, weights, KNOB_KINDS)};
    dial.height = dmg_chance(b, 0.75f) ? dmg_scale_range(b, 0.4f, 1.3f) : dmg_scale_range(b, 0.15f, 2.3f);
    dial.sink = dmg_chance(b, 0.4f) ? dmg_range(b, 0.0f, 0.6f) : 0.0f;
    dial.endless = dmg_chance(b, 0.5f);
    dial.upper = dmg_scale_range(b, 0.4f, 6.0f);
    dial.lower = dmg_chance(b, 0.3f) ? -dial.upper : 0.0f;
    dial.collar = dmg_chance(b, 0.25f);
    dial.pulled = dmg_chance(b, 0.05f);
    return dial;
}

/* Draws the knob's joint on `parent`: clockwise is on. */
static uint32_t add_dial(dmg_builder* b, const dmg_dial* dial, uint32_t parent, const char* name, float height) {
    if (dial->pulled) return dmg_slide(b, parent, name, v3(0, 0, dmg_sign(b)), 0.0f, 0.15f * height);
    if (dial->endless) return dmg_spin(b, parent, name, v3(0, 0, 0), v3(0, 0, -1));
    uint32_t part = dmg_hinge(b, parent, name, v3(0, 0, 0), v3(0, 0, -1), dial->lower, dial->upper);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, part, dial->lower + (dial->upper - dial->lower) * dmg_unit(b));
    return part;
}

void dmg_dial_draw(dmg_builder* b, const dmg_dial* dial, float radius) {
    float height = 2.0f * radius * dial->height, sink = dial->sink * height;
    if (dial->collar) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.08f * radius), 1.2f * radius);
    dmg_save(b);
    dmg_move(b, 0, 0, -sink);
    add_dial(b, dial, 0, "knob", height);
    draw_dial_body(b, dial->kind, radius, height);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_dial_stack_draw(dmg_builder* b, float radius) {
    static const float counts[] = {0, 0, 6, 1};
    int count = dmg_weighted(b, counts, 4);
    bool carried = dmg_chance(b, 0.25f), same = dmg_chance(b, 0.4f);
    dmg_dial dial = dmg_dial_pick(b);
    uint32_t part = 0;
    dmg_save(b);
    for (int i = 0; i < count; ++i) {
        if (i > 0 && !same) dial = dmg_dial_pick(b);
        dial.pulled = dial.pulled || dmg_chance(b, 0.03f);
        /* The lower ones are discs for two fingers, the top one a knob. */
        float height =
            2.0f * radius * (i + 1 < count ? dmg_scale_range(b, 0.12f, 0.8f) : dmg_scale_range(b, 0.2f, 1.5f));
        float root = i > 0 && dmg_chance(b, 0.4f) ? -0.6f * height : 0.0f; /* a shaft inside the lower knob */
        part = add_dial(b, &dial, carried ? part : 0, i > 0 ? "inner_knob" : "knob", height);
        if (root < 0.0f) dmg_rod(b, v3(0, 0, root), v3(0, 0, 0), 0.5f * radius);
        int kind = dial.kind == KNOB_ARROW && i + 1 < count ? KNOB_KNURLED : dial.kind;
        draw_dial_body(b, kind, radius, height);
        dmg_move(b, 0, 0, height);
        radius *= dmg_range(b, 0.4f, 0.85f);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- keys ---- */

enum { KEY_BOX, KEY_OPEN, KEY_BEVELLED, KEY_SOFT, KEY_ROUND, KEY_DOMED, KEY_HEAD, KEY_KINDS };

dmg_key dmg_key_pick(dmg_builder* b) {
    static const float weights[KEY_KINDS] = {3, 2.5f, 2, 1.5f, 1.6f, 0.7f, 0.4f};
    dmg_key key = {.kind = dmg_weighted(b, weights, KEY_KINDS)};
    bool round = key.kind >= KEY_ROUND;
    key.width = dmg_range(b, 0.8f, 1.9f);
    key.height = round || dmg_chance(b, 0.2f) ? key.width : key.width * dmg_scale_range(b, 0.3f, 1.1f);
    float low = 0.04f, high = round ? 0.3f : 0.45f;
    if (key.kind == KEY_HEAD) {
        low = 0.3f;
        high = 0.8f;
    }
    key.rise = key.width * dmg_scale_range(b, low, high);
    key.travel = key.rise * (dmg_chance(b, 0.4f) ? dmg_scale_range(b, 0.05f, 0.3f) : dmg_range(b, 0.3f, 0.8f));
    key.framed = dmg_chance(b, 0.25f);
    return key;
}

void dmg_key_draw(dmg_builder* b, const dmg_key* key, float radius) {
    float w = key->width * radius, h = key->height * radius, rise = key->rise * radius, r = 0.5f * w;
    float root = dmg_chance(b, 0.5f) ? 0.4f * rise : 0.0f;
    dmg_vec centre = {0, 0, 0.5f * (rise - root)}, size = {w, h, rise + root};
    if (key->framed && key->kind < KEY_ROUND) dmg_frame_draw(b, 1.25f * w, h + 0.25f * w, 0.2f * rise, 0.1f * w);
    if (key->framed && key->kind >= KEY_ROUND) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.15f * r, 0.1f * r);
    dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, key->travel * radius);
    if (key->kind == KEY_BOX) dmg_box(b, centre, size);
    if (key->kind == KEY_OPEN) dmg_box_faces(b, centre, size, DMG_FACE_ALL & ~DMG_FACE_BACK);
    if (key->kind == KEY_SOFT) dmg_rounded_box(b, centre, size, 0.3f * fminf(h, rise));
    if (key->kind == KEY_BEVELLED) {
        const dmg_xy base[] = {
            {-0.5f * w, -0.5f * h}, {0.5f * w, -0.5f * h}, {0.5f * w, 0.5f * h}, {-0.5f * w, 0.5f * h}};
        const dmg_row rows[] = {{1, 1, 0, -root}, {1, 1, 0, 0.6f * rise}, {0.85f, 0.75f, 0, rise}};
        dmg_loft(b, base, 4, rows, 3);
    }
    if (key->kind == KEY_ROUND) dmg_rod(b, v3(0, 0, -root), v3(0, 0, rise), r);
    if (key->kind == KEY_DOMED) {
        const dmg_xy profile[] = {{r, -root}, {r, 0.5f * rise}, {0.7f * r, 0.85f * rise}, {0, rise}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 4);
    }
    if (key->kind == KEY_HEAD) { /* a wide head on a stem, to be struck */
        dmg_rod(b, v3(0, 0, -root), v3(0, 0, 0.6f * rise), 0.55f * r);
        dmg_rod(b, v3(0, 0, 0.6f * rise), v3(0, 0, rise), r);
    }
    dmg_use(b, 0);
}

/* ---- switches ---- */

dmg_toggle dmg_toggle_pick(dmg_builder* b) {
    dmg_toggle toggle = {.kind = dmg_int(b, 0, 4)};
    toggle.length = dmg_range(b, 1.0f, 2.6f);
    toggle.thin = dmg_range(b, 0.12f, 0.32f);
    toggle.pivot = dmg_chance(b, 0.4f) ? 0.0f : -dmg_range(b, 0.0f, 0.5f);
    toggle.start = dmg_chance(b, 0.7f) ? toggle.pivot : fmaxf(toggle.pivot, -0.05f);
    if (toggle.start > toggle.pivot && dmg_chance(b, 0.5f)) toggle.pivot *= 3.0f;
    toggle.swing = dmg_range(b, 0.2f, 0.65f);
    toggle.rest = dmg_chance(b, 0.4f) ? 0.0f : dmg_sign(b);
    toggle.nut = dmg_chance(b, 0.6f);
    return toggle;
}

void dmg_toggle_draw(dmg_builder* b, const dmg_toggle* toggle, float radius) {
    float length = toggle->length * radius, thin = toggle->thin * radius, pivot = toggle->pivot * radius,
          start = toggle->start * radius, middle = 0.5f * (start + length), whole = length - start;
    if (toggle->nut) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.2f * radius), 0.5f * radius);
    uint32_t part = dmg_hinge(b, 0, "toggle", v3(0, 0, pivot), v3(-1, 0, 0), -toggle->swing, toggle->swing);
    if (toggle->kind == 0) dmg_cone(b, v3(0, 0, start), v3(0, 0, length), 0.7f * thin, 1.2f * thin);
    if (toggle->kind == 1) dmg_box(b, v3(0, 0, middle), v3(2.5f * thin, thin, whole));
    if (toggle->kind == 2) dmg_rounded_box(b, v3(0, 0, middle), v3(2 * thin, 2 * thin, whole), 0.6f * thin);
    if (toggle->kind == 3) dmg_rod(b, v3(0, 0, start), v3(0, 0, length), thin);
    if (toggle->kind == 4) { /* a thin stalk with a paddle */
        dmg_rod(b, v3(0, 0, start), v3(0, 0, length), 0.5f * thin);
        dmg_box(b, v3(0, 0, 0.8f * length), v3(3 * thin, 0.8f * thin, 0.5f * length));
    }
    dmg_rest(b, part, (dmg_chance(b, 0.75f) ? toggle->rest : -toggle->rest) * toggle->swing);
    dmg_use(b, 0);
}

dmg_rocker dmg_rocker_pick(dmg_builder* b) {
    dmg_rocker rocker = {.kind = dmg_int(b, 0, 3)};
    rocker.length = dmg_range(b, 1.2f, 1.9f);
    rocker.width = rocker.length * dmg_range(b, 0.25f, 0.9f);
    rocker.rise = rocker.length * dmg_range(b, 0.06f, 0.25f);
    rocker.depth = rocker.length * dmg_range(b, 0.05f, 0.4f);
    rocker.tilt = dmg_range(b, 0.08f, 0.3f);
    rocker.framed = dmg_chance(b, 0.5f);
    return rocker;
}

/* Outlines across the pivot: x runs along the rocker, y out of the panel; the pivot is the origin. */
void dmg_rocker_draw(dmg_builder* b, const dmg_rocker* rocker, float radius) {
    float half = 0.5f * rocker->length * radius, width = rocker->width * radius, rise = rocker->rise * radius,
          depth = rocker->depth * radius;
    if (rocker->framed) dmg_frame_draw(b, 1.2f * width, 2.2f * half, 0.3f * rise, 0.08f * width);
    uint32_t part = dmg_hinge(b, 0, "rocker", v3(0, 0, 0), v3(-1, 0, 0), -rocker->tilt, rocker->tilt);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI); /* the outline's x becomes y, */
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* its y becomes z */
    const dmg_xy vee[] = {{-half, rise}, {-half, -depth}, {half, -depth}, {half, rise}, {0, 0.4f * rise}};
    const dmg_xy hollow[] = {{-half, 1.3f * rise},        {-0.8f * half, -depth},     {0.8f * half, -depth},
                             {half, 1.3f * rise},         {0.6f * half, 0.6f * rise}, {0.2f * half, 0.3f * rise},
                             {-0.2f * half, 0.3f * rise}, {-0.6f * half, 0.6f * rise}};
    const dmg_xy plate[] = {{-half, rise}, {-half, -0.2f * rise}, {half, -0.2f * rise}, {half, rise}};
    const dmg_xy wedge[] = {{-0.7f * half, -0.3f * depth}, {0.7f * half, -0.3f * depth}, {0, 1.2f * half}};
    if (rocker->kind == 0) dmg_extrude(b, vee, 5, -0.5f * width, 0.5f * width);
    if (rocker->kind == 1) dmg_extrude(b, hollow, 8, -0.5f * width, 0.5f * width);
    if (rocker->kind == 2) dmg_extrude(b, plate, 4, -0.5f * width, 0.5f * width);
    if (rocker->kind == 3) dmg_extrude(b, wedge, 3, -0.5f * width, 0.5f * width);
    dmg_restore(b);
    if (rocker->kind != 3 || dmg_chance(b, 0.5f)) dmg_rest(b, part, dmg_sign(b) * rocker->tilt);
    dmg_use(b, 0);
}

void dmg_guard_draw(dmg_builder* b, float radius) {
    float length = 2 * radius, rise = radius * dmg_range(b, 0.5f, 1.2f), width = radius * dmg_range(b, 0.6f, 1.3f),
          lift = rise * dmg_range(b, 0.0f, 0.3f);
    bool sides = dmg_chance(b, 0.7f);
    dmg_hinge(b, 0, "guard", v3(0, 0.5f * length, lift), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.4f, 2.2f));
    if (sides)
        dmg_box_faces(b, v3(0, 0, 0.5f * rise), v3(width, length, rise),
                      DMG_FACE_ALL & ~(DMG_FACE_BACK | DMG_FACE_BOTTOM));
    else
        dmg_box(b, v3(0, 0, rise), v3(width, length, 0.12f * rise));
    if (!sides) dmg_box(b, v3(0, 0.47f * length, 0.5f * rise), v3(width, 0.06f * length, rise));
    dmg_use(b, 0);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * rise), 0.15f * radius);
    if (dmg_chance(b, 0.5f)) /* what it hangs on */
        dmg_rod(b, v3(-0.6f * width, 0.5f * length, lift), v3(0.6f * width, 0.5f * length, lift), 0.08f * radius);
}

void dmg_breaker_draw(dmg_builder* b, float radius) {
    float thin = radius * dmg_range(b, 0.35f, 0.6f), rise = thin * dmg_range(b, 0.5f, 1.4f);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.3f * rise), 1.35f * thin);
    bool out = dmg_chance(b, 0.7f);
    dmg_slide(b, 0, "breaker", v3(0, 0, out ? 1 : -1), 0.0f, rise * dmg_range(b, 0.2f, 0.5f));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, rise), thin);
    dmg_use(b, 0);
}

/* Differs from a knob that turns by the rod between it and the panel. */
void dmg_plunger_draw(dmg_builder* b, float radius) {
    float thin = radius * dmg_range(b, 0.12f, 0.3f), knob = radius * dmg_range(b, 0.45f, 0.9f),
          out = knob * dmg_scale_range(b, 0.5f, 4.0f), height = knob * dmg_range(b, 0.3f, 1.4f),
          root = out * dmg_range(b, 0.0f, 1.0f), travel = out * dmg_range(b, 0.4f, 0.95f);
    bool pushed = dmg_chance(b, 0.5f);
    if (dmg_chance(b, 0.7f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.2f * knob), 1.8f * thin);
    dmg_slide(b, 0, "plunger", v3(0, 0, pushed ? -1 : 1), 0.0f, travel);
    dmg_rod(b, v3(0, 0, -root), v3(0, 0, out), thin);
    dmg_move(b, 0, 0, out);
    int kind = dmg_int(b, 0, 4);
    if (kind == 0) dmg_ellipsoid(b, v3(0, 0, 0.8f * knob), v3(knob, knob, knob));
    if (kind == 1) dmg_rod(b, v3(0, 0, 0), v3(0, 0, height), knob);
    if (kind == 2) draw_knurled(b, knob, height);
    if (kind == 3) dmg_knob_draw(b, 3, knob, height);
    if (kind == 4) dmg_rounded_box(b, v3(0, 0, 0.3f * knob), v3(2.5f * knob, 0.7f * knob, 0.6f * knob), 0.2f * knob);
    dmg_move(b, 0, 0, -out);
    dmg_use(b, 0);
}

void dmg_key_switch_draw(dmg_builder* b, float radius) {
    float core = radius * dmg_range(b, 0.35f, 0.7f), rise = core * dmg_range(b, 0.1f, 0.7f),
          bow = core * dmg_range(b, 0.7f, 1.5f), thin = 0.15f * core;
    float upper = dmg_range(b, 0.6f, 3.5f);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, rise), 1.3f * core);
    uint32_t part = dmg_hinge(b, 0, "key", v3(0, 0, 0), v3(0, 0, -1), 0.0f, upper);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 1.1f * rise), core);
    if (dmg_chance(b, 0.8f)) { /* the key's blade and bow */
        dmg_box(b, v3(0, 0, rise + 0.5f * bow), v3(thin, 0.8f * core, bow));
        dmg_rod(b, v3(-0.5f * thin, 0, rise + 1.3f * bow), v3(0.5f * thin, 0, rise + 1.3f * bow), 0.55f * bow);
    } else {
        dmg_box(b, v3(0, 0, 1.1f * rise), v3(thin, 1.4f * core, 0.1f * rise));
    }
    if (dmg_chance(b, 0.4f)) dmg_rest(b, part, upper * dmg_unit(b));
    dmg_use(b, 0);
}

void dmg_thumb_wheel_draw(dmg_builder* b, float radius) {
    bool flat = dmg_chance(b, 0.5f);
    float sink = radius * dmg_range(b, 0.1f, 0.5f);
    dmg_vec axis = flat ? v3(1, 0, 0) : v3(0, 1, 0), half = v3_scale(axis, 0.2f * radius), middle = {0, 0, -sink};
    dmg_spin(b, 0, "thumb_wheel", middle, axis);
    dmg_rod(b, v3_sub(middle, half), v3_add(middle, half), radius);
    dmg_use(b, 0);
}

void dmg_fader_draw(dmg_builder* b, float radius) {
    float travel = radius * dmg_range(b, 1.0f, 1.6f);
    dmg_box(b, v3(0, 0, 0), v3(0.15f * radius, 2 * radius, 0.02f * radius));
    uint32_t fader = dmg_slide(b, 0, "fader", v3(0, 1, 0), -0.5f * travel, 0.5f * travel);
    dmg_box(b, v3(0, 0, 0.3f * radius), v3(0.8f * radius, 0.3f * radius, 0.6f * radius));
    dmg_rest(b, fader, travel * dmg_range(b, -0.5f, 0.5f));
    dmg_use(b, 0);
}

void dmg_ornament_draw(dmg_builder* b, float radius) {
    int kind = dmg_int(b, 0, 5);
    if (kind == 0) dmg_box(b, v3(0, 0, 0), v3(1.9f * radius, 1.3f * radius, 0.1f * radius));
    if (kind == 1) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.15f * radius), 0.3f * radius);
    if (kind == 2) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.3f * radius), 0.25f * radius);
    if (kind == 3) dmg_frame_draw(b, 1.9f * radius, 1.9f * radius, 0.1f * radius, 0.1f * radius);
    for (int i = 0; i < 3 && kind == 4; ++i) /* a legend: letters as plates of one face */
        dmg_box_faces(b, v3(0.4f * radius * (float)(i - 1), 0, 0.01f * radius), v3(0.3f * radius, 0.5f * radius, 0),
                      DMG_FACE_FRONT);
    if (kind == 5) dmg_box(b, v3(0, 0, 0.1f * radius), v3(0.25f * radius, 0.25f * radius, 0.2f * radius));
}

/* ---- rows ---- */

/* Properties that the controls of a row share. */
typedef struct row_style {
    dmg_dial dial;
    dmg_key key;
    dmg_toggle toggle;
    dmg_rocker rocker;
} row_style;

static void draw_one(dmg_builder* b, dmg_control_kind kind, const row_style* style, float radius) {
    switch (kind) {
    case DMG_CONTROL_DIAL:
        dmg_dial_draw(b, &style->dial, radius);
        break;
    case DMG_CONTROL_STACK:
        dmg_dial_stack_draw(b, radius);
        break;
    case DMG_CONTROL_KEY:
        dmg_key_draw(b, &style->key, radius);
        break;
    case DMG_CONTROL_TOGGLE:
        dmg_toggle_draw(b, &style->toggle, radius);
        break;
    case DMG_CONTROL_ROCKER:
        dmg_rocker_draw(b, &style->rocker, radius);
        break;
    case DMG_CONTROL_GUARD:
        dmg_guard_draw(b, radius);
        break;
    case DMG_CONTROL_BREAKER:
        dmg_breaker_draw(b, radius);
        break;
    case DMG_CONTROL_PLUNGER:
        dmg_plunger_draw(b, radius);
        break;
    case DMG_CONTROL_LOCK:
        dmg_key_switch_draw(b, radius);
        break;
    case DMG_CONTROL_THUMB_WHEEL:
        dmg_thumb_wheel_draw(b, radius);
        break;
    case DMG_CONTROL_FADER:
        dmg_fader_draw(b, radius);
        break;
    case DMG_CONTROL_ORNAMENT:
    case DMG_CONTROL_KINDS:
        dmg_ornament_draw(b, radius);
        break;
    }
}

void dmg_control_row_draw(dmg_builder* b, dmg_control_kind kind, int count, float pitch, float radius) {
    row_style style;
    style.dial = dmg_dial_pick(b);
    style.key = dmg_key_pick(b);
    style.toggle = dmg_toggle_pick(b);
    style.rocker = dmg_rocker_pick(b);
    bool legends = dmg_chance(b, 0.3f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        if (count < 3 || !dmg_chance(b, 0.12f)) draw_one(b, kind, &style, radius);
        if (legends)
            dmg_box_faces(b, v3(0, 1.3f * radius, 0.01f * radius), v3(1.2f * radius, 0.3f * radius, 0), DMG_FACE_FRONT);
        dmg_restore(b);
    }
}
