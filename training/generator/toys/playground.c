/* Draws playground equipment: see-saws, roundabouts, spring rockers, swings, sand diggers. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* Draws a seat whose top is y = 0, its rider facing +Z: a board, a dish, a saddle, a seat with a back. */
static void draw_seat(dmg_builder* b, int kind, float w) {
    if (kind == 0) dmg_box(b, v3(0, -0.08f * w, 0), v3(w, 0.16f * w, w));
    if (kind == 1) dmg_cone(b, v3(0, -0.25f * w, 0), v3(0, 0, 0), 0.3f * w, 0.55f * w);
    if (kind == 2) dmg_rounded_box(b, v3(0, -0.12f * w, 0), v3(0.7f * w, 0.24f * w, 1.3f * w), 0.1f * w);
    if (kind == 3) {
        dmg_rounded_box(b, v3(0, -0.1f * w, 0), v3(w, 0.2f * w, w), 0.08f * w);
        dmg_rounded_box(b, v3(0, 0.35f * w, -0.45f * w), v3(w, 0.8f * w, 0.14f * w), 0.05f * w);
    }
}

/* Draws what the rider holds, from y = 0 upwards, across x: a T, a hoop, two pegs through a post. */
static void draw_grip_bar(dmg_builder* b, int kind, float w, float high, float r) {
    if (kind == 0) {
        dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), r);
        dmg_rod(b, v3(-0.5f * w, high, 0), v3(0.5f * w, high, 0), r);
    }
    if (kind == 1) {
        const dmg_vec path[] = {{-0.4f * w, 0, 0},   {-0.5f * w, 0.7f * high, 0}, {-0.3f * w, high, 0},
                                {0.3f * w, high, 0}, {0.5f * w, 0.7f * high, 0},  {0.4f * w, 0, 0}};
        dmg_sweep(b, path, 6, r, r, false);
    }
    if (kind == 2) {
        dmg_box(b, v3(0, 0.5f * high, 0), v3(3 * r, high, 2 * r));
        dmg_rod(b, v3(-0.5f * w, 0.8f * high, 0), v3(0.5f * w, 0.8f * high, 0), r);
    }
}

/* ---- see-saws ---- */

/* Draws what the beam lies on: legs spread like an A, posts at both sides, a block, a coil. The axle is at y, along x.
 */
static void draw_trestle(dmg_builder* b, int kind, float y, float half, float r) {
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (half + 1.5f * r);
        if (kind == 0)
            for (int k = -1; k <= 1; k += 2) dmg_rod(b, v3(x, y, 0), v3(x * 1.15f, 0, (float)k * 0.55f * y), r);
        if (kind == 1) dmg_box_span(b, v3(x - r, 0, -2 * r), v3(x + r, y + 2 * r, 2 * r));
    }
    if (kind == 2) {
        const dmg_xy block[] = {{-0.5f * y, 0}, {0.5f * y, 0}, {1.5f * r, y - 2 * r}, {-1.5f * r, y - 2 * r}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_extrude(b, block, 4, -half, half);
        dmg_restore(b);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * (half + r) - r, 0.5f * y, -1.5f * r),
                         v3((float)s * (half + r) + r, y + 2 * r, 1.5f * r));
    }
    if (kind < 3) dmg_rod(b, v3(-half - 3 * r, y, 0), v3(half + 3 * r, y, 0), 0.8f * r);
}

