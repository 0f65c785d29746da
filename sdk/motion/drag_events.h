/* Events of a dragged part (DM_EVENT_*): compares one update with the one before, with hysteresis, so that a trembling
 * hand makes no noise. */
#ifndef DMI_MOTION_DRAG_EVENTS_H
#define DMI_MOTION_DRAG_EVENTS_H

#include "motion/drag_rules.h"

typedef struct dmi_event_state {
    int32_t limit;       /* at which the part is: -1, 0 or 1 */
    bool away, open;     /* from rest; as far as opened */
    bool blocked;        /* by the bounds of an update */
    float since_opening; /* s since it was last opened or closed */
    float catch_index;   /* of the detent or snap value whose it is; an integer */
    float peak_speed;    /* joint value a second, lately: fades */
    uint32_t changes;    /* of the joint */
    uint32_t events;     /* of the last update: DM_EVENT_* */
    uint32_t detents;    /* gone over to in the last update */
    float impact;        /* of the last update, joint value a second */
} dmi_event_state;

/* Where the part is after an update. */
typedef struct dmi_event_input {
    const dm_joint* joint;
    const dm_drag_feel* feel;
    const dmi_rules* rules;
    float value, velocity;
    bool blocked;
    bool beyond_lower, beyond_upper; /* an estimated limit has given: where it was last is no limit */
    uint32_t changes;
    int32_t struck;  /* a limit struck during the update: -1, 0 for none, 1 … */
    float impact;    /* … and how fast */
    uint32_t others; /* events that others have found */
} dmi_event_input;

/* Starts where the part is, without an event. */
dmi_event_state dmi_event_state_begin(const dmi_event_input* now);
/* Finds what has happened in an update of dt seconds. */
void dmi_event_state_update(dmi_event_state* state, const dmi_event_input* now, float dt);

#endif
