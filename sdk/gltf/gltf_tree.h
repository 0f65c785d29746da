/* The tree of nodes of a parsed file, with nodes made of instances (gltf_instancing.c), and what each node is there for
 * (gltf_roles.c). */
#ifndef DMI_GLTF_TREE_H
#define DMI_GLTF_TREE_H

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

#endif
