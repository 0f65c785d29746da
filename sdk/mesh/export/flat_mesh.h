/* Meshes that lie in one plane. */
#ifndef DMI_MESH_EXPORT_FLAT_MESH_H
#define DMI_MESH_EXPORT_FLAT_MESH_H

#include "mesh/export/rig_model.h"

/* Lifts a corner of a mesh that lies in one plane by a millionth of its size: MuJoCo 3 refuses meshes without a volume,
 * also those that nothing collides with. */
void dmi_lift_corner(dmi_rig_mesh* mesh);

#endif
