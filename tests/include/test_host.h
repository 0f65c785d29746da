/* A host for tests: an allocator that counts, checks sizes and fails on demand, and a log that remembers. */
#ifndef DM_TEST_HOST_H
#define DM_TEST_HOST_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragmesh/dragmesh.h"
#include "platform.h"

#define TEST_NEVER (-1)
#define TEST_MAX_ALIGNMENT 64 /* bytes: dm_allocator */

typedef struct test_memory {
    _Atomic int64_t calls;      /* of allocate so far, the failed ones too */
    _Atomic int64_t live_bytes; /* given out and not released */
    _Atomic int64_t live_blocks;
    _Atomic int64_t size_errors; /* releases whose size was not the one asked for, alignments that are not promised */
    int64_t fail_at;             /* this call of allocate (from 0) and all later ones answer NULL; TEST_NEVER */
    bool fail_once;              /* the later ones don't */
} test_memory;

typedef struct test_block {
    void* base;
    size_t size;
} test_block; /* lies right in front of the memory given out */

static inline void* DM_CALL test_allocate(void* user, size_t size, size_t alignment) {
    test_memory* memory = user;
    int64_t call = atomic_fetch_add(&memory->calls, 1);
    if (memory->fail_at >= 0 && (memory->fail_once ? call == memory->fail_at : call >= memory->fail_at)) return NULL;
    const bool promised = alignment > 0 && (alignment & (alignment - 1)) == 0 && alignment <= TEST_MAX_ALIGNMENT;
    if (!promised) atomic_fetch_add(&memory->size_errors, 1);
    size_t room = alignment > sizeof(test_block) ? alignment : sizeof(test_block);
    size_t step = alignment > _Alignof(max_align_t) ? alignment : _Alignof(max_align_t);
    char* base = platform_allocate(room + size, step);
    if (base == NULL) return NULL;
    ((test_block*)(void*)(base + room))[-1] = (test_block){base, size};
    memset(base + room, 0xCD, size); /* whoever counts on zeros finds out */
    atomic_fetch_add(&memory->live_bytes, (int64_t)size);
    atomic_fetch_add(&memory->live_blocks, 1);
    return base + room;
}

static inline void DM_CALL test_release(void* user, void* pointer, size_t size) {
    test_memory* memory = user;
    test_block block = ((test_block*)pointer)[-1];
    if (block.size != size) atomic_fetch_add(&memory->size_errors, 1);
    atomic_fetch_sub(&memory->live_bytes, (int64_t)block.size);
    atomic_fetch_sub(&memory->live_blocks, 1);
    platform_release(block.base);
}

static inline dm_allocator test_allocator(test_memory* memory) {
    return (dm_allocator){memory, test_allocate, test_release};
}

typedef struct test_messages {
    int count;
    int32_t level; /* of the last one, as the rest */
    dm_result code;
    char text[1024];
} test_messages;

static inline void DM_CALL test_log_message(void* user, int32_t level, dm_result code, const char* text) {
    test_messages* messages = user;
    messages->count++;
    messages->level = level;
    messages->code = code;
    snprintf(messages->text, sizeof messages->text, "%s", text);
}

static inline dm_log test_log(test_messages* messages) {
    return (dm_log){messages, test_log_message};
}

#endif
