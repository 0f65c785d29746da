/* One public header as JSON. */
#ifndef DESCRIBE_HEADER_H
#define DESCRIBE_HEADER_H

#include <cjson/cJSON.h>
#include <clang-c/Index.h>

/* Adds what the header declares to the lists of `api`: constants, enums, types, structs, functions. Ends the program
 * where a function does not state its threading tag. */
void header_describe(CXTranslationUnit unit, const char* path, const char* name, cJSON* api);

#endif
