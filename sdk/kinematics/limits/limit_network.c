/* Predicts how probable each range is, and answers with the range that overlaps the likely ones most: a door that goes
 * a quarter turn or a half overlaps neither well with the mean of both. */
#include "kinematics/limits/limit_network.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"

#define LEAST_RANGE 0.01f /* least distance between the limits, in the features' unit; by hand */
/* Ranges less probable than this do not count; by hand (if all were alike, each would have more). */
#define UNLIKELY 1e-3f
/* Factor of ranges that begin at rest, where a drag shows to which side the joint opens. Animated props open from where
 * they rest more often than generated objects do. It was chosen among 1, 1.5, 2 and 4 on game props, with the
 * development set as a check (docs/research/trials_joints.md). */
#define RESTS_AT_END 2.0f
#define LOWEST_LOGIT (-30.0f)
#define LEAST_UNION 1e-4f /* avoids a division by 0 */

#define BATCH 4 /* joints at a time, which share the weights in the caches; what they need fits a small stack */

enum { MAX_NAME = 32, HIDDEN = 160, OUTPUTS = 1 + DMI_LIMIT_KINDS * (1 + 2 * DMI_LIMIT_SIZES) };

static bool sizes_rise(const float sizes[DMI_LIMIT_SIZES]) {
    bool rise = sizes[0] == 0;
    for (int i = 1; i < DMI_LIMIT_SIZES; i++) rise &= sizes[i] > sizes[i - 1];
    return rise;
}

static void read_vector(dmi_loader* loader, const char* name, uint32_t count, float* out) {
    const float* tensor = dmi_load_tensor(loader, name, count, 0);
    if (tensor != NULL) memcpy(out, tensor, count * sizeof *out);
}

void dmi_limit_network_read(dmi_loader* loader, dmi_limit_network* out_network) {
    static const uint32_t sizes[] = {DMI_LIMIT_INPUTS, HIDDEN, HIDDEN, OUTPUTS};
    read_vector(loader, "limits.mean", DMI_LIMIT_INPUTS, out_network->mean);
    read_vector(loader, "limits.scale", DMI_LIMIT_INPUTS, out_network->scale);
    read_vector(loader, "limits.sizes", DMI_LIMIT_SIZES, out_network->sizes);
    for (int i = 0; i < DMI_LIMIT_MEMBERS; i++) {
        char name[MAX_NAME];
        snprintf(name, sizeof name, "limits.%d", i);
        dmi_load_perceptron(loader, name, sizes, 3, &out_network->members[i]);
    }
    if (loader->result == DM_OK && !sizes_rise(out_network->sizes))
        loader->result = dmi_fail(loader->env, DM_ERROR_WRONG_MODEL, "limits.sizes does not rise from 0");
}

/* Computes the softmax. The least logit is held so that no probability is denormal. */
static void softmax(const float* logits, int count, float* out) {
    float most = -INFINITY, sum = 0;
    for (int i = 0; i < count; i++) most = dmi_fmaxf(most, logits[i]);
    for (int i = 0; i < count; i++) sum += out[i] = dmi_expf(dmi_fmaxf(logits[i] - most, LOWEST_LOGIT));
    for (int i = 0; i < count; i++) out[i] /= sum;
}

enum { MOST_RANGES = DMI_LIMIT_SIZES * DMI_LIMIT_SIZES };

typedef struct ranges {
    int count;
    float down[MOST_RANGES], up[MOST_RANGES], probability[MOST_RANGES];
} ranges;

/* Adds the probability that a member gives each range: a mixture whose components have a distribution of either side.
 */
static void add_member(const float outputs[OUTPUTS - 1], float probability[DMI_LIMIT_SIZES][DMI_LIMIT_SIZES]) {
    enum { N = DMI_LIMIT_SIZES, KINDS = DMI_LIMIT_KINDS };
    float kind[KINDS], down[KINDS][N], up[KINDS][N];
    softmax(outputs, KINDS, kind);
    for (int k = 0; k < KINDS; k++) {
        softmax(outputs + KINDS + (size_t)k * N, N, down[k]);
        softmax(outputs + KINDS + (size_t)(KINDS + k) * N, N, up[k]);
    }
    for (int k = 0; k < KINDS; k++)
        for (int d = 0; d < N; d++) {
            const float both = kind[k] * down[k][d] / DMI_LIMIT_MEMBERS;
            for (int u = 0; u < N; u++) probability[d][u] += both * up[k][u];
        }
}

