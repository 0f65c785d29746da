/* Makes batches for KPP-Net: inputs by dmi_kpp_input_make, labels in the input's own frame. */
#include <math.h>
#include <string.h>

#include "lab_given.h"
#include "pull.h"

static float clamped(float value, float most) {
    return fmaxf(-most, fminf(most, value));
}

static void write_labels(const dm_joint* joint, const dmi_kpp_frame* frame, const dm_lab_kpp* out, size_t i) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    const float from[3] = {joint->origin.x - frame->origin[0], joint->origin.y - frame->origin[1],
                           joint->origin.z - frame->origin[2]};
    dmi_kpp_frame_rotate(frame, axis, out->axis + 3 * i);
    dmi_kpp_frame_rotate(frame, from, out->origin + 3 * i);
    for (int k = 0; k < 3; k++) out->origin[3 * i + k] *= frame->scale;
    float* limits = out->limits + 5 * i;
    memset(limits, 0, 5 * sizeof(float));
    const int turns = joint->type == DM_JOINT_REVOLUTE || joint->type == DM_JOINT_SCREW;
    const float unit = turns ? 1.0f / 3.14159265f : frame->scale;
    if (joint->type != DM_JOINT_CONTINUOUS) {
        limits[turns ? 0 : 2] = clamped(joint->lower * unit, 4.0f);
        limits[turns ? 1 : 3] = clamped(joint->upper * unit, 4.0f);
    }
    if (joint->type == DM_JOINT_SCREW) limits[4] = clamped(joint->pitch * frame->scale, 4.0f);
    out->type[i] = joint->type - 1;
    out->size[i] = 1.0f / frame->scale;
}

/* hint: NULL without a drag. */
static void write_case(const lab_case* made, const dmi_drag_hint* hint, const dm_joint* joint, dmi_kpp_input* input,
                       const dm_lab_kpp* out, size_t i) {
    dmi_kpp_input_make(&made->cloud, 0, hint, input);
    memcpy(out->global_points + i * sizeof input->global_points / 4, input->global_points, sizeof input->global_points);
    memcpy(out->global_centres + i * sizeof input->global_centres / 4, input->global_centres,
           sizeof input->global_centres);
    memcpy(out->local_points + i * sizeof input->local_points / 4, input->local_points, sizeof input->local_points);
    memcpy(out->local_centres + i * sizeof input->local_centres / 4, input->local_centres, sizeof input->local_centres);
    memcpy(out->shape + i * DMI_KPP_SHAPE, input->shape, sizeof input->shape);
    out->has_drag[i] = hint != NULL;
    out->category[i] = (int32_t)made->category_id;
    write_labels(joint, &input->frame, out, i);
}

static void write_generated(lab_case* made, const dm_lab_options* options, dmi_kpp_input* input, const dm_lab_kpp* out,
                            uint32_t i) {
    dm_joint joint = made->joint;
    const int with_drag = lab_random_bool(&made->random, options->with_drag);
    dmi_drag_hint hint;
    if (with_drag) hint = lab_case_drag(made, options->pull, options->drag_noise_degrees, &joint);
    write_case(made, with_drag ? &hint : NULL, &joint, input, out, i);
}

dm_result dm_lab_kpp_batch(const dm_lab_options* options, const dm_lab_kpp* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    lab_case* made = dmi_alloc(&env, sizeof *made, 64);
    dmi_kpp_input* input = dmi_alloc(&env, sizeof *input, 64);
    dm_result result = made && input ? DM_OK : DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        result = lab_case_make(&env, options, i, made);
        if (result != DM_OK) break;
        write_generated(made, options, input, out, i);
        lab_case_release(&env, made);
    }
    dmi_free(&env, input, sizeof *input);
    dmi_free(&env, made, sizeof *made);
    return result;
}

dm_result dm_lab_kpp_given(const dm_lab_given* given, const dm_lab_options* options, const dm_lab_kpp* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    lab_case* made = dmi_alloc(&env, sizeof *made, 64);
    dmi_kpp_input* input = dmi_alloc(&env, sizeof *input, 64);
    dm_result result = made && input ? lab_case_given(&env, given, made) : DM_ERROR_OUT_OF_MEMORY;
    if (result == DM_OK) {
        made->random = dmi_random_make(options->seed, 0);
        dm_joint joint = made->joint;
        const int with_drag = lab_random_bool(&made->random, options->with_drag);
        dmi_drag_hint hint;
        if (with_drag) hint = lab_given_drag(made, given, options->drag_noise_degrees, &joint);
        write_case(made, with_drag ? &hint : NULL, &joint, input, out, 0);
        lab_case_release(&env, made);
    }
    dmi_free(&env, input, sizeof *input);
    dmi_free(&env, made, sizeof *made);
    return result;
}
