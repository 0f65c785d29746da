/* Draws sensor heads: dome and bullet cameras, scanners that spin or nod, stereo heads, eyes with lids, masts that
 * fold. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- cameras of buildings ---- */

/* Where it hangs: under a ceiling, on a wall's arm, on a post; the origin then is what it hangs from, down is -Y. */
static void draw_camera_mount(dmg_builder* b, float s) {
    int kind = dmg_int(b, 0, 3);
    float reach = s * dmg_range(b, 1.7f, 3.0f), t = s * dmg_range(b, 0.1f, 0.25f);
    dmg_move(b, 0, 3.5f * s, 0);
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), v3(0, t, 0), s);
    if (kind == 1) {
        dmg_box(b, v3(0, 0, -reach), v3(1.2f * s, 1.6f * s, t));
        dmg_beam(b, v3(0, 0, -reach), v3(0, 0.5f * t, 0), 0.5f * s, 2 * t);
        dmg_rod(b, v3(0, 0, 0), v3(0, t, 0), 0.5f * s);
    }
    if (kind == 2) {
        dmg_rod(b, v3(0, -3.5f * s, -reach), v3(0, 0.8f * s, -reach), 0.3f * s);
        dmg_rod(b, v3(0, 0.4f * s, -reach), v3(0, 0.4f * s, 0), 0.2f * s);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.6f * s, 0), 0.3f * s);
    }
    if (kind == 3) dmg_box(b, v3(0, 0.5f * t, 0), v3(2.2f * s, t, 2.2f * s));
}

/* Draws a housing that turns under its mount, with an eye in it that tips. */
static void draw_dome_camera(dmg_builder* b) {
    float s = dmg_scale_range(b, 0.03f, 0.3f), high = s * dmg_range(b, 0.4f, 1.3f),
          r = fminf(high, s * dmg_range(b, 0.6f, 0.95f));
    draw_camera_mount(b, s);
    bool turns = dmg_chance(b, 0.8f);
    uint32_t pan = 0;
    if (turns)
        pan = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "pan", v3(0, 0, 0), v3(0, 1, 0))
                                  : dmg_hinge(b, 0, "pan", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -2.8f, 2.8f);
    int shell = dmg_int(b, 0, 2);
    if (shell == 0) dmg_rod(b, v3(0, -high, 0), v3(0, -0.01f * s, 0), s);
    if (shell == 1) dmg_cone(b, v3(0, -high, 0), v3(0, -0.01f * s, 0), s, 0.6f * s);
    if (shell == 2) { /* cheeks on a neck */
        dmg_rod(b, v3(0, -high, 0), v3(0, 0, 0), 0.5f * s);
        dmg_box(b, v3(0, -high, 0), v3(2.2f * s, 0.3f * s, 0.8f * s));
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3((float)i * (r + 0.1f * s), -high - 0.6f * r, 0), v3(0.15f * s, 1.6f * r, 0.7f * s));
    }
    float y = -high - (shell == 2 ? 0.9f * r : 0.0f);
    float down = dmg_range(b, 0.5f, 1.4f);
    uint32_t eye = dmg_hinge(b, pan, "tilt", v3(0, y, 0), v3(dmg_sign(b), 0, 0), -0.8f, down);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(1, 0, 0), dmg_range(b, 0.2f, 1.0f));
    if (shell == 2 && dmg_chance(b, 0.5f)) { /* a long case under a hood */
        float deep = s * dmg_range(b, 1.2f, 2.2f);
        dmg_box(b, v3(0, 0, 0.1f * deep), v3(1.5f * r, 1.2f * r, deep));
        dmg_box(b, v3(0, 0.75f * r, 0.2f * deep), v3(1.8f * r, 0.1f * r, 1.2f * deep));
        if (dmg_chance(b, 0.4f)) { /* and a wiper */
            dmg_hinge(b, eye, "wiper", v3(0.3f * r, -0.5f * r, 0.62f * deep), v3(0, 0, 1), 0.0f, 1.5f);
            dmg_box(b, v3(0.3f * r, -0.1f * r, 0.62f * deep), v3(0.08f * r, 0.9f * r, 0.06f * r));
        }
    } else {
        dmg_ellipsoid(b, v3(0, 0, 0), v3(r, r, r));
        dmg_rod(b, v3(0, 0, 0.5f * r), v3(0, 0, 1.05f * r), 0.45f * r);
        for (int i = -1; i <= 1 && dmg_chance(b, 0.5f); i += 2)
            dmg_rod(b, v3((float)i * 0.6f * r, 0, 0), v3((float)i * 0.6f * r, 0, 0.9f * r), 0.15f * r);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a tube with a lens on a ball or an elbow, on a plate: turned once, when it was put up. */
static void draw_bullet_camera(dmg_builder* b) {
    float s = dmg_scale_range(b, 0.02f, 0.2f), arm = s * dmg_range(b, 0.8f, 2.5f),
          length = s * dmg_range(b, 2.0f, 4.0f);
    bool wall = dmg_chance(b, 0.5f), ball = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 2 * s, 0);
    if (wall) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.3f * s, 0), s);
    uint32_t pan = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "pan", v3(0, 0, 0), v3(0, 1, 0))
                                       : dmg_hinge(b, 0, "pan", v3(0, 0, 0), v3(0, 1, 0), -1.5f, 1.5f);
    dmg_rod(b, v3(0, 0.3f * s, 0), v3(0, 0.3f * s + arm, 0), 0.35f * s);
    dmg_move(b, 0, 0.3f * s + arm, 0);
    if (ball) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.5f * s, 0.5f * s, 0.5f * s));
    if (!ball) dmg_rod(b, v3(-0.6f * s, 0, 0), v3(0, 0, 0), 0.45f * s);
    uint32_t tilt = dmg_hinge(b, pan, "tilt", v3(0, 0, 0), v3(1, 0, 0), -0.7f, 0.7f);
    float x = ball ? 0.0f : 0.25f * s, up = ball ? 1.1f * s : 0.0f;
    if (!ball) dmg_rod(b, v3(0, 0, 0), v3(0.6f * s, 0, 0), 0.45f * s);
    if (ball) dmg_rod(b, v3(0, 0.3f * s, 0), v3(0, up, 0), 0.3f * s);
    dmg_move(b, x, up, 0);
    if (wall) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    if (dmg_chance(b, 0.3f)) dmg_spin(b, tilt, "roll", v3(0, 0, 0), v3(0, 0, 1));
    if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3(0, 0, -0.3f * length), v3(0, 0, 0.7f * length), 0.8f * s);
    else
        dmg_box(b, v3(0, 0, 0.2f * length), v3(1.5f * s, 1.3f * s, length));
    dmg_rod(b, v3(0, 0, 0.65f * length), v3(0, 0, 0.73f * length), 0.6f * s);
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0.85f * s, 0.25f * length), v3(1.7f * s, 0.1f * s, 1.1f * length));
    dmg_use(b, 0);
}

