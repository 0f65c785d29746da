/* Contexts of hosts with other axes and units, and all that can be asked of and done with a prepared object: whatever
 * made it, every number that comes out is finite in the host's frame, and what is saved and loaded is saved as the same
 * bytes.
 */
#ifndef DM_FUZZ_USE_OBJECT_H
#define DM_FUZZ_USE_OBJECT_H

#include <stdlib.h>
#include <string.h>

#include "host.h"

enum { HOSTS = 4, USE_PARTS = 4, USE_FRAMES = 4 }; /* parts that are dragged, updates of a drag */
#define SMALLEST_PICKED 1.001e-6f /* host units: the bounds of dm_scene_add, and a little for rounding */
#define LARGEST_PICKED 0.999e12f
/* Blocks that a context without objects keeps at most: more than it does, less than leaks add up to. */
enum { CONTEXT_BLOCKS = 64 };

static fuzz_host hosts[HOSTS];
static dm_context* contexts[HOSTS];

static inline void open_contexts(void) {
    static const dm_context_desc descs[HOSTS] = {
        {.axes = DM_AXES_GLTF},
        {.axes = DM_AXES_UNREAL, .unit_in_metres = 0.01f},
        {.axes = DM_AXES_CUSTOM,
         .custom_axes = {0.36f, 0.48f, -0.8f, -0.8f, 0.6f, 0, 0.48f, 0.64f, 0.6f},
         .unit_in_metres = 0.3048f},
        {.axes = DM_AXES_BLENDER, .unit_in_metres = 1e-12f}};
    for (int i = 0; i < HOSTS; i++) {
        dm_context_desc desc = descs[i];
        desc.struct_size = sizeof desc;
        desc.allocator = (dm_allocator){&hosts[i], fuzz_allocate, fuzz_release};
        desc.log = (dm_log){&hosts[i], fuzz_message};
        desc.picking = DM_PICK_PORTABLE;
        fuzz_expect(dm_context_create(&desc, &contexts[i]) == DM_OK);
    }
}

/* ---- what an object answers ---- */

static inline dm_object_info use_info(dm_context* context, dm_object object) {
    dm_object_info info = {.struct_size = sizeof info};
    fuzz_expect(dm_object_get_info(context, object, &info) == DM_OK);
    fuzz_expect_box(&info.box_min, &info.box_max);
    fuzz_expect(isfinite(info.size) && info.size > 0);
    return info;
}

static inline dm_part_info use_part(dm_context* context, dm_object object, uint32_t index) {
    dm_part_info part = {.struct_size = sizeof part};
    fuzz_expect(dm_object_get_part(context, object, index, &part) == DM_OK);
    fuzz_expect_box(&part.box_min, &part.box_max);
    fuzz_expect_vector(&part.centre);
    fuzz_expect(isfinite(part.area) && part.area >= 0);
    return part;
}

static inline void use_joints(dm_context* context, dm_object object, const dm_part_info* part) {
    dm_joint joint = {.struct_size = sizeof joint}, joints[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof joint}};
    const dm_drag_hint hint = {part->centre, {0, 0, 1}};
    uint32_t count = 0;
    dm_pose pose;
    fuzz_expect(dm_object_get_joint(context, object, part->id, &joint) == DM_OK);
    fuzz_expect_joint(&joint);
    if (dm_joint_pose(&joint, joint.upper, &pose) == DM_OK) fuzz_expect_pose(&pose);
    for (int way = 0; way < 2; way++) {
        const dm_result result = dm_object_get_hypotheses(context, object, part->id, way == 1 ? &hint : NULL, joints,
                                                          DM_MAX_HYPOTHESES, &count);
        fuzz_expect(result == DM_OK || way == 1);
        for (uint32_t i = 0; result == DM_OK && i < count; i++) fuzz_expect_joint(&joints[i]);
    }
}

/* ---- what can be done with it ---- */

