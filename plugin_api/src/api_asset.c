/* Asset handles: they are made of a host's nodes, queried, and made into objects. */
#include "api_asset.h"

#include <math.h>
#include <string.h>

#include "api_asset_nodes.h"
#include "api_check.h"
#include "api_degraded.h"
#include "api_joint_check.h"
#include "api_model.h"
#include "api_object.h"
#include "base/fp_environment.h"

#define NODES_BLOCK ((size_t)1 << 14) /* bytes of a block of the arena of copied nodes; by hand */
#define USUAL_MOVES 0.5f              /* dm_asset_desc.min_moves by default */

/* ---- dm_asset_create ---- */

static dm_result check_desc(dmi_env* env, const dm_asset_desc* desc) {
    const uint32_t known =
        DM_PREPARE_WITHOUT_PICKING | DM_PREPARE_MESH_INCOMPLETE | DM_ASSET_WITHOUT_CLIPS | DM_ASSET_WITHOUT_NAMES;
    if (desc->flags & ~known)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_asset_create: desc.flags is 0x%x: unknown flag",
                        desc->flags);
    if (desc->reserved != 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_asset_create: desc.reserved is %u: it must be 0",
                        desc->reserved);
    const float up[3] = {desc->up.x, desc->up.y, desc->up.z};
    dm_result result = dmi_check_finite(env, "dm_asset_create: desc.min_moves", &desc->min_moves, 1);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_asset_create: desc.up", up, 3);
    if (result == DM_OK && (desc->min_moves < 0 || desc->min_moves > 1))
        result = dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_asset_create: desc.min_moves is %g: it must be 0 to 1",
                          (double)desc->min_moves);
    return result;
}

/* Returns the degraded answers of an asset's joints, without those of motion networks. */
static uint32_t degraded_of(const dmi_asset* asset) {
    if (asset->object == NULL) return 0;
    return asset->object->degraded | (asset->object->parts[0].shape.face_count == 0 ? DM_DEGRADED_NO_BODY : 0);
}

static dm_result publish(dm_context* context, const dm_asset_desc* desc, dmi_asset* asset, dm_asset* out_asset) {
    dmi_env* env = &context->env;
    dmi_asset_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_asset_slot));
    if (slot == NULL) {
        dmi_asset_destroy(env, asset);
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory");
    }
    *slot = (dmi_asset_slot){asset, desc->model, !(desc->flags & DM_PREPARE_WITHOUT_PICKING)};
    uint64_t handle = 0;
    const dm_result result = dmi_pool_insert(context->assets, slot, &handle);
    if (result != DM_OK) {
        dmi_asset_release(context, slot);
        return result;
    }
    dmi_degraded_warn(env, "dm_asset_create", degraded_of(asset));
    if (asset->warnings & DM_ASSET_CLIP_LEFT_OUT)
        dmi_warn(env, "dm_asset_create: a clip is left out: it moves a node as no joint does, or is not rigid");
    *out_asset = handle;
    return DM_OK;
}

static dm_result make(dm_context* context, const dm_asset_desc* desc, dm_asset_node* nodes, dmi_asset_mesh* mesh,
                      const dmi_progress* progress, dmi_asset** out_asset) {
    dmi_env* env = &context->env;
    const dmi_progress merging = dmi_progress_piece(progress, 0, DMI_STAGE_ASSET_MERGED),
                       finding = dmi_progress_piece(progress, DMI_STAGE_ASSET_MERGED, 1);
    const dmi_model_slot* model = NULL;
    if (desc->model) {
        model = dmi_find(context, context->models, "dm_asset_create: desc.model", desc->model);
        if (model == NULL) return DM_ERROR_STALE_HANDLE;
    }
    dm_result result = dmi_asset_mesh_merge(env, nodes, desc->node_count, &merging, mesh);
    if (result == DM_OK) result = dmi_asset_joints_accept(env, nodes, desc->node_count, mesh->size);
    if (result != DM_OK) return result;
    const dmi_asset_desc inner = {.axes = &context->axes,
                                  .nodes = nodes,
                                  .node_count = desc->node_count,
                                  .mesh = mesh,
                                  .models = dmi_inference_models_of(context, model),
                                  .labels = {.label = desc->label, .up = desc->up},
                                  .seed = desc->seed,
                                  .min_moves = desc->min_moves > 0 ? desc->min_moves : USUAL_MOVES,
                                  .use_clips = !(desc->flags & DM_ASSET_WITHOUT_CLIPS),
                                  .use_names = !(desc->flags & DM_ASSET_WITHOUT_NAMES),
                                  .mesh_is_incomplete = (desc->flags & DM_PREPARE_MESH_INCOMPLETE) != 0,
                                  .progress = &finding};
    return dmi_asset_create(env, context->picker, &inner, out_asset);
}

