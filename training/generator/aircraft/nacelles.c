/* Draws jet engines in their nacelles: reversers with sleeves, buckets and pivot doors; nozzles with petals, ramps,
 * plugs and elbows. The axis is Z, the intake in front. */
#include "core/build.h"
#include "core/skins.h"
#include "parts/hardware.h"

/* ---- thrust reverser ---- */

typedef struct nacelle {
    float r, front, rear, cut; /* cut: where the reverser begins */
    float end;                 /* radius of the rear edge */
    float core, t;
    float top; /* half the sector that the pylon takes */
} nacelle;

static void draw_fan(dmg_builder* b, float r, float z) {
    int blades = dmg_int(b, 5, 16);
    float twist = dmg_range(b, 0.3f, 1.0f), nose = r * dmg_range(b, 0.3f, 0.7f), hub = r * dmg_range(b, 0.2f, 0.35f);
    bool disc = dmg_chance(b, 0.3f);
    if (dmg_chance(b, 0.75f)) dmg_spin(b, 0, "fan", v3(0, 0, z), v3(0, 0, 1));
    dmg_cone(b, v3(0, 0, z), v3(0, 0, z + nose), hub, 0);
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    if (disc)
        dmg_rod(b, v3(0, 0, -0.03f * r), v3(0, 0, 0), r);
    else
        dmg_blades_draw(b, dmg_int(b, 0, 2), r, hub, r * 1.5f / (float)blades, blades, twist);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws what carries the engine: a pylon, or nothing. */
static void draw_pylon(dmg_builder* b, const nacelle* n) {
    float wide = 0.8f * n->r * sinf(n->top), reach = n->r * dmg_range(b, 0.3f, 1.2f),
          back = n->cut + 0.1f * (n->front - n->cut), fore = n->front - 0.35f * (n->front - n->cut);
    if (dmg_chance(b, 0.75f)) dmg_box_span(b, v3(-wide, 0.97f * n->r, back), v3(wide, n->r + reach, fore));
}

/* Draws two fan cowls, hung beside the pylon, between z0 and z1. */
static void draw_fan_cowls(dmg_builder* b, const nacelle* n, float z0, float z1) {
    float top = n->top, bottom = dmg_range(b, 0.01f, 0.08f), swing = dmg_range(b, 0.5f, 1.1f);
    bool open = dmg_chance(b, 0.25f), latch = dmg_chance(b, 0.4f);
    dmg_skin_cone(b, (dmg_xy){n->r, z0}, (dmg_xy){n->r, z1}, 0.5f * DMG_PI - top, 0.5f * DMG_PI + top, n->t);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, hung = 0.5f * DMG_PI - side * (top + 0.01f),
              low = 0.5f * DMG_PI - side * (DMG_PI - bottom);
        dmg_vec line = dmg_skin_point(n->r, hung, 0.5f * (z0 + z1));
        uint32_t cowl = dmg_hinge(b, 0, "fan_cowl", line, v3(0, 0, side), 0.0f, swing);
        if (open) dmg_rest(b, cowl, swing);
        float gap = 0.006f * (z1 - z0);
        dmg_skin_cone(b, (dmg_xy){n->r, z0 + gap}, (dmg_xy){n->r, z1 - gap}, fminf(hung, low), fmaxf(hung, low), n->t);
        if (latch) {
            dmg_vec at = dmg_skin_point(1.01f * n->r, low + side * 0.1f, 0.5f * (z0 + z1));
            dmg_box(b, at, v3(0.08f * n->r, 0.03f * n->r, 0.3f * (z1 - z0)));
        }
        dmg_use(b, 0);
    }
}

