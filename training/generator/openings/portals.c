/* Draws doors of stations and starships: leaves that part along straight, slanted or toothed seams, slide into
 * corners, fold out as petals, turn or slide as the blades of an iris, run one behind another. They stand in the x,
 * y plane; +Z is towards the player. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- outlines: convex ones about the origin, counter-clockwise ---- */

enum { OUTLINE_POINTS = 24, MOST_SECTORS = 8 };

typedef struct outline {
    dmg_xy at[OUTLINE_POINTS];
    int count;
} outline;

static outline grow_outline(const outline* o, float x, float y) {
    outline grown = *o;
    for (int i = 0; i < o->count; ++i) grown.at[i] = (dmg_xy){x * o->at[i].x, y * o->at[i].y};
    return grown;
}

static dmg_xy middle_of(const outline* o) {
    dmg_xy sum = {0, 0};
    for (int i = 0; i < o->count; ++i) {
        sum.x += o->at[i].x / (float)o->count;
        sum.y += o->at[i].y / (float)o->count;
    }
    return sum;
}

/* Keeps what lies behind the line: n . p <= d. */
static void cut_outline(outline* o, float nx, float ny, float d) {
    outline kept = {.count = 0};
    for (int i = 0; i < o->count; ++i) {
        dmg_xy p = o->at[i], q = o->at[(i + 1) % o->count];
        float a = nx * p.x + ny * p.y - d, c = nx * q.x + ny * q.y - d;
        if (a <= 0 && kept.count < OUTLINE_POINTS) kept.at[kept.count++] = p;
        if ((a < 0) == (c < 0) || kept.count >= OUTLINE_POINTS) continue;
        float share = a / (a - c);
        kept.at[kept.count++] = (dmg_xy){p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
    }
    *o = kept;
}

static void extrude_outline(dmg_builder* b, const outline* o, float low, float high) {
    if (o->count >= 3) dmg_extrude(b, o->at, o->count, low, high);
}

static outline round_outline(float x, float y, float power, int count) {
    outline o = {.count = count};
    for (int i = 0; i < count; ++i) {
        float angle = 2.0f * DMG_PI * ((float)i + 0.5f) / (float)count, c = cosf(angle), s = sinf(angle);
        float reach = powf(powf(fabsf(c), power) + powf(fabsf(s), power), -1.0f / power);
        o.at[i] = (dmg_xy){x * reach * c, y * reach * s};
    }
    return o;
}

/* ---- the portal ---- */

typedef struct portal {
    outline hole;
    float x, y;       /* half sizes of the opening */
    float wall, leaf; /* thickness of a wall's plate, of a leaf */
    float gap;        /* between them */
    float over;       /* how much larger the leaves are than the opening */
    float reach;      /* half sizes of the wall, in those of the opening */
    bool front, back; /* plates before and behind the leaves */
} portal;

/* A rectangle, one with cut corners, a hexagon, a circle, a soft rectangle, a trapezoid. */
static outline pick_hole(dmg_builder* b, float x, float y) {
    float cut = dmg_range(b, 0.15f, 0.6f) * fminf(x, y), waist = dmg_range(b, 0.6f, 0.9f),
          power = dmg_range(b, 3.0f, 6.0f);
    const outline shapes[] = {
        {{{x, y}, {-x, y}, {-x, -y}, {x, -y}}, 4},
        {{{x, y - cut},
          {x - cut, y},
          {cut - x, y},
          {-x, y - cut},
          {-x, cut - y},
          {cut - x, -y},
          {x - cut, -y},
          {x, cut - y}},
         8},
        {{{x, 0}, {waist * x, y}, {-waist * x, y}, {-x, 0}, {-waist * x, -y}, {waist * x, -y}}, 6},
        {{{waist * x, y}, {-waist * x, y}, {-x, -y}, {x, -y}}, 4},
        {{{x, y - cut}, {x - cut, y}, {cut - x, y}, {-x, y - cut}, {-x, -y}, {x, -y}}, 6},
    };
    int kind = dmg_weighted(b, (const float[]){4, 3, 2, 1, 2, 2, 2}, 7);
    if (kind == 5) return round_outline(x, y, power, 20);
    if (kind == 6) return round_outline(x, y, 2.0f, 20);
    return shapes[kind];
}

static portal pick_portal(dmg_builder* b) {
    portal p = {.y = dmg_scale_range(b, 0.15f, 3.0f)};
    p.x = p.y * dmg_range(b, 0.4f, 1.5f);
    p.hole = pick_hole(b, p.x, p.y);
    float size = fminf(p.x, p.y);
    p.wall = size * dmg_range(b, 0.03f, 0.15f);
    p.leaf = size * dmg_range(b, 0.03f, 0.2f);
    p.gap = size * dmg_range(b, 0.01f, 0.06f);
    p.over = dmg_range(b, 1.01f, 1.08f);
    p.reach = dmg_chance(b, 0.35f) ? dmg_range(b, 1.15f, 1.35f) : dmg_range(b, 1.9f, 2.3f);
    int plates = dmg_weighted(b, (const float[]){3, 2, 1.5f}, 3);
    p.front = plates != 2;
    p.back = plates != 1;
    return p;
}

/* Draws a plate with the opening in it, its outside the opening's own shape grown or made square. */
static void draw_plate(dmg_builder* b, const portal* p, float low, float high, bool square) {
    outline outer = grow_outline(&p->hole, p->reach, p->reach);
    for (int i = 0; i < outer.count && square; ++i) {
        float far = fmaxf(fabsf(outer.at[i].x) / p->x, fabsf(outer.at[i].y) / p->y);
        outer.at[i].x *= p->reach / far;
        outer.at[i].y *= p->reach / far;
    }
    dmg_ring_plate(b, outer.at, p->hole.at, outer.count, low, high);
}

/* The leaves lie about z = 0. */
static void draw_wall(dmg_builder* b, const portal* p) {
    float z = 0.5f * p->leaf + p->gap, rim = p->wall;
    bool square = dmg_chance(b, 0.6f), lips = dmg_chance(b, 0.5f);
    if (p->front) draw_plate(b, p, z, z + p->wall, square);
    if (p->back) draw_plate(b, p, -z - p->wall, -z, square);
    outline lip = grow_outline(&p->hole, 1.12f, 1.12f);
    if (p->front && lips) dmg_ring_plate(b, lip.at, p->hole.at, lip.count, z + p->wall, z + p->wall + 0.5f * rim);
    float x = p->reach * p->x, y = p->reach * p->y, deep = z + p->wall;
    if (p->reach < 1.4f || !square) return;
    for (int s = -1; s <= 1 && dmg_chance(b, 0.8f); s += 2) /* what joins the plates, or carries the one */
        dmg_box(b, v3((float)s * (x + 0.5f * rim), 0, 0), v3(rim, 2 * y, 2 * deep));
    dmg_box(b, v3(0, -y - 0.5f * rim, 0), v3(2 * (x + rim), rim, 2 * deep * dmg_range(b, 1.0f, 1.5f)));
    if (dmg_chance(b, 0.7f)) dmg_box(b, v3(0, y + 0.5f * rim, 0), v3(2 * (x + rim), rim, 2 * deep));
}

/* ---- leaves ---- */

/* Draws a field raised or let through, a band across, or nothing; it stays clear of the wall it runs behind. */
static void draw_leaf(dmg_builder* b, const portal* p, const outline* o, int dress) {
    float half = 0.5f * p->leaf, rise = 0.6f * p->gap;
    dmg_xy middle = middle_of(o);
    outline field = *o;
    for (int i = 0; i < o->count; ++i) {
        field.at[i].x = middle.x + 0.7f * (o->at[i].x - middle.x);
        field.at[i].y = middle.y + 0.7f * (o->at[i].y - middle.y);
    }
    if (dress == 3) /* a pane within a frame */
        dmg_ring_plate(b, o->at, field.at, o->count, -half, half);
    else
        extrude_outline(b, o, -half, half);
    if (dress == 1) extrude_outline(b, &field, half, half + rise);
    if (dress == 2) extrude_outline(b, &field, -half - rise, half + rise);
    if (dress == 3) extrude_outline(b, &field, -0.3f * half, 0.3f * half);
}

/* Draws a part for every leaf. Across the seam it goes by its own size; `way` need not be across. */
static void slide_leaf(dmg_builder* b, const portal* p, const outline* o, dmg_vec way, float travel, int dress) {
    way = v3_normalize(way);
    dmg_slide(b, 0, "leaf", way, 0.0f, travel);
    draw_leaf(b, p, o, dress);
    dmg_use(b, 0);
}

/* Draws two halves; the seam stands, lies or slants, and they go across it or along x or y all the same. */
static void draw_halves(dmg_builder* b, const portal* p, int dress) {
    float seam = 0.5f * DMG_PI * (float)dmg_int(b, 0, 1), slant = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.2f, 0.7f),
          off = dmg_chance(b, 0.7f) ? 0.0f : dmg_range(b, -0.3f, 0.3f), gap = 0.004f * p->x;
    bool across = dmg_chance(b, 0.35f);
    float nx = cosf(seam + slant), ny = sinf(seam + slant), share = dmg_range(b, 0.75f, 1.0f);
    dmg_vec way = across ? v3(nx, ny, 0) : v3(cosf(seam), sinf(seam), 0);
    float half = seam > 0 ? p->y : p->x;
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        outline o = grow_outline(&p->hole, p->over, p->over);
        cut_outline(&o, side * nx, side * ny, side * off * half - gap);
        /* n . p beyond the seam: the leaf that goes the other way is kept */
        slide_leaf(b, p, &o, v3_scale(way, -side), share * half * (1.0f + side * off), dress);
    }
}

