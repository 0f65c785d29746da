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

char* text_read(const char* path) {
    FILE* file = fopen(path, "rb");
    if (file == NULL) text_fail("%s can't be read", path);
    size_t room = 1 << 20, size = 0;
    char* text = text_alloc(room);
    for (size_t got; (got = fread(text + size, 1, room - 1 - size, file)) > 0;) {
        size += got;
        if (size + 1 == room && (text = realloc(text, room *= 2)) == NULL) text_fail("no memory");
    }
    fclose(file);
    text[size] = 0;
    return text;
}
