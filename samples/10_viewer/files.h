/* Reading of whole files; samples/common/output_file.h writes them. */
#ifndef VIEWER_FILES_H
#define VIEWER_FILES_H

#include <stddef.h>

/* A file's bytes and a zero after them, to be freed; NULL with errno set. */
char* file_read(const char* path, size_t* out_size);

/* Adds or takes the ending: path_with_ending("a/b.glb", ".dmo") = "a/b.dmo", to be freed. */
char* path_with_ending(const char* path, const char* ending);

/* folder/name, to be freed. */
char* path_join(const char* folder, const char* name);

/* Allocates, or ends the program: enough for a sample. */
void* take(size_t count, size_t size);

#endif