/* Draws the whole from the reverser forwards, with what turns in its intake. */
static void draw_front(dmg_builder* b, const nacelle* n) {
    float lip = n->r * dmg_range(b, 0.78f, 0.95f), mid = n->front - (n->front - n->cut) * dmg_range(b, 0.3f, 0.55f);
    bool cowls = dmg_chance(b, 0.4f);
    const dmg_xy rows[] = {{n->r, cowls ? mid : n->cut},
                           {n->r, mid + 0.02f * n->r},
                           {0.5f * (lip + n->r) + 0.03f * n->r, 0.35f * mid + 0.65f * n->front},
                           {lip, n->front}};
    dmg_skin skin = {.rows = rows, .count = 4, .from = 0, .to = 2 * DMG_PI, .t = n->t, .high = 1};
    dmg_skin_draw(b, &skin);
    if (cowls) draw_fan_cowls(b, n, n->cut, mid);
    if (dmg_chance(b, 0.5f)) dmg_torus(b, v3(0, 0, n->front), v3(0, 0, 1), lip - 0.5f * n->t, 0.04f * n->r);
    dmg_rod(b, v3(0, 0, n->cut), v3(0, 0, mid), n->core);
    draw_fan(b, lip - n->t - 0.08f * n->r, mid + 0.3f * (n->front - mid));
}

/* Draws a ring, or two halves, that moves back and bares the cascades. */
static void draw_sleeve(dmg_builder* b, const nacelle* n) {
    float deep = n->cut - n->rear, way = deep * dmg_range(b, 0.3f, 0.75f), inner = n->end * 0.94f - n->t,
          gap = dmg_range(b, 0.02f, 0.25f);
    int halves = dmg_chance(b, 0.55f) ? 2 : 1, ribs = dmg_int(b, 0, 5), doors = dmg_int(b, 0, 4);
    bool bars = dmg_chance(b, 0.4f), open = dmg_chance(b, 0.35f);
    for (int i = 0; i <= ribs && !bars; ++i)
        dmg_torus(b, v3(0, 0, n->cut - way * (float)i / (float)(ribs + 1)), v3(0, 0, 1), inner - 0.02f * n->r,
                  0.02f * n->r);
    dmg_skin_cone(b, (dmg_xy){inner, n->cut - way}, (dmg_xy){inner, n->cut}, 0, 2 * DMG_PI, 0.02f * n->r);
    for (int i = 0; i < 12 && bars; ++i) {
        float angle = DMG_PI * (float)i / 6.0f;
        dmg_beam(b, dmg_skin_point(inner, angle, n->cut), dmg_skin_point(inner, angle, n->cut - way), 0.03f * n->r,
                 0.03f * n->r);
    }
    dmg_cone(b, v3(0, 0, n->cut), v3(0, 0, n->rear - 0.3f * deep), n->core, 0.4f * n->core);
    for (int h = 0; h < halves; ++h) {
        float from = halves == 1 ? 0.0f : -0.5f * DMG_PI + DMG_PI * (float)h + gap,
              to = halves == 1 ? 2 * DMG_PI : from + DMG_PI - 2 * gap;
        uint32_t sleeve = dmg_slide(b, 0, "sleeve", v3(0, 0, -1), 0.0f, way);
        if (open) dmg_rest(b, sleeve, way);
        dmg_skin_cone(b, (dmg_xy){n->end, n->rear}, (dmg_xy){n->r, n->cut - 0.004f * n->r}, from, to, n->t);
        float reach = inner - 0.1f * n->r, length = 0.75f * fminf(reach - n->core, 0.8f * deep);
        dmg_band blockers = {.name = "blocker",
                             .parent = sleeve,
                             .back = {reach, n->cut - 0.05f * deep - length},
                             .front = {reach, n->cut - 0.05f * deep},
                             .count = doors,
                             .start = from,
                             .arc = to - from,
                             .fill = 0.55f,
                             .t = 0.02f * n->r,
                             .upper = 1.0f,
                             .inwards = true,
                             .plates = true};
        if (doors && length > 0) dmg_band_draw(b, &blockers);
        dmg_use(b, 0);
    }
    for (int s = 0; s < 2 && halves == 2; ++s) { /* beams between the halves */
        float angle = s ? 0.5f * DMG_PI : -0.5f * DMG_PI;
        dmg_beam(b, dmg_skin_point(n->end - 0.03f * n->r, angle, n->cut),
                 dmg_skin_point(n->end - 0.03f * n->r, angle, n->rear), 1.6f * gap * n->end, 0.05f * n->r);
    }
}

