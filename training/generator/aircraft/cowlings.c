/* Draws piston engines under their cowlings: rings of flaps, panels, bonnets in halves, scoops with doors, shutters,
 * lowered radiators, propellers whose blades turn. The propeller is in front. */
#include "core/build.h"
#include "core/skins.h"
#include "parts/hardware.h"

/* ---- what both kinds of engine have ---- */

/* Draws a propeller behind whose spinner the blades may turn about their own lines. */
static void draw_propeller(dmg_builder* b, float z, float hub, float blade) {
    int count = dmg_int(b, 2, 5), kind = dmg_int(b, 0, 2);
    float chord = blade * dmg_range(b, 0.1f, 0.25f), twist = dmg_range(b, 0.3f, 0.9f),
          length = hub * dmg_range(b, 0.8f, 2.5f);
    bool pitches = dmg_chance(b, 0.4f), blunt = dmg_chance(b, 0.3f);
    const dmg_xy cone[] = {{0, 0}, {hub, 0}, {0.75f * hub, 0.5f * length}, {0, length}};
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    dmg_rod(b, v3(0, 0, -0.5f * hub), v3(0, 0, 0.05f * hub), 0.4f * hub); /* the shaft */
    uint32_t spinner = dmg_spin(b, 0, "propeller", v3(0, 0, 0), v3(0, 0, 1));
    if (blunt)
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * length), 0.6f * hub);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cone, 4);
    dmg_move(b, 0, 0, 0.3f * length);
    if (!pitches) dmg_blades_draw(b, kind, blade, hub, chord, count, twist);
    for (int i = 0; i < count && pitches; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, count);
        dmg_hinge(b, spinner, "blade", v3(0, 0, 0), v3(1, 0, 0), -0.3f, 1.0f);
        dmg_blades_draw(b, kind, blade, hub, chord, 1, twist);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a duct below y = 0 from the front z1 back to z0: doors at its exit, slats in its mouth. */
static void draw_scoop(dmg_builder* b, float half, float deep, float z0, float z1) {
    float t = 0.06f * deep, mouth = deep * dmg_range(b, 0.8f, 1.0f), swing = dmg_range(b, 0.3f, 0.9f),
          door = (z1 - z0) * dmg_range(b, 0.25f, 0.5f);
    bool exit = dmg_chance(b, 0.8f), rear = dmg_chance(b, 0.3f);
    int slats = dmg_chance(b, 0.4f) ? dmg_int(b, 2, 5) : 0;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * half - 0.5f * t, -mouth, z0), v3((float)s * half + 0.5f * t, 0.3f * deep, z1));
    dmg_box_span(b, v3(-half, -mouth, exit ? z0 + door : z0), v3(half, -mouth + t, z1));
    if (exit) { /* about its front edge, the rear goes down; or it is hung behind and scoops */
        dmg_hinge(b, 0, "scoop_door", v3(0, -mouth + 0.5f * t, rear ? z0 : z0 + door), v3(rear ? 1.0f : -1.0f, 0, 0),
                  0.0f, swing);
        dmg_box_span(b, v3(-half + t, -mouth, z0), v3(half - t, -mouth + t, z0 + 0.99f * door));
        dmg_use(b, 0);
    }
    for (int i = 0; i < slats; ++i) {
        float each = (mouth - t) / (float)slats, y = -mouth + t + each * ((float)i + 0.5f);
        dmg_hinge(b, 0, "slat", v3(0, y, z1 - 0.5f * each), v3(1, 0, 0), 0.0f, 1.4f);
        dmg_box(b, v3(0, y, z1 - 0.5f * each), v3(2 * half - 2 * t, 0.1f * each, 0.9f * each));
        dmg_use(b, 0);
    }
}

/* ---- round: cylinders in a star ---- */

typedef struct cowl {
    float r, length, t;
    float mid0, mid1; /* between them panels, where it has some */
} cowl;

