/* Part masks as segmenters write them: a .npy or a JSON array with one integer a vertex or one a face. */
#ifndef DMI_MESH_MASK_H
#define DMI_MESH_MASK_H

#include "base/env.h"

/* Reads numbers from .npy (bool, (u)int8..64, little-endian, C order, one dimension) or JSON (flat array of integers).
 * *out_values is released with dmi_free(env, values, count * sizeof(int64_t)). Malformed bytes give DM_ERROR_BAD_DATA.
 */
dm_result dmi_mask_parse(dmi_env* env, const void* data, size_t size, int64_t** out_values, size_t* out_count);

/* Converts mask values to part ids 0 and 1: 1 where non-zero, or equal to *mask_value when that is given. out_scope is
 * DM_PER_VERTEX or DM_PER_FACE by the length; when both fit, per vertex is taken and *out_ambiguous set. */
dm_result dmi_mask_to_part_ids(dmi_env* env, const int64_t* values, size_t count, const int64_t* mask_value,
                               size_t vertex_count, size_t face_count, uint8_t* out_part_ids, int32_t* out_scope,
                               int* out_ambiguous);

#endif
