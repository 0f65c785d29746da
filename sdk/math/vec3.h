/* Conversions between the host's dm_vec3 and the float[3] or double[3] that the rooms compute with: f(dmi_xyz(p).v),
 * q = dmi_vec3(v). The only place for them. */
#ifndef DMI_MATH_VEC3_H
#define DMI_MATH_VEC3_H

#include "dragmesh/dragmesh.h"

/* An array by value: &p.x is the address of one float, and compilers warn when three are read through it. */
typedef struct dmi_float3 {
    float v[3];
} dmi_float3;

typedef struct dmi_double3 {
    double v[3];
} dmi_double3;

static inline dmi_float3 dmi_xyz(dm_vec3 p) {
    return (dmi_float3){{p.x, p.y, p.z}};
}

static inline dmi_double3 dmi_xyz_f64(dm_vec3 p) {
    return (dmi_double3){{(double)p.x, (double)p.y, (double)p.z}};
}

static inline dm_vec3 dmi_vec3(const float v[3]) {
    return (dm_vec3){v[0], v[1], v[2]};
}

static inline dm_vec3 dmi_vec3_f64(const double v[3]) {
    return (dm_vec3){(float)v[0], (float)v[1], (float)v[2]};
}

#endif
