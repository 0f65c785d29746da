/* Buffers of a document, and views of them. */
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

#endif
