/* One drag. The grabbed point stays as near to the pointer's ray as the joint allows; once released, the part moves on
 * by itself. */
#ifndef DMI_DRAG_DRAG_H
#define DMI_DRAG_DRAG_H

#include "drag/drag_events.h"
#include "drag/drag_rules.h"
#include "drag/follow.h"
#include "drag/hypothesis_tracker.h"
#include "drag/pose_blend.h"
#include "drag/release.h"

/* ---- hands other than one pointer: a hand in space, a scalar, and a second hand beside the first ---- */

/* Number of eyes from which a hand in space is shown to the hypothesis tracker, in turn. The tracker knows only rays,
 * and from two sides no motion is end on in all. */
#define DMI_HAND_EYES 2

/* A second hand on the part. */
typedef struct dmi_second_hand {
    bool on;
    bool placed;         /* bias is known */
    float rest_point[3]; /* where it holds the part, with the part at rest */
    float value;         /* joint value that it asked for last, without the bias */
    float bias;          /* joint value that is added to what it asks for, so that it comes without a jump */
} dmi_second_hand;

typedef struct dmi_hands {
    int32_t kind;    /* DM_HAND_* of the last update; POINT: `point` holds */
    bool has_offset; /* offset is known */
    float offset[3]; /* vector from the hand in space to the point that it grabbed */
    float point[3];  /* place of the hand in space, with the offset added */
    float bias;      /* joint value that is added to what the first hand asks for, since a second one has gone */
    float pressed;   /* s for which a scalar has asked for more at an estimated limit; 0: it does not */
    uint32_t eye;    /* eye of the next ray that the hypothesis tracker gets from a hand in space */
    dmi_second_hand second;
} dmi_hands;

/* ---- one update ---- */

/* What constrains the part in one update. */
typedef struct dmi_constraints {
    dmi_bounds bounds;
    bool locked;
    float handles[2];
} dmi_constraints;

/* What dmi_drag_take needs to do an update that asks (DM_INPUT_ASK) again with another value. */
typedef struct dmi_pending_value {
    bool open;
    float start; /* joint value before the update */
    float dt;
    float lower, upper; /* bounds between which the value may be taken */
    int32_t phase;      /* phase before the update */
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

/* ---- the drag ---- */

typedef struct dmi_drag {
    dm_joint joint;      /* active joint, host object frame */
    float rest_point[3]; /* the grabbed point with the part at rest */
    dm_drag_feel feel;
    float value, target, velocity;
    float speed;         /* speed of the grabbed point, host units a unit of the joint value */
    float point[3];      /* the grabbed point as shown */
    float pointer_value; /* value that the pointer asks for, before soft ends bring it into the limits */
    dm_vec3 grab_offset; /* vector from the pointer to the grabbed point when it was grabbed; it is added to all rays */
    dm_ray last_ray;     /* the last usable ray; its direction is unit, and zeros before the first one */
    dmi_projection projection;      /* parallel, and perspective once rays of different directions have come */
    dmi_hypothesis_tracker tracker; /* hypotheses that the pull chooses among; count 0: the joint is certain */
    dmi_pull_evidence earlier;      /* what earlier drags of the same instance have said of its joints */
    int32_t basis;                  /* DM_BASIS_* of the joint that the drag began with */
    float first_confidence;         /* confidence of that joint */
    bool limits_are_estimates;      /* the limits were inferred, and may be exceeded up to the reachable ones */
    float estimated_lower, estimated_upper, reachable_lower, reachable_upper;
    dmi_span pointer_span; /* pointer values at which the part is at its limits, as they were found; infinite without
                              limits */
    float closed;          /* value at which the part is closed, inside the limits as they were found */
    float open_way;        /* way from `closed` to where it is open, which may be negative; infinite without limits */
    dmi_pose_blend blend;
    uint32_t changes; /* changes of the active joint */
    dmi_release release;
    dmi_rules rules;
    dmi_constraints constraints; /* constraints of the update that runs; nothing between two updates */
    float asked;                 /* value that the hand asks for; the target is on its way there (dmi_catch_up) */
    float lag;                   /* target minus `asked` */
    bool stalled; /* the part did not follow the plan of its release in the last update, so the plan is made anew */
    dmi_drag_step_start start; /* where the part was before the last update */
    dmi_event_state event_state;
    dmi_latch latch;
    dmi_hands hands;
    uint32_t events;     /* events found so far in the update that runs, beside those of event_state */
    dmi_landing landing; /* limits that the part has struck in the last update */
    float waited;        /* s since the release */
    bool stays;          /* the host has released it with DM_INTENT_STAY */
    int32_t open_side;   /* side on which a part that opens to both sides is to open, as dmi_released_part.side */
    dmi_pending_value pending;
} dmi_drag;

/* Starts a drag. grab_point: position of the grabbed point with the joint at start_value. */
void dmi_drag_begin(dmi_drag* drag, const dm_joint* joint, const float grab_point[3], float start_value,
                    const dm_drag_feel* feel);
/* Declares that the joint was inferred. Its limits may be exceeded then, and the pull chooses among `joints`, of which
 * the first is active; with a count of 0 or 1 there is no other. The part must be at rest. free_ranges: ranges that are
 * free for the joints; NULL: they have no bounds. size: the part's, host units. */
void dmi_drag_track_hypotheses(dmi_drag* drag, const dm_joint* joints, const dmi_free_range* free_ranges,
                               uint32_t count, float size, dmi_limit_give limit_give);
/* Gives the drag its rules. Call it before the first update. */
void dmi_drag_set_rules(dmi_drag* drag, const dmi_rules* rules);
/* Advances the drag by dt seconds. ray may be NULL once the part is released. */
void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state);
/* Does the same for everything that an input can hold. */
void dmi_drag_step(dmi_drag* drag, const dm_drag_input* input, float dt, dm_drag_state* out_state);
/* Repeats the last update, which must have asked (DM_INPUT_ASK), with another value. */
void dmi_drag_take(dmi_drag* drag, float value, dm_drag_state* out_state);
/* Writes how the drag stands. Its events are 0, because only an update has events. */
void dmi_drag_get_state(const dmi_drag* drag, dm_drag_state* out_state);
/* Returns whether the part is more than half-way open. */
bool dmi_drag_is_open(const dmi_drag* drag);
/* Releases the part. intent: DM_INTENT_*. duration: s; 0 lets the plan choose it. */
void dmi_drag_release(dmi_drag* drag, int32_t intent, float duration);

#endif
