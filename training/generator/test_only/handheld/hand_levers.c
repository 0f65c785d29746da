/* Draws tools that a hand squeezes: grip trainers, pruning shears, staple guns, spray bottles, hose nozzles, glue
 * guns, a brake lever between seats. Forward is +Z; levers are bent shells on pins inside the body. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

static dmg_bent pick_arm(dmg_builder* b, dmg_vec from, dmg_vec to, dmg_vec bow, float wide, float deep) {
    dmg_bent n = dmg_bent_between(from, to, bow, v3(1, 0, 0), wide, deep);
    n.wide[1] *= dmg_range(b, 0.8f, 1.2f);
    n.deep[1] *= dmg_range(b, 0.8f, 1.2f);
    n.wide[2] *= dmg_range(b, 0.7f, 1.1f);
    n.power = dmg_range(b, 2.0f, 3.5f);
    n.round[0] = n.round[1] = 0.1f;
    n.columns = 14;
    return n;
}

/* Draws two handles that part from a coil at the top; one has a dial for the spring. */
static void draw_trainer(dmg_builder* b, float l) {
    float spread = l * dmg_range(b, 0.25f, 0.4f), r = l * dmg_range(b, 0.07f, 0.1f),
          coil = l * dmg_range(b, 0.09f, 0.14f), bow = l * dmg_range(b, -0.05f, 0.15f);
    int turns = dmg_int(b, 2, 4);
    bool dial = dmg_chance(b, 0.4f);
    for (int i = 0; i < turns; ++i)
        dmg_torus(b, v3(0.06f * l * ((float)i - 0.5f * (float)turns), l, 0), v3(1, 0, 0), coil, 0.03f * l);
    for (int s = -1; s <= 1; s += 2) {
        if (s > 0) dmg_hinge(b, 0, "handle", v3(0, l, 0), v3(1, 0, 0), 0.0f, 0.7f * atanf(2 * spread / l));
        float z = (float)s * spread;
        dmg_rod(b, v3(0, l, (float)s * coil), v3(0, 0.6f * l, 0.5f * z + (float)s * 0.6f * coil), 0.03f * l);
        dmg_bent n = pick_arm(b, v3(0, 0.68f * l, 0.45f * z + (float)s * 0.6f * coil), v3(0, 0, z),
                              v3(0, 0, (float)s * bow), r, r);
        dmg_bent_draw(b, &n);
        dmg_use(b, 0);
    }
    if (!dial) return;
    dmg_spin(b, 0, "dial", v3(0, l, 0), v3(1, 0, 0));
    dmg_rod(b, v3(-0.1f * l, l, 0), v3(0.1f * l, l, 0), 0.5f * coil);
    dmg_rod(b, v3(0.1f * l, l, 0), v3(0.16f * l, l, 0), 0.9f * coil);
    dmg_use(b, 0);
}

/* Handles to -Z, blades to +Z, all about one bolt along X; a catch at the handles' end or at the bolt. */
static void draw_shears(dmg_builder* b, float l) {
    float swing = dmg_range(b, 0.25f, 0.45f), t = 0.025f * l, blade = l * dmg_range(b, 0.35f, 0.5f), r = 0.05f * l;
    bool end = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 0.5f * l, 0);
    for (int s = -1; s <= 1; s += 2) {
        if (s > 0) dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(1, 0, 0), 0.0f, swing);
        float up = (float)s;
        dmg_bent n = pick_arm(b, v3(0, -0.1f * up * r, -0.05f * l), v3(0, up * 0.1f * l, -l), v3(0, up * 0.12f * l, 0),
                              0.6f * r, r);
        dmg_bent_draw(b, &n);
        const dmg_xy edge[] = {{-0.1f * l, -0.06f * l},
                               {0.5f * blade, -0.1f * l},
                               {blade, 0},
                               {0.5f * blade, 0.005f * l},
                               {-0.1f * l, 0.06f * l}};
        dmg_aim(b, v3(up * 0.55f * t, 0, 0), v3(up, 0, 0), v3(0, up, 0));
        dmg_mirror(b, v3(1, 0, 0));
        if (s > 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_extrude(b, edge, 5, -0.5f * t, 0.5f * t);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_rod(b, v3(-2 * t, 0, 0), v3(2 * t, 0, 0), 0.8f * r);
    dmg_vec pin = end ? v3(0, -0.1f * l, -1.0f * l) : v3(0.6f * r + t, -0.1f * r, -0.1f * l);
    dmg_hinge(b, 0, "catch", pin, v3(1, 0, 0), 0.0f, end ? 1.2f : 0.8f);
    dmg_rod(b, v3_mad(pin, v3(1, 0, 0), -0.7f * t), v3_mad(pin, v3(1, 0, 0), 0.7f * t), 0.5f * r);
    dmg_beam(b, pin, v3_add(pin, end ? v3(0, 0.2f * l, -0.02f * l) : v3(0, 0.02f * l, 0.12f * l)), t, 0.4f * r);
    dmg_use(b, 0);
}

