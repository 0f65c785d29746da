/* Generated assets as sdk/assets sees them, drawn for training. */
#ifndef DM_LAB_ASSET_DRAW_H
#define DM_LAB_ASSET_DRAW_H

#include "asset.h"
#include "assets/asset_grouping.h"
#include "assets/node_cells.h"
#include "assets/node_labels.h"
#include "dragmesh_lab.h"

typedef struct dm_lab_drawn_asset {
    dmi_env* env;
    dmg_asset asset;
    dmi_mesh* mesh;
    dmi_arena arena;
    dmi_asset_node* nodes;
    uint32_t *of_part, *unit_node, *body; /* body of each unit; 0: it stays */
    uint32_t unit_count;
    bool use_names;
    dmi_node_labels labels;
    dmi_node_cells cells;
} dm_lab_drawn_asset;

/* Makes the `index`-th asset of the options' stream. Close after success. */
dm_result dm_lab_open_asset(dmi_env* env, const dm_lab_options* options, uint32_t index, dm_lab_drawn_asset* out);
void dm_lab_close_asset(dm_lab_drawn_asset* out);

/* Describes the mesh, with a part a node: node i has the id i + 1. The ids are of the asset's arena. */
dm_result dm_lab_describe_mesh(dm_lab_drawn_asset* asset, dm_mesh_desc* out);

#endif
