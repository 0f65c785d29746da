#include "layout.h"

#include <stdlib.h>
#include <string.h>

#include "text.h"
#include "types.h"

/* i386 Linux aligns 64-bit numbers in structs to 4, the other 32-bit ABIs to 8. */
static const struct abi {
    const char* name;
    const char* targets[3];
} abis[] = {
    {"64-bit", {"x86_64-linux-gnu", "aarch64-linux-gnu", "x86_64-windows-gnu"}},
    {"32-bit", {"armv7-linux-gnueabihf", "wasm32-unknown-unknown", NULL}},
    {"32-bit i386", {"i686-linux-gnu", NULL, NULL}},
};
enum { ABIS = sizeof abis / sizeof *abis, MAX_ARGUMENTS = 16 };

typedef struct measured {
    const char* abi;
    cJSON* structs;
} measured;

static cJSON* find_struct(const cJSON* structs, const char* name) {
    cJSON* entry;
    cJSON_ArrayForEach(entry, structs) {
        if (strcmp(cJSON_GetObjectItem(entry, "name")->valuestring, name) == 0) return entry;
    }
    return NULL;
}

static cJSON* measure(CXCursor cursor, const cJSON* entry) {
    const CXType type = clang_getCursorType(cursor);
    cJSON* layout = cJSON_CreateObject();
    cJSON_AddNumberToObject(layout, "size", (double)clang_Type_getSizeOf(type));
    cJSON_AddNumberToObject(layout, "align", (double)clang_Type_getAlignOf(type));
    cJSON *offsets = cJSON_AddArrayToObject(layout, "offsets"), *field;
    cJSON_ArrayForEach(field, cJSON_GetObjectItem(entry, "fields")) {
        const long long bits = clang_Type_getOffsetOf(type, cJSON_GetObjectItem(field, "name")->valuestring);
        const long long bytes = bits / 8;
        cJSON_AddItemToArray(offsets, cJSON_CreateNumber((double)bytes));
    }
    return layout;
}

static enum CXChildVisitResult visit(CXCursor cursor, CXCursor parent, CXClientData data) {
    const measured* m = data;
    (void)parent;
    if (clang_getCursorKind(cursor) != CXCursor_StructDecl || !clang_isCursorDefinition(cursor))
        return CXChildVisit_Continue;
    char* name = cursor_name(cursor);
    cJSON* entry = find_struct(m->structs, name);
    if (entry != NULL) {
        cJSON *layouts = cJSON_GetObjectItem(entry, "layout"), *layout = measure(cursor, entry);
        const cJSON* before = cJSON_GetObjectItemCaseSensitive(layouts, m->abi);
        if (before == NULL)
            cJSON_AddItemToObject(layouts, m->abi, layout);
        else if (!cJSON_Compare(before, layout, 1))
            text_fail("%s has two layouts in the ABI \"%s\"", name, m->abi);
        else
            cJSON_Delete(layout);
    }
    free(name);
    return CXChildVisit_Continue;
}

static void measure_target(CXIndex index, const char* path, const char* const* arguments, int argument_count,
                           const char* target, measured* m) {
    const char* all[MAX_ARGUMENTS] = {"-target", target, "-ffreestanding"};
    int count = 3;
    for (int i = 0; i < argument_count && count < MAX_ARGUMENTS; i++) all[count++] = arguments[i];
    const CXTranslationUnit unit = clang_parseTranslationUnit(index, path, all, count, NULL, 0, 0);
    if (unit == NULL || clang_getNumDiagnostics(unit) > 0) text_fail("%s does not compile for %s", path, target);
    clang_visitChildren(clang_getTranslationUnitCursor(unit), visit, m);
    clang_disposeTranslationUnit(unit);
}

void layout_describe(CXIndex index, const char* path, const char* const* arguments, int argument_count, cJSON* api) {
    cJSON *list = cJSON_GetObjectItem(api, "abis"), *structs = cJSON_GetObjectItem(api, "structs"), *entry;
    cJSON_ArrayForEach(entry, structs) cJSON_AddObjectToObject(entry, "layout");
    for (int a = 0; a < ABIS; a++) {
        cJSON* abi = cJSON_CreateObject();
        cJSON_AddStringToObject(abi, "name", abis[a].name);
        cJSON* targets = cJSON_AddArrayToObject(abi, "targets");
        cJSON_AddItemToArray(list, abi);
        measured m = {abis[a].name, structs};
        for (int t = 0; t < 3 && abis[a].targets[t] != NULL; t++) {
            cJSON_AddItemToArray(targets, cJSON_CreateString(abis[a].targets[t]));
            measure_target(index, path, arguments, argument_count, abis[a].targets[t], &m);
        }
    }
}
