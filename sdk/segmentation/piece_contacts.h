/* Contacts between samples of different pieces, found with a hash grid. */
#ifndef DMI_SEGMENTATION_PIECE_CONTACTS_H
#define DMI_SEGMENTATION_PIECE_CONTACTS_H

#include "segmentation/pieces.h"

/* Fills the samples' contacts, `pairs` and `pair_count`. `samples`, `first` and `contact_distance` are given. */
dm_result dmi_piece_contacts_find(dmi_arena* arena, dmi_pieces* pieces);

#endif
