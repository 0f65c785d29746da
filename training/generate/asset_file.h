/* Declares the files of an asset: object.glb, a scene of nodes, and asset.json, which says what moves in it. */
#ifndef GENERATE_ASSET_FILE_H
#define GENERATE_ASSET_FILE_H

#include <stddef.h>
#include <stdint.h>

#include "asset.h"

/* Returns the bytes of a .glb with a node for each of the asset's, meshes shared by instances; NULL without memory. */
void* asset_glb(const dmg_asset* asset, size_t* out_size);
/* Returns asset.json: its nodes' labels, and the parts with joints, carriers and limits relative to the file's pose;
 * NULL without memory. */
char* asset_json(const dmg_asset* asset, uint64_t seed, uint32_t flags);

#endif
