/* Reads and applies the part finder's networks. */
#include "segmentation/part_networks.h"

#include "segmentation/proposals.h"
#include "segmentation/region_growing.h"

#define BATCH 32 /* rows at a time: their hidden numbers are on the stack */

enum { GROWTH_HIDDEN = 16, CHOICE_HIDDEN = 144 };

void dmi_part_growth_read(dmi_loader* loader, dmi_perceptron* out) {
    static const uint32_t sizes[] = {DMI_NEIGHBOUR_FEATURES, GROWTH_HIDDEN, 1};
    dmi_load_perceptron(loader, "growth", sizes, 2, out);
}

void dmi_part_choice_read(dmi_loader* loader, dmi_perceptron* out) {
    static const uint32_t sizes[] = {DMI_PROPOSAL_FEATURES, CHOICE_HIDDEN, 1};
    dmi_load_perceptron(loader, "choice", sizes, 2, out);
}

void dmi_part_network_apply(const dmi_perceptron* network, dmi_isa isa, const float* features, uint32_t count,
                            float* out) {
    _Alignas(DMI_ALIGNMENT) float hidden[BATCH][CHOICE_HIDDEN];
    float* const buffers[2] = {hidden[0], NULL};
    const uint32_t inputs = network->layers[0].inputs;
    for (uint32_t first = 0; first < count; first += BATCH) {
        const uint32_t rows = count - first < BATCH ? count - first : BATCH;
        dmi_perceptron_apply(network, dmi_kernels_for(isa), features + (size_t)first * inputs, rows, buffers,
                             out + first);
    }
}
