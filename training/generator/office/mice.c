/* Draws computer mice: keys on the shell's front, the wheel between them, thumb keys, the battery cover. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

/* Lengths in metres; `a` runs from the rear (0) to the front (1), `s` over the top from the left foot (-1) to the right
 * one (1). */
typedef struct mouse {
    float length, wide, tall; /* wide: half */
    float hump;               /* where it is highest */
    float rear, front;        /* how much of the height is gone at the ends */
    float power, round;       /* of the cross section and of the plan */
    float waist, tilt;        /* narrower in the middle, higher at one side */
    float seam, side, gap;    /* keys begin at this a, end at this s, begin at this s */
    float plate, recess;      /* thickness of what moves, depth of the place where it lies */
    int columns, rows;        /* of a patch */
    bool cover;               /* what is behind the seam comes off too */
} mouse;

enum { SIDE_LIMIT = 24, ROW_LIMIT = 24 };

/* A point of the shell, `deep` inside it. */
static dmg_vec skin(const mouse* m, float a, float s, float deep) {
    float from_end = fabsf(2.0f * a - 1.0f), plan = powf(fmaxf(0.0f, 1.0f - powf(from_end, m->round)), 0.5f);
    float middle = (a - 0.55f) / 0.2f,
          wide = m->wide * (0.45f + 0.55f * plan) * (1.0f - m->waist * expf(-middle * middle));
    float off = a < m->hump ? (m->hump - a) / m->hump : (a - m->hump) / (1.0f - m->hump);
    float tall = m->tall * (1.0f - (a < m->hump ? m->rear : m->front) * off * off) * (1.0f + m->tilt * s);
    float angle = 0.5f * DMG_PI * s, x = powf(fabsf(sinf(angle)), 2.0f / m->power),
          y = powf(fmaxf(0.0f, cosf(angle)), 2.0f / m->power);
    return v3(copysignf(x, s) * (wide - 0.7f * deep), fmaxf(0.0f, y * (tall - deep)), (a - 0.5f) * m->length);
}

static mouse pick_mouse(dmg_builder* b) {
    mouse m = {.length = dmg_scale_range(b, 0.075f, 0.14f)};
    m.wide = m.length * dmg_range(b, 0.22f, 0.38f);
    m.tall = m.length * dmg_range(b, 0.22f, 0.45f);
    m.hump = dmg_range(b, 0.3f, 0.55f);
    m.rear = dmg_range(b, 0.35f, 0.75f);
    m.front = dmg_range(b, 0.15f, 0.7f);
    m.power = dmg_scale_range(b, 2.0f, 6.0f);
    m.round = dmg_scale_range(b, 2.0f, 8.0f);
    m.waist = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, 0.18f);
    m.tilt = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, -0.15f, 0.25f);
    if (dmg_chance(b, 0.2f)) { /* a box of the eighties */
        m.power = dmg_range(b, 6.0f, 12.0f);
        m.round = dmg_range(b, 10.0f, 20.0f);
        m.rear = dmg_range(b, 0.0f, 0.2f);
        m.front = dmg_range(b, 0.0f, 0.3f);
        m.waist = 0.0f;
    }
    m.seam = dmg_range(b, 0.42f, 0.66f);
    m.side = dmg_range(b, 0.55f, 0.85f);
    m.plate = m.length * dmg_range(b, 0.012f, 0.03f);
    m.recess = m.plate + m.length * dmg_range(b, 0.015f, 0.04f);
    m.columns = dmg_int(b, 3, 9);
    m.rows = dmg_int(b, 3, 9);
    m.cover = dmg_chance(b, 0.4f);
    return m;
}

/* Draws a piece of the shell as a plate: its top, its underside and its rim. Rows go to the front, columns to the
 * right. */
static void draw_patch(dmg_builder* b, const mouse* m, float a0, float a1, float s0, float s1) {
    enum { LIMIT = 10 };
    dmg_vec top[LIMIT * LIMIT], under[LIMIT * LIMIT], rim[8 * LIMIT];
    int rows = m->rows, columns = m->columns, count = 0;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            float a = a0 + (a1 - a0) * (float)r / (float)(rows - 1);
            float s = s0 + (s1 - s0) * (float)c / (float)(columns - 1);
            top[r * columns + c] = skin(m, a, s, 0);
            under[r * columns + columns - 1 - c] = skin(m, a, s, m->plate);
        }
    }
    const int around = 2 * (rows + columns - 2);
    for (int i = 0; i < around; ++i, ++count) { /* along the front to the right, and back at the other end */
        int c = i < columns ? i : columns - 1, r = rows - 1;
        if (i >= columns) r = rows - 1 - (i - columns + 1);
        if (i >= columns + rows - 1) {
            r = 0;
            c = columns - 1 - (i - columns - rows + 2);
        }
        if (i >= 2 * columns + rows - 2) {
            c = 0;
            r = i - 2 * columns - rows + 3;
        }
        rim[i] = top[r * columns + c];
        rim[around + i] = under[r * columns + columns - 1 - c];
    }
    dmg_rows_draw(b, top, rows, columns, 0);
    dmg_rows_draw(b, under, rows, columns, 0);
    dmg_rows_draw(b, rim, 2, around, DMG_ROWS_ROUND);
}

