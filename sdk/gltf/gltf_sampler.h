/* Animation samplers (glTF 2.0 §3.11). */
#ifndef DMI_GLTF_SAMPLER_H
#define DMI_GLTF_SAMPLER_H

#include "gltf/gltf_accessor.h"

typedef enum dmi_gltf_interpolation { DMI_GLTF_LINEAR, DMI_GLTF_STEP, DMI_GLTF_CUBIC } dmi_gltf_interpolation;

/* Keys of one property of one node. */
typedef struct dmi_gltf_sampler {
    dmi_gltf_elements times, values;
    dmi_gltf_interpolation interpolation;
    int components; /* 3, or 4 for a rotation */
} dmi_gltf_sampler;

/* Reads a sampler for values of `components` numbers. Times rise and all numbers are finite then. */
dm_result dmi_gltf_read_sampler(dm_gltf* gltf, const cJSON* json, int components, const char* place,
                                dmi_gltf_problem* problem, dmi_gltf_sampler* out);
double dmi_gltf_sample_time(const dmi_gltf_sampler* sampler, uint64_t key);
/* Writes the value at a time. Before the first key and after the last one, it is the value of that key. Rotations are
 * unit quaternions. */
void dmi_gltf_sample(const dmi_gltf_sampler* sampler, double time, double out[4]);

#endif
