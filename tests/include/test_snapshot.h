/* Checksums of changed saved drags, set right as someone would who means harm. */
#ifndef TEST_SNAPSHOT_H
#define TEST_SNAPSHOT_H

#include <stdint.h>
#include <string.h>

/* Bytes of a saved drag (plugin_api/src/api_snapshot.c): where its checksum lies, and from where on it counts. */
enum { TEST_SNAPSHOT_CHECKSUM_AT = 24, TEST_SNAPSHOT_CHECKED_FROM = 32 };

/* Computes the checksum anew, as dm_drag_save does, and stores it. */
static inline void test_snapshot_sign(uint8_t* saved, size_t size) {
    uint64_t sum = 0xcbf29ce484222325u, word;
    size_t i = TEST_SNAPSHOT_CHECKED_FROM;
    for (; i + sizeof word <= size; i += sizeof word) {
        memcpy(&word, saved + i, sizeof word);
        sum = (sum ^ word) * 0x100000001b3u;
        sum ^= sum >> 32;
    }
    for (; i < size; i++) sum = (sum ^ saved[i]) * 0x100000001b3u;
    memcpy(saved + TEST_SNAPSHOT_CHECKSUM_AT, &sum, sizeof sum);
}

#endif
