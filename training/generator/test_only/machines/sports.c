/* Draws gym machines: exercise bicycles, towers with weights, benches whose backs are raised, rowers. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a tube that slides in one that stands; a pin beside it holds it. Leaves the slider in use. */
static uint32_t draw_post(dmg_builder* b, const char* name, dmg_vec foot, float sleeve, float length, float r) {
    dmg_rod(b, foot, v3(foot.x, foot.y + sleeve, foot.z), 1.3f * r);
    dmg_slide(b, 0, "pop_pin", v3(0, 0, -1), 0.0f, 0.8f * r);
    dmg_rod(b, v3(foot.x, foot.y + 0.85f * sleeve, foot.z - 3 * r),
            v3(foot.x, foot.y + 0.85f * sleeve, foot.z - 1.1f * r), 0.5f * r);
    dmg_ellipsoid(b, v3(foot.x, foot.y + 0.85f * sleeve, foot.z - 3.2f * r), v3(r, r, r));
    dmg_use(b, 0);
    uint32_t post = dmg_slide(b, 0, name, v3(0, 1, 0), 0.0f, 0.6f * sleeve);
    dmg_rod(b, v3(foot.x, foot.y + 0.2f * sleeve, foot.z), v3(foot.x, foot.y + sleeve + length, foot.z), r);
    return post;
}

/* Cranks on one axle at the height y, a pedal at the end of each. */
static void draw_pedals(dmg_builder* b, float y, float crank, float r) {
    uint32_t axle = dmg_spin(b, 0, "crank", v3(0, y, 0), v3(1, 0, 0));
    dmg_rod(b, v3(-3.2f * r, y, 0), v3(3.2f * r, y, 0), 0.7f * r);
    for (int i = -1; i <= 1; i += 2) {
        float s = (float)i, x = s * 3.2f * r;
        dmg_use(b, axle);
        dmg_beam(b, v3(x, y, 0), v3(x, y, s * crank), 0.6f * r, 1.2f * r);
        dmg_spin(b, axle, "pedal", v3(x, y, s * crank), v3(1, 0, 0));
        dmg_rod(b, v3(x, y, s * crank), v3(x + s * 5 * r, y, s * crank), 0.4f * r);
        dmg_box(b, v3(x + s * 3 * r, y, s * crank), v3(3.6f * r, 1.1f * r, 3.6f * r));
    }
    dmg_use(b, 0);
}

static void draw_exercise_bike(dmg_builder* b) {
    float r = dmg_range(b, 0.018f, 0.03f), half = dmg_range(b, 0.35f, 0.5f), crank = dmg_range(b, 0.12f, 0.18f),
          wheel = dmg_range(b, 0.16f, 0.26f), y = dmg_range(b, 0.3f, 0.38f);
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), spokes = dmg_int(b, 4, 7);
    bool shroud = dmg_chance(b, 0.4f);
    float z = 0.6f * half, seat = y + dmg_range(b, 0.1f, 0.2f);
    for (int i = -1; i <= 1; i += 2) dmg_rod(b, v3(-0.25f, r, (float)i * half), v3(0.25f, r, (float)i * half), r);
    dmg_beam(b, v3(0, r, -half), v3(0, r, half), 2 * r, 2 * r);
    dmg_beam(b, v3(0, r, 0), v3(0, y, 0), 2.4f * r, 2.4f * r);
    dmg_beam(b, v3(0, y, 0), v3(0, seat, -0.5f * half), 2 * r, 2 * r);
    for (int i = -1; i <= 1; i += 2)
        dmg_beam(b, v3((float)i * 2.2f * r, r, z), v3((float)i * 2.2f * r, y + 0.25f, z), 0.8f * r, 1.6f * r);
    dmg_beam(b, v3(0, y, 0), v3(0, y + 0.28f, z), 1.5f * r, 2 * r);
    dmg_box(b, v3(0, y + 0.26f, z), v3(5.2f * r, 3 * r, 3 * r));
    dmg_spin(b, 0, "flywheel", v3(0, wheel + 3 * r, z), v3(1, 0, 0));
    dmg_save(b);
    dmg_move(b, 0, wheel + 3 * r, z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_wheel_draw(b, kind, fminf(wheel, y + 0.2f - wheel), 2 * r, spokes);
    dmg_restore(b);
    dmg_rod(b, v3(-2 * r, wheel + 3 * r, z), v3(2 * r, wheel + 3 * r, z), 0.6f * r);
    dmg_use(b, 0);
    if (shroud) dmg_rod(b, v3(1.3f * r, y, 0), v3(1.8f * r, y, 0), 0.8f * crank);
    draw_pedals(b, y, crank, r);
    uint32_t post = draw_post(b, "seat_post", v3(0, seat, -0.5f * half), 0.2f, 0.12f, r);
    dmg_slide(b, post, "saddle", v3(0, 0, 1), -0.05f, 0.05f);
    dmg_rounded_box(b, v3(0, seat + 0.345f, -0.5f * half), v3(0.2f, 0.05f, 0.24f), 0.02f);
    dmg_use(b, 0);
    draw_post(b, "bar_post", v3(0, y + 0.26f, z), 0.25f, 0.15f, r);
    dmg_rod(b, v3(-0.22f, y + 0.66f, z), v3(0.22f, y + 0.66f, z), 0.8f * r);
    for (int i = -1; i <= 1; i += 2)
        dmg_rod(b, v3((float)i * 0.2f, y + 0.66f, z), v3((float)i * 0.2f, y + 0.7f, z - 0.15f), 0.8f * r);
    dmg_use(b, 0);
    dmg_screw(b, 0, "resistance", v3(0, y + 0.16f, 0.45f * z), v3(0, 0.85f, -0.5f), 0.001f, 0.0f, 12.0f);
    dmg_rod(b, v3(0, y + 0.1f, 0.45f * z), v3(0, y + 0.22f, 0.45f * z - 0.06f), 1.1f * r);
    dmg_use(b, 0);
}

