/* Vertices and triangles of a primitive, wherever the file keeps them, and its morph targets (gltf_morph.c). */
#ifndef DMI_GLTF_GEOMETRY_H
#define DMI_GLTF_GEOMETRY_H

#include "gltf/gltf_accessor.h"

/* Most sets of JOINTS_n and WEIGHTS_n, four bones a vertex each; files have one or two. */
#define DMI_GLTF_JOINT_SETS 4

typedef struct dmi_gltf_geometry {
    int32_t mode;    /* DMI_GLTF_TRIANGLES … */
    int32_t indexed; /* else every vertex is a corner */
    dmi_gltf_elements positions, indices;
    uint32_t joint_sets;
    dmi_gltf_elements joints[DMI_GLTF_JOINT_SETS], weights[DMI_GLTF_JOINT_SETS];
    /* Primitives with the same keys share their vertices. `key` is below dmi_gltf_key_count. */
    uint32_t key;
    double joint_key;
} dmi_gltf_geometry;

/* Finds the geometry of a primitive and checks it, except the values of indices and positions. */
dm_result dmi_gltf_find_geometry(dm_gltf* gltf, const cJSON* primitive, const char* place, dmi_gltf_problem* problem,
                                 dmi_gltf_geometry* out);
uint32_t dmi_gltf_key_count(const dm_gltf* gltf);
/* Returns the key that find_geometry would give, or dmi_gltf_key_count when there is none. */
uint32_t dmi_gltf_key(const dm_gltf* gltf, const cJSON* primitive);

/* Returns the Draco extension of a primitive that this build decodes, or NULL when its accessors hold the data. */
const cJSON* dmi_gltf_draco_of(const dm_gltf* gltf, const cJSON* primitive);
/* Finds the elements of an attribute of a Draco primitive, as its accessor describes them. name: NULL for the
 * indices. */
dm_result dmi_gltf_find_in_draco(dm_gltf* gltf, const cJSON* primitive, const char* attribute, const char* place,
                                 dmi_gltf_problem* problem, dmi_gltf_elements* out);

/* Frees what compressed views hold, and their list. */
void dmi_gltf_release_decoded(dm_gltf* gltf);

/* ---- morph targets, in the weights that they have at rest ---- */

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
