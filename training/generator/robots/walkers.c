/* Draws legs of plates and motor drums, and hands of finger chains. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- legs ---- */

/* Draws a plate in the plane of Y and Z from joint to joint, round at both ends, its inner face at x = 0. */
static void draw_plate(dmg_builder* b, dmg_vec from, dmg_vec to, float wide, float narrow, float thick) {
    enum { HALF = 5 };
    dmg_xy outline[2 * HALF];
    float heading = atan2f(to.y - from.y, to.z - from.z);
    for (int i = 0; i < 2 * HALF; ++i) {
        dmg_vec at = i < HALF ? to : from;
        float step = DMG_PI * (float)(i % HALF) / (HALF - 1), r = 0.5f * (i < HALF ? narrow : wide),
              angle = heading - 0.5f * DMG_PI + step + (i < HALF ? 0.0f : DMG_PI);
        outline[i] = (dmg_xy){-(at.z + r * cosf(angle)), at.y + r * sinf(angle)};
    }
    /* x, y, z of the outline's plane are -Z, Y, X of ours; the outline then goes clockwise, so take it backwards. */
    for (int i = 0; i < HALF; ++i) {
        dmg_xy swap = outline[i];
        outline[i] = outline[2 * HALF - 1 - i];
        outline[2 * HALF - 1 - i] = swap;
    }
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_extrude(b, outline, 2 * HALF, from.x, from.x + thick);
    dmg_restore(b);
}

typedef struct plate_leg {
    float thigh, shin, bend;
    float drum, plate; /* radius of the motors, thickness of the plates */
    int foot;          /* ball, pad, wheel, none */
    bool rolls;        /* the hip turns about the body's long axis first */
    bool twin;         /* plates on both sides of the knee */
    bool blade;        /* the shin is a tapered bar, not a plate */
} plate_leg;

/* Beyond its hip drum everything lies farther out: thigh plate, then the shin beside it. The origin is on the body's
 * side, out is +X. */
static void draw_plate_leg(dmg_builder* b, const plate_leg* l, float turned) {
    float r = l->drum, t = l->plate;
    uint32_t carrier = 0;
    if (l->rolls) {
        dmg_rod(b, v3(0.9f * r, 0, -turned * 2.2f * r), v3(0.9f * r, 0, -turned * 0.8f * r), 0.8f * r);
        carrier = dmg_hinge(b, 0, "hip", v3(0.9f * r, 0, 0), v3(0, 0, dmg_sign(b)), -0.6f, 0.6f);
        dmg_rod(b, v3(0.9f * r, 0, -turned * 0.8f * r), v3(0.9f * r, 0, 0), 0.85f * r);
        dmg_move(b, 0.9f * r, 0, turned * r);
    }
    dmg_rod(b, v3(0, 0, 0), v3(1.2f * r, 0, 0), r);
    float x = 1.25f * r;
    dmg_vec hip = {x, 0, 0}, knee = {x, -l->thigh * cosf(l->bend), -l->thigh * sinf(l->bend)};
    uint32_t thigh = dmg_hinge(b, carrier, "thigh", hip, v3(dmg_sign(b), 0, 0), -1.3f, 1.3f);
    draw_plate(b, hip, knee, 1.9f * r, 1.3f * r, t);
    dmg_rod(b, v3(x, 0, 0), v3(x + 1.4f * t, 0, 0), 0.5f * r);
    float inner = x + t, gap = l->twin ? 1.6f * t : 0.0f;
    if (l->twin) draw_plate(b, v3(x + t + gap, 0, 0), v3(x + t + gap, knee.y, knee.z), 1.5f * r, 1.2f * r, t);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(inner, knee.y, knee.z), v3(inner + fmaxf(gap, t), knee.y, knee.z), 0.45f * r);
    float to = 0.8f * l->bend;
    dmg_vec from = {inner + 0.2f * t, knee.y, knee.z},
            foot = {from.x, knee.y - l->shin * cosf(to), knee.z + l->shin * sinf(to)};
    uint32_t shin = dmg_hinge(b, thigh, "shin", knee, v3(dmg_sign(b), 0, 0), -1.0f, 1.0f);
    if (l->blade) {
        dmg_vec mid = {0.5f * t, 0, 0};
        dmg_rod(b, from, v3(from.x + 1.1f * t, knee.y, knee.z), 0.6f * r);
        dmg_cone(b, v3_add(from, mid), v3_add(foot, mid), 0.4f * r, 0.25f * r);
    } else
        draw_plate(b, from, foot, 1.2f * r, 0.5f * r, 1.1f * t);
    dmg_move(b, foot.x + 0.5f * t, foot.y, foot.z);
    if (l->foot == 0) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.4f * r, 0.4f * r, 0.4f * r));
    if (l->foot == 1) {
        if (dmg_chance(b, 0.5f)) dmg_hinge(b, shin, "foot", v3(0, 0, 0), v3(1, 0, 0), -0.6f, 0.6f);
        dmg_box(b, v3(0, -0.3f * r, 0.3f * r), v3(1.4f * r, 0.3f * r, 2.4f * r));
    }
    if (l->foot == 2) {
        float radius = r * dmg_range(b, 0.8f, 1.6f);
        dmg_spin(b, shin, "wheel", v3(0, 0, 0), v3(1, 0, 0));
        dmg_move(b, t + 0.3f * r, 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, dmg_int(b, 0, 2), radius, 0.5f * r, 5);
    }
    dmg_use(b, 0);
}

