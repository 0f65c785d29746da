/* The prepared object as bytes (.dmo): versioned, checksummed, little-endian. Layout: blob_format.h. */
#ifndef DMI_OBJECT_DMO_H
#define DMI_OBJECT_DMO_H

#include "kinematics/object/object.h"

size_t dmi_dmo_size(const dmi_object* object);
/* out: dmi_dmo_size bytes. */
void dmi_dmo_write(const dmi_object* object, uint8_t* out);
/* Trusts nothing: whatever the bytes, the answer is a valid object, BAD_DATA or VERSION. `axes` are those of the host
 * that loads, which need not be those of the host that saved. */
dm_result dmi_dmo_read(dmi_env* env, dmi_picker* picker, const dmi_axes* axes, const void* data, size_t size,
                       dmi_object** out_object);

#endif
