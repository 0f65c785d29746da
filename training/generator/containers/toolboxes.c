/* Draws lids on arms: tool boxes whose lid sinks behind the box, bins whose lid reaches back to a rod; casements in
 * walls. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- a box whose lid hangs on arms ---- */

typedef struct crate {
    float width, height, depth, wall;
    float up, back;    /* the lid's line: y, z */
    float under, rear; /* of the closed lid: its lower face, its hung end */
    float lid;         /* its thickness */
    float pin;         /* radius */
    float far;
} crate;

/* Draws the line inside the rear wall, near its top: the open lid stands behind the box. */
static void hang_behind(dmg_builder* b, crate* c) {
    float in = c->depth * dmg_range(b, 0.0f, 0.1f), drop = c->height * dmg_range(b, 0.03f, 0.2f);
    c->far = dmg_range(b, 1.5f, 2.0f);
    c->back = in - 0.5f * c->depth;
    c->rear = -0.5f * c->depth - drop;
    float lean = fmaxf(-cosf(c->far), 0.0f), clear = (in + lean * (in + drop)) / sinf(c->far);
    c->under = c->height + 0.002f * c->height;
    c->up = c->under - clear * dmg_range(b, 1.0f, 1.4f) - c->pin;
}

/* Draws the line on a rod behind the rim, which lugs of the lid reach. */
static void hang_on_rod(dmg_builder* b, crate* c) {
    float out = c->depth * dmg_range(b, 0.01f, 0.12f);
    c->far = dmg_range(b, 1.4f, 3.8f);
    c->back = -0.5f * c->depth - out - c->pin;
    c->rear = -0.5f * c->depth - dmg_range(b, 0.0f, 0.8f) * out;
    c->under = c->height + 0.002f * c->height;
    c->up = c->under + c->lid * dmg_range(b, -0.5f, 1.0f);
}

/* Arms from the line to the lid in use, one wide or a few narrow; the pin and what holds it on the body. */
static void draw_lid_arms(dmg_builder* b, const crate* c, uint32_t lid) {
    int count = dmg_int(b, 1, 3), holder = dmg_int(b, c->back < -0.5f * c->depth ? 1 : 0, 2);
    float wide = c->width * (count == 1 ? dmg_range(b, 0.2f, 0.7f) : dmg_range(b, 0.02f, 0.1f)),
          spread = dmg_range(b, 0.3f, 0.45f);
    for (int i = 0; i < count; ++i) {
        float x = count == 1 ? 0.0f : 2.0f * spread * c->width * ((float)i / (float)(count - 1) - 0.5f);
        dmg_use(b, lid);
        dmg_beam(b, v3(x, c->up, c->back), v3(x, c->under + 0.5f * c->lid, c->rear + 0.1f * c->depth), wide,
                 1.6f * c->pin);
        dmg_rod(b, v3(x - 0.5f * wide, c->up, c->back), v3(x + 0.5f * wide, c->up, c->back), 1.3f * c->pin);
        dmg_use(b, 0);
        for (int s = -1; s <= 1 && holder == 1; s += 2) { /* cheeks beside each arm */
            float at = x + (float)s * (0.6f * wide + c->pin);
            dmg_box_span(b, v3(at - 0.5f * c->pin, c->up - 3 * c->pin, c->back - 1.2f * c->pin),
                         v3(at + 0.5f * c->pin, c->up + 1.2f * c->pin, -0.49f * c->depth));
        }
    }
    if (holder == 2) dmg_rod(b, v3(-spread * c->width, c->up, c->back), v3(spread * c->width, c->up, c->back), c->pin);
}

static void draw_crate_body(dmg_builder* b, const crate* c, float taper) {
    const float x = 0.5f * c->width, z = 0.5f * c->depth;
    const dmg_xy outline[] = {{-x, -z}, {x, -z}, {x, z}, {-x, z}};
    const dmg_row rows[] = {{taper, taper, 0, 0}, {1, 1, 0, 0.98f * c->height}};
    dmg_save(b);
    if (dmg_chance(b, 0.5f)) {
        dmg_move(b, 0, c->height, 0);
        dmg_face_up(b);
        dmg_case_draw(b, dmg_case_pick(b), c->width, c->depth, c->height, c->wall);
    } else {
        dmg_face_up(b);
        dmg_loft(b, outline, 4, rows, 2);
    }
    dmg_restore(b);
    int ribs = dmg_int(b, 0, 4);
    for (int i = 0; i < ribs; ++i)
        dmg_box(b, v3(c->width * (((float)i + 0.5f) / (float)ribs - 0.5f), 0.6f * c->height, z),
                v3(0.04f * c->width, 0.5f * c->height, 0.02f * c->depth));
}

