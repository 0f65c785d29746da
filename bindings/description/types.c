#include "types.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

static char* copy(CXString string) {
    const char* text = clang_getCString(string);
    const size_t size = strlen(text) + 1;
    char* out = memcpy(text_alloc(size), text, size);
    clang_disposeString(string);
    return out;
}

char* cursor_name(CXCursor cursor) {
    return copy(clang_getCursorSpelling(cursor));
}

/* The name of a type that is no pointer and no array, without const and struct. */
static char* plain_name(CXType type) {
    char* name = copy(clang_getTypeSpelling(type));
    const char* const prefixes[] = {"const ", "struct "};
    for (int i = 0; i < 2; i++) {
        const size_t n = strlen(prefixes[i]);
        if (strncmp(name, prefixes[i], n) == 0) memmove(name, name + n, strlen(name + n) + 1);
    }
    return name;
}

static bool is_function(CXType type) {
    const enum CXTypeKind kind = clang_getCanonicalType(type).kind;
    return kind == CXType_FunctionProto || kind == CXType_FunctionNoProto;
}

/* A typedef keeps its name even where it stands for a pointer. */
static bool is_pointer(CXType type) {
    return type.kind == CXType_Pointer;
}

static void add_string(cJSON* to, const char* key, char* owned) {
    cJSON_AddStringToObject(to, key, owned);
    free(owned);
}

cJSON* type_to_json(CXType type, CXCursor declaration) {
    cJSON* out = cJSON_CreateObject();
    add_string(out, "c", copy(clang_getTypeSpelling(type)));
    long long count = 0;
    if (type.kind == CXType_ConstantArray) {
        count = clang_getArraySize(type);
        type = clang_getArrayElementType(type);
    }
    int pointers = 0;
    while (is_pointer(type) && !is_function(clang_getPointeeType(type))) {
        type = clang_getPointeeType(type);
        pointers++;
    }
    if (is_pointer(type)) {
        cJSON_AddItemToObject(out, "callback", signature_to_json(declaration, clang_getPointeeType(type)));
        return out;
    }
    add_string(out, "name", plain_name(type));
    if (pointers > 0) cJSON_AddNumberToObject(out, "pointers", pointers);
    if (clang_isConstQualifiedType(type)) cJSON_AddTrueToObject(out, "const");
    if (count > 0) cJSON_AddNumberToObject(out, "count", (double)count);
    return out;
}

typedef struct names {
    char* list[16];
    int count;
} names;

static enum CXChildVisitResult keep_parameter(CXCursor cursor, CXCursor parent, CXClientData data) {
    names* found = data;
    (void)parent;
    if (clang_getCursorKind(cursor) == CXCursor_ParmDecl) {
        if (found->count == 16) text_fail("a function has more than 16 parameters");
        found->list[found->count++] = cursor_name(cursor);
    }
    return CXChildVisit_Continue;
}

cJSON* signature_to_json(CXCursor cursor, CXType function) {
    cJSON* out = cJSON_CreateObject();
    names found = {.count = 0};
    if (!clang_Cursor_isNull(cursor)) clang_visitChildren(cursor, keep_parameter, &found);
    if (function.kind != CXType_FunctionProto) function = clang_getCanonicalType(function); /* in parentheses */
    cJSON_AddItemToObject(out, "returns", type_to_json(clang_getResultType(function), clang_getNullCursor()));
    cJSON* parameters = cJSON_AddArrayToObject(out, "parameters");
    for (int i = 0; i < clang_getNumArgTypes(function); i++) {
        cJSON* parameter = cJSON_CreateObject();
        if (i < found.count) cJSON_AddStringToObject(parameter, "name", found.list[i]);
        const bool declared = i < found.count && clang_getCursorKind(cursor) == CXCursor_FunctionDecl;
        const CXType type = declared ? clang_getCursorType(clang_Cursor_getArgument(cursor, (unsigned)i))
                                     : clang_getArgType(function, (unsigned)i);
        cJSON_AddItemToObject(parameter, "type", type_to_json(type, clang_getNullCursor()));
        cJSON_AddItemToArray(parameters, parameter);
    }
    for (int i = 0; i < found.count; i++) free(found.list[i]);
    return out;
}
