/* Which of its hypotheses a part moves by, told by how the player pulls it: the pull stays near the right joint's path.
 */
#ifndef DMI_MOTION_DRAG_RIVALS_H
#define DMI_MOTION_DRAG_RIVALS_H

#include "motion/drag_lines.h"

typedef struct dmi_rivals {
    dmi_hold hold;
    dmi_rival list[DMI_RIVALS];
    uint32_t count, best;   /* best: in force */
    float hope[DMI_RIVALS]; /* by which they are weighed: the score, and what comes with waiting */
    uint32_t round;         /* of weighing */
    dmi_lines lines;
} dmi_rivals;

/* joints[0] is in force. Adds the other side of ranges that begin at rest: which way a part opens is easily mistaken.
 */
void dmi_rivals_init(dmi_rivals* rivals, const dm_joint* joints, uint32_t count, const float grab_point[3], float size,
                     dmi_give give);
/* One more, of which no range is known; one too many is left out. */
void dmi_rivals_add_alternative(dmi_rivals* rivals, const dm_joint* joint);
/* Weighs the best, which asks for `wish` on its side of rest, and the likeliest of the others by one more ray; not all,
 * so that an update stays near a microsecond. 1 when another, the other side, or another line has become the best. */
int dmi_rivals_weigh(dmi_rivals* rivals, float wish, const dm_ray* ray, dmi_projection projection);
/* Probability of the best. */
float dmi_rivals_confidence(const dmi_rivals* rivals);

#endif
