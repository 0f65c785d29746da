/* Draws hands unlike human ones: three fingers round a palm, prostheses with one-piece fingers, hooks, scoops. The
 * palm's face is z = 0, fingers reach to +Z. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct digit {
    int links, shape; /* box, rod, tapered, plates, blade that is bent */
    float length, wide, deep;
    float bend;  /* inwards, at each joint, as drawn */
    float swing; /* of each joint */
    bool pads, knuckles;
} digit;

static digit pick_digit(dmg_builder* b, float palm) {
    digit d = {.links = dmg_int(b, 1, 3)};
    d.shape = dmg_int(b, 0, 4);
    d.length = palm * dmg_range(b, 0.7f, 1.8f);
    d.wide = palm * dmg_range(b, 0.14f, 0.3f);
    d.deep = palm * dmg_range(b, 0.12f, 0.28f);
    d.bend = dmg_range(b, 0.1f, 0.7f);
    d.swing = dmg_range(b, 0.4f, 1.1f);
    d.pads = dmg_chance(b, 0.4f);
    d.knuckles = dmg_chance(b, 0.5f);
    return d;
}

/* From joint to joint in the plane of X and Z; inwards is -X. */
static void draw_bone(dmg_builder* b, const digit* d, dmg_vec from, dmg_vec to) {
    float w = d->wide, t = d->deep;
    dmg_vec mid = v3_lerp(from, to, 0.5f);
    if (d->shape == 0) dmg_beam(b, from, to, t, w);
    if (d->shape == 1) dmg_rod(b, from, to, 0.5f * w);
    if (d->shape == 2) dmg_cone(b, from, to, 0.55f * w, 0.35f * w);
    if (d->shape == 3)
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec off = {0, (float)s * 0.42f * w, 0};
            dmg_beam(b, v3_add(from, off), v3_add(to, off), t, 0.16f * w);
        }
    if (d->shape == 3) dmg_rod(b, v3_add(mid, v3(0, -0.5f * w, 0)), v3_add(mid, v3(0, 0.5f * w, 0)), 0.2f * t);
    if (d->shape == 4) { /* outwards first, then in */
        mid.x += 0.2f * v3_length(v3_sub(to, from));
        dmg_beam(b, from, mid, 0.7f * t, w);
        dmg_beam(b, mid, to, 0.6f * t, 0.9f * w);
    }
    if (d->pads)
        dmg_box(b, v3_add(v3_lerp(from, to, 0.6f), v3(-0.55f * t, 0, 0)),
                v3(0.3f * t, 0.8f * w, 0.35f * v3_length(v3_sub(to, from))));
}

/* Draws a finger at the origin: its joints turn about Y, the tip inwards. */
static void draw_digit(dmg_builder* b, const digit* d, uint32_t carrier, const char* name) {
    float lean = dmg_chance(b, 0.5f) ? 0.4f * d->bend : 0.0f, each = d->length / (float)d->links;
    dmg_vec at = {0, 0, 0};
    for (int i = 0; i < d->links; ++i) {
        dmg_vec to = v3_mad(at, v3(sinf(lean), 0, cosf(lean)), each);
        float sign = dmg_sign(b), out = d->swing * dmg_range(b, 0.3f, 1.0f);
        carrier =
            dmg_hinge(b, carrier, name, at, v3(0, sign, 0), sign > 0 ? -d->swing : -out, sign > 0 ? out : d->swing);
        if (d->knuckles)
            dmg_rod(b, v3_add(at, v3(0, -0.6f * d->wide, 0)), v3_add(at, v3(0, 0.6f * d->wide, 0)), 0.55f * d->deep);
        draw_bone(b, d, at, to);
        lean -= d->bend;
        each *= 0.85f;
        at = to;
    }
}

/* Draws the forearm behind, the palm before it; standing, lying or hanging. Returns what the fingers are carried by. */
static uint32_t draw_wrist(dmg_builder* b, float palm) {
    float back = palm * dmg_range(b, 0.6f, 2.5f), r = palm * dmg_range(b, 0.25f, 0.45f);
    int pose = dmg_int(b, 0, 2), wrist = dmg_int(b, 0, 3);
    dmg_move(b, 0, pose ? 2.5f * palm : back + palm, 0);
    if (pose != 1) dmg_turn(b, v3(1, 0, 0), (pose == 0 ? -0.5f : 0.5f) * DMG_PI);
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0.0f, 3.0f));
    float end = palm * (wrist > 1 ? 0.9f : 0.6f);
    if (dmg_chance(b, 0.6f))
        dmg_cone(b, v3(0, 0, -back - end), v3(0, 0, -end), 1.2f * r, r);
    else
        dmg_box(b, v3(0, 0, -0.5f * back - end), v3(2 * r, 1.6f * r, back));
    if (wrist == 0) return 0;
    if (wrist == 1) return dmg_spin(b, 0, "wrist", v3(0, 0, -end), v3(0, 0, 1));
    dmg_vec axis = wrist == 2 ? v3(0, 1, 0) : v3(1, 0, 0), at = {0, 0, 0.15f * palm - end};
    bool fork = dmg_chance(b, 0.5f);
    if (fork) dmg_rod(b, v3_mad(at, axis, -0.5f * r), v3_mad(at, axis, 0.5f * r), 0.15f * palm);
    uint32_t part = dmg_hinge(b, 0, "wrist", at, axis, -0.6f, 0.6f);
    dmg_rod(b, v3(0, 0, fork ? at.z : -end), v3(0, 0, -0.5f * palm), 0.45f * r);
    return part;
}

