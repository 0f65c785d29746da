/* Makes things that look like parts and stay: blind drawer fronts, fixed panels, objects without any moving part. What
 * stays is changed so that a person would say so too: a blind front has no box behind it, a fixed panel no handle and
 * no gap. Shares are set by hand. */
#include <stdlib.h>
#include <string.h>

#include "asset/asset_layer.h"

/* What becomes of an object's parts and pieces. */
typedef struct changes {
    dmg_fate fates[DMG_PART_LIMIT];
    bool* drop; /* of each piece */
    dmg_bounds backs[DMG_PART_LIMIT];
    uint32_t back_count; /* boxes that close the body behind blind fronts */
} changes;

static bool carries(const dmg_builder* b, uint32_t part) {
    for (uint32_t i = 0; i < b->part_count; ++i)
        if (b->parts[i].joint.parent == part) return true;
    return false;
}

static dmg_bounds piece_bounds(const dmg_builder* b, uint32_t piece) {
    dmg_bounds box = dmg_bounds_none();
    for (uint32_t v = b->pieces[piece].first_vertex; v < dmg_piece_end(b, piece); ++v)
        dmg_bounds_grow(&box, b->vertices[v]);
    return box;
}

static float side(const dmg_bounds* box, int axis) {
    const dmg_vec size = v3_sub(box->high, box->low);
    return axis == 0 ? size.x : axis == 1 ? size.y : size.z;
}

static float* coordinate(dmg_vec* v, int axis) {
    return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

static float volume(const dmg_bounds* box) {
    const float least = 0.01f * dmg_largest_side(box); /* sheets have none of their own */
    return fmaxf(side(box, 0), least) * fmaxf(side(box, 1), least) * fmaxf(side(box, 2), least);
}

/* Returns the axis of the box along which the joint slides, or -1; writes on which side it opens. */
static int slide_axis(const dmg_joint* joint, float* out_sign) {
    if (joint->type != DM_JOINT_PRISMATIC) return -1;
    *out_sign = joint->upper > -joint->lower ? 1.0f : -1.0f;
    for (int k = 0; k < 3; ++k) {
        if (fabsf(joint->axis[k]) < 0.99f) continue;
        *out_sign = copysignf(*out_sign, *out_sign * joint->axis[k]);
        return k;
    }
    return -1;
}

/* Returns the largest piece of the part at the front of its way, at most a third of the part deep; piece_count: none.
 */
static uint32_t front_piece(const dmg_builder* b, uint32_t part, int axis, float sign) {
    dmg_bounds all = dmg_part_bounds(b, part);
    uint32_t best = b->piece_count;
    float largest = 0.0f;
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        dmg_bounds box = piece_bounds(b, p);
        const float deep = side(&all, axis);
        const float centre = 0.5f * (*coordinate(&box.low, axis) + *coordinate(&box.high, axis));
        const float ahead = sign > 0.0f ? *coordinate(&all.high, axis) - centre : centre - *coordinate(&all.low, axis);
        if (side(&box, axis) > 0.34f * deep || ahead > 0.34f * deep) continue;
        const float across = side(&box, (axis + 1) % 3) * side(&box, (axis + 2) % 3);
        if (across > largest) largest = across, best = p;
    }
    return best;
}

/* Turns a drawer into its front: removes the box behind it. Returns whether it had one. */
static bool make_blind(dmg_builder* b, uint32_t part, changes* out) {
    float sign = 1.0f;
    const int axis = slide_axis(&b->parts[part - 1].joint, &sign);
    if (axis < 0 || axis == 1 || carries(b, part)) return false;
    const uint32_t front = front_piece(b, part, axis, sign);
    if (front == b->piece_count) return false;
    dmg_bounds panel = piece_bounds(b, front);
    const float back = sign > 0.0f ? *coordinate(&panel.low, axis) : *coordinate(&panel.high, axis);
    uint32_t dropped = 0;
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        dmg_bounds box = piece_bounds(b, p);
        const float middle = 0.5f * (*coordinate(&box.low, axis) + *coordinate(&box.high, axis));
        out->drop[p] = p != front && (middle - back) * sign < 0.0f;
        dropped += out->drop[p];
    }
    if (dropped == 0) return false;
    out->fates[part - 1] = DMG_WELDED;
    if (!dmg_chance(b, 0.75f)) return true;
    const float thick = fmaxf(side(&panel, axis), 1e-3f) * dmg_range(b, 0.5f, 1.5f);
    *coordinate(&panel.low, axis) = sign > 0.0f ? back - thick : back;
    *coordinate(&panel.high, axis) = sign > 0.0f ? back : back + thick;
    out->backs[out->back_count++] = panel;
    return true;
}

