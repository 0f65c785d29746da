/* Draws clothes airers: frames of thin bars on folding legs, towers of racks, umbrella lines, wall racks. */
#include "core/build.h"
#include "parts/hardware.h"

/* Lengths in metres. */
typedef struct airer {
    float wide, deep, tall; /* half, half, whole */
    float r;                /* of the frame's tubes */
    bool round;             /* tubes, or square bars */
    int bars;               /* across a frame */
    bool along;             /* those run away from the frame's line, not along it */
} airer;

static airer pick_airer(dmg_builder* b) {
    airer a = {.tall = dmg_scale_range(b, 0.6f, 1.8f)};
    a.wide = a.tall * dmg_range(b, 0.22f, 0.45f);
    a.deep = a.tall * dmg_range(b, 0.2f, 0.4f);
    a.r = a.tall * dmg_range(b, 0.006f, 0.016f);
    a.round = dmg_chance(b, 0.6f);
    a.bars = dmg_int(b, 2, 9);
    a.along = dmg_chance(b, 0.3f);
    return a;
}

static void bar(dmg_builder* b, const airer* a, dmg_vec from, dmg_vec to, float r) {
    if (a->round)
        dmg_rod(b, from, to, r);
    else
        dmg_beam(b, from, to, 1.8f * r, 1.8f * r);
}

/* Draws a frame of bars in the plane y = 0 from x = `from` to x = `to`, `half` to either side in z. */
static void draw_rack(dmg_builder* b, const airer* a, float from, float to, float half) {
    bar(b, a, v3(from, 0, -half), v3(to, 0, -half), a->r);
    bar(b, a, v3(from, 0, half), v3(to, 0, half), a->r);
    bar(b, a, v3(to, 0, -half), v3(to, 0, half), a->r);
    bar(b, a, v3(from, 0, -half), v3(from, 0, half), a->r);
    for (int i = 1; i <= a->bars; ++i) {
        float share = (float)i / (float)(a->bars + 1), x = from + (to - from) * share, z = half * (2.0f * share - 1.0f);
        if (a->along)
            bar(b, a, v3(from, 0, z), v3(to, 0, z), 0.45f * a->r);
        else
            bar(b, a, v3(x, 0, -half), v3(x, 0, half), 0.45f * a->r);
    }
}

/* Draws a leg frame from the line x = 0, y = 0 down to (x, y): two tubes and what joins them. */
static void draw_leg_frame(dmg_builder* b, const airer* a, float x, float y, float half) {
    for (int s = -1; s <= 1; s += 2) bar(b, a, v3(0, 0, (float)s * half), v3(x, y, (float)s * half), a->r);
    bar(b, a, v3(x, y, -half), v3(x, y, half), a->r);
    if (dmg_chance(b, 0.5f)) bar(b, a, v3(0.7f * x, 0.7f * y, -half), v3(0.7f * x, 0.7f * y, half), 0.8f * a->r);
    if (dmg_chance(b, 0.4f))
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(x, y, (float)s * half - 2 * a->r), v3(x, y, (float)s * half + 2 * a->r), 1.7f * a->r);
}

/* Draws a wing beside the line x = 0, level when at 0: it hangs, lies level or stands up; a stay below it sometimes. */
static void draw_wing(dmg_builder* b, const airer* a, uint32_t parent, float reach, float half, float hang) {
    float lift = dmg_chance(b, 0.5f) ? 0.05f : dmg_range(b, 0.2f, 1.2f);
    uint32_t wing = dmg_hinge(b, parent, "wing", v3(0, 0, 0), v3(0, 0, 1), -hang, lift);
    int rest = dmg_int(b, 0, 3);
    dmg_rest(b, wing, rest == 0 ? -hang : (rest == 1 ? 0.7f * lift : 0.0f));
    draw_rack(b, a, 1.2f * a->r, reach, half);
    dmg_rod(b, v3(0, 0, -half), v3(0, 0, -half + 4 * a->r), 1.4f * a->r);
    dmg_rod(b, v3(0, 0, half - 4 * a->r), v3(0, 0, half), 1.4f * a->r);
    if (rest < 2 || !dmg_chance(b, 0.5f)) return;
    float at = reach * dmg_range(b, 0.4f, 0.7f), z = 0.6f * half;
    dmg_hinge(b, wing, "stay", v3(at, -a->r, 0), v3(0, 0, -1), -0.4f, 1.0f);
    for (int s = -1; s <= 1; s += 2)
        bar(b, a, v3(at, -a->r, (float)s * z), v3(0.1f * reach, -at, (float)s * z), 0.6f * a->r);
    bar(b, a, v3(at, -a->r, -z), v3(at, -a->r, z), 0.6f * a->r);
}