static void draw_star(dmg_builder* b, const cowl* c) {
    int cylinders = dmg_int(b, 5, 9), rows = dmg_int(b, 1, 2);
    float z = 0.55f * c->length, wide = c->r * 1.2f / (float)cylinders;
    dmg_cone(b, v3(0, 0, -0.02f * c->r), v3(0, 0, 0.98f * c->length), 0.38f * c->r, 0.2f * c->r);
    for (int i = 0; i < cylinders * rows; ++i) {
        float angle = 2 * DMG_PI * ((float)i + (i < cylinders ? 0.0f : 0.5f)) / (float)cylinders,
              at = z - (i < cylinders ? 0.0f : 0.3f * c->length);
        dmg_rod(b, dmg_skin_point(0.2f * c->r, angle, at), dmg_skin_point(0.8f * c->r, angle, at),
                fminf(wide, 0.14f * c->length));
    }
}

/* Panels that peel away from the engine, hung along their upper edges or their front ones. */
static void draw_peels(dmg_builder* b, const cowl* c) {
    int each = dmg_int(b, 1, 2); /* a side */
    bool front = dmg_chance(b, 0.35f);
    float swing = dmg_range(b, 0.7f, 1.4f), strip = dmg_range(b, 0.03f, 0.2f), gap = 0.01f * c->length;
    dmg_xy back = {c->r, c->mid0 + gap}, fore = {c->r, c->mid1 - gap};
    for (int s = -1; s <= 1; s += 2) {
        for (int i = 0; i < each; ++i) {
            float side = (float)s, share = (DMG_PI - 2 * strip) / (float)each,
                  high = 0.5f * DMG_PI - side * (strip + share * (float)i), low = high - side * 0.97f * share;
            if (front)
                dmg_hinge(b, 0, "cowl_panel", dmg_skin_point(c->r, 0.5f * (high + low), c->mid1),
                          v3_scale(dmg_skin_tangent(0.5f * (high + low)), -1), 0.0f, swing);
            else
                dmg_hinge(b, 0, "cowl_panel", dmg_skin_point(c->r, high, 0), v3(0, 0, side), 0.0f, swing);
            dmg_skin_cone(b, back, fore, fminf(high, low), fmaxf(high, low), c->t);
            dmg_use(b, 0);
        }
        float middle = 0.5f * DMG_PI * (float)s;
        dmg_skin_cone(b, (dmg_xy){c->r, c->mid0}, (dmg_xy){c->r, c->mid1}, middle - 0.95f * strip,
                      middle + 0.95f * strip, c->t);
    }
}

/* Draws what lets the air out behind: flaps all round, on the lower half or at both sides; or a ring that slides. */
static void draw_outlet(dmg_builder* b, const cowl* c) {
    float deep = c->r * dmg_range(b, 0.18f, 0.45f), rear = c->r * dmg_range(b, 0.93f, 1.0f),
          swing = dmg_range(b, 0.2f, 0.75f);
    if (dmg_chance(b, 0.2f)) {
        float way = 0.8f * deep, rest = way * dmg_unit(b);
        bool over = dmg_chance(b, 0.5f);
        float r = over ? c->r + 0.03f * c->r : c->r;
        uint32_t ring = dmg_slide(b, 0, "gill_ring", v3(0, 0, over ? 1.0f : -1.0f), 0.0f, way);
        if (dmg_chance(b, 0.4f)) dmg_rest(b, ring, rest);
        dmg_skin_cone(b, (dmg_xy){over ? r : rear, -deep}, (dmg_xy){r, over ? 0.1f * deep : -0.01f * deep}, 0,
                      2 * DMG_PI, fmaxf(c->t, over ? 0.02f * c->r : 0.0f));
        dmg_use(b, 0);
        return;
    }
    int kind = dmg_int(b, 0, 2);
    dmg_band d = {
        .name = "cowl_flap", .back = {rear, -deep}, .front = {c->r, -0.01f * deep}, .t = c->t, .upper = swing};
    d.fill = dmg_range(b, 0.7f, 0.98f);
    d.plates = dmg_chance(b, 0.4f);
    if (dmg_chance(b, 0.4f)) d.rest = swing * dmg_range(b, 0.3f, 1.0f);
    d.count = dmg_int(b, 6, 14);
    d.arc = 2 * DMG_PI;
    if (kind == 1) {
        d.arc = dmg_range(b, 1.8f, 4.2f);
        d.start = -0.5f * DMG_PI - 0.5f * d.arc;
        d.count = dmg_int(b, 2, 8);
    }
    if (kind < 2) dmg_band_draw(b, &d);
    for (int s = 0; s < 2 && kind == 2; ++s) {
        dmg_band side = d;
        side.arc = 1.7f;
        side.start = (s ? DMG_PI : 0.0f) - 0.85f;
        side.count = 1 + d.count / 3;
        dmg_band_draw(b, &side);
    }
    if (kind > 0 && dmg_chance(b, 0.5f)) { /* the skin goes on where there are none */
        float from = kind == 1 ? d.start + d.arc : 0.9f, to = kind == 1 ? d.start + 2 * DMG_PI : DMG_PI - 0.9f;
        dmg_skin_cone(b, d.back, (dmg_xy){c->r, 0}, from + 0.03f, to - 0.03f, c->t);
    }
}

