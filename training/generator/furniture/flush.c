/* Draws cabinets of flush fronts, pulled by an edge or without a handle: boxes, rails, hinges and gaps distinguish
 * drawers from doors. */
#include "core/build.h"
#include "parts/hardware.h"

/* What an edge is pulled by. */
enum { PULL_NONE, PULL_BEVEL, PULL_HOOK, PULL_NOTCH, PULL_HOLE, PULL_CHANNEL, PULL_CORNER, PULL_KINDS };

typedef struct flush {
    float depth, wall, t, gap;
    float grip;  /* how far from its edge a front is shaped to be pulled */
    float least; /* no cell is narrower */
    float open;  /* chance of a front to stand open */
    int pull, hinge, rail, fake;
    bool inset, boards;
    dmg_tray_kind tray;
    dmg_hinge_style knuckle;
    dmg_handle handle;
} flush;

/* ---- fronts ---- */

/* Draws a section in x and z carried along y: what bevels and hooks are. */
static void extrude_section(dmg_builder* b, const dmg_xy* section, int count, float height) {
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    dmg_extrude(b, section, count, -0.5f * height, 0.5f * height);
    dmg_restore(b);
}

static void draw_notched(dmg_builder* b, const flush* k, float w, float h, float at) {
    float x = 0.5f * w, y = 0.5f * h, half = fminf(0.2f * h, 1.5f * k->grip), centre = at * (h - 2.2f * half);
    const dmg_xy outline[] = {{-x, -y},
                              {x, -y},
                              {x, centre - half},
                              {x - k->grip, centre - 0.75f * half},
                              {x - k->grip, centre + 0.75f * half},
                              {x, centre + half},
                              {x, y},
                              {-x, y}};
    dmg_extrude(b, outline, 8, -k->t, 0);
}

/* Front at z = 0, pulled at its edge towards +X. */
static void draw_plate(dmg_builder* b, const flush* k, float w, float h) {
    float x = 0.5f * w, t = k->t, g = fminf(k->grip, 0.3f * w);
    const dmg_xy bevel[] = {{-x, -t}, {x - fminf(g, 1.5f * t), -t}, {x, 0}, {-x, 0}};
    const dmg_xy hook[] = {{-x, -t}, {x - g, -t}, {x, 0.5f * g - t}, {x, 0.5f * g}, {x - g, 0}, {-x, 0}};
    const dmg_xy corner[] = {{-x, -0.5f * h}, {x, -0.5f * h}, {x, 0.5f * h - g}, {x - g, 0.5f * h}, {-x, 0.5f * h}};
    switch (k->pull) {
    case PULL_BEVEL:
        extrude_section(b, bevel, 4, h);
        break;
    case PULL_HOOK:
        extrude_section(b, hook, 6, h);
        break;
    case PULL_NOTCH:
        draw_notched(b, k, w, h, 0.0f);
        break;
    case PULL_HOLE:
        dmg_box_span(b, v3(-x, -0.5f * h, -t), v3(x - 2 * g, 0.5f * h, 0));
        dmg_save(b);
        dmg_move(b, x - g, 0, 0);
        dmg_holed_plate_draw(b, 2 * g, h, t, 0.6f * g);
        dmg_restore(b);
        break;
    case PULL_CHANNEL: /* shorter: fingers reach behind it */
        dmg_box_span(b, v3(-x, -0.5f * h, -t), v3(x - g, 0.5f * h, 0));
        break;
    case PULL_CORNER:
        dmg_extrude(b, corner, 5, -t, 0);
        break;
    default:
        dmg_box(b, v3(0, 0, -0.5f * t), v3(w, h, t));
        break;
    }
    dmg_handle_draw(b, &k->handle, 0.6f * h);
}

/* Fields that make one front look like several drawers or doors. */
static void draw_fake_seams(dmg_builder* b, const flush* k, float w, float h) {
    if (k->fake == 0 || !dmg_chance(b, 0.5f)) return;
    int count = dmg_int(b, 2, 4);
    bool across = w > h;
    for (int i = 0; i < count; ++i) {
        float at = ((float)i + 0.5f) / (float)count - 0.5f;
        dmg_box(b, v3(across ? at * w : 0, across ? 0 : at * h, 0.1f * k->t),
                v3(across ? 0.92f * w / (float)count : 0.94f * w, across ? 0.9f * h : 0.92f * h / (float)count,
                   0.2f * k->t));
    }
}

