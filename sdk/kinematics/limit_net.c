/* Forward pass of the limits' network: how probable each range is, and the range that overlaps the likely ones most. A
 * door that goes a quarter turn or a half overlaps neither well with the mean of both. */
#include "kinematics/limit_net.h"

#include <math.h>
#include <string.h>

#define LEAST 0.01f    /* between the limits */
#define UNLIKELY 1e-3f /* ranges less probable than this don't count; all alike have more */
#define LOW_LOGIT (-30.0f)

static int sizes_rise(const float sizes[DMI_LIMIT_SIZES]) {
    int rise = sizes[0] == 0;
    for (int i = 1; i < DMI_LIMIT_SIZES; i++) rise &= sizes[i] > sizes[i - 1];
    return rise;
}

int dmi_limit_net_read(const dmi_weights* weights, dmi_limit_net* out_net) {
    const uint32_t in = DMI_LIMIT_FEATURES, hidden = DMI_LIMIT_HIDDEN;
    return dmi_weights_read(weights, "limits.mean", in, 0, out_net->mean) &&
           dmi_weights_read(weights, "limits.scale", in, 0, out_net->scale) &&
           dmi_weights_read(weights, "limits.sizes", DMI_LIMIT_SIZES, 0, out_net->sizes) &&
           dmi_weights_read(weights, "limits.first", in, hidden, out_net->first) &&
           dmi_weights_read(weights, "limits.first_bias", hidden, 0, out_net->first_bias) &&
           dmi_weights_read(weights, "limits.second", hidden, hidden, out_net->second) &&
           dmi_weights_read(weights, "limits.second_bias", hidden, 0, out_net->second_bias) &&
           dmi_weights_read(weights, "limits.last", hidden, DMI_LIMIT_OUTPUTS, out_net->last) &&
           dmi_weights_read(weights, "limits.last_bias", DMI_LIMIT_OUTPUTS, 0, out_net->last_bias) &&
           sizes_rise(out_net->sizes);
}

static void dense(const float* weight, const float* bias, const float* in, int inputs, int outputs,
                  float* restrict out) {
    memcpy(out, bias, (size_t)outputs * sizeof *out);
    for (int i = 0; i < inputs; i++)
        for (int o = 0; o < outputs; o++) out[o] += in[i] * weight[i * outputs + o];
}

static void rectify(float* x, int count) {
    for (int i = 0; i < count; i++) x[i] = x[i] > 0 ? x[i] : 0;
}

/* Logits to probabilities; the least logit is held so that no share is denormal. */
static void share(const float* logits, int count, float* out) {
    float most = -INFINITY, sum = 0;
    for (int i = 0; i < count; i++) most = fmaxf(most, logits[i]);
    for (int i = 0; i < count; i++) sum += out[i] = expf(fmaxf(logits[i] - most, LOW_LOGIT));
    for (int i = 0; i < count; i++) out[i] /= sum;
}

enum { MOST_RANGES = DMI_LIMIT_SIZES * DMI_LIMIT_SIZES };

typedef struct ranges {
    int count;
    float down[MOST_RANGES], up[MOST_RANGES], probability[MOST_RANGES];
} ranges;

/* The ranges that count: of every kind of range each side has its own shares. */
static void likely_ranges(const dmi_limit_net* net, const float outputs[DMI_LIMIT_OUTPUTS - 1], ranges* out) {
    enum { N = DMI_LIMIT_SIZES, KINDS = DMI_LIMIT_KINDS };
    float kind[KINDS], down[KINDS][N], up[KINDS][N];
    share(outputs, KINDS, kind);
    for (int k = 0; k < KINDS; k++) {
        share(outputs + KINDS + k * N, N, down[k]);
        share(outputs + KINDS + (KINDS + k) * N, N, up[k]);
    }
    out->count = 0;
    for (int d = 0; d < N; d++)
        for (int u = 0; u < N; u++) {
            float p = 0;
            for (int k = 0; k < KINDS; k++) p += kind[k] * down[k][d] * up[k][u];
            if (p <= UNLIKELY) continue;
            out->down[out->count] = net->sizes[d];
            out->up[out->count] = net->sizes[u];
            out->probability[out->count++] = p;
        }
}

/* Of two ranges that hold the rest, their overlap is what they share over what they cover; adds that of range k with
 * each, as probable as it is. All ranges side by side in the inner loop: four or eight overlaps at a time. */
static void add_overlaps(const ranges* all, int k, float* restrict expected) {
    const float down = all->down[k], up = all->up[k], probability = all->probability[k];
    for (int i = 0; i < all->count; i++) {
        const float d = all->down[i], u = all->up[i];
        const float both = (d < down ? d : down) + (u < up ? u : up);
        expected[i] += probability * (both / ((d < down ? down : d) + (u < up ? up : u) + 1e-4f));
    }
}

/* The range whose expected overlap with the true one is largest. */
static int best_range(const ranges* all) {
    float expected[MOST_RANGES] = {0};
    int best = 0;
    for (int k = 0; k < all->count; k++) add_overlaps(all, k, expected);
    for (int i = 1; i < all->count; i++)
        if (expected[i] > expected[best]) best = i;
    return best;
}

void dmi_limit_net_forward(const dmi_limit_net* net, const float features[DMI_LIMIT_FEATURES], float* out_lower,
                           float* out_upper, float* out_free) {
    float x[DMI_LIMIT_FEATURES], a[DMI_LIMIT_HIDDEN], b[DMI_LIMIT_HIDDEN], out[DMI_LIMIT_OUTPUTS];
    ranges likely;
    for (int i = 0; i < DMI_LIMIT_FEATURES; i++) x[i] = (features[i] - net->mean[i]) * net->scale[i];
    dense(net->first, net->first_bias, x, DMI_LIMIT_FEATURES, DMI_LIMIT_HIDDEN, a);
    rectify(a, DMI_LIMIT_HIDDEN);
    dense(net->second, net->second_bias, a, DMI_LIMIT_HIDDEN, DMI_LIMIT_HIDDEN, b);
    rectify(b, DMI_LIMIT_HIDDEN);
    dense(net->last, net->last_bias, b, DMI_LIMIT_HIDDEN, DMI_LIMIT_OUTPUTS, out);
    likely_ranges(net, out + 1, &likely);
    const int best = best_range(&likely);
    *out_lower = -likely.down[best];
    *out_upper = likely.up[best];
    if (*out_upper - *out_lower < LEAST) *out_upper = *out_lower + LEAST;
    *out_free = out[0];
}
