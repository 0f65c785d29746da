/* The screw between two poses of one joint is that joint. Between those of two joints it lies anywhere, and a large
 * turn about it would swing the grabbed point away from the pointer: so the part turns about that point instead. */
#include "motion/drag_handover.h"

#include <math.h>

#include "math/linear3.h"
#include "math/vec3.h"

#define TURN_TIME 0.1f    /* s … */
#define TURN_SLOWER 0.3f  /* … and so much more a radian, … */
#define LONGEST_TURN 0.6f /* … up to this */
#define LAG_TIME 0.05f    /* s, … */
#define LAG_SLOWER 0.3f   /* … and so much more a length of the part, … */
#define LONGEST_LAG 0.5f  /* … up to this: the grabbed point belongs to the pointer */

dmi_handover dmi_handover_none(void) {
    return (dmi_handover){.offset = dmi_pose_identity(), .age = INFINITY};
}

dmi_handover dmi_handover_along(const dm_pose* before, const dm_pose* now) {
    const dm_pose back = dmi_pose_inverse(now), offset = dmi_pose_multiply(before, &back);
    const float turn = 2 * acosf(fminf(fabsf(offset.real[3]), 1));
    return (dmi_handover){.offset = offset, .turn_time = fminf(TURN_TIME + TURN_SLOWER * turn, LONGEST_TURN)};
}

dmi_handover dmi_handover_begin(const dm_pose* before, const dm_pose* now, const float point[3], float size) {
    dmi_handover handover = dmi_handover_along(before, now);
    float shown[3], there[3];
    dmi_pose_apply(before, point, shown);
    dmi_pose_apply(now, point, there);
    dmi_sub3(shown, there, handover.lag);
    const float lengths = size > 0 ? dmi_length3(handover.lag) / size : 0;
    handover.lag_time = fminf(LAG_TIME + LAG_SLOWER * lengths, LONGEST_LAG);
    return handover;
}

/* How much is left, from 1 to 0 with neither a start nor an end that is felt. */
static float left_of(float age, float time) {
    const float s = fminf(age / time, 1);
    return 1 - s * s * (3 - 2 * s);
}

dm_pose dmi_handover_pose(const dmi_handover* handover, const dm_pose* joint, const float point[3]) {
    if (!(handover->age < fmaxf(handover->turn_time, handover->lag_time))) return *joint;
    const dm_pose none = dmi_pose_identity();
    const dm_pose left = dmi_pose_sclerp(&none, &handover->offset, left_of(handover->age, handover->turn_time));
    if (handover->lag_time == 0) return dmi_pose_multiply(&left, joint);
    float there[3], turned[3], shift[3];
    dmi_pose_apply(joint, point, there);
    dmi_pose_rotate(&left, there, turned);
    dmi_madd3(there, left_of(handover->age, handover->lag_time), handover->lag, shift);
    dmi_sub3(shift, turned, shift);
    const dm_pose offset = dmi_pose_from_rotation_translation(left.real, shift);
    return dmi_pose_multiply(&offset, joint);
}
