/* Draws robots and the objects they handle as collision shapes: a box, a cylinder, a capsule or a ball for each
 * link. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct prim {
    int shape; /* capsule, box, cylinder, egg */
    float gap; /* fraction of a link's length left free at both ends; negative: the links run into each other */
    bool ball; /* balls at the joints */
} prim;

static prim pick_prim(dmg_builder* b) {
    prim p = {.shape = dmg_int(b, 0, 3)};
    p.ball = dmg_chance(b, 0.25f);
    int fit = dmg_int(b, 0, 2);
    if (fit == 1) p.gap = dmg_range(b, 0.04f, 0.22f);
    if (fit == 2) p.gap = -dmg_range(b, 0.03f, 0.12f);
    return p;
}

/* Draws a link from joint to joint, `wide` thick. */
static void draw_limb(dmg_builder* b, const prim* p, dmg_vec from, dmg_vec to, float wide) {
    dmg_vec start = v3_lerp(from, to, p->gap), end = v3_lerp(to, from, p->gap), along = v3_sub(end, start);
    if (p->ball) dmg_ellipsoid(b, from, v3(0.6f * wide, 0.6f * wide, 0.6f * wide));
    if (p->shape == 0) dmg_capsule(b, start, end, 0.5f * wide);
    if (p->shape == 1) dmg_beam(b, start, end, wide, wide);
    if (p->shape == 2) dmg_rod(b, start, end, 0.5f * wide);
    if (p->shape == 3) {
        float half = 0.5f * v3_length(along), r = 0.55f * wide;
        const dmg_xy egg[] = {{0, 0}, {0.7f * r, 0.3f * half}, {r, half}, {0.7f * r, 1.7f * half}, {0, 2 * half}};
        dmg_lathe(b, start, along, egg, 5);
    }
}

/* Draws the torso of a robot. */
static void draw_trunk(dmg_builder* b, const prim* p, dmg_vec centre, dmg_vec size) {
    if (p->shape == 1) dmg_box(b, centre, size);
    if (p->shape == 3) dmg_ellipsoid(b, centre, v3_scale(size, 0.55f));
    if (p->shape != 0 && p->shape != 2) return;
    float r = 0.5f * fminf(size.x, fminf(size.y, size.z)), half = 0.5f * fmaxf(size.x, fmaxf(size.y, size.z)) - r;
    dmg_vec along = size.x >= size.y && size.x >= size.z ? v3(1, 0, 0) : (size.y >= size.z ? v3(0, 1, 0) : v3(0, 0, 1));
    if (p->shape == 0) dmg_capsule(b, v3_mad(centre, along, -half), v3_mad(centre, along, half), r);
    if (p->shape == 2) dmg_rod(b, v3_mad(centre, along, -half - r), v3_mad(centre, along, half + r), r);
}

/* Draws two links and an end, all about axes across the limb. */
static void draw_jointed(dmg_builder* b, const prim* p, uint32_t carrier, const char* const names[3],
                         const dmg_vec at[4], float wide, dmg_vec axis, float swing) {
    for (int i = 0; i < 3 && names[i]; ++i) {
        float sign = dmg_sign(b);
        carrier = dmg_hinge(b, carrier, names[i], at[i], v3_scale(axis, sign), -swing, swing);
        draw_limb(b, p, at[i], at[i + 1], wide);
        wide *= 0.8f;
        if (!names[2]) axis = v3(1, 0, 0);
    }
    if (!names[2] && dmg_chance(b, 0.5f)) dmg_ellipsoid(b, at[2], v3(0.8f * wide, 0.8f * wide, 0.8f * wide));
}

/* ---- creatures ---- */

