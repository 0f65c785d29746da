/* Draws cameras that are aimed: bullets on jointed brackets, eyeballs and domes in housings, heads that pan on a
 * yoke, carriages on rails, gimbals of three motors. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what films ---- */

typedef struct lens {
    float r, length; /* along +Z from the origin, the body behind it */
    bool round, hood, ring;
} lens;

static lens pick_lens(dmg_builder* b, float r) {
    lens l = {.r = r};
    l.length = r * dmg_range(b, 3.0f, 7.0f);
    l.round = dmg_chance(b, 0.5f);
    l.hood = dmg_chance(b, 0.6f);
    l.ring = dmg_chance(b, 0.35f);
    return l;
}

/* Draws a long body about z = 0, a shade over it that slides, a ring that focuses. */
static void draw_bullet_body(dmg_builder* b, const lens* l, uint32_t head) {
    float front = 0.55f * l->length, back = -0.45f * l->length, t = 0.06f * l->r;
    if (l->round)
        dmg_rod(b, v3(0, 0, back), v3(0, 0, front), l->r);
    else
        dmg_box_span(b, v3(-l->r, -l->r, back), v3(l->r, l->r, front));
    dmg_rod(b, v3(0, 0, front), v3(0, 0, front + 0.06f * l->r), 0.6f * l->r);
    if (l->hood) {
        float way = l->length * dmg_range(b, 0.08f, 0.3f), wide = 1.12f * l->r;
        const dmg_xy line[] = {
            {wide, 0}, {wide, 0.7f * l->r}, {0.7f * l->r, wide}, {-0.7f * l->r, wide}, {-wide, 0.7f * l->r},
            {-wide, 0}};
        dmg_slide(b, head, "sunshield", v3(0, 0, 1), 0.0f, way);
        dmg_save(b);
        dmg_move(b, 0, 0, 0.1f * l->length);
        dmg_bent_plate(b, line, 6, t, l->length);
        dmg_restore(b);
        dmg_use(b, head);
    }
    if (l->ring) {
        float end = front + 0.06f * l->r;
        dmg_hinge(b, head, "focus_ring", v3(0, 0, end), v3(0, 0, 1), 0.0f, 2.0f);
        dmg_rod(b, v3(0, 0, end), v3(0, 0, end + 0.3f * l->r), 0.5f * l->r);
        dmg_box(b, v3(0, 0.5f * l->r, end + 0.15f * l->r), v3(0.12f * l->r, 0.12f * l->r, 0.25f * l->r));
        dmg_use(b, head);
    }
}

/* Orients the frame for what the camera is fixed to, behind z = 0: turns +Z up, down or leaves it; returns which. */
static int face_surface(dmg_builder* b, float height, float plate) {
    int kind = dmg_int(b, 0, 2);
    bool wide = dmg_chance(b, 0.5f), round = dmg_chance(b, 0.5f);
    float t = 0.12f * plate, size = wide ? plate * dmg_range(b, 2.0f, 4.0f) : 2.2f * plate;
    dmg_move(b, 0, kind == 1 ? t : height, 0);
    if (kind) dmg_turn(b, v3(1, 0, 0), kind == 1 ? -0.5f * DMG_PI : 0.5f * DMG_PI);
    if (round)
        dmg_rod(b, v3(0, 0, -t), v3(0, 0, 0), 0.5f * size);
    else
        dmg_box_span(b, v3(-0.5f * size, -0.5f * size, -t), v3(0.5f * size, 0.5f * size, 0));
    return kind;
}