/* Dogs and two-legged machines whose hips are drums and whose thighs are plates beside them. */
void dmg_build_plate_legs(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.15f, 1.4f), wide = length * dmg_range(b, 0.2f, 0.55f),
          high = length * dmg_range(b, 0.12f, 0.4f), bend = dmg_range(b, 0.1f, 0.9f);
    plate_leg leg = {
        .thigh = length * dmg_range(b, 0.3f, 0.6f), .bend = bend, .drum = length * dmg_range(b, 0.05f, 0.1f)};
    leg.shin = leg.thigh * dmg_range(b, 0.8f, 1.2f);
    leg.plate = leg.drum * dmg_range(b, 0.2f, 0.7f);
    leg.foot = dmg_int(b, 0, 3);
    leg.rolls = dmg_chance(b, 0.6f);
    leg.twin = dmg_chance(b, 0.4f);
    leg.blade = dmg_chance(b, 0.4f);
    int pairs = dmg_chance(b, 0.7f) ? 2 : 1, shape = dmg_int(b, 0, 2), row = pairs - 1;
    dmg_move(b, 0, leg.thigh + leg.shin + leg.drum, 0);
    if (shape == 0) dmg_box(b, v3(0, 0.2f * high, 0), v3(wide, high, length));
    if (shape == 1) dmg_rounded_box(b, v3(0, 0.2f * high, 0), v3(wide, high, length), 0.25f * high);
    if (shape == 2) { /* two decks on a spine */
        dmg_box(b, v3(0, 0.4f * high, 0), v3(wide, 0.1f * high, length));
        dmg_box(b, v3(0, 0, 0), v3(wide, 0.3f * high, 0.95f * length));
        dmg_box(b, v3(0, 0.25f * high, 0), v3(0.4f * wide, 0.3f * high, 0.6f * length));
    }
    for (int i = 0; i < 2 * pairs; ++i) {
        float end = row ? (i / 2 ? 1.0f : -1.0f) : 0.0f;
        dmg_save(b);
        if (i % 2) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.5f * wide, 0, end * 0.4f * length);
        draw_plate_leg(b, &leg, row ? end : 1.0f);
        dmg_restore(b);
    }
    if (!dmg_chance(b, 0.4f)) return;
    float drum = 0.3f * wide; /* a scanner that spins on the back */
    dmg_move(b, 0, 0.7f * high, dmg_range(b, -0.2f, 0.4f) * length);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.5f * drum, 0), 0.7f * drum);
    dmg_spin(b, 0, "scanner", v3(0, 0.5f * drum, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0.5f * drum, 0), v3(0, 1.5f * drum, 0), drum);
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, drum, 0.9f * drum), v3(0.6f * drum, 0.5f * drum, 0.4f * drum));
    dmg_use(b, 0);
}

/* ---- insects ---- */

