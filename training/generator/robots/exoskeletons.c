/* Draws exoskeletons: bars, drums and cuffs along the limbs of an absent wearer. They look to +Z; outwards of a side
 * is +X. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct exo {
    float thigh, shank, t; /* lengths, thickness of the bars */
    float drum, thin;      /* radius and half length of the actuators */
    int bar, joint, cuff;
    bool telescopes; /* the bars are cut in two to fit the wearer */
} exo;

/* From joint to joint: a flat bar, two bars side by side, a tube, a shell, a frame of two struts. */
static void draw_strut(dmg_builder* b, const exo* e, dmg_vec from, dmg_vec to) {
    float t = e->t;
    if (e->bar == 0) dmg_beam(b, from, to, 0.6f * t, 2.0f * t);
    if (e->bar == 1)
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec off = {0, 0, (float)s * 0.7f * t};
            dmg_rod(b, v3_add(from, off), v3_add(to, off), 0.3f * t);
        }
    if (e->bar == 2) dmg_rod(b, from, to, 0.6f * t);
    if (e->bar == 3) dmg_cone(b, from, to, 1.1f * t, 0.7f * t);
    if (e->bar == 4) {
        dmg_vec mid = v3_lerp(from, to, 0.5f);
        dmg_beam(b, from, mid, 0.8f * t, 2.4f * t);
        dmg_beam(b, mid, to, 0.8f * t, 1.4f * t);
    }
}

/* About X: a drum, a thin disc, a box with a shaft, nothing but the bars' ends. */
static void draw_exo_joint(dmg_builder* b, const exo* e, dmg_vec at) {
    float w = e->thin;
    if (e->joint == 0) dmg_rod(b, v3_add(at, v3(-w, 0, 0)), v3_add(at, v3(w, 0, 0)), e->drum);
    if (e->joint == 1)
        dmg_rod(b, v3_add(at, v3(-0.6f * e->t, 0, 0)), v3_add(at, v3(0.6f * e->t, 0, 0)), 0.8f * e->drum);
    if (e->joint == 2) dmg_rounded_box(b, at, v3(2 * w, 1.8f * e->drum, 1.6f * e->drum), 0.3f * fminf(w, e->drum));
}

/* Half a ring round the limb, inside of `at` by its radius; its opening to the front, the back or the side. */
static void draw_cuff(dmg_builder* b, const exo* e, dmg_vec at, float radius) {
    float high = radius * dmg_range(b, 0.4f, 1.0f), t = 0.12f * radius, start = dmg_range(b, -0.5f, 0.5f),
          arc = dmg_range(b, 2.4f, 4.5f);
    dmg_vec middle = {at.x - radius - 0.5f * e->t, at.y - 0.5f * high, at.z};
    if (e->cuff == 0) return;
    if (e->cuff == 1) {
        const dmg_xy profile[] = {{radius - t, 0}, {radius, 0}, {radius, high}, {radius - t, high}, {radius - t, 0}};
        dmg_lathe_arc(b, middle, v3(0, 1, 0), profile, 5, start + 0.5f * DMG_PI - 0.5f * arc, arc);
    }
    if (e->cuff == 2) { /* a pad on a stub */
        dmg_box(b, v3(middle.x, at.y, at.z - radius), v3(1.4f * radius, high, 2 * t));
        dmg_beam(b, at, v3(middle.x + 0.5f * radius, at.y, at.z - radius), t, 2 * t);
    }
    if (e->cuff == 3) dmg_torus(b, v3(middle.x, at.y, at.z), v3(0, 1, 0), radius, t);
}

/* Draws a bar that ends at a joint, in two pieces that slide when it is adjustable. Returns the part that carries the
 * end. */
static uint32_t draw_limb(dmg_builder* b, const exo* e, uint32_t carrier, dmg_vec from, dmg_vec to) {
    if (!e->telescopes) {
        draw_strut(b, e, from, to);
        return carrier;
    }
    dmg_vec along = v3_normalize(v3_sub(to, from)), mid = v3_lerp(from, to, 0.6f), start = v3_lerp(from, to, 0.3f);
    float length = v3_length(v3_sub(to, from));
    dmg_beam(b, from, mid, 1.4f * e->t, 1.8f * e->t);
    carrier = dmg_slide(b, carrier, "length", along, -0.15f * length, 0.2f * length);
    dmg_beam(b, start, to, 0.8f * e->t, 1.1f * e->t);
    return carrier;
}

