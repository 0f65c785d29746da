/* Transformer layer. Attention uses the matrix product of the linear layers, head by head, on keys and values that are
 * packed like weights. */
#include "nn/layers.h"

#include <math.h>
#include <stdio.h>

#define MAX_NAME 96     /* bytes of a tensor name */
#define ALIGN_FLOATS 16 /* 64 bytes */

static size_t aligned(size_t floats) {
    return (floats + ALIGN_FLOATS - 1) / ALIGN_FLOATS * ALIGN_FLOATS;
}

/* Loads q, k and v; the division of softmax(q k / sqrt(d)) is folded into q. */
static void load_qkv(dmi_loader* loader, const char* name, uint32_t width, uint32_t heads, dmi_linear* out_qkv) {
    float* weight = dmi_load_part(loader, name, ".weight", 3 * width, width);
    float* bias = dmi_load_part(loader, name, ".bias", 3 * width, 0);
    if (loader->result != DM_OK) return;
    const uint32_t head = width / heads;
    const float scale = 1.0f / sqrtf((float)head);
    for (size_t i = 0; i < (size_t)width * width; i++) weight[i] *= scale;
    for (uint32_t i = 0; i < width; i++) bias[i] *= scale;
    dmi_pack_linear(loader, weight, width, bias, width, 3 * width, out_qkv);
}

void dmi_load_transformer(dmi_loader* loader, const char* name, uint32_t width, uint32_t heads, uint32_t hidden,
                          dmi_transformer* out_layer) {
    char part[MAX_NAME];
    *out_layer = (dmi_transformer){.width = width, .heads = heads};
    snprintf(part, sizeof part, "%s.norm1", name);
    dmi_load_norm(loader, part, width, &out_layer->norm1);
    snprintf(part, sizeof part, "%s.attn.qkv", name);
    load_qkv(loader, part, width, heads, &out_layer->qkv);
    snprintf(part, sizeof part, "%s.attn.out", name);
    dmi_load_linear(loader, part, width, width, &out_layer->out);
    snprintf(part, sizeof part, "%s.norm2", name);
    dmi_load_norm(loader, part, width, &out_layer->norm2);
    snprintf(part, sizeof part, "%s.ff1", name);
    dmi_load_linear(loader, part, width, hidden, &out_layer->ff1);
    snprintf(part, sizeof part, "%s.ff2", name);
    dmi_load_linear(loader, part, hidden, width, &out_layer->ff2);
}

/* Layout of the scratch. */
typedef struct layout {
    size_t normal, wide, mixed, keys, values, scores, size; /* floats from its start */
} layout;

static layout lay_out(uint32_t tokens, uint32_t width, uint32_t heads, uint32_t hidden) {
    const uint32_t head = width / heads, widest = hidden > 3 * width ? hidden : 3 * width;
    layout at = {0};
    at.wide = at.normal + aligned((size_t)tokens * width);
    at.mixed = at.wide + aligned((size_t)tokens * widest);
    at.keys = at.mixed + aligned((size_t)tokens * width);
    at.values = at.keys + aligned(dmi_panels_size(tokens, head));
    at.scores = at.values + aligned(dmi_panels_size(head, tokens));
    at.size = at.scores + aligned((size_t)tokens * tokens);
    return at;
}

size_t dmi_transformer_scratch(uint32_t tokens, uint32_t width, uint32_t heads, uint32_t hidden) {
    return lay_out(tokens, width, heads, hidden).size;
}

/* Computes one head: mixed = softmax(q k) v. q, k, v are slices of rows `stride` floats apart; so is `mixed`, `width`
 * apart. */
static void attend(const dmi_kernels* kernels, uint32_t tokens, uint32_t head, uint32_t width, const float* q,
                   float* scratch, const layout* at, float* mixed) {
    const size_t stride = 3 * (size_t)width;
    float *keys = scratch + at->keys, *values = scratch + at->values, *scores = scratch + at->scores;
    dmi_panels_pack(q + width, stride, 1, tokens, head, keys);
    dmi_panels_pack(q + 2 * (size_t)width, 1, stride, head, tokens, values);
    kernels->gemm(&(dmi_gemm){.x = q,
                              .panels = keys,
                              .y = scores,
                              .x_stride = stride,
                              .y_stride = tokens,
                              .rows = tokens,
                              .depth = head,
                              .columns = tokens});
    kernels->softmax(scores, tokens, tokens);
    kernels->gemm(&(dmi_gemm){.x = scores,
                              .panels = values,
                              .y = mixed,
                              .x_stride = tokens,
                              .y_stride = width,
                              .rows = tokens,
                              .depth = tokens,
                              .columns = head});
}

void dmi_transformer_apply(const dmi_transformer* layer, const dmi_kernels* kernels, uint32_t tokens, float* x,
                           float* scratch) {
    const uint32_t width = layer->width, head = width / layer->heads;
    const layout at = lay_out(tokens, width, layer->heads, layer->ff1.outputs);
    float *normal = scratch + at.normal, *wide = scratch + at.wide, *mixed = scratch + at.mixed;
    dmi_norm_apply(&layer->norm1, kernels, x, tokens, normal);
    dmi_linear_apply(&layer->qkv, kernels, normal, tokens, 0, wide);
    for (size_t h = 0; h < layer->heads; h++)
        attend(kernels, tokens, head, width, wide + h * head, scratch, &at, mixed + h * head);
    dmi_linear_apply(&layer->out, kernels, mixed, tokens, DMI_GEMM_ADD, x);
    dmi_norm_apply(&layer->norm2, kernels, x, tokens, normal);
    dmi_linear_apply(&layer->ff1, kernels, normal, tokens, DMI_GEMM_RELU, wide);
    dmi_linear_apply(&layer->ff2, kernels, wide, tokens, DMI_GEMM_ADD, x);
}