/* Draws a leg out along +X: hip about the upright, then two links about Z. */
static void draw_insect_leg(dmg_builder* b, int style, float reach, float thick, float rise) {
    float first = 0.2f * reach, second = 0.4f * reach, third = 0.65f * reach;
    if (style == 2) dmg_box(b, v3(0, 0, 0), v3(1.6f * thick, 1.4f * thick, 2 * thick)); /* the servo in the body */
    uint32_t coxa = dmg_hinge(b, 0, "coxa", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -0.7f, 0.7f);
    if (style != 2) dmg_rod(b, v3(0, -0.9f * thick, 0), v3(0, 0.9f * thick, 0), 0.8f * thick);
    if (style == 2) dmg_rod(b, v3(0, -1.0f * thick, 0), v3(0, 1.0f * thick, 0), 0.4f * thick);
    dmg_beam(b, v3(0, 0, 0), v3(first, 0, 0), 1.2f * thick, 1.2f * thick);
    dmg_vec knee = {first + second * cosf(rise), second * sinf(rise), 0},
            tip = {knee.x + third * cosf(rise - 1.5f), knee.y + third * sinf(rise - 1.5f), 0};
    uint32_t femur = dmg_hinge(b, coxa, "femur", v3(first, 0, 0), v3(0, 0, dmg_sign(b)), -0.7f, 0.6f);
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * 0.9f * thick;
        if (style == 0) dmg_beam(b, v3(first, 0, z), v3(knee.x, knee.y, z), 0.4f * thick, 1.6f * thick);
    }
    if (style != 0) dmg_cone(b, v3(first, 0, 0), knee, 0.9f * thick, 0.7f * thick);
    if (style == 2) dmg_rod(b, v3(first, 0, -1.2f * thick), v3(first, 0, 1.2f * thick), 0.6f * thick);
    dmg_hinge(b, femur, "tibia", knee, v3(0, 0, dmg_sign(b)), -0.8f, 0.6f);
    if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3_add(knee, v3(0, 0, -0.7f * thick)), v3_add(knee, v3(0, 0, 0.7f * thick)), 0.8f * thick);
    if (style == 0) dmg_beam(b, knee, tip, 1.1f * thick, 0.9f * thick);
    if (style != 0) dmg_cone(b, knee, tip, 0.7f * thick, 0.1f * thick);
    dmg_use(b, 0);
}

/* Six or eight legs round a flat body. */
void dmg_build_insect_robot(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.1f, 1.5f), wide = length * dmg_range(b, 0.4f, 1.0f),
          reach = length * dmg_range(b, 0.6f, 1.3f), thick = length * dmg_range(b, 0.025f, 0.06f),
          rise = dmg_range(b, 0.2f, 0.9f), high = length * dmg_range(b, 0.08f, 0.25f);
    int style = dmg_int(b, 0, 2), body = dmg_int(b, 0, 2), side = dmg_int(b, 2, 4);
    float stand = 0.65f * reach * sinf(1.5f - rise) - 0.4f * reach * sinf(rise);
    dmg_move(b, 0, fmaxf(stand, 0.6f * high), 0);
    if (body == 0) dmg_box(b, v3(0, 0, 0), v3(wide, high, length));
    if (body == 1) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.55f * wide, 0.6f * high, 0.55f * length));
    for (int s = -1; s <= 1 && body == 2; s += 2)
        dmg_box(b, v3(0, (float)s * 0.8f * thick, 0), v3(wide, 0.3f * thick, length));
    if (body == 2) dmg_box(b, v3(0, 0, 0), v3(0.5f * wide, 2 * thick, 0.6f * length));
    for (int i = 0; i < 2 * side; ++i) {
        float place = 2.0f * (float)(i / 2) / (float)(side - 1) - 1.0f,
              out = body == 1 ? 0.5f * wide * sqrtf(1.0f - 0.6f * place * place) : 0.5f * wide;
        dmg_save(b);
        if (i % 2) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, out + thick, 0, 0.42f * length * place);
        dmg_turn(b, v3(0, 1, 0), -0.6f * place);
        draw_insect_leg(b, style, reach, thick, rise);
        dmg_restore(b);
    }
}

/* ---- hands: the palm's plane is X, Y, fingers reach up and bend towards +Z ---- */

typedef struct finger_style {
    int bone; /* rounded box, rod, plates, capsule */
    float thick;
    bool knuckles, spreads;
    float bent; /* how far each joint is bent as drawn */
} finger_style;

static void draw_bone(dmg_builder* b, const finger_style* f, float length, float thick) {
    if (f->bone == 0) dmg_rounded_box(b, v3(0, 0.5f * length, 0), v3(thick, 0.96f * length, thick), 0.25f * thick);
    if (f->bone == 1) dmg_rod(b, v3(0, 0, 0), v3(0, length, 0), 0.45f * thick);
    if (f->bone == 3) dmg_ellipsoid(b, v3(0, 0.5f * length, 0), v3(0.5f * thick, 0.55f * length, 0.5f * thick));
    for (int s = -1; s <= 1 && f->bone == 2; s += 2)
        dmg_box(b, v3((float)s * 0.38f * thick, 0.5f * length, 0), v3(0.2f * thick, 1.1f * length, 0.8f * thick));
}

