/* Scene handles, and the camera. */
#include "api_scene.h"

#include <math.h>

#include "api_check.h"
#include "api_handles.h"
#include "base/fp_environment.h"
#include "math/dual_quat.h"
#include "pick/pick.h"

dm_result DM_CALL dm_camera_ray(const dm_context* context, const dm_camera* camera, float x, float y, dm_ray* out_ray) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_camera known;
    dm_result result =
        dmi_read_desc(DMI_SILENT, "camera", camera, DMI_FIRST_SIZE(dm_camera, ortho_height), sizeof known, &known);
    if (result != DM_OK) return result;
    if (!isfinite(x) || !isfinite(y)) return DM_ERROR_NOT_FINITE;
    dm_ray ray;
    if (out_ray == NULL || !dmi_camera_ray(&known, context->axes.handedness, x, y, &ray))
        return DM_ERROR_INVALID_ARGUMENT;
    if (!isfinite(ray.origin.x) || !isfinite(ray.origin.y) || !isfinite(ray.origin.z)) return DM_ERROR_NOT_FINITE;
    *out_ray = ray;
    return DM_OK;
}

/* ---- create and destroy ---- */

dm_result DM_CALL dm_scene_create(dm_context* context, const dm_scene_desc* desc, dm_scene* out_scene) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_scene_desc known;
    dm_result result = dmi_read_desc(env, "dm_scene_create: desc", desc, DMI_FIRST_SIZE(dm_scene_desc, reserved),
                                     sizeof known, &known);
    if (result != DM_OK) return result;
    if (known.reserved != 0) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_scene_create: desc.reserved is %u: it must be 0",
                        known.reserved);
    }
    if (out_scene == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_scene_create: out_scene is NULL");
    dmi_scene_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_scene_slot));
    if (slot == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_scene_create: no memory");
    uint64_t handle = 0;
    result = dmi_scene_create(context->picker, &slot->scene);
    if (result == DM_OK) result = dmi_pool_insert(context->scenes, slot, &handle);
    if (result != DM_OK) {
        if (slot->scene != NULL) dmi_scene_destroy(slot->scene);
        dmi_free(env, slot, sizeof *slot);
        return result;
    }
    *out_scene = handle;
    return DM_OK;
}

static void link_to_scene(dmi_placement* placement) {
    dmi_placement** first = &placement->scene->placements;
    placement->next_of_scene = *first;
    placement->link_of_scene = first;
    if (*first != NULL) (*first)->link_of_scene = &placement->next_of_scene;
    *first = placement;
}

static void link_to_object(dmi_placement* placement) {
    dmi_placement** first = &placement->object->placements;
    placement->next_of_object = *first;
    placement->link_of_object = first;
    if (*first != NULL) (*first)->link_of_object = &placement->next_of_object;
    *first = placement;
}

static void link_placement(dm_context* context, dmi_placement* placement) {
    dmi_lock(context);
    link_to_scene(placement);
    link_to_object(placement);
    dmi_unlock(context);
}

static void unlink_placement(dm_context* context, dmi_placement* placement) {
    dmi_lock(context);
    *placement->link_of_scene = placement->next_of_scene;
    if (placement->next_of_scene != NULL) placement->next_of_scene->link_of_scene = placement->link_of_scene;
    *placement->link_of_object = placement->next_of_object;
    if (placement->next_of_object != NULL) placement->next_of_object->link_of_object = placement->link_of_object;
    dmi_unlock(context);
    dmi_free(&context->env, placement, sizeof *placement);
}

void dmi_scene_release(dm_context* context, dmi_scene_slot* slot) {
    while (slot->placements != NULL) unlink_placement(context, slot->placements);
    dmi_scene_destroy(slot->scene);
    dmi_free(&context->env, slot, sizeof *slot);
}

void dmi_scenes_remove_object(dm_context* context, dmi_object_slot* slot) {
    while (slot->placements != NULL) {
        dmi_scene_remove(slot->placements->scene->scene, slot->placements->instance);
        unlink_placement(context, slot->placements);
    }
}

