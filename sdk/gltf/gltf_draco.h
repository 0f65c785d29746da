/* KHR_draco_mesh_compression, decoded by the library Draco. A build without it has DMI_NO_DRACO. No C++ exception
 * leaves these functions. */
#ifndef DMI_GLTF_DRACO_H
#define DMI_GLTF_DRACO_H

#include <stddef.h>

#include "dragmesh/dragmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

#define DMI_DRACO_NAME "KHR_draco_mesh_compression"

typedef struct dmi_draco dmi_draco; /* a decoded mesh */

/* Returns whether this build can decode. */
int dmi_draco_available(void);
/* Decodes a mesh that has at most these points and faces by its own account. `reason` gets what is wrong. */
dm_result dmi_draco_open(const void* data, size_t size, uint32_t most_points, uint32_t most_faces, char* reason,
                         size_t reason_size, dmi_draco** out);
void dmi_draco_close(dmi_draco* mesh);
uint32_t dmi_draco_points(const dmi_draco* mesh);
uint32_t dmi_draco_faces(const dmi_draco* mesh);
/* Writes three points a face. */
void dmi_draco_read_faces(const dmi_draco* mesh, uint32_t* out);
/* Returns the components of the attribute with that unique id, or 0 when there is none. */
uint32_t dmi_draco_components(const dmi_draco* mesh, uint32_t id);
/* Writes the values as component type `type` of glTF, component after component, point after point. Returns 0 when the
 * mesh cannot give them. */
int dmi_draco_read(const dmi_draco* mesh, uint32_t id, int type, void* out);

#ifdef __cplusplus
}
#endif

#endif