/* ---- a level frame with a wing at either side, on crossed or splayed legs ---- */

static void draw_winged(dmg_builder* b, const airer* a) {
    bool crossed = dmg_chance(b, 0.5f);
    float y = a->tall, x = a->wide, splay = crossed ? -1.7f * x : x * dmg_range(b, 0.0f, 0.3f),
          inner = a->deep - 2.5f * a->r;
    float reach = fminf(0.9f * y, a->wide * dmg_range(b, 0.8f, 2.0f)), fold = dmg_range(b, 0.5f, 1.3f);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    draw_rack(b, a, -x, x, a->deep);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2) { /* drawn for the right one, seen in a mirror for the left one */
        dmg_save(b);
        if (s < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, x, y, 0);
        float half = s < 0 ? inner : inner - (crossed ? 2.5f * a->r : 0.0f);
        bool still = crossed && s < 0; /* the other leg turns about where they cross, or at the top */
        dmg_use(b, 0);
        if (!still && crossed && dmg_chance(b, 0.5f)) {
            float low = (y - a->r) / 1.7f;
            dmg_hinge(b, 0, "legs", v3(-x, -low, 0), v3(0, 0, 1), 0.0f, 0.5f * fold);
        } else if (!still) {
            dmg_hinge(b, 0, "legs", v3(0, 0, 0), v3(0, 0, crossed ? 1.0f : -1.0f), crossed ? -0.05f : 0.0f,
                      crossed ? 0.6f * fold : fold);
        }
        draw_leg_frame(b, a, splay, -y + a->r, half);
        float hang = crossed ? 1.4f : 1.3f - atan2f(splay, y);
        dmg_use(b, 0);
        draw_wing(b, a, 0, reach, a->deep, hang);
        dmg_restore(b);
    }
}

/* ---- a tower: uprights at both ends, racks that fold against them ---- */

static void draw_tower_foot(dmg_builder* b, const airer* a, float x) {
    bool rolls = dmg_chance(b, 0.5f), folds = dmg_chance(b, 0.4f);
    float wheel = 3.0f * a->r, y = rolls ? 2.0f * wheel : a->r;
    uint32_t foot = 0;
    if (folds) foot = dmg_hinge(b, 0, "foot", v3(x, y, 0), v3(0, 1, 0), 0.0f, 1.57f);
    bar(b, a, v3(x, y, -a->deep), v3(x, y, a->deep), 1.2f * a->r);
    for (int s = -1; s <= 1 && rolls; s += 2) {
        float z = 0.9f * (float)s * a->deep, trail = 0.4f * wheel;
        uint32_t caster = dmg_spin(b, foot, "caster", v3(x, y, z), v3(0, 1, 0));
        dmg_box_span(b, v3(x - 0.6f * wheel, wheel, z - 0.8f * wheel),
                     v3(x - 0.4f * wheel, y - a->r, z + 0.5f * wheel));
        dmg_box_span(b, v3(x + 0.4f * wheel, wheel, z - 0.8f * wheel),
                     v3(x + 0.6f * wheel, y - a->r, z + 0.5f * wheel));
        dmg_box_span(b, v3(x - 0.6f * wheel, y - 1.8f * a->r, z - 0.8f * wheel),
                     v3(x + 0.6f * wheel, y - a->r, z + 0.5f * wheel));
        dmg_spin(b, caster, "wheel", v3(x, wheel, z - trail), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.35f * wheel, wheel, z - trail), v3(x + 0.35f * wheel, wheel, z - trail), wheel);
    }
    dmg_use(b, 0);
}

/* Draws one level's rack, at the front or at the rear; its own x points there. It folds up against the uprights, or
 * down. */
static void draw_tower_rack(dmg_builder* b, const airer* a, float y, bool front, bool up, float reach) {
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(0, 1, 0), front ? -0.5f * DMG_PI : 0.5f * DMG_PI);
    dmg_use(b, 0);
    const float folded = up ? 1.5f : -1.5f;
    uint32_t rack = dmg_hinge(b, 0, "rack", v3(1.5f * a->r, 0, 0), v3(0, 0, 1), fminf(0, folded), fmaxf(0, folded));
    dmg_rest(b, rack, dmg_chance(b, 0.75f) ? 0.0f : folded);
    draw_rack(b, a, 1.5f * a->r, reach, a->wide - 2.5f * a->r);
    dmg_restore(b);
}

