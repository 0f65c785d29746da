/* Conversion between the host's frame and the object-normalised frame; the only place for it.
 *
 *   host object frame --(axes, unit)--> canonical metres --(x - centre) / size--> object-normalised
 *
 * Everything inside the rooms is object-normalised: centre = centre of the box of the whole object at rest, size = its
 * largest side (paper §3.2), so the box's largest side runs from -0.5 to 0.5. */
#ifndef DMI_MATH_FRAMES_H
#define DMI_MATH_FRAMES_H

#include <stdbool.h>

#include "math/dual_quat.h"

typedef struct dmi_axes {
    float to_canonical[9]; /* row-major, orthogonal */
    float handedness;      /* its determinant, +1 or -1 */
    float unit;            /* metres a host unit */
} dmi_axes;

/* Returns false when the preset is unknown or the custom matrix is not orthogonal. */
bool dmi_axes_init(dmi_axes* out, int32_t preset, const float custom[9], float unit_in_metres);

/* Converts a host point to canonical metres, before any normalisation. */
void dmi_axes_point_in(const dmi_axes* axes, const double host[3], double out[3]);

/* Host object frame <-> object-normalised. Doubles where an object may sit far from its frame's origin. */
typedef struct dmi_frame {
    dmi_axes axes;
    double centre[3]; /* canonical metres */
    double size;      /* canonical metres */
} dmi_frame;

/* Returns whether numbers of the object stay inside float's range on both sides: its size and where it is, in metres
 * and in host units. */
bool dmi_frame_is_usable(const dmi_frame* frame);

void dmi_frame_point_in(const dmi_frame* frame, const double host[3], float out[3]);
void dmi_frame_point_out(const dmi_frame* frame, const float inner[3], float out_host[3]);
void dmi_frame_vector_in(const dmi_frame* frame, const float host[3], float out[3]); /* axes and 1 / size */
void dmi_frame_vector_out(const dmi_frame* frame, const float inner[3], float out_host[3]);
void dmi_frame_direction_in(const dmi_frame* frame, const float host[3], float out[3]); /* axes alone */
void dmi_frame_direction_out(const dmi_frame* frame, const float inner[3], float out_host[3]);
/* dmi_frame_point_out as a 3x4 matrix, column-major: three images of the inner axes, then that of the inner origin. */
void dmi_frame_matrix_out(const dmi_frame* frame, double out_host[12]);
/* Returns host units in one inner unit. */
float dmi_frame_length_out(const dmi_frame* frame);
dm_ray dmi_frame_ray_in(const dmi_frame* frame, const dm_ray* host);
dm_pose dmi_frame_pose_in(const dmi_frame* frame, const dm_pose* host);
dm_pose dmi_frame_pose_out(const dmi_frame* frame, const dm_pose* inner);
/* Converts axis, origin, pitch and limits; a turning axis flips with the handedness, so that positive stays positive.
 */
dm_joint dmi_frame_joint_in(const dmi_frame* frame, const dm_joint* host);
dm_joint dmi_frame_joint_out(const dmi_frame* frame, const dm_joint* inner);

#endif
