/* The tree of a scene under random changes: every box lies in those above it, every leaf is reached once, and the
 * height stays small whatever the order of changes. */
#include "test_env.h"

#include <math.h>

#include "base/random.h"
#include "pick/top_tree.h"

enum { LEAVES = 400 };

typedef struct bench {
    test_env t;
    dmi_top_tree tree;
    uint32_t leaf[LEAVES];
    int there[LEAVES], placed;
    int seen[LEAVES];
} bench;

static void open_bench(bench* b) {
    *b = (bench){.placed = 0};
    test_env_open(&b->t, TEST_NEVER);
    dmi_top_tree_init(&b->tree, &b->t.env);
}

static void close_bench(bench* b) {
    dmi_top_tree_release(&b->tree);
    test_env_close(&b->t);
}

static void add_leaf(bench* b, int i, const dmi_box* box) {
    assert_int_equal(dmi_top_tree_add(&b->tree, &b->there[i], &b->leaf[i]), DM_OK);
    b->tree.leaves[b->leaf[i]].box = *box;
    b->there[i] = 1;
    b->placed++;
}

static int inside(const dmi_box* inner, const float low[3], const float high[3]) {
    for (int k = 0; k < 3; k++) {
        if (inner->low[k] < low[k] || inner->high[k] > high[k]) return 0;
    }
    return 1;
}

/* Checks what is below a reference, and returns its height. */
static uint32_t check_reference(bench* b, uint32_t reference, uint32_t parent, const float low[3],
                                const float high[3]) {
    if (reference & DMI_LEAF) {
        const dmi_top_leaf* leaf = &b->tree.leaves[reference & ~DMI_LEAF];
        assert_true(leaf->placed && leaf->parent == parent && inside(&leaf->box, low, high));
        b->seen[(const int*)dmi_top_tree_item(&b->tree, reference & ~DMI_LEAF)->part - b->there]++;
        return 0;
    }
    const dmi_top_node* node = &b->tree.nodes[reference];
    assert_true(node->parent == parent);
    assert_in_range(node->count, 2, DMI_WIDE);
    uint32_t height = 0;
    for (uint32_t i = 0; i < DMI_WIDE; i++) {
        if (i >= node->count) {
            assert_true(node->wide.planes[0][i] == INFINITY && node->wide.planes[3][i] == -INFINITY);
            continue;
        }
        float child_low[3], child_high[3];
        for (int k = 0; k < 3; k++) {
            child_low[k] = node->wide.planes[k][i];
            child_high[k] = node->wide.planes[3 + k][i];
            assert_true(child_low[k] >= low[k] && child_high[k] <= high[k]);
        }
        const uint32_t below = check_reference(b, node->wide.child[i], reference, child_low, child_high);
        height = below > height ? below : height;
    }
    return height + 1;
}

/* Returns the tree's height. */
static uint32_t check_tree(bench* b) {
    static const float low[3] = {-INFINITY, -INFINITY, -INFINITY}, high[3] = {INFINITY, INFINITY, INFINITY};
    uint32_t height = 0;
    memset(b->seen, 0, sizeof b->seen);
    if (b->tree.root != DMI_TOP_NONE) height = check_reference(b, b->tree.root, DMI_TOP_NONE, low, high);
    for (int i = 0; i < LEAVES; i++) assert_int_equal(b->seen[i], b->there[i]);
    assert_int_equal(b->tree.placed_count, b->placed);
    assert_true(height <= b->tree.levels);
    return height;
}

static dmi_box random_box(dmi_random* random) {
    dmi_box box = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        box.low[k] = 100 * dmi_random_unit(random);
        box.high[k] = box.low[k] + 3 * dmi_random_unit(random);
    }
    return box;
}

static void change(bench* b, int i, dmi_random* random) {
    const dmi_box box = random_box(random);
    const uint32_t what = dmi_random_u32(random) % 3;
    if (!b->there[i]) {
        add_leaf(b, i, &box);
        dmi_top_tree_place(&b->tree, b->leaf[i]);
    } else if (what == 0) {
        dmi_top_tree_remove(&b->tree, b->leaf[i]);
        b->there[i] = 0;
        b->placed--;
    } else {
        b->tree.leaves[b->leaf[i]].box = box;
        dmi_top_tree_place(&b->tree, b->leaf[i]);
    }
}

