/* A true joint as the naive hand needs it, and what is wrong with another one. */
#include "dragbot_naive.h"

/* All by hand. */
static const double right_angle_error = 10 * PI / 180; /* rad: the axis is right */
static const double right_line = 0.05;                 /* of the object's size: the axis' line is right */
static const double upright = 0.7;                     /* cosine between the axis and up: the part opens like a door */
static const double middle_arm = 1e-3;                 /* of the object's size: the part's middle moves */
static const double hinge_arm = 1e-2; /* of the object's size: the part lies to one side of its hinge */
static const double place_vote = 0.5; /* of where the part is in the object, against the way it moves */
static const double vote_step = 1e-3; /* votes that differ by less are the same */

static vec foot_on_axis(const known_joint* joint, vec point) {
    return add(joint->origin, scale(joint->axis, dot(sub(point, joint->origin), joint->axis)));
}

dm_result bot_truth_make(const bot_object* object, int joint, bot_truth* out_truth) {
    const known_joint* known = &object->known.joints[joint];
    const session* session = object->session;
    dm_object_info info = {.struct_size = sizeof info};
    dm_part_info part = {.struct_size = sizeof part};
    dm_result result = dm_object_get_info(session->context, session->object, &info);
    if (result == DM_OK) result = dm_object_get_part(session->context, session->object, 0, &part);
    if (result != DM_OK) return result;
    const vec centre = scale(add(vec_of(part.box_min), vec_of(part.box_max)), 0.5);
    *out_truth = (bot_truth){.joint = known,
                             .side = bot_travel(known, object->size) < 0 ? -1 : 1,
                             .low = vec_of(info.box_min),
                             .high = vec_of(info.box_max),
                             .part_low = vec_of(part.box_min),
                             .part_high = vec_of(part.box_max),
                             .centre = centre,
                             .at = foot_on_axis(known, centre),
                             .size = object->size};
    return DM_OK;
}

bool bot_joint_turns(const dm_joint* joint) {
    return joint->type == DM_JOINT_REVOLUTE || joint->type == DM_JOINT_CONTINUOUS;
}

enum bot_wrong bot_truth_compare(const bot_truth* truth, const dm_joint* joint) {
    const bool slides = truth->joint->slides;
    if (slides ? joint->type != DM_JOINT_PRISMATIC : !bot_joint_turns(joint)) return BOT_WRONG_TYPE;
    const vec axis = unit(vec_of(joint->axis));
    if (fabs(dot(axis, truth->joint->axis)) < cos(right_angle_error)) return BOT_WRONG_AXIS;
    if (slides) return BOT_RIGHT;
    const vec off = sub(truth->at, vec_of(joint->origin));
    return length(sub(off, scale(axis, dot(off, axis)))) < right_line * truth->size ? BOT_RIGHT : BOT_WRONG_LINE;
}

vec bot_truth_motion(const bot_truth* truth, vec point) {
    const known_joint* joint = truth->joint;
    return scale(joint->slides ? joint->axis : cross(joint->axis, sub(point, joint->origin)), truth->side);
}

/* ---- the side of a person ---- */

static vec flatten(vec direction, vec up) {
    return sub(direction, scale(up, dot(direction, up)));
}

/* Returns which side the part's way, its place on its hinge and its place in the object speak for. */
static vec vote_for_side(const bot_truth* truth, vec up) {
    const vec motion = bot_truth_motion(truth, truth->centre), arm = sub(truth->centre, truth->at);
    const vec middle = scale(add(truth->low, truth->high), 0.5);
    vec vote = {0, 0, 0};
    if (length(motion) > middle_arm * truth->size) vote = flatten(unit(motion), up);
    if (!truth->joint->slides && fabs(dot(truth->joint->axis, up)) < upright && length(arm) > hinge_arm * truth->size)
        vote = add(vote, flatten(unit(arm), up));
    return add(vote, scale(flatten(sub(truth->centre, middle), up), place_vote / truth->size));
}

vec bot_truth_front(const bot_truth* truth, vec up) {
    /* glTF's front is +z. */
    static const vec sides[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    const vec vote = vote_for_side(truth, up);
    vec best = {0, 0, 0};
    double most = -INFINITY;
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        const double votes = vote_step * round(dot(sides[i], vote) / vote_step);
        if (fabs(dot(sides[i], up)) > 0.5 || !(votes > most)) continue;
        best = sides[i];
        most = votes;
    }
    return best;
}
