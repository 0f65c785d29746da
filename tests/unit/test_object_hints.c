/* Labels, pivots and the up direction at the boundary: they decide what the shape leaves open, and nothing else. */
#include <math.h>
#include <string.h>

#include "math/linear3.h"
#include "test_world.h"

static const float no_axes[9];

/* A cube with a square plate in the middle of its front, which may be hinged on any side. */
static void make_front(test_shape* shape) {
    shape->vertex_count = shape->face_count = 0;
    test_shape_box(shape, (const float[]){0, 0, 0}, (const float[]){1, 1, 1}, 0);
    test_shape_box(shape, (const float[]){0.1f, 0.1f, 1.004f}, (const float[]){0.9f, 0.9f, 1.03f}, 1);
}

static void open_world(test_world* w, int32_t axes, float unit) {
    test_world_init(w);
    w->desc.axes = axes;
    w->desc.unit_in_metres = unit;
    test_world_open(w);
    test_world_load_model(w);
    make_front(&w->shape);
}

typedef struct asked {
    const char *label, *object_label;
    const dm_pivot* pivot;
    dm_vec3 up;
    const dm_drag_hint* drag;
    int32_t pivot_kind;
} asked;

static dm_result prepare(test_world* w, asked what, dm_object* out) {
    const dm_mesh_desc mesh = test_shape_desc(&w->shape);
    const dm_part_desc part = {.struct_size = sizeof part,
                               .id = 1,
                               .drag = what.drag,
                               .label = what.label,
                               .pivot = what.pivot,
                               .pivot_kind = what.pivot_kind};
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .mesh = &mesh,
                                 .parts = &part,
                                 .part_count = 1,
                                 .model = w->model,
                                 .label = what.object_label,
                                 .up = what.up};
    return dm_object_prepare(w->context, &desc, out);
}

static dm_joint joint_of(test_world* w, dm_object object) {
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_get_joint(w->context, object, 1, &joint), DM_OK);
    return joint;
}

static dm_joint answer(test_world* w, asked what) {
    dm_object object = 0;
    assert_int_equal(prepare(w, what, &object), DM_OK);
    return joint_of(w, object);
}

static void assert_through(const dm_joint* joint, dm_vec3 point, float tolerance) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin), at = dmi_xyz(point);
    assert_int_equal(joint->type, DM_JOINT_REVOLUTE);
    assert_true(dmi_line_distance3(at.v, axis.v, origin.v) < tolerance);
}

static dm_pivot pivot_at(float x, float y, float z) {
    return (dm_pivot){.origin = {x, y, z}, .axes = {1, 0, 0, 0, 2, 0, 0, 0, -1}};
}

static void a_pivot_on_an_edge_decides_the_side(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    const dm_pivot left = pivot_at(0.1f, 0.3f, 1.015f), right = pivot_at(0.9f, 0.3f, 1.015f);
    dm_joint joint = answer(&w, (asked){.pivot = &left});
    assert_through(&joint, left.origin, 0.005f);
    assert_true(fabsf(joint.axis.y) > 0.999f);
    joint = answer(&w, (asked){.pivot = &right});
    assert_through(&joint, right.origin, 0.005f);
    test_world_close(&w);
}

static void a_pivot_that_a_program_has_put_says_nothing(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    const dm_pivot right = pivot_at(0.9f, 0.3f, 1.015f);
    const dm_joint none = answer(&w, (asked){.label = NULL});
    const dm_joint unset = answer(&w, (asked){.pivot = &right, .pivot_kind = DM_PIVOT_DEFAULT});
    assert_memory_equal(&none, &unset, sizeof none);
    test_world_close(&w);
}