/* Half shells that swing about their own side pivots until they meet behind the pipe. */
static void draw_buckets(dmg_builder* b, const nacelle* n) {
    float deep = n->cut - n->rear, pipe = n->end * dmg_range(b, 0.75f, 0.9f), swing = dmg_range(b, 1.1f, 1.5f),
          pivot = n->rear + deep * dmg_range(b, 0.0f, 0.08f), gap = dmg_range(b, 0.01f, 0.2f),
          apart = n->end * 0.2f * dmg_unit(b), scarf = dmg_range(b, 0.7f, 1.0f);
    bool arms = dmg_chance(b, 0.5f), open = dmg_chance(b, 0.4f), fairing = dmg_chance(b, 0.5f);
    dmg_skin_cone(b, (dmg_xy){pipe - n->t, pivot + 0.03f * deep}, (dmg_xy){pipe, n->cut}, 0, 2 * DMG_PI,
                  fmaxf(n->t, 0.02f * n->r));
    dmg_cone(b, v3(0, 0, n->cut), v3(0, 0, pivot), 0.8f * n->core, 0.2f * n->core);
    dmg_save(b);
    if (dmg_chance(b, 0.45f)) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    for (int s = -1; s <= 1 && fairing; s += 2)
        dmg_box_span(b, v3((float)s * 1.04f * n->r - 0.03f * n->r, -0.12f * n->r, pivot - 0.04f * deep),
                     v3((float)s * 1.04f * n->r + 0.03f * n->r, 0.12f * n->r, n->cut + 0.3f * deep));
    for (int s = 0; s < 2; ++s) {
        dmg_save(b);
        if (s) dmg_turn(b, v3(0, 0, 1), DMG_PI);
        uint32_t bucket = dmg_hinge(b, 0, "bucket", v3(0, apart, pivot), v3(-1, 0, 0), 0.0f, swing);
        if (open) dmg_rest(b, bucket, swing);
        float half = 0.5f * DMG_PI - fmaxf(gap, asinf(apart / n->end) * 0.9f);
        dmg_skin_cone(b, (dmg_xy){n->end, n->rear}, (dmg_xy){n->r, n->rear + scarf * deep}, 0.5f * DMG_PI - half,
                      0.5f * DMG_PI + half, n->t);
        for (int k = -1; k <= 1 && arms; k += 2)
            dmg_beam(b, v3((float)k * 0.98f * n->end, apart, pivot),
                     v3((float)k * 0.9f * n->end, 0.45f * n->end, pivot + 0.6f * deep), 0.03f * n->r, 0.1f * n->r);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (scarf < 0.97f)
        dmg_skin_cone(b, (dmg_xy){n->r, n->rear + scarf * deep}, (dmg_xy){n->r, n->cut}, 0, 2 * DMG_PI, n->t);
    dmg_restore(b);
}

/* Doors in the skin that tilt about a line across their middle: the front out, the rear in. */
static void draw_pivot_doors(dmg_builder* b, const nacelle* n) {
    float deep = n->cut - n->rear, z1 = n->rear + deep * dmg_range(b, 0.15f, 0.35f),
          side = n->end + (n->r - n->end) * 0.3f, swing = dmg_range(b, 0.5f, 1.1f),
          start = dmg_chance(b, 0.5f) ? 0.25f * DMG_PI : 0.0f;
    int count = dmg_int(b, 2, 4);
    dmg_skin_cone(b, (dmg_xy){n->end, n->rear}, (dmg_xy){side, z1}, 0, 2 * DMG_PI, n->t);
    dmg_cone(b, v3(0, 0, n->cut), v3(0, 0, n->rear), 0.6f * n->core, 0.3f * n->core);
    dmg_band doors = {.name = "pivot_door",
                      .back = {side, z1 + 0.01f * deep},
                      .front = {n->r, n->cut - 0.01f * deep},
                      .count = count,
                      .start = start,
                      .arc = 2 * DMG_PI,
                      .t = n->t,
                      .upper = swing,
                      .inwards = true,
                      .strips = true};
    doors.fill = dmg_range(b, 0.45f, 0.85f);
    doors.at = dmg_range(b, 0.4f, 0.65f);
    if (dmg_chance(b, 0.35f)) doors.rest = swing;
    dmg_band_draw(b, &doors);
}

void dmg_build_thrust_reverser(dmg_builder* b) {
    nacelle n = {.r = dmg_scale_range(b, 0.05f, 1.6f)};
    float length = n.r * dmg_range(b, 2.2f, 5.5f);
    n.front = 0.5f * length;
    n.rear = -0.5f * length;
    n.cut = n.rear + length * dmg_range(b, 0.3f, 0.5f);
    n.end = n.r * dmg_range(b, 0.75f, 1.0f);
    n.core = n.r * dmg_range(b, 0.3f, 0.55f);
    n.t = dmg_chance(b, 0.4f) ? 0.0f : n.r * dmg_range(b, 0.02f, 0.06f);
    int kind = dmg_int(b, 0, 2), engines = dmg_chance(b, 0.2f) ? 2 : 1;
    n.top = dmg_range(b, 0.1f, 0.3f);
    static const float turns[] = {0, 0, 0.5f, -0.5f, 1}; /* below a wing, at either side of a hull, on top */
    float turn = DMG_PI * turns[engines == 2 ? 0 : dmg_int(b, 0, 4)];
    dmg_move(b, 0, 2.2f * n.r, 0);
    dmg_turn(b, v3(0, 1, 0), DMG_PI); /* what opens faces the front */
    dmg_turn(b, v3(0, 0, 1), turn);
    uint64_t same = b->random_state; /* a pair is alike */
    for (int i = 0; i < engines; ++i) {
        b->random_state = same;
        dmg_save(b);
        if (engines == 2) dmg_move(b, (i ? -1.6f : 1.6f) * n.r, 0, 0);
        draw_front(b, &n);
        draw_pylon(b, &n);
        if (kind == 0) draw_sleeve(b, &n);
        if (kind == 1) draw_buckets(b, &n);
        if (kind == 2) draw_pivot_doors(b, &n);
        dmg_restore(b);
    }
    if (engines == 2) dmg_rounded_box(b, v3(0, 1.05f * n.r, 0), v3(3.6f * n.r, 0.2f * n.r, 0.6f * length), 0.05f * n.r);
}

/* ---- jet nozzle ---- */

typedef struct nozzle {
    float r, length, t; /* of the duct in front, which ends at z = 0 */
} nozzle;

static void draw_duct(dmg_builder* b, const nozzle* n) {
    float fore = n->r * dmg_range(b, 0.7f, 1.25f);
    const dmg_xy rows[] = {{n->r, 0}, {0.5f * (n->r + fore) + 0.05f * n->r, 0.5f * n->length}, {fore, n->length}};
    int rods = dmg_chance(b, 0.4f) ? dmg_int(b, 3, 8) : 0, rings = dmg_int(b, 0, 3);
    dmg_skin skin = {.rows = rows, .count = 3, .from = 0, .to = 2 * DMG_PI, .t = n->t, .high = 1};
    dmg_skin_draw(b, &skin);
    for (int i = 0; i < rods; ++i) { /* what drives the nozzle */
        float angle = 2 * DMG_PI * (float)i / (float)rods;
        dmg_rod(b, dmg_skin_point(1.04f * n->r, angle, 0.02f * n->length),
                dmg_skin_point(1.12f * n->r, angle, 0.5f * n->length), 0.03f * n->r);
    }
    for (int i = 0; i < rings; ++i)
        dmg_torus(b, v3(0, 0, n->length * 0.2f * (float)i), v3(0, 0, 1), n->r * 0.3f * (float)(i + 1) / 1.2f,
                  0.02f * n->r);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0, 0.55f * n->length), v3(0, 0, 0.6f * n->length), 0.9f * fminf(n->r, fore));
}

