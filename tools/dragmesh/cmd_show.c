/* dragmesh show: what a prepared object holds. */
#include <stdio.h>
#include <stdlib.h>

#include "answer.h"
#include "file_report.h"
#include "files.h"
#include "json.h"
#include "runs.h"
#include "shown.h"

/* What is printed of a part. */
typedef struct part_entry {
    dm_part_info info;
    dm_joint joint, hypotheses[DM_MAX_HYPOTHESES];
    uint32_t hypothesis_count;
} part_entry;

static const double no_origin[3]; /* a prepared object is in its own frame */

static dm_result load(session* session, const char* path, size_t* out_size) {
    char* bytes = file_read(path, out_size);
    if (bytes == NULL)
        return session_fail(session, DM_ERROR_NOT_FOUND, "can't read '%.200s': %s", path, file_problem());
    const dm_result result = dm_object_load(session->context, bytes, *out_size, 0, &session->object);
    free(bytes);
    if (result != DM_OK) session_add_place(session, "in", path);
    return result;
}

static dm_result read_part(session* session, uint32_t index, part_entry* out) {
    *out = (part_entry){.info = dm_part_info_default(), .joint = dm_joint_default()};
    out->hypotheses[0] = dm_joint_default();
    dm_result result = dm_object_get_part(session->context, session->object, index, &out->info);
    if (result == DM_OK) result = dm_object_get_joint(session->context, session->object, out->info.id, &out->joint);
    if (result == DM_OK)
        result = dm_object_get_hypotheses(session->context, session->object, out->info.id, NULL, out->hypotheses,
                                          DM_MAX_HYPOTHESES, &out->hypothesis_count);
    return result;
}

static void print_part(const part_entry* part) {
    const dm_vec3* low = &part->info.box_min;
    const dm_vec3* high = &part->info.box_max;
    printf("part %u", (unsigned)part->info.id);
    if (part->info.parent != 0) printf(", on part %u", (unsigned)part->info.parent);
    printf(": %u triangles, size %.4f x %.4f x %.4f\n   ", (unsigned)part->info.triangle_count,
           shown((double)(high->x - low->x), 4), shown((double)(high->y - low->y), 4),
           shown((double)(high->z - low->z), 4));
    joint_print(&part->joint, no_origin);
    for (uint32_t i = 1; i < part->hypothesis_count; i++) {
        printf("or ");
        joint_print(&part->hypotheses[i], no_origin);
    }
}

static cJSON* part_to_json(const part_entry* part) {
    cJSON* out = cJSON_CreateObject();
    cJSON_AddNumberToObject(out, "id", part->info.id);
    cJSON_AddNumberToObject(out, "parent", part->info.parent);
    cJSON_AddNumberToObject(out, "triangles", part->info.triangle_count);
    json_add_vector(out, "box_min", part->info.box_min);
    json_add_vector(out, "box_max", part->info.box_max);
    json_add_vector(out, "centre", part->info.centre);
    joint_to_json(&part->joint, no_origin, out);
    cJSON* list = cJSON_AddArrayToObject(out, "hypotheses");
    for (uint32_t i = 0; i < part->hypothesis_count; i++) {
        cJSON* hypothesis = cJSON_CreateObject();
        joint_to_json(&part->hypotheses[i], no_origin, hypothesis);
        cJSON_AddItemToArray(list, hypothesis);
    }
    return out;
}

static cJSON* object_to_json(const dm_object_info* info, size_t bytes) {
    cJSON* out = cJSON_CreateObject();
    cJSON_AddNumberToObject(out, "bytes", (double)bytes);
    cJSON_AddNumberToObject(out, "vertices", (double)info->vertex_count);
    cJSON_AddNumberToObject(out, "triangles", (double)info->triangle_count);
    json_add_vector(out, "box_min", info->box_min);
    json_add_vector(out, "box_max", info->box_max);
    json_add_number(out, "size", (double)info->size, 9);
    cJSON_AddBoolToObject(out, "pickable", info->pickable != 0);
    return out;
}

static void print_object(const dm_object_info* info, size_t bytes) {
    printf("%zu bytes: %u parts, %llu triangles of %llu vertices, largest side %.4f, %s\n", bytes,
           (unsigned)info->part_count, (unsigned long long)info->triangle_count, (unsigned long long)info->vertex_count,
           (double)info->size, info->pickable ? "rays can hit it" : "without triangles for rays");
}

static dm_result print_file(session* session, const char* path, int as_json) {
    size_t bytes = 0;
    dm_object_info info = dm_object_info_default();
    dm_result result = load(session, path, &bytes);
    if (result == DM_OK) result = dm_object_get_info(session->context, session->object, &info);
    if (result != DM_OK) return result;
    cJSON* out = object_to_json(&info, bytes);
    cJSON* parts = cJSON_AddArrayToObject(out, "parts");
    if (!as_json) print_object(&info, bytes);
    for (uint32_t i = 0; i < info.part_count && result == DM_OK; i++) {
        part_entry part;
        result = read_part(session, i, &part);
        if (result == DM_OK && !as_json) print_part(&part);
        if (result == DM_OK) cJSON_AddItemToArray(parts, part_to_json(&part));
    }
    if (result == DM_OK && !as_json) confidence_print();
    if (result == DM_OK && as_json)
        json_print_line(out);
    else
        cJSON_Delete(out);
    return result;
}

int show_run(const cli_command* command, int argc, char** argv) {
    return file_report_run(command, argc, argv, print_file);
}