static void draw_tower(dmg_builder* b, const airer* a) {
    int levels = dmg_int(b, 2, 4), sides = dmg_int(b, 1, 2);
    float x = a->wide, room = 0.85f * a->tall / (float)levels, reach = fminf(1.1f * a->deep, 0.85f * room);
    bool up = dmg_chance(b, 0.5f), wings = dmg_chance(b, 0.3f);
    for (int s = -1; s <= 1; s += 2) {
        bar(b, a, v3((float)s * x, a->r, 0), v3((float)s * x, a->tall, 0), a->r);
        draw_tower_foot(b, a, (float)s * x);
    }
    bar(b, a, v3(-x, a->tall, 0), v3(x, a->tall, 0), a->r);
    bar(b, a, v3(-x, 0.1f * a->tall, 0), v3(x, 0.1f * a->tall, 0), 0.8f * a->r);
    for (int i = 0; i < levels; ++i) {
        float y = 0.14f * a->tall + room * ((float)i + (up ? 0.05f : 0.95f));
        for (int s = 0; s < sides; ++s) draw_tower_rack(b, a, y, s == 0, up, reach);
    }
    for (int s = -1; s <= 1 && wings; s += 2) {
        dmg_save(b);
        if (s < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, x + 1.5f * a->r, a->tall, 0);
        dmg_use(b, 0);
        draw_wing(b, a, 0, 0.8f * a->deep, 0.4f * a->deep, 1.4f);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- lines on arms that open like an umbrella's; it turns on its pole ---- */

static void draw_umbrella_arm(dmg_builder* b, const airer* a, uint32_t hub, uint32_t runner, float length, float rise,
                              float drop) {
    float tube = 2.0f * a->r, root = 2.2f * tube, c = cosf(rise), s = sinf(rise);
    dmg_use(b, hub);
    dmg_box(b, v3(0.7f * root, 0, 0), v3(root, 1.5f * tube, 1.2f * tube));
    uint32_t arm = dmg_hinge(b, hub, "arm", v3(root, 0, 0), v3(0, 0, 1), -0.3f, 1.45f - rise);
    dmg_vec from = v3(root, 0, 0), end = v3(root + length * c, length * s, 0);
    bar(b, a, from, end, 0.9f * a->r);
    dmg_rod(b, v3(root, 0, -0.5f * tube), v3(root, 0, 0.5f * tube), 0.6f * tube);
    for (int i = 0; i < a->bars / 2; ++i) { /* what the lines run through */
        dmg_vec at = v3_lerp(from, end, 0.35f + 0.6f * (float)i / (float)(a->bars / 2));
        dmg_box(b, v3(at.x, at.y + a->r, 0), v3(a->r, 2 * a->r, 0.6f * a->r));
    }
    float share = dmg_range(b, 0.3f, 0.5f);
    dmg_vec hold = v3_lerp(from, end, share), foot = v3(root, -drop, 0);
    dmg_use(b, runner);
    dmg_box(b, v3(0.7f * root, -drop, 0), v3(root, 1.2f * tube, 1.2f * tube));
    if (dmg_chance(b, 0.5f)) { /* the strut hangs from the arm, or stands on the runner */
        dmg_hinge(b, arm, "strut", hold, v3(0, 0, 1), -0.6f, 0.5f);
    } else {
        dmg_hinge(b, runner, "strut", foot, v3(0, 0, 1), -0.5f, 0.6f);
    }
    bar(b, a, foot, v3_mad(hold, v3_normalize(v3(-s, c, 0)), -a->r), 0.6f * a->r);
}

static void draw_umbrella(dmg_builder* b, const airer* a) {
    int arms = dmg_int(b, 3, 5);
    float length = a->tall * dmg_range(b, 0.4f, 0.75f), rise = dmg_range(b, 0.1f, 0.9f),
          drop = a->tall * dmg_range(b, 0.12f, 0.25f);
    float tube = 2.0f * a->r, foot = 0.3f * a->tall;
    bool turns = dmg_chance(b, 0.7f);
    dmg_rod(b, v3(0, 0, 0), v3(0, a->tall - (turns ? 1.6f * drop : -tube), 0), tube);
    if (dmg_chance(b, 0.5f)) /* a foot for those that stand on a floor */
        for (int i = 0; i < 3; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, 3);
            bar(b, a, v3(0, a->r, 0), v3(foot, a->r, 0), 1.5f * a->r);
            dmg_restore(b);
        }
    dmg_move(b, 0, a->tall, 0);
    uint32_t hub = turns ? dmg_spin(b, 0, "top", v3(0, 0, 0), v3(0, 1, 0)) : 0;
    if (turns) dmg_rod(b, v3(0, -1.9f * drop, 0), v3(0, tube, 0), 0.8f * tube);
    dmg_rod(b, v3(0, -tube, 0), v3(0, tube, 0), 1.6f * tube);
    uint32_t runner = dmg_slide(b, hub, "runner", v3(0, -1, 0), -0.3f * drop, 0.5f * drop);
    dmg_rod(b, v3(0, -drop - tube, 0), v3(0, -drop + tube, 0), 1.6f * tube);
    for (int i = 0; i < arms; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, arms);
        draw_umbrella_arm(b, a, hub, runner, length, rise, drop);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.4f)) return;
    dmg_move(b, 0, -0.5f * a->tall, 0);
    dmg_box(b, v3(0, 0, tube), v3(3 * tube, 4 * tube, 2 * tube));
    dmg_spin(b, 0, "crank", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 2 * tube), v3(0, 0, 3.5f * tube), 0.5f * tube);
    dmg_box_span(b, v3(-0.4f * tube, -0.5f * tube, 3.5f * tube), v3(0.4f * tube, 5 * tube, 4.2f * tube));
    dmg_rod(b, v3(0, 4.5f * tube, 4.2f * tube), v3(0, 4.5f * tube, 7.5f * tube), 0.5f * tube);
}

