/* Draws things of two halves about a line: laptops, telephones, staplers, tools. */
#include "core/build.h"
#include "parts/hardware.h"

/* Keys as parts of the body or joints of their own, on y = 0 facing up, over width x depth centred at the origin. */
static void draw_keys(dmg_builder* b, float width, float depth, float rise, bool moving) {
    int columns = moving ? dmg_int(b, 4, 8) : dmg_int(b, 6, 12), rows = moving ? dmg_int(b, 2, 4) : dmg_int(b, 3, 5);
    float px = width / (float)columns, pz = depth / (float)rows;
    if (moving) {
        dmg_buttons keys = {"key",      columns,    rows, px,          pz,
                            0.84f * px, 0.84f * pz, rise, 0.6f * rise, dmg_chance(b, 0.7f) ? 0 : 2};
        dmg_save(b);
        dmg_face_up(b);
        dmg_buttons_draw(b, 0, &keys);
        dmg_restore(b);
        return;
    }
    for (int i = 0; i < columns * rows; ++i) {
        float x = px * ((float)(i % columns) + 0.5f) - 0.5f * width,
              z = pz * ((float)(i / columns) + 0.5f) - 0.5f * depth;
        dmg_box(b, v3(x, 0.5f * rise, z), v3(0.84f * px, rise, 0.84f * pz));
    }
}

/* Draws a half of a laptop, lying on y = 0 … thick. */
static void draw_half(dmg_builder* b, int style, float width, float depth, float thick) {
    dmg_save(b);
    dmg_move(b, 0, thick, 0);
    dmg_face_up(b);
    if (style == 0)
        dmg_rounded_plate(b, width, depth, thick, 0.06f * depth);
    else if (style == 1)
        dmg_rounded_box(b, v3(0, 0, -0.5f * thick), v3(width, depth, thick), 0.4f * thick);
    else
        dmg_box(b, v3(0, 0, -0.5f * thick), v3(width, depth, thick));
    dmg_restore(b);
}

/* Draws the screen half, lying closed on y = 0 … thick, hinge line along X at z = -depth / 2. */
static void draw_screen(dmg_builder* b, int style, float width, float depth, float thick) {
    float bezel = 0.05f * width;
    draw_half(b, style, width, depth, thick);
    if (dmg_chance(b, 0.4f))
        dmg_box(b, v3(0, -0.02f * thick, 0), v3(width - 2 * bezel, 0.1f * thick, depth - 2 * bezel));
    if (dmg_chance(b, 0.15f)) dmg_box(b, v3(0, 1.05f * thick, 0), v3(0.15f * depth, 0.1f * thick, 0.15f * depth));
}

void dmg_build_laptop(dmg_builder* b) {
    float width = dmg_range(b, 0.22f, 0.42f), depth = width * dmg_range(b, 0.58f, 0.8f),
          base = width * dmg_range(b, 0.03f, 0.12f);
    float thick = width * dmg_range(b, 0.015f, 0.06f), gap = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0005f, 0.003f);
    int style = dmg_int(b, 0, 3);
    draw_half(b, style, width, depth, base);
    int keyboard = dmg_int(b, 0, 3); /* none, drawn, moving keys, a sunken field */
    dmg_save(b);
    dmg_move(b, 0, base, -0.15f * depth);
    if (keyboard == 1) draw_keys(b, 0.9f * width, 0.5f * depth, 0.4f * gap + 0.001f, false);
    if (keyboard == 2 && dmg_chance(b, 0.3f)) draw_keys(b, 0.9f * width, 0.5f * depth, 0.004f, true);
    if (keyboard == 3) dmg_box(b, v3(0, 0, 0), v3(0.9f * width, 0.0015f, 0.5f * depth));
    dmg_move(b, 0, 0, 0.48f * depth);
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0, 0), v3(0.25f * width, 0.0012f, 0.22f * depth)); /* touch pad */
    dmg_restore(b);
    float radius = fminf(base, thick) * dmg_range(b, 0.3f, 0.7f),
          back = -0.5f * depth + radius * dmg_range(b, -1.2f, 1.2f);
    if (dmg_chance(b, 0.5f)) back = depth * dmg_range(b, -0.5f, -0.4f); /* inside the lid's lower edge */
    float up = base + gap + (dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, -0.5f, 0.5f) * base);
    if (dmg_chance(b, 0.5f)) { /* the barrel under the screen's lower edge */
        float span = width * dmg_range(b, 0.06f, 0.45f);
        int barrels = span > 0.25f * width ? 1 : 2;
        for (int i = 0; i < barrels; ++i) {
            float x = barrels == 1 ? 0.0f : width * ((float)i - 0.5f) * 0.75f;
            dmg_rod(b, v3(x - 0.5f * span, up, back), v3(x + 0.5f * span, up, back), radius);
        }
    }
    float far = dmg_range(b, 2.1f, 3.14f);
    uint32_t screen = dmg_hinge(b, 0, "screen", v3(0, up, back), v3(-1, 0, 0), 0.0f, far);
    dmg_move(b, 0, base + gap, 0);
    float scale = dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.9f, 1.02f);
    draw_screen(b, style, width * scale, depth * scale, thick);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.75f)) dmg_rest(b, screen, dmg_range(b, 1.2f, fminf(2.3f, far)));
}

