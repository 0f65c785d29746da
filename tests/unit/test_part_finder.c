/* The part at a grabbed point: among given pieces, in one mesh of several sheets, on one sheet. */
#include "test_env.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "segmentation/part_finder.h"
#include "test_shapes.h"

static test_shape shape;
static uint8_t found[TEST_SHAPE_MAX];

static dm_result find(dmi_env* env, int with_ids, const float point[3], const float drag[3]) {
    dmi_axes axes;
    dmi_mesh* mesh = NULL;
    dm_mesh_desc desc = test_shape_desc(&shape);
    if (!with_ids) desc.part_ids = NULL;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    memset(found, 0xcd, sizeof found);
    dm_result result = dmi_mesh_create_pieces(env, &axes, &desc, NULL, &mesh);
    if (result != DM_OK) return result;
    dmi_part_query query = {.mesh = mesh, .drag = {drag[0], drag[1], drag[2]}};
    const double host[3] = {(double)point[0], (double)point[1], (double)point[2]};
    dmi_frame_point_in(&mesh->frame, host, query.point);
    result = dmi_part_find(env, &query, found);
    dmi_mesh_destroy(env, mesh);
    return result;
}

static void find_ok(int with_ids, const float point[3], const float drag[3]) {
    test_env t;
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(find(&t.env, with_ids, point, drag), DM_OK);
    test_env_close(&t);
}

/* Checks for each of the three parts whether all of its faces are found (1) or none (0). */
static void expect_parts(int part0, int part1, int part2) {
    const int expected[3] = {part0, part1, part2};
    for (uint32_t f = 0; f < shape.face_count; f++) assert_int_equal(found[f], expected[shape.part[f]]);
}

static const float on_door[3] = {0.3f, 0.3f, 1.05f}, on_handle[3] = {0.91f, 0.5f, 1.07f}, outward[3] = {0, 0, 1},
                   no_drag[3] = {0, 0, 0};

static void test_a_node_carries_the_small_pieces_attached_to_it(void** state) {
    (void)state;
    test_shape_cabinet(&shape);
    find_ok(1, on_door, outward);
    expect_parts(0, 1, 1);
    find_ok(1, on_door, no_drag);
    expect_parts(0, 1, 1);
}

static void test_a_node_does_not_carry_the_piece_it_is_attached_to(void** state) {
    (void)state;
    test_shape_cabinet(&shape);
    find_ok(1, on_handle, outward);
    expect_parts(0, 0, 1);
}

static void test_large_neighbours_are_not_carried(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){4, 1, 1}, 0);
    test_shape_box(&shape, (const float[]){4.01f, 0, 0}, (const float[]){5, 1, 1}, 1);
    test_shape_box(&shape, (const float[]){5.01f, 0, 0}, (const float[]){6, 1, 1}, 2);
    find_ok(1, (const float[]){4.5f, 0.5f, 1}, outward);
    expect_parts(0, 1, 0);
}

static void* DM_CALL allocate_dirty(void* user, size_t size, size_t alignment) {
    (void)user;
    void* memory = aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (memory != NULL) memset(memory, 0x55, size);
    return memory;
}

static void DM_CALL release_dirty(void* user, void* memory, size_t size) {
    (void)user, (void)size;
    free(memory);
}

/* Ids that no face has, 0 too, are pieces without a place: what memory held before must not give them one. */
static void test_ids_without_faces_are_no_pieces(void** state) {
    (void)state;
    dm_context* context;
    dm_context_desc host = dm_context_desc_default();
    host.allocator = (dm_allocator){NULL, allocate_dirty, release_dirty};
    test_shape_cabinet(&shape);
    uint8_t ids[TEST_SHAPE_MAX];
    for (uint32_t f = 0; f < shape.face_count; f++) ids[f] = (uint8_t)(2 * shape.part[f] + 1); /* 1, 3, 5 */
    dm_mesh_desc mesh = test_shape_desc(&shape);
    mesh.part_ids = ids, mesh.part_id_bytes = shape.face_count, mesh.part_id_format = DM_UINT8;
    mesh.part_id_scope = DM_PER_FACE;
    const dm_drag_hint drag = {{on_door[0], on_door[1], on_door[2]}, {0, 0, 1}};
    assert_int_equal(dm_context_create(&host, &context), DM_OK);
    assert_int_equal(dm_mesh_find_part(context, &mesh, &drag, found, shape.face_count), DM_OK);
    expect_parts(0, 1, 1);
    dm_context_destroy(context);
}

