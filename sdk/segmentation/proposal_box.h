/* A box along the principal axes of surface samples. */
#ifndef DMI_SEGMENTATION_PROPOSAL_BOX_H
#define DMI_SEGMENTATION_PROPOSAL_BOX_H

#include <stdbool.h>
#include <stdint.h>

#define DMI_MIN_BOX_SIDE 1e-6f /* object sizes: the least side that is divided by */

/* Lengths are object-normalised. */
typedef struct dmi_proposal_box {
    float centre[3];       /* mean of the samples */
    float axes[3][3];      /* unit rows, largest variance first */
    float low[3], high[3]; /* ends along each axis, from the centre */
    float radius;          /* root mean square distance of the samples from the centre */
    uint32_t samples;
} dmi_proposal_box;

dmi_proposal_box dmi_proposal_box_fit(const float (*points)[3], uint32_t count);
/* Returns whether the point lies in the box grown by the margin on all sides. */
bool dmi_proposal_box_contains(const dmi_proposal_box* box, const float point[3], float margin);
/* Computes for each axis the share of occupied cells of the box whose mirror image across it is occupied too. points:
 * those that the box was fitted to. */
void dmi_proposal_box_symmetry(const dmi_proposal_box* box, const float (*points)[3], float out[3]);

#endif
