/* Saved drags that someone changed who means harm: what they are drags of, and checksums set right. */
#ifndef TEST_SNAPSHOT_H
#define TEST_SNAPSHOT_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "dragmesh/dragmesh.h"

/* Rules of every kind, for a drag whose saved state has all that it can have. */
static inline dm_drag_rules test_every_rule(void) {
    static const float snaps[2] = {0.2f, 0.9f};
    return (dm_drag_rules){.struct_size = sizeof(dm_drag_rules),
                           .flags = DM_RULE_LATCH,
                           .snaps = snaps,
                           .snap_count = 2,
                           .event_time = 0.1f,
                           .max_speed = 3,
                           .max_acceleration = 30,
                           .auto_close_share = 0.1f,
                           .close_delay = 0.1f,
                           .tip_share = 0.5f,
                           .restitution = 0.3f,
                           .break_distance = 3};
}

/* Whether a drag's state holds nothing but numbers. */
static inline bool test_state_is_finite(const dm_drag_state* now) {
    float sum = now->value + now->target + now->velocity + now->impact;
    sum += now->grab_point.x + now->grab_point.y + now->grab_point.z;
    for (int i = 0; i < 4; i++) sum += now->pose.real[i] + now->pose.dual[i];
    return isfinite(sum);
}

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
