/* Which pivots of an asset's nodes follow one rule, and which of them break it. */
#include <math.h>
#include <string.h>

#include "test_env.h"

#include "mesh/pivot_rule.h"

typedef struct box {
    double low[3], high[3];
} box;

/* A body, a door on its front, a lid on its top and a knob on the door: no two of one shape. */
static const box cabinet[] = {{{0, 0, 0}, {2, 1, 1}},
                              {{0, 0, 1.01}, {1, 1, 1.05}},
                              {{0, 1.01, 0}, {2, 1.06, 1}},
                              {{0.9, 0.4, 1.05}, {0.92, 0.6, 1.07}}};
enum { BODY, DOOR, LID, KNOB, NODES };

/* Two faces on each side of the box. */
static dmi_pivot_witness measure(const box* b, const double pivot[3], const float axes[9]) {
    dmi_pivot_gauge gauge;
    dmi_pivot_gauge_begin(pivot, axes, &gauge);
    for (int side = 0; side < 6; side++) {
        const int k = side / 2, u = (k + 1) % 3, w = (k + 2) % 3;
        double corner[4][3];
        for (int c = 0; c < 4; c++) {
            corner[c][k] = side % 2 ? b->high[k] : b->low[k];
            corner[c][u] = c == 1 || c == 2 ? b->high[u] : b->low[u];
            corner[c][w] = c >= 2 ? b->high[w] : b->low[w];
        }
        for (int f = 0; f < 2; f++) {
            double face[3][3];
            for (int i = 0; i < 3; i++) memcpy(face[i], corner[i == 0 ? 0 : i + f], sizeof face[i]);
            if (side % 2 == 0) { /* fronts stay out */
                memcpy(face[1], corner[2 + f], sizeof face[1]);
                memcpy(face[2], corner[1 + f], sizeof face[2]);
            }
            dmi_pivot_gauge_add_face(&gauge, (const double(*)[3])face);
        }
    }
    return dmi_pivot_gauge_finish(&gauge);
}

/* shares: where in the box each pivot is, 0 the low end, 1 the high end. */
static dmi_pivot_witness put(const box* b, double x, double y, double z) {
    static const float none[9] = {0};
    const double share[3] = {x, y, z};
    double at[3];
    for (int k = 0; k < 3; k++) at[k] = b->low[k] + share[k] * (b->high[k] - b->low[k]);
    return measure(b, at, none);
}

static void assert_kinds(const dmi_pivot_witness nodes[NODES], const dmi_pivot_kind want[NODES]) {
    dmi_pivot_kind found[NODES];
    dmi_pivots_judge(nodes, NODES, found);
    for (int i = 0; i < NODES; i++)
        if (found[i] != want[i]) fail_msg("node %d is of kind %d, not %d", i, found[i], want[i]);
}

static void pivots_at_one_place_of_each_box_say_nothing(void** state) {
    (void)state;
    static const dmi_pivot_kind unset[NODES] = {DMI_PIVOT_UNSET, DMI_PIVOT_UNSET, DMI_PIVOT_UNSET, DMI_PIVOT_UNSET};
    for (int place = 0; place < DMI_BOX_PLACES; place++) {
        dmi_pivot_witness nodes[NODES];
        for (int i = 0; i < NODES; i++)
            nodes[i] = put(&cabinet[i], (place % 3) / 2.0, (place / 3 % 3) / 2.0, (place / 9) / 2.0);
        assert_kinds(nodes, unset);
    }
}

static void pivots_at_one_point_say_nothing(void** state) {
    (void)state;
    static const dmi_pivot_kind unset[NODES] = {DMI_PIVOT_UNSET, DMI_PIVOT_UNSET, DMI_PIVOT_UNSET, DMI_PIVOT_UNSET};
    static const double point[3] = {0.3, -4, 0.7};
    static const float none[9] = {0};
    dmi_pivot_witness nodes[NODES];
    for (int i = 0; i < NODES; i++) nodes[i] = measure(&cabinet[i], point, none);
    assert_kinds(nodes, unset);
}

static void a_pivot_that_breaks_the_rule_is_set(void** state) {
    (void)state;
    static const dmi_pivot_kind want[NODES] = {DMI_PIVOT_UNSET, DMI_PIVOT_SET, DMI_PIVOT_UNSET, DMI_PIVOT_UNSET};
    dmi_pivot_witness nodes[NODES];
    for (int i = 0; i < NODES; i++) nodes[i] = put(&cabinet[i], 0.5, 0.5, 0.5);
    nodes[DOOR] = put(&cabinet[DOOR], 0, 0.5, 0.5);
    assert_kinds(nodes, want);
}