/* More shells in one corner of the door than samples of one bucket are compared. */
static void test_many_tiny_shells_in_one_cell_do_not_hide_the_part(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){2, 1, 1}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 1.01f}, (const float[]){1, 1, 1.05f}, 1);
    for (int i = 0; i < 320; i++) {
        const float x = 0.95f + 0.001f * (float)(i % 18), y = 0.95f + 0.001f * (float)(i / 18);
        test_shape_box(&shape, (const float[]){x, y, 1.0501f}, (const float[]){x + 0.0005f, y + 0.0005f, 1.0506f}, 2);
    }
    find_ok(0, on_door, outward);
    for (uint32_t f = 0; f < 24; f++) assert_int_equal(found[f], shape.part[f]);
}

static void test_sheets_of_one_mesh_are_separate_pieces(void** state) {
    (void)state;
    test_shape_cabinet(&shape);
    find_ok(0, on_door, outward);
    for (uint32_t f = 0; f < shape.face_count; f++) {
        if (shape.part[f] == 0) assert_int_equal(found[f], 0);
        if (shape.part[f] == 1) assert_int_equal(found[f], 1);
    }
}

/* Makes a slab of 3 x 3 cells whose middle cell is raised as a button (part 1), one closed sheet. */
static void make_button(void) {
    uint32_t grid[2][4][4], raised[2][2];
    shape.vertex_count = shape.face_count = 0;
    for (int z = 0; z < 2; z++)
        for (int y = 0; y < 4; y++)
            for (int x = 0; x < 4; x++) grid[z][y][x] = test_shape_vertex(&shape, (float)x, (float)y, (float)z);
    for (int y = 0; y < 2; y++)
        for (int x = 0; x < 2; x++) raised[y][x] = test_shape_vertex(&shape, 1 + (float)x, 1 + (float)y, 1.4f);
    for (int y = 0; y < 3; y++) {
        for (int x = 0; x < 3; x++) {
            uint32_t(*low)[4] = grid[0], (*high)[4] = grid[1];
            test_shape_face(&shape, low[y][x], low[y + 1][x + 1], low[y][x + 1], 0);
            test_shape_face(&shape, low[y][x], low[y + 1][x], low[y + 1][x + 1], 0);
            if (x == 1 && y == 1) continue;
            test_shape_face(&shape, high[y][x], high[y][x + 1], high[y + 1][x + 1], 0);
            test_shape_face(&shape, high[y][x], high[y + 1][x + 1], high[y + 1][x], 0);
        }
    }
    /* Walls: pairs of a lower and an upper vertex, once around, seen from outside. */
    static const int ring[12][2] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2},
                                    {3, 3}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}};
    for (int i = 0; i < 12; i++) {
        const int *a = ring[i], *b = ring[(i + 1) % 12];
        test_shape_face(&shape, grid[0][a[1]][a[0]], grid[0][b[1]][b[0]], grid[1][b[1]][b[0]], 0);
        test_shape_face(&shape, grid[0][a[1]][a[0]], grid[1][b[1]][b[0]], grid[1][a[1]][a[0]], 0);
    }
    static const int square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; i++) {
        const int *a = square[i], *b = square[(i + 1) % 4];
        const uint32_t low_a = grid[1][1 + a[1]][1 + a[0]], low_b = grid[1][1 + b[1]][1 + b[0]];
        test_shape_face(&shape, low_a, low_b, raised[b[1]][b[0]], 1);
        test_shape_face(&shape, low_a, raised[b[1]][b[0]], raised[a[1]][a[0]], 1);
    }
    test_shape_face(&shape, raised[0][0], raised[0][1], raised[1][1], 1);
    test_shape_face(&shape, raised[0][0], raised[1][1], raised[1][0], 1);
}

static void test_a_bulge_is_cut_where_the_surface_bends_inwards(void** state) {
    (void)state;
    make_button();
    find_ok(0, (const float[]){1.5f, 1.5f, 1.4f}, (const float[]){0, 0, -1});
    expect_parts(0, 1, 0);
}

/* Left-handed hosts wind every triangle the other way round. */
static void test_a_bulge_is_cut_in_a_mesh_wound_inside_out(void** state) {
    (void)state;
    make_button();
    for (uint32_t f = 0; f < shape.face_count; f++) {
        const uint32_t second = shape.corners[f][1];
        shape.corners[f][1] = shape.corners[f][2];
        shape.corners[f][2] = second;
    }
    find_ok(0, (const float[]){1.5f, 1.5f, 1.4f}, (const float[]){0, 0, -1});
    expect_parts(0, 1, 0);
}