/* Plates on two rods, a pin in one of them: those above it go up together. */
static void draw_stack(dmg_builder* b, float x, float z, float high) {
    int plates = dmg_int(b, 6, 14), chosen = dmg_int(b, 2, plates - 2);
    float each = 0.032f, low = 0.12f, way = fminf(0.6f, high - low - each * (float)plates - 0.15f),
          top = low + each * (float)plates;
    for (int i = -1; i <= 1; i += 2)
        dmg_rod(b, v3(x + (float)i * 0.09f, 0.05f, z), v3(x + (float)i * 0.09f, high, z), 0.01f);
    uint32_t moved = 0;
    for (int i = 0; i < plates; ++i) {
        if (i == chosen) moved = dmg_slide(b, 0, "weights", v3(0, 1, 0), 0.0f, way);
        float y = low + each * ((float)i + 0.5f);
        for (int s = -1; s <= 1; ++s) /* let round the rods */
            dmg_box(b, v3(x + (float)s * 0.12f, y, z), v3(s ? 0.035f : 0.15f, 0.9f * each, 0.1f));
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(x, y, z + (float)s * 0.035f), v3(0.26f, 0.9f * each, 0.03f));
    }
    dmg_rod(b, v3(x, top, z), v3(x, top + 0.12f, z), 0.015f);
    dmg_slide(b, moved, "pin", v3(0, 0, 1), 0.0f, 0.06f);
    dmg_rod(b, v3(x, low + each * ((float)chosen + 0.5f), z + 0.045f),
            v3(x, low + each * ((float)chosen + 0.5f), z + 0.1f), 0.009f);
    dmg_use(b, 0);
    dmg_box(b, v3(x, 0.5f * low, z), v3(0.28f, low, 0.1f));
}

/* Draws an arm that the legs or the arms push: up from the knee, in from the sides, down from above, away on a
 * carriage. */
