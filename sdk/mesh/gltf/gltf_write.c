/* dm_gltf_write: meshes made elsewhere, as a static .glb. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "mesh/gltf/gltf_file.h"
#include "mesh/gltf/gltf_write.h"

static dm_result check_part(dmi_env* env, const dm_gltf_part* part, uint32_t which) {
    if (!part->positions || !part->indices || part->vertex_count == 0 || part->index_count == 0 ||
        part->index_count % 3 != 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "part %u: %" PRIu64 " vertices and %" PRIu64 " indices", which,
                        part->vertex_count, part->index_count);
    if (part->vertex_count > DM_MAX_ELEMENTS || part->index_count / 3 > DM_MAX_ELEMENTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "part %u: more than %d vertices or triangles", which, DM_MAX_ELEMENTS);
    for (uint64_t i = 0; i < 3 * part->vertex_count; i++) {
        if (!isfinite(part->positions[i]))
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "part %u: vertex %" PRIu64 " is not finite", which, i / 3);
    }
    for (uint64_t i = 0; i < part->index_count; i++) {
        if (part->indices[i] >= part->vertex_count)
            return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE, "part %u: index %" PRIu64 " names vertex %u of %" PRIu64,
                            which, i, part->indices[i], part->vertex_count);
    }
    return DM_OK;
}

static void add_part(dmi_tiny* tiny, const dm_gltf_part* part) {
    float low[3], high[3];
    for (int k = 0; k < 3; k++) low[k] = high[k] = part->positions[k];
    for (uint64_t i = 0; i < 3 * part->vertex_count; i++) {
        low[i % 3] = fminf(low[i % 3], part->positions[i]);
        high[i % 3] = fmaxf(high[i % 3], part->positions[i]);
    }
    const size_t position_bytes = part->vertex_count * 3 * sizeof(float);
    const int32_t vertices = dmi_tiny_add_view(tiny, part->positions, position_bytes, DMI_TINY_VERTICES);
    const int32_t triangles =
        dmi_tiny_add_view(tiny, part->indices, part->index_count * sizeof(uint32_t), DMI_TINY_INDICES);
    const int32_t positions = dmi_tiny_add_accessor(tiny, vertices, DMI_TINY_FLOAT, 3, part->vertex_count, low, high);
    const int32_t indices = dmi_tiny_add_accessor(tiny, triangles, DMI_TINY_UINT, 1, part->index_count, NULL, NULL);
    const int32_t material = dmi_tiny_add_material(tiny, part->colour);
    const int32_t mesh = dmi_tiny_add_mesh(tiny, part->name, -1);
    dmi_tiny_add_primitive(tiny, mesh, positions, indices, material);
    dmi_tiny_add_root(tiny, dmi_tiny_add_node(tiny, part->name, mesh));
}

dm_result dm_gltf_write(const dm_gltf_part* parts, uint32_t part_count, const dm_allocator* allocator,
                        const dm_log* log, void** out_data, size_t* out_size) {
    dmi_env env;
    dmi_env_init(&env, allocator, log, NULL);
    if (!parts || part_count == 0 || !out_data || !out_size)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_write: no part, or no place for the result");
    for (uint32_t i = 0; i < part_count; i++) {
        const dm_result result = check_part(&env, &parts[i], i);
        if (result != DM_OK) return result;
    }
    dmi_tiny* tiny = dmi_tiny_new();
    if (!tiny) return dmi_fail(&env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_write: no memory");
    for (uint32_t i = 0; i < part_count; i++) add_part(tiny, &parts[i]);
    const dm_result result = dmi_gltf_finish(&env, tiny, out_data, out_size);
    dmi_tiny_free(tiny);
    return result;
}

dm_result dmi_gltf_finish(dmi_env* env, dmi_tiny* tiny, void** out_data, size_t* out_size) {
    char message[512] = "";
    const void* data;
    size_t size;
    const dm_result result = dmi_tiny_write(tiny, &data, &size, message, sizeof message);
    if (result != DM_OK) return dmi_fail(env, result, "glTF: %s", message);
    void* copy = dmi_alloc(env, size, 16);
    if (!copy) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a file of %zu bytes", size);
    memcpy(copy, data, size);
    *out_data = copy;
    *out_size = size;
    return DM_OK;
}

void dm_gltf_release_bytes(const dm_gltf* gltf, void* data, size_t size) {
    if (!gltf) return;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, NULL, NULL);
    dmi_free(&env, data, size);
}
