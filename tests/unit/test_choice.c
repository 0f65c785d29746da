/* dm_object_desc.choose: the host picks one of a part's hypotheses while the object is prepared. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "test_world.h"

enum { ANSWERS = 8 };

/* What the callback answers for each part id, and what it was shown. */
typedef struct chooser {
    int32_t answers[ANSWERS];
    uint32_t asked[ANSWERS], calls;
    uint32_t count; /* of the door's hypotheses */
    dm_part_info door;
    dm_joint joints[DM_MAX_HYPOTHESES];
    dm_hypothesis hypotheses[DM_MAX_HYPOTHESES];
} chooser;

static int32_t DM_CALL choose(void* user, const dm_choice* choice) {
    chooser* c = user;
    assert_true(choice->struct_size >= sizeof *choice && choice->count >= 1 && choice->count <= DM_MAX_HYPOTHESES);
    c->asked[c->calls++ % ANSWERS] = choice->part->id;
    for (uint32_t i = 0; choice->part->id == TEST_DOOR && i < choice->count; i++) {
        c->count = choice->count;
        c->door = *choice->part;
        c->hypotheses[i] = *choice->hypotheses[i];
        c->joints[i] = *choice->hypotheses[i]->joint;
    }
    return c->answers[choice->part->id];
}

static dm_result prepare(test_world* w, chooser* c, const dm_part_desc* parts, uint32_t count, dm_object* out_object) {
    const dm_mesh_desc mesh = test_shape_desc(&w->shape);
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .mesh = &mesh,
                                 .parts = parts,
                                 .part_count = count,
                                 .model = w->model,
                                 .choose = c != NULL ? choose : NULL,
                                 .choose_user = c};
    return dm_object_prepare(w->context, &desc, out_object);
}

static const chooser keeps = {.answers = {DM_CHOICE_KEEP, DM_CHOICE_KEEP, DM_CHOICE_KEEP}};

static void open_world(test_world* w) {
    test_world_init(w);
    test_world_open(w);
    test_world_load_model(w);
}

static dm_joint joint_of(const test_world* w, dm_object object, uint32_t part) {
    dm_joint joint = dm_joint_default();
    assert_int_equal(dm_object_get_joint(w->context, object, part, &joint), DM_OK);
    return joint;
}

static uint32_t hypotheses_of(const test_world* w, dm_object object, dm_joint out[DM_MAX_HYPOTHESES]) {
    uint32_t count = 0;
    out[0] = dm_joint_default();
    assert_int_equal(dm_object_get_hypotheses(w->context, object, TEST_DOOR, NULL, out, DM_MAX_HYPOTHESES, &count),
                     DM_OK);
    return count;
}

/* ---- what the host is shown ---- */

static void assert_vector(dm_vec3 a, dm_vec3 b, float tolerance) {
    if (!(fabsf(a.x - b.x) <= tolerance && fabsf(a.y - b.y) <= tolerance && fabsf(a.z - b.z) <= tolerance))
        fail_msg("(%g, %g, %g) is not (%g, %g, %g)", (double)a.x, (double)a.y, (double)a.z, (double)b.x, (double)b.y,
                 (double)b.z);
}

/* The end's pose is the joint's at its value, and the box that of the door's corners under it. */
static void check_end(const test_world* w, const dm_joint* joint, const dm_joint_end* end, float size) {
    dm_pose pose;
    dm_vec3 low = {FLT_MAX, FLT_MAX, FLT_MAX}, high = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
    assert_int_equal(dm_joint_pose(joint, end->value, &pose), DM_OK);
    for (uint32_t face = 0; face < w->shape.face_count; face++) {
        for (int k = 0; k < 3 && w->shape.part[face] == TEST_DOOR; k++) {
            float expected[3], p[3];
            const float* corner = w->shape.xyz[w->shape.corners[face][k]];
            dm_pose_apply_points(&pose, corner, 0, expected, 0, 1);
            dm_pose_apply_points(&end->pose, corner, 0, p, 0, 1);
            assert_vector((dm_vec3){p[0], p[1], p[2]}, (dm_vec3){expected[0], expected[1], expected[2]}, 1e-4f * size);
            low = (dm_vec3){fminf(low.x, p[0]), fminf(low.y, p[1]), fminf(low.z, p[2])};
            high = (dm_vec3){fmaxf(high.x, p[0]), fmaxf(high.y, p[1]), fmaxf(high.z, p[2])};
        }
    }
    assert_vector(end->box_min, low, 1e-4f * size);
    assert_vector(end->box_max, high, 1e-4f * size);
    const dm_vec3 middle = {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2}; /* of a cuboid */
    assert_vector(end->centre, middle, 1e-4f * size);
}

