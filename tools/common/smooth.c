/* Normals that are smooth over round surfaces and sharp at edges. */
#include "smooth.h"

#include <stdlib.h>
#include <string.h>

#include "cli.h"

/* Faces that meet at less than this cosine make an edge. */
static const double crease_cosine = 0.75;

typedef struct corner {
    float position[3];
    uint32_t vertex;
} corner;

static int by_position(const void* a, const void* b) {
    const corner *left = a, *right = b;
    for (int k = 0; k < 3; k++)
        if (left->position[k] != right->position[k]) return left->position[k] < right->position[k] ? -1 : 1;
    return left->vertex < right->vertex ? -1 : left->vertex > right->vertex;
}

static void weld(smooth_normals* smooth, uint64_t count) {
    corner* corners = cli_alloc(count * sizeof *corners);
    for (uint64_t v = 0; v < count; v++) {
        memcpy(corners[v].position, smooth->positions + 3 * v, sizeof corners[v].position);
        corners[v].vertex = (uint32_t)v;
    }
    qsort(corners, count, sizeof *corners, by_position);
    uint32_t first = 0;
    for (uint64_t i = 0; i < count; i++) {
        /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked */
        if (i == 0 || memcmp(corners[i].position, corners[i - 1].position, sizeof corners[i].position) != 0)
            first = corners[i].vertex;
        smooth->welded[corners[i].vertex] = first;
    }
    free(corners);
}

/* Which faces each welded vertex has, as a table of lists. */
static void list_faces(smooth_normals* smooth, uint64_t vertex_count, uint64_t face_count) {
    for (uint64_t i = 0; i < 3 * face_count; i++) smooth->first[smooth->welded[smooth->indices[i]] + 1]++;
    for (uint64_t v = 0; v < vertex_count; v++) smooth->first[v + 1] += smooth->first[v];
    uint32_t* next = cli_alloc(vertex_count * sizeof *next);
    memcpy(next, smooth->first, vertex_count * sizeof *next);
    for (uint64_t i = 0; i < 3 * face_count; i++)
        smooth->faces[next[smooth->welded[smooth->indices[i]]]++] = (uint32_t)(i / 3);
    free(next);
}

smooth_normals smooth_build(const dm_mesh_desc* mesh) {
    const uint64_t faces = mesh->index_count / 3;
    smooth_normals s = {.positions = mesh->positions,
                        .indices = mesh->indices,
                        .welded = cli_alloc(mesh->vertex_count * sizeof *s.welded),
                        .first = cli_alloc_zeroed((mesh->vertex_count + 1) * sizeof *s.first),
                        .faces = cli_alloc(mesh->index_count * sizeof *s.faces),
                        .normals = cli_alloc(faces * sizeof *s.normals)};
    for (uint64_t f = 0; f < faces; f++) {
        const vec a = vec_at(s.positions + 3 * (size_t)s.indices[3 * f]);
        const vec b = vec_at(s.positions + 3 * (size_t)s.indices[3 * f + 1]);
        const vec c = vec_at(s.positions + 3 * (size_t)s.indices[3 * f + 2]);
        s.normals[f] = cross(sub(b, a), sub(c, a));
    }
    weld(&s, mesh->vertex_count);
    list_faces(&s, mesh->vertex_count, faces);
    return s;
}

void smooth_free(smooth_normals* smooth) {
    free(smooth->welded);
    free(smooth->first);
    free(smooth->faces);
    free(smooth->normals);
}

static vec corner_normal(const smooth_normals* smooth, uint32_t vertex, vec own) {
    const uint32_t at = smooth->welded[vertex];
    vec sum = {0, 0, 0};
    for (uint32_t i = smooth->first[at]; i < smooth->first[at + 1]; i++) {
        const vec normal = smooth->normals[smooth->faces[i]];
        if (dot(unit(normal), own) > crease_cosine) sum = add(sum, normal);
    }
    return length(sum) > 0 ? unit(sum) : own;
}

vec smooth_at(const smooth_normals* smooth, uint32_t face, double u, double v) {
    const vec own = unit(smooth->normals[face]);
    const uint32_t* corners = smooth->indices + 3 * (size_t)face;
    const vec a = scale(corner_normal(smooth, corners[0], own), 1 - u - v);
    const vec b = scale(corner_normal(smooth, corners[1], own), u);
    const vec c = scale(corner_normal(smooth, corners[2], own), v);
    const vec sum = add(add(a, b), c);
    return length(sum) > 1e-6 ? unit(sum) : own;
}
