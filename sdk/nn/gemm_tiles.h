/* Loops over rows and panels, shared by the kernels that keep tiles of sums in registers (gemm_avx2.c, gemm_avx512.c,
 * gemm_neon.c). They define
 *   TARGET       the attributes of a function of their instruction set
 *   TILE_ROWS    most rows of a tile: 6 or 8
 *   TILE_PANELS  panels of a tile of many rows: 1 or 2
 *   ROW_PANELS   panels of a tile when there is only one row: enough independent sums to hide the latency of FMA
 * before they include it, and `tile` after. */
#ifndef DMI_NN_GEMM_TILES_H
#define DMI_NN_GEMM_TILES_H

#include "base/compiler.h"
#include "nn/kernels.h"

#define TARGET_INLINE TARGET DMI_ALWAYS_INLINE static inline
#define TILE (TILE_ROWS * TILE_PANELS) /* most rows x panels of a tile */

/* Start of the sums without a bias. */
static const float zeros[ROW_PANELS * DMI_PANEL];

/* Stores a tile whose last panel is not full, for instruction sets without masked stores. */
TARGET static inline void store_part(const dmi_gemm* gemm, float* y, size_t columns, const float (*sums)[DMI_PANEL],
                                     size_t rows, size_t panels) {
    for (size_t r = 0; r < rows; r++, y += gemm->y_stride, sums += panels)
        for (size_t j = 0; j < columns; j++) {
            const float sum = sums[j / DMI_PANEL][j % DMI_PANEL];
            y[j] = gemm->flags & DMI_GEMM_ADD ? y[j] + sum : sum;
        }
}

/* Computes rows row.. of the panels first..; `rows` and `panels` are constants where it is inlined. */
TARGET_INLINE void tile(const dmi_gemm* gemm, size_t row, size_t first, const size_t rows, const size_t panels);

/* Computes all rows for the panels from `first` on, in tiles of nearly equal size: 16 rows are 6 + 5 + 5. */
TARGET_INLINE void panel_rows(const dmi_gemm* gemm, size_t first, const size_t panels) {
    uint32_t row = 0;
    for (uint32_t tiles = (gemm->rows + TILE_ROWS - 1) / TILE_ROWS; tiles > 0; tiles--) {
        const uint32_t rows = (gemm->rows - row + tiles - 1) / tiles;
        switch (rows) {
#if TILE_ROWS == 8
        case 8:
            tile(gemm, row, first, 8, panels);
            break;
        case 7:
            tile(gemm, row, first, 7, panels);
            break;
#endif
        case 6:
            tile(gemm, row, first, 6, panels);
            break;
        case 5:
            tile(gemm, row, first, 5, panels);
            break;
        case 4:
            tile(gemm, row, first, 4, panels);
            break;
        case 3:
            tile(gemm, row, first, 3, panels);
            break;
        case 2:
            tile(gemm, row, first, 2, panels);
            break;
        default:
            tile(gemm, row, first, 1, panels);
            break;
        }
        row += rows;
    }
}

TARGET static void one_row(const dmi_gemm* gemm) {
    uint32_t first = 0;
    for (; first + (ROW_PANELS - 1) * DMI_PANEL < gemm->columns; first += ROW_PANELS * DMI_PANEL)
        tile(gemm, 0, first, 1, ROW_PANELS);
    for (; first + DMI_PANEL < gemm->columns; first += 2 * DMI_PANEL) tile(gemm, 0, first, 1, 2);
    for (; first < gemm->columns; first += DMI_PANEL) tile(gemm, 0, first, 1, 1);
}

/* Computes the whole product. */
TARGET_INLINE void all_tiles(const dmi_gemm* gemm) {
    uint32_t first = 0;
    if (gemm->rows == 1) {
        one_row(gemm);
        return;
    }
    for (; first + (TILE_PANELS - 1) * DMI_PANEL < gemm->columns; first += TILE_PANELS * DMI_PANEL)
        panel_rows(gemm, first, TILE_PANELS);
    if (TILE_PANELS > 1 && first < gemm->columns) panel_rows(gemm, first, 1);
}

#endif
