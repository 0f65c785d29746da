/* Finds the part that a grabbed point belongs to.
 *
 * With several rigid pieces given (nodes), the grabbed one moves, and what is small and hangs on the rest through it
 * alone moves with it: a handle on a door. In one piece, sheets of surface are the pieces, and the part grows from the
 * grabbed one by learned evidence of what belongs together. A sheet that is most of the mesh is cut where it bends
 * inwards, else at its creases. */
#include "kinematics/part_finder.h"

#include <string.h>

#include "kinematics/linear3.h"
#include "kinematics/part_weights.h"
#include "mesh/connectivity.h"

#define BLOCK ((size_t)1 << 20)
#define WELD 1e-5f         /* of the object's size */
#define MOST_CARRIED 0.25f /* of the part's area: what is larger has a joint of its own, or holds the part */
#define CONCAVE_SINE 0.2f
#define CREASE_COSINE 0.8f /* smooth regions end where neighbouring faces turn by more than 37 degrees */
#define WHOLE_SHARE 0.85f  /* a bulge with more is the whole body again */
#define RIM_SHARE 0.25f    /* of the grabbed smooth region's area: its walls and bevels */
#define MOST_SHARE 0.5f    /* of the whole area: a sheet with more is the body, and what was grabbed a bulge of it */
#define NONE UINT32_MAX

typedef struct finder {
    dmi_arena* arena;
    const dmi_part_query* query;
    dmi_pieces pieces;
    uint32_t seed;   /* the grabbed piece */
    uint8_t* inside; /* a piece */
} finder;

static dm_result out_of_memory(const finder* f) {
    return dmi_fail(f->arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to find a part among %u triangles",
                    f->query->mesh->face_count);
}

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

static uint32_t nearest_face(const dmi_mesh* mesh, const float point[3]) {
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

/* ---- what hangs on the rest through the part alone ---- */

static uint32_t find_root(uint32_t* parents, uint32_t p) {
    while (parents[p] != p) p = parents[p] = parents[parents[p]];
    return p;
}

static void unite(uint32_t* parents, uint32_t a, uint32_t b) {
    parents[find_root(parents, a)] = find_root(parents, b);
}

/* Pieces outside the part fall into groups that touch; the largest stays, and so do groups that touch the part nowhere;
 * the others go along when they are small. */
static dm_result carry(finder* f) {
    const dmi_pieces* pieces = &f->pieces;
    uint32_t* parents = dmi_arena_push(f->arena, pieces->count * sizeof *parents);
    float* area = dmi_arena_push(f->arena, pieces->count * sizeof *area);
    uint8_t* touches = dmi_arena_push(f->arena, pieces->count);
    if (parents == NULL || area == NULL || touches == NULL) return out_of_memory(f);
    memset(area, 0, pieces->count * sizeof *area);
    memset(touches, 0, pieces->count);
    for (uint32_t p = 0; p < pieces->count; p++) parents[p] = p;
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        for (uint32_t t = 0; t < sample->touch_count; t++) {
            const uint32_t other = pieces->samples[sample->touches[t].sample].piece;
            if (!f->inside[sample->piece] && !f->inside[other]) unite(parents, sample->piece, other);
        }
    }
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        for (uint32_t t = 0; t < sample->touch_count; t++) {
            const uint32_t other = pieces->samples[sample->touches[t].sample].piece;
            if (f->inside[sample->piece] && !f->inside[other]) touches[find_root(parents, other)] = 1;
            if (f->inside[other] && !f->inside[sample->piece]) touches[find_root(parents, sample->piece)] = 1;
        }
    }
    uint32_t largest = NONE;
    float part = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        if (f->inside[p])
            part += pieces->area[p];
        else
            area[find_root(parents, p)] += pieces->area[p];
    }
    for (uint32_t p = 0; p < pieces->count; p++)
        if (!f->inside[p] && parents[p] == p && (largest == NONE || area[p] > area[largest])) largest = p;
    for (uint32_t p = 0; p < pieces->count; p++) {
        const uint32_t root = find_root(parents, p);
        if (!f->inside[p] && root != largest && touches[root] && area[root] <= MOST_CARRIED * part) f->inside[p] = 2;
    }
    return DM_OK;
}

