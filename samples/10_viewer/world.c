/* An object of a file, its parts and their joints: opening, preparing, saving. Moving it: world_move.c. */
#include "world.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../common/output_file.h"
#include "../common/weights_folder.h"
#include "files.h"
#include "parts.h"

static void DM_CALL keep_message(void* user, int32_t level, dm_result code, const char* text) {
    (void)code;
    if (level == DM_LOG_INFO) return;
    world* w = user;
    snprintf(w->message, sizeof w->message, "%s", text);
}

static int fail(world* world, const char* format, ...) {
    va_list list;
    va_start(list, format);
    vsnprintf(world->message, sizeof world->message, format, list);
    va_end(list);
    return -1;
}

static double seconds_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int adopt(world* world);

/* ---- opening ---- */

static char* read_weights(const char* folder, const char* name, size_t* out_size) {
    char* path = path_join(folder, name);
    *out_size = 0;
    char* data = file_read(path, out_size);
    free(path);
    return data;
}

/* Without its weights the viewer still works, by geometry alone; each file may be absent. */
static int load_model(world* world, const char* folder) {
    char found[4096];
    if (folder == NULL) folder = weights_folder_find(found, sizeof found) ? found : ".";
    if (strcmp(folder, "none") == 0) return 0;
    dm_model_desc desc = {.struct_size = sizeof desc};
    char* kinematics = read_weights(folder, WEIGHTS_KINEMATICS, &desc.kinematics_size);
    char* motion = read_weights(folder, WEIGHTS_MOTION, &desc.motion_size);
    char* ranker = read_weights(folder, WEIGHTS_RANKER, &desc.ranker_size);
    desc.kinematics = kinematics, desc.motion = motion, desc.ranker = ranker;
    dm_result result = DM_OK;
    if (kinematics != NULL || motion != NULL || ranker != NULL)
        result = dm_model_load(world->context, &desc, &world->model);
    else
        fail(world, "no weights in '%s': joints come from geometry alone", folder);
    world->has_motion = result == DM_OK && motion != NULL;
    free(kinematics);
    free(motion);
    free(ranker);
    return result == DM_OK ? 0 : -1;
}

static float mesh_diagonal(const dm_mesh_desc* mesh) {
    dm_vec3 low = vec(INFINITY, INFINITY, INFINITY), high = scale(low, -1);
    for (uint64_t v = 0; v < mesh->vertex_count; v++) {
        const dm_vec3 p = vec_from((const float*)mesh->positions + 3 * v);
        low = vec_min(low, p), high = vec_max(high, p);
    }
    return length(sub(high, low));
}

/* Opens the file, or the scene's shapes as if they were one. */
static dm_result open_gltf(world* world, const char* path) {
    dm_gltf_desc desc = {.struct_size = sizeof desc, .log = {world, keep_message}};
    if (world->table == NULL) return dm_gltf_open_file(path, &desc, &world->gltf);
    void* bytes = scene_glb(world->table, &desc.size);
    desc.data = bytes;
    const dm_result result = dm_gltf_open(&desc, &world->gltf);
    free(bytes);
    return result;
}

static int open_file(world* world, const char* path) {
    dm_result result = open_gltf(world, path);
    if (result == DM_OK) result = dm_gltf_get_mesh(world->gltf, &world->mesh);
    if (result != DM_OK) return -1;
    world->face_count = (uint32_t)(world->mesh.index_count / 3);
    world->face_part = take(world->face_count, 1);
    world->size = mesh_diagonal(&world->mesh);
    return 0;
}

/* Whether the parts have as many faces as those of a prepared object. */
static bool parts_fit(world* world, dm_object object) {
    dm_object_info info = {.struct_size = sizeof info};
    bool fits = dm_object_get_info(world->context, object, &info) == DM_OK && info.part_count == world->part_count;
    for (uint32_t i = 0; i < info.part_count && fits; i++) {
        dm_part_info part = {.struct_size = sizeof part};
        uint32_t faces = 0;
        fits = dm_object_get_part(world->context, object, i, &part) == DM_OK;
        for (uint32_t f = 0; f < world->face_count; f++) faces += world->face_part[f] == part.id;
        fits = fits && faces == part.triangle_count;
    }
    return fits;
}

/* The parts of a prepared object, which does not say whose nodes are whose: those of the asset, else every node but the
 * largest. */
static int find_parts_of_dmo(world* world, const world_options* options) {
    dm_object object = 0;
    size_t size = 0;
    char* data = file_read(options->dmo, &size);
    if (data == NULL) return fail(world, "can't read '%s': %s", options->dmo, strerror(errno));
    const dm_result result = dm_object_load(world->context, data, size, 0, &object);
    free(data);
    if (result != DM_OK) return -1;
    if (parts_from_asset(world, options->file, 0) != 0 || !parts_fit(world, object)) {
        parts_clear(world);
        parts_from_nodes(world);
    }
    dm_object_destroy(world->context, object);
    return 0;
}

/* What may move: as told, else as saved beside the file, else as the library says. */
static int find_parts(world* world, const world_options* options) {
    if (world->table != NULL) {
        world_scene_parts(world);
        return 0;
    }
    if (options->part_count) return parts_from_names(world, options->parts, options->part_count);
    char* beside = path_with_ending(options->dmo != NULL ? options->dmo : options->file, ".parts.npy");
    const bool known = parts_load(world, beside) == 0;
    free(beside);
    if (known) return 0;
    if (options->dmo != NULL) return find_parts_of_dmo(world, options);
    const double start = seconds_now();
    const int status = parts_from_asset(world, options->file, 1);
    world->prepare_seconds = seconds_now() - start;
    return status;
}