/* Draws the shell, one piece, let in where plates lie on it. */
static void draw_shell(dmg_builder* b, const mouse* m) {
    float sides[SIDE_LIMIT], ends[ROW_LIMIT];
    int columns = 0, rows = 0, half = m->columns > 5 ? 4 : 2;
    for (int i = 0; i <= half; ++i) sides[columns++] = -1.0f + (1.0f - m->side - 0.02f) * (float)i / (float)half;
    for (int i = 0; i <= 2 * half; ++i) sides[columns++] = m->side * ((float)i / (float)half - 1.0f);
    for (int i = 0; i <= half; ++i) sides[columns++] = m->side + 0.02f + (0.98f - m->side) * (float)i / (float)half;
    for (int i = 0; i <= half + 1; ++i) ends[rows++] = m->seam * (float)i / (float)(half + 1);
    for (int i = 0; i <= half + 1; ++i)
        ends[rows++] = m->seam + 0.006f + (0.994f - m->seam) * (float)i / (float)(half + 1);
    dmg_vec at[ROW_LIMIT * SIDE_LIMIT];
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            bool let_in = fabsf(sides[c]) <= m->side && (ends[r] > m->seam || (m->cover && ends[r] > 0.01f));
            at[r * columns + c] = skin(m, ends[r], sides[c], let_in ? m->recess : 0.0f);
        }
    }
    dmg_rows_draw(b, at, rows, columns, DMG_ROWS_TUBE);
}

/* ---- what moves on top ---- */

/* Draws two keys, or one over the whole width: they bend about their rear edge or a line behind it, or sink. */
static void draw_keys(dmg_builder* b, const mouse* m, int keys) {
    bool sinks = dmg_chance(b, 0.15f);
    float room = (m->recess - m->plate) * dmg_range(b, 0.5f, 0.9f), reach = (0.985f - m->seam) * m->length;
    float behind = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, 0.0f, 0.25f) * m->length;
    float deep = dmg_chance(b, 0.5f) ? 0.5f * m->plate : m->plate * dmg_range(b, 0.0f, 2.0f);
    dmg_vec line = skin(m, m->seam + 0.012f, 0, deep);
    line.z -= behind;
    static const char* const names[] = {"left_key", "right_key", "key"};
    for (int i = 0; i < keys; ++i) {
        float s0 = keys == 1 ? -m->side : (i == 0 ? -m->side : m->gap), s1 = keys == 2 && i == 0 ? -m->gap : m->side;
        const char* name = names[keys == 1 ? 2 : i];
        if (sinks)
            dmg_slide(b, 0, name, v3(0, -1, 0), 0.0f, room);
        else
            dmg_hinge(b, 0, name, line, v3(1, 0, 0), 0.0f, room / (reach + behind));
        draw_patch(b, m, m->seam + 0.012f, 0.985f, s0, s1);
    }
    dmg_use(b, 0);
}

static void draw_wheel_rim(dmg_builder* b, dmg_vec at, float r, float half) {
    int kind = dmg_int(b, 0, 3);
    dmg_vec left = v3_add(at, v3(-half, 0, 0)), right = v3_add(at, v3(half, 0, 0));
    if (kind == 0) dmg_rod(b, left, right, r);
    if (kind == 1) { /* a tyre between two discs */
        dmg_rod(b, left, right, 0.85f * r);
        dmg_torus(b, at, v3(1, 0, 0), r - 0.6f * half, 0.6f * half);
    }
    if (kind >= 2) { /* grooves round it or across it */
        const dmg_xy profile[] = {{0, -half},       {0.8f * r, -half}, {r, -0.5f * half}, {0.9f * r, 0},
                                  {r, 0.5f * half}, {0.8f * r, half},  {0, half}};
        dmg_lathe(b, at, v3(1, 0, 0), profile, 7);
    }
    const int teeth = kind == 3 ? dmg_int(b, 10, 20) : 0;
    for (int i = 0; i < teeth; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)teeth;
        dmg_vec out = v3(0, cosf(angle), sinf(angle));
        dmg_beam(b, v3_mad(at, out, 0.7f * r), v3_mad(at, out, 1.05f * r), 0.9f * half, 0.15f * r);
    }
}

