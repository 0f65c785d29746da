/* Draws lifting and travelling axes: scissors, columns, telescopes, forks, stacked axes, legs that reach. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- lifts ---- */

typedef struct lift {
    float half, deep, t; /* half the width of the base, its depth, thickness of what it is built of */
    float travel;
} lift;

/* Draws what stands on the ground: a plate, a cabinet, a frame, a cart on wheels. Returns its height. */
static float draw_lift_base(dmg_builder* b, const lift* l) {
    int kind = dmg_int(b, 0, 3);
    float high = l->t * dmg_range(b, 1.0f, 3.0f), wheel = kind == 3 ? l->half * dmg_range(b, 0.1f, 0.3f) : 0.0f;
    if (kind == 0) dmg_box(b, v3(0, 0.5f * high, 0), v3(2 * l->half, high, l->deep));
    if (kind == 1) {
        high = l->half * dmg_range(b, 0.3f, 1.2f);
        dmg_rounded_box(b, v3(0, 0.5f * high, 0), v3(2 * l->half, high, l->deep), 0.1f * high);
    }
    if (kind == 2)
        for (int s = -1; s <= 1; s += 2) {
            dmg_box(b, v3(0, 0.5f * high, (float)s * 0.45f * l->deep), v3(2 * l->half, high, l->t));
            dmg_box(b, v3((float)s * 0.95f * l->half, 0.5f * high, 0), v3(l->t, 0.8f * high, l->deep));
        }
    if (kind == 3) {
        dmg_box(b, v3(0, wheel + 0.5f * high, 0), v3(2 * l->half, high, l->deep));
        bool turn = dmg_chance(b, 0.6f);
        for (int i = 0; i < 4; ++i) {
            float x = (i % 2 ? 0.7f : -0.7f) * l->half, z = (i / 2 ? 0.55f : -0.55f) * l->deep;
            if (turn) dmg_spin(b, 0, "wheel", v3(x, wheel, z), v3(0, 0, 1));
            dmg_rod(b, v3(x, wheel, z - 0.04f * l->deep), v3(x, wheel, z + 0.04f * l->deep), wheel);
            dmg_use(b, 0);
        }
    }
    return high + wheel;
}

/* Draws a platform with its underside at y = 0; a rail round it, a gate in the rail, a box or nothing on it. */
static void draw_platform(dmg_builder* b, uint32_t platform, const lift* l) {
    float x = l->half * dmg_range(b, 0.8f, 1.05f), z = 0.5f * l->deep * dmg_range(b, 0.8f, 1.05f), t = l->t,
          rail = l->half * dmg_range(b, 0.4f, 1.0f), rod = 0.3f * t;
    int top = dmg_int(b, 0, 3);
    dmg_box(b, v3(0, 0.5f * t, 0), v3(2 * x, t, 2 * z));
    if (top == 1) dmg_rounded_box(b, v3(0, t + 0.3f * rail, 0), v3(x, 0.6f * rail, z), 0.1f * rail);
    if (top < 2) return;
    for (int i = 0; i < 4; ++i) {
        float px = (i % 2 ? 0.95f : -0.95f) * x, pz = (i / 2 ? 0.95f : -0.95f) * z;
        dmg_box(b, v3(px, t + 0.5f * rail, pz), v3(2 * rod, rail, 2 * rod));
    }
    for (int s = -1; s <= 1; s += 2)
        for (int k = 1; k <= 2; ++k)
            dmg_box(b, v3(0, t + 0.48f * rail * (float)k, (float)s * 0.95f * z), v3(1.9f * x, 1.5f * rod, 1.5f * rod));
    if (top == 3) { /* a gate at one end */
        float open = dmg_range(b, 1.0f, 1.7f);
        dmg_hinge(b, platform, "gate", v3(0.95f * x, 0, -0.95f * z), v3(0, 1, 0), -dmg_range(b, 0.0f, 1.0f), open);
        for (int k = 1; k <= 2; ++k)
            dmg_box(b, v3(0.95f * x, t + 0.45f * rail * (float)k, 0), v3(1.2f * rod, 1.2f * rod, 1.85f * z));
        dmg_use(b, platform);
    }
}

