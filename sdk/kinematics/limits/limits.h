/* Limits of joints: how far a joint goes from rest before the part meets the body. Where nothing stops it, a usual
 * opening is the limit. A part may rest open; its closed pose is a limit then. */
#ifndef DMI_LIMITS_LIMITS_H
#define DMI_LIMITS_LIMITS_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/limits/limit_network.h"

/* Measures what the limits of a joint depend on: its sweep to either side, its shape, KPP-Net's guess. Returns the unit
 * that limits are learnt in: 1 rad, or the part's extent along a slide. prediction may be NULL. */
float dmi_limits_features(const dmi_part_analysis* analysis, const dmi_prediction* prediction, int with_drag,
                          const dm_joint* joint, float out[DMI_LIMIT_FEATURES]);

/* Signs a joint without a drag. The side with more room before the part meets the body becomes positive. */
void dmi_limits_face_room(const dmi_part_analysis* analysis, dm_joint* joint);

/* Sets lower and upper of revolute, prismatic or screw joints (inner frame), and turns a revolute one that nothing
 * stops into a continuous one. count: at most DM_MAX_HYPOTHESES. with_drag: positive follows a drag; else the joints
 * come back with the longer way on the positive side. features: each joint's candidate features. prediction and network
 * may be NULL; without a network, rules set the limits. */
void dmi_limits_set(const dmi_part_analysis* analysis, const dmi_prediction* prediction, int with_drag,
                    const dmi_limit_network* network, dmi_isa isa, const float* const* features, dm_joint* joints,
                    uint32_t count);

/* closed_pose.c: finds the value at which a sliding part is closed, where that is not rest. Returns false where it
 * rests closed, and where the shape does not tell: it turns, it is small, nothing stops it or both sides do, or its
 * front comes flush with nothing where it is stopped. joint: object-normalised frame; its limits are not used. */
bool dmi_closed_pose_find(const dmi_part_analysis* analysis, const dm_joint* joint, float* out_value);

#endif
