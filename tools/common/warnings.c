/* What the library warned of while it answered, for the tool's JSON. */
#include "warnings.h"

#include <stdlib.h>
#include <string.h>

#include "cli.h"

void warnings_add(warnings* list, const char* text) {
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->texts[i], text) == 0) return;
    char** texts = cli_alloc(((size_t)list->count + 1) * sizeof *texts);
    if (list->count > 0) memcpy(texts, list->texts, (size_t)list->count * sizeof *texts);
    free(list->texts);
    list->texts = texts;
    list->texts[list->count++] = cli_copy_text(text);
}

void warnings_clear(warnings* list) {
    for (int i = 0; i < list->count; i++) free(list->texts[i]);
    free(list->texts);
    *list = (warnings){NULL, 0};
}

void warnings_to_json(const warnings* list, cJSON* out) {
    cJSON* array = cJSON_GetObjectItemCaseSensitive(out, "warnings");
    if (array == NULL && list->count > 0) array = cJSON_AddArrayToObject(out, "warnings");
    for (int i = 0; i < list->count; i++) cJSON_AddItemToArray(array, cJSON_CreateString(list->texts[i]));
}
