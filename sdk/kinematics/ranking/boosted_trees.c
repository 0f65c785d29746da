/* Reads boosted trees, and walks rows of features down them side by side. */
#include "kinematics/ranking/ranker.h"

#include <math.h>

#define BATCH 16 /* rows at a time, because each waits for its own memory; measured */

/* A tree's nodes as the file has them. A leaf has column -1, and its value is a score. */
typedef struct raw_tree {
    const float *column, *value;
} raw_tree;

/* Reads and checks a tree. Returns whether the nodes form one. Nodes lie level by level: the two children of a split
 * come after those of the splits before it, so every path ends in a leaf. */
static int read_tree(const raw_tree* raw, dmi_tree_node* nodes, float* scores, uint32_t* out_depth) {
    uint32_t depth[DMI_TREE_NODES] = {0}, left = 1;
    *out_depth = 0;
    for (uint32_t n = 0; n < DMI_TREE_NODES; n++) {
        const float column = raw->column[n], value = raw->value[n];
        if (!isfinite(value)) return 0;
        if (column == -1) {
            nodes[n] = (dmi_tree_node){.value = INFINITY, .left = (uint8_t)n};
            scores[n] = value;
            continue;
        }
        if (!(column >= 0 && column < DMI_FEATURE_COUNT && column == (float)(uint8_t)column) || left <= n ||
            left >= DMI_TREE_NODES - 1)
            return 0;
        nodes[n] = (dmi_tree_node){.value = value, .column = (uint8_t)column, .left = (uint8_t)left};
        scores[n] = 0;
        *out_depth = depth[left] = depth[left + 1] = depth[n] + 1;
        left += 2;
    }
    return 1;
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
