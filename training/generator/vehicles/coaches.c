/* Draws buses, coaches and rail cars: a shell with openings for doors or a plain block, doors and flaps in its
 * sides, roof and ends, wheels or bogies, and current collectors. Ahead is +Z; the sides are drawn for +X and
 * mirrored. */
#include "core/build.h"
#include "parts/coach_doors.h"
#include "parts/works.h"

typedef struct coach {
    float half, length, low, floor, belt, eave, roof, wall, wheel;
    float arch[2]; /* middles of the wheel arches, rear and front */
    bool hollow, rail;
} coach;

enum { GAP_LIMIT = 8 };

/* What the wall leaves out: a doorway or a wheel arch. */
typedef struct gap {
    float low, high, top;
    bool door;
} gap;

typedef struct side {
    gap gaps[GAP_LIMIT];
    int count;
} side;

static coach pick_coach(dmg_builder* b) {
    coach c = {.rail = dmg_chance(b, 0.4f), .hollow = dmg_chance(b, 0.7f)};
    c.half = dmg_range(b, 1.0f, 1.4f);
    c.length = c.rail ? dmg_range(b, 7.0f, 14.0f) : dmg_range(b, 5.5f, 11.0f);
    c.wheel = c.rail ? dmg_range(b, 0.3f, 0.42f) : dmg_range(b, 0.38f, 0.52f);
    c.floor = c.rail ? 2 * c.wheel + dmg_range(b, 0.35f, 0.5f) : dmg_range(b, 0.35f, 1.1f);
    c.low = c.rail ? c.floor - 0.25f : 0.3f;
    c.floor = fmaxf(c.floor, c.low + 0.08f);
    c.belt = c.floor + dmg_range(b, 0.7f, 0.95f);
    c.eave = c.floor + dmg_range(b, 1.9f, 2.1f);
    c.roof = c.eave + dmg_range(b, 0.2f, 0.45f);
    c.wall = dmg_range(b, 0.05f, 0.09f);
    c.arch[1] = 0.5f * c.length - (dmg_chance(b, 0.7f) ? 2.3f : 1.0f);
    c.arch[0] = -0.5f * c.length + dmg_range(b, 1.2f, 2.4f);
    return c;
}

/* ---- the shell ---- */

/* Between two places of the wall, from a height up to the roof; panes in bays, some of them open or in two. */
static void draw_wall(dmg_builder* b, const coach* c, float z0, float z1, float from) {
    float x0 = c->half - c->wall, x1 = c->half, post = 0.05f, head = c->eave - 0.12f;
    if (z1 - z0 < 0.02f) return;
    int bays = (int)fmaxf(1.0f, (z1 - z0) / 1.5f);
    float pitch = (z1 - z0) / (float)bays;
    if (from < c->belt) dmg_box_span(b, v3(x0, from, z0), v3(x1, c->belt, z1));
    dmg_box_span(b, v3(x0, fmaxf(from, head), z0), v3(x1, c->roof, z1));
    for (int i = 0; i < bays && from < head; ++i) {
        float low = z0 + pitch * (float)i, high = low + pitch, sill = fmaxf(from, c->belt),
              x = c->half - 0.5f * c->wall;
        dmg_box_span(b, v3(x0, sill, low), v3(x1, head, low + post));
        dmg_box_span(b, v3(x0, sill, high - post), v3(x1, head, high));
        int kind = pitch > 0.6f ? dmg_weighted(b, (const float[]){7, 1, 1, 1}, 4) : 0;
        float top = kind == 1 ? sill + 0.65f * (head - sill) : head, mid = 0.5f * (low + high);
        if (kind < 2) dmg_box_span(b, v3(x - 0.008f, sill, low + post), v3(x + 0.008f, top, high - post));
        if (kind == 1) { /* the upper third tips in about its lower edge */
            dmg_hinge(b, 0, "vent", v3(x, top, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.3f, 0.8f));
            dmg_box_span(b, v3(x - 0.01f, top + 0.005f, low + post), v3(x + 0.01f, head - 0.005f, high - post));
        }
        if (kind == 2) { /* one half before the other, sliding */
            dmg_box_span(b, v3(x - 0.008f, sill, low + post), v3(x + 0.008f, head, mid));
            dmg_slide(b, 0, "window", v3(0, 0, -1), 0.0f, 0.9f * (mid - low - post));
            dmg_box_span(b, v3(x - 0.03f, sill, mid), v3(x - 0.012f, head, high - post));
            dmg_box_span(b, v3(x - 0.04f, sill + 0.1f, mid), v3(x - 0.03f, head - 0.1f, mid + 0.03f));
        }
        if (kind == 3) { /* the sash drops into the wall */
            dmg_slide(b, 0, "window", v3(0, -1, 0), 0.0f, 0.6f * (head - sill));
            dmg_box_span(b, v3(x0 - 0.03f, sill, low + 0.3f * post), v3(x0 - 0.01f, head, high - 0.3f * post));
        }
        dmg_use(b, 0);
    }
}

