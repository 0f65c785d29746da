/* The prepared object as bytes (.dmo): versioned, checksummed, little-endian. Layout: blob_format.h. */
#ifndef DMI_KINEMATICS_BLOB_H
#define DMI_KINEMATICS_BLOB_H

#include "kinematics/object.h"

size_t dmi_object_blob_size(const dmi_object* object);
/* out: dmi_object_blob_size bytes. */
void dmi_object_to_blob(const dmi_object* object, uint8_t* out);
/* Trusts nothing: whatever the bytes, the answer is a valid object, BAD_DATA or VERSION. `axes` are those of the host
 * that loads, which need not be those of the host that saved. */
dm_result dmi_object_from_blob(dmi_env* env, dmi_picker* picker, const dmi_axes* axes, const void* data, size_t size,
                               dmi_object** out_object);

#endif
