/* The whole way from a mesh and a part to joint hypotheses: a door, a drawer, poses, drags, memory that runs out. */
#include "test_env.h"

#include <math.h>

#include "kinematics/inference/joint_inference.h"
#include "math/linear3.h"
#include "test_shapes.h"
#include "test_world.h"

static test_shape shape;
static dmi_cloud cloud;

typedef struct bench {
    test_env t;
    dmi_mesh* mesh;
} bench;

static dmi_mesh* make_mesh(dmi_env* env, const test_shape* from) {
    dm_mesh_desc desc = test_shape_desc(from);
    dmi_axes axes;
    dmi_mesh* mesh = NULL;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create(env, &axes, &desc, NULL, 0, NULL, &mesh), DM_OK);
    return mesh;
}

static void open_bench(bench* b) {
    test_env_open(&b->t, TEST_NEVER);
    b->mesh = make_mesh(&b->t.env, &shape);
    assert_int_equal(dmi_cloud_sample(&b->t.env, b->mesh, 1, 5, &cloud), DM_OK);
}

static void close_bench(bench* b) {
    dmi_mesh_destroy(&b->t.env, b->mesh);
    test_env_close(&b->t);
}

/* An open case of five slabs with a drawer that fills it. */
static void make_drawer(void) {
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.6f, 0.3f, 0.02f}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.02f, 0.3f, 0.5f}, 0);
    test_shape_box(&shape, (const float[]){0.58f, 0, 0}, (const float[]){0.6f, 0.3f, 0.5f}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.6f, 0.02f, 0.5f}, 0);
    test_shape_box(&shape, (const float[]){0, 0.28f, 0}, (const float[]){0.6f, 0.3f, 0.5f}, 0);
    test_shape_box(&shape, (const float[]){0.023f, 0.023f, 0.05f}, (const float[]){0.577f, 0.2f, 0.5f}, 1);
}

/* A case with a door that nearly fills the front, hinged by two knuckles on its left edge. */
static void make_door(void) {
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.5f, 0.8f, 0.4f}, 0);
    test_shape_box(&shape, (const float[]){0, 0.01f, 0.405f}, (const float[]){0.49f, 0.79f, 0.425f}, 1);
    for (int i = 0; i < 2; i++) {
        float y = i == 0 ? 0.1f : 0.6f;
        test_shape_box(&shape, (const float[]){-0.012f, y, 0.395f}, (const float[]){0.004f, y + 0.08f, 0.412f}, 0);
    }
    test_shape_box(&shape, (const float[]){0.44f, 0.35f, 0.425f}, (const float[]){0.46f, 0.45f, 0.45f}, 1);
}

static dmi_hypotheses infer(bench* b, const dmi_drag_hint* hint, int32_t type) {
    dmi_inference_query query = {.mesh = b->mesh, .cloud = &cloud, .hint = hint, .part = 1, .given_type = type};
    dmi_hypotheses found;
    assert_int_equal(dmi_joint_inference_run(&b->t.env, &query, &found, NULL), DM_OK);
    return found;
}

/* The same with the weights that ship, the ranker alone. */
static dmi_hypotheses infer_ranked(bench* b, const dmi_drag_hint* hint) {
    size_t size;
    void* bytes = test_read_file("sdk/models/ranker.safetensors", &size);
    dmi_joint_models* joints = NULL;
    assert_int_equal(dmi_joint_models_load(&b->t.env, bytes, size, &joints), DM_OK);
    dmi_inference_query query = {.mesh = b->mesh, .cloud = &cloud, .hint = hint, .part = 1, .models.joints = joints};
    dmi_hypotheses found;
    assert_int_equal(dmi_joint_inference_run(&b->t.env, &query, &found, NULL), DM_OK);
    dmi_joint_models_destroy(joints);
    free(bytes);
    return found;
}

