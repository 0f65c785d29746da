/* Players' hands: they pick what is before them, pull it open, and let go. */
#ifndef SAMPLE_HANDS_H
#define SAMPLE_HANDS_H

#include "stream.h"

enum { HANDS = 4, PULL_FRAMES = 45 /* of a drag */ };
#define ARM 14.0f /* m that a hand reaches */

typedef struct hand {
    dm_drag drag; /* 0: it holds nothing */
    uint32_t prop, part, frame;
    dm_vec3 eye, from, to; /* the pointer's ray goes from the eye to between the other two; world frame */
} hand;

typedef struct hands {
    stream* stream;
    hand hand[HANDS];
    uint64_t picks, hits, drags, updates;
} hands;

/* Moves what is held; before the scene's commit. */
dm_result hands_pull(hands* h);
/* Picks for the hands that hold nothing; after the commit. */
dm_result hands_look(hands* h, const dm_camera* camera, uint64_t frame);
/* Lets go of a prop that is about to leave: stream.leaves. */
void hands_leave(void* hands, uint32_t prop);
/* Lets go of all. */
void hands_rest(hands* h);

#endif
