/* Draws an aircraft's landing gear and covers: legs with their doors, bays in round and flat skins, canopies over a
 * cockpit. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- gear leg ---- */

typedef struct leg {
    float length, radius, wheel, width;
    int wheels; /* 1, 2 side by side, 4 on a beam */
    bool strut; /* the lower half slides in the upper one */
} leg;

static void draw_wheel_pair(dmg_builder* b, uint32_t carrier, const leg* l, int kind, bool spins, dmg_vec axle) {
    float half = l->wheels == 1 ? 0.0f : 0.6f * l->width + 1.2f * l->radius;
    if (l->wheels > 1) dmg_rod(b, v3_add(axle, v3(-half, 0, 0)), v3_add(axle, v3(half, 0, 0)), 0.5f * l->radius);
    bool apart = dmg_chance(b, 0.5f);
    if (spins && !apart) dmg_spin(b, carrier, "wheel", axle, v3(1, 0, 0));
    for (int k = 0; k < (l->wheels == 1 ? 1 : 2); ++k) {
        dmg_save(b);
        dmg_move(b, l->wheels == 1 ? axle.x : axle.x + (float)(2 * k - 1) * half, axle.y, axle.z);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        if (spins && apart) dmg_spin(b, carrier, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, kind, l->wheel, l->width, 6);
        dmg_restore(b);
    }
    dmg_use(b, carrier);
}

/* Draws two links behind the strut. */
static void draw_torque_links(dmg_builder* b, const leg* l) {
    float r = 0.4f * l->radius, out = -l->length * 0.2f;
    dmg_beam(b, v3(0, -0.45f * l->length, 0), v3(0, -0.62f * l->length, out), 2 * l->radius, r);
    dmg_beam(b, v3(0, -0.62f * l->length, out), v3(0, -0.8f * l->length, 0), 1.6f * l->radius, r);
}

/* From the trunnion at the origin downwards; `carrier` is what folds. */
static void draw_leg(dmg_builder* b, uint32_t carrier, const leg* l) {
    int kind = dmg_int(b, 0, 2);
    bool spins = dmg_chance(b, 0.8f), steers = dmg_chance(b, 0.3f), links = dmg_chance(b, 0.5f);
    dmg_rod(b, v3(0, 0.5f * l->radius, 0), v3(0, -0.55f * l->length, 0), l->radius);
    if (links && !l->strut && !steers) draw_torque_links(b, l);
    if (steers)
        carrier = dmg_hinge_either_way(b, carrier, "steering", v3(0, 0, 0), v3(0, 1, 0), 0.4f, 1.2f);
    else if (l->strut)
        carrier = dmg_slide(b, carrier, "strut", v3(0, 1, 0), 0.0f, l->length * dmg_range(b, 0.08f, 0.2f));
    dmg_rod(b, v3(0, -0.5f * l->length, 0), v3(0, -l->length, 0), 0.7f * l->radius);
    dmg_vec foot = {l->wheels == 1 ? 0.6f * l->width + l->radius : 0, -l->length, 0};
    if (l->wheels == 1 && dmg_chance(b, 0.4f)) { /* a fork holds it */
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 0.7f * l->width, -l->length + 1.3f * l->wheel, 0),
                     v3((float)s * 0.7f * l->width, -l->length, 0), 0.6f * l->radius, l->radius);
        dmg_box(b, v3(0, -l->length + 1.3f * l->wheel, 0), v3(2 * l->width, l->radius, 1.5f * l->radius));
        foot.x = 0;
    } else if (l->wheels == 1) {
        dmg_rod(b, v3(0, -l->length, 0), foot, 0.6f * l->radius);
    }
    if (l->wheels < 4) {
        draw_wheel_pair(b, carrier, l, kind, spins, foot);
        return;
    }
    float reach = 1.15f * l->wheel, tilt = dmg_range(b, 0.2f, 0.6f);
    uint32_t beam = dmg_chance(b, 0.6f) ? dmg_hinge(b, carrier, "bogie", foot, v3(1, 0, 0), -tilt, tilt) : carrier;
    dmg_box(b, foot, v3(1.2f * l->radius, 1.4f * l->radius, 2.3f * reach));
    for (int s = -1; s <= 1; s += 2) draw_wheel_pair(b, beam, l, kind, spins, v3_add(foot, v3(0, 0, (float)s * reach)));
}

