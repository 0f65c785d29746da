/* Loads, packs and applies linear layers, perceptrons and normalisation. */
#include "nn/layers.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MAX_NAME 96                     /* bytes of a tensor name, docs/networks.md has shorter ones */
#define FORMAT_VERSION 1                /* version of the weight files, docs/networks.md */
#define BLOCK_SIZE ((size_t)256 * 1024) /* bytes of an arena block; by hand */

dm_result dmi_load_network(dmi_env* env, const void* data, size_t size, const char* architecture,
                           dmi_read_network* read, void* network, dmi_arena* keep) {
    dmi_weights* weights = NULL;
    const dm_result opened = dmi_weights_open(env, data, size, architecture, FORMAT_VERSION, &weights);
    if (opened != DM_OK) return opened;
    dmi_arena spare;
    dmi_arena_init(&spare, env, BLOCK_SIZE);
    dmi_loader loader = {env, weights, keep, &spare, DM_OK};
    read(&loader, network);
    dmi_arena_release(&spare);
    dmi_weights_close(weights);
    if (loader.result != DM_OK) dmi_arena_release(keep);
    return loader.result;
}

static void* fail(dmi_loader* loader, dm_result result) {
    if (loader->result == DM_OK) loader->result = result;
    return NULL;
}

static float* push(dmi_loader* loader, dmi_arena* arena, size_t count) {
    if (loader->result != DM_OK) return NULL;
    float* memory = dmi_arena_push(arena, count * sizeof(float));
    if (memory == NULL) {
        dmi_fail(loader->env, DM_ERROR_OUT_OF_MEMORY, "weights: no memory for %zu numbers", count);
        return fail(loader, DM_ERROR_OUT_OF_MEMORY);
    }
    return memory;
}

static float* push_zeros(dmi_loader* loader, dmi_arena* arena, size_t count) {
    float* memory = push(loader, arena, count);
    if (memory != NULL) memset(memory, 0, count * sizeof(float));
    return memory;
}

float* dmi_load_alloc(dmi_loader* loader, size_t count) {
    return push_zeros(loader, loader->keep, count);
}

float* dmi_load_spare(dmi_loader* loader, size_t count) {
    return push_zeros(loader, loader->spare, count);
}

float* dmi_load_tensor(dmi_loader* loader, const char* name, uint32_t rows, uint32_t cols) {
    const size_t count = (size_t)rows * (cols ? cols : 1);
    if (loader->result != DM_OK) return NULL;
    float* tensor = push(loader, loader->spare, count);
    if (tensor == NULL) return NULL;
    bool finite = false;
    if (!dmi_weights_read(loader->weights, name, rows, cols, tensor, &finite)) return fail(loader, DM_ERROR_BAD_DATA);
    if (finite) return tensor;
    size_t bad = 0;
    while (isfinite(tensor[bad])) bad++;
    dmi_fail(loader->env, DM_ERROR_BAD_DATA, "weights: number %zu of '%s' is not finite", bad, name);
    return fail(loader, DM_ERROR_BAD_DATA);
}

float* dmi_load_part(dmi_loader* loader, const char* prefix, const char* suffix, uint32_t rows, uint32_t cols) {
    char name[2 * MAX_NAME];
    snprintf(name, sizeof name, "%s%s", prefix, suffix);
    return dmi_load_tensor(loader, name, rows, cols);
}

void dmi_pack_linear(dmi_loader* loader, const float* weight, size_t stride, const float* bias, uint32_t inputs,
                     uint32_t outputs, dmi_linear* out_linear) {
    float* panels = push(loader, loader->keep, dmi_panels_size(outputs, inputs)); /* packing fills all of it */
    float* padded = bias != NULL ? dmi_load_alloc(loader, dmi_padded_columns(outputs)) : NULL;
    *out_linear = (dmi_linear){panels, padded, inputs, outputs};
    if (loader->result != DM_OK) return;
    dmi_panels_pack(weight, stride, 1, outputs, inputs, panels);
    if (bias != NULL) memcpy(padded, bias, outputs * sizeof(float));
}

void dmi_load_linear(dmi_loader* loader, const char* name, uint32_t inputs, uint32_t outputs, dmi_linear* out_linear) {
    const float* weight = dmi_load_part(loader, name, ".weight", outputs, inputs);
    const float* bias = dmi_load_part(loader, name, ".bias", outputs, 0);
    dmi_pack_linear(loader, weight, inputs, bias, inputs, outputs, out_linear);
}

void dmi_load_mlp(dmi_loader* loader, const char* name, uint32_t inputs, uint32_t hidden, uint32_t outputs,
                  dmi_mlp* out_mlp) {
    char layer[MAX_NAME];
    snprintf(layer, sizeof layer, "%s.0", name);
    dmi_load_linear(loader, layer, inputs, hidden, &out_mlp->first);
    snprintf(layer, sizeof layer, "%s.2", name);
    dmi_load_linear(loader, layer, hidden, outputs, &out_mlp->second);
}