static void draw_humanoid(dmg_builder* b, float s) {
    prim p = pick_prim(b);
    float hip = 0.12f * s, shoulder = 0.2f * s, wide = s * dmg_range(b, 0.07f, 0.12f),
          spread = dmg_range(b, 0.0f, 1.4f), swing = dmg_range(b, 0.5f, 1.1f);
    bool waist = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 1.05f * s, 0);
    draw_trunk(b, &p, v3(0, 0.4f * s, 0), v3(0.45f * s, 0.22f * s, 0.18f * s));
    if (dmg_chance(b, 0.7f))
        dmg_hinge(b, 0, "head", v3(0, 0.55f * s, 0), dmg_chance(b, 0.5f) ? v3(0, 1, 0) : v3(1, 0, 0), -0.7f, 0.7f);
    dmg_ellipsoid(b, v3(0, 0.68f * s, 0), v3(0.1f * s, 0.12f * s, 0.11f * s));
    dmg_box(b, v3(0, 0.68f * s, 0.1f * s), v3(0.1f * s, 0.04f * s, 0.06f * s));
    dmg_use(b, 0);
    uint32_t pelvis = 0;
    if (waist) pelvis = dmg_hinge(b, 0, "pelvis", v3(0, 0.2f * s, 0), v3(0, dmg_sign(b), 0), -0.7f, 0.7f);
    draw_trunk(b, &p, v3(0, 0.08f * s, 0), v3(0.34f * s, 0.18f * s, 0.17f * s));
    for (int side = -1; side <= 1; side += 2) {
        float x = (float)side, turn = x * spread, bend = dmg_range(b, 0.0f, 0.8f);
        dmg_vec arm[4] = {{x * 1.25f * shoulder, 0.46f * s, 0}}, leg[4] = {{x * hip, 0, 0}};
        arm[1] = v3_add(arm[0], v3(0.33f * s * sinf(turn), -0.33f * s * cosf(turn), 0));
        arm[2] = v3_add(arm[1], v3(0.2f * s * sinf(turn), -0.3f * s * cosf(turn) * cosf(bend), 0.3f * s * sinf(bend)));
        leg[1] = v3_add(leg[0], v3(0, -0.48f * s, 0.05f * s));
        leg[2] = v3_add(leg[1], v3(0, -0.48f * s, -0.05f * s));
        leg[3] = v3_add(leg[2], v3(0, -0.02f * s, 0.2f * s));
        dmg_vec lift = dmg_chance(b, 0.5f) ? v3(0, 0, 1) : v3(1, 0, 0);
        draw_jointed(b, &p, 0, (const char* const[3]){"upper_arm", "forearm", NULL}, arm, wide, lift, swing);
        draw_jointed(b, &p, pelvis, (const char* const[3]){"thigh", "shin", "foot"}, leg, 1.2f * wide, v3(1, 0, 0),
                     swing);
        dmg_use(b, 0);
    }
}

static void draw_quadruped(dmg_builder* b, float s) {
    prim p = pick_prim(b), body = p;
    if (dmg_chance(b, 0.4f)) body.shape = 1;
    float wide = s * dmg_range(b, 0.2f, 0.45f), high = s * dmg_range(b, 0.15f, 0.35f),
          leg = s * dmg_range(b, 0.3f, 0.55f), bend = dmg_range(b, 0.1f, 0.8f), t = s * dmg_range(b, 0.05f, 0.1f);
    bool outward = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 2 * leg, 0);
    draw_trunk(b, &body, v3(0, 0, 0), v3(wide, high, s));
    for (int i = 0; i < 4; ++i) {
        float x = i % 2 ? 1.0f : -1.0f, z = i / 2 ? 1.0f : -1.0f, at = x * (0.5f * wide + (outward ? 0.8f * t : 0.0f));
        dmg_vec hip = {at, -0.2f * high, z * 0.4f * s}, knee = v3_add(hip, v3(0, -leg * cosf(bend), -leg * sinf(bend))),
                foot = v3_add(knee, v3(0, -leg * cosf(bend), leg * sinf(bend)));
        uint32_t carrier = 0;
        if (outward && dmg_chance(b, 0.7f)) {
            carrier = dmg_hinge(b, 0, "hip", v3(x * 0.5f * wide, hip.y, hip.z), v3(0, 0, dmg_sign(b)), -0.5f, 0.5f);
            dmg_rod(b, v3_add(hip, v3(0, 0, -0.8f * t)), v3_add(hip, v3(0, 0, 0.8f * t)), 0.7f * t);
        }
        draw_jointed(b, &p, carrier, (const char* const[3]){"thigh", "shin", NULL}, (const dmg_vec[4]){hip, knee, foot},
                     t, v3(1, 0, 0), 0.8f);
        dmg_use(b, 0);
    }
}

/* ---- vehicles ---- */

