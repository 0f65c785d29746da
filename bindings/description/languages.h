/* The description in other languages. Each function returns the text of a source file; free it. */
#ifndef DESCRIBE_LANGUAGES_H
#define DESCRIBE_LANGUAGES_H

#include <cjson/cJSON.h>

/* Blittable structs, delegates, constants and P/Invoke declarations of C# 7. */
char* csharp_write(const cJSON* api);
/* A class of C# that compares the layout of these structs with the description at run time. */
char* csharp_layout_write(const cJSON* api);
/* Structs, constants and extern blocks of Rust, and tests of the layout. */
char* rust_write(const cJSON* api);
/* ctypes structs, constants and prototypes of Python. */
char* python_write(const cJSON* api);
/* Assertions of C++17 that the header at hand is the described one. */
char* cpp_write(const cJSON* api);

#endif
