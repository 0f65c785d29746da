/* Follow the pointer: the grabbed point stays as near the pointer's ray as its joint allows. */
#ifndef DMI_MOTION_DRAG_H
#define DMI_MOTION_DRAG_H

#include "math/joint.h"

typedef struct dmi_drag {
    dm_joint joint;      /* host object frame */
    float rest_point[3]; /* the grabbed point with the part at rest */
    dm_drag_feel feel;
    float value, target, velocity;
} dmi_drag;

/* grab_point: where the grabbed point is with the joint at start_value. */
void dmi_drag_begin(dmi_drag* drag, const dm_joint* joint, const float grab_point[3], float start_value,
                    const dm_drag_feel* feel);
void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state);
void dmi_drag_state_now(const dmi_drag* drag, dm_drag_state* out_state);

#endif
