/* Reads boosted trees, and walks rows of features down them side by side. */
#include "kinematics/ranking/ranker.h"

#include <math.h>
#include <string.h>

#define BATCH 16 /* rows at a time, because each waits for its own memory; measured */

/* A tree's nodes as the file has them. A leaf has column -1, and its value is a score. */
typedef struct raw_tree {
    const float *column, *value;
} raw_tree;

/* Converts the columns of a tree's nodes. Returns whether all are columns or leaves, and all values are numbers. */
static bool read_columns(const raw_tree* raw, int32_t out_columns[DMI_TREE_NODES]) {
    uint32_t bad = 0;
    for (uint32_t n = 0; n < DMI_TREE_NODES; n++) {
        const float above = raw->column[n] > -1 ? raw->column[n] : -1;
        const float held = above < DMI_FEATURE_COUNT - 1 ? above : DMI_FEATURE_COUNT - 1;
        out_columns[n] = (int32_t)held;
        bad |= (uint32_t)((float)out_columns[n] != raw->column[n]) | (uint32_t) !(fabsf(raw->value[n]) < INFINITY);
    }
    return bad == 0;
}

/* Returns a where all bits of the mask are set, b where none is. */
static float choose(uint32_t mask, float a, float b) {
    uint32_t bits[2];
    memcpy(&bits[0], &a, sizeof a);
    memcpy(&bits[1], &b, sizeof b);
    bits[0] = (bits[0] & mask) | (bits[1] & ~mask);
    memcpy(&a, &bits[0], sizeof a);
    return a;
}

/* Reads and checks a tree. Returns whether the nodes form one. Nodes lie level by level: the two children of a split
 * come after those of the splits before it, so every path ends in a leaf. No branch asks whether a node is a leaf: no
 * processor would foresee it. */
static bool read_tree(const raw_tree* raw, dmi_tree_node* nodes, float* scores, uint32_t* out_depth) {
    int32_t columns[DMI_TREE_NODES];
    uint32_t left = 1, bad = 0, deepest = 0;
    uint32_t level = 1, level_end = 1; /* levels of nodes so far, and the first node of the next */
    if (!read_columns(raw, columns)) return false;
    for (uint32_t n = 0; n < DMI_TREE_NODES; n++) {
        if (n == level_end) {
            level_end = left;
            level++;
        }
        const uint32_t leaf = 0u - (uint32_t)(columns[n] < 0), split = ~leaf; /* all bits, or none */
        bad |= split & ((uint32_t)(left <= n) | (uint32_t)(left >= DMI_TREE_NODES - 1));
        nodes[n].value = choose(leaf, INFINITY, raw->value[n]);
        nodes[n].column = (uint8_t)((uint32_t)columns[n] & split);
        nodes[n].left = (uint8_t)((n & leaf) | (left & split));
        scores[n] = choose(leaf, raw->value[n], 0);
        deepest = (deepest & leaf) | (level & split);
        left += 2 & split;
        left = left < DMI_TREE_NODES ? left : DMI_TREE_NODES;
    }
    *out_depth = deepest;
    return bad == 0;
}

void dmi_boosted_trees_read(dmi_loader* loader, dmi_boosted_trees* out_trees) {
    const float* column = dmi_load_tensor(loader, "trees.column", DMI_TREES, DMI_TREE_NODES);
    const float* value = dmi_load_tensor(loader, "trees.value", DMI_TREES, DMI_TREE_NODES);
    for (uint32_t t = 0; loader->result == DM_OK && t < DMI_TREES; t++) {
        const size_t first = (size_t)t * DMI_TREE_NODES;
        const raw_tree tree = {.column = column + first, .value = value + first};
        if (!read_tree(&tree, out_trees->nodes[t], out_trees->scores[t], &out_trees->depth[t]))
            loader->result =
                dmi_fail(loader->env, DM_ERROR_WRONG_MODEL, "trees.column and trees.value: tree %u is none", t);
    }
}

/* Returns the next node. It compares with >, not <=, so that a NaN goes left and stays in a leaf. */
static inline uint32_t next_node(const dmi_tree_node* nodes, uint32_t node, const float* row) {
    return nodes[node].left + (uint32_t)(row[nodes[node].column] > nodes[node].value);
}

static void score_rows(const dmi_boosted_trees* trees, const float (*rows)[DMI_FEATURE_COUNT], uint32_t count,
                       float* out_scores) {
    const uint32_t used = rows[0][DMI_FEATURE_HAS_DRAG] > 0 ? DMI_TREES : DMI_TREES - DMI_DRAG_TREES;
    for (uint32_t r = 0; r < count; r++) out_scores[r] = 0;
    for (uint32_t t = 0; t < used; t++) {
        uint32_t at[BATCH] = {0};
        for (uint32_t d = 0; d < trees->depth[t]; d++)
            for (uint32_t r = 0; r < count; r++) at[r] = next_node(trees->nodes[t], at[r], rows[r]);
        for (uint32_t r = 0; r < count; r++) out_scores[r] += trees->scores[t][at[r]];
    }
}

void dmi_boosted_trees_score(const dmi_boosted_trees* trees, const float (*features)[DMI_FEATURE_COUNT], uint32_t count,
                             float* out_scores) {
    uint32_t first = 0;
    for (; first + BATCH <= count; first += BATCH) score_rows(trees, features + first, BATCH, out_scores + first);
    if (first < count) score_rows(trees, features + first, count - first, out_scores + first);
}
