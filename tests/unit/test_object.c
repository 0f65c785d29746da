/* Prepared objects: results and errors of prepare, the joint in use, lifetime of dependent handles. */
#include <math.h>
#include <string.h>

#include "kinematics/object/object.h"
#include "motion/dq_vae.h"
#include "test_world.h"

#define assert_near(a, b, tolerance) assert_true(fabsf((a) - (b)) <= (tolerance))

static void assert_joint_bits(const dm_joint* a, const dm_joint* b) {
    assert_memory_equal(a, b, sizeof *a);
}

/* Descriptor of the cabinet without a list of parts. */
typedef struct plain_cabinet {
    dm_mesh_desc mesh;
    dm_object_desc desc;
} plain_cabinet;

static void describe(const test_world* w, plain_cabinet* out) {
    out->mesh = test_shape_desc(&w->shape);
    out->desc = (dm_object_desc){.struct_size = sizeof out->desc, .mesh = &out->mesh, .model = w->model};
}

/* ---- queries ---- */

static void test_info_is_in_host_units(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    dm_object_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_object_get_info(w.context, object, &info), DM_OK);
    assert_int_equal(info.part_count, 2);
    assert_int_equal(info.vertex_count, w.shape.vertex_count);
    assert_int_equal(info.triangle_count, w.shape.face_count);
    assert_int_equal(info.pickable, 1);
    assert_near(info.size, 2, 1e-5f);
    assert_near(info.box_min.x, 0, 1e-5f);
    assert_near(info.box_max.x, 2, 1e-5f);
    assert_near(info.box_max.z, 1.07f, 1e-5f);
    dm_part_info part = {.struct_size = sizeof part};
    assert_int_equal(dm_object_get_part(w.context, object, 1, &part), DM_OK);
    assert_int_equal(part.id, TEST_HANDLE);
    assert_int_equal(part.parent, TEST_DOOR);
    assert_int_equal(part.triangle_count, 12);
    assert_near(part.centre.x, 0.91f, 1e-5f);
    assert_near(part.box_min.z, 1.05f, 1e-5f);
    assert_near(part.area, 2 * (0.02f * 0.2f + 0.02f * 0.02f + 0.2f * 0.02f), 1e-5f);
    assert_int_equal(dm_object_get_part(w.context, object, 2, &part), DM_ERROR_NOT_FOUND);
    test_world_close(&w);
}

static int turns(const dm_joint* joint) {
    return joint->type == DM_JOINT_REVOLUTE || joint->type == DM_JOINT_CONTINUOUS;
}

static void test_a_door_is_revolute_without_weights(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    dm_joint joint = {.struct_size = sizeof joint}, ranked[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *ranked}};
    uint32_t count = 0;
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
    assert_true(turns(&joint));
    assert_true(joint.joint_confidence > 0 && joint.joint_confidence <= 1);
    assert_int_equal(dm_object_get_hypotheses(w.context, object, TEST_DOOR, NULL, ranked, DM_MAX_HYPOTHESES, &count),
                     DM_OK);
    assert_true(count >= 2 && count <= DM_MAX_HYPOTHESES);
    assert_joint_bits(&joint, &ranked[0]);
    for (uint32_t i = 1; i < count; i++)
        assert_true(ranked[i].joint_confidence <= ranked[i - 1].joint_confidence + 1e-6f);
    assert_int_equal(dm_object_get_hypotheses(w.context, object, TEST_DOOR, NULL, ranked, 1, &count), DM_OK);
    assert_int_equal(count, 1);
    assert_int_equal(dm_object_get_hypotheses(w.context, object, TEST_DOOR, NULL, NULL, 0, &count), DM_OK);
    assert_int_equal(count, 0);
    assert_int_equal(dm_object_get_joint(w.context, object, 0, &joint), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_object_get_joint(w.context, object, 3, &joint), DM_ERROR_NOT_FOUND);
    test_world_close(&w);
}

