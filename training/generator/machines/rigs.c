/* Draws rigs of links: arms that a cylinder raises, toggle clamps, lazy tongs and pantographs, current collectors. A
 * cylinder's barrel swings about its foot, and its rod slides in it. */
#include "core/build.h"
#include "parts/cranks.h"
#include "parts/hardware.h"

/* Everything moves in the plane of X and Y. */
typedef struct rig {
    float size, t; /* t: thickness of links */
    dmg_crank link;
    int lugs;
} rig;

static rig pick_rig(dmg_builder* b, float low, float high) {
    rig r = {.size = dmg_scale_range(b, low, high)};
    r.t = r.size * dmg_range(b, 0.04f, 0.09f);
    r.link = dmg_crank_pick(b, r.size);
    r.link.t = r.t;
    r.link.eye = dmg_chance(b, 0.8f) ? r.t * dmg_range(b, 0.6f, 0.9f) : 0.0f;
    r.lugs = dmg_int(b, 0, 2);
    return r;
}

/* Draws two ears with a pin, a block under it, or a ball of a mount; down from `at` to y = floor. */
static void draw_lugs(dmg_builder* b, const rig* r, dmg_vec at, float floor) {
    float t = r->t, h = at.y - floor;
    dmg_rod(b, v3_add(at, v3(0, 0, -t)), v3_add(at, v3(0, 0, t)), 0.3f * t);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec foot = {at.x, floor, (float)s * 0.8f * t};
        if (r->lugs == 0)
            dmg_box(b, v3_add(foot, v3(0, 0.5f * h + 0.4f * t, 0)), v3(1.6f * t, h + 0.8f * t, 0.35f * t));
        if (r->lugs == 1) dmg_beam(b, v3_add(foot, v3(-0.8f * t, 0, 0)), v3(at.x, at.y, foot.z), 0.35f * t, 0.5f * t);
        if (r->lugs == 1) dmg_beam(b, v3_add(foot, v3(0.8f * t, 0, 0)), v3(at.x, at.y, foot.z), 0.35f * t, 0.5f * t);
    }
    if (r->lugs == 2)
        dmg_box(b, v3(at.x, floor + 0.5f * fmaxf(0.1f * t, h - 0.9f * t), 0),
                v3(2 * t, fmaxf(0.1f * t, h - 0.9f * t), 2 * t));
}

/* ---- cylinders ---- */

static float plane_angle(dmg_vec a) {
    return atan2f(a.y, a.x);
}

static dmg_vec turned(dmg_vec point, dmg_vec about, float angle) {
    return v3_add(about, v3_turn(v3_sub(point, about), v3(0, 0, 1), angle));
}

/* From `foot`, on `carrier`, to `eye`, a point of what turns about `pin` from -down to up: barrel and rod have the
 * ways that this asks of them. */
static void draw_cylinder(dmg_builder* b, const rig* r, uint32_t carrier, dmg_vec foot, dmg_vec eye, dmg_vec pin,
                          float down, float up) {
    float low = 0, high = 0, in = 0, out = 0, t = r->t;
    dmg_vec along = v3_sub(eye, foot);
    for (int i = 0; i <= 16; ++i) {
        dmg_vec at = v3_sub(turned(eye, pin, -down + (up + down) * (float)i / 16.0f), foot);
        float way = v3_length(at) - v3_length(along),
              lean = remainderf(plane_angle(at) - plane_angle(along), 2.0f * DMG_PI);
        low = fminf(low, lean);
        high = fmaxf(high, lean);
        in = fminf(in, way);
        out = fmaxf(out, way);
    }
    float length = v3_length(along), radius = t * dmg_range(b, 0.5f, 0.9f), neck = length * dmg_range(b, 0.5f, 0.7f);
    bool square = dmg_chance(b, 0.2f);
    along = v3_normalize(along);
    if (high - low < 0.03f) high = low + 0.03f;
    uint32_t barrel = dmg_hinge(b, carrier, "cylinder", foot, v3(0, 0, 1), low, high);
    dmg_rod(b, v3_add(foot, v3(0, 0, -0.6f * t)), v3_add(foot, v3(0, 0, 0.6f * t)), 0.5f * t);
    if (square)
        dmg_beam(b, foot, v3_mad(foot, along, neck), 1.7f * radius, 1.7f * radius);
    else
        dmg_rod(b, foot, v3_mad(foot, along, neck), radius);
    dmg_rod(b, v3_mad(foot, along, neck - 0.6f * t), v3_mad(foot, along, neck), 1.12f * radius);
    dmg_slide(b, barrel, "rod", along, fmaxf(in, 0.1f * length - neck), out);
    dmg_rod(b, v3_mad(foot, along, fmaxf(0.15f * length, neck - 1.2f * out - t)), eye, 0.5f * radius);
    dmg_rod(b, v3_add(eye, v3(0, 0, -0.6f * t)), v3_add(eye, v3(0, 0, 0.6f * t)), 0.5f * t);
}

