/* Converts the network's raw outputs. */
#include "kinematics/kpp/kpp_prediction.h"

#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define MIN_AXIS 1e-6f /* length of a raw axis below which it has no direction; by hand */

/* Rotates a vector out of the frame. */
static void rotate_out(const dmi_kpp_frame* frame, const float in[3], float out[3]) {
    for (int k = 0; k < 3; k++)
        out[k] = in[0] * frame->rotation[k] + in[1] * frame->rotation[3 + k] + in[2] * frame->rotation[2 * 3 + k];
}

void dmi_prediction_read(const dmi_kpp_frame* frame, const dmi_kpp_output* raw, dmi_prediction* out) {
    static const float x_axis[3] = {1, 0, 0};
    memcpy(out->type, raw->type_logits, sizeof out->type);
    dmi_softmax(out->type, DMI_KPP_TYPES);
    rotate_out(frame, raw->turn_axis, out->turn_axis);
    rotate_out(frame, raw->slide_axis, out->slide_axis);
    if (!(dmi_normalize3(out->turn_axis) > MIN_AXIS)) rotate_out(frame, x_axis, out->turn_axis);
    if (!(dmi_normalize3(out->slide_axis) > MIN_AXIS)) rotate_out(frame, x_axis, out->slide_axis);
    rotate_out(frame, raw->origin, out->origin);
    for (int k = 0; k < 3; k++) out->origin[k] = frame->origin[k] + out->origin[k] / frame->scale;
    for (int k = 0; k < 2; k++) {
        out->turn_limits[k] = raw->limits[k] * DMI_PI_F;
        out->slide_limits[k] = raw->limits[2 + k] / frame->scale;
    }
    out->pitch = raw->limits[DMI_KPP_LIMITS - 1] / frame->scale;
}
