/* One mesh of all nodes of an asset, in the asset frame. */
#ifndef DMI_ASSETS_ASSET_MESH_H
#define DMI_ASSETS_ASSET_MESH_H

#include <stdbool.h>

#include "base/progress.h"

typedef struct dmi_asset_mesh {
    double* positions; /* vertex_count x 3 */
    uint32_t* indices; /* face_count x 3; those of mirrored nodes wound the other way round, so that fronts stay out */
    uint32_t* face_id; /* index of the node + 1 */
    uint32_t vertex_count, face_count;
    float size; /* largest side of the box, host units */
} dmi_asset_mesh;

/* Returns whether a node's mesh counts: it has one, and does not follow another node. */
bool dmi_asset_node_counts(const dm_asset_node* node);
/* Returns the node that a node follows; DM_ASSET_NO_NODE: it follows none, or the scene. */
uint32_t dmi_asset_followed(const dm_asset_node* node);

/* Merges the meshes that count, node after node. nodes: of this version, with checked mesh descriptors. Errors name the
 * node. On an error, out is to be released as well. */
dm_result dmi_asset_mesh_merge(dmi_env* env, const dm_asset_node* nodes, uint32_t node_count,
                               const dmi_progress* progress, dmi_asset_mesh* out);
void dmi_asset_mesh_release(dmi_env* env, dmi_asset_mesh* mesh);

/* Describes the mesh, with face_id as part ids. */
dm_mesh_desc dmi_asset_mesh_describe(const dmi_asset_mesh* mesh);

#endif
