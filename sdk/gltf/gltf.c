/* dm_gltf: opening and closing a file, its nodes and its mesh. */
#include <errno.h>
#include <stddef.h>
#include <string.h>

#include "base/fp_environment.h"
#include "base/utf8.h"
#include "gltf/gltf_asset.h"
#include "gltf/gltf_buffers.h"
#include "gltf/gltf_document.h"
#include "gltf/gltf_file.h"
#include "gltf/gltf_geometry.h"
#include "gltf/gltf_merge.h"
#include "gltf/gltf_tree.h"

/* Bytes of a description before fields were added to it. */
#define FIRST_SIZE offsetof(dm_gltf_desc, progress)

/* Returns where a description says its problems go; NULL when it is too short to say so. */
static const dm_log* log_of(const dm_gltf_desc* desc) {
    return desc->struct_size >= FIRST_SIZE ? &desc->log : NULL;
}

static dm_result check_desc(dmi_env* env, const dm_gltf_desc* given, const dm_gltf_desc* desc, int has_data) {
    const uint8_t* bytes = (const uint8_t*)given;
    for (uint32_t i = sizeof *desc; i < desc->struct_size; i++) {
        if (bytes[i])
            return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "dm_gltf_desc: byte %u is set, this library knows %zu", i,
                            sizeof *desc);
    }
    if (has_data != (desc->data && desc->size > 0))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        has_data ? "dm_gltf_desc.data is empty" : "dm_gltf_desc.data: the file's name stands for it");
    if ((desc->allocator.allocate == NULL) != (desc->allocator.release == NULL))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_desc.allocator: both functions or none");
    if ((desc->files.open == NULL) != (desc->files.close == NULL))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_desc.files: both functions or none");
    return DM_OK;
}

/* Copies and checks a description, with or without data. A newer caller may only send zeros where this library knows no
 * field. */
static dm_result read_desc(dmi_env* env, const dm_gltf_desc* given, int has_data, dm_gltf_desc* out) {
    if (given->struct_size < FIRST_SIZE)
        return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "dm_gltf_desc.struct_size is %u, at least %zu is needed",
                        given->struct_size, FIRST_SIZE);
    *out = (dm_gltf_desc){0};
    memcpy(out, given, given->struct_size < sizeof *out ? given->struct_size : sizeof *out);
    return check_desc(env, given, out, has_data);
}

static dm_result load_document(dm_gltf* gltf, const dm_gltf_desc* desc, dmi_gltf_problem* problem) {
    dmi_gltf_container container;
    cJSON* root;
    dm_result result = dmi_gltf_split(desc->data, desc->size, problem, &container);
    if (result == DM_OK) result = dmi_gltf_tell(gltf, 0, DMI_PROGRESS_STEP, problem);
    if (result == DM_OK) result = dmi_json_parse(container.json, container.json_size, problem, &root);
    if (result != DM_OK) return result;
    result = dmi_gltf_document_open(&gltf->env, root, problem, &gltf->document);
    if (result == DM_OK) result = dmi_gltf_tell(gltf, DMI_STAGE_GLTF_PARSED, DMI_PROGRESS_STEP, problem);
    if (result == DM_OK) result = dmi_gltf_check_asset(&gltf->document, problem);
    if (result == DM_OK) result = dmi_gltf_check_fields(&gltf->document, problem);
    if (result == DM_OK) result = dmi_gltf_read_buffers(gltf, &container, problem);
    if (result == DM_OK) result = dmi_gltf_tell(gltf, DMI_STAGE_GLTF_BUFFERS_READ, DMI_PROGRESS_STEP, problem);
    if (result == DM_OK) result = dmi_gltf_unroll_instances(gltf, problem);
    if (result == DM_OK) result = dmi_gltf_part_morphs(gltf, problem);
    if (result == DM_OK) result = dmi_gltf_read_tree(gltf, problem);
    if (result == DM_OK) result = dmi_gltf_sort_names(gltf, problem);
    if (result == DM_OK) result = dmi_gltf_find_roles(gltf, problem);
    if (result == DM_OK) result = dmi_gltf_tell(gltf, DMI_STAGE_GLTF_TREE_READ, DMI_PROGRESS_STEP, problem);
    if (result == DM_OK) result = dmi_gltf_merge(gltf, problem);
    return result == DM_OK ? dmi_gltf_tell(gltf, 1, DMI_PROGRESS_STEP, problem) : result;
}

