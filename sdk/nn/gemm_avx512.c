/* Matrix product on AVX-512: as gemm_avx2.c, with a panel in one register and sixteen sums a tile. */
#include "nn/kernels.h"

#if defined(__x86_64__)
#include <immintrin.h>
#include <math.h>

#define TARGET DMI_TARGET("avx512f")
/* 16 sums and their operands in 32 registers. */
#define TILE_ROWS 8
#define TILE_PANELS 2
#define ROW_PANELS 8
#include "nn/gemm_tiles.h"

/* Returns the mask of existing columns of the panel that starts at `first`. */
TARGET_INLINE __mmask16 columns_mask(const dmi_gemm* gemm, size_t first) {
    const size_t left = gemm->columns - first;
    const uint32_t bits = left >= DMI_PANEL ? 0xffffu : (1u << left) - 1u;
    return (__mmask16)bits;
}

/* `rows` and `panels` are constants where this is inlined: the sums stay in registers, as long as no loop over them has
 * a branch. */
TARGET_INLINE void tile(const dmi_gemm* gemm, size_t row, size_t first, const size_t rows, const size_t panels) {
    const size_t panel_size = (size_t)gemm->depth * DMI_PANEL, x_stride = gemm->x_stride, y_stride = gemm->y_stride;
    const float* panel = gemm->panels + first * gemm->depth;
    const float* bias = gemm->bias != NULL ? gemm->bias + first : zeros;
    const float* x = gemm->x + row * x_stride;
    float* y = gemm->y + row * y_stride + first;
    __m512 sum[TILE];
    for (size_t i = 0; i < rows * panels; i++) sum[i] = _mm512_loadu_ps(bias + i % panels * DMI_PANEL);
    for (const float* end = panel + panel_size; panel < end; panel += DMI_PANEL, x++)
        for (size_t i = 0; i < rows * panels; i++)
            sum[i] = _mm512_fmadd_ps(_mm512_set1_ps(x[i / panels * x_stride]),
                                     _mm512_load_ps(panel + i % panels * panel_size), sum[i]);
    const __m512 floor = _mm512_set1_ps(gemm->flags & DMI_GEMM_RELU ? 0.0f : -INFINITY);
    const __mmask16 full = 0xffff /* all 16 columns */, last = columns_mask(gemm, first + (panels - 1) * DMI_PANEL);
    const __mmask16 old = gemm->flags & DMI_GEMM_ADD ? full : 0;
    for (size_t i = 0; i < rows * panels; i++) {
        const __mmask16 mask = i % panels == panels - 1 ? last : full;
        float* out = y + i / panels * y_stride + i % panels * DMI_PANEL;
        const __m512 value = _mm512_max_ps(floor, sum[i]);
        _mm512_mask_storeu_ps(out, mask, _mm512_add_ps(value, _mm512_maskz_loadu_ps((__mmask16)(mask & old), out)));
    }
}

TARGET void dmi_gemm_avx512(const dmi_gemm* gemm) {
    all_tiles(gemm);
}

#endif
