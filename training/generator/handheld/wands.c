/* Draws motion and play controllers of unusual bodies: flat pebbles, wands with a ball, bars with a key pad, rings
 * held by a spoke, light guns, halves joined by a band. +Y is forward, +Z out of the thumb's face. */
#include "core/build.h"
#include "parts/thumbs.h"

enum { ROUND = 20, LAYERS = 7 };

/* ---- bodies ---- */

/* A flat body seen from above: an outline carried down in layers that round its edges. */
typedef struct slab {
    float half_width, half_length, thick;
    float power;      /* of its outline: 2 an ellipse */
    float egg, waist; /* wider in front, narrower in the middle */
    float edge;       /* how much of the thickness is rounding */
} slab;

static slab pick_slab(dmg_builder* b, float length) {
    slab s = {.half_length = 0.5f * length, .power = dmg_range(b, 2.0f, 6.0f)};
    s.edge = dmg_range(b, 0.05f, 0.5f);
    s.half_width = s.half_length * dmg_range(b, 0.25f, 0.8f);
    s.thick = fminf(s.half_width, s.half_length * dmg_range(b, 0.2f, 0.5f));
    s.egg = dmg_range(b, -0.3f, 0.3f);
    s.waist = dmg_chance(b, 0.4f) ? dmg_range(b, 0.0f, 0.35f) : 0.0f;
    return s;
}

/* Half its width at `along` its half length. */
static float slab_width(const slab* s, float along) {
    float a = fminf(1.0f, fabsf(along)), round = powf(1.0f - powf(a, s->power), 1.0f / s->power);
    return s->half_width * round * (1.0f + s->egg * along) * (1.0f - s->waist * (1.0f - a * a));
}

/* Draws the layers between heights `low` and `high`, both shares of the thickness below the face. */
static void draw_slab(dmg_builder* b, const slab* s, float low, float high) {
    dmg_vec at[LAYERS * ROUND];
    for (int r = 0; r < LAYERS; ++r) {
        float share = low + (high - low) * (float)r / (LAYERS - 1), off = fabsf(2.0f * share - 1.0f);
        float over = fmaxf(0.0f, (off - 1.0f + 2.0f * s->edge) / (2.0f * s->edge)),
              in = 1.0f - 2.0f * s->edge * s->thick / s->half_length * (1.0f - sqrtf(fmaxf(0.0f, 1.0f - over * over)));
        for (int c = 0; c < ROUND; ++c) {
            float angle = -2.0f * DMG_PI * (float)c / ROUND, x = cosf(angle), y = sinf(angle);
            float along = copysignf(powf(fabsf(y), 2.0f / s->power), y);
            at[r * ROUND + c] = v3(copysignf(slab_width(s, along), x) * (fabsf(x) < 1e-4f ? 0.0f : 1.0f) * in,
                                   s->half_length * along * in, -share * s->thick);
        }
    }
    dmg_rows_draw(b, at, LAYERS, ROUND, DMG_ROWS_TUBE);
}

/* Draws one shell, two halves with a seam between, or a body with a face plate let in. */
static void draw_body(dmg_builder* b, const slab* s) {
    int kind = dmg_int(b, 0, 2);
    float seam = dmg_range(b, 0.35f, 0.65f), gap = dmg_range(b, 0.0f, 0.03f);
    if (kind == 1) {
        draw_slab(b, s, 0.0f, seam - gap);
        draw_slab(b, s, seam + gap, 1.0f);
        return;
    }
    draw_slab(b, s, 0.0f, 1.0f);
    if (kind == 2) {
        slab plate = *s;
        plate.half_width *= 0.8f;
        plate.half_length *= 0.85f;
        plate.thick *= 0.1f;
        dmg_move(b, 0, 0, plate.thick * 0.3f);
        draw_slab(b, &plate, 0.0f, 1.0f);
        dmg_move(b, 0, 0, -plate.thick * 0.3f);
    }
}

/* ---- what a finger pulls ---- */

/* Below the origin; hinged in front of or behind its root, or sliding, its construction told by what shows: ears and
 * a pin, a guard round it, a slot it runs in. */