/* Returns the displacement of the pull's point along the pull for a small positive step of the joint. */
static float along_pull(const dm_joint* joint) {
    const dm_drag_hint pull = test_pull();
    dm_pose pose;
    float point[3] = {pull.point.x, pull.point.y, pull.point.z}, moved[3];
    assert_int_equal(dm_joint_pose(joint, 0.01f, &pose), DM_OK);
    dm_pose_apply_points(&pose, point, 0, moved, 0, 1);
    return (moved[0] - point[0]) * pull.vector.x + (moved[1] - point[1]) * pull.vector.y +
           (moved[2] - point[2]) * pull.vector.z;
}

static void test_a_drag_signs_the_hypotheses(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    dm_joint ranked[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *ranked}};
    uint32_t count = 0;
    dm_drag_hint pull = test_pull();
    assert_int_equal(dm_object_get_hypotheses(w.context, object, TEST_DOOR, &pull, ranked, DM_MAX_HYPOTHESES, &count),
                     DM_OK);
    for (uint32_t i = 0; i < count; i++) assert_true(along_pull(&ranked[i]) >= -1e-7f);
    assert_true(turns(&ranked[0]));
    pull.vector.z = 0;
    assert_int_equal(dm_object_get_hypotheses(w.context, object, TEST_DOOR, &pull, ranked, 8, &count),
                     DM_ERROR_ZERO_DRAG);
    test_world_close(&w);
}

/* ---- types and joints given by the host ---- */

static void test_given_types_are_kept(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    plain_cabinet cabinet;
    describe(&w, &cabinet);
    for (int32_t type = DM_JOINT_REVOLUTE; type <= DM_JOINT_FIXED; type++) {
        const dm_part_desc part = {.struct_size = sizeof part, .id = TEST_DOOR, .joint_type = type};
        cabinet.desc.parts = &part;
        cabinet.desc.part_count = 1;
        dm_object object;
        dm_joint joint = {.struct_size = sizeof joint};
        assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_OK);
        assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
        assert_int_equal(joint.type, type);
    }
    const dm_part_desc part = {.struct_size = sizeof part, .id = TEST_DOOR, .joint_type = 6};
    cabinet.desc.parts = &part;
    dm_object object;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(w.messages.text, "parts[0].joint_type is 6"));
    test_world_close(&w);
}

typedef struct asked {
    int calls;
    uint32_t last_id;
    dm_vec3 box_max;
    int32_t answer;
} asked;

static int32_t DM_CALL answer(void* user, uint32_t part_id, dm_vec3 box_min, dm_vec3 box_max) {
    asked* a = user;
    (void)box_min;
    a->calls++;
    a->last_id = part_id;
    a->box_max = box_max;
    return a->answer;
}

static void test_intent_callback(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    plain_cabinet cabinet;
    describe(&w, &cabinet);
    asked a = {.answer = DM_JOINT_PRISMATIC};
    cabinet.desc.intent = answer;
    cabinet.desc.intent_user = &a;
    dm_object object;
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_OK);
    assert_int_equal(a.calls, 2);
    assert_int_equal(a.last_id, TEST_HANDLE);
    assert_near(a.box_max.z, 1.07f, 1e-5f);
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
    assert_int_equal(joint.type, DM_JOINT_PRISMATIC);
    a.answer = 77;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(w.messages.text, "desc.intent answered 77 for part 1"));
    test_world_close(&w);
}

