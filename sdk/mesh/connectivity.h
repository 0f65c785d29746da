/* Connectivity of faces: vertices welded by position, smooth regions, shells and sheets. */
#ifndef DMI_MESH_CONNECTIVITY_H
#define DMI_MESH_CONNECTIVITY_H

#include "base/arena.h"
#include "base/progress.h"
#include "mesh/mesh.h"

/* out_welded[v] = the smallest vertex within `tolerance` of v that stands for itself, or v. Vertices in a row, each
 * within the tolerance of the next, need not all become one. progress: may be NULL. */
dm_result dmi_weld_vertices(dmi_arena* arena, const dmi_mesh* mesh, float tolerance, const dmi_progress* progress,
                            uint32_t* out_welded);

/* Labels 0.. of the faces for which select[f] is non-zero (others get UINT32_MAX): connected over shared welded edges
 * where the unsigned cosine between their normals is above `min_cosine`; min_cosine < -1: shells connected over
 * vertices. progress: may be NULL, here and below. */
dm_result dmi_face_regions(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const uint8_t* select,
                           float min_cosine, const dmi_progress* progress, uint32_t* out_labels, uint32_t* out_count);

/* Labels 0.. of all faces: connected over welded edges at which just two sheets of surface meet. Faces in the same
 * place (double-sided meshes) count as one. Pieces that merely touch, at a vertex or an edge, stay apart. */
dm_result dmi_face_sheets(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const dmi_progress* progress,
                          uint32_t* out_labels, uint32_t* out_count);
/* The same, but an edge at which 32 sheets or more meet divides nothing: all its faces are of one sheet. */
dm_result dmi_face_sheets_and_fans(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded,
                                   const dmi_progress* progress, uint32_t* out_labels, uint32_t* out_count);
/* dmi_face_sheets, cut also where the surface bends inwards by more than the angle with this sine, seen from outside.
 */
dm_result dmi_face_bulges(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, float concave_sine,
                          const dmi_progress* progress, uint32_t* out_labels, uint32_t* out_count);

#endif
