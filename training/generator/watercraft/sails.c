/* Draws sailing and working boats: booms, yards and derricks on their masts, rudders with tillers, boards that swing
 * or slide, winches, anchors, hatches. The bow is +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

typedef struct hull {
    float length, half, high; /* the deck's middle is the origin */
    float stern;              /* width of the transom, share of the beam */
    int kind;                 /* round, hard chines, flat-bottomed */
} hull;

static const dmg_xy SECTIONS[3][7] = {
    {{1, 0}, {-1, 0}, {-0.92f, -0.5f}, {-0.55f, -0.88f}, {0, -1}, {0.55f, -0.88f}, {0.92f, -0.5f}},
    {{1, 0}, {-1, 0}, {-0.97f, -0.3f}, {-0.8f, -0.7f}, {0, -1}, {0.8f, -0.7f}, {0.97f, -0.3f}},
    {{1, 0}, {-1, 0}, {-0.92f, -0.5f}, {-0.8f, -0.95f}, {0, -1}, {0.8f, -0.95f}, {0.92f, -0.5f}},
};

static void draw_hull(dmg_builder* b, const hull* h, float half) {
    float l = h->length;
    const dmg_row rows[] = {{h->stern * half, 0.75f * h->high, 0, -0.5f * l},
                            {half * (0.5f + 0.5f * h->stern), 0.9f * h->high, 0, -0.25f * l},
                            {half, h->high, 0, 0},
                            {0.75f * half, 0.95f * h->high, 0.02f * h->high, 0.25f * l},
                            {0.4f * half, 0.8f * h->high, 0.08f * h->high, 0.4f * l},
                            {0.05f * half, 0.5f * h->high, 0.15f * h->high, 0.5f * l}};
    dmg_loft(b, SECTIONS[h->kind], 7, rows, 6);
}

static hull pick_hull(dmg_builder* b) {
    hull h = {.length = dmg_scale_range(b, 0.2f, 9.0f)};
    h.kind = dmg_int(b, 0, 2);
    h.stern = dmg_range(b, 0.3f, 0.95f);
    h.half = h.length * dmg_range(b, 0.12f, 0.2f);
    h.high = h.length * dmg_range(b, 0.09f, 0.16f);
    return h;
}

/* ---- steering ---- */

