/* Implements free-form shells: bent bodies of changing section with openings that keys fill flush, hoops; and the
 * small parts that stand square to such a surface, their pivots hidden below it. */
#include "core/lofts.h"

#include "parts/hardware.h"
#include "parts/thumbs.h"

enum { ROW_LIMIT = 40, COLUMN_LIMIT = 32 };

/* ---- the shell's surface ---- */

dmg_bent dmg_bent_between(dmg_vec from, dmg_vec to, dmg_vec bow, dmg_vec side, float wide, float deep) {
    dmg_bent n = {.side = side, .power = 2, .rows = 20, .columns = 20};
    n.control[0] = from;
    n.control[1] = v3_add(v3_lerp(from, to, 0.33f), bow);
    n.control[2] = v3_add(v3_lerp(from, to, 0.67f), bow);
    n.control[3] = to;
    for (int i = 0; i < 3; ++i) {
        n.wide[i] = wide;
        n.deep[i] = deep;
    }
    n.round[0] = n.round[1] = 0.2f;
    return n;
}

dmg_vec dmg_bent_middle(const dmg_bent* n, float s) {
    float r = 1 - s;
    dmg_vec p = v3_scale(n->control[0], r * r * r);
    p = v3_mad(p, n->control[1], 3 * r * r * s);
    p = v3_mad(p, n->control[2], 3 * r * s * s);
    return v3_mad(p, n->control[3], s * s * s);
}

static float between(const float* at, float s) {
    float value = at[0] * (1 - s) * (1 - 2 * s) + at[1] * 4 * s * (1 - s) + at[2] * s * (2 * s - 1);
    return fmaxf(value, 0.3f * fminf(at[0], fminf(at[1], at[2])));
}

/* How much of the section is left near a rounded end. */
static float rounding(const dmg_bent* n, float s) {
    float left = 1;
    for (int end = 0; end < 2; ++end) {
        float from_end = end ? 1 - s : s;
        if (n->round[end] <= 0 || from_end >= n->round[end]) continue;
        float off = 1 - from_end / n->round[end];
        left *= sqrtf(fmaxf(0.004f, 1 - off * off));
    }
    return left;
}

static float squared(float value, float power) {
    return copysignf(powf(fabsf(value), 2 / power), value);
}

static dmg_vec skin(const dmg_bent* n, float s, float angle) {
    const float step = 0.01f;
    s = fminf(1, fmaxf(0, s));
    dmg_vec line = v3_normalize(v3_sub(dmg_bent_middle(n, fminf(1, s + step)), dmg_bent_middle(n, fmaxf(0, s - step))));
    dmg_vec side = v3_normalize(v3_mad(n->side, line, -v3_dot(n->side, line)));
    side = v3_turn(side, line, n->twist * s);
    dmg_vec front = v3_cross(side, line);
    float left = rounding(n, s), c = cosf(angle), d = sinf(angle);
    float x = left * between(n->wide, s) * squared(c, n->power) * (1 - n->egg * d),
          z = left * between(n->deep, s) * squared(d, n->power);
    return v3_mad(v3_mad(dmg_bent_middle(n, s), side, x), front, z);
}

static dmg_vec along_line(const dmg_bent* n, float s, float angle) {
    const float step = 0.01f;
    return v3_normalize(v3_sub(skin(n, s + step, angle), skin(n, s - step, angle)));
}

static dmg_vec outward(const dmg_bent* n, float s, float angle) {
    const float step = 0.04f;
    dmg_vec round = v3_sub(skin(n, s, angle + step), skin(n, s, angle - step));
    return v3_normalize(v3_cross(along_line(n, s, angle), round));
}

dmg_vec dmg_bent_point(const dmg_bent* n, float s, float angle, float out) {
    dmg_vec at = skin(n, s, angle);
    return out == 0 ? at : v3_mad(at, outward(n, s, angle), out);
}

