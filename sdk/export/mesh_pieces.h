/* Pieces of a mesh: the faces that hang together over their vertices, once those in one place are one, and whether each
 * piece closes a volume. */
#ifndef DMI_EXPORT_MESH_PIECES_H
#define DMI_EXPORT_MESH_PIECES_H

#include "export/rig_model.h"

typedef struct dmi_mesh_pieces {
    uint32_t* faces;  /* piece of each face */
    uint8_t* is_open; /* per piece: 1 when it has an edge at which not one face goes each way */
    uint32_t count;
} dmi_mesh_pieces;

/* Finds the pieces, in memory of the model. */
dm_result dmi_find_pieces(dmi_rig_model* model, const dmi_rig_mesh* mesh, dmi_mesh_pieces* out);

#endif
