/* Draws small things: bottles, jars, dispensers, pens, sticks, knives, glasses, locks. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- bottle and jar ---- */

/* Ribs round a cap, or smooth. */
static void draw_cap(dmg_builder* b, float radius, float height, float low) {
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_rod(b, v3(0, low, 0), v3(0, low + height, 0), radius);
    if (kind == 1) {
        dmg_save(b);
        dmg_move(b, 0, low, 0);
        dmg_face_up(b);
        dmg_knob_draw(b, 4, radius, height);
        dmg_restore(b);
    }
    if (kind == 2) { /* a hollow one, its wall double */
        const dmg_xy wall[] = {{0.85f * radius, low},
                               {radius, low},
                               {radius, low + 0.9f * height},
                               {0.9f * radius, low + height},
                               {0, low + height}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), wall, 5);
    }
    if (kind == 3) dmg_cone(b, v3(0, low, 0), v3(0, low + height, 0), radius, radius * 0.6f);
}

/* How a cap leaves its neck: turned off, pulled off, or turned without end. */
static uint32_t add_cap(dmg_builder* b, const char* name, float radius, float height) {
    static const float weights[] = {4, 1.5f, 1, 1};
    int motion = dmg_weighted(b, weights, 4);
    float pitch = radius * dmg_range(b, 0.02f, 0.12f), turns = dmg_range(b, 0.3f, 3.0f);
    if (motion == 0) return dmg_screw(b, 0, name, v3(0, 0, 0), v3(0, 1, 0), pitch, 0.0f, 2 * DMG_PI * turns);
    if (motion == 1) return dmg_slide(b, 0, name, v3(0, 1, 0), 0.0f, height * dmg_range(b, 0.8f, 2.0f));
    if (motion == 2) return dmg_spin(b, 0, name, v3(0, 0, 0), v3(0, 1, 0));
    float way = dmg_sign(b);
    return dmg_hinge(b, 0, name, v3(0, 0, 0), v3(0, way, 0), 0.0f, DMG_PI * dmg_range(b, 0.4f, 1.9f));
}

/* Body, shoulder and neck; the neck's radius and top are returned in `neck`. */
static dmg_xy draw_bottle_body(dmg_builder* b, float radius, float height) {
    float neck = radius * dmg_range(b, 0.2f, 0.6f), shoulder = height * dmg_range(b, 0.5f, 0.85f),
          waist = radius * dmg_range(b, 0.7f, 1.1f);
    int shape = dmg_int(b, 0, 3);
    if (shape == 3) { /* square, with a round neck */
        dmg_rounded_box(b, v3(0, 0.5f * shoulder, 0), v3(2 * radius, shoulder, 2 * radius * dmg_range(b, 0.5f, 1.0f)),
                        0.15f * radius);
        dmg_cone(b, v3(0, 0.98f * shoulder, 0), v3(0, height, 0), 0.9f * neck, 0.9f * neck);
        return (dmg_xy){neck, height};
    }
    dmg_xy profile[8] = {{0, 0},
                         {0.9f * radius, 0},
                         {radius, 0.03f * height},
                         {waist, 0.5f * shoulder},
                         {radius, 0.95f * shoulder},
                         {0.9f * neck, 0.5f * (shoulder + height)},
                         {0.9f * neck, height},
                         {0, height}};
    if (shape == 1) profile[3].x = radius;
    if (shape == 2) profile[4] = (dmg_xy){0.7f * radius, shoulder};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, dmg_chance(b, 0.7f) ? 8 : 7);
    return (dmg_xy){neck, height};
}

