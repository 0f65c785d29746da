/* Defines what programs need beside stat.c. */
#include "pin.h"

#include <stddef.h>

PIN(hypot);
PIN(__libc_start_main);

typedef int main_function(int, char**, char**);

double pinned_hypot(double x, double y);
int pinned___libc_start_main(main_function* run, int count, char** values, void (*begin)(void), void (*end)(void),
                             void (*unload)(void), void* stack_end);

double __wrap_hypot(double x, double y);
int __wrap___libc_start_main(main_function* run, int count, char** values, void (*begin)(void), void (*end)(void),
                             void (*unload)(void), void* stack_end);

double __wrap_hypot(double x, double y) {
    return pinned_hypot(x, y);
}

/* Starts a program. Since glibc 2.34, crt1.o leaves the program's constructors to the C library; before, it named a
 * function that ran them. Programs in C have none, so neither side needs to. */
int __wrap___libc_start_main(main_function* run, int count, char** values, void (*begin)(void), void (*end)(void),
                             void (*unload)(void), void* stack_end) {
    (void)begin, (void)end;
    return pinned___libc_start_main(run, count, values, NULL, NULL, unload, stack_end);
}
