/* A tree of boxes that change: a box is moved, put in or taken out in the time of one way through the tree. */
#ifndef DMI_PICK_TOP_TREE_H
#define DMI_PICK_TOP_TREE_H

#include <stdbool.h>

#include "base/compiler.h"
#include "base/env.h"
#include "pick/box_split.h"

#define DMI_TOP_NONE 0xffffffffu
#define DMI_TOP_FIRST 8u  /* leaves at first; doubles when full */
#define DMI_TOP_CHUNKS 30 /* chunks of items: the first leaves, and one each time they double */
/* Numbers of a 3x4 matrix, column-major, and one more, so that code may compute four rows at once. Likewise the fourth
 * number of points and directions: what it holds does not count. */
#define DMI_MATRIX 13
/* Levels of nodes of a settled tree. The builder halves ranges from DMI_TOP_FREE_LEVELS on; the rest is for those of
 * 2^32 leaves and for growth. */
#define DMI_TOP_FREE_LEVELS 16 /* levels to spare; by hand: scenes of 100,000 parts take up to 9 */
#define DMI_TOP_MOST_LEVELS (DMI_TOP_FREE_LEVELS + 32 + 16)

typedef struct dmi_top_node {
    dmi_wide_node wide;
    uint32_t count;  /* number of children in use, which come first; 2 or more */
    uint32_t parent; /* index; DMI_TOP_NONE for the root. For a free node: the next free one */
} dmi_top_node;

typedef struct dmi_top_leaf {
    dmi_box box;
    /* Node above a placed leaf, or DMI_TOP_NONE when it is the root. A free leaf holds the next free one here. */
    uint32_t parent;
    bool placed; /* the leaf is in the tree */
} dmi_top_leaf;

/* What a leaf stands for, and what a ray reads where it enters the leaf's box: two cache lines that are found without a
 * way over pointers. The owner of the tree fills it. */
typedef struct dmi_top_item {
    _Alignas(DMI_ALIGNMENT) double from_world[DMI_MATRIX];
    double scale;                     /* host units in one of the object-normalised frame */
    const struct dmi_bvh_part* shape; /* shape in the part's bvh */
    const void* part;                 /* NULL: the leaf is free */
} dmi_top_item;

typedef struct dmi_top_tree {
    dmi_env* env;
    dmi_top_node* nodes;
    dmi_top_leaf* leaves;
    dmi_top_item* items[DMI_TOP_CHUNKS]; /* grow by a chunk, so that none is copied */
    dmi_box_item* sorted;                /* scratch of a rebuild */
    uint32_t root;                       /* reference; DMI_TOP_NONE when empty */
    uint32_t levels;                     /* most levels of nodes */
    uint32_t capacity;                   /* capacity of the arrays */
    uint32_t chunks;                     /* chunks in use */
    uint32_t placed_count;               /* leaves in the tree */
    uint32_t free_leaf, free_node;
    uint32_t waiting;                 /* leaves, in `sorted` */
    uint32_t used_leaves, used_nodes; /* the others have never been used, nor their memory touched */
} dmi_top_tree;

/* Where the item of a leaf is: chunk 0 has the first leaves, and each other one as many as all before it. */
static inline dmi_top_item* dmi_top_tree_item(const dmi_top_tree* tree, uint32_t leaf) {
    const uint32_t mask = DMI_TOP_FIRST - 1, chunk = dmi_floor_log2((leaf | mask) / (DMI_TOP_FIRST / 2));
    return tree->items[chunk] + (leaf - ((DMI_TOP_FIRST / 2 << chunk) & ~mask));
}

void dmi_top_tree_init(dmi_top_tree* tree, dmi_env* env);
void dmi_top_tree_release(dmi_top_tree* tree);

/* Makes a leaf, which is not placed yet. The only call that allocates. */
dm_result dmi_top_tree_add(dmi_top_tree* tree, const void* part, uint32_t* out_leaf);
void dmi_top_tree_remove(dmi_top_tree* tree, uint32_t leaf);
/* Puts a leaf where its box belongs, which may have changed. */
void dmi_top_tree_place(dmi_top_tree* tree, uint32_t leaf);
/* Puts off the placing of a leaf that is not placed until dmi_top_tree_place_waiting, before which no leaf is
 * added and the tree is not rebuilt. Leaves that lie together are placed together: near-linear in their number. */
void dmi_top_tree_wait(dmi_top_tree* tree, uint32_t leaf);
void dmi_top_tree_place_waiting(dmi_top_tree* tree);
/* Builds the tree anew from the leaves whose `placed` is set: cheaper than placing many. */
void dmi_top_tree_rebuild(dmi_top_tree* tree);
/* Rebuilds a tree that has grown too high to be walked. Once after changes. */
void dmi_top_tree_settle(dmi_top_tree* tree);

#endif
