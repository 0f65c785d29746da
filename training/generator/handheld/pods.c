/* Draws hand-held housings with a finger lever let into the shell: it fills an opening as a button would, flush or a
 * little proud, round or long, and turns about a hidden pin near one of its ends; similar-looking ones slide.
 * Controllers with a rounded head, tools with a trigger, plain handles. Forward is +Z, up +Y. */
#include "core/build.h"
#include "parts/thumbs.h"

/* ---- the housing: an ellipsoid or rounder box, its reach to either side of its middle its own ---- */

typedef struct pod {
    dmg_vec low, high;
    float power; /* 2 an ellipsoid, more: nearer to a box */
    float top;   /* cut flat at this height, for the thumb */
    float bend;  /* how far it hangs down behind, over the square of the way */
} pod;

static float pick_reach(float at, float low, float high) {
    return at * (at < 0 ? low : high);
}

/* The point of the surface in direction `way` of the unit sphere. */
static dmg_vec pod_point(const pod* p, dmg_vec way) {
    float sum = powf(fabsf(way.x), p->power) + powf(fabsf(way.y), p->power) + powf(fabsf(way.z), p->power);
    dmg_vec at = v3_scale(way, powf(sum, -1.0f / p->power));
    at = v3(pick_reach(at.x, p->low.x, p->high.x), pick_reach(at.y, p->low.y, p->high.y),
            pick_reach(at.z, p->low.z, p->high.z));
    at.y = fminf(at.y, p->top);
    if (at.z < 0) at.y -= p->bend * at.z * at.z;
    return at;
}

/* ---- the opening ---- */

enum { COLUMNS = 18, RINGS = 9, LEVER_ROWS = 7 };

typedef struct mouth {
    dmg_vec side, up, out; /* on the pod's unit sphere; up: towards the lever's root */
    float wide, tall;      /* half sizes there */
    float power, taper;
    /* On the pod: */
    dmg_vec centre, across, along, normal;
    float width, length;
} mouth;

/* Direction of the outline at an angle from `side` to `up`; share 0 is its middle, 1 its edge. */
static dmg_vec mouth_way(const mouth* m, float angle, float share) {
    float c = cosf(angle), s = sinf(angle);
    float round = powf(powf(fabsf(c), m->power) + powf(fabsf(s), m->power), -1.0f / m->power);
    float x = m->wide * round * c * (1.0f + m->taper * round * s), y = m->tall * round * s;
    return v3_normalize(v3_mad(v3_mad(m->out, m->side, share * x), m->up, share * y));
}

static float column_angle(int column) {
    return 2.0f * DMG_PI * (float)column / COLUMNS;
}

/* side x up = out. */
static mouth pick_mouth(dmg_builder* b, const pod* p, dmg_vec up, dmg_vec out, float wide, float tall) {
    mouth m = {.side = v3_normalize(v3_cross(up, out)), .up = up, .out = out, .wide = wide, .tall = tall};
    m.power = dmg_chance(b, 0.5f) ? 2.0f : dmg_range(b, 2.0f, 5.0f);
    m.taper = dmg_range(b, -0.35f, 0.35f);
    dmg_vec root = pod_point(p, mouth_way(&m, 0.5f * DMG_PI, 1)), tip = pod_point(p, mouth_way(&m, -0.5f * DMG_PI, 1));
    dmg_vec right = pod_point(p, mouth_way(&m, 0, 1)), left = pod_point(p, mouth_way(&m, DMG_PI, 1));
    m.length = v3_length(v3_sub(root, tip));
    m.width = v3_length(v3_sub(right, left));
    m.centre = v3_lerp(v3_lerp(root, tip, 0.5f), v3_lerp(left, right, 0.5f), 0.5f);
    m.along = v3_normalize(v3_sub(root, tip));
    m.normal = v3_normalize(v3_cross(v3_sub(right, left), m.along));
    m.across = v3_cross(m.along, m.normal);
    return m;
}

typedef enum opening { OPENING_NONE, OPENING_HOLE, OPENING_WALLS, OPENING_WELL } opening;

static opening pick_opening(dmg_builder* b) {
    return (opening)dmg_weighted(b, (const float[]){0.2f, 0.3f, 0.15f, 0.35f}, 4);
}

