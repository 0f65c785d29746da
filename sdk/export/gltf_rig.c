/* Makes the files of a rigged asset in memory (dm_gltf_rig). */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "base/fp_environment.h"
#include "base/utf8.h"
#include "export/rig_formats.h"

enum { ALIGNMENT = 16, PATH = DMI_RIG_NAME + 16 };

typedef struct rig_file {
    char path[PATH];
    dmi_text text;
} rig_file;

struct dm_gltf_rig {
    dmi_env env;
    rig_file* files;
    uint32_t count, capacity;
};

/* A format, and what it cannot hold of a joint, as a warning says it; NULL: it holds the joint. */
typedef struct format {
    uint32_t bit;
    const char* path;
    dmi_rig_print* print;
    const char* screw;
} format;

static const format formats[] = {
    {DM_GLTF_RIG_URDF, "rigged.urdf", dmi_rig_print_urdf, "URDF has no screws: it turns and does not advance"},
    {DM_GLTF_RIG_MJCF, "rigged.xml", dmi_rig_print_mjcf, NULL},
    {DM_GLTF_RIG_SDF, "rigged.sdf", dmi_rig_print_sdf, NULL},
    {DM_GLTF_RIG_USDA, "rigged.usda", dmi_rig_print_usda, "USD has no screws: it turns and does not advance"},
    {DM_GLTF_RIG_TSCN, "rigged.tscn", dmi_rig_print_tscn, "Godot has no screws: it turns and does not advance"},
};
enum { FORMATS = sizeof formats / sizeof *formats };
/* Formats whose files refer to those of the meshes. */
enum { BESIDE_MESHES = DM_GLTF_RIG_URDF | DM_GLTF_RIG_MJCF | DM_GLTF_RIG_SDF | DM_GLTF_RIG_TSCN };

/* ---- checks ---- */

static bool is_name(const char* name) {
    if (name == NULL) return true;
    const size_t length = strnlen(name, DM_MAX_LABEL + 1);
    return length <= DM_MAX_LABEL && dmi_utf8_is_valid(name, length);
}

static dm_result check_nodes(dmi_env* env, const dm_gltf_rig_desc* desc) {
    for (uint32_t n = 0; n < desc->node_count; n++) {
        const dm_asset_node* node = &desc->nodes[n];
        if (node->struct_size != sizeof *node)
            return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "dm_gltf_rig_make: nodes[%u].struct_size is %u, not %zu", n,
                            node->struct_size, sizeof *node);
        if (!is_name(node->name))
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: nodes[%u].name is no UTF-8, or too long",
                            n);
        if (desc->node_parts[n] != DM_ASSET_NO_PART && desc->node_parts[n] >= desc->part_count)
            return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE, "dm_gltf_rig_make: node_parts[%u] is %u of %u parts", n,
                            desc->node_parts[n], desc->part_count);
        for (int k = 0; node->transform != NULL && k < 16; k++) /* literal: a matrix */
            if (!isfinite(node->transform[k]))
                return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_gltf_rig_make: nodes[%u].transform[%d] is %g", n, k,
                                (double)node->transform[k]);
        for (int k = 0; desc->colours != NULL && k < 4; k++) /* literal: a colour */
            if (!isfinite(desc->colours[4 * n + k]))         /* literal: a colour */
                return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_gltf_rig_make: the colour of node %u is not finite", n);
    }
    return DM_OK;
}