/* Floor, roof and both ends of a hollow body. */
static void draw_ends(dmg_builder* b, const coach* c) {
    float x = c->half - c->wall, z = 0.5f * c->length, w = c->wall;
    dmg_box_span(b, v3(-x, c->floor - 0.07f, -z), v3(x, c->floor, z));
    if (dmg_chance(b, 0.5f)) {
        dmg_box_span(b, v3(-c->half, c->roof, -z), v3(c->half, c->roof + w, z));
    } else { /* arched */
        dmg_xy line[9];
        for (int i = 0; i < 9; ++i) {
            float at = 1.0f - 0.25f * (float)i;
            line[i] = (dmg_xy){at * c->half, c->roof + 0.5f * w + 0.2f * (1.0f - at * at)};
        }
        dmg_bent_plate(b, line, 9, w, c->length);
    }
    for (int s = -1; s <= 1; s += 2) {
        float end = (float)s * z, in = end - (float)s * w, belt = c->belt - (s > 0 ? dmg_range(b, 0.0f, 0.4f) : 0.0f);
        dmg_box_span(b, v3(-x, c->low, fminf(end, in)), v3(x, belt, fmaxf(end, in)));
        dmg_box_span(b, v3(-x, c->eave - 0.05f, fminf(end, in)), v3(x, c->roof, fmaxf(end, in)));
        dmg_box(b, v3(0, 0.5f * (belt + c->eave), 0.5f * (end + in)), v3(2 * x, c->eave - belt, 0.016f));
    }
}

/* Draws a block; its nose and tail perhaps tapered; panes laid on. */
static void draw_block(dmg_builder* b, const coach* c, const side* s) {
    float z = 0.5f * c->length, low = c->low, high = c->roof - low, r = dmg_range(b, 0.1f, 0.3f);
    const dmg_xy outline[] = {{-c->half, 0},       {c->half, 0},        {c->half, high - r},
                              {c->half - r, high}, {r - c->half, high}, {-c->half, high - r}};
    float nose = dmg_chance(b, 0.5f) ? dmg_range(b, 0.3f, 1.0f) : 0.02f;
    const dmg_row rows[] = {{1, 1, 0, -z}, {1, 1, 0, z - nose}, {0.85f, 0.75f, 0, z}};
    dmg_save(b);
    dmg_move(b, 0, low, 0);
    dmg_loft(b, outline, 6, rows, nose > 0.1f ? 3 : 2);
    dmg_restore(b);
    if (nose < 0.1f) dmg_box_span(b, v3(-0.9f * c->half, c->belt, z - 0.1f), v3(0.9f * c->half, c->eave, z + 0.03f));
    for (int k = 0; k < 2; ++k) {
        dmg_save(b);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        float at = -z + 0.2f;
        for (int i = 0; i <= s[k].count; ++i) {
            const gap* g = i < s[k].count ? &s[k].gaps[i] : NULL;
            if (g && !g->door) continue;
            float to = g ? g->low - 0.08f : z - nose - 0.1f;
            if (to > at + 0.3f)
                dmg_box_span(b, v3(c->half - 0.02f, c->belt, at), v3(c->half + 0.012f, c->eave - r, to));
            if (g) at = g->high + 0.08f;
        }
        dmg_restore(b);
    }
}

