/* What an object keeps of its mesh once it is prepared: no more than its trees read and the rest is computed from. */
#ifndef DMI_MESH_PACKED_MESH_H
#define DMI_MESH_PACKED_MESH_H

#include "base/progress.h"
#include "mesh/mesh.h"

#define DMI_POSITION_PADDING 16     /* readable bytes from any vertex on: Embree and vector code load four floats */
#define DMI_NARROW_VERTICES 0x10000 /* most vertices that 16 bits can name */

typedef struct dmi_packed_part {
    uint32_t first_face, face_count;
    uint32_t solid_count; /* triangles with an area, in the numbers that the trees see; they come first */
} dmi_packed_part;

/* Faces are in the order of their parts; within a part, those with an area first, else as in the mesh. */
typedef struct dmi_packed_mesh {
    float* positions;  /* vertex_count x 3, object-normalised, DMI_POSITION_PADDING bytes behind them */
    uint16_t* narrow;  /* face_count x 3 corners, or NULL */
    uint32_t* wide;    /* the same where `narrow` is NULL: for many vertices, and for Embree */
    uint32_t* of_mesh; /* which face of the mesh each is; NULL: the same one */
    dmi_packed_part* parts;
    uint32_t vertex_count, face_count, part_count;
} dmi_packed_mesh;

/* Numbers to pack, in the order of the mesh. */
typedef struct dmi_unpacked {
    const float* positions;
    const uint32_t *indices, *face_part;
    uint32_t vertex_count, face_count, part_count;
} dmi_unpacked;

dmi_unpacked dmi_unpacked_of(const dmi_mesh* mesh);
/* wide: corners of 32 bits, however few vertices there are. progress: may be NULL. */
dm_result dmi_packed_mesh_create(dmi_env* env, const dmi_unpacked* from, bool wide, const dmi_progress* progress,
                                 dmi_packed_mesh** out_packed);
/* NULL does nothing. */
void dmi_packed_mesh_destroy(dmi_env* env, dmi_packed_mesh* packed);
/* Fills indices and face_part of a mesh that dmi_mesh_restore made, and its positions. */
void dmi_packed_mesh_unpack(const dmi_packed_mesh* packed, dmi_mesh* mesh);

static inline uint32_t dmi_packed_corner(const dmi_packed_mesh* packed, uint32_t face, int i) {
    const size_t at = (size_t)face * 3 + (size_t)i;
    return packed->narrow != NULL ? packed->narrow[at] : packed->wide[at];
}

/* The face of the mesh. */
static inline uint32_t dmi_packed_of_mesh(const dmi_packed_mesh* packed, uint32_t face) {
    return packed->of_mesh != NULL ? packed->of_mesh[face] : face;
}

#endif
