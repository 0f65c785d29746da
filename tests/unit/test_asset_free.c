/* Lids that nothing holds: pots and jars of revolution, against boxes, bins, stools and buttons. */
#include <math.h>

#include "test_world.h"

enum { SIDES = 32, NODES = 3, BODY = 0, TOP, EXTRA };

typedef struct test_asset {
    test_world w;
    test_shape shapes[NODES];
    dm_mesh_desc meshes[NODES];
    dm_asset_node nodes[NODES];
    dm_asset_desc desc;
} test_asset;

/* A point of a profile: radius, height. */
typedef float knee[2];

/* Turns a profile about y. */
static void add_lathe(test_shape* shape, const knee* profile, uint32_t count) {
    const uint32_t first = shape->vertex_count;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = 0; k < SIDES; k++) {
            const float turn = 6.2831853f * (float)k / SIDES;
            test_shape_vertex(shape, profile[i][0] * cosf(turn), profile[i][1], profile[i][0] * sinf(turn));
        }
    for (uint32_t i = 0; i + 1 < count; i++)
        for (uint32_t k = 0; k < SIDES; k++) {
            const uint32_t a = first + i * SIDES + k, b = first + i * SIDES + (k + 1) % SIDES;
            test_shape_face(shape, a, a + SIDES, b, 0);
            test_shape_face(shape, b, a + SIDES, b + SIDES, 0);
        }
}

static void set_node(test_asset* t, uint32_t node, const char* name) {
    t->meshes[node] = test_shape_desc(&t->shapes[node]);
    t->meshes[node].part_ids = NULL;
    t->meshes[node].part_id_bytes = 0;
    t->meshes[node].part_id_scope = 0;
    t->nodes[node] = (dm_asset_node){.struct_size = sizeof t->nodes[node],
                                     .parent = DM_ASSET_NO_NODE,
                                     .flags = DM_ASSET_NODE_NO_PIVOT,
                                     .name = name,
                                     .mesh = &t->meshes[node]};
}

/* A vessel with a thick wall, and a lid with a knob on its rim. */
static const knee vessel[] = {{0.001f, 0}, {0.5f, 0}, {0.5f, 0.6f}, {0.44f, 0.6f}, {0.44f, 0.06f}, {0.001f, 0.06f}};
static const knee lid[] = {{0.001f, 0.605f}, {0.5f, 0.605f}, {0.5f, 0.65f},
                           {0.1f, 0.68f},    {0.1f, 0.78f},  {0.001f, 0.78f}};
static const knee plate[] = {{0.001f, 0.605f}, {0.5f, 0.605f}, {0.5f, 0.65f}, {0.001f, 0.65f}};

static test_asset* open_lathes(const char* body, const knee* below, uint32_t below_count, const char* top,
                               const knee* above, uint32_t above_count) {
    test_asset* t = calloc(1, sizeof *t);
    assert_non_null(t);
    test_world_init(&t->w);
    test_world_open(&t->w);
    test_world_load_model(&t->w);
    add_lathe(&t->shapes[BODY], below, below_count);
    add_lathe(&t->shapes[TOP], above, above_count);
    set_node(t, BODY, body);
    set_node(t, TOP, top);
    t->desc = (dm_asset_desc){.struct_size = sizeof t->desc,
                              .nodes = t->nodes,
                              .node_count = 2,
                              .min_moves = 0.001f, /* whether it moves is not asked here */
                              .model = t->w.model};
    return t;
}

#define COUNT(list) (sizeof(list) / sizeof *(list))

static test_asset* open_pot(const char* body, const char* top) {
    return open_lathes(body, vessel, COUNT(vessel), top, lid, COUNT(lid));
}

static void close_asset(test_asset* t) {
    test_world_close(&t->w);
    free(t);
}

static dm_asset create(test_asset* t) {
    dm_asset asset = 0;
    const dm_result result = dm_asset_create(t->w.context, &t->desc, &asset);
    if (result != DM_OK) fail_msg("%s", t->w.messages.text);
    return asset;
}

static uint32_t part_of_top(test_asset* t, dm_asset asset) {
    uint32_t parts[NODES];
    assert_int_equal(dm_asset_get_node_parts(t->w.context, asset, parts, NODES), DM_OK);
    return parts[TOP];
}

/* How the top is answered; -1: it is no part. */
static int32_t state_of_top(test_asset* t, dm_asset asset) {
    const uint32_t index = part_of_top(t, asset);
    dm_asset_part part = dm_asset_part_default();
    if (index == DM_ASSET_NO_PART) return -1;
    assert_int_equal(dm_asset_get_part(t->w.context, asset, index, &part), DM_OK);
    return part.state;
}

static void assert_state(test_asset* t, bool is_free) {
    const int32_t state = state_of_top(t, create(t));
    if ((state == DM_ASSET_FREE) != is_free) fail_msg("'%s' is answered %d", t->nodes[TOP].name, state);
    close_asset(t);
}

/* ---- what is free ---- */