static const float* keep_vector(dmi_loader* loader, const float* vector, uint32_t count) {
    float* kept = dmi_load_alloc(loader, count);
    if (kept != NULL && vector != NULL) memcpy(kept, vector, count * sizeof(float));
    return kept;
}

void dmi_load_norm(dmi_loader* loader, const char* name, uint32_t width, dmi_norm* out_norm) {
    const float* weight = dmi_load_part(loader, name, ".weight", width, 0);
    const float* bias = dmi_load_part(loader, name, ".bias", width, 0);
    *out_norm = (dmi_norm){keep_vector(loader, weight, width), keep_vector(loader, bias, width), width};
}

void dmi_linear_apply(const dmi_linear* linear, const dmi_kernels* kernels, const float* x, uint32_t rows,
                      uint32_t flags, float* y) {
    kernels->gemm(&(dmi_gemm){.x = x,
                              .panels = linear->panels,
                              .bias = linear->bias,
                              .y = y,
                              .x_stride = linear->inputs,
                              .y_stride = linear->outputs,
                              .rows = rows,
                              .depth = linear->inputs,
                              .columns = linear->outputs,
                              .flags = flags});
}

void dmi_mlp_apply(const dmi_mlp* mlp, const dmi_kernels* kernels, const float* x, uint32_t rows, uint32_t flags,
                   float* hidden, float* y) {
    dmi_linear_apply(&mlp->first, kernels, x, rows, DMI_GEMM_RELU, hidden);
    dmi_linear_apply(&mlp->second, kernels, hidden, rows, flags, y);
}

void dmi_norm_apply(const dmi_norm* norm, const dmi_kernels* kernels, const float* x, uint32_t rows, float* y) {
    kernels->layer_norm(x, rows, norm->width, norm->weight, norm->bias, y);
}

/* ---- perceptrons ---- */

static void load_layer(dmi_loader* loader, const char* name, uint32_t index, const uint32_t* sizes,
                       dmi_linear* out_layer) {
    char layer[MAX_NAME];
    snprintf(layer, sizeof layer, "%s.%u", name, 2 * index);
    dmi_load_linear(loader, layer, sizes[index], sizes[index + 1], out_layer);
}

void dmi_load_perceptron(dmi_loader* loader, const char* name, const uint32_t* sizes, uint32_t layer_count,
                         dmi_perceptron* out) {
    out->layer_count = layer_count;
    for (uint32_t i = 0; i < layer_count; i++) load_layer(loader, name, i, sizes, &out->layers[i]);
}

/* W' = W scale, b' = b - W' mean, in double precision: the means may be many scales away from 0. */
static void fold_standardisation(float* weight, float* bias, const float* mean, const float* scale, uint32_t inputs,
                                 uint32_t outputs) {
    for (uint32_t o = 0; o < outputs; o++) {
        double shift = 0;
        for (uint32_t i = 0; i < inputs; i++) {
            float* w = weight + (size_t)o * inputs + i;
            shift += (double)*w * scale[i] * mean[i];
            *w *= scale[i];
        }
        bias[o] = (float)(bias[o] - shift);
    }
}

void dmi_load_standardised_perceptron(dmi_loader* loader, const char* name, const uint32_t* sizes, uint32_t layer_count,
                                      dmi_perceptron* out) {
    const uint32_t inputs = sizes[0], outputs = sizes[1];
    const float* mean = dmi_load_part(loader, name, ".mean", inputs, 0);
    const float* scale = dmi_load_part(loader, name, ".scale", inputs, 0);
    float* weight = dmi_load_part(loader, name, ".0.weight", outputs, inputs);
    float* bias = dmi_load_part(loader, name, ".0.bias", outputs, 0);
    if (loader->result == DM_OK) fold_standardisation(weight, bias, mean, scale, inputs, outputs);
    out->layer_count = layer_count;
    dmi_pack_linear(loader, weight, inputs, bias, inputs, outputs, &out->layers[0]);
    for (uint32_t i = 1; i < layer_count; i++) load_layer(loader, name, i, sizes, &out->layers[i]);
}

void dmi_perceptron_apply(const dmi_perceptron* perceptron, const dmi_kernels* kernels, const float* x, uint32_t rows,
                          float* const hidden[2], float* y) {
    const uint32_t last = perceptron->layer_count - 1;
    for (uint32_t i = 0; i < last; i++) {
        dmi_linear_apply(&perceptron->layers[i], kernels, x, rows, DMI_GEMM_RELU, hidden[i % 2]);
        x = hidden[i % 2];
    }
    dmi_linear_apply(&perceptron->layers[last], kernels, x, rows, 0, y);
}