/* Draws a bucket, fork, hook, platform or nothing at an arm's end. */
static void draw_load(dmg_builder* b, const rig* r, dmg_vec at, float lean) {
    float s = 3 * r->t;
    int kind = dmg_int(b, 0, 4);
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 0, 1), lean);
    const dmg_xy bucket[] = {{0, 0.4f * s}, {0, -0.4f * s}, {0.5f * s, -0.7f * s}, {1.2f * s, -0.5f * s}};
    if (kind == 0) dmg_bent_plate(b, bucket, 4, 0.1f * s, 1.6f * s);
    if (kind == 1) dmg_box(b, v3(0.3f * s, 0, 0), v3(0.8f * s, 0.8f * s, 0.8f * s));
    if (kind == 2) dmg_rod(b, v3(0, 0, -0.7f * s), v3(0, 0, 0.7f * s), 0.35f * s);
    if (kind == 3) dmg_box(b, v3(0.6f * s, 0.4f * s, 0), v3(1.8f * s, 0.12f * s, 1.6f * s));
    dmg_restore(b);
}

/* Draws a boom on lugs, raised by a cylinder; perhaps a second arm with a cylinder of its own. */
static void draw_boom(dmg_builder* b) {
    rig r = pick_rig(b, 0.08f, 2.0f);
    float s = r.size, t = r.t, lean = dmg_range(b, -0.1f, 0.9f), at = dmg_range(b, 0.35f, 0.65f),
          pinned = t * dmg_range(b, 1.5f, 4.0f);
    float down = dmg_range(b, 0.2f, fmaxf(0.25f, lean)), up = dmg_range(b, 0.3f, 1.2f - 0.5f * lean);
    bool post = dmg_chance(b, 0.5f);
    dmg_vec pin = {0, post ? 0.5f * s : pinned, 0}, tip = {s * cosf(lean), pin.y + s * sinf(lean), 0};
    dmg_vec foot = {post ? 0.5f * t : s * dmg_range(b, 0.2f, 0.35f), post ? 1.2f * t : pinned * 0.7f, 0};
    dmg_vec eye = v3_add(v3_lerp(pin, tip, at), v3(0.9f * t * sinf(lean), -0.9f * t * cosf(lean), 0));
    down = fminf(down, 0.9f * asinf(fminf(1.0f, fmaxf(0.0f, (tip.y - 4 * t) / s))) + 0.05f);
    dmg_box_span(b, v3(-0.35f * s, -0.5f * t, -3 * t), v3(0.6f * s, 0, 3 * t));
    draw_lugs(b, &r, pin, 0);
    draw_lugs(b, &r, foot, 0);
    uint32_t boom = dmg_hinge(b, 0, "boom", pin, v3(0, 0, 1), -down, up);
    dmg_link_draw(b, &r.link, pin, tip);
    dmg_beam(b, v3_lerp(pin, tip, at), eye, t, t);
    bool arm = dmg_chance(b, 0.6f);
    if (!arm) draw_load(b, &r, tip, lean - 0.3f);
    if (arm) {
        float fold = dmg_range(b, 0.6f, 1.6f), reach = dmg_range(b, 0.5f, 0.9f) * s, own = fmaxf(0.2f, 0.6f * fold);
        dmg_vec way = {cosf(lean - fold), sinf(lean - fold), 0}, end = v3_mad(tip, way, reach),
                horn = v3_mad(tip, way, -2.5f * t);
        dmg_vec base = v3_add(v3_lerp(pin, tip, 0.5f), v3(-1.6f * t * sinf(lean), 1.6f * t * cosf(lean), 0));
        dmg_beam(b, v3_lerp(pin, tip, 0.5f), base, t, t);
        dmg_hinge(b, boom, "arm", tip, v3(0, 0, 1), -0.5f * own, 0.8f * own);
        dmg_link_draw(b, &r.link, horn, end);
        draw_load(b, &r, end, lean - fold);
        draw_cylinder(b, &r, boom, base, horn, tip, 0.5f * own, 0.8f * own);
    }
    draw_cylinder(b, &r, 0, foot, eye, pin, down, up);
    dmg_use(b, 0);
}

/* ---- clamps ---- */

