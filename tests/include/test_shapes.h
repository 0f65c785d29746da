/* Small meshes for tests: boxes with outward triangles, each of a part of its own or the body. */
#ifndef DM_TEST_SHAPES_H
#define DM_TEST_SHAPES_H

#include <stdint.h>

#include "dragmesh/dragmesh.h"

#define TEST_SHAPE_MAX 4096

typedef struct test_shape {
    float xyz[TEST_SHAPE_MAX][3];
    uint32_t corners[TEST_SHAPE_MAX][3];
    uint32_t part[TEST_SHAPE_MAX]; /* id of each face */
    uint32_t vertex_count, face_count;
} test_shape;

static inline uint32_t test_shape_vertex(test_shape* shape, float x, float y, float z) {
    float* p = shape->xyz[shape->vertex_count];
    p[0] = x;
    p[1] = y;
    p[2] = z;
    return shape->vertex_count++;
}

static inline void test_shape_face(test_shape* shape, uint32_t a, uint32_t b, uint32_t c, uint32_t part) {
    uint32_t* corners = shape->corners[shape->face_count];
    corners[0] = a;
    corners[1] = b;
    corners[2] = c;
    shape->part[shape->face_count++] = part;
}

enum { TEST_BOX_VERTICES = 8, TEST_BOX_FACES = 12 };

/* Corners of a box's triangles; bit k of a corner: whether it is at the upper end of axis k. */
static const uint8_t test_box_corners[TEST_BOX_FACES][3] = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
                                                            {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                            {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};

static inline void test_shape_box(test_shape* shape, const float min[3], const float max[3], uint32_t part) {
    const uint32_t first = shape->vertex_count;
    for (int i = 0; i < TEST_BOX_VERTICES; i++)
        test_shape_vertex(shape, i & 1 ? max[0] : min[0], i & 2 ? max[1] : min[1], i & 4 ? max[2] : min[2]);
    for (int t = 0; t < TEST_BOX_FACES; t++) {
        const uint8_t* at = test_box_corners[t];
        test_shape_face(shape, first + at[0], first + at[1], first + at[2], part);
    }
}

/* A cabinet of 2 x 1 x 1 (the body, a solid box) with a door on its +z side (part 1) that has a thin handle (part 2).
 */
static inline void test_shape_cabinet(test_shape* shape) {
    shape->vertex_count = shape->face_count = 0;
    test_shape_box(shape, (const float[]){0, 0, 0}, (const float[]){2, 1, 1}, 0);
    test_shape_box(shape, (const float[]){0, 0, 1.01f}, (const float[]){1, 1, 1.05f}, 1);
    test_shape_box(shape, (const float[]){0.9f, 0.4f, 1.05f}, (const float[]){0.92f, 0.6f, 1.07f}, 2);
}

static inline dm_mesh_desc test_shape_desc(const test_shape* shape) {
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = shape->xyz,
                          .vertex_count = shape->vertex_count,
                          .indices = shape->corners,
                          .index_count = (uint64_t)shape->face_count * 3,
                          .part_ids = shape->part,
                          .part_id_bytes = shape->face_count * sizeof *shape->part,
                          .part_id_scope = DM_PER_FACE};
}

#endif
