/* What the viewer computes with beside vectors.h: poses. Matrices are cglm's. */
#ifndef VIEWER_VEC_H
#define VIEWER_VEC_H

#include <math.h>

#include "../common/vectors.h"
#include "cglm/scalar_camera.h"

/* Any unit vector at right angles to a unit vector. */
static inline dm_vec3 perpendicular(dm_vec3 a) {
    return unit(cross(a, fabsf(a.x) < 0.6f ? vec(1, 0, 0) : vec(0, 1, 0)));
}

static const dm_pose pose_identity = {{0, 0, 0, 1}, {0, 0, 0, 0}};

/* The inverse of a unit dual quaternion is its conjugate. */
static inline dm_pose pose_inverse(const dm_pose* p) {
    return (dm_pose){{-p->real[0], -p->real[1], -p->real[2], p->real[3]},
                     {-p->dual[0], -p->dual[1], -p->dual[2], p->dual[3]}};
}

static inline dm_vec3 pose_direction(const dm_pose* pose, dm_vec3 d) {
    return sub(pose_point(pose, d), pose_point(pose, vec(0, 0, 0)));
}

#endif
