/* Generated motions for other parts of the boundary. */
#ifndef DMI_API_MOTION_H
#define DMI_API_MOTION_H

#include "api_handles.h"

/* Generates the motion from rest to the end of `joint` (host frame) in the direction of the hint, as joint values at
 * DM_MOTION_FRAMES evenly spaced times. Answers NO_MODEL without weights. */
dm_result dmi_motion_opening(dm_context* context, const dmi_object_slot* slot, uint32_t part, const dm_joint* joint,
                             const dmi_drag_hint* hint, uint32_t seed, float out_values[DM_MOTION_FRAMES]);

#endif
