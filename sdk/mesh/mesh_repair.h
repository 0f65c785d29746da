/* A part's mask as it was meant: patches lost and leaked by painters and segmenters, put back. */
#ifndef DMI_MESH_MESH_REPAIR_H
#define DMI_MESH_MESH_REPAIR_H

#include "base/arena.h"
#include "mesh/mesh.h"

/* out_mended: the mesh with, where anything can be mended, its own face_part and parts, in the arena; all else is the
 * mesh's. A piece of surface (a
 * sheet, then a smooth region) that belongs to one part but for a small share of its area belongs to it whole, unless
 * a part would lose more of its own area and of its own triangles by that than an error explains: a lid of a one-piece
 * box stays a lid.
 * welded: from dmi_weld_vertices. */
dm_result dmi_mesh_repair(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, dmi_mesh* out_mended);

#endif
