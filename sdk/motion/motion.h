/* A generated motion: the network's key poses projected exactly onto the joint, sampled continuously. */
#ifndef DMI_MOTION_MOTION_H
#define DMI_MOTION_MOTION_H

#include "math/frames.h"
#include "math/joint.h"
#include "motion/dq_vae.h"

typedef struct dmi_motion {
    dm_joint joint;                 /* host frame */
    float values[DM_MOTION_FRAMES]; /* joint values, inside the limits */
} dmi_motion;

/* Computes the drag path for a drag without one: the path of the drag point along the joint, from rest to the limit in
 * the drag's direction, at minimum-jerk pace. A joint without limits goes one turn, or half the object's size. */
void dmi_motion_default_path(const dm_joint* joint, const float drag_point[3], const float drag_vector[3],
                             float out_path[DMI_VAE_PATH][3]);
/* Resamples a host path to DMI_VAE_PATH points, evenly by index. */
void dmi_motion_resample_path(const float (*path)[3], uint32_t count, float out_path[DMI_VAE_PATH][3]);

/* Projects the network's poses exactly onto the joint's screw, in the inner frame. Each key pose becomes the joint
 * value nearest to it, with turns unwrapped over the frames. Frame 0 becomes rest, and values are clamped to the
 * limits. */
void dmi_motion_project(const dm_joint* joint, const float raw[DM_MOTION_FRAMES][8],
                        float out_values[DM_MOTION_FRAMES]);

/* Returns the joint value at t in [0, 1] (clamped), by monotone cubic interpolation of the key values. */
float dmi_motion_value(const dmi_motion* motion, float t);

#endif
