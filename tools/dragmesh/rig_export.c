/* The files for engines and simulators beside rig.json. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragmesh/ext/gltf_rig.h"
#include "files.h"
#include "rig_output.h"

typedef struct format {
    const char* name;
    uint32_t bit;
} format;

static const format formats[] = {{"glb", DM_GLTF_RIG_GLB}, {"urdf", DM_GLTF_RIG_URDF}, {"mjcf", DM_GLTF_RIG_MJCF},
                                 {"sdf", DM_GLTF_RIG_SDF}, {"usda", DM_GLTF_RIG_USDA}, {"tscn", DM_GLTF_RIG_TSCN}};
enum { FORMATS = sizeof formats / sizeof *formats };

uint32_t rig_read_formats(const char* list, char* out_unknown, size_t size) {
    uint32_t found = 0;
    for (const char* at = list; *at;) {
        const size_t length = strcspn(at, ",");
        int i = 0;
        while (i < FORMATS && (strlen(formats[i].name) != length || strncmp(formats[i].name, at, length) != 0)) i++;
        if (i == FORMATS) {
            snprintf(out_unknown, size, "%.*s", (int)length, at);
            return 0;
        }
        found |= formats[i].bit;
        at += length + (at[length] == ',');
    }
    if (found == 0) snprintf(out_unknown, size, "none");
    return found;
}

void rig_format_names(uint32_t asked, char* out, size_t size) {
    size_t length = 0;
    for (int i = 0; i < FORMATS && length < size; i++)
        if (asked & formats[i].bit)
            length += (size_t)snprintf(out + length, size - length, "%s%s", length > 0 ? "," : "", formats[i].name);
}

/* The folder of the meshes is made where there are some. */
static dm_result write_file(file_set* set, const dm_gltf_rig_file* file, const char* folder) {
    const char* slash = strchr(file->path, '/');
    char *path = path_join(folder, file->path), *end = slash != NULL ? strrchr(path, '/') : NULL;
    dm_result result = DM_OK;
    if (end != NULL) {
        *end = 0;
        if (platform_make_folder(path) != 0 && errno != EEXIST) result = session_fail_to_write(set->session, path);
        *end = '/';
    }
    if (result == DM_OK) result = file_set_add(set, path, file->data, file->size);
    free(path);
    return result;
}

static dm_result write_files(file_set* set, const dm_gltf_rig* files, const char* folder) {
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < dm_gltf_rig_file_count(files) && result == DM_OK; i++) {
        dm_gltf_rig_file file;
        dm_gltf_rig_get_file(files, i, &file);
        result = write_file(set, &file, folder);
    }
    return result;
}

dm_result rig_write_formats(file_set* set, const rig* rig, uint32_t asked, const char* folder) {
    session* session = set->session;
    char name[DM_MAX_LABEL + 1];
    const uint32_t count = rig->info.part_count;
    dm_asset_part* parts = cli_alloc(count * sizeof *parts);
    dm_joint* joints = cli_alloc(count * sizeof *joints);
    uint32_t* node_parts = cli_alloc(rig->node_count * sizeof *node_parts);
    part_hints_file_stem(session->path, name, sizeof name);
    for (uint32_t i = 0; i < count; i++) {
        parts[i] = rig->parts[i].part;
        joints[i] = rig->parts[i].joint;
    }
    const dm_gltf_rig_desc desc = {.struct_size = sizeof desc,
                                   .formats = asked,
                                   .nodes = rig->nodes,
                                   .parts = parts,
                                   .joints = joints,
                                   .node_parts = node_parts,
                                   .name = name,
                                   .gltf = session->gltf,
                                   .node_count = rig->node_count,
                                   .part_count = count,
                                   .log = session_log(session)};
    dm_gltf_rig* files = NULL;
    dm_result result = dm_asset_get_node_parts(session->context, rig->asset, node_parts, rig->node_count);
    if (result == DM_OK) result = dm_gltf_rig_make(&desc, &files);
    if (result == DM_OK) result = write_files(set, files, folder);
    dm_gltf_rig_destroy(files);
    free(parts);
    free(joints);
    free(node_parts);
    return result;
}