/* Draws the lid: a plate, a dished one with a skirt inside, or a shell that rises in the middle. */
static void draw_crate_lid(dmg_builder* b, const crate* c) {
    int kind = dmg_int(b, 0, 3);
    float over = dmg_range(b, 0.0f, 0.04f) * c->depth, length = 0.5f * c->depth + over - c->rear,
          w = c->width + 2 * over;
    dmg_save(b);
    dmg_move(b, 0, c->under, c->rear + 0.5f * length);
    dmg_face_up(b);
    const dmg_xy outline[] = {
        {-0.5f * w, -0.5f * length}, {0.5f * w, -0.5f * length}, {0.5f * w, 0.5f * length}, {-0.5f * w, 0.5f * length}};
    const dmg_row rows[] = {{1, 1, 0, 0}, {1, 1, 0, 0.5f * c->lid}, {0.8f, 0.8f, 0, 2.0f * c->lid}};
    if (kind == 0) dmg_box(b, v3(0, 0, 0.5f * c->lid), v3(w, length, c->lid));
    if (kind == 1) dmg_rounded_box(b, v3(0, 0, 0.5f * c->lid), v3(w, length, c->lid), 0.45f * c->lid);
    if (kind == 2) dmg_loft(b, outline, 4, rows, 3);
    if (kind == 3) dmg_box_faces(b, v3(0, 0, c->lid), v3(w, length, 2 * c->lid), DMG_FACE_ALL & ~DMG_FACE_BACK);
    if (dmg_chance(b, 0.5f)) { /* what one lifts it by */
        dmg_handle pull = dmg_handle_pick(b, 0.3f * w);
        dmg_move(b, 0, dmg_chance(b, 0.5f) ? 0.0f : -0.4f * length,
                 kind == 2   ? 2.0f * c->lid
                 : kind == 3 ? 2 * c->lid
                             : c->lid);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle_draw(b, &pull, 0.6f * w);
    }
    dmg_restore(b);
}

/* On an axle behind the foot, which a taper makes shorter than the rim. */
static void draw_crate_wheels(dmg_builder* b, const crate* c, float taper) {
    float radius = c->depth * dmg_range(b, 0.1f, 0.2f), back = -0.5f * taper * c->depth;
    dmg_rod(b, v3(-0.48f * c->width, radius, back), v3(0.48f * c->width, radius, back), 0.2f * radius);
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * 0.48f * c->width, radius, back);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, 0, radius, 0.4f * radius, 5);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_toolbox(dmg_builder* b) {
    crate c = {.width = dmg_scale_range(b, 0.2f, 0.8f)};
    bool bin = dmg_chance(b, 0.4f);
    c.depth = c.width * dmg_range(b, 0.5f, 1.2f);
    c.height = c.width * (bin ? dmg_range(b, 0.8f, 2.0f) : dmg_range(b, 0.3f, 0.9f));
    c.wall = c.width * dmg_range(b, 0.01f, 0.05f);
    c.lid = c.width * dmg_scale_range(b, 0.015f, 0.12f);
    c.pin = c.width * dmg_scale_range(b, 0.008f, 0.03f);
    if (bin || dmg_chance(b, 0.3f))
        hang_on_rod(b, &c);
    else
        hang_behind(b, &c);
    float taper = bin && dmg_chance(b, 0.7f) ? dmg_range(b, 0.7f, 0.95f) : 1.0f;
    draw_crate_body(b, &c, taper);
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, c.up, c.back), v3(-1, 0, 0), 0.0f, c.far);
    draw_crate_lid(b, &c);
    draw_lid_arms(b, &c, lid);
    if (dmg_chance(b, 0.45f)) dmg_rest(b, lid, fminf(dmg_range(b, 0.3f, 1.9f), c.far));
    dmg_use(b, 0);
    if (bin && dmg_chance(b, 0.7f)) draw_crate_wheels(b, &c, taper);
}

