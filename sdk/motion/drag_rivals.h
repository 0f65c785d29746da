/* Which of its hypotheses a part moves by, told by how the player pulls it: the pull stays near the right joint's path.
 */
#ifndef DMI_MOTION_DRAG_RIVALS_H
#define DMI_MOTION_DRAG_RIVALS_H

#include "motion/follow.h"

#define DMI_RIVALS 6

typedef struct dmi_rival {
    dm_joint joint; /* host object frame */
    float prior;    /* log of its probability before the pull, up to a constant */
    float score;    /* the same after it */
    float reach;    /* the value the pointer asks of it */
} dmi_rival;

typedef struct dmi_rivals {
    dmi_rival list[DMI_RIVALS];
    uint32_t count, best; /* best: in force */
    float size;           /* of the part */
    float pull;           /* how far the pointer went from the grabbed point, at its depth, at most */
} dmi_rivals;

/* joints[0] is in force. Adds the other side of ranges that begin at rest: which way a part opens is easily mistaken.
 */
void dmi_rivals_init(dmi_rivals* rivals, const dm_joint* joints, uint32_t count, float size);
/* Weighs them by one more ray. 1 when another has become the best. */
int dmi_rivals_weigh(dmi_rivals* rivals, const float grab_point[3], const dm_ray* ray, dmi_projection projection);
/* Probability of the best. */
float dmi_rivals_confidence(const dmi_rivals* rivals);

#endif
