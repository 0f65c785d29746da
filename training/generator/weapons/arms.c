/* Draws arms as first-person games model them: revolvers, bolt, pump and break-action guns, carbines with magazine,
 * cover and folding stock, flintlocks, crossbows. The muzzle is at +Z, the line of the barrel y = 0. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* Draws an outline in (z, y) from x = -half to half. */
static void draw_side(dmg_builder* b, const dmg_xy* outline, int count, float half) {
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_extrude(b, outline, count, -half, half);
    dmg_restore(b);
}

/* Draws a blade curved to the front under its pin, in a guard or bare. */
static void draw_trigger(dmg_builder* b, uint32_t parent, dmg_vec pin, float length, float half, bool guard) {
    dmg_use(b, parent);
    if (guard) {
        float y = pin.y, low = y - 1.5f * length, z = pin.z;
        const dmg_vec loop[] = {{0, y, z - 1.1f * length},
                                {0, low + 0.4f * length, z - length},
                                {0, low, z - 0.2f * length},
                                {0, low + 0.3f * length, z + length},
                                {0, y, z + 1.4f * length}};
        dmg_sweep(b, loop, 5, 0.07f * length, 0.8f * half, false);
    }
    float up = length * dmg_range(b, -0.1f, 0.5f), ahead = length * dmg_range(b, -0.3f, 0.3f),
          pull = dmg_range(b, 0.15f, 0.5f);
    dmg_vec at = v3(0, pin.y + up, pin.z + ahead);
    if (dmg_chance(b, 0.15f))
        dmg_slide(b, parent, "trigger", v3(0, 0, -1), 0.0f, 0.3f * length);
    else
        dmg_hinge(b, parent, "trigger", at, v3(1, 0, 0), 0.0f, pull);
    float hook = length * dmg_range(b, 0.0f, 0.4f), t = length * dmg_range(b, 0.1f, 0.2f);
    const dmg_xy blade[] = {{pin.z - t, pin.y + 0.3f * length},
                            {pin.z - t - 0.3f * hook, pin.y - 0.5f * length},
                            {pin.z + hook - t, pin.y - length},
                            {pin.z + hook + 0.4f * t, pin.y - length},
                            {pin.z + t - 0.3f * hook, pin.y - 0.5f * length},
                            {pin.z + t, pin.y + 0.3f * length}};
    draw_side(b, blade, 6, half * dmg_range(b, 0.3f, 0.8f));
    dmg_use(b, parent);
}

/* Cocked back about its foot, at the frame's rear. */
static void draw_hammer(dmg_builder* b, uint32_t parent, dmg_vec foot, float length, float half) {
    float spur = length * dmg_range(b, 0.2f, 0.6f), cock = dmg_range(b, 0.5f, 1.1f);
    dmg_hinge(b, parent, "hammer", foot, v3(-1, 0, 0), 0.0f, cock);
    float y = foot.y, z = foot.z, t = 0.18f * length;
    const dmg_xy side[] = {{z - t, y - t},
                           {z + t, y - t},
                           {z + t, y + length},
                           {z - 0.5f * t, y + length},
                           {z - spur, y + 1.05f * length},
                           {z - spur, y + 0.9f * length},
                           {z - t, y + 0.75f * length}};
    dmg_save(b);
    dmg_move(b, foot.x, 0, 0);
    draw_side(b, side, 7, half);
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Draws a grip for one hand, raked to the rear, its top at (z, y). */
static void draw_grip(dmg_builder* b, float z, float y, float length, float deep, float half) {
    float rake = dmg_range(b, 0.1f, 0.5f) * length, flare = deep * dmg_range(b, 0.9f, 1.5f);
    const dmg_xy side[] = {{z - rake - 0.6f * flare, y - length},
                           {z - rake + 0.4f * flare, y - length},
                           {z - 0.4f * rake + 0.4f * deep, y - 0.4f * length},
                           {z + 0.5f * deep, y},
                           {z - 0.5f * deep, y},
                           {z - 0.5f * rake - 0.5f * deep, y - 0.4f * length}};
    draw_side(b, side, 6, half);
}

/* Draws a butt for the shoulder from z rearwards, of wood in one piece or with a thin wrist. */
static void draw_butt(dmg_builder* b, float z, float y, float length, float high, float half) {
    float drop = length * dmg_range(b, 0.08f, 0.22f), end = z - length, wrist = high * dmg_range(b, 0.5f, 0.9f);
    const dmg_xy side[] = {{end, y - drop - 1.3f * high},
                           {z - 0.45f * length, y - 0.6f * drop - 0.6f * wrist},
                           {z - 0.2f * length, y - wrist},
                           {z, y - high},
                           {z, y},
                           {z - 0.25f * length, y - 0.3f * drop},
                           {end, y - drop + 0.2f * high}};
    draw_side(b, side, 7, half);
}

static void draw_sights(dmg_builder* b, float rear, float front, float y, float size) {
    dmg_box_span(b, v3(-0.15f * size, y, front - size), v3(0.15f * size, y + size, front));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.4f * size, y + 0.4f * size, rear), v3(0.3f * size, 0.8f * size, 0.5f * size));
}