/* Base, ball or fork, and the body: about the surface's normal, about a pin across, about the body's own line. */
static void draw_jointed_bullet(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.02f, 0.06f);
    lens l = pick_lens(b, r);
    float stem = r * dmg_range(b, 1.2f, 3.5f), thick = r * dmg_range(b, 0.3f, 0.5f), out = 0.35f * r;
    bool fork = dmg_chance(b, 0.5f), rolls = dmg_chance(b, 0.6f);
    int kind = face_surface(b, 0.2f + 4 * l.length, r * 1.4f);
    float neck = 0.5f * l.length + 0.5f * r;
    uint32_t pan = dmg_hinge(b, 0, "pan", v3(0, 0, 0), v3(0, 0, 1), -DMG_PI, DMG_PI);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0, out), 1.1f * r, 0.8f * r);
    dmg_rod(b, v3(0, 0, out), v3(0, 0, out + stem - (fork ? thick : 0.0f)), thick);
    float pin = out + stem;
    for (int s = -1; s <= 1 && fork; s += 2)
        dmg_box(b, v3((float)s * 0.85f * thick, 0, pin - 0.2f * thick), v3(0.4f * thick, 1.6f * thick, 2.2f * thick));
    uint32_t tilt = dmg_hinge(b, pan, "tilt", v3(0, 0, pin), v3(kind == 1 ? 1.0f : -1.0f, 0, 0), -0.2f, 1.6f);
    dmg_rest(b, tilt, kind ? 1.5f : dmg_range(b, 0.0f, 0.5f));
    if (fork)
        dmg_rod(b, v3(-1.2f * thick, 0, pin), v3(1.2f * thick, 0, pin), 0.5f * thick);
    else
        dmg_ellipsoid(b, v3(0, 0, pin), v3(1.5f * thick, 1.5f * thick, 1.5f * thick));
    dmg_rod(b, v3(0, 0, pin), v3(0, 0, pin + neck - 0.45f * l.length), 0.45f * thick);
    dmg_move(b, 0, 0, pin + neck);
    uint32_t head = tilt;
    if (rolls) head = dmg_hinge(b, tilt, "roll", v3(0, 0, 0), v3(0, 0, 1), -DMG_PI, DMG_PI);
    draw_bullet_body(b, &l, head);
}

/* Draws the older bracket: an arm out of the wall or a post, the head on top of it or hung below. */
static void draw_arm_bullet(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.03f, 0.08f);
    lens l = pick_lens(b, r);
    float reach = l.length * dmg_range(b, 0.6f, 1.1f), y = l.length * dmg_range(b, 1.0f, 3.0f),
          rise = r * dmg_range(b, 1.6f, 2.2f);
    bool hangs = dmg_chance(b, 0.35f), post = dmg_chance(b, 0.4f);
    float up = hangs ? -1.0f : 1.0f, arm = r * dmg_range(b, 0.25f, 0.4f);
    if (post)
        dmg_rod(b, v3(0, 0, -reach), v3(0, y + 3 * r, -reach), 0.8f * r);
    else
        dmg_box(b, v3(0, y, -reach), v3(3 * r, 4 * r, 0.3f * r));
    dmg_beam(b, v3(0, y, -reach), v3(0, y, 0.8f * arm), 1.6f * arm, 1.6f * arm);
    if (dmg_chance(b, 0.4f)) dmg_beam(b, v3(0, y - 2 * r, -reach), v3(0, y, -0.3f * reach), arm, arm);
    dmg_move(b, 0, y + up * 0.8f * arm, 0);
    uint32_t pan = dmg_hinge(b, 0, "pan", v3(0, 0, 0), v3(0, 1, 0), -1.4f, 1.4f);
    float pin = up * 0.55f * rise;
    dmg_rod(b, v3(0, 0, 0), v3(0, up * 0.15f * rise, 0), 1.1f * arm);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.6f * arm - 0.2f * arm, hangs ? pin - arm : 0.1f * rise, -arm),
                     v3((float)s * 0.6f * arm + 0.2f * arm, hangs ? -0.1f * rise : pin + arm, arm));
    uint32_t tilt = dmg_hinge(b, pan, "tilt", v3(0, pin, 0), v3(1, 0, 0), -0.4f, 0.5f);
    dmg_rod(b, v3(-arm, pin, 0), v3(arm, pin, 0), 0.35f * arm);
    dmg_box_span(b, v3(-0.35f * arm, fminf(pin, up * rise), -0.8f * arm),
                 v3(0.35f * arm, fmaxf(pin, up * rise), 0.8f * arm));
    dmg_move(b, 0, up * (rise + 0.95f * r), 0.1f * l.length);
    draw_bullet_body(b, &l, tilt);
}

/* ---- domes ---- */

