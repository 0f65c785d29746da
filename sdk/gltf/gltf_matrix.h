/* Transforms of nodes: affine matrices, column-major, and unit quaternions x, y, z, w. */
#ifndef DMI_GLTF_MATRIX_H
#define DMI_GLTF_MATRIX_H

#include <stdbool.h>

/* Numbers of a matrix from one column to the next; first number of the translation. */
enum { DMI_GLTF_COLUMN = 4, DMI_GLTF_ORIGIN = 12 };

void dmi_gltf_multiply(const double a[16], const double b[16], double out[16]);
/* Writes the matrix that scales, turns, then moves. rotation: of unit length. */
void dmi_gltf_compose(const double translation[3], const double rotation[4], const double scale[3], double out[16]);
/* Returns the determinant of the matrix without its translation. It is below 0 when the matrix mirrors. */
double dmi_gltf_determinant(const double m[16]);
/* Inverts a matrix. Returns false where it has no inverse. */
bool dmi_gltf_invert(const double m[16], double out[16]);
/* Writes a direction as the matrix turns it. */
void dmi_gltf_turn(const double m[16], const double v[3], double out[3]);
double dmi_gltf_length(const double v[3]);
/* Makes the columns unit and right-angled, one after the other. Returns by how much they were off, or 1 where they span
 * no space, or mirror. */
double dmi_gltf_straighten(double m[16]);
/* Writes the rotation of a matrix with unit columns at right angles that does not mirror. */
void dmi_gltf_to_quaternion(const double m[16], double q[4]);
/* Makes a quaternion unit. Zeros become the identity. */
void dmi_gltf_normalize(double q[4]);

#endif
