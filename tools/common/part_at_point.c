/* --moving auto: finds the part at the grabbed point. */
#include "part_at_point.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output_file.h"

bool part_at_point_requested(const name_list* moving) {
    return moving->count == 1 && strcmp(moving->names[0], "auto") == 0;
}

dm_result part_at_point_mark(session* session, const float* positions, const dm_drag_hint* drag, bool merged,
                             uint8_t* out_face_ids) {
    const uint64_t faces = session->mesh.index_count / 3;
    dm_mesh_desc mesh = session->mesh;
    uint32_t* nodes = cli_alloc_zeroed(faces * sizeof *nodes);
    for (uint32_t i = 0; i < dm_gltf_node_count(session->gltf); i++) {
        dm_gltf_node node;
        dm_gltf_get_node(session->gltf, i, &node);
        for (uint64_t f = 0; f < node.face_count; f++) nodes[node.first_face + f] = i;
    }
    if (positions != NULL) mesh.positions = positions;
    if (!merged) {
        mesh.part_ids = nodes;
        mesh.part_id_bytes = faces * sizeof *nodes;
        mesh.part_id_format = DM_UINT32;
        mesh.part_id_scope = DM_PER_FACE;
    }
    const dm_result result = dm_mesh_find_part(session->context, &mesh, drag, out_face_ids, faces);
    free(nodes);
    return result;
}

void part_at_point_to_json(const session* session, cJSON* out) {
    uint8_t* moving = session_moving_faces(session);
    for (uint32_t i = 0; i < dm_gltf_node_count(session->gltf); i++) {
        dm_gltf_node node;
        uint64_t inside = 0;
        dm_gltf_get_node(session->gltf, i, &node);
        for (uint64_t f = 0; f < node.face_count; f++) inside += moving[node.first_face + f] != 0;
        if (2 * inside > node.face_count) cJSON_AddItemToArray(out, cJSON_CreateString(node.name));
    }
    free(moving);
}

int part_at_point_write(const session* session, const char* path) {
    const size_t faces = (size_t)(session->mesh.index_count / 3);
    uint8_t* moving = session_moving_faces(session);
    char* text = cli_alloc(2 * faces + 2);
    for (size_t f = 0; f < faces; f++) {
        text[2 * f] = f == 0 ? '[' : ',';
        text[2 * f + 1] = moving[f] ? '1' : '0';
    }
    text[2 * faces] = ']';
    text[2 * faces + 1] = '\n';
    const int status = output_write(path, text, 2 * faces + 2);
    if (status != 0) fprintf(stderr, "dragmesh: can't write '%s': %s\n", path, strerror(errno));
    free(text);
    free(moving);
    return status;
}
