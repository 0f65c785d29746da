/* Pre-norm transformer layer: x += attention(norm1(x)); x += ff2(ReLU(ff1(norm2(x)))) (docs/networks.md). */
#ifndef DMI_NN_TRANSFORMER_H
#define DMI_NN_TRANSFORMER_H

#include "nn/layers.h"

typedef struct dmi_transformer {
    dmi_norm norm1, norm2;
    dmi_linear qkv, out, ff1, ff2; /* rows of q already divided by sqrt(width of a head) */
    uint32_t width, heads;
} dmi_transformer;

void dmi_load_transformer(dmi_loader* loader, const char* name, uint32_t width, uint32_t heads, uint32_t hidden,
                          dmi_transformer* out_layer);

/* Returns the floats of scratch that layers of at most these sizes need. */
size_t dmi_transformer_scratch(uint32_t tokens, uint32_t width, uint32_t heads, uint32_t hidden);

/* x: tokens x width, in place. scratch: 64-byte aligned. */
void dmi_transformer_apply(const dmi_transformer* layer, const dmi_kernels* kernels, uint32_t tokens, float* x,
                           float* scratch);

#endif
