/* Prepares an object: mesh -> BVH -> a cloud and a joint inference for each part. Parts run on the host's workers. */
#include "kinematics/object/prepare.h"

#include <stdio.h>

#include "base/arena.h"
#include "kinematics/analysis/part_analysis.h"
#include "kinematics/object/prepare_steps.h"
#include "mesh/connectivity.h"
#include "mesh/mesh_repair.h"

#define BATCH 32                        /* parts between two calls of the progress callback, with workers; by hand */
#define SCRATCH_BLOCK ((size_t)1 << 20) /* bytes, of the arenas; by hand */
#define MAX_FIELD_NAME 64               /* bytes of a field's name in an error message, with the terminating zero */

/* Input and result of one part's inference. */
typedef struct part_request {
    dmi_drag_hint hint;
    bool has_hint;
    dm_result result;
} part_request;

/* The mesh that all parts' analyses read. */
typedef struct shared_mesh {
    dmi_mesh mesh; /* mesh with repaired part masks */
    const uint32_t* welded;
} shared_mesh;

typedef struct preparation {
    dmi_env* env;
    const dmi_prepare_desc* desc;
    const dmi_progress* progress; /* progress of the whole call */
    dmi_object* object;
    const dmi_mesh* mesh;
    part_request* requests; /* one per part; the body's is unused */
    shared_mesh shared;
    const uint32_t* like; /* per part, the one that is inferred for it, mostly itself; NULL: each is inferred itself */
    dmi_arena_pool scratch; /* arenas of the parts */
    uint32_t first;         /* part of task 0 */
} preparation;

/* Returns the only hypothesis for a part that the host declares fixed. */
static dmi_hypotheses fixed_joint(const dmi_part* shape) {
    const dm_joint joint = {.type = DM_JOINT_FIXED,
                            .type_confidence = 1.0f,
                            .joint_confidence = 1.0f,
                            .axis = {0.0f, 1.0f, 0.0f},
                            .origin = {shape->centre[0], shape->centre[1], shape->centre[2]},
                            .source = DM_JOINT_FROM_HOST};
    return (dmi_hypotheses){.joints = {joint}, .count = 1};
}

