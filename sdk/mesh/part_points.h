/* The surface points of a part and of the body near it that the motion network reads. */
#ifndef DMI_MESH_PART_POINTS_H
#define DMI_MESH_PART_POINTS_H

#include "mesh/cloud.h"

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
