/* EXT_meshopt_compression and KHR_meshopt_compression, decoded by the library meshoptimizer. A build without it has
 * DMI_NO_MESHOPT. */
#ifndef DMI_MESH_GLTF_MESHOPT_H
#define DMI_MESH_GLTF_MESHOPT_H

#include "mesh/gltf/gltf_json.h"

/* A compressed buffer view. */
typedef struct dmi_meshopt_view {
    const uint8_t* data;
    uint64_t size;
    uint64_t count, stride; /* of the elements that come out */
    const char *mode, *filter;
} dmi_meshopt_view;

/* Whether this build can decode. */
int dmi_meshopt_available(void);
/* Whether `name` is that of one of the two extensions. */
int dmi_meshopt_is_name(const char* name);
/* The extension of a buffer view, or of a buffer; NULL: it has none. */
const cJSON* dmi_meshopt_of(const cJSON* object);
/* Which of the names the extension of the object has. */
const char* dmi_meshopt_name_of(const cJSON* object);
/* Checks mode, stride and filter, and that the sizes are possible, before memory is taken for the elements. */
dm_result dmi_meshopt_check(const dmi_meshopt_view* view, const char* place, dmi_gltf_problem* problem);
/* Writes count * stride bytes of a view that was checked. */
dm_result dmi_meshopt_decode(const dmi_meshopt_view* view, const char* place, dmi_gltf_problem* problem, uint8_t* out);

#endif