/* From the floor of the opening over its edge to the pod's far side. */
static void draw_pod(dmg_builder* b, const pod* p, const mouth* m, opening kind, float well) {
    dmg_vec at[(RINGS + 3) * COLUMNS];
    int rows = 0;
    bool wall = kind >= OPENING_WALLS;
    for (int r = wall ? -1 : 0; r <= RINGS; ++r, ++rows) {
        for (int c = 0; c < COLUMNS; ++c) {
            dmg_vec way = mouth_way(m, column_angle(c), kind == OPENING_NONE ? 0.1f : 1.0f);
            float from = acosf(fminf(1.0f, v3_dot(way, m->out))), share = 0.97f * (float)(r < 0 ? 0 : r) / RINGS,
                  angle = from + (DMG_PI - from) * share;
            dmg_vec round = v3_normalize(v3_mad(way, m->out, -v3_dot(way, m->out)));
            way = v3_add(v3_scale(m->out, cosf(angle)), v3_scale(round, sinf(angle)));
            at[rows * COLUMNS + c] = v3_mad(pod_point(p, way), m->normal, r < 0 ? -well : 0.0f);
        }
    }
    bool floor = kind == OPENING_WELL || kind == OPENING_NONE;
    dmg_rows_draw(b, at, rows, COLUMNS, DMG_ROWS_ROUND | DMG_ROWS_CAP_LAST | (floor ? DMG_ROWS_CAP_FIRST : 0));
}

/* Closed all round. */
static void draw_plain_pod(dmg_builder* b, const pod* p) {
    const mouth whole = {.side = {1, 0, 0}, .up = {0, 1, 0}, .out = {0, 0, 1}, .wide = 1, .tall = 1, .power = 2};
    draw_pod(b, p, &whole, OPENING_NONE, 0);
}

/* ---- the lever ---- */

/* Heights over the shell and depths are shares of its length. */
typedef struct lever {
    float gap;                     /* it is this much smaller than the opening */
    float rise, lip, saddle, roll; /* at the root, more at the tip, less in the middle, less at the sides */
    float scoop;                   /* how late the tip rises */
    float depth, slant;            /* of its side walls, more or less at the tip */
    bool closed;                   /* behind */
} lever;

static lever pick_lever(dmg_builder* b) {
    lever l = {.gap = dmg_range(b, 0.0f, 0.1f), .rise = dmg_chance(b, 0.5f) ? 0.0f : dmg_scale_range(b, 0.02f, 0.25f)};
    l.lip = dmg_chance(b, 0.3f) ? dmg_range(b, 0.0f, 0.1f) : dmg_range(b, 0.05f, 0.55f);
    l.scoop = dmg_range(b, 1.0f, 4.0f);
    l.saddle = dmg_range(b, -0.12f, 0.2f);
    l.roll = dmg_range(b, -0.1f, 0.25f);
    l.depth = dmg_scale_range(b, 0.06f, 0.5f);
    l.slant = dmg_range(b, -0.5f, 0.8f);
    l.closed = dmg_chance(b, 0.55f);
    return l;
}

/* Over the shell, at shares of the half length towards the tip and of the half width. */
static float lever_height(const lever* l, float tip, float side) {
    float end = fmaxf(0.0f, 0.5f + 0.5f * tip);
    return l->rise + l->lip * powf(end, l->scoop) - l->saddle * (1.0f - tip * tip) -
           l->roll * side * side * (l->rise + l->lip);
}

static void draw_lever(dmg_builder* b, const pod* p, const mouth* m, const lever* l) {
    static const float shares[LEVER_ROWS] = {0.1f, 0.4f, 0.65f, 0.85f, 1.0f, 1.0f, 1.0f};
    dmg_vec at[LEVER_ROWS * COLUMNS];
    for (int r = 0; r < LEVER_ROWS; ++r) {
        for (int c = 0; c < COLUMNS; ++c) {
            dmg_vec q = pod_point(p, mouth_way(m, column_angle(c), shares[r] * (1.0f - l->gap)));
            dmg_vec from = v3_sub(q, m->centre);
            float tip = -2.0f * v3_dot(from, m->along) / m->length, side = 2.0f * v3_dot(from, m->across) / m->width;
            float height = lever_height(l, tip, side), wall = l->depth * (1.0f + l->slant * tip);
            if (r == LEVER_ROWS - 2) height = fminf(height, 0.0f) - 0.1f * l->depth;
            if (r == LEVER_ROWS - 1) height = fminf(height, 0.0f) - wall;
            at[r * COLUMNS + c] = v3_mad(q, m->normal, height * m->length);
        }
    }
    dmg_rows_draw(b, at, LEVER_ROWS, COLUMNS,
                  DMG_ROWS_ROUND | DMG_ROWS_CAP_FIRST | (l->closed ? DMG_ROWS_CAP_LAST : 0));
}

