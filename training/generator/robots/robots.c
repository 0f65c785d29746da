/* Draws robots and cranes: arms, grippers, legs, mounts that pan and tilt, carriages on rails, jetways and cranes. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- links ---- */

/* How all the links of one machine look. */
typedef struct link_style {
    int body;    /* rod, beam, capsule, twin plates, block */
    int hub;     /* barrel along the axis, ball, block, bare pin */
    float thick; /* half size across */
    float hub_radius;
} link_style;

static link_style pick_links(dmg_builder* b, float thick) {
    link_style style = {.body = dmg_int(b, 0, 5), .hub = dmg_int(b, 0, 4), .thick = thick};
    style.hub_radius = thick * dmg_range(b, 0.9f, 1.7f);
    return style;
}

/* Draws what surrounds a joint's axis. */
static void draw_hub(dmg_builder* b, const link_style* s, dmg_vec at, dmg_vec axis, float half) {
    dmg_vec along = v3_scale(v3_normalize(axis), half);
    if (s->hub == 0) dmg_rod(b, v3_sub(at, along), v3_add(at, along), s->hub_radius);
    if (s->hub == 1) dmg_ellipsoid(b, at, v3(s->hub_radius, s->hub_radius, s->hub_radius));
    if (s->hub == 2) dmg_box(b, at, v3(1.8f * s->hub_radius, 1.8f * s->hub_radius, 1.8f * s->hub_radius));
    if (s->hub == 3) dmg_rod(b, v3_sub(at, along), v3_add(at, along), 0.4f * s->hub_radius);
}

static void draw_link(dmg_builder* b, const link_style* s, dmg_vec from, dmg_vec to) {
    float t = s->thick;
    dmg_vec along = v3_normalize(v3_sub(to, from)), u, w;
    v3_basis(along, &u, &w);
    if (s->body == 0) dmg_rod(b, from, to, 0.8f * t);
    if (s->body == 1) dmg_beam(b, from, to, 1.4f * t, 1.6f * t);
    if (s->body == 2) dmg_cone(b, from, to, t, 0.6f * t);
    for (int i = -1; i <= 1 && s->body == 3; i += 2) {
        dmg_vec side = v3_scale(u, (float)i * 0.8f * t);
        dmg_beam(b, v3_add(from, side), v3_add(to, side), 0.3f * t, 1.4f * t);
    }
    if (s->body == 4) dmg_beam(b, v3_mad(from, along, -0.6f * t), v3_mad(to, along, 0.6f * t), 2 * t, 2 * t);
    if (s->body == 5) { /* bent */
        dmg_vec elbow = v3_mad(v3_lerp(from, to, 0.5f), u, t);
        const dmg_vec path[] = {from, elbow, to};
        dmg_sweep(b, path, 3, 0.7f * t, 0.9f * t, false);
    }
}

/* Draws a pedestal, a rail block or nothing below y = 0 … height. */
static void draw_pedestal(dmg_builder* b, float radius, float height) {
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), v3(0, height, 0), radius);
    if (kind == 1) dmg_box(b, v3(0, 0.5f * height, 0), v3(2 * radius, height, 2 * radius));
    if (kind == 2) dmg_cone(b, v3(0, 0, 0), v3(0, height, 0), 1.5f * radius, 0.8f * radius);
    if (kind == 3) {
        dmg_box(b, v3(0, 0.1f * height, 0), v3(4 * radius, 0.2f * height, 3 * radius));
        dmg_rod(b, v3(0, 0, 0), v3(0, height, 0), 0.8f * radius);
    }
}

/* ---- grippers: the palm's face is z = 0, the fingers reach to +Z and close towards x = 0 ---- */

typedef struct grip_style {
    int kind; /* 0 slide, 1 turn at the root, 2 turn with a tip that turns too */
    int fingers;
    float palm, length, thick, opened;
} grip_style;

static grip_style pick_grip(dmg_builder* b, float palm) {
    grip_style g = {.kind = dmg_int(b, 0, 2), .fingers = dmg_chance(b, 0.75f) ? 2 : 3, .palm = palm};
    g.length = palm * dmg_range(b, 0.5f, 1.8f);
    g.thick = palm * dmg_range(b, 0.08f, 0.22f);
    g.opened = dmg_range(b, 0.3f, 0.9f);
    return g;
}

