/* The parts of a .glb or .gltf file. */
#ifndef DMI_GLTF_CONTAINER_H
#define DMI_GLTF_CONTAINER_H

#include "gltf/gltf_problem.h"

typedef struct dmi_gltf_container {
    const char* json;
    size_t json_size;
    const uint8_t* bin; /* NULL: none */
    size_t bin_size;
} dmi_gltf_container;

/* Checks header and chunk sizes. The parts point into `data`. */
dm_result dmi_gltf_split(const uint8_t* data, size_t size, dmi_gltf_problem* problem, dmi_gltf_container* out);

#endif
