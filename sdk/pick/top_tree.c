/* The tree of a scene: nodes of two to eight children, leaves at any depth. A leaf goes where it adds the least
 * surface; a node that overflows is split in two, as in an R-tree (Guttman 1984), so that only the split of the root
 * makes all ways longer. */
#include "pick/top_tree.h"

#include <math.h>
#include <string.h>

#include "pick/lanes.h"

#define FIRST_CAPACITY 8                                     /* leaves; doubles when full */
#define MOST_PENDING (DMI_WIDE * (DMI_TOP_FREE_LEVELS + 32)) /* ranges of a rebuild that wait */
#define ENTRIES (DMI_WIDE + 1)                               /* of a node that overflows */
#define LEAST_ENTRIES 2                                      /* of each half */

/* A child with its box. */
typedef struct entry {
    dmi_box box;
    uint32_t reference;
} entry;

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
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked */
    return memcmp(a->low, b->low, 3 * sizeof(float)) == 0 && memcmp(a->high, b->high, 3 * sizeof(float)) == 0;
}

static dmi_box child_box(const dmi_wide_node* node, uint32_t slot) {
    dmi_box box = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        box.low[k] = node->planes[k][slot];
        box.high[k] = node->planes[3 + k][slot];
    }
    return box;
}

static dmi_box node_box(const dmi_top_node* node) {
    dmi_box box = child_box(&node->wide, 0);
    for (uint32_t i = 1; i < node->count; i++) {
        const dmi_box child = child_box(&node->wide, i);
        box = join(&box, &child);
    }
    return box;
}

/* ---- links ---- */

static void set_parent(dmi_top_tree* tree, uint32_t reference, uint32_t parent) {
    if (reference & DMI_LEAF)
        tree->leaves[reference & ~DMI_LEAF].parent = parent;
    else
        tree->nodes[reference].parent = parent;
}

static void set_child(dmi_top_tree* tree, uint32_t index, uint32_t slot, const entry* child) {
    dmi_wide_node_set_box(&tree->nodes[index].wide, slot, &child->box);
    tree->nodes[index].wide.child[slot] = child->reference;
    set_parent(tree, child->reference, index);
}

static void add_child(dmi_top_tree* tree, uint32_t index, const entry* child) {
    set_child(tree, index, tree->nodes[index].count++, child);
}

static entry get_child(const dmi_top_tree* tree, uint32_t index, uint32_t slot) {
    const dmi_wide_node* node = &tree->nodes[index].wide;
    return (entry){child_box(node, slot), node->child[slot]};
}

/* Takes a child out; the last one moves to its slot. */
static void drop_child(dmi_top_tree* tree, uint32_t index, uint32_t slot) {
    static const dmi_box inside_out = {{INFINITY, INFINITY, INFINITY, 0}, {-INFINITY, -INFINITY, -INFINITY, 0}};
    dmi_top_node* node = &tree->nodes[index];
    const uint32_t last = --node->count;
    const entry moved = get_child(tree, index, last);
    set_child(tree, index, slot, &moved);
    dmi_wide_node_set_box(&node->wide, last, &inside_out);
    node->wide.child[last] = 0;
}

static uint32_t slot_of(const dmi_top_tree* tree, uint32_t parent, uint32_t reference) {
    uint32_t slot = 0;
    while (tree->nodes[parent].wide.child[slot] != reference) slot++;
    return slot;
}

/* Returns a node without children; its parent is not set. */
static uint32_t take_node(dmi_top_tree* tree) {
    const uint32_t index = tree->free_node;
    dmi_top_node* node = &tree->nodes[index];
    tree->free_node = node->parent;
    node->count = 0;
    memset(node->wide.child, 0, sizeof node->wide.child);
    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < DMI_WIDE; i++) {
            node->wide.planes[k][i] = INFINITY;
            node->wide.planes[3 + k][i] = -INFINITY;
        }
    return index;
}

static void give_node(dmi_top_tree* tree, uint32_t index) {
    tree->nodes[index].parent = tree->free_node;
    tree->free_node = index;
}

static void set_root(dmi_top_tree* tree, uint32_t reference) {
    tree->root = reference;
    if (reference != DMI_TOP_NONE) set_parent(tree, reference, DMI_TOP_NONE);
}

