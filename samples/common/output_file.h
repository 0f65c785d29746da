/* A file that appears whole or not at all. It is written under a name of its own beside its place and renamed when it
 * is complete, so that whatever fails or ends the program, the file that was there before is still there. */
#ifndef SAMPLES_OUTPUT_FILE_H
#define SAMPLES_OUTPUT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "platform.h"

typedef struct output_file {
    FILE* stream; /* takes the content; NULL when it is not open, or no longer */
    char* target; /* path of the file, links followed; NULL where it is a pipe or a device, which is written at once */
    char* part;   /* path of what becomes that file; NULL once it has */
    int error;    /* errno of the first addition that failed; 0: none */
} output_file;

/* Whether the path names a pipe, a device, or what the program has open: written at once, there is nothing to keep. */
bool output_is_stream(const char* path);
/* Opens a file for writing. Returns 0, or -1 with errno set, also where it is a folder or may not be written. */
int output_open(output_file* file, const char* path);
/* Add bytes, or text as printf makes it; a failure shows in output_seal. */
void output_put(output_file* file, const void* data, size_t size);
void output_print(output_file* file, const char* format, ...) PLATFORM_PRINTF(2, 3);
/* Brings all of it to the disk and closes it. Returns 0, or -1 with errno set, and then nothing of it is left. */
int output_seal(output_file* file);
/* Puts a sealed file into its place. Returns as output_seal. Files that belong together are all sealed before the first
 * of them is published. */
int output_publish(output_file* file);
/* Removes what was written. Allowed at any time, and after a failure. */
void output_discard(output_file* file);

/* Seals and publishes. */
int output_close(output_file* file);
/* Writes a whole file. Returns 0, or -1 with errno set. */
int output_write(const char* path, const void* data, size_t size);

typedef struct output_bytes {
    const char* path;
    const void* data;
    size_t size;
} output_bytes;
enum { OUTPUT_TOGETHER = 4 }; /* most files that output_write_all writes */
/* Writes files that belong together: the disk has all of them before the first one takes its place. Returns 0, or -1
 * with errno set and *out_failed the index of the file that could not be written. Nothing has changed then, unless what
 * failed is a rename after the first. */
int output_write_all(const output_bytes* files, int count, int* out_failed);

#endif
