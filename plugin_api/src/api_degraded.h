/* What answers lack: the bits DM_DEGRADED_*, and the one warning about them. */
#ifndef DMI_API_DEGRADED_H
#define DMI_API_DEGRADED_H

#include "api_handles.h"

/* Returns the bits of an object in use: what it was prepared without, and whether its motion network is missing. */
uint32_t dmi_degraded_of(const dmi_object_slot* slot);
/* Warns in the name of `function` of everything that the bits stand for. With 0 it logs nothing. */
void dmi_degraded_warn(dmi_env* env, const char* function, uint32_t bits);

#endif