/* Teeth along the seam: two leaves of a rectangle that mesh. */
static void draw_meshing(dmg_builder* b, const portal* p) {
    enum { TEETH = 9 };
    dmg_xy seam[TEETH];
    int count = 2 * dmg_int(b, 1, 4) + 1;
    float depth = p->x * dmg_range(b, 0.08f, 0.3f), x = p->over * p->x, y = p->over * p->y, gap = 0.004f * p->x;
    bool steps = dmg_chance(b, 0.5f), upright = dmg_chance(b, 0.6f);
    float share = dmg_range(b, 0.75f, 0.95f);
    for (int i = 0; i < count; ++i) {
        bool out = steps ? (i + 1) / 2 % 2 : i % 2;
        float at = steps ? (float)(2 * (i / 2) + (i % 2 ? 1 : 0)) : (float)i;
        seam[i] = (dmg_xy){out ? depth : -depth, y * (2.0f * at / (float)(count - 1) - 1.0f)};
    }
    dmg_save(b);
    if (!upright) { /* one above the other: the same, lying, as wide as the opening is high */
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        for (int i = 0; i < count; ++i) seam[i] = (dmg_xy){seam[i].x * p->y / p->x, seam[i].y * p->x / p->y};
        x = p->over * p->y;
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_xy leaf[TEETH + 2];
        float side = (float)s;
        for (int i = 0; i < count; ++i)
            leaf[i] = (dmg_xy){seam[s > 0 ? count - 1 - i : i].x + side * gap, seam[s > 0 ? count - 1 - i : i].y};
        leaf[count] = (dmg_xy){side * x, leaf[count - 1].y};
        leaf[count + 1] = (dmg_xy){side * x, leaf[0].y};
        dmg_slide(b, 0, "leaf", v3(side, 0, 0), 0.0f, share * x);
        dmg_extrude(b, leaf, count + 2, -0.5f * p->leaf, 0.5f * p->leaf);
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* The part of an outline between two directions from the origin less than half a turn apart. */
static outline sector_of(const portal* p, float from, float to, float gap) {
    outline o = grow_outline(&p->hole, p->over, p->over);
    cut_outline(&o, sinf(from), -cosf(from), -gap);
    cut_outline(&o, -sinf(to), cosf(to), -gap);
    return o;
}

static float span_of(const outline* o, dmg_vec way) {
    float least = 1e9f, most = -1e9f;
    for (int i = 0; i < o->count; ++i) {
        float at = way.x * o->at[i].x + way.y * o->at[i].y;
        least = fminf(least, at);
        most = fmaxf(most, at);
    }
    return most - least;
}

/* Draws three or four leaves that draw back from the middle, into the corners or along x and y in turn. */
static void draw_sectors(dmg_builder* b, const portal* p, int dress) {
    int count = dmg_int(b, 3, 4);
    float start = dmg_chance(b, 0.5f) ? 0.0f : DMG_PI / (float)count, gap = 0.004f * p->x,
          share = dmg_range(b, 0.6f, 0.95f);
    for (int i = 0; i < count; ++i) {
        float step = 2.0f * DMG_PI / (float)count, from = start + step * (float)i;
        outline o = sector_of(p, from, from + step, gap);
        dmg_vec way = {cosf(from + 0.5f * step), sinf(from + 0.5f * step), 0};
        slide_leaf(b, p, &o, way, share * span_of(&o, way), dress);
    }
}

/* Draws the blades of an iris that each slide along their neighbour's edge. */
static void draw_sliding_iris(dmg_builder* b, const portal* p, int dress) {
    int count = dmg_int(b, 5, MOST_SECTORS);
    float share = dmg_range(b, 0.5f, 0.8f), step = 2.0f * DMG_PI / (float)count, hand = dmg_sign(b);
    for (int i = 0; i < count; ++i) {
        float from = step * (float)i, edge = hand > 0 ? from : from + step;
        outline o = sector_of(p, from, from + step, 0.002f * p->x);
        dmg_vec way = {cosf(edge), sinf(edge), 0};
        slide_leaf(b, p, &o, way, share * fminf(p->x, p->y), dress);
    }
}

/* Blades that turn about pins in the rim, each on its own level. */
static void draw_turning_iris(dmg_builder* b, const portal* p) {
    enum { STEPS = 5 };
    int count = dmg_int(b, 5, MOST_SECTORS);
    float r = fmaxf(p->x, p->y) * p->over, step = 2.0f * DMG_PI / (float)count, hand = dmg_sign(b),
          swing = dmg_range(b, 0.7f, 1.0f), curl = dmg_range(b, 0.3f, 1.0f), t = p->leaf / (float)count,
          share = dmg_chance(b, 0.3f) ? 1.0f : 0.96f;
    dmg_save(b);
    if (hand < 0) dmg_mirror(b, v3(1, 0, 0));
    for (int i = 0; i < count; ++i) {
        float level = dmg_chance(b, 0.5f) ? 0.0f : ((float)i + 0.5f) * t - 0.5f * p->leaf;
        dmg_xy blade[2 * STEPS + 2];
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, count);
        for (int k = 0; k <= STEPS; ++k) { /* out along one curled edge, back along the next */
            float s = (float)k / STEPS, out = curl * s * (1.0f - s), back = 1.0f - s;
            float in = curl * back * (1.0f - back), far = share * step;
            blade[k] = (dmg_xy){r * s * cosf(out), r * s * sinf(out)};
            blade[STEPS + 1 + k] = (dmg_xy){r * back * cosf(in + far), r * back * sinf(in + far)};
        }
        dmg_hinge(b, 0, "blade", v3(1.03f * r, 0, 0), v3(0, 0, -1), 0.0f, swing);
        dmg_extrude(b, blade, 2 * STEPS + 1, level - 0.45f * t, level + 0.45f * t);
        dmg_rod(b, v3(1.03f * r, 0, -0.5f * p->leaf), v3(1.03f * r, 0, 0.5f * p->leaf), 0.05f * r);
        dmg_use(b, 0);
        dmg_restore(b);
    }
    dmg_restore(b);
}

/* Petals hung on the sides of a polygon, opening towards the player. */
static void draw_petals(dmg_builder* b, portal* p) {
    int count = dmg_int(b, 3, MOST_SECTORS);
    float r = p->y, inner = r * cosf(DMG_PI / (float)count), swing = dmg_range(b, 1.0f, 2.2f), t = p->leaf,
          tip = dmg_chance(b, 0.3f) ? dmg_range(b, 0.15f, 0.35f) : 0.01f, line = dmg_range(b, 0.0f, 0.5f) * t;
    int dress = dmg_int(b, 0, 2);
    p->x = r;
    p->hole = round_outline(r, r, 2.0f, count);
    p->front = false;
    p->back = true;
    p->reach = fminf(p->reach, dmg_range(b, 1.1f, 1.5f));
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, count);
        float wide = inner * tanf(DMG_PI / (float)count);
        outline o = {{{tip * inner, -tip * wide},
                      {0.98f * inner, -0.97f * wide},
                      {0.98f * inner, 0.97f * wide},
                      {tip * inner, tip * wide}},
                     4};
        dmg_hinge(b, 0, "petal", v3(1.02f * inner, 0, line), v3(0, 1, 0), 0.0f, swing);
        draw_leaf(b, p, &o, dress);
        dmg_rod(b, v3(1.02f * inner, -0.5f * wide, line), v3(1.02f * inner, 0.5f * wide, line), 0.3f * t);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* Leaves that run one behind another to one side, each drawn along by the next. */
static void draw_telescope(dmg_builder* b, const portal* p, int dress) {
    int count = dmg_int(b, 2, 3), way = dmg_int(b, 0, 3);
    float angle = 0.5f * DMG_PI * (float)way, x = way % 2 ? p->y : p->x, y = way % 2 ? p->x : p->y;
    float step = 2.0f * x / (float)count, t = p->leaf / (float)count;
    portal thin = *p;
    thin.leaf = 0.8f * t;
    thin.gap = 0.1f * t;
    uint32_t parent = 0;
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), angle);
    for (int i = 0; i < count; ++i) { /* the first goes least and carries the others */
        float right = x - step * (float)i, left = right - 1.03f * step;
        outline o = {{{right, y * p->over}, {left, y * p->over}, {left, -y * p->over}, {right, -y * p->over}}, 4};
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * p->leaf - ((float)i + 0.5f) * t);
        parent = dmg_slide(b, parent, "leaf", v3(1, 0, 0), 0.0f, 0.96f * step);
        draw_leaf(b, &thin, &o, dress);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    dmg_restore(b);
}

