#include "text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void text_fail(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fputs("describe: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

void* text_alloc(size_t size) {
    void* memory = malloc(size);
    if (memory == NULL) text_fail("no memory");
    return memory;
}