/* Petals round the duct's end, with a second stage on them sometimes. */
static void draw_petals(dmg_builder* b, const nozzle* n, uint32_t carrier, float r) {
    int count = dmg_int(b, 5, 11);
    bool stages = count < 9 && dmg_chance(b, 0.35f);
    float length = r * dmg_range(b, 0.5f, 1.3f), lean = dmg_range(b, 0.0f, 0.35f), gap = dmg_range(b, 0.08f, 0.3f),
          out = dmg_range(b, 0.1f, 0.5f), in = fminf(0.4f, 0.6f * gap * r / length);
    dmg_band d = {.name = "petal",
                  .parent = carrier,
                  .front = {r, 0},
                  .count = count,
                  .arc = 2 * DMG_PI,
                  .fill = 1 - gap,
                  .t = n->t,
                  .lower = -in,
                  .upper = out + lean,
                  .plates = dmg_chance(b, 0.4f)};
    d.back = (dmg_xy){r - length * sinf(lean), -length * cosf(lean)};
    d.rest = dmg_chance(b, 0.5f) ? d.lower + (d.upper - d.lower) * dmg_unit(b) : 0.0f;
    if (!stages) {
        dmg_band_draw(b, &d);
        return;
    }
    float each = 2 * DMG_PI / (float)count, flare = dmg_range(b, 0.0f, 0.35f), more = length * dmg_range(b, 0.5f, 1.0f);
    for (int i = 0; i < count; ++i) {
        dmg_band one = d;
        one.count = 1;
        one.start = each * (float)i;
        one.arc = each;
        dmg_band_draw(b, &one);
        dmg_band next = {.name = "outer_petal",
                         .parent = b->part_count,
                         .front = d.back,
                         .count = 1,
                         .start = one.start,
                         .arc = each,
                         .fill = d.fill,
                         .t = d.t,
                         .lower = -0.6f * in,
                         .upper = 0.3f,
                         .plates = d.plates};
        next.back = (dmg_xy){d.back.x + more * sinf(flare), d.back.y - more * cosf(flare)};
        dmg_band_draw(b, &next);
    }
    dmg_use(b, carrier);
}

