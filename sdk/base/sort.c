/* Least-significant-digit radix sort of floats by their bits: three passes of 11 bits, which cover a float. */
#include "base/sort.h"

#include <string.h>

#define DIGIT 11 /* bits; 2048 counters fit the first-level cache */
#define BUCKETS (1u << DIGIT)

/* Maps floats to unsigned integers of the same order: inverts all bits of negative ones, the sign bit of others. */
static uint32_t key_of(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits ^ ((0u - (bits >> 31)) | 0x80000000u);
}

static uint32_t digit_of(float value, int pass) {
    return key_of(value) >> (DIGIT * pass) & (BUCKETS - 1);
}

static void sort_by_digit(const float* from, uint32_t count, int pass, float* to) {
    uint32_t place[BUCKETS] = {0}, before = 0;
    for (uint32_t i = 0; i < count; i++) place[digit_of(from[i], pass)]++;
    for (uint32_t b = 0; b < BUCKETS; b++) {
        const uint32_t size = place[b];
        place[b] = before;
        before += size;
    }
    for (uint32_t i = 0; i < count; i++) to[place[digit_of(from[i], pass)]++] = from[i];
}

void dmi_sort_floats(float* values, uint32_t count, float* spare) {
    sort_by_digit(values, count, 0, spare);
    sort_by_digit(spare, count, 1, values);
    sort_by_digit(values, count, 2, spare);
    memcpy(values, spare, count * sizeof *values);
}
