/* Reads what the host's descriptors say of the asset: labels, pivots, the up direction. */
#ifndef DMI_OBJECT_PART_HINTS_H
#define DMI_OBJECT_PART_HINTS_H

#include "kinematics/object/object.h"

/* What an object's descriptor says of all its parts. */
typedef struct dmi_object_labels {
    const char* label; /* NULL: none */
    dm_vec3 up;        /* host object frame; 0: that of the axes */
} dmi_object_labels;

/* Sets asset_hints of all parts. mesh: the object's. parts: `count` descriptors; NULL with a count of 0: none. Errors:
 * NOT_FINITE, TOO_LARGE for a label. */
dm_result dmi_object_read_hints(dmi_env* env, const dmi_mesh* mesh, dmi_object* object, const dmi_object_labels* labels,
                                const dm_part_desc* parts, uint32_t count);

#endif