/* ---- on a wall: a frame that folds down, or bars that are drawn out ---- */

static void draw_wall_rack(dmg_builder* b, const airer* a) {
    float y = 0.5f * a->tall, t = 2.5f * a->r, reach = 0.8f * a->tall * dmg_range(b, 0.4f, 0.9f), half = 1.4f * a->wide;
    float plate = dmg_chance(b, 0.5f) ? reach : 6.0f * a->r;
    dmg_box_span(b, v3(-half - t, y - 2 * t, -t), v3(half + t, y + plate, 0));
    dmg_move(b, 0, y, 0);
    if (dmg_chance(b, 0.5f)) { /* x of the rack points off the wall */
        dmg_box_span(b, v3(-half, -t, 0), v3(-half + t, t, 2.0f * t));
        dmg_box_span(b, v3(half - t, -t, 0), v3(half, t, 2.0f * t));
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        bool down = dmg_chance(b, 0.3f);
        uint32_t rack =
            dmg_hinge(b, 0, "rack", v3(1.4f * t, 0, 0), v3(0, 0, 1), down ? -1.5f : 0.0f, down ? 0.0f : 1.5f);
        dmg_rest(b, rack, dmg_chance(b, 0.5f) ? 0.0f : (down ? -1.5f : 1.5f));
        draw_rack(b, a, 1.4f * t, reach, half - 1.5f * t);
        if (dmg_chance(b, 0.5f)) { /* and a second one on its end */
            dmg_hinge(b, rack, "outer_rack", v3(reach, 0, 0), v3(0, 0, 1), -1.5f, 0.1f);
            draw_rack(b, a, reach + 2.2f * a->r, 1.6f * reach, half - 1.5f * t);
        }
        return;
    }
    int stages = dmg_int(b, 1, 3);
    uint32_t carrier = 0;
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    for (int i = 0; i < stages; ++i) { /* each in the one before, drawn out straight */
        float z = half - (1.5f + 2.5f * (float)i) * t, out = 2.0f * t * (float)(i + 1);
        carrier = dmg_slide(b, carrier, "rack", v3(1, 0, 0), 0.0f, 0.85f * reach / (float)stages);
        dmg_rest(b, carrier, dmg_chance(b, 0.5f) ? 0.0f : 0.6f * reach / (float)stages);
        for (int s = -1; s <= 1; s += 2) bar(b, a, v3(-0.4f * t, 0, (float)s * z), v3(out, 0, (float)s * z), a->r);
        bar(b, a, v3(out, 0, -z), v3(out, 0, z), a->r);
    }
}

void dmg_build_clothes_airer(dmg_builder* b) {
    static const float shares[] = {4, 3, 2.5f, 2};
    airer a = pick_airer(b);
    switch (dmg_weighted(b, shares, 4)) {
    case 0:
        draw_winged(b, &a);
        break;
    case 1:
        draw_tower(b, &a);
        break;
    case 2:
        draw_umbrella(b, &a);
        break;
    default:
        draw_wall_rack(b, &a);
        break;
    }
}