static void draw_single(dmg_builder* b, const portal* p, int dress) {
    outline o = grow_outline(&p->hole, p->over, p->over);
    int kind = dmg_int(b, 0, 2);
    float share = dmg_range(b, 0.8f, 1.0f), side = dmg_sign(b);
    if (kind == 0) slide_leaf(b, p, &o, v3(side, 0, 0), 2 * share * p->x, dress);
    if (kind == 1) slide_leaf(b, p, &o, v3(0, 1, 0), 2 * share * p->y, dress);
    if (kind < 2) return;
    /* Swings aside in its own plane about a pin in the wall. */
    dmg_vec pin = {side * 1.12f * p->x, dmg_range(b, -0.8f, 0.8f) * p->y, 0};
    dmg_hinge(b, 0, "leaf", pin, v3(0, 0, side), 0.0f, dmg_range(b, 1.2f, 2.0f));
    draw_leaf(b, p, &o, dress);
    dmg_rod(b, v3_add(pin, v3(0, 0, -0.6f * p->leaf)), v3_add(pin, v3(0, 0, 0.5f * p->leaf)), 0.1f * p->x);
    dmg_use(b, 0);
}

/* ---- what is beside the door ---- */

/* On z = 0 facing +Z: a plate with a key, a lever, a flap over it or a knob. */
static void draw_console(dmg_builder* b, float size) {
    float t = 0.15f * size, y = size * dmg_range(b, -0.4f, 0.4f);
    int kind = dmg_int(b, 0, 3);
    dmg_box(b, v3(0, 0, 0.5f * t), v3(size, 1.6f * size, t));
    if (kind == 0) {
        dmg_vec pin = {0, y, t};
        dmg_box(b, pin, v3(0.25f * size, 0.9f * size, 0.3f * t));
        dmg_hinge(b, 0, "lever", pin, v3(dmg_sign(b), 0, 0), -0.7f, 0.7f);
        dmg_rod(b, pin, v3(0, y, t + 0.6f * size), 0.05f * size);
        dmg_ellipsoid(b, v3(0, y, t + 0.65f * size), v3(0.09f * size, 0.09f * size, 0.09f * size));
    }
    if (kind == 1) {
        dmg_save(b);
        dmg_move(b, 0, y, t);
        dmg_spin(b, 0, "knob", v3(0, 0, 0), v3(0, 0, 1));
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 0.25f * size, 0.25f * size);
        dmg_restore(b);
    }
    if (kind == 2) {
        float rise = size * dmg_range(b, 0.06f, 0.2f);
        dmg_slide(b, 0, "key", v3(0, 0, -1), 0.0f, 0.8f * rise);
        dmg_box(b, v3(0, y, t + 0.5f * rise), v3(0.5f * size, 0.5f * size, rise));
    }
    if (kind == 3) {
        dmg_hinge(b, 0, "flap", v3(0, 0.6f * size, t), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
        dmg_box(b, v3(0, 0, t + 0.06f * size), v3(0.8f * size, 1.2f * size, 0.1f * size));
    }
    dmg_use(b, 0);
}