/* ---- revolver ---- */

/* About the line (x, y) along Z, from z to z + length: a drum with flutes or chambers. */
static void draw_drum(dmg_builder* b, float x, float y, float z, float length, float radius) {
    enum { LOBES = 6, POINTS = 36 };
    dmg_save(b);
    dmg_move(b, x, y, z);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, length), 0.2f * radius);
    if (dmg_chance(b, 0.5f)) {
        dmg_xy outline[POINTS];
        for (int i = 0; i < POINTS; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / POINTS, r = radius * (0.95f + 0.05f * cosf(LOBES * angle));
            outline[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
        }
        dmg_extrude(b, outline, POINTS, 0.02f * length, 0.98f * length);
    } else {
        dmg_rod(b, v3(0, 0, 0.02f * length), v3(0, 0, 0.98f * length), radius);
    }
    int chambers = dmg_chance(b, 0.6f) ? dmg_int(b, 5, 8) : 0;
    for (int i = 0; i < chambers; ++i) {
        dmg_turn_to(b, v3(0, 0, 1), 1, chambers);
        dmg_rod(b, v3(0.65f * radius, 0, -0.01f * length), v3(0.65f * radius, 0, 0.995f * length), 0.2f * radius);
    }
    dmg_restore(b);
}

static void draw_revolver(dmg_builder* b, float size) {
    float drum = size * dmg_range(b, 0.07f, 0.1f), long_ = drum * dmg_range(b, 1.6f, 2.4f), half = 0.4f * drum,
          barrel = size * dmg_range(b, 0.25f, 0.7f), bore = 0.25f * drum, y = -0.65f * drum, t = 0.3f * drum;
    float low = y - 1.05f * drum - t, rear = -0.7f * drum;
    int action = dmg_int(b, 0, 2); /* a drum that swings out, spins in a fixed frame, or tips with the barrel */
    dmg_box_span(b, v3(-half, low, rear), v3(half, low + t, long_ + 0.02f * drum));
    dmg_box_span(b, v3(-half, low, rear), v3(half, bore + t, -0.02f * drum));
    draw_grip(b, rear + 0.3f * drum, low + 0.5f * drum, size * dmg_range(b, 0.3f, 0.45f), 1.1f * drum, 0.9f * half);
    uint32_t carrier = 0;
    float front = long_ + 0.02f * drum;
    if (action == 2)
        carrier = dmg_hinge(b, 0, "barrel", v3(0, low + 0.5f * t, front + 0.2f * t), v3(1, 0, 0), 0.0f,
                            dmg_range(b, 0.7f, 1.5f));
    dmg_box_span(b, v3(-half, low + t, front), v3(half, bore + t, front + 0.5f * drum));
    dmg_box_span(b, v3(-half, bore, 0), v3(half, bore + t, front));
    dmg_cone(b, v3(0, 0, front), v3(0, 0, front + barrel), 1.7f * bore, 1.4f * bore);
    if (dmg_chance(b, 0.5f)) dmg_box_span(b, v3(-0.5f * bore, y, front), v3(0.5f * bore, 0, front + 0.9f * barrel));
    draw_sights(b, 0.1f * drum, front + barrel, bore + t, 0.35f * drum);
    dmg_use(b, carrier);
    uint32_t crane = carrier;
    if (action == 0) {
        float side = dmg_sign(b), x = side * 0.5f * half, line = low + t * dmg_range(b, 0.4f, 1.1f);
        crane = dmg_hinge(b, 0, "crane", v3(x, line, 0), v3(0, 0, -side), 0.0f, dmg_range(b, 1.2f, 1.7f));
        dmg_box_span(b, v3(-0.5f * half, line, front - 0.25f * t), v3(0.5f * half, y, front - 0.02f * drum));
        dmg_rod(b, v3(0, y, front - 0.3f * t), v3(0, y, front + 0.5f * barrel), 0.15f * drum);
    }
    dmg_spin(b, crane, "drum", v3(0, y, 0), v3(0, 0, 1));
    draw_drum(b, 0, y, 0, 0.97f * long_, drum);
    dmg_use(b, 0);
    draw_hammer(b, 0, v3(0, y, rear), 1.2f * drum + bore, 0.4f * half);
    draw_trigger(b, 0, v3(0, low, 0.3f * long_), 0.6f * drum, half, dmg_chance(b, 0.85f));
    if (action == 1 && dmg_chance(b, 0.7f)) { /* the gate beside the drum */
        dmg_hinge(b, 0, "gate", v3(1.02f * half, y - 0.5f * drum, 0), v3(0, 0, -1), 0.0f, 1.4f);
        dmg_box_span(b, v3(1.02f * half, y - 0.5f * drum, -0.3f * drum),
                     v3(1.02f * half + 0.5f * drum, 0.2f * bore, -0.05f * drum));
        dmg_use(b, 0);
    }
}

