/* Grouping of an asset's nodes: which are one body, which bodies move, what carries them, and that the order of faces
 * and nodes does not count. */
#include "test_env.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "assets/asset_grouping.h"
#include "assets/asset_models.h"
#include "assets/merge_tree.h"
#include "assets/node_cells.h"
#include "assets/set_features.h"
#include "mesh/mesh.h"
#include "test_shapes.h"

enum { MOST_NODES = 32 };

/* Boxes as nodes of an asset, node i with the faces of id i + 1. */
typedef struct scene {
    test_env t;
    test_shape shape;
    dmi_asset_node nodes[MOST_NODES];
    uint32_t order[MOST_NODES], count;
    dmi_mesh* mesh;
    dmi_arena arena;
    dmi_asset_models models;
    dmi_asset_bodies bodies;
} scene;

static uint32_t add_node(scene* s, const char* name, uint32_t parent) {
    s->nodes[s->count] =
        (dmi_asset_node){.name = name, .mesh_name = "", .parent = parent, .given_body = DMI_ASSET_BODY};
    s->order[s->count] = s->count;
    return s->count++;
}

static uint32_t add_box(scene* s, const char* name, const float low[3], const float high[3]) {
    test_shape_box(&s->shape, low, high, s->count + 1);
    return add_node(s, name, DMI_ASSET_BODY);
}

/* A wardrobe 1 wide, 2 high, .6 deep of five boards with the front open, its door of three nodes. */
enum { LEFT, RIGHT, BOTTOM, TOP, BACK, PANEL, GLASS, HANDLE, WARDROBE_NODES };

static void add_wardrobe(scene* s) {
    add_box(s, "", (const float[]){0, 0, 0}, (const float[]){0.02f, 2, 0.6f});
    add_box(s, "", (const float[]){0.98f, 0, 0}, (const float[]){1, 2, 0.6f});
    add_box(s, "", (const float[]){0.02f, 0, 0}, (const float[]){0.98f, 0.02f, 0.6f});
    add_box(s, "", (const float[]){0.02f, 1.98f, 0}, (const float[]){0.98f, 2, 0.6f});
    add_box(s, "", (const float[]){0.02f, 0.02f, 0}, (const float[]){0.98f, 1.98f, 0.02f});
    add_box(s, "", (const float[]){0, 0, 0.605f}, (const float[]){1, 2, 0.625f});
    add_box(s, "", (const float[]){0.2f, 0.5f, 0.625f}, (const float[]){0.8f, 1.7f, 0.63f});
    add_box(s, "", (const float[]){0.9f, 0.9f, 0.625f}, (const float[]){0.92f, 1.1f, 0.66f});
}

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

static dm_result group(scene* s) {
    dmi_axes axes;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    const dm_mesh_desc desc = test_shape_desc(&s->shape);
    dmi_mesh_destroy(&s->t.env, s->mesh);
    assert_int_equal(dmi_mesh_create_numbered(&s->t.env, &axes, &desc, s->count, NULL, &s->mesh), DM_OK);
    const dmi_asset_query query = {.mesh = s->mesh,
                                   .nodes = s->nodes,
                                   .order = s->order,
                                   .node_count = s->count,
                                   .use_names = true,
                                   .models = &s->models,
                                   .min_moves = 0.5f,
                                   .arena = &s->arena};
    return dmi_asset_find_bodies(&s->t.env, &query, &s->bodies);
}

static uint32_t body_of(const scene* s, uint32_t node) {
    return s->bodies.body_of_node[node];
}

/* ---- what is measured ---- */

typedef struct measures {
    float opening[DMI_OPENING_FEATURES], standing[DMI_STANDING_FEATURES];
} measures;

