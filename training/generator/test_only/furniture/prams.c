/* Draws pushchairs and prams with swivelling wheels, hoods and bars. */
#include "core/arcs.h"
#include "core/build.h"
#include "parts/hardware.h"

/* ---- pushchair ---- */

typedef struct pram {
    float half, high, front, rear; /* half width; of the handle; where the axles are, along z */
    float seat, tube;              /* height of the seat */
    float big, small;              /* radii of the wheels behind and in front */
    int wheel, spokes;
} pram;

/* Draws a wheel about X at a place of the part in use. */
static void draw_pram_wheel(dmg_builder* b, const pram* p, uint32_t parent, dmg_vec at, float radius) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, parent, "wheel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_wheel_draw(b, p->wheel, radius, 0.3f * radius + 0.01f, p->spokes);
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Draws a fork below its upright pin, the axle trailing behind it. */
static void draw_swivel(dmg_builder* b, const pram* p, float x) {
    float r = p->small, trail = r * dmg_range(b, 0.2f, 0.7f), t = p->tube, top = 2.1f * r + t;
    float clear = 0.15f * r + 0.005f + 0.6f * t, swing = dmg_range(b, 0.8f, 3.1f);
    dmg_vec pin = v3(x, top, p->front);
    dmg_rod(b, v3(x, top + 0.5f * t, p->front), v3(x, top + 4 * t, p->front), 1.3f * t);
    uint32_t fork = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "swivel", pin, v3(0, 1, 0))
                                        : dmg_hinge(b, 0, "swivel", pin, v3(0, 1, 0), -swing, swing);
    dmg_rod(b, v3(x, top - t, p->front), v3(x, top + 0.4f * t, p->front), t);
    dmg_box_span(b, v3(x - clear - 0.4f * t, top - t, p->front - t),
                 v3(x + clear + 0.4f * t, top - 0.3f * t, p->front + t));
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3(x + (float)s * clear, top - 0.6f * t, p->front), v3(x + (float)s * clear, r, p->front - trail),
                 0.7f * t, 1.5f * t);
    dmg_rod(b, v3(x - clear, r, p->front - trail), v3(x + clear, r, p->front - trail), 0.4f * t);
    draw_pram_wheel(b, p, fork, v3(x, r, p->front - trail), r);
    dmg_use(b, 0);
}

static void draw_pram_wheels(dmg_builder* b, const pram* p, bool three, bool swivels) {
    float fork = 2.1f * p->small + 3 * p->tube, out = p->half + p->tube + 0.15f * p->big + 0.01f;
    dmg_rod(b, v3(-out, p->big, p->rear), v3(out, p->big, p->rear), 0.7f * p->tube);
    for (int s = -1; s <= 1; s += 2) draw_pram_wheel(b, p, 0, v3((float)s * out, p->big, p->rear), p->big);
    if (three) dmg_rod(b, v3(-p->half, fork, p->front), v3(p->half, fork, p->front), p->tube);
    for (int i = three ? 1 : 0; i < 3; i += 2) {
        float x = three ? 0.0f : p->half * (float)(i - 1);
        if (swivels) {
            draw_swivel(b, p, x);
            continue;
        }
        float side = x + 0.15f * p->small + 0.01f + p->tube;
        dmg_beam(b, v3(side, fork, p->front), v3(side, p->small, p->front), p->tube, 1.5f * p->tube);
        dmg_rod(b, v3(x, p->small, p->front), v3(side, p->small, p->front), 0.5f * p->tube);
        draw_pram_wheel(b, p, 0, v3(x, p->small, p->front), p->small);
        if (three) break;
    }
}

/* Side frames: one tube from the handle to the front wheel, a leg from it to the rear axle. The handle: fixed, two
 * hooks, drawn out, or folded about its joints. */
