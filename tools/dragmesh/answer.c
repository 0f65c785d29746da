/* Answers as JSON and as text. */
#include "answer.h"

#include <stdbool.h>
#include <stdio.h>

#include "joint_type.h"
#include "json.h"
#include "shown.h"

void joint_to_json(const dm_joint* joint, const double frame[3], cJSON* out) {
    cJSON_AddStringToObject(out, "type", joint_type_name(joint->type));
    json_add_number(out, "type_confidence", (double)joint->type_confidence, 4);
    json_add_number(out, "confidence", (double)joint->joint_confidence, 4);
    json_add_vector(out, "axis", joint->axis);
    json_add_point(out, "origin", joint->origin, frame);
    const bool limited = joint->type != DM_JOINT_CONTINUOUS;
    json_add_number(out, "lower", limited ? (double)joint->lower : NAN, 9);
    json_add_number(out, "upper", limited ? (double)joint->upper : NAN, 9);
    if (joint->closed != 0) json_add_number(out, "closed", (double)joint->closed, 9);
    if (joint->type == DM_JOINT_SCREW) json_add_number(out, "pitch", (double)joint->pitch, 9);
}

void answer_to_json(const joint_answer* answer, cJSON* out) {
    joint_to_json(&answer->joint, answer->frame, out);
    cJSON* hypotheses = cJSON_AddArrayToObject(out, "hypotheses");
    for (uint32_t i = 0; i < answer->hypothesis_count; i++) {
        cJSON* hypothesis = cJSON_CreateObject();
        joint_to_json(&answer->hypotheses[i], answer->frame, hypothesis);
        choice_ends_to_json(&answer->choice, i, answer->frame, hypothesis);
        cJSON_AddItemToArray(hypotheses, hypothesis);
    }
    if (answer->choice.count > 0 && answer->choice.chosen >= 0)
        cJSON_AddNumberToObject(out, "chosen", answer->choice.chosen);
    else if (answer->choice.count > 0)
        cJSON_AddNullToObject(out, "chosen");
    if (answer->ambiguous_mask)
        cJSON_AddStringToObject(out, "note", "the mask's length fits vertices and triangles; read per vertex");
    cJSON* ms = cJSON_AddObjectToObject(out, "ms");
    json_add_number(ms, "prepare", answer->prepare_ms, 5);
    json_add_number(ms, "kpp", answer->kinematics_ms, 5);
    json_add_number(ms, "motion", answer->motion_ms, 5);
}

void joint_print(const dm_joint* joint, const double frame[3]) {
    const char* unit = joint->type == DM_JOINT_PRISMATIC ? "units" : "rad";
    printf("%-10s %3.0f %%  axis (%.4f, %.4f, %.4f)  origin (%.4f, %.4f, %.4f)", joint_type_name(joint->type),
           (double)joint->joint_confidence * 100, shown((double)joint->axis.x, 4), shown((double)joint->axis.y, 4),
           shown((double)joint->axis.z, 4), shown((double)joint->origin.x + frame[0], 4),
           shown((double)joint->origin.y + frame[1], 4), shown((double)joint->origin.z + frame[2], 4));
    if (joint->type != DM_JOINT_CONTINUOUS)
        printf("  from %.4f to %.4f %s", shown((double)joint->lower, 4), shown((double)joint->upper, 4), unit);
    printf("\n");
}

void confidence_print(void) {
    printf("%%: how probable it is that type, axis and origin are all right\n");
}

void answer_print(const joint_answer* answer) {
    joint_print(&answer->joint, answer->frame);
    const uint32_t active = answer->choice.count > 0 && answer->choice.chosen > 0 ? (uint32_t)answer->choice.chosen : 0;
    for (uint32_t i = 0; i < answer->hypothesis_count; i++) {
        if (i == active) continue;
        printf("   or ");
        joint_print(&answer->hypotheses[i], answer->frame);
    }
    confidence_print();
    printf("%.1f ms to prepare, %.1f ms of them kinematics; %.2f ms for the motion\n", answer->prepare_ms,
           answer->kinematics_ms, answer->motion_ms);
}
