/* Screws fixed hardware to an object: handles, plates, vents and studs on its faces, hinge plates, feet, trims, cables.
 * Each belongs to the surface on which it sits. Shares and sizes are set by hand. */
#include "asset/asset_layer.h"
#include "parts/hardware.h"

/* ---- on faces ---- */

static void draw_plate(dmg_builder* b, float radius) {
    const float x = radius * dmg_range(b, 0.5f, 2.0f), y = radius * dmg_range(b, 0.4f, 1.6f), z = 0.08f * radius;
    dmg_box(b, v3(0, 0, 0.5f * z), v3(x, y, z));
    if (!dmg_chance(b, 0.4f)) return;
    for (int i = 0; i < 4; ++i) {
        const float side_x = i & 1 ? 0.4f : -0.4f, side_y = i & 2 ? 0.4f : -0.4f;
        dmg_rod(b, v3(side_x * x, side_y * y, z), v3(side_x * x, side_y * y, 1.5f * z), 0.08f * radius);
    }
}

static void draw_vent(dmg_builder* b, float radius) {
    const int count = dmg_int(b, 3, 8);
    const float width = radius * dmg_range(b, 0.8f, 1.8f), step = 1.6f * radius / (float)count;
    for (int i = 0; i < count; ++i) {
        const float y = ((float)i + 0.5f) * step - 0.8f * radius;
        dmg_box(b, v3(0, y, 0.03f * radius), v3(width, 0.5f * step, 0.06f * radius));
    }
}

static void draw_studs(dmg_builder* b, float radius) {
    const int count = dmg_int(b, 2, 6);
    const float r = radius * dmg_range(b, 0.08f, 0.2f);
    for (int i = 0; i < count; ++i) {
        const float x = radius * (2.0f * (float)i / (float)(count - 1) - 1.0f) * 0.9f;
        dmg_ellipsoid(b, v3(x, 0, 0), v3(r, r, 0.7f * r));
    }
}

static void draw_emblem(dmg_builder* b, float radius) {
    enum { POINTS = 10 };
    dmg_xy star[POINTS];
    const float inner = dmg_range(b, 0.4f, 0.95f);
    for (int i = 0; i < POINTS; ++i) {
        const float angle = 2.0f * DMG_PI * (float)i / POINTS, r = 0.7f * radius * (i % 2 ? inner : 1.0f);
        star[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
    }
    dmg_extrude(b, star, POINTS, 0, 0.12f * radius);
}

static void draw_handle(dmg_builder* b, float radius) {
    const dmg_handle handle = dmg_handle_pick(b, 1.4f * radius);
    if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &handle, 1.8f * radius);
}

static void draw_strip(dmg_builder* b, float radius) {
    dmg_box(b, v3(0, 0, 0.04f * radius), v3(1.9f * radius, 0.2f * radius, 0.08f * radius));
}