/* The pin runs across the root, in the shell's wall or under it; deeper in, or nearer to the middle, in some. Returns
 * how deep the tip goes, as a share of the length. */
static float hinge_lever(dmg_builder* b, const pod* p, const mouth* m, const char* name, float most) {
    dmg_vec root = v3_sub(pod_point(p, mouth_way(m, 0.5f * DMG_PI, 1)), m->centre);
    float along = dmg_range(b, 0.35f, 0.62f), below = dmg_range(b, -0.35f, 0.12f), yaw = dmg_range(b, -0.15f, 0.15f);
    if (dmg_chance(b, 0.2f)) {
        along = dmg_range(b, 0.0f, 0.8f);
        below = dmg_range(b, -0.8f, 0.0f);
    }
    float pull = fminf(dmg_range(b, 0.1f, 0.55f), most / hypotf(along + 0.5f, below));
    dmg_vec pin = v3_mad(m->centre, m->along, along * m->length);
    pin = v3_mad(pin, m->normal, v3_dot(root, m->normal) + below * m->length);
    dmg_vec axis = dmg_chance(b, 0.7f) ? m->across : v3_turn(m->across, m->normal, yaw);
    dmg_hinge(b, 0, name, pin, axis, 0.0f, pull);
    return pull * (along + 0.5f);
}

static float slide_lever(dmg_builder* b, const mouth* m, const lever* l, const char* name) {
    dmg_vec press = v3_scale(m->normal, -1);
    if (dmg_chance(b, 0.3f)) press = v3_turn(press, m->across, dmg_range(b, -0.35f, 0.35f));
    float way = fminf(0.5f * l->rise + 0.2f * l->lip, dmg_scale_range(b, 0.02f, 0.3f));
    dmg_slide(b, 0, name, press, 0.0f, m->length * way);
    return way;
}

/* Draws the pod, its opening and what fills it; the well leaves the lever its way where the pod is thick enough. */
static void draw_lever_pod(dmg_builder* b, const pod* p, const mouth* m, const char* name, bool turns) {
    lever l = pick_lever(b);
    opening kind = pick_opening(b);
    float thick = v3_dot(m->centre, m->normal) / m->length, room = dmg_range(b, 0.05f, 0.4f);
    l.depth = fminf(l.depth, 0.5f * thick);
    if (!turns) { /* a key stands out by more than its way, so that it still shows when pressed */
        l.rise = fmaxf(l.rise, dmg_range(b, 0.04f, 0.15f));
        l.saddle = fminf(l.saddle, 0.4f * l.rise);
    }
    /* A shell without an opening is not to swallow it. */
    float most = kind == OPENING_NONE ? 0.1f + 0.7f * (l.rise + l.lip) : fminf(0.45f, 0.7f * thick);
    float way = turns ? hinge_lever(b, p, m, name, most) : slide_lever(b, m, &l, name);
    draw_lever(b, p, m, &l);
    dmg_use(b, 0);
    float well = l.depth * (1.0f + fabsf(l.slant)) + way + room;
    draw_pod(b, p, m, kind, m->length * fminf(well, 1.2f * thick));
}

/* ---- what else is on them ---- */

/* On z = 0 within a radius: a stick, a pad or neither, near the edge rather than in the middle, and few keys. */
static void draw_thumb_things(dmg_builder* b, float r) {
    int layout = dmg_int(b, 0, 3), keys = dmg_int(b, 0, 2);
    float turn = dmg_range(b, 0, 2.0f * DMG_PI), off = r * (layout == 0 ? 0.0f : dmg_range(b, 0.0f, 0.6f));
    dmg_save(b);
    dmg_move(b, off * cosf(turn), off * sinf(turn), 0);
    if (layout == 0)
        dmg_touch_pad_draw(b, 0, r * dmg_range(b, 0.3f, 0.6f));
    else if (layout < 3)
        dmg_thumb_stick_draw(b, 0, r * dmg_range(b, 0.22f, 0.4f));
    dmg_restore(b);
    float small = r * dmg_range(b, 0.12f, 0.2f), reach = r * dmg_range(b, 0.6f, 0.8f);
    for (int i = 0; i < keys; ++i) {
        float angle = turn + DMG_PI + 2.5f * small / reach * ((float)i - 0.5f * (float)(keys - 1));
        dmg_save(b);
        dmg_move(b, reach * cosf(angle), reach * sinf(angle), 0);
        dmg_thumb_key_draw(b, 0, i == 1 ? "menu" : "key", small);
        dmg_restore(b);
    }
}