/* Round nozzle; the whole of it may swing on a gimbal. */
static void draw_round_nozzle(dmg_builder* b, const nozzle* n) {
    uint32_t carrier = 0;
    draw_duct(b, n);
    if (dmg_chance(b, 0.3f)) {
        float tilt = dmg_range(b, 0.15f, 0.4f), r = 0.94f * n->r - n->t;
        bool both = dmg_chance(b, 0.5f), across = dmg_chance(b, 0.7f);
        carrier = dmg_hinge(b, 0, "nozzle", v3(0, 0, 0), across ? v3(1, 0, 0) : v3(0, 1, 0), -tilt, tilt);
        if (both) {
            dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), r - 0.03f * n->r, 0.03f * n->r);
            carrier = dmg_hinge(b, carrier, "nozzle_yaw", v3(0, 0, 0), across ? v3(0, 1, 0) : v3(1, 0, 0), -tilt, tilt);
        }
        dmg_skin_cone(b, (dmg_xy){r, -0.25f * n->r}, (dmg_xy){0.9f * r, 0.1f * n->r}, 0, 2 * DMG_PI,
                      fmaxf(n->t, 0.02f * n->r));
        dmg_save(b);
        dmg_move(b, 0, 0, -0.25f * n->r);
        draw_petals(b, n, carrier, r);
        dmg_restore(b);
        return;
    }
    draw_petals(b, n, 0, n->r);
    if (dmg_chance(b, 0.25f)) draw_petals(b, n, 0, 0.6f * n->r);
}

