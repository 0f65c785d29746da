/* The tree of a scene. Leaves go in where they add the least surface (Bittner et al. 2013, "Fast insertion-based
 * optimization of bounding volume hierarchies"), and rotations on the way up keep the tree good whatever the order of
 * insertions (Kopta et al. 2012, "Fast, effective BVH updates for animated scenes"). */
#include "pick/top_tree.h"

#include <math.h>
#include <string.h>

#include "pick/lanes.h"

#define FIRST_CAPACITY 16                   /* leaves; doubles when full */
#define FREE_HEIGHT 24                      /* levels that a rebuild splits by surface before it halves; by hand */
#define MOST_PENDING (FREE_HEIGHT + 32 + 2) /* ranges of a rebuild that wait: one a level, and the two of the last */

/* ---- boxes ---- */

static dmi_box join(const dmi_box* a, const dmi_box* b) {
    dmi_box joined;
    dmi_lanes_store(joined.low, dmi_lanes_min(dmi_lanes_load(a->low), dmi_lanes_load(b->low)));
    dmi_lanes_store(joined.high, dmi_lanes_max(dmi_lanes_load(a->high), dmi_lanes_load(b->high)));
    return joined;
}

static float joined_area(const dmi_box* a, const dmi_box* b) {
    const dmi_box joined = join(a, b);
    return dmi_box_area(&joined);
}

static bool same(const dmi_box* a, const dmi_box* b) {
    return memcmp(a->low, b->low, 3 * sizeof(float)) == 0 && memcmp(a->high, b->high, 3 * sizeof(float)) == 0;
}

static dmi_box child_box(const dmi_top_node* node, uint32_t side) {
    dmi_box box = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        box.low[k] = node->bounds[k][side];
        box.high[k] = node->bounds[k][2 + side];
    }
    return box;
}

static dmi_box node_box(const dmi_top_node* node) {
    const dmi_box a = child_box(node, 0), b = child_box(node, 1);
    return join(&a, &b);
}

/* ---- links ---- */

static uint32_t height_of(const dmi_top_tree* tree, uint32_t reference) {
    return reference & DMI_TOP_LEAF ? 0 : tree->nodes[reference].height;
}

static void set_parent(dmi_top_tree* tree, uint32_t reference, uint32_t parent) {
    if (reference & DMI_TOP_LEAF)
        tree->leaves[reference & ~DMI_TOP_LEAF].parent = parent;
    else
        tree->nodes[reference].parent = parent;
}

static void set_child(dmi_top_tree* tree, uint32_t index, uint32_t side, uint32_t reference, const dmi_box* box) {
    dmi_top_node* node = &tree->nodes[index];
    for (int k = 0; k < 3; k++) {
        node->bounds[k][side] = box->low[k];
        node->bounds[k][2 + side] = box->high[k];
    }
    node->child[side] = reference;
    set_parent(tree, reference, index);
}

static uint32_t side_of(const dmi_top_tree* tree, uint32_t parent, uint32_t reference) {
    return tree->nodes[parent].child[1] == reference;
}

static void measure_height(const dmi_top_tree* tree, dmi_top_node* node) {
    const uint32_t a = height_of(tree, node->child[0]), b = height_of(tree, node->child[1]);
    node->height = 1 + (a > b ? a : b);
}

static uint32_t take_node(dmi_top_tree* tree) {
    const uint32_t index = tree->free_node;
    tree->free_node = tree->nodes[index].parent;
    return index;
}

static void give_node(dmi_top_tree* tree, uint32_t index) {
    tree->nodes[index].parent = tree->free_node;
    tree->free_node = index;
}

/* ---- the way up ---- */

