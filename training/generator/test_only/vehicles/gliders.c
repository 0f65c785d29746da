/* Draws gliders: airbrakes that rise out of the wing or turn in it, canopies hung at the side, ahead or behind,
 * control surfaces whose lines follow the wing or stand square to the hull, a wheel that folds away, a tow hook; and
 * their trailer. */
#include "core/build.h"
#include "parts/walls.h"
#include "parts/wings.h"

typedef struct sailplane {
    float length, r; /* of the hull: its widest radius */
    float high;      /* height of its middle */
    float wing_z;    /* of the wing's root quarter */
} sailplane;

/* ---- wings ---- */

typedef struct trailing {
    const char* name;
    float s0, s1, depth; /* along the span; share of the local chord, or of the inner end's where square */
    bool square;         /* its line runs straight out from the hull, whatever the sweep */
    float up, down;
} trailing;

/* Share of the chord where the line of a surface lies at station s. */
static float hinge_share(const dmg_wing* w, const trailing* t, float s) {
    if (!t->square) return 1.0f - t->depth;
    float z = dmg_wing_point(w, t->s0, 1.0f - t->depth, 0).z, fore = dmg_wing_point(w, s, 0, 0).z,
          aft = dmg_wing_point(w, s, 1, 0).z;
    return fminf(fmaxf((fore - z) / (fore - aft), 0.3f), 0.93f);
}

static void draw_trailing(dmg_builder* b, const dmg_wing* w, uint32_t parent, const trailing* t, bool tab) {
    float c0 = hinge_share(w, t, t->s0), c1 = hinge_share(w, t, t->s1), gap = 0.006f, in = 0.003f;
    dmg_wing_patch_draw(b, w, (dmg_xy){t->s0, t->s1}, (dmg_xy){0, 0}, (dmg_xy){c0, c1});
    dmg_vec from = dmg_wing_point(w, t->s0, c0 + gap, 0), to = dmg_wing_point(w, t->s1, c1 + gap, 0);
    uint32_t flap = dmg_hinge(b, parent, t->name, from, v3_normalize(v3_sub(from, to)), -t->up, t->down);
    dmg_wing_patch_draw(b, w, (dmg_xy){t->s0 + in, t->s1 - in}, (dmg_xy){c0 + gap, c1 + gap},
                        (dmg_xy){1, tab ? 0.94f : 1});
    if (tab) { /* a trim tab behind it */
        float mid = 0.5f * (t->s0 + t->s1), wide = 0.2f * (t->s1 - t->s0);
        dmg_vec a = dmg_wing_point(w, mid - wide, 0.985f, 0), e = dmg_wing_point(w, mid + wide, 0.965f, 0);
        dmg_hinge(b, flap, "trim_tab", a, v3_normalize(v3_sub(a, e)), -0.4f, 0.4f);
        dmg_wing_patch_draw(b, w, (dmg_xy){mid - wide, mid + wide}, (dmg_xy){0.985f, 0.965f}, (dmg_xy){1.1f, 1.08f});
    }
    dmg_use(b, parent);
}

static void draw_cut_wing(dmg_builder* b, const dmg_wing* w, uint32_t parent, const trailing* t, int count, bool tab) {
    float done = 0;
    dmg_use(b, parent);
    for (int i = 0; i < count; ++i) {
        if (t[i].s0 > done) dmg_wing_piece_draw(b, w, done, t[i].s0, 0, 1);
        draw_trailing(b, w, parent, &t[i], tab && i == 0);
        done = t[i].s1;
    }
    if (done < 1) dmg_wing_piece_draw(b, w, done, 1, 0, 1);
}

