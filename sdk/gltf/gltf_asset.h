/* The scene as a list of nodes of an asset. */
#ifndef DMI_GLTF_ASSET_H
#define DMI_GLTF_ASSET_H

#include "gltf/gltf_file.h"

/* The answer of dm_gltf_get_asset. Its memory is the arena's. */
struct dmi_gltf_asset {
    dmi_arena arena;
    dm_asset_node* nodes; /* first the dm_gltf_nodes, then groups, then what follows others */
    uint32_t* file_nodes; /* index of each in the file */
    uint32_t count;
    uint32_t* places; /* per node of the file: its first place in `nodes`; DM_ASSET_NO_NODE: it is not there */
};

/* Frees the asset of a file, where one was asked for. */
void dmi_gltf_release_asset(dm_gltf* gltf);

#endif
