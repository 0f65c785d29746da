/* .dmo files: loading restores the saved bits in any host's axes; invalid bytes are reported. */
#include <math.h>
#include <string.h>

#include "../../plugin_api/src/api_handles.h" /* for the features of an object */
#include "kinematics/object/dmo_format.h"
#include "test_world.h"

#define BARE_SIZE 2560 /* bytes of a door without triangles and the handle fixed to it; the door alone: under 2,048 */
#define CORPUS "tests/abi/corpus/cabinet_v1.dmo"

typedef struct bytes {
    uint8_t* data;
    size_t size;
} bytes;

static bytes save(dm_context* context, dm_object object) {
    bytes out = {NULL, 0};
    assert_int_equal(dm_object_save(context, object, NULL, 0, &out.size), DM_OK);
    out.data = malloc(out.size);
    assert_non_null(out.data);
    size_t written = 0;
    assert_int_equal(dm_object_save(context, object, out.data, out.size, &written), DM_OK);
    assert_int_equal(written, out.size);
    return out;
}

/* Makes the cabinet with a hinge of the host for the handle, which is none of the hypotheses. */
static dm_object make_object(test_world* w, uint32_t flags) {
    dm_object object = 0;
    assert_int_equal(test_world_prepare(w, flags, &object), DM_OK);
    const dm_joint hinge = test_hinge();
    assert_int_equal(dm_object_set_joint(w->context, object, TEST_HANDLE, &hinge), DM_OK);
    return object;
}

static void put_u32(uint8_t* at, uint32_t value) {
    for (int i = 0; i < 4; i++) at[i] = (uint8_t)(value >> (8 * i));
}

static void sign_again(bytes* file) {
    put_u32(file->data + 8, dmi_dmo_crc(file->data + 12, file->size - 12));
}

static void assert_same_part(dm_context* a, dm_object in_a, dm_context* b, dm_object in_b, uint32_t index) {
    dm_part_info part_a = {.struct_size = sizeof part_a}, part_b = {.struct_size = sizeof part_b};
    assert_int_equal(dm_object_get_part(a, in_a, index, &part_a), DM_OK);
    assert_int_equal(dm_object_get_part(b, in_b, index, &part_b), DM_OK);
    assert_memory_equal(&part_a, &part_b, sizeof part_a);
    dm_joint ranked_a[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *ranked_a}},
             ranked_b[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *ranked_b}};
    uint32_t count_a = 0, count_b = 0;
    assert_int_equal(dm_object_get_hypotheses(a, in_a, part_a.id, NULL, ranked_a, DM_MAX_HYPOTHESES, &count_a), DM_OK);
    assert_int_equal(dm_object_get_hypotheses(b, in_b, part_a.id, NULL, ranked_b, DM_MAX_HYPOTHESES, &count_b), DM_OK);
    assert_int_equal(count_a, count_b);
    assert_memory_equal(ranked_a, ranked_b, count_a * sizeof *ranked_a);
}

static void test_crc_has_the_standard_check_value(void** state) {
    (void)state;
    assert_int_equal(dmi_dmo_crc((const uint8_t*)"123456789", 9), 0xCBF43926);
}

static void test_loading_gives_the_saved_bits(void** state) {
    (void)state;
    test_world w, fresh;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    test_world_init(&fresh);
    test_world_open(&fresh);
    test_world_load_model(&fresh);
    dm_object object = make_object(&w, 0), loaded = 0;
    bytes file = save(w.context, object);
    assert_int_equal(dm_object_load(fresh.context, file.data, file.size, fresh.model, &loaded), DM_OK);
    dm_object_info a = {.struct_size = sizeof a}, b = {.struct_size = sizeof b};
    assert_int_equal(dm_object_get_info(w.context, object, &a), DM_OK);
    assert_int_equal(dm_object_get_info(fresh.context, loaded, &b), DM_OK);
    assert_int_equal(b.picking, DM_PICK_PORTABLE); /* the file's trees */
    b.picking = a.picking;
    assert_memory_equal(&a, &b, sizeof a);
    dm_joint joint_a = {.struct_size = sizeof joint_a}, joint_b = {.struct_size = sizeof joint_b};
    for (uint32_t i = 0; i < 2; i++) assert_same_part(w.context, object, fresh.context, loaded, i);
    dm_object_get_joint(w.context, object, TEST_DOOR, &joint_a);
    dm_object_get_joint(fresh.context, loaded, TEST_DOOR, &joint_b);
    assert_memory_equal(&joint_a, &joint_b, sizeof joint_a);
    dm_object_get_joint(w.context, object, TEST_HANDLE, &joint_a);
    dm_object_get_joint(fresh.context, loaded, TEST_HANDLE, &joint_b);
    assert_int_equal(joint_b.source, DM_JOINT_FROM_HOST);
    assert_memory_equal(&joint_a, &joint_b, sizeof joint_a);
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull()};
    dm_motion motion_a, motion_b;
    dm_pose poses_a[DM_MOTION_FRAMES], poses_b[DM_MOTION_FRAMES];
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion_a), DM_OK);
    assert_int_equal(dm_motion_generate(fresh.context, loaded, &desc, &motion_b), DM_OK);
    dm_motion_get_frames(w.context, motion_a, poses_a, NULL);
    dm_motion_get_frames(fresh.context, motion_b, poses_b, NULL);
    assert_memory_equal(poses_a, poses_b, sizeof poses_a);
    const dm_drag_hint pull = test_pull(); /* triangles are loaded, so refinement works */
    assert_int_equal(dm_object_refine(w.context, object, TEST_DOOR, &pull), DM_OK);
    assert_int_equal(dm_object_refine(fresh.context, loaded, TEST_DOOR, &pull), DM_OK);
    for (uint32_t i = 0; i < 2; i++) assert_same_part(w.context, object, fresh.context, loaded, i);
    free(file.data);
    test_world_close(&w);
    test_world_close(&fresh);
}