void dmg_aim(dmg_builder* b, dmg_vec at, dmg_vec out, dmg_vec up) {
    dmg_frame to = {.origin = at};
    to.column[2] = v3_normalize(out);
    to.column[0] = v3_normalize(v3_cross(up, to.column[2]));
    to.column[1] = v3_cross(to.column[2], to.column[0]);
    dmg_save(b);
    b->frames[b->frame_depth] = dmg_frame_multiply(&b->frames[b->frame_depth], &to);
}

void dmg_bent_stand(dmg_builder* b, const dmg_bent* n, float s, float angle, float out) {
    dmg_aim(b, dmg_bent_point(n, s, angle, out), outward(n, s, angle), along_line(n, s, angle));
}

/* ---- openings ---- */

/* Rows are closer at the ends, which are round. */
static float row_share(const dmg_bent* n, int row) {
    float u = (float)row / (float)(n->rows - 1);
    return u - 0.1f * sinf(2 * DMG_PI * u);
}

static float column_angle(const dmg_bent* n, int column) {
    return 2 * DMG_PI * (float)column / (float)n->columns;
}

static int nearest_row(const dmg_bent* n, float s) {
    int best = 1;
    for (int r = 1; r < n->rows - 1; ++r)
        if (fabsf(row_share(n, r) - s) < fabsf(row_share(n, best) - s)) best = r;
    return best;
}

dmg_window dmg_bent_open(dmg_bent* n, float s, float angle, float length, float arc, float depth) {
    float each = 2 * DMG_PI / (float)n->columns;
    dmg_window w = {.depth = depth};
    w.row0 = nearest_row(n, s - 0.5f * length);
    w.row1 = nearest_row(n, s + 0.5f * length);
    if (w.row1 < w.row0 + 2) w.row1 = w.row0 + 2;
    if (w.row1 > n->rows - 2) {
        w.row1 = n->rows - 2;
        if (w.row0 > w.row1 - 2) w.row0 = w.row1 - 2;
    }
    w.column0 = (int)lrintf((angle - 0.5f * arc) / each);
    w.column1 = (int)lrintf((angle + 0.5f * arc) / each);
    if (w.column1 < w.column0 + 2) w.column1 = w.column0 + 2;
    if (n->window_count < DMG_WINDOW_LIMIT) n->windows[n->window_count++] = w;
    return w;
}

static bool is_open(const dmg_bent* n, int row, int column) {
    for (int i = 0; i < n->window_count; ++i) {
        const dmg_window* w = &n->windows[i];
        int from = (column - w->column0) % n->columns;
        if (from < 0) from += n->columns;
        if (row >= w->row0 && row < w->row1 && from < w->column1 - w->column0) return true;
    }
    return false;
}

/* Walls from the opening's edge down, and a floor. */
static void draw_well(dmg_builder* b, const dmg_bent* n, const dmg_window* w) {
    int rows = w->row1 - w->row0, columns = w->column1 - w->column0, around = 2 * (rows + columns), count = 0;
    dmg_vec wall[4 * (ROW_LIMIT + COLUMN_LIMIT)], ground[ROW_LIMIT * COLUMN_LIMIT];
    for (int level = 0; level < 2; ++level) {
        for (int i = 0; i < around; ++i) { /* round against the angle, from the last row's end */
            int r = rows, c = columns - i;
            if (i >= columns) r = rows - (i - columns), c = 0;
            if (i >= columns + rows) r = 0, c = i - columns - rows;
            if (i >= 2 * columns + rows) r = i - 2 * columns - rows, c = columns;
            wall[count++] =
                dmg_bent_point(n, row_share(n, w->row0 + r), column_angle(n, w->column0 + c), level ? -w->depth : 0.0f);
        }
    }
    dmg_rows_draw(b, wall, 2, around, DMG_ROWS_ROUND);
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c)
            ground[r * (columns + 1) + c] =
                dmg_bent_point(n, row_share(n, w->row0 + r), column_angle(n, w->column0 + c), -w->depth);
    dmg_rows_draw(b, ground, rows + 1, columns + 1, 0);
}

