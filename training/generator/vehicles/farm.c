/* Draws farm machines: tractors with a bonnet and a linkage that carries tools behind, combines with a header, a
 * reel and a pipe that swings out, tools whose wings fold. Ahead is +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

typedef struct farm {
    float size, wheel, small, half, deck; /* big and small wheels, half the track, top of the frame */
} farm;

/* ---- tools: the headstock's plane is z = 0, they trail to -Z; y = 0 is the lower pins ---- */

/* Draws a frame across with wings that fold up, or back; tines, discs or nozzles under it. */
static void draw_winged_tool(dmg_builder* b, const farm* f, uint32_t carrier) {
    float half = f->half * dmg_range(b, 0.7f, 1.0f), wing = f->size * dmg_range(b, 0.4f, 1.0f), r = 0.03f * f->size;
    float z = -0.25f * f->size, low = -dmg_range(b, 0.12f, 0.22f) * f->size, most = dmg_range(b, 1.2f, 1.8f);
    int feet = dmg_int(b, 0, 2), count = dmg_int(b, 3, 6);
    bool back = dmg_chance(b, 0.3f);
    dmg_use(b, carrier);
    dmg_box_span(b, v3(-half, -r, z - r), v3(half, r, z + r));
    for (int k = -1; k <= 1; ++k) {
        uint32_t part = carrier;
        float from = k ? (float)k * (half + 0.3f * r) : -half, to = k ? (float)k * (half + wing) : half;
        if (k) {
            dmg_vec pin = {from, back ? 0.0f : 1.2f * r, back ? z - 1.2f * r : z};
            part = dmg_hinge(b, carrier, "wing", pin, back ? v3(0, (float)k, 0) : v3(0, 0, (float)k), 0.0f, most);
            dmg_box_span(b, v3(fminf(from, to), -r, z - r), v3(fmaxf(from, to), r, z + r));
        }
        for (int i = 0; i < count; ++i) {
            float x = from + (to - from) * ((float)i + 0.5f) / (float)count;
            if (feet == 0) {
                const dmg_vec tine[] = {
                    {x, 0, z}, {x, 0.3f * low, z - 3 * r}, {x, 0.8f * low, z - 2 * r}, {x, low, z + r}};
                dmg_sweep(b, tine, 4, 0.3f * r, 0.5f * r, false);
            }
            if (feet == 1) {
                dmg_beam(b, v3(x, 0, z), v3(x, 0.5f * low, z - r), 0.5f * r, 0.8f * r);
                if (i % 2 == 0) dmg_spin(b, part, "disc", v3(x, 0.5f * low, z - r), v3(1, 0, 0));
                dmg_rod(b, v3(x - 0.2f * r, 0.5f * low, z - r), v3(x + 0.2f * r, 0.5f * low, z - r), -0.5f * low);
                dmg_use(b, part);
            }
            if (feet == 2) dmg_cone(b, v3(x, -r, z), v3(x, -2.5f * r, z), 0.6f * r, 0.2f * r);
        }
    }
    dmg_use(b, carrier);
}

/* Shares on both sides of a beam, turned over about its length. */
static void draw_plough(dmg_builder* b, const farm* f, uint32_t carrier) {
    float r = 0.04f * f->size, long_ = f->size * dmg_range(b, 0.5f, 1.1f), share = 0.2f * f->size;
    int count = dmg_int(b, 2, 5);
    dmg_use(b, carrier);
    dmg_rod(b, v3(0, 0.12f * f->size, 0), v3(0, 0.12f * f->size, -0.15f * f->size), 1.6f * r);
    uint32_t beam = dmg_hinge(b, carrier, "plough", v3(0, 0.12f * f->size, 0), v3(0, 0, dmg_sign(b)), 0.0f, DMG_PI);
    dmg_move(b, 0, 0.12f * f->size, -0.16f * f->size);
    dmg_beam(b, v3(0, 0, 0), v3(0.25f * long_, 0, -long_), 2 * r, 2 * r);
    for (int i = 0; i < count; ++i) {
        float at = ((float)i + 0.5f) / (float)count;
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec root = {0.25f * long_ * at, 0, -long_ * at}, tip = v3_add(root, v3(0, (float)s * share, 0));
            dmg_beam(b, root, tip, 0.8f * r, 1.2f * r);
            dmg_beam(b, v3_add(tip, v3(-0.05f * f->size, 0, 0.07f * f->size)),
                     v3_add(tip, v3(0.06f * f->size, (float)s * -0.04f * f->size, -0.08f * f->size)), 0.5f * r,
                     0.12f * f->size);
        }
    }
    dmg_move(b, 0, -0.12f * f->size, 0.16f * f->size);
    dmg_use(b, beam);
}

