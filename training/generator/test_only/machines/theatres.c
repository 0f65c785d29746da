/* Draws operating-room equipment: x-ray machines with a C-shaped arm or a tube on ceiling rails, lamps on linked
 * arms. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a fork on a stem that turns, a wheel in it; the stem's top is at the origin, the ground `high` below. */
static void draw_caster(dmg_builder* b, float high) {
    float r = 0.36f * high, w = 0.3f * r;
    uint32_t fork = dmg_spin(b, 0, "caster", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, -0.12f * high, 0), v3(0, 0, 0), 0.5f * r);
    dmg_box_span(b, v3(-0.4f * r, -0.2f * high, -0.5f * r), v3(0.4f * r, -0.1f * high, 0.9f * r));
    dmg_box_span(b, v3(w, -0.7f * high, 0.2f * r), v3(1.4f * w, -0.15f * high, 0.8f * r));
    dmg_spin(b, fork, "wheel", v3(0, r - high, 0.5f * r), v3(1, 0, 0));
    dmg_rod(b, v3(-w, r - high, 0.5f * r), v3(0.9f * w, r - high, 0.5f * r), r);
    dmg_use(b, 0);
}

static void draw_casters(dmg_builder* b, float half_x, float z0, float z1, float high) {
    for (int i = 0; i < 4; ++i) {
        dmg_save(b);
        dmg_move(b, i & 1 ? half_x : -half_x, high, i & 2 ? z0 : z1);
        draw_caster(b, high);
        dmg_restore(b);
    }
}

/* ---- an arm like a C in the plane x = 0 about the origin, open to +Z ---- */

static void draw_c(dmg_builder* b, float r, float t) {
    enum { POINTS = 17 };
    dmg_vec path[POINTS];
    float over = dmg_range(b, 0.0f, 0.25f), tube = r * dmg_range(b, 0.16f, 0.24f),
          face = r * dmg_range(b, 0.16f, 0.28f);
    bool flat = dmg_chance(b, 0.4f), turned = dmg_chance(b, 0.25f);
    for (int i = 0; i < POINTS; ++i) {
        float angle = 0.5f * DMG_PI - over + (DMG_PI + 2 * over) * (float)i / (float)(POINTS - 1);
        path[i] = v3(0, r * sinf(angle), r * cosf(angle));
    }
    dmg_sweep(b, path, POINTS, t, 0.7f * t, false);
    dmg_vec top = path[0], low = path[POINTS - 1];
    if (turned) { /* the source above */
        top = path[POINTS - 1];
        low = path[0];
    }
    float up = turned ? -1.0f : 1.0f;
    dmg_save(b);
    dmg_move(b, 0, top.y, top.z);
    if (flat)
        dmg_box(b, v3(0, -0.25f * up * r, 0), v3(1.6f * face, 0.14f * r, 1.6f * face));
    else
        dmg_cone(b, v3(0, 0.1f * up * r, 0), v3(0, -0.34f * up * r, 0), 0.7f * face, face);
    dmg_rod(b, v3(0, -0.25f * up * r, 0), v3(0, 0.12f * up * r, 0), 0.4f * face);
    dmg_restore(b);
    dmg_rounded_box(b, v3(0, low.y, low.z), v3(2 * tube, 1.6f * tube, 2 * tube), 0.2f * tube);
    dmg_cone(b, v3(0, low.y + 0.7f * up * tube, low.z), v3(0, low.y + 1.5f * up * tube, low.z), 0.7f * tube,
             0.5f * tube);
    if (dmg_chance(b, 0.4f)) dmg_torus(b, v3(t, 0.7f * r, -0.75f * r), v3(0, 0, 1), 0.1f * r, 0.015f * r);
}

