/* Draws round kitchen machines: blenders whose jug lifts off a turned base, coffee makers whose body is no box. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

/* ---- on a turned body: the frame to a place of its flank ---- */

/* Draws a cone's flank: radius `low` at y = 0, `high` at y = top; +Z out, +Y up along it. */
static void to_flank(dmg_builder* b, float low, float high, float top, float share, float round) {
    dmg_turn(b, v3(0, 1, 0), round);
    dmg_move(b, 0, share * top, low + (high - low) * share);
    dmg_turn(b, v3(1, 0, 0), -atan2f(low - high, top));
}

/* Draws a dial with a grip across it, or keys. */
static void draw_flank_controls(dmg_builder* b, float size) {
    int kind = dmg_int(b, 0, 2), keys = dmg_int(b, 1, 3);
    if (kind == 0) {
        float upper = dmg_range(b, 1.0f, 5.0f), low = dmg_chance(b, 0.5f) ? 0.0f : -0.5f * upper;
        if (dmg_chance(b, 0.3f))
            dmg_spin(b, 0, "dial", v3(0, 0, 0), v3(0, 0, -1));
        else
            dmg_hinge(b, 0, "dial", v3(0, 0, 0), v3(0, 0, -1), low, upper + low);
        if (dmg_chance(b, 0.4f)) { /* a disc with a blade on it, wider at one end */
            float thin = size * dmg_range(b, 0.1f, 0.3f);
            dmg_rod(b, v3(0, 0, -0.2f * size), v3(0, 0, thin), size);
            dmg_box(b, v3(0, 0, 1.5f * thin), v3(0.3f * size, 1.9f * size, 2 * thin));
        } else {
            dmg_any_knob_draw(b, size, 0.3f, 1.2f);
        }
        dmg_use(b, 0);
    }
    for (int i = 0; i < keys && kind > 0; ++i) {
        dmg_save(b);
        if (kind == 1) dmg_move(b, size * ((float)i - 0.5f * (float)(keys - 1)), 0, 0);
        if (kind == 2) dmg_move(b, 0, size * ((float)i - 0.5f * (float)(keys - 1)), 0);
        dmg_thumb_key_draw(b, 0, "button", 0.4f * size);
        dmg_restore(b);
    }
}

/* ---- blender ---- */

static void draw_bow_handle(dmg_builder* b, float at, float low, float high, float reach, float thick) {
    enum { POINTS = 7 };
    dmg_vec path[POINTS];
    bool square = dmg_chance(b, 0.4f);
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * ((float)i / (POINTS - 1) - 0.5f), out = cosf(angle);
        path[i] = v3(0, 0.5f * (low + high) + 0.5f * (high - low) * sinf(angle),
                     at + reach * (square ? fminf(1.0f, 2.0f * out) : out));
    }
    dmg_sweep(b, path, POINTS, thick, thick * dmg_range(b, 1.0f, 2.0f), false);
}

/* On y = 0; its wall is a shell, or as solid as many are drawn. */
static void draw_jar(dmg_builder* b, float radius, float height, bool handle) {
    float foot = radius * dmg_range(b, 0.6f, 1.05f), wall = 0.04f * radius, collar = height * dmg_range(b, 0.05f, 0.2f);
    bool solid = dmg_chance(b, 0.4f);
    const dmg_xy shell[] = {{0, 0},
                            {foot, 0},
                            {foot, collar},
                            {radius, height},
                            {radius - wall, height},
                            {foot - wall, collar},
                            {0, 0.8f * collar}};
    const dmg_xy block[] = {{0, 0}, {foot, 0}, {foot, collar}, {radius, height}, {0, height}};
    if (solid)
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), block, 5);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), shell, 7);
    if (handle)
        draw_bow_handle(b, 0.9f * fminf(foot, radius), 0.25f * height, 0.85f * height,
                        radius * dmg_range(b, 0.4f, 0.8f), 0.08f * radius);
}

static void draw_jar_lid(dmg_builder* b, uint32_t jar, float radius, float height) {
    float thick = height * dmg_range(b, 0.04f, 0.15f);
    bool own = dmg_chance(b, 0.5f);
    if (own) dmg_slide(b, jar, "lid", v3(0, 1, 0), 0.0f, height * dmg_range(b, 0.1f, 0.8f));
    dmg_rod(b, v3(0, height, 0), v3(0, height + thick, 0), 1.03f * radius);
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, height + thick, 0), v3(0, height + 2 * thick, 0), 0.35f * radius);
    if (own) dmg_use(b, jar);
}

