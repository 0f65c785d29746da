/* Which body of an asset carries which, of boxes that are bodies for certain. */
#include "test_env.h"

#include <stdlib.h>
#include <string.h>

#include "assets/asset_grouping.h"
#include "assets/carrier_features.h"
#include "mesh/mesh.h"
#include "test_shapes.h"

enum { MOST_NODES = 32 };

/* Boxes as nodes of an asset, node i with the faces of id i + 1. */
typedef struct scene {
    test_env t;
    test_shape shape;
    dmi_asset_node nodes[MOST_NODES];
    uint32_t order[MOST_NODES], count;
    bool by_rules, without_names;
    dmi_mesh* mesh;
    dmi_arena arena;
    dmi_asset_models models;
    dmi_asset_bodies bodies;
} scene;

/* Adds a node that stays, or is a body that moves. */
static uint32_t add_box(scene* s, bool moves, const float low[3], const float high[3]) {
    test_shape_box(&s->shape, low, high, s->count + 1);
    s->nodes[s->count] = (dmi_asset_node){
        .name = "", .mesh_name = "", .parent = DMI_ASSET_BODY, .given_body = moves ? s->count : DMI_ASSET_BODY};
    s->order[s->count] = s->count;
    return s->count++;
}

#define STAYS DMI_ASSET_BODY /* stands for a node of what stays */

static scene* open_scene(void) {
    scene* s = calloc(1, sizeof *s);
    assert_non_null(s);
    test_env_open(&s->t, TEST_NEVER);
    dmi_arena_init(&s->arena, &s->t.env, 1 << 16);
    assert_int_equal(dmi_asset_models_load(&s->t.env, dmi_asset_weights, dmi_asset_weights_size, &s->models), DM_OK);
    return s;
}

static void close_scene(scene* s) {
    dmi_mesh_destroy(&s->t.env, s->mesh);
    dmi_arena_release(&s->arena);
    dmi_asset_models_release(&s->models);
    test_env_close(&s->t);
    free(s);
}

static dm_result find(scene* s) {
    dmi_axes axes;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    const dm_mesh_desc desc = test_shape_desc(&s->shape);
    dmi_mesh_destroy(&s->t.env, s->mesh);
    s->mesh = NULL;
    const dm_result result = dmi_mesh_create_numbered(&s->t.env, &axes, &desc, s->count, NULL, &s->mesh);
    if (result != DM_OK) return result;
    const dmi_asset_query query = {.mesh = s->mesh,
                                   .nodes = s->nodes,
                                   .order = s->order,
                                   .node_count = s->count,
                                   .use_names = !s->without_names,
                                   .models = s->by_rules ? NULL : &s->models,
                                   .min_moves = 0.9f,
                                   .arena = &s->arena};
    return dmi_asset_find_bodies(&s->t.env, &query, &s->bodies);
}

/* Returns whether the node's body is carried by the other node's; STAYS: by what stays. */
static bool is_carried_by(const scene* s, uint32_t node, uint32_t other) {
    const uint32_t body = s->bodies.body_of_node[node];
    assert_int_not_equal(body, DMI_ASSET_BODY);
    return s->bodies.bodies[body].carrier == (other == STAYS ? DMI_ASSET_BODY : s->bodies.body_of_node[other]);
}

/* ---- things that people know ---- */

/* A cupboard of five boards, 1 wide, 2 high, .5 deep, its front open. */
static void add_cupboard(scene* s) {
    add_box(s, false, (const float[]){0, 0, 0}, (const float[]){0.02f, 2, 0.5f});
    add_box(s, false, (const float[]){0.98f, 0, 0}, (const float[]){1, 2, 0.5f});
    add_box(s, false, (const float[]){0.02f, 0, 0}, (const float[]){0.98f, 0.02f, 0.5f});
    add_box(s, false, (const float[]){0.02f, 1.98f, 0}, (const float[]){0.98f, 2, 0.5f});
    add_box(s, false, (const float[]){0.02f, 0.02f, 0}, (const float[]){0.98f, 1.98f, 0.02f});
}