/* On a trolley: column up, boom to and fro and aside, the C tipped about the boom and run through its holder. */
static void draw_mobile_c(dmg_builder* b) {
    float r = dmg_range(b, 0.55f, 0.85f), t = r * dmg_range(b, 0.05f, 0.1f), clear = dmg_range(b, 0.25f, 0.45f),
          y = r + clear, wheel = 0.14f, way = dmg_range(b, 0.25f, 0.45f), run = dmg_range(b, 0.6f, 1.2f),
          col = r * dmg_range(b, 0.1f, 0.18f), half = dmg_range(b, 0.22f, 0.32f);
    bool aside = dmg_chance(b, 0.7f), reaches = dmg_chance(b, 0.7f), panel = dmg_chance(b, 0.6f);
    float back = -r - dmg_range(b, 0.4f, 0.6f);
    dmg_rounded_box(b, v3(0, wheel + 0.16f, back), v3(1.8f * half, 0.3f, 0.5f), 0.04f);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * half, wheel + 0.05f, back - 0.25f), v3((float)s * half, wheel + 0.05f, -0.45f * r),
                 0.08f, 0.09f);
    dmg_box(b, v3(0, wheel + 0.05f, back), v3(2 * half, 0.09f, 0.3f));
    draw_casters(b, half, back - 0.2f, -0.5f * r, wheel + 0.005f);
    dmg_box_span(b, v3(-col, wheel + 0.3f, back - col), v3(col, y - 0.12f, back + col));
    uint32_t part = dmg_slide(b, 0, "column", v3(0, 1, 0), 0.0f, way);
    dmg_box_span(b, v3(-0.75f * col, y - 0.5f, back - 0.75f * col), v3(0.75f * col, y - 0.06f, back + 0.75f * col));
    if (aside) part = dmg_hinge(b, part, "wigwag", v3(0, y, back), v3(0, dmg_sign(b), 0), -0.22f, 0.22f);
    dmg_box(b, v3(0, y, back), v3(2.2f * col, 0.115f, 2.6f * col));
    if (reaches) part = dmg_slide(b, part, "boom", v3(0, 0, 1), 0.0f, 0.2f);
    dmg_rod(b, v3(0, y, back - 1.4f * col), v3(0, y, -r - 0.19f), 0.045f);
    part = dmg_hinge(b, part, "tilt", v3(0, y, 0), v3(0, 0, dmg_sign(b)), -3.1f, 3.1f);
    dmg_rod(b, v3(0, y, -r - 0.18f), v3(0, y, -r - 0.09f), 0.1f);
    for (int s = -1; s <= 1; s += 2) /* the holder on both sides of the C */
        dmg_box(b, v3((float)s * (t + 0.025f), y, -r - 0.03f), v3(0.03f, 0.3f, 0.16f));
    dmg_box(b, v3(0, y, -r - t - 0.035f), v3(2 * t + 0.04f, 0.26f, 0.03f));
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    uint32_t c = dmg_hinge(b, part, "orbit", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -0.5f * run, 0.9f * run);
    dmg_rest(b, c, dmg_chance(b, 0.5f) ? 0.0f : 0.3f * run);
    draw_c(b, r, t);
    dmg_restore(b);
    dmg_use(b, 0);
    if (!panel) return;
    float top = wheel + 0.3f, x = 0.75f * half;
    dmg_rod(b, v3(x, top - 0.02f, back - 0.1f), v3(x, top + 0.53f, back - 0.1f), 0.02f);
    part = dmg_spin(b, 0, "monitor_arm", v3(x, top + 0.5f, back - 0.1f), v3(0, 1, 0));
    dmg_rod(b, v3(x, top + 0.5f, back - 0.1f), v3(x, top + 0.56f, back - 0.1f), 0.03f);
    dmg_hinge(b, part, "monitor", v3(x, top + 0.6f, back - 0.1f), v3(1, 0, 0), -0.5f, 0.5f);
    dmg_box(b, v3(x, top + 0.72f, back - 0.12f), v3(0.36f, 0.26f, 0.04f));
    dmg_rod(b, v3(x - 0.06f, top + 0.6f, back - 0.1f), v3(x + 0.06f, top + 0.6f, back - 0.1f), 0.02f);
}