/* Plates that rise out of the wing, above or below, or swing up about their front or inner edge. */
static void draw_airbrake(dmg_builder* b, const dmg_wing* w, int kind, float s, float wide, float high, bool below) {
    dmg_vec at = dmg_wing_point(w, s, 0.45f, 1), foot = dmg_wing_point(w, s, 0.45f, -1);
    float t = 0.012f * w->root, span = wide * w->span, slope = w->sweep / w->span;
    dmg_vec along = v3_normalize(v3(1, w->dihedral, -slope)), half = v3_scale(along, 0.5f * span);
    if (kind == 0) {
        for (int k = 0; k < (below ? 2 : 1); ++k) {
            dmg_vec top = k ? foot : at;
            float dir = k ? -1.0f : 1.0f, z = k ? -3 * t : 0.0f;
            dmg_slide(b, 0, "airbrake", v3(0, dir, 0), 0.0f, high);
            dmg_vec cap = v3_add(top, v3(0, dir * t, z));
            dmg_beam(b, v3_sub(cap, half), v3_add(cap, half), 4 * t, t);
            dmg_vec web = v3_add(top, v3(0, dir * (0.5f * t - 0.5f * high), z));
            dmg_beam(b, v3_sub(web, half), v3_add(web, half), t, high);
            dmg_use(b, 0);
        }
        return;
    }
    dmg_vec pin = v3_add(at, v3(0, 0.6f * t, kind == 1 ? 0.5f * high : 0));
    if (kind == 1) /* about its front edge */
        dmg_hinge(b, 0, "spoiler", pin, along, 0.0f, 1.2f);
    else /* a paddle on a pin through the wing, turning upright */
        dmg_hinge(b, 0, "airbrake", at, v3(1, 0, 0), 0.0f, 1.57f);
    dmg_vec plate = v3_add(at, v3(0, 0.7f * t, 0));
    dmg_beam(b, v3_sub(plate, half), v3_add(plate, half), high, t);
    dmg_use(b, 0);
}

/* Draws one wing, to the right. */
static void draw_glider_wing(dmg_builder* b, const dmg_wing* w, const trailing* t, int count, int brake, float s,
                             float wide, float high, bool below, bool winglet) {
    draw_cut_wing(b, w, 0, t, count, false);
    if (brake < 3) draw_airbrake(b, w, brake, s, wide, high, below);
    dmg_use(b, 0);
    if (winglet) {
        dmg_vec tip = dmg_wing_point(w, 1, 0.5f, 0);
        dmg_beam(b, tip, v3_add(tip, v3(0.25f * w->tip, 1.1f * w->tip, -0.3f * w->tip)), 0.08f * w->tip, 0.6f * w->tip);
    }
}

static void draw_wings(dmg_builder* b, const sailplane* p) {
    float half = p->length * dmg_range(b, 0.9f, 1.6f), root = p->length * dmg_range(b, 0.11f, 0.17f);
    dmg_wing w = dmg_wing_pick(b, half, root);
    w.sweep = dmg_chance(b, 0.5f) ? dmg_range(b, 0.3f, 1.0f) * (w.root - w.tip) : half * dmg_range(b, -0.06f, 0.25f);
    w.dihedral = dmg_range(b, 0.0f, 0.06f);
    trailing t[2] = {{.name = "flap"}, {.name = "aileron"}};
    int count = dmg_int(b, 0, 1) ? 2 : 1, brake = dmg_int(b, 0, 3);
    float middle = dmg_range(b, 0.45f, 0.62f), depth = dmg_range(b, 0.15f, 0.3f), up = dmg_range(b, 0.2f, 0.5f);
    bool square = dmg_chance(b, 0.4f), below = dmg_chance(b, 0.4f), winglet = dmg_chance(b, 0.3f),
         top = dmg_chance(b, 0.6f);
    t[0].s0 = dmg_range(b, 0.03f, 0.15f);
    t[0].s1 = middle - 0.01f;
    t[1].s0 = middle + 0.01f;
    t[1].s1 = dmg_range(b, 0.85f, 0.97f);
    for (int i = 0; i < 2; ++i) {
        t[i].depth = depth;
        t[i].square = square;
        t[i].up = i ? up : 0.15f;
        t[i].down = i ? 0.6f * up : dmg_range(b, 0.3f, 0.8f);
    }
    float s = dmg_range(b, 0.3f, 0.4f), wide = dmg_range(b, 0.08f, 0.16f), high = root * dmg_range(b, 0.12f, 0.2f);
    for (int k = 0; k < 2; ++k) {
        dmg_save(b);
        dmg_move(b, 0, p->high + (top ? 0.75f : 0.1f) * p->r, p->wing_z);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        draw_glider_wing(b, &w, count == 2 ? t : t + 1, count, brake, s, wide, high, below, winglet);
        dmg_restore(b);
    }
}

/* ---- tail: conventional, on top of the fin, or a vee ---- */

