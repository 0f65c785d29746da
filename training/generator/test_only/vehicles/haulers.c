/* Draws lorries with machines on their backs: concrete mixers, refuse lorries, sweepers; fire engines with ladders,
 * shutters, lockers, outriggers, monitors. The rear end is z = 0. */
#include "core/build.h"
#include "parts/trucks.h"
#include "parts/walls.h"

/* ---- mixer ---- */

/* Segments of a gutter, each hung on the one before, the first on a post at the rear. */
static void draw_chutes(dmg_builder* b, float size, dmg_vec at) {
    int count = dmg_int(b, 1, 3);
    float length = size * dmg_range(b, 0.3f, 0.5f), half = 0.09f * size, t = 0.012f * size,
          slope = dmg_range(b, 0.4f, 0.8f);
    dmg_use(b, 0);
    dmg_rod(b, v3(at.x, at.y - 0.4f * size, at.z), v3(at.x, at.y - 0.05f * size, at.z), 0.04f * size);
    uint32_t part = dmg_hinge(b, 0, "chute_swing", at, v3(0, dmg_sign(b), 0), -1.3f, 1.3f);
    dmg_rod(b, v3(at.x, at.y - 0.05f * size, at.z), v3(at.x, at.y, at.z), 0.045f * size);
    if (dmg_chance(b, 0.6f)) part = dmg_hinge(b, part, "chute_tilt", at, v3(1, 0, 0), -0.3f, 0.35f);
    const dmg_xy trough[] = {
        {-half, 1.2f * half}, {-0.8f * half, 0.3f * half}, {0, 0}, {0.8f * half, 0.3f * half}, {half, 1.2f * half}};
    dmg_save(b);
    dmg_move(b, at.x, at.y + t, at.z);
    dmg_turn(b, v3(1, 0, 0), -slope); /* its -Z goes down */
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, 0, 0, -0.5f * length);
        dmg_bent_plate(b, trough, 5, t, 0.98f * length);
        dmg_restore(b);
        dmg_move(b, 0, 0, -length);
        if (i + 1 < count) part = dmg_hinge(b, part, "chute_fold", v3(0, 1.3f * half, 0), v3(-1, 0, 0), 0.0f, 2.8f);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_mixer_back(dmg_builder* b, const dmg_truck* t, float size) {
    float r = t->half * dmg_range(b, 0.9f, 1.1f), tilt = dmg_range(b, 0.15f, 0.3f), l = t->length * 0.92f,
          y = t->deck + 1.25f * r;
    bool fins = dmg_chance(b, 0.5f), hopper = dmg_chance(b, 0.6f);
    dmg_box_span(b, v3(-0.7f * t->half, t->deck, 0.8f * t->length), v3(0.7f * t->half, y, 0.9f * t->length));
    dmg_save(b);
    dmg_move(b, 0, y, 0.5f * t->length);
    dmg_turn(b, v3(1, 0, 0), tilt); /* +Z down, the mouth behind up */
    dmg_spin(b, 0, "drum", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    const dmg_xy drum[] = {{0.3f * r, -0.5f * l},  {0.38f * r, -0.5f * l}, {0.9f * r, -0.1f * l}, {r, 0.05f * l},
                           {0.95f * r, 0.25f * l}, {0.5f * r, 0.42f * l},  {0, 0.42f * l}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), drum, 7);
    dmg_torus(b, v3(0, 0, -0.16f * l), v3(0, 0, 1), 0.88f * r, 0.05f * r);
    for (int i = 0; i < 4 && fins; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, 4);
        dmg_beam(b, v3(0.99f * r, -0.2f * r, -0.02f * l), v3(0.96f * r, 0.2f * r, 0.2f * l), 0.03f * r, 0.06f * r);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
    float mouth = y + 0.5f * l * sinf(tilt), z = 0.5f * t->length - 0.5f * l * cosf(tilt);
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 0.62f * r - 0.05f * r, t->deck, z - 0.1f * r),
                     v3((float)k * 0.62f * r + 0.05f * r, mouth + 0.5f * r, z + 0.15f * r));
    dmg_box_span(b, v3(-0.6f * r, t->deck, z - 0.1f * r), v3(0.6f * r, t->deck + 0.3f * r, z + 0.1f * r));
    if (hopper) { /* a funnel over the mouth that tips up */
        dmg_vec pin = {0, mouth + 0.55f * r, z + 0.1f * r};
        dmg_rod(b, v3(-0.62f * r, pin.y, pin.z), v3(0.62f * r, pin.y, pin.z), 0.03f * r);
        dmg_hinge(b, 0, "hopper", pin, v3(1, 0, 0), 0.0f, 0.8f);
        const dmg_xy funnel[] = {{z - 0.1f * r, mouth + 0.6f * r},
                                 {z + 0.1f * r, mouth + 0.6f * r},
                                 {z + 0.2f * r, mouth + 1.1f * r},
                                 {z - 0.7f * r, mouth + 1.1f * r}};
        dmg_side_prism(b, funnel, 4, -0.5f * r, 0.5f * r);
        dmg_use(b, 0);
    }
    draw_chutes(b, size, v3(0, t->deck + 0.45f * r, z - 0.3f * r));
    dmg_box_span(b, v3(-0.1f * r, t->deck, z - 0.36f * r), v3(0.1f * r, t->deck + 0.12f * r, z));
}

