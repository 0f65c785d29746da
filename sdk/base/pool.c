/* Handle pool: slots in chunks that never move, so that a look-up is three loads without a lock.
 *
 * Memory order: remove raises the generation before it clears the item, insert stores the item after that, and get
 * reads the item before the generation. A reader that sees a later item therefore sees the later generation too, and
 * returns NULL. */
#include "base/pool.h"

#include <stdbool.h>

#include "base/compiler.h"

#define CHUNK_COUNT 18                  /* 64 + 128 + ... covers all 24-bit indices but the last 64 */
#define FIRST_CHUNK_BITS 6              /* 64 slots; each chunk doubles */
#define LAST_GENERATION UINT32_MAX      /* 32 bits of the handle */
#define INDEX_MASK ((uint64_t)0xFFFFFF) /* 24 bits of the handle */
#define NO_SLOT UINT32_MAX

typedef struct slot {
    _Atomic(void*) item;
    _Atomic uint32_t generation; /* generation of the handle in use, or of the next one while the slot is free */
    uint32_t next, previous;     /* neighbours in the list of live or of free slots; read and written under the lock */
} slot;

struct dmi_pool {
    dmi_env* env;
    atomic_flag lock;
    uint8_t kind;
    uint32_t first_generation;        /* generation that every slot begins with */
    uint32_t slot_count, chunk_count; /* read and written under the lock */
    uint32_t first_free, first_live;
    _Atomic(slot*) chunks[CHUNK_COUNT];
};

static void lock(dmi_pool* pool) {
    while (atomic_flag_test_and_set_explicit(&pool->lock, memory_order_acquire)) {
    }
}

static void unlock(dmi_pool* pool) {
    atomic_flag_clear_explicit(&pool->lock, memory_order_release);
}

static size_t chunk_slots(uint32_t chunk) {
    return (size_t)1 << (chunk + FIRST_CHUNK_BITS);
}

/* Where the slot of an index is. */
typedef struct place {
    uint32_t chunk;
    size_t slot;
} place;

static place place_of(uint32_t index) {
    const uint64_t shifted = (uint64_t)index + ((uint64_t)1 << FIRST_CHUNK_BITS);
    const uint32_t bits = dmi_floor_log2(shifted);
    return (place){bits - FIRST_CHUNK_BITS, (size_t)(shifted - ((uint64_t)1 << bits))};
}

/* Returns the slot of an index; NULL when no chunk holds it. */
static slot* slot_at(const dmi_pool* pool, uint32_t index) {
    const place at = place_of(index);
    if (at.chunk >= CHUNK_COUNT) return NULL;
    slot* slots = atomic_load_explicit(&pool->chunks[at.chunk], memory_order_acquire);
    return slots == NULL ? NULL : &slots[at.slot];
}

/* The same for an index that a list holds, and so a chunk. */
static slot* listed_slot(const dmi_pool* pool, uint32_t index) {
    const place at = place_of(index);
    return atomic_load_explicit(&pool->chunks[at.chunk], memory_order_acquire) + at.slot;
}

static uint64_t make_handle(const dmi_pool* pool, uint32_t generation, uint32_t index) {
    return (uint64_t)pool->kind << DMI_HANDLE_KIND_SHIFT | (uint64_t)generation << DMI_HANDLE_GENERATION_SHIFT | index;
}

/* Returns a first generation, different for each pool of the process, so that a handle of one context is stale in all
 * others. Fibonacci hashing spreads them. */
static uint32_t next_first_generation(void) {
    static _Atomic uint32_t pools;
    uint32_t number = atomic_fetch_add_explicit(&pools, 1, memory_order_relaxed);
    return 1 + number * 0x9E3779B1u /* a prime near 2^32 / golden ratio */ % LAST_GENERATION;
}

dm_result dmi_pool_create(dmi_env* env, uint8_t kind, dmi_pool** out_pool) {
    dmi_pool* pool = dmi_alloc_zeroed(env, sizeof *pool, _Alignof(dmi_pool));
    if (pool == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "handle pool: no memory for %zu bytes", sizeof *pool);
    pool->env = env;
    pool->kind = kind;
    pool->first_generation = next_first_generation();
    pool->first_free = pool->first_live = NO_SLOT;
    atomic_flag_clear(&pool->lock);
    *out_pool = pool;
    return DM_OK;
}

void dmi_pool_destroy(dmi_pool* pool) {
    if (pool == NULL) return;
    for (uint32_t i = 0; i < pool->chunk_count; i++) {
        dmi_free(pool->env, atomic_load_explicit(&pool->chunks[i], memory_order_relaxed),
                 chunk_slots(i) * sizeof(slot));
    }
    dmi_free(pool->env, pool, sizeof *pool);
}

/* Takes a free slot, under the lock; NO_SLOT when a chunk is missing. */
static uint32_t take_free(dmi_pool* pool) {
    uint32_t index = pool->first_free;
    if (index != NO_SLOT) {
        pool->first_free = listed_slot(pool, index)->next;
        return index;
    }
    if (slot_at(pool, pool->slot_count) == NULL) return NO_SLOT;
    return pool->slot_count++;
}