static void each_hypothesis_comes_with_both_ends(void** state) {
    (void)state;
    static const int32_t axes[] = {DM_AXES_GLTF, DM_AXES_UNREAL};
    for (int i = 0; i < 2; i++) {
        test_world w;
        test_world_init(&w);
        w.desc.axes = axes[i];
        w.desc.unit_in_metres = i ? 0.01f : 1;
        test_world_open(&w);
        test_world_load_model(&w);
        chooser c = keeps;
        dm_object object;
        assert_int_equal(prepare(&w, &c, NULL, 0, &object), DM_OK);
        dm_joint ranked[DM_MAX_HYPOTHESES];
        dm_part_info door = dm_part_info_default();
        assert_int_equal(hypotheses_of(&w, object, ranked), c.count);
        assert_true(c.count >= 2);
        assert_int_equal(dm_object_get_part(w.context, object, 0, &door), DM_OK);
        assert_memory_equal(&c.door, &door, sizeof door);
        for (uint32_t k = 0; k < c.count; k++) {
            const dm_joint* joint = &c.joints[k];
            assert_memory_equal(joint, &ranked[k], sizeof *joint);
            assert_true(c.hypotheses[k].struct_size == sizeof *c.hypotheses);
            const dm_joint_end* ends = c.hypotheses[k].ends;
            if (joint->lower < joint->upper && joint->type != DM_JOINT_CONTINUOUS)
                assert_true(ends[0].value == joint->lower && ends[1].value == joint->upper);
            else
                assert_true(ends[0].value == -ends[1].value && ends[1].value > 0);
            for (int end = 0; end < 2; end++) check_end(&w, joint, &ends[end], 2);
        }
        test_world_close(&w);
    }
}

/* Runs the tasks last to first, as threads may. */
static int32_t DM_CALL run_backwards(void* user, uint32_t count, dm_task task, void* data) {
    (void)user;
    while (count > 0) task(data, --count);
    return 1;
}

static void parts_are_asked_in_order_and_fixed_ones_not(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    w.desc.jobs.parallel_for = run_backwards;
    test_world_open(&w);
    const dm_part_desc parts[2] = {{.struct_size = sizeof *parts, .id = TEST_HANDLE, .parent = TEST_DOOR},
                                   {.struct_size = sizeof *parts, .id = TEST_DOOR}};
    chooser c = keeps;
    dm_object object;
    assert_int_equal(prepare(&w, &c, parts, 2, &object), DM_OK);
    assert_true(c.calls == 2 && c.asked[0] == TEST_DOOR && c.asked[1] == TEST_HANDLE);
    const dm_part_desc fixed = {.struct_size = sizeof fixed, .id = TEST_DOOR, .joint_type = DM_JOINT_FIXED};
    c = keeps;
    assert_int_equal(prepare(&w, &c, &fixed, 1, &object), DM_OK);
    assert_int_equal(c.calls, 0);
    const dm_part_desc slide = {.struct_size = sizeof slide, .id = TEST_DOOR, .joint_type = DM_JOINT_PRISMATIC};
    c = keeps;
    assert_int_equal(prepare(&w, &c, &slide, 1, &object), DM_OK);
    for (uint32_t i = 0; i < c.count; i++) assert_int_equal(c.joints[i].type, DM_JOINT_PRISMATIC);
    test_world_close(&w);
}

/* ---- what its answer does ---- */

static void the_choice_is_in_force(void** state) {
    (void)state;
    test_world w;
    open_world(&w);
    chooser c = keeps;
    c.answers[TEST_DOOR] = 1;
    dm_object object, loaded;
    assert_int_equal(prepare(&w, &c, NULL, 0, &object), DM_OK);
    dm_joint chosen = joint_of(&w, object, TEST_DOOR), ranked[DM_MAX_HYPOTHESES];
    assert_true(chosen.source == DM_JOINT_CHOSEN && chosen.joint_confidence == 1 && chosen.type_confidence == 1);
    dm_joint expected = c.joints[1]; /* but for source and confidences */
    expected.source = DM_JOINT_CHOSEN, expected.joint_confidence = expected.type_confidence = 1;
    assert_memory_equal(&chosen, &expected, sizeof chosen);
    assert_int_equal(hypotheses_of(&w, object, ranked), c.count);
    for (uint32_t i = 0; i < c.count; i++) assert_memory_equal(&ranked[i], &c.joints[i], sizeof *ranked);

    static uint8_t file[1 << 20];
    size_t size = 0;
    assert_int_equal(dm_object_save(w.context, object, file, sizeof file, &size), DM_OK);
    assert_int_equal(dm_object_load(w.context, file, size, 0, &loaded), DM_OK);
    chosen = joint_of(&w, loaded, TEST_DOOR);
    assert_memory_equal(&chosen, &expected, sizeof chosen);

    assert_int_equal(dm_object_reset_joint(w.context, object, TEST_DOOR), DM_OK);
    chosen = joint_of(&w, object, TEST_DOOR);
    assert_memory_equal(&chosen, &c.joints[0], sizeof chosen);
    test_world_close(&w);
}