/* Wheels have their pivots in their middle, whatever the body's is. */
static void without_the_body_there_is_no_rule(void** state) {
    (void)state;
    static const dmi_pivot_kind unjudged[NODES] = {DMI_PIVOT_UNJUDGED};
    dmi_pivot_witness nodes[NODES];
    for (int i = 0; i < NODES; i++) nodes[i] = put(&cabinet[i], 0.5, 0.5, 0.5);
    nodes[BODY] = put(&cabinet[BODY], 0.5, 0, 0.5);
    assert_kinds(nodes, unjudged);
    for (int i = LID; i < NODES; i++) nodes[i] = put(&cabinet[i], 0.1, 0.2, 0.3); /* one of four follows */
    nodes[BODY] = put(&cabinet[BODY], 0.5, 0.5, 0.5);
    nodes[DOOR] = put(&cabinet[DOOR], 0.2, 0.7, 0.3);
    assert_kinds(nodes, unjudged);
}

/* Two leaves of one mesh, each on its hinge. */
static void copies_of_one_mesh_are_one_witness(void** state) {
    (void)state;
    static const dmi_pivot_kind unjudged[NODES] = {DMI_PIVOT_UNJUDGED};
    dmi_pivot_witness nodes[NODES];
    for (int i = 0; i < NODES; i++) {
        const double scale = i + 1, at[3] = {2.0 * i, scale, 0.05 * scale};
        const float axes[9] = {(float)scale, 0, 0, 0, (float)scale, 0, 0, 0, (float)scale};
        const box leaf = {{2.0 * i, 0, 0}, {2.0 * i + scale, 2 * scale, 0.1 * scale}};
        nodes[i] = measure(&leaf, at, axes);
    }
    assert_kinds(nodes, unjudged);
}

/* The same in a node that is turned in the scene: its own box counts. */
static void a_turned_node_follows_by_its_own_box(void** state) {
    (void)state;
    const double s = sqrt(0.5), middle[3] = {0.5, 0.5, 1.03};
    const float axes[9] = {(float)s, (float)s, 0, (float)-s, (float)s, 0, 0, 0, 1};
    const dmi_pivot_witness along = measure(&cabinet[DOOR], middle, axes);
    const double corner[3] = {0.5, -0.5, 1.01}; /* the low corner of the box along these axes */
    const dmi_pivot_witness low = measure(&cabinet[DOOR], corner, axes);
    assert_true(along.rules & UINT64_C(1) << 13); /* the middle: place 1 of 3 in each coordinate */
    assert_true(low.rules & UINT64_C(1) << 0);
}

static void nodes_without_faces_do_not_count(void** state) {
    (void)state;
    static const double point[3] = {0, 0, 0};
    static const float none[9] = {0};
    dmi_pivot_gauge gauge;
    dmi_pivot_kind kind;
    dmi_pivot_gauge_begin(point, none, &gauge);
    const dmi_pivot_witness empty = dmi_pivot_gauge_finish(&gauge);
    assert_true(empty.area == 0);
    dmi_pivots_judge(&empty, 1, &kind);
    assert_int_equal(kind, DMI_PIVOT_UNJUDGED);
    dmi_pivots_judge(NULL, 0, NULL);
}

static void parts_alone_are_judged_by_each_other(void** state) {
    (void)state;
    static const box doors[] = {{{0, 0, 0}, {1, 2, 0.05}}, {{1, 0, 0}, {1.7, 1.6, 0.05}}, {{2, 0, 0}, {2.4, 1, 0.05}}};
    dmi_pivot_witness parts[NODES];
    for (int i = 0; i < NODES; i++) parts[i] = put(&cabinet[i], 0, 0, 0);
    assert_true(dmi_part_pivots_follow_rule(parts, NODES));
    assert_false(dmi_part_pivots_follow_rule(parts, 2)); /* two may be alike by chance */
    parts[LID] = put(&cabinet[LID], 0, 0.5, 0);
    assert_false(dmi_part_pivots_follow_rule(parts, NODES));
    for (int i = 0; i < 3; i++) parts[i] = put(&doors[i], 0, 0.5, 0.5);
    assert_true(dmi_part_pivots_follow_rule(parts, 3)); /* the middle of a side */
    for (int i = 0; i < 3; i++) parts[i] = put(&doors[i], 0, 0.5, 0);
    assert_false(dmi_part_pivots_follow_rule(parts, 3)); /* all are hinged on the left edge */
    for (int i = 0; i < NODES; i++) parts[i] = put(&cabinet[KNOB], 0.5, 0.5, 0.5);
    assert_false(dmi_part_pivots_follow_rule(parts, NODES)); /* four wheels of one size */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pivots_at_one_place_of_each_box_say_nothing),
        cmocka_unit_test(pivots_at_one_point_say_nothing),
        cmocka_unit_test(a_pivot_that_breaks_the_rule_is_set),
        cmocka_unit_test(without_the_body_there_is_no_rule),
        cmocka_unit_test(copies_of_one_mesh_are_one_witness),
        cmocka_unit_test(a_turned_node_follows_by_its_own_box),
        cmocka_unit_test(nodes_without_faces_do_not_count),
        cmocka_unit_test(parts_alone_are_judged_by_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
