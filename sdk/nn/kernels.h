/* The numeric kernels of each instruction set, and which sets this machine runs. */
#ifndef DMI_NN_KERNELS_H
#define DMI_NN_KERNELS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/cpu.h"

/* ---- matrix product on packed weights: y = act(x W^T + b); a panel holds 16 outputs: panel p, element [k][j] is
 * W[16 p + j][k], and outputs past the last are zero ---- */

#define DMI_PANEL 16 /* outputs of a panel: one register of AVX-512, two of AVX2, four of NEON */

enum {
    DMI_GEMM_RELU = 1, /* y = max(0, …) */
    DMI_GEMM_ADD = 2   /* y += … */
};

typedef struct dmi_gemm {
    const float* x;      /* rows x depth, x_stride floats between rows */
    const float* panels; /* 64-byte aligned, dmi_panels_size floats */
    const float* bias;   /* NULL, or a number for every column of the panels (the padding's too) */
    float* y;            /* rows x columns, y_stride floats between rows; not overlapping x */
    size_t x_stride, y_stride;
    uint32_t rows, depth, columns;
    uint32_t flags; /* DMI_GEMM_* */
} dmi_gemm;

typedef void dmi_gemm_kernel(const dmi_gemm* gemm);
dmi_gemm_kernel dmi_gemm_scalar;
#if defined(__x86_64__)
dmi_gemm_kernel dmi_gemm_avx2;
dmi_gemm_kernel dmi_gemm_avx512;
#elif defined(__aarch64__)
dmi_gemm_kernel dmi_gemm_neon;
#endif

static inline uint32_t dmi_padded_columns(uint32_t columns) {
    return (columns + DMI_PANEL - 1) / DMI_PANEL * DMI_PANEL;
}

/* Returns the floats that `columns` outputs of `depth` inputs take when packed. */
static inline size_t dmi_panels_size(uint32_t columns, uint32_t depth) {
    return (size_t)dmi_padded_columns(columns) * depth;
}

/* Packs a matrix: element(output j, input k) = source[j * output_stride + k * input_stride]. */
void dmi_panels_pack(const float* source, size_t output_stride, size_t input_stride, uint32_t columns, uint32_t depth,
                     float* out_panels);

/* ---- all kernels ---- */

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