static void draw_pram_frame(dmg_builder* b, const pram* p) {
    float back = p->rear - dmg_range(b, 0.0f, 0.15f), share = dmg_range(b, 0.3f, 0.5f), far = dmg_range(b, 0.08f, 0.2f);
    int kind = dmg_int(b, 0, 3);
    dmg_vec front = v3(0, 2.1f * p->small + 3 * p->tube, p->front), top = v3(0, p->high, back),
            knee = v3_lerp(front, top, share), joint = v3_lerp(front, top, 0.8f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec x = v3((float)s * p->half, 0, 0);
        dmg_rod(b, v3_add(front, x), v3_add(kind < 2 ? top : joint, x), p->tube);
        dmg_rod(b, v3_add(knee, x), v3_add(v3(0, p->big, p->rear), x), p->tube);
        dmg_rod(b, v3_add(v3_lerp(front, top, 0.15f), x), v3_add(v3(0, p->seat - 0.04f, 0.1f * p->front), x),
                0.8f * p->tube);
    }
    dmg_vec along = v3_normalize(v3_sub(top, front));
    uint32_t handle = 0;
    if (kind == 2) handle = dmg_slide(b, 0, "handle", along, 0.0f, far);
    if (kind == 3) handle = dmg_hinge(b, 0, "handle", joint, v3(dmg_sign(b), 0, 0), -0.7f, 0.7f);
    float thin = kind == 2 ? 0.7f * p->tube : p->tube;
    for (int s = -1; s <= 1 && kind >= 2; s += 2) {
        dmg_vec x = v3((float)s * p->half, 0, 0);
        dmg_vec from = kind == 2 ? v3_mad(joint, along, -far) : joint;
        dmg_rod(b, v3_add(from, x), v3_add(top, x), thin);
        if (kind == 3) dmg_rod(b, v3_mad(v3_add(joint, x), x, -0.05f), v3_mad(v3_add(joint, x), x, 0.08f), 2 * p->tube);
    }
    for (int s = -1; s <= 1 && kind == 1; s += 2)
        dmg_capsule(b, v3((float)s * p->half, top.y, top.z), v3((float)s * p->half, top.y - 0.03f, top.z - 0.12f),
                    1.4f * p->tube);
    if (kind != 1) dmg_capsule(b, v3(-p->half, top.y, top.z), v3(p->half, top.y, top.z), 1.2f * p->tube);
    if (handle && kind == 2 && dmg_chance(b, 0.5f)) dmg_rest(b, handle, far);
    dmg_use(b, 0);
}

/* Over the head: one or two curved sheets about a line through the sides' joints; pushed back by their front. */
static void draw_hood(dmg_builder* b, uint32_t parent, dmg_vec at, float half, float radius) {
    float from = dmg_range(b, 0.5f, 0.9f), to = dmg_range(b, 2.2f, 2.8f), t = 0.02f * radius, far = 0.55f * (to - from);
    bool two = dmg_chance(b, 0.5f), cheeks = dmg_chance(b, 0.6f);
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    float mid = two ? 0.5f * (from + to) : from;
    if (!two) far = dmg_range(b, 0.6f, 1.5f);
    uint32_t hood = dmg_hinge(b, parent, "hood", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, two ? 0.8f : far);
    dmg_arc_skin(b, radius, mid, to, t, 2 * half);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (half - t);
        if (cheeks) dmg_arc_cheek(b, 0.99f * radius, mid, to, x, t, true);
        dmg_beam(b, v3(x, 0, 0), v3(x, radius * sinf(mid) * 0.98f, radius * cosf(mid) * 0.98f), t, 2 * t);
    }
    if (two) {
        dmg_hinge(b, hood, "hood_front", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, far);
        dmg_arc_skin(b, 1.03f * radius, from, mid + 0.1f, t, 2 * half + 4 * t);
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * (half + 1.5f * t);
            dmg_beam(b, v3(x, 0, 0), v3(x, radius * sinf(from), radius * cosf(from)), t, 2 * t);
        }
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Draws a seat whose back reclines, with a leg rest, a bar across and a hood. */
static void draw_pram_seat(dmg_builder* b, const pram* p) {
    float half = p->half - 1.5f * p->tube, y = p->seat, deep = 0.24f, z0 = -0.1f, z1 = z0 + deep, t = 0.03f,
          back = dmg_range(b, 0.4f, 0.5f), lean = dmg_range(b, 0.15f, 0.5f), far = dmg_range(b, 0.4f, 1.2f),
          arm = y + 0.2f;
    int bar = dmg_int(b, 0, 2);
    dmg_box_span(b, v3(-half, y - t, z0), v3(half, y, z1));
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_box_span(b, v3(fminf(x, x + (float)s * 2.6f * p->tube), y - 0.5f * t, 0),
                     v3(fmaxf(x, x + (float)s * 2.6f * p->tube), y, 0.05f));
        dmg_box_span(b, v3(x - 0.01f, y - t, z0 + 0.03f), v3(x + 0.01f, arm - 0.1f, z1));
        dmg_rod(b, v3(x, arm - 0.12f, z0 + 0.06f), v3(x, arm + 0.02f, z0 + 0.06f), 0.012f);
    }
    dmg_hinge(b, 0, "leg_rest", v3(0, y - 0.5f * t, z1 + 0.005f), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.3f));
    dmg_box_span(b, v3(-0.95f * half, y - 0.2f, z1 + 0.006f), v3(0.95f * half, y - 0.1f * t, z1 + 0.03f));
    dmg_vec top = v3(0, y + back * cosf(lean), z0 - back * sinf(lean));
    uint32_t rest = dmg_hinge(b, 0, "backrest", v3(0, y, z0), v3(-1, 0, 0), 0.0f, far);
    dmg_beam(b, v3_lerp(v3(0, y, z0), top, 0.03f), top, 2 * half - 0.03f, t);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, rest, far * dmg_unit(b));
    dmg_use(b, 0);
    if (bar > 0) { /* across the lap: swung aside or up */
        dmg_vec hook = v3(half, arm, z0 + 0.06f);
        if (bar == 1)
            dmg_hinge(b, 0, "bar", hook, v3(0, 1, 0), 0.0f, 1.7f);
        else
            dmg_hinge(b, 0, "bar", hook, v3(-1, 0, 0), 0.0f, 1.6f);
        const dmg_vec path[] = {hook,
                                v3(half, arm, z1),
                                v3(0.5f * half, arm, z1 + 0.06f),
                                v3(-0.5f * half, arm, z1 + 0.06f),
                                v3(-half, arm, z1),
                                v3(-half, arm, z0 + 0.09f)};
        dmg_sweep(b, path, 6, 0.014f, 0.014f, false);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.8f)) draw_hood(b, 0, v3(0, arm + 0.03f, z0 + 0.06f), half + 0.035f, 0.33f);
}