static void test_set_joint(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    dm_joint joint = test_hinge(), now = dm_joint_default();
    joint.axis.y = -3; /* any length */
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &now), DM_OK);
    assert_int_equal(now.source, DM_JOINT_FROM_HOST);
    assert_true(now.joint_confidence == 1 && now.type_confidence == 1 && now.axis.y == -1 && now.upper == joint.upper);
    const struct {
        float* field;
        float value;
        dm_result expected;
        const char* message;
    } faults[] = {
        {&joint.axis.y, 0, DM_ERROR_INVALID_ARGUMENT, "joint.axis has length 0"},
        {&joint.axis.z, (float)NAN, DM_ERROR_NOT_FINITE, "joint.axis.z"},
        {&joint.origin.x, (float)INFINITY, DM_ERROR_NOT_FINITE, "joint.origin.x is inf"},
        {&joint.upper, -1, DM_ERROR_INVALID_ARGUMENT, "joint.lower 0 is above upper -1"},
        {&joint.lower, (float)NAN, DM_ERROR_NOT_FINITE, "joint.lower"},
        {&joint.upper, (float)-INFINITY, DM_ERROR_INVALID_ARGUMENT, "is above upper -inf"},
        {&joint.pitch, (float)NAN, DM_ERROR_NOT_FINITE, "joint.pitch"},
    };
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        joint = test_hinge();
        *faults[i].field = faults[i].value;
        assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &joint), faults[i].expected);
        if (!strstr(w.messages.text, faults[i].message)) fail_msg("no '%s' in: %s", faults[i].message, w.messages.text);
    }
    joint = test_hinge();
    joint.type = DM_JOINT_UNKNOWN;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &joint), DM_ERROR_INVALID_ARGUMENT);
    joint.type = DM_JOINT_CONTINUOUS; /* has no limits: theirs are not checked */
    joint.upper = (float)INFINITY;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, NULL), DM_ERROR_INVALID_ARGUMENT);
    test_world_close(&w);
}

/* ---- invalid input of prepare ---- */

static void test_invalid_meshes_are_reported(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    plain_cabinet cabinet;
    dm_object object = 0;
    describe(&w, &cabinet);
    cabinet.desc.mesh = NULL;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INVALID_ARGUMENT);
    describe(&w, &cabinet);
    cabinet.mesh.index_format = 9;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(w.messages.text, "index_format is 9"));
    describe(&w, &cabinet);
    cabinet.mesh.reserved = 1;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INVALID_ARGUMENT);
    describe(&w, &cabinet);
    cabinet.desc.flags = 8;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INVALID_ARGUMENT);
    describe(&w, &cabinet);
    cabinet.desc.flags = DM_PREPARE_NETWORK_ALONE;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_NO_MODEL);
    describe(&w, &cabinet);
    cabinet.desc.part_count = 3;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INVALID_ARGUMENT);
    describe(&w, &cabinet);
    cabinet.desc.model = 12345;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_STALE_HANDLE);
    describe(&w, &cabinet);
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, NULL), DM_ERROR_INVALID_ARGUMENT);
    w.shape.xyz[3][1] = (float)NAN;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_NOT_FINITE);
    test_shape_cabinet(&w.shape);
    w.shape.corners[5][2] = 4000;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_INDEX_OUT_OF_RANGE);
    test_shape_cabinet(&w.shape);
    memset(w.shape.part, 0, sizeof w.shape.part);
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_EMPTY_MASK);
    test_shape_cabinet(&w.shape);
    memset(w.shape.xyz, 0, sizeof w.shape.xyz);
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_DEGENERATE_MESH);
    assert_int_equal(object, 0);
    test_shape_cabinet(&w.shape);
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_OK); /* the context still works */
    test_world_close(&w);
}

static void test_invalid_drags_are_reported(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    plain_cabinet cabinet;
    describe(&w, &cabinet);
    dm_drag_hint drag = test_pull();
    const dm_part_desc part = {.struct_size = sizeof part, .id = TEST_DOOR, .drag = &drag};
    cabinet.desc.parts = &part;
    cabinet.desc.part_count = 1;
    dm_object object = 0;
    drag.vector = (dm_vec3){0, 0, 0};
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_ZERO_DRAG);
    assert_non_null(strstr(w.messages.text, "dm_object_prepare: desc.parts[0].drag.vector"));
    drag = test_pull();
    drag.point.x = 2.1f; /* 1.1 from the door of an object of size 2 */
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_DRAG_OFF_PART);
    assert_non_null(strstr(w.messages.text, "part 1"));
    drag.point.x = (float)NAN;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_NOT_FINITE);
    drag = test_pull();
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_OK);
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
    assert_true(along_pull(&joint) > 0);
    test_world_close(&w);
}

