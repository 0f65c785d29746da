/* Joint value at which a point is seen nearest to a ray, or is nearest to a hand in space: closed form for slides, and
 * for turns about a hand; Newton's method for turns seen, and for screws. */
#include "drag/follow.h"

#include <math.h>
#include <stdbool.h>

#include "math/elementary.h"
#include "math/linear3.h"

/* All values are set by hand, with the cases of tests/unit/test_drag.c; docs/feel.md. */
#define MAX_STEPS 16           /* steps of Newton's method */
#define MAX_STEP 0.5f          /* rad */
#define STEP_TOLERANCE 3e-5f   /* rad, relative beyond 1: the error left by a Newton step is about its square */
#define COARSE_TOLERANCE 1e-2f /* the same for the coarse search, in half the time */
#define MIN_SINE2 1e-9f        /* squared sine between a ray and a line that count as parallel */
#define MAX_FOLD 1.2f          /* rad between two places either side of a fold */
#define MAX_FOLD_AT_LIMIT 0.5f /* rad, the same when the pointer may only have passed a limit */
#define MIN_SLANT 0.8f         /* sine of the slant at which a circle is seen nearly edge on */
#define FOLD_MARGIN 0.01f      /* share of the lever arm by which the other branch must look nearer */
#define BRANCH_MISS 0.2f       /* share of the lever arm by which a point has clearly left the pointer */
#define BRANCH_GAIN 0.4f       /* share by which a place farther on must miss the pointer less */
/* Places tried in the range, 30 degrees apart on a whole circle, whose branches are 180 wide. */
#define BRANCH_PLACES 12
/* Sine between a point's motion and the line of sight; below it the motion is seen end on. */
#define END_ON_SINE 0.15f
#define MIN_ARM 1e-6f /* lever arm of a turning point, share of its coordinates; a smaller one is rounding */

/* A sliding point relative to the ray's origin at value v: P = arm + (along + v) a, with the arm perpendicular to a. */
typedef struct slide_view {
    vec3 a, d, arm;
    float along, ad; /* ad = a.d */
} slide_view;

/* Follows a slide in perspective. The angle between d and P has one stationary point, where a.d |arm|^2 = (along + v)
 * d.arm. With d.arm > 0 it is the minimum. Otherwise the pointer is beyond the line's vanishing point, and the angle
 * decreases all the way towards it: to the limit that lies along the ray. */
static float follow_slide_perspective(slide_view* view, float start, float lower, float upper) {
    const float across = dmi_dot3(view->d, view->arm), arm2 = dmi_dot3(view->arm, view->arm);
    if (!(arm2 > MIN_SINE2 * view->along * view->along)) return start; /* the slide is seen end on */
    if (across > 0) return view->ad * arm2 / across - view->along;
    if (view->ad > 0 && upper < INFINITY) return upper;
    if (view->ad < 0 && lower > -INFINITY) return lower;
    return start;
}

/* Returns the value of the closest point between the two lines. */
static float follow_slide_parallel(slide_view* view, float start) {
    vec3 across;
    dmi_scale3(view->a, view->ad, across);
    dmi_sub3(view->d, across, across);
    const float sine2 = dmi_dot3(across, across);
    if (!(sine2 > MIN_SINE2)) return start;
    return view->ad * dmi_dot3(view->d, view->arm) / sine2 - view->along;
}

static float follow_slide(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                          dmi_projection projection, float start, float lower, float upper) {
    slide_view view;
    vec3 p;
    dmi_copy3(dmi_xyz(joint->axis).v, view.a);
    dmi_copy3(dmi_xyz(ray->direction).v, view.d);
    dmi_sub3(rest_point, dmi_xyz(ray->origin).v, p);
    view.along = dmi_dot3(view.a, p);
    view.ad = dmi_dot3(view.a, view.d);
    dmi_scale3(view.a, view.along, view.arm);
    dmi_sub3(p, view.arm, view.arm);
    return projection == DMI_PARALLEL ? follow_slide_parallel(&view, start)
                                      : follow_slide_perspective(&view, start, lower, upper);
}

