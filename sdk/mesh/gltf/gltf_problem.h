/* What is wrong with a file, or with a piece of it: kept as text, because a bad piece is left out with a warning and
 * only becomes an error when nothing else is there. */
#ifndef DMI_MESH_GLTF_PROBLEM_H
#define DMI_MESH_GLTF_PROBLEM_H

#include "base/env.h"

typedef struct dmi_gltf_problem {
    dm_result code; /* DM_OK: none */
    int fatal;      /* of the machine or of the whole file, not of a piece */
    char text[448]; /* fits a log message, with words before it */
} dmi_gltf_problem;

/* Stores the problem, fatal where memory is short or the host asked to stop, and returns `code`. */
dm_result dmi_gltf_refuse(dmi_gltf_problem* problem, dm_result code, const char* format, ...) DMI_PRINTF(3, 4);
/* Logs a warning, for what is left out of a file. */
void dmi_gltf_warn(dmi_env* env, const char* format, ...) DMI_PRINTF(2, 3);

#endif