/* ---- the linkage: two lower arms with links, a top bar, perhaps a tool on all of them ---- */

static void draw_linkage(dmg_builder* b, const farm* f, float z) {
    float reach = 0.4f * f->size, y = 0.75f * f->wheel, x0 = 0.1f * f->size, x1 = 0.2f * f->size, r = 0.022f * f->size;
    int tool = dmg_int(b, 0, 3);
    bool one = tool < 2; /* the arms go up as one with what they carry */
    uint32_t lift = 0;
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec root = {(float)s * x0, y, z}, end = {(float)s * x1, y - 0.05f * f->size, z - reach};
        dmg_use(b, 0);
        dmg_box(b, root, v3(3 * r, 3 * r, 3 * r));
        if (!lift || !one) lift = dmg_hinge_across(b, 0, "lift_arm", v3(0, y, z), -0.7f, 0.15f);
        dmg_use(b, lift);
        dmg_beam(b, root, end, 1.2f * r, 2.2f * r);
        dmg_ellipsoid(b, end, v3(1.2f * r, 1.6f * r, 1.6f * r));
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3_lerp(root, end, 0.6f),
                    v3_lerp(v3_lerp(root, end, 0.5f), v3((float)s * x0, y + 0.25f * f->size, z - 0.1f * f->size), 0.8f),
                    0.7f * r);
    }
    dmg_vec top = {0, y + 0.2f * f->size, z - 0.01f * f->size}, hook = {0, y + 0.22f * f->size, z - 0.9f * reach};
    dmg_use(b, 0);
    dmg_box(b, top, v3(3 * r, 4 * r, 4 * r));
    if (!one) {
        dmg_hinge_across(b, 0, "top_link", top, -0.5f, 0.9f);
        dmg_rod(b, top, hook, r);
        dmg_rod(b, v3_lerp(top, hook, 0.25f), v3_lerp(top, hook, 0.75f), 1.7f * r);
        dmg_use(b, 0);
        return;
    }
    dmg_use(b, lift);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * x1, y - 0.06f * f->size, z - reach), v3(0, y + 0.24f * f->size, z - reach), 2 * r,
                 2 * r);
    dmg_rod(b, v3(-1.2f * x1, y - 0.05f * f->size, z - reach), v3(1.2f * x1, y - 0.05f * f->size, z - reach), 1.3f * r);
    dmg_save(b);
    dmg_move(b, 0, y - 0.05f * f->size, z - reach);
    if (tool == 0) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * x1 - r, -r, -0.25f * f->size), v3((float)s * x1 + r, r, 0));
        draw_winged_tool(b, f, lift);
    } else
        draw_plough(b, f, lift);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- tractor ---- */

static void draw_bonnet(dmg_builder* b, const farm* f, float z0, float z1) {
    float x = 0.26f * f->size, low = f->deck, high = f->deck + 0.42f * f->size, t = 0.02f * f->size;
    int kind = dmg_int(b, 0, 2); /* from the nose, from the cab, wings at the sides */
    dmg_box_span(b, v3(-0.8f * x, low, z0), v3(0.8f * x, high - 3 * t, z1 - 2 * t));
    const dmg_xy hood[] = {{z0 + t, high - 2 * t}, {z1, high - 4 * t}, {z1, high - t}, {z0 + t, high + t}};
    if (kind == 0) dmg_hinge_across(b, 0, "bonnet", v3(0, high - 3 * t, z1 - t), -dmg_range(b, 0.6f, 1.2f), 0.0f);
    if (kind == 1) dmg_hinge_across(b, 0, "bonnet", v3(0, high, z0 + t), 0.0f, dmg_range(b, 0.6f, 1.2f));
    dmg_side_prism(b, hood, 4, -x, x);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, x0 = side * 0.82f * x, x1 = side * x;
        if (kind == 2)
            dmg_hinge(b, 0, "side_panel", v3(x1, high - 4 * t, 0), v3(0, 0, side), 0.0f, dmg_range(b, 0.8f, 1.6f));
        dmg_box_span(b, v3(fminf(x0, x1), low + 4 * t, z0 + 2 * t), v3(fmaxf(x0, x1), high - 5 * t, z1 - 3 * t));
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) { /* the exhaust, a flap on it */
        float px = 1.25f * x, pz = z0 + 0.3f * (z1 - z0), top = high + 0.5f * f->size;
        dmg_rod(b, v3(px, low, pz), v3(px, top, pz), 0.035f * f->size);
        dmg_hinge(b, 0, "exhaust_flap", v3(px, top, pz - 0.04f * f->size), v3(-1, 0, 0), 0.0f,
                  dmg_range(b, 0.7f, 1.4f));
        dmg_rod(b, v3(px, top + 0.002f * f->size, pz), v3(px, top + 0.012f * f->size, pz), 0.04f * f->size);
        dmg_use(b, 0);
    }
}

