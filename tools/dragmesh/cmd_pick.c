/* dragmesh pick: what a ray meets first in a file. */
#include <stdio.h>
#include <stdlib.h>

#include "json.h"
#include "nodes.h"
#include "options.h"
#include "runs.h"
#include "session_open.h"

/* A scene wants an object with a part. Picking asks for none, so the first triangle is entered once more, as a part
 * that is fixed; a hit on either copy is that triangle. */
static dm_result prepare_for_picking(session* session) {
    const dm_mesh_desc* mesh = &session->mesh;
    const uint64_t faces = mesh->index_count / 3;
    uint32_t* indices = cli_alloc((mesh->index_count + 3) * sizeof *indices);
    uint8_t* ids = cli_alloc_zeroed(faces + 1);
    for (uint64_t i = 0; i < mesh->index_count + 3; i++)
        indices[i] = ((const uint32_t*)mesh->indices)[i % mesh->index_count];
    ids[faces] = 1;
    dm_mesh_desc doubled = *mesh;
    doubled.indices = indices;
    doubled.index_count += 3;
    doubled.part_ids = ids;
    doubled.part_id_bytes = faces + 1;
    doubled.part_id_format = DM_UINT8;
    doubled.part_id_scope = DM_PER_FACE;
    const dm_part_desc part = {.struct_size = sizeof part, .id = 1, .joint_type = DM_JOINT_FIXED};
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &doubled, .parts = &part, .part_count = 1};
    const dm_result result = dm_object_prepare(session->context, &desc, &session->object);
    free(indices);
    free(ids);
    return result;
}

static dm_result pick(session* session, const dm_ray* ray, dm_hit* out_hit) {
    dm_scene scene;
    uint32_t instance;
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_result result = prepare_for_picking(session);
    if (result == DM_OK) result = dm_scene_create(session->context, &desc, &scene);
    if (result == DM_OK) result = dm_scene_add(session->context, scene, session->object, NULL, &instance);
    if (result == DM_OK) result = dm_scene_commit(session->context, scene);
    if (result == DM_OK) result = dm_scene_pick(session->context, scene, ray, out_hit);
    if (result == DM_OK) out_hit->triangle %= (uint32_t)(session->mesh.index_count / 3);
    return result;
}

static void print_hit(const session* session, const dm_hit* hit, int as_json) {
    dm_gltf_node node = {0};
    if (hit->object) dm_gltf_get_node(session->gltf, node_of_face(session->gltf, hit->triangle), &node);
    if (!as_json && !hit->object) printf("nothing\n");
    if (!as_json && hit->object)
        printf("%s, triangle %llu of it, at (%g, %g, %g), %g away\n", node.name,
               (unsigned long long)(hit->triangle - node.first_face), (double)hit->point.x + session->origin[0] + 0.0,
               (double)hit->point.y + session->origin[1] + 0.0, (double)hit->point.z + session->origin[2] + 0.0,
               (double)hit->distance); /* no -0 */
    if (!as_json) return;
    cJSON* out = cJSON_CreateObject();
    cJSON_AddBoolToObject(out, "hit", hit->object != 0);
    if (hit->object) {
        cJSON_AddStringToObject(out, "node", node.name);
        cJSON_AddNumberToObject(out, "node_index", node.node);
        cJSON_AddNumberToObject(out, "triangle", hit->triangle);
        cJSON_AddNumberToObject(out, "node_triangle", (double)(hit->triangle - node.first_face));
        json_add_number(out, "distance", (double)hit->distance, 9);
        json_add_point(out, "point", hit->point, session->origin);
        json_add_vector(out, "normal", hit->normal);
    }
    session_warnings_to_json(session, out);
    json_print_line(out);
}

int pick_run(const cli_command* command, int argc, char** argv) {
    const char* file = NULL;
    int as_json = 0, has_ray = 0;
    double numbers[6];
    const option_spec table[] = {
        {.name = "--ray", .kind = OPTION_DOUBLES, .value = numbers, .count = 6, .given = &has_ray},
        {.name = "--json", .kind = OPTION_FLAG, .value = &as_json}};
    session session;
    int status = options_read(command, argc, argv, table, 2, &file);
    if (status == CLI_OK && (file == NULL || !has_ray))
        status = options_refuse(command, "a file and a --ray are needed");
    if (status == CLI_OK) status = session_open(&session, "none", NULL);
    if (status != CLI_OK) return status;
    dm_hit hit = {.struct_size = sizeof hit};
    dm_result result = session_use_file(&session, file);
    const dm_ray ray = {session_point(&session, numbers), {(float)numbers[3], (float)numbers[4], (float)numbers[5]}};
    if (result == DM_OK) result = pick(&session, &ray, &hit);
    if (result == DM_OK)
        print_hit(&session, &hit, as_json);
    else
        fprintf(stderr, "dragmesh: %s\n", session.error);
    session_close(&session);
    return result == DM_OK ? CLI_OK : CLI_FAILED;
}
