/* Declares network inputs and labels of cases that a loader provides (dragmesh_training/loaders). */
#ifndef DM_LAB_GIVEN_H
#define DM_LAB_GIVEN_H

#include "lab_ranker.h"

/* Writes one KPP-Net case into the first place of `out`. Reads only seed, with_drag and drag_noise_degrees of the
 * options. Equal limits mean none; `category` is 0. */
DM_API dm_result dm_lab_kpp_given(const dm_lab_given* given, const dm_lab_options* options, const dm_lab_kpp* out);

/* Writes options->count DQ-VAE strokes on the part. Reads of the other options only seed, drag_noise_degrees,
 * joint_noise and hand_noise. Returns DM_ERROR_NOT_FOUND for a joint that has no limits and is not continuous. */
DM_API dm_result dm_lab_vae_given(const dm_lab_given* given, const dm_lab_options* options, const dm_lab_vae* out);

#endif
