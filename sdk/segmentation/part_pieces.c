/* Samples of pieces, by area, and a grid of cells that finds which of them touch. */
#include "segmentation/part_pieces.h"

#include <string.h>

#include "base/random.h"
#include "math/linear3.h"

#define SAMPLES 12288    /* of the whole mesh, by area */
#define LEAST_SAMPLES 16 /* of a piece, however small */
#define REACH 1.25f      /* in mean distances between samples */
#define MOST_MET 256     /* of a bucket, by one sample: thousands of screws beside a floor crowd in a few */
#define NONE UINT32_MAX

typedef struct grid {
    uint32_t *heads, *next;
    uint32_t mask;
    float cells_a_unit;
} grid;

static dm_result out_of_memory(const dmi_arena* arena, const dmi_mesh* mesh) {
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to take %u triangles apart", mesh->face_count);
}

/* ---- samples ---- */

/* Faces in order of their piece. */
static uint32_t* sort_faces(dmi_arena* arena, const dmi_pieces* pieces, uint32_t* begin) {
    const dmi_mesh* mesh = pieces->mesh;
    uint32_t* sorted = dmi_arena_push(arena, mesh->face_count * sizeof *sorted);
    if (sorted == NULL) return NULL;
    memset(begin, 0, (pieces->count + 2) * sizeof *begin);
    for (uint32_t f = 0; f < mesh->face_count; f++) begin[pieces->labels[f] + 2]++;
    for (uint32_t p = 0; p < pieces->count; p++) begin[p + 2] += begin[p + 1];
    for (uint32_t f = 0; f < mesh->face_count; f++) sorted[begin[pieces->labels[f] + 1]++] = f;
    return sorted;
}

static void sample_face(const dmi_mesh* mesh, uint32_t face, dmi_random* random, dmi_piece_sample* out) {
    const uint32_t* corners = mesh->indices + (size_t)face * 3;
    const float root = sqrtf(dmi_random_unit(random)), share = dmi_random_unit(random);
    const float weight[3] = {1 - root, root * (1 - share), root * share};
    for (int k = 0; k < 3; k++) {
        out->point[k] = 0;
        for (int i = 0; i < 3; i++) out->point[k] += weight[i] * mesh->positions[(size_t)corners[i] * 3 + (size_t)k];
    }
    dmi_copy3(mesh->face_normal + (size_t)face * 3, out->normal);
}

/* Evenly along the running sum of the piece's areas. */
static void sample_piece(dmi_pieces* pieces, uint32_t piece, const uint32_t* faces, uint32_t face_count,
                         dmi_random* random) {
    const uint32_t first = pieces->first[piece], count = pieces->first[piece + 1] - first;
    const float step = pieces->area[piece] / (float)count;
    float sum = 0;
    uint32_t made = 0;
    for (uint32_t i = 0; i < face_count && made < count; i++) {
        sum += pieces->mesh->face_area[faces[i]];
        for (; made < count && (sum > ((float)made + 0.5f) * step || i + 1 == face_count); made++) {
            dmi_piece_sample* sample = &pieces->samples[first + made];
            sample_face(pieces->mesh, faces[i], random, sample);
            sample->piece = piece;
            sample->touch_count = 0;
        }
    }
}

static dm_result sample_pieces(dmi_arena* arena, dmi_pieces* pieces) {
    const dmi_mesh* mesh = pieces->mesh;
    uint32_t* begin = dmi_arena_push(arena, ((size_t)pieces->count + 2) * sizeof *begin);
    uint32_t* faces = begin != NULL ? sort_faces(arena, pieces, begin) : NULL;
    pieces->area = dmi_arena_push(arena, pieces->count * sizeof *pieces->area);
    pieces->first = dmi_arena_push(arena, ((size_t)pieces->count + 1) * sizeof *pieces->first);
    if (faces == NULL || pieces->area == NULL || pieces->first == NULL) return out_of_memory(arena, mesh);
    float total = 0;
    memset(pieces->area, 0, pieces->count * sizeof *pieces->area);
    for (uint32_t f = 0; f < mesh->face_count; f++) pieces->area[pieces->labels[f]] += mesh->face_area[f];
    for (uint32_t p = 0; p < pieces->count; p++) total += pieces->area[p];
    pieces->first[0] = 0;
    for (uint32_t p = 0; p < pieces->count; p++)
        pieces->first[p + 1] = pieces->first[p] + LEAST_SAMPLES + (uint32_t)(SAMPLES * pieces->area[p] / total);
    pieces->reach = REACH * sqrtf(total / SAMPLES);
    pieces->samples = dmi_arena_push(arena, pieces->first[pieces->count] * sizeof *pieces->samples);
    if (pieces->samples == NULL) return out_of_memory(arena, mesh);
    dmi_random random = dmi_random_make(1, 0);
    for (uint32_t p = 0; p < pieces->count; p++)
        sample_piece(pieces, p, faces + begin[p], begin[p + 1] - begin[p], &random);
    return DM_OK;
}

/* ---- touches ---- */

static uint32_t bucket_of(const grid* grid, const int32_t cell[3]) {
    uint32_t hash = (uint32_t)cell[0] * 0x9e3779b1u ^ (uint32_t)cell[1] * 0x85ebca6bu ^ (uint32_t)cell[2] * 0xc2b2ae35u;
    return (hash ^ hash >> 15) & grid->mask;
}

