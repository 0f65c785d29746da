/* Samples the surfaces of pieces in proportion to their area, and finds the contacts between them with a hash grid
 * whose cells are as wide as the contact distance. */
#include "segmentation/pieces.h"

#include <math.h>
#include <string.h>

#include "base/compiler.h"
#include "base/random.h"
#include "math/linear3.h"

#define MESH_SAMPLES 12288   /* samples distributed over the whole mesh by area; by hand */
#define MIN_PIECE_SAMPLES 16 /* samples added to every piece that has faces, whatever its area; by hand */
#define ADDED_SAMPLES                                                                                                  \
    32768 /* samples of all pieces: where there are more pieces than this allows for, each gets fewer; by hand */
#define CONTACT_SPACINGS 1.25f /* contact distance in mean sample spacings; by hand */
#define SAMPLE_SEED 1          /* seed of the random positions within faces; arbitrary */

/* ---- contacts of the pieces ---- */

/* Most samples of one bucket that are compared with one sample, which bounds the work in crowded buckets; by hand. */
#define MAX_COMPARED 256
#define MIN_COMPARED 16
/* Most comparisons in all, where that is fewer than MAX_COMPARED for each sample; by hand. */
#define COMPARED_IN_ALL (1u << 22)
#define MIN_SLOTS 16 /* fewest slots of a hash table; by hand */
#define BLOCK 16     /* places that are compared at once; a power of two, 32 at most */
/* The square of a rounded square root is larger by less than this factor: twice 2^-23, and a margin. */
#define ROUNDED_SQUARE 1.000001f
#define NO_BYTE 0xff /* memset value that makes every uint32_t DMI_PIECE_NONE */

/* Multipliers and shift of the hashes: large odd constants with mixed bits, as of xxHash32 and MurmurHash3. */
#define HASH_X 0x9e3779b1u
#define HASH_Y 0x85ebca6bu
#define HASH_Z 0xc2b2ae35u
#define HASH_SHIFT 15

/* The 27 cells of a cell and its neighbours, by index. Comparisons with those after the middle meet each pair once. */
enum { NEIGHBOUR_CELLS = 27, FIRST_LATER_CELL = 14, CELLS_OF_A_SLAB = 9 };

enum { NUMBERS_A_PLACE = 5 }; /* coordinates, reach, and reach of the block */

/* A bucket of samples. Its box holds its first samples, as many as are compared. */
typedef struct bucket {
    uint32_t first, end; /* places */
    float low[3], high[3];
} bucket;

/* A grid of buckets. A *place* is a position in the list of samples that is sorted by bucket; in a bucket, later
 * samples come first. What most comparisons read stands apart from the rest of a sample. */
typedef struct hash_grid {
    bucket* buckets;
    uint32_t* samples;                            /* per place */
    uint32_t* places;                             /* per sample */
    uint32_t* pieces;                             /* per place */
    float* points[3];                             /* per place */
    uint32_t (*contacts)[DMI_PIECE_MAX_CONTACTS]; /* per place: the pieces of its contacts */
    float* block_reach; /* per first place of each block of a bucket: no less than any reach in the block */
    /* Per place: square of the distance from which on a contact with another sample is not kept. */
    float* reach;
    uint32_t mask;     /* buckets - 1 */
    uint32_t compared; /* samples of a bucket that are compared with one sample */
    float cells_per_unit;
} hash_grid;

