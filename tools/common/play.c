/* The motion of an answered part, from rest to fully open. */
#include "play.h"

#include <math.h>
#include <stdlib.h>

#include "constants.h"

#define REST_SHARE 0.05f /* of the range: an upper limit this near to rest is the end where the part rests; by hand */

float play_target(const dm_joint* joint) {
    if (joint->type == DM_JOINT_CONTINUOUS) return (float)TWO_PI;
    /* A positive step follows the drag, so the part opens to the upper limit, unless it rests there. */
    const float near = REST_SHARE * (joint->upper - joint->lower);
    return joint->upper > near ? joint->upper : joint->lower;
}

float minimum_jerk(float t) {
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

static dm_result sample_network(session* session, const job* job, uint32_t count, dm_pose* out_poses,
                                float* out_values) {
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = JOB_PART, .drag = job->drag};
    dm_motion motion;
    dm_result result = dm_motion_generate(session->context, session->object, &desc, &motion);
    if (result != DM_OK) return result;
    for (uint32_t i = 0; i < count && result == DM_OK; i++)
        result = dm_motion_sample(session->context, motion, (float)i / (float)(count - 1), &out_poses[i],
                                  out_values != NULL ? &out_values[i] : NULL);
    dm_motion_destroy(session->context, motion);
    return result;
}

dm_result play_motion(session* session, const job* job, const joint_answer* answer, uint32_t count, dm_pose* out_poses,
                      float* out_values) {
    if (session->has_motion && job->has_drag) return sample_network(session, job, count, out_poses, out_values);
    const float target = play_target(&answer->joint);
    for (uint32_t i = 0; i < count; i++) {
        const float value = target * minimum_jerk((float)i / (float)(count - 1));
        const dm_result result = dm_joint_pose(&answer->joint, value, &out_poses[i]);
        if (result != DM_OK) return session_fail(session, result, "the joint has no pose");
        if (out_values != NULL) out_values[i] = value;
    }
    return DM_OK;
}

dm_result play_export(session* session, const dm_pose* poses, uint32_t count, float seconds, void** out_data,
                      size_t* out_size) {
    float* times = cli_alloc(count * sizeof *times);
    for (uint32_t i = 0; i < count; i++) times[i] = seconds * (float)i / (float)(count - 1);
    uint8_t* moving = session_moving_faces(session);
    const dm_gltf_track track = {
        .name = "dragmesh_part", .face_ids = moving, .value = 1, .poses = poses, .times = times, .key_count = count};
    const dm_result result = dm_gltf_export(session->gltf, &track, 1, out_data, out_size);
    free(moving);
    free(times);
    return result;
}