/* ---- long guns of wood ---- */

static void draw_bolt(dmg_builder* b, float length, float r, float half) {
    float reach = r * dmg_range(b, 3.0f, 5.0f), z = -0.05f * length, side = 1.0f, drop = dmg_range(b, 0.2f, 0.9f);
    /* One body, two motions in life: it is lifted, then drawn; here one of them. */
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, 0, "bolt", v3(0, 0, -1), 0.0f, 0.1f * length);
        drop = dmg_range(b, -0.6f, 0.2f);
    } else {
        dmg_hinge(b, 0, "bolt", v3(0, 0, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.8f, 1.4f));
    }
    dmg_rod(b, v3(0, 0, -0.13f * length), v3(0, 0, 0.06f * length), 0.75f * r);
    dmg_vec end = {side * (half + reach * cosf(drop)), -reach * sinf(drop), z - 0.3f * reach};
    dmg_rod(b, v3(0, 0, z), end, 0.35f * r);
    dmg_ellipsoid(b, end, v3(0.8f * r, 0.8f * r, 0.8f * r));
    dmg_use(b, 0);
}

static void draw_rifle(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.012f, 0.018f), barrel = size * dmg_range(b, 0.4f, 0.6f), half = 1.5f * r,
          high = 3.2f * r, rear = -0.12f * size;
    const dmg_xy fore[] = {{rear, -1.2f * high},
                           {0.1f * size, -1.2f * high},
                           {0.8f * barrel, -high},
                           {0.8f * barrel, -0.8f * r},
                           {rear, -0.8f * r}};
    draw_side(b, fore, 5, half);
    draw_butt(b, rear, -0.8f * r, size * dmg_range(b, 0.28f, 0.36f), high, half);
    dmg_cone(b, v3(0, 0, 0.06f * size), v3(0, 0, barrel), 0.9f * r, 0.6f * r);
    dmg_lathe_arc(b, v3(0, 0, rear), v3(0, 0, 1),
                  (const dmg_xy[]){
                      {0.8f * r, 0}, {1.1f * r, 0}, {1.1f * r, 0.18f * size}, {0.8f * r, 0.18f * size}, {0.8f * r, 0}},
                  5, 0, 2.0f * DMG_PI);
    draw_bolt(b, size, r, 0.5f * r);
    draw_trigger(b, 0, v3(0, -1.2f * high, -0.04f * size), 0.035f * size, half, true);
    if (dmg_chance(b, 0.5f)) { /* a scope */
        float y = 3.5f * r, tube = 1.2f * r;
        dmg_rod(b, v3(0, y, -0.1f * size), v3(0, y, 0.12f * size), tube);
        dmg_cone(b, v3(0, y, 0.08f * size), v3(0, y, 0.18f * size), tube, 2 * tube);
        for (int i = 0; i < 2; ++i) dmg_box(b, v3(0, 0.5f * y, i ? 0.06f * size : -0.06f * size), v3(r, y, r));
        dmg_spin(b, 0, "turret", v3(0, y, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, y, 0), v3(0, y + 2 * tube, 0), 0.7f * tube);
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.6f)) return;
    bool drops = dmg_chance(b, 0.5f); /* a magazine that comes out, or a floor plate on a hinge */
    float z = 0.0f, deep = 0.08f * size, y = -1.2f * high;
    if (drops)
        dmg_slide(b, 0, "magazine", v3(0, -1, 0), 0.0f, 0.06f * size);
    else
        dmg_hinge(b, 0, "floor_plate", v3(0, y, z + 0.02f * size + deep), v3(-1, 0, 0), 0.0f, 1.4f);
    dmg_box_span(b, v3(-0.6f * half, y - (drops ? 0.05f * size : 0.3f * r), z + 0.02f * size),
                 v3(0.6f * half, drops ? y + r : y, z + 0.02f * size + deep));
    dmg_use(b, 0);
}