/* The opening of a cell as its front fills it; z is where the front's face is. */
typedef struct place {
    float w, h, z, in_w, in_h;
} place;

static place place_of(const flush* k, float w, float h) {
    float rim = k->inset ? k->wall : 0.0f;
    place p = {w - rim - 2 * k->gap, h - rim - 2 * k->gap, k->inset ? 0.0f : 1.05f * k->t, w - k->wall, h - k->wall};
    return p;
}

/* ---- drawers ---- */

/* Rails on the cell's walls and on the box's sides, or one below its middle. */
static void draw_rails(dmg_builder* b, const flush* k, const place* p, uint32_t part, float deep, float box) {
    float r = fminf(0.25f * (p->in_w - box), 0.5f * k->wall), high = fminf(0.12f * p->h, 3 * r);
    if (k->rail == 0) return;
    float y = k->rail == 2 ? -0.46f * p->h : -0.2f * p->h;
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_use(b, 0);
        dmg_box(b, v3(side * (0.5f * p->in_w - 0.5f * r), y, -0.5f * k->depth), v3(r, high, 0.9f * k->depth));
        dmg_use(b, part);
        dmg_box(b, v3(side * (0.5f * box + 0.5f * r), y, -k->t - 0.5f * deep), v3(r, 0.6f * high, 0.95f * deep));
    }
}

/* Draws what stands in the box: partitions along or across, or hanging files. */
static void draw_partitions(dmg_builder* b, float w, float h, float deep, float wall) {
    int kind = dmg_int(b, 0, 4), count = dmg_int(b, 1, 4);
    for (int i = 1; i <= count; ++i) {
        float at = (float)i / (float)(count + 1);
        if (kind == 0)
            dmg_box(b, v3((at - 0.5f) * w, 0.35f * h, -0.5f * deep), v3(0.6f * wall, 0.6f * h, 0.95f * deep));
        if (kind == 1) dmg_box(b, v3(0, 0.35f * h, -at * deep), v3(0.95f * w, 0.6f * h, 0.6f * wall));
        if (kind == 2) dmg_box(b, v3(0, 0.55f * h, -at * deep), v3(0.9f * w, 0.8f * h, 0.25f * wall));
    }
}

static void draw_drawer_box(dmg_builder* b, const flush* k, const place* p, uint32_t part, float deep) {
    float box = p->in_w - k->wall * dmg_range(b, 0.6f, 2.0f), share = dmg_range(b, 0.35f, 0.88f),
          wall = fminf(0.6f * k->wall, 0.1f * p->h);
    if (k->tray == DMG_TRAY_NONE) return;
    dmg_save(b);
    dmg_move(b, 0, -0.47f * p->in_h, -k->t);
    dmg_tray_draw(b, k->tray, box, share * p->in_h, deep, wall);
    if (k->tray != DMG_TRAY_SOLID) draw_partitions(b, box, share * p->in_h, deep, wall);
    dmg_restore(b);
    draw_rails(b, k, p, part, deep, box);
}

static void draw_flush_drawer(dmg_builder* b, const flush* k, float w, float h) {
    place p = place_of(k, w, h);
    float inner = k->depth - k->wall - k->t, deep = inner * dmg_range(b, 0.55f, 0.97f),
          travel = deep * dmg_range(b, 0.6f, 0.97f);
    bool below = dmg_chance(b, 0.15f);
    dmg_save(b);
    dmg_move(b, 0, 0, p.z);
    uint32_t part = dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, travel);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), (below ? -0.5f : 0.5f) * DMG_PI);
    draw_plate(b, k, p.h, p.w);
    dmg_restore(b);
    draw_fake_seams(b, k, p.w, p.h);
    draw_drawer_box(b, k, &p, part, deep);
    if (dmg_chance(b, 0.06f)) {
        dmg_vec at = {0.4f * p.w, 0.2f * p.h, 0};
        float r = fminf(0.12f * p.h, 0.8f * k->t);
        dmg_hinge(b, part, "lock", at, v3(0, 0, -1), 0.0f, 0.5f * DMG_PI);
        dmg_move(b, at.x, at.y, 0);
        dmg_knob_draw(b, 2, r, r);
    }
    dmg_restore(b);
    if (dmg_chance(b, k->open)) dmg_rest(b, part, travel * dmg_range(b, 0.1f, 1.0f));
    dmg_use(b, 0);
}

