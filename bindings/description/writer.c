#include "writer.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

void put(writer* w, const char* format, ...) {
    for (;;) {
        va_list arguments;
        va_start(arguments, format);
        const int n = vsnprintf(w->text != NULL ? w->text + w->length : NULL, w->room - w->length, format, arguments);
        va_end(arguments);
        if (n < 0) text_fail("a declaration can't be written");
        if (w->length + (size_t)n < w->room) {
            w->length += (size_t)n;
            return;
        }
        w->room = 2 * (w->room + (size_t)n + 1);
        if ((w->text = realloc(w->text, w->room)) == NULL) text_fail("no memory");
    }
}

void put_pascal(writer* w, const char* name) {
    if (strncmp(name, "dm_", 3) == 0) name += 3;
    for (bool first = true; *name != '\0'; name++) {
        if (*name != '_') put(w, "%c", first ? toupper(*name) : *name);
        first = *name == '_';
    }
}

const char* string_of(const cJSON* entry, const char* key) {
    return cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(entry, key));
}

int number_of(const cJSON* entry, const char* key) {
    const cJSON* item = cJSON_GetObjectItemCaseSensitive(entry, key);
    return item != NULL ? item->valueint : 0;
}

const cJSON* type_of(const cJSON* api, const char* name) {
    const cJSON* entry;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "types")) {
        if (strcmp(string_of(entry, "name"), name) == 0) return entry;
    }
    return NULL;
}

const cJSON* function_of(const cJSON* api, const cJSON* alias) {
    const cJSON* entry;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(api, "functions")) {
        if (strcmp(string_of(entry, "name"), string_of(alias, "function")) == 0) return entry;
    }
    return NULL;
}

bool is_opaque(const cJSON* api, const char* name) {
    const cJSON* type = type_of(api, name);
    return type != NULL && strcmp(string_of(type, "kind"), "opaque") == 0;
}

bool is_sized(const cJSON* structure) {
    const cJSON* first = cJSON_GetArrayItem(cJSON_GetObjectItem(structure, "fields"), 0);
    return first != NULL && strcmp(string_of(first, "name"), "struct_size") == 0;
}

const cJSON* callback_of(const cJSON* api, const cJSON* type) {
    const cJSON* callback = cJSON_GetObjectItem(type, "callback");
    if (callback != NULL) return callback;
    return cJSON_GetObjectItem(type_of(api, string_of(type, "name")), "signature");
}

bool is_callback(const cJSON* api, const cJSON* type) {
    return callback_of(api, type) != NULL;
}

const char* replaced(const char* const* pairs, const char* name) {
    for (; *pairs != NULL; pairs += 2)
        if (strcmp(*pairs, name) == 0) return pairs[1];
    return NULL;
}
