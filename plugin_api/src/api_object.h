/* Object handles for other parts of the boundary. */
#ifndef DMI_API_OBJECT_H
#define DMI_API_OBJECT_H

#include "api_handles.h"

/* Takes ownership of an object, encodes it for the motion network of `model` (0: none), and gives it a handle. It warns
 * in the name of `function` of what the object lacks. unmissed: bits DM_DEGRADED_* that the warning leaves out. */
dm_result dmi_object_publish(dm_context* context, const char* function, dmi_object* object, dm_model model,
                             uint32_t unmissed, dm_object* out_object);

/* Frees an object that has been removed from its pool, with its motions and drags. It must be in no scene. */
void dmi_object_release(dm_context* context, dmi_object_slot* slot);

#endif
