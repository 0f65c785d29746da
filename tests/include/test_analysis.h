/* Analyses part 1 of a shape, for tests of features. */
#ifndef DM_TEST_ANALYSIS_H
#define DM_TEST_ANALYSIS_H

#include "test_env.h"

#include "kinematics/candidates/candidates.h"
#include "test_shapes.h"

static inline void test_with_analysis(void (*make)(test_shape* shape),
                                      void (*check)(const dmi_mesh* mesh, const dmi_part_analysis* analysis)) {
    static test_shape shape;
    static dmi_cloud cloud;
    static dmi_part_analysis analysis;
    test_env t;
    dmi_arena arena;
    dmi_axes axes;
    dmi_mesh* mesh = NULL;
    test_env_open(&t, TEST_NEVER);
    shape.vertex_count = shape.face_count = 0;
    make(&shape);
    const dm_mesh_desc desc = test_shape_desc(&shape);
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create(&t.env, &axes, &desc, NULL, 0, &mesh), DM_OK);
    assert_int_equal(dmi_cloud_sample(&t.env, mesh, 1, 3, &cloud), DM_OK);
    dmi_arena_init(&arena, &t.env, (size_t)1 << 20);
    assert_int_equal(dmi_part_analysis_make(&arena, mesh, &cloud, 1, NULL, &analysis), DM_OK);
    check(mesh, &analysis);
    dmi_arena_release(&arena);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
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