/* Hip, knee and ankle at the outside of a leg. */
static void draw_exo_leg(dmg_builder* b, const exo* e, uint32_t belt, dmg_vec hip) {
    float bend = dmg_range(b, -0.1f, 0.5f), fold = dmg_range(b, 0.0f, 0.9f), radius = 0.2f * e->thigh,
          foot = 0.5f * e->shank;
    dmg_vec knee = v3_add(hip, v3(0, -e->thigh * cosf(bend), e->thigh * sinf(bend))),
            ankle = v3_add(knee, v3(0, -e->shank * cosf(fold - bend), -e->shank * sinf(fold - bend)));
    uint32_t carrier = belt;
    if (dmg_chance(b, 0.4f)) { /* to the side first, about a drum behind */
        dmg_vec behind = v3_add(hip, v3(-0.3f * radius, 0, -1.2f * radius));
        carrier = dmg_hinge(b, belt, "abduction", behind, v3(0, 0, dmg_sign(b)), -0.3f, 0.5f);
        dmg_rod(b, v3_add(behind, v3(0, 0, -e->thin)), v3_add(behind, v3(0, 0, e->thin)), 0.7f * e->drum);
        dmg_beam(b, behind, hip, e->t, 1.5f * e->t);
    }
    draw_exo_joint(b, e, hip);
    carrier = dmg_hinge(b, carrier, "hip", hip, v3(dmg_sign(b), 0, 0), -1.2f, 0.9f);
    draw_cuff(b, e, v3_lerp(hip, knee, 0.55f), radius);
    carrier = draw_limb(b, e, carrier, hip, knee);
    draw_exo_joint(b, e, knee);
    carrier = dmg_hinge(b, carrier, "knee", knee, v3(dmg_sign(b), 0, 0), -0.9f, 0.9f);
    draw_cuff(b, e, v3_lerp(knee, ankle, 0.45f), 0.8f * radius);
    carrier = draw_limb(b, e, carrier, knee, ankle);
    if (dmg_chance(b, 0.3f)) return;
    if (dmg_chance(b, 0.6f)) draw_exo_joint(b, e, ankle);
    dmg_hinge(b, carrier, "ankle", ankle, v3(dmg_sign(b), 0, 0), -0.5f, 0.5f);
    dmg_vec sole = v3_add(ankle, v3(-radius, -0.3f * foot, 0.3f * foot));
    dmg_box(b, sole, v3(0.5f * foot, 0.1f * foot, foot));
    dmg_beam(b, ankle, v3(ankle.x - 0.3f * e->t, sole.y, ankle.z), e->t, e->t);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0.5f * (ankle.x + sole.x), sole.y, ankle.z),
                v3(fabsf(ankle.x - sole.x) + e->t, 0.15f * foot, 0.3f * foot));
}

/* Draws a shoulder of two drums, an upper arm, a forearm with a grip. */
static void draw_exo_arm(dmg_builder* b, const exo* e, uint32_t back, dmg_vec root) {
    float upper = 0.75f * e->thigh, lower = 0.65f * e->thigh, lean = dmg_range(b, -0.2f, 0.6f),
          radius = 0.14f * e->thigh;
    dmg_vec shoulder = v3_add(root, v3(1.5f * radius, 0, 2.0f * radius)),
            elbow = v3_add(shoulder, v3(0, -upper * cosf(lean), upper * sinf(lean))),
            hand = v3_add(elbow, v3(0, -0.3f * lower, 0.95f * lower));
    draw_exo_joint(b, e, root);
    uint32_t carrier = dmg_hinge(b, back, "shoulder_yaw", root, v3(0, dmg_sign(b), 0), -0.6f, 0.6f);
    dmg_rod(b, v3_add(root, v3(0, -e->thin, 0)), v3_add(root, v3(0, e->thin, 0)), 0.7f * e->drum);
    dmg_beam(b, root, shoulder, e->t, 1.6f * e->t);
    draw_exo_joint(b, e, shoulder);
    carrier = dmg_hinge(b, carrier, "shoulder", shoulder, v3(dmg_sign(b), 0, 0), -1.5f, 0.6f);
    draw_cuff(b, e, v3_lerp(shoulder, elbow, 0.6f), radius);
    draw_strut(b, e, shoulder, elbow);
    draw_exo_joint(b, e, elbow);
    carrier = dmg_hinge(b, carrier, "elbow", elbow, v3(dmg_sign(b), 0, 0), -0.8f, 0.8f);
    draw_strut(b, e, elbow, hand);
    if (dmg_chance(b, 0.5f)) dmg_spin(b, carrier, "wrist", hand, v3_normalize(v3_sub(hand, elbow)));
    dmg_rod(b, v3_add(hand, v3(-1.8f * radius, 0, 0)), hand, 0.2f * radius);
}

void dmg_build_exoskeleton(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.15f, 1.2f), hips = size * dmg_range(b, 0.3f, 0.5f),
          back = size * dmg_range(b, 0.2f, 0.9f);
    exo e = {.thigh = size * dmg_range(b, 0.6f, 0.9f)};
    e.t = size * dmg_range(b, 0.03f, 0.08f);
    e.bar = dmg_int(b, 0, 4);
    e.shank = e.thigh * dmg_range(b, 0.85f, 1.1f);
    e.drum = size * dmg_range(b, 0.06f, 0.12f);
    e.thin = e.drum * dmg_range(b, 0.3f, 0.9f);
    e.joint = dmg_int(b, 0, 3);
    e.cuff = dmg_int(b, 0, 3);
    e.telescopes = dmg_chance(b, 0.2f);
    int limbs = dmg_int(b, 0, 3); /* legs, arms, both, one of them */
    dmg_move(b, 0, e.thigh + 1.2f * e.shank, 0);
    float z = -0.45f * hips;
    dmg_box(b, v3(0, 0.5f * back, z), v3(0.7f * hips, back, 0.25f * hips)); /* the pack */
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0, z), v3(2 * hips, 2 * e.t, 1.5f * e.t));
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        if (s < 0) dmg_mirror(b, v3(1, 0, 0));
        if (limbs != 1 && (limbs != 3 || s > 0)) {
            dmg_beam(b, v3(0.9f * hips, 0, z), v3(hips, 0, 0), e.t, 2 * e.t);
            dmg_beam(b, v3(0.3f * hips, 0, z), v3(0.93f * hips, 0, z), e.t, 2 * e.t);
            draw_exo_leg(b, &e, 0, v3(hips, 0, 0));
            dmg_use(b, 0);
        }
        if (limbs == 1 || limbs == 2) {
            dmg_beam(b, v3(0, back, z), v3(0.8f * hips, back, z), e.t, 2 * e.t);
            draw_exo_arm(b, &e, 0, v3(0.8f * hips, back, z));
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
}
