/* EXT_mesh_gpu_instancing: a node whose mesh stands in many places. */
#ifndef DMI_GLTF_INSTANCING_H
#define DMI_GLTF_INSTANCING_H

#include "gltf/gltf_file.h"

#define DMI_INSTANCING_NAME "EXT_mesh_gpu_instancing"

/* Replaces instances by nodes of their own, behind all nodes of the file. Each is called as the node that had them,
 * with a dot and a number from 0 on, and hangs below it. Where the instances cannot be read, one is left, with a
 * warning. */
dm_result dmi_gltf_unroll_instances(dm_gltf* gltf, dmi_gltf_problem* problem);

#endif
