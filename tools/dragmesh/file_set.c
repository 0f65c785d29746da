/* Files that belong together. */
#include "file_set.h"

#include <stdlib.h>

dm_result file_set_add(file_set* set, const char* path, const void* data, size_t size) {
    output_file file;
    int status = output_open(&file, path);
    if (status == 0) {
        output_put(&file, data, size);
        status = output_seal(&file);
    }
    if (status != 0) return session_fail_to_write(set->session, path);
    set->items = cli_grow(set->items, (size_t)(set->count + 1) * sizeof *set->items);
    set->items[set->count++] = (file_set_item){.path = cli_copy_text(path), .file = file};
    return DM_OK;
}

dm_result file_set_publish(file_set* set) {
    for (int i = 0; i < set->count; i++)
        if (output_publish(&set->items[i].file) != 0) return session_fail_to_write(set->session, set->items[i].path);
    return DM_OK;
}

void file_set_free(file_set* set) {
    for (int i = 0; i < set->count; i++) {
        output_discard(&set->items[i].file);
        free(set->items[i].path);
    }
    free(set->items);
    *set = (file_set){.session = set->session};
}