static void draw_pump_gun(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.012f, 0.018f), barrel = size * dmg_range(b, 0.4f, 0.6f), half = 1.3f * r,
          low = -4.5f * r, grip = dmg_range(b, 0.13f, 0.2f) * size, way = dmg_range(b, 0.06f, 0.1f) * size;
    dmg_box_span(b, v3(-half, low, -0.14f * size), v3(half, 1.2f * r, 0.06f * size));
    dmg_rod(b, v3(0, 0, 0.06f * size), v3(0, 0, barrel), r);
    dmg_rod(b, v3(0, -2.2f * r, 0.06f * size), v3(0, -2.2f * r, 0.85f * barrel), 0.9f * r);
    if (dmg_chance(b, 0.7f))
        draw_butt(b, -0.14f * size, 0, size * dmg_range(b, 0.25f, 0.36f), 3.5f * r, half);
    else
        draw_grip(b, -0.1f * size, low, 0.13f * size, 0.05f * size, half);
    draw_trigger(b, 0, v3(0, low, -0.05f * size), 0.035f * size, half, true);
    dmg_slide(b, 0, "pump", v3(0, 0, -1), 0.0f, way);
    float from = 0.06f * size + way + 0.01f * size, y = -2.2f * r;
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_rod(b, v3(0, y, from), v3(0, y, from + grip), 1.9f * r);
    if (kind == 1) dmg_rounded_box(b, v3(0, y - 0.2f * r, from + 0.5f * grip), v3(4 * r, 3.4f * r, grip), 0.8f * r);
    for (int i = 0; i < 7 && kind == 2; ++i) /* ribbed */
        dmg_rod(b, v3(0, y, from + grip * (float)i / 7.0f), v3(0, y, from + grip * ((float)i + 0.7f) / 7.0f), 1.9f * r);
    if (kind == 2) dmg_rod(b, v3(0, y, from), v3(0, y, from + grip), 1.6f * r);
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.5f)) return;
    dmg_hinge(b, 0, "loading_gate", v3(0, low, 0.04f * size), v3(1, 0, 0), 0.0f, 0.25f);
    dmg_box_span(b, v3(-0.7f * half, low - 0.2f * r, -0.02f * size), v3(0.7f * half, low, 0.04f * size));
    dmg_use(b, 0);
}