/* Turns a leaf into a panel that fills its opening: keeps its largest piece, and enlarges that across. */
static bool make_panel(dmg_builder* b, uint32_t part, changes* out) {
    dmg_bounds all = dmg_part_bounds(b, part);
    const float size = dmg_largest_side(&all);
    const int thin = side(&all, 0) < 0.25f * size ? 0 : side(&all, 2) < 0.25f * size ? 2 : -1;
    if (b->parts[part - 1].joint.type != DM_JOINT_REVOLUTE || thin < 0 || carries(b, part)) return false;
    uint32_t best = b->piece_count;
    float largest = 0.0f;
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        const dmg_bounds box = piece_bounds(b, p);
        if (volume(&box) > largest) largest = volume(&box), best = p;
        out->drop[p] = true;
    }
    if (best == b->piece_count) return false;
    out->drop[best] = false;
    out->fates[part - 1] = DMG_WELDED;
    dmg_bounds box = piece_bounds(b, best);
    const float by = size * dmg_range(b, 0.005f, 0.03f);
    for (uint32_t v = b->pieces[best].first_vertex; v < dmg_piece_end(b, best); ++v) {
        for (int k = 0; k < 3; ++k) {
            float *at = coordinate(&b->vertices[v], k), low = *coordinate(&box.low, k),
                  high = *coordinate(&box.high, k);
            if (k != thin && high > low) *at += by * (2.0f * (*at - low) / (high - low) - 1.0f);
        }
    }
    return true;
}

static bool changes_init(const dmg_builder* b, changes* out) {
    memset(out, 0, sizeof *out);
    out->drop = calloc(b->piece_count + 1, sizeof *out->drop);
    return out->drop != NULL;
}

static void apply(dmg_builder* b, changes* how) {
    dmg_drop_pieces(b, how->drop);
    dmg_part_fates(b, how->fates);
    for (uint32_t i = 0; i < how->back_count; ++i) dmg_box_span(b, how->backs[i].low, how->backs[i].high);
    free(how->drop);
}

bool dmg_make_still(dmg_builder* b) {
    dmg_bounds body = dmg_part_bounds(b, 0), whole = dmg_whole_bounds(b);
    changes how;
    const bool wanted = dmg_chance(b, 0.15f), fronts = dmg_chance(b, 0.4f), scene = dmg_chance(b, 0.3f);
    if (wanted && scene) {
        dmg_draw_scene(b);
        return true;
    }
    if (!wanted || body.low.x > body.high.x || dmg_largest_side(&body) < 0.3f * dmg_largest_side(&whole)) return false;
    if (!changes_init(b, &how)) {
        b->failed = true;
        return false;
    }
    for (uint32_t i = 0; i < b->part_count; ++i) how.fates[i] = DMG_DROPPED;
    for (uint32_t part = 1; fronts && part <= b->part_count; ++part)
        if (!make_blind(b, part, &how) && dmg_chance(b, 0.5f)) make_panel(b, part, &how);
    apply(b, &how);
    return true;
}

static bool is_smaller(const dmg_builder* b, uint32_t part, float size) {
    const dmg_bounds box = dmg_part_bounds(b, part);
    return dmg_largest_side(&box) < size;
}

void dmg_fix_parts(dmg_builder* b) {
    const bool carried = dmg_chance(b, 0.2f), small = dmg_chance(b, 0.06f), blind = dmg_chance(b, 0.3f),
               panels = dmg_chance(b, 0.15f);
    const dmg_bounds whole = dmg_whole_bounds(b);
    const float size = dmg_largest_side(&whole);
    changes how;
    if (!changes_init(b, &how)) {
        b->failed = true;
        return;
    }
    uint32_t left = b->part_count;
    for (uint32_t part = 1; part <= b->part_count && left > 1; ++part) {
        const bool is_carried = b->parts[part - 1].joint.parent != 0;
        bool fixed = blind && dmg_chance(b, 0.35f) && make_blind(b, part, &how);
        if (!fixed && panels && dmg_chance(b, 0.3f)) fixed = make_panel(b, part, &how);
        if (!fixed && !carries(b, part) &&
            ((is_carried && carried && is_smaller(b, part, 0.25f * size)) ||
             (!is_carried && small && is_smaller(b, part, 0.1f * size)))) {
            how.fates[part - 1] = DMG_WELDED;
            fixed = true;
        }
        left -= fixed;
    }
    apply(b, &how);
}
