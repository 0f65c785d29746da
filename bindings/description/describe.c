/* describe RESOURCE_FOLDER INCLUDE_FOLDER OUT_FOLDER -- writes the description of the public headers, a C header
 * without directives, and what each binding is generated from them. Prints the names of the files, in OUT_FOLDER. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ffi.h"
#include "header.h"
#include "languages.h"
#include "layout.h"
#include "text.h"

static const char* const headers[] = {"dragmesh/dragmesh.h", "dragmesh/ext/gltf.h", "dragmesh/ext/gltf_rig.h"};
enum { HEADERS = sizeof headers / sizeof *headers, PATH_ROOM = 4096 };

static const char json_name[] = "dragmesh_api.json", ffi_name[] = "dragmesh_ffi.h";

/* What is written from the description, beside it. */
static const struct {
    const char* name;
    char* (*text)(const cJSON* api);
} sources[] = {
    {ffi_name, ffi_write},
    {"cpp/dragmesh_check.hpp", cpp_write},
    {"csharp/DragMesh/Native.cs", csharp_write},
    {"csharp/DragMesh/Layout.cs", csharp_layout_write},
    {"rust/dragmesh-sys/src/generated.rs", rust_write},
    {"python/dragmesh/native.py", python_write},
};

static const char about[] =
    "The C interface of dragmesh. Written by scripts/describe from the public headers: not to be "
    "edited.";

static void write_file(const char* path, const char* text) {
    FILE* file = fopen(path, "wb");
    if (file == NULL || fputs(text, file) < 0 || fclose(file) != 0) text_fail("%s can't be written", path);
}

static cJSON* new_description(void) {
    static const char* const lists[] = {"abis", "constants", "enums", "types", "structs", "functions", "aliases"};
    cJSON* api = cJSON_CreateObject();
    cJSON_AddStringToObject(api, "about", about);
    for (int i = 0; i < 7; i++) cJSON_AddArrayToObject(api, lists[i]);
    return api;
}

/* The function that ends what a handle or pointer of this type stands for. */
static const char* released_by(const cJSON* api, const char* type) {
    static const char* const verbs[] = {"destroy", "unload", "end", "close"};
    const cJSON* function;
    char wanted[128];
    for (int i = 0; i < 4; i++) {
        snprintf(wanted, sizeof wanted, "%s_%s", type, verbs[i]);
        cJSON_ArrayForEach(function, cJSON_GetObjectItem(api, "functions")) {
            const char* name = cJSON_GetObjectItem(function, "name")->valuestring;
            if (strcmp(name, wanted) == 0) return name;
        }
    }
    return NULL;
}

/* States who ends what: "released_by" of types, "creates" of the functions that hand one out. */
static void add_ownership(cJSON* api) {
    cJSON *type, *function, *parameter;
    cJSON_ArrayForEach(type, cJSON_GetObjectItem(api, "types")) {
        const char *name = cJSON_GetObjectItem(type, "name")->valuestring,
                   *kind = cJSON_GetObjectItem(type, "kind")->valuestring;
        if (strcmp(kind, "handle") != 0 && strcmp(kind, "opaque") != 0) continue;
        const char* end = released_by(api, name);
        if (end == NULL) text_fail("no function ends a %s", name);
        cJSON_AddStringToObject(type, "released_by", end);
        cJSON_ArrayForEach(function, cJSON_GetObjectItem(api, "functions"))
            cJSON_ArrayForEach(parameter, cJSON_GetObjectItem(function, "parameters")) {
            const cJSON* to = cJSON_GetObjectItem(cJSON_GetObjectItem(parameter, "type"), "name");
            const bool out = strcmp(cJSON_GetObjectItem(parameter, "direction")->valuestring, "out") == 0;
            if (out && to != NULL && strcmp(to->valuestring, name) == 0)
                cJSON_AddStringToObject(function, "creates", name);
        }
    }
}

static void describe_headers(CXIndex index, const char* folder, const char* unit_path, const char* const* arguments,
                             int argument_count, cJSON* api) {
    const CXTranslationUnit unit = clang_parseTranslationUnit(index, unit_path, arguments, argument_count, NULL, 0,
                                                              CXTranslationUnit_DetailedPreprocessingRecord);
    if (unit == NULL || clang_getNumDiagnostics(unit) > 0) text_fail("the headers in %s do not compile", folder);
    for (int i = 0; i < HEADERS; i++) {
        char path[PATH_ROOM];
        snprintf(path, sizeof path, "%s/%s", folder, headers[i]);
        header_describe(unit, path, headers[i], api);
    }
    clang_disposeTranslationUnit(unit);
    add_ownership(api);
}

/* Ends the program where the structs of the written header have another layout than those of the public ones. */
static void check_ffi(CXIndex index, const char* path, const char* resources, const cJSON* api) {
    const char* const arguments[] = {"-std=c17", "-resource-dir", resources, "-include",
                                     "stdint.h", "-include",      "stddef.h"};
    cJSON *again = cJSON_Duplicate(api, 1), *entry;
    cJSON_ReplaceItemInObject(again, "abis", cJSON_CreateArray());
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(again, "structs")) cJSON_DeleteItemFromObject(entry, "layout");
    layout_describe(index, path, arguments, sizeof arguments / sizeof *arguments, again);
    if (!cJSON_Compare(again, api, 1)) text_fail("%s has other layouts than the public headers", path);
    cJSON_Delete(again);
}

/* Writes a source that includes all headers. */
static void write_unit(const char* path) {
    char text[PATH_ROOM] = "";
    for (int i = 0; i < HEADERS; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "#include \"%s\"\n", headers[i]);
    write_file(path, text);
}

static char* describe_all(CXIndex index, const char* resources, const char* folder, const char* unit_path, cJSON* api) {
    char include[PATH_ROOM];
    snprintf(include, sizeof include, "-I%s", folder);
    const char* const arguments[] = {"-std=c17", "-resource-dir", resources, include};
    write_unit(unit_path);
    describe_headers(index, folder, unit_path, arguments, 4, api);
    layout_describe(index, unit_path, arguments, 4, api);
    remove(unit_path);
    char* json = cJSON_Print(api);
    if (json == NULL) text_fail("no memory");
    return json;
}

int main(int argc, char** argv) {
    if (argc != 4) text_fail("usage: describe RESOURCE_FOLDER INCLUDE_FOLDER OUT_FOLDER");
    const char *resources = argv[1], *folder = argv[2], *out = argv[3];
    char path[PATH_ROOM];
    CXIndex index = clang_createIndex(0, 1);
    cJSON* api = new_description();
    snprintf(path, sizeof path, "%s/unit.c", out);
    char* json = describe_all(index, resources, folder, path, api);
    snprintf(path, sizeof path, "%s/%s", out, json_name);
    write_file(path, json), puts(json_name);
    free(json);
    for (size_t i = 0; i < sizeof sources / sizeof *sources; i++) {
        char* text = sources[i].text(api);
        snprintf(path, sizeof path, "%s/%s", out, sources[i].name);
        write_file(path, text), puts(sources[i].name);
        free(text);
    }
    snprintf(path, sizeof path, "%s/%s", out, ffi_name);
    check_ffi(index, path, resources, api);
    clang_disposeIndex(index);
    cJSON_Delete(api);
    return 0;
}
