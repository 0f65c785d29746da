/* Events of a dragged part (DM_EVENT_*): compares one update with the one before, with hysteresis, so that a trembling
 * hand makes no noise. */
#ifndef DMI_DRAG_DRAG_EVENTS_H
#define DMI_DRAG_DRAG_EVENTS_H

#include "drag/drag_rules.h"

typedef struct dmi_event_state {
    int32_t limit;       /* limit that the part is at: -1, 0 or 1 */
    bool away, open;     /* it is away from rest; it counts as open */
    bool blocked;        /* the bounds of an update hold it */
    float since_opening; /* s since it was last opened or closed */
    float catch_index;   /* index of the detent or snap value that holds it; an integer */
    float peak_speed;    /* highest recent speed, joint value a second; it fades */
    uint32_t changes;    /* changes of the joint, as dm_drag_state.changes */
    uint32_t events;     /* DM_EVENT_* of the last update */
    uint32_t detents;    /* detents that it has gone over to in the last update */
    float impact;        /* speed of an impact in the last update, joint value a second */
} dmi_event_state;

/* Where the part is after an update. */
typedef struct dmi_event_input {
    const dm_joint* joint;
    const dm_drag_feel* feel;
    const dmi_rules* rules;
    float value, velocity;
    bool blocked;
    bool beyond_lower, beyond_upper; /* an estimated limit has given, so the place where it was is no limit */
    uint32_t changes;
    int32_t struck;  /* limit struck during the update: -1, 1, or 0 for none … */
    float impact;    /* … and the speed of the impact, joint value a second */
    uint32_t others; /* events that others have found */
} dmi_event_input;

/* Returns the state of a part where it is, without an event. */
dmi_event_state dmi_event_state_begin(const dmi_event_input* now);
/* Finds what has happened in an update of dt seconds. */
void dmi_event_state_update(dmi_event_state* state, const dmi_event_input* now, float dt);

#endif