static void draw_under_trigger(dmg_builder* b, uint32_t parent, const char* name, float width, float length) {
    int kind = dmg_int(b, 0, 4);
    float t = length * dmg_range(b, 0.1f, 0.25f), pull = dmg_range(b, 0.15f, 0.5f), half = 0.5f * width;
    dmg_use(b, parent);
    if (kind == 0) { /* a paddle between ears on a pin that shows, its free end to the rear: squeezed up */
        float droop = length * dmg_range(b, 0.15f, 0.5f);
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3((float)s * half, 0, -0.6f * t), v3((float)s * 1.25f * half, 0, -0.6f * t), 1.2f * t);
        dmg_hinge(b, parent, name, v3(0, 0, -0.6f * t), v3(-1, 0, 0), 0.0f, 0.8f * atanf(droop / length));
        dmg_rod(b, v3(-half, 0, -0.6f * t), v3(half, 0, -0.6f * t), 0.5f * t);
        dmg_beam(b, v3(0, 0.2f * t, -0.7f * t), v3(0, -length, -droop - 0.7f * t), 0.9f * width, 0.7f * t);
    }
    if (kind == 1 || kind == 2) { /* a blade that hooks to the front */
        const dmg_vec blade[] = {{0, 0.2f * t, 0.4f * t},
                                 {0, -0.2f * length, -0.4f * length},
                                 {0, -0.1f * length, -0.75f * length},
                                 {0, 0.2f * length, -length}};
        const dmg_vec guard[] = {{0, length, 0},
                                 {0, 0.9f * length, -1.2f * length},
                                 {0, 0, -1.5f * length},
                                 {0, -length, -1.2f * length},
                                 {0, -1.2f * length, 0}};
        if (kind == 2) dmg_sweep(b, guard, 5, 0.5f * t, 0.4f * width, false);
        float ahead = length * dmg_range(b, -0.2f, 0.2f), up = length * dmg_range(b, 0.0f, 0.4f);
        dmg_hinge(b, parent, name, v3(0, ahead, up), v3(-1, 0, 0), 0.0f, pull);
        dmg_sweep(b, blade, 4, t, 0.5f * width, false);
    }
    if (kind == 3) { /* a plunger that runs to the rear on a rail */
        dmg_box_span(b, v3(-0.3f * half, -length, -0.5f * t), v3(0.3f * half, 0.6f * length, 0.2f * t));
        dmg_slide(b, parent, name, v3(0, -1, 0), 0.0f, length * dmg_range(b, 0.2f, 0.5f));
        dmg_rounded_box(b, v3(0, 0, -0.6f * length), v3(width, 1.6f * t, length), 0.5f * t);
        dmg_box_span(b, v3(-0.4f * half, -0.4f * length, -t), v3(0.4f * half, 0.4f * t, -0.1f * t));
    }
    if (kind == 4) { /* a shell round the front */
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_turn(b, v3(0, 1, 0), DMG_PI);
        dmg_trigger_shell_draw(b, parent, name, width, length);
        dmg_restore(b);
    }
    dmg_use(b, parent);
}

/* Keys in front: two beside or above each other, pressed in, or tipping about an upright pin at the outer end. */
static void draw_bumpers(dmg_builder* b, const slab* s) {
    int count = dmg_int(b, 1, 2);
    float y = s->half_length, wide = s->half_width * dmg_range(b, 0.5f, 0.9f) / (float)count, deep = 0.25f * s->thick,
          high = s->thick * dmg_range(b, 0.3f, 0.5f);
    bool tips = dmg_chance(b, 0.5f);
    for (int i = 0; i < count; ++i) {
        float x = count == 1 ? 0.0f : (i ? 0.55f : -0.55f) * wide, side = x < 0 ? -1.0f : 1.0f;
        dmg_use(b, 0);
        if (tips)
            dmg_hinge(b, 0, "bumper", v3(x + side * 0.5f * wide, y, -0.5f * s->thick), v3(0, 0, side), 0.0f,
                      0.6f * deep / wide);
        else
            dmg_slide(b, 0, "bumper", v3(0, -1, 0), 0.0f, 0.5f * deep);
        dmg_rounded_box(b, v3(x, y, -0.5f * s->thick), v3(wide, 2 * deep, high), 0.4f * deep);
    }
    dmg_use(b, 0);
}

