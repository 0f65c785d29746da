/* A file that appears whole or not at all. */
#include "output_file.h"

#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "platform.h"

enum { PATH_ROOM = 4096, LINKS_MOST = 40, PARTS_MOST = 8 }; /* Linux' PATH_MAX and its most links; by hand */

/* ---- what is left when the program ends ---- */

/* Paths of parts that are not yet in their places; those beyond PARTS_MOST stay where the program is ended. */
static char* volatile parts[PARTS_MOST];

static void remove_parts(void) {
    for (int i = 0; i < PARTS_MOST; i++) {
        if (parts[i] != NULL) platform_remove(parts[i]);
    }
}

static void end_by_signal(int number) {
    remove_parts();
    signal(number, SIG_DFL);
    raise(number);
}

/* Handles a signal that nobody else does. */
static void handle(int number, void (*handler)(int)) {
    void (*before)(int) = signal(number, handler);
    if (before != SIG_DFL) signal(number, before);
}

/* A limit on the size of files (SIGXFSZ) is an error of the write, as a full disk is. */
static void handle_signals(void) {
    static bool done;
    if (done) return;
    done = true;
    atexit(remove_parts);
    handle(SIGINT, end_by_signal);
    handle(SIGTERM, end_by_signal);
#ifdef SIGHUP
    handle(SIGHUP, end_by_signal);
#endif
#ifdef SIGXFSZ
    handle(SIGXFSZ, SIG_IGN);
#endif
}

static void remember(char* part) {
    for (int i = 0; i < PARTS_MOST; i++) {
        if (parts[i] != NULL) continue;
        parts[i] = part;
        return;
    }
}

static void forget(output_file* file) {
    for (int i = 0; i < PARTS_MOST; i++) {
        if (parts[i] == file->part) parts[i] = NULL;
    }
    free(file->part);
    file->part = NULL;
}

/* ---- where it goes ---- */

/* Returns how many characters of a path are its folder, with the separator. */
static size_t folder_length(const char* path) {
    size_t length = strlen(path);
    while (length > 0 && !platform_is_separator(path[length - 1])) length--;
    return length;
}

static bool begins(const char* text, const char* with) {
    return strncmp(text, with, strlen(with)) == 0;
}

/* Whether the path names something that is open already, which a rename would not reach. */
static bool names_open_file(const char* path) {
    return begins(path, "/proc/") || begins(path, "/dev/fd/");
}

/* Returns the descriptor of this program that the path names; -1: none. */
static int named_descriptor(const char* path) {
    static const char* const folders[] = {"/proc/self/fd/", "/dev/fd/"};
    for (int i = 0; i < 2; i++) {
        char* end;
        const char* text = path + strlen(folders[i]);
        if (!begins(path, folders[i])) continue;
        const long number = strtol(text, &end, 10);
        if (end != text && *end == 0 && number >= 0 && number < 1 << 20) return (int)number;
    }
    return -1;
}

/* Replaces a path by what the link there names, until it is no link; false with errno set where there is no end. */
static bool follow_links(char path[PATH_ROOM]) {
    char to[PATH_ROOM];
    for (int i = 0; i < LINKS_MOST; i++) {
        if (names_open_file(path) || !platform_read_link(path, to, sizeof to)) return true;
        const size_t folder = platform_is_separator(to[0]) ? 0 : folder_length(path);
        if (folder + strlen(to) >= PATH_ROOM) {
            errno = ENAMETOOLONG;
            return false;
        }
        memcpy(path + folder, to, strlen(to) + 1);
    }
    errno = ELOOP;
    return false;
}

/* ---- writing ---- */

static int open_stream(output_file* file, const char* path) {
    const int descriptor = named_descriptor(path);
    fflush(stdout); /* what was printed comes first where both go to one place */
    file->stream = descriptor >= 0 ? platform_duplicate(descriptor) : platform_open(path, "wb");
    return file->stream != NULL ? 0 : -1;
}

/* Creates the part under a name that no other has: those of other programs have another process id, or are there. */
static int open_part(output_file* file) {
    static unsigned count;
    const size_t folder = folder_length(file->target), size = folder + 64;
    file->part = malloc(size);
    do {
        if (file->part == NULL) return -1;
        snprintf(file->part, size, "%.*s.dragmesh-%ld-%u", (int)folder, file->target, platform_process(), count++);
        file->stream = platform_create(file->part);
    } while (file->stream == NULL && errno == EEXIST);
    if (file->stream == NULL) {
        free(file->part);
        file->part = NULL;
        return -1;
    }
    remember(file->part);
    return 0;
}

