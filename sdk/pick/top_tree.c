/* The tree of a scene: nodes of two to eight children, leaves at any depth. A leaf goes where it adds the least
 * surface; a node that overflows is split in two, as in an R-tree (Guttman 1984), so that only the split of the root
 * makes all ways longer. */
#include "pick/top_tree.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"
#include "pick/lanes.h"

#define MOST_PENDING (DMI_WIDE * (DMI_TOP_FREE_LEVELS + 32)) /* ranges of a rebuild that wait */
#define ENTRIES (DMI_WIDE + 1)                               /* entries of a node that overflows */
#define MOST_SPREAD 2   /* surface of a group of new leaves, of that of the leaves beside it; by hand */
#define LEAST_ENTRIES 2 /* fewest entries of each half */

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

/* The least, and the largest number of a plane; unused children are inside out. */
static float least_of(const float plane[DMI_WIDE]) {
    float four[DMI_WIDE / 2];
    dmi_lanes_store(four, dmi_lanes_min(dmi_lanes_load(plane), dmi_lanes_load(plane + DMI_WIDE / 2)));
    return dmi_fminf(dmi_fminf(four[0], four[1]), dmi_fminf(four[2], four[3]));
}

static float most_of(const float plane[DMI_WIDE]) {
    float four[DMI_WIDE / 2];
    dmi_lanes_store(four, dmi_lanes_max(dmi_lanes_load(plane), dmi_lanes_load(plane + DMI_WIDE / 2)));
    return dmi_fmaxf(dmi_fmaxf(four[0], four[1]), dmi_fmaxf(four[2], four[3]));
}

