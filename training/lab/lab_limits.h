/* Declares the cases that the limits' networks are trained on. */
#ifndef DM_LAB_LIMITS_H
#define DM_LAB_LIMITS_H

#include "dragmesh_lab.h"

/* One entry a case. */
typedef struct dm_lab_limits {
    float* features;  /* x dm_lab_limits_columns(): of the joint's sweep */
    float* candidate; /* x dm_lab_limits_candidate_columns(): the candidate features of the same joint */
    float* lower;     /* in the features' unit (1 rad, or the part's extent along the slide) */
    float* upper;
    int32_t* free;     /* 1: continuous, the limits mean nothing */
    int32_t* category; /* id */
    float* pose;       /* pose error, object sizes */
    int32_t* has_drag;
} dm_lab_limits;

DM_API uint32_t dm_lab_limits_columns(void);
DM_API uint32_t dm_lab_limits_candidate_columns(void);
/* Fills the arrays. Weights as for the ranker. The joints are the candidates nearest to the true ones, signed as the
 * library signs them. */
DM_API dm_result dm_lab_limits_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                                     const void* prefilter, size_t prefilter_size, const dm_lab_limits* out);

#endif