void dmg_build_blender(dmg_builder* b) {
    float base = dmg_range(b, 0.08f, 0.2f), low = dmg_range(b, 0.07f, 0.11f), high = low * dmg_range(b, 0.5f, 1.0f),
          radius = low * dmg_range(b, 0.6f, 1.0f), height = base * dmg_range(b, 0.9f, 2.2f);
    bool square = dmg_chance(b, 0.3f);
    if (square) {
        dmg_rounded_box(b, v3(0, 0.5f * base, 0), v3(2 * low, base, 2 * low), 0.3f * low);
        high = low;
    } else {
        float belly = dmg_range(b, -0.1f, 0.25f) * low;
        const dmg_xy profile[] = {
            {0, 0}, {low, 0}, {0.5f * (low + high) + belly, 0.5f * base}, {high, base}, {0, base}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 5);
        low += fmaxf(0.0f, belly); /* of the flank's middle, where the controls are */
        high += fmaxf(0.0f, belly);
    }
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, base, 0), v3(0, 1.08f * base, 0), 0.35f * radius);
    dmg_save(b);
    dmg_move(b, 0, base, 0);
    float round = dmg_range(b, 0, 2.0f * DMG_PI);
    dmg_turn(b, v3(0, 1, 0), round);
    uint32_t jar;
    if (dmg_chance(b, 0.75f))
        jar = dmg_slide(b, 0, "jar", v3(0, 1, 0), 0.0f, height * dmg_range(b, 0.08f, 1.0f));
    else {
        const float upper = dmg_range(b, 0.3f, 0.9f);
        const dmg_vec axis = v3(0, dmg_sign(b), 0);
        jar = dmg_hinge(b, 0, "jar", v3(0, 0, 0), axis, 0.0f, upper);
    }
    draw_jar(b, radius, height, dmg_chance(b, 0.75f));
    draw_jar_lid(b, jar, radius, height);
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_turn(b, v3(0, 1, 0), square ? 0.0f : dmg_range(b, -1.0f, 1.0f));
    to_flank(b, low, high, base, 0.5f, 0);
    draw_flank_controls(b, base * dmg_range(b, 0.1f, 0.22f));
}

/* ---- coffee maker ---- */

typedef struct maker {
    float radius, height, foot; /* of the body; of the plate it stands on */
    float reach, cup;           /* where the cup is, before the axis; the room under the spout */
} maker;

/* Draws a ball, an egg, a drum or a block, its top a plane wide enough for a button. Returns the top's height. */
static float draw_maker_body(dmg_builder* b, const maker* m) {
    float r = m->radius, h = m->height, waist = dmg_range(b, 0.6f, 1.0f);
    int shape = dmg_int(b, 0, 3);
    const dmg_xy ball[] = {{0, 0},
                           {0.7f * r, 0},
                           {0.95f * r, 0.25f * h},
                           {r, 0.5f * h},
                           {0.9f * r, 0.78f * h},
                           {0.6f * r, 0.95f * h},
                           {0.3f * r, h},
                           {0, h}};
    const dmg_xy drum[] = {{0, 0}, {r, 0}, {waist * r, 0.5f * h}, {r, 0.97f * h}, {0.95f * r, h}, {0, h}};
    if (shape <= 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), ball, 8);
    if (shape == 2) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), drum, 6);
    if (shape == 3) dmg_rounded_box(b, v3(0, 0.5f * h, 0), v3(1.5f * r, h, 1.9f * r), 0.3f * r);
    return h;
}

/* Draws the button on top: a low cone, a disc in rings, a dome. Round as a knob, but it is pressed. */
static void draw_top_button(dmg_builder* b, float radius) {
    float rise = radius * dmg_range(b, 0.2f, 0.6f), deep = radius * dmg_range(b, 0.0f, 0.6f),
          flat = dmg_range(b, 0.3f, 0.95f);
    const dmg_xy cone[] = {{0, -deep}, {radius, -deep}, {radius, 0.2f * rise}, {flat * radius, rise}, {0, rise}};
    const dmg_xy rings[] = {{radius, -deep},
                            {radius, rise},
                            {0.7f * radius, rise},
                            {0.7f * radius, 0.6f * rise},
                            {0.55f * radius, 0.6f * rise},
                            {0.5f * radius, 0.9f * rise},
                            {0, rise}};
    int shape = dmg_int(b, 0, 2);
    dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, rise * dmg_scale_range(b, 0.1f, 0.45f));
    if (shape == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cone, 5);
    if (shape == 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), rings, 7);
    if (shape == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(radius, radius, rise));
    dmg_use(b, 0);
}

