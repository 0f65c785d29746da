/* A generated motion: the network's key poses projected exactly onto the joint, sampled continuously. */
#ifndef DMI_MOTION_MOTION_H
#define DMI_MOTION_MOTION_H

#include "math/frames.h"
#include "math/joint.h"
#include "motion/dq_vae.h"

typedef struct dmi_motion {
    dm_joint joint;                 /* host frame: what sampling needs and nothing else */
    float values[DM_MOTION_FRAMES]; /* joint values, inside the limits */
} dmi_motion;

/* The drag path that a drag asks for when the host gives none: the drag point's own way along the joint from rest to
 * the limit in the drag's direction, at minimum-jerk pace (a continuous joint: one turn; a limitless slide: half the
 * object). */
void dmi_motion_default_path(const dm_joint* joint, const float drag_point[3], const float drag_vector[3],
                             float out_path[DMI_VAE_PATH][3]);
/* Resamples a host path to DMI_VAE_PATH points, even in order of arrival. */
void dmi_motion_resample_path(const float (*path)[3], uint32_t count, float out_path[DMI_VAE_PATH][3]);

/* Exact projection of the network's poses onto the joint's screw: each key pose becomes the joint value nearest to it
 * (turns unwrapped over the frames), frame 0 becomes rest, values are clamped to the limits. Inner frame. */
void dmi_motion_project(const dm_joint* joint, const float raw[DM_MOTION_FRAMES][8],
                        float out_values[DM_MOTION_FRAMES]);

/* t in [0, 1], clamped; monotone-cubic between key values so that it neither overshoots nor jerks. */
float dmi_motion_value(const dmi_motion* motion, float t);

#endif
