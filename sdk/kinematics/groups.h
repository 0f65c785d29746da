/* Farthest-point sampling: centres spread evenly over points, and the points nearest to each. */
#ifndef DMI_KINEMATICS_GROUPS_H
#define DMI_KINEMATICS_GROUPS_H

#include <stdint.h>

#define DMI_GROUP 16         /* points a group */
#define DMI_GROUPED_MAX 1024 /* points altogether */
#define DMI_GROUPED_STEP 32  /* their number is a multiple of it */

/* Points, coordinates apart, and how far each is from the nearest centre so far, squared. */
typedef struct dmi_grouping {
    const float *x, *y, *z; /* finite */
    uint32_t count;
    float cover[DMI_GROUPED_MAX];
} dmi_grouping;

void dmi_grouping_begin(const float* x, const float* y, const float* z, uint32_t count, dmi_grouping* out);
/* The group round a centre: itself, then by distance, ties by index. Answers the next centre: the point farthest from
 * all so far, the first of equals. */
uint32_t dmi_grouping_next(dmi_grouping* grouping, uint32_t centre, uint32_t out_members[DMI_GROUP]);

#endif
