/* What measures the library's calls: clocks, and measurements in order. */
#ifndef CLI_TIMING_H
#define CLI_TIMING_H

#include <stddef.h>
#include <time.h>

double timing_now_ns(clockid_t clock);
/* The least first. */
void timing_sort(double* values, size_t count);

#endif