/* Draws a bar over a base held down by a handle with a link between; or a plunger that a handle pushes. */
static void draw_clamp(dmg_builder* b) {
    rig r = pick_rig(b, 0.04f, 0.3f);
    float s = r.size, t = r.t, h = 2.2f * t, open = dmg_range(b, 0.8f, 1.7f);
    bool upright = dmg_chance(b, 0.5f), plunger = dmg_chance(b, 0.35f);
    dmg_vec pin = {0, h, 0}, knee = {-1.5f * t, h + 2.2f * t, 0}, end = {0.8f * s, h + t, 0};
    dmg_box_span(b, v3(-3 * t, -0.5f * t, -2 * t), v3((plunger ? 4 : 3) * t, 0, 2 * t));
    draw_lugs(b, &r, pin, 0);
    float rise = upright ? 1.3f : 0.15f;
    dmg_vec grip = v3_add(plunger ? pin : knee, v3(-s * cosf(rise), s * sinf(rise), 0));
    if (plunger) {
        float y = h + 1.2f * t, way = 0.5f * s * dmg_range(b, 0.4f, 0.9f);
        dmg_tube_draw(b, v3(1.5f * t, y, 0), v3(1, 0, 0), 3 * t, 0.5f * t, 0.3f * t);
        dmg_box_span(b, v3(2 * t, 0, -0.4f * t), v3(4 * t, y - 0.7f * t, 0.4f * t));
        dmg_slide(b, 0, "plunger", v3(1, 0, 0), -0.2f * way, way);
        dmg_rod(b, v3(-0.5f * t, y, 0), v3(5.5f * t, y, 0), 0.45f * t);
        dmg_rod(b, v3(5.5f * t, y, 0), v3(6.2f * t, y, 0), t);
        dmg_use(b, 0);
        dmg_hinge(b, 0, "handle", pin, v3(0, 0, -1), -0.2f, open);
    } else {
        uint32_t bar = dmg_hinge(b, 0, "bar", pin, v3(0, 0, 1), 0.0f, open);
        dmg_beam(b, pin, v3_add(pin, v3(t, t, 0)), t, t);
        dmg_beam(b, v3_add(pin, v3(-1.5f * t, 0.9f * t, 0)), end, 0.8f * t, 0.8f * t);
        if (dmg_chance(b, 0.5f)) dmg_screw(b, bar, "spindle", end, v3(0, 1, 0), 0.02f * t, -6.0f, 12.0f);
        dmg_rod(b, v3_add(end, v3(0, -1.5f * t, 0)), v3_add(end, v3(0, t, 0)), 0.3f * t);
        dmg_rod(b, v3_add(end, v3(0, -2.0f * t, 0)), v3_add(end, v3(0, -1.4f * t, 0)), 0.7f * t);
        dmg_use(b, bar);
        dmg_hinge(b, bar, "handle", knee, v3(0, 0, dmg_sign(b)), -0.7f, 0.7f);
        pin = knee;
    }
    dmg_vec start = v3_lerp(pin, grip, 0.5f);
    dmg_link_draw(b, &r.link, pin, grip);
    if (dmg_chance(b, 0.8f)) dmg_capsule(b, start, grip, 0.8f * t);
    dmg_use(b, 0);
}

/* ---- tongs ---- */

/* Crossed bars in a row out of a wall or on a table; each pair turns on the one before, or all on the ends. */
static void draw_tongs(dmg_builder* b) {
    rig r = pick_rig(b, 0.05f, 0.8f);
    float s = r.size, t = r.t, half = dmg_range(b, 0.3f, 1.1f), x = s * cosf(half), y = s * sinf(half),
          swing = fminf(half - 0.15f, 0.4f);
    int cells = dmg_int(b, 1, 5);
    bool wall = dmg_chance(b, 0.6f);
    dmg_move(b, 0, y + 2 * t, 0);
    if (!wall) dmg_face_up(b);
    if (wall)
        dmg_box_span(b, v3(-1.5f * t, -0.8f * s - t, -1.5f * t), v3(-t, 0.8f * s + t, 1.5f * t));
    else
        dmg_box_span(b, v3(-2 * t, -s - t, -1.6f * t), v3(0.9f * x, s + t, -1.2f * t));
    for (int k = -1; k <= 1; k += 2) {
        float z = (float)k * 0.5f * t;
        dmg_vec root = {0, -(float)k * 0.5f * y, z};
        uint32_t carrier = 0;
        dmg_rod(b, v3(0, root.y, -1.2f * t), v3(0, root.y, t), 0.3f * t);
        dmg_box_span(b, v3(-t, root.y - 0.4f * t, -1.2f * t), v3(0.3f * t, root.y + 0.4f * t, -0.7f * t));
        for (int i = 0; i < cells; ++i) {
            float side = (i % 2 ? -1.0f : 1.0f) * (float)k;
            dmg_vec to = {root.x + x, root.y + side * y, z};
            float way = i ? 1.6f * swing : swing;
            carrier = dmg_hinge(b, carrier, "bar", root, v3(0, 0, dmg_sign(b)), -way, way);
            dmg_link_draw(b, &r.link, root, to);
            if (k > 0)
                dmg_rod(b, v3_lerp(root, to, 0.5f), v3_add(v3_lerp(root, to, 0.5f), v3(0, 0, -1.1f * t)), 0.3f * t);
            root = to;
        }
        if (k < 0 && dmg_chance(b, 0.6f)) draw_load(b, &r, root, 0.0f);
        dmg_use(b, 0);
    }
}