/* ---- scanners ---- */

/* Draws a drum on a drum: the upper one spins, plain, notched, with a window or a mirror; on a bracket or legs. */
static void draw_scanner(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.02f, 0.3f), base = r * dmg_range(b, 0.2f, 1.2f), high = r * dmg_range(b, 0.4f, 1.8f),
          up = dmg_chance(b, 0.5f) ? r * dmg_range(b, 0.5f, 4.0f) : 0.0f;
    int head = dmg_int(b, 0, 4), legs = dmg_int(b, 3, 4);
    for (int i = 0; i < legs && up > 0; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, legs);
        dmg_rod(b, v3(1.3f * r, 0, 0), v3(0.7f * r, up, 0), 0.12f * r);
        dmg_restore(b);
    }
    dmg_move(b, 0, up, 0);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0, 0), v3(0, base, 0), r * dmg_range(b, 0.7f, 1.1f));
    else
        dmg_rounded_box(b, v3(0, 0.5f * base, 0), v3(2.2f * r, base, 2.2f * r), 0.2f * base);
    dmg_move(b, 0, base, 0);
    bool caged = dmg_chance(b, 0.25f);
    for (int i = 0; i < 4 && caged; ++i) {
        float x = (i % 2 ? 1.1f : -1.1f) * r, z = (i / 2 ? 1.1f : -1.1f) * r;
        dmg_rod(b, v3(x, -base, z), v3(x, 1.2f * high, z), 0.08f * r);
    }
    if (caged) dmg_box(b, v3(0, 1.2f * high, 0), v3(2.4f * r, 0.1f * r, 2.4f * r));
    dmg_spin(b, 0, "scanner", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    if (head < 2) {
        const dmg_xy profile[] = {{0, 0.02f * r},           {0.95f * r, 0.02f * r}, {0.9f * r, 0.3f * high},
                                  {0.9f * r, 0.75f * high}, {0.7f * r, high},       {0, high}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 6);
    }
    if (head == 1) dmg_box(b, v3(0, 0.5f * high, 0.85f * r), v3(0.8f * r, 0.3f * high, 0.3f * r));
    if (head == 2) { /* two halves with a slit between them */
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.5f * r, 0.5f * high + 0.1f * r, 0), v3(0.4f * r, high, 1.1f * r));
        dmg_rod(b, v3(0, 0.02f * r, 0), v3(0, 0.12f * r, 0), 0.8f * r);
    }
    if (head == 3) { /* a mirror at a slant */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.3f * high, 0), 0.3f * r);
        dmg_beam(b, v3(0, 0.2f * high, -0.4f * r), v3(0, 0.95f * high, 0.4f * r), r, 0.08f * r);
    }
    if (head == 4) dmg_box(b, v3(0, 0.55f * high, 0.1f * r), v3(1.3f * r, 0.9f * high, 1.4f * r));
    dmg_use(b, 0);
}

