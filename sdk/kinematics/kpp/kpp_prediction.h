/* KPP-Net's prediction for one part in the object-normalised frame. */
#ifndef DMI_KPP_KPP_PREDICTION_H
#define DMI_KPP_KPP_PREDICTION_H

#include "kinematics/kpp/kpp_net.h"

typedef struct dmi_prediction {
    float type[DMI_KPP_TYPES];                    /* probabilities, sum 1 */
    float turn_axis[3], slide_axis[3], origin[3]; /* unit axes; a point of the turn's axis */
    float turn_limits[2];                         /* lower, upper; rad */
    float slide_limits[2];                        /* lower, upper; object sizes */
    float pitch;                                  /* object sizes per rad */
} dmi_prediction;

/* Converts the network's raw outputs: normalises axes, computes probabilities, transforms out of the input's frame. */
void dmi_prediction_read(const dmi_kpp_frame* frame, const dmi_kpp_output* raw, dmi_prediction* out);

#endif
