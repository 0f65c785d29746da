/* Opens a session: a context, and the weights for it, which it finds. */
#include "session_open.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "weights_folder.h"

typedef struct weights {
    char* data; /* NULL: there is no such file */
    size_t size;
} weights;

/* Returns the folder that was named, else where weights_folder_find looks; NULL when none has any. To be freed. */
static char* find_folder(const char* models) {
    char found[4096];
    if (models != NULL) return cli_copy_text(models);
    return weights_folder_find(found, sizeof found) ? cli_copy_text(found) : NULL;
}

/* Reads a file of weights where there is one; the library warns of what is missing. */
static dm_result read_weights(session* session, const char* folder, const char* name, weights* out) {
    char* path = path_join(folder, name);
    dm_result result = DM_OK;
    *out = (weights){NULL, 0};
    out->data = file_read(path, &out->size);
    if (out->data == NULL && errno != ENOENT && errno != ENOTDIR)
        result = session_fail(session, DM_ERROR_NOT_FOUND, "can't read the weights '%s': %s", path, file_problem());
    free(path);
    return result;
}

static void free_weights(weights* weights) {
    free(weights->data);
    weights->data = NULL;
    weights->size = 0;
}

/* Loads the files that are there, each alone where that fails, so that the error names the one. */
static dm_result load_model(session* session, const char* folder, const dm_model_desc* all) {
    if (all->kinematics == NULL && all->motion == NULL && all->ranker == NULL) return DM_OK;
    const dm_result result = dm_model_load(session->context, all, &session->model);
    if (result == DM_OK) return result;
    const dm_model_desc alone[] = {
        {.struct_size = sizeof *all, .kinematics = all->kinematics, .kinematics_size = all->kinematics_size},
        {.struct_size = sizeof *all, .motion = all->motion, .motion_size = all->motion_size},
        {.struct_size = sizeof *all, .ranker = all->ranker, .ranker_size = all->ranker_size}};
    const void* const data[] = {all->kinematics, all->motion, all->ranker};
    const char* const names[] = {WEIGHTS_KINEMATICS, WEIGHTS_MOTION, WEIGHTS_RANKER};
    for (size_t i = 0; i < sizeof alone / sizeof *alone; i++) {
        dm_model model = 0;
        if (data[i] == NULL) continue;
        if (dm_model_load(session->context, &alone[i], &model) == DM_OK) {
            dm_model_unload(session->context, model);
            continue;
        }
        char* path = path_join(folder, names[i]);
        session_add_place(session, "in the weights", path);
        free(path);
        break;
    }
    return result;
}

static dm_result load_folder(session* session, const char* folder) {
    weights kinematics = {NULL, 0}, motion = {NULL, 0}, ranker = {NULL, 0};
    dm_result result = read_weights(session, folder, WEIGHTS_KINEMATICS, &kinematics);
    if (result == DM_OK) result = read_weights(session, folder, WEIGHTS_MOTION, &motion);
    if (result == DM_OK && session->method != METHOD_RULES)
        result = read_weights(session, folder, WEIGHTS_RANKER, &ranker);
    if (result == DM_OK && kinematics.data == NULL && motion.data == NULL && ranker.data == NULL)
        result = session_fail(session, DM_ERROR_NOT_FOUND, "there is no %s, %s or %s in '%s'", WEIGHTS_KINEMATICS,
                              WEIGHTS_MOTION, WEIGHTS_RANKER, folder);
    if (result == DM_OK && session->method == METHOD_GEOMETRY) free_weights(&kinematics);
    const dm_model_desc desc = {.struct_size = sizeof desc,
                                .kinematics = kinematics.data,
                                .kinematics_size = kinematics.size,
                                .motion = motion.data,
                                .motion_size = motion.size,
                                .ranker = ranker.data,
                                .ranker_size = ranker.size};
    if (result == DM_OK) result = load_model(session, folder, &desc);
    session->has_motion = result == DM_OK && motion.data != NULL;
    free(kinematics.data);
    free(motion.data);
    free(ranker.data);
    return result;
}

static dm_result load_weights(session* session, const char* models) {
    if (models != NULL && strcmp(models, "none") == 0) return DM_OK;
    char* folder = find_folder(models);
    if (folder == NULL)
        return session_fail(session, DM_ERROR_NO_MODEL,
                            "no weights: there is no %s beside the program; name a folder with --models DIR or "
                            "DRAGMESH_MODELS, or use --models none",
                            WEIGHTS_KINEMATICS);
    const dm_result result = load_folder(session, folder);
    free(folder);
    return result;
}

static int open_with(session* session, const char* models, const dm_allocator* allocator, enum session_method method) {
    if (!session_init(session, allocator, method)) {
        fprintf(stderr, "dragmesh: %s\n", session->error);
        return CLI_FAILED;
    }
    if (load_weights(session, models) == DM_OK) return CLI_OK;
    fprintf(stderr, "dragmesh: %s\n", session->error);
    session_close(session);
    return CLI_USAGE;
}

int session_open(session* session, const char* models, const dm_allocator* allocator) {
    return open_with(session, models, allocator, METHOD_FULL);
}

int session_open_method(session* session, const char* models, enum session_method method) {
    return open_with(session, models, NULL, method);
}
