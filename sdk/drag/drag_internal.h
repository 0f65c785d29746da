/* Steps of an update that the files of a drag share. The files, in the order of an update, and the fields of dmi_drag
 * that each of them is about:
 *
 *   drag.c          begins and ends an update: constraints, pending, point
 *   drag_pointer.h  reads the pointer's ray: last_ray, grab_offset, projection
 *   drag_hands.c    reads all other hands: hands
 *   drag_joint.c    holds the joint, its limits, and what the hand asks of it: joint, tracker, closed, asked, blend
 *   drag_keep.c     applies the host's rules, and finds what has happened: start, latch, lag, events, event_state
 *   drag_release.c  moves a part that is let go: release, waited, stays, landing, stalled
 *
 * These hand on the pointer value, the target, and value and velocity of the part. */
#ifndef DMI_DRAG_DRAG_INTERNAL_H
#define DMI_DRAG_DRAG_INTERNAL_H

#include "drag/drag.h"

/* ---- drag_joint.c ---- */

/* Returns the pointer value that asks for `value`. */
float dmi_drag_pointer_value(const dmi_drag* drag, float value);
/* Returns the joint with its limits as they were found: a pull beyond estimated ones moves them along. */
dm_joint dmi_drag_found_joint(const dmi_drag* drag);
/* Finds where the part is closed, its way open, and the pointer values of the limits: anew when joint, limits or rules
 * have changed. */
void dmi_drag_measure_span(dmi_drag* drag);
/* Finds how fast the grabbed point moves, host units a unit of the joint value: anew when the joint has changed. */
void dmi_drag_measure_speed(dmi_drag* drag);
/* Returns where the part is shown. */
dm_pose dmi_drag_shown_pose(const dmi_drag* drag);
/* Sets the value that is asked for by the pointer value. */
void dmi_drag_ask(dmi_drag* drag);
/* Shows the tracker a ray; `nearest` is the value of the active joint. Returns true when the joint has changed. */
bool dmi_drag_track(dmi_drag* drag, float nearest, const dm_ray* unit);

/* ---- drag_release.c ---- */

/* Moves a released part on by dt seconds. */
void dmi_drag_update_released(dmi_drag* drag, float dt);

/* ---- drag_hands.c ---- */

/* Reads what the hands of an input ask for. */
void dmi_drag_aim(dmi_drag* drag, const dm_drag_input* input, float dt);
/* Returns how far the hand is from where it holds the part, host units. */
float dmi_drag_hand_miss(const dmi_drag* drag);

/* ---- drag_keep.c: only of drags that have rules, but for the status ---- */

/* Remembers where the part is before the update. */
void dmi_drag_note_start(dmi_drag* drag);
/* Brings the target to what the hand asks for, as far as the rules let it. before: the target of the last update. */
void dmi_drag_hold_back(dmi_drag* drag, float before, float dt);
/* Limits the step of this update, and finds what has happened. */
void dmi_drag_keep_rules(dmi_drag* drag, float dt);
/* Finds anew what has happened in the last update, which has asked. */
void dmi_drag_find_events_again(dmi_drag* drag);
void dmi_drag_write_events(const dmi_drag* drag, dm_drag_state* out_state);
/* Returns what holds the part, and how it stands: DM_STATUS_*; 0 without rules. */
uint32_t dmi_drag_status(const dmi_drag* drag);

#endif