/* ---- growing ---- */

float dmi_growth_score(const float features[DMI_GROWTH_FEATURES]) {
    float score = dmi_part_bias;
    for (int h = 0; h < DMI_PART_HIDDEN; h++) {
        float sum = dmi_part_hidden_bias[h];
        for (int i = 0; i < DMI_GROWTH_FEATURES; i++) sum += dmi_part_hidden[h][i] * features[i];
        score += dmi_part_output[h] * fmaxf(sum, 0);
    }
    return score;
}

static dm_result grow(finder* f, const uint32_t* shells) {
    dmi_growth growth;
    dm_result result = dmi_growth_make(f->arena, &f->pieces, shells, f->query->drag, &growth);
    if (result != DM_OK) return result;
    dmi_growth_add(&growth, f->seed);
    for (;;) {
        uint32_t best = NONE;
        float most = 0;
        dmi_growth_look(&growth);
        for (uint32_t i = 0; i < growth.touching_count; i++) {
            const float score = dmi_growth_score((const float*)growth.features[growth.touching[i]]);
            if (score <= most) continue;
            most = score;
            best = growth.touching[i];
        }
        if (best == NONE) break;
        dmi_growth_add(&growth, best);
    }
    f->inside = growth.inside;
    return DM_OK;
}

/* ---- the two ways ---- */

static dm_result take_pieces(finder* f, const uint32_t* labels, uint32_t count) {
    dm_result result = dmi_pieces_make(f->arena, f->query->mesh, labels, count, &f->pieces);
    if (result != DM_OK) return result;
    f->seed = labels[nearest_face(f->query->mesh, f->query->point)];
    f->inside = dmi_arena_push(f->arena, count);
    if (f->inside == NULL) return out_of_memory(f);
    memset(f->inside, 0, count);
    f->inside[f->seed] = 1;
    return DM_OK;
}

static dm_result find_among_given(finder* f) {
    dm_result result = take_pieces(f, f->query->mesh->face_part, f->query->mesh->part_count);
    return result == DM_OK ? carry(f) : result;
}

static float total_area(const finder* f) {
    float sum = 0;
    for (uint32_t p = 0; p < f->pieces.count; p++) sum += f->pieces.area[p];
    return sum;
}

/* The small smooth regions around the grabbed one: walls and bevels between it and what it stands on. */
static dm_result take_rims(finder* f, const uint32_t* welded) {
    const dmi_mesh* mesh = f->query->mesh;
    const uint32_t* labels = f->pieces.labels;
    uint8_t* corner = dmi_arena_push(f->arena, mesh->vertex_count);
    if (corner == NULL) return out_of_memory(f);
    memset(corner, 0, mesh->vertex_count);
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++)
        if (labels[i / 3] == f->seed) corner[welded[mesh->indices[i]]] = 1;
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++) {
        const uint32_t piece = labels[i / 3];
        if (corner[welded[mesh->indices[i]]] && f->pieces.area[piece] <= RIM_SHARE * f->pieces.area[f->seed])
            f->inside[piece] = 1;
    }
    return DM_OK;
}

/* A surface cut where it bends inwards, or, where that cuts nothing off, at every crease. What was grabbed is the part
 * alone; what hangs on it is not asked. */