static void check_knob(bool by_rules) {
    scene* s = open_scene();
    s->by_rules = by_rules;
    add_cupboard(s);
    const uint32_t door = add_box(s, true, (const float[]){0, 0, 0.502f}, (const float[]){1, 2, 0.52f});
    const uint32_t knob = add_box(s, true, (const float[]){0.9f, 0.95f, 0.52f}, (const float[]){0.94f, 0.99f, 0.56f});
    assert_int_equal(find(s), DM_OK);
    assert_true(is_carried_by(s, knob, door));
    assert_true(is_carried_by(s, door, STAYS));
    close_scene(s);
}

static void a_knob_hangs_on_its_door(void** state) {
    (void)state;
    check_knob(false);
}

static void without_models_rules_answer(void** state) {
    (void)state;
    check_knob(true);
}

/* The leaves touch each other along their whole height, and the posts by two hinges each. */
static void leaves_do_not_hang_on_each_other(void** state) {
    (void)state;
    scene* s = open_scene();
    add_box(s, false, (const float[]){0, 0, 0}, (const float[]){0.05f, 2, 0.05f});
    add_box(s, false, (const float[]){1.15f, 0, 0}, (const float[]){1.2f, 2, 0.05f});
    add_box(s, false, (const float[]){0, 2, 0}, (const float[]){1.2f, 2.05f, 0.05f});
    for (int i = 0; i < 4; i++) {
        const float x = i & 1 ? 1.1f : 0.05f, y = i & 2 ? 1.6f : 0.3f;
        add_box(s, false, (const float[]){x, y, 0.01f}, (const float[]){x + 0.05f, y + 0.1f, 0.04f});
    }
    const uint32_t left = add_box(s, true, (const float[]){0.1f, 0, 0.005f}, (const float[]){0.59f, 1.95f, 0.045f});
    const uint32_t right = add_box(s, true, (const float[]){0.592f, 0, 0.005f}, (const float[]){1.1f, 1.95f, 0.045f});
    assert_int_equal(find(s), DM_OK);
    assert_true(is_carried_by(s, left, STAYS));
    assert_true(is_carried_by(s, right, STAYS));
    s->by_rules = true;
    assert_int_equal(find(s), DM_OK);
    assert_true(is_carried_by(s, left, right)); /* which the rules take for one that hangs on the other */
    close_scene(s);
}

static void drawers_hang_on_their_cabinet(void** state) {
    (void)state;
    scene* s = open_scene();
    uint32_t drawers[4];
    add_cupboard(s);
    for (uint32_t i = 0; i < 4; i++) {
        const float low = 0.03f + 0.49f * (float)i;
        drawers[i] = add_box(s, true, (const float[]){0.025f, low, 0.05f}, (const float[]){0.975f, low + 0.48f, 0.5f});
    }
    assert_int_equal(find(s), DM_OK);
    for (uint32_t i = 0; i < 4; i++) assert_true(is_carried_by(s, drawers[i], STAYS));
    close_scene(s);
}

/* Four panels of a folding door, each beside the one before. */
static void folding_panels_are_a_chain(void** state) {
    (void)state;
    scene* s = open_scene();
    uint32_t last = STAYS;
    add_box(s, false, (const float[]){0, 0, 0}, (const float[]){0.1f, 2, 0.1f});
    for (uint32_t i = 0; i < 4; i++) {
        const float low = 0.1f + 0.5f * (float)i;
        const uint32_t panel = add_box(s, true, (const float[]){low, 0, 0}, (const float[]){low + 0.5f, 2, 0.04f});
        assert_int_equal(find(s), DM_OK);
        assert_true(is_carried_by(s, panel, last));
        last = panel;
    }
    close_scene(s);
}

/* ---- what the asset says ---- */

/* The tree counts where a body is given, and is not read without names. */
static void a_given_body_hangs_where_its_tree_says(void** state) {
    (void)state;
    scene* s = open_scene();
    add_cupboard(s);
    const uint32_t left = add_box(s, true, (const float[]){0, 0, 0.502f}, (const float[]){0.499f, 2, 0.52f});
    const uint32_t right = add_box(s, true, (const float[]){0.501f, 0, 0.502f}, (const float[]){1, 2, 0.52f});
    s->nodes[right].parent = left;
    assert_int_equal(find(s), DM_OK);
    assert_true(is_carried_by(s, right, left));
    s->without_names = true;
    assert_int_equal(find(s), DM_OK);
    assert_true(is_carried_by(s, right, STAYS));
    close_scene(s);
}

