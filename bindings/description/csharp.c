#include <stdint.h>
#include <string.h>

#include "languages.h"
#include "writer.h"

static const char* const plain_types[] = {
    "int8_t", "sbyte",    "uint8_t", "byte",    "int16_t", "short",    "uint16_t", "ushort", "int32_t",
    "int",    "uint32_t", "uint",    "int64_t", "long",    "uint64_t", "ulong",    "size_t", "UIntPtr",
    "char",   "byte",     "float",   "float",   "double",  "double",   "void",     "void",   NULL};
static const char* const keywords[] = {"object", "@object", "ref", "@ref", "params", "@params", NULL};

static void put_type(writer* w, const cJSON* api, const cJSON* type) {
    if (is_callback(api, type)) {
        put(w, "IntPtr");
        return;
    }
    const char *name = string_of(type, "name"), *plain = replaced(plain_types, name);
    const cJSON* declared = type_of(api, name);
    int stars = number_of(type, "pointers");
    if (is_opaque(api, name)) {
        put(w, "IntPtr");
        stars--;
    } else if (declared != NULL) {
        put(w, "%s", replaced(plain_types, string_of(declared, "integer")));
    } else if (plain != NULL) {
        put(w, "%s", plain);
    } else {
        put_pascal(w, name);
    }
    put(w, "%.*s", stars, "****");
}

static void put_doc(writer* w, const cJSON* entry, const char* indent) {
    const char* doc = string_of(entry, "doc");
    if (doc == NULL) return;
    put(w, "%s/// <summary>", indent);
    for (; *doc != '\0'; doc++) {
        if (*doc == '<')
            put(w, "&lt;");
        else if (*doc == '>')
            put(w, "&gt;");
        else if (*doc == '&')
            put(w, "&amp;");
        else
            put(w, "%c", *doc);
    }
    put(w, "</summary>\n");
}

static void put_parameters(writer* w, const cJSON* api, const cJSON* parameters) {
    const cJSON* parameter;
    put(w, "(");
    cJSON_ArrayForEach(parameter, parameters) {
        const char* name = string_of(parameter, "name");
        if (parameter != parameters->child) put(w, ", ");
        const cJSON* type = cJSON_GetObjectItem(parameter, "type");
        put_type(w, api, type);
        put(w, "%s %s", number_of(type, "count") > 0 ? "*" : "",
            replaced(keywords, name) != NULL ? replaced(keywords, name) : name);
    }
    put(w, ");\n");
}

static void put_constant(writer* w, const cJSON* constant) {
    const double value = cJSON_GetObjectItem(constant, "value")->valuedouble;
    put_doc(w, constant, "        ");
    put(w, "        public const %s %s = %.0f;\n", value <= INT32_MAX ? "int" : "uint", string_of(constant, "name"),
        value);
}

static void put_constants(writer* w, const cJSON* api) {
    const cJSON *entry, *constant;
    put(w, "    /// <summary>The constants of the C header, under its names.</summary>\n"
           "    public static class Constants\n    {\n");
    cJSON_ArrayForEach(constant, cJSON_GetObjectItem(api, "constants")) put_constant(w, constant);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "enums"))
        cJSON_ArrayForEach(constant, cJSON_GetObjectItem(entry, "constants")) put_constant(w, constant);
    put(w, "    }\n");
}

static void put_delegate(writer* w, const cJSON* api, const char* owner, const char* name, const cJSON* callback) {
    put(w, "\n    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]\n    public unsafe delegate ");
    put_type(w, api, cJSON_GetObjectItem(callback, "returns"));
    put(w, " ");
    put_pascal(w, owner);
    put_pascal(w, name);
    put_parameters(w, api, cJSON_GetObjectItem(callback, "parameters"));
}

static void put_delegates(writer* w, const cJSON* api) {
    const cJSON *entry, *field;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "types")) {
        const cJSON* signature = cJSON_GetObjectItem(entry, "signature");
        if (signature != NULL) put_delegate(w, api, "", string_of(entry, "name"), signature);
    }
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs"))
        cJSON_ArrayForEach(field, cJSON_GetObjectItem(entry, "fields")) {
        const cJSON* callback = cJSON_GetObjectItem(cJSON_GetObjectItem(field, "type"), "callback");
        if (callback != NULL) put_delegate(w, api, string_of(entry, "name"), string_of(field, "name"), callback);
    }
}

/* Writes an array of numbers as a fixed buffer; one of structs as a field an element, because C# has no buffer of
 * them. */
static void put_field(writer* w, const cJSON* api, const cJSON* field) {
    const cJSON* type = cJSON_GetObjectItem(field, "type");
    const int count = number_of(type, "count");
    const bool fixed = count > 0 && replaced(plain_types, string_of(type, "name")) != NULL;
    for (int i = 0; i < (count > 0 && !fixed ? count : 1); i++) {
        put_doc(w, field, "        ");
        put(w, "        public %s", fixed ? "fixed " : "");
        put_type(w, api, type);
        put(w, " ");
        put_pascal(w, string_of(field, "name"));
        if (fixed)
            put(w, "[%d]", count);
        else if (count > 0)
            put(w, "%d", i);
        put(w, ";\n");
    }
}

