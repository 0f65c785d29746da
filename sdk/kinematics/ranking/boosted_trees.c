/* Reads a forest, and walks rows of evidence down its trees side by side. */
#include "kinematics/ranking/boosted_trees.h"

#include <math.h>

#define SIDE 16 /* rows at a time: each waits for its own memory */

/* A tree's nodes as the file has them: column -1 for leaves, then the value is a score. */
typedef struct raw_tree {
    const float *column, *value;
} raw_tree;

/* Nodes lie level by level: a fork's two go after those of the forks before it, so that every way down ends. */
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
        if (!(column >= 0 && column < DMI_FEATURE_COUNT && column == floorf(column)) || left <= n ||
            left >= DMI_TREE_NODES - 1)
            return 0;
        nodes[n] = (dmi_tree_node){.value = value, .column = (uint8_t)column, .left = (uint8_t)left};
        scores[n] = 0;
        *out_depth = depth[left] = depth[left + 1] = depth[n] + 1;
        left += 2;
    }
    return 1;
}

dm_result dmi_boosted_trees_read(dmi_env* env, const dmi_weights* weights, dmi_boosted_trees* out_forest) {
    enum { NODES = DMI_TREES * DMI_TREE_NODES };
    const size_t bytes = 2 * sizeof(float) * NODES;
    float* raw = dmi_alloc(env, bytes, _Alignof(float));
    if (raw == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "forest: no memory for %zu bytes", bytes);
    int whole = dmi_weights_read(weights, "forest.column", DMI_TREES, DMI_TREE_NODES, raw) &&
                dmi_weights_read(weights, "forest.value", DMI_TREES, DMI_TREE_NODES, raw + NODES);
    for (uint32_t t = 0; whole && t < DMI_TREES; t++) {
        const float* first = raw + (size_t)t * DMI_TREE_NODES;
        const raw_tree tree = {.column = first, .value = first + NODES};
        whole = read_tree(&tree, out_forest->nodes[t], out_forest->scores[t], &out_forest->depth[t]);
    }
    dmi_free(env, raw, bytes);
    return whole ? DM_OK
                 : dmi_fail(env, DM_ERROR_WRONG_MODEL, "forest: a tensor is missing, or is no forest of %d trees",
                            DMI_TREES);
}

/* Not less-or-equal: what is no number goes left, and so stays in a leaf. */
static inline uint32_t step(const dmi_tree_node* nodes, uint32_t node, const float* row) {
    return nodes[node].left + (uint32_t)(row[nodes[node].column] > nodes[node].value);
}

static void score_rows(const dmi_boosted_trees* forest, const float (*rows)[DMI_FEATURE_COUNT], uint32_t count,
                       float* out_scores) {
    for (uint32_t r = 0; r < count; r++) out_scores[r] = 0;
    for (uint32_t t = 0; t < DMI_TREES; t++) {
        uint32_t at[SIDE] = {0};
        for (uint32_t d = 0; d < forest->depth[t]; d++)
            for (uint32_t r = 0; r < count; r++) at[r] = step(forest->nodes[t], at[r], rows[r]);
        for (uint32_t r = 0; r < count; r++) out_scores[r] += forest->scores[t][at[r]];
    }
}

void dmi_boosted_trees_score(const dmi_boosted_trees* forest, const float (*evidence)[DMI_FEATURE_COUNT],
                             uint32_t count, float* out_scores) {
    uint32_t first = 0;
    for (; first + SIDE <= count; first += SIDE) score_rows(forest, evidence + first, SIDE, out_scores + first);
    if (first < count) score_rows(forest, evidence + first, count - first, out_scores + first);
}