/* ---- progress and workers ---- */

typedef struct watcher {
    int calls, stop_at;
    float last;
    int rising;
} watcher;

static int32_t DM_CALL watch(void* user, float done) {
    watcher* seen = user;
    if (done < seen->last || done > 1) seen->rising = 0;
    seen->last = done;
    return ++seen->calls == seen->stop_at;
}

static void test_progress_rises_and_cancels(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    plain_cabinet cabinet;
    describe(&w, &cabinet);
    watcher seen = {.rising = 1};
    cabinet.desc.progress = watch;
    cabinet.desc.progress_user = &seen;
    dm_object object = 0;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_OK);
    assert_true(seen.rising && seen.calls >= 4);
    assert_near(seen.last, 1, 1e-6f);
    int calls = seen.calls;
    int64_t held = test_world_bytes(&w);
    for (int stop = 1; stop <= calls; stop++) {
        seen = (watcher){.rising = 1, .stop_at = stop};
        object = 0;
        assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &object), DM_ERROR_CANCELLED);
        assert_int_equal(object, 0);
        assert_int_equal(test_world_bytes(&w), held);
    }
    test_world_close(&w);
}

/* Runs the tasks in an order other than that of a loop. */
static int32_t DM_CALL backwards(void* user, uint32_t count, dm_task task, void* data) {
    (*(int*)user)++;
    for (uint32_t i = count; i-- > 0;) task(data, i);
    return 1;
}

static int32_t DM_CALL declining(void* user, uint32_t count, dm_task task, void* data) {
    (*(int*)user)++;
    (void)count, (void)task, (void)data;
    return 0;
}

static void save_with(int32_t(DM_CALL* parallel_for)(void*, uint32_t, dm_task, void*), int* calls, uint8_t** out,
                      size_t* size) {
    test_world w;
    test_world_init(&w);
    w.desc.jobs = (dm_jobs){calls, parallel_for};
    test_world_open(&w);
    test_world_load_model(&w);
    dm_object object = test_world_cabinet(&w);
    assert_int_equal(dm_object_save(w.context, object, NULL, 0, size), DM_OK);
    *out = malloc(*size);
    assert_int_equal(dm_object_save(w.context, object, *out, *size, size), DM_OK);
    test_world_close(&w);
}

static void test_the_same_bits_for_any_workers(void** state) {
    (void)state;
    uint8_t* blobs[3];
    size_t sizes[3];
    int calls = 0;
    save_with(NULL, &calls, &blobs[0], &sizes[0]);
    assert_int_equal(calls, 0);
    save_with(backwards, &calls, &blobs[1], &sizes[1]);
    assert_true(calls > 0);
    save_with(declining, &calls, &blobs[2], &sizes[2]);
    for (int i = 1; i < 3; i++) {
        assert_int_equal(sizes[i], sizes[0]);
        assert_memory_equal(blobs[i], blobs[0], sizes[0]);
    }
    for (int i = 0; i < 3; i++) free(blobs[i]);
}

/* ---- refinement and motions ---- */

