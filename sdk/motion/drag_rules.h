/* What a host asks of a part besides following the hand: dm_drag_rules with its defaults filled in. */
#ifndef DMI_MOTION_DRAG_RULES_H
#define DMI_MOTION_DRAG_RULES_H

#include "motion/drag_feel.h"
#include "motion/drag_snaps.h"

typedef struct dmi_rules {
    bool on;           /* false: the part has no rules */
    bool one_sided;    /* only one of the joint's limits is one */
    float object_size; /* host units */
    uint32_t flags;    /* DM_RULE_* */
    dmi_snaps snaps;
    float open_share, closed_share; /* shares of the range from where the part is closed */
    float event_time;               /* s */
    float max_speed;                /* joint value a second; 0: none */
    float max_acceleration;         /* joint value a second squared; 0: none */
    float lock_give;                /* share of the range; 0: none */
    float latch_turn;               /* joint value of a handle */
    float auto_close_share;         /* share of the range; 0: the part does not close itself */
    float auto_close_time;          /* s */
    float close_delay;              /* s */
    float tip_share;                /* share of the range; 0: the part does not fall */
    float fall_time;                /* s over the whole range */
    float restitution;              /* 0 to 1 */
    float break_distance;           /* host units; 0: none */
    float drive_speed;              /* share of the range a second */
} dmi_rules;

/* Fills in the defaults. given: valid rules, whose snap values are copied. */
dmi_rules dmi_rules_from(const dm_drag_rules* given, const dm_drag_feel* feel, const dm_joint* joint, bool one_sided,
                         float object_size);
/* Returns how far a value is from where the part is closed, a share of the range. */
float dmi_rules_share(const dmi_rules* rules, const dm_joint* joint, float value);
/* Returns how far a value is from rest, a share of the range. */
float dmi_rules_share_from_rest(const dmi_rules* rules, const dm_joint* joint, float value);
/* Returns the range of a joint; where a limit is missing, 1 rad or the object's size. */
float dmi_rules_range(const dmi_rules* rules, const dm_joint* joint);

#endif