static void draw_round_cowling(dmg_builder* b, float r) {
    cowl c = {.r = r};
    c.length = r * dmg_range(b, 0.7f, 1.8f);
    c.t = dmg_chance(b, 0.4f) ? 0.0f : r * dmg_range(b, 0.015f, 0.05f);
    bool peels = dmg_chance(b, 0.4f), ring = dmg_chance(b, 0.2f);
    float lip = r * dmg_range(b, 0.6f, 0.85f), body = r * dmg_range(b, 0.78f, 0.86f),
          tail = r * dmg_range(b, 0.5f, 3.0f);
    c.mid0 = c.length * dmg_range(b, 0.02f, 0.15f);
    c.mid1 = c.length * dmg_range(b, 0.5f, 0.7f);
    if (!peels) c.mid1 = c.mid0;
    const dmg_xy rows[] = {{r, c.mid1},
                           {r * 1.005f, c.mid1 + 0.01f * r},
                           {0.5f * (r + lip) + 0.08f * r, 0.3f * c.mid1 + 0.7f * c.length},
                           {lip, c.length}};
    dmg_skin fore = {.rows = rows, .count = ring ? 3 : 4, .from = 0, .to = 2 * DMG_PI, .t = c.t, .high = 1};
    dmg_skin_draw(b, &fore);
    dmg_skin_cone(b, (dmg_xy){r, 0}, (dmg_xy){r, c.mid0}, 0, 2 * DMG_PI, c.t);
    if (peels) draw_peels(b, &c);
    dmg_cone(b, v3(0, 0, -tail), v3(0, 0, -0.03f * r), body * dmg_range(b, 0.6f, 1.0f), body);
    draw_star(b, &c);
    draw_outlet(b, &c);
    float blade = r * dmg_range(b, 1.3f, 2.8f), hub = r * dmg_range(b, 0.15f, 0.35f);
    int scoops = dmg_weighted(b, (const float[]){3, 2, 1}, 3);
    for (int i = 0; i < scoops; ++i) { /* oil below, the carburettor's air on top */
        float half = r * dmg_range(b, 0.12f, 0.3f), deep = r * dmg_range(b, 0.2f, 0.4f);
        dmg_save(b);
        if (i) dmg_turn(b, v3(0, 0, 1), DMG_PI);
        dmg_move(b, 0, -1.02f * r, 0);
        draw_scoop(b, half, deep, peels ? c.mid1 : 0.1f * c.length, 0.85f * c.length);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.85f)) draw_propeller(b, 1.08f * c.length + 0.1f * r, hub, blade);
}

/* ---- long: cylinders in line ---- */

typedef struct bonnet {
    float half, high, length, t, pan; /* pan: the part of the height that stays */
} bonnet;

