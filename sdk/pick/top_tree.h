/* A tree of boxes that change: a box is moved, put in or taken out in the time of one way through the tree. */
#ifndef DMI_PICK_TOP_TREE_H
#define DMI_PICK_TOP_TREE_H

#include <stdbool.h>

#include "base/env.h"
#include "pick/box_split.h"

#define DMI_TOP_NONE 0xffffffffu
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

typedef struct dmi_top_tree {
    dmi_env* env;
    dmi_top_node* nodes;
    dmi_top_leaf* leaves;
    void** items;          /* what each leaf stands for: close together, since a ray reads nothing else of a leaf */
    dmi_box_item* sorted;  /* scratch of a rebuild */
    uint32_t root;         /* reference; DMI_TOP_NONE when empty */
    uint32_t levels;       /* most levels of nodes */
    uint32_t capacity;     /* capacity of the arrays */
    uint32_t placed_count; /* leaves in the tree */
    uint32_t free_leaf, free_node;
    uint32_t waiting;                 /* leaves, in `sorted` */
    uint32_t used_leaves, used_nodes; /* the others have never been used, nor their memory touched */
} dmi_top_tree;

void dmi_top_tree_init(dmi_top_tree* tree, dmi_env* env);
void dmi_top_tree_release(dmi_top_tree* tree);

/* Makes a leaf, which is not placed yet. The only call that allocates. */
dm_result dmi_top_tree_add(dmi_top_tree* tree, void* item, uint32_t* out_leaf);
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
