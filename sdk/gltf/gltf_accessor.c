/* Reads accessors of a file that nobody vouches for. Every offset, stride and count is checked against the buffer's
 * real size before a byte is read. */
#include "gltf/gltf_accessor.h"

#include <inttypes.h>
#include <string.h>

#include "gltf/gltf_buffers.h"

uint32_t dmi_gltf_component_size(int32_t type) {
    switch (type) {
    case DMI_GLTF_BYTE:
    case DMI_GLTF_UBYTE:
        return 1;
    case DMI_GLTF_SHORT:
    case DMI_GLTF_USHORT:
        return 2;
    case DMI_GLTF_UINT:
    case DMI_GLTF_FLOAT:
        return 4;
    default:
        return 0;
    }
}

dm_result dmi_gltf_read_type(const cJSON* json, const char* place, dmi_gltf_problem* problem, int32_t* out) {
    uint64_t type = 0;
    const dm_result result = dmi_json_whole(json, "componentType", 0, INT32_MAX, place, problem, &type);
    *out = (int32_t)type;
    return result;
}

int32_t dmi_gltf_components(const char* type) {
    static const struct {
        const char* name;
        int32_t components;
    } types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    for (size_t i = 0; type && i < sizeof types / sizeof *types; i++) {
        if (strcmp(type, types[i].name) == 0) return types[i].components;
    }
    return 0;
}

/* Returns whether `count` elements of `element` bytes, `stride` apart from `offset` on, lie within `size` bytes. */
static int fits(uint64_t offset, uint64_t count, uint64_t element, uint64_t stride, uint64_t size) {
    if (count == 0) return 1;
    if (element > size || offset > size - element || stride == 0) return 0;
    return (count - 1) <= (size - element - offset) / stride;
}

/* Finds the elements of `json`, which names a view and an offset in it. */
static dm_result find_range(dm_gltf* gltf, const cJSON* json, uint64_t count, uint64_t element, const char* place,
                            dmi_gltf_problem* problem, const uint8_t** out_data, uint64_t* out_stride) {
    const double index = dmi_json_number(json, "bufferView", DMI_GLTF_NO_INDEX);
    dmi_gltf_view view;
    uint64_t offset;
    dm_result result = dmi_json_whole(json, "byteOffset", 0, UINT32_MAX, place, problem, &offset);
    if (result == DM_OK) result = dmi_gltf_find_view(gltf, index, place, problem, &view);
    if (result != DM_OK) return result;
    const uint64_t stride = view.stride ? view.stride : element;
    if (stride < element)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                               "%s: byteStride of buffer view %.17g is %" PRIu64 ", its elements have %" PRIu64
                               " bytes",
                               place, index, stride, element);
    if (!fits(offset, count, element, stride, view.size))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                               "%s: %" PRIu64 " elements of %" PRIu64 " bytes from byte %" PRIu64
                               " on leave buffer view %.17g of %" PRIu64 " bytes",
                               place, count, element, offset, index, view.size);
    *out_data = view.data + offset;
    *out_stride = stride;
    return DM_OK;
}

/* Returns whether sparse changes name elements that exist. It is asked once for an accessor, however many primitives
 * have it. */
static int changes_fit(dm_gltf* gltf, double accessor, const dmi_gltf_elements* elements) {
    enum { UNKNOWN, FIT, DO_NOT_FIT };
    uint8_t* known = &gltf->sparse_fit[dmi_gltf_position(&gltf->document, DMI_GLTF_ACCESSORS, accessor)];
    if (*known != UNKNOWN) return *known == FIT;
    *known = FIT;
    for (uint64_t i = 0; i < elements->change_count; i++) {
        if (dmi_gltf_changed(elements, i) >= elements->count) *known = DO_NOT_FIT;
    }
    return *known == FIT;
}

static dm_result find_changes(dm_gltf* gltf, double accessor, const cJSON* sparse, uint64_t element, const char* place,
                              dmi_gltf_problem* problem, dmi_gltf_elements* out) {
    const cJSON *indices = dmi_json_get(sparse, "indices"), *values = dmi_json_get(sparse, "values");
    int32_t type;
    dm_result result = dmi_gltf_read_type(indices, place, problem, &type);
    if (result == DM_OK)
        result = dmi_json_whole(sparse, "count", 0, (double)out->count, place, problem, &out->change_count);
    if (result != DM_OK) return result;
    if (type != DMI_GLTF_UBYTE && type != DMI_GLTF_USHORT && type != DMI_GLTF_UINT)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: sparse indices of component type %d", place, type);
    out->changed_type = type;
    result = find_range(gltf, indices, out->change_count, dmi_gltf_component_size(type), place, problem, &out->changed,
                        &out->changed_size);
    if (result == DM_OK)
        result =
            find_range(gltf, values, out->change_count, element, place, problem, &out->changes, &out->change_stride);
    if (result == DM_OK && !changes_fit(gltf, accessor, out))
        return dmi_gltf_refuse(problem, DM_ERROR_INDEX_OUT_OF_RANGE,
                               "%s: a sparse index of accessor %.17g is none of its %" PRIu64 " elements", place,
                               accessor, out->count);
    return result;
}

