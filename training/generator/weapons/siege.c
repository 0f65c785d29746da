/* Draws siege engines and old artillery as props: cannon on carriages, ballistas, catapults with a windlass,
 * trebuchets with a hung weight. They shoot towards +Z. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* Draws a wheel with its axle stub at (x, radius, z), turning about X. */
static void draw_cart_wheel(dmg_builder* b, int kind, float x, float z, float radius, float width) {
    dmg_use(b, 0);
    dmg_spin(b, 0, "wheel", v3(x, radius, z), v3(1, 0, 0));
    dmg_save(b);
    dmg_move(b, x, radius, z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    if (kind < 7) {
        dmg_wheel_draw(b, kind, radius, width, dmg_int(b, 4, 12));
    } else { /* felloes of wood */
        const dmg_xy rim[] = {{0.82f * radius, -0.5f * width},
                              {radius, -0.5f * width},
                              {radius, 0.5f * width},
                              {0.82f * radius, 0.5f * width},
                              {0.82f * radius, -0.5f * width}};
        int spokes = dmg_int(b, 4, 12);
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), rim, 5);
        dmg_rod(b, v3(0, 0, -0.8f * width), v3(0, 0, 0.8f * width), 0.2f * radius);
        for (int i = 0; i < spokes; ++i) {
            dmg_turn_to(b, v3(0, 0, 1), 1, spokes);
            dmg_box_span(b, v3(0.1f * radius, -0.05f * radius, -0.2f * width),
                         v3(0.83f * radius, 0.05f * radius, 0.2f * width));
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws two or four wheels under a frame, on axles of the body. */
static void draw_running_gear(dmg_builder* b, float half_width, float front, float rear, float radius) {
    int kind = dmg_chance(b, 0.5f) ? 7 : dmg_int(b, 0, 2);
    float width = radius * dmg_range(b, 0.15f, 0.4f), x = half_width + 0.8f * width;
    for (int i = 0; i < 2; ++i) {
        float z = i ? rear : front;
        if (i && front == rear) break;
        dmg_rod(b, v3(-x, radius, z), v3(x, radius, z), 0.12f * radius);
        for (int s = -1; s <= 1; s += 2) draw_cart_wheel(b, kind, (float)s * x, z, radius, width);
    }
}

/* Draws a drum across the frame that turns about X: handspikes, cranks or wheels at its ends; a rope round its middle.
 */
static void draw_windlass(dmg_builder* b, uint32_t parent, dmg_vec at, float half, float radius) {
    int kind = dmg_int(b, 0, 3), spikes = dmg_int(b, 2, 6);
    float reach = radius * dmg_range(b, 2.5f, 5.0f), thin = radius * dmg_range(b, 0.2f, 0.4f);
    dmg_spin(b, parent, "windlass", at, v3(1, 0, 0));
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_rod(b, v3(-half, 0, 0), v3(half, 0, 0), radius);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(-0.3f * half, 0, 0), v3(0.3f * half, 0, 0), 1.25f * radius);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half, out = (float)s * (half + 2 * radius);
        if (s < 0 && kind == 1) continue;
        if (kind <= 1) { /* cranks, on the two ends or on one */
            dmg_box_span(b, v3(x - thin, -thin, -thin), v3(x + thin, reach, thin));
            dmg_rod(b, v3(x, reach - thin, 0), v3(out, reach - thin, 0), thin);
        }
        for (int i = 0; i < spikes && kind == 2; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / (float)spikes;
            dmg_rod(b, v3(x, 0, 0), v3(x, reach * cosf(angle), reach * sinf(angle)), thin);
        }
        if (kind == 3) {
            dmg_save(b);
            dmg_move(b, x, 0, 0);
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_wheel_draw(b, 3, reach, radius, 2 * spikes);
            dmg_restore(b);
        }
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* ---- cannon ---- */

/* Trunnions at the origin, muzzle to +Z. */
static void draw_barrel(dmg_builder* b, float length, float radius, float half) {
    float breech = -0.4f * length, muzzle = 0.6f * length, mouth = radius * dmg_range(b, 0.6f, 0.85f),
          bore = mouth * dmg_range(b, 0.4f, 0.7f), swell = mouth * dmg_range(b, 1.0f, 1.4f);
    const dmg_xy gun[] = {{0, breech},
                          {radius, breech},
                          {0.95f * radius, 0},
                          {mouth, muzzle - 0.12f * length},
                          {swell, muzzle - 0.04f * length},
                          {mouth, muzzle},
                          {bore, muzzle},
                          {bore, muzzle - 0.3f * length},
                          {0, muzzle - 0.3f * length}};
    bool low_poly = dmg_chance(b, 0.3f);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), gun, low_poly ? 6 : 9);
    if (low_poly) dmg_rod(b, v3(0, 0, 0.55f * length), v3(0, 0, muzzle), mouth);
    dmg_rod(b, v3(-half, 0, 0), v3(half, 0, 0), 0.28f * radius);
    if (dmg_chance(b, 0.7f)) { /* the knob behind */
        dmg_rod(b, v3(0, 0, breech - 0.5f * radius), v3(0, 0, breech), 0.25f * radius);
        dmg_ellipsoid(b, v3(0, 0, breech - 0.7f * radius), v3(0.4f * radius, 0.4f * radius, 0.4f * radius));
    }
    int rings = dmg_int(b, 0, 4);
    for (int i = 0; i < rings; ++i) {
        float z = breech + length * 0.2f * (float)i;
        dmg_rod(b, v3(0, 0, z), v3(0, 0, z + 0.03f * length), (1.1f - 0.05f * (float)i) * radius);
    }
}