/* Draws a head that reaches over the cup, with its lever: one arm or a yoke, up and back over the pin. */
static void draw_brew_head(dmg_builder* b, const maker* m) {
    float r = m->radius * dmg_range(b, 0.3f, 0.5f), y = m->cup + 0.5f * r, arm = m->reach * dmg_range(b, 0.5f, 1.0f),
          wide = 2.1f * r, thin = 0.12f * r, up = dmg_range(b, -0.2f, 0.4f);
    dmg_rod(b, v3(0, y + 0.5f * r, 0), v3(0, y + 0.5f * r, m->reach), 0.7f * r);
    dmg_rod(b, v3(0, y - 0.5f * r, m->reach), v3(0, y + 1.2f * r, m->reach), r);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) { /* a yoke about the head, pinned at its sides */
        dmg_vec pin = {0, y + 0.5f * r, m->reach};
        dmg_hinge(b, 0, "lever", pin, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.6f));
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec foot = v3_add(pin, v3((float)s * 0.5f * wide, 0, 0));
            dmg_beam(b, foot, v3_add(foot, v3(0, up * arm, arm + r)), thin, 2 * thin);
        }
        dmg_vec end = v3_add(pin, v3(0, up * arm, arm + r));
        dmg_rod(b, v3_add(end, v3(-0.55f * wide, 0, 0)), v3_add(end, v3(0.55f * wide, 0, 0)), 1.2f * thin);
    }
    if (kind == 1) {
        const float upper = dmg_range(b, 0.5f, 1.2f);
        const dmg_vec axis = v3(0, dmg_sign(b), 0); /* the holder turns under the head */
        dmg_hinge(b, 0, "holder", v3(0, y, m->reach), axis, 0.0f, upper);
        dmg_rod(b, v3(0, y - 0.9f * r, m->reach), v3(0, y - 0.5f * r, m->reach), 0.9f * r);
        dmg_beam(b, v3(0, y - 0.7f * r, m->reach + 0.8f * r), v3(0, y - 0.7f * r, m->reach + 0.8f * r + arm), 0.3f * r,
                 0.25f * r);
    }
    if (kind == 2) { /* a flap on top of the head */
        dmg_hinge(b, 0, "flap", v3(0, y + 1.25f * r, m->reach - r), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.7f));
        dmg_rod(b, v3(0, y + 1.2f * r, m->reach), v3(0, y + 1.4f * r, m->reach), 1.05f * r);
    }
    dmg_use(b, 0);
}

void dmg_build_coffee_maker(dmg_builder* b) {
    maker m = {.radius = dmg_range(b, 0.07f, 0.14f), .foot = dmg_range(b, 0.01f, 0.05f)};
    m.height = m.radius * dmg_range(b, 1.6f, 3.2f);
    m.reach = m.radius * dmg_range(b, 1.3f, 2.0f);
    m.cup = m.foot + (m.height - m.foot) * dmg_range(b, 0.4f, 0.65f);
    if (dmg_chance(b, 0.7f))
        dmg_cone(b, v3(0, 0, 0), v3(0, m.foot, 0), 1.15f * m.radius, m.radius);
    else
        dmg_box_span(b, v3(-m.radius, 0, -m.radius), v3(m.radius, m.foot, m.radius));
    dmg_save(b);
    dmg_move(b, 0, 0.8f * m.foot, 0);
    float top = draw_maker_body(b, &m);
    dmg_save(b);
    dmg_move(b, 0, top, 0);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    int on_top = dmg_int(b, 0, 3);
    if (on_top <= 1) draw_top_button(b, m.radius * dmg_range(b, 0.12f, 0.3f));
    if (on_top == 2) draw_flank_controls(b, 0.15f * m.radius);
    dmg_restore(b);
    dmg_restore(b);
    draw_brew_head(b, &m);
    dmg_box_span(b, v3(-0.4f * m.radius, 0, 0), v3(0.4f * m.radius, 0.2f * m.foot, m.reach + 0.3f * m.radius));
    dmg_slide(b, 0, "drip_tray", v3(0, 0, 1), 0.0f, m.radius * dmg_range(b, 0.3f, 1.2f));
    dmg_rod(b, v3(0, 0.22f * m.foot, m.reach + 0.3f * m.radius), v3(0, 0.9f * m.foot, m.reach + 0.3f * m.radius),
            0.6f * m.radius);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) { /* the tank behind lifts out */
        dmg_slide(b, 0, "tank", v3(0, 1, 0), 0.0f, m.height * dmg_range(b, 0.2f, 0.9f));
        dmg_rod(b, v3(0, m.foot, -1.5f * m.radius), v3(0, 0.85f * m.height, -1.5f * m.radius), 0.5f * m.radius);
        dmg_use(b, 0);
    }
}
