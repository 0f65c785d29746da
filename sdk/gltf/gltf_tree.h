/* The tree of nodes of a parsed file. */
#ifndef DMI_GLTF_TREE_H
#define DMI_GLTF_TREE_H

#include "gltf/gltf_file.h"
#include "gltf/gltf_matrix.h"

/* Fills tree and order, except what gltf_roles.h finds. Refuses nodes with two parents; nodes of a cycle are not
 * placed. */
dm_result dmi_gltf_read_tree(dm_gltf* gltf, dmi_gltf_problem* problem);

/* Writes the column-major matrix of a node, relative to its parent. */
void dmi_gltf_local_matrix(const cJSON* node, double out[16]);

#endif
