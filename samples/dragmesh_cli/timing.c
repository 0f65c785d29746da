/* Reads clocks and sorts measurements. */
#include "timing.h"

#include <stdlib.h>

double timing_now_ns(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static int by_value(const void* a, const void* b) {
    const double left = *(const double*)a, right = *(const double*)b;
    return left < right ? -1 : left > right;
}

void timing_sort(double* values, size_t count) {
    qsort(values, count, sizeof *values, by_value);
}