static pod pick_handle(dmg_builder* b, float length) {
    float front = dmg_range(b, 0.3f, 0.5f), half = length * dmg_range(b, 0.11f, 0.18f);
    pod p = {.low = {half, half, (1.0f - front) * length}, .power = dmg_range(b, 2.0f, 4.0f), .top = 1.0f};
    p.high = v3(half, half * dmg_range(b, 0.8f, 1.3f), front * length);
    p.low.y = half * dmg_range(b, 0.8f, 1.5f);
    p.bend = dmg_range(b, 0.0f, 0.25f) / length;
    return p;
}

/* Draws a lever under the fingers: along the handle, at the side, round the corner or in front of them. */
static void draw_grip(dmg_builder* b, const pod* p, float lever_chance, const char* name) {
    if (!dmg_chance(b, lever_chance)) {
        draw_plain_pod(b, p);
        return;
    }
    float angle = dmg_chance(b, 0.5f) ? dmg_range(b, -0.3f, 0.3f) : dmg_range(b, -0.5f * DMG_PI, 0.0f);
    float wide = dmg_range(b, 0.35f, 0.8f), tall = dmg_range(b, 0.15f, 0.45f);
    dmg_vec out = {cosf(angle), sinf(angle), 0}, up = {0, 0, dmg_chance(b, 0.6f) ? 1.0f : -1.0f};
    mouth m = pick_mouth(b, p, up, out, wide, tall);
    draw_lever_pod(b, p, &m, name, dmg_chance(b, 0.4f));
}

/* ---- kinds ---- */

/* A head with a lever for the forefinger below its front, a face for the thumb on top, on a handle. */
void dmg_build_finger_controller(dmg_builder* b) {
    float r = dmg_range(b, 0.018f, 0.032f), cut = dmg_range(b, 0.3f, 0.9f);
    pod head = {.low = {r, r * dmg_range(b, 0.6f, 1.4f), r * dmg_range(b, 0.8f, 1.8f)},
                .power = dmg_range(b, 2.0f, 3.5f)};
    const float front = r * dmg_range(b, 0.8f, 1.7f), crown = r * dmg_range(b, 0.5f, 1.1f);
    head.high = v3(r, crown, front);
    head.top = cut * head.high.y;
    float tilt = dmg_range(b, -0.2f, 0.8f), droop = dmg_range(b, 0.0f, 1.3f), length = r * dmg_range(b, 2.8f, 4.5f);
    float wide = dmg_range(b, 0.3f, 0.8f), tall = dmg_range(b, 0.3f, 0.75f), yaw = dmg_range(b, -0.3f, 0.3f);
    /* Its upper edge stays below the thumb's face. */
    float down = fmaxf(dmg_range(b, 0.1f, 1.4f), atanf(tall) - asinf(0.6f * cut));
    /* And its lower one clear of the handle. */
    droop = fminf(droop, DMG_PI - 1.0f - atanf(tall) - down + tilt);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    dmg_turn(b, v3(1, 0, 0), dmg_range(b, -0.6f, 0.4f));
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -droop);
    pod handle = pick_handle(b, length);
    handle.high.z += 0.8f * head.low.z; /* what the head hides of it */
    dmg_move(b, 0, 0, -0.95f * handle.high.z);
    draw_grip(b, &handle, 0.5f, "squeeze");
    dmg_restore(b);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -tilt);
    dmg_vec out = {sinf(yaw) * cosf(down), -sinf(down), cosf(yaw) * cosf(down)};
    dmg_vec up = {sinf(yaw) * sinf(down), cosf(down), cosf(yaw) * sinf(down)};
    mouth m = pick_mouth(b, &head, up, out, wide, tall);
    bool turns = dmg_chance(b, 0.8f);
    draw_lever_pod(b, &head, &m, turns ? "trigger" : "bumper", turns);
    if (dmg_chance(b, 0.35f)) {
        const float tube = r * dmg_range(b, 0.08f, 0.3f), radius = r * dmg_range(b, 1.3f, 2.5f);
        const dmg_vec axis = v3(0, dmg_unit(b), 1);
        const float z = r * dmg_range(b, -0.5f, 1.5f), y = r * dmg_range(b, -1.5f, 1.5f);
        dmg_torus(b, v3(0, y, z), axis, radius, tube);
    }
    float flat = sqrtf(fmaxf(0.15f, 1.0f - cut * cut)) * fminf(r, fminf(head.low.z, head.high.z));
    dmg_move(b, 0, head.top, 0);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_turn(b, v3(0, 0, 1), DMG_PI); /* the face's y points away from the player */
    draw_thumb_things(b, 0.9f * flat);
    dmg_restore(b);
}