/* Bones one after another from the origin upwards. */
static void draw_digit(dmg_builder* b, const finger_style* f, uint32_t palm, int bones, float length,
                       const char* name) {
    uint32_t carrier = palm;
    float thick = f->thick, way = dmg_sign(b);
    if (f->spreads) {
        carrier = dmg_hinge(b, palm, "spread", v3(0, 0, 0), v3(0, 0, 1), -0.35f, 0.35f);
        dmg_ellipsoid(b, v3(0, 0, 0), v3(0.6f * thick, 0.6f * thick, 0.6f * thick));
        dmg_move(b, 0, 0.3f * thick, 0);
    }
    for (int i = 0; i < bones; ++i) {
        float each = length * (i == 0 ? 1.3f : 1.0f) / ((float)bones + 0.3f), most = (i ? 1.5f : 1.1f) - f->bent;
        dmg_turn(b, v3(1, 0, 0), f->bent);
        carrier = way > 0 ? dmg_hinge(b, carrier, name, v3(0, 0, 0), v3(1, 0, 0), -f->bent, most)
                          : dmg_hinge(b, carrier, name, v3(0, 0, 0), v3(-1, 0, 0), -most, f->bent);
        if (f->knuckles) dmg_rod(b, v3(-0.6f * thick, 0, 0), v3(0.6f * thick, 0, 0), 0.5f * thick);
        draw_bone(b, f, each, thick);
        thick *= 0.92f;
        dmg_move(b, 0, each, 0);
    }
    dmg_use(b, palm);
}

/* Hands with a thumb, as mannequins, prostheses and dexterous robots have them. */
void dmg_build_robot_hand(dmg_builder* b) {
    float palm = dmg_scale_range(b, 0.05f, 0.4f), wide = palm * dmg_range(b, 0.6f, 1.1f),
          deep = palm * dmg_range(b, 0.2f, 0.45f), length = palm * dmg_range(b, 0.6f, 1.3f),
          cuff = palm * dmg_range(b, 0.3f, 1.2f);
    int fingers = dmg_int(b, 2, 4), bones = dmg_int(b, 2, 3), shape = dmg_int(b, 0, 2);
    finger_style f = {.bone = dmg_int(b, 0, 3), .knuckles = dmg_chance(b, 0.5f), .spreads = dmg_chance(b, 0.3f)};
    f.bent = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.05f, 0.6f);
    f.thick = fminf(0.8f * wide / (float)fingers, deep) * dmg_range(b, 0.6f, 0.95f);
    uint32_t wrist = 0;
    dmg_rod(b, v3(0, 0, 0), v3(0, cuff, 0), 0.35f * wide);
    dmg_move(b, 0, cuff, 0);
    bool turns = dmg_chance(b, 0.5f);
    if (turns) {
        bool nods = dmg_chance(b, 0.6f);
        wrist = dmg_hinge(b, 0, "wrist", v3(0, 0.2f * palm, 0), nods ? v3(1, 0, 0) : v3(0, 1, 0), -0.6f, 0.6f);
        dmg_ellipsoid(b, v3(0, 0.2f * palm, 0), v3(0.3f * wide, 0.28f * palm, 0.5f * deep));
    }
    dmg_move(b, 0, (turns ? 0.38f : 0.0f) * palm, 0);
    if (shape == 0) dmg_box(b, v3(0, 0.45f * palm, 0), v3(wide, 0.9f * palm, deep));
    if (shape == 1) dmg_rounded_box(b, v3(0, 0.45f * palm, 0), v3(wide, 0.9f * palm, deep), 0.3f * deep);
    if (shape == 2)
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(0, 0.45f * palm, (float)s * 0.4f * deep), v3(wide, 0.9f * palm, 0.2f * deep));
    if (shape == 2) dmg_box(b, v3(0, 0.45f * palm, 0), v3(0.7f * wide, 0.7f * palm, 0.7f * deep));
    for (int i = 0; i < fingers; ++i) {
        float place = (float)i / (float)(fingers - 1) - 0.5f;
        dmg_save(b);
        dmg_move(b, place * (wide - f.thick), 0.97f * palm - 0.2f * palm * place * place, 0);
        draw_digit(b, &f, wrist, bones, length * (1.0f - 0.4f * fabsf(place)), "finger");
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.9f)) { /* the thumb leaves the side, and turns across the palm */
        float side = dmg_sign(b);
        if (side < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.55f * wide, dmg_range(b, 0.2f, 0.5f) * palm, 0.2f * deep);
        dmg_turn(b, v3(0, 0, 1), -dmg_range(b, 0.3f, 1.1f));
        dmg_turn(b, v3(0, 1, 0), -dmg_range(b, 0.3f, 1.4f));
        draw_digit(b, &f, wrist, 2, 0.8f * length, "thumb");
    }
    dmg_use(b, 0);
}
