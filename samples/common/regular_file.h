/* Opens files that end. */
#ifndef SAMPLES_REGULAR_FILE_H
#define SAMPLES_REGULAR_FILE_H

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

/* Opens a regular file for reading; NULL with errno set. Pipes and devices, which may never end, are no files: EINVAL.
 * A folder: EISDIR. */
static inline FILE* open_regular_file(const char* path) {
    struct stat info = {0};
    const int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* a pipe without a writer opens too */
    if (descriptor < 0) return NULL;
    if (fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode)) return fdopen(descriptor, "rb");
    close(descriptor);
    errno = S_ISDIR(info.st_mode) ? EISDIR : EINVAL;
    return NULL;
}

#endif
