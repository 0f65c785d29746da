/* Whole files. */
#include "files.h"

#include <stdlib.h>
#include <string.h>

#include "../common/platform.h"

void* take(size_t count, size_t size) {
    void* memory = calloc(count ? count : 1, size);
    if (memory != NULL) return memory;
    fprintf(stderr, "viewer: out of memory\n");
    exit(1);
}

char* file_read(const char* path, size_t* out_size) {
    FILE* file = platform_open_regular(path);
    if (file == NULL) return NULL;
    char* bytes = NULL;
    if (fseek(file, 0, SEEK_END) == 0) {
        const long size = ftell(file);
        rewind(file);
        if (size >= 0) bytes = take((size_t)size + 1, 1);
        if (bytes != NULL && fread(bytes, 1, (size_t)size, file) != (size_t)size) {
            free(bytes);
            bytes = NULL;
        }
        *out_size = (size_t)size;
    }
    fclose(file);
    return bytes;
}

char* path_with_ending(const char* path, const char* ending) {
    const char* slash = strrchr(path, '/');
    const char* dot = strrchr(slash != NULL ? slash : path, '.');
    const size_t stem = dot != NULL ? (size_t)(dot - path) : strlen(path);
    const size_t size = stem + strlen(ending) + 1;
    char* out = take(size, 1);
    snprintf(out, size, "%.*s%s", (int)stem, path, ending);
    return out;
}

char* path_join(const char* folder, const char* name) {
    const size_t size = strlen(folder) + strlen(name) + 2;
    char* path = take(size, 1);
    snprintf(path, size, "%s/%s", folder, name);
    return path;
}
