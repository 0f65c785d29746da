/* Accessors of a file that nobody vouches for: every offset, stride and count is checked against the buffer's real size
 * before a byte is read. */
#include <inttypes.h>
#include <string.h>

#include "mesh/gltf/gltf_accessor.h"

static uint64_t component_size(int32_t type) {
    switch (type) {
    case DMI_TINY_BYTE:
    case DMI_TINY_UBYTE:
        return 1;
    case DMI_TINY_SHORT:
    case DMI_TINY_USHORT:
        return 2;
    case DMI_TINY_UINT:
    case DMI_TINY_FLOAT:
        return 4;
    default:
        return 0;
    }
}

/* count elements of `element` bytes, `stride` apart from `offset` on, lie within `size` bytes. */
static int fits(uint64_t offset, uint64_t count, uint64_t element, uint64_t stride, uint64_t size) {
    if (count == 0) return 1;
    if (element > size || offset > size - element) return 0;
    return (count - 1) <= (size - element - offset) / stride;
}

/* The elements' first byte in `out_data`, their distance in `out_stride`. */
static dm_result find_range(dmi_env* env, const dmi_tiny* tiny, int32_t index, uint64_t offset, uint64_t count,
                            uint64_t element, const char* place, const uint8_t** out_data, uint64_t* out_stride) {
    dmi_tiny_view view;
    if (!dmi_tiny_get_view(tiny, index, &view))
        return dmi_fail(env, DM_ERROR_BAD_DATA, "%s: buffer view %d, or its buffer, does not exist", place, index);
    if (view.offset > view.buffer_size || view.size > view.buffer_size - view.offset)
        return dmi_fail(env, DM_ERROR_BAD_DATA,
                        "%s: buffer view %d, bytes %" PRIu64 " + %" PRIu64 ", leaves its buffer of %" PRIu64, place,
                        index, view.offset, view.size, view.buffer_size);
    const uint64_t stride = view.stride ? view.stride : element;
    if (!fits(offset, count, element, stride, view.size))
        return dmi_fail(env, DM_ERROR_BAD_DATA,
                        "%s: %" PRIu64 " elements of %" PRIu64 " bytes from byte %" PRIu64
                        " on leave buffer view %d of %" PRIu64 " bytes",
                        place, count, element, offset, index, view.size);
    *out_data = view.buffer + view.offset + offset;
    *out_stride = stride;
    return DM_OK;
}

static dm_result find_changes(dmi_env* env, const dmi_tiny* tiny, const dmi_tiny_accessor* accessor, uint64_t element,
                              const char* place, dmi_gltf_elements* out) {
    const uint64_t index_size = component_size(accessor->index_type);
    if (accessor->sparse_count > accessor->count)
        return dmi_fail(env, DM_ERROR_BAD_DATA, "%s: %" PRIu64 " sparse elements of %" PRIu64, place,
                        accessor->sparse_count, accessor->count);
    if (accessor->index_type != DMI_TINY_UBYTE && accessor->index_type != DMI_TINY_USHORT &&
        accessor->index_type != DMI_TINY_UINT)
        return dmi_fail(env, DM_ERROR_BAD_DATA, "%s: sparse indices of component type %d", place, accessor->index_type);
    out->change_count = accessor->sparse_count;
    out->changed_type = accessor->index_type;
    dm_result result = find_range(env, tiny, accessor->index_view, accessor->index_offset, out->change_count,
                                  index_size, place, &out->changed, &out->changed_size);
    if (result != DM_OK) return result;
    result = find_range(env, tiny, accessor->value_view, accessor->value_offset, out->change_count, element, place,
                        &out->changes, &out->change_stride);
    if (result != DM_OK) return result;
    for (uint64_t i = 0; i < out->change_count; i++) {
        if (dmi_gltf_changed(out, i) >= out->count)
            return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE, "%s: sparse index %" PRIu64 " of %" PRIu64 " elements",
                            place, dmi_gltf_changed(out, i), out->count);
    }
    return DM_OK;
}

dm_result dmi_gltf_find_elements(dmi_env* env, const dmi_tiny* tiny, int32_t index, const char* place,
                                 dmi_gltf_elements* out) {
    dmi_tiny_accessor accessor;
    if (!dmi_tiny_get_accessor(tiny, index, &accessor))
        return dmi_fail(env, DM_ERROR_BAD_DATA, "%s: accessor %d does not exist", place, index);
    const uint64_t size = component_size(accessor.component_type);
    if (size == 0 || accessor.components <= 0)
        return dmi_fail(env, DM_ERROR_BAD_DATA, "%s: accessor %d has component type %d", place, index,
                        accessor.component_type);
    if (accessor.count > DM_MAX_ELEMENTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "%s: accessor %d counts %" PRIu64 " elements, %d is the most", place,
                        index, accessor.count, DM_MAX_ELEMENTS);
    const uint64_t element = size * (uint64_t)accessor.components;
    *out = (dmi_gltf_elements){.count = accessor.count,
                               .component_type = accessor.component_type,
                               .components = accessor.components,
                               .normalized = accessor.normalized};
    if (accessor.view >= 0) {
        const dm_result result = find_range(env, tiny, accessor.view, accessor.offset, accessor.count, element, place,
                                            &out->data, &out->stride);
        if (result != DM_OK) return result;
    } else if (!accessor.sparse) {
        return dmi_fail(env, DM_ERROR_BAD_DATA, "%s: accessor %d has no data", place, index);
    }
    return accessor.sparse ? find_changes(env, tiny, &accessor, element, place, out) : DM_OK;
}

/* Integers in the file are little-endian. */
static double read_component(const uint8_t* bytes, int32_t type, int32_t normalized) {
    const uint16_t u16 = (uint16_t)(bytes[0] | (type == DMI_TINY_BYTE || type == DMI_TINY_UBYTE ? 0 : bytes[1] << 8));
    switch (type) {
    case DMI_TINY_UBYTE:
        return normalized ? bytes[0] / 255.0 : bytes[0];
    case DMI_TINY_BYTE: {
        const double value = (int8_t)bytes[0];
        return !normalized ? value : value < -127 ? -1 : value / 127;
    }
    case DMI_TINY_USHORT:
        return normalized ? u16 / 65535.0 : u16;
    case DMI_TINY_SHORT: {
        const double value = (int16_t)u16;
        return !normalized ? value : value < -32767 ? -1 : value / 32767;
    }
    default:
        break;
    }
    const uint32_t u32 = (uint32_t)u16 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
    if (type == DMI_TINY_UINT) return u32;
    float value;
    memcpy(&value, &u32, sizeof value);
    return (double)value;
}

static double read_at(const dmi_gltf_elements* elements, const uint8_t* element, int component) {
    return read_component(element + component_size(elements->component_type) * (uint64_t)component,
                          elements->component_type, elements->normalized);
}

double dmi_gltf_element(const dmi_gltf_elements* elements, uint64_t i, int component) {
    return elements->data ? read_at(elements, elements->data + i * elements->stride, component) : 0;
}

uint64_t dmi_gltf_changed(const dmi_gltf_elements* elements, uint64_t i) {
    return (uint64_t)read_component(elements->changed + i * elements->changed_size, elements->changed_type, 0);
}

double dmi_gltf_change(const dmi_gltf_elements* elements, uint64_t i, int component) {
    return read_at(elements, elements->changes + i * elements->change_stride, component);
}