static void draw_tailplane(dmg_builder* b, const dmg_wing* w, dmg_vec at, float lean, bool square, bool whole,
                           bool tab) {
    trailing t = {.name = lean > 0 ? "ruddervator" : "elevator",
                  .s0 = 0.06f,
                  .s1 = 0.96f,
                  .depth = 0.35f,
                  .up = 0.45f,
                  .down = 0.4f};
    t.square = square;
    for (int k = 0; k < 2; ++k) {
        dmg_save(b);
        dmg_move(b, at.x, at.y, at.z);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        dmg_turn(b, v3(0, 0, 1), lean);
        if (whole) { /* the half turns as one on a rod through its quarter */
            dmg_hinge(b, 0, "stabilator", v3(0, 0, 0.2f * w->root), v3(-1, 0, 0), -0.3f, 0.3f);
            dmg_wing_piece_draw(b, w, 0.03f, 1, 0, 1);
            dmg_use(b, 0);
        } else {
            draw_cut_wing(b, w, 0, &t, 1, tab);
        }
        dmg_restore(b);
    }
}

static void draw_glider_tail(dmg_builder* b, const sailplane* p) {
    int kind = dmg_int(b, 0, 2);
    bool square = dmg_chance(b, 0.4f), whole = dmg_chance(b, 0.25f), tab = dmg_chance(b, 0.4f);
    float z = -0.44f * p->length, chord = p->length * dmg_range(b, 0.08f, 0.12f),
          tall = p->length * dmg_range(b, 0.13f, 0.2f);
    dmg_wing tail = dmg_wing_pick(b, p->length * dmg_range(b, 0.16f, 0.24f), chord);
    tail.sweep = dmg_range(b, 0.0f, 1.0f) * (tail.root - tail.tip);
    tail.sweep += dmg_range(b, 0.0f, 0.2f) * chord;
    if (kind == 2) {
        draw_tailplane(b, &tail, v3(0, p->high + 0.1f * p->r, z), dmg_range(b, 0.5f, 0.8f), square, false, false);
        return;
    }
    dmg_wing fin = dmg_wing_pick(b, tall, 1.3f * chord);
    fin.sweep = dmg_range(b, 0.0f, 0.5f) * tall;
    fin.tip = fmaxf(fin.tip, 0.6f * fin.root);
    trailing rudder = {.name = "rudder", .s0 = 0.05f, .s1 = 0.95f, .depth = 0.4f, .up = 0.5f, .down = 0.5f};
    rudder.square = square;
    dmg_save(b);
    dmg_move(b, 0, p->high, z);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    draw_cut_wing(b, &fin, 0, &rudder, 1, false);
    dmg_restore(b);
    dmg_vec at =
        kind == 1 ? v3(0, p->high + 1.02f * tall, z - fin.sweep) : v3(0, p->high + 0.2f * p->r, z + 1.3f * chord);
    draw_tailplane(b, &tail, at, 0, square, whole, tab);
}

/* ---- hull ---- */

static void draw_glider_canopy(dmg_builder* b, const sailplane* p, float z0, float z1) {
    int kind = dmg_weighted(b, (const float[]){3, 2, 1, 1}, 4); /* side, ahead, behind, forward on rails */
    float half = 0.5f * (z1 - z0), z = 0.5f * (z0 + z1), high = p->r * dmg_range(b, 0.55f, 0.9f), wide = 0.8f * p->r,
          y = p->high + 0.42f * p->r;
    uint32_t canopy;
    if (kind == 0)
        canopy = dmg_hinge(b, 0, "canopy", v3(wide, y, z), v3(0, 0, -1), 0.0f, dmg_range(b, 1.0f, 1.6f));
    else if (kind == 1)
        canopy = dmg_hinge(b, 0, "canopy", v3(0, y, z1), v3(1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.3f));
    else if (kind == 2)
        canopy = dmg_hinge(b, 0, "canopy", v3(0, y, z0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.1f));
    else
        canopy = dmg_slide(b, 0, "canopy", v3(0, 0.25f, 0.97f), 0.0f, 0.7f * half);
    const dmg_vec rim[] = {
        {-wide, y, z}, {-0.8f * wide, y, z - 0.7f * half}, {0, y, z - half}, {0.8f * wide, y, z - 0.7f * half},
        {wide, y, z},  {0.8f * wide, y, z + 0.7f * half},  {0, y, z + half}, {-0.8f * wide, y, z + 0.7f * half}};
    dmg_sweep(b, rim, 8, 0.04f * p->r, 0.04f * p->r, true);
    dmg_dome(b, v3(0, y, z), v3(0.98f * wide, high, 0.98f * half));
    if (kind < 3 && dmg_chance(b, 0.5f)) { /* the pane one slides to breathe */
        dmg_slide(b, canopy, "vent_pane", v3(0, 0, -1), 0.0f, 0.2f * half);
        dmg_box(b, v3(-1.02f * wide, y + 0.25f * high, z), v3(0.02f * p->r, 0.25f * high, 0.3f * half));
    }
    dmg_use(b, 0);
}

