/* Scene handles for other parts of the boundary. */
#ifndef DMI_API_SCENE_H
#define DMI_API_SCENE_H

#include "api_handles.h"

/* Frees a scene that has been removed from its pool. */
void dmi_scene_release(dm_context* context, dmi_scene_slot* slot);

/* Removes an object's instances from all scenes. */
void dmi_scenes_remove_object(dm_context* context, dmi_object_slot* slot);

#endif
