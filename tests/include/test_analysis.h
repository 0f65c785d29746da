/* Analyses part 1 of a shape, for tests of features. */
#ifndef DM_TEST_ANALYSIS_H
#define DM_TEST_ANALYSIS_H

#include "test_env.h"

#include "base/random.h"
#include "kinematics/candidates/candidates.h"
#include "test_shapes.h"

/* A crooked pile of boxes: many directions, so many candidates. */
static inline void test_shape_pile(test_shape* shape, dmi_random* random) {
    shape->vertex_count = shape->face_count = 0;
    for (int i = 0; i < 6; i++) {
        const float x = 0.13f * (float)i, y = 0.1f * dmi_random_unit(random);
        test_shape_box(shape, (const float[]){x, y, 0}, (const float[]){x + 0.12f, y + 0.4f, 0.5f}, 0);
        test_shape_box(shape, (const float[]){x, 0.52f, y}, (const float[]){x + 0.1f, 0.56f + 0.3f * y, 0.5f}, 1);
    }
}

typedef struct test_analysis {
    test_env t;
    dmi_arena arena;
    dmi_mesh* mesh;
    dmi_cloud cloud;
    dmi_part_analysis of_part;
} test_analysis;

/* Large: keep it static. seed: of the cloud. */
static inline void test_analysis_open(test_analysis* a, const test_shape* shape, uint64_t seed) {
    const dm_mesh_desc desc = test_shape_desc(shape);
    dmi_axes axes;
    test_env_open(&a->t, TEST_NEVER);
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create(&a->t.env, &axes, &desc, NULL, 0, NULL, &a->mesh), DM_OK);
    assert_int_equal(dmi_cloud_sample(&a->t.env, a->mesh, 1, seed, &a->cloud), DM_OK);
    dmi_arena_init(&a->arena, &a->t.env, (size_t)1 << 20);
    assert_int_equal(dmi_part_analysis_make(&a->arena, a->mesh, &a->cloud, 1, NULL, NULL, &a->of_part), DM_OK);
}

static inline void test_analysis_close(test_analysis* a) {
    dmi_arena_release(&a->arena);
    dmi_mesh_destroy(&a->t.env, a->mesh);
    test_env_close(&a->t);
}

static inline void test_with_analysis(void (*make)(test_shape* shape),
                                      void (*check)(const dmi_mesh* mesh, const dmi_part_analysis* analysis)) {
    static test_shape shape;
    static test_analysis a;
    shape.vertex_count = shape.face_count = 0;
    make(&shape);
    test_analysis_open(&a, &shape, 3);
    check(a.mesh, &a.of_part);
    test_analysis_close(&a);
}

/* Returns a candidate; axis and origin are in the coordinates of the shape's vertices. */
static inline dmi_candidate test_candidate(const dmi_mesh* mesh, int32_t type, const float axis[3],
                                           const double origin[3]) {
    dmi_candidate c = {.type = type};
    for (int k = 0; k < 3; k++) c.axis[k] = axis[k];
    dmi_frame_point_in(&mesh->frame, origin, c.origin);
    return c;
}

#endif
