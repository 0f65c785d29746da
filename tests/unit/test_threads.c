/* Threads: the library starts none, and what is tagged [any-thread] may run side by side. */
#include <dirent.h>
#include <math.h>
#include <pthread.h>

#include "test_world.h"

static int thread_count(void) {
    DIR* folder = opendir("/proc/self/task");
    if (!folder) return -1;
    int count = 0;
    for (const struct dirent* entry = readdir(folder); entry; entry = readdir(folder)) count += entry->d_name[0] != '.';
    closedir(folder);
    return count;
}

static dm_scene scene_with(dm_context* context, dm_object object) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_scene scene = 0;
    uint32_t instance;
    assert_int_equal(dm_scene_create(context, &desc, &scene), DM_OK);
    assert_int_equal(dm_scene_add(context, scene, object, NULL, &instance), DM_OK);
    assert_int_equal(dm_scene_commit(context, scene), DM_OK);
    return scene;
}

/* A grid of this many quads a side on the door's front, so that building a BVH is worth a worker to whoever has one. */
#define FINE 160

static dm_object prepare_fine_cabinet(test_world* w) {
    static float xyz[(FINE + 1) * (FINE + 1) + 8][3];
    static uint32_t corners[FINE * FINE * 2 + 12][3];
    static uint8_t part[FINE * FINE * 2 + 12];
    uint32_t vertices = 0, faces = 0;
    for (uint32_t i = 0; i < 8; i++, vertices++) memcpy(xyz[vertices], w->shape.xyz[i], sizeof xyz[0]);
    for (uint32_t i = 0; i < 12; i++, faces++) memcpy(corners[faces], w->shape.corners[i], sizeof corners[0]);
    for (uint32_t y = 0; y <= FINE; y++) {
        for (uint32_t x = 0; x <= FINE; x++, vertices++) {
            xyz[vertices][0] = (float)x / FINE;
            xyz[vertices][1] = (float)y / FINE;
            xyz[vertices][2] = 1.01f;
        }
    }
    for (uint32_t i = 0; i < FINE * FINE; i++, faces += 2) {
        uint32_t at = 8 + i / FINE * (FINE + 1) + i % FINE;
        memcpy(corners[faces], (uint32_t[]){at, at + 1, at + FINE + 2}, sizeof corners[0]);
        memcpy(corners[faces + 1], (uint32_t[]){at, at + FINE + 2, at + FINE + 1}, sizeof corners[0]);
        part[faces] = part[faces + 1] = TEST_DOOR;
    }
    const dm_mesh_desc mesh = {.struct_size = sizeof mesh,
                               .positions = xyz,
                               .vertex_count = vertices,
                               .indices = corners,
                               .index_count = 3 * (uint64_t)faces,
                               .part_ids = part,
                               .part_id_bytes = faces * sizeof *part,
                               .part_id_format = DM_UINT8,
                               .part_id_scope = DM_PER_FACE};
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = w->model};
    dm_object object = 0;
    assert_int_equal(dm_object_prepare(w->context, &desc, &object), DM_OK);
    return object;
}

static void test_the_library_starts_no_thread(void** state) {
    (void)state;
    const int before = thread_count();
    assert_true(before >= 1);
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    assert_int_equal(thread_count(), before);
    dm_object object = prepare_fine_cabinet(&w);
    assert_int_equal(thread_count(), before);
    dm_scene scene = scene_with(w.context, object);
    const dm_ray ray = {{0.5f, 0.5f, 5}, {0, 0, -1}};
    dm_hit hit = {.struct_size = sizeof hit};
    assert_int_equal(dm_scene_pick(w.context, scene, &ray, &hit), DM_OK);
    assert_int_equal(hit.object, object);
    assert_int_equal(thread_count(), before);
    test_world_close(&w);
    assert_int_equal(thread_count(), before);
}

/* ---- side by side ---- */

#define THREADS 4

