/* A log of poses, for comparing two runs bit by bit. */
#ifndef VIEWER_POSES_H
#define VIEWER_POSES_H

#include "../common/output_file.h"

#include "world.h"

typedef struct poses {
    output_file* file; /* may be NULL: only the hash is kept */
    uint64_t hash;
    dm_pose last[WORLD_MAX_PARTS + 1];
    dm_joint joints[WORLD_MAX_PARTS + 1];
} poses;

void poses_open(poses* poses, output_file* file);

/* Adds every part's pose to the hash, and writes those that changed since the last frame in hexadecimal floats, and
 * changes of a joint. */
void poses_frame(poses* poses, const world* world, uint32_t frame);

#endif
