/* What a host asks of a part besides following the hand: dm_drag_rules with its defaults filled in. */
#ifndef DMI_MOTION_DRAG_RULES_H
#define DMI_MOTION_DRAG_RULES_H

#include "motion/drag_feel.h"
#include "motion/drag_snaps.h"

typedef struct dmi_rules {
    bool on;           /* false: none of it */
    bool one_sided;    /* only one of the joint's limits is one */
    float object_size; /* host units */
    dmi_snaps snaps;
    float open_share, closed_share; /* of the range, from rest */
    float event_time;               /* s */
    float max_speed;                /* joint value a second; 0: none */
    float max_acceleration;         /* joint value a second squared; 0: none */
} dmi_rules;

/* Fills in the defaults. given: sound, its snap values copied at once. */
dmi_rules dmi_rules_from(const dm_drag_rules* given, const dm_drag_feel* feel, const dm_joint* joint, bool one_sided,
                         float object_size);
/* Returns the range of a joint; where a limit is missing, 1 rad or the object's size. */
float dmi_rules_range(const dmi_rules* rules, const dm_joint* joint);

#endif
