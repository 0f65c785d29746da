/* What a triangle takes for as long as its object can be picked, by each backend: the sums of docs/memory.md. */
#include "test_world.h"

enum { GRID = 60, VERTICES = 2 * (GRID + 1) * (GRID + 1), FACES = 2 * 2 * GRID * GRID };

static float xyz[VERTICES][3];
static uint32_t corners[FACES][3];
static uint8_t part_ids[FACES];

/* A body and a door in front of it, each a fine grid. interleaved: faces of both take turns. */
static dm_mesh_desc make_grids(bool interleaved) {
    uint32_t vertex = 0;
    for (uint32_t g = 0; g < 2; g++)
        for (uint32_t y = 0; y <= GRID; y++)
            for (uint32_t x = 0; x <= GRID; x++, vertex++)
                memcpy(xyz[vertex], (float[]){(float)x / GRID, (float)y / GRID, (float)g + 0.01f * (float)(x % 3)},
                       sizeof xyz[0]);
    for (uint32_t f = 0; f < FACES; f++) {
        const uint32_t part = interleaved ? f % 2 : f / (FACES / 2), own = interleaved ? f / 2 : f % (FACES / 2);
        const uint32_t quad = own / 2, at = part * VERTICES / 2 + quad / GRID * (GRID + 1) + quad % GRID;
        const uint32_t lower[3] = {at, at + 1, at + GRID + 2}, upper[3] = {at, at + GRID + 2, at + GRID + 1};
        memcpy(corners[f], own % 2 ? upper : lower, sizeof corners[f]);
        part_ids[f] = (uint8_t)part;
    }
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = xyz,
                          .vertex_count = VERTICES,
                          .indices = corners,
                          .index_count = 3 * (uint64_t)FACES,
                          .part_ids = part_ids,
                          .part_id_bytes = sizeof part_ids,
                          .part_id_format = DM_UINT8,
                          .part_id_scope = DM_PER_FACE};
}

static double held(test_world* w) {
    dm_memory_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_context_trim(w->context), DM_OK);
    assert_int_equal(dm_context_get_memory(w->context, &info), DM_OK);
    assert_int_equal(info.kept_bytes, 0);
    return (double)(info.bytes + info.pick_bytes);
}

/* Returns the bytes a triangle that an object takes more because it can be picked. */
static double bytes_a_triangle(int32_t picking, bool interleaved) {
    test_world w;
    dm_object bare, pickable;
    test_world_init(&w);
    w.desc.picking = picking;
    test_world_open(&w);
    const dm_mesh_desc mesh = make_grids(interleaved);
    dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .flags = DM_PREPARE_WITHOUT_PICKING};
    assert_int_equal(dm_object_prepare(w.context, &desc, &bare), DM_OK); /* makes room for handles */
    const double before = held(&w);
    assert_int_equal(dm_object_prepare(w.context, &desc, &bare), DM_OK);
    const double with_bare = held(&w);
    desc.flags = 0;
    assert_int_equal(dm_object_prepare(w.context, &desc, &pickable), DM_OK);
    const double bytes = (held(&w) - with_bare) - (with_bare - before);
    test_world_close(&w);
    print_message("picking %d%s: %.1f bytes a triangle\n", picking, interleaved ? ", interleaved" : "", bytes / FACES);
    return bytes / FACES;
}

static void the_librarys_own_trees_take_little(void** state) {
    (void)state;
    const double sorted = bytes_a_triangle(DM_PICK_PORTABLE, false), mixed = bytes_a_triangle(DM_PICK_PORTABLE, true);
    assert_in_range((int)sorted, 60, 75);
    assert_in_range((int)(mixed - sorted + 0.5), 4, 4); /* of which face of the mesh each is */
}

static void embrees_trees_take_little_more(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    w.desc.picking = DM_PICK_EMBREE;
    if (dm_context_create(&w.desc, &w.context) != DM_OK) skip();
    test_world_close(&w);
    assert_in_range((int)bytes_a_triangle(DM_PICK_EMBREE, false), 60, 95);
}

static void without_trees_there_are_the_triangles_alone(void** state) {
    (void)state;
    const double vertices = 12.0 * VERTICES / FACES, bytes = bytes_a_triangle(DM_PICK_NONE, false);
    assert_true(bytes >= vertices + 6 && bytes < vertices + 7);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_librarys_own_trees_take_little),
        cmocka_unit_test(embrees_trees_take_little_more),
        cmocka_unit_test(without_trees_there_are_the_triangles_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