/* Swaps one child of a node with a child of the other where that makes the other's box smaller. */
static void rotate(dmi_top_tree* tree, uint32_t index) {
    dmi_top_node* node = &tree->nodes[index];
    float best_gain = 0;
    uint32_t best_side = 0, best_inner = 0;
    for (uint32_t side = 0; side < 2; side++) {
        const uint32_t lower = node->child[side];
        if (lower & DMI_TOP_LEAF) continue;
        const dmi_box other = child_box(node, 1 - side), whole = child_box(node, side);
        const float area = dmi_box_area(&whole);
        for (uint32_t inner = 0; inner < 2; inner++) { /* the one that goes up */
            const dmi_box stays = child_box(&tree->nodes[lower], 1 - inner);
            const float gain = area - joined_area(&stays, &other);
            if (gain > best_gain) {
                best_gain = gain;
                best_side = side;
                best_inner = inner;
            }
        }
    }
    if (!(best_gain > 0)) return;
    const uint32_t lower = node->child[best_side], other = node->child[1 - best_side];
    const dmi_box other_box = child_box(node, 1 - best_side), up_box = child_box(&tree->nodes[lower], best_inner);
    const uint32_t up = tree->nodes[lower].child[best_inner];
    set_child(tree, lower, best_inner, other, &other_box);
    measure_height(tree, &tree->nodes[lower]);
    const dmi_box lower_box = node_box(&tree->nodes[lower]);
    set_child(tree, index, best_side, lower, &lower_box);
    set_child(tree, index, 1 - best_side, up, &up_box);
}

/* Measures and improves a node and those above it, as far as something changes. */
static void climb(dmi_top_tree* tree, uint32_t index) {
    while (index != DMI_TOP_NONE) {
        dmi_top_node* node = &tree->nodes[index];
        const uint32_t height = node->height, parent = node->parent;
        rotate(tree, index);
        measure_height(tree, node);
        if (parent == DMI_TOP_NONE) return;
        const uint32_t side = side_of(tree, parent, index);
        const dmi_box old = child_box(&tree->nodes[parent], side), box = node_box(node);
        if (same(&old, &box) && height == node->height) return;
        set_child(tree, parent, side, index, &box);
        index = parent;
    }
}

/* ---- putting in and taking out ---- */

/* Puts `reference` where `old` was. */
static void replace(dmi_top_tree* tree, uint32_t parent, uint32_t old, uint32_t reference, const dmi_box* box) {
    if (parent == DMI_TOP_NONE) {
        tree->root = reference;
        set_parent(tree, reference, DMI_TOP_NONE);
    } else {
        set_child(tree, parent, side_of(tree, parent, old), reference, box);
    }
}

/* Finds the reference, and its box, beside which a box adds the least surface. */
static uint32_t find_sibling(const dmi_top_tree* tree, const dmi_box* box, dmi_box* out_box) {
    uint32_t reference = tree->root;
    if (reference & DMI_TOP_LEAF) {
        *out_box = tree->leaves[reference & ~DMI_TOP_LEAF].box;
        return reference;
    }
    *out_box = node_box(&tree->nodes[reference]);
    while (!(reference & DMI_TOP_LEAF)) {
        const dmi_top_node* node = &tree->nodes[reference];
        const float here = joined_area(out_box, box), grown = here - dmi_box_area(out_box);
        float cost[2];
        dmi_box child[2];
        for (uint32_t side = 0; side < 2; side++) {
            child[side] = child_box(node, side);
            cost[side] = grown + joined_area(&child[side], box);
            if (!(node->child[side] & DMI_TOP_LEAF)) cost[side] -= dmi_box_area(&child[side]);
        }
        const uint32_t side = cost[1] < cost[0];
        if (here <= cost[side]) break;
        reference = node->child[side];
        *out_box = child[side];
    }
    return reference;
}

