/* Bounding rectangles and boxes of point sets, along axes that are chosen for least area or volume. */
#ifndef DMI_ANALYSIS_BOUNDING_BOX_H
#define DMI_ANALYSIS_BOUNDING_BOX_H

#include <stdint.h>

#define DMI_MAX_HULL_POINTS 512 /* points that a rectangle or box is computed from; by hand */

/* A box with its own axes. */
typedef struct dmi_box {
    float axes[3][3];      /* unit rows, longest side first, right-handed */
    float low[3], high[3]; /* coordinates along the axes */
} dmi_box;

typedef struct dmi_rectangle {
    float axes[2][3];
    float low[2], high[2]; /* coordinates along the axes */
} dmi_rectangle;

void dmi_box_centre(const dmi_box* box, float out[3]);
/* Returns the place of a point along an axis of the box: -1 and 1 at its ends. */
float dmi_box_place(const dmi_box* box, int axis, const float point[3]);
/* Computes the box of least volume with one axis among the unit `directions`. count <= DMI_MAX_HULL_POINTS. */
void dmi_min_volume_box(const float (*points)[3], uint32_t count, const float (*directions)[3],
                        uint32_t direction_count, dmi_box* out);
/* Computes the rectangle of least area round the points projected along the unit `direction`. Its axes are unit and
 * perpendicular to the direction. count <= DMI_MAX_HULL_POINTS. */
void dmi_min_area_rectangle(const float (*points)[3], uint32_t count, const float direction[3], dmi_rectangle* out);
/* Computes the least and greatest coordinate of the points along each axis. */
void dmi_extents_along(const float (*points)[3], uint32_t count, const float axes[][3], uint32_t axis_count,
                       float* out_low, float* out_high);

#endif
