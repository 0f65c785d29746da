/* What the fields of a document may hold. */
#ifndef DMI_GLTF_FIELDS_H
#define DMI_GLTF_FIELDS_H

#include "gltf/gltf_document.h"

/* Checks the fields that this library reads without another check: an index must be one, a list of numbers as long as
 * glTF has it, a name text, and an object an object. Answers BAD_DATA, with the field, what it must be and what it is.
 * Other faults of counts, sizes and offsets are refused where these are read. */
dm_result dmi_gltf_check_fields(const dmi_gltf_document* document, dmi_gltf_problem* problem);

#endif
