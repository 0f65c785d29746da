/* Matrix product in plain C: the fallback, and the reference of the other kernels' tests. Also the packing. */
#include "nn/kernels.h"

#include <string.h>

#include "base/compiler.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#define LANES 4 /* floats of a vector; compilers split it where a machine has none */
#define GROUPS (DMI_PANEL / LANES)
#define TILE_ROWS 2 /* sums of eight vectors, in 16 registers */

typedef DMI_VECTOR(float, LANES) lanes;

#if defined(__SSE__)
/* Packs four inputs of a whole panel, which lie side by side in the source. */
static inline void pack_four(const float* corner, size_t output_stride, float* out_panels) {
    for (uint32_t j = 0; j < DMI_PANEL; j += LANES) {
        __m128 in[LANES];
        for (uint32_t i = 0; i < LANES; i++) in[i] = _mm_loadu_ps(corner + (j + i) * output_stride);
        _MM_TRANSPOSE4_PS(in[0], in[1], in[2], in[3]);
        for (uint32_t k = 0; k < LANES; k++) _mm_storeu_ps(out_panels + k * DMI_PANEL + j, in[k]);
    }
}
#else
static inline void pack_four(const float* corner, size_t output_stride, float* out_panels) {
    for (uint32_t k = 0; k < LANES; k++)
        for (uint32_t j = 0; j < DMI_PANEL; j++) out_panels[k * DMI_PANEL + j] = corner[j * output_stride + k];
}
#endif

void dmi_panels_pack(const float* source, size_t output_stride, size_t input_stride, uint32_t columns, uint32_t depth,
                     float* out_panels) {
    for (uint32_t first = 0; first < columns; first += DMI_PANEL) {
        const uint32_t width = columns - first < DMI_PANEL ? columns - first : DMI_PANEL;
        const float* corner = source + first * output_stride;
        uint32_t k = 0;
        if (width == DMI_PANEL && input_stride == 1)
            for (; k + LANES <= depth; k += LANES, out_panels += LANES * DMI_PANEL)
                pack_four(corner + k, output_stride, out_panels);
        for (; k < depth; k++, out_panels += DMI_PANEL) {
            for (uint32_t j = 0; j < width; j++) out_panels[j] = corner[j * output_stride + k * input_stride];
            for (uint32_t j = width; j < DMI_PANEL; j++) out_panels[j] = 0.0f;
        }
    }
}

/* Stores columns first … first + 15 of one row. */
static void store(const dmi_gemm* gemm, uint32_t row, uint32_t first, const lanes sum[GROUPS]) {
    const uint32_t left = gemm->columns - first, width = left < DMI_PANEL ? left : DMI_PANEL;
    float* y = gemm->y + row * gemm->y_stride + first;
    for (uint32_t j = 0; j < width; j++) {
        float value = sum[j / LANES][j % LANES];
        if (gemm->flags & DMI_GEMM_RELU) value = value > 0.0f ? value : 0.0f;
        y[j] = gemm->flags & DMI_GEMM_ADD ? y[j] + value : value;
    }
}

static inline lanes load(const float* p) {
    lanes value;
    memcpy(&value, p, sizeof value);
    return value;
}

/* `rows` is a constant where this is inlined. */
static inline void tile(const dmi_gemm* gemm, uint32_t row, uint32_t first, const uint32_t rows) {
    const float* panel = gemm->panels + (size_t)first * gemm->depth;
    const float* x = gemm->x + row * gemm->x_stride;
    lanes sum[TILE_ROWS][GROUPS] = {{{0}}};
    if (gemm->bias != NULL)
        for (uint32_t r = 0; r < rows; r++) memcpy(sum[r], gemm->bias + first, sizeof sum[r]);
    for (uint32_t k = 0; k < gemm->depth; k++, panel += DMI_PANEL)
        for (size_t g = 0; g < GROUPS; g++) {
            const lanes weights = load(panel + g * LANES);
            for (uint32_t r = 0; r < rows; r++) sum[r][g] += x[r * gemm->x_stride + k] * weights;
        }
    for (uint32_t r = 0; r < rows; r++) store(gemm, row + r, first, sum[r]);
}

void dmi_gemm_scalar(const dmi_gemm* gemm) {
    for (uint32_t first = 0; first < gemm->columns; first += DMI_PANEL) {
        uint32_t row = 0;
        for (; row + TILE_ROWS <= gemm->rows; row += TILE_ROWS) tile(gemm, row, first, TILE_ROWS);
        for (; row < gemm->rows; row++) tile(gemm, row, first, 1);
    }
}