/* In axes and a unit that round. */
static void test_saving_again_gives_the_same_bytes(void** state) {
    (void)state;
    static const float turned[9] = {0.36f, 0.48f, -0.8f, -0.8f, 0.6f, 0, 0.48f, 0.64f, 0.6f};
    test_world w;
    test_world_init(&w);
    w.desc.axes = DM_AXES_CUSTOM;
    memcpy(w.desc.custom_axes, turned, sizeof turned);
    w.desc.unit_in_metres = 0.3048f;
    test_world_open(&w);
    for (uint32_t flags = 0; flags <= DM_PREPARE_WITHOUT_PICKING; flags++) {
        bytes first = save(w.context, make_object(&w, flags));
        dm_object loaded;
        assert_int_equal(dm_object_load(w.context, first.data, first.size, 0, &loaded), DM_OK);
        bytes second = save(w.context, loaded);
        assert_int_equal(first.size, second.size);
        assert_memory_equal(first.data, second.data, first.size);
        free(first.data);
        free(second.data);
    }
    test_world_close(&w);
}

static void test_without_triangles_it_is_small(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    const dm_drag_hint pull = test_pull();
    const dm_part_desc parts[2] = {
        {.struct_size = sizeof parts[0], .id = TEST_DOOR, .drag = &pull},
        {.struct_size = sizeof parts[0], .id = TEST_HANDLE, .parent = TEST_DOOR, .joint_type = DM_JOINT_FIXED}};
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .flags = DM_PREPARE_WITHOUT_PICKING,
                                 .mesh = &mesh,
                                 .parts = parts,
                                 .part_count = 2,
                                 .model = w.model};
    dm_object door;
    assert_int_equal(dm_object_prepare(w.context, &desc, &door), DM_OK);
    bytes file = save(w.context, door);
    assert_in_range(file.size, 1, BARE_SIZE);
    dm_object loaded;
    dm_object_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 0, &loaded), DM_OK);
    assert_int_equal(dm_object_get_info(w.context, loaded, &info), DM_OK);
    assert_int_equal(info.pickable, 0);
    size_t size = 0;
    assert_int_equal(dm_object_save(w.context, loaded, file.data, 10, &size), DM_ERROR_BUFFER_TOO_SMALL);
    assert_int_equal(size, file.size);
    free(file.data);
    test_world_close(&w);
}

static void test_loaded_objects_can_be_picked(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, 0));
    dm_object loaded;
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 0, &loaded), DM_OK);
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_scene scene;
    uint32_t instance;
    dm_hit hit = {.struct_size = sizeof hit};
    const dm_ray ray = {{0.5f, 0.25f, 5}, {0, 0, -1}};
    assert_int_equal(dm_scene_create(w.context, &desc, &scene), DM_OK);
    assert_int_equal(dm_scene_add(w.context, scene, loaded, NULL, &instance), DM_OK);
    assert_int_equal(dm_scene_commit(w.context, scene), DM_OK);
    assert_int_equal(dm_scene_pick(w.context, scene, &ray, &hit), DM_OK);
    assert_int_equal(hit.object, loaded);
    assert_int_equal(hit.part_id, TEST_DOOR);
    assert_true(fabsf(hit.point.z - 1.05f) < 1e-5f);
    free(file.data);
    test_world_close(&w);
}

/* Saved by a Y-up host in metres, loaded by a Z-up host in centimetres. */
static void test_a_file_serves_hosts_of_other_axes(void** state) {
    (void)state;
    test_world w, unreal;
    test_world_init(&w);
    test_world_open(&w);
    test_world_init(&unreal);
    unreal.desc.axes = DM_AXES_UNREAL;
    unreal.desc.unit_in_metres = 0.01f;
    test_world_open(&unreal);
    bytes file = save(w.context, make_object(&w, 0));
    dm_object loaded;
    dm_object_info info = {.struct_size = sizeof info};
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_load(unreal.context, file.data, file.size, 0, &loaded), DM_OK);
    assert_int_equal(dm_object_get_info(unreal.context, loaded, &info), DM_OK);
    assert_true(fabsf(info.size - 200) < 1e-3f && fabsf(info.box_max.z - 100) < 1e-3f);
    assert_int_equal(dm_object_get_joint(unreal.context, loaded, TEST_HANDLE, &joint), DM_OK);
    assert_true(fabsf(fabsf(joint.axis.z) - 1) < 1e-6f && fabsf(joint.origin.z - 50) < 1e-3f);
    free(file.data);
    test_world_close(&w);
    test_world_close(&unreal);
}

/* ---- invalid bytes ---- */

static void assert_bad(test_world* w, const bytes* file, size_t size, dm_result expected) {
    dm_object object = 0;
    w->messages.count = 0;
    /* A block of exactly this size lets sanitizers detect reads beyond the end. */
    uint8_t* exact = malloc(size > 0 ? size : 1);
    memcpy(exact, file->data, size);
    assert_int_equal(dm_object_load(w->context, exact, size, 0, &object), expected);
    free(exact);
    assert_int_equal(object, 0);
    assert_true(w->messages.count >= 1);
}

