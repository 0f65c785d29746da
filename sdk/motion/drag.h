/* One drag: the grabbed point stays as near to the pointer's ray as the joint allows; once released, the part moves on
 * by itself. */
#ifndef DMI_MOTION_DRAG_H
#define DMI_MOTION_DRAG_H

#include "motion/drag_bounds.h"
#include "motion/drag_events.h"
#include "motion/drag_hands.h"
#include "motion/drag_latch.h"
#include "motion/drag_release.h"
#include "motion/pose_blend.h"
#include "motion/pull_evidence.h"

/* What constrains the part in one update. */
typedef struct dmi_constraints {
    dmi_bounds bounds;
    bool locked;
    float handles[2];
} dmi_constraints;

/* An update that asks: what dmi_drag_take needs to do it again with another value. */
typedef struct dmi_pending_value {
    bool open;
    float start; /* joint value before the update */
    float dt;
    float lower, upper; /* between which the value may be taken */
    int32_t phase;      /* before the update */
    dmi_event_state event_state;
} dmi_pending_value;

/* Where the part was before an update. */
typedef struct dmi_drag_step_start {
    float value, velocity;
    int32_t phase;
} dmi_drag_step_start;

/* Pointer values that a hand may ask for. */
typedef struct dmi_span {
    float lower, upper;
} dmi_span;

typedef struct dmi_drag {
    dm_joint joint;      /* active joint, host object frame */
    float rest_point[3]; /* the grabbed point with the part at rest */
    dm_drag_feel feel;
    float value, target, velocity;
    float speed;               /* of the grabbed point, host units a unit of the joint value */
    float point[3];            /* the grabbed point as shown */
    float pointer_value;       /* value that the pointer asks for, before soft ends bring it into the limits */
    dm_vec3 grab_offset;       /* from the pointer to the grabbed point when it was grabbed: added to all rays */
    dm_ray last_ray;           /* of the last update that had a usable one; direction unit, zeros before the first */
    dmi_projection projection; /* perspective once rays of different directions have come */
    dmi_hypothesis_tracker tracker; /* count 0: the joint is certain */
    dmi_pull_evidence earlier;      /* of earlier drags of the same instance */
    int32_t basis;                  /* DM_BASIS_* of the joint that the drag began with */
    float first_confidence;         /* of that joint */
    bool limits_are_estimates;      /* limits were inferred and may be exceeded up to the reachable ones */
    float estimated_lower, estimated_upper, reachable_lower, reachable_upper;
    dmi_span pointer_span; /* at whose ends the part is at its limits, as they were found; infinite without limits */
    float closed;          /* value at which the part is closed, inside the limits as they were found */
    float open_way;        /* from there to where it is open, which may be negative; infinite without limits */
    dmi_pose_blend blend;
    uint32_t changes; /* of the active joint */
    dmi_release release;
    dmi_rules rules;
    dmi_constraints constraints; /* of the update at hand; nothing between two */
    float asked;                 /* value that the hand asks for; the target is on its way there (dmi_catch_up) */
    float lag;                   /* target minus that */
    bool stalled;                /* the plan of the release was not followed in the last update: planned anew */
    dmi_drag_step_start start;   /* of the last update */
    dmi_event_state event_state;
    dmi_latch latch;
    dmi_hands hands;
    uint32_t events;     /* found so far in the update at hand, beside those of event_state */
    dmi_landing landing; /* of the last update */
    float waited;        /* s since the release */
    bool stays;          /* released by a host that asked for DM_INTENT_STAY */
    int32_t open_side;   /* on which a part that opens to both sides is to open: dmi_released_part */
    dmi_pending_value pending;
} dmi_drag;

/* Starts a drag. grab_point: position of the grabbed point with the joint at start_value. */
void dmi_drag_begin(dmi_drag* drag, const dm_joint* joint, const float grab_point[3], float start_value,
                    const dm_drag_feel* feel);
/* Declares that the joint was inferred: its limits may be exceeded, and the pull chooses among `joints`, of which the
 * first is active (count 0 or 1: no other). Only with the part at rest. free_ranges: of the joints; NULL: without
 * bounds. size: of the part, host units. */
void dmi_drag_track_hypotheses(dmi_drag* drag, const dm_joint* joints, const dmi_free_range* free_ranges,
                               uint32_t count, float size, dmi_limit_give limit_give);
/* Gives the drag rules: before its first update. */
void dmi_drag_set_rules(dmi_drag* drag, const dmi_rules* rules);
/* Advances by dt seconds. ray may be NULL once released. */
void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state);
/* The same for all that an input holds. */
void dmi_drag_step(dmi_drag* drag, const dm_drag_input* input, float dt, dm_drag_state* out_state);
/* Takes another value in the last update, which has asked. */
void dmi_drag_take(dmi_drag* drag, float value, dm_drag_state* out_state);
/* Tells no events: they are of an update. */
void dmi_drag_get_state(const dmi_drag* drag, dm_drag_state* out_state);
/* Whether the part is more than half-way open. */
bool dmi_drag_is_open(const dmi_drag* drag);
/* Releases the part. intent: DM_INTENT_*; duration: s, 0: chosen by the plan. */
void dmi_drag_release(dmi_drag* drag, int32_t intent, float duration);

#endif