/* ---- where doors and wheels are ---- */

static void add_gap(side* s, gap g) {
    if (s->count >= GAP_LIMIT) return;
    for (int i = 0; i < s->count; ++i)
        if (g.low < s->gaps[i].high + 0.1f && s->gaps[i].low < g.high + 0.1f) return;
    int at = s->count++;
    for (; at > 0 && s->gaps[at - 1].low > g.low; --at) s->gaps[at] = s->gaps[at - 1];
    s->gaps[at] = g;
}

static void pick_gaps(dmg_builder* b, const coach* c, side* s, int doors) {
    float reach = 1.25f * c->wheel, end = 0.5f * c->length - 0.2f;
    for (int i = 0; i < 2 && !c->rail; ++i)
        add_gap(s, (gap){c->arch[i] - reach, c->arch[i] + reach, fmaxf(2.25f * c->wheel, c->low + 0.1f), false});
    for (int i = 0; i < doors; ++i) {
        float wide = dmg_range(b, 0.7f, 1.5f), at = dmg_range(b, -end, end - wide);
        if (i == 0 && !c->rail && end - wide > c->arch[1] + reach + 0.1f) at = end - wide;
        add_gap(s, (gap){at, at + wide, c->eave - 0.08f, true});
    }
}

static void draw_side(dmg_builder* b, const coach* c, const side* s) {
    float at = -0.5f * c->length;
    dmg_doorway d = dmg_doorway_pick(b, c->hollow);
    d.wall = c->wall;
    d.t = dmg_range(b, 0.025f, 0.05f);
    for (int i = 0; i < s->count; ++i) {
        const gap* g = &s->gaps[i];
        if (c->hollow) {
            draw_wall(b, c, at, g->low, c->low);
            draw_wall(b, c, g->low, g->high, g->top);
            if (g->door) dmg_box_span(b, v3(c->half - c->wall, c->low, g->low), v3(c->half, c->floor, g->high));
        }
        at = g->high;
        if (!g->door) continue;
        d.wide = g->high - g->low;
        d.high = g->top - c->floor;
        dmg_save(b);
        dmg_move(b, c->half, c->floor, 0.5f * (g->low + g->high));
        dmg_doorway_draw(b, &d);
        dmg_restore(b);
    }
    if (c->hollow) draw_wall(b, c, at, 0.5f * c->length, c->low);
}

/* ---- under it ---- */

static void draw_bogie(dmg_builder* b, const coach* c, float z, int wheel_kind) {
    float r = c->wheel, axle = 2.4f * r, x = 0.62f * c->half;
    uint32_t bogie = dmg_hinge(b, 0, "bogie", v3(0, 0, z), v3(0, dmg_sign(b), 0), -0.12f, 0.12f);
    dmg_rod(b, v3(0, 1.2f * r, z), v3(0, c->low - 0.01f, z), 0.8f * r);
    dmg_box_span(b, v3(-x, 1.0f * r, z - 0.4f * r), v3(x, 1.5f * r, z + 0.4f * r));
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s * (x + 0.25f * r);
        dmg_box(b, v3(side, 1.15f * r, z), v3(0.25f * r, 0.4f * r, 2 * axle));
    }
    for (int k = -1; k <= 1; k += 2) {
        float at = z + 0.5f * (float)k * axle;
        dmg_spin(b, bogie, "wheelset", v3(0, r, at), v3(1, 0, 0));
        dmg_rod(b, v3(-x - 0.1f * r, r, at), v3(x + 0.1f * r, r, at), 0.2f * r);
        for (int s = -1; s <= 1; s += 2) {
            dmg_save(b);
            dmg_move(b, (float)s * (x - 0.15f * r), r, at);
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_wheel_draw(b, wheel_kind, r, 0.25f * r, 5);
            dmg_restore(b);
        }
    }
    dmg_use(b, 0);
}

