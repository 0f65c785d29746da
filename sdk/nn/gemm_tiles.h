/* What the kernels with tiles of twelve sums (gemm_avx2.c, gemm_neon.c) share: the walk over rows and panels. For them
 * alone: they define TARGET, the attributes of a function of their instruction set, and `tile`. */
#ifndef DMI_NN_GEMM_TILES_H
#define DMI_NN_GEMM_TILES_H

#include "nn/gemm.h"

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

/* Rows row.. of the panels first..; `rows` and `panels` are constants where it is inlined. */
TARGET_INLINE void tile(const dmi_gemm* gemm, size_t row, size_t first, const size_t rows, const size_t panels);

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

/* The whole product. */
TARGET_INLINE void all_tiles(const dmi_gemm* gemm) {
    if (gemm->rows == 1) {
        one_row(gemm);
        return;
    }
    for (uint32_t first = 0; first < gemm->columns; first += DMI_PANEL) panel_rows(gemm, first);
}

#endif
