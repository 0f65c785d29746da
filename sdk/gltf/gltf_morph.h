/* Morph targets, in the weights that they have at rest. */
#ifndef DMI_GLTF_MORPH_H
#define DMI_GLTF_MORPH_H

#include "gltf/gltf_file.h"

/* Vertices of a primitive, as they lie in its mesh. */
typedef struct dmi_gltf_morphed {
    const cJSON* primitive;
    const cJSON* weights; /* one number a target; NULL: all are 0 */
    const char* place;
    const uint32_t* elements; /* per vertex: its position in the accessors */
    float* positions;         /* 3 a vertex */
    uint64_t count;
} dmi_gltf_morphed;

/* Gives each node whose weights differ from those of another node with the same mesh a copy of the mesh. */
dm_result dmi_gltf_part_morphs(dm_gltf* gltf, dmi_gltf_problem* problem);
/* Returns the weights that a node has at rest, or NULL when all are 0. */
const cJSON* dmi_gltf_weights_of(const dm_gltf* gltf, const cJSON* node);
/* Returns whether the primitive has targets for the weights. */
int dmi_gltf_is_morphed(const cJSON* primitive, const cJSON* weights);
/* Moves the vertices by the targets. A target that cannot be read is left out with a warning. */
dm_result dmi_gltf_morph(dm_gltf* gltf, const dmi_gltf_morphed* morphed, dmi_gltf_problem* problem);

#endif