/* ---- telephone ---- */

/* Keys of a telephone on z = 0, in a field centred at the origin. */
static void draw_phone_keys(dmg_builder* b, uint32_t parent, float width, float height) {
    float px = width / 3.0f, py = height / 5.0f, fill = dmg_range(b, 0.6f, 0.9f), rise = px * dmg_range(b, 0.05f, 0.2f);
    dmg_buttons keys = {"key", 3, dmg_int(b, 4, 5), px, py, fill * px, fill * py, rise, 0.7f * rise, dmg_int(b, 0, 3)};
    dmg_buttons_draw(b, parent, &keys);
}

/* Draws two plates about a line, or one over the other on rails. */
static void draw_folding_phone(dmg_builder* b, float width, float length, float thick) {
    int kind = dmg_int(b, 0, 2); /* flip, book, slider */
    float t = 0.5f * thick, gap = 0.02f * thick;
    dmg_move(b, 0, t, 0);
    dmg_face_up(b);
    dmg_rounded_plate(b, width, length, t, 0.15f * width);
    dmg_save(b);
    dmg_move(b, 0, -0.1f * length, 0);
    if (kind != 1) draw_phone_keys(b, 0, 0.85f * width, 0.6f * length);
    dmg_restore(b);
    if (kind == 2) {
        dmg_slide(b, 0, "slider", v3(0, 1, 0), 0.0f, 0.55f * length);
        dmg_move(b, 0, 0, t + 0.2f * thick);
        dmg_rounded_plate(b, width, length, t, 0.15f * width);
        dmg_use(b, 0);
        return;
    }
    float in = thick * dmg_range(b, -0.2f, 0.4f), r = t * dmg_range(b, 0.4f, 0.9f);
    dmg_vec pivot = kind == 0 ? v3(0, 0.5f * length - in, gap) : v3(-0.5f * width + in, 0, gap);
    dmg_vec axis = kind == 0 ? v3(-1, 0, 0) : v3(0, -1, 0), along = v3_scale(axis, 0.5f * (kind == 0 ? width : length));
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3_mad(pivot, along, -0.5f), v3_mad(pivot, along, 0.5f), r);
    float far = dmg_range(b, 2.4f, 3.14f);
    uint32_t cover = dmg_hinge(b, 0, "cover", pivot, axis, 0.0f, far);
    dmg_save(b);
    dmg_move(b, 0, 0, t + gap);
    dmg_rounded_plate(b, width, length, t, 0.15f * width);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, cover, dmg_range(b, 1.5f, far));
    dmg_use(b, 0);
}

/* Draws a plate with keys along its edges. */
static void draw_plate_phone(dmg_builder* b, float width, float length, float thick) {
    dmg_move(b, 0, thick, 0);
    dmg_face_up(b);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_plate(b, width, length, thick, 0.12f * width);
    else
        dmg_rounded_box(b, v3(0, 0, -0.5f * thick), v3(width, length, thick), 0.45f * thick);
    dmg_box(b, v3(0, 0, 0), v3(0.92f * width, 0.88f * length, 0.03f * thick));
    if (dmg_chance(b, 0.5f)) draw_phone_keys(b, 0, 0.8f * width, 0.35f * length);
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), (float)s * 0.5f * DMG_PI);
        dmg_move(b, (float)s * 0.5f * thick, 0.2f * length, 0.5f * width);
        float rise = 0.12f * thick;
        dmg_buttons keys = {s < 0 ? "volume" : "power",
                            1,
                            s < 0 ? 2 : 1,
                            0,
                            0.1f * length,
                            0.35f * thick,
                            0.08f * length,
                            rise,
                            0.7f * rise,
                            0};
        dmg_buttons_draw(b, 0, &keys);
        dmg_restore(b);
    }
}