/* Draws the right half of the bonnet, bent over the engine: hung on the middle strip, or along the pan. */
static void draw_bonnet_half(dmg_builder* b, const bonnet* n, bool low, float swing, int louvres, bool latch) {
    float x0 = 0.06f * n->half, z = 0.5f * n->length;
    const dmg_xy line[] = {
        {x0, n->high}, {0.7f * n->half, 0.97f * n->high}, {n->half, 0.8f * n->high}, {n->half, n->pan}};
    uint32_t half = dmg_hinge(b, 0, "bonnet", low ? v3(n->half, n->pan, 0) : v3(x0, n->high, 0),
                              v3(0, 0, low ? -1.0f : 1.0f), 0.0f, swing);
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    dmg_bent_plate(b, line, 4, n->t, 0.96f * n->length);
    dmg_restore(b);
    for (int i = 0; i < louvres; ++i)
        dmg_box(b,
                v3(n->half + n->t, 0.5f * (n->pan + 0.8f * n->high),
                   n->length * (0.2f + 0.6f * ((float)i + 0.5f) / (float)louvres)),
                v3(n->t, 0.3f * n->high, 0.25f * n->length / (float)louvres));
    if (latch) {
        float y = low ? 0.78f * n->high : n->pan + 0.08f * n->high;
        dmg_vec pin = {n->half + 0.6f * n->t, y, z};
        dmg_hinge(b, half, "latch", pin, v3(1, 0, 0), 0.0f, 1.5f);
        dmg_box_span(b, v3(pin.x, y - 0.02f * n->high, z - 0.02f * n->high),
                     v3(pin.x + 1.5f * n->t, y + 0.02f * n->high, z + 0.14f * n->high));
    }
    dmg_use(b, 0);
}

/* Draws the block with its exhausts, seen when the bonnet is up. */
static void draw_block(dmg_builder* b, const bonnet* n) {
    int pipes = dmg_int(b, 3, 6);
    dmg_box_span(b, v3(-0.4f * n->half, 0.3f * n->pan, 0.1f * n->length),
                 v3(0.4f * n->half, 0.75f * n->high, 0.9f * n->length));
    bool vee = dmg_chance(b, 0.5f);
    for (int i = 0; i < pipes; ++i) {
        float z = n->length * (0.18f + 0.64f * ((float)i + 0.5f) / (float)pipes), y = 0.55f * n->high,
              r = 0.04f * n->high;
        dmg_rod(b, v3(0.35f * n->half, y, z), v3(0.75f * n->half, y, z), r);
        if (vee) dmg_rod(b, v3(-0.35f * n->half, y, z), v3(-0.75f * n->half, y, z), r);
    }
}

/* Draws a radiator in the nose behind shutters that turn about upright or level lines. */
static void draw_shutters(dmg_builder* b, const bonnet* n, float z) {
    int count = dmg_int(b, 3, 8);
    bool upright = dmg_chance(b, 0.6f);
    float wide = 1.5f * n->half, high = 0.55f * n->high, each = (upright ? wide : high) / (float)count,
          y = 0.55f * n->high;
    dmg_box(b, v3(0, y, z - 0.45f * each), v3(wide, high, 0.1f * each));
    dmg_save(b);
    dmg_move(b, 0, y, z + 0.52f * each);
    dmg_frame_draw(b, wide + 0.12f * n->half, 1.06f * high, 0.9f * each, 0.06f * n->half);
    dmg_restore(b);
    for (int i = 0; i < count; ++i) {
        float at = each * ((float)i + 0.5f) - 0.5f * (upright ? wide : high);
        dmg_vec pin = upright ? v3(at, y, z + 0.15f * each) : v3(0, y + at, z + 0.15f * each);
        dmg_hinge(b, 0, "shutter", pin, upright ? v3(0, 1, 0) : v3(1, 0, 0), 0.0f, 1.5f);
        dmg_box(b, pin,
                upright ? v3(0.92f * each, 0.95f * high, 0.06f * each) : v3(0.95f * wide, 0.92f * each, 0.06f * each));
        dmg_use(b, 0);
    }
}