/* Draws a door of the bay beside the leg: hung along the bay's side, or across its end. */
static void draw_leg_door(dmg_builder* b, float side, float half, float deep, float z0, float z1) {
    float t = 0.03f * half + 0.01f * deep, swing = dmg_range(b, 1.2f, 1.9f);
    uint32_t door = dmg_hinge(b, 0, "gear_door", v3(side * half, 0, 0), v3(0, 0, -side), 0.0f, swing);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, door, swing);
    dmg_box_span(b, v3(fminf(side * half, side * 0.02f * half), -t, z0),
                 v3(fmaxf(side * half, side * 0.02f * half), 0, z1));
    dmg_use(b, 0);
}

/* Rails of the bay and the pin between them: forwards or backwards (`along` Z), or to the side. */
static void draw_bay_frame(dmg_builder* b, float half, float deep, float z0, float z1, float t) {
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * half - 0.5f * t + (float)s * t, 0, z0),
                     v3((float)s * half + 0.5f * t + (float)s * t, deep, z1));
    dmg_box_span(b, v3(-half - 1.5f * t, deep, z0), v3(half + 1.5f * t, deep + t, z1));
}

void dmg_build_gear_leg(dmg_builder* b) {
    leg l = {.length = dmg_scale_range(b, 0.1f, 3.0f)};
    static const int wheels[] = {1, 2, 4};
    l.radius = l.length * dmg_range(b, 0.03f, 0.09f);
    l.wheel = l.length * dmg_range(b, 0.15f, 0.38f);
    l.width = l.wheel * dmg_range(b, 0.3f, 0.8f);
    l.wheels = wheels[dmg_int(b, 0, 2)];
    l.strut = dmg_chance(b, 0.35f);
    if (l.wheels == 4) l.wheel *= 0.7f;
    int way = dmg_int(b, 0, 3); /* forwards, backwards, to either side */
    float half = 1.3f * l.width + 3 * l.radius + (way > 1 ? l.wheel : 0.0f), deep = 1.2f * l.wheel + l.radius,
          t = 0.5f * l.radius, reach = 1.1f * (l.length + l.wheel), lean = dmg_range(b, -0.15f, 0.15f);
    dmg_move(b, 0, l.length + l.wheel, 0);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), (way == 1 ? DMG_PI : (way == 2 ? 0.5f * DMG_PI : (way == 3 ? -0.5f * DMG_PI : 0.0f))));
    bool bay = dmg_chance(b, 0.7f);
    if (bay) draw_bay_frame(b, half, deep, -3 * l.radius, reach, t);
    if (!bay) dmg_box(b, v3(0, 2 * l.radius, 0), v3(2 * half, 2 * l.radius, 6 * l.radius));
    dmg_rod(b, v3(-half - t, l.radius, 0), v3(half + t, l.radius, 0), 0.6f * l.radius);
    int doors = bay ? dmg_int(b, 0, 2) : 0;
    float from = dmg_range(b, 1.5f, 3.0f) * l.radius;
    for (int s = 0; s < doors; ++s) draw_leg_door(b, s ? -1.0f : 1.0f, half, deep, from, reach);
    /* About -X what hangs down goes forwards. */
    float fold = dmg_range(b, 1.3f, 1.65f);
    uint32_t part = dmg_hinge(b, 0, "leg", v3(0, l.radius, 0), v3(-1, 0, 0), 0.0f, fold);
    if (dmg_chance(b, 0.2f)) dmg_rest(b, part, fold);
    if (dmg_chance(b, 0.4f)) /* its own door rides on it */
        dmg_box(b, v3(0, -0.5f * l.length, -2.2f * l.radius), v3(0.9f * half, 0.9f * l.length, 0.5f * l.radius));
    dmg_turn(b, v3(0, 1, 0), (way == 1 ? -DMG_PI : (way == 2 ? -0.5f * DMG_PI : (way == 3 ? 0.5f * DMG_PI : 0.0f))));
    dmg_turn(b, v3(0, 0, 1), way > 1 ? 0.0f : lean);
    draw_leg(b, part, &l);
    dmg_restore(b);
}

/* ---- bays in a round skin ---- */

enum { ARC_LIMIT = 12 };

/* Draws a sheet along an arc in x, y about the origin, from angle a0 to a1 (0: +X, counter-clockwise), z0 … z1. */
static void draw_arc(dmg_builder* b, float radius, float high, float a0, float a1, float t, float z0, float z1) {
    dmg_xy line[ARC_LIMIT + 1];
    int steps = (int)ceilf((float)b->sides * fabsf(a1 - a0) / (2.0f * DMG_PI));
    steps = steps < 2 ? 2 : (steps > ARC_LIMIT ? ARC_LIMIT : steps);
    for (int i = 0; i <= steps; ++i) {
        float angle = a0 + (a1 - a0) * (float)i / (float)steps;
        line[i] = (dmg_xy){radius * cosf(angle), high * radius * sinf(angle)};
    }
    dmg_save(b);
    dmg_move(b, 0, 0, 0.5f * (z0 + z1));
    dmg_bent_plate(b, line, steps + 1, t, z1 - z0);
    dmg_restore(b);
}

