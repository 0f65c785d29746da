/* Boosted trees score what a plain walk down them says; a file that holds no trees is refused. */
#include "test_env.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "kinematics/ranking/ranker.h"
#include "test_world.h"

enum { NODES = DMI_TREES * DMI_TREE_NODES, TENSORS = 2, ROWS = 37 };

static dmi_boosted_trees boosted;
static float rows[ROWS][DMI_FEATURE_COUNT], scores[ROWS];

/* Trees as a weights file has them. */
typedef struct trees {
    float column[NODES], value[NODES];
} trees;
static trees made;

/* The first tree forks at column 5 and, to the right of it, at column 201; the others are one leaf that says nothing.
 */
static void two_forks(void) {
    memset(&made, 0, sizeof made);
    for (int n = 0; n < NODES; n++) made.column[n] = -1;
    made.column[0] = 5, made.value[0] = 0.5f;
    made.value[1] = 10;
    made.column[2] = 201, made.value[2] = -1;
    made.value[3] = 20, made.value[4] = 30;
}

/* The bytes of a weights file around `made`. */
static unsigned char* file_of_trees(size_t* out_size) {
    static const char* names[TENSORS] = {"column", "value"};
    char header[1024];
    size_t bytes = sizeof(float) * NODES, at = 0;
    int length = snprintf(header, sizeof header,
                          "{\"__metadata__\":{\"architecture\":\"dragmesh-joint-models\",\"version\":\"1\"}");
    for (int i = 0; i < TENSORS; i++, at += bytes)
        length += snprintf(header + length, sizeof header - (size_t)length,
                           ",\"trees.%s\":{\"dtype\":\"F32\",\"shape\":[%d,%d],\"data_offsets\":[%zu,%zu]}", names[i],
                           DMI_TREES, DMI_TREE_NODES, at, at + bytes);
    header[length++] = '}';
    unsigned char* file = calloc(1, 8 + (size_t)length + sizeof made);
    assert_non_null(file);
    file[0] = (unsigned char)(length & 255), file[1] = (unsigned char)(length >> 8);
    memcpy(file + 8, header, (size_t)length);
    memcpy(file + 8 + length, &made, sizeof made);
    *out_size = 8 + (size_t)length + sizeof made;
    return file;
}

static void read_trees(dmi_loader* loader, void* trees) {
    dmi_boosted_trees_read(loader, trees);
}

static dm_result read_bytes(test_env* t, const void* bytes, size_t size) {
    dmi_arena keep;
    dmi_arena_init(&keep, &t->env, 4096);
    const dm_result result =
        dmi_load_network(&t->env, bytes, size, "dragmesh-joint-models", read_trees, &boosted, &keep);
    dmi_arena_release(&keep);
    return result;
}

static dm_result read_made(test_env* t) {
    size_t size;
    unsigned char* file = file_of_trees(&size);
    const dm_result result = read_bytes(t, file, size);
    free(file);
    return result;
}

static void rows_go_down_to_their_leaves(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    two_forks();
    assert_int_equal(read_made(&t), DM_OK);
    for (int r = 0; r < ROWS; r++) rows[r][5] = r % 3 == 0 ? 0.5f : 0.6f, rows[r][201] = r % 3 == 1 ? -1 : 0;
    dmi_boosted_trees_score(&boosted, (const float(*)[DMI_FEATURE_COUNT])rows, ROWS, scores);
    for (int r = 0; r < ROWS; r++) assert_true(scores[r] == (r % 3 == 0 ? 10 : r % 3 == 1 ? 20 : 30));
    test_env_close(&t);
}

/* The last trees correct the scores where there is a drag, and there alone. */
static void trees_of_drags_count_with_a_drag(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    two_forks();
    made.value[(DMI_TREES - DMI_DRAG_TREES - 1) * DMI_TREE_NODES] = 100;
    made.value[(DMI_TREES - DMI_DRAG_TREES) * DMI_TREE_NODES] = 1;
    made.value[(DMI_TREES - 1) * DMI_TREE_NODES] = 2;
    assert_int_equal(read_made(&t), DM_OK);
    for (int drag = 0; drag < 2; drag++) {
        memset(rows, 0, sizeof rows);
        for (int r = 0; r < ROWS; r++) rows[r][DMI_FEATURE_HAS_DRAG] = (float)drag;
        dmi_boosted_trees_score(&boosted, (const float(*)[DMI_FEATURE_COUNT])rows, ROWS, scores);
        for (int r = 0; r < ROWS; r++) assert_true(scores[r] == (drag ? 113 : 110));
    }
    test_env_close(&t);
}

