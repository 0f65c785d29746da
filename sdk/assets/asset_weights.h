/* The weights of the asset's models: the bytes of sdk/models/asset_parts.safetensors. premake5.lua writes them to
 * build/embed/asset_weights.c. */
#ifndef DMI_ASSETS_ASSET_WEIGHTS_H
#define DMI_ASSETS_ASSET_WEIGHTS_H

#include <stddef.h>

extern const unsigned char dmi_asset_weights[]; /* 64-byte aligned */
extern const size_t dmi_asset_weights_size;     /* bytes */

#endif
