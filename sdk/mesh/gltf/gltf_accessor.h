/* Elements of accessors, checked against the bytes that are really there. */
#ifndef DMI_MESH_GLTF_ACCESSOR_H
#define DMI_MESH_GLTF_ACCESSOR_H

#include "mesh/gltf/gltf_file.h"

/* Elements of an accessor, every byte of which was checked to lie in its buffer. */
typedef struct dmi_gltf_elements {
    const uint8_t* data; /* NULL: all zeros */
    uint64_t stride, count;
    int32_t component_type, components, normalized;
    const uint8_t *changed, *changes; /* sparse: which elements, and what they are instead */
    uint64_t change_count, changed_size, change_stride;
    int32_t changed_type;
} dmi_gltf_elements;

dm_result dmi_gltf_find_elements(dm_gltf* gltf, double accessor, const char* place, dmi_gltf_problem* problem,
                                 dmi_gltf_elements* out);
/* Bytes of a component; 0: no component type. */
uint32_t dmi_gltf_component_size(int32_t type);
/* Reads componentType of an accessor, or of sparse indices; BAD_DATA for what is no whole number. */
dm_result dmi_gltf_read_type(const cJSON* json, const char* place, dmi_gltf_problem* problem, int32_t* out);
/* Components of "SCALAR", "VEC3" …; 0: no type. */
int32_t dmi_gltf_components(const char* type);
/* Component `component` of element `i`, sparse changes apart. */
double dmi_gltf_element(const dmi_gltf_elements* elements, uint64_t i, int component);
/* The element that sparse change `i` is about, and its component. */
uint64_t dmi_gltf_changed(const dmi_gltf_elements* elements, uint64_t i);
double dmi_gltf_change(const dmi_gltf_elements* elements, uint64_t i, int component);
/* The same with sparse changes. */
double dmi_gltf_value(const dmi_gltf_elements* elements, uint64_t i, int component);
/* Position of the sparse change of an element; change_count: it has none. Changes are sorted, as glTF demands; where
 * they are not, or one comes twice, any or the first counts. */
uint64_t dmi_gltf_find_change(const dmi_gltf_elements* elements, uint64_t element);
/* All elements of an accessor of one unsigned integer each, changes included. */
void dmi_gltf_read_indices(const dmi_gltf_elements* elements, uint32_t* out);

#endif
