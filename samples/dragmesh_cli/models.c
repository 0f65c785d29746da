/* Finds and loads the weights: --models, DRAGMESH_MODELS, or a folder beside the program. */
#include "models.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/platform.h"
#include "files.h"

static const char* const kinematics_file = "kpp_net.safetensors";
static const char* const motion_file = "dq_vae.safetensors";
static const char* const ranker_file = "ranker.safetensors";

typedef struct weights {
    char* data; /* NULL: there is no such file */
    size_t size;
} weights;

/* Returns the folder of the program; to be freed. */
static char* program_folder(void) {
    char path[4096];
    return path_join(platform_program_folder(path, sizeof path) ? path : ".", "");
}

static bool holds_weights(const char* folder) {
    char* file = path_join(folder, kinematics_file);
    const bool found = platform_exists(file);
    free(file);
    return found;
}

/* Returns the folder of the weights, in the order of the usage text; NULL when none has any. To be freed. */
static char* find_folder(const char* models) {
    if (models != NULL) return path_join(models, "");
    const char* named = getenv("DRAGMESH_MODELS");
    if (named != NULL && *named) return path_join(named, "");
    static const char* const places[] = {"models", "../models", "../../sdk/models"};
    char* program = program_folder();
    char* found = NULL;
    for (size_t i = 0; i < sizeof places / sizeof *places && found == NULL; i++) {
        char* folder = path_join(program, places[i]);
        if (holds_weights(folder))
            found = folder;
        else
            free(folder);
    }
    free(program);
    return found;
}

static dm_result read_weights(session* session, const char* folder, const char* name, int required, weights* out) {
    char* path = path_join(folder, name);
    dm_result result = DM_OK;
    *out = (weights){NULL, 0};
    if (required || platform_exists(path)) {
        out->data = file_read(path, &out->size);
        if (out->data == NULL)
            result = session_fail(session, DM_ERROR_NOT_FOUND, "can't read the weights '%s': %s", path, file_problem());
    }
    free(path);
    return result;
}

static void free_weights(weights* weights) {
    free(weights->data);
    weights->data = NULL;
    weights->size = 0;
}

static dm_result load_folder(session* session, const char* folder) {
    weights kinematics = {NULL, 0}, motion = {NULL, 0}, ranker = {NULL, 0};
    dm_result result = read_weights(session, folder, kinematics_file, 1, &kinematics);
    if (result == DM_OK) result = read_weights(session, folder, motion_file, 0, &motion);
    if (result == DM_OK && session->method != METHOD_RULES)
        result = read_weights(session, folder, ranker_file, 0, &ranker);
    if (result == DM_OK && session->method == METHOD_GEOMETRY) free_weights(&kinematics);
    if (result == DM_OK && (kinematics.data != NULL || motion.data != NULL || ranker.data != NULL)) {
        const dm_model_desc desc = {.struct_size = sizeof desc,
                                    .kinematics = kinematics.data,
                                    .kinematics_size = kinematics.size,
                                    .motion = motion.data,
                                    .motion_size = motion.size,
                                    .ranker = ranker.data,
                                    .ranker_size = ranker.size};
        result = dm_model_load(session->context, &desc, &session->model);
        if (result != DM_OK) {
            char reason[sizeof session->error];
            memcpy(reason, session->error, sizeof reason);
            snprintf(session->error, sizeof session->error, "%.800s (weights in %.200s)", reason, folder);
        }
    }
    session->has_motion = result == DM_OK && motion.data != NULL;
    free(kinematics.data);
    free(motion.data);
    free(ranker.data);
    return result;
}

dm_result models_load(session* session, const char* models) {
    if (models != NULL && strcmp(models, "none") == 0) return DM_OK;
    char* folder = find_folder(models);
    if (folder == NULL)
        return session_fail(session, DM_ERROR_NO_MODEL,
                            "no weights: there is no %s beside the program; name a folder with --models DIR or "
                            "DRAGMESH_MODELS, or use --models none",
                            kinematics_file);
    const dm_result result = load_folder(session, folder);
    free(folder);
    return result;
}