/* A turning point seen from the ray's origin: P(v) = centre + cos v u + sin v w + v advance. */
typedef struct turn_view {
    vec3 centre, u, w, advance, d;
    dmi_projection projection;
    float step_tolerance;
} turn_view;

static turn_view view_turn(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                           dmi_projection projection) {
    turn_view view = {.projection = projection};
    dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin), eye = dmi_xyz(ray->origin);
    vec3 arm, foot;
    dmi_copy3(dmi_xyz(ray->direction).v, view.d);
    dmi_sub3(rest_point, origin.v, arm);
    dmi_scale3(axis.v, dmi_dot3(arm, axis.v), foot);
    dmi_sub3(arm, foot, view.u);
    dmi_cross3(axis.v, view.u, view.w);
    dmi_add3(origin.v, foot, foot);
    dmi_sub3(foot, eye.v, view.centre);
    dmi_scale3(axis.v, joint->type == DM_JOINT_SCREW ? joint->pitch : 0, view.advance);
    return view;
}

/* Returns whether the point moves at all. One on the axis of a pure turn has only the rounding of its coordinates as
 * arm. */
static bool moves_point(const dm_joint* joint, const float rest_point[3], turn_view* view) {
    dmi_float3 origin = dmi_xyz(joint->origin);
    const float arm = dmi_length3(view->u) + dmi_length3(view->advance);
    return arm > MIN_ARM * (dmi_length3(rest_point) + dmi_length3(origin.v));
}

typedef struct slopes {
    float first, second; /* derivatives of the objective by the joint value */
} slopes;

/* Returns the slopes of |P - (d.P) d|^2 / 2, which is half the squared distance from the ray's line. */
static slopes parallel_slopes(vec3 d, vec3 p, vec3 velocity, vec3 acceleration) {
    const float pd = dmi_dot3(p, d), vd = dmi_dot3(velocity, d), ad = dmi_dot3(acceleration, d);
    return (slopes){dmi_dot3(p, velocity) - pd * vd,
                    dmi_dot3(velocity, velocity) - vd * vd + dmi_dot3(p, acceleration) - pd * ad};
}

/* Returns the slopes of -(d.P) / |P|, which is minus the cosine of the angle to the ray. */
static slopes perspective_slopes(vec3 d, vec3 p, vec3 velocity, vec3 acceleration) {
    const float distance = dmi_length3(p), n = dmi_dot3(p, d), n1 = dmi_dot3(velocity, d);
    const float n2 = dmi_dot3(acceleration, d), cosine = n / distance, q1 = dmi_dot3(p, velocity) / distance;
    const float q2 = (dmi_dot3(velocity, velocity) + dmi_dot3(p, acceleration) - q1 * q1) / distance;
    const float g1 = (n1 - cosine * q1) / distance;
    return (slopes){-g1, -(n2 - cosine * q2 - 2 * g1 * q1) / distance};
}

static slopes slopes_at(turn_view* view, float value) {
    const dmi_circlef at = dmi_circle_atf(value);
    const float c = at.cosine, s = at.sine;
    vec3 p, velocity, acceleration;
    for (int i = 0; i < 3; i++) {
        const float radius = c * view->u[i] + s * view->w[i];
        p[i] = view->centre[i] + radius + value * view->advance[i];
        velocity[i] = c * view->w[i] - s * view->u[i] + view->advance[i];
        acceleration[i] = -radius;
    }
    return view->projection == DMI_PARALLEL ? parallel_slopes(view->d, p, velocity, acceleration)
                                            : perspective_slopes(view->d, p, velocity, acceleration);
}

/* Minimises by Newton's method on the first derivative, safeguarded by the bracket of points known to lie left and
 * right of the minimum. */
