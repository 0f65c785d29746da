/* Fuzz target: prepared objects. The checksum is set right first, so that the fuzzer reaches what lies behind it;
 * whatever the bytes, the answer is an error or an object that can be asked, saved and picked. */
#include <stdlib.h>
#include <string.h>

#include "dragmesh/dragmesh.h"
#include "kinematics/object/dmo_format.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

static void use(dm_context* context, dm_object object) {
    dm_object_info info = {.struct_size = sizeof info};
    if (dm_object_get_info(context, object, &info) != DM_OK) abort();
    for (uint32_t i = 0; i < info.part_count; i++) {
        dm_part_info part = {.struct_size = sizeof part};
        dm_joint joint = {.struct_size = sizeof joint};
        dm_pose pose;
        if (dm_object_get_part(context, object, i, &part) != DM_OK) abort();
        if (dm_object_get_joint(context, object, part.id, &joint) != DM_OK) abort();
        dm_joint_pose(&joint, 1.0f, &pose);
    }
    size_t size = 0;
    if (dm_object_save(context, object, NULL, 0, &size) != DM_OK) abort();
    void* again = malloc(size);
    if (again && dm_object_save(context, object, again, size, &size) != DM_OK) abort();
    free(again);
    dm_scene scene;
    dm_hit hit = {.struct_size = sizeof hit};
    uint32_t instance;
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    const dm_ray ray = {info.box_min, {info.box_max.x - info.box_min.x, info.box_max.y - info.box_min.y, 1.0f}};
    if (dm_scene_create(context, &desc, &scene) != DM_OK) abort();
    if (dm_scene_add(context, scene, object, NULL, &instance) == DM_OK) dm_scene_commit(context, scene);
    dm_scene_pick(context, scene, &ray, &hit);
    dm_scene_destroy(context, scene);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static dm_context* context;
    if (!context && dm_context_create(NULL, &context) != DM_OK) abort();
    uint8_t* bytes = malloc(size > 0 ? size : 1);
    if (!bytes) return 0;
    memcpy(bytes, data, size);
    if (size > 12) {
        uint32_t crc = dmi_dmo_crc(bytes + 12, size - 12);
        for (int i = 0; i < 4; i++) bytes[8 + i] = (uint8_t)(crc >> (8 * i));
    }
    dm_object object;
    if (dm_object_load(context, bytes, size, 0, &object) == DM_OK) {
        use(context, object);
        if (dm_object_destroy(context, object) != DM_OK) abort();
    }
    free(bytes);
    return 0;
}
