/* KPP-Net's answer about one part, in the object-normalised frame. */
#ifndef DMI_KPP_KPP_PREDICTION_H
#define DMI_KPP_KPP_PREDICTION_H

#include "kinematics/kpp/kpp_net.h"

typedef struct dmi_prediction {
    float type[DMI_KPP_TYPES]; /* probabilities */
    float turn_axis[3], slide_axis[3], origin[3];
    float turn_limits[2], slide_limits[2], pitch;
} dmi_prediction;

/* Reads the raw heads: normalises axes, turns logits into probabilities, leaves the input's frame. */
void dmi_prediction_read(const dmi_kpp_frame* frame, const dmi_kpp_output* raw, dmi_prediction* out);

#endif
