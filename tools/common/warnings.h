/* What the library warned of while it answered, for the tool's JSON. */
#ifndef CLI_WARNINGS_H
#define CLI_WARNINGS_H

#include <cjson/cJSON.h>

typedef struct warnings {
    char** texts;
    int count;
} warnings;

/* Adds a copy of a text that is not there yet. */
void warnings_add(warnings* list, const char* text);
void warnings_clear(warnings* list);
/* Appends the texts to the member `warnings`, an array; makes it where there is a first one. */
void warnings_to_json(const warnings* list, cJSON* out);

#endif