/* Draws a long smooth body, the lever on top, hung ahead or behind; staples in a drawer below. */
static void draw_staple_gun(dmg_builder* b, float l) {
    float high = l * dmg_range(b, 0.3f, 0.4f), w = l * dmg_range(b, 0.06f, 0.09f), rise = dmg_range(b, 0.25f, 0.5f);
    bool front = dmg_chance(b, 0.5f), drawer = dmg_chance(b, 0.7f), lock = dmg_chance(b, 0.5f);
    dmg_bent n = dmg_bent_between(v3(0, 0.55f * high, -0.5f * l), v3(0, 0.55f * high, 0.5f * l), v3(0, 0.1f * high, 0),
                                  v3(-1, 0, 0), w, 0.2f * high);
    n.deep[2] = 0.5f * high;
    n.power = dmg_range(b, 2.5f, 4.0f);
    dmg_bent_draw(b, &n);
    dmg_box_span(b, v3(-0.6f * w, 0.05f * high, 0.3f * l), v3(0.6f * w, 0.6f * high, 0.49f * l));
    dmg_box_span(b, v3(-0.7f * w, 0.1f * high, -0.4f * l), v3(0.7f * w, 0.3f * high, 0.3f * l));
    dmg_box_span(b, v3(-0.5f * w, 0.2f * high, -0.4f * l), v3(0.5f * w, 0.6f * high, -0.3f * l));
    float z = front ? 0.34f * l : -0.42f * l, far = front ? -0.45f * l : 0.42f * l, y = high;
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.75f * w, y - 0.15f * high, z), v3(0.3f * w, 0.5f * high, 0.1f * l));
    uint32_t lever = dmg_hinge(b, 0, "lever", v3(0, y, z), v3(front ? -1.0f : 1.0f, 0, 0), 0.0f, 0.6f * rise);
    dmg_bent arm = pick_arm(b, v3(0, y, z), v3(0, y + fabsf(far - z) * sinf(rise), far), v3(0, 0.05f * l, 0), 0.55f * w,
                            0.08f * high);
    dmg_bent_draw(b, &arm);
    if (lock) {
        dmg_hinge(b, lever, "lock", arm.control[3], v3(1, 0, 0), 0.0f, 1.5f);
        dmg_beam(b, arm.control[3], v3_add(arm.control[3], v3(0, -0.3f * high, 0)), 1.4f * w, 0.06f * high);
    }
    dmg_use(b, 0);
    if (!drawer) return;
    dmg_slide(b, 0, "magazine", v3(0, 0, -1), 0.0f, l * dmg_range(b, 0.3f, 0.6f));
    dmg_box_span(b, v3(-0.4f * w, 0.14f * high, -0.44f * l), v3(0.4f * w, 0.26f * high, 0.28f * l));
    dmg_box_span(b, v3(-0.7f * w, 0.05f * high, -0.47f * l), v3(0.7f * w, 0.35f * high, -0.42f * l));
    dmg_use(b, 0);
}

