/* Files that belong together: the disk has all of them before the first one takes its place. */
#ifndef CLI_FILE_SET_H
#define CLI_FILE_SET_H

#include "output_file.h"
#include "session.h"

typedef struct file_set_item {
    char* path;
    output_file file; /* sealed */
} file_set_item;

typedef struct file_set {
    session* session; /* gets the errors */
    file_set_item* items;
    int count;
} file_set;

/* Brings a file to the disk, beside its place. */
dm_result file_set_add(file_set* set, const char* path, const void* data, size_t size);
/* Puts all files into their places, in the order in which they were added. */
dm_result file_set_publish(file_set* set);
/* Removes what was not published. */
void file_set_free(file_set* set);

#endif