/* Draws one beam on the axle at the origin, along z: seats, grips and buffers at its ends. */
static void draw_see_saw_beam(dmg_builder* b, uint32_t parent, float reach, float t, float y, int pairs) {
    int seat = dmg_int(b, 0, 3), grip = dmg_int(b, 0, 2), shape = dmg_int(b, 0, 2);
    float above = t * dmg_range(b, 0.3f, 1.2f), w = dmg_range(b, 0.22f, 0.36f), low = y - 0.35f * t;
    float most = 0.8f * asinf(fminf(0.6f, low / (reach + 0.5f * w)));
    uint32_t beam = dmg_hinge(b, parent, "see_saw", v3(0, 0, 0), v3(1, 0, 0), -most, most);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, beam, most * (dmg_chance(b, 0.6f) ? dmg_sign(b) : dmg_range(b, -1, 1)));
    if (shape == 0) dmg_box(b, v3(0, above, 0), v3(t, t, 2 * reach));
    if (shape == 1) dmg_rod(b, v3(0, above, -reach), v3(0, above, reach), 0.55f * t);
    if (shape == 2) { /* sagging between raised seats */
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3(0, above - 0.2f * t, 0), v3(0, above + 0.6f * t, (float)s * reach), t, t);
    }
    dmg_box(b, v3(0, 0.3f * above, 0), v3(1.2f * t, fmaxf(above, t), 1.6f * t));
    for (int i = 0; i < 2 * pairs; ++i) {
        float s = i & 1 ? 1.0f : -1.0f, z = s * (reach - 0.5f * w - (float)(i / 2) * 2.6f * w);
        dmg_save(b);
        dmg_move(b, 0, above + 0.5f * t + 0.2f * w + (shape == 2 ? 0.5f * t : 0), z);
        if (s > 0) dmg_turn(b, v3(0, 1, 0), DMG_PI);
        draw_seat(b, seat, w);
        dmg_box(b, v3(0, -0.15f * w, 0), v3(0.3f * w, 0.3f * w, 0.3f * w));
        dmg_move(b, 0, -0.25f * w, 0.95f * w);
        draw_grip_bar(b, grip, 1.1f * w, w * 1.1f, 0.05f * w);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_see_saw(dmg_builder* b) {
    float reach = dmg_range(b, 0.9f, 2.0f), y = reach * dmg_range(b, 0.25f, 0.4f), t = dmg_range(b, 0.06f, 0.14f);
    int beams = dmg_weighted(b, (const float[]){5, 1, 1}, 3) + 1, pairs = dmg_chance(b, 0.2f) ? 2 : 1;
    int trestle = dmg_int(b, 0, 3);
    float pitch = dmg_range(b, 0.6f, 0.9f);
    if (trestle == 3) { /* a post whose fork turns round as well */
        float fork = 0.75f * y;
        dmg_cone(b, v3(0, 0, 0), v3(0, 0.3f * y, 0), 0.14f, 0.08f);
        dmg_rod(b, v3(0, 0, 0), v3(0, fork, 0), 0.05f);
        uint32_t turns = dmg_spin(b, 0, "swivel", v3(0, fork, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, fork - 0.1f, 0), v3(0, fork + 0.02f, 0), 0.07f);
        dmg_box(b, v3(0, fork + 0.01f, 0), v3(1.9f * t, 0.03f, 0.1f));
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.85f * t - 0.015f, fork, -0.05f),
                         v3((float)s * 0.85f * t + 0.015f, y + 0.04f, 0.05f));
        dmg_rod(b, v3(-t, y, 0), v3(t, y, 0), 0.02f);
        dmg_move(b, 0, y, 0);
        draw_see_saw_beam(b, turns, reach, t, y, pairs);
        return;
    }
    draw_trestle(b, trestle, y, 0.5f * pitch * (float)(beams - 1) + t, dmg_range(b, 0.025f, 0.05f));
    bool tyres = dmg_chance(b, 0.3f);
    for (int i = 0; i < beams; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(beams - 1));
        for (int s = -1; s <= 1 && tyres; s += 2) /* half sunk, where the ends come down */
            dmg_torus(b, v3(x, 0, (float)s * 0.93f * reach), v3(1, 0, 0), 0.15f * y, 0.06f * y);
        dmg_save(b);
        dmg_move(b, x, y, 0);
        draw_see_saw_beam(b, 0, reach, t, y - (tyres ? 0.22f * y : 0), pairs);
        dmg_restore(b);
    }
}

/* ---- roundabouts ---- */

