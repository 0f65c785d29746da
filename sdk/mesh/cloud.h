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

/* ---- the points of a cloud that the motion network reads: of a part and of the body near it ---- */

#define DMI_PART_POINTS 64           /* half are of the part, a quarter near it, a quarter of the whole body */
#define DMI_PART_POINT_UNIT 0x1p-16f /* object sizes; by hand: a surface lies within 0.5 */

/* Coordinates in DMI_PART_POINT_UNIT; inner frame. A prepared object and one that is loaded have the same. */
typedef struct dmi_part_points {
    int16_t at[DMI_PART_POINTS][3];
} dmi_part_points;

/* Rounds points 0, step, 2 step … to the unit. What lies farther out than 0.5 is drawn in. */
void dmi_part_points_take(const float (*xyz)[3], size_t step, dmi_part_points* out);
/* Writes the points as object-normalised coordinates. */
void dmi_part_points_place(const dmi_part_points* points, float out_xyz[DMI_PART_POINTS][3]);
/* Takes the points that a cloud keeps for the motion network. */
void dmi_part_points_of_cloud(const dmi_cloud* cloud, dmi_part_points* out);

#endif