/* On the transom, its pins in a raked line; a tiller that lifts on its head, a blade that swings up between cheeks. */
static void draw_transom_rudder(dmg_builder* b, const hull* h) {
    float l = h->length, z = -0.505f * l, rake = dmg_range(b, 0.0f, 0.25f), t = 0.012f * l, chord = 0.09f * l,
          deep = h->high * dmg_range(b, 1.1f, 2.0f), swing = dmg_range(b, 0.5f, 1.0f);
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    for (int i = 0; i < 2; ++i)
        dmg_box_span(b, v3(-t, -0.15f * h->high - 0.35f * h->high * (float)i - t, -0.6f * t),
                     v3(t, -0.15f * h->high - 0.35f * h->high * (float)i + t, t));
    dmg_turn(b, v3(1, 0, 0), -rake);
    dmg_move(b, 0, 0, -t);
    uint32_t rudder = dmg_hinge(b, 0, "rudder", v3(0, -0.3f * h->high, 0), v3(0, dmg_sign(b), 0), -swing, swing);
    bool lifts = dmg_chance(b, 0.4f);
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, -0.8f * h->high, 0), v3(0, 0.35f * h->high, 0), 0.7f * t);
    if (lifts) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * t - 0.3f * t, -0.7f * h->high, -0.6f * chord),
                         v3((float)s * t + 0.3f * t, 0.35f * h->high, 0));
        dmg_rod(b, v3(-1.6f * t, -0.55f * h->high, -0.4f * chord), v3(1.6f * t, -0.55f * h->high, -0.4f * chord),
                0.6f * t);
        dmg_hinge_across(b, rudder, "rudder_blade", v3(0, -0.55f * h->high, -0.4f * chord), -1.5f, 0.0f);
    }
    const dmg_xy blade[] = {{-0.9f * chord, -0.35f * h->high},
                            {-chord, -0.8f * deep},
                            {-0.7f * chord, -deep},
                            {-0.15f * chord, -0.9f * deep},
                            {-0.02f * chord, -0.35f * h->high}};
    const dmg_xy whole[] = {{-0.5f * chord, 0.3f * h->high}, {-chord, -0.4f * h->high},
                            {-chord, -0.8f * deep},          {-0.7f * chord, -deep},
                            {-0.02f * chord, -0.9f * deep},  {-0.02f * chord, 0.3f * h->high}};
    if (lifts) dmg_side_prism(b, blade, 5, -0.5f * t, 0.5f * t);
    if (!lifts) dmg_side_prism(b, whole, 6, -0.5f * t, 0.5f * t);
    dmg_use(b, rudder);
    if (dmg_chance(b, 0.85f)) {
        float y = 0.35f * h->high, reach = l * dmg_range(b, 0.12f, 0.22f);
        if (dmg_chance(b, 0.4f))
            rudder = dmg_hinge_across(b, rudder, "tiller", v3(0, y, 0), -0.05f, dmg_range(b, 0.6f, 1.3f));
        dmg_beam(b, v3(0, y, -0.5f * chord), v3(0, y + 0.15f * reach, reach), 1.2f * t, 1.5f * t);
        if (dmg_chance(b, 0.3f)) { /* its extension */
            dmg_vec joint = {0, y + 0.15f * reach + 1.4f * t, reach - t};
            dmg_hinge(b, rudder, "tiller_extension", joint, v3(0, dmg_sign(b), 0), -1.6f, 1.6f);
            dmg_rod(b, v3_add(joint, v3(0, -0.7f * t, 0)), v3_add(joint, v3(0, 0.5f * t, 0)), 0.8f * t);
            dmg_rod(b, joint, v3_add(joint, v3(0, -0.1f * reach, -0.8f * reach)), 0.4f * t);
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Under the counter on an upright stock, turned by a wheel. */
static void draw_spade_rudder(dmg_builder* b, const hull* h) {
    float l = h->length, z = -0.42f * l, deep = h->high * dmg_range(b, 1.2f, 1.9f), chord = 0.08f * l, t = 0.012f * l,
          y = -0.8f * h->high, pivot = dmg_range(b, 0.0f, 0.35f);
    dmg_hinge(b, 0, "rudder", v3(0, y, z), v3(0, dmg_sign(b), 0), -0.7f, 0.7f);
    dmg_rod(b, v3(0, -0.6f * h->high, z), v3(0, -deep, z), 0.5f * t);
    dmg_box_span(b, v3(-0.5f * t, -deep, z - (1 - pivot) * chord), v3(0.5f * t, y, z + pivot * chord));
    dmg_use(b, 0);
    float r = h->half * dmg_range(b, 0.25f, 0.5f), up = 0.9f * h->high;
    dmg_save(b);
    dmg_move(b, 0, 0, -0.3f * l);
    dmg_box_span(b, v3(-0.1f * h->half, -0.02f * l, 0), v3(0.1f * h->half, up + 0.15f * h->half, 0.12f * h->half));
    dmg_move(b, 0, up, -0.1f * h->half);
    dmg_turn(b, v3(1, 0, 0), dmg_range(b, 0.0f, 0.4f));
    dmg_rod(b, v3(0, 0, -0.02f * l), v3(0, 0, 0.15f * h->half), 0.06f * h->half);
    dmg_hinge(b, 0, "helm", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -3.1f, 3.1f);
    dmg_wheel_draw(b, 3, r, 0.1f * r, dmg_int(b, 3, 8));
    int grips = dmg_chance(b, 0.4f) ? 8 : 0;
    for (int i = 0; i < grips; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, grips);
        dmg_rod(b, v3(0.95f * r, 0, 0), v3(1.25f * r, 0, 0), 0.05f * r);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- boards below: one that swings down about its pin, one that slides, a keel, boards at the sides ---- */

static void draw_boards(dmg_builder* b, const hull* h) {
    float l = h->length, deep = h->high * dmg_range(b, 0.8f, 1.6f), t = 0.01f * l, chord = 0.13f * l;
    int kind = dmg_int(b, 0, 3);
    if (kind <= 1) /* the case it goes up into */
        dmg_box_span(b, v3(-2 * t, -0.02f * l, 0.02f * l - chord), v3(2 * t, 0.35f * h->high, 0.05f * l));
    if (kind == 0) {
        float down = dmg_range(b, 0.6f, 1.4f), most = 1.45f;
        dmg_hinge_across(b, 0, "centreboard", v3(0, -0.95f * h->high, 0.03f * l), down - most, down);
        dmg_save(b);
        dmg_move(b, 0, -0.95f * h->high, 0.03f * l);
        dmg_turn(b, v3(1, 0, 0), down);
        dmg_box_span(b, v3(-0.6f * t, -0.5f * chord, -deep), v3(0.6f * t, 0.3f * chord, 0.1f * chord));
        dmg_restore(b);
    }
    if (kind == 1) {
        dmg_slide(b, 0, "daggerboard", v3(0, 1, 0), -0.3f * deep, 0.8f * deep);
        dmg_box_span(b, v3(-0.6f * t, -h->high - 0.8f * deep, 0.04f * l - chord),
                     v3(0.6f * t, 0.6f * h->high, 0.04f * l));
        dmg_box_span(b, v3(-3 * t, 0.6f * h->high, 0.04f * l - chord), v3(3 * t, 0.6f * h->high + t, 0.04f * l));
    }
    if (kind == 2) {
        const dmg_xy fin[] = {{-0.1f * l, -0.9f * h->high},
                              {-0.08f * l, -h->high - deep},
                              {0.06f * l, -h->high - deep},
                              {0.12f * l, -0.9f * h->high}};
        dmg_side_prism(b, fin, 4, -1.5f * t, 1.5f * t);
        dmg_rod(b, v3(0, -h->high - deep, -0.12f * l), v3(0, -h->high - deep, 0.1f * l), 3 * t);
    }
    for (int s = -1; s <= 1 && kind == 3; s += 2) {
        dmg_vec pin = {(float)s * (h->half + t), -0.1f * h->high, 0.03f * l};
        float down = dmg_range(b, 0.2f, 1.4f); /* from lying aft */
        dmg_hinge_across(b, 0, "leeboard", pin, down - 1.5f, down);
        dmg_save(b);
        dmg_move(b, pin.x, pin.y, pin.z);
        dmg_turn(b, v3(1, 0, 0), down);
        const dmg_xy leaf[] = {{0.04f * l, -0.02f * l},
                               {0.04f * l, 0.02f * l},
                               {-1.2f * deep, 0.06f * l},
                               {-1.4f * deep, 0},
                               {-1.2f * deep, -0.07f * l}};
        dmg_side_prism(b, leaf, 5, -0.6f * t, 0.6f * t);
        dmg_rod(b, v3(-1.5f * t, 0, 0), v3(1.5f * t, 0, 0), t);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_use(b, 0);
}

/* ---- rig: the mast's foot at the origin ---- */

static void draw_sail_boom(dmg_builder* b, uint32_t mast, float l, float high, float r) {
    float y = l * dmg_range(b, 0.1f, 0.18f), reach = l * dmg_range(b, 0.3f, 0.5f),
          off = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -0.9f, 0.9f), most = 1.3f;
    bool aft = dmg_chance(b, 0.5f); /* the pin behind the mast, or the mast itself */
    float z = aft ? -2.2f * r : 0.0f;
    dmg_save(b);
    uint32_t boom = dmg_hinge(b, mast, "boom", v3(0, y, z), v3(0, 1, 0), -most - off, most - off);
    dmg_move(b, 0, y, z);
    dmg_turn(b, v3(0, 1, 0), off);
    if (!aft) {
        const dmg_xy collar[] = {{1.1f * r, -1.5f * r},
                                 {1.8f * r, -1.5f * r},
                                 {1.8f * r, 1.5f * r},
                                 {1.1f * r, 1.5f * r},
                                 {1.1f * r, -1.5f * r}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), collar, 5);
    } else {
        dmg_box(b, v3(0, 0, 0), v3(1.2f * r, 2.5f * r, 1.5f * r));
    }
    bool lifts = dmg_chance(b, 0.3f), sail = dmg_chance(b, 0.5f) && !lifts;
    if (lifts) dmg_hinge_across(b, boom, "topping", v3(0, 0, -1.5f * r), -0.9f, 0.15f);
    dmg_rod(b, v3(0, 0, -1.5f * r), v3(0, 0, -reach), 0.8f * r);
    if (sail) {
        float foot = 1.5f * r, head = 0.9f * high - y;
        bool gaff = dmg_chance(b, 0.35f);
        const dmg_xy main[] = {{-2 * r, foot}, {-2 * r, head}, {-0.96f * reach, foot}};
        const dmg_xy quad[] = {
            {-2 * r, foot}, {-2 * r, 0.6f * head}, {-0.65f * reach, 0.95f * head}, {-0.96f * reach, foot}};
        dmg_side_prism(b, gaff ? quad : main, gaff ? 4 : 3, -0.2f * r, 0.2f * r);
        if (gaff) dmg_rod(b, v3(0, 0.58f * head, -1.5f * r), v3(0, 0.97f * head, -0.68f * reach), 0.6f * r);
    } else if (dmg_chance(b, 0.4f)) { /* the sail lies on it */
        dmg_ellipsoid(b, v3(0, 1.6f * r, -0.5f * reach), v3(1.6f * r, 1.4f * r, 0.45f * reach));
    }
    dmg_restore(b);
    dmg_use(b, mast);
}

/* Draws a derrick: its heel turns on the mast, the boom rises on the heel; a block hangs from its end. */
static void draw_derrick(dmg_builder* b, uint32_t mast, float l, float r) {
    float y = l * dmg_range(b, 0.06f, 0.14f), reach = l * dmg_range(b, 0.25f, 0.4f), up = dmg_range(b, 0.2f, 1.2f),
          side = dmg_chance(b, 0.8f) ? 1.0f : -1.0f;
    dmg_save(b);
    dmg_move(b, 0, y, side * 2.4f * r);
    if (side < 0) dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_use(b, mast);
    dmg_box(b, v3(0, -1.4f * r, -0.6f * r), v3(2 * r, 0.8f * r, 3.5f * r));
    uint32_t heel = dmg_hinge(b, mast, "heel", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -1.0f, 1.0f);
    dmg_rod(b, v3(0, -r, 0), v3(0, 0.8f * r, 0), 0.9f * r);
    uint32_t boom = dmg_hinge_across(b, heel, "derrick", v3(0, 0, 0.4f * r), -up, 1.4f - up);
    dmg_move(b, 0, 0, 0.4f * r);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -up);
    dmg_rod(b, v3(0, 0, 0.5f * r), v3(0, 0, reach), 0.7f * r);
    dmg_restore(b);
    dmg_vec end = v3(0, reach * sinf(up), reach * cosf(up));
    float drop = 0.4f * reach;
    if (dmg_chance(b, 0.6f)) {
        dmg_rod(b, v3_add(end, v3(0, -drop, 0)), end, 0.1f * r);
        dmg_slide(b, boom, "hook", v3(0, -1, 0), -0.7f * drop, 0.3f * drop);
        dmg_box(b, v3_add(end, v3(0, -drop, 0)), v3(r, 1.6f * r, 0.7f * r));
        dmg_torus(b, v3_add(end, v3(0, -drop - 1.4f * r, 0)), v3(1, 0, 0), 0.6f * r, 0.2f * r);
    }
    dmg_restore(b);
    dmg_use(b, mast);
}

static void draw_yard(dmg_builder* b, uint32_t mast, float y, float reach, float r) {
    dmg_hinge(b, mast, "yard", v3(0, y, 0), v3(0, dmg_sign(b), 0), -0.8f, 0.8f);
    dmg_rod(b, v3(-reach, y, 1.9f * r), v3(reach, y, 1.9f * r), 0.7f * r);
    dmg_box(b, v3(0, y, 1.3f * r), v3(1.5f * r, 1.2f * r, 1.4f * r));
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.9f * reach, y - 0.9f * reach, 1.8f * r), v3(0.9f * reach, y - 0.5f * r, 2.1f * r));
    dmg_use(b, mast);
}

