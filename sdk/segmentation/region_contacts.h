/* What is around a region: its contacts with the pieces outside it, and the connected components that these make.
 * Contacts are kept while the region grows: a piece that joins changes the sums of the pieces that it is in contact
 * with, and no others. */
#ifndef DMI_SEGMENTATION_REGION_CONTACTS_H
#define DMI_SEGMENTATION_REGION_CONTACTS_H

#include "segmentation/pieces.h"

/* ---- kinds of contacts ---- */

typedef struct dmi_contact_kind {
    bool flush, stacked;  /* parallel faces: coplanar, or one above the other */
    bool concave, convex; /* each sample lies before the other's plane, or each behind it */
    bool ahead, behind;   /* stacked, and the first sample lies ahead of the other along the drag, or behind it */
} dmi_contact_kind;

/* Classifies the contact of `sample` with another piece's sample. drag: unit, or zeros: none. */
dmi_contact_kind dmi_contact_classify(const dmi_pieces* pieces, const dmi_piece_sample* sample,
                                      const dmi_piece_contact* contact, const float drag[3]);

/* ---- contacts of a region ---- */

/* Contacts of a piece outside the region, in numbers of samples. */
typedef struct dmi_neighbour_contacts {
    uint32_t with_region, with_others; /* the piece's samples in contact with the region, with another piece outside */
    uint32_t from_region;              /* the region's samples in contact with the piece */
    uint32_t flush, stacked, ahead, behind, concave, convex; /* kinds of the contacts in with_region */
    float distance;                                          /* sum over with_region, in contact distances */
} dmi_neighbour_contacts;

typedef struct dmi_region_contacts {
    const dmi_pieces* pieces;
    float drag[3];                    /* unit; zeros: none */
    uint32_t *samples, *first_sample; /* samples in contact with another piece; per piece, where its own begin */
    uint32_t *touching_pieces, *first_of_touching; /* those with a sample in contact with a piece; where they begin */
    dmi_neighbour_contacts* sums;                  /* per piece; of those outside the region */
} dmi_region_contacts;

/* Makes the contacts of an empty region. All memory comes from the arena. drag: as of dmi_region_make. */
dm_result dmi_region_contacts_make(dmi_arena* arena, const dmi_pieces* pieces, const float drag[3],
                                   dmi_region_contacts* out);
/* Takes in that a piece has joined. inside: per piece, 1 in the region, that piece already. */
void dmi_region_contacts_add(dmi_region_contacts* contacts, const uint8_t* inside, uint32_t piece);

/* ---- connected components of the pieces that remain outside ---- */

#define DMI_PIECE_CARRIED 2 /* value of `inside` for a piece that moves with the part by being attached to it alone */

typedef struct dmi_remaining_components {
    uint32_t* roots;       /* piece -> the piece that represents its component */
    float* area;           /* area of each component, at its root; object-normalised */
    uint8_t* touches_part; /* whether each component does, at its root */
    uint32_t largest;      /* root of the largest component; DMI_PIECE_NONE: the part is everything */
    float part_area;
} dmi_remaining_components;

/* Allocates room for the components from the arena. */
dm_result dmi_remaining_components_make(dmi_arena* arena, const dmi_pieces* pieces, dmi_remaining_components* out);
/* Computes the components of the pieces with inside[p] == 0. */
void dmi_remaining_components_find(const dmi_pieces* pieces, const uint8_t* inside, dmi_remaining_components* out);
/* Sets inside[p] to DMI_PIECE_CARRIED for the pieces of small components that touch the part, the largest component
 * excepted. Returns their number. */
uint32_t dmi_remaining_components_carry(const dmi_pieces* pieces, const dmi_remaining_components* components,
                                        uint8_t* inside);

#endif