static void draw_break_gun(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.012f, 0.02f), barrel = size * dmg_range(b, 0.25f, 0.6f), apart = 1.05f * r,
          low = -3.5f * r, pin = size * dmg_range(b, 0.05f, 0.09f);
    bool beside = dmg_chance(b, 0.6f), pair = dmg_chance(b, 0.75f);
    float half = beside && pair ? 2.1f * r : 1.3f * r;
    dmg_box_span(b, v3(-half, low, -0.05f * size), v3(half, -1.05f * r, pin));
    dmg_box_span(b, v3(-half, low, -0.05f * size), v3(half, 0.9f * r, -0.005f * size));
    if (dmg_chance(b, 0.7f))
        draw_butt(b, -0.05f * size, 0.2f * r, size * dmg_range(b, 0.25f, 0.38f), 3.2f * r, 0.8f * half);
    else
        draw_grip(b, -0.03f * size, low + r, 0.12f * size, 0.06f * size, 0.8f * half);
    dmg_hinge(b, 0, "barrels", v3(0, low + 0.8f * r, pin + 0.4f * r), v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.0f));
    for (int i = 0; i < (pair ? 2 : 1); ++i) {
        float shift = pair ? (i ? apart : -apart) : 0.0f;
        dmg_rod(b, v3(beside ? shift : 0, beside ? 0 : shift + apart, 0),
                v3(beside ? shift : 0, beside ? 0 : shift + apart, barrel), r);
    }
    dmg_box_span(b, v3(-0.8f * half, low, pin + 0.4f * r),
                 v3(0.8f * half, -0.7f * r, pin + size * dmg_range(b, 0.1f, 0.2f)));
    dmg_use(b, 0);
    draw_trigger(b, 0, v3(0, low, -0.02f * size), 0.035f * size, 0.5f * half, true);
    if (dmg_chance(b, 0.6f)) { /* the lever on top, to the side */
        dmg_hinge(b, 0, "top_lever", v3(0, 0.9f * r, -0.02f * size), v3(0, 1, 0), 0.0f, 0.6f);
        dmg_beam(b, v3(0, 1.2f * r, -0.01f * size), v3(0, 1.1f * r, -0.08f * size), 0.8f * r, 0.6f * r);
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.4f)) return;
    for (int s = -1; s <= 1; s += 2)
        draw_hammer(b, 0, v3((float)s * 1.15f * half, -r, -0.03f * size), 2.6f * r, 0.13f * half);
}

/* Draws a flint's jaw that snaps to the front on a steel that tips; a ramrod under the barrel. */
static void draw_flintlock(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.018f, 0.03f), barrel = size * dmg_range(b, 0.35f, 0.7f), half = 1.2f * r,
          side = 1.15f * half;
    const dmg_xy fore[] = {{-0.08f * size, -3.2f * r},
                           {0.1f * size, -3 * r},
                           {0.85f * barrel, -2 * r},
                           {0.85f * barrel, 0},
                           {-0.08f * size, 0.2f * r}};
    draw_side(b, fore, 5, half);
    dmg_cone(b, v3(0, 0.3f * r, -0.03f * size), v3(0, 0.3f * r, barrel), 1.1f * r, 0.8f * r);
    if (dmg_chance(b, 0.5f))
        draw_grip(b, -0.06f * size, 0, size * dmg_range(b, 0.2f, 0.3f), 3 * r, half);
    else
        draw_butt(b, -0.08f * size, 0.2f * r, 0.35f * size, 3.2f * r, half);
    dmg_box_span(b, v3(half, -2.2f * r, -0.06f * size), v3(1.12f * half, 0, 0.1f * size));
    draw_trigger(b, 0, v3(0, -3.1f * r, -0.02f * size), 0.04f * size, half, true);
    draw_hammer(b, 0, v3(side + 0.1f * half, -0.8f * r, -0.02f * size), 4 * r, 0.12f * half);
    dmg_hinge(b, 0, "steel", v3(side, 0, 0.07f * size), v3(1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.1f));
    dmg_beam(b, v3(side + 0.15f * half, 0, 0.07f * size), v3(side + 0.15f * half, 0.2f * r, 0.035f * size), 0.3f * half,
             0.4f * r);
    dmg_beam(b, v3(side + 0.15f * half, 0.1f * r, 0.04f * size), v3(side + 0.15f * half, 2.4f * r, 0.03f * size),
             0.3f * half, 0.5f * r);
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.6f)) return;
    dmg_slide(b, 0, "ramrod", v3(0, 0, 1), 0.0f, 0.7f * barrel);
    dmg_rod(b, v3(0, -2.3f * r, 0.1f * barrel), v3(0, -2.3f * r, 0.98f * barrel), 0.3f * r);
    dmg_use(b, 0);
}