static dmi_drag_hint hint_at(const bench* b, double x, double y, double z, float vx, float vy, float vz) {
    dmi_drag_hint hint;
    dmi_frame_point_in(&b->mesh->frame, (const double[]){x, y, z}, hint.point);
    dmi_frame_vector_in(&b->mesh->frame, (const float[]){vx, vy, vz}, hint.vector);
    return hint;
}

static void check_hypotheses(const dmi_hypotheses* h) {
    assert_in_range(h->count, 1, DM_MAX_HYPOTHESES);
    float sum = 0;
    for (uint32_t i = 0; i < h->count; i++) {
        const dm_joint* joint = &h->joints[i];
        float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
        assert_float_equal(dmi_length3(axis), 1, 1e-4f);
        assert_true(joint->upper > joint->lower && isfinite(joint->upper) && isfinite(joint->lower));
        assert_true(joint->joint_confidence >= 0 && joint->type_confidence >= joint->joint_confidence - 1e-4f);
        if (i > 0) assert_true(joint->joint_confidence <= h->joints[i - 1].joint_confidence + 1e-4f);
        sum += joint->joint_confidence;
    }
    assert_true(sum <= 1.001f);
}

static void a_drawer_slides_out(void** state) {
    (void)state;
    bench b;
    make_drawer();
    open_bench(&b);
    dmi_drag_hint hint = hint_at(&b, 0.3, 0.1, 0.5, 0.01f, 0, 0.1f);
    dmi_hypotheses found = infer_ranked(&b, &hint);
    assert_int_equal(found.joints[0].type, DM_JOINT_PRISMATIC);
    assert_float_equal(found.joints[0].axis.z, 1, 1e-3f);
    /* 0.45 deep in an object of size 0.6: it comes out by a third of that at least, and not inwards. */
    assert_true(found.joints[0].upper > 0.25f && found.joints[0].upper < 0.75f);
    assert_true(found.joints[0].lower > -0.15f);
    close_bench(&b);
}

/* Pulled at mid-height, the door could as well be a flap: the rules alone need only name its hinges early. */
static void a_door_turns_about_its_hinges(void** state) {
    (void)state;
    bench b;
    make_door();
    open_bench(&b);
    dmi_drag_hint hint = hint_at(&b, 0.45, 0.4, 0.45, 0, 0.005f, 0.1f);
    dmi_hypotheses found = infer(&b, &hint, DM_JOINT_REVOLUTE);
    check_hypotheses(&found);
    uint32_t hinge = 0;
    while (hinge < found.count && fabsf(found.joints[hinge].axis.y) < 0.99f) hinge++;
    assert_in_range(hinge, 0, 2);
    for (uint32_t i = 0; i < found.count; i++) {
        float velocity[3];
        assert_int_equal(found.joints[i].type, DM_JOINT_REVOLUTE);
        dmi_joint_velocity(&found.joints[i], 0, hint.point, velocity);
        assert_true(dmi_dot3(velocity, hint.vector) > 0);
    }
    close_bench(&b);
}

static void a_given_type_is_kept(void** state) {
    (void)state;
    static const int32_t types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};
    bench b;
    make_door();
    open_bench(&b);
    for (int i = 0; i < 4; i++) {
        dmi_hypotheses found = infer(&b, NULL, types[i]);
        check_hypotheses(&found);
        for (uint32_t k = 0; k < found.count; k++) assert_int_equal(found.joints[k].type, types[i]);
    }
    close_bench(&b);
}

/* The same object turned by 90 degrees about x, ten times as large and elsewhere: the same joint, moved along. */
static void the_answer_moves_with_the_object(void** state) {
    (void)state;
    bench b;
    make_drawer();
    open_bench(&b);
    dmi_hypotheses before = infer(&b, NULL, DM_JOINT_PRISMATIC);
    close_bench(&b);
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        float* p = shape.xyz[i];
        float y = p[1], z = p[2];
        p[0] = 10 * p[0] + 3, p[1] = -10 * z - 7, p[2] = 10 * y + 1;
    }
    open_bench(&b);
    dmi_hypotheses after = infer(&b, NULL, DM_JOINT_PRISMATIC);
    close_bench(&b);
    const dm_joint *p = &before.joints[0], *q = &after.joints[0];
    const float turned[3] = {p->axis.x, -p->axis.z, p->axis.y}, axis[3] = {q->axis.x, q->axis.y, q->axis.z};
    assert_true(fabsf(dmi_dot3(turned, axis)) > 0.999f);
    assert_float_equal(p->upper - p->lower, q->upper - q->lower, 0.05f);
}

