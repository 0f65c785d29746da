#include "weights_folder.h"

#include <stdio.h>
#include <stdlib.h>

#include "platform.h"

enum { PATH_CAPACITY = 4096 };

/* Writes folder/name; false when it does not fit. */
static bool join(char* out_path, size_t size, const char* folder, const char* name) {
    const int length = snprintf(out_path, size, "%s/%s", folder, name);
    return length >= 0 && (size_t)length < size;
}

/* Whether a folder has one of the files; the library warns of those that are missing. */
static bool holds_weights(const char* folder) {
    static const char* const names[] = {WEIGHTS_KINEMATICS, WEIGHTS_MOTION, WEIGHTS_RANKER};
    char file[PATH_CAPACITY];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (join(file, sizeof file, folder, names[i]) && platform_exists(file)) return true;
    return false;
}

bool weights_folder_find(char* out_path, size_t size) {
    const char* named = getenv("DRAGMESH_MODELS");
    if (named != NULL && *named) {
        const int length = snprintf(out_path, size, "%s", named);
        return length >= 0 && (size_t)length < size;
    }
    static const char* const places[] = {".", "models", "../models", "../../sdk/models"};
    char program[PATH_CAPACITY];
    if (!platform_program_folder(program, sizeof program)) snprintf(program, sizeof program, ".");
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        if (join(out_path, size, program, places[i]) && holds_weights(out_path)) return true;
    return false;
}
