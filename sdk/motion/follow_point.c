/* Closed form for slides and turns; Newton's method for screws. */
#include "motion/follow_point.h"

#include <math.h>

#include "math/constants.h"
#include "math/elementary.h"
#include "math/linear3.h"
#include "math/vec3.h"

#define MAX_STEPS 12    /* steps of Newton's method; by hand */
#define MAX_STEP 0.5f   /* rad, the longest step; by hand */
#define TOLERANCE 1e-6f /* rad, a step that ends the search; by hand */
#define MIN_ARM 1e-6f   /* lever arm, share of the coordinates; a smaller one is rounding */

/* A point and a hand about an axis. */
typedef struct turn {
    float angle;   /* angle from the point to the hand, rad */
    float product; /* product of both lever arms */
    float along;   /* height of the hand above the point, along the axis */
} turn;

static bool view_turn(const dm_joint* joint, const float rest_point[3], const float hand[3], turn* out) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin);
    float u[3], w[3], across[3];
    dmi_sub3(rest_point, origin.v, u);
    dmi_sub3(hand, origin.v, w);
    const float size = dmi_length3(rest_point) + dmi_length3(origin.v);
    out->along = dmi_dot3(w, axis.v) - dmi_dot3(u, axis.v);
    dmi_reject3(u, axis.v);
    dmi_reject3(w, axis.v);
    dmi_cross3(u, w, across);
    out->product = dmi_length3(u) * dmi_length3(w);
    out->angle = dmi_atan2f(dmi_dot3(across, axis.v), dmi_dot3(u, w));
    return dmi_fminf(dmi_length3(u), dmi_length3(w)) > MIN_ARM * size;
}

/* Minimises -product cos(v - angle) + (pitch v - along)^2 / 2 downhill from `start`. */
static float follow_screw(const turn* view, float pitch, float start) {
    float value = start;
    for (int i = 0; i < MAX_STEPS; i++) {
        const float off = pitch * value - view->along;
        const dmi_circlef at = dmi_circle_atf(value - view->angle);
        const float first = view->product * at.sine + pitch * off;
        const float second = view->product * at.cosine + pitch * pitch;
        const float step = second > 0 ? -first / second : -copysignf(MAX_STEP, first);
        value += dmi_fminf(dmi_fmaxf(step, -MAX_STEP), MAX_STEP);
        if (fabsf(step) < TOLERANCE) break;
    }
    return value;
}

float dmi_follow_point(const dm_joint* joint, const float rest_point[3], const float hand[3], float start, float lower,
                       float upper) {
    float value = start;
    turn view;
    if (joint->type == DM_JOINT_PRISMATIC) {
        float way[3];
        dmi_sub3(hand, rest_point, way);
        value = dmi_dot3(way, dmi_xyz(joint->axis).v);
    } else if (dmi_joint_turns(joint->type) && view_turn(joint, rest_point, hand, &view)) {
        value = view.angle + DMI_TWO_PI_F * roundf((start - view.angle) / DMI_TWO_PI_F);
        if (joint->type == DM_JOINT_SCREW && joint->pitch != 0) value = follow_screw(&view, joint->pitch, start);
    }
    return isfinite(value) ? dmi_fminf(dmi_fmaxf(value, lower), upper) : start;
}