/* Draws two fingers that swing round the palm's edge and one that does not; or all three alike. */
static void draw_three(dmg_builder* b, uint32_t palm_part, float palm) {
    digit d = pick_digit(b, palm);
    int shell = dmg_int(b, 0, 2), count = dmg_chance(b, 0.8f) ? 3 : 4;
    bool spreads = count == 3 && dmg_chance(b, 0.6f);
    float r = 0.5f * palm, open = dmg_range(b, 0.5f, 1.4f);
    if (shell == 0) dmg_rod(b, v3(0, 0, -0.6f * palm), v3(0, 0, -0.3f * d.deep), 1.05f * r);
    if (shell == 1) dmg_rounded_box(b, v3(0, 0, -0.3f * palm), v3(1.1f * palm, 1.1f * palm, 0.6f * palm), 0.15f * palm);
    if (shell == 2) dmg_cone(b, v3(0, 0, -0.6f * palm), v3(0, 0, -0.3f * d.deep), 0.6f * r, 1.1f * r);
    for (int i = 0; i < count; ++i) {
        uint32_t carrier = palm_part;
        dmg_save(b);
        if (spreads && i > 0) {
            float side = i == 1 ? 1.0f : -1.0f;
            dmg_turn(b, v3(0, 0, 1), DMG_PI - side * dmg_range(b, 0.3f, 0.9f));
            dmg_move(b, 0.85f * r, 0, 0);
            dmg_use(b, palm_part);
            carrier = dmg_hinge(b, palm_part, "spread", v3(0, 0, 0), v3(0, 0, side), -open, open);
            dmg_rod(b, v3(0, 0, -0.6f * d.deep), v3(0, 0, 0.5f * d.deep), 0.7f * d.wide);
            dmg_move(b, 0, 0, 0.5f * d.deep);
        } else {
            dmg_turn_to(b, v3(0, 0, 1), i, count);
            dmg_move(b, 0.85f * r, 0, 0);
        }
        dmg_use(b, palm_part);
        draw_digit(b, &d, carrier, "finger");
        dmg_restore(b);
    }
}

/* Draws a palm, four fingers of one or two links side by side, a thumb that swings across. */
static void draw_prosthesis(dmg_builder* b, uint32_t palm_part, float palm) {
    digit d = pick_digit(b, palm);
    d.links = dmg_int(b, 1, 2);
    d.shape = dmg_chance(b, 0.5f) ? 2 : d.shape;
    d.wide = 0.2f * palm;
    d.deep = palm * dmg_range(b, 0.14f, 0.22f);
    int fingers = dmg_int(b, 2, 4), shell = dmg_int(b, 0, 2);
    float step = 0.24f * palm, half = 0.5f * step * (float)fingers;
    if (shell == 0) dmg_rounded_box(b, v3(0, 0, -0.35f * palm), v3(0.3f * palm, 2 * half, 0.6f * palm), 0.1f * palm);
    if (shell == 1) dmg_box(b, v3(0, 0, -0.35f * palm), v3(0.22f * palm, 2 * half, 0.65f * palm));
    if (shell == 2)
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.13f * palm, 0, -0.33f * palm), v3(0.05f * palm, 2 * half, 0.66f * palm));
    if (shell == 2) dmg_box(b, v3(0, 0, -0.6f * palm), v3(0.3f * palm, half, 0.1f * palm));
    for (int i = 0; i < fingers; ++i) {
        dmg_save(b);
        dmg_move(b, 0, step * ((float)i + 0.5f) - half, 0);
        dmg_use(b, palm_part);
        draw_digit(b, &d, palm_part, "finger");
        dmg_restore(b);
    }
    float side = dmg_sign(b);
    dmg_vec root = {-0.1f * palm, side * half, -0.45f * palm};
    dmg_use(b, palm_part);
    uint32_t thumb = palm_part;
    dmg_move(b, root.x, root.y, root.z);
    if (dmg_chance(b, 0.7f)) {
        thumb = dmg_hinge(b, palm_part, "thumb_base", v3(0, 0, 0), v3(0, 0, side), -0.2f, 1.4f);
        dmg_rod(b, v3(0, 0, -0.15f * palm), v3(0, 0, 0.1f * palm), 0.12f * palm);
    }
    dmg_move(b, 0, side * 0.12f * palm, 0);
    dmg_turn(b, v3(0, 0, 1), side * -0.5f * DMG_PI * dmg_range(b, -0.3f, 0.3f));
    dmg_turn(b, v3(1, 0, 0), -side * dmg_range(b, 0.3f, 0.8f));
    d.length *= 0.75f;
    draw_digit(b, &d, thumb, "thumb");
}