static void draw_leaves(dmg_builder* b, portal* p) {
    int kind = dmg_weighted(b, (const float[]){4, 2, 3, 1.5f, 2, 2, 1.5f, 2}, 8), dress = dmg_int(b, 0, 3);
    if (kind == 3 || kind == 4) p->reach = dmg_range(b, 1.4f, 1.8f);
    if (kind == 4) { /* a round opening, its blades' housing behind the wall alone */
        p->x = p->y;
        p->hole = round_outline(p->x, p->y, 2.0f, 20);
    }
    switch (kind) {
    case 0:
        draw_halves(b, p, dress);
        break;
    case 1:
        draw_meshing(b, p);
        break;
    case 2:
        draw_sectors(b, p, dress);
        break;
    case 3:
        draw_sliding_iris(b, p, dress);
        break;
    case 4:
        draw_turning_iris(b, p);
        break;
    case 5:
        draw_petals(b, p);
        break;
    case 6:
        draw_telescope(b, p, dress);
        break;
    default:
        draw_single(b, p, dress);
        break;
    }
}

/* Draws one portal, its middle at the origin; returns how far it reaches down. */
static float draw_portal(dmg_builder* b, portal* p) {
    draw_leaves(b, p);
    draw_wall(b, p);
    float size = p->y * dmg_range(b, 0.12f, 0.25f), z = 0.5f * p->leaf + p->gap, x = 1.12f * p->x + 0.8f * size;
    if (p->front && p->reach * p->x > x + 0.6f * size && dmg_chance(b, 0.7f)) {
        dmg_save(b);
        dmg_move(b, dmg_sign(b) * x, -0.1f * p->y, z + p->wall);
        draw_console(b, size);
        dmg_restore(b);
    }
    return p->reach * p->y + p->wall;
}