dm_result dmi_gltf_find_elements(dm_gltf* gltf, double index, const char* place, dmi_gltf_problem* problem,
                                 dmi_gltf_elements* out) {
    const cJSON* json = dmi_gltf_item(&gltf->document, DMI_GLTF_ACCESSORS, index);
    if (!cJSON_IsObject(json))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: accessor %.17g does not exist", place, index);
    *out = (dmi_gltf_elements){.components = dmi_gltf_components(dmi_json_text(json, "type")),
                               .normalized = cJSON_IsTrue(dmi_json_get(json, "normalized"))};
    dm_result result = dmi_gltf_read_type(json, place, problem, &out->component_type);
    const uint32_t size = dmi_gltf_component_size(out->component_type);
    if (result == DM_OK && (size == 0 || out->components == 0))
        result = dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: accessor %.17g has component type %d", place, index,
                                 out->component_type);
    if (result == DM_OK) result = dmi_json_whole(json, "count", 0, UINT32_MAX, place, problem, &out->count);
    if (result != DM_OK) return result;
    if (out->count > DM_MAX_ELEMENTS)
        return dmi_gltf_refuse(problem, DM_ERROR_TOO_LARGE,
                               "%s: accessor %.17g counts %" PRIu64 " elements, %d is the most", place, index,
                               out->count, DM_MAX_ELEMENTS);
    const uint64_t element = size * (uint64_t)out->components;
    const cJSON* sparse = dmi_json_get(json, "sparse");
    if (dmi_json_get(json, "bufferView"))
        result = find_range(gltf, json, out->count, element, place, problem, &out->data, &out->stride);
    else if (!sparse)
        result = dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: accessor %.17g has no data", place, index);
    return result == DM_OK && sparse ? find_changes(gltf, index, sparse, element, place, problem, out) : result;
}

/* Reads an integer, which is little-endian in the file. */
static uint32_t read_u32(const uint8_t* bytes) {
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static double read_component(const uint8_t* bytes, int32_t type, int32_t normalized) {
    const uint16_t u16 = (uint16_t)(bytes[0] | (type == DMI_GLTF_BYTE || type == DMI_GLTF_UBYTE ? 0 : bytes[1] << 8));
    switch (type) {
    case DMI_GLTF_UBYTE:
        return normalized ? bytes[0] / 255.0 : bytes[0];
    case DMI_GLTF_BYTE: {
        const double value = (int8_t)bytes[0];
        return !normalized ? value : value < -127 ? -1 : value / 127;
    }
    case DMI_GLTF_USHORT:
        return normalized ? u16 / 65535.0 : u16;
    case DMI_GLTF_SHORT: {
        const double value = (int16_t)u16;
        return !normalized ? value : value < -32767 ? -1 : value / 32767;
    }
    default:
        break;
    }
    const uint32_t u32 = (uint32_t)u16 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
    if (type == DMI_GLTF_UINT) return u32;
    float value;
    memcpy(&value, &u32, sizeof value);
    return (double)value;
}

static double read_at(const dmi_gltf_elements* elements, const uint8_t* element, int component) {
    return read_component(element + dmi_gltf_component_size(elements->component_type) * (uint64_t)component,
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

double dmi_gltf_value(const dmi_gltf_elements* elements, uint64_t i, int component) {
    const uint64_t change = dmi_gltf_find_change(elements, i);
    return change < elements->change_count ? dmi_gltf_change(elements, change, component)
                                           : dmi_gltf_element(elements, i, component);
}

uint64_t dmi_gltf_find_change(const dmi_gltf_elements* elements, uint64_t element) {
    uint64_t low = 0, high = elements->change_count;
    while (low < high) {
        const uint64_t middle = low + (high - low) / 2;
        if (dmi_gltf_changed(elements, middle) < element)
            low = middle + 1;
        else
            high = middle;
    }
    return low < elements->change_count && dmi_gltf_changed(elements, low) == element ? low : elements->change_count;
}

void dmi_gltf_read_indices(const dmi_gltf_elements* elements, uint32_t* out) {
    const uint8_t* data = elements->data;
    const uint64_t count = data ? elements->count : 0, stride = elements->stride;
    switch (elements->component_type) {
    case DMI_GLTF_UBYTE:
        for (uint64_t i = 0; i < count; i++) out[i] = data[i * stride];
        break;
    case DMI_GLTF_USHORT:
        for (uint64_t i = 0; i < count; i++) out[i] = (uint32_t)(data[i * stride] | data[i * stride + 1] << 8);
        break;
    default:
        for (uint64_t i = 0; i < count; i++) out[i] = read_u32(data + i * stride);
        break;
    }
    for (uint64_t i = count; i < elements->count; i++) out[i] = 0;
    for (uint64_t i = 0; i < elements->change_count; i++)
        out[dmi_gltf_changed(elements, i)] = (uint32_t)dmi_gltf_change(elements, i, 0);
}
