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

bool weights_folder_find(char* out_path, size_t size) {
    const char* named = getenv("DRAGMESH_MODELS");
    if (named != NULL && *named) return join(out_path, size, named, "");
    static const char* const places[] = {".", "models", "../models", "../../sdk/models"};
    char program[PATH_CAPACITY], file[PATH_CAPACITY];
    if (!platform_program_folder(program, sizeof program)) snprintf(program, sizeof program, ".");
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        if (join(out_path, size, program, places[i]) && join(file, sizeof file, out_path, WEIGHTS_KINEMATICS) &&
            platform_exists(file))
            return true;
    return false;
}
