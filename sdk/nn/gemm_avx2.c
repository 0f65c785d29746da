/* Matrix product with AVX2 and FMA: tiles of rows x panels whose sums stay in twelve registers. */
#include "nn/kernels.h"

#if defined(__x86_64__)
#include <immintrin.h>
#include <math.h>

#define TARGET DMI_TARGET("avx2,fma")
/* 12 sums and their operands fill the 16 registers. */
#define TILE_ROWS 6
#define TILE_PANELS 1
#define ROW_PANELS 4
#include "nn/gemm_tiles.h"

/* Accumulates rows x panels; low and high are columns 0-7 and 8-15 of a panel. `rows` and `panels` are constants where
 * this is inlined: the sums stay in registers as long as no loop over them has a branch. */
TARGET_INLINE void accumulate(const dmi_gemm* gemm, const float* x, size_t first, const size_t rows,
                              const size_t panels, __m256* low, __m256* high) {
    const size_t panel_size = (size_t)gemm->depth * DMI_PANEL, stride = gemm->x_stride;
    const float* panel = gemm->panels + first * gemm->depth;
    const float* bias = gemm->bias != NULL ? gemm->bias + first : zeros;
    for (size_t i = 0; i < rows * panels; i++) {
        low[i] = _mm256_loadu_ps(bias + i % panels * DMI_PANEL);
        high[i] = _mm256_loadu_ps(bias + i % panels * DMI_PANEL + 8);
    }
    for (const float* end = panel + panel_size; panel < end; panel += DMI_PANEL, x++)
        for (size_t i = 0; i < rows * panels; i++) {
            const __m256 value = _mm256_broadcast_ss(x + i / panels * stride);
            const float* weights = panel + i % panels * panel_size;
            low[i] = _mm256_fmadd_ps(value, _mm256_load_ps(weights), low[i]);
            high[i] = _mm256_fmadd_ps(value, _mm256_load_ps(weights + 8), high[i]);
        }
    const __m256 floor = _mm256_set1_ps(gemm->flags & DMI_GEMM_RELU ? 0.0f : -INFINITY);
    for (size_t i = 0; i < rows * panels; i++) {
        low[i] = _mm256_max_ps(floor, low[i]);
        high[i] = _mm256_max_ps(floor, high[i]);
    }
}

TARGET_INLINE void tile(const dmi_gemm* gemm, size_t row, size_t first, const size_t rows, const size_t panels) {
    const size_t stride = gemm->y_stride;
    float* y = gemm->y + row * stride + first;
    __m256 low[TILE], high[TILE];
    accumulate(gemm, gemm->x + row * gemm->x_stride, first, rows, panels, low, high);
    if (gemm->columns - first < panels * DMI_PANEL) {
        float sums[TILE][DMI_PANEL];
        for (size_t i = 0; i < rows * panels; i++) {
            _mm256_storeu_ps(sums[i], low[i]);
            _mm256_storeu_ps(sums[i] + 8, high[i]);
        }
        store_part(gemm, y, gemm->columns - first, (const float(*)[DMI_PANEL])sums, rows, panels);
        return;
    }
    if (gemm->flags & DMI_GEMM_ADD)
        for (size_t i = 0; i < rows * panels; i++) {
            const float* old = y + i / panels * stride + i % panels * DMI_PANEL;
            low[i] = _mm256_add_ps(low[i], _mm256_loadu_ps(old));
            high[i] = _mm256_add_ps(high[i], _mm256_loadu_ps(old + 8));
        }
    for (size_t i = 0; i < rows * panels; i++) {
        float* out = y + i / panels * stride + i % panels * DMI_PANEL;
        _mm256_storeu_ps(out, low[i]);
        _mm256_storeu_ps(out + 8, high[i]);
    }
}

TARGET void dmi_gemm_avx2(const dmi_gemm* gemm) {
    all_tiles(gemm);
}

#endif