/* Draws a ball or a small camera on a turning ring in a round housing; perhaps under a clear cover that swings away. */
static void draw_dome(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.04f, 0.12f), deep = r * dmg_range(b, 0.4f, 0.9f),
          ball = r * dmg_range(b, 0.55f, 0.72f);
    bool eyeball = dmg_chance(b, 0.5f), cover = dmg_chance(b, 0.45f), lugs = dmg_chance(b, 0.5f);
    int kind = face_surface(b, 10 * r, r);
    float start = kind ? dmg_range(b, 0.3f, 1.0f) : dmg_range(b, 0.0f, 0.5f), t = 0.05f * r;
    const dmg_xy housing[] = {{0, 0},           {r, 0}, {0.95f * r, deep}, {0.8f * r, deep}, {0.8f * r, 0.25f * deep},
                              {0, 0.25f * deep}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), housing, 6);
    uint32_t pan = dmg_hinge(b, 0, "pan", v3(0, 0, 0.25f * deep), v3(0, 0, 1), -DMG_PI, DMG_PI);
    float pin = deep + 0.2f * ball;
    dmg_rod(b, v3(0, 0, 0.25f * deep), v3(0, 0, 0.4f * deep), 0.75f * r);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.7f * r - t, -0.15f * r, 0.3f * deep),
                     v3((float)s * 0.7f * r + t, 0.15f * r, pin + 0.12f * r));
    float inner = 0.7f * r - t;
    ball = fminf(fminf(ball, inner), 0.95f * (pin - 0.4f * deep));
    uint32_t tilt = dmg_hinge(b, pan, "tilt", v3(0, 0, pin), v3(-1, 0, 0), -1.1f, 1.1f);
    dmg_rest(b, tilt, start);
    dmg_rod(b, v3(-inner, 0, pin), v3(inner, 0, pin), 0.08f * r);
    if (eyeball) {
        dmg_ellipsoid(b, v3(0, 0, pin), v3(ball, ball, ball));
        dmg_rod(b, v3(0, 0, pin), v3(0, 0, pin + 1.04f * ball), 0.5f * ball);
    } else {
        dmg_box(b, v3(0, 0, pin), v3(1.1f * ball, 0.9f * ball, 0.8f * ball));
        uint32_t roll = dmg_hinge(b, tilt, "lens", v3(0, 0, pin), v3(0, 0, 1), -1.5f, 1.5f);
        dmg_cone(b, v3(0, 0, pin + 0.4f * ball), v3(0, 0, pin + 1.1f * ball), 0.35f * ball, 0.42f * ball);
        if (lugs) dmg_box(b, v3(0, 0.45f * ball, pin + 0.8f * ball), v3(0.1f * ball, 0.2f * ball, 0.3f * ball));
        dmg_use(b, roll);
    }
    if (!cover) return;
    float rim = deep + 0.02f * r, high = 1.02f * r;
    uint32_t lid = dmg_hinge(b, 0, "cover", v3(0, r, rim), v3(1, 0, 0), 0.0f, 2.2f);
    dmg_rest(b, lid, dmg_range(b, 1.2f, 2.1f));
    dmg_keep_rest(b, lid);
    const dmg_xy bubble[] = {
        {r, rim}, {r, rim + 0.1f * r}, {0.9f * r, rim + 0.5f * high}, {0.6f * r, rim + 0.85f * high}, {0, rim + high}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), bubble, 5);
}

/* ---- heads that go round without end ---- */