/* Draws a table whose top floats: lifted, run lengthwise and across. */
static void draw_patient_table(dmg_builder* b, float z) {
    float high = dmg_range(b, 0.7f, 0.95f), wide = dmg_range(b, 0.5f, 0.7f), length = dmg_range(b, 1.8f, 2.2f);
    bool tilts = dmg_chance(b, 0.5f);
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    dmg_box_span(b, v3(-0.5f, 0, -0.25f), v3(0.3f, 0.08f, 0.25f));
    dmg_box_span(b, v3(-0.3f, 0.08f, -0.18f), v3(0.1f, 0.6f * high, 0.18f));
    uint32_t part = dmg_slide(b, 0, "table_lift", v3(0, 1, 0), 0.0f, 0.25f);
    dmg_box_span(b, v3(-0.26f, 0.4f * high, -0.15f), v3(0.06f, high - 0.14f, 0.15f));
    if (tilts) part = dmg_hinge(b, part, "table_tilt", v3(-0.1f, high - 0.1f, 0), v3(0, 0, dmg_sign(b)), -0.25f, 0.25f);
    dmg_box_span(b, v3(-0.4f, high - 0.138f, -0.2f), v3(0.2f, high - 0.07f, 0.2f));
    part = dmg_slide(b, part, "table_cross", v3(0, 0, 1), -0.1f, 0.1f);
    dmg_box_span(b, v3(-0.45f, high - 0.068f, -0.4f * wide), v3(0.25f, high - 0.042f, 0.4f * wide));
    dmg_slide(b, part, "table_top", v3(1, 0, 0), -0.3f, 0.3f);
    dmg_rounded_box(b, v3(0, high - 0.02f, 0), v3(length, 0.04f, wide), 0.015f);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a tube that hangs from a carriage on rails, its column in lengths one in another. */
static void draw_ceiling_tube(dmg_builder* b) {
    float span = dmg_range(b, 1.6f, 3.0f), deep = dmg_range(b, 1.4f, 2.4f), high = dmg_range(b, 2.4f, 2.9f),
          col = dmg_range(b, 0.07f, 0.12f), each = dmg_range(b, 0.25f, 0.38f);
    int stages = dmg_int(b, 2, 4);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, high + 0.04f, (float)s * 0.5f * deep), v3(span, 0.08f, 0.07f));
    uint32_t part = dmg_slide(b, 0, "bridge", v3(1, 0, 0), -0.35f * span, 0.35f * span);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * 0.2f, high - 0.045f, 0), v3(0.06f, 0.085f, deep + 0.1f));
    part = dmg_slide(b, part, "carriage", v3(0, 0, 1), -0.35f * deep, 0.35f * deep);
    dmg_box(b, v3(0, high - 0.14f, 0), v3(0.5f, 0.1f, 0.45f));
    float y = high - 0.19f;
    for (int i = 0; i < stages; ++i) {
        float w = col * (1.0f - 0.16f * (float)i), low = y - each - 0.06f * (float)i;
        if (i) part = dmg_slide(b, part, "column", v3(0, -1, 0), 0.0f, 0.8f * each);
        dmg_box_span(b, v3(-w, low, -w), v3(w, i ? low + 0.06f - 0.002f : y + 0.01f, w));
        if (i) dmg_box_span(b, v3(-0.8f * w, low, -0.8f * w), v3(0.8f * w, low + 0.8f * each, 0.8f * w));
        if (i + 1 == stages) y = low;
    }
    part = dmg_spin(b, part, "tube_yaw", v3(0, y, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, y - 0.08f, 0), v3(0, y - 0.002f, 0), 0.08f);
    dmg_box_span(b, v3(-0.04f, y - 0.3f, -0.06f), v3(0.04f, y - 0.08f, 0.0f));
    part = dmg_hinge(b, part, "tube_tilt", v3(0, y - 0.24f, 0.1f), v3(0, 0, dmg_sign(b)), -1.9f, 1.9f);
    dmg_rod(b, v3(0, y - 0.24f, 0.004f), v3(0, y - 0.24f, 0.05f), 0.06f);
    dmg_rod(b, v3(-0.22f, y - 0.24f, 0.12f), v3(0.22f, y - 0.24f, 0.12f), 0.075f);
    dmg_box(b, v3(0, y - 0.18f, 0.24f), v3(0.3f, 0.2f, 0.03f));
    dmg_sweep(
        b,
        (const dmg_vec[]){
            {-0.2f, y - 0.24f, 0.2f}, {-0.24f, y - 0.26f, 0.3f}, {0.24f, y - 0.26f, 0.3f}, {0.2f, y - 0.24f, 0.2f}},
        4, 0.012f, 0.012f, false);
    dmg_spin(b, part, "collimator", v3(0, y - 0.32f, 0.12f), v3(0, 1, 0));
    dmg_box(b, v3(0, y - 0.41f, 0.12f), v3(0.2f, 0.17f, 0.18f));
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) draw_patient_table(b, 0.1f);
    if (dmg_chance(b, 0.5f)) return;
    float x = -0.6f * span; /* a stand with a plate for the chest */
    dmg_box_span(b, v3(x - 0.1f, 0, -0.12f), v3(x, 2.1f, 0.12f));
    part = dmg_slide(b, 0, "plate_lift", v3(0, 1, 0), -0.5f, 0.5f);
    dmg_box_span(b, v3(x + 0.004f, 1.1f, -0.1f), v3(x + 0.06f, 1.4f, 0.1f));
    dmg_hinge(b, part, "plate", v3(x + 0.1f, 1.25f, 0), v3(0, 0, 1), -0.3f, 1.57f);
    dmg_box_span(b, v3(x + 0.07f, 1.0f, -0.26f), v3(x + 0.13f, 1.5f, 0.26f));
    dmg_use(b, 0);
}

