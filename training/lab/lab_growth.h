/* What the part finder's growing is fitted on: pieces that touch a growing part, and whether they belong to it. */
#ifndef DM_LAB_GROWTH_H
#define DM_LAB_GROWTH_H

#include "dragmesh_lab.h"

typedef struct dm_lab_growth {
    uint32_t capacity;
    float* features; /* x capacity x dm_lab_growth_columns() */
    float* belongs;  /* x capacity: 0 or 1 */
    float* weight;   /* x capacity: 1 over the pieces that touched at that step */
    int32_t* category;
    uint32_t* count; /* rows written; the batch ends early when the next case might not fit */
} dm_lab_growth;

DM_API uint32_t dm_lab_growth_columns(void);
/* Of each case a part grows twice, from a random piece of its own, taking random pieces that belong to it. */
DM_API dm_result dm_lab_growth_batch(const dm_lab_options* options, const dm_lab_growth* out);

#endif