/* Draws two ears on a column, the head between them; a wiper on its window, lamps at its sides. */
static void draw_yoke_head(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.05f, 0.14f), half = r * dmg_range(b, 0.8f, 1.2f),
          deep = r * dmg_range(b, 0.8f, 1.5f);
    float column = r * dmg_range(b, 0.8f, 2.5f), high = r * dmg_range(b, 0.7f, 1.1f), ear = 0.3f * r;
    bool hangs = dmg_chance(b, 0.4f), wiper = dmg_chance(b, 0.5f), lamp = dmg_chance(b, 0.4f),
         single = dmg_chance(b, 0.3f);
    float clear = sqrtf(high * high + deep * deep) + 0.1f * r, pin = column + 0.3f * r + clear;
    if (hangs) { /* upside down, below a plate */
        dmg_move(b, 0, pin + 2 * r, 0);
        dmg_turn(b, v3(0, 0, 1), DMG_PI);
    }
    dmg_cone(b, v3(0, 0, 0), v3(0, column, 0), r * dmg_range(b, 1.0f, 1.5f), 0.8f * r);
    uint32_t pan = dmg_spin(b, 0, "pan", v3(0, column, 0), v3(0, 1, 0));
    dmg_box_span(b, v3(-half - 1.2f * ear, column, -0.6f * r), v3(half + 1.2f * ear, column + 0.3f * r, 0.6f * r));
    for (int s = single ? 1 : -1; s <= 1; s += 2) {
        float x = (float)s * (half + 0.7f * ear);
        dmg_box_span(b, v3(x - 0.5f * ear, column + 0.25f * r, -0.5f * r),
                     v3(x + 0.5f * ear, pin + 0.4f * r, 0.5f * r));
    }
    uint32_t tilt = dmg_hinge(b, pan, "tilt", v3(0, pin, 0), v3(-1, 0, 0), -0.7f, 1.5f);
    dmg_rest(b, tilt, dmg_range(b, -0.3f, 0.4f));
    dmg_rounded_box(b, v3(0, pin, 0), v3(2 * half, 2 * high, 2 * deep), 0.2f * r);
    dmg_rod(b, v3(single ? 0.0f : -half - 0.3f * ear, pin, 0), v3(half + 0.3f * ear, pin, 0), 0.25f * r);
    dmg_rod(b, v3(0, pin, 0.9f * deep), v3(0, pin, 1.04f * deep), 0.55f * high);
    if (lamp) dmg_rod(b, v3(0, pin + high, -0.5f * deep), v3(0, pin + high, 0.9f * deep), 0.3f * r);
    if (!wiper) return;
    float z = 1.06f * deep, foot = pin - 0.8f * high;
    dmg_hinge(b, tilt, "wiper", v3(0.5f * half, foot, z), v3(0, 0, 1), 0.0f, 1.5f);
    dmg_rod(b, v3(0.5f * half, foot, 0.97f * deep), v3(0.5f * half, foot, z + 0.06f * r), 0.09f * r);
    dmg_box_span(b, v3(0.5f * half - 0.04f * r, foot, z - 0.02f * r),
                 v3(0.5f * half + 0.04f * r, foot + 1.3f * high, z + 0.05f * r));
}

/* Draws a bell on a bent arm or under the ceiling; a ball below it pans, in its slot the eye tilts. */
static void draw_speed_dome(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.06f, 0.13f), bell = r * dmg_range(b, 1.2f, 2.4f), y = r * 8;
    bool arm = dmg_chance(b, 0.6f), rim = dmg_chance(b, 0.6f);
    float reach = r * dmg_range(b, 2.0f, 4.0f), slot = 0.32f * r, top = y + bell;
    const dmg_xy shell[] = {{0, 0},           {1.02f * r, 0}, {1.05f * r, 0.3f * bell}, {0.6f * r, 0.9f * bell},
                            {0.3f * r, bell}, {0, bell}};
    dmg_lathe(b, v3(0, y, 0), v3(0, 1, 0), shell, 6);
    if (rim) dmg_cone(b, v3(0, y + 0.02f * r, 0), v3(0, y + 0.35f * r, 0), 1.35f * r, 1.05f * r);
    if (arm) {
        const dmg_vec path[] = {{0, top - 0.1f * r, 0},
                                {0, top + 0.6f * r, -0.1f * r},
                                {0, top + 0.9f * r, -0.5f * r},
                                {0, top + 0.6f * r, -reach + 0.2f * r},
                                {0, top + 0.5f * r, -reach}};
        dmg_sweep(b, path, 5, 0.22f * r, 0.22f * r, false);
        dmg_box(b, v3(0, top + 0.5f * r, -reach), v3(1.6f * r, 2 * r, 0.2f * r));
    } else {
        dmg_rod(b, v3(0, top - 0.1f * r, 0), v3(0, top + reach, 0), 0.2f * r);
        dmg_rod(b, v3(0, top + reach, 0), v3(0, top + reach + 0.15f * r, 0), r);
    }
    uint32_t pan = dmg_spin(b, 0, "pan", v3(0, y, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, y - 0.15f * r, 0), v3(0, y - 0.01f * r, 0), 0.98f * r);
    for (int s = -1; s <= 1; s += 2) { /* half balls at both sides of the slot */
        dmg_save(b);
        dmg_move(b, (float)s * slot, y - 0.15f * r, 0);
        dmg_turn(b, v3(0, 0, 1), (float)-s * 0.5f * DMG_PI);
        dmg_dome(b, v3(0, 0, 0), v3(0.75f * r, 0.6f * r, 0.75f * r));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.05f * r, 0), 0.74f * r);
        dmg_restore(b);
    }
    float pin = y - 0.25f * r;
    uint32_t tilt = dmg_hinge(b, pan, "tilt", v3(0, pin, 0), v3(1, 0, 0), 0.0f, 1.6f);
    dmg_rest(b, tilt, dmg_range(b, 0.2f, 1.2f));
    dmg_rod(b, v3(-1.1f * slot, pin, 0), v3(1.1f * slot, pin, 0), 0.1f * r);
    dmg_box(b, v3(0, pin - 0.15f * r, 0.3f * r), v3(1.7f * slot, 0.45f * r, 0.5f * r));
    dmg_rod(b, v3(0, pin - 0.15f * r, 0.5f * r), v3(0, pin - 0.15f * r, 0.85f * r), 0.75f * slot);
}