static void draw_running_gear(dmg_builder* b, const coach* c) {
    float x = c->half;
    if (c->rail) {
        int kind = dmg_int(b, 0, 1);
        for (int s = -1; s <= 1; s += 2) {
            float end = (float)s * 0.5f * c->length, reach = (float)s * 0.5f;
            draw_bogie(b, c, (float)s * 0.33f * c->length, kind);
            if (dmg_chance(b, 0.5f)) dmg_hinge(b, 0, "coupler", v3(0, 0, end), v3(0, 1, 0), -0.3f, 0.3f);
            dmg_beam(b, v3(0, c->low + 0.08f, end), v3(0, c->low + 0.08f, end + reach), 0.14f, 0.12f);
            dmg_box(b, v3(0, c->low + 0.08f, end + reach), v3(0.3f, 0.25f, 0.12f));
            dmg_use(b, 0);
        }
        dmg_box_span(b, v3(-0.7f * x, 0.5f * c->low, -0.12f * c->length), v3(0.7f * x, c->low, 0.1f * c->length));
        return;
    }
    dmg_tyre front = dmg_tyre_pick(b, c->wheel), rear;
    front.width = fminf(front.width, 0.3f);
    rear = front;
    front.steers = dmg_chance(b, 0.6f);
    front.knuckle = 2;
    float out = c->hollow ? -0.55f : 0.2f;
    dmg_axle_draw(b, &rear, 0, x + out * rear.width, c->arch[0]);
    dmg_axle_draw(b, &front, 0, x + out * front.width, c->arch[1]);
    if (!c->hollow || c->floor > 2.3f * c->wheel) return;
    for (int i = 0; i < 4; ++i) { /* boxes over the wheels, inside */
        float s = i % 2 ? 1.0f : -1.0f, z = c->arch[i / 2], in = s * (x - 0.5f), skin = s * (x - c->wall);
        dmg_box_span(b, v3(fminf(in, skin), c->floor, z - 1.2f * c->wheel),
                     v3(fmaxf(in, skin), 2.3f * c->wheel, z + 1.2f * c->wheel));
    }
}

/* Flaps over the lockers below the floor, between the wheels: they turn up, drop, or slide. */
static void draw_lockers(dmg_builder* b, const coach* c, const side* s) {
    float z0 = c->arch[0] + 1.4f * c->wheel, z1 = c->arch[1] - 1.4f * c->wheel, t = 0.03f, x = c->half + 0.005f;
    float high = c->floor - c->low - 0.04f;
    int count = dmg_int(b, 1, 4), kind = dmg_weighted(b, (const float[]){3, 1, 1}, 3);
    if (c->rail || high < 0.4f) return;
    dmg_box_span(b, v3(0.3f * c->half, c->low, z0), v3(c->half - c->wall, c->floor - 0.07f, z1));
    float each = (z1 - z0) / (float)count, most = dmg_range(b, 1.2f, 2.0f);
    for (int i = 0; i < count; ++i) {
        float low = z0 + each * (float)i + 0.03f, top = c->low + high;
        bool clash = false;
        for (int k = 0; k < s->count; ++k)
            clash |= s->gaps[k].door && s->gaps[k].low < low + each && s->gaps[k].high > low;
        if (clash) continue;
        if (kind == 0) dmg_hinge(b, 0, "locker", v3(x + t, top, 0), v3(0, 0, 1), 0.0f, most);
        if (kind == 1) dmg_hinge(b, 0, "locker", v3(x + t, c->low, 0), v3(0, 0, -1), 0.0f, most);
        if (kind == 2) dmg_slide(b, 0, "locker", v3(0.2f, 1, 0), 0.0f, 0.9f * high);
        dmg_box_span(b, v3(x, c->low, low), v3(x + t, top, low + each - 0.06f));
        if (dmg_chance(b, 0.5f))
            dmg_box(b, v3(x + 1.5f * t, kind == 1 ? top - 0.1f : c->low + 0.1f, low + 0.5f * each), v3(t, 0.03f, 0.2f));
        dmg_use(b, 0);
    }
}

/* ---- on the roof ---- */

