/* Draws household things on stands: seats that recline, carts with folding handles, screens on arms, tables whose
 * legs fold. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- recliner: back, foot rest and arm rests each on a line of their own ---- */

void dmg_build_recliner(dmg_builder* b) {
    float width = dmg_range(b, 0.5f, 0.9f), deep = dmg_range(b, 0.45f, 0.65f), seat = dmg_range(b, 0.3f, 0.5f),
          t = dmg_range(b, 0.04f, 0.18f), tall = dmg_range(b, 0.45f, 0.8f);
    float rear = -0.5f * deep, nose = 0.5f * deep, back = dmg_range(b, 0.04f, 0.18f), lean = dmg_range(b, 0.3f, 1.3f);
    bool soft = dmg_chance(b, 0.6f);
    dmg_box_span(b, v3(-0.45f * width, 0.1f * seat, rear), v3(0.45f * width, seat - t, nose - 0.05f));
    dmg_rounded_box(b, v3(0, seat - 0.5f * t, 0), v3(width, t, deep), soft ? 0.3f * t : 0.05f * t);
    if (dmg_chance(b, 0.85f)) {
        float up = seat - t * dmg_range(b, 0.0f, 1.0f), off = back * dmg_range(b, 0.0f, 1.0f);
        uint32_t rest = dmg_hinge(b, 0, "back", v3(0, up, rear - off), v3(-1, 0, 0), -0.1f, lean);
        dmg_rounded_box(b, v3(0, seat + 0.5f * tall, rear - 0.5f * back), v3(width, tall, back),
                        soft ? 0.3f * back : 0.05f * back);
        if (dmg_chance(b, 0.4f)) {
            dmg_slide(b, rest, "head_rest", v3(0, 1, 0), 0.0f, dmg_range(b, 0.05f, 0.15f));
            dmg_box(b, v3(0, seat + tall + 0.09f, rear - 0.5f * back), v3(0.4f * width, 0.14f, 0.6f * back));
            for (int s = -1; s <= 1; s += 2)
                dmg_rod(b, v3((float)s * 0.1f * width, seat + 0.8f * tall, rear - 0.5f * back),
                        v3((float)s * 0.1f * width, seat + tall + 0.05f, rear - 0.5f * back), 0.008f);
        }
    }
    float drop = (seat - t) * dmg_range(b, 0.5f, 0.85f), thin = 0.05f;
    dmg_hinge(b, 0, "foot_rest", v3(0, seat - t, nose), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.6f));
    dmg_box_span(b, v3(-0.45f * width, seat - t - drop, nose), v3(0.45f * width, seat - t, nose + thin));
    int arms = dmg_int(b, 0, 2);
    float over = seat + dmg_range(b, 0.15f, 0.25f);
    for (int s = -1; s <= 1 && arms > 0; s += 2) { /* swung up about their rear end, or fixed */
        float x = (float)s * (0.5f * width + 0.05f);
        dmg_use(b, 0);
        dmg_box_span(b, v3(x - 0.03f, arms == 1 ? over - 0.04f : 0, rear), v3(x + 0.03f, over - 0.01f, rear + 0.06f));
        dmg_box(b, v3(x - (float)s * 0.05f, seat - 0.5f * t, rear + 0.03f), v3(0.1f, 0.6f * t, 0.05f));
        dmg_box(b, v3(x, 0.5f * (seat - t + over), rear + 0.03f), v3(0.04f, over - seat + t, 0.05f));
        if (arms == 1)
            dmg_hinge(b, 0, "arm_rest", v3(x, over, rear + 0.03f), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.6f));
        dmg_box_span(b, v3(x - 0.04f, over, rear), v3(x + 0.04f, over + 0.05f, 0.3f * deep));
    }
    dmg_use(b, 0);
}

/* ---- a flat cart: its push handle folds onto the deck, casters below ---- */

