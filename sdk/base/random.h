/* Seeded random numbers (PCG32), the same on every machine. */
#ifndef DMI_BASE_RANDOM_H
#define DMI_BASE_RANDOM_H

#include <stdint.h>

typedef struct dmi_random {
    uint64_t state, increment;
} dmi_random;

dmi_random dmi_random_make(uint64_t seed, uint64_t stream);
uint32_t dmi_random_u32(dmi_random* random);
/* Uniform in [0, 1), 24 bits. */
float dmi_random_unit(dmi_random* random);
/* Standard normal distribution. */
float dmi_random_normal(dmi_random* random);

#endif
