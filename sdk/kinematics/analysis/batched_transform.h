/* Points of a part moved along a joint, many at a time, and their distances from the body. */
#ifndef DMI_ANALYSIS_BATCHED_TRANSFORM_H
#define DMI_ANALYSIS_BATCHED_TRANSFORM_H

#include "kinematics/analysis/distance_grid.h"

/* A moved point is x = base + cosine * radial + sine * tangent + shift * axis. Prismatic joints have radial and tangent
 * 0. Coordinates are separated, object-normalised. */
typedef struct dmi_batched_transform {
    float axis[3];
    float base[3][DMI_POINT_BATCH], radial[3][DMI_POINT_BATCH], tangent[3][DMI_POINT_BATCH];
    uint32_t count;
} dmi_batched_transform;

#define DMI_TRANSFORM_BATCH 8 /* points that the widest code moves at a time; other counts take the slow way */

/* Returns a count rounded up to whole batches. */
static inline uint32_t dmi_whole_batches(uint32_t count) {
    return (count + DMI_TRANSFORM_BATCH - 1) / DMI_TRANSFORM_BATCH * DMI_TRANSFORM_BATCH;
}

#define DMI_TOUCH_CELLS 2.1f /* cells of a grid: a point that is nearer to its samples touches them; by hand */

/* Copies the points so that those that do not touch the grid's samples come first. Returns how many do not. */
uint32_t dmi_put_free_points_first(const dmi_distance_grid* grid, const float (*points)[3], uint32_t count,
                                   float (*out)[3]);

/* Decompose the points about the axis (unit). count <= DMI_POINT_BATCH. */
void dmi_batched_transform_revolute(const float axis[3], const float origin[3], const float (*points)[3],
                                    uint32_t count, dmi_batched_transform* out);
void dmi_batched_transform_prismatic(const float axis[3], const float (*points)[3], uint32_t count,
                                     dmi_batched_transform* out);

/* Computes the distances of the moved points from the grid's samples at the angle with this cosine and sine, shifted
 * along the axis. */
void dmi_batched_transform_distances(const dmi_batched_transform* transform, float cosine, float sine, float shift,
                                     const dmi_distance_grid* grid, float out[DMI_POINT_BATCH]);

/* Computes which of the moved points lie in a cell that holds a sample: 1, otherwise 0. */
void dmi_batched_transform_meetings(const dmi_batched_transform* transform, float cosine, float sine, float shift,
                                    const dmi_distance_grid* grid, int32_t out[DMI_POINT_BATCH]);

#endif