/* ---- what a thumb moves, on the face ---- */

/* Draws a cross that tips about one of its lines, or four keys round a point. */
static void draw_cross(dmg_builder* b, float radius) {
    float rise = radius * dmg_range(b, 0.15f, 0.4f), arm = radius * dmg_range(b, 0.25f, 0.4f);
    if (dmg_chance(b, 0.4f)) {
        for (int i = 0; i < 4; ++i) {
            float angle = 0.5f * DMG_PI * (float)i;
            dmg_save(b);
            dmg_move(b, 0.65f * radius * cosf(angle), 0.65f * radius * sinf(angle), 0);
            dmg_thumb_key_draw(b, 0, "key", 0.3f * radius);
            dmg_restore(b);
        }
        return;
    }
    if (dmg_chance(b, 0.5f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.15f * radius, 0.1f * radius);
    bool across = dmg_chance(b, 0.5f);
    dmg_hinge(b, 0, "cross", v3(0, 0, -rise * dmg_range(b, 0.0f, 1.5f)), across ? v3(1, 0, 0) : v3(0, 1, 0), -0.15f,
              0.15f);
    const dmg_xy plus[] = {{arm, -radius}, {arm, -arm}, {radius, -arm}, {radius, arm},   {arm, arm},   {arm, radius},
                           {-arm, radius}, {-arm, arm}, {-radius, arm}, {-radius, -arm}, {-arm, -arm}, {-arm, -radius}};
    dmg_extrude(b, plus, 12, -0.3f * rise, rise);
    dmg_use(b, 0);
}

/* Draws a row of things along the face from front to rear, as much as there is room for. */
static void draw_face(dmg_builder* b, const slab* s) {
    float y = 0.7f * s->half_length, end = -0.8f * s->half_length;
    for (int i = 0; i < 5 && y > end; ++i) {
        float r = 0.5f * slab_width(s, y / s->half_length) * dmg_range(b, 0.5f, 1.3f);
        int kind = i == 0 ? dmg_int(b, 0, 2) : dmg_int(b, 0, 6);
        if (kind >= 3) r *= 0.45f;
        y -= r;
        if (y - r < end) break;
        dmg_save(b);
        dmg_move(b, 0, y, 0);
        if (kind == 0) draw_cross(b, 0.9f * r);
        if (kind == 1) dmg_thumb_stick_draw(b, 0, 0.7f * r);
        if (kind == 2) dmg_touch_pad_draw(b, 0, r);
        for (int k = -1; k <= 1 && kind >= 3; ++k) { /* one, two or three side by side */
            if ((kind == 3 && k) || (kind == 4 && !k)) continue;
            if (kind == 6 && k) continue;
            dmg_save(b);
            dmg_move(b, 2.0f * r * (float)k, 0, 0);
            dmg_thumb_key_draw(b, 0, k ? "menu" : "key", 0.8f * r);
            dmg_restore(b);
        }
        dmg_restore(b);
        y -= r * dmg_range(b, 1.2f, 2.0f);
    }
    dmg_use(b, 0);
}

/* Pressed in at the side, or a flap hinged in front or behind. */
static void draw_grip_key(dmg_builder* b, float half_width, float y, float thick, float side) {
    float length = thick * dmg_range(b, 0.6f, 1.5f), rise = 0.15f * half_width,
          high = thick * dmg_range(b, 0.25f, 0.5f);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, 0, "grip", v3(-side, 0, 0), 0.0f, rise * dmg_range(b, 0.3f, 0.8f));
    } else {
        float end = dmg_sign(b);
        dmg_hinge(b, 0, "grip", v3(side * half_width, y + 0.5f * end * length, -0.5f * thick), v3(0, 0, -end * side),
                  0.0f, 0.7f * rise / length);
    }
    dmg_rounded_box(b, v3(side * half_width, y, -0.5f * thick), v3(2 * rise, length, high), 0.4f * rise);
    dmg_use(b, 0);
}

