/* Scratch memory that stays with a context: what is kept, within which bounds, and who gets it back. */
#include <pthread.h>

#include "base/arena.h"
#include "base/env.h"
#include "test_env.h"
#include "test_world.h"

enum { KB = 1024, THREADS = 4, ROUNDS = 12, LIVES = 200, LEAST_SAVED = 8 };

static void open_keeping(test_env* t, size_t most) {
    test_env_open(t, TEST_NEVER);
    t->env.kept.most = most;
}

static void close_keeping(test_env* t) {
    dmi_env_trim(&t->env);
    test_env_close(t);
}

/* ---- the store ---- */

static void an_arena_takes_what_the_one_before_had(void** state) {
    (void)state;
    test_env t;
    open_keeping(&t, 1024 * KB);
    for (int round = 0; round < 5; round++) {
        dmi_arena arena;
        dmi_arena_init(&arena, &t.env, 64 * KB);
        for (int i = 0; i < 4; i++) assert_non_null(dmi_arena_push(&arena, 40 * KB));
        assert_non_null(dmi_arena_push(&arena, 200 * KB));
        dmi_arena_release(&arena);
        assert_int_equal(t.memory.calls, 5);
    }
    assert_int_equal(dmi_kept_bytes(&t.env.kept), t.memory.live_bytes);
    assert_int_equal(dmi_env_trim(&t.env), t.env.peak_bytes);
    assert_int_equal(dmi_kept_bytes(&t.env.kept), 0);
    close_keeping(&t);
}

static void nothing_is_kept_where_nobody_asks(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    void* memory = dmi_scratch_alloc(&t.env, 64 * KB);
    assert_non_null(memory);
    dmi_scratch_free(&t.env, memory);
    assert_int_equal(t.memory.live_blocks, 0);
    test_env_close(&t);
}

static void the_bound_holds_and_the_oldest_go(void** state) {
    (void)state;
    test_env t;
    open_keeping(&t, 300 * KB);
    void* block[5];
    for (size_t i = 0; i < 5; i++) assert_non_null(block[i] = dmi_alloc(&t.env, (100 + i) * KB, DMI_ALIGNMENT));
    for (size_t i = 0; i < 5; i++) {
        dmi_kept_give(&t.env, block[i], (100 + i) * KB);
        assert_true(dmi_kept_bytes(&t.env.kept) <= 300 * KB);
    }
    assert_int_equal(dmi_kept_bytes(&t.env.kept), (103 + 104) * KB);
    void* large = dmi_alloc(&t.env, 301 * KB, DMI_ALIGNMENT);
    dmi_kept_give(&t.env, large, 301 * KB);
    assert_int_equal(dmi_kept_bytes(&t.env.kept), (103 + 104) * KB);
    close_keeping(&t);
}

static void a_block_fits_or_is_left(void** state) {
    (void)state;
    test_env t;
    open_keeping(&t, 1024 * KB);
    dmi_kept_give(&t.env, dmi_alloc(&t.env, 100 * KB, DMI_ALIGNMENT), 100 * KB);
    size_t size;
    void* much_smaller = dmi_kept_take(&t.env, 50 * KB, &size);
    assert_int_equal(size, 50 * KB);
    void* larger = dmi_kept_take(&t.env, 101 * KB, &size);
    assert_int_equal(size, 101 * KB);
    assert_int_equal(dmi_kept_bytes(&t.env.kept), 100 * KB);
    void* little_smaller = dmi_kept_take(&t.env, 90 * KB, &size);
    assert_int_equal(size, 100 * KB);
    assert_int_equal(dmi_kept_bytes(&t.env.kept), 0);
    dmi_kept_give(&t.env, much_smaller, 50 * KB);
    dmi_kept_give(&t.env, larger, 101 * KB);
    dmi_kept_give(&t.env, little_smaller, 100 * KB);
    close_keeping(&t);
}

/* What nobody uses must not be why the host has nothing left. */
static void a_refusing_host_gets_the_kept_memory_first(void** state) {
    (void)state;
    test_env t;
    open_keeping(&t, 1024 * KB);
    dmi_scratch_free(&t.env, dmi_scratch_alloc(&t.env, 64 * KB));
    assert_int_equal(t.memory.live_blocks, 1);
    t.memory.fail_at = t.memory.calls, t.memory.fail_once = true;
    void* memory = dmi_alloc(&t.env, 400 * KB, DMI_ALIGNMENT);
    assert_non_null(memory);
    assert_int_equal(t.memory.live_blocks, 1);
    t.memory.fail_at = t.memory.calls;
    assert_null(dmi_alloc(&t.env, 1, 1));
    assert_int_equal(t.memory.calls, 4);
    dmi_free(&t.env, memory, 400 * KB);
    close_keeping(&t);
}

