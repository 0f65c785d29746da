/* What an entry of the property `parts` says: a DragMeshPart, or a Dictionary with the same names. */
#ifndef DRAGMESH_GODOT_SETTINGS_H
#define DRAGMESH_GODOT_SETTINGS_H

#include "body.h"

/* All but the handles of its latch, which are nodes. entry nil: defaults. */
void settings_read(settings* out, const gd_value* entry, bool* out_locked);

/* ---- joints and states as Dictionaries, with the names of their fields ---- */

gd_value value_of_joint(const dm_joint* joint);
/* What the Dictionary does not hold stays. */
void joint_of_value(const gd_value* value, dm_joint* joint);
gd_value value_of_pose(const dm_pose* pose);
gd_value value_of_part_state(const dm_part_state* state);
void part_state_of_value(const gd_value* value, dm_part_state* state);
gd_value value_of_drag_state(const dm_drag_state* state);
gd_value value_of_vec3(dm_vec3 v);
dm_vec3 vec3_of_value(const gd_value* value);

#endif
