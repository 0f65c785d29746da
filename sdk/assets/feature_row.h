/* A row of numbers that is filled from the front. */
#ifndef DMI_ASSETS_FEATURE_ROW_H
#define DMI_ASSETS_FEATURE_ROW_H

#include <stdint.h>

typedef struct dmi_row {
    float* out;
    uint32_t count;
} dmi_row;

static inline void dmi_put(dmi_row* row, float value) {
    row->out[row->count++] = value;
}

#endif