/* ---- carbine ---- */

static void draw_carbine_stock(dmg_builder* b, float rear, float size, float half, float high) {
    int kind = dmg_int(b, 0, 3); /* fixed, folds to the side, drops under, slides in */
    float length = size * dmg_range(b, 0.2f, 0.3f), y = -0.5f * high, end = rear - length, side = dmg_sign(b);
    if (kind == 0) {
        draw_butt(b, rear, -0.1f * high, length, 0.8f * high, 0.8f * half);
        return;
    }
    if (kind == 3) {
        dmg_rod(b, v3(0, y, rear - 0.7f * length), v3(0, y, rear), 0.25f * high);
        dmg_slide(b, 0, "stock", v3(0, 0, 1), 0.0f, 0.3f * length);
        dmg_rod(b, v3(0, y, end), v3(0, y, rear - 0.45f * length), 0.36f * high);
        dmg_box_span(b, v3(-0.5f * half, y - 1.2f * high, end), v3(0.5f * half, y, rear - 0.7f * length));
    } else {
        if (kind == 1)
            dmg_hinge(b, 0, "stock", v3(side * half, y, rear - 0.1f * half), v3(0, -side, 0), 0.0f,
                      dmg_range(b, 2.6f, 3.0f));
        else
            dmg_hinge(b, 0, "stock", v3(0, -0.9f * high, rear - 0.1f * half), v3(-1, 0, 0), 0.0f,
                      dmg_range(b, 1.6f, 2.2f));
        for (int k = 0; k < 2; ++k)
            dmg_rod(b, v3(0, y + (k ? 0.3f : -0.3f) * high, rear - 0.1f * half),
                    v3(0, y + (k ? 0.3f : -0.9f) * high, end), 0.25f * half);
    }
    dmg_box_span(b, v3(-0.7f * half, y - 1.3f * high, end - 0.4f * half), v3(0.7f * half, y + 0.5f * high, end));
    dmg_use(b, 0);
}

