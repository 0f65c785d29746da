/* Meshes that lie in one plane. */
#ifndef DMI_EXPORT_FLAT_MESH_H
#define DMI_EXPORT_FLAT_MESH_H

#include "export/rig_model.h"

/* Lifts a corner of a mesh that lies in one plane by a millionth of its size, or by what a volume of 2e-14 m³ takes,
 * but not by more than `most`. MuJoCo 3 refuses meshes without a volume, also those that nothing collides with. */
void dmi_lift_corner(dmi_rig_mesh* mesh, double most);
/* Returns whether the mesh has fewer than the four points that MuJoCo 3 asks for. Writes one that makes a second side
 * for a face, with its first two corners. */
bool dmi_find_fourth_point(const dmi_rig_mesh* mesh, uint32_t* out_face, float out_point[3]);

#endif
