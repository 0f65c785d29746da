/* The portable backend's tree: nodes of eight boxes over blocks of four triangles. */
#ifndef DMI_PICK_WIDE_TREE_H
#define DMI_PICK_WIDE_TREE_H

#include "base/cpu.h"
#include "pick/backend.h"
#include "pick/box_split.h"

#define DMI_BLOCK 4 /* triangles of a leaf: one register of SSE or NEON */
/* Levels of nodes. The builder halves ranges from DMI_FREE_LEVELS on, and 2^32 triangles can be halved 32 times. */
#define DMI_FREE_LEVELS 24 /* levels to spare; by hand: real meshes take up to 12 */
#define DMI_MOST_LEVELS (DMI_FREE_LEVELS + 32)

typedef struct dmi_triangle_block {
    _Alignas(16) float corner[3][3][DMI_BLOCK]; /* [corner][axis]; unused triangles: a point */
    uint32_t face[DMI_BLOCK];
} dmi_triangle_block;

typedef struct dmi_wide_tree dmi_wide_tree;
typedef bool dmi_wide_trace(const dmi_wide_tree* tree, const dmi_part_ray* ray, dmi_part_hit* out_hit);

struct dmi_wide_tree {
    dmi_wide_node* nodes; /* [0] is the root */
    dmi_triangle_block* blocks;
    uint32_t node_count, block_count;
    dmi_wide_trace* trace; /* the trace of the machine's instruction set */
};

dm_result dmi_wide_tree_build(dmi_env* env, const dmi_triangles* triangles, dmi_wide_tree* out_tree);
/* Makes the tree that the shape is of, to the bits that were built. Checks all of the shape: BAD_DATA, without a
 * message, where it is none of these triangles. */
dm_result dmi_wide_tree_restore(dmi_env* env, const dmi_triangles* triangles, const dmi_tree_shape* shape,
                                dmi_wide_tree* out_tree);
dmi_tree_shape dmi_wide_tree_shape(const dmi_wide_tree* tree);
void dmi_wide_tree_release(dmi_env* env, dmi_wide_tree* tree);
/* Room for so many nodes and blocks; false where there is none. */
bool dmi_wide_tree_allocate(dmi_env* env, uint32_t nodes, uint32_t blocks, dmi_wide_tree* out_tree);

static inline const float* dmi_triangle_corner(const dmi_triangles* t, uint32_t face, int i) {
    const size_t at = (size_t)face * 3 + (size_t)i;
    return t->positions + (size_t)(t->narrow != NULL ? t->narrow[at] : t->wide[at]) * 3;
}

/* Sets slot `i` of a block; not used: a point of the block's first face. */
static inline void dmi_block_set(const dmi_triangles* t, dmi_triangle_block* block, uint32_t i, uint32_t face,
                                 bool used) {
    block->face[i] = face;
    for (int c = 0; c < 3; c++) {
        const float* p = dmi_triangle_corner(t, face, used ? c : 0);
        for (int k = 0; k < 3; k++) block->corner[c][k][i] = p[k];
    }
}

/* First hit, with the same bits from each. */
dmi_wide_trace dmi_wide_trace_plain;
#if defined(__x86_64__)
dmi_wide_trace dmi_wide_trace_avx2;
#endif

#endif
