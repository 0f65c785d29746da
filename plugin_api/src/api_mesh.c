/* Checks that a mesh's buffers are as long as counts, formats and strides say. */
#include "api_mesh.h"

#include <stdbool.h>

#include "api_check.h"

static uint64_t integer_bytes(int32_t format) {
    return format == DM_UINT8 ? 1 : format == DM_UINT16 ? 2 : 4;
}

static dm_result check_formats(dmi_env* env, const char* what, const dm_mesh_desc* mesh) {
    const struct {
        const char* name;
        int32_t value, last;
    } formats[] = {{"position_format", mesh->position_format, DM_FLOAT64},
                   {"index_format", mesh->index_format, DM_UINT8},
                   {"part_id_format", mesh->part_id_format, DM_INT32},
                   {"part_id_scope", mesh->part_id_scope, DM_PER_FACE}};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (formats[i].value >= 0 && formats[i].value <= formats[i].last) continue;
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.%s is %d: it must be 0 to %d", what, formats[i].name,
                        formats[i].value, formats[i].last);
    }
    if (mesh->reserved == 0) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.reserved is %u: it must be 0", what, mesh->reserved);
}

/* A buffer of `count` elements; stride 0 = packed. */
typedef struct buffer {
    const char *name, *elements, *hint;
    uint64_t bytes, count, element, stride;
    bool exact; /* a longer buffer is wrong too, because it shows a forgotten scope */
} buffer;

/* Checks a buffer. One with a stride may end with the last element, or begin inside the first vertex. */
static dm_result check_buffer(dmi_env* env, const char* what, const buffer* b) {
    const uint64_t stride = b->stride > 0 ? b->stride : b->element;
    const uint64_t least = b->count > 0 ? (b->count - 1) * stride + b->element : 0, most = b->count * stride;
    if (b->bytes >= least && (!b->exact || b->bytes <= most)) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "%s.%s is %llu, but %llu %s of %llu bytes, %llu apart, take %llu. Is %s forgotten?", what, b->name,
                    (unsigned long long)b->bytes, (unsigned long long)b->count, b->elements,
                    (unsigned long long)b->element, (unsigned long long)stride, (unsigned long long)least, b->hint);
}

/* Checks all buffers. Nothing overflows for counts up to DM_MAX_ELEMENTS, and larger counts are refused later with a
 * message that names them. */
static dm_result check_buffers(dmi_env* env, const char* what, const dm_mesh_desc* mesh) {
    if (mesh->vertex_count > DM_MAX_ELEMENTS || mesh->index_count > 3 * (uint64_t)DM_MAX_ELEMENTS) return DM_OK;
    const uint64_t corners = mesh->indices != NULL ? mesh->index_count : mesh->vertex_count, faces = corners / 3;
    const bool per_face = mesh->part_id_scope == DM_PER_FACE;
    const buffer positions = {.name = "position_bytes",
                              .elements = "positions",
                              .hint = "position_format or position_stride",
                              .bytes = mesh->position_bytes,
                              .count = mesh->vertex_count,
                              .element = mesh->position_format == DM_FLOAT64 ? 24 : 12,
                              .stride = mesh->position_stride};
    const buffer indices = {.name = "index_bytes",
                            .elements = "indices",
                            .hint = "index_format",
                            .bytes = mesh->index_bytes,
                            .count = mesh->index_count,
                            .element = integer_bytes(mesh->index_format)};
    const buffer ids = {.name = "part_id_bytes",
                        .elements = per_face ? "faces" : "vertices",
                        .hint = "part_id_bytes, part_id_format or part_id_scope",
                        .bytes = mesh->part_id_bytes,
                        .count = per_face ? faces : mesh->vertex_count,
                        .element = integer_bytes(mesh->part_id_format),
                        .stride = mesh->part_id_stride,
                        .exact = true};
    dm_result result = DM_OK;
    if (mesh->position_bytes > 0) result = check_buffer(env, what, &positions);
    if (result == DM_OK && mesh->indices != NULL && mesh->index_bytes > 0) result = check_buffer(env, what, &indices);
    /* Corners that make no whole triangles are refused later with a message that names them. */
    const bool counted = !per_face || (corners > 0 && corners % 3 == 0);
    if (result == DM_OK && mesh->part_ids != NULL && counted) result = check_buffer(env, what, &ids);
    return result;
}

dm_result dmi_mesh_desc_read(dmi_env* env, const char* what, const dm_mesh_desc* mesh, dm_mesh_desc* out) {
    dm_result result = dmi_read_desc(env, what, mesh, DMI_FIRST_SIZE(dm_mesh_desc, reserved), sizeof *out, out);
    if (result == DM_OK) result = check_formats(env, what, out);
    if (result == DM_OK) result = check_buffers(env, what, out);
    return result;
}
