/* The motion of an answered part from rest to fully open. */
#ifndef CLI_PLAY_H
#define CLI_PLAY_H

#include "job.h"

/* `count` (2 or more) poses at even times. With a drag and motion weights it is the network's motion; else the joint's
 * own motion at minimum-jerk pace. out_values may be NULL. */
dm_result play_motion(session* session, const job* job, const joint_answer* answer, uint32_t count, dm_pose* out_poses,
                      float* out_values);
/* The joint value that opens the part fully in the direction of the drag (a continuous joint: one turn). */
float play_target(const dm_joint* joint);
/* Minimum-jerk progress (Flash and Hogan 1985): 0..1 to 0..1. */
float minimum_jerk(float t);
/* An animated .glb of the session's file, looping there and back, to be given back to dm_gltf_release_bytes;
 * session->error on failure. */
dm_result play_export(session* session, const dm_pose* poses, uint32_t count, float seconds, void** out_data,
                      size_t* out_size);

#endif