static void the_same_query_gives_the_same_bits(void** state) {
    (void)state;
    bench b;
    make_door();
    open_bench(&b);
    dmi_hypotheses first = infer(&b, NULL, DM_JOINT_UNKNOWN), second = infer(&b, NULL, DM_JOINT_UNKNOWN);
    assert_int_equal(first.count, second.count);
    assert_memory_equal(first.joints, second.joints, first.count * sizeof *first.joints);
    close_bench(&b);
}

static void orienting_follows_the_drag(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .lower = -0.5f, .upper = 2};
    dmi_drag_hint hint = {{1, 0, 0}, {0, -1, 0}};
    dmi_joint_orient(&joint, &hint);
    assert_float_equal(joint.axis.z, -1, 0);
    assert_float_equal(joint.lower, -2, 0);
    assert_float_equal(joint.upper, 0.5f, 0);
    dmi_joint_orient(&joint, &hint);
    assert_float_equal(joint.axis.z, -1, 0);
    dm_joint fixed = {.type = DM_JOINT_FIXED, .axis = {1, 0, 0}};
    dmi_joint_orient(&fixed, &hint);
    assert_float_equal(fixed.axis.x, 1, 0);
}

static dmi_hypotheses slide_or_turn(void) {
    dmi_hypotheses h = {.count = 2};
    h.joints[0] = (dm_joint){.type = DM_JOINT_PRISMATIC,
                             .axis = {1, 0, 0},
                             .upper = 0.5f,
                             .joint_confidence = 0.6f,
                             .type_confidence = 0.6f};
    h.joints[1] = (dm_joint){.type = DM_JOINT_REVOLUTE,
                             .axis = {0, 0, 1},
                             .origin = {-1, 0, 0},
                             .upper = 1.5f,
                             .joint_confidence = 0.3f,
                             .type_confidence = 0.4f};
    return h;
}

static void a_drag_reranks(void** state) {
    (void)state;
    dmi_hypotheses before = slide_or_turn(), after;
    dmi_drag_hint along = {{0, 0, 0}, {1, 0.1f, 0}}, across = {{0, 0, 0}, {0.05f, 1, 0}};
    dmi_hypotheses_rerank(&before, &along, &after);
    assert_int_equal(after.joints[0].type, DM_JOINT_PRISMATIC);
    assert_true(after.joints[0].joint_confidence > 0.6f);
    dmi_hypotheses_rerank(&before, &across, &after);
    assert_int_equal(after.count, 2);
    assert_int_equal(after.joints[0].type, DM_JOINT_REVOLUTE);
    assert_true(after.joints[0].joint_confidence > 0.8f && after.joints[0].type_confidence > 0.8f);
    assert_float_equal(after.joints[0].joint_confidence + after.joints[1].joint_confidence, 0.9f, 1e-4f);
    /* In place. */
    dmi_hypotheses_rerank(&before, &across, &before);
    assert_int_equal(before.joints[0].type, DM_JOINT_REVOLUTE);
}

/* How unlike each other two joints move the corners of the door: the sine between their velocities. */
static float unlike(const dm_joint* a, const dm_joint* b) {
    float aa = 0, ab = 0, bb = 0;
    for (int corner = 0; corner < 8; corner++) {
        const float x = corner & 1 ? 0.3f : -0.3f, y = corner & 2 ? 0.4f : -0.4f, z = corner & 4 ? 0.25f : 0.2f;
        float u[3], v[3];
        dmi_joint_velocity(a, 0, (const float[]){x, y, z}, u);
        dmi_joint_velocity(b, 0, (const float[]){x, y, z}, v);
        aa += dmi_dot3(u, u), ab += dmi_dot3(u, v), bb += dmi_dot3(v, v);
    }
    return sqrtf(fmaxf(1 - ab * ab / (aa * bb), 0));
}

