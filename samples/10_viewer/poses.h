/* A log of poses, for comparing two runs bit by bit. */
#ifndef VIEWER_POSES_H
#define VIEWER_POSES_H

#include <stdio.h>

#include "world.h"

typedef struct poses {
    FILE* file; /* may be NULL: only the hash is kept */
    uint64_t hash;
    dm_pose last[WORLD_MAX_PARTS + 1];
    dm_joint joints[WORLD_MAX_PARTS + 1];
} poses;

void poses_open(poses* poses, FILE* file);

/* Every part's pose goes into the hash; those that changed since the last frame are written, in hexadecimal floats,
 * and so are changes of a joint. */
void poses_frame(poses* poses, const world* world, uint32_t frame);

#endif
