/* Vertices and triangles of a primitive, wherever the file keeps them. */
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

#endif