static int open_beside(output_file* file, const char* path, bool exists) {
    if (exists && !platform_may_write(path)) return -1;
    file->target = malloc(strlen(path) + 1);
    if (file->target == NULL) return -1;
    memcpy(file->target, path, strlen(path) + 1);
    if (open_part(file) != 0) return -1;
    if (exists) platform_copy_mode(file->target, file->stream);
    return 0;
}

bool output_is_stream(const char* path) {
    char followed[PATH_ROOM];
    const size_t size = strlen(path) + 1;
    if (size > PATH_ROOM) return false;
    memcpy(followed, path, size);
    return follow_links(followed) && (names_open_file(followed) || platform_kind_of(followed) == PLATFORM_STREAM);
}

static int open_at(output_file* file, const char* path) {
    char followed[PATH_ROOM];
    const size_t size = strlen(path) + 1;
    if (size > PATH_ROOM) errno = ENAMETOOLONG;
    if (size > PATH_ROOM) return -1;
    memcpy(followed, path, size);
    if (!follow_links(followed)) return -1;
    const enum platform_kind kind = platform_kind_of(followed);
    if (kind == PLATFORM_FOLDER) errno = EISDIR;
    if (kind == PLATFORM_FOLDER) return -1;
    if (kind == PLATFORM_STREAM || names_open_file(followed)) return open_stream(file, followed);
    return open_beside(file, followed, kind == PLATFORM_FILE);
}

int output_open(output_file* file, const char* path) {
    handle_signals();
    *file = (output_file){.stream = NULL};
    const int status = open_at(file, path);
    if (status != 0) output_discard(file);
    return status;
}

static void note_failure(output_file* file) {
    if (file->error == 0) file->error = errno != 0 ? errno : EIO;
}

void output_put(output_file* file, const void* data, size_t size) {
    if (size > 0 && fwrite(data, 1, size, file->stream) != size) note_failure(file);
}

void output_print(output_file* file, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    if (vfprintf(file->stream, format, arguments) < 0) note_failure(file);
    va_end(arguments);
}

/* Closes the stream and returns what went wrong with it since it was opened, as an errno. */
static int close_stream(output_file* file) {
    int error = file->error;
    errno = 0;
    if (fflush(file->stream) != 0 && error == 0) error = errno;
    if (error == 0 && file->part != NULL && platform_sync(file->stream) != 0) error = errno;
    if (fclose(file->stream) != 0 && error == 0) error = errno;
    file->stream = NULL;
    return error;
}

int output_seal(output_file* file) {
    const int error = close_stream(file);
    if (error == 0) return 0;
    output_discard(file);
    errno = error;
    return -1;
}

int output_publish(output_file* file) {
    int status = 0;
    if (file->part != NULL) {
        status = platform_replace(file->part, file->target);
        if (status == 0) forget(file);
    }
    output_discard(file);
    return status;
}

void output_discard(output_file* file) {
    const int error = errno;
    if (file->stream != NULL) fclose(file->stream);
    file->stream = NULL;
    if (file->part != NULL) {
        platform_remove(file->part);
        forget(file);
    }
    free(file->target);
    file->target = NULL;
    errno = error;
}

int output_close(output_file* file) {
    return output_seal(file) == 0 ? output_publish(file) : -1;
}

int output_write(const char* path, const void* data, size_t size) {
    output_file file;
    if (output_open(&file, path) != 0) return -1;
    output_put(&file, data, size);
    return output_close(&file);
}

int output_write_all(const output_bytes* files, int count, int* out_failed) {
    output_file opened[OUTPUT_TOGETHER];
    int status = 0, sealed = 0;
    for (int i = 0; i < count && status == 0; i++) {
        *out_failed = i;
        status = output_open(&opened[i], files[i].path);
        if (status != 0) break;
        output_put(&opened[i], files[i].data, files[i].size);
        status = output_seal(&opened[i]);
        sealed = i + 1;
    }
    for (int i = 0; i < sealed; i++) {
        if (status == 0) *out_failed = i;
        if (status == 0)
            status = output_publish(&opened[i]);
        else
            output_discard(&opened[i]);
    }
    return status;
}