/* Tall as a door, but a rack is fixed to it and comes along. */
static void draw_pull_out(dmg_builder* b, const flush* k, float w, float h) {
    place p = place_of(k, w, h);
    float deep = (k->depth - k->wall - k->t) * dmg_range(b, 0.7f, 0.97f), travel = deep * dmg_range(b, 0.7f, 0.98f),
          rack = p.in_w - k->wall * dmg_range(b, 0.5f, 1.5f), thin = 0.5f * k->wall;
    int shelves = dmg_int(b, 2, 5), style = dmg_int(b, 0, 2);
    bool top = dmg_chance(b, 0.4f);
    dmg_save(b);
    dmg_move(b, 0, 0, p.z);
    uint32_t part = dmg_slide(b, 0, "pull_out", v3(0, 0, 1), 0.0f, travel);
    dmg_save(b);
    if (top) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    draw_plate(b, k, top ? p.h : p.w, top ? p.w : p.h);
    dmg_restore(b);
    draw_fake_seams(b, k, p.w, p.h);
    for (int i = 0; i < shelves; ++i) {
        dmg_save(b);
        dmg_move(b, 0, 0.94f * p.in_h * ((float)i / (float)shelves - 0.49f), -k->t);
        dmg_tray_draw(b, style == 0 ? DMG_TRAY_WIRE : DMG_TRAY_BOARDS, rack, 0.2f * p.in_h / (float)shelves, deep,
                      thin);
        dmg_restore(b);
    }
    if (style != 2) dmg_box(b, v3(0, 0, -k->t - deep + 0.5f * thin), v3(rack, 0.94f * p.in_h, thin));
    if (style == 2) dmg_box(b, v3(0, 0, -k->t - 0.5f * deep), v3(thin, 0.94f * p.in_h, deep));
    dmg_restore(b);
    if (dmg_chance(b, k->open)) dmg_rest(b, part, travel * dmg_range(b, 0.1f, 1.0f));
    dmg_use(b, 0);
}

/* ---- doors ---- */

/* Cups let into the leaf's back with arms to the wall; the hung edge is at x = 0, the face at z = 0. */
static void draw_cups(dmg_builder* b, const flush* k, float h, uint32_t leaf) {
    float r = 0.7f * k->t, arm = fminf(5 * k->t, 0.3f * k->depth);
    int count = h > 20 * k->t ? 3 : 2;
    for (int i = 0; i < count; ++i) {
        float y = 0.76f * h * ((float)i / (float)(count - 1) - 0.5f);
        dmg_use(b, leaf);
        dmg_rod(b, v3(1.6f * r + k->gap, y, -1.25f * k->t), v3(1.6f * r + k->gap, y, -0.8f * k->t), r);
        dmg_use(b, 0);
        dmg_box_span(b, v3(0.05f * r, y - 0.5f * r, -k->t - arm), v3(0.5f * r, y + 0.5f * r, -1.3f * k->t));
    }
    dmg_use(b, leaf);
}

/* Small trays on the back of a door; far enough from its free edge to come out past the wall there. */
static void draw_door_bins(dmg_builder* b, const flush* k, float w, float h) {
    int count = dmg_int(b, 1, 3);
    float deep = fminf(0.2f * w, 0.4f * k->depth);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, 0, h * (((float)i + 0.3f) / (float)count - 0.5f), -k->t);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.75f * w, 0.15f * h / (float)count, deep, 0.3f * k->t);
        dmg_restore(b);
    }
}

/* Draws the line's place: across from the hung edge, behind the face. */
static dmg_vec pick_line(dmg_builder* b, const flush* k) {
    static const float through[] = {0.0f, 0.5f, 1.0f};
    float in = dmg_range(b, 0.3f, 2.0f);
    if (k->hinge == 2) return v3(-k->gap, 0, 0); /* knuckles before the seam */
    if (k->hinge == 3) return v3(in * k->t, 0, -0.5f * k->t);
    return v3(0, 0, -k->t * through[k->inset ? 0 : dmg_int(b, 0, 2)]);
}