void dmg_bent_draw(dmg_builder* b, const dmg_bent* n) {
    if (n->rows > ROW_LIMIT || n->columns > COLUMN_LIMIT) {
        b->failed = true;
        return;
    }
    const uint32_t width = (uint32_t)n->columns, first = b->vertex_count;
    dmg_piece_begin(b);
    for (int r = 0; r < n->rows; ++r)
        for (int c = 0; c < n->columns; ++c) dmg_vertex(b, skin(n, row_share(n, r), column_angle(n, c)));
    for (int r = 0; r + 1 < n->rows; ++r) {
        for (uint32_t c = 0; c < width; ++c) {
            if (is_open(n, r, (int)c)) continue;
            uint32_t here = first + (uint32_t)r * width, next = (c + 1) % width;
            dmg_quad(b, here + c, here + width + c, here + width + next, here + next);
        }
    }
    uint32_t last = first + (uint32_t)(n->rows - 1) * width;
    for (uint32_t c = 1; c + 1 < width; ++c) {
        dmg_triangle(b, first, first + c, first + c + 1);
        dmg_triangle(b, last, last + c + 1, last + c);
    }
    for (int i = 0; i < n->window_count; ++i) draw_well(b, n, &n->windows[i]);
}

/* ---- what fills an opening ---- */

typedef struct fill {
    float rise, thick, power, gap;
} fill;

/* A pad as the shell is curved: its foot, its rim, then inwards over its back. */
static void draw_fill(dmg_builder* b, const dmg_bent* n, const dmg_window* w, const fill* f) {
    enum { AROUND = 20, RINGS = 6 };
    const float shrink[RINGS] = {1, 1, 0.9f, 0.65f, 0.35f, 0.05f};
    const float lift[RINGS] = {-1, 0, 0.6f, 0.9f, 1, 1};
    float s0 = row_share(n, w->row0), s1 = row_share(n, w->row1), a0 = column_angle(n, w->column0),
          a1 = column_angle(n, w->column1);
    dmg_vec at[RINGS * AROUND];
    for (int r = 0; r < RINGS; ++r) {
        for (int i = 0; i < AROUND; ++i) {
            float angle = -2 * DMG_PI * (float)i / AROUND, share = 0.5f * f->gap * shrink[r];
            float s = 0.5f * (s0 + s1) + (s1 - s0) * share * squared(cosf(angle), f->power),
                  a = 0.5f * (a0 + a1) + (a1 - a0) * share * squared(sinf(angle), f->power);
            at[r * AROUND + i] = dmg_bent_point(n, s, a, lift[r] < 0 ? -f->thick : f->rise * lift[r]);
        }
    }
    dmg_rows_draw(b, at, RINGS, AROUND, DMG_ROWS_TUBE);
}

void dmg_bent_key_draw(dmg_builder* b, const dmg_bent* n, const dmg_window* w, uint32_t parent, const char* name,
                       dmg_key_motion motion) {
    float rise = w->depth * dmg_range(b, 0.0f, 0.5f), pin = w->depth * dmg_range(b, -0.1f, 0.9f),
          share = dmg_range(b, 0.4f, 0.85f), off = dmg_range(b, -0.08f, 0.25f);
    fill f = {.rise = rise, .thick = w->depth * dmg_range(b, 0.2f, 0.5f)};
    f.power = dmg_scale_range(b, 2.5f, 9.0f);
    f.gap = dmg_range(b, 0.9f, 0.97f);
    float s0 = row_share(n, w->row0), s1 = row_share(n, w->row1), s = 0.5f * (s0 + s1),
          a = 0.5f * (column_angle(n, w->column0) + column_angle(n, w->column1)), room = share * (w->depth - f.thick);
    if (motion == DMG_KEY_FIRST) s = s0 + off * (s1 - s0);
    if (motion == DMG_KEY_LAST) s = s1 - off * (s1 - s0);
    float long_way = v3_length(v3_sub(skin(n, s1, a), skin(n, s0, a))),
          short_way =
              v3_length(v3_sub(skin(n, s, column_angle(n, w->column0)), skin(n, s, column_angle(n, w->column1))));
    dmg_bent_stand(b, n, s, a, 0);
    dmg_vec at = v3(0, 0, -pin);
    if (motion == DMG_KEY_PRESS) dmg_slide(b, parent, name, v3(0, 0, -1), 0.0f, room);
    if (motion == DMG_KEY_FIRST) dmg_hinge(b, parent, name, at, v3(-1, 0, 0), 0.0f, fminf(0.5f, room / long_way));
    if (motion == DMG_KEY_LAST) dmg_hinge(b, parent, name, at, v3(1, 0, 0), 0.0f, fminf(0.5f, room / long_way));
    float rock = fminf(0.35f, 1.6f * room / long_way), aside = fminf(0.35f, 1.6f * room / short_way);
    if (motion == DMG_KEY_ROCK) dmg_hinge(b, parent, name, at, v3(1, 0, 0), -rock, rock);
    if (motion == DMG_KEY_ROCK_ASIDE) dmg_hinge(b, parent, name, at, v3(0, 1, 0), -aside, aside);
    dmg_restore(b);
    draw_fill(b, n, w, &f);
    dmg_use(b, parent);
}

