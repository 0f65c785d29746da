/* How a drag feels (dm_drag_feel): soft ends, detents, stiffness, damping and inertia between the pointer and the joint
 * value. The pointer value is what the pointer asks for. The target is what the part is asked for. Snap values are
 * catches at places that the host lists, where detents are evenly spaced. */
#ifndef DMI_DRAG_DRAG_FEEL_H
#define DMI_DRAG_DRAG_FEEL_H

#include "math/joint.h"

/* Returns the width of the soft zone inside (and outside) each limit, joint value. */
float dmi_feel_soft_width(const dm_drag_feel* feel, const dm_joint* joint);
/* Maps a pointer value into the limits and towards the detents; monotone. */
float dmi_feel_target(const dm_drag_feel* feel, const dm_joint* joint, float pointer_value);
/* Does the same for estimated limits, which a longer pull exceeds. A dead zone takes the place of an end. closed: the
 * joint value from which detents are spaced. */
float dmi_feel_soft_target(const dm_drag_feel* feel, float closed, float lower, float upper, float pointer_value);
/* Inverse of dmi_feel_target: returns a pointer value with this target. */
float dmi_feel_pointer_value(const dm_drag_feel* feel, const dm_joint* joint, float target);
/* Returns the inverse of dmi_feel_soft_target, for targets inside the limits. */
float dmi_feel_soft_pointer_value(const dm_drag_feel* feel, float closed, float target);
/* Returns the detent nearest to a value, inside the limits; the value itself without detents. */
float dmi_feel_nearest_detent(const dm_drag_feel* feel, const dm_joint* joint, float value);
/* Returns how hard detents and snap values hold, 0 to 1. */
float dmi_feel_detent_pull(const dm_drag_feel* feel);
/* Returns the half-life of a free part's velocity, s. With 0 it stops at once. */
float dmi_feel_coast_time(const dm_drag_feel* feel);

/* Moves value and velocity by dt seconds towards a target that went evenly from `before` to `target`: the closed-form
 * solution of the equation of motion, so that the same path gives the same value at any frame rate. */
void dmi_feel_follow(const dm_drag_feel* feel, const dm_joint* joint, float before, float target, float dt,
                     float* inout_value, float* inout_velocity);

/* ---- snap values ---- */

typedef struct dmi_snaps {
    uint32_t count;             /* 0: none */
    float values[DM_MAX_SNAPS]; /* joint values, rising */
    float reach;                /* joint value to either side; 0: half-way to the next */
    float outer_reach;          /* the same on a side without a next one */
    float pull;                 /* share of full strength, 0 to 1 */
} dmi_snaps;

/* Moves a pointer value towards the snap value that it is in reach of; monotone, with the least slope at snap values.
 */
float dmi_snaps_pull(const dmi_snaps* snaps, float value);
/* Inverse of dmi_snaps_pull: returns a pointer value that is moved to `target`. */
float dmi_snaps_invert(const dmi_snaps* snaps, float target);
/* Returns whether a value is in reach of a snap value inside the limits. out_snap gets that one. */
bool dmi_snaps_catch(const dmi_snaps* snaps, const dm_joint* joint, float value, float* out_snap);
/* Returns where a value lies among the snap values, from -1 to their count: an index at each, and half-way to the next
 * one at the end of the reach. */
float dmi_snaps_place(const dmi_snaps* snaps, float value);

#endif
