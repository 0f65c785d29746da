/* Small multi-layer perceptrons for rows of measured numbers: y = W_n relu(… relu(W_1 x + b_1) …) + b_n. */
#ifndef DMI_NN_PERCEPTRON_H
#define DMI_NN_PERCEPTRON_H

#include "nn/layers.h"

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

#endif