/* Doors meeting in the middle of the bay, each hung along its outer edge; or one alone; some in two leaves. */
static void draw_arc_doors(dmg_builder* b, float radius, float high, float middle, float half, float t, float z0,
                           float z1) {
    int leaves = dmg_int(b, 1, 2), along = dmg_int(b, 1, 3);
    float swing = dmg_range(b, 0.9f, 1.8f), each = (z1 - z0) / (float)along, gap = 0.01f * (z1 - z0),
          out = t * dmg_unit(b);
    bool slides = dmg_chance(b, 0.12f), folds = leaves == 1 && dmg_chance(b, 0.3f);
    for (int i = 0; i < along * leaves; ++i) {
        float s = i % leaves ? -1.0f : 1.0f, from = z0 + each * (float)(i / leaves) + gap, to = from + each - 2 * gap;
        float edge = middle + s * half, other = leaves == 1 ? middle - half : middle, fold = 0.5f * (edge + other);
        dmg_vec line = {(radius + out) * cosf(edge), high * (radius + out) * sinf(edge), 0};
        if (slides)
            dmg_slide(b, 0, "bay_door", v3(0, 0, i / leaves * 2 < along ? -1.0f : 1.0f), 0.0f, 0.8f * each);
        else
            dmg_hinge(b, 0, "bay_door", line, v3(0, 0, s), 0.0f, swing);
        uint32_t door = b->part_count;
        if (!folds || slides) {
            draw_arc(b, slides ? radius + t : radius, high, fminf(edge, other), fmaxf(edge, other), t, from, to);
        } else {
            draw_arc(b, radius, high, fminf(edge, fold), fmaxf(edge, fold), t, from, to);
            dmg_hinge(b, door, "leaf", v3(radius * cosf(fold), high * radius * sinf(fold), 0), v3(0, 0, -s), 0.0f,
                      dmg_range(b, 0.8f, 1.8f));
            draw_arc(b, radius, high, fminf(fold, other), fmaxf(fold, other), t, from, to);
        }
        dmg_use(b, 0);
    }
}

void dmg_build_hull_bay(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.1f, 4.0f), high = dmg_range(b, 0.6f, 1.3f),
          length = radius * dmg_range(b, 1.0f, 6.0f), t = radius * dmg_range(b, 0.01f, 0.05f),
          half = dmg_range(b, 0.25f, 0.8f);
    float middle = -0.5f * DMG_PI; /* below, at a side, on top */
    static const float weights[] = {5, 2, 2, 1};
    int place = dmg_weighted(b, weights, 4);
    if (place == 1) middle = dmg_range(b, -0.3f, 0.5f);
    if (place == 2) middle = DMG_PI - dmg_range(b, -0.3f, 0.5f);
    if (place == 3) middle = 0.5f * DMG_PI;
    float z0 = -length * dmg_range(b, 0.2f, 0.45f), z1 = length * dmg_range(b, 0.2f, 0.45f);
    bool whole = dmg_chance(b, 0.4f); /* a half shell: the rest of the body is not there */
    float around = whole ? DMG_PI : half + dmg_range(b, 0.3f, 1.2f);
    dmg_move(b, 0, 1.4f * radius, 0);
    draw_arc(b, radius, high, middle - around, middle + around, t, -0.5f * length, z0);
    draw_arc(b, radius, high, middle - around, middle + around, t, z1, 0.5f * length);
    for (int s = 0; s < 2; ++s) {
        float a0 = s ? middle - around : middle + half, a1 = s ? middle - half : middle + around;
        draw_arc(b, radius, high, a0, a1, t, z0, z1);
    }
    draw_arc_doors(b, radius, high, middle, half, t, z0, z1);
}

/* ---- canopy ---- */

