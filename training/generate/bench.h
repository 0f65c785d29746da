/* Declares the benchmark of the generator. */
#ifndef GENERATE_BENCH_H
#define GENERATE_BENCH_H

#include <stdint.h>

/* Prints objects a second of each category and of all in turn, on this core, without export. */
int bench(const uint32_t* categories, uint32_t count, uint32_t flags);

#endif