static dm_result split(finder* f) {
    const dmi_mesh* mesh = f->query->mesh;
    uint32_t count;
    uint32_t* welded = dmi_arena_push(f->arena, mesh->vertex_count * sizeof *welded);
    uint32_t* labels = dmi_arena_push(f->arena, mesh->face_count * sizeof *labels);
    uint8_t* all = dmi_arena_push(f->arena, mesh->face_count);
    if (welded == NULL || labels == NULL || all == NULL) return out_of_memory(f);
    dm_result result = dmi_weld_vertices(f->arena, mesh, WELD, welded);
    if (result == DM_OK) result = dmi_face_bulges(f->arena, mesh, welded, CONCAVE_SINE, labels, &count);
    if (result == DM_OK) result = take_pieces(f, labels, count);
    if (result != DM_OK || f->pieces.area[f->seed] <= WHOLE_SHARE * total_area(f)) return result;
    memset(all, 1, mesh->face_count);
    result = dmi_face_regions(f->arena, mesh, welded, all, CREASE_COSINE, labels, &count);
    if (result == DM_OK) result = take_pieces(f, labels, count);
    return result == DM_OK ? take_rims(f, welded) : result;
}

dm_result dmi_part_sheets(dmi_arena* arena, const dmi_mesh* mesh, dmi_pieces* out_pieces, uint32_t** out_shells) {
    uint32_t count, shell_count, face_count = mesh->face_count;
    uint32_t* welded = dmi_arena_push(arena, mesh->vertex_count * sizeof *welded);
    uint32_t* labels = dmi_arena_push(arena, face_count * sizeof *labels);
    uint32_t* by_face = dmi_arena_push(arena, face_count * sizeof *by_face);
    uint8_t* all = dmi_arena_push(arena, face_count);
    if (welded == NULL || labels == NULL || by_face == NULL || all == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to take %u triangles apart", face_count);
    memset(all, 1, face_count);
    dm_result result = dmi_weld_vertices(arena, mesh, WELD, welded);
    if (result == DM_OK) result = dmi_face_sheets(arena, mesh, welded, labels, &count);
    if (result == DM_OK) result = dmi_face_regions(arena, mesh, welded, all, -2, by_face, &shell_count);
    if (result == DM_OK) result = dmi_pieces_make(arena, mesh, labels, count, out_pieces);
    if (result != DM_OK) return result;
    *out_shells = dmi_arena_push(arena, count * sizeof **out_shells);
    if (*out_shells == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to take %u triangles apart", face_count);
    for (uint32_t f = 0; f < face_count; f++) (*out_shells)[labels[f]] = by_face[f];
    return DM_OK;
}

static int is_everything(const finder* f) {
    for (uint32_t p = 0; p < f->pieces.count; p++)
        if (!f->inside[p] && f->pieces.area[p] > 0) return 0;
    return 1;
}

static dm_result find_in_one(finder* f) {
    uint32_t* shells;
    dm_result result = dmi_part_sheets(f->arena, f->query->mesh, &f->pieces, &shells);
    if (result != DM_OK) return result;
    f->seed = f->pieces.labels[nearest_face(f->query->mesh, f->query->point)];
    if (f->pieces.area[f->seed] > MOST_SHARE * total_area(f)) return split(f);
    result = grow(f, shells);
    return result == DM_OK ? carry(f) : result;
}

static int is_given_in_pieces(const dmi_mesh* mesh) {
    uint32_t filled = 0;
    for (uint32_t p = 0; p < mesh->part_count; p++) filled += mesh->parts[p].face_count > 0;
    return filled > 1;
}

dm_result dmi_part_find(dmi_env* env, const dmi_part_query* query, uint8_t* out_faces) {
    dmi_arena arena;
    dmi_arena_init(&arena, env, BLOCK);
    finder f = {.arena = &arena, .query = query};
    dm_result result = is_given_in_pieces(query->mesh) ? find_among_given(&f) : find_in_one(&f);
    if (result == DM_OK && is_everything(&f))
        result = dmi_fail(env, DM_ERROR_FULL_MASK, "the grabbed point's part is the whole mesh: nothing would stay");
    if (result == DM_OK)
        for (uint32_t i = 0; i < query->mesh->face_count; i++) out_faces[i] = f.inside[f.pieces.labels[i]] != 0;
    dmi_arena_release(&arena);
    return result;
}
