/* Copies of a primitive with vertices of its own. */
#ifndef DMI_GLTF_COPY_H
#define DMI_GLTF_COPY_H

#include "gltf/gltf_edit.h"

/* Vertices and triangles of a copy. */
typedef struct dmi_copy {
    const cJSON* from;        /* the primitive in the file */
    const uint32_t* elements; /* per vertex: its position in the primitive's accessors */
    const uint32_t* vertices; /* per vertex: its position in the merged mesh */
    uint32_t* corners;        /* corners of the triangles, as vertices of the copy */
    uint64_t vertex_count, face_count;
    const double* placed; /* matrix that placed the vertices in the merged mesh, from which the copy takes them without
                             bones; NULL: it stays in the mesh's frame */
} dmi_copy;

/* Copies a primitive. Returns the new one, or NULL after a failure. */
cJSON* dmi_copy_primitive(dmi_edit* e, const dmi_copy* copy);

#endif
