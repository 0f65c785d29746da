/* Declares the one source of drags of all training cases. */
#ifndef DM_LAB_PULL_H
#define DM_LAB_PULL_H

#include "case.h"

/* Draws a drag on the case's part, in the object-normalised frame: mostly opening, sometimes closing where the joint
 * has room for that. pull: DM_LAB_PULL_*. noise_degrees: sigma of its error is between 0 and this. Returns the joint
 * signed so that positive follows the drag. */
dmi_drag_hint lab_case_drag(lab_case* made, int32_t pull, float noise_degrees, dm_joint* out_joint);

#endif