void dmg_build_bottle(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.01f, 0.15f), height = radius * dmg_range(b, 1.5f, 8.0f);
    dmg_xy neck = draw_bottle_body(b, radius, height);
    float cap = neck.x * dmg_range(b, 0.5f, 2.0f), low = neck.y - 0.85f * cap;
    if (dmg_chance(b, 0.75f)) {
        add_cap(b, "cap", 1.1f * neck.x, cap);
        draw_cap(b, 1.1f * neck.x, cap, low);
    } else { /* a base that stays and a lid on a hinge */
        float r = 1.15f * neck.x, y = neck.y + 0.05f * cap;
        dmg_rod(b, v3(0, low, 0), v3(0, y, 0), r);
        dmg_hinge(b, 0, "flip_cap", v3(0, y, -r), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 2.6f));
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(0, y, 0), v3(0, y + 0.4f * cap, 0), r);
        else
            dmg_dome(b, v3(0, y, 0), v3(r, 0.6f * cap, r));
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.15f)) { /* a handle */
        const dmg_vec loop[] = {{0.9f * radius, 0.2f * height, 0},
                                {1.6f * radius, 0.25f * height, 0},
                                {1.6f * radius, 0.45f * height, 0},
                                {0.9f * radius, 0.5f * height, 0}};
        dmg_sweep(b, loop, 4, 0.1f * radius, 0.15f * radius, false);
    }
}

void dmg_build_jar(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.02f, 0.15f), height = radius * dmg_range(b, 0.6f, 3.5f),
          mouth = radius * dmg_range(b, 0.6f, 1.0f), lid = radius * dmg_range(b, 0.15f, 0.6f), wall = 0.06f * radius;
    bool hollow = dmg_chance(b, 0.5f);
    const dmg_xy outside[] = {{0, 0},
                              {0.95f * radius, 0},
                              {radius, 0.08f * height},
                              {radius, 0.8f * height},
                              {mouth, 0.9f * height},
                              {mouth, height},
                              {mouth - wall, height},
                              {mouth - wall, 0.9f * height},
                              {radius - wall, 0.8f * height},
                              {radius - wall, wall},
                              {0, wall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), outside, hollow ? 11 : 6);
    int clip = dmg_int(b, 0, 4);
    float low = height - 0.8f * lid;
    if (clip > 0) {
        add_cap(b, "lid", 1.06f * mouth, lid);
        draw_cap(b, 1.06f * mouth, lid, low);
    } else { /* hinged, with a wire */
        float back = 1.1f * mouth;
        dmg_hinge(b, 0, "lid", v3(0, height, -back), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 2.5f));
        dmg_rod(b, v3(0, height, 0), v3(0, height + lid, 0), 1.03f * mouth);
        dmg_box(b, v3(0, height + 0.3f * lid, -back), v3(0.4f * mouth, 0.3f * lid, 0.3f * mouth));
    }
    if (dmg_chance(b, 0.3f))
        dmg_ellipsoid(b, v3(0, height + 0.5f * lid, 0), v3(0.15f * mouth, 0.3f * lid, 0.15f * mouth));
    dmg_use(b, 0);
}

/* ---- pumps ---- */

void dmg_build_dispenser(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.015f, 0.06f), height = radius * dmg_range(b, 2, 6),
          rise = radius * dmg_range(b, 0.8f, 2.0f), reach = radius * dmg_range(b, 0.8f, 2.0f);
    dmg_xy neck = draw_bottle_body(b, radius, height);
    dmg_rod(b, v3(0, neck.y - 0.5f * rise, 0), v3(0, neck.y + 0.2f * rise, 0), 1.2f * neck.x);
    if (dmg_chance(b, 0.7f)) { /* pressed from above */
        float turned = dmg_range(b, -0.5f, 0.5f);
        bool turns = dmg_chance(b, 0.25f);
        if (turns)
            dmg_spin(b, 0, "nozzle", v3(0, 0, 0), v3(0, 1, 0));
        else
            dmg_slide(b, 0, "pump", v3(0, -1, 0), 0.0f, rise * dmg_range(b, 0.4f, 0.75f));
        dmg_turn(b, v3(0, 1, 0), turned);
        dmg_rod(b, v3(0, neck.y, 0), v3(0, neck.y + rise, 0), 0.35f * neck.x);
        dmg_rod(b, v3(0, neck.y + rise, 0), v3(0, neck.y + 1.3f * rise, 0), 0.8f * neck.x);
        dmg_beam(b, v3(0, neck.y + 1.15f * rise, 0), v3(0, neck.y + dmg_range(b, 0.9f, 1.3f) * rise, reach),
                 0.4f * neck.x, 0.25f * rise);
    } else { /* a spray head with a trigger */
        float y = neck.y + 0.2f * rise;
        dmg_box(b, v3(0, y + 0.6f * rise, 0), v3(1.4f * neck.x, 0.8f * rise, 2 * reach));
        dmg_hinge(b, 0, "trigger", v3(0, y + 0.4f * rise, 0.7f * reach), v3(1, 0, 0), 0.0f, 0.4f);
        dmg_beam(b, v3(0, y + 0.4f * rise, 0.75f * reach), v3(0, y - 0.8f * rise, 0.9f * reach), neck.x, 0.15f * reach);
    }
    dmg_use(b, 0);
}