static dmi_box node_box(const dmi_top_node* node) {
    dmi_box box = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        box.low[k] = least_of(node->wide.planes[k]);
        box.high[k] = most_of(node->wide.planes[3 + k]);
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
    const bool used = tree->free_node != DMI_TOP_NONE;
    const uint32_t index = used ? tree->free_node : tree->used_nodes++;
    dmi_top_node* node = &tree->nodes[index];
    if (used) tree->free_node = node->parent;
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

/* Joins a box that a node has got to the boxes above it, as far as something changes. */
static void extend(dmi_top_tree* tree, uint32_t index, const dmi_box* added) {
    for (;;) {
        const uint32_t parent = tree->nodes[index].parent;
        if (parent == DMI_TOP_NONE) return;
        const uint32_t slot = slot_of(tree, parent, index);
        const dmi_box old = child_box(&tree->nodes[parent].wide, slot), box = join(&old, added);
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
    extend(tree, index, &added->box);
}

/* ---- putting in and taking out ---- */

/* Computes the surface of four children from `first` on, and by how much it grows when a box joins them. */
static void measure_growth(const dmi_wide_node* node, uint32_t first, const dmi_box* box, float out_area[4],
                           float out_growth[4]) {
    dmi_lanes own[3], joined[3];
    for (int k = 0; k < 3; k++) {
        const dmi_lanes low = dmi_lanes_load(node->planes[k] + first),
                        high = dmi_lanes_load(node->planes[3 + k] + first);
        own[k] = dmi_lanes_sub(high, low);
        joined[k] = dmi_lanes_sub(dmi_lanes_max(high, dmi_lanes_all(box->high[k])),
                                  dmi_lanes_min(low, dmi_lanes_all(box->low[k])));
    }
    dmi_lanes area[2];
    const dmi_lanes* sides[2] = {own, joined};
    for (int i = 0; i < 2; i++) {
        const dmi_lanes* s = sides[i];
        area[i] = dmi_lanes_add(dmi_lanes_add(dmi_lanes_mul(s[0], s[1]), dmi_lanes_mul(s[1], s[2])),
                                dmi_lanes_mul(s[2], s[0]));
    }
    dmi_lanes_store(out_area, area[0]);
    dmi_lanes_store(out_growth, dmi_lanes_sub(area[1], area[0]));
}

/* Returns the child of a node whose box grows least, the smaller one of two. */
static uint32_t choose_child(const dmi_top_node* node, const dmi_box* box) {
    float area[DMI_WIDE], growth[DMI_WIDE];
    for (uint32_t first = 0; first < DMI_WIDE; first += DMI_WIDE / 2)
        measure_growth(&node->wide, first, box, area + first, growth + first);
    uint32_t best = 0;
    for (uint32_t i = 1; i < node->count; i++)
        if (growth[i] < growth[best] || (growth[i] == growth[best] && area[i] < area[best])) best = i;
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

static uint32_t chunk_size(uint32_t chunk) {
    return chunk == 0 ? DMI_TOP_FIRST : DMI_TOP_FIRST / 2 << chunk;
}

/* Frees the arrays that are copied when the tree grows. */
static void release_arrays(const dmi_top_tree* tree) {
    const size_t capacity = tree->capacity;
    dmi_free(tree->env, tree->nodes, capacity * sizeof *tree->nodes);
    dmi_free(tree->env, tree->leaves, capacity * sizeof *tree->leaves);
    dmi_free(tree->env, tree->sorted, capacity * sizeof *tree->sorted);
}

void dmi_top_tree_release(dmi_top_tree* tree) {
    release_arrays(tree);
    for (uint32_t i = 0; i < tree->chunks; i++)
        dmi_free(tree->env, tree->items[i], chunk_size(i) * sizeof *tree->items[i]);
}

/* Doubles the room. */
static dm_result expand(dmi_top_tree* tree) {
    dmi_env* env = tree->env;
    const size_t capacity = tree->capacity > 0 ? 2 * (size_t)tree->capacity : DMI_TOP_FIRST;
    const size_t items_size = chunk_size(tree->chunks) * sizeof(dmi_top_item);
    dmi_top_tree grown = *tree;
    grown.capacity = (uint32_t)capacity;
    grown.nodes = dmi_alloc(env, capacity * sizeof *grown.nodes, DMI_ALIGNMENT);
    grown.leaves = dmi_alloc(env, capacity * sizeof *grown.leaves, DMI_ALIGNMENT);
    grown.sorted = dmi_alloc(env, capacity * sizeof *grown.sorted, DMI_ALIGNMENT);
    dmi_top_item* items = dmi_alloc(env, items_size, DMI_ALIGNMENT);
    if (grown.nodes == NULL || grown.leaves == NULL || grown.sorted == NULL || items == NULL) {
        release_arrays(&grown);
        dmi_free(env, items, items_size);
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for a scene of %u parts", grown.capacity);
    }
    if (tree->capacity > 0) {
        memcpy(grown.nodes, tree->nodes, tree->used_nodes * sizeof *grown.nodes);
        memcpy(grown.leaves, tree->leaves, tree->used_leaves * sizeof *grown.leaves);
    }
    grown.items[grown.chunks++] = items;
    release_arrays(tree);
    *tree = grown;
    return DM_OK;
}

dm_result dmi_top_tree_add(dmi_top_tree* tree, const void* part, uint32_t* out_leaf) {
    uint32_t leaf = tree->free_leaf;
    if (leaf != DMI_TOP_NONE) {
        tree->free_leaf = tree->leaves[leaf].parent;
    } else {
        const dm_result result = tree->used_leaves == tree->capacity ? expand(tree) : DM_OK;
        if (result != DM_OK) return result;
        leaf = tree->used_leaves++;
    }
    dmi_top_tree_item(tree, leaf)->part = part;
    tree->leaves[leaf].parent = DMI_TOP_NONE;
    tree->leaves[leaf].placed = false;
    *out_leaf = leaf;
    return DM_OK;
}

void dmi_top_tree_remove(dmi_top_tree* tree, uint32_t leaf) {
    if (tree->leaves[leaf].placed) take_out(tree, leaf);
    dmi_top_tree_item(tree, leaf)->part = NULL;
    tree->leaves[leaf].parent = tree->free_leaf;
    tree->free_leaf = leaf;
}

/* ---- rebuilding ---- */

static void set_item(dmi_top_tree* tree, uint32_t at, uint32_t leaf) {
    const dmi_box* box = &tree->leaves[leaf].box;
    dmi_box_item* item = &tree->sorted[at];
    memcpy(item->low, box->low, sizeof item->low);
    memcpy(item->high, box->high, sizeof item->high);
    item->id = leaf;
    item->unused = 0;
}

static uint32_t gather(dmi_top_tree* tree) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < tree->used_leaves; i++)
        if (tree->leaves[i].placed) set_item(tree, count++, i);
    return count;
}

/* Leaves that become a child of node `parent`. */
typedef struct pending {
    dmi_box_range range;
    uint32_t parent, level;
} pending;

static dmi_box item_box(const dmi_box_item* item) {
    dmi_box box = {{0}, {0}};
    memcpy(box.low, item->low, sizeof item->low);
    memcpy(box.high, item->high, sizeof item->high);
    return box;
}

static void add_leaf(dmi_top_tree* tree, uint32_t index, uint32_t at) {
    const dmi_box_item* item = &tree->sorted[at];
    const entry leaf = {item_box(item), DMI_LEAF | item->id};
    add_child(tree, index, &leaf);
}

/* Splits a range that one node can't hold; its children of several leaves wait. Returns how many wait then. */
static uint32_t add_children(dmi_top_tree* tree, uint32_t index, const pending* work, pending* stack,
                             uint32_t waiting) {
    const dmi_box_splits how = work->level < DMI_TOP_FREE_LEVELS ? DMI_SPLIT_FAST : DMI_SPLIT_IN_HALVES;
    dmi_box_range ranges[DMI_WIDE] = {work->range};
    const uint32_t count = dmi_box_split_up(tree->sorted, 1, how, ranges, DMI_WIDE, NULL);
    for (uint32_t i = 0; i < count; i++) {
        if (ranges[i].count > 1)
            stack[waiting++] = (pending){ranges[i], index, work->level + 1};
        else
            add_leaf(tree, index, ranges[i].first);
    }
    return waiting;
}

/* Makes the node of a range of several leaves, links it, and puts off its children of several. */
static uint32_t make_node(dmi_top_tree* tree, const pending* work, pending* stack, uint32_t waiting) {
    const dmi_box_range* range = &work->range;
    const uint32_t index = take_node(tree);
    if (work->parent == DMI_TOP_NONE) {
        set_root(tree, index);
    } else {
        const entry self = {range->box, index};
        add_child(tree, work->parent, &self);
    }
    if (work->level + 1 > tree->levels) tree->levels = work->level + 1;
    if (range->count > DMI_WIDE) return add_children(tree, index, work, stack, waiting);
    for (uint32_t i = 0; i < range->count; i++) add_leaf(tree, index, range->first + i);
    return waiting;
}

static void make_nodes(dmi_top_tree* tree, uint32_t count) {
    pending stack[MOST_PENDING], work = {.range = {.first = 0, .count = count}, .parent = DMI_TOP_NONE};
    dmi_box_range_measure(tree->sorted, &work.range);
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
    tree->used_nodes = 0;
    set_root(tree, count == 1 ? DMI_LEAF | tree->sorted[0].id : DMI_TOP_NONE);
    if (count > 1) make_nodes(tree, count);
}

/* ---- many new leaves ---- */

void dmi_top_tree_wait(dmi_top_tree* tree, uint32_t leaf) {
    set_item(tree, tree->waiting++, leaf);
}

/* Whether all children of a node that has only leaves or only nodes are leaves. */
static bool is_bottom(const dmi_top_tree* tree, uint32_t reference) {
    return reference & DMI_LEAF || tree->nodes[reference].wide.child[0] & DMI_LEAF;
}

/* Finds the node among whose children one of the lowest nodes, with this box, belongs; out_beside: which of them it
 * comes next to. The tree has two leaves or more. */
static uint32_t find_place(dmi_top_tree* tree, const dmi_box* box, entry* out_beside) {
    uint32_t index = tree->root;
    for (uint32_t level = 2;; level++) {
        const uint32_t slot = choose_child(&tree->nodes[index], box);
        *out_beside = get_child(tree, index, slot);
        if (is_bottom(tree, out_beside->reference)) {
            if (level > tree->levels) tree->levels = level;
            return index;
        }
        index = out_beside->reference;
    }
}

/* Places a group of up to DMI_WIDE waiting leaves that are close to each other: as one node where that is about as
 * small as those beside it, else one by one. */
static void place_group(dmi_top_tree* tree, const dmi_box_range* range) {
    entry beside;
    bool close = range->count > 1 && tree->root != DMI_TOP_NONE && !(tree->root & DMI_LEAF);
    const uint32_t parent = close ? find_place(tree, &range->box, &beside) : 0;
    close = close && dmi_box_area(&range->box) <= MOST_SPREAD * dmi_box_area(&beside.box);
    if (!close) {
        for (uint32_t i = 0; i < range->count; i++) insert(tree, tree->sorted[range->first + i].id);
        return;
    }
    const entry group = {range->box, take_node(tree)};
    for (uint32_t i = 0; i < range->count; i++) {
        add_leaf(tree, group.reference, range->first + i);
        tree->leaves[tree->sorted[range->first + i].id].placed = true;
    }
    tree->placed_count += range->count;
    add_or_split(tree, parent, &group);
}

void dmi_top_tree_place_waiting(dmi_top_tree* tree) {
    pending stack[MOST_PENDING];
    uint32_t depth = 1;
    stack[0] = (pending){.range = {.count = tree->waiting}};
    dmi_box_range_measure(tree->sorted, &stack[0].range);
    while (depth > 0 && tree->waiting > 0) {
        const pending work = stack[--depth];
        dmi_box_range ranges[DMI_WIDE] = {work.range};
        const dmi_box_splits how = work.level < DMI_TOP_FREE_LEVELS ? DMI_SPLIT_FAST : DMI_SPLIT_IN_HALVES;
        const uint32_t count = dmi_box_split_up(tree->sorted, DMI_WIDE, how, ranges, DMI_WIDE, NULL);
        for (uint32_t i = 0; i < count; i++) {
            if (ranges[i].count > DMI_WIDE)
                stack[depth++] = (pending){.range = ranges[i], .level = work.level + 1};
            else
                place_group(tree, &ranges[i]);
        }
    }
    tree->waiting = 0;
}

void dmi_top_tree_settle(dmi_top_tree* tree) {
    if (tree->levels > DMI_TOP_MOST_LEVELS) dmi_top_tree_rebuild(tree);
}
