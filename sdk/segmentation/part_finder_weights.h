/* The weights of the part finder's networks: the bytes of sdk/models/part_finder.safetensors. premake5.lua writes them
 * to build/embed/part_finder_weights.c. */
#ifndef DMI_SEGMENTATION_PART_FINDER_WEIGHTS_H
#define DMI_SEGMENTATION_PART_FINDER_WEIGHTS_H

#include <stddef.h>

extern const unsigned char dmi_part_finder_weights[]; /* 64-byte aligned */
extern const size_t dmi_part_finder_weights_size;     /* bytes */

#endif