static inline void use_drag(dm_context* context, dm_object object, const dm_part_info* part) {
    static uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = part->id, .grab_point = part->centre};
    const float size = use_info(context, object).size;
    dm_drag drag;
    const dm_result begun = dm_drag_begin(context, &desc, &drag);
    fuzz_expect_result(begun);
    if (begun != DM_OK) return;
    for (int frame = 0; frame < USE_FRAMES; frame++) {
        const float way = 0.1f * size * (float)frame;
        const dm_vec3 c = part->centre;
        const dm_ray ray = {{c.x + way, c.y, c.z + 3 * size}, {way, 0, -1}};
        dm_drag_state state = {.struct_size = sizeof state};
        const dm_result result = dm_drag_update(context, drag, &ray, 1.0f / 60, &state);
        fuzz_expect_result(result);
        if (result == DM_OK) fuzz_expect_state(&state);
    }
    fuzz_expect(dm_drag_save(context, drag, saved, sizeof saved) == DM_OK);
    fuzz_expect_result(dm_drag_restore(context, drag, saved, sizeof saved));
    dm_part_state end = {.struct_size = sizeof end};
    fuzz_expect_result(dm_drag_release(context, drag, NULL, NULL));
    fuzz_expect(dm_drag_end(context, drag, &end) == DM_OK);
    fuzz_expect_pose(&end.pose);
    fuzz_expect_joint(&end.joint);
    fuzz_expect(isfinite(end.value));
}

/* Whether it is the body or a part: ids may be any of 32 bits. */
static inline bool use_has_part(dm_context* context, dm_object object, const dm_object_info* info, uint32_t id) {
    bool has = id == 0;
    for (uint32_t i = 0; i < info->part_count && !has; i++) {
        dm_part_info part = {.struct_size = sizeof part};
        fuzz_expect(dm_object_get_part(context, object, i, &part) == DM_OK);
        has = part.id == id;
    }
    return has;
}

static inline void use_pick(dm_context* context, dm_object object, const dm_object_info* info) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    const dm_vec3 low = info->box_min, high = info->box_max;
    const dm_ray ray = {low, {high.x - low.x, high.y - low.y, high.z - low.z}};
    dm_hit hit = {.struct_size = sizeof hit};
    dm_scene scene;
    uint32_t instance;
    fuzz_expect(dm_scene_create(context, &desc, &scene) == DM_OK);
    const dm_result added = dm_scene_add(context, scene, object, NULL, &instance);
    const bool can_be_picked = info->pickable && info->size >= SMALLEST_PICKED && info->size <= LARGEST_PICKED;
    fuzz_expect(added == DM_OK || (!can_be_picked && added == DM_ERROR_UNSUPPORTED) ||
                added == DM_ERROR_INVALID_ARGUMENT);
    fuzz_expect(dm_scene_commit(context, scene) == DM_OK);
    const dm_result picked = dm_scene_pick(context, scene, &ray, &hit);
    fuzz_expect_result(picked);
    if (picked == DM_OK && hit.object != 0) {
        fuzz_expect_vector(&hit.point);
        fuzz_expect_vector(&hit.normal);
        fuzz_expect_vector(&hit.object_point);
        fuzz_expect(isfinite(hit.distance) && use_has_part(context, object, info, hit.part_id));
    }
    fuzz_expect(dm_scene_destroy(context, scene) == DM_OK);
}

static inline uint8_t* use_save(dm_context* context, dm_object object, size_t* out_size) {
    fuzz_expect(dm_object_save(context, object, NULL, 0, out_size) == DM_OK);
    uint8_t* bytes = malloc(*out_size);
    fuzz_expect(bytes != NULL && dm_object_save(context, object, bytes, *out_size, out_size) == DM_OK);
    return bytes;
}

static inline void use_save_twice(dm_context* context, dm_object object) {
    size_t first_size, second_size;
    dm_object again;
    uint8_t* first = use_save(context, object, &first_size);
    fuzz_expect(dm_object_load(context, first, first_size, 0, &again) == DM_OK);
    uint8_t* second = use_save(context, again, &second_size);
    fuzz_expect(first_size == second_size && memcmp(first, second, first_size) == 0);
    fuzz_expect(dm_object_destroy(context, again) == DM_OK);
    free(first);
    free(second);
}

/* All of the above. */
static inline void use_object(dm_context* context, dm_object object) {
    const dm_object_info info = use_info(context, object);
    for (uint32_t i = 0; i < info.part_count; i++) {
        const dm_part_info part = use_part(context, object, i);
        use_joints(context, object, &part);
        if (i < USE_PARTS) use_drag(context, object, &part);
    }
    use_save_twice(context, object);
    use_pick(context, object, &info);
}

#endif
