/* Writes meshes made elsewhere as a static .glb (dm_gltf_write). */
#include <inttypes.h>
#include <math.h>

#include "gltf/gltf_edit.h"
#include "math/elementary.h"

#include "base/fp_environment.h"

static dm_result check_part(dmi_env* env, const dm_gltf_part* part, uint32_t which) {
    if (!part->positions || !part->indices || part->vertex_count == 0 || part->index_count == 0 ||
        part->index_count % 3 != 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "part %u: %" PRIu64 " vertices and %" PRIu64 " indices", which,
                        part->vertex_count, part->index_count);
    if (part->vertex_count > DM_MAX_ELEMENTS || part->index_count / 3 > DM_MAX_ELEMENTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "part %u: more than %d vertices or triangles", which, DM_MAX_ELEMENTS);
    for (int i = 0; i < 4; i++) {
        if (!isfinite(part->colour[i]))
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "part %u: colour[%d] is not finite", which, i);
    }
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

static int32_t add_material(dmi_edit* e, const float colour[4]) {
    const dmi_edit_item material = dmi_edit_add(e, DMI_GLTF_MATERIALS, NULL);
    cJSON* surface = dmi_edit_object(e, material.json, "pbrMetallicRoughness");
    double values[4];
    for (int i = 0; i < 4; i++)
        values[i] = (double)dmi_fmaxf(0, dmi_fminf(1, colour[i])); /* glTF's range of a colour */
    dmi_edit_numbers(e, surface, "baseColorFactor", values, 4);
    dmi_edit_number(e, surface, "metallicFactor", 0);
    dmi_edit_number(e, surface, "roughnessFactor", 0.8);
    dmi_edit_set(e, material.json, "doubleSided", cJSON_CreateTrue());
    return material.index;
}

static void add_part(dmi_edit* e, const dm_gltf_part* part) {
    float low[3], high[3];
    for (int k = 0; k < 3; k++) low[k] = high[k] = part->positions[k];
    for (uint64_t v = 0; v < part->vertex_count; v++) {
        for (int k = 0; k < 3; k++) {
            low[k] = dmi_fminf(low[k], part->positions[3 * v + (uint64_t)k]);
            high[k] = dmi_fmaxf(high[k], part->positions[3 * v + (uint64_t)k]);
        }
    }
    const uint64_t vertex_bytes = part->vertex_count * 3 * sizeof(float);
    const int32_t vertices = dmi_edit_add_view(e, part->positions, vertex_bytes, DMI_GLTF_VERTEX_TARGET);
    const int32_t triangles =
        dmi_edit_add_view(e, part->indices, part->index_count * sizeof(uint32_t), DMI_GLTF_INDEX_TARGET);
    const int32_t positions = dmi_edit_add_accessor(e, vertices, DMI_GLTF_FLOAT, 3, part->vertex_count, low, high);
    const int32_t indices = dmi_edit_add_accessor(e, triangles, DMI_GLTF_UINT, 1, part->index_count, NULL, NULL);
    const int32_t material = add_material(e, part->colour);
    cJSON* primitive = dmi_edit_new(e, cJSON_CreateObject());
    dmi_edit_number(e, dmi_edit_object(e, primitive, "attributes"), "POSITION", positions);
    dmi_edit_number(e, primitive, "indices", indices);
    dmi_edit_number(e, primitive, "material", material);
    const dmi_edit_item mesh = dmi_edit_add(e, DMI_GLTF_MESHES, NULL), node = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
    dmi_edit_append(e, dmi_edit_list(e, mesh.json, "primitives"), primitive);
    dmi_edit_number(e, node.json, "mesh", mesh.index);
    if (part->name) dmi_edit_text(e, mesh.json, "name", part->name);
    if (part->name) dmi_edit_text(e, node.json, "name", part->name);
    cJSON* scene = e->document.counts[DMI_GLTF_SCENES] ? e->document.items[DMI_GLTF_SCENES][0] : NULL;
    dmi_edit_append_number(e, dmi_edit_list(e, scene, "nodes"), node.index);
}

dm_result dm_gltf_write(const dm_gltf_part* parts, uint32_t part_count, const dm_allocator* allocator,
                        const dm_log* log, void** out_data, size_t* out_size) {
    DMI_OWN_FP;
    dmi_env env;
    dmi_env_init(&env, allocator, log, NULL);
    if (!parts || part_count == 0 || !out_data || !out_size)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_write: no part, or no place for the result");
    for (uint32_t i = 0; i < part_count; i++) {
        const dm_result result = check_part(&env, &parts[i], i);
        if (result != DM_OK) return result;
    }
    dmi_edit edit;
    dmi_edit_open(&edit, &env, NULL);
    for (uint32_t i = 0; i < part_count; i++) add_part(&edit, &parts[i]);
    const dm_result result = dmi_edit_write(&edit, out_data, out_size);
    dmi_edit_close(&edit);
    return result;
}
