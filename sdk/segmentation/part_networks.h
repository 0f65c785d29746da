/* The part finder's two networks: one rates whether a piece belongs to a growing region, the other which proposal is
 * the part. Both have one hidden layer and one output, and are fitted on generated objects. */
#ifndef DMI_SEGMENTATION_PART_NETWORKS_H
#define DMI_SEGMENTATION_PART_NETWORKS_H

#include <stddef.h>

#include "nn/layers.h"

#define DMI_PART_FINDER_ARCHITECTURE "dragmesh-part-finder" /* name in the weights file */

typedef struct dmi_part_networks {
    dmi_perceptron growth; /* DMI_NEIGHBOUR_FEATURES -> 16 -> log odds that the piece belongs to the region */
    dmi_perceptron choice; /* DMI_PROPOSAL_FEATURES -> 144 -> score of the proposal, unnormalised */
} dmi_part_networks;

/* Reads the tensors growth.*. */
void dmi_part_growth_read(dmi_loader* loader, dmi_perceptron* out);
/* Reads the tensors choice.*. */
void dmi_part_choice_read(dmi_loader* loader, dmi_perceptron* out);

/* Applies either network to `count` dense rows of features. */
void dmi_part_network_apply(const dmi_perceptron* network, dmi_isa isa, const float* features, uint32_t count,
                            float* out);

extern const unsigned char dmi_part_finder_weights[]; /* 64-byte aligned */
extern const size_t dmi_part_finder_weights_size;     /* bytes */

#endif
