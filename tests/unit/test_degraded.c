/* What answers lack is said: as bits of the object, and in one warning of the call that makes it; through a .dmo too.
 */
#include "test_world.h"

enum { KINEMATICS = 1, RANKER = 2, MOTION = 4, ALL = KINEMATICS | RANKER | MOTION };

typedef struct weights {
    char* data[3];
    size_t size[3];
} weights;

static const char* const files[3] = {"kpp_net.safetensors", "ranker.safetensors", "dq_vae.safetensors"};
static const uint32_t bits[3] = {DM_DEGRADED_NO_KINEMATICS, DM_DEGRADED_NO_RANKER, DM_DEGRADED_NO_MOTION};

static dm_model load(const test_world* w, const weights* all, int given) {
    dm_model_desc desc = dm_model_desc_default();
    dm_model model = 0;
    if (given & KINEMATICS) desc.kinematics = all->data[0], desc.kinematics_size = all->size[0];
    if (given & RANKER) desc.ranker = all->data[1], desc.ranker_size = all->size[1];
    if (given & MOTION) desc.motion = all->data[2], desc.motion_size = all->size[2];
    if (given != 0) assert_int_equal(dm_model_load(w->context, &desc, &model), DM_OK);
    return model;
}

static uint32_t degraded(const test_world* w, dm_object object) {
    dm_object_info info = dm_object_info_default();
    assert_int_equal(dm_object_get_info(w->context, object, &info), DM_OK);
    return info.degraded;
}

/* Whether one warning came that names just the files of these bits, or none for no bits. */
static void assert_said(const test_world* w, uint32_t expected) {
    if (w->messages.count != (expected != 0)) fail_msg("%d messages for %u", w->messages.count, expected);
    for (int i = 0; i < 3 && expected != 0; i++)
        if ((strstr(w->messages.text, files[i]) != NULL) != ((expected & bits[i]) != 0))
            fail_msg("bits %u: %s", expected, w->messages.text);
}

/* Saves the object and loads it with a model, 0: none. Returns the bits of the copy. */
static uint32_t save_and_load(test_world* w, dm_object object, dm_model model, size_t* out_size) {
    static uint8_t bytes[1 << 18];
    dm_object copy = 0;
    assert_int_equal(dm_object_save(w->context, object, bytes, sizeof bytes, out_size), DM_OK);
    w->messages.count = 0;
    assert_int_equal(dm_object_load(w->context, bytes, *out_size, model, &copy), DM_OK);
    const uint32_t found = degraded(w, copy);
    assert_int_equal(dm_object_destroy(w->context, copy), DM_OK);
    return found;
}

static void each_missing_file_is_said_once(void** state) {
    (void)state;
    weights all;
    test_world w;
    test_world_init(&w);
    w.desc.picking = DM_PICK_PORTABLE; /* picking plays no part here */
    test_world_open(&w);
    for (int i = 0; i < 3; i++) {
        char path[64];
        snprintf(path, sizeof path, "sdk/models/%s", files[i]);
        all.data[i] = test_read_file(path, &all.size[i]);
    }
    const dm_model full = load(&w, &all, ALL);
    size_t whole = 0;
    for (int given = ALL; given >= 0; given--) {
        uint32_t expected = 0;
        dm_object object = 0;
        size_t size = 0;
        for (int i = 0; i < 3; i++) expected |= given >> i & 1 ? 0 : bits[i];
        w.model = load(&w, &all, given);
        w.messages.count = 0;
        assert_int_equal(test_world_prepare(&w, 0, &object), DM_OK);
        assert_said(&w, expected);
        assert_int_equal(degraded(&w, object), expected);
        /* With all weights, what was missing at the preparation is still said. */
        const uint32_t kept = expected & ~(uint32_t)DM_DEGRADED_NO_MOTION;
        assert_int_equal(save_and_load(&w, object, full, &size), kept);
        assert_said(&w, kept);
        /* Without a model no motions are asked for. */
        assert_int_equal(save_and_load(&w, object, 0, &size), kept | DM_DEGRADED_NO_MOTION);
        assert_said(&w, kept);
        if (given == ALL) whole = size;
        if (given == (KINEMATICS | RANKER)) assert_int_equal(size, whole); /* nothing more is written */
        assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    }
    for (int i = 0; i < 3; i++) free(all.data[i]);
    w.messages.count = 0;
    test_world_close(&w);
}

static void other_reasons_are_said(void** state) {
    (void)state;
    test_world w;
    dm_object object = 0;
    test_world_init(&w);
    w.desc.picking = DM_PICK_PORTABLE; /* picking plays no part here */
    test_world_open(&w);
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    const dm_pivot far = {.origin = {1e6f, 0, 0}};
    const dm_part_desc parts[2] = {{.struct_size = sizeof *parts, .id = TEST_DOOR, .pivot = &far},
                                   {.struct_size = sizeof *parts, .id = TEST_HANDLE, .parent = TEST_DOOR}};
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .flags = DM_PREPARE_MESH_INCOMPLETE,
                                 .mesh = &mesh,
                                 .parts = parts,
                                 .part_count = 2};
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    const uint32_t expected =
        DM_DEGRADED_NO_KINEMATICS | DM_DEGRADED_NO_RANKER | DM_DEGRADED_NO_MOTION | DM_DEGRADED_HINT | DM_DEGRADED_MESH;
    size_t size;
    assert_int_equal(degraded(&w, object), expected);
    assert_int_equal(w.messages.count, 1);
    assert_non_null(strstr(w.messages.text, "a pivot far away"));
    assert_non_null(strstr(w.messages.text, "the mesh is not all of its file"));
    assert_int_equal(save_and_load(&w, object, 0, &size), expected);
    w.messages.count = 0;
    test_world_close(&w);
}

/* Of parts that are fixed, no weights are missed. */
static void nothing_is_missed_where_nothing_moves(void** state) {
    (void)state;
    test_world w;
    dm_object object = 0;
    test_world_init(&w);
    w.desc.picking = DM_PICK_PORTABLE; /* picking plays no part here */
    test_world_open(&w);
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    const dm_part_desc parts[2] = {
        {.struct_size = sizeof *parts, .id = TEST_DOOR, .joint_type = DM_JOINT_FIXED},
        {.struct_size = sizeof *parts, .id = TEST_HANDLE, .parent = TEST_DOOR, .joint_type = DM_JOINT_FIXED}};
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .parts = parts, .part_count = 2};
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    assert_int_equal(degraded(&w, object), 0);
    assert_int_equal(w.messages.count, 0);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_missing_file_is_said_once),
        cmocka_unit_test(other_reasons_are_said),
        cmocka_unit_test(nothing_is_missed_where_nothing_moves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