static void add_on_face(dmg_builder* b, bool on_body, float size) {
    static void (*const kinds[])(dmg_builder*, float) = {draw_plate,  draw_vent,   draw_studs,
                                                         draw_emblem, draw_handle, draw_strip};
    static const float weights[] = {2, 1, 1, 1, 2, 1};
    const float radius = size * dmg_scale_range(b, 0.01f, 0.08f);
    const int kind = dmg_weighted(b, weights, 6);
    dmg_place place;
    /* Upright faces; the outside of lids as well. Nothing else of the object is near. */
    if (!dmg_find_place(b, on_body, -0.1f, on_body ? 0.1f : 1.1f, radius, &place)) return;
    if (place.clearance < (on_body ? 4.0f * radius : 1e29f)) return;
    const dmg_vec reach = v3_scale(v3(radius, radius, radius), 1.2f), o = place.frame.origin;
    const dmg_bounds box = {v3_sub(o, reach), v3_add(o, reach)};
    if (dmg_is_swept(b, place.part, &box)) return;
    dmg_enter_place(b, &place);
    kinds[kind](b, radius);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- hinge plates ---- */

/* The line of a hinge beside its leaf. */
typedef struct hinge_line {
    dmg_vec middle, axis, across; /* across: from the axis over the leaf, unit */
    float length;                 /* of the leaf along the axis */
} hinge_line;

static bool find_hinge_line(const dmg_builder* b, uint32_t part, hinge_line* out) {
    const dmg_joint* joint = &b->parts[part - 1].joint;
    if (joint->type != DM_JOINT_REVOLUTE) return false;
    const dmg_bounds box = dmg_part_bounds(b, part);
    const dmg_vec centre = v3_lerp(box.low, box.high, 0.5f), origin = v3_from(joint->origin);
    out->axis = v3_from(joint->axis);
    const float along = v3_dot(v3_sub(centre, origin), out->axis);
    out->middle = v3_mad(origin, out->axis, along);
    const dmg_vec size = v3_sub(box.high, box.low), off = v3_sub(centre, out->middle);
    out->length = fabsf(v3_dot(size, v3(fabsf(out->axis.x), fabsf(out->axis.y), fabsf(out->axis.z))));
    out->across = v3_normalize(off);
    return v3_length(off) > 0.1f * out->length;
}

/* Screws a plate to what the ray meets, when that is of the part. */
static void add_hinge_plate(dmg_builder* b, const hinge_line* line, dmg_vec at, dmg_vec out, uint32_t part, float width,
                            float tall) {
    uint32_t face = 0;
    const float reach = 0.5f * line->length,
                distance = dmg_cast(b, v3_mad(at, out, reach), v3_scale(out, -1.0f), &face);
    if (distance > 1.5f * reach || b->face_part[face] != part) return;
    const dmg_place place = {
        .frame = {{line->across, line->axis, v3_cross(line->across, line->axis)}, v3_mad(at, out, reach - distance)},
        .part = part};
    dmg_enter_place(b, &place);
    dmg_box(b, v3(0, 0, 0), v3(width, tall, 0.16f * width));
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Screws pairs of plates along the hinge, one half on the leaf, one on what carries it. */
static void add_hinge_plates(dmg_builder* b, uint32_t part) {
    hinge_line line;
    if (!find_hinge_line(b, part, &line)) return;
    const int count = dmg_int(b, 2, 3);
    const float tall = line.length * dmg_range(b, 0.06f, 0.15f), width = tall * dmg_range(b, 0.3f, 1.0f);
    const float inset = dmg_range(b, 0.25f, 0.42f), side = dmg_sign(b);
    const dmg_vec out = v3_scale(v3_cross(line.axis, line.across), side);
    for (int i = 0; i < count; ++i) {
        const float along = line.length * inset * (2.0f * (float)i / (float)(count - 1) - 1.0f);
        const dmg_vec at = v3_mad(line.middle, line.axis, along);
        add_hinge_plate(b, &line, v3_mad(at, line.across, 0.6f * width), out, part, width, tall);
        add_hinge_plate(b, &line, v3_mad(at, line.across, -0.6f * width), out, b->parts[part - 1].joint.parent, width,
                        tall);
    }
}

/* ---- round the body ---- */

/* Whether the body reaches its box's floor, or its top, near all four corners and, if asked for, in the middle. */
static bool has_corners(const dmg_builder* b, const dmg_bounds* body, bool at_top, bool and_middle) {
    const dmg_vec size = v3_sub(body->high, body->low), middle = v3_lerp(body->low, body->high, 0.5f);
    const float off = 0.02f * dmg_largest_side(body), y = at_top ? body->high.y + off : body->low.y - off;
    const dmg_vec inwards = v3(0, at_top ? -1.0f : 1.0f, 0);
    uint32_t face = 0;
    for (int i = 0; i < (and_middle ? 5 : 4); ++i) {
        const float x = i == 4 ? 0.0f : i & 1 ? 0.43f : -0.43f, z = i == 4 ? 0.0f : i & 2 ? 0.43f : -0.43f;
        const dmg_vec from = v3(middle.x + x * size.x, y, middle.z + z * size.z);
        if (dmg_cast(b, from, inwards, &face) > 1.5f * off || b->face_part[face] != 0) return false;
    }
    return true;
}

static void add_feet(dmg_builder* b, const dmg_bounds* body, const dmg_bounds* whole) {
    if (body->low.y > whole->low.y + 0.01f * dmg_largest_side(whole) || !has_corners(b, body, false, false)) return;
    const dmg_vec size = v3_sub(body->high, body->low), middle = v3_lerp(body->low, body->high, 0.5f);
    const float height = dmg_largest_side(body) * dmg_range(b, 0.02f, 0.12f);
    dmg_save(b);
    b->frames[b->frame_depth] = dmg_frame_identity();
    dmg_move(b, middle.x, body->low.y - height, middle.z);
    dmg_use(b, 0);
    dmg_feet_draw(b, dmg_int(b, 0, DMG_FEET_KINDS - 1), 0.9f * size.x, 0.9f * size.z, height);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void add_if_unswept(dmg_builder* b, dmg_vec low, dmg_vec high) {
    const dmg_bounds box = {low, high};
    if (!dmg_is_swept(b, 0, &box)) dmg_box_span(b, low, high);
}

/* A cornice, or posts up the edges. */
static void add_trims(dmg_builder* b, const dmg_bounds* body) {
    const dmg_vec size = v3_sub(body->high, body->low);
    const float thick = dmg_largest_side(body) * dmg_range(b, 0.01f, 0.04f), out = thick * dmg_range(b, 0, 1.0f);
    const bool cornice = dmg_chance(b, 0.5f), posts = dmg_chance(b, 0.5f);
    if (cornice && has_corners(b, body, true, true)) { /* over an opening it would be a lid */
        const dmg_vec low = v3(body->low.x - out, body->high.y, body->low.z - out);
        add_if_unswept(b, low, v3_add(low, v3(size.x + 2.0f * out, thick, size.z + 2.0f * out)));
    }
    if (!posts || !has_corners(b, body, true, false)) return;
    for (int i = 0; i < 4; ++i) {
        const dmg_vec low =
            v3(i & 1 ? body->high.x : body->low.x - thick, body->low.y, i & 2 ? body->high.z - thick : body->low.z);
        add_if_unswept(b, low, v3_add(low, v3(thick, size.y, thick)));
    }
}

/* A cable from the back to the floor. */
static void add_cable(dmg_builder* b, const dmg_bounds* body) {
    enum { KNOTS = 5 };
    const float size = dmg_largest_side(body), x = dmg_range(b, body->low.x, body->high.x);
    const float y = body->low.y + dmg_range(b, 0.1f, 0.5f) * (body->high.y - body->low.y), off = size * 0.1f;
    const float radius = size * dmg_range(b, 0.004f, 0.01f), z = body->low.z;
    const dmg_vec path[KNOTS] = {{x, y, z + radius},
                                 {x, y, z - 0.5f * off},
                                 {x, body->low.y + 0.3f * (y - body->low.y), z - off},
                                 {x + off, body->low.y + radius, z - 1.5f * off},
                                 {x + 3.0f * off, body->low.y + radius, z - 1.5f * off}};
    dmg_sweep(b, path, KNOTS, radius, radius, false);
}

void dmg_add_fixtures(dmg_builder* b) {
    const dmg_bounds whole = dmg_whole_bounds(b), body = dmg_part_bounds(b, 0);
    const float size = dmg_largest_side(&whole);
    const bool on_body = dmg_chance(b, 0.35f), on_parts = dmg_chance(b, 0.2f), plates = dmg_chance(b, 0.25f);
    const bool has_body = body.low.x <= body.high.x, feet = dmg_chance(b, 0.12f) && has_body,
               trims = dmg_chance(b, 0.12f) && has_body, cable = dmg_chance(b, 0.05f) && has_body;
    const uint32_t parts = b->part_count;
    for (uint32_t part = 1; plates && part <= parts; ++part) add_hinge_plates(b, part);
    for (int left = dmg_int(b, 1, 5); on_body && left > 0; --left) add_on_face(b, true, size);
    for (int left = dmg_int(b, 1, 4); on_parts && left > 0; --left) add_on_face(b, false, size);
    if (feet) add_feet(b, &body, &whole);
    if (trims) add_trims(b, &body);
    if (cable) add_cable(b, &body);
}