/* ---- styles ---- */

/* Draws the lid over the batteries, slid off to the rear or swung about its front edge. */
static void draw_battery_lid(dmg_builder* b, const slab* s) {
    float width = 1.3f * s->half_width * (1.0f - s->waist), length = s->half_length * dmg_range(b, 0.4f, 0.8f),
          t = 0.08f * s->thick, y = -0.8f * s->half_length;
    if (dmg_chance(b, 0.6f))
        dmg_slide(b, 0, "battery_lid", v3(0, -1, 0), 0.0f, 0.8f * length);
    else
        dmg_hinge(b, 0, "battery_lid", v3(0, y + length, -s->thick - 0.5f * t), v3(1, 0, 0), 0.0f, 1.6f);
    dmg_box_span(b, v3(-0.5f * width, y, -s->thick - t), v3(0.5f * width, y + length, -s->thick));
    dmg_use(b, 0);
}

static void draw_pebble(dmg_builder* b, float size) {
    slab s = pick_slab(b, size);
    draw_body(b, &s);
    draw_face(b, &s);
    int front = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, 0, s.half_length * dmg_range(b, 0.2f, 0.6f), -s.thick);
    float wide = s.half_width * dmg_range(b, 0.5f, 1.0f), reach = s.half_length * dmg_range(b, 0.25f, 0.45f);
    if (front < 2) draw_under_trigger(b, 0, "trigger", wide, reach);
    dmg_restore(b);
    if (front > 0) draw_bumpers(b, &s);
    float y = -s.half_length * dmg_range(b, 0.0f, 0.5f), side = dmg_sign(b);
    if (dmg_chance(b, 0.5f)) draw_grip_key(b, slab_width(&s, y / s.half_length), y, s.thick, side);
    if (dmg_chance(b, 0.3f)) draw_battery_lid(b, &s);
    if (!dmg_chance(b, 0.5f)) return;
    /* A ring in front, over or under the hand. */
    float r = s.half_width * dmg_range(b, 1.3f, 2.2f), tube = r * dmg_range(b, 0.06f, 0.16f),
          lean = dmg_range(b, 0.0f, 1.5f);
    dmg_torus(b, v3(0, s.half_length * 0.8f + 0.3f * r, dmg_range(b, -1.2f, 0.6f) * s.thick),
              v3(0, sinf(lean), cosf(lean)), r, tube);
}

/* Draws a tube with a ball, a crystal or a star at its end; keys along its top, a trigger below. */
static void draw_wand(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.06f, 0.1f), front = 0.45f * size, rear = -0.55f * size,
          tip = r * dmg_range(b, 0.8f, 1.6f);
    const dmg_xy tube[] = {
        {0, rear},         {0.8f * r, rear}, {r, rear + 0.3f * size}, {r * dmg_range(b, 0.8f, 1.1f), 0}, {r, front - r},
        {0.5f * r, front}, {0, front}};
    dmg_lathe(b, v3(0, 0, -r), v3(0, 1, 0), tube, 7);
    int end = dmg_int(b, 0, 3);
    dmg_vec at = v3(0, front + 0.7f * tip, -r);
    if (end == 0) dmg_ellipsoid(b, at, v3(tip, tip, tip));
    if (end == 1) dmg_cone(b, v3(0, front, -r), v3(0, front + 2 * tip, -r), 0.8f * tip, 0);
    if (end == 2) dmg_torus(b, at, v3(1, 0, 0), 1.2f * tip, 0.3f * tip);
    slab s = {.half_width = 1.1f * r, .half_length = 0.35f * size, .thick = 2 * r, .power = 4};
    dmg_save(b);
    dmg_move(b, 0, 0.05f * size, -0.03f * r);
    if (dmg_chance(b, 0.5f)) {
        dmg_rounded_box(b, v3(0, 0, -0.2f * r), v3(1.2f * r, 0.7f * size, 0.5f * r), 0.15f * r);
        dmg_move(b, 0, 0, 0.05f * r);
    }
    draw_face(b, &s);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, size * dmg_range(b, 0.1f, 0.3f), -1.95f * r);
    draw_under_trigger(b, 0, "trigger", 1.2f * r, size * dmg_range(b, 0.08f, 0.16f));
    dmg_restore(b);
    if (dmg_chance(b, 0.4f)) draw_grip_key(b, r, -0.1f * size, 2 * r, dmg_sign(b));
    if (!dmg_chance(b, 0.3f)) return;
    dmg_screw(b, 0, "cap", v3(0, rear, -r), v3(0, -1, 0), 0.1f * r, 0.0f, 4.0f * DMG_PI);
    dmg_rod(b, v3(0, rear - 0.5f * r, -r), v3(0, rear, -r), 0.85f * r);
    dmg_use(b, 0);
}