/* Draws one finger at +X; the frame turns round for the others. */
static void draw_finger(dmg_builder* b, uint32_t palm, const grip_style* g, bool both_ways) {
    float x = 0.42f * g->palm, t = g->thick, mid = 0.5f * g->length, wide = 2 * t;
    if (g->kind == 0) {
        dmg_slide(b, palm, "finger", v3(-1, 0, 0), 0.0f, 0.9f * (x - t));
        dmg_box(b, v3(x, 0, 0.5f * g->length), v3(t, wide, g->length));
        dmg_box(b, v3(x - 0.4f * t, 0, 0.85f * g->length), v3(t, 0.8f * wide, 0.3f * g->length));
    } else {
        float in = atan2f(0.8f * x, g->length);
        uint32_t finger = dmg_hinge(b, palm, "finger", v3(x, 0, 0), v3(0, -1, 0), both_ways ? -g->opened : 0.0f,
                                    in + 0.3f * g->opened);
        dmg_rest(b, finger, both_ways ? 0.0f : dmg_range(b, 0, in));
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(x, -0.6f * wide, 0), v3(x, 0.6f * wide, 0), 0.7f * t);
        dmg_box(b, v3(x, 0, g->kind == 2 ? 0.5f * mid : mid), v3(t, wide, g->kind == 2 ? mid : g->length));
        if (g->kind == 2) {
            dmg_hinge(b, finger, "finger_tip", v3(x, 0, mid), v3(0, -1, 0), -0.6f, 0.8f);
            if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(x, -0.6f * wide, mid), v3(x, 0.6f * wide, mid), 0.6f * t);
            dmg_box(b, v3(x, 0, 1.5f * mid), v3(0.8f * t, 0.9f * wide, mid));
        }
    }
    dmg_use(b, palm);
}

static void draw_gripper(dmg_builder* b, uint32_t palm, const grip_style* g) {
    bool both_ways = dmg_chance(b, 0.5f);
    dmg_use(b, palm);
    if (dmg_chance(b, 0.6f))
        dmg_box(b, v3(0, 0, -0.3f * g->palm), v3(g->palm, 3 * g->thick, 0.6f * g->palm));
    else
        dmg_rod(b, v3(0, 0, -0.5f * g->palm), v3(0, 0, 0), 0.55f * g->palm);
    for (int i = 0; i < g->fingers; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, g->fingers);
        draw_finger(b, palm, g, both_ways);
        dmg_restore(b);
    }
}

void dmg_build_gripper(dmg_builder* b) {
    float palm = dmg_scale_range(b, 0.05f, 0.6f);
    grip_style g = pick_grip(b, palm);
    int mount = dmg_int(b, 0, 3);
    uint32_t carrier = 0;
    if (mount == 0) { /* rises on a post */
        float high = palm * dmg_range(b, 2.0f, 4.0f);
        dmg_box(b, v3(0, 0.5f * high, -0.75f * palm), v3(0.25f * palm, high, 0.25f * palm));
        dmg_box(b, v3(0, 0.05f * palm, -0.4f * palm), v3(1.5f * palm, 0.1f * palm, 1.5f * palm));
        dmg_move(b, 0, 0.6f * palm, 0);
        carrier = dmg_slide(b, 0, "riser", v3(0, 1, 0), 0.0f, high - 1.2f * palm);
    } else {
        dmg_move(b, 0, 0.8f * palm + (mount == 1 ? g.length : 0), 0);
        if (mount == 1) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* hanging */
        float length = palm * dmg_range(b, 0.5f, 2.0f), thick = palm * dmg_range(b, 0.15f, 0.4f);
        dmg_rod(b, v3(0, 0, -0.5f * palm - length), v3(0, 0, -0.5f * palm), thick);
        if (mount == 3) carrier = dmg_spin(b, 0, "wrist", v3(0, 0, -0.5f * palm), v3(0, 0, 1));
    }
    draw_gripper(b, carrier, &g);
    dmg_use(b, 0);
}

/* ---- arm ---- */

