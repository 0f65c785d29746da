/* Shows hypotheses to the host, with the places that they take the part to. */
#include "kinematics/object/prepare_steps.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define OPEN_TURN DMI_HALF_PI_F /* rad from rest, of an end that no limit sets; by hand */
#define OPEN_SLIDE 0.5f         /* object sizes from rest, of an end that no limit sets; by hand */

enum { ENDS = 2 };

/* A part's hypotheses as the host gets them, and the ends of their ranges. */
typedef struct question {
    dm_joint joints[DM_MAX_HYPOTHESES];
    dm_hypothesis hypotheses[DM_MAX_HYPOTHESES];
    const dm_hypothesis* list[DM_MAX_HYPOTHESES];
} question;

/* Returns the value at the lower (0) or the upper (1) end of an inner joint. */
static float value_at(const dm_joint* joint, int end) {
    if (dmi_joint_has_limits(joint)) return end ? joint->upper : joint->lower;
    const float open = dmi_joint_turns(joint->type) ? OPEN_TURN : OPEN_SLIDE;
    return end ? open : -open;
}

/* Computes the box of a part at `pose`, in the inner frame. */
static void box_at(const dmi_mesh* mesh, uint32_t part, const dm_pose* pose, float min[3], float max[3]) {
    for (int k = 0; k < 3; k++) min[k] = FLT_MAX, max[k] = -FLT_MAX;
    for (uint32_t face = 0; face < mesh->face_count; face++) {
        if (mesh->face_part[face] != part) continue;
        for (int corner = 0; corner < 3; corner++) {
            float p[3];
            dmi_pose_apply(pose, mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)face + corner], p);
            for (int k = 0; k < 3; k++) min[k] = dmi_fminf(min[k], p[k]), max[k] = dmi_fmaxf(max[k], p[k]);
        }
    }
}

static dm_joint_end describe_end(const dmi_object* object, const dmi_mesh* mesh, uint32_t part, const dm_joint* joint,
                                 int end) {
    const dmi_frame* frame = &object->frame;
    const float value = value_at(joint, end);
    const dm_pose pose = dmi_joint_pose(joint, value);
    float min[3], max[3], centre[3], centre_out[3];
    box_at(mesh, part, &pose, min, max);
    dmi_pose_apply(&pose, object->parts[part].shape.centre, centre);
    dmi_frame_point_out(frame, centre, centre_out);
    dm_joint_end out = {.value = joint->type == DM_JOINT_PRISMATIC ? value * dmi_frame_length_out(frame) : value,
                        .pose = dmi_frame_pose_out(frame, &pose),
                        .centre = dmi_vec3(centre_out)};
    dmi_object_box_out(frame, min, max, &out.box_min, &out.box_max);
    return out;
}

static void describe_hypotheses(const dmi_object* object, const dmi_mesh* mesh, uint32_t part, question* out) {
    const dmi_hypotheses* found = &object->parts[part].hypotheses;
    for (uint32_t i = 0; i < found->count; i++) {
        out->joints[i] = dmi_frame_joint_out(&object->frame, &found->joints[i]);
        out->joints[i].struct_size = sizeof out->joints[i];
        out->hypotheses[i] = (dm_hypothesis){.struct_size = sizeof *out->hypotheses, .joint = &out->joints[i]};
        for (int end = 0; end < ENDS; end++)
            out->hypotheses[i].ends[end] = describe_end(object, mesh, part, &found->joints[i], end);
        out->list[i] = &out->hypotheses[i];
    }
}

dm_result dmi_choose_joint(dmi_env* env, dmi_object* object, const dmi_mesh* mesh, uint32_t index,
                           dm_choice_callback choose, void* user) {
    dmi_object_part* part = &object->parts[index];
    if (part->given_type == DM_JOINT_FIXED) return DM_OK;
    question asked;
    describe_hypotheses(object, mesh, index, &asked);
    const dm_part_info info = dmi_object_part_out(object, index);
    const dm_choice choice = {
        .struct_size = sizeof choice, .count = part->hypotheses.count, .part = &info, .hypotheses = asked.list};
    const int32_t chosen = choose(user, &choice);
    if (chosen == DM_CHOICE_KEEP) return DM_OK;
    if (chosen < 0 || (uint32_t)chosen >= choice.count)
        return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE,
                        "dm_object_prepare: desc.choose answered %d for part %u, which has %u hypotheses", chosen,
                        info.id, choice.count);
    part->joint = dmi_frame_joint_out(&object->frame, &part->hypotheses.joints[chosen]);
    part->joint.type_confidence = part->joint.joint_confidence = 1;
    part->joint.source = DM_JOINT_CHOSEN;
    return DM_OK;
}
