/* A level of many instances: placing, moving, and rays that graze, beside bare Embree: bench_level [instances]. One
 * JSON object a line, processor time of this thread. A ratio of two versions: run both, by turns. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bare_embree.h"
#include "world.h"

#define INSTANCES 100000
#define GRAZED 10000   /* instances of the scene that rays graze */
#define TRIANGLES 2000 /* of each */
#define WAVE 1000      /* instances that are added between two commits */
#define PITCH 3.0f     /* units between instances */
#define BUILDS 3
#define ROUNDS 7
#define ROUND_MS 100
#define MOVES 5 /* rounds of moves */
#define RAYS 1024
#define HEIGHT 0.8f /* of an instance */
#define CHECK(call) bench_check(call, #call)

typedef struct level {
    dm_context* context;
    dm_object object;
    dm_scene scene;
    RTCScene bare;
    dm_ray rays[RAYS];
    uint32_t ray, hits, turn;
} level;

/* ---- placing ---- */

static void open_scene(level* l) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    CHECK(dm_scene_create(l->context, &desc, &l->scene));
}

/* A square, row by row. */
static void place_of(uint32_t i, uint32_t count, float out[3]) {
    const uint32_t side = (uint32_t)ceil(sqrt((double)count));
    out[0] = PITCH * (float)(i % side);
    out[1] = 0;
    out[2] = PITCH * (float)(i / side);
}

static void add_instances(level* l, uint32_t count, uint32_t wave) {
    for (uint32_t i = 0; i < count; i++) {
        float at[3];
        uint32_t instance;
        place_of(i, count, at);
        const dm_pose pose = {{0, 0, 0, 1}, {0.5f * at[0], 0.5f * at[1], 0.5f * at[2], 0}};
        CHECK(dm_scene_add(l->context, l->scene, l->object, &pose, &instance));
        if ((i + 1) % wave == 0) CHECK(dm_scene_commit(l->context, l->scene));
    }
    CHECK(dm_scene_commit(l->context, l->scene));
}

/* The least of some builds, each in a scene of its own; the last one stays. */
static void time_placing(level* l, uint32_t count, uint32_t wave, const char* what) {
    double best = INFINITY;
    for (int i = 0; i < BUILDS; i++) {
        open_scene(l);
        const double start = bench_now_ns();
        add_instances(l, count, wave);
        best = fmin(best, bench_now_ns() - start);
        if (i + 1 < BUILDS) CHECK(dm_scene_destroy(l->context, l->scene));
    }
    printf("{\"what\": \"%s\", \"instances\": %u, \"ms\": %.2f}\n", what, count, best / 1e6);
    fflush(stdout);
}

/* ---- moving ---- */

/* Doors all over the level, each a little farther open than a round ago. */
static void move_doors(level* l, uint32_t count, uint32_t moved) {
    const float angle = 0.05f * (float)(++l->turn % 30);
    const dm_pose pose = {{0, sinf(angle), 0, cosf(angle)}, {0.1f * sinf(angle), 0, 0, 0}};
    for (uint32_t i = 0; i < moved; i++) {
        const uint32_t instance = (uint32_t)((uint64_t)i * count / moved);
        CHECK(dm_scene_move(l->context, l->scene, instance, 1, &pose));
    }
    CHECK(dm_scene_commit(l->context, l->scene));
}

static void time_moves(level* l, uint32_t count, uint32_t moved) {
    double best = INFINITY;
    for (int i = 0; i < MOVES; i++) {
        const double start = bench_now_ns();
        move_doors(l, count, moved);
        best = fmin(best, bench_now_ns() - start);
    }
    printf("{\"what\": \"move\", \"instances\": %u, \"moved\": %u, \"ms\": %.3f, \"us_each\": %.3f}\n", count, moved,
           best / 1e6, best / 1e3 / moved);
    fflush(stdout);
}

/* ---- grazing rays ---- */

static const dm_ray* next_ray(level* l) {
    return &l->rays[l->ray++ % RAYS];
}

static void pick_ours(void* user) {
    level* l = user;
    dm_hit hit = {.struct_size = sizeof hit};
    CHECK(dm_scene_pick(l->context, l->scene, next_ray(l), &hit));
    l->hits += hit.object != 0;
}