/* Measures what the set of one node would open, and how it stands. */
static void measure_set(scene* s, uint32_t node, measures* out) {
    assert_int_equal(group(s), DM_OK);
    uint32_t of_part[MOST_NODES + 1];
    dmi_node_cells cells;
    dmi_node_labels labels;
    dmi_asset_facts facts;
    dmi_node_set set;
    dmi_set_way ways[DMI_GRID_SIDES];
    for (uint32_t p = 0; p < s->mesh->part_count; p++) of_part[p] = p == 0 ? UINT32_MAX : p - 1;
    assert_int_equal(dmi_node_labels_make(&s->arena, s->nodes, s->count, s->order, s->count, false, &labels), DM_OK);
    assert_int_equal(dmi_node_cells_make(&s->arena, s->mesh, of_part, s->count, NULL, &cells), DM_OK);
    assert_int_equal(dmi_asset_facts_make(&s->arena, &cells, &labels, &facts), DM_OK);
    assert_int_equal(dmi_node_set_make(&s->arena, &cells, &node, 1, UINT32_MAX, &set), DM_OK);
    dmi_measure_ways(&set, UINT32_MAX, cells.exposed[node], ways);
    dmi_row opening = {out->opening, 0}, standing = {out->standing, 0};
    dmi_put_openings(&opening, &set, &facts, ways, &node);
    dmi_put_standing(&standing, &set, &facts, ways);
    assert_int_equal(opening.count, DMI_OPENING_FEATURES);
    assert_int_equal(standing.count, DMI_STANDING_FEATURES);
}

static void measure_opening(scene* s, uint32_t node, float row[DMI_OPENING_FEATURES]) {
    measures m;
    measure_set(s, node, &m);
    memcpy(row, m.opening, sizeof m.opening);
}

/* A chest 1 wide whose lid lies `gap` above it, a knob on top. Returns the lid. */
static uint32_t add_chest(scene* s, float gap) {
    const float low = 0.5f + gap;
    add_box(s, "", (const float[]){0, 0, 0}, (const float[]){0.02f, 0.5f, 1});
    add_box(s, "", (const float[]){0.98f, 0, 0}, (const float[]){1, 0.5f, 1});
    add_box(s, "", (const float[]){0.02f, 0, 0}, (const float[]){0.98f, 0.02f, 1});
    const uint32_t lid = add_box(s, "", (const float[]){0, low, 0}, (const float[]){1, low + 0.05f, 1});
    add_box(s, "", (const float[]){0.48f, low + 0.05f, 0.48f}, (const float[]){0.52f, low + 0.09f, 0.52f});
    return lid;
}

static void a_lid_has_clearance(void** state) {
    (void)state;
    float apart[DMI_OPENING_FEATURES], flush[DMI_OPENING_FEATURES];
    scene* s = open_scene();
    measure_opening(s, add_chest(s, 0.004f), apart);
    close_scene(s);
    s = open_scene();
    measure_opening(s, add_chest(s, 0), flush);
    close_scene(s);
    assert_true(fabsf(apart[DMI_OPENING_CLEARANCE] - 0.004f) < 0.002f);
    assert_true(apart[DMI_OPENING_CLEARANCE + 2] > 0.5f && flush[DMI_OPENING_CLEARANCE + 2] == 0);
    assert_true(flush[DMI_OPENING_DEPENDANTS] == 1); /* the knob */
}

/* A drawer leaves the object to the front, and behind it is its carcass. */
static void a_drawer_has_room_ahead(void** state) {
    (void)state;
    float row[DMI_OPENING_FEATURES];
    scene* s = open_scene();
    add_box(s, "", (const float[]){0, 0, 0}, (const float[]){0.02f, 0.3f, 1});
    add_box(s, "", (const float[]){0.98f, 0, 0}, (const float[]){1, 0.3f, 1});
    add_box(s, "", (const float[]){0.02f, 0, 0}, (const float[]){0.98f, 0.02f, 1});
    add_box(s, "", (const float[]){0.02f, 0.28f, 0}, (const float[]){0.98f, 0.3f, 1});
    add_box(s, "", (const float[]){0.02f, 0.02f, 0}, (const float[]){0.98f, 0.28f, 0.02f});
    const uint32_t drawer = add_box(s, "", (const float[]){0.03f, 0.03f, 0.3f}, (const float[]){0.97f, 0.27f, 1});
    measure_opening(s, drawer, row);
    const float* way = row + DMI_OPENING_WAYS;
    assert_true(way[0] > 0.99f && way[2] < 0.1f); /* ahead all of it leaves; behind, it meets the back … */
    assert_true(way[3] > 0.28f && way[3] < 1);    /* … which is as far from it as its own depth, or less */
    assert_true(way[4] > 0.7f && way[4] < 1 && way[5] < 0.01f); /* it covers most of the front, and is level with it */
    close_scene(s);
}

