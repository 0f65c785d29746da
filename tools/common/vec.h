/* Vectors of three doubles, for metrics and pictures. */
#ifndef CLI_VEC_H
#define CLI_VEC_H

#include <math.h>

#include "constants.h"
#include "dragmesh/dragmesh.h"

typedef struct vec {
    double x, y, z;
} vec;

static inline vec vec_of(dm_vec3 a) {
    return (vec){(double)a.x, (double)a.y, (double)a.z};
}
static inline vec vec_at(const float* a) {
    return (vec){(double)a[0], (double)a[1], (double)a[2]};
}
static inline dm_vec3 vec_out(vec a) {
    return (dm_vec3){(float)a.x, (float)a.y, (float)a.z};
}
static inline vec add(vec a, vec b) {
    return (vec){a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline vec sub(vec a, vec b) {
    return (vec){a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline vec scale(vec a, double s) {
    return (vec){a.x * s, a.y * s, a.z * s};
}
static inline double dot(vec a, vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline vec cross(vec a, vec b) {
    return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double length(vec a) {
    return sqrt(dot(a, a));
}
static inline vec unit(vec a) {
    const double l = length(a);
    return l > 0 ? scale(a, 1 / l) : a;
}
/* Rotates x by `angle` (rad) about a unit axis through the origin (Rodrigues' formula). */
static inline vec turn(vec x, vec axis, double angle) {
    const double c = cos(angle), s = sin(angle);
    return add(add(scale(x, c), scale(cross(axis, x), s)), scale(axis, dot(axis, x) * (1 - c)));
}

#endif