/* Draws a split hook: one half stays, the other turns at its root; or a scoop with a lid; or suction cups on springs.
 */
static void draw_hook(dmg_builder* b, uint32_t palm_part, float palm) {
    enum { POINTS = 7 };
    float t = 0.1f * palm, reach = palm * dmg_range(b, 0.8f, 1.6f), curl = dmg_range(b, 1.2f, 3.0f),
          out = palm * dmg_range(b, 0.2f, 0.5f);
    dmg_vec path[POINTS];
    int kind = dmg_int(b, 0, 2), cups = dmg_int(b, 1, 4);
    dmg_cone(b, v3(0, 0, -0.6f * palm), v3(0, 0, 0), 0.35f * palm, 0.25f * palm);
    for (int i = 0; i < POINTS; ++i) {
        float share = (float)i / (POINTS - 1), angle = share * curl;
        path[i] =
            v3(0.15f * palm + out * (1.0f - cosf(angle)), 0.14f * palm, reach * (0.6f * share + 0.4f * sinf(angle)));
    }
    for (int half = 0; half < 2 && kind == 0; ++half) {
        if (half)
            dmg_hinge(b, palm_part, "hook", v3(0.15f * palm, 0, 0.05f * palm), v3(1, 0, 0), 0.0f,
                      dmg_range(b, 0.5f, 1.2f));
        dmg_save(b);
        if (half) dmg_mirror(b, v3(0, 1, 0));
        dmg_sweep(b, path, POINTS, t, 0.8f * t, false);
        if (half)
            dmg_beam(b, v3(0.15f * palm, 0.1f * palm, 0.05f * palm), v3(-0.3f * palm, 0.2f * palm, 0.05f * palm), t, t);
        dmg_restore(b);
    }
    if (kind == 1) { /* two shells that part */
        const dmg_xy shell[] = {{0.42f * palm, 0},
                                {0.5f * palm, 0},
                                {0.4f * palm, 0.6f * palm},
                                {0.3f * palm, 0.6f * palm},
                                {0.42f * palm, 0}};
        bool both = dmg_chance(b, 0.5f);
        for (int s = -1; s <= 1; s += 2) {
            dmg_use(b, palm_part);
            if (s > 0 || both)
                dmg_hinge(b, palm_part, "shell", v3(0, 0, 0.02f * palm), v3((float)-s, 0, 0), 0.0f,
                          dmg_range(b, 0.5f, 1.3f));
            dmg_lathe_arc(b, v3(0, 0, 0.05f * palm), v3(0, 0, 1), shell, 5,
                          s > 0 ? 0.5f * DMG_PI + 1.6f : 1.6f - 0.5f * DMG_PI, DMG_PI - 0.05f);
        }
    }
    if (kind == 2) {
        dmg_box(b, v3(0, 0, 0.1f * palm), v3(1.6f * palm, cups > 2 ? 1.2f * palm : 0.3f * palm, 0.12f * palm));
        for (int i = 0; i < cups; ++i) {
            float x = cups == 1 ? 0.0f : (i % 2 ? 0.65f : -0.65f) * palm,
                  y = cups > 2 ? (i / 2 ? 0.45f : -0.45f) * palm : 0.0f;
            dmg_use(b, palm_part);
            dmg_slide(b, palm_part, "cup", v3(0, 0, -1), 0.0f, 0.3f * palm);
            dmg_rod(b, v3(x, y, 0), v3(x, y, 0.6f * palm), 0.06f * palm);
            dmg_cone(b, v3(x, y, 0.55f * palm), v3(x, y, 0.7f * palm), 0.08f * palm, 0.2f * palm);
        }
    }
}

void dmg_build_finger_hand(dmg_builder* b) {
    float palm = dmg_scale_range(b, 0.03f, 0.4f);
    uint32_t part = draw_wrist(b, palm);
    int kind = dmg_int(b, 0, 4);
    dmg_use(b, part);
    if (kind < 2) draw_three(b, part, palm);
    if (kind == 2 || kind == 3) draw_prosthesis(b, part, palm);
    if (kind == 4) draw_hook(b, part, palm);
    dmg_use(b, 0);
}
