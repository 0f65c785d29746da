/* Farthest-point sampling: centres spread evenly over points, and the points nearest to each centre. */
#ifndef DMI_KPP_FARTHEST_POINT_SAMPLING_H
#define DMI_KPP_FARTHEST_POINT_SAMPLING_H

#include <stdint.h>

#define DMI_FPS_GROUP 16        /* points of a group (docs/networks.md) */
#define DMI_FPS_MAX_POINTS 1024 /* points altogether (docs/networks.md) */
#define DMI_FPS_POINT_STEP 32   /* divides the number of points: lanes of the distance loops */

/* Points, coordinates separated, and the squared distance of each from the nearest centre so far. */
typedef struct dmi_fps {
    const float *x, *y, *z; /* finite */
    uint32_t count;
    float min_square[DMI_FPS_MAX_POINTS];
} dmi_fps;

void dmi_fps_begin(const float* x, const float* y, const float* z, uint32_t count, dmi_fps* out);
/* Finds the group of a centre: itself, then its nearest points by distance, ties by index. Returns the next centre: the
 * point farthest from all centres so far, of equals the first. */
uint32_t dmi_fps_next(dmi_fps* sampling, uint32_t centre, uint32_t out_members[DMI_FPS_GROUP]);

#endif