/* Rails out from the middle, bent hoops on the rim, seats with their backs outward. */
static void draw_deck_things(dmg_builder* b, float r, float y, int kind, int count) {
    float tall = dmg_range(b, 0.5f, 0.9f), tube = dmg_range(b, 0.015f, 0.03f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, count);
        if (kind == 0) {
            const dmg_vec path[] = {
                {0, y + tall, 0.15f * r}, {0, y + tall, 0.8f * r}, {0, y + 0.9f * tall, 0.92f * r}, {0, y, 0.94f * r}};
            dmg_sweep(b, path, 4, tube, tube, false);
        }
        if (kind == 1) {
            const dmg_vec path[] = {{-0.2f * r, y, 0.9f * r},
                                    {-0.2f * r, y + 0.9f * tall, 0.9f * r},
                                    {-0.13f * r, y + tall, 0.9f * r},
                                    {0.13f * r, y + tall, 0.9f * r},
                                    {0.2f * r, y + 0.9f * tall, 0.9f * r},
                                    {0.2f * r, y, 0.9f * r}};
            dmg_sweep(b, path, 6, tube, tube, false);
        }
        if (kind == 2) {
            dmg_move(b, 0, y + 0.5f * tall, 0.75f * r);
            dmg_turn(b, v3(0, 1, 0), DMG_PI);
            draw_seat(b, 3, 0.4f * r);
            dmg_box(b, v3(0, -0.3f * tall, 0), v3(0.2f * r, 0.5f * tall, 0.2f * r));
        }
        dmg_restore(b);
    }
}

/* Cups on a disc: each turns on its own, and so does the wheel in its middle. */
static void draw_cups(dmg_builder* b, uint32_t deck, float r, float y, int count) {
    float own = fminf(0.34f * r, 0.62f * r * sinf(DMG_PI / (float)count)), high = own * dmg_range(b, 0.6f, 1.1f);
    bool wheels = dmg_chance(b, 0.6f), handles = dmg_chance(b, 0.5f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, count);
        dmg_move(b, 0, y, 0.62f * r);
        uint32_t cup = dmg_spin(b, deck, "cup", v3(0, 0, 0), v3(0, 1, 0));
        const dmg_xy bowl[] = {{0, 0.01f},          {0.6f * own, 0.01f},         {0.95f * own, high},
                               {0.88f * own, high}, {0.55f * own, 0.15f * high}, {0, 0.15f * high}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bowl, 6);
        if (handles) dmg_torus(b, v3(0.95f * own, 0.55f * high, 0), v3(0, 0, 1), 0.3f * high, 0.05f * high);
        if (wheels) {
            dmg_rod(b, v3(0, 0, 0), v3(0, 0.7f * high, 0), 0.07f * own);
            dmg_spin(b, cup, "cup_wheel", v3(0, 0.7f * high, 0), v3(0, 1, 0));
            dmg_cone(b, v3(0, 0.68f * high, 0), v3(0, 0.8f * high, 0), 0.4f * own, 0.36f * own);
        }
        dmg_restore(b);
        dmg_use(b, deck);
    }
}