static void draw_hatches(dmg_builder* b, const coach* c, float top) {
    int count = dmg_int(b, 0, 2);
    bool lifts = dmg_chance(b, 0.4f);
    for (int i = 0; i < count; ++i) {
        float z = (0.18f - 0.36f * (float)i) * c->length, size = dmg_range(b, 0.25f, 0.4f);
        dmg_box(b, v3(0, top, z), v3(2.1f * size, 0.06f, 2.1f * size));
        if (lifts)
            dmg_slide(b, 0, "hatch", v3(0, 1, 0), 0.0f, dmg_range(b, 0.08f, 0.2f));
        else
            dmg_hinge(b, 0, "hatch", v3(0, top + 0.035f, z - size), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.6f));
        dmg_box_span(b, v3(-size, top + 0.03f, z - size), v3(size, top + 0.08f, z + size));
        if (lifts)
            for (int s = -1; s <= 1; s += 2)
                dmg_rod(b, v3((float)s * 0.6f * size, top - 0.25f, z), v3((float)s * 0.6f * size, top + 0.04f, z),
                        0.02f);
        dmg_use(b, 0);
    }
}

/* Draws the head over the arms: bars across, horns at their ends. It stands level by itself. */
static void draw_collector(dmg_builder* b, uint32_t arm, dmg_vec at, float half) {
    if (dmg_chance(b, 0.7f)) dmg_hinge(b, arm, "collector", at, v3(1, 0, 0), -0.3f, 0.3f);
    dmg_rod(b, v3(-0.5f * half, at.y, at.z), v3(0.5f * half, at.y, at.z), 0.025f);
    for (int k = -1; k <= 1; k += 2) {
        float z = at.z + 0.12f * (float)k;
        const dmg_vec bow[] = {{-half, at.y - 0.1f, z},
                               {-0.75f * half, at.y + 0.07f, z},
                               {0.75f * half, at.y + 0.07f, z},
                               {half, at.y - 0.1f, z}};
        dmg_sweep(b, bow, 4, 0.02f, 0.03f, false);
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 0.45f * half;
            dmg_beam(b, v3(x, at.y, at.z), v3(x, at.y + 0.06f, z), 0.03f, 0.03f);
        }
    }
}

/* One-armed, or a lozenge of two; drawn raised, it folds down. */
static void draw_pantograph(dmg_builder* b, const coach* c, float top, float z) {
    float reach = dmg_range(b, 0.6f, 1.1f), rise = dmg_range(b, 0.5f, 1.1f), y = top + 0.22f, half = 0.65f * c->half;
    bool both = dmg_chance(b, 0.35f);
    float wide = both ? 0.4f * c->half : 0.06f, lean = atan2f(rise, reach);
    for (int i = 0; i < 4; ++i)
        dmg_rod(b, v3(i & 1 ? 0.35f * c->half : -0.35f * c->half, top - 0.3f, z + (i & 2 ? 0.4f : -0.4f)),
                v3(i & 1 ? 0.35f * c->half : -0.35f * c->half, y - 0.05f, z + (i & 2 ? 0.4f : -0.4f)), 0.05f);
    dmg_box(b, v3(0, y - 0.04f, z), v3(0.8f * c->half, 0.06f, 1.0f));
    for (float s = both ? -1.0f : 1.0f; s <= 1; s += 2) {
        dmg_vec foot = {0, y + 0.04f, z - (both ? -0.3f * s : 0.4f)}, knee = {0, foot.y + rise, foot.z + s * -reach};
        dmg_vec head = {0, knee.y + 1.1f * rise, z};
        uint32_t low = dmg_hinge(b, 0, "lower_arm", foot, v3(-s, 0, 0), -0.3f, 0.9f * lean);
        dmg_rod(b, v3_add(foot, v3(-wide, 0, 0)), v3_add(foot, v3(wide, 0, 0)), 0.06f);
        for (int k = -1; k <= 1; k += 2) {
            dmg_vec at = {(float)k * wide * 0.9f, 0, 0};
            dmg_rod(b, v3_add(foot, at), v3_add(knee, at), 0.035f);
        }
        dmg_rod(b, v3_add(knee, v3(-wide, 0, 0)), v3_add(knee, v3(wide, 0, 0)), 0.045f);
        uint32_t high = dmg_hinge(b, low, "upper_arm", knee, v3(s, 0, 0), -0.2f, 1.1f * lean);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3_add(knee, v3((float)k * wide * 0.7f, 0, 0)),
                    v3_add(head, v3((float)k * 0.3f * half, -0.02f, 0)), 0.025f);
        if (s > 0) draw_collector(b, high, head, half);
        dmg_use(b, 0);
    }
}

