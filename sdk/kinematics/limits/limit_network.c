/* Forward pass of the limits' networks: how probable each range is, and the range that overlaps the likely ones most. A
 * door that goes a quarter turn or a half overlaps neither well with the mean of both. */
#include "kinematics/limits/limit_network.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define LEAST 0.01f    /* between the limits */
#define UNLIKELY 1e-3f /* ranges less probable than this don't count; all alike have more */
#define LOW_LOGIT (-30.0f)

static int sizes_rise(const float sizes[DMI_LIMIT_SIZES]) {
    int rise = sizes[0] == 0;
    for (int i = 1; i < DMI_LIMIT_SIZES; i++) rise &= sizes[i] > sizes[i - 1];
    return rise;
}

static int read_voice(const dmi_weights* weights, int index, dmi_limit_member* out) {
    const uint32_t in = DMI_LIMIT_INPUTS, hidden = DMI_LIMIT_HIDDEN, outputs = DMI_LIMIT_OUTPUTS;
    const struct {
        const char* name;
        uint32_t rows, columns;
        float* to;
    } tensors[] = {{"first", in, hidden, out->first},       {"first_bias", hidden, 0, out->first_bias},
                   {"second", hidden, hidden, out->second}, {"second_bias", hidden, 0, out->second_bias},
                   {"last", hidden, outputs, out->last},    {"last_bias", outputs, 0, out->last_bias}};
    for (size_t i = 0; i < sizeof tensors / sizeof *tensors; i++) {
        char name[32];
        snprintf(name, sizeof name, "limits.%d.%s", index, tensors[i].name);
        if (!dmi_weights_read(weights, name, tensors[i].rows, tensors[i].columns, tensors[i].to)) return 0;
    }
    return 1;
}

int dmi_limit_network_read(const dmi_weights* weights, dmi_limit_network* out_net) {
    int whole = dmi_weights_read(weights, "limits.mean", DMI_LIMIT_INPUTS, 0, out_net->mean) &&
                dmi_weights_read(weights, "limits.scale", DMI_LIMIT_INPUTS, 0, out_net->scale) &&
                dmi_weights_read(weights, "limits.sizes", DMI_LIMIT_SIZES, 0, out_net->sizes) &&
                sizes_rise(out_net->sizes);
    for (int i = 0; i < DMI_LIMIT_MEMBERS; i++) whole = whole && read_voice(weights, i, &out_net->voices[i]);
    return whole;
}

/* rows x outputs, from rows x inputs. What is zero adds nothing. */
static void dense(const float* weight, const float* bias, const float* in, uint32_t rows, int inputs, int outputs,
                  float* restrict out) {
    for (uint32_t r = 0; r < rows; r++) memcpy(out + r * (uint32_t)outputs, bias, (size_t)outputs * sizeof *out);
    for (int i = 0; i < inputs; i++)
        for (uint32_t r = 0; r < rows; r++) {
            const float x = in[r * (uint32_t)inputs + (uint32_t)i];
            float* to = out + r * (uint32_t)outputs;
            if (x == 0) continue;
            for (int o = 0; o < outputs; o++) to[o] += x * weight[i * outputs + o];
        }
}

static void rectify(float* x, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) x[i] = x[i] > 0 ? x[i] : 0;
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

/* Of each range how probable a voice thinks it: of every kind of range each side has its own shares. */
static void add_opinion(const float outputs[DMI_LIMIT_OUTPUTS - 1],
                        float probability[DMI_LIMIT_SIZES][DMI_LIMIT_SIZES]) {
    enum { N = DMI_LIMIT_SIZES, KINDS = DMI_LIMIT_KINDS };
    float kind[KINDS], down[KINDS][N], up[KINDS][N];
    share(outputs, KINDS, kind);
    for (int k = 0; k < KINDS; k++) {
        share(outputs + KINDS + k * N, N, down[k]);
        share(outputs + KINDS + (KINDS + k) * N, N, up[k]);
    }
    for (int k = 0; k < KINDS; k++)
        for (int d = 0; d < N; d++) {
            const float both = kind[k] * down[k][d] / DMI_LIMIT_MEMBERS;
            for (int u = 0; u < N; u++) probability[d][u] += both * up[k][u];
        }
}

