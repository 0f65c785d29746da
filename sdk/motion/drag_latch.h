/* Lock and latch of a part. They hold it where it is until a key or a handle lets go. */
#ifndef DMI_MOTION_DRAG_LATCH_H
#define DMI_MOTION_DRAG_LATCH_H

#include "motion/drag_rules.h"

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