/* Opens by a description that was checked. Takes over `on_disk`, also where it fails. */
static dm_result open_checked(const dm_gltf_desc* desc, const dmi_gltf_on_disk* on_disk, dm_gltf** out_gltf) {
    dmi_env setup;
    dmi_env_init(&setup, &desc->allocator, &desc->log, NULL);
    dm_gltf* gltf = dmi_alloc_zeroed(&setup, sizeof *gltf, 64);
    if (!gltf) {
        dmi_gltf_release_on_disk(&setup, on_disk);
        return dmi_fail(&setup, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %zu bytes", sizeof *gltf);
    }
    dmi_env_init(&gltf->env, &desc->allocator, &desc->log, NULL);
    gltf->progress =
        (dmi_progress){.function = "glTF", .progress = desc->progress, .user = desc->progress_user, .to = 1};
    gltf->on_disk = *on_disk;
    gltf->files = on_disk->folder ? dmi_gltf_folder_files(gltf) : desc->files;
    dmi_gltf_problem problem = {.code = DM_OK};
    const dm_result result = load_document(gltf, desc, &problem);
    dmi_gltf_log_warnings(&gltf->env, &gltf->warnings);
    if (result == DM_OK) {
        *out_gltf = gltf;
        return DM_OK;
    }
    dm_gltf_close(gltf);
    return dmi_fail(&setup, result, "%s", problem.text);
}

dm_result dm_gltf_open(const dm_gltf_desc* desc, dm_gltf** out_gltf) {
    DMI_OWN_FP;
    dmi_env setup;
    if (!desc || !out_gltf) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env_init(&setup, NULL, log_of(desc), NULL);
    dm_gltf_desc known;
    const dm_result result = read_desc(&setup, desc, 1, &known);
    const dmi_gltf_on_disk none = {NULL, 0, NULL, 0};
    return result == DM_OK ? open_checked(&known, &none, out_gltf) : result;
}

/* The folder that holds the file, as new memory of *out_size bytes. */
static char* folder_of(dmi_env* env, const char* path, size_t* out_size) {
    const char* slash = dmi_gltf_last_separator(path);
    const size_t length = !slash ? 1 : slash == path ? 1 : (size_t)(slash - path);
    char* folder = dmi_alloc(env, length + 1, 1);
    if (!folder) return NULL;
    memcpy(folder, slash ? path : ".", length);
    folder[length] = 0;
    *out_size = length + 1;
    return folder;
}

/* Takes `from` over. */
static dm_result open_contents(dmi_env* env, const char* path, const dm_gltf_desc* desc, const dmi_gltf_contents* from,
                               dm_gltf** out_gltf) {
    dmi_gltf_on_disk on_disk = {.data = from->data, .size = from->size};
    on_disk.folder = folder_of(env, path, &on_disk.folder_size);
    if (from->size == 0 || !on_disk.folder) {
        dmi_gltf_release_on_disk(env, &on_disk);
        return from->size == 0 ? dmi_fail(env, DM_ERROR_BAD_DATA, "'%.200s' is empty", path)
                               : dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a path");
    }
    dm_gltf_desc whole = *desc;
    whole.data = from->data;
    whole.size = from->size;
    return open_checked(&whole, &on_disk, out_gltf);
}

dm_result dm_gltf_open_file(const char* path, const dm_gltf_desc* desc, dm_gltf** out_gltf) {
    DMI_OWN_FP;
    dmi_env env;
    if (!path || !desc || !out_gltf) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env_init(&env, NULL, log_of(desc), NULL);
    dm_gltf_desc known;
    dm_result result = read_desc(&env, desc, 0, &known);
    if (result == DM_OK && known.files.open)
        result = dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_desc.files: the folder stands for them");
    if (result != DM_OK) return result;
    dmi_env_init(&env, &known.allocator, &known.log, NULL);
    dmi_gltf_contents found;
    result = dmi_gltf_read_file(&env, path, &found);
    if (result == DM_ERROR_OUT_OF_MEMORY || result == DM_ERROR_TOO_LARGE)
        return dmi_fail(&env, result, "'%.200s': no memory for it, or more than 4 GB", path);
    if (result != DM_OK)
        return dmi_fail(&env, result, "can't read '%.200s': %s", path,
                        errno == EINVAL ? "it is a pipe or a device, not a file" : strerror(errno));
    return open_contents(&env, path, &known, &found, out_gltf);
}

void dm_gltf_close(dm_gltf* gltf) {
    if (!gltf) return;
    dmi_env* env = &gltf->env;
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    dmi_gltf_release_asset(gltf);
    dmi_gltf_release_decoded(gltf);
    dmi_gltf_release_buffers(gltf);
    dmi_free(env, gltf->tree, count * sizeof *gltf->tree);
    dmi_free(env, gltf->names, count * sizeof *gltf->names);
    dmi_free(env, gltf->order, count * sizeof *gltf->order);
    dmi_free(env, gltf->nodes, gltf->node_capacity * sizeof *gltf->nodes);
    dmi_free(env, gltf->pieces, gltf->piece_capacity * sizeof *gltf->pieces);
    dmi_free(env, gltf->positions, gltf->vertex_capacity * 3 * sizeof *gltf->positions);
    dmi_free(env, gltf->indices, gltf->face_capacity * 3 * sizeof *gltf->indices);
    dmi_free(env, gltf->sources, gltf->vertex_capacity * sizeof *gltf->sources);
    dmi_free(env, gltf->vertex_places, gltf->vertex_capacity * sizeof *gltf->vertex_places);
    dmi_free(env, gltf->face_places, gltf->face_capacity * sizeof *gltf->face_places);
    dmi_gltf_document_close(env, &gltf->document);
    dmi_gltf_release_on_disk(env, &gltf->on_disk);
    dmi_env last;
    dmi_env_init(&last, &env->allocator, NULL, NULL);
    dmi_free(&last, gltf, sizeof *gltf);
}

uint32_t dm_gltf_node_count(const dm_gltf* gltf) {
    return gltf ? gltf->node_count : 0;
}

dm_result dm_gltf_get_node(const dm_gltf* gltf, uint32_t index, dm_gltf_node* out_node) {
    DMI_OWN_FP;
    if (!gltf || !out_node) return DM_ERROR_INVALID_ARGUMENT;
    if (index >= gltf->node_count) return DM_ERROR_NOT_FOUND;
    *out_node = gltf->nodes[index];
    return DM_OK;
}

int32_t dm_gltf_left_out(const dm_gltf* gltf) {
    return gltf && (gltf->left_out.code != DM_OK || gltf->has_one_of_instances);
}

dm_result dm_gltf_get_mesh(const dm_gltf* gltf, dm_mesh_desc* out_mesh) {
    DMI_OWN_FP;
    if (!gltf || !out_mesh) return DM_ERROR_INVALID_ARGUMENT;
    *out_mesh = (dm_mesh_desc){.struct_size = sizeof *out_mesh,
                               .positions = gltf->positions,
                               .vertex_count = gltf->vertex_count,
                               .indices = gltf->indices,
                               .index_count = 3 * gltf->face_count};
    return DM_OK;
}

void dm_gltf_get_origin(const dm_gltf* gltf, double out_origin[3]) {
    for (int k = 0; k < 3; k++) out_origin[k] = gltf ? gltf->origin[k] : 0;
}

uint32_t dm_gltf_version(void) {
    return DM_VERSION;
}

size_t dm_gltf_mend_text(char* text) {
    return text ? dmi_utf8_mend(text) : 0;
}
