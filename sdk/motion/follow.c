/* Nearest look of a point on its way along a joint to a pointer's ray: closed form for slides, Newton for turns. */
#include "motion/follow.h"

#include <math.h>
#include <stdbool.h>

#define CGLM_ALL_UNALIGNED
#include <cglm/cglm.h>

#define MOST_STEPS 16
#define LONGEST_STEP 0.5f     /* rad */
#define LAST_STEP 3e-5f       /* rad, relative beyond 1; what a Newton step leaves is about its square … */
#define LAST_ROUGH_STEP 1e-2f /* … and this one in half the time */
#define LEAST_SINE2 1e-9f     /* of the angle between a ray and a line that count as parallel, squared */
#define LONGEST_FOLD 1.2f     /* rad: how far apart two places either side of a fold may be … */
#define LONGEST_AT_LIMIT 0.5f /* … when the pointer may only have gone past a limit */
#define LEAST_SLANT 0.8f      /* sine of the slant at which a circle is seen nearly edge on */
#define LEAST_FOLD 0.01f      /* of a turning point's arm: how much nearer the other side must look */
#define LEAST_ARM 1e-6f       /* of a turning point, as a share of its coordinates */

/* A slide's point seen from the ray's origin: P = arm + (along + v) a with the arm across the axis a. */
typedef struct slide_view {
    vec3 a, d, arm;
    float along, ad; /* ad = a.d */
} slide_view;

/* The angle between d and P has one stationary point, P where a.d |arm|^2 = (along + v) d.arm. With d.arm > 0 it is the
 * nearest look. Else the pointer is beyond the line's vanishing point, and the look gets better all the way towards
 * that: to the end that lies along the ray. */
static float follow_slide_perspective(slide_view* view, float start, float lower, float upper) {
    const float across = glm_vec3_dot(view->d, view->arm), arm2 = glm_vec3_norm2(view->arm);
    if (!(arm2 > LEAST_SINE2 * view->along * view->along)) return start; /* seen end on */
    if (across > 0) return view->ad * arm2 / across - view->along;
    if (view->ad > 0 && upper < INFINITY) return upper;
    if (view->ad < 0 && lower > -INFINITY) return lower;
    return start;
}

/* Nearest points of two lines. */
static float follow_slide_parallel(slide_view* view, float start) {
    vec3 across;
    glm_vec3_scale(view->a, view->ad, across);
    glm_vec3_sub(view->d, across, across);
    const float sine2 = glm_vec3_norm2(across);
    if (!(sine2 > LEAST_SINE2)) return start;
    return view->ad * glm_vec3_dot(view->d, view->arm) / sine2 - view->along;
}

static float follow_slide(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                          dmi_projection projection, float start, float lower, float upper) {
    slide_view view = {.a = {joint->axis.x, joint->axis.y, joint->axis.z},
                       .d = {ray->direction.x, ray->direction.y, ray->direction.z}};
    vec3 p = {rest_point[0] - ray->origin.x, rest_point[1] - ray->origin.y, rest_point[2] - ray->origin.z};
    view.along = glm_vec3_dot(view.a, p);
    view.ad = glm_vec3_dot(view.a, view.d);
    glm_vec3_scale(view.a, view.along, view.arm);
    glm_vec3_sub(p, view.arm, view.arm);
    return projection == DMI_PARALLEL ? follow_slide_parallel(&view, start)
                                      : follow_slide_perspective(&view, start, lower, upper);
}

/* A turning point seen from the ray's origin: P(v) = centre + cos v u + sin v w + v advance. */
typedef struct turn_view {
    vec3 centre, u, w, advance, d;
    dmi_projection projection;
    float last_step;
} turn_view;

static turn_view view_turn(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                           dmi_projection projection) {
    turn_view view = {.projection = projection, .d = {ray->direction.x, ray->direction.y, ray->direction.z}};
    vec3 a = {joint->axis.x, joint->axis.y, joint->axis.z}, o = {joint->origin.x, joint->origin.y, joint->origin.z};
    vec3 eye = {ray->origin.x, ray->origin.y, ray->origin.z}, arm, foot;
    glm_vec3_sub((float*)rest_point, o, arm);
    glm_vec3_scale(a, glm_vec3_dot(arm, a), foot);
    glm_vec3_sub(arm, foot, view.u);
    glm_vec3_cross(a, view.u, view.w);
    glm_vec3_add(o, foot, foot);
    glm_vec3_sub(foot, eye, view.centre);
    glm_vec3_scale(a, joint->type == DM_JOINT_SCREW ? joint->pitch : 0, view.advance);
    return view;
}

/* Not so for a point on the axis of a pure turn, whose arm is the rounding of its coordinates. */
static bool has_way(const dm_joint* joint, const float rest_point[3], turn_view* view) {
    vec3 origin = {joint->origin.x, joint->origin.y, joint->origin.z};
    const float arm = glm_vec3_norm(view->u) + glm_vec3_norm(view->advance);
    return arm > LEAST_ARM * (glm_vec3_norm((float*)rest_point) + glm_vec3_norm(origin));
}

typedef struct slopes {
    float first, second; /* derivatives by the joint value of what is to become least */
} slopes;

/* |P - (d.P) d|^2 / 2 */
static slopes parallel_slopes(vec3 d, vec3 p, vec3 velocity, vec3 acceleration) {
    const float pd = glm_vec3_dot(p, d), vd = glm_vec3_dot(velocity, d), ad = glm_vec3_dot(acceleration, d);
    return (slopes){glm_vec3_dot(p, velocity) - pd * vd,
                    glm_vec3_dot(velocity, velocity) - vd * vd + glm_vec3_dot(p, acceleration) - pd * ad};
}

