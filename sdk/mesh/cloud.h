/* Surface samples of one part and of the rest: the input of the networks and of the geometric analysis.
 *
 * Area-weighted and seeded. The moving part gets half of the points however thin it is; a quarter lies on the body
 * near the part, a quarter anywhere on the body. Training uses this very code (bindings/python). */
#ifndef DMI_MESH_CLOUD_H
#define DMI_MESH_CLOUD_H

#include "mesh/mesh.h"

#define DMI_CLOUD_PART 2048 /* points on the moving part and the parts it carries */
/* Points on the rest, inside the part's box grown by 0.2 of its diagonal (at least 0.02). */
#define DMI_CLOUD_NEAR 1024
#define DMI_CLOUD_BODY 1024 /* anywhere on the rest */
/* The points come in the order part, near, body. Within a block they are in low-discrepancy order, so that its first
 * ones cover it. */
#define DMI_CLOUD_POINTS 4096

typedef struct dmi_cloud {
    float xyz[DMI_CLOUD_POINTS][3];    /* object-normalised */
    float normal[DMI_CLOUD_POINTS][3]; /* unit, as the triangle's winding gives it */
} dmi_cloud;

/* Samples part `part` (index in mesh->parts, not 0). When the rest has no triangle near the part, the near block holds
 * the rest's samples nearest to it; when there is no rest, both other blocks repeat the part's. Never fails for a mesh
 * that dmi_mesh_create accepted, but for memory. */
dm_result dmi_cloud_sample(dmi_env* env, const dmi_mesh* mesh, uint32_t part, uint64_t seed, dmi_cloud* out_cloud);

#endif