/* A leaf beside one post hangs on a line, about which it turns freely. */
static void a_leaf_hangs_on_its_post(void** state) {
    (void)state;
    float row[DMI_OPENING_FEATURES];
    scene* s = open_scene();
    add_box(s, "", (const float[]){0, 0, 0}, (const float[]){0.05f, 2, 0.05f});
    const uint32_t leaf = add_box(s, "", (const float[]){0.052f, 0, 0.01f}, (const float[]){1, 2, 0.04f});
    measure_opening(s, leaf, row);
    assert_true(row[DMI_OPENING_HANG] < 0.1f && row[DMI_OPENING_HANG + 1] > 0.2f);
    for (int turn = 2; turn < 6; turn++) assert_true(row[DMI_OPENING_HANG + turn] < 0.06f);
    assert_true(fabsf(row[DMI_OPENING_HANG + 6] - 0.25f) < 0.05f); /* half its width, by its height */
    close_scene(s);
}

/* Adds a box whose axes are turned by `turn` thirds about the diagonal. */
static uint32_t add_turned(scene* s, int turn, const float low[3], const float high[3]) {
    float turned_low[3], turned_high[3];
    for (int k = 0; k < 3; k++) turned_low[(k + turn) % 3] = low[k], turned_high[(k + turn) % 3] = high[k];
    return add_box(s, "", turned_low, turned_high);
}

/* An open laptop stands on its base, and its screen does not, whichever axis is up. */
static void a_laptop_stands_on_its_base(void** state) {
    (void)state;
    for (int turn = 0; turn < 3; turn++) {
        measures base, screen;
        scene* s = open_scene();
        const uint32_t low = add_turned(s, turn, (const float[]){0, 0, 0}, (const float[]){1, 0.05f, 0.7f});
        const uint32_t high = add_turned(s, turn, (const float[]){0, 0.06f, 0.05f}, (const float[]){1, 0.7f, 0.09f});
        measure_set(s, low, &base);
        measure_set(s, high, &screen);
        const float *stands = base.standing + DMI_STANDING_GROUND, *leans = screen.standing + DMI_STANDING_GROUND;
        assert_true(stands[0] > 0.9f);                      /* the ground is full … */
        assert_true(stands[2] > 0.99f && leans[2] < 0.01f); /* … of the base */
        assert_true(stands[3] < 0.01f && leans[3] > 0.99f);
        const float *under = base.standing + DMI_STANDING_PLACE, *over = screen.standing + DMI_STANDING_PLACE;
        assert_true(under[0] < 0.01f && under[1] < 0.1f && over[0] > 0.05f && over[1] > 0.95f);
        assert_true(screen.standing[DMI_STANDING_WAYS] == 0);    /* it leaves the base upwards … */
        assert_true(screen.standing[DMI_STANDING_WAYS + 3] > 0); /* … and not downwards */
        assert_true(base.standing[DMI_STANDING_COVER] > 0.9f && screen.standing[DMI_STANDING_COVER + 1] > 0.9f);
        for (int i = 1; i < DMI_GRID_SIDES; i++)
            assert_true(screen.standing[DMI_STANDING_SHARES + i] <= screen.standing[DMI_STANDING_SHARES + i - 1]);
        close_scene(s);
    }
}

/* ---- what is found ---- */

static void nodes_of_a_door_are_one_body(void** state) {
    (void)state;
    scene* s = open_scene();
    add_wardrobe(s);
    assert_int_equal(group(s), DM_OK);
    for (uint32_t n = LEFT; n <= BACK; n++) assert_int_equal(body_of(s, n), DMI_ASSET_BODY);
    assert_int_not_equal(body_of(s, PANEL), DMI_ASSET_BODY);
    assert_int_equal(body_of(s, GLASS), body_of(s, PANEL));
    assert_int_equal(body_of(s, HANDLE), body_of(s, PANEL));
    assert_int_equal(s->bodies.count, 1);
    assert_true(s->bodies.bodies[0].moves >= 0.5f && s->bodies.bodies[0].moves <= 1);
    close_scene(s);
}

static void a_single_node_stays(void** state) {
    (void)state;
    scene* s = open_scene();
    add_box(s, "door", (const float[]){0, 0, 0}, (const float[]){1, 2, 0.1f});
    assert_int_equal(group(s), DM_OK);
    assert_int_equal(s->bodies.count, 0);
    assert_int_equal(body_of(s, 0), DMI_ASSET_BODY);
    close_scene(s);
}

/* ---- what is stated ---- */

