/* Sample points of a part, carried along a joint many at a time. */
#ifndef DMI_ANALYSIS_BATCHED_TRANSFORM_H
#define DMI_ANALYSIS_BATCHED_TRANSFORM_H

#include "kinematics/analysis/distance_grid.h"

/* x = base + cosine * across + sine * beside + shift * axis; a slide has no across and no beside. */
typedef struct dmi_batched_transform {
    float axis[3];
    float base[3][DMI_POINT_BATCH], across[3][DMI_POINT_BATCH], beside[3][DMI_POINT_BATCH];
    uint32_t count;
} dmi_batched_transform;

/* count: at most DMI_POINT_BATCH. */
void dmi_batched_transform_revolute(const float axis[3], const float origin[3], const float (*points)[3],
                                    uint32_t count, dmi_batched_transform* out);
void dmi_batched_transform_prismatic(const float axis[3], const float (*points)[3], uint32_t count,
                                     dmi_batched_transform* out);

/* How far the points are from the field's samples at a place of the joint. */
void dmi_batched_transform_distances(const dmi_batched_transform* moved, float cosine, float sine, float shift,
                                     const dmi_distance_grid* field, float out[DMI_POINT_BATCH]);

#endif
