/* Picking with each backend beside bare Embree, in one run and on one thread: bench_pick [triangles]. Builds, rays, and
 * commits against the number of instances. One JSON object a line. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bare_embree.h"
#include "mesh/mesh.h"
#include "pick/pick.h"
#include "test_bvh.h"
#include "world.h"

#define RAYS 1024
#define ROUNDS 7
#define ROUND_MS 100
#define TRIANGLES 1000000
#define SMALL_TRIANGLES 2000 /* of each of many instances */
#define MOST_INSTANCES 16384
#define BUILDS 3
#define PITCH 3.0f /* units between instances */
#define CHECK(call) bench_check(call, #call)

typedef struct world {
    dm_context* context;
    dm_object object;
    dm_scene scene;
} world;

typedef struct bench {
    dm_ray rays[RAYS];
    uint32_t ray, hits;
    world worlds[2]; /* Embree's, the portable one */
    world* current;
    RTCDevice device;
    RTCScene bare;
    uint32_t instances, moved;
} bench;

static const int32_t choices[2] = {DM_PICK_EMBREE, DM_PICK_PORTABLE};
static const char* const names[2] = {"dragmesh, embree", "dragmesh, portable"};

/* ---- contexts and scenes ---- */

static world open_world(int32_t choice) {
    world w = {0};
    const dm_context_desc desc = {.struct_size = sizeof desc, .picking = choice};
    CHECK(dm_context_create(&desc, &w.context));
    return w;
}

static void place_instances(world* w, const float* places, uint32_t count) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    CHECK(dm_scene_create(w->context, &desc, &w->scene));
    for (uint32_t i = 0; i < count; i++) {
        const float* at = places + 3 * (size_t)i;
        const dm_pose pose = {{0, 0, 0, 1}, {0.5f * at[0], 0.5f * at[1], 0.5f * at[2], 0}};
        uint32_t instance;
        CHECK(dm_scene_add(w->context, w->scene, w->object, &pose, &instance));
    }
    CHECK(dm_scene_commit(w->context, w->scene));
}

static void prepare(world* w, const bench_mesh* mesh) {
    const dm_mesh_desc desc = bench_mesh_desc(mesh);
    const dm_object_desc object = {.struct_size = sizeof object, .mesh = &desc, .seed = 1};
    CHECK(dm_object_prepare(w->context, &object, &w->object));
}

/* A square of cabinets. */
static void make_places(float* places, uint32_t count) {
    const uint32_t side = (uint32_t)ceil(sqrt((double)count));
    for (uint32_t i = 0; i < count; i++) {
        places[3 * (size_t)i] = PITCH * (float)(i % side);
        places[3 * (size_t)i + 1] = 0;
        places[3 * (size_t)i + 2] = PITCH * (float)(i / side);
    }
}

/* ---- rays ---- */

static const dm_ray* next_ray(bench* b) {
    return &b->rays[b->ray++ % RAYS];
}

static void pick_ours(void* user) {
    bench* b = user;
    dm_hit hit = {.struct_size = sizeof hit};
    CHECK(dm_scene_pick(b->current->context, b->current->scene, next_ray(b), &hit));
    b->hits += hit.object != 0;
}

