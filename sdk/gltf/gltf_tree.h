/* The tree of nodes of a parsed file: nodes made of instances (gltf_instancing.c), the names that find them, what each
 * node is there for (gltf_roles.c), and what the file says of it beside its mesh (gltf_hints.c). */
#ifndef DMI_GLTF_TREE_H
#define DMI_GLTF_TREE_H

#include <stdbool.h>

#include "gltf/gltf_file.h"
#include "gltf/gltf_matrix.h"

/* Fills tree and order, except what gltf_roles.c finds. Refuses nodes with two parents; nodes of a cycle are not
 * placed. */
dm_result dmi_gltf_read_tree(dm_gltf* gltf, dmi_gltf_problem* problem);

/* Writes the column-major matrix of a node, relative to its parent. */
void dmi_gltf_local_matrix(const cJSON* node, double out[16]);

/* Fills `shown` of all nodes, and `follows` of those with a mesh that are in the scene and not shown. The names must be
 * sorted. Levels of detail are those of MSFT_lod, and siblings that are named so (door_LOD0, door_LOD1); the finest is
 * shown. */
dm_result dmi_gltf_find_roles(dm_gltf* gltf, dmi_gltf_problem* problem);

#define DMI_INSTANCING_NAME "EXT_mesh_gpu_instancing"

/* Replaces instances by nodes of their own, behind all nodes of the file. Each is called as the node that had them,
 * with a dot and a number from 0 on, and hangs below it. Where the instances cannot be read, one is left, with a
 * warning. */
dm_result dmi_gltf_unroll_instances(dm_gltf* gltf, dmi_gltf_problem* problem);

/* ---- names ---- */

/* Nodes of one name, in the file's order. */
typedef struct dmi_gltf_namesakes {
    const dmi_gltf_name* first;
    uint32_t count;
} dmi_gltf_namesakes;

/* Sorts the names of the tree's nodes. */
dm_result dmi_gltf_sort_names(dm_gltf* gltf, dmi_gltf_problem* problem);
/* Finds the nodes of this name, which may be no valid UTF-8. "#12" is node 12 of the file, unless a node is really
 * called so. */
dmi_gltf_namesakes dmi_gltf_find_nodes(const dm_gltf* gltf, const char* name);

/* ---- what the file says of a node ---- */

/* Returns the name of a node's mesh, or "" when it has none. */
const char* dmi_gltf_mesh_name(const dm_gltf* gltf, const dmi_gltf_tree_node* node);
/* Copies origin and axes from the node's transform to the scene, as the merged mesh has them. Returns false, and zeros,
 * where no float holds them. */
bool dmi_gltf_write_pivot(const dm_gltf* gltf, const double world[16], dm_pivot* out);
/* Judges the pivots of all nodes that have triangles: after these are merged. */
dm_result dmi_gltf_judge_pivots(dm_gltf* gltf, dmi_gltf_problem* problem);

#endif