static void draw_moved_arm(dmg_builder* b, float seat, float high) {
    float reach = dmg_range(b, 0.35f, 0.5f), z = 0.5f, t = 0.03f;
    switch (dmg_int(b, 0, 2)) {
    case 0:
        dmg_box_span(b, v3(-0.2f, seat - 0.1f, 0.2f), v3(0.2f, seat - 0.02f, z));
        for (int i = -1; i <= 1; i += 2)
            dmg_box_span(b, v3((float)i * 0.22f - t, seat - 0.12f, z - 0.1f),
                         v3((float)i * 0.22f + t, seat, z + 0.06f));
        uint32_t arm =
            dmg_hinge(b, 0, "leg_arm", v3(0, seat - 0.06f, z + 0.03f), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.9f));
        dmg_rod(b, v3(-0.2f, seat - 0.06f, z + 0.03f), v3(0.2f, seat - 0.06f, z + 0.03f), t);
        dmg_beam(b, v3(0, seat - 0.06f, z + 0.03f), v3(0, seat - 0.06f - reach, z + 0.03f), 1.5f * t, 1.5f * t);
        dmg_spin(b, arm, "roller", v3(0, seat - 0.06f - reach, z + 0.06f), v3(1, 0, 0));
        dmg_rod(b, v3(-0.2f, seat - 0.06f - reach, z + 0.06f), v3(0.2f, seat - 0.06f - reach, z + 0.06f), 0.05f);
        break;
    case 1:
        for (int i = -1; i <= 1; i += 2) {
            float s = (float)i, x = s * 0.3f, y = seat + 0.55f;
            dmg_use(b, 0);
            dmg_box_span(b, v3(fminf(0, x) - t, y + 0.2f, -0.1f), v3(fmaxf(0, x) + t, y + 0.28f, -0.02f));
            uint32_t wing = dmg_hinge(b, 0, "wing", v3(x, y, -0.06f), v3(0, -s, 0), 0.0f, 1.4f);
            dmg_rod(b, v3(x, y - 0.15f, -0.06f), v3(x, y + 0.2f, -0.06f), t);
            dmg_beam(b, v3(x, y - 0.1f, -0.06f), v3(x + s * reach, y - 0.1f, 0), 1.3f * t, 1.3f * t);
            dmg_hinge(b, wing, "pad", v3(x + s * reach, y - 0.1f, 0), v3(0, 1, 0), -0.3f, 0.3f);
            dmg_rounded_box(b, v3(x + s * reach, y - 0.1f, 0.04f), v3(0.12f, 0.36f, 0.08f), 0.03f);
        }
        break;
    default:
        dmg_rod(b, v3(0, high - 0.03f, -0.1f), v3(0, high - 0.03f, 0.32f), 0.03f);
        dmg_spin(b, 0, "pulley", v3(0, high - 0.12f, 0.3f), v3(1, 0, 0));
        dmg_rod(b, v3(-0.015f, high - 0.12f, 0.3f), v3(0.015f, high - 0.12f, 0.3f), 0.06f);
        dmg_use(b, 0);
        dmg_box_span(b, v3(-0.03f, high - 0.13f, 0.29f), v3(-0.018f, high, 0.31f));
        dmg_slide(b, 0, "lat_bar", v3(0, -1, 0), 0.0f, 0.6f * (high - seat - 0.6f));
        dmg_rod(b, v3(0, high - 0.35f, 0.36f), v3(0, high - 0.13f, 0.36f), 0.008f);
        dmg_rod(b, v3(-0.4f, high - 0.35f, 0.36f), v3(0.4f, high - 0.35f, 0.36f), 0.016f);
        for (int i = -1; i <= 1; i += 2)
            dmg_rod(b, v3((float)i * 0.4f, high - 0.35f, 0.36f), v3((float)i * 0.52f, high - 0.43f, 0.36f), 0.018f);
        break;
    }
    dmg_use(b, 0);
}

static void draw_weight_tower(dmg_builder* b) {
    float high = dmg_range(b, 1.7f, 2.2f), seat = dmg_range(b, 0.42f, 0.52f), z = -0.35f;
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * 0.2f - 0.025f, 0, z - 0.04f), v3((float)i * 0.2f + 0.025f, high, z + 0.04f));
    dmg_box_span(b, v3(-0.225f, high - 0.06f, z - 0.04f), v3(0.225f, high, -0.02f));
    dmg_box_span(b, v3(-0.03f, 0, -0.08f), v3(0.03f, high, -0.02f));
    dmg_box_span(b, v3(-0.3f, 0, z - 0.1f), v3(0.3f, 0.05f, z + 0.1f));
    dmg_box_span(b, v3(-0.04f, 0, z), v3(0.04f, 0.05f, 0.5f));
    dmg_box_span(b, v3(-0.035f, 0, 0.15f), v3(0.035f, seat - 0.15f, 0.22f));
    draw_stack(b, 0, z, high - 0.05f);
    dmg_slide(b, 0, "seat", v3(0, 1, 0), 0.0f, 0.12f);
    dmg_box_span(b, v3(-0.02f, seat - 0.2f, 0.165f), v3(0.02f, seat, 0.205f));
    dmg_rounded_box(b, v3(0, seat + 0.04f, 0.2f), v3(0.36f, 0.08f, 0.38f), 0.03f);
    dmg_use(b, 0);
    dmg_rounded_box(b, v3(0, seat + 0.5f, 0), v3(0.28f, 0.5f, 0.07f), 0.03f);
    draw_moved_arm(b, seat, high);
}

