/* Hash of everything that a generated object consists of. */
#ifndef DM_TEST_OBJECT_HASH_H
#define DM_TEST_OBJECT_HASH_H

#include "generator.h"
#include "test_hash.h"

static inline uint64_t test_hash_object(uint64_t hash, const dmg_object* o) {
    hash = test_hash_bytes(hash, o->positions, (size_t)o->vertex_count * 3 * sizeof(float));
    hash = test_hash_bytes(hash, o->indices, (size_t)o->face_count * 3 * sizeof(uint32_t));
    hash = test_hash_bytes(hash, o->face_part, (size_t)o->face_count * sizeof(uint32_t));
    return test_hash_bytes(hash, o->joints, o->joint_count * sizeof *o->joints);
}

#endif
