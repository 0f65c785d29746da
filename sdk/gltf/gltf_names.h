/* Finds nodes by the names that a caller gives. */
#ifndef DMI_GLTF_NAMES_H
#define DMI_GLTF_NAMES_H

#include "gltf/gltf_file.h"

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

#endif
