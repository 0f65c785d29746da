/* A problem of a file, or of a piece of it. It is kept as text, because a bad piece is left out with a warning and only
 * becomes an error when nothing else is there. */
#ifndef DMI_GLTF_PROBLEM_H
#define DMI_GLTF_PROBLEM_H

#include "base/env.h"

typedef struct dmi_gltf_problem {
    dm_result code; /* DM_OK: none */
    int fatal;      /* it is a problem of the machine or of the whole file, not of a piece */
    char text[448]; /* fits a log message, with words before it */
} dmi_gltf_problem;

/* Stores the problem, which is fatal where memory is short or the host asked to stop. Returns `code`. */
dm_result dmi_gltf_refuse(dmi_gltf_problem* problem, dm_result code, const char* format, ...) DMI_PRINTF(3, 4);

#define DMI_GLTF_NAMED_WARNINGS 3 /* warnings of one call that its message quotes; by hand */

/* What one call warns of. */
typedef struct dmi_gltf_warnings {
    uint32_t count;
    char texts[DMI_GLTF_NAMED_WARNINGS][512]; /* texts of the first ones, each as long as a log message */
} dmi_gltf_warnings;

/* Adds a warning that something of a file is left out, or is not read as it stands. */
void dmi_gltf_warn(dmi_gltf_warnings* warnings, const char* format, ...) DMI_PRINTF(2, 3);
/* Logs one message, which counts the warnings of the call and quotes the first ones, and forgets them. Each function of
 * dm_gltf that may warn ends with it. */
void dmi_gltf_log_warnings(dmi_env* env, dmi_gltf_warnings* warnings);

#endif
