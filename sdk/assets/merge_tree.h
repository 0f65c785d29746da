/* Merges the nodes of an asset, the likeliest to be one body first, into ever larger sets, which are candidates for
 * bodies, and rates each set. */
#ifndef DMI_ASSETS_MERGE_TREE_H
#define DMI_ASSETS_MERGE_TREE_H

#include "assets/asset_models.h"
#include "assets/set_features.h"

/* ---- numbers by which a pair of nodes is told to be one body ---- */

#define DMI_PAIR_FEATURES 50

/* Takes scratch from the arena, and rewinds it. The order of a and b does not count. */
dm_result dmi_pair_features_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_asset_facts* facts, uint32_t a,
                                 uint32_t b, float out[DMI_PAIR_FEATURES]);

/* ---- tree ---- */

typedef struct dmi_node_pair {
    uint32_t a, b;     /* a < b */
    float probability; /* that both are one body */
    float weight;      /* weight of their contact */
} dmi_node_pair;

typedef struct dmi_merge_tree {
    const dmi_node_cells* grid;
    dmi_asset_facts facts;
    dmi_node_pair* pairs;
    uint32_t pair_count;
    /* sets 0 .. node_count - 1 are the nodes; each later one is the union of two earlier ones */
    uint32_t set_count;
    uint32_t (*children)[2]; /* UINT32_MAX: a node */
    float* link;             /* mean probability at which it was merged; 1: a node */
    uint32_t* first;         /* set s has members[first[s]] .. members[first[s] + size[s] - 1], rising */
    uint32_t *size, *members;
} dmi_merge_tree;

/* Lists the pairs of nodes that may be of one body: those that touch, and each node's nearest. */
dm_result dmi_node_pairs_list(dmi_arena* arena, const dmi_node_cells* grid, dmi_node_pair** out_pairs,
                              uint32_t* out_count);
/* models NULL: pairs that touch are merged by the share of their contact. */
dm_result dmi_merge_tree_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_node_labels* labels,
                              const dmi_asset_models* models, const dmi_progress* progress, dmi_merge_tree* out);
/* Computes the links of all sets, as dmi_set_features_make takes them. out: set_count of them. */
dm_result dmi_merge_tree_links(dmi_arena* arena, const dmi_merge_tree* tree, dmi_set_links* out);

/* ---- context (set_ratings.c): what the other sets of the asset say of a set ---- */

/* Most assets have something that moves, and few have many unlike parts. */
#define DMI_CONTEXT_FEATURES 17

/* Computes the numbers of all sets. links: of the tree's sets; moves: probability of each by its own features. All
 * memory comes from the arena. */
dm_result dmi_set_context_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links,
                               const float* moves, float (*out)[DMI_CONTEXT_FEATURES]);

/* ---- ratings (set_ratings.c): how likely each set is a body that moves ---- */

#define DMI_RATED_FEATURES (DMI_SET_FEATURES + DMI_CONTEXT_FEATURES)

typedef struct dmi_set_ratings {
    float (*features)[DMI_RATED_FEATURES]; /* each set's own features, then those of its context in the last round */
    float* moves;                          /* probability of each set after the last round */
} dmi_set_ratings;

/* rounds: how many times the sets are rated in view of each other, up to DMI_CONTEXT_ROUNDS. All memory comes from the
 * arena. */
dm_result dmi_set_ratings_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_asset_models* models, int rounds,
                               const dmi_progress* progress, dmi_set_ratings* out);

#endif