/* The pose an arm is shown in: link directions turn by these about the axes, in the state it is drawn in. */
void dmg_build_robot_arm(dmg_builder* b) {
    float reach = dmg_scale_range(b, 0.2f, 3.0f), thick = reach * dmg_range(b, 0.03f, 0.07f);
    link_style style = pick_links(b, thick);
    int links = dmg_int(b, 2, 5);
    float base = reach * dmg_range(b, 0.05f, 0.25f), swing = dmg_range(b, 0.6f, 1.8f);
    draw_pedestal(b, 1.6f * thick, base);
    dmg_move(b, 0, base, 0);
    uint32_t carrier = 0;
    bool flat = dmg_chance(b, 0.2f); /* all axes upright, as pick-and-place machines have */
    if (dmg_chance(b, 0.75f)) {
        carrier = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "waist", v3(0, 0, 0), v3(0, 1, 0))
                                      : dmg_hinge(b, 0, "waist", v3(0, 0, 0), v3(0, 1, 0), -2.8f, 2.8f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 1.6f * thick, 0), 1.5f * thick);
        dmg_move(b, 0, 2.6f * thick, 0);
    }
    dmg_vec at = {0, 0, 0};
    float lean = dmg_range(b, -0.3f, 0.5f);
    for (int i = 0; i < links; ++i) {
        dmg_vec axis = flat ? v3(0, 1, 0) : v3(1, 0, 0);
        float length = reach / (float)links * dmg_range(b, 0.7f, 1.3f), half = 1.3f * thick;
        dmg_vec along = flat ? v3(sinf(lean), 0, cosf(lean)) : v3(0, cosf(lean), sinf(lean));
        if (!flat && dmg_chance(b, 0.2f)) axis = along; /* this one rolls */
        dmg_use(b, carrier);
        draw_hub(b, &style, at, axis, half);
        dmg_vec to = v3_mad(at, along, length);
        if (flat) at.y += 1.2f * style.thick, to.y = at.y;
        carrier = dmg_hinge(b, carrier, "link", at, v3_scale(axis, dmg_sign(b)), -swing, swing);
        if (dmg_chance(b, 0.5f)) draw_hub(b, &style, at, axis, 0.8f * half);
        draw_link(b, &style, v3_mad(at, along, 0.3f * thick), to);
        at = to;
        lean += dmg_range(b, 0.0f, 1.3f);
    }
    if (dmg_chance(b, 0.6f)) {
        grip_style g = pick_grip(b, 3 * thick);
        dmg_vec along = flat ? v3(0, -1, 0) : v3(0, cosf(lean), sinf(lean));
        dmg_move(b, at.x, at.y, at.z);
        dmg_turn(b, v3(1, 0, 0), flat ? 0.5f * DMG_PI : atan2f(-along.y, along.z));
        dmg_move(b, 0, 0, 2 * thick);
        if (dmg_chance(b, 0.5f)) carrier = dmg_spin(b, carrier, "wrist", v3(0, 0, 0), v3(0, 0, 1));
        draw_gripper(b, carrier, &g);
    }
    dmg_use(b, 0);
}

/* ---- legs ---- */

/* Draws a leg from a hip at the origin, body towards -X: out, then thigh and shin. */
static void draw_leg(dmg_builder* b, const link_style* s, float thigh, float shin, float bend, bool out, bool motor) {
    uint32_t carrier = 0;
    float t = s->thick;
    if (out) {
        dmg_beam(b, v3(-6 * t, 0, 0), v3(-0.5f * t, 0, 0), 0.8f * t, 0.8f * t);
        carrier = dmg_hinge(b, 0, "hip", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -0.8f, 0.8f);
        draw_hub(b, s, v3(0, 0, 0), v3(0, 0, 1), 1.2f * t);
        dmg_box(b, v3(t, 0, 0), v3(2 * t, 1.2f * t, 1.2f * t));
    } else {
        dmg_rod(b, v3(-6 * t, 0, 0), v3(2 * t, 0, 0), motor ? 1.5f * t : 0.5f * t);
    }
    float x = out ? 2.2f * t : 2.0f * t;
    dmg_vec hip = {x, 0, 0}, knee = {x, -thigh * cosf(bend), -thigh * sinf(bend)},
            foot = {x, knee.y - shin * cosf(0.8f * bend), knee.z + shin * sinf(0.8f * bend)};
    bool endless = dmg_chance(b, 0.3f);
    carrier = endless ? dmg_spin(b, carrier, "thigh", hip, v3(1, 0, 0))
                      : dmg_hinge(b, carrier, "thigh", hip, v3(1, 0, 0), -1.2f, 1.2f);
    draw_hub(b, s, hip, v3(1, 0, 0), t);
    draw_link(b, s, hip, knee);
    dmg_hinge(b, carrier, "shin", knee, v3(-1, 0, 0), -0.7f, 1.2f);
    draw_hub(b, s, knee, v3(1, 0, 0), 0.8f * t);
    draw_link(b, s, knee, foot);
    if (dmg_chance(b, 0.6f)) dmg_ellipsoid(b, foot, v3(0.8f * t, 0.8f * t, 0.8f * t));
    dmg_use(b, 0);
}

