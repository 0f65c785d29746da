/* What a host asks of a part besides following the hand: dm_drag_rules with its defaults filled in. Its highest speed
 * and acceleration, and the bounds of the host's world, limit the step of an update. Its lock and its latch hold the
 * part. */
#ifndef DMI_DRAG_DRAG_RULES_H
#define DMI_DRAG_DRAG_RULES_H

#include "drag/drag_feel.h"

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

/* ---- how far a part gets in one update ---- */

/* Bounds of one update; infinite on a free side. */
typedef struct dmi_bounds {
    float lower, upper;
} dmi_bounds;

/* Returns the value inside the bounds that is nearest to `value`. */
float dmi_bounds_clamp(dmi_bounds bounds, float value);
/* Returns whether the bounds hold a part at `value` that is asked to go to `target`. */
bool dmi_bounds_hold(dmi_bounds bounds, float value, float target, float range, bool held_before);

/* Limits a step of dt seconds from `before`, which the feel or the plan of a release has made. The step gets no faster
 * than the rules allow, and stops softly at the bounds without passing them. speed_before: the velocity before the
 * step. Returns whether value or velocity has changed. */
bool dmi_limit_step(const dmi_rules* rules, dmi_bounds bounds, float before, float speed_before, float dt,
                    float* inout_value, float* inout_velocity);

/* Returns the target for `asked`. `last` is the target of the last update, and `inout_lag` is `last` minus what was
 * asked then. A part that was held glides to the hand once it is free. The caller bounds the result and stores the lag
 * that is left. */
float dmi_catch_up(float asked, float last, float lag, float dt);

/* ---- lock and latch: they hold a part where it is until a key or a handle lets go ---- */

typedef struct dmi_latch {
    bool closed; /* the latch holds the part at rest */
    bool locked; /* the lock holds it at `at` */
    bool turned; /* a handle has opened the latch */
    bool tried;  /* the hand asks for more than is given */
    float at;    /* joint value */
} dmi_latch;

/* Starts with the latch closed where the part is at rest and has one. */
dmi_latch dmi_latch_begin(const dmi_rules* rules, const dm_joint* joint, float value);
static inline bool dmi_latch_holds(const dmi_latch* latch) {
    return latch->closed || latch->locked;
}
/* Follows the lock and the handles of an update. Returns events. */
uint32_t dmi_latch_update(dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float value, bool locked,
                          const float handles[2]);
/* Returns the target of a part that is held, for the one that is asked for: near `at`, and less so the more is asked
 * for. */
float dmi_latch_give(const dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float asked);
/* Returns DM_EVENT_LOCKED when a part that is held is tried. */
uint32_t dmi_latch_try(dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float asked);

#endif
