/* How a part truly moves, and how poses move its points. */
#include <math.h>
#include <stdbool.h>

#include "dragbot.h"

static const double free_slide = 0.1; /* share of the object's size pulled where no limits are known; by hand */

vec bot_true_move(const known_joint* truth, vec point, double value) {
    if (truth->slides) return add(point, scale(truth->axis, value));
    return add(truth->origin, turn(sub(point, truth->origin), truth->axis, value));
}

vec bot_true_direction(const known_joint* truth, vec point, double value) {
    const vec way = truth->slides ? truth->axis : cross(truth->axis, sub(point, truth->origin));
    return unit(scale(way, value < 0 ? -1 : 1));
}

/* Returns the side of rest, +1 or -1, that the dataset's drags pull to. */
static double side_of(const known_joint* truth) {
    if (truth->drag_count == 0) return fabs(truth->lower) > fabs(truth->upper) ? -1 : 1;
    const vec point = truth->drags[0].point;
    const vec way = truth->slides ? truth->axis : cross(truth->axis, sub(point, truth->origin));
    return dot(way, truth->drags[0].vector) < 0 ? -1 : 1;
}

double bot_travel(const known_joint* truth, double size) {
    const double side = side_of(truth), end = side > 0 ? truth->upper : truth->lower;
    if (isfinite(end) && end * side > 0) return end;
    return side * (truth->slides ? free_slide * size : 0.5 * PI);
}

dm_joint bot_true_joint(const known_joint* truth) {
    dm_joint joint = {.struct_size = sizeof joint, .axis = vec_out(truth->axis), .origin = vec_out(truth->origin)};
    const bool limited = isfinite(truth->lower) && isfinite(truth->upper);
    joint.type = truth->slides ? DM_JOINT_PRISMATIC : limited ? DM_JOINT_REVOLUTE : DM_JOINT_CONTINUOUS;
    if (limited) joint.lower = (float)truth->lower, joint.upper = (float)truth->upper;
    return joint;
}

vec bot_moved(const dm_pose* pose, vec point) {
    float xyz[3] = {(float)point.x, (float)point.y, (float)point.z};
    dm_pose_apply_points(pose, xyz, 0, xyz, 0, 1);
    return vec_at(xyz);
}

double bot_apart(const bot_part* part, const dm_pose* a, const dm_pose* b) {
    double most = 0;
    for (int i = 0; i < BOT_EXTREMES; i++)
        most = fmax(most, length(sub(bot_moved(a, part->extremes[i]), bot_moved(b, part->extremes[i]))));
    return most / part->object_size;
}
