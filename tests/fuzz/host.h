/* A host that counts what it lends, refuses memory when told to, and calls the library back from its own hooks. */
#ifndef DM_FUZZ_HOST_H
#define DM_FUZZ_HOST_H

#include <stdlib.h>
#include <string.h>

#include "expect.h"
#include "input.h"

#define FUZZ_BLOCK_MARK 0x6472616765642121u
#define FUZZ_BLOCK_MOST ((size_t)256 << 20) /* bytes; more is refused */
#define FUZZ_ALIGNMENT_MOST 64
#define FUZZ_NEW_BYTE 0xcd /* what new memory holds */

typedef struct fuzz_host {
    fuzz_input* in;
    int64_t live;                            /* blocks */
    size_t bytes, peak;                      /* lent, and most ever lent */
    uint32_t refuse_in;                      /* the n-th allocation from now fails; 0 = none */
    void (*reenter)(struct fuzz_host* host); /* what a hook calls; NULL = nothing */
    bool inside;                             /* a hook has called the library: not again */
} fuzz_host;

/* Stands before each block, at its end; the rest of the space before is for the alignment. */
typedef struct fuzz_block {
    uint64_t mark;
    size_t size;
    void* base;
} fuzz_block;

static inline void fuzz_call_back(fuzz_host* host) {
    if (host->reenter == NULL || host->inside) return;
    host->inside = true;
    host->reenter(host);
    host->inside = false;
}

static inline void* DM_CALL fuzz_allocate(void* user, size_t size, size_t alignment) {
    fuzz_host* host = user;
    fuzz_expect(size > 0 && alignment > 0 && (alignment & (alignment - 1)) == 0 && alignment <= FUZZ_ALIGNMENT_MOST);
    if (host->refuse_in > 0 && --host->refuse_in == 0) return NULL;
    if (size > FUZZ_BLOCK_MOST) return NULL;
    uint8_t* base = malloc(sizeof(fuzz_block) + FUZZ_ALIGNMENT_MOST + size);
    if (base == NULL) return NULL;
    const uintptr_t first = (uintptr_t)base + sizeof(fuzz_block), room = FUZZ_ALIGNMENT_MOST - 1;
    uint8_t* memory = base + sizeof(fuzz_block) + ((first + room) / FUZZ_ALIGNMENT_MOST * FUZZ_ALIGNMENT_MOST - first);
    const fuzz_block block = {FUZZ_BLOCK_MARK, size, base};
    memcpy(memory - sizeof block, &block, sizeof block);
    memset(memory, FUZZ_NEW_BYTE, size);
    host->live++;
    host->bytes += size;
    if (host->bytes > host->peak) host->peak = host->bytes;
    return memory;
}

static inline void DM_CALL fuzz_release(void* user, void* memory, size_t size) {
    fuzz_host* host = user;
    fuzz_block block;
    fuzz_expect(memory != NULL);
    memcpy(&block, (uint8_t*)memory - sizeof block, sizeof block);
    fuzz_expect(block.mark == FUZZ_BLOCK_MARK && block.size == size);
    memset((uint8_t*)memory - sizeof block, 0, sizeof block);
    free(block.base);
    host->live--;
    host->bytes -= size;
}

static inline void DM_CALL fuzz_message(void* user, int32_t level, dm_result code, const char* text) {
    fuzz_expect(level >= DM_LOG_ERROR && level <= DM_LOG_INFO && code <= DM_OK && code >= DM_ERROR_INTERNAL);
    fuzz_expect(text != NULL && text[0] != 0);
    fuzz_call_back(user);
}

/* Runs the tasks in one order or the other, or none. */
static inline int32_t DM_CALL fuzz_parallel_for(void* user, uint32_t count, dm_task task, void* data) {
    const uint32_t way = fuzz_below(((fuzz_host*)user)->in, 3);
    if (way == 0) return 0;
    for (uint32_t i = 0; i < count; i++) task(data, way == 1 ? i : count - 1 - i);
    return 1;
}

static inline int32_t DM_CALL fuzz_progress(void* user, float done) {
    fuzz_host* host = user;
    fuzz_expect(done >= 0 && done <= 1);
    fuzz_call_back(host);
    return fuzz_one_in(host->in, 200);
}

static inline int32_t DM_CALL fuzz_choose(void* user, const dm_choice* choice) {
    fuzz_host* host = user;
    fuzz_expect(choice->count > 0 && choice->count <= DM_MAX_HYPOTHESES);
    fuzz_call_back(host);
    return (int32_t)fuzz_below(host->in, DM_MAX_HYPOTHESES + 1) - 1;
}

static inline int32_t DM_CALL fuzz_intent(void* user, uint32_t part, dm_vec3 low, dm_vec3 high) {
    fuzz_host* host = user;
    fuzz_expect(part > 0 && low.x <= high.x && low.y <= high.y && low.z <= high.z);
    fuzz_call_back(host);
    return (int32_t)fuzz_below(host->in, 7);
}

#endif
