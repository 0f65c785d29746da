/* Finds and loads the weights: --models, DRAGMESH_MODELS, or a folder beside the program. */
#include "models.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/platform.h"
#include "../common/weights_folder.h"
#include "files.h"

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
    dm_result result = read_weights(session, folder, WEIGHTS_KINEMATICS, 1, &kinematics);
    if (result == DM_OK) result = read_weights(session, folder, WEIGHTS_MOTION, 0, &motion);
    if (result == DM_OK && session->method != METHOD_RULES)
        result = read_weights(session, folder, WEIGHTS_RANKER, 0, &ranker);
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
            session_add_place(session, "weights in", folder);
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
                            WEIGHTS_KINEMATICS);
    const dm_result result = load_folder(session, folder);
    free(folder);
    return result;
}
