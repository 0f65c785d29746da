/* The shape of a wide tree, and a tree from a shape. Only what can't be computed is stored, so that no shape makes a
 * tree that reads elsewhere, loops, or lacks a triangle: boxes and corners come from the triangles themselves. */
#include <math.h>
#include <string.h>

#include "base/env.h"
#include "pick/lanes.h"
#include "pick/wide_tree.h"

typedef struct restoring {
    const dmi_triangles* triangles;
    const dmi_tree_shape* shape;
    dmi_wide_tree* tree;
    uint8_t* level;         /* level of each node, from 1; 0: no node above it is known */
    uint8_t* seen;          /* per triangle: it is in a block */
    uint32_t blocks, faces; /* so far */
} restoring;

dmi_tree_shape dmi_wide_tree_shape(const dmi_wide_tree* tree) {
    return (dmi_tree_shape){.child = tree->nodes->child,
                            .face = tree->blocks->face,
                            .child_step = sizeof *tree->nodes / sizeof(uint32_t),
                            .face_step = sizeof *tree->blocks / sizeof(uint32_t),
                            .node_count = tree->node_count,
                            .block_count = tree->block_count};
}

/* ---- checks ---- */

/* Takes the next block, in whose order leaves are met. Each triangle is in one block once. */
static bool restore_block(restoring* r, uint32_t index) {
    if (index != r->blocks || index >= r->shape->block_count) return false;
    const uint32_t* face = r->shape->face + index * r->shape->face_step;
    dmi_triangle_block* block = &r->tree->blocks[r->blocks++];
    for (uint32_t i = 0; i < DMI_BLOCK; i++) {
        const bool used = i == 0 || face[i] != face[0];
        if (face[i] >= r->triangles->face_count || (used && r->seen[face[i]])) return false;
        if (used) r->seen[face[i]] = 1;
        r->faces += used;
        dmi_block_set(r->triangles, block, i, face[i], used);
    }
    return true;
}

/* A node below another comes after it and below no other one: no way through the tree loops, or is longer than the
 * stack of a ray is deep. */
static bool check_child(const restoring* r, uint32_t node, uint32_t child) {
    if (child <= node || child >= r->shape->node_count || r->level[child] != 0) return false;
    r->level[child] = (uint8_t)(r->level[node] + 1);
    return r->level[child] <= DMI_MOST_LEVELS;
}

static bool restore_references(restoring* r) {
    r->level[0] = 1;
    for (uint32_t n = 0; n < r->shape->node_count; n++) {
        const uint32_t* child = r->shape->child + n * r->shape->child_step;
        if (r->level[n] == 0) return false;
        for (uint32_t i = 0; i < DMI_WIDE; i++) {
            const bool good = child[i] == 0 || (child[i] & DMI_LEAF ? restore_block(r, child[i] & ~DMI_LEAF)
                                                                    : check_child(r, n, child[i]));
            if (!good) return false;
            r->tree->nodes[n].child[i] = child[i];
        }
    }
    return r->blocks == r->shape->block_count && r->faces == r->triangles->face_count;
}

/* ---- boxes ---- */

/* Returns the least, or the most, of four numbers. */
static float least_of(dmi_lanes lanes) {
    float x[4];
    dmi_lanes_store(x, lanes);
    const float a = x[1] < x[0] ? x[1] : x[0], b = x[3] < x[2] ? x[3] : x[2];
    return b < a ? b : a;
}

static float most_of(dmi_lanes lanes) {
    float x[4];
    dmi_lanes_store(x, lanes);
    const float a = x[1] > x[0] ? x[1] : x[0], b = x[3] > x[2] ? x[3] : x[2];
    return b > a ? b : a;
}

static dmi_box block_box(const dmi_triangle_block* block) {
    dmi_box box = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        const dmi_lanes a = dmi_lanes_load(block->corner[0][k]), b = dmi_lanes_load(block->corner[1][k]),
                        c = dmi_lanes_load(block->corner[2][k]);
        box.low[k] = least_of(dmi_lanes_min(dmi_lanes_min(a, b), c));
        box.high[k] = most_of(dmi_lanes_max(dmi_lanes_max(a, b), c));
    }
    return box;
}

static dmi_box node_box(const dmi_wide_node* node) {
    dmi_box box = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        const float *low = node->planes[k], *high = node->planes[3 + k];
        box.low[k] = least_of(dmi_lanes_min(dmi_lanes_load(low), dmi_lanes_load(low + DMI_WIDE / 2)));
        box.high[k] = most_of(dmi_lanes_max(dmi_lanes_load(high), dmi_lanes_load(high + DMI_WIDE / 2)));
    }
    return box;
}

/* Measures the boxes from the last node to the root, because what is below a node comes after it. */
static void measure_boxes(dmi_wide_tree* tree) {
    static const dmi_box inside_out = {{INFINITY, INFINITY, INFINITY, 0}, {-INFINITY, -INFINITY, -INFINITY, 0}};
    for (uint32_t n = tree->node_count; n-- > 0;) {
        dmi_wide_node* node = &tree->nodes[n];
        for (uint32_t i = 0; i < DMI_WIDE; i++) {
            const uint32_t child = node->child[i];
            const dmi_box box = child == 0         ? inside_out
                                : child & DMI_LEAF ? block_box(&tree->blocks[child & ~DMI_LEAF])
                                                   : node_box(&tree->nodes[child]);
            dmi_wide_node_set_box(node, i, &box);
        }
    }
}

/* ---- the whole ---- */

static bool restore(dmi_env* env, restoring* r, bool* out_room) {
    const size_t nodes = r->shape->node_count, faces = r->triangles->face_count;
    r->level = dmi_scratch_alloc(env, nodes + faces);
    *out_room = r->level != NULL;
    if (!*out_room) return false;
    memset(r->level, 0, nodes + faces);
    r->seen = r->level + nodes;
    const bool good = restore_references(r);
    if (good) measure_boxes(r->tree);
    dmi_scratch_free(env, r->level);
    return good;
}

dm_result dmi_wide_tree_restore(dmi_env* env, const dmi_triangles* triangles, const dmi_tree_shape* shape,
                                dmi_wide_tree* out_tree) {
    const uint32_t faces = triangles->face_count;
    /* A block has a triangle or more, and of nodes there are no more than blocks. */
    if (shape->node_count == 0 || shape->block_count > faces || shape->node_count > shape->block_count)
        return DM_ERROR_BAD_DATA;
    bool room = dmi_wide_tree_allocate(env, shape->node_count, shape->block_count, out_tree);
    restoring r = {.triangles = triangles, .shape = shape, .tree = out_tree};
    const bool allocated = room;
    if (room && restore(env, &r, &room)) return DM_OK;
    if (allocated) dmi_wide_tree_release(env, out_tree);
    if (room) return DM_ERROR_BAD_DATA;
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick among %u triangles", faces);
}