/* Returns whether it is a sailing rig. */
static bool draw_rig(dmg_builder* b, const hull* h) {
    float l = h->length, high = l * dmg_range(b, 0.7f, 1.3f), r = l * dmg_range(b, 0.008f, 0.016f),
          z = l * dmg_range(b, 0.05f, 0.2f);
    int kind = dmg_weighted(b, (const float[]){5, 3, 2}, 3); /* boom, derrick, yards */
    if (kind == 1) high *= 0.6f;
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    uint32_t mast = 0;
    if (kind == 0 && dmg_chance(b, 0.25f)) { /* stepped between cheeks: it is lowered aft */
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 1.8f * r - 0.4f * r, -0.01f * l, -1.5f * r),
                         v3((float)s * 1.8f * r + 0.4f * r, 0.06f * l, 1.5f * r));
        mast = dmg_hinge_across(b, 0, "mast", v3(0, 0.045f * l, 0), 0.0f, dmg_range(b, 0.7f, 1.1f));
    }
    dmg_cone(b, v3(0, mast ? 0.01f * l : -0.02f * l, 0), v3(0, high, 0), r, 0.7f * r);
    if (kind == 0) draw_sail_boom(b, mast, l, high, r);
    if (kind == 1) draw_derrick(b, mast, l, 1.2f * r);
    int yards = kind == 2 ? dmg_int(b, 1, 3) : 0;
    for (int i = 0; i < yards; ++i)
        draw_yard(b, mast, high * (0.9f - 0.3f * (float)i), l * (0.2f + 0.05f * (float)i), r);
    if (kind == 0 && dmg_chance(b, 0.3f)) { /* a pole before the mast */
        float y = 0.12f * l, reach = 0.25f * l;
        dmg_hinge(b, mast, "pole", v3(0, y, 1.6f * r), v3(0, dmg_sign(b), 0), -1.4f, 1.4f);
        dmg_rod(b, v3(0, y, 1.6f * r), v3(0, y, reach), 0.5f * r);
    }
    dmg_use(b, 0);
    dmg_restore(b);
    if (kind == 0 && !mast && dmg_chance(b, 0.6f)) { /* the forestay, a furled sail round it */
        dmg_vec foot = {0, 0.02f * l, 0.48f * l}, top = {0, 0.9f * high, z + r};
        dmg_rod(b, foot, top, 0.15f * r);
        if (dmg_chance(b, 0.7f)) {
            dmg_spin(b, 0, "furler", foot, v3_normalize(v3_sub(top, foot)));
            dmg_cone(b, v3_lerp(foot, top, 0.05f), v3_lerp(foot, top, 0.9f), r, 0.4f * r);
            dmg_rod(b, v3_lerp(foot, top, 0.015f), v3_lerp(foot, top, 0.045f), 1.8f * r);
            dmg_use(b, 0);
        }
    }
    return kind != 1;
}