/* Draws a disc on a low bearing; a dish that leans; a mast with a net or pegs; a spider of seats on arms. */
static void draw_roundabout(dmg_builder* b) {
    float r = dmg_range(b, 0.6f, 1.6f), y = dmg_range(b, 0.12f, 0.35f), t = dmg_range(b, 0.03f, 0.08f),
          lean = dmg_chance(b, 0.25f) ? dmg_range(b, 0.1f, 0.4f) : 0.0f;
    int style = dmg_weighted(b, (const float[]){3, 1, 1, 1.2f}, 4), count = dmg_int(b, 3, 6);
    dmg_rod(b, v3(0, 0, 0), v3(0, y, 0), 0.12f * r);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0.4f * y, 0), 0.35f * r, 0.15f * r);
    dmg_move(b, 0, y, 0);
    if (style == 1) dmg_turn(b, v3(1, 0, 0), fminf(lean, 0.6f * t / r));
    bool fixed = style == 0 && dmg_chance(b, 0.35f);
    float post = dmg_range(b, 0.5f, 0.9f), wheel = r * dmg_range(b, 0.2f, 0.35f);
    uint32_t deck = dmg_spin(b, 0, style == 2 ? "mast" : "roundabout", v3(0, 0, 0), v3(0, 1, 0));
    if (style == 0 || style == 3) {
        const dmg_xy disc[] = {{0.16f * r, 0}, {0.95f * r, 0}, {r, 0.5f * t},
                               {0.95f * r, t}, {0.16f * r, t}, {0.16f * r, 0}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), disc, 6);
        if (style == 0)
            draw_deck_things(b, r, t, dmg_int(b, 0, 2), count);
        else
            draw_cups(b, deck, r, t, count);
    }
    if (style == 1) { /* a dish to sit in */
        const dmg_xy dish[] = {
            {0, 0}, {0.3f * r, 0}, {r, 0.45f * r}, {0.93f * r, 0.46f * r}, {0.28f * r, 0.08f * r}, {0, 0.08f * r}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), dish, 6);
    }
    if (style == 2) { /* a mast to stand and climb on */
        dmg_rod(b, v3(0, 0, 0), v3(0, 2.2f * r, 0), 0.05f * r);
        dmg_rod(b, v3(0, 0.05f * r, 0), v3(0, 0.05f * r + t, 0), 0.4f * r);
        for (int i = 0; i < count; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, count);
            dmg_rod(b, v3(0, 0.05f * r + t, 0.35f * r), v3(0, 2.1f * r, 0.03f * r), 0.025f * r);
            dmg_rod(b, v3(0, 1.3f * r, 0), v3(0, 1.3f * r, 0.35f * r), 0.03f * r);
            dmg_restore(b);
        }
    }
    dmg_use(b, fixed || style == 3 ? 0 : deck);
    if (style == 0 ||
        style == 3) { /* a wheel in the middle to pull round by: it stands still, or turns with the rest */
        dmg_rod(b, v3(0, 0, 0), v3(0, post, 0), 0.06f * r);
        dmg_torus(b, v3(0, post, 0), v3(0, 1, 0), wheel, 0.03f * r);
        dmg_box(b, v3(0, post, 0), v3(2 * wheel, 0.03f * r, 0.06f * r));
    }
    dmg_use(b, 0);
}

/* ---- rockers on springs ---- */

static void draw_coil(dmg_builder* b, float r, float low, float high, float tube) {
    enum { POINTS = 33 };
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float share = (float)i / (POINTS - 1), angle = 2.0f * DMG_PI * 4.0f * share;
        path[i] = v3(r * cosf(angle), low + (high - low) * share, r * sinf(angle));
    }
    dmg_sweep(b, path, POINTS, tube, tube, false);
}

/* Cheeks cut like an animal, a car or a wave; a body turned like an egg; a log; a platform for two. Facing +Z, its
 * underside on y = 0. */
static void draw_mount(dmg_builder* b, int kind, float l) {
    float nose = l * dmg_range(b, 0.35f, 0.6f), crest = l * dmg_range(b, 0.4f, 0.8f), t = 0.03f * l;
    const dmg_xy cheek[] = {{-0.55f * l, 0.1f * l},    {-0.2f * l, 0},     {0.3f * l, 0},        {nose, 0.25f * l},
                            {0.55f * l, 0.7f * crest}, {0.35f * l, crest}, {0.2f * l, 0.4f * l}, {-0.3f * l, 0.32f * l},
                            {-0.5f * l, 0.5f * l}};
    if (kind == 0) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, cheek, 9, -0.15f * l, t - 0.15f * l);
        dmg_extrude(b, cheek, 9, 0.15f * l - t, 0.15f * l);
        dmg_restore(b);
        dmg_box(b, v3(0, 0.35f * l, -0.05f * l), v3(0.27f * l, 0.05f * l, 0.35f * l));
        dmg_box(b, v3(0, 0.03f * l, 0.05f * l), v3(0.27f * l, 0.05f * l, 0.4f * l));
    }
    if (kind == 1) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, cheek, 9, -0.04f * l, 0.04f * l);
        dmg_restore(b);
        dmg_box(b, v3(0, 0.37f * l, -0.05f * l), v3(0.3f * l, 0.05f * l, 0.35f * l));
    }
    if (kind == 2) {
        dmg_ellipsoid(b, v3(0, 0.2f * l, 0), v3(0.2f * l, 0.2f * l, 0.5f * l));
        dmg_ellipsoid(b, v3(0, 0.5f * l, 0.45f * l), v3(0.13f * l, 0.15f * l, 0.17f * l));
    }
    if (kind == 3) {
        dmg_box(b, v3(0, 0.05f * l, 0), v3(0.3f * l, 0.1f * l, 1.6f * l));
        for (int s = -1; s <= 1; s += 2) {
            dmg_save(b);
            if (s > 0) dmg_turn(b, v3(0, 1, 0), DMG_PI);
            dmg_move(b, 0, 0.25f * l, -0.6f * l);
            draw_seat(b, 3, 0.35f * l);
            dmg_restore(b);
        }
    }
    float foot = 0.15f * l, hand = kind == 3 ? 0.55f * l : 0.62f * l;
    dmg_rod(b, v3(-0.3f * l, foot, 0.15f * l), v3(0.3f * l, foot, 0.15f * l), 0.025f * l);
    dmg_rod(b, v3(-0.25f * l, hand, 0.25f * l), v3(0.25f * l, hand, 0.25f * l), 0.025f * l);
    dmg_box(b, v3(0, 0.5f * (hand + foot), 0.25f * l), v3(0.06f * l, hand - foot, 0.05f * l));
}

