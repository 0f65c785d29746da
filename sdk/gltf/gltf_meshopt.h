/* EXT_meshopt_compression and KHR_meshopt_compression, decoded by the library meshoptimizer. A build without it has
 * DMI_NO_MESHOPT. */
#ifndef DMI_GLTF_MESHOPT_H
#define DMI_GLTF_MESHOPT_H

#include "gltf/gltf_document.h"

/* A compressed buffer view. */
typedef struct dmi_meshopt_view {
    const uint8_t* data;
    uint64_t size;
    uint64_t count, stride; /* number and size of the elements that come out */
    const char *mode, *filter;
} dmi_meshopt_view;

/* Returns whether this build can decode. */
int dmi_meshopt_available(void);
/* Returns whether `name` is that of one of the two extensions. */
int dmi_meshopt_is_name(const char* name);
/* Returns the extension of a buffer view, or of a buffer, or NULL when it has none. */
const cJSON* dmi_meshopt_of(const cJSON* object);
/* Returns which of the names the extension of the object has. */
const char* dmi_meshopt_name_of(const cJSON* object);
/* Checks mode, stride and filter, and that the sizes are possible, before memory is taken for the elements. */
dm_result dmi_meshopt_check(const dmi_meshopt_view* view, const char* place, dmi_gltf_problem* problem);
/* Writes count * stride bytes of a view that was checked. */
dm_result dmi_meshopt_decode(const dmi_meshopt_view* view, const char* place, dmi_gltf_problem* problem, uint8_t* out);

#endif
