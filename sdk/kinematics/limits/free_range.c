/* Finds collision-free ranges by the same sweep as limits. */
#include "kinematics/limits/free_range.h"

#include "kinematics/limits/sweep.h"

#define SLIDE_EXTENTS 1.2f /* extents of the part that a slide is swept; by hand */

dmi_free_range dmi_free_range_of(const dmi_part_analysis* analysis, const dm_joint* joint) {
    dmi_sweep sweep;
    dmi_free_range out = dmi_unbounded_range();
    dmi_sweep_make(analysis, joint, &sweep);
    const bool slides = dmi_sweep_slides(&sweep);
    const float step = slides ? SLIDE_EXTENTS * sweep.extent / DMI_SWEEP_SLIDES : DMI_SWEEP_TURN;
    const int steps = slides ? DMI_SWEEP_SLIDES : DMI_SWEEP_TURNS;
    float up[2], down[2]; /* values where the part is stopped, and where it is jammed */
    dmi_sweep_reach(&sweep, step, steps, up);
    dmi_sweep_reach(&sweep, -step, steps, down);
    if (up[1] < step * (float)steps) out.upper = up[1];
    if (down[1] > -step * (float)steps) out.lower = down[1];
    return out;
}