/* ---- a casement in a wall ---- */

/* Draws a sash of bars round panes, its hung edge at x = 0, its middle plane z = 0: one pane, panes side by side, or
 * louvres. */
static void draw_wall_sash(dmg_builder* b, float width, float height, float t) {
    float bar = fminf(width, height) * dmg_range(b, 0.04f, 0.14f), pane = t * dmg_range(b, 0.05f, 0.4f);
    int columns = dmg_int(b, 1, 3), rows = dmg_int(b, 1, 3);
    dmg_save(b);
    dmg_move(b, 0.5f * width, 0, 0.5f * t);
    dmg_frame_draw(b, width, height, t, bar);
    dmg_restore(b);
    if (dmg_chance(b, 0.8f)) dmg_box(b, v3(0.5f * width, 0, 0), v3(width - 1.8f * bar, height - 1.8f * bar, pane));
    for (int i = 1; i < columns; ++i)
        dmg_box(b, v3(width * (float)i / (float)columns, 0, 0), v3(0.5f * bar, height - 2 * bar, 0.7f * t));
    for (int i = 1; i < rows; ++i)
        dmg_box(b, v3(0.5f * width, height * ((float)i / (float)rows - 0.5f), 0),
                v3(width - 2 * bar, 0.5f * bar, 0.7f * t));
}

/* A wall or a frame with an opening, and one or two sashes hung in it: on the sash's edge, in its frame's corner or on
 * pins a little inside; open or closed, outwards or inwards. */
void dmg_build_casement(dmg_builder* b) {
    float height = dmg_range(b, 0.4f, 1.8f), width = height * dmg_scale_range(b, 0.35f, 1.2f),
          t = fminf(width, height) * dmg_scale_range(b, 0.02f, 0.12f);
    float gap = dmg_chance(b, 0.5f) ? 0.001f : width * dmg_range(b, 0.0f, 0.03f),
          wall = t * dmg_scale_range(b, 0.8f, 4.0f), border = dmg_scale_range(b, 0.06f, 0.8f) * height;
    int sashes = dmg_int(b, 1, 2);
    bool top_hung = dmg_chance(b, 0.2f);
    float opening = (float)sashes * width + 2 * gap,
          in = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, 1.0f) * (wall - t),
          pinned = dmg_chance(b, 0.4f) ? dmg_range(b, 0.0f, 1.0f) * t : 0.0f;
    static const float through[] = {0.5f, 0.5f, 0.0f, -0.5f};
    float line = through[dmg_int(b, 0, 3)] * t, far = dmg_range(b, 0.7f, 2.0f),
          rest = dmg_chance(b, 0.5f) ? dmg_range(b, 0.2f, 1.0f) * far : 0.0f;
    dmg_move(b, 0, 0.5f * height + border, 0.5f * wall);
    dmg_frame_draw(b, opening + 2 * border, height + 2 * gap + 2 * border, wall, border);
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, -0.5f * height - gap - 0.1f * t, 0), v3(1.1f * opening, t, wall + 2 * t));
    if (top_hung) dmg_turn(b, v3(0, 0, 1), -0.5f * DMG_PI);
    if (top_hung && sashes == 2) sashes = 1;
    float w = top_hung ? height : width, h = top_hung ? opening - 2 * gap : height;
    for (int i = 0; i < sashes; ++i) {
        dmg_save(b);
        if (i == 1 || (sashes == 1 && !top_hung && dmg_chance(b, 0.5f))) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, -0.5f * (sashes == 2 ? 2 * w : w), 0, -0.5f * t - fmaxf(in, 0.0f));
        uint32_t sash = dmg_hinge(b, 0, "window", v3(pinned, 0, line), v3(0, -1, 0), 0.0f, far);
        draw_wall_sash(b, w, h, t);
        if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0.96f * w, 0, 0.7f * t), v3(0.03f * w, 0.12f * h, t));
        dmg_rest(b, sash, i == 0 || dmg_chance(b, 0.7f) ? rest : 0.0f);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}
