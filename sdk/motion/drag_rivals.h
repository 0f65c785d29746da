/* Which of its hypotheses a part moves by, told by how the player pulls it: the pull stays near the right joint's path.
 */
#ifndef DMI_MOTION_DRAG_RIVALS_H
#define DMI_MOTION_DRAG_RIVALS_H

#include "motion/drag_fit.h"

#define DMI_RIVALS 64

typedef struct dmi_rival {
    dm_joint joint;   /* host object frame */
    float home[3];    /* the origin that it came with; the pull may have shifted it … */
    float shift[2];   /* … by so much (drag_fit.h), … */
    float lean;       /* … which costs so much, log */
    float side;       /* of rest that its range was found on, +1 or -1; 0: both */
    int open;         /* nothing is known of its range */
    int settled;      /* the part has gone out on that side: rest is its stop */
    float prior;      /* log of its probability before the pull, up to a constant */
    float score;      /* the same after it */
    float reach;      /* the value the pointer asks of it, on whichever side */
    float worst;      /* how far it has missed the pull, at most */
    float stop_score; /* were it held by the stop at rest that its joint has */
} dmi_rival;

/* How far a pull takes a part beyond limits that were only estimated. */
typedef struct dmi_give {
    float share;  /* of the range; 0: as far as it is pulled … */
    float length; /* … up to this along a slide, and up to a turn */
} dmi_give;

/* A rival on its way through the pull: as it is, and then, if that promises more, with its line shifted. */
typedef struct dmi_fitting {
    dmi_fit fit;
    uint32_t rival, thinned;
    int shifted;
    float shift[2], lean; /* tried now */
    float before;         /* how well the line as it was explains the pull, log */
} dmi_fitting;

typedef struct dmi_rivals {
    dmi_rival list[DMI_RIVALS];
    uint32_t count, best;      /* best: in force */
    float hope[DMI_RIVALS];    /* by which they are weighed: the score, and what comes with waiting */
    uint32_t round;            /* of weighing */
    float promise[DMI_RIVALS]; /* by which lines are fitted: the score after it, and what comes with waiting */
    uint32_t fits;
    float size; /* of the part */
    dmi_give give;
    dmi_pull pull;
    dmi_fitting fitting;
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
/* Where the pull may take a joint that the library found: a stop at rest is a stop, but how far a part opens was only
 * estimated. Infinite without limits. */
void dmi_rivals_limits(const dm_joint* joint, dmi_give give, float* out_lower, float* out_upper);
/* Probability of the best. */
float dmi_rivals_confidence(const dmi_rivals* rivals);

#endif