static dm_joint joint_of(const dmi_alternative* one) {
    return (dm_joint){.type = one->type,
                      .axis = {one->axis[0], one->axis[1], one->axis[2]},
                      .origin = {one->origin[0], one->origin[1], one->origin[2]}};
}

static void alternatives_are_unlike_all_before_them(void** state) {
    (void)state;
    static const int32_t given[] = {DM_JOINT_UNKNOWN, DM_JOINT_PRISMATIC, DM_JOINT_CONTINUOUS, DM_JOINT_SCREW};
    make_door();
    bench b;
    open_bench(&b);
    for (int g = 0; g < 4; g++) {
        const dmi_inference_query query = {.mesh = b.mesh, .cloud = &cloud, .part = 1, .given_type = given[g]};
        dmi_hypotheses found;
        dmi_alternatives others;
        assert_int_equal(dmi_joint_inference_run(&b.t.env, &query, &found, &others), DM_OK);
        assert_true(others.count <= DMI_ALTERNATIVES);
        if (given[g] == DM_JOINT_UNKNOWN) assert_true(others.count > DMI_ALTERNATIVES / 2);
        if (given[g] == DM_JOINT_SCREW) assert_int_equal(others.count, 0);
        for (uint32_t i = 0; i < others.count; i++) {
            const dm_joint joint = joint_of(&others.list[i]);
            assert_true(others.list[i].confidence >= 0 && others.list[i].confidence <= 1);
            assert_true(given[g] == DM_JOINT_UNKNOWN || joint.type == given[g]);
            for (uint32_t k = 0; k < found.count; k++)
                if (dmi_joint_turns(found.joints[k].type) == dmi_joint_turns(joint.type))
                    assert_true(unlike(&joint, &found.joints[k]) > 0.03f);
            for (uint32_t k = 0; k < i; k++) {
                const dm_joint before = joint_of(&others.list[k]);
                if (before.type == joint.type) assert_true(unlike(&joint, &before) > 0.03f);
            }
        }
    }
    close_bench(&b);
}

static void memory_that_runs_out_is_reported(void** state) {
    (void)state;
    make_door();
    for (int64_t fail_at = 0; fail_at < 400; fail_at++) {
        test_env t;
        test_env_open(&t, TEST_NEVER);
        dmi_mesh* mesh = make_mesh(&t.env, &shape);
        assert_int_equal(dmi_cloud_sample(&t.env, mesh, 1, 5, &cloud), DM_OK);
        t.memory.fail_at = t.memory.calls + fail_at;
        dmi_inference_query query = {.mesh = mesh, .cloud = &cloud, .part = 1};
        dmi_hypotheses found;
        dmi_alternatives others;
        dm_result result = dmi_joint_inference_run(&t.env, &query, &found, &others);
        dmi_mesh_destroy(&t.env, mesh);
        if (result != DM_OK) {
            assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
            assert_int_equal(t.messages.code, DM_ERROR_OUT_OF_MEMORY);
        }
        test_env_close(&t);
        if (result == DM_OK) return;
    }
    fail_msg("it never succeeded");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drawer_slides_out),
        cmocka_unit_test(a_door_turns_about_its_hinges),
        cmocka_unit_test(a_given_type_is_kept),
        cmocka_unit_test(the_answer_moves_with_the_object),
        cmocka_unit_test(the_same_query_gives_the_same_bits),
        cmocka_unit_test(orienting_follows_the_drag),
        cmocka_unit_test(a_drag_reranks),
        cmocka_unit_test(alternatives_are_unlike_all_before_them),
        cmocka_unit_test(memory_that_runs_out_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