/* ---- on deck ---- */

static void draw_winches(dmg_builder* b, const hull* h) {
    int pairs = dmg_int(b, 0, 2);
    float r = 0.018f * h->length * dmg_range(b, 0.7f, 1.2f), high = 2.2f * r;
    const dmg_xy drum[] = {{0, 0}, {r, 0}, {0.7f * r, 0.5f * high}, {0.95f * r, high}, {0, high}};
    for (int i = 0; i < 2 * pairs; ++i) {
        float x = (i & 1 ? 0.84f : -0.84f) * h->half * (i & 2 ? 1.0f : h->stern),
              z = (i & 2 ? -0.08f : -0.32f) * h->length;
        dmg_vec at = {x, 0.25f * r, z};
        dmg_rod(b, v3(x, -0.5f * r, z), at, 1.1f * r);
        dmg_spin(b, 0, "winch", at, v3(0, 1, 0));
        dmg_lathe(b, at, v3(0, 1, 0), drum, 5);
        if (dmg_chance(b, 0.5f)) { /* its crank */
            if (dmg_chance(b, 0.5f)) dmg_spin(b, 0, "winch_crank", at, v3(0, -1, 0));
            dmg_box_span(b, v3(x - 0.25f * r, at.y + high, z), v3(x + 0.25f * r, at.y + 1.25f * high, z + 2.4f * r));
            dmg_rod(b, v3(x, at.y + high, z + 2.1f * r), v3(x, at.y + 1.9f * high, z + 2.1f * r), 0.3f * r);
        }
        dmg_use(b, 0);
    }
}

