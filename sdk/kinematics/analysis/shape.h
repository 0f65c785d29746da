/* Shape analysis of point sets: boxes, clusters of normals, and the motions under which a surface slides on itself. */
#ifndef DMI_ANALYSIS_SHAPE_H
#define DMI_ANALYSIS_SHAPE_H

#include <stdint.h>

/* A box with its own axes. */
typedef struct dmi_box {
    float axes[3][3];      /* rows, unit, longest side first */
    float low[3], high[3]; /* along the axes */
} dmi_box;

void dmi_box_centre(const dmi_box* box, float out[3]);

/* Smallest rectangle (by area) round points seen along `direction`: two unit vectors across it and the limits along
 * them. Works on the points' convex hull; count at most DMI_SHAPE_MAX_HULL. */
#define DMI_SHAPE_MAX_HULL 512
typedef struct dmi_rectangle {
    float axes[2][3];
    float low[2], high[2];
} dmi_rectangle;
void dmi_shape_rectangle(const float (*points)[3], uint32_t count, const float direction[3], dmi_rectangle* out);
/* Limits of the points along given axes. */
void dmi_shape_limits(const float (*points)[3], uint32_t count, const float axes[][3], uint32_t axis_count,
                      float* out_low, float* out_high);

/* The box of least volume with one axis among `directions`. */
void dmi_shape_box(const float (*points)[3], uint32_t count, const float (*directions)[3], uint32_t direction_count,
                   dmi_box* out);

/* Points of the set that are farthest in some direction, out of a fixed fan and `extra` directions: its convex hull but
 * for rounded corners. Answers how many (at most DMI_SHAPE_MAX_HULL). */
uint32_t dmi_shape_extremes(const float (*points)[3], uint32_t count, const float (*extra)[3], uint32_t extra_count,
                            float (*out)[3]);

/* Unsigned directions that many of the unit normals share, most frequent first; `share` is theirs of all. */
typedef struct dmi_normal_cluster {
    float direction[3];
    float share;
} dmi_normal_cluster;
uint32_t dmi_shape_normal_clusters(const float (*normals)[3], uint32_t count, uint32_t most, dmi_normal_cluster* out);

/* Slippage (Gelfand and Guibas 2004): motions with the least mean normal velocity of a sampled surface. The residual is
 * that velocity's root mean square over a unit mean speed: 0 for a perfect bearing or rail. */
typedef struct dmi_slippage {
    float turn_axis[2][3], turn_point[2][3], turn_residual[2];
    float slide[2][3], slide_residual[2];
} dmi_slippage;
void dmi_shape_slippage(const float (*points)[3], const float (*normals)[3], const float* weights, uint32_t count,
                        dmi_slippage* out);

#endif
