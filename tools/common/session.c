/* State of one run of the tool: a context with its weights, and the file and object of the last job. */
#include "session.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "output_file.h"

enum { PATH_SHOWN = 200 }; /* bytes of a path in an error */

/* Adds a copy of a text that is not there yet. */
static void add_warning(warnings* list, const char* text) {
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->texts[i], text) == 0) return;
    char** texts = cli_alloc(((size_t)list->count + 1) * sizeof *texts);
    if (list->count > 0) memcpy(texts, list->texts, (size_t)list->count * sizeof *texts);
    free(list->texts);
    list->texts = texts;
    list->texts[list->count++] = cli_copy_text(text);
}

static void clear_warnings(warnings* list) {
    for (int i = 0; i < list->count; i++) free(list->texts[i]);
    free(list->texts);
    *list = (warnings){NULL, 0};
}

/* Appends the texts to the member `warnings`, an array; makes it where there is a first one. */
static void list_warnings(const warnings* list, cJSON* out) {
    cJSON* array = cJSON_GetObjectItemCaseSensitive(out, "warnings");
    if (array == NULL && list->count > 0) array = cJSON_AddArrayToObject(out, "warnings");
    for (int i = 0; i < list->count; i++) cJSON_AddItemToArray(array, cJSON_CreateString(list->texts[i]));
}

static void set_error(session* session, dm_result code, const char* text) {
    snprintf(session->error, sizeof session->error, "%s: %s", dm_result_string(code), text);
}

/* Keeps a warning for answers as JSON. Objects of one file mostly have the same one: it is printed once in a row. */
static void warn(session* session, const char* text) {
    add_warning(session->opens_file ? &session->file_warnings : &session->object_warnings, text);
    if (session->is_quiet) return;
    if (session->warned != NULL && strcmp(session->warned, text) == 0) return;
    fprintf(stderr, "dragmesh: %s\n", text);
    free(session->warned);
    session->warned = cli_copy_text(text);
}

static void DM_CALL on_message(void* user, int32_t level, dm_result code, const char* text) {
    if (level == DM_LOG_ERROR)
        set_error(user, code, text);
    else if (level == DM_LOG_WARNING)
        warn(user, text);
}

dm_log session_log(session* session) {
    return (dm_log){session, on_message};
}

void session_warnings_to_json(const session* session, cJSON* out) {
    list_warnings(&session->file_warnings, out);
    list_warnings(&session->object_warnings, out);
}

dm_result session_fail(session* session, dm_result code, const char* format, ...) {
    char text[900];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    set_error(session, code, text);
    return code;
}

void session_add_place(session* session, const char* preposition, const char* path) {
    char reason[sizeof session->error], shown[PATH_SHOWN + 1];
    snprintf(shown, sizeof shown, "%s", path);
    if (strstr(session->error, shown) != NULL) return;
    memcpy(reason, session->error, sizeof reason);
    snprintf(session->error, sizeof session->error, "%.800s (%s '%s')", reason, preposition, shown);
}

dm_result session_fail_to_write(session* session, const char* path) {
    snprintf(session->error, sizeof session->error, "can't write '%.800s': %s", path, strerror(errno));
    return SESSION_NOT_WRITTEN;
}

dm_result session_write(session* session, const char* path, const void* data, size_t size) {
    return output_write(path, data, size) == 0 ? DM_OK : session_fail_to_write(session, path);
}

bool session_init(session* session, const dm_allocator* allocator, enum session_method method) {
    memset(session, 0, sizeof *session);
    session->method = method;
    dm_context_desc desc = {.struct_size = sizeof desc, .log = session_log(session)};
    if (allocator != NULL) desc.allocator = *allocator;
    return dm_context_create(&desc, &session->context) == DM_OK;
}

void session_release_object(session* session) {
    if (session->object) dm_object_destroy(session->context, session->object);
    free(session->part_ids);
    session->object = 0;
    session->part_ids = NULL;
    clear_warnings(&session->object_warnings);
}

void session_own_part_ids(session* session, uint8_t* ids, size_t count, int32_t scope, int32_t joint_type) {
    free(session->part_ids);
    session->part_ids = ids;
    session->part_id_count = count;
    session->part_id_scope = scope;
    session->joint_type = joint_type;
}

static void release_file(session* session) {
    session_release_object(session);
    dm_gltf_close(session->gltf);
    free(session->path);
    session->gltf = NULL;
    session->path = NULL;
    clear_warnings(&session->file_warnings);
}

void session_close(session* session) {
    release_file(session);
    dm_context_destroy(session->context);
    free(session->warned);
    session->context = NULL;
    session->warned = NULL;
}

/* Standard input: nothing lies beside it. */
static dm_result open_input(session* session) {
    size_t size;
    char* bytes = file_read("-", &size);
    if (bytes == NULL)
        return session_fail(session, DM_ERROR_NOT_FOUND, "can't read standard input: %s", file_problem());
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = bytes, .size = size, .log = session_log(session)};
    const dm_result result =
        size > 0 ? dm_gltf_open(&desc, &session->gltf) : session_fail(session, DM_ERROR_BAD_DATA, "it is empty");
    free(bytes);
    return result;
}

static dm_result open_path(session* session, const char* path) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .log = session_log(session)};
    return dm_gltf_open_file(path, &desc, &session->gltf);
}

uint32_t session_prepare_flags(const session* session) {
    return (session->method == METHOD_KPP ? DM_PREPARE_NETWORK_ALONE : 0u) |
           (dm_gltf_left_out(session->gltf) ? DM_PREPARE_MESH_INCOMPLETE : 0u);
}

dm_vec3 session_point(const session* session, const double point[3]) {
    return (dm_vec3){(float)(point[0] - session->origin[0]), (float)(point[1] - session->origin[1]),
                     (float)(point[2] - session->origin[2])};
}

dm_result session_use_file(session* session, const char* path) {
    if (session->path != NULL && strcmp(session->path, path) == 0) return DM_OK;
    release_file(session);
    session->opens_file = true;
    const dm_result result = strcmp(path, "-") == 0 ? open_input(session) : open_path(session, path);
    session->opens_file = false;
    if (result != DM_OK) {
        session_add_place(session, "in", path);
        return result;
    }
    dm_gltf_get_origin(session->gltf, session->origin);
    dm_gltf_get_mesh(session->gltf, &session->mesh);
    session->path = cli_copy_text(path);
    return DM_OK;
}

uint8_t* session_moving_faces(const session* session) {
    const uint64_t faces = session->mesh.index_count / 3;
    const uint32_t* indices = session->mesh.indices;
    uint8_t* moving = cli_alloc(faces);
    for (uint64_t face = 0; face < faces; face++) {
        const uint32_t* corner = indices + 3 * face;
        const uint8_t* ids = session->part_ids;
        /* Per vertex, a triangle belongs to the id that two of its corners share. */
        moving[face] =
            session->part_id_scope == DM_PER_FACE ? ids[face] : ids[corner[0]] + ids[corner[1]] + ids[corner[2]] >= 2;
    }
    return moving;
}
