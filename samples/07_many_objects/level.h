/* The level as its designer left it: where each prop stands and of which kind it is. And what the player has changed.
 */
#ifndef SAMPLE_LEVEL_H
#define SAMPLE_LEVEL_H

#include <stdbool.h>

#include "dragmesh/dragmesh.h"

enum {
    COLUMNS = 24,       /* props in a row across the street */
    DISTRICT_ROWS = 10, /* neighbours share kinds; each district has its own */
    DISTRICT_KINDS = 8,
    MOST_KEPT = 4096 /* parts that stand otherwise than the designer left them */
};
#define PITCH 2.4f  /* m from prop to prop */
#define STREET 2.6f /* m from the middle of the street to the first props */

typedef struct prop {
    uint32_t kind;
    float x, z;        /* m, on the ground */
    dm_pose place;     /* once it has been placed */
    uint32_t instance; /* of the scene, while it is placed */
    bool placed;
} prop;

/* A part that the player has moved: what a saved game holds of it. It outlives the instance. */
typedef struct kept_part {
    uint32_t prop, part;
    dm_part_state state;
} kept_part;

typedef struct level {
    prop* props;
    uint32_t prop_count, row_count, kind_count;
    kept_part* kept;
    uint32_t kept_count;
} level;

/* Returns false when there is no memory. */
bool level_make(level* level, uint32_t props, uint32_t kinds);
void level_free(level* level);
float level_length(const level* level);
/* What is kept of a part; NULL: it stands as at rest. */
const kept_part* level_kept(const level* level, uint32_t prop, uint32_t part);
/* Keeps the state of a part in place of an earlier one. */
void level_keep(level* level, uint32_t prop, uint32_t part, const dm_part_state* state);
/* Where a prop stands that reaches down to `bottom` in its own frame; it faces the street. */
dm_pose level_place(const prop* prop, float bottom);

#endif