/* Draws two cheeks on wheels with a trail, a low box on trucks, or a slide that turns on a pivot. Trunnions at `high`.
 */
static uint32_t draw_carriage(dmg_builder* b, int style, float length, float high, float half, float t) {
    float rear = -length * dmg_range(b, 0.5f, 1.3f), nose = length * dmg_range(b, 0.1f, 0.25f), wheel = 0.9f * high;
    uint32_t carrier = 0;
    if (style == 2) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.15f * high, 0), half + 2 * t);
        carrier = dmg_hinge(b, 0, "pivot", v3(0, 0, 0), v3(0, 1, 0), -dmg_range(b, 0.5f, DMG_PI), 2.0f);
        dmg_box_span(b, v3(-half - t, 0.15f * high, -0.5f * length), v3(half + t, 0.3f * high, nose));
    }
    for (int s = -1; s <= 1; s += 2) {
        float from = (float)s > 0 ? half : -half - t;
        dmg_save(b); /* the cheek's outline: x along +Z */
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        float base = style == 2 ? 0.3f * high : style == 1 ? 0.35f * high : 0.55f * high;
        const dmg_xy steps[] = {{-0.5f * length, base},         {nose, base},
                                {nose, 1.05f * high},           {-0.1f * length, 1.05f * high},
                                {-0.25f * length, 0.8f * high}, {-0.5f * length, 0.6f * high + 0.3f * base}};
        const dmg_xy trail[] = {{rear, 0},
                                {rear + 0.15f * length, 0},
                                {nose, 0.7f * high},
                                {nose, 1.05f * high},
                                {-0.1f * length, 1.05f * high},
                                {rear, 0.15f * high}};
        dmg_extrude(b, style == 0 ? trail : steps, 6, -from - t, -from);
        dmg_restore(b);
    }
    dmg_box_span(b, v3(-half, 0.6f * high, nose - t), v3(half, 0.7f * high, nose));
    if (style == 1) {
        dmg_box_span(b, v3(-half, 0.36f * high, -0.5f * length), v3(half, 0.45f * high, nose));
        float small = high * dmg_range(b, 0.15f, 0.24f);
        dmg_box_span(b, v3(-half - t, small, -0.4f * length), v3(half + t, 0.36f * high, -0.3f * length));
        dmg_box_span(b, v3(-half - t, small, nose - 0.15f * length), v3(half + t, 0.36f * high, nose - 0.05f * length));
        draw_running_gear(b, half + t, nose - 0.1f * length, -0.35f * length, small);
    } else if (style == 0) {
        dmg_box_span(b, v3(-half, 0.02f * high, rear), v3(half, 0.12f * high, rear + 0.1f * length));
        draw_running_gear(b, half + t, 0, 0, wheel);
    }
    return carrier;
}