static void what_is_no_number_still_ends_in_a_leaf(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    two_forks();
    assert_int_equal(read_made(&t), DM_OK);
    for (int k = 0; k < DMI_FEATURE_COUNT; k++) rows[0][k] = NAN, rows[1][k] = INFINITY, rows[2][k] = -INFINITY;
    dmi_boosted_trees_score(&boosted, (const float(*)[DMI_FEATURE_COUNT])rows, 3, scores);
    assert_true(scores[0] == 10 && scores[1] == 30 && scores[2] == 10);
    test_env_close(&t);
}

/* Each makes one number of the two forks what no tree has. */
static void what_is_no_tree_is_refused(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    float* const numbers[] = {&made.column[0], &made.column[0], &made.column[2],
                              &made.column[0], &made.value[0],  &made.value[1]};
    const float wrong[] = {DMI_FEATURE_COUNT, 0.5f, -2, NAN, INFINITY, NAN};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        two_forks();
        *numbers[i] = wrong[i];
        assert_int_equal(read_made(&t), isfinite(wrong[i]) ? DM_ERROR_WRONG_MODEL : DM_ERROR_BAD_DATA);
    }
    two_forks();
    made.column[0] = -1; /* the fork at 2 hangs on nothing, and its own would be 1 and 2 */
    assert_int_equal(read_made(&t), DM_ERROR_WRONG_MODEL);
    two_forks();
    for (int n = 0; n < DMI_TREE_NODES / 2; n++) made.column[n] = 0;
    assert_int_equal(read_made(&t), DM_OK);
    made.column[DMI_TREE_NODES / 2] = 0; /* no room for what it forks to */
    assert_int_equal(read_made(&t), DM_ERROR_WRONG_MODEL);
    test_env_close(&t);
}

static float walk(const trees* from, int tree, const float* row) {
    const float* column = from->column + (size_t)tree * DMI_TREE_NODES;
    const float* value = from->value + (size_t)tree * DMI_TREE_NODES;
    int n = 0;
    while (column[n] >= 0) {
        int forks = 0;
        for (int before = 0; before < n; before++) forks += column[before] >= 0;
        n = 1 + 2 * forks + (row[(int)column[n]] > value[n]);
    }
    return value[n];
}

/* Side by side and one by one: the same bits. */
static void the_shipped_trees_say_what_a_plain_walk_says(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    size_t size;
    void* bytes = test_read_file("sdk/models/ranker.safetensors", &size);
    dmi_weights* weights;
    assert_int_equal(read_bytes(&t, bytes, size), DM_OK);
    assert_int_equal(dmi_weights_open(&t.env, bytes, size, "dragmesh-joint-models", 1, &weights), DM_OK);
    assert_true(dmi_weights_read(weights, "trees.column", DMI_TREES, DMI_TREE_NODES, made.column, NULL));
    assert_true(dmi_weights_read(weights, "trees.value", DMI_TREES, DMI_TREE_NODES, made.value, NULL));
    dmi_weights_close(weights);
    free(bytes);
    dmi_random random = dmi_random_make(7, 1);
    for (int drag = 0; drag < 2; drag++) {
        for (int r = 0; r < ROWS; r++) {
            for (int k = 0; k < DMI_FEATURE_COUNT; k++) rows[r][k] = dmi_random_normal(&random);
            rows[r][DMI_FEATURE_HAS_DRAG] = (float)drag;
        }
        dmi_boosted_trees_score(&boosted, (const float(*)[DMI_FEATURE_COUNT])rows, ROWS, scores);
        for (int r = 0; r < ROWS; r++) {
            float sum = 0;
            for (int tree = 0; tree < DMI_TREES - (drag ? 0 : DMI_DRAG_TREES); tree++)
                sum += walk(&made, tree, rows[r]);
            assert_true(sum == scores[r]);
            assert_true(r == 0 || scores[r] != scores[0]);
        }
    }
    test_env_close(&t);
}

