/* Draws boards and boxes in more pieces, as catalogues of furniture have them: a front of rails, stiles and infill, a
 * wall of boards, a slab with an edge strip. Shares are set by hand. */
#include "asset/asset_layer.h"

enum { CORNERS = 8, FACES = 12 };

/* Whether the piece is a box as dmg_box_faces draws it: bits 0, 1 and 2 of a corner's number are its sides. */
static bool is_box(const dmg_builder* b, uint32_t piece) {
    const dmg_vec* v = b->vertices + b->pieces[piece].first_vertex;
    if (dmg_piece_end(b, piece) - b->pieces[piece].first_vertex != CORNERS) return false;
    if (dmg_piece_face_end(b, piece) - b->pieces[piece].first_face != FACES) return false;
    for (int i = 3; i < CORNERS; ++i) {
        dmg_vec sum = v[0];
        for (int k = 0; k < 3; ++k)
            if (i & 1 << k) sum = v3_add(sum, v3_sub(v[1 << k], v[0]));
        if (v3_length(v3_sub(sum, v[i])) > 1e-4f * v3_length(v3_sub(v[7], v[0]))) return false;
    }
    return true;
}

/* Draws a copy of the piece, and leaves each its side of the cut at `share` of the way along the axis. */
static void cut(dmg_builder* b, uint32_t piece, int axis, float share) {
    const uint32_t first = b->pieces[piece].first_vertex, face = b->pieces[piece].first_face, copy = b->vertex_count;
    dmg_use(b, b->pieces[piece].part);
    dmg_piece_begin(b);
    for (uint32_t i = 0; i < CORNERS; ++i) dmg_vertex(b, b->vertices[first + i]);
    for (uint32_t f = face; f < face + FACES && !b->failed; ++f) {
        const uint32_t* c = b->indices + 3 * (size_t)f;
        const uint32_t corners[3] = {c[0] - first + copy, c[1] - first + copy, c[2] - first + copy};
        dmg_triangle(b, corners[0], corners[1], corners[2]);
    }
    if (b->failed) return;
    for (uint32_t i = 0; i < CORNERS; ++i) {
        const uint32_t low = i & ~(1u << axis), high = i | 1u << axis;
        if (i != low) continue;
        const dmg_vec middle = v3_lerp(b->vertices[copy + low], b->vertices[copy + high], share);
        b->vertices[first + high] = middle;
        b->vertices[copy + low] = middle;
    }
}

static float side(const dmg_builder* b, uint32_t piece, int axis) {
    const dmg_vec* v = b->vertices + b->pieces[piece].first_vertex;
    return v3_length(v3_sub(v[1 << axis], v[0]));
}

/* Returns the axis along which the box is longest but for `but`. */
static int longest_axis(const dmg_builder* b, uint32_t piece, int but) {
    int best = but == 0 ? 1 : 0;
    for (int k = 0; k < 3; ++k)
        if (k != but && side(b, piece, k) > side(b, piece, best)) best = k;
    return best;
}

/* Cuts the box into boards side by side. */
static void cut_boards(dmg_builder* b, uint32_t piece) {
    const int along = longest_axis(b, piece, -1), axis = dmg_chance(b, 0.7f) ? longest_axis(b, piece, along) : along;
    uint32_t rest = piece;
    for (int left = dmg_int(b, 2, 5); left > 1; --left) {
        cut(b, rest, axis, 1.0f / (float)left);
        rest = b->piece_count - 1;
    }
}

/* Cuts a border off all four sides: stiles, rails, and the infill that stays. */
static void cut_frame(dmg_builder* b, uint32_t piece) {
    const int along = longest_axis(b, piece, -1), across = longest_axis(b, piece, along);
    const float border = side(b, piece, across) * dmg_range(b, 0.05f, 0.2f);
    const int axes[2] = {along, across};
    for (int i = 0; i < 2; ++i) {
        const float share = border / side(b, piece, axes[i]);
        cut(b, piece, axes[i], 1.0f - share);           /* the copy is the border beyond */
        cut(b, piece, axes[i], share / (1.0f - share)); /* the piece is the border before */
        const uint32_t inner = b->piece_count - 1;
        piece = inner;
    }
}

void dmg_cut_boards(dmg_builder* b) {
    const float share = dmg_chance(b, 0.3f) ? dmg_range(b, 0.1f, 0.8f) : 0.0f;
    const uint32_t pieces = b->piece_count;
    const dmg_bounds whole = dmg_whole_bounds(b);
    const float least = 0.15f * dmg_largest_side(&whole);
    const bool frames = dmg_chance(b, 0.6f);
    for (uint32_t p = 0; p < pieces && !b->failed; ++p) {
        if (!dmg_chance(b, share) || !is_box(b, p) || side(b, p, longest_axis(b, p, -1)) < least) continue;
        if (frames && dmg_chance(b, 0.6f))
            cut_frame(b, p);
        else
            cut_boards(b, p);
    }
    dmg_use(b, 0);
}
