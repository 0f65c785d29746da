/* Samples the surfaces of pieces in proportion to their area. */
#include "segmentation/pieces.h"

#include <string.h>

#include "base/random.h"
#include "math/linear3.h"
#include "segmentation/piece_contacts.h"

#define MESH_SAMPLES 12288   /* samples distributed over the whole mesh by area; by hand */
#define MIN_PIECE_SAMPLES 16 /* samples added to every piece that has faces, whatever its area; by hand */
#define ADDED_SAMPLES                                                                                                  \
    32768 /* samples of all pieces: where there are more pieces than this allows for, each gets fewer; by hand */
#define CONTACT_SPACINGS 1.25f /* contact distance in mean sample spacings; by hand */
#define SAMPLE_SEED 1          /* seed of the random positions within faces; arbitrary */

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

/* Draws a uniformly distributed point of the face. */
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

/* Returns how many samples each piece gets whatever its area: at least 1. */
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
    return result == DM_OK ? dmi_piece_contacts_find(arena, out) : result;
}
