/* The tree of nodes: who carries whom, which of them the scene shows, and where they are in it. */
#include "mesh/gltf/gltf_tree.h"

static void multiply(const double a[16], const double b[16], double out[16]) {
    for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int k = 0; k < 4; k++) sum += a[4 * k + row] * b[4 * column + k];
            out[4 * column + row] = sum;
        }
    }
}

static dm_result read_parents(dm_gltf* gltf) {
    for (uint32_t i = 0; i < gltf->tree_count; i++) gltf->parents[i] = -1;
    for (uint32_t i = 0; i < gltf->tree_count; i++) {
        dmi_tiny_node node;
        dmi_tiny_get_node(gltf->tiny, i, &node);
        for (uint32_t c = 0; c < node.child_count; c++) {
            const int child = node.children[c];
            if (child < 0 || (uint32_t)child >= gltf->tree_count)
                return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "glTF: node %u has child %d, the file has %u nodes", i,
                                child, gltf->tree_count);
            if (gltf->parents[child] >= 0 || (uint32_t)child == i)
                return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "glTF: node %d is a child of node %u and of node %d",
                                child, i, gltf->parents[child]);
            gltf->parents[child] = (int32_t)i;
        }
    }
    return DM_OK;
}

/* Appends a root, once (its world's last number tells). A listed node that another one carries comes with that one. */
static void enter_root(dm_gltf* gltf, uint32_t node) {
    double* entered = gltf->worlds + 16 * (size_t)node + 15;
    if (gltf->parents[node] >= 0 || *entered != 0) return;
    *entered = 1;
    gltf->order[gltf->order_count++] = node;
}

static dm_result enter_roots(dm_gltf* gltf) {
    uint32_t count;
    const int* roots = dmi_tiny_scene_roots(gltf->tiny, &count);
    for (uint32_t i = 0; i < count; i++) {
        if (roots[i] < 0 || (uint32_t)roots[i] >= gltf->tree_count)
            return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "glTF: the scene lists node %d, the file has %u nodes",
                            roots[i], gltf->tree_count);
        enter_root(gltf, (uint32_t)roots[i]);
    }
    for (uint32_t i = 0; count == 0 && i < gltf->tree_count; i++) enter_root(gltf, i);
    return DM_OK;
}

dm_result dmi_gltf_read_tree(dm_gltf* gltf) {
    gltf->tree_count = dmi_tiny_node_count(gltf->tiny);
    gltf->parents = dmi_alloc(&gltf->env, gltf->tree_count * sizeof *gltf->parents, 16);
    gltf->order = dmi_alloc(&gltf->env, gltf->tree_count * sizeof *gltf->order, 16);
    gltf->worlds = dmi_alloc_zeroed(&gltf->env, gltf->tree_count * 16 * sizeof *gltf->worlds, 16);
    if (!gltf->parents || !gltf->order || !gltf->worlds)
        return dmi_fail(&gltf->env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u nodes", gltf->tree_count);
    dm_result result = read_parents(gltf);
    if (result == DM_OK) result = enter_roots(gltf);
    if (result != DM_OK) return result;
    /* Every node has one parent at most, so the walk from the roots meets it once: a cycle has no root. */
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        const uint32_t index = gltf->order[at];
        double* world = gltf->worlds + 16 * (size_t)index;
        dmi_tiny_node node;
        dmi_tiny_get_node(gltf->tiny, index, &node);
        if (gltf->parents[index] < 0)
            for (int i = 0; i < 16; i++) world[i] = node.matrix[i];
        else
            multiply(gltf->worlds + 16 * (size_t)gltf->parents[index], node.matrix, world);
        for (uint32_t c = 0; c < node.child_count; c++) gltf->order[gltf->order_count++] = (uint32_t)node.children[c];
    }
    return DM_OK;
}