static dm_result check_parts(dmi_env* env, const dm_gltf_rig_desc* desc) {
    for (uint32_t p = 0; p < desc->part_count; p++) {
        if (desc->part_names != NULL && !is_name(desc->part_names[p]))
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: part_names[%u] is no UTF-8, or too long",
                            p);
        const dm_asset_part* part = &desc->parts[p];
        const dm_joint* joint = &desc->joints[p];
        if (part->struct_size != sizeof *part || joint->struct_size != sizeof *joint)
            return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "dm_gltf_rig_make: part %u: struct_size of part or joint", p);
        if (part->parent != DM_ASSET_NO_PART && part->parent >= desc->part_count)
            return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE, "dm_gltf_rig_make: parts[%u].parent is %u of %u parts", p,
                            part->parent, desc->part_count);
        const float sum = fabsf(joint->axis.x) + fabsf(joint->axis.y) + fabsf(joint->axis.z) + fabsf(joint->origin.x) +
                          fabsf(joint->origin.y) + fabsf(joint->origin.z) + fabsf(joint->lower) + fabsf(joint->upper) +
                          fabsf(joint->pitch);
        if (!isfinite(sum)) return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_gltf_rig_make: joints[%u] is not finite", p);
    }
    return DM_OK;
}

static dm_result check_desc(dmi_env* env, const dm_gltf_rig_desc* desc) {
    uint32_t known = DM_GLTF_RIG_GLB;
    dmi_axes axes;
    for (int i = 0; i < FORMATS; i++) known |= formats[i].bit;
    if (desc->formats == 0 || (desc->formats & ~known) != 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: formats is %u, known are %u", desc->formats,
                        known);
    if (desc->nodes == NULL || desc->node_parts == NULL || desc->node_count == 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: no nodes");
    if (desc->part_count > 0 && (desc->parts == NULL || desc->joints == NULL))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: no parts or joints");
    if (desc->node_count > DM_MAX_ASSET_NODES || desc->part_count > DM_MAX_PARTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_gltf_rig_make: %u nodes and %u parts; %d and %d are the most",
                        desc->node_count, desc->part_count, DM_MAX_ASSET_NODES, DM_MAX_PARTS);
    if (!dmi_axes_init(&axes, desc->axes, NULL, desc->unit_in_metres))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: axes %d, unit_in_metres %g", desc->axes,
                        (double)desc->unit_in_metres);
    if ((desc->formats & DM_GLTF_RIG_GLB) && (desc->gltf == NULL || desc->axes != DM_AXES_GLTF))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: a GLB needs `gltf`, and glTF's axes");
    if (desc->gltf != NULL && dm_gltf_node_count(desc->gltf) > desc->node_count)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: the nodes are not those of `gltf`");
    if (!isfinite(desc->density + desc->thickness + desc->friction + desc->damping_time))
        return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_gltf_rig_make: density, thickness, friction or damping_time");
    if (desc->density < 0 || desc->thickness < 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: density or thickness is negative");
    if (!is_name(desc->name))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_rig_make: name is no UTF-8, or too long");
    const dm_result result = check_nodes(env, desc);
    return result == DM_OK ? check_parts(env, desc) : result;
}

/* ---- files ---- */

static rig_file* add_file(dm_gltf_rig* rig, const char* before, const char* path, const char* after) {
    rig_file* file = &rig->files[rig->count++];
    snprintf(file->path, sizeof file->path, "%s%s%s", before, path, after);
    file->text = (dmi_text){.env = &rig->env};
    return file;
}

static void log_warning(dmi_env* env, const char* name, const char* what) {
    char text[3 * DMI_RIG_NAME];
    if (env->log.message == NULL) return;
    snprintf(text, sizeof text, "%s: %s", name, what);
    env->log.message(env->log.user, DM_LOG_WARNING, DM_OK, text);
}

static void warn_of_joints(dm_gltf_rig* rig, const dmi_rig_model* model, const format* format) {
    for (uint32_t b = 0; b < model->body_count && format->screw != NULL; b++)
        if (model->bodies[b].kind == DMI_RIG_SCREW) log_warning(&rig->env, model->bodies[b].joint_name, format->screw);
}

static dm_result print_files(dm_gltf_rig* rig, const dmi_rig_model* model, uint32_t asked) {
    rig->capacity = model->mesh_count + FORMATS + 1; /* one more with the GLB */
    rig->files = dmi_alloc(&rig->env, rig->capacity * sizeof *rig->files, ALIGNMENT);
    if (rig->files == NULL) return dmi_fail(&rig->env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_rig_make: no memory");
    for (uint32_t m = 0; (asked & BESIDE_MESHES) && m < model->mesh_count; m++)
        dmi_rig_print_obj(&model->meshes[m], &add_file(rig, DMI_RIG_MESHES, model->meshes[m].name, ".obj")->text);
    for (int i = 0; i < FORMATS; i++) {
        if (!(asked & formats[i].bit)) continue;
        formats[i].print(model, &add_file(rig, "", formats[i].path, "")->text);
        warn_of_joints(rig, model, &formats[i]);
    }
    for (uint32_t i = 0; i < rig->count; i++)
        if (rig->files[i].text.failed)
            return dmi_fail(&rig->env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_rig_make: no memory");
    return DM_OK;
}

static dm_result write_glb(dm_gltf_rig* rig, dmi_rig_model* model) {
    void* data = NULL;
    size_t size = 0;
    const dm_result result = dmi_rig_write_glb(model, &data, &size);
    if (result == DM_OK)
        add_file(rig, "", "rigged.glb", "")->text =
            (dmi_text){.env = &rig->env, .data = data, .size = size, .capacity = size};
    return result;
}

static dm_result make_files(dm_gltf_rig* rig, const dm_gltf_rig_desc* desc) {
    dmi_rig_model model;
    dm_result result = dmi_rig_model_make(&rig->env, desc, &model);
    for (uint32_t b = 0; b < model.body_count && result == DM_OK; b++)
        if (model.bodies[b].is_range_made)
            log_warning(&rig->env, model.bodies[b].joint_name,
                        "it slides without limits: the asset's size either way stands for them");
    if (result == DM_OK) result = print_files(rig, &model, desc->formats);
    if (result == DM_OK && (desc->formats & DM_GLTF_RIG_GLB) && model.body_count > 1) result = write_glb(rig, &model);
    dmi_rig_model_close(&model);
    return result;
}

dm_result dm_gltf_rig_make(const dm_gltf_rig_desc* desc, dm_gltf_rig** out_rig) {
    DMI_OWN_FP;
    dmi_env env;
    if (desc == NULL || out_rig == NULL) return DM_ERROR_INVALID_ARGUMENT;
    *out_rig = NULL;
    if (desc->struct_size != sizeof *desc) return DM_ERROR_STRUCT_SIZE;
    if ((desc->allocator.allocate == NULL) != (desc->allocator.release == NULL)) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env_init(&env, &desc->allocator, &desc->log, NULL);
    dm_result result = check_desc(&env, desc);
    if (result != DM_OK) return result;
    dm_gltf_rig* rig = dmi_alloc_zeroed(&env, sizeof *rig, ALIGNMENT);
    if (rig == NULL) return dmi_fail(&env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_rig_make: no memory");
    dmi_env_init(&rig->env, &desc->allocator, &desc->log, NULL);
    result = make_files(rig, desc);
    if (result == DM_OK)
        *out_rig = rig;
    else
        dm_gltf_rig_destroy(rig);
    return result;
}

void dm_gltf_rig_destroy(dm_gltf_rig* rig) {
    if (rig == NULL) return;
    dmi_env env;
    dmi_env_init(&env, &rig->env.allocator, NULL, NULL);
    for (uint32_t i = 0; i < rig->count; i++) dmi_text_free(&rig->files[i].text);
    dmi_free(&rig->env, rig->files, rig->capacity * sizeof *rig->files);
    dmi_free(&env, rig, sizeof *rig);
}

uint32_t dm_gltf_rig_file_count(const dm_gltf_rig* rig) {
    return rig != NULL ? rig->count : 0;
}

dm_result dm_gltf_rig_get_file(const dm_gltf_rig* rig, uint32_t index, dm_gltf_rig_file* out_file) {
    if (rig == NULL || out_file == NULL) return DM_ERROR_INVALID_ARGUMENT;
    if (index >= rig->count) return DM_ERROR_NOT_FOUND;
    *out_file = (dm_gltf_rig_file){
        .path = rig->files[index].path, .data = rig->files[index].text.data, .size = rig->files[index].text.size};
    return DM_OK;
}