void dmg_build_c_arm(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){3, 1.5f}, 2);
    if (design) {
        draw_ceiling_tube(b);
        return;
    }
    draw_mobile_c(b);
    if (dmg_chance(b, 0.25f)) draw_patient_table(b, 0.05f);
}

/* ---- lamps ---- */

/* Draws the head below the origin, shining down: a dome, a flat disc, a ring, pods like petals. */
static void draw_lamp_head(dmg_builder* b, uint32_t head, float r) {
    int kind = dmg_int(b, 0, 3), pods = dmg_int(b, 3, 6), grip = dmg_int(b, 0, 2);
    float t = r * dmg_range(b, 0.1f, 0.3f);
    if (kind == 0) {
        const dmg_xy bowl[] = {{0, 0.1f * t},         {0.9f * r, -t}, {r, -t},
                               {0.75f * r, 0.5f * t}, {0.35f * r, t}, {0, 1.1f * t}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bowl, 6);
    } else if (kind == 1) {
        dmg_rod(b, v3(0, -0.4f * t, 0), v3(0, 0.4f * t, 0), r);
        for (int i = 0; i < 6; ++i)
            dmg_rod(b, v3(0.65f * r * cosf((float)i * 1.0472f), -0.55f * t, 0.65f * r * sinf((float)i * 1.0472f)),
                    v3(0.65f * r * cosf((float)i * 1.0472f), -0.3f * t, 0.65f * r * sinf((float)i * 1.0472f)),
                    0.18f * r);
    } else {
        if (kind == 2) dmg_torus(b, v3(0, 0, 0), v3(0, 1, 0), 0.82f * r, 0.18f * r);
        dmg_rod(b, v3(0, -0.3f * t, 0), v3(0, 0.4f * t, 0), 0.3f * r);
        for (int i = 0; i < pods; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, pods);
            dmg_beam(b, v3(0.2f * r, 0, 0), v3(0.75f * r, 0, 0), 0.12f * r, 0.3f * t);
            if (kind == 3) dmg_cone(b, v3(0.68f * r, -0.5f * t, 0), v3(0.68f * r, 0.4f * t, 0), 0.34f * r, 0.26f * r);
            dmg_restore(b);
        }
    }
    if (grip == 0) return;
    float y = kind == 0 ? 0.0f : -0.4f * t; /* turned to focus, or pulled off to be boiled */
    if (grip == 1)
        dmg_spin(b, head, "focus_handle", v3(0, y, 0), v3(0, 1, 0));
    else
        dmg_slide(b, head, "handle", v3(0, -1, 0), 0.0f, 0.4f * r);
    const dmg_xy knob[] = {{0, y - 0.5f * r - t},         {0.07f * r, y - 0.5f * r - t}, {0.05f * r, y - 0.3f * r - t},
                           {0.09f * r, y - 0.1f * r - t}, {0.09f * r, y - 0.004f * r},   {0, y - 0.004f * r}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), knob, 6);
}

