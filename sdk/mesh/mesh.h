/* A checked, object-normalised copy of the host's mesh with its parts. */
#ifndef DMI_MESH_MESH_H
#define DMI_MESH_MESH_H

#include "base/progress.h"
#include "mesh/mesh_data.h"

/* Checks everything dragmesh.h promises and names what is wrong and where. `parts` may be NULL: then every id that owns
 * a triangle is a part; with a list, ids that are not in it are the body's.
 * progress: may be NULL; with one, CANCELLED as well. */
dm_result dmi_mesh_create(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc, const dm_part_desc* parts,
                          uint32_t part_count, const dmi_progress* progress, dmi_mesh** out_mesh);
/* A mesh to look for parts in: desc->part_ids may be NULL (then all is one piece), and parts may be empty, cover
 * everything, or have no area. parts[0] has the faces of id 0. progress: may be NULL. */
dm_result dmi_mesh_create_pieces(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc,
                                 const dmi_progress* progress, dmi_mesh** out_mesh);
/* The same where the ids per face are 0 to piece_count: parts[i] has the faces of id i, and may be empty. */
dm_result dmi_mesh_create_numbered(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc, uint32_t piece_count,
                                   const dmi_progress* progress, dmi_mesh** out_mesh);
void dmi_mesh_destroy(dmi_env* env, dmi_mesh* mesh);

/* A mesh from a file: room, whose positions, indices, face_part and parts (id, parent, face_count) the caller fills, …
 */
dm_result dmi_mesh_restore(dmi_env* env, const dmi_frame* frame, uint32_t vertex_count, uint32_t face_count,
                           uint32_t part_count, dmi_mesh** out_mesh);
/* … and then areas, normals, boxes and centres, to the bits that dmi_mesh_create made of the same numbers. progress:
 * may be NULL. */
dm_result dmi_mesh_measure(dmi_env* env, const dmi_progress* progress, dmi_mesh* mesh);
/* Boxes, areas and centres of the parts alone, from face_part and the faces' areas. */
dm_result dmi_mesh_measure_parts(dmi_env* env, dmi_mesh* mesh);

#endif