/* Its wheel, now and then on a cradle that tilts sideways; a key or two behind it. */
static void draw_mouse_wheel(dmg_builder* b, const mouse* m, float half) {
    float a = m->seam + (0.96f - m->seam) * dmg_range(b, 0.35f, 0.7f), r = m->tall * dmg_range(b, 0.2f, 0.36f);
    dmg_vec at = skin(m, a, 0, 0);
    at.y -= r * dmg_range(b, 0.25f, 0.7f);
    uint32_t cradle = 0;
    if (dmg_chance(b, 0.15f)) {
        float tip = dmg_range(b, 0.08f, 0.2f);
        cradle = dmg_hinge(b, 0, "wheel_cradle", v3(0, at.y - 0.7f * r, at.z), v3(0, 0, 1), -tip, tip);
        dmg_box(b, v3(0, at.y, at.z), v3(2.6f * half, 0.3f * r, 0.3f * r));
        dmg_box(b, v3(0, at.y - 0.7f * r, at.z), v3(1.2f * half, 0.4f * r, 2.0f * r));
    }
    dmg_spin(b, cradle, "wheel", at, v3(-1, 0, 0));
    draw_wheel_rim(b, at, r, half);
    int keys = dmg_int(b, 0, 2);
    float z = at.z - r, rest = skin(m, m->seam, 0, 0).z, pitch = (z - rest) / (float)(keys + 1);
    for (int i = 0; i < keys && pitch > 0.03f * m->length; ++i) {
        float place = z - pitch * ((float)i + 0.7f), key = 0.35f * pitch;
        float y = skin(m, place / m->length + 0.5f, 0, 0).y;
        dmg_slide(b, 0, "step_key", v3(0, -1, 0), 0.0f, 0.5f * (m->recess - m->plate));
        dmg_box(b, v3(0, y - 0.5f * m->plate, place), v3(1.6f * half, 1.2f * m->plate, 2.0f * key));
    }
    dmg_use(b, 0);
}

/* Draws the palm's shell over the battery: swings up about its rear or its front edge, slides off, or lifts off. */
static void draw_cover(dmg_builder* b, const mouse* m) {
    int way = dmg_int(b, 0, 3);
    dmg_vec rear = skin(m, 0.02f, 0, m->plate), front = skin(m, m->seam - 0.01f, 0, m->plate);
    if (way == 0) dmg_hinge(b, 0, "cover", rear, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.7f));
    if (way == 1)
        dmg_hinge(b, 0, "cover", v3(0, skin(m, m->seam, 0, 0).y, front.z), v3(1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.7f));
    if (way == 2) dmg_slide(b, 0, "cover", v3_normalize(v3(0, 0.1f, -1)), 0.0f, m->length * dmg_range(b, 0.2f, 0.5f));
    if (way == 3) dmg_slide(b, 0, "cover", v3(0, 1, 0), 0.0f, m->length * dmg_range(b, 0.15f, 0.4f));
    draw_patch(b, m, 0.02f, m->seam - 0.008f, -m->side, m->side);
    dmg_use(b, 0);
}

/* ---- at its sides and below ---- */

/* Draws one to three keys in a row at the thumb's side: they sink, or tip about their rear edge. */
static void draw_thumb_keys(dmg_builder* b, const mouse* m) {
    int count = dmg_int(b, 1, 3);
    float side = dmg_chance(b, 0.8f) ? -1.0f : 1.0f, s = side * fminf(0.97f, m->side + dmg_range(b, 0.05f, 0.1f));
    float begin = dmg_range(b, 0.3f, 0.45f), pitch = dmg_range(b, 0.08f, 0.15f),
          rise = m->length * dmg_range(b, 0.012f, 0.03f);
    float tall = m->tall * dmg_range(b, 0.08f, 0.2f);
    bool tips = dmg_chance(b, 0.3f);
    for (int i = 0; i < count; ++i) {
        dmg_vec from = skin(m, begin + pitch * ((float)i + 0.08f), s, 0),
                to = skin(m, begin + pitch * ((float)i + 0.92f), s, 0);
        dmg_vec along = v3_normalize(v3_sub(to, from)), out = v3_normalize(v3_cross(v3(0, side, 0), along));
        dmg_use(b, 0);
        if (tips)
            dmg_hinge(b, 0, "thumb_key", from, v3(0, -side, 0), 0.0f, 0.8f * rise / v3_length(v3_sub(to, from)));
        else
            dmg_slide(b, 0, "thumb_key", v3_scale(out, -1), 0.0f, rise * dmg_range(b, 0.4f, 0.8f));
        dmg_beam(b, from, to, 2.0f * rise, tall);
    }
    dmg_use(b, 0);
}

