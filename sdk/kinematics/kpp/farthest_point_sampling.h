/* Farthest-point sampling: centres spread evenly over points, and the points nearest to each. */
#ifndef DMI_KPP_FARTHEST_POINT_SAMPLING_H
#define DMI_KPP_FARTHEST_POINT_SAMPLING_H

#include <stdint.h>

#define DMI_FPS_GROUP 16        /* points a group */
#define DMI_FPS_MAX_POINTS 1024 /* points altogether */
#define DMI_FPS_POINT_STEP 32   /* their number is a multiple of it */

/* Points, coordinates apart, and how far each is from the nearest centre so far, squared. */
typedef struct dmi_fps {
    const float *x, *y, *z; /* finite */
    uint32_t count;
    float cover[DMI_FPS_MAX_POINTS];
} dmi_fps;

void dmi_fps_begin(const float* x, const float* y, const float* z, uint32_t count, dmi_fps* out);
/* The group round a centre: itself, then by distance, ties by index. Answers the next centre: the point farthest from
 * all so far, the first of equals. */
uint32_t dmi_fps_next(dmi_fps* grouping, uint32_t centre, uint32_t out_members[DMI_FPS_GROUP]);

#endif
