/* A cabinet of five boxes for fuzz targets: a body, a door with a knob (part 1), a drawer (part 2), a button (part 3).
 */
#ifndef DM_FUZZ_BOX_MESH_H
#define DM_FUZZ_BOX_MESH_H

#include <stdint.h>

#include "dragmesh/dragmesh.h"

enum { BOX_MESH_BOXES = 5, BOX_MESH_PARTS = 3 };
enum { BOX_MESH_VERTICES = 8 * BOX_MESH_BOXES, BOX_MESH_TRIANGLES = 12 * BOX_MESH_BOXES };

typedef struct box_mesh {
    float positions[BOX_MESH_VERTICES][3];
    uint32_t indices[3 * BOX_MESH_TRIANGLES];
    uint8_t parts[BOX_MESH_TRIANGLES];
} box_mesh;

/* The knob. */
static const dm_vec3 box_mesh_grab = {0.45f, 0.5f, 0.55f};

static inline box_mesh box_mesh_make(void) {
    static const struct {
        float low[3], high[3];
        uint8_t part;
    } boxes[BOX_MESH_BOXES] = {{{-0.5f, -0.5f, -0.5f}, {0.5f, 1, 0.45f}, 0},
                               {{-0.5f, 0, 0.46f}, {0.5f, 1, 0.5f}, 1},
                               {{0.4f, 0.45f, 0.5f}, {0.5f, 0.55f, 0.55f}, 1},
                               {{-0.5f, -0.4f, 0}, {0.5f, -0.1f, 0.5f}, 2},
                               {{-0.1f, -0.48f, 0.45f}, {0, -0.42f, 0.49f}, 3}};
    static const uint8_t corners[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    box_mesh mesh;
    for (uint32_t b = 0; b < BOX_MESH_BOXES; b++) {
        for (uint32_t c = 0; c < 8; c++)
            for (uint32_t k = 0; k < 3; k++)
                mesh.positions[8 * b + c][k] = c >> k & 1 ? boxes[b].high[k] : boxes[b].low[k];
        for (uint32_t t = 0; t < 12; t++) {
            for (uint32_t k = 0; k < 3; k++) mesh.indices[3 * (12 * b + t) + k] = 8 * b + corners[t][k];
            mesh.parts[12 * b + t] = boxes[b].part;
        }
    }
    return mesh;
}

/* Part ids a face. */
static inline dm_mesh_desc box_mesh_desc(const box_mesh* mesh) {
    const dm_mesh_desc desc = {.struct_size = sizeof desc,
                               .positions = mesh->positions,
                               .vertex_count = BOX_MESH_VERTICES,
                               .indices = mesh->indices,
                               .index_count = 3 * BOX_MESH_TRIANGLES,
                               .part_ids = mesh->parts,
                               .part_id_bytes = sizeof mesh->parts,
                               .part_id_format = DM_UINT8,
                               .part_id_scope = DM_PER_FACE};
    return desc;
}

#endif