void dmg_build_scifi_door(dmg_builder* b) {
    portal p = pick_portal(b);
    bool lock = dmg_chance(b, 0.2f);
    float length = p.y * dmg_range(b, 1.0f, 3.0f);
    dmg_move(b, 0, 2.4f * p.y, 0);
    draw_portal(b, &p);
    if (!lock) return;
    /* An air lock: another one behind it, a tube of plates between. */
    portal q = pick_portal(b);
    q.hole = grow_outline(&q.hole, p.x / q.x, p.y / q.y);
    float scale = fminf(p.x, p.y) / fminf(q.x, q.y);
    q.wall *= scale;
    q.leaf *= scale;
    q.gap *= scale;
    q.x = p.x;
    q.y = p.y;
    float front = -0.5f * p.leaf - p.gap - (p.back ? p.wall : 0.0f), x = 1.1f * p.x, y = 1.1f * p.y, t = p.wall;
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_box(b, v3(side * x, 0, front - 0.5f * length), v3(t, 2 * y, length));
        dmg_box(b, v3(0, side * y, front - 0.5f * length), v3(2 * x + t, t, length));
    }
    dmg_move(b, 0, 0, front - length - 0.5f * q.leaf - q.gap - (q.back ? q.wall : 0.0f));
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    draw_portal(b, &q);
}
