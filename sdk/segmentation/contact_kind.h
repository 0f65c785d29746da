/* Classification of a contact by the positions and normals of its two samples. */
#ifndef DMI_SEGMENTATION_CONTACT_KIND_H
#define DMI_SEGMENTATION_CONTACT_KIND_H

#include "segmentation/pieces.h"

typedef struct dmi_contact_kind {
    bool flush, stacked;  /* parallel faces: coplanar, or one above the other */
    bool concave, convex; /* each sample lies before the other's plane, or each behind it */
    bool ahead, behind;   /* stacked, and the first sample lies ahead of the other along the drag, or behind it */
} dmi_contact_kind;

/* Classifies the contact of `sample` with another piece's sample. drag: unit, or zeros: none. */
dmi_contact_kind dmi_contact_classify(const dmi_pieces* pieces, const dmi_piece_sample* sample,
                                      const dmi_piece_contact* contact, const float drag[3]);

#endif
