/* Axis hardware: pins, knuckles, sockets, rims and shells that lie on the axis of a candidate joint, on the part and on
 * the body. A pair in line, one on either side, suggests a hinge more strongly than a single one. */
#ifndef DMI_FEATURES_AXIS_HARDWARE_H
#define DMI_FEATURES_AXIS_HARDWARE_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/features/feature_table.h"

/* Fills the group HARDWARE but for what compares candidates. */
void dmi_axis_hardware_features(const dmi_part_analysis* analysis, const dmi_candidate* candidate,
                                float row[DMI_FEATURE_COUNT]);

#endif