/* ---- orders and limits ---- */

/* Boxes in a ring, all alike: whatever carries what, it ends at what stays. */
static void nothing_carries_itself(void** state) {
    (void)state;
    scene* s = open_scene();
    for (uint32_t i = 0; i < 9; i++) {
        const float x = (float)(i % 3), y = (float)(i / 3);
        add_box(s, i != 4, (const float[]){x, y, 0}, (const float[]){x + 1, y + 1, 1});
    }
    assert_int_equal(find(s), DM_OK);
    assert_int_equal(s->bodies.count, 8);
    for (uint32_t b = 0; b < s->bodies.count; b++) {
        uint32_t at = b, steps = 0;
        while (at != DMI_ASSET_BODY && steps++ <= s->bodies.count) at = s->bodies.bodies[at].carrier;
        assert_int_equal(at, DMI_ASSET_BODY);
    }
    close_scene(s);
}

static void equal_assets_get_equal_answers(void** state) {
    (void)state;
    dmi_asset_body first[4];
    scene* s = open_scene();
    add_cupboard(s);
    add_box(s, true, (const float[]){0, 0, 0.502f}, (const float[]){0.499f, 2, 0.52f});
    add_box(s, true, (const float[]){0.501f, 0, 0.502f}, (const float[]){1, 2, 0.52f});
    add_box(s, true, (const float[]){0.46f, 0.95f, 0.52f}, (const float[]){0.48f, 0.99f, 0.56f});
    add_box(s, true, (const float[]){0.52f, 0.95f, 0.52f}, (const float[]){0.54f, 0.99f, 0.56f});
    assert_int_equal(find(s), DM_OK);
    assert_int_equal(s->bodies.count, 4);
    memcpy(first, s->bodies.bodies, sizeof first);
    assert_int_equal(find(s), DM_OK);
    assert_memory_equal(s->bodies.bodies, first, sizeof first);
    close_scene(s);
}

/* An asset of which nothing stays has no contact with it either. */
static void all_may_move(void** state) {
    (void)state;
    scene* s = open_scene();
    const uint32_t base = add_box(s, true, (const float[]){0, 0, 0}, (const float[]){1, 0.2f, 1});
    const uint32_t top = add_box(s, true, (const float[]){0.4f, 0.2f, 0.4f}, (const float[]){0.6f, 0.4f, 0.6f});
    assert_int_equal(find(s), DM_OK);
    assert_false(is_carried_by(s, base, top) && is_carried_by(s, top, base));
    close_scene(s);
}

static void failing_memory_leaves_nothing(void** state) {
    (void)state;
    for (int64_t fail_at = 0;; fail_at++) {
        scene* s = open_scene();
        add_cupboard(s);
        add_box(s, true, (const float[]){0, 0, 0.502f}, (const float[]){1, 2, 0.52f});
        add_box(s, true, (const float[]){0.9f, 0.95f, 0.52f}, (const float[]){0.94f, 0.99f, 0.56f});
        s->t.memory.fail_at = s->t.memory.calls + fail_at;
        const dm_result result = find(s);
        s->t.memory.fail_at = TEST_NEVER;
        close_scene(s);
        if (result == DM_OK) break;
        assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        assert_true(fail_at < 1000);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_knob_hangs_on_its_door),
        cmocka_unit_test(without_models_rules_answer),
        cmocka_unit_test(leaves_do_not_hang_on_each_other),
        cmocka_unit_test(drawers_hang_on_their_cabinet),
        cmocka_unit_test(folding_panels_are_a_chain),
        cmocka_unit_test(a_given_body_hangs_where_its_tree_says),
        cmocka_unit_test(nothing_carries_itself),
        cmocka_unit_test(equal_assets_get_equal_answers),
        cmocka_unit_test(all_may_move),
        cmocka_unit_test(failing_memory_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