void dmg_build_legged_robot(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.15f, 1.2f), width = length * dmg_range(b, 0.25f, 0.7f),
          high = length * dmg_range(b, 0.12f, 0.4f), thick = length * dmg_range(b, 0.025f, 0.06f);
    int pairs = dmg_int(b, 1, 3), shape = dmg_int(b, 0, 2);
    link_style style = pick_links(b, thick);
    float thigh = length * dmg_range(b, 0.25f, 0.6f), shin = thigh * dmg_range(b, 0.8f, 1.2f),
          bend = dmg_range(b, 0.2f, 0.9f);
    bool out = dmg_chance(b, 0.6f), motor = dmg_chance(b, 0.5f);
    dmg_move(b, 0, thigh + shin + 0.5f * high, 0);
    if (shape == 0) dmg_box(b, v3(0, 0, 0), v3(width, high, length));
    if (shape == 1) dmg_rounded_box(b, v3(0, 0, 0), v3(width, high, length), 0.3f * high);
    if (shape == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.55f * width, 0.55f * high, 0.55f * length));
    for (int i = 0; i < 2 * pairs; ++i) {
        dmg_save(b);
        float z = pairs == 1 ? 0.0f : 0.42f * length * (2.0f * (float)(i / 2) / (float)(pairs - 1) - 1.0f);
        if (i % 2) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.5f * width + 0.5f * thick, -0.2f * high, z);
        draw_leg(b, &style, thigh, shin, bend, out, motor);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.5f)) { /* a head that looks about */
        float size = width * dmg_range(b, 0.3f, 0.6f);
        bool nods = dmg_chance(b, 0.4f);
        dmg_vec neck = {0, 0.5f * high, 0.45f * length};
        dmg_hinge(b, 0, "head", neck, nods ? v3(1, 0, 0) : v3(0, 1, 0), -1.2f, 1.2f);
        dmg_rod(b, neck, v3_add(neck, v3(0, 0.3f * size, 0)), 0.15f * size);
        dmg_box(b, v3_add(neck, v3(0, 0.6f * size, 0.1f * size)), v3(size, 0.6f * size, 0.8f * size));
        dmg_use(b, 0);
    }
}

/* ---- pan and tilt ---- */