/* Draws two poles that turn and tip on their feet. */
static void draw_poles(dmg_builder* b, const coach* c, float top) {
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.3f * c->half, long_ = 0.4f * c->length;
        dmg_rod(b, v3(x, top - 0.3f, 0), v3(x, top + 0.1f, 0), 0.14f);
        uint32_t foot = dmg_hinge(b, 0, "pole_foot", v3(x, 0, 0), v3(0, 1, 0), -1.0f, 1.0f);
        dmg_rod(b, v3(x, top + 0.1f, 0), v3(x, top + 0.22f, 0), 0.1f);
        dmg_hinge(b, foot, "pole", v3(x, top + 0.25f, 0), v3(1, 0, 0), -0.1f, 0.6f);
        dmg_rod(b, v3(x - 0.08f, top + 0.25f, 0), v3(x + 0.08f, top + 0.25f, 0), 0.06f);
        dmg_rod(b, v3(x, top + 0.25f, 0), v3(x, top + 0.5f, -long_), 0.03f);
        dmg_box(b, v3(x, top + 0.52f, -long_), v3(0.06f, 0.08f, 0.2f));
        dmg_use(b, 0);
    }
}

static void draw_roof(dmg_builder* b, const coach* c) {
    float top = c->roof + (c->hollow ? c->wall : 0.0f) + 0.1f;
    dmg_box(b, v3(0, c->roof + 0.05f, 0), v3(1.3f * c->half, 0.1f + 2 * (top - 0.1f - c->roof), 0.9f * c->length));
    if (c->hollow) top = fmaxf(top, c->roof + 0.2f + c->wall);
    if (c->hollow) dmg_box(b, v3(0, 0.5f * (c->roof + top), 0), v3(c->half, top - c->roof, 0.85f * c->length));
    int kind = dmg_weighted(b, (const float[]){c->rail ? 1.5f : 4.0f, c->rail ? 4.0f : 1.0f, 1.0f}, 3);
    if (kind != 2) draw_hatches(b, c, top);
    if (kind == 1) draw_pantograph(b, c, top, dmg_chance(b, 0.5f) ? 0.0f : -0.36f * c->length);
    if (kind == 2) draw_poles(b, c, top);
}

/* ---- ends ---- */

static void draw_front(dmg_builder* b, const coach* c) {
    float z = 0.5f * c->length + 0.035f, reach = 0.6f * c->half;
    int wipers = c->hollow ? dmg_int(b, 0, 2) : 0;
    for (int i = 0; i < wipers; ++i) {
        float x = (wipers == 1 ? 0.0f : (i ? 0.1f : 0.75f) * c->half), y = c->belt - 0.02f;
        dmg_rod(b, v3(x, y, z - 0.12f), v3(x, y, z), 0.025f);
        dmg_hinge(b, 0, "wiper", v3(x, y, 0), v3(0, 0, 1), -1.5f, 0.0f);
        dmg_rod(b, v3(x, y, z), v3(x, y, z + 0.03f), 0.035f);
        dmg_beam(b, v3(x, y, z + 0.02f), v3(x - 0.7f * reach, y + 0.05f, z + 0.02f), 0.015f, 0.03f);
        dmg_box(b, v3(x - 0.7f * reach, y + 0.05f, z + 0.01f), v3(reach, 0.03f, 0.02f));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.4f)) return;
    for (int s = -1; s <= 1; s += 2) { /* mirrors on arms */
        float y = c->eave - 0.1f, x = (float)s * 0.95f * c->half, out = (float)s * (c->half + 0.3f);
        dmg_hinge(b, 0, "mirror", v3(x, 0, z - 0.01f), v3(0, (float)s, 0), -0.2f, 1.4f);
        dmg_rod(b, v3(x, y, z - 0.1f), v3(x, y, z + 0.15f), 0.02f);
        dmg_rod(b, v3(x, y, z + 0.15f), v3(out, y - 0.05f, z + 0.2f), 0.02f);
        dmg_rounded_box(b, v3(out, y - 0.25f, z + 0.2f), v3(0.22f, 0.4f, 0.1f), 0.03f);
        dmg_use(b, 0);
    }
}