static void test_every_truncation_is_noticed(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, 0));
    for (size_t size = 0; size < file.size; size += size < 256 ? 1 : 61) assert_bad(&w, &file, size, DM_ERROR_BAD_DATA);
    free(file.data);
    test_world_close(&w);
}

static void test_every_flipped_bit_is_noticed(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, DM_PREPARE_WITHOUT_PICKING));
    for (size_t i = 0; i < file.size; i += i < 512 ? 1 : 37) {
        file.data[i] ^= (uint8_t)(1 << i % 8);
        int in_version = i >= 4 && i < 8;
        dm_object object = 0;
        dm_result result = dm_object_load(w.context, file.data, file.size, 0, &object);
        assert_true(result == DM_ERROR_BAD_DATA || (in_version && result == DM_ERROR_VERSION));
        file.data[i] ^= (uint8_t)(1 << i % 8);
    }
    free(file.data);
    test_world_close(&w);
}

/* Overwrites 32-bit words and corrects the checksum: loading fails, or gives a valid object. */
static void test_any_changed_word_is_rejected_or_valid(void** state) {
    (void)state;
    static const uint32_t edges[] = {0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x7f800000, 0x7fc00000, 0x7149f2ca};
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, 0));
    const int64_t held = test_world_bytes(&w);
    int loaded = 0;
    for (size_t at = 12; at + 4 <= file.size; at += at < 1600 ? 4 : 1012) {
        const uint32_t edge = edges[(at / 4) % (sizeof edges / sizeof *edges)];
        uint8_t kept[4];
        memcpy(kept, file.data + at, 4);
        put_u32(file.data + at, edge);
        sign_again(&file);
        dm_object object = 0;
        dm_joint joints[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *joints}};
        uint32_t count;
        dm_result result = dm_object_load(w.context, file.data, file.size, 0, &object);
        if (result == DM_OK) {
            loaded++;
            dm_object_get_hypotheses(w.context, object, TEST_DOOR, NULL, joints, DM_MAX_HYPOTHESES, &count);
            assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
        } else {
            assert_int_equal(result, DM_ERROR_BAD_DATA);
        }
        assert_int_equal(test_world_bytes(&w), held);
        memcpy(file.data + at, kept, 4);
    }
    assert_true(loaded > 0);
    free(file.data);
    test_world_close(&w);
}

static void test_newer_files(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, 0));
    put_u32(file.data + 4, DMI_DMO_VERSION + 1);
    assert_bad(&w, &file, file.size, DM_ERROR_VERSION);
    put_u32(file.data + 4, DMI_DMO_VERSION);
    /* A section with an unknown tag, here the renamed triangles, is skipped. */
    put_u32(file.data + DMI_DMO_HEADER_SIZE + DMI_DMO_TRIANGLES * DMI_DMO_ENTRY_SIZE, DMI_DMO_TAG('N', 'E', 'W', ' '));
    sign_again(&file);
    dm_object object;
    dm_object_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 0, &object), DM_OK);
    assert_int_equal(dm_object_get_info(w.context, object, &info), DM_OK);
    assert_int_equal(info.pickable, 0);
    put_u32(file.data + DMI_DMO_HEADER_SIZE + DMI_DMO_TRIANGLES * DMI_DMO_ENTRY_SIZE, dmi_dmo_tags[DMI_DMO_JOINTS]);
    sign_again(&file);
    assert_bad(&w, &file, file.size, DM_ERROR_BAD_DATA); /* the same section twice */
    free(file.data);
    test_world_close(&w);
}

/* Returns the offset of a section from the file's table. */
static size_t section_at(const bytes* file, int section) {
    const uint8_t* offset = file->data + DMI_DMO_HEADER_SIZE + (size_t)section * DMI_DMO_ENTRY_SIZE + 8;
    return (size_t)offset[0] | (size_t)offset[1] << 8 | (size_t)offset[2] << 16;
}

static void assert_bad_word(test_world* w, bytes* file, size_t at, uint32_t word) {
    uint8_t kept[4];
    memcpy(kept, file->data + at, 4);
    put_u32(file->data + at, word);
    sign_again(file);
    assert_bad(w, file, file->size, DM_ERROR_BAD_DATA);
    memcpy(file->data + at, kept, 4);
}

static void test_alternatives(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, DM_PREPARE_WITHOUT_PICKING));
    const size_t at = section_at(&file, DMI_DMO_ALTERNATIVES);
    assert_true(file.data[at] > 0 && file.data[at] <= DMI_ALTERNATIVES);
    assert_bad_word(&w, &file, at, DMI_ALTERNATIVES + 1);
    assert_bad_word(&w, &file, at, 0); /* leaves bytes over */
    assert_bad_word(&w, &file, at + 4, DM_JOINT_FIXED);
    assert_bad_word(&w, &file, at + 8, 0x40000000);  /* a confidence of 2 */
    assert_bad_word(&w, &file, at + 12, 0x7fc00000); /* NaN in the axis */
    assert_bad_word(&w, &file, at + 24, 0x7f800000); /* infinity in the origin */
    float axis[3];
    memcpy(axis, file.data + at + 12, sizeof axis);
    const size_t main_one = fabsf(axis[0]) > 0.5f ? 0 : fabsf(axis[1]) > 0.5f ? 1 : 2;
    const float longer = 1.0003f * axis[main_one];
    uint32_t word;
    memcpy(&word, &longer, sizeof word);
    assert_bad_word(&w, &file, at + 12 + 4 * main_one, word); /* an axis that is too long to be rounding */
    /* Older files lack the section, and the one of free ranges: rename both. */
    put_u32(file.data + DMI_DMO_HEADER_SIZE + DMI_DMO_ALTERNATIVES * DMI_DMO_ENTRY_SIZE,
            DMI_DMO_TAG('N', 'E', 'W', ' '));
    put_u32(file.data + DMI_DMO_HEADER_SIZE + DMI_DMO_FREE_RANGES * DMI_DMO_ENTRY_SIZE,
            DMI_DMO_TAG('N', 'E', 'W', '2'));
    sign_again(&file);
    dm_object object = 0;
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 0, &object), DM_OK);
    free(file.data);
    test_world_close(&w);
}

