/* Repairs part masks: returns patches that painters and segmenters lost or leaked. */
#ifndef DMI_MESH_MESH_REPAIR_H
#define DMI_MESH_MESH_REPAIR_H

#include "base/arena.h"
#include "mesh/mesh.h"

/* A piece of surface (a sheet, then a smooth region) that belongs to one part but for a small share of its area is
 * given to it whole, unless another part would lose more of its own area and triangles by that than an error explains:
 * a lid of a one-piece box stays a lid. out_repaired: the mesh with its own face_part and parts, in the arena, where
 * anything was repaired; all else is the mesh's. welded: from dmi_weld_vertices. progress: may be
 * NULL. */
dm_result dmi_mesh_repair(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const dmi_progress* progress,
                          dmi_mesh* out_repaired);

#endif
