/* Welding against all pairs, regions and shells against a search over neighbours, on boxes and on random meshes. */
#include "test_env.h"

#include <math.h>

#include "base/random.h"
#include "mesh/connectivity.h"
#include "test_shapes.h"

static test_shape shape;
static uint32_t welded[TEST_SHAPE_MAX], labels[TEST_SHAPE_MAX], expected[TEST_SHAPE_MAX];
static uint8_t all[TEST_SHAPE_MAX], select_some[TEST_SHAPE_MAX];

typedef struct stage {
    test_env t;
    dmi_arena arena;
    dmi_mesh* mesh;
} stage;

static void open_stage(stage* s) {
    test_env_open(&s->t, TEST_NEVER);
    dmi_arena_init(&s->arena, &s->t.env, 4096);
    dmi_axes axes;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    dm_mesh_desc desc = test_shape_desc(&shape);
    dm_result result = dmi_mesh_create(&s->t.env, &axes, &desc, NULL, 0, NULL, &s->mesh);
    if (result != DM_OK) print_error("%s\n", s->t.messages.text);
    assert_int_equal(result, DM_OK);
    memset(all, 1, sizeof all);
}

static void close_stage(stage* s) {
    dmi_arena_release(&s->arena);
    dmi_mesh_destroy(&s->t.env, s->mesh);
    test_env_close(&s->t);
}

static uint32_t regions(stage* s, const uint8_t* select, float min_cosine) {
    uint32_t count = UINT32_MAX;
    memset(labels, 0xcd, sizeof labels);
    assert_int_equal(dmi_face_regions(&s->arena, s->mesh, welded, select, min_cosine, NULL, labels, &count), DM_OK);
    return count;
}

static void weld(stage* s, float tolerance) {
    assert_int_equal(dmi_weld_vertices(&s->arena, s->mesh, tolerance, NULL, welded), DM_OK);
}

/* Two boxes with 24 vertices of their own each (four a side), as exporters write them. */
static void split_boxes(void) {
    static test_shape boxes;
    boxes.vertex_count = boxes.face_count = 0;
    test_shape_box(&boxes, (const float[]){0, 0, 0}, (const float[]){1, 1, 1}, 0);
    test_shape_box(&boxes, (const float[]){2, 0, 0}, (const float[]){3, 1, 1}, 1);
    shape.vertex_count = shape.face_count = 0;
    for (uint32_t f = 0; f < boxes.face_count; f++) {
        uint32_t v[3];
        for (int i = 0; i < 3; i++) {
            const float* p = boxes.xyz[boxes.corners[f][i]];
            v[i] = test_shape_vertex(&shape, p[0], p[1], p[2]);
        }
        test_shape_face(&shape, v[0], v[1], v[2], boxes.part[f]);
    }
}

static void split_vertices_are_welded(void** state) {
    (void)state;
    split_boxes();
    stage s;
    open_stage(&s);
    for (int exact = 0; exact < 2; exact++) {
        weld(&s, exact ? 0 : 1e-4f);
        uint32_t kept = 0;
        for (uint32_t v = 0; v < shape.vertex_count; v++) {
            kept += welded[v] == v;
            assert_true(welded[v] <= v);
            assert_int_equal(welded[welded[v]], welded[v]);
            assert_memory_equal(shape.xyz[welded[v]], shape.xyz[v], sizeof shape.xyz[v]);
        }
        assert_int_equal(kept, 16);
    }
    close_stage(&s);
}

/* The rule of the header, over all pairs. */
static void check_weld(const dmi_mesh* mesh, float tolerance) {
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        const float* p = mesh->positions + 3 * v;
        uint32_t found = v;
        double nearest_miss = 1;
        for (uint32_t w = 0; w < v; w++) {
            if (welded[w] != w) continue;
            const float* q = mesh->positions + 3 * w;
            double x = (double)(p[0] - q[0]), y = (double)(p[1] - q[1]), z = (double)(p[2] - q[2]);
            double distance = sqrt(x * x + y * y + z * z);
            if (distance <= (double)tolerance && w < found) found = w;
            nearest_miss = fmin(nearest_miss, fabs(distance - (double)tolerance));
        }
        if (nearest_miss > 1e-7) assert_int_equal(welded[v], found);
    }
}