/* Finite in the file, infinite in the host's frame: the object is 2 m large. */
static void test_joints_beyond_the_hosts_numbers(void** state) {
    (void)state;
    enum { ORIGIN = 7 * 4, PITCH = 3 * 4, JOINT = 13 * 4 }; /* bytes in a joint */
    const uint32_t largest = 0x7f7fffff;                    /* FLT_MAX */
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, DM_PREPARE_WITHOUT_PICKING));
    const size_t joints = section_at(&file, DMI_DMO_JOINTS), host = section_at(&file, DMI_DMO_HOST_JOINTS);
    const size_t handle = joints + 8 + file.data[joints] * JOINT + 8; /* of the second part: its first hypothesis */
    const size_t own = handle + file.data[handle - 8] * JOINT;        /* the host's */
    assert_bad_word(&w, &file, joints + 8 + ORIGIN, largest);
    assert_bad_word(&w, &file, joints + 8 + PITCH, largest);
    assert_bad_word(&w, &file, joints + 8 + 4, 0x80000001); /* a confidence a little below 0 */
    assert_bad_word(&w, &file, joints + 8 + 8, 0x3f800001); /* and above 1 */
    assert_bad_word(&w, &file, own + ORIGIN, largest);
    assert_bad_word(&w, &file, section_at(&file, DMI_DMO_ALTERNATIVES) + 24, largest);
    assert_bad_word(&w, &file, host + (DMI_DMO_AXES + 1) * 4 + ORIGIN, 0x7f800000); /* infinity */
    free(file.data);
    test_world_close(&w);
}

/* ---- each number at its edges ---- */

enum { TINY = 1, MINUS_TINY = (int)0x80000001, ONE = 0x3f800000, MINUS_ONE = (int)0xbf800000, NONE = 0x7fc00000 };
enum { MOST_AREA = 0x5368d4a5, LARGEST = 0x7f7fffff, INFINITE = 0x7f800000, MINUS = (int)0x80000000 }; /* as floats */

