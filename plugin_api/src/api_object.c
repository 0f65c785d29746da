/* Object handles: prepare, destroy, and queries. */
#include <stdio.h>
#include <string.h>

#include "api_check.h"
#include "api_degraded.h"
#include "api_handles.h"
#include "api_mesh.h"
#include "api_model.h"
#include "api_object.h"
#include "api_scene.h"
#include "base/fp_environment.h"
#include "math/linear3.h"

/* ---- the descriptors of dm_object_prepare ---- */

static dm_result check_flags(dmi_env* env, const dm_object_desc* desc) {
    const uint32_t known = DM_PREPARE_WITHOUT_PICKING | DM_PREPARE_NETWORK_ALONE | DM_PREPARE_MESH_INCOMPLETE;
    if (desc->flags & ~known) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_prepare: desc.flags is 0x%x: unknown flag",
                        desc->flags);
    }
    if (desc->reserved != 0) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_prepare: desc.reserved is %u: it must be 0",
                        desc->reserved);
    }
    if (desc->part_count > DM_MAX_PARTS) {
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_object_prepare: desc.part_count is %u: the most is %d",
                        desc->part_count, DM_MAX_PARTS);
    }
    if ((desc->parts == NULL) != (desc->part_count == 0)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_prepare: desc.parts is %s but desc.part_count is %u",
                        desc->parts != NULL ? "given" : "NULL", desc->part_count);
    }
    return DM_OK;
}

/* Reads the host's part array, whose stride is the host's struct_size. */
static dm_result read_parts(dmi_env* env, const dm_object_desc* desc, dm_part_desc* out) {
    const uint8_t* next = (const uint8_t*)desc->parts;
    uint32_t step = desc->parts[0].struct_size;
    for (uint32_t i = 0; i < desc->part_count; i++) {
        char what[64]; /* fits the text below with ten digits */
        snprintf(what, sizeof what, "dm_object_prepare: desc.parts[%u]", i);
        /* NOLINTNEXTLINE(bugprone-sizeof-expression): the field is a pointer */
        dm_result result = dmi_read_desc(env, what, next, DMI_FIRST_SIZE(dm_part_desc, drag), sizeof *out, &out[i]);
        if (result == DM_OK && out[i].reserved != 0)
            result = dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.reserved is %u: it must be 0", what, out[i].reserved);
        if (result != DM_OK) return result;
        if (out[i].struct_size != step) {
            return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "%s.struct_size is %u, but that of the first part is %u", what,
                            out[i].struct_size, step);
        }
        snprintf(what, sizeof what, "dm_object_prepare: desc.parts[%u].joint_type", i);
        result = dmi_check_range(env, what, out[i].joint_type, DM_JOINT_UNKNOWN, DM_JOINT_FIXED);
        if (result != DM_OK) return result;
        next += step;
    }
    return DM_OK;
}

/* ---- features of the motion network ---- */

typedef struct encoding {
    dm_context* context;
    dmi_object_slot* slot;
    const dmi_dq_vae* network;
} encoding;

static void DM_CALL encode_part(void* data, uint32_t task) {
    const encoding* work = data;
    dmi_dq_vae_prepare(work->network, work->context->isa, &work->slot->object->parts[task + 1].points,
                       &work->slot->features[task + 1]);
}

static dm_result encode(dm_context* context, const char* function, dmi_object_slot* slot, const dmi_model_slot* model) {
    if (model == NULL || model->motion == NULL) return DM_OK;
    dmi_env* env = &context->env;
    uint32_t count = slot->object->part_count;
    encoding work = {.context = context, .slot = slot, .network = model->motion};
    slot->features = dmi_alloc(env, count * sizeof *slot->features, _Alignof(dmi_vae_object));
    if (slot->features == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for the motion network's features", function);
    return dmi_parallel_for(env, count - 1, encode_part, &work);
}

/* ---- prepare and destroy ---- */

dm_result dmi_object_publish(dm_context* context, const char* function, dmi_object* object, dm_model model,
                             uint32_t unmissed, dm_object* out_object) {
    dmi_env* env = &context->env;
    dmi_object_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_object_slot));
    if (slot == NULL) {
        dmi_object_destroy(env, object);
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "%s: no memory", function);
    }
    slot->object = object;
    slot->model = model;
    dm_result result = encode(context, function, slot, dmi_pool_get(context->models, model));
    uint64_t handle = 0;
    if (result == DM_OK) result = dmi_pool_insert(context->objects, slot, &handle);
    if (result != DM_OK) {
        dmi_object_release(context, slot);
        return result;
    }
    dmi_degraded_warn(env, function, dmi_degraded_of(slot) & ~unmissed);
    *out_object = handle;
    return DM_OK;
}