static void absurd_sizes_are_refused(void** state) {
    (void)state;
    test_env t;
    open_keeping(&t, SIZE_MAX);
    assert_null(dmi_scratch_alloc(&t.env, SIZE_MAX));
    assert_null(dmi_scratch_alloc(&t.env, SIZE_MAX - 63));
    assert_int_equal(t.memory.calls, 0);
    close_keeping(&t);
}

/* ---- a context ---- */

static dm_memory_info memory_of(const test_world* w) {
    dm_memory_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_context_get_memory(w->context, &info), DM_OK);
    return info;
}

static dm_result prepare(test_world* w, uint64_t seed, dm_object* out) {
    const dm_mesh_desc mesh = test_shape_desc(&w->shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = w->model, .seed = seed};
    return dm_object_prepare(w->context, &desc, out);
}

static void open_world(test_world* w, uint64_t kept) {
    test_world_init(w);
    w->desc.kept_bytes = kept;
    w->desc.picking = DM_PICK_PORTABLE;
    test_world_open(w);
    test_world_load_model(w);
}

/* Returns how often a call asks the host. */
static uint64_t requests_of_a_call(test_world* w) {
    dm_object object;
    const uint64_t before = memory_of(w).allocations;
    assert_int_equal(prepare(w, 1, &object), DM_OK);
    const uint64_t made = memory_of(w).allocations - before;
    assert_int_equal(dm_object_destroy(w->context, object), DM_OK);
    return made;
}

/* Where memory is kept, the second of two alike calls asks for what stays alone; else it asks as the first did. */
static void a_second_call_asks_the_host_for_little(void** state) {
    (void)state;
    test_world w;
    open_world(&w, 1);
    requests_of_a_call(&w); /* makes room for handles */
    const uint64_t first = requests_of_a_call(&w);
    assert_int_equal(requests_of_a_call(&w), first);
    assert_int_equal(memory_of(&w).kept_bytes, 0);
    test_world_close(&w);
    open_world(&w, 0);
    assert_true(requests_of_a_call(&w) <= first);
    const dm_memory_info after = memory_of(&w);
    assert_true(requests_of_a_call(&w) + LEAST_SAVED <= first);
    assert_true(after.kept_bytes > 1024 * KB);
    assert_int_equal(memory_of(&w).bytes, after.bytes);
    assert_int_equal(memory_of(&w).peak_bytes, after.peak_bytes);
    test_world_close(&w);
}

/* Loaded, trimmed, unloaded, over and over: no more is held than after the first time. */
static void many_lives_hold_no_more_than_one(void** state) {
    (void)state;
    test_world w;
    open_world(&w, 0);
    dm_object object;
    size_t size = 0;
    assert_int_equal(prepare(&w, 1, &object), DM_OK);
    assert_int_equal(dm_object_save(w.context, object, NULL, 0, &size), DM_OK);
    uint8_t* file = malloc(size);
    assert_int_equal(dm_object_save(w.context, object, file, size, &size), DM_OK);
    assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    assert_int_equal(dm_context_trim(w.context), DM_OK);
    const int64_t held = w.memory.live_bytes, blocks = w.memory.live_blocks;
    for (int i = 0; i < LIVES; i++) {
        assert_int_equal(dm_object_load(w.context, file, size, w.model, &object), DM_OK);
        if (i % 3 == 0) assert_int_equal(dm_context_trim(w.context), DM_OK);
        assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
        assert_int_equal(w.memory.live_bytes - held, (int64_t)memory_of(&w).kept_bytes);
    }
    assert_int_equal(dm_context_trim(w.context), DM_OK);
    assert_int_equal(w.memory.live_bytes, held);
    assert_int_equal(w.memory.live_blocks, blocks);
    free(file);
    test_world_close(&w);
}

/* What docs/memory.md says of a context and of the first handle of a kind. */
enum { CONTEXT_BYTES = 1945, FIRST_HANDLE_BYTES = 1536 };

