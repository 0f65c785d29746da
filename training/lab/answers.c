/* Runs the library's whole joint inference on generated cases and measures the errors of its answers. */
#include "answers.h"

#include <math.h>
#include <string.h>

#include "hint_draw.h"
#include "kinematics/inference/joint_inference.h"
#include "math/linear3.h"
#include "pose_error.h"
#include "pull.h"

static void score(const lab_case* made, const dm_joint* truth, const float drag_point[3], const dm_joint* answer,
                  const dm_lab_answers* out, uint32_t at) {
    const float axis[3] = {answer->axis.x, answer->axis.y, answer->axis.z};
    const float origin[3] = {answer->origin.x, answer->origin.y, answer->origin.z};
    const float true_axis[3] = {truth->axis.x, truth->axis.y, truth->axis.z};
    const float true_origin[3] = {truth->origin.x, truth->origin.y, truth->origin.z};
    const int slides = answer->type == DM_JOINT_PRISMATIC;
    lab_pose_target target;
    lab_pose_target_make(&made->cloud, truth, drag_point, &target);
    out->pose[at] = lab_pose_error(&target, slides ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE, axis, origin);
    out->confidence[at] = answer->joint_confidence;
    out->right_type[at] = slides == (truth->type == DM_JOINT_PRISMATIC);
    out->axis_error[at] = acosf(fminf(fabsf(dmi_dot3(axis, true_axis)), 1));
    out->line_error[at] = slides ? -1 : dmi_line_distance3(origin, true_axis, true_origin);
    out->category[at] = (int32_t)made->category_id;
}

/* shares: of asset hints; NULL: none are drawn. */
static dm_result answer_case(dmi_env* env, const dm_lab_options* options, const dm_lab_hint_options* shares,
                             const dmi_kpp_net* net, const dmi_joint_models* joints, lab_case* made,
                             const dm_lab_answers* out, uint32_t at) {
    dm_joint truth;
    const dmi_drag_hint hint = lab_case_drag(made, options->pull, options->drag_noise_degrees, &truth);
    const int with_drag = lab_random_bool(&made->random, options->with_drag);
    const uint32_t part = (uint32_t)dmi_mesh_find_part(made->mesh, made->part);
    dmi_asset_hints hints = {.has_pivot = false};
    if (shares != NULL) hints = lab_draw_hints(&made->random, made, part, shares);
    const dmi_inference_query query = {.mesh = made->mesh,
                                       .cloud = &made->cloud,
                                       .models = {net, joints, dmi_cpu_best_isa()},
                                       .hint = with_drag ? &hint : NULL,
                                       .asset_hints = &hints,
                                       .welded = made->welded,
                                       .part = part};
    dmi_hypotheses found;
    const dm_result result = dmi_joint_inference_run(env, &query, &found, NULL);
    if (result != DM_OK) return result;
    out->has_drag[at] = with_drag;
    score(made, &truth, hint.point, &found.joints[0], out, at);
    return DM_OK;
}

dm_result dm_lab_answer(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                        const void* ranker, size_t ranker_size, const dm_lab_answers* out) {
    return dm_lab_answer_hinted(options, NULL, kinematics, kinematics_size, ranker, ranker_size, out);
}

dm_result dm_lab_answer_hinted(const dm_lab_options* options, const dm_lab_hint_options* hints, const void* kinematics,
                               size_t kinematics_size, const void* ranker, size_t ranker_size,
                               const dm_lab_answers* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_kpp_net* net = NULL;
    dmi_joint_models* joints = NULL;
    lab_case* made = dmi_alloc(&env, sizeof *made, 64);
    dm_result result = made != NULL ? DM_OK : DM_ERROR_OUT_OF_MEMORY;
    if (result == DM_OK && kinematics != NULL) result = dmi_kpp_net_load(&env, kinematics, kinematics_size, &net);
    if (result == DM_OK && ranker != NULL) result = dmi_joint_models_load(&env, ranker, ranker_size, &joints);
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        result = lab_case_make(&env, options, i, made);
        if (result != DM_OK) break;
        result = answer_case(&env, options, hints, net, joints, made, out, i);
        lab_case_release(&env, made);
    }
    dmi_joint_models_destroy(joints);
    if (net != NULL) dmi_kpp_net_destroy(net);
    if (made != NULL) dmi_free(&env, made, sizeof *made);
    return result;
}
