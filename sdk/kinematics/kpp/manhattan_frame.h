/* Manhattan frame (Straub et al. 2014): the three perpendicular directions that most surface normals are parallel to.
 * Joint axes of manufactured objects are mostly parallel to one of them. */
#ifndef DMI_KPP_MANHATTAN_FRAME_H
#define DMI_KPP_MANHATTAN_FRAME_H

#include <stdint.h>

/* Unit normals in one block or two. */
typedef struct dmi_normals {
    const float (*first)[3];
    uint32_t first_count;
    const float (*second)[3];
    uint32_t second_count;
} dmi_normals;

/* Computes a start for the fit: the eigenvectors (rows) of the sum of n n^T over the normals, largest eigenvalue first.
 */
void dmi_manhattan_frame_guess(const dmi_normals* normals, float out_axes[3][3]);

/* Rotates the perpendicular unit rows `axes` to fit the normals near them. Returns the share of normals within 8
 * degrees of an axis, 0 .. 1. */
float dmi_manhattan_frame_fit(const dmi_normals* normals, float axes[3][3]);

#endif
