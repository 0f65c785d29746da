/* Which faces belong to which part, by hand: a brush, and filling what hangs together. */
#include <stdbool.h>
#include <stdlib.h>

#include "files.h"
#include "parts.h"

static uint32_t vertex_of(const world* world, size_t face, size_t corner) {
    return ((const uint32_t*)world->mesh.indices)[3 * face + corner];
}

static dm_vec3 place_of(const world* world, uint32_t vertex) {
    return vec_from((const float*)world->mesh.positions + 3 * (size_t)vertex);
}

static bool touches(const world* world, uint32_t face, dm_vec3 point, float radius) {
    for (size_t k = 0; k < 3; k++)
        if (length(sub(place_of(world, vertex_of(world, face, k)), point)) <= radius) return true;
    return false;
}

uint32_t parts_paint(world* world, dm_vec3 point, float radius, uint32_t part) {
    uint32_t changed = 0;
    for (uint32_t face = 0; face < world->face_count; face++) {
        if (world->face_part[face] == part || !touches(world, face, point, radius)) continue;
        world->face_part[face] = (uint8_t)part;
        changed++;
    }
    return changed;
}

typedef struct placed {
    dm_vec3 place;
    uint32_t vertex;
} placed;

static int by_place(const void* a, const void* b) {
    const dm_vec3 p = ((const placed*)a)->place, q = ((const placed*)b)->place;
    if (p.x != q.x) return p.x < q.x ? -1 : 1;
    if (p.y != q.y) return p.y < q.y ? -1 : 1;
    return p.z == q.z ? 0 : p.z < q.z ? -1 : 1;
}

static uint32_t root_of(uint32_t* links, uint32_t i) {
    while (links[i] != i) i = links[i] = links[links[i]];
    return i;
}

static void join(uint32_t* links, uint32_t a, uint32_t b) {
    links[root_of(links, a)] = root_of(links, b);
}

/* Vertices in the same place, and the corners of a face, hang together. */
static uint32_t* link_vertices(const world* world) {
    const uint32_t count = (uint32_t)world->mesh.vertex_count;
    uint32_t* links = take(count, sizeof *links);
    placed* order = take(count, sizeof *order);
    for (uint32_t i = 0; i < count; i++) {
        links[i] = i;
        order[i] = (placed){place_of(world, i), i};
    }
    qsort(order, count, sizeof *order, by_place);
    for (uint32_t i = 1; i < count; i++)
        if (by_place(&order[i - 1], &order[i]) == 0) join(links, order[i].vertex, order[i - 1].vertex);
    for (uint32_t face = 0; face < world->face_count; face++)
        for (size_t k = 1; k < 3; k++) join(links, vertex_of(world, face, k), vertex_of(world, face, 0));
    free(order);
    return links;
}

uint32_t parts_fill(world* world, uint32_t face, uint32_t part) {
    uint32_t* links = link_vertices(world);
    const uint32_t root = root_of(links, vertex_of(world, face, 0));
    uint32_t changed = 0;
    for (uint32_t i = 0; i < world->face_count; i++) {
        if (root_of(links, vertex_of(world, i, 0)) != root || world->face_part[i] == part) continue;
        world->face_part[i] = (uint8_t)part;
        changed++;
    }
    free(links);
    return changed;
}
