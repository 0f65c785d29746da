/* Draws bins by their lids: domes and split lids over a pedal, swing and push lids, barrels on two wheels, and
 * fronts that tilt or draw out with a bucket. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct bin {
    float r, h; /* half its width, height without the lid */
    float d;    /* half its depth */
    bool round;
} bin;

static void draw_shell(dmg_builder* b, const bin* n, float low, float taper) {
    float t = 0.012f, r = n->r, h = n->h;
    const dmg_xy wall[] = {{0, low}, {taper * r, low}, {r, h}, {r - t, h}, {taper * r - t, low + t}, {0, low + t}};
    if (n->round) {
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), wall, 6);
        return;
    }
    dmg_save(b);
    dmg_move(b, 0, low, 0);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, 2 * r, h - low, 2 * n->d, t);
    dmg_box_span(b, v3(t - r, t, -t), v3(r - t, h - low, 0)); /* a tray has no front */
    dmg_restore(b);
}

/* Draws a disc, dome or board over the mouth, hung behind, with the pedal that lifts it. */
static void draw_pedal_bin(dmg_builder* b, bin* n) {
    float taper = dmg_range(b, 0.75f, 1.0f), swing = dmg_range(b, 1.0f, 1.6f), t = 0.015f, z = n->d;
    int lid = dmg_int(b, 0, 2);
    bool slow = dmg_chance(b, 0.5f), bucket = dmg_chance(b, 0.4f);
    draw_shell(b, n, 0.03f, n->round ? taper : 1.0f);
    if (!n->round) dmg_move(b, 0, 0, -n->d); /* lids are drawn about the middle of the mouth */
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.031f, 0), 0.8f * fminf(n->r, n->d));
    if (lid == 2) { /* two leaves from both sides */
        for (int s = -1; s <= 1; s += 2) {
            float side = (float)s;
            dmg_hinge(b, 0, "half_lid", v3(side * n->r, n->h + 0.004f, 0), v3(0, 0, -side), 0.0f, swing);
            if (n->round) {
                const dmg_xy disc[] = {{0, 0}, {n->r, 0}, {n->r, t}, {0, t}};
                dmg_lathe_arc(b, v3(0, n->h + 0.003f, 0), v3(0, 1, 0), disc, 4, s > 0 ? 0.01f : DMG_PI + 0.01f,
                              DMG_PI - 0.02f);
            } else
                dmg_box_span(b, v3(fminf(0.003f * side, side * n->r), n->h + 0.003f, -z),
                             v3(fmaxf(0.003f * side, side * n->r), n->h + t, z));
            dmg_use(b, 0);
        }
    } else {
        dmg_box_span(b, v3(-0.25f * n->r, n->h - 0.05f, -z - 0.02f), v3(0.25f * n->r, n->h, 0.01f - z));
        dmg_hinge(b, 0, "lid", v3(0, n->h + 0.002f, -z - 0.01f), v3(-1, 0, 0), 0.0f, swing);
        dmg_box_span(b, v3(-0.25f * n->r, n->h + 0.002f, -z - 0.02f), v3(0.25f * n->r, n->h + t, 0.05f - z));
        if (n->round)
            dmg_rod(b, v3(0, n->h + 0.002f, 0), v3(0, n->h + t, 0), n->r);
        else
            dmg_box_span(b, v3(-n->r, n->h + 0.002f, -z), v3(n->r, n->h + t, z));
        if (lid == 1) dmg_dome(b, v3(0, n->h + t - 0.001f, 0), v3(0.97f * n->r, 0.4f * n->r, 0.97f * z));
    }
    dmg_use(b, 0);
    float wide = slow ? 0.05f : 0.8f * n->r, front = (n->round ? taper : 1.0f) * z;
    dmg_hinge(b, 0, "pedal", v3(0, 0.025f, 0.2f * z), v3(1, 0, 0), 0.0f, 0.12f);
    dmg_box_span(b, v3(-0.02f, 0.015f, 0.85f * fminf(n->r, z)), v3(0.02f, 0.025f, front + 0.02f));
    dmg_box_span(b, v3(-wide, 0.013f, front + 0.015f), v3(wide, 0.027f, front + 0.06f));
    if (!bucket || lid == 2) return;
    dmg_slide(b, 0, "liner", v3(0, 1, 0), 0.0f, 0.8f * n->h);
    float in = 0.9f * fminf(taper * n->r, z) - 0.02f;
    dmg_cone(b, v3(0, 0.06f, 0), v3(0, n->h - 0.03f, 0), 0.95f * in, in);
}

