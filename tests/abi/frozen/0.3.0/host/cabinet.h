/* A kitchen cabinet in plain arrays, for the samples whose point is something else: a body, a door (part 1, hinge on
 * the left) and a drawer above it (part 2). Metres, y up, the front faces +z. */
#ifndef SAMPLES_CABINET_H
#define SAMPLES_CABINET_H

#include <stdio.h>

#include "dragmesh/dragmesh.h"

enum { CABINET_BOXES = 13, CABINET_VERTICES = CABINET_BOXES * 8, CABINET_INDICES = CABINET_BOXES * 36 };
enum { CABINET_DOOR = 1, CABINET_DRAWER = 2 };

static const float cabinet_boxes[CABINET_BOXES][7] = {
    {0.00f, 0.00f, 0.000f, 0.60f, 0.02f, 0.40f, 0},               /* bottom: from x, y, z to x, y, z, part */
    {0.00f, 0.98f, 0.000f, 0.60f, 1.00f, 0.42f, 0},               /* top */
    {0.00f, 0.02f, 0.000f, 0.02f, 0.98f, 0.40f, 0},               /* left */
    {0.58f, 0.02f, 0.000f, 0.60f, 0.98f, 0.40f, 0},               /* right */
    {0.02f, 0.02f, 0.000f, 0.58f, 0.98f, 0.02f, 0},               /* back */
    {0.00f, 0.00f, 0.402f, 0.60f, 0.79f, 0.42f, CABINET_DOOR},    /* the door … */
    {0.54f, 0.35f, 0.420f, 0.56f, 0.55f, 0.45f, CABINET_DOOR},    /* … and its handle, on the right */
    {0.00f, 0.80f, 0.402f, 0.60f, 0.97f, 0.42f, CABINET_DRAWER},  /* the drawer's front … */
    {0.25f, 0.87f, 0.420f, 0.35f, 0.89f, 0.45f, CABINET_DRAWER},  /* … handle … */
    {0.04f, 0.82f, 0.030f, 0.56f, 0.83f, 0.402f, CABINET_DRAWER}, /* … and box */
    {0.04f, 0.83f, 0.030f, 0.05f, 0.95f, 0.402f, CABINET_DRAWER},
    {0.55f, 0.83f, 0.030f, 0.56f, 0.95f, 0.402f, CABINET_DRAWER},
    {0.05f, 0.83f, 0.030f, 0.55f, 0.95f, 0.040f, CABINET_DRAWER},
};

typedef struct cabinet {
    float positions[CABINET_VERTICES][3];
    uint16_t indices[CABINET_INDICES];
    uint8_t parts[CABINET_VERTICES]; /* of each vertex; 0 = the body */
} cabinet;

/* Fills the arrays and describes them; the description points into them. */
static inline dm_mesh_desc cabinet_make(cabinet* out) {
    static const uint8_t corners[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                        2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    for (int v = 0; v < CABINET_VERTICES; v++) {
        for (int k = 0; k < 3; k++) out->positions[v][k] = cabinet_boxes[v / 8][v >> k & 1 ? k + 3 : k];
        out->parts[v] = (uint8_t)cabinet_boxes[v / 8][6];
    }
    for (int i = 0; i < CABINET_INDICES; i++) out->indices[i] = (uint16_t)(i / 36 * 8 + corners[i % 36]);
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = out->positions,
                          .vertex_count = CABINET_VERTICES,
                          .indices = out->indices,
                          .index_count = CABINET_INDICES,
                          .index_bytes = sizeof out->indices,
                          .index_format = DM_UINT16,
                          .part_ids = out->parts,
                          .part_id_bytes = sizeof out->parts,
                          .part_id_format = DM_UINT8};
}

/* Somewhere to put the messages: the one thing every host should connect from the first day. */
static inline void DM_CALL print_message(void* user, int32_t level, dm_result code, const char* text) {
    (void)user;
    if (level <= DM_LOG_WARNING) fprintf(stderr, "%s: %s\n", dm_result_string(code), text);
}

static inline const char* joint_name(int32_t type) {
    static const char* const names[] = {"unknown", "revolute", "prismatic", "screw", "continuous", "fixed"};
    return type >= 0 && type <= DM_JOINT_FIXED ? names[type] : "unknown";
}

#endif
