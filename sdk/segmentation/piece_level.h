/* Divisions of a mesh into pieces at two levels of detail: sheets of surface, or one sheet's smooth regions and the
 * other sheets. */
#ifndef DMI_SEGMENTATION_PIECE_LEVEL_H
#define DMI_SEGMENTATION_PIECE_LEVEL_H

#include "segmentation/pieces.h"

#define DMI_PIECE_MAX_REPEATS 4 /* pieces of the same area that one piece lists; by hand */

typedef struct dmi_mesh_sheets {
    const dmi_mesh* mesh;
    uint32_t* welded; /* vertex -> the vertex that represents its position */
    uint32_t* labels; /* face -> sheet, as of dmi_face_sheets_and_fans */
    uint32_t* shells; /* face -> shell connected over shared vertices; a sheet lies in one shell */
    uint32_t count;   /* number of sheets */
} dmi_mesh_sheets;

typedef struct dmi_piece_level {
    dmi_pieces pieces;
    uint32_t *sheets, *shells;                  /* piece -> its sheet, its shell */
    uint32_t (*repeats)[DMI_PIECE_MAX_REPEATS]; /* piece -> others of the same area, then DMI_PIECE_NONE */
    float total_area;                           /* object-normalised */
    bool sheet_is_cut;                          /* one sheet is divided into its smooth regions */
} dmi_piece_level;

/* Both functions take all memory from the arena. progress: may be NULL. */
dm_result dmi_mesh_sheets_make(dmi_arena* arena, const dmi_mesh* mesh, const dmi_progress* progress,
                               dmi_mesh_sheets* out);
/* Makes every sheet a piece; the sheet `cut`, unless DMI_PIECE_NONE, is divided into its smooth regions. When that
 * sheet has a single region, out->pieces.count is 0. */
dm_result dmi_piece_level_make(dmi_arena* arena, const dmi_mesh_sheets* sheets, uint32_t cut,
                               const dmi_progress* progress, dmi_piece_level* out);

#endif
