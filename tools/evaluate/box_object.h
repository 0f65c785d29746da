/* The object that the benchmark works on: a cabinet with a door and a handle, made of boxes of many triangles. */
#ifndef CLI_BOX_OBJECT_H
#define CLI_BOX_OBJECT_H

#include "dragmesh/dragmesh.h"

typedef struct box_object {
    float* positions;
    uint32_t* indices;
    uint8_t* part_ids; /* a face: 1 = the door */
    uint32_t vertex_count, face_count;
} box_object;

/* `grid`: squares along each side of a box. */
box_object box_object_new(int grid);
void box_object_free(box_object* object);
dm_mesh_desc box_object_mesh(const box_object* object);

/* A drag that pulls the door's handle open. */
extern const dm_drag_hint box_object_drag;

#endif
