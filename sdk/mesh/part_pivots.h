/* Measures the parts of a mesh about their pivots. */
#ifndef DMI_MESH_PART_PIVOTS_H
#define DMI_MESH_PART_PIVOTS_H

#include "mesh/mesh_data.h"
#include "mesh/pivot_rule.h"

/* pivots: one a part of the mesh, host frame; NULL: it has none, and does not count. scratch: one a part. */
void dmi_part_pivots_measure(const dmi_mesh* mesh, const dm_pivot* const* pivots, dmi_pivot_gauge* scratch,
                             dmi_pivot_witness* out);

#endif