/* A 32-bit word of a section, the last values of it that are right, and the first that are wrong. */
static const struct edge {
    int section;
    uint32_t at; /* bytes */
    int good[4], bad[6];
    int good_count, bad_count;
    const char* says;
} edges[] = {
    {DMI_DMO_OBJECT, 32, {MINUS_ONE}, {MINUS_ONE + 1, NONE, INFINITE}, 1, 3, "section OBJ"},
    {DMI_DMO_OBJECT, 52, {ONE}, {ONE + 1, NONE, INFINITE}, 1, 3, "section OBJ"},
    {DMI_DMO_OBJECT, 56, {DM_MAX_ELEMENTS, 0}, {DM_MAX_ELEMENTS + 1, -1}, 2, 2, "section OBJ"},
    {DMI_DMO_OBJECT, 60, {0}, {1}, 1, 1, "section OBJ"},
    {DMI_DMO_OBJECT, 64, {DM_MAX_ELEMENTS, 0}, {DM_MAX_ELEMENTS + 1, -1}, 2, 2, "section OBJ"},
    {DMI_DMO_OBJECT, 68, {0}, {1}, 1, 1, "section OBJ"},
    {DMI_DMO_OBJECT, 72, {0, -1}, {0}, 2, 0, ""}, /* any seed */
    {DMI_DMO_OBJECT, 80, {3}, {2, 4, 1, 0, -1, DM_MAX_PARTS + 2}, 1, 6, "the number of parts"},
    {DMI_DMO_PARTS, 0, {0}, {1, -1}, 1, 2, "do not form a tree"},
    {DMI_DMO_PARTS, 4, {0}, {1, 2, 3}, 1, 3, "do not form a tree"},
    {DMI_DMO_PARTS, 56, {1}, {0, 9}, 1, 2, "do not form a tree"},
    {DMI_DMO_PARTS, 60, {0}, {1, 3, -1}, 1, 3, "do not form a tree"},
    {DMI_DMO_PARTS, 112, {2, 9, -1}, {1, 0}, 3, 2, "do not form a tree"},
    {DMI_DMO_PARTS, 116, {0, 1}, {2, 3, -1}, 2, 3, "do not form a tree"},
    {DMI_DMO_PARTS, 12, {MINUS_ONE}, {MINUS_ONE + 1, ONE, NONE}, 1, 3, "section PART"},
    {DMI_DMO_PARTS, 32, {ONE}, {ONE + 1, MINUS_ONE, NONE}, 1, 3, "section PART"},
    {DMI_DMO_PARTS, 36, {MINUS_ONE, ONE}, {MINUS_ONE + 1, ONE + 1, NONE}, 2, 3, "section PART"},
    {DMI_DMO_PARTS, 44, {MINUS_ONE, ONE}, {MINUS_ONE + 1, ONE + 1, INFINITE}, 2, 3, "section PART"},
    {DMI_DMO_PARTS, 48, {0, MINUS, MOST_AREA}, {MINUS_TINY, MOST_AREA + 1, NONE, INFINITE}, 3, 4, "section PART"},
    {DMI_DMO_PARTS, 52, {DM_JOINT_UNKNOWN, DM_JOINT_FIXED}, {-1, DM_JOINT_FIXED + 1}, 2, 2, "section PART"},
    {DMI_DMO_PARTS, 164, {DM_JOINT_UNKNOWN, DM_JOINT_FIXED}, {-1, DM_JOINT_FIXED + 1}, 2, 2, "section PART"},
    {DMI_DMO_JOINTS, 0, {0}, {DM_MAX_HYPOTHESES + 1, -1}, 0, 2, "section JNT"},
    {DMI_DMO_JOINTS, 4, {0}, {-2, DM_MAX_HYPOTHESES + 1}, 1, 2, "section JNT"},
    {DMI_DMO_JOINTS, 8, {DM_JOINT_REVOLUTE, DM_JOINT_FIXED}, {0, DM_JOINT_FIXED + 1, -1}, 2, 3, "section JNT"},
    {DMI_DMO_JOINTS, 12, {0, MINUS, ONE}, {MINUS_TINY, ONE + 1, NONE}, 3, 3, "section JNT"},
    {DMI_DMO_JOINTS, 16, {0, MINUS, ONE}, {MINUS_TINY, ONE + 1, NONE}, 3, 3, "section JNT"},
    {DMI_DMO_JOINTS, 48, {MINUS | LARGEST}, {LARGEST, INFINITE, NONE}, 0, 3, "section JNT"},
    {DMI_DMO_JOINTS, 56, {DM_JOINT_FROM_NETWORK, DM_JOINT_CHOSEN}, {-1, DM_JOINT_CHOSEN + 1}, 2, 2, "section JNT"},
    {DMI_DMO_POINTS, 0, {0, -1}, {0}, 2, 0, ""}, /* any points */
    {DMI_DMO_POINTS, 2 * DMI_DMO_POINTS_SIZE - 4, {MINUS, ONE}, {0}, 2, 0, ""},
    {DMI_DMO_ALTERNATIVES, 0, {0}, {DMI_ALTERNATIVES + 1, -1}, 0, 2, "section ALT"},
    {DMI_DMO_ALTERNATIVES,
     4,
     {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_CONTINUOUS},
     {DM_JOINT_UNKNOWN, DM_JOINT_SCREW, DM_JOINT_FIXED, DM_JOINT_FIXED + 1},
     3,
     4,
     "section ALT"},
    {DMI_DMO_ALTERNATIVES, 8, {0, ONE}, {MINUS_TINY, ONE + 1, NONE}, 2, 3, "section ALT"},
    {DMI_DMO_FREE_RANGES, 0, {0, MINUS, MINUS | LARGEST}, {TINY, ONE, MINUS | INFINITE, NONE}, 3, 4, "section FRE"},
    {DMI_DMO_FREE_RANGES, 4, {0, MINUS, LARGEST}, {MINUS_TINY, MINUS_ONE, INFINITE, NONE}, 3, 4, "section FRE"},
    {DMI_DMO_HOST_JOINTS, 0, {0, NONE}, {0}, 2, 0, ""}, /* of other axes: then the file's joint is turned into ours */
    {DMI_DMO_HOST_JOINTS, 40, {DM_JOINT_REVOLUTE, DM_JOINT_FIXED}, {0, DM_JOINT_FIXED + 1}, 2, 2, "JNT or HST"},
    {DMI_DMO_HOST_JOINTS, 44, {0, ONE}, {MINUS_TINY, ONE + 1, NONE}, 2, 3, "JNT or HST"},
};

static void every_number_has_its_edges(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, DM_PREPARE_WITHOUT_PICKING));
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
        const struct edge* e = &edges[i];
        const size_t at = section_at(&file, e->section) + e->at;
        uint8_t kept[4];
        memcpy(kept, file.data + at, 4);
        for (int k = 0; k < e->good_count; k++) {
            dm_object object = 0;
            put_u32(file.data + at, (uint32_t)e->good[k]);
            sign_again(&file);
            if (dm_object_load(w.context, file.data, file.size, 0, &object) != DM_OK)
                fail_msg("edge %zu, %08x: %s", i, (unsigned)e->good[k], w.messages.text);
            assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
            memcpy(file.data + at, kept, 4);
        }
        for (int k = 0; k < e->bad_count; k++) {
            assert_bad_word(&w, &file, at, (uint32_t)e->bad[k]);
            if (!strstr(w.messages.text, e->says))
                fail_msg("edge %zu, %08x: %s", i, (unsigned)e->bad[k], w.messages.text);
        }
    }
    free(file.data);
    test_world_close(&w);
}

/* Parts that carry each other in a ring hang on no body. */
static void a_ring_of_parts_is_no_tree(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, DM_PREPARE_WITHOUT_PICKING));
    const size_t at = section_at(&file, DMI_DMO_PARTS);
    put_u32(file.data + at + 60, 2);
    dm_object object = 0;
    sign_again(&file);
    const uint32_t parent = file.data[at + 116];
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 0, &object),
                     parent == 1 ? DM_ERROR_BAD_DATA : DM_OK);
    assert_bad_word(&w, &file, at + 116, 1);
    assert_non_null(strstr(w.messages.text, "do not form a tree"));
    free(file.data);
    test_world_close(&w);
}

