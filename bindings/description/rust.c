#include <stdint.h>
#include <string.h>

#include "languages.h"
#include "writer.h"

static const char* const plain_types[] = {
    "int8_t", "i8",       "uint8_t", "u8",      "int16_t", "i16",      "uint16_t", "u16",    "int32_t",
    "i32",    "uint32_t", "u32",     "int64_t", "i64",     "uint64_t", "u64",      "size_t", "usize",
    "char",   "c_char",   "float",   "f32",     "double",  "f64",      "void",     "c_void", NULL};
static const char* const keywords[] = {"type", "type_", "ref", "ref_", "box", "box_", "move", "move_", NULL};

static const char* rust_name(const char* name) {
    const char* other = replaced(keywords, name);
    return other != NULL ? other : name;
}

static void put_signature(writer* w, const cJSON* api, const cJSON* signature);

static void put_type(writer* w, const cJSON* api, const cJSON* type) {
    const cJSON* callback = cJSON_GetObjectItem(type, "callback");
    if (callback != NULL) {
        put(w, "Option<unsafe extern \"C\" fn");
        put_signature(w, api, callback);
        put(w, ">");
        return;
    }
    for (int i = 0; i < number_of(type, "pointers"); i++)
        put(w, "*%s ", cJSON_HasObjectItem(type, "const") ? "const" : "mut");
    const char *name = string_of(type, "name"), *plain = replaced(plain_types, name);
    put(w, "%s", plain != NULL ? plain : name);
}

static void put_field_type(writer* w, const cJSON* api, const cJSON* type) {
    const int count = number_of(type, "count");
    if (count > 0) put(w, "[");
    put_type(w, api, type);
    if (count > 0) put(w, "; %d]", count);
}

static void put_signature(writer* w, const cJSON* api, const cJSON* signature) {
    const cJSON *parameters = cJSON_GetObjectItem(signature, "parameters"), *parameter,
                *returns = cJSON_GetObjectItem(signature, "returns");
    put(w, "(");
    cJSON_ArrayForEach(parameter, parameters) {
        if (parameter != parameters->child) put(w, ", ");
        const cJSON* type = cJSON_GetObjectItem(parameter, "type");
        put(w, "%s: ", rust_name(string_of(parameter, "name")));
        if (number_of(type, "count") > 0) put(w, "*%s ", cJSON_HasObjectItem(type, "const") ? "const" : "mut");
        put_type(w, api, type);
    }
    put(w, ")");
    if (strcmp(string_of(returns, "name"), "void") != 0 || number_of(returns, "pointers") > 0) {
        put(w, " -> ");
        put_type(w, api, returns);
    }
}

/* Writes a comment; brackets would be links, and code in it would be run. */
static void put_doc(writer* w, const cJSON* entry, const char* indent) {
    const char* doc = string_of(entry, "doc");
    if (doc == NULL) return;
    put(w, "%s/// ", indent);
    for (; *doc != '\0'; doc++) put(w, strchr("[]<>*_`", *doc) != NULL ? "\\%c" : "%c", *doc);
    put(w, "\n");
}

static void put_constant(writer* w, const cJSON* constant) {
    const double value = cJSON_GetObjectItem(constant, "value")->valuedouble;
    put_doc(w, constant, "");
    put(w, "pub const %s: %s = %.0f;\n", string_of(constant, "name"), value <= INT32_MAX ? "i32" : "u32", value);
}

static void put_types(writer* w, const cJSON* api) {
    const cJSON* entry;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "types")) {
        const char* name = string_of(entry, "name");
        const cJSON* signature = cJSON_GetObjectItem(entry, "signature");
        put_doc(w, entry, "");
        if (signature != NULL) {
            put(w, "pub type %s = Option<unsafe extern \"C\" fn", name);
            put_signature(w, api, signature);
            put(w, ">;\n");
        } else if (is_opaque(api, name)) {
            put(w, "#[repr(C)]\npub struct %s {\n    opaque: [u8; 0],\n}\n", name);
        } else {
            put(w, "pub type %s = %s;\n", name, replaced(plain_types, string_of(entry, "integer")));
        }
    }
}