dm_result DM_CALL dm_scene_destroy(dm_context* context, dm_scene scene) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_scene_slot* slot = dmi_take(context, context->scenes, "dm_scene_destroy", scene);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_scene_release(context, slot);
    return DM_OK;
}

/* ---- instances and picking ---- */

dm_result DM_CALL dm_scene_add(dm_context* context, dm_scene scene, dm_object object, const dm_pose* pose,
                               uint32_t* out_instance) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dmi_scene_slot* slot = dmi_find(context, context->scenes, "dm_scene_add", scene);
    dmi_object_slot* owner = slot != NULL ? dmi_find(context, context->objects, "dm_scene_add", object) : NULL;
    if (owner == NULL) return DM_ERROR_STALE_HANDLE;
    dm_pose unit = dmi_pose_identity();
    dm_result result = pose != NULL ? dmi_check_pose(env, "dm_scene_add: placement", pose, &unit) : DM_OK;
    if (result != DM_OK) return result;
    if (out_instance == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_scene_add: out_instance is NULL");
    if (owner->object->bvh == NULL) {
        return dmi_fail(env, DM_ERROR_UNSUPPORTED,
                        "dm_scene_add: the object kept no triangles (DM_PREPARE_WITHOUT_PICKING)");
    }
    dmi_placement* placement = dmi_alloc_zeroed(env, sizeof *placement, _Alignof(dmi_placement));
    if (placement == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_scene_add: no memory");
    *placement = (dmi_placement){.scene = slot, .object = owner};
    result = dmi_scene_add(slot->scene, owner->object->bvh, &owner->object->frame, object, &unit, &placement->instance);
    if (result != DM_OK) {
        dmi_free(env, placement, sizeof *placement);
        return result;
    }
    *out_instance = placement->instance;
    dmi_scene_set_user(slot->scene, placement->instance, placement);
    link_placement(context, placement);
    return DM_OK;
}

dm_result DM_CALL dm_scene_move(dm_context* context, dm_scene scene, uint32_t instance, uint32_t part_id,
                                const dm_pose* pose) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_scene_slot* slot = dmi_pool_get(context->scenes, scene);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_pose unit;
    dm_result result = dmi_check_pose(DMI_SILENT, "pose", pose, &unit);
    if (result != DM_OK) return result;
    return dmi_scene_move(slot->scene, instance, part_id, &unit);
}

dm_result DM_CALL dm_scene_remove(dm_context* context, dm_scene scene, uint32_t instance) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_scene_slot* slot = dmi_find(context, context->scenes, "dm_scene_remove", scene);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_placement* placement = dmi_scene_user(slot->scene, instance);
    const dm_result result = dmi_scene_remove(slot->scene, instance);
    if (result == DM_OK) unlink_placement(context, placement);
    return result;
}

dm_result DM_CALL dm_scene_commit(dm_context* context, dm_scene scene) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_scene_slot* slot = dmi_pool_get(context->scenes, scene);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_scene_commit(slot->scene);
    return DM_OK;
}

dm_result DM_CALL dm_scene_pick(dm_context* context, dm_scene scene, const dm_ray* ray, dm_hit* out_hit) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_scene_slot* slot = dmi_pool_get(context->scenes, scene);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_result result = dmi_check_ray(DMI_SILENT, "ray", ray);
    if (result != DM_OK) return result;
    dm_hit other;
    const uint32_t given = out_hit != NULL ? out_hit->struct_size : 0;
    const bool ours = given == sizeof other; /* mostly: no check of the size, no copy */
    if (!ours) result = dmi_check_out(DMI_SILENT, "out_hit", out_hit, DMI_FIRST_SIZE(dm_hit, object_point));
    if (result != DM_OK) return result;
    dm_hit* hit = ours ? out_hit : &other;
    dmi_scene_pick(slot->scene, ray, hit);
    if (!ours) dmi_write_out(out_hit, &other, sizeof other);
    out_hit->struct_size = given;
    return DM_OK;
}