/* Draws a flat duct with a ramp above and one below, each with a second one on its end sometimes. */
static void draw_flat_nozzle(dmg_builder* b, const nozzle* n) {
    float half = n->r * dmg_range(b, 0.8f, 1.8f), high = n->r * dmg_range(b, 0.35f, 0.9f),
          t = fmaxf(n->t, 0.02f * n->r), length = high * dmg_range(b, 1.0f, 2.2f), lean = dmg_range(b, 0.0f, 0.4f),
          up = dmg_range(b, 0.15f, 0.5f), in = fminf(0.35f, 0.6f * high / length);
    bool second = dmg_chance(b, 0.5f), cheeks = dmg_chance(b, 0.7f), skins = dmg_chance(b, 0.5f);
    int ramps = dmg_chance(b, 0.8f) ? 2 : 1;
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_box_span(b, v3(side * half - t, -high, 0), v3(side * half + t, high, n->length));
        dmg_box_span(b, v3(-half, side * high - t, 0), v3(half, side * high + t, n->length));
        if (cheeks)
            dmg_box_span(b, v3(side * half - t, -0.8f * high, -0.9f * length), v3(side * half + t, 0.8f * high, 0));
    }
    for (int i = 0; i < ramps; ++i) {
        dmg_save(b);
        if (i) dmg_mirror(b, v3(0, 1, 0));
        dmg_vec line = {0, high, -t}, tip = {0, high - length * sinf(lean), -t - length * cosf(lean)};
        uint32_t ramp = dmg_hinge(b, 0, "ramp", line, v3(1, 0, 0), -in + 0.5f * lean, up + lean);
        dmg_beam(b, line, tip, 1.9f * half - 2 * t, skins ? 0.5f * t : 2 * t);
        if (second) {
            float more = length * dmg_range(b, 0.5f, 1.2f);
            dmg_hinge(b, ramp, "outer_ramp", tip, v3(1, 0, 0), -0.2f, 0.4f);
            dmg_beam(b, tip, v3_add(tip, v3(0, 0.3f * more * lean, -more)), 1.9f * half - 2 * t,
                     skins ? 0.5f * t : 2 * t);
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (ramps == 1) dmg_box_span(b, v3(-half, -high - t, -1.2f * length), v3(half, -high + t, 0));
}

/* Draws a cone in the middle that slides, at the rear or in an intake. */
static void draw_plug(dmg_builder* b, const nozzle* n) {
    float r = n->r * dmg_range(b, 0.35f, 0.75f), fore = n->r * dmg_range(b, 0.3f, 1.0f),
          back = n->r * dmg_range(b, 0.8f, 2.2f), way = n->r * dmg_range(b, 0.2f, 0.7f), stem = 0.3f * r;
    int struts = dmg_int(b, 0, 4);
    draw_duct(b, n);
    for (int i = 0; i < struts; ++i) {
        float angle = 2 * DMG_PI * (float)i / (float)struts;
        dmg_beam(b, dmg_skin_point(stem, angle, fore + way + 0.1f * n->r),
                 dmg_skin_point(n->r, angle, fore + way + 0.1f * n->r), 0.04f * n->r, 0.1f * n->r);
    }
    if (struts) dmg_rod(b, v3(0, 0, fore + way), v3(0, 0, fore + way + 0.3f * n->r), 1.3f * stem);
    uint32_t plug = dmg_slide(b, 0, "plug", v3(0, 0, -1), 0.0f, way);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, plug, way * dmg_unit(b));
    const dmg_xy bulb[] = {
        {0, fore}, {stem, 0.8f * fore}, {r, 0.1f * fore}, {0.85f * r, -0.3f * back}, {0.3f * r, -0.8f * back},
        {0, -back}};
    const dmg_xy spike[] = {{0, fore}, {0.9f * r, 0.6f * fore}, {r, 0}, {0, -back}};
    bool sharp = dmg_chance(b, 0.5f);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI); /* a profile goes up outside: from the front to the rear */
    dmg_xy turned[6];
    for (int i = 0; i < (sharp ? 4 : 6); ++i)
        turned[i] = (dmg_xy){sharp ? spike[i].x : bulb[i].x, sharp ? -spike[i].y : -bulb[i].y};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), turned, sharp ? 4 : 6);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Elbows at the body's sides that turn from backwards to downwards. */
