#include <string.h>

#include "languages.h"
#include "writer.h"

static const char* const plain_types[] = {"int8_t",   "c.c_int8",   "uint8_t",  "c.c_uint8",  "int16_t",  "c.c_int16",
                                          "uint16_t", "c.c_uint16", "int32_t",  "c.c_int32",  "uint32_t", "c.c_uint32",
                                          "int64_t",  "c.c_int64",  "uint64_t", "c.c_uint64", "size_t",   "c.c_size_t",
                                          "float",    "c.c_float",  "double",   "c.c_double", NULL};
static const char* const python_types[] = {"int8_t",  "int", "uint8_t",  "int",   "int16_t", "int",   "uint16_t", "int",
                                           "int32_t", "int", "uint32_t", "int",   "int64_t", "int",   "uint64_t", "int",
                                           "size_t",  "int", "float",    "float", "double",  "float", NULL};
static const char* const keywords[] = {"from", "from_", NULL};

static void put_text(writer* w, const char* text) {
    for (; *text != '\0'; text++) put(w, strchr("\\\"", *text) != NULL ? "\\%c" : "%c", *text);
}

static void put_signature(writer* w, const cJSON* api, const cJSON* signature);

static void put_type(writer* w, const cJSON* api, const cJSON* type) {
    const cJSON* callback = callback_of(api, type);
    if (callback != NULL) {
        put(w, "c.CFUNCTYPE(");
        put_signature(w, api, callback);
        put(w, ")");
        return;
    }
    const char* name = string_of(type, "name");
    const cJSON* declared = type_of(api, name);
    int stars = number_of(type, "pointers");
    const bool is_text = strcmp(name, "char") == 0, is_void = strcmp(name, "void") == 0;
    if (stars > 0 && (is_text || is_void || is_opaque(api, name))) stars--;
    for (int i = 0; i < stars; i++) put(w, "c.POINTER(");
    if (is_text)
        put(w, "c.c_char_p"); /* takes a buffer to write into, too */
    else if (is_void)
        put(w, number_of(type, "pointers") > 0 ? "c.c_void_p" : "None");
    else if (is_opaque(api, name))
        put(w, "c.c_void_p");
    else if (declared != NULL)
        put(w, "%s", replaced(plain_types, string_of(declared, "integer")));
    else if (replaced(plain_types, name) != NULL)
        put(w, "%s", replaced(plain_types, name));
    else
        put_pascal(w, name);
    for (int i = 0; i < stars; i++) put(w, ")");
    if (number_of(type, "count") > 0) put(w, " * %d", number_of(type, "count"));
}

static void put_types(writer* w, const cJSON* api, const cJSON* parameters) {
    const cJSON* parameter;
    cJSON_ArrayForEach(parameter, parameters) {
        const cJSON* type = cJSON_GetObjectItem(parameter, "type");
        if (parameter != parameters->child) put(w, ", ");
        if (number_of(type, "count") > 0)
            put(w, "c.c_void_p");
        else
            put_type(w, api, type);
    }
}

static void put_signature(writer* w, const cJSON* api, const cJSON* signature) {
    const cJSON* parameters = cJSON_GetObjectItem(signature, "parameters");
    put_type(w, api, cJSON_GetObjectItem(signature, "returns"));
    if (cJSON_GetArraySize(parameters) > 0) put(w, ", ");
    put_types(w, api, parameters);
}

static void put_constant(writer* w, const cJSON* constant) {
    put(w, "%s = %.0f\n", string_of(constant, "name"), cJSON_GetObjectItem(constant, "value")->valuedouble);
}

/* Writes what a field reads as, for type checkers. */
static void put_annotation(writer* w, const cJSON* api, const cJSON* field) {
    const cJSON* type = cJSON_GetObjectItem(field, "type");
    const char *name = string_of(field, "name"), *other = replaced(keywords, name);
    put(w, "    %s: ", other != NULL ? other : name);
    if (is_callback(api, type) || number_of(type, "pointers") > 0 || number_of(type, "count") > 0) {
        put(w, "Any\n");
        return;
    }
    const bool declared = type_of(api, string_of(type, "name")) != NULL;
    const char* plain = declared ? "int" : replaced(python_types, string_of(type, "name"));
    if (plain != NULL)
        put(w, "%s", plain);
    else
        put_pascal(w, string_of(type, "name"));
    put(w, "\n");
}