static dm_result prepare(dm_context* context, const dm_object_desc* desc, const dm_part_desc* parts,
                         dm_object* out_object) {
    dmi_env* env = &context->env;
    dm_mesh_desc mesh;
    dm_result result = dmi_mesh_desc_read(env, "dm_object_prepare: desc.mesh", desc->mesh, &mesh);
    if (result != DM_OK) return result;
    const dmi_model_slot* model = NULL;
    if (desc->model) {
        model = dmi_find(context, context->models, "dm_object_prepare: desc.model", desc->model);
        if (model == NULL) return DM_ERROR_STALE_HANDLE;
    }
    if ((desc->flags & DM_PREPARE_NETWORK_ALONE) && !(model != NULL && model->kinematics != NULL))
        return dmi_fail(env, DM_ERROR_NO_MODEL,
                        "dm_object_prepare: desc.flags asks for the network alone, but desc.model has none");
    const dmi_prepare_desc inner = {.axes = &context->axes,
                                    .mesh = &mesh,
                                    .parts = parts,
                                    .part_count = desc->part_count,
                                    .models = dmi_inference_models_of(context, model),
                                    .labels = {.label = desc->label, .up = desc->up},
                                    .seed = desc->seed,
                                    .network_alone = (desc->flags & DM_PREPARE_NETWORK_ALONE) != 0,
                                    .mesh_is_incomplete = (desc->flags & DM_PREPARE_MESH_INCOMPLETE) != 0,
                                    .keep_triangles = !(desc->flags & DM_PREPARE_WITHOUT_PICKING),
                                    .intent = desc->intent,
                                    .intent_user = desc->intent_user,
                                    .choose = desc->choose,
                                    .choose_user = desc->choose_user,
                                    .progress = desc->progress,
                                    .progress_user = desc->progress_user};
    dmi_object* object = NULL;
    result = dmi_object_prepare(env, context->picker, &inner, &object);
    if (result != DM_OK) return result;
    return dmi_object_publish(context, "dm_object_prepare", object, desc->model, 0, out_object);
}

dm_result DM_CALL dm_object_prepare(dm_context* context, const dm_object_desc* desc, dm_object* out_object) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_object_desc known;
    dm_result result = dmi_read_desc(env, "dm_object_prepare: desc", desc,
                                     DMI_FIRST_SIZE(dm_object_desc, progress_user), sizeof known, &known);
    if (result == DM_OK) result = check_flags(env, &known);
    if (result != DM_OK) return result;
    if (out_object == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_prepare: out_object is NULL");
    if (known.parts == NULL) return prepare(context, &known, NULL, out_object);
    size_t size = known.part_count * sizeof(dm_part_desc);
    dm_part_desc* parts = dmi_alloc(env, size, _Alignof(dm_part_desc));
    if (parts == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_object_prepare: no memory for %u parts", known.part_count);
    result = read_parts(env, &known, parts);
    if (result == DM_OK) result = prepare(context, &known, parts, out_object);
    dmi_free(env, parts, size);
    return result;
}

static void release_dependents(dm_context* context, dmi_pool* pool, dmi_dependent* first, size_t size) {
    while (first != NULL) {
        dmi_dependent* next = first->next;
        dmi_pool_remove(pool, first->handle);
        dmi_free(&context->env, first, size);
        first = next;
    }
}

void dmi_object_release(dm_context* context, dmi_object_slot* slot) {
    release_dependents(context, context->motions, slot->motions, sizeof(dmi_motion_slot));
    release_dependents(context, context->drags, slot->drags, sizeof(dmi_drag_slot));
    dmi_free(&context->env, slot->features, slot->object->part_count * sizeof *slot->features);
    dmi_free(&context->env, slot->links, slot->link_count * sizeof *slot->links);
    dmi_object_destroy(&context->env, slot->object);
    dmi_free(&context->env, slot, sizeof *slot);
}

dm_result DM_CALL dm_object_destroy(dm_context* context, dm_object object) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_object_slot* slot = dmi_take(context, context->objects, "dm_object_destroy", object);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_scenes_remove_object(context, slot);
    dmi_object_release(context, slot);
    return DM_OK;
}

/* ---- queries ---- */

dm_result DM_CALL dm_object_get_info(dm_context* context, dm_object object, dm_object_info* out_info) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result = dmi_check_out(&context->env, "dm_object_get_info: out_info", out_info,
                                     DMI_FIRST_SIZE(dm_object_info, pickable));
    if (result != DM_OK) return result;
    const dmi_object_slot* slot = dmi_find(context, context->objects, "dm_object_get_info", object);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    const dmi_object* inner = slot->object;
    dm_object_info info = {.part_count = inner->part_count - 1,
                           .vertex_count = inner->vertex_count,
                           .triangle_count = inner->triangle_count,
                           .size = dmi_frame_length_out(&inner->frame),
                           .pickable = inner->bvh != NULL,
                           .degraded = dmi_degraded_of(slot),
                           .picking = dmi_bvh_picking(inner->bvh)};
    dmi_object_box_out(&inner->frame, inner->box_min, inner->box_max, &info.box_min, &info.box_max);
    dmi_write_out(out_info, &info, sizeof info);
    return DM_OK;
}

dm_result DM_CALL dm_object_get_part(dm_context* context, dm_object object, uint32_t index, dm_part_info* out_info) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result =
        dmi_check_out(&context->env, "dm_object_get_part: out_info", out_info, DMI_FIRST_SIZE(dm_part_info, area));
    if (result != DM_OK) return result;
    const dmi_object_slot* slot = dmi_find(context, context->objects, "dm_object_get_part", object);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    const dmi_object* inner = slot->object;
    if (index >= inner->part_count - 1) {
        return dmi_fail(&context->env, DM_ERROR_NOT_FOUND, "dm_object_get_part: index is %u of %u parts", index,
                        inner->part_count - 1);
    }
    const dm_part_info info = dmi_object_part_out(inner, index + 1);
    dmi_write_out(out_info, &info, sizeof info);
    return DM_OK;
}
