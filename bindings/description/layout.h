/* Sizes and offsets of structs on each ABI. */
#ifndef DESCRIBE_LAYOUT_H
#define DESCRIBE_LAYOUT_H

#include <cjson/cJSON.h>
#include <clang-c/Index.h>

/* Lists the ABIs and their clang targets in `api`, and adds {ABI: {"size", "align", "offsets"}} to each struct of it.
 * Ends the program where two targets of one ABI differ. arguments: for the compiler, without a target. */
void layout_describe(CXIndex index, const char* path, const char* const* arguments, int argument_count, cJSON* api);

#endif