/* ---- refuse ---- */

/* Draws a comb behind that takes a bin by its rim and throws it over; the bin hangs on it. */
static void draw_bin_lift(dmg_builder* b, uint32_t parent, float half, float y, float z, float size) {
    int lifts = dmg_int(b, 1, 2);
    bool bin = dmg_chance(b, 0.6f);
    for (int i = 0; i < lifts; ++i) {
        float x = lifts == 1 ? 0.0f : (i ? 0.45f : -0.45f) * half, w = 0.3f * half, h = 0.35f * size;
        uint32_t lift = dmg_hinge(b, parent, "bin_lift", v3(x, y, z), v3(1, 0, 0), 0.0f, 1.9f);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3(x + (float)k * w - 0.015f * size, y - 0.2f * size, z - 0.04f * size),
                         v3(x + (float)k * w + 0.015f * size, y + 0.02f * size, z));
        dmg_box_span(b, v3(x - w, y - 0.22f * size, z - 0.05f * size), v3(x + w, y - 0.16f * size, z));
        if (bin) {
            dmg_box_span(b, v3(x - w, y - 0.15f * size - h, z - 0.35f * size),
                         v3(x + w, y - 0.16f * size, z - 0.055f * size));
            dmg_hinge(b, lift, "bin_lid", v3(x, y - 0.14f * size, z - 0.06f * size), v3(1, 0, 0), 0.0f, 1.6f);
            dmg_box_span(b, v3(x - w, y - 0.155f * size, z - 0.36f * size),
                         v3(x + w, y - 0.135f * size, z - 0.06f * size));
        }
        dmg_use(b, parent);
    }
}