/* Draws a box, a drum or a board on cylinders; casters are balls, or turn. */
static void draw_base(dmg_builder* b, float s) {
    float r = s * dmg_range(b, 0.1f, 0.3f), thin = r * dmg_range(b, 0.2f, 0.8f), high = s * dmg_range(b, 0.15f, 0.5f),
          wide = 0.5f * s, length = s * dmg_range(b, 0.8f, 1.6f),
          off = dmg_chance(b, 0.4f) ? 0.3f * thin : -0.2f * thin;
    bool car = dmg_chance(b, 0.5f), round = !car && dmg_chance(b, 0.5f), steers = dmg_chance(b, 0.6f);
    if (round) dmg_rod(b, v3(0, 0.7f * r, 0), v3(0, 0.7f * r + high, 0), 0.5f * s);
    if (!round) dmg_box(b, v3(0, 0.7f * r + 0.5f * high, 0), v3(s, high, length));
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0.7f * r + 1.25f * high, -0.1f * length), v3(0.8f * s, 0.5f * high, 0.5f * length));
    for (int i = 0; i < (car ? 4 : 2); ++i) {
        float x = (i % 2 ? 1.0f : -1.0f) * (wide + 0.5f * thin + off),
              z = car ? (i / 2 ? 0.32f : -0.32f) * length : 0.0f;
        uint32_t carrier = 0;
        if (car && i / 2 && steers) { /* the knuckle: a small box inside */
            carrier = dmg_hinge(b, 0, "knuckle", v3(x, r, z), v3(0, dmg_sign(b), 0), -0.6f, 0.6f);
            dmg_box(b, v3(x, r, z), v3(0.4f * thin, 1.4f * r * dmg_range(b, 0.3f, 1.6f), 0.3f * r));
        }
        dmg_spin(b, carrier, "wheel", v3(x, r, z), v3(1, 0, 0));
        if (dmg_chance(b, 0.85f))
            dmg_rod(b, v3(x - 0.5f * thin, r, z), v3(x + 0.5f * thin, r, z), r);
        else
            dmg_ellipsoid(b, v3(x, r, z), v3(0.6f * thin, r, r));
        dmg_use(b, 0);
    }
    for (int i = -1; i <= 1 && !car; i += 2) {
        float z = (float)i * 0.38f * (round ? s : length);
        if (i > 0 && dmg_chance(b, 0.5f)) continue;
        bool turns = dmg_chance(b, 0.5f);
        if (turns) dmg_spin(b, 0, "caster", v3(0, 0, z), v3(0, 1, 0));
        if (turns) dmg_box(b, v3(0, 0.6f * r, z - 0.1f * r), v3(0.5f * r, 0.3f * r, 0.5f * r));
        dmg_ellipsoid(b, v3(0, 0.3f * r, z - (turns ? 0.2f * r : 0)), v3(0.3f * r, 0.3f * r, 0.3f * r));
        dmg_use(b, 0);
    }
}