/* ---- carried and pushed ---- */

/* Draws a camera with its screen to the left, lens to the front, standing on y = 0. */
static void draw_film_camera(dmg_builder* b, uint32_t on, float size) {
    float wide = size * dmg_range(b, 0.4f, 1.2f), high = size * dmg_range(b, 0.55f, 0.8f),
          deep = size * dmg_range(b, 0.4f, 0.9f), r = 0.35f * high;
    bool screen = dmg_chance(b, 0.4f), ring = dmg_chance(b, 0.6f);
    dmg_box_span(b, v3(-0.5f * wide, 0, -0.5f * deep), v3(0.5f * wide, high, 0.5f * deep));
    dmg_rod(b, v3(0, 0.5f * high, 0.5f * deep), v3(0, 0.5f * high, 0.5f * deep + 0.4f * size), fminf(r, 0.48f * wide));
    if (ring) {
        float z = 0.5f * deep + 0.4f * size;
        dmg_hinge(b, on, "focus_ring", v3(0, 0.5f * high, z), v3(0, 0, 1), 0.0f, 2.5f);
        dmg_cone(b, v3(0, 0.5f * high, z), v3(0, 0.5f * high, z + 0.25f * size), 0.9f * fminf(r, 0.48f * wide),
                 fminf(r, 0.48f * wide));
        dmg_box(b, v3(0, 0.5f * high + fminf(r, 0.48f * wide), z + 0.15f * size),
                v3(0.05f * size, 0.08f * size, 0.05f * size));
        dmg_use(b, on);
    }
    if (!screen) return;
    float x = -0.5f * wide - 0.02f * size;
    dmg_hinge(b, on, "screen", v3(x, 0, 0.3f * deep), v3(0, -1, 0), 0.0f, 1.7f);
    dmg_box_span(b, v3(x - 0.04f * size, 0.1f * high, -0.45f * deep), v3(x + 0.015f * size, 0.9f * high, 0.3f * deep));
    dmg_use(b, on);
}