static dm_result create(dm_context* context, const dm_asset_desc* desc, dm_asset* out_asset) {
    dmi_env* env = &context->env;
    float told;
    dmi_progress progress = dmi_progress_of(env, "dm_asset_create", &told);
    if (desc->progress != NULL) {
        progress.progress = desc->progress;
        progress.user = desc->progress_user;
    }
    dmi_arena arena;
    dmi_arena_init(&arena, env, NODES_BLOCK);
    dm_asset_node* nodes = NULL;
    dmi_asset_mesh mesh = {0};
    dmi_asset* asset = NULL;
    dm_result result = dmi_asset_nodes_read(&arena, desc, &nodes);
    if (result == DM_OK) result = make(context, desc, nodes, &mesh, &progress, &asset);
    dmi_asset_mesh_release(env, &mesh);
    dmi_arena_release(&arena);
    return result == DM_OK ? publish(context, desc, asset, out_asset) : result;
}

dm_result DM_CALL dm_asset_create(dm_context* context, const dm_asset_desc* desc, dm_asset* out_asset) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_asset_desc known;
    dm_result result = dmi_read_desc(env, "dm_asset_create: desc", desc, DMI_FIRST_SIZE(dm_asset_desc, reserved),
                                     sizeof known, &known);
    if (result == DM_OK) result = check_desc(env, &known);
    if (result != DM_OK) return result;
    if (out_asset == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_asset_create: out_asset is NULL");
    return create(context, &known, out_asset);
}

void dmi_asset_release(dm_context* context, dmi_asset_slot* slot) {
    dmi_asset_destroy(&context->env, slot->asset);
    dmi_free(&context->env, slot, sizeof *slot);
}

dm_result DM_CALL dm_asset_destroy(dm_context* context, dm_asset asset) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_asset_slot* slot = dmi_take(context, context->assets, "dm_asset_destroy", asset);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_asset_release(context, slot);
    return DM_OK;
}

/* ---- queries ---- */

dm_result DM_CALL dm_asset_get_info(dm_context* context, dm_asset asset, dm_asset_info* out_info) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result =
        dmi_check_out(&context->env, "dm_asset_get_info: out_info", out_info, DMI_FIRST_SIZE(dm_asset_info, warnings));
    if (result != DM_OK) return result;
    const dmi_asset_slot* slot = dmi_find(context, context->assets, "dm_asset_get_info", asset);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    const dmi_asset* inner = slot->asset;
    dm_asset_info info = {.node_count = inner->node_count,
                          .part_count = inner->part_count,
                          .triangle_count = inner->triangle_count,
                          .degraded = degraded_of(inner),
                          .warnings = inner->warnings};
    for (uint32_t i = 0; i < inner->part_count; i++) info.moving_count += inner->parts[i].state != DM_ASSET_STAYS;
    dmi_write_out(out_info, &info, sizeof info);
    return DM_OK;
}

/* Finds the asset and checks the index of one of its parts. */
static dm_result find_part(dm_context* context, const char* function, dm_asset asset, uint32_t index,
                           const dmi_asset** out_asset) {
    const dmi_asset_slot* slot = dmi_find(context, context->assets, function, asset);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    *out_asset = slot->asset;
    if (index < slot->asset->part_count) return DM_OK;
    return dmi_fail(&context->env, DM_ERROR_NOT_FOUND, "%s: index is %u of %u parts", function, index,
                    slot->asset->part_count);
}