static void pick_bare(void* user) {
    bench* b = user;
    const dm_ray* ray = next_ray(b);
    const float origin[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const float direction[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    b->hits += (uint32_t)bare_embree_hits(b->bare, origin, direction);
}

/* The three by turns, so that what else the machine does costs all the same; the least of the rounds' medians. */
static void compare_picks(bench* b, const char* what) {
    double best[3] = {INFINITY, INFINITY, INFINITY};
    for (int round = 0; round < ROUNDS; round++) {
        best[2] = fmin(best[2], bench_median_ns(pick_bare, b, ROUND_MS, NULL));
        for (int i = 0; i < 2; i++) {
            b->current = &b->worlds[i];
            best[i] = fmin(best[i], bench_median_ns(pick_ours, b, ROUND_MS, NULL));
        }
    }
    printf("{\"what\": \"%s\", \"who\": \"embree, instances, robust\", \"ns\": %.1f}\n", what, best[2]);
    for (int i = 0; i < 2; i++) {
        printf("{\"what\": \"%s\", \"who\": \"%s\", \"ns\": %.1f, \"ratio\": %.2f}\n", what, names[i], best[i],
               best[i] / best[2]);
    }
    fflush(stdout);
}

static void pick_one_object(bench* b, uint32_t triangles) {
    static const float origin[3] = {0};
    bench_mesh mesh = bench_mesh_new(triangles, 1);
    for (uint32_t i = 0; i < RAYS; i++) {
        const float x = (float)(i * 421 % 1021) / 1021 - 0.5f, y = (float)(i * 733 % 1019) / 1019 - 0.5f;
        b->rays[i] = (dm_ray){{0.25f, 0.4f, 2}, {0.3f * x, 0.5f * y, -1}};
    }
    b->bare = bare_embree_instances(b->device, &mesh, 1, NULL, RTC_SCENE_FLAG_ROBUST);
    for (int i = 0; i < 2; i++) {
        prepare(&b->worlds[i], &mesh);
        place_instances(&b->worlds[i], origin, 1);
    }
    compare_picks(b, "pick, 1M triangles");
    rtcReleaseScene(b->bare);
    for (int i = 0; i < 2; i++) {
        CHECK(dm_scene_destroy(b->worlds[i].context, b->worlds[i].scene));
        CHECK(dm_object_destroy(b->worlds[i].context, b->worlds[i].object));
    }
    bench_mesh_free(&mesh);
}

/* From above, and from a side along the rows: some rays pass many cabinets. */
static void make_field_rays(bench* b, uint32_t instances) {
    const float size = PITCH * ceilf(sqrtf((float)instances));
    for (uint32_t i = 0; i < RAYS; i++) {
        const float x = (float)(i * 421 % 1021) / 1021, y = (float)(i * 733 % 1019) / 1019;
        const dm_vec3 eye = {0.5f * size, 2, -2}, target = {size * x, 0.8f * y, size * y};
        b->rays[i] = (dm_ray){eye, {target.x - eye.x, target.y - eye.y, target.z - eye.z}};
    }
}

static void pick_many_instances(bench* b, const bench_mesh* mesh, uint32_t instances) {
    float* places = bench_alloc(3 * instances * sizeof(float));
    char what[64];
    make_places(places, instances);
    make_field_rays(b, instances);
    b->bare = bare_embree_instances(b->device, mesh, instances, places, RTC_SCENE_FLAG_ROBUST);
    for (int i = 0; i < 2; i++) place_instances(&b->worlds[i], places, instances);
    snprintf(what, sizeof what, "pick, %u instances", instances);
    compare_picks(b, what);
    rtcReleaseScene(b->bare);
    for (int i = 0; i < 2; i++) CHECK(dm_scene_destroy(b->worlds[i].context, b->worlds[i].scene));
    free(places);
}

/* ---- builds ---- */

static void build_with(const bench_mesh* mesh, int i, double bare) {
    dmi_env env;
    dmi_axes axes;
    dmi_mesh* inner;
    dmi_picker* picker;
    double best = INFINITY;
    const dm_mesh_desc desc = bench_mesh_desc(mesh);
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 1);
    CHECK(dmi_mesh_create(&env, &axes, &desc, NULL, 0, NULL, &inner));
    CHECK(dmi_picker_create(&env, choices[i], &picker));
    const uint64_t before = env.bytes + env.pick_bytes;
    uint64_t bytes = 0;
    for (int round = 0; round < BUILDS; round++) {
        dmi_bvh* bvh;
        const double start = bench_now_ns();
        CHECK(test_bvh_create(picker, inner, NULL, &bvh));
        best = fmin(best, bench_now_ns() - start);
        bytes = env.bytes + env.pick_bytes - before;
        test_bvh_destroy(bvh);
    }
    printf("{\"what\": \"build\", \"who\": \"%s\", \"ms\": %.1f, \"ratio\": %.2f, \"bytes_a_triangle\": %.1f}\n",
           names[i], best / 1e6, best / bare, (double)bytes / (double)mesh->face_count);
    fflush(stdout);
    dmi_picker_destroy(picker);
    dmi_mesh_destroy(&env, inner);
}

static void compare_builds(bench* b, uint32_t triangles) {
    bench_mesh mesh = bench_mesh_new(triangles, 1);
    double bare = INFINITY;
    for (int round = 0; round < BUILDS; round++) {
        const double start = bench_now_ns();
        b->bare = bare_embree_instances(b->device, &mesh, 1, NULL, RTC_SCENE_FLAG_ROBUST);
        bare = fmin(bare, bench_now_ns() - start);
        rtcReleaseScene(b->bare);
    }
    printf("{\"what\": \"build\", \"who\": \"embree\", \"ms\": %.1f}\n", bare / 1e6);
    for (int i = 0; i < 2; i++) build_with(&mesh, i, bare);
    bench_mesh_free(&mesh);
}

/* ---- commits ---- */

/* Opens one door a little and commits. */
static void move_one(void* user) {
    bench* b = user;
    const float angle = 0.01f * (float)(b->moved % 100);
    const dm_pose pose = {{0, sinf(angle), 0, cosf(angle)}, {0.1f * sinf(angle), 0, 0, 0}};
    const uint32_t instance = b->moved++ * 7919u % b->instances;
    CHECK(dm_scene_move(b->current->context, b->current->scene, instance, 1, &pose));
    CHECK(dm_scene_commit(b->current->context, b->current->scene));
}

static void commit_many_instances(bench* b, uint32_t instances) {
    float* places = bench_alloc(3 * instances * sizeof(float));
    make_places(places, instances);
    b->current = &b->worlds[1];
    b->instances = instances;
    const double before = bench_now_ns();
    place_instances(b->current, places, instances);
    const double placed = bench_now_ns();
    double least;
    const double median = bench_median_ns(move_one, b, ROUNDS * ROUND_MS, &least);
    const double removing = bench_now_ns();
    for (uint32_t i = 0; i < instances; i++) CHECK(dm_scene_remove(b->current->context, b->current->scene, i));
    const double removed = bench_now_ns();
    printf("{\"what\": \"commit\", \"instances\": %u, \"move_commit_us\": %.3f, \"place_all_ms\": %.3f, "
           "\"remove_all_ms\": %.3f}\n",
           instances, median / 1e3, (placed - before) / 1e6, (removed - removing) / 1e6);
    fflush(stdout);
    CHECK(dm_scene_destroy(b->current->context, b->current->scene));
    free(places);
}

int main(int argc, char** argv) {
    static bench b;
    const uint32_t triangles = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : TRIANGLES;
    b.device = rtcNewDevice("threads=1");
    for (int i = 0; i < 2; i++) b.worlds[i] = open_world(choices[i]);
    compare_builds(&b, triangles);
    pick_one_object(&b, triangles);
    bench_mesh mesh = bench_mesh_new(SMALL_TRIANGLES, 1);
    for (int i = 0; i < 2; i++) prepare(&b.worlds[i], &mesh);
    for (uint32_t n = 1; n <= MOST_INSTANCES; n *= 4) pick_many_instances(&b, &mesh, n);
    for (uint32_t n = 1; n <= MOST_INSTANCES; n *= 4) commit_many_instances(&b, n);
    for (int i = 0; i < 2; i++) dm_context_destroy(b.worlds[i].context);
    bench_mesh_free(&mesh);
    rtcReleaseDevice(b.device);
    return 0;
}
