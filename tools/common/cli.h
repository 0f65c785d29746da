/* Exit statuses, memory and the clock of the tools. */
#ifndef CLI_H
#define CLI_H

#include <stddef.h>

/* Exit statuses: the contract of the tools. */
enum { CLI_OK = 0, CLI_FAILED = 1, CLI_USAGE = 2 };
/* Of a command that has printed its help, in place of an exit status; the tool exits with CLI_OK then. */
enum { CLI_HELPED = -1 };

/* Memory of a tool: ends the program with a message when there is none. free() releases it. */
void* cli_alloc(size_t size);
void* cli_alloc_zeroed(size_t size);
char* cli_copy_text(const char* text);
void* cli_grow(void* memory, size_t size);
/* Returns `items`, moved to twice the room where its *room items are all taken. */
void* cli_grow_list(void* items, size_t count, size_t* room, size_t item_size);

double cli_now_ms(void);

#endif
