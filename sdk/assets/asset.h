/* A whole asset: which of its nodes move, as one or apart, how, and what carries them. */
#ifndef DMI_ASSETS_ASSET_H
#define DMI_ASSETS_ASSET_H

#include "assets/asset_grouping.h"
#include "assets/asset_mesh.h"
#include "assets/body_hints.h"
#include "kinematics/object/prepare.h"

typedef struct dmi_asset_desc {
    const dmi_axes* axes;
    const dm_asset_node* nodes; /* checked structs of this version, with accepted joints; parents form no circle */
    uint32_t node_count;
    dmi_asset_mesh* mesh; /* the nodes' mesh; its part ids are overwritten */
    dmi_inference_models models;
    dmi_object_labels labels;
    uint64_t seed;
    float min_moves; /* probability from which on a part moves */
    bool use_clips, use_names;
    bool mesh_is_incomplete;      /* DM_PREPARE_MESH_INCOMPLETE */
    const dmi_progress* progress; /* hears of what is left of the call */
} dmi_asset_desc;

typedef struct dmi_asset_part {
    uint32_t carrier;                /* index of the part that carries it, or DMI_ASSET_BODY */
    uint32_t first_node, node_count; /* range of dmi_asset.nodes */
    int32_t state;                   /* DM_ASSET_STAYS … */
    float moves;
    dmi_asset_given given;
} dmi_asset_part;

typedef struct dmi_asset {
    dmi_asset_part* parts;
    uint32_t *part_of_node, *nodes; /* part of each node, or DMI_ASSET_BODY; the nodes of parts, part after part */
    uint32_t part_count, node_count, triangle_count;
    uint32_t warnings;  /* DM_ASSET_CLIP_LEFT_OUT */
    dmi_object* object; /* holds all parts, also those that stay: part i has the id i + 1. NULL: no part may move */
} dmi_asset;

/* Finds the parts of an asset. The result has the same bits for any number of workers behind env->jobs. */
dm_result dmi_asset_create(dmi_env* env, dmi_picker* picker, const dmi_asset_desc* desc, dmi_asset** out_asset);
/* NULL: does nothing. */
void dmi_asset_destroy(dmi_env* env, dmi_asset* asset);

/* Makes an object of the parts that move. EMPTY_MASK: none does. */
dm_result dmi_asset_make_object(dmi_env* env, dmi_picker* picker, const dmi_asset* asset, bool keep_triangles,
                                dmi_object** out_object);

#endif
