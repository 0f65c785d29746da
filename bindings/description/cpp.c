#include "languages.h"
#include "writer.h"

static void put_constant(writer* w, const cJSON* constant) {
    put(w, "static_assert(%s == %.0f, \"%s has another value\");\n", string_of(constant, "name"),
        cJSON_GetObjectItem(constant, "value")->valuedouble, string_of(constant, "name"));
}

static void put_struct(writer* w, const cJSON* structure) {
    const char* name = string_of(structure, "name");
    const cJSON *layout = cJSON_GetObjectItem(cJSON_GetObjectItem(structure, "layout"), "64-bit"), *field;
    const cJSON* offset = cJSON_GetObjectItem(layout, "offsets")->child;
    put(w, "static_assert(sizeof(void*) != 8 || sizeof(%s) == %d, \"%s has another size\");\n", name,
        number_of(layout, "size"), name);
    cJSON_ArrayForEach(field, cJSON_GetObjectItem(structure, "fields")) {
        const char* field_name = string_of(field, "name");
        put(w,
            "static_assert(std::is_same<decltype(%s::%s), %s>::value && (sizeof(void*) != 8 || offsetof(%s, %s) == "
            "%d), \"%s.%s is another field\");\n",
            name, field_name, string_of(cJSON_GetObjectItem(field, "type"), "c"), name, field_name, offset->valueint,
            name, field_name);
        offset = offset->next;
    }
}

static void put_function(writer* w, const cJSON* function) {
    const char* name = string_of(function, "name");
    const cJSON *parameters = cJSON_GetObjectItem(function, "parameters"), *parameter;
    put(w, "static_assert(std::is_same<decltype(&%s), %s (*)(", name,
        string_of(cJSON_GetObjectItem(function, "returns"), "c"));
    cJSON_ArrayForEach(parameter, parameters) {
        put(w, "%s%s", parameter != parameters->child ? ", " : "",
            string_of(cJSON_GetObjectItem(parameter, "type"), "c"));
    }
    put(w, ")>::value, \"%s is another function\");\n", name);
}

char* cpp_write(const cJSON* api) {
    writer w = {0};
    const cJSON *entry, *constant;
    put(&w,
        "/* %s\n * Include it once in a program to have the compiler compare the headers at hand with those that the "
        "bindings describe. */\n#ifndef DRAGMESH_CHECK_HPP\n#define DRAGMESH_CHECK_HPP\n\n#include <cstddef>\n"
        "#include <type_traits>\n\n#include \"dragmesh/ext/gltf.h\"\n#include \"dragmesh/ext/gltf_rig.h\"\n\n",
        string_of(api, "about"));
    cJSON_ArrayForEach(constant, cJSON_GetObjectItem(api, "constants")) put_constant(&w, constant);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "enums"))
        cJSON_ArrayForEach(constant, cJSON_GetObjectItem(entry, "constants")) put_constant(&w, constant);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) put_struct(&w, entry);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "functions")) put_function(&w, entry);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "aliases"))
        put(&w, "static_assert(std::is_same<decltype(%s), decltype(%s)>::value, \"%s is another function\");\n",
            string_of(entry, "name"), string_of(entry, "function"), string_of(entry, "name"));
    put(&w, "\n#endif\n");
    return w.text;
}
