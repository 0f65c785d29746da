#include "header.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "comments.h"
#include "text.h"
#include "types.h"

typedef struct reader {
    CXTranslationUnit unit;
    CXFile file;
    const char* header; /* as it is included */
    comments* docs;
    cJSON* api;
    char default_thread[64]; /* "" : each function states its own */
} reader;

static cJSON* list(reader* r, const char* name) {
    return cJSON_GetObjectItemCaseSensitive(r->api, name);
}

static cJSON* add_entry(reader* r, const char* list_name, const char* name, CXCursor cursor) {
    cJSON* entry = cJSON_CreateObject();
    if (name != NULL) cJSON_AddStringToObject(entry, "name", name);
    const char* doc = comments_of(r->docs, cursor);
    if (doc != NULL) cJSON_AddStringToObject(entry, "doc", doc);
    cJSON_AddStringToObject(entry, "header", r->header);
    cJSON_AddItemToArray(list(r, list_name), entry);
    return entry;
}

/* ---- enums and structs ---- */

typedef struct members {
    reader* reader;
    cJSON* list;
} members;

static cJSON* add_member(members* m, CXCursor cursor) {
    cJSON* member = cJSON_CreateObject();
    char* name = cursor_name(cursor);
    cJSON_AddStringToObject(member, "name", name);
    free(name);
    const char* doc = comments_of(m->reader->docs, cursor);
    if (doc != NULL) cJSON_AddStringToObject(member, "doc", doc);
    cJSON_AddItemToArray(m->list, member);
    return member;
}

static enum CXChildVisitResult add_constant(CXCursor cursor, CXCursor parent, CXClientData data) {
    (void)parent;
    if (clang_getCursorKind(cursor) == CXCursor_EnumConstantDecl)
        cJSON_AddNumberToObject(add_member(data, cursor), "value", (double)clang_getEnumConstantDeclValue(cursor));
    return CXChildVisit_Continue;
}

static enum CXChildVisitResult add_field(CXCursor cursor, CXCursor parent, CXClientData data) {
    (void)parent;
    if (clang_getCursorKind(cursor) == CXCursor_FieldDecl)
        cJSON_AddItemToObject(add_member(data, cursor), "type", type_to_json(clang_getCursorType(cursor), cursor));
    return CXChildVisit_Continue;
}

static void add_enum(reader* r, CXCursor cursor) {
    cJSON* entry = add_entry(r, "enums", NULL, cursor);
    members m = {r, cJSON_AddArrayToObject(entry, "constants")};
    clang_visitChildren(cursor, add_constant, &m);
}

static void add_struct(reader* r, CXCursor cursor) {
    char* name = cursor_name(cursor);
    cJSON* entry = add_entry(r, "structs", name, cursor);
    members m = {r, cJSON_AddArrayToObject(entry, "fields")};
    clang_visitChildren(cursor, add_field, &m);
    free(name);
}

/* ---- other types ---- */

static bool is_struct_here(CXType type) {
    return clang_getCanonicalType(type).kind == CXType_Record &&
           !clang_equalCursors(clang_getCursorDefinition(clang_getTypeDeclaration(type)), clang_getNullCursor());
}

/* Handles are 64-bit numbers; other numbers, such as results, are plain integers. */
static void add_type(reader* r, CXCursor cursor) {
    const CXType type = clang_getTypedefDeclUnderlyingType(cursor);
    if (is_struct_here(type)) return; /* add_struct has it */
    char* name = cursor_name(cursor);
    cJSON* entry = add_entry(r, "types", name, cursor);
    free(name);
    const CXType pointee = clang_getPointeeType(type);
    if (clang_getCanonicalType(type).kind == CXType_Record) {
        cJSON_AddStringToObject(entry, "kind", "opaque");
    } else if (type.kind == CXType_Pointer) {
        cJSON_AddStringToObject(entry, "kind", "callback");
        cJSON_AddItemToObject(entry, "signature", signature_to_json(cursor, pointee));
    } else {
        cJSON* whole = type_to_json(type, clang_getNullCursor());
        const char* integer = cJSON_GetObjectItem(whole, "name")->valuestring;
        cJSON_AddStringToObject(entry, "kind", strcmp(integer, "uint64_t") == 0 ? "handle" : "integer");
        cJSON_AddStringToObject(entry, "integer", integer);
        cJSON_Delete(whole);
    }
}

/* ---- functions ---- */

/* Copies the last "[...]" of a text that names a threading rule; false when there is none. */
static bool find_thread(const char* doc, char out[64]) {
    static const char* const tags[] = {"[any-thread", "[frame", "[exclusive"};
    const char* found = NULL;
    for (int i = 0; doc != NULL && i < 3; i++)
        for (const char* at = doc; (at = strstr(at, tags[i])) != NULL; at++)
            if (found == NULL || at > found) found = at;
    const char* end = found != NULL ? strchr(found, ']') : NULL;
    if (end == NULL || end - found > 63) return false;
    memcpy(out, found + 1, (size_t)(end - found - 1));
    out[end - found - 1] = 0;
    return true;
}

static const char* direction_of(const cJSON* parameter) {
    const cJSON *name = cJSON_GetObjectItem(parameter, "name"), *type = cJSON_GetObjectItem(parameter, "type");
    if (strncmp(name->valuestring, "out_", 4) == 0) return "out";
    const bool points = cJSON_HasObjectItem(type, "pointers");
    return points && !cJSON_HasObjectItem(type, "const") ? "in out" : "in";
}