/* Draws what is aimed: looks to +Z, its middle at the origin. */
static void draw_aimed(dmg_builder* b, int kind, float size) {
    if (kind == 0) { /* camera */
        dmg_box(b, v3(0, 0, 0), v3(0.7f * size, 0.6f * size, size));
        dmg_rod(b, v3(0, 0, 0.4f * size), v3(0, 0, 0.75f * size), 0.22f * size);
    }
    if (kind == 1) { /* lamp */
        dmg_cone(b, v3(0, 0, -0.4f * size), v3(0, 0, 0.5f * size), 0.2f * size, 0.5f * size);
        dmg_rod(b, v3(0, 0, 0.5f * size), v3(0, 0, 0.55f * size), 0.52f * size);
    }
    if (kind == 2) { /* telescope or barrel */
        dmg_rod(b, v3(0, 0, -0.6f * size), v3(0, 0, 0.8f * size), 0.22f * size);
        dmg_rod(b, v3(0, 0, 0.7f * size), v3(0, 0, 1.4f * size), 0.12f * size);
    }
    if (kind == 3) { /* screen */
        dmg_rounded_plate(b, 1.8f * size, 1.1f * size, 0.12f * size, 0.05f * size);
        dmg_box(b, v3(0, 0, -0.15f * size), v3(0.5f * size, 0.4f * size, 0.15f * size));
    }
    if (kind == 4) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.5f * size, 0.5f * size, 0.5f * size));
    if (kind == 5) { /* a panel */
        dmg_box(b, v3(0, 0, 0), v3(2.2f * size, 1.4f * size, 0.06f * size));
        dmg_beam(b, v3(-size, 0, -0.06f * size), v3(size, 0, -0.06f * size), 0.1f * size, 0.1f * size);
    }
    if (kind == 6) { /* dish */
        const dmg_xy bowl[] = {{0, 0},
                               {0.5f * size, 0.1f * size},
                               {0.8f * size, 0.32f * size},
                               {0.5f * size, 0.14f * size},
                               {0, 0.03f * size}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), bowl, 5);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * size), 0.03f * size);
        dmg_box(b, v3(0, 0, 0.6f * size), v3(0.1f * size, 0.1f * size, 0.15f * size));
    }
}

/* Draws a fork that holds both sides, an arm that holds one, or a neck from below; up to y = arm, where the tilt axis
 * is. */
static void draw_yoke(dmg_builder* b, int kind, float half, float arm, float thick) {
    if (kind == 0) {
        dmg_box(b, v3(0, 0.5f * thick, 0), v3(2 * half + 2 * thick, thick, 2 * thick));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * (half + 0.5f * thick), 0.55f * arm, 0), v3(thick, 1.1f * arm, 2 * thick));
    }
    if (kind == 1) {
        dmg_box(b, v3(0.5f * half, 0.5f * thick, 0), v3(half + 2 * thick, thick, 2 * thick));
        dmg_box(b, v3(half + 0.5f * thick, 0.55f * arm, 0), v3(thick, 1.1f * arm, 2 * thick));
    }
    if (kind == 2) dmg_rod(b, v3(0, 0, 0), v3(0, arm, 0), 0.7f * thick);
    if (kind == 3) dmg_rounded_box(b, v3(0, 0.45f * arm, 0), v3(1.2f * half, 0.9f * arm, half), 0.2f * half);
}

void dmg_build_pan_tilt(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.03f, 1.5f), thick = size * dmg_range(b, 0.05f, 0.2f),
          arm = size * dmg_range(b, 0.65f, 1.2f), base = size * dmg_range(b, 0.1f, 2.5f),
          half = size * dmg_range(b, 0.36f, 0.6f);
    int aimed = dmg_int(b, 0, 6), yoke = dmg_int(b, 0, 3), foot = dmg_int(b, 0, 3);
    if (dmg_chance(b, 0.2f)) { /* hanging from a ceiling */
        dmg_move(b, 0, base + 2.5f * size, 0);
        dmg_mirror(b, v3(0, 1, 0));
    }
    if (foot == 3)
        for (int i = 0; i < 3; ++i) { /* tripod */
            float angle = 2.0f * DMG_PI * (float)i / 3.0f, out = 0.5f * base + 0.3f * size;
            dmg_rod(b, v3(out * cosf(angle), 0, out * sinf(angle)), v3(0, base, 0), 0.5f * thick);
        }
    else
        draw_pedestal(b, size * dmg_range(b, 0.15f, 0.5f), base);
    uint32_t pan = 0;
    int panning = dmg_int(b, 0, 3);
    if (panning == 1) pan = dmg_spin(b, 0, "pan", v3(0, 0, 0), v3(0, 1, 0));
    if (panning >= 2) pan = dmg_hinge(b, 0, "pan", v3(0, 0, 0), v3(0, 1, 0), -2.5f, 2.5f);
    dmg_move(b, 0, base, 0);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0, 0), v3(0, thick, 0), size * dmg_range(b, 0.15f, 0.4f));
    draw_yoke(b, yoke, half, arm, thick);
    dmg_move(b, 0, arm, 0);
    float up = dmg_range(b, 0.3f, 1.6f), down = dmg_range(b, 0.2f, 1.2f),
          behind = dmg_chance(b, 0.4f) ? size * dmg_range(b, 0.0f, 0.4f) : 0.0f;
    uint32_t tilt = pan;
    if (pan == 0 || dmg_chance(b, 0.85f)) tilt = dmg_hinge(b, pan, "tilt", v3(0, 0, 0), v3(1, 0, 0), -up, down);
    bool pins = dmg_chance(b, 0.6f);
    if (pins) dmg_rod(b, v3(yoke == 1 ? 0 : -half - 0.3f * thick, 0, 0), v3(half + 0.3f * thick, 0, 0), 0.5f * thick);
    if (tilt != pan && dmg_chance(b, 0.2f)) { /* a third, about the line of sight */
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.8f * half, 0.4f * thick);
        dmg_spin(b, tilt, "roll", v3(0, 0, 0), v3(0, 0, 1));
    }
    dmg_move(b, 0, yoke == 2 ? 0.3f * size : 0, behind);
    draw_aimed(b, aimed, fminf(size, 1.9f * half));
    dmg_use(b, 0);
}