/* Welds the vertices and repairs the part masks. */
static dm_result make_shared_mesh(dmi_arena* arena, const dmi_mesh* mesh, const dmi_progress* progress,
                                  shared_mesh* out) {
    uint32_t* welded = dmi_arena_push(arena, mesh->vertex_count * sizeof *welded);
    if (welded == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to weld %u vertices", mesh->vertex_count);
    const dmi_progress welding = dmi_progress_piece(progress, 0, DMI_STAGE_SHARE_WELDED),
                       repairing = dmi_progress_piece(progress, DMI_STAGE_SHARE_WELDED, 1);
    dm_result result = dmi_weld_vertices(arena, mesh, DMI_WELD_TOLERANCE, &welding, welded);
    out->welded = welded;
    if (result == DM_OK) result = dmi_progress_tell(progress, DMI_STAGE_SHARE_WELDED);
    if (result == DM_OK) result = dmi_mesh_repair(arena, mesh, welded, &repairing, &out->mesh);
    return result == DM_OK ? dmi_progress_tell(progress, 1) : result;
}

/* Infers the joint of one part; the best hypothesis becomes the joint in use. `cloud` and the arena are scratch. */
static dm_result infer_part(dmi_arena* arena, dmi_object* object, uint32_t index, const dmi_inference_models* models,
                            const dmi_drag_hint* hint, const shared_mesh* shared, const dmi_progress* progress,
                            dmi_cloud* cloud) {
    dmi_env* env = arena->env;
    dmi_object_part* part = &object->parts[index];
    const dmi_progress inferring = dmi_progress_piece(progress, DMI_STAGE_PART_SAMPLED, 1);
    dm_result result = dmi_cloud_sample(env, &shared->mesh, index, object->seed, cloud);
    if (result == DM_OK) result = dmi_progress_tell(progress, DMI_STAGE_PART_SAMPLED);
    if (result != DM_OK) return result;
    const dmi_inference_query query = {.mesh = &shared->mesh,
                                       .cloud = cloud,
                                       .models = *models,
                                       .hint = hint,
                                       .asset_hints = &part->asset_hints,
                                       .welded = shared->welded,
                                       .scratch = arena,
                                       .progress = &inferring,
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

/* Returns the share that a part has in the whole. Workers report no progress, because the callback is for the calling
 * thread. */
static dmi_progress part_progress(const preparation* work, uint32_t index) {
    const float all = (float)(work->object->part_count - 1);
    const dmi_progress parts = dmi_progress_piece(work->progress, DMI_STAGE_PREPARE_SHARED, 1);
    if (work->env->jobs.parallel_for != NULL) return (dmi_progress){0};
    return dmi_progress_piece(&parts, (float)(index - 1) / all, (float)index / all);
}

static dm_result prepare_in(dmi_arena* arena, preparation* work, uint32_t index) {
    dmi_object* object = work->object;
    const part_request* own = &work->requests[index];
    dmi_cloud* cloud = dmi_arena_push(arena, sizeof *cloud);
    if (cloud == NULL) return dmi_fail(work->env, DM_ERROR_OUT_OF_MEMORY, "dm_object_prepare: no memory for a cloud");
    const dmi_drag_hint* hint = own->has_hint ? &own->hint : NULL;
    const dmi_progress progress = part_progress(work, index);
    dm_result result = infer_part(arena, object, index, &work->desc->models, hint, &work->shared, &progress, cloud);
    if (result == DM_OK) dmi_part_points_of_cloud(cloud, &object->parts[index].points);
    return result;
}

static void DM_CALL prepare_part(void* data, uint32_t task) {
    preparation* work = data;
    const uint32_t index = work->first + task;
    if (work->like != NULL && work->like[index] != index) return;
    dmi_arena own, *arena = dmi_arena_pool_take(&work->scratch, &own);
    work->requests[index].result = prepare_in(arena, work, index);
    dmi_arena_pool_put(&work->scratch, arena);
}

/* Gives their answers to the parts of a batch that are like earlier parts, or like others of the batch. */
static void copy_alike(const preparation* work, uint32_t tasks) {
    for (uint32_t i = work->first; work->like != NULL && i < work->first + tasks; i++)
        if (work->like[i] != i) dmi_alike_part_copy(work->object, work->like[i], i);
}

/* Finds parts that are alike, where there are many. */
static dm_result find_alike(dmi_arena* arena, preparation* work) {
    const uint32_t count = work->object->part_count;
    if (count - 1 < DMI_MANY_PARTS) return DM_OK;
    const dmi_progress asking = dmi_progress_piece(work->progress, DMI_STAGE_PREPARE_SHARED, DMI_STAGE_PREPARE_SHARED);
    uint32_t* like = dmi_arena_push(arena, count * sizeof *like);
    uint8_t* excluded = dmi_arena_push(arena, count);
    if (like == NULL || excluded == NULL)
        return dmi_fail(work->env, DM_ERROR_OUT_OF_MEMORY, "dm_object_prepare: no memory for %u parts", count);
    for (uint32_t i = 0; i < count; i++) excluded[i] = work->requests[i].has_hint;
    const dm_result result = dmi_alike_parts_find(arena, &work->shared.mesh, work->object, excluded, &asking, like);
    work->like = like;
    return result;
}

/* Asks the host to choose among the hypotheses of the parts of a batch. */
static dm_result choose_joints(const preparation* work, uint32_t tasks) {
    const dmi_prepare_desc* desc = work->desc;
    dm_result result = DM_OK;
    for (uint32_t i = work->first; desc->choose != NULL && i < work->first + tasks && result == DM_OK; i++)
        result = dmi_choose_joint(work->env, work->object, work->mesh, i, desc->choose, desc->choose_user);
    return result;
}

/* Infers all parts in batches, so that choices are asked and progress is reported on this thread. Returns the error of
 * the part with the lowest index. */
static dm_result prepare_parts(preparation* work) {
    dmi_env* env = work->env;
    uint32_t count = work->object->part_count, batch = env->jobs.parallel_for != NULL ? BATCH : 1;
    for (work->first = 1; work->first < count; work->first += batch) {
        uint32_t tasks = count - work->first < batch ? count - work->first : batch;
        dm_result result = dmi_parallel_for(env, tasks, prepare_part, work);
        if (result != DM_OK) return result;
        for (uint32_t i = work->first; i < work->first + tasks; i++) {
            if (work->requests[i].result != DM_OK) return work->requests[i].result;
        }
        copy_alike(work, tasks);
        result = choose_joints(work, tasks);
        if (result != DM_OK) return result;
        const float done = (float)(work->first + tasks - 1) / (float)(count - 1);
        result = dmi_progress_tell(work->progress, DMI_STAGE_PREPARE_SHARED + (1 - DMI_STAGE_PREPARE_SHARED) * done);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

static dm_result ask_type(dmi_env* env, const dmi_prepare_desc* desc, const dmi_object* object, dmi_object_part* part) {
    if (part->given_type != DM_JOINT_UNKNOWN || desc->intent == NULL) return DM_OK;
    dm_vec3 box_min, box_max;
    dmi_object_box_out(&object->frame, part->shape.box_min, part->shape.box_max, &box_min, &box_max);
    part->given_type = desc->intent(desc->intent_user, part->shape.id, box_min, box_max);
    if (part->given_type >= DM_JOINT_UNKNOWN && part->given_type <= DM_JOINT_FIXED) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_prepare: desc.intent answered %d for part %u",
                    part->given_type, part->shape.id);
}

/* Sets types, drags and hints of all parts from the host's descriptors and its callback. */
static dm_result make_requests(preparation* work) {
    const dmi_prepare_desc* desc = work->desc;
    dmi_object* object = work->object;
    dm_result result =
        dmi_object_read_hints(work->env, work->mesh, object, &desc->labels, desc->parts, desc->part_count);
    if (result != DM_OK) return result;
    for (uint32_t i = 0; desc->parts != NULL && i < desc->part_count; i++) {
        const dm_part_desc* given = &desc->parts[i];
        int32_t index = dmi_object_find_part(object, given->id);
        if (index <= 0) return dmi_fail(work->env, DM_ERROR_INTERNAL, "part %u was lost", given->id);
        object->parts[index].given_type = given->joint_type;
        if (given->drag == NULL) continue;
        char what[MAX_FIELD_NAME];
        snprintf(what, sizeof what, "dm_object_prepare: desc.parts[%u].drag", i);
        result = dmi_object_hint(work->env, what, object, (uint32_t)index, given->drag, &work->requests[index].hint);
        if (result != DM_OK) return result;
        work->requests[index].has_hint = true;
    }
    for (uint32_t i = 1; i < object->part_count; i++) {
        result = ask_type(work->env, desc, object, &object->parts[i]);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

/* Makes the shared mesh, and infers all parts with it. */
static dm_result run_requests(preparation* work) {
    dmi_arena arena;
    dmi_arena_init(&arena, work->env, SCRATCH_BLOCK);
    dmi_arena_pool_init(&work->scratch, work->env, SCRATCH_BLOCK);
    const dmi_progress sharing =
        dmi_progress_piece(work->progress, DMI_STAGE_PREPARE_TREES_BUILT, DMI_STAGE_PREPARE_SHARED);
    dm_result result = make_shared_mesh(&arena, work->mesh, &sharing, &work->shared);
    if (result == DM_OK) result = find_alike(&arena, work);
    if (result == DM_OK) result = prepare_parts(work);
    dmi_arena_pool_release(&work->scratch);
    dmi_arena_release(&arena);
    return result;
}

static dm_result infer_joints(preparation* work) {
    size_t size = work->object->part_count * sizeof *work->requests;
    work->requests = dmi_alloc_zeroed(work->env, size, _Alignof(part_request));
    if (work->requests == NULL)
        return dmi_fail(work->env, DM_ERROR_OUT_OF_MEMORY, "dm_object_prepare: no memory for the parts");
    dm_result result = make_requests(work);
    if (result == DM_OK) result = run_requests(work);
    dmi_free(work->env, work->requests, size);
    return result;
}

/* Creates the object of a mesh. */
static dm_result make_object(dmi_env* env, const dmi_mesh* mesh, uint64_t seed, dmi_object** out_object) {
    dmi_object* object = NULL;
    dm_result result = dmi_object_create(env, mesh->part_count, &object);
    if (result != DM_OK) return result;
    object->frame = mesh->frame;
    object->seed = seed;
    object->vertex_count = mesh->vertex_count;
    object->triangle_count = mesh->face_count;
    for (uint32_t i = 0; i < mesh->part_count; i++) object->parts[i].shape = mesh->parts[i];
    dmi_object_bound(object);
    *out_object = object;
    return DM_OK;
}

/* Notes which weights the inference of a part was without. */
static void note_missing(const dmi_inference_models* models, dmi_object* object) {
    bool inferred = false;
    for (uint32_t i = 1; i < object->part_count; i++)
        inferred = inferred || object->parts[i].given_type != DM_JOINT_FIXED;
    if (inferred && models->kpp == NULL) object->degraded |= DM_DEGRADED_NO_KINEMATICS;
    if (inferred && models->joints == NULL && !object->network_alone) object->degraded |= DM_DEGRADED_NO_RANKER;
}

/* Keeps the triangles, and builds the trees, where the host wants them. */
static dm_result keep_triangles(dmi_env* env, dmi_picker* picker, const dmi_prepare_desc* desc,
                                const dmi_progress* progress, const dmi_mesh* mesh, dmi_object* object) {
    const dmi_progress packing = dmi_progress_piece(progress, DMI_STAGE_PREPARE_MESH_READ, DMI_STAGE_PREPARE_PACKED),
                       building = dmi_progress_piece(progress, DMI_STAGE_PREPARE_PACKED, DMI_STAGE_PREPARE_TREES_BUILT);
    const bool trees = !desc->without_trees;
    const dmi_unpacked all = dmi_unpacked_of(mesh);
    if (!desc->keep_triangles) return DM_OK;
    const dm_result result = dmi_object_pack(env, &all, trees && dmi_picker_is_wide(picker), &packing, object);
    return result == DM_OK && trees ? dmi_object_make_trees(picker, NULL, &building, object) : result;
}

static dm_result prepare_object(dmi_env* env, dmi_picker* picker, const dmi_prepare_desc* desc,
                                const dmi_progress* progress, const dmi_mesh* mesh, dmi_object* object) {
    dm_result result = dmi_progress_tell(progress, DMI_STAGE_PREPARE_MESH_READ);
    if (result == DM_OK) result = keep_triangles(env, picker, desc, progress, mesh, object);
    if (result == DM_OK) result = dmi_progress_tell(progress, DMI_STAGE_PREPARE_TREES_BUILT);
    if (result != DM_OK) return result;
    preparation work = {.env = env, .desc = desc, .progress = progress, .object = object, .mesh = mesh};
    result = infer_joints(&work);
    if (result == DM_OK) note_missing(&desc->models, object);
    return result;
}

static dm_result prepare_mesh(dmi_env* env, dmi_picker* picker, const dmi_prepare_desc* desc,
                              const dmi_progress* progress, const dmi_mesh* mesh, dmi_object** out_object) {
    dmi_object* object = NULL;
    dm_result result = make_object(env, mesh, desc->seed, &object);
    if (result != DM_OK) return result;
    object->network_alone = desc->network_alone;
    if (desc->mesh_is_incomplete) object->degraded |= DM_DEGRADED_MESH;
    result = prepare_object(env, picker, desc, progress, mesh, object);
    if (result != DM_OK) {
        dmi_object_destroy(env, object);
        return result;
    }
    *out_object = object;
    return DM_OK;
}

dm_result dmi_object_prepare(dmi_env* env, dmi_picker* picker, const dmi_prepare_desc* desc, dmi_object** out_object) {
    float told;
    dmi_progress progress = dmi_progress_of(env, "dm_object_prepare", &told);
    if (desc->progress != NULL) {
        progress.progress = desc->progress;
        progress.user = desc->progress_user;
    }
    if (desc->watched != NULL) progress = *desc->watched;
    const dmi_progress reading = dmi_progress_piece(&progress, 0, DMI_STAGE_PREPARE_MESH_READ);
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_mesh_create(env, desc->axes, desc->mesh, desc->parts, desc->part_count, &reading, &mesh);
    if (result != DM_OK) return result;
    result = prepare_mesh(env, picker, desc, &progress, mesh, out_object);
    dmi_mesh_destroy(env, mesh);
    return result;
}

static dm_result refine_in(dmi_arena* arena, dmi_object* object, uint32_t part, const dmi_inference_models* models,
                           const dmi_drag_hint* hint, const dmi_progress* progress, const dmi_mesh* mesh) {
    const dmi_progress sharing = dmi_progress_piece(progress, DMI_STAGE_REFINE_UNPACKED, DMI_STAGE_REFINE_SHARED),
                       inferring = dmi_progress_piece(progress, DMI_STAGE_REFINE_SHARED, 1);
    dmi_cloud* cloud = dmi_arena_push(arena, sizeof *cloud);
    if (cloud == NULL) return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "dm_object_refine: no memory for a cloud");
    shared_mesh shared;
    const dm_result result = make_shared_mesh(arena, mesh, &sharing, &shared);
    return result == DM_OK ? infer_part(arena, object, part, models, hint, &shared, &inferring, cloud) : result;
}

dm_result dmi_object_refine(dmi_env* env, dmi_object* object, uint32_t part, const dmi_inference_models* models,
                            const dmi_drag_hint* hint) {
    float told;
    const dmi_progress progress = dmi_progress_of(env, "dm_object_refine", &told),
                       unpacking = dmi_progress_piece(&progress, 0, DMI_STAGE_REFINE_UNPACKED);
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_object_unpack(env, object, &unpacking, &mesh);
    if (result != DM_OK) return result;
    dmi_arena arena;
    dmi_arena_init(&arena, env, SCRATCH_BLOCK);
    result = refine_in(&arena, object, part, models, hint, &progress, mesh);
    dmi_arena_release(&arena);
    dmi_mesh_destroy(env, mesh);
    return result;
}
