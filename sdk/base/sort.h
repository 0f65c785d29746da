/* Numbers in order, in a few passes however they lay. */
#ifndef DMI_BASE_SORT_H
#define DMI_BASE_SORT_H

#include <stdint.h>

/* Rising, infinities included, no NaN; spare: as many floats of scratch. */
void dmi_sort_floats(float* values, uint32_t count, float* spare);

#endif
