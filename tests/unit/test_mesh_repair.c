/* Masks with patches lost and leaked are put back; masks that follow the surface stay as they are. */
#include "test_env.h"

#include "base/random.h"
#include "mesh/connectivity.h"
#include "mesh/mesh_repair.h"
#include "test_shapes.h"

#define CELLS 12 /* a side of a slab's grid */

static test_shape shape;

typedef struct stage {
    test_env t;
    dmi_arena arena;
    dmi_mesh* mesh;
    dmi_mesh repaired;
} stage;

static dm_result run(stage* s, int64_t fail_at) {
    test_env_open(&s->t, TEST_NEVER);
    dmi_axes axes;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    const dm_mesh_desc desc = test_shape_desc(&shape);
    assert_int_equal(dmi_mesh_create(&s->t.env, &axes, &desc, NULL, 0, NULL, &s->mesh), DM_OK);
    dmi_arena_init(&s->arena, &s->t.env, 4096);
    uint32_t* welded = dmi_arena_push(&s->arena, s->mesh->vertex_count * sizeof *welded);
    assert_non_null(welded);
    assert_int_equal(dmi_weld_vertices(&s->arena, s->mesh, 1e-5f, NULL, welded), DM_OK);
    if (fail_at != TEST_NEVER) s->t.memory.fail_at = (int64_t)s->t.memory.calls + fail_at;
    return dmi_mesh_repair(&s->arena, s->mesh, welded, NULL, &s->repaired);
}

static void end(stage* s) {
    s->t.memory.fail_at = TEST_NEVER;
    dmi_arena_release(&s->arena);
    dmi_mesh_destroy(&s->t.env, s->mesh);
    test_env_close(&s->t);
}

/* A sheet of cells at height z, in shared vertices. */
static void add_sheet(float x, float z, uint32_t part) {
    const uint32_t first = shape.vertex_count;
    for (int i = 0; i <= CELLS; i++)
        for (int k = 0; k <= CELLS; k++) test_shape_vertex(&shape, x + (float)i / CELLS, (float)k / CELLS, z);
    for (uint32_t i = 0; i < CELLS; i++)
        for (uint32_t k = 0; k < CELLS; k++) {
            const uint32_t a = first + i * (CELLS + 1) + k, b = a + CELLS + 1;
            test_shape_face(&shape, a, b, b + 1, part);
            test_shape_face(&shape, a, b + 1, a + 1, part);
        }
}

/* A body and a door beside it. */
static void body_and_door(void) {
    shape.vertex_count = shape.face_count = 0;
    add_sheet(0, 0, 0);
    add_sheet(1.05f, 0, 1);
}

/* Moves the faces of a square patch to a part. */
static void paint(float x, float y, float side, uint32_t part) {
    for (uint32_t f = 0; f < shape.face_count; f++) {
        const float* p = shape.xyz[shape.corners[f][0]];
        if (p[0] >= x && p[0] < x + side && p[1] >= y && p[1] < y + side) shape.part[f] = part;
    }
}

static void assert_parts_are(const stage* s, uint32_t (*part_of)(uint32_t face)) {
    for (uint32_t f = 0; f < s->mesh->face_count; f++) assert_int_equal(s->repaired.face_part[f], part_of(f));
}

static uint32_t by_sheet(uint32_t face) {
    return face >= 2 * CELLS * CELLS;
}

static uint32_t as_painted(uint32_t face) {
    return shape.part[face];
}

static void patches_come_back(void** state) {
    (void)state;
    body_and_door();
    paint(1.5f, 0.2f, 0.3f, 0); /* lost */
    paint(0.8f, 0.5f, 0.3f, 1); /* leaked */
    stage s;
    assert_int_equal(run(&s, TEST_NEVER), DM_OK);
    assert_parts_are(&s, by_sheet);
    /* The parts' boxes follow; the mesh's own labels do not change. */
    assert_true(s.repaired.parts[1].box_min[0] > s.mesh->parts[1].box_min[0]);
    assert_float_equal(s.repaired.parts[0].area, s.repaired.parts[1].area, 1e-5);
    for (uint32_t f = 0; f < s.mesh->face_count; f++) assert_int_equal(s.mesh->face_part[f], shape.part[f]);
    end(&s);
}

/* Two triangles of a coarse wall, leaked to a fine knob, have most of its area and few of its triangles. */
static void coarse_leaks_come_back(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    add_sheet(1.05f, 0, 1);
    const uint32_t knob = shape.face_count;
    test_shape_box(&shape, (const float[]){-5, -5, -5}, (const float[]){5, 5, -1}, 0);
    test_shape_box(&shape, (const float[]){-5, -5, -9}, (const float[]){5, 5, -6}, 0);
    shape.part[knob] = shape.part[knob + 3] = 1;
    stage s;
    assert_int_equal(run(&s, TEST_NEVER), DM_OK);
    for (uint32_t f = 0; f < s.mesh->face_count; f++) assert_int_equal(s.repaired.face_part[f], f < knob);
    end(&s);
}

static void part_of_one_piece_stays(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    add_sheet(0, 0, 0);
    paint(0.4f, 0.4f, 0.3f, 1); /* a button: all that the part has */
    stage s;
    assert_int_equal(run(&s, TEST_NEVER), DM_OK);
    assert_parts_are(&s, as_painted);
    end(&s);
}

static void lid_of_one_box_stays(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 1, 1}, 0);
    for (uint32_t f = 6; f < 8; f++) shape.part[f] = 1; /* the side at +y */
    stage s;
    assert_int_equal(run(&s, TEST_NEVER), DM_OK);
    assert_parts_are(&s, as_painted);
    end(&s);
}

static void wide_mixture_stays(void** state) {
    (void)state;
    body_and_door();
    paint(1.0f, 0, 0.55f, 0);
    paint(1.0f, 0.5f, 0.55f, 0); /* half of the door: no error of a few patches */
    stage s;
    assert_int_equal(run(&s, TEST_NEVER), DM_OK);
    assert_parts_are(&s, as_painted);
    end(&s);
}

static void memory_may_fail(void** state) {
    (void)state;
    body_and_door();
    paint(1.5f, 0.2f, 0.3f, 0);
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    for (int64_t n = 0; result != DM_OK; n++) {
        stage s;
        result = run(&s, n);
        assert_true(result == DM_OK || result == DM_ERROR_OUT_OF_MEMORY);
        if (result == DM_OK) assert_true(n > 2);
        end(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(patches_come_back),       cmocka_unit_test(coarse_leaks_come_back),
        cmocka_unit_test(part_of_one_piece_stays), cmocka_unit_test(lid_of_one_box_stays),
        cmocka_unit_test(wide_mixture_stays),      cmocka_unit_test(memory_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
