/* Buffers of a document, views of them, and the URIs of buffers and images (gltf_uri.c). */
#ifndef DMI_GLTF_BUFFERS_H
#define DMI_GLTF_BUFFERS_H

#include "gltf/gltf_file.h"
#include "gltf/gltf_problem.h"

/* ---- the parts of a .glb or .gltf file ---- */

typedef struct dmi_gltf_container {
    const char* json;
    size_t json_size;
    const uint8_t* bin; /* NULL: none */
    size_t bin_size;
} dmi_gltf_container;

/* Checks header and chunk sizes. The parts point into `data`. */
dm_result dmi_gltf_split(const uint8_t* data, size_t size, dmi_gltf_problem* problem, dmi_gltf_container* out);

/* ---- buffers ---- */

/* Bytes of a view, decompressed. stride 0: packed. */
typedef struct dmi_gltf_view {
    const uint8_t* data;
    uint64_t size, stride;
} dmi_gltf_view;

/* Copies the binary chunk, decodes embedded buffers and asks the host for files. */
dm_result dmi_gltf_read_buffers(dm_gltf* gltf, const dmi_gltf_container* from, dmi_gltf_problem* problem);
void dmi_gltf_release_buffers(dm_gltf* gltf);
/* Finds the bytes of a data: URI, or of a file beside the document. dmi_gltf_release_buffers gives them back. */
dm_result dmi_gltf_open_uri(dm_gltf* gltf, const char* uri, dmi_gltf_problem* problem, dmi_gltf_buffer* out);

/* Checks that the view lies in its buffer. */
dm_result dmi_gltf_find_view(dm_gltf* gltf, double index, const char* place, dmi_gltf_problem* problem,
                             dmi_gltf_view* out);
/* Finds the bytes of a view as they lie in the file, compressed. */
dm_result dmi_gltf_find_stored(dm_gltf* gltf, const cJSON* view, const char* place, dmi_gltf_problem* problem,
                               dmi_gltf_view* out);

/* ---- URIs ---- */

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
