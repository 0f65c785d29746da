/* Clocks, sorting of measurements, and what they were measured on. */
#ifndef CLI_TIMING_H
#define CLI_TIMING_H

#include <stddef.h>
#include <time.h>

double timing_now_ns(clockid_t clock);
/* Sorts ascending. */
void timing_sort(double* values, size_t count);
/* Returns the widest instruction set of this machine that the library has kernels for: "avx512", "avx2" … */
const char* timing_isa(void);

#endif
