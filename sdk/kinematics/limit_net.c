/* Forward pass of the limits' network: three dense layers, then sizes on a logarithmic scale. */
#include "kinematics/limit_net.h"

#include <math.h>

#define LEAST 0.01f /* sizes are learnt as log(size + LEAST) */
#define MOST 7.0f
#define AT_AN_END 0.05f /* less room than this share of the other side: it rests at the end */

int dmi_limit_net_read(const dmi_weights* weights, dmi_limit_net* out_net) {
    const uint32_t in = DMI_LIMIT_FEATURES, hidden = DMI_LIMIT_HIDDEN;
    return dmi_weights_read(weights, "limits.mean", in, 0, out_net->mean) &&
           dmi_weights_read(weights, "limits.scale", in, 0, out_net->scale) &&
           dmi_weights_read(weights, "limits.0.weight", hidden, in, out_net->first) &&
           dmi_weights_read(weights, "limits.0.bias", hidden, 0, out_net->first_bias) &&
           dmi_weights_read(weights, "limits.2.weight", hidden, hidden, out_net->second) &&
           dmi_weights_read(weights, "limits.2.bias", hidden, 0, out_net->second_bias) &&
           dmi_weights_read(weights, "limits.4.weight", 3, hidden, out_net->last) &&
           dmi_weights_read(weights, "limits.4.bias", 3, 0, out_net->last_bias);
}

static void dense(const float* weight, const float* bias, const float* in, int inputs, int outputs, int rectify,
                  float* out) {
    for (int o = 0; o < outputs; o++) {
        float sum = bias[o];
        for (int i = 0; i < inputs; i++) sum += weight[o * inputs + i] * in[i];
        out[o] = rectify && sum < 0 ? 0 : sum;
    }
}

static float size_of(float logarithm) {
    return fminf(fmaxf(expf(fminf(logarithm, 3)) - LEAST, 0), MOST);
}

void dmi_limit_net_forward(const dmi_limit_net* net, const float features[DMI_LIMIT_FEATURES], float* out_lower,
                           float* out_upper, float* out_free) {
    float x[DMI_LIMIT_FEATURES], a[DMI_LIMIT_HIDDEN], b[DMI_LIMIT_HIDDEN], out[3];
    for (int i = 0; i < DMI_LIMIT_FEATURES; i++) x[i] = (features[i] - net->mean[i]) * net->scale[i];
    dense(net->first, net->first_bias, x, DMI_LIMIT_FEATURES, DMI_LIMIT_HIDDEN, 1, a);
    dense(net->second, net->second_bias, a, DMI_LIMIT_HIDDEN, DMI_LIMIT_HIDDEN, 1, b);
    dense(net->last, net->last_bias, b, DMI_LIMIT_HIDDEN, 3, 0, out);
    const float down = size_of(out[0]), up = size_of(out[1]);
    *out_lower = down > AT_AN_END * up ? -down : 0;
    *out_upper = up > AT_AN_END * down ? up : 0;
    if (*out_upper - *out_lower < LEAST) *out_upper = *out_lower + LEAST;
    *out_free = out[2];
}