/* It comes off upwards, as far as it is high, and nothing is sure of that. */
static void test_a_pots_lid_is_free(void** state) {
    (void)state;
    test_asset* t = open_pot("teapot", "lid");
    const dm_asset asset = create(t);
    assert_int_equal(state_of_top(t, asset), DM_ASSET_FREE);
    dm_joint joint = dm_joint_default(), others[DM_MAX_HYPOTHESES];
    dm_object object;
    uint32_t count;
    const uint32_t top = part_of_top(t, asset);
    assert_int_equal(dm_asset_get_joint(t->w.context, asset, top, &joint), DM_OK);
    assert_int_equal(joint.type, DM_JOINT_PRISMATIC);
    assert_true(joint.axis.y > 0.999f && joint.lower == 0 && fabsf(joint.upper - 0.175f) < 1e-3f);
    assert_true(joint.joint_confidence <= 0.5f && joint.type_confidence <= 0.5f);
    assert_int_equal(dm_asset_make_object(t->w.context, asset, &object), DM_OK);
    for (uint32_t i = 0; i < DM_MAX_HYPOTHESES; i++) others[i] = dm_joint_default();
    assert_int_equal(dm_object_get_hypotheses(t->w.context, object, top + 1, NULL, others, DM_MAX_HYPOTHESES, &count),
                     DM_OK);
    assert_memory_equal(&others[0], &joint, sizeof joint);
    for (uint32_t i = 1; i < count; i++) {
        assert_true(others[i].joint_confidence <= others[i - 1].joint_confidence);
        assert_false(others[i].type == DM_JOINT_PRISMATIC && fabsf(others[i].axis.y) > 0.999f);
    }
    close_asset(t);
}

static void test_shape_alone_says_so(void** state) {
    (void)state;
    assert_state(open_pot("a", "b"), true);
    test_asset* t = open_pot("box", "drawer");
    t->desc.flags = DM_ASSET_WITHOUT_NAMES;
    assert_state(t, true);
}

static void test_a_cork_is_free(void** state) {
    (void)state;
    static const knee bottle[] = {{0.001f, 0},   {0.3f, 0},     {0.3f, 0.6f},   {0.1f, 0.8f},   {0.1f, 1.1f},
                                  {0.07f, 1.1f}, {0.07f, 0.8f}, {0.25f, 0.58f}, {0.25f, 0.05f}, {0.001f, 0.05f}};
    static const knee cork[] = {{0.001f, 1}, {0.069f, 1}, {0.069f, 1.18f}, {0.001f, 1.18f}};
    assert_state(open_lathes("flask", bottle, COUNT(bottle), "cork", cork, COUNT(cork)), true);
}

/* The asset may lie on its side. */
static void test_up_counts(void** state) {
    (void)state;
    test_asset* t = open_pot("teapot", "lid");
    t->desc.up = (dm_vec3){1, 0, 0};
    assert_state(t, false);
}

/* ---- what is not ---- */

static void test_boxes_and_bins_hinge(void** state) {
    (void)state;
    assert_state(open_pot("trashcan", "lid"), false);
    assert_state(open_pot("toilet", "lid"), false);
    test_asset* t = open_pot("pot", "lid");
    for (uint32_t i = BODY; i <= TOP; i++) t->shapes[i].vertex_count = t->shapes[i].face_count = 0;
    test_shape_box(&t->shapes[BODY], (const float[]){0, 0, 0}, (const float[]){1, 0.6f, 1}, 0);
    test_shape_box(&t->shapes[TOP], (const float[]){0, 0.61f, 0}, (const float[]){1, 0.7f, 1}, 0);
    set_node(t, BODY, "chest");
    set_node(t, TOP, "lid");
    assert_state(t, false);
}

/* A plate that turns, a knob on a panel: solid below, and nothing says that they are lids. */
static void test_what_is_solid_below_is_no_lid(void** state) {
    (void)state;
    static const knee block[] = {{0.001f, 0}, {0.5f, 0}, {0.5f, 0.6f}, {0.001f, 0.6f}};
    assert_state(open_lathes("a", block, COUNT(block), "b", lid, COUNT(lid)), false);
    assert_state(open_lathes("a", block, COUNT(block), "knob", lid, COUNT(lid)), false);
}

/* A button: nothing to hold it by. */
static void test_a_flat_top_needs_a_name(void** state) {
    (void)state;
    assert_state(open_lathes("a", vessel, COUNT(vessel), "b", plate, COUNT(plate)), false);
    assert_state(open_lathes("a", vessel, COUNT(vessel), "lid", plate, COUNT(plate)), true);
}

/* A bar across the lid holds it down. */
static void test_what_is_below_something_is_held(void** state) {
    (void)state;
    test_asset* t = open_pot("pot", "lid");
    test_shape_box(&t->shapes[BODY], (const float[]){-0.6f, 0.9f, -0.05f}, (const float[]){0.6f, 0.95f, 0.05f}, 0);
    set_node(t, BODY, "pot");
    assert_state(t, false);
}

/* A tongue at the edge, as a hinge has it. */
static void test_hardware_at_the_edge_is_a_hinge(void** state) {
    (void)state;
    test_asset* t = open_pot("pot", "lid");
    test_shape_box(&t->shapes[TOP], (const float[]){0.4f, 0.61f, -0.05f}, (const float[]){0.75f, 0.65f, 0.05f}, 0);
    set_node(t, TOP, "lid");
    assert_state(t, false);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_pots_lid_is_free),
        cmocka_unit_test(test_shape_alone_says_so),
        cmocka_unit_test(test_a_cork_is_free),
        cmocka_unit_test(test_up_counts),
        cmocka_unit_test(test_boxes_and_bins_hinge),
        cmocka_unit_test(test_what_is_solid_below_is_no_lid),
        cmocka_unit_test(test_a_flat_top_needs_a_name),
        cmocka_unit_test(test_what_is_below_something_is_held),
        cmocka_unit_test(test_hardware_at_the_edge_is_a_hinge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
