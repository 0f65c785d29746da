/* Draws mills turned by hand: columns whose head turns, boxes with a drawer under a crank, tubes with a jar, mincers
 * clamped to a table. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a crank on a vertical shaft at y: an arm straight, cranked up or curved, a knob at its end that may turn. */
static void draw_mill_crank(dmg_builder* b, uint32_t parent, float y, float arm, float t) {
    float rise = arm * dmg_range(b, 0.0f, 0.4f), knob = t * dmg_range(b, 1.5f, 3.0f),
          tall = knob * dmg_range(b, 1.2f, 3.0f);
    bool turns = dmg_chance(b, 0.5f), ball = dmg_chance(b, 0.4f);
    int kind = dmg_int(b, 0, 2);
    dmg_vec hub = v3(0, y + 3 * t, 0), end = v3(arm, y + 3 * t + rise, 0);
    uint32_t crank = dmg_spin(b, parent, "crank", v3(0, y, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, y, 0), v3(0, y + 4 * t, 0), 1.2f * t);
    if (kind == 0) dmg_beam(b, hub, end, 2 * t, t);
    if (kind == 1) {
        dmg_vec knee = v3(0.6f * arm, hub.y, 0);
        dmg_rod(b, hub, knee, 0.7f * t);
        dmg_rod(b, knee, end, 0.7f * t);
    }
    if (kind == 2) {
        const dmg_vec path[] = {hub, v3(0.3f * arm, hub.y + 0.7f * rise, 0), v3(0.7f * arm, end.y, 0), end};
        dmg_sweep(b, path, 4, 0.6f * t, t, false);
    }
    dmg_rod(b, v3(end.x, end.y - t, 0), v3(end.x, end.y + t, 0), 1.3f * t);
    if (turns) dmg_spin(b, crank, "crank_knob", end, v3(0, 1, 0));
    if (ball)
        dmg_ellipsoid(b, v3(end.x, end.y + t + 0.9f * knob, 0), v3(knob, knob, knob));
    else
        dmg_cone(b, v3(end.x, end.y + 1.01f * t, 0), v3(end.x, end.y + t + tall, 0), 0.6f * knob, knob);
    dmg_use(b, parent);
}

/* Draws a turned column whose head goes round, with a nut on top; or one with a crank. */
static void draw_pepper_mill(dmg_builder* b) {
    float r = dmg_range(b, 0.022f, 0.035f), high = r * dmg_range(b, 3.0f, 10.0f), waist = r * dmg_range(b, 0.5f, 1.0f),
          seam = high * dmg_range(b, 0.6f, 0.8f), neck = r * dmg_range(b, 0.6f, 1.0f),
          nut = r * dmg_range(b, 0.2f, 0.4f);
    bool ball = dmg_chance(b, 0.4f), crank = dmg_chance(b, 0.25f), ring = dmg_chance(b, 0.3f);
    const dmg_xy body[] = {
        {0, 0},       {r, 0},   {r, 0.1f * high}, {0.9f * r, 0.15f * high}, {waist, 0.4f * high}, {neck, 0.9f * seam},
        {neck, seam}, {0, seam}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 8);
    if (ring) { /* below, it sets how fine it grinds */
        dmg_hinge(b, 0, "ring", v3(0, 0, 0), v3(0, 1, 0), 0.0f, dmg_range(b, 1.0f, 5.0f));
        dmg_rod(b, v3(0, 0.03f * high, 0), v3(0, 0.08f * high, 0), 1.12f * r);
        dmg_use(b, 0);
    }
    float top = high - 1.2f * nut;
    const dmg_xy head[] = {{0, seam + 0.0005f},
                           {neck, seam + 0.0005f},
                           {1.05f * r, seam + 0.3f * (top - seam)},
                           {0.9f * r, seam + 0.75f * (top - seam)},
                           {0.5f * r, top},
                           {0, top}};
    if (crank) {
        dmg_rod(b, v3(0, seam - 0.1f * r, 0), v3(0, seam + 0.3f * r, 0), 1.1f * neck);
        draw_mill_crank(b, 0, seam + 0.3f * r, r * dmg_range(b, 1.3f, 2.6f), 0.12f * r);
        return;
    }
    uint32_t part = dmg_spin(b, 0, "head", v3(0, seam, 0), v3(0, 1, 0));
    if (ball) {
        float half = 0.5f * (top - seam);
        dmg_rod(b, v3(0, seam + 0.0005f, 0), v3(0, seam + half, 0), 0.5f * neck);
        dmg_ellipsoid(b, v3(0, seam + half, 0), v3(fminf(half, 1.2f * r), half, fminf(half, 1.2f * r)));
    } else {
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), head, 6);
    }
    if (dmg_chance(b, 0.6f)) dmg_screw(b, part, "nut", v3(0, top, 0), v3(0, 1, 0), 0.0003f, 0.0f, 6.0f * DMG_PI);
    dmg_rod(b, v3(0, top - 0.2f * nut, 0), v3(0, top + 0.5f * nut, 0), 0.5f * nut);
    dmg_ellipsoid(b, v3(0, top + 0.8f * nut, 0), v3(nut, 0.6f * nut, nut));
    dmg_use(b, 0);
}

