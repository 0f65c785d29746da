/* dm_vec3 to and from the float[3] that the rooms compute with: f(dmi_xyz(p).v), q = dmi_vec3(v). */
#ifndef DMI_MATH_VEC3_H
#define DMI_MATH_VEC3_H

#include "dragmesh/dragmesh.h"

/* By value: &p.x is the address of one float, and compilers warn when three are read through it. */
typedef struct dmi_float3 {
    float v[3];
} dmi_float3;

static inline dmi_float3 dmi_xyz(dm_vec3 p) {
    return (dmi_float3){{p.x, p.y, p.z}};
}

static inline dm_vec3 dmi_vec3(const float v[3]) {
    return (dm_vec3){v[0], v[1], v[2]};
}

#endif