static float find_minimum(turn_view* view, float start, float lower, float upper) {
    float left = -INFINITY, right = INFINITY, value = start;
    for (int i = 0; i < MAX_STEPS; i++) {
        const slopes slope = slopes_at(view, value);
        if (!isfinite(slope.first) || !isfinite(slope.second)) return start;
        if (slope.first == 0 || (slope.first < 0 && value >= upper) || (slope.first > 0 && value <= lower)) break;
        if (slope.first < 0) left = value;
        if (slope.first > 0) right = value;
        float step = slope.second > 0 ? -slope.first / slope.second : -copysignf(MAX_STEP, slope.first);
        step = dmi_clamp(step, -MAX_STEP, MAX_STEP);
        float next = dmi_clamp(value + step, lower, upper);
        if (fabsf(next - value) <= view->step_tolerance * dmi_fmaxf(1, fabsf(value))) return next;
        if (next <= left || next >= right) next = 0.5f * (left + right);
        value = next;
    }
    return value;
}

/* Returns the distance of the point at `value` from the ray; infinite behind the eye of a perspective. */
static float distance_from_ray(turn_view* view, float value) {
    const dmi_circlef at = dmi_circle_atf(value);
    const float c = at.cosine, s = at.sine;
    vec3 p;
    for (int i = 0; i < 3; i++) {
        p[i] = view->centre[i] + c * view->u[i] + s * view->w[i] + value * view->advance[i];
    }
    const float along = dmi_dot3(p, view->d);
    if (view->projection == DMI_PERSPECTIVE && !(along > 0)) return INFINITY;
    for (int i = 0; i < 3; i++) p[i] -= along * view->d[i];
    return dmi_length3(p);
}

/* A circle seen at a slant runs out and back on the screen; its two branches meet in a fold. A local minimiser would
 * turn round there when the pointer comes back on the other branch. So the value mirrored at the fold is tried too, and
 * taken when it is clearly nearer to the ray, but only near the fold, so that the part never sweeps across. */
static float pass_fold(turn_view* view, float value, float lower, float upper) {
    const float out = dmi_dot3(view->u, view->d), side = dmi_dot3(view->w, view->d);
    const float arm = dmi_length3(view->u);
    if (!(out * out + side * side > MIN_SLANT * MIN_SLANT * arm * arm)) return value;
    const float quarter = DMI_HALF_PI_F,
                slope = dmi_atan2f(side, out) + quarter; /* where the circle runs parallel to the ray */
    const float fold = slope + DMI_PI_F * roundf((value - slope) / DMI_PI_F), gap = 2 * (fold - value);
    const float other = value + gap, longest = value > lower && value < upper ? MAX_FOLD : MAX_FOLD_AT_LIMIT;
    if (fabsf(gap) > longest || other < lower || other > upper) return value;
    const float here = distance_from_ray(view, value);
    if (here < FOLD_MARGIN * arm) return value;
    const float there = find_minimum(view, other, lower, upper), then = distance_from_ray(view, there);
    const float passed = (there - fold) * (value - fold);
    return passed < 0 && then < here - FOLD_MARGIN * arm ? there : value;
}

/* Searches the range for a place that is nearer to the pointer, once the pointer has clearly left the point. A pointer
 * that goes straight to where a turn should end leaves the circle. The place downhill may then be a stop or a fold,
 * while a place farther on is at the pointer. */
static float find_branch(turn_view* view, float value, float lower, float upper) {
    const float here = distance_from_ray(view, value);
    if (here < BRANCH_MISS * dmi_length3(view->u)) return value;
    const float spacing = (upper - lower) / BRANCH_PLACES;
    float best = value, least = here;
    for (int i = 0; i < BRANCH_PLACES; i++) {
        const float other = lower + spacing * ((float)i + 0.5f), distance = distance_from_ray(view, other);
        if (distance < least) least = distance, best = other;
    }
    if (best == value) return value;
    const float there = find_minimum(view, best, lower, upper);
    return distance_from_ray(view, there) < BRANCH_GAIN * here ? there : value;
}

