/* Drag handles for other parts of the boundary. */
#ifndef DMI_API_DRAG_H
#define DMI_API_DRAG_H

#include <stdbool.h>

#include "api_handles.h"

/* Whether a drag can have begun with this feel. */
bool dmi_is_usable_feel(const dm_drag_feel* feel);
/* Reports, once, what an update noticed and may not log itself. */
void dmi_drag_slot_warn(dmi_env* env, const char* function, dmi_drag_slot* slot);

#endif
