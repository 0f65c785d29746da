/* A cabinet of five boxes for fuzz targets: a body, a door with a knob (part 1), a drawer (part 2), a button (part 3).
 */
#ifndef DM_FUZZ_CABINET_H
#define DM_FUZZ_CABINET_H

#include "../include/test_shapes.h"
#include "expect.h"

enum { CABINET_BOXES = 5, CABINET_PARTS = 3 };
enum { CABINET_VERTICES = TEST_BOX_VERTICES * CABINET_BOXES, CABINET_FACES = TEST_BOX_FACES * CABINET_BOXES };

/* The knob. */
static const dm_vec3 cabinet_grab = {0.45f, 0.5f, 0.55f};

static inline void cabinet_make(test_shape* out) {
    static const struct {
        float low[3], high[3];
        uint32_t part;
    } boxes[CABINET_BOXES] = {{{-0.5f, -0.5f, -0.5f}, {0.5f, 1, 0.45f}, 0},
                              {{-0.5f, 0, 0.46f}, {0.5f, 1, 0.5f}, 1},
                              {{0.4f, 0.45f, 0.5f}, {0.5f, 0.55f, 0.55f}, 1},
                              {{-0.5f, -0.4f, 0}, {0.5f, -0.1f, 0.5f}, 2},
                              {{-0.1f, -0.48f, 0.45f}, {0, -0.42f, 0.49f}, 3}};
    out->vertex_count = out->face_count = 0;
    for (int b = 0; b < CABINET_BOXES; b++) test_shape_box(out, boxes[b].low, boxes[b].high, boxes[b].part);
}

/* Prepares one in the context; ends the process where that fails. */
static inline dm_object cabinet_prepare(dm_context* context) {
    static test_shape shape;
    cabinet_make(&shape);
    const dm_mesh_desc mesh = test_shape_desc(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh};
    dm_object object = 0;
    fuzz_expect(dm_object_prepare(context, &desc, &object) == DM_OK);
    return object;
}

#endif