/* Draws a hoop to look through, held by a spoke across it or by a handle under it. */
static void draw_hoop(dmg_builder* b, float size) {
    float r = 0.4f * size, tube = r * dmg_range(b, 0.08f, 0.18f), lean = dmg_range(b, -0.4f, 0.8f);
    dmg_vec axis = {0, cosf(lean), sinf(lean)};
    dmg_torus(b, v3(0, 0, 0), axis, r, tube);
    slab s = {.half_width = r * dmg_range(b, 0.22f, 0.32f), .edge = 0.3f};
    s.half_length = r * dmg_range(b, 0.7f, 0.95f);
    s.power = dmg_range(b, 2.0f, 5.0f);
    s.thick = 1.6f * s.half_width;
    dmg_save(b);
    bool across = dmg_chance(b, 0.5f);
    dmg_turn(b, v3(1, 0, 0), across ? 0.5f * DMG_PI + lean : lean * 0.5f);
    dmg_move(b, 0, across ? 0 : -0.9f * r - 0.5f * s.half_length, 0.5f * s.thick);
    draw_body(b, &s);
    draw_face(b, &s);
    dmg_move(b, 0, s.half_length * dmg_range(b, 0.0f, 0.4f), -s.thick);
    draw_under_trigger(b, 0, "trigger", 1.2f * s.half_width, s.half_length * dmg_range(b, 0.3f, 0.5f));
    dmg_restore(b);
}

/* Barrel and raked grip: the trigger before the grip, a slide or a pump along the barrel, the thumb's things behind. */
static void draw_light_gun(dmg_builder* b, float size) {
    float half = size * dmg_range(b, 0.06f, 0.1f), high = half * dmg_range(b, 1.6f, 3.0f),
          rake = dmg_range(b, 0.05f, 0.5f), grip = size * dmg_range(b, 0.35f, 0.5f), rear = -0.35f * size,
          front = size * dmg_range(b, 0.3f, 0.65f);
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-half, rear, -high), v3(half, front, 0));
    else
        dmg_rounded_box(b, v3(0, 0.5f * (rear + front), -0.5f * high), v3(2 * half, front - rear, high), 0.5f * half);
    dmg_cone(b, v3(0, front, -0.4f * high), v3(0, front + 0.15f * size, -0.4f * high), 0.35f * high,
             0.3f * high * dmg_range(b, 0.5f, 1.6f));
    dmg_vec foot = {0, rear + 0.12f * size - rake * grip, -0.7f * high - grip};
    dmg_beam(b, v3(0, rear + 0.12f * size, -0.7f * high), foot, 1.7f * half, 0.16f * size);
    dmg_save(b);
    dmg_move(b, 0, rear + 0.32f * size, -high);
    draw_under_trigger(b, 0, "trigger", half, size * dmg_range(b, 0.1f, 0.16f));
    dmg_restore(b);
    int moves = dmg_int(b, 0, 3);
    if (moves == 1) { /* the upper half slides to the rear */
        dmg_slide(b, 0, "slide", v3(0, -1, 0), 0.0f, 0.15f * size);
        dmg_box_span(b, v3(-1.1f * half, rear, 0), v3(1.1f * half, front, 0.4f * high));
    } else if (moves == 2) {
        float from = 0.15f * size, way = 0.1f * size;
        dmg_slide(b, 0, "pump", v3(0, -1, 0), 0.0f, way);
        dmg_rounded_box(b, v3(0, from + way, -1.1f * high), v3(2.2f * half, 0.2f * size, 0.7f * high), 0.2f * half);
    } else if (moves == 3) { /* tipped open for new caps */
        dmg_hinge(b, 0, "lid", v3(0, front, 0), v3(1, 0, 0), -dmg_range(b, 0.8f, 1.4f), 0.0f);
        dmg_box_span(b, v3(-half, 0.2f * size + rear, 0), v3(half, front, 0.25f * high));
    }
    dmg_use(b, 0);
    dmg_save(b); /* behind, where the thumb lies */
    dmg_move(b, 0, rear, -0.4f * high);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    if (dmg_chance(b, 0.5f))
        dmg_thumb_stick_draw(b, 0, 0.6f * half);
    else
        dmg_thumb_key_draw(b, 0, "key", 0.5f * half);
    dmg_restore(b);
    if (!dmg_chance(b, 0.5f)) return;
    dmg_vec down = v3_normalize(v3_sub(foot, v3(0, rear + 0.12f * size, -0.7f * high)));
    dmg_slide(b, 0, "magazine", down, 0.0f, 0.6f * grip);
    dmg_beam(b, v3_mad(foot, down, -0.3f * grip), v3_mad(foot, down, 0.06f * grip), 1.2f * half, 0.1f * size);
    dmg_use(b, 0);
}

