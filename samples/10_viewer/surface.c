/* The object's triangles as the graphics card wants them: smooth normals, colours, one range a part. */
#include "surface.h"

#include <stdlib.h>
#include <string.h>

#include "files.h"

typedef struct vertex {
    vec3 place, normal, colour;
} vertex;

typedef struct corner {
    vec3 place;
    uint32_t index; /* 3 x face + corner */
} corner;

static const float crease = 0.766f; /* cos 40 degrees */

static vec3 place_of(const world* world, uint32_t corner) {
    return vec_from((const float*)world->mesh.positions + 3 * (size_t)((const uint32_t*)world->mesh.indices)[corner]);
}

/* Length = twice the area, so that large faces count more. */
static vec3 face_normal(const world* world, uint32_t face) {
    const vec3 a = place_of(world, 3 * face), b = place_of(world, 3 * face + 1), c = place_of(world, 3 * face + 2);
    return cross(sub(b, a), sub(c, a));
}

static int by_place(const void* a, const void* b) {
    return memcmp(a, b, sizeof(vec3));
}

/* Of the corners [first, end) in one place: each takes the faces there that lie nearly in its own plane. */
static void smooth(const corner* corners, uint32_t first, uint32_t end, const vec3* faces, vec3* normals) {
    for (uint32_t i = first; i < end; i++) {
        const vec3 own = unit(faces[corners[i].index / 3]);
        vec3 sum = {0, 0, 0};
        for (uint32_t k = first; k < end; k++) {
            const vec3 other = faces[corners[k].index / 3];
            if (dot(own, other) >= crease * length(other)) sum = add(sum, other);
        }
        normals[corners[i].index] = unit(sum);
    }
}

static vec3* corner_normals(const world* world) {
    const uint32_t count = world->face_count * 3;
    vec3 *faces = take(world->face_count, sizeof *faces), *normals = take(count, sizeof *normals);
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

/* The file's own colour, held between too dark and too bright to light well. */
static vec3 node_colour(const dm_gltf_node* node) {
    const vec3 c = vec(node->colour[0], node->colour[1], node->colour[2]);
    return vec(clampf(c.x, 0.03f, 0.8f), clampf(c.y, 0.03f, 0.8f), clampf(c.z, 0.03f, 0.8f));
}

static vec3* face_colours(const world* world) {
    vec3* colours = take(world->face_count, sizeof *colours);
    dm_gltf_node node;
    for (uint32_t i = 0; i < dm_gltf_node_count(world->gltf); i++) {
        if (dm_gltf_get_node(world->gltf, i, &node) != DM_OK) continue;
        for (uint64_t face = 0; face < node.face_count; face++) colours[node.first_face + face] = node_colour(&node);
    }
    return colours;
}

static vertex* ordered_by_part(surface* surface, const world* world) {
    vec3 *normals = corner_normals(world), *colours = face_colours(world);
    vertex* vertices = take((size_t)world->face_count * 3, sizeof *vertices);
    uint32_t count = 0;
    for (uint32_t part = 0; part <= world->part_count; part++) {
        surface->first[part] = (GLint)count;
        for (uint32_t face = 0; face < world->face_count; face++) {
            if (world->face_part[face] != part) continue;
            for (uint32_t k = 3 * face; k < 3 * face + 3; k++)
                vertices[count++] = (vertex){place_of(world, k), normals[k], colours[face]};
        }
    }
    surface->first[world->part_count + 1] = (GLint)count;
    free(normals);
    free(colours);
    return vertices;
}

void surface_make(surface* surface, const world* world) {
    surface_free(surface);
    vertex* vertices = ordered_by_part(surface, world);
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
    for (GLuint i = 0; i < 3; i++, offset += sizeof(vec3)) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof *vertices, offset);
    }
    free(vertices);
}

void surface_free(surface* surface) {
    if (surface->array) glDeleteVertexArrays(1, &surface->array);
    if (surface->buffer) glDeleteBuffers(1, &surface->buffer);
    memset(surface, 0, sizeof *surface);
}