static void pick_bare(void* user) {
    level* l = user;
    const dm_ray* ray = next_ray(l);
    const float origin[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const float direction[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    l->hits += (uint32_t)bare_embree_hits(l->bare, origin, direction);
}

/* Along the level at the height of the tops: through many boxes, and past many instances. */
static void make_grazing_rays(level* l, uint32_t count) {
    const float size = PITCH * ceilf(sqrtf((float)count));
    for (uint32_t i = 0; i < RAYS; i++) {
        const float x = (float)(i * 421 % 1021) / 1021, y = (float)(i * 733 % 1019) / 1019;
        const dm_vec3 eye = {size * x, HEIGHT * (0.9f + 0.2f * y), -2};
        const dm_vec3 target = {size * y, HEIGHT * (0.9f + 0.2f * x), size};
        l->rays[i] = (dm_ray){eye, {target.x - eye.x, target.y - eye.y, target.z - eye.z}};
    }
}

/* By turns, the least of the rounds' medians. */
static void compare_rays(level* l, const char* who) {
    double ours = INFINITY, bare = INFINITY;
    for (int i = 0; i < ROUNDS; i++) {
        bare = fmin(bare, bench_median_ns(pick_bare, l, ROUND_MS, NULL));
        ours = fmin(ours, bench_median_ns(pick_ours, l, ROUND_MS, NULL));
    }
    l->hits = 0;
    for (int i = 0; i < RAYS; i++) pick_ours(l);
    printf("{\"what\": \"graze\", \"who\": \"%s\", \"ns\": %.1f, \"bare_ns\": %.1f, \"ratio\": %.3f, \"hits\": %u}\n",
           who, ours, bare, ours / bare, l->hits);
    fflush(stdout);
}

static void compare_grazing(const bench_mesh* mesh, int32_t choice, const char* who) {
    static level l;
    const dm_context_desc desc = {.struct_size = sizeof desc, .picking = choice};
    const dm_mesh_desc shape = bench_mesh_desc(mesh);
    const dm_object_desc object = {.struct_size = sizeof object, .mesh = &shape, .seed = 1};
    RTCDevice device = rtcNewDevice("threads=1");
    float* places = bench_alloc(3 * GRAZED * sizeof(float));
    for (uint32_t i = 0; i < GRAZED; i++) place_of(i, GRAZED, places + 3 * (size_t)i);
    CHECK(dm_context_create(&desc, &l.context));
    CHECK(dm_object_prepare(l.context, &object, &l.object));
    open_scene(&l);
    add_instances(&l, GRAZED, GRAZED);
    make_grazing_rays(&l, GRAZED);
    l.bare = bare_embree_instances(device, mesh, GRAZED, places, RTC_SCENE_FLAG_ROBUST);
    compare_rays(&l, who);
    rtcReleaseScene(l.bare);
    rtcReleaseDevice(device);
    dm_context_destroy(l.context);
    free(places);
}

int main(int argc, char** argv) {
    static level l;
    const uint32_t count = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : INSTANCES;
    const dm_context_desc desc = {.struct_size = sizeof desc, .picking = DM_PICK_PORTABLE};
    bench_mesh mesh = bench_mesh_new(TRIANGLES, 1);
    const dm_mesh_desc shape = bench_mesh_desc(&mesh);
    const dm_object_desc object = {.struct_size = sizeof object, .mesh = &shape, .seed = 1};
    CHECK(dm_context_create(&desc, &l.context));
    CHECK(dm_object_prepare(l.context, &object, &l.object));
    time_placing(&l, count, count, "place at once");
    CHECK(dm_scene_destroy(l.context, l.scene));
    time_placing(&l, count, WAVE, "place in waves");
    for (uint32_t moved = count / 1000; moved > 0 && moved <= count; moved *= 10) time_moves(&l, count, moved);
    dm_context_destroy(l.context);
    compare_grazing(&mesh, DM_PICK_EMBREE, "dragmesh, embree");
    compare_grazing(&mesh, DM_PICK_PORTABLE, "dragmesh, portable");
    bench_mesh_free(&mesh);
    return 0;
}