static void draw_refuse_back(dmg_builder* b, const dmg_truck* t, float size) {
    float top = t->deck + size * dmg_range(b, 0.75f, 1.0f), z = 0.2f * t->length, w = t->half,
          low = t->deck - 0.1f * size;
    dmg_box_span(b, v3(-w, t->deck, z), v3(w, top, 0.97f * t->length));
    dmg_wall_enter(b, v3(w, 0.5f * (t->deck + top), 0.85f * t->length), 0.5f * DMG_PI);
    dmg_wall_leaf_draw(b, 0, "side_door", 0.2f * t->length, 0.5f * (top - t->deck), DMG_SIDE_LEFT);
    dmg_restore(b);
    uint32_t gate = dmg_hinge(b, 0, "tailgate", v3(0, top, z), v3(1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.5f));
    const dmg_xy side[] = {{z - 0.01f * size, low},
                           {z - 0.01f * size, top},
                           {z - 0.25f * size, top},
                           {-0.25f * size, low + 0.45f * (top - low)},
                           {-0.25f * size, low}};
    const dmg_xy over[] = {{z - 0.01f * size, low + 0.6f * (top - low)},
                           {z - 0.01f * size, top},
                           {z - 0.25f * size, top},
                           {-0.1f * size, low + 0.6f * (top - low)}};
    for (int k = -1; k <= 1; k += 2)
        dmg_side_prism(b, (const dmg_xy[]){side[4], side[0], side[1], side[2], side[3]}, 5, (float)k * w,
                       (float)k * 0.93f * w);
    dmg_side_prism(b, over, 4, -0.93f * w, 0.93f * w);
    dmg_box_span(b, v3(-0.93f * w, low, -0.25f * size), v3(0.93f * w, low + 0.25f * (top - low), z - 0.01f * size));
    dmg_vec pin = {0, low + 0.45f * (top - low), 0};
    dmg_hinge(b, gate, "packer", pin, v3(-1, 0, 0), 0.0f, 0.6f);
    dmg_box_span(b, v3(-0.9f * w, low + 0.3f * (top - low), -0.03f * size),
                 v3(0.9f * w, low + 0.56f * (top - low), 0.03f * size));
    dmg_use(b, gate);
    draw_bin_lift(b, gate, w, low + 0.25f * (top - low), -0.26f * size, size);
    dmg_use(b, 0);
}

/* ---- sweeper ---- */

static void draw_sweeper_back(dmg_builder* b, const dmg_truck* t, float size) {
    float top = t->deck + size * dmg_range(b, 0.6f, 0.9f), w = t->half, z = 0.55f * t->length, r = 0.28f * size;
    uint32_t hopper = dmg_hinge(b, 0, "hopper", v3(0, t->deck + 0.02f * size, 0.02f * size), v3(-1, 0, 0), 0.0f,
                                dmg_range(b, 0.6f, 1.0f));
    dmg_box_span(b, v3(-w, t->deck + 0.02f * size, 0), v3(w, top, 0.93f * t->length));
    dmg_wall_enter(b, v3(0, 0.5f * (t->deck + top), 0), DMG_PI);
    dmg_wall_leaf_draw(b, hopper, "rear_door", 1.8f * w, 0.85f * (top - t->deck), DMG_SIDE_TOP);
    dmg_restore(b);
    dmg_use(b, 0);
    for (int k = -1; k <= 1; k += 2) { /* brushes on arms that reach out at the sides, the mouth between them */
        float s = (float)k;
        dmg_vec pin = {s * 0.9f * w, 0.6f * t->deck, z};
        dmg_box_span(b, v3(fminf(s * 0.3f * w, pin.x), 0.55f * t->deck, z - 0.05f * size),
                     v3(fmaxf(s * 0.3f * w, pin.x), t->deck, z + 0.05f * size));
        uint32_t arm = dmg_hinge(b, 0, "brush_arm", pin, v3(0, -s, 0), -0.2f, 0.5f);
        dmg_vec end = {s * (w + 0.1f * size), 0.6f * t->deck, z + 0.25f * size};
        dmg_beam(b, v3_add(pin, v3(s * 0.03f * size, 0, 0)), end, 0.05f * size, 0.05f * size);
        dmg_spin(b, arm, "side_brush", end, v3(0, dmg_sign(b), 0));
        dmg_cone(b, v3(end.x, 0, end.z), v3(end.x, 0.35f * t->deck, end.z), r, 0.5f * r);
        dmg_rod(b, v3(end.x, 0.3f * t->deck, end.z), v3(end.x, 0.65f * t->deck, end.z), 0.2f * r);
        dmg_use(b, 0);
    }
    float y = 0.4f * t->deck;
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 0.85f * w - 0.02f * size, y - 0.05f * size, z - 0.3f * size),
                     v3((float)k * 0.85f * w + 0.02f * size, t->deck, z - 0.2f * size));
    dmg_spin(b, 0, "roller_brush", v3(0, y, z - 0.25f * size), v3(1, 0, 0));
    dmg_rod(b, v3(-0.8f * w, y, z - 0.25f * size), v3(0.8f * w, y, z - 0.25f * size), 0.95f * y);
    dmg_use(b, 0);
}

