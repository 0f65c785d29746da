/* Straight pulls: which drags are read as one, and what KPP-Net makes of a door that is pulled so. */
#include "test_env.h"

#include <math.h>

#include "kinematics/inference/joint_inference.h"
#include "math/linear3.h"
#include "test_shapes.h"
#include "test_world.h"

#define PULLED 1.0f /* rad: turn to whose end the chords lead */

/* A turn about z through the origin. */
static const dmi_candidate turn = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}};

/* Reads a drag of the point (1, 0, 0), which starts to move along y. */
static bool read(const dmi_candidate* candidate, const float vector[3], float angle, float reach, dmi_drag_hint* out) {
    float features[DMI_FEATURE_COUNT] = {0};
    features[DMI_FEATURE_DRAG_ANGLE] = angle, features[DMI_FEATURE_DRAG_REACH] = reach;
    const dmi_drag_hint hint = {{1, 0, 0}, {vector[0], vector[1], vector[2]}};
    return dmi_straight_pull_read(candidate, features, &hint, out);
}

static void a_chord_at_the_far_end_means_the_first_movement(void** state) {
    (void)state;
    const float chord[3] = {cosf(PULLED) - 1, sinf(PULLED), 0};
    dmi_drag_hint found;
    assert_true(read(&turn, chord, 0, 1, &found));
    assert_float_equal(found.vector[0], 0, 1e-6f);
    assert_float_equal(found.vector[1], dmi_length3(chord), 1e-6f);
    assert_float_equal(found.vector[2], 0, 1e-6f);
    assert_float_equal(found.point[0], 1, 0);
}

static void other_drags_are_left_as_they_are(void** state) {
    (void)state;
    const float chord[3] = {cosf(PULLED) - 1, sinf(PULLED), 0}, along[3] = {0, 1, 0};
    const dmi_candidate slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, 1, 0}};
    dmi_drag_hint found;
    assert_false(read(&turn, along, 0, 1, &found));    /* already the first movement */
    assert_false(read(&turn, chord, 0.3f, 1, &found)); /* the turn does not explain it */
    assert_false(read(&turn, chord, 0, 0.6f, &found)); /* held half-way to the axis */
    assert_false(read(&slide, chord, 0.5f, 0, &found));
}

/* A chest from 0 to (1, 0.5, 0.6), whose lid is open by 40 degrees about its back edge, along x at y 0.5, z 0. */
static test_shape shape;
static dmi_cloud cloud;

static void make_chest(void) {
    const float cosine = 0.76604444f, sine = 0.64278761f; /* of 40 degrees */
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 0.02f, 0.6f}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 0.5f, 0.02f}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0.58f}, (const float[]){1, 0.5f, 0.6f}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.02f, 0.5f, 0.6f}, 0);
    test_shape_box(&shape, (const float[]){0.98f, 0, 0}, (const float[]){1, 0.5f, 0.6f}, 0);
    const uint32_t first = shape.vertex_count;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 0.03f, 0.6f}, 1);
    for (uint32_t i = first; i < shape.vertex_count; i++) {
        float* x = shape.xyz[i];
        const float y = x[1], z = x[2];
        x[1] = 0.5f + cosine * y + sine * z, x[2] = cosine * z - sine * y;
    }
}

/* Infers with all weights that ship. point, vector: in the chest's frame. */
static dm_joint infer(const float point[3], const float vector[3], float* out_scale) {
    test_env t;
    size_t sizes[2];
    void* bytes[2] = {test_read_file("sdk/models/kpp_net.safetensors", &sizes[0]),
                      test_read_file("sdk/models/ranker.safetensors", &sizes[1])};
    dmi_kpp_net* net = NULL;
    dmi_joint_models* joints = NULL;
    dmi_mesh* mesh = NULL;
    dmi_axes axes;
    const dm_mesh_desc desc = test_shape_desc(&shape);
    test_env_open(&t, TEST_NEVER);
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create(&t.env, &axes, &desc, NULL, 0, NULL, &mesh), DM_OK);
    assert_int_equal(dmi_cloud_sample(&t.env, mesh, 1, 5, &cloud), DM_OK);
    assert_int_equal(dmi_kpp_net_load(&t.env, bytes[0], sizes[0], &net), DM_OK);
    assert_int_equal(dmi_joint_models_load(&t.env, bytes[1], sizes[1], &joints), DM_OK);
    dmi_drag_hint hint;
    dmi_frame_point_in(&mesh->frame, (const double[]){point[0], point[1], point[2]}, hint.point);
    dmi_frame_vector_in(&mesh->frame, vector, hint.vector);
    const dmi_inference_query query = {
        .mesh = mesh, .cloud = &cloud, .models = {net, joints, DMI_ISA_SCALAR}, .hint = &hint, .part = 1};
    dmi_hypotheses found;
    assert_int_equal(dmi_joint_inference_run(&t.env, &query, &found, NULL), DM_OK);
    const dm_joint joint = dmi_frame_joint_out(&mesh->frame, &found.joints[0]);
    *out_scale = dmi_frame_length_out(&mesh->frame);
    dmi_joint_models_destroy(joints);
    dmi_kpp_net_destroy(net);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
    for (int i = 0; i < 2; i++) free(bytes[i]);
    return joint;
}

static void a_lid_pulled_straight_turns(void** state) {
    (void)state;
    make_chest();
    const float corner[3] = {1, 0.5f + 0.6f * 0.64278761f, 0.6f * 0.76604444f};
    const float pulls[][3] = {{0, 0.1f, 0},
                              {0, 0.6f * (0.98480775f - 0.64278761f), 0.6f * (0.17364818f - 0.76604444f)}};
    for (int i = 0; i < 2; i++) {
        float size;
        const dm_joint joint = infer(corner, pulls[i], &size);
        assert_int_equal(joint.type, DM_JOINT_REVOLUTE);
        assert_float_equal(fabsf(joint.axis.x), 1, 1e-3f);
        assert_float_equal(joint.origin.y, 0.5f, 0.02f * size);
        assert_float_equal(joint.origin.z, 0, 0.02f * size);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_chord_at_the_far_end_means_the_first_movement),
        cmocka_unit_test(other_drags_are_left_as_they_are),
        cmocka_unit_test(a_lid_pulled_straight_turns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
