/* Finds contacts with a hash grid whose cells are as wide as the contact distance. */
#include "segmentation/piece_contacts.h"

#include <string.h>

#include "math/linear3.h"

/* Samples of one bucket that are compared with one sample. Bounds the work in crowded buckets; by hand. */
#define MAX_COMPARED 256
#define MIN_COMPARED 16
#define COMPARED_IN_ALL (1u << 22) /* the sum over all samples, where it asks for fewer than MAX_COMPARED; by hand */
#define MIN_SLOTS 16               /* of a hash table; by hand */
#define NO_BYTE 0xff               /* memset value that makes every uint32_t DMI_PIECE_NONE */

/* Multipliers and shift of the hashes: large odd constants with mixed bits, as of xxHash32 and MurmurHash3. */
#define HASH_X 0x9e3779b1u
#define HASH_Y 0x85ebca6bu
#define HASH_Z 0xc2b2ae35u
#define HASH_SHIFT 15

/* The 27 cells around and including a cell, by index; from the first one past the middle on, each pair comes once. */
enum { NEIGHBOUR_CELLS = 27, FIRST_LATER_CELL = 14, CELLS_OF_A_SLAB = 9 };

typedef struct hash_grid {
    uint32_t *heads, *next; /* per bucket: its first sample; per sample: the next of its bucket */
    uint32_t mask;          /* buckets - 1 */
    uint32_t compared;      /* samples of a bucket that are compared with one sample */
    float cells_per_unit;
} hash_grid;

static dm_result out_of_memory(const dmi_arena* arena, const dmi_mesh* mesh) {
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for the contacts of %u triangles", mesh->face_count);
}

/* ---- contacts of samples ---- */

static uint32_t bucket_of(const hash_grid* grid, const int32_t cell[3]) {
    uint32_t hash = (uint32_t)cell[0] * HASH_X ^ (uint32_t)cell[1] * HASH_Y ^ (uint32_t)cell[2] * HASH_Z;
    return (hash ^ hash >> HASH_SHIFT) & grid->mask;
}

static void cell_of(const hash_grid* grid, const float point[3], int32_t out[3]) {
    for (int k = 0; k < 3; k++) out[k] = (int32_t)floorf(point[k] * grid->cells_per_unit);
}

/* Keeps the nearest sample of each other piece. When more pieces are in contact than there is room for, keeps the
 * nearest of them. */
static void add_contact(const dmi_pieces* pieces, dmi_piece_sample* sample, uint32_t other, float distance) {
    uint32_t at = 0, farthest = 0;
    for (; at < sample->contact_count; at++) {
        if (pieces->samples[sample->contacts[at].sample].piece == pieces->samples[other].piece) break;
        if (sample->contacts[at].distance > sample->contacts[farthest].distance) farthest = at;
    }
    if (at == DMI_PIECE_MAX_CONTACTS) at = farthest;
    if (at < sample->contact_count && sample->contacts[at].distance <= distance) return;
    sample->contacts[at] = (dmi_piece_contact){other, distance};
    if (at == sample->contact_count) sample->contact_count++;
}

/* Adds the contact of two samples to both, if they are of different pieces and close enough. */
static void compare_samples(const dmi_pieces* pieces, uint32_t a, uint32_t b) {
    dmi_piece_sample *sample_a = &pieces->samples[a], *sample_b = &pieces->samples[b];
    float offset[3];
    if (sample_a->piece == sample_b->piece) return;
    dmi_sub3(sample_a->point, sample_b->point, offset);
    const float square = dmi_dot3(offset, offset);
    if (square >= pieces->contact_distance * pieces->contact_distance) return;
    const float distance = sqrtf(square);
    add_contact(pieces, sample_a, b, distance);
    add_contact(pieces, sample_b, a, distance);
}

/* Compares sample `s` with the samples of a bucket, from `first` on. */
static void compare_with_bucket(const dmi_pieces* pieces, const hash_grid* grid, uint32_t s, uint32_t first) {
    uint32_t compared = 0;
    for (uint32_t other = first; other != DMI_PIECE_NONE && compared < grid->compared; other = grid->next[other]) {
        compare_samples(pieces, s, other);
        compared++;
    }
}

/* Compares sample `s` with the rest of its own cell's list and with half of the cells around, so that each pair of
 * samples is compared once. */