void dmg_build_mixer_truck(dmg_builder* b) {
    float size = dmg_chance(b, 0.3f) ? dmg_scale_range(b, 0.06f, 0.6f) : dmg_range(b, 2.0f, 2.8f);
    dmg_truck t = dmg_truck_pick(b, size);
    t.length = fmaxf(t.length, 1.8f * size);
    dmg_truck_draw(b, &t);
    dmg_use(b, 0);
    int kind = dmg_weighted(b, (const float[]){3, 2, 2}, 3);
    if (kind == 0) draw_mixer_back(b, &t, size);
    if (kind == 1) draw_refuse_back(b, &t, size);
    if (kind == 2) draw_sweeper_back(b, &t, size);
}

/* ---- fire engine ---- */

/* Draws a barrel on a base that pans and tilts. */
static void draw_monitor(dmg_builder* b, uint32_t parent, dmg_vec at, float size) {
    dmg_use(b, parent);
    dmg_rod(b, at, v3_add(at, v3(0, 0.3f * size, 0)), 0.2f * size);
    uint32_t pan = dmg_hinge(b, parent, "monitor_pan", at, v3(0, dmg_sign(b), 0), -2.5f, 2.5f);
    dmg_box(b, v3_add(at, v3(0, 0.5f * size, 0)), v3(0.35f * size, 0.38f * size, 0.35f * size));
    dmg_vec pin = v3_add(at, v3(0, 0.6f * size, 0));
    uint32_t tilt = dmg_hinge_across(b, pan, "monitor_tilt", pin, -0.3f, 1.2f);
    dmg_rod(b, v3_add(pin, v3(-0.25f * size, 0, 0)), v3_add(pin, v3(0.25f * size, 0, 0)), 0.1f * size);
    dmg_cone(b, pin, v3_add(pin, v3(0, 0.15f * size, 1.3f * size)), 0.12f * size, 0.08f * size);
    dmg_vec tip = v3_add(pin, v3(0, 0.15f * size, 1.3f * size));
    dmg_spin(b, tilt, "nozzle", tip, v3_normalize(v3(0, 0.15f, 1.3f)));
    dmg_cone(b, v3_add(tip, v3(0, 0.002f * size, 0.02f * size)), v3_add(tip, v3(0, 0.03f * size, 0.25f * size)),
             0.1f * size, 0.15f * size);
    dmg_use(b, parent);
}

