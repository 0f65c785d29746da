/* Loaded before the C library (LD_PRELOAD): makes one step of writing a file fail. FAIL_STEP is open, write, flush,
 * sync, rename, close, or wait, which stays in the step sync until a signal comes; FAIL_FILE is which of the files that
 * the program creates, from 1. Only the files that output_file.c creates beside their places count. */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum { WRITABLE = 100 }; /* bytes of a file before its writes fail */

static int created, failing = -1; /* files so far; descriptor of the one that fails */
static char failing_path[4096];

static bool step_is(const char* name) {
    const char* step = getenv("FAIL_STEP");
    return step != NULL && strcmp(step, name) == 0;
}

static bool is_next(void) {
    const char* number = getenv("FAIL_FILE");
    return ++created == (number != NULL ? atoi(number) : 1);
}

/* Finds the C library's own function. */
#define NEXT(type, name, ...)                                                                                          \
    type (*next)(__VA_ARGS__);                                                                                         \
    *(void**)(&next) = dlsym(RTLD_NEXT, name)

int open(const char* path, int flags, ...) {
    NEXT(int, "open", const char*, int, ...);
    va_list list;
    va_start(list, flags);
    const int mode = flags & O_CREAT ? va_arg(list, int) : 0;
    va_end(list);
    const bool fails = (flags & O_EXCL) && strstr(path, ".dragmesh-") != NULL && is_next();
    if (fails && step_is("open")) {
        errno = EDQUOT;
        return -1;
    }
    const int descriptor = next(path, flags, mode);
    if (!fails) return descriptor;
    failing = descriptor;
    snprintf(failing_path, sizeof failing_path, "%s", path);
    if (step_is("write")) setrlimit(RLIMIT_FSIZE, &(struct rlimit){WRITABLE, WRITABLE});
    return descriptor;
}

int fflush(FILE* file) {
    NEXT(int, "fflush", FILE*);
    const int result = next(file);
    if (file == NULL || fileno(file) != failing || failing < 0 || !step_is("flush")) return result;
    errno = EDQUOT;
    return -1;
}

int fsync(int descriptor) {
    NEXT(int, "fsync", int);
    if (descriptor == failing && step_is("wait")) {
        fputs("waits\n", stderr);
        for (;;) pause();
    }
    if (descriptor != failing || !step_is("sync")) return next(descriptor);
    errno = EDQUOT;
    return -1;
}

int fclose(FILE* file) {
    NEXT(int, "fclose", FILE*);
    const bool fails = fileno(file) == failing && failing >= 0 && step_is("close");
    const int result = next(file);
    if (!fails) return result;
    failing = -1;
    errno = EDQUOT;
    return EOF;
}

int rename(const char* from, const char* to) {
    NEXT(int, "rename", const char*, const char*);
    if (strcmp(from, failing_path) != 0 || !step_is("rename")) return next(from, to);
    errno = EDQUOT;
    return -1;
}