void dmg_build_syringe(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.004f, 0.04f), length = radius * dmg_range(b, 5, 12), wall = 0.12f * radius,
          drawn = dmg_range(b, 0.2f, 0.8f);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI * (float)dmg_int(b, 0, 2));
    const dmg_xy barrel[] = {{0, 0},   {radius, 0}, {radius, length}, {radius - wall, length}, {radius - wall, wall},
                             {0, wall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), barrel, 6);
    dmg_cone(b, v3(0, -1.2f * radius, 0), v3(0, 0, 0), 0.1f * radius, 0.35f * radius);
    if (dmg_chance(b, 0.8f)) dmg_box(b, v3(0, 0.99f * length, 0), v3(4 * radius, 0.2f * radius, 1.6f * radius));
    float travel = 0.85f * length;
    uint32_t plunger = dmg_slide(b, 0, "plunger", v3(0, 1, 0), 0.0f, travel);
    dmg_rod(b, v3(0, 0.05f * length, 0), v3(0, 0.05f * length + 0.6f * radius, 0), 0.85f * radius);
    dmg_box(b, v3(0, 0.55f * length, 0), v3(0.8f * radius, length, 0.25f * radius));
    dmg_rod(b, v3(0, 1.06f * length, 0), v3(0, 1.09f * length, 0), radius * dmg_range(b, 0.9f, 1.5f));
    dmg_rest(b, plunger, drawn * travel);
    dmg_use(b, 0);
}

/* ---- pen and stick ---- */

void dmg_build_pen(dmg_builder* b) {
    float length = dmg_range(b, 0.1f, 0.18f), radius = length * dmg_range(b, 0.03f, 0.08f),
          cap = length * dmg_range(b, 0.25f, 0.5f);
    int kind = dmg_int(b, 0, 2);
    dmg_move(b, 0, radius, 0);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, 0, 3));
    dmg_rod(b, v3(-0.5f * length, 0, 0), v3(0.38f * length, 0, 0), radius);
    dmg_cone(b, v3(0.38f * length, 0, 0), v3(0.5f * length, 0, 0), radius, 0.1f * radius);
    bool clip = dmg_chance(b, 0.7f);
    float from = -0.4f * length;
    if (kind == 0) { /* a cap, pulled or screwed */
        float pitch = radius * dmg_range(b, 0.1f, 0.3f);
        if (dmg_chance(b, 0.7f))
            dmg_slide(b, 0, "cap", v3(1, 0, 0), 0.0f, cap);
        else
            dmg_screw(b, 0, "cap", v3(0, 0, 0), v3(1, 0, 0), pitch, 0.0f, 9.0f);
        dmg_rod(b, v3(0.52f * length - cap, 0, 0), v3(0.52f * length, 0, 0), 1.2f * radius);
        from = 0.52f * length - cap;
    }
    if (clip)
        dmg_box(b, v3(from + 0.13f * length, 1.5f * radius, 0), v3(0.28f * length, 0.15f * radius, 0.4f * radius));
    dmg_use(b, 0);
    if (kind == 1) { /* a button at the end */
        float out = length * dmg_range(b, 0.02f, 0.07f);
        dmg_slide(b, 0, "button", v3(1, 0, 0), 0.0f, 0.7f * out);
        dmg_rod(b, v3(-0.5f * length - out, 0, 0), v3(-0.48f * length, 0, 0), 0.5f * radius);
        dmg_use(b, 0);
    }
    if (kind == 2) { /* the rear half twists */
        dmg_hinge(b, 0, "barrel", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), 0.0f, 2.5f);
        dmg_rod(b, v3(-0.52f * length, 0, 0), v3(-0.05f * length, 0, 0), 1.04f * radius);
        dmg_use(b, 0);
    }
}