typedef struct player {
    test_world* w;
    dm_object shared;
    uint8_t* blob;
    size_t blob_size;
    int failed;
} player;

#define PLAYER_CHECK(condition)                                                                                        \
    if (!(condition)) player->failed = __LINE__

/* Own object, own drag and motion on the shared object, then all of it ended again. */
static void play_round(player* player) {
    dm_context* context = player->w->context;
    dm_object own = 0;
    PLAYER_CHECK(test_world_prepare(player->w, 0, &own) == DM_OK);
    size_t size = 0;
    PLAYER_CHECK(dm_object_save(context, own, NULL, 0, &size) == DM_OK && size == player->blob_size);
    uint8_t* blob = malloc(size);
    PLAYER_CHECK(dm_object_save(context, own, blob, size, &size) == DM_OK);
    PLAYER_CHECK(memcmp(blob, player->blob, size) == 0); /* whoever prepares beside it, the same bits */
    free(blob);
    const dm_motion_desc motion_desc = {.struct_size = sizeof motion_desc, .part_id = TEST_DOOR, .drag = test_pull()};
    const dm_drag_desc drag_desc = {.struct_size = sizeof drag_desc,
                                    .part_id = TEST_DOOR,
                                    .object = player->shared,
                                    .grab_point = test_pull().point};
    dm_motion motion = 0;
    dm_drag drag = 0;
    PLAYER_CHECK(dm_motion_generate(context, player->shared, &motion_desc, &motion) == DM_OK);
    PLAYER_CHECK(dm_drag_begin(context, &drag_desc, &drag) == DM_OK);
    for (int i = 0; i < 20; i++) {
        const dm_ray ray = {{0.9f, 0.5f, 5}, {-0.01f * (float)i, 0, -1}};
        dm_drag_state drag_state = {.struct_size = sizeof drag_state};
        dm_pose pose;
        PLAYER_CHECK(dm_drag_update(context, drag, &ray, 0.016f, &drag_state) == DM_OK);
        PLAYER_CHECK(dm_motion_sample(context, motion, (float)i / 20, &pose, NULL) == DM_OK);
    }
    PLAYER_CHECK(dm_drag_end(context, drag, NULL) == DM_OK);
    PLAYER_CHECK(dm_motion_destroy(context, motion) == DM_OK);
    PLAYER_CHECK(dm_object_destroy(context, own) == DM_OK);
}

static void* play(void* data) {
    player* player = data;
    for (int round = 0; round < 3; round++) play_round(player);
    return NULL;
}

static void test_many_threads_on_one_context(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    w.desc.log = (dm_log){0}; /* the test host's log remembers one message and is for one thread */
    test_world_open(&w);
    test_world_load_model(&w);
    player players[THREADS] = {{.w = &w, .shared = test_world_cabinet(&w)}};
    assert_int_equal(dm_object_save(w.context, players[0].shared, NULL, 0, &players[0].blob_size), DM_OK);
    players[0].blob = malloc(players[0].blob_size);
    assert_int_equal(
        dm_object_save(w.context, players[0].shared, players[0].blob, players[0].blob_size, &players[0].blob_size),
        DM_OK);
    pthread_t threads[THREADS];
    for (int i = 1; i < THREADS; i++) players[i] = players[0];
    for (int i = 0; i < THREADS; i++) assert_int_equal(pthread_create(&threads[i], NULL, play, &players[i]), 0);
    for (int i = 0; i < THREADS; i++) pthread_join(threads[i], NULL);
    for (int i = 0; i < THREADS; i++) {
        if (players[i].failed) fail_msg("thread %d failed at line %d", i, players[i].failed);
    }
    free(players[0].blob);
    test_world_close(&w);
}

typedef struct picker {
    dm_context* context;
    dm_scene scene;
    dm_object object;
    int hits, others;
} picker;