static void draw_open_seat(dmg_builder* b, const farm* f, float z) {
    float y = f->deck + 0.3f * f->size, s = 0.12f * f->size;
    dmg_rod(b, v3(0, f->deck, z), v3(0, y - 0.3f * s, z), 0.3f * s);
    dmg_hinge_across(b, 0, "seat", v3(0, y - 0.3f * s, z + s), -dmg_range(b, 0.4f, 1.0f), 0.0f);
    dmg_rounded_box(b, v3(0, y, z), v3(2.2f * s, 0.5f * s, 2 * s), 0.15f * s);
    dmg_beam(b, v3(0, y, z - 0.9f * s), v3(0, y + 2 * s, z - 1.2f * s), 2.2f * s, 0.4f * s);
    dmg_use(b, 0);
    for (int k = -1; k <= 1; k += 2) { /* the bow over him: folds back at half its height */
        dmg_vec foot = {(float)k * 0.28f * f->size, f->deck, z - 0.2f * f->size};
        dmg_beam(b, foot, v3_add(foot, v3(0, 0.5f * f->size, 0)), 0.04f * f->size, 0.04f * f->size);
    }
    float bend = f->deck + 0.52f * f->size, x = 0.28f * f->size, zb = z - 0.2f * f->size;
    if (dmg_chance(b, 0.7f)) dmg_hinge_across(b, 0, "roll_bar", v3(0, bend, zb), 0.0f, dmg_range(b, 1.5f, 2.6f));
    const dmg_vec bow[] = {{-x, bend - 0.02f * f->size, zb},
                           {-x, bend + 0.4f * f->size, zb},
                           {x, bend + 0.4f * f->size, zb},
                           {x, bend - 0.02f * f->size, zb}};
    dmg_sweep(b, bow, 4, 0.02f * f->size, 0.02f * f->size, false);
    dmg_use(b, 0);
}

static void draw_steering(dmg_builder* b, const farm* f, float z) {
    float y = f->deck + 0.45f * f->size, r = 0.12f * f->size;
    dmg_save(b);
    dmg_move(b, 0, y, z);
    dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.7f, 1.2f));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 2.5f * r), 0.1f * r);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_hinge(b, 0, "steering_wheel", v3(0, 0, 0), v3(0, 0, 1), -4.0f, 4.0f);
    dmg_wheel_draw(b, 3, r, 0.2f * r, dmg_int(b, 3, 4));
    dmg_restore(b);
    dmg_use(b, 0);
}

static void build_tractor(dmg_builder* b, const farm* f) {
    float front = f->size * dmg_range(b, 0.75f, 1.0f), nose = front + 0.2f * f->size, cab = 0.25f * f->size;
    dmg_tyre rear = dmg_tyre_pick(b, f->wheel), fore = rear;
    rear.width = f->wheel * dmg_range(b, 0.4f, 0.75f);
    fore.radius = f->small;
    fore.width = f->small * dmg_range(b, 0.4f, 0.8f);
    fore.steers = true;
    dmg_box_span(b, v3(-0.18f * f->size, 0.6f * f->wheel, -0.2f * f->size),
                 v3(0.18f * f->size, f->deck, nose - 0.02f * f->size));
    dmg_axle_draw(b, &rear, 0, f->half + 0.5f * rear.width, 0);
    dmg_axle_draw(b, &fore, 0, 0.26f * f->size + fore.width, front);
    draw_bonnet(b, f, cab + 0.05f * f->size, nose);
    for (int s = -1; s <= 1; s += 2) { /* wings over the big wheels */
        float x = (float)s * (f->half + 0.5f * rear.width), y = 2.08f * f->wheel;
        dmg_box(b, v3(x, y, 0), v3(rear.width, 0.03f * f->size, 1.2f * f->wheel));
        dmg_box_span(b, v3(fminf((float)s * 0.1f * f->size, x), y - 0.02f * f->size, -0.05f * f->size),
                     v3(fmaxf((float)s * 0.1f * f->size, x), y + 0.01f * f->size, 0.05f * f->size));
        dmg_box(b, v3((float)s * 0.3f * f->size, 0.5f * (f->deck + y), 0),
                v3(0.05f * f->size, y - f->deck, 0.2f * f->size));
    }
    if (dmg_chance(b, 0.6f)) {
        dmg_cab shell = dmg_cab_pick(b, v3(-0.34f * f->size, f->deck, -0.35f * f->size),
                                     v3(0.34f * f->size, f->deck + 0.95f * f->size, cab));
        dmg_cab_draw(b, &shell, 0);
    } else {
        draw_open_seat(b, f, -0.1f * f->size);
        draw_steering(b, f, 0.12f * f->size);
    }
    draw_linkage(b, f, -0.22f * f->size);
}

