/* The GLB of a rigged asset. */
#ifndef DMI_MESH_EXPORT_RIG_GLB_H
#define DMI_MESH_EXPORT_RIG_GLB_H

#include "mesh/export/rig_model.h"

/* Writes desc->scene again with joints, masses and collision boxes, into memory of the model's host. */
dm_result dmi_rig_write_glb(dmi_rig_model* model, void** out_data, size_t* out_size);

#endif