/* Draws a leaf hung at its side towards -X before a cell w x h. */
static uint32_t draw_flush_leaf(dmg_builder* b, const flush* k, const char* name, const place* p, float w, float h) {
    float far = dmg_range(b, 1.4f, 2.0f), x = -0.5f * w;
    dmg_vec line = pick_line(b, k);
    uint32_t part = dmg_hinge(b, 0, name, v3(x + line.x, 0, p->z + line.z), v3(0, -1, 0), 0.0f, far);
    dmg_save(b);
    dmg_move(b, 0, 0, p->z);
    draw_plate(b, k, w, h);
    draw_fake_seams(b, k, w, h);
    if (w < 1.3f * h && w > 0.4f * k->depth && dmg_chance(b, 0.25f)) draw_door_bins(b, k, w, h);
    dmg_move(b, x, 0, 0);
    if (k->hinge == 1) draw_cups(b, k, h, part);
    if (k->hinge == 2 || k->hinge == 3) {
        dmg_hinge_style style = k->knuckle;
        if (k->hinge == 3) style.kind = DMG_HINGE_PIVOT;
        dmg_move(b, line.x, 0, line.z);
        dmg_hinge_draw(b, &style, h, w, part, 0);
    }
    dmg_restore(b);
    if (dmg_chance(b, k->open)) dmg_rest(b, part, far * dmg_range(b, 0.1f, 1.0f));
    dmg_use(b, 0);
    return part;
}

/* Shelves behind doors, or a tray that slides out when they are open. */
static void draw_inside(dmg_builder* b, const flush* k, float w, float h) {
    int shelves = dmg_int(b, 0, 3);
    float wall = k->wall, clear = k->t + 0.25f * k->depth;
    for (int i = 1; i <= shelves; ++i) {
        dmg_save(b);
        dmg_move(b, 0, h * ((float)i / (float)(shelves + 1) - 0.5f), -clear);
        if (dmg_chance(b, 0.25f)) {
            dmg_slide(b, 0, "inner_tray", v3(0, 0, 1), 0.0f, 0.6f * k->depth);
            dmg_tray_draw(b, DMG_TRAY_BOARDS, w - 2.2f * wall, 0.3f * h / (float)(shelves + 1),
                          0.95f * (k->depth - wall - clear), 0.4f * wall);
            dmg_use(b, 0);
        } else {
            dmg_box_span(b, v3(-0.5f * w + 0.5f * wall, 0, wall + clear - k->depth),
                         v3(0.5f * w - 0.5f * wall, 0.7f * wall, 0));
        }
        dmg_restore(b);
    }
}

static void draw_flush_door(dmg_builder* b, const flush* k, float w, float h, bool right) {
    place p = place_of(k, w, h);
    dmg_save(b);
    if (right) dmg_mirror(b, v3(1, 0, 0));
    draw_flush_leaf(b, k, "door", &p, p.w, p.h);
    dmg_restore(b);
}

static void draw_twin_doors(dmg_builder* b, const flush* k, float w, float h) {
    place p = place_of(k, w, h);
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        if (s > 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, -0.25f * p.w, 0, 0);
        draw_flush_leaf(b, k, "door", &p, 0.5f * p.w - 0.5f * k->gap, p.h);
        dmg_restore(b);
    }
}

/* Hung above or below: the frame is turned so that the hung side lies towards -X. */
static void draw_flush_flap(dmg_builder* b, const flush* k, float w, float h, bool up) {
    place p = place_of(k, w, h);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), (up ? -0.5f : 0.5f) * DMG_PI);
    draw_flush_leaf(b, k, "flap", &p, p.h, p.w);
    dmg_restore(b);
}

/* Draws two leaves on tracks behind each other, on strips above and below them. */
static void draw_sliders(dmg_builder* b, const flush* k, float w, float h) {
    place p = place_of(k, w, h);
    float leaf = 0.52f * p.w, strip = fminf(0.04f * h, k->t), first = dmg_sign(b), z = k->inset ? 0 : 2.2f * k->t;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-0.5f * p.w, (float)s * 0.5f * p.h - 0.5f * strip, z - 2.2f * k->t),
                     v3(0.5f * p.w, (float)s * 0.5f * p.h + 0.5f * strip, z + 0.1f * k->t));
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, face = z - (side == first ? 0.0f : 1.1f * k->t), travel = 0.88f * (p.w - leaf);
        dmg_save(b);
        if (s > 0) dmg_mirror(b, v3(1, 0, 0));
        uint32_t part = dmg_slide(b, 0, "sliding_door", v3(1, 0, 0), 0.0f, travel);
        dmg_move(b, 0.5f * (leaf - p.w), 0, face);
        dmg_mirror(b, v3(1, 0, 0)); /* pulled at its outer edge */
        draw_plate(b, k, leaf, p.h - 1.1f * strip);
        dmg_restore(b);
        if (dmg_chance(b, 0.5f * k->open)) dmg_rest(b, part, travel * dmg_range(b, 0.2f, 1.0f));
        dmg_use(b, 0);
    }
}

