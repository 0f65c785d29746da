/* Matrix product on NEON: as gemm_avx2.c, with a panel in four registers and twenty-four sums a tile. */
#include "nn/kernels.h"

#if defined(__aarch64__)
#include <arm_neon.h>
#include <math.h>

#define TARGET /* part of the architecture */
/* 24 sums and their operands in 32 registers. */
#define TILE_ROWS 6
#define TILE_PANELS 1
#define ROW_PANELS 4
#include "nn/gemm_tiles.h"

#define LANES 4                    /* floats of a register */
#define GROUPS (DMI_PANEL / LANES) /* registers a panel */

/* Accumulates rows x panels. Both are constants where this is inlined: the sums stay in registers, as long as no loop
 * over them has a branch. */
TARGET_INLINE void accumulate(const dmi_gemm* gemm, const float* x, size_t first, const size_t rows,
                              const size_t panels, float32x4_t (*sum)[GROUPS]) {
    const size_t panel_size = (size_t)gemm->depth * DMI_PANEL, stride = gemm->x_stride;
    const float* panel = gemm->panels + first * gemm->depth;
    const float* bias = gemm->bias ? gemm->bias + first : zeros;
    for (size_t i = 0; i < rows * panels; i++)
        for (size_t g = 0; g < GROUPS; g++) sum[i][g] = vld1q_f32(bias + i % panels * DMI_PANEL + g * LANES);
    for (const float* end = panel + panel_size; panel < end; panel += DMI_PANEL, x++)
        for (size_t i = 0; i < rows * panels; i++) {
            const float value = x[i / panels * stride];
            const float* weights = panel + i % panels * panel_size;
            for (size_t g = 0; g < GROUPS; g++)
                sum[i][g] = vfmaq_n_f32(sum[i][g], vld1q_f32(weights + g * LANES), value);
        }
    const float32x4_t floor = vdupq_n_f32(gemm->flags & DMI_GEMM_RELU ? 0.0f : -INFINITY);
    for (size_t i = 0; i < rows * panels; i++)
        for (size_t g = 0; g < GROUPS; g++) sum[i][g] = vmaxq_f32(floor, sum[i][g]);
}

TARGET_INLINE void tile(const dmi_gemm* gemm, size_t row, size_t first, const size_t rows, const size_t panels) {
    const size_t stride = gemm->y_stride;
    float* y = gemm->y + row * stride + first;
    float32x4_t sum[TILE][GROUPS];
    accumulate(gemm, gemm->x + row * gemm->x_stride, first, rows, panels, sum);
    if (gemm->columns - first < panels * DMI_PANEL) {
        float sums[TILE][DMI_PANEL];
        for (size_t i = 0; i < rows * panels; i++)
            for (size_t g = 0; g < GROUPS; g++) vst1q_f32(sums[i] + g * LANES, sum[i][g]);
        store_part(gemm, y, gemm->columns - first, (const float(*)[DMI_PANEL])sums, rows, panels);
        return;
    }
    for (size_t i = 0; i < rows * panels; i++)
        for (size_t g = 0; g < GROUPS; g++) {
            float* out = y + i / panels * stride + i % panels * DMI_PANEL + g * LANES;
            if (gemm->flags & DMI_GEMM_ADD) sum[i][g] = vaddq_f32(sum[i][g], vld1q_f32(out));
            vst1q_f32(out, sum[i][g]);
        }
}

void dmi_gemm_neon(const dmi_gemm* gemm) {
    all_tiles(gemm);
}

#else
typedef int dmi_no_neon; /* ISO C asks for a declaration in every file */
#endif
