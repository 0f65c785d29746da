/* Asset handles for other parts of the boundary. */
#ifndef DMI_API_ASSET_H
#define DMI_API_ASSET_H

#include "api_handles.h"

/* Frees an asset that has been removed from its pool. */
void dmi_asset_release(dm_context* context, dmi_asset_slot* slot);

#endif