/* In the middle of the plate's side: an artist may have meant it, and did where no program did it. */
static void a_pivot_that_somebody_has_set_says_the_more(void** state) {
    (void)state;
    test_world w;
    dm_object object = 0;
    open_world(&w, DM_AXES_GLTF, 0);
    const dm_pivot side = pivot_at(0.9f, 0.5f, 1.017f);
    const dm_joint unknown = answer(&w, (asked){.pivot = &side});
    const dm_joint set = answer(&w, (asked){.pivot = &side, .pivot_kind = DM_PIVOT_SET});
    assert_through(&set, side.origin, 0.005f);
    assert_true(set.joint_confidence > unknown.joint_confidence);
    assert_int_equal(prepare(&w, (asked){.pivot = &side, .pivot_kind = 3}, &object), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(prepare(&w, (asked){.pivot_kind = -1}, &object), DM_ERROR_INVALID_ARGUMENT);
    test_world_close(&w);
}

static void hosts_of_all_axes_get_the_same(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_UNREAL, 0.01f);
    for (uint32_t i = 0; i < w.shape.vertex_count; i++) {
        const float x = w.shape.xyz[i][0], y = w.shape.xyz[i][1], z = w.shape.xyz[i][2];
        const float host[3] = {100 * x, 100 * z, 100 * y};
        memcpy(w.shape.xyz[i], host, sizeof host);
    }
    const dm_pivot right = {.origin = {90, 101.5f, 30}, .axes = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    const dm_joint joint = answer(&w, (asked){.pivot = &right});
    assert_through(&joint, right.origin, 0.5f);
    test_world_close(&w);
}

static void refining_keeps_the_hints(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    const dm_pivot right = pivot_at(0.9f, 0.3f, 1.015f);
    const dm_drag_hint drag = {.point = {0.5f, 0.5f, 1.03f}, .vector = {0, 0, 0.1f}};
    dm_object prepared = 0, refined = 0;
    assert_int_equal(prepare(&w, (asked){.pivot = &right, .drag = &drag}, &prepared), DM_OK);
    assert_int_equal(prepare(&w, (asked){.pivot = &right}, &refined), DM_OK);
    assert_int_equal(dm_object_refine(w.context, refined, 1, &drag), DM_OK);
    const dm_joint a = joint_of(&w, prepared), b = joint_of(&w, refined);
    assert_memory_equal(&a, &b, sizeof a);
    assert_through(&a, right.origin, 0.005f);
    test_world_close(&w);
}

/* How likely the library finds turns, or slides. */
static float share_of(test_world* w, asked what, int32_t type) {
    const dm_joint joint = answer(w, what);
    return joint.type == type ? joint.type_confidence : 1 - joint.type_confidence;
}

static void a_label_tells_drawers_from_doors(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    const float without = share_of(&w, (asked){.label = NULL}, DM_JOINT_PRISMATIC);
    const float drawer = share_of(&w, (asked){.label = "Cabinet/Drawer_01"}, DM_JOINT_PRISMATIC);
    const float door = share_of(&w, (asked){.label = "Cabinet/Door_01"}, DM_JOINT_PRISMATIC);
    const float by_object = share_of(&w, (asked){.object_label = "Drawer", .label = "Cube"}, DM_JOINT_PRISMATIC);
    assert_true(drawer > without && drawer > door);
    assert_true(by_object > without);
    test_world_close(&w);
}

/* How likely the library finds turns about an upright line against those about a level one, along y and along x. */
static float upright_share(test_world* w, asked what) {
    dm_object object = 0;
    dm_joint ranked[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *ranked}};
    uint32_t count = 0;
    float upright = 0, level = 0;
    assert_int_equal(prepare(w, what, &object), DM_OK);
    assert_int_equal(dm_object_get_hypotheses(w->context, object, 1, NULL, ranked, DM_MAX_HYPOTHESES, &count), DM_OK);
    for (uint32_t i = 0; i < count; i++) {
        if (ranked[i].type != DM_JOINT_REVOLUTE) continue;
        upright += fabsf(ranked[i].axis.y) > 0.99f ? ranked[i].joint_confidence : 0;
        level += fabsf(ranked[i].axis.x) > 0.99f ? ranked[i].joint_confidence : 0;
    }
    assert_true(upright + level > 0);
    return upright / (upright + level);
}