static void draw_cannon(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.3f, 3.0f), radius = length * dmg_range(b, 0.07f, 0.16f),
          high = length * dmg_range(b, 0.3f, 0.5f), half = radius * dmg_range(b, 1.1f, 1.4f), t = 0.4f * radius;
    int style = dmg_int(b, 0, 2);
    uint32_t carrier = draw_carriage(b, style, length, high, half, t);
    float up = dmg_range(b, 0.15f, 0.5f), down = dmg_range(b, 0.0f, 0.15f);
    dmg_hinge(b, carrier, "barrel", v3(0, high, 0), v3(-1, 0, 0), -down, fminf(up, 0.3f * high / (0.4f * length)));
    dmg_save(b);
    dmg_move(b, 0, high, 0);
    draw_barrel(b, length, radius, half + t * dmg_range(b, 0.5f, 1.2f));
    dmg_restore(b);
    dmg_use(b, carrier);
    float z = -0.32f * length, top = high - 1.3f * radius, low = high * (style ? 0.5f : 0.42f);
    int aim = dmg_int(b, 0, 2);
    if (aim == 1 && top > low) { /* a screw under the breech */
        dmg_screw(b, carrier, "screw", v3(0, low, z), v3(0, 1, 0), 0.05f * radius, 0.0f, 4.0f * DMG_PI);
        dmg_rod(b, v3(0, low - 0.5f * radius, z), v3(0, top, z), 0.25f * radius);
        for (int i = 0; i < 2; ++i)
            dmg_beam(b, v3(i ? 0 : -0.7f * radius, low, i ? z - 0.7f * radius : z),
                     v3(i ? 0 : 0.7f * radius, low, i ? z + 0.7f * radius : z), 0.2f * radius, 0.2f * radius);
    }
    if (aim == 2) { /* a wedge under it */
        dmg_slide(b, carrier, "wedge", v3(0, 0, -1), 0.0f, 0.15f * length);
        dmg_box_span(b, v3(-0.5f * radius, low, z - 0.2f * length), v3(0.5f * radius, fmaxf(top, low + t), z));
        dmg_rod(b, v3(0, low + 0.3f * t, z - 0.35f * length), v3(0, low + 0.3f * t, z - 0.2f * length), 0.3f * t);
    }
    dmg_use(b, 0);
}

/* ---- ballista ---- */

/* Bow arms in upright skeins, each about an upright line, or a bow of one piece. */
static void draw_bow(dmg_builder* b, uint32_t parent, float wide, float y, float z, float t) {
    float span = wide * dmg_range(b, 1.5f, 3.0f), back = dmg_range(b, 0.1f, 0.6f), swing = dmg_range(b, 0.3f, 0.8f);
    if (dmg_chance(b, 0.3f)) {
        const dmg_vec bow[] = {{-span, y, z - 0.5f * wide},
                               {-0.6f * span, y, z - 0.1f * wide},
                               {0, y, z},
                               {0.6f * span, y, z - 0.1f * wide},
                               {span, y, z - 0.5f * wide}};
        dmg_sweep(b, bow, 5, 0.3f * t, 0.6f * t, false);
        return;
    }
    for (int k = 0; k < 2; ++k) dmg_box(b, v3(0, y + (k ? 3.0f : -3.0f) * t, z), v3(2.4f * wide, 0.8f * t, 3 * t));
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * wide;
        dmg_use(b, parent);
        dmg_rod(b, v3(x, y - 2.6f * t, z), v3(x, y + 2.6f * t, z), 0.7f * t);
        dmg_box(b, v3(x + (float)s * 1.4f * t, y, z + 1.2f * t), v3(0.5f * t, 6 * t, 0.5f * t));
        dmg_hinge(b, parent, "arm", v3(x, y, z), v3(0, (float)s, 0), 0.0f, swing);
        dmg_beam(b, v3(x - (float)s * 0.5f * t, y, z + 0.5f * t * back), v3(x + (float)s * span, y, z - back * span),
                 0.6f * t, 0.8f * t);
    }
    dmg_use(b, parent);
}

