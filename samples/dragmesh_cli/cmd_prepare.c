/* dragmesh prepare: a file's parts, their joints found, as a .dmo that a game loads without the network. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "job.h"
#include "json.h"
#include "nodes.h"
#include "session_open.h"

/* Part ids of a face: the named nodes are part 1; without names every node is a part but the largest. */
static dm_result select_parts(session* session, const name_list* moving, uint16_t** out_ids) {
    const uint64_t faces = session->mesh.index_count / 3;
    *out_ids = NULL;
    if (moving->count == 0) {
        if (dm_gltf_node_count(session->gltf) > DM_MAX_PARTS)
            return session_fail(session, DM_ERROR_TOO_LARGE, "%u nodes, %d parts are the most; name some with --moving",
                                dm_gltf_node_count(session->gltf), DM_MAX_PARTS);
        *out_ids = node_part_ids(session, largest_node(session));
        return DM_OK;
    }
    uint8_t* marked = cli_alloc_zeroed(faces);
    const dm_result result =
        dm_gltf_mark_faces(session->gltf, (const char* const*)moving->names, moving->count, 1, marked, faces);
    *out_ids = cli_alloc(faces * sizeof **out_ids);
    for (uint64_t face = 0; face < faces; face++) (*out_ids)[face] = marked[face];
    free(marked);
    return result;
}

/* What the file says of each part's node; the descriptors point to it. To be freed. */
static part_hints* add_hints(const session* session, const name_list* moving, dm_part_desc* parts, uint32_t count) {
    part_hints* hints = cli_alloc_zeroed(count * sizeof *hints);
    for (uint32_t i = 0; i < count; i++) {
        char number[32];
        dm_gltf_node node = {.name = ""};
        dm_gltf_get_node(session->gltf, parts[i].id - 1, &node);
        snprintf(number, sizeof number, "#%u", node.node);
        part_hints_of_node(session->gltf, session->path, moving->count > 0 ? moving->names[0] : number, &hints[i]);
        part_hints_enter(&hints[i], &parts[i]);
    }
    return hints;
}

/* A named node takes what it carries along as one part; without names, each node knows what carries it. */
static dm_part_desc* list_parts(const session* session, const name_list* moving, uint32_t* out_count) {
    if (moving->count == 0) return node_parts(session, largest_node(session), out_count);
    dm_part_desc* part = cli_alloc_zeroed(sizeof *part);
    *part = (dm_part_desc){.struct_size = sizeof *part, .id = 1};
    *out_count = 1;
    return part;
}

static dm_result prepare(session* session, const name_list* moving, int no_hints) {
    uint16_t* ids;
    uint32_t count = 0;
    dm_result result = select_parts(session, moving, &ids);
    if (result == DM_OK) {
        dm_part_desc* parts = list_parts(session, moving, &count);
        part_hints* hints = no_hints ? NULL : add_hints(session, moving, parts, count);
        dm_mesh_desc mesh = session->mesh;
        mesh.part_ids = ids;
        mesh.part_id_bytes = mesh.index_count / 3 * sizeof *ids;
        mesh.part_id_format = DM_UINT16;
        mesh.part_id_scope = DM_PER_FACE;
        const dm_object_desc desc = {.struct_size = sizeof desc,
                                     .flags = session_prepare_flags(session),
                                     .mesh = &mesh,
                                     .parts = count > 0 ? parts : NULL,
                                     .part_count = count,
                                     .model = session->model};
        result = dm_object_prepare(session->context, &desc, &session->object);
        free(hints);
        free(parts);
    }
    free(ids);
    return result;
}

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

static void part_name(const session* session, const name_list* moving, uint32_t id, char* out, size_t size) {
    dm_gltf_node node = {0};
    if (moving->count > 0)
        snprintf(out, size, "%s%s", moving->names[0], moving->count > 1 ? " …" : "");
    else if (dm_gltf_get_node(session->gltf, id - 1, &node) == DM_OK)
        snprintf(out, size, "%s", node.name);
    dm_gltf_mend_text(out);
}

static void report(session* session, const name_list* moving, size_t bytes, int as_json) {
    dm_object_info info = {.struct_size = sizeof info};
    dm_object_get_info(session->context, session->object, &info);
    cJSON* out = cJSON_CreateObject();
    cJSON* parts = cJSON_AddArrayToObject(out, "parts");
    for (uint32_t i = 0; i < info.part_count; i++) {
        dm_part_info part = {.struct_size = sizeof part};
        joint_answer found = {0};
        char name[256] = "";
        dm_object_get_part(session->context, session->object, i, &part);
        found.joint = dm_joint_default();
        dm_object_get_joint(session->context, session->object, part.id, &found.joint);
        part_name(session, moving, part.id, name, sizeof name);
        cJSON* item = cJSON_CreateObject();
        cJSON_AddNumberToObject(item, "id", part.id);
        cJSON_AddNumberToObject(item, "parent", part.parent);
        cJSON_AddStringToObject(item, "name", name);
        joint_to_json(&found.joint, session->origin, item);
        cJSON_AddItemToArray(parts, item);
        if (!as_json) printf("part %u '%s': ", part.id, name);
        if (!as_json) joint_print(&found.joint, session->origin);
    }
    cJSON_AddNumberToObject(out, "bytes", (double)bytes);
    session_warnings_to_json(session, out);
    if (!as_json) confidence_print();
    if (as_json)
        json_print_line(out);
    else
        cJSON_Delete(out);
}

static int run(int argc, char** argv) {
    const char *file = NULL, *out_path = NULL, *models = NULL;
    int as_json = 0, no_hints = 0;
    name_list moving = {NULL, 0};
    const option_spec table[] = {{.name = "-o", .kind = OPTION_TEXT, .value = &out_path},
                                 {.name = "--moving", .kind = OPTION_NAMES, .value = &moving},
                                 {.name = "--models", .kind = OPTION_TEXT, .value = &models},
                                 {.name = "--no-hints", .kind = OPTION_FLAG, .value = &no_hints},
                                 {.name = "--json", .kind = OPTION_FLAG, .value = &as_json}};
    session session;
    int status = options_read(&cli_prepare, argc, argv, table, sizeof table / sizeof *table, &file);
    if (status == CLI_OK && (file == NULL || out_path == NULL))
        status = options_refuse(&cli_prepare, "a file and -o are needed");
    if (status == CLI_OK) status = options_check_output(&cli_prepare, "-o", out_path, ".dmo");
    if (status == CLI_OK) status = session_open(&session, models, NULL);
    if (status == CLI_OK) {
        size_t bytes = 0;
        dm_result result = session_use_file(&session, file);
        if (result == DM_OK) result = prepare(&session, &moving, no_hints);
        if (result == DM_OK) result = save(&session, out_path, &bytes);
        if (result == DM_OK)
            report(&session, &moving, bytes, as_json);
        else
            fprintf(stderr, "dragmesh: %s\n", session.error);
        status = result == DM_OK ? CLI_OK : CLI_FAILED;
        session_close(&session);
    }
    name_list_free(&moving);
    return status;
}

const cli_command cli_prepare = {
    "prepare", run, "FILE.glb -o OUT.dmo [--moving NODE[,NODE…]] [--no-hints] [--json]",
    "Finds the joints and writes them for a game to load. Without --moving every node is a part but the largest."};
