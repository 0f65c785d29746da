/* Builds the portable backend's tree from the top down: a range of triangles is split into up to eight, the largest one
 * first, and each of these becomes a node or a block. */
#include "pick/wide_tree.h"

#include <math.h>
#include <string.h>

#include "base/kept.h"
#include "pick/box_split.h"

/* Ranges that wait at once: up to DMI_WIDE from each level. */
#define MOST_PENDING (DMI_WIDE * DMI_MOST_LEVELS)
/* First guesses of the counts, which grow; measured on meshes of 1,000 to 1,000,000 triangles. */
#define FACES_PER_BLOCK 3
#define BLOCKS_PER_NODE 6

typedef struct pending {
    dmi_box_range range;
    uint32_t parent, slot, level;
} pending;

typedef struct builder {
    dmi_env* env;
    const dmi_triangles* triangles;
    dmi_box_item* items;
    pending* stack;
    uint32_t waiting;
    dmi_wide_tree* tree;
    uint32_t placed; /* triangles in blocks */
    uint32_t told;   /* of them, at the last report */
    bool cancelled;
} builder;

static const float* corner(const dmi_triangles* t, uint32_t face, int i) {
    return t->positions + (size_t)t->faces[face].corner[i] * 3;
}

/* fminf and fmaxf are calls. */
static float least(float a, float b) {
    return a < b ? a : b;
}

static float most(float a, float b) {
    return a > b ? a : b;
}

/* Tells that so many triangles are in blocks. Returns whether to go on. */
static bool tell(builder* b) {
    b->told = b->placed;
    b->cancelled =
        dmi_progress_tell(b->triangles->progress, (float)b->placed / (float)b->triangles->face_count) != DM_OK;
    return !b->cancelled;
}

static bool make_items(builder* b) {
    const dmi_triangles* t = b->triangles;
    dmi_box_item* items = b->items;
    for (uint32_t f = 0; f < t->face_count; f++) {
        if (f % DMI_PROGRESS_STEP == DMI_PROGRESS_STEP - 1 && !tell(b)) return false;
        const float *a = corner(t, f, 0), *b = corner(t, f, 1), *c = corner(t, f, 2);
        items[f].id = f;
        items[f].unused = 0;
        for (int k = 0; k < 3; k++) {
            items[f].low[k] = least(least(a[k], b[k]), c[k]);
            items[f].high[k] = most(most(a[k], b[k]), c[k]);
        }
    }
    return true;
}

/* Moves `used` elements to an array of another capacity. False without memory, and when it is cancelled. */
static bool move_array(builder* b, void** array, uint32_t used, uint32_t* capacity, uint32_t wanted, size_t size) {
    uint8_t* moved = dmi_alloc(b->env, wanted * size, DMI_ALIGNMENT);
    if (moved == NULL) return false;
    for (uint32_t first = 0; first < used && !b->cancelled; first += DMI_PROGRESS_STEP) {
        const uint32_t count = used - first < DMI_PROGRESS_STEP ? used - first : DMI_PROGRESS_STEP;
        memcpy(moved + first * size, (uint8_t*)*array + first * size, count * size);
        if (count == DMI_PROGRESS_STEP) tell(b);
    }
    if (b->cancelled) {
        dmi_free(b->env, moved, wanted * size);
        return false;
    }
    dmi_free(b->env, *array, *capacity * size);
    *array = moved;
    *capacity = wanted;
    return true;
}

/* Makes room for one more element; false without memory. */
static bool reserve(builder* b, void** array, uint32_t used, uint32_t* capacity, size_t size) {
    return used < *capacity || move_array(b, array, used, capacity, *capacity + *capacity / 2 + 1, size);
}

/* Gives back what was reserved beyond `used`; without memory for the copy it stays. False when it is cancelled. */
static bool trim(builder* b, void** array, uint32_t used, uint32_t* capacity, size_t size) {
    return used == *capacity || move_array(b, array, used, capacity, used, size) || !b->cancelled;
}

static void fill_block(const builder* b, const dmi_box_range* range, dmi_triangle_block* block) {
    const dmi_triangles* t = b->triangles;
    for (uint32_t i = 0; i < DMI_BLOCK; i++) {
        const bool used = i < range->count;
        const uint32_t face = b->items[range->first + (used ? i : 0)].id;
        block->face[i] = face;
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++) block->corner[c][k][i] = corner(t, face, used ? c : 0)[k];
    }
}

static void set_child(dmi_wide_node* node, uint32_t slot, const dmi_box* box, uint32_t reference) {
    dmi_wide_node_set_box(node, slot, box);
    node->child[slot] = reference;
}

