/* Which of its hypotheses a part moves by, told by how the player pulls it: the pull stays near the right joint's path.
 */
#ifndef DMI_MOTION_HYPOTHESIS_TRACKER_H
#define DMI_MOTION_HYPOTHESIS_TRACKER_H

#include <stdbool.h>

#include "motion/drag_lines.h"

typedef struct dmi_hypothesis_tracker {
    dmi_hold hold;
    dmi_joint_hypothesis list[DMI_TRACKED_HYPOTHESES];
    uint32_t count, best;               /* best: in force */
    float hope[DMI_TRACKED_HYPOTHESES]; /* by which they are weighed: the score, and what comes with waiting */
    uint32_t round;                     /* of weighing */
    dmi_lines lines;
} dmi_hypothesis_tracker;

/* joints[0] is in force. Adds the other side of ranges that begin at rest: which way a part opens is easily mistaken.
 */
void dmi_hypothesis_tracker_init(dmi_hypothesis_tracker* rivals, const dm_joint* joints, uint32_t count,
                                 const float grab_point[3], float size, dmi_give give);
/* One more, of which no range is known; one too many is left out. */
void dmi_hypothesis_tracker_add_alternative(dmi_hypothesis_tracker* rivals, const dm_joint* joint);
/* Weighs the best, which asks for `wish` on its side of rest, and the likeliest of the others by one more ray; not all,
 * so that an update stays near a microsecond. 1 when another, the other side, or another line has become the best. */
bool dmi_hypothesis_tracker_weigh(dmi_hypothesis_tracker* rivals, float wish, const dm_ray* ray,
                                  dmi_projection projection);
/* Probability of the best. */
float dmi_hypothesis_tracker_confidence(const dmi_hypothesis_tracker* rivals);

#endif
