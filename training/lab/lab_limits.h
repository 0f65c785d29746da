/* What the training of the limits' network sees. */
#ifndef DM_LAB_LIMITS_H
#define DM_LAB_LIMITS_H

#include "dragmesh_lab.h"

/* One entry a case. */
typedef struct dm_lab_limits {
    float* features; /* x dm_lab_limits_columns() */
    float* lower;    /* in the features' unit (1 rad, or the part's extent along the slide) */
    float* upper;
    int32_t* free; /* 1: continuous, the limits mean nothing */
    int32_t* category;
} dm_lab_limits;

DM_API uint32_t dm_lab_limits_columns(void);
/* kinematics: bytes of a KPP-Net weights file. The joints are the true ones. */
DM_API dm_result dm_lab_limits_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                                     const dm_lab_limits* out);

#endif