/* However many rows: a whole number of batches, one more, one less. */
static void any_number_of_rows_scores_alike(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    two_forks();
    assert_int_equal(read_made(&t), DM_OK);
    memset(rows, 0, sizeof rows);
    for (int r = 0; r < ROWS; r++) rows[r][5] = r % 3 == 0 ? 0.5f : 0.6f, rows[r][201] = r % 3 == 1 ? -1 : 0;
    for (uint32_t count = 0; count <= ROWS; count++) {
        for (int r = 0; r < ROWS; r++) scores[r] = -7;
        dmi_boosted_trees_score(&boosted, (const float(*)[DMI_FEATURE_COUNT])rows, count, scores);
        for (uint32_t r = 0; r < ROWS; r++)
            assert_true(scores[r] == (r >= count ? -7 : r % 3 == 0 ? 10 : r % 3 == 1 ? 20 : 30));
    }
    test_env_close(&t);
}

/* The last columns and nodes that a tree may have, and the first that it may not; what is left of the next tree. */
static void trees_end_where_they_say(void** state) {
    (void)state;
    enum { LAST = DMI_TREES - 1 };
    test_env t;
    test_env_open(&t, TEST_NEVER);
    memset(rows, 0, sizeof rows);
    rows[0][DMI_FEATURE_HAS_DRAG] = 1;
    for (int tree = 0; tree < DMI_TREES; tree += LAST) {
        float* const column = made.column + tree * DMI_TREE_NODES;
        float* const value = made.value + tree * DMI_TREE_NODES;
        two_forks();
        made.value[1] = made.value[3] = made.value[4] = 0;
        for (int n = 0; n < 5; n++) column[n] = -1;
        column[0] = DMI_FEATURE_COUNT - 1, column[2] = 0; /* 1 and 2 below it; 3 and 4 below 2 */
        value[0] = 0.5f, value[2] = 0.5f, value[1] = 1, value[3] = 2, value[4] = 4;
        assert_int_equal(read_made(&t), DM_OK);
        for (int way = 0; way < 4; way++) {
            rows[0][DMI_FEATURE_COUNT - 1] = (float)(way & 1), rows[0][0] = (float)(way >> 1);
            dmi_boosted_trees_score(&boosted, (const float(*)[DMI_FEATURE_COUNT])rows, 1, scores);
            assert_true(scores[0] == (way & 1 ? (way & 2 ? 4 : 2) : 1));
        }
        column[1] = DMI_FEATURE_COUNT - 1;
        assert_int_equal(read_made(&t), DM_OK);
        column[1] = DMI_FEATURE_COUNT;
        assert_int_equal(read_made(&t), DM_ERROR_WRONG_MODEL);
        char says[32];
        snprintf(says, sizeof says, "tree %d is none", tree);
        assert_non_null(strstr(t.messages.text, says));
    }
    /* A chain: each split's right child splits again, 127 deep. The walk goes all the way. */
    two_forks();
    made.column[2] = -1, made.value[1] = made.value[3] = made.value[4] = 0;
    for (int n = 0; n < DMI_TREE_NODES - 1; n += 2) made.column[n] = 1, made.value[n] = (float)n;
    for (int n = 1; n < DMI_TREE_NODES; n += 2) made.value[n] = (float)-n;
    made.value[DMI_TREE_NODES - 1] = 9;
    assert_int_equal(read_made(&t), DM_OK);
    for (int n = 0; n < DMI_TREE_NODES; n++) {
        rows[0][1] = (float)n - 0.5f;
        dmi_boosted_trees_score(&boosted, (const float(*)[DMI_FEATURE_COUNT])rows, 1, scores);
        const int split = n / 2 * 2 + (n % 2 ? 2 : 0); /* the first whose value is not exceeded */
        assert_true(scores[0] == (split >= DMI_TREE_NODES - 1 ? 9 : (float)-(split + 1)));
    }
    test_env_close(&t);
}

static void no_memory_is_no_wrong_model(void** state) {
    (void)state;
    test_env starved;
    two_forks();
    test_env_open(&starved, 1); /* the header's block, then none for the tensors */
    assert_int_equal(read_made(&starved), DM_ERROR_OUT_OF_MEMORY);
    test_env_close(&starved);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_go_down_to_their_leaves),
        cmocka_unit_test(trees_of_drags_count_with_a_drag),
        cmocka_unit_test(what_is_no_number_still_ends_in_a_leaf),
        cmocka_unit_test(what_is_no_tree_is_refused),
        cmocka_unit_test(the_shipped_trees_say_what_a_plain_walk_says),
        cmocka_unit_test(any_number_of_rows_scores_alike),
        cmocka_unit_test(trees_end_where_they_say),
        cmocka_unit_test(no_memory_is_no_wrong_model),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