/* 1 - cos of the angle: -(d.P) / |P| */
static slopes perspective_slopes(vec3 d, vec3 p, vec3 velocity, vec3 acceleration) {
    const float distance = glm_vec3_norm(p), n = glm_vec3_dot(p, d), n1 = glm_vec3_dot(velocity, d);
    const float n2 = glm_vec3_dot(acceleration, d), cosine = n / distance, q1 = glm_vec3_dot(p, velocity) / distance;
    const float q2 = (glm_vec3_dot(velocity, velocity) + glm_vec3_dot(p, acceleration) - q1 * q1) / distance;
    const float g1 = (n1 - cosine * q1) / distance;
    return (slopes){-g1, -(n2 - cosine * q2 - 2 * g1 * q1) / distance};
}

static slopes slopes_at(turn_view* view, float value) {
    const float c = cosf(value), s = sinf(value);
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

/* Newton's method on the slope, kept between the last points known to lie left and right of the minimum. */
static float descend(turn_view* view, float start, float lower, float upper) {
    float left = -INFINITY, right = INFINITY, value = start;
    for (int i = 0; i < MOST_STEPS; i++) {
        const slopes slope = slopes_at(view, value);
        if (!isfinite(slope.first) || !isfinite(slope.second)) return start;
        if (slope.first == 0 || (slope.first < 0 && value >= upper) || (slope.first > 0 && value <= lower)) break;
        if (slope.first < 0) left = value;
        if (slope.first > 0) right = value;
        float step = slope.second > 0 ? -slope.first / slope.second : -copysignf(LONGEST_STEP, slope.first);
        step = glm_clamp(step, -LONGEST_STEP, LONGEST_STEP);
        float next = glm_clamp(value + step, lower, upper);
        if (fabsf(next - value) <= view->last_step * fmaxf(1, fabsf(value))) return next;
        if (next <= left || next >= right) next = 0.5f * (left + right);
        value = next;
    }
    return value;
}

/* How far apart the point at `value` and the ray look, as a length where the point is; behind the eye, infinite. */
static float look_apart(turn_view* view, float value) {
    const float c = cosf(value), s = sinf(value);
    vec3 p;
    for (int i = 0; i < 3; i++) {
        p[i] = view->centre[i] + c * view->u[i] + s * view->w[i] + value * view->advance[i];
    }
    const float along = glm_vec3_dot(p, view->d);
    if (view->projection == DMI_PERSPECTIVE && !(along > 0)) return INFINITY;
    for (int i = 0; i < 3; i++) p[i] -= along * view->d[i];
    return glm_vec3_norm(p);
}

/* A circle seen at a slant runs out and back on the screen, and the two branches meet in a fold. There a point that
 * only goes downhill would turn round when the pointer comes back on the other branch. So the other branch's place,
 * mirrored at the fold, is tried too, and taken when it looks clearly nearer; not far from the fold alone, where the
 * branches look alike, so that nothing sweeps across. */
static float pass_fold(turn_view* view, float value, float lower, float upper) {
    const float out = glm_vec3_dot(view->u, view->d), side = glm_vec3_dot(view->w, view->d);
    const float arm = glm_vec3_norm(view->u);
    if (!(out * out + side * side > LEAST_SLANT * LEAST_SLANT * arm * arm)) return value;
    const float quarter = GLM_PI_2f, slope = atan2f(side, out) + quarter; /* where the circle runs along the ray */
    const float fold = slope + GLM_PIf * roundf((value - slope) / GLM_PIf), gap = 2 * (fold - value);
    const float other = value + gap, longest = value > lower && value < upper ? LONGEST_FOLD : LONGEST_AT_LIMIT;
    if (fabsf(gap) > longest || other < lower || other > upper) return value;
    const float here = look_apart(view, value);
    if (here < LEAST_FOLD * arm) return value;
    const float there = descend(view, other, lower, upper), then = look_apart(view, there);
    const float passed = (there - fold) * (value - fold);
    return passed < 0 && then < here - LEAST_FOLD * arm ? there : value;
}

static float follow(const dm_joint* joint, const float rest_point[3], const dm_ray* ray, dmi_projection projection,
                    float start, float lower, float upper, int roughly) {
    float value = start;
    if (joint->type == DM_JOINT_PRISMATIC) {
        value = follow_slide(joint, rest_point, ray, projection, start, lower, upper);
    } else if (dmi_joint_turns(joint->type)) {
        turn_view view = view_turn(joint, rest_point, ray, projection);
        view.last_step = roughly ? LAST_ROUGH_STEP : LAST_STEP;
        if (!has_way(joint, rest_point, &view)) return start;
        const float least = fmaxf(lower, start - GLM_PIf), most = fminf(upper, start + GLM_PIf);
        value = descend(&view, start, least, most);
        if (!roughly) value = pass_fold(&view, value, least, most);
    }
    return isfinite(value) ? glm_clamp(value, lower, upper) : start;
}

float dmi_follow_ray(const dm_joint* joint, const float rest_point[3], const dm_ray* ray, dmi_projection projection,
                     float start, float lower, float upper) {
    return follow(joint, rest_point, ray, projection, start, lower, upper, 0);
}

float dmi_follow_ray_roughly(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                             dmi_projection projection, float start, float lower, float upper) {
    return follow(joint, rest_point, ray, projection, start, lower, upper, 1);
}