/* The head and the table: sizes to the byte, sections that lie in the file to its last byte and no further. */
static void the_table_ends_with_the_file(void** state) {
    (void)state;
    enum { SECTIONS = 12, SIZE = 16, VERSION = 4 };
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, 0));
    const uint32_t size = (uint32_t)file.size, count = file.data[SECTIONS];
    const size_t entry = DMI_DMO_HEADER_SIZE + DMI_DMO_TRIANGLES * DMI_DMO_ENTRY_SIZE;
    dm_object object;
    assert_int_equal(count, DMI_DMO_SECTIONS - 2); /* no old points, and no closed values: no part rests open */
    assert_bad_word(&w, &file, VERSION, 0);
    assert_bad_word(&w, &file, SIZE, size + 1);
    assert_bad_word(&w, &file, SIZE, size - 1);
    assert_bad_word(&w, &file, SIZE + 4, 1);
    assert_bad_word(&w, &file, SECTIONS, DMI_DMO_MAX_SECTIONS + 1);
    assert_bad_word(&w, &file, SECTIONS, 0);
    assert_non_null(strstr(w.messages.text, "a section is missing"));
    assert_bad_word(&w, &file, entry + 8, size + 1);
    assert_non_null(strstr(w.messages.text, "lies outside the file"));
    assert_bad_word(&w, &file, entry + 12, 1);
    assert_bad_word(&w, &file, entry + 20, 1);
    assert_non_null(strstr(w.messages.text, "lies outside the file"));
    for (int s = 0; s < (int)count; s++) { /* each section a word longer, and shorter */
        uint8_t* length = file.data + DMI_DMO_HEADER_SIZE + (size_t)s * DMI_DMO_ENTRY_SIZE + 16;
        uint32_t had;
        memcpy(&had, length, 4);
        const int fits = section_at(&file, s) + had + 4 <= file.size;
        if (s != DMI_DMO_OBJECT && fits) assert_bad_word(&w, &file, (size_t)(length - file.data), had + 4);
        if (s != DMI_DMO_OBJECT) assert_bad_word(&w, &file, (size_t)(length - file.data), had - 4);
    }
    /* A section of none that is known: at the end, without a byte. */
    put_u32(file.data + entry, DMI_DMO_TAG('N', 'E', 'W', ' '));
    put_u32(file.data + entry + 8, size);
    put_u32(file.data + entry + 16, 0);
    sign_again(&file);
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 0, &object), DM_OK);
    assert_bad_word(&w, &file, entry + 16, 1);
    for (int s = 0; s < DMI_DMO_ALTERNATIVES; s++) { /* what older files had already is there */
        assert_bad_word(&w, &file, DMI_DMO_HEADER_SIZE + (size_t)s * DMI_DMO_ENTRY_SIZE,
                        DMI_DMO_TAG('N', 'E', 'W', '2'));
        assert_non_null(strstr(w.messages.text, "a section is missing"));
    }
    free(file.data);
    test_world_close(&w);
}

/* Triangles: positions within the object, corners that are vertices, parts that there are, counts as the parts say. */
static void triangles_have_edges(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, 0));
    const size_t at = section_at(&file, DMI_DMO_TRIANGLES);
    uint32_t vertices, faces;
    memcpy(&vertices, file.data + at, 4);
    memcpy(&faces, file.data + at + 8, 4);
    const size_t positions = at + 16, corners = positions + 12 * (size_t)vertices, parts = corners + 12 * (size_t)faces;
    static const uint32_t wrong[] = {ONE + 1, (uint32_t)MINUS_ONE + 1, NONE, INFINITE};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_bad_word(&w, &file, positions, wrong[i]);
        assert_non_null(strstr(w.messages.text, "a vertex lies far outside"));
        assert_bad_word(&w, &file, corners - 4, wrong[i]);
    }
    for (size_t c = 0; c < 3 * (size_t)faces; c += 3 * (size_t)faces - 1) {
        assert_bad_word(&w, &file, corners + 4 * c, vertices);
        assert_non_null(strstr(w.messages.text, "an index names no vertex"));
    }
    assert_bad_word(&w, &file, parts, 3); /* the first triangle is of a part that is not, the second of the body */
    assert_non_null(strstr(w.messages.text, "a triangle of no part"));
    assert_bad_word(&w, &file, parts, 0x00010001);
    assert_non_null(strstr(w.messages.text, "another number of triangles"));
    for (int k = -1; k <= 1; k += 2) {
        assert_bad_word(&w, &file, at, vertices + (uint32_t)k);
        assert_bad_word(&w, &file, at + 8, faces + (uint32_t)k);
        assert_non_null(strstr(w.messages.text, "section TRI has the wrong size"));
    }
    assert_bad_word(&w, &file, at + 4, 1);
    assert_bad_word(&w, &file, at + 12, 1);
    free(file.data);
    test_world_close(&w);
}

static void test_load_arguments(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, 0));
    dm_object object = 0;
    assert_int_equal(dm_object_load(w.context, NULL, 5, 0, &object), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 0, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_object_load(w.context, file.data, file.size, 99, &object), DM_ERROR_STALE_HANDLE);
    assert_int_equal(dm_object_save(w.context, object, NULL, 0, &file.size), DM_ERROR_STALE_HANDLE);
    assert_int_equal(dm_object_save(w.context, object, NULL, 0, NULL), DM_ERROR_INVALID_ARGUMENT);
    free(file.data);
    test_world_close(&w);
}

