/* Reads clocks, sorts measurements, names the instruction set. */
#include "timing.h"

#include <stdlib.h>

#include "platform.h"

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

const char* timing_isa(void) {
#if defined(__x86_64__)
    if (PLATFORM_CPU_HAS("avx512f") && PLATFORM_CPU_HAS("avx512bw") && PLATFORM_CPU_HAS("avx512dq") &&
        PLATFORM_CPU_HAS("avx512vl"))
        return "avx512";
    return PLATFORM_CPU_HAS("avx2") && PLATFORM_CPU_HAS("fma") ? "avx2" : "sse2";
#elif defined(__aarch64__)
    return "neon";
#else
    return "scalar";
#endif
}