/* Draws a flap in a hood over the bin: it swings both ways about its middle, or is pushed in at the top. */
static void draw_swing_bin(dmg_builder* b, bin* n) {
    float t = 0.01f, high = n->r * dmg_range(b, 0.5f, 1.0f), half = 0.8f * n->r, slope = dmg_range(b, 0.3f, 1.0f);
    bool push = dmg_chance(b, 0.4f), lifts = dmg_chance(b, 0.4f);
    n->round = false;
    draw_shell(b, n, 0, 1.0f);
    dmg_move(b, 0, n->h, -n->d);
    uint32_t hood = 0;
    if (lifts) hood = dmg_slide(b, 0, "hood", v3(0, 1, 0), 0.0f, 0.15f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * (n->r - 0.5f * t) - 0.5f * t, 0.001f, -n->d),
                     v3((float)s * (n->r - 0.5f * t) + 0.5f * t, high, n->d));
    dmg_box_span(b, v3(-n->r + t, 0.001f, -n->d), v3(n->r - t, high, t - n->d));
    dmg_box_span(b, v3(-n->r + t, 0.001f, n->d - t), v3(n->r - t, 0.3f * high, n->d));
    float reach = 0.85f * n->d;
    dmg_save(b);
    dmg_move(b, 0, push ? high : 0.62f * high, push ? t - n->d : 0);
    if (!push) dmg_turn(b, v3(1, 0, 0), 0.3f * slope);
    if (push)
        dmg_hinge(b, hood, "push_flap", v3(0, 0, 0.3f * t), v3(1, 0, 0), 0.0f, 0.9f * atan2f(high, 2 * n->d) + 0.3f);
    else
        dmg_hinge(b, hood, "swing_flap", v3(0, 0, 0), v3(1, 0, 0), -0.9f, 0.9f);
    dmg_box_span(b, v3(-half, -0.5f * t, push ? 0.002f : -reach), v3(half, 0.5f * t, push ? 1.8f * n->d : reach));
    if (!push) dmg_rod(b, v3(-n->r + 1.1f * t, 0, 0), v3(n->r - 1.1f * t, 0, 0), 0.6f * t);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Tapered, on an axle with two wheels behind; the lid's line is at the top of the rear, with the grips. */