void dmg_build_usb_stick(dmg_builder* b) {
    float length = dmg_range(b, 0.04f, 0.08f), width = length * dmg_range(b, 0.2f, 0.4f),
          thick = width * dmg_range(b, 0.3f, 0.7f), plug = length * dmg_range(b, 0.2f, 0.3f);
    int kind = dmg_int(b, 0, 2);
    dmg_move(b, 0, thick, 0);
    dmg_box(b, v3(0.5f * length + 0.5f * plug, 0, 0), v3(plug, 0.4f * thick, 0.6f * width));
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0, 0), v3(length, thick, width));
    else
        dmg_rounded_box(b, v3(0, 0, 0), v3(length, thick, width), 0.3f * thick);
    if (kind == 0) { /* a cap over the plug */
        dmg_slide(b, 0, "cap", v3(1, 0, 0), 0.0f, 1.3f * plug);
        dmg_box(b, v3(0.5f * length + 0.55f * plug, 0, 0), v3(1.1f * plug, thick, width));
    }
    if (kind == 1) { /* a clip that swings about a rivet */
        float x = -0.4f * length, shut = dmg_range(b, 0.0f, 6.0f);
        uint32_t clip = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "clip", v3(x, 0, 0), v3(0, 1, 0))
                                            : dmg_hinge(b, 0, "clip", v3(x, 0, 0), v3(0, 1, 0), 0.0f, 2 * DMG_PI);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(0.1f * length, (float)s * 0.58f * thick, 0), v3(1.15f * length, 0.08f * thick, 0.9f * width));
        dmg_box(b, v3(0.68f * length, 0, 0), v3(0.03f * length, 1.25f * thick, 0.9f * width));
        dmg_rod(b, v3(x, -0.7f * thick, 0), v3(x, 0.7f * thick, 0), 0.15f * width);
        dmg_rest(b, clip, shut);
    }
    if (kind == 2) { /* a button slides the plug out */
        dmg_slide(b, 0, "slider", v3(1, 0, 0), 0.0f, 0.4f * length);
        dmg_box(b, v3(-0.2f * length, 0.6f * thick, 0), v3(0.2f * length, 0.3f * thick, 0.4f * width));
    }
    dmg_use(b, 0);
}

/* ---- knife and glasses ---- */

void dmg_build_folding_knife(dmg_builder* b) {
    float length = dmg_range(b, 0.06f, 0.15f), width = length * dmg_range(b, 0.12f, 0.25f),
          thick = width * dmg_range(b, 0.4f, 0.8f);
    int tools = dmg_int(b, 1, 4);
    bool plates = dmg_chance(b, 0.5f); /* in a solid handle the blades lie on top */
    dmg_move(b, 0, width, 0);
    if (plates)
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(0, 0, (float)s * 0.45f * thick), v3(length, width, 0.1f * thick));
    else
        dmg_rounded_box(b, v3(0, 0, 0), v3(length, width, thick), 0.3f * thick);
    for (int i = 0; i < tools; ++i) {
        float end = i % 2 ? -1.0f : 1.0f, z = thick * (((float)i + 0.5f) / (float)tools - 0.5f) * 0.8f,
              blade = length * dmg_range(b, 0.6f, 0.92f), high = width * dmg_range(b, 0.3f, 0.7f),
              t = 0.5f * thick / (float)tools, open = dmg_chance(b, 0.6f) ? DMG_PI * dmg_range(b, 0.3f, 1.0f) : 0.0f;
        dmg_vec pin = {end * 0.45f * length, (plates ? 0.2f : 0.55f) * width, z};
        uint32_t tool = dmg_hinge(b, 0, "blade", pin, v3(0, 0, -end), 0.0f, DMG_PI);
        dmg_save(b);
        dmg_move(b, pin.x, pin.y, z - 0.5f * t);
        const dmg_xy right[] = {{-blade, 0},       {-0.7f * blade, -0.6f * high},
                                {0, -0.6f * high}, {0.2f * high, 0.2f * high},
                                {0, 0.4f * high},  {-0.9f * blade, 0.4f * high}};
        if (end < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_extrude(b, right, 6, 0, t);
        dmg_restore(b);
        dmg_rest(b, tool, open);
        dmg_use(b, 0);
    }
}

