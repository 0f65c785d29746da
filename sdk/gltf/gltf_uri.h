/* URIs of buffers and images. */
#ifndef DMI_GLTF_URI_H
#define DMI_GLTF_URI_H

#include "gltf/gltf_problem.h"

/* What messages show of a URI: its first 80 bytes at most, and "…" where that is not all. */
typedef struct dmi_uri_excerpt {
    char text[84];
} dmi_uri_excerpt;
dmi_uri_excerpt dmi_uri_shorten(const char* uri);

/* Returns whether the scheme is data:, in any case of letters (RFC 3986, section 3.1). */
int dmi_uri_is_data(const char* uri);
/* Decodes a base64 data: URI into new memory of `out_size` bytes. */
dm_result dmi_uri_decode(dmi_env* env, const char* uri, dmi_gltf_problem* problem, uint8_t** out, uint64_t* out_size);
/* Writes the path of a file beside the document, percent signs decoded. `path` has room for strlen(uri) + 1. The
 * function refuses whatever may lead elsewhere: absolute paths, "..", "\", schemes, and %00, where a path in C would
 * end. */
dm_result dmi_uri_to_path(const char* uri, dmi_gltf_problem* problem, char* path);

#endif
