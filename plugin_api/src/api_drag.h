/* Drag handles for other parts of the boundary. */
#ifndef DMI_API_DRAG_H
#define DMI_API_DRAG_H

#include "api_handles.h"

/* Checks the numbers of a feel; errors name the field of dm_drag_begin. */
dm_result dmi_check_feel(dmi_env* env, const dm_drag_feel* feel);
/* Reports, once, what an update noticed and may not log itself. */
void dmi_drag_slot_warn(dmi_env* env, const char* function, dmi_drag_slot* slot);

#endif
