/* Reads the host's strided buffers in any format, with the checks that need no mesh yet, and its parts. */
#ifndef DMI_MESH_MESH_READ_H
#define DMI_MESH_MESH_READ_H

#include "base/env.h"
#include "mesh/mesh.h"

/* A dm_mesh_desc with checked pointers, formats, strides and counts; only part_ids may still be NULL. */
typedef struct dmi_mesh_reader {
    const dm_mesh_desc* desc;
    size_t position_stride, index_size, part_id_stride; /* bytes */
    uint32_t vertex_count, face_count;
} dmi_mesh_reader;

dm_result dmi_mesh_reader_open(dmi_env* env, const dm_mesh_desc* desc, dmi_mesh_reader* out_reader);

/* All corners, face after face; an index that names no vertex is an error. */
dm_result dmi_mesh_read_indices(dmi_env* env, const dmi_mesh_reader* reader, uint32_t* out_indices);
/* DM_ERROR_NOT_FINITE names the first vertex with a coordinate that is no number or does not fit a float. */
dm_result dmi_mesh_check_positions(dmi_env* env, const dmi_mesh_reader* reader);
void dmi_mesh_read_position(const dmi_mesh_reader* reader, uint32_t vertex, double out[3]);
/* Part id of a vertex or a face, as desc->part_id_scope says; negative ones are the body's 0. */
uint32_t dmi_mesh_read_part_id(const dmi_mesh_reader* reader, uint32_t element);

/* ---- which part each face belongs to, and the tree of parts (mesh_parts.c) ---- */

/* Fills mesh->parts (id, parent, face_count), part_count and face_part. The mesh's indices must be there. On an error
 * dmi_mesh_destroy still releases what was made. descs NULL: every id that owns a triangle is a part of the body. */
dm_result dmi_mesh_assign_parts(dmi_env* env, const dmi_mesh_reader* reader, const dm_part_desc* descs,
                                uint32_t desc_count, dmi_mesh* mesh);
/* The same by whatever ids there are: part ids may be NULL, and no face or every face may be the body's. */
dm_result dmi_mesh_assign_pieces(dmi_env* env, const dmi_mesh_reader* reader, dmi_mesh* mesh);
/* The same where the ids per face are 0 to piece_count: id i is part i, also when no face has it. */
dm_result dmi_mesh_assign_numbered(dmi_env* env, const dmi_mesh_reader* reader, uint32_t piece_count, dmi_mesh* mesh);

#endif
