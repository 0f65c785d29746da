/* The pieces a mesh falls into, samples of their surfaces, and where they touch: what a part is put together from. */
#ifndef DMI_SEGMENTATION_PART_PIECES_H
#define DMI_SEGMENTATION_PART_PIECES_H

#include "base/arena.h"
#include "mesh/mesh.h"

#define DMI_PIECE_TOUCHES 6 /* most other pieces that one sample touches */

typedef struct dmi_piece_touch {
    uint32_t sample; /* of the other piece, the nearest */
    float distance;
} dmi_piece_touch;

typedef struct dmi_piece_sample {
    float point[3], normal[3];
    uint32_t piece, touch_count;
    dmi_piece_touch touches[DMI_PIECE_TOUCHES]; /* one a piece */
} dmi_piece_sample;

typedef struct dmi_pieces {
    const dmi_mesh* mesh;
    const uint32_t* labels; /* face -> piece */
    uint32_t count;
    float* area;               /* of a piece */
    dmi_piece_sample* samples; /* piece after piece */
    uint32_t* first;           /* of a piece; one more at the end */
    float reach;               /* samples nearer than this touch */
    uint32_t (*pairs)[2];      /* pieces that touch, each pair once */
    uint32_t pair_count;
} dmi_pieces;

/* Everything lives in the arena. labels: face -> 0 .. count - 1. */
dm_result dmi_pieces_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* labels, uint32_t count,
                          dmi_pieces* out);

#endif
