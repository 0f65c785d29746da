/* Makes whole assets of the generator's objects: several nodes a body, fixed hardware, things that look like parts and
 * stay, objects in which nothing moves, names, hierarchies and pivots as exporters leave them. */
#ifndef DMG_ASSET_H
#define DMG_ASSET_H

#include "generator.h"

#ifdef __cplusplus
extern "C" {
#endif

#define DMG_NO_NODE UINT32_MAX
#define DMG_NO_PART UINT32_MAX

typedef struct dmg_asset_node {
    char name[64], mesh_name[64]; /* UTF-8. No two nodes have one name, unless it is "" */
    uint32_t parent;              /* the node above it; DMG_NO_NODE: none */
    uint32_t face_count;          /* 0: an empty node, which groups others */
    uint32_t part;       /* 0 = stays, i = joints[i - 1] moves it; of an empty node, the part that it groups, or
                            DMG_NO_PART */
    uint32_t mesh;       /* nodes with one number are instances: their local positions are equal, up to
                            rounding. Of an empty node DMG_NO_NODE */
    int32_t loose;       /* 1: lies on what carries it, and may be taken away */
    float transform[16]; /* node to scene, column-major: a rotation, one scale and the pivot */
} dmg_asset_node;

typedef struct dmg_asset {
    dmg_object object;   /* vertices in the scene's frame. No vertex is of two nodes. joint_count 0: nothing moves */
    uint32_t* face_node; /* face_count: the node that holds the face */
    dmg_asset_node* nodes;
    uint32_t node_count;
} dmg_asset;

/* Makes an asset. category, seed and flags are those of dmg_make, whose object it begins with. Same category id, seed
 * and flags: the same bits. Returns 0 on success. Release with dmg_asset_release. */
int dmg_make_asset(uint32_t category, uint64_t seed, uint32_t flags, dmg_asset* out_asset);
void dmg_asset_release(dmg_asset* asset);

#ifdef __cplusplus
}
#endif

#endif
