/* URIs of buffers and images. */
#ifndef DMI_MESH_GLTF_URI_H
#define DMI_MESH_GLTF_URI_H

#include "mesh/gltf/gltf_problem.h"

int dmi_uri_is_data(const char* uri);
/* Decodes a base64 data: URI into new memory of `out_size` bytes. */
dm_result dmi_uri_decode(dmi_env* env, const char* uri, dmi_gltf_problem* problem, uint8_t** out, uint64_t* out_size);
/* Writes the path of a file beside the document, percent signs decoded; `path` has room for strlen(uri) + 1. Refuses
 * whatever may lead elsewhere: absolute paths, "..", "\", schemes. */
dm_result dmi_uri_to_path(const char* uri, dmi_gltf_problem* problem, char* path);

#endif