/* Draws a handset on its cradle. */
static void draw_desk_phone(dmg_builder* b, float width, float depth, float height) {
    const dmg_xy wedge[] = {
        {-0.5f * depth, 0}, {0.5f * depth, 0}, {0.5f * depth, 0.35f * height}, {-0.5f * depth, height}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* x becomes z */
    dmg_extrude(b, wedge, 4, -0.5f * width, 0.5f * width);
    dmg_restore(b);
    float slope = atan2f(0.65f * height, depth), ear = 0.16f * width;
    dmg_move(b, 0, 0.675f * height, 0);
    dmg_turn(b, v3(1, 0, 0), slope - 0.5f * DMG_PI);
    dmg_save(b);
    dmg_move(b, 0.18f * width, 0, 0);
    draw_phone_keys(b, 0, 0.45f * width, 0.6f * depth);
    dmg_restore(b);
    float x = -0.3f * width, rise = 0.3f * height;
    dmg_slide(b, 0, "handset", v3(0, 0, 1), 0.0f, 2 * height);
    dmg_box(b, v3(x, 0, rise), v3(0.7f * ear, 0.9f * depth, 0.6f * ear));
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(x, (float)s * 0.38f * depth, 0.05f * height), v3(x, (float)s * 0.38f * depth, rise), 0.5f * ear);
    dmg_use(b, 0);
}

void dmg_build_phone(dmg_builder* b) {
    float width = dmg_range(b, 0.05f, 0.09f), length = width * dmg_range(b, 1.4f, 2.3f),
          thick = width * dmg_range(b, 0.1f, 0.35f);
    int kind = dmg_int(b, 0, 3);
    if (kind <= 1) draw_folding_phone(b, width, length, thick);
    if (kind == 2) draw_plate_phone(b, width, length, 0.6f * thick);
    if (kind == 3) draw_desk_phone(b, 3 * width, 2.5f * width, width);
}

/* ---- stapler ---- */

void dmg_build_stapler(dmg_builder* b) {
    float length = dmg_range(b, 0.08f, 0.2f), width = length * dmg_range(b, 0.18f, 0.32f),
          base = length * dmg_range(b, 0.04f, 0.1f), high = length * dmg_range(b, 0.12f, 0.28f), t = 0.06f * length;
    float pivot = -0.5f * length + length * dmg_range(b, 0.03f, 0.15f), up = base + high * dmg_range(b, 0.4f, 0.7f);
    /* Along Z, jaw in front. */
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 0.5f * base, 0), v3(width, base, length), 0.3f * base);
    else
        dmg_box(b, v3(0, 0.5f * base, 0), v3(width, base, length));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.35f * width - 0.04f * width, 0.5f * base, pivot - t),
                     v3((float)s * 0.35f * width + 0.04f * width, up + 0.3f * t, pivot + t));
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, base, 0.42f * length), v3(0.4f * width, 0.1f * base, 0.1f * length));
    float rested = dmg_chance(b, 0.5f) ? dmg_range(b, 0.05f, 0.3f) : 0.0f, far = dmg_range(b, 1.5f, 3.0f);
    uint32_t magazine = dmg_hinge(b, 0, "magazine", v3(0, up, pivot), v3(-1, 0, 0), -0.1f, far);
    dmg_box_span(b, v3(-0.28f * width, up - 0.5f * t, pivot - t), v3(0.28f * width, up + 0.4f * t, 0.46f * length));
    dmg_rest(b, magazine, rested);
    uint32_t top = dmg_hinge(b, dmg_chance(b, 0.5f) ? magazine : 0, "arm", v3(0, up, pivot), v3(-1, 0, 0), -0.15f, far);
    dmg_vec back = {0, up + 0.9f * t, pivot - t}, front = {0, up + 1.3f * t, 0.5f * length};
    if (dmg_chance(b, 0.5f))
        dmg_beam(b, back, front, 0.75f * width, t);
    else
        dmg_rounded_box(b, v3_lerp(back, front, 0.5f), v3(0.8f * width, 1.4f * t, length), 0.5f * t);
    dmg_rest(b, top, b->parts[top - 1].joint.parent ? 0.12f : fminf(rested + 0.15f, far));
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(-0.4f * width, up, pivot), v3(0.4f * width, up, pivot), 0.3f * t);
}