/* Draws a scanner in a yoke that nods, driven from one side. */
static void draw_nodder(dmg_builder* b) {
    float s = dmg_scale_range(b, 0.03f, 0.3f), t = s * dmg_range(b, 0.08f, 0.2f), y = s * dmg_range(b, 0.8f, 1.4f);
    int load = dmg_int(b, 0, 2);
    dmg_box(b, v3(0, 0.5f * t, 0), v3(2.4f * s + 2 * t, t, 1.2f * s));
    for (int i = -1; i <= 1; i += 2)
        dmg_box(b, v3((float)i * (1.15f * s + 0.5f * t), 0.5f * (y + 0.3f * s), 0), v3(t, y + 0.3f * s, 0.8f * s));
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(1.15f * s + t, y, 0), v3(1.9f * s + t, y, 0), 0.35f * s);
    uint32_t nod = dmg_hinge(b, 0, "nod", v3(0, y, 0), v3(dmg_sign(b), 0, 0), -0.7f, 0.9f);
    dmg_rod(b, v3(-1.15f * s, y, 0), v3(1.15f * s, y, 0), 0.12f * s);
    dmg_box(b, v3(0, y, -0.3f * s), v3(1.8f * s, t, 1.2f * s));
    if (load == 0) {
        dmg_box(b, v3(0, y + 0.4f * s, -0.2f * s), v3(s, 0.7f * s, 0.9f * s));
        dmg_spin(b, nod, "scanner", v3(0, y, -0.2f * s), v3(0, 1, 0));
        dmg_rod(b, v3(0, y + 0.76f * s, -0.2f * s), v3(0, y + 1.2f * s, -0.2f * s), 0.42f * s);
    }
    if (load == 1) dmg_rod(b, v3(0, y, 0), v3(0, y, 0.9f * s), 0.4f * s);
    if (load == 2) dmg_rounded_box(b, v3(0, y + 0.3f * s, 0), v3(2 * s, 0.5f * s, 0.5f * s), 0.1f * s);
    dmg_use(b, 0);
}

/* ---- heads ---- */

/* Draws an eyeball in its socket that looks left and right or up and down, with lids before it that shut. */
static void draw_eye(dmg_builder* b, uint32_t head, float r, bool lids) {
    bool nods = dmg_chance(b, 0.3f);
    dmg_use(b, head);
    dmg_torus(b, v3(0, 0, 0.1f * r), v3(0, 0, 1), 1.12f * r, 0.1f * r);
    if (dmg_chance(b, 0.85f)) dmg_hinge(b, head, "eye", v3(0, 0, 0), nods ? v3(1, 0, 0) : v3(0, 1, 0), -0.6f, 0.6f);
    dmg_ellipsoid(b, v3(0, 0, 0), v3(r, r, r));
    dmg_rod(b, v3(0, 0, 0.8f * r), v3(0, 0, 1.04f * r), 0.35f * r);
    for (int s = -1; s <= 1 && lids; s += 2) {
        dmg_hinge(b, head, s > 0 ? "upper_lid" : "lower_lid", v3(0, 0, 0), v3((float)s, 0, 0), 0.0f,
                  dmg_range(b, 0.5f, 0.9f));
        const dmg_xy shell[] = {
            {1.08f * r, -1.0f * r}, {1.16f * r, -1.0f * r}, {1.16f * r, r}, {1.08f * r, r}, {1.08f * r, -1.0f * r}};
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), (float)s * -0.9f);
        dmg_lathe_arc(b, v3(0, 0, 0), v3(1, 0, 0), shell, 5, 0.5f * DMG_PI - 0.5f, 1.0f);
        dmg_restore(b);
    }
    dmg_use(b, head);
}