/* Returns the highest probability by which a set of the asset is rated. */
static float rate(scene* s) {
    uint32_t of_part[MOST_NODES + 1];
    dmi_node_cells cells;
    dmi_node_labels labels;
    dmi_merge_tree tree;
    dmi_set_ratings r;
    float best = 0;
    for (uint32_t p = 0; p < s->mesh->part_count; p++) of_part[p] = p == 0 ? UINT32_MAX : p - 1;
    assert_int_equal(dmi_node_labels_make(&s->arena, s->nodes, s->count, s->order, s->count, true, &labels), DM_OK);
    assert_int_equal(dmi_node_cells_make(&s->arena, s->mesh, of_part, s->count, NULL, &cells), DM_OK);
    assert_int_equal(dmi_merge_tree_make(&s->arena, &cells, &labels, &s->models, NULL, &tree), DM_OK);
    assert_int_equal(dmi_set_ratings_make(&s->arena, &tree, &s->models, DMI_CONTEXT_ROUNDS, NULL, &r), DM_OK);
    for (uint32_t i = 0; i < tree.set_count; i++) best = dmi_fmaxf(best, r.moves[i]);
    return best;
}

/* Groups, and returns the highest probability that is stated. */
static float state_highest(scene* s) {
    float best = 0;
    assert_int_equal(group(s), DM_OK);
    for (uint32_t b = 0; b < s->bodies.count; b++) best = dmi_fmaxf(best, s->bodies.bodies[b].moves);
    return best;
}

/* A shelf of `count` books. */
static void add_shelf(scene* s, int count) {
    add_wardrobe(s);
    s->count = PANEL, s->shape.face_count = PANEL * 12; /* its door is left out */
    add_box(s, "", (const float[]){0.02f, 1, 0.02f}, (const float[]){0.98f, 1.02f, 0.6f});
    for (int i = 0; i < count; i++) {
        const float x = 0.1f + 0.1f * (float)i;
        add_box(s, "", (const float[]){x, 0.02f, 0.1f}, (const float[]){x + 0.08f, 0.4f, 0.4f});
    }
}

/* A slab with a panel before it, `gap` away and `inset` smaller on each side. */
static void add_panel(scene* s, float gap, float inset) {
    add_box(s, "", (const float[]){0, 0, 0}, (const float[]){1, 1, 1});
    add_box(s, "", (const float[]){inset, inset, 1 + gap}, (const float[]){1 - inset, 1 - inset, 1.02f + gap});
}

/* A slab, a smaller one and a post on each other. */
static void add_monument(scene* s, float post) {
    add_box(s, "", (const float[]){0, 0, 0}, (const float[]){1, 0.3f, 1});
    add_box(s, "", (const float[]){0.1f, 0.3f, 0.1f}, (const float[]){0.9f, 0.6f, 0.9f});
    add_box(s, "", (const float[]){0.25f, 0.6f, 0.25f}, (const float[]){0.75f, 0.6f + post, 0.75f});
}

enum { SCENES = 18 };

static void add_scene(scene* s, int i) {
    if (i < 6)
        add_shelf(s, i + 1);
    else if (i < 12)
        add_monument(s, 0.2f * (float)(i - 5));
    else
        add_panel(s, i % 2 ? 0.004f : 0, 0.06f * (float)(i - 11));
}

/* What is less likely than .25 stays, and is stated as it is rated. From there on a body moves, and is stated as one
 * half or little more; from .5 on, as up to .08 more than it is rated. */
static void ratings_are_stated(void** state) {
    (void)state;
    int staying = 0, likely = 0, sure = 0;
    for (int i = 0; i < SCENES; i++) {
        scene* s = open_scene();
        add_scene(s, i);
        const float stated = state_highest(s), rated = rate(s);
        if (rated >= 0.5f)
            sure++, assert_true(fabsf(stated - (0.58f + 0.84f * (rated - 0.5f))) < 1e-5f);
        else if (rated >= 0.25f)
            likely++, assert_true(fabsf(stated - (0.5f + 0.32f * (rated - 0.25f))) < 1e-5f);
        else
            staying += stated == rated, assert_true(stated <= rated); /* the body itself is not listed */
        close_scene(s);
    }
    assert_true(staying > 0 && likely > 0 && sure > 0);
}

/* ---- what the asset says ---- */

