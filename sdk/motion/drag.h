/* Follow the pointer: the grabbed point stays as near the pointer's ray as its joint allows; let go, the part moves on.
 */
#ifndef DMI_MOTION_DRAG_H
#define DMI_MOTION_DRAG_H

#include "motion/drag_handover.h"
#include "motion/drag_release.h"
#include "motion/hypothesis_tracker.h"

typedef struct dmi_drag {
    dm_joint joint;      /* host object frame */
    float rest_point[3]; /* the grabbed point with the part at rest */
    dm_drag_feel feel;
    float value, target, velocity;
    float speed;               /* how far the grabbed point goes a unit of the value */
    float point[3];            /* where the grabbed point is */
    float reach;               /* the value the pointer asks for before soft ends bring it into the limits */
    dm_ray last_ray;           /* of the last update that had a usable one; direction unit, zeros before the first */
    dmi_projection projection; /* perspective once rays of different directions have come */
    dmi_hypothesis_tracker rivals;         /* count 0: nothing else is thought of */
    int yields;                /* its limits are estimates: these, and at most those the pull may take it to */
    float guess_lower, guess_upper, most_lower, most_upper;
    dmi_handover handover;
    uint32_t changes; /* of the joint */
    dmi_release release;
} dmi_drag;

/* grab_point: where the grabbed point is with the joint at start_value. */
void dmi_drag_begin(dmi_drag* drag, const dm_joint* joint, const float grab_point[3], float start_value,
                    const dm_drag_feel* feel);
/* The joint was found by the library: its limits yield. joints: what the part may move by instead, the best, which is
 * in force, first; count 0 or 1: nothing else. Only with the part at rest. size: of the part. */
void dmi_drag_doubt(dmi_drag* drag, const dm_joint* joints, uint32_t count, float size, dmi_give give);
/* ray may be NULL once released. */
void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state);
void dmi_drag_state_now(const dmi_drag* drag, dm_drag_state* out_state);

#endif