/* Eyes on a bar, perhaps a skull behind them and a jaw below. */
static void draw_face(dmg_builder* b, uint32_t head, float s) {
    float r = s * dmg_range(b, 0.16f, 0.26f);
    bool lids = dmg_chance(b, 0.6f), skull = dmg_chance(b, 0.6f);
    if (skull) dmg_ellipsoid(b, v3(0, 0.75f * s, -0.55f * s), v3(0.7f * s, 0.8f * s, 0.5f * s));
    dmg_box(b, v3(0, 0.75f * s, -1.3f * r), v3(1.3f * s, 0.15f * s, 0.15f * s));
    dmg_box(b, v3(0, 0.35f * s, -1.3f * r), v3(0.3f * s, 0.9f * s, 0.15f * s));
    for (int i = -1; i <= 1; i += 2) {
        dmg_save(b);
        dmg_move(b, (float)i * 0.38f * s, 0.85f * s, 0);
        dmg_box(b, v3(0, -0.1f * s, -1.2f * r), v3(0.5f * r, 0.5f * r, 0.6f * r));
        draw_eye(b, head, r, lids);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.7f)) { /* the jaw hangs behind and below */
        dmg_hinge(b, head, "jaw", v3(0, 0.45f * s, -0.4f * s), v3(1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.7f));
        for (int i = -1; i <= 1; i += 2)
            dmg_beam(b, v3((float)i * 0.5f * s, 0.45f * s, -0.4f * s), v3((float)i * 0.35f * s, 0.2f * s, 0.1f * s),
                     0.08f * s, 0.15f * s);
        dmg_box(b, v3(0, 0.2f * s, 0.12f * s), v3(0.8f * s, 0.15f * s, 0.12f * s));
    }
}

/* Draws a head on a neck: a bar with two cameras, a screen, or a face with eyes, brows and a jaw. */
static void draw_head(dmg_builder* b) {
    float s = dmg_scale_range(b, 0.05f, 0.5f), neck = s * dmg_range(b, 0.3f, 1.5f), t = 0.15f * s,
          turn = dmg_range(b, 0.7f, 2.0f);
    int kind = dmg_int(b, 0, 2), order = dmg_int(b, 0, 2);
    dmg_rounded_box(b, v3(0, 0.2f * s, 0), v3(1.6f * s, 0.4f * s, s), 0.1f * s);
    uint32_t head = 0;
    if (order != 1) head = dmg_hinge(b, 0, "neck", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -turn, turn);
    dmg_rod(b, v3(0, 0.4f * s, 0), v3(0, 0.4f * s + neck, 0), 1.2f * t);
    dmg_move(b, 0, 0.4f * s + neck, 0);
    if (order > 0) {
        if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(-1.5f * t, 0, 0), v3(1.5f * t, 0, 0), 1.1f * t);
        head = dmg_hinge(b, head, "nod", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -0.5f, 0.7f);
        dmg_box(b, v3(0, 0.5f * t, 0), v3(4 * t, t, 2 * t));
    }
    if (kind == 0) { /* stereo: each camera may turn inwards */
        float wide = s * dmg_range(b, 0.6f, 1.2f);
        dmg_box(b, v3(0, 0.3f * s, 0), v3(2.6f * wide, 0.15f * s, 0.3f * s));
        dmg_beam(b, v3(0, 0, 0), v3(0, 0.3f * s, 0), 0.3f * s, 0.2f * s);
        bool each = dmg_chance(b, 0.6f);
        for (int i = -1; i <= 1; i += 2) {
            dmg_vec at = {(float)i * wide, 0.55f * s, 0};
            if (each) dmg_hinge(b, head, "camera", at, v3(0, 1, 0), -0.5f, 0.5f);
            dmg_box(b, at, v3(0.35f * s, 0.35f * s, 0.45f * s));
            dmg_rod(b, at, v3_add(at, v3(0, 0, 0.4f * s)), 0.13f * s);
            dmg_use(b, head);
        }
    }
    if (kind == 1) {
        dmg_rounded_box(b, v3(0, 0.6f * s, 0), v3(1.4f * s, s, 0.25f * s), 0.08f * s);
        dmg_box(b, v3(0, 0.6f * s, 0.13f * s), v3(1.2f * s, 0.75f * s, 0.02f * s));
        for (int i = -1; i <= 1; i += 2) { /* antennae or ears */
            if (dmg_chance(b, 0.5f))
                dmg_hinge(b, head, "ear", v3((float)i * 0.75f * s, 0.8f * s, 0), v3(1, 0, 0), -0.8f, 0.8f);
            dmg_rod(b, v3((float)i * 0.68f * s, 0.8f * s, 0), v3((float)i * 0.82f * s, 0.8f * s, 0), 0.15f * s);
            dmg_beam(b, v3((float)i * 0.78f * s, 0.8f * s, 0), v3((float)i * 0.78f * s, 1.4f * s, 0), 0.06f * s,
                     0.2f * s);
            dmg_use(b, head);
        }
    }
    if (kind == 2) draw_face(b, head, s);
    dmg_use(b, 0);
}

