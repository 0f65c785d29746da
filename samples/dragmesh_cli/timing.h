/* Clocks and sorting of measurements. */
#ifndef CLI_TIMING_H
#define CLI_TIMING_H

#include <stddef.h>
#include <time.h>

double timing_now_ns(clockid_t clock);
/* Sorts ascending. */
void timing_sort(double* values, size_t count);

#endif