/* The back is raised on a strut in a row of notches; the seat tips a little; rollers for the feet. */
static void draw_bench(dmg_builder* b) {
    float y = dmg_range(b, 0.36f, 0.48f), back = dmg_range(b, 0.65f, 0.85f), seat = dmg_range(b, 0.28f, 0.4f),
          w = dmg_range(b, 0.22f, 0.32f), up = dmg_range(b, 0.9f, 1.5f), t = 0.025f;
    bool declines = dmg_chance(b, 0.4f), rollers = dmg_chance(b, 0.5f), seats = dmg_chance(b, 0.7f);
    float rest = up * dmg_unit(b);
    dmg_beam(b, v3(0, y - 0.09f, -back), v3(0, y - 0.09f, seat), 0.06f, 0.06f);
    for (int i = -1; i <= 1; i += 2) {
        float z = i > 0 ? seat - 0.05f : -0.85f * back;
        dmg_box_span(b, v3(-0.03f, 0, z - 0.03f), v3(0.03f, y - 0.08f, z + 0.03f));
        dmg_box_span(b, v3(-0.25f, 0, z - 0.03f), v3(0.25f, 0.05f, z + 0.03f));
    }
    dmg_box_span(b, v3(-0.04f, y - 0.1f, -0.03f), v3(0.04f, y - 0.03f, 0.03f));
    uint32_t rear = dmg_hinge(b, 0, "backrest", v3(0, y - 0.03f, -0.01f), v3(1, 0, 0), declines ? -0.05f : 0.0f, up);
    dmg_rest(b, rear, rest);
    dmg_rounded_box(b, v3(0, y + 0.03f, -0.5f * back - 0.01f), v3(w, 0.06f, back - 0.03f), 0.02f);
    dmg_box_span(b, v3(-t, y - 0.04f, -0.9f * back), v3(t, y + 0.01f, -0.03f));
    dmg_use(b, 0);
    if (seats) dmg_hinge(b, 0, "seat", v3(0, y - 0.03f, 0.01f), v3(-1, 0, 0), 0.0f, 0.5f);
    dmg_rounded_box(b, v3(0, y + 0.03f, 0.5f * seat + 0.02f), v3(w, 0.06f, seat - 0.02f), 0.02f);
    dmg_box_span(b, v3(-t, y - 0.04f, 0.015f), v3(t, y + 0.01f, 0.9f * seat));
    dmg_use(b, 0);
    dmg_slide(b, 0, "pop_pin", v3(1, 0, 0), 0.0f, 0.02f);
    dmg_rod(b, v3(0.03f, y - 0.09f, -0.2f * back), v3(0.07f, y - 0.09f, -0.2f * back), 0.01f);
    dmg_rod(b, v3(0.07f, y - 0.09f, -0.2f * back), v3(0.09f, y - 0.09f, -0.2f * back), 0.02f);
    dmg_use(b, 0);
    if (!rollers) return;
    float z = seat + 0.08f;
    dmg_beam(b, v3(0, y - 0.09f, seat - 0.03f), v3(0, y - 0.09f, z), 0.05f, 0.05f);
    uint32_t arm = dmg_hinge(b, 0, "leg_arm", v3(0, y - 0.09f, z), v3(-1, 0, 0), 0.0f, 1.5f);
    dmg_beam(b, v3(0, y - 0.09f, z), v3(0, 0.1f, z), 0.05f, 0.04f);
    dmg_spin(b, arm, "roller", v3(0, 0.12f, z + 0.03f), v3(1, 0, 0));
    dmg_rod(b, v3(-0.2f, 0.12f, z + 0.03f), v3(0.2f, 0.12f, z + 0.03f), 0.05f);
}