void dmg_build_eyeglasses(dmg_builder* b) {
    float width = dmg_range(b, 0.1f, 0.16f), lens = width * dmg_range(b, 0.18f, 0.24f),
          rim = width * dmg_range(b, 0.008f, 0.03f), arm = width * dmg_range(b, 0.8f, 1.05f), folded = DMG_PI * 0.5f;
    bool round = dmg_chance(b, 0.5f), glass = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 1.5f * lens, 0);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.27f * width;
        if (round) dmg_torus(b, v3(x, 0, 0), v3(0, 0, 1), lens, rim);
        dmg_save(b);
        dmg_move(b, x, 0, rim);
        if (!round) dmg_frame_draw(b, 2.1f * lens, 1.5f * lens, 2 * rim, 2 * rim);
        if (glass) dmg_box(b, v3(0, 0, -rim), v3(1.4f * lens, 1.2f * lens, 0.2f * rim));
        dmg_restore(b);
        dmg_box(b, v3((float)s * 0.49f * width, 0.4f * lens, 0), v3(0.05f * width, 2.5f * rim, 2 * rim));
        dmg_vec pin = {(float)s * 0.5f * width, 0.4f * lens, -rim};
        uint32_t temple =
            dmg_hinge(b, 0, s < 0 ? "temple_left" : "temple_right", pin, v3(0, (float)s, 0), 0.0f, folded);
        const dmg_vec path[] = {pin, v3_add(pin, v3(0, 0, -0.75f * arm)), v3_add(pin, v3(0, -0.25f * arm, -arm))};
        dmg_sweep(b, path, 3, rim, 0.6f * rim, false);
        if (dmg_chance(b, 0.25f)) dmg_rest(b, temple, folded * dmg_range(b, 0.3f, 1.0f));
        dmg_use(b, 0);
    }
    dmg_beam(b, v3(-0.1f * width, 0.2f * lens, 0), v3(0.1f * width, 0.2f * lens, 0), 1.5f * rim, 1.5f * rim);
}

/* ---- padlock ---- */

void dmg_build_padlock(dmg_builder* b) {
    enum { POINTS = 9 };
    float width = dmg_scale_range(b, 0.02f, 0.12f), height = width * dmg_range(b, 0.6f, 1.3f),
          thick = width * dmg_range(b, 0.25f, 0.6f), half = width * dmg_range(b, 0.25f, 0.4f),
          rise = width * dmg_range(b, 0.4f, 1.2f), tube = width * dmg_range(b, 0.05f, 0.1f);
    dmg_move(b, 0, height, 0);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, -0.5f * height, 0), v3(width, height, thick), 0.3f * thick);
    else
        dmg_box(b, v3(0, -0.5f * height, 0), v3(width, height, thick));
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)(i - 1) / (POINTS - 3);
        path[i] = v3(-half * cosf(angle), rise - half + half * sinf(angle), 0);
    }
    int kind = dmg_int(b, 0, 2);
    float sunk = kind == 0 ? 0.6f * height : 0.0f;
    path[0] = v3(-half, -sunk, 0);
    path[POINTS - 1] = v3(half, -sunk, 0);
    if (kind == 0)
        dmg_slide(b, 0, "shackle", v3(0, 1, 0), 0.0f, 0.4f * rise);
    else if (kind == 1)
        dmg_hinge(b, 0, "shackle", v3(half, 0, 0), v3(0, 1, 0), 0.0f, DMG_PI);
    else
        dmg_hinge(b, 0, "shackle", v3(half, 0, 0), v3(0, 0, -1), 0.0f, 1.2f);
    dmg_sweep(b, path, POINTS, tube, tube, false);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) { /* dials */
        int dials = dmg_int(b, 3, 5);
        float r = 0.12f * height, w = 0.7f * width / (float)dials;
        for (int i = 0; i < dials; ++i) {
            float x = w * ((float)i - 0.5f * (float)(dials - 1));
            dmg_spin(b, 0, "dial", v3(x, -0.6f * height, 0.5f * thick), v3(1, 0, 0));
            dmg_rod(b, v3(x - 0.4f * w, -0.6f * height, 0.5f * thick), v3(x + 0.4f * w, -0.6f * height, 0.5f * thick),
                    r);
            dmg_use(b, 0);
        }
    }
}
