/* Objects of which everything moves: a door leaf alone, two leaves, a part that carries all others. */
#include <math.h>
#include <string.h>

#include "test_world.h"

#define WIDE 0.9f
#define HIGH 2.0f
#define THICK 0.05f
#define SLACK (0.02f * HIGH) /* 2 % of the object's size: how far a line may lie off */

enum { LEAF = 1, OTHER = 2 };

static test_world w;

static void add_leaf(float left, uint32_t part) {
    test_shape_box(&w.shape, (const float[]){left, 0, 0}, (const float[]){left + WIDE, HIGH, THICK}, part);
}

static void open_world(void) {
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    w.shape.vertex_count = w.shape.face_count = 0;
}

static dm_object prepare(const dm_part_desc* parts, uint32_t count) {
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    const dm_object_desc desc = {
        .struct_size = sizeof desc, .mesh = &mesh, .parts = parts, .part_count = count, .model = w.model};
    dm_object object = 0;
    const dm_result result = dm_object_prepare(w.context, &desc, &object);
    if (result != DM_OK) fail_msg("%s", w.messages.text);
    return object;
}

static dm_part_desc part(uint32_t id, uint32_t parent, const dm_drag_hint* drag) {
    return (dm_part_desc){.struct_size = sizeof(dm_part_desc), .id = id, .parent = parent, .drag = drag};
}

static dm_joint joint_of(dm_object object, uint32_t id) {
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_get_joint(w.context, object, id, &joint), DM_OK);
    const float numbers[] = {joint.axis.x,   joint.axis.y, joint.axis.z, joint.origin.x,        joint.origin.y,
                             joint.origin.z, joint.lower,  joint.upper,  joint.joint_confidence};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) assert_true(isfinite(numbers[i]));
    return joint;
}

/* An upright hinge at `x`, anywhere in the leaf's thickness. */
static void assert_hinge(const dm_joint* joint, float x) {
    assert_int_equal(joint->type, DM_JOINT_REVOLUTE);
    assert_true(fabsf(joint->axis.y) > 0.999f);
    assert_true(fabsf(joint->origin.x - x) < SLACK);
    assert_true(joint->origin.z > -SLACK && joint->origin.z < THICK + SLACK);
}

static void a_leaf_alone_turns_about_an_edge(void** state) {
    (void)state;
    open_world();
    add_leaf(0, LEAF);
    const dm_drag_hint right = {{0.95f * WIDE, 0.5f * HIGH, THICK}, {0, 0, 0.1f}};
    const dm_drag_hint left = {{0.05f * WIDE, 0.5f * HIGH, THICK}, {0, 0, 0.1f}};
    dm_part_desc leaf = part(LEAF, 0, &right);
    dm_joint joint = joint_of(prepare(&leaf, 1), LEAF);
    assert_hinge(&joint, 0);
    leaf.drag = &left;
    joint = joint_of(prepare(&leaf, 1), LEAF);
    assert_hinge(&joint, WIDE);
    joint_of(prepare(NULL, 0), LEAF);
    test_world_close(&w);
}

/* What a host does with it next works too: it is told of, picked, dragged, stored. */
static void a_leaf_alone_is_an_object_like_others(void** state) {
    (void)state;
    open_world();
    add_leaf(0, LEAF);
    const dm_drag_hint pull = {{0.95f * WIDE, 0.5f * HIGH, THICK}, {0, 0, 0.1f}};
    const dm_part_desc leaf = part(LEAF, 0, &pull);
    const dm_object object = prepare(&leaf, 1);
    dm_object_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_object_get_info(w.context, object, &info), DM_OK);
    assert_int_equal(info.part_count, 1);
    assert_true(fabsf(info.box_min.x) < 1e-5f && fabsf(info.box_max.x - WIDE) < 1e-5f);
    assert_true(fabsf(info.box_max.y - HIGH) < 1e-5f);

    const dm_scene_desc scene_desc = {.struct_size = sizeof scene_desc};
    dm_scene scene;
    uint32_t instance;
    assert_int_equal(dm_scene_create(w.context, &scene_desc, &scene), DM_OK);
    assert_int_equal(dm_scene_add(w.context, scene, object, NULL, &instance), DM_OK);
    assert_int_equal(dm_scene_commit(w.context, scene), DM_OK);
    const dm_ray ray = {{0.8f, 1, 5}, {0, 0, -1}};
    dm_hit hit = {.struct_size = sizeof hit};
    assert_int_equal(dm_scene_pick(w.context, scene, &ray, &hit), DM_OK);
    assert_int_equal(hit.part_id, LEAF);

    dm_drag drag;
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = LEAF, .grab_point = hit.object_point};
    assert_int_equal(dm_drag_begin(w.context, &desc, &drag), DM_OK);
    dm_drag_state now = {.struct_size = sizeof now};
    for (int frame = 0; frame < 60; frame++) {
        const dm_ray to = {{0.8f - 0.005f * (float)frame, 1.2f, 5}, {0, -0.04f, -1}};
        assert_int_equal(dm_drag_update(w.context, drag, &to, 1.0f / 60, &now), DM_OK);
    }
    assert_true(isfinite(now.value) && fabsf(now.value) > 0.1f);
    assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);

    static uint8_t bytes[1 << 20];
    size_t size;
    dm_object loaded = 0;
    assert_int_equal(dm_object_save(w.context, object, bytes, sizeof bytes, &size), DM_OK);
    assert_int_equal(dm_object_load(w.context, bytes, size, w.model, &loaded), DM_OK);
    const dm_joint saved = joint_of(object, LEAF), read = joint_of(loaded, LEAF);
    assert_memory_equal(&saved, &read, sizeof read);
    test_world_close(&w);
}

static void two_leaves_hang_outside(void** state) {
    (void)state;
    open_world();
    add_leaf(0, LEAF);
    add_leaf(WIDE + 0.005f, OTHER);
    const dm_drag_hint pulls[2] = {{{0.9f * WIDE, 0.5f * HIGH, THICK}, {0, 0, 0.1f}},
                                   {{1.1f * WIDE, 0.5f * HIGH, THICK}, {0, 0, 0.1f}}};
    const dm_part_desc parts[2] = {part(LEAF, 0, &pulls[0]), part(OTHER, 0, &pulls[1])};
    const dm_object object = prepare(parts, 2);
    const dm_joint left = joint_of(object, LEAF), right = joint_of(object, OTHER);
    assert_hinge(&left, 0);
    assert_hinge(&right, 2 * WIDE + 0.005f);
    test_world_close(&w);
}

/* The body of the knob is the leaf that carries it; the leaf has none. */
static void a_part_may_carry_all_the_others(void** state) {
    (void)state;
    open_world();
    add_leaf(0, LEAF);
    test_shape_box(&w.shape, (const float[]){0.8f, 0.9f, THICK}, (const float[]){0.86f, 1.1f, THICK + 0.06f}, OTHER);
    const dm_drag_hint pull = {{0.83f, 1, THICK + 0.06f}, {0, 0, 0.1f}};
    const dm_part_desc parts[2] = {part(LEAF, 0, &pull), part(OTHER, LEAF, NULL)};
    const dm_object object = prepare(parts, 2);
    const dm_joint leaf = joint_of(object, LEAF);
    assert_hinge(&leaf, 0);
    joint_of(object, OTHER);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leaf_alone_turns_about_an_edge),
        cmocka_unit_test(a_leaf_alone_is_an_object_like_others),
        cmocka_unit_test(two_leaves_hang_outside),
        cmocka_unit_test(a_part_may_carry_all_the_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