static void draw_ballista(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.4f, 3.0f), high = length * dmg_range(b, 0.25f, 0.7f),
          t = length * dmg_range(b, 0.025f, 0.05f), wide = length * dmg_range(b, 0.12f, 0.25f);
    int stand = dmg_int(b, 0, 2);
    if (stand == 0) { /* a post on feet */
        dmg_rod(b, v3(0, 0, 0), v3(0, high - 4 * t, 0), 1.2f * t);
        for (int i = 0; i < 3; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / 3.0f + 0.5f, c = cosf(angle), s = sinf(angle);
            dmg_beam(b, v3(0, 0.6f * high, 0), v3(0.5f * high * c, 0, 0.5f * high * s), t, t);
        }
    } else { /* a frame, on wheels or not */
        float floor = stand == 1 ? 0.0f : 0.3f * high;
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 1.5f * wide - t, floor, -0.4f * length),
                         v3((float)s * 1.5f * wide + t, floor + 2 * t, 0.4f * length));
        dmg_box_span(b, v3(-1.5f * wide, floor, -2 * t), v3(1.5f * wide, floor + 2 * t, 2 * t));
        dmg_box_span(b, v3(-1.5f * t, floor, -1.5f * t), v3(1.5f * t, high - 4 * t, 1.5f * t));
        if (stand == 2) draw_running_gear(b, 1.5f * wide + t, 0.3f * length, -0.3f * length, floor + t);
    }
    uint32_t head = 0;
    if (dmg_chance(b, 0.7f)) head = dmg_hinge(b, 0, "head", v3(0, high, 0), v3(0, 1, 0), -1.2f, 1.2f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 2 * t - 0.4f * t, high - 3.5f * t, -1.5f * t),
                     v3((float)s * 2 * t + 0.4f * t, high + t, 1.5f * t));
    dmg_box(b, v3(0, high - 3.5f * t, 0), v3(4.8f * t, t, 3 * t));
    uint32_t stock = dmg_hinge(b, head, "stock", v3(0, high, 0), v3(-1, 0, 0), -0.15f, dmg_range(b, 0.3f, 0.6f));
    dmg_rod(b, v3(-2.5f * t, high, 0), v3(2.5f * t, high, 0), 0.4f * t);
    dmg_box_span(b, v3(-1.4f * t, high - t, -0.55f * length), v3(1.4f * t, high + t, 0.45f * length));
    draw_bow(b, stock, wide, high + 2.5f * t, 0.35f * length, t);
    draw_windlass(b, stock, v3(0, high + 0.5f * t, -0.57f * length), 2.5f * t, 0.7f * t);
    dmg_use(b, stock);
    if (dmg_chance(b, 0.8f)) { /* the slider with its bolt */
        dmg_slide(b, stock, "slider", v3(0, 0, -1), 0.0f, 0.35f * length);
        dmg_box_span(b, v3(-0.8f * t, high + t, -0.1f * length), v3(0.8f * t, high + 1.8f * t, 0.4f * length));
        if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, high + 2.2f * t, 0), v3(0, high + 2.2f * t, 0.6f * length), 0.3f * t);
        dmg_box(b, v3(0, high + 2.2f * t, -0.08f * length), v3(1.2f * t, 1.2f * t, 1.5f * t));
    }
    dmg_use(b, 0);
}

/* ---- catapults and trebuchets: an arm about X between two frames ---- */

/* Draws a spoon, a bucket or a sling's hook at its end. */
static void draw_arm_end(dmg_builder* b, dmg_vec at, float t) {
    int kind = dmg_int(b, 0, 2);
    const dmg_xy cup[] = {
        {0, -1.2f * t}, {1.2f * t, -0.8f * t}, {2 * t, 0.8f * t}, {1.6f * t, 0.8f * t}, {0, -0.4f * t}};
    if (kind == 0) dmg_lathe(b, at, v3(0, 1, 0), cup, 5);
    if (kind == 1) dmg_box_faces(b, at, v3(3 * t, 1.5f * t, 3 * t), DMG_FACE_ALL & ~DMG_FACE_TOP);
    if (kind == 2) dmg_torus(b, at, v3(1, 0, 0), t, 0.3f * t);
    if (kind < 2 && dmg_chance(b, 0.4f)) dmg_ellipsoid(b, v3_mad(at, v3(0, 1, 0), t), v3(1.3f * t, 1.3f * t, 1.3f * t));
}

static void draw_catapult(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.3f, 4.0f), half = length * dmg_range(b, 0.15f, 0.28f),
          t = length * dmg_range(b, 0.02f, 0.04f), floor = length * dmg_range(b, 0.02f, 0.18f),
          high = length * dmg_range(b, 0.25f, 0.5f), arm = length * dmg_range(b, 0.5f, 0.75f);
    bool wheels = floor > 0.06f * length;
    float deck = floor + 2 * t, pin = deck + t * dmg_range(b, -0.5f, 2.0f), z = length * dmg_range(b, 0.0f, 0.15f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_box_span(b, v3(x - t, floor, -0.5f * length), v3(x + t, deck, 0.5f * length));
        dmg_box_span(b, v3(x - t, deck, z + 2.5f * t), v3(x + t, deck + high, z + 4.5f * t));
        dmg_beam(b, v3(x, deck, 0.48f * length), v3(x, deck + 0.9f * high, z + 4 * t), 1.4f * t, 1.4f * t);
        if (pin > deck) dmg_box_span(b, v3(x - t, deck, z - 1.5f * t), v3(x + t, pin + t, z + 1.5f * t));
    }
    for (int i = 0; i < 2; ++i)
        dmg_box_span(b, v3(-half, floor, (i ? 0.5f : -0.5f) * length - t),
                     v3(half, deck, (i ? 0.5f : -0.5f) * length + t));
    dmg_box_span(b, v3(-half - t, deck + high, z + 2.5f * t), v3(half + t, deck + high + 2 * t, z + 4.5f * t));
    if (wheels) draw_running_gear(b, half + t, 0.35f * length, -0.35f * length, floor + 0.5f * t);
    /* Drawn upright against the bar; hauled down behind. */
    float most = acosf(fminf(0.99f, (pin - deck + 3.0f * t) / arm));
    uint32_t lever = dmg_hinge(b, 0, "arm", v3(0, pin, z), v3(-1, 0, 0), 0.0f, fminf(1.3f, most));
    if (dmg_chance(b, 0.6f)) dmg_use(b, 0); /* a twisted rope from frame to frame, or an axle of its own */
    dmg_rod(b, v3(-half, pin, z), v3(half, pin, z), dmg_range(b, 0.6f, 1.4f) * t);
    dmg_use(b, lever);
    dmg_box_span(b, v3(-t, pin, z - t), v3(t, pin + arm, z + t));
    dmg_save(b);
    dmg_move(b, 0, pin + arm, z);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI * dmg_unit(b));
    draw_arm_end(b, v3(0, 0.5f * t, 0), 1.5f * t);
    dmg_restore(b);
    dmg_use(b, 0);
    float back = -0.5f * length + 4 * t;
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * half, deck + 1.5f * t, back), v3(1.2f * t, 3 * t, 3 * t));
    if (back < z - 0.3f * length) draw_windlass(b, 0, v3(0, deck + 1.7f * t, back), half + 1.5f * t, t);
}

