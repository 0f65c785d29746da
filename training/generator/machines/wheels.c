/* Draws wheels under things. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct wheel_set {
    int kind, spokes;
    float radius, width;
} wheel_set;

static wheel_set pick_wheels(dmg_builder* b, float radius) {
    wheel_set wheels = {.kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), .spokes = dmg_int(b, 3, 8), .radius = radius};
    wheels.width = radius * dmg_scale_range(b, 0.12f, 1.0f);
    return wheels;
}

/* Draws a wheel part at the current origin, axle along X. */
static void draw_axle_wheel(dmg_builder* b, const wheel_set* wheels, uint32_t parent) {
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, parent, "wheel", v3(0, 0, 0), v3(0, 0, 1));
    dmg_wheel_draw(b, wheels->kind, wheels->radius, wheels->width, wheels->spokes);
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Draws a cart: a body on two axles. */
static void draw_cart(dmg_builder* b, const wheel_set* wheels) {
    float width = wheels->radius * dmg_range(b, 2.0f, 5.0f), length = wheels->radius * dmg_range(b, 4.0f, 10.0f),
          height = wheels->radius * dmg_range(b, 0.6f, 3.0f);
    float floor = wheels->radius * dmg_range(b, 0.7f, 1.5f), base = length * dmg_range(b, 0.3f, 0.42f);
    int shape = dmg_int(b, 0, 3), axles = dmg_chance(b, 0.15f) ? 3 : 2;
    if (shape == 0) dmg_box(b, v3(0, floor + 0.5f * height, 0), v3(width, height, length));
    if (shape == 1) dmg_rounded_box(b, v3(0, floor + 0.5f * height, 0), v3(width, height, length), 0.3f * height);
    if (shape >= 2) {
        dmg_box(b, v3(0, floor + 0.1f * height, 0), v3(width, 0.2f * height, length));
        dmg_save(b);
        dmg_move(b, 0, floor + height, -0.1f * length);
        dmg_face_up(b);
        if (shape == 2) dmg_case_draw(b, dmg_case_pick(b), 0.9f * width, 0.7f * length, 0.8f * height, 0.05f * width);
        dmg_restore(b);
        if (shape == 3)
            dmg_box(b, v3(0, floor + 0.6f * height, 0.25f * length), v3(0.8f * width, height, 0.35f * length));
    }
    bool rods = dmg_chance(b, 0.5f), inside = dmg_chance(b, 0.3f);
    float x = inside ? 0.5f * width - 0.5f * wheels->width : 0.5f * width + 0.55f * wheels->width;
    for (int i = 0; i < 2 * axles; ++i) {
        float z = base * (2.0f * (float)(i / 2) / (float)(axles - 1) - 1.0f);
        if (rods && i % 2 == 0) dmg_rod(b, v3(-x, wheels->radius, z), v3(x, wheels->radius, z), 0.1f * wheels->radius);
        dmg_save(b);
        dmg_move(b, i % 2 ? x : -x, wheels->radius, z);
        draw_axle_wheel(b, wheels, 0);
        dmg_restore(b);
    }
}

/* Draws a barrow or trolley: wheels in forks, a handle bar. */
static void draw_fork(dmg_builder* b, const wheel_set* wheels) {
    float r = wheels->radius, half = 0.6f * wheels->width + 0.05f * r, arm = r * dmg_range(b, 1.5f, 5.0f),
          lean = dmg_range(b, -0.5f, 0.8f);
    dmg_vec axle = {0, r, 0}, top = {0, r + arm * cosf(lean), -arm * sinf(lean)};
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec side = {(float)s * half, 0, 0};
        dmg_beam(b, v3_add(axle, side), v3_add(top, side), 0.08f * r, 0.2f * r);
    }
    dmg_beam(b, v3_add(top, v3(-half, 0, 0)), v3_add(top, v3(half, 0, 0)), 0.2f * r, 0.2f * r);
    if (dmg_chance(b, 0.6f))
        dmg_box(b, v3_add(top, v3(0, 0.3f * r, -0.8f * r)), v3(dmg_range(b, 1.0f, 3.0f) * r, 0.6f * r, 2.5f * r));
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(-half, r, 0), v3(half, r, 0), 0.1f * r);
    dmg_move(b, 0, r, 0);
    draw_axle_wheel(b, wheels, 0);
}

/* A wheel on a bracket against a wall or on a stand. */
static void draw_stand(dmg_builder* b, const wheel_set* wheels) {
    float r = wheels->radius, high = r * dmg_range(b, 1.2f, 3.0f), back = wheels->width * dmg_range(b, 0.6f, 2.0f);
    dmg_box(b, v3(0, 0.5f * high, -back), v3(0.3f * r, high, 0.3f * r));
    dmg_box(b, v3(0, 0.03f * r, -back), v3(1.4f * r, 0.06f * r, 1.2f * r));
    dmg_rod(b, v3(0, high, -back), v3(0, high, 0.3f * wheels->width), 0.12f * r);
    dmg_spin(b, 0, "wheel", v3(0, high, 0), v3(0, 0, 1));
    dmg_save(b);
    dmg_move(b, 0, high, 0);
    dmg_wheel_draw(b, wheels->kind, r, wheels->width, wheels->spokes);
    if (dmg_chance(b, 0.3f))
        dmg_rod(b, v3(0.8f * r, 0, 0), v3(0.8f * r, 0, wheels->width + 0.4f * r), 0.08f * r); /* crank pin */
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_wheel(dmg_builder* b) {
    wheel_set wheels = pick_wheels(b, dmg_scale_range(b, 0.03f, 0.6f));
    static const float weights[] = {5, 2, 2};
    int kind = dmg_weighted(b, weights, 3);
    if (kind == 0) draw_cart(b, &wheels);
    if (kind == 1) draw_fork(b, &wheels);
    if (kind == 2) draw_stand(b, &wheels);
}
