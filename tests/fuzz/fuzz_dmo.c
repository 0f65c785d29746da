/* Fuzz target: prepared objects (.dmo). The checksum is set right first, so that the fuzzer reaches what lies behind
 * it; its own four bytes, which do not count then, say in whose axes and unit the file is loaded.
 *
 * Whatever the bytes: an error and nothing kept, or an object of which every number is finite in the host's frame,
 * whose parts can be dragged and picked, and that is the same bytes each time that it is saved and loaded. Memory stays
 * in proportion to the file. */
#include <stdlib.h>
#include <string.h>

#include "host.h"
#include "kinematics/object/dmo_format.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { HOSTS = 4, CHECKSUM_AT = 8, MOST_PARTS = 4, FRAMES = 4 };
enum {
    CONTEXT_BLOCKS = 64
}; /* that a context without objects keeps at most: more than it does, less than leaks add up to */

#define MEMORY_BASE ((size_t)1 << 20) /* bytes that a file of any size may take */
#define MEMORY_FACTOR 64              /* of the file's size, beyond that; by hand: triangles have a tree */

static fuzz_host hosts[HOSTS];
static dm_context* contexts[HOSTS];
static fuzz_host* host;
static dm_context* context;

static void open_contexts(void) {
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

static dm_object_info ask_info(dm_object object) {
    dm_object_info info = {.struct_size = sizeof info};
    fuzz_expect(dm_object_get_info(context, object, &info) == DM_OK);
    fuzz_expect_box(&info.box_min, &info.box_max);
    fuzz_expect(isfinite(info.size) && info.size > 0);
    return info;
}

static dm_part_info ask_part(dm_object object, uint32_t index) {
    dm_part_info part = {.struct_size = sizeof part};
    fuzz_expect(dm_object_get_part(context, object, index, &part) == DM_OK);
    fuzz_expect_box(&part.box_min, &part.box_max);
    fuzz_expect_vector(&part.centre);
    fuzz_expect(isfinite(part.area) && part.area >= 0);
    return part;
}

static void ask_joints(dm_object object, const dm_part_info* part) {
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

static void drag_part(dm_object object, const dm_part_info* part) {
    static uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = part->id, .grab_point = part->centre};
    const float size = ask_info(object).size;
    dm_drag drag;
    const dm_result begun = dm_drag_begin(context, &desc, &drag);
    fuzz_expect_result(begun);
    if (begun != DM_OK) return;
    for (int frame = 0; frame < FRAMES; frame++) {
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

static void pick(dm_object object, const dm_object_info* info) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    const dm_vec3 low = info->box_min, high = info->box_max;
    const dm_ray ray = {low, {high.x - low.x, high.y - low.y, high.z - low.z}};
    dm_hit hit = {.struct_size = sizeof hit};
    dm_scene scene;
    uint32_t instance;
    fuzz_expect(dm_scene_create(context, &desc, &scene) == DM_OK);
    const dm_result added = dm_scene_add(context, scene, object, NULL, &instance);
    fuzz_expect(added == DM_OK || (!info->pickable && added == DM_ERROR_UNSUPPORTED) ||
                added == DM_ERROR_INVALID_ARGUMENT);
    fuzz_expect(dm_scene_commit(context, scene) == DM_OK);
    const dm_result picked = dm_scene_pick(context, scene, &ray, &hit);
    fuzz_expect_result(picked);
    if (picked == DM_OK && hit.object != 0) {
        fuzz_expect_vector(&hit.point);
        fuzz_expect_vector(&hit.normal);
        fuzz_expect_vector(&hit.object_point);
        fuzz_expect(isfinite(hit.distance) && hit.part_id <= UINT16_MAX);
    }
    fuzz_expect(dm_scene_destroy(context, scene) == DM_OK);
}

static uint8_t* save(dm_object object, size_t* out_size) {
    fuzz_expect(dm_object_save(context, object, NULL, 0, out_size) == DM_OK);
    uint8_t* bytes = malloc(*out_size);
    fuzz_expect(bytes != NULL && dm_object_save(context, object, bytes, *out_size, out_size) == DM_OK);
    return bytes;
}

static void save_twice(dm_object object) {
    size_t first_size, second_size;
    dm_object again;
    uint8_t* first = save(object, &first_size);
    fuzz_expect(dm_object_load(context, first, first_size, 0, &again) == DM_OK);
    uint8_t* second = save(again, &second_size);
    fuzz_expect(first_size == second_size && memcmp(first, second, first_size) == 0);
    fuzz_expect(dm_object_destroy(context, again) == DM_OK);
    free(first);
    free(second);
}

static void use(dm_object object) {
    const dm_object_info info = ask_info(object);
    for (uint32_t i = 0; i < info.part_count; i++) {
        const dm_part_info part = ask_part(object, i);
        ask_joints(object, &part);
        if (i < MOST_PARTS) drag_part(object, &part);
    }
    save_twice(object);
    pick(object, &info);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (contexts[0] == NULL) open_contexts();
    const int which = size > CHECKSUM_AT ? data[CHECKSUM_AT] % HOSTS : 0;
    host = &hosts[which], context = contexts[which];
    uint8_t* bytes = malloc(size > 0 ? size : 1);
    if (bytes == NULL) return 0;
    memcpy(bytes, data, size);
    if (size > DMI_DMO_CHECKED_FROM) {
        const uint32_t crc = dmi_dmo_crc(bytes + DMI_DMO_CHECKED_FROM, size - DMI_DMO_CHECKED_FROM);
        for (int i = 0; i < 4; i++) bytes[CHECKSUM_AT + i] = (uint8_t)(crc >> (8 * i));
    }
    dm_object object = 0;
    host->peak = host->bytes;
    const dm_result result = dm_object_load(context, bytes, size, 0, &object);
    fuzz_expect(result == DM_OK || result == DM_ERROR_BAD_DATA || result == DM_ERROR_VERSION);
    fuzz_expect(host->peak - host->bytes <= MEMORY_BASE + MEMORY_FACTOR * size);
    free(bytes);
    if (result == DM_OK) {
        use(object);
        fuzz_expect(dm_object_destroy(context, object) == DM_OK);
    }
    fuzz_expect(host->live <= CONTEXT_BLOCKS);
    return 0;
}
