/* Folders of object.glb + joints.json: objects whose joints are known. */
#include "dataset.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "platform.h"

static int by_name(const void* a, const void* b) {
    return strcmp(*(char* const*)a, *(char* const*)b);
}

typedef struct listing {
    const char *folder, *file;
    name_list names;
} listing;

static void add_object(void* user, const char* name) {
    listing* found = user;
    char *object = path_join(found->folder, name), *path = path_join(object, found->file);
    if (name[0] != '.' && platform_exists(path)) name_list_add(&found->names, name, strlen(name));
    free(path);
    free(object);
}

name_list dataset_list(const char* folder, const char* file) {
    listing found = {folder, file, {NULL, 0}};
    platform_list(folder, add_object, &found);
    if (found.names.count) qsort(found.names.names, found.names.count, sizeof *found.names.names, by_name);
    return found.names;
}

static char* copy_text(const cJSON* json, const char* name, const char* otherwise) {
    const cJSON* found = cJSON_GetObjectItemCaseSensitive(json, name);
    const char* text = cJSON_IsString(found) ? found->valuestring : otherwise;
    return cli_copy_text(text);
}

static double number_or(const cJSON* json, const char* name, double otherwise) {
    const cJSON* found = cJSON_GetObjectItemCaseSensitive(json, name);
    return cJSON_IsNumber(found) ? found->valuedouble : otherwise;
}

static vec read_vec(const cJSON* json, const char* name) {
    const cJSON* list = cJSON_GetObjectItemCaseSensitive(json, name);
    double numbers[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        const cJSON* item = cJSON_GetArrayItem(list, i);
        if (cJSON_IsNumber(item)) numbers[i] = item->valuedouble;
    }
    return (vec){numbers[0], numbers[1], numbers[2]};
}

static void append_name(char* label, size_t size, const cJSON* name) {
    const size_t length = strlen(label);
    if (cJSON_IsString(name)) snprintf(label + length, size - length, "%s%s", length > 0 ? "/" : "", name->valuestring);
}

/* Joins the names of file, parents (listed nearest first) and node. */
static char* read_label(const cJSON* json) {
    const cJSON* names = cJSON_GetObjectItemCaseSensitive(json, "label");
    const cJSON* parents = cJSON_GetObjectItemCaseSensitive(names, "parents");
    char* label = cli_alloc_zeroed(DM_MAX_LABEL + 1);
    append_name(label, DM_MAX_LABEL + 1, cJSON_GetObjectItemCaseSensitive(names, "file"));
    for (int i = cJSON_GetArraySize(parents); i-- > 0;)
        append_name(label, DM_MAX_LABEL + 1, cJSON_GetArrayItem(parents, i));
    append_name(label, DM_MAX_LABEL + 1, cJSON_GetObjectItemCaseSensitive(names, "node"));
    return label;
}

static void read_pivot(const cJSON* json, known_joint* out) {
    const cJSON* axes = cJSON_GetObjectItemCaseSensitive(json, "pivot_axes");
    out->has_pivot = cJSON_IsArray(cJSON_GetObjectItemCaseSensitive(json, "pivot"));
    out->pivot = read_vec(json, "pivot");
    for (int i = 0; i < 3 && cJSON_GetArraySize(axes) == 9; i++) {
        double row[3];
        for (int k = 0; k < 3; k++) row[k] = cJSON_GetNumberValue(cJSON_GetArrayItem(axes, 3 * i + k));
        out->pivot_axes[i] = (vec){row[0], row[1], row[2]};
    }
}

static void read_joint(const cJSON* json, known_joint* out) {
    const cJSON* item;
    char* type = copy_text(json, "type", "revolute");
    *out = (known_joint){.name = copy_text(json, "name", ""),
                         .slides = strcmp(type, "prismatic") == 0,
                         .axis = unit(read_vec(json, "axis")),
                         .origin = read_vec(json, "origin"),
                         .lower = number_or(json, "lower", NAN),
                         .upper = number_or(json, "upper", NAN),
                         .weight = number_or(json, "weight", 1),
                         .label = read_label(json)};
    read_pivot(json, out);
    free(type);
    cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(json, "moving_nodes")) {
        if (cJSON_IsString(item)) name_list_add(&out->moving, item->valuestring, strlen(item->valuestring));
    }
    cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(json, "drags")) {
        if (out->drag_count < DATASET_DRAGS)
            out->drags[out->drag_count++] = (known_drag){read_vec(item, "point"), read_vec(item, "vector")};
    }
}

int dataset_read(const char* folder, const char* name, known_object* out_object, char* error, size_t error_size) {
    char* object = path_join(folder, name);
    char* path = path_join(object, "joints.json");
    size_t size;
    char* text = file_read(path, &size);
    cJSON* json = text != NULL ? cJSON_Parse(text) : NULL;
    const cJSON* joints = cJSON_GetObjectItemCaseSensitive(json, "joints");
    const int count = cJSON_GetArraySize(joints);
    if (count > 0) {
        *out_object = (known_object){.name = cli_copy_text(name),
                                     .glb = path_join(object, "object.glb"),
                                     .category = copy_text(json, "category", "?"),
                                     .joints = cli_alloc((size_t)count * sizeof(known_joint)),
                                     .joint_count = count};
        int at = 0;
        const cJSON* item;
        char* up = copy_text(json, "up", "y");
        out_object->up = up[0] >= 'x' && up[0] <= 'z' ? up[0] : 'y';
        out_object->up_direction = (vec){out_object->up == 'x', out_object->up == 'y', out_object->up == 'z'};
        free(up);
        cJSON_ArrayForEach(item, joints) read_joint(item, &out_object->joints[at++]);
    } else {
        snprintf(error, error_size, "'%s' %s", path, text != NULL ? "lists no joints" : file_problem());
    }
    cJSON_Delete(json);
    free(text);
    free(path);
    free(object);
    return count > 0 ? 0 : -1;
}

void dataset_enter_frame(known_object* object, const double origin[3]) {
    const vec from = {origin[0], origin[1], origin[2]};
    for (int i = 0; i < object->joint_count; i++) {
        known_joint* joint = &object->joints[i];
        joint->origin = sub(joint->origin, from);
        joint->pivot = sub(joint->pivot, from);
        for (int k = 0; k < joint->drag_count; k++) joint->drags[k].point = sub(joint->drags[k].point, from);
    }
}

void dataset_free(known_object* object) {
    for (int i = 0; i < object->joint_count; i++) {
        name_list_free(&object->joints[i].moving);
        free(object->joints[i].name);
        free(object->joints[i].label);
    }
    free(object->joints);
    free(object->name);
    free(object->glb);
    free(object->category);
}

const char* dataset_source(const char* name) {
    static const char* const partnet[] = {"gensim2", "robotwin", "sapien", "gapartnet", "dexteroushands",
                                          "genesis", "rpad",     "r_pad",  "partnet"};
    if (strncmp(name, "flightgear__", strlen("flightgear__")) == 0) return "flightgear";
    if (strncmp(name, "webxr", strlen("webxr")) == 0) return "webxr";
    for (size_t i = 0; i < sizeof partnet / sizeof *partnet; i++)
        if (strncmp(name, partnet[i], strlen(partnet[i])) == 0) return "partnet";
    return "simulation";
}