static void insert(dmi_top_tree* tree, uint32_t leaf) {
    const dmi_box* box = &tree->leaves[leaf].box;
    tree->leaves[leaf].placed = true;
    tree->placed_count++;
    if (tree->root == DMI_TOP_NONE) {
        replace(tree, DMI_TOP_NONE, DMI_TOP_NONE, DMI_TOP_LEAF | leaf, box);
        return;
    }
    dmi_box sibling_box;
    const uint32_t sibling = find_sibling(tree, box, &sibling_box);
    const uint32_t parent =
        sibling & DMI_TOP_LEAF ? tree->leaves[sibling & ~DMI_TOP_LEAF].parent : tree->nodes[sibling].parent;
    const uint32_t index = take_node(tree);
    const dmi_box joined = join(&sibling_box, box);
    tree->nodes[index].parent = DMI_TOP_NONE;
    replace(tree, parent, sibling, index, &joined);
    set_child(tree, index, 0, sibling, &sibling_box);
    set_child(tree, index, 1, DMI_TOP_LEAF | leaf, box);
    measure_height(tree, &tree->nodes[index]);
    climb(tree, parent);
}

static void take_out(dmi_top_tree* tree, uint32_t leaf) {
    const uint32_t parent = tree->leaves[leaf].parent;
    tree->leaves[leaf].placed = false;
    tree->placed_count--;
    if (parent == DMI_TOP_NONE) {
        tree->root = DMI_TOP_NONE;
        return;
    }
    const dmi_top_node* node = &tree->nodes[parent];
    const uint32_t side = side_of(tree, parent, DMI_TOP_LEAF | leaf), above = node->parent;
    const dmi_box box = child_box(node, 1 - side);
    replace(tree, above, parent, node->child[1 - side], &box);
    give_node(tree, parent);
    climb(tree, above);
}

void dmi_top_tree_place(dmi_top_tree* tree, uint32_t leaf) {
    if (tree->leaves[leaf].placed) take_out(tree, leaf);
    insert(tree, leaf);
}

/* ---- leaves ---- */

void dmi_top_tree_init(dmi_top_tree* tree, dmi_env* env) {
    *tree = (dmi_top_tree){.env = env, .root = DMI_TOP_NONE, .free_leaf = DMI_TOP_NONE, .free_node = DMI_TOP_NONE};
}

static void release_arrays(dmi_env* env, dmi_top_node* nodes, dmi_top_leaf* leaves, dmi_box_item* items,
                           size_t capacity) {
    dmi_free(env, nodes, capacity * sizeof *nodes);
    dmi_free(env, leaves, capacity * sizeof *leaves);
    dmi_free(env, items, capacity * sizeof *items);
}

void dmi_top_tree_release(dmi_top_tree* tree) {
    release_arrays(tree->env, tree->nodes, tree->leaves, tree->items, tree->capacity);
}

/* Doubles the room; the new nodes and leaves are free. */
static dm_result expand(dmi_top_tree* tree) {
    dmi_env* env = tree->env;
    const uint32_t old = tree->capacity, capacity = old > 0 ? 2 * old : FIRST_CAPACITY;
    dmi_top_node* nodes = dmi_alloc(env, capacity * sizeof *nodes, DMI_ALIGNMENT);
    dmi_top_leaf* leaves = dmi_alloc(env, capacity * sizeof *leaves, DMI_ALIGNMENT);
    dmi_box_item* items = dmi_alloc(env, capacity * sizeof *items, DMI_ALIGNMENT);
    if (nodes == NULL || leaves == NULL || items == NULL) {
        release_arrays(env, nodes, leaves, items, capacity);
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for a scene of %u parts", capacity);
    }
    if (old > 0) {
        memcpy(nodes, tree->nodes, old * sizeof *nodes);
        memcpy(leaves, tree->leaves, old * sizeof *leaves);
    }
    for (uint32_t i = old; i < capacity; i++) {
        nodes[i].parent = i + 1 < capacity ? i + 1 : tree->free_node;
        leaves[i].parent = i + 1 < capacity ? i + 1 : tree->free_leaf;
        leaves[i].placed = false;
    }
    dmi_top_tree_release(tree);
    tree->nodes = nodes;
    tree->leaves = leaves;
    tree->items = items;
    tree->capacity = capacity;
    tree->free_node = tree->free_leaf = old;
    return DM_OK;
}