int world_open(world* world, const world_options* options) {
    memset(world, 0, sizeof *world);
    const dm_context_desc host = {.struct_size = sizeof host, .log = {world, keep_message}};
    int status = dm_context_create(&host, &world->context) == DM_OK ? 0 : fail(world, "no context");
    if (status == 0 && options->scene != NULL) {
        world->table = scene_find(options->scene);
        if (world->table == NULL) status = fail(world, "no scene has the name '%s'", options->scene);
    }
    if (status == 0) status = load_model(world, options->models);
    if (status == 0) status = open_file(world, options->file);
    if (status == 0) status = find_parts(world, options);
    if (status == 0 && options->dmo != NULL)
        status = world_load(world, options->dmo);
    else if (status == 0 && world->object)
        status = adopt(world);
    /* A failure to prepare is no end: the player can still say what moves. */
    if (status == 0 && !world->object) world_prepare(world);
    if (status != 0) world_close(world);
    return status;
}

void world_close(world* world) {
    char message[sizeof world->message];
    memcpy(message, world->message, sizeof message);
    dm_context_destroy(world->context);
    if (world->gltf != NULL) dm_gltf_close(world->gltf);
    free(world->face_part);
    memset(world, 0, sizeof *world);
    memcpy(world->message, message, sizeof message);
}

/* ---- preparing ---- */

static void read_part(world* world, uint32_t index) {
    dm_part_info info = {.struct_size = sizeof info};
    if (dm_object_get_part(world->context, world->object, index, &info) != DM_OK) return;
    if (info.id == 0 || info.id > world->part_count) return;
    world_part* part = &world->parts[info.id];
    part->id = info.id;
    part->parent = info.parent;
    part->centre = info.centre;
    part->box_min = info.box_min;
    part->box_max = info.box_max;
    part->has_keys = 0;
    world_read_joint(world, info.id);
}

static int adopt(world* world) {
    world->info = (dm_object_info){.struct_size = sizeof world->info};
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_result result = dm_object_get_info(world->context, world->object, &world->info);
    if (result == DM_OK) result = dm_scene_create(world->context, &desc, &world->scene);
    if (result == DM_OK) result = dm_scene_add(world->context, world->scene, world->object, NULL, &world->instance);
    if (result != DM_OK) return -1;
    for (uint32_t i = 0; i < world->info.part_count; i++) read_part(world, i);
    world->revision++;
    world_update(world);
    return 0;
}

static void let_go_of_object(world* world) {
    world->held = 0;
    world->history_count = 0;
    for (uint32_t id = 1; id <= world->part_count; id++) world->parts[id].drag = 0; /* they end with their object */
    if (world->scene) dm_scene_destroy(world->context, world->scene);
    if (world->object) dm_object_destroy(world->context, world->object);
    world->scene = 0;
    world->object = 0;
}

int world_prepare(world* world) {
    let_go_of_object(world);
    world->message[0] = 0;
    dm_part_desc descs[WORLD_MAX_PARTS];
    for (uint32_t i = 0; i < world->part_count; i++)
        descs[i] = (dm_part_desc){.struct_size = sizeof descs[i], .id = i + 1, .parent = world->parts[i + 1].parent};
    dm_mesh_desc mesh = world->mesh;
    mesh.part_ids = world->face_part;
    mesh.part_id_bytes = world->face_count;
    mesh.part_id_format = DM_UINT8;
    mesh.part_id_scope = DM_PER_FACE;
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .mesh = &mesh,
                                 .parts = descs,
                                 .part_count = world->part_count,
                                 .model = world->model,
                                 .seed = 1};
    if (world->part_count == 0)
        return fail(world, "nothing here seems to move: point at a piece and press M, or paint (P)");
    const double start = seconds_now();
    if (dm_object_prepare(world->context, &desc, &world->object) != DM_OK) return -1;
    world->prepare_seconds = seconds_now() - start;
    if (world_scene_equip(world) != 0) return -1;
    return adopt(world);
}

/* ---- prepared objects ---- */

int world_load(world* world, const char* path) {
    size_t size = 0;
    char* data = file_read(path, &size);
    if (data == NULL) return fail(world, "can't read '%s': %s", path, strerror(errno));
    const dm_result result = dm_object_load(world->context, data, size, world->model, &world->object);
    free(data);
    return result == DM_OK ? adopt(world) : -1;
}

/* Writes the object and the parts that its faces belong to, both or none. */
static int write_object(world* world, const char* path, const char* beside) {
    size_t size = 0, part_size;
    dm_object_save(world->context, world->object, NULL, 0, &size);
    uint8_t *data = take(size, 1), *parts = parts_encode(world, &part_size);
    int status = dm_object_save(world->context, world->object, data, size, &size) == DM_OK ? 0 : -1, failed;
    const output_bytes files[2] = {{path, data, size}, {beside, parts, part_size}};
    if (status == 0 && output_write_all(files, 2, &failed) != 0)
        status = fail(world, "can't write '%s': %s", files[failed].path, strerror(errno));
    free(parts);
    free(data);
    return status;
}

int world_save(world* world, const char* path) {
    if (!world->object) return fail(world, "nothing is prepared, so nothing can be saved");
    char* beside = path_with_ending(path, ".parts.npy");
    const int status = write_object(world, path, beside);
    if (status == 0) fail(world, "saved %s", path); /* a message, no failure */
    free(beside);
    return status;
}
