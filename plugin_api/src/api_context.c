/* Creates and destroys contexts: the host's hooks, the frames, and one pool for each kind of handle. */
#include <math.h>
#include <string.h>

#include "api_asset.h"
#include "api_check.h"
#include "api_handles.h"
#include "api_model.h"
#include "api_object.h"
#include "api_scene.h"
#include "base/fp_environment.h"

#define DEFAULT_KEPT ((uint64_t)32 << 20) /* bytes: what one worker needs for a prop, and the weights; by hand */

static dm_result check_hooks(dmi_env* env, const dm_context_desc* desc) {
    if ((desc->allocator.allocate == NULL) != (desc->allocator.release == NULL)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_context_create: desc.allocator must have both allocate and release, or none");
    }
    if (!isfinite(desc->unit_in_metres) || desc->unit_in_metres < 0.0f) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_context_create: desc.unit_in_metres is %g: it must be positive",
                        (double)desc->unit_in_metres);
    }
    return dmi_check_range(env, "dm_context_create: desc.axes", desc->axes, DM_AXES_GLTF, DM_AXES_CUSTOM);
}

static dm_result check_picking(dmi_env* env, const dm_context_desc* desc) {
    if (desc->reserved != 0) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_context_create: desc.reserved is %u: it must be 0",
                        desc->reserved);
    }
    return dmi_check_range(env, "dm_context_create: desc.picking", desc->picking, DM_PICK_AUTO, DM_PICK_NONE);
}

static dm_result init_context(dm_context* context, const dm_context_desc* desc) {
    dmi_env* env = &context->env;
    float unit = desc->unit_in_metres > 0.0f ? desc->unit_in_metres : 1.0f;
    if (!dmi_axes_init(&context->axes, desc->axes, desc->custom_axes, unit)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_context_create: desc.custom_axes is not an orthogonal matrix");
    }
    context->isa = dmi_cpu_best_isa();
    struct {
        dmi_pool** pool;
        uint8_t kind;
    } pools[] = {{&context->models, DMI_KIND_MODEL},   {&context->objects, DMI_KIND_OBJECT},
                 {&context->motions, DMI_KIND_MOTION}, {&context->drags, DMI_KIND_DRAG},
                 {&context->scenes, DMI_KIND_SCENE},   {&context->assets, DMI_KIND_ASSET}};
    for (size_t i = 0; i < sizeof pools / sizeof *pools; i++) {
        dm_result result = dmi_pool_create(env, pools[i].kind, pools[i].pool);
        if (result != DM_OK) return result;
    }
    return dmi_picker_create(env, desc->picking, &context->picker);
}

/* Allocates the context's own block through an environment that outlives it. */
static dm_context* allocate_context(dmi_env* outer, const dm_context_desc* desc) {
    dm_context* context = dmi_alloc_zeroed(outer, sizeof *context, _Alignof(dm_context));
    if (context == NULL) return NULL;
    dmi_env_init(&context->env, &outer->allocator, &outer->log, &outer->jobs);
    context->env.progress = desc->progress;
    context->env.progress_user = desc->progress_user;
    const uint64_t kept = desc->kept_bytes > 0 ? desc->kept_bytes : DEFAULT_KEPT;
    context->env.kept.most = kept < SIZE_MAX ? (size_t)kept : SIZE_MAX;
    context->env.bytes = context->env.peak_bytes = sizeof *context;
    context->env.allocations = 1;
    atomic_flag_clear(&context->lock);
    return context;
}

dm_result DM_CALL dm_context_create(const dm_context_desc* desc, dm_context** out_context) {
    DMI_OWN_FP;
    if (out_context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_context_desc known = {.struct_size = sizeof known};
    dmi_env outer;
    dmi_env_init(&outer, NULL, NULL, NULL);
    dm_result result = DM_OK;
    if (desc != NULL) {
        result = dmi_read_desc(&outer, "dm_context_create: desc", desc, DMI_FIRST_SIZE(dm_context_desc, jobs),
                               sizeof known, &known);
    }
    if (result != DM_OK) return result;
    dmi_env_init(&outer, NULL, &known.log, NULL);
    result = check_hooks(&outer, &known);
    if (result == DM_OK) result = check_picking(&outer, &known);
    if (result != DM_OK) return result;
    dmi_env_init(&outer, &known.allocator, &known.log, &known.jobs);
    dm_context* context = allocate_context(&outer, &known);
    if (context == NULL)
        return dmi_fail(&outer, DM_ERROR_OUT_OF_MEMORY, "dm_context_create: no memory for the context");
    result = init_context(context, &known);
    if (result != DM_OK) {
        dm_context_destroy(context);
        return result;
    }
    *out_context = context;
    return DM_OK;
}

/* Releases scenes before the objects they show, and objects (with drags and motions) before the models they use. */
static void empty_pools(dm_context* context) {
    uint64_t handle = 0;
    while (context->scenes != NULL && dmi_pool_any(context->scenes, &handle) != NULL) {
        dmi_scene_release(context, dmi_pool_remove(context->scenes, handle));
    }
    while (context->objects != NULL && dmi_pool_any(context->objects, &handle) != NULL) {
        dmi_object_release(context, dmi_pool_remove(context->objects, handle));
    }
    while (context->assets != NULL && dmi_pool_any(context->assets, &handle) != NULL) {
        dmi_asset_release(context, dmi_pool_remove(context->assets, handle));
    }
    while (context->models != NULL && dmi_pool_any(context->models, &handle) != NULL) {
        dmi_model_release(context, dmi_pool_remove(context->models, handle));
    }
}

void DM_CALL dm_context_destroy(dm_context* context) {
    if (context == NULL) return;
    empty_pools(context);
    dmi_pool_destroy(context->assets);
    dmi_pool_destroy(context->scenes);
    dmi_pool_destroy(context->drags);
    dmi_pool_destroy(context->motions);
    dmi_pool_destroy(context->objects);
    dmi_pool_destroy(context->models);
    if (context->picker != NULL) dmi_picker_destroy(context->picker);
    dmi_env_trim(&context->env);
    dmi_env outer;
    dmi_env_init(&outer, &context->env.allocator, &context->env.log, &context->env.jobs);
    dmi_free(&outer, context, sizeof *context);
}

dm_result DM_CALL dm_context_get_memory(const dm_context* context, dm_memory_info* out_info) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &((dm_context*)context)->env; /* the environment holds the log */
    dm_result result =
        dmi_check_out(env, "dm_context_get_memory: out_info", out_info, DMI_FIRST_SIZE(dm_memory_info, pick_bytes));
    if (result != DM_OK) return result;
    const dm_memory_info info = {.bytes = env->bytes,
                                 .peak_bytes = env->peak_bytes,
                                 .allocations = env->allocations,
                                 .pick_bytes = env->pick_bytes,
                                 .kept_bytes = dmi_kept_bytes(&env->kept)};
    dmi_write_out(out_info, &info, sizeof info);
    return DM_OK;
}

dm_result DM_CALL dm_context_trim(dm_context* context) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env_trim(&context->env);
    return DM_OK;
}