static void add_function(reader* r, CXCursor cursor) {
    if (clang_Cursor_isFunctionInlined(cursor)) return; /* bindings make their own defaults */
    char* name = cursor_name(cursor);
    cJSON* entry = add_entry(r, "functions", name, cursor);
    const cJSON* doc = cJSON_GetObjectItem(entry, "doc");
    char thread[64];
    if (!find_thread(doc != NULL ? doc->valuestring : NULL, thread)) {
        if (r->default_thread[0] == 0) text_fail("%s does not state its threading tag", name);
        snprintf(thread, sizeof thread, "%s", r->default_thread);
    }
    cJSON_AddStringToObject(entry, "threads", thread);
    cJSON* signature = signature_to_json(cursor, clang_getCursorType(cursor));
    cJSON* parameter;
    cJSON_ArrayForEach(parameter, cJSON_GetObjectItem(signature, "parameters")) {
        if (!cJSON_HasObjectItem(parameter, "name")) text_fail("%s has a parameter without a name", name);
        cJSON_AddStringToObject(parameter, "direction", direction_of(parameter));
    }
    cJSON_AddItemToObject(entry, "returns", cJSON_DetachItemFromObject(signature, "returns"));
    cJSON_AddItemToObject(entry, "parameters", cJSON_DetachItemFromObject(signature, "parameters"));
    cJSON_Delete(signature);
    free(name);
}

/* ---- macros ---- */

/* Adds another name of a function; where the text is none of a function, drop_other_names takes it out again. */
static void add_alias(reader* r, CXCursor cursor, const char* function) {
    char* name = cursor_name(cursor);
    cJSON_AddStringToObject(add_entry(r, "aliases", name, cursor), "function", function);
    free(name);
}

/* Adds a macro that stands for one number or for another name. */
static void add_macro(reader* r, CXCursor cursor) {
    CXToken* tokens = NULL;
    unsigned count = 0;
    clang_tokenize(r->unit, clang_getCursorExtent(cursor), &tokens, &count);
    if (count == 2 && !clang_Cursor_isMacroFunctionLike(cursor)) {
        const CXString spelling = clang_getTokenSpelling(r->unit, tokens[1]);
        const char* text = clang_getCString(spelling);
        char* end = NULL;
        double value = strtod(text, &end);
        bool number = clang_getTokenKind(tokens[1]) == CXToken_Literal && end != text;
        if (strcmp(text, "UINT32_MAX") == 0) value = UINT32_MAX, number = true;
        if (number) {
            char* name = cursor_name(cursor);
            cJSON_AddNumberToObject(add_entry(r, "constants", name, cursor), "value", value);
            free(name);
        } else if (clang_getTokenKind(tokens[1]) == CXToken_Identifier) {
            add_alias(r, cursor, text);
        }
        clang_disposeString(spelling);
    }
    clang_disposeTokens(r->unit, tokens, count);
}

static bool has_function(const cJSON* api, const char* name) {
    const cJSON* function;
    cJSON_ArrayForEach(
        function, cJSON_GetObjectItem(api, "functions")) if (strcmp(cJSON_GetObjectItem(function, "name")->valuestring,
                                                                    name) == 0) return true;
    return false;
}

/* Macros are read before functions, so only now it is known which of them name one. */
static void drop_other_names(cJSON* api) {
    cJSON *aliases = cJSON_GetObjectItem(api, "aliases"), *next;
    for (cJSON* alias = aliases->child; alias != NULL; alias = next) {
        next = alias->next;
        if (!has_function(api, cJSON_GetObjectItem(alias, "function")->valuestring))
            cJSON_Delete(cJSON_DetachItemViaPointer(aliases, alias));
    }
}

/* ---- the header ---- */

static enum CXChildVisitResult visit(CXCursor cursor, CXCursor parent, CXClientData data) {
    reader* r = data;
    CXFile file = NULL;
    (void)parent;
    clang_getFileLocation(clang_getCursorLocation(cursor), &file, NULL, NULL, NULL);
    if (!clang_File_isEqual(file, r->file)) return CXChildVisit_Continue;
    switch (clang_getCursorKind(cursor)) {
    case CXCursor_EnumDecl:
        add_enum(r, cursor);
        break;
    case CXCursor_StructDecl:
        if (clang_isCursorDefinition(cursor)) add_struct(r, cursor);
        break;
    case CXCursor_TypedefDecl:
        add_type(r, cursor);
        break;
    case CXCursor_FunctionDecl:
        add_function(r, cursor);
        break;
    case CXCursor_MacroDefinition:
        add_macro(r, cursor);
        break;
    default:
        break;
    }
    return CXChildVisit_Continue;
}

void header_describe(CXTranslationUnit unit, const char* path, const char* name, cJSON* api) {
    reader r = {.unit = unit, .file = clang_getFile(unit, path), .header = name, .api = api};
    if (r.file == NULL) text_fail("%s is not included", path);
    r.docs = comments_read(unit, r.file);
    const char* text = strstr(clang_getFileContents(unit, r.file, NULL), "All functions [");
    if (text != NULL) find_thread(text, r.default_thread);
    clang_visitChildren(clang_getTranslationUnitCursor(unit), visit, &r);
    drop_other_names(api);
    comments_free(r.docs);
}