static void put_struct(writer* w, const cJSON* api, const cJSON* structure) {
    const char* name = string_of(structure, "name");
    const cJSON* field;
    put(w, "\n");
    put_doc(w, structure, "");
    put(w, "#[repr(C)]\n#[derive(Clone, Copy, Debug)]\npub struct %s {\n", name);
    cJSON_ArrayForEach(field, cJSON_GetObjectItem(structure, "fields")) {
        put_doc(w, field, "    ");
        put(w, "    pub %s: ", rust_name(string_of(field, "name")));
        put_field_type(w, api, cJSON_GetObjectItem(field, "type"));
        put(w, ",\n");
    }
    put(w, "}\n\nimpl Default for %s {\n    /// Zeros%s.\n    fn default() -> Self {\n", name,
        is_sized(structure) ? ", with struct\\_size set" : "");
    if (is_sized(structure))
        put(w, "        let mut value: Self = unsafe { core::mem::zeroed() };\n"
               "        value.struct_size = core::mem::size_of::<Self>() as u32;\n        value\n");
    else
        put(w, "        unsafe { core::mem::zeroed() }\n");
    put(w, "    }\n}\n");
}

static void put_functions(writer* w, const cJSON* api, bool gltf) {
    const cJSON* function;
    put(w, "\n%s#[link(name = \"%s\")]\nextern \"C\" {\n", gltf ? "#[cfg(feature = \"gltf\")]\n" : "",
        gltf ? "dragmesh_gltf" : "dragmesh");
    cJSON_ArrayForEach(function, cJSON_GetObjectItem(api, "functions")) {
        if ((strstr(string_of(function, "header"), "gltf") != NULL) != gltf) continue;
        put_doc(w, function, "    ");
        put(w, "    pub fn %s", string_of(function, "name"));
        put_signature(w, api, function);
        put(w, ";\n");
    }
    put(w, "}\n");
    cJSON_ArrayForEach(function, cJSON_GetObjectItem(api, "aliases")) {
        if ((strstr(string_of(function, "header"), "gltf") != NULL) != gltf) continue;
        put_doc(w, function, "");
        put(w, "%spub use self::%s as %s;\n", gltf ? "#[cfg(feature = \"gltf\")]\n" : "",
            string_of(function, "function"), string_of(function, "name"));
    }
}

static void put_layout(writer* w, const cJSON* structure, const char* abi) {
    const char* name = string_of(structure, "name");
    const cJSON *layout = cJSON_GetObjectItem(cJSON_GetObjectItem(structure, "layout"), abi), *field;
    int index = 0;
    put(w, "        check!(%s, %d", name, number_of(layout, "size"));
    cJSON_ArrayForEach(field, cJSON_GetObjectItem(structure, "fields")) {
        put(w, ", %s %d", rust_name(string_of(field, "name")),
            cJSON_GetArrayItem(cJSON_GetObjectItem(layout, "offsets"), index)->valueint);
        index++;
    }
    put(w, ");\n");
}

static void put_layouts(writer* w, const cJSON* api, const char* abi, int bits) {
    const cJSON* entry;
    put(w, "\n    #[test]\n    #[cfg(target_pointer_width = \"%d\")]\n    fn layouts_are_those_of_c() {\n", bits);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) put_layout(w, entry, abi);
    put(w, "    }\n");
}

char* rust_write(const cJSON* api) {
    writer w = {0};
    const cJSON *entry, *constant;
    put(&w, "// %s\nuse std::os::raw::{c_char, c_void};\n\n", string_of(api, "about"));
    cJSON_ArrayForEach(constant, cJSON_GetObjectItem(api, "constants")) put_constant(&w, constant);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "enums"))
        cJSON_ArrayForEach(constant, cJSON_GetObjectItem(entry, "constants")) put_constant(&w, constant);
    put(&w, "\n");
    put_types(&w, api);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) put_struct(&w, api, entry);
    put_functions(&w, api, false);
    put_functions(&w, api, true);
    put(&w, "\n#[cfg(test)]\nmod tests {\n    use super::*;\n    use core::mem::size_of;\n\n"
            "    macro_rules! check {\n"
            "        ($name:ident, $size:expr $(, $field:ident $offset:expr)*) => {\n"
            "            let value = $name::default();\n"
            "            let start = &value as *const _ as usize;\n"
            "            assert_eq!(size_of::<$name>(), $size, stringify!($name));\n"
            "            $(assert_eq!(core::ptr::addr_of!(value.$field) as usize - start, $offset, stringify!($name, "
            "$field));)*\n        };\n    }\n");
    put_layouts(&w, api, "64-bit", 64);
    put_layouts(&w, api, "32-bit", 32);
    put(&w, "}\n");
    return w.text;
}
