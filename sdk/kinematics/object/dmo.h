/* The prepared object as bytes (.dmo): versioned, checksummed, little-endian. dmo_format.h describes the layout. */
#ifndef DMI_OBJECT_DMO_H
#define DMI_OBJECT_DMO_H

#include "kinematics/object/object.h"

/* Returns the number of bytes that dmi_dmo_write writes. trees: those of its triangles (dmi_object_stored_trees); NULL:
 * none. */
size_t dmi_dmo_size(const dmi_object* object, const dmi_bvh* trees);
void dmi_dmo_write(const dmi_object* object, const dmi_bvh* trees, uint8_t* out);
/* Reads bytes from any source, and checks all of them. Returns a valid object, DM_ERROR_BAD_DATA or DM_ERROR_VERSION.
 * axes: those of the host that loads, which need not be those of the host that saved. progress: may be NULL. */
dm_result dmi_dmo_read(dmi_env* env, dmi_picker* picker, const dmi_axes* axes, const void* data, size_t size,
                       const dmi_progress* progress, dmi_object** out_object);

#endif