static void draw_quadrotor(dmg_builder* b, float s) {
    int count = dmg_chance(b, 0.7f) ? 4 : 6, rotor = dmg_int(b, 0, 2);
    float t = s * dmg_range(b, 0.03f, 0.09f), r = s * dmg_range(b, 0.25f, 0.48f), up = t * dmg_range(b, 0.6f, 2.0f),
          off = dmg_chance(b, 0.5f) ? 0.5f * DMG_PI / (float)count : 0.0f;
    prim p = pick_prim(b);
    dmg_move(b, 0, 0.5f * s, 0);
    draw_trunk(b, &p, v3(0, 0, 0), v3(0.4f * s, 0.12f * s, 0.4f * s));
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), off);
        dmg_turn_to(b, v3(0, 1, 0), i, count);
        if (p.shape == 1) dmg_box(b, v3(0.4f * s, 0, 0), v3(0.8f * s, t, t));
        if (p.shape != 1) dmg_rod(b, v3(0.1f * s, 0, 0), v3(0.8f * s, 0, 0), 0.5f * t);
        dmg_move(b, 0.8f * s, up, 0);
        if (p.gap <= 0) dmg_rod(b, v3(0, -1.2f * up, 0), v3(0, -0.1f * t, 0), 0.6f * t);
        dmg_spin(b, 0, "rotor", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
        if (rotor == 0) dmg_rod(b, v3(0, 0, 0), v3(0, 0.2f * t, 0), r);
        if (rotor == 1) dmg_box(b, v3(0, 0.1f * t, 0), v3(2 * r, 0.2f * t, 0.15f * r));
        if (rotor == 2) dmg_ellipsoid(b, v3(0, 0.1f * t, 0), v3(r, 0.2f * t, r));
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* ---- arms and what they handle ---- */

/* Cylinders and boxes one on another, every second one turned across; fingers of boxes. */
static void draw_serial_arm(dmg_builder* b, float s) {
    int joints = dmg_int(b, 2, 7);
    float wide = s * dmg_range(b, 0.05f, 0.14f);
    prim p = pick_prim(b);
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0.3f * wide, 0), v3(3 * wide, 0.6f * wide, 3 * wide));
    dmg_rod(b, v3(0, 0, 0), v3(0, 1.5f * wide, 0), 0.9f * wide);
    dmg_move(b, 0, 2 * wide, 0);
    for (int i = 0; i < joints; ++i) {
        bool rolls = i == 0 || (i > 1 && dmg_chance(b, 0.4f)), drum = dmg_chance(b, 0.4f);
        float length = s * dmg_range(b, 0.15f, 0.4f);
        if (rolls) length *= 0.5f;
        dmg_vec axis = rolls ? v3(0, 1, 0) : v3(1, 0, 0);
        carrier = rolls && dmg_chance(b, 0.4f)
                      ? dmg_spin(b, carrier, "joint", v3(0, 0, 0), axis)
                      : dmg_hinge(b, carrier, "joint", v3(0, 0, 0), v3_scale(axis, dmg_sign(b)), -1.0f, 1.0f);
        if (drum) dmg_rod(b, v3_scale(axis, rolls ? 0 : -0.6f * wide), v3_scale(axis, 0.6f * wide), 0.6f * wide);
        draw_limb(b, &p, v3(0, 0, 0), v3(0, length, 0), wide);
        dmg_move(b, 0, length, 0);
        dmg_turn(b, v3(1, 0, 0), rolls ? 0.0f : dmg_range(b, -0.8f, 1.0f));
        wide *= dmg_range(b, 0.8f, 1.0f);
    }
    dmg_box(b, v3(0, 0.2f * wide, 0), v3(2.4f * wide, 0.5f * wide, wide));
    bool slides = dmg_chance(b, 0.6f);
    for (int i = -1; i <= 1; i += 2) {
        float x = (float)i * 0.9f * wide;
        if (slides) dmg_slide(b, carrier, "finger", v3((float)-i, 0, 0), -0.2f * wide, 0.6f * wide);
        if (!slides) dmg_hinge(b, carrier, "finger", v3(x, 0.6f * wide, 0), v3(0, 0, (float)i), -0.4f, 0.4f);
        dmg_box(b, v3(x, 1.3f * wide, 0), v3(0.4f * wide, 1.6f * wide, 0.6f * wide));
        dmg_use(b, carrier);
    }
    dmg_use(b, 0);
}

/* Five boards round an opening that looks to +Z, centred. */
static void draw_open_box(dmg_builder* b, float w, float h, float deep, float t) {
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * (w - 0.5f * t), 0, -0.5f * deep), v3(t, 2 * h, deep));
        dmg_box(b, v3(0, (float)s * (h - 0.5f * t), -0.5f * deep), v3(2 * w, t, deep));
    }
    dmg_box(b, v3(0, 0, -deep + 0.5f * t), v3(2 * w, 2 * h, t));
}

static void draw_bare_handle(dmg_builder* b, const prim* p, float at, float reach, float out, float t) {
    bool bar = dmg_chance(b, 0.6f);
    if (!bar) dmg_ellipsoid(b, v3(at, 0, out), v3(1.5f * t, 1.5f * t, 1.5f * t));
    if (!bar) return;
    draw_limb(b, p, v3(at, -reach, out), v3(at, reach, out), t);
    for (int s = -1; s <= 1 && p->gap <= 0.0f; s += 2)
        dmg_rod(b, v3(at, (float)s * 0.8f * reach, 0), v3(at, (float)s * 0.8f * reach, out), 0.4f * t);
}

