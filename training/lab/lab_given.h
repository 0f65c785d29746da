/* The networks' training on cases that a loader provides (dragmesh_training/loaders): other people's objects. */
#ifndef DM_LAB_GIVEN_H
#define DM_LAB_GIVEN_H

#include "lab_ranker.h"

/* KPP-Net: one case into the first place of `out`. Of the options counts: seed, with_drag, drag_noise_degrees. Equal
 * limits are none; `category` is 0. */
DM_API dm_result dm_lab_kpp_given(const dm_lab_given* given, const dm_lab_options* options, const dm_lab_kpp* out);

/* DQ-VAE: options->count strokes of a hand on the part. Of the other options count: seed, drag_noise_degrees,
 * joint_noise, hand_noise. DM_ERROR_NOT_FOUND for a joint that has no limits and is not continuous: no stroke is its.
 */
DM_API dm_result dm_lab_vae_given(const dm_lab_given* given, const dm_lab_options* options, const dm_lab_vae* out);

#endif