/* Lockers along the sides: roller shutters going up, doors, drawers behind, drop-down steps. */
static void draw_lockers(dmg_builder* b, const dmg_truck* t, float top) {
    int count = dmg_int(b, 2, 4), kind = dmg_int(b, 0, 2);
    float z0 = 0.06f * t->length, z1 = 0.94f * t->length, each = (z1 - z0) / (float)count, low = t->deck,
          h = 0.85f * (top - low), y = low + 0.07f * (top - low), d = 0.05f * t->half;
    for (int i = 0; i < 2 * count; ++i) {
        float s = i % 2 ? -1.0f : 1.0f, z = z0 + each * ((float)(i / 2) + 0.5f);
        dmg_wall_enter(b, v3(s * t->half, y, z), s * 0.5f * DMG_PI);
        if (kind == 0) { /* a shutter drawn as a slab with ribs, going up over the roof's edge */
            int ribs = dmg_int(b, 3, 7);
            for (int k = -1; k <= 1; k += 2)
                dmg_box_span(b, v3((float)k * 0.46f * each - 0.02f * each, 0, 0),
                             v3((float)k * 0.46f * each + 0.02f * each, h, 1.5f * d));
            dmg_slide(b, 0, "shutter", v3(0, 1, 0), 0.0f, 0.85f * h);
            dmg_box_span(b, v3(-0.43f * each, 0.01f * h, 0.2f * d), v3(0.43f * each, h, 0.8f * d));
            for (int k = 0; k < ribs; ++k)
                dmg_box(b, v3(0, h * ((float)k + 0.5f) / (float)ribs, 0.8f * d),
                        v3(0.84f * each, 0.3f * h / (float)ribs, 0.4f * d));
            dmg_box(b, v3(0, 0.05f * h, 1.4f * d), v3(0.5f * each, 0.03f * h, 1.2f * d));
        } else {
            dmg_move(b, 0, 0.5f * h, 0);
            dmg_wall_leaf_draw(b, 0, "locker_door", 0.9f * each, h,
                               kind == 1 ? DMG_SIDE_TOP
                               : s > 0   ? DMG_SIDE_LEFT
                                         : DMG_SIDE_RIGHT);
        }
        dmg_use(b, 0);
        dmg_restore(b);
        if (dmg_chance(b, 0.3f)) { /* a tray below the lockers */
            dmg_slide(b, 0, "drawer", v3(s, 0, 0), 0.0f, 0.7f * t->half);
            dmg_box_span(b, v3(fminf(s * 0.3f, s * 1.04f) * t->half, low - 0.12f * t->half, z - 0.4f * each),
                         v3(fmaxf(s * 0.3f, s * 1.04f) * t->half, low - 0.01f * t->half, z + 0.4f * each));
            dmg_use(b, 0);
        }
    }
}

/* Ladder sections in each other on a turntable: turns, raises, runs out; a cage at its end. */
static void draw_ladder(dmg_builder* b, const dmg_truck* t, float y, float size) {
    int sections = dmg_int(b, 1, 4), rungs = 8;
    bool cage = dmg_chance(b, 0.5f), behind = dmg_chance(b, 0.6f);
    float z = behind ? 0.15f * t->length : 0.7f * t->length, dir = behind ? 1.0f : -1.0f,
          l = t->length * dmg_range(b, 0.8f, 1.0f), half = 0.3f * t->half, h = 0.06f * size;
    dmg_rod(b, v3(0, y, z), v3(0, y + 0.06f * size, z), 0.6f * t->half);
    uint32_t part = dmg_spin(b, 0, "turntable", v3(0, y, z), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, y + 0.061f * size, z), v3(0, y + 0.1f * size, z), 0.6f * t->half);
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 1.25f * half - 0.02f * size, y + 0.1f * size, z - 0.1f * size),
                     v3((float)k * 1.25f * half + 0.02f * size, y + 0.32f * size, z + 0.05f * size));
    float base = y + 0.25f * size, from = z - dir * 0.05f * size;
    part = dmg_hinge(b, part, "ladder", v3(0, base, from), v3(-dir, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.3f));
    dmg_rod(b, v3(-1.22f * half, base, from), v3(1.22f * half, base, from), 0.03f * size);
    for (int i = 0; i < sections; ++i) {
        float w = half * (1.0f - 0.17f * (float)i), at = base + 0.5f * h * (float)i;
        if (i) part = dmg_slide(b, part, "ladder_section", v3(0, 0, dir), 0.0f, 0.8f * l);
        for (int k = -1; k <= 1; k += 2) {
            dmg_beam(b, v3((float)k * w, at, from), v3((float)k * w, at, from + dir * l), 0.05f * half, 0.3f * h);
            dmg_beam(b, v3((float)k * w, at + h, from), v3((float)k * w, at + h, from + dir * l), 0.05f * half,
                     0.2f * h);
        }
        for (int r = 0; r < rungs; ++r) {
            float rz = from + dir * l * ((float)r + 0.5f) / (float)rungs;
            dmg_rod(b, v3(-w, at, rz), v3(w, at, rz), 0.1f * h);
            for (int k = -1; k <= 1; k += 2)
                dmg_beam(b, v3((float)k * w, at, rz), v3((float)k * w, at + h, rz), 0.05f * half, 0.1f * h);
        }
    }
    float end = from + dir * (l + 0.02f * size), cy = base + 0.5f * h * (float)(sections - 1);
    if (cage) {
        uint32_t basket = dmg_hinge(b, part, "cage", v3(0, cy, end), v3(dir, 0, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(-0.8f * half, cy, fminf(end, end + dir * 0.3f * size)),
                     v3(0.8f * half, cy + 0.02f * size, fmaxf(end, end + dir * 0.3f * size)));
        for (int k = 0; k < 4; ++k)
            dmg_box(b,
                    v3((k & 1 ? 0.78f : -0.78f) * half, cy + 0.12f * size, end + dir * (k & 2 ? 0.29f : 0.01f) * size),
                    v3(0.02f * size, 0.24f * size, 0.02f * size));
        draw_monitor(b, basket, v3(0, cy + 0.02f * size, end + dir * 0.15f * size), 0.15f * size);
    }
    dmg_use(b, 0);
}