static void draw_elbows(dmg_builder* b, const nozzle* n) {
    int rows = dmg_int(b, 1, 2), vanes = dmg_int(b, 0, 4);
    float r = n->r * dmg_range(b, 0.25f, 0.42f), swing = dmg_range(b, 1.4f, 1.8f), bell = r * dmg_range(b, 0.85f, 1.2f),
          reach = r * dmg_range(b, 1.4f, 2.6f), stub = r * dmg_range(b, 0.1f, 0.5f), rest = swing * dmg_unit(b);
    bool flat = dmg_chance(b, 0.4f), turned = dmg_chance(b, 0.5f);
    dmg_rounded_box(b, v3(0, 0, 0.2f * n->length), v3(1.7f * n->r, 1.5f * n->r, 1.6f * n->length), 0.2f * n->r);
    for (int i = 0; i < 2 * rows; ++i) {
        dmg_save(b);
        if (i & 1) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.85f * n->r, 0, i < 2 ? -0.1f * n->length : 0.6f * n->length);
        dmg_rod(b, v3(-0.05f * n->r, 0, 0), v3(stub, 0, 0), 1.05f * r);
        uint32_t elbow = dmg_hinge(b, 0, "elbow", v3(stub, 0, 0), v3(-1, 0, 0), 0.0f, swing);
        if (turned) dmg_rest(b, elbow, rest);
        float out = stub + 1.05f * r;
        dmg_rod(b, v3(stub, 0, 0), v3(out + 0.5f * r, 0, 0), r);
        if (flat) {
            dmg_box(b, v3(out, 0, -0.5f * reach), v3(1.7f * r, 1.7f * r, reach));
            for (int k = 0; k < vanes; ++k)
                dmg_box(b, v3(out, r * (1.4f * ((float)k + 0.5f) / (float)vanes - 0.7f), -1.1f * reach),
                        v3(1.6f * r, 0.05f * r, 0.3f * reach));
        } else {
            dmg_cone(b, v3(out, 0, 0), v3(out, 0, -reach), 0.9f * r, bell);
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Small doors round a skin in front that open inwards, or outwards to let air go. */
static void draw_blow_doors(dmg_builder* b, const nozzle* n) {
    float z = n->length * 1.02f, deep = n->r * dmg_range(b, 0.25f, 0.6f), swing = dmg_range(b, 0.25f, 0.6f);
    dmg_band d = {.name = "blow_door",
                  .back = {n->r, z},
                  .front = {n->r, z + deep},
                  .count = dmg_int(b, 3, 10),
                  .arc = 2 * DMG_PI,
                  .t = n->t,
                  .upper = swing,
                  .strips = true};
    d.fill = dmg_range(b, 0.4f, 0.85f);
    d.inwards = dmg_chance(b, 0.6f);
    dmg_band_draw(b, &d);
    dmg_skin_cone(b, (dmg_xy){n->r, z + deep}, (dmg_xy){0.9f * n->r, z + 2 * deep}, 0, 2 * DMG_PI, n->t);
}

void dmg_build_jet_nozzle(dmg_builder* b) {
    nozzle n = {.r = dmg_scale_range(b, 0.05f, 1.2f)};
    n.length = n.r * dmg_range(b, 1.0f, 3.5f);
    n.t = dmg_chance(b, 0.4f) ? 0.0f : n.r * dmg_range(b, 0.02f, 0.06f);
    static const float weights[] = {4, 2, 2, 2};
    int kind = dmg_weighted(b, weights, 4), count = kind != 3 && dmg_chance(b, 0.2f) ? 2 : 1;
    float apart = n.r * (kind == 1 ? 4.2f : 2.6f);
    dmg_move(b, 0, 1.8f * n.r, 0);
    dmg_turn(b, v3(0, 1, 0), DMG_PI); /* what moves faces the front */
    uint64_t same = b->random_state;
    for (int i = 0; i < count; ++i) {
        b->random_state = same;
        dmg_save(b);
        if (count == 2) dmg_move(b, (float)(2 * i - 1) * 0.5f * apart, 0, 0);
        if (kind == 0) draw_round_nozzle(b, &n);
        if (kind == 1) draw_flat_nozzle(b, &n);
        if (kind == 2) draw_plug(b, &n);
        if (kind == 3) draw_elbows(b, &n);
        if (kind != 3 && kind != 1 && dmg_chance(b, 0.3f)) draw_blow_doors(b, &n);
        dmg_restore(b);
    }
    if (count == 2) dmg_box_span(b, v3(-0.2f * apart, -0.5f * n.r, 0), v3(0.2f * apart, 0.6f * n.r, 1.2f * n.length));
}