/* ---- cells ---- */

static void fill_cell(dmg_builder* b, const flush* k, float w, float h) {
    enum { DRAWER, PULL_OUT, DOOR, TWINS, DOWN, UP, SLIDERS, OPEN };
    static const float flat[] = {7, 0, 0.5f, 0.6f, 1, 0.8f, 0.5f, 0.3f}, tall[] = {0.8f, 2.5f, 5, 0.6f, 0, 0, 0, 0.3f},
                       even[] = {3, 0.7f, 3, 1, 0.8f, 0.6f, 0.4f, 0.3f};
    int kind = dmg_weighted(b, w > 1.4f * h ? flat : (h > 1.6f * w ? tall : even), 8);
    bool right = dmg_chance(b, 0.5f);
    if (kind >= DOOR && k->boards) draw_inside(b, k, w, h);
    if (kind == DRAWER) draw_flush_drawer(b, k, w, h);
    if (kind == PULL_OUT) draw_pull_out(b, k, w, h);
    if (kind == DOOR) draw_flush_door(b, k, w, h, right);
    if (kind == TWINS) draw_twin_doors(b, k, w, h);
    if (kind == DOWN || kind == UP) draw_flush_flap(b, k, w, h, kind == UP);
    if (kind == SLIDERS) draw_sliders(b, k, w, h);
}

/* Cuts a field into unequal ones, across its longer side, and those again; boards stand in the cuts. */
static void divide(dmg_builder* b, const flush* k, float w, float h, int level) {
    bool wide = w > h * dmg_range(b, 0.7f, 1.6f);
    float span = wide ? w : h, share[6], sum = 0.0f, at = -0.5f, grade = dmg_range(b, 0.6f, 1.2f);
    int most = (int)(span / k->least), count = dmg_int(b, 2, level > 1 ? 4 : 6), style = dmg_int(b, 0, 2);
    if (count > most) count = most;
    if (level == 0 || count < 2 || dmg_chance(b, 0.12f)) {
        fill_cell(b, k, w, h);
        return;
    }
    for (int i = 0; i < count; ++i) {
        share[i] = style == 0 ? 1.0f : (style == 1 ? powf(grade, (float)i) : dmg_range(b, 0.6f, 1.8f));
        sum += share[i];
    }
    bool boards = k->boards && (k->inset || dmg_chance(b, 0.7f));
    for (int i = 0; i < count; ++i) {
        float part = share[i] / sum, middle = at + 0.5f * part;
        dmg_save(b);
        dmg_move(b, wide ? middle * w : 0, wide ? 0 : middle * h, 0);
        divide(b, k, wide ? part * w : w, wide ? h : part * h, level - 1);
        dmg_restore(b);
        at += part;
        if (i + 1 == count || !boards) continue;
        dmg_box(b, v3(wide ? at * w : 0, wide ? 0 : at * h, -0.5f * k->depth),
                v3(wide ? k->wall : w - k->wall, wide ? h - k->wall : k->wall, 0.98f * k->depth));
    }
}

/* ---- the cabinet ---- */

static flush pick_flush(dmg_builder* b, float small, float large, float depth) {
    static const float trays[] = {0.5f, 5, 2, 0.4f, 0.8f}, pulls[] = {4, 2, 2, 1.5f, 1, 2, 0.7f};
    flush k = {.depth = depth};
    k.wall = small * dmg_range(b, 0.015f, 0.05f);
    k.t = small * dmg_scale_range(b, 0.012f, 0.06f);
    k.gap = fminf(k.t, k.wall) * dmg_range(b, 0.05f, 0.35f);
    k.pull = dmg_weighted(b, pulls, PULL_KINDS);
    k.grip = small * dmg_range(b, 0.025f, 0.06f);
    k.least = large * dmg_range(b, 0.09f, 0.25f);
    k.open = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.1f, 0.6f);
    k.hinge = dmg_int(b, 0, 3);
    k.rail = dmg_int(b, 0, 2);
    k.fake = dmg_chance(b, 0.2f);
    k.inset = dmg_chance(b, 0.45f);
    k.boards = dmg_chance(b, 0.8f);
    k.tray = (dmg_tray_kind)dmg_weighted(b, trays, 5);
    k.knuckle = dmg_hinge_pick(b, 0.4f * k.t);
    if (k.knuckle.kind == DMG_HINGE_NONE) k.knuckle.kind = DMG_HINGE_BARREL;
    if (dmg_chance(b, 0.25f)) { /* a pull in the middle of everything, which tells nothing */
        k.handle = dmg_handle_pick(b, 0.15f * small);
        if (k.handle.kind == DMG_HANDLE_LIP) k.handle.kind = DMG_HANDLE_KNOB;
    }
    return k;
}

