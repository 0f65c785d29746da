/* dragmesh prepare: a file's parts, their joints found, as a .dmo that a game loads without the network. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "answer.h"
#include "files.h"
#include "job.h"
#include "json.h"
#include "rig_output.h"
#include "runs.h"
#include "session_open.h"

/* How the parts are told. */
typedef struct request {
    name_list moving; /* nodes that are one part; none: the whole asset is asked for its parts */
    bool no_hints;
    double min_moves;
} request;

/* ---- one part, by its names ---- */

static dm_result mark_part(session* session, const name_list* moving, uint8_t* ids) {
    const uint64_t faces = session->mesh.index_count / 3;
    return dm_gltf_mark_faces(session->gltf, (const char* const*)moving->names, moving->count, 1, ids, faces);
}

/* A named node takes what it carries along. */
static dm_result prepare_named(session* session, const request* request) {
    uint8_t* ids = cli_alloc_zeroed(session->mesh.index_count / 3);
    dm_part_desc part = {.struct_size = sizeof part, .id = 1};
    part_hints hints;
    if (!request->no_hints) {
        part_hints_of_node(session->gltf, session->path, request->moving.names[0], &hints);
        part_hints_enter(&hints, &part);
    }
    dm_mesh_desc mesh = session->mesh;
    mesh.part_ids = ids;
    mesh.part_id_bytes = mesh.index_count / 3;
    mesh.part_id_format = DM_UINT8;
    mesh.part_id_scope = DM_PER_FACE;
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .flags = session_prepare_flags(session),
                                 .mesh = &mesh,
                                 .parts = &part,
                                 .part_count = 1,
                                 .model = session->model};
    dm_result result = mark_part(session, &request->moving, ids);
    if (result == DM_OK) result = dm_object_prepare(session->context, &desc, &session->object);
    free(ids);
    return result;
}

/* ---- a whole asset ---- */

static dm_result prepare_whole(session* session, const char* file, const request* request, rig* out_rig) {
    const rig_options options = {
        .without_names = request->no_hints, .without_pivots = request->no_hints, .min_moves = request->min_moves};
    const dm_result result = rig_make(session, file, &options, out_rig);
    if (result != DM_OK) return result;
    return dm_asset_make_object(session->context, out_rig->asset, &session->object);
}

/* ---- what is written and said ---- */

static dm_result save(session* session, const char* path, size_t* out_size) {
    size_t size = 0;
    dm_result result = dm_object_save(session->context, session->object, NULL, 0, &size);
    if (result != DM_OK) return result;
    void* bytes = cli_alloc(size);
    result = dm_object_save(session->context, session->object, bytes, size, &size);
    if (result == DM_OK) result = session_write(session, path, bytes, size);
    free(bytes);
    *out_size = size;
    return result;
}

/* Adds the names of a part: those that were asked for, or those of its nodes. */
static void add_names(const session* session, const request* request, const rig* rig, uint32_t id, cJSON* item) {
    char name[256];
    if (request->moving.count > 0)
        snprintf(name, sizeof name, "%s%s", request->moving.names[0], request->moving.count > 1 ? " …" : "");
    else
        snprintf(name, sizeof name, "%s", rig_part_name(rig, id - 1));
    dm_gltf_mend_text(name);
    cJSON_AddStringToObject(item, "name", name);
    if (request->moving.count == 0) rig_nodes_to_json(session, rig, id - 1, item);
}

static cJSON* part_to_json(session* session, const request* request, const rig* rig, uint32_t index) {
    dm_part_info part = {.struct_size = sizeof part};
    dm_joint joint = dm_joint_default();
    dm_object_get_part(session->context, session->object, index, &part);
    dm_object_get_joint(session->context, session->object, part.id, &joint);
    cJSON* item = cJSON_CreateObject();
    cJSON_AddNumberToObject(item, "id", part.id);
    cJSON_AddNumberToObject(item, "parent", part.parent);
    add_names(session, request, rig, part.id, item);
    joint_to_json(&joint, session->origin, item);
    return item;
}

static void report(session* session, const request* request, const rig* rig, size_t bytes, bool as_json) {
    dm_object_info info = {.struct_size = sizeof info};
    dm_object_get_info(session->context, session->object, &info);
    cJSON* out = cJSON_CreateObject();
    cJSON* parts = cJSON_AddArrayToObject(out, "parts");
    for (uint32_t i = 0; i < info.part_count; i++) {
        cJSON* item = part_to_json(session, request, rig, i);
        cJSON_AddItemToArray(parts, item);
        if (as_json) continue;
        dm_joint joint = dm_joint_default();
        const uint32_t id = (uint32_t)cJSON_GetObjectItem(item, "id")->valueint;
        dm_object_get_joint(session->context, session->object, id, &joint);
        printf("part %u '%s': ", id, cJSON_GetStringValue(cJSON_GetObjectItem(item, "name")));
        joint_print(&joint, session->origin);
    }
    cJSON_AddNumberToObject(out, "bytes", (double)bytes);
    session_warnings_to_json(session, out);
    if (!as_json) confidence_print();
    if (as_json)
        json_print_line(out);
    else
        cJSON_Delete(out);
}

static int prepare(session* session, const char* file, const char* out_path, const request* request, bool as_json) {
    rig rig = {.nodes = NULL};
    size_t bytes = 0;
    dm_result result = session_use_file(session, file);
    if (result == DM_OK)
        result =
            request->moving.count > 0 ? prepare_named(session, request) : prepare_whole(session, file, request, &rig);
    if (result == DM_OK) result = save(session, out_path, &bytes);
    if (result == DM_OK)
        report(session, request, &rig, bytes, as_json);
    else
        fprintf(stderr, "dragmesh: %s\n", session->error);
    rig_free(session, &rig);
    return result == DM_OK ? CLI_OK : CLI_FAILED;
}

int prepare_run(const cli_command* command, int argc, char** argv) {
    const char *file = NULL, *out_path = NULL, *models = NULL;
    int as_json = 0, no_hints = 0;
    request request = {.min_moves = RIG_USUAL_MOVES};
    const option_spec table[] = {{.name = "-o", .kind = OPTION_TEXT, .value = &out_path},
                                 {.name = "--moving", .kind = OPTION_NAMES, .value = &request.moving},
                                 {.name = "--min-moves", .kind = OPTION_NUMBER, .value = &request.min_moves},
                                 {.name = "--models", .kind = OPTION_TEXT, .value = &models},
                                 {.name = "--no-hints", .kind = OPTION_FLAG, .value = &no_hints},
                                 {.name = "--json", .kind = OPTION_FLAG, .value = &as_json}};
    session session;
    int status = options_read(command, argc, argv, table, sizeof table / sizeof *table, &file);
    request.no_hints = no_hints;
    if (status == CLI_OK && (file == NULL || out_path == NULL))
        status = options_refuse(command, "a file and -o are needed");
    if (status == CLI_OK && !(request.min_moves >= 0 && request.min_moves <= 1))
        status = options_refuse(command, "--min-moves: 0 to 1");
    if (status == CLI_OK) status = options_check_output(command, "-o", out_path, ".dmo");
    if (status == CLI_OK) status = session_open(&session, models, NULL);
    if (status == CLI_OK) {
        status = prepare(&session, file, out_path, &request, as_json);
        session_close(&session);
    }
    name_list_free(&request.moving);
    return status;
}
