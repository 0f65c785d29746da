/* Whole files. */
#include "files.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli.h"

static char* read_all(FILE* file, size_t* out_size) {
    size_t size = 0, room = 1 << 16;
    char* bytes = cli_alloc(room);
    for (;;) {
        size += fread(bytes + size, 1, room - 1 - size, file);
        if (size < room - 1) break;
        room *= 2;
        bytes = cli_grow(bytes, room);
    }
    bytes[size] = 0;
    *out_size = size;
    if (!ferror(file)) return bytes;
    free(bytes);
    return NULL;
}

char* file_read(const char* path, size_t* out_size) {
    if (strcmp(path, "-") == 0) return read_all(stdin, out_size);
    struct stat info;
    if (stat(path, &info) == 0 && S_ISDIR(info.st_mode)) {
        errno = EISDIR;
        return NULL;
    }
    FILE* file = fopen(path, "rb");
    if (file == NULL) return NULL;
    char* bytes = read_all(file, out_size);
    const int reason = errno;
    fclose(file);
    errno = reason;
    return bytes;
}

int file_write(const char* path, const void* data, size_t size) {
    FILE* file = fopen(path, "wb");
    if (file == NULL) return -1;
    const bool wrote = fwrite(data, 1, size, file) == size;
    return fclose(file) == 0 && wrote ? 0 : -1;
}

bool file_exists(const char* path) {
    struct stat info;
    return stat(path, &info) == 0;
}

char* path_join(const char* folder, const char* name) {
    const size_t size = strlen(folder) + strlen(name) + 2;
    char* path = cli_alloc(size);
    snprintf(path, size, "%s/%s", folder, name);
    return path;
}