/* Adds a chunk. The host's allocator runs outside the lock; of two threads at once, one frees its chunk again. */
static dm_result add_chunk(dmi_pool* pool, uint32_t chunk) {
    if (chunk >= CHUNK_COUNT)
        return dmi_fail(pool->env, DM_ERROR_TOO_LARGE, "handle pool: 2^24 handles are in use or used up");
    size_t size = chunk_slots(chunk) * sizeof(slot);
    slot* slots = dmi_alloc_zeroed(pool->env, size, _Alignof(slot));
    if (slots == NULL) return dmi_fail(pool->env, DM_ERROR_OUT_OF_MEMORY, "handle pool: no memory for %zu bytes", size);
    for (size_t i = 0; i < chunk_slots(chunk); i++) atomic_init(&slots[i].generation, pool->first_generation);
    lock(pool);
    if (pool->chunk_count == chunk) {
        atomic_store_explicit(&pool->chunks[chunk], slots, memory_order_release);
        pool->chunk_count++;
        slots = NULL;
    }
    unlock(pool);
    dmi_free(pool->env, slots, size);
    return DM_OK;
}

static void link_live(dmi_pool* pool, uint32_t index) {
    slot* s = listed_slot(pool, index);
    s->previous = NO_SLOT;
    s->next = pool->first_live;
    if (s->next != NO_SLOT) listed_slot(pool, s->next)->previous = index;
    pool->first_live = index;
}

static void unlink_live(dmi_pool* pool, const slot* s) {
    if (s->next != NO_SLOT) listed_slot(pool, s->next)->previous = s->previous;
    if (s->previous != NO_SLOT) {
        listed_slot(pool, s->previous)->next = s->next;
    } else {
        pool->first_live = s->next;
    }
}

dm_result dmi_pool_insert(dmi_pool* pool, void* item, uint64_t* out_handle) {
    for (;;) {
        lock(pool);
        uint32_t index = take_free(pool), chunk = pool->chunk_count;
        if (index != NO_SLOT) {
            slot* s = listed_slot(pool, index);
            link_live(pool, index);
            atomic_store_explicit(&s->item, item, memory_order_release);
            *out_handle = make_handle(pool, atomic_load_explicit(&s->generation, memory_order_relaxed), index);
        }
        unlock(pool);
        if (index != NO_SLOT) return DM_OK;
        dm_result result = add_chunk(pool, chunk);
        if (result != DM_OK) return result;
    }
}

static uint32_t generation_after(uint32_t generation) {
    return generation == LAST_GENERATION ? 1 : generation + 1;
}

/* A slot that has had all generations stays out of the list, so that no handle is given twice. */
static void put_free(dmi_pool* pool, uint32_t index) {
    listed_slot(pool, index)->next = pool->first_free;
    pool->first_free = index;
}

/* Whether the handle has the kind and generation of the slot. */
static bool matches(const dmi_pool* pool, const slot* s, uint64_t handle) {
    const uint32_t generation = (uint32_t)(handle >> DMI_HANDLE_GENERATION_SHIFT); /* drops the kind above it */
    return handle >> DMI_HANDLE_KIND_SHIFT == pool->kind &&
           atomic_load_explicit(&s->generation, memory_order_relaxed) == generation;
}

void* dmi_pool_get(const dmi_pool* pool, uint64_t handle) {
    const slot* s = slot_at(pool, (uint32_t)(handle & INDEX_MASK));
    if (s == NULL) return NULL;
    void* item = atomic_load_explicit(&s->item, memory_order_acquire);
    return matches(pool, s, handle) ? item : NULL;
}

void* dmi_pool_remove(dmi_pool* pool, uint64_t handle) {
    const uint32_t index = (uint32_t)(handle & INDEX_MASK);
    void* item = NULL;
    lock(pool);
    slot* s = slot_at(pool, index);
    if (s != NULL && matches(pool, s, handle)) item = atomic_load_explicit(&s->item, memory_order_relaxed);
    if (item != NULL) {
        const uint32_t next = generation_after(atomic_load_explicit(&s->generation, memory_order_relaxed));
        atomic_store_explicit(&s->generation, next, memory_order_relaxed);
        atomic_store_explicit(&s->item, NULL, memory_order_release);
        unlink_live(pool, s);
        if (next != pool->first_generation) put_free(pool, index);
    }
    unlock(pool);
    return item;
}

void* dmi_pool_any(const dmi_pool* pool, uint64_t* out_handle) {
    if (pool->first_live == NO_SLOT) return NULL;
    const slot* s = listed_slot(pool, pool->first_live);
    *out_handle = make_handle(pool, atomic_load_explicit(&s->generation, memory_order_relaxed), pool->first_live);
    return atomic_load_explicit(&s->item, memory_order_relaxed);
}