static float follow_on_joint(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                             dmi_projection projection, float start, float lower, float upper, bool coarse) {
    float value = start;
    if (joint->type == DM_JOINT_PRISMATIC) {
        value = follow_slide(joint, rest_point, ray, projection, start, lower, upper);
    } else if (dmi_joint_turns(joint->type)) {
        turn_view view = view_turn(joint, rest_point, ray, projection);
        view.step_tolerance = coarse ? COARSE_TOLERANCE : STEP_TOLERANCE;
        if (!moves_point(joint, rest_point, &view)) return start;
        const float least = dmi_fmaxf(lower, start - DMI_PI_F), most = dmi_fminf(upper, start + DMI_PI_F);
        value = find_minimum(&view, start, least, most);
        if (!coarse) value = find_branch(&view, pass_fold(&view, value, least, most), least, most);
    }
    return isfinite(value) ? dmi_clamp(value, lower, upper) : start;
}

float dmi_follow_ray(const dm_joint* joint, const float rest_point[3], const dm_ray* ray, dmi_projection projection,
                     float start, float lower, float upper) {
    return follow_on_joint(joint, rest_point, ray, projection, start, lower, upper, false);
}

float dmi_follow_ray_coarse(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                            dmi_projection projection, float start, float lower, float upper) {
    return follow_on_joint(joint, rest_point, ray, projection, start, lower, upper, true);
}

void dmi_line_of_sight(const float point[3], const dm_ray* ray, dmi_projection projection, float out_sight[3],
                       float* out_eye_distance) {
    const dmi_float3 eye = dmi_xyz(ray->origin), direction = dmi_xyz(ray->direction);
    dmi_copy3(direction.v, out_sight);
    *out_eye_distance = INFINITY;
    if (projection == DMI_PARALLEL) return;
    dmi_sub3(point, eye.v, out_sight);
    *out_eye_distance = dmi_normalize3(out_sight);
}

bool dmi_is_seen_end_on(const dm_joint* joint, const float rest_point[3], const float sight[3]) {
    float velocity[3];
    dmi_joint_velocity(joint, 0, rest_point, velocity);
    if (!(dmi_normalize3(velocity) > 0)) return false;
    dmi_reject3(velocity, sight);
    return dmi_length3(velocity) < END_ON_SINE;
}

/* ---- a hand in space ---- */

#define POINT_STEPS 12        /* steps of Newton's method; by hand */
#define MAX_STEP 0.5f         /* rad, the longest step; by hand */
#define POINT_TOLERANCE 1e-6f /* rad, a step that ends the search; by hand */
#define MIN_ARM 1e-6f         /* lever arm, share of the coordinates; a smaller one is rounding */

/* A point and a hand about an axis. */
typedef struct hand_turn {
    float angle;   /* angle from the point to the hand, rad */
    float product; /* product of both lever arms */
    float along;   /* height of the hand above the point, along the axis */
} hand_turn;

static bool view_hand_turn(const dm_joint* joint, const float rest_point[3], const float hand[3], hand_turn* out) {
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
static float follow_screw(const hand_turn* view, float pitch, float start) {
    float value = start;
    for (int i = 0; i < POINT_STEPS; i++) {
        const float off = pitch * value - view->along;
        const dmi_circlef at = dmi_circle_atf(value - view->angle);
        const float first = view->product * at.sine + pitch * off;
        const float second = view->product * at.cosine + pitch * pitch;
        const float step = second > 0 ? -first / second : -copysignf(MAX_STEP, first);
        value += dmi_fminf(dmi_fmaxf(step, -MAX_STEP), MAX_STEP);
        if (fabsf(step) < POINT_TOLERANCE) break;
    }
    return value;
}

float dmi_follow_point(const dm_joint* joint, const float rest_point[3], const float hand[3], float start, float lower,
                       float upper) {
    float value = start;
    hand_turn view;
    if (joint->type == DM_JOINT_PRISMATIC) {
        float way[3];
        dmi_sub3(hand, rest_point, way);
        value = dmi_dot3(way, dmi_xyz(joint->axis).v);
    } else if (dmi_joint_turns(joint->type) && view_hand_turn(joint, rest_point, hand, &view)) {
        value = view.angle + DMI_TWO_PI_F * roundf((start - view.angle) / DMI_TWO_PI_F);
        if (joint->type == DM_JOINT_SCREW && joint->pitch != 0) value = follow_screw(&view, joint->pitch, start);
    }
    return isfinite(value) ? dmi_fminf(dmi_fmaxf(value, lower), upper) : start;
}
