/* Makes the object of the benchmark: a cabinet with a door and a handle, made of boxes of many triangles. */
#include "box_object.h"

#include <stdlib.h>

#include "cli.h"

typedef struct box {
    float low[3], high[3];
    uint8_t part;
} box;

/* Metres. The door is in front, hinged at its left side, with a bar for a handle at its right. */
static const box boxes[] = {
    {{-0.25f, 0, -0.4f}, {0.25f, 0.02f, 0}, 0},          {{-0.25f, 0.78f, -0.4f}, {0.25f, 0.8f, 0}, 0},
    {{-0.25f, 0.02f, -0.4f}, {-0.23f, 0.78f, 0}, 0},     {{0.23f, 0.02f, -0.4f}, {0.25f, 0.78f, 0}, 0},
    {{-0.23f, 0.02f, -0.4f}, {0.23f, 0.78f, -0.38f}, 0}, {{-0.25f, 0, 0.002f}, {0.25f, 0.8f, 0.022f}, 1},
    {{0.2f, 0.3f, 0.03f}, {0.215f, 0.5f, 0.045f}, 1}};
enum { BOXES = sizeof boxes / sizeof *boxes };

const dm_drag_hint box_object_drag = {{0.21f, 0.4f, 0.045f}, {0, 0, 0.1f}};

static void add_side(box_object* object, const box* from, int axis, int far, int grid) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const uint32_t base = object->vertex_count;
    for (int j = 0; j <= grid; j++) {
        for (int i = 0; i <= grid; i++) {
            float* p = object->positions + 3 * (size_t)object->vertex_count++;
            p[axis] = far ? from->high[axis] : from->low[axis];
            p[u] = from->low[u] + (from->high[u] - from->low[u]) * (float)i / (float)grid;
            p[v] = from->low[v] + (from->high[v] - from->low[v]) * (float)j / (float)grid;
        }
    }
    const uint32_t row = (uint32_t)grid + 1;
    for (uint32_t j = 0; j < (uint32_t)grid; j++) {
        for (uint32_t i = 0; i < (uint32_t)grid; i++) {
            const uint32_t a = base + j * row + i, b = a + 1, c = a + row, d = c + 1;
            const uint32_t corners[2][6] = {{a, c, b, b, c, d}, {a, b, c, c, b, d}};
            for (int k = 0; k < 6; k++) object->indices[3 * (size_t)object->face_count + (size_t)k] = corners[far][k];
            object->part_ids[object->face_count++] = from->part;
            object->part_ids[object->face_count++] = from->part;
        }
    }
}

box_object box_object_new(int grid) {
    const size_t sides = (size_t)BOXES * 6, row = (size_t)grid + 1, squares = (size_t)grid * (size_t)grid;
    box_object object = {.positions = cli_alloc(sides * row * row * 3 * sizeof(float)),
                         .indices = cli_alloc(sides * squares * 6 * sizeof(uint32_t)),
                         .part_ids = cli_alloc(sides * squares * 2)};
    for (int i = 0; i < BOXES; i++)
        for (int side = 0; side < 6; side++) add_side(&object, &boxes[i], side / 2, side % 2, grid);
    return object;
}

void box_object_free(box_object* object) {
    free(object->positions);
    free(object->indices);
    free(object->part_ids);
}

dm_mesh_desc box_object_mesh(const box_object* object) {
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = object->positions,
                          .vertex_count = object->vertex_count,
                          .indices = object->indices,
                          .index_count = 3 * (uint64_t)object->face_count,
                          .part_ids = object->part_ids,
                          .part_id_bytes = object->face_count,
                          .part_id_format = DM_UINT8,
                          .part_id_scope = DM_PER_FACE};
}