/* ---- combine ---- */

/* Before it: a trough with a screw, a knife, a reel on two arms; all of it goes up with the feeder. */
static void draw_header(dmg_builder* b, const farm* f, float z) {
    float half = f->half * dmg_range(b, 1.3f, 2.2f), y = 0.35f * f->size, r = 0.13f * f->size, t = 0.02f * f->size;
    dmg_vec pin = {0, f->deck + 0.1f * f->size, z};
    uint32_t header = dmg_hinge_across(b, 0, "header", pin, -0.15f, dmg_range(b, 0.2f, 0.45f));
    dmg_beam(b, pin, v3(0, y, z + 0.45f * f->size), 0.3f * f->size, 0.2f * f->size);
    float at = z + 0.45f * f->size;
    const dmg_xy trough[] = {
        {at, y + 2.2f * r}, {at, y - 0.5f * r}, {at + 0.5f * r, y - 1.2f * r}, {at + 3.5f * r, y - 1.4f * r}};
    dmg_side_sheet(b, trough, 4, t, 2 * half);
    const dmg_xy end[] = {{at, y - r}, {at + 4.2f * r, y - 1.45f * r}, {at + 2 * r, y + 1.2f * r}, {at, y + 2.2f * r}};
    for (int s = -1; s <= 1; s += 2) dmg_side_prism(b, end, 4, (float)s * half, (float)s * (half + t));
    dmg_vec screw = {0, y, at + 1.3f * r};
    dmg_spin(b, header, "screw", screw, v3(1, 0, 0));
    dmg_rod(b, v3(-0.98f * half, screw.y, screw.z), v3(0.98f * half, screw.y, screw.z), 0.4f * r);
    for (int i = 0; i < 9; ++i) {
        float x = half * (-0.9f + 0.225f * (float)i);
        dmg_beam(b, v3(x - 0.04f * half, screw.y, screw.z), v3(x + 0.04f * half, screw.y, screw.z), 1.5f * r, 1.5f * r);
    }
    dmg_use(b, header);
    dmg_vec axle = {0, y + 2.6f * r, at + 3.4f * r};
    dmg_vec root = {0, y + 2.2f * r, at};
    uint32_t arms = dmg_chance(b, 0.7f) ? dmg_hinge_across(b, header, "reel_arms", root, -0.1f, 0.5f) : header;
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * (half + 2 * t), root.y, root.z), v3((float)s * (half + 2 * t), axle.y, axle.z), t,
                 2 * t);
    dmg_rod(b, v3(-half - 2 * t, root.y, root.z), v3(half + 2 * t, root.y, root.z), 0.7f * t);
    dmg_spin(b, arms, "reel", axle, v3(1, 0, 0));
    int bats = dmg_int(b, 4, 6);
    dmg_rod(b, v3(-half - 2 * t, axle.y, axle.z), v3(half + 2 * t, axle.y, axle.z), 0.8f * t);
    for (int i = 0; i < bats; ++i) {
        float angle = 2 * DMG_PI * (float)i / (float)bats, c = 1.7f * r * cosf(angle), d = 1.7f * r * sinf(angle);
        dmg_rod(b, v3(-0.95f * half, axle.y + c, axle.z + d), v3(0.95f * half, axle.y + c, axle.z + d), 0.7f * t);
        for (int s = -1; s <= 1; ++s)
            dmg_beam(b, v3((float)s * 0.9f * half, axle.y, axle.z), v3((float)s * 0.9f * half, axle.y + c, axle.z + d),
                     0.5f * t, 0.8f * t);
    }
    dmg_use(b, 0);
}

