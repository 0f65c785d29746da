/* The description as C without a preprocessor. */
#ifndef DESCRIBE_FFI_H
#define DESCRIBE_FFI_H

#include <cjson/cJSON.h>

/* Returns the text of a header that has no directives, for tools that read C declarations (LuaJIT's ffi.cdef, cffi);
 * they know size_t and the fixed-width integers. Free it. */
char* ffi_write(const cJSON* api);

#endif
