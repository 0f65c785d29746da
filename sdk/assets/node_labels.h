/* What the asset says of its nodes beside their shape: names, and the tree that they stand in. */
#ifndef DMI_ASSETS_NODE_LABELS_H
#define DMI_ASSETS_NODE_LABELS_H

#include <stdbool.h>

#include "base/arena.h"
#include "base/env.h"
#include "kinematics/hints/part_kind.h"

typedef struct dmi_asset_node dmi_asset_node;

/* What a name says, as rows of features have it. */
enum { DMI_NAME_SILENT = 0, DMI_NAME_OBJECT = 1, DMI_NAME_PART = 2, DMI_NAME_GRIP = 3, DMI_NAME_CLASSES = 4 };

typedef struct dmi_node_labels {
    const dmi_asset_node* nodes;
    uint32_t unit_count;       /* things with geometry: nodes, or nodes that are one body for certain */
    const uint32_t* unit_node; /* unit -> the node that names it */
    uint8_t* name;             /* unit -> DMI_NAME_* */
    uint8_t* kind;             /* unit -> dmi_part_kind */
    uint32_t* stem;            /* unit -> the first unit whose name is the same up to numbers; without a name: itself */
    uint32_t* units_below;     /* node -> units at it or below it */
    float told;                /* share of the units whose names say that they are parts */
    bool has_tree;             /* some node carries a part of the units, not all */
} dmi_node_labels;

/* Returns whether a kind is one of parts that move, not of objects. */
bool dmi_kind_is_part(dmi_part_kind kind);

/* use_names: false, names are not read and the tree is not either. All memory comes from the arena; nodes and
 * unit_node must outlive `out`. */
dm_result dmi_node_labels_make(dmi_arena* arena, const dmi_asset_node* nodes, uint32_t node_count,
                               const uint32_t* unit_node, uint32_t unit_count, bool use_names, dmi_node_labels* out);

/* Returns how many units stand at or below the lowest node that is above all of the given units (or is theirs);
 * unit_count where there is none. */
uint32_t dmi_units_of_group(const dmi_node_labels* labels, const uint32_t* units, uint32_t count);
/* Returns whether unit a's node stands below unit b's. */
bool dmi_unit_is_below(const dmi_node_labels* labels, uint32_t a, uint32_t b);

/* ---- order of nodes: those above come first ---- */

/* Writes all nodes, each after the one that above[node] names; DM_ASSET_NO_NODE: none. Returns DM_ASSET_NO_NODE, or a
 * node that is above itself. done: a byte a node, scratch. */
uint32_t dmi_asset_order_nodes(const uint32_t* above, uint32_t count, uint32_t* out_order, uint8_t* done);

#endif