/* ---- scissors, pliers: two crossed levers about a pin, lying on y = 0 with the jaws to +X ---- */

typedef struct lever {
    float jaw, grip, width, thick, bend;
    int kind, loop;
} lever;

/* Drawn in x, y; `side` is which way the grip goes. */
static void draw_lever(dmg_builder* b, const lever* l, float side) {
    float w = l->width, z = l->thick;
    if (l->kind == 0) { /* a blade, straight on its inner edge */
        const dmg_xy blade[] = {{-0.5f * w, -0.5f * w},
                                {0.3f * l->jaw, -0.5f * w},
                                {l->jaw, -0.2f * w},
                                {0.6f * l->jaw, 0.3f * w},
                                {-0.5f * w, 0.5f * w}};
        dmg_save(b);
        if (side > 0) dmg_mirror(b, v3(0, 1, 0));
        dmg_extrude(b, blade, 5, -0.5f * z, 0.5f * z);
        dmg_restore(b);
    }
    if (l->kind == 1) { /* a jaw */
        const dmg_xy jaw[] = {
            {-w, -w}, {0.6f * l->jaw, -0.8f * w}, {l->jaw, -0.15f * w}, {l->jaw, 0.05f * w}, {-w, 0.9f * w}};
        dmg_save(b);
        if (side > 0) dmg_mirror(b, v3(0, 1, 0));
        dmg_extrude(b, jaw, 5, -0.5f * z, 0.5f * z);
        dmg_restore(b);
    }
    if (l->kind == 2) dmg_box(b, v3(0.5f * l->jaw, -side * 0.2f * w, 0), v3(l->jaw, 0.6f * w, z)); /* tongs */
    float spread = l->bend * l->grip;
    dmg_vec path[] = {{0, 0, 0}, {-0.35f * l->grip, side * 0.5f * spread, 0}, {-l->grip, side * spread, 0}};
    dmg_sweep(b, path, 3, 0.35f * w, 0.5f * z, false);
    if (l->loop) {
        float r = 0.16f * l->grip;
        dmg_torus(b, v3(-l->grip - 0.7f * r, side * (spread + 0.3f * r), 0), v3(0, 0, 1), r, 0.2f * r);
    }
}

static void draw_crossed(dmg_builder* b, const lever* l, const char* name, float closed_by, float open) {
    dmg_move(b, 0, l->thick, 0);
    dmg_face_up(b);
    draw_lever(b, l, 1.0f);
    dmg_rod(b, v3(0, 0, -0.7f * l->thick), v3(0, 0, 1.8f * l->thick), 0.3f * l->width);
    dmg_save(b);
    dmg_move(b, 0, 0, 1.05f * l->thick);
    /* Jaws open when the moving one's jaw goes to +y, right-handed about z. */
    uint32_t part = dmg_hinge(b, 0, name, v3(0, 0, 0), v3(0, 0, 1), -closed_by, open);
    draw_lever(b, l, -1.0f);
    dmg_restore(b);
    dmg_rest(b, part, dmg_chance(b, 0.6f) ? dmg_range(b, 0, open) : 0.0f);
    dmg_use(b, 0);
}

void dmg_build_scissors(dmg_builder* b) {
    lever l = {.jaw = dmg_range(b, 0.05f, 0.14f), .kind = 0, .loop = 1};
    l.grip = l.jaw * dmg_range(b, 0.5f, 1.2f);
    l.width = l.jaw * dmg_range(b, 0.1f, 0.22f);
    l.thick = l.width * dmg_range(b, 0.12f, 0.3f);
    l.bend = dmg_range(b, 0.15f, 0.35f);
    l.loop = dmg_chance(b, 0.9f);
    draw_crossed(b, &l, "blade", 0.0f, dmg_range(b, 0.6f, 1.6f));
}

