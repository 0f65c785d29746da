/* What a released part does: the intent of the player (release_intent.c), the plan from where the part is and how fast
 * it goes to where it ends (release_plan.c), and the motion along it (release_motion.c). */
#ifndef DMI_DRAG_RELEASE_H
#define DMI_DRAG_RELEASE_H

#include <stdbool.h>
#include <stdint.h>

#include "drag/drag_rules.h"
#include "motion/motion.h"

/* ---- intent ---- */

/* A part at the moment of its release. */
typedef struct dmi_released_part {
    const dm_joint* joint;
    const dm_drag_feel* feel;
    const dmi_rules* rules; /* rules of the part; NULL: it has none */
    float value, velocity;
    int32_t side; /* side on which a part that opens to both sides is to open: -1 or 1; 0: where it was pulled */
} dmi_released_part;

/* Returns the part's rules, or none. */
const dmi_rules* dmi_released_rules(const dmi_released_part* part);
/* Returns whether limits bound the part to both sides. */
bool dmi_released_has_range(const dmi_released_part* part);
/* Returns the joint value whose shares the thresholds are: the range, where the part has one. */
float dmi_released_unit(const dmi_released_part* part);
/* Returns the distance that exponentially decaying velocity covers. */
float dmi_released_glide(const dmi_released_part* part);
/* Returns whether a snap value catches the part as it glides to a stop. */
bool dmi_released_is_caught(const dmi_released_part* part, float* out_snap);
/* Returns whether the part glides against a limit that throws it back. */
bool dmi_released_is_thrown_back(const dmi_released_part* part);
/* Returns whether the part falls, to rest or to its open end. */
bool dmi_released_falls(const dmi_released_part* part);
/* Returns whether the part closes by itself from where it is. */
bool dmi_released_closes_itself(const dmi_released_part* part);
/* Returns the intent that DM_INTENT_AUTO stands for. */
int32_t dmi_released_intent(const dmi_released_part* part, float return_time);
/* Returns whether the part is more than half-way from rest to the end on its side. */
bool dmi_release_is_open(const dmi_released_part* part);
/* Returns the limit that is not rest; of two, the one on the side that the part was pulled to. */
float dmi_release_open_end(const dmi_released_part* part);

/* ---- free motion between the limits, with bounces: a fall, or a glide; its steps are exact at any frame rate ---- */

typedef struct dmi_flight {
    float lower, upper;  /* limits, joint values */
    float acceleration;  /* joint value a second squared, signed; 0: glides */
    float time_constant; /* s, of the speed of a glide: e-fold */
    float restitution;   /* share of the speed that is left after a limit, 0 to 1 */
} dmi_flight;

/* What a step has done. */
typedef struct dmi_landing {
    int32_t struck; /* the limit struck last: -1, 0 for none, 1 */
    float impact;   /* speed of the hardest one, joint value a second */
    bool settled;   /* it does not move on */
} dmi_landing;

/* Advances value and velocity by dt seconds. */
dmi_landing dmi_flight_advance(const dmi_flight* flight, float dt, float* inout_value, float* inout_velocity);
/* Returns where a glide ends. */
float dmi_flight_end(const dmi_flight* flight, float value, float velocity);

/* ---- plan and motion ---- */

typedef struct dmi_release {
    int32_t phase, intent;        /* DM_DRAG_*; DM_INTENT_STAY, OPEN, CLOSE or FREEZE */
    float start, end, velocity;   /* joint values, and velocity at the release in values a second */
    float duration, elapsed;      /* s */
    float return_time;            /* s; 0: nothing springs back */
    bool glides;                  /* the value decays exponentially without an aim; else it moves to `end` */
    bool flies;                   /* it falls, or glides with bounces, from value and velocity to value and velocity */
    float acceleration;           /* acceleration of a fall, joint value a second squared; 0: it glides */
    bool paced;                   /* it follows the keys; else minimum jerk */
    float keys[DM_MOTION_FRAMES]; /* joint values from rest outwards, evenly spaced in time */
    float first, last;            /* times on the keys, 0 to 1, where the part starts and ends */
} dmi_release;

/* Plans the release. intent: DM_INTENT_* as the host asked. duration: s; 0 lets the plan choose it. The phase becomes
 * DM_DRAG_RELEASED, or DM_DRAG_AT_REST when there is nothing to do. */
void dmi_release_begin(dmi_release* release, const dmi_released_part* part, int32_t intent, float duration);
/* Paces the plan by a generated motion from rest to the outer one of start and end. Values that do not suit the plan
 * leave it as it is. Returns whether the plan is paced. */
bool dmi_release_set_pace(dmi_release* release, const float values[DM_MOTION_FRAMES]);
/* Advances value and velocity by dt seconds. */
void dmi_release_advance(dmi_release* release, const dm_drag_feel* feel, const dm_joint* joint, float dt,
                         float* out_value, float* out_velocity);
/* Does the same for a plan that flies. Returns the limits that it has struck. */
dmi_landing dmi_release_fly(dmi_release* release, const dmi_released_part* part, float dt, float* out_value,
                            float* out_velocity);

#endif
