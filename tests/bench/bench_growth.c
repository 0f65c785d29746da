/* How cost and memory grow with triangles, parts and live drags, and how preparing scales over workers:
 * bench_growth triangles|parts|drags|jobs [most [models]]. One JSON object a line. */
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "test_hash.h"
#include "world.h"

#define PARTS_TRIANGLES 100000
#define DRAG_TRIANGLES 1000
#define JOB_OBJECTS 16
#define LOAD_TRIANGLES 5400 /* of an object that is loaded */
#define LOADS 400           /* a round */
#define BARE_LOADS 20000    /* a round, of objects without triangles */
#define LOAD_ROUNDS 5
#define JOB_TRIANGLES 20000
#define CHECK(call) bench_check(call, #call)

/* Least of three, so that other programs show little. */
static double least_ms(double (*measure)(void* user), void* user) {
    double least = measure(user);
    for (int i = 0; i < 2; i++) {
        const double again = measure(user);
        if (again < least) least = again;
    }
    return least * 1e-6;
}

typedef struct subject {
    bench_world* world;
    const bench_mesh* mesh;
    uint32_t flags;
    dm_scene scene;
    uint32_t instance;
    dm_pose pose;
    dm_ray ray;
} subject;

static double prepare_once(void* user) {
    subject* s = user;
    const double start = bench_now_ns();
    const dm_object object = bench_world_prepare(s->world, s->mesh, s->flags);
    const double taken = bench_now_ns() - start;
    CHECK(dm_object_destroy(s->world->context, object));
    return taken;
}

static void move_once(void* user) {
    subject* s = user;
    CHECK(dm_scene_move(s->world->context, s->scene, s->instance, 1, &s->pose));
    CHECK(dm_scene_commit(s->world->context, s->scene));
}

static void pick_once(void* user) {
    subject* s = user;
    dm_hit hit = {.struct_size = sizeof hit};
    CHECK(dm_scene_pick(s->world->context, s->scene, &s->ray, &hit));
}

static size_t saved_size(bench_world* world, dm_object object) {
    size_t size = 0;
    CHECK(dm_object_save(world->context, object, NULL, 0, &size));
    return size;
}

/* Everything about one object of a size. */
static void show_object(bench_world* world, uint32_t triangles, uint32_t parts) {
    bench_mesh mesh = bench_mesh_new(triangles, parts);
    subject s = {.world = world, .mesh = &mesh, .flags = DM_PREPARE_WITHOUT_PICKING};
    dm_memory_info before = {.struct_size = sizeof before}, after = {.struct_size = sizeof after};
    s.pose.real[3] = 1;
    const double bare = least_ms(prepare_once, &s);
    s.flags = 0;
    const double whole = least_ms(prepare_once, &s);
    CHECK(dm_context_get_memory(world->context, &before));
    const dm_object object = bench_world_prepare(world, &mesh, 0);
    CHECK(dm_context_get_memory(world->context, &after));
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    CHECK(dm_scene_create(world->context, &desc, &s.scene));
    CHECK(dm_scene_add(world->context, s.scene, object, NULL, &s.instance));
    CHECK(dm_scene_commit(world->context, s.scene));
    const dm_vec3 handle = bench_mesh_drag(1).point;
    s.ray = (dm_ray){{handle.x, handle.y + 0.3f, 2}, {0, -0.15f, -1}};
    printf("{\"triangles\": %u, \"parts\": %u, \"prepare_ms\": %.3f, \"prepare_with_picking_ms\": %.3f, "
           "\"move_commit_us\": %.3f, \"pick_us\": %.3f, \"bytes\": %llu, \"pick_bytes\": %llu, \"dmo_bytes\": %zu}\n",
           mesh.face_count, parts, bare, whole, bench_median_ns(move_once, &s, 50, NULL) * 1e-3,
           bench_median_ns(pick_once, &s, 50, NULL) * 1e-3, (unsigned long long)(after.bytes - before.bytes),
           (unsigned long long)(after.pick_bytes - before.pick_bytes), saved_size(world, object));
    fflush(stdout);
    CHECK(dm_scene_destroy(world->context, s.scene));
    CHECK(dm_object_destroy(world->context, object));
    bench_mesh_free(&mesh);
}

static void grow_triangles(bench_world* world, uint32_t most) {
    for (uint32_t triangles = 1000; triangles <= most; triangles *= 4) show_object(world, triangles, 1);
}

static void grow_parts(bench_world* world, uint32_t most) {
    for (uint32_t parts = 1; parts <= most; parts *= 4) show_object(world, PARTS_TRIANGLES, parts);
}

/* ---- live drags ---- */

typedef struct crowd {
    bench_world* world;
    dm_drag* drags;
    dm_motion* motions;
    uint32_t count, frame;
} crowd;

static void update_all(void* user) {
    crowd* c = user;
    const float turn = 0.01f * (float)(c->frame++ % 50);
    for (uint32_t i = 0; i < c->count; i++) {
        const dm_ray ray = {{0.458f, 0.6f, 2}, {-turn, -0.1f, -1}};
        dm_drag_state state = {.struct_size = sizeof state};
        CHECK(dm_drag_update(c->world->context, c->drags[i], &ray, 1 / 60.0f, &state));
    }
}