/* Draws what opens on its body: the pipe swings out, tank flaps on the roof, panels at the sides, the hood behind, a
 * ladder. */
static void draw_combine_parts(dmg_builder* b, const farm* f, float z0, float z1, float top) {
    float x = f->half, r = 0.06f * f->size, t = 0.025f * f->size;
    dmg_vec foot = {x + 1.4f * r, top - 0.2f * f->size, z1 - 0.3f * f->size};
    dmg_rod(b, v3(foot.x, f->deck + 0.2f * f->size, foot.z), foot, 1.1f * r);
    dmg_box_span(b, v3(0.8f * x, f->deck + 0.2f * f->size, foot.z - r),
                 v3(foot.x, f->deck + 0.3f * f->size, foot.z + r));
    dmg_hinge(b, 0, "pipe", foot, v3(0, -1, 0), 0.0f, dmg_range(b, 1.3f, 1.8f));
    dmg_rod(b, foot, v3_add(foot, v3(0, 1.5f * r, 0)), 1.1f * r);
    dmg_rod(b, v3_add(foot, v3(0, 1.2f * r, 0)), v3(foot.x, foot.y + 0.15f * f->size, z0 - 0.1f * f->size), r);
    dmg_use(b, 0);
    int flaps = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1 && flaps; s += 2) {
        float side = (float)s, in = 0.02f * x;
        dmg_hinge(b, 0, "tank_flap", v3(side * 0.8f * x, top + 0.5f * t, 0), v3(0, 0, -side), 0.0f,
                  dmg_range(b, 0.8f, 2.2f));
        dmg_box_span(b, v3(fminf(side * in, side * 0.8f * x), top + 0.01f * t, z1 - 0.6f * f->size),
                     v3(fmaxf(side * in, side * 0.8f * x), top + t, z1 - 0.05f * f->size));
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, x0 = side * x, x1 = side * (x + t), low = f->deck + 0.3f * f->size,
              high = top - 0.25f * f->size, back = z0 + 0.1f * f->size, fore = z1 - 0.5f * f->size;
        int kind = dmg_int(b, 0, 2);
        if (kind == 0) dmg_hinge(b, 0, "side_panel", v3(x1, high, 0), v3(0, 0, side), 0.0f, dmg_range(b, 0.9f, 1.6f));
        if (kind == 1) dmg_hinge(b, 0, "side_panel", v3(x1, 0, back), v3(0, side, 0), 0.0f, dmg_range(b, 0.9f, 1.6f));
        if (kind < 2) dmg_box_span(b, v3(fminf(x0, x1), low, back), v3(fmaxf(x0, x1), high, fore));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.6f)) { /* the straw hood */
        dmg_hinge_across(b, 0, "hood", v3(0, top - 0.1f * f->size, z0), -dmg_range(b, 0.5f, 1.1f), 0.0f);
        dmg_box_span(b, v3(-0.9f * x, f->deck, z0 - t), v3(0.9f * x, top - 0.1f * f->size, z0));
        dmg_use(b, 0);
    }
    dmg_vec rung = {-x - 0.05f * f->size, f->deck + 0.3f * f->size, z1 - 0.1f * f->size};
    if (dmg_chance(b, 0.6f)) dmg_hinge(b, 0, "ladder", rung, v3(0, dmg_sign(b), 0), -1.2f, 1.2f);
    for (int k = -1; k <= 1; k += 2)
        dmg_rod(b, v3_add(rung, v3(-0.1f * f->size + 0.1f * f->size * (float)k, 0, 0)),
                v3_add(rung, v3(-0.1f * f->size + 0.1f * f->size * (float)k, -0.6f * f->deck, 0)), 0.015f * f->size);
    for (int i = 0; i < 4; ++i)
        dmg_box(b, v3_add(rung, v3(-0.1f * f->size, -0.15f * f->deck * (float)i, 0)),
                v3(0.2f * f->size, 0.015f * f->size, 0.05f * f->size));
    dmg_use(b, 0);
}