void dmg_build_flat_cart(dmg_builder* b) {
    float length = dmg_range(b, 0.6f, 1.2f), width = length * dmg_range(b, 0.45f, 0.8f),
          wheel = dmg_range(b, 0.04f, 0.09f), t = dmg_range(b, 0.02f, 0.06f), deck = 2.7f * wheel,
          tube = dmg_range(b, 0.01f, 0.02f), tall = length * dmg_range(b, 0.5f, 0.95f);
    float top = deck + t, rear = -0.5f * length + tube * dmg_range(b, 1.0f, 5.0f), x = 0.42f * width;
    dmg_rounded_box(b, v3(0, deck + 0.5f * t, 0), v3(width, t, length), 0.2f * t);
    for (int i = 0; i < 4; ++i) {
        float px = i & 1 ? x : -x, pz = i & 2 ? 0.4f * length : -0.4f * length, trail = i & 2 ? 0.4f * wheel : 0.0f;
        uint32_t fork = 0;
        dmg_use(b, 0);
        if (i & 2) fork = dmg_spin(b, 0, "caster", v3(px, 0, pz), v3(0, 1, 0));
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(px + (float)s * 0.4f * wheel - 0.004f, 0.8f * wheel, pz - trail - 0.3f * wheel),
                         v3(px + (float)s * 0.4f * wheel + 0.004f, 2.4f * wheel, pz - trail + 0.3f * wheel));
        dmg_box_span(b, v3(px - 0.45f * wheel, 2.4f * wheel, pz - trail - 0.3f * wheel),
                     v3(px + 0.45f * wheel, deck, pz + 0.5f * wheel));
        dmg_spin(b, fork, "wheel", v3(px, wheel, pz - trail), v3(1, 0, 0));
        dmg_rod(b, v3(px - 0.3f * wheel, wheel, pz - trail), v3(px + 0.3f * wheel, wheel, pz - trail), wheel);
    }
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * (x + 1.5f * tube), top + 2 * tube, rear), v3(tube, 4 * tube, 3 * tube));
    dmg_hinge(b, 0, "handle", v3(0, top + 2 * tube, rear), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.5f));
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * x, top + 2 * tube, rear), v3((float)s * x, top + tall, rear), tube);
    int bars = dmg_int(b, 1, 3);
    for (int i = 0; i < bars; ++i) {
        float y = top + tall * (1.0f - 0.3f * (float)i);
        dmg_rod(b, v3(-x, y, rear), v3(x, y, rear), tube);
    }
    dmg_use(b, 0);
}

/* ---- a table whose leg frames fold under its top ---- */

void dmg_build_folding_table(dmg_builder* b) {
    float length = dmg_range(b, 0.7f, 2.0f), width = length * dmg_range(b, 0.35f, 0.7f),
          t = dmg_range(b, 0.015f, 0.05f), tube = dmg_range(b, 0.01f, 0.025f), high = fminf(0.44f * length, 0.75f),
          z = 0.42f * width;
    bool halves = dmg_chance(b, 0.4f);
    float line = tube * dmg_range(b, 1.0f, 2.0f), apart = 0.5f * length - tube * dmg_range(b, 2.0f, 5.0f);
    dmg_move(b, 0, high, 0);
    float edge = halves ? 0.0f : 0.5f * length;
    dmg_box_span(b, v3(-0.5f * length, 0, -0.5f * width), v3(edge, t, 0.5f * width));
    uint32_t leaf = 0;
    if (halves) {
        const float upper = dmg_range(b, 1.5f, DMG_PI);
        const dmg_vec origin = v3(0, dmg_chance(b, 0.5f) ? t : t + 0.3f * tube, 0);
        leaf = dmg_hinge(b, 0, "leaf", origin, v3(0, 0, 1), 0.0f, upper);
        dmg_box_span(b, v3(0, 0, -0.5f * width), v3(0.5f * length, t, 0.5f * width));
    }
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * apart;
        uint32_t carrier = s > 0 ? leaf : 0;
        dmg_use(b, carrier);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3(x - 1.5f * tube, -2 * line, (float)k * z - 2.6f * tube),
                         v3(x + 1.5f * tube, 0, (float)k * z - 1.2f * tube));
        dmg_hinge(b, carrier, "legs", v3(x, -line, 0), v3(0, 0, -(float)s), 0.0f, dmg_range(b, 1.3f, 1.55f));
        for (int k = -1; k <= 1; k += 2) dmg_rod(b, v3(x, -line, (float)k * z), v3(x, -high, (float)k * z), tube);
        float y = -high * dmg_range(b, 0.3f, 0.95f);
        dmg_rod(b, v3(x, y, -z), v3(x, y, z), 0.9f * tube);
        dmg_rod(b, v3(x, -line, -z), v3(x, -line, z), 0.9f * tube);
    }
    dmg_use(b, 0);
}