/* Draws a seat on a rail; a fan in its cage; plates for the feet; the bar on its cord. */
static void draw_rower(dmg_builder* b) {
    float length = dmg_range(b, 1.2f, 1.5f), y = dmg_range(b, 0.3f, 0.45f), r = dmg_range(b, 0.2f, 0.26f), z = 0.45f,
          way = 0.75f * length, rest = way * dmg_unit(b);
    bool folds = dmg_chance(b, 0.4f);
    dmg_beam(b, v3(0, y - 0.03f, 0.1f), v3(0, y - 0.03f, z), 0.07f, 0.08f);
    dmg_box_span(b, v3(-0.05f, 0, 0.05f), v3(0.05f, y, 0.12f));
    dmg_box_span(b, v3(-0.3f, 0, z + 0.05f), v3(0.3f, 0.06f, z + 0.15f));
    for (int i = -1; i <= 1; i += 2)
        dmg_beam(b, v3((float)i * 0.08f, 0.03f, z + 0.1f), v3((float)i * 0.08f, y + 0.15f, z + 0.1f), 0.02f, 0.05f);
    dmg_beam(b, v3(-0.09f, y, z), v3(0.09f, y, z), 0.05f, 0.05f);
    dmg_spin(b, 0, "fan", v3(0, y + 0.12f, z + 0.1f), v3(1, 0, 0));
    dmg_save(b);
    dmg_move(b, 0, y + 0.12f, z + 0.1f);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_wheel_draw(b, dmg_int(b, 0, 3), r, 0.08f, 8);
    dmg_restore(b);
    dmg_rod(b, v3(-0.08f, y + 0.12f, z + 0.1f), v3(0.08f, y + 0.12f, z + 0.1f), 0.015f);
    dmg_use(b, 0);
    uint32_t rail = folds ? dmg_hinge(b, 0, "rail", v3(0, y - 0.06f, 0.04f), v3(1, 0, 0), 0.0f, 1.5f) : 0;
    dmg_box_span(b, v3(-0.03f, y - 0.06f, -length), v3(0.03f, y, 0.04f));
    dmg_box_span(b, v3(-0.2f, 0, -length), v3(0.2f, 0.05f, -length + 0.06f));
    dmg_box_span(b, v3(-0.03f, 0, -length), v3(0.03f, y, -length + 0.05f));
    uint32_t seat = dmg_slide(b, rail, "seat", v3(0, 0, 1), 0.0f, way);
    dmg_rest(b, seat, rest);
    dmg_rounded_box(b, v3(0, y + 0.05f, -length + 0.15f), v3(0.3f, 0.07f, 0.22f), 0.03f);
    dmg_box(b, v3(0, y + 0.005f, -length + 0.15f), v3(0.1f, 0.03f, 0.16f));
    for (int i = -1; i <= 1; i += 2) {
        float x = (float)i * 0.13f;
        dmg_use(b, 0);
        dmg_box_span(b, v3(fminf(x, 0), y - 0.04f, 0.12f), v3(fmaxf(x, 0), y, 0.16f));
        dmg_hinge(b, 0, "foot_plate", v3(x, y, 0.14f), v3(1, 0, 0), -0.3f, 0.3f);
        dmg_beam(b, v3(x, y, 0.11f), v3(x, y + 0.25f, 0.19f), 0.1f, 0.02f);
    }
    dmg_use(b, 0);
    dmg_slide(b, 0, "handle", v3(0, 0, -1), 0.0f, 0.6f * length);
    dmg_rod(b, v3(-0.22f, y + 0.42f, 0.25f), v3(0.22f, y + 0.42f, 0.25f), 0.016f);
    dmg_rod(b, v3(0, y + 0.42f, 0.25f), v3(0, y + 0.42f, z + 0.1f), 0.005f);
    dmg_use(b, 0);
    dmg_box_span(b, v3(-0.09f, y + 0.1f, z + 0.11f), v3(-0.07f, y + 0.5f, z + 0.15f));
    dmg_box_span(b, v3(-0.09f, y + 0.41f, z + 0.08f), v3(0.04f, y + 0.45f, z + 0.14f));
}

void dmg_build_gym_machine(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 4, 2, 2}, 4);
    if (kind == 0) draw_exercise_bike(b);
    if (kind == 1) draw_weight_tower(b);
    if (kind == 2) draw_bench(b);
    if (kind == 3) draw_rower(b);
}
