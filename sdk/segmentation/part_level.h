/* A mesh taken apart into pieces, coarsely (sheets of surface) or more finely, and how pieces relate. */
#ifndef DMI_SEGMENTATION_PART_LEVEL_H
#define DMI_SEGMENTATION_PART_LEVEL_H

#include "segmentation/part_pieces.h"

#define DMI_PART_TWINS 4
#define DMI_PART_NONE UINT32_MAX

typedef struct dmi_part_sheets {
    const dmi_mesh* mesh;
    uint32_t* welded; /* vertex -> the one that stands for its place */
    uint32_t* labels; /* face -> sheet */
    uint32_t* shells; /* face -> shell over shared vertices; a sheet is of one shell */
    uint32_t count;
} dmi_part_sheets;

typedef struct dmi_part_level {
    dmi_pieces pieces;
    uint32_t *sheets, *shells;         /* of a piece */
    uint32_t (*twins)[DMI_PART_TWINS]; /* of a piece: others of the same area, as repeated parts have; rest: NONE */
    float total_area;
    int fine; /* a sheet is cut */
} dmi_part_level;

/* All live in the arena. */
dm_result dmi_part_sheets_make(dmi_arena* arena, const dmi_mesh* mesh, dmi_part_sheets* out);
/* Sheets as pieces; the sheet `cut`, unless NONE, in its smooth regions. No pieces at all: there was nothing to cut. */
dm_result dmi_part_level_make(dmi_arena* arena, const dmi_part_sheets* sheets, uint32_t cut, dmi_part_level* out);

#endif