/* A cloud of triangles so dense that cells, their sides and chains of near vertices all occur. */
static void random_soup(uint64_t seed, uint32_t faces, float size) {
    dmi_random random = dmi_random_make(seed, 0);
    shape.vertex_count = shape.face_count = 0;
    for (uint32_t f = 0; f < faces; f++) {
        for (int i = 0; i < 3; i++) {
            float x = dmi_random_unit(&random), y = dmi_random_unit(&random), z = dmi_random_unit(&random);
            test_shape_vertex(&shape, f < 2 ? x : 0.4f + size * x, f < 2 ? y : 0.4f + size * y,
                              f < 2 ? z : 0.4f + size * z);
        }
        test_shape_face(&shape, 3 * f, 3 * f + 1, 3 * f + 2, f % 2);
    }
}

static void welding_matches_all_pairs(void** state) {
    (void)state;
    static const float tolerances[] = {0, 1e-5f, 1e-3f, 0.01f, 0.1f, 0.5f};
    for (uint64_t seed = 0; seed < 4; seed++) {
        random_soup(seed, 130, seed % 2 == 0 ? 0.02f : 0.2f);
        stage s;
        open_stage(&s);
        for (int i = 0; i < 6; i++) {
            weld(&s, tolerances[i]);
            check_weld(s.mesh, tolerances[i]);
        }
        close_stage(&s);
    }
}

static void boxes_have_six_sides_and_one_shell(void** state) {
    (void)state;
    split_boxes();
    stage s;
    open_stage(&s);
    weld(&s, 1e-5f);
    assert_int_equal(regions(&s, all, 0.9f), 12); /* two boxes */
    for (uint32_t f = 0; f < 24; f++) assert_int_equal(labels[f], f / 2);
    assert_int_equal(regions(&s, all, -0.5f), 2); /* any edge will do */
    assert_int_equal(regions(&s, all, -2), 2);
    for (uint32_t f = 0; f < 24; f++) assert_int_equal(labels[f], f / 12);
    memset(select_some, 0, sizeof select_some);
    for (uint32_t f = 12; f < 24; f++) select_some[f] = 255;
    assert_int_equal(regions(&s, select_some, 0.9f), 6);
    for (uint32_t f = 0; f < 24; f++) assert_int_equal(labels[f], f < 12 ? UINT32_MAX : (f - 12) / 2);
    memset(select_some, 0, sizeof select_some);
    assert_int_equal(regions(&s, select_some, 0.9f), 0);
    assert_int_equal(regions(&s, select_some, -2), 0);
    for (uint32_t f = 0; f < 24; f++) assert_int_equal(labels[f], UINT32_MAX);
    for (uint32_t v = 0; v < shape.vertex_count; v++) welded[v] = v; /* nothing welded: every triangle for itself */
    assert_int_equal(regions(&s, all, -2), 24);
    close_stage(&s);
}

/* A corner shared is a shell, but no region; a fold is one region by its angle alone; winding does not matter. */
static void angles_and_corners(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    uint32_t a = test_shape_vertex(&shape, 0, 0, 0), b = test_shape_vertex(&shape, 1, 0, 0);
    uint32_t c = test_shape_vertex(&shape, 0, 1, 0), d = test_shape_vertex(&shape, 0.5f, -0.8f, 0.6f);
    uint32_t e = test_shape_vertex(&shape, -1, 0, 0), f = test_shape_vertex(&shape, -1, 0, 1);
    test_shape_face(&shape, a, b, c, 0);
    test_shape_face(&shape, a, b, d, 1); /* wound the other way; folded: cosine 0.8 */
    test_shape_face(&shape, a, e, f, 1); /* touches in one corner */
    stage s;
    open_stage(&s);
    weld(&s, 0);
    assert_int_equal(regions(&s, all, 0.79f), 2);
    assert_int_equal(labels[0], labels[1]);
    assert_int_equal(regions(&s, all, 0.81f), 3);
    assert_int_equal(regions(&s, all, -1), 2);
    assert_int_equal(regions(&s, all, -1.5f), 1);
    close_stage(&s);
}

/* A fan of flat triangles round one edge: thousands of faces at it cost no square of their number. */
static void an_edge_with_many_faces(void** state) {
    (void)state;
    enum { FACES = 4000 };
    shape.vertex_count = shape.face_count = 0;
    uint32_t a = test_shape_vertex(&shape, 0, 0, 0), b = test_shape_vertex(&shape, 0, 0, 1);
    for (uint32_t f = 0; f < FACES; f++) {
        float angle = 3.0f * (float)f / FACES;
        test_shape_face(&shape, a, b, test_shape_vertex(&shape, cosf(angle), sinf(angle), 0), f % 2);
    }
    stage s;
    open_stage(&s);
    weld(&s, 0);
    assert_int_equal(regions(&s, all, 0.99f), 1);
    assert_int_equal(regions(&s, all, 0.9999999f), FACES);
    close_stage(&s);
}