/* Those that count. */
static void likely_ranges(const dmi_limit_network* net, const float probability[DMI_LIMIT_SIZES][DMI_LIMIT_SIZES],
                          ranges* out) {
    out->count = 0;
    for (int d = 0; d < DMI_LIMIT_SIZES; d++)
        for (int u = 0; u < DMI_LIMIT_SIZES; u++) {
            if (probability[d][u] <= UNLIKELY) continue;
            out->down[out->count] = net->sizes[d];
            out->up[out->count] = net->sizes[u];
            out->probability[out->count++] = probability[d][u];
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

/* What is unknown counts as its mean. */
static void standardise(const dmi_limit_network* net, const dmi_limit_query* question, float out[DMI_LIMIT_INPUTS]) {
    const float *mean = net->mean + DMI_LIMIT_FEATURES, *scale = net->scale + DMI_LIMIT_FEATURES;
    for (int i = 0; i < DMI_LIMIT_FEATURES; i++) out[i] = (question->features[i] - net->mean[i]) * net->scale[i];
    for (int i = 0; i < DMI_FEATURE_COUNT; i++)
        out[DMI_LIMIT_FEATURES + i] = question->evidence != NULL ? (question->evidence[i] - mean[i]) * scale[i] : 0;
}

static void speak(const dmi_limit_member* voice, const float* x, uint32_t rows, float* out) {
    float a[DMI_LIMIT_ROWS * DMI_LIMIT_HIDDEN], b[DMI_LIMIT_ROWS * DMI_LIMIT_HIDDEN];
    dense(voice->first, voice->first_bias, x, rows, DMI_LIMIT_INPUTS, DMI_LIMIT_HIDDEN, a);
    rectify(a, rows * DMI_LIMIT_HIDDEN);
    dense(voice->second, voice->second_bias, a, rows, DMI_LIMIT_HIDDEN, DMI_LIMIT_HIDDEN, b);
    rectify(b, rows * DMI_LIMIT_HIDDEN);
    dense(voice->last, voice->last_bias, b, rows, DMI_LIMIT_HIDDEN, DMI_LIMIT_OUTPUTS, out);
}

static void answer(const dmi_limit_network* net, const float probability[DMI_LIMIT_SIZES][DMI_LIMIT_SIZES],
                   dmi_limit_prediction* out) {
    ranges likely;
    likely_ranges(net, probability, &likely);
    const int best = best_range(&likely);
    out->lower = -likely.down[best];
    out->upper = likely.up[best];
    if (out->upper - out->lower < LEAST) out->upper = out->lower + LEAST;
}

void dmi_limit_network_predict(const dmi_limit_network* net, const dmi_limit_query* questions, uint32_t count,
                               dmi_limit_prediction* out) {
    float x[DMI_LIMIT_ROWS][DMI_LIMIT_INPUTS], said[DMI_LIMIT_ROWS][DMI_LIMIT_OUTPUTS];
    float probability[DMI_LIMIT_ROWS][DMI_LIMIT_SIZES][DMI_LIMIT_SIZES] = {0};
    for (uint32_t r = 0; r < count; r++) {
        standardise(net, &questions[r], x[r]);
        out[r].free = 0;
    }
    for (int i = 0; i < DMI_LIMIT_MEMBERS; i++) {
        speak(&net->voices[i], x[0], count, said[0]);
        for (uint32_t r = 0; r < count; r++) {
            out[r].free += said[r][0] / DMI_LIMIT_MEMBERS;
            add_opinion(said[r] + 1, probability[r]);
        }
    }
    for (uint32_t r = 0; r < count; r++) answer(net, (const float(*)[DMI_LIMIT_SIZES])probability[r], &out[r]);
}
