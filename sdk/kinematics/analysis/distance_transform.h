/* Exact Euclidean distance transform of a grid of occupied cells. */
#ifndef DMI_ANALYSIS_DISTANCE_TRANSFORM_H
#define DMI_ANALYSIS_DISTANCE_TRANSFORM_H

#include "kinematics/analysis/distance_grid.h"

#define DMI_TRANSFORM_LANES 16 /* lines at a time; square, in_row and in_slab have so many elements to spare */

/* Computes in_row, in_slab and square from the grid's size, cell and start. */
void dmi_distance_transform(dmi_distance_grid* grid);

#endif