static void draw_rear(dmg_builder* b, const coach* c) {
    float z = -0.5f * c->length - 0.005f, x = 0.8f * c->half, y0 = c->low + 0.1f, y1 = c->belt - 0.05f, t = 0.04f;
    int kind = dmg_int(b, 0, 3);
    if (c->rail || kind == 3) return;
    if (kind == 0) dmg_hinge(b, 0, "engine_flap", v3(0, y1, z - t), v3(1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.8f));
    if (kind == 1) dmg_hinge(b, 0, "engine_flap", v3(x, 0, z - t), v3(0, -1, 0), 0.0f, dmg_range(b, 1.0f, 2.5f));
    if (kind == 2) dmg_hinge(b, 0, "engine_flap", v3(0, y0, z - t), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.7f));
    dmg_box_span(b, v3(-x, y0, z - t), v3(x, y1, z));
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.5f * (y0 + y1), z + 0.5f), v3(1.2f * x, 0.8f * (y1 - y0), 0.6f));
}

/* ---- inside ---- */

static bool at_door(const side* s, float low, float high) {
    for (int i = 0; i < s->count; ++i)
        if (s->gaps[i].door && s->gaps[i].low - 0.2f < high && s->gaps[i].high + 0.2f > low) return true;
    return false;
}

/* Benches in rows, some of which tip up; none near doors. */
static void draw_seats(dmg_builder* b, const coach* c, const side* s) {
    int tips = dmg_int(b, 0, 3), left = tips;
    float pitch = dmg_range(b, 0.75f, 1.1f), x0 = 0.35f * c->half, x1 = c->half - c->wall - 0.12f;
    for (float z = -0.5f * c->length + 0.5f; z < 0.5f * c->length - 1.6f; z += pitch) {
        if (at_door(s, z, z + 1.4f)) continue;
        float y = c->floor + 0.42f, lift = fabsf(z - c->arch[0]) < 1.0f || fabsf(z - c->arch[1]) < 1.0f ? 0.3f : 0.0f;
        y += c->rail ? 0.0f : lift;
        dmg_box_span(b, v3(x0, y - 0.1f, z), v3(x1, y + 0.65f, z + 0.08f));
        dmg_box_span(b, v3(x0 + 0.1f, c->floor, z), v3(x1 - 0.1f, y - 0.1f, z + 0.07f));
        if (left-- > 0) dmg_hinge(b, 0, "seat", v3(0, y - 0.02f, z + 0.1f), v3(-1, 0, 0), 0.0f, 1.4f);
        dmg_box_span(b, v3(x0, y - 0.08f, z + 0.09f), v3(x1, y, z + 0.5f));
        dmg_use(b, 0);
    }
}

void dmg_build_bus(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.7f) ? 1.0f : dmg_scale_range(b, 0.02f, 0.3f));
    coach c = pick_coach(b);
    side sides[2] = {{.count = 0}, {.count = 0}};
    int doors = dmg_int(b, 1, 3), others = c.rail ? doors : dmg_int(b, 0, 1);
    pick_gaps(b, &c, &sides[0], doors);
    pick_gaps(b, &c, &sides[1], others);
    if (c.hollow) draw_ends(b, &c);
    if (!c.hollow) draw_block(b, &c, sides);
    bool seats = c.hollow && dmg_chance(b, 0.5f), lockers = dmg_chance(b, 0.7f);
    for (int k = 0; k < 2; ++k) {
        dmg_save(b);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        draw_side(b, &c, &sides[k]);
        if (lockers) draw_lockers(b, &c, &sides[k]);
        if (seats) draw_seats(b, &c, &sides[k]);
        dmg_restore(b);
    }
    draw_running_gear(b, &c);
    draw_roof(b, &c);
    draw_front(b, &c);
    draw_rear(b, &c);
}