dm_result dmi_top_tree_add(dmi_top_tree* tree, void* item, uint32_t* out_leaf) {
    if (tree->free_leaf == DMI_TOP_NONE) {
        const dm_result result = expand(tree);
        if (result != DM_OK) return result;
    }
    const uint32_t leaf = tree->free_leaf;
    tree->free_leaf = tree->leaves[leaf].parent;
    tree->leaves[leaf] = (dmi_top_leaf){.item = item, .parent = DMI_TOP_NONE};
    *out_leaf = leaf;
    return DM_OK;
}

void dmi_top_tree_remove(dmi_top_tree* tree, uint32_t leaf) {
    if (tree->leaves[leaf].placed) take_out(tree, leaf);
    tree->leaves[leaf].item = NULL;
    tree->leaves[leaf].parent = tree->free_leaf;
    tree->free_leaf = leaf;
}

/* ---- rebuilding ---- */

static uint32_t gather(dmi_top_tree* tree) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < tree->capacity; i++) {
        const dmi_top_leaf* leaf = &tree->leaves[i];
        if (!leaf->placed) continue;
        dmi_box_item* item = &tree->items[count++];
        memcpy(item->low, leaf->box.low, sizeof item->low);
        memcpy(item->high, leaf->box.high, sizeof item->high);
        item->id = i;
        item->unused = 0;
    }
    return count;
}

/* A range of leaves that becomes child `side` of node `parent`. */
typedef struct pending {
    dmi_box_range range;
    uint32_t parent, side, level;
} pending;

/* Gives a range its reference: of its leaf, or of a node that is made next; false for a leaf. */
static bool link_range(dmi_top_tree* tree, const pending* work, uint32_t next_node) {
    const bool alone = work->range.count == 1;
    const uint32_t reference = alone ? DMI_TOP_LEAF | tree->items[work->range.first].id : next_node;
    if (work->parent == DMI_TOP_NONE) {
        tree->root = reference;
        set_parent(tree, reference, DMI_TOP_NONE);
    } else {
        set_child(tree, work->parent, work->side, reference, &work->range.box);
    }
    return !alone;
}

/* Makes the nodes, each before those below it, and returns how many. */
static uint32_t make_nodes(dmi_top_tree* tree, uint32_t count) {
    pending stack[MOST_PENDING];
    uint32_t waiting = 1, made = 0;
    stack[0] = (pending){.range = {.first = 0, .count = count}, .parent = DMI_TOP_NONE};
    dmi_box_range_measure(tree->items, &stack[0].range);
    while (waiting > 0) {
        const pending work = stack[--waiting];
        if (!link_range(tree, &work, made)) continue;
        dmi_box_range two[2];
        dmi_box_split(tree->items, &work.range, 1, work.level >= FREE_HEIGHT, two);
        for (uint32_t side = 0; side < 2; side++) stack[waiting++] = (pending){two[side], made, side, work.level + 1};
        made++;
    }
    return made;
}

void dmi_top_tree_rebuild(dmi_top_tree* tree) {
    const uint32_t count = gather(tree);
    tree->placed_count = count;
    tree->root = DMI_TOP_NONE;
    const uint32_t made = count > 0 ? make_nodes(tree, count) : 0;
    for (uint32_t i = made; i > 0; i--) measure_height(tree, &tree->nodes[i - 1]);
    tree->free_node = DMI_TOP_NONE;
    for (uint32_t i = tree->capacity; i > made; i--) give_node(tree, i - 1);
}

void dmi_top_tree_settle(dmi_top_tree* tree) {
    if (tree->root != DMI_TOP_NONE && height_of(tree, tree->root) > DMI_TOP_MOST_HEIGHT) dmi_top_tree_rebuild(tree);
}
