/* Growing text, and what all languages read from the description. */
#ifndef DESCRIBE_WRITER_H
#define DESCRIBE_WRITER_H

#include <stdbool.h>
#include <stddef.h>

#include <cjson/cJSON.h>

typedef struct writer {
    char* text; /* ends with a zero; to be freed */
    size_t length, room;
} writer;

void put(writer* w, const char* format, ...) __attribute__((format(printf, 2, 3)));
/* Writes a C name as DragDesc for dm_drag_desc, or StructSize for struct_size. */
void put_pascal(writer* w, const char* name);

/* Returns the string of a key; NULL: absent. */
const char* string_of(const cJSON* entry, const char* key);
/* Returns the number of a key; 0: absent. */
int number_of(const cJSON* entry, const char* key);
/* Returns the function that an entry of "aliases" is another name of. */
const cJSON* function_of(const cJSON* api, const cJSON* alias);
/* Returns the entry of "types" with this name; NULL: it is a struct or a type of C. */
const cJSON* type_of(const cJSON* api, const char* name);
/* Whether the named type is an opaque struct, which is only pointed to. */
bool is_opaque(const cJSON* api, const char* name);
/* Whether the struct begins with struct_size. */
bool is_sized(const cJSON* structure);
/* Whether the type is a function pointer, with or without a typedef. */
bool is_callback(const cJSON* api, const cJSON* type);
/* Returns {"returns", "parameters"} of a function pointer. */
const cJSON* callback_of(const cJSON* api, const cJSON* type);
/* Returns the replacement of a name in pairs {name, replacement, ..., NULL}; NULL: it has none. */
const char* replaced(const char* const* pairs, const char* name);

#endif