/* Draws a wooden or tin box with a drawer for what falls down, a funnel on top, with a flap or none. */
static void draw_box_mill(dmg_builder* b) {
    float w = dmg_range(b, 0.09f, 0.16f), h = w * dmg_range(b, 0.8f, 1.5f), wall = 0.07f * w,
          r = w * dmg_range(b, 0.25f, 0.42f), low = h * dmg_range(b, 0.3f, 0.5f), dome = r * dmg_range(b, 0.4f, 1.1f);
    bool open = dmg_chance(b, 0.4f), foot = dmg_chance(b, 0.6f);
    dmg_drawer d = dmg_drawer_pick(b, 0.03f);
    d.width = w - 2.4f * wall;
    d.height = low - 1.6f * wall;
    d.depth = w - 3 * wall;
    d.travel = d.depth * dmg_range(b, 0.5f, 1.0f);
    d.handle.kind = dmg_chance(b, 0.7f) ? DMG_HANDLE_KNOB : DMG_HANDLE_BALL;
    d.handle.standoff = 0.1f * w;
    d.handle.thickness = 0.04f * w;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * low + wall, 0.5f * w);
    dmg_case_draw(b, DMG_CASE_BOARDS, w, low, w, wall);
    dmg_drawer_draw(b, 0, "drawer", &d);
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_box_span(b, v3(-0.5f * w, wall + low, -0.5f * w), v3(0.5f * w, h, 0.5f * w));
    if (foot) dmg_box_span(b, v3(-0.57f * w, 0, -0.57f * w), v3(0.57f * w, 1.02f * wall, 0.57f * w));
    if (dmg_chance(b, 0.5f)) dmg_box_span(b, v3(-0.55f * w, h, -0.55f * w), v3(0.55f * w, h + 0.5f * wall, 0.55f * w));
    float top = h + 0.4f * wall;
    dmg_move(b, 0, top, 0);
    if (open) { /* a bowl, and a bridge that carries the shaft */
        const dmg_xy bowl[] = {{0, 0},           {0.5f * r, 0},           {1.2f * r, dome},
                               {1.1f * r, dome}, {0.4f * r, 0.1f * dome}, {0, 0.1f * dome}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bowl, 6);
        dmg_box(b, v3(0, dome, 0), v3(2.25f * r, 0.08f * r, 0.3f * r));
    } else {
        dmg_dome(b, v3(0, 0, 0), v3(r, dome, r));
        float turn = dmg_range(b, -1.0f, 1.0f);
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), turn);
        dmg_turn(b, v3(1, 0, 0), 0.6f);
        dmg_hinge(b, 0, "flap", v3(0, 0.7f * dome, 0.65f * r), v3(0, 1, 0), 0.0f, dmg_range(b, 0.8f, 2.0f));
        dmg_rounded_box(b, v3(0.1f * r, fmaxf(0.9f * dome, 0.7f * r), 0.2f * r), v3(0.6f * r, 0.06f * r, 0.5f * r),
                        0.02f * r);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    draw_mill_crank(b, 0, dome, w * dmg_range(b, 0.5f, 1.1f), 0.035f * w);
}

/* Draws a slim tube with a jar below that is screwed off, a crank that is lifted off above. */
static void draw_tube_mill(dmg_builder* b) {
    float r = dmg_range(b, 0.022f, 0.035f), high = r * dmg_range(b, 3.5f, 6.5f), seam = high * dmg_range(b, 0.3f, 0.5f),
          jar = r * dmg_range(b, 0.85f, 1.25f), t = 0.1f * r, arm = r * dmg_range(b, 1.8f, 4.0f);
    bool band = dmg_chance(b, 0.5f), lid = dmg_chance(b, 0.5f);
    dmg_rod(b, v3(0, seam, 0), v3(0, high, 0), r);
    if (band) dmg_rod(b, v3(0, seam + 0.3f * r, 0), v3(0, high - 0.6f * r, 0), 1.06f * r);
    const dmg_xy rows[] = {
        {0, 0}, {0.9f * jar, 0}, {jar, 0.1f * seam}, {0.95f * r, seam - 0.0005f}, {0, seam - 0.0005f}};
    dmg_screw(b, 0, "jar", v3(0, seam, 0), v3(0, -1, 0), 0.0006f, 0.0f, 4.0f * DMG_PI);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), rows, 5);
    dmg_use(b, 0);
    uint32_t cap = 0;
    if (lid) {
        cap = dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, r * dmg_range(b, 0.5f, 2.0f));
        dmg_rod(b, v3(0, high + 0.0005f, 0), v3(0, high + 0.25f * r, 0), 1.02f * r);
    }
    draw_mill_crank(b, cap, high + (lid ? 0.25f * r : 0.0f), arm, t);
    dmg_use(b, 0);
}

