/* The pieces that a mesh is divided into, at two levels of detail, samples of their surfaces, and the contacts between
 * them. */
#ifndef DMI_SEGMENTATION_PIECES_H
#define DMI_SEGMENTATION_PIECES_H

#include <stdbool.h>

#include "base/arena.h"
#include "mesh/mesh.h"

#define DMI_PIECE_NONE UINT32_MAX
#define DMI_PIECE_MAX_CONTACTS 6 /* other pieces that one sample keeps a contact with; by hand */

typedef struct dmi_piece_contact {
    uint32_t sample; /* nearest sample of the other piece */
    float distance;  /* object-normalised */
} dmi_piece_contact;

typedef struct dmi_piece_sample {
    float point[3], normal[3]; /* object-normalised; unit */
    uint32_t piece, contact_count;
    dmi_piece_contact contacts[DMI_PIECE_MAX_CONTACTS]; /* one per other piece at most */
} dmi_piece_sample;

typedef struct dmi_pieces {
    const dmi_mesh* mesh;
    const uint32_t* labels; /* face -> piece */
    uint32_t count;
    float* area;               /* per piece, object-normalised */
    dmi_piece_sample* samples; /* sorted by piece */
    uint32_t* first;           /* samples of piece p: first[p] .. first[p + 1] - 1 */
    float contact_distance;    /* samples of two pieces that are closer than this are in contact */
    uint32_t (*pairs)[2];      /* pieces in contact, each unordered pair once, smaller index first */
    uint32_t pair_count;
} dmi_pieces;

/* Samples the pieces and finds their contacts. All memory comes from the arena. labels: face -> 0 .. count - 1. */
dm_result dmi_pieces_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* labels, uint32_t count,
                          dmi_pieces* out);

/* ---- levels (piece_level.c): sheets of surface, or one sheet's smooth regions and the other sheets ---- */

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
