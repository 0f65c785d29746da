/* The answer about an asset as JSON. */
#include <stdio.h>

#include "answer.h"
#include "joint_type.h"
#include "json.h"
#include "rig_output.h"

const char* rig_options_text(const rig_options* options, char* out, size_t size) {
    const uint32_t version = dm_version();
    char formats[RIG_FORMATS_TEXT];
    rig_format_names(options->formats, formats, sizeof formats);
    snprintf(out, size, "version %u, names %s, clips %s, min-moves %.4g, formats %s, up %c", version,
             options->without_names ? "off" : "on", options->without_clips ? "off" : "on", options->min_moves, formats,
             options->up ? options->up : 'y');
    return out;
}

void rig_nodes_to_json(const session* session, const rig* rig, uint32_t index, cJSON* out) {
    const rig_part* part = &rig->parts[index];
    cJSON *names = cJSON_AddArrayToObject(out, "nodes"), *numbers = cJSON_AddArrayToObject(out, "node_indices");
    for (uint32_t i = 0; i < part->part.node_count; i++) {
        uint32_t number = 0;
        const char* name = rig->nodes[part->nodes[i]].name;
        dm_gltf_get_asset_node(session->gltf, part->nodes[i], &number);
        cJSON_AddItemToArray(names, cJSON_CreateString(name != NULL ? name : ""));
        cJSON_AddItemToArray(numbers, cJSON_CreateNumber(number));
    }
}

/* The joint as those who know turns and slides alone read it. What they lack is in `dragmesh_joint`. */
static void plain_joint_to_json(const session* session, const dm_joint* joint, cJSON* out) {
    const bool is_plain = joint->type != DM_JOINT_SCREW && joint->type != DM_JOINT_CONTINUOUS;
    joint_to_json(joint, session->origin, out);
    if (is_plain) return;
    cJSON_SetValuestring(cJSON_GetObjectItemCaseSensitive(out, "type"), joint_type_name(DM_JOINT_REVOLUTE));
    cJSON_DeleteItemFromObjectCaseSensitive(out, "pitch");
    joint_to_json(joint, session->origin, cJSON_AddObjectToObject(out, "dragmesh_joint"));
}

static cJSON* part_to_json(const session* session, const rig* rig, uint32_t index) {
    static const char* const states[] = {
        [DM_ASSET_STAYS] = "stays", [DM_ASSET_MOVES] = "moves", [DM_ASSET_FREE] = "free"};
    static const char* const bases[] = {
        [DM_ASSET_INFERRED] = "inferred", [DM_ASSET_FROM_FILE] = "file", [DM_ASSET_FROM_CLIP] = "clip"};
    const rig_part* part = &rig->parts[index];
    cJSON* out = cJSON_CreateObject();
    rig_nodes_to_json(session, rig, index, out);
    cJSON_AddNumberToObject(out, "parent", part->part.parent == DM_ASSET_NO_PART ? -1 : (double)part->part.parent);
    cJSON_AddStringToObject(out, "state", states[part->part.state]);
    json_add_number(out, "moves", (double)part->part.moves, 4);
    cJSON_AddStringToObject(out, "basis", bases[part->part.basis]);
    plain_joint_to_json(session, &part->joint, out);
    if (part->part.duration > 0) json_add_number(out, "duration", (double)part->part.duration, 9);
    cJSON_AddNumberToObject(out, "triangle_count", part->part.triangle_count);
    return out;
}

cJSON* rig_to_json(const session* session, const rig* rig, const rig_options* options) {
    char text[RIG_OPTIONS_TEXT];
    cJSON* out = cJSON_CreateObject();
    cJSON_AddStringToObject(out, "options", rig_options_text(options, text, sizeof text));
    cJSON* parts = cJSON_AddArrayToObject(out, "parts");
    for (uint32_t i = 0; i < rig->info.part_count; i++) cJSON_AddItemToArray(parts, part_to_json(session, rig, i));
    session_warnings_to_json(session, out);
    return out;
}