/* Bars that cross in pairs, level above level; as a rule each is a part that turns on its lower pin. */
static void draw_scissor_lift(dmg_builder* b, const lift* l) {
    int levels = dmg_int(b, 1, 4);
    float base = draw_lift_base(b, l), reach = 1.6f * l->half, lean = dmg_range(b, 0.2f, 0.8f), bar = 0.7f * l->t,
          level = reach * tanf(lean);
    bool move = dmg_chance(b, 0.7f), twin = dmg_chance(b, 0.7f);
    for (int i = 0; i < levels; ++i)
        for (int k = 0; k < 2; ++k) {
            float side = k ? 1.0f : -1.0f, y = base + 0.5f * bar + level * (float)i;
            dmg_vec from = {side * 0.5f * reach, y, 0}, to = {-side * 0.5f * reach, y + level, 0};
            if (move && (i == 0 || dmg_chance(b, 0.7f)))
                dmg_hinge(b, 0, "bar", from, v3(0, 0, side), -0.6f * lean, dmg_range(b, 0.1f, 0.5f));
            for (int s = -1; s <= (twin ? 1 : -1); s += 2) {
                float z = twin ? (float)s * (0.42f * l->deep - (k ? 1.1f * bar : 0)) : (k ? 1.1f * bar : 0);
                dmg_beam(b, v3(from.x, from.y, z), v3(to.x, to.y, z), bar, 1.3f * bar);
            }
            if (twin) dmg_rod(b, v3(to.x, to.y, -0.4f * l->deep), v3(to.x, to.y, 0.4f * l->deep), 0.4f * bar);
            dmg_use(b, 0);
        }
    dmg_move(b, 0, base + level * (float)levels + bar, 0);
    float down = level * (float)levels * dmg_range(b, 0.3f, 0.8f);
    uint32_t platform = dmg_slide(b, 0, "platform", v3(0, 1, 0), -down, level * dmg_range(b, 0.1f, 0.6f));
    draw_platform(b, platform, l);
    dmg_use(b, 0);
}

/* Sleeves in one another, the inmost carries; round or square, the widest below or above. */
static void draw_telescope_lift(dmg_builder* b, const lift* l) {
    int stages = dmg_int(b, 1, 4);
    bool round = dmg_chance(b, 0.5f), inverted = dmg_chance(b, 0.2f);
    float base = draw_lift_base(b, l), high = l->half * dmg_range(b, 0.8f, 3.0f),
          r = l->half * dmg_range(b, 0.15f, 0.5f), shown = high * dmg_range(b, 0.03f, 0.4f),
          shrink = dmg_range(b, 0.75f, 0.92f), y = base;
    uint32_t carrier = 0;
    if (inverted) r *= powf(shrink, (float)stages), shrink = 1.0f / shrink;
    for (int i = 0; i <= stages; ++i) {
        if (i > 0) carrier = dmg_slide(b, carrier, "stage", v3(0, 1, 0), 0.0f, 0.8f * high - shown);
        float low = y + (i && inverted ? 0.15f * high : 0.0f);
        if (round)
            dmg_rod(b, v3(0, low, 0), v3(0, y + high, 0), r);
        else
            dmg_box(b, v3(0, 0.5f * (low + y + high), 0), v3(2 * r, y + high - low, 2 * r));
        if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, y + 0.95f * high, 0), v3(0, y + high, 0), (round ? 1.1f : 1.5f) * r);
        if (i < stages) y += shown;
        r *= shrink;
    }
    dmg_move(b, 0, y + high, 0);
    if (dmg_chance(b, 0.4f)) carrier = dmg_spin(b, carrier, "turntable", v3(0, 0, 0), v3(0, 1, 0));
    draw_platform(b, carrier, l);
    dmg_use(b, 0);
}

/* Shoulders with a head on a carriage; arms that hang from them. */
static void draw_torso(dmg_builder* b, uint32_t torso, float size) {
    float wide = size * dmg_range(b, 0.6f, 1.2f), t = 0.2f * size;
    dmg_rounded_box(b, v3(0, 0, 0.5f * size), v3(wide, 0.5f * size, 0.7f * size), 0.1f * size);
    dmg_rod(b, v3(-0.5f * wide - t, 0, 0.5f * size), v3(0.5f * wide + t, 0, 0.5f * size), t);
    for (int s = -1; s <= 1; s += 2) {
        if (dmg_chance(b, 0.3f)) continue;
        dmg_vec at = {(float)s * (0.5f * wide + 1.2f * t), 0, 0.5f * size},
                elbow = v3_add(at, v3(0, -0.7f * size, 0.3f * size));
        uint32_t arm = dmg_hinge(b, torso, "arm", at, v3(dmg_sign(b), 0, 0), -1.0f, 1.0f);
        dmg_beam(b, at, elbow, t, t);
        dmg_hinge(b, arm, "forearm", elbow, v3(dmg_sign(b), 0, 0), -1.0f, 1.0f);
        dmg_beam(b, elbow, v3_add(elbow, v3(0, 0, 0.7f * size)), 0.8f * t, 0.8f * t);
        dmg_use(b, torso);
    }
    if (dmg_chance(b, 0.7f)) {
        dmg_vec neck = {0, 0.25f * size, 0.5f * size};
        dmg_hinge(b, torso, "head", neck, dmg_chance(b, 0.5f) ? v3(0, 1, 0) : v3(1, 0, 0), -0.8f, 0.8f);
        dmg_rod(b, neck, v3_add(neck, v3(0, 0.3f * size, 0)), 0.5f * t);
        dmg_box(b, v3_add(neck, v3(0, 0.35f * size, 0.05f * size)), v3(0.6f * size, 0.25f * size, 0.25f * size));
        dmg_use(b, torso);
    }
}