/* Draws a tub to lie in, with a hood at its head and a cover. */
static void draw_pram_tub(dmg_builder* b, const pram* p) {
    float half = p->half - 0.5f * p->tube, long_ = 0.4f, deep = dmg_range(b, 0.18f, 0.26f), y = p->seat + deep,
          t = 0.02f;
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_face_up(b);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * half, 2 * long_, deep, t);
    dmg_restore(b);
    dmg_box_span(b, v3(-half - p->tube, p->seat - 0.04f, -0.03f), v3(half + p->tube, p->seat, 0.03f));
    draw_hood(b, 0, v3(0, y + 0.012f, -0.1f), half, 0.28f);
    if (!dmg_chance(b, 0.6f)) return;
    dmg_hinge(b, 0, "cover", v3(0, y, long_), v3(1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.6f));
    dmg_box_span(b, v3(-half, y + 0.002f, 0.15f), v3(half, y + 0.012f, long_));
    dmg_use(b, 0);
}

void dmg_build_pushchair(dmg_builder* b) {
    pram p = {.half = dmg_range(b, 0.2f, 0.27f)};
    bool three = dmg_chance(b, 0.25f), swivels = dmg_chance(b, 0.75f), tub = dmg_chance(b, 0.3f);
    p.high = dmg_range(b, 0.95f, 1.08f);
    p.front = dmg_range(b, 0.35f, 0.48f);
    p.rear = -dmg_range(b, 0.3f, 0.45f);
    p.seat = dmg_range(b, 0.42f, 0.55f);
    p.tube = dmg_range(b, 0.01f, 0.016f);
    p.small = dmg_range(b, 0.06f, 0.11f);
    p.big = p.small * dmg_range(b, 1.0f, 1.7f);
    p.wheel = dmg_int(b, 0, DMG_WHEEL_KINDS - 1);
    p.spokes = dmg_int(b, 3, 8);
    draw_pram_frame(b, &p);
    draw_pram_wheels(b, &p, three, swivels);
    if (tub)
        draw_pram_tub(b, &p);
    else
        draw_pram_seat(b, &p);
    if (dmg_chance(b, 0.5f)) /* the basket */
        dmg_box_span(b, v3(-p.half, 1.2f * p.big, 0.8f * p.rear), v3(p.half, 1.2f * p.big + 0.02f, 0.4f * p.front));
    if (dmg_chance(b, 0.6f)) { /* trodden on to stop the wheels */
        float y = p.big + 0.6f * p.tube;
        dmg_hinge(b, 0, "brake", v3(0, p.big, p.rear), v3(-1, 0, 0), -0.3f, 0.3f);
        dmg_box_span(b, v3(-0.06f, y - 0.01f, p.rear - 0.07f), v3(0.06f, y + 0.006f, p.rear + 0.01f));
        dmg_use(b, 0);
    }
}