/* Draws the wheel: fixed, swung back into its well between doors, or let down on a leg. */
static void draw_glider_wheel(dmg_builder* b, const sailplane* p, float z) {
    float r = p->r * dmg_range(b, 0.4f, 0.6f), y = p->high - 1.25f * p->r;
    bool folds = dmg_chance(b, 0.7f), doors = dmg_chance(b, 0.7f);
    uint32_t leg = folds ? dmg_hinge(b, 0, "gear_leg", v3(0, p->high - 0.3f * p->r, z + 0.9f * p->r),
                                     v3(dmg_sign(b), 0, 0), -0.5f, 0.5f)
                         : 0;
    for (int k = -1; k <= 1; k += 2)
        dmg_beam(b, v3((float)k * 0.25f * p->r, p->high - 0.4f * p->r, z + 0.8f * p->r),
                 v3((float)k * 0.25f * p->r, y, z), 0.06f * p->r, 0.12f * p->r);
    dmg_spin(b, leg, "wheel", v3(0, y, z), v3(dmg_sign(b), 0, 0));
    dmg_wall_enter(b, v3(0, y, z), 0.5f * DMG_PI);
    dmg_wheel_draw(b, 6, r, 0.35f * p->r, 5);
    dmg_restore(b);
    for (int k = 0; k < 2 && doors; ++k) { /* shown open: they hang beside the wheel */
        float x = 0.45f * p->r, top = p->high - 0.92f * p->r;
        dmg_save(b);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        dmg_use(b, 0);
        dmg_hinge(b, 0, "gear_door", v3(x, top, z), v3(0, 0, 1), -1.3f, 0.0f);
        dmg_box_span(b, v3(x - 0.02f * p->r, top - 0.42f * p->r, z - 1.1f * r),
                     v3(x + 0.02f * p->r, top, z + 1.1f * r));
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_sailplane(dmg_builder* b) {
    sailplane p = {.length = dmg_range(b, 5.5f, 9.0f)};
    p.r = p.length * dmg_range(b, 0.045f, 0.065f);
    p.high = p.r * 1.8f;
    p.wing_z = p.length * dmg_range(b, 0.06f, 0.14f);
    float l = p.length, boom = p.r * dmg_range(b, 0.25f, 0.4f);
    const dmg_xy hull[] = {
        {0, -0.5f * l},   {0.8f * boom, -0.48f * l}, {boom, -0.1f * l},        {0.9f * p.r, 0.13f * l},
        {p.r, 0.25f * l}, {0.85f * p.r, 0.37f * l},  {0.45f * p.r, 0.46f * l}, {0, 0.5f * l}};
    dmg_lathe(b, v3(0, p.high, 0), v3(0, 0, 1), hull, 8);
    draw_wings(b, &p);
    draw_glider_tail(b, &p);
    draw_glider_canopy(b, &p, l * dmg_range(b, 0.13f, 0.2f), 0.42f * l);
    draw_glider_wheel(b, &p, l * dmg_range(b, 0.1f, 0.2f));
    if (dmg_chance(b, 0.6f)) { /* what the rope hangs on */
        float y = p.high - 0.5f * p.r, z = 0.455f * l, r = 0.1f * p.r;
        dmg_box(b, v3(0, y + 0.1f * p.r, z), v3(1.5f * r, 2 * r, 3 * r));
        dmg_hinge(b, 0, "tow_hook", v3(0, y, z), v3(1, 0, 0), 0.0f, 1.2f);
        dmg_beam(b, v3(0, y, z), v3(0, y - 3 * r, z + 0.5f * r), 0.6f * r, r);
        dmg_beam(b, v3(0, y - 3 * r, z + 0.3f * r), v3(0, y - 2.6f * r, z + 2.5f * r), 0.6f * r, r);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.5f)) {
        dmg_rod(b, v3(0, p.high - 0.9f * boom, -0.45f * l), v3(0, 0.12f * p.r, -0.45f * l), 0.12f * p.r);
        dmg_spin(b, 0, "tail_wheel", v3(0.1f * p.r, 0.3f * p.r, -0.45f * l), v3(dmg_sign(b), 0, 0));
        dmg_rod(b, v3(0.13f * p.r, 0.3f * p.r, -0.45f * l), v3(0.3f * p.r, 0.3f * p.r, -0.45f * l), 0.25f * p.r);
    }
}

/* Draws a long box on an axle: the lid lifts at its front end or along one side, a ramp door lets the hull out. */
static void draw_trailer(dmg_builder* b) {
    float l = dmg_range(b, 7.0f, 9.5f), half = dmg_range(b, 0.5f, 0.8f), low = 0.45f,
          high = low + dmg_range(b, 0.4f, 0.7f), top = high + dmg_range(b, 0.4f, 0.7f), t = 0.03f;
    bool side = dmg_chance(b, 0.35f);
    dmg_box_span(b, v3(-half, low - 0.06f, -0.5f * l), v3(half, low, 0.5f * l));
    for (int k = -1; k <= 1; k += 2) {
        dmg_box_span(b, v3((float)k * (half - 0.5f * t) - 0.5f * t, low, -0.5f * l),
                     v3((float)k * (half - 0.5f * t) + 0.5f * t, high, 0.5f * l));
        dmg_rod(b, v3(0, 0.3f, -0.1f * l), v3((float)k * (half + 0.1f), 0.3f, -0.1f * l), 0.04f);
        dmg_spin(b, 0, "wheel", v3((float)k * (half + 0.15f), 0.3f, -0.1f * l), v3(dmg_sign(b), 0, 0));
        dmg_wall_enter(b, v3((float)k * (half + 0.15f), 0.3f, -0.1f * l), 0.5f * DMG_PI);
        dmg_wheel_draw(b, 6, 0.3f, 0.18f, 5);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_box_span(b, v3(-0.05f, 0.28f, -0.1f * l - 0.05f), v3(0.05f, low, -0.1f * l + 0.05f));
    dmg_box_span(b, v3(-half, low, 0.5f * l - t), v3(half, high, 0.5f * l));
    uint32_t lid = side ? dmg_hinge(b, 0, "lid", v3(-half, high, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 1.0f, 1.6f))
                        : dmg_hinge(b, 0, "lid", v3(0, high, 0.5f * l), v3(1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.7f));
    const dmg_xy arch[] = {{-half, high + 0.01f}, {-0.9f * half, 0.5f * (high + top)}, {-0.5f * half, top},
                           {0.5f * half, top},    {0.9f * half, 0.5f * (high + top)},  {half, high + 0.01f}};
    dmg_bent_plate(b, arch, 6, t, l);
    dmg_extrude(b, (const dmg_xy[]){arch[0], arch[5], arch[4], arch[3], arch[2], arch[1]}, 6, 0.5f * l - t, 0.5f * l);
    dmg_slide(b, lid, "lid_vent", v3(0, 0, 1), 0.0f, 0.2f);
    dmg_box(b, v3(0, top + 0.04f, 0.2f * l), v3(0.4f, 0.05f, 0.3f));
    dmg_hinge(b, 0, "tail_ramp", v3(0, low, -0.5f * l), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 1.9f));
    dmg_box_span(b, v3(-half + t, low + 0.005f, -0.5f * l - t), v3(half - t, high - 0.01f, -0.5f * l - 0.002f));
    dmg_use(b, 0);
    for (int k = -1; k <= 1; k += 2)
        dmg_beam(b, v3((float)k * 0.5f * half, low - 0.1f, 0.45f * l), v3(0, low - 0.1f, 0.5f * l + 1.2f), 0.06f,
                 0.08f);
    dmg_box(b, v3(0, low - 0.1f, 0.5f * l + 0.8f), v3(0.2f, 0.14f, 0.14f));
    uint32_t leg = dmg_slide(b, 0, "jockey_leg", v3(0, 1, 0), 0.0f, 0.15f);
    dmg_rod(b, v3(0.14f, 0.08f, 0.5f * l + 0.8f), v3(0.14f, low + 0.3f, 0.5f * l + 0.8f), 0.025f);
    dmg_spin(b, leg, "jockey_wheel", v3(0.2f, 0.1f, 0.5f * l + 0.8f), v3(1, 0, 0));
    dmg_rod(b, v3(0.17f, 0.1f, 0.5f * l + 0.8f), v3(0.24f, 0.1f, 0.5f * l + 0.8f), 0.1f);
    dmg_use(b, 0);
}

void dmg_build_glider(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.3f) ? dmg_scale_range(b, 0.03f, 0.3f) : 1.0f);
    if (dmg_chance(b, 0.85f))
        draw_sailplane(b);
    else
        draw_trailer(b);
}