static void keeping_is_as_if_nobody_asked(void** state) {
    (void)state;
    test_world w;
    open_world(&w);
    chooser c = keeps;
    dm_object asked, unasked;
    assert_int_equal(prepare(&w, &c, NULL, 0, &asked), DM_OK);
    assert_int_equal(prepare(&w, NULL, NULL, 0, &unasked), DM_OK);
    assert_int_equal(c.calls, 2);
    for (uint32_t part = TEST_DOOR; part <= TEST_HANDLE; part++) {
        const dm_joint a = joint_of(&w, asked, part), b = joint_of(&w, unasked, part);
        assert_memory_equal(&a, &b, sizeof a);
    }
    test_world_close(&w);
}

static void what_is_no_index_is_refused_by_name(void** state) {
    (void)state;
    test_world w;
    open_world(&w);
    static const int32_t wrong[] = {DM_MAX_HYPOTHESES, -2, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        chooser c = keeps;
        char words[64];
        dm_object object = 77;
        c.answers[TEST_HANDLE] = wrong[i];
        assert_int_equal(prepare(&w, &c, NULL, 0, &object), DM_ERROR_INDEX_OUT_OF_RANGE);
        assert_int_equal(object, 77);
        snprintf(words, sizeof words, "desc.choose answered %d for part 2", wrong[i]);
        if (!strstr(w.messages.text, words)) fail_msg("no '%s' in: %s", words, w.messages.text);
    }
    test_world_cabinet(&w); /* the context is usable */
    test_world_close(&w);
}

/* As docs/integration.md has it. */
static int32_t DM_CALL first_that_rises(void* user, const dm_choice* choice) {
    (void)user;
    for (uint32_t i = 0; i < choice->count; i++)
        if (choice->hypotheses[i]->ends[1].centre.y > choice->part->centre.y) return (int32_t)i;
    return DM_CHOICE_KEEP;
}

static void a_rule_of_the_host_picks_by_where_the_part_goes(void** state) {
    (void)state;
    test_world w;
    open_world(&w);
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = w.model, .choose = first_that_rises};
    dm_object object;
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    const dm_joint joint = joint_of(&w, object, TEST_DOOR);
    dm_part_info door = dm_part_info_default();
    dm_pose pose;
    assert_int_equal(dm_object_get_part(w.context, object, 0, &door), DM_OK);
    assert_int_equal(joint.source, DM_JOINT_CHOSEN);
    assert_int_equal(dm_joint_pose(&joint, joint.upper, &pose), DM_OK);
    float centre[3] = {door.centre.x, door.centre.y, door.centre.z};
    dm_pose_apply_points(&pose, centre, 0, centre, 0, 1);
    assert_true(centre[1] > door.centre.y);
    test_world_close(&w);
}

/* ---- what it does in a drag ---- */

static dm_vec3 moved(const dm_joint* joint, float value) {
    dm_pose pose;
    float point[3] = {test_pull().point.x, test_pull().point.y, test_pull().point.z};
    assert_int_equal(dm_joint_pose(joint, value, &pose), DM_OK);
    dm_pose_apply_points(&pose, point, 0, point, 0, 1);
    return (dm_vec3){point[0], point[1], point[2]};
}

/* Pulls the handle along a joint to `value`, seen from the front above. */
static dm_part_state pull(const test_world* w, dm_object object, const dm_part_state* from, const dm_joint* along,
                          float value) {
    const dm_vec3 eye = {2.5f, 1.8f, 4};
    const float start = from != NULL ? from->value : 0;
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = TEST_DOOR,
                               .object = object,
                               .grab_point = moved(along, start),
                               .state = from};
    dm_drag drag;
    dm_drag_state now = dm_drag_state_default();
    dm_part_state end = dm_part_state_default();
    assert_int_equal(dm_drag_begin(w->context, &desc, &drag), DM_OK);
    for (int k = 0; k <= 90; k++) {
        const dm_vec3 to = moved(along, start + (value - start) * fminf((float)k / 60, 1));
        const dm_ray ray = {eye, {to.x - eye.x, to.y - eye.y, to.z - eye.z}};
        assert_int_equal(dm_drag_update(w->context, drag, &ray, 0.016f, &now), DM_OK);
    }
    assert_int_equal(dm_drag_end(w->context, drag, &end), DM_OK);
    return end;
}