/* Clamped to the table's edge: a barrel with a funnel, a crank behind, a screw ring in front, the screw of the clamp.
 */
static void draw_meat_mill(dmg_builder* b) {
    float r = dmg_range(b, 0.025f, 0.045f), high = r * dmg_range(b, 4.0f, 6.5f), long_ = r * dmg_range(b, 2.5f, 4.5f),
          t = 0.3f * r, jaw = r * dmg_range(b, 1.2f, 2.2f), gap = r * dmg_range(b, 1.0f, 1.8f),
          funnel = r * dmg_range(b, 1.3f, 2.2f), arm = r * dmg_range(b, 2.2f, 4.0f);
    float foot = high - gap - 2.2f * r, reach = 0.5f * long_;
    const dmg_xy cup[] = {{0.5f * r, 0},        {0.8f * r, 0}, {funnel, 1.6f * r}, {0.93f * funnel, 1.6f * r},
                          {0.7f * r, 0.1f * r}, {0.5f * r, 0}};
    dmg_rod(b, v3(0, high, -reach), v3(0, high, reach), r);
    dmg_lathe(b, v3(0, high + 0.7f * r, 0.2f * reach), v3(0, 1, 0), cup, 6);
    dmg_box_span(b, v3(-0.5f * r, foot, -0.5f * t - reach), v3(0.5f * r, high, 0.7f * t - reach)); /* the leg */
    dmg_box_span(b, v3(-0.7f * r, high - 1.7f * r, -reach), v3(0.7f * r, high - 1.7f * r + t, jaw - reach));
    dmg_box_span(b, v3(-0.5f * r, foot - t, -0.5f * t - reach), v3(0.5f * r, foot, jaw - reach));
    dmg_screw(b, 0, "ring", v3(0, high, reach), v3(0, 0, 1), 0.0008f, 0.0f, 6.0f * DMG_PI);
    dmg_rod(b, v3(0, high, reach - 0.2f * r), v3(0, high, reach + 0.5f * r), 1.2f * r);
    for (int i = 0; i < 4; ++i) {
        float angle = 0.5f * DMG_PI * (float)i;
        dmg_box(b, v3(1.2f * r * cosf(angle), high + 1.2f * r * sinf(angle), reach + 0.15f * r),
                v3(0.3f * r, 0.3f * r, 0.5f * r));
    }
    float z = 0.75f * jaw - reach, drop = fmaxf(foot - t - 0.02f, 0.3f * foot), bar = 0.6f * r;
    dmg_screw(b, 0, "clamp_screw", v3(0, 0, z), v3(0, 1, 0), 0.001f, 0.0f, 0.4f * gap / 0.001f);
    dmg_rod(b, v3(0, foot - t - drop, z), v3(0, foot + 0.3f * gap, z), 0.2f * r);
    dmg_rod(b, v3(0, foot + 0.3f * gap, z), v3(0, foot + 0.4f * gap, z), 0.45f * r);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(-bar, foot - t - 0.9f * drop, z), v3(bar, foot - t - 0.9f * drop, z), 0.12f * r);
    else
        dmg_box(b, v3(0, foot - t - 0.85f * drop, z), v3(2 * bar, 0.3f * drop, 0.2f * r));
    dmg_use(b, 0);
    dmg_move(b, 0, high, -reach);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    draw_mill_crank(b, 0, 0, arm, 0.2f * r);
}

void dmg_build_hand_mill(dmg_builder* b) {
    switch (dmg_weighted(b, (const float[]){3, 3, 2, 2}, 4)) {
    case 0:
        draw_pepper_mill(b);
        break;
    case 1:
        draw_box_mill(b);
        break;
    case 2:
        draw_tube_mill(b);
        break;
    default:
        draw_meat_mill(b);
        break;
    }
}
