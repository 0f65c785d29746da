/* Copies of a primitive with vertices of its own. */
#ifndef DMI_MESH_GLTF_COPY_H
#define DMI_MESH_GLTF_COPY_H

#include "mesh/gltf/gltf_edit.h"

/* Vertices and triangles of a copy. */
typedef struct dmi_copy {
    const cJSON* from;        /* the primitive in the file */
    const uint32_t* elements; /* of a vertex: its position in the primitive's accessors */
    const uint32_t* vertices; /* of a vertex: its position in the merged mesh */
    uint32_t* corners;        /* of vertices of the copy */
    uint64_t vertex_count, face_count;
    const double* placed; /* the matrix that placed the vertices in the merged mesh, which the copy takes from there,
                             without bones; NULL: it stays in the mesh's frame */
} dmi_copy;

/* Returns the new primitive; NULL: failed. */
cJSON* dmi_copy_primitive(dmi_edit* e, const dmi_copy* copy);

#endif
