/* glTF in and out when malloc fails: JSON is read by cJSON and Draco's meshes by C++, whose memory is not the host's
 * allocator. Each call of malloc fails once. The answer is OUT_OF_MEMORY, nothing is lost, and nothing aborts. */
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_malloc.h"
#include "test_prop.h"

/* ---- the calls ---- */

static const test_prop* beside_of; /* the prop whose file is asked for */

static int32_t DM_CALL open_beside(void* user, const char* path, const void** out_data, size_t* out_size) {
    (void)user;
    (void)path;
    *out_data = beside_of->beside;
    *out_size = beside_of->beside_size;
    return DM_OK;
}

static void DM_CALL close_beside(void* user, const void* data, size_t size) {
    (void)user;
    (void)data;
    (void)size;
}

static dm_result open_prop(const test_prop* prop, dm_gltf** out_gltf) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = prop->data,
                               .size = prop->size,
                               .files = {.open = open_beside, .close = close_beside}};
    beside_of = prop;
    return dm_gltf_open(&desc, out_gltf);
}

static dm_result export_door(const dm_gltf* gltf) {
    static uint8_t ids[1024];
    static const char* const door = "door";
    const dm_pose poses[2] = {{.real = {0, 0, 0, 1}}, {.real = {0, 0.6f, 0, 0.8f}}};
    const float times[2] = {0, 1};
    dm_mesh_desc mesh;
    void* data = NULL;
    size_t size = 0;
    dm_gltf_get_mesh(gltf, &mesh);
    memset(ids, 0, sizeof ids);
    dm_result result = dm_gltf_mark_faces(gltf, &door, 1, 1, ids, mesh.index_count / 3);
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = poses, .times = times, .key_count = 2};
    if (result == DM_OK) result = dm_gltf_export(gltf, &track, 1, &data, &size);
    if (result == DM_OK) dm_gltf_release_bytes(gltf, data, size);
    return result;
}

/* Checks the answer of a call during which one malloc has failed, or none had to. */
static void check(const char* call, int way, dm_result result, int64_t left) {
    const dm_result expected = test_malloc.has_failed ? DM_ERROR_OUT_OF_MEMORY : DM_OK;
    if (result != expected || left != 0)
        fail_msg("%s, way %d, malloc %d: %s, not %s; %d blocks are left", call, way, (int)test_malloc.fail_at,
                 dm_result_string(result), dm_result_string(expected), (int)left);
}

static void open_fails_well(void** state) {
    (void)state;
    if (!TEST_MALLOC) skip();
    for (int way = 0; way < TEST_PROP_WAYS; way++) {
        test_prop prop;
        if (!test_prop_make(&prop, (test_prop_way)way)) continue;
        int64_t n = 0;
        do {
            dm_gltf* gltf = NULL;
            test_malloc_watch(n++);
            const dm_result result = open_prop(&prop, &gltf);
            if (result == DM_OK) dm_gltf_close(gltf);
            check("open", way, result, test_malloc_unwatch());
        } while (test_malloc.has_failed);
        assert_true(n > 50); /* or the failures were not seen */
        test_prop_free(&prop);
    }
}

/* What an export keeps with the file goes with it: opened, exported and closed, nothing is left. */
static void export_fails_well(void** state) {
    (void)state;
    if (!TEST_MALLOC) skip();
    for (int way = 0; way < TEST_PROP_WAYS; way++) {
        test_prop prop;
        if (!test_prop_make(&prop, (test_prop_way)way)) continue;
        test_malloc_watch(-1);
        dm_gltf* gltf = NULL;
        assert_int_equal(open_prop(&prop, &gltf), DM_OK);
        const int64_t opened = test_malloc.calls;
        assert_int_equal(export_door(gltf), DM_OK);
        const int64_t all = test_malloc.calls;
        assert_true(all - opened > 50);
        dm_gltf_close(gltf);
        assert_int_equal(test_malloc_unwatch(), 0);
        for (int64_t n = opened; n < all; n++) {
            test_malloc_watch(n);
            assert_int_equal(open_prop(&prop, &gltf), DM_OK);
            const dm_result result = export_door(gltf);
            dm_gltf_close(gltf);
            check("open and export", way, result, test_malloc_unwatch());
        }
        test_prop_free(&prop);
    }
}

static void write_fails_well(void** state) {
    (void)state;
    if (!TEST_MALLOC) skip();
    const float positions[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const uint32_t indices[6] = {0, 1, 2, 2, 1, 3};
    const dm_gltf_part parts[2] = {{"body", positions[0], indices, 4, 6, {1, 1, 1, 1}},
                                   {"door", positions[0], indices, 4, 3, {0, 1, 0, 1}}};
    int64_t n = 0;
    do {
        void* data = NULL;
        size_t size = 0;
        test_malloc_watch(n++);
        const dm_result result = dm_gltf_write(parts, 2, NULL, NULL, &data, &size);
        free(data);
        check("write", 0, result, test_malloc_unwatch());
    } while (test_malloc.has_failed);
    assert_true(n > 50);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(open_fails_well), cmocka_unit_test(export_fails_well),
                                       cmocka_unit_test(write_fails_well)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
