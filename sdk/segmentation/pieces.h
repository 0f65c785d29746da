/* The pieces that a mesh is divided into, samples of their surfaces, and the contacts between them. */
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

#endif
