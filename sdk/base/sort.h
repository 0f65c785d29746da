/* Sorting of floats in linear time. */
#ifndef DMI_BASE_SORT_H
#define DMI_BASE_SORT_H

#include <stdint.h>

/* Sorts ascending; infinities are allowed, NaN is not. spare: scratch of `count` floats. */
void dmi_sort_floats(float* values, uint32_t count, float* spare);

#endif
