/* Prepares an object: mesh -> BVH -> for each part a cloud, the network and the geometry -> joints. */
#include "kinematics/object/prepare.h"

#include <stdio.h>

#include "base/arena_pool.h"
#include "kinematics/analysis/part_analysis.h"
#include "mesh/connectivity.h"
#include "mesh/mesh_repair.h"

/* Parts between two calls of the progress callback when the host's workers run them. */
#define BATCH 32
#define GROUND_BLOCK ((size_t)1 << 16)
#define SCRATCH_BLOCK ((size_t)1 << 20)

/* What one part starts from, gathered before the workers begin. */
typedef struct plan {
    dmi_drag_hint hint;
    int has_hint;
    dm_result result;
} plan;

/* What the studies of all parts share of the mesh. */
typedef struct ground {
    dmi_mesh mesh; /* with the masks as they were meant */
    const uint32_t* welded;
} ground;

typedef struct preparation {
    dmi_env* env;
    const dmi_prepare_desc* desc;
    dmi_object* object;
    plan* plans; /* one a part, the body's unused */
    ground ground;
    dmi_arena_pool scratch; /* of the parts */
    uint32_t first;         /* part of task 0 */
} preparation;

static dm_result report(dmi_env* env, const dmi_prepare_desc* desc, float done) {
    if (!desc->progress || !desc->progress(desc->progress_user, done)) return DM_OK;
    return dmi_fail(env, DM_ERROR_CANCELLED, "dm_object_prepare: the progress callback asked to stop at %.0f %%",
                    (double)(done * 100.0f));
}

/* The one hypothesis about a part that the host says does not move. */
static dmi_hypotheses fixed_joint(const dmi_part* shape) {
    const dm_joint joint = {.type = DM_JOINT_FIXED,
                            .type_confidence = 1.0f,
                            .confidence = 1.0f,
                            .axis = {0.0f, 1.0f, 0.0f},
                            .origin = {shape->centre[0], shape->centre[1], shape->centre[2]},
                            .source = DM_JOINT_FROM_HOST};
    return (dmi_hypotheses){.joints = {joint}, .count = 1};
}