/* Draws a bubble of frames and panes between z0 and z1, open below, lower at its ends by their `taper`. */
static void draw_bubble(dmg_builder* b, float wide, float high, float t, float z0, float z1) {
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) draw_arc(b, wide, high / wide, 0.02f, DMG_PI - 0.02f, t, z0, z1);
    if (kind == 1) { /* frames at both ends, panes as one sheet between */
        draw_arc(b, wide, high / wide, 0.02f, DMG_PI - 0.02f, 2 * t, z0, z0 + 3 * t);
        draw_arc(b, wide, high / wide, 0.02f, DMG_PI - 0.02f, 2 * t, z1 - 3 * t, z1);
        draw_arc(b, wide, high / wide, 0.02f, DMG_PI - 0.02f, 0.5f * t, z0, z1);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * wide - t, 0, z0), v3((float)s * wide + t, 2 * t, z1));
    }
    if (kind == 2) {
        float end = dmg_range(b, 0.5f, 0.95f), middle = 0.5f * (z0 + z1);
        const dmg_xy arch[] = {{wide, 0},
                               {0.85f * wide, 0.65f * high},
                               {0.4f * wide, high},
                               {-0.4f * wide, high},
                               {-0.85f * wide, 0.65f * high},
                               {-wide, 0}};
        const dmg_row rows[] = {{end, end, 0, z0}, {1, 1, 0, middle}, {end, end, 0, z1}};
        dmg_loft(b, arch, 6, rows, 3);
    }
}

static void add_canopy_joint(dmg_builder* b, int kind, float wide, float z0, float z1) {
    float swing = dmg_range(b, 0.5f, 1.2f), low = wide * dmg_range(b, -0.1f, 0.1f);
    if (kind == 0) dmg_hinge(b, 0, "canopy", v3(0, low, z0), v3(-1, 0, 0), 0.0f, swing);
    if (kind == 1) dmg_hinge(b, 0, "canopy", v3(0, low, z1), v3(1, 0, 0), 0.0f, swing);
    if (kind == 2) dmg_hinge(b, 0, "canopy", v3(wide, low, 0), v3(0, 0, -1), 0.0f, 1.4f * swing);
    if (kind == 3) dmg_hinge(b, 0, "canopy", v3(-wide, low, 0), v3(0, 0, 1), 0.0f, 1.4f * swing);
    if (kind == 4) {
        const float upper = dmg_range(b, 0.5f, 1.0f) * (z1 - z0);
        const dmg_vec direction = v3(0, dmg_range(b, 0.0f, 0.15f), -1);
        dmg_slide(b, 0, "canopy", direction, 0.0f, upper);
    }
}

void dmg_build_canopy(dmg_builder* b) {
    float wide = dmg_scale_range(b, 0.1f, 1.2f), length = wide * dmg_range(b, 1.2f, 3.5f),
          high = wide * dmg_range(b, 0.5f, 1.2f), deep = wide * dmg_range(b, 0.4f, 1.5f), t = 0.03f * wide,
          front = wide * dmg_range(b, 0.5f, 2.5f), back = wide * dmg_range(b, 0.3f, 3.0f);
    int count = dmg_int(b, 1, 2), kind = dmg_int(b, 0, 4);
    dmg_move(b, 0, deep + wide, 0);
    float z1 = 0.5f * length, z0 = -z1;
    /* The tub: sides and floor, or the solid nose of an aircraft. */
    if (dmg_chance(b, 0.5f)) {
        dmg_save(b);
        dmg_face_up(b);
        dmg_case_draw(b, dmg_case_pick(b), 2.1f * wide, length, deep, 1.5f * t);
        dmg_restore(b);
    } else {
        dmg_box_span(b, v3(-1.05f * wide, -deep, z0), v3(1.05f * wide, -0.02f * wide, z1));
    }
    const dmg_xy nose[] = {{1.05f * wide, -deep}, {1.05f * wide, 0}, {-1.05f * wide, 0}, {-1.05f * wide, -deep}};
    const dmg_row fore[] = {
        {1, 1, 0, z1}, {0.7f, 0.7f, -0.1f * deep, z1 + 0.6f * front}, {0.1f, 0.3f, -0.2f * deep, z1 + front}};
    const dmg_row aft[] = {{0.3f, 0.5f, 0, z0 - back}, {1, 1, 0, z0}};
    dmg_loft(b, nose, 4, fore, 3);
    if (dmg_chance(b, 0.7f)) dmg_loft(b, nose, 4, aft, 2);
    if (dmg_chance(b, 0.6f)) { /* a windscreen that stays */
        const dmg_xy pane[] = {{z1 + 0.02f * wide, 0}, {z1 + 0.45f * front, 0}, {z1 + 0.02f * wide, 0.8f * high}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, pane, 3, -0.6f * wide, 0.6f * wide);
        dmg_restore(b);
    }
    for (int i = 0; i < count; ++i) {
        float each = length / (float)count, from = z0 + each * (float)i, to = from + 0.98f * each;
        add_canopy_joint(b, kind, wide, from, to);
        draw_bubble(b, wide, high, t, from, to);
        dmg_use(b, 0);
    }
}