/* ---- masts ---- */

/* Folds up from a deck, telescopes or not, a head on top that turns. */
static void draw_sensor_mast(dmg_builder* b) {
    float high = dmg_scale_range(b, 0.2f, 3.0f), t = high * dmg_range(b, 0.02f, 0.06f),
          s = high * dmg_range(b, 0.08f, 0.2f);
    bool lies = dmg_chance(b, 0.4f), telescopes = dmg_chance(b, 0.4f);
    dmg_box(b, v3(0, s, lies ? -0.12f * high : 0), v3(3 * s, 2 * s, lies ? 0.7f * high : 3 * s));
    dmg_move(b, 0, 2 * s + 1.3f * t, 0);
    for (int i = -1; i <= 1; i += 2) dmg_box(b, v3((float)i * 1.6f * t, 0, 0), v3(t, 2.8f * t, 3 * t));
    uint32_t mast = 0;
    if (lies || dmg_chance(b, 0.6f))
        mast = dmg_hinge(b, 0, "mast", v3(0, 0, 0), v3(lies ? 1.0f : -1.0f, 0, 0), 0.0f, lies ? 1.6f : 1.3f);
    dmg_rod(b, v3(-2.2f * t, 0, 0), v3(2.2f * t, 0, 0), 0.5f * t);
    if (lies) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.6f * high, 0), t);
    float top = 0.6f * high;
    if (telescopes) {
        mast = dmg_slide(b, mast, "extension", v3(0, 1, 0), 0.0f, 0.4f * high);
        dmg_rod(b, v3(0, 0.1f * high, 0), v3(0, 0.7f * high, 0), 0.7f * t);
        top = 0.7f * high;
    }
    dmg_move(b, 0, top, 0);
    uint32_t head = mast;
    if (dmg_chance(b, 0.7f)) head = dmg_spin(b, mast, "head", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.2f * s, 0), 1.3f * t);
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, head, "tilt", v3(0, 0.7f * s, 0), v3(dmg_sign(b), 0, 0), -0.7f, 0.7f);
        dmg_box(b, v3(0, 0.7f * s, 0.1f * s), v3(1.6f * s, 0.7f * s, 0.8f * s));
        dmg_rod(b, v3(0.35f * s, 0.7f * s, 0.4f * s), v3(0.35f * s, 0.7f * s, 0.7f * s), 0.2f * s);
        dmg_use(b, head);
        dmg_beam(b, v3(0, 0.1f * s, 0), v3(0, 0.6f * s, 0), 0.3f * s, 0.3f * s);
    } else
        dmg_box(b, v3(0, 0.4f * s, 0), v3(2.5f * s, 0.4f * s, 0.4f * s));
    dmg_use(b, 0);
}

void dmg_build_sensor_head(dmg_builder* b) {
    static void (*const kinds[])(dmg_builder*) = {draw_dome_camera, draw_bullet_camera, draw_scanner,
                                                  draw_nodder,      draw_head,          draw_sensor_mast};
    static const float weights[] = {2, 1.2f, 1.5f, 1, 2.5f, 1.3f};
    kinds[dmg_weighted(b, weights, 6)](b);
}