/* A scanner, a drill, a gun for glue or water: a body along Z on a handle whose front has the trigger. */
void dmg_build_trigger_tool(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.08f, 0.3f), lean = dmg_range(b, 0.0f, 0.5f);
    float r = length * dmg_range(b, 0.16f, 0.3f), back = dmg_range(b, -0.35f, 0.1f);
    pod body = {.low = {r, r, length * dmg_range(b, 0.3f, 0.6f)}, .power = dmg_range(b, 2.0f, 5.0f), .top = 1.0f};
    const float z = length * dmg_range(b, 0.4f, 0.8f), y = r * dmg_range(b, 0.7f, 1.2f);
    body.high = v3(r, y, z);
    pod handle = pick_handle(b, length * dmg_range(b, 0.7f, 1.2f));
    handle.high.y *= dmg_range(b, 1.0f, 1.5f);
    handle.low.y *= dmg_range(b, 1.0f, 1.5f);
    draw_plain_pod(b, &body);
    if (dmg_chance(b, 0.6f)) {
        const float radius_to = r * dmg_range(b, 0.1f, 0.8f), radius_from = r * dmg_range(b, 0.3f, 0.8f);
        const dmg_vec to = v3(0, 0, body.high.z * dmg_range(b, 1.1f, 1.6f)); /* its muzzle */
        dmg_cone(b, v3(0, 0, 0.8f * body.high.z), to, radius_from, radius_to);
    }
    dmg_save(b);
    float wide = dmg_range(b, 0.3f, 0.8f), tall = dmg_range(b, 0.2f, 0.55f);
    handle.high.z *= dmg_range(b, 0.5f, 1.0f);
    dmg_move(b, 0, -0.7f * r, back * length);
    dmg_turn(b, v3(1, 0, 0), lean - 0.5f * DMG_PI); /* the handle's -Z hangs down, its -Y is in front */
    dmg_move(b, 0, 0, -handle.high.z * (tall + dmg_range(b, 0.1f, 0.5f)));
    mouth m = pick_mouth(b, &handle, v3(0, 0, 1), v3(0, -1, 0), wide, tall);
    bool turns = dmg_chance(b, 0.75f);
    draw_lever_pod(b, &handle, &m, turns ? "trigger" : "button", turns);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f)) {
        dmg_vec spot = pod_point(&body, v3_normalize(v3(0, 1, dmg_range(b, -0.4f, 0.4f))));
        dmg_move(b, 0, spot.y, spot.z);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_thumb_key_draw(b, 0, "key", r * dmg_range(b, 0.12f, 0.3f));
    }
}

/* A wand or a handle alone, with a lever along it that a finger or the whole hand presses. */
void dmg_build_squeeze_handle(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.08f, 0.35f);
    pod handle = pick_handle(b, length);
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, -DMG_PI, DMG_PI));
    draw_grip(b, &handle, 1.0f, "lever");
    if (dmg_chance(b, 0.5f)) {
        const float radius_to = handle.high.x * dmg_range(b, 0.2f, 1.6f),
                    radius_from = handle.high.x * dmg_range(b, 0.3f, 1.2f);
        const dmg_vec to = v3(0, 0, handle.high.z * dmg_range(b, 1.3f, 3.0f));
        dmg_cone(b, v3(0, 0, 0.7f * handle.high.z), to, radius_from, radius_to);
    }
    if (dmg_chance(b, 0.4f)) {
        dmg_save(b);
        dmg_vec spot = pod_point(&handle, v3_normalize(v3(0, 1, dmg_range(b, -0.2f, 0.4f))));
        dmg_move(b, 0, spot.y, spot.z);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_thumb_key_draw(b, 0, "key", handle.high.x * dmg_range(b, 0.2f, 0.45f));
        dmg_restore(b);
    }
}