static void draw_springer(dmg_builder* b) {
    float l = dmg_range(b, 0.5f, 0.9f), spring = l * dmg_range(b, 0.4f, 0.7f), r = l * dmg_range(b, 0.1f, 0.17f),
          tube = r * dmg_range(b, 0.12f, 0.22f), split = dmg_range(b, 0.0f, 0.6f), lean = dmg_range(b, 0.15f, 0.4f);
    int kind = dmg_int(b, 0, 3), count = kind == 3 && dmg_chance(b, 0.5f) ? 2 : 1;
    bool side = dmg_chance(b, 0.25f), lathe = dmg_chance(b, 0.25f);
    if (split < 0.15f) split = 0.0f; /* all of the spring moves with its rider */
    dmg_box(b, v3(0, 0.02f * l, 0), v3(3 * r, 0.04f * l, count == 2 ? l : 3 * r));
    float at = spring * split;
    for (int pass = 0; pass < 2; ++pass) {
        if (pass) {
            uint32_t rocker = dmg_hinge(b, 0, "rocker", v3(0, at, 0), side ? v3(0, 0, 1) : v3(1, 0, 0), -lean, lean);
            if (dmg_chance(b, 0.25f)) dmg_rest(b, rocker, lean * dmg_range(b, -1, 1));
        }
        float low = pass ? at : 0.04f * l, high = pass ? spring : at;
        for (int i = 0; i < count && high > low; ++i) {
            float z = count == 2 ? (i ? 0.35f : -0.35f) * l : 0.0f;
            dmg_save(b);
            dmg_move(b, 0, 0, z);
            if (lathe)
                dmg_cone(b, v3(0, low, 0), v3(0, high, 0), r, 0.9f * r);
            else
                draw_coil(b, r, low, high, tube);
            dmg_restore(b);
        }
    }
    dmg_box(b, v3(0, spring, 0), v3(2.2f * r, 0.03f * l, count == 2 ? l : 2.2f * r));
    dmg_move(b, 0, spring + 0.015f * l, 0);
    draw_mount(b, kind, l);
    dmg_use(b, 0);
}

/* ---- swings ---- */

