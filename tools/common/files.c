/* Whole files. */
#include "files.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "platform.h"

#define STREAM_MOST ((size_t)1 << 30) /* bytes that are read of a stream; by hand */

const char* file_problem(void) {
    return errno == EINVAL ? "it is a pipe or a device, not a file" : strerror(errno);
}

static char* read_all(FILE* file, size_t* out_size) {
    size_t size = 0, room = 1 << 16;
    char* bytes = cli_alloc(room);
    for (;;) {
        size += fread(bytes + size, 1, room - 1 - size, file);
        if (size < room - 1) break;
        if (room > STREAM_MOST) {
            free(bytes);
            errno = EFBIG;
            return NULL;
        }
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
    FILE* file = platform_open_regular(path);
    if (file == NULL) return NULL;
    char* bytes = read_all(file, out_size);
    const int reason = errno;
    fclose(file);
    errno = reason;
    return bytes;
}

enum file_line file_read_line(FILE* file, char** line, size_t* room, size_t* out_length) {
    size_t length = 0;
    int c;
    while ((c = platform_getc(file)) != EOF && c != '\n') {
        if (length == LINE_MOST) return LINE_TOO_LONG;
        if (length + 1 >= *room) *line = cli_grow(*line, *room = *room ? 2 * *room : BUFSIZ);
        (*line)[length++] = (char)c;
    }
    if (c == EOF && length == 0) return LINE_NONE;
    if (*line == NULL) *line = cli_grow(NULL, *room = BUFSIZ);
    (*line)[length] = 0;
    *out_length = length;
    return LINE_READ;
}

char* path_join(const char* folder, const char* name) {
    const size_t size = strlen(folder) + strlen(name) + 2;
    char* path = cli_alloc(size);
    snprintf(path, size, "%s/%s", folder, name);
    return path;
}