static bool turns(const dm_joint* joint) {
    return joint->type != DM_JOINT_PRISMATIC;
}

/* A slide that the host has chosen stays one, whatever the pull says; without a choice the drag changes to the hinge.
 */
static void a_pull_does_not_leave_the_choice(void** state) {
    (void)state;
    const dm_joint hinge = test_hinge();
    test_world w;
    open_world(&w);
    chooser c = keeps;
    dm_object object;
    assert_int_equal(prepare(&w, &c, NULL, 0, &object), DM_OK);
    uint32_t slide = 0;
    while (slide < c.count && turns(&c.joints[slide])) slide++;
    assert_true(slide < c.count);
    assert_true(turns(&(dm_joint){.type = pull(&w, object, NULL, &hinge, 1.2f).joint.type}));
    c = keeps;
    c.answers[TEST_DOOR] = (int32_t)slide;
    assert_int_equal(prepare(&w, &c, NULL, 0, &object), DM_OK);
    dm_part_state end = pull(&w, object, NULL, &hinge, 1.2f);
    assert_true(!turns(&end.joint) && end.joint.source == DM_JOINT_CHOSEN);
    end = pull(&w, object, &(dm_part_state){.struct_size = sizeof end, .joint = end.joint}, &hinge, 1.2f);
    assert_true(!turns(&end.joint) && end.joint.source == DM_JOINT_CHOSEN);
    test_world_close(&w);
}

/* Nor does a pull to the other side of rest turn the range of the choice round; without a choice it does. */
static void a_pull_does_not_turn_the_choice_round(void** state) {
    (void)state;
    test_world w;
    open_world(&w);
    chooser c = keeps;
    dm_object object;
    for (int chosen = 0; chosen < 2; chosen++) {
        c.answers[TEST_DOOR] = 0;
        assert_int_equal(prepare(&w, &c, NULL, 0, &object), DM_OK);
        dm_part_state start = {.struct_size = sizeof start, .joint = joint_of(&w, object, TEST_DOOR)};
        assert_true(turns(&start.joint) && start.joint.lower <= 0 && start.joint.upper > 0.5f);
        start.joint.origin.z += 1; /* like none of the hypotheses, so that its free range is unknown */
        if (!chosen) start.joint.source = DM_JOINT_FROM_NETWORK;
        const dm_part_state end = pull(&w, object, &start, &start.joint, -0.8f);
        assert_int_equal(end.joint.lower < -0.5f, !chosen);
        assert_int_equal(end.value < -0.5f, !chosen);
    }
    test_world_close(&w);
}

/* Limits of a chosen joint are the library's estimates: a pull that goes on takes the part beyond them. */
static void limits_of_the_choice_give(void** state) {
    (void)state;
    test_world w;
    open_world(&w);
    chooser c = keeps;
    c.answers[TEST_DOOR] = 0;
    dm_object object;
    assert_int_equal(prepare(&w, &c, NULL, 0, &object), DM_OK);
    const dm_joint joint = joint_of(&w, object, TEST_DOOR);
    assert_true(joint.type == DM_JOINT_REVOLUTE && joint.upper > 0.5f);
    dm_part_state start = {.struct_size = sizeof start, .joint = joint};
    start.joint.upper = 0.5f;
    dm_part_state end = pull(&w, object, &start, &joint, 1.2f);
    assert_true(end.value > 1);
    start.joint.source = DM_JOINT_FROM_HOST;
    end = pull(&w, object, &start, &joint, 1.2f);
    assert_true(end.value <= 0.5f);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_hypothesis_comes_with_both_ends),
                                       cmocka_unit_test(parts_are_asked_in_order_and_fixed_ones_not),
                                       cmocka_unit_test(the_choice_is_in_force),
                                       cmocka_unit_test(keeping_is_as_if_nobody_asked),
                                       cmocka_unit_test(what_is_no_index_is_refused_by_name),
                                       cmocka_unit_test(a_rule_of_the_host_picks_by_where_the_part_goes),
                                       cmocka_unit_test(a_pull_does_not_leave_the_choice),
                                       cmocka_unit_test(a_pull_does_not_turn_the_choice_round),
                                       cmocka_unit_test(limits_of_the_choice_give)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