static void draw_trebuchet(dmg_builder* b) {
    float high = dmg_scale_range(b, 0.3f, 6.0f), t = high * dmg_range(b, 0.025f, 0.05f),
          half = high * dmg_range(b, 0.12f, 0.25f), foot = high * dmg_range(b, 0.35f, 0.6f),
          small = high * dmg_range(b, 0.2f, 0.35f), tall = high * dmg_range(b, 0.9f, 1.3f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_box_span(b, v3(x - t, 0, -1.3f * foot), v3(x + t, 2 * t, 1.3f * foot));
        dmg_beam(b, v3(x, t, -foot), v3(x, high + t, 0), t, 1.5f * t);
        dmg_beam(b, v3(x, t, foot), v3(x, high + t, 0), t, 1.5f * t);
        if (dmg_chance(b, 0.6f)) dmg_beam(b, v3(x, 0.5f * high, -0.5f * foot), v3(x, 0.5f * high, 0.5f * foot), t, t);
    }
    for (int i = -1; i <= 1; ++i)
        dmg_box_span(b, v3(-half, 0, (float)i * 1.2f * foot - t), v3(half, 2 * t, (float)i * 1.2f * foot + t));
    /* The beam as it stands after the shot, its long end up; the weight hangs from the short one. */
    float swing = dmg_range(b, 1.2f, 2.0f);
    uint32_t beam = dmg_hinge(b, 0, "beam", v3(0, high, 0), v3(-1, 0, 0), -0.2f, swing);
    dmg_rod(b, v3(-half - 0.5f * t, high, 0), v3(half + 0.5f * t, high, 0), 0.6f * t);
    dmg_box_span(b, v3(-t, high - small, -t), v3(t, high + tall, t));
    draw_arm_end(b, v3(0, high + tall + t, 0), t);
    float y = high - small + t, box = 0.6f * half, drop = fminf(high - small - 3 * t, high * dmg_range(b, 0.3f, 0.55f));
    if (dmg_chance(b, 0.7f)) {
        dmg_hinge(b, beam, "weight", v3(0, y, 0), v3(1, 0, 0), -dmg_range(b, 0.3f, 1.2f), 1.2f);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 1.4f * t, y + t, 0), v3((float)s * 1.4f * t, y - 0.5f * drop, 0), 0.5f * t, t);
        dmg_rod(b, v3(-1.8f * t, y, 0), v3(1.8f * t, y, 0), 0.4f * t);
    } else {
        dmg_use(b, beam);
    }
    dmg_box_span(b, v3(-box, y - drop, -1.3f * box), v3(box, y - 0.45f * drop, 1.3f * box));
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * half, 3 * t, -1.1f * foot), v3(1.2f * t, 3 * t, 3 * t));
        draw_windlass(b, 0, v3(0, 3 * t, -1.1f * foot), half + 1.5f * t, 0.9f * t);
    }
}

void dmg_build_siege_engine(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){1.3f, 1, 1, 0.7f}, 4);
    if (kind == 0) draw_cannon(b);
    if (kind == 1) draw_ballista(b);
    if (kind == 2) draw_catapult(b);
    if (kind == 3) draw_trebuchet(b);
    dmg_use(b, 0);
}
