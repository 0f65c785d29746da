/* Opening, preparing, closing. */
#include "world.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void* DM_CALL count_allocate(void* user, size_t size, size_t alignment) {
    ++*(_Atomic uint64_t*)user;
    if (alignment < sizeof(void*)) alignment = sizeof(void*);
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

static void DM_CALL count_release(void* user, void* memory, size_t size) {
    (void)user;
    (void)size;
    free(memory);
}

static void DM_CALL print_message(void* user, int32_t level, dm_result code, const char* message) {
    (void)user;
    fprintf(stderr, "bench: %d %d: %s\n", level, code, message);
}

void bench_check(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "bench: %s: %s\n", what, dm_result_string(result));
    exit(1);
}

static void* read_weights(const char* folder, const char* name, size_t* out_size) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.safetensors", folder, name);
    *out_size = 0;
    return access(path, R_OK) == 0 ? bench_read(path, out_size) : NULL;
}

void bench_world_open(bench_world* world, const char* models, const dm_jobs* jobs) {
    *world = (bench_world){.context = NULL};
    dm_context_desc context = {.struct_size = sizeof context};
    context.allocator = (dm_allocator){(void*)&world->allocations, count_allocate, count_release};
    context.log = (dm_log){NULL, print_message};
    if (jobs != NULL) context.jobs = *jobs;
    bench_check(dm_context_create(&context, &world->context), "dm_context_create");
    dm_model_desc model = {.struct_size = sizeof model};
    void* kinematics = read_weights(models, "kpp_net", &model.kinematics_size);
    void* motion = read_weights(models, "dq_vae", &model.motion_size);
    void* ranker = read_weights(models, "ranker", &model.ranker_size);
    model.kinematics = kinematics;
    model.motion = motion;
    model.ranker = ranker;
    bench_check(dm_model_load(world->context, &model, &world->model), "dm_model_load");
    free(kinematics);
    free(motion);
    free(ranker);
}

dm_object bench_world_prepare(bench_world* world, const bench_mesh* mesh, uint32_t flags) {
    const dm_mesh_desc desc = bench_mesh_desc(mesh);
    const dm_object_desc object = {
        .struct_size = sizeof object, .flags = flags, .mesh = &desc, .model = world->model, .seed = 1};
    dm_object prepared;
    bench_check(dm_object_prepare(world->context, &object, &prepared), "dm_object_prepare");
    return prepared;
}

void bench_world_hinge(bench_world* world, dm_object object, uint32_t part, int32_t type) {
    const dm_vec3 handle = bench_mesh_drag(part).point;
    const dm_joint joint = {.struct_size = sizeof joint,
                            .type = type,
                            .axis = {0, type == DM_JOINT_PRISMATIC ? 0 : -1.0f, type == DM_JOINT_PRISMATIC ? 1.0f : 0},
                            .origin = {handle.x - 0.458f, 0.4f, 0.012f},
                            .upper = type == DM_JOINT_PRISMATIC ? 0.4f : 2.0f};
    bench_check(dm_object_set_joint(world->context, object, part, &joint), "dm_object_set_joint");
}

void bench_world_close(bench_world* world) {
    dm_context_destroy(world->context);
}