/* Measures the boxes above a node, as far as something changes. */
static void climb(dmi_top_tree* tree, uint32_t index) {
    for (;;) {
        const uint32_t parent = tree->nodes[index].parent;
        if (parent == DMI_TOP_NONE) return;
        const uint32_t slot = slot_of(tree, parent, index);
        const dmi_box old = child_box(&tree->nodes[parent].wide, slot), box = node_box(&tree->nodes[index]);
        if (same(&old, &box)) return;
        dmi_wide_node_set_box(&tree->nodes[parent].wide, slot, &box);
        index = parent;
    }
}

/* ---- splitting ---- */

/* Sorts entries by the centres of their boxes along an axis. */
static void sort_entries(entry entries[ENTRIES], int axis) {
    for (int i = 1; i < ENTRIES; i++) {
        const entry moved = entries[i];
        const float centre = moved.box.low[axis] + moved.box.high[axis];
        int at = i;
        for (; at > 0 && entries[at - 1].box.low[axis] + entries[at - 1].box.high[axis] > centre; at--)
            entries[at] = entries[at - 1];
        entries[at] = moved;
    }
}

/* Returns the surface of the best division of sorted entries, weighted by their numbers, and the size of its first
 * group. */
static float divide(const entry entries[ENTRIES], int* out_first) {
    float behind[ENTRIES], best = INFINITY;
    dmi_box box = entries[ENTRIES - 1].box;
    for (int i = ENTRIES - 1; i > 0; i--) {
        box = join(&box, &entries[i].box);
        behind[i] = dmi_box_area(&box) * (float)(ENTRIES - i);
    }
    box = entries[0].box;
    *out_first = ENTRIES / 2;
    for (int i = 1; i <= ENTRIES - LEAST_ENTRIES; i++) {
        const float cost = dmi_box_area(&box) * (float)i + behind[i];
        if (i >= LEAST_ENTRIES && cost < best) {
            best = cost;
            *out_first = i;
        }
        box = join(&box, &entries[i].box);
    }
    return best;
}

/* Spreads the children of a full node and one more over it and a new node, which is returned. */
static uint32_t split_node(dmi_top_tree* tree, uint32_t index, const entry* added) {
    entry entries[ENTRIES];
    float best_cost = INFINITY;
    int first, best_axis = 0;
    for (uint32_t i = 0; i < DMI_WIDE; i++) entries[i] = get_child(tree, index, i);
    entries[DMI_WIDE] = *added;
    for (int axis = 0; axis < 3; axis++) {
        sort_entries(entries, axis);
        const float cost = divide(entries, &first);
        if (!(cost < best_cost)) continue;
        best_cost = cost;
        best_axis = axis;
    }
    sort_entries(entries, best_axis);
    divide(entries, &first);
    const uint32_t parent = tree->nodes[index].parent;
    give_node(tree, index);
    take_node(tree); /* the same one, empty */
    tree->nodes[index].parent = parent;
    const uint32_t other = take_node(tree);
    for (int i = 0; i < ENTRIES; i++) add_child(tree, i < first ? index : other, &entries[i]);
    return other;
}

/* Adds a child to a node; a node that is full is split, and so may be those above it. */
static void add_or_split(dmi_top_tree* tree, uint32_t index, const entry* added) {
    entry child = *added;
    while (tree->nodes[index].count == DMI_WIDE) {
        const uint32_t other = split_node(tree, index, &child), parent = tree->nodes[index].parent;
        const entry halves[2] = {{node_box(&tree->nodes[index]), index}, {node_box(&tree->nodes[other]), other}};
        if (parent == DMI_TOP_NONE) {
            const uint32_t root = take_node(tree);
            for (int i = 0; i < 2; i++) add_child(tree, root, &halves[i]);
            set_root(tree, root);
            tree->levels++;
            return;
        }
        dmi_wide_node_set_box(&tree->nodes[parent].wide, slot_of(tree, parent, index), &halves[0].box);
        child = halves[1];
        index = parent;
    }
    add_child(tree, index, &child);
    climb(tree, index);
}

/* ---- putting in and taking out ---- */

/* Returns the child of a node whose box grows least, the smaller one of two. */
static uint32_t choose_child(const dmi_top_node* node, const dmi_box* box) {
    uint32_t best = 0;
    float best_growth = INFINITY, best_area = INFINITY;
    for (uint32_t i = 0; i < node->count; i++) {
        const dmi_box child = child_box(&node->wide, i);
        const float area = dmi_box_area(&child), growth = joined_area(&child, box) - area;
        if (growth > best_growth || (growth == best_growth && area >= best_area)) continue;
        best = i;
        best_growth = growth;
        best_area = area;
    }
    return best;
}