/* ---- rails and pendulums ---- */

/* A load on a track, with something hanging from or standing on it. */
void dmg_build_rail(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.2f, 4.0f), size = length * dmg_range(b, 0.06f, 0.2f),
          bar = size * dmg_range(b, 0.08f, 0.3f);
    int kind = dmg_int(b, 0, 3), shape = dmg_int(b, 0, 2), rods = dmg_int(b, 1, 2);
    bool upright = dmg_chance(b, 0.3f);
    dmg_move(b, 0, upright ? 0.5f * length : length * dmg_range(b, 0.1f, 0.8f), 0);
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    float travel = length - 1.1f * size;
    uint32_t cart = 0;
    for (int i = 0; i < rods; ++i) {
        float z = rods == 1 ? 0.0f : ((float)i - 0.5f) * 0.6f * size;
        if (kind == 3)
            dmg_box(b, v3(0, -0.5f * size - 0.5f * bar, z), v3(length, bar, bar));
        else
            dmg_rod(b, v3(-0.5f * length, 0, z), v3(0.5f * length, 0, z), 0.5f * bar);
    }
    for (int s = -1; s <= 1 && dmg_chance(b, 0.7f); s += 2)
        dmg_box(b, v3((float)s * (0.5f * length + 0.1f * size), 0, 0), v3(0.2f * size, 1.3f * size, 1.3f * size));
    if (kind != 2) {
        cart = dmg_slide(b, 0, "carriage", v3(1, 0, 0), -0.5f * travel, 0.5f * travel);
        if (shape == 0) dmg_box(b, v3(0, 0, 0), v3(size, size, size));
        if (shape == 1) dmg_rod(b, v3(-0.5f * size, 0, 0), v3(0.5f * size, 0, 0), 0.5f * size);
        if (shape == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.6f * size, 0.5f * size, 0.5f * size));
        int rest = dmg_int(b, 0, 2);
        if (rest < 2) dmg_rest(b, cart, rest == 0 ? -0.5f * travel : travel * dmg_range(b, -0.5f, 0.5f));
    }
    if (kind == 1 || kind == 2) { /* a pendulum, perhaps double */
        float arm = length * dmg_range(b, 0.2f, 0.6f), thin = 0.25f * size, z = 0.5f * size + thin;
        uint32_t carrier = cart;
        dmg_vec at = {0, 0, kind == 1 ? z : 0};
        for (int i = dmg_int(b, 1, 2); i > 0; --i) {
            carrier = dmg_chance(b, 0.6f) ? dmg_spin(b, carrier, "pendulum", at, v3(0, 0, 1))
                                          : dmg_hinge(b, carrier, "pendulum", at, v3(0, 0, 1), -2.0f, 2.0f);
            dmg_rod(b, v3_add(at, v3(0, 0, -thin)), v3_add(at, v3(0, 0, thin)), 1.4f * thin);
            dmg_beam(b, at, v3_add(at, v3(0, -arm, 0)), thin, thin);
            at.y -= arm;
            if (dmg_chance(b, 0.5f)) dmg_ellipsoid(b, at, v3(1.6f * thin, 1.6f * thin, 1.6f * thin));
        }
    }
    dmg_use(b, 0);
}

