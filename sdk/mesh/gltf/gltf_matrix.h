/* Transforms of nodes: affine matrices, column-major, and unit quaternions x, y, z, w. */
#ifndef DMI_MESH_GLTF_MATRIX_H
#define DMI_MESH_GLTF_MATRIX_H

#include <stdbool.h>

enum { DMI_GLTF_COLUMN = 4, DMI_GLTF_ORIGIN = 12 }; /* in a matrix: between columns; of the translation */

void dmi_gltf_multiply(const double a[16], const double b[16], double out[16]);
/* The matrix that scales, turns, then moves. rotation: of unit length. */
void dmi_gltf_compose(const double translation[3], const double rotation[4], const double scale[3], double out[16]);
/* Of the matrix without its translation; below 0: it mirrors. */
double dmi_gltf_determinant(const double m[16]);
/* Returns false where the matrix has no inverse. */
bool dmi_gltf_invert(const double m[16], double out[16]);
/* Writes where a direction comes to. */
void dmi_gltf_turn(const double m[16], const double v[3], double out[3]);
double dmi_gltf_length(const double v[3]);
/* Makes the columns unit and right-angled, one after the other. Returns by how much they were off; 1 where they span no
 * space, or mirror. */
double dmi_gltf_straighten(double m[16]);
/* Writes the rotation of a matrix with unit columns at right angles that does not mirror. */
void dmi_gltf_to_quaternion(const double m[16], double q[4]);
/* Makes a quaternion unit; zeros become that of no turn. */
void dmi_gltf_normalize(double q[4]);

#endif