static void test_refine_needs_weights_and_triangles(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    const dm_drag_hint pull = test_pull();
    assert_int_equal(dm_object_refine(w.context, object, TEST_DOOR, &pull), DM_ERROR_NO_MODEL);
    test_world_load_model(&w);
    object = test_world_cabinet(&w);
    assert_int_equal(dm_object_refine(w.context, object, TEST_DOOR, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_object_refine(w.context, object, TEST_DOOR, &pull), DM_OK);
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
    assert_true(along_pull(&joint) > 0);
    dm_object bare;
    assert_int_equal(test_world_prepare(&w, DM_PREPARE_WITHOUT_PICKING, &bare), DM_OK);
    assert_int_equal(dm_object_refine(w.context, bare, TEST_DOOR, &pull), DM_ERROR_UNSUPPORTED);
    test_world_close(&w);
}

/* Refining with a drag gives the bits of preparing with it. */
static void test_refine_equals_prepare(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    plain_cabinet cabinet;
    describe(&w, &cabinet);
    const dm_drag_hint pull = test_pull();
    dm_part_desc part = {.struct_size = sizeof part, .id = TEST_DOOR};
    cabinet.desc.parts = &part;
    cabinet.desc.part_count = 1;
    dm_object refined, prepared;
    dm_joint a = {.struct_size = sizeof a}, b = {.struct_size = sizeof b};
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &refined), DM_OK);
    assert_int_equal(dm_object_refine(w.context, refined, TEST_DOOR, &pull), DM_OK);
    part.drag = &pull;
    assert_int_equal(dm_object_prepare(w.context, &cabinet.desc, &prepared), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, refined, TEST_DOOR, &a), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, prepared, TEST_DOOR, &b), DM_OK);
    assert_joint_bits(&a, &b);
    test_world_close(&w);
}

static void test_picking_does_not_change_joints(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object full = test_world_cabinet(&w), bare;
    assert_int_equal(test_world_prepare(&w, DM_PREPARE_WITHOUT_PICKING, &bare), DM_OK);
    dm_joint a = {.struct_size = sizeof a}, b = {.struct_size = sizeof b};
    assert_int_equal(dm_object_get_joint(w.context, full, TEST_DOOR, &a), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, bare, TEST_DOOR, &b), DM_OK);
    assert_joint_bits(&a, &b);
    dm_object_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_object_get_info(w.context, bare, &info), DM_OK);
    assert_int_equal(info.pickable, 0);
    test_world_close(&w);
}

static void test_motion_follows_the_joint_in_use(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    dm_object object = test_world_cabinet(&w);
    dm_joint hinge = test_hinge();
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
    for (int flipped = 0; flipped < 2; flipped++) {
        const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull()};
        dm_motion motion;
        dm_pose poses[DM_MOTION_FRAMES], pose;
        float values[DM_MOTION_FRAMES], value;
        assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_OK);
        assert_int_equal(dm_motion_get_frames(w.context, motion, poses, values), DM_OK);
        assert_true(values[0] == 0);
        assert_true((flipped ? -1.0f : 1.0f) * values[DM_MOTION_FRAMES - 1] >= 0);
        for (int i = 0; i < DM_MOTION_FRAMES; i++) {
            assert_true(values[i] >= hinge.lower && values[i] <= hinge.upper);
            assert_int_equal(dm_joint_pose(&hinge, values[i], &pose), DM_OK);
            for (int k = 0; k < 4; k++) {
                assert_near(pose.real[k], poses[i].real[k], 1e-6f);
                assert_near(pose.dual[k], poses[i].dual[k], 1e-6f);
            }
        }
        assert_int_equal(dm_motion_sample(w.context, motion, 2, &pose, &value), DM_OK);
        assert_true(value == values[DM_MOTION_FRAMES - 1]);
        assert_int_equal(dm_motion_sample(w.context, motion, -1, &pose, NULL), DM_OK);
        /* The same hinge with its axis negated: the same motion with negated values. */
        hinge = (dm_joint){.struct_size = sizeof(dm_joint),
                           .type = DM_JOINT_REVOLUTE,
                           .axis = {0, 1, 0},
                           .origin = {0, 0.5f, 1.03f},
                           .lower = -1.5f};
        assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
    }
    test_world_close(&w);
}

/* Equal limits mean none: the motion goes about as far as the drag, 0.2 at 0.9 from the hinge. */
static void test_motion_without_limits(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    dm_object object = test_world_cabinet(&w);
    dm_joint hinge = test_hinge();
    hinge.upper = hinge.lower;
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull()};
    dm_pose poses[DM_MOTION_FRAMES];
    float values[DM_MOTION_FRAMES];
    dm_motion motion;
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_OK);
    assert_int_equal(dm_motion_get_frames(w.context, motion, poses, values), DM_OK);
    assert_true(values[DM_MOTION_FRAMES - 1] > 0.15f);
    test_world_close(&w);
}