/* Faces joined by the rule, found by looking at all pairs until nothing changes. */
static uint32_t slow_regions(const dmi_mesh* mesh, const uint8_t* select, float min_cosine) {
    uint32_t count = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) expected[f] = select[f] ? f : UINT32_MAX;
    for (int changed = 1; changed;) {
        changed = 0;
        for (uint32_t i = 0; i < mesh->face_count * mesh->face_count; i++) {
            uint32_t f = i / mesh->face_count, g = i % mesh->face_count, shared = 0;
            if (!select[f] || !select[g] || expected[f] <= expected[g]) continue;
            for (uint32_t k = 0; k < 9; k++) {
                shared += welded[mesh->indices[3 * f + k / 3]] == welded[mesh->indices[3 * g + k % 3]];
            }
            const float *n = mesh->face_normal + 3 * f, *m = mesh->face_normal + 3 * g;
            int smooth = fabsf(n[0] * m[0] + n[1] * m[1] + n[2] * m[2]) > min_cosine;
            if (min_cosine < -1 ? shared == 0 : shared < 2 || !smooth) continue;
            expected[f] = expected[g];
            changed = 1;
        }
    }
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (select[f]) expected[f] = expected[f] == f ? count++ : expected[expected[f]];
    }
    return count;
}

/* A bumpy, torn sheet: some quads are missing, some faces are not selected. */
static void regions_match_a_slow_search(void** state) {
    (void)state;
    for (uint64_t seed = 0; seed < 5; seed++) {
        dmi_random random = dmi_random_make(seed, 0);
        shape.vertex_count = shape.face_count = 0;
        enum { SIDE = 8 };
        for (int i = 0; i < (SIDE + 1) * (SIDE + 1); i++) {
            float bump = dmi_random_unit(&random) < 0.3f ? 0.7f * dmi_random_unit(&random) : 0;
            test_shape_vertex(&shape, (float)(i % (SIDE + 1)), (float)(i / (SIDE + 1)), bump);
        }
        for (uint32_t q = 0; q < SIDE * SIDE; q++) {
            uint32_t v = q / SIDE * (SIDE + 1) + q % SIDE;
            if (q > 1 && dmi_random_unit(&random) < 0.35f) continue;
            test_shape_face(&shape, v, v + 1, v + SIDE + 1, q % 2);
            test_shape_face(&shape, v + 1, v + SIDE + 2, v + SIDE + 1, q % 2);
        }
        stage s;
        open_stage(&s);
        weld(&s, 0);
        for (uint32_t f = 0; f < shape.face_count; f++) select_some[f] = dmi_random_unit(&random) < 0.8f;
        static const float cosines[] = {-2, -1, 0.5f, 0.95f, 0.999f};
        for (int i = 0; i < 10; i++) {
            const uint8_t* select = i % 2 == 0 ? all : select_some;
            uint32_t count = slow_regions(s.mesh, select, cosines[i / 2]);
            assert_int_equal(regions(&s, select, cosines[i / 2]), count);
            assert_memory_equal(labels, expected, shape.face_count * sizeof labels[0]);
        }
        close_stage(&s);
    }
}

static void every_refused_allocation_is_reported(void** state) {
    (void)state;
    split_boxes();
    stage s;
    open_stage(&s);
    dmi_arena_release(&s.arena);
    int failures = 0;
    for (int64_t n = 0;; n++) {
        uint32_t count;
        dmi_arena_init(&s.arena, &s.t.env, 64); /* small blocks: every push asks the host */
        s.t.memory.calls = 0;
        s.t.memory.fail_at = n;
        dm_result result = dmi_weld_vertices(&s.arena, s.mesh, 1e-5f, NULL, welded);
        if (result == DM_OK) result = dmi_face_regions(&s.arena, s.mesh, welded, all, 0.9f, NULL, labels, &count);
        if (result == DM_OK) result = dmi_face_regions(&s.arena, s.mesh, welded, all, -2, NULL, labels, &count);
        dmi_arena_release(&s.arena);
        if (result == DM_OK) break;
        assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        failures++;
    }
    assert_int_equal(failures, 8);
    assert_int_equal(s.t.messages.count, failures);
    close_stage(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(split_vertices_are_welded),
        cmocka_unit_test(welding_matches_all_pairs),
        cmocka_unit_test(boxes_have_six_sides_and_one_shell),
        cmocka_unit_test(angles_and_corners),
        cmocka_unit_test(an_edge_with_many_faces),
        cmocka_unit_test(regions_match_a_slow_search),
        cmocka_unit_test(every_refused_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