/* Hung on the end of an arm at the origin: a fork that turns about the upright, the head in it, sometimes a ring
 * between. */
static void draw_lamp_yoke(dmg_builder* b, uint32_t arm, float r) {
    float stem = r * dmg_range(b, 0.2f, 0.5f), t = 0.045f * r, wide = 1.12f * r, drop = stem + 1.15f * r;
    bool half = dmg_chance(b, 0.5f), ring = dmg_chance(b, 0.3f);
    uint32_t fork = dmg_spin(b, arm, "yoke", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, -stem, 0), v3(0, -0.002f, 0), 1.5f * t);
    const dmg_vec both[] = {{-wide, -drop, 0},       {-wide, -stem - 0.4f * r, 0}, {-0.6f * wide, -stem, 0},
                            {0.6f * wide, -stem, 0}, {wide, -stem - 0.4f * r, 0},  {wide, -drop, 0}};
    if (half)
        dmg_sweep(b, both + 3, 3, t, t, false);
    else
        dmg_sweep(b, both, 6, t, t, false);
    if (half) dmg_rod(b, v3(0, -stem, 0), v3(0.6f * wide, -stem, 0), t);
    uint32_t head;
    if (ring) {
        head = dmg_hinge(b, fork, "gimbal", v3(0, -drop, 0), v3(1, 0, 0), -1.5f, 1.5f);
        dmg_torus(b, v3(0, -drop, 0), v3(0, 1, 0), 1.06f * r, 0.6f * t);
        dmg_move(b, 0, -drop, 0);
        head = dmg_hinge(b, head, "lamp_head", v3(0, 0, 0), v3(0, 0, 1), -1.2f, 1.2f);
        dmg_rod(b, v3(0, 0, -1.03f * r), v3(0, 0, -0.3f * r), 0.6f * t);
        dmg_rod(b, v3(0, 0, 0.3f * r), v3(0, 0, 1.03f * r), 0.6f * t);
    } else {
        dmg_move(b, 0, -drop, 0);
        head = dmg_hinge(b, fork, "lamp_head", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -1.5f, 1.5f);
        dmg_rod(b, v3(half ? 0.2f * r : -0.99f * wide, 0, 0), v3(0.99f * wide, 0, 0), 0.7f * t);
    }
    draw_lamp_head(b, head, ring ? 0.93f * r : r);
}