/* Draws a windlass on the foredeck; an anchor on its roller at the stem. */
static void draw_ground_tackle(dmg_builder* b, const hull* h) {
    float l = h->length, r = 0.02f * l, z = 0.3f * l, y = 1.4f * r;
    if (dmg_chance(b, 0.6f)) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 1.6f * r - 0.3f * r, -0.3f * r, z - 0.7f * r),
                         v3((float)s * 1.6f * r + 0.3f * r, y + 0.5f * r, z + 0.7f * r));
        dmg_spin(b, 0, "windlass", v3(0, y, z), v3(dmg_sign(b), 0, 0));
        dmg_rod(b, v3(-2.4f * r, y, z), v3(2.4f * r, y, z), 0.4f * r);
        dmg_rod(b, v3(-1.1f * r, y, z), v3(1.1f * r, y, z), 0.9f * r);
        for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3((float)s * 2.0f * r, y, z), v3((float)s * 2.6f * r, y, z), r);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.5f)) {
        float bow = 0.5f * l, up = 0.8f * r, t = 0.3f * r;
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * r - 0.2f * r, -0.5f * r, bow - 3 * r),
                         v3((float)s * r + 0.2f * r, up + 0.5f * r, bow + r));
        dmg_spin(b, 0, "bow_roller", v3(0, up - 0.6f * r, bow), v3(1, 0, 0));
        dmg_rod(b, v3(-0.9f * r, up - 0.6f * r, bow), v3(0.9f * r, up - 0.6f * r, bow), 0.5f * r);
        dmg_use(b, 0);
        bool swings = dmg_chance(b, 0.5f);
        if (swings)
            dmg_hinge_across(b, 0, "anchor", v3(0, up, bow), -1.3f, 0.2f);
        else
            dmg_slide(b, 0, "anchor", v3(0, 0, 1), 0.0f, 0.05f * l);
        dmg_box_span(b, v3(-t, up - t, bow - 3 * r), v3(t, up + t, bow + 2.5f * r));
        dmg_beam(b, v3(0, up, bow + 2.4f * r), v3(0, up - 2 * r, bow + 1.6f * r), 3 * r, 0.5f * r);
        dmg_use(b, 0);
    }
}

