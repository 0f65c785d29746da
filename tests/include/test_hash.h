/* FNV-1a, to compare what must be the same to the bit. */
#ifndef DM_TEST_HASH_H
#define DM_TEST_HASH_H

#include <stddef.h>
#include <stdint.h>

#define TEST_HASH_START 0xcbf29ce484222325u
#define TEST_HASH_PRIME 0x100000001b3u

/* Goes on with a hash; the first one is TEST_HASH_START. */
static inline uint64_t test_hash_bytes(uint64_t hash, const void* data, size_t size) {
    const uint8_t* bytes = data;
    for (size_t i = 0; i < size; i++) hash = (hash ^ bytes[i]) * TEST_HASH_PRIME;
    return hash;
}

#endif