static void test_motion_arguments(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    dm_motion motion = 0;
    dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull()};
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_ERROR_NO_MODEL);
    test_world_load_model(&w);
    object = test_world_cabinet(&w);
    assert_int_equal(dm_motion_generate(w.context, object, &desc, NULL), DM_ERROR_INVALID_ARGUMENT);
    desc.part_id = 5;
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_ERROR_NOT_FOUND);
    desc.part_id = TEST_DOOR;
    desc.drag.vector.z = 0;
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_ERROR_ZERO_DRAG);
    desc.drag = test_pull();
    desc.drag.point.x = -50;
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_ERROR_DRAG_OFF_PART);
    desc.drag = test_pull();
    dm_vec3 path[3] = {desc.drag.point, {0.8f, 0.5f, 1.3f}, {0.6f, 0.5f, (float)NAN}};
    desc.path_count = 3;
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_ERROR_INVALID_ARGUMENT);
    desc.path = path;
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_ERROR_NOT_FINITE);
    assert_non_null(strstr(w.messages.text, "desc.path[2]"));
    path[2].z = 1.6f;
    assert_int_equal(motion, 0);
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_OK);
    dm_pose pose;
    assert_int_equal(dm_motion_sample(w.context, motion, (float)NAN, &pose, NULL), DM_ERROR_NOT_FINITE);
    assert_int_equal(dm_motion_sample(w.context, motion, 0, NULL, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_motion_get_frames(w.context, motion, NULL, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_model_unload(w.context, w.model), DM_OK);
    assert_int_equal(dm_motion_sample(w.context, motion, 0.5f, &pose, NULL),
                     DM_OK); /* the model may be unloaded by now */
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_ERROR_NO_MODEL);
    assert_int_equal(dm_motion_destroy(w.context, motion), DM_OK);
    assert_int_equal(dm_motion_sample(w.context, motion, 0.5f, &pose, NULL), DM_ERROR_STALE_HANDLE);
    test_world_close(&w);
}

static void test_a_fixed_part_stays(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    const dm_joint fixed = {.struct_size = sizeof fixed, .type = DM_JOINT_FIXED};
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &fixed), DM_OK);
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull()};
    dm_motion motion;
    dm_pose pose;
    float value;
    assert_int_equal(dm_motion_generate(w.context, object, &desc, &motion), DM_OK);
    assert_int_equal(dm_motion_sample(w.context, motion, 1, &pose, &value), DM_OK);
    assert_true(value == 0 && pose.real[3] == 1 && pose.dual[0] == 0);
    test_world_close(&w);
}

/* ---- lifetime ---- */

