#include "ffi.h"

#include <string.h>

#include "writer.h"

static const double most_int = 2147483647.0; /* a larger constant is no enumerator */

static void put_parameters(writer* w, const cJSON* parameters);

/* Writes a declaration: the type, the name, and what stands behind the name. */
static void put_declaration(writer* w, const cJSON* type, const char* name) {
    const cJSON *callback = cJSON_GetObjectItem(type, "callback"), *count = cJSON_GetObjectItem(type, "count");
    if (callback != NULL) {
        put_declaration(w, cJSON_GetObjectItem(callback, "returns"), "");
        put(w, " (*%s)(", name);
        put_parameters(w, cJSON_GetObjectItem(callback, "parameters"));
        put(w, ")");
        return;
    }
    const cJSON* pointers = cJSON_GetObjectItem(type, "pointers");
    const int stars = pointers != NULL ? pointers->valueint : 0;
    put(w, "%s%s%.*s%s%s", cJSON_HasObjectItem(type, "const") ? "const " : "", string_of(type, "name"), stars, "****",
        name[0] ? " " : "", name);
    if (count != NULL) put(w, "[%d]", count->valueint);
}

static void put_parameters(writer* w, const cJSON* parameters) {
    const cJSON* parameter;
    if (cJSON_GetArraySize(parameters) == 0) put(w, "void");
    cJSON_ArrayForEach(parameter, parameters) {
        if (parameter->prev->next != NULL) put(w, ", ");
        const char* name = string_of(parameter, "name");
        put_declaration(w, cJSON_GetObjectItem(parameter, "type"), name != NULL ? name : "");
    }
}

static void put_constants(writer* w, const cJSON* api) {
    const cJSON *entry, *constant;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "constants")) {
        const double value = cJSON_GetObjectItem(entry, "value")->valuedouble;
        put(w, value <= most_int ? "enum { %s = %.0f };\n" : "static const uint32_t %s = %.0f;\n",
            string_of(entry, "name"), value);
    }
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "enums")) {
        put(w, "enum {");
        cJSON_ArrayForEach(constant, cJSON_GetObjectItem(entry, "constants")) {
            put(w, "%s\n    %s = %.0f", constant->prev->next != NULL ? "," : "", string_of(constant, "name"),
                cJSON_GetObjectItem(constant, "value")->valuedouble);
        }
        put(w, "\n};\n");
    }
}

static void put_types(writer* w, const cJSON* api) {
    const cJSON* entry;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs"))
        put(w, "typedef struct %s %s;\n", string_of(entry, "name"), string_of(entry, "name"));
    for (int callbacks = 0; callbacks < 2; callbacks++) /* last, because they name the others */
        cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "types")) {
            const char *name = string_of(entry, "name"), *kind = string_of(entry, "kind");
            const cJSON* signature = cJSON_GetObjectItem(entry, "signature");
            if (callbacks != (signature != NULL)) continue;
            if (signature != NULL) {
                put(w, "typedef ");
                put_declaration(w, cJSON_GetObjectItem(signature, "returns"), "");
                put(w, " (*%s)(", name);
                put_parameters(w, cJSON_GetObjectItem(signature, "parameters"));
                put(w, ");\n");
            } else if (strcmp(kind, "opaque") == 0) {
                put(w, "typedef struct %s %s;\n", name, name);
            } else {
                put(w, "typedef %s %s;\n", string_of(entry, "integer"), name);
            }
        }
}

static void put_structs(writer* w, const cJSON* api) {
    const cJSON *entry, *field;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) {
        put(w, "struct %s {\n", string_of(entry, "name"));
        cJSON_ArrayForEach(field, cJSON_GetObjectItem(entry, "fields")) {
            put(w, "    ");
            put_declaration(w, cJSON_GetObjectItem(field, "type"), string_of(field, "name"));
            put(w, ";\n");
        }
        put(w, "};\n");
    }
}

/* Writes a declaration of the function under its other name; the label is what is linked. */
static void put_alias(writer* w, const cJSON* api, const cJSON* alias) {
    const cJSON* function = function_of(api, alias);
    put_declaration(w, cJSON_GetObjectItem(function, "returns"), string_of(alias, "name"));
    put(w, "(");
    put_parameters(w, cJSON_GetObjectItem(function, "parameters"));
    put(w, ") __asm__(\"%s\");\n", string_of(function, "name"));
}

char* ffi_write(const cJSON* api) {
    writer w = {0};
    const cJSON* entry;
    put(&w, "/* %s */\n", string_of(api, "about"));
    put_constants(&w, api);
    put_types(&w, api);
    put_structs(&w, api);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "functions")) {
        put_declaration(&w, cJSON_GetObjectItem(entry, "returns"), string_of(entry, "name"));
        put(&w, "(");
        put_parameters(&w, cJSON_GetObjectItem(entry, "parameters"));
        put(&w, ");\n");
    }
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "aliases")) put_alias(&w, api, entry);
    return w.text;
}
