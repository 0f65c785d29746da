/* Finds what of the scene is no body of its own: hidden nodes, shapes for collisions, coarser levels of detail. */
#ifndef DMI_GLTF_ROLES_H
#define DMI_GLTF_ROLES_H

#include "gltf/gltf_file.h"

/* Fills `shown` of all nodes, and `follows` of those with a mesh that are in the scene and not shown. The names must be
 * sorted. Levels of detail are those of MSFT_lod, and siblings that are named so (door_LOD0, door_LOD1); the finest is
 * shown. */
dm_result dmi_gltf_find_roles(dm_gltf* gltf, dmi_gltf_problem* problem);

#endif
