/* The numeric kernels of each instruction set, and which sets this machine runs. */
#ifndef DMI_NN_KERNELS_H
#define DMI_NN_KERNELS_H

#include <stdbool.h>

#include "base/cpu.h"
#include "nn/gemm.h"

/* Matrices are dense, row after row, `columns` numbers each, unless a stride is named. Any sizes, any alignment. */
typedef struct dmi_kernels {
    dmi_gemm_kernel* gemm;
    /* y = (x - mean) / sqrt(variance + 1e-5) * weight + bias, row by row. */
    void (*layer_norm)(const float* x, uint32_t rows, uint32_t columns, const float* weight, const float* bias,
                       float* y);
    /* Softmax of every row, in place. */
    void (*softmax)(float* x, uint32_t rows, uint32_t columns);
    /* y[i] *= sigmoid(x[i]). */
    void (*gate)(const float* x, uint32_t count, float* y);
    /* x = x scale + shift, column by column (FiLM). */
    void (*modulate)(float* x, uint32_t rows, uint32_t columns, const float* scale, const float* shift);
    /* Maximum and mean of every column. */
    void (*max_rows)(const float* x, uint32_t rows, uint32_t columns, float* out);
    void (*mean_rows)(const float* x, uint32_t rows, uint32_t columns, float* out);
} dmi_kernels;

extern const dmi_kernels dmi_kernels_scalar;
#if defined(__x86_64__)
extern const dmi_kernels dmi_kernels_avx2, dmi_kernels_avx512;
#elif defined(__aarch64__)
extern const dmi_kernels dmi_kernels_neon;
#endif

/* Returns the kernels of a set; the scalar ones for a set that this build has none for. */
const dmi_kernels* dmi_kernels_for(dmi_isa isa);
/* Whether this build has kernels of its own for the set and this processor runs them. */
bool dmi_kernels_usable(dmi_isa isa);

#endif