void dmg_hoop_draw(dmg_builder* b, float radius_x, float radius_z, float wide, float high, float lean, float swell) {
    enum { ROUND = 36, SECTION = 10 };
    dmg_vec at[(ROUND + 1) * SECTION];
    for (int i = 0; i <= ROUND; ++i) {
        float turn = 2 * DMG_PI * (float)i / ROUND, grow = 1 + swell * sinf(turn);
        dmg_vec out = v3(cosf(turn), 0, sinf(turn)), middle = v3(radius_x * out.x, 0, radius_z * out.z);
        dmg_vec across = v3_add(v3_scale(out, cosf(lean)), v3(0, sinf(lean), 0)),
                up = v3_add(v3_scale(out, -sinf(lean)), v3(0, cosf(lean), 0));
        for (int k = 0; k < SECTION; ++k) {
            float angle = -2 * DMG_PI * (float)k / SECTION;
            dmg_vec p = v3_mad(middle, across, wide * grow * cosf(angle));
            at[i * SECTION + k] = v3_mad(p, up, high * grow * sinf(angle));
        }
    }
    dmg_rows_draw(b, at, ROUND + 1, SECTION, DMG_ROWS_ROUND);
}

/* ---- what stands out of a surface ---- */

uint32_t dmg_finger_lever_draw(dmg_builder* b, uint32_t parent, const char* name, float wide, float length) {
    float hook = length * dmg_range(b, -0.05f, 0.45f), dip = length * dmg_range(b, 0.0f, 0.3f),
          pull = dmg_range(b, 0.12f, 0.5f), tip = dmg_range(b, 0.5f, 1.1f), inside = length * dmg_range(b, 0.15f, 0.4f),
          thick = length * dmg_range(b, 0.07f, 0.16f), pin_y = length * dmg_range(b, -0.1f, 0.25f),
          pin_z = length * dmg_range(b, -0.5f, 0.0f);
    dmg_bent n = dmg_bent_between(v3(0, 0.12f * length, -inside), v3(0, -length, hook), v3(0, 0, 0), v3(-1, 0, 0),
                                  0.5f * wide, thick);
    n.control[1] = v3(0, 0.05f * length, 0.25f * length);
    n.control[2] = v3(0, -0.6f * length, -dip);
    n.wide[2] = 0.5f * wide * tip;
    n.deep[0] = 1.5f * thick;
    n.deep[2] = 0.7f * thick;
    n.power = dmg_range(b, 2.0f, 5.0f);
    n.rows = 14;
    n.columns = 12;
    uint32_t lever = dmg_hinge(b, parent, name, v3(0, pin_y, pin_z), v3(1, 0, 0), 0.0f, pull);
    dmg_bent_draw(b, &n);
    dmg_use(b, parent);
    return lever;
}