/* Draws a bottle; on its screwed collar a beaked head with a trigger before the neck. */
static void draw_sprayer(dmg_builder* b, float l) {
    float r = l * dmg_range(b, 0.18f, 0.28f), neck = l * dmg_range(b, 0.07f, 0.1f), w = neck * dmg_range(b, 0.9f, 1.3f),
          y = 0.78f * l, waist = r * dmg_range(b, 0.75f, 1.05f);
    const dmg_xy bottle[] = {{0, 0},           {0.95f * r, 0}, {r, 0.04f * l}, {waist, 0.4f * l}, {0.8f * r, 0.58f * l},
                             {neck, 0.7f * l}, {neck, y},      {0, y}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bottle, 8);
    float head = l * dmg_range(b, 0.22f, 0.32f), deep = l * dmg_range(b, 0.06f, 0.09f);
    dmg_screw(b, 0, "collar", v3(0, 0, 0), v3(0, 1, 0), 0.0008f, 0.0f, 9.0f);
    dmg_rod(b, v3(0, 0.71f * l, 0), v3(0, y + 0.01f * l, 0), 1.25f * neck);
    dmg_use(b, 0);
    dmg_bent n = dmg_bent_between(v3(0, 0.92f * l, -0.55f * head), v3(0, 0.93f * l, 0.75f * head), v3(0, 0.05f * l, 0),
                                  v3(-1, 0, 0), w, deep);
    n.deep[2] *= dmg_range(b, 0.5f, 0.9f);
    n.power = dmg_range(b, 2.0f, 3.5f);
    dmg_bent_open(&n, 0.6f, 1.5f * DMG_PI, 0.2f, 0.9f, 0.5f * deep);
    dmg_bent_draw(b, &n);
    dmg_rod(b, v3(0, y, 0), v3(0, 0.9f * l, -0.05f * head), 0.8f * neck);
    dmg_save(b);
    dmg_move(b, 0, 0.9f * l, 0.35f * head);
    dmg_turn(b, v3(1, 0, 0), dmg_range(b, -0.5f, -0.1f));
    dmg_finger_lever_draw(b, 0, "trigger", 1.2f * w, l * dmg_range(b, 0.16f, 0.24f));
    dmg_restore(b);
    dmg_spin(b, 0, "nozzle", v3(0, 0.93f * l, 0), v3(0, 0, 1));
    dmg_rounded_box(b, v3(0, 0.93f * l, 0.8f * head), v3(1.3f * deep, 1.3f * deep, 0.2f * head), 0.2f * deep);
    dmg_use(b, 0);
}

/* Draws a bent barrel: the lever before or behind the grip, a head that turns, a ring that keeps it open. */
static void draw_gun_nozzle(dmg_builder* b, float l, bool glue) {
    float w = l * dmg_range(b, 0.09f, 0.13f), down = l * dmg_range(b, 0.55f, 0.8f),
          lean = l * dmg_range(b, 0.15f, 0.4f), reach = l * dmg_range(b, 0.28f, 0.4f);
    bool rear = !glue && dmg_chance(b, 0.5f), slides = glue && dmg_chance(b, 0.4f);
    dmg_move(b, 0, down, 0);
    dmg_bent barrel =
        dmg_bent_between(v3(0, 0, -0.4f * l), v3(0, 0, 0.55f * l), v3(0, 0.04f * l, 0), v3(-1, 0, 0), w, 1.15f * w);
    barrel.wide[2] *= 0.6f;
    barrel.deep[2] *= 0.6f;
    barrel.power = dmg_range(b, 2.0f, 3.5f);
    barrel.rows = 26;
    dmg_bent_draw(b, &barrel);
    dmg_bent grip = dmg_bent_between(v3(0, -down, -0.2f * l - lean), v3(0, 0, -0.2f * l), v3(0, 0, -0.05f * l),
                                     v3(1, 0, 0), 0.85f * w, w);
    grip.egg = dmg_range(b, 0.0f, 0.25f);
    grip.rows = 24;
    dmg_window back = {0};
    float s = dmg_range(b, 0.55f, 0.65f);
    if (rear) back = dmg_bent_open(&grip, s, 1.5f * DMG_PI, 0.5f, 1.0f, 0.5f * w);
    if (!rear) dmg_bent_open(&grip, s + 0.1f, 0.5f * DMG_PI, 0.3f, 0.8f, 0.5f * w);
    dmg_bent_draw(b, &grip);
    if (rear) dmg_bent_key_draw(b, &grip, &back, 0, "lever", DMG_KEY_LAST);
    if (!rear) {
        dmg_bent_stand(b, &grip, s + 0.2f, 0.5f * DMG_PI, 0);
        if (slides) {
            dmg_slide(b, 0, "trigger", v3(0, 0, -1), 0.0f, 0.4f * w);
            dmg_rounded_box(b, v3(0, -0.1f * l, 0.3f * w), v3(1.0f * w, reach * 0.6f, 1.4f * w), 0.3f * w);
            dmg_use(b, 0);
        } else
            dmg_finger_lever_draw(b, 0, "trigger", 1.1f * w, reach);
        dmg_restore(b);
    }
    float z = 0.52f * l;
    if (!glue) {
        dmg_spin(b, 0, "spray_head", v3(0, 0, 0), v3(0, 0, 1));
        dmg_cone(b, v3(0, 0, z), v3(0, 0, z + 0.14f * l), 0.7f * w, 1.3f * w);
        dmg_rod(b, v3(0, 0, z + 0.14f * l), v3(0, 0, z + 0.17f * l), 1.4f * w);
        dmg_use(b, 0);
        return;
    }
    dmg_cone(b, v3(0, 0, z), v3(0, 0, z + 0.15f * l), 0.5f * w, 0.12f * w);
    dmg_slide(b, 0, "glue_stick", v3(0, 0, -1), 0.0f, 0.18f * l); /* drawn back out */
    dmg_rod(b, v3(0, 0, -0.75f * l), v3(0, 0, -0.2f * l), 0.35f * w);
    dmg_hinge(b, 0, "stand", v3(0, -0.6f * w, 0.4f * l), v3(-1, 0, 0), 0.0f, 1.4f);
    const dmg_vec wire[] = {{-0.7f * w, -0.6f * w, 0.4f * l},
                            {-0.7f * w, -0.9f * w, 0},
                            {0.7f * w, -0.9f * w, 0},
                            {0.7f * w, -0.6f * w, 0.4f * l}};
    dmg_sweep(b, wire, 4, 0.06f * w, 0.06f * w, false);
    dmg_rod(b, v3(-0.7f * w, -0.6f * w, 0.4f * l), v3(0.7f * w, -0.6f * w, 0.4f * l), 0.06f * w);
    dmg_use(b, 0);
}

