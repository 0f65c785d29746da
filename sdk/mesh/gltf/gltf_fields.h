/* What the fields of a document may hold. */
#ifndef DMI_MESH_GLTF_FIELDS_H
#define DMI_MESH_GLTF_FIELDS_H

#include "mesh/gltf/gltf_document.h"

/* Checks the fields that this library reads without a question: whether an index is one, a list of numbers is as long
 * as glTF has it, a name is text, and an object is one. BAD_DATA names the field, what it must be and what it is. What
 * else may be wrong with counts, sizes and offsets is refused where they are read. */
dm_result dmi_gltf_check_fields(const dmi_gltf_document* document, dmi_gltf_problem* problem);

#endif