/* ---- current collectors ---- */

/* Draws a frame on insulators, a lower arm, an upper arm that folds the other way, a head kept level with its strips.
 */
static void draw_collector(dmg_builder* b) {
    rig r = pick_rig(b, 0.15f, 1.6f);
    float s = r.size, t = 0.7f * r.t, wide = s * dmg_range(b, 0.25f, 0.5f), a = dmg_range(b, 0.25f, 0.8f),
          c = dmg_range(b, 0.25f, 0.8f), h = 2.5f * t, head = s * dmg_range(b, 0.4f, 0.7f);
    bool twin = dmg_chance(b, 0.4f);
    for (int i = 0; i < 4; ++i) {
        float sx = i % 2 ? 1.0f : -1.0f, sz = i / 2 ? 1.0f : -1.0f;
        dmg_cone(b, v3(0.5f * sx * s, 0, sz * wide), v3(0.5f * sx * s, h, sz * wide), t, 0.6f * t);
        if (sx > 0) dmg_box(b, v3(0, h, sz * wide), v3(1.1f * s, t, t));
        if (sz > 0) dmg_box(b, v3(0.5f * sx * s, h, 0), v3(t, t, 2 * wide));
    }
    dmg_vec pin = {0.4f * s, h + 1.2f * t, 0}, elbow = {pin.x - s * cosf(a), pin.y + s * sinf(a), 0},
            top = {elbow.x + 0.95f * s * cosf(c), elbow.y + 0.95f * s * sinf(c), 0};
    dmg_rod(b, v3(pin.x, pin.y - 0.4f * t, -wide), v3(pin.x, pin.y - 0.4f * t, wide), 0.3f * t);
    uint32_t lower = dmg_hinge(b, 0, "lower_arm", pin, v3(0, 0, -1), 0.1f - a, 1.2f - a);
    dmg_rod(b, v3(pin.x, pin.y, -0.7f * wide), v3(pin.x, pin.y, 0.7f * wide), 0.5f * t);
    for (int k = -1; k <= 1; k += 2) {
        float z = twin ? (float)k * 0.5f * wide : 0.0f;
        if (twin || k > 0) dmg_beam(b, v3_add(pin, v3(0, 0, z)), v3_add(elbow, v3(0, 0, 0.7f * z)), t, t);
    }
    uint32_t upper = dmg_hinge(b, lower, "upper_arm", elbow, v3(0, 0, 1), -0.6f, 0.6f);
    dmg_rod(b, v3_add(elbow, v3(0, 0, -0.5f * wide)), v3_add(elbow, v3(0, 0, 0.5f * wide)), 0.5f * t);
    for (int k = -1; k <= 1; k += 2)
        dmg_rod(b, v3_add(elbow, v3(0, 0, (float)k * 0.3f * wide)), v3_add(top, v3(0, 0, (float)k * 0.3f * wide)),
                0.3f * t);
    if (dmg_chance(b, 0.8f)) dmg_hinge(b, upper, "head", top, v3(0, 0, dmg_sign(b)), -0.4f, 0.4f);
    dmg_rod(b, v3_add(top, v3(0, 0, -0.4f * wide)), v3_add(top, v3(0, 0, 0.4f * wide)), 0.4f * t);
    for (int k = -1; k <= 1; k += 2) {
        float x = top.x + (float)k * 2 * t, y = top.y + 1.2f * t;
        dmg_beam(b, top, v3(x, y, 0), 0.6f * t, 0.4f * t);
        dmg_box(b, v3(x, y, 0), v3(0.8f * t, 0.6f * t, 2 * head));
        for (int e = -1; e <= 1; e += 2)
            dmg_beam(b, v3(x, y, (float)e * head), v3(x, y - 1.8f * t, (float)e * (head + 2.5f * t)), 0.6f * t,
                     0.6f * t);
    }
    dmg_use(b, 0);
}

void dmg_build_link_rig(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){0.45f, 0.2f, 0.2f, 0.15f}, 4);
    if (kind == 0) draw_boom(b);
    if (kind == 1) draw_clamp(b);
    if (kind == 2) draw_tongs(b);
    if (kind == 3) draw_collector(b);
}
