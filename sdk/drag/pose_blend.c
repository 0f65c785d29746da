/* Two poses of one joint differ by a screw of that joint. The screw between poses of two joints may lie anywhere, and a
 * large turn about it would swing the grabbed point away from the pointer. So the part turns about that point there. */
#include "drag/pose_blend.h"

#include <math.h>

#include "math/elementary.h"
#include "math/linear3.h"

/* The values are fitted by the scripted player (docs/research/trials_drag.md). */
#define TURN_TIME 0.1f       /* s for the rotation at least */
#define TURN_TIME_SLOPE 0.3f /* s more a radian */
#define MAX_TURN_TIME 0.6f   /* s */
#define LAG_TIME 0.05f       /* s for the grabbed point at least */
#define LAG_TIME_SLOPE 0.3f  /* s more a length of the part */
#define MAX_LAG_TIME 0.5f    /* s */

dmi_pose_blend dmi_pose_blend_none(void) {
    return (dmi_pose_blend){.offset = dmi_pose_identity(), .age = INFINITY};
}

dmi_pose_blend dmi_pose_blend_same_joint(const dm_pose* before, const dm_pose* now) {
    const dm_pose back = dmi_pose_inverse(now), offset = dmi_pose_multiply(before, &back);
    const float turn = 2 * dmi_acosf(dmi_fminf(fabsf(offset.real[3]), 1));
    return (dmi_pose_blend){.offset = offset,
                            .turn_time = dmi_fminf(TURN_TIME + TURN_TIME_SLOPE * turn, MAX_TURN_TIME)};
}

dmi_pose_blend dmi_pose_blend_new_joint(const dm_pose* before, const dm_pose* now, const float point[3], float size) {
    dmi_pose_blend blend = dmi_pose_blend_same_joint(before, now);
    float shown[3], there[3];
    dmi_pose_apply(before, point, shown);
    dmi_pose_apply(now, point, there);
    dmi_sub3(shown, there, blend.lag);
    const float lengths = size > 0 ? dmi_length3(blend.lag) / size : 0;
    blend.lag_time = dmi_fminf(LAG_TIME + LAG_TIME_SLOPE * lengths, MAX_LAG_TIME);
    return blend;
}

/* Returns the share that is left, from 1 to 0 by the smoothstep polynomial. */
static float remaining_share(float age, float time) {
    const float s = dmi_fminf(age / time, 1);
    return 1 - s * s * (3 - 2 * s);
}

dm_pose dmi_pose_blend_apply(const dmi_pose_blend* blend, const dm_pose* joint, const float point[3]) {
    if (!(blend->age < dmi_fmaxf(blend->turn_time, blend->lag_time))) return *joint;
    const dm_pose none = dmi_pose_identity();
    const dm_pose left = dmi_pose_sclerp(&none, &blend->offset, remaining_share(blend->age, blend->turn_time));
    if (blend->lag_time == 0) return dmi_pose_multiply(&left, joint);
    float there[3], turned[3], shift[3];
    dmi_pose_apply(joint, point, there);
    dmi_pose_rotate(&left, there, turned);
    dmi_madd3(there, remaining_share(blend->age, blend->lag_time), blend->lag, shift);
    dmi_sub3(shift, turned, shift);
    const dm_pose offset = dmi_pose_from_rotation_translation(left.real, shift);
    return dmi_pose_multiply(&offset, joint);
}
