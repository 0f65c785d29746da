/* Snap values: catches at places that the host lists, where detents are evenly spaced. */
#ifndef DMI_MOTION_DRAG_SNAPS_H
#define DMI_MOTION_DRAG_SNAPS_H

#include "math/joint.h"

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
