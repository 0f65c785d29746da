/* The portable backend's tree: nodes of eight boxes over blocks of four triangles. */
#ifndef DMI_PICK_WIDE_TREE_H
#define DMI_PICK_WIDE_TREE_H

#include "base/cpu.h"
#include "pick/backend.h"
#include "pick/wide_node.h"

#define DMI_BLOCK 4 /* triangles of a leaf: one register of SSE or NEON */
/* Levels of nodes. The builder halves ranges from DMI_FREE_LEVELS on, and 2^32 triangles can be halved 32 times. */
#define DMI_FREE_LEVELS 24 /* by hand: real meshes take up to 12 */
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
    uint32_t node_count, block_count, node_capacity, block_capacity;
    dmi_wide_trace* trace; /* of the machine's instruction set */
};

dm_result dmi_wide_tree_build(dmi_env* env, const dmi_triangles* triangles, dmi_wide_tree* out_tree);
void dmi_wide_tree_release(dmi_env* env, dmi_wide_tree* tree);

/* First hit, with the same bits from each. */
dmi_wide_trace dmi_wide_trace_plain;
#if defined(__x86_64__)
dmi_wide_trace dmi_wide_trace_avx2;
#endif

#endif
