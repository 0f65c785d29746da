/* Motions for other parts of the boundary. */
#ifndef DMI_API_MOTION_H
#define DMI_API_MOTION_H

#include "api_context.h"

/* The DQ-VAE's way from rest to the end of `joint` (host frame) that lies along the hint: values of the joint at
 * DM_MOTION_FRAMES even times. NO_MODEL without weights. */
dm_result dmi_motion_opening(dm_context* context, const dmi_object_slot* slot, uint32_t part, const dm_joint* joint,
                             const dmi_drag_hint* hint, uint32_t seed, float out_values[DM_MOTION_FRAMES]);

#endif