static void test_destroying_an_object_invalidates_its_handles(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    dm_memory_info before = {.struct_size = sizeof before}, after = {.struct_size = sizeof after};
    const dm_scene_desc scene_desc = {.struct_size = sizeof scene_desc};
    dm_scene scenes[2];
    dm_object stays = test_world_cabinet(&w);
    for (int i = 0; i < 2; i++) assert_int_equal(dm_scene_create(w.context, &scene_desc, &scenes[i]), DM_OK);
    uint32_t instance;
    assert_int_equal(dm_scene_add(w.context, scenes[0], stays, NULL, &instance), DM_OK);
    dm_context_get_memory(w.context, &before);
    dm_object object = test_world_cabinet(&w);
    const dm_motion_desc motion_desc = {.struct_size = sizeof motion_desc, .part_id = TEST_DOOR, .drag = test_pull()};
    const dm_drag_desc drag_desc = {
        .struct_size = sizeof drag_desc, .part_id = TEST_DOOR, .object = object, .grab_point = test_pull().point};
    dm_motion motions[3];
    dm_drag drags[3];
    for (int i = 0; i < 3; i++) {
        assert_int_equal(dm_motion_generate(w.context, object, &motion_desc, &motions[i]), DM_OK);
        assert_int_equal(dm_drag_begin(w.context, &drag_desc, &drags[i]), DM_OK);
    }
    assert_int_equal(dm_motion_destroy(w.context, motions[1]), DM_OK);
    assert_int_equal(dm_drag_end(w.context, drags[0], NULL), DM_OK);
    const dm_pose aside = {.real = {0, 0, 0, 1}, .dual = {5, 0, 0, 0}}; /* 10 to the right */
    for (int i = 0; i < 3; i++) {
        assert_int_equal(dm_scene_add(w.context, scenes[i / 2], object, &aside, &instance), DM_OK);
    }
    assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    dm_pose pose;
    dm_drag_state drag_state = {.struct_size = sizeof drag_state};
    const dm_ray ray = {{10.5f, 0.5f, 5}, {0, 0, -1}};
    assert_int_equal(dm_motion_sample(w.context, motions[0], 0, &pose, NULL), DM_ERROR_STALE_HANDLE);
    assert_int_equal(dm_drag_update(w.context, drags[2], &ray, 0, &drag_state), DM_ERROR_STALE_HANDLE);
    assert_int_equal(dm_drag_end(w.context, drags[2], NULL), DM_ERROR_STALE_HANDLE);
    dm_hit hit = {.struct_size = sizeof hit};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(dm_scene_commit(w.context, scenes[i]), DM_OK);
        assert_int_equal(dm_scene_pick(w.context, scenes[i], &ray, &hit), DM_OK);
        assert_int_equal(hit.object, 0);
    }
    const dm_ray other = {{0.5f, 0.5f, 5}, {0, 0, -1}};
    assert_int_equal(dm_scene_pick(w.context, scenes[0], &other, &hit), DM_OK);
    assert_int_equal(hit.object, stays);
    dm_context_get_memory(w.context, &after);
    /* Scenes may keep memory for instances, and pools for handles, but nothing else; scratch that the context keeps is
     * left out. */
    const uint64_t held_before = before.bytes - before.kept_bytes, held_after = after.bytes - after.kept_bytes;
    assert_true(held_after - held_before < 16384);
    test_world_close(&w);
}

static void test_a_scene_may_be_destroyed_first(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_scene scene;
    dm_object object = test_world_cabinet(&w);
    uint32_t a, b;
    assert_int_equal(dm_scene_create(w.context, &desc, &scene), DM_OK);
    assert_int_equal(dm_scene_add(w.context, scene, object, NULL, &a), DM_OK);
    assert_int_equal(dm_scene_add(w.context, scene, object, NULL, &b), DM_OK);
    assert_int_equal(dm_scene_remove(w.context, scene, a), DM_OK);
    assert_int_equal(dm_scene_remove(w.context, scene, a), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_scene_destroy(w.context, scene), DM_OK);
    assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_info_is_in_host_units),
        cmocka_unit_test(test_a_door_is_revolute_without_weights),
        cmocka_unit_test(test_a_drag_signs_the_hypotheses),
        cmocka_unit_test(test_given_types_are_kept),
        cmocka_unit_test(test_intent_callback),
        cmocka_unit_test(test_set_joint),
        cmocka_unit_test(test_invalid_meshes_are_reported),
        cmocka_unit_test(test_invalid_drags_are_reported),
        cmocka_unit_test(test_progress_rises_and_cancels),
        cmocka_unit_test(test_the_same_bits_for_any_workers),
        cmocka_unit_test(test_refine_needs_weights_and_triangles),
        cmocka_unit_test(test_refine_equals_prepare),
        cmocka_unit_test(test_picking_does_not_change_joints),
        cmocka_unit_test(test_motion_follows_the_joint_in_use),
        cmocka_unit_test(test_motion_without_limits),
        cmocka_unit_test(test_motion_arguments),
        cmocka_unit_test(test_a_fixed_part_stays),
        cmocka_unit_test(test_destroying_an_object_invalidates_its_handles),
        cmocka_unit_test(test_a_scene_may_be_destroyed_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