static void draw_carbine(dmg_builder* b, float size) {
    float half = size * dmg_range(b, 0.018f, 0.03f), high = half * dmg_range(b, 2.2f, 3.5f),
          rear = -size * dmg_range(b, 0.12f, 0.2f), front = size * dmg_range(b, 0.06f, 0.15f),
          fore = front + size * dmg_range(b, 0.12f, 0.3f), top = 0.4f * high, low = top - high;
    dmg_box_span(b, v3(-half, low, rear), v3(half, top, front));
    dmg_rod(b, v3(0, 0, front), v3(0, 0, fore + size * dmg_range(b, 0.03f, 0.2f)), 0.4f * half);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0, front), v3(0, 0, fore), 1.1f * half);
    else
        dmg_box_span(b, v3(-0.9f * half, -0.35f * high, front), v3(0.9f * half, 0.35f * high, fore));
    draw_sights(b, rear + half, fore, top, 0.8f * half);
    draw_carbine_stock(b, rear, size, half, high);
    float grip = rear + 0.25f * (front - rear), well = rear + (front - rear) * dmg_range(b, 0.6f, 0.8f);
    draw_grip(b, grip, low, size * dmg_range(b, 0.1f, 0.16f), 1.7f * half, 0.8f * half);
    draw_trigger(b, 0, v3(0, low, 0.5f * (grip + well)), 0.03f * size, half, true);
    float lean = dmg_range(b, 0.0f, 0.3f), mag = size * dmg_range(b, 0.08f, 0.2f);
    dmg_vec down = {0, -cosf(lean), sinf(lean)}, mouth = {0, low + 0.3f * high, well};
    dmg_slide(b, 0, "magazine", down, 0.0f, mag + 0.3f * high);
    dmg_beam(b, mouth, v3_mad(mouth, down, mag + 0.3f * high), 1.3f * half, 1.8f * half);
    dmg_use(b, 0);
    float side = dmg_sign(b), x = side * half, port = 0.35f * (front - rear), z = rear + 0.45f * (front - rear);
    if (dmg_chance(b, 0.6f)) { /* the cover over the port, its pin below or above it */
        bool below = dmg_chance(b, 0.7f);
        float at = below ? top - 0.55f * high : top - 0.1f * high, tall = (below ? 0.4f : -0.4f) * high;
        dmg_hinge(b, 0, "dust_cover", v3(x + 0.08f * side * half, at, z), v3(0, 0, below ? -side : side), 0.0f,
                  dmg_range(b, 1.5f, 2.8f));
        dmg_rod(b, v3(x + 0.08f * side * half, at, z), v3(x + 0.08f * side * half, at, z + port), 0.08f * half);
        dmg_box(b, v3(x + 0.08f * side * half, at + 0.5f * tall, z + 0.5f * port), v3(0.14f * half, fabsf(tall), port));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.7f)) { /* what is drawn to load it: at the side or on top */
        dmg_slide(b, 0, "charging_handle", v3(0, 0, -1), 0.0f, port);
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(-x, 0.3f * top, z + 1.1f * port), v3(-x - 1.4f * side * half, 0.3f * top, z + 1.1f * port),
                    0.25f * half);
        else
            dmg_box_span(b, v3(-1.4f * half, top, rear + 0.1f * half),
                         v3(1.4f * half, top + 0.3f * half, rear + 0.7f * half));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.6f)) { /* the selector, a short lever on the side */
        float zs = grip + half, ys = low + 0.4f * high;
        dmg_hinge(b, 0, "selector", v3(-x, ys, zs), v3(-side, 0, 0), -0.8f, 0.8f);
        dmg_rod(b, v3(-x, ys, zs), v3(-x - 0.25f * side * half, ys, zs), 0.35f * half);
        dmg_box(b, v3(-x - 0.25f * side * half, ys, zs + 0.6f * half), v3(0.2f * half, 0.3f * half, 1.3f * half));
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.3f)) return;
    for (int s = -1; s <= 1; s += 2) { /* two feet folded along the barrel */
        float zf = fore - half, yf = -0.5f * high;
        dmg_hinge(b, 0, "bipod", v3(0, yf, zf), v3(-1, 0, 0), 0.0f, 1.5f);
        dmg_rod(b, v3((float)s * 0.8f * half, yf, zf), v3((float)s * 0.8f * half, yf, zf - 0.16f * size), 0.2f * half);
        dmg_use(b, 0);
    }
}

/* ---- crossbow ---- */