/* Draws a cabin with what closes it: a hatch that slides forward over the way in, boards pulled up, doors; one on the
 * foredeck that is hinged; ports in the sides hinged above. */
static void draw_cabin(dmg_builder* b, const hull* h, bool tall) {
    float l = h->length, high = h->high * (tall ? dmg_range(b, 1.2f, 2.0f) : dmg_range(b, 0.3f, 0.6f)),
          x = 0.62f * h->half, z0 = -0.2f * l, z1 = tall ? 0.0f : 0.22f * l, t = 0.006f * l;
    const dmg_xy side[] = {
        {z0, -0.1f * h->high}, {z1, -0.1f * h->high}, {z1 - 0.04f * l, 0.9f * high}, {z0 + 0.01f * l, high}};
    dmg_side_prism(b, side, 4, -x, x);
    float w = 0.35f * x, deep = 0.12f * l;
    if (!tall && dmg_chance(b, 0.7f)) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 1.08f * w - t, 0.9f * high, z0),
                         v3((float)s * 1.08f * w + t, high + 1.5f * t, z0 + 1.9f * deep));
        dmg_slide(b, 0, "sliding_hatch", v3(0, 0, 1), 0.0f, 0.85f * deep);
        dmg_box_span(b, v3(-w, high, z0), v3(w, high + 2 * t, z0 + deep));
        dmg_box_span(b, v3(-0.6f * w, high + 2 * t, z0 + 0.05f * deep),
                     v3(0.6f * w, high + 3.5f * t, z0 + 0.15f * deep));
        dmg_use(b, 0);
    }
    int way_in = dmg_int(b, 0, 2);
    if (way_in == 0) dmg_slide(b, 0, "washboard", v3(0, 1, 0), 0.0f, 0.9f * high);
    if (way_in == 1)
        dmg_hinge(b, 0, "cabin_door", v3(-w, 0.5f * high, z0 - t), v3(0, 1, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
    if (way_in < 2) dmg_box_span(b, v3(-w, 0, z0 - 2 * t), v3(w, 0.95f * high, z0));
    dmg_use(b, 0);
    int ports = dmg_int(b, 0, 3);
    for (int i = 0; i < 2 * ports; ++i) {
        float s = i & 1 ? 1.0f : -1.0f, each = (z1 - z0 - 0.08f * l) / (float)ports,
              z = z0 + 0.03f * l + each * ((float)(i / 2) + 0.5f), tall_port = 0.4f * high;
        if (dmg_chance(b, 0.6f))
            dmg_hinge(b, 0, "port", v3(s * (x + 0.5f * t), 0.75f * high, z), v3(0, 0, s), 0.0f, 1.3f);
        dmg_box_span(b, v3(fminf(s * x, s * (x + t)), 0.75f * high - tall_port, z - 0.35f * each),
                     v3(fmaxf(s * x, s * (x + t)), 0.75f * high, z + 0.35f * each));
        dmg_use(b, 0);
    }
    if (tall && dmg_chance(b, 0.6f)) {
        dmg_spin(b, 0, "radar", v3(0, high, -0.1f * l), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.98f * high, -0.1f * l), v3(0, high + 5 * t, -0.1f * l), 2 * t);
        dmg_box(b, v3(0, high + 6 * t, -0.1f * l), v3(0.8f * x, 3 * t, 3 * t));
        dmg_use(b, 0);
    }
}