static dm_result no_memory_for_contacts(const dmi_arena* arena, const dmi_mesh* mesh) {
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

/* Returns the index of the farthest contact of a sample; the first of several that are equally far. */
static uint32_t farthest_contact(const dmi_piece_sample* sample) {
    uint32_t farthest = 0;
    for (uint32_t i = 1; i < DMI_PIECE_MAX_CONTACTS; i++)
        if (sample->contacts[i].distance > sample->contacts[farthest].distance) farthest = i;
    return farthest;
}

/* Adds a contact to the sample at a place. Keeps the nearest sample of each other piece, and when more pieces are in
 * contact than there is room for, the nearest of them. Returns whether the sample's reach has become less. */
static bool add_contact(const dmi_pieces* pieces, const hash_grid* grid, uint32_t place, uint32_t other, float square) {
    if (square >= grid->reach[place]) return false;
    dmi_piece_sample* sample = &pieces->samples[grid->samples[place]];
    uint32_t *known = grid->contacts[place], at = 0;
    const uint32_t piece = grid->pieces[other], count = sample->contact_count;
    const float distance = sqrtf(square);
    while (at < count && known[at] != piece) at++;
    if (at == DMI_PIECE_MAX_CONTACTS) at = farthest_contact(sample);
    if (at < count && sample->contacts[at].distance <= distance) return false;
    known[at] = piece;
    sample->contacts[at] = (dmi_piece_contact){grid->samples[other], distance};
    if (at == count) sample->contact_count++;
    if (sample->contact_count < DMI_PIECE_MAX_CONTACTS) return false;
    const float farthest = sample->contacts[farthest_contact(sample)].distance;
    const float reach = farthest * farthest * ROUNDED_SQUARE;
    if (reach >= grid->reach[place]) return false;
    grid->reach[place] = reach;
    return true;
}

/* Compares the sample at a place with those at BLOCK others, from `first` on. Returns a bit for each sample that is of
 * another piece and near enough to be a contact of either. */
static uint32_t near_ones(const hash_grid* grid, uint32_t place, uint32_t first) {
    const float x = grid->points[0][place], y = grid->points[1][place], z = grid->points[2][place];
    const float *xs = grid->points[0] + first, *ys = grid->points[1] + first, *zs = grid->points[2] + first;
    const float *reaches = grid->reach + first, own = grid->reach[place];
    const uint32_t *pieces = grid->pieces + first, piece = grid->pieces[place];
    uint32_t near[BLOCK], any = 0, bits = 0;
    for (int i = 0; i < BLOCK; i++) {
        const float dx = x - xs[i], dy = y - ys[i], dz = z - zs[i], square = dx * dx + dy * dy + dz * dz;
        near[i] = ((uint32_t)(square < own) | (uint32_t)(square < reaches[i])) & (uint32_t)(pieces[i] != piece);
    }
    for (int i = 0; i < BLOCK; i++) any |= near[i];
    if (any == 0) return 0;
    for (int i = 0; i < BLOCK; i++) bits |= near[i] << i;
    return bits;
}

/* Compares the sample at a place with those at BLOCK others or fewer, from `first` to `end`. Returns whether the reach
 * of one of these others has become less. */
static bool compare_with_block(const dmi_pieces* pieces, const hash_grid* grid, uint32_t place, uint32_t first,
                               uint32_t end) {
    bool less = false;
    uint32_t bits = near_ones(grid, place, first);
    if (end - first < BLOCK) bits &= ((uint32_t)1 << (end - first)) - 1;
    for (; bits != 0; bits &= bits - 1) {
        const uint32_t other = first + dmi_trailing_zeros(bits);
        const float offset[3] = {grid->points[0][place] - grid->points[0][other],
                                 grid->points[1][place] - grid->points[1][other],
                                 grid->points[2][place] - grid->points[2][other]};
        const float square = dmi_dot3(offset, offset);
        add_contact(pieces, grid, place, other, square);
        less = add_contact(pieces, grid, other, place, square) || less;
    }
    return less;
}

/* Returns where the comparison of one sample with a bucket ends. The comparison begins at `first`. */
static uint32_t compared_end(const hash_grid* grid, uint32_t first, uint32_t end) {
    return end - first > grid->compared ? first + grid->compared : end;
}

static float block_reach(const hash_grid* grid, uint32_t first, uint32_t end) {
    float reach = 0;
    for (uint32_t at = first; at < end; at++)
        if (grid->reach[at] > reach) reach = grid->reach[at];
    return reach;
}

/* Returns the square of the distance from a point to the box of a bucket. It is rounded as the distances to the samples
 * are, and so is no larger than any of them. */
static float square_to_box(const bucket* b, const float point[3]) {
    float offset[3];
    for (int k = 0; k < 3; k++) {
        offset[k] = 0;
        if (point[k] < b->low[k]) offset[k] = b->low[k] - point[k];
        if (point[k] > b->high[k]) offset[k] = point[k] - b->high[k];
    }
    return dmi_dot3(offset, offset);
}

/* Compares the sample at a place with a bucket. It skips blocks in which nothing is near enough for a contact of
 * either. */
static void compare_with_bucket(const dmi_pieces* pieces, const hash_grid* grid, uint32_t place, const bucket* b) {
    if (b->first == b->end) return;
    const float point[3] = {grid->points[0][place], grid->points[1][place], grid->points[2][place]};
    const float square = square_to_box(b, point);
    if (square >= pieces->contact_distance * pieces->contact_distance) return;
    const uint32_t end = compared_end(grid, b->first, b->end);
    for (uint32_t at = b->first; at < end; at += BLOCK) {
        if (square >= grid->block_reach[at] && square >= grid->reach[place]) continue;
        const uint32_t block_end = end - at < BLOCK ? end : at + BLOCK;
        if (compare_with_block(pieces, grid, place, at, block_end))
            grid->block_reach[at] = block_reach(grid, at, block_end);
    }
}

/* Compares the sample at a place with the rest of its own bucket. */
static void compare_with_rest(const dmi_pieces* pieces, const hash_grid* grid, uint32_t place, uint32_t bucket_end) {
    const uint32_t end = compared_end(grid, place + 1, bucket_end);
    for (uint32_t at = place + 1; at < end; at += BLOCK)
        compare_with_block(pieces, grid, place, at, end - at < BLOCK ? end : at + BLOCK);
}

/* Compares sample `s` with the rest of its own cell's bucket and with half of the cells around, so that each pair of
 * samples is compared once. */
static void compare_with_neighbours(const dmi_pieces* pieces, const hash_grid* grid, uint32_t s) {
    const uint32_t place = grid->places[s];
    int32_t own[3], cell[3];
    cell_of(grid, pieces->samples[s].point, own);
    compare_with_rest(pieces, grid, place, grid->buckets[bucket_of(grid, own)].end);
    for (int i = FIRST_LATER_CELL; i < NEIGHBOUR_CELLS; i++) {
        cell[0] = own[0] + i % 3 - 1;
        cell[1] = own[1] + i / 3 % 3 - 1;
        cell[2] = own[2] + i / CELLS_OF_A_SLAB - 1;
        compare_with_bucket(pieces, grid, place, &grid->buckets[bucket_of(grid, cell)]);
    }
}

static uint32_t compared_with_each(uint32_t sample_count) {
    const uint32_t share = COMPARED_IN_ALL / sample_count;
    if (share > MAX_COMPARED) return MAX_COMPARED;
    return share > MIN_COMPARED ? share : MIN_COMPARED;
}

/* Takes the arrays of a grid from the arena. The last block of places may reach beyond them. */
static bool take_arrays(dmi_arena* arena, uint32_t count, hash_grid* out) {
    const size_t padded = (size_t)count + BLOCK, buckets = (size_t)out->mask + 1;
    out->buckets = dmi_arena_push(arena, buckets * sizeof *out->buckets);
    out->samples = dmi_arena_push(arena, count * sizeof *out->samples);
    out->places = dmi_arena_push(arena, count * sizeof *out->places);
    out->pieces = dmi_arena_push(arena, padded * sizeof *out->pieces);
    out->contacts = dmi_arena_push(arena, count * sizeof *out->contacts);
    float* numbers = dmi_arena_push(arena, NUMBERS_A_PLACE * padded * sizeof *numbers);
    if (out->buckets == NULL || out->samples == NULL || out->places == NULL || out->pieces == NULL ||
        out->contacts == NULL || numbers == NULL)
        return false;
    memset(out->buckets, 0, buckets * sizeof *out->buckets);
    memset(out->pieces, 0, padded * sizeof *out->pieces);
    memset(numbers, 0, NUMBERS_A_PLACE * padded * sizeof *numbers);
    for (size_t k = 0; k < 3; k++) out->points[k] = numbers + k * padded;
    out->reach = numbers + 3 * padded;
    out->block_reach = out->reach + padded;
    return true;
}

/* Sorts the samples by bucket, by a counting sort that fills each bucket from its last place to its first. */
static void place_samples(const dmi_pieces* pieces, uint32_t count, hash_grid* grid) {
    uint32_t end = 0;
    for (uint32_t s = 0; s < count; s++) {
        int32_t cell[3];
        cell_of(grid, pieces->samples[s].point, cell);
        grid->places[s] = bucket_of(grid, cell);
        grid->buckets[grid->places[s]].end++;
    }
    for (uint32_t b = 0; b <= grid->mask; b++) {
        end += grid->buckets[b].end;
        grid->buckets[b].first = grid->buckets[b].end = end;
    }
    for (uint32_t s = 0; s < count; s++) {
        const uint32_t place = --grid->buckets[grid->places[s]].first;
        grid->places[s] = place;
        grid->samples[place] = s;
        grid->pieces[place] = pieces->samples[s].piece;
        for (int k = 0; k < 3; k++) grid->points[k][place] = pieces->samples[s].point[k];
        grid->reach[place] = grid->block_reach[place] = pieces->contact_distance * pieces->contact_distance;
    }
}

static void bound_buckets(hash_grid* grid) {
    for (uint32_t i = 0; i <= grid->mask; i++) {
        bucket* b = &grid->buckets[i];
        const uint32_t end = compared_end(grid, b->first, b->end);
        for (int k = 0; k < 3; k++) {
            b->low[k] = INFINITY;
            b->high[k] = -INFINITY;
            for (uint32_t at = b->first; at < end; at++) {
                const float x = grid->points[k][at];
                if (x < b->low[k]) b->low[k] = x;
                if (x > b->high[k]) b->high[k] = x;
            }
        }
    }
}

static dm_result find_sample_contacts(dmi_arena* arena, dmi_pieces* pieces) {
    const uint32_t count = pieces->first[pieces->count];
    uint32_t buckets = MIN_SLOTS;
    while (buckets < count) buckets *= 2;
    hash_grid grid = {
        .mask = buckets - 1, .compared = compared_with_each(count), .cells_per_unit = 1 / pieces->contact_distance};
    if (!take_arrays(arena, count, &grid)) return no_memory_for_contacts(arena, pieces->mesh);
    place_samples(pieces, count, &grid);
    bound_buckets(&grid);
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
    if (seen == NULL || pieces->pairs == NULL) return no_memory_for_contacts(arena, pieces->mesh);
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

/* Fills the samples' contacts, `pairs` and `pair_count`. `samples`, `first` and `contact_distance` are given. */
static dm_result piece_contacts_find(dmi_arena* arena, dmi_pieces* pieces) {
    dm_result result = find_sample_contacts(arena, pieces);
    return result == DM_OK ? find_pairs(arena, pieces) : result;
}

/* ---- pieces ---- */

static dm_result out_of_memory(const dmi_arena* arena, const dmi_mesh* mesh) {
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to divide %u triangles into pieces",
                    mesh->face_count);
}

/* Returns the faces sorted by piece (counting sort), NULL without memory. Piece p's faces are begin[p] ..
 * begin[p + 1] - 1; begin has count + 2 entries. */
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

/* Draws a point that is uniformly distributed over the face. */
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

/* Places the piece's samples at equal steps of the running sum of its face areas (systematic sampling). */
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
            sample->contact_count = 0;
        }
    }
}