static void draw_crossbow(dmg_builder* b, float size) {
    float half = size * dmg_range(b, 0.02f, 0.035f), high = half * dmg_range(b, 1.5f, 3.0f),
          span = size * dmg_range(b, 0.3f, 0.5f), front = 0.5f * size, bend = span * dmg_range(b, 0.15f, 0.5f),
          nut = -size * dmg_range(b, 0.02f, 0.12f);
    const dmg_vec prod[] = {{-span, 0, front - bend},
                            {-0.5f * span, 0, front - 0.25f * bend},
                            {0, 0, front},
                            {0.5f * span, 0, front - 0.25f * bend},
                            {span, 0, front - bend}};
    dmg_box_span(b, v3(-half, -high, -0.2f * size), v3(half, 0, front));
    dmg_sweep(b, prod, 5, 0.25f * half, 0.7f * half, false);
    draw_butt(b, -0.2f * size, 0, size * dmg_range(b, 0.15f, 0.3f), high, half);
    if (dmg_chance(b, 0.5f))
        dmg_torus(b, v3(0, -0.5f * high, front + 1.5f * high), v3(0, 1, 0), 1.5f * high, 0.2f * half);
    if (dmg_chance(b, 0.5f)) {
        dmg_rod(b, v3(0, 0.3f * half, nut), v3(0, 0.3f * half, 1.02f * front), 0.2f * half);
        dmg_rod(b, v3(-span, 0.3f * half, front - bend), v3(0, 0.3f * half, nut), 0.08f * half);
        dmg_rod(b, v3(span, 0.3f * half, front - bend), v3(0, 0.3f * half, nut), 0.08f * half);
    }
    dmg_spin(b, 0, "nut", v3(0, 0, nut), v3(1, 0, 0));
    dmg_rod(b, v3(-0.5f * half, 0, nut), v3(0.5f * half, 0, nut), 0.6f * half);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) { /* a long lever under the stock, squeezed up to it */
        float tip = size * dmg_range(b, 0.2f, 0.35f), gap = dmg_range(b, 0.15f, 0.4f);
        dmg_hinge(b, 0, "lever", v3(0, -high, nut), v3(1, 0, 0), -0.1f, 0.8f * gap);
        dmg_beam(b, v3(0, -high, nut + half), v3(0, -high - tip * gap - 0.5f * half, nut - tip), 0.6f * half,
                 0.5f * half);
    } else {
        draw_trigger(b, 0, v3(0, -high, nut - 0.05f * size), 0.05f * size, half, dmg_chance(b, 0.6f));
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.4f)) { /* spanned with a crank at the butt, */
        float z = -0.18f * size, reach = 4 * half;
        dmg_spin(b, 0, "crank", v3(0, 0.8f * half, z), v3(1, 0, 0));
        dmg_rod(b, v3(-1.8f * half, 0.8f * half, z), v3(1.8f * half, 0.8f * half, z), 0.6f * half);
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 1.8f * half, y = 0.8f * half + (float)s * reach;
            dmg_beam(b, v3(x, 0.8f * half, z), v3(x, y, z), 0.3f * half, 0.4f * half);
            dmg_rod(b, v3(x, y, z), v3(x + (float)s * 2 * half, y, z), 0.3f * half);
        }
    } else if (dmg_chance(b, 0.5f)) { /* or with a forked lever over the stock */
        float z = 0.25f * size;
        dmg_hinge(b, 0, "spanner", v3(0, 0.3f * half, z), v3(1, 0, 0), 0.0f, 1.8f);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 1.2f * half, 0.3f * half, z),
                     v3((float)s * 1.2f * half, 1.5f * half, z - 0.3f * size), 0.25f * half, 0.4f * half);
        dmg_rod(b, v3(-1.3f * half, 1.5f * half, z - 0.3f * size), v3(1.3f * half, 1.5f * half, z - 0.3f * size),
                0.3f * half);
    }
    dmg_use(b, 0);
}

void dmg_build_firearm(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.3f, 1.3f);
    int kind = dmg_weighted(b, (const float[]){1.2f, 1, 1, 1, 0.6f, 1.5f}, 6);
    dmg_move(b, 0, 0.3f * size, 0);
    if (kind == 0) draw_revolver(b, size);
    if (kind == 1) draw_rifle(b, size);
    if (kind == 2) draw_pump_gun(b, size);
    if (kind == 3) draw_break_gun(b, size);
    if (kind == 4) draw_flintlock(b, size);
    if (kind == 5) draw_carbine(b, size);
    dmg_use(b, 0);
}

void dmg_build_crossbow(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.3f, 1.0f);
    dmg_move(b, 0, 0.3f * size, 0);
    draw_crossbow(b, size);
    dmg_use(b, 0);
}