static void build_combine(dmg_builder* b, const farm* f) {
    float long_ = f->size * dmg_range(b, 1.4f, 1.9f), top = f->deck + f->size * dmg_range(b, 0.75f, 1.0f),
          z1 = 0.25f * f->size, z0 = z1 - long_;
    dmg_tyre fore = dmg_tyre_pick(b, f->wheel), rear = fore;
    fore.width = f->wheel * dmg_range(b, 0.5f, 0.9f);
    rear.radius = f->small;
    rear.width = 0.5f * f->small;
    rear.steers = dmg_chance(b, 0.8f);
    const dmg_xy body[] = {{z0, f->deck + 0.1f * f->size}, {z0 + 0.3f * long_, f->deck}, {z1, f->deck}, {z1, top},
                           {z0 + 0.2f * long_, top},       {z0, top - 0.1f * f->size}};
    dmg_side_prism(b, body, 6, -f->half, f->half);
    dmg_box_span(b, v3(-0.2f * f->size, 0.8f * f->small, z0 + 0.15f * f->size),
                 v3(0.2f * f->size, f->deck + 0.05f * f->size, z1));
    dmg_axle_draw(b, &fore, 0, f->half + 0.55f * fore.width, 0);
    dmg_axle_draw(b, &rear, 0, 0.7f * f->half, z0 + 0.3f * f->size);
    dmg_cab cab = dmg_cab_pick(b, v3(-0.35f * f->size, f->deck + 0.25f * f->size, z1),
                               v3(0.35f * f->size, f->deck + 1.0f * f->size, z1 + 0.45f * f->size));
    dmg_cab_draw(b, &cab, 0);
    draw_combine_parts(b, f, z0, z1, top);
    draw_header(b, f, z1 + 0.03f * f->size);
}

/* ---- a tool alone, on a drawbar and two wheels ---- */

static void build_trailed_tool(dmg_builder* b, const farm* f) {
    float y = 1.3f * f->small, r = 0.03f * f->size;
    dmg_tyre t = dmg_tyre_pick(b, f->small);
    dmg_axle_draw(b, &t, 0, 0.5f * f->half, 0.25f * f->size);
    dmg_box_span(b, v3(-0.3f * f->half, f->small - r, 0.0f), v3(0.3f * f->half, y + r, 0.5f * f->size));
    uint32_t bar = dmg_chance(b, 0.6f) ? dmg_hinge_across(b, 0, "drawbar", v3(0, y, 0.5f * f->size), -0.2f, 0.8f) : 0;
    dmg_beam(b, v3(0, y, 0.5f * f->size), v3(0, 0.8f * y, 1.3f * f->size), 2 * r, 2.5f * r);
    dmg_torus(b, v3(0, 0.8f * y, 1.3f * f->size + 2 * r), v3(0, 1, 0), 2 * r, 0.7f * r);
    dmg_vec leg = {2.4f * r, 0.9f * y, 1.0f * f->size};
    dmg_box(b, v3_add(leg, v3(-0.7f * r, 0, 0)), v3(2.5f * r, 2 * r, 2 * r));
    if (dmg_chance(b, 0.5f))
        dmg_slide(b, bar, "prop", v3(0, 1, 0), -0.05f * y, 0.5f * y);
    else
        dmg_hinge_across(b, bar, "prop", leg, -1.5f, 0.0f);
    dmg_rod(b, v3(leg.x + r, 0.02f * y, leg.z), v3(leg.x + r, 1.2f * y, leg.z), 0.8f * r);
    dmg_rod(b, v3(leg.x + r, 0, leg.z), v3(leg.x + r, 0.05f * y, leg.z), 2 * r);
    dmg_use(b, 0);
    uint32_t lift = dmg_chance(b, 0.5f) ? dmg_hinge_across(b, 0, "tool_frame", v3(0, y, 0), -0.6f, 0.0f) : 0;
    dmg_box_span(b, v3(-2 * r, y - r, -0.25f * f->size), v3(2 * r, y + r, -0.3f * r));
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    draw_winged_tool(b, f, lift);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_farm_machine(dmg_builder* b) {
    farm f = {.size = dmg_scale_range(b, 0.08f, 2.2f)};
    f.wheel = f.size * dmg_range(b, 0.32f, 0.45f);
    f.small = f.size * dmg_range(b, 0.2f, 0.28f);
    f.half = f.size * dmg_range(b, 0.34f, 0.45f);
    f.deck = f.wheel * dmg_range(b, 1.4f, 1.7f);
    int kind = dmg_weighted(b, (const float[]){4, 3, 2}, 3);
    if (kind == 0) build_tractor(b, &f);
    if (kind == 1) build_combine(b, &f);
    if (kind == 2) build_trailed_tool(b, &f);
}
