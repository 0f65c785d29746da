/* The object's triangles as the graphics card wants them: sorted by part and texture. */
#include "surface.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"

typedef struct vertex {
    dm_vec3 place, normal, colour;
    float uv[2];
} vertex;

typedef struct corner {
    dm_vec3 place;
    uint32_t index; /* 3 x face + corner */
} corner;

static const float crease = 0.766f; /* cos 40 degrees */

static dm_vec3 place_of(const world* world, uint32_t corner) {
    return vec_from((const float*)world->mesh.positions + 3 * (size_t)((const uint32_t*)world->mesh.indices)[corner]);
}

/* Length = twice the area, so that large faces count more. */
static dm_vec3 face_normal(const world* world, uint32_t face) {
    const dm_vec3 a = place_of(world, 3 * face), b = place_of(world, 3 * face + 1), c = place_of(world, 3 * face + 2);
    return cross(sub(b, a), sub(c, a));
}

static int by_place(const void* a, const void* b) {
    return memcmp(a, b, sizeof(dm_vec3));
}

/* Of the corners [first, end) in one place: each takes the faces there that lie nearly in its own plane. */
static void smooth(const corner* corners, uint32_t first, uint32_t end, const dm_vec3* faces, dm_vec3* normals) {
    for (uint32_t i = first; i < end; i++) {
        const dm_vec3 own = unit(faces[corners[i].index / 3]);
        dm_vec3 sum = {0, 0, 0};
        for (uint32_t k = first; k < end; k++) {
            const dm_vec3 other = faces[corners[k].index / 3];
            if (dot(own, other) >= crease * length(other)) sum = add(sum, other);
        }
        normals[corners[i].index] = unit(sum);
    }
}

static dm_vec3* corner_normals(const world* world) {
    const uint32_t count = world->face_count * 3;
    dm_vec3 *faces = take(world->face_count, sizeof *faces), *normals = take(count, sizeof *normals);
    corner* corners = take(count, sizeof *corners);
    for (uint32_t face = 0; face < world->face_count; face++) faces[face] = face_normal(world, face);
    for (uint32_t i = 0; i < count; i++) corners[i] = (corner){place_of(world, i), i};
    qsort(corners, count, sizeof *corners, by_place);
    for (uint32_t first = 0, end; first < count; first = end) {
        for (end = first + 1; end < count && by_place(&corners[first], &corners[end]) == 0;) end++;
        smooth(corners, first, end, faces, normals);
    }
    free(corners);
    free(faces);
    return normals;
}

/* A face in the order in which it is drawn. */
typedef struct drawn {
    uint32_t part, slot, face;
} drawn;

static int by_part_and_texture(const void* a, const void* b) {
    const drawn *x = a, *y = b;
    if (x->part != y->part) return x->part < y->part ? -1 : 1;
    if (x->slot != y->slot) return x->slot < y->slot ? -1 : 1;
    return x->face < y->face ? -1 : 1;
}

/* Faces of parts that the world does not have any more are the body's. */
static drawn* order_faces(const world* world, const textures* textures) {
    drawn* order = take(world->face_count, sizeof *order);
    for (uint32_t face = 0; face < world->face_count; face++) {
        const uint32_t part = world->face_part[face];
        order[face] = (drawn){part <= world->part_count ? part : 0, textures->slots[face], face};
    }
    qsort(order, world->face_count, sizeof *order, by_part_and_texture);
    return order;
}

/* Lists the runs of every part, and where its vertices begin. */
static void list_runs(surface* surface, const world* world, const textures* textures, const drawn* order) {
    uint32_t count = 0, part = 0;
    surface->runs = take(world->face_count, sizeof *surface->runs);
    for (uint32_t i = 0; i < world->face_count; i++) {
        const bool new_part = i == 0 || order[i].part != order[i - 1].part;
        for (; new_part && part <= order[i].part; part++)
            surface->first[part] = (GLint)(3 * i), surface->first_run[part] = count;
        if (new_part || order[i].slot != order[i - 1].slot)
            surface->runs[count++] = (surface_run){.first = (GLint)(3 * i), .texture = textures->names[order[i].slot]};
        surface->runs[count - 1].count += 3;
    }
    for (; part <= world->part_count + 1; part++)
        surface->first[part] = (GLint)(3 * world->face_count), surface->first_run[part] = count;
}

static vertex* make_vertices(const world* world, const textures* textures, const drawn* order) {
    dm_vec3* normals = corner_normals(world);
    vertex* vertices = take((size_t)world->face_count * 3, sizeof *vertices);
    for (uint32_t i = 0; i < 3 * world->face_count; i++) {
        const uint32_t face = order[i / 3].face, corner = 3 * face + i % 3;
        const float* uv = textures->uv[corner];
        vertices[i] = (vertex){place_of(world, corner), normals[corner], textures->colours[face], {uv[0], uv[1]}};
    }
    free(normals);
    return vertices;
}

void surface_make(surface* surface, const world* world, const textures* textures) {
    surface_free(surface);
    drawn* order = order_faces(world, textures);
    list_runs(surface, world, textures, order);
    vertex* vertices = make_vertices(world, textures, order);
    free(order);
    const uint32_t count = world->face_count * 3;
    surface->box_min = vec(INFINITY, INFINITY, INFINITY);
    surface->box_max = scale(surface->box_min, -1);
    for (uint32_t i = 0; i < count; i++) {
        surface->box_min = vec_min(surface->box_min, vertices[i].place);
        surface->box_max = vec_max(surface->box_max, vertices[i].place);
    }
    glGenVertexArrays(1, &surface->array);
    glGenBuffers(1, &surface->buffer);
    glBindVertexArray(surface->array);
    glBindBuffer(GL_ARRAY_BUFFER, surface->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *vertices), vertices, GL_STATIC_DRAW);
    const char* offset = NULL; /* of the attribute in a vertex, as OpenGL wants it: a pointer */
    for (GLuint i = 0; i < 4; i++, offset += sizeof(dm_vec3)) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, i < 3 ? 3 : 2, GL_FLOAT, GL_FALSE, sizeof *vertices, offset);
    }
    free(vertices);
}

void surface_free(surface* surface) {
    if (surface->array) glDeleteVertexArrays(1, &surface->array);
    if (surface->buffer) glDeleteBuffers(1, &surface->buffer);
    free(surface->runs);
    memset(surface, 0, sizeof *surface);
}