/* A box has no concave edges, so its lid ends at the creases. */
static void test_convex_sheets_are_cut_at_creases(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 1, 1}, 0);
    find_ok(0, (const float[]){0.5f, 0.5f, 1}, outward);
    uint32_t count = 0;
    for (uint32_t f = 0; f < shape.face_count; f++) {
        count += found[f];
        for (int i = 0; i < 3 && found[f]; i++) assert_true(shape.xyz[shape.corners[f][i]][2] > 0.5f);
    }
    assert_int_equal(count, 2);
}

static void test_a_whole_mesh_is_no_part(void** state) {
    (void)state;
    test_env t;
    shape.vertex_count = shape.face_count = 0;
    for (int i = 0; i < 4; i++) test_shape_vertex(&shape, (float)(i % 2), (float)(i / 2), 0);
    test_shape_face(&shape, 0, 1, 3, 0);
    test_shape_face(&shape, 0, 3, 2, 0);
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(find(&t.env, 0, (const float[]){0.5f, 0.5f, 0}, outward), DM_ERROR_FULL_MASK);
    for (uint32_t f = 0; f < shape.face_count; f++) assert_int_equal(found[f], 0xcd); /* an error writes nothing */
    test_env_close(&t);
}

static void test_every_failing_allocation_is_reported(void** state) {
    (void)state;
    for (int with_ids = 0; with_ids < 2; with_ids++) {
        dm_result result = DM_ERROR_OUT_OF_MEMORY;
        for (int n = 0; result != DM_OK; n++) {
            test_env t;
            test_shape_cabinet(&shape);
            test_env_open(&t, n);
            result = find(&t.env, with_ids, on_door, outward);
            if (result != DM_OK) assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
            test_env_close(&t);
            assert_true(n < 200);
        }
    }
}

static void test_api_reports_invalid_arguments(void** state) {
    (void)state;
    dm_context* context;
    test_shape_cabinet(&shape);
    dm_mesh_desc mesh = test_shape_desc(&shape);
    dm_drag_hint drag = {{0.3f, 0.3f, 1.05f}, {0, 0, 1}};
    assert_int_equal(dm_context_create(NULL, &context), DM_OK);
    assert_int_equal(dm_mesh_find_part(context, &mesh, &drag, found, shape.face_count), DM_OK);
    expect_parts(0, 1, 1);
    assert_int_equal(dm_mesh_find_part(context, &mesh, NULL, found, shape.face_count), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_mesh_find_part(context, &mesh, &drag, NULL, shape.face_count), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_mesh_find_part(NULL, &mesh, &drag, found, shape.face_count), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_mesh_find_part(context, &mesh, &drag, found, shape.face_count - 1), DM_ERROR_BUFFER_TOO_SMALL);
    drag.point.x = 1000;
    assert_int_equal(dm_mesh_find_part(context, &mesh, &drag, found, shape.face_count), DM_ERROR_DRAG_OFF_PART);
    drag.point.x = (float)NAN;
    assert_int_equal(dm_mesh_find_part(context, &mesh, &drag, found, shape.face_count), DM_ERROR_NOT_FINITE);
    dm_context_destroy(context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_node_carries_the_small_pieces_attached_to_it),
        cmocka_unit_test(test_a_node_does_not_carry_the_piece_it_is_attached_to),
        cmocka_unit_test(test_large_neighbours_are_not_carried),
        cmocka_unit_test(test_ids_without_faces_are_no_pieces),
        cmocka_unit_test(test_sheets_of_one_mesh_are_separate_pieces),
        cmocka_unit_test(test_many_tiny_shells_in_one_cell_do_not_hide_the_part),
        cmocka_unit_test(test_a_bulge_is_cut_where_the_surface_bends_inwards),
        cmocka_unit_test(test_a_bulge_is_cut_in_a_mesh_wound_inside_out),
        cmocka_unit_test(test_convex_sheets_are_cut_at_creases),
        cmocka_unit_test(test_a_whole_mesh_is_no_part),
        cmocka_unit_test(test_every_failing_allocation_is_reported),
        cmocka_unit_test(test_api_reports_invalid_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
