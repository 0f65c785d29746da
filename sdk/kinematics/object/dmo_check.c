/* Checks numbers read from a .dmo file. */
#include "kinematics/object/dmo_bytes.h"

#include <float.h>
#include <math.h>

#define MAX_AREA 1e12f       /* largest area of a part, object sizes squared; by hand */
#define UNIT_TOLERANCE 2e-5f /* tolerance of an axis' squared length; by hand: rounding leaves 2e-7 */

enum { JOINT_NUMBERS = 6 }; /* numbers of a joint that need only be finite */

bool dmi_dmo_within(const float* values, size_t count, float limit) {
    for (size_t i = 0; i < count; i++) {
        if (!(fabsf(values[i]) <= limit)) return false;
    }
    return true;
}

static bool is_coordinate(const float v[3]) {
    return dmi_dmo_within(v, 3, DMI_DMO_MAX_COORDINATE);
}

bool dmi_dmo_valid_object(const dmi_object* object) {
    return dmi_frame_is_usable(&object->frame) && is_coordinate(object->box_min) && is_coordinate(object->box_max) &&
           object->vertex_count <= DM_MAX_ELEMENTS && object->triangle_count <= DM_MAX_ELEMENTS;
}

bool dmi_dmo_valid_shape(const dmi_part* shape) {
    bool valid = is_coordinate(shape->box_min) && is_coordinate(shape->box_max) && is_coordinate(shape->centre) &&
                 shape->area >= 0.0f && shape->area <= MAX_AREA;
    for (int i = 0; i < 3; i++) valid = valid && shape->box_min[i] <= shape->box_max[i];
    return valid;
}

bool dmi_dmo_valid_tree(const dmi_object* object) {
    for (uint32_t i = 0; i < object->part_count; i++) {
        const dmi_part* shape = &object->parts[i].shape;
        if (i == 0 ? shape->id != 0 || shape->parent != 0 : shape->id <= object->parts[i - 1].shape.id) return false;
        if (shape->parent >= object->part_count) return false;
    }
    for (uint32_t i = 1; i < object->part_count; i++) {
        uint32_t steps = 0;
        for (uint32_t p = i; p != 0; p = object->parts[p].shape.parent) {
            if (steps++ > object->part_count) return false;
        }
    }
    return true;
}

static bool is_share(float value) {
    return value >= 0 && value <= 1;
}

bool dmi_dmo_valid_joint_numbers(const dm_joint* joint) {
    const dm_vec3 a = joint->axis;
    const float numbers[JOINT_NUMBERS] = {joint->origin.x, joint->origin.y, joint->origin.z,
                                          joint->pitch,    joint->lower,    joint->upper};
    return joint->type >= DM_JOINT_REVOLUTE && joint->type <= DM_JOINT_FIXED &&
           fabsf(a.x * a.x + a.y * a.y + a.z * a.z - 1.0f) <= UNIT_TOLERANCE &&
           dmi_dmo_within(numbers, JOINT_NUMBERS, FLT_MAX) && joint->lower <= joint->upper &&
           is_share(joint->type_confidence) && is_share(joint->joint_confidence) &&
           joint->source >= DM_JOINT_FROM_NETWORK && joint->source <= DM_JOINT_CHOSEN;
}

bool dmi_dmo_valid_joint(const dmi_frame* frame, const dm_joint* inner) {
    const dm_joint host = dmi_frame_joint_out(frame, inner);
    return dmi_dmo_valid_joint_numbers(inner) && dmi_dmo_valid_joint_numbers(&host);
}

bool dmi_dmo_valid_alternative(const dmi_frame* frame, const dmi_alternative* alternative) {
    const int32_t type = alternative->type;
    const bool known = type == DM_JOINT_REVOLUTE || type == DM_JOINT_CONTINUOUS || type == DM_JOINT_PRISMATIC;
    const dm_joint joint = dmi_alternative_joint(alternative);
    return known && dmi_dmo_valid_joint(frame, &joint);
}