/* Draws a mast of one, two or four profiles with a carriage before it: a torso, a fork, a table, a hook. */
static void draw_mast_lift(dmg_builder* b, const lift* l) {
    float base = draw_lift_base(b, l), high = l->half * dmg_range(b, 2.0f, 6.0f), t = l->t * dmg_range(b, 0.6f, 1.5f),
          car = l->half * dmg_range(b, 0.4f, 0.9f), gap = l->half * dmg_range(b, 0.25f, 0.8f),
          from = car * dmg_range(b, 0.3f, 1.0f);
    int profile = dmg_int(b, 0, 2), load = dmg_int(b, 0, 2);
    dmg_move(b, 0, base, -l->deep * dmg_range(b, 0.0f, 0.35f));
    uint32_t mast = 0;
    if (load == 1 && dmg_chance(b, 0.3f)) mast = dmg_hinge(b, 0, "mast", v3(0, 0, 0), v3(1, 0, 0), -0.1f, 0.15f);
    if (profile == 0) dmg_box(b, v3(0, 0.5f * high, -0.5f * t), v3(gap, high, t));
    if (profile == 1) dmg_rod(b, v3(0, 0, -0.6f * gap), v3(0, high, -0.6f * gap), 0.55f * gap);
    for (int s = -1; s <= 1 && profile == 2; s += 2)
        dmg_box(b, v3((float)s * gap, 0.5f * high, -0.5f * t), v3(t, high, t));
    if (profile == 2)
        for (int s = 0; s <= 1; ++s) dmg_box(b, v3(0, s ? high : t, -0.5f * t), v3(2 * gap, t, 0.8f * t));
    float way = high - from - 0.6f * car;
    uint32_t carriage = dmg_slide(b, mast, load ? "carriage" : "torso", v3(0, 1, 0), 0.0f, way);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, carriage, way * dmg_unit(b));
    dmg_move(b, 0, from, 0);
    bool ring = dmg_chance(b, 0.4f);
    dmg_box(b, v3(0, 0, 0.3f * t), v3(2.2f * gap + t, 0.5f * car, 0.6f * t));
    for (int s = -1; s <= 1 && ring; s += 2) /* round the profile */
        dmg_box(b, v3((float)s * (1.1f * gap + 0.6f * t), 0, -0.5f * gap), v3(0.5f * t, 0.4f * car, 1.2f * gap));
    dmg_move(b, 0, 0, 0.6f * t);
    if (load == 0) draw_torso(b, carriage, car);
    if (load == 2) {
        dmg_box(b, v3(0, -0.2f * car, car), v3(2.2f * gap + t, 0.4f * t, 2 * car));
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * gap, 0.1f * car, 0), v3((float)s * gap, -0.2f * car, 1.4f * car), 0.4f * t,
                     0.4f * t);
    }
    for (int s = -1; s <= 1 && load == 1; s += 2) {
        float x = (float)s * 0.6f * gap;
        if (dmg_chance(b, 0.3f)) dmg_slide(b, carriage, "fork", v3(1, 0, 0), -0.3f * gap, 0.3f * gap);
        dmg_box(b, v3(x, 0, 0.2f * t), v3(0.4f * t, 0.8f * car, 0.4f * t));
        dmg_box(b, v3(x, -0.4f * car, 0.9f * car), v3(0.5f * t, 0.2f * t, 1.8f * car));
        dmg_use(b, carriage);
    }
    dmg_use(b, 0);
}

void dmg_build_lift_column(dmg_builder* b) {
    lift l = {.half = dmg_scale_range(b, 0.06f, 1.5f)};
    l.deep = l.half * dmg_range(b, 0.8f, 2.2f);
    l.t = l.half * dmg_range(b, 0.06f, 0.22f);
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) draw_scissor_lift(b, &l);
    if (kind == 1) draw_telescope_lift(b, &l);
    if (kind > 1) draw_mast_lift(b, &l);
}

