/* Normals that are smooth over round surfaces and sharp at edges. */
#ifndef CLI_SMOOTH_H
#define CLI_SMOOTH_H

#include "dragmesh/dragmesh.h"
#include "vec.h"

typedef struct smooth_normals {
    const float* positions;
    const uint32_t* indices;
    uint32_t* welded; /* a vertex: the first vertex at the same position */
    uint32_t* first;  /* a welded vertex: where its faces begin in `faces`; one more at the end */
    uint32_t* faces;
    vec* normals; /* a face: normal times twice the area */
} smooth_normals;

smooth_normals smooth_build(const dm_mesh_desc* mesh);
void smooth_free(smooth_normals* smooth);
/* Unit normal at a point of a face; u, v weigh its second and third corner. */
vec smooth_at(const smooth_normals* smooth, uint32_t face, double u, double v);

#endif
