/* Materials of primitives. */
#ifndef DMI_GLTF_SURFACE_H
#define DMI_GLTF_SURFACE_H

#include "gltf/gltf_file.h"

/* Returns the primitive's material, and writes its base colour. Without a material it returns NULL and writes white. */
const cJSON* dmi_gltf_material_of(const dm_gltf* gltf, const cJSON* primitive, float out_colour[4]);

#endif
