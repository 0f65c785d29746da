/* Contacts between a proposal and the rest, and how freely the proposal could move there. */
#ifndef DMI_SEGMENTATION_PROPOSAL_CONTACT_H
#define DMI_SEGMENTATION_PROPOSAL_CONTACT_H

#include "segmentation/proposals.h"

/* concave, convex, flush, stacked, stacked with the rest ahead, stacked with the rest behind, same sheet, same shell */
#define DMI_PROPOSAL_CONTACT_KINDS 8

/* Sums over the part's samples that are in contact with the rest; lengths object-normalised. */
typedef struct dmi_proposal_contact {
    float count;                             /* the part's samples in contact with the rest */
    float rest_count;                        /* the rest's samples in contact with the part */
    float kinds[DMI_PROPOSAL_CONTACT_KINDS]; /* samples of each kind */
    float centre[3], square;                 /* sums of x and of |x|^2 */
    float distance;                          /* unit: contact distances */
    float normal[3][3], right[3], constant;  /* normal equations of the speeds, see dmi_proposal_contact_turn */
} dmi_proposal_contact;

dmi_proposal_contact dmi_proposal_contact_sum(const dmi_proposal* part, const dmi_grab* grab);
/* Returns the mean square speed along the contact normals for a unit velocity of the grabbed point along the drag, with
 * the angular velocity about that point chosen by damped least squares. */
float dmi_proposal_contact_turn(const dmi_proposal_contact* sums);

/* Returns whether the sample is in contact with a piece of the part. */
bool dmi_sample_touches(const dmi_pieces* pieces, const uint8_t* inside, const dmi_piece_sample* sample);

#endif
