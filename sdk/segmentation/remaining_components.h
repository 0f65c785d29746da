/* Connected components of the pieces that remain when a part is taken out of a mesh. */
#ifndef DMI_SEGMENTATION_REMAINING_COMPONENTS_H
#define DMI_SEGMENTATION_REMAINING_COMPONENTS_H

#include "segmentation/pieces.h"

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