/* ---- axes on axes ---- */

typedef struct axis_style {
    int body;  /* plain beam, channel with a cover, two rods between plates, T-slot with a strip */
    int table; /* of the carriage: block, plate, saddle over the beam */
    bool motor;
} axis_style;

/* Draws one linear axis along +X about the origin, its carriage on +Y. Returns the carriage, leaves the frame on its
 * top. */
static uint32_t draw_axis(dmg_builder* b, const axis_style* s, uint32_t carrier, float length, float w) {
    float h = 0.6f * w, car = fminf(w * dmg_range(b, 0.8f, 1.8f), 0.5f * length), t = 0.25f * w;
    dmg_use(b, carrier);
    if (s->body == 0) dmg_box(b, v3(0, 0.5f * h, 0), v3(length, h, w));
    if (s->body == 1) {
        dmg_box(b, v3(0, 0.25f * h, 0), v3(length, 0.5f * h, w));
        for (int e = -1; e <= 1; e += 2)
            dmg_box(b, v3(0, 0.7f * h, (float)e * 0.42f * w), v3(length, 0.6f * h, 0.16f * w));
        dmg_rod(b, v3(-0.5f * length, 0.7f * h, 0), v3(0.5f * length, 0.7f * h, 0), 0.12f * w);
    }
    if (s->body == 2)
        for (int e = -1; e <= 1; e += 2) {
            dmg_rod(b, v3(-0.5f * length, 0.5f * h, (float)e * 0.35f * w),
                    v3(0.5f * length, 0.5f * h, (float)e * 0.35f * w), 0.1f * w);
            dmg_box(b, v3((float)e * 0.5f * length, 0.5f * h, 0), v3(t, h, w));
        }
    if (s->body == 3) {
        dmg_box(b, v3(0, 0.4f * h, 0), v3(length, 0.8f * h, 0.7f * w));
        dmg_box(b, v3(0, 0.9f * h, 0), v3(length, 0.2f * h, 0.25f * w));
    }
    if (s->motor) {
        dmg_box(b, v3(-0.5f * length - 0.4f * w, 0.45f * h, 0), v3(0.8f * w, 0.8f * w, 0.8f * w));
        if (dmg_chance(b, 0.3f)) { /* its hand wheel */
            dmg_spin(b, carrier, "handwheel", v3(0, 0.5f * h, 0), v3(1, 0, 0));
            dmg_rod(b, v3(0.5f * length + 0.2f * w, 0.5f * h, 0), v3(0.5f * length + 0.35f * w, 0.5f * h, 0),
                    0.35f * w);
            dmg_rod(b, v3(0.5f * length, 0.5f * h, 0), v3(0.5f * length + 0.2f * w, 0.5f * h, 0), 0.08f * w);
            dmg_box(b, v3(0.5f * length + 0.45f * w, 0.5f * h + 0.2f * w, 0), v3(0.25f * w, 0.1f * w, 0.1f * w));
        }
    }
    float way = 0.5f * (length - car) - (s->body == 2 ? t : 0);
    uint32_t carriage = dmg_slide(b, carrier, "axis", v3(dmg_sign(b), 0, 0), -way, way);
    if (dmg_chance(b, 0.8f)) dmg_rest(b, carriage, way * dmg_range(b, -1, 1));
    float low = s->body == 2 ? 0.25f * h : h;
    if (s->table == 0) dmg_box(b, v3(0, 0.5f * (low + h + t), 0), v3(car, h + t - low, 0.9f * w));
    if (s->table == 1) dmg_box(b, v3(0, h + 0.5f * t, 0), v3(car, t, 1.5f * w));
    if (s->table == 2) {
        dmg_box(b, v3(0, h + 0.5f * t, 0), v3(car, t, 1.3f * w));
        for (int e = -1; e <= 1; e += 2)
            dmg_box(b, v3(0, 0.6f * h, (float)e * 0.58f * w), v3(car, 0.8f * h, 0.14f * w));
    }
    if (s->body == 2 && s->table) dmg_box(b, v3(0, 0.6f * h, 0), v3(0.8f * car, 0.9f * h, 0.9f * w));
    dmg_move(b, 0, h + t, 0);
    return carriage;
}

