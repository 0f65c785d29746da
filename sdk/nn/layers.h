/* Layers as docs/networks.md names them, and perceptrons of linear ones: loaded and packed once, then applied to rows
 * of numbers. */
#ifndef DMI_NN_LAYERS_H
#define DMI_NN_LAYERS_H

#include "base/arena.h"
#include "nn/kernels.h"
#include "nn/weights.h"

/* y = W x + b. */
typedef struct dmi_linear {
    const float* panels;
    const float* bias; /* NULL: none */
    uint32_t inputs, outputs;
} dmi_linear;

/* Linear, ReLU, Linear. */
typedef struct dmi_mlp {
    dmi_linear first, second;
} dmi_mlp;

typedef struct dmi_norm {
    const float *weight, *bias;
    uint32_t width;
} dmi_norm;

/* State of loading; the first failure stays in `result`, and everything loaded after it is zero. */
typedef struct dmi_loader {
    dmi_env* env;
    const dmi_weights* weights;
    dmi_arena* keep;  /* lives as long as the network */
    dmi_arena* spare; /* released when loading ends */
    dm_result result;
} dmi_loader;

/* Opens the file, calls `read` to load every layer of `network`, and closes it. On failure `keep` is empty again. */
typedef void dmi_read_network(dmi_loader* loader, void* network);
dm_result dmi_load_network(dmi_env* env, const void* data, size_t size, const char* architecture,
                           dmi_read_network* read, void* network, dmi_arena* keep);

/* Copies a tensor to `spare`, aligned, every number finite; NULL after a failure. cols 0: a vector. */
float* dmi_load_tensor(dmi_loader* loader, const char* name, uint32_t rows, uint32_t cols);
/* The same for the tensor named `prefix` + `suffix`. */
float* dmi_load_part(dmi_loader* loader, const char* prefix, const char* suffix, uint32_t rows, uint32_t cols);
/* Allocates `count` zeros in `keep` or in `spare`, 64-byte aligned; NULL after a failure. */
float* dmi_load_alloc(dmi_loader* loader, size_t count);
float* dmi_load_spare(dmi_loader* loader, size_t count);
void dmi_load_linear(dmi_loader* loader, const char* name, uint32_t inputs, uint32_t outputs, dmi_linear* out_linear);
void dmi_load_mlp(dmi_loader* loader, const char* name, uint32_t inputs, uint32_t hidden, uint32_t outputs,
                  dmi_mlp* out_mlp);
void dmi_load_norm(dmi_loader* loader, const char* name, uint32_t width, dmi_norm* out_norm);
/* Packs a dense W (outputs x inputs, `stride` floats between its rows) and b (NULL: none) made by the caller. */
void dmi_pack_linear(dmi_loader* loader, const float* weight, size_t stride, const float* bias, uint32_t inputs,
                     uint32_t outputs, dmi_linear* out_linear);

/* Computes y = W x + b for `rows` rows, flags DMI_GEMM_*. Rows of x and y are as long as inputs and outputs. */
void dmi_linear_apply(const dmi_linear* linear, const dmi_kernels* kernels, const float* x, uint32_t rows,
                      uint32_t flags, float* y);
/* Applies both layers; hidden: scratch of rows x mlp->first.outputs. */
void dmi_mlp_apply(const dmi_mlp* mlp, const dmi_kernels* kernels, const float* x, uint32_t rows, uint32_t flags,
                   float* hidden, float* y);
void dmi_norm_apply(const dmi_norm* norm, const dmi_kernels* kernels, const float* x, uint32_t rows, float* y);

/* ---- perceptrons for rows of measured numbers: y = W_n relu(… relu(W_1 x + b_1) …) + b_n ---- */

#define DMI_PERCEPTRON_LAYERS 3 /* the most that one has */

typedef struct dmi_perceptron {
    dmi_linear layers[DMI_PERCEPTRON_LAYERS];
    uint32_t layer_count;
} dmi_perceptron;

/* Loads the layers `name`.0, `name`.2, … (.weight and .bias: the even places, as ReLU takes the odd ones). sizes:
 * inputs, hidden widths, outputs: layer_count + 1 numbers. */
void dmi_load_perceptron(dmi_loader* loader, const char* name, const uint32_t* sizes, uint32_t layer_count,
                         dmi_perceptron* out);
/* The same, with inputs standardised: takes (x - mean) * scale of the tensors `name`.mean and `name`.scale into the
 * first layer, so that it is applied to x itself. */
void dmi_load_standardised_perceptron(dmi_loader* loader, const char* name, const uint32_t* sizes, uint32_t layer_count,
                                      dmi_perceptron* out);

/* x: dense rows. hidden: two buffers, each of rows x the widest hidden layer. */
void dmi_perceptron_apply(const dmi_perceptron* perceptron, const dmi_kernels* kernels, const float* x, uint32_t rows,
                          float* const hidden[2], float* y);

/* ---- pre-norm transformer layer (transformer.c): x += attention(norm1(x)); x += ff2(ReLU(ff1(norm2(x)))) ---- */

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
