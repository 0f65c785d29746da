/* Matrix product on NEON: as gemm_avx2.c, with a panel in four registers and twenty-four sums a tile. */
#include "nn/gemm.h"

#if defined(__aarch64__)
#include <arm_neon.h>
#include <math.h>

#define TILE_INLINE __attribute__((always_inline)) static inline
#define TILE 6 /* most rows x panels of a tile */
#define LANES 4
#define GROUPS (DMI_PANEL / LANES) /* registers a panel */

/* The start of the sums when there is no bias. */
static const float zeros[4 * DMI_PANEL];

/* The end of a tile whose last panel is not full. */
static void store_part(const dmi_gemm* gemm, float* y, size_t columns, const float (*sums)[DMI_PANEL], size_t rows,
                       size_t panels) {
    for (size_t r = 0; r < rows; ++r, y += gemm->y_stride, sums += panels)
        for (size_t j = 0; j < columns; ++j) {
            const float sum = sums[j / DMI_PANEL][j % DMI_PANEL];
            y[j] = gemm->flags & DMI_GEMM_ADD ? y[j] + sum : sum;
        }
}

/* Sums of rows x panels. Both are constants where this is inlined: the sums stay in registers, as long as no loop over
 * them has a branch. */
TILE_INLINE void accumulate(const dmi_gemm* gemm, const float* x, size_t first, const size_t rows, const size_t panels,
                            float32x4_t (*sum)[GROUPS]) {
    const size_t panel_size = (size_t)gemm->depth * DMI_PANEL, stride = gemm->x_stride;
    const float* panel = gemm->panels + first * gemm->depth;
    const float* bias = gemm->bias ? gemm->bias + first : zeros;
    for (size_t i = 0; i < rows * panels; ++i)
        for (size_t g = 0; g < GROUPS; ++g) sum[i][g] = vld1q_f32(bias + i % panels * DMI_PANEL + g * LANES);
    for (const float* end = panel + panel_size; panel < end; panel += DMI_PANEL, ++x)
        for (size_t i = 0; i < rows * panels; ++i) {
            const float value = x[i / panels * stride];
            const float* weights = panel + i % panels * panel_size;
            for (size_t g = 0; g < GROUPS; ++g)
                sum[i][g] = vfmaq_n_f32(sum[i][g], vld1q_f32(weights + g * LANES), value);
        }
    const float32x4_t floor = vdupq_n_f32(gemm->flags & DMI_GEMM_RELU ? 0.0f : -INFINITY);
    for (size_t i = 0; i < rows * panels; ++i)
        for (size_t g = 0; g < GROUPS; ++g) sum[i][g] = vmaxq_f32(floor, sum[i][g]);
}

TILE_INLINE void tile(const dmi_gemm* gemm, size_t row, size_t first, const size_t rows, const size_t panels) {
    const size_t stride = gemm->y_stride;
    float* y = gemm->y + row * stride + first;
    float32x4_t sum[TILE][GROUPS];
    accumulate(gemm, gemm->x + row * gemm->x_stride, first, rows, panels, sum);
    if (gemm->columns - first < panels * DMI_PANEL) {
        float sums[TILE][DMI_PANEL];
        for (size_t i = 0; i < rows * panels; ++i)
            for (size_t g = 0; g < GROUPS; ++g) vst1q_f32(sums[i] + g * LANES, sum[i][g]);
        store_part(gemm, y, gemm->columns - first, (const float(*)[DMI_PANEL])sums, rows, panels);
        return;
    }
    for (size_t i = 0; i < rows * panels; ++i)
        for (size_t g = 0; g < GROUPS; ++g) {
            float* out = y + i / panels * stride + i % panels * DMI_PANEL + g * LANES;
            if (gemm->flags & DMI_GEMM_ADD) sum[i][g] = vaddq_f32(sum[i][g], vld1q_f32(out));
            vst1q_f32(out, sum[i][g]);
        }
}

/* All rows for one panel, in tiles as even as can be: 16 rows are 6 + 5 + 5. */
static void panel_rows(const dmi_gemm* gemm, size_t first) {
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
static void one_row(const dmi_gemm* gemm) {
    uint32_t first = 0;
    for (; first + 3 * DMI_PANEL < gemm->columns; first += 4 * DMI_PANEL) tile(gemm, 0, first, 1, 4);
    for (; first + DMI_PANEL < gemm->columns; first += 2 * DMI_PANEL) tile(gemm, 0, first, 1, 2);
    for (; first < gemm->columns; first += DMI_PANEL) tile(gemm, 0, first, 1, 1);
}

void dmi_gemm_neon(const dmi_gemm* gemm) {
    if (gemm->rows == 1) {
        one_row(gemm);
        return;
    }
    for (uint32_t first = 0; first < gemm->columns; first += DMI_PANEL) panel_rows(gemm, first);
}

#else
typedef int dmi_no_neon; /* ISO C asks for a declaration in every file */
#endif