static void insert(dmi_top_tree* tree, uint32_t leaf) {
    const entry added = {tree->leaves[leaf].box, DMI_LEAF | leaf};
    tree->leaves[leaf].placed = true;
    tree->placed_count++;
    if (tree->root == DMI_TOP_NONE) {
        set_root(tree, added.reference);
        return;
    }
    if (tree->root & DMI_LEAF) {
        const entry other = {tree->leaves[tree->root & ~DMI_LEAF].box, tree->root};
        const uint32_t root = take_node(tree);
        add_child(tree, root, &other);
        add_child(tree, root, &added);
        set_root(tree, root);
        tree->levels = 1;
        return;
    }
    uint32_t index = tree->root;
    for (;;) {
        const dmi_top_node* node = &tree->nodes[index];
        const uint32_t child = node->wide.child[choose_child(node, &added.box)];
        if (child & DMI_LEAF) break;
        index = child;
    }
    add_or_split(tree, index, &added);
}

static void take_out(dmi_top_tree* tree, uint32_t leaf) {
    const uint32_t index = tree->leaves[leaf].parent;
    tree->leaves[leaf].placed = false;
    tree->placed_count--;
    if (index == DMI_TOP_NONE) {
        set_root(tree, DMI_TOP_NONE);
        return;
    }
    drop_child(tree, index, slot_of(tree, index, DMI_LEAF | leaf));
    if (tree->nodes[index].count > 1) {
        climb(tree, index);
        return;
    }
    /* The last child takes the node's own place. */
    const uint32_t parent = tree->nodes[index].parent;
    const entry last = get_child(tree, index, 0);
    if (parent == DMI_TOP_NONE) {
        set_root(tree, last.reference);
    } else {
        set_child(tree, parent, slot_of(tree, parent, index), &last);
        climb(tree, parent);
    }
    give_node(tree, index);
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

/* Items first … that become a child of node `parent`. */
typedef struct pending {
    uint32_t first, count, parent, level;
} pending;

/* Splits a range into up to eight; returns how many, and the box of all. */
static uint32_t split_range(dmi_top_tree* tree, const pending* work, dmi_box* out_box, dmi_box_range out[DMI_WIDE]) {
    out[0] = (dmi_box_range){.first = work->first, .count = work->count};
    dmi_box_range_measure(tree->items, &out[0]);
    *out_box = out[0].box;
    return dmi_box_split_up(tree->items, 1, work->level >= DMI_TOP_FREE_LEVELS, out, DMI_WIDE, NULL);
}

/* Makes the node of a range of several leaves, links it, and puts off its children of several. */
static uint32_t make_node(dmi_top_tree* tree, const pending* work, pending* stack, uint32_t waiting) {
    dmi_box_range ranges[DMI_WIDE];
    dmi_box box;
    const uint32_t index = take_node(tree), count = split_range(tree, work, &box, ranges);
    if (work->parent == DMI_TOP_NONE) {
        set_root(tree, index);
    } else {
        const entry self = {box, index};
        add_child(tree, work->parent, &self);
    }
    for (uint32_t i = 0; i < count; i++) {
        if (ranges[i].count > 1) {
            stack[waiting++] = (pending){ranges[i].first, ranges[i].count, index, work->level + 1};
        } else {
            const entry leaf = {ranges[i].box, DMI_LEAF | tree->items[ranges[i].first].id};
            add_child(tree, index, &leaf);
        }
    }
    if (work->level + 1 > tree->levels) tree->levels = work->level + 1;
    return waiting;
}

static void make_nodes(dmi_top_tree* tree, uint32_t count) {
    pending stack[MOST_PENDING], work = {.count = count, .parent = DMI_TOP_NONE};
    for (uint32_t waiting = 0;;) {
        waiting = make_node(tree, &work, stack, waiting);
        if (waiting == 0) return;
        work = stack[--waiting];
    }
}

void dmi_top_tree_rebuild(dmi_top_tree* tree) {
    const uint32_t count = gather(tree);
    tree->placed_count = count;
    tree->levels = 0;
    tree->free_node = DMI_TOP_NONE;
    for (uint32_t i = tree->capacity; i > 0; i--) give_node(tree, i - 1);
    set_root(tree, count == 1 ? DMI_LEAF | tree->items[0].id : DMI_TOP_NONE);
    if (count > 1) make_nodes(tree, count);
}

void dmi_top_tree_settle(dmi_top_tree* tree) {
    if (tree->levels > DMI_TOP_MOST_LEVELS) dmi_top_tree_rebuild(tree);
}