/* Draws a shallow well with a lid on the top, as on tool chests; the frame is at the top's middle. */
static void draw_lidded_well(dmg_builder* b, const flush* k, float w) {
    float high = w * dmg_range(b, 0.06f, 0.2f), d = k->depth, t = k->t, far = dmg_range(b, 1.2f, 1.7f);
    dmg_save(b);
    dmg_move(b, 0, high, 0);
    dmg_face_up(b);
    dmg_case_draw(b, DMG_CASE_BOARDS, w, d, high, k->wall);
    dmg_restore(b);
    bool below = dmg_chance(b, 0.5f);
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, high + (below ? 0.0f : t), -0.5f * d), v3(-1, 0, 0), 0.0f, far);
    dmg_box_span(b, v3(-0.5f * w, high + 0.03f * t, -0.5f * d), v3(0.5f * w, high + t, 0.5f * d));
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.5f * w, high - 0.3f * high, 0.5f * d), v3(0.5f * w, high + t, 0.5f * d + t));
    if (dmg_chance(b, 0.3f)) dmg_rest(b, lid, far * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, 0);
}

static void draw_castors(dmg_builder* b, float w, float d, float r) {
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.42f : -0.42f) * w, z = (i & 2 ? 0.4f : -0.4f) * d;
        dmg_use(b, 0);
        dmg_box_span(b, v3(x - 0.5f * r, 1.5f * r, z - 0.6f * r), v3(x + 0.5f * r, 2.3f * r, z + 0.6f * r));
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(x + (float)s * 0.5f * r - 0.06f * r, 0.7f * r, z - 0.3f * r),
                         v3(x + (float)s * 0.5f * r + 0.06f * r, 1.6f * r, z + 0.3f * r));
        dmg_spin(b, 0, "wheel", v3(x, r, z), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.38f * r, r, z), v3(x + 0.38f * r, r, z), r);
    }
    dmg_use(b, 0);
}

void dmg_build_flush_cabinet(dmg_builder* b) {
    float w = dmg_scale_range(b, 0.3f, 2.2f), h = dmg_scale_range(b, 0.4f, 2.2f), small = fminf(w, h),
          d = fminf(fmaxf(small * dmg_range(b, 0.4f, 1.1f), 0.2f * h), 0.8f), foot = small * dmg_range(b, 0.0f, 0.14f);
    flush k = pick_flush(b, small, fmaxf(w, h), d);
    bool rolls = dmg_chance(b, 0.2f);
    if (rolls) {
        draw_castors(b, w, d, 0.035f * small);
        foot = 2.3f * 0.035f * small;
    } else {
        dmg_feet_draw(b, dmg_int(b, 0, DMG_FEET_KINDS - 1), w, d, foot);
    }
    dmg_save(b);
    dmg_move(b, 0, foot + 0.5f * h, 0.5f * d);
    dmg_case_draw(b, k.boards ? DMG_CASE_BOARDS : dmg_case_pick(b), w, h, d, k.wall);
    divide(b, &k, w, h, dmg_int(b, 1, 3));
    if (b->part_count == 0) draw_flush_drawer(b, &k, w, h); /* all cells were open ones */
    dmg_restore(b);
    dmg_move(b, 0, foot + h, 0);
    if (dmg_chance(b, 0.15f))
        draw_lidded_well(b, &k, w);
    else if (dmg_chance(b, 0.4f)) /* a top that stands over */
        dmg_box_span(b, v3(-0.51f * w, 0, -0.5f * d), v3(0.51f * w, 1.2f * k.wall, 0.5f * d + 1.5f * k.t));
}
