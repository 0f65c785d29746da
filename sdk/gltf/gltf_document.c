/* Indexes the lists of a document, and checks whether this library may read it at all. */
#include "gltf/gltf_document.h"

#include <math.h>
#include <string.h>

#include "gltf/gltf_draco.h"
#include "gltf/gltf_meshopt.h"
#include "gltf/gltf_tree.h"

const char* const dmi_gltf_list_names[DMI_GLTF_LISTS] = {
    [DMI_GLTF_ACCESSORS] = "accessors", [DMI_GLTF_BUFFERS] = "buffers",  [DMI_GLTF_IMAGES] = "images",
    [DMI_GLTF_MATERIALS] = "materials", [DMI_GLTF_MESHES] = "meshes",    [DMI_GLTF_NODES] = "nodes",
    [DMI_GLTF_SAMPLERS] = "samplers",   [DMI_GLTF_SCENES] = "scenes",    [DMI_GLTF_SKINS] = "skins",
    [DMI_GLTF_TEXTURES] = "textures",   [DMI_GLTF_VIEWS] = "bufferViews"};

static dm_result open_list(dmi_env* env, dmi_gltf_document* document, dmi_gltf_list list, dmi_gltf_problem* problem) {
    const cJSON* found = dmi_json_get(document->root, dmi_gltf_list_names[list]);
    const uint32_t count = cJSON_IsArray(found) ? (uint32_t)cJSON_GetArraySize(found) : 0;
    cJSON** items = dmi_alloc(env, (size_t)count * sizeof(void*), sizeof(void*));
    if (!items) return dmi_gltf_refuse(problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u items", count);
    document->items[list] = items;
    document->counts[list] = count;
    cJSON* item = count ? found->child : NULL;
    for (uint32_t i = 0; i < count; i++, item = item->next) items[i] = item;
    return DM_OK;
}

dm_result dmi_gltf_document_open(dmi_env* env, cJSON* root, dmi_gltf_problem* problem, dmi_gltf_document* out) {
    *out = (dmi_gltf_document){.root = root};
    for (int list = 0; list < DMI_GLTF_LISTS; list++) {
        const dm_result result = open_list(env, out, (dmi_gltf_list)list, problem);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

dm_result dmi_gltf_list_again(dmi_env* env, dmi_gltf_document* document, dmi_gltf_list list,
                              dmi_gltf_problem* problem) {
    dmi_free(env, document->items[list], document->counts[list] * sizeof(void*));
    document->items[list] = NULL;
    document->counts[list] = 0;
    return open_list(env, document, list, problem);
}

void dmi_gltf_document_close(dmi_env* env, dmi_gltf_document* document) {
    for (int list = 0; list < DMI_GLTF_LISTS; list++)
        dmi_free(env, document->items[list], document->counts[list] * sizeof(void*));
    cJSON_Delete(document->root);
    *document = (dmi_gltf_document){0};
}

int64_t dmi_gltf_position(const dmi_gltf_document* document, dmi_gltf_list list, double index) {
    return index >= 0 && index < document->counts[list] && index == floor(index) ? (int64_t)index : -1;
}

cJSON* dmi_gltf_item(const dmi_gltf_document* document, dmi_gltf_list list, double index) {
    const int64_t position = dmi_gltf_position(document, list, index);
    return position >= 0 ? document->items[list][position] : NULL;
}

/* ---- extensions ---- */

/* Required extensions that change nothing of what this library reads, or that it reads. One with a * is a prefix. */
static const char* const known_extensions[] = {
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_materials_*",
    "KHR_texture_*",
    "EXT_texture_*",
    "MSFT_texture_dds",
    "KHR_lights_*",
    "EXT_lights_*",
    "KHR_xmp_json_ld",
    "KHR_xmp",
    "KHR_animation_*",
    "KHR_node_selectability",
    "KHR_node_hoverability",
    "KHR_audio_emitter",
    "KHR_interactivity",
    "KHR_techniques_webgl",
    DMI_INSTANCING_NAME,
    "MSFT_lod",
    "KHR_physics_rigid_bodies",
    "KHR_collision_shapes",
    "KHR_implicit_shapes",
};

static int is_known(const char* name) {
    if (dmi_meshopt_is_name(name)) return dmi_meshopt_available();
    if (strcmp(name, DMI_DRACO_NAME) == 0) return dmi_draco_available();
    for (size_t i = 0; i < sizeof known_extensions / sizeof *known_extensions; i++) {
        const size_t length = strlen(known_extensions[i]);
        const int is_prefix = known_extensions[i][length - 1] == '*';
        if (is_prefix ? strncmp(name, known_extensions[i], length - 1) == 0 : strcmp(name, known_extensions[i]) == 0)
            return 1;
    }
    return 0;
}

int dmi_gltf_requires(const dmi_gltf_document* document, const char* extension) {
    const cJSON* name;
    cJSON_ArrayForEach(name, dmi_json_get(document->root, "extensionsRequired")) {
        if (cJSON_IsString(name) && strcmp(name->valuestring, extension) == 0) return 1;
    }
    return 0;
}

dm_result dmi_gltf_check_asset(const dmi_gltf_document* document, dmi_gltf_problem* problem) {
    const cJSON *asset = dmi_json_get(document->root, "asset"), *name;
    const char *version = dmi_json_text(asset, "version"), *least = dmi_json_text(asset, "minVersion");
    if (!version || !version[0]) return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "glTF: asset.version is missing");
    if (strncmp(version, "2", 1) != 0 || (least && strcmp(least, "2.0") != 0))
        return dmi_gltf_refuse(problem, version[0] < '2' ? DM_ERROR_UNSUPPORTED : DM_ERROR_VERSION,
                               "glTF: version %.20s, only 2.0 can be read", least ? least : version);
    cJSON_ArrayForEach(name, dmi_json_get(document->root, "extensionsRequired")) {
        if (cJSON_IsString(name) && !is_known(name->valuestring))
            return dmi_gltf_refuse(
                problem, DM_ERROR_UNSUPPORTED, "glTF: the file needs the extension %.80s%s", name->valuestring,
                dmi_meshopt_is_name(name->valuestring) || strcmp(name->valuestring, DMI_DRACO_NAME) == 0
                    ? ", whose library this build lacks"
                    : "");
    }
    return DM_OK;
}