/* A node that is stated to move is a body alone, whatever it looks like. */
static void given_nodes_are_one_body(void** state) {
    (void)state;
    scene* s = open_scene();
    add_wardrobe(s);
    s->nodes[LEFT].given_body = s->nodes[BOTTOM].given_body = 7;
    assert_int_equal(group(s), DM_OK);
    const uint32_t body = body_of(s, LEFT);
    assert_int_not_equal(body, DMI_ASSET_BODY);
    assert_int_equal(body_of(s, BOTTOM), body);
    assert_true(s->bodies.bodies[body].moves == 1);
    for (uint32_t n = 0; n < WARDROBE_NODES; n++)
        if (n != LEFT && n != BOTTOM) assert_int_not_equal(body_of(s, n), body);
    close_scene(s);
}

/* The parts of one unit lie at both ends of the asset: its box and its area are those of all. */
static void a_unit_is_as_large_as_all_its_nodes(void** state) {
    (void)state;
    scene* s = open_scene();
    add_box(s, "", (const float[]){0, 0, 0}, (const float[]){1, 1, 1});
    add_box(s, "", (const float[]){1, 0, 0}, (const float[]){2, 1, 1});
    add_box(s, "", (const float[]){2, 0, 0}, (const float[]){3, 1, 1});
    s->nodes[0].given_body = s->nodes[2].given_body = 1;
    assert_int_equal(group(s), DM_OK);
    const uint32_t of_part[] = {UINT32_MAX, 0, 1, 0};
    dmi_node_cells cells;
    assert_int_equal(dmi_node_cells_make(&s->arena, s->mesh, of_part, 2, NULL, &cells), DM_OK);
    assert_true(fabsf(cells.high_of[0][0] - cells.low_of[0][0] - 1) < 1e-6f);
    assert_true(fabsf(cells.area[0] - 2 * cells.area[1]) < 1e-5f);
    for (uint32_t i = 0; i < cells.first[2]; i++) {
        const int32_t x = (int32_t)cells.cells[i] % cells.size[0];
        assert_true(x > 0 && x < cells.size[0] - 1);
    }
    close_scene(s);
}

static void fixed_nodes_go_with_what_is_above(void** state) {
    (void)state;
    scene* s = open_scene();
    add_wardrobe(s);
    s->nodes[PANEL].given_body = 3;
    s->nodes[TOP].is_fixed = true;
    s->nodes[TOP].parent = PANEL;
    const uint32_t order[] = {LEFT, RIGHT, BOTTOM, BACK, PANEL, GLASS, HANDLE, TOP};
    memcpy(s->order, order, sizeof order);
    assert_int_equal(group(s), DM_OK);
    assert_int_equal(body_of(s, TOP), body_of(s, PANEL));
    close_scene(s);
}

static void a_group_is_of_the_body_below_it(void** state) {
    (void)state;
    scene* s = open_scene();
    add_wardrobe(s);
    const uint32_t hinge = add_node(s, "", DMI_ASSET_BODY), room = add_node(s, "", DMI_ASSET_BODY);
    for (uint32_t n = PANEL; n <= HANDLE; n++) s->nodes[n].parent = hinge, s->nodes[n].given_body = 1;
    s->nodes[LEFT].parent = s->nodes[hinge].parent = room;
    const uint32_t order[] = {room, hinge, LEFT, RIGHT, BOTTOM, TOP, BACK, PANEL, GLASS, HANDLE};
    memcpy(s->order, order, sizeof order);
    assert_int_equal(group(s), DM_OK);
    assert_int_equal(body_of(s, hinge), body_of(s, PANEL));
    assert_int_equal(body_of(s, room), DMI_ASSET_BODY);
    close_scene(s);
}

static void a_part_on_a_part_is_carried_by_it(void** state) {
    (void)state;
    scene* s = open_scene();
    add_wardrobe(s);
    s->nodes[PANEL].given_body = 1;
    s->nodes[GLASS].given_body = 1;
    s->nodes[HANDLE].given_body = 2;
    assert_int_equal(group(s), DM_OK);
    const uint32_t door = body_of(s, PANEL), handle = body_of(s, HANDLE);
    assert_int_equal(s->bodies.bodies[handle].carrier, door);
    assert_int_equal(s->bodies.bodies[door].carrier, DMI_ASSET_BODY);
    close_scene(s);
}