/* Returns how many samples each piece gets regardless of its area: at least 1. */
static uint32_t samples_added(uint32_t piece_count) {
    const uint32_t share = ADDED_SAMPLES / piece_count;
    if (share > MIN_PIECE_SAMPLES) return MIN_PIECE_SAMPLES;
    return share > 0 ? share : 1;
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
    const uint32_t added = samples_added(pieces->count);
    pieces->first[0] = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        const bool empty = begin[p] == begin[p + 1];
        const uint32_t share = empty ? 0 : added + (uint32_t)(MESH_SAMPLES * pieces->area[p] / total);
        pieces->first[p + 1] = pieces->first[p] + share;
    }
    pieces->contact_distance = CONTACT_SPACINGS * sqrtf(total / MESH_SAMPLES);
    pieces->samples = dmi_arena_push(arena, pieces->first[pieces->count] * sizeof *pieces->samples);
    if (pieces->samples == NULL) return out_of_memory(arena, mesh);
    dmi_random random = dmi_random_make(SAMPLE_SEED, 0);
    for (uint32_t p = 0; p < pieces->count; p++)
        sample_piece(pieces, p, faces + begin[p], begin[p + 1] - begin[p], &random);
    return DM_OK;
}

dm_result dmi_pieces_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* labels, uint32_t count,
                          dmi_pieces* out) {
    *out = (dmi_pieces){.mesh = mesh, .labels = labels, .count = count};
    dm_result result = sample_pieces(arena, out);
    return result == DM_OK ? piece_contacts_find(arena, out) : result;
}