static void* pick_many(void* data) {
    picker* p = data;
    for (int i = 0; i < 500; i++) {
        const dm_ray ray = {{0.05f + 0.9f * (float)(i % 25) / 25, 0.05f + 0.9f * (float)(i / 25) / 20, 5}, {0, 0, -1}};
        dm_hit hit = {.struct_size = sizeof hit};
        if (dm_scene_pick(p->context, p->scene, &ray, &hit) != DM_OK || hit.object != p->object)
            p->others++;
        else
            p->hits++;
    }
    return NULL;
}

static void test_many_threads_pick_one_scene(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    picker pickers[THREADS] = {{.context = w.context, .scene = scene_with(w.context, object), .object = object}};
    pthread_t threads[THREADS];
    for (int i = 1; i < THREADS; i++) pickers[i] = pickers[0];
    for (int i = 0; i < THREADS; i++) assert_int_equal(pthread_create(&threads[i], NULL, pick_many, &pickers[i]), 0);
    for (int i = 0; i < THREADS; i++) pthread_join(threads[i], NULL);
    for (int i = 0; i < THREADS; i++) {
        assert_int_equal(pickers[i].hits, 500);
        assert_int_equal(pickers[i].others, 0);
    }
    test_world_close(&w);
}

/* A host's job system that hands every other task to a thread of its own. */
typedef struct job_half {
    dm_task task;
    void* data;
    uint32_t first, count;
} job_half;

static void* run_half(void* data) {
    const job_half* half = data;
    for (uint32_t i = half->first; i < half->count; i += 2) half->task(half->data, i);
    return NULL;
}

static int32_t DM_CALL two_threads(void* user, uint32_t count, dm_task task, void* data) {
    (void)user;
    job_half halves[2] = {{task, data, 0, count}, {task, data, 1, count}};
    pthread_t helper;
    if (pthread_create(&helper, NULL, run_half, &halves[1]) != 0) return 0;
    run_half(&halves[0]);
    pthread_join(helper, NULL);
    return 1;
}

static void test_prepare_on_the_hosts_workers(void** state) {
    (void)state;
    dm_joint joints[2] = {dm_joint_default(), dm_joint_default()};
    for (int i = 0; i < 2; i++) {
        test_world w;
        test_world_init(&w);
        if (i == 1) w.desc.jobs.parallel_for = two_threads;
        test_world_open(&w);
        test_world_load_model(&w);
        dm_object object = test_world_cabinet(&w);
        assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joints[i]), DM_OK);
        test_world_close(&w);
    }
    assert_memory_equal(&joints[0], &joints[1], sizeof joints[0]);
}

static void test_two_contexts_at_once(void** state) {
    (void)state;
    test_world a, b;
    test_world_init(&a);
    test_world_init(&b);
    b.desc.axes = DM_AXES_BLENDER;
    b.desc.unit_in_metres = 0.5f;
    test_world_open(&a);
    test_world_open(&b);
    dm_object in_a = test_world_cabinet(&a), in_b = test_world_cabinet(&b);
    dm_scene scene_a = scene_with(a.context, in_a), scene_b = scene_with(b.context, in_b);
    test_world_close(&a); /* the other one goes on */
    const dm_ray ray = {{0.5f, 0.5f, 5}, {0, 0, -1}};
    dm_hit hit = {.struct_size = sizeof hit};
    assert_int_equal(dm_scene_pick(b.context, scene_b, &ray, &hit), DM_OK);
    assert_int_equal(hit.object, in_b);
    assert_int_equal(dm_scene_pick(b.context, scene_a, &ray, &hit), DM_ERROR_STALE_HANDLE);
    test_world_close(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_library_starts_no_thread), /* first: later ones have had threads of their own */
        cmocka_unit_test(test_many_threads_on_one_context),  cmocka_unit_test(test_many_threads_pick_one_scene),
        cmocka_unit_test(test_prepare_on_the_hosts_workers), cmocka_unit_test(test_two_contexts_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
