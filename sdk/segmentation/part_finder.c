/* Finds the part that a grabbed point belongs to.
 *
 * With several rigid pieces given (nodes), the grabbed one moves, and what is small and hangs on the rest through it
 * alone moves with it: a handle on a door. In one piece, proposals grow from what was grabbed, and the one that a
 * learned score likes best is the part. */
#include "segmentation/part_finder.h"

#include <string.h>

#include "math/linear3.h"
#include "segmentation/part_choice.h"
#include "segmentation/part_weights.h"

#define BLOCK ((size_t)1 << 20)

/* ---- the grabbed face ---- */

/* Squared distance of p to the triangle a, b, c (Ericson, Real-Time Collision Detection, 5.1.5). */
static float triangle_distance(const float p[3], const float a[3], const float b[3], const float c[3]) {
    float ab[3], ac[3], ap[3], nearest[3], off[3];
    dmi_sub3(b, a, ab), dmi_sub3(c, a, ac), dmi_sub3(p, a, ap);
    const float d00 = dmi_dot3(ab, ab), d01 = dmi_dot3(ab, ac), d11 = dmi_dot3(ac, ac);
    const float d20 = dmi_dot3(ap, ab), d21 = dmi_dot3(ap, ac), area = d00 * d11 - d01 * d01;
    float v = area > 0 ? (d11 * d20 - d01 * d21) / area : -1, w = area > 0 ? (d00 * d21 - d01 * d20) / area : -1;
    if (v >= 0 && w >= 0 && v + w <= 1) {
        for (int k = 0; k < 3; k++) nearest[k] = a[k] + v * ab[k] + w * ac[k];
        dmi_sub3(p, nearest, off);
        return dmi_dot3(off, off);
    }
    const float* corners[4] = {a, b, c, a};
    float best = INFINITY;
    for (int i = 0; i < 3; i++) {
        float along[3];
        dmi_sub3(corners[i + 1], corners[i], along), dmi_sub3(p, corners[i], off);
        const float length = dmi_dot3(along, along);
        const float t = length > 0 ? fminf(fmaxf(dmi_dot3(off, along) / length, 0), 1) : 0;
        dmi_madd3(corners[i], t, along, nearest);
        dmi_sub3(p, nearest, off);
        best = fminf(best, dmi_dot3(off, off));
    }
    return best;
}

uint32_t dmi_part_nearest_face(const dmi_mesh* mesh, const float point[3]) {
    uint32_t best = 0;
    float least = INFINITY;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t* corner = mesh->indices + (size_t)f * 3;
        const float distance =
            triangle_distance(point, mesh->positions + (size_t)corner[0] * 3, mesh->positions + (size_t)corner[1] * 3,
                              mesh->positions + (size_t)corner[2] * 3);
        if (distance >= least) continue;
        least = distance;
        best = f;
    }
    return best;
}

/* ---- the two ways ---- */

static int is_given_in_pieces(const dmi_mesh* mesh) {
    uint32_t filled = 0;
    for (uint32_t p = 0; p < mesh->part_count; p++) filled += mesh->parts[p].face_count > 0;
    return filled > 1;
}

static dm_result find_among_given(dmi_arena* arena, const dmi_part_query* query, uint8_t* out_faces) {
    const dmi_mesh* mesh = query->mesh;
    dmi_pieces pieces;
    dmi_part_groups groups;
    dm_result result = dmi_pieces_make(arena, mesh, mesh->face_part, mesh->part_count, &pieces);
    if (result == DM_OK) result = dmi_part_groups_make(arena, &pieces, &groups);
    if (result != DM_OK) return result;
    uint8_t* inside = dmi_arena_push(arena, pieces.count);
    if (inside == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to find a part among %u", pieces.count);
    memset(inside, 0, pieces.count);
    inside[mesh->face_part[dmi_part_nearest_face(mesh, query->point)]] = 1;
    dmi_part_groups_find(&pieces, inside, &groups);
    dmi_part_carry(&pieces, &groups, inside);
    for (uint32_t f = 0; f < mesh->face_count; f++) out_faces[f] = inside[mesh->face_part[f]] != 0;
    return DM_OK;
}

static dm_result find_in_one(dmi_arena* arena, const dmi_part_query* query, uint8_t* out_faces) {
    const dmi_mesh* mesh = query->mesh;
    dmi_grab grab = {.face = dmi_part_nearest_face(mesh, query->point)};
    dmi_copy3(query->point, grab.point);
    dmi_copy3(query->drag, grab.drag);
    memset(out_faces, 1, mesh->face_count);
    dmi_part_sheets sheets;
    dmi_proposals* proposals = dmi_arena_push(arena, sizeof *proposals);
    if (proposals == NULL) return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to find a part");
    dm_result result = dmi_part_sheets_make(arena, mesh, &sheets);
    if (result == DM_OK) result = dmi_proposals_make(arena, &sheets, &grab, &dmi_part_growth_net, proposals);
    if (result != DM_OK) return result;
    float most = -INFINITY;
    for (uint32_t i = 0; i < proposals->count; i++) {
        const dmi_proposal* item = &proposals->items[i];
        const float score = dmi_part_net_run(&dmi_part_choice_net, item->features);
        if (score <= most) continue;
        most = score;
        for (uint32_t f = 0; f < mesh->face_count; f++) out_faces[f] = item->inside[item->level->pieces.labels[f]] != 0;
    }
    return result;
}

static int is_everything(const dmi_mesh* mesh, const uint8_t* faces) {
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (!faces[f] && mesh->face_area[f] > 0) return 0;
    return 1;
}

dm_result dmi_part_find(dmi_env* env, const dmi_part_query* query, uint8_t* out_faces) {
    dmi_arena arena;
    dmi_arena_init(&arena, env, BLOCK);
    dm_result result = is_given_in_pieces(query->mesh) ? find_among_given(&arena, query, out_faces)
                                                       : find_in_one(&arena, query, out_faces);
    if (result == DM_OK && is_everything(query->mesh, out_faces))
        result = dmi_fail(env, DM_ERROR_FULL_MASK, "the grabbed point's part is the whole mesh: nothing would stay");
    dmi_arena_release(&arena);
    return result;
}