/* Along, across and up, in any order; a turntable, a cradle or a probe on the last. */
static void draw_stack(dmg_builder* b) {
    float w = dmg_scale_range(b, 0.02f, 0.4f), length = w * dmg_range(b, 2.5f, 9.0f);
    int axes = dmg_int(b, 1, 3), order = dmg_int(b, 0, 2);
    axis_style s = {.body = dmg_int(b, 0, 3)};
    s.table = dmg_int(b, 0, 2);
    s.motor = dmg_chance(b, 0.5f);
    if (dmg_chance(b, 0.4f)) {
        dmg_box(b, v3(0, 0.2f * w, 0), v3(1.2f * length, 0.4f * w, 0.8f * length));
        dmg_move(b, 0, 0.4f * w, 0);
    }
    uint32_t carrier = 0;
    for (int i = 0; i < axes; ++i) {
        bool up = i == axes - 1 && i > 0 && order > 0;
        if (i > 0 && !up) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        if (up) { /* on its end, on a foot */
            dmg_box(b, v3(0, 0.05f * w, 0), v3(w, 0.1f * w, w));
            dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
            dmg_move(b, 0.5f * length + (s.motor ? 0.8f * w : 0), 0, 0);
        }
        carrier = draw_axis(b, &s, carrier, length, w);
        length *= dmg_range(b, 0.5f, 0.9f);
        w *= dmg_range(b, 0.75f, 0.95f);
        if (length < 2.5f * w) length = 2.5f * w;
    }
    int load = dmg_int(b, 0, 3);
    if (load == 1 || load == 2) {
        dmg_spin(b, carrier, "turntable", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.3f * w, 0), 0.6f * w);
        dmg_box(b, v3(0.3f * w, 0.5f * w, 0), v3(0.3f * w, 0.4f * w, 0.3f * w));
    }
    if (load == 3) {
        dmg_box(b, v3(0, 0.3f * w, 0), v3(0.5f * w, 0.6f * w, 0.5f * w));
        dmg_rod(b, v3(0, 0.4f * w, 0), v3(1.5f * w, 0.4f * w, 0), 0.1f * w);
    }
    dmg_use(b, 0);
}

/* Draws a cylinder hung at its eye between lugs, its rod out or in, an eye at the rod's end. */
static void draw_actuator(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.1f, 1.5f), r = length * dmg_range(b, 0.04f, 0.14f),
          eye = r * dmg_range(b, 0.7f, 1.2f), lean = dmg_range(b, 0.1f, 1.5f), out = length * dmg_range(b, 0.05f, 0.7f);
    bool swings = dmg_chance(b, 0.7f);
    dmg_box(b, v3(0, 0.2f * eye, 0), v3(6 * eye, 0.4f * eye, 5 * eye));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(0, 1.3f * eye, (float)s * 1.1f * eye), v3(1.6f * eye, 2.2f * eye, 0.4f * eye));
    dmg_move(b, 0, 1.8f * eye, 0);
    dmg_turn(b, v3(0, 0, 1), lean);
    uint32_t barrel = 0;
    if (swings) barrel = dmg_hinge(b, 0, "cylinder", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -0.4f * lean, 0.4f * lean);
    dmg_rod(b, v3(0, 0, -1.6f * eye), v3(0, 0, 1.6f * eye), 0.4f * eye);
    dmg_box(b, v3(0.8f * eye, 0, 0), v3(2 * eye, 1.2f * eye, 1.5f * eye));
    if (dmg_chance(b, 0.7f))
        dmg_rod(b, v3(1.5f * eye, 0, 0), v3(1.5f * eye + length, 0, 0), r);
    else
        dmg_box(b, v3(1.5f * eye + 0.5f * length, 0, 0), v3(length, 2 * r, 2 * r));
    if (dmg_chance(b, 0.4f))
        dmg_box(b, v3(1.5f * eye + 0.15f * length, 1.8f * r, 0), v3(0.3f * length, 2 * r, 1.4f * r));
    float mouth = 1.5f * eye + length;
    dmg_slide(b, barrel, "rod", v3(1, 0, 0), -0.9f * out, 0.9f * (length - out));
    dmg_rod(b, v3(mouth - (length - out), 0, 0), v3(mouth + out + eye, 0, 0), r * dmg_range(b, 0.3f, 0.7f));
    dmg_rod(b, v3(mouth + out + eye, 0, -0.7f * eye), v3(mouth + out + eye, 0, 0.7f * eye), eye);
    dmg_use(b, 0);
}

void dmg_build_stacked_axes(dmg_builder* b) {
    if (dmg_chance(b, 0.25f))
        draw_actuator(b);
    else
        draw_stack(b);
}