dm_result DM_CALL dm_asset_get_part(dm_context* context, dm_asset asset, uint32_t index, dm_asset_part* out_part) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_asset* inner = NULL;
    dm_result result =
        dmi_check_out(&context->env, "dm_asset_get_part: out_part", out_part, DMI_FIRST_SIZE(dm_asset_part, box_max));
    if (result == DM_OK) result = find_part(context, "dm_asset_get_part", asset, index, &inner);
    if (result != DM_OK) return result;
    const dmi_asset_part* part = &inner->parts[index];
    const dm_part_info shape = dmi_object_part_out(inner->object, index + 1);
    const dm_asset_part out = {.parent = part->carrier,
                               .part_id = part->state != DM_ASSET_STAYS ? index + 1 : 0,
                               .state = part->state,
                               .basis = part->given.basis,
                               .moves = part->moves,
                               .node_count = part->node_count,
                               .triangle_count = shape.triangle_count,
                               .duration = part->given.duration,
                               .box_min = shape.box_min,
                               .box_max = shape.box_max};
    dmi_write_out(out_part, &out, sizeof out);
    return DM_OK;
}

dm_result DM_CALL dm_asset_get_joint(dm_context* context, dm_asset asset, uint32_t index, dm_joint* out_joint) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_asset* inner = NULL;
    dm_result result = dmi_joint_check_out(&context->env, "dm_asset_get_joint: out_joint", out_joint);
    if (result == DM_OK) result = find_part(context, "dm_asset_get_joint", asset, index, &inner);
    if (result == DM_OK) dmi_write_out(out_joint, &inner->object->parts[index + 1].joint, sizeof(dm_joint));
    return result;
}

static dm_result copy_numbers(dm_context* context, const char* function, const uint32_t* numbers, uint32_t count,
                              uint32_t* out, uint32_t capacity) {
    if (capacity < count)
        return dmi_fail(&context->env, DM_ERROR_BUFFER_TOO_SMALL, "%s: capacity is %u, there are %u", function,
                        capacity, count);
    if (out == NULL && count > 0)
        return dmi_fail(&context->env, DM_ERROR_INVALID_ARGUMENT, "%s: the output is NULL", function);
    if (count > 0) memcpy(out, numbers, count * sizeof *out);
    return DM_OK;
}

dm_result DM_CALL dm_asset_get_part_nodes(dm_context* context, dm_asset asset, uint32_t index, uint32_t* out_nodes,
                                          uint32_t capacity) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_asset* inner = NULL;
    dm_result result = find_part(context, "dm_asset_get_part_nodes", asset, index, &inner);
    if (result != DM_OK) return result;
    const dmi_asset_part* part = &inner->parts[index];
    return copy_numbers(context, "dm_asset_get_part_nodes", inner->nodes + part->first_node, part->node_count,
                        out_nodes, capacity);
}

dm_result DM_CALL dm_asset_get_node_parts(dm_context* context, dm_asset asset, uint32_t* out_parts, uint32_t capacity) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_asset_slot* slot = dmi_find(context, context->assets, "dm_asset_get_node_parts", asset);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    return copy_numbers(context, "dm_asset_get_node_parts", slot->asset->part_of_node, slot->asset->node_count,
                        out_parts, capacity);
}

/* ---- dm_asset_make_object ---- */

dm_result DM_CALL dm_asset_make_object(dm_context* context, dm_asset asset, dm_object* out_object) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    if (out_object == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_asset_make_object: out_object is NULL");
    const dmi_asset_slot* slot = dmi_find(context, context->assets, "dm_asset_make_object", asset);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_object* object = NULL;
    dm_result result = dmi_asset_make_object(env, context->picker, slot->asset, slot->keep_triangles, &object);
    if (result != DM_OK) return result;
    return dmi_object_publish(context, "dm_asset_make_object", object, slot->model, degraded_of(slot->asset),
                              out_object);
}
