/* Our calls beside bare Embree, memcpy and cglm, in one run: bench_peers [triangles [models]]. One JSON object a line,
 * nanoseconds a call; peers/run puts PyTorch and oneDNN beside it. */
#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bare_embree.h"
#include "world.h"

#define ROUND_MS 800
#define RAYS 1024
#define POINTS 100000
#define KINEMATICS_TRIANGLES 100000
#define CHECK(call) bench_check(call, #call)

typedef struct peers {
    bench_world world;
    dm_object object, small; /* to be picked; to be understood */
    dm_scene scene;
    RTCScene flat, instanced, robust;
    dm_ray rays[RAYS];
    uint32_t ray, hits;
    dm_pose pose;
    mat4 matrix;
    float *src, *dst;
} peers;

static void show(const char* who, const char* what, peers* p, void (*call)(void*)) {
    double least;
    const double median = bench_median_ns(call, p, ROUND_MS, &least);
    printf("{\"who\": \"%s\", \"what\": \"%s\", \"median_ns\": %.1f, \"least_ns\": %.1f}\n", who, what, median, least);
    fflush(stdout);
}

static const dm_ray* next_ray(peers* p) {
    return &p->rays[p->ray++ % RAYS];
}

static void pick_ours(void* user) {
    peers* p = user;
    dm_hit hit = {.struct_size = sizeof hit};
    CHECK(dm_scene_pick(p->world.context, p->scene, next_ray(p), &hit));
    p->hits += hit.object != 0;
}

static void pick_bare(peers* p, RTCScene scene) {
    const dm_ray* ray = next_ray(p);
    const float origin[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const float direction[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    p->hits += bare_embree_hits(scene, origin, direction);
}

static void pick_flat(void* user) {
    peers* p = user;
    pick_bare(p, p->flat);
}

static void pick_instanced(void* user) {
    peers* p = user;
    pick_bare(p, p->instanced);
}

static void pick_robust(void* user) {
    peers* p = user;
    pick_bare(p, p->robust);
}

static void apply_ours(void* user) {
    peers* p = user;
    dm_pose_apply_points(&p->pose, p->src, 0, p->dst, 0, POINTS);
}

static void apply_memcpy(void* user) {
    peers* p = user;
    memcpy(p->dst, p->src, POINTS * 3 * sizeof(float));
    __asm__ volatile("" : : "r"(p->dst) : "memory");
}

static void apply_cglm(void* user) {
    peers* p = user;
    for (size_t i = 0; i < POINTS; i++) glm_mat4_mulv3(p->matrix, p->src + 3 * i, 1, p->dst + 3 * i);
    __asm__ volatile("" : : "r"(p->dst) : "memory");
}

static void motion_ours(void* user) {
    peers* p = user;
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = 1, .drag = bench_mesh_drag(1)};
    dm_motion motion;
    CHECK(dm_motion_generate(p->world.context, p->small, &desc, &motion));
    CHECK(dm_motion_destroy(p->world.context, motion));
}

static void kinematics_ours(void* user) {
    peers* p = user;
    const dm_drag_hint drag = bench_mesh_drag(1);
    CHECK(dm_object_refine(p->world.context, p->small, 1, &drag));
}

/* Rays of a camera in front of the cabinet, most of which hit it. */
static void make_rays(peers* p) {
    for (uint32_t i = 0; i < RAYS; i++) {
        const float x = (float)(i * 421 % 1021) / 1021 - 0.5f, y = (float)(i * 733 % 1019) / 1019 - 0.5f;
        p->rays[i] = (dm_ray){{0.25f, 0.4f, 2}, {0.3f * x, 0.5f * y, -1}};
    }
}

static void compare_picking(peers* p, uint32_t triangles) {
    RTCDevice device = rtcNewDevice("threads=1");
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    uint32_t instance;
    bench_mesh mesh = bench_mesh_new(triangles, 1);
    p->object = bench_world_prepare(&p->world, &mesh, 0);
    CHECK(dm_scene_create(p->world.context, &desc, &p->scene));
    CHECK(dm_scene_add(p->world.context, p->scene, p->object, NULL, &instance));
    CHECK(dm_scene_commit(p->world.context, p->scene));
    p->flat = bare_embree_part(device, &mesh, BARE_EMBREE_ALL, RTC_SCENE_FLAG_NONE);
    p->instanced = bare_embree_instances(device, &mesh, 1, NULL, RTC_SCENE_FLAG_NONE);
    p->robust = bare_embree_instances(device, &mesh, 1, NULL,
                                      RTC_SCENE_FLAG_ROBUST); /* no ray between two triangles, as ours */
    make_rays(p);
    show("dragmesh", "pick", p, pick_ours);
    show("embree, instances, robust", "pick", p, pick_robust);
    show("embree, instances", "pick", p, pick_instanced);
    show("embree, one mesh", "pick", p, pick_flat);
    rtcReleaseScene(p->flat);
    rtcReleaseScene(p->instanced);
    rtcReleaseScene(p->robust);
    rtcReleaseDevice(device);
    bench_mesh_free(&mesh);
}

static void compare_points(peers* p) {
    p->pose = (dm_pose){{0, 0.08715574f, 0, 0.9961947f}, {0, 0, 0, 0}};
    dm_pose_to_matrix(&p->pose, (float*)p->matrix);
    p->src = bench_alloc(POINTS * 3 * sizeof(float));
    p->dst = bench_alloc(POINTS * 3 * sizeof(float));
    memset(p->src, 0, POINTS * 3 * sizeof(float));
    memset(p->dst, 0, POINTS * 3 * sizeof(float));
    show("dragmesh", "points", p, apply_ours);
    show("memcpy", "points", p, apply_memcpy);
    show("cglm", "points", p, apply_cglm);
    free(p->src);
    free(p->dst);
}

int main(int argc, char** argv) {
    static peers p;
    bench_world_open(&p.world, argc > 2 ? argv[2] : "sdk/models", NULL);
    bench_mesh mesh = bench_mesh_new(KINEMATICS_TRIANGLES, 1);
    p.small = bench_world_prepare(&p.world, &mesh, 0);
    show("dragmesh", "kinematics", &p, kinematics_ours);
    bench_world_hinge(&p.world, p.small, 1, DM_JOINT_REVOLUTE);
    show("dragmesh", "motion", &p, motion_ours);
    compare_points(&p);
    compare_picking(&p, argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1000000);
    bench_world_close(&p.world);
    bench_mesh_free(&mesh);
    return 0;
}
