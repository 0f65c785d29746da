/* Which part each face belongs to, and the tree of parts. */
#ifndef DMI_MESH_MESH_PARTS_H
#define DMI_MESH_MESH_PARTS_H

#include "base/env.h"
#include "mesh/mesh_data.h"
#include "mesh/mesh_read.h"

/* Fills mesh->parts (id, parent, face_count), part_count and face_part. The mesh's indices must be there. On an error
 * dmi_mesh_destroy still releases what was made. descs NULL: every id that owns a triangle is a part of the body. */
dm_result dmi_mesh_assign_parts(dmi_env* env, const dmi_mesh_reader* reader, const dm_part_desc* descs,
                                uint32_t desc_count, dmi_mesh* mesh);
/* The same by whatever ids there are: part ids may be NULL, and no face or every face may be the body's. */
dm_result dmi_mesh_assign_pieces(dmi_env* env, const dmi_mesh_reader* reader, dmi_mesh* mesh);
/* The same where the ids per face are 0 to piece_count: id i is part i, also when no face has it. */
dm_result dmi_mesh_assign_numbered(dmi_env* env, const dmi_mesh_reader* reader, uint32_t piece_count, dmi_mesh* mesh);

#endif
