/* Elements of accessors, checked against the bytes that are really there, and the samplers of animations that they
 * make up (gltf_sampler.c). */
#ifndef DMI_GLTF_ACCESSOR_H
#define DMI_GLTF_ACCESSOR_H

#include "gltf/gltf_file.h"

/* Elements of an accessor, every byte of which was checked to lie in its buffer. */
typedef struct dmi_gltf_elements {
    const uint8_t* data; /* NULL: all are zeros */
    uint64_t stride, count;
    int32_t component_type, components, normalized;
    const uint8_t *changed, *changes; /* sparse changes: which elements change, and their new values */
    uint64_t change_count, changed_size, change_stride;
    int32_t changed_type;
} dmi_gltf_elements;

dm_result dmi_gltf_find_elements(dm_gltf* gltf, double accessor, const char* place, dmi_gltf_problem* problem,
                                 dmi_gltf_elements* out);
/* Returns the bytes of a component, or 0 when the type is none. */
uint32_t dmi_gltf_component_size(int32_t type);
/* Reads componentType of an accessor, or of sparse indices. Answers BAD_DATA for what is no whole number. */
dm_result dmi_gltf_read_type(const cJSON* json, const char* place, dmi_gltf_problem* problem, int32_t* out);
/* Returns the components of "SCALAR", "VEC3" …, or 0 when the type is none. */
int32_t dmi_gltf_components(const char* type);
/* Returns component `component` of element `i`, without sparse changes. */
double dmi_gltf_element(const dmi_gltf_elements* elements, uint64_t i, int component);
/* Returns the element that sparse change `i` replaces. */
uint64_t dmi_gltf_changed(const dmi_gltf_elements* elements, uint64_t i);
double dmi_gltf_change(const dmi_gltf_elements* elements, uint64_t i, int component);
/* Returns component `component` of element `i`, with sparse changes. */
double dmi_gltf_value(const dmi_gltf_elements* elements, uint64_t i, int component);
/* Returns the position of the sparse change of an element, or change_count when it has none. Changes are sorted, as
 * glTF demands. Where they are not, or one comes twice, the answer is any of them or the first. */
uint64_t dmi_gltf_find_change(const dmi_gltf_elements* elements, uint64_t element);
/* Writes all elements of an accessor of one unsigned integer each, changes included. */
void dmi_gltf_read_indices(const dmi_gltf_elements* elements, uint32_t* out);

/* ---- animation samplers (glTF 2.0 §3.11) ---- */

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
