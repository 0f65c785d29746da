/* Makes candidates of KPP-Net's prediction. */
#include "kinematics/candidates/candidates.h"
#include "math/linear3.h"

void dmi_prediction_candidates(const dmi_prediction* prediction, const float centre[3], dmi_candidate out[2],
                               float out_probability[2]) {
    const float* axes[2] = {prediction->turn_axis, prediction->slide_axis};
    const float* points[2] = {prediction->origin, centre};
    for (int i = 0; i < 2; i++) {
        float arm[3];
        out[i] = (dmi_candidate){.type = i == 0 ? DM_JOINT_REVOLUTE : DM_JOINT_PRISMATIC,
                                 .direction_families = DMI_DIRECTION_NETWORK,
                                 .origin_families = DMI_ORIGIN_NETWORK};
        dmi_copy3(axes[i], out[i].axis);
        dmi_sub3(centre, points[i], arm);
        const float along = dmi_dot3(arm, axes[i]);
        for (int k = 0; k < 3; k++) out[i].origin[k] = points[i][k] + along * axes[i][k];
    }
    out_probability[1] = prediction->type[DM_JOINT_PRISMATIC - 1];
    out_probability[0] = 1 - out_probability[1];
}