static void random_changes_keep_the_tree_whole(void** state) {
    (void)state;
    bench b;
    open_bench(&b);
    dmi_random random = dmi_random_make(1, 2);
    for (int step = 0; step < 20000; step++) {
        change(&b, (int)(dmi_random_u32(&random) % LEAVES), &random);
        if (step % 5000 == 4999) dmi_top_tree_rebuild(&b.tree);
        if (step % 97 == 0 || step < 200) assert_in_range(check_tree(&b), 0, 12);
    }
    for (int i = 0; i < LEAVES; i++) {
        if (b.there[i]) dmi_top_tree_remove(&b.tree, b.leaf[i]);
        b.placed -= b.there[i];
        b.there[i] = 0;
        check_tree(&b);
    }
    assert_true(b.tree.root == DMI_TOP_NONE);
    close_bench(&b);
}

/* In a row, in a row with doubling gaps, and all in one place: what makes a list of a careless tree. */
static void sorted_insertions_keep_the_tree_low(void** state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        bench b;
        open_bench(&b);
        for (int i = 0; i < LEAVES; i++) {
            const float at = kind == 0 ? (float)i : kind == 1 ? powf(1.2f, (float)i) : 0;
            const dmi_box box = {{at, 0, 0, 0}, {at + 0.5f, 1, 1, 0}};
            add_leaf(&b, i, &box);
            dmi_top_tree_place(&b.tree, b.leaf[i]);
            dmi_top_tree_settle(&b.tree);
            assert_in_range(check_tree(&b), 0, 20);
        }
        close_bench(&b);
    }
}

static void a_rebuilt_tree_has_the_same_leaves(void** state) {
    (void)state;
    for (int count = 0; count < LEAVES; count = 2 * count + 1) {
        bench b;
        open_bench(&b);
        dmi_random random = dmi_random_make(3, (uint64_t)count);
        for (int i = 0; i < count; i++) {
            const dmi_box box = random_box(&random);
            add_leaf(&b, i, &box);
            b.tree.leaves[b.leaf[i]].placed = true;
        }
        dmi_top_tree_rebuild(&b.tree);
        assert_in_range(check_tree(&b), 0, 10);
        for (int i = 0; i < LEAVES; i++) change(&b, i, &random); /* nodes are free again, and as many as needed */
        check_tree(&b);
        close_bench(&b);
    }
}

/* Close together or all over the tree, into an empty tree or a full one: what waits is placed like anything else. */
static void waiting_leaves_are_placed_together(void** state) {
    (void)state;
    for (int before = 0; before < 200; before = 3 * before + 1) {
        for (int spread = 0; spread < 3; spread++) {
            bench b;
            open_bench(&b);
            dmi_random random = dmi_random_make(9, (uint64_t)before);
            for (int i = 0; i < before; i++) change(&b, i, &random);
            for (int i = before; i < LEAVES;) {
                const int first = i;
                for (; i < first + 60 && i < LEAVES; i++) {
                    dmi_box box = random_box(&random);
                    for (int k = 0; k < 3 && spread < 2; k++) {
                        const float low = spread == 0 ? 50 : (float)(i / 20);
                        box.low[k] = low + 0.02f * box.low[k];
                        box.high[k] = box.low[k] + 0.5f;
                    }
                    add_leaf(&b, i, &box);
                }
                for (int k = first; k < i; k++) dmi_top_tree_wait(&b.tree, b.leaf[k]);
                dmi_top_tree_place_waiting(&b.tree);
                dmi_top_tree_settle(&b.tree);
                assert_in_range(check_tree(&b), 0, 16);
            }
            for (int i = 0; i < LEAVES; i++) change(&b, i, &random);
            check_tree(&b);
            close_bench(&b);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_changes_keep_the_tree_whole),
        cmocka_unit_test(sorted_insertions_keep_the_tree_low),
        cmocka_unit_test(a_rebuilt_tree_has_the_same_leaves),
        cmocka_unit_test(waiting_leaves_are_placed_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