/* ---- jetway ---- */

static void draw_tunnel(dmg_builder* b, int kind, float from, float to, float width, float height) {
    if (kind == 0)
        dmg_box_faces(b, v3(0, 0, 0.5f * (from + to)), v3(width, height, to - from),
                      DMG_FACE_ALL & ~(DMG_FACE_FRONT | DMG_FACE_BACK));
    if (kind == 1) dmg_box(b, v3(0, 0, 0.5f * (from + to)), v3(width, height, to - from));
    if (kind == 2) dmg_rounded_box(b, v3(0, 0, 0.5f * (from + to)), v3(width, height, to - from), 0.2f * height);
}

/* A bridge to aircraft: a round room that turns, tunnels that telescope and tip, a cab that turns at the end. */
void dmg_build_jetway(dmg_builder* b) {
    float width = dmg_range(b, 2.0f, 3.5f), height = width * dmg_range(b, 0.8f, 1.2f), floor = dmg_range(b, 2.5f, 5.0f),
          length = width * dmg_range(b, 3, 8);
    int tunnels = dmg_int(b, 1, 3), kind = dmg_int(b, 0, 2);
    dmg_rod(b, v3(0, 0, 0), v3(0, floor, 0), 0.3f * width);
    bool room_turns = dmg_chance(b, 0.7f);
    dmg_move(b, 0, floor, 0);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0.5f * height, -1.5f * width),
                v3(1.1f * width, 1.1f * height, 2 * width)); /* the terminal's end */
    uint32_t carrier = dmg_hinge(b, 0, "rotunda", v3(0, 0, 0), v3(0, 1, 0), -1.2f, 1.2f);
    if (!room_turns) dmg_use(b, 0);
    dmg_rod(b, v3(0, -0.1f * height, 0), v3(0, 1.2f * height, 0), 0.8f * width);
    dmg_use(b, carrier);
    dmg_move(b, 0, 0.5f * height, 0.6f * width);
    if (!room_turns) dmg_box(b, v3(0, 0, 0.2f * width), v3(width, height, 0.6f * width));
    if (dmg_chance(b, 0.7f))
        carrier = dmg_hinge(b, carrier, "slope", v3(0, -0.4f * height, 0), v3(-1, 0, 0), -0.15f, 0.15f);
    float grow = 1.0f, at = 0.0f, end = 0.0f;
    for (int i = 0; i < tunnels; ++i) {
        if (i > 0) carrier = dmg_slide(b, carrier, "tunnel", v3(0, 0, 1), 0.0f, 0.7f * length);
        end = at + length;
        draw_tunnel(b, kind, at, end, grow * width, grow * height);
        grow *= dmg_chance(b, 0.5f) ? 0.9f : 1.0f / 0.9f;
        at += length * dmg_range(b, 0.15f, 0.6f);
    }
    dmg_move(b, 0, 0, end);
    if (dmg_chance(b, 0.7f)) { /* legs with wheels under the last tunnel */
        float drop = floor + 0.5f * height - 0.3f;
        for (int s = -1; s <= 1; s += 2) {
            dmg_box(b, v3((float)s * 0.6f * width, -0.5f * drop, -0.3f * length),
                    v3(0.15f * width, drop, 0.15f * width));
            dmg_rod(b, v3((float)s * 0.6f * width - 0.15f, -drop, -0.3f * length),
                    v3((float)s * 0.6f * width + 0.15f, -drop, -0.3f * length), 0.3f);
        }
    }
    if (dmg_chance(b, 0.8f)) {
        carrier = dmg_hinge(b, carrier, "cab", v3(0, 0, 0.3f * width), v3(0, 1, 0), -1.0f, 1.0f);
        dmg_rod(b, v3(0, -0.55f * height, 0.3f * width), v3(0, 0.55f * height, 0.3f * width), 0.65f * width);
        if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0, width), v3(1.1f * width, 1.1f * height, 0.6f * width));
        if (dmg_chance(b, 0.4f)) {
            dmg_hinge(b, carrier, "hood", v3(0, 0.5f * height, 0.9f * width), v3(-1, 0, 0), 0.0f, 0.4f);
            dmg_box(b, v3(0, 0.55f * height, 1.4f * width), v3(1.1f * width, 0.08f * height, width));
        }
    }
    dmg_use(b, 0);
}