/* Lists the ranges that count. at_rest: factor of those that begin at rest. */
static void likely_ranges(const dmi_limit_network* network, const float probability[DMI_LIMIT_SIZES][DMI_LIMIT_SIZES],
                          float at_rest, ranges* out) {
    out->count = 0;
    for (int d = 0; d < DMI_LIMIT_SIZES; d++)
        for (int u = 0; u < DMI_LIMIT_SIZES; u++) {
            if (probability[d][u] <= UNLIKELY) continue;
            out->down[out->count] = network->sizes[d];
            out->up[out->count] = network->sizes[u];
            out->probability[out->count++] = probability[d][u] * (d == 0 ? at_rest : 1);
        }
}

/* Adds the overlap (intersection over union) of range k with each range, times the probability of k. Both ranges hold
 * the rest configuration. The inner loop is over all ranges, so that it vectorises. */
static void add_overlaps(const ranges* all, int k, float* restrict expected) {
    const float down = all->down[k], up = all->up[k], probability = all->probability[k];
    for (int i = 0; i < all->count; i++) {
        const float d = all->down[i], u = all->up[i];
        const float both = (d < down ? d : down) + (u < up ? u : up);
        expected[i] += probability * (both / ((d < down ? down : d) + (u < up ? up : u) + LEAST_UNION));
    }
}

/* Returns the range whose expected overlap with the true one is largest. */
static int best_range(const ranges* all) {
    float expected[MOST_RANGES] = {0};
    int best = 0;
    for (int k = 0; k < all->count; k++) add_overlaps(all, k, expected);
    for (int i = 1; i < all->count; i++)
        if (expected[i] > expected[best]) best = i;
    return best;
}

/* Standardises the inputs. An unknown input counts as its mean. */
static void standardise_inputs(const dmi_limit_network* network, const dmi_limit_query* query,
                               float out[DMI_LIMIT_INPUTS]) {
    const float *mean = network->mean + DMI_LIMIT_FEATURES, *scale = network->scale + DMI_LIMIT_FEATURES;
    for (int i = 0; i < DMI_LIMIT_FEATURES; i++) out[i] = (query->features[i] - network->mean[i]) * network->scale[i];
    for (int i = 0; i < DMI_FEATURE_COUNT; i++)
        out[DMI_LIMIT_FEATURES + i] = query->candidate != NULL ? (query->candidate[i] - mean[i]) * scale[i] : 0;
}

static void choose_range(const dmi_limit_network* network, const float probability[DMI_LIMIT_SIZES][DMI_LIMIT_SIZES],
                         bool dragged, dmi_limit_prediction* out) {
    ranges likely;
    likely_ranges(network, probability, dragged ? RESTS_AT_END : 1, &likely);
    const int best = best_range(&likely);
    out->lower = -likely.down[best];
    out->upper = likely.up[best];
    if (out->upper - out->lower < LEAST_RANGE) out->upper = out->lower + LEAST_RANGE;
}

/* Predicts limits of up to BATCH joints. */
static void predict_batch(const dmi_limit_network* network, dmi_isa isa, const dmi_limit_query* queries, uint32_t count,
                          dmi_limit_prediction* out) {
    _Alignas(DMI_ALIGNMENT) float x[BATCH][DMI_LIMIT_INPUTS], y[BATCH][OUTPUTS], hidden[2][BATCH][HIDDEN];
    float* const buffers[2] = {hidden[0][0], hidden[1][0]};
    float probability[BATCH][DMI_LIMIT_SIZES][DMI_LIMIT_SIZES] = {0};
    for (uint32_t r = 0; r < count; r++) {
        standardise_inputs(network, &queries[r], x[r]);
        out[r].free = 0;
    }
    for (int i = 0; i < DMI_LIMIT_MEMBERS; i++) {
        dmi_perceptron_apply(&network->members[i], dmi_kernels_for(isa), x[0], count, buffers, y[0]);
        for (uint32_t r = 0; r < count; r++) {
            out[r].free += y[r][0] / DMI_LIMIT_MEMBERS;
            add_member(y[r] + 1, probability[r]);
        }
    }
    for (uint32_t r = 0; r < count; r++)
        choose_range(network, (const float(*)[DMI_LIMIT_SIZES])probability[r], queries[r].dragged, &out[r]);
}

void dmi_limit_network_predict(const dmi_limit_network* network, dmi_isa isa, const dmi_limit_query* queries,
                               uint32_t count, dmi_limit_prediction* out) {
    for (uint32_t first = 0; first < count; first += BATCH)
        predict_batch(network, isa, queries + first, count - first < BATCH ? count - first : BATCH, out + first);
}
