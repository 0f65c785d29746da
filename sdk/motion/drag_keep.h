/* Keeps a drag's rules in an update. Only drags that have rules. */
#ifndef DMI_MOTION_DRAG_KEEP_H
#define DMI_MOTION_DRAG_KEEP_H

#include "motion/drag.h"

/* Remembers where the part is before the update. */
void dmi_drag_note_start(dmi_drag* drag);
/* Brings the target to what the hand asks for, as far as the rules let it. before: the target of the last update. */
void dmi_drag_hold_back(dmi_drag* drag, float before, float dt);
/* Limits the step of this update, and finds what has happened. */
void dmi_drag_keep_rules(dmi_drag* drag, float dt);
void dmi_drag_write_events(const dmi_drag* drag, dm_drag_state* out_state);

#endif
