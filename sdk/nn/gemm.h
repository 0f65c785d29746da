/* Matrix product on packed weights: y = act(x W^T + b), one kernel for each instruction set.
 *
 * A panel holds 16 outputs: panel p, element [k][j] is W[16 p + j][k]; outputs past the last are zero. */
#ifndef DMI_NN_GEMM_H
#define DMI_NN_GEMM_H

#include <stddef.h>
#include <stdint.h>

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

#endif
