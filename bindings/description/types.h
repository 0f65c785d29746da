/* C types as JSON: name, pointers, const, count, or a callback's parameters. */
#ifndef DESCRIBE_TYPES_H
#define DESCRIBE_TYPES_H

#include <cjson/cJSON.h>
#include <clang-c/Index.h>

/* Returns {"name", "pointers", "const", "count", "c"}. "pointers" counts the stars, "const" says that what is pointed
 * to stays as it is, "count" is that of an array; the ones that don't apply are absent. A pointer to a function without
 * a typedef has "callback" instead of a name, with the parameters' names of `declaration`, which may be null. */
cJSON* type_to_json(CXType type, CXCursor declaration);
/* Returns {"returns", "parameters"} of a function type; the names are those of the cursor's parameters. */
cJSON* signature_to_json(CXCursor cursor, CXType function);
/* Returns a cursor's name; free it. */
char* cursor_name(CXCursor cursor);

#endif
