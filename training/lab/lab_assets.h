/* Declares the cases that the models of whole assets are fitted on: pairs of nodes, and sets of nodes, of generated
 * assets. */
#ifndef DM_LAB_ASSETS_H
#define DM_LAB_ASSETS_H

#include "dragmesh_lab.h"

typedef struct dm_lab_asset_rows {
    uint32_t capacity; /* rows; a call that would need more answers TOO_LARGE */
    float* features;   /* x capacity x columns */
    float* target;     /* x capacity: pairs: 1, both nodes are of one body; sets: overlap with a body that moves */
    int32_t* children; /* sets: x capacity x 2: rows of the two sets that make this one, or -1; pairs: NULL */
    uint32_t* first;   /* x options->count + 1: asset i has the rows first[i] .. first[i + 1] - 1 */
    uint32_t* movers;  /* x options->count: bodies that move */
} dm_lab_asset_rows;

DM_API uint32_t dm_lab_asset_pair_columns(void);
DM_API uint32_t dm_lab_asset_set_columns(void);
/* Returns how many of a set's columns, the last, tell of the asset's other sets. */
DM_API uint32_t dm_lab_asset_context_columns(void);
/* options: seed, count, split, categories and messy are read. */
DM_API dm_result dm_lab_asset_pairs(const dm_lab_options* options, const dm_lab_asset_rows* out);
/* weights: bytes of a file of architecture dragmesh-asset-parts, whose trees of pairs merge the nodes, and whose trees
 * of sets give the last columns, after as many rounds (1 or more) as are wanted. */
DM_API dm_result dm_lab_asset_sets(const dm_lab_options* options, const void* weights, size_t weights_size,
                                   uint32_t rounds, const dm_lab_asset_rows* out);

#endif