/* ---- compatibility with earlier versions ---- */

/* Written by `test_dmo corpus` at version 0.1: the cabinet of test_shapes.h, prepared without weights, the hinge of
 * test_world.h on both parts. */
static void test_the_first_version_still_loads(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    size_t size = 0;
    void* data = test_read_file(CORPUS, &size);
    dm_object object;
    dm_object_info info = {.struct_size = sizeof info};
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_load(w.context, data, size, 0, &object), DM_OK);
    assert_int_equal(dm_object_get_info(w.context, object, &info), DM_OK);
    assert_int_equal(info.part_count, 2);
    assert_int_equal(info.triangle_count, 36);
    assert_int_equal(info.pickable, 1);
    assert_true(fabsf(info.size - 2) < 1e-6f);
    for (uint32_t id = TEST_DOOR; id <= TEST_HANDLE; id++) {
        assert_int_equal(dm_object_get_joint(w.context, object, id, &joint), DM_OK);
        assert_int_equal(joint.type, DM_JOINT_REVOLUTE);
        assert_int_equal(joint.source, DM_JOINT_FROM_HOST);
        assert_true(fabsf(joint.axis.y + 1) < 1e-6f && fabsf(joint.origin.z - 1.03f) < 1e-6f);
        assert_true(joint.lower == 0 && joint.upper == 1.5f);
    }
    free(data);
    test_world_close(&w);
}

/* A file of the first version has 512 points a part, of which those are kept that a prepared object would have. */
static void points_of_the_first_version_are_kept(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes old = {NULL, 0};
    old.data = test_read_file(CORPUS, &old.size);
    dm_object object = 0;
    assert_int_equal(dm_object_load(w.context, old.data, old.size, 0, &object), DM_OK);
    bytes file = save(w.context, object);
    assert_int_equal(file.data[4], DMI_DMO_VERSION);
    const uint8_t *from = old.data + section_at(&old, DMI_DMO_POINTS),
                  *to = file.data + section_at(&file, DMI_DMO_POINTS);
    for (size_t i = 0; i < (size_t)2 * DMI_PART_POINTS * 3; i++) {
        float coordinate;
        memcpy(&coordinate, from + (i / 3 * 8 * 3 + i % 3) * sizeof coordinate, sizeof coordinate);
        int16_t kept;
        memcpy(&kept, to + i * sizeof kept, sizeof kept);
        assert_true(fabsf((float)kept * DMI_PART_POINT_UNIT - coordinate) <= DMI_PART_POINT_UNIT);
    }
    free(file.data);
    free(old.data);
    test_world_close(&w);
}

static void numbers_of_old_points_have_their_edges(void** state) {
    (void)state;
    const size_t last = 2 * DMI_DMO_OLD_POINTS_SIZE - 4;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes old = {NULL, 0};
    old.data = test_read_file(CORPUS, &old.size);
    const size_t at = section_at(&old, DMI_DMO_POINTS);
    for (size_t i = 0; i <= last; i += last) {
        assert_bad_word(&w, &old, at + i, ONE + 1);
        assert_bad_word(&w, &old, at + i, (uint32_t)MINUS_ONE + 1);
        assert_bad_word(&w, &old, at + i, NONE);
        assert_non_null(strstr(w.messages.text, "section PNT"));
    }
    free(old.data);
    test_world_close(&w);
}

/* Neither form of the points, one of them under the other's name, or one that is cut short. */
static void points_of_a_forged_file_are_refused(void** state) {
    (void)state;
    const size_t tag = DMI_DMO_HEADER_SIZE + DMI_DMO_POINTS * DMI_DMO_ENTRY_SIZE, size = tag + 16;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    bytes file = save(w.context, make_object(&w, DM_PREPARE_WITHOUT_PICKING));
    assert_bad_word(&w, &file, tag, DMI_DMO_TAG('N', 'E', 'W', ' '));
    assert_non_null(strstr(w.messages.text, "a section is missing"));
    assert_bad_word(&w, &file, tag, dmi_dmo_tags[DMI_DMO_PLAIN_POINTS]);
    assert_non_null(strstr(w.messages.text, "the number of parts"));
    assert_bad_word(&w, &file, size, 2 * DMI_DMO_POINTS_SIZE - 2);
    assert_bad_word(&w, &file, size, 2 * DMI_DMO_POINTS_SIZE + 2);
    assert_bad_word(&w, &file, size, 0);
    free(file.data);
    test_world_close(&w);
}

/* A pull at the middle of a part, along its joint. */
static dm_drag_hint pull_at_the_middle(dm_context* context, dm_object object, const dm_joint* joint) {
    dm_part_info part = {.struct_size = sizeof part};
    assert_int_equal(dm_object_get_part(context, object, 0, &part), DM_OK);
    const dm_vec3 a = joint->axis,
                  middle = {0.5f * (part.box_min.x + part.box_max.x), 0.5f * (part.box_min.y + part.box_max.y),
                            0.5f * (part.box_min.z + part.box_max.z)};
    const dm_vec3 arm = {middle.x - joint->origin.x, middle.y - joint->origin.y, middle.z - joint->origin.z};
    return (dm_drag_hint){.point = middle,
                          .vector = {a.y * arm.z - a.z * arm.y, a.z * arm.x - a.x * arm.z, a.x * arm.y - a.y * arm.x}};
}

