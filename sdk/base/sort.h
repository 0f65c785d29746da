/* Sorting of floats in linear time, and binary search by id in records sorted by ascending id. */
#ifndef DMI_BASE_SORT_H
#define DMI_BASE_SORT_H

#include <stddef.h>
#include <stdint.h>

/* Sorts ascending; infinities are allowed, NaN is not. spare: scratch of `count` floats. */
void dmi_sort_floats(float* values, uint32_t count, float* spare);

/* Returns the index of the record, or -1. first: the id of record 0; stride: bytes from one record's id to the next's.
 */
static inline int32_t dmi_find_id(const uint32_t* first, size_t stride, uint32_t count, uint32_t id) {
    const char* ids = (const char*)first;
    uint32_t low = 0, high = count;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (*(const uint32_t*)(ids + middle * stride) < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && *(const uint32_t*)(ids + low * stride) == id ? (int32_t)low : -1;
}

#endif