/* Boxes of boards: doors, a drawer, a lid, a sliding leaf, a door in three posts; handles are capsules that may float.
 */
static void draw_board_box(dmg_builder* b, float s) {
    float w = s * dmg_range(b, 0.4f, 1.0f), h = s * dmg_range(b, 0.3f, 1.0f), deep = s * dmg_range(b, 0.3f, 1.0f),
          t = s * dmg_range(b, 0.02f, 0.07f), side = dmg_sign(b);
    prim p = pick_prim(b);
    int kind = dmg_int(b, 0, 4);
    float line = dmg_chance(b, 0.5f) ? 0.0f : t, open = dmg_range(b, 1.1f, 2.1f);
    dmg_move(b, 0, h, 0);
    if (kind < 4) draw_open_box(b, w, h, deep, t);
    if (kind == 0 || kind == 4) {
        float high = kind ? h - t : h, x = kind ? w - t : w;
        for (int i = -1; i <= 1 && kind; i += 2)
            dmg_box(b, v3((float)i * (w - 0.5f * t), 0, 0.5f * t), v3(t, 2 * h, 2 * t));
        if (kind) dmg_box(b, v3(0, h - 0.5f * t, 0.5f * t), v3(2 * w, t, 2 * t));
        uint32_t door = dmg_hinge(b, 0, "door", v3(side * x, 0, line), v3(0, side, 0), 0.0f, open);
        dmg_box(b, v3(0, 0, 0.5f * t), v3(1.98f * x, 1.98f * high, t));
        dmg_move(b, 0, 0, t);
        if (kind && dmg_chance(b, 0.6f)) { /* a lever */
            float at = -side * 0.8f * x;
            dmg_hinge(b, door, "lever", v3(at, 0, 0), v3(0, 0, -side), 0.0f, 1.2f);
            draw_limb(b, &p, v3(at, 0, 0), v3(at, 0, 2.5f * t), t);
            draw_limb(b, &p, v3(at, 0, 2.5f * t), v3(at + side * 0.4f * x, 0, 2.5f * t), t);
        } else
            draw_bare_handle(b, &p, -side * 0.8f * x, 0.4f * high, 2 * t, 0.8f * t);
    }
    if (kind == 1) {
        dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, 0.8f * deep);
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_move(b, 0, 0.5f * deep, 0.8f * h);
        draw_open_box(b, w - 1.2f * t, 0.45f * deep, 1.7f * h, 0.7f * t);
        dmg_restore(b);
        dmg_box(b, v3(0, 0, 0.5f * t), v3(2 * w, 2 * h, t));
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        draw_bare_handle(b, &p, 0, 0.4f * w, 3 * t, 0.8f * t);
    }
    if (kind == 2) { /* turned up: a lid hung at its far edge */
        dmg_hinge(b, 0, "lid", v3(0, h, line), v3(-1, 0, 0), 0.0f, open);
        dmg_box(b, v3(0, 0, 0.5f * t), v3(2 * w, 2 * h, t));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, -0.85f * h, 1.5f * t), v3(0.4f * w, 2 * t, t));
    }
    if (kind == 3)
        for (int i = -1; i <= 1; i += 2) { /* two leaves one before the other */
            float z = i > 0 ? 0.5f * t : 1.6f * t;
            dmg_slide(b, 0, "leaf", v3((float)-i, 0, 0), 0.0f, 0.9f * w);
            dmg_box(b, v3((float)i * 0.5f * w, 0, z), v3(w, 1.96f * h, t));
            dmg_box(b, v3((float)i * 0.9f * w, 0, z + t), v3(0.5f * t, 0.5f * h, i > 0 ? 0.2f * t : t));
            dmg_use(b, 0);
        }
    dmg_use(b, 0);
}

void dmg_build_collision_model(dmg_builder* b) {
    static void (*const kinds[])(dmg_builder*, float) = {draw_humanoid,  draw_quadruped,  draw_base,
                                                         draw_quadrotor, draw_serial_arm, draw_board_box};
    static const float weights[] = {2, 1.5f, 1.5f, 1, 2.5f, 2.5f};
    float size = dmg_scale_range(b, 0.1f, 1.5f);
    kinds[dmg_weighted(b, weights, 6)](b, size);
}
