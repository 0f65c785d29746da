/* Converts a screen position to a ray. */
#ifndef DMI_PICK_CAMERA_H
#define DMI_PICK_CAMERA_H

#include <stdbool.h>

#include "dragmesh/dragmesh.h"

/* handedness: +1 right-handed host, -1 left-handed. False (and no output) for a camera without a valid frame or
 * viewport.
 */
bool dmi_camera_ray(const dm_camera* camera, float handedness, float x, float y, dm_ray* out_ray);

#endif
