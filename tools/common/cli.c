/* Memory and the clock of the tools. */
#include "cli.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "timing.h"

void* cli_grow(void* memory, size_t size) {
    void* grown = realloc(memory, size > 0 ? size : 1);
    if (grown != NULL) return grown;
    fprintf(stderr, "dragmesh: no memory for %zu bytes\n", size);
    exit(CLI_FAILED);
}

void* cli_grow_list(void* items, size_t count, size_t* room, size_t item_size) {
    enum { FIRST_ROOM = 1024 };
    if (count < *room) return items;
    *room = *room ? 2 * *room : FIRST_ROOM;
    return cli_grow(items, *room * item_size);
}

void* cli_alloc(size_t size) {
    return cli_grow(NULL, size);
}

void* cli_alloc_zeroed(size_t size) {
    void* memory = cli_alloc(size);
    memset(memory, 0, size);
    return memory;
}

char* cli_copy_text(const char* text) {
    const size_t size = strlen(text) + 1;
    char* copy = cli_alloc(size);
    memcpy(copy, text, size);
    return copy;
}

double cli_now_ms(void) {
    return 1e-6 * timing_now_ns(CLOCK_MONOTONIC);
}
