/* Slippage analysis (Gelfand and Guibas 2004): rigid motions under which a surface slides along itself. */
#ifndef DMI_ANALYSIS_SLIPPAGE_H
#define DMI_ANALYSIS_SLIPPAGE_H

#include <stdint.h>

/* The two best rotations and translations. A residual is the root mean square normal speed of the surface for an
 * angular velocity of 1, in root mean square radii, or a linear velocity of 1; 0: a perfect bearing or rail. */
typedef struct dmi_slippage {
    float turn_axis[2][3], turn_point[2][3], turn_residual[2];
    float slide[2][3], slide_residual[2];
} dmi_slippage;

/* weights: of the samples; NULL: all equal. */
void dmi_slippage_compute(const float (*points)[3], const float (*normals)[3], const float* weights, uint32_t count,
                          dmi_slippage* out);

#endif