/* On its underside y = 0: pads, a hatch for the battery, a switch. */
static void draw_underside(dmg_builder* b, const mouse* m, float foot) {
    float w = 0.5f * m->wide, l = m->length;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-w, -foot, 0.36f * (float)s * l - 0.04f * l),
                     v3(w, 0.1f * foot, 0.36f * (float)s * l + 0.04f * l));
    if (dmg_chance(b, 0.6f)) {
        float half = m->wide * dmg_range(b, 0.2f, 0.5f), z0 = l * dmg_range(b, -0.28f, -0.2f),
              z1 = z0 + l * dmg_range(b, 0.2f, 0.4f);
        bool swings = dmg_chance(b, 0.4f), rear = dmg_chance(b, 0.5f);
        if (swings)
            dmg_hinge(b, 0, "hatch", v3(0, 0, rear ? z0 : z1), v3(rear ? 1.0f : -1.0f, 0, 0), 0.0f,
                      dmg_range(b, 0.8f, 1.5f));
        else
            dmg_slide(b, 0, "hatch", v3(0, 0, rear ? -1.0f : 1.0f), 0.0f, (z1 - z0) * dmg_range(b, 0.3f, 0.9f));
        dmg_box_span(b, v3(-half, -0.7f * foot, z0), v3(half, 0.1f * foot, z1));
        dmg_box(b, v3(0, -0.8f * foot, rear ? z1 - 0.04f * l : z0 + 0.04f * l), v3(half, 0.3f * foot, 0.03f * l));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.5f)) {
        float way = l * dmg_range(b, 0.025f, 0.05f), size = 0.8f * way;
        bool along = dmg_chance(b, 0.5f);
        dmg_slide(b, 0, "switch", along ? v3(0, 0, 1) : v3(1, 0, 0), 0.0f, way);
        dmg_box(b, v3(-0.5f * way, -0.4f * foot, 0.27f * l), v3(size, foot, size));
        dmg_use(b, 0);
    }
}

static void draw_cable(dmg_builder* b, const mouse* m) {
    dmg_vec path[7];
    float y = 0.3f * skin(m, 0.99f, 0, m->recess).y, r = m->length * dmg_range(b, 0.012f, 0.03f),
          bend = dmg_range(b, -0.4f, 0.4f);
    float far = dmg_range(b, 0.3f, 1.2f) * m->length;
    for (int i = 0; i < 7; ++i) {
        float t = (float)i / 6.0f;
        path[i] = v3(bend * t * t * far, y + (r - y) * fminf(1.0f, 2.0f * t), 0.48f * m->length + t * far);
    }
    dmg_sweep(b, path, 7, r, r, false);
    dmg_cone(b, path[0], v3(0, y, 0.56f * m->length), 2.2f * r, 1.2f * r);
}

/* It stands on its edge, as a hand hangs: a wedge carries it. */
static void stand_up(dmg_builder* b, const mouse* m) {
    float lean = dmg_range(b, 0.5f, 1.1f), x = m->wide * cosf(lean), y = m->wide * sinf(lean), z = 0.4f * m->length;
    const dmg_xy wedge[] = {{-0.7f * x, 0}, {0.85f * x, 0}, {0.85f * x, 1.85f * y}, {-0.7f * x, 0.3f * y}};
    dmg_extrude(b, wedge, 4, -z, z);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(0, 0, 1), lean);
}

void dmg_build_computer_mouse(dmg_builder* b) {
    mouse m = pick_mouse(b);
    float foot = m.length * dmg_range(b, 0.012f, 0.03f), half = m.length * dmg_range(b, 0.025f, 0.05f);
    bool upright = dmg_chance(b, 0.15f), wheel = dmg_chance(b, 0.85f);
    float share = 1.25f * half / m.wide;
    m.gap = wheel ? 2.0f / DMG_PI * asinf(powf(share, 0.5f * m.power)) : 0.02f;
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    if (upright)
        stand_up(b, &m);
    else
        dmg_move(b, 0, foot, 0);
    draw_shell(b, &m);
    draw_keys(b, &m, wheel || dmg_chance(b, 0.5f) ? 2 : 1);
    if (wheel) draw_mouse_wheel(b, &m, half);
    if (m.cover) draw_cover(b, &m);
    if (dmg_chance(b, 0.55f)) draw_thumb_keys(b, &m);
    if (!upright) draw_underside(b, &m, foot);
    if (dmg_chance(b, 0.45f)) draw_cable(b, &m);
}
