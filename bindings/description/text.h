/* Memory of a program that ends where something is wrong. */
#ifndef DESCRIBE_TEXT_H
#define DESCRIBE_TEXT_H

#include <stddef.h>

/* Prints "describe: ..." and ends the program. */
_Noreturn void text_fail(const char* format, ...);
void* text_alloc(size_t size);

#endif
