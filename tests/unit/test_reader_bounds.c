/* Memory that readers take for a byte of input: of a .dmo and of weights, at the most, while they are read. That of
 * glTF is in test_gltf.c. */
#include "test_world.h"

/* Bytes a byte, and always; docs/reliability.md promises them. */
enum { DMO_A_BYTE = 16, WEIGHTS_A_BYTE = 4, ALWAYS = 64 * 1024 };

enum { SIDE = 200 }; /* quads a side of the large mesh */

static uint64_t peak_above(const dm_context* context, uint64_t held) {
    dm_memory_info now = dm_memory_info_default();
    assert_int_equal(dm_context_get_memory(context, &now), DM_OK);
    return now.peak_bytes - held;
}

static uint64_t held_by(const dm_context* context) {
    dm_memory_info now = dm_memory_info_default();
    assert_int_equal(dm_context_get_memory(context, &now), DM_OK);
    return now.bytes;
}

/* Saves the object, and loads it into a context that has held nothing else. */
static void check_object(test_world* w, dm_object object) {
    size_t size;
    assert_int_equal(dm_object_save(w->context, object, NULL, 0, &size), DM_OK);
    void* saved = malloc(size);
    assert_int_equal(dm_object_save(w->context, object, saved, size, &size), DM_OK);
    for (int32_t picking = DM_PICK_PORTABLE; picking <= DM_PICK_NONE; picking++) {
        const dm_context_desc desc = {.struct_size = sizeof desc, .picking = picking};
        dm_context* fresh;
        dm_object loaded;
        assert_int_equal(dm_context_create(&desc, &fresh), DM_OK);
        const uint64_t held = held_by(fresh);
        assert_int_equal(dm_object_load(fresh, saved, size, 0, &loaded), DM_OK);
        const uint64_t peak = peak_above(fresh, held);
        print_message("a .dmo of %zu bytes: %.2f bytes a byte\n", size, (double)peak / (double)size);
        assert_true(peak <= ALWAYS + DMO_A_BYTE * (uint64_t)size);
        dm_context_destroy(fresh);
    }
    free(saved);
}

static void of_a_small_object(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    check_object(&w, test_world_cabinet(&w));
    test_world_close(&w);
}

static void of_a_large_object(void** state) {
    (void)state;
    static float xyz[(SIDE + 1) * (SIDE + 1)][3];
    static uint32_t corners[2 * SIDE * SIDE][3];
    static uint8_t part[2 * SIDE * SIDE];
    for (uint32_t v = 0; v < (SIDE + 1) * (SIDE + 1); v++) {
        xyz[v][0] = (float)(v % (SIDE + 1)) / SIDE;
        xyz[v][1] = (float)(v / (SIDE + 1)) / SIDE;
        xyz[v][2] = 0.001f * (float)(v * 7 % 11);
    }
    for (uint32_t q = 0; q < SIDE * SIDE; q++) {
        const uint32_t a = q / SIDE * (SIDE + 1) + q % SIDE, b = a + SIDE + 1;
        memcpy(corners[2 * q], (uint32_t[]){a, a + 1, b + 1}, sizeof corners[0]);
        memcpy(corners[2 * q + 1], (uint32_t[]){a, b + 1, b}, sizeof corners[0]);
        part[2 * q] = part[2 * q + 1] = q >= SIDE * SIDE / 2;
    }
    const dm_mesh_desc mesh = {.struct_size = sizeof mesh,
                               .positions = xyz,
                               .vertex_count = sizeof xyz / sizeof *xyz,
                               .indices = corners,
                               .index_count = sizeof corners / sizeof **corners,
                               .part_ids = part,
                               .part_id_bytes = sizeof part,
                               .part_id_format = DM_UINT8,
                               .part_id_scope = DM_PER_FACE};
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh};
    test_world w;
    dm_object object;
    test_world_init(&w);
    test_world_open(&w);
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    check_object(&w, object);
    test_world_close(&w);
}

static void of_weights(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_model_desc desc = dm_model_desc_default();
    void* kinematics = test_read_file("sdk/models/kpp_net.safetensors", &desc.kinematics_size);
    void* motion = test_read_file("sdk/models/dq_vae.safetensors", &desc.motion_size);
    void* ranker = test_read_file("sdk/models/ranker.safetensors", &desc.ranker_size);
    desc.kinematics = kinematics, desc.motion = motion, desc.ranker = ranker;
    const uint64_t held = held_by(w.context), size = desc.kinematics_size + desc.motion_size + desc.ranker_size;
    assert_int_equal(dm_model_load(w.context, &desc, &w.model), DM_OK);
    const uint64_t peak = peak_above(w.context, held);
    print_message("weights of %u bytes: %.2f bytes a byte\n", (unsigned)size, (double)peak / (double)size);
    assert_true(peak <= ALWAYS + WEIGHTS_A_BYTE * size);
    free(kinematics);
    free(motion);
    free(ranker);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_a_small_object),
        cmocka_unit_test(of_a_large_object),
        cmocka_unit_test(of_weights),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