/* ---- crane ---- */

/* Diggers, cranes and turrets: a house that turns on tracks or a mast, booms one after another. */
void dmg_build_crane(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.1f, 4.0f), thick = size * dmg_range(b, 0.08f, 0.2f),
          high = size * dmg_range(b, 0.3f, 0.6f);
    int base = dmg_int(b, 0, 2), booms = dmg_int(b, 1, 3);
    float top = base == 2 ? size * dmg_range(b, 1.0f, 4.0f) : 0.5f * size;
    if (base == 0)
        for (int s = -1; s <= 1; s += 2)
            dmg_rounded_box(b, v3((float)s * 0.6f * size, 0.25f * size, 0), v3(0.35f * size, 0.5f * size, 2 * size),
                            0.2f * size);
    if (base == 0) dmg_box(b, v3(0, 0.35f * size, 0), v3(size, 0.25f * size, 1.2f * size));
    if (base == 1) dmg_box(b, v3(0, 0.25f * size, 0), v3(1.2f * size, 0.5f * size, 2.2f * size));
    if (base == 2) dmg_box(b, v3(0, 0.5f * top, 0), v3(0.4f * size, top, 0.4f * size));
    dmg_move(b, 0, top, 0);
    uint32_t carrier = dmg_chance(b, 0.8f) ? dmg_spin(b, 0, "house", v3(0, 0, 0), v3(0, 1, 0)) : 0;
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.08f * size, 0), 0.45f * size);
    dmg_box(b, v3(0, 0.08f * size + 0.5f * high, -0.2f * size), v3(size, high, 1.4f * size));
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0.3f * size, 0.08f * size + high, 0.2f * size), v3(0.4f * size, 0.9f * high, 0.5f * size));
    link_style style = pick_links(b, thick);
    dmg_vec at = {-0.1f * size, 0.5f * high, 0.5f * size};
    float lean = dmg_range(b, 0.3f, 1.3f);
    for (int i = 0; i < booms; ++i) {
        float length = size * dmg_range(b, 0.8f, 2.2f) / (1.0f + 0.3f * (float)i);
        dmg_vec along = {0, sinf(lean), cosf(lean)}, to = v3_mad(at, along, length);
        if (i > 0 && dmg_chance(b, 0.2f)) { /* telescopes */
            carrier = dmg_slide(b, carrier, "boom", along, 0.0f, 0.7f * length);
            dmg_beam(b, v3_mad(at, along, -0.8f * length), v3_mad(at, along, 0.2f * length), 0.9f * thick,
                     0.9f * thick);
            at = v3_mad(at, along, 0.2f * length);
            continue;
        }
        carrier = dmg_hinge(b, carrier, "boom", at, v3(dmg_sign(b), 0, 0), -0.6f, 0.6f);
        draw_hub(b, &style, at, v3(1, 0, 0), 1.2f * thick);
        draw_link(b, &style, at, to);
        at = to;
        lean -= dmg_range(b, 0.3f, 1.6f);
    }
    if (dmg_chance(b, 0.6f)) { /* a bucket */
        dmg_hinge(b, carrier, "bucket", at, v3(dmg_sign(b), 0, 0), -1.0f, 1.0f);
        dmg_save(b);
        dmg_move(b, at.x, at.y, at.z);
        const dmg_xy side[] = {{0, 0},
                               {0.15f * size, -0.5f * size},
                               {0.45f * size, -0.55f * size},
                               {0.2f * size, -0.45f * size},
                               {0.1f * size, 0}};
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, side, 5, -0.35f * size, 0.35f * size);
        dmg_restore(b);
    } else if (dmg_chance(b, 0.5f)) { /* a hook on a rope */
        dmg_use(b, carrier);
        dmg_rod(b, v3_add(at, v3(0, -1.4f * size, 0)), at, 0.015f * size);
        dmg_slide(b, carrier, "hook", v3(0, -1, 0), 0.0f, 0.8f * size);
        dmg_box(b, v3_add(at, v3(0, -0.55f * size, 0)), v3(0.15f * size, 0.2f * size, 0.1f * size));
    }
    dmg_use(b, 0);
}
