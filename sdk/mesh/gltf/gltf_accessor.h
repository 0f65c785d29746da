/* Elements of accessors, checked against the bytes that are really there. */
#ifndef DMI_MESH_GLTF_ACCESSOR_H
#define DMI_MESH_GLTF_ACCESSOR_H

#include "base/env.h"
#include "mesh/gltf/gltf_tiny.h"

/* Elements of an accessor, every byte of which was checked to lie in its buffer. */
typedef struct dmi_gltf_elements {
    const uint8_t* data; /* NULL: all zeros */
    uint64_t stride, count;
    int32_t component_type, components, normalized;
    const uint8_t *changed, *changes; /* sparse: which elements, and what they are instead */
    uint64_t change_count, changed_size, change_stride;
    int32_t changed_type;
} dmi_gltf_elements;

dm_result dmi_gltf_find_elements(dmi_env* env, const dmi_tiny* tiny, int32_t accessor, const char* place,
                                 dmi_gltf_elements* out);
/* Component `component` of element `i`, sparse changes apart. */
double dmi_gltf_element(const dmi_gltf_elements* elements, uint64_t i, int component);
/* The element that sparse change `i` is about, and its component. */
uint64_t dmi_gltf_changed(const dmi_gltf_elements* elements, uint64_t i);
double dmi_gltf_change(const dmi_gltf_elements* elements, uint64_t i, int component);

#endif