static void put_struct(writer* w, const cJSON* api, const cJSON* structure) {
    const cJSON *fields = cJSON_GetObjectItem(structure, "fields"), *field;
    put(w, "\n\nclass ");
    put_pascal(w, string_of(structure, "name"));
    put(w, "(%s):\n", is_sized(structure) ? "Sized" : "Struct");
    if (string_of(structure, "doc") != NULL) {
        put(w, "    \"\"\"");
        put_text(w, string_of(structure, "doc"));
        put(w, "\"\"\"\n\n");
    }
    cJSON_ArrayForEach(field, fields) put_annotation(w, api, field);
    put(w, "    _fields_ = [\n");
    cJSON_ArrayForEach(field, fields) {
        const char *name = string_of(field, "name"), *other = replaced(keywords, name);
        put(w, "        (\"%s\", ", other != NULL ? other : name);
        put_type(w, api, cJSON_GetObjectItem(field, "type"));
        put(w, "),\n");
    }
    put(w, "    ]\n");
}

static void put_functions(writer* w, const cJSON* api, const char* table, bool gltf) {
    const cJSON* function;
    put(w, "\n%s = {  # name: (result, arguments)\n", table);
    cJSON_ArrayForEach(function, cJSON_GetObjectItem(api, "functions")) {
        if ((strstr(string_of(function, "header"), "gltf") != NULL) != gltf) continue;
        put(w, "    \"%s\": (", string_of(function, "name"));
        put_type(w, api, cJSON_GetObjectItem(function, "returns"));
        put(w, ", [");
        put_types(w, api, cJSON_GetObjectItem(function, "parameters"));
        put(w, "]),\n");
    }
    put(w, "}\n");
}

/* Writes {another name: function}. */
static void put_aliases(writer* w, const cJSON* api) {
    const cJSON* alias;
    put(w, "\nALIASES = {  # another name of a function\n");
    cJSON_ArrayForEach(alias, cJSON_GetObjectItem(api, "aliases"))
        put(w, "    \"%s\": \"%s\",\n", string_of(alias, "name"), string_of(alias, "function"));
    put(w, "}\n");
}

/* Writes {struct: {pointer size: (size, offsets)}}. */
static void put_layouts(writer* w, const cJSON* api) {
    static const struct {
        const char* name;
        int pointer;
    } abis[] = {{"64-bit", 8}, {"32-bit", 4}};
    const cJSON *entry, *offset;
    put(w, "\nLAYOUTS = {  # struct: {bytes of a pointer: (size, offsets)}\n");
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) {
        put(w, "    ");
        put_pascal(w, string_of(entry, "name"));
        put(w, ": {");
        for (int i = 0; i < 2; i++) {
            const cJSON* layout = cJSON_GetObjectItem(cJSON_GetObjectItem(entry, "layout"), abis[i].name);
            put(w, "%s%d: (%d, [", i > 0 ? ", " : "", abis[i].pointer, number_of(layout, "size"));
            cJSON_ArrayForEach(offset, cJSON_GetObjectItem(layout, "offsets"))
                put(w, "%s%d", offset == cJSON_GetObjectItem(layout, "offsets")->child ? "" : ", ", offset->valueint);
            put(w, "])");
        }
        put(w, "},\n");
    }
    put(w, "}\n");
}

char* python_write(const cJSON* api) {
    writer w = {0};
    const cJSON *entry, *constant;
    put(&w, "# %s\n", string_of(api, "about"));
    put(&w, "# pylint: disable=line-too-long, missing-class-docstring, too-many-lines, too-few-public-methods\n"
            "\"\"\"The structs, constants and functions of the C headers, for ctypes.\"\"\"\nimport ctypes as c\nfrom "
            "typing import Any\n\n"
            "from .base import Sized, Struct\n\n");
    cJSON_ArrayForEach(constant, cJSON_GetObjectItem(api, "constants")) put_constant(&w, constant);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "enums"))
        cJSON_ArrayForEach(constant, cJSON_GetObjectItem(entry, "constants")) put_constant(&w, constant);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) put_struct(&w, api, entry);
    put(&w, "\n");
    put_functions(&w, api, "FUNCTIONS", false);
    put_functions(&w, api, "GLTF_FUNCTIONS", true);
    put_aliases(&w, api);
    put_layouts(&w, api);
    return w.text;
}