static void draw_outriggers(dmg_builder* b, const dmg_truck* t, float size) {
    for (int i = 0; i < 4; ++i) {
        float s = i & 1 ? 1.0f : -1.0f, z = (i & 2 ? 0.62f : 0.03f) * t->length, y = t->deck - 0.08f * size,
              w = 0.9f * t->half;
        dmg_use(b, 0);
        uint32_t beam = dmg_slide(b, 0, "outrigger", v3(s, 0, 0), 0.0f, 0.8f * t->half);
        dmg_box_span(b, v3(fminf(s * 0.1f * w, s * w), y - 0.04f * size, z - 0.04f * size),
                     v3(fmaxf(s * 0.1f * w, s * w), y + 0.04f * size, z + 0.04f * size));
        dmg_slide(b, beam, "outrigger_foot", v3(0, -1, 0), 0.0f, 0.4f * t->deck);
        dmg_rod(b, v3(s * 1.05f * w, 0.45f * t->deck, z), v3(s * 1.05f * w, y + 0.08f * size, z), 0.03f * size);
        dmg_rod(b, v3(s * 1.05f * w, 0.41f * t->deck, z), v3(s * 1.05f * w, 0.45f * t->deck, z), 0.07f * size);
    }
    dmg_use(b, 0);
}

void dmg_build_fire_engine(dmg_builder* b) {
    float size = dmg_chance(b, 0.3f) ? dmg_scale_range(b, 0.06f, 0.6f) : dmg_range(b, 2.0f, 2.8f);
    dmg_truck t = dmg_truck_pick(b, size);
    t.length = fmaxf(t.length, 1.8f * size);
    float top = t.deck + size * dmg_range(b, 0.45f, 0.75f);
    dmg_truck_draw(b, &t);
    dmg_use(b, 0);
    dmg_box_span(b, v3(-t.half, t.deck, 0), v3(t.half, top, 0.97f * t.length));
    draw_lockers(b, &t, top);
    if (dmg_chance(b, 0.6f)) draw_outriggers(b, &t, size);
    int kind = dmg_weighted(b, (const float[]){3, 2, 1}, 3);
    if (kind == 0) draw_ladder(b, &t, top, size);
    if (kind == 1) {
        float at = t.length * dmg_range(b, 0.4f, 0.8f), big = size * dmg_range(b, 0.2f, 0.35f);
        draw_monitor(b, 0, v3(0, top, at), big);
    }
    dmg_wall_enter(b, v3(0, 0.5f * (t.deck + top), 0), DMG_PI);
    if (dmg_chance(b, 0.7f))
        dmg_wall_leaf_draw(b, 0, "pump_door", t.half, 0.85f * (top - t.deck),
                           dmg_chance(b, 0.6f) ? DMG_SIDE_TOP : DMG_SIDE_LEFT);
    dmg_restore(b);
}