static void cell_of(const grid* grid, const float point[3], int32_t out[3]) {
    for (int k = 0; k < 3; k++) out[k] = (int32_t)floorf(point[k] * grid->cells_a_unit);
}

/* Keeps the nearest sample of each other piece; when there are too many pieces, the nearest of them. */
static void note_touch(const dmi_pieces* pieces, dmi_piece_sample* sample, uint32_t other, float distance) {
    uint32_t at = 0, farthest = 0;
    for (; at < sample->touch_count; at++) {
        if (pieces->samples[sample->touches[at].sample].piece == pieces->samples[other].piece) break;
        if (sample->touches[at].distance > sample->touches[farthest].distance) farthest = at;
    }
    if (at == DMI_PIECE_TOUCHES) at = farthest;
    if (at < sample->touch_count && sample->touches[at].distance <= distance) return;
    sample->touches[at] = (dmi_piece_touch){other, distance};
    if (at == sample->touch_count) sample->touch_count++;
}

static void compare(const dmi_pieces* pieces, uint32_t s, uint32_t o) {
    dmi_piece_sample *one = &pieces->samples[s], *other = &pieces->samples[o];
    float apart[3];
    if (one->piece == other->piece) return;
    dmi_sub3(one->point, other->point, apart);
    const float square = dmi_dot3(apart, apart);
    if (square >= pieces->reach * pieces->reach) return;
    const float distance = sqrtf(square);
    note_touch(pieces, one, o, distance);
    note_touch(pieces, other, s, distance);
}

/* With one bucket's samples from that one on. */
static void compare_with(const dmi_pieces* pieces, const grid* grid, uint32_t s, uint32_t first) {
    uint32_t met = 0;
    for (uint32_t o = first; o != NONE && met < MOST_MET; o = grid->next[o], met++) compare(pieces, s, o);
}

/* Each pair once: with those before it in its own cell, and all of half the cells around. */
static void search_around(const dmi_pieces* pieces, const grid* grid, uint32_t s) {
    int32_t own[3], cell[3];
    cell_of(grid, pieces->samples[s].point, own);
    compare_with(pieces, grid, s, grid->next[s]);
    for (int i = 14; i < 27; i++) {
        cell[0] = own[0] + i % 3 - 1;
        cell[1] = own[1] + i / 3 % 3 - 1;
        cell[2] = own[2] + i / 9 - 1;
        compare_with(pieces, grid, s, grid->heads[bucket_of(grid, cell)]);
    }
}

static dm_result find_touches(dmi_arena* arena, dmi_pieces* pieces) {
    const uint32_t count = pieces->first[pieces->count];
    uint32_t buckets = 16;
    while (buckets < count) buckets *= 2;
    grid grid = {.mask = buckets - 1, .cells_a_unit = 1 / pieces->reach};
    grid.heads = dmi_arena_push(arena, buckets * sizeof *grid.heads);
    grid.next = dmi_arena_push(arena, count * sizeof *grid.next);
    if (grid.heads == NULL || grid.next == NULL) return out_of_memory(arena, pieces->mesh);
    memset(grid.heads, 0xff, buckets * sizeof *grid.heads);
    for (uint32_t s = 0; s < count; s++) {
        int32_t cell[3];
        cell_of(&grid, pieces->samples[s].point, cell);
        const uint32_t bucket = bucket_of(&grid, cell);
        grid.next[s] = grid.heads[bucket];
        grid.heads[bucket] = s;
    }
    for (uint32_t s = 0; s < count; s++) search_around(pieces, &grid, s);
    return DM_OK;
}

/* A pair is found in a table of all that were seen. */
static dm_result note_pairs(dmi_arena* arena, dmi_pieces* pieces) {
    const uint32_t samples = pieces->first[pieces->count];
    uint32_t touches = 0, slots = 16;
    for (uint32_t s = 0; s < samples; s++) touches += pieces->samples[s].touch_count;
    while (slots < 2 * touches) slots *= 2;
    uint32_t(*seen)[2] = dmi_arena_push(arena, slots * sizeof *seen);
    pieces->pairs = dmi_arena_push(arena, (touches + 1) * sizeof *pieces->pairs);
    if (seen == NULL || pieces->pairs == NULL) return out_of_memory(arena, pieces->mesh);
    memset(seen, 0xff, slots * sizeof *seen);
    for (uint32_t s = 0; s < samples; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        for (uint32_t t = 0; t < sample->touch_count; t++) {
            const uint32_t other = pieces->samples[sample->touches[t].sample].piece;
            const uint32_t low = other < sample->piece ? other : sample->piece, high = low ^ other ^ sample->piece;
            uint32_t at = (low * 0x9e3779b1u ^ high * 0x85ebca6bu) & (slots - 1);
            while (seen[at][0] != NONE && (seen[at][0] != low || seen[at][1] != high)) at = (at + 1) & (slots - 1);
            if (seen[at][0] == low) continue;
            seen[at][0] = pieces->pairs[pieces->pair_count][0] = low;
            seen[at][1] = pieces->pairs[pieces->pair_count++][1] = high;
        }
    }
    return DM_OK;
}

dm_result dmi_pieces_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* labels, uint32_t count,
                          dmi_pieces* out) {
    *out = (dmi_pieces){.mesh = mesh, .labels = labels, .count = count};
    dm_result result = sample_pieces(arena, out);
    if (result == DM_OK) result = find_touches(arena, out);
    return result == DM_OK ? note_pairs(arena, out) : result;
}
