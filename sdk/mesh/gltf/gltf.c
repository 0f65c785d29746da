/* dm_gltf: opening and closing a file, its nodes and its mesh. */
#include "mesh/gltf/gltf_container.h"
#include "mesh/gltf/gltf_file.h"
#include "mesh/gltf/gltf_merge.h"
#include "mesh/gltf/gltf_tree.h"

/* A newer caller may only send zeros where this library knows no field. */
static dm_result check_desc(dmi_env* env, const dm_gltf_desc* desc) {
    if (desc->struct_size < sizeof *desc)
        return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "dm_gltf_desc.struct_size is %u, at least %zu is needed",
                        desc->struct_size, sizeof *desc);
    const uint8_t* bytes = (const uint8_t*)desc;
    for (uint32_t i = sizeof *desc; i < desc->struct_size; i++) {
        if (bytes[i])
            return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "dm_gltf_desc: byte %u is set, this library knows %zu", i,
                            sizeof *desc);
    }
    if (!desc->data || desc->size == 0) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_desc.data is empty");
    if ((desc->allocator.allocate == NULL) != (desc->allocator.release == NULL))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_desc.allocator: both functions or none");
    return DM_OK;
}

static dm_result load(dm_gltf* gltf, const dm_gltf_desc* desc) {
    int binary;
    dm_result result = dmi_gltf_check_container(&gltf->env, desc->data, desc->size, &binary);
    if (result != DM_OK) return result;
    char message[512] = "";
    result = dmi_tiny_parse(desc->data, desc->size, binary, &gltf->tiny, message, sizeof message);
    if (result != DM_OK) return dmi_fail(&gltf->env, result, "glTF: %s", message);
    const char* foreign = dmi_tiny_foreign_extension(gltf->tiny);
    if (foreign) return dmi_fail(&gltf->env, DM_ERROR_UNSUPPORTED, "glTF: the file needs %s", foreign);
    result = dmi_gltf_read_tree(gltf);
    return result == DM_OK ? dmi_gltf_merge(gltf) : result;
}

dm_result dm_gltf_open(const dm_gltf_desc* desc, dm_gltf** out_gltf) {
    dmi_env setup;
    if (!desc || !out_gltf) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env_init(&setup, NULL, desc->struct_size >= sizeof *desc ? &desc->log : NULL, NULL);
    dm_result result = check_desc(&setup, desc);
    if (result != DM_OK) return result;
    dmi_env_init(&setup, &desc->allocator, &desc->log, NULL);
    dm_gltf* gltf = dmi_alloc_zeroed(&setup, sizeof *gltf, 64);
    if (!gltf) return dmi_fail(&setup, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %zu bytes", sizeof *gltf);
    dmi_env_init(&gltf->env, &desc->allocator, &desc->log, NULL);
    result = load(gltf, desc);
    if (result == DM_OK)
        *out_gltf = gltf;
    else
        dm_gltf_close(gltf);
    return result;
}

void dm_gltf_close(dm_gltf* gltf) {
    if (!gltf) return;
    dmi_env* env = &gltf->env;
    dmi_tiny_free(gltf->tiny);
    dmi_free(env, gltf->parents, gltf->tree_count * sizeof *gltf->parents);
    dmi_free(env, gltf->order, gltf->tree_count * sizeof *gltf->order);
    dmi_free(env, gltf->worlds, gltf->tree_count * 16 * sizeof *gltf->worlds);
    dmi_free(env, gltf->nodes, gltf->node_capacity * sizeof *gltf->nodes);
    dmi_free(env, gltf->pieces, gltf->piece_capacity * sizeof *gltf->pieces);
    dmi_free(env, gltf->positions, gltf->vertex_count * 3 * sizeof *gltf->positions);
    dmi_free(env, gltf->indices, gltf->face_count * 3 * sizeof *gltf->indices);
    dmi_env last;
    dmi_env_init(&last, &env->allocator, NULL, NULL);
    dmi_free(&last, gltf, sizeof *gltf);
}

uint32_t dm_gltf_node_count(const dm_gltf* gltf) {
    return gltf ? gltf->node_count : 0;
}

dm_result dm_gltf_get_node(const dm_gltf* gltf, uint32_t index, dm_gltf_node* out_node) {
    if (!gltf || !out_node) return DM_ERROR_INVALID_ARGUMENT;
    if (index >= gltf->node_count) return DM_ERROR_NOT_FOUND;
    *out_node = gltf->nodes[index];
    return DM_OK;
}

dm_result dm_gltf_get_mesh(const dm_gltf* gltf, dm_mesh_desc* out_mesh) {
    if (!gltf || !out_mesh) return DM_ERROR_INVALID_ARGUMENT;
    *out_mesh = (dm_mesh_desc){.struct_size = sizeof *out_mesh,
                               .positions = gltf->positions,
                               .vertex_count = gltf->vertex_count,
                               .indices = gltf->indices,
                               .index_count = 3 * gltf->face_count};
    return DM_OK;
}
