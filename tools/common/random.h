/* Seeded random numbers of the tool (splitmix64): the same on every machine. */
#ifndef CLI_RANDOM_H
#define CLI_RANDOM_H

#include <math.h>
#include <stdint.h>

#include "constants.h"

typedef struct random_state {
    uint64_t state;
} random_state;

static inline uint64_t random_u64(random_state* random) {
    uint64_t z = random->state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}
/* [0, 1). */
static inline double random_unit(random_state* random) {
    return (double)(random_u64(random) >> 11) * 0x1p-53;
}
/* Standard normal (Box-Muller). */
static inline double random_normal(random_state* random) {
    const double radius = sqrt(-2 * log(1 - random_unit(random)));
    return radius * cos(TWO_PI * random_unit(random));
}

#endif