static void draw_hatches(dmg_builder* b, const hull* h) {
    float l = h->length, t = 0.008f * l;
    int hatches = dmg_int(b, 1, 2);
    for (int i = 0; i < hatches; ++i) {
        float z = i ? -0.42f * l : 0.26f * l, wide = (i ? 0.5f * h->stern : 0.25f) * h->half, deep = 0.05f * l;
        bool ahead = dmg_chance(b, 0.6f), turned = dmg_chance(b, 0.25f);
        float y = i ? 0.0f : 3 * t;
        if (!i) dmg_box_span(b, v3(-wide, -0.02f * l, z - deep), v3(wide, y, z + deep));
        if (turned)
            dmg_hinge(b, 0, "hatch", v3(wide, y, z), v3(0, 0, -1), 0.0f, dmg_range(b, 1.0f, 2.5f));
        else
            dmg_hinge_across(b, 0, "hatch", v3(0, y, ahead ? z + deep : z - deep), ahead ? -1.9f : 0.0f,
                             ahead ? 0.0f : 1.9f);
        dmg_box_span(b, v3(-1.05f * wide, y, z - 1.02f * deep), v3(1.05f * wide, y + t, z + 1.02f * deep));
        if (dmg_chance(b, 0.5f))
            dmg_box(
                b,
                v3(turned ? -0.8f * wide : 0, y + 1.5f * t, turned ? z : (ahead ? z - 0.8f * deep : z + 0.8f * deep)),
                v3(0.3f * wide, t, 0.15f * deep));
        dmg_use(b, 0);
    }
}

/* ---- the whole ---- */

void dmg_build_sailing_boat(dmg_builder* b) {
    hull h = pick_hull(b);
    bool twin = dmg_chance(b, 0.2f);
    dmg_move(b, 0, 2.7f * h.high, 0);
    if (twin) { /* two hulls, beams across, a bridge between them */
        for (int s = -1; s <= 1; s += 2) {
            dmg_save(b);
            dmg_move(b, (float)s * 1.3f * h.half, 0, 0);
            draw_hull(b, &h, 0.35f * h.half);
            dmg_restore(b);
        }
        for (int i = 0; i < 2; ++i)
            dmg_rod(b, v3(-1.3f * h.half, -0.1f * h.high, (i ? 0.2f : -0.35f) * h.length),
                    v3(1.3f * h.half, -0.1f * h.high, (i ? 0.2f : -0.35f) * h.length), 0.02f * h.length);
        dmg_box_span(b, v3(-1.2f * h.half, -0.12f * h.high, -0.35f * h.length), v3(1.2f * h.half, 0, 0.22f * h.length));
        dmg_box_span(b, v3(-0.05f * h.half, -0.12f * h.high, 0.2f * h.length), v3(0.05f * h.half, 0, 0.5f * h.length));
    } else {
        draw_hull(b, &h, h.half);
        if (dmg_chance(b, 0.7f)) draw_boards(b, &h);
    }
    bool sails = draw_rig(b, &h);
    if (twin) {
        for (int s = -1; s <= 1; s += 2) {
            dmg_save(b);
            dmg_move(b, (float)s * 1.3f * h.half, 0, 0);
            draw_transom_rudder(b, &h);
            dmg_restore(b);
        }
    } else if (dmg_chance(b, sails ? 0.65f : 0.3f)) {
        draw_transom_rudder(b, &h);
    } else {
        draw_spade_rudder(b, &h);
    }
    if (dmg_chance(b, 0.6f) && !twin) draw_cabin(b, &h, !sails && dmg_chance(b, 0.7f));
    if (dmg_chance(b, 0.5f) && !twin) draw_hatches(b, &h);
    if (dmg_chance(b, 0.6f)) draw_winches(b, &h);
    if (dmg_chance(b, 0.5f) && !twin) draw_ground_tackle(b, &h);
    dmg_use(b, 0);
}
