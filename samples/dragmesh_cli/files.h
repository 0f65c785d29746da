/* Whole files. */
#ifndef CLI_FILES_H
#define CLI_FILES_H

#include <stdbool.h>
#include <stddef.h>

/* The bytes, with a NUL behind them, to be freed; NULL with errno set. "-" is standard input. */
char* file_read(const char* path, size_t* out_size);
/* 0, or -1 with errno set. */
int file_write(const char* path, const void* data, size_t size);
bool file_exists(const char* path);
/* folder/name, to be freed. */
char* path_join(const char* folder, const char* name);

#endif