/* Calls that any thread or a frame may make on an object with a door. */
static void use_a_door(dm_context* context, dm_object object) {
    dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR};
    dm_drag_desc held = {.struct_size = sizeof held, .object = object, .part_id = TEST_DOOR};
    dm_drag_state now = {.struct_size = sizeof now};
    dm_joint joint = {.struct_size = sizeof joint};
    const dm_ray ray = {{0, 0, 5}, {0.1f, 0.1f, -1}};
    dm_motion motion;
    dm_drag drag;
    assert_int_equal(dm_object_get_joint(context, object, TEST_DOOR, &joint), DM_OK);
    desc.drag = pull_at_the_middle(context, object, &joint);
    held.grab_point = desc.drag.point;
    assert_int_equal(dm_motion_generate(context, object, &desc, &motion), DM_OK);
    assert_int_equal(dm_drag_begin(context, &held, &drag), DM_OK);
    for (int i = 0; i < 10; i++) assert_int_equal(dm_drag_update(context, drag, &ray, 0.02f, &now), DM_OK);
    assert_int_equal(dm_drag_end(context, drag, NULL), DM_OK);
    assert_int_equal(dm_motion_destroy(context, motion), DM_OK);
}

/* A pull opens the first part of each, which is a door. */
static void files_of_earlier_versions_play_their_motions(void** state) {
    (void)state;
    static const char* const files[] = {CORPUS, "tests/abi/corpus/cabinet_0.2.0.dmo"};
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR};
        size_t size = 0;
        void* data = test_read_file(files[i], &size);
        dm_object object = 0;
        dm_motion motion = 0;
        dm_joint joint = {.struct_size = sizeof joint};
        dm_pose poses[DM_MOTION_FRAMES];
        float values[DM_MOTION_FRAMES];
        assert_int_equal(dm_object_load(w.context, data, size, w.model, &object), DM_OK);
        assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
        desc.drag = pull_at_the_middle(w.context, object, &joint);
        assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_OK);
        assert_int_equal(dm_motion_get_frames(w.context, motion, poses, values), DM_OK);
        assert_true(fabsf(values[0]) < 0.05f);
        assert_true(values[DM_MOTION_FRAMES - 1] > 0.5f * joint.upper && values[DM_MOTION_FRAMES - 1] <= joint.upper);
        free(data);
    }
    test_world_close(&w);
}

/* The features are there when the object is, and no later call writes them: two threads may generate motions of it. */
static void nothing_is_encoded_later(void** state) {
    (void)state;
    static const char* const files[] = {NULL, CORPUS, "tests/abi/corpus/cabinet_0.2.0.dmo"};
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        size_t size = 0;
        void* data = files[i] != NULL ? test_read_file(files[i], &size) : NULL;
        dm_object object = 0;
        if (data == NULL)
            object = make_object(&w, 0);
        else
            assert_int_equal(dm_object_load(w.context, data, size, w.model, &object), DM_OK);
        free(data);
        const dmi_object_slot* slot = dmi_pool_get(w.context->objects, object);
        const size_t bytes = slot->object->part_count * sizeof *slot->features;
        assert_non_null(slot->features);
        void* before = malloc(bytes);
        memcpy(before, slot->features, bytes);
        use_a_door(w.context, object);
        assert_memory_equal(slot->features, before, bytes);
        free(before);
    }
    test_world_close(&w);
}

static int write_corpus(const char* path) {
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = make_object(&w, 0);
    const dm_joint hinge = test_hinge();
    dm_object_set_joint(w.context, object, TEST_DOOR, &hinge);
    bytes file = save(w.context, object);
    FILE* stream = fopen(path, "wb");
    int failed = stream == NULL || fwrite(file.data, 1, file.size, stream) != file.size;
    if (stream != NULL) fclose(stream);
    free(file.data);
    test_world_close(&w);
    return failed;
}

int main(int argc, char** argv) {
    if (argc == 3 && strcmp(argv[1], "corpus") == 0) return write_corpus(argv[2]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_crc_has_the_standard_check_value),
        cmocka_unit_test(test_loading_gives_the_saved_bits),
        cmocka_unit_test(test_saving_again_gives_the_same_bytes),
        cmocka_unit_test(test_without_triangles_it_is_small),
        cmocka_unit_test(test_loaded_objects_can_be_picked),
        cmocka_unit_test(test_a_file_serves_hosts_of_other_axes),
        cmocka_unit_test(test_every_truncation_is_noticed),
        cmocka_unit_test(test_every_flipped_bit_is_noticed),
        cmocka_unit_test(test_any_changed_word_is_rejected_or_valid),
        cmocka_unit_test(test_newer_files),
        cmocka_unit_test(test_alternatives),
        cmocka_unit_test(test_joints_beyond_the_hosts_numbers),
        cmocka_unit_test(every_number_has_its_edges),
        cmocka_unit_test(a_ring_of_parts_is_no_tree),
        cmocka_unit_test(the_table_ends_with_the_file),
        cmocka_unit_test(triangles_have_edges),
        cmocka_unit_test(test_load_arguments),
        cmocka_unit_test(test_the_first_version_still_loads),
        cmocka_unit_test(points_of_the_first_version_are_kept),
        cmocka_unit_test(numbers_of_old_points_have_their_edges),
        cmocka_unit_test(points_of_a_forged_file_are_refused),
        cmocka_unit_test(files_of_earlier_versions_play_their_motions),
        cmocka_unit_test(nothing_is_encoded_later),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