void dmg_bat_draw(dmg_builder* b, uint32_t parent, const char* name, float size) {
    int kind = dmg_int(b, 0, 2);
    float swing = dmg_range(b, 0.2f, 0.5f), pin = size * dmg_range(b, 0.0f, 0.3f),
          long_way = size * dmg_range(b, 0.8f, 1.6f), neck = size * dmg_range(b, 0.35f, 0.6f);
    const dmg_xy collar[] = {{neck, 0}, {neck, 0.15f * size}, {0.7f * neck, 0.22f * size}, {0.4f * neck, 0.1f * size}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), collar, 4);
    uint32_t bat = dmg_hinge(b, parent, name, v3(0, 0, -pin), v3(1, 0, 0), -swing, swing);
    float r = 0.1f * size;
    dmg_vec tip = v3(0, 0, long_way);
    if (kind == 0) dmg_cone(b, v3(0, 0, 0), tip, r, 1.8f * r);
    if (kind == 1) {
        dmg_rod(b, v3(0, 0, 0), tip, r);
        dmg_ellipsoid(b, tip, v3(2 * r, 2 * r, 2 * r));
    }
    if (kind == 2) dmg_box_span(b, v3(-1.8f * r, -0.8f * r, 0), v3(1.8f * r, 0.8f * r, long_way));
    dmg_rest(b, bat, dmg_chance(b, 0.5f) ? -swing : swing);
    dmg_use(b, parent);
}

void dmg_hat_draw(dmg_builder* b, uint32_t parent, const char* name, float size) {
    float swing = dmg_range(b, 0.15f, 0.35f), pin = size * dmg_range(b, 0.1f, 0.8f),
          high = size * dmg_range(b, 0.4f, 0.9f), r = size * dmg_range(b, 0.35f, 0.55f);
    int kind = dmg_int(b, 0, 2);
    bool aside = dmg_chance(b, 0.5f);
    const dmg_xy boot[] = {{0.8f * size, -0.02f * size}, {0.75f * size, 0.08f * size}, {0.45f * size, 0.1f * size}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), boot, 3);
    dmg_hinge(b, parent, name, v3(0, 0, -pin), aside ? v3(0, 1, 0) : v3(1, 0, 0), -swing, swing);
    dmg_cone(b, v3(0, 0, -0.1f * size), v3(0, 0, high), 0.35f * r, 0.5f * r);
    const dmg_xy cap[] = {
        {0, high}, {r, high}, {1.05f * r, high + 0.25f * r}, {0.8f * r, high + 0.45f * r}, {0, high + 0.3f * r}};
    if (kind == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cap, 5);
    if (kind == 1) { /* a castle: four merlons */
        dmg_rod(b, v3(0, 0, high), v3(0, 0, high + 0.3f * r), r);
        for (int i = 0; i < 4; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 0, 1), i, 4);
            dmg_box(b, v3(0.75f * r, 0, high + 0.45f * r), v3(0.35f * r, 0.7f * r, 0.34f * r));
            dmg_restore(b);
        }
    }
    if (kind == 2) dmg_ellipsoid(b, v3(0, 0, high), v3(r, r, 0.5f * r));
    dmg_use(b, parent);
}

void dmg_rock_key_draw(dmg_builder* b, uint32_t parent, const char* name, float wide, float high) {
    float dip = high * dmg_range(b, 0.02f, 0.12f), rise = high * dmg_range(b, 0.08f, 0.25f),
          pin = high * dmg_range(b, -0.05f, 0.3f), swing = dmg_range(b, 0.08f, 0.25f), t = 0.08f * wide,
          w = 0.5f * wide, h = 0.5f * high, deep = 0.3f * high;
    bool framed = dmg_chance(b, 0.6f);
    const dmg_xy profile[] = {{-h, -deep}, {h, -deep}, {h, rise}, {0, rise - dip}, {-h, rise}};
    if (framed) {
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * t);
        dmg_frame_draw(b, wide + 3 * t, high + 3 * t, t, 1.2f * t);
        dmg_restore(b);
    }
    uint32_t key = dmg_hinge(b, parent, name, v3(0, 0, -pin), v3(1, 0, 0), -swing, swing);
    dmg_aim(b, v3(0, 0, 0), v3(1, 0, 0), v3(0, 0, 1));
    dmg_extrude(b, profile, 5, -w, w);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, key, swing);
    dmg_use(b, parent);
}