/* A level comes and goes: weights, an object from a file, an instance of it that is picked. */
static void play_level(test_world* w, const uint8_t* file, size_t size) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_object object;
    dm_scene scene;
    uint32_t instance;
    test_world_load_model(w);
    assert_int_equal(dm_object_load(w->context, file, size, w->model, &object), DM_OK);
    assert_int_equal(dm_scene_create(w->context, &desc, &scene), DM_OK);
    assert_int_equal(dm_scene_add(w->context, scene, object, NULL, &instance), DM_OK);
    assert_int_equal(dm_scene_commit(w->context, scene), DM_OK);
    assert_int_equal(dm_scene_destroy(w->context, scene), DM_OK);
    assert_int_equal(dm_object_destroy(w->context, object), DM_OK);
    assert_int_equal(dm_model_unload(w->context, w->model), DM_OK);
}

/* Once all has gone, a trim leaves the context and the room for handles; by the host's count and by the context's. */
static void a_trim_leaves_the_context_and_room_for_handles(void** state) {
    (void)state;
    test_world w;
    open_world(&w, 0);
    dm_object object;
    size_t size = 0;
    assert_int_equal(prepare(&w, 1, &object), DM_OK);
    assert_int_equal(dm_object_save(w.context, object, NULL, 0, &size), DM_OK);
    uint8_t* file = malloc(size);
    assert_int_equal(dm_object_save(w.context, object, file, size, &size), DM_OK);
    assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    assert_int_equal(dm_model_unload(w.context, w.model), DM_OK);
    int64_t first = 0;
    for (int i = 0; i < LIVES; i++) {
        play_level(&w, file, size);
        if (i % 2 == 1) continue; /* the next one finds the memory of this one */
        assert_int_equal(dm_context_trim(w.context), DM_OK);
        assert_int_equal(memory_of(&w).kept_bytes, 0);
        assert_int_equal(memory_of(&w).bytes, w.memory.live_bytes);
        if (i == 0) first = w.memory.live_bytes;
        assert_int_equal(w.memory.live_bytes, first);
    }
    assert_true(first <= CONTEXT_BYTES + 3 * FIRST_HANDLE_BYTES);
    free(file);
    test_world_close(&w);
}

/* ---- threads ---- */

typedef struct worker {
    test_world* world;
    uint64_t seed;
    dm_joint first;
    int wrong;
} worker;

static void* prepare_often(void* user) {
    worker* own = user;
    for (int i = 0; i < ROUNDS; i++) {
        dm_object object = 0;
        dm_joint joint = {.struct_size = sizeof joint};
        own->wrong += prepare(own->world, own->seed, &object) != DM_OK;
        own->wrong += dm_object_get_joint(own->world->context, object, TEST_DOOR, &joint) != DM_OK;
        if (i == 0) own->first = joint;
        own->wrong += memcmp(&joint, &own->first, sizeof joint) != 0;
        own->wrong += dm_object_destroy(own->world->context, object) != DM_OK;
        if (i % 4 == 3) own->wrong += dm_context_trim(own->world->context) != DM_OK;
    }
    return NULL;
}

static void threads_share_what_is_kept(void** state) {
    (void)state;
    test_world w;
    open_world(&w, 16 * KB * KB);
    worker workers[THREADS] = {0};
    pthread_t threads[THREADS];
    for (int i = 0; i < THREADS; i++) {
        workers[i] = (worker){.world = &w, .seed = 1 + (uint64_t)i / 2};
        assert_int_equal(pthread_create(&threads[i], NULL, prepare_often, &workers[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        assert_int_equal(workers[i].wrong, 0);
        assert_memory_equal(&workers[i].first, &workers[i / 2 * 2].first, sizeof(dm_joint));
    }
    assert_true(memory_of(&w).kept_bytes <= 16 * KB * KB);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_arena_takes_what_the_one_before_had),
        cmocka_unit_test(nothing_is_kept_where_nobody_asks),
        cmocka_unit_test(the_bound_holds_and_the_oldest_go),
        cmocka_unit_test(a_block_fits_or_is_left),
        cmocka_unit_test(a_refusing_host_gets_the_kept_memory_first),
        cmocka_unit_test(absurd_sizes_are_refused),
        cmocka_unit_test(a_second_call_asks_the_host_for_little),
        cmocka_unit_test(many_lives_hold_no_more_than_one),
        cmocka_unit_test(a_trim_leaves_the_context_and_room_for_handles),
        cmocka_unit_test(threads_share_what_is_kept),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
