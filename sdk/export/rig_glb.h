/* The GLB of a rigged asset. */
#ifndef DMI_EXPORT_RIG_GLB_H
#define DMI_EXPORT_RIG_GLB_H

#include "export/rig_model.h"

/* Writes the file of the model's nodes with an animation, joints, masses and collision boxes, into memory of the host.
 * The root is not the only body. */
dm_result dmi_rig_write_glb(dmi_rig_model* model, void** out_data, size_t* out_size);

#endif