/* Draws one seat under the beam at the origin, hung `drop` deep: chains as rods. */
static void draw_swing_seat(dmg_builder* b, int kind, float drop, float w) {
    float swing = dmg_range(b, 0.5f, 1.1f), r = 0.012f;
    uint32_t part = dmg_hinge(b, 0, "swing", v3(0, 0, 0), v3(1, 0, 0), -swing, swing);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, part, swing * dmg_range(b, -0.6f, 0.6f));
    float z = kind >= 3 ? 0.7f * w : 0.0f, top = kind >= 3 ? 0.35f : 1.0f;
    if (kind == 2) { /* a tyre on three chains from one swivel */
        dmg_rod(b, v3(0, 0, 0), v3(0, -0.15f * drop, 0), 0.025f);
        dmg_spin(b, part, "tyre", v3(0, -0.15f * drop, 0), v3(0, 1, 0));
        for (int i = 0; i < 3; ++i) {
            dmg_vec rim = v3_turn(v3(0, -drop, w), v3(0, 1, 0), 2.0f * DMG_PI * (float)i / 3.0f);
            dmg_rod(b, v3(0, -0.15f * drop, 0), rim, r);
        }
        dmg_torus(b, v3(0, -drop, 0), v3(0, 1, 0), w, 0.25f * w);
        dmg_use(b, 0);
        return;
    }
    for (int s = -1; s <= 1; s += 2)
        for (int k = -1; k <= (z > 0 ? 1 : -1); k += 2)
            dmg_rod(b, v3((float)s * 0.55f * w, 0, (float)k * z * (1 - top)),
                    v3((float)s * 0.5f * w, -drop, (float)k * z), r);
    dmg_save(b);
    dmg_move(b, 0, -drop + 0.05f * w, 0);
    if (kind == 0) dmg_box(b, v3(0, -0.05f * w, 0), v3(1.1f * w, 0.08f * w, 0.5f * w));
    if (kind == 1) { /* a bucket with holes for the legs */
        draw_seat(b, 3, w);
        dmg_box(b, v3(0, 0.3f * w, 0.45f * w), v3(w, 0.15f * w, 0.1f * w));
    }
    if (kind == 3) { /* a nest */
        dmg_torus(b, v3(0, 0, 0), v3(0, 1, 0), 0.85f * w, 0.08f * w);
        dmg_rod(b, v3(0, -0.06f * w, 0), v3(0, 0, 0), 0.85f * w);
    }
    if (kind == 4) { /* a boat for two who face each other */
        dmg_box(b, v3(0, -0.05f * w, 0), v3(1.05f * w, 0.1f * w, 2.2f * w));
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, 0.3f * w, (float)s * 1.05f * w), v3(w, 0.7f * w, 0.1f * w));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_swings(dmg_builder* b) {
    int seats = dmg_int(b, 1, 3), legs = dmg_int(b, 0, 2), kind = dmg_int(b, 0, 4);
    float high = dmg_range(b, 1.6f, 2.8f), w = dmg_range(b, 0.35f, 0.55f), pitch = w * dmg_range(b, 2.2f, 3.2f),
          r = dmg_range(b, 0.03f, 0.07f), drop = high * dmg_range(b, 0.6f, 0.8f),
          half = 0.5f * pitch * (float)seats + 0.3f * w, spread = high * dmg_range(b, 0.3f, 0.5f);
    bool alike = dmg_chance(b, 0.5f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        if (legs == 1) dmg_rod(b, v3(x, 0, 0), v3(x, high, 0), 1.4f * r);
        for (int k = -1; k <= 1 && legs != 1; k += 2)
            dmg_rod(b, v3(x + (float)s * 0.1f * high, 0, (float)k * spread), v3(x, high, 0), r);
        if (legs == 2)
            dmg_rod(b, v3(x + (float)s * 0.05f * high, 0.5f * high, -0.5f * spread),
                    v3(x + (float)s * 0.05f * high, 0.5f * high, 0.5f * spread), 0.7f * r);
    }
    dmg_rod(b, v3(-half - 0.1f, high, 0), v3(half + 0.1f, high, 0), 1.1f * r);
    for (int i = 0; i < seats; ++i) {
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(seats - 1)), high - r * dmg_range(b, 0.0f, 1.5f), 0);
        draw_swing_seat(b, alike ? kind : dmg_int(b, 0, 4), drop, w);
        dmg_restore(b);
    }
}

/* ---- a digger for the sand ---- */