/* The second panel of a folding door touches the first one alone. A third thing lies on the second. */
static void panels_hang_on_each_other(void** state) {
    (void)state;
    scene* s = open_scene();
    const uint32_t post = add_box(s, "", (const float[]){0, 0, 0}, (const float[]){0.1f, 2, 0.1f});
    const uint32_t first = add_box(s, "", (const float[]){0.1f, 0, 0}, (const float[]){0.6f, 2, 0.04f});
    const uint32_t second = add_box(s, "", (const float[]){0.6f, 0, 0}, (const float[]){1.1f, 2, 0.04f});
    const uint32_t knob = add_box(s, "", (const float[]){1, 1, 0.04f}, (const float[]){1.05f, 1.05f, 0.1f});
    s->nodes[first].given_body = 1, s->nodes[second].given_body = 2, s->nodes[knob].given_body = 3;
    assert_int_equal(group(s), DM_OK);
    const dmi_asset_body* bodies = s->bodies.bodies;
    assert_int_equal(body_of(s, post), DMI_ASSET_BODY);
    assert_int_equal(bodies[body_of(s, first)].carrier, DMI_ASSET_BODY);
    assert_int_equal(bodies[body_of(s, second)].carrier, body_of(s, first));
    assert_int_equal(bodies[body_of(s, knob)].carrier, body_of(s, second));
    close_scene(s);
}

/* ---- orders ---- */

/* Turns the list of faces round, and the corners of each. */
static void reverse_faces(test_shape* shape) {
    for (uint32_t i = 0, k = shape->face_count; i < k--; i++) {
        uint32_t corners[3];
        memcpy(corners, shape->corners[i], sizeof corners);
        memcpy(shape->corners[i], shape->corners[k], sizeof corners);
        memcpy(shape->corners[k], corners, sizeof corners);
        const uint32_t part = shape->part[i];
        shape->part[i] = shape->part[k], shape->part[k] = part;
    }
    for (uint32_t f = 0; f < shape->face_count; f++) {
        const uint32_t first = shape->corners[f][0];
        shape->corners[f][0] = shape->corners[f][1];
        shape->corners[f][1] = shape->corners[f][2];
        shape->corners[f][2] = first;
    }
}

static void the_order_of_faces_does_not_count(void** state) {
    (void)state;
    scene* s = open_scene();
    add_wardrobe(s);
    assert_int_equal(group(s), DM_OK);
    uint32_t before[WARDROBE_NODES];
    memcpy(before, s->bodies.body_of_node, sizeof before);
    const float moves = s->bodies.bodies[0].moves;
    reverse_faces(&s->shape);
    assert_int_equal(group(s), DM_OK);
    assert_memory_equal(s->bodies.body_of_node, before, sizeof before);
    assert_true(fabsf(s->bodies.bodies[0].moves - moves) < 0.05f);
    close_scene(s);
}

/* ---- limits ---- */

static void failing_memory_leaves_nothing(void** state) {
    (void)state;
    for (int64_t fail_at = 0;; fail_at++) {
        scene* s = open_scene();
        add_wardrobe(s);
        s->t.memory.fail_at = s->t.memory.calls + fail_at;
        dmi_axes axes;
        assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
        const dm_mesh_desc desc = test_shape_desc(&s->shape);
        dm_result result = dmi_mesh_create_numbered(&s->t.env, &axes, &desc, s->count, NULL, &s->mesh);
        const dmi_asset_query query = {.mesh = s->mesh,
                                       .nodes = s->nodes,
                                       .order = s->order,
                                       .node_count = s->count,
                                       .models = &s->models,
                                       .min_moves = 0.5f,
                                       .arena = &s->arena};
        if (result == DM_OK) result = dmi_asset_find_bodies(&s->t.env, &query, &s->bodies);
        s->t.memory.fail_at = TEST_NEVER;
        close_scene(s);
        if (result == DM_OK) break;
        assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        assert_true(fail_at < 1000);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lid_has_clearance),
        cmocka_unit_test(a_drawer_has_room_ahead),
        cmocka_unit_test(a_leaf_hangs_on_its_post),
        cmocka_unit_test(a_laptop_stands_on_its_base),
        cmocka_unit_test(nodes_of_a_door_are_one_body),
        cmocka_unit_test(a_single_node_stays),
        cmocka_unit_test(ratings_are_stated),
        cmocka_unit_test(given_nodes_are_one_body),
        cmocka_unit_test(a_unit_is_as_large_as_all_its_nodes),
        cmocka_unit_test(fixed_nodes_go_with_what_is_above),
        cmocka_unit_test(a_group_is_of_the_body_below_it),
        cmocka_unit_test(a_part_on_a_part_is_carried_by_it),
        cmocka_unit_test(panels_hang_on_each_other),
        cmocka_unit_test(the_order_of_faces_does_not_count),
        cmocka_unit_test(failing_memory_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
