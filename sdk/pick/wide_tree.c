/* Builds the portable backend's tree from the top down: a range of triangles is split into up to eight, the largest one
 * first, and each of these becomes a node or a block. */
#include "pick/wide_tree.h"

#include <math.h>
#include <string.h>

#include "base/env.h"
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
    dmi_wide_tree* tree; /* its arrays are scratch memory */
    uint32_t node_capacity, block_capacity;
    uint32_t placed; /* triangles in blocks */
    uint32_t told;   /* items placed at the last report */
    bool cancelled;
} builder;

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
        const float *a = dmi_triangle_corner(t, f, 0), *b = dmi_triangle_corner(t, f, 1),
                    *c = dmi_triangle_corner(t, f, 2);
        items[f].id = f;
        items[f].unused = 0;
        for (int k = 0; k < 3; k++) {
            items[f].low[k] = least(least(a[k], b[k]), c[k]);
            items[f].high[k] = most(most(a[k], b[k]), c[k]);
        }
    }
    return true;
}

/* Copies elements, and reports. False when it is cancelled. */
static bool copy_array(builder* b, const void* from, uint32_t count, size_t size, void* to) {
    for (uint32_t first = 0; first < count && !b->cancelled; first += DMI_PROGRESS_STEP) {
        const uint32_t step = count - first < DMI_PROGRESS_STEP ? count - first : DMI_PROGRESS_STEP;
        memcpy((uint8_t*)to + first * size, (const uint8_t*)from + first * size, step * size);
        if (step == DMI_PROGRESS_STEP) tell(b);
    }
    return !b->cancelled;
}

/* Makes room for one more element; false without memory, and when it is cancelled. */
static bool reserve(builder* b, void** array, uint32_t used, uint32_t* capacity, size_t size) {
    if (used < *capacity) return true;
    const uint32_t wanted = *capacity + *capacity / 2 + 1;
    void* moved = dmi_scratch_alloc(b->env, wanted * size);
    if (moved == NULL || !copy_array(b, *array, used, size, moved)) {
        dmi_scratch_free(b->env, moved);
        return false;
    }
    dmi_scratch_free(b->env, *array);
    *array = moved;
    *capacity = wanted;
    return true;
}

static void fill_block(const builder* b, const dmi_box_range* range, dmi_triangle_block* block) {
    for (uint32_t i = 0; i < DMI_BLOCK; i++) {
        const bool used = i < range->count;
        dmi_block_set(b->triangles, block, i, b->items[range->first + (used ? i : 0)].id, used);
    }
}

static void set_child(dmi_wide_node* node, uint32_t slot, const dmi_box* box, uint32_t reference) {
    dmi_wide_node_set_box(node, slot, box);
    node->child[slot] = reference;
}

static bool make_leaf(builder* b, uint32_t node, uint32_t slot, const dmi_box_range* range) {
    dmi_wide_tree* tree = b->tree;
    if (!reserve(b, (void**)&tree->blocks, tree->block_count, &b->block_capacity, sizeof *tree->blocks)) return false;
    fill_block(b, range, &tree->blocks[tree->block_count]);
    set_child(&tree->nodes[node], slot, &range->box, DMI_LEAF | tree->block_count++);
    b->placed += range->count;
    return b->placed - b->told < DMI_PROGRESS_STEP || tell(b);
}

/* Makes the node of a range, its leaves, and work of its larger children. */
static bool make_node(builder* b, const pending* work) {
    dmi_wide_tree* tree = b->tree;
    if (!reserve(b, (void**)&tree->nodes, tree->node_count, &b->node_capacity, sizeof *tree->nodes)) return false;
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

bool dmi_wide_tree_allocate(dmi_env* env, uint32_t nodes, uint32_t blocks, dmi_wide_tree* out_tree) {
    *out_tree = (dmi_wide_tree){.node_count = nodes, .block_count = blocks};
    out_tree->nodes = dmi_alloc(env, nodes * sizeof *out_tree->nodes, DMI_ALIGNMENT);
    out_tree->blocks = dmi_alloc(env, blocks * sizeof *out_tree->blocks, DMI_ALIGNMENT);
    if (out_tree->nodes != NULL && out_tree->blocks != NULL) return true;
    dmi_wide_tree_release(env, out_tree);
    return false;
}

/* Moves the tree from scratch memory into as much as it needs. */
static bool settle(builder* b, dmi_wide_tree* out_tree) {
    const dmi_wide_tree* built = b->tree;
    if (!dmi_wide_tree_allocate(b->env, built->node_count, built->block_count, out_tree)) return false;
    if (copy_array(b, built->nodes, built->node_count, sizeof *built->nodes, out_tree->nodes) &&
        copy_array(b, built->blocks, built->block_count, sizeof *built->blocks, out_tree->blocks))
        return true;
    dmi_wide_tree_release(b->env, out_tree);
    return false;
}

dm_result dmi_wide_tree_build(dmi_env* env, const dmi_triangles* triangles, dmi_wide_tree* out_tree) {
    const uint32_t faces = triangles->face_count;
    dmi_wide_tree tree = {0};
    builder b = {.env = env, .triangles = triangles, .tree = &tree};
    b.block_capacity = faces / FACES_PER_BLOCK + 1;
    b.node_capacity = b.block_capacity / BLOCKS_PER_NODE + 1;
    b.items = dmi_scratch_alloc(env, faces * sizeof *b.items);
    b.stack = dmi_scratch_alloc(env, (size_t)MOST_PENDING * sizeof *b.stack);
    tree.nodes = dmi_scratch_alloc(env, b.node_capacity * sizeof *tree.nodes);
    tree.blocks = dmi_scratch_alloc(env, b.block_capacity * sizeof *tree.blocks);
    const bool room = b.items != NULL && b.stack != NULL && tree.nodes != NULL && tree.blocks != NULL;
    const bool made = room && make_items(&b) && make_nodes(&b) && settle(&b, out_tree);
    dmi_scratch_free(env, b.items);
    dmi_scratch_free(env, b.stack);
    dmi_scratch_free(env, tree.nodes);
    dmi_scratch_free(env, tree.blocks);
    if (made) return DM_OK;
    if (b.cancelled) return DM_ERROR_CANCELLED;
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick among %u triangles", faces);
}

void dmi_wide_tree_release(dmi_env* env, dmi_wide_tree* tree) {
    dmi_free(env, tree->nodes, tree->node_count * sizeof *tree->nodes);
    dmi_free(env, tree->blocks, tree->block_count * sizeof *tree->blocks);
    *tree = (dmi_wide_tree){0};
}
