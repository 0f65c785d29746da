/* Loads and applies multi-layer perceptrons. */
#include "nn/perceptron.h"

#include <stdio.h>

#define MAX_NAME 64

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
