/* The bytes of a fuzz input, read as whatever is asked for; zeros when they have run out. */
#ifndef DM_FUZZ_INPUT_H
#define DM_FUZZ_INPUT_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "dragmesh/dragmesh.h"

typedef struct fuzz_input {
    const uint8_t* data;
    size_t size;
} fuzz_input;

static inline uint8_t fuzz_byte(fuzz_input* in) {
    if (in->size == 0) return 0;
    in->size--;
    return *in->data++;
}

static inline uint32_t fuzz_word(fuzz_input* in) {
    uint32_t word = 0;
    for (int i = 0; i < 4; i++) word |= (uint32_t)fuzz_byte(in) << 8 * i;
    return word;
}

/* From 0 to count - 1. */
static inline uint32_t fuzz_below(fuzz_input* in, uint32_t count) {
    return fuzz_byte(in) % count;
}

static inline bool fuzz_one_in(fuzz_input* in, uint32_t count) {
    return fuzz_below(in, count) == count - 1;
}

/* Mostly from -2 to 2; now and then one at which checks break, or any bits. */
static inline float fuzz_number(fuzz_input* in) {
    static const float edges[] = {0,     -0.0f, 1,       -1,       1e-30f,     1e-45f,      1e9f, 1e10f,    -1e10f,
                                  1e19f, 1e30f, 3.4e38f, -3.4e38f, 6.2831853f, 16777216.0f, NAN,  INFINITY, -INFINITY};
    const uint8_t kind = fuzz_byte(in);
    if (kind < 200) return ((float)kind - 100) / 50;
    if (kind < 240) return (float)(int8_t)fuzz_byte(in) / 16;
    if (kind < 252) return edges[fuzz_below(in, sizeof edges / sizeof edges[0])];
    const uint32_t bits = fuzz_word(in);
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static inline dm_vec3 fuzz_vector(fuzz_input* in) {
    const float x = fuzz_number(in), y = fuzz_number(in);
    return (dm_vec3){x, y, fuzz_number(in)};
}

/* The size of a struct, seldom one that no version of it had. */
static inline uint32_t fuzz_struct_size(fuzz_input* in, size_t right) {
    const uint8_t kind = fuzz_byte(in);
    return kind < 250 ? (uint32_t)right : kind - 250u;
}

#endif