/* Rails on feet, the carriage along them, a head on it; a crank or a flywheel at one end. */
static void draw_slider(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.4f, 1.6f), wide = dmg_range(b, 0.06f, 0.14f), y = dmg_range(b, 0.06f, 0.2f),
          rail = 0.01f;
    bool flat = dmg_chance(b, 0.35f), crank = dmg_chance(b, 0.5f), head = dmg_chance(b, 0.75f),
         levels = dmg_chance(b, 0.5f);
    float block = wide * dmg_range(b, 0.9f, 1.4f), way = 0.5f * length - 0.6f * block - 0.03f,
          rest = way * dmg_range(b, -0.9f, 0.9f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.5f * length, z = (float)s * 0.5f * wide;
        dmg_box(b, v3(x, y, 0), v3(0.03f, 0.035f, 1.3f * wide));
        if (!flat) dmg_rod(b, v3(-0.5f * length, y, z), v3(0.5f * length, y, z), rail);
        for (int f = -1; f <= 1; f += 2) {
            float fz = (float)f * 0.6f * wide;
            dmg_rod(b, v3(x, 0.3f * y, fz), v3(x, y, fz), 0.006f);
            if (levels) dmg_screw(b, 0, "foot", v3(x, 0, fz), v3(0, -1, 0), 0.0015f, 0.0f, 10.0f);
            dmg_cone(b, v3(x, 0, fz), v3(x, 0.3f * y, fz), 0.018f, 0.01f);
            dmg_use(b, 0);
        }
    }
    if (flat) dmg_box(b, v3(0, y, 0), v3(length, 0.02f, 0.8f * wide));
    if (crank) {
        dmg_save(b);
        dmg_move(b, 0.5f * length + 0.016f, y, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        float r = fminf(0.9f * y, 0.06f);
        int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), spokes = dmg_int(b, 3, 6);
        dmg_spin(b, 0, "flywheel", v3(0, 0, 0.01f), v3(0, 0, 1));
        dmg_move(b, 0, 0, 0.012f);
        dmg_wheel_draw(b, kind, r, 0.018f, spokes);
        dmg_rod(b, v3(0.6f * r, 0, 0), v3(0.6f * r, 0, 0.04f), 0.006f);
        dmg_restore(b);
    }
    uint32_t on = dmg_slide(b, 0, "carriage", v3(1, 0, 0), -way, way);
    dmg_rest(b, on, rest);
    float top = y + 0.045f;
    dmg_box_span(b, v3(-0.5f * block, y + 0.011f, -0.62f * wide), v3(0.5f * block, top, 0.62f * wide));
    if (dmg_chance(b, 0.5f)) {
        dmg_screw(b, on, "brake", v3(0, 0.5f * (y + top), 0.62f * wide), v3(0, 0, 1), 0.001f, 0.0f, 6.0f);
        dmg_cone(b, v3(0, top - 0.015f, 0.62f * wide), v3(0, top - 0.015f, 0.62f * wide + 0.02f), 0.006f, 0.012f);
        dmg_box(b, v3(0, top - 0.015f, 0.62f * wide + 0.022f), v3(0.03f, 0.008f, 0.006f));
        dmg_use(b, on);
    }
    float turn = dmg_range(b, -1.0f, 1.0f), size = wide * dmg_range(b, 0.8f, 1.3f);
    if (head) {
        on = dmg_hinge(b, on, "pan", v3(0, top, 0), v3(0, 1, 0), -DMG_PI, DMG_PI);
        dmg_rest(b, on, turn);
        dmg_rod(b, v3(0, top, 0), v3(0, top + 0.03f, 0), 0.03f);
        dmg_box_span(b, v3(-0.012f, top + 0.02f, -0.015f), v3(0.012f, top + 0.075f, 0.015f));
        on = dmg_hinge(b, on, "tilt", v3(0, top + 0.06f, 0), v3(1, 0, 0), -0.4f, 0.6f);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.018f - 0.005f, top + 0.045f, -0.012f),
                         v3((float)s * 0.018f + 0.005f, top + 0.09f, 0.012f));
        dmg_box_span(b, v3(-0.03f, top + 0.085f, -0.04f), v3(0.03f, top + 0.1f, 0.04f));
        top += 0.1f;
    }
    dmg_move(b, 0, top, 0);
    draw_film_camera(b, on, size);
}

