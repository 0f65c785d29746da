/* Sweeps a part along a joint through the distance grid of its body. It finds what stops the part, and how far it comes
 * off. */
#ifndef DMI_LIMITS_SWEEP_H
#define DMI_LIMITS_SWEEP_H

#include "dragmesh/dragmesh.h"
#include "kinematics/analysis/batched_transform.h"
#include "kinematics/analysis/part_analysis.h"
#include "math/joint.h"

#define DMI_SWEEP_POINTS DMI_POINT_BATCH /* points of the part that are swept */
#define DMI_SWEEP_TURN 0.05f             /* rad of one step of a turn; by hand */
#define DMI_SWEEP_TURNS 63               /* steps to half a turn */
#define DMI_SWEEP_SLIDES 48              /* steps of a slide */

typedef struct dmi_sweep {
    const dmi_part_analysis* analysis;
    const dm_joint* joint; /* inner frame */
    float origin[3];
    dmi_batched_transform moved, moved_free; /* all points; those that are free, then some that are not */
    float extent;                            /* extent of the part along the axis, at least 0.01 */
    int32_t free_count;                      /* points that do not touch the body at rest */
} dmi_sweep;

void dmi_sweep_make(const dmi_part_analysis* analysis, const dm_joint* joint, dmi_sweep* out);

static inline bool dmi_sweep_slides(const dmi_sweep* s) {
    return s->joint->type == DM_JOINT_PRISMATIC;
}

/* Writes the largest values that the part reaches in the direction of `step` before it is stopped, and jammed. */
void dmi_sweep_reach(const dmi_sweep* s, float step, int steps, float out[2]);

/* The points' distances from the body at a value, in object sizes. */
typedef struct dmi_clearance {
    float mean, least;
} dmi_clearance;
dmi_clearance dmi_sweep_clearance(const dmi_sweep* s, float value);

/* Returns the mean distance of the part from itself, in diagonals, when it is turned by three angles. It is small for a
 * knob, a wheel, a cap. */
float dmi_sweep_roundness(const dmi_sweep* s);

/* ---- range that is free ---- */

/* Sweeps half a turn, or a bit more than the part's extent along a slide, to either side. A side on which nothing is
 * penetrated so far has no bound. joint: object-normalised frame; its limits are not used. */
dmi_free_range dmi_free_range_of(const dmi_part_analysis* analysis, const dm_joint* joint);

#endif
