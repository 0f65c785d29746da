/* Adds segmentation errors to a part mask: a patch of the part is lost, a patch of the rest leaks in. */
#include "mask_noise.h"

#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "vec.h"

typedef struct candidate {
    double distance;
    uint64_t vertex;
} candidate;

static int by_distance(const void* a, const void* b) {
    const candidate *left = a, *right = b;
    if (left->distance != right->distance) return left->distance < right->distance ? -1 : 1;
    return left->vertex < right->vertex ? -1 : left->vertex > right->vertex;
}

/* Flips the `count` vertices of id `from` that are nearest to `centre`. */
static void flip_nearest(const float* positions, uint64_t vertex_count, const float* centre, uint8_t from,
                         uint64_t count, candidate* room, uint8_t* ids) {
    uint64_t found = 0;
    for (uint64_t v = 0; v < vertex_count; v++) {
        if (ids[v] != from) continue;
        const vec offset = sub(vec_at(positions + 3 * v), vec_at(centre));
        room[found++] = (candidate){dot(offset, offset), v};
    }
    qsort(room, found, sizeof *room, by_distance);
    for (uint64_t i = 0; i < count && i < found; i++) ids[room[i].vertex] = !from;
}

/* A random vertex of the part. */
static const float* any_of_part(const float* positions, uint64_t vertex_count, uint64_t part_count,
                                random_state* random, const uint8_t* ids) {
    uint64_t left = (uint64_t)(random_unit(random) * (double)part_count);
    for (uint64_t v = 0; v < vertex_count; v++) {
        if (ids[v] && left-- == 0) return positions + 3 * v;
    }
    return positions;
}

void mask_noise_apply(const float* positions, uint64_t vertex_count, double fraction, random_state* random,
                      uint8_t* vertex_ids) {
    uint64_t part = 0;
    for (uint64_t v = 0; v < vertex_count; v++) part += vertex_ids[v];
    const uint64_t rest = vertex_count - part, change = (uint64_t)(fraction * (double)part);
    if (change == 0 || rest == 0) return;
    candidate* room = cli_alloc(vertex_count * sizeof *room);
    uint8_t* before = cli_alloc(vertex_count);
    memcpy(before, vertex_ids, vertex_count);
    const float* lost = any_of_part(positions, vertex_count, part, random, before);
    const float* leak = any_of_part(positions, vertex_count, part, random, before);
    flip_nearest(positions, vertex_count, lost, 1, change, room, vertex_ids);
    for (uint64_t v = 0; v < vertex_count; v++)
        before[v] = before[v] ? 2 : 0; /* what was just lost does not leak back */
    flip_nearest(positions, vertex_count, leak, 0, change < rest / 4 ? change : rest / 4, room, before);
    for (uint64_t v = 0; v < vertex_count; v++) vertex_ids[v] |= before[v] == 1;
    free(before);
    free(room);
}

void mask_vertices_of_faces(const uint32_t* indices, uint64_t face_count, const uint8_t* face_ids,
                            uint64_t vertex_count, uint8_t* out_vertex_ids) {
    memset(out_vertex_ids, 0, vertex_count);
    for (uint64_t corner = 0; corner < 3 * face_count; corner++)
        if (face_ids[corner / 3]) out_vertex_ids[indices[corner]] = 1;
}
