/* Adds small moving parts that other moving parts carry: buttons, knobs and latches on the outside of doors and lids,
 * trays in drawers. Shares and sizes are set by hand. */
#include "asset/asset_layer.h"
#include "parts/hardware.h"

static void add_button(dmg_builder* b, uint32_t carrier, float radius) {
    const float rise = radius * dmg_range(b, 0.3f, 0.8f);
    dmg_slide(b, carrier, "button", v3(0, 0, -1), 0, dmg_button_way(b, rise));
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0, -0.2f * rise), v3(0, 0, rise), 0.5f * radius);
    else
        dmg_box(b, v3(0, 0, 0.4f * rise), v3(0.9f * radius, 0.7f * radius, 1.2f * rise));
}

static void add_knob(dmg_builder* b, uint32_t carrier, float radius) {
    const float half = dmg_range(b, 0.7f, 2.6f);
    if (dmg_chance(b, 0.4f))
        dmg_spin(b, carrier, "knob", v3(0, 0, 0), v3(0, 0, 1));
    else
        dmg_hinge(b, carrier, "knob", v3(0, 0, 0), v3(0, 0, 1), 0, 2.0f * half);
    dmg_any_knob_draw(b, 0.7f * radius, 0.4f, 1.2f);
}

/* A lever that turns about a rose. */
static void add_lever(dmg_builder* b, uint32_t carrier, float radius) {
    const float side = dmg_sign(b), out = 0.5f * radius, thick = 0.12f * radius;
    dmg_use(b, carrier);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.15f * radius), 0.4f * radius);
    dmg_hinge(b, carrier, "handle", v3(0, 0, 0), v3(0, 0, side), 0, dmg_range(b, 0.5f, 1.6f));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), thick);
    dmg_box(b, v3(-side * 0.75f * radius, 0, out), v3(1.7f * radius, 0.25f * radius, 0.2f * radius));
}

/* A clasp that is lifted off the surface. */
static void add_clasp(dmg_builder* b, uint32_t carrier, float radius) {
    const float thick = 0.15f * radius;
    dmg_hinge(b, carrier, "latch", v3(0, 0.6f * radius, 0.5f * thick), v3(-1, 0, 0), 0, dmg_range(b, 1.0f, 2.8f));
    dmg_box(b, v3(0, 0, 0.5f * thick), v3(0.6f * radius, 1.2f * radius, thick));
    dmg_rod(b, v3(-0.35f * radius, 0.6f * radius, 0.5f * thick), v3(0.35f * radius, 0.6f * radius, 0.5f * thick),
            0.6f * thick);
}

static void add_on_outside(dmg_builder* b, float size) {
    static void (*const kinds[])(dmg_builder*, uint32_t, float) = {add_button, add_knob, add_lever, add_clasp};
    const float radius = size * dmg_scale_range(b, 0.015f, 0.06f);
    dmg_place place;
    if (!dmg_find_place(b, false, -0.1f, 1.1f, radius, &place) || place.clearance < 1e29f) return;
    const dmg_vec reach = v3(radius, radius, radius), o = place.frame.origin;
    const dmg_bounds box = {v3_sub(o, reach), v3_add(o, reach)};
    if (dmg_is_swept(b, place.part, &box) || b->part_count >= DMG_PART_LIMIT) return;
    dmg_enter_place(b, &place);
    kinds[dmg_int(b, 0, 3)](b, place.part, radius);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Returns how far it is from a point to the walls of the part, both ways along a direction; 0: there is none. */
static float wall_distance(const dmg_builder* b, uint32_t part, dmg_vec at, dmg_vec along, float most) {
    uint32_t face = 0;
    const float distance = dmg_cast(b, at, along, &face);
    return distance < most && b->face_part[face] == part ? distance : 0.0f;
}

/* A small tray that slides on the floor of a drawer or on that of another hollow part. */
static void add_tray(dmg_builder* b, float size) {
    dmg_place place;
    if (!dmg_find_place(b, false, 0.98f, 1.1f, 0.03f * size, &place) || b->part_count >= DMG_PART_LIMIT) return;
    const dmg_vec up = v3(0, 1, 0), at = v3_mad(place.frame.origin, up, 0.01f * size);
    const float left = wall_distance(b, place.part, at, v3(-1, 0, 0), size);
    const float right = wall_distance(b, place.part, at, v3(1, 0, 0), size);
    const float back = wall_distance(b, place.part, at, v3(0, 0, -1), size);
    const float front = wall_distance(b, place.part, at, v3(0, 0, 1), size);
    const dmg_bounds own = dmg_part_bounds(b, place.part);
    const float height = fminf(0.7f * (own.high.y - place.frame.origin.y), place.clearance * 0.9f);
    if (left <= 0 || right <= 0 || back <= 0 || front <= 0 || height < 0.02f * size) return;
    const float width = left + right, depth = back + front, share = dmg_range(b, 0.3f, 0.6f);
    const bool sideways = width > depth;
    const dmg_vec corner = v3(at.x - left, place.frame.origin.y, at.z - back);
    const float x = sideways ? share * width : width, z = sideways ? depth : share * depth;
    dmg_save(b);
    b->frames[b->frame_depth] = dmg_frame_identity();
    dmg_move(b, corner.x + 0.5f * x, corner.y, corner.z + 0.98f * z);
    const float way = 0.97f * (1.0f - share) * (sideways ? width : depth);
    dmg_slide(b, place.part, "inner_tray", sideways ? v3(1, 0, 0) : v3(0, 0, 1), 0, way);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.96f * x, height, 0.96f * z, 0.06f * fminf(x, z));
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_add_carried(dmg_builder* b) {
    const dmg_bounds whole = dmg_whole_bounds(b);
    const float size = dmg_largest_side(&whole);
    const bool outside = dmg_chance(b, 0.15f), tray = dmg_chance(b, 0.08f);
    for (int left = dmg_int(b, 1, 4); outside && left > 0; --left) add_on_outside(b, size);
    for (int left = dmg_int(b, 1, 2); tray && left > 0; --left) add_tray(b, size);
}