/* Out of a boot between the seats: a bent lever on a pin under it, a button in its end. */
static void draw_park_brake(dmg_builder* b, float l) {
    float high = l * dmg_range(b, 0.25f, 0.4f), r = l * dmg_range(b, 0.06f, 0.09f), swing = dmg_range(b, 0.4f, 0.9f),
          tilt = dmg_range(b, 0.05f, 0.3f);
    dmg_bent n = dmg_bent_between(v3(0, 0.25f * high, -0.6f * l), v3(0, 0.25f * high, 0.7f * l), v3(0, 0.1f * high, 0),
                                  v3(-1, 0, 0), 0.22f * l, 0.5f * high);
    n.power = dmg_range(b, 2.5f, 4.0f);
    n.rows = 30;
    n.columns = 24;
    dmg_bent_open(&n, 0.42f, 0.5f * DMG_PI, 0.34f, 0.5f, 0.35f * high);
    dmg_bent_draw(b, &n);
    dmg_vec pin = v3(0, 0.5f * high, -0.2f * l), tip = v3(0, pin.y + l * (sinf(tilt) + 0.2f), pin.z + l * cosf(tilt));
    uint32_t lever = dmg_hinge(b, 0, "hand_brake", pin, v3(-1, 0, 0), 0.0f, swing);
    dmg_bent arm = dmg_bent_between(pin, tip, v3(0, 0.08f * l, 0), v3(-1, 0, 0), 0.7f * r, 0.7f * r);
    arm.control[1] = v3(0, pin.y + 0.35f * l, pin.z + 0.25f * l);
    arm.wide[2] = arm.deep[2] = r;
    arm.round[0] = arm.round[1] = 0.06f;
    dmg_bent_draw(b, &arm);
    dmg_vec line = v3_normalize(v3_sub(tip, arm.control[2]));
    dmg_slide(b, lever, "release", v3_scale(line, -1), 0.0f, 0.5f * r);
    dmg_capsule(b, v3_mad(tip, line, -0.5f * r), v3_mad(tip, line, 0.5f * r), 0.45f * r);
    dmg_use(b, 0);
}

void dmg_build_hand_exerciser(dmg_builder* b) {
    int kind = dmg_int(b, 0, 6);
    float l = dmg_range(b, 0.12f, 0.22f), skew = dmg_range(b, -0.4f, 0.4f), lean = dmg_range(b, -0.5f, 0.5f);
    dmg_move(b, 0, 0.3f * l, 0);
    dmg_turn(b, v3(0, 1, 0), skew);
    dmg_turn(b, v3(1, 0, 0), lean);
    if (kind == 0) draw_trainer(b, l);
    if (kind == 1) draw_shears(b, l);
    if (kind == 2) draw_staple_gun(b, l);
    if (kind == 3) draw_sprayer(b, 1.3f * l);
    if (kind == 4 || kind == 5) draw_gun_nozzle(b, l, kind == 5);
    if (kind == 6) draw_park_brake(b, 1.4f * l);
}