static void up_tells_which_side_a_door_hangs_on(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    const float without = upright_share(&w, (asked){.up = {-3, 0, 0}});
    const float upright = upright_share(&w, (asked){.label = "door"});
    const float turned = upright_share(&w, (asked){.label = "door", .up = {-3, 0, 0}});
    assert_true(upright > without + 0.05f);
    assert_true(turned < without - 0.05f);
    test_world_close(&w);
}

static void what_tells_nothing_changes_nothing(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    const dm_joint without = answer(&w, (asked){.label = NULL});
    const dm_joint with = answer(&w, (asked){.label = "Scene/Cube.001", .object_label = "\xFF\xC0", .up = {0, 0, 1}});
    assert_memory_equal(&without, &with, sizeof with);
    const dm_pivot far = {.origin = {1e30f, 0, 0}};
    const dm_joint lost = answer(&w, (asked){.pivot = &far});
    assert_memory_equal(&without, &lost, sizeof lost);
    test_world_close(&w);
}

static void assert_refused(test_world* w, asked what, dm_result code, const char* field) {
    dm_object object = 0;
    assert_int_equal(prepare(w, what, &object), code);
    assert_non_null(strstr(w->messages.text, field));
    assert_int_equal(object, 0);
}

static void bad_hints_are_named(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    char label[DM_MAX_LABEL + 2];
    memset(label, 'a', sizeof label - 1);
    label[sizeof label - 1] = 0;
    assert_refused(&w, (asked){.label = label}, DM_ERROR_TOO_LARGE, "label");
    assert_refused(&w, (asked){.object_label = label}, DM_ERROR_TOO_LARGE, "desc.label");
    label[DM_MAX_LABEL] = 0;
    answer(&w, (asked){.label = label});
    dm_pivot pivot = {.origin = {0, NAN, 0}};
    memcpy(pivot.axes, no_axes, sizeof no_axes);
    assert_refused(&w, (asked){.pivot = &pivot}, DM_ERROR_NOT_FINITE, "pivot");
    pivot = (dm_pivot){.axes = {0, 0, 0, 0, INFINITY}};
    assert_refused(&w, (asked){.pivot = &pivot}, DM_ERROR_NOT_FINITE, "pivot");
    assert_refused(&w, (asked){.up = {0, NAN, 0}}, DM_ERROR_NOT_FINITE, "desc.up");
    answer(&w, (asked){.label = "door"});
    test_world_close(&w);
}

/* A caller built before labels and pivots sends shorter descriptors. */
static void older_callers_are_answered_as_before(void** state) {
    (void)state;
    test_world w;
    open_world(&w, DM_AXES_GLTF, 0);
    const dm_joint now = answer(&w, (asked){.label = NULL});
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    const dm_part_desc part = {.struct_size = offsetof(dm_part_desc, label), .id = 1, .label = "drawer"};
    const dm_object_desc desc = {.struct_size = offsetof(dm_object_desc, label),
                                 .mesh = &mesh,
                                 .parts = &part,
                                 .part_count = 1,
                                 .model = w.model,
                                 .up = {NAN, 0, 0}};
    dm_object object = 0;
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    const dm_joint then = joint_of(&w, object);
    assert_memory_equal(&now, &then, sizeof then);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pivot_on_an_edge_decides_the_side),
        cmocka_unit_test(a_pivot_that_a_program_has_put_says_nothing),
        cmocka_unit_test(a_pivot_that_somebody_has_set_says_the_more),
        cmocka_unit_test(hosts_of_all_axes_get_the_same),
        cmocka_unit_test(refining_keeps_the_hints),
        cmocka_unit_test(a_label_tells_drawers_from_doors),
        cmocka_unit_test(up_tells_which_side_a_door_hangs_on),
        cmocka_unit_test(what_tells_nothing_changes_nothing),
        cmocka_unit_test(bad_hints_are_named),
        cmocka_unit_test(older_callers_are_answered_as_before),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