/* From the spindle (the axis Y) at height y: an arm about it, a sprung one that also nods, the lamp at its end. */
static void draw_lamp_arms(dmg_builder* b, uint32_t base, float y, float turn, float first, float second, float r) {
    float t = 0.04f, nod = dmg_range(b, 0.4f, 0.8f), lean = dmg_range(b, -1.0f, 1.0f), sleeve = 0.09f;
    bool long_arm = dmg_chance(b, 0.8f);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), turn);
    dmg_move(b, 0, y, 0);
    uint32_t part = base;
    if (long_arm) {
        part = dmg_spin(b, base, "arm", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
        dmg_rod(b, v3(0, -0.5f * sleeve, 0), v3(0, 0.5f * sleeve, 0), 0.075f);
        dmg_beam(b, v3(0.05f, 0, 0), v3(first, 0, 0), 1.6f * t, 1.8f * t);
        dmg_rod(b, v3(first, -0.06f, 0), v3(first, 0.05f, 0), 0.05f);
        dmg_move(b, first, -0.063f, 0);
    } else {
        dmg_move(b, 0, -0.05f, 0);
    }
    part = dmg_spin(b, part, "elbow", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, -0.1f, 0), v3(0, 0, 0), 0.05f);
    dmg_turn(b, v3(0, 1, 0), lean);
    dmg_move(b, 0, -0.07f, 0);
    part = dmg_hinge(b, part, "spring_arm", v3(0.07f, 0, 0), v3(0, 0, -1), -nod, nod);
    dmg_rod(b, v3(0.07f, 0, -0.045f), v3(0.07f, 0, 0.045f), 0.035f);
    dmg_beam(b, v3(0.08f, 0, 0), v3(second, 0, 0), 1.6f * t, 1.7f * t);
    dmg_rod(b, v3(second, -0.05f, 0), v3(second, 0.04f, 0), 0.04f);
    dmg_move(b, second, -0.05f, 0);
    draw_lamp_yoke(b, part, r);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_operating_lamp(dmg_builder* b) {
    int mount = dmg_weighted(b, (const float[]){3, 1.2f, 0.8f}, 3), arms = mount ? 1 : dmg_int(b, 1, 3);
    float r = dmg_range(b, 0.18f, 0.38f), high = dmg_range(b, 1.7f, 2.2f), drop = dmg_range(b, 0.4f, 0.8f),
          turn = dmg_range(b, 0.0f, 6.28f);
    if (mount == 0) { /* the ceiling's plate and tube; the sleeves stack along it */
        float low = high - 0.16f * (float)arms;
        dmg_rod(b, v3(0, high + drop, 0), v3(0, high + drop + 0.03f, 0), 0.2f);
        dmg_cone(b, v3(0, high + drop - 0.15f, 0), v3(0, high + drop, 0), 0.08f, 0.17f);
        dmg_rod(b, v3(0, low, 0), v3(0, high + drop - 0.15f, 0), 0.045f);
    } else if (mount == 1) { /* a stand on casters, its column drawn out */
        float foot = 0.1f;
        dmg_box(b, v3(0, foot + 0.03f, 0), v3(0.6f, 0.05f, 0.12f));
        dmg_box(b, v3(0, foot + 0.03f, 0), v3(0.12f, 0.05f, 0.6f));
        for (int i = 0; i < 4; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, 4);
            dmg_move(b, 0.26f, foot + 0.006f, 0);
            draw_caster(b, foot);
            dmg_restore(b);
        }
        dmg_rod(b, v3(0, foot, 0), v3(0, high, 0), 0.03f);
    } else { /* a bracket on the wall */
        dmg_box(b, v3(0, high, -0.2f), v3(0.2f, 0.3f, 0.04f));
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(-0.04f, high + (float)s * 0.08f - 0.02f, -0.19f),
                         v3(0.04f, high + (float)s * 0.08f + 0.02f, 0.05f));
        dmg_rod(b, v3(0, high - 0.09f, 0), v3(0, high + 0.09f, 0), 0.035f);
    }
    for (int i = 0; i < arms; ++i) {
        float first = dmg_range(b, 0.5f, 1.0f), second = dmg_range(b, 0.5f, 0.9f);
        draw_lamp_arms(b, 0, high - 0.16f * (float)i, turn + (float)i * 6.28f / (float)arms, first, second, r);
        r *= dmg_range(b, 0.8f, 1.0f);
    }
}
