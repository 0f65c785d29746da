/* The keys of a track as an animated node. */
#ifndef DMI_GLTF_ANIMATION_H
#define DMI_GLTF_ANIMATION_H

#include "gltf/gltf_moves.h"

/* Adds an animation in front of all others, so that a viewer plays it. */
cJSON* dmi_animation_add(dmi_edit* e, const char* name);
/* Adds the node that the track moves and its channels. Returns the node, which has no children yet and stands at
 * `out_pivot` in the scene. */
dmi_edit_item dmi_animation_add_track(dmi_edit* e, const dmi_moves* moves, cJSON* animation, const dm_gltf_track* track,
                                      uint32_t index, double out_pivot[3]);

#endif
