/* How people pull: the likelihood of a pull, given the joint that the part has. */
#ifndef DMI_DRAG_HAND_LIKELIHOOD_H
#define DMI_DRAG_HAND_LIKELIHOOD_H

#include "drag/joint_hypothesis.h"

/* Adds one more ray to the pull. */
void dmi_grasp_add(dmi_grasp* grasp, const dm_ray* ray);
/* Returns whether the pull bends so little that the hand may have meant a straight line. */
bool dmi_grasp_is_straight(const dmi_grasp* grasp);
/* Whether the pull can't tell this joint's value, nor anything against it: the part was grabbed on this joint, whose
 * first motion is seen end on. */
bool dmi_joint_hypothesis_is_end_on(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis);
/* Returns the residual that the right joint has with an unsteady pointer, host units. */
float dmi_expected_residual(const dmi_grasp* grasp);
/* Returns the log likelihood of a hand that follows the part exactly and misses it by this largest residual. */
float dmi_followed_log_likelihood(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, float residual);
/* Returns the log likelihood of the pull, summed over the ways in which a hand may pull. residual: the largest one. */
float dmi_joint_hypothesis_log_likelihood(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis,
                                          float residual);

#endif