static void compare_with_neighbours(const dmi_pieces* pieces, const hash_grid* grid, uint32_t s) {
    int32_t own[3], cell[3];
    cell_of(grid, pieces->samples[s].point, own);
    compare_with_bucket(pieces, grid, s, grid->next[s]);
    for (int i = FIRST_LATER_CELL; i < NEIGHBOUR_CELLS; i++) {
        cell[0] = own[0] + i % 3 - 1;
        cell[1] = own[1] + i / 3 % 3 - 1;
        cell[2] = own[2] + i / CELLS_OF_A_SLAB - 1;
        compare_with_bucket(pieces, grid, s, grid->heads[bucket_of(grid, cell)]);
    }
}

static uint32_t compared_with_each(uint32_t sample_count) {
    const uint32_t share = COMPARED_IN_ALL / sample_count;
    if (share > MAX_COMPARED) return MAX_COMPARED;
    return share > MIN_COMPARED ? share : MIN_COMPARED;
}

static dm_result find_sample_contacts(dmi_arena* arena, dmi_pieces* pieces) {
    const uint32_t count = pieces->first[pieces->count];
    uint32_t buckets = MIN_SLOTS;
    while (buckets < count) buckets *= 2;
    hash_grid grid = {
        .mask = buckets - 1, .compared = compared_with_each(count), .cells_per_unit = 1 / pieces->contact_distance};
    grid.heads = dmi_arena_push(arena, buckets * sizeof *grid.heads);
    grid.next = dmi_arena_push(arena, count * sizeof *grid.next);
    if (grid.heads == NULL || grid.next == NULL) return out_of_memory(arena, pieces->mesh);
    memset(grid.heads, NO_BYTE, buckets * sizeof *grid.heads);
    for (uint32_t s = 0; s < count; s++) {
        int32_t cell[3];
        cell_of(&grid, pieces->samples[s].point, cell);
        const uint32_t bucket = bucket_of(&grid, cell);
        grid.next[s] = grid.heads[bucket];
        grid.heads[bucket] = s;
    }
    for (uint32_t s = 0; s < count; s++) compare_with_neighbours(pieces, &grid, s);
    return DM_OK;
}

/* ---- pairs of pieces ---- */

/* Appends the pair of pieces unless the open-addressing table `seen` (a power of two of slots) holds it. */
static void add_pair(dmi_pieces* pieces, uint32_t (*seen)[2], uint32_t slots, uint32_t low, uint32_t high) {
    uint32_t at = (low * HASH_X ^ high * HASH_Y) & (slots - 1);
    while (seen[at][0] != DMI_PIECE_NONE && (seen[at][0] != low || seen[at][1] != high)) at = (at + 1) & (slots - 1);
    if (seen[at][0] == low) return;
    seen[at][0] = pieces->pairs[pieces->pair_count][0] = low;
    seen[at][1] = pieces->pairs[pieces->pair_count++][1] = high;
}

static dm_result find_pairs(dmi_arena* arena, dmi_pieces* pieces) {
    const uint32_t samples = pieces->first[pieces->count];
    uint32_t contacts = 0, slots = MIN_SLOTS;
    for (uint32_t s = 0; s < samples; s++) contacts += pieces->samples[s].contact_count;
    while (slots < 2 * contacts) slots *= 2;
    uint32_t(*seen)[2] = dmi_arena_push(arena, slots * sizeof *seen);
    pieces->pairs = dmi_arena_push(arena, (contacts + 1) * sizeof *pieces->pairs);
    if (seen == NULL || pieces->pairs == NULL) return out_of_memory(arena, pieces->mesh);
    memset(seen, NO_BYTE, slots * sizeof *seen);
    for (uint32_t s = 0; s < samples; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        for (uint32_t c = 0; c < sample->contact_count; c++) {
            const uint32_t other = pieces->samples[sample->contacts[c].sample].piece;
            const uint32_t low = other < sample->piece ? other : sample->piece, high = low ^ other ^ sample->piece;
            add_pair(pieces, seen, slots, low, high);
        }
    }
    return DM_OK;
}

dm_result dmi_piece_contacts_find(dmi_arena* arena, dmi_pieces* pieces) {
    dm_result result = find_sample_contacts(arena, pieces);
    return result == DM_OK ? find_pairs(arena, pieces) : result;
}
