/* Matrix product on AVX2 and FMA: tiles of rows x panels whose sums stay in twelve registers. */
#include "nn/gemm.h"

#if defined(__x86_64__)
#include <immintrin.h>
#include <math.h>

#define TARGET __attribute__((target("avx2,fma")))
#define TARGET_INLINE TARGET __attribute__((always_inline)) static inline
#define TILE 6 /* most rows x panels of a tile */

/* The start of the sums when there is no bias. */
static const float zeros[4 * DMI_PANEL];

/* The end of a tile whose last panel is not full. */
TARGET static void store_part(const dmi_gemm* gemm, float* y, size_t columns, const float (*sums)[DMI_PANEL],
                              size_t rows, size_t panels) {
    for (size_t r = 0; r < rows; ++r, y += gemm->y_stride, sums += panels)
        for (size_t j = 0; j < columns; ++j) {
            const float sum = sums[j / DMI_PANEL][j % DMI_PANEL];
            y[j] = gemm->flags & DMI_GEMM_ADD ? y[j] + sum : sum;
        }
}

/* Sums of rows x panels; low and high are columns 0-7 and 8-15 of a panel. `rows` and `panels` are constants where this
 * is inlined: the sums stay in registers, as long as no loop over them has a branch. */
TARGET_INLINE void accumulate(const dmi_gemm* gemm, const float* x, size_t first, const size_t rows,
                              const size_t panels, __m256* low, __m256* high) {
    const size_t panel_size = (size_t)gemm->depth * DMI_PANEL, stride = gemm->x_stride;
    const float* panel = gemm->panels + first * gemm->depth;
    const float* bias = gemm->bias ? gemm->bias + first : zeros;
    for (size_t i = 0; i < rows * panels; ++i) {
        low[i] = _mm256_loadu_ps(bias + i % panels * DMI_PANEL);
        high[i] = _mm256_loadu_ps(bias + i % panels * DMI_PANEL + 8);
    }
    for (const float* end = panel + panel_size; panel < end; panel += DMI_PANEL, ++x)
        for (size_t i = 0; i < rows * panels; ++i) {
            const __m256 value = _mm256_broadcast_ss(x + i / panels * stride);
            const float* weights = panel + i % panels * panel_size;
            low[i] = _mm256_fmadd_ps(value, _mm256_load_ps(weights), low[i]);
            high[i] = _mm256_fmadd_ps(value, _mm256_load_ps(weights + 8), high[i]);
        }
    const __m256 floor = _mm256_set1_ps(gemm->flags & DMI_GEMM_RELU ? 0.0f : -INFINITY);
    for (size_t i = 0; i < rows * panels; ++i) {
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
        for (size_t i = 0; i < rows * panels; ++i) {
            _mm256_storeu_ps(sums[i], low[i]);
            _mm256_storeu_ps(sums[i] + 8, high[i]);
        }
        store_part(gemm, y, gemm->columns - first, (const float(*)[DMI_PANEL])sums, rows, panels);
        return;
    }
    if (gemm->flags & DMI_GEMM_ADD)
        for (size_t i = 0; i < rows * panels; ++i) {
            const float* old = y + i / panels * stride + i % panels * DMI_PANEL;
            low[i] = _mm256_add_ps(low[i], _mm256_loadu_ps(old));
            high[i] = _mm256_add_ps(high[i], _mm256_loadu_ps(old + 8));
        }
    for (size_t i = 0; i < rows * panels; ++i) {
        float* out = y + i / panels * stride + i % panels * DMI_PANEL;
        _mm256_storeu_ps(out, low[i]);
        _mm256_storeu_ps(out + 8, high[i]);
    }
}

/* All rows for one panel, in tiles as even as can be: 16 rows are 6 + 5 + 5. */
TARGET static void panel_rows(const dmi_gemm* gemm, size_t first) {
    uint32_t row = 0;
    for (uint32_t tiles = (gemm->rows + TILE - 1) / TILE; tiles > 0; --tiles) {
        const uint32_t rows = (gemm->rows - row + tiles - 1) / tiles;
        switch (rows) {
        case 6:
            tile(gemm, row, first, 6, 1);
            break;
        case 5:
            tile(gemm, row, first, 5, 1);
            break;
        case 4:
            tile(gemm, row, first, 4, 1);
            break;
        case 3:
            tile(gemm, row, first, 3, 1);
            break;
        case 2:
            tile(gemm, row, first, 2, 1);
            break;
        default:
            tile(gemm, row, first, 1, 1);
            break;
        }
        row += rows;
    }
}

/* One row: four panels at a time, for enough independent sums to hide the latency of FMA. */
TARGET static void one_row(const dmi_gemm* gemm) {
    uint32_t first = 0;
    for (; first + 3 * DMI_PANEL < gemm->columns; first += 4 * DMI_PANEL) tile(gemm, 0, first, 1, 4);
    for (; first + DMI_PANEL < gemm->columns; first += 2 * DMI_PANEL) tile(gemm, 0, first, 1, 2);
    for (; first < gemm->columns; first += DMI_PANEL) tile(gemm, 0, first, 1, 1);
}

TARGET void dmi_gemm_avx2(const dmi_gemm* gemm) {
    if (gemm->rows == 1) {
        one_row(gemm);
        return;
    }
    for (uint32_t first = 0; first < gemm->columns; first += DMI_PANEL) panel_rows(gemm, first);
}

#endif