static bool make_leaf(builder* b, uint32_t node, uint32_t slot, const dmi_box_range* range) {
    dmi_wide_tree* tree = b->tree;
    if (!reserve(b, (void**)&tree->blocks, tree->block_count, &tree->block_capacity, sizeof *tree->blocks))
        return false;
    fill_block(b, range, &tree->blocks[tree->block_count]);
    set_child(&tree->nodes[node], slot, &range->box, DMI_LEAF | tree->block_count++);
    b->placed += range->count;
    return b->placed - b->told < DMI_PROGRESS_STEP || tell(b);
}

/* Makes the node of a range, its leaves, and work of its larger children. */
static bool make_node(builder* b, const pending* work) {
    dmi_wide_tree* tree = b->tree;
    if (!reserve(b, (void**)&tree->nodes, tree->node_count, &tree->node_capacity, sizeof *tree->nodes)) return false;
    const uint32_t index = tree->node_count++;
    if (index > 0) tree->nodes[work->parent].child[work->slot] = index;
    dmi_box_range ranges[DMI_WIDE];
    ranges[0] = work->range;
    const float done = (float)b->placed / (float)b->triangles->face_count;
    const dmi_progress progress = dmi_progress_piece(b->triangles->progress, done, done);
    const uint32_t count =
        dmi_box_split_up(b->items, DMI_BLOCK, work->level >= DMI_FREE_LEVELS ? DMI_SPLIT_IN_HALVES : DMI_SPLIT_BY_COST,
                         ranges, DMI_WIDE, &progress);
    b->cancelled = count == 0;
    if (b->cancelled) return false;
    static const dmi_box inside_out = {{INFINITY, INFINITY, INFINITY, 0}, {-INFINITY, -INFINITY, -INFINITY, 0}};
    for (uint32_t i = 0; i < DMI_WIDE; i++) {
        if (i >= count) {
            set_child(&tree->nodes[index], i, &inside_out, 0);
        } else if (ranges[i].count > DMI_BLOCK) {
            set_child(&tree->nodes[index], i, &ranges[i].box, 0);
            b->stack[b->waiting++] = (pending){ranges[i], index, i, work->level + 1};
        } else if (!make_leaf(b, index, i, &ranges[i])) {
            return false;
        }
    }
    return true;
}

static bool make_nodes(builder* b) {
    pending work = {.range = {.first = 0, .count = b->triangles->face_count}};
    dmi_box_range_measure(b->items, &work.range);
    b->waiting = 0;
    for (;;) {
        if (!make_node(b, &work)) return false;
        if (b->waiting == 0) return true;
        work = b->stack[--b->waiting];
    }
}

dm_result dmi_wide_tree_build(dmi_env* env, const dmi_triangles* triangles, dmi_wide_tree* out_tree) {
    const uint32_t faces = triangles->face_count;
    dmi_wide_tree tree = {0};
    builder b = {.env = env, .triangles = triangles, .tree = &tree};
    tree.block_capacity = faces / FACES_PER_BLOCK + 1;
    tree.node_capacity = tree.block_capacity / BLOCKS_PER_NODE + 1;
    b.items = dmi_scratch_alloc(env, faces * sizeof *b.items);
    b.stack = dmi_scratch_alloc(env, (size_t)MOST_PENDING * sizeof *b.stack);
    tree.nodes = dmi_alloc(env, tree.node_capacity * sizeof *tree.nodes, DMI_ALIGNMENT);
    tree.blocks = dmi_alloc(env, tree.block_capacity * sizeof *tree.blocks, DMI_ALIGNMENT);
    bool made = b.items != NULL && b.stack != NULL && tree.nodes != NULL && tree.blocks != NULL;
    if (made) made = make_items(&b) && make_nodes(&b);
    dmi_scratch_free(env, b.items);
    dmi_scratch_free(env, b.stack);
    if (made) {
        made = trim(&b, (void**)&tree.nodes, tree.node_count, &tree.node_capacity, sizeof *tree.nodes) &&
               trim(&b, (void**)&tree.blocks, tree.block_count, &tree.block_capacity, sizeof *tree.blocks);
    }
    *out_tree = tree;
    if (made) return DM_OK;
    dmi_wide_tree_release(env, out_tree);
    if (b.cancelled) return DM_ERROR_CANCELLED;
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick among %u triangles", faces);
}

void dmi_wide_tree_release(dmi_env* env, dmi_wide_tree* tree) {
    dmi_free(env, tree->nodes, tree->node_capacity * sizeof *tree->nodes);
    dmi_free(env, tree->blocks, tree->block_capacity * sizeof *tree->blocks);
    *tree = (dmi_wide_tree){0};
}