/* Draws a radiator below that slides up into the pan and down into the wind, or swings out on its front edge. */
static void draw_drop_radiator(dmg_builder* b, const bonnet* n) {
    float half = 0.5f * n->half, deep = 0.5f * n->pan, z0 = n->length * dmg_range(b, 0.05f, 0.3f),
          z1 = z0 + n->length * dmg_range(b, 0.2f, 0.4f);
    bool swings = dmg_chance(b, 0.4f);
    uint32_t box =
        swings ? dmg_hinge(b, 0, "radiator", v3(0, -0.3f * deep, z1), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.8f))
               : dmg_slide(b, 0, "radiator", v3(0, -1, 0), 0.0f, 0.8f * deep);
    dmg_box_span(b, v3(-half, -0.4f * deep, z0), v3(half, swings ? -0.01f * deep : 0.6f * deep, z1));
    if (dmg_chance(b, 0.5f)) dmg_rest(b, box, b->parts[box - 1].joint.upper * dmg_unit(b));
    dmg_use(b, 0);
}

static void draw_long_cowling(dmg_builder* b, float r) {
    bonnet n = {.half = 0.6f * r, .t = 0.03f * r};
    n.high = r * dmg_range(b, 1.2f, 2.0f);
    n.length = r * dmg_range(b, 2.0f, 4.5f);
    n.pan = n.high * dmg_range(b, 0.25f, 0.5f);
    bool low = dmg_chance(b, 0.35f), latch = dmg_chance(b, 0.4f), nose = dmg_chance(b, 0.4f);
    float swing = low ? dmg_range(b, 0.8f, 1.9f) : dmg_range(b, 0.6f, 1.3f), wall = 0.05f * n.length;
    int louvres = dmg_chance(b, 0.5f) ? dmg_int(b, 2, 7) : 0, below = dmg_int(b, 0, 2);
    const dmg_xy section[] = {{-0.8f * n.half, 0},      {0.8f * n.half, 0},      {n.half, 0.3f * n.high},
                              {n.half, 0.8f * n.high},  {0.7f * n.half, n.high}, {-0.7f * n.half, n.high},
                              {-n.half, 0.8f * n.high}, {-n.half, 0.3f * n.high}};
    dmg_extrude(b, section, 8, -dmg_range(b, 0.1f, 1.5f) * r, 0.01f * n.length);
    dmg_extrude(b, section, 8, 0.99f * n.length, n.length + wall);
    dmg_box_span(b, v3(-0.97f * n.half, 0.02f * n.high, 0), v3(0.97f * n.half, n.pan - 0.5f * n.t, n.length));
    dmg_box_span(b, v3(-0.05f * n.half, n.high - n.t, 0), v3(0.05f * n.half, n.high + 0.3f * n.t, n.length));
    draw_block(b, &n);
    for (int s = 0; s < 2; ++s) {
        dmg_save(b);
        if (s) dmg_mirror(b, v3(1, 0, 0));
        draw_bonnet_half(b, &n, low, swing, louvres, latch);
        dmg_restore(b);
    }
    if (below == 1) draw_drop_radiator(b, &n);
    if (below == 2) {
        float deep = 0.5f * n.pan;
        draw_scoop(b, 0.45f * n.half, deep, 0.1f * n.length, 0.9f * n.length);
    }
    float end = n.length + wall;
    if (nose) draw_shutters(b, &n, end + 0.02f * r);
    float blade = r * dmg_range(b, 1.5f, 3.0f), hub = n.half * dmg_range(b, 0.25f, 0.6f);
    dmg_move(b, 0, 0.55f * n.high, 0);
    if (dmg_chance(b, 0.8f)) draw_propeller(b, end + (nose ? 0.6f * r : 0.1f * r) + 0.5f * hub, hub, blade);
}

void dmg_build_cowling(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.06f, 1.0f);
    bool turned = dmg_chance(b, 0.4f);
    dmg_move(b, 0, 2.5f * r, 0);
    if (turned) dmg_turn(b, v3(0, 1, 0), DMG_PI); /* seen from behind, where the flaps are */
    if (dmg_chance(b, 0.6f))
        draw_round_cowling(b, r);
    else
        draw_long_cowling(b, r);
}