static void sample_all(void* user) {
    crowd* c = user;
    const float t = 0.01f * (float)(c->frame++ % 100);
    for (uint32_t i = 0; i < c->count; i++) {
        dm_pose pose;
        CHECK(dm_motion_sample(c->world->context, c->motions[i], t, &pose, NULL));
    }
}

static void grow_drags(bench_world* world, uint32_t most) {
    bench_mesh mesh = bench_mesh_new(DRAG_TRIANGLES, 1);
    crowd c = {
        .world = world, .drags = bench_alloc(most * sizeof *c.drags), .motions = bench_alloc(most * sizeof *c.motions)};
    const dm_object object = bench_world_prepare(world, &mesh, 0);
    bench_world_hinge(world, object, 1, DM_JOINT_REVOLUTE);
    const dm_drag_hint pull = bench_mesh_drag(1);
    const dm_drag_desc drag = {.struct_size = sizeof drag, .part_id = 1, .object = object, .grab_point = pull.point};
    const dm_motion_desc motion = {.struct_size = sizeof motion, .part_id = 1, .drag = pull};
    for (uint32_t next = 1; next <= most; next *= 10) {
        dm_memory_info before = {.struct_size = sizeof before}, after = {.struct_size = sizeof after};
        const uint32_t added = next - c.count;
        CHECK(dm_context_get_memory(world->context, &before));
        for (uint32_t i = c.count; i < next; i++) {
            CHECK(dm_drag_begin(world->context, &drag, &c.drags[i]));
            CHECK(dm_motion_generate(world->context, object, &motion, &c.motions[i]));
        }
        CHECK(dm_context_get_memory(world->context, &after));
        c.count = next;
        const double update = bench_median_ns(update_all, &c, 300, NULL);
        const double sample = bench_median_ns(sample_all, &c, 300, NULL);
        printf("{\"live\": %u, \"update_us\": %.3f, \"sample_us\": %.3f, \"bytes_each\": %.0f}\n", next, update * 1e-3,
               sample * 1e-3, (double)(after.bytes - before.bytes) / added);
        fflush(stdout);
    }
    free(c.drags);
    free(c.motions);
    bench_mesh_free(&mesh);
}

/* ---- workers ---- */

/* The simplest job system a host may have: the workers of one call, tasks taken in turn. */
typedef struct team {
    uint32_t workers;
} team;

typedef struct job {
    dm_task task;
    void* data;
    uint32_t count;
    _Atomic uint32_t next;
} job;

static void* work(void* user) {
    job* j = user;
    for (uint32_t i = atomic_fetch_add(&j->next, 1); i < j->count; i = atomic_fetch_add(&j->next, 1))
        j->task(j->data, i);
    return NULL;
}

static int32_t DM_CALL run_team(void* user, uint32_t count, dm_task task, void* data) {
    const team* t = user;
    pthread_t threads[64];
    job j = {.task = task, .data = data, .count = count};
    for (uint32_t i = 1; i < t->workers; i++) pthread_create(&threads[i], NULL, work, &j);
    work(&j);
    for (uint32_t i = 1; i < t->workers; i++) pthread_join(threads[i], NULL);
    return 1;
}