static void draw_wheeled_bin(dmg_builder* b, bin* n) {
    float h = dmg_range(b, 0.8f, 1.05f), w = h * dmg_range(b, 0.24f, 0.5f), d = h * dmg_range(b, 0.26f, 0.36f),
          wheel = dmg_range(b, 0.08f, 0.13f), rise = dmg_range(b, 0.02f, 0.1f), taper = dmg_range(b, 0.7f, 0.9f),
          t = 0.02f;
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1);
    const dmg_xy mouth[] = {{-w, -d}, {w, -d}, {w, d}, {-w, d}};
    const dmg_row rows[] = {
        {taper, 0.75f, 0.2f * d, 0.01f}, {1, 1, 0, h - 0.08f}, {1.06f, 1.06f, 0, h - 0.075f}, {1.06f, 1.06f, 0, h}};
    n->h = h;
    dmg_save(b);
    dmg_face_up(b);
    dmg_mirror(b, v3(0, 1, 0));
    dmg_loft(b, mouth, 4, rows, 4);
    dmg_restore(b);
    float back = -1.06f * d;
    dmg_hinge(b, 0, "lid", v3(0, h + 0.01f, back - 0.03f), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.6f, 3.6f));
    const dmg_xy top[] = {{-1.1f * w, back}, {1.1f * w, back}, {1.1f * w, 1.12f * d}, {-1.1f * w, 1.12f * d}};
    const dmg_row cover[] = {{1, 1, 0, h + 0.002f}, {1, 1, 0, h + t}, {0.7f, 0.6f, 0, h + t + rise}};
    dmg_save(b);
    dmg_face_up(b);
    dmg_mirror(b, v3(0, 1, 0));
    dmg_loft(b, top, 4, cover, 3);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(0.5f * (float)s * w - 0.03f, h + 0.003f, back - 0.04f),
                     v3(0.5f * (float)s * w + 0.03f, h + 0.018f, back + 0.02f));
    dmg_use(b, 0);
    dmg_rod(b, v3(-0.9f * w, h - 0.02f, back - 0.035f), v3(0.9f * w, h - 0.02f, back - 0.035f), 0.014f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(0.85f * (float)s * w - 0.015f, h - 0.04f, back - 0.04f),
                     v3(0.85f * (float)s * w + 0.015f, h - 0.005f, back + 0.02f));
    float axle = -0.75f * d;
    dmg_rod(b, v3(-0.95f * w, wheel, axle), v3(0.95f * w, wheel, axle), 0.01f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (w + 0.035f);
        dmg_spin(b, 0, "wheel", v3(x, wheel, axle), v3(1, 0, 0));
        dmg_save(b);
        dmg_move(b, x, wheel, axle);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, kind, wheel, 0.045f, 6);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws a box or cupboard whose fronts tilt out about their lower edges with a bucket, or draw out. */
static void draw_recycling(dmg_builder* b, const bin* n) {
    int count = dmg_int(b, 1, 3);
    bool stacked = dmg_chance(b, 0.5f), tilts = dmg_chance(b, 0.65f);
    float w = 2 * n->r, h = fminf(n->h, 0.5f), d = w * dmg_range(b, 0.7f, 1.0f), t = 0.016f,
          tilt = dmg_range(b, 0.35f, 0.6f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, stacked ? 0 : w * (float)i, (stacked ? (float)i : 0.0f) * h + 0.5f * h, 0);
        dmg_case_draw(b, DMG_CASE_BOARDS, w, h, d, t);
        if (tilts)
            dmg_hinge(b, 0, "front", v3(0, t - 0.5f * h, 0), v3(1, 0, 0), 0.0f, tilt);
        else
            dmg_slide(b, 0, "front", v3(0, 0, 1), 0.0f, 0.8f * d);
        dmg_box_span(b, v3(-0.49f * w, t + 0.002f - 0.5f * h, 0.001f), v3(0.49f * w, 0.49f * h, t));
        dmg_save(b);
        dmg_move(b, 0, 0.36f * h, t);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle cup = {tilts ? DMG_HANDLE_CUP : DMG_HANDLE_BAR, 0.4f * w, 0.015f, 0.03f, 0.9f};
        dmg_handle_draw(b, &cup, w);
        dmg_restore(b);
        dmg_move(b, 0, t + 0.01f - 0.5f * h, 0);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.85f * w, (tilts ? 0.55f : 0.75f) * h, (tilts ? 0.5f : 0.85f) * d, 0.008f);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_hinged_bin(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 2, 2, 1.5f}, 4);
    bin n = {.r = dmg_range(b, 0.1f, 0.2f)};
    n.h = n.r * dmg_range(b, 2.2f, 4.2f);
    n.round = dmg_chance(b, 0.55f);
    n.d = n.round ? n.r : n.r * dmg_range(b, 0.6f, 1.1f);
    if (kind == 0) draw_pedal_bin(b, &n);
    if (kind == 1) draw_swing_bin(b, &n);
    if (kind == 2) draw_wheeled_bin(b, &n);
    if (kind == 3) draw_recycling(b, &n);
}
