/* Chance that belongs to a place: the same wherever the point stands in a list. */
#ifndef DMI_MATH_PLACE_HASH_H
#define DMI_MATH_PLACE_HASH_H

#include <stdint.h>
#include <string.h>

/* Returns 64 bits that look random (the finaliser of SplitMix64). */
static inline uint64_t dmi_scramble(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* Returns 64 bits for the bits of a point's coordinates; -0 counts as 0. */
static inline uint64_t dmi_hash_place(const float point[3]) {
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        const float value = point[k] + 0.0f;
        uint32_t bits;
        memcpy(&bits, &value, sizeof bits);
        hash = dmi_scramble(hash ^ bits);
    }
    return hash;
}

#endif