static double read_clock(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

/* What is done over and over with any number of workers: its time by the wall, and the bytes that came out. */
typedef struct effort {
    bench_world world;
    const bench_mesh* mesh;
    dm_object objects[JOB_OBJECTS];
    uint32_t count;
} effort;

static void DM_CALL prepare_task(void* data, uint32_t index) {
    effort* e = data;
    e->objects[index] = bench_world_prepare(&e->world, e->mesh, DM_PREPARE_WITHOUT_PICKING);
}

/* One object of many parts, which the library hands to the host's workers; or the host's workers take an object each.
 */
static void run_effort(effort* e, const team* t, int whole_objects) {
    e->count = whole_objects ? JOB_OBJECTS : 1;
    if (whole_objects)
        run_team((void*)t, e->count, prepare_task, e);
    else
        prepare_task(e, 0);
}

/* Hash of all that the objects are saved as. */
static uint64_t hash_objects(effort* e) {
    uint64_t hash = TEST_HASH_START;
    for (uint32_t i = 0; i < e->count; i++) {
        size_t size = saved_size(&e->world, e->objects[i]);
        uint8_t* saved = bench_alloc(size);
        CHECK(dm_object_save(e->world.context, e->objects[i], saved, size, &size));
        hash = test_hash_bytes(hash, saved, size);
        free(saved);
    }
    return hash;
}

/* Least time by the wall; least time of all processors together to *out_cpu. */
static double time_team(team* t, const char* models, const bench_mesh* mesh, int whole_objects, double* out_cpu,
                        uint64_t* out_hash) {
    effort e = {.mesh = mesh};
    const dm_jobs jobs = {t, run_team};
    bench_world_open(&e.world, models, whole_objects ? NULL : &jobs);
    double least = 0;
    for (int i = 0; i < 9; i++) {
        const double start = read_clock(CLOCK_MONOTONIC), cpu_start = read_clock(CLOCK_PROCESS_CPUTIME_ID);
        run_effort(&e, t, whole_objects);
        const double taken = read_clock(CLOCK_MONOTONIC) - start;
        const double cpu = read_clock(CLOCK_PROCESS_CPUTIME_ID) - cpu_start;
        if (i == 0 || taken < least) least = taken;
        if (i == 0 || cpu < *out_cpu) *out_cpu = cpu;
        *out_hash = hash_objects(&e);
        for (uint32_t k = 0; k < e.count; k++) CHECK(dm_object_destroy(e.world.context, e.objects[k]));
    }
    bench_world_close(&e.world);
    return least;
}

static void grow_jobs(const char* models, uint32_t most) {
    for (int whole_objects = 0; whole_objects < 2; whole_objects++) {
        bench_mesh mesh = bench_mesh_new(JOB_TRIANGLES, whole_objects ? 1 : JOB_OBJECTS);
        double alone = 0, cpu = 0;
        uint64_t first = 0;
        for (uint32_t workers = 1; workers <= most; workers *= 2) {
            team t = {workers};
            uint64_t hash = 0;
            const double taken = time_team(&t, models, &mesh, whole_objects, &cpu, &hash);
            if (workers == 1) alone = taken, first = hash;
            printf("{\"tasks\": \"%s\", \"workers\": %u, \"prepare_ms\": %.2f, \"cpu_ms\": %.2f, \"speedup\": %.2f, "
                   "\"same_bits\": %s}\n",
                   whole_objects ? "objects" : "parts", workers, taken * 1e-6, cpu * 1e-6, alone / taken,
                   hash == first ? "true" : "false");
            fflush(stdout);
        }
        bench_mesh_free(&mesh);
    }
}

/* ---- loading side by side ---- */

typedef struct load_effort {
    bench_world world;
    uint8_t* saved; /* .dmo */
    size_t size;
} load_effort;

static void DM_CALL load_task(void* data, uint32_t index) {
    const load_effort* e = data;
    (void)index;
    dm_object object;
    CHECK(dm_object_load(e->world.context, e->saved, e->size, e->world.model, &object));
    CHECK(dm_object_destroy(e->world.context, object));
}

static void save_one(load_effort* e, const bench_mesh* mesh, uint32_t flags) {
    const dm_object object = bench_world_prepare(&e->world, mesh, flags);
    e->size = saved_size(&e->world, object);
    e->saved = bench_alloc(e->size);
    CHECK(dm_object_save(e->world.context, object, e->saved, e->size, &e->size));
    CHECK(dm_object_destroy(e->world.context, object));
}

/* The host's workers load and destroy an object each, over and over; the least time by the wall of some rounds. */
static void grow_loads(const char* models, uint32_t most, uint32_t flags, uint32_t count) {
    load_effort e;
    bench_mesh mesh = bench_mesh_new(LOAD_TRIANGLES, 1);
    bench_world_open(&e.world, models, NULL);
    save_one(&e, &mesh, flags);
    double alone = 0;
    for (uint32_t workers = 1; workers <= most; workers *= 2) {
        team t = {workers};
        double least = INFINITY;
        for (int i = 0; i < LOAD_ROUNDS; i++) {
            const double start = read_clock(CLOCK_MONOTONIC);
            run_team(&t, count, load_task, &e);
            least = fmin(least, read_clock(CLOCK_MONOTONIC) - start);
        }
        if (workers == 1) alone = least;
        printf("{\"tasks\": \"%s\", \"workers\": %u, \"load_us\": %.2f, \"speedup\": %.2f}\n",
               flags ? "bare loads" : "loads", workers, least * 1e-3 / count, alone / least);
        fflush(stdout);
    }
    free(e.saved);
    bench_world_close(&e.world);
    bench_mesh_free(&mesh);
}

int main(int argc, char** argv) {
    const char* what = argc > 1 ? argv[1] : "";
    const uint32_t most = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 0;
    const char* models = argc > 3 ? argv[3] : "sdk/models";
    bench_world world;
    if (strcmp(what, "jobs") == 0) {
        grow_jobs(models, most ? most : 2);
        grow_loads(models, most ? most : 2, 0, LOADS);
        grow_loads(models, most ? most : 2, DM_PREPARE_WITHOUT_PICKING, BARE_LOADS);
        return 0;
    }
    bench_world_open(&world, models, NULL);
    if (strcmp(what, "triangles") == 0)
        grow_triangles(&world, most ? most : 4096000);
    else if (strcmp(what, "parts") == 0)
        grow_parts(&world, most ? most : 256);
    else if (strcmp(what, "drags") == 0)
        grow_drags(&world, most ? most : 100000);
    else
        fprintf(stderr, "bench_growth triangles|parts|drags|jobs [most [models]]\n");
    bench_world_close(&world);
    return 0;
}
