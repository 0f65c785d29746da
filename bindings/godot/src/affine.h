/* Transforms in double precision, laid out as Godot's Transform3D: a row-major 3x3 matrix, then the origin. */
#ifndef DRAGMESH_GODOT_AFFINE_H
#define DRAGMESH_GODOT_AFFINE_H

#include "dragmesh/dragmesh.h"

typedef struct affine {
    double m[12];
} affine;

affine affine_identity(void);
/* x -> a(b(x)) */
affine affine_after(const affine* a, const affine* b);
/* Of one that has an inverse. */
affine affine_inverse(const affine* a);
affine affine_of_pose(const dm_pose* pose);
dm_vec3 affine_point(const affine* a, const double p[3]);
dm_vec3 affine_vector(const affine* a, const double v[3]);

#endif
