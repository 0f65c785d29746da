/* The host's allocator and the host's job system: every byte is counted, work runs on the host's threads, a refused
 * allocation is an error and nothing more, and no frame allocates. */
#include <pthread.h>
#include <stdatomic.h>

#include "../common/cabinet.h"
#include "../common/platform.h"
#include "../common/weights.h"

/* ---- memory ---- */

typedef struct budget {
    atomic_size_t used, peak, calls;
    size_t most; /* a request beyond it is refused */
} budget;

static void* DM_CALL allocate(void* user, size_t size, size_t alignment) {
    budget* b = user;
    atomic_fetch_add(&b->calls, 1);
    const size_t used = atomic_fetch_add(&b->used, size) + size;
    if (used > b->most) {
        atomic_fetch_sub(&b->used, size);
        return NULL;
    }
    size_t peak = atomic_load(&b->peak);
    while (used > peak && !atomic_compare_exchange_weak(&b->peak, &peak, used)) {
    }
    return platform_allocate(size, alignment);
}

static void DM_CALL release(void* user, void* memory, size_t size) {
    atomic_fetch_sub(&((budget*)user)->used, size);
    platform_release(memory);
}

/* ---- jobs: a game has a pool; four threads a call show the contract just as well ---- */

enum { THREADS = 4 };

typedef struct batch {
    dm_task task;
    void* data;
    uint32_t count;
    atomic_uint next;
} batch;

static void* work(void* argument) {
    batch* b = argument;
    for (uint32_t i; (i = atomic_fetch_add(&b->next, 1)) < b->count;) b->task(b->data, i);
    return NULL;
}

static int32_t DM_CALL parallel_for(void* user, uint32_t count, dm_task task, void* data) {
    batch b = {.task = task, .data = data, .count = count};
    pthread_t threads[THREADS];
    int started = 0;
    *(uint32_t*)user += count;
    while (started < THREADS - 1 && pthread_create(&threads[started], NULL, work, &b) == 0) started++;
    work(&b); /* the caller helps */
    for (int i = 0; i < started; i++) pthread_join(threads[i], NULL);
    return 1; /* all are done; 0 would mean: run them yourself */
}

static dm_result drag_the_door(dm_context* context, dm_object object, const budget* budget) {
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = CABINET_DOOR, .grab_point = {0.55f, 0.45f, 0.45f}};
    dm_drag drag;
    dm_drag_state state = {.struct_size = sizeof state, .value = 0};
    dm_result result = dm_drag_begin(context, &desc, &drag);
    const size_t before = atomic_load(&budget->calls);
    for (int frame = 0; frame < 100 && result == DM_OK; frame++) {
        const dm_ray pointer = {{0.55f - 0.004f * (float)frame, 1.2f, 2.0f}, {0, -0.45f, -0.9f}};
        result = dm_drag_update(context, drag, &pointer, 1.0f / 60, &state);
    }
    printf("100 frames of a drag: door at %.2f rad, %zu allocations\n", (double)state.value,
           atomic_load(&budget->calls) - before);
    return result == DM_OK ? dm_drag_end(context, drag, NULL) : result;
}

int main(int argc, char** argv) {
    static cabinet shape;
    budget budget = {.most = (size_t)256 << 20};
    uint32_t tasks = 0;
    const dm_context_desc host = {.struct_size = sizeof host,
                                  .allocator = {&budget, allocate, release},
                                  .log = {NULL, print_message},
                                  .jobs = {&tasks, parallel_for}};
    dm_context* context;
    dm_model model;
    dm_object object;
    if (dm_context_create(&host, &context) != DM_OK) return 1;
    if (load_weights(context, argc > 1 ? argv[1] : "sdk/models", &model) != DM_OK) return 1;
    const dm_mesh_desc mesh = cabinet_make(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = model};

    const size_t most = budget.most;
    budget.most = atomic_load(&budget.used) + 1000; /* nearly nothing left */
    const dm_result refused = dm_object_prepare(context, &desc, &object);
    printf("with 1000 bytes left: %s; %zu bytes in use, as before\n", dm_result_string(refused),
           atomic_load(&budget.used));
    budget.most = most;

    if (refused != DM_ERROR_OUT_OF_MEMORY || dm_object_prepare(context, &desc, &object) != DM_OK) return 1;
    printf("prepared: %u tasks on the host's threads, %zu bytes at most, %zu now\n", (unsigned)tasks,
           atomic_load(&budget.peak), atomic_load(&budget.used));
    if (drag_the_door(context, object, &budget) != DM_OK) return 1;
    dm_context_destroy(context);
    printf("after dm_context_destroy: %zu bytes\n", atomic_load(&budget.used));
    return atomic_load(&budget.used) != 0;
}