static void put_struct(writer* w, const cJSON* api, const cJSON* structure) {
    const cJSON* field;
    put(w, "\n");
    put_doc(w, structure, "    ");
    put(w, "    [StructLayout(LayoutKind.Sequential)]\n    public unsafe partial struct ");
    put_pascal(w, string_of(structure, "name"));
    put(w, "\n    {\n");
    cJSON_ArrayForEach(field, cJSON_GetObjectItem(structure, "fields")) put_field(w, api, field);
    if (is_sized(structure)) {
        put(w, "\n        /// <summary>Zeros, with StructSize set.</summary>\n        public static ");
        put_pascal(w, string_of(structure, "name"));
        put(w, " New() => new ");
        put_pascal(w, string_of(structure, "name"));
        put(w, " { StructSize = (uint)sizeof(");
        put_pascal(w, string_of(structure, "name"));
        put(w, ") };\n");
    }
    put(w, "    }\n");
}

/* Writes a function under its name, or under that of an alias. */
static void put_function(writer* w, const cJSON* api, const cJSON* function, const char* name) {
    const bool gltf = strstr(string_of(function, "header"), "gltf") != NULL;
    put(w, "\n");
    put_doc(w, function, "        ");
    put(w, "        [DllImport(%s, CallingConvention = CallingConvention.Cdecl", gltf ? "GltfLibrary" : "Library");
    if (strcmp(name, string_of(function, "name")) != 0) put(w, ", EntryPoint = \"%s\"", string_of(function, "name"));
    put(w, ")]\n        public static extern ");
    put_type(w, api, cJSON_GetObjectItem(function, "returns"));
    put(w, " %s", name);
    put_parameters(w, api, cJSON_GetObjectItem(function, "parameters"));
}

char* csharp_write(const cJSON* api) {
    writer w = {0};
    const cJSON* entry;
    put(&w, "// %s\nusing System;\nusing System.Runtime.InteropServices;\n\nnamespace DragMesh\n{\n",
        string_of(api, "about"));
    put_constants(&w, api);
    put_delegates(&w, api);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) put_struct(&w, api, entry);
    put(&w, "\n    /// <summary>The functions of the C header.</summary>\n"
            "    public static unsafe class Native\n    {\n"
            "#if UNITY_IOS && !UNITY_EDITOR\n"
            "        public const string Library = \"__Internal\", GltfLibrary = \"__Internal\";\n"
            "#else\n"
            "        public const string Library = \"dragmesh\", GltfLibrary = \"dragmesh_gltf\";\n"
            "#endif\n");
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "functions"))
        put_function(&w, api, entry, string_of(entry, "name"));
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "aliases"))
        put_function(&w, api, function_of(api, entry), string_of(entry, "name"));
    put(&w, "    }\n}\n");
    return w.text;
}

static void put_layout(writer* w, const cJSON* structure) {
    const char* name = string_of(structure, "name");
    const cJSON *layout = cJSON_GetObjectItem(structure, "layout"), *field;
    const cJSON *wide = cJSON_GetObjectItem(layout, "64-bit"), *narrow = cJSON_GetObjectItem(layout, "32-bit");
    int index = 0;
    put(w, "            { ");
    put_pascal(w, name);
    put(w, " s; byte* at = (byte*)&s;\n");
    put(w, "              Expect(\"%s\", sizeof(", name);
    put_pascal(w, name);
    put(w, "), %d, %d);\n", number_of(wide, "size"), number_of(narrow, "size"));
    cJSON_ArrayForEach(field, cJSON_GetObjectItem(structure, "fields")) {
        const cJSON* type = cJSON_GetObjectItem(field, "type");
        const bool array = number_of(type, "count") > 0;
        const bool fixed = array && replaced(plain_types, string_of(type, "name")) != NULL;
        put(w, "              Expect(\"%s.%s\", (byte*)%ss.", name, string_of(field, "name"), fixed ? "" : "&");
        put_pascal(w, string_of(field, "name"));
        put(w, "%s - at, %d, %d);\n", array && !fixed ? "0" : "",
            cJSON_GetArrayItem(cJSON_GetObjectItem(wide, "offsets"), index)->valueint,
            cJSON_GetArrayItem(cJSON_GetObjectItem(narrow, "offsets"), index)->valueint);
        index++;
    }
    put(w, "            }\n");
}

char* csharp_layout_write(const cJSON* api) {
    writer w = {0};
    const cJSON* entry;
    put(&w,
        "// %s\nusing System;\n\nnamespace DragMesh\n{\n"
        "    /// <summary>Compares the runtime's layout of the structs with that of C.</summary>\n"
        "    public static unsafe class Layout\n    {\n"
        "        private static int compared;\n\n"
        "        private static void Expect(string name, long found, long wide, long narrow)\n        {\n"
        "            compared++;\n"
        "            long wanted = IntPtr.Size == 8 ? wide : narrow;\n"
        "            if (found != wanted) throw new InvalidOperationException(name + \" is \" + found + \", in C \" "
        "+ wanted);\n        }\n\n"
        "        /// <summary>Returns how many sizes and offsets it has compared; throws at the first that "
        "differs.</summary>\n"
        "        public static int Check()\n        {\n            compared = 0;\n",
        string_of(api, "about"));
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "structs")) put_layout(&w, entry);
    put(&w, "            return compared;\n        }\n    }\n}\n");
    return w.text;
}
