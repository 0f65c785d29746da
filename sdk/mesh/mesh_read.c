/* Reads the host's buffers element by element. They may be unaligned, so all reads go through memcpy. */
#include "mesh/mesh_read.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Returns the bytes of an index or part id of a format; 0 for an unknown one. */
static size_t integer_size(int32_t format) {
    switch (format) {
    case DM_UINT32:
    case DM_INT32:
        return 4;
    case DM_UINT16:
        return 2;
    case DM_UINT8:
        return 1;
    default:
        return 0;
    }
}

/* Returns the stride of a field whose elements have `size` bytes (stride 0: packed); 0 when it is too small. */
static size_t checked_stride(dmi_env* env, const char* field, uint32_t stride, size_t size) {
    if (stride == 0) return size;
    if (stride >= size) return stride;
    dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.%s: %u bytes, an element has %zu", field, stride, size);
    return 0;
}

static dm_result check_positions_desc(dmi_env* env, const dm_mesh_desc* desc, dmi_mesh_reader* reader) {
    if (desc->positions == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.positions: NULL");
    if (desc->position_format != DM_FLOAT32 && desc->position_format != DM_FLOAT64) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.position_format: unknown value %d",
                        desc->position_format);
    }
    if (desc->vertex_count == 0) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.vertex_count: 0");
    if (desc->vertex_count > DM_MAX_ELEMENTS) {
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_mesh_desc.vertex_count: %llu, at most %d",
                        (unsigned long long)desc->vertex_count, DM_MAX_ELEMENTS);
    }
    size_t size = 3 * (desc->position_format == DM_FLOAT64 ? sizeof(double) : sizeof(float));
    reader->position_stride = checked_stride(env, "position_stride", desc->position_stride, size);
    reader->vertex_count = (uint32_t)desc->vertex_count;
    return reader->position_stride > 0 ? DM_OK : DM_ERROR_INVALID_ARGUMENT;
}

static dm_result check_indices_desc(dmi_env* env, const dm_mesh_desc* desc, dmi_mesh_reader* reader) {
    uint64_t count = desc->indices != NULL ? desc->index_count : desc->vertex_count;
    if (desc->indices == NULL && desc->index_count != 0 && desc->index_count != desc->vertex_count) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.indices: NULL, but index_count is %llu",
                        (unsigned long long)desc->index_count);
    }
    reader->index_size = integer_size(desc->index_format);
    if (reader->index_size == 0 || desc->index_format == DM_INT32) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.index_format: unknown value %d",
                        desc->index_format);
    }
    if (count == 0 || count % 3 != 0) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_mesh_desc.index_count: %llu, must be a multiple of 3 above 0", (unsigned long long)count);
    }
    if (count / 3 > DM_MAX_ELEMENTS) {
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_mesh_desc.index_count: %llu, at most %lld",
                        (unsigned long long)count, 3LL * DM_MAX_ELEMENTS);
    }
    reader->face_count = (uint32_t)(count / 3);
    return DM_OK;
}

static dm_result check_part_ids_desc(dmi_env* env, const dm_mesh_desc* desc, dmi_mesh_reader* reader) {
    if (desc->part_ids == NULL) return DM_OK;
    size_t size = integer_size(desc->part_id_format);
    if (size == 0) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.part_id_format: unknown value %d",
                        desc->part_id_format);
    }
    if (desc->part_id_scope != DM_PER_VERTEX && desc->part_id_scope != DM_PER_FACE) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.part_id_scope: unknown value %d",
                        desc->part_id_scope);
    }
    reader->part_id_stride = checked_stride(env, "part_id_stride", desc->part_id_stride, size);
    return reader->part_id_stride > 0 ? DM_OK : DM_ERROR_INVALID_ARGUMENT;
}

dm_result dmi_mesh_reader_open(dmi_env* env, const dm_mesh_desc* desc, dmi_mesh_reader* out_reader) {
    *out_reader = (dmi_mesh_reader){.desc = desc};
    if (desc == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc: NULL");
    dm_result result = check_positions_desc(env, desc, out_reader);
    if (result == DM_OK) result = check_indices_desc(env, desc, out_reader);
    if (result == DM_OK) result = check_part_ids_desc(env, desc, out_reader);
    return result;
}

/* Reads an unsigned integer of 1, 2 or 4 bytes. */
static uint32_t read_integer(const char* memory, size_t size) {
    uint32_t u32;
    uint16_t u16;
    switch (size) {
    case 4:
        memcpy(&u32, memory, 4);
        return u32;
    case 2:
        memcpy(&u16, memory, 2);
        return u16;
    default:
        return (uint8_t)*memory;
    }
}

dm_result dmi_mesh_read_indices(dmi_env* env, const dmi_mesh_reader* reader, uint32_t* out_indices) {
    const char* indices = reader->desc->indices;
    size_t count = (size_t)reader->face_count * 3;
    for (size_t i = 0; i < count; i++) {
        uint32_t index =
            indices != NULL ? read_integer(indices + i * reader->index_size, reader->index_size) : (uint32_t)i;
        if (index >= reader->vertex_count) {
            return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE,
                            "dm_mesh_desc.indices: face %zu names vertex %u, there are %u vertices", i / 3, index,
                            reader->vertex_count);
        }
        out_indices[i] = index;
    }
    return DM_OK;
}

void dmi_mesh_read_position(const dmi_mesh_reader* reader, uint32_t vertex, double out[3]) {
    const char* memory = (const char*)reader->desc->positions + vertex * reader->position_stride;
    if (reader->desc->position_format == DM_FLOAT64) {
        memcpy(out, memory, 3 * sizeof(double));
        return;
    }
    float xyz[3];
    memcpy(xyz, memory, sizeof xyz);
    for (int i = 0; i < 3; i++) out[i] = (double)xyz[i];
}

dm_result dmi_mesh_check_positions(dmi_env* env, const dmi_mesh_reader* reader) {
    for (uint32_t v = 0; v < reader->vertex_count; v++) {
        double p[3];
        dmi_mesh_read_position(reader, v, p);
        /* Written so that NaN fails it too. */
        if (fabs(p[0]) <= FLT_MAX && fabs(p[1]) <= FLT_MAX && fabs(p[2]) <= FLT_MAX) continue;
        return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_mesh_desc.positions: vertex %u is (%g, %g, %g)", v, p[0], p[1],
                        p[2]);
    }
    return DM_OK;
}

uint32_t dmi_mesh_read_part_id(const dmi_mesh_reader* reader, uint32_t element) {
    size_t size = integer_size(reader->desc->part_id_format);
    const char* ids = reader->desc->part_ids;
    uint32_t id = read_integer(ids + element * reader->part_id_stride, size);
    return reader->desc->part_id_format == DM_INT32 && id > INT32_MAX ? 0 : id;
}
