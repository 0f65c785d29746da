/* Whole files. */
#ifndef CLI_FILES_H
#define CLI_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* What errno says of a file that could not be opened or read. */
const char* file_problem(void);
/* The bytes, with a NUL behind them, to be freed; NULL with errno set. "-" is standard input, of which a GB is the
 * most: EFBIG. */
char* file_read(const char* path, size_t* out_size);

enum { LINE_MOST = 1 << 24 }; /* bytes of a line; by hand: a job with thousands of names is far shorter */
enum file_line { LINE_READ, LINE_NONE, LINE_TOO_LONG };
/* Reads a line, its end left out, with a NUL behind it. The buffer grows; free it at the end. */
enum file_line file_read_line(FILE* file, char** line, size_t* room, size_t* out_length);
/* folder/name, to be freed. */
char* path_join(const char* folder, const char* name);

#endif