static dm_result lay_ground(dmi_arena* arena, const dmi_mesh* mesh, ground* out) {
    uint32_t* welded = dmi_arena_push(arena, mesh->vertex_count * sizeof *welded);
    if (welded == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to weld %u vertices", mesh->vertex_count);
    dm_result result = dmi_weld_vertices(arena, mesh, DMI_WELD_TOLERANCE, welded);
    out->welded = welded;
    return result == DM_OK ? dmi_mesh_repair(arena, mesh, welded, &out->mesh) : result;
}

/* Cloud -> hypotheses; the best one comes into force. `cloud` is scratch, as the arena is. */
static dm_result infer_part(dmi_arena* arena, dmi_object* object, uint32_t index, const dmi_inference_models* models,
                            const dmi_drag_hint* hint, const ground* ground, dmi_cloud* cloud) {
    dmi_env* env = arena->env;
    dmi_object_part* part = &object->parts[index];
    dm_result result = dmi_cloud_sample(env, &ground->mesh, index, object->seed, cloud);
    if (result != DM_OK) return result;
    const dmi_inference_query query = {.mesh = &ground->mesh,
                                       .cloud = cloud,
                                       .models = *models,
                                       .hint = hint,
                                       .welded = ground->welded,
                                       .scratch = arena,
                                       .part = index,
                                       .given_type = part->given_type,
                                       .network_alone = object->network_alone};
    dmi_hypotheses found;
    dmi_alternatives others = {.count = 0};
    result = part->given_type == DM_JOINT_FIXED ? DM_OK : dmi_joint_inference_run(env, &query, &found, &others);
    if (result != DM_OK) return result;
    if (part->given_type == DM_JOINT_FIXED) found = fixed_joint(&part->shape);
    if (found.count == 0) return dmi_fail(env, DM_ERROR_INTERNAL, "part %u: no hypothesis", part->shape.id);
    part->hypotheses = found;
    part->alternatives = others;
    part->joint = dmi_frame_joint_out(&object->frame, &found.joints[0]);
    return DM_OK;
}

static dm_result prepare_in(dmi_arena* arena, preparation* work, uint32_t index) {
    dmi_object* object = work->object;
    const plan* own = &work->plans[index];
    dmi_cloud* cloud = dmi_arena_push(arena, sizeof *cloud);
    if (!cloud) return dmi_fail(work->env, DM_ERROR_OUT_OF_MEMORY, "dm_object_prepare: no memory for a cloud");
    const dmi_drag_hint* hint = own->has_hint ? &own->hint : NULL;
    dm_result result = infer_part(arena, object, index, &work->desc->models, hint, &work->ground, cloud);
    if (result == DM_OK) dmi_cloud_thin(cloud, object->parts[index].points);
    return result;
}

static void DM_CALL prepare_part(void* data, uint32_t task) {
    preparation* work = data;
    uint32_t index = work->first + task;
    dmi_arena own, *arena = dmi_arena_pool_take(&work->scratch, &own);
    work->plans[index].result = prepare_in(arena, work, index);
    dmi_arena_pool_put(&work->scratch, arena);
}

/* In batches, so that the host hears of progress on its own thread; the part with the lowest index names the error. */
static dm_result prepare_parts(preparation* work) {
    dmi_env* env = work->env;
    uint32_t count = work->object->part_count, batch = env->jobs.parallel_for ? BATCH : 1;
    for (work->first = 1; work->first < count; work->first += batch) {
        uint32_t tasks = count - work->first < batch ? count - work->first : batch;
        dmi_parallel_for(env, tasks, prepare_part, work);
        for (uint32_t i = work->first; i < work->first + tasks; i++) {
            if (work->plans[i].result != DM_OK) return work->plans[i].result;
        }
        dm_result result = report(env, work->desc, 0.1f + 0.9f * (float)(work->first + tasks) / (float)count);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

static dm_result ask_type(dmi_env* env, const dmi_prepare_desc* desc, const dmi_object* object, dmi_object_part* part) {
    if (part->given_type != DM_JOINT_UNKNOWN || !desc->intent) return DM_OK;
    dm_vec3 box_min, box_max;
    dmi_object_box_out(&object->frame, part->shape.box_min, part->shape.box_max, &box_min, &box_max);
    part->given_type = desc->intent(desc->intent_user, part->shape.id, box_min, box_max);
    if (part->given_type >= DM_JOINT_UNKNOWN && part->given_type <= DM_JOINT_FIXED) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_prepare: desc.intent answered %d for part %u",
                    part->given_type, part->shape.id);
}

/* Types and drags of all parts, from the host's descriptors and its callback. */
static dm_result make_plans(preparation* work) {
    const dmi_prepare_desc* desc = work->desc;
    dmi_object* object = work->object;
    for (uint32_t i = 0; desc->parts && i < desc->part_count; i++) {
        const dm_part_desc* given = &desc->parts[i];
        int32_t index = dmi_object_find_part(object, given->id);
        if (index <= 0) return dmi_fail(work->env, DM_ERROR_INTERNAL, "part %u was lost", given->id);
        object->parts[index].given_type = given->joint_type;
        if (!given->drag) continue;
        char what[64];
        snprintf(what, sizeof what, "dm_object_prepare: desc.parts[%u].drag", i);
        dm_result result =
            dmi_object_hint(work->env, what, object, (uint32_t)index, given->drag, &work->plans[index].hint);
        if (result != DM_OK) return result;
        work->plans[index].has_hint = 1;
    }
    for (uint32_t i = 1; i < object->part_count; i++) {
        dm_result result = ask_type(work->env, desc, object, &object->parts[i]);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

/* Lays the ground for all parts once, and prepares them. */
static dm_result lay_and_run(preparation* work) {
    dmi_arena arena;
    dmi_arena_init(&arena, work->env, GROUND_BLOCK);
    dmi_arena_pool_init(&work->scratch, work->env, SCRATCH_BLOCK);
    dm_result result = lay_ground(&arena, work->object->mesh, &work->ground);
    if (result == DM_OK) result = prepare_parts(work);
    dmi_arena_pool_release(&work->scratch);
    dmi_arena_release(&arena);
    return result;
}

static dm_result plan_and_run(preparation* work) {
    size_t size = work->object->part_count * sizeof *work->plans;
    work->plans = dmi_alloc_zeroed(work->env, size, _Alignof(plan));
    if (!work->plans) return dmi_fail(work->env, DM_ERROR_OUT_OF_MEMORY, "dm_object_prepare: no memory for the parts");
    dm_result result = make_plans(work);
    if (result == DM_OK) result = lay_and_run(work);
    dmi_free(work->env, work->plans, size);
    return result;
}

/* The object's own facts, from its mesh, which it takes over. */
static dm_result adopt_mesh(dmi_env* env, dmi_mesh* mesh, uint64_t seed, dmi_object** out_object) {
    dmi_object* object = NULL;
    dm_result result = dmi_object_create(env, mesh->part_count, &object);
    if (result != DM_OK) {
        dmi_mesh_destroy(env, mesh);
        return result;
    }
    object->mesh = mesh;
    object->frame = mesh->frame;
    object->seed = seed;
    object->vertex_count = mesh->vertex_count;
    object->triangle_count = mesh->face_count;
    for (uint32_t i = 0; i < mesh->part_count; i++) object->parts[i].shape = mesh->parts[i];
    dmi_object_bound(object);
    *out_object = object;
    return DM_OK;
}

static dm_result fill(dmi_env* env, dmi_picker* picker, const dmi_prepare_desc* desc, dmi_object* object) {
    dm_result result = report(env, desc, 0.05f);
    if (result == DM_OK && desc->keep_triangles) result = dmi_bvh_create(picker, object->mesh, &object->bvh);
    if (result == DM_OK) result = report(env, desc, 0.1f);
    if (result != DM_OK) return result;
    preparation work = {.env = env, .desc = desc, .object = object};
    result = plan_and_run(&work);
    if (result == DM_OK && !desc->keep_triangles) dmi_object_drop_triangles(env, object);
    return result;
}

dm_result dmi_object_prepare(dmi_env* env, dmi_picker* picker, const dmi_prepare_desc* desc, dmi_object** out_object) {
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_mesh_create(env, desc->axes, desc->mesh, desc->parts, desc->part_count, &mesh);
    if (result != DM_OK) return result;
    dmi_object* object = NULL;
    result = adopt_mesh(env, mesh, desc->seed, &object);
    if (result != DM_OK) return result;
    object->network_alone = desc->network_alone;
    result = fill(env, picker, desc, object);
    if (result != DM_OK) {
        dmi_object_destroy(env, object);
        return result;
    }
    *out_object = object;
    return DM_OK;
}

dm_result dmi_object_refine(dmi_env* env, dmi_object* object, uint32_t part, const dmi_inference_models* models,
                            const dmi_drag_hint* hint) {
    dmi_arena arena;
    dmi_arena_init(&arena, env, SCRATCH_BLOCK);
    dmi_cloud* cloud = dmi_arena_push(&arena, sizeof *cloud);
    ground ground;
    dm_result result = cloud != NULL ? lay_ground(&arena, object->mesh, &ground)
                                     : dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_object_refine: no memory for a cloud");
    if (result == DM_OK) result = infer_part(&arena, object, part, models, hint, &ground, cloud);
    dmi_arena_release(&arena);
    return result;
}