/* Draws two halves on a bar or a band, each with a stick or keys; a half slides off its rail. */
static void draw_halves(dmg_builder* b, float size) {
    slab s = pick_slab(b, 0.6f * size);
    s.egg = 0;
    s.half_width = fmaxf(s.half_width, 0.5f * s.half_length);
    float apart = s.half_width * dmg_range(b, 1.6f, 3.0f), rail = 0.06f * size;
    bool slides = dmg_chance(b, 0.5f);
    dmg_rounded_box(b, v3(0, 0, -0.5f * s.thick),
                    v3(2 * apart - 1.6f * s.half_width, 1.2f * s.half_length, 0.8f * s.thick), 0.1f * s.thick);
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * apart;
        uint32_t half = 0;
        dmg_use(b, 0);
        if (slides) {
            dmg_box(b, v3(x - (float)k * 0.9f * s.half_width, 0, -0.5f * s.thick),
                    v3(rail, 1.2f * s.half_length, 0.3f * s.thick));
            half = dmg_slide(b, 0, "half", v3(0, 1, 0), 0.0f, 1.2f * s.half_length);
        } else if (dmg_chance(b, 0.4f)) { /* it folds on its band */
            half =
                dmg_hinge(b, 0, "half", v3(x - (float)k * s.half_width, 0, -s.thick), v3(0, -(float)k, 0), -1.2f, 0.3f);
        }
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        draw_body(b, &s);
        float r = 0.35f * s.half_width, y = 0.35f * s.half_length * dmg_sign(b);
        dmg_move(b, 0, y, 0);
        dmg_thumb_stick_draw(b, half, r);
        dmg_move(b, 0, -2 * y, 0);
        dmg_thumb_key_draw(b, half, "key", 0.6f * r);
        dmg_restore(b);
        dmg_save(b);
        dmg_move(b, x, 0.5f * s.half_length, -s.thick);
        if (dmg_chance(b, 0.6f)) draw_under_trigger(b, half, "trigger", 0.8f * s.half_width, 0.35f * s.half_length);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_wand_controller(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.08f, 0.3f);
    int kind = dmg_weighted(b, (const float[]){1.5f, 1, 0.8f, 1, 0.8f}, 5);
    dmg_turn(b, v3(1, 0, 0), dmg_range(b, -0.5f, 0.5f) - 0.5f * DMG_PI);
    dmg_turn(b, v3(0, 0, 1), DMG_PI);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    if (kind == 0) draw_pebble(b, size);
    if (kind == 1) draw_wand(b, size);
    if (kind == 2) draw_hoop(b, size);
    if (kind == 3) draw_light_gun(b, size);
    if (kind == 4) draw_halves(b, size);
    dmg_use(b, 0);
}