/* Boom, arm and bucket in the plane x = 0. */
static void draw_digger_arm(dmg_builder* b, uint32_t cab, dmg_vec foot, float boom, float r) {
    float arm = boom * dmg_range(b, 0.6f, 1.0f), rise = boom * dmg_range(b, 0.3f, 0.7f);
    float reach = sqrtf(boom * boom - rise * rise);
    dmg_vec knee = v3_add(foot, v3(0, rise, reach)), tip = {0, knee.y - arm * 0.85f, knee.z + arm * 0.4f};
    if (tip.y < 0.12f) tip.y = 0.12f;
    uint32_t first = dmg_hinge(b, cab, "boom", foot, v3(1, 0, 0), -dmg_range(b, 0.2f, 0.6f), 0.25f);
    dmg_beam(b, foot, knee, 2 * r, 2 * r);
    dmg_rod(b, v3_add(foot, v3(-2.6f * r, 0, 0)), v3_add(foot, v3(2.6f * r, 0, 0)), 0.7f * r);
    uint32_t second = dmg_hinge(b, first, "arm", knee, v3(1, 0, 0), -0.5f, 0.4f);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3_add(knee, v3((float)s * 1.6f * r, 0.1f * arm, -0.06f * arm)),
                 v3_add(tip, v3((float)s * 1.6f * r, 0, 0)), r, 2 * r);
    dmg_rod(b, v3_add(knee, v3(-2.4f * r, 0, 0)), v3_add(knee, v3(2.4f * r, 0, 0)), 0.7f * r);
    dmg_hinge(b, second, "bucket", tip, v3(1, 0, 0), -0.3f, dmg_range(b, 0.8f, 1.5f));
    const dmg_xy shell[] = {{0, 0.02f}, {0.03f, -0.1f}, {-0.06f, -0.14f}, {-0.16f, -0.1f}};
    dmg_save(b);
    dmg_move(b, 0, tip.y, tip.z);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_bent_plate(b, shell, 4, 0.012f, 0.16f);
    for (int s = -1; s <= 1; s += 2)
        dmg_extrude(b, (const dmg_xy[]){shell[3], shell[2], shell[1], shell[0]}, 4, (float)s * 0.08f - 0.006f,
                    (float)s * 0.08f + 0.006f);
    dmg_restore(b);
}

static void draw_digger(dmg_builder* b) {
    float y = dmg_range(b, 0.3f, 0.5f), boom = dmg_range(b, 0.4f, 0.7f), r = dmg_range(b, 0.018f, 0.03f),
          out = dmg_range(b, 0.15f, 0.3f);
    int levers = dmg_int(b, 0, 2);
    dmg_rod(b, v3(0, 0, 0), v3(0, y - 0.05f, 0), 0.05f);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0.05f, 0), 0.2f, 0.15f);
    uint32_t cab = dmg_spin(b, 0, "digger", v3(0, y, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, y - 0.06f, 0), v3(0, y, 0), 0.07f);
    dmg_box_span(b, v3(-2 * r, y - 0.03f, -0.15f), v3(2 * r, y + 0.02f, out));
    dmg_save(b);
    dmg_move(b, 0, y + 0.08f, -0.05f);
    draw_seat(b, dmg_int(b, 0, 3), 0.28f);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 2 * r - 0.5f * r, y - 0.03f, out - 2 * r),
                     v3((float)s * 2 * r + 0.5f * r, y + 0.08f + r, out + 2 * r));
    draw_digger_arm(b, cab, v3(0, y + 0.08f, out), boom, r);
    for (int i = 0; i < levers; ++i) {
        float x = i ? 0.1f : -0.1f;
        dmg_use(b, cab);
        dmg_box(b, v3(0.5f * x, y + 0.01f, 0.6f * out), v3(fabsf(x), 0.02f, 0.03f));
        dmg_hinge(b, cab, "lever", v3(x, y + 0.02f, 0.6f * out), v3(1, 0, 0), -0.4f, 0.4f);
        dmg_rod(b, v3(x, y, 0.6f * out), v3(x, y + 0.35f, 0.6f * out - 0.03f), 0.012f);
        dmg_ellipsoid(b, v3(x, y + 0.36f, 0.6f * out - 0.03f), v3(0.025f, 0.025f, 0.025f));
    }
    dmg_use(b, 0);
}

void dmg_build_playground_piece(dmg_builder* b) {
    int kind = dmg_int(b, 0, 4);
    if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * (float)dmg_int(b, 0, 3));
    if (kind == 0) draw_see_saw(b);
    if (kind == 1) draw_roundabout(b);
    if (kind == 2) draw_springer(b);
    if (kind == 3) draw_swings(b);
    if (kind == 4) draw_digger(b);
    dmg_use(b, 0);
}
