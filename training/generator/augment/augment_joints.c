/* Makes joints as inexact as those that people place by eye. The error is bounded by the displacement it causes at the
 * end of the part's range: a hinge stays nearly exact, the axis of a button that moves little may lean by degrees. */
#include "core/build.h"

static float farthest_from_axis(const dmg_builder* b, uint32_t part, const dmg_joint* joint) {
    const dmg_vec axis = v3_from(joint->axis), origin = v3_from(joint->origin);
    float most = 0.0f;
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v)
            most = fmaxf(most, v3_length(v3_cross(axis, v3_sub(b->vertices[v], origin))));
    }
    return most;
}

/* Draws a unit vector at right angles to the axis. */
static dmg_vec across(dmg_builder* b, dmg_vec axis) {
    float x = dmg_normal(b), y = dmg_normal(b), z = dmg_normal(b);
    return v3_normalize(v3_cross(axis, v3_normalize(v3(x, y, z))));
}

/* Tilts the axis, and shifts a turning joint's line, so that the part ends about `seen` metres beside where it would
 * have.
 */
static void loosen(dmg_builder* b, uint32_t part, float seen) {
    dmg_joint* joint = &b->parts[part - 1].joint;
    const float range = joint->upper - joint->lower;
    if (joint->type == DM_JOINT_CONTINUOUS || joint->type == DM_JOINT_SCREW || range <= 0.0f) return;
    const bool slides = joint->type == DM_JOINT_PRISMATIC;
    const float reach = slides ? 1.0f : farthest_from_axis(b, part, joint);
    const float lean = fminf(seen / fmaxf(range * reach, 1e-6f), 0.12f) * dmg_normal(b);
    const dmg_vec axis = v3_from(joint->axis);
    v3_to(v3_normalize(v3_mad(axis, across(b, axis), lean)), joint->axis);
    if (slides) return;
    const float off = fminf(seen / range, 0.1f * reach) * dmg_normal(b);
    v3_to(v3_mad(v3_from(joint->origin), across(b, axis), off), joint->origin);
}

void dmg_augment_joints(dmg_builder* b, float size) {
    if (!dmg_chance(b, 0.4f)) return;
    const float seen = size * dmg_scale_range(b, 0.0005f, 0.004f);
    for (uint32_t part = 1; part <= b->part_count; ++part) loosen(b, part, seen);
}