/* Draws a grip with a thumb stick; on it the motors of yaw, roll and tilt, each with the arm that reaches the next. */
static void draw_gimbal(dmg_builder* b) {
    float s = dmg_scale_range(b, 0.05f, 0.12f), grip = s * dmg_range(b, 2.0f, 3.5f), r = 0.22f * s;
    bool feet = dmg_chance(b, 0.5f), stick = dmg_chance(b, 0.6f), phone = dmg_chance(b, 0.4f);
    float back = s * dmg_range(b, 1.0f, 1.3f), side = s * dmg_range(b, 1.0f, 1.4f), y = grip + 0.5f * s;
    float legs = feet ? grip * 0.45f : 0.0f, spread = dmg_range(b, 0.5f, 1.1f);
    dmg_move(b, 0, feet ? legs : 0.0f, 0);
    for (int i = 0; i < 3 && feet; ++i) { /* closed they lie together below the grip */
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, 3);
        uint32_t leg = dmg_hinge(b, 0, "leg", v3(0, 0, 0.75f * r), v3(-1, 0, 0), 0.0f, 1.2f);
        dmg_rest(b, leg, spread);
        dmg_cone(b, v3(0, 0, 0.75f * r), v3(0, -legs, 0.6f * r), 0.3f * r, 0.2f * r);
        dmg_use(b, 0);
        dmg_restore(b);
    }
    dmg_rod(b, v3(0, 0, 0), v3(0, grip, 0), r);
    if (stick) {
        dmg_hinge(b, 0, "thumb_stick", v3(0, 0.85f * grip, r), v3(1, 0, 0), -0.35f, 0.35f);
        dmg_rod(b, v3(0, 0.85f * grip, 0.9f * r), v3(0, 0.85f * grip, 1.5f * r), 0.15f * r);
        dmg_rod(b, v3(0, 0.85f * grip, 1.4f * r), v3(0, 0.85f * grip, 1.6f * r), 0.4f * r);
    }
    float middle = y + 0.9f * s;
    uint32_t yaw = dmg_hinge(b, 0, "yaw", v3(0, grip, 0), v3(0, 1, 0), -2.8f, 2.8f);
    dmg_rod(b, v3(0, grip, 0), v3(0, grip + 0.3f * s, 0), 1.3f * r);
    dmg_beam(b, v3(0, grip + 0.18f * s, 0), v3(0, grip + 0.18f * s, -back), 0.25f * s, 0.2f * s);
    dmg_beam(b, v3(0, grip + 0.1f * s, -back), v3(0, middle + 0.1f * s, -back), 0.25f * s, 0.2f * s);
    uint32_t roll = dmg_hinge(b, yaw, "roll", v3(0, middle, -back), v3(0, 0, 1), -0.7f, 0.7f);
    float z = -back + 0.11f * s;
    dmg_rod(b, v3(0, middle, z), v3(0, middle, z + 0.25f * s), 1.2f * r);
    dmg_beam(b, v3(0, middle, z + 0.15f * s), v3(side, middle, z + 0.15f * s), 0.2f * s, 0.18f * s);
    dmg_beam(b, v3(side, middle, z + 0.07f * s), v3(side, middle, 0.1f * s), 0.18f * s, 0.2f * s);
    uint32_t tilt = dmg_hinge(b, roll, "tilt", v3(side, middle, 0), v3(1, 0, 0), -0.8f, 0.8f);
    float in = side - 0.12f * s;
    dmg_rod(b, v3(in - 0.22f * s, middle, 0), v3(in, middle, 0), 1.1f * r);
    if (!phone) {
        float size = dmg_range(b, 0.6f, 0.85f) * s;
        dmg_beam(b, v3(in - 0.15f * s, middle, 0), v3(-0.3f * size, middle, 0), 0.1f * s, 0.16f * s);
        dmg_move(b, 0, middle - 0.3f * size, 0);
        draw_film_camera(b, tilt, size);
        return;
    }
    float half = 0.35f * s, wide = s * dmg_range(b, 0.9f, 1.1f);
    dmg_box_span(b, v3(-half, middle - half, -0.05f * s), v3(in - 0.1f * s, middle + half, 0.03f * s));
    dmg_box_span(b, v3(-0.7f * wide, middle - half, 0.04f * s), v3(0.6f * wide, middle + half, 0.1f * s));
    dmg_slide(b, tilt, "clamp", v3(0, 1, 0), 0.0f, 0.3f * s);
    dmg_box_span(b, v3(-half, middle + half + 0.01f * s, -0.05f * s), v3(half, middle + half + 0.08f * s, 0.16f * s));
}

void dmg_build_security_camera(dmg_builder* b) {
    void (*const draw[])(dmg_builder*) = {draw_jointed_bullet, draw_arm_bullet, draw_dome,  draw_yoke_head,
                                          draw_speed_dome,     draw_slider,     draw_gimbal};
    draw[dmg_weighted(b, (const float[]){4, 3, 4, 2, 3, 3, 3}, 7)](b);
}