void dmg_build_pliers(dmg_builder* b) {
    lever l = {.jaw = dmg_range(b, 0.03f, 0.08f), .kind = dmg_chance(b, 0.75f) ? 1 : 2};
    l.grip = l.jaw * dmg_range(b, 1.5f, 3.5f);
    l.width = l.jaw * dmg_range(b, 0.2f, 0.4f);
    l.thick = l.width * dmg_range(b, 0.4f, 0.9f);
    l.bend = dmg_range(b, 0.1f, 0.3f);
    draw_crossed(b, &l, "jaw", 0.0f, dmg_range(b, 0.4f, 1.0f));
}

/* ---- lighter ---- */

void dmg_build_lighter(dmg_builder* b) {
    float width = dmg_range(b, 0.02f, 0.04f), height = width * dmg_range(b, 1.2f, 1.8f),
          depth = width * dmg_range(b, 0.25f, 0.5f), lid = height * dmg_range(b, 0.4f, 0.7f), wall = 0.05f * width;
    bool rounded = dmg_chance(b, 0.5f), caps = dmg_chance(b, 0.7f);
    dmg_vec centre = {0, 0.5f * height, 0}, size = {width, height, depth};
    if (rounded)
        dmg_rounded_box(b, centre, size, 0.3f * depth);
    else
        dmg_box(b, centre, size);
    dmg_save(b);
    dmg_move(b, 0, height, 0);
    dmg_box(b, v3(-0.1f * width, 0.2f * lid, 0), v3(0.5f * width, 0.4f * lid, 0.6f * depth));
    dmg_spin(b, 0, "flint_wheel", v3(-0.1f * width, 0.4f * lid, 0), v3(0, 0, 1));
    dmg_save(b);
    dmg_move(b, -0.1f * width, 0.4f * lid, 0);
    dmg_wheel_draw(b, dmg_chance(b, 0.5f) ? 4 : 0, 0.15f * width, 0.5f * depth, 6);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, 0, "gas_button", v3(0, -1, 0), 0.0f, 0.12f * lid);
        dmg_box(b, v3(0.3f * width, 0.2f * lid, 0), v3(0.3f * width, 0.35f * lid, 0.7f * depth));
    }
    if (caps) {
        float side = dmg_sign(b), far = dmg_range(b, 1.8f, 2.8f), out = dmg_range(b, -0.5f, 1.0f) * wall;
        uint32_t cap = dmg_hinge(b, 0, "lid", v3(side * (0.5f * width + out), dmg_range(b, 0, 0.1f) * lid, 0),
                                 v3(0, 0, -side), 0.0f, far);
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_case_draw(b, DMG_CASE_BOARDS, width, depth, lid, wall);
        dmg_restore(b);
        if (dmg_chance(b, 0.5f)) dmg_rest(b, cap, dmg_range(b, 0.8f, 1.0f) * far);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- book ---- */

void dmg_build_book(dmg_builder* b) {
    float width = dmg_range(b, 0.1f, 0.3f), height = width * dmg_range(b, 1.0f, 1.6f),
          pages = width * dmg_range(b, 0.05f, 0.4f), t = width * dmg_range(b, 0.008f, 0.03f);
    bool binder = dmg_chance(b, 0.2f), back_opens = dmg_chance(b, 0.3f);
    if (dmg_chance(b, 0.5f)) { /* standing */
        dmg_move(b, 0, 0.5f * height, 0);
    } else {
        dmg_move(b, 0, 0.5f * pages + t, 0);
        dmg_face_up(b);
    }
    dmg_box(b, v3(0.48f * t, 0, 0), v3(width - t, 0.97f * height, binder ? 0.4f * pages : pages));
    if (dmg_chance(b, 0.8f)) dmg_box(b, v3(-0.5f * width, 0, 0), v3(t, height, pages));
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * 0.5f * pages;
        if (s < 0 && !back_opens)
            dmg_use(b, 0);
        else {
            float far = dmg_range(b, 1.6f, 3.0f);
            uint32_t cover = dmg_hinge(b, 0, s > 0 ? "cover" : "back_cover",
                                       v3(-0.5f * width + dmg_range(b, -1, 1) * t, 0, z + (float)s * 0.5f * t),
                                       v3(0, -(float)s, 0), 0.0f, far);
            if (dmg_chance(b, 0.4f)) dmg_rest(b, cover, dmg_range(b, 0, far));
        }
        dmg_box(b, v3(0.02f * width, 0, z + (float)s * 0.5f * t), v3(1.04f * width, height, t));
    }
    dmg_use(b, 0);
}
